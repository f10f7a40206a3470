// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialSweep.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysSectorSweep.h"
#include "vtkGodRaysSweepKernels.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <tuple>
#include <vector>

namespace
{
using vtkGodRays::SweepEffort;
using vtkGodRays::SweepImage;
using vtkGodRays::SweepPlan;
using vtkGodRays::SweepResult;
using vtkGodRays::SweepWedge;
using vtkGodRays::SweepWorkspace;
using Parameters = vtkGodRaysRadialSweep::Parameters;

// Sums of the largest floats stay finite.
constexpr float ScaleOfFloats = 1.0f / 1048576.0f;

// What each effort attains on black and white noise from pixel to pixel: root mean square error
// [fraction of the peak] times the root of the number of pixels that are summed. Measured; see
// Documentation/Evidence/Accuracy.md.
struct EffortRow
{
  double Error;
  double Spacing;
  double SubrowReach;
};
constexpr double EverywhereSubrows = 1e9;
const EffortRow Efforts[] = {
  { 0.077, 1.0, 32.0 },
  { 0.058, 0.85, 32.0 },
  { 0.041, 0.7, 32.0 },
  { 0.031, 0.5, 32.0 },
  { 0.0235, 0.5, 96.0 },
  { 0.017, 1.0 / 3.0, 96.0 },
  { 0.0098, 1.0 / 3.0, EverywhereSubrows },
  { 0.0063, 1.0 / 4.0, EverywhereSubrows },
  { 0.0038, 1.0 / 6.0, EverywhereSubrows },
};

constexpr double MostTaps = 4e8; // of a picture are affordable: 200 a pixel of 1920 x 1080

// Across layers of fewer pixels than that, what falls to 0 beyond the edges is all that there is: lines
// are so close together.
constexpr int ThinLayer = 4;
constexpr double ThinSpacing = 1.0 / 32.0;

// How many taps the whole picture takes at a distance that SumClippedTaps() chooses.
double EstimateTaps(const vtkGodRaysMarch& march, double tolerance)
{
  const double spacing = std::min(std::max(std::sqrt(tolerance / 0.09), 0.02), 1.0);
  return march.GetLengthWithin() / spacing * march.PictureSize[0] * march.PictureSize[1];
}

// The least effort that keeps the tolerance; false if none does.
bool ChooseEffort(double tolerance, const vtkGodRaysMarch& march, SweepEffort& effort)
{
  effort.FitTolerance = 0.4 * tolerance;
  effort.TapTolerance = tolerance;
  const double parallelism = march.GetParallelism();
  const double scale = march.GetErrorScale();
  const bool thin = std::min(march.LayerSize[0], march.LayerSize[1]) < ThinLayer;
  for (const EffortRow& row : Efforts)
  {
    // Parallel lines a whole fraction of a pixel apart can meet the centres of all pixels.
    effort.Spacing = parallelism > 3.0 ? 1.0 / std::ceil(1.0 / row.Spacing - 1e-6) : row.Spacing;
    effort.SubrowReach = row.SubrowReach;
    if (thin)
    {
      effort.Spacing = std::min(effort.Spacing, ThinSpacing);
      effort.SubrowReach = EverywhereSubrows;
    }
    if (row.Error * scale <= tolerance)
    {
      return true;
    }
  }
  return false;
}

// Of a band, within the image; rows that are divided count as more.
double EstimatePixels(const SweepWedge& wedge, int band)
{
  const double low = wedge.FirstSlope + band * wedge.BandWidth;
  double pixels = 0.0;
  const std::size_t step = std::max<std::size_t>(1, wedge.Schedule.size() / 64);
  for (std::size_t i = 0; i < wedge.Schedule.size(); i += step)
  {
    const double s = wedge.Schedule[i].Distance;
    const double left = std::max(-1.0, wedge.LightColumn + low * s);
    const double right =
      std::min<double>(wedge.Columns, wedge.LightColumn + (low + wedge.BandWidth) * s);
    pixels += 16.0 + std::max(0.0, right - left);
  }
  return pixels * static_cast<double>(step);
}

// Run function(0) ... function(count - 1) on all threads, each once.
template <typename Function>
void RunTasks(vtkIdType count, vtkIdType grain, const Function& function)
{
  vtkSMPTools::For(0, count, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        function(static_cast<int>(i));
      }
    });
}

