// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadow maps that view rays walk through on the processor, against the ground truth, and against steps.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"

#include <algorithm>

using namespace GodRaysTesting;

namespace
{
class GodRaysShadowMapWalk : public MediumTest
{
protected:
  vtkNew<vtkGodRaysShadowMapIntegrator> Integrator;

  GodRaysShadowMapWalk()
  {
    this->Integrator->SetBackend(vtkGodRaysIntegrator::PROCESSOR);
    this->Integrator->SetMapSize(1024);
    this->Rays->SetIntegrator(this->Integrator);
    this->Rays->SetErrorTolerance(1e-4);
  }

  bool IsWalked() { return Says(this->Rays->GetPlan(), "walked on the processor"); }
};
}

TEST_F(GodRaysShadowMapWalk, IsTheClosedFormWithoutShadows)
{
  EXPECT_LT(this->GetError({ 0.3, 0.2, -1.0, 0.0 }), 1e-4);
  // a thing that casts no shadow into the picture
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -25.0 }, { 200.0, 200.0, 0.1 }));
  EXPECT_LT(this->GetError({ 0.0, 0.2, 1.0, 0.0 }), 1e-4);
  EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
}

TEST_F(GodRaysShadowMapWalk, IsTheGroundTruthWithOccluders)
{
  this->AddPillars();
  this->CheckErrors({
    { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.003 },
    { "edge", { 0.5, 0.2, -1.0, 0.0 }, 0.0006 },
    { "beside", { 1.0, 0.3, -0.1, 0.0 }, 0.0001 },
    { "behind", { 0.3, 0.4, 1.0, 0.0 }, 0.0008 },
  });
  EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
}

TEST_F(GodRaysShadowMapWalk, IsTheGroundTruthInThreeColours)
{
  this->AddPillars();
  this->Model->SetScatteringCoefficient(0.02, 0.05, 0.1);
  this->Model->SetAbsorptionCoefficient(0.0, 0.02, 0.3);
  this->CheckErrors({ { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.0025 } });
  EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
}

// The control: so coarse a map must fail.
TEST_F(GodRaysShadowMapWalk, IsAsGoodAsTheMap)
{
  this->AddPillars();
  const std::array<double, 4> light{ 0.3, 0.4, 1.0, 0.0 };
  const double walked = this->GetError(light);
  this->Integrator->SetMapSize(64);
  const double coarse = this->GetError(light);
  std::cout << "walked " << walked << ", in a map of 64 pixels " << coarse << "\n";
  EXPECT_GT(coarse, 1.6 * walked);
}

TEST_F(GodRaysShadowMapWalk, SeesWhatThePictureDoesNot)
{
  this->Renderer->AddActor(MakeBox({ 9.0, 0.5, 0.0 }, { 0.5, 2.0, 4.0 })); // outside
  const double outside = this->GetError({ 1.0, 0.1, 0.0, 0.0 });
  std::cout << "error " << outside << "\n";
  EXPECT_LT(outside, 0.005);
}

TEST_F(GodRaysShadowMapWalk, IsTheGroundTruthOfLamps)
{
  this->AddPillars();
  this->CheckErrors({
    { "lamp hidden in front", { 0.0, 0.5, -2.0, 1.0 }, 0.0023 },
    { "lamp beside", { 6.0, 1.0, 0.5, 1.0 }, 0.0002 },
    { "lamp between", { 0.6, 3.5, 2.0, 1.0 }, 0.00004 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.001 },
  });
  EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
}

// A spotlight 0.16 below the top of a closed slab that the camera looks down to: all before the slab is dark,
// also the pixels next to the light, where rays end shortly before it.
TEST_F(GodRaysShadowMapWalk, ASpotlightInAClosedThingIsDarkOutside)
{
  this->Renderer->GetActiveCamera()->SetPosition(2.96, 2.22, -6.22);
  this->Renderer->GetActiveCamera()->SetFocalPoint(0.23, -0.68, -1.19);
  this->Renderer->GetActiveCamera()->SetViewAngle(62.0);
  auto spot = MakeLamplight({ 1.32, -1.757, 2.376 });
  spot->SetFocalPoint(1.1, -1.13, 0.84);
  spot->SetConeAngle(22.6);
  this->Rays->AddLight(spot);
  this->Rays->SetErrorTolerance(1e-6);
  auto slab = MakeBox({ 0.0, -1.7, 0.0 }, { 60.0, 0.2, 60.0 });
  this->Renderer->AddActor(slab);
  const auto getLargest = [this]()
  {
    auto image = this->GetScattering();
    double largest = 0.0;
    for (int i = 0; i < Width * Height; ++i)
    {
      largest = std::max(largest, GetValue(image, i % Width, i / Width));
    }
    return largest;
  };
  for (const double exponent : { 0.0, 8.0 })
  {
    spot->SetExponent(exponent);
    slab->VisibilityOn();
    this->Renderer->ResetCameraClippingRange();
    const double closed = getLargest();
    EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
    slab->VisibilityOff();
    const double open = getLargest();
    std::cout << "exponent " << exponent << ": " << closed / open << " of what it is without\n";
    EXPECT_GT(open, 0.0);
    EXPECT_LE(closed, 1e-5 * open); // what single precision leaves
  }
}

TEST_F(GodRaysShadowMapWalk, IsTheGroundTruthInAParallelProjection)
{
  this->AddPillars();
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  this->CheckErrors({
    { "sun", { 0.5, 0.3, -1.0, 0.0 }, 0.0035 },
    { "sun behind", { 0.3, 0.4, 1.0, 0.0 }, 0.003 },
    { "lamp hidden in front", { 0.0, 0.5, -2.0, 1.0 }, 0.001 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.001 },
  });
  EXPECT_TRUE(this->IsWalked()) << this->Rays->GetPlan();
}

TEST_F(GodRaysShadowMapWalk, KeepsTheMapAndDrawsTheSameAgain)
{
  this->AddPillars();
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(box);
  this->AddSun({ 0.15, 0.1, -1.0 });
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "4 of 512")) << this->Rays->GetPlan();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), ", kept"));
  const auto before = GetPixels(this->Scene.Window);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept"));
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  box->SetPosition(0.3, 0.0, 0.0);
  const auto moved = GetPixels(this->Scene.Window);
  EXPECT_FALSE(Says(this->Rays->GetPlan(), ", kept"));
  EXPECT_GT(GetLargestDifference(before, moved), 2);
  this->Integrator->SetNumberOfNestedMaps(1);
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), ", kept"));
  this->Integrator->SetNumberOfNestedMaps(4);
  EXPECT_EQ(moved, GetPixels(this->Scene.Window));
  this->Scene.Window->Finalize();
  EXPECT_EQ(moved, GetPixels(this->Scene.Window));
}

// Two suns share what the walk has of the frame.
TEST_F(GodRaysShadowMapWalk, AddsLights)
{
  this->AddPillars();
  const std::array<double, 3> one{ 0.15, 0.1, -1.0 };
  const std::array<double, 3> other{ 0.5, 0.4, -1.0 };
  auto first = this->AddSun(one);
  auto alone = this->GetScattering();
  auto second = this->AddSun(other);
  auto both = this->GetScattering();
  first->SwitchOff();
  auto rest = this->GetScattering();
  for (const int x : { 40, 100, 180 })
  {
    const double sum = GetValue(alone, x, 80) + GetValue(rest, x, 80);
    EXPECT_NEAR(GetValue(both, x, 80), sum, 2e-3 * sum);
  }
  first->SwitchOn();
  this->Scene.Window->Render();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept")) << "each light has a map of its own";
}
