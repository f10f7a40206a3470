// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Taps of the depth: against closed forms, the ground truth, and the epipolar coverage, whose oracle
// they are; lights wherever the geometry is singular.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysDepthWeightedTapsIntegrator.h"
#include "vtkGodRaysEpipolarCoverageIntegrator.h"

#include "vtkCamera.h"

#include <algorithm>
#include <cmath>

using namespace GodRaysTesting;

namespace
{
class GodRaysDepthWeightedTaps : public MediumTest
{
protected:
  vtkNew<vtkGodRaysDepthWeightedTapsIntegrator> Integrator;

  GodRaysDepthWeightedTaps() { this->Rays->SetIntegrator(this->Integrator); }
};

double GetDifference(vtkImageData* image, vtkImageData* expected)
{
  double squares = 0.0;
  double peak = 0.0;
  const int* size = image->GetDimensions();
  for (int i = 0; i < 3 * size[0] * size[1]; ++i)
  {
    const int x = i / 3 % size[0];
    const int y = i / 3 / size[0];
    const double value = GetValue(expected, x, y, i % 3);
    squares += std::pow(GetValue(image, x, y, i % 3) - value, 2);
    peak = std::max(peak, value);
  }
  return std::sqrt(squares / (3.0 * size[0] * size[1])) / peak;
}
}

TEST_F(GodRaysDepthWeightedTaps, IsTheClosedFormWithoutOccluders)
{
  for (const Case& each : {
         Case{ "sun in front", { 0.3, 0.2, -1.0, 0.0 }, 1e-4 },
         Case{ "sun beside", { 1.0, 0.5, 0.0, 0.0 }, 1e-4 },
         Case{ "sun behind", { 0.2, -0.1, 1.0, 0.0 }, 1e-4 },
         Case{ "lamp in front", { 1.0, 0.5, -3.0, 1.0 }, 1e-4 },
         Case{ "lamp behind", { 0.5, 0.5, 13.0, 1.0 }, 1e-4 },
       })
  {
    const double error = this->GetError(each.Light);
    std::cout << each.Name << ": " << error << "\n";
    EXPECT_LT(error, each.Bound) << each.Name;
  }
  this->Model->SetScatteringCoefficient(0.05, 0.02, 0.2);
  this->Model->SetAbsorptionCoefficient(0.0, 0.01, 0.1);
  EXPECT_LT(this->GetError({ 0.3, 0.2, -1.0, 0.0 }), 1e-4);
}

TEST_F(GodRaysDepthWeightedTaps, IsTheGroundTruthWithOccluders)
{
  this->AddPillars();
  this->CheckErrors({
    { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.012 },
    { "edge", { 0.5, 0.2, -1.0, 0.0 }, 0.0065 },
    { "beside", { 1.0, 0.3, -0.1, 0.0 }, 0.0024 },
    { "behind", { 0.3, 0.4, 1.0, 0.0 }, 0.008 },
    { "lamp hidden in front", { 0.0, 0.5, -2.0, 1.0 }, 0.0077 },
    { "lamp beside", { 6.0, 1.0, 0.5, 1.0 }, 0.002 },
    { "lamp between", { 0.6, 3.5, 2.0, 1.0 }, 0.002 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.002 },
  });
}

TEST_F(GodRaysDepthWeightedTaps, NeedsTapsForThinThings)
{
  this->AddPillars();
  const std::array<double, 4> light{ 0.15, 0.1, -1.0, 0.0 };
  this->Integrator->SetNumberOfTaps(4);
  const double few = this->GetError(light);
  this->Integrator->SetNumberOfTaps(512);
  const double many = this->GetError(light);
  std::cout << "4 taps: " << few << ", 512: " << many << "\n";
  EXPECT_LT(many, 0.012);
  EXPECT_GT(few, 2.0 * many);
}

