// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumIntegrator.h"

#include "vtkGodRaysMediumModel.h"

void vtkGodRaysMediumIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkGodRaysMediumIntegrator::Contribute(const Request&)
{
  return true;
}

bool vtkGodRaysMediumIntegrator::Supports(vtkGodRaysModel* model)
{
  return vtkGodRaysMediumModel::SafeDownCast(model) != nullptr;
}
