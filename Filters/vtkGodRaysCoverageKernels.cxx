// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysCoverageKernels.cxx"
#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysCoverageKernels.h"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#ifndef vtkGodRaysCoverageKernels_once
#define vtkGodRaysCoverageKernels_once
namespace vtkGodRays
{
constexpr int MaximumIntervals = 16;

// The pixels of a row that belong to a wedge, first and last.
inline void FindCoveragePixels(
  const CoverageWedge& wedge, const CoverageImage& image, int row, int& first, int& last)
{
  const double reach = std::abs(wedge.W * row - wedge.B);
  double low = 0.0;
  double high = image.Width - 1.0;
  if (wedge.W != 0.0)
  {
    const double a = (wedge.A - reach) / wedge.W;
    const double b = (wedge.A + reach) / wedge.W;
    low = std::max(low, std::ceil(std::min(a, b)));
    high = std::min(high, std::floor(std::max(a, b)));
  }
  else if (std::abs(wedge.A) > reach)
  {
    high = -1.0;
  }
  first = static_cast<int>(std::min(low, image.Width + 0.0));
  last = static_cast<int>(std::max(high, -1.0));
}
}
#endif

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = HWY_CAPPED(float, 8);
using Float = hn::Vec<FloatTag>;
using IntTag = hn::RebindToSigned<FloatTag>;

HWY_INLINE int GetLanes()
{
  return static_cast<int>(hn::Lanes(FloatTag()));
}

//------------------------------------------------------------------------------
// 1 - e^-x for x >= 0, to 2e-7 of itself.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> Absorbed(Tag d, hn::Vec<Tag> x)
{
  const hn::RebindToSigned<Tag> di;
  const auto y = hn::Min(x, hn::Set(d, 80.0f));
  const auto k = hn::Round(hn::Mul(y, hn::Set(d, 1.44269504f)));
  auto f = hn::NegMulAdd(k, hn::Set(d, 0.693145752f), y);
  f = hn::NegMulAdd(k, hn::Set(d, 1.42860677e-6f), f);
  // 1 - e^-f
  auto p = hn::Set(d, 1.0f / 5040.0f);
  p = hn::NegMulAdd(f, p, hn::Set(d, 1.0f / 720.0f));
  p = hn::NegMulAdd(f, p, hn::Set(d, 1.0f / 120.0f));
  p = hn::NegMulAdd(f, p, hn::Set(d, 1.0f / 24.0f));
  p = hn::NegMulAdd(f, p, hn::Set(d, 1.0f / 6.0f));
  p = hn::NegMulAdd(f, p, hn::Set(d, 0.5f));
  p = hn::NegMulAdd(f, p, hn::Set(d, 1.0f));
  p = hn::Mul(f, p);
  const auto exponent = hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), hn::ConvertTo(di, k)));
  const auto power = hn::BitCast(d, exponent); // 2^-k
  return hn::MulAdd(power, p, hn::Sub(hn::Set(d, 1.0f), power));
}

//------------------------------------------------------------------------------
// What a line knows: disjoint hidden intervals, in any order, then empty ones at infinity.
struct Line
{
  HWY_ALIGN float Low[MaximumIntervals];
  HWY_ALIGN float High[MaximumIntervals];
};

//------------------------------------------------------------------------------
class Lines
{
public:
  Lines(int count, float farthest)
    : Intervals(hwy::AllocateAligned<Line>(count))
    , Counts(count, 0)
    , Farthest(farthest)
  {
    for (int i = 0; i < count; ++i)
    {
      std::fill_n(this->Intervals[i].Low, MaximumIntervals, Nowhere);
      std::fill_n(this->Intervals[i].High, MaximumIntervals, Nowhere);
    }
  }

