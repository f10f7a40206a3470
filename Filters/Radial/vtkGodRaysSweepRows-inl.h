// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled for each set of vector instructions: see vtkGodRaysSweepKernels.cxx.
#if defined(vtkGodRaysSweepRows_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysSweepRows_inl_h
#undef vtkGodRaysSweepRows_inl_h
#else
#define vtkGodRaysSweepRows_inl_h
#endif

#include "vtkGodRaysMath.h"
#include "vtkGodRaysSweepKernels.h"
#include "vtkGodRaysSweepLanes-inl.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// What is one component's own.
struct SweepChannel
{
  const SweepImage* Image = nullptr;
  SweepResult Result = { nullptr, 0 };
  float LightValue = 0.0f;
  float Gain = 0.0f;

  float* State[MaximumPowers + 1] = {};
  float* Spare[MaximumPowers + 1] = {};
  float* Sums = nullptr;
  float* Tail = nullptr;
  float* Raw = nullptr;
  float* Smooth = nullptr;
  float* History = nullptr;
  float* Strips = nullptr;
  float* AxisStates = nullptr;
  float* AxisPixels = nullptr;
  int LoadedStrip[2] = { -1, -1 };
};

// A band of a wedge and the rows of pixels that it meets, in some components at once.
template <int Channels>
class BandRows
{
public:
  // axis: what the strip has left, or null for the strip itself.
  BandRows(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
    SweepWorkspace* axis, SweepWorkspace& workspace, const SweepResult* results)
    : Wedge(wedge)
    , Octaves(axis ? wedge.Octaves : wedge.AxisOctaves)
    , AxisColumns(axis ? axis->AxisColumns : workspace.AxisColumns)
    , Last(band + 1 == wedge.Bands)
    , First(band == 0)
    , IsAxis(!axis)
    , HasAxis(axis && !wedge.AxisOctaves.empty())
    , LowSlope(axis ? wedge.FirstSlope + band * wedge.BandWidth : 0.0)
    , HighSlope(wedge.FirstSlope + (band + 1) * wedge.BandWidth)
    , Stride(wedge.GetStride())
  {
    for (int c = 0; c < Channels; ++c)
    {
      SweepChannel& channel = this->Channel[c];
      channel.Image = &images[c];
      channel.Result = results ? results[c] : channel.Result;
      channel.Gain =
        ToFloat(plan.March.Gain / MeanExponential(plan.March.K) / channel.Image->Scale);
      channel.LightValue = static_cast<float>(channel.Image->Sample(plan.Light[0], plan.Light[1]));
    }
    std::fill_n(this->OutputLast, StripRows, -1);
    this->PrepareAxis(axis ? *axis : workspace);
    this->Prepare(workspace);
  }

protected:
  static constexpr int StripRows = 16;
  static constexpr int StripMargin = 48;
  static constexpr int PrefetchRows = 64;

  // How many floats that begin a line of the cache; memory is kept.
  static float* Resize(std::vector<float>& values, std::size_t size)
  {
    if (values.size() < size + 16)
    {
      values.resize(size + 16);
    }
    return Align(values.data());
  }

  void Prepare(SweepWorkspace& workspace)
  {
    const int powers = this->Wedge.Powers;
    const std::ptrdiff_t size = (2 * powers + 4) * this->Stride;
    const std::ptrdiff_t width = this->Stride + StripMargin * 2;
    float* lines = Resize(workspace.Lines, static_cast<std::size_t>(Channels * size));
    float* pixels = Resize(workspace.Pixels, static_cast<std::size_t>(Channels * 2 * width));
    const std::size_t history = static_cast<std::size_t>(this->Wedge.HistorySize);
    float* sums = Resize(workspace.History, Channels * history);
    if (this->Wedge.HasTail)
    {
      std::fill_n(sums, Channels * history, 0.0f);
    }
    for (int c = 0; c < Channels; ++c)
    {
      SweepChannel& channel = this->Channel[c];
      this->PrepareLines(channel, lines + c * size);
      channel.Raw = pixels + 2 * c * width;
      channel.Smooth = channel.Raw + width;
      channel.History = sums + c * history;
    }
    if (this->Wedge.Transposed)
    {
      this->PrepareStrips(workspace);
    }
  }

  void PrepareLines(SweepChannel& channel, float* lines) const
  {
    const int powers = this->Wedge.Powers;
    for (int j = 0; j <= powers; ++j) // the last one holds the image at the row before
    {
      const float factor = static_cast<float>(j < powers ? this->Wedge.InitialState[j] : 1.0);
      channel.State[j] = lines + j * this->Stride;
      channel.Spare[j] = lines + (powers + 1 + j) * this->Stride;
      const bool lit = this->Wedge.StartsAtLight;
      std::fill_n(channel.State[j], this->Stride, lit ? factor * channel.LightValue : 0.0f);
      std::fill_n(channel.Spare[j], this->Stride, 0.0f);
    }
    channel.Sums = lines + (2 * powers + 2) * this->Stride;
    channel.Tail = channel.Sums + this->Stride;
    std::fill_n(channel.Sums, 2 * this->Stride, 0.0f);
  }

