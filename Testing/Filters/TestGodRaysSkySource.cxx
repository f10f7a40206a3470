// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky against published radiances, closed forms and itself, at all heights and hours; and as a source
// of VTK: parts, types, progress, errors.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSkySource.h"
#include "vtkGodRaysSun.h"

#include "vtkMath.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

using namespace GodRaysFiltersTesting;
using Source = vtkGodRaysSkySource;
using Atmosphere = vtkGodRaysAtmosphere;
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

namespace
{
const double pi = 3.14159265358979323846;

Vec3 GetPixel(Source* source, int x, int y, int z = 0)
{
  vtkImageData* image = source->GetOutput();
  return Vec3(image->GetScalarComponentAsDouble(x, y, z, 0),
    image->GetScalarComponentAsDouble(x, y, z, 1), image->GetScalarComponentAsDouble(x, y, z, 2));
}

// Azimuth is counted from the sun [degrees].
Vec3 GetRadiance(Source* source, double viewZenith, double azimuth)
{
  const double zenith = vtkMath::RadiansFromDegrees(viewZenith);
  const double turn = vtkMath::RadiansFromDegrees(source->GetSunAzimuth() + azimuth);
  const double direction[3] = { std::sin(zenith) * std::sin(turn),
    std::sin(zenith) * std::cos(turn), std::cos(zenith) };
  Vec3 radiance;
  EXPECT_TRUE(source->GetRadiance(direction, &radiance[0]));
  return radiance;
}

struct Golden
{
  double SunZenith, ViewZenith, Azimuth;
  Vec3 Radiance;
};
// Single scattering, converged, without ground, from 0.5 m. [W/(m^2 sr nm)]
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

void Prepare(Source* source, double sunZenith, double tolerance)
{
  source->GetAtmosphere()->SetGroundAlbedo(0.0, 0.0, 0.0);
  source->SetObserverHeight(0.5);
  source->SetSunElevation(90.0 - sunZenith);
  source->SetTolerance(tolerance);
}
}

//------------------------------------------------------------------------------
// The published constants are rounded: what is left is of the order of 1e-4.
TEST(SkySource, IsThePublishedSky)
{
  for (const Golden& golden : goldens)
  {
    vtkNew<Source> source;
    Prepare(source, golden.SunZenith, 1e-3);
    const Vec3 radiance = GetRadiance(source, golden.ViewZenith, golden.Azimuth);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(radiance[c] / golden.Radiance[c], 1.0, 1e-3)
        << golden.SunZenith << " " << golden.ViewZenith << " " << golden.Azimuth << " " << c;
    }
  }
}

