// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A planet from space, with its atmosphere: the sky, seen from above it.

#include "../ExampleWindow.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkEarthSource.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  // The unit is 1000 km, the planet's centre the origin. The sun is above the equator, along y.
  const double radius = 6.36;
  vtkNew<vtkRenderer> renderer;
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->SetWorldUnitInMeters(1e6);
  sky->SetOrigin(0.0, radius, 0.0);
  sky->SetUp(0.0, 1.0, 0.0);
  sky->SetNorth(0.0, 0.0, 1.0);
  sky->SetSunElevation(90.0);
  sky->SetExposure(6.0);
  sky->AerialPerspectiveOff(); // coastlines are a map, not things

  double eye[3] = { -12.0, 2.0, 5.0 };
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(eye);
  camera->SetFocalPoint(0.0, 0.3, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(1.0, 30.0);

  // Those of the far side are cut off: the planet's horizon is a plane before its centre.
  vtkNew<vtkEarthSource> coasts;
  coasts->SetRadius(radius);
  coasts->SetOnRatio(1);
  coasts->OutlineOn();
  vtkNew<vtkPlane> horizon;
  horizon->SetNormal(eye);
  vtkMath::MultiplyScalar(eye, radius * radius / vtkMath::Dot(eye, eye));
  horizon->SetOrigin(eye);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(coasts->GetOutputPort());
  mapper->AddClippingPlane(horizon);
  vtkNew<vtkActor> lines;
  lines->SetMapper(mapper);
  lines->RotateZ(150.0);
  lines->GetProperty()->SetColor(0.75, 0.85, 0.8);
  lines->GetProperty()->LightingOff();
  renderer->AddActor(lines);

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc, argv);
}
