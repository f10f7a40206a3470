// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysShadowKernels.cxx"
#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysCoverageRays-inl.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysShadowKernels.h"

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#ifndef vtkGodRaysShadowKernels_once
#define vtkGodRaysShadowKernels_once
namespace vtkGodRays
{
constexpr int ShadowBlock = 32; // columns whose sums are one

class ShadowLines
{
public:
  // Of a line's rows.
  std::vector<float> RowFirst, RowEnd; // pixels of the wedge
  std::vector<int> Begin, End;         // pixels of the line
  std::vector<float> Perpendicular;    // distance from the axis at depth 1 [columns]
  std::vector<float> Extinction;       // for each column's width
  std::vector<float> Step;             // place on the ladder
  std::vector<float> Before;           // transmittance of what is before the first column
  std::vector<int> Head;               // the first column that turns dark there, or -1
  // Of its pixels.
  std::vector<int> Offset, Row;
  std::vector<float> Last; // where rays end [columns]
  // Of columns.
  std::vector<int> Flip, Next;
  std::vector<float> Dark;     // 1 or 0
  std::vector<int> DarkBlocks; // how many columns of each block are
  std::vector<float> Inner[2]; // sums of what is dark before a column, in its block
  std::vector<float> Outer[2]; // and in the blocks before
  std::vector<float> IsAfter;  // 0 in its first half, then 1

  void Reserve(int rows, int columns)
  {
    const std::size_t paddedRows = rows + 16;
    for (std::vector<float>* values : { &this->RowFirst, &this->RowEnd, &this->Perpendicular,
           &this->Extinction, &this->Step, &this->Before })
    {
      values->resize(paddedRows);
    }
    for (std::vector<int>* values : { &this->Begin, &this->End, &this->Head })
    {
      values->resize(paddedRows);
    }
    this->Offset.resize(4 * paddedRows);
    this->Row.resize(4 * paddedRows);
    this->Last.resize(4 * paddedRows);
    this->Flip.resize(columns + 64);
    this->Next.resize(columns + 64);
    this->Dark.resize(columns + 64);
    const std::size_t blocks = columns / ShadowBlock + 64;
    this->DarkBlocks.resize(blocks);
    if (this->IsAfter.size() != 2 * blocks)
    {
      this->IsAfter.assign(2 * blocks, 1.0f);
      std::fill_n(this->IsAfter.begin(), blocks, 0.0f);
    }
    for (int i = 0; i < 2; ++i)
    {
      this->Inner[i].resize(columns + 64);
      this->Outer[i].resize(blocks);
    }
  }
};
}
#endif

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
HWY_INLINE Float SetFloat(double value)
{
  return hn::Set(FloatTag(), static_cast<float>(value));
}