// Neither knows of the other: one marches in a shader, one sweeps lines on the processor.
TEST_F(GodRaysDepthWeightedTaps, IsTheOracleOfTheCoverage)
{
  this->AddPillars();
  this->Model->SetScatteringCoefficient(0.05, 0.03, 0.08);
  this->Integrator->SetNumberOfTaps(512);
  vtkNew<vtkGodRaysEpipolarCoverageIntegrator> coverage;
  for (const Case& each : {
         // pixels nearest to a line there, and of its own here
         Case{ "front", { 0.15, 0.1, -1.0, 0.0 }, 0.005 },
         Case{ "beside", { 1.0, 0.3, -0.1, 0.0 }, 0.001 },
         Case{ "across", { 1.0, 0.3, 0.0, 0.0 }, 0.001 },
         Case{ "behind", { 0.3, 0.4, 1.0, 0.0 }, 0.002 },
       })
  {
    for (const bool parallel : { false, true })
    {
      this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
      this->SetLight(each.Light);
      this->Rays->SetIntegrator(this->Integrator);
      auto taps = this->GetScattering();
      this->Rays->SetIntegrator(coverage);
      const double difference = GetDifference(this->GetScattering(), taps);
      std::cout << each.Name << (parallel ? ", parallel: " : ": ") << difference << "\n";
      EXPECT_LT(difference, each.Bound) << each.Name;
    }
  }
}

TEST_F(GodRaysDepthWeightedTaps, TakesAnyLight)
{
  this->AddPillars();
  const double tangent = std::tan(20.0 * std::acos(-1.0) / 180.0);
  const double x = (2.0 * 100.5 / Width - 1.0) * tangent * Width / Height;
  const double y = (2.0 * 90.5 / Height - 1.0) * tangent;
  for (const bool parallel : { false, true })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
    for (const std::array<double, 4>& light : {
           std::array<double, 4>{ x, y, -1.0, 0.0 }, // in the centre of a pixel
           { -x, -y, 1.0, 0.0 },
           { 0.0, 0.0, -1.0, 0.0 },
           { 0.0, 0.0, 1.0, 0.0 },
           { 1.0, 0.0, 0.0, 0.0 },
           { 0.0, 1.0, 1e-7, 0.0 },
           { 0.0, 1.0, -1e-7, 0.0 },
           { 3.0 * x, 3.0 * y, 7.0, 1.0 }, // the same for a lamp, before and behind the pillars
           { 12.0 * x, 12.0 * y, -2.0, 1.0 },
           { 0.0, 1.0, 10.0, 1.0 },
           { 0.0, 0.0, 10.0, 1.0 },
         })
    {
      this->SetLight(light);
      auto image = this->GetScattering();
      double least = 1.0;
      double most = 0.0;
      for (int i = 0; i < Width * Height; ++i)
      {
        const double value = GetValue(image, i % Width, i / Width);
        least = std::isfinite(value) ? std::min(least, value) : -1.0;
        most = std::max(most, value);
      }
      EXPECT_GE(least, 0.0) << light[0] << " " << light[1] << " " << light[2];
      EXPECT_GT(most, 1e-3) << light[0] << " " << light[1] << " " << light[2];
      EXPECT_LT(most, 1e20) << light[0] << " " << light[1] << " " << light[2];
    }
  }
}

TEST_F(GodRaysDepthWeightedTaps, SeesPropsThatAreIgnoredButCastNoShadow)
{
  this->SetLight({ 0.5, 0.3, -1.0, 0.0 });
  auto wall = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(wall);
  auto blocking = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::IGNORED);
  auto ignored = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::AUTOMATIC);
  wall->VisibilityOff();
  auto empty = this->GetScattering();
  const int onWall[2] = { 140, 108 };
  const int inShadow[2] = { 80, 80 };
  EXPECT_LT(GetValue(ignored, onWall[0], onWall[1]), 0.7 * GetValue(empty, onWall[0], onWall[1]));
  EXPECT_NEAR(
    GetValue(ignored, inShadow[0], inShadow[1]), GetValue(empty, inShadow[0], inShadow[1]), 1e-6);
  EXPECT_LT(
    GetValue(blocking, inShadow[0], inShadow[1]), 0.98 * GetValue(empty, inShadow[0], inShadow[1]));
}
