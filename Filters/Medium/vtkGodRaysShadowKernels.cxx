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
#include "vtkGodRaysShadowDark-inl.h"
#include "vtkGodRaysShadowKernels.h"
#include "vtkGodRaysShadowLines.h"

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
//------------------------------------------------------------------------------
class ShadowSweep
{
public:
  ShadowSweep(const CoverageSettings& settings, const CoverageImage& image,
    const CoverageWedge& wedge, const vtkGodRaysShadowGrids& grids, const ShadowTables& tables,
    const ShadowPicture& picture, ShadowLines& memory)
    : Settings(settings)
    , Image(image)
    , Wedge(wedge)
    , Grids(grids)
    , Ladder(tables.Ladder)
    , Fan(tables.Fan)
    , Picture(picture)
    , Memory(memory)
    , Sums(memory, tables.Ladder)
    , Runs(memory)
    , Seen(memory)
    , Distance(length(Vec3(settings.Light[0], settings.Light[1], settings.Light[2])))
    , Light(Vec3(settings.Light[0], settings.Light[1], settings.Light[2]) / this->Distance)
  {
    memory.Reserve(wedge.Rows, grids.Point ? this->Fan.Columns : this->Ladder.Columns);
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
    if (this->Settings.Table->Kind != CoverageTable::NONE)
    {
      this->HideRuns();
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
    const double x = wedge.FirstLine + index * wedge.Spacing;
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
        this->Memory.Column[n + i] = begin + i;
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

  // The line's plane, and the columns of the map in it; false if there are none.
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
    return this->Grids.Point ? this->FindWedges(across) : this->FindStrips(across);
  }

  // Of a point light: wedges in the map, and not beyond where the first ray goes.
  bool FindWedges(const Vec3& across)
  {
    const double pi = std::acos(-1.0);
    double low = std::max(0.0, std::atan2(this->Across[0], this->Along[0]));
    double high = pi;
    for (int face = 0; face < this->Grids.Levels; ++face)
    {
      const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
      for (int i = 0; i < 3; ++i)
      {
        const Vec3 axis(grid.Axes[i][0], grid.Axes[i][1], grid.Axes[i][2]);
        this->Faces[face][i][0] = dot(axis, this->Light);
        this->Faces[face][i][1] = dot(axis, across);
      }
    }
    if (this->Grids.Levels == 1) // within a cone about the third axis
    {
      const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[0];
      double square = 1.0;
      for (int i = 0; i < 2; ++i)
      {
        const double end = grid.Low[i] + grid.Size[i] * grid.Texel[i];
        square += std::pow(std::max(std::abs(grid.Low[i]), std::abs(end)), 2);
      }
      const double* axis = this->Faces[0][2];
      const double cosine =
        1.0 / (std::sqrt(square) * std::max(std::hypot(axis[0], axis[1]), 1e-12));
      if (cosine >= 1.0)
      {
        return false;
      }
      const double half = std::acos(cosine);
      const double middle = std::atan2(axis[1], axis[0]);
      const double turns = middle + half < 0.0 ? 2.0 * pi : 0.0;
      low = std::max(low, middle - half + turns);
      high = std::min(high, middle + half + turns);
    }
    this->FirstColumn = static_cast<int>(std::max((pi - high) / this->Fan.Angle, 0.0));
    this->Columns =
      static_cast<int>(std::min(std::ceil((pi - low) / this->Fan.Angle), this->Fan.Columns + 0.0));
    return this->FirstColumn < this->Columns;
  }

  bool FindStrips(const Vec3& across)
  {
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
    if (this->Grids.Point)
    {
      this->FindFlipsOfWedges();
    }
    int end = this->Grids.Point ? 0 : this->Columns;
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
    Float gain[2];
    Float offset[2];
    for (int i = 0; i < 2; ++i)
    {
      const double perLength = this->Direction[i] / grid.Texel[i];
      gain[i] = SetFloat(perLength * this->Width);
      offset[i] = SetFloat(perLength * this->Start - grid.Low[i] / grid.Texel[i]);
    }
    const auto stride = hn::Set(di, static_cast<int>(grid.Stride));
    for (int j = begin; j < end; j += GetLanes())
    {
      const Float middle = hn::LoadU(d, this->Ladder.Middles.data() + j);
      const auto index = [&](int i) HWY_ATTR
      { return GetTexel(grid, i, hn::MulAdd(gain[i], middle, offset[i])); };
      const Float depth = hn::GatherIndex(d, grid.Depths, index(0) + index(1) * stride);
      const Float h =
        hn::MulAdd(depth, SetFloat(this->Grids.HeightAtOne - this->Grids.HeightAtZero),
          SetFloat(this->Grids.HeightAtZero));
      const Float t = hn::MulAdd(middle, SetFloat(this->Width), SetFloat(this->Start));
      this->StoreFlips(j, h, t, hn::Ge(depth, SetFloat(1.0)));
    }
  }

  // Of a point light the occluder in a column is at (d + r cos, r sin), at the distance r from the light.
  void FindFlipsOfWedges()
  {
    const FloatTag d;
    const IntTag di;
    const Float zero = hn::Zero(d);
    const Float one = SetFloat(1.0);
    const double nearnessAtZero = this->Grids.GetNearness(0.0);
    for (int j = this->FirstColumn; j < this->Columns; j += GetLanes())
    {
      const Float cosine = hn::LoadU(d, this->Fan.MiddleCosines.data() + j);
      const Float sine = hn::LoadU(d, this->Fan.MiddleSines.data() + j);
      Float nearness = hn::Set(d, -1.0f); // 1/r
      for (int face = 0; face < this->Grids.Levels; ++face)
      {
        const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
        const auto along = [&](int i) HWY_ATTR
        {
          return hn::MulAdd(
            cosine, SetFloat(this->Faces[face][i][0]), sine * SetFloat(this->Faces[face][i][1]));
        };
        const Float ahead = along(2);
        const auto place = [&](int i) HWY_ATTR
        {
          return (along(i) / hn::Max(ahead, SetFloat(1e-6)) - SetFloat(grid.Low[i])) *
            SetFloat(1.0 / grid.Texel[i]);
        };
        const Float x = place(0);
        const Float y = place(1);
        const auto inside = hn::And(hn::And(hn::Gt(ahead, zero), hn::Lt(nearness, zero)),
          hn::And(hn::And(hn::Ge(x, SetFloat(-0.01)), hn::Le(x, SetFloat(grid.Size[0] + 0.01))),
            hn::And(hn::Ge(y, SetFloat(-0.01)), hn::Le(y, SetFloat(grid.Size[1] + 0.01)))));
        if (hn::AllFalse(d, inside))
        {
          continue;
        }
        const auto texel =
          GetTexel(grid, 0, x) + GetTexel(grid, 1, y) * hn::Set(di, static_cast<int>(grid.Stride));
        const Float depth =
          hn::GatherIndex(d, grid.Depths, hn::IfThenElseZero(hn::RebindMask(di, inside), texel));
        const Float nearnessAlong = hn::MulAdd(
          depth, SetFloat(this->Grids.GetNearness(1.0) - nearnessAtZero), SetFloat(nearnessAtZero));
        const auto blocks = hn::And(inside, hn::Lt(depth, one));
        nearness = hn::IfThenElse(blocks, nearnessAlong * ahead, nearness);
      }
      // times 1/r
      const Float h = hn::MulAdd(nearness, SetFloat(this->Distance), cosine);
      this->StoreFlips(j, h, sine, hn::Lt(nearness, zero));
    }
  }

  static HWY_INLINE hn::Vec<IntTag> GetTexel(
    const vtkGodRaysShadowGrids::Grid& grid, int axis, Float place)
  {
    const IntTag di;
    return hn::Min(
      hn::Max(hn::ConvertTo(di, place), hn::Zero(di)), hn::Set(di, grid.Size[axis] - 1));
  }

  // The rows in which columns turn dark whose occluders are at (h, t), or that have none.
  HWY_INLINE void StoreFlips(int column, Float h, Float t, hn::Mask<FloatTag> empty)
  {
    const FloatTag d;
    const IntTag di;
    const Float zero = hn::Zero(d);
    const Float p0 = SetFloat(this->Along[0]);
    const Float p1 = SetFloat(this->Along[1]);
    const Float q0 = SetFloat(this->Across[0]);
    const Float q1 = SetFloat(this->Across[1]);
    const Float rows = SetFloat(this->Rows);
    const Float lastP = SetFloat(this->Along[0] + this->Along[1] * (this->Rows - 1));
    const Float lastQ = SetFloat(this->Across[0] + this->Across[1] * (this->Rows - 1));
    const Float quotient = hn::Ceil((h * q0 - t * p0) / (t * p1 - h * q1));
    Float row = hn::Max(zero, hn::Min(quotient, rows - SetFloat(1.0)));
    row = hn::IfThenElse(hn::Le(t * p0, h * q0), zero, row); // before the first row
    const auto never = hn::Or(hn::Or(hn::Gt(t * lastP, h * lastQ), hn::Le(t, zero)), empty);
    row = hn::IfThenElse(never, rows, row);
    // A quotient that is not a number is of a column at the very edge of both conditions.
    row = hn::IfThenElse(hn::Eq(row, row), row, rows);
    hn::StoreU(hn::ConvertTo(di, row), di, this->Memory.Flip.data() + column);
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
    const Float lastColumn = SetFloat(GetShadowColumn(this->Columns));
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
      this->StoreExcess(
        i, hn::Min(at, lastColumn), hn::GatherIndex(d, this->Memory.Extinction.data(), row));
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

  // Of what all columns up to a width hide, f(u) = 1 - e^-u with u = x width, the part that is too much in
  // the middle between two steps, over 1/4: linear in ln x, it is L^2 (u f' + u^2 f'')/2 for steps of L.
  HWY_INLINE void StoreExcess(int pixel, Float width, Float extinction)
  {
    const FloatTag d;
    const Float one = SetFloat(1.0);
    const double step = std::log(ShadowLadder::Ratio);
    const auto bend = [&](Float u, Float absorbed) HWY_ATTR
    { return u * (one - u) * (one - absorbed); };
    const Float u = width * extinction;
    Float hidden = Absorbed(d, u);
    Float excess = bend(u, hidden);
    if (this->FirstColumn > 0)
    {
      const Float first = SetFloat(ShadowLadder::Each) * extinction;
      const Float before = Absorbed(d, first);
      excess = excess - bend(first, before);
      hidden = hidden - before;
    }
    const Float part = SetFloat(0.5 * step * step) * excess / hn::Max(hidden, SetFloat(1e-12));
    hn::StoreU(hn::Max(hn::Min(part, SetFloat(0.02)), SetFloat(-0.02)), d,
      this->Memory.Excess.data() + pixel);
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
        const float part = steps[rows[i]] - step;
        hidden[this->Memory.Offset[i]] = this->Sums.Read(place, part) *
          this->Memory.Before[rows[i]] * (1.0f - part * (1.0f - part) * this->Memory.Excess[i]);
      }
    }
  }

