// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialIntegrator
 * @brief   how the radial sum of an occlusion layer is evaluated
 *
 * vtkGodRaysPass calls Integrate() once for each light of a frame that has a vtkGodRaysRadialSumModel.
 *
 * @sa vtkGodRaysEpipolarIntegrator vtkGodRaysTapsIntegrator vtkGodRaysRadialSumModel
 */

#ifndef vtkGodRaysRadialIntegrator_h
#define vtkGodRaysRadialIntegrator_h

#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkWrappingHints.h"          // For VTK_WRAPEXCLUDE

class vtkGodRaysRadialSumModel;
class vtkGodRaysSum;
class vtkGodRaysTarget;
class vtkOpenGLRenderWindow;
struct vtkGodRaysLight;
struct vtkGodRaysMarch;
struct vtkGodRaysMarchParameters;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysRadialIntegrator : public vtkGodRaysIntegrator
{
public:
  vtkTypeMacro(vtkGodRaysRadialIntegrator, vtkGodRaysIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What an integrator gets to do its work. Layer and result are private to the module: integrators
  /// are written there, see CONTRIBUTING.md.
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr; ///< its context is current
    vtkGodRaysRadialSumModel* Model = nullptr;
    const vtkGodRaysLight* Light = nullptr;
    vtkGodRaysTarget* Layer =
      nullptr;              ///< its occlusion layer: RGB, or of one channel over its colour
    double ViewScale = 1.0; ///< fraction of the layer's width that the picture covers
    double ErrorTolerance = 1.0 / 255.0;
    vtkGodRaysSum* Result = nullptr; ///< the light scattered by all lights: add to it

    ///@{
    /// The march of the invariant sum, in uv and in pixels.
    vtkGodRaysMarchParameters GetMarchParameters() const;
    vtkGodRaysMarch GetMarch() const;
    ///@}
  };

  /**
   * In which format this integrator wants the layer of a light of one colour: GL_R16F or GL_R32F,
   * one value a pixel, or 0, like any other layer (unless overridden). precision is the format of
   * any other layer, GL_RGBA16F or GL_RGBA32F.
   */
  VTK_WRAPEXCLUDE virtual unsigned int GetOneColorFormat(
    vtkGodRaysModel* model, unsigned int precision);

  /**
   * Add the light of one layer to the result. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Integrate(const Request& request) = 0;

  bool Supports(vtkGodRaysModel* model) override;

protected:
  vtkGodRaysRadialIntegrator() = default;
  ~vtkGodRaysRadialIntegrator() override = default;

private:
  vtkGodRaysRadialIntegrator(const vtkGodRaysRadialIntegrator&) = delete;
  void operator=(const vtkGodRaysRadialIntegrator&) = delete;
};

#endif