//------------------------------------------------------------------------------
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

  // At a step and the next one, of the columns before an end.
  void Build(int step, int end)
  {
    this->Blocks = end / ShadowBlock + 1;
    for (int node = 0; node < 2; ++node)
    {
      const float* weights =
        this->Ladder.Weights.data() + static_cast<std::size_t>(step + node) * this->Ladder.Columns;
      this->Weights[node] = weights;
      float* inner = this->Memory.Inner[node].data();
      float* outer = this->Memory.Outer[node].data();
      float total = 0.0f;
      for (int block = 0; block < this->Blocks; ++block)
      {
        const int first = block * ShadowBlock;
        outer[block] = total;
        float sum = 0.0f;
        if (this->Memory.DarkBlocks[block] == 0)
        {
          std::fill_n(inner + first, ShadowBlock, 0.0f);
          continue;
        }
        for (int j = first; j < first + ShadowBlock; ++j)
        {
          inner[j] = sum;
          sum += weights[j] * this->Memory.Dark[j];
        }
        total += sum;
      }
      inner[this->Blocks * ShadowBlock] = 0.0f;
      std::fill_n(outer + this->Blocks, 16, total);
    }
  }

  HWY_INLINE void Add(int column)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const int block = column / ShadowBlock;
    const float* before = this->Memory.IsAfter.data() + this->Memory.IsAfter.size() / 2 - 1;
    const float* inside = before - column % ShadowBlock;
    const float* outside = before - block;
    for (int node = 0; node < 2; ++node)
    {
      const Float weight = hn::Set(d, this->Weights[node][column]);
      float* inner = this->Memory.Inner[node].data() + block * ShadowBlock;
      for (int k = 0; k < ShadowBlock; k += lanes)
      {
        hn::StoreU(
          hn::MulAdd(weight, hn::LoadU(d, inside + k), hn::LoadU(d, inner + k)), d, inner + k);
      }
      float* outer = this->Memory.Outer[node].data();
      for (int k = 0; k <= this->Blocks; k += lanes)
      {
        hn::StoreU(
          hn::MulAdd(weight, hn::LoadU(d, outside + k), hn::LoadU(d, outer + k)), d, outer + k);
      }
    }
  }

  // Before a place in columns, at a part of the way from the first step to the second.
  HWY_INLINE float Read(float place, float part) const
  {
    const int column = static_cast<int>(place);
    const float within = place - column;
    float sums[2];
    for (int node = 0; node < 2; ++node)
    {
      const float* inner = this->Memory.Inner[node].data();
      const float* outer = this->Memory.Outer[node].data();
      const float low = outer[column / ShadowBlock] + inner[column];
      const float high = outer[(column + 1) / ShadowBlock] + inner[column + 1];
      sums[node] = low + within * (high - low);
    }
    return sums[0] + part * (sums[1] - sums[0]);
  }

private:
  ShadowLines& Memory;
  const ShadowLadder& Ladder;
  const float* Weights[2] = {};
  int Blocks = 0;
};

//------------------------------------------------------------------------------
class ShadowSweep
{
public:
  ShadowSweep(const CoverageSettings& settings, const CoverageImage& image,
    const CoverageWedge& wedge, const vtkGodRaysShadowGrids& grids, const ShadowLadder& ladder,
    const ShadowPicture& picture, ShadowLines& memory)
    : Settings(settings)
    , Image(image)
    , Wedge(wedge)
    , Grids(grids)
    , Ladder(ladder)
    , Picture(picture)
    , Memory(memory)
    , Sums(memory, ladder)
    , Light(settings.Light[0], settings.Light[1], settings.Light[2])
  {
    memory.Reserve(wedge.Rows, ladder.Columns);
    for (int k = 0; k < wedge.Rows; ++k)
    {
      int first;
      int last;
      FindCoveragePixels(wedge, image, wedge.First + k * wedge.Direction, first, last);
      memory.RowFirst[k] = static_cast<float>(first);
      memory.RowEnd[k] = static_cast<float>(std::max(last + 1, first));
    }
  }

  void Sweep(int line)
  {
    if (!this->FindPixels(line) || !this->FindColumns() || !this->FindFlips())
    {
      return;
    }
    for (int c = 0; c < this->Settings.Channels; ++c)
    {
      this->MeasureRows(this->Settings.Extinction[c]);
      this->MeasurePixels();
      this->Hide(this->Picture.Hidden[c]);
    }
  }

private:
  // A line, x = At + Slope n in the n-th row of the wedge.
  struct Straight
  {
    double At;
    double Slope;
  };
  Straight GetLine(double index) const
  {
    const CoverageWedge& wedge = this->Wedge;
    const double x = wedge.FirstLine + index * CoverageSpacing;
    const double slope = (wedge.W * x - wedge.A) / (wedge.W * wedge.Widest - wedge.B);
    return { x + slope * (wedge.First - wedge.Widest), slope * wedge.Direction };
  }

