// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectScene.h"

#include "vtkGodRaysTapsIntegrator.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricSuperToroid.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

//------------------------------------------------------------------------------
const std::vector<EffectScene::Variant>& EffectScene::GetVariants()
{
  static const std::vector<Variant> variants = {
    { "plain", false, false, 0 },
    { "default", true, false, 0 },
    { "taps 100", true, false, 100 },
    { "plain, with a lamp", false, true, 0 },
    { "default, lamp", true, true, 0 },
  };
  return variants;
}

//------------------------------------------------------------------------------
EffectScene::EffectScene(Device& device, int width, int height)
  : OpenGL(device)
{
  vtkNew<vtkParametricSuperToroid> function;
  vtkNew<vtkParametricFunctionSource> ring; // two triangles for each of 500 by 300 cells
  ring->SetParametricFunction(function);
  ring->SetUResolution(500);
  ring->SetVResolution(300);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ring->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetOrientation(35.0, 25.0, 0.0);
  actor->SetScale(1.3);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->Renderer->AddActor(actor);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  this->Lamp->SetMapper(sphereMapper);
  this->Lamp->SetPosition(0.3, 0.3, -6.0);
  this->Lamp->GetProperty()->LightingOff();
  vtkGodRaysPass::SetRole(this->Lamp, vtkGodRaysPass::LIGHT);
  this->Renderer->AddActor(this->Lamp);

  this->Light->SetLightTypeToSceneLight();
  this->Light->PositionalOn();
  this->Light->SetPosition(0.3, 0.3, -6.0);

  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(30.0);
  camera->SetClippingRange(0.1, 100.0);

  this->OpenGL.GetWindow()->SetSize(width, height);
  this->OpenGL.GetWindow()->AddRenderer(this->Renderer);
  for (const Variant& variant : GetVariants())
  {
    if (!variant.HasPass)
    {
      continue;
    }
    auto pass = vtkSmartPointer<vtkGodRaysPass>::New();
    if (!variant.LampShines)
    {
      pass->AddLight(this->Light);
      pass->SetSourceRadius(2.0);
    }
    if (variant.Taps > 0)
    {
      vtkNew<vtkGodRaysTapsIntegrator> taps;
      taps->SetNumberOfTaps(variant.Taps);
      pass->SetIntegrator(taps);
    }
    this->Passes[variant.Name] = pass; // not attached: it would come back into the other variants
  }
}

//------------------------------------------------------------------------------
EffectScene::~EffectScene()
{
  vtkRenderWindow* window = this->OpenGL.GetWindow();
  for (auto& pass : this->Passes)
  {
    pass.second->ReleaseGraphicsResources(window);
  }
  this->Renderer->SetPass(nullptr);
  this->Renderer->ReleaseGraphicsResources(window);
  window->RemoveRenderer(this->Renderer);
  window->SetSize(64, 64);
}

//------------------------------------------------------------------------------
double EffectScene::Draw(const Variant& variant)
{
  this->Lamp->SetVisibility(variant.LampShines);
  this->Renderer->SetPass(variant.HasPass ? this->Passes[variant.Name] : nullptr);
  return this->OpenGL.Measure([this]() { this->OpenGL.GetWindow()->Render(); });
}
