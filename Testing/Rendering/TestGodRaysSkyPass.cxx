// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky behind a scene and the air before it, against published radiances and integrals in double
// precision: from the ground to space, by day and at dusk; where they are drawn, what they are made of, and
// the sun's light.

#include "GodRaysTesting.h"

#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSkySource.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkFramebufferPass.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPixelBufferObject.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

using namespace GodRaysTesting;
using vtkGodRays::ToVec3;
using vtkGodRays::Vec3;
using Atmosphere = vtkGodRaysAtmosphere;

namespace
{
const double EarthRadius = 6360e3;

double GetBrightest(const Vec3& color)
{
  return std::max({ color.x, color.y, color.z });
}

/// A unit vector to an azimuth from north by east and an elevation [degrees], of a map.
Vec3 GetDirection(double azimuth, double elevation)
{
  const double turn = vtkMath::RadiansFromDegrees(azimuth);
  const double rise = vtkMath::RadiansFromDegrees(elevation);
  return Vec3(std::cos(rise) * std::sin(turn), std::cos(rise) * std::cos(turn), std::sin(rise));
}

/// The elevation at which the ground's horizon is seen [degrees].
double GetHorizon(double height)
{
  return -vtkMath::DegreesFromRadians(std::acos(EarthRadius / (EarthRadius + height)));
}

/// A sky in a framebuffer of floats, and the integral that it should be. The sun is in the south.
class GodRaysSkyPass : public ::testing::Test
{
protected:
  static constexpr int Size = 48;

  Messages Said;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkFramebufferPass> Floats;
  vtkNew<vtkGodRaysSkyPass> Sky;
  vtkNew<vtkGodRaysSkySource> Truth;
  std::vector<Vec3> Seen; // linear light of the last frame, lower left first
  int Every = 13;         // pixel is compared, which is from all rows and columns

  GodRaysSkyPass()
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetSize(Size, Size);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    this->Floats->SetColorFormat(vtkTextureObject::Float32);
    this->Floats->SetDelegatePass(this->Sky);
    this->Renderer->SetPass(this->Floats);
    this->Sky->SetExposure(1.0);
    this->Sky->WhiteBalanceOff(); // radiances as they are
    this->Sky->SunDiscOff();
    this->Sky->MultipleScatteringOff();
    this->Truth->SetAtmosphere(this->Sky->GetAtmosphere());
    this->SetSun(30.0);
    this->SetView(2.0, 180.0, 20.0, 60.0);
  }

  void SetSun(double elevation)
  {
    this->Sky->SetSunElevation(elevation);
    this->Truth->SetSunElevation(elevation);
  }

  void SetMultipleScattering(bool multiple)
  {
    this->Sky->SetMultipleScattering(multiple);
    this->Truth->SetMultipleScattering(multiple);
  }

  /// Look from a height [m] to an azimuth and elevation, over an angle [degrees].
  void SetView(double height, double azimuth, double elevation, double angle)
  {
    this->Eye = Vec3(0.0, 0.0, height);
    this->Look = GetDirection(azimuth, elevation);
    this->ViewUp = GetDirection(azimuth, elevation + 90.0);
    this->Tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
    this->Truth->SetObserverHeight(std::max(height, 0.0));
    this->PlaceCamera(Vec3(0.0), 1.0);
  }

