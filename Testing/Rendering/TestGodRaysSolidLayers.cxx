// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Layers of solid things: a city whose houses hide each other, against the ground truth.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysEpipolarCoverageIntegrator.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPropCollection.h"

using namespace GodRaysTesting;

namespace
{
class GodRaysSolidLayers : public MediumTest
{
protected:
  GodRaysSolidLayers()
  {
    this->Renderer->AddActor(MakeBox({ 0.0, -2.1, -3.0 }, { 16.0, 0.2, 16.0 }));
    for (int i = 0; i < 14; ++i)
    {
      const double height = 1.0 + 0.37 * (i * 5 % 7);
      this->Renderer->AddActor(MakeBox({ -3.6 + 1.2 * (i % 7), -1.99 + 0.5 * height, i / 7 * -3.0 },
        { 0.7, height, 1.2 + 0.1 * (i % 3) }));
    }
    this->Rays->SetIntegrator(this->Integrator);
  }

  vtkNew<vtkGodRaysEpipolarCoverageIntegrator> Integrator;
};
}

TEST_F(GodRaysSolidLayers, KnowWhatIsHidden)
{
  struct Case
  {
    const char* Name;
    std::array<double, 4> Light;
    double Bounds[3]; // of 0, 1 and 2 layers [root mean square over the peak]
  };
  for (const Case& each : {
         Case{ "front", { 0.15, 0.25, -1.0, 0.0 }, { 0.01, 0.008, 0.0025 } },
         Case{ "beside", { 1.0, 0.6, -0.1, 0.0 }, { 0.0021, 0.0011, 0.0009 } },
         Case{ "behind", { 0.3, 0.5, 1.0, 0.0 }, { 0.007, 0.0032, 0.0017 } },
       })
  {
    double errors[3];
    for (int layers = 0; layers < 3; ++layers)
    {
      this->Integrator->SetNumberOfLayers(layers);
      errors[layers] = this->GetError(each.Light);
      std::cout << each.Name << ", " << layers << " layers: " << errors[layers] << "\n";
      RecordProperty(each.Name + std::to_string(layers), std::to_string(errors[layers]));
      EXPECT_LT(errors[layers], each.Bounds[layers]) << each.Name;
    }
    EXPECT_LT(errors[1], 0.8 * errors[0]) << each.Name;
    EXPECT_LT(errors[2], 0.9 * errors[1]) << each.Name;
  }
}

// With a margin and ignored props depths are of renderings of their own.
TEST_F(GodRaysSolidLayers, WorkWithAMarginAndRoles)
{
  this->Integrator->SetNumberOfLayers(2);
  const std::array<double, 4> light{ 0.15, 0.25, -1.0, 0.0 };
  this->Rays->SetLayerMargin(0.25);
  EXPECT_LT(this->GetError(light), 0.004);
  this->Rays->SetLayerMargin(0.0);
  auto without = this->GetScattering();
  auto ignored = MakeBox({ 0.5, 0.5, 4.0 }, { 0.5, 0.5, 0.5 });
  vtkGodRaysPass::SetRole(ignored, vtkGodRaysPass::IGNORED);
  this->Renderer->AddActor(ignored);
  auto with = this->GetScattering();
  EXPECT_NEAR(GetValue(with, 60, 100), GetValue(without, 60, 100), 1e-6);
  EXPECT_LT(GetValue(with, 146, 114), 0.9 * GetValue(without, 146, 114)); // the ray ends there
}

// The mappers' shaders are the scene's own again, and the keys of props, too.
TEST_F(GodRaysSolidLayers, LeaveTheSceneAlone)
{
  this->SetLight({ 0.15, 0.25, -1.0, 0.0 });
  this->Model->SetScatteringCoefficient(1e-12, 1e-12, 1e-12);
  const auto before = GetPixels(this->Scene.Window);
  this->Integrator->SetNumberOfLayers(2);
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    EXPECT_FALSE(keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()));
  }
}
