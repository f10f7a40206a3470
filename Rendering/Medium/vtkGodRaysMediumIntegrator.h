// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumIntegrator
 * @brief   how the light that a medium scatters along view rays is evaluated
 *
 * vtkGodRaysPass calls Integrate() once for each light of a frame that has a vtkGodRaysMediumModel.
 *
 * @sa vtkGodRaysShadowMapIntegrator vtkGodRaysMediumModel
 */

#ifndef vtkGodRaysMediumIntegrator_h
#define vtkGodRaysMediumIntegrator_h

#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkWrappingHints.h"          // For VTK_WRAPEXCLUDE

#include <vector> // For std::vector

class vtkGodRaysCompositor;
class vtkGodRaysSum;
class vtkGodRaysViewDepths;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
struct vtkGodRaysMedium;
struct vtkGodRaysLight;
struct vtkGodRaysShadowGrids;
struct vtkGodRaysView;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysMediumIntegrator : public vtkGodRaysIntegrator
{
public:
  vtkTypeMacro(vtkGodRaysMediumIntegrator, vtkGodRaysIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What an integrator gets to do its work. It is private to the module: integrators are written there,
  /// see CONTRIBUTING.md.
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr; ///< its context is current
    vtkRenderer* Renderer = nullptr;
    const vtkGodRaysMedium* Medium = nullptr; ///< in scene units
    const vtkGodRaysView* View = nullptr;
    const vtkGodRaysLight* Light = nullptr;
    vtkGodRaysViewDepths* Depths = nullptr;
    const std::vector<vtkProp*>* Occluders = nullptr; ///< these props block light
    vtkGodRaysCompositor* Compositor = nullptr;       ///< of a scene on several processes
    double Share = 0.5; ///< of a nested face in the one before [fraction]
    /// Of the camera; with it, a sun's faces take steps as the eye moves. Infinite: one face is about all
    /// occluders, wherever the eye is.
    double Focus = 0.0;
    double Nearest = 0.0; ///< distance from a lamp from which on its cube of maps must see things
    double Overlap = 0.0; ///< by which its faces reach into the next ones [of half a face]
    bool WantsLayers = true;   ///< of what lets light through; false where there is no picture
    bool WantsShadows = false; ///< GetShadows() is called afterwards
    vtkGodRaysSum* Result = nullptr;     ///< the light scattered by all lights: add to it
    double ErrorTolerance = 1.0 / 255.0; ///< of this frame; see vtkGodRaysPass
    bool Interactive = false;            ///< the user drags the camera, or the like
    double LastError = -1.0;             ///< that was measured in the last frame; -1: none was
  };

  /**
   * Add what the medium scatters of the light to the result. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Integrate(const Request& request) = 0;

  /**
   * Take part in Integrate() on a process that has no picture: the calls of a compositor that it
   * makes. Depths and Result are null. Unless overridden, nothing. Returns false, after an error, if
   * that failed.
   */
  VTK_WRAPEXCLUDE virtual bool Contribute(const Request& request);

  ///@{
  /**
   * What hides the light of the last request, as numbers that are valid until the next one; or draw that
   * alone, without light. Unless overridden, null: it is not known, and volumes in the medium are not drawn.
   */
  VTK_WRAPEXCLUDE virtual const vtkGodRaysShadowGrids* GetShadows() { return nullptr; }
  VTK_WRAPEXCLUDE virtual const vtkGodRaysShadowGrids* DrawShadows(const Request&)
  {
    return nullptr;
  }
  ///@}

  bool Supports(vtkGodRaysModel* model) override;

protected:
  vtkGodRaysMediumIntegrator() = default;
  ~vtkGodRaysMediumIntegrator() override = default;

private:
  vtkGodRaysMediumIntegrator(const vtkGodRaysMediumIntegrator&) = delete;
  void operator=(const vtkGodRaysMediumIntegrator&) = delete;
};

#endif
