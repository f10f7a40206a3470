// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysCoverageKernels.h
 * @brief   what surfaces hide of each view ray, swept along lines through the light
 *
 * Private. A directional light in view coordinates (x right, y up, z forwards) is seen at the pixel
 * (A, B)/W, and light flows through the pixel p along d(p) = W p - (A, B). A light ray passes the pixels
 * of a line along d, and there
 *
 *     h = scale z + shift
 *
 * is constant, z being the view depth: scale = |d|/|d at the line's widest place| in perspective and
 * 1 in a parallel projection, whose shift grows along the line by what the light ray recedes. So a
 * sample of a surface hides the light ray h from all that is farther along the line: a line carries the
 * union of hidden intervals of h, the same for each of its pixels, and a pixel sums what the medium
 * sends from them, up to its own depth.
 *
 * The picture is divided into four wedges about the light, each swept row by row in the direction in
 * which light flows, along y or (transposed) along x; lines are 2 pixels apart where they are widest,
 * a pixel takes the nearest one. Bands of lines are independent of each other.
 */

#ifndef vtkGodRaysCoverageKernels_h
#define vtkGodRaysCoverageKernels_h

#include <cstddef>
#include <memory>
#include <vector>

namespace vtkGodRays
{
/// Depth of what is nowhere.
constexpr float CoverageSky = 1e30f;

struct CoverageSettings
{
  double PixelSize; // at depth 1, or of a parallel projection [scene units]
  bool Parallel;
  double Light[3];         // view coordinates, length 1
  double FarLimit;         // [scene units]
  int Channels;            // extinctions that differ: 1 or 3
  double Extinction[3];    // [1/scene unit], above 0
  int Layers;              // 0: depths of the first surfaces; else fronts and backs, up to 2 times
  double Thickness = 0.01; // of what is seen from before, without layers [fraction of its depth]
  double Jump = 0.1;       // of depth between samples of one surface [fraction of the lesser]
  double Bend = 0.01;      // of 1/depth (parallel: depth) from a plane [fraction]
};

/// A picture or its transpose, by planes. Depths are positive, CoverageSky at most.
struct CoverageImage
{
  int Width;
  int Height;
  double Center[2];       // the view axis, whole numbers being the centres of pixels
  const float* Depths[4]; // front, back, front, back
  const float* Ends;      // of view rays
  float* Hidden[3];       // result: the part of the light along the ray that is hidden, [0, 1]
};

/// A wedge of rows through which light flows up (Direction 1) or down (-1).
struct CoverageWedge
{
  double A, B, W;
  double AlongLight; // the light's component along rows, for the shift of parallel projections
  int Direction;
  int First; // row
  int Rows;
  int Widest;       // row
  double FirstLine; // where it crosses the widest row
  int Lines;
  int Bands;
};

constexpr int CoverageBandLines = 128;
constexpr double CoverageSpacing = 2.0; // [pixels]

/// The wedge of one direction; no Rows if there is none. Depends on the image's size and centre alone.
CoverageWedge MakeCoverageWedge(
  const CoverageSettings& settings, const CoverageImage& image, bool transposed, int direction);

/// Index of the pixel in which the light is seen, -1 if that is none; isCentred tells whether it is in
/// the pixel's very centre.
std::ptrdiff_t FindCoverageLight(
  const CoverageWedge& wedge, const CoverageImage& image, bool& isCentred);

/// What a band remembers of its lines while it is swept, for the next sweep to use again.
class CoverageLines;
struct DeleteCoverageLines
{
  void operator()(CoverageLines* lines) const;
};
using CoverageLinesPointer = std::unique_ptr<CoverageLines, DeleteCoverageLines>;
CoverageLinesPointer MakeCoverageLines();

/// Sweep a band and write the pixels that lie in it. Returns how many intervals found no room.
long long SweepCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, CoverageLines& lines);

/// Write to a pixel what is hidden between two view depths.
void HideCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float begin, float end);

/// A phase function, linear between the entries of a table: the first half is over sin(a/2), a being
/// the scattering angle, from 0 to sin(45 degrees), the second over cos(a/2) back to 0.
using CoveragePhase = std::vector<float>;

/// How pixels shine: the sum over phases of phase x factor x light, for each component.
struct CoverageShade
{
  int Components; // 1 or 3
  int Phases;     // 1 or 2
  CoveragePhase Table[2];
  float Factors[2][3];
};

/// A row of the result, components interleaved.
void WriteCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row);
}

#endif
