// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Layers of solid things: a city whose houses hide each other, against the ground truth.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysEpipolarCoverageIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

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

// Mappers of impostors write the depth of a sphere, which is not that of the square that they draw. They have
// no back faces: the second layer begins with the next front. The reference is the light of meshes.
TEST(GodRaysSolidImpostors, AreBehindEachOtherAsMeshesAre)
{
  Messages messages;
  const std::array<double, 3> centers[] = { { 0.0, 0.0, 0.0 }, { 0.4, 0.3, -2.2 } };
  double errors[3] = { 0.0, 0.0, 0.0 };
  for (int layers = 1; layers < 3; ++layers)
  {
    vtkNew<vtkImageData> lights[2];
    for (int impostors = 0; impostors < 2; ++impostors)
    {
      Stage scene(160, 120);
      // The medium ends with what is seen, of which an impostor says its centre alone.
      scene.Renderer->AddActor(MakeBox({ -3.0, -2.0, -5.0 }, { 0.05, 0.05, 0.05 }));
      scene.Renderer->AddActor(MakeBox({ 3.0, 2.0, 2.0 }, { 0.05, 0.05, 0.05 }));
      vtkNew<vtkPoints> points;
      vtkNew<vtkCellArray> cells;
      for (const auto& center : centers)
      {
        const vtkIdType point = points->InsertNextPoint(center.data());
        cells->InsertNextCell(1, &point);
        if (!impostors)
        {
          vtkNew<vtkSphereSource> source;
          source->SetCenter(center[0], center[1], center[2]);
          source->SetRadius(1.0);
          source->SetThetaResolution(96);
          source->SetPhiResolution(96);
          vtkNew<vtkPolyDataMapper> mapper;
          mapper->SetInputConnection(source->GetOutputPort());
          vtkNew<vtkActor> actor;
          actor->SetMapper(mapper);
          scene.Renderer->AddActor(actor);
        }
      }
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      data->SetVerts(cells);
      vtkNew<vtkOpenGLSphereMapper> mapper;
      mapper->SetInputData(data);
      mapper->SetRadius(1.0f);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      if (impostors)
      {
        scene.Renderer->AddActor(actor);
      }
      vtkNew<vtkGodRaysHomogeneousModel> fog;
      fog->ApplyPreset("fog");
      scene.Rays->SetModel(fog);
      vtkNew<vtkGodRaysEpipolarCoverageIntegrator> integrator;
      integrator->SetNumberOfLayers(layers);
      scene.Rays->SetIntegrator(integrator);
      scene.Rays->AddLight(MakeSun({ 1.0, 0.4, -0.3 }));
      scene.Rays->Attach(scene.Renderer);
      scene.Window->Render();
      ASSERT_TRUE(scene.Rays->GetScatteringImage(lights[impostors])) << scene.Rays->GetPlan();
    }
    double peak = 0.0;
    for (int y = 0; y < 120; ++y)
    {
      for (int x = 0; x < 160; ++x)
      {
        const double mesh = GetValue(lights[0], x, y);
        const double difference = GetValue(lights[1], x, y) - mesh;
        errors[layers] += difference * difference / (160.0 * 120.0);
        peak = std::max(peak, mesh);
      }
    }
    errors[layers] = std::sqrt(errors[layers]) / peak;
    std::cout << layers << " layers: " << errors[layers] << " of the peak\n";
    EXPECT_LT(errors[layers], 0.0035);
  }
  EXPECT_LT(errors[2], 1.1 * errors[1]);
}
