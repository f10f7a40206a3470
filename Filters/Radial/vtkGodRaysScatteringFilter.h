// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysScatteringFilter
 * @brief   the converged radial sum of an image, fast, on the processor
 *
 * Evaluates what vtkGodRaysReferenceFilter evaluates, to ErrorTolerance: the limit of
 * the sum of a vtkGodRaysRadialModel for any number of taps. With n = NumberOfSamples,
 * d = Decay and the march m(x) = vtkGodRays::MarchVector(LightClip, ndc(x), MarchScale) [uv],
 *
 *     L(x) = G integral_0^1 K(t) s(x + t Density m(x)) dt
 *     K(t) = e^(-k t)/phi(k),  phi(k) = (1 - e^-k)/k,  k = -n ln d
 *     G = Exposure Weight (1 - d^n)/(1 - d)   (n Exposure Weight for d = 1)
 *
 * where s is the image, bilinear between the centres of pixels and falling to 0 half a pixel beyond
 * the edges. The integral is evaluated by a sector sweep: running sums along lines through the
 * light, one pass over the image, at a cost that does not depend on NumberOfSamples. See
 * vtkGodRaysSectorSweep.h.
 *
 * Where the sweep cannot keep the tolerance, taps are summed instead, as closely as it takes, within
 * the image alone. That is so for marches below 8 pixels, images below 32 pixels one way (but not for
 * strips, where marches are longer than 128 pixels in the mean), Density above 1, kernels that end
 * within few pixels (k > 30), and most that grow (k < 0) where less than the way to the light is
 * marched. GetPlan() tells. It costs 10 to 100 times as much, but for short marches.
 * Tolerances below some 3e-4 of large pictures would take too many: there the finest sweep is done,
 * which keeps them on pictures of shapes, but not on black and white noise.
 *
 * Input: a 2-D vtkImageData (any extent in x and y, one slice) with 1 to 4 components of type
 * unsigned char, float or double. Bytes count as value/255. Components are independent, alpha
 * included. Spacing and origin have no influence. NaN and negative values count as 0, those above
 * the largest float (3.4e38, infinity included) as that.
 *
 * Output: the whole image, float, of the same extent and number of components. Bytes of the result
 * do not depend on the number of threads. On processors with other vector instructions they differ
 * by less than 1e-6 of the peak.
 *
 * An input that cannot be used is one error that says what to do, and the output is empty. The
 * output is empty, too, after AbortExecute, which is looked at whenever progress is told, on the
 * calling thread: up to 20 times if there is an observer of ProgressEvent, or where taps are summed.
 * Memory is kept for the next execution; ReleaseMemory() frees it.
 *
 * @sa vtkGodRaysReferenceFilter vtkGodRaysRadialModel
 */

#ifndef vtkGodRaysScatteringFilter_h
#define vtkGodRaysScatteringFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysRadialFilter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysScatteringFilter : public vtkGodRaysRadialFilter
{
public:
  static vtkGodRaysScatteringFilter* New();
  vtkTypeMacro(vtkGodRaysScatteringFilter, vtkGodRaysRadialFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the error that is accepted: root mean square over the pixels [fraction of the largest
   * one]. It is kept on pictures up to black and white noise from pixel to pixel; of a few single
   * bright pixels in a large dark picture it can be three times that. Single pixels along the edges
   * of shafts, most so behind thin features that point at the light, deviate by more. The number of
   * running sums, the distance of lines and the rows that are divided follow from it. Valid range:
   * [1e-5, 0.1]. Default is 1/255.
   */
  void SetErrorTolerance(double tolerance);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  /// How the integral is evaluated.
  enum MethodType
  {
    AUTOMATIC = 0, ///< SWEEP where it keeps the tolerance, TAPS elsewhere
    SWEEP = 1,     ///< also where only speed speaks against it: for tests
    TAPS = 2       ///< closely spaced: slow
  };

  ///@{
  /**
   * Set/Get how the integral is evaluated, one of MethodType. Default is AUTOMATIC.
   */
  vtkSetClampMacro(Method, int, AUTOMATIC, TAPS);
  vtkGetMacro(Method, int);
  ///@}

  /**
   * What the last execution did and why: method, running sums and the bound of their error, lines,
   * divided rows.
   */
  std::string GetPlan() const;

  /**
   * Free what is kept for the next execution. The output is not touched.
   */
  void ReleaseMemory();

protected:
  vtkGodRaysScatteringFilter();
  ~vtkGodRaysScatteringFilter() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysScatteringFilter(const vtkGodRaysScatteringFilter&) = delete;
  void operator=(const vtkGodRaysScatteringFilter&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  double ErrorTolerance = 1.0 / 255.0;
  int Method = AUTOMATIC;
};

#endif
