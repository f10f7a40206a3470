// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowKernels.h
 * @brief   what a shadow map hides of each view ray, swept along lines through the light
 *
 * Private. A line of the picture through the light is a plane through eye and light. In it a point is
 * (h, t), h along the direction e to the light and t its distance from the axis along e through the eye.
 * The view ray of row k is D(k), P = D.e, Q = D.v, v being the direction of t: its points have h = t P/Q.
 * The map tells of each column t the height h(t) below which all is dark; so the ray is dark there if
 * t P(k) <= h Q(k). P and Q are affine in k, and rows are counted in the direction in which light flows:
 * each column turns dark in one row at most and stays dark, the row where its occluder is seen.
 *
 * Of a point light at (d, 0), columns are wedges about it, at an angle a from e; the map tells the distance
 * r beyond which all is dark, and the occluder is at (h, t) = (d + r cos a, r sin a). All else holds as it
 * is: farther from the light is farther along the rows. Wedges are counted from the direction to the eye;
 * a ray (P, Q) of depth 1 meets the one at a at the depth d sin a/(P sin a - Q cos a).
 *
 * Parallel view rays begin at (h0, t0), which are affine in k, along one (P, Q); h of a ray at t is
 * h0 + (t - t0) P/Q. Of a point light, e is their direction and (h, t) are counted from the light: a wedge
 * is dark for rays with t0 >= r sin a.
 *
 * What dark columns hide is what MeasureRays() finds between the ends of their runs. For a directional
 * light in a homogeneous medium, in perspective, it is a sum over dark columns before the end of the ray,
 *
 *     hidden = sum e^(-x b_j) - e^(-x b_(j+1)),     x = sigma |D|/Q [1/column]
 *
 * with the columns' edges b_j. x is one number for a row. The terms stand in a table for a ladder of x,
 * whose neighbours differ by ShadowLadder::Ratio; sums of the terms of dark columns are kept at the two
 * steps of the ladder about the row's, and read between them, linearly in the logarithm of x. Columns are
 * one of the map's texels wide, and finer next to the axis, where view rays are short in columns.
 *
 * Of layers that let light through, each column turns dark in one row of each layer, by the part that the
 * layer takes: sums are of these parts, and runs are of columns that are as dark as each other.
 *
 * Hidden light is in parts of an infinite ray's, as vtkGodRaysCoverageKernels has it.
 */

#ifndef vtkGodRaysShadowKernels_h
#define vtkGodRaysShadowKernels_h

#include "vtkGodRaysCoverageKernels.h" // For CoverageSettings and CoverageWedge
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysShadowTables.h"

#include <cstddef>
#include <memory>

namespace vtkGodRays
{
/// A picture or its transpose: pixel (x, row) is at x Across + row Along of each plane.
struct ShadowPicture
{
  const float* Begins;                  // of view rays in a spotlight's cone; nullptr: at the eye
  const float* Ends;                    // of view rays
  float* Hidden[CoverageMaximumPlanes]; // result; 0 before
  std::ptrdiff_t Across;
  std::ptrdiff_t Along;
};

/// What a band of lines needs while it is swept, for the next sweep to use again.
class ShadowLines;
struct DeleteShadowLines
{
  void operator()(ShadowLines* lines) const;
};
using ShadowLinesPointer = std::unique_ptr<ShadowLines, DeleteShadowLines>;
ShadowLinesPointer MakeShadowLines();

/// Sweep a band and write the pixels that lie in it. The axes of the grids are those of the picture: for
/// its transpose x and y change places.
void SweepShadowBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, const vtkGodRaysShadowGrids& grids,
  const ShadowTables& tables, const ShadowPicture& picture, ShadowLines& lines);
}

#endif
