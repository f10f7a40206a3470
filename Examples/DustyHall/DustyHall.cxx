// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// Physical single scattering: the sun through windows into the dust of a hall.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <array>
#include <vector>

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // A hall, 14 m long and 6 m high: floor, roof, walls and pillars; and between its five windows.
  std::vector<std::array<double, 6>> bounds = { { -7, 7, -0.3, 0, -4.4, 5 },
    { -7, 7, 6, 6.3, -4.4, 5 }, { -7, -6.8, 0, 6, -4.4, 5 }, { 6.8, 7, 0, 6, -4.4, 5 },
    { -7, 7, 0, 1.2, -4.4, -4 }, { -7, 7, 4.8, 6, -4.4, -4 }, { -7.2, -5.75, 0, 6, -4.4, -4 },
    { -2.95, -2.25, 0, 6, -1.35, -0.65 }, { 3.55, 4.25, 0, 6, -1.85, -1.15 } };
  for (const double x : { -5.2, -2.6, 0.0, 2.6, 5.2 })
  {
    bounds.push_back({ x + 0.55, x + 2.05, 0, 6, -4.4, -4 });
    bounds.push_back({ x - 0.03, x + 0.03, 1.2, 5, -4.25, -4.15 });
  }
  vtkNew<vtkAppendPolyData> boxes;
  for (const auto& each : bounds)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(each.data());
    boxes->AddInputConnection(box->GetOutputPort());
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(boxes->GetOutputPort());
  vtkNew<vtkActor> hall;
  hall->SetMapper(mapper);
  hall->GetProperty()->SetColor(0.72, 0.66, 0.6);
  hall->GetProperty()->SetAmbient(0.3);
  hall->GetProperty()->SetDiffuse(0.5);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(hall);
  renderer->SetBackground(0.75, 0.85, 1.0);
  renderer->GetActiveCamera()->SetPosition(-1.5, 1.7, 4.9);
  renderer->GetActiveCamera()->SetFocalPoint(1.3, 2.3, -3.6);
  renderer->GetActiveCamera()->SetViewAngle(60.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkLight> sun;
  sun->SetPosition(0.35, 0.75, -1.0);
  sun->SetColor(1.0, 0.86, 0.62);
  renderer->AddLight(sun);

  vtkNew<vtkGodRaysHomogeneousModel> dust;
  dust->SetScatteringCoefficient(0.05, 0.05, 0.05); // [1/m]
  vtkNew<vtkGodRaysPass> rays;
  rays->SetModel(dust);
  rays->SetIntensity(10.0); // as for eyes used to the dark
  rays->AddLight(sun);
  rays->SurfaceShadowsOn(); // sunlight comes through the windows alone
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv);
}
