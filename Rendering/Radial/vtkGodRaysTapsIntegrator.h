// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysTapsIntegrator
 * @brief   the radial sum as published: n texture taps from each pixel towards the light
 *
 * Evaluates a vtkGodRaysPublishedModel exactly as its authors' shaders do, [Mitchell2007] and its kin, and
 * a vtkGodRaysRadialModel with any number of taps, at a cost of one texture read a tap. Jitter and several
 * passes, two customary approximations, are there to be compared with. NumberOfTaps, Jitter and
 * NumberOfPasses are for a vtkGodRaysRadialModel: a published sum has its authors' own.
 *
 * @sa vtkGodRaysPass vtkGodRaysRadialModel vtkGodRaysPublishedModel
 */

#ifndef vtkGodRaysTapsIntegrator_h
#define vtkGodRaysTapsIntegrator_h

#include "vtkGodRaysRadialIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class vtkGodRaysRadialSumModel;

namespace vtkGodRays
{
struct TapSum;
}

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysTapsIntegrator : public vtkGodRaysRadialIntegrator
{
public:
  static vtkGodRaysTapsIntegrator* New();
  vtkTypeMacro(vtkGodRaysTapsIntegrator, vtkGodRaysRadialIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how many taps a pixel takes [no unit]. 0 takes the model's NumberOfSamples. The brightness does
   * not depend on it, only banding and cost do. Published sums take the taps of their authors. Valid range:
   * [0, 4096]. Default is 0.
   */
  vtkSetClampMacro(NumberOfTaps, int, 0, 4096);
  vtkGetMacro(NumberOfTaps, int);
  ///@}

  ///@{
  /**
   * Set/Get whether each pixel's taps are moved by up to half their distance either way, by a fixed
   * noise: [Jimenez2014], the customary way to turn banding into grain, which is then left to a blur.
   * It is there for comparison. Default is off.
   */
  vtkSetMacro(Jitter, bool);
  vtkGetMacro(Jitter, bool);
  vtkBooleanMacro(Jitter, bool);
  ///@}

  ///@{
  /**
   * Set/Get in how many passes, each on the result of the one before, the sum is evaluated [no unit]: the
   * customary shortcut, there for comparison. p passes take m taps each, m being the p-th root of the number
   * of taps, rounded, and stand for m^p of them: each pass strides m times as far as the one before. It is
   * exact where all shafts are parallel, but for repeated interpolation; elsewhere each pass starts from
   * where the one before has led, so that marches come short of the light. Valid range: [1, 4]. Default is
   * 1.
   */
  vtkSetClampMacro(NumberOfPasses, int, 1, 4);
  vtkGetMacro(NumberOfPasses, int);
  ///@}

  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysTapsIntegrator();
  ~vtkGodRaysTapsIntegrator() override;

private:
  vtkGodRaysTapsIntegrator(const vtkGodRaysTapsIntegrator&) = delete;
  void operator=(const vtkGodRaysTapsIntegrator&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;

  bool IsJittered(vtkGodRaysRadialSumModel* model) const;
  void GetPasses(vtkGodRaysRadialSumModel* model, std::vector<vtkGodRays::TapSum>& passes) const;

  int NumberOfTaps = 0;
  bool Jitter = false;
  int NumberOfPasses = 1;
};

#endif