  /// The same view in a world that is moved, and whose unit is so many metres.
  void PlaceCamera(const Vec3& origin, double unit)
  {
    const Vec3 eye = origin + this->Eye / unit;
    const Vec3 focus = eye + 1e3 / unit * this->Look;
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(this->ViewUp.x, this->ViewUp.y, this->ViewUp.z);
    camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(this->Tangent)));
    camera->SetClippingRange(0.1 / unit, 1e4 / unit);
  }

  /// The direction that a pixel looks in.
  Vec3 GetRay(int x, int y) const
  {
    const Vec3 right = cross(this->Look, this->ViewUp);
    return normalize(this->Look +
      this->Tangent *
        ((2.0 * (x + 0.5) / Size - 1.0) * right + (2.0 * (y + 0.5) / Size - 1.0) * this->ViewUp));
  }

  Vec3 GetTruth(const Vec3& ray)
  {
    Vec3 truth;
    EXPECT_TRUE(this->Truth->GetRadiance(&ray[0], &truth[0]));
    return truth;
  }

  const std::vector<Vec3>& Render()
  {
    this->Window->Render();
    std::vector<float> pixels(4 * Size * Size);
    auto buffer =
      vtk::TakeSmartPointer<vtkPixelBufferObject>(this->Floats->GetColorTexture()->Download());
    unsigned int size[2] = { Size, Size };
    vtkIdType increments[2] = { 0, 0 };
    EXPECT_TRUE(buffer->Download2D(VTK_FLOAT, pixels.data(), size, 4, increments));
    this->Seen.clear();
    for (std::size_t i = 0; i < pixels.size(); i += 4)
    {
      const Vec3 shown(pixels[i], pixels[i + 1], pixels[i + 2]);
      EXPECT_TRUE(std::isfinite(shown.x + shown.y + shown.z));
      this->Seen.push_back(vtkGodRays::DecodeDisplay(shown));
    }
    return this->Seen;
  }

  /// Light of a frame, and what it should be, in directions of some elevations.
  struct Pair
  {
    Vec3 Seen;
    Vec3 Truth;
  };
  void AddPairs(std::vector<Pair>& pairs, double lowest, double highest)
  {
    this->Render();
    for (int i = 0; i < Size * Size; i += this->Every)
    {
      const Vec3 ray = this->GetRay(i % Size, i / Size);
      const double elevation = vtkMath::DegreesFromRadians(std::asin(ray.z));
      if (elevation > lowest && elevation < highest)
      {
        pairs.push_back({ this->Seen[i], this->GetTruth(ray) });
      }
    }
  }

  /// The largest error, as a fraction of the brightest colour that there should be, and of at least a part
  /// of the brightest of all.
  static double GetError(const std::vector<Pair>& pairs, double least)
  {
    double floor = 1e-30;
    for (const Pair& pair : pairs)
    {
      floor = std::max(floor, least * GetBrightest(pair.Truth));
    }
    double worst = 0.0;
    for (const Pair& pair : pairs)
    {
      worst = std::max(worst,
        GetBrightest(abs(pair.Seen - pair.Truth)) / std::max(floor, GetBrightest(pair.Truth)));
    }
    return worst;
  }

  /// The same of views to and away from the sun and across: of the horizon, or the planet's edge, and of
  /// what is above.
  double GetErrorOfSky(double height, double sun, double least)
  {
    this->SetSun(sun);
    const double horizon = GetHorizon(height);
    std::vector<Pair> pairs;
    for (const double azimuth : { 180.0, 85.0, 0.0 })
    {
      // a pixel's middle is not as exact as the horizon
      this->SetView(height, azimuth, horizon, height > 1e6 ? 2.0 : 20.0);
      this->AddPairs(pairs, horizon + 1e-3, 90.0);
      this->AddPairs(pairs, -90.0, horizon - 1e-3);
      this->SetView(height, azimuth, 50.0, 89.0);
      this->AddPairs(pairs, 0.0, 90.0);
    }
    return GetError(pairs, least);
  }

  Vec3 Eye;
  Vec3 Look;
  Vec3 ViewUp;
  double Tangent = 1.0;
};
}

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
  for (const int preset : { Atmosphere::EARTH_HAZY, Atmosphere::EARTH_POLLUTED,
         Atmosphere::NISHITA_1993, Atmosphere::LODATO_2015 })
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

//------------------------------------------------------------------------------
namespace
{
/// Single scattering along the first part of a ray, in the middle of many steps, and what it leaves of the
/// light behind.
void IntegrateAir(Atmosphere* atmosphere, double height, const Vec3& ray, const Vec3& sun,
  double reach, Vec3& light, Vec3& left)
{
  const vtkGodRays::SkyAtmosphere sky = vtkGodRays::MakeSkyAtmosphere(atmosphere);
  const double cosAngle = dot(ray, sun);
  const auto shadow = vtkGodRays::SkyShadow(sky.GroundRadius, height, ray.z, sun.z, cosAngle);
  const int steps = 500;
  light = Vec3(0.0);
  for (int i = 0; i < steps; ++i)
  {
    const double distance = (i + 0.5) / steps * reach;
    if (!(distance > shadow.x && distance < shadow.y))
    {
      light +=
        reach / steps * vtkGodRays::SkyInscatter(sky, height, ray.z, sun.z, cosAngle, distance);
    }
  }
  light *= ToVec3(atmosphere->GetSunIrradiance());
  left = exp(-vtkGodRays::SkyDepth(sky, height, ray.z, reach));
}

/// A plane across the view, of a colour that no light changes.
vtkSmartPointer<vtkActor> MakeWall(const Vec3& center, const Vec3& look, double size, double grey)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(size, 0.0, 0.0);
  plane->SetPoint2(0.0, size, 0.0);
  plane->SetCenter(center.x, center.y, center.z);
  plane->SetNormal(-look.x, -look.y, -look.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto wall = vtkSmartPointer<vtkActor>::New();
  wall->SetMapper(mapper);
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(grey, grey, grey);
  return wall;
}
}

