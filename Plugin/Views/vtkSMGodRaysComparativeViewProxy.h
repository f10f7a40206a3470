// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGodRaysComparativeViewProxy
 * @brief   several vtkGodRaysRenderView with the same parameters, also of their model and integrator
 *
 * ParaView links the parameters of what can be chosen in a list, such as models, between the views of a
 * comparison, if these are there when the first view is made. Here they are.
 */

#ifndef vtkSMGodRaysComparativeViewProxy_h
#define vtkSMGodRaysComparativeViewProxy_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkSMComparativeViewProxy.h"

class VTKGODRAYSVIEWS_EXPORT vtkSMGodRaysComparativeViewProxy : public vtkSMComparativeViewProxy
{
public:
  static vtkSMGodRaysComparativeViewProxy* New();
  vtkTypeMacro(vtkSMGodRaysComparativeViewProxy, vtkSMComparativeViewProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMGodRaysComparativeViewProxy();
  ~vtkSMGodRaysComparativeViewProxy() override;

  /**
   * Overridden to make all models and integrators before the first view.
   */
  void CreateVTKObjects() override;

private:
  vtkSMGodRaysComparativeViewProxy(const vtkSMGodRaysComparativeViewProxy&) = delete;
  void operator=(const vtkSMGodRaysComparativeViewProxy&) = delete;
};

#endif