// The same in at most so many steps, before each of which the monitor is asked.
template <typename Function>
bool RunSteps(
  int count, int steps, const vtkGodRaysRadialSweep::Monitor& monitor, const Function& function)
{
  steps = monitor ? std::max(1, std::min(steps, count)) : 1;
  for (int i = 0; i < steps; ++i)
  {
    if (monitor && !monitor(static_cast<double>(i) / steps))
    {
      return false;
    }
    const int first = static_cast<int>(static_cast<std::int64_t>(count) * i / steps);
    const int end = static_cast<int>(static_cast<std::int64_t>(count) * (i + 1) / steps);
    RunTasks(end - first, 1, [&](int task) { function(first + task); });
  }
  return true;
}
}

// The work, and the memory that it needs again.
class vtkGodRaysRadialSweep::vtkInternals
{
public:
  Planes PrepareInput(int width, int height, int components)
  {
    this->Planned = this->Planned && width == this->Plan.Width && height == this->Plan.Height;
    this->Plan.Width = width;
    this->Plan.Height = height;
    this->Components = components;
    Planes planes;
    for (int c = 0; c < components; ++c)
    {
      this->Images[c].Resize(width, height);
      this->Images[c].Scale = 1.0f;
      planes.Values[c] = this->Images[c].GetRow(0);
      planes.Stride = this->Images[c].Stride;
    }
    return planes;
  }

  // scale: so that sums of the largest values stay finite.
  template <typename Scalar>
  void LoadInput(const Scalar* pixels, int width, int height, int components, float scale)
  {
    this->PrepareInput(width, height, components);
    for (int c = 0; c < components; ++c)
    {
      this->Images[c].Scale = scale;
    }
    RunTasks(height, 8,
      [&](int y)
      {
        const Scalar* row = pixels + static_cast<std::ptrdiff_t>(y) * width * components;
        for (int c = 0; c < components; ++c)
        {
          vtkGodRays::LoadPixels(row + c, components, width, scale, this->Images[c].GetRow(y));
        }
      });
  }

  bool Execute(const Parameters& parameters, const Monitor& monitor, int steps)
  {
    if (this->Components == 0)
    {
      return false;
    }
    if (!this->Planned || parameters != this->PlannedParameters)
    {
      this->MakePlan(parameters);
      this->PlannedParameters = parameters;
      this->Planned = true;
    }
    this->PointAtResults();
    if (!this->Sweeps)
    {
      return this->SumTaps(monitor, std::max(steps, 20));
    }
    return this->Sweep(monitor, steps);
  }

  void SetResult(int component, float* values) { this->Places[component] = values; }

  const float* GetResult(int component) const { return this->Targets[component].Values; }

  std::string Describe() const;

private:
  void MakePlan(const Parameters& parameters)
  {
    const int size[2] = { this->Plan.Width, this->Plan.Height };
    this->Plan.March = vtkGodRaysMarch(parameters, size, size, 1.0);
    this->IsKept = ChooseEffort(parameters.ErrorTolerance, this->Plan.March, this->Plan.Effort);
    this->Reason = "";
    this->Plan.NumberOfWedges = 0;
    if (parameters.Decay <= 0.0)
    {
      this->Reason = "decay 0 leaves the pixel itself";
      this->Sweeps = false;
    }
    else
    {
      this->Sweeps = this->ChoosesSweep(parameters.Method);
    }
  }

  bool ChoosesSweep(int method)
  {
    if (method == TAPS)
    {
      this->Reason = "as asked for";
      return false;
    }
    if (this->Plan.March.GetLongest() < vtkGodRaysMarch::ShortestSweep)
    {
      this->Reason = "the longest march is below 8 pixels";
      return false;
    }
    if (method == AUTOMATIC && this->Plan.March.IsSmall())
    {
      this->Reason = "the image is small";
      return false;
    }
    if (method == AUTOMATIC && !this->IsKept &&
      EstimateTaps(this->Plan.March, this->Plan.Effort.TapTolerance) <= MostTaps)
    {
      this->Reason = "the march is short for the tolerance";
      return false;
    }
    return vtkGodRays::PlanSweep(this->Plan, this->Reason);
  }

  void PointAtResults()
  {
    const std::size_t pixels = static_cast<std::size_t>(this->Plan.Width) * this->Plan.Height;
    for (int c = 0; c < this->Components; ++c)
    {
      if (!this->Places[c])
      {
        this->Results[c].resize(pixels);
      }
      float* values = this->Places[c] ? this->Places[c] : this->Results[c].data();
      this->Targets[c] = { values, this->Plan.Width };
    }
  }

  struct Task
  {
    const SweepWedge* Wedge;
    int Band;
    int Component; // the first one
    int Channels;
    int Strip; // of the axis, in this wedge and component
    double Cost;
  };

  // A row of the disc about the light.
  struct NearRow
  {
    int Y;
    int First;
    int Last;
    std::size_t Offset; // in NearPixels; components follow each other

