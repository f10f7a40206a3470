// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The measure of rays, and the lines of a band. Compiled for each set of vector instructions: see
// vtkGodRaysCoverageKernels.cxx.
#if defined(vtkGodRaysCoverageRays_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysCoverageRays_inl_h
#undef vtkGodRaysCoverageRays_inl_h
#else
#define vtkGodRaysCoverageRays_inl_h
#endif

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysLanes-inl.h"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#ifndef vtkGodRaysCoverageLines_once
#define vtkGodRaysCoverageLines_once

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
// ln(1 + x) for x >= 0, to 3e-7 of itself.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> LogOfOnePlus(Tag d, hn::Vec<Tag> x)
{
  const hn::RebindToSigned<Tag> di;
  const auto one = hn::Set(d, 1.0f);
  const auto y = hn::Add(one, hn::Min(x, hn::Set(d, 1e37f)));
  // y = 2^k m, m about 1
  const auto bits = hn::BitCast(di, y);
  const auto exponent =
    hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3))); // the root of 1/2
  const auto m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  // What rounding took from y belongs to m - 1.
  const auto lost = hn::Sub(hn::Min(x, hn::Set(d, 1e37f)), hn::Sub(y, one));
  const auto rest = hn::Div(hn::Mul(lost, m), y);
  const auto f = hn::Div(hn::Add(hn::Sub(m, one), rest), hn::Add(m, one));
  const auto f2 = hn::Mul(f, f);
  auto p = hn::Set(d, 2.0f / 9.0f);
  p = hn::MulAdd(p, f2, hn::Set(d, 2.0f / 7.0f));
  p = hn::MulAdd(p, f2, hn::Set(d, 2.0f / 5.0f));
  p = hn::MulAdd(p, f2, hn::Set(d, 2.0f / 3.0f));
  p = hn::MulAdd(p, f2, hn::Set(d, 2.0f));
  return hn::MulAdd(hn::ConvertTo(d, exponent), hn::Set(d, 0.693147181f), hn::Mul(p, f));
}

//------------------------------------------------------------------------------
// View rays, one in each lane: Length is of a unit of depth, Gain what the table's values are times.
template <typename Tag>
struct Rays
{
  using V = hn::Vec<Tag>;
  V Length;
  V Row;
  V Slice;
  V Foot;   // of a point light
  V Square; // of its distance from the ray
  V Start;  // its distance from the eye
  V Way;    // Start - Foot, of which so much is left if they are nearly the same
  V InverseWidth;
  V Gain;
  V Ground; // of a planet, where the ray meets it
  V Dusk;   // where it enters and leaves its shadow
  V Dawn;
};

//------------------------------------------------------------------------------
// asinh(x), to 4e-7 of itself.
HWY_INLINE Float InverseSinh(Float x)
{
  const FloatTag d;
  const Float one = hn::Set(d, 1.0f);
  const Float size = hn::Abs(x);
  const Float more = size * size / (one + hn::Sqrt(hn::MulAdd(size, size, one)));
  return hn::CopySign(LogOfOnePlus(d, size + more), x);
}

//------------------------------------------------------------------------------
// s - foot + r, where r is the distance from the light.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> WayFromFoot(Tag d, hn::Vec<Tag> beyond, hn::Vec<Tag> square, hn::Vec<Tag> r)
{
  const auto sum = hn::Add(r, hn::Abs(beyond));
  return hn::IfThenElse(hn::Gt(beyond, hn::Zero(d)), sum, hn::Div(square, sum));
}

//------------------------------------------------------------------------------
// tan(a/4), a being the angle about the origin from the x axis, [-180 degrees, 180 degrees].
HWY_INLINE Float TangentOfQuarter(Float x, Float y)
{
  const FloatTag d;
  const Float half = hn::Set(d, 0.5f);
  const Float r = hn::Max(hn::Sqrt(hn::MulAdd(x, x, y * y)), hn::Set(d, 1e-30f));
  // sine and cosine of a/2, times the root of r
  const Float more = hn::Sqrt(half * (r + hn::Abs(x)));
  const Float less = half * hn::Abs(y) / more;
  const auto isBefore = hn::Ge(x, hn::Zero(d));
  const Float sine = hn::IfThenElse(isBefore, less, more);
  const Float cosine = hn::IfThenElse(isBefore, more, less);
  return hn::CopySign(sine / (hn::Sqrt(r) + cosine), y);
}

