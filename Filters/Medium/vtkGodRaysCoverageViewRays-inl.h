// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// View rays of pixels, as tables of airlight tell them apart, and where a planet's ground ends and darkens
// them. Compiled for each set of vector instructions: see vtkGodRaysCoverageKernels.cxx.
#if defined(vtkGodRaysCoverageViewRays_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysCoverageViewRays_inl_h
#undef vtkGodRaysCoverageViewRays_inl_h
#else
#define vtkGodRaysCoverageViewRays_inl_h
#endif

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysLanes-inl.h"

#include <hwy/highway.h>

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

// asinh(x), to 4e-7 of itself.
HWY_INLINE Float InverseSinh(Float x)
{
  const FloatTag d;
  const Float one = hn::Set(d, 1.0f);
  const Float size = hn::Abs(x);
  const Float more = size * size / (one + hn::Sqrt(hn::MulAdd(size, size, one)));
  return hn::CopySign(LogOfOnePlus(d, size + more), x);
}

// s - foot + r, where r is the distance from the light.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> WayFromFoot(Tag d, hn::Vec<Tag> beyond, hn::Vec<Tag> square, hn::Vec<Tag> r)
{
  const auto sum = hn::Add(r, hn::Abs(beyond));
  return hn::IfThenElse(hn::Gt(beyond, hn::Zero(d)), sum, hn::Div(square, sum));
}

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

// Rays over a planet. Lengths are in distances of the eye from its centre: at the way t along a ray,
// (distance from the centre)^2 = Ground^2 + Room + 2 Rise t + t^2.
struct RaysOverGround
{
  Float Aside; // of parallel rays' starts, along the eye's vertical [scene units]
  Float Rise;
  Float Room;
  Float Excess; // of the least distance^2 of the ray's line, than Ground^2
  Float Way;    // to the ground, or CoverageSky if it is not met
};

HWY_INLINE RaysOverGround FindGround(
  const CoverageSettings& settings, Float column, Float row, Float length)
{
  const FloatTag d;
  const CoverageTable::Globe& planet = settings.Table->Planet;
  const Float zero = hn::Zero(d);
  const auto set = [&](double value) { return hn::Set(d, static_cast<float>(value)); };
  RaysOverGround rays;
  rays.Aside = column * set(settings.Up[0]) + row * set(settings.Up[1]);
  rays.Room = set(planet.Room);
  if (settings.Parallel)
  {
    const Float perLength = set(1.0 / planet.Radius);
    const Float more =
      (rays.Aside + rays.Aside + hn::MulAdd(column, column, row * row) * perLength) * perLength;
    rays.Room = rays.Room + more;
    rays.Excess = set(planet.Excess) + more;
    rays.Rise = set(settings.Up[2]);
  }
  else
  {
    rays.Rise = (rays.Aside + set(settings.Up[2])) / length;
    rays.Excess = hn::NegMulAdd(rays.Rise, rays.Rise, rays.Room);
  }
  const auto isMet = hn::And(hn::Lt(rays.Rise, zero), hn::Le(rays.Excess, zero));
  const Float way = hn::Max(rays.Room, zero) /
    (hn::Sqrt(hn::Max(hn::Neg(rays.Excess), zero)) - hn::Min(rays.Rise, set(-1e-12)));
  rays.Way = hn::IfThenElse(isMet, way, set(CoverageSky));
  return rays;
}

// Where a t^2 + 2 b t + c is 0, without cancellation.
struct Roots
{
  Float First;
  Float Second;
  hn::Mask<FloatTag> Are;
};

HWY_INLINE Roots FindRoots(Float a, Float b, Float c)
{
  const FloatTag d;
  const Float zero = hn::Zero(d);
  const Float root = hn::NegMulAdd(a, c, b * b);
  const Float q = hn::Neg(b + hn::CopySign(hn::Sqrt(hn::Max(root, zero)), b));
  const Float one = q / a;
  const Float other = c / hn::IfThenElse(hn::Eq(q, zero), hn::Set(d, 1e-30f), q);
  return { hn::Min(one, other), hn::Max(one, other), hn::Gt(root, zero) };
}

