// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// The least that god rays need: a sun, something before it, and three lines.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // A colonnade: the ground, a beam and eleven pillars, all boxes.
  vtkNew<vtkAppendPolyData> boxes;
  const auto addBox = [&boxes](double x0, double x1, double y0, double y1, double z0, double z1)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(x0, x1, y0, y1, z0, z1);
    boxes->AddInputConnection(box->GetOutputPort());
  };
  addBox(-40.0, 40.0, -0.2, 0.0, -8.0, 20.0);
  addBox(-12.0, 12.0, 4.0, 4.7, -0.5, 0.5);
  for (int i = -5; i <= 5; ++i)
  {
    addBox(2.0 * i - 0.4, 2.0 * i + 0.4, 0.0, 4.0, -0.4, 0.4);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(boxes->GetOutputPort());
  vtkNew<vtkActor> colonnade;
  colonnade->SetMapper(mapper);
  colonnade->GetProperty()->SetAmbient(0.15);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(colonnade);
  renderer->SetBackground(0.03, 0.06, 0.14);
  renderer->GetActiveCamera()->SetPosition(-3.0, 1.3, 9.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.5, 2.5, 0.0);
  renderer->GetActiveCamera()->SetViewAngle(60.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkLight> sun; // it shines from its position towards the origin
  sun->SetPosition(0.645, 0.16, -1.0);
  sun->SetColor(1.0, 0.85, 0.6);
  renderer->AddLight(sun);

  vtkNew<vtkGodRaysPass> rays;
  rays->AddLight(sun);
  rays->SetBackgroundGlowFalloff(12.0);
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv);
}
