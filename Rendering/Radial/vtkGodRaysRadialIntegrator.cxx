// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialIntegrator.h"

#include "vtkGodRaysRadialModel.h"

//------------------------------------------------------------------------------
void vtkGodRaysRadialIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
unsigned int vtkGodRaysRadialIntegrator::GetOneColorFormat(
  vtkOpenGLRenderWindow*, vtkGodRaysModel*, unsigned int)
{
  return 0;
}

//------------------------------------------------------------------------------
bool vtkGodRaysRadialIntegrator::Supports(vtkGodRaysModel* model)
{
  return vtkGodRaysRadialModel::SafeDownCast(model) != nullptr;
}
