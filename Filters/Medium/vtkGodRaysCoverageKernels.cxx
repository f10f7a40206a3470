// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysCoverageKernels.cxx"
#include "vtkGodRaysVectorSets.h"

#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysCoverageRays-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// From depth to h in a row, and back.
struct Rate
{
  float Scale;
  float Shift;
  bool Reciprocal; // of depth
  double Gain;     // of the way back
  double Offset;

  float operator()(float z) const
  {
    return this->Scale * (this->Reciprocal ? 1.0f / z : z) + this->Shift;
  }
};

// The intervals that are hidden from some pixels, as many as there are lanes. All of them at once are
// measured faster than each pixel's on its own.
class PixelIntervals
{
public:
  HWY_INLINE void Add(int pixel, const Lines& lines, int line)
  {
    const int count = lines.Copy(line, this->Low + this->Count, this->High + this->Count);
    std::fill_n(this->Pixels + this->Count, count, pixel);
    this->Count += count;
    this->Ends[pixel] = this->Count;
  }

  // What lies in each, between the first and the last depths of the pixels' rays.
  HWY_INLINE void Measure(const CoverageSettings& settings, const Rate& rate,
    const Rays<FloatTag>& rays, Float first, Float last)
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    std::fill_n(this->Low + this->Count, lanes, 0.0f);
    std::fill_n(this->High + this->Count, lanes, 0.0f);
    std::fill_n(this->Pixels + this->Count, lanes, 0);
    const Float gain = hn::Set(d, static_cast<float>(rate.Gain));
    const Float offset = hn::Set(d, static_cast<float>(rate.Offset));
    for (int i = 0; i < this->Count; i += lanes)
    {
      const auto pixels = hn::LoadU(di, this->Pixels + i);
      const Rays<FloatTag> here = Select(rays, pixels);
      const Float begin = hn::TableLookupLanes(first, hn::IndicesFromVec(d, pixels));
      const Float end = hn::TableLookupLanes(last, hn::IndicesFromVec(d, pixels));
      const auto toDistance = [&](Float h) HWY_ATTR
      {
        Float z = hn::MulAdd(h, gain, offset);
        if (rate.Reciprocal)
        {
          z = hn::Set(d, 1.0f) / hn::Max(z, hn::Set(d, 1e-30f));
        }
        return hn::Max(hn::Min(z, end), begin) * here.Length;
      };
      const Float low = toDistance(hn::LoadU(d, this->Low + i));
      const Float high = toDistance(hn::LoadU(d, this->High + i));
      const RayParts<false> parts(settings, here, hn::Min(low, high), hn::Max(low, high));
      for (int p = 0; p < settings.Planes; ++p)
      {
        hn::StoreU(hn::Max(parts.Measure(p), hn::Zero(d)), d, this->Measured[p] + i);
      }
    }
  }

  HWY_INLINE void Sum(int plane, int pixels, float* sums) const
  {
    int i = 0;
    for (int pixel = 0; pixel < pixels; ++pixel)
    {
      float sum = 0.0f;
      for (; i < this->Ends[pixel]; ++i)
      {
        sum += this->Measured[plane][i];
      }
      sums[pixel] = sum;
    }
  }

  void Clear() { this->Count = 0; }

private:
  static constexpr int Most = 8 * MaximumIntervals + 8;
  int Count = 0;
  int Ends[8]; // of pixels' intervals
  int32_t Pixels[Most];
  float Low[Most];
  float High[Most];
  float Measured[CoverageMaximumPlanes][Most];
};

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
    , ShadesItself(settings.Point || settings.Light[2] < 0.0)
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
      if (this->Settings.Layers > 0 && this->ShadesItself)
      {
        const Rate here = this->GetRate(n);
        this->TakeLayers(row, here, here, this->GetRate(n + 0.5));
      }
    }
    return this->Hidden.Overflows;
  }