//------------------------------------------------------------------------------
// Over a planet, of the rays of pixels. Lengths are in distances of the eye from its centre: at the way t
// along a ray, (distance from the centre)^2 = Ground^2 + room + 2 rise t + t^2, and what is nearer to the
// light than the centre is nearer by light + cosine t. Returns the place in rows.
HWY_INLINE Float FindPlanetRays(
  const CoverageSettings& settings, Float column, Float row, Rays<FloatTag>& rays)
{
  const FloatTag d;
  const CoverageTable& table = *settings.Table;
  const CoverageTable::Globe& planet = table.Planet;
  const Float zero = hn::Zero(d);
  const auto set = [&](double value) { return hn::Set(d, static_cast<float>(value)); };
  Float rise = column * set(settings.Up[0]) + row * set(settings.Up[1]);
  const Float nearer = column * set(settings.Light[0]) + row * set(settings.Light[1]);
  Float room = set(planet.Room);
  Float excess; // of the least distance^2 of the ray's line
  Float light = set(planet.LightSlope);
  Float cosine;
  Float place;
  Float slice;
  if (settings.Parallel)
  {
    const Float perLength = set(1.0 / planet.Radius);
    const Float more =
      (rise + rise + hn::MulAdd(column, column, row * row) * perLength) * perLength;
    room = room + more;
    excess = set(planet.Excess) + more;
    rise = set(settings.Up[2]);
    cosine = set(settings.Light[2]);
    light = hn::MulAdd(nearer, perLength, light);
    const Float surface = set(planet.Ground);
    const auto toUnits = [&](Float more) HWY_ATTR // of a distance^2 than Ground^2
    {
      const Float radius = hn::Sqrt(hn::Max(hn::MulAdd(surface, surface, more), zero));
      return InverseSinh(more / (radius + surface) * set(planet.Radius / table.RowUnit));
    };
    place = toUnits(excess) + toUnits(room);
    slice = nearer;
  }
  else
  {
    rise = (rise + set(settings.Up[2])) / rays.Length;
    cosine = (nearer + set(settings.Light[2])) / rays.Length;
    excess = hn::NegMulAdd(rise, rise, room);
    place = InverseSinh((rise - set(planet.Horizon)) * set(1.0 / table.RowUnit));
    slice = cosine;
  }
  rays.Slice = (slice - set(table.FirstSlice)) * set(table.SlicesPerUnit);
  rays.Slice = hn::Min(hn::Max(rays.Slice, zero), set(table.Slices - 1.0));
  const Float above = hn::Max(room, zero);
  const auto isMet = hn::And(hn::Lt(rise, zero), hn::Le(excess, zero));
  const Float toGround =
    above / (hn::Sqrt(hn::Max(hn::Neg(excess), zero)) - hn::Min(rise, set(-1e-12)));
  rays.Ground = hn::IfThenElse(isMet, toGround * set(planet.Radius), set(CoverageSky));
  // Where the air is densest, and how far from there it falls by 1/e: scale = slope s + s^2/2.
  const Float longest = set(planet.Longest);
  const Float foot =
    hn::Min(hn::IfThenElse(isMet, toGround, hn::Max(hn::Neg(rise), zero)), longest);
  const Float ground = set(planet.Ground);
  const Float square = hn::MulAdd(foot, foot + rise + rise, hn::MulAdd(ground, ground, room));
  const Float along = rise + foot;
  const Float least = set(planet.Scale / planet.Longest);
  const Float steep = hn::MulAdd(least, least, along * along / hn::Max(square, set(1e-12)));
  const Float scale = set(2.0 * planet.Scale);
  const Float height = scale / (hn::Sqrt(steep) + hn::Sqrt(steep + scale));
  const Float heights = height * height;
  const Float near = foot * foot / (hn::Sqrt(hn::MulAdd(foot, foot, heights)) + height);
  rays.Foot = near * set(planet.Radius);
  rays.Square = heights * set(planet.Radius * planet.Radius);
  rays.Start = hn::Sqrt(hn::MulAdd(rays.Foot, rays.Foot, rays.Square));
  rays.Way = WayFromFoot(d, hn::Neg(rays.Foot), rays.Square, rays.Start);
  rays.Dusk = rays.Dawn = zero;
  if (planet.HasShadow)
  {
    // A cylinder, a t^2 + 2 b t + c <= 0, where light + cosine t <= 0.
    const Float a = hn::Max(hn::NegMulAdd(cosine, cosine, set(1.0)), set(1e-7));
    const Float b = hn::NegMulAdd(light, cosine, rise);
    const Float c = hn::NegMulAdd(light, light, room);
    const Float root = hn::NegMulAdd(a, c, b * b);
    const Float q = hn::Neg(b + hn::CopySign(hn::Sqrt(hn::Max(root, zero)), b));
    const Float one = q / a;
    const Float other = c / hn::IfThenElse(hn::Eq(q, zero), set(1e-30), q);
    const Float middle =
      hn::Neg(light) / hn::IfThenElse(hn::Lt(hn::Abs(cosine), set(1e-12)), set(1e-12), cosine);
    const auto isTowards = hn::Gt(cosine, zero);
    Float begin = hn::Max(hn::Min(one, other), zero);
    Float end = hn::Max(one, other);
    begin = hn::IfThenElse(isTowards, begin, hn::Max(begin, middle));
    end = hn::IfThenElse(isTowards, hn::Min(end, middle), end);
    const auto isDark = hn::And(hn::Gt(root, zero), hn::Gt(end, begin));
    rays.Dusk = hn::IfThenElseZero(isDark, begin * set(planet.Radius));
    rays.Dawn = hn::IfThenElseZero(isDark, end * set(planet.Radius));
  }
  return place;
}