  HWY_INLINE void Insert(int index, float a, float b)
  {
    if (a >= this->Farthest || !(b > a))
    {
      return;
    }
    Line& line = this->Intervals[index];
    const int count = this->Counts[index];
    unsigned int touched = 0;
    const FloatTag d;
    const int lanes = GetLanes();
    for (int i = 0; i < count; i += lanes)
    {
      const auto mask = hn::And(hn::Le(hn::Load(d, line.Low + i), hn::Set(d, b)),
        hn::Ge(hn::Load(d, line.High + i), hn::Set(d, a)));
      uint8_t bits[8] = {};
      hn::StoreMaskBits(d, mask, bits);
      touched |= static_cast<unsigned int>(bits[0]) << i;
    }
    if (touched == 0)
    {
      if (count < MaximumIntervals)
      {
        line.Low[count] = a;
        line.High[count] = b;
        this->Counts[index] = count + 1;
      }
      else
      {
        this->JoinNearest(line, a, b);
      }
      return;
    }
    this->Join(index, touched, a, b);
  }

  // The part of the light along a ray that is hidden up to h = last; rate h is optical depth.
  HWY_INLINE float Sum(int index, float rate, float start, float last) const
  {
    const Line& line = this->Intervals[index];
    const int count = this->Counts[index];
#if HWY_TARGET == HWY_SCALAR
    const FloatTag d;
    float sum = 0.0f;
    for (int i = 0; i < count; ++i)
    {
      const float low = std::max(std::min(line.Low[i], last), start) - start;
      const float high = std::max(std::min(line.High[i], last), start) - start;
      sum += hn::GetLane(Absorbed(d, hn::Set(d, rate * high))) -
        hn::GetLane(Absorbed(d, hn::Set(d, rate * low)));
    }
    return sum;
#else
    // Low ends in the lower half of a register, high ones in the upper.
    const HWY_CAPPED(float, 16) d;
    const hn::Half<decltype(d)> half;
    const int lanes = static_cast<int>(hn::Lanes(half));
    const auto begin = hn::Set(d, start);
    const auto end = hn::Set(d, last);
    const auto r = hn::Set(d, rate);
    auto sum = hn::Zero(half);
    for (int i = 0; i < count; i += lanes)
    {
      const auto ends = hn::Combine(d, hn::Load(half, line.High + i), hn::Load(half, line.Low + i));
      const auto inside = hn::Sub(hn::Max(hn::Min(ends, end), begin), begin);
      const auto absorbed = Absorbed(d, hn::Mul(r, inside));
      sum = hn::Add(sum, hn::Sub(hn::UpperHalf(half, absorbed), hn::LowerHalf(half, absorbed)));
    }
    return hn::GetLane(hn::SumOfLanes(half, sum));
#endif
  }

  int GetCount(int index) const
  {
    return this->Counts[index];
  }

  long long Overflows = 0;

private:
  // Into the first one touched; the others are replaced by the last ones.
  void Join(int index, unsigned int touched, float a, float b)
  {
    Line& line = this->Intervals[index];
    int count = this->Counts[index];
    int first = 0;
    while ((touched >> first & 1u) == 0)
    {
      ++first;
    }
    a = std::min(a, line.Low[first]);
    b = std::max(b, line.High[first]);
    touched &= touched - 1;
    for (int i = count - 1; touched != 0 && i > first; --i)
    {
      if ((touched >> i & 1u) != 0)
      {
        touched &= ~(1u << i);
        a = std::min(a, line.Low[i]);
        b = std::max(b, line.High[i]);
        --count;
        line.Low[i] = line.Low[count];
        line.High[i] = line.High[count];
        line.Low[count] = Nowhere;
        line.High[count] = Nowhere;
      }
    }
    line.Low[first] = a;
    line.High[first] = b;
    this->Counts[index] = count;
  }

  void JoinNearest(Line& line, float a, float b)
  {
    ++this->Overflows;
    int nearest = 0;
    float least = Nowhere;
    for (int i = 0; i < MaximumIntervals; ++i)
    {
      const float gap = line.Low[i] > b ? line.Low[i] - b : a - line.High[i];
      if (gap < least)
      {
        least = gap;
        nearest = i;
      }
    }
    line.Low[nearest] = std::min(a, line.Low[nearest]);
    line.High[nearest] = std::max(b, line.High[nearest]);
  }