//------------------------------------------------------------------------------
// Against itself with a tolerance of 1e-10.
TEST(SkySource, KeepsItsTolerance)
{
  for (const double sun : { 0.0, 60.0, 89.0, 93.0, 97.0 })
  {
    for (const double view : { 0.0, 45.0, 80.0, 89.0, 89.9 })
    {
      for (const double height : { 0.5, 12e3 })
      {
        vtkNew<Source> source;
        Prepare(source, sun, 1e-10);
        source->SetObserverHeight(height);
        const Vec3 converged = GetRadiance(source, view, 150.0);
        for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-6 })
        {
          source->SetTolerance(tolerance);
          const Vec3 radiance = GetRadiance(source, view, 150.0);
          const double brightest = std::max(converged.x, std::max(converged.y, converged.z));
          for (int c = 0; c < 3; ++c)
          {
            EXPECT_NEAR(radiance[c], converged[c], tolerance * brightest + 1e-300)
              << sun << " " << view << " " << height;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// A plane atmosphere without absorption has a closed form: that of ExponentialAirlight.
TEST(SkySource, IsTheClosedFormOverAHugePlanet)
{
  vtkNew<Source> source;
  Atmosphere* air = source->GetAtmosphere();
  Prepare(source, 60.0, 1e-9);
  air->SetGroundRadius(1e9);
  air->SetTopHeight(40e3); // 33 scale heights
  air->SetRayleighScattering(0.0, 0.0, 0.0);
  air->SetOzoneAbsorption(0.0, 0.0, 0.0);
  air->SetMieScattering(1.8e-4, 1.8e-5, 1.8e-6);
  air->SetMieAbsorption(0.2e-4, 0.2e-5, 0.2e-6);
  air->SetMiePhaseFunction(Atmosphere::ISOTROPIC);
  air->SetSunIrradiance(1.0, 1.0, 1.0);
  const double slope = 0.5;
  const Vec3 radiance = GetRadiance(source, 60.0, 37.0);
  for (int c = 0; c < 3; ++c)
  {
    const double scattering = air->GetMieScattering()[c];
    const double expected = scattering / (4.0 * pi) *
      vtkGodRays::ExponentialAirlight(scattering / 0.9, 0.5, slope, 0.5, 1200.0, 0.0, 40e3 / slope);
    EXPECT_NEAR(radiance[c] / expected, 1.0, 1e-5) << c; // 40 km of a planet of 1e6 km are curved
  }
}

//------------------------------------------------------------------------------
TEST(SkySource, IsFiniteEverywhere)
{
  for (const int preset : { Atmosphere::EARTH_CLEAR, Atmosphere::EARTH_POLLUTED, Atmosphere::MARS,
         Atmosphere::LODATO_2015 })
  {
    vtkNew<Source> source;
    source->SetAtmospherePreset(preset);
    source->SetMapping(Source::EQUIRECTANGULAR);
    source->SetResolution(9); // the fifth row is exactly level
    source->SetTolerance(1e-2);
    source->SetSunDisc(true);
    source->SetMultipleScattering(preset == Atmosphere::MARS);
    for (const double height : { 0.0, 1e-3, 2.0, 10e3, 100e3, 2.0 * 6360e3, 1e12 })
    {
      for (const double sun : { 90.0, 30.0, 5.0, 0.0, -5.0, -6.0, -20.0, -90.0 })
      {
        source->SetObserverHeight(height);
        source->SetSunElevation(sun);
        source->Update();
        vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
        for (int c = 0; c < 3; ++c)
        {
          double range[2];
          values->GetRange(range, c);
          EXPECT_TRUE(range[0] >= 0.0 && range[1] < 1e5)
            << preset << " " << height << " " << sun << " " << range[0] << " " << range[1];
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Small changes of the sun, the observer and the view change little.
TEST(SkySource, IsContinuous)
{
  vtkNew<Source> source;
  Prepare(source, 90.0, 1e-6);
  const auto expectNear = [](const Vec3& a, const Vec3& b, double tolerance, double where)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(a[c] / b[c], 1.0, tolerance) << where;
    }
  };
  // The sun sets, from 2 degrees above to 6 below; 2 below that the shadow fills the atmosphere.
  Vec3 before = GetRadiance(source, 45.0, 30.0);
  for (double elevation = 2.0; elevation > -6.0; elevation -= 0.005)
  {
    source->SetSunElevation(elevation);
    const Vec3 radiance = GetRadiance(source, 45.0, 30.0);
    if (elevation < 2.0)
    {
      expectNear(radiance, before, 0.02, elevation);
    }
    before = radiance;
  }
  // Through the level, from 10 km; and up through the top of the atmosphere.
  source->SetSunElevation(20.0);
  source->SetObserverHeight(10e3);
  expectNear(
    GetRadiance(source, 90.0 - 1e-7, 90.0), GetRadiance(source, 90.0 + 1e-7, 90.0), 1e-5, 0);
  expectNear(GetRadiance(source, 90.0, 90.0), GetRadiance(source, 90.0 + 1e-7, 90.0), 1e-5, 0);
  source->SetObserverHeight(60e3 - 1e-3);
  const Vec3 inside = GetRadiance(source, 95.0, 90.0);
  source->SetObserverHeight(60e3 + 1e-3);
  expectNear(GetRadiance(source, 95.0, 90.0), inside, 1e-4, 60e3);
  // At the ground, up to the eye's height.
  source->SetObserverHeight(0.0);
  const Vec3 level = GetRadiance(source, 90.0, 90.0);
  source->SetObserverHeight(1e-3);
  expectNear(GetRadiance(source, 90.0, 90.0), level, 1e-4, 0.0);
}

//------------------------------------------------------------------------------
// [Lodato2015]: uniform density and steps of the first order. Over a huge planet, with the sun in the
// zenith, the light from a point at distance d of a view of slope s is as e^(-beta (1 - s) d): the sum
// is too large by the bias of a step of that depth. With the view to the sun it is exact.
TEST(SkySource, StepsAreThePublishedOnes)
{
  vtkNew<Source> source;
  source->SetAtmospherePreset(Atmosphere::LODATO_2015);
  source->GetAtmosphere()->SetGroundRadius(1e9);
  Prepare(source, 0.0, 1e-8);
  source->SetObserverHeight(0.0);
  for (const double slope : { 1.0, 0.5, 0.1 })
  {
    const double view = vtkMath::DegreesFromRadians(std::acos(slope));
    source->SetMethod(Source::ADAPTIVE);
    const Vec3 converged = GetRadiance(source, view, 0.0);
    source->SetMethod(Source::STEPS);
    for (const int steps : { 1, 8, 64, 256 })
    {
      source->SetNumberOfSteps(steps);
      const Vec3 radiance = GetRadiance(source, view, 0.0);
      for (int c = 0; c < 3; ++c)
      {
        const double extinction = source->GetAtmosphere()->GetRayleighScattering()[c] +
          source->GetAtmosphere()->GetMieScattering()[c];
        const double depth = extinction * (1.0 - slope) * 8000.0 / slope / steps;
        EXPECT_NEAR(radiance[c] / converged[c], 1.0 / vtkGodRays::MeanExponential(depth), 1e-3)
          << slope << " " << steps << " " << c;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The zenith's whole radiance by paths of light of all orders: Testing/Benchmark/SkyError.cxx, 100000 of
// them, with a standard error of 0.3 to 0.7 %. [W/(m^2 sr nm)]
TEST(SkySource, MultipleScatteringIsThatOfPathsInTheZenith)
{
  const double zenithAngles[] = { 30.0, 60.0, 85.0 };
  const Vec3 expected[] = { { 9.459e-3, 2.437e-2, 5.789e-2 }, { 5.760e-3, 1.586e-2, 3.940e-2 },
    { 3.425e-3, 6.984e-3, 1.393e-2 } };
  vtkNew<Source> source;
  for (int i = 0; i < 3; ++i)
  {
    source->SetSunElevation(90.0 - zenithAngles[i]);
    source->SetMultipleScattering(false);
    const Vec3 once = GetRadiance(source, 0.0, 0.0);
    source->SetMultipleScattering(true);
    const Vec3 all = GetRadiance(source, 0.0, 0.0);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(all[c] / expected[i][c], 1.0, 0.05) << zenithAngles[i] << " " << c;
      EXPECT_LT(once[c] / expected[i][c], 0.92) << zenithAngles[i] << " " << c;
    }
  }
}

//------------------------------------------------------------------------------
// A disc of any number of pixels brings the sun's irradiance to the observer.
TEST(SkySource, TheDiscKeepsItsEnergy)
{
  for (const int resolution : { 64, 256, 1500 })
  {
    vtkNew<Source> source;
    source->SetMapping(Source::FISHEYE);
    source->SetResolution(resolution);
    source->SetSunElevation(71.3);
    source->SetOutputScalarType(VTK_DOUBLE);
    source->SetTolerance(0.1);
    // The part of the picture about the sun alone.
    const int x = resolution / 2;
    const int y = static_cast<int>((1.0 - (90.0 - 71.3) / 90.0) / 2.0 * resolution);
    const int extent[6] = { x - 9, x + 9, y - 9, y + 9, 0, 0 };
    Vec3 sums[2];
    for (int disc = 0; disc < 2; ++disc)
    {
      source->SetSunDisc(disc == 1);
      source->UpdateExtent(extent);
      sums[disc] = Vec3(0.0);
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          const Vec2 position(
            (2.0 * i + 1.0) / resolution - 1.0, (2.0 * j + 1.0) / resolution - 1.0);
          sums[disc] += GetPixel(source, i, j) * vtkGodRays::SkyMapSolidAngle(2, position) * 4.0 /
            double(resolution) / double(resolution);
        }
      }
    }
    double irradiance[3];
    ASSERT_TRUE(source->GetSunLight(irradiance));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR((sums[1][c] - sums[0][c]) / irradiance[c], 1.0, 0.026)
        << resolution; // DiscCoverage
    }
  }
}

//------------------------------------------------------------------------------
TEST(SkySource, TheSunsLightIsDimmedAndSets)
{
  vtkNew<Source> source;
  source->SetSunElevation(90.0);
  source->SetObserverHeight(0.0);
  double light[3];
  ASSERT_TRUE(source->GetSunLight(light));
  const double depths[3] = { 0.061471, 0.141945, 0.271257 };
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(
      light[c] / source->GetAtmosphere()->GetSunIrradiance()[c], std::exp(-depths[c]), 2e-5);
  }
  source->SetSunElevation(1.0);
  ASSERT_TRUE(source->GetSunLight(light));
  EXPECT_GT(light[0], 3.0 * light[2]); // red
  source->SetSunElevation(-1.0);
  ASSERT_TRUE(source->GetSunLight(light));
  EXPECT_EQ(light[0], 0.0);
  source->SetObserverHeight(1e5); // from where the horizon is 10 degrees lower
  ASSERT_TRUE(source->GetSunLight(light));
  EXPECT_GT(light[0], 0.0);
}

//------------------------------------------------------------------------------
// All mappings have the same sky: the irradiance of the ground by the upper hemisphere.
TEST(SkySource, MappingsAgree)
{
  Vec3 sums[4];
  for (int mapping = Source::PARABOLOID; mapping <= Source::CUBE_MAP; ++mapping)
  {
    vtkNew<Source> source;
    source->SetMapping(mapping);
    source->SetResolution(mapping == Source::EQUIRECTANGULAR ? 90 : 96);
    source->SetSunElevation(30.0);
    source->SetTolerance(1e-4);
    source->Update();
    int size[3];
    source->GetOutput()->GetDimensions(size);
    sums[mapping] = Vec3(0.0);
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          const Vec2 position((2.0 * x + 1.0) / size[0] - 1.0, (2.0 * y + 1.0) / size[1] - 1.0);
          const bool cube = mapping == Source::CUBE_MAP;
          Vec3 direction = cube ? vtkGodRays::CubeMapDirection(z, position)
                                : vtkGodRays::SkyMapDirection(mapping, position);
          const double distance = vtkGodRays::length(direction);
          const double angle = 4.0 / size[0] / size[1] *
            (cube ? std::pow(distance, -3.0) : vtkGodRays::SkyMapSolidAngle(mapping, position));
          const bool within = mapping % 2 == 1 || vtkGodRays::dot(position, position) < 1.0;
          sums[mapping] += within
            ? GetPixel(source, x, y, z) * angle * std::max(direction.z / distance, 0.0)
            : Vec3(0.0);
        }
      }
    }
  }
  for (int mapping = Source::EQUIRECTANGULAR; mapping <= Source::CUBE_MAP; ++mapping)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(sums[mapping][c] / sums[0][c], 1.0, 0.003) << mapping;
    }
  }
  // Of blue light that the air takes from the sun's, 0.40 W/(m^2 nm), less than half comes down.
  EXPECT_LT(sums[0].z, 0.20);
  EXPECT_GT(sums[0].z, 0.10);
}

//------------------------------------------------------------------------------
TEST(SkySource, PartsAreThoseOfTheWhole)
{
  vtkNew<Source> whole;
  whole->SetMapping(Source::CUBE_MAP);
  whole->SetResolution(12);
  whole->SetTolerance(1e-2);
  whole->Update();
  EXPECT_EQ(whole->GetOutput()->GetScalarType(), VTK_FLOAT);
  EXPECT_STREQ(whole->GetOutput()->GetPointData()->GetScalars()->GetName(), "Radiance");
  vtkNew<Source> part;
  part->SetMapping(Source::CUBE_MAP);
  part->SetResolution(12);
  part->SetTolerance(1e-2);
  const int extent[6] = { 3, 7, 2, 9, 1, 4 };
  part->UpdateExtent(extent);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(GetPixel(part, 5, 4, 2)[c], GetPixel(whole, 5, 4, 2)[c]);
    EXPECT_EQ(GetPixel(part, 7, 9, 4)[c], GetPixel(whole, 7, 9, 4)[c]);
  }
}