  // The rows in which the line's strip meets the picture, and the pixels in it.
  bool FindPixels(int line)
  {
    const Straight left = this->GetLine(line - 0.5);
    const Straight right = this->GetLine(line + 0.5);
    double low = 0.0;
    double high = this->Wedge.Rows - 1.0;
    const auto clip = [&](double value, double slope) // value + slope n >= 0
    {
      if (slope > 1e-14)
      {
        low = std::max(low, std::ceil(-value / slope));
      }
      else if (slope < -1e-14)
      {
        high = std::min(high, std::floor(-value / slope));
      }
      else if (value < 0.0)
      {
        high = -1.0;
      }
    };
    clip(right.At + 1.0, right.Slope);
    clip(this->Image.Width - left.At, -left.Slope);
    if (!(low <= high))
    {
      return false;
    }
    this->FirstRow = static_cast<int>(low);
    this->Rows = static_cast<int>(high) - this->FirstRow + 1;
    this->FindEdges(left, this->Memory.Begin.data());
    this->FindEdges(right, this->Memory.End.data());
    this->Center = this->GetLine(line);
    const int row = this->Wedge.First + this->FirstRow * this->Wedge.Direction;
    const std::ptrdiff_t step = this->Picture.Along * this->Wedge.Direction;
    std::ptrdiff_t base = row * this->Picture.Along;
    int n = 0;
    for (int k = 0; k < this->Rows; ++k, base += step)
    {
      const int begin = this->Memory.Begin[k];
      const int count = std::min(this->Memory.End[k] - begin, 3);
      for (int i = 0; i < 3; ++i) // without branches; what is too much is written over
      {
        this->Memory.Offset[n + i] = static_cast<int>(base + (begin + i) * this->Picture.Across);
        this->Memory.Row[n + i] = k;
      }
      n += std::max(count, 0);
    }
    this->Pixels = n;
    return n > 0;
  }

  // Neighbours round their common edge alike: rows are counted from the wedge's first.
  void FindEdges(const Straight& edge, int* columns) const
  {
    const FloatTag d;
    const IntTag di;
    for (int k = 0; k < this->Rows; k += GetLanes())
    {
      const int n = this->FirstRow + k;
      const Float x =
        hn::Ceil(SetFloat(edge.At) + SetFloat(edge.Slope) * hn::Iota(d, static_cast<float>(n)));
      const Float first = hn::LoadU(d, this->Memory.RowFirst.data() + n);
      const Float end = hn::LoadU(d, this->Memory.RowEnd.data() + n);
      hn::StoreU(hn::ConvertTo(di, hn::Min(hn::Max(x, first), end)), di, columns + k);
    }
  }

  Vec3 GetRay(double k) const
  {
    const double n = this->FirstRow + k;
    const double x = this->Center.At + this->Center.Slope * n;
    const double row = this->Wedge.First + n * this->Wedge.Direction;
    return Vec3((x - this->Image.Center[0]) * this->Settings.PixelSize,
      (row - this->Image.Center[1]) * this->Settings.PixelSize, 1.0);
  }

