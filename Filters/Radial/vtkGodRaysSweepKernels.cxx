// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled several times: by foreach_target.h, once for each set of vector
// instructions, and at last for the baseline, with HWY_ONCE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vtkGodRaysSweepKernels.cxx"
#include "vtkGodRaysVectorSets.h"

#include <hwy/foreach_target.h> // must come before highway.h

#include "vtkGodRaysSweepKernels.h"
#include "vtkGodRaysSweepRows-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
// One band of a wedge on its way along the rows, in some components at once.
template <int Channels>
class BandSweep : BandRows<Channels>
{
  using Rows = BandRows<Channels>;
  using Rows::StripRows;

public:
  using Rows::Rows;

  template <int Powers>
  void Run()
  {
    const SweepRow* previous = nullptr;
    int count = 0;
    for (const SweepRow& row : this->Wedge.Schedule)
    {
      if (++count % ClearedRows == 0)
      {
        this->ClearNegligible<Powers>();
      }
      if (row.Refine)
      {
        this->Refine<Powers>(*previous, row);
      }
      if (this->FindLines(row))
      {
        this->LoadRow(row);
        this->AdvanceLines<Powers>(row);
        if (row.Output)
        {
          this->WriteRow(row);
        }
      }
      previous = &row;
    }
    this->FlushStrip();
  }

private:
  static constexpr int ClearedRows = 8;

  // Lines.

  // Where lines of one octave lie among those of a coarser one: Start + Ratio line.
  struct Map
  {
    double Start;
    double Ratio;

    double Find(int line) const { return this->Start + this->Ratio * line; }
  };
  Map FindCoarse(int fine, int coarse) const
  {
    const SweepOctave& from = this->Octaves[fine];
    const SweepOctave& to = this->Octaves[coarse];
    return { (from.FirstSlope - to.FirstSlope) / to.SlopeStep, std::ldexp(1.0, fine - coarse) };
  }

  // From one row to the next; then the sums that make the result, if one is wanted.
  template <int Powers>
  void AdvanceLines(const SweepRow& row)
  {
    if (!row.Output || row.Tail < 0)
    {
      this->AdvanceLines<Powers, false>(row, Map{ 0.0, 0.0 });
      this->StoreRow<Powers>(row);
      return;
    }
    const Map coarse = this->FindCoarse(row.Octave, this->Wedge.HistoryOctaves[row.Tail]);
    if (row.Store >= 0)
    {
      // It may be what the row's own end reads.
      this->AdvanceLines<Powers, false>(row, coarse);
      this->StoreRow<Powers>(row);
      this->BlendTail(row, coarse);
      this->SubtractTail(coarse);
      return;
    }
    this->BlendTail(row, coarse);
    this->AdvanceLines<Powers, true>(row, coarse);
  }

