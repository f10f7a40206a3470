// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What is read back after a change, and before another frame: the last frame's, or nothing.

#include "../Filters/GodRaysGridScenes.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysVolumeModel.h"

#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <string>
#include <vector>

using namespace GodRaysTesting;

namespace
{
using Change = std::function<void(vtkGodRaysPass*)>;
struct Case
{
  const char* Name;
  Change Apply;
  bool HasData = false; // a volume scatters
};

/// How the light is summed: textures of its own, or lent by the integrator or the effect.
const Case Kinds[] = {
  { "processor", [](vtkGodRaysPass*) {} },
  { "graphics card",
    [](vtkGodRaysPass* rays)
    {
      vtkGodRaysEpipolarIntegrator::SafeDownCast(rays->GetIntegrator())
        ->SetBackend(vtkGodRaysEpipolarIntegrator::GRAPHICS);
    } },
  { "taps", [](vtkGodRaysPass* rays) { rays->SetIntegrator(vtkNew<vtkGodRaysTapsIntegrator>()); } },
  { "medium", [](vtkGodRaysPass* rays) { rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>()); } },
  { "shadow map",
    [](vtkGodRaysPass* rays)
    {
      rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
      vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
      integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
      rays->SetIntegrator(integrator);
    } },
  { "data", [](vtkGodRaysPass* rays) { rays->SetModel(vtkNew<vtkGodRaysVolumeModel>()); }, true },
};

void AddSmoke(vtkRenderer* renderer)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(GodRaysGridScenes::MakePlume(17));
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(1.5, 0.5);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->SetPosition(0.0, 0.0, 6.0); // about the origin
  vtkGodRaysPass::SetRole(volume, vtkGodRaysPass::MEDIUM);
  renderer->AddVolume(volume);
}

/// Another window of the same size, with another light and the same integrator; it is gone at the end.
void DrawElsewhere(vtkGodRaysPass* rays)
{
  Stage other;
  other.AddPillarsAndSun()->SetPosition(-0.4, 0.1, -1.0);
  other.Rays->SetModel(vtkSmartPointer<vtkGodRaysModel>::Take(rays->GetModel()->NewInstance()));
  other.Rays->SetIntegrator(rays->GetIntegrator());
  other.Window->Render();
}

const Case Changes[] = {
  { "nothing", [](vtkGodRaysPass*) {} },
  { "the integrator of the model", [](vtkGodRaysPass* rays) { rays->SetIntegrator(nullptr); } },
  { "a new integrator",
    [](vtkGodRaysPass* rays) { rays->SetIntegrator(vtkNew<vtkGodRaysEpipolarIntegrator>()); } },
  { "a new medium's integrator",
    [](vtkGodRaysPass* rays) { rays->SetIntegrator(vtkNew<vtkGodRaysShadowMapIntegrator>()); } },
  { "the default model", [](vtkGodRaysPass* rays) { rays->SetModel(nullptr); } },
  { "a new look", [](vtkGodRaysPass* rays) { rays->SetModel(vtkNew<vtkGodRaysRadialModel>()); } },
  { "a new medium",
    [](vtkGodRaysPass* rays) { rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>()); } },
  { "an integrator in two windows", DrawElsewhere },
};

/// Finalize the window, of which the pass is not told.
void TakeAway(Stage& scene)
{
  scene.Renderer->SetPass(nullptr);
  scene.Window->Finalize();
}

std::vector<double> GetValues(vtkImageData* image)
{
  std::vector<double> values;
  int size[3];
  image->GetDimensions(size);
  for (int i = 0; i < 3 * size[0] * size[1]; ++i)
  {
    values.push_back(GetValue(image, i / 3 % size[0], i / 3 / size[0], i % 3));
  }
  return values;
}

using Read = bool (vtkGodRaysPass::*)(vtkImageData*);

void CheckReadBack(
  const Case& kind, const std::string& name, const std::function<void(Stage&)>& change, Read read)
{
  SCOPED_TRACE(std::string(kind.Name) + ", then " + name);
  Messages messages(true);
  Stage scene;
  scene.AddPillarsAndSun();
  if (kind.HasData)
  {
    AddSmoke(scene.Renderer);
  }
  kind.Apply(scene.Rays);
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  const bool had = (scene.Rays->*read)(image);
  const std::vector<double> before = had ? GetValues(image) : std::vector<double>();
  if (had)
  {
    // memory that is given again may not hold the values that are expected
    image->GetPointData()->GetScalars()->Fill(-1.0);
  }
  change(scene);
  if ((scene.Rays->*read)(image))
  {
    EXPECT_TRUE(had);
    EXPECT_EQ(GetValues(image), before);
  }
  else
  {
    EXPECT_EQ(image->GetNumberOfPoints(), 0);
    EXPECT_NE(name, "nothing") << "there is light";
  }
  EXPECT_EQ(glGetError(), 0u);
  EXPECT_TRUE(messages.Take().empty());
}
}

TEST(GodRaysReadBack, GivesTheLastFrameOrNothing)
{
  for (const Case& kind : Kinds)
  {
    for (const Case& change : Changes)
    {
      CheckReadBack(
        kind, change.Name, [&](Stage& scene) { change.Apply(scene.Rays); },
        &vtkGodRaysPass::GetScatteringImage);
    }
    for (const Read read :
      { &vtkGodRaysPass::GetScatteringImage, &vtkGodRaysPass::GetOcclusionImage })
    {
      CheckReadBack(
        kind, "resources released, of the pass",
        [](Stage& scene) { scene.Rays->ReleaseGraphicsResources(scene.Window); }, read);
      CheckReadBack(
        kind, "resources released, of the integrator",
        [](Stage& scene) { scene.Rays->GetIntegrator()->ReleaseGraphicsResources(scene.Window); },
        read);
      CheckReadBack(
        kind, "another size", [](Stage& scene) { scene.Window->SetSize(50, 40); }, read);
      CheckReadBack(
        kind, "detached", [](Stage& scene) { scene.Rays->Detach(scene.Renderer); }, read);
      CheckReadBack(
        kind, "without a window", [](Stage& scene) { scene.Window->Finalize(); }, read);
      CheckReadBack(kind, "without the renderer's pass and a window", TakeAway, read);
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysReadBack, GivesTheNumbersOfTheLastFrameOrNothing)
{
  const Read read = &vtkGodRaysPass::GetMediumImage;
  for (const Case& kind : { Kinds[3], Kinds[4] }) // media
  {
    for (const Case& change : Changes)
    {
      CheckReadBack(
        kind, change.Name, [&](Stage& scene) { change.Apply(scene.Rays); }, read);
    }
    CheckReadBack(
      kind, "resources released, of the pass",
      [](Stage& scene) { scene.Rays->ReleaseGraphicsResources(scene.Window); }, read);
    CheckReadBack(
      kind, "resources released, of the integrator",
      [](Stage& scene) { scene.Rays->GetIntegrator()->ReleaseGraphicsResources(scene.Window); },
      read);
    CheckReadBack(
      kind, "another size", [](Stage& scene) { scene.Window->SetSize(50, 40); }, read);
    CheckReadBack(
      kind, "detached", [](Stage& scene) { scene.Rays->Detach(scene.Renderer); }, read);
    CheckReadBack(
      kind, "without a window", [](Stage& scene) { scene.Window->Finalize(); }, read);
    CheckReadBack(kind, "without the renderer's pass and a window", TakeAway, read);
  }
}
