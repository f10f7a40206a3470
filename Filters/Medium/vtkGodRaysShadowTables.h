// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowTables.h
 * @brief   the columns of shadow maps in planes through the eye and a light
 *
 * Private; see vtkGodRaysShadowKernels.h.
 */

#ifndef vtkGodRaysShadowTables_h
#define vtkGodRaysShadowTables_h

#include "vtkGodRaysShadowGrids.h"

#include <vector>

namespace vtkGodRays
{
/// Of a directional light: the columns of all lines, and what comes from each at the steps of the ladder.
struct ShadowLadder
{
  static constexpr double Ratio = 1.15; // interpolation: less than 8e-4 of an infinite ray
  static constexpr int Octaves = 3;     // of finer columns
  static constexpr int Mantissa = 6;    // 2^Mantissa columns in each
  static constexpr int Each = 1 << Mantissa;
  static constexpr int FirstWhole =
    Each * (1 + Octaves); // the first column of width 1; it begins at Each

  int Columns = 0; // room for them, padded
  int Steps = 0;
  double First = 0.0;         // x of the first step
  std::vector<float> Weights; // of steps, of columns
  std::vector<float> Middles; // of columns, in widths of whole ones
  std::vector<float> Edges;   // where they begin, alike
};

/// Of a point light: columns are wedges of one angle, from the direction to the eye on.
struct ShadowFan
{
  int Columns = 0;    // to the direction away from the eye
  double Angle = 0.0; // of each [radians]
  // Of the angle between the way from the eye to the light and a column's middle, or where it begins; padded.
  std::vector<float> MiddleSines;
  std::vector<float> MiddleCosines;
  std::vector<float> EdgeSines;
  std::vector<float> EdgeMinusCosines;
};

struct ShadowTables
{
  ShadowLadder Ladder;
  ShadowFan Fan;
};

/// Where a column begins [widths of whole columns from the axis].
double GetShadowColumn(int column);

/// For extinctions [1/scene unit] from low to high, above 0; without weights if high is 0. A ladder that
/// serves as it is stays.
void MakeShadowLadder(
  const vtkGodRaysShadowGrids& grids, double low, double high, ShadowLadder& ladder);

/// Columns as wide as the least texel in the middle of a face.
void MakeShadowFan(const vtkGodRaysShadowGrids& grids, ShadowFan& fan);
}

#endif
