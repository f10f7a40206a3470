// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysSweepKernels.cxx"
// Sets that differ too little from the others to be worth their code, and those whose registers
// have no size when the program is compiled (arm64 has NEON as well).
#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysSweepKernels.h"

#include <hwy/cache_control.h>
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = HWY_CAPPED(float, 16);
using Float = hn::Vec<FloatTag>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Int = hn::Vec<IntTag>;

constexpr float LargestFloat = std::numeric_limits<float>::max();

// Pixels that have the same number of taps.
constexpr int GroupedPixels = 16;

// Lanes that are computed together, in one or several registers: positions are rounded alike then.
constexpr int Group = 16;

// Sums below this are 0: numbers too small to be normalised are slow.
constexpr float Negligible = 1e-36f;

//------------------------------------------------------------------------------
HWY_INLINE int GetLanes()
{
  return static_cast<int>(hn::Lanes(FloatTag()));
}

//------------------------------------------------------------------------------
// Where in its group a register begins.
HWY_INLINE int FindLane(int index)
{
  return GetLanes() == Group ? 0 : index % Group;
}

//------------------------------------------------------------------------------
// Infinity would make NaN of black.
inline float ToFloat(double value)
{
  return static_cast<float>(std::min(value, static_cast<double>(LargestFloat)));
}

//------------------------------------------------------------------------------
// c + a b and c - a b, rounded twice: the same on every processor. This file is compiled with
// -ffp-contract=off, or compilers would join them where they can.
HWY_INLINE Float AddProduct(Float a, Float b, Float c)
{
  return a * b + c;
}
HWY_INLINE Float SubtractProduct(Float a, Float b, Float c)
{
  return c - a * b;
}

//------------------------------------------------------------------------------
// Where a row is read: as many places as there are lanes, step apart.
struct Places
{
  std::ptrdiff_t Base;
  Int Index; // from Base
  Float Fraction;
};

//------------------------------------------------------------------------------
// Lanes of a group of 16 from the given one on; position is that of the group's first. Rounding does
// not depend on how many lanes there are. maximum: of Index, when rounding goes beyond it.
HWY_INLINE Places FindPlaces(double position, float step, int lane, int maximum)
{
  const FloatTag d;
  const IntTag di;
  const double base = std::floor(position);
  const float start = static_cast<float>(position - base);
  const Float local = hn::Iota(d, static_cast<float>(lane)) * hn::Set(d, step) + hn::Set(d, start);
  const int first = lane == 0 ? 0 : static_cast<int>(static_cast<float>(lane) * step + start);
  Places places;
  places.Base = static_cast<std::ptrdiff_t>(base) + first;
  places.Index = hn::Min(hn::ConvertTo(di, local) - hn::Set(di, first), hn::Set(di, maximum));
  places.Fraction = local - hn::ConvertTo(d, places.Index + hn::Set(di, first));
  return places;
}

//------------------------------------------------------------------------------
// Lanes index[i] of Registers consecutive registers.
template <int Registers>
HWY_INLINE Float Look(const float* values, Int index)
{
  const FloatTag d;
  const IntTag di;
  const int lanes = GetLanes();
  if constexpr (Registers == 1)
  {
    return hn::TableLookupLanes(hn::LoadU(d, values), hn::IndicesFromVec(d, index));
  }
  else
  {
#if HWY_TARGET == HWY_AVX3
    if constexpr (Registers == 2)
    {
      return Float{ _mm512_permutex2var_ps(
        _mm512_loadu_ps(values), index.raw, _mm512_loadu_ps(values + 16)) };
    }
#endif
    const auto lane = hn::IndicesFromVec(d, hn::And(index, hn::Set(di, lanes - 1)));
    Float result = hn::TableLookupLanes(hn::LoadU(d, values), lane);
    for (int i = 1; i < Registers; ++i)
    {
      const auto beyond = hn::RebindMask(d, hn::Gt(index, hn::Set(di, i * lanes - 1)));
      result = hn::IfThenElse(
        beyond, hn::TableLookupLanes(hn::LoadU(d, values + i * lanes), lane), result);
    }
    return result;
  }
}

//------------------------------------------------------------------------------
// Linear between neighbours. Steps from one place to the next are at most Registers.
template <int Registers>
HWY_INLINE Float Read(const float* row, const Places& places)
{
  const Float left = Look<Registers>(row + places.Base, places.Index);
  const Float right = Look<Registers>(row + places.Base + 1, places.Index);
  return AddProduct(places.Fraction, right - left, left);
}

//------------------------------------------------------------------------------
// The cubic through b and c with the slopes (c - a)/2 and (d - b)/2 there.
HWY_INLINE Float Interpolate(Float a, Float b, Float c, Float e, Float fraction)
{
  const FloatTag d;
  const Float half = hn::Set(d, 0.5f);
  const Float difference = c - b;
  const Float slope = half * (c - a);
  const Float end = half * (e - b);
  // b + f (slope + f (3 difference - 2 slope - end + f (slope + end - 2 difference)))
  const Float third = SubtractProduct(hn::Set(d, 2.0f), difference, slope + end);
  const Float second = difference - slope - third;
  return AddProduct(fraction, AddProduct(fraction, AddProduct(fraction, third, second), slope), b);
}

//------------------------------------------------------------------------------
// How far the places of a register's lanes lie apart.
enum Reach
{
  NEAR,   // within one register
  MIDDLE, // within two, with the three neighbours
  FAR,    // within two
  ANY
};

