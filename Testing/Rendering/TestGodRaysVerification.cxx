// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Errors that are measured in a frame with a medium, against those of a whole picture of the reference.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <string>

using namespace GodRaysTesting;

namespace
{
constexpr int AllPixels = 1000000;

class GodRaysVerification : public MediumTest
{
protected:
  vtkNew<vtkGodRaysShadowMapIntegrator> Coarse; // whose errors are large

  GodRaysVerification()
  {
    this->Coarse->SetMapSize(64);
    this->Coarse->SetNumberOfNestedMaps(1);
    this->Coarse->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
    this->Rays->SetIntegrator(this->Coarse);
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  }

  double Measure(int pixels = AllPixels)
  {
    vtkGodRaysIntegrator* integrator = this->Rays->GetIntegrator();
    integrator->SetVerifyPixels(pixels);
    this->Scene.Window->Render();
    return integrator->GetErrorEstimate();
  }

  /// That all pixels have the error that the reference finds.
  void Check(const char* name, std::array<double, 4> light)
  {
    const double expected = this->GetError(light);
    const double measured = this->Measure();
    std::cout << name << ": " << expected << ", measured " << measured << "\n";
    EXPECT_NEAR(measured / expected, 1.0, 0.03) << name;
    this->Rays->GetIntegrator()->SetVerifyPixels(0);
  }
};
}

TEST_F(GodRaysVerification, IsWhatTheReferenceFinds)
{
  this->AddPillars();
  this->Renderer->AddActor(MakeBox({ 7.0, 0.5, 1.0 }, { 0.4, 2.0, 6.0 })); // outside
  this->Check("sun in front", { 0.15, 0.1, -1.0, 0.0 });
  this->Check("sun beside", { 1.0, 0.3, -0.1, 0.0 });
  this->Check("lamp", { 0.0, 0.5, -2.0, 1.0 });
  this->Check("lamp outside", { 11.0, 0.5, 1.0, 1.0 });
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  this->Renderer->GetActiveCamera()->Roll(10.0);
  this->Renderer->ResetCameraClippingRange();
  this->Check("from elsewhere", { 1.0, 0.3, -0.1, 0.0 });
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  // No edge goes through the centre of a pixel, where picture and reference may see different things.
  this->Renderer->GetActiveCamera()->SetParallelScale(2.7);
  this->Check("parallel", { 1.0, 0.3, -0.1, 0.0 });
}

TEST_F(GodRaysVerification, TakesSomePixelsAndTellsThePlan)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  this->Scene.Window->Render();
  EXPECT_EQ(this->Coarse->GetErrorEstimate(), -1.0);
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "error:"));
  const double all = this->Measure();
  const double largest = this->Coarse->GetLargestVerifiedError();
  const double some = this->Measure(1000);
  EXPECT_NEAR(some / all, 1.0, 0.6);
  EXPECT_EQ(some, this->Measure(1000)) << "the same pixels every time";
  EXPECT_LE(this->Coarse->GetLargestVerifiedError(), largest);
  EXPECT_GT(this->Coarse->GetLargestVerifiedError(), some);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "error: asked for 0.00392157, measured "))
    << this->Rays->GetPlan();
  this->Measure(0);
  EXPECT_EQ(this->Coarse->GetErrorEstimate(), -1.0);
  // Published sums have no limit.
  this->Rays->SetIntegrator(nullptr);
  vtkNew<vtkGodRaysPublishedModel> published;
  this->Rays->SetModel(published);
  EXPECT_EQ(this->Measure(100), -1.0);
}

TEST_F(GodRaysVerification, IsOfTheWorstLight)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  const double front = this->Measure();
  this->SetLight({ 1.0, 0.3, -0.1, 0.0 });
  const double beside = this->Measure();
  this->AddSun({ 0.15, 0.1, -1.0 });
  const double both = this->Measure();
  EXPECT_GT(front, 3.0 * beside);
  EXPECT_NEAR(both / front, 1.0, 0.02);
}

// Polygons are taken again when they move, are cut or hidden.
TEST_F(GodRaysVerification, FollowsTheOccluders)
{
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(box);
  vtkNew<vtkGodRaysShadowMapIntegrator> automatic;
  this->Rays->SetIntegrator(automatic);
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  const auto isRight = [this](const char* change)
  {
    const double error = this->Measure(4000);
    EXPECT_GT(error, 0.0) << change;
    EXPECT_LT(error, 0.006) << change; // the box's shadow is far more
  };
  isRight("none");
  box->SetPosition(0.8, 0.0, 0.0);
  isRight("moved");
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plane->SetOrigin(1.0, 0.0, 0.0);
  box->GetMapper()->AddClippingPlane(plane);
  isRight("cut");
  plane->SetOrigin(1.6, 0.0, 0.0);
  isRight("cut elsewhere");
  box->VisibilityOff();
  EXPECT_LT(this->Measure(4000), 1e-4);
  box->VisibilityOn();
  this->Renderer->RemoveActor(box);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(box);
  assembly->SetPosition(-1.0, 0.3, 0.0);
  this->Renderer->AddActor(assembly);
  isRight("in an assembly");
}

TEST_F(GodRaysVerification, SaysWhatItLeavesOut)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  this->Measure(100);
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "left out")) << this->Rays->GetPlan();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(mapper);
  this->Renderer->AddActor(glyphs);
  this->Measure(100);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "1 props that are no surfaces are left out"))
    << this->Rays->GetPlan();
}

TEST_F(GodRaysVerification, IsOfEverySoManyStillFrames)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  this->Coarse->SetVerifyPixels(20);
  const auto draw = [this](double updateRate = 0.0001)
  {
    this->Scene.Window->SetDesiredUpdateRate(updateRate);
    this->Scene.Window->Render();
    return this->Coarse->GetErrorEstimate();
  };
  const double error = draw();
  EXPECT_GE(error, 0.0);
  EXPECT_EQ(draw(), error);
  EXPECT_EQ(draw(10.0), -1.0) << "while the user drags";
  this->Coarse->SetVerifyInterval(3);
  std::vector<double> errors;
  for (int i = 0; i < 7; ++i)
  {
    errors.push_back(draw());
    draw(10.0);
  }
  EXPECT_EQ(errors, (std::vector<double>{ error, -1.0, -1.0, error, -1.0, -1.0, error }));
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "error:"));
  this->Coarse->SetVerifyInterval(0);
  EXPECT_EQ(this->Coarse->GetVerifyInterval(), 1);
}

// Until it is within the tolerance, or the largest map is reached.
TEST_F(GodRaysVerification, CorrectsTheChoice)
{
  for (int i = -60; i <= 60; ++i) // finer than the map's texels
  {
    this->Renderer->AddActor(MakeBox({ 0.06 * i, 0.0, 0.0 }, { 0.02, 4.0, 0.02 }));
  }
  vtkNew<vtkGodRaysShadowMapIntegrator> automatic;
  this->Rays->SetIntegrator(automatic);
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  const double first = this->Measure();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "4 of 768")) << this->Rays->GetPlan();
  this->Rays->SetErrorTolerance(1.0 / 255.0 - 1e-6); // a new choice, of the same map
  EXPECT_EQ(this->Measure(), first);
  ASSERT_GT(first, this->Rays->GetErrorTolerance());
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "4 of 768")) << this->Rays->GetPlan();
  automatic->SetVerifyPixels(0);
  this->Scene.Window->Render();
  const auto kept = this->Rays->GetPlan();
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "4 of 768")) << "what was learnt is kept";
  this->Rays->SetErrorTolerance(0.006);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "4 of 512")) << this->Rays->GetPlan();
}
