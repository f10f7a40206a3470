// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// The shortest program with god rays: a scene with gaps and three lines.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkExtractEdges.h"
#include "vtkGodRaysPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // The edges of a grid as tubes, in the colours of the grid's values
  vtkNew<vtkRTAnalyticSource> grid;
  grid->SetWholeExtent(0, 3, 0, 3, 0, 3);
  vtkNew<vtkExtractEdges> edges;
  edges->SetInputConnection(grid->GetOutputPort());
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(edges->GetOutputPort());
  tubes->SetRadius(0.08);
  tubes->SetNumberOfSides(16);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(-20.0, 0.95, 0.85, 0.3);
  colors->AddRGBPoint(100.0, 0.15, 0.7, 0.6);
  colors->AddRGBPoint(260.0, 0.3, 0.45, 0.95);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->SetLookupTable(colors);
  vtkNew<vtkActor> lattice;
  lattice->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(lattice);
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.016, 0.02, 0.031); // shafts show before dark grounds
  renderer->SetBackground2(0.055, 0.067, 0.094);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Azimuth(25.0);
  camera->Elevation(20.0);
  renderer->ResetCamera();
  camera->Dolly(1.12);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkGodRaysPass> rays;
  rays->SetSunPlacement(vtkGodRaysPass::SUN_EVERY_VIEW); // behind the lattice, with the most shafts
  rays->Attach(renderer);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv, {}, 8);
}
