// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAutomaticIntegrator
 * @brief   single scattering by the cheapest way that keeps the error asked for
 *
 * The default of vtkGodRaysMediumModel. For each light of a frame it walks view rays through a shadow map: it
 * sees the shadows of all props, whether the picture shows them or not, and is the closed form where no
 * shadow can be seen. Of a directional light, seen in perspective, there are four nested maps about the axis
 * through the eye; else one, or a cube of six about a lamp, which serves while the camera moves. The maps'
 * size and the number of rays follow from vtkGodRaysPass::SetErrorTolerance(). While a camera is dragged, to
 * a tolerance above 0.009, there is one map in the place of nested ones.
 *
 * Where VerifyPixels has found an error above the tolerance, the next frames take a map for a smaller one,
 * until the tolerance changes.
 *
 * Documentation/ModelError.md has the errors and the costs.
 *
 * @sa vtkGodRaysShadowMapIntegrator vtkGodRaysMediumModel
 */

#ifndef vtkGodRaysAutomaticIntegrator_h
#define vtkGodRaysAutomaticIntegrator_h

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkNew.h"                    // For vtkNew

#include <string> // For std::string

class vtkGodRaysShadowMapIntegrator;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysAutomaticIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static vtkGodRaysAutomaticIntegrator* New();
  vtkTypeMacro(vtkGodRaysAutomaticIntegrator, vtkGodRaysMediumIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  VTK_WRAPEXCLUDE bool Contribute(const Request& request) override;
  VTK_WRAPEXCLUDE const vtkGodRaysShadowGrids* GetShadows() override;
  VTK_WRAPEXCLUDE const vtkGodRaysShadowGrids* DrawShadows(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysAutomaticIntegrator();
  ~vtkGodRaysAutomaticIntegrator() override;

private:
  vtkGodRaysAutomaticIntegrator(const vtkGodRaysAutomaticIntegrator&) = delete;
  void operator=(const vtkGodRaysAutomaticIntegrator&) = delete;

  /// Sets up the shadow maps. Returns the request with the tolerance as corrected.
  Request Choose(const Request& request);
  double GetCorrectedTolerance(const Request& request);

  vtkNew<vtkGodRaysShadowMapIntegrator> Shadows;
  double Tolerance = 0.0;  // that was asked for last
  double Correction = 1.0; // what it is times
  unsigned int Frame = 0;  // in which that was looked at
};

#endif
