// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sun: its frames, date and place, its light, who shares it, and bad input.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysSkySource.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysSunPosition.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>

using namespace GodRaysFiltersTesting;
using Sun = vtkGodRaysSun;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void ExpectNear(const double actual[3], double x, double y, double z)
{
  EXPECT_NEAR(actual[0], x, 1e-12);
  EXPECT_NEAR(actual[1], y, 1e-12);
  EXPECT_NEAR(actual[2], z, 1e-12);
}

void SetAngles(Sun* sun, double azimuth, double elevation)
{
  sun->SetAzimuth(azimuth);
  sun->SetElevation(elevation);
}
}

//------------------------------------------------------------------------------
TEST(Sun, StandsInItsFrame)
{
  struct Row
  {
    int Frame;
    double Up[3];
    double North[3];
    double East[3];
  };
  const Row rows[] = { { Sun::CAMERA, { 0, 1, 0 }, { 0, 0, -1 }, { 1, 0, 0 } },
    { Sun::X_UP, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } },
    { Sun::Y_UP, { 0, 1, 0 }, { 0, 0, -1 }, { 1, 0, 0 } },
    { Sun::Z_UP, { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 } },
    { Sun::UP_AND_NORTH, { 0, 0, -1 }, { 0, -1, 0 }, { 1, 0, 0 } } };
  vtkNew<Sun> sun;
  sun->SetUp(0.0, 0.0, -5.0);
  sun->SetNorth(0.0, -2.0, 7.0); // its horizontal part counts
  for (const Row& row : rows)
  {
    sun->SetFrame(row.Frame);
    double direction[3];
    SetAngles(sun, 0.0, 0.0);
    ASSERT_TRUE(sun->GetDirection(nullptr, direction));
    ExpectNear(direction, row.North[0], row.North[1], row.North[2]);
    SetAngles(sun, 90.0 + 720.0, 0.0);
    ASSERT_TRUE(sun->GetDirection(nullptr, direction));
    ExpectNear(direction, row.East[0], row.East[1], row.East[2]);
    SetAngles(sun, 33.0, 90.0);
    ASSERT_TRUE(sun->GetDirection(nullptr, direction));
    ExpectNear(direction, row.Up[0], row.Up[1], row.Up[2]);
  }
}

//------------------------------------------------------------------------------
TEST(Sun, FollowsTheCameraInItsFrameAlone)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(5.0, 1.0, 2.0);
  camera->SetFocalPoint(9.0, 1.0, 2.0);
  camera->SetViewUp(0.0, 0.6, 0.8);
  vtkNew<Sun> sun;
  double direction[3];
  SetAngles(sun, 0.0, 30.0);
  ASSERT_TRUE(sun->GetDirection(camera, direction));
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(30.0));
  ExpectNear(direction, cosine, 0.3, 0.4);

  // The light that it makes lies there, by VTK's transform of a camera light.
  vtkNew<vtkLight> light;
  ASSERT_TRUE(sun->UpdateLight(light));
  EXPECT_TRUE(light->LightTypeIsCameraLight());
  light->SetTransformMatrix(camera->GetCameraLightTransformMatrix());
  double position[3], focus[3], towards[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focus);
  vtkMath::Subtract(position, focus, towards);
  vtkMath::Normalize(towards);
  ExpectNear(towards, direction[0], direction[1], direction[2]);

  sun->SetFrame(Sun::Z_UP);
  ASSERT_TRUE(sun->GetDirection(camera, direction));
  ExpectNear(direction, 0.0, cosine, 0.5);
}