  void PrepareStrips(SweepWorkspace& workspace)
  {
    const float* target = this->Channel[0].Result.Values;
    const auto address = reinterpret_cast<std::uintptr_t>(target) / sizeof(float);
    this->OutputShift = static_cast<int>(address % StripRows);
    // Zeros about the pixels, as in the image.
    this->StripStride = (this->Wedge.Columns + 15) / 16 * 16 + 2 * SweepImage::Padding;
    const std::ptrdiff_t size = 3 * StripRows * this->StripStride + 2 * SweepImage::Padding;
    const std::size_t all = static_cast<std::size_t>(Channels * size) + 16;
    if (workspace.Strips.size() != all || workspace.StripColumns != this->Wedge.Columns)
    {
      workspace.Strips.assign(all, 0.0f);
      workspace.StripColumns = this->Wedge.Columns;
    }
    for (int c = 0; c < Channels; ++c)
    {
      this->Channel[c].Strips = Align(workspace.Strips.data()) + c * size + SweepImage::Padding;
    }
  }

  // Where the axis strip leaves what it finds.
  void PrepareAxis(SweepWorkspace& workspace)
  {
    const std::ptrdiff_t states = static_cast<std::ptrdiff_t>(this->Wedge.AxisOctaves.size()) *
      (this->Wedge.Powers + 1) * this->Stride;
    const std::ptrdiff_t pixels =
      static_cast<std::ptrdiff_t>(this->Wedge.OutputRows) * this->Wedge.AxisPixels;
    if (this->IsAxis)
    {
      Resize(workspace.AxisStates, static_cast<std::size_t>(Channels * states));
      Resize(workspace.AxisPixels, static_cast<std::size_t>(Channels * pixels));
      this->AxisColumns.resize(2 * static_cast<std::size_t>(this->Wedge.OutputRows));
      for (std::size_t i = 0; i < this->AxisColumns.size(); ++i)
      {
        this->AxisColumns[i] = i % 2 ? -1 : 0;
      }
    }
    if (this->IsAxis || this->HasAxis)
    {
      for (int c = 0; c < Channels; ++c)
      {
        this->Channel[c].AxisStates = Align(workspace.AxisStates.data()) + c * states;
        this->Channel[c].AxisPixels = Align(workspace.AxisPixels.data()) + c * pixels;
      }
    }
  }

  // Slope of a band's line 0 in an octave.
  double GetSlope(const SweepOctave& octave) const { return this->LowSlope + octave.FirstSlope; }

  // The lines of the band that are over the image in a row, as whole groups; false if none.
  bool FindLines(const SweepRow& row)
  {
    const SweepOctave& octave = this->Octaves[row.Octave];
    const double s = row.Distance;
    this->Position = this->Wedge.LightColumn + this->GetSlope(octave) * s;
    this->Step = octave.SlopeStep * s;
    // Two more on each side: the neighbours of pixels at the edges.
    const double first = std::max(0.0, std::floor((-1.0 - this->Position) / this->Step) - 2.0);
    const double last = std::min(
      octave.Lines - 1.0, std::ceil((this->Wedge.Columns - this->Position) / this->Step) + 2.0);
    if (!(first <= last))
    {
      return false;
    }
    this->FirstLine = static_cast<int>(first) / Group * Group;
    this->EndLine = (static_cast<int>(last) / Group + 1) * Group;
    return true;
  }

  // Rows of pixels.

  // The pixels that the lines meet, smoothed, in Smooth[0 ... PixelCount + some].
  void LoadRow(const SweepRow& row)
  {
    const int lanes = GetLanes();
    const int first =
      static_cast<int>(std::floor(this->Position + this->FirstLine * this->Step)) - 1;
    const int last =
      static_cast<int>(std::floor(this->Position + (this->EndLine - 1) * this->Step)) + 2;
    this->FirstPixel = first;
    const int count = last - first + 1;
    const float* pixels[Channels];
    for (int c = 0; c < Channels; ++c)
    {
      SweepChannel& channel = this->Channel[c];
      if (row.Blend == 0.0f)
      {
        pixels[c] = this->GetPixels(channel, row.Row) + first;
        continue;
      }
      float* raw = channel.Raw + lanes;
      this->CopyPixels(channel, row.Row, first - 1, count + 2, raw - 1);
      this->CopyPixels(channel, row.Row + 1, first - 1, count + 2, channel.Smooth);
      BlendPixels(raw - 1, channel.Smooth, count + 2, row.Blend);
      pixels[c] = raw;
    }
    this->SmoothPixels(row, pixels, count);
  }

  // Pixels first to first + count of a row, 0 outside the image.
  void CopyPixels(SweepChannel& channel, int row, int first, int count, float* to)
  {
    const int begin = std::min(std::max(0, first), first + count);
    const int end = std::max(begin, std::min(this->Wedge.Columns, first + count));
    if (row < 0 || row >= this->Wedge.Rows)
    {
      std::fill_n(to, count, 0.0f);
      return;
    }
    const float* from = this->GetPixels(channel, row);
    std::fill_n(to, begin - first, 0.0f);
    std::copy(from + begin, from + end, to + (begin - first));
    std::fill_n(to + (end - first), first + count - end, 0.0f);
  }

