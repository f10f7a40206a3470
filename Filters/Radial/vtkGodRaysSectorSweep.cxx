// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSectorSweep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vtkGodRays
{
namespace
{
// Lights farther than this many image sizes are brought to it: then shafts deviate from where they
// should be by less than 1e-4 pixels in an image of 1000.
constexpr double FarthestLight = 1e7;

// Of a band, where it is widest: its state stays in the first-level cache, and what is computed
// once a row weighs little.
constexpr double LinesOfBand = 640.0;

// Octaves nearer to the light than this are not worth it [pixels].
constexpr double ShortestOctave = 24.0;

// The axis strip: pixels on either side in which it is needed, at most as many as it has, and its
// lines' distance [pixels].
constexpr double AxisReach = 2.0;
constexpr double LargestAxisReach = 32.0;
constexpr double AxisSpacing = 0.25;

int RoundUp(int value, int multiple)
{
  return (value + multiple - 1) / multiple * multiple;
}

// integral of x^(q-1) from 1 - e to 1 = (1 - (1-e)^q)/q.
double IntegratePower(double q, double e)
{
  const double logarithm = std::log1p(-e);
  return std::abs(q) < 1e-9 ? -logarithm : -std::expm1(q * logarithm) / q;
}

// The weights of the image at the row before and at this one, in G with power p:
//   After  = integral (1-z) (1-e z)^p |e| dz,  Before = integral z (1-e z)^p |e| dz,  z in [0, 1]
// where e is the step, relative to this row's distance.
void ComputeStepWeights(double p, double e, double& before, double& after)
{
  const double size = std::abs(e);
  const double pe = p * e;
  if (std::abs(pe) < 0.1 && size < 0.05)
  {
    // (1-e z)^p as a binomial series in z: terms below 1e-7 are left out.
    const double c2 = pe * (pe - e) / 2.0;
    const double c3 = c2 * (pe - 2.0 * e) / 3.0;
    const double c4 = c3 * (pe - 3.0 * e) / 4.0;
    after = size * (1.0 / 2.0 - pe / 6.0 + c2 / 12.0 - c3 / 20.0 + c4 / 30.0);
    before = size * (1.0 / 2.0 - pe / 3.0 + c2 / 4.0 - c3 / 5.0 + c4 / 6.0);
    return;
  }
  const double zeroth = IntegratePower(p + 1.0, e);
  const double first = IntegratePower(p + 2.0, e);
  before = std::abs((zeroth - first) / e);
  after = std::max(std::abs(zeroth) - before, 0.0);
}

void ComputeCoefficients(const PowerSum& kernel, double before, SweepRow& row)
{
  const double e = (row.Distance - before) / row.Distance;
  const double logarithm = std::log1p(-e);
  for (int j = 0; j < kernel.Count; ++j)
  {
    const double p = kernel.Powers[j];
    double weights[2];
    ComputeStepWeights(p, e, weights[0], weights[1]);
    row.Pole[j] = static_cast<float>(std::exp((p + 1.0) * logarithm));
    row.Before[j] = static_cast<float>(weights[0]);
    row.After[j] = static_cast<float>(weights[1]);
  }
}

// Into how many a row at distance s is divided. The error of a step falls with the square of it.
int CountSubrows(const SweepEffort& effort, double distance)
{
  return distance < effort.SubrowReach ? 4 : distance < 3.0 * effort.SubrowReach ? 2 : 1;
}

// Everything about the rows that a wedge's geometry decides, in the order of the sweep.
class Scheduler
{
public:
  Scheduler(const SweepPlan& plan, SweepWedge& wedge)
    : Plan(plan)
    , Wedge(wedge)
  {
  }

  // False if the wedge holds no pixel.
  bool Run()
  {
    if (!this->FindRange() || !this->FindSlopes())
    {
      return false;
    }
    this->Outward = this->Plan.Density > 0.0;
    this->MakeOctaves();
    this->MakeBands();
    this->MakeAxis();
    this->MakeRows();
    this->MakeHistory();
    this->MakeFactors();
    return true;
  }

  // Distances of the first and the last pixel row, after FindRange().
  double GetNearest() const { return this->Entry; }
  double GetFarthest() const { return this->Farthest; }

  // Entry: where the image begins, 0 if the light is between its rows.
  bool FindRange()
  {
    const SweepWedge& w = this->Wedge;
    const bool up = w.Direction > 0;
    const double border = up ? -1.0 : w.Rows;
    const double light = std::clamp(w.LightRow, -2.0, w.Rows + 1.0); // farther is no other row
    this->FirstRow = up ? std::max(0, Floor(light) + 1) : std::min(w.Rows - 1, Ceil(light) - 1);
    this->LastRow = up ? w.Rows - 1 : 0;
    if (up ? this->FirstRow > this->LastRow : this->FirstRow < this->LastRow)
    {
      return false;
    }
    this->Entry = std::max(0.0, w.Direction * (border - w.LightRow));
    this->Nearest = this->GetDistance(this->FirstRow);
    this->Farthest = this->GetDistance(this->LastRow);
    return this->Farthest > 0.0;
  }

  // The slopes of the wedge's pixels.
  bool FindSlopes()
  {
    const double left = -this->Wedge.LightColumn;
    const double right = this->Wedge.Columns - 1 - this->Wedge.LightColumn;
    const double nearest = std::max(this->Nearest, 1e-9);
    this->LowSlope = std::max(-1.0, std::min(left / nearest, left / this->Farthest));
    this->HighSlope = std::min(1.0, std::max(right / nearest, right / this->Farthest));
    return this->LowSlope <= this->HighSlope;
  }

private:
  static int Floor(double x) { return static_cast<int>(std::floor(x)); }
  static int Ceil(double x) { return static_cast<int>(std::ceil(x)); }

  double GetDistance(double row) const
  {
    return this->Wedge.Direction * (row - this->Wedge.LightRow);
  }

  // A sweep towards the light has one: its lines have no need to be made anew.
  void MakeOctaves()
  {
    this->Wedge.Octaves.clear();
    double top = this->Farthest;
    do
    {
      SweepOctave octave;
      octave.SlopeStep = this->Plan.Effort.Spacing / top;
      this->Wedge.Octaves.push_back(octave);
      top *= 0.5;
    } while (
      this->Plan.Effort.Octaves && this->Outward && top > this->Nearest && top > ShortestOctave);
  }

  int FindOctave(double distance) const
  {
    const int count = static_cast<int>(this->Wedge.Octaves.size());
    int octave = 0;
    double top = 0.5 * this->Farthest;
    while (octave + 1 < count && distance <= top)
    {
      ++octave;
      top *= 0.5;
    }
    return octave;
  }

  void MakeBands()
  {
    // From a pixel's centre in the farthest row on, and by whole pixels there.
    SweepWedge& w = this->Wedge;
    const double first = std::floor(w.LightColumn + this->LowSlope * this->Farthest);
    const double last = std::ceil(w.LightColumn + this->HighSlope * this->Farthest);
    const double bands = std::ceil((last - first) / this->Plan.Effort.Spacing / LinesOfBand);
    // Even numbers are shared best.
    w.Bands = bands > 1.0 ? RoundUp(static_cast<int>(bands), 2) : 1;
    w.FirstSlope = (first - w.LightColumn) / this->Farthest;
    w.BandWidth = std::max(1.0, std::ceil((last - first) / w.Bands)) / this->Farthest;
    for (SweepOctave& octave : w.Octaves)
    {
      octave.FirstSlope = -SweepWedge::Margin * octave.SlopeStep;
      octave.Lines = Ceil(w.BandWidth / octave.SlopeStep) + SweepWedge::Margin + 4;
    }
  }

  // From the far end of an octave to its near one, a line of the strip moves by AxisReach pixels.
  void MakeAxis()
  {
    SweepWedge& w = this->Wedge;
    const SweepEffort& effort = this->Plan.Effort;
    w.AxisOctaves.clear();
    w.AxisPixels = 0;
    if (!this->Outward || !effort.Axis || effort.Spacing <= AxisSpacing || w.LightColumn < -1.0 ||
      w.LightColumn > w.Columns)
    {
      return;
    }
    double top = this->Farthest;
    for (std::size_t i = 0; i < w.Octaves.size(); ++i, top *= 0.5)
    {
      const bool nearest = i + 1 == w.Octaves.size();
      const double change = nearest ? std::min(0.5, 1.0 - this->Nearest / top) : 0.5;
      // Whole lines, so that one has slope 0.
      const double reach = AxisSpacing *
        std::ceil(std::min(AxisReach / std::max(change, 1e-9), LargestAxisReach) / AxisSpacing);
      SweepOctave octave;
      octave.HalfWidth = reach / top;
      octave.SlopeStep = AxisSpacing / top;
      octave.FirstSlope = -octave.HalfWidth - 3.0 * octave.SlopeStep;
      octave.Lines = Ceil(2.0 * octave.HalfWidth / octave.SlopeStep) + 7;
      w.AxisOctaves.push_back(octave);
      w.AxisPixels = std::max(w.AxisPixels, 2 * Ceil(reach) + 2);
    }
  }

  void MakeRows()
  {
    SweepWedge& w = this->Wedge;
    w.Schedule.clear();
    w.OutputRows = 0;
    w.FirstOutputRow = this->FirstRow;
    w.StartsAtLight = this->Outward && this->Entry == 0.0;
    const int rows = std::abs(this->LastRow - this->FirstRow) + 1;
    double before = this->Outward ? this->Entry : this->Farthest + 1.0;
    this->Start = before;
    for (int i = 0; i < rows; ++i)
    {
      const int row =
        this->Outward ? this->FirstRow + i * w.Direction : this->LastRow - i * w.Direction;
      this->AddRow(row, before);
      before = this->GetDistance(row);
    }
    this->MarkOctaves();
  }

  // A row of pixels, and those between it and the one before.
  void AddRow(int pixelRow, double before)
  {
    const double distance = this->GetDistance(pixelRow);
    const int count = CountSubrows(this->Plan.Effort, std::max(distance, before));
    for (int i = 1; i <= count; ++i)
    {
      SweepRow row;
      row.Distance = i == count ? distance : before + (distance - before) * i / count;
      row.Height = static_cast<float>(std::abs(distance - before) / count);
      row.Output = i == count;
      if (row.Output)
      {
        row.Row = pixelRow;
        row.OutputIndex = this->Wedge.OutputRows++;
      }
      else
      {
        const double position = pixelRow + this->Wedge.Direction * (row.Distance - distance);
        row.Row = Floor(position);
        row.Blend = static_cast<float>(position - row.Row);
      }
      const double previous = i == 1 ? before : before + (distance - before) * (i - 1) / count;
      ComputeCoefficients(this->Plan.Kernel, previous, row);
      this->Wedge.Schedule.push_back(row);
    }
  }

  void MarkOctaves()
  {
    int octave = static_cast<int>(this->Wedge.Octaves.size()) - 1;
    for (SweepRow& row : this->Wedge.Schedule)
    {
      const int wanted = std::min(this->FindOctave(row.Distance), octave);
      row.Refine = &row != &this->Wedge.Schedule.front() && wanted != octave;
      // From the second octave to the first there can be one alone.
      octave = row.Refine || &row == &this->Wedge.Schedule.front() ? wanted : octave;
      row.Octave = octave;
    }
  }

  // Which sums are kept, and which are read where: those at q s, q = 1 - d.
  void MakeHistory()
  {
    SweepWedge& w = this->Wedge;
    w.HistoryOctaves.clear();
    w.HistoryOffsets.clear();
    w.HistorySize = 0;
    const double q = 1.0 - this->Plan.Density;
    const double last = w.Schedule.back().Distance;
    const double reach = this->Outward ? q * last - this->Start : this->Start - q * last;
    w.HasTail = q > 1e-7 && reach > 0.0;
    if (!w.HasTail)
    {
      return;
    }
    std::vector<double> distances;
    auto add = [&](int octave, double distance)
    {
      const int axisLines = w.AxisOctaves.empty() ? 0 : w.AxisOctaves[octave].Lines;
      const int stride = RoundUp(std::max(w.Octaves[octave].Lines, axisLines), 16) + 64;
      w.HistoryOctaves.push_back(octave);
      w.HistoryOffsets.push_back(w.HistorySize);
      w.HistorySize += stride;
      distances.push_back(distance);
      return static_cast<int>(distances.size()) - 1;
    };
    add(w.Schedule.front().Octave, this->Start);
    const double sign = this->Outward ? 1.0 : -1.0;
    std::size_t entry = 0;
    for (SweepRow& row : w.Schedule)
    {
      if (sign * (distances.back() - q * last) < 0.0)
      {
        if (row.Refine)
        {
          row.RefineStore = add(row.Octave, distances.back());
        }
        row.Store = add(row.Octave, row.Distance);
      }
      const double target = q * row.Distance;
      if (!row.Output || sign * (target - this->Start) <= 0.0)
      {
        continue;
      }
      while (entry + 2 < distances.size() && sign * (distances[entry + 1] - target) <= 0.0)
      {
        ++entry;
      }
      row.Tail = static_cast<int>(entry);
      row.TailBlend = static_cast<float>(
        std::min(1.0, (target - distances[entry]) / (distances[entry + 1] - distances[entry])));
      row.TailScale = static_cast<float>(1.0 / target);
    }
  }

  void MakeFactors()
  {
    SweepWedge& w = this->Wedge;
    const PowerSum& kernel = this->Plan.Kernel;
    const double d = this->Plan.Density;
    w.Powers = kernel.Count;
    w.Smooth = this->Plan.Effort.Smooth;
    for (int j = 0; j < kernel.Count; ++j)
    {
      const double factor = kernel.Factors[j] / std::abs(d);
      w.Factors[j] = static_cast<float>(factor);
      w.TailFactors[j] =
        static_cast<float>(w.HasTail ? factor * std::pow(1.0 - d, kernel.Powers[j] + 1.0) : 0.0);
      w.InitialState[j] = w.StartsAtLight ? 1.0 / (kernel.Powers[j] + 1.0) : 0.0;
    }
  }

  const SweepPlan& Plan;
  SweepWedge& Wedge;
  bool Outward = true;
  int FirstRow = 0; // nearest to the light
  int LastRow = 0;
  double Entry = 0.0;
  double Start = 0.0;
  double Nearest = 0.0;
  double Farthest = 0.0;
  double LowSlope = 0.0;
  double HighSlope = 0.0;
};

void MakeWedge(const SweepPlan& plan, bool transposed, int direction, SweepWedge& wedge)
{
  wedge.Transposed = transposed;
  wedge.Direction = direction;
  wedge.LightRow = plan.Light[transposed ? 0 : 1];
  wedge.LightColumn = plan.Light[transposed ? 1 : 0];
  wedge.Rows = transposed ? plan.Width : plan.Height;
  wedge.Columns = transposed ? plan.Height : plan.Width;
}

// Of the march, the part beyond which no pixel has anything of the image before it.
double FindEnd(SweepPlan& plan)
{
  double end = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    SweepWedge wedge;
    MakeWedge(plan, i >= 2, i % 2 ? -1 : 1, wedge);
    Scheduler scheduler(plan, wedge);
    if (!scheduler.FindRange() || !scheduler.FindSlopes())
    {
      continue;
    }
    const double farthest = scheduler.GetFarthest();
    const double nearest = scheduler.GetNearest();
    // To where the image begins, or ends.
    const double u =
      plan.Density > 0.0 ? nearest / farthest : (farthest + 1.0) / std::max(nearest, 1.0);
    end = std::max(end, (1.0 - u) / plan.Density);
  }
  // In few steps, so that a fit serves many positions of the light.
  return std::min(1.0, end > 0.25 ? std::ceil(16.0 * end) / 16.0 : end * 1.001);
}

// The light at the end of all marches, if it is not too far away.
void FindLight(SweepPlan& plan)
{
  const vtkGodRaysMarch& march = plan.March;
  const double size = std::max(plan.Width, plan.Height);
  const double center[2] = { 0.5 * (plan.Width - 1), 0.5 * (plan.Height - 1) };
  double way[2];
  for (int i = 0; i < 2; ++i)
  {
    way[i] = march.Constant[i] - march.Slope * center[i];
  }
  const double length = std::hypot(way[0], way[1]);
  plan.Density = march.Slope;
  if (std::abs(march.Slope) * FarthestLight * size < length)
  {
    plan.Density = length / (FarthestLight * size);
  }
  for (int i = 0; i < 2; ++i)
  {
    plan.Light[i] = center[i] + way[i] / plan.Density;
  }
}
}