//------------------------------------------------------------------------------
TEST(SkySource, ExecutesWhenSomethingChanged)
{
  vtkNew<Source> source;
  source->SetResolution(8);
  source->Update();
  const Vec3 before = GetPixel(source, 4, 4);
  const vtkMTimeType time = source->GetOutput()->GetMTime();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetMTime(), time);
  source->GetAtmosphere()->SetSunIrradiance(2.948, 3.7008, 3.82396);
  source->Update();
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(GetPixel(source, 4, 4)[c] / before[c], 2.0, 1e-6);
  }
}

//------------------------------------------------------------------------------
TEST(SkySource, SaysWhatCannotBeUsed)
{
  vtkNew<Source> source;
  source->SetResolution(8);
  const ErrorListener errors(source);
  source->GetAtmosphere()->SetMieScattering(-1.0, 0.0, 0.0);
  source->Update();
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("MieScattering"), std::string::npos);
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  source->GetAtmosphere()->SetMieScattering(0.0, 0.0, 0.0);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 64);
  const double nowhere[3] = { 0.0, 0.0, 0.0 };
  double radiance[3] = { 1.0, 1.0, 1.0 };
  EXPECT_FALSE(source->GetRadiance(nowhere, radiance));
  EXPECT_EQ(radiance[0], 0.0);
  EXPECT_EQ(errors.Texts.size(), 2u);
  const ErrorListener errorsOfSun(source->GetSun());
  source->SetSunElevation(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(errorsOfSun.Texts.size(), 1u);
}

