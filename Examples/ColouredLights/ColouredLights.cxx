// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// Three lamps, each of its own colour, behind a lattice.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkAppendPolyData> bars;
  for (int i = -5; i <= 5; ++i)
  {
    vtkNew<vtkCubeSource> upright;
    upright->SetBounds(i - 0.3, i + 0.3, -6.0, 6.0, -0.2, 0.2);
    bars->AddInputConnection(upright->GetOutputPort());
    vtkNew<vtkCubeSource> crossbar;
    crossbar->SetBounds(-6.0, 6.0, i - 0.2, i + 0.2, -0.2, 0.2);
    bars->AddInputConnection(crossbar->GetOutputPort());
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(bars->GetOutputPort());
  vtkNew<vtkActor> lattice;
  lattice->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(lattice);
  renderer->GetActiveCamera()->SetPosition(2.5, 1.0, 14.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkGodRaysPass> rays;
  const double colors[3][3] = { { 1.0, 0.2, 0.1 }, { 0.2, 1.0, 0.3 }, { 0.2, 0.4, 1.0 } };
  const double positions[3][3] = { { -3.5, -1.0, -3.0 }, { 0.3, 1.6, -3.0 }, { 3.0, -1.4, -3.0 } };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkLight> lamp;
    lamp->SetPositional(true);
    lamp->SetConeAngle(180.0);
    lamp->SetPosition(positions[i]);
    lamp->SetColor(colors[i]);
    renderer->AddLight(lamp);
    rays->AddLight(lamp);
  }
  rays->SetBackgroundGlowFalloff(8.0);
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, argc, argv);
}
