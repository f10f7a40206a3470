// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraOptions.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <cmath>

namespace
{
//------------------------------------------------------------------------------
/**
 * The position and focal point of a camera in a given direction from the middle of the data, which fill
 * the picture as before.
 */
void Orbit(const Scene& scene, const Viewpoint& view, Options& options)
{
  Vector3 center;
  scene.Bounds.GetCenter(center.data());
  const Vector3 direction = scene.GetDirection((*options.Camera)[0], (*options.Camera)[1]);
  const double radius = 0.5 * scene.Bounds.GetDiagonalLength();
  const double aspect = static_cast<double>(options.Size[0]) / options.Size[1];
  const double half = 0.5 * vtkMath::RadiansFromDegrees(view.Camera->GetViewAngle());
  const double narrower = std::min(half, std::atan(aspect * std::tan(half)));
  const double distance = radius > 0.0 ? radius / std::sin(narrower) : 1.0;
  options.FocalPoint = center;
  options.CameraPosition = center;
  for (int i = 0; i < 3; ++i)
  {
    (*options.CameraPosition)[i] += distance * direction[i];
  }
}
}

//------------------------------------------------------------------------------
Viewpoint MakeView(const Scene& scene, const Options& given)
{
  Options options = given;
  Viewpoint view = MakeViewpoint(scene, options);
  if (options.Camera)
  {
    Orbit(scene, view, options);
    view = MakeViewpoint(scene, options);
  }
  if (options.Zoom != 1.0)
  {
    Vector3 position;
    Vector3 focus;
    view.Camera->GetPosition(position.data());
    view.Camera->GetFocalPoint(focus.data());
    for (int i = 0; i < 3; ++i)
    {
      position[i] = focus[i] + (position[i] - focus[i]) / options.Zoom;
    }
    options.CameraPosition = position;
    options.FocalPoint = focus;
    const double scale = view.Camera->GetParallelScale() / options.Zoom;
    view = MakeViewpoint(scene, options); // of what is seen now, another place may suit the light
    view.Camera->SetParallelScale(scale);
  }
  if (options.ParallelHeight)
  {
    view.Camera->SetParallelScale(0.5 * *options.ParallelHeight);
  }
  if (options.SunAt)
  {
    const double aspect = static_cast<double>(options.Size[0]) / options.Size[1];
    const auto& [x, y] = *options.SunAt;
    const Vector3 place = GetLightAt(view, view.Camera, aspect, x, y);
    (view.LightIsLamp ? view.LightPosition : view.LightDirection) = place;
    view.LightWasChosen = false;
  }
  return view;
}

//------------------------------------------------------------------------------
Vector3 GetLightAt(const Viewpoint& view, vtkCamera* camera, double aspect, double x, double y)
{
  vtkMatrix4x4* toPicture = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(toPicture, toWorld);
  const auto unproject = [&](double depth)
  {
    double point[4] = { 2.0 * x - 1.0, 2.0 * y - 1.0, depth, 1.0 };
    toWorld->MultiplyPoint(point, point);
    return Vector3{ point[0] / point[3], point[1] / point[3], point[2] / point[3] };
  };
  if (view.LightIsLamp)
  {
    double point[4] = { view.LightPosition[0], view.LightPosition[1], view.LightPosition[2], 1.0 };
    toPicture->MultiplyPoint(point, point);
    return unproject(point[2] / point[3]);
  }
  const Vector3 ends[2] = { unproject(-1.0), unproject(1.0) };
  Vector3 direction;
  vtkMath::Subtract(ends[1].data(), ends[0].data(), direction.data());
  vtkMath::Normalize(direction.data());
  return direction;
}

//------------------------------------------------------------------------------
bool FindLight(const Viewpoint& view, vtkCamera* camera, double aspect, double& x, double& y)
{
  const Vector3& light = view.LightIsLamp ? view.LightPosition : view.LightDirection;
  double point[4] = { light[0], light[1], light[2], view.LightIsLamp ? 1.0 : 0.0 };
  camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->MultiplyPoint(point, point);
  x = 0.5 * (point[0] / point[3] + 1.0);
  y = 0.5 * (point[1] / point[3] + 1.0);
  return point[3] > 0.0;
}
