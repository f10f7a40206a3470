// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysPublishedModel
 * @brief   radial sums exactly as their authors published them, tap by tap
 *
 * With n = NumberOfSamples, d = Decay, w = Weight, e = Exposure, the march m from the pixel uv to the
 * light [uv], and s_k = s(uv + k Density/n m) of the layer s:
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
 * layer); "zero": nothing is beyond. All march to the light itself, however far it is. The blurs and
 * reduced sizes that some authors add before or after are not part of a formulation. THREE_JS reads only
 * Exposure, uses red alone, stops at the light and below the upper edge, as published, and steps by a
 * fixed length in units of the picture, not of the march.
 *
 * Cost: one texture read a tap.
 *
 * @sa vtkGodRaysPass vtkGodRaysTapsIntegrator vtkGodRaysRadialModel
 */

#ifndef vtkGodRaysPublishedModel_h
#define vtkGodRaysPublishedModel_h

#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <string> // For std::string
#include <vector> // For std::vector

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysPublishedModel : public vtkGodRaysRadialSumModel
{
public:
  static vtkGodRaysPublishedModel* New();
  vtkTypeMacro(vtkGodRaysPublishedModel, vtkGodRaysRadialSumModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whose sum is evaluated; see the table above.
  enum FormulationType
  {
    MITCHELL = 0,            ///< listing of GPU Gems 3, chapter 13 [Mitchell2007]
    GIANASSI = 1,            ///< Gianassi and Gigli
    LAYERS = 2,              ///< React Three Fiber tutorial, each colour in its own channel
    LAYERS_AS_PUBLISHED = 3, ///< the same with its slip: red in all three channels
    EQUATION = 4,            ///< equation 4 of GPU Gems 3, chapter 13, as printed
    POSTPROCESSING = 5,      ///< pmndrs postprocessing, GodRaysEffect
    THREE_JS = 6,            ///< three.js, GodRaysShader
    BABYLON = 7,             ///< Babylon.js, VolumetricLightScatteringPostProcess
    ERKAMAN = 8,             ///< glsl-godrays
    ARAUJO = 9               ///< screen-space-godrays
  };

  ///@{
  /**
   * Set/Get whose sum is evaluated, one of FormulationType. The parameters stay as they are; presets have
   * the authors' own. See ApplyPreset(). Any other number is an error and changes nothing. Default is
   * MITCHELL.
   */
  void SetFormulation(int formulation);
  vtkGetMacro(Formulation, int);
  const char* GetFormulationAsString() const;
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

  ///@{
  /**
   * Set the formulation of this name and its authors' parameters; names are those of
   * GetFormulationAsString(). Returns false, with an error that lists the names, for any other name, and
   * changes nothing. A new model has those of "mitchell".
   */
  bool ApplyPreset(const char* name) override;
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  static const char* GetPresetDescription(int index);
  ///@}

  VTK_WRAPEXCLUDE void GetTapSums(std::vector<vtkGodRays::TapSum>& passes, int taps) const override;
  int GetBorder() const override;
  bool GetLinearLight() const override;
  bool CapsMarch() const override { return false; }
  int GetBlend() const override;
  double GetSceneGain() const override;
  bool CanScatter() const override;
  std::string Describe() const override;

protected:
  vtkGodRaysPublishedModel();
  ~vtkGodRaysPublishedModel() override = default;

private:
  vtkGodRaysPublishedModel(const vtkGodRaysPublishedModel&) = delete;
  void operator=(const vtkGodRaysPublishedModel&) = delete;

  double ClampMaximum = 1.0;
  int Formulation = MITCHELL;
};

#endif
