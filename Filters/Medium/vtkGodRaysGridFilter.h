// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridFilter
 * @brief   light that media of data scatter once, fast and to a tolerance
 *
 * What vtkGodRaysSingleScatteringReference integrates for media of data, for pictures: the light's optical
 * depths through data are computed once, at an eighth as many places as data have but at least 40 along each
 * axis, and kept, in a sixteenth of the data's memory, until data or light change; empty space is skipped;
 * steps are as long, and pixels evaluated as far apart, as ErrorTolerance lets them be. Numbers without
 * OpenGL.
 *
 * Input: vtkImageData, media of data, up to 32, in one another if need be; see vtkGodRaysGridMediumFilter.
 * Second input, optional: a picture of Size pixels whose scalars are the view depths at which rays end; what
 * is not above 0 ends none. What it shows throws no shadow here.
 *
 * Output: vtkImageData of Size pixels with arrays of floats: "Radiance", the scalars, of red, green and
 * blue: what data scatter, and what they take from the light of the medium of formulas before, in and behind
 * them, which makes it negative where smoke dims bright haze. The sum with that medium's own radiance is the
 * whole. "Transmittance": of data between the eye and the end of the ray.
 *
 * Errors: RMSE against the reference below the tolerance for data whose structures are some four points wide.
 * The light's depths, known at every other point, are what remains: for narrower ones the error may be
 * twice as large, whatever the tolerance. Data that are narrower than 8 pixels in the picture, and shadows
 * that are, may be missed between pixels. Cost: Documentation/Evidence/Accuracy.md.
 *
 * @sa vtkGodRaysSingleScatteringReference
 */

#ifndef vtkGodRaysGridFilter_h
#define vtkGodRaysGridFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysGridMediumFilter.h"

#include <memory> // For std::unique_ptr

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysGridFilter : public vtkGodRaysGridMediumFilter
{
public:
  static vtkGodRaysGridFilter* New();
  vtkTypeMacro(vtkGodRaysGridFilter, vtkGodRaysGridMediumFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the accepted error [fraction of the picture's largest radiance]. Valid range: [1e-5, 0.1].
   * Default is 1/255.
   */
  void SetErrorTolerance(double tolerance);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

protected:
  vtkGodRaysGridFilter();
  ~vtkGodRaysGridFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysGridFilter(const vtkGodRaysGridFilter&) = delete;
  void operator=(const vtkGodRaysGridFilter&) = delete;

  double ErrorTolerance = 1.0 / 255.0;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
