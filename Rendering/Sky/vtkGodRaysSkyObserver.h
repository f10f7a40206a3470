// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSkyObserver.h
 * @brief   the eye above a planet, as one frame has it; private to this module
 */

#ifndef vtkGodRaysSkyObserver_h
#define vtkGodRaysSkyObserver_h

#include "vtkGodRaysMath.h"

#include <string>

struct vtkGodRaysView;

/// Where the planet is in the world.
struct vtkGodRaysPlanet
{
  vtkGodRays::Vec3 Origin;  ///< on the ground [scene units]
  vtkGodRays::Vec3 Up;      ///< there, of length 1
  vtkGodRays::Vec3 Sun;     ///< the direction to it, of length 1
  double GroundRadius;      ///< [m]
  double WorldUnitInMeters; ///< [m]
};

/// Directions of the observer are x horizontally towards the sun, z up from the ground below.
struct vtkGodRaysSkyObserver
{
  double Height; ///< above the ground, at least 0 [m]
  vtkGodRays::Vec3 Sun;

  ///@{
  /// With these, x and y in [-1, 1] of the picture become a vector along the view ray, of any length.
  vtkGodRays::Vec3 PictureOrigin;
  vtkGodRays::Vec3 PictureRight;
  vtkGodRays::Vec3 PictureUp;
  ///@}

  vtkGodRays::Vec3 Axis; ///< of view, of length 1

  void Set(const vtkGodRaysView& view, const vtkGodRaysPlanet& planet);

  /// A line for a plan.
  std::string Describe() const;
};

#endif
