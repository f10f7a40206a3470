// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridLight.h
 * @brief   what a medium of data leaves of a light, at all places
 *
 * Private. Optical depths of the light's ways through one grid, at nodes about twice as far apart as its
 * points, and at least 40 along each axis: at most an eighth of its memory, but for small or thin ones, whose
 * depths bend between points where no datum changes. The nodes of a directional light stand in columns along
 * its direction, so that sums along a column are exact and nothing is smeared from plane to plane; each plane
 * across the axis that light goes along most keeps the columns that go through the grid there. Of a point
 * light, they stand along the grid's axes, and have means along the light's ways: depths rise from the light
 * as a cone does, which no straight lines between nodes tell.
 */

#ifndef vtkGodRaysGridLight_h
#define vtkGodRaysGridLight_h

#include "vtkGodRaysGrid.h"

#include <vector>

class vtkGodRaysGridLight
{
public:
  using Vec3 = vtkGodRays::Vec3;

  /**
   * Sum the depths. The light is a position, or a direction of length 1. The grid is not kept.
   */
  void Build(const vtkGodRaysGrid& grid, const Vec3& light, bool directional);

  /**
   * Add the optical depths of the light's way to a place in points of the grid, in it or not, for as many
   * bands as it has: between the nodes linear.
   */
  void AddDepth(const vtkGodRaysGrid& grid, const Vec3& place, float* depth) const;

  /// How many numbers are kept.
  std::size_t GetSize() const { return this->Depths.size(); }

private:
  void Look(const Vec3& place, float* known) const;

  Vec3 Light = Vec3(0.0); // place, or steps
  bool Directional = true;
  int Bands = 1;
  int Order[3] = { 0, 1, 2 };             // axes across planes, and along them
  int Size[3] = { 2, 2, 2 };              // planes, and nodes of each, along these
  double Distance[3] = { 1.0, 1.0, 1.0 }; // of neighbours [points]
  double Slope[2] = { 0.0, 0.0 }; // by which columns move aside for each point across planes
  std::vector<int> Base[2];       // the first column of each plane
  std::vector<float> Depths;
};

#endif
