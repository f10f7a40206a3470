// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumFilter.h"

#include "vtkGodRaysMedium.h"
#include "vtkGodRaysProgress.h"
#include "vtkGodRaysSetGet.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ViewAngle, 1e-3, 170.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ParallelScale, 1e-9, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, Asymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, SecondAsymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, SecondWeight, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ScaleHeight, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, GasAsymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, GasScaleHeight, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, GroundLevel, -1e15, 1e15);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, PlanetRadius, 0.0, 1e15);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ConeAngle, 1e-3, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, SpotExponent, 0.0, 128.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, FarLimit, 1e-6, 1e9);

namespace
{
bool IsWithin(const double* values, int count, double low, double high)
{
  for (int i = 0; i < count; ++i)
  {
    if (!(values[i] >= low && values[i] <= high)) // false for NaN
    {
      return false;
    }
  }
  return true;
}

void PrintNumbers(ostream& os, vtkIndent indent, const char* name, const double* values, int count)
{
  os << indent << name << ":";
  for (int i = 0; i < count; ++i)
  {
    os << " " << values[i];
  }
  os << "\n";
}
}

void vtkGodRaysMediumFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintNumbers(os, indent, "CameraPosition", this->CameraPosition, 3);
  PrintNumbers(os, indent, "CameraFocalPoint", this->CameraFocalPoint, 3);
  PrintNumbers(os, indent, "CameraViewUp", this->CameraViewUp, 3);
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "ParallelScale: " << this->ParallelScale << "\n";
  PrintNumbers(os, indent, "ScatteringCoefficient", this->ScatteringCoefficient, 3);
  PrintNumbers(os, indent, "AbsorptionCoefficient", this->AbsorptionCoefficient, 3);
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "Asymmetry: " << this->Asymmetry << "\n";
  os << indent << "SecondPhaseFunction: " << this->SecondPhaseFunction << "\n";
  os << indent << "SecondAsymmetry: " << this->SecondAsymmetry << "\n";
  os << indent << "SecondWeight: " << this->SecondWeight << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  PrintNumbers(os, indent, "GasScatteringCoefficient", this->GasScatteringCoefficient, 3);
  PrintNumbers(os, indent, "GasAbsorptionCoefficient", this->GasAbsorptionCoefficient, 3);
  os << indent << "GasPhaseFunction: " << this->GasPhaseFunction << "\n";
  os << indent << "GasAsymmetry: " << this->GasAsymmetry << "\n";
  os << indent << "GasScaleHeight: " << this->GasScaleHeight << "\n";
  PrintNumbers(os, indent, "MediumUp", this->MediumUp, 3);
  os << indent << "GroundLevel: " << this->GroundLevel << "\n";
  os << indent << "PlanetRadius: " << this->PlanetRadius << "\n";
  os << indent << "FarLimit: " << this->FarLimit << "\n";
  PrintNumbers(os, indent, "Light", this->Light, 4);
  PrintNumbers(os, indent, "LightColor", this->LightColor, 3);
  os << indent << "ConeAngle: " << this->ConeAngle << "\n";
  PrintNumbers(os, indent, "SpotDirection", this->SpotDirection, 3);
  os << indent << "SpotExponent: " << this->SpotExponent << "\n";
}

vtkGodRaysMediumFilter::View vtkGodRaysMediumFilter::GetView(int height) const
{
  View view;
  vtkMath::Subtract(this->CameraFocalPoint, this->CameraPosition, view.Forward);
  vtkMath::Normalize(view.Forward);
  vtkMath::Cross(view.Forward, this->CameraViewUp, view.Right);
  vtkMath::Normalize(view.Right);
  vtkMath::Cross(view.Right, view.Forward, view.Up);
  vtkMath::Assign(this->CameraPosition, view.Position);
  view.Parallel = this->ParallelProjection;
  view.PixelSize = 2.0 / height *
    (view.Parallel ? this->ParallelScale
                   : std::tan(0.5 * vtkMath::RadiansFromDegrees(this->ViewAngle)));
  return view;
}

