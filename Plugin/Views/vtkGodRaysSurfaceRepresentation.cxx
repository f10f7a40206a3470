// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSurfaceRepresentation.h"

#include "vtkGodRaysPass.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"

vtkStandardNewMacro(vtkGodRaysSurfaceRepresentation);

//------------------------------------------------------------------------------
vtkGodRaysSurfaceRepresentation::vtkGodRaysSurfaceRepresentation()
  : Role(vtkGodRaysPass::AUTOMATIC)
{
}

//------------------------------------------------------------------------------
vtkGodRaysSurfaceRepresentation::~vtkGodRaysSurfaceRepresentation() = default;

//------------------------------------------------------------------------------
void vtkGodRaysSurfaceRepresentation::SetRole(int role)
{
  vtkGodRaysPass::SetRole(this->GetActor(), role);
  const int actual = vtkGodRaysPass::GetRole(this->GetActor());
  if (actual == role && this->Role != role)
  {
    this->Role = role;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Role: " << this->Role << "\n";
}
