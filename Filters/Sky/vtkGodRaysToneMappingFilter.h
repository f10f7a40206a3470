// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysToneMappingFilter
 * @brief   shows a picture of light: exposure, tone curve, and the sRGB transfer, once
 *
 * The exposure is found from the picture's luminance: its geometric mean becomes Key [Reinhard2002].
 * Pixels without light, such as those around a paraboloid's disc, do not count. GetUsedExposure() gives it
 * to others, as vtkToneMappingPass and vtkGodRaysSkyPass.
 *
 * Input: vtkImageData with scalars of 1 component (grey) or 3 and more (red, green, blue), linear light of
 * any unit, of any type, taken as it is. Negative values and NaN count as 0; values above 1e30 as that.
 *
 * Output: the same extent, unsigned char, 1 component or 3, encoded by sRGB's transfer. It needs the whole
 * extent. An input that cannot be used is one error, and the output is empty.
 *
 * @sa vtkGodRaysSkySource vtkGodRaysHDRWriter vtkToneMappingPass
 */

#ifndef vtkGodRaysToneMappingFilter_h
#define vtkGodRaysToneMappingFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysToneMappingFilter : public vtkImageAlgorithm
{
public:
  static vtkGodRaysToneMappingFilter* New();
  vtkTypeMacro(vtkGodRaysToneMappingFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get whether the exposure is found from the picture: the geometric mean of its luminance becomes Key.
   * Default is on.
   */
  vtkSetMacro(AutomaticExposure, bool);
  vtkGetMacro(AutomaticExposure, bool);
  vtkBooleanMacro(AutomaticExposure, bool);
  ///@}

  ///@{
  /**
   * Set/Get what the geometric mean of the luminance becomes by an automatic exposure [linear light, 1 is
   * white]. Valid range: [0.001, 1]. Default is 0.18, a grey card; 0.09 and 0.36 suit dark and bright
   * pictures.
   */
  void SetKey(double key);
  vtkGetMacro(Key, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on light if it is not automatic [1/unit of the light]. Valid range: [0, 1e30].
   * Default is 1.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  /// From exposed light to what is shown.
  enum CurveType
  {
    CLAMP = 0,   ///< as it is, up to 1
    REINHARD = 1 ///< c (1 + c/WhitePoint^2)/(1 + c), for each colour for itself
  };

  ///@{
  /**
   * Set/Get how exposed light c is shown, one of CurveType. Default is REINHARD.
   */
  vtkSetClampMacro(Curve, int, CLAMP, REINHARD);
  vtkGetMacro(Curve, int);
  ///@}

  ///@{
  /**
   * Set/Get the exposed light that REINHARD makes white [linear light]; brighter light is white, too.
   * Valid range: [1, 1e15]. Default is 1e15, at which nothing is: c/(1 + c).
   */
  void SetWhitePoint(double light);
  vtkGetMacro(WhitePoint, double);
  ///@}

  /**
   * The factor on light in the last update [1/unit of the light]; 1 for a picture without light.
   */
  vtkGetMacro(UsedExposure, double);

  /**
   * The linear light of a value that is shown, from 0 to 1: the inverse of the transfer. Above 1 the curve
   * goes on. Negative values count as 0. [IEC61966-2-1]
   */
  static double Decode(double shown);

protected:
  vtkGodRaysToneMappingFilter() = default;
  ~vtkGodRaysToneMappingFilter() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  bool AutomaticExposure = true;
  double Key = 0.18;
  double Exposure = 1.0;
  int Curve = REINHARD;
  double WhitePoint = 1e15;
  double UsedExposure = 1.0;

private:
  vtkGodRaysToneMappingFilter(const vtkGodRaysToneMappingFilter&) = delete;
  void operator=(const vtkGodRaysToneMappingFilter&) = delete;
};

#endif
