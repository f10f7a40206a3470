// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The dark columns of a line and what they hide. Compiled for each set of vector instructions: see
// vtkGodRaysShadowKernels.cxx.
#if defined(vtkGodRaysShadowDark_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysShadowDark_inl_h
#undef vtkGodRaysShadowDark_inl_h
#else
#define vtkGodRaysShadowDark_inl_h
#endif

#include "vtkGodRaysCoverageRays-inl.h"
#include "vtkGodRaysShadowLines.h"
#include "vtkGodRaysShadowTables.h"

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// The sums of what is dark, at two steps of the ladder.
class DarkSums
{
public:
  DarkSums(ShadowLines& memory, const ShadowLadder& ladder)
    : Memory(memory)
    , Ladder(ladder)
  {
  }

  void Clear(int columns)
  {
    std::fill_n(this->Memory.Dark.begin(), columns + 64, 0.0f);
    std::fill_n(this->Memory.DarkBlocks.begin(), columns / ShadowBlock + 2, 0);
  }

  HWY_INLINE void Mark(int column)
  {
    this->Memory.Dark[column] = 1.0f;
    ++this->Memory.DarkBlocks[column / ShadowBlock];
  }

  // A part of its light.
  HWY_INLINE void Mark(int column, float part)
  {
    this->Memory.Dark[column] += part;
    ++this->Memory.DarkBlocks[column / ShadowBlock];
  }

  // At a step and the next one, of the columns before an end.
  void Build(int step, int end)
  {
    this->Blocks = end / ShadowBlock + 1;
    for (int node = 0; node < 2; ++node)
    {
      this->Weights[node] =
        this->Ladder.Weights.data() + static_cast<std::size_t>(step + node) * this->Ladder.Columns;
    }
    const float* dark = this->Memory.Dark.data();
    float* inner = this->Memory.Inner.data();
    float* outer = this->Memory.Outer.data();
    float totals[2] = {};
    for (int block = 0; block < this->Blocks; ++block, inner += ShadowBlockRoom, outer += 2)
    {
      std::copy_n(totals, 2, outer);
      if (this->Memory.DarkBlocks[block] == 0)
      {
        std::fill_n(inner, 2 * ShadowBlock + 2, 0.0f);
        continue;
      }
      const FourTag d;
      auto one = hn::Zero(d); // sums before
      auto other = hn::Zero(d);
      for (int j = 0; j < ShadowBlock; j += FourLanes)
      {
        const int column = block * ShadowBlock + j;
        const auto part = hn::LoadU(d, dark + column);
        const auto ofOne = one + SumLanes(part * hn::LoadU(d, this->Weights[0] + column));
        const auto ofOther = other + SumLanes(part * hn::LoadU(d, this->Weights[1] + column));
        hn::StoreInterleaved2(ofOne, ofOther, d, inner + 2 * j + 2);
        one = hn::Broadcast<FourLanes - 1>(ofOne);
        other = hn::Broadcast<FourLanes - 1>(ofOther);
      }
      std::fill_n(inner, 2, 0.0f);
      for (int node = 0; node < 2; ++node)
      {
        totals[node] += inner[2 * ShadowBlock + node];
      }
    }
  }

  HWY_INLINE void Add(int column)
  {
    this->Add(column, this->Weights[0][column], this->Weights[1][column]);
  }
  HWY_INLINE void Add(int column, float part)
  {
    this->Add(column, part * this->Weights[0][column], part * this->Weights[1][column]);
  }

  // Before a place in a column, at both steps.
  HWY_INLINE void Read(unsigned int column, float within, float* sums) const
  {
    const hn::CappedTag<float, 2> d;
    const unsigned int block = column / ShadowBlock;
    const float* inner =
      this->Memory.Inner.data() + block * ShadowBlockRoom + column % ShadowBlock * 2;
    const float* outer = this->Memory.Outer.data() + 2 * block;
    for (int node = 0; node < 2; node += hn::MaxLanes(d))
    {
      const auto low = hn::LoadU(d, inner + node);
      const auto high = hn::LoadU(d, inner + node + 2);
      const auto before = hn::LoadU(d, outer + node);
      hn::StoreU(hn::MulAdd(hn::Set(d, within), high - low, before + low), d, sums + node);
    }
  }

private:
  using FourTag = hn::CappedTag<float, 4>;
  static constexpr int FourLanes = HWY_TARGET == HWY_SCALAR ? 1 : 4;

