// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadow maps: against closed forms and the ground truth, with things that the picture's depth does
// not hold; and that the scene does not notice them.

#include "GodRaysLonelyCompositor.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkCamera.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <cmath>

using namespace GodRaysTesting;

namespace
{
class GodRaysShadowMap : public MediumTest
{
protected:
  vtkNew<vtkGodRaysShadowMapIntegrator> Integrator;

  GodRaysShadowMap() { this->Rays->SetIntegrator(this->Integrator); }
};
}

TEST_F(GodRaysShadowMap, IsTheClosedFormWithoutShadowsWhateverTheSteps)
{
  this->Integrator->SetNumberOfSteps(1);
  for (const Case& each : {
         Case{ "sun in front", { 0.3, 0.2, -1.0, 0.0 }, 1e-4 },
         Case{ "sun beside", { 1.0, 0.5, 0.0, 0.0 }, 1e-4 },
         Case{ "lamp in front", { 1.0, 0.5, -3.0, 1.0 }, 1e-4 },
         Case{ "lamp behind", { 0.5, 0.5, 13.0, 1.0 }, 1e-4 },
       })
  {
    EXPECT_LT(this->GetError(each.Light), each.Bound) << each.Name;
  }
  // a thing that casts no shadow into the picture
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -25.0 }, { 200.0, 200.0, 0.1 }));
  EXPECT_LT(this->GetError({ 0.0, 0.2, 1.0, 0.0 }), 1e-4);
}

TEST_F(GodRaysShadowMap, IsTheGroundTruthWithOccluders)
{
  this->AddPillars();
  this->CheckErrors({
    { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.0067 },
    { "edge", { 0.5, 0.2, -1.0, 0.0 }, 0.0027 },
    { "beside", { 1.0, 0.3, -0.1, 0.0 }, 0.0009 },
    { "behind", { 0.3, 0.4, 1.0, 0.0 }, 0.0063 },
    { "lamp hidden in front", { 0.0, 0.5, -2.0, 1.0 }, 0.0023 },
    { "lamp beside", { 6.0, 1.0, 0.5, 1.0 }, 0.0002 },
    { "lamp between", { 0.6, 3.5, 2.0, 1.0 }, 0.00004 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.001 },
  });
}

// Each colour is extinguished in its own way, so that shadows weigh differently.
TEST_F(GodRaysShadowMap, IsTheGroundTruthInThreeColours)
{
  this->AddPillars();
  this->Model->SetScatteringCoefficient(0.02, 0.05, 0.1);
  this->Model->SetAbsorptionCoefficient(0.0, 0.02, 0.3);
  this->CheckErrors({ { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.0067 } });
}

TEST_F(GodRaysShadowMap, NeedsStepsAndPixels)
{
  this->AddPillars();
  const std::array<double, 4> light{ 0.15, 0.1, -1.0, 0.0 };
  this->Integrator->SetNumberOfSteps(4);
  const double few = this->GetError(light);
  this->Integrator->SetNumberOfSteps(256);
  const double many = this->GetError(light);
  this->Integrator->SetMapSize(64);
  const double coarse = this->GetError(light);
  std::cout << "4 steps: " << few << ", 256: " << many << ", in a map of 64 pixels: " << coarse
            << "\n";
  EXPECT_LT(many, 0.0064); // the 5 x 5 pixels of the mean are much in so small a picture
  EXPECT_GT(few, 1.3 * many);
  EXPECT_GT(coarse, 1.6 * many);
}

// Beside the picture, and behind what is seen. The control is the picture that lacks them.
TEST_F(GodRaysShadowMap, SeesWhatThePictureDoesNot)
{
  const auto check = [this](const char* name, vtkActor* unseen, std::array<double, 4> light)
  {
    this->Renderer->AddActor(unseen);
    const double error = this->GetError(light);
    this->Renderer->RemoveActor(unseen);
    auto lacking = this->GetScattering();
    this->Renderer->AddActor(unseen);
    const double without = GetErrorOfMedium(this->Renderer, this->Model, light, lacking);
    std::cout << name << ": " << error << ", without it " << without << "\n";
    EXPECT_LT(error, 0.01) << name;
    EXPECT_GT(without, 5.0 * error) << name;
  };
  check("outside", MakeBox({ 9.0, 0.5, 0.0 }, { 0.5, 2.0, 4.0 }), { 1.0, 0.1, 0.0, 0.0 });
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddActor(MakeBox({ -1.0, 0.0, 3.0 }, { 2.0, 2.0, 0.1 }));
  check("hidden", MakeBox({ -1.5, 0.0, -1.0 }, { 2.0, 2.0, 1.0 }), { -0.6, 0.2, -1.0, 0.0 });
}