void SweepImage::Resize(int width, int height)
{
  if (width != this->Width || height != this->Height)
  {
    this->Width = width;
    this->Height = height;
    this->Stride = RoundUp(width + 2 * Padding, 16);
    this->Values.assign(static_cast<std::size_t>(this->Stride) * (height + 24) + 16, 0.0f);
    const auto address = reinterpret_cast<std::uintptr_t>(this->Values.data()) / sizeof(float);
    this->Offset = static_cast<std::ptrdiff_t>((16 - address % 16) % 16);
  }
}

double SweepImage::Sample(double x, double y) const
{
  if (!(x > -1.0 && y > -1.0 && x < this->Width && y < this->Height))
  {
    return 0.0;
  }
  const double left = std::floor(x);
  const double low = std::floor(y);
  const float* lower = this->GetRow(static_cast<int>(low)) + static_cast<int>(left);
  const float* upper = lower + this->Stride;
  const double fx = x - left;
  const double fy = y - low;
  return (1.0 - fy) * ((1.0 - fx) * lower[0] + fx * lower[1]) +
    fy * ((1.0 - fx) * upper[0] + fx * upper[1]);
}

int SweepWedge::GetStride() const
{
  int lines = 0;
  for (const SweepOctave& octave : this->Octaves)
  {
    lines = std::max(lines, octave.Lines);
  }
  for (const SweepOctave& octave : this->AxisOctaves)
  {
    lines = std::max(lines, octave.Lines);
  }
  return RoundUp(lines, 16) + 64;
}