//------------------------------------------------------------------------------
TEST(SkySource, CanBeStopped)
{
  vtkNew<Source> source;
  source->SetResolution(64);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3);
    });
  source->AddObserver(vtkCommand::ProgressEvent, stop);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
TEST(SkySource, TakesAnAtmosphere)
{
  vtkNew<Source> source;
  vtkNew<Source> other;
  vtkNew<Atmosphere> mars;
  mars->LoadPreset(Atmosphere::MARS);
  other->SetAtmospherePreset(Atmosphere::MARS);
  const Vec3 earth = GetRadiance(source, 40.0, 30.0);
  source->SetAtmosphere(mars);
  EXPECT_EQ(source->GetAtmosphere(), mars);
  EXPECT_EQ(GetRadiance(source, 40.0, 30.0), GetRadiance(other, 40.0, 30.0));
  source->SetAtmosphere(nullptr);
  ASSERT_NE(source->GetAtmosphere(), nullptr);
  EXPECT_EQ(GetRadiance(source, 40.0, 30.0), earth);
}

//------------------------------------------------------------------------------
// The sky of Mars is a light to moderate yellowish brown, linear light of (1.66, 1, 0.45), and redder away
// from the sun [Maki1999]; about a low sun it is blue [Ehlers2014]. In units of the sun's own colour.
TEST(SkySource, IsYellowishBrownOverMarsAndBlueAboutTheSun)
{
  vtkNew<Source> source;
  source->SetAtmospherePreset(Atmosphere::MARS);
  source->MultipleScatteringOn();
  const double* sun = source->GetAtmosphere()->GetSunIrradiance();
  for (const double elevation : { 45.0, 20.0, 5.0, 2.0 })
  {
    Prepare(source, 90.0 - elevation, 1e-3);
    const auto getColor = [&](double zenith, double azimuth)
    {
      const Vec3 color = GetRadiance(source, zenith, azimuth) / Vec3(sun[0], sun[1], sun[2]);
      return color / color.y;
    };
    double before = 0.0;
    for (const double azimuth : { 0.0, 5.0, 10.0, 20.0, 40.0, 90.0 })
    {
      const Vec3 color = getColor(90.0 - elevation, azimuth);
      EXPECT_GT(color.x / color.z, before) << elevation << " " << azimuth;
      before = color.x / color.z;
    }
    EXPECT_GT(getColor(90.0 - elevation, 1.0).z, 1.4);
    EXPECT_LT(getColor(90.0 - elevation, 1.0).x, 0.8);
    for (const double zenith : { 0.0, 30.0, 60.0, 80.0, 88.0 })
    {
      const Vec3 color = getColor(zenith, 180.0);
      EXPECT_NEAR(color.x, 1.66, 0.5) << elevation << " " << zenith;
      EXPECT_NEAR(color.z, 0.45, 0.09) << elevation << " " << zenith;
    }
  }
}

