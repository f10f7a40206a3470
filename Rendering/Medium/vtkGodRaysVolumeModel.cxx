// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeModel.h"

#include "vtkGodRaysMedium.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGodRaysVolumeModel);

void vtkGodRaysVolumeModel::FillMedium(vtkGodRaysMedium& medium, const double*) const
{
  medium.NumberOfComponents = 1;
  medium.Components[0] = vtkGodRaysMedium::Component();
}

std::string vtkGodRaysVolumeModel::Describe() const
{
  return std::string("volumes tagged MEDIUM alone") +
    (this->AttenuateScene ? ", the scene is dimmed" : ", the scene is not dimmed");
}

void vtkGodRaysVolumeModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
