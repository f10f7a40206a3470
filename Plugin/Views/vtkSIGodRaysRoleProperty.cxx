// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSIGodRaysRoleProperty.h"

#include "vtkAlgorithm.h"
#include "vtkGodRaysPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkSMMessage.h"

vtkStandardNewMacro(vtkSIGodRaysRoleProperty);

vtkSIGodRaysRoleProperty::vtkSIGodRaysRoleProperty() = default;

vtkSIGodRaysRoleProperty::~vtkSIGodRaysRoleProperty() = default;

bool vtkSIGodRaysRoleProperty::Push(vtkSMMessage* message, int offset)
{
  this->SaveValueToCache(message, offset);
  auto representation = vtkAlgorithm::SafeDownCast(this->GetVTKObject());
  const Variant& value = message->GetExtension(ProxyState::property, offset).value();
  const int role = value.integer_size() == 1 ? value.integer(0) : -1;
  if (!representation || role < vtkGodRaysPass::AUTOMATIC || role > vtkGodRaysPass::MEDIUM)
  {
    vtkErrorMacro(
      "God Rays Role needs a representation and one of Automatic (0), Occluder (1), Light (2), "
      "Ignored (3) and Medium (4), not "
      << role << "; it stays as it was.");
    return true; // It has been told.
  }
  representation->GetInformation()->Set(vtkGodRaysPass::ROLE(), role);
  return true;
}

void vtkSIGodRaysRoleProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