//------------------------------------------------------------------------------
TEST(Sun, IsPutInADirection)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(5.0, 1.0, 2.0);
  camera->SetFocalPoint(9.0, 2.0, 2.0);
  camera->SetViewUp(0.0, 0.6, 0.8);
  vtkNew<Sun> sun;
  sun->SetUp(0.1, 0.2, 3.0);
  sun->SetNorth(1.0, 2.0, 0.5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int frame = Sun::CAMERA; frame <= Sun::UP_AND_NORTH; ++frame)
  {
    sun->SetFrame(frame);
    for (const auto& wanted : { std::array<double, 3>{ 0.3, -0.5, 0.2 }, { -3.0, 0.1, 0.0 },
           { 0.0, 0.0, 1.0 }, { 1e-8, 0.0, -2e-8 } })
    {
      sun->SetPosition(Sun::DATE_AND_PLACE);
      ASSERT_TRUE(sun->MoveTo(camera, wanted.data())) << frame;
      EXPECT_EQ(sun->GetPosition(), Sun::AZIMUTH_AND_ELEVATION);
      EXPECT_EQ(sun->GetFrame(), frame);
      double direction[3];
      ASSERT_TRUE(sun->GetDirection(camera, direction));
      const double length = vtkMath::Norm(wanted.data());
      ExpectNear(direction, wanted[0] / length, wanted[1] / length, wanted[2] / length);
    }
    const double azimuth = sun->GetAzimuth();
    for (const auto& wrong : { std::array<double, 3>{ 0.0, 0.0, 0.0 }, { nan, 0.0, 1.0 } })
    {
      EXPECT_FALSE(sun->MoveTo(camera, wrong.data()));
      EXPECT_EQ(sun->GetAzimuth(), azimuth);
    }
  }
  sun->SetNorth(0.1, 0.2, 3.0);
  const double up[3] = { 0.0, 0.0, 1.0 };
  EXPECT_FALSE(sun->MoveTo(camera, up));
}

//------------------------------------------------------------------------------
TEST(Sun, StandsWhereItsEphemerisSays)
{
  vtkNew<vtkGodRaysSunPosition> expected;
  vtkNew<Sun> sun;
  SetAngles(sun, 3.0, -4.0);
  for (vtkGodRaysSunPosition* each : { expected.Get(), sun->GetEphemeris() })
  {
    EXPECT_TRUE(each->SetDateTime("2024-06-21T19:30:00+02:00"));
    each->SetLatitude(48.137);
    each->SetLongitude(11.575);
  }
  EXPECT_EQ(sun->GetAngles()[0], 3.0);
  EXPECT_EQ(sun->GetAngles()[1], -4.0);
  EXPECT_FALSE(sun->IsAboveHorizon());
  EXPECT_TRUE(sun->Shines()) << "from below a scene";

  sun->SetPosition(Sun::DATE_AND_PLACE);
  EXPECT_EQ(sun->GetAngles()[0], expected->GetAzimuth());
  EXPECT_EQ(sun->GetAngles()[1], expected->GetElevation());
  sun->SetFrame(Sun::Y_UP);
  const double up[3] = { 0.0, 1.0, 0.0 };
  const double north[3] = { 0.0, 0.0, -1.0 };
  double direction[3], truth[3];
  ASSERT_TRUE(sun->GetDirection(nullptr, direction));
  ASSERT_TRUE(expected->GetDirection(up, north, truth));
  ExpectNear(direction, truth[0], truth[1], truth[2]);
  EXPECT_TRUE(sun->Shines());

  const vtkMTimeType time = sun->GetMTime();
  sun->GetEphemeris()->SetTimeOfDay(23.0);
  EXPECT_GT(sun->GetMTime(), time);
  EXPECT_FALSE(sun->IsAboveHorizon());
  EXPECT_FALSE(sun->Shines());

  sun->SetEphemeris(expected);
  EXPECT_EQ(sun->GetEphemeris(), expected);
  EXPECT_TRUE(sun->Shines());
  sun->SetEphemeris(nullptr);
  ASSERT_NE(sun->GetEphemeris(), nullptr);
  EXPECT_EQ(sun->GetEphemeris()->GetYear(), 2000);
}

