// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysShadowKernels.cxx"
#include "vtkGodRaysVectorSets.h"

#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysCoverageRays-inl.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysShadowDark-inl.h"
#include "vtkGodRaysShadowKernels.h"
#include "vtkGodRaysShadowLine-inl.h"
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
class ShadowSweep : private ShadowLine
{
public:
  ShadowSweep(const CoverageSettings& settings, const CoverageImage& image,
    const CoverageWedge& wedge, const vtkGodRaysShadowGrids& grids, const ShadowTables& tables,
    const ShadowPicture& picture, ShadowLines& memory)
    : ShadowLine(settings, image, wedge, grids, tables, picture, memory)
    , Sums(memory, tables.Ladder)
    , Runs(memory)
    , Shades(memory)
    , Seen(memory, CountUnsureColumns(wedge, grids, tables.Fan.Angle))
  {
  }

  void Sweep(int line)
  {
    if (!this->FindPixels(line) || !this->FindColumns() || !this->FindFlips())
    {
      return;
    }
    this->ReadDepths();
    const bool inParts = this->Grids.NumberOfLayers > 0;
    if (this->Settings.Table->Kind != CoverageTable::NONE || this->Settings.Parallel)
    {
      inParts ? this->HideRuns<true>() : this->HideRuns<false>();
      return;
    }
    this->FindLengths();
    this->FindEnds();
    for (int c = 0; c < this->Settings.Channels; ++c)
    {
      this->MeasureRows(this->Settings.Extinction[c]);
      this->MeasurePixels();
      inParts ? this->Hide<true>(c) : this->Hide<false>(c);
    }
  }

private:
  using Layer = vtkGodRaysShadowGrids::Layer;

  // The row in which each column turns dark; false if none does.
  bool FindFlips()
  {
    std::fill_n(this->Memory.Head.begin(), this->Rows, -1);
    if (this->Grids.NumberOfLayers == 0)
    {
      return this->FindFlips(nullptr, 0) > 0;
    }
    int flips = 0;
    for (int k = 0; k < this->Grids.NumberOfLayers; ++k)
    {
      flips += this->FindFlips(this->Grids.Layers + k, k * this->Memory.Room);
    }
    return flips > 0;
  }

  // Of a layer, or, if there is none, of the grids; from a place in Flip on. How many columns do.
  int FindFlips(const Layer* layer, int place)
  {
    if (this->Grids.Point)
    {
      this->FindFlipsOfWedges(layer, place);
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
      this->FindFlips(this->Grids.Grids[level], layer, place, begin, end);
      end = begin;
    }
    int flips = 0;
    for (int j = this->FirstColumn; j < this->Columns; ++j)
    {
      const int row = this->Memory.Flip[place + j];
      if (row < this->Rows)
      {
        this->Memory.Next[place + j] = this->Memory.Head[row];
        this->Memory.Head[row] = place + j;
        ++flips;
      }
    }
    return flips;
  }

  void FindFlips(
    const vtkGodRaysShadowGrids::Grid& grid, const Layer* layer, int place, int begin, int end)
  {
    const float* depths = layer ? layer->Depths + grid.First : grid.Depths;
    const FloatTag d;
    const IntTag di;
    Float gain[2];
    Float offset[2];
    for (int i = 0; i < 2; ++i)
    {
      const double perLength = this->Direction[i] / grid.Texel[i];
      gain[i] = SetFloat(perLength * this->Width);
      offset[i] =
        SetFloat(perLength * this->Start + (this->Offset[i] - grid.Low[i]) / grid.Texel[i]);
    }
    const double heightAtZero = this->Grids.GetHeight(0.0);
    const auto stride = hn::Set(di, static_cast<int>(grid.Stride));
    for (int j = begin; j < end; j += GetLanes())
    {
      const Float middle = hn::LoadU(d, this->Ladder.Middles.data() + j);
      const auto index = [&](int i) HWY_ATTR
      { return GetTexel(grid, i, hn::MulAdd(gain[i], middle, offset[i])); };
      const auto texel = index(0) + index(1) * stride;
      const Float depth = hn::GatherIndex(d, depths, texel);
      for (int c = 0; layer && c < this->Settings.Channels; ++c)
      {
        hn::StoreU(hn::GatherIndex(d, layer->Dark[c] + grid.First, texel), d,
          this->Memory.Part[c].data() + place + j);
      }
      const Float h = hn::MulAdd(
        depth, SetFloat(this->Grids.GetHeight(1.0) - heightAtZero), SetFloat(heightAtZero));
      const Float t = hn::MulAdd(middle, SetFloat(this->Width), SetFloat(this->Start));
      const auto empty = hn::Ge(depth, SetFloat(1.0));
      if (this->Settings.Parallel)
      {
        // At t the ray (P, Q) from (Along, Across) has h = Along + (t - Across) P/Q.
        const double p = this->Axis.z;
        const double q = this->Meeting[3][0];
        const Float excess = hn::MulAdd(t, SetFloat(p),
          hn::NegMulAdd(h, SetFloat(q), SetFloat(q * this->Along[0] - p * this->Across[0])));
        this->StoreFlips(
          place + j, excess, SetFloat(q * this->Along[1] - p * this->Across[1]), empty);
        continue;
      }
      this->StoreFlips(place + j, this->GetExcess(0, h, t), this->GetExcess(1, h, t), empty);
    }
  }

