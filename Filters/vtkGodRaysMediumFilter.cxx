// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumFilter.h"

#include "vtkGodRaysMedium.h"
#include "vtkGodRaysSetGet.h"
#include "vtkMath.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>

vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ViewAngle, 1e-3, 170.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, ParallelScale, 1e-9, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumFilter, Asymmetry, -0.99, 0.99);
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

//------------------------------------------------------------------------------
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
  os << indent << "FarLimit: " << this->FarLimit << "\n";
  PrintNumbers(os, indent, "Light", this->Light, 4);
  PrintNumbers(os, indent, "LightColor", this->LightColor, 3);
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
vtkGodRaysMedium vtkGodRaysMediumFilter::GetMedium(const View&) const
{
  vtkGodRaysMedium medium;
  vtkGodRaysMedium::Component& component = medium.Components[0];
  std::copy_n(this->ScatteringCoefficient, 3, component.Scattering);
  std::copy_n(this->AbsorptionCoefficient, 3, component.Absorption);
  component.PhaseFunction = this->PhaseFunction;
  component.Asymmetry = this->Asymmetry;
  medium.FarLimit = this->FarLimit;
  return medium;
}

//------------------------------------------------------------------------------
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
  if (!IsWithin(this->ScatteringCoefficient, 3, 0.0, 1e3) ||
    !IsWithin(this->AbsorptionCoefficient, 3, 0.0, 1e3))
  {
    return "a coefficient of the medium is out of range. Set ScatteringCoefficient and "
           "AbsorptionCoefficient to numbers in [0, 1000].";
  }
  if (!IsWithin(this->Light, 4, -1e15, 1e15) ||
    (this->Light[3] == 0.0 && vtkMath::Norm(this->Light) == 0.0))
  {
    return "the light is nowhere. Set Light to four numbers within 1e15, the first three not all 0 "
           "if the last one is.";
  }
  if (!IsWithin(this->LightColor, 3, 0.0, 1e30))
  {
    return "the light's colour is out of range. Set LightColor to numbers in [0, 1e30].";
  }
  return {};
}

//------------------------------------------------------------------------------
// Newer VTKs are told to stop in turn, and pass it on.
bool vtkGodRaysMediumFilter::TellProgress(double progress)
{
  this->UpdateProgress(progress);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  if (this->GetAbortExecute())
  {
    this->SetAbortOutput(true);
  }
  return !this->CheckAbort();
#else
  return this->GetAbortExecute() == 0;
#endif
}