//------------------------------------------------------------------------------
// The rays of pixels in units of PixelSize from the view axis.
HWY_INLINE Rays<FloatTag> FindRays(const CoverageSettings& settings, Float column, Float row)
{
  const FloatTag d;
  const CoverageTable& table = *settings.Table;
  const Float zero = hn::Zero(d);
  const Float one = hn::Set(d, 1.0f);
  const auto set = [&](double value) { return hn::Set(d, static_cast<float>(value)); };
  Rays<FloatTag> rays;
  rays.Length =
    settings.Parallel ? one : hn::Sqrt(hn::MulAdd(column, column, hn::MulAdd(row, row, one)));
  rays.Row = rays.Slice = rays.Foot = rays.Square = rays.Start = rays.Way = rays.InverseWidth =
    zero;
  rays.Gain = one;
  rays.Ground = rays.Dusk = rays.Dawn = zero;
  if (table.Kind == CoverageTable::NONE)
  {
    return rays;
  }
  Float place = zero;
  const Float lightX = set(settings.Light[0]);
  const Float lightY = set(settings.Light[1]);
  const Float lightZ = set(settings.Light[2]);
  if (table.Kind == CoverageTable::POINT)
  {
    Float height;
    Float about; // of the cosine between up and the way from the light's axis
    if (settings.Parallel)
    {
      const Float x = lightX - column;
      const Float y = lightY - row;
      height = hn::Max(hn::Sqrt(x * x + y * y), hn::Set(d, table.Nearest));
      rays.Foot = lightZ;
      place = LogOfOnePlus(d, height / hn::Set(d, table.RowUnit));
      about = x * set(-settings.SliceAxis[0]) + y * set(-settings.SliceAxis[1]);
      about = settings.Around
        ? TangentOfQuarter(about, x * set(-settings.SliceSide[0]) + y * set(-settings.SliceSide[1]))
        : about / height;
    }
    else
    {
      // Of light and ray, both of length 1.
      const Float z = one / rays.Length;
      const Float x = column * z;
      const Float y = row * z;
      const Float far = hn::Set(d, 1.0f / table.Distance);
      const Float lx = lightX * far;
      const Float ly = lightY * far;
      const Float lz = lightZ * far;
      const Float cx = y * lz - z * ly;
      const Float cy = z * lx - x * lz;
      const Float cz = x * ly - y * lx;
      const Float cosine = x * lx + y * ly + z * lz;
      const Float sine = hn::Max(hn::Sqrt(cx * cx + cy * cy + cz * cz), hn::Set(d, table.Nearest));
      height = sine * hn::Set(d, table.Distance);
      rays.Foot = cosine * hn::Set(d, table.Distance);
      const auto tangent =
        hn::IfThenElse(hn::Gt(cosine, zero), sine / (one + cosine), (one - cosine) / sine);
      place = LogOfOnePlus(d, tangent / hn::Set(d, table.RowUnit));
      const Float rise = x * set(settings.SliceAxis[0]) + y * set(settings.SliceAxis[1]) +
        z * set(settings.SliceAxis[2]);
      about = settings.Around ? TangentOfQuarter(rise,
                                  x * set(settings.SliceSide[0]) + y * set(settings.SliceSide[1]) +
                                    z * set(settings.SliceSide[2]))
                              : (rise - cosine * hn::Set(d, table.LightRise)) / sine;
    }
    rays.Slice = (about * hn::Set(d, table.InverseSide) - hn::Set(d, table.FirstSlice)) *
      hn::Set(d, table.SlicesPerUnit);
    rays.Slice = hn::Min(hn::Max(rays.Slice, zero), hn::Set(d, table.Slices - 1.0f));
    rays.Square = height * height;
    rays.Start = hn::Sqrt(rays.Foot * rays.Foot + rays.Square);
    rays.Way = WayFromFoot(d, hn::Neg(rays.Foot), rays.Square, rays.Start);
    rays.Gain = one / height;
  }
  else if (table.Kind == CoverageTable::PLANET)
  {
    place = FindPlanetRays(settings, column, row, rays);
  }
  else
  {
    const Float rise = column * set(settings.Up[0]) + row * set(settings.Up[1]);
    if (settings.Parallel)
    {
      place = rise + set(settings.EyeHeight);
    }
    else
    {
      const Float x = (rise + set(settings.Up[2])) / (rays.Length * hn::Set(d, table.RowUnit));
      place = InverseSinh(x);
    }
  }
  rays.Row = (place - hn::Set(d, table.FirstRow)) * hn::Set(d, table.RowsPerUnit);
  rays.Row = hn::Min(hn::Max(rays.Row, zero), hn::Set(d, table.Rows - 1.0f));
  if (table.Kind == CoverageTable::LAYERS)
  {
    const IntTag di;
    const auto index = hn::Min(hn::ConvertTo(di, rays.Row), hn::Set(di, table.Rows - 2));
    const Float low = hn::GatherIndex(d, table.InverseWidths.data(), index);
    const Float high = hn::GatherIndex(d, table.InverseWidths.data() + 1, index);
    rays.InverseWidth = low + (rays.Row - hn::ConvertTo(d, index)) * (high - low);
  }
  return rays;
}

