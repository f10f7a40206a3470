// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialSumModel
 * @brief   shafts as a weighted sum of taps along the march to the light: the base of its models
 *
 * Every pixel sums its light's occlusion layer along the march from the pixel to the light, each step
 * weaker than the one before. A model says which taps, what they weigh, and how sum and picture are
 * joined. Unless it says otherwise, light is summed and added as light, the layer is 0 beyond its edges,
 * and the march to a light far outside the picture is capped.
 *
 * Density, Weight or Exposure 0 means no rays.
 * Numbers beyond a valid range are clamped to it; NaN and infinities are errors and change nothing.
 *
 * @sa vtkGodRaysRadialModel vtkGodRaysPublishedModel vtkGodRaysRadialIntegrator
 */

#ifndef vtkGodRaysRadialSumModel_h
#define vtkGodRaysRadialSumModel_h

#include "vtkGodRaysModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkWrappingHints.h"          // For VTK_WRAPEXCLUDE

#include <vector> // For std::vector

class vtkImageData;

namespace vtkGodRays
{
struct TapSum;
}

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysRadialSumModel : public vtkGodRaysModel
{
public:
  vtkTypeMacro(vtkGodRaysRadialSumModel, vtkGodRaysModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how far towards the light the march goes [fraction of the way]. Above 1 it goes past
   * the light. 0 means no rays. Valid range: [0, 2]. Default is 0.97, of a vtkGodRaysPublishedModel
   * 0.8.
   */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor from one of the NumberOfSamples samples to the next one towards the light
   * [no unit]. Above 1 the samples near the light count most. Valid range: [0, 1.05].
   * Default is 1, of a vtkGodRaysPublishedModel 0.99.
   */
  void SetDecay(double decay);
  vtkGetMacro(Decay, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on each of the NumberOfSamples samples [no unit]. 0 means no rays.
   * Valid range: [0, 100]. Default is 0.013, of a vtkGodRaysPublishedModel 0.8.
   */
  void SetWeight(double weight);
  vtkGetMacro(Weight, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor on the whole sum [no unit]. 0 means no rays. Valid range: [0, 100].
   * Default is 1, of a vtkGodRaysPublishedModel 0.05.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of samples that Decay and Weight refer to [no unit]. Of a vtkGodRaysPublishedModel it
   * is the number of taps, as the authors count them (THREE_JS reads Exposure alone); of a
   * vtkGodRaysRadialModel it is no cost: the integrator takes the taps that it needs. Valid range: [1,
   * 10000]. Default is 100.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 10000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  /**
   * The sums to evaluate, each pass on the result of the one before, with this number of taps if the
   * model can be summed with any; taps that are not positive stand for NumberOfSamples.
   * FixedLength is in uv of the picture: where SumTaps gets uv of a layer with a margin, multiply
   * it by the part of the layer that the picture covers.
   */
  VTK_WRAPEXCLUDE virtual void GetTapSums(
    std::vector<vtkGodRays::TapSum>& passes, int taps) const = 0;

  /**
   * Evaluate the model on the processor, in double precision, with vtkSMPTools.
   *
   * layer: the occlusion layer, 32-bit float RGB. lightClip: the light's clip coordinates
   * (X, Y, w) in the layer, which are those in the picture, X and Y times viewScale. marchScale:
   * the factor of vtkGodRays::MarchVector [1/clip unit]; 1/w marches exactly to the light.
   * viewScale: the part of the layer that the picture covers, about its centre [fraction of its width
   * and height]; 1 unless the layer has a margin. size: columns and rows of the picture. scattering:
   * the result, 64-bit float RGB. taps: as for GetTapSums(). All passes but the last are evaluated on
   * the pixels of the layer. Values are those of the layer, light or shown (see GetLinearLight()). The
   * result is 0 when CanScatter() is false.
   *
   * Returns false, after an error, and leaves the result alone when an argument is not usable.
   */
  bool Evaluate(vtkImageData* layer, const double lightClip[3], double marchScale, double viewScale,
    const int size[2], vtkImageData* scattering, int taps = 0);

  /**
   * The result for a layer that is 1 everywhere, before any clamp: the brightest possible result
   * of a layer of values from 0 to 1 [no unit]. Errors are fractions of it.
   */
  double GetFlatGain() const;

  /// What the layer holds beyond its edges.
  enum BorderMode
  {
    ZERO_BORDER = 0, ///< nothing (GL_CLAMP_TO_BORDER, border colour 0)
    EDGE_BORDER = 1  ///< its outermost pixels (GL_CLAMP_TO_EDGE)
  };

  /**
   * What is read beyond the layer's edges, one of BorderMode.
   */
  virtual int GetBorder() const { return ZERO_BORDER; }

  /**
   * Whether light is summed and blended as light, or as the values that the display is sent.
   */
  virtual bool GetLinearLight() const { return true; }

  /**
   * Whether the march towards a light far outside the picture is capped, so that its shafts keep their
   * brightness, or always ends at the light; then a light behind the camera makes no shafts.
   */
  virtual bool CapsMarch() const { return true; }

  /// How rays join the picture; the values are those of vtkGodRaysPass::BlendMode.
  enum BlendMode
  {
    ADD = 1,   ///< scene + rays
    SCREEN = 2 ///< scene + rays - min(scene * rays, 1)
  };

  /**
   * How rays join the picture, one of BlendMode.
   */
  virtual int GetBlend() const { return ADD; }

  ///@{
  /**
   * The response of the sum: the distance from the light over which rays fade to 1/e [heights of the
   * picture], 0 if they do not; the largest amplitude of streaks [no unit].
   */
  virtual double GetReach() const { return 0.0; }
  virtual double GetStreaks() const { return 0.0; }
  ///@}

  /**
   * The factor on the scene's own colours when rays are added [no unit].
   */
  virtual double GetSceneGain() const { return 1.0; }

  bool CanScatter() const override;
  VTK_NEWINSTANCE vtkGodRaysIntegrator* MakeIntegrator() const override;
  VTK_WRAPEXCLUDE std::unique_ptr<vtkGodRaysEffect> MakeEffect() override;

protected:
  vtkGodRaysRadialSumModel() = default;
  ~vtkGodRaysRadialSumModel() override = default;

  /**
   * Set what every such sum has.
   */
  void SetParameters(
    double density, double decay, double weight, double exposure, int numberOfSamples);

  /**
   * The same in words, for Describe().
   */
  std::string DescribeParameters() const;

  double Density = 0.97;
  double Decay = 1.0;
  double Weight = 0.013;
  double Exposure = 1.0;
  int NumberOfSamples = 100;

private:
  vtkGodRaysRadialSumModel(const vtkGodRaysRadialSumModel&) = delete;
  void operator=(const vtkGodRaysRadialSumModel&) = delete;
};

#endif
