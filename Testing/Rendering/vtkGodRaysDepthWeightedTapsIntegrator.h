// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysDepthWeightedTapsIntegrator
 * @brief   single scattering, shadowed by n taps of the picture's depth: a loop in a shader
 *
 * For models of a medium. From each pixel n taps of the view depth are taken towards the light. What
 * is seen at depth z hides light from one depth of the pixel's view ray, so a tap hides an interval of
 * it, about as long as taps are apart; intervals of neighbours that touch, or that are of one surface,
 * are joined, and their airlight is taken off that of the whole ray. This is Mitchell's loop with depth
 * in the place of colour. It runs on the graphics card, reads nothing back, needs no state along lines
 * through the light, and so serves as the oracle of vtkGodRaysEpipolarCoverageIntegrator: with many taps
 * it differs only where two things hide the same part of a ray, which it takes off twice.
 *
 * Any light: before, beside or behind the eye, directional or a point; perspective and parallel views.
 * Airlight is in closed form for a directional light in a medium that is homogeneous or has one
 * component; otherwise it is a quadrature of 2 points in each hidden interval and in 32 parts of the
 * whole ray, whose places are even in the angle at a point light.
 *
 * The depth of the picture does not hold what is outside it or behind other things, nor how thick
 * things are: a surface is taken to be Thickness thick.
 *
 * @sa vtkGodRaysMediumModel vtkGodRaysEpipolarCoverageIntegrator vtkGodRaysShadowMapIntegrator
 */

#ifndef vtkGodRaysDepthWeightedTapsIntegrator_h
#define vtkGodRaysDepthWeightedTapsIntegrator_h

#include "vtkGodRaysMediumIntegrator.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkGodRaysDepthWeightedTapsIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static vtkGodRaysDepthWeightedTapsIntegrator* New();
  vtkTypeMacro(vtkGodRaysDepthWeightedTapsIntegrator, vtkGodRaysMediumIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how many taps a pixel takes, along the part of its way to the light that is in the picture
   * [no unit]. The brightness does not depend on it, only how well thin things are found. Valid range:
   * [1, 4096]. Default is 32.
   */
  vtkSetClampMacro(NumberOfTaps, int, 1, 4096);
  vtkGetMacro(NumberOfTaps, int);
  ///@}

  ///@{
  /**
   * Set/Get how thick a surface is taken to be [fraction of its view depth]. Above 0.03, thin things
   * cast too much shadow. Valid range: [0, 1]. Default is 0.01.
   */
  void SetThickness(double thickness);
  vtkGetMacro(Thickness, double);
  ///@}

  bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysDepthWeightedTapsIntegrator();
  ~vtkGodRaysDepthWeightedTapsIntegrator() override;

private:
  vtkGodRaysDepthWeightedTapsIntegrator(const vtkGodRaysDepthWeightedTapsIntegrator&) = delete;
  void operator=(const vtkGodRaysDepthWeightedTapsIntegrator&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;

  int NumberOfTaps = 32;
  double Thickness = 0.01;
};

#endif