//------------------------------------------------------------------------------
// By night there is no light that is scattered twice where there is none that is scattered once; by day it
// is more over bright ground.
TEST(SkySource, GivesItsTableOfMultipleScattering)
{
  vtkNew<Source> source;
  vtkNew<vtkImageData> table;
  ASSERT_TRUE(source->GetMultipleScattering(table));
  ASSERT_EQ(table->GetDimensions()[0], 48);
  ASSERT_EQ(table->GetDimensions()[1], 16);
  const auto get = [&table](int slope, int height)
  { return table->GetScalarComponentAsDouble(slope, height, 0, 2); };
  EXPECT_EQ(get(0, 0), 0.0);
  EXPECT_GT(get(47, 0), get(30, 0));
  EXPECT_GT(get(47, 2), 0.01);
  const double dark = get(47, 0);
  source->GetAtmosphere()->SetGroundAlbedo(0.9, 0.9, 0.9);
  ASSERT_TRUE(source->GetMultipleScattering(table));
  EXPECT_GT(get(47, 0), 1.5 * dark);

  const ErrorListener errors(source);
  source->GetAtmosphere()->SetMieScattering(-1.0, 0.0, 0.0);
  EXPECT_FALSE(source->GetMultipleScattering(table));
  EXPECT_EQ(table->GetNumberOfPoints(), 0);
  EXPECT_EQ(errors.Texts.size(), 1u);
}

