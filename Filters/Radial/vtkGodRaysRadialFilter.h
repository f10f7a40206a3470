// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialFilter
 * @brief   what the filters that evaluate the radial integral of an image share
 *
 * The parameters of the integral, the light, and what can be an input; subclasses evaluate it.
 *
 * @sa vtkGodRaysReferenceFilter vtkGodRaysScatteringFilter
 */

#ifndef vtkGodRaysRadialFilter_h
#define vtkGodRaysRadialFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string> // For std::string

class vtkDataArray;
class vtkImageData;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysRadialFilter : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkGodRaysRadialFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How many components an input may have.
  static constexpr int MaximumComponents = 4;

  ///@{
  /**
   * Set/Get how far towards the light the march goes [fraction of the way]. Above 1 it goes past the light.
   * 0 leaves every pixel by itself. NaN and infinities are an error and change nothing, as for all real
   * parameters. Valid range: [0, 2]. Default is 0.97.
   */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor from one of the NumberOfSamples samples to the next one towards the light
   * [no unit]. Above 1 the samples near the light count most. Valid range: [0, 1.05].
   * Default is 1.
   */
  void SetDecay(double decay);
  vtkGetMacro(Decay, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on each of the NumberOfSamples samples [no unit]. 0 means no rays.
   * Valid range: [0, 100]. Default is 0.013.
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
   * Valid range: [1, 10000]. Default is 100.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 10000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Set/Get the light's clip coordinates (X, Y, w): it is seen at (X/w, Y/w), where (-1, -1) is the
   * picture's lower left corner and (1, 1) its upper right one; it may lie outside. With w = 0 it is at
   * infinity, and its shafts are parallel; with w < 0 it is behind the camera. Infinite numbers and NaN are
   * an error and change nothing. Valid range: [-1e30, 1e30] each. Default is (0, 0, 1), the picture's
   * centre.
   */
  void SetLightClip(double x, double y, double w);
  void SetLightClip(const double light[3]) { this->SetLightClip(light[0], light[1], light[2]); }
  vtkGetVector3Macro(LightClip, double);
  ///@}

  ///@{
  /**
   * Set/Get the march's length in units of the way to the light, times 1/w [1/clip unit]: 1/w marches
   * exactly to the light. See vtkGodRays::MarchVector. Valid range: [-1e30, 1e30]. Default is 1.
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
   * Put the light at infinity, so that all shafts are parallel: (du, dv) is the march of every
   * pixel towards the light [fractions of the picture's width and height], of which Density is a
   * part. Sets LightClip and MarchScale.
   */
  void SetLightDirection(double du, double dv);

protected:
  vtkGodRaysRadialFilter() = default;
  ~vtkGodRaysRadialFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /// Of the result's numbers.
  virtual int GetResultType() const { return VTK_FLOAT; }

  /**
   * The input's values. Null after an error that says why they cannot be used: then the output is empty.
   */
  vtkDataArray* GetUsableScalars(vtkInformationVector** input, vtkInformationVector* output);

  /**
   * Tell the progress [fraction]; false if someone has told the filter to stop. On the thread that
   * executes it only.
   */
  bool TellProgress(double progress);

  double Density = 0.97;
  double Decay = 1.0;
  double Weight = 0.013;
  double Exposure = 1.0;
  double LightClip[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;
  int NumberOfSamples = 100;

private:
  vtkGodRaysRadialFilter(const vtkGodRaysRadialFilter&) = delete;
  void operator=(const vtkGodRaysRadialFilter&) = delete;
};

#endif
