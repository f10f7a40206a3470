// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// Three lamps, each of its own colour, in lanterns.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShrinkPolyData.h"
#include "vtkSphereSource.h"

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // From far away, so that all are seen along their axes: shafts leave between the panes.
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.02, 0.025, 0.05);
  renderer->GetActiveCamera()->SetPosition(0.0, 0.1, 32.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewAngle(11.0);

  vtkNew<vtkGodRaysPass> rays;
  const double colors[3][3] = { { 1.0, 0.38, 0.12 }, { 0.25, 0.85, 0.4 }, { 0.3, 0.5, 1.0 } };
  const double positions[3][3] = { { -2.1, -0.9, 0.0 }, { 0.1, 0.95, 0.0 }, { 2.2, -0.75, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(positions[i]);
    sphere->SetRadius(0.8);
    sphere->SetThetaResolution(12);
    sphere->LatLongTessellationOn();
    vtkNew<vtkShrinkPolyData> panes;
    panes->SetInputConnection(sphere->GetOutputPort());
    panes->SetShrinkFactor(0.75);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(panes->GetOutputPort());
    vtkNew<vtkActor> lantern;
    lantern->SetMapper(mapper);
    lantern->GetProperty()->SetColor(0.3, 0.3, 0.34);
    lantern->GetProperty()->SetAmbient(0.1);
    renderer->AddActor(lantern);

    vtkNew<vtkLight> lamp;
    lamp->SetPositional(true);
    lamp->SetConeAngle(180.0);
    lamp->SetPosition(positions[i]);
    lamp->SetColor(colors[i]);
    renderer->AddLight(lamp);
    rays->AddLight(lamp);
  }
  renderer->ResetCameraClippingRange();
  rays->SetIntensity(2.5);
  rays->SetBackgroundGlowRadius(0.4); // [degrees] within the lanterns
  rays->SetBackgroundGlowFalloff(1.0);
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv);
}
