// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysModel
 * @brief   what light the medium scatters towards the viewer
 *
 * A model holds the parameters and says what is summed; a vtkGodRaysIntegrator evaluates it. This base is
 * what vtkGodRaysPass needs to know of any model. Models are written in this module, which has the effects
 * that they make: see CONTRIBUTING.md.
 *
 * @sa vtkGodRaysRadialModel vtkGodRaysMediumModel vtkGodRaysIntegrator vtkGodRaysPass
 */

#ifndef vtkGodRaysModel_h
#define vtkGodRaysModel_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWrappingHints.h" // For VTK_NEWINSTANCE

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkGodRaysEffect;
class vtkGodRaysIntegrator;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysModel : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set parameters to those of this name. Returns false, with an error that lists the names, for a name
   * that is none of them; a model has none unless this is overridden.
   */
  virtual bool ApplyPreset(const char* name);

  /**
   * Whether the parameters change any picture. If not, the pass draws the scene straight through.
   */
  virtual bool CanScatter() const = 0;

  /**
   * A new integrator, the one that the pass takes for this model unless it is given another.
   */
  VTK_NEWINSTANCE virtual vtkGodRaysIntegrator* MakeIntegrator() const = 0;

  /**
   * The model and its parameters in one line, for vtkGodRaysPass::GetPlan().
   */
  virtual std::string Describe() const = 0;

  /**
   * What draws the model. The model must outlive it.
   */
  VTK_WRAPEXCLUDE virtual std::unique_ptr<vtkGodRaysEffect> MakeEffect() = 0;

protected:
  vtkGodRaysModel() = default;
  ~vtkGodRaysModel() override = default;

private:
  vtkGodRaysModel(const vtkGodRaysModel&) = delete;
  void operator=(const vtkGodRaysModel&) = delete;
};

#endif