// Over a planet, of the rays of pixels, a point light being there: where they meet the ground, enter the
// planet's shadow and leave it. That is the cone of the light's own horizon, behind it: with A the way from
// the light to a ray's start, and B to its end, along the light's vertical, for each unit of the ray, and r
// the distance from the light, (A + B t)^2 >= room r^2 and A + B t <= -room Radius. Room is the light's.
HWY_INLINE void FindGroundOfLamp(
  const CoverageSettings& settings, Float column, Float row, Rays<FloatTag>& rays)
{
  const FloatTag d;
  const CoverageTable::Globe& planet = settings.Table->Planet;
  const Float zero = hn::Zero(d);
  const auto set = [&](double value) { return hn::Set(d, static_cast<float>(value)); };
  const Float perLength = set(1.0 / planet.Radius);
  const Float radius = set(planet.Radius);
  const RaysOverGround over = FindGround(settings, column, row, rays.Length);
  rays.Ground = hn::Min(over.Way * radius, set(CoverageSky));
  if (!planet.HasShadow)
  {
    return;
  }
  Float along = set(planet.LampAlong);
  if (settings.Parallel)
  {
    const Float nearer = column * set(settings.Light[0]) + row * set(settings.Light[1]);
    along = along + hn::MulAdd(nearer, perLength, over.Aside);
  }
  const Float ofLamp = set(planet.LampRoom);
  const Float slope = hn::MulAdd(rays.Foot, perLength, over.Rise);
  // a t^2 + 2 b t + c >= 0
  Float a = hn::MulAdd(slope, slope, hn::Neg(ofLamp));
  a = hn::IfThenElse(hn::Lt(hn::Abs(a), set(1e-12)), set(-1e-12), a);
  const Float b = hn::MulAdd(along, slope, ofLamp * rays.Foot);
  const Float c = hn::MulAdd(along, along, hn::Neg(ofLamp * rays.Start * rays.Start));
  const Roots roots = FindRoots(a, b, c);
  const auto isWithin = hn::Gt(a, zero); // the ray, in the end, the cone
  const auto isDown = hn::Lt(slope, zero);
  const Float sky = set(CoverageSky);
  Float begin = hn::IfThenElse(isWithin, hn::IfThenElse(isDown, roots.Second, zero), roots.First);
  Float end = hn::IfThenElse(isWithin, hn::IfThenElse(isDown, sky, roots.First), roots.Second);
  const Float horizon = hn::Neg(hn::MulAdd(ofLamp, radius, along)) /
    hn::IfThenElse(hn::Lt(hn::Abs(slope), set(1e-12)), set(1e-12), slope);
  begin = hn::Max(hn::IfThenElse(isDown, hn::Max(begin, horizon), begin), zero);
  end = hn::IfThenElse(isDown, end, hn::Min(end, horizon));
  const auto isDark = hn::And(roots.Are, hn::Gt(end, begin));
  rays.Dusk = hn::IfThenElseZero(isDark, begin);
  rays.Dawn = hn::IfThenElseZero(isDark, hn::Min(end, sky));
}

// Over a planet, of the rays of pixels. Units are those of RaysOverGround; what is nearer to the light than
// the centre is nearer by light + cosine t. Returns the place in rows.
HWY_INLINE Float FindPlanetRays(
  const CoverageSettings& settings, Float column, Float row, Rays<FloatTag>& rays)
{
  const FloatTag d;
  const CoverageTable& table = *settings.Table;
  const CoverageTable::Globe& planet = table.Planet;
  const Float zero = hn::Zero(d);
  const auto set = [&](double value) { return hn::Set(d, static_cast<float>(value)); };
  const RaysOverGround over = FindGround(settings, column, row, rays.Length);
  const Float rise = over.Rise;
  const Float room = over.Room;
  const Float nearer = column * set(settings.Light[0]) + row * set(settings.Light[1]);
  Float light = set(planet.LightSlope);
  Float cosine;
  Float place;
  Float slice;
  if (settings.Parallel)
  {
    cosine = set(settings.Light[2]);
    light = hn::MulAdd(nearer, set(1.0 / planet.Radius), light);
    const Float surface = set(planet.Ground);
    const auto toUnits = [&](Float more) HWY_ATTR // of a distance^2 than Ground^2
    {
      const Float radius = hn::Sqrt(hn::Max(hn::MulAdd(surface, surface, more), zero));
      return InverseSinh(more / (radius + surface) * set(planet.Radius / table.RowUnit));
    };
    place = toUnits(over.Excess) + toUnits(room);
    slice = nearer;
  }
  else
  {
    cosine = (nearer + set(settings.Light[2])) / rays.Length;
    place = InverseSinh((rise - set(planet.Horizon)) * set(1.0 / table.RowUnit));
    slice = cosine;
  }
  rays.Slice = (slice - set(table.FirstSlice)) * set(table.SlicesPerUnit);
  rays.Slice = hn::Min(hn::Max(rays.Slice, zero), set(table.Slices - 1.0));
  const auto isMet = hn::Lt(over.Way, set(CoverageSky));
  rays.Ground = hn::Min(over.Way * set(planet.Radius), set(CoverageSky));
  // Where the air is densest, and how far from there it falls by 1/e: scale = slope s + s^2/2.
  const Float longest = set(planet.Longest);
  const Float foot =
    hn::Min(hn::IfThenElse(isMet, over.Way, hn::Max(hn::Neg(rise), zero)), longest);
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
    const Roots roots = FindRoots(a, b, c);
    const Float middle =
      hn::Neg(light) / hn::IfThenElse(hn::Lt(hn::Abs(cosine), set(1e-12)), set(1e-12), cosine);
    const auto isTowards = hn::Gt(cosine, zero);
    Float begin = hn::Max(roots.First, zero);
    Float end = roots.Second;
    begin = hn::IfThenElse(isTowards, begin, hn::Max(begin, middle));
    end = hn::IfThenElse(isTowards, hn::Min(end, middle), end);
    const auto isDark = hn::And(roots.Are, hn::Gt(end, begin));
    rays.Dusk = hn::IfThenElseZero(isDark, begin * set(planet.Radius));
    rays.Dawn = hn::IfThenElseZero(isDark, end * set(planet.Radius));
  }
  return place;
}

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
    if (settings.PlanetRadius > 0.0)
    {
      FindGroundOfLamp(settings, column, row, rays);
    }
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

// The rays of which others' lanes tell the number.
HWY_INLINE Rays<FloatTag> Select(const Rays<FloatTag>& rays, hn::Vec<IntTag> numbers)
{
  const auto indices = hn::IndicesFromVec(FloatTag(), numbers);
  const auto select = [&](Float field) HWY_ATTR { return hn::TableLookupLanes(field, indices); };
  return { select(rays.Length), select(rays.Row), select(rays.Slice), select(rays.Foot),
    select(rays.Square), select(rays.Start), select(rays.Way), select(rays.InverseWidth),
    select(rays.Gain), select(rays.Ground), select(rays.Dusk), select(rays.Dawn) };
}
}
}
HWY_AFTER_NAMESPACE();

#endif