  // The sums of the numbers up to each.
  static HWY_INLINE hn::Vec<FourTag> SumLanes(hn::Vec<FourTag> x)
  {
#if HWY_TARGET != HWY_SCALAR
    const FourTag d;
    x = x + hn::ShiftLeftLanes<1>(d, x);
    x = x + hn::ShiftLeftLanes<2>(d, x);
#endif
    return x;
  }

  // One number and the other in turn, from the place k on.
  static HWY_INLINE Float Alternate(float one, float other, int k)
  {
    const FloatTag d;
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, k % 2 == 0 ? one : other);
#else
    static_cast<void>(k); // even
    return hn::OddEven(hn::Set(d, other), hn::Set(d, one));
#endif
  }

  // To what follows the column in its block, and to the blocks that follow.
  HWY_INLINE void Add(int column, float one, float other)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const int block = column / ShadowBlock;
    const float* after = this->Memory.IsAfter.data() + this->Memory.IsAfter.size() / 2;
    const float* inside = after - 2 * (column % ShadowBlock + 1);
    const float* outside = after - 2 * (block + 1);
    float* inner = this->Memory.Inner.data() + block * ShadowBlockRoom;
    for (int k = 0; k < 2 * ShadowBlock + 2; k += lanes)
    {
      hn::StoreU(
        hn::MulAdd(Alternate(one, other, k), hn::LoadU(d, inside + k), hn::LoadU(d, inner + k)), d,
        inner + k);
    }
    float* outer = this->Memory.Outer.data();
    for (int k = 0; k < 2 * this->Blocks; k += lanes)
    {
      hn::StoreU(
        hn::MulAdd(Alternate(one, other, k), hn::LoadU(d, outside + k), hn::LoadU(d, outer + k)), d,
        outer + k);
    }
  }

  ShadowLines& Memory;
  const ShadowLadder& Ladder;
  const float* Weights[2] = {};
  int Blocks = 0;
};

// The runs of columns that are dark.
class DarkRuns
{
public:
  explicit DarkRuns(ShadowLines& memory)
    : Memory(memory)
  {
  }

  void Clear(int columns)
  {
    std::fill_n(this->Memory.Dark.begin(), columns + 64, 0.0f);
    this->Memory.RunBegin.clear();
    this->Memory.RunEnd.clear();
  }

  // A column that is not dark yet.
  HWY_INLINE void Mark(int column)
  {
    ShadowLines& m = this->Memory;
    m.Dark[column] = 1.0f;
    const bool joinsBefore = column > 0 && m.Dark[column - 1] != 0.0f;
    const bool joinsAfter = m.Dark[column + 1] != 0.0f;
    const int first = joinsBefore ? m.OtherEnd[column - 1] : column;
    const int last = joinsAfter ? m.OtherEnd[column + 1] : column;
    m.OtherEnd[first] = last;
    m.OtherEnd[last] = first;
    if (joinsBefore)
    {
      m.RunEnd[m.RunAt[first]] = last + 1;
      if (joinsAfter)
      {
        this->Remove(m.RunAt[column + 1]);
      }
    }
    else if (joinsAfter)
    {
      const int at = m.RunAt[column + 1];
      m.RunBegin[at] = first;
      m.RunAt[first] = at;
    }
    else
    {
      m.RunAt[first] = static_cast<int>(m.RunBegin.size());
      m.RunBegin.push_back(first);
      m.RunEnd.push_back(first + 1);
    }
  }

private:
  void Remove(int at)
  {
    ShadowLines& m = this->Memory;
    m.RunBegin[at] = m.RunBegin.back();
    m.RunEnd[at] = m.RunEnd.back();
    m.RunAt[m.RunBegin[at]] = at;
    m.RunBegin.pop_back();
    m.RunEnd.pop_back();
  }

  ShadowLines& Memory;
};

// How dark columns are, in steps so small that pictures do not show them, and the runs of those that are
// alike.
class DarkShades
{
public:
  static constexpr float Steps = 512.0f;

  explicit DarkShades(ShadowLines& memory)
    : Memory(memory)
  {
  }

  void Clear(int channels)
  {
    this->Channels = channels;
    for (int c = 0; c < channels; ++c)
    {
      std::fill(this->Memory.Sum[c].begin(), this->Memory.Sum[c].end(), 0.0f);
      std::fill(this->Memory.Shade[c].begin(), this->Memory.Shade[c].end(), 0);
    }
    std::fill(this->Memory.ShadeEdges.begin(), this->Memory.ShadeEdges.end(), 0);
  }