  static constexpr float Nowhere = 3e38f;

  hwy::AlignedFreeUniquePtr<Line[]> Intervals;
  std::vector<int> Counts;
  float Farthest;
};

//------------------------------------------------------------------------------
// From depth to h in a row, and half a row before it.
struct Rate
{
  float Scale;
  float Shift;
  float operator()(float z) const { return this->Scale * z + this->Shift; }
};

//------------------------------------------------------------------------------
class Band
{
public:
  Band(const CoverageSettings& settings, const CoverageImage& image, const CoverageWedge& wedge,
    int band)
    : Settings(settings)
    , Image(image)
    , Wedge(wedge)
    , Begin(band * CoverageBandLines)
    , End(std::min(wedge.Lines, (band + 1) * CoverageBandLines))
    , IsLast(band == wedge.Bands - 1)
    , Recession(settings.Parallel ? settings.Light[2] * settings.PixelSize / wedge.AlongLight : 0.0)
    , Hidden(End - Begin, this->FindFarthest())
    , Before(End - Begin, CoverageSky)
    , Slopes(End - Begin, 0.0f)
  {
  }

  long long Sweep()
  {
    for (int n = 0; n < this->Wedge.Rows; ++n)
    {
      const int row = this->Wedge.First + n * this->Wedge.Direction;
      this->TakeSamples(n, row);
      this->WritePixels(n, row);
    }
    return this->Hidden.Overflows;
  }

private:
  double GetFlow(double row) const { return this->Wedge.W * row - this->Wedge.B; }

  Rate GetRate(double n) const
  {
    const double row = this->Wedge.First + n * this->Wedge.Direction;
    const double scale = this->GetFlow(row) / this->GetFlow(this->Wedge.Widest);
    return { static_cast<float>(this->Settings.Parallel ? 1.0 : std::max(0.0, scale)),
      static_cast<float>(this->Recession * n) };
  }

  float FindFarthest() const
  {
    const double last = this->Recession * (this->Wedge.Rows + 1.0);
    return static_cast<float>(1.01 * this->Settings.FarLimit + std::max(0.0, last));
  }