TEST_F(GodRaysSkyPass, TheAirBeforeASceneIsTheIntegral)
{
  const double grey = 0.2;
  const double behind = vtkGodRays::DecodeDisplay(grey);
  for (const int preset : { Atmosphere::EARTH_CLEAR, Atmosphere::EARTH_HAZY })
  {
    this->Sky->GetAtmosphere()->LoadPreset(preset);
    double thinnest = 1.0;
    for (const double height : { 2.0, 1500.0, 12e3 })
    {
      double worst = 0.0;
      for (const double sun : { 40.0, 4.0, -2.0 }) // first, as each needs its tables
      {
        this->SetSun(sun);
        for (const double distance : { 300.0, 3e3, 30e3, 150e3 })
        {
          for (const double azimuth : { 180.0, 60.0 })
          {
            this->SetView(height, azimuth, 1.0, 30.0);
            const auto wall =
              MakeWall(this->Eye + distance * this->Look, this->Look, 2.0 * distance, grey);
            this->Renderer->RemoveAllViewProps();
            this->Renderer->AddActor(wall);
            this->Renderer->GetActiveCamera()->SetClippingRange(0.5 * distance, 2.0 * distance);
            this->Render();
            const Vec3 towards = GetDirection(180.0, sun);
            double brightest = 0.0;
            double error = 0.0;
            for (int y = 2; y < Size; y += 6)
            {
              for (int x = 2; x < Size; x += 9)
              {
                const Vec3 ray = this->GetRay(x, y);
                const double reach = distance / dot(ray, this->Look);
                const double ground = vtkGodRays::SkyGroundDistance(EarthRadius, height, ray.z);
                if (ground >= 0.0 && ground < reach)
                {
                  continue;
                }
                Vec3 light;
                Vec3 left;
                IntegrateAir(this->Sky->GetAtmosphere(), height, ray, towards, reach, light, left);
                const Vec3 truth = light + behind * left;
                brightest = std::max(brightest, GetBrightest(truth));
                error = std::max(error, GetBrightest(abs(this->Seen[y * Size + x] - truth)));
                thinnest = std::min(thinnest, left.z);
              }
            }
            worst = std::max(worst, error / brightest);
          }
        }
      }
      std::cout << "preset " << preset << ", " << height << " m: " << worst
                << " of the brightest\n";
      // from high up, ways dip into dense air and out of it
      EXPECT_LT(worst, height < 10e3 ? 0.01 : 0.045) << preset << " " << height;
    }
    EXPECT_LT(thinnest, 0.1) << "the air is thin everywhere";
  }
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, LeavesDepthAndThinAirAlone)
{
  const auto wall = MakeWall(Vec3(0.0, -50.0, 10.0), Vec3(0.0, -1.0, 0.0), 30.0, 0.4);
  this->Renderer->AddActor(wall);
  this->Renderer->SetPass(nullptr);
  this->Renderer->GetActiveCamera()->SetClippingRange(10.0, 100.0);
  const auto depths = GetDepths(this->Window);
  const auto plain = GetPixels(this->Window);
  this->Renderer->SetPass(this->Sky);
  for (const bool thick : { false, true })
  {
    this->Sky->SetWorldUnitInMeters(thick ? 1000.0 : 0.01);
    EXPECT_EQ(depths, GetDepths(this->Window));
    EXPECT_EQ(Says(this->Sky->GetPlan(), "air: none, it is too little"), !thick);
    const auto pixels = GetPixels(this->Window);
    int sky = 0;
    int changed = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      const bool same = std::equal(&plain[4 * i], &plain[4 * i + 3], &pixels[4 * i]);
      sky += depths[i] == 1.0f && !same;
      changed += depths[i] < 1.0f && !same;
    }
    EXPECT_GT(sky, 500);
    EXPECT_EQ(changed > 500, thick) << changed;
  }
}