  // From a table: what is between the ends of the runs of dark columns.
  void HideRuns()
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    const int* rows = this->Memory.Row.data();
    const ColumnEdges edges = this->GetEdges();
    const auto number = [&](double first, double change, Float row) HWY_ATTR
    { return hn::MulAdd(row, SetFloat(change), SetFloat(first)); };
    this->Runs.Clear(this->Columns);
    int row = 0;
    for (int i = 0; i < this->Pixels; i += lanes)
    {
      const int count = std::min(this->Pixels - i, lanes);
      this->Seen.Clear();
      for (int pixel = 0; pixel < count; ++pixel)
      {
        for (; row <= rows[i + pixel]; ++row)
        {
          for (int j = this->Memory.Head[row]; j >= 0; j = this->Memory.Next[j])
          {
            this->Runs.Mark(j);
          }
        }
        this->Seen.Add(pixel);
      }
      const auto inside = hn::RebindMask(di, hn::FirstN(d, count));
      const auto here = hn::IfThenElseZero(inside, hn::LoadU(di, rows + i));
      const auto column = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Column.data() + i));
      const auto offset = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Offset.data() + i));
      const Float k = hn::ConvertTo(d, here);
      const Float x = (hn::ConvertTo(d, column) - SetFloat(this->Image.Center[0])) *
        SetFloat(this->Settings.PixelSize);
      const double first =
        this->Wedge.First + this->FirstRow * static_cast<double>(this->Wedge.Direction);
      const Float y = number((first - this->Image.Center[1]) * this->Settings.PixelSize,
        this->Wedge.Direction * this->Settings.PixelSize, k);
      const Float last =
        hn::Min(hn::GatherIndex(d, this->Picture.Ends, offset), SetFloat(this->Settings.FarLimit));
      const Float begin = this->Picture.Begins
        ? hn::Min(hn::GatherIndex(d, this->Picture.Begins, offset), last)
        : hn::Zero(d);
      this->Seen.Measure(this->Settings, edges, FindRays(this->Settings, x, y),
        number(this->Along[0], this->Along[1], k), number(this->Across[0], this->Across[1], k),
        begin, last);
      HWY_ALIGN float sums[8];
      for (int plane = 0; plane < this->Settings.Planes; ++plane)
      {
        this->Seen.Sum(plane, count, sums);
        for (int pixel = 0; pixel < count; ++pixel)
        {
          this->Picture.Hidden[plane][this->Memory.Offset[i + pixel]] = sums[pixel];
        }
      }
    }
  }

  ColumnEdges GetEdges()
  {
    if (this->Grids.Point)
    {
      return { this->Fan.EdgeSines.data(), this->Fan.EdgeMinusCosines.data(),
        static_cast<float>(this->Distance), 1.0f };
    }
    const FloatTag d;
    for (int j = this->FirstColumn; j <= this->Columns; j += GetLanes())
    {
      hn::StoreU(hn::MulAdd(hn::LoadU(d, this->Ladder.Edges.data() + j), SetFloat(this->Width),
                   SetFloat(this->Start)),
        d, this->Memory.EdgePlaces.data() + j);
    }
    return { this->Memory.EdgePlaces.data(), this->Memory.Ones.data(), 1.0f, 0.0f };
  }

  const CoverageSettings& Settings;
  const CoverageImage& Image;
  const CoverageWedge& Wedge;
  const vtkGodRaysShadowGrids& Grids;
  const ShadowLadder& Ladder;
  const ShadowFan& Fan;
  const ShadowPicture& Picture;
  ShadowLines& Memory;
  DarkSums Sums;
  DarkRuns Runs;
  SeenRuns Seen;
  const double Distance; // of a point light, else 1
  const Vec3 Light;      // the direction to it
  // Of the line:
  Straight Center = {};
  int FirstRow = 0;
  int Rows = 0;
  int Pixels = 0;
  double Along[2] = {};     // P of the first row, and its change from row to row
  double Across[2] = {};    // Q
  double Square[3] = {};    // of D's length, a polynomial of the row
  double Direction[2] = {}; // of t along the map's axes
  double Faces[vtkGodRaysShadowGrids::MaximumGrids][3]
              [2] = {}; // of e and v along a point light's axes
  double Width = 0.0;   // of a whole column [scene units]
  double Start = 0.0;   // t from which columns are counted
  int FirstColumn = 0;
  int Columns = 0; // one beyond the map's last
};

//------------------------------------------------------------------------------
void RunShadowBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, const vtkGodRaysShadowGrids& grids,
  const ShadowTables& tables, const ShadowPicture& picture, ShadowLines& lines)
{
  ShadowSweep sweep(settings, image, wedge, grids, tables, picture, lines);
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
  const ShadowTables& tables, const ShadowPicture& picture, ShadowLines& lines)
{
  HWY_DYNAMIC_DISPATCH(RunShadowBand)
  (settings, image, wedge, band, grids, tables, picture, lines);
}
}
#endif
