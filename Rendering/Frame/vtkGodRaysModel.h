// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysModel
 * @brief   what light the medium scatters towards the viewer
 *
 * A model holds the parameters of the medium and says what is summed along the way to the light; a
 * vtkGodRaysIntegrator evaluates it. This base is what vtkGodRaysPass needs to know of any model.
 *
 * @sa vtkGodRaysRadialModel vtkGodRaysIntegrator vtkGodRaysPass
 */

#ifndef vtkGodRaysModel_h
#define vtkGodRaysModel_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWrappingHints.h" // For VTK_NEWINSTANCE

#include <string> // For std::string

class vtkGodRaysIntegrator;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysModel : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How rays join the picture; the values are those of vtkGodRaysPass::BlendMode.
  enum BlendMode
  {
    ADD = 1,   ///< scene + rays
    SCREEN = 2 ///< scene + rays - min(scene * rays, 1)
  };

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
   * A new integrator, the one that the pass takes for this model unless it is given another: a
   * vtkGodRaysEpipolarIntegrator, unless overridden.
   */
  VTK_NEWINSTANCE virtual vtkGodRaysIntegrator* MakeIntegrator() const;

  /**
   * The result for a layer that is 1 everywhere, before any clamp: the brightest possible result
   * of a layer of values from 0 to 1 [no unit]. Errors are fractions of it.
   */
  virtual double GetFlatGain() const = 0;

  /**
   * The model and its parameters in one line, for vtkGodRaysPass::GetPlan().
   */
  virtual std::string Describe() const = 0;

  /**
   * Whether light is summed and blended as light (true, unless overridden), or as the values that
   * the display is sent, as many published shaders do.
   */
  virtual bool GetLinearLight() const { return true; }

  /**
   * Whether the march towards a light far outside the picture is capped, so that its shafts keep
   * their brightness (true, unless overridden), or always ends at the light, as published; then a
   * light behind the camera makes no shafts.
   */
  virtual bool CapsMarch() const { return true; }

  /**
   * How rays join the picture, one of BlendMode. ADD unless overridden.
   */
  virtual int GetBlend() const { return ADD; }

  /**
   * The factor on the scene's own colours when rays are added [no unit]. 1 unless overridden.
   */
  virtual double GetSceneGain() const { return 1.0; }

protected:
  vtkGodRaysModel() = default;
  ~vtkGodRaysModel() override = default;

private:
  vtkGodRaysModel(const vtkGodRaysModel&) = delete;
  void operator=(const vtkGodRaysModel&) = delete;
};

#endif