  // The row's samples of the lines change what is hidden.
  void TakeSamples(int n, int row)
  {
    const double scale = this->GetFlow(row) / this->GetFlow(this->Wedge.Widest);
    const double step = CoverageSpacing * scale;
    const double x0 = this->Wedge.FirstLine +
      (this->Wedge.W * this->Wedge.FirstLine - this->Wedge.A) / this->GetFlow(this->Wedge.Widest) *
        (row - this->Wedge.Widest);
    const double least = std::max<double>(this->Begin, std::ceil((-0.499 - x0) / step));
    const double most =
      std::min<double>(this->End - 1, std::floor((this->Image.Width - 0.501 - x0) / step));
    if (!(least <= most))
    {
      return;
    }
    const int first = static_cast<int>(least);
    const int last = static_cast<int>(most);
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * this->Image.Width;
    const Rate here = this->GetRate(n);
    const Rate half = this->GetRate(n - 0.5);
    const double start = x0 + first * step + 0.5;
    const float fstart = static_cast<float>(start);
    const float fstep = static_cast<float>(step);
    const int rightmost = this->Image.Width - 1;
    if (this->Settings.Layers > 0)
    {
      const Rate beyond = this->GetRate(n + 0.5);
      for (int l = first; l <= last; ++l)
      {
        const int x = std::min(static_cast<int>(fstart + fstep * (l - first)), rightmost);
        for (int layer = 0; layer < this->Settings.Layers; ++layer)
        {
          const float front = this->Image.Depths[2 * layer][offset + x];
          const float back = this->Image.Depths[2 * layer + 1][offset + x];
          if (front < CoverageSky)
          {
            const float far = back < CoverageSky && back > front
              ? back
              : front * static_cast<float>(1.0 + this->Settings.Thickness);
            const float low = n == 0 && this->Wedge.Covered ? 0.0f : half(front);
            this->Hidden.Insert(
              l - this->Begin, std::min(low, beyond(front)), std::max(half(far), beyond(far)));
          }
        }
      }
      return;
    }
    const float* depths = this->Image.Depths[0] + offset;
    const Rate before = this->GetRate(n - 1.0);
    const Rate enter = n == 0 && this->Wedge.Covered ? Rate{ 0.0f, 0.0f } : half;
    const float thickness = static_cast<float>(this->Settings.Thickness);
    const float jump = static_cast<float>(this->Settings.Jump);
    const float bend = static_cast<float>(this->Settings.Bend);
    const bool parallel = this->Settings.Parallel;
    for (int l = first; l <= last; ++l)
    {
      const int x = std::min(static_cast<int>(fstart + fstep * (l - first)), rightmost);
      const float z = depths[x];
      const int i = l - this->Begin;
      const float previous = this->Before[i];
      const bool solid = z < CoverageSky;
      const bool wasSolid = previous < CoverageSky;
      if (!solid && !wasSolid)
      {
        continue;
      }
      bool linked = false;
      if (solid && wasSolid)
      {
        const float affine = parallel ? z : 1.0f / z;
        const float slope = parallel ? z - previous : affine - 1.0f / previous;
        linked = std::abs(z - previous) < jump * std::min(z, previous) ||
          std::abs(slope - this->Slopes[i]) < bend * affine;
        this->Slopes[i] = slope;
      }
      else
      {
        this->Slopes[i] = 0.0f;
      }
      if (wasSolid && !linked)
      {
        this->InsertBetween(
          i, before(previous), half(previous), before.Scale * thickness * previous);
      }
      if (solid)
      {
        this->InsertBetween(
          i, linked ? before(previous) : enter(z), here(z), here.Scale * thickness * z);
      }
      this->Before[i] = z;
    }
  }

  HWY_INLINE void InsertBetween(int line, float a, float b, float thickness)
  {
    this->Hidden.Insert(line, std::min(a, b), std::max(a, b) + thickness);
  }

  // The row's pixels that are nearest to the band's lines.
  void WritePixels(int n, int row)
  {
    int first;
    int last;
    FindCoveragePixels(this->Wedge, this->Image, row, first, last);
    const double flow = this->GetFlow(row);
    const double gain = this->GetFlow(this->Wedge.Widest) / flow / CoverageSpacing;
    const double bias =
      (-this->Wedge.A * (this->Wedge.Widest - row) / flow - this->Wedge.FirstLine) /
      CoverageSpacing;
    const auto find = [&](int line)
    {
      return static_cast<int>(
        std::min(std::max(std::ceil((line - 0.5 - bias) / gain), first + 0.0), last + 1.0));
    };
    const int begin = this->Begin == 0 ? first : find(this->Begin);
    const int end = this->IsLast ? last + 1 : find(this->End);
    if (begin >= end)
    {
      return;
    }
    const Rate rate = this->GetRate(n);
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * this->Image.Width;
    const float* depths = this->Image.Depths[0] + offset;
    const float farLimit = static_cast<float>(this->Settings.FarLimit);
    const float pixel = static_cast<float>(this->Settings.PixelSize);
    const double middle = 0.5 * (this->Image.Width - 1.0);
    const float y = static_cast<float>((row - 0.5 * (this->Image.Height - 1.0)) * pixel);
    const float y2 = 1.0f + y * y;
    const float inverse = 1.0f / std::max(rate.Scale, 1e-30f);
    const float position = static_cast<float>(begin * gain + bias - this->Begin) + 0.5f;
    const float fgain = static_cast<float>(gain);
    const int most = this->End - this->Begin - 1;
    for (int x = begin; x < end; ++x)
    {
      const int line =
        std::min(std::max(static_cast<int>(position + fgain * (x - begin)), 0), most);
      if (this->Hidden.GetCount(line) == 0)
      {
        for (int c = 0; c < this->Settings.Channels; ++c)
        {
          this->Image.Hidden[c][offset + x] = 0.0f;
        }
        continue;
      }
      const float column = static_cast<float>((x - middle) * pixel);
      const float length = this->Settings.Parallel ? 1.0f : std::sqrt(column * column + y2);
      const float end2 = rate(std::min(depths[x], farLimit));
      for (int c = 0; c < this->Settings.Channels; ++c)
      {
        this->Image.Hidden[c][offset + x] = this->Hidden.Sum(line,
          static_cast<float>(this->Settings.Extinction[c]) * length * inverse, rate.Shift, end2);
      }
    }
  }

