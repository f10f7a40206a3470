// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysCoverageFilter
 * @brief   light that a medium scatters once, shadowed by what a depth image holds; fast
 *
 * Evaluates the integral of vtkGodRaysMediumFilter, in closed form or from a table but for the shadows,
 * which are taken from the depth image by one sweep over it: for a directional light, an occluder of view
 * depth z in a pixel at the ratio u of this pixel's distance from the light hides the point of depth u z
 * of its view ray, for any pixel; other lights have a like rule. So each line through the light carries a
 * short list of hidden intervals, and a pixel sums what is left of the airlight. See
 * vtkGodRaysCoverageKernels.h. There is no step along the ray; the cost does not depend on the length of
 * shafts.
 *
 * What a depth image does not hold cannot be seen: surfaces outside the picture, behind others, and how
 * thick they are. Thickness stands for the latter, or with components of fronts and backs the solid
 * layers themselves. vtkGodRaysSingleScatteringReference measures what that costs; see
 * Documentation/Accuracy.md.
 *
 * Input: a 2-D vtkImageData, one slice, of float or double, view depths [scene units]: 1 component, the
 * first surface; or 2 or 4, the fronts and backs of one or two solid layers, the nearer first. Depths
 * that are not above 0 and below 1e30, infinity and NaN among them, are the open sky. Of the camera,
 * its axes and the view's size are used; positions are not, as depths are counted from the eye.
 *
 * Output: the radiance as a float image of the same extent: 1 component if LightColor and coefficients
 * are the same for red, green and blue, else 3. Bytes do not depend on the number of threads; on
 * processors with other vector instructions they differ by less than 1e-5 of the peak.
 *
 * Supported: directional and point lights anywhere (in the picture, beside it, behind the eye, across
 * the view), perspective and parallel projection, one or two components, homogeneous or of a density that
 * falls exponentially with height, over a plane or a planet. A planet's ground ends view rays, of point
 * lights where the depths show it. A view ray nearer to a point light than 0.28 pixels is taken to be so far
 * from it, since that is the mean over its pixel.
 *
 * Point lights and media of exponential density use a table of airlight, made anew when the camera, the
 * light or the medium change; what is read from it differs by less than 0.002 of the picture's peak, by less
 * than 0.004 where a planet's shadow is in it.
 *
 * An input or parameter that cannot be used is one error that says what to do, and the output is empty;
 * so it is after AbortExecute, which is looked at whenever progress is told, 4 times, on the calling
 * thread.
 *
 * @sa vtkGodRaysSingleScatteringReference
 */

#ifndef vtkGodRaysCoverageFilter_h
#define vtkGodRaysCoverageFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMediumFilter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkGodRaysCoverageSweep;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysCoverageFilter : public vtkGodRaysMediumFilter
{
public:
  static vtkGodRaysCoverageFilter* New();
  vtkTypeMacro(vtkGodRaysCoverageFilter, vtkGodRaysMediumFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how thick a surface is taken to be whose back is not known [fraction of its view depth].
   * Above 0.03, thin things cast too much shadow. Valid range: [0, 1]. Default is 0.01.
   */
  void SetThickness(double thickness);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Set/Get the name of a second array of the input, of 1 component, that holds where view rays end, for
   * things that are seen but cast no shadow, or the other way round. Default is "": where the nearest
   * thing that casts a shadow is.
   */
  vtkSetMacro(EndArrayName, std::string);
  vtkGetMacro(EndArrayName, std::string);
  ///@}

  /**
   * What the last execution did: layers, channels, lines, and how many hidden intervals found no room
   * in their line's list of 16 and were joined to the nearest.
   */
  std::string GetPlan() const;

  /**
   * The number of hidden intervals that found no room in the last execution.
   */
  long long GetNumberOfOverflows() const;

protected:
  vtkGodRaysCoverageFilter();
  ~vtkGodRaysCoverageFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysCoverageFilter(const vtkGodRaysCoverageFilter&) = delete;
  void operator=(const vtkGodRaysCoverageFilter&) = delete;

  std::unique_ptr<vtkGodRaysCoverageSweep> Sweep;

  double Thickness = 0.01;
  std::string EndArrayName;
};

#endif
