// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysEpipolarCoverageIntegrator
 * @brief   single scattering with the shadows of all that the depth of the picture holds
 *
 * Whatever is seen at view depth z hides light from the point of
 * depth u z on the view rays of the pixels beyond it on the line from the light, at u times this pixel's
 * distance from the light; so each line through the light carries a short list of hidden intervals, and
 * a pixel sums in closed form, or from a table, what is left of the airlight. There is no step
 * along the ray, and the cost does not depend on the length of shafts. It runs on the processor, with
 * vtkSMPTools, over depths that are read back from the graphics card; see vtkGodRaysCoverageFilter.
 *
 * The depth of the picture does not hold what is outside it or behind other things, nor how thick
 * things are: a surface is taken to be Thickness thick, unless there are NumberOfLayers. What that costs
 * stands in Documentation/ModelError.md.
 *
 * @sa vtkGodRaysMediumModel vtkGodRaysCoverageFilter
 */

#ifndef vtkGodRaysEpipolarCoverageIntegrator_h
#define vtkGodRaysEpipolarCoverageIntegrator_h

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysEpipolarCoverageIntegrator
  : public vtkGodRaysMediumIntegrator
{
public:
  static vtkGodRaysEpipolarCoverageIntegrator* New();
  vtkTypeMacro(vtkGodRaysEpipolarCoverageIntegrator, vtkGodRaysMediumIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how thick a surface is taken to be [fraction of its view depth]. Above 0.03, thin things
   * cast too much shadow. Valid range: [0, 1]. Default is 0.01.
   */
  void SetThickness(double thickness);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Set/Get how many layers of solid things are known [no unit]. 0: the first surface alone, Thickness
   * thick. 1: also where view rays leave the first thing; 2: also where they enter and leave the second
   * one, which takes 1 or 3 more renderings of the occluders. Things must be closed, with polygons
   * that face outwards; what has no back is Thickness thick. A scene on several processes has none, which
   * is told once.
   * Valid range: [0, 2]. Default is 0.
   */
  vtkSetClampMacro(NumberOfLayers, int, 0, 2);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysEpipolarCoverageIntegrator();
  ~vtkGodRaysEpipolarCoverageIntegrator() override;

private:
  vtkGodRaysEpipolarCoverageIntegrator(const vtkGodRaysEpipolarCoverageIntegrator&) = delete;
  void operator=(const vtkGodRaysEpipolarCoverageIntegrator&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;

  double Thickness = 0.01;
  int NumberOfLayers = 0;
};

#endif
