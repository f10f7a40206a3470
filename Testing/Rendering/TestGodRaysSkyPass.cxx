// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky against published radiances and integrals in double precision: from the ground to space, by day
// and at dusk.

#include "GodRaysSkyTesting.h"

#include "vtkGodRaysAtmosphere.h"

#include <algorithm>
#include <iostream>

using namespace GodRaysTesting;
using vtkGodRays::ToVec3;
using Atmosphere = vtkGodRaysAtmosphere;

//------------------------------------------------------------------------------
// Single scattering, converged, without ground, from 0.5 m; zenith angles of sun and view, azimuth from the
// sun. [W/(m^2 sr nm)]
TEST_F(GodRaysSkyPass, IsThePublishedSky)
{
  struct Golden
  {
    double SunZenith, ViewZenith, Azimuth;
    Vec3 Radiance;
  };
  const Golden goldens[] = { { 0, 0, 0, { 3.471197e-2, 5.208999e-2, 7.448241e-2 } },
    { 0, 89, 0, { 5.063710e-2, 8.133292e-2, 8.226054e-2 } },
    { 30, 0, 0, { 8.145345e-3, 1.962685e-2, 4.096663e-2 } },
    { 30, 45, 0, { 2.035693e-2, 3.879425e-2, 6.836233e-2 } },
    { 60, 0, 0, { 4.809867e-3, 1.216489e-2, 2.541176e-2 } },
    { 60, 45, 0, { 1.964327e-2, 3.586598e-2, 6.041084e-2 } },
    { 60, 45, 180, { 5.584284e-3, 1.414081e-2, 2.876382e-2 } },
    { 60, 89, 180, { 8.218950e-2, 1.235982e-1, 1.104194e-1 } },
    { 85, 0, 0, { 2.955332e-3, 5.417282e-3, 8.643337e-3 } },
    { 85, 45, 180, { 5.726272e-3, 1.033239e-2, 1.570532e-2 } } };
  this->Sky->GetAtmosphere()->SetGroundAlbedo(0.0, 0.0, 0.0);
  double worst[2] = { 0.0, 0.0 };
  for (const Golden& golden : goldens)
  {
    this->SetSun(90.0 - golden.SunZenith);
    this->SetView(0.5, 180.0 + golden.Azimuth, 90.0 - golden.ViewZenith, 0.01);
    const Vec3 seen = this->Render()[Size * Size / 2 + Size / 2];
    double& error = worst[golden.ViewZenith > 80.0 ? 1 : 0];
    error = std::max(error, GetBrightest(abs(seen / golden.Radiance - 1.0)));
  }
  std::cout << "published radiances: " << worst[0] << ", near the horizon " << worst[1] << "\n";
  EXPECT_LT(worst[0], 0.01);
  EXPECT_LT(worst[1], 0.03);
}

TEST_F(GodRaysSkyPass, IsTheIntegralByDay)
{
  for (const double height : { 0.0, 2.0, 1e3, 10e3, 50e3, 100e3 })
  {
    double worst = 0.0;
    for (const double sun : { 90.0, 60.0, 30.0, 5.0, 1.0 })
    {
      worst = std::max(worst, this->GetErrorOfSky(height, sun, 0.01));
    }
    std::cout << height << " m: " << worst << "\n";
    EXPECT_LT(worst, 0.01) << height;
  }
}

// The edge between day and night is in sight. Where it meets the planet's edge, a few pixels, of which
// samples may have none, are further off.
TEST_F(GodRaysSkyPass, IsTheIntegralFromSpace)
{
  this->Every = 1;
  for (const double height : { 1e6, 2.0 * EarthRadius })
  {
    for (const double sun : { 90.0, 30.0, 5.0, 1.0, -10.0, -30.0 })
    {
      const double error = this->GetErrorOfSky(height, sun, 1.0);
      std::cout << height << " m, sun " << sun << ": " << error << "\n";
      EXPECT_LT(error, 0.02) << height << " " << sun;
    }
  }
}

TEST_F(GodRaysSkyPass, IsTheIntegralAtDusk)
{
  this->SetMultipleScattering(true);
  for (const double height : { 2.0, 10e3 })
  {
    for (const double sun : { 0.0, -1.0, -4.0, -8.0 })
    {
      const double error = this->GetErrorOfSky(height, sun, 0.1);
      std::cout << height << " m, sun " << sun << ": " << error << "\n";
      EXPECT_LT(error, 0.01) << height << " " << sun;
    }
  }
}

