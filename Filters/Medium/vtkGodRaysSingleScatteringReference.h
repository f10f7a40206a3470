// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSingleScatteringReference
 * @brief   light that a medium scatters once between surfaces, to a tolerance: the ground truth
 *
 * Evaluates the integral of vtkGodRaysMediumFilter with the visibility of the light from every point of
 * every view ray. A view ray and the light span a plane, which cuts triangles into line segments; what
 * of the ray each segment hides from the light is one interval, whose ends are known in closed form. So
 * the lit parts of the ray are exact but for rounding: no steps, no shadow rays, no bias, and nothing
 * can be missed between samples. The integral over each lit part is evaluated by adaptive Gauss-Kronrod
 * quadrature of 15 points in double precision, to Tolerance. A ray straight at or away from the light,
 * within 1e-9 radians, is lit beyond its last, or before its first, surface.
 *
 * Input: vtkPolyData, the occluders, in world coordinates: polygons, which are convex, and triangle
 * strips; both sides block. Without input nothing blocks. Cost: each ray looks at the triangles in its
 * plane, found by a tree of boxes: of the order of 10 us in scenes of 100 000 triangles.
 *
 * Second input, optional: vtkPolyData at which view rays end, in place of the occluders: what is seen
 * but casts no shadow is in this one alone, what casts shadows unseen in the first alone.
 *
 * Third input, optional, any number of them: vtkImageData, media of data. The optical depth of a cell along a
 * line is exact but for rounding. What is scattered is integrated between places where a view ray, or the
 * light's way to it, goes from one cell to another, and the light's optical depth through data is summed anew
 * at each place: of the order of 1 ms for each pixel of data with 50 cells along each axis, at a Tolerance
 * of 1e-6.
 *
 * Output: vtkImageData of Size pixels with arrays of doubles: "Radiance", the scalars, of red,
 * green and blue; "Transmittance", of all media between the eye and the end of the view ray; "Depth", the
 * view depth of the first occluder, infinity where there is none; and "End", that of what ends the view
 * ray.
 *
 * Bytes do not depend on the number of threads. AbortExecute is looked at whenever progress is told,
 * 20 times, on the calling thread; the output is empty then, as after an error.
 */

#ifndef vtkGodRaysSingleScatteringReference_h
#define vtkGodRaysSingleScatteringReference_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysGridMediumFilter.h"

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysSingleScatteringReference
  : public vtkGodRaysGridMediumFilter
{
public:
  static vtkGodRaysSingleScatteringReference* New();
  vtkTypeMacro(vtkGodRaysSingleScatteringReference, vtkGodRaysGridMediumFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the accepted error of each lit part's quadrature [fraction of the pixel without
   * occluders]. Valid range: [1e-12, 1e-2]. Default is 1e-9.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkGodRaysSingleScatteringReference();
  ~vtkGodRaysSingleScatteringReference() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysSingleScatteringReference(const vtkGodRaysSingleScatteringReference&) = delete;
  void operator=(const vtkGodRaysSingleScatteringReference&) = delete;

  double Tolerance = 1e-9;
};

#endif
