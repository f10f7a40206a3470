// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture of what is all around a scene, as its background and as light on its surfaces.
 */

#ifndef Environment_h
#define Environment_h

#include "Scene.h"

#include <string> // For std::string

class vtkRenderer;

/**
 * Put the picture behind a scene that the renderer has, and let it light the scene's surfaces. Throws Failure
 * when the file is missing, is no .hdr, or is not twice as wide as high.
 */
void AddEnvironment(vtkRenderer* renderer, const Scene& scene, const std::string& path);

#endif
