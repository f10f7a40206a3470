// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysSweepTaps.cxx"
#include "vtkGodRaysVectorSets.h"

#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysSweepKernels.h"
#include "vtkGodRaysSweepLanes-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// Pixels that have the same number of taps.
constexpr int GroupedPixels = 16;

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

// Midpoint taps; each has the weight that the kernel has in its stretch:
//   L = Gain/phi(k) sum_i e^(-k t_i) sinh(z)/z dt s(p + t_i v),  z = k dt/2
void RunTaps(const vtkGodRaysMarch& march, const SweepImage& image, double tolerance, int y,
  int firstPixel, int lastPixel, float* to)
{
  const FloatTag d;
  const int lanes = GetLanes();
  const double k = march.K;
  const float origin = k < 0.0 ? 1.0f : 0.0f;       // of t, so that the weights are at most 1
  const double mean = MeanExponential(std::abs(k)); // from that origin
  const double gain = march.Gain / mean / static_cast<double>(image.Scale);
  // Beyond it is nothing of importance.
  const double reach = std::min(1.0, std::log(100.0 / tolerance) / std::max(k, 1e-300));
  const Float rate = hn::Set(d, static_cast<float>(-k));
  const Float one = hn::Set(d, 1.0f);
  const Float lane = CountFrom(d, 0.0f);
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
HWY_EXPORT(RunTaps);
HWY_EXPORT(LoadFloats);

void SumClippedTaps(const vtkGodRaysMarch& march, const SweepImage& image, double tolerance, int y,
  int first, int last, float* to)
{
  HWY_DYNAMIC_DISPATCH(RunTaps)(march, image, tolerance, y, first, last, to);
}

void LoadPixels(const float* pixels, int step, int count, float scale, float* row)
{
  HWY_DYNAMIC_DISPATCH(LoadFloats)(pixels, step, count, scale, row);
}

void LoadPixels(const unsigned char* pixels, int step, int count, float scale, float* row)
{
  const float factor = scale / 255.0f;
  for (int i = 0; i < count; ++i)
  {
    row[i] = factor * pixels[static_cast<std::ptrdiff_t>(i) * step];
  }
}

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
}
#endif
