// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the user is told when a light gives no shafts where it was asked for.
 */

#ifndef Advice_h
#define Advice_h

#include "Options.h"
#include "Scene.h"
#include "Viewpoint.h"

#include <string> // For std::string
#include <vector> // For std::vector

/**
 * A sentence for each thing about the light, seen by the view's camera, that a picture with rays would
 * not show: a sun below the horizon of the plain background, a light so far out of the picture that a
 * look has no shafts of it. isMedium: whether the rays are those of a medium.
 */
std::vector<std::string> GetAdvice(
  const Scene& scene, const Viewpoint& view, const Options& options, bool isMedium);

#endif
