// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGodRaysComparativeViewProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMProxyListDomain.h"

vtkStandardNewMacro(vtkSMGodRaysComparativeViewProxy);

vtkSMGodRaysComparativeViewProxy::vtkSMGodRaysComparativeViewProxy() = default;

vtkSMGodRaysComparativeViewProxy::~vtkSMGodRaysComparativeViewProxy() = default;

void vtkSMGodRaysComparativeViewProxy::CreateVTKObjects()
{
  if (!this->ObjectsCreated && this->Location != 0) // 0: a prototype
  {
    for (const char* name : { "Model", "Integrator" })
    {
      auto choice = this->GetProperty(name)->FindDomain<vtkSMProxyListDomain>();
      choice->CreateProxies(this->GetSessionProxyManager());
    }
  }
  this->Superclass::CreateVTKObjects();
}

void vtkSMGodRaysComparativeViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
