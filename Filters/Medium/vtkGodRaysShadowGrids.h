// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowGrids.h
 * @brief   a light's shadow map, as numbers
 *
 * Private. Of a directional light, one to four grids across it, nested about the axis through the eye: a
 * later one is finer, and nothing is looked up in an earlier one where a later one reaches. Of a point
 * light, one grid or the six of a cube about it, across axes of their own at distance 1 from it. In view
 * coordinates, x to the right, y up, z forwards, with the eye at the origin.
 *
 * What lets part of the light through makes layers: with t1, t2 ... of what a ray of light meets at the
 * depths d1 < d2 < ..., a place at s gets the product T of the t_k with d_k < s. That is
 *
 *     1 - T = sum of (T_(k-1) - T_k) [d_k < s],     T_k = t1 ... t_k,
 *
 * so that each layer is a map of depths d_k in itself, which dims by a part T_(k-1) - T_k, of each colour.
 */

#ifndef vtkGodRaysShadowGrids_h
#define vtkGodRaysShadowGrids_h

#include <algorithm>
#include <cmath>
#include <cstddef>

struct vtkGodRaysShadowGrids
{
  static constexpr int MaximumLevels = 4; // of a directional light
  static constexpr int MaximumGrids = 6;
  static constexpr float Nothing = -1e30f; // the height where no occluder is

  struct Grid
  {
    const float* Depths = nullptr; // texel (i, j) at j Stride + i; 1 where no occluder is
    std::ptrdiff_t Stride = 0;
    int Size[2] = { 0, 0 };         // [texels]
    double Low[2] = { 0.0, 0.0 };   // edges, along Axes [scene units; of a point light, 1]
    double Texel[2] = { 1.0, 1.0 }; // their widths, alike
    std::ptrdiff_t First = 0;       // texel, in a layer
    // Across the light, and away from it, of length 1; of a directional light those of the first grid.
    double Axes[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  };
  /// Texels as those of all grids together are, from Grid::First on with its Stride.
  struct Layer
  {
    const float* Depths = nullptr; // 1 where there is nothing
    const float* Dark[3] = {};     // part of the light that is dark beyond [0, 1], of each colour
  };

  Grid Grids[MaximumGrids];
  int Levels = 0;                // of grids
  const Layer* Layers = nullptr; // in place of the grids' own depths
  int NumberOfLayers = 0;        // 0 if all that blocks light is opaque
  bool Colored = false;          // whether the colours' parts differ
  bool Point = false;
  unsigned int Version = 0; // another one for other depths or layers; 0: unknown
  // Distances along the third axis of depths 0 and 1, from a point light or the eye [scene units].
  double Range[2] = { 0.0, 1.0 };

  /// One over the distance of an occluder from a point light, along the third axis, of a depth.
  double GetNearness(double depth) const
  {
    return (this->Range[1] - depth * (this->Range[1] - this->Range[0])) /
      (this->Range[1] * this->Range[0]);
  }

  /// The distance from the eye towards a directional light, of a depth.
  double GetHeight(double depth) const
  {
    return depth * (this->Range[0] - this->Range[1]) - this->Range[0];
  }

  /// As if the occluders were those of a layer alone.
  vtkGodRaysShadowGrids GetLayer(int layer) const
  {
    vtkGodRaysShadowGrids one = *this;
    for (Grid& grid : one.Grids)
    {
      grid.Depths = this->Layers[layer].Depths + grid.First;
    }
    return one;
  }

  /// The distance from a point light of the occluder in a direction of length 1; 1e30 if there is none. If
  /// there is one, texel tells which of a layer's texels has it.
  double GetDistance(const double direction[3], std::ptrdiff_t* texel = nullptr) const
  {
    const auto along = [&](const double axis[3])
    { return axis[0] * direction[0] + axis[1] * direction[1] + axis[2] * direction[2]; };
    for (int face = 0; face < this->Levels; ++face)
    {
      const Grid& grid = this->Grids[face];
      const double ahead = along(grid.Axes[2]);
      if (!(ahead > 0.0))
      {
        continue;
      }
      const double i = (along(grid.Axes[0]) / ahead - grid.Low[0]) / grid.Texel[0];
      const double j = (along(grid.Axes[1]) / ahead - grid.Low[1]) / grid.Texel[1];
      if (i >= 0.0 && j >= 0.0 && i < grid.Size[0] && j < grid.Size[1])
      {
        const std::ptrdiff_t at =
          static_cast<std::ptrdiff_t>(j) * grid.Stride + static_cast<std::ptrdiff_t>(i);
        const float depth = grid.Depths[at];
        if (texel)
        {
          *texel = grid.First + at;
        }
        return depth < 1.0f ? 1.0 / (ahead * this->GetNearness(depth)) : 1e30;
      }
    }
    return 1e30;
  }

  /// The height of the occluder on a directional light's way through a place; Nothing if there is none. If
  /// there is one, texel tells which of a layer's texels has it.
  float GetHeight(const double place[3], std::ptrdiff_t* texel = nullptr) const
  {
    const auto along = [&](const double axis[3])
    { return axis[0] * place[0] + axis[1] * place[1] + axis[2] * place[2]; };
    const double a = along(this->Grids[0].Axes[0]);
    const double b = along(this->Grids[0].Axes[1]);
    for (int level = this->Levels - 1; level >= 0; --level)
    {
      const Grid& grid = this->Grids[level];
      const double i = (a - grid.Low[0]) / grid.Texel[0];
      const double j = (b - grid.Low[1]) / grid.Texel[1];
      if (i >= 0.0 && j >= 0.0 && i < grid.Size[0] && j < grid.Size[1])
      {
        const std::ptrdiff_t at =
          static_cast<std::ptrdiff_t>(j) * grid.Stride + static_cast<std::ptrdiff_t>(i);
        const float depth = grid.Depths[at];
        if (texel)
        {
          *texel = grid.First + at;
        }
        return depth < 1.0f ? static_cast<float>(this->GetHeight(depth)) : Nothing;
      }
    }
    return Nothing;
  }
};

#endif
