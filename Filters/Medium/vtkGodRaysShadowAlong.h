// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowAlong.h
 * @brief   what a shadow map hides of view rays along rays of its light, which are on no line of a sweep
 *
 * Private; see vtkGodRaysShadowKernels.h.
 */

#ifndef vtkGodRaysShadowAlong_h
#define vtkGodRaysShadowAlong_h

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysShadowGrids.h"

#include <cstddef>

namespace vtkGodRays
{
/// Write what is hidden of the view ray of a pixel in whose centre the light, or its opposite, is.
void HideAlongRay(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysShadowGrids& grids, std::ptrdiff_t pixel);

/// The same of all view rays: of a light in the eye, to which all that is seen is lit, or of a directional
/// light along parallel rays.
void HideAlongRays(
  const CoverageSettings& settings, const CoverageImage& image, const vtkGodRaysShadowGrids& grids);
}

#endif