  const CoverageSettings& Settings;
  const CoverageImage& Image;
  const CoverageWedge& Wedge;
  const int Begin;
  const int End;
  const bool IsLast;
  const double Recession; // by which a light ray comes nearer from row to row
  Lines Hidden;
  std::vector<float> Before; // depths of the last samples
  std::vector<float> Slopes;
};

//------------------------------------------------------------------------------
long long RunCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band)
{
  return Band(settings, image, wedge, band).Sweep();
}

//------------------------------------------------------------------------------
void RunCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoveragePhase& phase, int y, int components, const double factors[3], float* row)
{
  const FloatTag d;
  const IntTag di;
  const int lanes = GetLanes();
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y) * image.Width;
  const float pixel = static_cast<float>(settings.PixelSize);
  const float height = static_cast<float>((y - 0.5 * (image.Height - 1.0)) * settings.PixelSize);
  const float middle = static_cast<float>(0.5 * (image.Width - 1.0));
  const float sign = phase.Back ? -1.0f : 1.0f;
  const int intervals = static_cast<int>(phase.Table.size()) - 1;
  const Float zero = hn::Zero(d);
  for (int x = 0; x < image.Width; x += lanes)
  {
    const int count = std::min(lanes, image.Width - x);
    HWY_ALIGN float buffer[8];
    const auto load = [&](const float* values)
    {
      if (count == lanes)
      {
        return hn::LoadU(d, values + offset + x);
      }
      std::fill_n(buffer, lanes, 0.0f);
      std::copy_n(values + offset + x, count, buffer);
      return hn::Load(d, buffer);
    };
    const Float column =
      (hn::Iota(d, static_cast<float>(x)) - hn::Set(d, middle)) * hn::Set(d, pixel);
    Float length = hn::Set(d, 1.0f);
    Float vx = zero;
    Float vy = zero;
    Float vz = length;
    if (!settings.Parallel)
    {
      length = hn::Sqrt(column * column + hn::Set(d, 1.0f + height * height));
      vz = hn::Set(d, 1.0f) / length;
      vx = column * vz;
      vy = hn::Set(d, height) * vz;
    }
    // Half the chord between the directions of view and light is sin(a/2).
    const Float dx = vx - hn::Set(d, sign * static_cast<float>(settings.Light[0]));
    const Float dy = vy - hn::Set(d, sign * static_cast<float>(settings.Light[1]));
    const Float dz = vz - hn::Set(d, sign * static_cast<float>(settings.Light[2]));
    const Float chord = hn::Sqrt(dx * dx + dy * dy + dz * dz) * hn::Set(d, 0.5f * intervals);
    const auto place = hn::Min(hn::ConvertTo(di, chord), hn::Set(di, intervals - 1));
    const Float t = chord - hn::ConvertTo(d, place);
    const Float left = hn::GatherIndex(d, phase.Table.data(), place);
    const Float right = hn::GatherIndex(d, phase.Table.data() + 1, place);
    const Float scattered = left + t * (right - left);
    const Float depth =
      hn::Min(load(image.Depths[0]), hn::Set(d, static_cast<float>(settings.FarLimit)));
    HWY_ALIGN float results[3][8];
    for (int c = 0; c < settings.Channels; ++c)
    {
      const Float rate = hn::Set(d, static_cast<float>(settings.Extinction[c])) * length;
      const Float hidden = hn::Max(load(image.Hidden[c]), zero);
      const Float lit = hn::Max(Absorbed(d, rate * depth) - hidden, zero);
      hn::Store(scattered * lit, d, results[c]);
    }
    for (int c = 0; c < components; ++c)
    {
      const float factor = static_cast<float>(factors[c]);
      const float* from = results[settings.Channels == 1 ? 0 : c];
      for (int i = 0; i < count; ++i)
      {
        row[(x + i) * components + c] = factor * from[i];
      }
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vtkGodRays
{
HWY_EXPORT(RunCoverageBand);
HWY_EXPORT(RunCoverageRow);

//------------------------------------------------------------------------------
CoverageWedge MakeCoverageWedge(
  const CoverageSettings& settings, const CoverageImage& image, bool transposed, int direction)
{
  const double across = settings.Light[transposed ? 1 : 0] / settings.PixelSize;
  const double along = settings.Light[transposed ? 0 : 1] / settings.PixelSize;
  CoverageWedge wedge = {};
  wedge.W = settings.Parallel ? 0.0 : settings.Light[2];
  wedge.A = across + wedge.W * 0.5 * (image.Width - 1.0);
  wedge.B = along + wedge.W * 0.5 * (image.Height - 1.0);
  wedge.AlongLight = std::abs(along * settings.PixelSize);
  wedge.Direction = direction;

  int low = image.Height;
  int high = -1;
  double left = 0.0;
  double right = -1.0;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (int row = 0; row < image.Height; ++row)
    {
      const double flow = wedge.W * row - wedge.B;
      if (!(flow * direction > 0.0))
      {
        continue;
      }
      if (pass == 0)
      {
        low = std::min(low, row);
        high = std::max(high, row);
        continue;
      }
      int ends[2];
      FindCoveragePixels(wedge, image, row, ends[0], ends[1]);
      if (ends[0] > ends[1])
      {
        continue;
      }
      for (const int x : ends)
      {
        const double place = x + (wedge.W * x - wedge.A) / flow * (wedge.Widest - row);
        const bool isFirst = left > right;
        left = isFirst ? place : std::min(left, place);
        right = isFirst ? place : std::max(right, place);
      }
    }
    if (low > high)
    {
      return wedge;
    }
    wedge.First = direction > 0 ? low : high;
    wedge.Rows = high - low + 1;
    const int last = low + high - wedge.First;
    wedge.Widest = wedge.W < 0.0 ? wedge.First : last;
  }
  if (left > right)
  {
    wedge.Rows = 0;
    return wedge;
  }
  wedge.FirstLine = left;
  wedge.Lines = static_cast<int>(std::ceil((right - left) / CoverageSpacing)) + 1;
  wedge.Bands = (wedge.Lines + CoverageBandLines - 1) / CoverageBandLines;

  if (wedge.W > 0.0)
  {
    const double x = std::floor(wedge.A / wedge.W + 0.5);
    const double y = std::floor(wedge.B / wedge.W + 0.5);
    wedge.Covered = x >= 0.0 && y >= 0.0 && x < image.Width && y < image.Height &&
      image.Depths[0][static_cast<std::ptrdiff_t>(y) * image.Width + static_cast<int>(x)] <
        CoverageSky;
  }
  return wedge;
}

//------------------------------------------------------------------------------
long long SweepCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band)
{
  return HWY_DYNAMIC_DISPATCH(RunCoverageBand)(settings, image, wedge, band);
}

//------------------------------------------------------------------------------
void WriteCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoveragePhase& phase, int y, int components, const double factors[3], float* row)
{
  HWY_DYNAMIC_DISPATCH(RunCoverageRow)(settings, image, phase, y, components, factors, row);
}
}
#endif