TEST_F(GodRaysSkyPass, IsBehindWhatIsTranslucent)
{
  const auto veil = MakeWall(Vec3(0.0, -50.0, 20.0), Vec3(0.0, -1.0, 0.0), 200.0, 0.0);
  this->Sky->AerialPerspectiveOff();
  this->Sky->SetExposure(4.0);
  this->Renderer->SetPass(this->Sky);
  const auto open = GetPixels(this->Window);
  this->Renderer->AddActor(veil);
  veil->GetProperty()->SetOpacity(0.5);
  const auto veiled = GetPixels(this->Window);
  const int upper = 4 * (40 * Size + 24);
  ASSERT_GT(open[upper + 2], 50);
  EXPECT_NEAR(veiled[upper + 2], 0.5 * open[upper + 2], 2.5);

  vtkNew<vtkGodRaysSkyPass>
    outer; // the sky of a delegate is drawn after it, and replaces what it covers
  outer->SetExposure(4.0);
  outer->WhiteBalanceOff();
  outer->SetSunElevation(30.0);
  this->Sky->SetExposure(0.0);
  outer->SetDelegatePass(this->Sky);
  outer->MultipleScatteringOff();
  outer->SunDiscOff();
  this->Renderer->SetPass(outer);
  EXPECT_EQ(GetPixels(this->Window)[upper + 2], open[upper + 2]);
}

TEST_F(GodRaysSkyPass, LeavesSelectionsAlone)
{
  const auto wall = MakeWall(Vec3(0.0, -50.0, 10.0), Vec3(0.0, -1.0, 0.0), 30.0, 0.4);
  this->Renderer->AddActor(wall);
  this->Renderer->SetPass(this->Sky);
  this->Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  EXPECT_EQ(selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()), wall);
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: none, a hardware selection is made"));
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, MakesNothingWithoutCause)
{
  this->Renderer->AddActor(MakeWall(Vec3(0.0, -5e3, 0.0), Vec3(0.0, -1.0, 0.0), 3e3, 0.4));
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 2);
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: a new table, as there was none"));
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 60.0)
  {
    this->SetView(2.0, azimuth, 5.0, 50.0);
    this->Sky->SetSunAzimuth(azimuth / 3.0);
    this->Sky->SetExposure(1.0 + azimuth);
    this->Render();
    EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: the table is kept"));
  }
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 2);
  this->SetView(180.0, 180.0, 5.0, 50.0);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the observer's height changed"));
  this->SetSun(10.0);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the sun's elevation changed"));
  this->Sky->GetAtmosphere()->SetMieAsymmetry(0.7);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the atmosphere changed"));
  this->SetMultipleScattering(true);
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 10);
  this->Sky->ReleaseGraphicsResources(this->Window);
  const auto before = this->Seen;
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 12);
  EXPECT_EQ(before, this->Seen);
}