//------------------------------------------------------------------------------
TEST(Sun, IsUpWhileItsLimbIs)
{
  vtkNew<Sun> sun;
  sun->SetElevation(-0.25);
  EXPECT_TRUE(sun->IsAboveHorizon());
  sun->SetAngularRadius(0.2);
  EXPECT_FALSE(sun->IsAboveHorizon());
}

//------------------------------------------------------------------------------
TEST(Sun, MakesALightItsOwn)
{
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetIntensity(3.0);
  light->SetFocalPoint(4.0, 5.0, 6.0);
  vtkNew<vtkTransform> moved;
  moved->Translate(1.0, 2.0, 3.0);
  light->SetTransformMatrix(moved->GetMatrix());
  vtkNew<Sun> sun;
  sun->SetFrame(Sun::Z_UP);
  SetAngles(sun, 90.0, 0.0);
  sun->SetColor(1.0, 0.5, 0.25);
  ASSERT_TRUE(sun->UpdateLight(light));
  EXPECT_TRUE(light->LightTypeIsSceneLight());
  EXPECT_FALSE(light->GetPositional());
  EXPECT_EQ(light->GetIntensity(), 1.0);
  double position[3], focus[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focus);
  ExpectNear(position, 1.0, 0.0, 0.0);
  ExpectNear(focus, 0.0, 0.0, 0.0);
  ExpectNear(light->GetDiffuseColor(), 1.0, 0.5, 0.25);

  const ErrorListener errors(sun);
  EXPECT_FALSE(sun->UpdateLight(nullptr));
  EXPECT_EQ(errors.Texts.size(), 1u);
}

//------------------------------------------------------------------------------
TEST(Sun, IsSharedBySkies)
{
  vtkNew<Sun> sun;
  SetAngles(sun, 120.0, 20.0);
  vtkNew<vtkGodRaysSkySource> first, second;
  EXPECT_EQ(first->GetSunElevation(), 45.0);
  EXPECT_EQ(first->GetSunAzimuth(), 180.0);
  first->SetSun(sun);
  second->SetSun(sun);
  const vtkMTimeType time = second->GetMTime();
  first->SetSunElevation(5.0);
  EXPECT_EQ(sun->GetElevation(), 5.0);
  EXPECT_EQ(second->GetSunElevation(), 5.0);
  EXPECT_GT(second->GetMTime(), time);

  // By date and place the source follows the ephemeris, whatever the angles are.
  double low[3], high[3];
  ASSERT_TRUE(first->GetSunLight(low));
  sun->SetPosition(Sun::DATE_AND_PLACE); // at noon in the tropics
  ASSERT_TRUE(first->GetSunLight(high));
  EXPECT_GT(high[2], 1.5 * low[2]);

  first->SetSun(nullptr);
  EXPECT_NE(first->GetSun(), sun);
  EXPECT_EQ(first->GetSunElevation(), 45.0);
}

//------------------------------------------------------------------------------
TEST(Sun, AnAngleOfASkyOverrulesDateAndPlace)
{
  vtkNew<vtkGodRaysSkySource> sky;
  sky->GetSun()->SetPosition(vtkGodRaysSun::DATE_AND_PLACE);
  sky->SetSunElevation(33.0);
  EXPECT_EQ(sky->GetSun()->GetAngles()[1], 33.0);
  sky->GetSun()->SetPosition(vtkGodRaysSun::DATE_AND_PLACE);
  sky->SetSunAzimuth(44.0);
  EXPECT_EQ(sky->GetSun()->GetAngles()[0], 44.0);
}

