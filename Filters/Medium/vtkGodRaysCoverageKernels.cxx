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

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
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