// Where values have 8 bits, light that is brighter than white keeps its hue: below half of white, all of it
// is as it is; floating-point values always are.
TEST_F(GodRaysSkyPass, KeepsItsHueWhereItIsBright)
{
  this->Sky->GetAtmosphere()->LoadPreset(Atmosphere::MARS);
  this->Sky->SetExposure(12.0);
  this->SetSun(8.0);
  this->SetView(2.0, 180.0, 12.0, 60.0);
  const std::vector<Vec3> light = this->Render();
  double brightest = 0.0;
  for (const Vec3& each : light)
  {
    brightest = std::max(brightest, GetBrightest(each));
  }
  EXPECT_GT(brightest, 4.0); // the shoulder is not for them

  struct Picture
  {
    double Clipped = 0.0; // part of the pixels
    double Below = 0.0;   // largest error below the knee [levels of 255]
    double Hue = 0.0;     // largest error of a channel above it, in units of the brightest
    int Above = 0;        // pixels above the knee
  };
  this->Renderer->SetPass(this->Sky);
  const auto look = [&]
  {
    const auto pixels = GetPixels(this->Window);
    Picture picture;
    for (std::size_t i = 0; i < light.size(); ++i)
    {
      const Vec3 shown(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
      picture.Clipped +=
        GetBrightest(shown) == 255.0 ? 1.0 / static_cast<double>(light.size()) : 0.0;
      if (GetBrightest(light[i]) < 0.49)
      {
        picture.Below = std::max(
          picture.Below, GetBrightest(abs(shown - 255.0 * vtkGodRays::EncodeDisplay(light[i]))));
        continue;
      }
      ++picture.Above;
      const Vec3 seen = vtkGodRays::DecodeDisplay(shown / 255.0);
      picture.Hue = std::max(picture.Hue,
        GetBrightest(abs(seen / GetBrightest(seen) - light[i] / GetBrightest(light[i]))));
    }
    return picture;
  };
  EXPECT_FALSE(this->Sky->GetHighlightShoulder());
  this->Sky->HighlightShoulderOn();
  const Picture with = look();
  std::cout << "8 bits: " << 100.0 * with.Clipped << " % clipped, hue within " << with.Hue << " of "
            << with.Above << " bright pixels, " << with.Below << " levels off below\n";
  EXPECT_EQ(with.Clipped, 0.0);
  EXPECT_LT(with.Below, 0.6);
  EXPECT_LT(with.Hue, 0.02);
  EXPECT_GT(with.Above, 100);

  // the sun is seen, as the only white
  const auto sky = GetPixels(this->Window);
  this->Sky->SunDiscOn();
  const auto sun = GetPixels(this->Window);
  this->Sky->SunDiscOff();
  int white = 0;
  for (std::size_t i = 0; i < sky.size(); ++i)
  {
    EXPECT_GE(sun[i], sky[i]) << i;
    white += i % 4 < 3 && sun[i] == 255;
  }
  EXPECT_GT(white, 2);

  this->Sky->HighlightShoulderOff();
  const Picture without = look();
  std::cout << "without a shoulder: " << 100.0 * without.Clipped << " % clipped, hue within "
            << without.Hue << "\n";
  EXPECT_GT(without.Clipped, 0.1);
  EXPECT_GT(without.Hue, 0.2);
  EXPECT_LT(without.Below, 0.6);

  // tone mapping has all of the light
  this->Sky->HighlightShoulderOn();
  this->Renderer->SetPass(this->Floats);
  const auto& again = this->Render();
  EXPECT_EQ(again, light);
}

TEST_F(GodRaysSkyPass, HasASunThatIsDarkerTowardsItsLimb)
{
  this->SetSun(40.0);
  this->SetView(2.0, 180.0, 40.0, 0.8);
  const auto bare = this->Render();
  this->Sky->SunDiscOn();
  const auto& disc = this->Render();
  Vec3 sum(0.0);
  for (std::size_t i = 0; i < disc.size(); ++i)
  {
    sum += disc[i] - bare[i];
  }
  const double pixel = 2.0 * this->Tangent / Size;
  double irradiance[3];
  ASSERT_TRUE(this->Truth->GetSunLight(irradiance));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(sum[c] * pixel * pixel / irradiance[c], 1.0, 0.01);
  }
  const Vec3 middle = disc[Size * Size / 2 + Size / 2];
  const Vec3 limb = disc[Size * Size / 2 + Size / 2 + 14]; // of 16 pixels
  EXPECT_NEAR(limb.x / middle.x, std::pow(1.0 - 14.5 * 14.5 / 16.07 / 16.07, 0.2032), 0.03);
  EXPECT_LT(limb.z / middle.z, limb.x / middle.x);
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, GivesALightTheColourOfTheSun)
{
  vtkNew<vtkLight> light;
  this->Sky->SetExposure(2.0);
  double former = 2.0;
  for (const double sun : { 60.0, 20.0, 5.0, 1.0 })
  {
    this->SetSun(sun);
    this->Truth->SetObserverHeight(0.0);
    this->Sky->UpdateLight(light);
    double truth[3];
    ASSERT_TRUE(this->Truth->GetSunLight(truth));
    double color[3];
    this->Sky->GetSunColor(color);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(color[c], truth[c]);
      EXPECT_NEAR(vtkGodRays::DecodeDisplay(light->GetDiffuseColor()[c]) * light->GetIntensity(),
        2.0 * truth[c] / vtkMath::Pi(), 1e-9);
    }
    EXPECT_LT(color[2] / color[0], former) << "redder when lower";
    former = color[2] / color[0];
    double towards[3];
    vtkMath::Subtract(light->GetPosition(), light->GetFocalPoint(), towards);
    EXPECT_LT(length(ToVec3(towards) - GetDirection(180.0, sun)), 1e-9);
  }
  this->SetSun(-1.0);
  this->Sky->UpdateLight(light);
  EXPECT_EQ(light->GetIntensity(), 0.0);
  this->Sky->UpdateLight(nullptr);
  EXPECT_EQ(this->Said.Take().size(), 1u);
}