  // What turns dark of a column at a place of Part.
  HWY_INLINE void Mark(int column, int place)
  {
    ShadowLines& m = this->Memory;
    for (int c = 0; c < this->Channels; ++c)
    {
      m.Sum[c][column] += m.Part[c][place];
      m.Shade[c][column + 1] = static_cast<int>(std::lround(Steps * m.Sum[c][column]));
    }
    this->FindEdge(column);
    this->FindEdge(column + 1);
  }

  // visit(first, one after the last) of all runs that are dark.
  template <typename Visit>
  void Find(const Visit& visit) const
  {
    const ShadowLines& m = this->Memory;
    int begin = -1;
    for (std::size_t word = 0; word < m.ShadeEdges.size(); ++word)
    {
      for (std::uint64_t bits = m.ShadeEdges[word]; bits != 0; bits &= bits - 1)
      {
        const int edge = static_cast<int>(64 * word + hwy::Num0BitsBelowLS1Bit_Nonzero64(bits));
        if (begin >= 0)
        {
          visit(begin, edge);
        }
        bool isDark = false;
        for (int c = 0; c < this->Channels; ++c)
        {
          isDark = isDark || m.Shade[c][edge + 1] > 0;
        }
        begin = isDark ? edge : -1;
      }
    }
  }

private:
  HWY_INLINE void FindEdge(int column)
  {
    ShadowLines& m = this->Memory;
    bool differs = false;
    for (int c = 0; c < this->Channels; ++c)
    {
      differs = differs || m.Shade[c][column] != m.Shade[c][column + 1];
    }
    const std::uint64_t bit = std::uint64_t(1) << column % 64;
    std::uint64_t& word = m.ShadeEdges[column / 64];
    word = differs ? word | bit : word & ~bit;
  }

  ShadowLines& Memory;
  int Channels = 1;
};

// Where columns begin along view rays: a ray is there at the depth (A x + B y)/(C x + D y), whose x and y are
// the column's and A to D the ray's,
//
//                         x        y         A    B    C    D
//     directional         t        1         1    0    0    Q
//     point               sin a    -cos a    d    0    P    Q
//     directional, rays parallel             1   -t0   0    Q
//     point, rays parallel                   z   -t0   1    0
//
// where a parallel ray begins at t0, and the point light is at the depth z.
struct ColumnEdges
{
  const float* X;
  const float* Y;
};

// How many columns a point light's map may be off where a ray ends: a texel's diagonal and a column, and what
// half a strip of the picture, which is as dark as its middle line, is seen to be from the light. What is lit
// so shortly before a ray's end, after what is dark, is what lies on the far side of what is seen, as within
// a closed thing with a light in it. Not of layers that let light through, whose runs follow each other.
// At most 48: a fan's tables go on for 64 columns.
inline int CountUnsureColumns(
  const CoverageWedge& wedge, const vtkGodRaysShadowGrids& grids, double columnAngle)
{
  if (!grids.Point || grids.NumberOfLayers > 0)
  {
    return 0;
  }
  const double reach = std::abs(wedge.W * wedge.Widest - wedge.B); // of the widest strip, times W
  const double strip = std::abs(wedge.W) * 0.5 * wedge.Spacing / std::max(reach, 1e-30);
  return 3 + static_cast<int>(std::min(std::ceil(strip / columnAngle), 45.0));
}

// What the runs hide of some pixels, as many as there are lanes. All of them at once are measured faster
// than each pixel's on its own.
class SeenRuns
{
public:
  // unsure: see CountUnsureColumns().
  SeenRuns(ShadowLines& memory, int unsure)
    : Memory(memory)
    , Unsure(unsure)
  {
  }

  void Clear()
  {
    this->Memory.SeenBegin.clear();
    this->Memory.SeenEnd.clear();
    this->Memory.Seer.clear();
    for (std::vector<float>& parts : this->Memory.SeenDark)
    {
      parts.clear();
    }
  }

  // The same of what is dark in part.
  void Add(const DarkShades& shades, int channels, int pixel)
  {
    ShadowLines& m = this->Memory;
    shades.Find(
      [&](int begin, int end)
      {
        m.SeenBegin.push_back(begin);
        m.SeenEnd.push_back(end);
        for (int c = 0; c < channels; ++c)
        {
          m.SeenDark[c].push_back(m.Shade[c][begin + 1] / DarkShades::Steps);
        }
      });
    m.Seer.resize(m.SeenBegin.size(), pixel);
    this->Ends[pixel] = static_cast<int>(m.SeenBegin.size());
  }

