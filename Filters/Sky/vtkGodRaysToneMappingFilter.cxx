// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysToneMappingFilter.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysToneMappingFilter);
vtkGodRaysSetFiniteMacro(vtkGodRaysToneMappingFilter, Key, 0.001, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysToneMappingFilter, Exposure, 0.0, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysToneMappingFilter, WhitePoint, 1.0, 1e15);

namespace
{
// What cannot be used, and what to do; empty if all can.
std::string FindFault(vtkDataArray* light)
{
  if (!light)
  {
    return "the picture has no scalars. Give vtkImageData with point scalars as the input.";
  }
  if (light->GetNumberOfComponents() == 2)
  {
    return "the scalars have 2 components. Give 1 (grey) or 3 (red, green, blue).";
  }
  return {};
}

vtkGodRays::Vec3 GetLight(vtkDataArray* light, vtkIdType pixel)
{
  const int green = light->GetNumberOfComponents() > 1 ? 1 : 0;
  const vtkGodRays::Vec3 value(light->GetComponent(pixel, 0), light->GetComponent(pixel, green),
    light->GetComponent(pixel, 2 * green));
  return vtkGodRays::Sanitize(value, 1e30);
}

// Key/geometric mean of the luminance of the pixels that have light; 1 if none has.
double FindExposure(vtkDataArray* light, double key)
{
  // Sums of blocks that do not depend on the threads.
  constexpr vtkIdType block = 4096;
  struct Sum
  {
    double Logarithms = 0.0;
    vtkIdType Pixels = 0;
  };
  const vtkIdType pixels = light->GetNumberOfTuples();
  std::vector<Sum> sums((pixels + block - 1) / block);
  vtkSMPTools::For(0, static_cast<vtkIdType>(sums.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        for (vtkIdType pixel = i * block; pixel < std::min(pixels, (i + 1) * block); ++pixel)
        {
          const double luminance = vtkGodRays::Luminance(GetLight(light, pixel));
          if (luminance > 0.0)
          {
            sums[i].Logarithms += std::log(luminance);
            ++sums[i].Pixels;
          }
        }
      }
    });
  Sum all;
  for (const Sum& sum : sums)
  {
    all.Logarithms += sum.Logarithms;
    all.Pixels += sum.Pixels;
  }
  return all.Pixels > 0 ? key / std::exp(all.Logarithms / static_cast<double>(all.Pixels)) : 1.0;
}
}

int vtkGodRaysToneMappingFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* scalars =
    vtkDataObject::GetActiveFieldInformation(input[0]->GetInformationObject(0),
      vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  const bool grey = scalars && scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) &&
    scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) == 1;
  vtkDataObject::SetPointDataActiveScalarInfo(
    output->GetInformationObject(0), VTK_UNSIGNED_CHAR, grey ? 1 : 3);
  return 1;
}

int vtkGodRaysToneMappingFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // The exposure is that of the whole picture.
  vtkInformation* info = input[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

int vtkGodRaysToneMappingFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* picture = vtkImageData::GetData(input[0]);
  vtkImageData* shown = vtkImageData::GetData(output);
  vtkDataArray* light = picture->GetPointData()->GetScalars();
  const std::string fault = FindFault(light);
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot show the picture: " << fault);
    shown->Initialize();
    return 0;
  }
  this->UsedExposure = this->AutomaticExposure ? FindExposure(light, this->Key) : this->Exposure;

  shown->SetExtent(picture->GetExtent());
  shown->AllocateScalars(VTK_UNSIGNED_CHAR, light->GetNumberOfComponents() > 1 ? 3 : 1);
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(shown->GetPointData()->GetScalars());
  bytes->SetName(light->GetName());
  vtkSMPTools::For(0, light->GetNumberOfTuples(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType pixel = first; pixel < last; ++pixel)
      {
        vtkGodRays::Vec3 value =
          vtkGodRays::Sanitize(GetLight(light, pixel) * this->UsedExposure, 1e30);
        value = this->Curve == REINHARD ? vtkGodRays::ToneReinhard(value, 1.0 / this->WhitePoint)
                                        : glm::min(value, vtkGodRays::Vec3(1.0));
        value = vtkGodRays::EncodeDisplay(value);
        for (int c = 0; c < bytes->GetNumberOfComponents(); ++c)
        {
          bytes->SetTypedComponent(pixel, c, static_cast<unsigned char>(255.0 * value[c] + 0.5));
        }
      }
    });
  return 1;
}

double vtkGodRaysToneMappingFilter::Decode(double shown)
{
  return shown > 0.0 ? vtkGodRays::DecodeDisplay(shown) : 0.0;
}

void vtkGodRaysToneMappingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticExposure: " << (this->AutomaticExposure ? "on" : "off") << "\n";
  os << indent << "Key: " << this->Key << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Curve: " << this->Curve << "\n";
  os << indent << "WhitePoint: " << this->WhitePoint << "\n";
  os << indent << "UsedExposure: " << this->UsedExposure << "\n";
}
