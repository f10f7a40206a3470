// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysIntegrator
 * @brief   how the light scattered towards the eye is summed: the interface of all integrators
 *
 * A model says what is summed, over an occlusion layer or along view rays; an integrator evaluates it. vtkGodRaysPass
 * calls Integrate() once for each light of a frame.
 *
 * @sa vtkGodRaysTapsIntegrator vtkGodRaysModel vtkGodRaysPass
 */

#ifndef vtkGodRaysIntegrator_h
#define vtkGodRaysIntegrator_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkGodRaysCompositor;
class vtkGodRaysModel;
class vtkGodRaysSum;
class vtkGodRaysTarget;
class vtkGodRaysViewDepths;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkWindow;
struct vtkGodRaysMedium;
struct vtkGodRaysSource;
struct vtkGodRaysView;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysIntegrator : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysIntegrator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What an integrator gets to do its work. Layer and result are private to the module: integrators
  /// are written there, see CONTRIBUTING.md.
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr; ///< its context is current
    vtkGodRaysModel* Model = nullptr;
    vtkGodRaysTarget* Layer = nullptr;   ///< occlusion layer of one light: RGB, or of one channel
    double Color[3] = { 1.0, 1.0, 1.0 }; ///< factor on a layer of one channel
    double LightClip[3] = { 0.0, 0.0, 1.0 }; ///< X, Y and w of the light, in the layer
    double MarchScale = 1.0;                 ///< see MarchVector() in vtkGodRaysRadialMath.glsl
    double ViewScale = 1.0; ///< fraction of the layer's width that the picture covers
    double Peak = 1.0;      ///< greatest value that the layer, times Color, may hold
    double ResolutionScale = 1.0;
    double ErrorTolerance = 1.0 / 255.0;
    vtkGodRaysSum* Result = nullptr; ///< the light scattered by all lights: add to it

    ///@{
    /// Of a vtkGodRaysMediumModel, which has no layer; null for others.
    const vtkGodRaysMedium* Medium = nullptr; ///< in scene units
    const vtkGodRaysView* View = nullptr;
    const vtkGodRaysSource* Source = nullptr;
    vtkGodRaysViewDepths* Depths = nullptr;
    vtkRenderer* Renderer = nullptr;
    const std::vector<vtkProp*>* Blocking = nullptr; ///< their opaque parts block light
    vtkGodRaysCompositor* Compositor = nullptr;      ///< of a scene on several processes
    ///@}
  };

  /**
   * In which format this integrator wants the layer of a light of one colour: GL_R16F or GL_R32F,
   * one value a pixel, or 0, like any other layer (unless overridden). precision is the format of
   * any other layer, GL_RGBA16F or GL_RGBA32F.
   */
  virtual unsigned int GetOneColorFormat(
    vtkOpenGLRenderWindow* window, vtkGodRaysModel* model, unsigned int precision);

  /**
   * Whether this integrator can evaluate the model.
   */
  virtual bool Supports(vtkGodRaysModel* model) = 0;

  /**
   * Add the light of one layer to the result. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Integrate(const Request& request) = 0;

  /**
   * Take part in Integrate() on a process that has no picture: the calls of a compositor that it
   * makes. Depths and Result are null. Unless overridden, nothing. Returns false, after an error, if
   * that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Contribute(const Request& request);

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
