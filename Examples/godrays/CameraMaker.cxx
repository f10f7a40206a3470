// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraMaker.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double ViewAngle = 30.0;
constexpr double TerrainViewAngle = 42.0;
constexpr double LongestShareOfPicture = 0.74;
}

//------------------------------------------------------------------------------
CameraMaker::CameraMaker(const Scene& scene, const Options& options)
  : Aspect(static_cast<double>(options.Size[0]) / options.Size[1])
  , Data(scene)
  , Settings(options)
{
  scene.Bounds.GetCenter(this->Center.data());
  this->Diagonal = scene.Bounds.GetDiagonalLength();
  this->Diagonal = this->Diagonal > 0.0 ? this->Diagonal : 1.0;
  // A picture that is higher than wide sees as much in its width.
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(ViewAngle));
  const double usual =
    2.0 * vtkMath::DegreesFromRadians(std::atan(tangent / std::min(this->Aspect, 1.0)));
  this->Angle = options.ViewAngle.value_or(scene.IsTerrain() ? TerrainViewAngle : usual);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> CameraMaker::Make(double azimuth, double pitch) const
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  const Vector3 look = this->Data.GetDirection(azimuth, pitch);
  camera->SetViewUp(this->Data.Up.data());
  camera->SetViewAngle(this->Angle);
  camera->SetParallelProjection(this->Settings.Parallel);
  if (this->StandsOnTerrain())
  {
    this->StandOnTerrain(camera, azimuth, look);
  }
  else
  {
    this->ShowWhole(camera, look);
  }
  this->ApplySettings(camera);
  this->SetClippingRange(camera);
  return camera;
}

//------------------------------------------------------------------------------
void CameraMaker::SetClippingRange(vtkCamera* camera) const
{
  double bounds[6];
  this->Data.Bounds.GetBounds(bounds);
  double position[3];
  double look[3];
  camera->GetPosition(position);
  camera->GetDirectionOfProjection(look);
  double farthest = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const double corner[3] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)] };
    double arm[3];
    vtkMath::Subtract(corner, position, arm);
    farthest = std::max(farthest, vtkMath::Dot(arm, look));
  }
  farthest = farthest > 0.0 ? 1.01 * farthest : this->Diagonal;
  camera->SetClippingRange(1e-3 * farthest, farthest);
}

//------------------------------------------------------------------------------
void CameraMaker::Turn(vtkCamera* camera, double x, double y) const
{
  if (!camera->GetParallelProjection())
  {
    const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    camera->Yaw(-vtkMath::DegreesFromRadians(std::atan(x * this->Aspect * tangent)));
    camera->Pitch(vtkMath::DegreesFromRadians(std::atan(y * tangent)));
    return;
  }
  vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
  Vector3 way;
  for (int i = 0; i < 3; ++i)
  {
    way[i] = camera->GetParallelScale() *
      (x * this->Aspect * toView->GetElement(0, i) + y * toView->GetElement(1, i));
  }
  Vector3 position;
  Vector3 focus;
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focus.data());
  camera->SetPosition(AddScaled(position, 1.0, way).data());
  camera->SetFocalPoint(AddScaled(focus, 1.0, way).data());
}

//------------------------------------------------------------------------------
bool CameraMaker::StandsOnTerrain() const
{
  return this->Data.IsTerrain() && !this->Settings.Parallel;
}

//------------------------------------------------------------------------------
void CameraMaker::StandOnTerrain(vtkCamera* camera, double azimuth, const Vector3& look) const
{
  const Vector3 ahead = this->Data.GetDirection(azimuth, 0.0);
  const double length = this->Data.GetExtent(ahead);
  Vector3 position = AddScaled(this->Center, -0.45 * length, ahead);
  const double ground = this->Data.GetHighest(position, 0.12 * length);
  const double level = vtkMath::Dot(position.data(), this->Data.Up.data());
  const double clearance = this->StandHeight * this->Data.GetExtent(this->Data.Up);
  position = AddScaled(position, ground + clearance - level, this->Data.Up);
  const Vector3 focus = AddScaled(position, 0.5 * length, look);
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
}

//------------------------------------------------------------------------------
void CameraMaker::ShowWhole(vtkCamera* camera, const Vector3& look) const
{
  Vector3 right;
  Vector3 up;
  vtkMath::Cross(look.data(), this->Data.Up.data(), right.data());
  if (vtkMath::Normalize(right.data()) == 0.0)
  {
    right = this->Data.East;
  }
  vtkMath::Cross(right.data(), look.data(), up.data());
  const double tangent =
    LongestShareOfPicture * std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Angle));
  double distance = 0.0;
  double halfHeight = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    Vector3 corner;
    this->Data.Bounds.GetCorner(i, corner.data());
    const Vector3 arm = Subtract(corner, this->Center);
    const double x = std::abs(vtkMath::Dot(arm.data(), right.data())) / this->Aspect;
    const double y = std::abs(vtkMath::Dot(arm.data(), up.data()));
    const double depth = vtkMath::Dot(arm.data(), look.data());
    halfHeight = std::max(halfHeight, std::max(x, y) / LongestShareOfPicture);
    distance = std::max(distance, std::max(x, y) / tangent - depth);
  }
  distance = distance > 0.0 ? distance : this->Diagonal;
  const Vector3 position = AddScaled(this->Center, -distance, look);
  camera->SetFocalPoint(this->Center.data());
  camera->SetPosition(position.data());
  camera->SetParallelScale(halfHeight > 0.0 ? halfHeight : this->Diagonal);
  if (std::abs(vtkMath::Dot(look.data(), this->Data.Up.data())) > 0.999)
  {
    camera->SetViewUp(this->Data.North.data());
  }
}

//------------------------------------------------------------------------------
void CameraMaker::ApplySettings(vtkCamera* camera) const
{
  if (this->Settings.FocalPoint)
  {
    // Keep the direction in which the camera looks.
    const Vector3& focus = *this->Settings.FocalPoint;
    Vector3 position;
    camera->GetPosition(position.data());
    Vector3 former;
    camera->GetFocalPoint(former.data());
    position = AddScaled(Subtract(position, former), 1.0, focus);
    camera->SetFocalPoint(focus.data());
    camera->SetPosition(position.data());
  }
  if (this->Settings.CameraPosition)
  {
    const Vector3 focus = this->Settings.FocalPoint.value_or(this->Center);
    camera->SetFocalPoint(focus.data());
    camera->SetPosition(this->Settings.CameraPosition->data());
  }
  if (this->Settings.ViewUp)
  {
    camera->SetViewUp(this->Settings.ViewUp->data());
  }
  double look[3];
  double up[3];
  camera->GetDirectionOfProjection(look);
  camera->GetViewUp(up);
  vtkMath::Normalize(up);
  if (std::abs(vtkMath::Dot(look, up)) > 0.9999)
  {
    camera->SetViewUp(this->Data.North.data()); // straight up or down
  }
}