TEST_F(GodRaysSkyPass, IsTheIntegralInOtherAir)
{
  this->SetMultipleScattering(true);
  for (const int preset :
    { Atmosphere::EARTH_HAZY, Atmosphere::EARTH_POLLUTED, Atmosphere::LODATO_2015 })
  {
    this->Sky->GetAtmosphere()->LoadPreset(preset);
    double worst = 0.0;
    for (const double sun : { 40.0, 3.0 })
    {
      worst = std::max(worst, this->GetErrorOfSky(2.0, sun, 0.01));
    }
    std::cout << "preset " << preset << ": " << worst << "\n";
    EXPECT_LT(worst, 0.01) << preset;
  }
}

// Light comes from ever nearer.
TEST_F(GodRaysSkyPass, IsTheIntegralInThickHaze)
{
  for (const double factor : { 3.0, 10.0 })
  {
    Atmosphere* air = this->Sky->GetAtmosphere();
    air->LoadPreset(Atmosphere::EARTH_POLLUTED);
    const Vec3 scattering = factor * ToVec3(air->GetMieScattering());
    air->SetMieScattering(scattering.x, scattering.y, scattering.z);
    for (const double sun : { 40.0, 3.0 })
    {
      const double error = this->GetErrorOfSky(2.0, sun, 0.01);
      std::cout << factor << " times polluted, sun " << sun << ": " << error << "\n";
      EXPECT_LT(error, sun > 10.0 ? 0.01 : 0.03) << factor << " " << sun;
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, IsFiniteAtAllHeightsAndHours)
{
  this->SetMultipleScattering(true);
  this->Sky->SunDiscOn();
  for (const double height :
    { -1e7, -EarthRadius, -100.0, -1e-9, 0.0, 1e-3, 60e3, 100e3, 2.0 * EarthRadius, 1e12 })
  {
    for (const double sun : { 90.0, 1e-9, 0.0, -1e-9, -6.0, -90.0 })
    {
      this->SetSun(sun);
      for (const double elevation : { 90.0, 0.0, -90.0 })
      {
        this->SetView(
          height, 180.0, elevation, 100.0); // one ray is exactly level, up or down nearly
        for (const Vec3& light : this->Render())
        {
          ASSERT_GE(std::min({ light.x, light.y, light.z }), 0.0) << height << " " << sun;
        }
      }
    }
  }
}

// Heights across the atmosphere's top and hours across sunset, in small steps.
TEST_F(GodRaysSkyPass, IsContinuous)
{
  const auto getStep = [this](const std::vector<Vec3>& former)
  {
    double step = 0.0;
    double brightest = 0.0;
    for (std::size_t i = 0; i < former.size(); ++i)
    {
      step = std::max(step, GetBrightest(abs(this->Seen[i] - former[i])));
      brightest = std::max(brightest, GetBrightest(former[i]));
    }
    return step / brightest;
  };
  this->SetMultipleScattering(true);
  double worst = 0.0;
  for (double sun = 0.1; sun > -0.1; sun -= 0.02)
  {
    this->SetSun(sun);
    const auto former = this->Seen;
    this->Render();
    worst = former.empty() ? 0.0 : std::max(worst, getStep(former));
  }
  std::cout << "0.02 degrees at sunset: " << worst << "\n";
  EXPECT_LT(worst, 0.02);

  this->Seen.clear();
  this->SetSun(20.0);
  worst = 0.0;
  for (double height = 59.9e3; height < 60.1e3; height += 20.0)
  {
    this->SetView(height, 180.0, -30.0, 40.0); // without the horizon, which moves through pixels
    const auto former = this->Seen;
    this->Render();
    worst = former.empty() ? 0.0 : std::max(worst, getStep(former));
  }
  std::cout << "20 m at the top: " << worst << "\n";
  EXPECT_LT(worst, 0.02);
}

// Camera and ground far from the world's origin, in a unit of a kilometre.
TEST_F(GodRaysSkyPass, IsTheSameAnywhereInTheWorld)
{
  this->SetView(500.0, 150.0, 5.0, 50.0);
  const auto here = this->Render();
  const Vec3 origin(6.4e6, -7e6, 3e6);
  this->Sky->SetOrigin(&origin[0]);
  this->Sky->SetWorldUnitInMeters(1000.0);
  this->PlaceCamera(origin, 1000.0);
  const auto there = this->Render();
  double worst = 0.0;
  for (std::size_t i = 0; i < here.size(); ++i)
  {
    worst = std::max(worst, GetBrightest(abs(here[i] - there[i])) / GetBrightest(here[i]));
  }
  EXPECT_LT(worst, 1e-3);
  this->Sky->SetOrigin(0.0, 0.0, 0.0); // a camera 1e10 m up
  EXPECT_GT(GetBrightest(abs(this->Render()[Size * Size / 2] - here[Size * Size / 2])), 1e-3);
}