    std::size_t GetWidth() const { return static_cast<std::size_t>(this->Last) - this->First + 1; }
  };

  // Three components are swept together, others one by one. Each band of lines writes pixels of
  // its own and has memory of its own.
  bool Sweep(const Monitor& monitor, int steps)
  {
    this->Strips.clear();
    this->Tasks.clear();
    for (int c = 0; c < this->Components;)
    {
      const int channels = this->Components - c >= 3 ? 3 : 1;
      for (int i = 0; i < this->Plan.NumberOfWedges; ++i)
      {
        const SweepWedge& wedge = this->Plan.Wedges[i];
        const int strip = static_cast<int>(this->Strips.size());
        this->Strips.push_back({ &wedge, 0, c, channels, strip, 0.0 });
        for (int band = 0; band < wedge.Bands; ++band)
        {
          this->Tasks.push_back({ &wedge, band, c, channels, strip, 0.0 });
        }
      }
      c += channels;
    }
    this->Axes.resize(std::max(this->Axes.size(), this->Strips.size()));
    this->Workspaces.resize(std::max(this->Workspaces.size(), this->Tasks.size()));
    this->FindNearRows();
    this->SortTasks();
    const int strips = static_cast<int>(this->Strips.size());
    RunTasks(strips + static_cast<vtkIdType>(this->NearRows.size()), 1,
      [this, strips](int i)
      {
        if (i >= strips)
        {
          this->SumTapsNearLight(this->NearRows[i - strips]);
          return;
        }
        const Task& task = this->Strips[i];
        vtkGodRays::SweepAxis(
          this->Plan, *task.Wedge, this->Images + task.Component, task.Channels, this->Axes[i]);
      });
    if (!RunSteps(static_cast<int>(this->Tasks.size()), steps, monitor,
          [this](int i)
          {
            const Task& task = this->Tasks[i];
            vtkGodRays::SweepBand(this->Plan, *task.Wedge, task.Band, this->Images + task.Component,
              task.Channels, this->Axes[task.Strip], this->Workspaces[i],
              this->Targets + task.Component);
          }))
    {
      return false;
    }
    this->WriteNearRows();
    return true;
  }

  // The longest ones first, so that threads end together.
  void SortTasks()
  {
    for (Task& task : this->Tasks)
    {
      task.Cost = task.Channels * EstimatePixels(*task.Wedge, task.Band);
    }
    std::sort(this->Tasks.begin(), this->Tasks.end(),
      [](const Task& a, const Task& b)
      { return std::tie(b.Cost, a.Strip, a.Band) < std::tie(a.Cost, b.Strip, b.Band); });
  }

  // The disc about the light where lines are too close together to matter: rows of its pixels.
  void FindNearRows()
  {
    const double* light = this->Plan.Light;
    const double radius = this->Plan.NearRadius;
    this->NearRows.clear();
    const double low = std::max(std::ceil(light[1] - radius), 0.0);
    const double high = std::min(std::floor(light[1] + radius), this->Plan.Height - 1.0);
    std::size_t size = 0;
    for (double y = low; y <= high; y += 1.0)
    {
      const double reach =
        std::sqrt(std::max(0.0, radius * radius - (y - light[1]) * (y - light[1])));
      const double left = std::max(std::ceil(light[0] - reach), 0.0);
      const double right = std::min(std::floor(light[0] + reach), this->Plan.Width - 1.0);
      if (left <= right)
      {
        this->NearRows.push_back(
          { static_cast<int>(y), static_cast<int>(left), static_cast<int>(right), size });
        size += this->NearRows.back().GetWidth() * this->Components;
      }
    }
    this->NearPixels.resize(std::max(this->NearPixels.size(), size));
  }

  // Bands write these pixels, too: so later.
  void SumTapsNearLight(const NearRow& row)
  {
    for (int c = 0; c < this->Components; ++c)
    {
      this->SumTapsInRow(
        c, row.Y, row.First, row.Last, this->NearPixels.data() + row.Offset + c * row.GetWidth());
    }
  }

  void WriteNearRows()
  {
    for (const NearRow& row : this->NearRows)
    {
      for (int c = 0; c < this->Components; ++c)
      {
        std::copy_n(this->NearPixels.data() + row.Offset + c * row.GetWidth(), row.GetWidth(),
          this->GetTarget(c, row.Y) + row.First);
      }
    }
  }

  bool SumTaps(const Monitor& monitor, int steps)
  {
    return RunSteps(this->Plan.Height, steps, monitor,
      [this](int y)
      {
        for (int c = 0; c < this->Components; ++c)
        {
          this->SumTapsInRow(c, y, 0, this->Plan.Width - 1, this->GetTarget(c, y));
        }
      });
  }

