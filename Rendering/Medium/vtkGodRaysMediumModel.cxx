// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumModel.h"

#include "vtkGodRaysMedium.h"
#include "vtkGodRaysMediumEffect.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysShadowMapIntegrator.h"

#include <algorithm>

vtkGodRaysSetFiniteMacro(vtkGodRaysMediumModel, WorldUnitInMeters, 0.0, 1e12);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumModel, FarLimit, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumModel, DataScale, 0.0, 1e9);
vtkGodRaysSetFinite3Macro(vtkGodRaysMediumModel, DataAlbedo, 0.0, 1.0);
vtkGodRaysSetModeMacro(vtkGodRaysMediumModel, DataPhaseFunction, vtkGodRaysLastPhaseFunction);
vtkGodRaysSetFiniteMacro(vtkGodRaysMediumModel, DataAsymmetry, -0.99, 0.99);

namespace
{
// Any place will do where only coefficients matter.
const double Identity[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0,
  0.0, 1.0 };
}

vtkGodRaysMedium vtkGodRaysMediumModel::GetMedium(
  const double worldToView[16], double farDepth, double diagonal) const
{
  vtkGodRaysMedium medium;
  this->FillMedium(medium, worldToView);
  medium.ConvertTo(this->GetUnit());
  if (this->WorldUnitInMeters == 0.0)
  {
    medium.Scale(this->GetScale(medium, diagonal));
  }
  medium.FarLimit = this->FarLimit > 0.0 ? this->FarLimit : farDepth;
  return medium;
}

double vtkGodRaysMediumModel::GetUnit() const
{
  return this->WorldUnitInMeters > 0.0 ? std::max(this->WorldUnitInMeters, 1e-12) : 1.0;
}

bool vtkGodRaysMediumModel::CanScatter() const
{
  const vtkGodRaysMedium medium = this->GetMedium(Identity, 1.0, 0.0);
  double most = 0.0;
  for (int i = 0; i < medium.NumberOfComponents; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most, medium.Components[i].Scattering[c]);
      most = std::max(most, this->AttenuateScene ? medium.Components[i].Absorption[c] : 0.0);
    }
  }
  return most > 0.0;
}

vtkGodRaysIntegrator* vtkGodRaysMediumModel::MakeIntegrator() const
{
  return vtkGodRaysShadowMapIntegrator::New();
}

std::unique_ptr<vtkGodRaysEffect> vtkGodRaysMediumModel::MakeEffect()
{
  return std::make_unique<vtkGodRaysMediumEffect>(this);
}

void vtkGodRaysMediumModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WorldUnitInMeters: " << this->WorldUnitInMeters << "\n";
  os << indent << "FarLimit: " << this->FarLimit << "\n";
  os << indent << "AttenuateScene: " << (this->AttenuateScene ? "on" : "off") << "\n";
  os << indent << "ScatteringOrders: " << (this->ScatteringOrders == ALL ? "ALL" : "SINGLE")
     << "\n";
  os << indent << "DataScale: " << this->DataScale << "\n";
  os << indent << "DataAlbedo: " << this->DataAlbedo[0] << " " << this->DataAlbedo[1] << " "
     << this->DataAlbedo[2] << "\n";
  os << indent << "DataPhaseFunction: " << this->DataPhaseFunction << "\n";
  os << indent << "DataAsymmetry: " << this->DataAsymmetry << "\n";
  os << indent << "DataResolution: " << this->DataResolution << "\n";
}