  static void BlendPixels(float* pixels, const float* next, int count, float blend)
  {
    const FloatTag d;
    for (int i = 0; i < count; i += GetLanes())
    {
      const Float a = hn::LoadU(d, pixels + i);
      const Float b = hn::LoadU(d, next + i);
      hn::StoreU(AddProduct(hn::Set(d, blend), b - a, a), d, pixels + i);
    }
  }

  // c = (h slope)^2/12, slope = (x - light)/s; see vtkGodRaysSectorSweep.h.
  void SmoothPixels(const SweepRow& row, const float* const raw[Channels], int count)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const double scale = this->Wedge.Smooth ? row.Height / (std::sqrt(12.0) * row.Distance) : 0.0;
    const double start = scale * (this->FirstPixel - this->Wedge.LightColumn);
    const Float step = hn::Set(d, static_cast<float>(scale));
    const Float largest = hn::Set(d, 0.25f);
    for (int i = 0; i < count; i += lanes)
    {
      const Float slope = AddProduct(
        CountFrom(d, static_cast<float>(i)), step, hn::Set(d, static_cast<float>(start)));
      const Float factor = hn::Min(slope * slope, largest);
      for (int c = 0; c < Channels; ++c)
      {
        const float* from = raw[c] + i;
        const Float middle = hn::LoadU(d, from);
        const Float sides = hn::LoadU(d, from - 1) + hn::LoadU(d, from + 1);
        const Float excess = SubtractProduct(hn::Set(d, 2.0f), middle, sides);
        hn::StoreU(AddProduct(factor, excess, middle), d, this->Channel[c].Smooth + i);
      }
    }
  }

  // A row of the wedge, from its first pixel on.
  const float* GetPixels(SweepChannel& channel, int row)
  {
    return this->Wedge.Transposed ? this->GetTransposed(channel, row) : channel.Image->GetRow(row);
  }

  // Columns of the image become rows 16 at a time, in two strips by turns: rows between pixels need
  // one of each.
  const float* GetTransposed(SweepChannel& channel, int column)
  {
    const int strip = column / StripRows;
    float* values = channel.Strips + (strip % 2) * StripRows * this->StripStride;
    if (channel.LoadedStrip[strip % 2] != strip)
    {
      channel.LoadedStrip[strip % 2] = strip;
      int first;
      int last;
      this->FindStripRange(strip, first, last);
      const int begin = std::max(0, first) / 16 * 16;
      const int end = std::min(this->Wedge.Columns, last + 1);
      const std::ptrdiff_t stride = channel.Image->Stride;
      for (int y = begin; y < end; y += 16)
      {
        const float* from = channel.Image->GetRow(y) + strip * StripRows;
        for (int i = 0; i < 16 && y + PrefetchRows < end; ++i)
        {
          hwy::Prefetch(from + (i + PrefetchRows) * stride);
        }
        Transpose16(from, stride, values + y, this->StripStride);
      }
    }
    return values + (column % StripRows) * this->StripStride;
  }

  // What the band may read in a strip's rows.
  void FindStripRange(int strip, int& first, int& last) const
  {
    const SweepWedge& w = this->Wedge;
    const double margin = StripMargin + (this->IsAxis ? w.AxisPixels : 0);
    double low = w.Columns;
    double high = 0.0;
    for (const int row : { strip * StripRows - 1, strip * StripRows + StripRows })
    {
      const double s = std::max(0.0, w.Direction * (row - w.LightRow));
      low = std::min(low, w.LightColumn + (this->IsAxis ? 0.0 : this->LowSlope * s));
      high = std::max(high, w.LightColumn + (this->IsAxis ? 0.0 : this->HighSlope * s));
    }
    first = static_cast<int>(std::max(low - margin, -1.0));
    last = static_cast<int>(std::min(high + margin, w.Columns + 1.0));
  }

  const SweepWedge& Wedge;
  const std::vector<SweepOctave>& Octaves;
  std::vector<int>& AxisColumns;
  const bool Last;
  const bool First;
  const bool IsAxis;
  const bool HasAxis;
  const double LowSlope;
  const double HighSlope;
  const int Stride;

  SweepChannel Channel[Channels];
  std::ptrdiff_t StripStride = 0;
  int OutputStrip = -1;
  int OutputShift = 0; // so that columns of a strip share lines of the cache
  int OutputFirst[StripRows] = {};
  int OutputLast[StripRows] = {};

  // In the present row:
  double Position = 0.0; // of line 0 [pixels]
  double Step = 0.0;     // from one line to the next [pixels]
  int FirstLine = 0;
  int EndLine = 0;
  int FirstPixel = 0; // Smooth[0]
};
}
}
HWY_AFTER_NAMESPACE();

#endif
