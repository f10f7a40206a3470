// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysWalkedLight
 * @brief   a light's rays as vtkGodRaysInScattering computes them, and their way into the sum; private to
 * this module
 */

#ifndef vtkGodRaysWalkedLight_h
#define vtkGodRaysWalkedLight_h

#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysTarget.h"

class vtkWindow;

class vtkGodRaysWalkedLight
{
public:
  vtkGodRaysInScattering Walk;

  /**
   * Returns the walk's parameters for a layer of this size [pixels] that a pinhole can see; without a shadow
   * map nothing blocks.
   */
  static vtkGodRaysInScattering::Parameters GetParameters(
    const vtkGodRaysMediumIntegrator::Request& request, const int size[2],
    const vtkGodRaysShadowGrids* shadows = nullptr);

  /**
   * Compute it, and add it to the request's result. Returns false, after an error, if that failed.
   */
  bool Add(const vtkGodRaysMediumIntegrator::Request& request,
    const vtkGodRaysInScattering::Parameters& parameters, const int size[2]);

  void Release(vtkWindow* window);

private:
  vtkGodRaysTarget Rays[2]; // of one channel, and of three
};

#endif