//------------------------------------------------------------------------------
// A disc of three times the radius has nine times the pixels; from farther away it is smaller.
TEST(Sun, HasADiscOfItsRadius)
{
  vtkNew<vtkGodRaysSkySource> sky;
  sky->SetMapping(vtkGodRaysSkySource::FISHEYE);
  sky->SetResolution(128);
  sky->SetTolerance(0.1);
  sky->SetSunElevation(70.0);
  sky->SunDiscOn();
  const auto count = [&sky](double radius, double distance)
  {
    sky->GetSun()->SetAngularRadius(radius);
    sky->GetAtmosphere()->SetSunDistance(distance);
    sky->Update();
    const double solidAngle =
      2.0 * vtkMath::Pi() * (1.0 - std::cos(vtkMath::RadiansFromDegrees(radius / distance)));
    const double half =
      0.4 * sky->GetAtmosphere()->GetSunIrradiance()[1] / solidAngle; // in the air
    int found = 0;
    for (int i = 0; i < 128 * 128; ++i)
    {
      found += sky->GetOutput()->GetScalarComponentAsDouble(i % 128, i / 128, 0, 1) > half;
    }
    return found;
  };
  const double area = count(5.0, 1.0); // of 0.5 pixels a square degree
  EXPECT_NEAR(area, 0.5 * vtkMath::Pi() * 25.0, 6.0);
  EXPECT_NEAR(count(15.0, 1.0) / area, 9.0, 0.9);
  EXPECT_EQ(count(15.0, 3.0), area);
}

//------------------------------------------------------------------------------
TEST(Sun, SaysWhatIsWrong)
{
  vtkNew<Sun> sun;
  ErrorListener errors(sun);
  const vtkMTimeType time = sun->GetMTime();
  sun->SetFrame(5);
  sun->SetPosition(-1);
  sun->SetAzimuth(NaN);
  sun->SetElevation(NaN);
  sun->SetAngularRadius(std::numeric_limits<double>::infinity());
  sun->SetUp(0.0, NaN, 0.0);
  sun->SetNorth(0.0, NaN, 0.0);
  sun->SetColor(NaN, 0.0, 0.0);
  EXPECT_EQ(errors.Texts.size(), 8u);
  EXPECT_EQ(sun->GetMTime(), time);
  sun->SetElevation(91.0);
  EXPECT_EQ(sun->GetElevation(), 90.0);
  sun->SetAngularRadius(0.0);
  EXPECT_EQ(sun->GetAngularRadius(), 0.01);
  sun->SetColor(2.0, -1.0, 0.5);
  ExpectNear(sun->GetColor(), 1.0, 0.0, 0.5);

  // Up and north that are parallel or 0: told once
  sun->SetFrame(Sun::UP_AND_NORTH);
  vtkNew<vtkLight> light;
  for (const double north : { 3.0, 0.0 })
  {
    errors.Texts.clear();
    sun->SetNorth(0.0, 0.0, north);
    double direction[3];
    EXPECT_FALSE(sun->GetDirection(nullptr, direction));
    EXPECT_FALSE(sun->GetDirection(nullptr, direction));
    EXPECT_FALSE(sun->UpdateLight(light));
    ASSERT_EQ(errors.Texts.size(), 1u);
    EXPECT_NE(errors.Texts[0].find("parallel"), std::string::npos);
  }
}

//------------------------------------------------------------------------------
TEST(Sun, AnglesAndDirectionsAreInverse)
{
  const double up[3] = { 0.0, 2.0, 0.0 };
  const double north[3] = { 2.0, 1.0, 0.0 };
  for (const double azimuth : { 0.0, 80.0, -100.0, 170.0 })
  {
    for (const double elevation : { -10.0, 0.0, 40.0, 89.0 })
    {
      double direction[3], angles[2];
      ASSERT_TRUE(
        vtkGodRaysSunPosition::ComputeDirection(azimuth, elevation, up, north, direction));
      vtkMath::MultiplyScalar(direction, 7.0);
      ASSERT_TRUE(vtkGodRaysSunPosition::ComputeAngles(direction, up, north, angles));
      EXPECT_NEAR(angles[0], azimuth, 1e-9);
      EXPECT_NEAR(angles[1], elevation, 1e-9);
    }
  }
  double angles[2] = { 1.0, 1.0 };
  EXPECT_FALSE(vtkGodRaysSunPosition::ComputeAngles(up, up, up, angles));
  EXPECT_EQ(angles[0], 0.0);
  EXPECT_EQ(angles[1], 0.0);
}