//------------------------------------------------------------------------------
// Irradiance by the forms against sums over all directions; of the brightest of a sky, as its share of a
// surface that nothing else lights is.
TEST(SkySource, FormsAreTheIrradianceOfTheSky)
{
  double worst = 0.0;
  double worstFromAbove = 0.0;
  double control = 0.0; // of the sky from above for every normal
  for (const int preset : { Atmosphere::EARTH_CLEAR, Atmosphere::EARTH_HAZY })
  {
    for (const double elevation : { 50.0, 6.0, -3.0 })
    {
      vtkNew<Source> source;
      source->SetAtmospherePreset(preset);
      source->MultipleScatteringOn();
      source->SetObserverHeight(0.0);
      source->SetSunElevation(elevation);
      source->SetSunAzimuth(75.0);
      double forms[48];
      ASSERT_TRUE(source->GetIrradianceForms(forms));
      constexpr int rows = 40;
      std::vector<Vec3> rays;
      std::vector<Vec3> lights; // times solid angle
      for (int k = 0; k < rows * rows; ++k)
      {
        const double height = pi / rows * (k / rows + 0.5) - 0.5 * pi;
        const double turn = 2.0 * pi / rows * (k % rows + 0.5);
        const Vec3 ray(
          std::cos(height) * std::sin(turn), std::cos(height) * std::cos(turn), std::sin(height));
        Vec3 light;
        ASSERT_TRUE(source->GetRadiance(&ray[0], &light[0]));
        rays.push_back(ray);
        lights.push_back(2.0 * pi * pi / (rows * rows) * std::cos(height) * light);
      }
      const auto sum = [&](const Vec3& normal, const Vec3& ground) // and of that much from below
      {
        Vec3 irradiance = 0.5 * pi * (1.0 - normal.z) * ground;
        for (std::size_t k = 0; k < rays.size(); ++k)
        {
          irradiance += std::max(dot(normal, rays[k]), 0.0) * lights[k];
        }
        return irradiance;
      };
      const Vec3 up(0.0, 0.0, 1.0);
      const Vec3 above = sum(up, Vec3(0.0));
      const double* albedo = source->GetAtmosphere()->GetGroundAlbedo();
      const Vec3 ground = Vec3(albedo[0], albedo[1], albedo[2]) / pi * above;
      const double turn = vtkMath::RadiansFromDegrees(75.0);
      const Vec3 sun(std::sin(turn), std::cos(turn), 0.0);
      const Vec3 normals[] = { up, sun, -sun, normalize(sun + up), Vec3(sun.y, -sun.x, 0.0) };
      std::vector<Vec3> truths;
      double brightest = 0.0;
      for (const Vec3& normal : normals)
      {
        truths.push_back(sum(normal, ground));
        brightest = std::max({ brightest, truths.back().x, truths.back().y, truths.back().z });
      }
      for (std::size_t k = 0; k < truths.size(); ++k)
      {
        const double n[4] = { normals[k].x, normals[k].y, normals[k].z, 1.0 };
        for (int c = 0; c < 3; ++c)
        {
          double found = 0.0;
          for (int i = 0; i < 16; ++i)
          {
            found += forms[16 * c + i] * n[i / 4] * n[i % 4];
          }
          const double error = std::abs(found - truths[k][c]) / brightest;
          worst = std::max(worst, error);
          worstFromAbove = std::max(worstFromAbove, k == 0 ? error : 0.0);
          control = std::max(control, std::abs(above[c] - truths[k][c]) / brightest);
        }
      }
    }
  }
  std::cout << "irradiance by forms: " << worst << " of the brightest off, from above "
            << worstFromAbove << "; that from above for all " << control << std::endl;
  EXPECT_LT(worst, 0.06);
  EXPECT_GT(control, 0.4);
}