//------------------------------------------------------------------------------
// The rays of which others' lanes tell the number.
HWY_INLINE Rays<FloatTag> Select(const Rays<FloatTag>& rays, hn::Vec<IntTag> numbers)
{
  const auto indices = hn::IndicesFromVec(FloatTag(), numbers);
  const auto select = [&](Float field) HWY_ATTR { return hn::TableLookupLanes(field, indices); };
  return { select(rays.Length), select(rays.Row), select(rays.Slice), select(rays.Foot),
    select(rays.Square), select(rays.Start), select(rays.Way), select(rays.InverseWidth),
    select(rays.Gain), select(rays.Ground), select(rays.Dusk), select(rays.Dawn) };
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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
    if (table.Kind == CoverageTable::PLANET)
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

//------------------------------------------------------------------------------
// The lines of a band.
class Lines
{
public:
  static constexpr float Nowhere = 3e38f;

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

  // Copies a line's intervals; returns their number.
  HWY_INLINE int Copy(int index, float* low, float* high) const
  {
    const int count = this->Counts[index];
    std::copy_n(this->Intervals[index].Low, count, low);
    std::copy_n(this->Intervals[index].High, count, high);
    return count;
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

  CoverageLine* const Intervals;
  int* const Counts;
  const float Farthest;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