vtkGodRaysMedium vtkGodRaysMediumFilter::GetMedium(const View& view) const
{
  vtkGodRaysMedium medium;
  vtkGodRaysMedium::Component& component = medium.Components[0];
  std::copy_n(this->ScatteringCoefficient, 3, component.Scattering);
  std::copy_n(this->AbsorptionCoefficient, 3, component.Absorption);
  component.PhaseFunction = this->PhaseFunction;
  component.Asymmetry = this->Asymmetry;
  component.SecondPhaseFunction = this->SecondPhaseFunction;
  component.SecondAsymmetry = this->SecondAsymmetry;
  component.SecondWeight = this->SecondWeight;
  component.ScaleHeight = this->ScaleHeight;
  if (!IsWithin(this->GasScatteringCoefficient, 3, 0.0, 0.0) ||
    !IsWithin(this->GasAbsorptionCoefficient, 3, 0.0, 0.0))
  {
    vtkGodRaysMedium::Component& gas = medium.Components[1];
    std::copy_n(this->GasScatteringCoefficient, 3, gas.Scattering);
    std::copy_n(this->GasAbsorptionCoefficient, 3, gas.Absorption);
    gas.PhaseFunction = this->GasPhaseFunction;
    gas.Asymmetry = this->GasAsymmetry;
    gas.ScaleHeight = this->GasScaleHeight;
    medium.NumberOfComponents = 2;
  }
  double up[3];
  vtkMath::Assign(this->MediumUp, up);
  vtkMath::Normalize(up);
  medium.PlanetRadius = this->PlanetRadius;
  double vertical[3];
  medium.PlaceEye(view.Position, up, this->GroundLevel, vertical);
  medium.Up[0] = vtkMath::Dot(vertical, view.Right);
  medium.Up[1] = vtkMath::Dot(vertical, view.Up);
  medium.Up[2] = vtkMath::Dot(vertical, view.Forward);
  medium.FarLimit = this->FarLimit;
  return medium;
}

vtkGodRaysSpot vtkGodRaysMediumFilter::GetSpot(const View& view) const
{
  vtkGodRaysSpot spot;
  if (this->ConeAngle >= 90.0 || this->Light[3] == 0.0)
  {
    return spot;
  }
  double axis[3];
  vtkMath::Assign(this->SpotDirection, axis);
  vtkMath::Normalize(axis);
  spot.Axis[0] = vtkMath::Dot(axis, view.Right);
  spot.Axis[1] = vtkMath::Dot(axis, view.Up);
  spot.Axis[2] = vtkMath::Dot(axis, view.Forward);
  spot.CosCone = std::cos(vtkMath::RadiansFromDegrees(this->ConeAngle));
  spot.Exponent = this->SpotExponent;
  return spot;
}

std::string vtkGodRaysMediumFilter::FindFault() const
{
  if (!IsWithin(this->CameraPosition, 3, -1e15, 1e15) ||
    !IsWithin(this->CameraFocalPoint, 3, -1e15, 1e15) ||
    !IsWithin(this->CameraViewUp, 3, -1e15, 1e15))
  {
    return "the camera is not finite. Set CameraPosition, CameraFocalPoint and CameraViewUp to "
           "numbers within 1e15.";
  }
  const View view = this->GetView(1);
  if (!(vtkMath::Norm(view.Forward) > 0.5 && vtkMath::Norm(view.Right) > 0.5))
  {
    return "the camera looks nowhere. CameraFocalPoint must differ from CameraPosition, and "
           "CameraViewUp must not be along the direction of view.";
  }
  return this->FindMediumFault();
}

std::string vtkGodRaysMediumFilter::FindMediumFault() const
{
  if (!IsWithin(this->ScatteringCoefficient, 3, 0.0, 1e3) ||
    !IsWithin(this->AbsorptionCoefficient, 3, 0.0, 1e3) ||
    !IsWithin(this->GasScatteringCoefficient, 3, 0.0, 1e3) ||
    !IsWithin(this->GasAbsorptionCoefficient, 3, 0.0, 1e3))
  {
    return "a coefficient of the medium is out of range. Set ScatteringCoefficient, "
           "AbsorptionCoefficient and those of the gas to numbers in [0, 1000].";
  }
  if (!IsWithin(this->MediumUp, 3, -1e15, 1e15) || vtkMath::Norm(this->MediumUp) == 0.0)
  {
    return "the medium does not know what is up. Set MediumUp to three numbers within 1e15, not "
           "all 0.";
  }
  if (!IsWithin(this->Light, 4, -1e15, 1e15) ||
    (this->Light[3] == 0.0 && vtkMath::Norm(this->Light) == 0.0))
  {
    return "the light is nowhere. Set Light to four numbers within 1e15, the first three not all 0 "
           "if the last one is.";
  }
  if (!IsWithin(this->SpotDirection, 3, -1e15, 1e15) || vtkMath::Norm(this->SpotDirection) == 0.0)
  {
    return "the spotlight has no direction. Set SpotDirection to three numbers within 1e15, not "
           "all 0.";
  }
  if (!IsWithin(this->LightColor, 3, 0.0, 1e30))
  {
    return "the light's colour is out of range. Set LightColor to numbers in [0, 1e30].";
  }
  return {};
}

bool vtkGodRaysMediumFilter::TellProgress(double progress)
{
  return vtkGodRays::TellProgress(this, progress);
}
