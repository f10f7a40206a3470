// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A lamp that is a prop, and a lantern about it that alone blocks its light: the floor does not.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkGodRaysPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShrinkPolyData.h"
#include "vtkSphereSource.h"

vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkAlgorithm* shape)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(shape->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
  return actor;
}

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  vtkNew<vtkRenderer> renderer;
  renderer->GetActiveCamera()->SetPosition(0.0, 1.6, 7.5);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.1, 0.0);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.5);
  const auto lamp = AddActor(renderer, ball);
  lamp->GetProperty()->LightingOff();
  lamp->GetProperty()->SetColor(1.0, 0.75, 0.35);
  vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
  vtkNew<vtkSphereSource> globe;
  vtkNew<vtkShrinkPolyData> plates; // of the globe, with gaps between them
  plates->SetInputConnection(globe->GetOutputPort());
  plates->SetShrinkFactor(0.62);
  const auto lantern = AddActor(renderer, plates);
  lantern->SetScale(2.0);
  lantern->GetProperty()->SetColor(0.25, 0.28, 0.35);
  vtkGodRaysPass::SetRole(lantern, vtkGodRaysPass::OCCLUDER);
  vtkNew<vtkCubeSource> slab;
  slab->SetBounds(-6.0, 6.0, -1.6, -1.4, -4.0, 3.0);
  AddActor(renderer, slab)->GetProperty()->SetColor(0.10, 0.12, 0.18);

  vtkNew<vtkGodRaysPass> rays;
  rays->UntaggedPropsOccludeOff();
  rays->SetBackgroundGlow(0.05);
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv);
}