//------------------------------------------------------------------------------
// Cubic between neighbours.
template <int Reach>
HWY_INLINE Float ReadSmoothly(const float* row, const Places& places)
{
  const FloatTag d;
  const float* from = row + places.Base;
#if HWY_TARGET == HWY_AVX3
  if constexpr (Reach == NEAR || Reach == MIDDLE)
  {
    const __m512 low = _mm512_loadu_ps(from - 1);
    const __m512 high = _mm512_loadu_ps(from + 15);
    const __m512i one = _mm512_set1_epi32(1);
    const __m512i a = places.Index.raw;
    const __m512i b = _mm512_add_epi32(a, one);
    const __m512i c = _mm512_add_epi32(b, one);
    const __m512i e = _mm512_add_epi32(c, one);
    return Interpolate(Float{ _mm512_permutex2var_ps(low, a, high) },
      Float{ _mm512_permutex2var_ps(low, b, high) }, Float{ _mm512_permutex2var_ps(low, c, high) },
      Float{ _mm512_permutex2var_ps(low, e, high) }, places.Fraction);
  }
#endif
  if constexpr (Reach == ANY)
  {
    return Interpolate(hn::GatherIndex(d, from - 1, places.Index),
      hn::GatherIndex(d, from, places.Index), hn::GatherIndex(d, from + 1, places.Index),
      hn::GatherIndex(d, from + 2, places.Index), places.Fraction);
  }
  else
  {
    constexpr int Registers = Reach == NEAR ? 1 : 2;
    return Interpolate(Look<Registers>(from - 1, places.Index), Look<Registers>(from, places.Index),
      Look<Registers>(from + 1, places.Index), Look<Registers>(from + 2, places.Index),
      places.Fraction);
  }
}

//------------------------------------------------------------------------------
// Four rows of four become columns.
HWY_INLINE void Transpose4(
  const float* from, std::ptrdiff_t fromStride, float* to, std::ptrdiff_t toStride)
{
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      to[j * toStride + i] = from[i * fromStride + j];
    }
  }
#else
  const hn::FixedTag<float, 4> d;
  const hn::FixedTag<double, 2> wide;
  const auto a = hn::LoadU(d, from);
  const auto b = hn::LoadU(d, from + fromStride);
  const auto c = hn::LoadU(d, from + 2 * fromStride);
  const auto e = hn::LoadU(d, from + 3 * fromStride);
  const auto lowAB = hn::BitCast(wide, hn::InterleaveLower(d, a, b));
  const auto lowCE = hn::BitCast(wide, hn::InterleaveLower(d, c, e));
  const auto highAB = hn::BitCast(wide, hn::InterleaveUpper(d, a, b));
  const auto highCE = hn::BitCast(wide, hn::InterleaveUpper(d, c, e));
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(wide, lowAB, lowCE)), d, to);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(wide, lowAB, lowCE)), d, to + toStride);
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(wide, highAB, highCE)), d, to + 2 * toStride);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(wide, highAB, highCE)), d, to + 3 * toStride);
#endif
}

//------------------------------------------------------------------------------
// Sixteen rows of sixteen become columns. All begin at lines of the cache, or nearly.
HWY_INLINE void Transpose16(
  const float* from, std::ptrdiff_t fromStride, float* to, std::ptrdiff_t toStride)
{
#if HWY_TARGET == HWY_AVX3
  const FloatTag d;
  const hn::RebindToFloat<hn::RepartitionToWide<IntTag>> wide;
  Float blocks[4][4]; // [row / 4][column % 4]: columns c, c + 4, c + 8, c + 12 of four rows
  for (int i = 0; i < 4; ++i)
  {
    const float* row = from + 4 * i * fromStride;
    const Float a = hn::LoadU(d, row);
    const Float b = hn::LoadU(d, row + fromStride);
    const Float c = hn::LoadU(d, row + 2 * fromStride);
    const Float e = hn::LoadU(d, row + 3 * fromStride);
    const auto lowAB = hn::BitCast(wide, hn::InterleaveLower(d, a, b));
    const auto lowCE = hn::BitCast(wide, hn::InterleaveLower(d, c, e));
    const auto highAB = hn::BitCast(wide, hn::InterleaveUpper(d, a, b));
    const auto highCE = hn::BitCast(wide, hn::InterleaveUpper(d, c, e));
    blocks[i][0] = hn::BitCast(d, hn::InterleaveLower(wide, lowAB, lowCE));
    blocks[i][1] = hn::BitCast(d, hn::InterleaveUpper(wide, lowAB, lowCE));
    blocks[i][2] = hn::BitCast(d, hn::InterleaveLower(wide, highAB, highCE));
    blocks[i][3] = hn::BitCast(d, hn::InterleaveUpper(wide, highAB, highCE));
  }
  for (int c = 0; c < 4; ++c)
  {
    const __m512 even01 = _mm512_shuffle_f32x4(blocks[0][c].raw, blocks[1][c].raw, 0x88);
    const __m512 even23 = _mm512_shuffle_f32x4(blocks[2][c].raw, blocks[3][c].raw, 0x88);
    const __m512 odd01 = _mm512_shuffle_f32x4(blocks[0][c].raw, blocks[1][c].raw, 0xdd);
    const __m512 odd23 = _mm512_shuffle_f32x4(blocks[2][c].raw, blocks[3][c].raw, 0xdd);
    float* column = to + c * toStride;
    hn::StoreU(Float{ _mm512_shuffle_f32x4(even01, even23, 0x88) }, d, column);
    hn::StoreU(Float{ _mm512_shuffle_f32x4(odd01, odd23, 0x88) }, d, column + 4 * toStride);
    hn::StoreU(Float{ _mm512_shuffle_f32x4(even01, even23, 0xdd) }, d, column + 8 * toStride);
    hn::StoreU(Float{ _mm512_shuffle_f32x4(odd01, odd23, 0xdd) }, d, column + 12 * toStride);
  }
#else
  for (int i = 0; i < 16; i += 4)
  {
    for (int j = 0; j < 16; j += 4)
    {
      Transpose4(from + i * fromStride + j, fromStride, to + j * toStride + i, toStride);
    }
  }
#endif
}

