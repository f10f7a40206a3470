// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSIGodRaysRoleProperty
 * @brief   ParaView's property God Rays Role: what a representation does to light
 *
 * A representation has no method for it, so that its role, one of vtkGodRaysPass::Role, is kept in the
 * representation's vtkAlgorithm::GetInformation(), under vtkGodRaysPass::ROLE(); absent means AUTOMATIC. A
 * vtkGodRaysRenderView reads it before each frame, and other views never do.
 *
 * Any other role is an error and changes nothing.
 */

#ifndef vtkSIGodRaysRoleProperty_h
#define vtkSIGodRaysRoleProperty_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkSIIntVectorProperty.h"

class VTKGODRAYSVIEWS_EXPORT vtkSIGodRaysRoleProperty : public vtkSIIntVectorProperty
{
public:
  static vtkSIGodRaysRoleProperty* New();
  vtkTypeMacro(vtkSIGodRaysRoleProperty, vtkSIIntVectorProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSIGodRaysRoleProperty();
  ~vtkSIGodRaysRoleProperty() override;

  bool Push(vtkSMMessage* message, int offset) override;

private:
  vtkSIGodRaysRoleProperty(const vtkSIGodRaysRoleProperty&) = delete;
  void operator=(const vtkSIGodRaysRoleProperty&) = delete;
};

#endif