private:
  double GetFlow(double row) const { return this->Wedge.W * row - this->Wedge.B; }

  // n rows from the first one.
  Rate GetRate(double n) const
  {
    const double widest = this->GetFlow(this->Wedge.Widest);
    const double row = this->Wedge.First + n * this->Wedge.Direction;
    const double scale = this->GetFlow(row) / widest;
    double gain = 1.0 / std::max(scale, 1e-30);
    double offset = 0.0;
    if (this->Settings.Point)
    {
      gain = std::max(scale, 1e-6);
      offset = (this->Wedge.Widest - row) / widest *
        (this->Settings.Parallel ? this->Settings.Light[2] : 1.0);
      return { static_cast<float>(1.0 / gain), static_cast<float>(-offset / gain),
        !this->Settings.Parallel, gain, offset };
    }
    if (this->Settings.Parallel)
    {
      const double shift = this->Wedge.Recession * n;
      return { 1.0f, static_cast<float>(shift), false, 1.0, -shift };
    }
    return { static_cast<float>(std::max(0.0, scale)), 0.0f, false, gain, 0.0 };
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
    const double last = this->Wedge.Recession * (this->Wedge.Rows + 1.0);
    return this->Settings.Point
      ? Lines::Nowhere
      : static_cast<float>(1.01 * this->Settings.FarLimit + std::max(0.0, last));
  }

  // The samples of the lines in a row: the places of the first and of others after it.
  struct Samples
  {
    int First;
    int Last;
    float Start;
    float Step;
    int Rightmost;
    int GetColumn(int line) const
    {
      return std::min(
        static_cast<int>(this->Start + this->Step * (line - this->First)), this->Rightmost);
    }
  };
  Samples FindSamples(int row) const
  {
    const double scale = this->GetFlow(row) / this->GetFlow(this->Wedge.Widest);
    const double step = this->Wedge.Spacing * scale;
    const double x0 = this->Wedge.FirstLine +
      (this->Wedge.W * this->Wedge.FirstLine - this->Wedge.A) / this->GetFlow(this->Wedge.Widest) *
        (row - this->Wedge.Widest);
    const double least = std::max<double>(this->Begin, std::ceil((-0.499 - x0) / step));
    const double most =
      std::min<double>(this->End - 1, std::floor((this->Image.Width - 0.501 - x0) / step));
    if (!(least <= most))
    {
      return { 0, -1, 0.0f, 0.0f, 0 };
    }
    return { static_cast<int>(least), static_cast<int>(most),
      static_cast<float>(x0 + least * step + 0.5), static_cast<float>(step),
      this->Image.Width - 1 };
  }

  // The rate of half a row before, or at the light if that is behind a surface of the first row.
  Rate GetEntrance(int n) const
  {
    return this->GetRate(n == 0 && this->Covered
        ? (this->Wedge.B / this->Wedge.W - this->Wedge.First) * this->Wedge.Direction
        : n - 0.5);
  }

  // What solid layers hide between two places of their row.
  void TakeLayers(int row, const Rate& enter, const Rate& from, const Rate& to)
  {
    const Samples samples = this->FindSamples(row);
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * this->Image.Width;
    const float thicker = static_cast<float>(1.0 + this->Settings.Thickness);
    for (int l = samples.First; l <= samples.Last; ++l)
    {
      const std::ptrdiff_t pixel = offset + samples.GetColumn(l);
      for (int layer = 0; layer < this->Settings.Layers; ++layer)
      {
        const float front = this->Image.Depths[2 * layer][pixel];
        const float back = this->Image.Depths[2 * layer + 1][pixel];
        if (front < CoverageSky)
        {
          const float far = back < CoverageSky && back > front ? back : front * thicker;
          const float ends[] = { enter(front), to(front), from(far), to(far) };
          this->Hidden.Insert(
            l - this->Begin, *std::min_element(ends, ends + 4), *std::max_element(ends, ends + 4));
        }
      }
    }
  }

  // The row's samples of the lines change what is hidden.
  void TakeSamples(int n, int row)
  {
    const Rate half = this->GetRate(n - 0.5);
    const Rate enter = this->GetEntrance(n);
    if (this->Settings.Layers > 0)
    {
      this->TakeLayers(row, enter, half, this->GetRate(this->ShadesItself ? n : n + 0.5));
      return;
    }
    const Samples samples = this->FindSamples(row);
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * this->Image.Width;
    const Rate here = this->GetRate(n);
    const float* depths = this->Image.Depths[0] + offset;
    const Rate before = this->GetRate(n - 1.0);
    const float thickness = static_cast<float>(this->Settings.Thickness);
    const float jump = static_cast<float>(this->Settings.Jump);
    const float bend = static_cast<float>(this->Settings.Bend);
    const bool parallel = this->Settings.Parallel;
    for (int l = samples.First; l <= samples.Last; ++l)
    {
      const float z = depths[samples.GetColumn(l)];
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
        this->InsertBetween(i, before(previous), half(previous), before, thickness, previous);
      }
      if (solid)
      {
        this->InsertBetween(i, linked ? before(previous) : enter(z), here(z), here, thickness, z);
      }
      this->Before[i] = z;
    }
  }

  // Made thicker behind a depth.
  HWY_INLINE void InsertBetween(
    int line, float a, float b, const Rate& rate, float thickness, float z)
  {
    const float low = std::min(a, b);
    const float high = std::max(a, b);
    if (rate.Reciprocal)
    {
      this->Hidden.Insert(line, low - rate.Scale * thickness / ((1.0f + thickness) * z), high);
    }
    else
    {
      this->Hidden.Insert(line, low, high + rate.Scale * thickness * z);
    }
  }

  // The row's pixels that are nearest to the band's lines.
  void WritePixels(int n, int row)
  {
    int first;
    int last;
    FindCoveragePixels(this->Wedge, this->Image, row, first, last);
    const double flow = this->GetFlow(row);
    const double gain = this->GetFlow(this->Wedge.Widest) / flow / this->Wedge.Spacing;
    const double bias =
      (-this->Wedge.A * (this->Wedge.Widest - row) / flow - this->Wedge.FirstLine) /
      this->Wedge.Spacing;
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
    const FloatTag d;
    const int lanes = GetLanes();
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(row) * this->Image.Width;
    const float* ends = this->Image.Ends + offset;
    const float* begins = this->Image.Begins ? this->Image.Begins + offset : nullptr;
    const float farLimit = static_cast<float>(this->Settings.FarLimit);
    const float pixel = static_cast<float>(this->Settings.PixelSize);
    const float middle = static_cast<float>(this->Image.Center[0]);
    const float y = static_cast<float>((row - this->Image.Center[1]) * this->Settings.PixelSize);
    const float position = static_cast<float>(begin * gain + bias - this->Begin) + 0.5f;
    const float fgain = static_cast<float>(gain);
    const int most = this->End - this->Begin - 1;
    const Rate rate = this->GetRate(n);
    PixelIntervals intervals;
    for (int x0 = begin; x0 < end; x0 += lanes)
    {
      const Float columns =
        (CountFrom(d, static_cast<float>(x0)) - hn::Set(d, middle)) * hn::Set(d, pixel);
      const Rays<FloatTag> rays = FindRays(this->Settings, columns, hn::Set(d, y));
      const int count = std::min(lanes, end - x0);
      HWY_ALIGN float nearest[8] = {};
      HWY_ALIGN float last[8] = {};
      for (int i = 0; i < count; ++i)
      {
        const float line = position + fgain * (x0 + i - begin);
        last[i] = std::min(ends[x0 + i], farLimit);
        nearest[i] = begins ? std::min(begins[x0 + i], last[i]) : 0.0f;
        intervals.Add(i, this->Hidden, std::min(std::max(static_cast<int>(line), 0), most));
      }
      intervals.Measure(this->Settings, rate, rays, hn::Load(d, nearest), hn::Load(d, last));
      for (int p = 0; p < this->Settings.Planes; ++p)
      {
        intervals.Sum(p, count, this->Image.Hidden[p] + offset + x0);
      }
      intervals.Clear();
    }
  }

  const CoverageSettings& Settings;
  const CoverageImage& Image;
  const CoverageWedge& Wedge;
  const int Begin;
  const int End;
  const bool IsLast;
  const bool ShadesItself; // the later half of a sample the part of its own ray before it
  const bool Covered;
  Lines Hidden;
  float* const Before;
  float* const Slopes;
};

