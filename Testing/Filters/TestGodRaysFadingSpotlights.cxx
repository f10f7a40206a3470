// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Spotlights that fade from slanted axes in air that thins out: no ray is lit as another one is, so that the
// table's slices go all about the light. Random scenes against the ground truth; GODRAYS_LONG takes more.

#include "GodRaysAirlight.h"
#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

using namespace GodRaysFiltersTesting;
using namespace GodRaysMediumScenes;
using vtkGodRays::Vec3;

namespace
{
// A spotlight that shines on some of what is seen, in air of a random kind.
void SetScene(Random random, vtkGodRaysMediumFilter* filter)
{
  const bool parallel = random.Uniform(0.0, 1.0) < 0.4;
  filter->SetFarLimit(random.Log(8.0, 40.0));
  filter->SetViewAngle(random.Uniform(25.0, 80.0));
  filter->SetParallelProjection(parallel);
  filter->SetParallelScale(random.Uniform(2.0, 6.0));
  const bool round = random.Uniform(0.0, 1.0) < 0.25; // over a planet, whose ground no ray meets
  const double height = round ? random.Log(8.0, 40.0) : random.Log(0.7, 20.0);
  const double eye = round ? 80.0 : random.Uniform(0.0, 3.0);
  const double b = random.Log(0.005, 0.15) * (round ? std::exp(eye / height) : 1.0);
  filter->SetScatteringCoefficient(b, b, b);
  filter->SetAsymmetry(random.Uniform(-0.5, 0.8));
  filter->SetScaleHeight(height);
  const double gas = random.Log(0.002, 0.05);
  filter->SetGasScatteringCoefficient(gas, gas, gas);
  filter->SetGasScaleHeight(random.Uniform(0.0, 1.0) < 0.5 || round ? 0.0 : random.Log(2.0, 20.0));
  const Vec3 up = random.Uniform(0.0, 1.0) < 0.5 ? Vec3(0.0, 1.0, 0.0) : random.Direction();
  filter->SetMediumUp(up.x, up.y, up.z);
  filter->SetGroundLevel(-eye);
  filter->SetPlanetRadius(round ? 500.0 : 0.0);
  // In the picture, beside it, behind the eye; towards somewhere before it.
  const Vec3 light = random.Log(2.0, 9.0) * random.Direction() +
    (random.Uniform(0.0, 1.0) < 0.5 ? Vec3(0.0, 0.0, -7.0) : Vec3(0.0));
  filter->SetLight(light.x, light.y, light.z, 1.0);
  const Vec3 target(
    random.Uniform(-2.0, 2.0), random.Uniform(-1.5, 1.5), -random.Uniform(4.0, 9.0));
  filter->SetSpotDirection(target.x - light.x, target.y - light.y, target.z - light.z);
  filter->SetConeAngle(random.Uniform(10.0, 50.0));
  filter->SetSpotExponent(random.Uniform(0.0, 1.0) < 0.5 ? 1.0 : random.Log(0.5, 60.0));
}
}

//------------------------------------------------------------------------------
TEST(FadingSpotlights, ShineInLayersAsTheIntegral)
{
  const unsigned int seed =
    std::getenv("GODRAYS_SEED") ? std::atoi(std::getenv("GODRAYS_SEED")) : 1;
  const int scenes = std::getenv("GODRAYS_LONG") ? 60 : 8;
  Error worst;
  for (int i = 0; i < scenes; ++i)
  {
    const Random random{ std::mt19937(1000 * seed + i) };
    vtkNew<vtkGodRaysSingleScatteringReference> reference;
    vtkNew<Airlight> airlight;
    SetScene(random, reference);
    SetScene(random, airlight);
    reference->SetSize(64, 36);
    reference->SetTolerance(1e-4);
    reference->Update();
    const auto start = std::chrono::steady_clock::now();
    const vtkIdType left = FindLight(reference, reference->GetSize());
    const Error error = Compare(reference->GetOutput(), airlight, left);
    const auto middle = std::chrono::steady_clock::now();
    const std::string plan = airlight->Describe();
    // The control: as if it did not fade.
    airlight->SetSpotExponent(0.0);
    const Error even = Compare(reference->GetOutput(), airlight, left);
    const std::chrono::duration<double> seconds = middle - start;
    const std::chrono::duration<double> evenSeconds = std::chrono::steady_clock::now() - middle;
    std::cout << i << ": " << error.Rms << ", at most " << error.Largest << ", even light "
              << even.Rms << ", " << 1e3 * seconds.count() << " ms, of which even light takes "
              << 1e3 * evenSeconds.count() << " ms, exponent " << reference->GetSpotExponent()
              << ", " << plan << "; " << airlight->Describe() << "\n";
    EXPECT_LE(error.Rms, 1e-3) << i << ": " << plan;
    EXPECT_LE(error.Largest, 0.01) << i << ": " << plan; // next to the light
    EXPECT_GT(even.Rms, 3.0 * error.Rms) << i << ": " << plan;
    worst.Rms = std::max(worst.Rms, error.Rms);
    worst.Largest = std::max(worst.Largest, error.Largest);
  }
  std::cout << "seed " << seed << ": worst root mean square " << worst.Rms << ", largest "
            << worst.Largest << "\n";
}
