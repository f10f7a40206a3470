// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysTapsIntegrator
 * @brief   the radial sum as published: n texture taps from each pixel towards the light
 *
 * Evaluates the formulations of vtkGodRaysRadialModel exactly as their authors' shaders do,
 * [Mitchell2007] and its kin, at a cost of n texture reads a pixel. At a ResolutionScale below 1
 * the sum is evaluated on a coarser grid, interpolated where the four neighbours of a pixel agree
 * to the pass's ErrorTolerance, and evaluated anew, at full size, where they do not: at the edges
 * of the shafts.
 *
 * @sa vtkGodRaysPass vtkGodRaysRadialModel
 */

#ifndef vtkGodRaysTapsIntegrator_h
#define vtkGodRaysTapsIntegrator_h

#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <memory> // For std::unique_ptr

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysTapsIntegrator : public vtkGodRaysIntegrator
{
public:
  static vtkGodRaysTapsIntegrator* New();
  vtkTypeMacro(vtkGodRaysTapsIntegrator, vtkGodRaysIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how many taps a pixel takes [no unit]. 0 takes the model's NumberOfSamples. The
   * brightness does not depend on it, only banding and cost do. Parity formulations always take
   * the taps of their authors. Valid range: [0, 4096]. Default is 0.
   */
  vtkSetClampMacro(NumberOfTaps, int, 0, 4096);
  vtkGetMacro(NumberOfTaps, int);
  ///@}

  bool Supports(vtkGodRaysModel* model) override;
  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model, double resolutionScale) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysTapsIntegrator();
  ~vtkGodRaysTapsIntegrator() override;

private:
  vtkGodRaysTapsIntegrator(const vtkGodRaysTapsIntegrator&) = delete;
  void operator=(const vtkGodRaysTapsIntegrator&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;

  int NumberOfTaps = 0;
};

#endif
