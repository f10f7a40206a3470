// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The integrator that chooses: what it takes for which light, view and tolerance, and how far that is from
// the ground truth, with the picture's own depths as the control.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysAutomaticIntegrator.h"
#include "vtkGodRaysEpipolarCoverageIntegrator.h"

#include "vtkCamera.h"

using namespace GodRaysTesting;

namespace
{
class GodRaysAutomaticIntegrator : public MediumTest
{
protected:
  std::string GetPlan()
  {
    this->Scene.Window->Render();
    return this->Rays->GetPlan();
  }

  /// The error by default, and that of the picture's depths.
  void CheckAgainstDepths(const char* name, std::array<double, 4> light, double bound)
  {
    const double error = this->GetError(light);
    vtkNew<vtkGodRaysEpipolarCoverageIntegrator> coverage;
    this->Rays->SetIntegrator(coverage);
    const double ofDepths = this->GetError(light);
    this->Rays->SetIntegrator(nullptr);
    std::cout << name << ": " << error << ", by the picture's depths " << ofDepths << "\n";
    EXPECT_LT(error, bound) << name;
    EXPECT_GT(ofDepths, 4.0 * bound) << name;
  }
};
}

TEST_F(GodRaysAutomaticIntegrator, ChoosesByLightViewAndMedium)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "automatic: shadow map: 4 of 768")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "swept on the processor"));
  this->SetLight({ 0.0, 0.5, -2.0, 1.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "6 of 1024")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "swept on the processor"));
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  EXPECT_TRUE(Says(this->GetPlan(), "automatic: epipolar coverage")) << this->Rays->GetPlan();
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
  vtkNew<vtkGodRaysAtmosphereModel> air;
  this->Rays->SetModel(air);
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "layered medium")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "4 of 768"));
  air->SetPlanetRadius(6.36e6);
  EXPECT_TRUE(Says(this->GetPlan(), "32 steps a pixel")) << this->Rays->GetPlan();
}

TEST_F(GodRaysAutomaticIntegrator, TakesMapsByTheTolerance)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  for (const auto& [tolerance, words] : { std::pair<double, const char*>{ 1.0 / 32.0, "4 of 256" },
         { 1.0 / 64.0, "4 of 256" }, { 1.0 / 128.0, "4 of 384" }, { 1.0 / 255.0, "4 of 768" },
         { 1.0 / 512.0, "4 of 1536" }, { 1e-6, "4 of 2048" } })
  {
    this->Rays->SetErrorTolerance(tolerance);
    EXPECT_TRUE(Says(this->GetPlan(), words)) << tolerance << "\n" << this->Rays->GetPlan();
  }
}

// While the camera is dragged one map serves; the still picture is the same every time.
TEST_F(GodRaysAutomaticIntegrator, KeepsTheMapWhileTheCameraIsDragged)
{
  this->AddPillars();
  for (const std::array<double, 4>& light :
    { std::array<double, 4>{ 0.15, 0.1, -1.0, 0.0 }, { 0.0, 0.5, -2.0, 1.0 } })
  {
    this->SetLight(light);
    const auto still = GetPixels(this->Scene.Window);
    this->Scene.Window->SetDesiredUpdateRate(15.0);
    this->Scene.Window->Render();
    for (int frame = 0; frame < 3; ++frame)
    {
      this->Renderer->GetActiveCamera()->Azimuth(1.0);
      EXPECT_TRUE(Says(this->GetPlan(), " of 1024 x 1024")) << this->Rays->GetPlan();
      EXPECT_TRUE(Says(this->GetPlan(), ", kept, "));
    }
    this->Renderer->GetActiveCamera()->Azimuth(-3.0);
    this->Scene.Window->SetDesiredUpdateRate(0.0001);
    EXPECT_LE(GetLargestDifference(still, GetPixels(this->Scene.Window)), 1);
  }
}

// A roof on columns over the eye, the sun behind it: most of what casts a shadow is not in the picture.
TEST_F(GodRaysAutomaticIntegrator, SeesARoofAndColumnsBehindTheEye)
{
  this->Renderer->AddActor(MakeBox({ 0.0, 2.6, 4.0 }, { 8.0, 0.2, 18.0 }));
  for (const double z : { -4.0, -1.0, 2.0, 5.0, 8.0, 11.0 })
  {
    this->Renderer->AddActor(MakeBox({ -2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
    this->Renderer->AddActor(MakeBox({ 2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
  }
  this->CheckAgainstDepths("sun behind the eye", { 1.0, 0.5, 0.6, 0.0 }, 0.004);
}

// In so small a picture the lines of the sweep, 2 pixels apart, decide the error, not the map.
TEST_F(GodRaysAutomaticIntegrator, SeesWhatStandsBesideThePicture)
{
  for (const double y : { -1.5, 0.0, 1.5 })
  {
    this->Renderer->AddActor(MakeBox({ 7.0, y, 1.0 }, { 0.4, 0.6, 6.0 }));
  }
  this->CheckAgainstDepths("sun beside", { 1.0, 0.1, -0.2, 0.0 }, 0.003);
  this->CheckAgainstDepths("lamp beside", { 11.0, 0.5, 1.0, 1.0 }, 0.005);
}

TEST_F(GodRaysAutomaticIntegrator, IsTheClosedFormWhereNoShadowCanBeSeen)
{
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -25.0 }, { 200.0, 200.0, 0.1 }));
  EXPECT_LT(this->GetError({ 0.0, 0.2, 1.0, 0.0 }), 1e-4);
}