  // The line's plane, and the columns of the map in it.
  bool FindColumns()
  {
    const Vec3 ray = this->GetRay(0.0);
    const Vec3 next = this->GetRay(1.0) - ray;
    const Vec3 last = this->GetRay(this->Rows - 1.0);
    // Across the light, from the ray that is farther from the axis.
    Vec3 across = last - dot(last, this->Light) * this->Light;
    const Vec3 other = ray - dot(ray, this->Light) * this->Light;
    across = normalize(dot(other, other) > dot(across, across) ? other : across);
    this->Along[0] = dot(ray, this->Light);
    this->Along[1] = dot(next, this->Light);
    this->Across[0] = dot(ray, across);
    this->Across[1] = dot(next, across);
    this->Square[0] = dot(ray, ray);
    this->Square[1] = 2.0 * dot(ray, next);
    this->Square[2] = dot(next, next);

    const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[0];
    double begin = 0.0;
    double end = 1e30;
    double most = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const double* axis = this->Grids.Axes[i];
      this->Direction[i] = dot(across, Vec3(axis[0], axis[1], axis[2]));
      most = std::max(most, std::abs(this->Direction[i]) / grid.Texel[i]);
      const double low = grid.Low[i];
      const double high = low + grid.Size[i] * grid.Texel[i];
      if (std::abs(this->Direction[i]) < 1e-12)
      {
        end = low <= 0.0 && high >= 0.0 ? end : -1.0;
        continue;
      }
      const double one = low / this->Direction[i];
      const double two = high / this->Direction[i];
      begin = std::max(begin, std::min(one, two));
      end = std::min(end, std::max(one, two));
    }
    if (!(begin < end) || !(most > 0.0))
    {
      return false;
    }
    // From the eye on; if the map begins later, from there, as if by Each columns before it.
    this->Width = 1.0 / most;
    this->Start = begin > 0.0 ? begin - ShadowLadder::Each * this->Width : 0.0;
    this->FirstColumn = begin > 0.0 ? ShadowLadder::FirstWhole : 0;
    const double whole = (end - this->Start) / this->Width - ShadowLadder::Each;
    const double room = this->Ladder.Columns - 64.0;
    this->Columns =
      static_cast<int>(std::min(std::ceil(std::max(whole, 0.0)) + ShadowLadder::FirstWhole, room));
    return true;
  }

  // The row in which each column turns dark; false if none does.
  bool FindFlips()
  {
    std::fill_n(this->Memory.Head.begin(), this->Rows, -1);
    int end = this->Columns;
    for (int level = 0; level < this->Grids.Levels && end > this->FirstColumn; ++level)
    {
      int begin = this->FirstColumn;
      if (level + 1 < this->Grids.Levels)
      {
        double reach = 1e30; // what is nearer is the next grid's
        for (int i = 0; i < 2; ++i)
        {
          if (std::abs(this->Direction[i]) > 1e-12)
          {
            reach = std::min(
              reach, this->Grids.GetReach(level + 1, i, this->Direction[i]) / this->Direction[i]);
          }
        }
        const auto middles = this->Ladder.Middles.begin();
        begin = static_cast<int>(std::lower_bound(middles + begin, middles + end,
                                   static_cast<float>((reach - this->Start) / this->Width)) -
          middles);
      }
      this->FindFlips(this->Grids.Grids[level], begin, end);
      end = begin;
    }
    int flips = 0;
    for (int j = this->FirstColumn; j < this->Columns; ++j)
    {
      const int row = this->Memory.Flip[j];
      if (row < this->Rows)
      {
        this->Memory.Next[j] = this->Memory.Head[row];
        this->Memory.Head[row] = j;
        ++flips;
      }
    }
    return flips > 0;
  }

  void FindFlips(const vtkGodRaysShadowGrids::Grid& grid, int begin, int end)
  {
    const FloatTag d;
    const IntTag di;
    const Float one = SetFloat(1.0);
    const Float zero = hn::Zero(d);
    Float gain[2];
    Float offset[2];
    for (int i = 0; i < 2; ++i)
    {
      const double perLength = this->Direction[i] / grid.Texel[i];
      gain[i] = SetFloat(perLength * this->Width);
      offset[i] = SetFloat(perLength * this->Start - grid.Low[i] / grid.Texel[i]);
    }
    const Float p0 = SetFloat(this->Along[0]);
    const Float p1 = SetFloat(this->Along[1]);
    const Float q0 = SetFloat(this->Across[0]);
    const Float q1 = SetFloat(this->Across[1]);
    const Float rows = SetFloat(this->Rows);
    const Float lastP = SetFloat(this->Along[0] + this->Along[1] * (this->Rows - 1));
    const Float lastQ = SetFloat(this->Across[0] + this->Across[1] * (this->Rows - 1));
    const auto stride = hn::Set(di, static_cast<int>(grid.Stride));
    for (int j = begin; j < end; j += GetLanes())
    {
      const Float middle = hn::LoadU(d, this->Ladder.Middles.data() + j);
      const auto index = [&](int i) HWY_ATTR
      {
        const auto texel = hn::ConvertTo(di, hn::MulAdd(gain[i], middle, offset[i]));
        return hn::Min(hn::Max(texel, hn::Zero(di)), hn::Set(di, grid.Size[i] - 1));
      };
      const Float depth = hn::GatherIndex(d, grid.Depths, index(0) + index(1) * stride);
      const Float h =
        hn::MulAdd(depth, SetFloat(this->Grids.HeightAtOne - this->Grids.HeightAtZero),
          SetFloat(this->Grids.HeightAtZero));
      const Float t = hn::MulAdd(middle, SetFloat(this->Width), SetFloat(this->Start));
      const Float quotient = hn::Ceil((h * q0 - t * p0) / (t * p1 - h * q1));
      Float row = hn::Max(zero, hn::Min(quotient, rows - one));
      row = hn::IfThenElse(hn::Le(t * p0, h * q0), zero, row); // before the first row
      const auto never =
        hn::Or(hn::Or(hn::Gt(t * lastP, h * lastQ), hn::Le(t, zero)), hn::Ge(depth, one));
      row = hn::IfThenElse(never, rows, row);
      // A quotient that is not a number is of a column at the very edge of both conditions.
      row = hn::IfThenElse(hn::Eq(row, row), row, rows);
      hn::StoreU(hn::ConvertTo(di, row), di, this->Memory.Flip.data() + j);
    }
  }

  void MeasureRows(double extinction)
  {
    const FloatTag d;
    const double perStep = 1.0 / std::log(ShadowLadder::Ratio);
    for (int k = 0; k < this->Rows; k += GetLanes())
    {
      const Float n = hn::Iota(d, static_cast<float>(k));
      const Float q = hn::Max(
        hn::MulAdd(SetFloat(this->Across[1]), n, SetFloat(this->Across[0])), SetFloat(1e-9));
      const Float square =
        hn::MulAdd(n, hn::MulAdd(n, SetFloat(this->Square[2]), SetFloat(this->Square[1])),
          SetFloat(this->Square[0]));
      const Float perColumn = SetFloat(extinction * this->Width) * hn::Sqrt(square) / q;
      const Float step =
        hn::Log(d, perColumn * SetFloat(1.0 / this->Ladder.First)) * SetFloat(perStep);
      const Float before = hn::Exp(d,
        hn::Max(hn::Min(perColumn * SetFloat(-this->Start / this->Width), SetFloat(60.0)),
          SetFloat(-80.0)));
      hn::StoreU(q * SetFloat(1.0 / this->Width), d, this->Memory.Perpendicular.data() + k);
      hn::StoreU(perColumn, d, this->Memory.Extinction.data() + k);
      hn::StoreU(hn::Min(hn::Max(step, hn::Zero(d)), SetFloat(this->Ladder.Steps - 1.001)), d,
        this->Memory.Step.data() + k);
      hn::StoreU(before, d, this->Memory.Before.data() + k);
    }
  }

  // Where pixels' rays end.
  void MeasurePixels()
  {
    const FloatTag d;
    const IntTag di;
    constexpr int shift = 23 - ShadowLadder::Mantissa;
    const Float each = SetFloat(ShadowLadder::Each);
    const Float fine = SetFloat(1 << ShadowLadder::Octaves);
    const Float one = SetFloat(1.0);
    const auto zero = hn::Zero(di);
    for (int i = 0; i < this->Pixels; i += GetLanes())
    {
      const int valid = std::min(this->Pixels - i, GetLanes());
      const auto inside = hn::RebindMask(di, hn::FirstN(d, valid));
      const auto row = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Row.data() + i));
      const auto offset = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Offset.data() + i));
      const Float depth =
        hn::Min(hn::GatherIndex(d, this->Picture.Ends, offset), SetFloat(this->Settings.FarLimit));
      const Float end =
        hn::MulAdd(depth, hn::GatherIndex(d, this->Memory.Perpendicular.data(), row),
          SetFloat(-this->Start / this->Width));
      const Float at = hn::Min(hn::Max(end, hn::Zero(d)), SetFloat(1e6));
      // The column is told by exponent and first bits of the mantissa.
      const Float y = hn::Min(at, each) * fine;
      const auto bits = hn::ShiftRight<shift>(hn::BitCast(di, y));
      const auto code = hn::Max(bits -
          hn::Set(di, (127 + ShadowLadder::Mantissa) * ShadowLadder::Each - ShadowLadder::Each),
        hn::Set(di, ShadowLadder::Each));
      const auto octave = hn::ShiftRight<ShadowLadder::Mantissa>(code) - hn::Set(di, 1);
      const auto isLower = hn::Lt(y, each);
      const auto isUpper = hn::Ge(at, each);
      // widths of the column, and columns for each unit, which are powers of 2
      Float width =
        hn::BitCast(d, hn::ShiftLeft<23>(octave + hn::Set(di, 127 - ShadowLadder::Octaves)));
      width = hn::IfThenElse(isLower, one / fine, width);
      width = hn::IfThenElse(isUpper, one, width);
      const Float x = at / width;
      const Float whole = hn::Floor(x);
      auto first = hn::ShiftLeft<ShadowLadder::Mantissa>(octave);
      first = hn::IfThenElse(hn::RebindMask(di, isLower), zero, first);
      first = hn::IfThenElse(hn::RebindMask(di, isUpper),
        hn::Set(di, ShadowLadder::Each * ShadowLadder::Octaves), first);
      // (1 - e^-ab)/(1 - e^-a), b of a column that is a thick
      const Float b = x - whole;
      const Float thick = hn::GatherIndex(d, this->Memory.Extinction.data(), row) * width;
      const Float part = Absorbed(d, thick * b) / Absorbed(d, hn::Max(thick, SetFloat(1e-20)));
      hn::StoreU(hn::ConvertTo(d, first) + whole + hn::Min(part, SetFloat(0.9999)), d,
        this->Memory.Last.data() + i);
    }
  }

  // Row by row in the direction of light, in stretches of pixels between the same steps of the ladder.
  void Hide(float* hidden)
  {
    const int* rows = this->Memory.Row.data();
    const float* steps = this->Memory.Step.data();
    const int* next = this->Memory.Next.data();
    this->Sums.Clear(this->Columns);
    int row = 0; // columns that turn dark before it are marked
    for (int i = 0; i < this->Pixels;)
    {
      const int step = std::min(static_cast<int>(steps[rows[i]]), this->Ladder.Steps - 2);
      const float low = step - 0.2f;
      const float high = step + 1.2f;
      int end = i;
      float most = 0.0f;
      for (; end < this->Pixels && steps[rows[end]] >= low && steps[rows[end]] <= high; ++end)
      {
        most = std::max(most, this->Memory.Last[end]);
      }
      const int needed = static_cast<int>(std::min(this->Columns + 0.0f, most + 1.0f));
      for (; row < rows[i]; ++row)
      {
        for (int j = this->Memory.Head[row]; j >= 0; j = next[j])
        {
          this->Sums.Mark(j);
        }
      }
      this->Sums.Build(step, needed);
      for (; i < end; ++i)
      {
        for (; row <= rows[i]; ++row)
        {
          for (int j = this->Memory.Head[row]; j >= 0; j = next[j])
          {
            this->Sums.Mark(j);
            if (j < needed)
            {
              this->Sums.Add(j);
            }
          }
        }
        const float place = std::min(this->Memory.Last[i], static_cast<float>(needed));
        hidden[this->Memory.Offset[i]] =
          this->Sums.Read(place, steps[rows[i]] - step) * this->Memory.Before[rows[i]];
      }
    }
  }

  const CoverageSettings& Settings;
  const CoverageImage& Image;
  const CoverageWedge& Wedge;
  const vtkGodRaysShadowGrids& Grids;
  const ShadowLadder& Ladder;
  const ShadowPicture& Picture;
  ShadowLines& Memory;
  DarkSums Sums;
  const Vec3 Light;
  // Of the line:
  Straight Center = {};
  int FirstRow = 0;
  int Rows = 0;
  int Pixels = 0;
  double Along[2] = {};     // P of the first row, and its change from row to row
  double Across[2] = {};    // Q
  double Square[3] = {};    // of D's length, a polynomial of the row
  double Direction[2] = {}; // of t along the map's axes
  double Width = 0.0;       // of a whole column [scene units]
  double Start = 0.0;       // t from which columns are counted
  int FirstColumn = 0;
  int Columns = 0; // one beyond the map's last
};

