// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialModel
 * @brief   shafts as a radial sum of the occlusion layer [Mitchell2007]
 *
 * Every pixel sums the layer s along its march to the light, each step weaker than the one before.
 * With n = NumberOfSamples, d = Decay, w = Weight, e = Exposure and the march m from the pixel uv
 * to the light [uv], the INVARIANT formulation is, for any number of taps N,
 *
 *     L(uv) = e w_N sum_{k=1}^{N} d_N^(k-1) s(uv + (k - 1/2) Density/N m)
 *     d_N = d^(n/N),  w_N = w (1 - d_N)/(1 - d)  (w n/N for d = 1)
 *
 * whose result for a constant layer, e w (1 - d^n)/(1 - d), does not depend on N, and which
 * converges with N^-2 to an integral; the samples published with Decay and Weight stay meaningful,
 * at whatever cost is afforded. It sums and blends linear light, and the layer is 0 beyond its
 * edges.
 *
 * The other formulations are published ones, tap by tap, with s_k = s(uv + k Density/n m):
 *
 * | formulation         | result                                    | light  | edge | blend  |
 * |---------------------|-------------------------------------------|--------|------|--------|
 * | MITCHELL            | e [s_0 + w sum_{k=1}^{n} d^(k-1) s_k]     | shown  | edge | add    |
 * | GIANASSI            | e [s_0 + w sum_{k=1}^{n-1} d^k s_k]       | shown  | edge | add    |
 * | LAYERS              | min(0.1 e w sum_{k=1}^{n} d^(k-1) s_k, c) | shown  | edge | add    |
 * | LAYERS_AS_PUBLISHED | the same, red copied to green and blue    | shown  | edge | add    |
 * | EQUATION            | e/n w sum_{k=0}^{n} d^k s_k               | linear | zero | add    |
 * | POSTPROCESSING      | min(e w sum_{k=1}^{n} d^(k-1) s_k, c)     | linear | edge | screen |
 * | THREE_JS            | e (1 - blur of 1 - s), 3 passes of 6 taps | shown  | edge | add    |
 * | BABYLON             | 0.4 e [s_0 + w sum_{k=1}^{n} d^(k-1) s_k] | shown  | edge | add    |
 * | ERKAMAN             | e w sum_{k=1}^{min(n+1, 100)} d^(k-1) s_k | shown  | edge | add    |
 * | ARAUJO              | as MITCHELL                               | shown  | edge | add    |
 *
 * c is ClampMaximum. BABYLON adds to 1.1 times the scene. "shown": the authors sum and blend the
 * values that the display is sent; "linear": light. "edge": their sampler repeats the outermost
 * pixels (ARAUJO's wraps around, which is not reproduced; it differs only where taps leave the
 * layer); "zero": nothing is beyond. The blurs and reduced sizes that some authors add before or
 * after are not part of a formulation. THREE_JS reads only Exposure, uses red alone, stops at the
 * light and below the upper edge, as published, and steps by a fixed length in units of the
 * picture, not of the march.
 *
 * Density, Weight or Exposure 0 means no rays, in every formulation.
 * Numbers beyond a valid range are clamped to it; NaN and infinities are errors and change nothing.
 *
 * Cost: one texture read a tap.
 *
 * @sa vtkGodRaysPass vtkGodRaysTapsIntegrator
 */

#ifndef vtkGodRaysRadialModel_h
#define vtkGodRaysRadialModel_h

#include "vtkGodRaysModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkWrappingHints.h"          // For VTK_WRAPEXCLUDE

#include <string> // For std::string
#include <vector> // For std::vector

class vtkImageData;

