// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysScatteringFilter
 * @brief   the converged radial sum of an image, fast, on the processor
 *
 * Evaluates what vtkGodRaysReferenceFilter evaluates, to ErrorTolerance: the limit of
 * vtkGodRaysRadialModel's INVARIANT formulation for any number of taps. With n = NumberOfSamples,
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
 * the image alone. That is so for marches below 8 pixels, images below 32 pixels, Density above 1,
 * kernels that end within few pixels (k > 30), and most that grow (k < 0) where less than the way to
 * the light is marched. GetPlan() tells. It costs 10 to 100 times as much, but for short marches.
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
 * An input that cannot be used is one error that says what to do, and the output is empty.
 * Memory is kept for the next execution; ReleaseMemory() frees it.
 *
 * @sa vtkGodRaysReferenceFilter vtkGodRaysRadialModel
 */

#ifndef vtkGodRaysScatteringFilter_h
#define vtkGodRaysScatteringFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysScatteringFilter : public vtkImageAlgorithm
{
public:
  static vtkGodRaysScatteringFilter* New();
  vtkTypeMacro(vtkGodRaysScatteringFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how far towards the light the march goes [fraction of the way]. Above 1 it goes past
   * the light. 0 leaves every pixel by itself, times G. NaN and infinities are an error and change
   * nothing, as for all real parameters. Valid range: [0, 2]. Default is 0.97.
   */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor from one of the NumberOfSamples samples to the next one towards the light
   * [no unit]. Above 1 the samples near the light count most. Valid range: [0, 1.05].
   * Default is 0.98.
   */
  void SetDecay(double decay);
  vtkGetMacro(Decay, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on each of the NumberOfSamples samples [no unit]. 0 means no rays.
   * Valid range: [0, 100]. Default is 0.03.
   */
  void SetWeight(double weight);
  vtkGetMacro(Weight, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on the whole sum [no unit]. 0 means no rays. Valid range: [0, 100].
   * Default is 1.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of samples that Decay and Weight refer to [no unit]. It is no cost.
   * Valid range: [1, 1024]. Default is 100.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 1024);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Set/Get the light's clip coordinates (X, Y, w): it is seen at (X/w, Y/w), where (-1, -1) is the
   * picture's lower left corner and (1, 1) its upper right one; w = 0 is a light at infinity, w < 0
   * one behind the camera. Infinite numbers and NaN are an error and change nothing. Valid range:
   * [-1e30, 1e30] each. Default is (0, 0, 1), the picture's centre.
   */
  void SetLightClip(double x, double y, double w);
  void SetLightClip(const double light[3]) { this->SetLightClip(light[0], light[1], light[2]); }
  vtkGetVector3Macro(LightClip, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor of vtkGodRays::MarchVector [1/clip unit]: 1/w marches exactly to the light.
   * Valid range: [-1e30, 1e30]. Default is 1.
   */
  void SetMarchScale(double scale);
  vtkGetMacro(MarchScale, double);
  ///@}

  /**
   * Put the light at a point of the picture [fractions of its width and height; (0, 0) is the lower
   * left corner, (1, 1) the upper right one; it may lie outside], and march exactly to it: sets
   * LightClip and MarchScale.
   */
  void SetLightPosition(double u, double v);

  /**
   * Put the light at infinity, so that all shafts are parallel: (du, dv) is the march of every pixel
   * towards the light [fractions of the picture's width and height], of which Density is a part.
   * Sets LightClip and MarchScale.
   */
  void SetLightDirection(double du, double dv);

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
    SWEEP = 1,     ///< SWEEP also where only speed speaks against it: for tests
    TAPS = 2       ///< taps, closely spaced: slow
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

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysScatteringFilter(const vtkGodRaysScatteringFilter&) = delete;
  void operator=(const vtkGodRaysScatteringFilter&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  double Density = 0.97;
  double Decay = 0.98;
  double Weight = 0.03;
  double Exposure = 1.0;
  double LightClip[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;
  double ErrorTolerance = 1.0 / 255.0;
  int NumberOfSamples = 100;
  int Method = AUTOMATIC;
};

#endif