//------------------------------------------------------------------------------
// The first float at or after values that begins a line of the cache.
inline float* Align(float* values)
{
  const auto address = reinterpret_cast<std::uintptr_t>(values) / sizeof(float);
  return values + (16 - address % 16) % 16;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
// One band of a wedge on its way along the rows, in some components at once.
template <int Channels>
class BandSweep
{
public:
  // axis: what the strip has left, or null for the strip itself.
  BandSweep(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
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
      channel.Gain = ToFloat(plan.March.Gain / MeanKernel(plan.March.K) / channel.Image->Scale);
      channel.LightValue = static_cast<float>(channel.Image->Sample(plan.Light[0], plan.Light[1]));
    }
    std::fill_n(this->OutputLast, StripRows, -1);
    this->PrepareAxis(axis ? *axis : workspace);
    this->Prepare(workspace);
  }

  template <int Powers>
  void Run()
  {
    const SweepRow* previous = nullptr;
    int count = 0;
    for (const SweepRow& row : this->Wedge.Schedule)
    {
      if (++count % ClearedRows == 0)
      {
        this->ClearNegligible<Powers>();
      }
      if (row.Refine)
      {
        this->Refine<Powers>(*previous, row);
      }
      if (this->FindLines(row))
      {
        this->LoadRow(row);
        this->AdvanceLines<Powers>(row);
        if (row.Output)
        {
          this->WriteRow(row);
        }
      }
      previous = &row;
    }
    this->FlushStrip();
  }

private:
  static constexpr int StripRows = 16;
  static constexpr int ClearedRows = 8;
  static constexpr int StripMargin = 48;
  static constexpr int PrefetchRows = 64;

  // phi(k), the mean of e^(-k t) over t in [0, 1].
  static double MeanKernel(double k) { return std::abs(k) < 1e-12 ? 1.0 : -std::expm1(-k) / k; }

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

  //----------------------------------------------------------------------------
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
      const Float slope =
        AddProduct(hn::Iota(d, static_cast<float>(i)), step, hn::Set(d, static_cast<float>(start)));
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

  //----------------------------------------------------------------------------
  // Lines.

  // Where lines of one octave lie among those of a coarser one: Start + Ratio line.
  struct Map
  {
    double Start;
    double Ratio;

    double Find(int line) const { return this->Start + this->Ratio * line; }
  };
  Map FindCoarse(int fine, int coarse) const
  {
    const SweepOctave& from = this->Octaves[fine];
    const SweepOctave& to = this->Octaves[coarse];
    return { (from.FirstSlope - to.FirstSlope) / to.SlopeStep, std::ldexp(1.0, fine - coarse) };
  }

  // From one row to the next; then the sums that make the result, if one is wanted.
  template <int Powers>
  void AdvanceLines(const SweepRow& row)
  {
    if (!row.Output || row.Tail < 0)
    {
      this->AdvanceLines<Powers, false>(row, Map{ 0.0, 0.0 });
      this->StoreRow<Powers>(row);
      return;
    }
    const Map coarse = this->FindCoarse(row.Octave, this->Wedge.HistoryOctaves[row.Tail]);
    if (row.Store >= 0)
    {
      // It may be what the row's own end reads.
      this->AdvanceLines<Powers, false>(row, coarse);
      this->StoreRow<Powers>(row);
      this->BlendTail(row, coarse);
      this->SubtractTail(coarse);
      return;
    }
    this->BlendTail(row, coarse);
    this->AdvanceLines<Powers, true>(row, coarse);
  }

  template <int Powers, bool Subtracts>
  void AdvanceLines(const SweepRow& row, const Map& coarse)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    Float pole[Powers];
    Float before[Powers];
    Float after[Powers];
    Float factor[Powers];
    for (int j = 0; j < Powers; ++j)
    {
      pole[j] = hn::Set(d, row.Pole[j]);
      before[j] = hn::Set(d, row.Before[j]);
      after[j] = hn::Set(d, row.After[j]);
      factor[j] = hn::Set(d, this->Wedge.Factors[j]);
    }
    const double position = this->Position - this->FirstPixel;
    const float step = static_cast<float>(this->Step);
    const float ratio = static_cast<float>(coarse.Ratio);
    for (int l = this->FirstLine; l < this->EndLine; l += lanes)
    {
      const int lane = FindLane(l);
      const Places places = FindPlaces(position + (l - lane) * this->Step, step, lane, lanes - 1);
      Places ends;
      if (Subtracts)
      {
        ends = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
      }
      for (int c = 0; c < Channels; ++c)
      {
        SweepChannel& channel = this->Channel[c];
        const Float now = Read<1>(channel.Smooth, places);
        const Float then = hn::Load(d, channel.State[Powers] + l);
        hn::Store(now, d, channel.State[Powers] + l);
        Float sum = hn::Zero(d);
        for (int j = 0; j < Powers; ++j)
        {
          Float state = AddProduct(before[j], then, after[j] * now);
          state = AddProduct(pole[j], hn::Load(d, channel.State[j] + l), state);
          hn::Store(state, d, channel.State[j] + l);
          sum = AddProduct(factor[j], state, sum);
        }
        if (Subtracts)
        {
          sum = sum - Read<1>(channel.Tail, ends);
        }
        hn::Store(sum, d, channel.Sums + l);
      }
    }
  }

  // Every few rows.
  template <int Powers>
  void ClearNegligible()
  {
    const FloatTag d;
    const Float negligible = hn::Set(d, Negligible);
    for (SweepChannel& channel : this->Channel)
    {
      for (int j = 0; j < Powers; ++j)
      {
        for (int l = this->FirstLine; l < this->EndLine; l += GetLanes())
        {
          const Float state = hn::Load(d, channel.State[j] + l);
          const Float kept = hn::IfThenElseZero(hn::Gt(hn::Abs(state), negligible), state);
          hn::Store(kept, d, channel.State[j] + l);
        }
      }
    }
  }

  template <int Powers>
  void StoreRow(const SweepRow& row)
  {
    if (row.Store >= 0)
    {
      this->StoreHistory<Powers>(row.Store, row.Distance, this->FirstLine, this->EndLine);
    }
  }

  // The sum that ends of marches subtract, times s: it is smoother than the sum near the light.
  template <int Powers>
  void StoreHistory(int entry, double distance, int first, int end)
  {
    const FloatTag d;
    const Float scale = hn::Set(d, static_cast<float>(distance));
    for (SweepChannel& channel : this->Channel)
    {
      float* history = channel.History + this->Wedge.HistoryOffsets[entry];
      for (int l = first; l < end; l += GetLanes())
      {
        Float sum = hn::Zero(d);
        for (int j = 0; j < Powers; ++j)
        {
          const Float factor = hn::Set(d, this->Wedge.TailFactors[j]);
          sum = AddProduct(factor, hn::Load(d, channel.State[j] + l), sum);
        }
        hn::Store(scale * sum, d, history + l);
      }
    }
  }

  // The two rows of the history are blended where there are fewer lines: in their own octave.
  void BlendTail(const SweepRow& row, const Map& coarse)
  {
    const FloatTag d;
    const int first = static_cast<int>(coarse.Find(this->FirstLine)) / Group * Group;
    const int end = static_cast<int>(coarse.Find(this->EndLine)) + 2;
    const Float blend = hn::Set(d, row.TailBlend);
    const Float scale = hn::Set(d, row.TailScale);
    for (SweepChannel& channel : this->Channel)
    {
      const float* here = channel.History + this->Wedge.HistoryOffsets[row.Tail];
      const float* next = channel.History + this->Wedge.HistoryOffsets[row.Tail + 1];
      for (int l = first; l < end; l += GetLanes())
      {
        const Float a = hn::Load(d, here + l);
        const Float b = hn::Load(d, next + l);
        hn::Store(AddProduct(blend, b - a, a) * scale, d, channel.Tail + l);
      }
    }
  }

  void SubtractTail(const Map& coarse)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const float ratio = static_cast<float>(coarse.Ratio);
    for (int l = this->FirstLine; l < this->EndLine; l += lanes)
    {
      const int lane = FindLane(l);
      const Places places = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
      for (SweepChannel& channel : this->Channel)
      {
        const Float tail = Read<1>(channel.Tail, places);
        hn::Store(hn::Load(d, channel.Sums + l) - tail, d, channel.Sums + l);
      }
    }
  }

  // Interpolate the states to the lines of a finer octave.
  template <int Powers>
  void Refine(const SweepRow& previous, const SweepRow& row)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const Map coarse = this->FindCoarse(row.Octave, previous.Octave);
    const float ratio = static_cast<float>(coarse.Ratio);
    const int lines = this->Octaves[row.Octave].Lines;
    for (SweepChannel& channel : this->Channel)
    {
      for (int j = 0; j <= Powers; ++j)
      {
        if (this->IsAxis)
        {
          std::copy_n(
            channel.State[j], this->Stride, this->GetAxisState(channel, previous.Octave, j));
        }
        for (int l = 0; l < lines; l += lanes)
        {
          const int lane = FindLane(l);
          const Places places = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
          hn::Store(ReadSmoothly<NEAR>(channel.State[j], places), d, channel.Spare[j] + l);
        }
        std::swap(channel.State[j], channel.Spare[j]);
        if (this->HasAxis)
        {
          this->TakeFromAxis(channel, j, previous.Octave, row.Octave);
        }
      }
    }
    if (row.RefineStore >= 0)
    {
      this->StoreHistory<Powers>(row.RefineStore, previous.Distance, 0, lines);
    }
  }

  // The strip's states before a refinement.
  float* GetAxisState(const SweepChannel& channel, int octave, int power) const
  {
    return channel.AxisStates +
      (static_cast<std::ptrdiff_t>(octave) * (this->Wedge.Powers + 1) + power) * this->Stride;
  }

  // The states of lines in the axis strip.
  void TakeFromAxis(SweepChannel& channel, int power, int coarse, int fine)
  {
    const SweepOctave& axis = this->Wedge.AxisOctaves[coarse];
    const SweepOctave& octave = this->Octaves[fine];
    const double start = this->GetSlope(octave);
    const double low = std::ceil((-axis.HalfWidth - start) / octave.SlopeStep);
    const double high = std::floor((axis.HalfWidth - start) / octave.SlopeStep);
    const float* states = this->GetAxisState(channel, coarse, power);
    const int end = static_cast<int>(std::min(high, octave.Lines - 1.0));
    for (int l = static_cast<int>(std::max(low, 0.0)); l <= end; ++l)
    {
      const double position = (start + l * octave.SlopeStep - axis.FirstSlope) / axis.SlopeStep;
      const int left = static_cast<int>(position);
      const float f = static_cast<float>(position - left);
      channel.State[power][l] = states[left] + f * (states[left + 1] - states[left]);
    }
  }

  //----------------------------------------------------------------------------
  // Results.

  // Whether the wedge owns a pixel; the wedges together own each pixel once.
  bool Owns(int column, double distance) const
  {
    const double across = std::abs(column - this->Wedge.LightColumn);
    return this->Wedge.Transposed ? across < distance : across <= distance;
  }

  // Pixels of the band in a row; wedge and image end them at both sides.
  void FindPixels(const SweepRow& row, int& first, int& last) const
  {
    const SweepWedge& w = this->Wedge;
    const double end = w.Columns - 1.0;
    const double s = row.Distance;
    auto find = [&](double slope)
    { return static_cast<int>(std::ceil(Clamp(w.LightColumn + slope * s, -2.0, end + 2.0))); };
    first = std::max(0, this->First ? find(-1.0) - 1 : find(this->LowSlope));
    last = std::min(w.Columns - 1, this->Last ? find(1.0) + 1 : find(this->HighSlope) - 1);
    while (first <= last && !this->Owns(first, s))
    {
      ++first;
    }
    while (first <= last && !this->Owns(last, s))
    {
      --last;
    }
  }

  static double Clamp(double value, double low, double high)
  {
    return std::min(std::max(value, low), high);
  }

  // Pixels of the axis strip in a row.
  void FindAxisPixels(const SweepRow& row, int& first, int& last) const
  {
    const double reach = this->Octaves[row.Octave].HalfWidth * row.Distance;
    const double column = this->Wedge.LightColumn;
    first = static_cast<int>(std::max(0.0, std::ceil(column - reach)));
    last = static_cast<int>(std::min(this->Wedge.Columns - 1.0, std::floor(column + reach)));
  }

  // What the axis strip has found, instead.
  void TakePixelsFromAxis(const SweepRow& row, int first, int last, float* const to[Channels]) const
  {
    const int* columns = this->AxisColumns.data() + 2 * row.OutputIndex;
    const int begin = std::max(first, columns[0]);
    const int end = std::min(last, columns[1]);
    for (int c = 0; c < Channels && begin <= end; ++c)
    {
      const float* from = this->GetAxisPixels(c, row);
      std::copy(
        from + (begin - columns[0]), from + (end + 1 - columns[0]), to[c] + (begin - first));
    }
  }

  float* GetAxisPixels(int c, const SweepRow& row) const
  {
    return this->Channel[c].AxisPixels +
      static_cast<std::ptrdiff_t>(row.OutputIndex) * this->Wedge.AxisPixels;
  }

  void WriteRow(const SweepRow& row)
  {
    int first;
    int last;
    if (this->IsAxis)
    {
      this->FindAxisPixels(row, first, last);
    }
    else
    {
      this->FindPixels(row, first, last);
    }
    if (first > last)
    {
      return;
    }
    const double position = (first - this->Position) / this->Step; // in lines
    const double step = 1.0 / this->Step;
    float* to[Channels];
    this->FindTargets(row, first, last, to);
    const int lanes = GetLanes();
    const int count = last - first + 1;
    const double reach = (lanes - 1) * step + 1.0;
    if (reach < lanes)
    {
      this->WritePixels<NEAR>(position, step, lanes - 1, to, count);
    }
    else if (reach < 2 * lanes - 3)
    {
      this->WritePixels<MIDDLE>(position, step, 2 * lanes - 4, to, count);
    }
    else if (reach < 2 * lanes)
    {
      this->WritePixels<FAR>(position, step, 2 * lanes - 1, to, count);
    }
    else
    {
      this->WritePixels<ANY>(position, step, std::numeric_limits<int>::max(), to, count);
    }
    if (this->HasAxis)
    {
      this->TakePixelsFromAxis(row, first, last, to);
    }
  }

  template <int Reach>
  HWY_INLINE void WritePixels(
    double position, double step, int maximum, float* const to[Channels], int count)
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    int i = 0;
    for (; i + lanes <= count; i += lanes)
    {
      const int lane = FindLane(i);
      const double start = std::max(1.0, position + (i - lane) * step);
      const Places places = FindPlaces(start, static_cast<float>(step), lane, maximum);
      for (int c = 0; c < Channels; ++c)
      {
        hn::StoreU(this->FindResult<Reach>(this->Channel[c], places), d, to[c] + i);
      }
    }
    if (i < count)
    {
      const int lane = FindLane(i);
      const double start = std::max(1.0, position + (i - lane) * step);
      Places places = FindPlaces(start, static_cast<float>(step), lane, maximum);
      // Those beyond the last pixel read lines that may not exist; they are dropped.
      places.Base = std::min<std::ptrdiff_t>(places.Base, this->Stride - 3);
      places.Index =
        hn::Min(places.Index, hn::Set(di, static_cast<int>(this->Stride - 3 - places.Base)));
      for (int c = 0; c < Channels; ++c)
      {
        HWY_ALIGN float rest[Group];
        hn::Store(this->FindResult<Reach>(this->Channel[c], places), d, rest);
        std::copy(rest, rest + (count - i), to[c] + i);
      }
    }
  }

  template <int Reach>
  static HWY_INLINE Float FindResult(const SweepChannel& channel, const Places& places)
  {
    const FloatTag d;
    const Float sum = ReadSmoothly<Reach>(channel.Sums, places) * hn::Set(d, channel.Gain);
    return hn::Max(hn::Min(sum, hn::Set(d, LargestFloat)), hn::Zero(d));
  }

  // Where pixels first to last of a row are written.
  void FindTargets(const SweepRow& row, int first, int last, float* to[Channels])
  {
    if (this->IsAxis)
    {
      this->AxisColumns[2 * row.OutputIndex] = first;
      this->AxisColumns[2 * row.OutputIndex + 1] = last;
      for (int c = 0; c < Channels; ++c)
      {
        to[c] = this->GetAxisPixels(c, row);
      }
      return;
    }
    if (!this->Wedge.Transposed)
    {
      for (int c = 0; c < Channels; ++c)
      {
        const SweepResult& result = this->Channel[c].Result;
        to[c] = result.Values + row.Row * result.Stride + first;
      }
      return;
    }
    const int strip = (row.Row + this->OutputShift) / StripRows;
    if (strip != this->OutputStrip)
    {
      this->FlushStrip();
      this->OutputStrip = strip;
    }
    const int column = (row.Row + this->OutputShift) % StripRows;
    this->OutputFirst[column] = first;
    this->OutputLast[column] = last;
    for (int c = 0; c < Channels; ++c)
    {
      to[c] = this->GetOutputRow(this->Channel[c], column) + first;
    }
  }

  float* GetOutputRow(const SweepChannel& channel, int column) const
  {
    return channel.Strips + (2 * StripRows + column) * this->StripStride;
  }

  // Write a strip of columns into the image; most 16 x 16 blocks are complete.
  void FlushStrip()
  {
    if (this->OutputStrip < 0)
    {
      return;
    }
    int begin = 0;
    int end = std::numeric_limits<int>::max();
    for (int i = 0; i < StripRows; ++i)
    {
      begin = std::max(begin, this->OutputFirst[i]);
      end = std::min(end, this->OutputLast[i] + 1);
    }
    begin = (begin + 15) / 16 * 16;
    end = std::max(begin, end / 16 * 16);
    for (SweepChannel& channel : this->Channel)
    {
      const std::ptrdiff_t stride = channel.Result.Stride;
      float* to = channel.Result.Values + (this->OutputStrip * StripRows - this->OutputShift);
      const float* from = this->GetOutputRow(channel, 0);
      for (int y = begin; y < end; y += 16)
      {
        Transpose16(from + y, this->StripStride, to + y * stride, stride);
      }
      for (int column = 0; column < StripRows; ++column)
      {
        const float* values = from + column * this->StripStride;
        const int last = this->OutputLast[column];
        for (int y = this->OutputFirst[column]; y <= last && y < begin; ++y)
        {
          to[y * stride + column] = values[y];
        }
        for (int y = std::max(end, this->OutputFirst[column]); y <= last; ++y)
        {
          to[y * stride + column] = values[y];
        }
      }
    }
    std::fill_n(this->OutputFirst, StripRows, 0);
    std::fill_n(this->OutputLast, StripRows, -1);
    this->OutputStrip = -1;
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

//------------------------------------------------------------------------------
template <int Channels>
void RunChannels(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  SweepWorkspace* axis, SweepWorkspace& workspace, const SweepResult* results)
{
  BandSweep<Channels> sweep(plan, wedge, band, images, axis, workspace, results);
  switch (wedge.Powers)
  {
    case 1:
      return sweep.template Run<1>();
    case 2:
      return sweep.template Run<2>();
    case 3:
      return sweep.template Run<3>();
    case 4:
      return sweep.template Run<4>();
    case 5:
      return sweep.template Run<5>();
    default:
      return sweep.template Run<6>();
  }
}

//------------------------------------------------------------------------------
void RunBand(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  int channels, SweepWorkspace* axis, SweepWorkspace& workspace, const SweepResult* results)
{
  if (channels == 3)
  {
    return RunChannels<3>(plan, wedge, band, images, axis, workspace, results);
  }
  RunChannels<1>(plan, wedge, band, images, axis, workspace, results);
}

//------------------------------------------------------------------------------
// Taps.

//------------------------------------------------------------------------------
// The part of t in [0, 1] where position + t velocity is in [-1, size].
HWY_INLINE void Clip(Float position, Float velocity, float size, Float& begin, Float& end)
{
  const FloatTag d;
  const Float low = hn::Set(d, -1.0f);
  const Float high = hn::Set(d, size);
  const auto still = hn::Lt(hn::Abs(velocity), hn::Set(d, 1e-20f));
  const Float safe = hn::IfThenElse(still, hn::Set(d, 1.0f), velocity);
  const Float a = (low - position) / safe;
  const Float b = (high - position) / safe;
  begin = hn::IfThenElse(still, begin, hn::Max(begin, hn::Min(a, b)));
  end = hn::IfThenElse(still, end, hn::Min(end, hn::Max(a, b)));
}

//------------------------------------------------------------------------------
// The image between four pixels, 0 outside.
HWY_INLINE Float SampleImage(const SweepImage& image, Float x, Float y)
{
  const FloatTag d;
  const IntTag di;
  x = hn::Max(hn::Min(x, hn::Set(d, static_cast<float>(image.Width))), hn::Set(d, -1.0f));
  y = hn::Max(hn::Min(y, hn::Set(d, static_cast<float>(image.Height))), hn::Set(d, -1.0f));
  const Float left = hn::Floor(x);
  const Float low = hn::Floor(y);
  const Float fx = x - left;
  const Float fy = y - low;
  const Int stride = hn::Set(di, static_cast<int>(image.Stride));
  const Int index = hn::ConvertTo(di, low) * stride + hn::ConvertTo(di, left);
  const float* origin = image.GetRow(0);
  const Float a = hn::GatherIndex(d, origin, index);
  const Float b = hn::GatherIndex(d, origin + 1, index);
  const Float c = hn::GatherIndex(d, origin + image.Stride, index);
  const Float e = hn::GatherIndex(d, origin + image.Stride + 1, index);
  const Float lower = AddProduct(fx, b - a, a);
  const Float upper = AddProduct(fx, e - c, c);
  return AddProduct(fy, upper - lower, lower);
}

//------------------------------------------------------------------------------
// Within how much of t in [0, reach] a march is over the image.
inline double FindStretch(
  const vtkGodRaysMarch& march, const SweepImage& image, double reach, const double position[2])
{
  const double size[2] = { static_cast<double>(image.Width), static_cast<double>(image.Height) };
  double begin = 0.0;
  double end = reach;
  for (int i = 0; i < 2; ++i)
  {
    const double velocity = march.Constant[i] - march.Slope * position[i];
    if (velocity != 0.0)
    {
      const double a = (-1.0 - position[i]) / velocity;
      const double b = (size[i] - position[i]) / velocity;
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
  }
  return std::max(0.0, end - begin);
}

//------------------------------------------------------------------------------
// How many taps the longest march of some pixels of row y needs: the number does not depend on how
// many lanes there are. Taps h pixels apart miss at most 0.06 h^2 of what a single bright pixel, or
// a steep kernel, contributes.
inline int CountTaps(const vtkGodRaysMarch& march, const SweepImage& image, double reach,
  double tolerance, int y, int first, int last)
{
  double length = 0.0;
  double stretch = 0.0;
  for (const int x : { first, (first + last) / 2, last })
  {
    const double position[2] = { static_cast<double>(x), static_cast<double>(y) };
    const double part = FindStretch(march, image, reach, position);
    stretch = std::max(stretch, part);
    length = std::max(length,
      part * std::hypot(march.Constant[0] - march.Slope * x, march.Constant[1] - march.Slope * y));
  }
  const double steepness = std::abs(march.K) * stretch;
  const double spacing = std::sqrt(tolerance / 0.09);
  const double wanted = std::max({ 4.0, length / std::min(std::max(spacing, 0.02), 1.0),
    steepness / std::sqrt(8.0 * tolerance) });
  return static_cast<int>(std::ceil(std::min(wanted, 1e6)));
}

//------------------------------------------------------------------------------
// Midpoint taps; each has the weight that the kernel has in its stretch:
//   L = Gain/phi(k) sum_i e^(-k t_i) sinh(z)/z dt s(p + t_i v),  z = k dt/2
void RunTaps(const vtkGodRaysMarch& march, const SweepImage& image, double tolerance, int y,
  int firstPixel, int lastPixel, float* to)
{
  const FloatTag d;
  const int lanes = GetLanes();
  const double k = march.K;
  const float origin = k < 0.0 ? 1.0f : 0.0f; // of t, so that the weights are at most 1
  const double mean = std::abs(k) < 1e-12 ? 1.0 : k < 0.0 ? std::expm1(k) / k : -std::expm1(-k) / k;
  const double gain = march.Gain / mean / static_cast<double>(image.Scale);
  // Beyond it is nothing of importance.
  const double reach = std::min(1.0, std::log(100.0 / tolerance) / std::max(k, 1e-300));
  const Float rate = hn::Set(d, static_cast<float>(-k));
  const Float one = hn::Set(d, 1.0f);
  const Float lane = hn::Iota(d, 0.0f);
  const Float vy =
    hn::Set(d, static_cast<float>(march.Constant[1] - march.Slope * static_cast<double>(y)));
  const Float py = hn::Set(d, static_cast<float>(y));
  for (int group = firstPixel; group <= lastPixel; group += GroupedPixels)
  {
    const int groupEnd = std::min(group + GroupedPixels, lastPixel + 1);
    const int taps = CountTaps(march, image, reach, tolerance, y, group, groupEnd - 1);
    for (int x = group; x < groupEnd; x += lanes)
    {
      const Float offset = lane + hn::Set(d, static_cast<float>(x - group));
      const Float px = hn::Set(d, static_cast<float>(group)) + offset;
      const Float vx = SubtractProduct(offset, hn::Set(d, static_cast<float>(march.Slope)),
        hn::Set(d, static_cast<float>(march.Constant[0] - march.Slope * group)));
      Float begin = hn::Zero(d);
      Float end = hn::Set(d, static_cast<float>(reach));
      Clip(px, vx, static_cast<float>(image.Width), begin, end);
      Clip(py, vy, static_cast<float>(image.Height), begin, end);
      const Float step = (hn::Max(begin, end) - begin) * hn::Set(d, static_cast<float>(1.0 / taps));
      const Float z = hn::Set(d, 0.5f) * rate * step;
      const Float z2 = z * z;
      const Float sinhc =
        AddProduct(z2, AddProduct(z2, hn::Set(d, 1.0f / 120.0f), hn::Set(d, 1.0f / 6.0f)), one);
      Float sum = hn::Zero(d);
      for (int i = 0; i < taps; ++i)
      {
        const Float t = AddProduct(hn::Set(d, i + 0.5f), step, begin);
        const Float weight = hn::Exp(d, rate * (t - hn::Set(d, origin)));
        const Float sample = SampleImage(image, AddProduct(t, vx, px), AddProduct(t, vy, py));
        sum = AddProduct(weight, sample, sum);
      }
      Float value = sum * step * sinhc * hn::Set(d, ToFloat(gain));
      value = hn::Max(hn::Min(value, hn::Set(d, LargestFloat)), hn::Zero(d));
      HWY_ALIGN float values[16];
      hn::Store(value, d, values);
      std::copy_n(values, std::min(lanes, groupEnd - x), to + (x - firstPixel));
    }
  }
}

//------------------------------------------------------------------------------
// NaN and negative numbers become 0, infinity the largest float.
void LoadFloats(const float* pixels, int step, int count, float scale, float* row)
{
  const FloatTag d;
  const int lanes = GetLanes();
  const Float zero = hn::Zero(d);
  const Float largest = hn::Set(d, LargestFloat);
  const Float factor = hn::Set(d, scale);
  int i = 0;
  if (step == 1)
  {
    for (; i + lanes <= count; i += lanes)
    {
      const Float value = hn::LoadU(d, pixels + i);
      const Float positive = hn::IfThenElse(hn::Gt(value, zero), value, zero);
      hn::StoreU(hn::Min(positive, largest) * factor, d, row + i);
    }
  }
  for (; i < count; ++i)
  {
    const float value = pixels[static_cast<std::ptrdiff_t>(i) * step];
    row[i] = (value > 0.0f ? std::min(value, LargestFloat) : 0.0f) * scale;
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vtkGodRays
{
HWY_EXPORT(RunBand);
HWY_EXPORT(RunTaps);
HWY_EXPORT(LoadFloats);

//------------------------------------------------------------------------------
void SweepAxis(const SweepPlan& plan, const SweepWedge& wedge, const SweepImage* images,
  int channels, SweepWorkspace& workspace)
{
  if (!wedge.AxisOctaves.empty())
  {
    HWY_DYNAMIC_DISPATCH(RunBand)
    (plan, wedge, 0, images, channels, nullptr, workspace, nullptr);
  }
}

//------------------------------------------------------------------------------
void SweepBand(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  int channels, SweepWorkspace& axis, SweepWorkspace& workspace, const SweepResult* results)
{
  HWY_DYNAMIC_DISPATCH(RunBand)(plan, wedge, band, images, channels, &axis, workspace, results);
}

//------------------------------------------------------------------------------
void SumClippedTaps(const vtkGodRaysMarch& march, const SweepImage& image, double tolerance, int y,
  int first, int last, float* to)
{
  HWY_DYNAMIC_DISPATCH(RunTaps)(march, image, tolerance, y, first, last, to);
}

//------------------------------------------------------------------------------
void LoadPixels(const float* pixels, int step, int count, float scale, float* row)
{
  HWY_DYNAMIC_DISPATCH(LoadFloats)(pixels, step, count, scale, row);
}

//------------------------------------------------------------------------------
void LoadPixels(const unsigned char* pixels, int step, int count, float scale, float* row)
{
  const float factor = scale / 255.0f;
  for (int i = 0; i < count; ++i)
  {
    row[i] = factor * pixels[static_cast<std::ptrdiff_t>(i) * step];
  }
}

//------------------------------------------------------------------------------
void LoadPixels(const double* pixels, int step, int count, float scale, float* row)
{
  const double largest = std::numeric_limits<float>::max();
  for (int i = 0; i < count; ++i)
  {
    const double value = pixels[static_cast<std::ptrdiff_t>(i) * step];
    row[i] = static_cast<float>(
      (value > 0.0 ? std::min(value, largest) : 0.0) * static_cast<double>(scale));
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GetInstructionSets()
{
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::string> names;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    names.push_back(hwy::TargetName(target));
  }
  return names;
}

//------------------------------------------------------------------------------
bool UseInstructionSet(const std::string& name)
{
  hwy::SetSupportedTargetsForTest(0);
  bool found = name.empty();
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    if (hwy::TargetName(target) == name)
    {
      hwy::SetSupportedTargetsForTest(target);
      found = true;
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return found;
}
}
#endif