TEST_F(GodRaysShadowMap, SurroundsALampWithMaps)
{
  this->AddPillars();
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -3.0 }, { 8.0, 6.0, 0.2 }));
  this->Renderer->AddActor(MakeBox({ 0.6, 3.0, -1.5 }, { 0.3, 0.2, 3.0 }));
  const double error = this->GetError({ 0.0, 0.5, -1.5, 1.0 }); // behind a pillar
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "6 of 1024")) << this->Rays->GetPlan();
  std::cout << "error " << error << "\n";
  EXPECT_LT(error, 0.01);
}

TEST_F(GodRaysShadowMap, IsTheSameInAParallelProjection)
{
  this->AddPillars();
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  const double error = this->GetError({ 0.5, 0.3, -1.0, 0.0 });
  std::cout << "error " << error << "\n";
  EXPECT_LT(error, 0.01); // the sides that the view does not show cast shadows, too
}

TEST_F(GodRaysShadowMap, KeepsTheMapWhileNothingInItChanges)
{
  this->AddPillars();
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(box);
  auto sun = this->AddSun({ 0.15, 0.1, -1.0 });
  const auto isKept = [this]()
  {
    this->Scene.Window->Render();
    return Says(this->Rays->GetPlan(), ", kept");
  };
  EXPECT_FALSE(isKept());
  const auto before = GetPixels(this->Scene.Window);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept"));
  this->Model->SetScatteringCoefficient(0.1, 0.1, 0.1);
  EXPECT_TRUE(isKept());
  this->Model->SetScatteringCoefficient(0.05, 0.05, 0.05);
  sun->SetPosition(0.3, 0.1, -1.0);
  EXPECT_FALSE(isKept());
  sun->SetPosition(0.15, 0.1, -1.0);
  EXPECT_FALSE(isKept());
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  box->SetPosition(0.3, 0.0, 0.0);
  EXPECT_FALSE(isKept());
  EXPECT_GT(GetLargestDifference(before, GetPixels(this->Scene.Window)), 2);
  vtkPolyDataMapper::SafeDownCast(box->GetMapper())->GetInput()->GetPoints()->Modified();
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plane->SetOrigin(-10.0, 0.0, 0.0);
  box->GetMapper()->AddClippingPlane(plane);
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  const auto whole = GetPixels(this->Scene.Window);
  plane->SetOrigin(0.5, 0.0, 0.0);
  EXPECT_FALSE(isKept());
  EXPECT_GT(GetLargestDifference(whole, GetPixels(this->Scene.Window)), 2);
  box->VisibilityOff();
  EXPECT_FALSE(isKept());
  this->Renderer->GetActiveCamera()->Azimuth(1.0);
  this->Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(isKept()); // all that casts a shadow is in it
  const auto kept = GetPixels(this->Scene.Window);
  vtkNew<vtkGodRaysShadowMapIntegrator> other;
  this->Rays->SetIntegrator(other);
  EXPECT_FALSE(isKept());
  EXPECT_LE(GetLargestDifference(kept, GetPixels(this->Scene.Window)), 1);
  this->Rays->SetIntegrator(this->Integrator);
  this->Integrator->SetMapSize(512);
  EXPECT_FALSE(isKept());
  this->Scene.Window->Finalize();
  EXPECT_FALSE(isKept());
}

