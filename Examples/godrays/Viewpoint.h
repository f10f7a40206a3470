// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the camera and the light are: as asked for, and where nothing is, such that shafts appear.
 */

#ifndef Viewpoint_h
#define Viewpoint_h

#include "Options.h"
#include "Scene.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkCamera;

struct Viewpoint
{
  vtkSmartPointer<vtkCamera> Camera;
  bool LightIsLamp = false;
  Vector3 LightPosition = { 0.0, 0.0, 1.0 };  ///< of a lamp
  Vector3 LightDirection = { 0.0, 0.0, 1.0 }; ///< unit vector from the scene to the light
  bool LightWasChosen = false;
  std::optional<Vector3> LampInMedium; ///< has the place of a chosen light in a medium
};

/**
 * Throws Failure when what is asked for contradicts itself.
 */
Viewpoint MakeViewpoint(const Scene& scene, const Options& options);

#endif