TEST_F(GodRaysSkyPass, HasAWhiteSun)
{
  Atmosphere* air = this->Sky->GetAtmosphere();
  const Vec3 sun = ToVec3(air->GetSunIrradiance());
  const Vec3 gain = vtkGodRays::Luminance(sun) / sun;
  this->SetView(2.0, 180.0, 20.0, 60.0);
  const auto plain = this->Render();
  vtkNew<vtkLight> light;
  this->Sky->UpdateLight(light);
  const Vec3 bluish = ToVec3(light->GetDiffuseColor());
  const double bluishIntensity = light->GetIntensity();
  this->Sky->WhiteBalanceOn();
  const auto& balanced = this->Render();
  ASSERT_GT(GetBrightest(plain[100]), 1e-3);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_LT(GetBrightest(abs(balanced[i] - gain * plain[i])), 1e-5 * GetBrightest(balanced[i]))
      << i;
  }
  this->Sky->UpdateLight(light);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(vtkGodRays::DecodeDisplay(light->GetDiffuseColor()[c]) * light->GetIntensity(),
      gain[c] * vtkGodRays::DecodeDisplay(bluish[c]) * bluishIntensity, 1e-9);
  }
}

TEST_F(GodRaysSkyPass, IsUnderTheRaysInTheSunsColour)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(96, 64);
  window->AddRenderer(renderer);
  renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->SetView(2.0, 180.0, 5.0, 50.0);
  for (int i = -2; i <= 2; ++i)
  {
    renderer->AddActor(MakeBox({ 6.0 * i, -40.0, 5.0 }, { 2.0, 2.0, 14.0 }));
  }
  this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 100.0);
  const auto getPicture = [&](bool raysFirst, double elevation, double* blueOverRed)
  {
    vtkNew<vtkGodRaysPass> rays;
    vtkNew<vtkLight> sun;
    if (raysFirst)
    {
      rays->Attach(renderer);
    }
    vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
    EXPECT_EQ(sky, vtkGodRaysSkyPass::Attach(renderer)) << "the one that it has";
    if (!raysFirst)
    {
      rays->Attach(renderer);
    }
    EXPECT_EQ(renderer->GetPass(), rays);
    EXPECT_EQ(rays->GetDelegatePass(), sky);
    sky->MultipleScatteringOff();
    sky->SetSunElevation(elevation);
    sky->UpdateLight(sun);
    rays->AddLight(sun);
    auto picture = GetPixels(window);
    vtkNew<vtkImageData> light;
    EXPECT_TRUE(rays->GetScatteringImage(light));
    EXPECT_GT(GetMean(light), 1e-3);
    double sums[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 96 * 64; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        sums[c] += GetValue(light, i % 96, i / 96, c);
      }
    }
    *blueOverRed = sums[2] / sums[0];
    EXPECT_TRUE(vtkGodRaysSkyPass::Detach(renderer));
    EXPECT_EQ(renderer->GetPass(), rays);
    EXPECT_EQ(rays->GetDelegatePass(), nullptr);
    rays->Detach(renderer);
    EXPECT_EQ(renderer->GetPass(), nullptr);
    return picture;
  };
  double high = 0.0;
  double low = 0.0;
  const auto picture = getPicture(false, 10.0, &high);
  EXPECT_EQ(picture, getPicture(true, 10.0, &high)) << "in whatever order they are attached";
  getPicture(false, 2.0, &low);
  EXPECT_LT(low, 0.5 * high);
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(renderer));
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(this->Renderer)) << "the delegate of another pass";
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(nullptr));
  EXPECT_EQ(vtkGodRaysSkyPass::Attach(nullptr), nullptr);
  EXPECT_EQ(this->Said.Take().size(), 1u);
}

