// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cameras and suns given by angles and places in the picture.
 */

#ifndef CameraOptions_h
#define CameraOptions_h

#include "Options.h"
#include "Scene.h"
#include "Viewpoint.h"

class vtkCamera;

/**
 * The viewpoint as all options have it: MakeViewpoint(), with --camera, --zoom, --parallel-height and
 * --sun-at.
 */
Viewpoint MakeView(const Scene& scene, const Options& options);

/**
 * Where a light is that is seen at a place of the picture, from (0, 0) at the lower left to (1, 1): the
 * direction to a sun; for a lamp, the point as far away as it was.
 */
Vector3 GetLightAt(const Viewpoint& view, vtkCamera* camera, double aspect, double x, double y);

/**
 * The place of the light in the picture, the reverse. Returns whether it is before the camera.
 */
bool FindLight(const Viewpoint& view, vtkCamera* camera, double aspect, double& x, double& y);

#endif
