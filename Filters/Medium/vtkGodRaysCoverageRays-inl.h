// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays, as the tables of airlight have them. Compiled for each set of vector instructions: see
// vtkGodRaysCoverageKernels.cxx.
#if defined(vtkGodRaysCoverageRays_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysCoverageRays_inl_h
#undef vtkGodRaysCoverageRays_inl_h
#else
#define vtkGodRaysCoverageRays_inl_h
#endif

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysCoverageViewRays-inl.h"

#include <hwy/highway.h>

#include <cstddef>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// Where in a table a distance from the eye is found.
template <typename Tag>
struct Place
{
  hn::Vec<hn::RebindToSigned<Tag>> Index;
  hn::Vec<Tag> Across; // from the row before, [0, 1]
  hn::Vec<Tag> Along;  // from the column before
  hn::Vec<Tag> Slice;  // from the first of four
};

template <typename Tag>
HWY_INLINE Place<Tag> Find(
  Tag d, const CoverageTable& table, const Rays<Tag>& rays, hn::Vec<Tag> distance)
{
  const hn::RebindToSigned<Tag> di;
  hn::Vec<Tag> x;
  if (table.Kind != CoverageTable::LAYERS)
  {
    const auto beyond = hn::Sub(distance, rays.Foot);
    const auto r = hn::Sqrt(hn::MulAdd(beyond, beyond, rays.Square));
    const auto way = WayFromFoot(d, beyond, rays.Square, r);
    const auto ratio =
      hn::Div(hn::Mul(distance, hn::Add(way, rays.Way)), hn::Mul(hn::Add(r, rays.Start), rays.Way));
    const auto depth = hn::Mul(distance, hn::Set(d, table.Change));
    x = hn::MulAdd(depth, hn::Add(ratio, hn::Set(d, 1.0f)), ratio);
  }
  else
  {
    x = hn::Mul(distance, rays.InverseWidth);
  }
  const auto column = hn::Min(hn::Mul(LogOfOnePlus(d, x), hn::Set(d, table.ColumnsPerUnit)),
    hn::Set(d, table.Columns - 1.0f));
  const auto j = hn::Min(hn::ConvertTo(di, column), hn::Set(di, table.Columns - 2));
  const auto i = hn::Min(hn::ConvertTo(di, rays.Row), hn::Set(di, table.Rows - 2));
  Place<Tag> place;
  place.Index = hn::ShiftLeft<1>(hn::Add(hn::Mul(i, hn::Set(di, table.Columns)), j));
  if (table.Slices > 1)
  {
    // Of the four slices about it, the place is between the second and the third, if that can be.
    const auto before = hn::Set(di, table.LinearSlices ? 0 : 1);
    const auto first =
      hn::Min(hn::Max(hn::Sub(hn::ConvertTo(di, rays.Slice), before), hn::Zero(di)),
        hn::Set(di, table.Slices - (table.LinearSlices ? 2 : 4)));
    place.Index = hn::Add(place.Index, hn::Mul(first, hn::Set(di, 2 * table.Rows * table.Columns)));
    place.Slice = hn::Sub(rays.Slice, hn::ConvertTo(d, first));
  }
  place.Across = hn::Sub(rays.Row, hn::ConvertTo(d, i));
  place.Along = hn::Sub(column, hn::ConvertTo(d, j));
  return place;
}

template <typename Tag>
HWY_INLINE hn::Vec<Tag> ReadSlice(
  Tag d, const CoverageTable& table, const float* values, const Place<Tag>& place)
{
  const int next = 2 * table.Columns;
  const auto read = [&](int k)
  {
    const auto before = hn::GatherIndex(d, values + k, place.Index);
    const auto after = hn::GatherIndex(d, values + k + next, place.Index);
    return hn::MulAdd(place.Across, hn::Sub(after, before), before);
  };
  const auto first = read(0);
  const auto slope = read(1);
  const auto change = hn::Sub(read(2), first);
  const auto slopes = hn::Add(slope, read(3));
  const auto t = place.Along;
  const auto two = hn::Set(d, 2.0f);
  auto sum = hn::NegMulAdd(two, change, slopes);
  sum = hn::MulAdd(t, sum, hn::Sub(hn::Mul(hn::Set(d, 3.0f), change), hn::Add(slopes, slope)));
  sum = hn::MulAdd(t, sum, slope);
  return hn::MulAdd(t, sum, first);
}