  // All runs as they are now, for the next pixel.
  void Add(int pixel)
  {
    ShadowLines& m = this->Memory;
    m.SeenBegin.insert(m.SeenBegin.end(), m.RunBegin.begin(), m.RunBegin.end());
    m.SeenEnd.insert(m.SeenEnd.end(), m.RunEnd.begin(), m.RunEnd.end());
    m.Seer.resize(m.SeenBegin.size(), pixel);
    this->Ends[pixel] = static_cast<int>(m.SeenBegin.size());
  }

  // Along rays that meet edges as four numbers tell, between their first and last depths.
  void Measure(const CoverageSettings& settings, const ColumnEdges& edges,
    const Rays<FloatTag>& rays, const Float meeting[4], Float first, Float last)
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    ShadowLines& m = this->Memory;
    const int count = static_cast<int>(m.SeenBegin.size());
    for (std::vector<int>* values : { &m.SeenBegin, &m.SeenEnd, &m.Seer })
    {
      values->resize(count + lanes, 0);
    }
    for (int plane = 0; plane < settings.Planes; ++plane)
    {
      m.Hidden[plane].resize(std::max<std::size_t>(m.Hidden[plane].size(), count + lanes));
    }
    for (int i = 0; i < count; i += lanes)
    {
      const auto seers = hn::LoadU(di, m.Seer.data() + i);
      const auto indices = hn::IndicesFromVec(d, seers);
      const Float begin = hn::TableLookupLanes(first, indices);
      const Float end = hn::TableLookupLanes(last, indices);
      const Float a = hn::TableLookupLanes(meeting[0], indices);
      const Float b = hn::TableLookupLanes(meeting[1], indices);
      const Float c = hn::TableLookupLanes(meeting[2], indices);
      const Float e = hn::TableLookupLanes(meeting[3], indices);
      const auto toDepth = [&](const int* columns, int more) HWY_ATTR
      {
        const auto column = hn::Add(hn::LoadU(di, columns + i), hn::Set(di, more));
        const Float x = hn::GatherIndex(d, edges.X, column);
        const Float y = hn::GatherIndex(d, edges.Y, column);
        const Float rate = hn::Max(hn::MulAdd(c, x, e * y), hn::Set(d, 1e-30f));
        return hn::Max(hn::Min(hn::MulAdd(a, x, b * y) / rate, end), begin);
      };
      const Float low = toDepth(m.SeenBegin.data(), 0);
      Float high = toDepth(m.SeenEnd.data(), 0);
      if (this->Unsure > 0)
      {
        const Float within = toDepth(m.SeenEnd.data(), this->Unsure);
        high = hn::IfThenElse(hn::Ge(within, end), end, high);
      }
      if (hn::AllTrue(d, hn::Ge(low, high))) // beyond the ray's end
      {
        for (int plane = 0; plane < settings.Planes; ++plane)
        {
          hn::StoreU(hn::Zero(d), d, m.Hidden[plane].data() + i);
        }
        continue;
      }
      const Rays<FloatTag> here = Select(rays, seers);
      const RayParts<false> parts(settings, here, low * here.Length, high * here.Length);
      for (int plane = 0; plane < settings.Planes; ++plane)
      {
        hn::StoreU(hn::Max(parts.Measure(plane), hn::Zero(d)), d, m.Hidden[plane].data() + i);
      }
    }
  }

  // What is dark in part.
  void Weigh(int plane, int channel)
  {
    float* hidden = this->Memory.Hidden[plane].data();
    const std::vector<float>& parts = this->Memory.SeenDark[channel];
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      hidden[i] *= parts[i];
    }
  }

  HWY_INLINE void Sum(int plane, int pixels, float* sums) const
  {
    const float* hidden = this->Memory.Hidden[plane].data();
    int i = 0;
    for (int pixel = 0; pixel < pixels; ++pixel)
    {
      float sum = 0.0f;
      for (; i < this->Ends[pixel]; ++i)
      {
        sum += hidden[i];
      }
      sums[pixel] = sum;
    }
  }

private:
  ShadowLines& Memory;
  const int Unsure;
  int Ends[8]; // of pixels' runs
};
}
}
HWY_AFTER_NAMESPACE();

#endif
