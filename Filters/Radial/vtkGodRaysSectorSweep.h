// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSectorSweep.h
 * @brief   the radial integral along lines through the light, by running sums
 *
 * Private. The plane about the light falls into four wedges, |dx| <= |dy| and the rest, each up and
 * down. In a wedge the lines x = light.x + slope s through the light are followed from one row of
 * pixels to the next, s being the distance from the light in rows. A line has a state of a few
 * running sums, one for each power of a PowerSum:
 *
 *     G_j(r) = r^-(p_j+1) integral s^p_j I ds           over what has been passed, up to r
 *     G_j(r) = Pole_j G_j(r') + Before_j I(r') + After_j I(r)         from one row to the next
 *     L(r)   = 1/|d| sum_j c_j [G_j(r) - q^(p_j+1) G_j(q r)],  q = 1 - d
 *
 * where I is linear between r' and r. A march towards the light sweeps away from it, and one away
 * from it (d < 0) sweeps towards it; the formulas are the same. G_j(q r) is read from a history of
 * sums, if the march ends within the image. Columns are rows of the transposed image in the two
 * other wedges; "line" always means a line through the light, "row" a row or column of pixels.
 *
 * Near the light lines are closer together than pixels are, and so fewer do: at distances s <= top/2,
 * top/4, ... every second line is left out ("octaves"), and states are interpolated to the new
 * lines where a sweep away from the light passes from one octave to the next.
 *
 * A row of pixels whose line passes the light within few pixels runs along one line of the fan, and
 * so does all that it shows: what lies across it is as sharp after the sum as before, and lines a
 * pixel apart are too few. The same holds for columns. So each wedge has an axis strip: a few pixels
 * on either side of slope 0, a band by itself with lines a quarter of a pixel apart, which becomes
 * narrower (in slopes) from octave to octave. It writes its pixels, and the bands take their states
 * from it where they refine.
 *
 * A line meets a row between two pixels, and from one row to the next it passes along both: exactly,
 * the integral weighs each row with a triangle of half width |slope| (h, with rows h apart) about
 * the meeting point. The rows are smoothed by that much, [c, 1 - 2 c, c] with c = (h slope)^2/12,
 * which has the same variance, before they are read. Without it, thin features would leave noise.
 *
 * Figures: Documentation/Evidence/Accuracy.md.
 */

#ifndef vtkGodRaysSectorSweep_h
#define vtkGodRaysSectorSweep_h

