// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is drawn: the props made of the files, and where they are.
 */

#ifndef Scene_h
#define Scene_h

#include "Files.h"
#include "Options.h"

#include "vtkBoundingBox.h"  // For vtkBoundingBox
#include "vtkProp3D.h"       // For vtkProp3D
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string
#include <vector> // For std::vector

struct Scene
{
  std::vector<vtkSmartPointer<vtkProp3D>> Props;
  vtkBoundingBox Bounds;
  Vector3 East, North, Up;      ///< the axes of the data that a map would have
  vtkIdType NumberOfCells = 0;  ///< drawn as surfaces
  vtkIdType NumberOfVoxels = 0; ///< drawn as volumes
  double ElevationScale = 1.0;
  std::vector<std::string> Arrays; ///< by which props are coloured
  std::vector<std::string> Notes;  ///< sentences for the user, none for most data
  bool HasGround = false;          ///< elevations, or a surface that is seen once from above

  /// What is lower, as a fraction of its width, is low.
  static constexpr double LowestOfShapes = 0.3;

  /**
   * Whether the data are wide and low; and whether they are ground, too, so gentle that they are to be
   * looked at from within.
   */
  bool IsLow() const;
  bool IsTerrain() const;

  /**
   * The unit vector to an azimuth and elevation in degrees, and the reverse.
   */
  Vector3 GetDirection(double azimuth, double elevation) const;
  void GetAngles(const Vector3& direction, double& azimuth, double& elevation) const;

  /**
   * The size of the data along a direction.
   */
  double GetExtent(const Vector3& direction) const;

  /**
   * The highest coordinate along Up within a horizontal distance of a point; the data's lowest when
   * there is nothing.
   */
  double GetHighest(const Vector3& point, double distance) const;
};

/**
 * Throws Failure when the files hold nothing that can be drawn, or not the array asked for.
 */
Scene MakeScene(const std::vector<FileContents>& files, const Options& options);

#endif