//------------------------------------------------------------------------------
// The sun's azimuth turns forms: they are those that are made for it, in a tenth of the time at most.
TEST(SkySource, FormsTurnWithTheSun)
{
  const auto get = [](Source* source, double azimuth, double* forms)
  {
    source->SetSunAzimuth(azimuth);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(source->GetIrradianceForms(forms));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  vtkNew<Source> source;
  source->SetSunElevation(20.0);
  double forms[48];
  const double making = get(source, 40.0, forms);
  double turning = making;
  for (const double azimuth : { 130.0, 201.0, 359.0, -75.0 })
  {
    turning = std::min(turning, get(source, azimuth, forms));
    vtkNew<Source> other;
    other->SetSunElevation(20.0);
    double made[48];
    get(other, azimuth, made);
    for (int i = 0; i < 48; ++i)
    {
      EXPECT_NEAR(forms[i], made[i], 1e-10 * std::abs(made[15])) << azimuth << " " << i;
    }
  }
  EXPECT_LT(turning, 0.1 * making);
  // Other changes count: of the sun's height, of the source and of the atmosphere.
  const auto differs = [&]
  {
    double changed[48];
    EXPECT_TRUE(source->GetIrradianceForms(changed));
    const bool is = !std::equal(changed, changed + 48, forms);
    std::copy_n(changed, 48, forms);
    return is;
  };
  EXPECT_FALSE(differs());
  source->SetSunElevation(21.0);
  EXPECT_TRUE(differs());
  source->SetObserverHeight(3000.0);
  EXPECT_TRUE(differs());
  source->GetAtmosphere()->SetGroundAlbedo(0.9, 0.9, 0.9);
  EXPECT_TRUE(differs());
}
