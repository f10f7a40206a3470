// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowGrids.h
 * @brief   a directional light's shadow map, as numbers
 *
 * Private. One to four grids across the light, nested about the axis through the eye: a later one is
 * finer, and nothing is looked up in an earlier one where a later one reaches. In view coordinates, x to
 * the right, y up, z forwards, with the eye at the origin.
 */

#ifndef vtkGodRaysShadowGrids_h
#define vtkGodRaysShadowGrids_h

#include <algorithm>
#include <cmath>
#include <cstddef>

struct vtkGodRaysShadowGrids
{
  static constexpr int MaximumLevels = 4;
  static constexpr float Nothing = -1e30f; // the height where no occluder is

  struct Grid
  {
    const float* Depths = nullptr; // texel (i, j) at j Stride + i; 1 where no occluder is
    std::ptrdiff_t Stride = 0;
    int Size[2] = { 0, 0 };         // [texels]
    double Low[2] = { 0.0, 0.0 };   // edges, along Axes [scene units]
    double Texel[2] = { 1.0, 1.0 }; // their widths [scene units]
  };
  Grid Grids[MaximumLevels];
  int Levels = 0;
  double Axes[2][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } }; // across the light; of length 1
  double HeightAtZero = 0.0; // along the direction to the light, of depth 0 [scene units]
  double HeightAtOne = 0.0;

  /// Where a line from the eye leaves a level, along an axis that it goes along in a direction of that
  /// sign. The level is looked up to there.
  double GetReach(int level, int axis, double sign) const
  {
    const Grid& grid = this->Grids[level];
    return sign > 0.0 ? grid.Low[axis] + grid.Size[axis] * grid.Texel[axis] : grid.Low[axis];
  }

  /// The height of the occluder about a place (a, b) along the axes; Nothing if there is none.
  float GetHeight(double a, double b) const
  {
    for (int level = this->Levels - 1; level >= 0; --level)
    {
      const Grid& grid = this->Grids[level];
      const double i = (a - grid.Low[0]) / grid.Texel[0];
      const double j = (b - grid.Low[1]) / grid.Texel[1];
      if (i >= 0.0 && j >= 0.0 && i < grid.Size[0] && j < grid.Size[1])
      {
        const float depth =
          grid
            .Depths[static_cast<std::ptrdiff_t>(j) * grid.Stride + static_cast<std::ptrdiff_t>(i)];
        return depth < 1.0f ? static_cast<float>(this->HeightAtZero +
                                depth * (this->HeightAtOne - this->HeightAtZero))
                            : Nothing;
      }
    }
    return Nothing;
  }
};

#endif
