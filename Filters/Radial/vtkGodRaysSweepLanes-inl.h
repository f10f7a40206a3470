// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled for each set of vector instructions: see vtkGodRaysSweepKernels.cxx.
#if defined(vtkGodRaysSweepLanes_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysSweepLanes_inl_h
#undef vtkGodRaysSweepLanes_inl_h
#else
#define vtkGodRaysSweepLanes_inl_h
#endif

#include "vtkGodRaysLanes-inl.h"

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

// Lanes that are computed together, in one or several registers: positions are rounded alike then.
constexpr int Group = 16;

// Sums below this are 0: numbers too small to be normalised are slow.
constexpr float Negligible = 1e-36f;

HWY_INLINE int GetLanes()
{
  return static_cast<int>(hn::Lanes(FloatTag()));
}

// Where in its group a register begins.
HWY_INLINE int FindLane(int index)
{
  return GetLanes() == Group ? 0 : index % Group;
}

// Infinity would make NaN of black.
inline float ToFloat(double value)
{
  return static_cast<float>(std::min(value, static_cast<double>(LargestFloat)));
}

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

// Where a row is read: as many places as there are lanes, step apart.
struct Places
{
  std::ptrdiff_t Base;
  Int Index; // from Base
  Float Fraction;
};

// Lanes of a group of 16 from the given one on; position is that of the group's first. Rounding does
// not depend on how many lanes there are. maximum: of Index, when rounding goes beyond it.
HWY_INLINE Places FindPlaces(double position, float step, int lane, int maximum)
{
  const FloatTag d;
  const IntTag di;
  const double base = std::floor(position);
  const float start = static_cast<float>(position - base);
  const Float local = CountFrom(d, static_cast<float>(lane)) * hn::Set(d, step) + hn::Set(d, start);
  const int first = lane == 0 ? 0 : static_cast<int>(static_cast<float>(lane) * step + start);
  Places places;
  places.Base = static_cast<std::ptrdiff_t>(base) + first;
  places.Index = hn::Min(hn::ConvertTo(di, local) - hn::Set(di, first), hn::Set(di, maximum));
  places.Fraction = local - hn::ConvertTo(d, places.Index + hn::Set(di, first));
  return places;
}

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

// Linear between neighbours. Steps from one place to the next are at most Registers.
template <int Registers>
HWY_INLINE Float Read(const float* row, const Places& places)
{
  const Float left = Look<Registers>(row + places.Base, places.Index);
  const Float right = Look<Registers>(row + places.Base + 1, places.Index);
  return AddProduct(places.Fraction, right - left, left);
}

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

// In each block of four lanes, four rows become four columns.
HWY_INLINE void TransposeBlocks([[maybe_unused]] Float rows[4])
{
#if HWY_TARGET != HWY_SCALAR
  const FloatTag d;
  const hn::RebindToFloat<hn::RepartitionToWide<IntTag>> wide;
  const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, rows[0], rows[1]));
  const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, rows[2], rows[3]));
  const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, rows[0], rows[1]));
  const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, rows[2], rows[3]));
  rows[0] = hn::BitCast(d, hn::InterleaveLower(wide, low01, low23));
  rows[1] = hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23));
  rows[2] = hn::BitCast(d, hn::InterleaveLower(wide, high01, high23));
  rows[3] = hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23));
#endif
}

// Four floats for each block of four lanes; at: where, for every fourth lane.
template <class Index>
HWY_INLINE Float LoadBlocks(const float* from, const Index* at)
{
  const FloatTag d;
#if HWY_TARGET == HWY_SCALAR
  return hn::LoadU(d, from + at[0]);
#else
  const hn::FixedTag<float, 4> block;
#if HWY_TARGET == HWY_AVX3
  const hn::FixedTag<float, 8> half;
  return hn::Combine(d,
    hn::Combine(half, hn::LoadU(block, from + at[12]), hn::LoadU(block, from + at[8])),
    hn::Combine(half, hn::LoadU(block, from + at[4]), hn::LoadU(block, from + at[0])));
#elif HWY_TARGET == HWY_AVX2
  return hn::Combine(d, hn::LoadU(block, from + at[4]), hn::LoadU(block, from + at[0]));
#else
  return hn::LoadU(block, from + at[0]);
#endif
#endif
}

// How far the places of a register's lanes lie apart.
enum Reach
{
  NEAR,   // within one register
  MIDDLE, // within two, with the three neighbours
  FAR,    // within two
  ANY
};

// Cubic between neighbours. Where lanes lie far apart, and registers are short, each lane loads its four
// neighbours at once: quicker than Highway's gathering, which takes one float at a time.
template <int Reach>
HWY_INLINE Float ReadSmoothly(const float* row, const Places& places)
{
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
  constexpr bool looks = Reach == FAR;
#else
  constexpr bool looks = Reach == NEAR || HWY_TARGET == HWY_SCALAR;
#endif
  if constexpr (looks)
  {
    constexpr int Registers = Reach == NEAR ? 1 : 2;
    return Interpolate(Look<Registers>(from - 1, places.Index), Look<Registers>(from, places.Index),
      Look<Registers>(from + 1, places.Index), Look<Registers>(from + 2, places.Index),
      places.Fraction);
  }
  else
  {
    HWY_ALIGN std::int32_t at[Group];
    hn::Store(places.Index, IntTag(), at);
    Float rows[4];
    for (int i = 0; i < 4; ++i)
    {
      rows[i] = LoadBlocks(from - 1, at + i);
    }
    TransposeBlocks(rows);
    return Interpolate(rows[0], rows[1], rows[2], rows[3], places.Fraction);
  }
}

// Sixteen rows of sixteen become columns. All begin at lines of the cache, or nearly.
HWY_INLINE void Transpose16(
  const float* from, std::ptrdiff_t fromStride, float* to, std::ptrdiff_t toStride)
{
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < Group; ++i)
  {
    for (int j = 0; j < Group; ++j)
    {
      to[j * toStride + i] = from[i * fromStride + j];
    }
  }
#else
  std::ptrdiff_t at[Group];
  for (int i = 0; i < Group; ++i)
  {
    at[i] = i * fromStride;
  }
  for (int i = 0; i < Group; i += GetLanes())
  {
    for (int j = 0; j < Group; j += 4)
    {
      Float rows[4];
      for (int k = 0; k < 4; ++k)
      {
        rows[k] = LoadBlocks(from + j, at + i + k);
      }
      TransposeBlocks(rows);
      for (int k = 0; k < 4; ++k)
      {
        hn::StoreU(rows[k], FloatTag(), to + (j + k) * toStride + i);
      }
    }
  }
#endif
}

// The first float at or after values that begins a line of the cache.
inline float* Align(float* values)
{
  const auto address = reinterpret_cast<std::uintptr_t>(values) / sizeof(float);
  return values + (16 - address % 16) % 16;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
