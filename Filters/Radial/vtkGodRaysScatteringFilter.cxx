// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysScatteringFilter.h"

#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkGodRaysRadialSweep.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkGodRaysScatteringFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysScatteringFilter, ErrorTolerance, 1e-5, 0.1);

static_assert(static_cast<int>(vtkGodRaysScatteringFilter::AUTOMATIC) ==
      static_cast<int>(vtkGodRaysRadialSweep::AUTOMATIC) &&
    static_cast<int>(vtkGodRaysScatteringFilter::SWEEP) ==
      static_cast<int>(vtkGodRaysRadialSweep::SWEEP) &&
    static_cast<int>(vtkGodRaysScatteringFilter::TAPS) ==
      static_cast<int>(vtkGodRaysRadialSweep::TAPS),
  "the two lists of methods");
static_assert(
  vtkGodRaysRadialFilter::MaximumComponents == vtkGodRaysRadialSweep::MaximumComponents, "");

// The sweep, and the results between VTK and it.
class vtkGodRaysScatteringFilter::vtkInternals
{
public:
  static constexpr int MostSteps = 20;

  // Fills results from scalars, both of size[0] x size[1] pixels.
  // Returns false if it was told to stop.
  bool Execute(vtkGodRaysScatteringFilter* filter, vtkDataArray* scalars, const int size[2],
    vtkFloatArray* results)
  {
    const int components = scalars->GetNumberOfComponents();
    this->Load(scalars, size, components);
    // One component is summed in place.
    this->Sweep.SetResult(0, components == 1 ? results->GetPointer(0) : nullptr);
    auto monitor = [filter](double progress) { return filter->TellProgress(progress); };
    const int steps = filter->HasObserver(vtkCommand::ProgressEvent) ? MostSteps : 1;
    if (!this->Sweep.Execute(GetParameters(filter), monitor, steps))
    {
      return false;
    }
    if (components > 1)
    {
      this->Interleave(size, components, results->GetPointer(0));
    }
    return filter->TellProgress(1.0);
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

  std::string Describe() const { return this->Sweep.Describe(); }

private:
  static vtkGodRaysRadialSweep::Parameters GetParameters(vtkGodRaysScatteringFilter* filter)
  {
    vtkGodRaysRadialSweep::Parameters parameters;
    parameters.Density = filter->Density;
    parameters.Decay = filter->Decay;
    parameters.Weight = filter->Weight;
    parameters.Exposure = filter->Exposure;
    parameters.NumberOfSamples = filter->NumberOfSamples;
    std::copy_n(filter->LightClip, 3, parameters.LightClip);
    parameters.MarchScale = filter->MarchScale;
    parameters.ErrorTolerance = filter->ErrorTolerance;
    parameters.Method = filter->Method;
    return parameters;
  }

  void Load(vtkDataArray* scalars, const int size[2], int components)
  {
    void* pixels = scalars->GetVoidPointer(0);
    switch (scalars->GetDataType())
    {
      case VTK_UNSIGNED_CHAR:
        this->Sweep.LoadInput(
          static_cast<const unsigned char*>(pixels), size[0], size[1], components);
        break;
      case VTK_FLOAT:
        this->Sweep.LoadInput(static_cast<const float*>(pixels), size[0], size[1], components);
        break;
      default:
        this->Sweep.LoadInput(static_cast<const double*>(pixels), size[0], size[1], components);
    }
  }

  void Interleave(const int size[2], int components, float* to)
  {
    const vtkIdType width = size[0];
    vtkSMPTools::For(0, size[1], 8,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int c = 0; c < components; ++c)
        {
          const float* from = this->Sweep.GetResult(c);
          for (vtkIdType i = begin * width; i < end * width; ++i)
          {
            to[i * components + c] = from[i];
          }
        }
      });
  }

  vtkGodRaysRadialSweep Sweep;
  vtkSmartPointer<vtkFloatArray> Results;
};

vtkGodRaysScatteringFilter::vtkGodRaysScatteringFilter()
  : Internals(new vtkInternals)
{
}

vtkGodRaysScatteringFilter::~vtkGodRaysScatteringFilter() = default;

void vtkGodRaysScatteringFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Plan: " << this->GetPlan() << "\n";
}

std::string vtkGodRaysScatteringFilter::GetPlan() const
{
  return this->Internals->Describe();
}

void vtkGodRaysScatteringFilter::ReleaseMemory()
{
  this->Internals.reset(new vtkInternals);
}

int vtkGodRaysScatteringFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkImageData* result = vtkImageData::GetData(output);
  vtkDataArray* scalars = this->GetUsableScalars(input, output);
  if (!scalars)
  {
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
  if (this->Internals->Execute(this, scalars, dimensions, results))
  {
    results->Modified();
  }
  else
  {
    result->Initialize();
  }
  return 1;
}