template <typename Tag>
HWY_INLINE hn::Vec<Tag> Read(
  Tag d, const CoverageTable& table, const std::vector<float>& plane, const Place<Tag>& place)
{
  const float* values = plane.data();
  if (table.Slices == 1)
  {
    return ReadSlice(d, table, values, place);
  }
  const std::ptrdiff_t slice = static_cast<std::ptrdiff_t>(2) * table.Rows * table.Columns;
  if (table.LinearSlices)
  {
    const auto low = ReadSlice(d, table, values, place);
    return hn::MulAdd(place.Slice, hn::Sub(ReadSlice(d, table, values + slice, place), low), low);
  }
  // Lagrange's cubic through four slices.
  const auto set = [&](float value) { return hn::Set(d, value); };
  const auto a = place.Slice;
  const auto b = hn::Sub(a, set(1.0f));
  const auto c = hn::Sub(a, set(2.0f));
  const auto e = hn::Sub(a, set(3.0f));
  const hn::Vec<Tag> weights[4] = { hn::Mul(hn::Mul(b, c), hn::Mul(e, set(-1.0f / 6.0f))),
    hn::Mul(hn::Mul(a, c), hn::Mul(e, set(0.5f))), hn::Mul(hn::Mul(a, b), hn::Mul(e, set(-0.5f))),
    hn::Mul(hn::Mul(a, b), hn::Mul(c, set(1.0f / 6.0f))) };
  auto sum = hn::Zero(d);
  for (int i = 0; i < 4; ++i)
  {
    sum = hn::MulAdd(weights[i], ReadSlice(d, table, values + i * slice, place), sum);
  }
  return sum;
}

// Parts of rays, from one distance of the eye to another one each; or, FromEye, all before it.
template <bool FromEye>
class RayParts
{
public:
  HWY_INLINE RayParts(
    const CoverageSettings& settings, const Rays<FloatTag>& rays, Float low, Float high)
    : Settings(settings)
    , Ends{ low, high }
  {
    const FloatTag d;
    const CoverageTable& table = *settings.Table;
    if (table.Kind == CoverageTable::NONE)
    {
      return;
    }
    if (settings.PlanetRadius > 0.0)
    {
      low = hn::Min(low, rays.Ground);
      high = hn::Min(high, rays.Ground);
      const Float begin = hn::Max(hn::Min(low, rays.Dawn), rays.Dusk);
      const Float end = hn::Max(hn::Min(high, rays.Dawn), rays.Dusk);
      this->IsDark = table.Planet.HasShadow && !hn::AllFalse(d, hn::Gt(end, begin));
      if (this->IsDark)
      {
        this->Dark[0] = Find(d, table, rays, begin);
        this->Dark[1] = Find(d, table, rays, end);
      }
    }
    this->Places[1] = Find(d, table, rays, high);
    if (!FromEye)
    {
      this->Places[0] = Find(d, table, rays, low);
    }
  }

  // The light from them.
  HWY_INLINE Float Measure(int plane) const
  {
    const FloatTag d;
    const CoverageTable& table = *this->Settings.Table;
    if (table.Kind == CoverageTable::NONE)
    {
      const Float extinction = hn::Set(d, static_cast<float>(this->Settings.Extinction[plane]));
      const Float before = Absorbed(d, this->Ends[1] * extinction);
      return FromEye ? before : before - Absorbed(d, this->Ends[0] * extinction);
    }
    const std::vector<float>& values = table.Values[plane];
    Float light = Read(d, table, values, this->Places[1]);
    if (!FromEye)
    {
      light = light - Read(d, table, values, this->Places[0]);
    }
    return this->IsDark
      ? light - (Read(d, table, values, this->Dark[1]) - Read(d, table, values, this->Dark[0]))
      : light;
  }

private:
  const CoverageSettings& Settings;
  const Float Ends[2];
  bool IsDark = false;
  Place<FloatTag> Places[2];
  Place<FloatTag> Dark[2];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