//------------------------------------------------------------------------------
void RunShadowBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, const vtkGodRaysShadowGrids& grids,
  const ShadowLadder& ladder, const ShadowPicture& picture, ShadowLines& lines)
{
  ShadowSweep sweep(settings, image, wedge, grids, ladder, picture, lines);
  const int end = std::min(wedge.Lines, (band + 1) * CoverageBandLines);
  for (int line = band * CoverageBandLines; line < end; ++line)
  {
    sweep.Sweep(line);
  }
}
}
}
HWY_AFTER_NAMESPACE();
#if HWY_ONCE
namespace vtkGodRays
{
HWY_EXPORT(RunShadowBand);

//------------------------------------------------------------------------------
double GetShadowColumn(int column)
{
  constexpr int each = ShadowLadder::Each;
  if (column >= ShadowLadder::FirstWhole)
  {
    return each + column - static_cast<double>(ShadowLadder::FirstWhole);
  }
  const double least = std::ldexp(1.0, -ShadowLadder::Octaves);
  return column < each ? column * least
                       : std::ldexp(least, column / each - 1) * (each + column % each);
}

//------------------------------------------------------------------------------
void MakeShadowLadder(
  const vtkGodRaysShadowGrids& grids, double low, double high, ShadowLadder& ladder)
{
  const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[0];
  const double least = std::min(grid.Texel[0], grid.Texel[1]);
  const double most = std::max(grid.Texel[0], grid.Texel[1]) * std::sqrt(2.0);
  // From rays at right angles to the light to where all is in the finest column. Both ends are rounded, so
  // that the ladder serves while a camera moves and texels change with it.
  constexpr int rounded = 16;
  const double perStep = 1.0 / std::log(ShadowLadder::Ratio);
  const double begin = std::floor(std::log(low * least) * perStep / rounded) * rounded;
  const double end = std::ceil(std::log(3000.0 * high * most) * perStep / rounded + 1.0) * rounded;
  const int steps = static_cast<int>(std::min(end - begin, 512.0));
  const double first = std::pow(ShadowLadder::Ratio, begin);
  const int wanted = grid.Size[0] + grid.Size[1] + ShadowLadder::FirstWhole + 128;
  const int columns = (wanted + 63) / 64 * 64;
  if (columns == ladder.Columns && steps == ladder.Steps && first == ladder.First)
  {
    return;
  }
  ladder.Columns = columns;
  ladder.Steps = steps;
  ladder.First = first;
  ladder.Middles.resize(columns + 64);
  for (int j = 0; j < columns + 64; ++j)
  {
    ladder.Middles[j] = static_cast<float>(0.5 * (GetShadowColumn(j) + GetShadowColumn(j + 1)));
  }
  ladder.Weights.assign(static_cast<std::size_t>(steps) * columns, 0.0f);
  for (int step = 0; step < steps; ++step)
  {
    const double x = first * std::pow(ShadowLadder::Ratio, step);
    float* weights = ladder.Weights.data() + static_cast<std::size_t>(step) * columns;
    for (int j = 0; j < columns; ++j)
    {
      const double start = GetShadowColumn(j);
      const double left = std::exp(-x * start);
      if (left < 1e-12)
      {
        break;
      }
      weights[j] = static_cast<float>(left * -std::expm1(-x * (GetShadowColumn(j + 1) - start)));
    }
  }
}

//------------------------------------------------------------------------------
void DeleteShadowLines::operator()(ShadowLines* lines) const
{
  delete lines;
}

//------------------------------------------------------------------------------
ShadowLinesPointer MakeShadowLines()
{
  return ShadowLinesPointer(new ShadowLines);
}

//------------------------------------------------------------------------------
void SweepShadowBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, const vtkGodRaysShadowGrids& grids,
  const ShadowLadder& ladder, const ShadowPicture& picture, ShadowLines& lines)
{
  HWY_DYNAMIC_DISPATCH(RunShadowBand)
  (settings, image, wedge, band, grids, ladder, picture, lines);
}
}
#endif