namespace vtkGodRays
{
struct TapSum;
}

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysRadialModel : public vtkGodRaysModel
{
public:
  static vtkGodRaysRadialModel* New();
  vtkTypeMacro(vtkGodRaysRadialModel, vtkGodRaysModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how far towards the light the march goes [fraction of the way]. Above 1 it goes past
   * the light. 0 means no rays. Valid range: [0, 2]. Default is 0.97.
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
   * Set/Get the number of samples that Decay and Weight refer to [no unit]. In the INVARIANT
   * formulation it is no cost: the integrator takes the taps that it needs. Valid range:
   * [1, 10000]. Default is 100.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 10000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Set/Get the largest result of the formulations whose authors clamp it: LAYERS,
   * LAYERS_AS_PUBLISHED and POSTPROCESSING [the layer's unit]. 0 means no rays in these.
   * Valid range: [0, 65504]. Default is 1.
   */
  void SetClampMaximum(double maximum);
  vtkGetMacro(ClampMaximum, double);
  ///@}

  /// Whose sum is evaluated; see the table above.
  enum Formulation
  {
    INVARIANT = 0,           ///< our own: the same brightness for any number of taps
    MITCHELL = 1,            ///< listing of GPU Gems 3, chapter 13
    GIANASSI = 2,            ///< Gianassi and Gigli
    LAYERS = 3,              ///< React Three Fiber tutorial, each colour in its own channel
    LAYERS_AS_PUBLISHED = 4, ///< the same with its slip: red in all three channels
    EQUATION = 5,            ///< equation 4 of GPU Gems 3, chapter 13, as printed
    POSTPROCESSING = 6,      ///< pmndrs postprocessing, GodRaysEffect
    THREE_JS = 7,            ///< three.js, GodRaysShader
    BABYLON = 8,             ///< Babylon.js, VolumetricLightScatteringPostProcess
    ERKAMAN = 9,             ///< glsl-godrays
    ARAUJO = 10              ///< screen-space-godrays
  };

  ///@{
  /**
   * Set/Get whose sum is evaluated, one of Formulation. The parameters stay as they are: use
   * ApplyPreset() for the authors' own. Any other number is an error and changes nothing.
   * Default is INVARIANT.
   */
  void SetFormulation(int formulation);
  vtkGetMacro(Formulation, int);
  const char* GetFormulationAsString() const;
  ///@}

  ///@{
  /**
   * Set all parameters to a named look. There is one preset for each published formulation, with
   * its authors' defaults, and some of our own, which are INVARIANT. Returns false, with an error
   * that lists the names, for any other name, and changes nothing.
   */
  bool ApplyPreset(const char* name) override;
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  static const char* GetPresetDescription(int index);
  ///@}

  /// What the layer holds beyond its edges.
  enum BorderMode
  {
    ZERO_BORDER = 0, ///< nothing (GL_CLAMP_TO_BORDER, border colour 0)
    EDGE_BORDER = 1  ///< its outermost pixels (GL_CLAMP_TO_EDGE)
  };

  /**
   * What the formulation reads beyond the layer's edges, one of BorderMode.
   */
  int GetBorder() const;

  /**
   * The sums to evaluate, each pass on the result of the one before. INVARIANT uses the given
   * number of taps, NumberOfSamples if that is not positive; published formulations have their own.
   * FixedLength is in uv of the picture: where SumTaps gets uv of a layer with a margin, multiply
   * it by the part of the layer that the picture covers.
   */
  VTK_WRAPEXCLUDE void GetTapSums(std::vector<vtkGodRays::TapSum>& passes, int taps) const;

  /**
   * Evaluate the model on the processor, in double precision, with vtkSMPTools.
   *
   * layer: the occlusion layer, 32-bit float RGB. lightClip: the light's clip coordinates
   * (X, Y, w) in the layer, which are those in the picture, X and Y times viewScale. marchScale:
   * the factor of vtkGodRays::MarchVector [1/clip unit]; 1/w marches exactly to the light, as all
   * published shaders do. viewScale: the part of the layer that the picture covers, about its
   * centre [fraction of its width and height]; 1 unless the layer has a margin. size: columns and
   * rows of the picture. scattering: the result, 64-bit float RGB. taps: as for GetTapSums(). The
   * first passes of a formulation of several are evaluated on the pixels of the layer. Values are
   * those of the layer, light or shown (see GetLinearLight()). The result is 0 when CanScatter() is
   * false.
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

  /**
   * Whether light is summed and blended as light, or as the values that the display is sent, as many
   * published shaders do.
   */
  bool GetLinearLight() const;

  /**
   * Whether the march towards a light far outside the picture is capped, so that its shafts keep
   * their brightness (INVARIANT), or always ends at the light, as published; then a light behind the
   * camera makes no shafts.
   */
  bool CapsMarch() const { return this->Formulation == INVARIANT; }

  /// How rays join the picture; the values are those of vtkGodRaysPass::BlendMode.
  enum BlendMode
  {
    ADD = 1,   ///< scene + rays
    SCREEN = 2 ///< scene + rays - min(scene * rays, 1)
  };

  /**
   * How rays join the picture, one of BlendMode.
   */
  int GetBlend() const;

  /**
   * The factor on the scene's own colours when rays are added [no unit].
   */
  double GetSceneGain() const;

  bool CanScatter() const override;
  VTK_NEWINSTANCE vtkGodRaysIntegrator* MakeIntegrator() const override;
  std::string Describe() const override;
  VTK_WRAPEXCLUDE std::unique_ptr<vtkGodRaysEffect> MakeEffect() override;

protected:
  vtkGodRaysRadialModel() = default;
  ~vtkGodRaysRadialModel() override = default;

private:
  vtkGodRaysRadialModel(const vtkGodRaysRadialModel&) = delete;
  void operator=(const vtkGodRaysRadialModel&) = delete;

  double Density = 0.97;
  double Decay = 0.98;
  double Weight = 0.03;
  double Exposure = 1.0;
  double ClampMaximum = 1.0;
  int NumberOfSamples = 100;
  int Formulation = INVARIANT;
};

#endif
