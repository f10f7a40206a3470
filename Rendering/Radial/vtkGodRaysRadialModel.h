// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialModel
 * @brief   shafts as a radial sum that is as bright for any number of taps
 *
 * The default look. With n = NumberOfSamples, d = Decay, w = Weight, e = Exposure and the march m from
 * the pixel uv to the light [uv], the sum of the layer s is, for any number of taps N,
 *
 *     L(uv) = e w_N sum_{k=1}^{N} d_N^(k-1) s(uv + (k - 1/2) Density/N m)
 *     d_N = d^(n/N),  w_N = w (1 - d_N)/(1 - d)  (w n/N for d = 1)
 *
 * whose result for a constant layer, e w (1 - d^n)/(1 - d), does not depend on N, and which
 * converges with N^-2 to an integral; the samples published with Decay and Weight [Mitchell2007] stay
 * meaningful, at whatever cost is afforded.
 *
 * Cost of the sum itself: one texture read a tap.
 *
 * @sa vtkGodRaysPass vtkGodRaysEpipolarIntegrator vtkGodRaysPublishedModel
 */

#ifndef vtkGodRaysRadialModel_h
#define vtkGodRaysRadialModel_h

#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <string> // For std::string
#include <vector> // For std::vector

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysRadialModel : public vtkGodRaysRadialSumModel
{
public:
  static vtkGodRaysRadialModel* New();
  vtkTypeMacro(vtkGodRaysRadialModel, vtkGodRaysRadialSumModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the distance from the light over which rays fade to 1/e, besides the fall of the sum itself
   * [heights of the picture]. It keeps the picture dark between shafts, as a vignette does. 0 leaves it out.
   * Valid range: [0, 100]. Default is 0.75.
   */
  void SetReach(double reach);
  double GetReach() const override { return this->Reach; }
  ///@}

  ///@{
  /**
   * Set/Get the largest amplitude of streaks: a fixed pattern of the angle about the light by which rays are
   * stronger and weaker, as in dust that is not even [fraction of the rays]. Nobody measured that dust: it is
   * there for looks, so that a thing with a smooth outline shows shafts, too. It fades to nothing where the
   * data make shafts of their own, and is left out with vtkGodRaysPass::DataFirst. Below 0.1 it is hardly
   * seen. 0 leaves it out. Valid range: [0, 0.5]. Default is 0.22.
   */
  void SetStreaks(double streaks);
  double GetStreaks() const override { return this->Streaks; }
  ///@}

  ///@{
  /**
   * Set all parameters to a named look: "default", "low-sun", "long-shafts", "cathedral", "soft-haze" or
   * "halo". Returns false, with an error that lists the names, for any other name, and changes nothing.
   * In scenes under the default exposure, any two of them differ by what is just noticeable, 2.3 in CIE
   * 1976 L*a*b*, over a third of the picture.
   */
  bool ApplyPreset(const char* name) override;
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  static const char* GetPresetDescription(int index);
  ///@}

  VTK_WRAPEXCLUDE void GetTapSums(std::vector<vtkGodRays::TapSum>& passes, int taps) const override;
  std::string Describe() const override;

protected:
  vtkGodRaysRadialModel() = default;
  ~vtkGodRaysRadialModel() override = default;

  double Reach = 0.75;
  double Streaks = 0.22;

private:
  vtkGodRaysRadialModel(const vtkGodRaysRadialModel&) = delete;
  void operator=(const vtkGodRaysRadialModel&) = delete;
};

#endif