// The depths of what stays where it is are kept; what is drawn over them makes the same picture.
TEST_F(GodRaysShadowMap, DrawsOnlyWhatMovesAmongThingsThatStay)
{
  this->AddPillars();
  for (const double corner : { -12.0, 12.0 }) // faces stay as they are
  {
    this->Renderer->AddActor(MakeBox({ corner, corner, 0.25 * corner }, { 0.1, 0.1, 0.1 }));
  }
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  auto other = MakeBox({ -1.5, 0.5, 2.0 }, { 1.0, 1.0, 0.1 });
  this->Renderer->AddActor(box);
  this->Renderer->AddActor(other);
  auto sun = this->AddSun({ 0.15, 0.1, -1.0 });
  const struct
  {
    double Box;
    double Other;
    const char* Part;                                // of the plan; none: all are drawn
  } frames[] = { { 0.0, 0.0, "" }, { 0.3, 0.0, "" }, // the first time all are drawn, to be kept
    { 0.5, 0.0, "only 1 of" }, { 0.5, 0.1, "" }, { 0.4, 0.2, "only 2 of" },
    { 0.4, 0.3, "only 2 of" } };
  const auto draw = [&](const auto& frame)
  {
    box->SetPosition(frame.Box, 0.0, 0.0);
    other->SetPosition(0.0, frame.Other, 0.0);
    return GetPixels(this->Scene.Window);
  };
  std::vector<decltype(GetPixels(this->Scene.Window))> pictures;
  for (const auto& frame : frames)
  {
    pictures.push_back(draw(frame));
    const std::string plan = this->Rays->GetPlan();
    EXPECT_EQ(Says(plan, ", only "), *frame.Part != 0) << plan;
    EXPECT_TRUE(Says(plan, frame.Part)) << plan;
  }
  EXPECT_GT(GetLargestDifference(pictures[1], pictures[2]), 2);
  EXPECT_GT(GetLargestDifference(pictures[4], pictures[5]), 2);
  sun->SetPosition(0.3, 0.1, -1.0);
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), ", only ")) << this->Rays->GetPlan();
  sun->SetPosition(0.15, 0.1, -1.0);
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    vtkNew<vtkGodRaysShadowMapIntegrator> fresh; // which knows of no frame before
    this->Rays->SetIntegrator(fresh);
    EXPECT_EQ(pictures[i], draw(frames[i])) << i;
  }
}

TEST_F(GodRaysShadowMap, AsksNoOtherProcessWhereOneHasAllData)
{
  this->AddPillars();
  this->AddSun({ 0.15, 0.1, -1.0 });
  vtkNew<LonelyCompositor> compositor;
  compositor->Distributed = false;
  this->Rays->SetCompositor(compositor);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "shadow map: 1 of")) << this->Rays->GetPlan();
  EXPECT_EQ(compositor->Calls, 0);
  this->Rays->SetCompositor(nullptr);
}

TEST_F(GodRaysShadowMap, LeavesTheSceneAndRolesAlone)
{
  this->AddPillars();
  auto wall = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(wall);
  auto sun = this->AddSun({ 0.5, 0.3, -1.0 });
  this->Renderer->AddLight(sun);
  this->Model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  this->Model->SetAbsorptionCoefficient(0.0, 0.0, 0.0);
  const auto before = GetPixels(this->Scene.Window); // scatters nothing: drawn straight through
  this->Model->SetScatteringCoefficient(1e-12, 1e-12, 1e-12);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double range[2] = { camera->GetClippingRange()[0], camera->GetClippingRange()[1] };
  const auto times = camera->GetMTime() + sun->GetMTime();
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "shadow map: 1 of"));
  EXPECT_EQ(camera, this->Renderer->GetActiveCamera());
  EXPECT_EQ(range[0], camera->GetClippingRange()[0]);
  EXPECT_EQ(range[1], camera->GetClippingRange()[1]);
  EXPECT_EQ(times, camera->GetMTime() + sun->GetMTime());

  this->Model->SetScatteringCoefficient(0.05, 0.05, 0.05);
  auto blocking = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::IGNORED);
  auto ignored = this->GetScattering();
  wall->VisibilityOff();
  auto empty = this->GetScattering();
  EXPECT_NEAR(GetValue(ignored, 80, 80), GetValue(empty, 80, 80), 1e-6);
  EXPECT_LT(GetValue(blocking, 80, 80), 0.98 * GetValue(empty, 80, 80));
}