  void SumTapsInRow(int component, int y, int first, int last, float* to)
  {
    vtkGodRays::SumClippedTaps(this->Plan.March, this->Images[component],
      this->Plan.Effort.TapTolerance, y, first, last, to);
  }

  float* GetTarget(int component, int y) const
  {
    const SweepResult& target = this->Targets[component];
    return target.Values + y * target.Stride;
  }

  SweepPlan Plan;
  Parameters PlannedParameters;
  bool Planned = false;
  bool Sweeps = false;
  bool IsKept = false; // the tolerance, by the sweep
  const char* Reason = "";
  int Components = 0;
  SweepImage Images[MaximumComponents];
  SweepResult Targets[MaximumComponents] = {};
  float* Places[MaximumComponents] = {};
  std::vector<float> Results[MaximumComponents];
  std::vector<Task> Tasks;
  std::vector<Task> Strips;
  std::vector<NearRow> NearRows;
  std::vector<float> NearPixels;
  std::vector<SweepWorkspace> Workspaces;
  std::vector<SweepWorkspace> Axes; // of the axis strips
};

std::string vtkGodRaysRadialSweep::vtkInternals::Describe() const
{
  std::ostringstream text;
  if (!this->Planned)
  {
    return "nothing has been computed";
  }
  const SweepEffort& effort = this->Plan.Effort;
  text << this->Plan.Width << " x " << this->Plan.Height << " pixels, " << this->Components
       << (this->Components == 1 ? " component: " : " components: ");
  if (this->Plan.NumberOfWedges == 0)
  {
    text << "taps, because " << this->Reason;
    return text.str();
  }
  int bands = 0;
  bool tail = false;
  for (int i = 0; i < this->Plan.NumberOfWedges; ++i)
  {
    bands += this->Plan.Wedges[i].Bands;
    tail = tail || this->Plan.Wedges[i].HasTail;
  }
  text << "sweep " << (this->Plan.Density > 0.0 ? "away from" : "towards") << " the light, "
       << this->Plan.Kernel.Count << " running sums (error of the kernel at most "
       << this->Plan.Kernel.Bound << "), lines " << effort.Spacing << " pixels apart, "
       << (effort.SubrowReach < EverywhereSubrows ? "rows near the light" : "all rows")
       << " divided, taps within " << this->Plan.NearRadius << ", "
       << (tail ? "history, " : "no history, ") << bands << " bands in "
       << this->Plan.NumberOfWedges << " wedges";
  if (!this->IsKept)
  {
    text << "; on noise, the tolerance is not kept";
  }
  return text.str();
}

bool vtkGodRaysRadialSweep::Parameters::operator==(const Parameters& other) const
{
  return this->Density == other.Density && this->Decay == other.Decay &&
    this->Weight == other.Weight && this->Exposure == other.Exposure &&
    this->NumberOfSamples == other.NumberOfSamples &&
    std::equal(this->LightClip, this->LightClip + 3, other.LightClip) &&
    this->MarchScale == other.MarchScale && this->ErrorTolerance == other.ErrorTolerance &&
    this->Method == other.Method;
}

vtkGodRaysRadialSweep::vtkGodRaysRadialSweep()
  : Internals(new vtkInternals)
{
}

vtkGodRaysRadialSweep::~vtkGodRaysRadialSweep() = default;

vtkGodRaysRadialSweep::Planes vtkGodRaysRadialSweep::PrepareInput(
  int width, int height, int components)
{
  return this->Internals->PrepareInput(width, height, components);
}

void vtkGodRaysRadialSweep::LoadInput(
  const unsigned char* pixels, int width, int height, int components)
{
  this->Internals->LoadInput(pixels, width, height, components, 1.0f);
}

void vtkGodRaysRadialSweep::LoadInput(const float* pixels, int width, int height, int components)
{
  this->Internals->LoadInput(pixels, width, height, components, ScaleOfFloats);
}

void vtkGodRaysRadialSweep::LoadInput(const double* pixels, int width, int height, int components)
{
  this->Internals->LoadInput(pixels, width, height, components, ScaleOfFloats);
}

void vtkGodRaysRadialSweep::SetResult(int component, float* values)
{
  this->Internals->SetResult(component, values);
}

bool vtkGodRaysRadialSweep::Execute(const Parameters& parameters, const Monitor& monitor, int steps)
{
  return this->Internals->Execute(parameters, monitor, steps);
}

const float* vtkGodRaysRadialSweep::GetResult(int component) const
{
  return this->Internals->GetResult(component);
}

std::string vtkGodRaysRadialSweep::Describe() const
{
  return this->Internals->Describe();
}
