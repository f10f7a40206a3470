// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Lamps in the air over a planet, of which there is nothing but its ground: where view rays meet it they end,
// what is behind it is dark, and nothing shines out of it. Random scenes against the ground truth;
// GODRAYS_LONG takes more.

#include "GodRaysAirlight.h"
#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

using namespace GodRaysFiltersTesting;
using namespace GodRaysMediumScenes;
using vtkGodRays::Vec3;

namespace
{
constexpr int Columns = 32;
constexpr int Rows = 24;

struct PlanetScene
{
  bool Parallel;
  double Radius; // of the planet
  double Eye;    // height
  double Lamp;   // height
  double Way;    // from the eye to the lamp, over the ground
  double Turn;   // of the lamp to the right [degrees]
  double Pitch;  // of the view, upwards [degrees]
  double Far;
  double Scale; // height in which the air thins by 1/e
  double Gas;   // of the other component, which is everywhere alike
};

// The view is along -z, and y is up in the picture.
void SetScene(const PlanetScene& scene, vtkGodRaysMediumFilter* filter)
{
  const double pitch = vtkMath::RadiansFromDegrees(scene.Pitch);
  const double turn = vtkMath::RadiansFromDegrees(scene.Turn);
  const Vec3 up(0.0, std::cos(pitch), -std::sin(pitch));
  const Vec3 level(0.0, std::sin(pitch), std::cos(pitch)); // backwards
  // The lamp stands over a place of the ground that is so far from that below the eye.
  const double angle = scene.Way / scene.Radius;
  const double distance = scene.Radius + scene.Lamp;
  const Vec3 ahead = std::sin(turn) * Vec3(1.0, 0.0, 0.0) - std::cos(turn) * level;
  const Vec3 light =
    distance * (std::cos(angle) * up + std::sin(angle) * ahead) - (scene.Radius + scene.Eye) * up;
  filter->SetFarLimit(scene.Far);
  filter->SetViewAngle(60.0);
  filter->SetParallelProjection(scene.Parallel);
  filter->SetParallelScale(0.5 * scene.Eye); // no ray begins in the ground
  filter->SetMediumUp(up.x, up.y, up.z);
  filter->SetGroundLevel(-scene.Eye);
  filter->SetPlanetRadius(scene.Radius);
  filter->SetScaleHeight(scene.Scale);
  const double b = 1.0 / scene.Far;
  filter->SetScatteringCoefficient(b, b, b);
  filter->SetAsymmetry(0.3);
  filter->SetGasScatteringCoefficient(scene.Gas * b, scene.Gas * b, scene.Gas * b);
  filter->SetGasScaleHeight(0.0);
  filter->SetLight(light.x, light.y, light.z, 1.0);
}

void SetTruth(const PlanetScene& scene, vtkGodRaysSingleScatteringReference* reference)
{
  SetScene(scene, reference);
  reference->SetSize(Columns, Rows);
  reference->SetTolerance(1e-4);
  reference->Update();
}

// The brightest pixel, in which the lamp may be: there the truth is of a ray through the pixel's centre, what
// is drawn the mean over the pixel.
vtkIdType FindBrightest(vtkImageData* truth)
{
  vtkDataArray* values = truth->GetPointData()->GetArray("Radiance");
  vtkIdType brightest = 0;
  for (vtkIdType i = 1; i < values->GetNumberOfTuples(); ++i)
  {
    brightest = values->GetComponent(i, 0) > values->GetComponent(brightest, 0) ? i : brightest;
  }
  return brightest;
}
}

//------------------------------------------------------------------------------
TEST(PlanetLamps, BelowTheGroundGiveNoLight)
{
  for (const bool parallel : { false, true })
  {
    const PlanetScene scene = { parallel, 6.36e4, 4.7, -0.34, 6.0, 5.0, -22.0, 30.0, 4.6, 0.2 };
    vtkNew<Airlight> airlight;
    SetScene(scene, airlight);
    vtkNew<vtkGodRaysSingleScatteringReference> reference;
    SetTruth(scene, reference);
    const Picture ends = MakePicture(Columns, Rows, [&](int, int) { return scene.Far; });
    EXPECT_EQ(reference->GetOutput()->GetPointData()->GetArray("Radiance")->GetRange(0)[1], 0.0);
    EXPECT_EQ(airlight->Draw(ends).GetMaximum(), 0.0) << airlight->Describe();
    // The control: a plane hides nothing.
    airlight->SetPlanetRadius(0.0);
    EXPECT_GT(airlight->Draw(ends).GetMaximum(), 1e-4);
  }
}

//------------------------------------------------------------------------------
TEST(PlanetLamps, ShineOnWhatTheirHorizonDoesNotHide)
{
  const unsigned int seed =
    std::getenv("GODRAYS_SEED") ? std::atoi(std::getenv("GODRAYS_SEED")) : 1;
  const int scenes = std::getenv("GODRAYS_LONG") ? 120 : 8;
  Random random{ std::mt19937(seed) };
  Error worst;
  for (int i = 0; i < scenes; ++i)
  {
    PlanetScene scene;
    scene.Parallel = i % 3 == 2;
    scene.Radius = random.Log(5.0, 1e5);
    // Lengths are those to the horizon of something so high.
    const double height = random.Log(1e-3, 0.3) * scene.Radius;
    const double reach = std::sqrt(2.0 * height * scene.Radius);
    scene.Eye = height * random.Log(0.2, 3.0);
    scene.Lamp = height * random.Log(0.05, 2.0);
    scene.Way = reach * random.Uniform(0.1, 1.5);
    scene.Turn = random.Uniform(-60.0, 60.0);
    scene.Pitch = random.Uniform(-30.0, 20.0);
    scene.Far = reach * random.Uniform(1.5, 4.0);
    scene.Scale = height * random.Log(0.5, 5.0);
    scene.Gas = i % 2 ? 0.0 : 0.3;
    vtkNew<Airlight> airlight;
    SetScene(scene, airlight);
    vtkNew<vtkGodRaysSingleScatteringReference> reference;
    SetTruth(scene, reference);
    const vtkIdType left = FindBrightest(reference->GetOutput());
    const Error error = Compare(reference->GetOutput(), airlight, left);
    const std::string plan = airlight->Describe();
    airlight->SetPlanetRadius(0.0); // the control: a plane ends no ray, and hides nothing
    const Error plane = Compare(reference->GetOutput(), airlight, left);
    std::cout << i << ": " << error.Rms << ", at most " << error.Largest << ", a plane "
              << plane.Rms << ", radius " << scene.Radius << ", heights " << scene.Eye << " and "
              << scene.Lamp << " and " << scene.Scale << ", way " << scene.Way << "\n";
    EXPECT_LE(error.Rms, 4e-3) << i << ": " << plan;
    EXPECT_LE(error.Largest, 0.015) << i << ": " << plan; // next to the light
    EXPECT_GT(plane.Rms, 3.0 * error.Rms) << i << ": " << plan;
    worst.Rms = std::max(worst.Rms, error.Rms);
    worst.Largest = std::max(worst.Largest, error.Largest);
  }
  std::cout << "seed " << seed << ": worst root mean square " << worst.Rms << ", largest "
            << worst.Largest << "\n";
}
