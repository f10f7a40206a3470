// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysModel.h"

void vtkGodRaysModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CanScatter: " << this->CanScatter() << "\n";
}

bool vtkGodRaysModel::ApplyPreset(const char* name)
{
  vtkErrorMacro("There is no preset \"" << (name ? name : "") << "\": this model has none.");
  return false;
}
