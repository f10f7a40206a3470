// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVerification
 * @brief   a light's rays against the exact ones, at some pixels; private to this module
 */

#ifndef vtkGodRaysVerification_h
#define vtkGodRaysVerification_h

#include "vtkNew.h" // For vtkNew

#include <array>
#include <functional>

class vtkGodRaysIntegrator;
class vtkGodRaysSum;
class vtkImageData;

class vtkGodRaysVerification
{
public:
  /**
   * Remember what there is before the light, if pixels of this frame are compared.
   */
  vtkGodRaysVerification(vtkGodRaysIntegrator* integrator, vtkGodRaysSum& sum);
  ~vtkGodRaysVerification();
  vtkGodRaysVerification(const vtkGodRaysVerification&) = delete;
  void operator=(const vtkGodRaysVerification&) = delete;

  bool IsWanted() const;

  /**
   * Compare what the light has added to the sum with the exact light of pixels, counted from the lower
   * left corner, and tell the integrator. exact is called on several threads.
   */
  void Measure(const std::function<std::array<double, 3>(int x, int y)>& exact);

private:
  vtkGodRaysIntegrator* Integrator;
  vtkGodRaysSum& Sum;
  vtkNew<vtkImageData> Before;
};

#endif
