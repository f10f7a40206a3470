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

// What a line knows: disjoint hidden intervals, in any order, then empty ones at infinity.
struct CoverageLine
{
  HWY_ALIGN float Low[MaximumIntervals];
  HWY_ALIGN float High[MaximumIntervals];
};

class CoverageLines
{
public:
  hwy::AlignedFreeUniquePtr<CoverageLine[]> Intervals =
    hwy::AllocateAligned<CoverageLine>(CoverageBandLines);
  int Counts[CoverageBandLines];
  float Before[CoverageBandLines]; // depths of the last samples
  float Slopes[CoverageBandLines];
};

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
// The lines of a band.
class Lines
{
public:
  Lines(CoverageLines& lines, int count, float farthest)
    : Intervals(lines.Intervals.get())
    , Counts(lines.Counts)
    , Farthest(farthest)
  {
    std::fill_n(this->Counts, count, 0);
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
    CoverageLine& line = this->Intervals[index];
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
    const CoverageLine& line = this->Intervals[index];
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
    CoverageLine& line = this->Intervals[index];
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

  void JoinNearest(CoverageLine& line, float a, float b)
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

  CoverageLine* const Intervals;
  int* const Counts;
  const float Farthest;
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
    int band, CoverageLines& lines)
    : Settings(settings)
    , Image(image)
    , Wedge(wedge)
    , Begin(band * CoverageBandLines)
    , End(std::min(wedge.Lines, (band + 1) * CoverageBandLines))
    , IsLast(band == wedge.Bands - 1)
    , Recession(settings.Parallel ? settings.Light[2] * settings.PixelSize / wedge.AlongLight : 0.0)
    , Covered(FindIfCovered(image, wedge))
    , Hidden(lines, End - Begin, this->FindFarthest())
    , Before(lines.Before)
    , Slopes(lines.Slopes)
  {
    std::fill_n(this->Before, this->End - this->Begin, CoverageSky);
    std::fill_n(this->Slopes, this->End - this->Begin, 0.0f);
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

  // Whether the light is seen, but for a surface before it.
  static bool FindIfCovered(const CoverageImage& image, const CoverageWedge& wedge)
  {
    bool isCentred;
    const std::ptrdiff_t pixel = FindCoverageLight(wedge, image, isCentred);
    return wedge.W > 0.0 && pixel >= 0 && image.Depths[0][pixel] < CoverageSky;
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
            const float low = n == 0 && this->Covered ? 0.0f : half(front);
            this->Hidden.Insert(
              l - this->Begin, std::min(low, beyond(front)), std::max(half(far), beyond(far)));
          }
        }
      }
      return;
    }
    const float* depths = this->Image.Depths[0] + offset;
    const Rate before = this->GetRate(n - 1.0);
    const Rate enter = n == 0 && this->Covered ? Rate{ 0.0f, 0.0f } : half;
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
    const float* ends = this->Image.Ends + offset;
    const float farLimit = static_cast<float>(this->Settings.FarLimit);
    const float pixel = static_cast<float>(this->Settings.PixelSize);
    const double middle = this->Image.Center[0];
    const float y = static_cast<float>((row - this->Image.Center[1]) * pixel);
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
      const float last = rate(std::min(ends[x], farLimit));
      for (int c = 0; c < this->Settings.Channels; ++c)
      {
        this->Image.Hidden[c][offset + x] = this->Hidden.Sum(line,
          static_cast<float>(this->Settings.Extinction[c]) * length * inverse, rate.Shift, last);
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
  const bool Covered;
  Lines Hidden;
  float* const Before;
  float* const Slopes;
};

//------------------------------------------------------------------------------
long long RunCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, CoverageLines& lines)
{
  return Band(settings, image, wedge, band, lines).Sweep();
}

//------------------------------------------------------------------------------
void RunCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float begin, float end)
{
  const FloatTag d;
  const double column = (pixel % image.Width - image.Center[0]) * settings.PixelSize;
  const double row = (pixel / image.Width - image.Center[1]) * settings.PixelSize;
  const double length = settings.Parallel ? 1.0 : std::sqrt(column * column + row * row + 1.0);
  const float last = std::min(image.Ends[pixel], static_cast<float>(settings.FarLimit));
  for (int c = 0; c < settings.Channels; ++c)
  {
    const float rate = static_cast<float>(settings.Extinction[c] * length);
    const auto absorbed = [&](float z)
    { return hn::GetLane(Absorbed(d, hn::Set(d, rate * std::min(z, last)))); };
    // All of the ray is all, whatever rounding makes of its length.
    image.Hidden[c][pixel] =
      begin <= 0.0f && end >= last ? 2.0f : std::max(absorbed(end) - absorbed(begin), 0.0f);
  }
}