#include "vtkGodRaysMarch.h"
#include "vtkGodRaysPowerSum.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vtkGodRays
{
/**
 * The pixels of one component: finite, not negative, their sums finite. Zeros surround them.
 */
struct SweepImage
{
  static constexpr int Padding = 32; ///< columns on each side; below are 2 rows and above 22

  float Scale = 1.0f; ///< a power of 2 that the values have been multiplied by
  int Width = 0;
  int Height = 0;
  std::ptrdiff_t Stride = 0;
  std::vector<float> Values;

  void Resize(int width, int height);
  /// Every 16 pixels from the first one on share a line of the cache.
  float* GetRow(int y) { return this->Values.data() + this->GetIndex(y); }
  const float* GetRow(int y) const { return this->Values.data() + this->GetIndex(y); }
  /// Bilinear, 0 outside; a pixel's centre has whole numbers.
  double Sample(double x, double y) const;

private:
  std::ptrdiff_t GetIndex(int y) const { return (y + 2) * this->Stride + Padding + this->Offset; }

  std::ptrdiff_t Offset = 0;
};

/**
 * What accuracy takes; see vtkGodRaysScatteringFilter::GetPlan().
 */
struct SweepEffort
{
  double Spacing = 1.0; ///< of lines where they are farthest apart [pixels], at most 1
  double FitTolerance = 1e-3;
  double SubrowReach = 48.0; ///< within it rows are divided: into 4, and 2 within three times that
  double NearRadius = 16.0;  ///< within it taps are taken [pixels]
  double TapTolerance = 1e-3;
  bool Smooth = true;
  bool Octaves = true;
  bool Axis = true;
};

/**
 * Part of a march that lies within the image: from the pixel up to a fraction End, beyond which
 * there is nothing, or else up to 1, where history may be needed.
 */
struct SweepRow
{
  double Distance = 0.0; ///< from the light, s [pixels]
  int Row = 0;           ///< the row of pixels at or below it
  float Blend = 0.0f;    ///< how far to the next one
  float Height = 1.0f;   ///< distance to the row before
  int Octave = 0;
  bool Output = false; ///< a row of pixels that is wanted
  int OutputIndex = 0; ///< how many of them come before
  bool Refine = false; ///< first one of a finer octave
  int Store = -1;      ///< where in the history, if it is needed
  int RefineStore = -1;
  int Tail = -1; ///< the history entry at or before q s
  float TailBlend = 0.0f;
  float TailScale = 0.0f;
  float Pole[MaximumPowers];
  float Before[MaximumPowers];
  float After[MaximumPowers];
};

struct SweepOctave
{
  double FirstSlope = 0.0; ///< of line 0; of a band: from the band's first slope on
  double SlopeStep = 0.0;  ///< from one line to the next
  int Lines = 0;           ///< of one band, with margins
  double HalfWidth = 0.0;  ///< of the axis strip [slope]
};

struct SweepWedge
{
  static constexpr int Margin = 2; ///< lines before a band's first

  bool Transposed = false;
  double LightRow = 0.0;
  double LightColumn = 0.0;
  int Rows = 0;
  int Columns = 0;
  int Direction = 1; ///< of s: up or down
  int FirstOutputRow = 0;

  double FirstSlope = 0.0;
  double BandWidth = 0.0; ///< in slopes
  int Bands = 0;
  int Powers = 0;
  float Factors[MaximumPowers] = {};
  float TailFactors[MaximumPowers] = {};
  double InitialState[MaximumPowers] = {}; ///< factor on the image at the light
  bool StartsAtLight = false;
  bool HasTail = false;
  bool Smooth = true;
  std::vector<SweepOctave> Octaves;     ///< 0 is the finest
  std::vector<SweepOctave> AxisOctaves; ///< of the axis strip; empty if there is none
  int AxisPixels = 0;                   ///< of the strip in a row, at most
  int OutputRows = 0;
  std::vector<SweepRow> Schedule;
  std::vector<int> HistoryOctaves;
  std::vector<std::ptrdiff_t> HistoryOffsets;
  std::ptrdiff_t HistorySize = 0;

  int GetStride() const; ///< of states [floats]
};

/**
 * The memory of one band; kept from one sweep to the next.
 */
struct SweepWorkspace
{
  std::vector<float> AxisStates; ///< what an axis strip leaves: the states before each refinement
  std::vector<float> AxisPixels; ///< and its pixels, row by row
  std::vector<int> AxisColumns;  ///< first and last one in each row
  std::vector<float> Lines;
  std::vector<float> Pixels;
  std::vector<float> Strips;
  int StripColumns = 0; ///< beyond which strips are 0
  std::vector<float> History;
};

/**
 * All that can be decided without the image.
 */
struct SweepPlan
{
  int Width = 0;
  int Height = 0;
  vtkGodRaysMarch March;
  SweepEffort Effort;
  double Light[2] = { 0.0, 0.0 }; ///< as used; far ones are brought nearer
  double Density = 0.0;           ///< fraction of the way to the light; negative: away from it
  double End = 1.0;               ///< of the kernel's fit
  PowerSum Kernel;
  std::array<double, 4> Fitted = {}; ///< what Kernel is for; it is kept from plan to plan
  double NearRadius = 0.0;
  std::vector<SweepWedge> Wedges; ///< up to 4
  int NumberOfWedges = 0;
};

/**
 * Fill in plan.Wedges and so on; width, height, march, effort are given. Returns false if the sweep
 * cannot keep the tolerance here, and why.
 */
bool PlanSweep(SweepPlan& plan, const char*& reason);
}

#endif
