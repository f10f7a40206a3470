// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSun.h"

#include "vtkCamera.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSunPosition.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkGodRaysSun);

vtkGodRaysSetModeMacro(vtkGodRaysSun, Frame, UP_AND_NORTH);
vtkGodRaysSetFinite3Macro(vtkGodRaysSun, Up, -1e30, 1e30);
vtkGodRaysSetFinite3Macro(vtkGodRaysSun, North, -1e30, 1e30);
vtkGodRaysSetModeMacro(vtkGodRaysSun, Position, DATE_AND_PLACE);
vtkGodRaysSetFiniteMacro(vtkGodRaysSun, Azimuth, std::numeric_limits<double>::lowest(),
  std::numeric_limits<double>::max());
vtkGodRaysSetFiniteMacro(vtkGodRaysSun, Elevation, -90.0, 90.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSun, AngularRadius, 0.01, 90.0);
vtkGodRaysSetFinite3Macro(vtkGodRaysSun, Color, 0.0, 1.0);

vtkGodRaysSun::vtkGodRaysSun()
  : Ephemeris(vtkSmartPointer<vtkGodRaysSunPosition>::New())
{
}

vtkGodRaysSun::~vtkGodRaysSun() = default;

void vtkGodRaysSun::SetEphemeris(vtkGodRaysSunPosition* ephemeris)
{
  if (!ephemeris || ephemeris != this->Ephemeris)
  {
    this->Ephemeris = ephemeris;
    if (!ephemeris)
    {
      this->Ephemeris = vtkSmartPointer<vtkGodRaysSunPosition>::New();
    }
    this->Modified();
  }
}

vtkGodRaysSunPosition* vtkGodRaysSun::GetEphemeris()
{
  return this->Ephemeris;
}

double* vtkGodRaysSun::GetAngles()
{
  const bool given = this->Position == AZIMUTH_AND_ELEVATION;
  this->Angles[0] = given ? this->Azimuth : this->Ephemeris->GetAzimuth();
  this->Angles[1] = given ? this->Elevation : this->Ephemeris->GetElevation();
  return this->Angles;
}

bool vtkGodRaysSun::IsAboveHorizon()
{
  return this->GetAngles()[1] > -this->AngularRadius;
}

bool vtkGodRaysSun::Shines()
{
  return this->Position == AZIMUTH_AND_ELEVATION || this->IsAboveHorizon();
}

void vtkGodRaysSun::GetAxes(vtkCamera* camera, double up[3], double north[3])
{
  static const double axes[][2][3] = { // by Frame
    { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 } }, { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } },
    { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 } }, { { 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 } }
  };
  const bool given = this->Frame == UP_AND_NORTH;
  vtkMath::Assign(given ? this->Up : axes[this->Frame][0], up);
  vtkMath::Assign(given ? this->North : axes[this->Frame][1], north);
  if (this->Frame == CAMERA && camera)
  {
    vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
    for (int i = 0; i < 3; ++i)
    {
      up[i] = view->GetElement(1, i);
      north[i] = -view->GetElement(2, i);
    }
  }
}

bool vtkGodRaysSun::GetDirection(vtkCamera* camera, double direction[3])
{
  double up[3], north[3];
  this->GetAxes(camera, up, north);
  const double* angles = this->GetAngles();
  const bool found =
    vtkGodRaysSunPosition::ComputeDirection(angles[0], angles[1], up, north, direction);
  if (!found && this->ErrorTime != this->GetMTime())
  {
    this->ErrorTime = this->GetMTime();
    vtkErrorMacro("There is no direction to the sun: Up and North must not be 0 nor parallel.");
  }
  return found;
}

bool vtkGodRaysSun::MoveTo(vtkCamera* camera, const double direction[3])
{
  double up[3], north[3], east[3], towards[3];
  this->GetAxes(camera, up, north);
  vtkMath::Cross(north, up, east);
  vtkMath::Cross(up, east, north);
  vtkMath::Assign(direction, towards);
  for (double* axis : { up, north, east, towards })
  {
    const double length = vtkMath::Normalize(axis);
    if (!(length > 0.0) || !std::isfinite(length))
    {
      return false;
    }
  }
  this->SetPosition(AZIMUTH_AND_ELEVATION);
  this->SetAzimuth(vtkMath::DegreesFromRadians(
    std::atan2(vtkMath::Dot(towards, east), vtkMath::Dot(towards, north))));
  this->SetElevation(vtkMath::DegreesFromRadians(
    std::asin(std::min(std::max(vtkMath::Dot(towards, up), -1.0), 1.0))));
  return true;
}

bool vtkGodRaysSun::UpdateLight(vtkLight* light)
{
  if (!light)
  {
    vtkErrorMacro("UpdateLight needs a vtkLight, not null.");
    return false;
  }
  double direction[3];
  if (!this->GetDirection(nullptr, direction))
  {
    return false;
  }
  light->SetPositional(false);
  if (this->Frame == CAMERA)
  {
    light->SetLightTypeToCameraLight(); // whose matrix the renderer sets
  }
  else
  {
    light->SetLightTypeToSceneLight();
    light->SetTransformMatrix(nullptr);
  }
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPosition(direction);
  light->SetColor(this->Color);
  light->SetIntensity(1.0);
  return true;
}

vtkMTimeType vtkGodRaysSun::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Ephemeris->GetMTime());
}

void vtkGodRaysSun::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double* values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  os << indent << "Frame: " << this->Frame << "\n";
  print("Up", this->Up);
  print("North", this->North);
  os << indent << "Position: " << this->Position << "\n";
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "AngularRadius: " << this->AngularRadius << "\n";
  print("Color", this->Color);
  os << indent << "Ephemeris:\n";
  this->Ephemeris->PrintSelf(os, indent.GetNextIndent());
}
