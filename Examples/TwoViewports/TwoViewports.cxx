// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A rose window in two viewports, each with a camera, a look and a pass of its own.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkDiskSource.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShrinkPolyData.h"

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  vtkNew<vtkDiskSource> rose;
  rose->SetInnerRadius(0.6);
  rose->SetOuterRadius(3.0);
  rose->SetRadialResolution(3);
  rose->SetCircumferentialResolution(16);
  vtkNew<vtkShrinkPolyData> plates; // of the rose, with gaps between them
  plates->SetInputConnection(rose->GetOutputPort());
  plates->SetShrinkFactor(0.7);
  vtkNew<vtkDiskSource> wall; // about the rose
  wall->SetInnerRadius(3.0);
  wall->SetOuterRadius(30.0);
  wall->SetCircumferentialResolution(96);
  vtkNew<vtkAppendPolyData> parts;
  parts->AddInputConnection(plates->GetOutputPort());
  parts->AddInputConnection(wall->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(parts->GetOutputPort());
  vtkNew<vtkActor> facade;
  facade->SetMapper(mapper);
  facade->GetProperty()->SetColor(0.35, 0.4, 0.55);
  facade->GetProperty()->SetAmbient(0.08);

  vtkNew<vtkLight> sun; // it shines from its position towards the origin
  sun->SetPosition(0.05, 0.1, -1.0);
  sun->SetColor(1.0, 0.85, 0.6);
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderers[2];
  vtkNew<vtkGodRaysPass> rays[2];
  const char* looks[2] = { "cathedral", "low-sun" };
  for (int i = 0; i < 2; ++i)
  {
    renderers[i]->SetViewport(0.5 * i, 0.0, 0.5 + 0.5 * i, 1.0);
    renderers[i]->AddActor(facade);
    renderers[i]->AddLight(sun);
    renderers[i]->SetBackground(0.2, 0.26, 0.42);
    renderers[i]->GetActiveCamera()->SetPosition(-2.0 * i - 0.5, 1.5 * i - 1.0, 12.0 + 2.0 * i);
    renderers[i]->GetActiveCamera()->SetViewAngle(45.0);
    window->AddRenderer(renderers[i]);
    rays[i]->ApplyPreset(looks[i]);
    rays[i]->AddLight(sun);
    rays[i]->Attach(renderers[i]);
  }
  return ShowOrWrite(window, size, argc, argv);
}
