// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageFilter.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGodRaysCoverageSweep.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysCoverageFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysCoverageFilter, Thickness, 0.0, 1.0);

namespace
{
using Sweep = vtkGodRaysCoverageSweep;

// Planes of positive depths.
template <typename Scalar>
void Load(const Scalar* values, int components, vtkIdType pixels, float* const* planes)
{
  vtkSMPTools::For(0, pixels, 1 << 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int c = 0; c < components; ++c)
      {
        float* plane = planes[c];
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Scalar z = values[i * components + c];
          // false for NaN
          plane[i] = z > 0 && z < Sweep::Sky ? static_cast<float>(z) : Sweep::Sky;
        }
      }
    });
}

void Load(vtkDataArray* depths, float* const* planes)
{
  const int components = depths->GetNumberOfComponents();
  const vtkIdType pixels = depths->GetNumberOfTuples();
  const void* values = depths->GetVoidPointer(0);
  if (depths->GetDataType() == VTK_FLOAT)
  {
    Load(static_cast<const float*>(values), components, pixels, planes);
  }
  else
  {
    Load(static_cast<const double*>(values), components, pixels, planes);
  }
}

bool IsReal(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}
}

vtkGodRaysCoverageFilter::vtkGodRaysCoverageFilter()
  : Sweep(new vtkGodRaysCoverageSweep)
{
}

vtkGodRaysCoverageFilter::~vtkGodRaysCoverageFilter() = default;

void vtkGodRaysCoverageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "EndArrayName: " << this->EndArrayName << "\n";
  os << indent << "Plan: " << this->GetPlan() << "\n";
}

std::string vtkGodRaysCoverageFilter::GetPlan() const
{
  return this->Sweep->Describe();
}

long long vtkGodRaysCoverageFilter::GetNumberOfOverflows() const
{
  return this->Sweep->GetNumberOfOverflows();
}

int vtkGodRaysCoverageFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  // Optional, so that it is this filter that tells what to do without one.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkGodRaysCoverageFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  if (input[0]->GetNumberOfInformationObjects() == 0)
  {
    const int none[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), none, 6);
    return 1;
  }
  Sweep::Parameters parameters;
  std::copy_n(this->LightColor, 3, parameters.LightColor);
  parameters.Medium = this->GetMedium(this->GetView(1));
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, Sweep::CountComponents(parameters));
  return 1;
}

int vtkGodRaysCoverageFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // Any pixel may need all of the image.
  if (vtkInformation* info = input[0]->GetInformationObject(0))
  {
    int whole[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  }
  return 1;
}

int vtkGodRaysCoverageFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkImageData* result = vtkImageData::GetData(output);
  vtkDataArray* depths = image ? this->GetInputArrayToProcess(0, input) : nullptr;
  const auto fail = [&](const std::string& fault)
  {
    vtkErrorMacro("Cannot compute scattered light: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  };
  const std::string parameterFault = this->FindFault();
  if (!parameterFault.empty())
  {
    return fail(parameterFault);
  }
  if (!depths || depths->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    image->GetNumberOfPoints() == 0 || image->GetDimensions()[2] != 1)
  {
    return fail(
      "there is no depth image. Connect one slice in x and y of view depths as point data; name "
      "the array with SetInputArrayToProcess() unless it is the active one.");
  }
  const int components = depths->GetNumberOfComponents();
  if ((components != 1 && components != 2 && components != 4) || !IsReal(depths))
  {
    return fail("the depths are " + std::to_string(components) + " component(s) of type " +
      depths->GetDataTypeAsString() +
      ". Give 1, 2 or 4 components of float or double: the first surface, or fronts and backs of "
      "solid layers.");
  }
  vtkDataArray* ends = nullptr;
  if (!this->EndArrayName.empty())
  {
    ends = image->GetPointData()->GetArray(this->EndArrayName.c_str());
    if (!ends || ends->GetNumberOfComponents() != 1 || !IsReal(ends))
    {
      return fail("there is no array \"" + this->EndArrayName +
        "\" of one component of float or double. Set EndArrayName to where view rays end, or to "
        "nothing.");
    }
  }

  int dimensions[3];
  image->GetDimensions(dimensions);
  const View view = this->GetView(dimensions[1]);
  Sweep::Parameters parameters;
  parameters.PixelSize = view.PixelSize;
  parameters.Center[0] = 0.5 * dimensions[0];
  parameters.Center[1] = 0.5 * dimensions[1];
  parameters.Parallel = view.Parallel;
  double light[3];
  const double* axes[3] = { view.Right, view.Up, view.Forward };
  for (int i = 0; i < 3; ++i)
  {
    light[i] = this->Light[i] - this->Light[3] * view.Position[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    parameters.Light[i] = vtkMath::Dot(light, axes[i]);
  }
  parameters.Light[3] = this->Light[3];
  std::copy_n(this->LightColor, 3, parameters.LightColor);
  parameters.Medium = this->GetMedium(view);
  parameters.Spot = this->GetSpot(view);
  parameters.Layers = components / 2;
  parameters.Thickness = this->Thickness;

  const vtkIdType pixels = image->GetNumberOfPoints();
  const Sweep::Planes planes =
    this->Sweep->PrepareInput(dimensions[0], dimensions[1], components + (ends ? 1 : 0));
  Load(depths, planes.Values);
  if (ends)
  {
    Load(ends, planes.Values + components);
  }

  vtkNew<vtkFloatArray> radiances;
  radiances->SetName("Radiance");
  radiances->SetNumberOfComponents(Sweep::CountComponents(parameters));
  radiances->SetNumberOfTuples(pixels);
  this->Sweep->SetResult(radiances->GetPointer(0));
  if (!this->Sweep->Execute(
        parameters, [this](double progress) { return this->TellProgress(progress); }))
  {
    result->Initialize();
    return 1;
  }
  result->SetExtent(image->GetExtent());
  result->GetPointData()->SetScalars(radiances);
  return 1;
}
