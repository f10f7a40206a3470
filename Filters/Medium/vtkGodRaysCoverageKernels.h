// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysCoverageKernels.h
 * @brief   the light of view rays, and the lines through the light along which shadows are swept
 *
 * Private. A light at (x, y, z, w) in view coordinates (x right, y up, z forwards) is seen at the pixel
 * (A, B)/W, and light flows through the pixel p along d(p) = W p - (A, B); W is z, but w where view rays
 * are parallel.
 *
 * What the medium sends from the first part of a view ray, were there no shadows, is a closed form for a
 * directional light in a homogeneous medium; else it is read from a table. It may: for given light and
 * medium, a view ray is told from others by one number. See CoverageTable.
 *
 * The picture is divided into four wedges about the light, each swept row by row in the direction in
 * which light flows, along y or (transposed) along x; lines are Spacing apart where they are widest. Bands
 * of lines are independent of each other. See vtkGodRaysShadowKernels.h.
 */

#ifndef vtkGodRaysCoverageKernels_h
#define vtkGodRaysCoverageKernels_h

#include "vtkGodRaysMedium.h" // For vtkGodRaysSpot

#include <cstddef>
#include <vector>

namespace vtkGodRays
{
/// Depth of what is nowhere.
constexpr float CoverageSky = 1e30f;

constexpr int CoverageMaximumPlanes = 6; // colours and components of the medium that differ

/// The light from the first part of a view ray, without its phase function unless the light is near: a
/// cubic between columns, linear between rows. A row belongs to
///  - a point light, in perspective: ln(1 + tan(a/2)/RowUnit), a being the angle of view ray and light,
///  - a point light and parallel rays: ln(1 + the light's distance from the view ray/RowUnit),
///  - layers, in perspective: asinh(rise of the view ray/RowUnit),
///  - layers and parallel rays: the height at which the view ray begins,
///  - a planet, in perspective: asinh((rise of the view ray - horizon's)/RowUnit),
///  - a planet and parallel rays: asinh(least height of the view ray's line/RowUnit);
/// a slice, cubic between slices, to where a ray lies about a point light in layers: the cosine of the
/// angle between the slices' axis and the ray's nearest way to the light's axis from the eye, seen along
/// that axis, or, of parallel rays, seen along the rays; where a spotlight fades from another axis than Up,
/// the tangent of a quarter of that angle itself, as what is left and right of Up is not alike; over a
/// planet, the cosine of the angle between view ray and light, or how much nearer to the light a parallel ray
/// begins than the eye;
/// a column to ln((1 + d) (1 + Change s)) for point lights, where s is the distance from the eye and
/// ln(1 + d) = asinh((s - foot)/height) - asinh(-foot/height), and to ln(1 + s/width) for layers; over a
/// planet as for point lights, the foot being where the view ray meets the densest of the air, and height
/// how far from there it falls by 1/e.
struct CoverageTable
{
  enum KindType
  {
    NONE, // the closed form
    POINT,
    LAYERS,
    PLANET
  };
  KindType Kind = NONE;
  int Rows = 0;
  int Columns = 0;
  int Slices = 1; // or at least 4, or, if linear between them, 2
  bool LinearSlices = false;
  float FirstSlice = 0.0f;
  float SlicesPerUnit = 0.0f;
  float FirstRow = 0.0f;
  float RowsPerUnit = 0.0f;
  float RowUnit = 1.0f;
  float ColumnsPerUnit = 0.0f;
  float Change = 0.0f; // of light, for each unit of length, where it is brightest
  float Nearest =
    0.0f; // sine of a point light's angle, or its distance if rays are parallel: at least
  float Distance = 0.0f;    // of a point light
  float LightRise = 0.0f;   // of the way to it, for each unit of length
  float InverseSide = 0.0f; // of the sine of the slices' axis and that way, or the view axis
  std::vector<float> InverseWidths; // of rows
  /// A planet, in distances of the eye from its centre. The table goes on smoothly within its shadow,
  /// which kernels take away.
  struct Globe
  {
    float Radius = 0.0f; // of the eye [scene units]
    float Ground = 0.0f; // its radius
    float Room = 0.0f;   // 1 - Ground^2
    float Excess = 0.0f; // of a parallel ray's line through the eye: least distance^2 - Ground^2
    float LightSlope = 0.0f; // cosine of the light and the vertical at the eye
    float Horizon = 0.0f;    // slope of a row of 0
    float Longest = 0.0f;    // of the picture's rays
    float Scale = 0.0f;      // least height in which the air thins by 1/e
    bool HasShadow = false;  // on the air before the picture's rays end
    float LampRoom = 0.0f;   // of a point light: its distance^2 from the centre - Ground^2
    float LampAlong = 0.0f;  // of the eye, from it along the vertical there [scene units]
  };
  Globe Planet;
  std::vector<float>
    Values[CoverageMaximumPlanes];            // by slices and rows: value and slope, of each column
  double Largest[CoverageMaximumPlanes] = {}; // light of a whole ray
};

/// Of a picture; for its transpose, x and y of vectors change places.
struct CoverageSettings
{
  double PixelSize; // at depth 1, or of a parallel projection [scene units]
  bool Parallel;
  bool Point;
  double Light[3];      // view coordinates: position, or direction of length 1
  double FarLimit;      // [scene units]
  int Channels;         // extinctions that differ: 1 or 3
  double Extinction[3]; // [1/scene unit], above 0; of the closed form
  int Planes;           // of what is hidden: Channels times components, if these differ
  double Up[3];         // of layers
  double
    SliceAxis[3]; // in planes with it and a point light's, rays are alike: Up, or a spotlight's
  bool Around;    // slices are all about the light's axis, at right angles to which are SliceAxis
  double SliceSide[3]; // and this one
  double EyeHeight;    // in layers
  double PlanetRadius; // 0: layers are plane
  vtkGodRaysSpot Spot;
  double Spacing = 2.0; // of lines where they are widest apart [pixels]
  const CoverageTable* Table;
};

/// A picture or its transpose, by planes. Depths are positive, CoverageSky at most.
struct CoverageImage
{
  int Width;
  int Height;
  double Center[2];                     // the view axis, whole numbers being the centres of pixels
  const float* Begins;                  // of view rays in a spotlight's cone; nullptr: at the eye
  const float* Ends;                    // of view rays
  float* Hidden[CoverageMaximumPlanes]; // result: of the light along the ray, what is hidden
};

/// A wedge of rows through which light flows up (Direction 1) or down (-1).
struct CoverageWedge
{
  double A, B, W;
  int Direction;
  int First; // row
  int Rows;
  int Widest;       // row
  double Spacing;   // of lines in it [pixels]
  double FirstLine; // where it crosses the widest row
  int Lines;
  int Bands;
};

constexpr int CoverageBandLines = 128;

/// The wedge of one direction; no Rows if there is none. Depends on the image's size and centre alone.
CoverageWedge MakeCoverageWedge(
  const CoverageSettings& settings, const CoverageImage& image, int direction);

/// The pixels of a row that belong to a wedge, first and last; last is below first if there are none.
void FindCoveragePixels(
  const CoverageWedge& wedge, const CoverageImage& image, int row, int& first, int& last);

/// Index of the pixel in which the light is seen, -1 if that is none; isCentred tells whether it is in
/// the pixel's very centre.
std::ptrdiff_t FindCoverageLight(
  const CoverageWedge& wedge, const CoverageImage& image, bool& isCentred);

/// Write to a pixel what is hidden before a view depth, and from another one on.
void HideCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float before, float from);

/// A phase function, linear between the entries of a table: the first half is over sin(a/2), a being
/// the scattering angle, from 0 to sin(45 degrees), the second over cos(a/2) back to 0.
using CoveragePhase = std::vector<float>;

/// How pixels shine: the sum over phases of phase x factor x light, for each component.
struct CoverageShade
{
  int Components;         // 1 or 3
  int Phases;             // 1 or 2
  CoveragePhase Table[2]; // not of point lights
  float Factors[2][3];
};

/// A row of the result, components interleaved.
void WriteCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row);
}

#endif