long long RunCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, CoverageLines& lines)
{
  return Band(settings, image, wedge, band, lines).Sweep();
}

void RunCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float before, float from)
{
  const FloatTag d;
  const double column = (pixel % image.Width - image.Center[0]) * settings.PixelSize;
  const double row = (pixel / image.Width - image.Center[1]) * settings.PixelSize;
  const auto rays =
    FindRays(settings, hn::Set(d, static_cast<float>(column)), hn::Set(d, static_cast<float>(row)));
  const float last = std::min(image.Ends[pixel], static_cast<float>(settings.FarLimit));
  const float first = image.Begins ? std::min(image.Begins[pixel], last) : 0.0f;
  for (int p = 0; p < settings.Planes; ++p)
  {
    const auto measure = [&](float z)
    {
      const Float distance = hn::Set(d, std::max(std::min(z, last), first)) * rays.Length;
      return hn::GetLane(RayParts<true>(settings, rays, hn::Zero(d), distance).Measure(p));
    };
    // All of the ray is all, whatever rounding makes of its length.
    image.Hidden[p][pixel] = before >= std::min(from, last)
      ? CoverageSky
      : measure(before) - measure(first) + std::max(measure(last) - measure(from), 0.0f);
  }
}

// The phase functions at rays of a directional light.
HWY_INLINE void FindPhases(const CoverageSettings& settings, const CoverageShade& shade,
  Float column, float row, Float length, Float* scattered)
{
  const FloatTag d;
  const IntTag di;
  const Float zero = hn::Zero(d);
  const Float lightX = hn::Set(d, static_cast<float>(settings.Light[0]));
  const Float lightY = hn::Set(d, static_cast<float>(settings.Light[1]));
  const Float lightZ = hn::Set(d, static_cast<float>(settings.Light[2]));
  const Float vz = hn::Set(d, 1.0f) / length;
  const Float vx = settings.Parallel ? zero : column * vz;
  const Float vy = settings.Parallel ? zero : hn::Set(d, row) * vz;
  // Half the chord between the directions of view and light is sin(a/2); between view and the opposite
  // of the light it is cos(a/2).
  const auto back = hn::Lt(vx * lightX + vy * lightY + vz * lightZ, zero);
  const Float sign = hn::IfThenElse(back, hn::Set(d, -1.0f), hn::Set(d, 1.0f));
  const Float dx = vx - sign * lightX;
  const Float dy = vy - sign * lightY;
  const Float dz = vz - sign * lightZ;
  const Float chord = hn::Sqrt(dx * dx + dy * dy + dz * dz);
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
}

void RunCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row)
{
  const FloatTag d;
  const int lanes = GetLanes();
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y) * image.Width;
  const Float pixel = hn::Set(d, static_cast<float>(settings.PixelSize));
  const float height = static_cast<float>((y - image.Center[1]) * settings.PixelSize);
  const Float middle = hn::Set(d, static_cast<float>(image.Center[0]));
  const Float farLimit = hn::Set(d, static_cast<float>(settings.FarLimit));
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
    const Float column = (CountFrom(d, static_cast<float>(x)) - middle) * pixel;
    const Rays<FloatTag> rays = FindRays(settings, column, hn::Set(d, height));
    const Float distance = hn::Min(load(image.Ends), farLimit) * rays.Length;
    Float lit[CoverageMaximumPlanes];
    const auto shine = [&](const auto& parts) HWY_ATTR
    {
      for (int p = 0; p < settings.Planes; ++p)
      {
        const Float hidden = hn::Max(load(image.Hidden[p]), zero);
        lit[p] = hn::Max(parts.Measure(p) - hidden, zero) * rays.Gain;
      }
    };
    if (image.Begins)
    {
      const Float begin = hn::Min(load(image.Begins) * rays.Length, distance);
      shine(RayParts<false>(settings, rays, begin, distance));
    }
    else
    {
      shine(RayParts<true>(settings, rays, zero, distance));
    }
    Float scattered[2] = { hn::Set(d, 1.0f), zero };
    if (!settings.Point)
    {
      FindPhases(settings, shade, column, height, rays.Length, scattered);
    }
    const bool isShared = settings.Planes == settings.Channels; // by the phases
    for (int c = 0; c < shade.Components; ++c)
    {
      const int plane = settings.Channels == 1 ? 0 : c;
      Float sum = hn::Set(d, shade.Factors[0][c]) * scattered[0] * lit[plane];
      if (shade.Phases == 2)
      {
        sum = sum +
          hn::Set(d, shade.Factors[1][c]) * scattered[1] *
            lit[isShared ? plane : plane + settings.Channels];
      }
      sum = hn::Min(sum, hn::Set(d, 3e38f));
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

void FindCoveragePixels(
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

CoverageWedge MakeCoverageWedge(
  const CoverageSettings& settings, const CoverageImage& image, int direction)
{
  const double across = settings.Light[0] / settings.PixelSize;
  const double along = settings.Light[1] / settings.PixelSize;
  CoverageWedge wedge = {};
  wedge.W = settings.Parallel ? (settings.Point ? 1.0 : 0.0) : settings.Light[2];
  wedge.A = across + wedge.W * image.Center[0];
  wedge.B = along + wedge.W * image.Center[1];
  wedge.Recession =
    settings.Parallel && !settings.Point ? settings.Light[2] / std::abs(along) : 0.0;
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
  wedge.Spacing = settings.Spacing;
  wedge.Lines = static_cast<int>(std::ceil((right - left) / settings.Spacing)) + 1;
  wedge.Bands = (wedge.Lines + CoverageBandLines - 1) / CoverageBandLines;
  return wedge;
}

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

void DeleteCoverageLines::operator()(CoverageLines* lines) const
{
  delete lines;
}

CoverageLinesPointer MakeCoverageLines()
{
  return CoverageLinesPointer(new CoverageLines);
}

long long SweepCoverageBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, CoverageLines& lines)
{
  return HWY_DYNAMIC_DISPATCH(RunCoverageBand)(settings, image, wedge, band, lines);
}

void HideCoverageInterval(const CoverageSettings& settings, const CoverageImage& image,
  std::ptrdiff_t pixel, float before, float from)
{
  HWY_DYNAMIC_DISPATCH(RunCoverageInterval)(settings, image, pixel, before, from);
}

void WriteCoverageRow(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageShade& shade, int y, float* row)
{
  HWY_DYNAMIC_DISPATCH(RunCoverageRow)(settings, image, shade, y, row);
}
}
#endif
