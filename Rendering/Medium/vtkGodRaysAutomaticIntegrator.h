// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAutomaticIntegrator
 * @brief   single scattering by the cheapest way that keeps the error asked for
 *
 * The default of vtkGodRaysMediumModel. For each light of a frame it takes
 *
 * - in perspective, a sweep over a shadow map: it sees the shadows of all props, whether the picture shows
 *   them or not, and is the closed form where no shadow can be seen. Of a directional light the map's size
 *   follows from vtkGodRaysPass::SetErrorTolerance(). From 0.008 on, as while a camera is dragged, one map
 *   serves for all places of the eye; below, there are four nested ones about the axis through the eye. Of
 *   a point light, a map or a cube of six has 1024 pixels a side and serves wherever the eye is;
 * - for parallel views, the picture's own depths (vtkGodRaysEpipolarCoverageIntegrator). They do not tell
 *   what is outside the picture or behind other things: the error is that of these depths, whatever the
 *   tolerance;
 * - for a directional light over a planet, and a spotlight that fades from an axis that is not vertical in
 *   an atmosphere, 32 steps through a shadow map, whatever the tolerance.
 *
 * Documentation/ModelError.md has the errors and the costs of all three.
 *
 * @sa vtkGodRaysShadowMapIntegrator vtkGodRaysEpipolarCoverageIntegrator vtkGodRaysMediumModel
 */

#ifndef vtkGodRaysAutomaticIntegrator_h
#define vtkGodRaysAutomaticIntegrator_h

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkNew.h"                    // For vtkNew

#include <string> // For std::string

class vtkGodRaysEpipolarCoverageIntegrator;
class vtkGodRaysShadowMapIntegrator;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysAutomaticIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static vtkGodRaysAutomaticIntegrator* New();
  vtkTypeMacro(vtkGodRaysAutomaticIntegrator, vtkGodRaysMediumIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  VTK_WRAPEXCLUDE bool Contribute(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysAutomaticIntegrator();
  ~vtkGodRaysAutomaticIntegrator() override;

private:
  vtkGodRaysAutomaticIntegrator(const vtkGodRaysAutomaticIntegrator&) = delete;
  void operator=(const vtkGodRaysAutomaticIntegrator&) = delete;

  void Choose(const Request& request);

  vtkNew<vtkGodRaysShadowMapIntegrator> Shadows;
  vtkNew<vtkGodRaysEpipolarCoverageIntegrator> Coverage;
  vtkGodRaysMediumIntegrator* Chosen = nullptr; // one of them, for the last light
};

#endif
