// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysScatteringFilter.h"

#include "vtkFloatArray.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSectorSweep.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSweepKernels.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysScatteringFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysScatteringFilter, ErrorTolerance, 1e-5, 0.1);

namespace
{
using vtkGodRays::SweepEffort;
using vtkGodRays::SweepImage;
using vtkGodRays::SweepMarch;
using vtkGodRays::SweepPlan;
using vtkGodRays::SweepResult;
using vtkGodRays::SweepWedge;
using vtkGodRays::SweepWorkspace;

// Below these the sweep is not faster, or not as accurate, as taps.
constexpr double ShortestMarch = 8.0; // [pixels]
constexpr int SmallestImage = 32;     // [pixels]

//------------------------------------------------------------------------------
// What the parameters mean in pixels. An infinite k, no march: the pixel itself, times Gain.
SweepMarch MakeMarch(vtkGodRaysScatteringFilter* filter, int width, int height)
{
  const double logarithm = std::log(filter->GetDecay());
  const int n = filter->GetNumberOfSamples();
  const double samples = logarithm == 0.0 ? n : std::expm1(n * logarithm) / std::expm1(logarithm);
  const double* light = filter->GetLightClip();
  const vtkGodRays::Vec3 lightClip(light[0], light[1], light[2]);
  const double size[2] = { static_cast<double>(width), static_cast<double>(height) };

  SweepMarch march;
  march.Gain = filter->GetExposure() * filter->GetWeight() * samples;
  march.K = -n * logarithm;
  // The march is linear in the pixel: known from that at the picture's centre, where ndc is 0.
  const vtkGodRays::Vec2 center =
    vtkGodRays::MarchVector(lightClip, vtkGodRays::Vec2(0.0), filter->GetMarchScale());
  march.Slope = filter->GetDensity() * filter->GetMarchScale() * light[2];
  for (int i = 0; i < 2; ++i)
  {
    march.Constant[i] =
      filter->GetDensity() * center[i] * size[i] + march.Slope * 0.5 * (size[i] - 1.0);
  }
  return march;
}

//------------------------------------------------------------------------------
// What each effort attains on black and white noise from pixel to pixel: root mean square error
// [fraction of the peak] times the root of the number of pixels that are summed. Measured; see
// Documentation/Accuracy.md.
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

//------------------------------------------------------------------------------
// How many pixels are summed, in the mean [pixels]. Steep kernels sum fewer.
double EstimateSummedPixels(const SweepMarch& march, int width, int height)
{
  double sum = 0.0;
  const double points[5][2] = { { 0.5, 0.5 }, { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  for (const double* point : points)
  {
    sum += std::hypot(march.Constant[0] - march.Slope * point[0] * (width - 1),
      march.Constant[1] - march.Slope * point[1] * (height - 1));
  }
  const double length = std::min(0.2 * sum, 0.4 * std::sqrt(static_cast<double>(width) * height));
  return std::max(1.0, length / std::sqrt(std::max(1.0, std::abs(march.K))));
}

//------------------------------------------------------------------------------
// From 1 for a light in the picture to 4 for parallel rays, whose lines come no closer together
// away from where they are farthest apart.
double EstimateParallelism(const SweepMarch& march, int width, int height)
{
  const double size[2] = { static_cast<double>(width), static_cast<double>(height) };
  double nearest = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double low = march.Constant[i];
    const double high = march.Constant[i] - march.Slope * (size[i] - 1.0);
    nearest = std::max(nearest, low * high > 0.0 ? std::min(std::abs(low), std::abs(high)) : 0.0);
    farthest = std::max({ farthest, std::abs(low), std::abs(high) });
  }
  return 1.0 + (farthest > 0.0 ? 3.0 * nearest / farthest : 0.0);
}

//------------------------------------------------------------------------------
// The least effort that keeps the tolerance; false if none does.
bool ChooseEffort(
  double tolerance, const SweepMarch& march, int width, int height, SweepEffort& effort)
{
  effort.FitTolerance = 0.4 * tolerance;
  effort.TapTolerance = tolerance;
  const double parallelism = EstimateParallelism(march, width, height);
  // A kernel that grows gives the far end of the march more weight, where errors are as large.
  const double growth = std::exp(0.5 * std::min(std::max(-march.K, 0.0), 4.0));
  const double scale = growth * parallelism / std::sqrt(EstimateSummedPixels(march, width, height));
  for (const EffortRow& row : Efforts)
  {
    // Parallel lines a whole fraction of a pixel apart can meet the centres of all pixels.
    effort.Spacing = parallelism > 2.0 ? 1.0 / std::ceil(1.0 / row.Spacing - 1e-6) : row.Spacing;
    effort.SubrowReach = row.SubrowReach;
    if (row.Error * scale <= tolerance)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
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
}

//------------------------------------------------------------------------------
// The work, and the memory that it needs again.
class vtkGodRaysScatteringFilter::vtkInternals
{
public:
  // Fills results from scalars, both of size[0] x size[1] pixels.
  void Execute(vtkGodRaysScatteringFilter* filter, vtkDataArray* scalars, const int size[2],
    vtkFloatArray* results)
  {
    this->Components = scalars->GetNumberOfComponents();
    this->Plan.Width = size[0];
    this->Plan.Height = size[1];
    this->Plan.March = MakeMarch(filter, size[0], size[1]);
    this->IsKept = ChooseEffort(
      filter->GetErrorTolerance(), this->Plan.March, size[0], size[1], this->Plan.Effort);
    this->Reason = "";

    this->PointAtResults(results);
    this->LoadImages(scalars);
    if (std::isinf(this->Plan.March.K))
    {
      this->Reason = "decay 0 leaves the pixel itself";
      this->Plan.March.K = 0.0;
      this->Plan.March.Slope = this->Plan.March.Constant[0] = this->Plan.March.Constant[1] = 0.0;
      this->SumTaps();
    }
    else if (this->ChoosesSweep(filter->GetMethod()))
    {
      this->Sweep();
      this->SumTapsNearLight();
    }
    else
    {
      this->SumTaps();
    }
    this->InterleaveResults(results);
  }

  // The memory of the results is used again if nobody else has it any more.
  vtkFloatArray* GetResults(int components, vtkIdType pixels, const char* name)
  {
    if (!this->Results || this->Results->GetReferenceCount() > 1)
    {
      this->Results = vtkSmartPointer<vtkFloatArray>::New();
    }
    this->Results->SetNumberOfComponents(components);
    this->Results->SetNumberOfTuples(pixels);
    this->Results->SetName(name);
    return this->Results;
  }

  std::string Describe() const;

private:
  bool ChoosesSweep(int method)
  {
    const int size = std::min(this->Plan.Width, this->Plan.Height);
    this->Plan.NumberOfWedges = 0;
    if (method == TAPS)
    {
      this->Reason = "as asked for";
      return false;
    }
    if (vtkGodRays::GetLongestMarch(this->Plan.March, this->Plan.Width, this->Plan.Height) <
      ShortestMarch)
    {
      this->Reason = "the longest march is below 8 pixels";
      return false;
    }
    if (method == AUTOMATIC && (size < SmallestImage || !this->IsKept))
    {
      this->Reason = this->IsKept ? "the image is small" : "the march is short for the tolerance";
      return false;
    }
    return vtkGodRays::PlanSweep(this->Plan, this->Reason);
  }

  // One component is summed in place, others one by one.
  void PointAtResults(vtkFloatArray* results)
  {
    const int width = this->Plan.Width;
    const std::size_t pixels = static_cast<std::size_t>(width) * this->Plan.Height;
    if (this->Components == 1)
    {
      this->Targets[0] = { results->GetPointer(0), width };
      return;
    }
    this->Planes.resize(pixels * this->Components);
    for (int c = 0; c < this->Components; ++c)
    {
      this->Targets[c] = { this->Planes.data() + c * pixels, width };
    }
  }

  void InterleaveResults(vtkFloatArray* results)
  {
    const int components = this->Components;
    if (components == 1)
    {
      return;
    }
    float* to = results->GetPointer(0);
    const int width = this->Plan.Width;
    RunTasks(this->Plan.Height, 8,
      [&](int y)
      {
        for (int c = 0; c < components; ++c)
        {
          const SweepResult& target = this->Targets[c];
          const float* from = target.Values + y * target.Stride;
          float* row = to + static_cast<std::ptrdiff_t>(y) * width * components + c;
          for (int x = 0; x < width; ++x)
          {
            row[x * components] = from[x];
          }
        }
      });
  }

  void LoadImages(vtkDataArray* scalars)
  {
    for (int c = 0; c < this->Components; ++c)
    {
      this->Images[c].Resize(this->Plan.Width, this->Plan.Height);
    }
    void* pixels = scalars->GetVoidPointer(0);
    switch (scalars->GetDataType())
    {
      case VTK_UNSIGNED_CHAR:
        return this->LoadRows(static_cast<const unsigned char*>(pixels));
      case VTK_FLOAT:
        return this->LoadRows(static_cast<const float*>(pixels));
      default:
        return this->LoadRows(static_cast<const double*>(pixels));
    }
  }

  template <typename Scalar>
  void LoadRows(const Scalar* pixels)
  {
    const int width = this->Plan.Width;
    RunTasks(this->Plan.Height, 8,
      [&](int y)
      {
        const Scalar* row = pixels + static_cast<std::ptrdiff_t>(y) * width * this->Components;
        for (int c = 0; c < this->Components; ++c)
        {
          vtkGodRays::LoadPixels(row + c, this->Components, width, this->Images[c].GetRow(y));
        }
      });
  }

  // Each band of lines writes pixels of its own and has memory of its own.
  void Sweep()
  {
    struct Task
    {
      const SweepWedge* Wedge;
      int Band;
      int Component;
    };
    std::vector<Task> tasks;
    for (int i = 0; i < this->Plan.NumberOfWedges; ++i)
    {
      const SweepWedge& wedge = this->Plan.Wedges[i];
      for (int band = 0; band < wedge.Bands; ++band)
      {
        for (int c = 0; c < this->Components; ++c)
        {
          tasks.push_back({ &wedge, band, c });
        }
      }
    }
    if (this->Workspaces.size() < tasks.size())
    {
      this->Workspaces.resize(tasks.size());
    }
    RunTasks(static_cast<vtkIdType>(tasks.size()), 1,
      [&](int i)
      {
        const Task& task = tasks[i];
        vtkGodRays::SweepBand(this->Plan, *task.Wedge, task.Band, this->Images[task.Component],
          this->Workspaces[i], this->Targets[task.Component]);
      });
  }

  // The disc about the light where lines are too close together to matter.
  void SumTapsNearLight()
  {
    const double* light = this->Plan.Light;
    const double radius = this->Plan.NearRadius;
    const int width = this->Plan.Width;
    const double low = std::max(std::ceil(light[1] - radius), 0.0);
    const double high = std::min(std::floor(light[1] + radius), this->Plan.Height - 1.0);
    if (!(low <= high))
    {
      return;
    }
    const int first = static_cast<int>(low);
    RunTasks(static_cast<vtkIdType>(high) - first + 1, 2,
      [&](int i)
      {
        const int y = first + i;
        const double reach =
          std::sqrt(std::max(0.0, radius * radius - (y - light[1]) * (y - light[1])));
        const double left = std::max(std::ceil(light[0] - reach), 0.0);
        const double right = std::min(std::floor(light[0] + reach), width - 1.0);
        if (left <= right)
        {
          this->SumTapsInRow(y, static_cast<int>(left), static_cast<int>(right));
        }
      });
  }

  void SumTaps()
  {
    RunTasks(this->Plan.Height, 1, [&](int y) { this->SumTapsInRow(y, 0, this->Plan.Width - 1); });
  }

  void SumTapsInRow(int y, int first, int last)
  {
    for (int c = 0; c < this->Components; ++c)
    {
      vtkGodRays::SumClippedTaps(this->Plan.March, this->Images[c], this->Plan.Effort.TapTolerance,
        y, first, last, this->Targets[c]);
    }
  }

  SweepPlan Plan;
  const char* Reason = "";
  int Components = 0;
  bool IsKept = false; // the tolerance, by the sweep
  SweepImage Images[MaximumComponents];
  SweepResult Targets[MaximumComponents] = {};
  std::vector<float> Planes;
  std::vector<SweepWorkspace> Workspaces;
  vtkSmartPointer<vtkFloatArray> Results;
};

//------------------------------------------------------------------------------
std::string vtkGodRaysScatteringFilter::vtkInternals::Describe() const
{
  std::ostringstream text;
  if (this->Components == 0)
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
  return text.str();
}

//------------------------------------------------------------------------------
vtkGodRaysScatteringFilter::vtkGodRaysScatteringFilter()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysScatteringFilter::~vtkGodRaysScatteringFilter() = default;

//------------------------------------------------------------------------------
void vtkGodRaysScatteringFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Plan: " << this->GetPlan() << "\n";
}

//------------------------------------------------------------------------------
std::string vtkGodRaysScatteringFilter::GetPlan() const
{
  return this->Internals->Describe();
}

//------------------------------------------------------------------------------
void vtkGodRaysScatteringFilter::ReleaseMemory()
{
  this->Internals.reset(new vtkInternals);
}

//------------------------------------------------------------------------------
int vtkGodRaysScatteringFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* outputInfo = output->GetInformationObject(0);
  if (input[0]->GetNumberOfInformationObjects() == 0)
  {
    const int none[6] = { 0, -1, 0, -1, 0, -1 };
    outputInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), none, 6);
    return 1;
  }
  vtkInformation* scalars = this->GetInputArrayFieldInformation(0, input);
  const bool known = scalars && scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  vtkDataObject::SetPointDataActiveScalarInfo(
    outputInfo, VTK_FLOAT, known ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) : 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGodRaysScatteringFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkImageData* result = vtkImageData::GetData(output);
  vtkDataArray* scalars = image ? this->GetInputArrayToProcess(0, input) : nullptr;
  const std::string fault = FindFault(image, scalars);
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute rays: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  }

  int dimensions[3];
  image->GetDimensions(dimensions);
  result->Initialize(); // lets go of the memory that is to be used again
  result->SetExtent(image->GetExtent());
  result->SetSpacing(image->GetSpacing());
  result->SetOrigin(image->GetOrigin());
  vtkFloatArray* results = this->Internals->GetResults(
    scalars->GetNumberOfComponents(), scalars->GetNumberOfTuples(), scalars->GetName());
  result->GetPointData()->SetScalars(results);
  this->Internals->Execute(this, scalars, dimensions, results);
  results->Modified();
  return 1;
}