  template <int Powers, bool Subtracts>
  void AdvanceLines(const SweepRow& row, const Map& coarse)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    Float pole[Powers];
    Float before[Powers];
    Float after[Powers];
    Float factor[Powers];
    for (int j = 0; j < Powers; ++j)
    {
      pole[j] = hn::Set(d, row.Pole[j]);
      before[j] = hn::Set(d, row.Before[j]);
      after[j] = hn::Set(d, row.After[j]);
      factor[j] = hn::Set(d, this->Wedge.Factors[j]);
    }
    const double position = this->Position - this->FirstPixel;
    const float step = static_cast<float>(this->Step);
    const float ratio = static_cast<float>(coarse.Ratio);
    for (int l = this->FirstLine; l < this->EndLine; l += lanes)
    {
      const int lane = FindLane(l);
      const Places places = FindPlaces(position + (l - lane) * this->Step, step, lane, lanes - 1);
      Places ends;
      if (Subtracts)
      {
        ends = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
      }
      for (int c = 0; c < Channels; ++c)
      {
        SweepChannel& channel = this->Channel[c];
        const Float now = Read<1>(channel.Smooth, places);
        const Float then = hn::Load(d, channel.State[Powers] + l);
        hn::Store(now, d, channel.State[Powers] + l);
        Float sum = hn::Zero(d);
        for (int j = 0; j < Powers; ++j)
        {
          Float state = AddProduct(before[j], then, after[j] * now);
          state = AddProduct(pole[j], hn::Load(d, channel.State[j] + l), state);
          hn::Store(state, d, channel.State[j] + l);
          sum = AddProduct(factor[j], state, sum);
        }
        if (Subtracts)
        {
          sum = sum - Read<1>(channel.Tail, ends);
        }
        hn::Store(sum, d, channel.Sums + l);
      }
    }
  }

  // Every few rows.
  template <int Powers>
  void ClearNegligible()
  {
    const FloatTag d;
    const Float negligible = hn::Set(d, Negligible);
    for (SweepChannel& channel : this->Channel)
    {
      for (int j = 0; j < Powers; ++j)
      {
        for (int l = this->FirstLine; l < this->EndLine; l += GetLanes())
        {
          const Float state = hn::Load(d, channel.State[j] + l);
          const Float kept = hn::IfThenElseZero(hn::Gt(hn::Abs(state), negligible), state);
          hn::Store(kept, d, channel.State[j] + l);
        }
      }
    }
  }

  template <int Powers>
  void StoreRow(const SweepRow& row)
  {
    if (row.Store >= 0)
    {
      this->StoreHistory<Powers>(row.Store, row.Distance, this->FirstLine, this->EndLine);
    }
  }

  // The sum that ends of marches subtract, times s: it is smoother than the sum near the light.
  template <int Powers>
  void StoreHistory(int entry, double distance, int first, int end)
  {
    const FloatTag d;
    const Float scale = hn::Set(d, static_cast<float>(distance));
    for (SweepChannel& channel : this->Channel)
    {
      float* history = channel.History + this->Wedge.HistoryOffsets[entry];
      for (int l = first; l < end; l += GetLanes())
      {
        Float sum = hn::Zero(d);
        for (int j = 0; j < Powers; ++j)
        {
          const Float factor = hn::Set(d, this->Wedge.TailFactors[j]);
          sum = AddProduct(factor, hn::Load(d, channel.State[j] + l), sum);
        }
        hn::Store(scale * sum, d, history + l);
      }
    }
  }

  // The two rows of the history are blended where there are fewer lines: in their own octave.
  void BlendTail(const SweepRow& row, const Map& coarse)
  {
    const FloatTag d;
    const int first = static_cast<int>(coarse.Find(this->FirstLine)) / Group * Group;
    const int end = static_cast<int>(coarse.Find(this->EndLine)) + 2;
    const Float blend = hn::Set(d, row.TailBlend);
    const Float scale = hn::Set(d, row.TailScale);
    for (SweepChannel& channel : this->Channel)
    {
      const float* here = channel.History + this->Wedge.HistoryOffsets[row.Tail];
      const float* next = channel.History + this->Wedge.HistoryOffsets[row.Tail + 1];
      for (int l = first; l < end; l += GetLanes())
      {
        const Float a = hn::Load(d, here + l);
        const Float b = hn::Load(d, next + l);
        hn::Store(AddProduct(blend, b - a, a) * scale, d, channel.Tail + l);
      }
    }
  }

  void SubtractTail(const Map& coarse)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const float ratio = static_cast<float>(coarse.Ratio);
    for (int l = this->FirstLine; l < this->EndLine; l += lanes)
    {
      const int lane = FindLane(l);
      const Places places = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
      for (SweepChannel& channel : this->Channel)
      {
        const Float tail = Read<1>(channel.Tail, places);
        hn::Store(hn::Load(d, channel.Sums + l) - tail, d, channel.Sums + l);
      }
    }
  }

  // Interpolate the states to the lines of a finer octave.
  template <int Powers>
  void Refine(const SweepRow& previous, const SweepRow& row)
  {
    const FloatTag d;
    const int lanes = GetLanes();
    const Map coarse = this->FindCoarse(row.Octave, previous.Octave);
    const float ratio = static_cast<float>(coarse.Ratio);
    const int lines = this->Octaves[row.Octave].Lines;
    for (SweepChannel& channel : this->Channel)
    {
      for (int j = 0; j <= Powers; ++j)
      {
        if (this->IsAxis)
        {
          std::copy_n(
            channel.State[j], this->Stride, this->GetAxisState(channel, previous.Octave, j));
        }
        for (int l = 0; l < lines; l += lanes)
        {
          const int lane = FindLane(l);
          const Places places = FindPlaces(coarse.Find(l - lane), ratio, lane, lanes - 1);
          hn::Store(ReadSmoothly<NEAR>(channel.State[j], places), d, channel.Spare[j] + l);
        }
        std::swap(channel.State[j], channel.Spare[j]);
        if (this->HasAxis)
        {
          this->TakeFromAxis(channel, j, previous.Octave, row.Octave);
        }
      }
    }
    if (row.RefineStore >= 0)
    {
      this->StoreHistory<Powers>(row.RefineStore, previous.Distance, 0, lines);
    }
  }

  // The strip's states before a refinement.
  float* GetAxisState(const SweepChannel& channel, int octave, int power) const
  {
    return channel.AxisStates +
      (static_cast<std::ptrdiff_t>(octave) * (this->Wedge.Powers + 1) + power) * this->Stride;
  }

  // The states of lines in the axis strip.
  void TakeFromAxis(SweepChannel& channel, int power, int coarse, int fine)
  {
    const SweepOctave& axis = this->Wedge.AxisOctaves[coarse];
    const SweepOctave& octave = this->Octaves[fine];
    const double start = this->GetSlope(octave);
    const double low = std::ceil((-axis.HalfWidth - start) / octave.SlopeStep);
    const double high = std::floor((axis.HalfWidth - start) / octave.SlopeStep);
    const float* states = this->GetAxisState(channel, coarse, power);
    const int end = static_cast<int>(std::min(high, octave.Lines - 1.0));
    for (int l = static_cast<int>(std::max(low, 0.0)); l <= end; ++l)
    {
      const double position = (start + l * octave.SlopeStep - axis.FirstSlope) / axis.SlopeStep;
      const int left = static_cast<int>(position);
      const float f = static_cast<float>(position - left);
      channel.State[power][l] = states[left] + f * (states[left + 1] - states[left]);
    }
  }

  // Results.

  // Whether the wedge owns a pixel; the wedges together own each pixel once.
  bool Owns(int column, double distance) const
  {
    const double across = std::abs(column - this->Wedge.LightColumn);
    return this->Wedge.Transposed ? across < distance : across <= distance;
  }

  // Pixels of the band in a row; wedge and image end them at both sides.
  void FindPixels(const SweepRow& row, int& first, int& last) const
  {
    const SweepWedge& w = this->Wedge;
    const double end = w.Columns - 1.0;
    const double s = row.Distance;
    auto find = [&](double slope)
    { return static_cast<int>(std::ceil(Clamp(w.LightColumn + slope * s, -2.0, end + 2.0))); };
    first = std::max(0, this->First ? find(-1.0) - 1 : find(this->LowSlope));
    last = std::min(w.Columns - 1, this->Last ? find(1.0) + 1 : find(this->HighSlope) - 1);
    while (first <= last && !this->Owns(first, s))
    {
      ++first;
    }
    while (first <= last && !this->Owns(last, s))
    {
      --last;
    }
  }

  static double Clamp(double value, double low, double high)
  {
    return std::min(std::max(value, low), high);
  }

  // Pixels of the axis strip in a row.
  void FindAxisPixels(const SweepRow& row, int& first, int& last) const
  {
    const double reach = this->Octaves[row.Octave].HalfWidth * row.Distance;
    const double column = this->Wedge.LightColumn;
    first = static_cast<int>(std::max(0.0, std::ceil(column - reach)));
    last = static_cast<int>(std::min(this->Wedge.Columns - 1.0, std::floor(column + reach)));
  }

  // What the axis strip has found, instead.
  void TakePixelsFromAxis(const SweepRow& row, int first, int last, float* const to[Channels]) const
  {
    const int* columns = this->AxisColumns.data() + 2 * row.OutputIndex;
    const int begin = std::max(first, columns[0]);
    const int end = std::min(last, columns[1]);
    for (int c = 0; c < Channels && begin <= end; ++c)
    {
      const float* from = this->GetAxisPixels(c, row);
      std::copy(
        from + (begin - columns[0]), from + (end + 1 - columns[0]), to[c] + (begin - first));
    }
  }

  float* GetAxisPixels(int c, const SweepRow& row) const
  {
    return this->Channel[c].AxisPixels +
      static_cast<std::ptrdiff_t>(row.OutputIndex) * this->Wedge.AxisPixels;
  }

  void WriteRow(const SweepRow& row)
  {
    int first;
    int last;
    if (this->IsAxis)
    {
      this->FindAxisPixels(row, first, last);
    }
    else
    {
      this->FindPixels(row, first, last);
    }
    if (first > last)
    {
      return;
    }
    const double position = (first - this->Position) / this->Step; // in lines
    const double step = 1.0 / this->Step;
    float* to[Channels];
    this->FindTargets(row, first, last, to);
    const int lanes = GetLanes();
    const int count = last - first + 1;
    const double reach = (lanes - 1) * step + 1.0;
    if (reach < lanes)
    {
      this->WritePixels<NEAR>(position, step, lanes - 1, to, count);
    }
    else if (reach < 2 * lanes - 3)
    {
      this->WritePixels<MIDDLE>(position, step, 2 * lanes - 4, to, count);
    }
    else if (reach < 2 * lanes)
    {
      this->WritePixels<FAR>(position, step, 2 * lanes - 1, to, count);
    }
    else
    {
      this->WritePixels<ANY>(position, step, std::numeric_limits<int>::max(), to, count);
    }
    if (this->HasAxis)
    {
      this->TakePixelsFromAxis(row, first, last, to);
    }
  }

  template <int Reach>
  HWY_INLINE void WritePixels(
    double position, double step, int maximum, float* const to[Channels], int count)
  {
    const FloatTag d;
    const IntTag di;
    const int lanes = GetLanes();
    int i = 0;
    for (; i + lanes <= count; i += lanes)
    {
      const int lane = FindLane(i);
      const double start = std::max(1.0, position + (i - lane) * step);
      const Places places = FindPlaces(start, static_cast<float>(step), lane, maximum);
      for (int c = 0; c < Channels; ++c)
      {
        hn::StoreU(this->FindResult<Reach>(this->Channel[c], places), d, to[c] + i);
      }
    }
    if (i < count)
    {
      const int lane = FindLane(i);
      const double start = std::max(1.0, position + (i - lane) * step);
      Places places = FindPlaces(start, static_cast<float>(step), lane, maximum);
      // Those beyond the last pixel read lines that may not exist; they are dropped.
      places.Base = std::min<std::ptrdiff_t>(places.Base, this->Stride - 3);
      places.Index =
        hn::Min(places.Index, hn::Set(di, static_cast<int>(this->Stride - 3 - places.Base)));
      for (int c = 0; c < Channels; ++c)
      {
        HWY_ALIGN float rest[Group];
        hn::Store(this->FindResult<Reach>(this->Channel[c], places), d, rest);
        std::copy(rest, rest + (count - i), to[c] + i);
      }
    }
  }

  template <int Reach>
  static HWY_INLINE Float FindResult(const SweepChannel& channel, const Places& places)
  {
    const FloatTag d;
    const Float sum = ReadSmoothly<Reach>(channel.Sums, places) * hn::Set(d, channel.Gain);
    return hn::Max(hn::Min(sum, hn::Set(d, LargestFloat)), hn::Zero(d));
  }

  // Where pixels first to last of a row are written.
  void FindTargets(const SweepRow& row, int first, int last, float* to[Channels])
  {
    if (this->IsAxis)
    {
      this->AxisColumns[2 * row.OutputIndex] = first;
      this->AxisColumns[2 * row.OutputIndex + 1] = last;
      for (int c = 0; c < Channels; ++c)
      {
        to[c] = this->GetAxisPixels(c, row);
      }
      return;
    }
    if (!this->Wedge.Transposed)
    {
      for (int c = 0; c < Channels; ++c)
      {
        const SweepResult& result = this->Channel[c].Result;
        to[c] = result.Values + row.Row * result.Stride + first;
      }
      return;
    }
    const int strip = (row.Row + this->OutputShift) / StripRows;
    if (strip != this->OutputStrip)
    {
      this->FlushStrip();
      this->OutputStrip = strip;
    }
    const int column = (row.Row + this->OutputShift) % StripRows;
    this->OutputFirst[column] = first;
    this->OutputLast[column] = last;
    for (int c = 0; c < Channels; ++c)
    {
      to[c] = this->GetOutputRow(this->Channel[c], column) + first;
    }
  }

  float* GetOutputRow(const SweepChannel& channel, int column) const
  {
    return channel.Strips + (2 * StripRows + column) * this->StripStride;
  }

  // Write a strip of columns into the image; most 16 x 16 blocks are complete.
  void FlushStrip()
  {
    if (this->OutputStrip < 0)
    {
      return;
    }
    int begin = 0;
    int end = std::numeric_limits<int>::max();
    for (int i = 0; i < StripRows; ++i)
    {
      begin = std::max(begin, this->OutputFirst[i]);
      end = std::min(end, this->OutputLast[i] + 1);
    }
    begin = (begin + 15) / 16 * 16;
    end = std::max(begin, end / 16 * 16);
    for (SweepChannel& channel : this->Channel)
    {
      const std::ptrdiff_t stride = channel.Result.Stride;
      float* to = channel.Result.Values + (this->OutputStrip * StripRows - this->OutputShift);
      const float* from = this->GetOutputRow(channel, 0);
      for (int y = begin; y < end; y += 16)
      {
        Transpose16(from + y, this->StripStride, to + y * stride, stride);
      }
      for (int column = 0; column < StripRows; ++column)
      {
        const float* values = from + column * this->StripStride;
        const int last = this->OutputLast[column];
        for (int y = this->OutputFirst[column]; y <= last && y < begin; ++y)
        {
          to[y * stride + column] = values[y];
        }
        for (int y = std::max(end, this->OutputFirst[column]); y <= last; ++y)
        {
          to[y * stride + column] = values[y];
        }
      }
    }
    std::fill_n(this->OutputFirst, StripRows, 0);
    std::fill_n(this->OutputLast, StripRows, -1);
    this->OutputStrip = -1;
  }
};