//------------------------------------------------------------------------------
void RunCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row)
{
  const FloatTag d;
  const IntTag di;
  const int lanes = GetLanes();
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y) * image.Width;
  const Float pixel = hn::Set(d, static_cast<float>(settings.PixelSize));
  const float height = static_cast<float>((y - image.Center[1]) * settings.PixelSize);
  const Float middle = hn::Set(d, static_cast<float>(image.Center[0]));
  const Float farLimit = hn::Set(d, static_cast<float>(settings.FarLimit));
  const Float lightX = hn::Set(d, static_cast<float>(settings.Light[0]));
  const Float lightY = hn::Set(d, static_cast<float>(settings.Light[1]));
  const Float lightZ = hn::Set(d, static_cast<float>(settings.Light[2]));
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
    const Float column = (hn::Iota(d, static_cast<float>(x)) - middle) * pixel;
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
    // Half the chord between the directions of view and light is sin(a/2); between view and the
    // opposite of the light it is cos(a/2).
    const auto back = hn::Lt(vx * lightX + vy * lightY + vz * lightZ, zero);
    const Float sign = hn::IfThenElse(back, hn::Set(d, -1.0f), hn::Set(d, 1.0f));
    const Float dx = vx - sign * lightX;
    const Float dy = vy - sign * lightY;
    const Float dz = vz - sign * lightZ;
    const Float chord = hn::Sqrt(dx * dx + dy * dy + dz * dz);
    Float scattered[2] = { zero, zero };
    for (int p = 0; p < shade.Phases; ++p)
    {
      const int intervals = static_cast<int>(shade.Table[p].size()) - 1;
      const float half = 0.5f * intervals;
      const Float way = chord * hn::Set(d, 0.707106781f * half);
      const Float place = hn::IfThenElse(back, hn::Set(d, 2.0f * half) - way, way);
      const auto index = hn::Min(hn::ConvertTo(di, place), hn::Set(di, intervals - 1));
      const Float t = place - hn::ConvertTo(d, index);
      const Float left = hn::GatherIndex(d, shade.Table[p].data(), index);
      const Float right = hn::GatherIndex(d, shade.Table[p].data() + 1, index);
      scattered[p] = left + t * (right - left);
    }
    const Float depth = hn::Min(load(image.Ends), farLimit);
    Float lit[3];
    for (int c = 0; c < settings.Channels; ++c)
    {
      const Float rate = hn::Set(d, static_cast<float>(settings.Extinction[c])) * length;
      const Float hidden = hn::Max(load(image.Hidden[c]), zero);
      lit[c] = hn::Max(Absorbed(d, rate * depth) - hidden, zero);
    }
    for (int c = 0; c < shade.Components; ++c)
    {
      Float sum = hn::Set(d, shade.Factors[0][c]) * scattered[0];
      if (shade.Phases == 2)
      {
        sum = sum + hn::Set(d, shade.Factors[1][c]) * scattered[1];
      }
      sum = sum * lit[settings.Channels == 1 ? 0 : c];
      if (shade.Components == 1 && count == lanes)
      {
        hn::StoreU(sum, d, row + x);
        continue;
      }
      hn::Store(sum, d, buffer);
      for (int i = 0; i < count; ++i)
      {
        row[(x + i) * shade.Components + c] = buffer[i];
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
HWY_EXPORT(RunCoverageInterval);
HWY_EXPORT(RunCoverageRow);

//------------------------------------------------------------------------------
CoverageWedge MakeCoverageWedge(
  const CoverageSettings& settings, const CoverageImage& image, bool transposed, int direction)
{
  const double across = settings.Light[transposed ? 1 : 0] / settings.PixelSize;
  const double along = settings.Light[transposed ? 0 : 1] / settings.PixelSize;
  CoverageWedge wedge = {};
  wedge.W = settings.Parallel ? 0.0 : settings.Light[2];
  wedge.A = across + wedge.W * image.Center[0];
  wedge.B = along + wedge.W * image.Center[1];
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
  return wedge;
}

//------------------------------------------------------------------------------
std::ptrdiff_t FindCoverageLight(
  const CoverageWedge& wedge, const CoverageImage& image, bool& isCentred)
{
  const double x = std::floor(wedge.A / wedge.W + 0.5);
  const double y = std::floor(wedge.B / wedge.W + 0.5);
  isCentred = wedge.W * x == wedge.A && wedge.W * y == wedge.B;
  // false for NaN
  return x >= 0.0 && y >= 0.0 && x < image.Width && y < image.Height
    ? static_cast<std::ptrdiff_t>(y) * image.Width + static_cast<std::ptrdiff_t>(x)
    : -1;
}

//------------------------------------------------------------------------------
void DeleteCoverageLines::operator()(CoverageLines* lines) const
{
  delete lines;
}

//------------------------------------------------------------------------------
CoverageLinesPointer MakeCoverageLines()
{
  return CoverageLinesPointer(new CoverageLines);
}

//------------------------------------------------------------------------------
long long SweepCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, CoverageLines& lines)
{
  return HWY_DYNAMIC_DISPATCH(RunCoverageBand)(settings, image, wedge, band, lines);
}

//------------------------------------------------------------------------------
void HideCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float begin, float end)
{
  HWY_DYNAMIC_DISPATCH(RunCoverageInterval)(settings, image, pixel, begin, end);
}

//------------------------------------------------------------------------------
void WriteCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row)
{
  HWY_DYNAMIC_DISPATCH(RunCoverageRow)(settings, image, shade, y, row);
}
}
#endif
