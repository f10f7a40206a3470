// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysIntegrator
 * @brief   how the light scattered towards the eye is summed: the interface of all integrators
 *
 * A model says what is summed over an occlusion layer, an integrator evaluates it. vtkGodRaysPass
 * calls Integrate() once for each light of a frame.
 *
 * @sa vtkGodRaysTapsIntegrator vtkGodRaysModel vtkGodRaysPass
 */

#ifndef vtkGodRaysIntegrator_h
#define vtkGodRaysIntegrator_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

class vtkGodRaysModel;
class vtkGodRaysTarget;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysIntegrator : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysIntegrator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What an integrator gets to do its work. Its target is private to the module: integrators are
  /// written there, see CONTRIBUTING.md.
  struct Request
  {
    vtkOpenGLRenderWindow* Window; ///< its context is current
    vtkGodRaysModel* Model;
    vtkTextureObject* Layer; ///< the occlusion layer of one light, RGB
    double LightClip[3];     ///< X, Y and w of the light in the layer's clip coordinates
    double MarchScale;       ///< see MarchVector() in vtkGodRaysFunctions.glsl
    double ViewScale;        ///< fraction of the layer's width that the picture covers
    double Peak;             ///< greatest value that the layer may hold
    double ResolutionScale;
    double ErrorTolerance;
    vtkGodRaysTarget* Result; ///< the light scattered by all lights: add to it
  };

  /**
   * Whether this integrator can evaluate the model.
   */
  virtual bool Supports(vtkGodRaysModel* model) = 0;

  /**
   * Add the light of one layer to the result. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Integrate(const Request& request) = 0;

  /**
   * What this integrator does for a model, in one line, for vtkGodRaysPass::GetPlan().
   */
  virtual std::string Describe(vtkGodRaysModel* model, double resolutionScale) = 0;

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