//------------------------------------------------------------------------------
// As VTK's shaders look it up: right, up and their cross product are x, y and z of a sphere.
TEST_F(GodRaysSkyPass, HasAnEnvironment)
{
  this->Sky->SetExposure(2.0);
  this->Truth->SetObserverHeight(0.0);
  vtkTexture* texture = this->Sky->GetEnvironmentTexture();
  ASSERT_TRUE(texture);
  vtkImageData* image = texture->GetInput();
  ASSERT_EQ(image->GetDimensions()[0], 128);
  const vtkMTimeType time = image->GetMTime();
  const Vec3 up(0.0, 0.0, 1.0);
  const Vec3 right(0.0, -1.0, 0.0);
  const Vec3 third = cross(right, up);
  for (const double azimuth : { 10.0, 100.0, 180.0, 300.0 })
  {
    const Vec3 ray = GetDirection(azimuth, 35.0);
    const double u = std::atan2(dot(ray, third), dot(ray, right)) / (2.0 * vtkMath::Pi()) + 0.5;
    const double v = std::asin(dot(ray, up)) / vtkMath::Pi() + 0.5;
    const int x = static_cast<int>(u * 128.0);
    const int y = static_cast<int>(v * 64.0);
    const Vec3 truth = 2.0 * this->GetTruth(ray);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetValue(image, x, y, c) / truth[c], 1.0, 0.1) << azimuth << " " << c;
    }
  }
  EXPECT_EQ(this->Sky->GetEnvironmentTexture()->GetInput()->GetMTime(), time);
  this->Sky->SetSunElevation(31.0);
  EXPECT_EQ(this->Sky->GetEnvironmentTexture(), texture);
  EXPECT_GT(texture->GetInput()->GetMTime(), time);
}

//------------------------------------------------------------------------------
// Hills in haze before a low sun, in the colours of that sun.
TEST_F(GodRaysSkyPass, MakesAPicture)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(320, 200);
  window->AddRenderer(renderer);
  this->SetView(300.0, 154.0, 5.0, 40.0);
  renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> sun;
  renderer->AddLight(sun);
  const double distances[] = { 3e3, 7e3, 14e3, 28e3, 56e3 };
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkConeSource> hill;
    const double distance = distances[i / 4];
    const double turn = 40.0 * (i % 4 + 0.37 * (i * i % 3)) - 90.0;
    const double height = 300.0 + distance * (0.04 + 0.02 * (i * 7 % 5) / 4.0);
    const Vec3 place = distance * GetDirection(154.0 + 0.4 * turn, 0.0);
    hill->SetResolution(7);
    hill->SetDirection(0.0, 0.0, 1.0);
    hill->SetHeight(height);
    hill->SetRadius(3.0 * height);
    hill->SetCenter(place.x, place.y, 0.5 * height);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(hill->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.35, 0.4, 0.3);
    renderer->AddActor(actor);
  }
  renderer->ResetCameraClippingRange();
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->GetAtmosphere()->LoadPreset(Atmosphere::EARTH_HAZY);
  sky->SetSunElevation(8.0);
  sky->SetExposure(1.5);
  sky->UpdateLight(sun);
  const auto pixels = GetPixels(window);
  EXPECT_TRUE(IsLikeBaseline(window, "GodRaysSkyPass"));
  const auto get = [&pixels](int x, int y) { return &pixels[4 * (320 * y + x)]; };
  EXPECT_GT(get(5, 195)[2], get(5, 195)[0] + 8) << "away from the sun the sky is blue";
  EXPECT_GT(get(270, 100)[0], get(270, 100)[2] + 30) << "below the sun it is yellow";
  EXPECT_GT(get(290, 40)[0], get(30, 40)[0] + 60) << "hills are bright before the sun";
  sky->AerialPerspectiveOff();
  GetPixels(window);
  EXPECT_FALSE(IsLikeBaseline(window, "GodRaysSkyPass", 2, true));
}

