// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysModel.h"

#include "vtkGodRaysEpipolarIntegrator.h"

//------------------------------------------------------------------------------
void vtkGodRaysModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CanScatter: " << this->CanScatter() << "\n";
  os << indent << "FlatGain: " << this->GetFlatGain() << "\n";
  os << indent << "LinearLight: " << this->GetLinearLight() << "\n";
  os << indent << "Blend: " << this->GetBlend() << "\n";
  os << indent << "SceneGain: " << this->GetSceneGain() << "\n";
}

//------------------------------------------------------------------------------
bool vtkGodRaysModel::ApplyPreset(const char* name)
{
  vtkErrorMacro("There is no preset \"" << (name ? name : "") << "\": this model has none.");
  return false;
}

//------------------------------------------------------------------------------
vtkGodRaysIntegrator* vtkGodRaysModel::MakeIntegrator() const
{
  return vtkGodRaysEpipolarIntegrator::New();
}