  // Of a point light the occluder in a column is at (d + r cos, r sin), at the distance r from the light.
  void FindFlipsOfWedges(const Layer* layer, int place)
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
      Float parts[3] = { zero, zero, zero };
      for (int face = 0; face < this->Grids.Levels; ++face)
      {
        const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
        const auto along = [&](int i) HWY_ATTR
        {
          return hn::MulAdd(
            cosine, SetFloat(this->Faces[face][i][0]), sine * SetFloat(this->Faces[face][i][1]));
        };
        const Float ahead = along(2);
        const auto placeAlong = [&](int i) HWY_ATTR
        {
          return (along(i) / hn::Max(ahead, SetFloat(1e-6)) - SetFloat(grid.Low[i])) *
            SetFloat(1.0 / grid.Texel[i]);
        };
        const Float x = placeAlong(0);
        const Float y = placeAlong(1);
        const auto inside = hn::And(hn::And(hn::Gt(ahead, zero), hn::Lt(nearness, zero)),
          hn::And(hn::And(hn::Ge(x, SetFloat(-0.01)), hn::Le(x, SetFloat(grid.Size[0] + 0.01))),
            hn::And(hn::Ge(y, SetFloat(-0.01)), hn::Le(y, SetFloat(grid.Size[1] + 0.01)))));
        if (hn::AllFalse(d, inside))
        {
          continue;
        }
        const auto texel =
          GetTexel(grid, 0, x) + GetTexel(grid, 1, y) * hn::Set(di, static_cast<int>(grid.Stride));
        const auto insideTexel = hn::IfThenElseZero(hn::RebindMask(di, inside), texel);
        const Float depth =
          hn::GatherIndex(d, layer ? layer->Depths + grid.First : grid.Depths, insideTexel);
        const Float nearnessAlong = hn::MulAdd(
          depth, SetFloat(this->Grids.GetNearness(1.0) - nearnessAtZero), SetFloat(nearnessAtZero));
        const auto blocks = hn::And(inside, hn::Lt(depth, one));
        nearness = hn::IfThenElse(blocks, nearnessAlong * ahead, nearness);
        for (int c = 0; layer && c < this->Settings.Channels; ++c)
        {
          parts[c] = hn::IfThenElse(
            blocks, hn::GatherIndex(d, layer->Dark[c] + grid.First, insideTexel), parts[c]);
        }
      }
      for (int c = 0; layer && c < this->Settings.Channels; ++c)
      {
        hn::StoreU(parts[c], d, this->Memory.Part[c].data() + place + j);
      }
      const auto empty = hn::Lt(nearness, zero);
      if (this->Settings.Parallel)
      {
        this->StoreFlips(place + j, hn::NegMulAdd(nearness, SetFloat(this->Across[0]), sine),
          nearness * SetFloat(-this->Across[1]), empty);
        continue;
      }
      const Float h = hn::MulAdd(nearness, SetFloat(this->Distance), cosine); // times 1/r
      this->StoreFlips(place + j, this->GetExcess(0, h, sine), this->GetExcess(1, h, sine), empty);
    }
  }

  static HWY_INLINE hn::Vec<IntTag> GetTexel(
    const vtkGodRaysShadowGrids::Grid& grid, int axis, Float place)
  {
    const IntTag di;
    return hn::Min(
      hn::Max(hn::ConvertTo(di, place), hn::Zero(di)), hn::Set(di, grid.Size[axis] - 1));
  }

  // t P - h Q of the first row's ray, or its change from row to row.
  HWY_INLINE Float GetExcess(int i, Float h, Float t) const
  {
    return t * SetFloat(this->Along[i]) - h * SetFloat(this->Across[i]);
  }

  // The rows k from which columns are dark, where excess + change k <= 0; none of what is empty.
  HWY_INLINE void StoreFlips(int place, Float excess, Float change, hn::Mask<FloatTag> empty)
  {
    const FloatTag d;
    const IntTag di;
    const Float zero = hn::Zero(d);
    const Float rows = SetFloat(this->Rows);
    const Float last = rows - SetFloat(1.0);
    const Float quotient = hn::Ceil(hn::Neg(excess) / change);
    Float row = hn::Max(zero, hn::Min(quotient, last));
    row = hn::IfThenElse(hn::Le(excess, zero), zero, row); // before the first row
    const auto never = hn::Or(hn::Gt(hn::MulAdd(change, last, excess), zero), empty);
    row = hn::IfThenElse(never, rows, row);
    // A quotient that is not a number is of a column at the very edge of both conditions.
    row = hn::IfThenElse(hn::Eq(row, row), row, rows);
    hn::StoreU(hn::ConvertTo(di, row), di, this->Memory.Flip.data() + place);
  }

  // How long rays are in a column.
  void FindLengths()
  {
    const FloatTag d;
    for (int k = 0; k < this->Rows; k += GetLanes())
    {
      const Float n = CountFrom(d, static_cast<float>(k));
      const Float q = hn::Max(
        hn::MulAdd(SetFloat(this->Across[1]), n, SetFloat(this->Across[0])), SetFloat(1e-9));
      const Float square =
        hn::MulAdd(n, hn::MulAdd(n, SetFloat(this->Square[2]), SetFloat(this->Square[1])),
          SetFloat(this->Square[0]));
      const Float length = SetFloat(this->Width) * hn::Sqrt(square) / q;
      hn::StoreU(q * SetFloat(1.0 / this->Width), d, this->Memory.Perpendicular.data() + k);
      hn::StoreU(length, d, this->Memory.Length.data() + k);
      hn::StoreU(hn::Log(d, length), d, this->Memory.LogLength.data() + k);
    }
  }

  void MeasureRows(double extinction)
  {
    const FloatTag d;
    const double perStep = 1.0 / std::log(ShadowLadder::Ratio);
    const Float firstStep = SetFloat(std::log(extinction / this->Ladder.First) * perStep);
    for (int k = 0; k < this->Rows; k += GetLanes())
    {
      const Float perColumn = hn::LoadU(d, this->Memory.Length.data() + k) * SetFloat(extinction);
      const Float step =
        hn::MulAdd(hn::LoadU(d, this->Memory.LogLength.data() + k), SetFloat(perStep), firstStep);
      const Float before = this->Start == 0.0
        ? SetFloat(1.0)
        : hn::Exp(d,
            hn::Max(hn::Min(perColumn * SetFloat(-this->Start / this->Width), SetFloat(60.0)),
              SetFloat(-80.0)));
      hn::StoreU(perColumn, d, this->Memory.Extinction.data() + k);
      hn::StoreU(hn::Min(hn::Max(step, hn::Zero(d)), SetFloat(this->Ladder.Steps - 1.001)), d,
        this->Memory.Step.data() + k);
      hn::StoreU(before, d, this->Memory.Before.data() + k);
    }
  }

  // Of the ends of pixels' rays. The pixels lie far apart, and reads that nothing else waits between overlap.
  void ReadDepths()
  {
    const float* ends = this->Picture.Ends;
    const int* offsets = this->Memory.Offset.data();
    float* depths = this->Memory.Depth.data();
    for (int i = 0; i < this->Pixels; ++i)
    {
      depths[i] = ends[offsets[i]];
    }
  }

  // Where pixels' rays end.
  void FindEnds()
  {
    const FloatTag d;
    const IntTag di;
    constexpr int shift = 23 - ShadowLadder::Mantissa;
    const Float each = SetFloat(ShadowLadder::Each);
    const Float fine = SetFloat(1 << ShadowLadder::Octaves);
    const Float one = SetFloat(1.0);
    const Float farthest = SetFloat(GetShadowColumn(this->Columns));
    const auto zero = hn::Zero(di);
    for (int i = 0; i < this->Pixels; i += GetLanes())
    {
      const int valid = std::min(this->Pixels - i, GetLanes());
      const auto inside = hn::RebindMask(di, hn::FirstN(d, valid));
      const auto row = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Row.data() + i));
      const Float depth =
        hn::Min(hn::LoadU(d, this->Memory.Depth.data() + i), SetFloat(this->Settings.FarLimit));
      const Float end =
        hn::MulAdd(depth, hn::GatherIndex(d, this->Memory.Perpendicular.data(), row),
          SetFloat(-this->Start / this->Width));
      const Float at = hn::Min(hn::Max(end, hn::Zero(d)), SetFloat(1e6));
      const auto column = hn::IfThenElseZero(inside, hn::LoadU(di, this->Memory.Column.data() + i));
      hn::StoreU(hn::Min(at, farthest), d, this->Memory.At.data() + i);
      hn::StoreU(this->GetLonger(hn::ConvertTo(d, column), hn::ConvertTo(d, row)), d,
        this->Memory.Longer.data() + i);
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
      hn::StoreU(hn::ConvertTo(d, first) + whole, d, this->Memory.Whole.data() + i);
      hn::StoreU(x - whole, d, this->Memory.Rest.data() + i);
      hn::StoreU(width, d, this->Memory.LastWidth.data() + i);
    }
  }

  void MeasurePixels()
  {
    const FloatTag d;
    const IntTag di;
    for (int i = 0; i < this->Pixels; i += GetLanes())
    {
      const int valid = std::min(this->Pixels - i, GetLanes());
      const auto row = hn::IfThenElseZero(
        hn::RebindMask(di, hn::FirstN(d, valid)), hn::LoadU(di, this->Memory.Row.data() + i));
      const Float extinction = hn::GatherIndex(d, this->Memory.Extinction.data(), row);
      this->StoreCorrections(i, hn::LoadU(d, this->Memory.At.data() + i), extinction,
        hn::LoadU(d, this->Memory.Longer.data() + i));
      const Float part =
        GetAbsorbedPart(extinction * hn::LoadU(d, this->Memory.LastWidth.data() + i),
          hn::LoadU(d, this->Memory.Rest.data() + i));
      const Float last =
        hn::Min(hn::LoadU(d, this->Memory.Whole.data() + i) + hn::Min(part, SetFloat(0.9999)),
          SetFloat(this->Columns));
      const auto lastColumn = hn::ConvertTo(di, last);
      hn::StoreU(last, d, this->Memory.Last.data() + i);
      hn::StoreU(lastColumn, di, this->Memory.LastColumn.data() + i);
      hn::StoreU(last - hn::ConvertTo(d, lastColumn), d, this->Memory.Within.data() + i);
    }
  }

  // (1 - e^-ab)/(1 - e^-a), b of a column that is a thick. Of thin ones within 1e-6, by the first terms in a:
  // b (1 + (1 - b) a/2 (1 + (1 - 2 b) a/6)).
  static HWY_INLINE Float GetAbsorbedPart(Float a, Float b)
  {
    const FloatTag d;
    const Float one = SetFloat(1.0);
    if (hn::AllTrue(d, hn::Lt(a, SetFloat(0.05))))
    {
      const Float second = hn::MulAdd((one - b - b) * SetFloat(1.0 / 6.0), a, one);
      return b * hn::MulAdd((one - b) * SetFloat(0.5) * a, second, one);
    }
    return Absorbed(d, a * b) / Absorbed(d, hn::Max(a, SetFloat(1e-20)));
  }

  // How much longer pixels' rays are than the line's in their rows, for each unit of depth [fraction].
  HWY_INLINE Float GetLonger(Float column, Float row) const
  {
    const double size = this->Settings.PixelSize;
    const double start =
      this->Center.At + this->Center.Slope * this->FirstRow - this->Image.Center[0];
    const Float ofLine =
      hn::MulAdd(row, SetFloat(this->Center.Slope * size), SetFloat(start * size));
    const Float ofPixel = (column - SetFloat(this->Image.Center[0])) * SetFloat(size);
    const Float square =
      hn::MulAdd(row, hn::MulAdd(row, SetFloat(this->Square[2]), SetFloat(this->Square[1])),
        SetFloat(this->Square[0]));
    return (ofPixel - ofLine) * (ofPixel + ofLine) * SetFloat(0.5) / square;
  }

  // What all columns up to a width hide is f(u) = 1 - e^-u with u = x width. Of the sums, the part that is
  // too much in the middle between two steps, over 1/4: linear in ln x, it is L^2 (u f' + u^2 f'')/2 for
  // steps of L. And what they are times for a ray that is longer: 1 + longer u f'/f. So what is all dark
  // is dark.
  HWY_INLINE void StoreCorrections(int pixel, Float width, Float extinction, Float longer)
  {
    const FloatTag d;
    const Float one = SetFloat(1.0);
    const double step = std::log(ShadowLadder::Ratio);
    const auto bend = [&](Float u, Float absorbed) HWY_ATTR
    { return u * (one - u) * (one - absorbed); };
    const Float u = width * extinction;
    Float hidden = Absorbed(d, u);
    Float excess = bend(u, hidden);
    const Float shift = extinction * SetFloat(this->Start / this->Width);
    Float change = (u + shift) * (one - hidden);
    if (this->FirstColumn > 0)
    {
      const Float first = SetFloat(ShadowLadder::Each) * extinction;
      const Float before = Absorbed(d, first);
      excess = excess - bend(first, before);
      change = change - (first + shift) * (one - before);
      hidden = hidden - before;
    }
    const Float perAll = one / hn::Max(hidden, SetFloat(1e-12));
    const Float part = SetFloat(0.5 * step * step) * excess * perAll;
    hn::StoreU(hn::MulAdd(longer, change * perAll, one), d, this->Memory.Stretch.data() + pixel);
    hn::StoreU(hn::Max(hn::Min(part, SetFloat(0.02)), SetFloat(-0.02)), d,
      this->Memory.Excess.data() + pixel);
  }

  // Row by row in the direction of light, in stretches of pixels between the same steps of the ladder.
  // In parts: where columns turn dark one layer after the other.
  template <bool InParts>
  void Hide(int channel)
  {
    const float* parts = this->Memory.Part[channel].data();
    const int* rows = this->Memory.Row.data();
    const float* steps = this->Memory.Step.data();
    const float* last = this->Memory.Last.data();
    const int* head = this->Memory.Head.data();
    const int* next = this->Memory.Next.data();
    const int* columns = this->Memory.LastColumn.data();
    const float* within = this->Memory.Within.data();
    float* sums = this->Memory.Sums.data();
    this->Sums.Clear(this->Columns);
    int row = 0; // columns that turn dark before it are marked
    for (int begin = 0; begin < this->Pixels;)
    {
      const int step = std::min(static_cast<int>(steps[rows[begin]]), this->Ladder.Steps - 2);
      const float low = step - 0.2f;
      const float high = step + 1.2f;
      int end = begin;
      float most = 0.0f;
      for (; end < this->Pixels && steps[rows[end]] >= low && steps[rows[end]] <= high; ++end)
      {
        most = std::max(most, last[end]);
      }
      const int needed = static_cast<int>(std::min(this->Columns + 0.0f, most + 1.0f));
      for (; row < rows[begin]; ++row)
      {
        for (int j = head[row]; j >= 0; j = next[j])
        {
          InParts ? this->Sums.Mark(this->GetColumn(j), parts[j]) : this->Sums.Mark(j);
        }
      }
      this->Sums.Build(step, needed);
      for (int i = begin; i < end; ++i)
      {
        for (; row <= rows[i]; ++row)
        {
          for (int j = head[row]; j >= 0; j = next[j])
          {
            const int column = InParts ? this->GetColumn(j) : j;
            InParts ? this->Sums.Mark(column, parts[j]) : this->Sums.Mark(column);
            if (column < needed)
            {
              InParts ? this->Sums.Add(column, parts[j]) : this->Sums.Add(column);
            }
          }
        }
        this->Sums.Read(columns[i], within[i], sums + 2 * i);
      }
      this->WriteHidden(begin, end, step, this->Picture.Hidden[channel]);
      begin = end;
    }
  }

  // Of pixels whose sums are of a step and the next one.
  void WriteHidden(int begin, int end, int step, float* hidden) const
  {
    const FloatTag d;
    const IntTag di;
    const int* offsets = this->Memory.Offset.data();
    for (int i = begin; i < end; i += GetLanes())
    {
      const int count = std::min(end - i, GetLanes());
      const auto row = hn::IfThenElseZero(
        hn::RebindMask(di, hn::FirstN(d, count)), hn::LoadU(di, this->Memory.Row.data() + i));
      const Float part = hn::GatherIndex(d, this->Memory.Step.data(), row) - SetFloat(step);
      Float one;
      Float other;
      hn::LoadInterleaved2(d, this->Memory.Sums.data() + 2 * i, one, other);
      const Float excess =
        part * (SetFloat(1.0) - part) * hn::LoadU(d, this->Memory.Excess.data() + i);
      const Float sum = hn::MulAdd(part, other - one, one) *
        hn::GatherIndex(d, this->Memory.Before.data(), row) * (SetFloat(1.0) - excess) *
        hn::LoadU(d, this->Memory.Stretch.data() + i);
      HWY_ALIGN float sums[8];
      hn::StoreU(sum, d, sums);
      for (int pixel = 0; pixel < count; ++pixel)
      {
        hidden[offsets[i + pixel]] = sums[pixel];
      }
    }
  }

  // Of a place in Flip, of layers.
  HWY_INLINE int GetColumn(int place) const { return place % this->Memory.Room; }

  // From a table: what is between the ends of the runs of dark columns.
  template <bool InParts>
  void HideRuns()
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    const int* rows = this->Memory.Row.data();
    const ColumnEdges edges = this->GetEdges();
    const auto number = [&](double first, double change, Float row) HWY_ATTR
    { return hn::MulAdd(row, SetFloat(change), SetFloat(first)); };
    InParts ? this->Shades.Clear(this->Settings.Channels) : this->Runs.Clear(this->Columns);
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
            InParts ? this->Shades.Mark(this->GetColumn(j), j) : this->Runs.Mark(j);
          }
        }
        InParts ? this->Seen.Add(this->Shades, this->Settings.Channels, pixel)
                : this->Seen.Add(pixel);
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
        hn::Min(hn::LoadU(d, this->Memory.Depth.data() + i), SetFloat(this->Settings.FarLimit));
      const Float begin = this->Picture.Begins
        ? hn::Min(hn::GatherIndex(d, this->Picture.Begins, offset), last)
        : hn::Zero(d);
      Float meeting[4];
      for (int j = 0; j < 4; ++j)
      {
        meeting[j] = number(this->Meeting[j][0], this->Meeting[j][1], k);
      }
      this->Seen.Measure(
        this->Settings, edges, FindRays(this->Settings, x, y), meeting, begin, last);
      HWY_ALIGN float sums[8];
      for (int plane = 0; plane < this->Settings.Planes; ++plane)
      {
        if (InParts)
        {
          this->Seen.Weigh(plane, plane % this->Settings.Channels);
        }
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
      return { this->Fan.EdgeSines.data(), this->Fan.EdgeMinusCosines.data() };
    }
    const FloatTag d;
    for (int j = this->FirstColumn; j <= this->Columns; j += GetLanes())
    {
      hn::StoreU(hn::MulAdd(hn::LoadU(d, this->Ladder.Edges.data() + j), SetFloat(this->Width),
                   SetFloat(this->Start)),
        d, this->Memory.EdgePlaces.data() + j);
    }
    return { this->Memory.EdgePlaces.data(), this->Memory.Ones.data() };
  }

  DarkSums Sums;
  DarkRuns Runs;
  DarkShades Shades;
  SeenRuns Seen;
};

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

void DeleteShadowLines::operator()(ShadowLines* lines) const
{
  delete lines;
}

ShadowLinesPointer MakeShadowLines()
{
  return ShadowLinesPointer(new ShadowLines);
}

void SweepShadowBand(const CoverageSettings& settings, const CoverageImage& image,
  const CoverageWedge& wedge, int band, const vtkGodRaysShadowGrids& grids,
  const ShadowTables& tables, const ShadowPicture& picture, ShadowLines& lines)
{
  HWY_DYNAMIC_DISPATCH(RunShadowBand)
  (settings, image, wedge, band, grids, tables, picture, lines);
}
}
#endif