template <int Channels>
void RunChannels(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  SweepWorkspace* axis, SweepWorkspace& workspace, const SweepResult* results)
{
  BandSweep<Channels> sweep(plan, wedge, band, images, axis, workspace, results);
  switch (wedge.Powers)
  {
    case 1:
      return sweep.template Run<1>();
    case 2:
      return sweep.template Run<2>();
    case 3:
      return sweep.template Run<3>();
    case 4:
      return sweep.template Run<4>();
    case 5:
      return sweep.template Run<5>();
    default:
      return sweep.template Run<6>();
  }
}

void RunBand(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  int channels, SweepWorkspace* axis, SweepWorkspace& workspace, const SweepResult* results)
{
  if (channels == 3)
  {
    return RunChannels<3>(plan, wedge, band, images, axis, workspace, results);
  }
  RunChannels<1>(plan, wedge, band, images, axis, workspace, results);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vtkGodRays
{
HWY_EXPORT(RunBand);

void SweepAxis(const SweepPlan& plan, const SweepWedge& wedge, const SweepImage* images,
  int channels, SweepWorkspace& workspace)
{
  if (!wedge.AxisOctaves.empty())
  {
    HWY_DYNAMIC_DISPATCH(RunBand)
    (plan, wedge, 0, images, channels, nullptr, workspace, nullptr);
  }
}

void SweepBand(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  int channels, SweepWorkspace& axis, SweepWorkspace& workspace, const SweepResult* results)
{
  HWY_DYNAMIC_DISPATCH(RunBand)(plan, wedge, band, images, channels, &axis, workspace, results);
}

std::vector<std::string> GetInstructionSets()
{
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::string> names;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    names.push_back(hwy::TargetName(target));
  }
  return names;
}

bool UseInstructionSet(const std::string& name)
{
  hwy::SetSupportedTargetsForTest(0);
  bool found = name.empty();
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    if (hwy::TargetName(target) == name)
    {
      hwy::SetSupportedTargetsForTest(target);
      found = true;
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return found;
}
}
#endif