TEST_F(GodRaysSkyPass, IsInItsViewportAlone)
{
  this->Renderer->SetPass(this->Sky);
  const auto alone = GetPixels(this->Window);
  vtkNew<vtkRenderer> other;
  other->SetActiveCamera(this->Renderer->GetActiveCamera());
  other->SetViewport(0.0, 0.0, 0.5, 0.5);
  other->SetBackground(0.2, 0.4, 0.6);
  this->Window->AddRenderer(other);
  this->Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  this->Window->SetSize(2 * Size, 2 * Size);
  const auto both = GetPixels(this->Window);
  for (int y = 0; y < 2 * Size; ++y)
  {
    for (int x = 0; x < 2 * Size; ++x)
    {
      const unsigned char* pixel = &both[4 * (2 * y * Size + x)];
      if (x >= Size && y >= Size)
      {
        ASSERT_TRUE(std::equal(pixel, pixel + 3, &alone[4 * ((y - Size) * Size + x - Size)]));
      }
      else
      {
        ASSERT_TRUE(x < Size && y < Size ? pixel[0] == 51 : pixel[0] == 0) << x << " " << y;
      }
    }
  }
  vtkGodRaysSkyPass::Attach(other)->SetSunElevation(5.0);
  const auto skies = GetPixels(this->Window);
  EXPECT_TRUE(std::equal(&skies[4 * (3 * Size * Size + Size)],
    &skies[4 * (3 * Size * Size + 2 * Size)], &both[4 * (3 * Size * Size + Size)]))
    << "two skies do not meet";
  EXPECT_NE(skies[4 * (Size * Size + 10)], 51);
}

TEST_F(GodRaysSkyPass, IsOneColourInAParallelProjection)
{
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  const Vec3 truth = this->GetTruth(this->Look);
  for (const Vec3& seen : this->Render())
  {
    EXPECT_LT(GetBrightest(abs(seen - truth)), 0.002 * GetBrightest(truth));
  }
}

TEST_F(GodRaysSkyPass, SaysWhatIsWrong)
{
  this->Sky->SetSunElevation(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(this->Sky->GetSunElevation(), 30.0);
  this->Sky->SetUp(0.0, 0.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(this->Said.Take().size(), 2u);

  this->Renderer->SetBackground(1.0, 0.0, 0.0);
  const auto isPlain = [this] { return this->Render()[0] == Vec3(1.0, 0.0, 0.0); };
  EXPECT_FALSE(isPlain());
  this->Sky->GetAtmosphere()->SetMieScattering(-1.0, 0.0, 0.0);
  EXPECT_TRUE(isPlain());
  EXPECT_TRUE(isPlain());
  auto said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without sky: a coefficient of the atmosphere is out of range. Set"));
  EXPECT_EQ(this->Sky->GetEnvironmentTexture(), nullptr);
  this->Said.Take();

  this->Sky->GetAtmosphere()->LoadPreset(Atmosphere::EARTH_CLEAR);
  EXPECT_FALSE(isPlain());
  this->Sky->SetNorth(0.0, 0.0, 3.0);
  EXPECT_TRUE(isPlain());
  said = this->Said.Take();
  ASSERT_FALSE(said.empty());
  EXPECT_TRUE(Says(said.back(), "Up and North")) << said.back();
  this->Sky->SetNorth(0.0, 1.0, 0.0);

  this->Sky->SetDelegatePass(this->Sky);
  this->Render();
  said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without the delegate of this pass: it leads back")) << said[0];
  this->Sky->SetDelegatePass(nullptr);

  // A tilted picture has a sky, but no air before the scene.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  this->Renderer->AddActor(MakeWall(1e3 * this->Look, this->Look, 100.0, 0.4));
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0));
  projection->SetElement(0, 1, 0.3);
  camera->UseExplicitProjectionTransformMatrixOn();
  camera->SetExplicitProjectionTransformMatrix(projection);
  this->Renderer->SetPass(this->Sky); // the other pass has a camera without the matrix
  EXPECT_NE(GetPixels(this->Window)[2], 0) << "the background has no blue";
  GetPixels(this->Window);
  said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without the air before it: the picture is tilted")) << said[0];
  this->Renderer->SetPass(this->Floats); // which wants to be released
}
