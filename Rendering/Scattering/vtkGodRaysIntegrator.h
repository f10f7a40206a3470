// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysIntegrator
 * @brief   how the light scattered towards the eye is summed: the base of all integrators
 *
 * A model says what is summed, an integrator evaluates it. What it is given to do so depends on the
 * effect: see vtkGodRaysRadialIntegrator and vtkGodRaysMediumIntegrator.
 *
 * @sa vtkGodRaysModel vtkGodRaysPass
 */

#ifndef vtkGodRaysIntegrator_h
#define vtkGodRaysIntegrator_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

class vtkGodRaysModel;
class vtkWindow;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysIntegrator : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysIntegrator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether this integrator can evaluate the model.
   */
  virtual bool Supports(vtkGodRaysModel* model) = 0;

  /**
   * What this integrator does for a model, in one line, for vtkGodRaysPass::GetPlan().
   */
  virtual std::string Describe(vtkGodRaysModel* model) = 0;

  /**
   * Free what is on the graphics card.
   */
  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;

protected:
  vtkGodRaysIntegrator() = default;
  ~vtkGodRaysIntegrator() override = default;

private:
  vtkGodRaysIntegrator(const vtkGodRaysIntegrator&) = delete;
  void operator=(const vtkGodRaysIntegrator&) = delete;
};

#endif
