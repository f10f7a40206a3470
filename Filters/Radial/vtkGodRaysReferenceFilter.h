// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysReferenceFilter
 * @brief   the converged radial sum of an image, exact in double precision
 *
 * The limit of the sum of a vtkGodRaysRadialModel for any number of taps, and so the
 * measure of everything that approximates it. With n = NumberOfSamples, d = Decay and the march
 * m(x) = vtkGodRays::MarchVector(LightClip, ndc(x), MarchScale) [uv], each pixel x of the result is
 *
 *     L(x) = G integral_0^1 K(t) s(x + t Density m(x)) dt
 *     K(t) = e^(-k t)/phi(k),  phi(k) = (1 - e^-k)/k,  k = -n ln d
 *     G = Exposure Weight (1 - d^n)/(1 - d)   (n Exposure Weight for d = 1)
 *
 * Limits: Decay 0 leaves the pixel itself, L = G s(x); so do Density 0 and a march of 0. A Decay
 * above 1 (k < 0) is a kernel that grows towards the light.
 *
 * s is the image as GL_LINEAR with GL_CLAMP_TO_BORDER and border 0 reads it: bilinear between the
 * centres of pixels, falling to 0 within half a pixel beyond the image's edges. The march is walked
 * from one line of pixel centres to the next; between two such lines s is a quadratic polynomial of
 * t, whose integral with the exponential has a closed form. So there is no step and no quadrature
 * error, and since no terms cancel, rounding alone remains: below 1e-12 of the largest possible
 * result (G times the brightest value) always, and below 1e-12 of each result that is at least a
 * thousandth of that. Documentation/Evidence/Accuracy.md has measured figures.
 *
 * Input: a 2-D vtkImageData (any extent in x and y, one slice) with 1 to 4 components of type
 * unsigned char, float or double. Bytes count as value/255. Components are independent, alpha
 * included. Spacing and origin have no influence: lengths are fractions of the picture. Values are
 * taken through vtkGodRays::Sanitize: NaN and negative ones count as 0, those above the largest
 * float (3.4e38, infinity included) as that; so no pixel can spread NaN.
 *
 * Output: an image of the same extent, spacing, origin and number of components, its scalars double
 * or, on demand, float (at most 3.4e38). Only the requested extent is computed: UpdateExtent() of a
 * single pixel is cheap. Bytes of the result do not depend on the number of threads.
 *
 * An input that cannot be used is one error that says what to do, and the output is empty. The
 * output is empty, too, after AbortExecute, which is looked at whenever progress is told, a hundred
 * times, on the calling thread.
 *
 * Cost: some 30 ns for each line of pixel centres that a march crosses, half of that for Decay 1;
 * see Documentation/Evidence/Accuracy.md. Memory: a copy of the input's scalars.
 *
 * @sa vtkGodRaysRadialModel
 */

#ifndef vtkGodRaysReferenceFilter_h
#define vtkGodRaysReferenceFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysRadialFilter.h"

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysReferenceFilter : public vtkGodRaysRadialFilter
{
public:
  static vtkGodRaysReferenceFilter* New();
  vtkTypeMacro(vtkGodRaysReferenceFilter, vtkGodRaysRadialFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the type of the result's scalars, VTK_DOUBLE or VTK_FLOAT. Any other is an error and
   * changes nothing. Default is VTK_DOUBLE.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  ///@}

protected:
  vtkGodRaysReferenceFilter() = default;
  ~vtkGodRaysReferenceFilter() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int GetResultType() const override { return this->OutputScalarType; }

private:
  vtkGodRaysReferenceFilter(const vtkGodRaysReferenceFilter&) = delete;
  void operator=(const vtkGodRaysReferenceFilter&) = delete;

  int OutputScalarType = VTK_DOUBLE;
};

#endif
