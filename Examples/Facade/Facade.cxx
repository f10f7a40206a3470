// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A facade at night: shafts from its windows alone, also for an eye that is very near.

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

#include <array>
#include <string>
#include <vector>

namespace
{
using Boxes = std::vector<std::array<double, 6>>;

vtkSmartPointer<vtkActor> AddBoxes(
  vtkRenderer* renderer, const Boxes& bounds, double red, double green, double blue)
{
  vtkNew<vtkAppendPolyData> boxes;
  for (const auto& each : bounds)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(each.data());
    boxes->AddInputConnection(box->GetOutputPort());
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(boxes->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  renderer->AddActor(actor);
  return actor;
}

/// Where the eye is: across the street, or 30 cm from the wall.
class View
{
public:
  void Look(bool near)
  {
    this->Near = near;
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(near ? -5.2 : -6.5, near ? 1.3 : 1.7, near ? 0.3 : 12.0);
    camera->SetFocalPoint(near ? -2.0 : 0.3, near ? 3.4 : 3.9, near ? -0.6 : 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetViewAngle(near ? 75.0 : 40.0);
    this->Renderer->ResetCameraClippingRange();
  }

  void OnKey(vtkObject* caller, unsigned long, void*)
  {
    auto interactor = vtkRenderWindowInteractor::SafeDownCast(caller);
    const char* key = interactor->GetKeySym(); // null for a key that X does not know
    if (key && key == std::string("n"))
    {
      this->Look(!this->Near);
      interactor->Render();
    }
  }

  vtkNew<vtkRenderer> Renderer;

private:
  bool Near = false;
};
}

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // A wall of 12.8 m by 7.6 m; eight windows of 1.2 m by 2 m, with bars before their panes.
  Boxes wall, panes;
  for (const double y : { 0.0, 3.2, 6.4 })
  {
    wall.push_back({ -6.4, 6.4, y, y + 1.2, -0.4, 0.0 });
  }
  for (const double x : { -5.6, -2.8, 0.0, 2.8, 5.6 })
  {
    wall.push_back({ x - 0.8, x + 0.8, 0.0, 7.6, -0.4, 0.0 });
  }
  for (const double x : { -4.2, -1.4, 1.4, 4.2 })
  {
    for (const double y : { 1.2, 4.4 })
    {
      panes.push_back({ x - 0.7, x + 0.7, y - 0.1, y + 2.1, -0.35, -0.34 });
      wall.push_back({ x - 0.04, x + 0.04, y, y + 2.0, -0.3, -0.25 });
      wall.push_back({ x - 0.6, x + 0.6, y + 0.63, y + 0.69, -0.3, -0.25 });
      wall.push_back({ x - 0.6, x + 0.6, y + 1.3, y + 1.36, -0.3, -0.25 });
    }
  }
  View view;
  vtkRenderer* renderer = view.Renderer;
  const auto house = AddBoxes(renderer, wall, 0.3, 0.31, 0.36);
  vtkGodRaysPass::SetRole(house, vtkGodRaysPass::OCCLUDER);
  const auto windows = AddBoxes(renderer, panes, 1.0, 0.72, 0.36);
  windows->GetProperty()->LightingOff();
  vtkGodRaysPass::SetRole(windows, vtkGodRaysPass::LIGHT);
  AddBoxes(renderer, { { -20.0, 20.0, -0.2, 0.0, -0.4, 20.0 } }, 0.1, 0.11, 0.13); // the street
  renderer->SetBackground(0.01, 0.012, 0.03);
  renderer->SetNearClippingPlaneTolerance(0.0005); // so that the wall is not cut open
  vtkNew<vtkLight> moon;
  moon->SetPosition(-1.0, 1.0, 2.0);
  moon->SetColor(0.25, 0.3, 0.45);
  renderer->AddLight(moon);
  const bool near = argc > 1 && argv[argc - 1] == std::string("near");
  view.Look(near);

  vtkNew<vtkGodRaysPass> rays;
  rays->UntaggedPropsOccludeOff();
  rays->SetBackgroundGlow(0.0); // the windows shine, and nothing else
  rays->ApplyPreset("low-sun");
  rays->SetIntensity(0.7);
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  if (argc > 1 + near)
  {
    return WritePicture(window, size, argv[1]);
  }
  window->SetSize(size[0], size[1]);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->AddObserver(vtkCommand::KeyPressEvent, &view, &View::OnKey);
  window->Render();
  interactor->Start();
  return EXIT_SUCCESS;
}
