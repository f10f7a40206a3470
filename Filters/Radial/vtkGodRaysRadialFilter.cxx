// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialFilter.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkGodRaysProgress.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkGodRaysSetFiniteMacro(vtkGodRaysRadialFilter, Density, 0.0, 2.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialFilter, Decay, 0.0, 1.05);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialFilter, Weight, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialFilter, Exposure, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialFilter, MarchScale, -1e30, 1e30);

namespace
{
constexpr double LargestClip = 1e30; // with the march scale's: its products stay finite

// Why an input cannot be used, and what to do; empty if it can.
std::string FindFault(vtkImageData* input, vtkDataArray* scalars)
{
  if (!input)
  {
    return "there is no input. Connect an image with SetInputConnection() or SetInputData().";
  }
  int dimensions[3];
  input->GetDimensions(dimensions);
  const std::string size = std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) +
    " x " + std::to_string(dimensions[2]);
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] < 1)
  {
    return "the input is empty: it has " + size + " points. Update what makes it, or allocate it.";
  }
  if (dimensions[2] != 1)
  {
    return "the input is not a picture in x and y: it has " + size +
      " points. Cut out one slice with vtkExtractVOI, or turn it with vtkImagePermute.";
  }
  if (!scalars)
  {
    return "the input has no scalars. Make an array of its point data the active one, or name it "
           "with SetInputArrayToProcess().";
  }
  const std::string array =
    scalars->GetName() ? "the array \"" + std::string(scalars->GetName()) + "\"" : "the array";
  if (scalars->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    return array + " has " + std::to_string(scalars->GetNumberOfTuples()) +
      " values for an image of " + size + " points. Take an array of the point data.";
  }
  const int type = scalars->GetDataType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    return array + " is of type " + scalars->GetDataTypeAsString() +
      ", and only unsigned char, float and double can be summed. Convert it with vtkImageCast or "
      "vtkImageShiftScale.";
  }
  if (scalars->GetNumberOfComponents() < 1 ||
    scalars->GetNumberOfComponents() > vtkGodRaysRadialFilter::MaximumComponents)
  {
    return array + " has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, and only 1 to 4 can be summed. Take some with vtkImageExtractComponents.";
  }
  return {};
}
}

void vtkGodRaysRadialFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Decay: " << this->Decay << "\n";
  os << indent << "Weight: " << this->Weight << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "LightClip: " << this->LightClip[0] << " " << this->LightClip[1] << " "
     << this->LightClip[2] << "\n";
  os << indent << "MarchScale: " << this->MarchScale << "\n";
}

void vtkGodRaysRadialFilter::SetLightClip(double x, double y, double w)
{
  if (!vtkMath::IsFinite(x) || !vtkMath::IsFinite(y) || !vtkMath::IsFinite(w))
  {
    vtkErrorMacro("LightClip must be three finite numbers in ["
      << -LargestClip << ", " << LargestClip << "], not (" << x << ", " << y << ", " << w
      << "); it stays (" << this->LightClip[0] << ", " << this->LightClip[1] << ", "
      << this->LightClip[2] << ").");
    return;
  }
  const double light[3] = { x, y, w };
  for (int i = 0; i < 3; ++i)
  {
    const double clamped = vtkMath::ClampValue(light[i], -LargestClip, LargestClip);
    if (this->LightClip[i] != clamped)
    {
      this->LightClip[i] = clamped;
      this->Modified();
    }
  }
}

void vtkGodRaysRadialFilter::SetLightPosition(double u, double v)
{
  if (!vtkMath::IsFinite(u) || !vtkMath::IsFinite(v))
  {
    vtkErrorMacro("The light's position must be two finite numbers, not ("
      << u << ", " << v << "); it stays where it is.");
    return;
  }
  this->SetLightClip(2.0 * u - 1.0, 2.0 * v - 1.0, 1.0);
  this->SetMarchScale(1.0);
}

void vtkGodRaysRadialFilter::SetLightDirection(double du, double dv)
{
  if (!vtkMath::IsFinite(du) || !vtkMath::IsFinite(dv))
  {
    vtkErrorMacro("The light's direction must be two finite numbers, not ("
      << du << ", " << dv << "); it stays as it is.");
    return;
  }
  this->SetLightClip(2.0 * du, 2.0 * dv, 0.0);
  this->SetMarchScale(1.0);
}

int vtkGodRaysRadialFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  // Optional, so that it is this filter that tells what to do without one.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkGodRaysRadialFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkGodRaysRadialFilter::RequestInformation(
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
  vtkDataObject::SetPointDataActiveScalarInfo(outputInfo, this->GetResultType(),
    known ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) : 1);
  return 1;
}

int vtkGodRaysRadialFilter::RequestUpdateExtent(
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

vtkDataArray* vtkGodRaysRadialFilter::GetUsableScalars(
  vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkDataArray* scalars = image ? this->GetInputArrayToProcess(0, input) : nullptr;
  const std::string fault = FindFault(image, scalars);
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute rays: " << fault);
    vtkImageData::GetData(output)->Initialize();
    return nullptr;
  }
  return scalars;
}

bool vtkGodRaysRadialFilter::TellProgress(double progress)
{
  return vtkGodRays::TellProgress(this, progress);
}