bool PlanSweep(SweepPlan& plan, const char*& reason)
{
  reason = "";
  plan.NumberOfWedges = 0;
  FindLight(plan);
  const double k = plan.March.K;
  constexpr double rounding = 1e-9; // of a density of 1 times the march's scale
  if (plan.Density > 1.0 && plan.Density < 1.0 + rounding)
  {
    plan.Density = 1.0;
  }
  if (plan.Density > 1.0)
  {
    reason = "the march goes past the light";
    return false;
  }
  if (k > 30.0)
  {
    reason = "the kernel ends within few pixels";
    return false;
  }
  plan.End = FindEnd(plan);
  const std::array<double, 4> fitted = { k, plan.Density, plan.End, plan.Effort.FitTolerance };
  if (plan.Fitted != fitted)
  {
    plan.Fitted = fitted;
    plan.Kernel = FitPowerSum(k, plan.Density, plan.End, plan.Effort.FitTolerance);
  }
  if (plan.Kernel.Bound > plan.Effort.FitTolerance)
  {
    reason = "the kernel is not a sum of few powers";
    return false;
  }
  plan.NearRadius =
    std::max(plan.Effort.NearRadius, 4.0 * std::max(1.0, k) / std::abs(plan.Density));
  plan.Wedges.resize(4);
  for (int i = 0; i < 4; ++i)
  {
    SweepWedge& wedge = plan.Wedges[plan.NumberOfWedges];
    MakeWedge(plan, i >= 2, i % 2 ? -1 : 1, wedge);
    if (Scheduler(plan, wedge).Run())
    {
      ++plan.NumberOfWedges;
    }
  }
  return true;
}
}
