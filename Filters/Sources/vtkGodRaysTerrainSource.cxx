// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTerrainSource.h"

#include "vtkGodRaysMemory.h"
#include "vtkGodRaysNoise.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSourceTools.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkGodRaysTerrainSource);

vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, Width, 1e-6, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, Height, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, Features, 0.01, 1000.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, Gain, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, Lacunarity, 1.0, 4.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, SnowHeight, -1.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysTerrainSource, RockSlope, 0.0, 90.0);

namespace
{
using vtkGodRaysNoise::Vector;

// Of the surface (x, y, h), where steepness is the gradient of h.
Vector GetNormal(double steepnessX, double steepnessY)
{
  const double length = std::hypot(steepnessX, steepnessY, 1.0);
  return { -steepnessX / length, -steepnessY / length, 1.0 / length };
}

// An array of the image, to be filled.
template <typename Array>
Array* AddArray(vtkImageData* image, const char* name, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
  return array;
}
}

vtkGodRaysTerrainSource::vtkGodRaysTerrainSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkGodRaysTerrainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "Octaves: " << this->Octaves << "\n";
  os << indent << "SmoothOctaves: " << this->SmoothOctaves << "\n";
  os << indent << "Gain: " << this->Gain << "\n";
  os << indent << "Lacunarity: " << this->Lacunarity << "\n";
  os << indent << "SnowHeight: " << this->SnowHeight << "\n";
  os << indent << "RockSlope: " << this->RockSlope << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

void vtkGodRaysTerrainSource::SetDimensions(int x, int y)
{
  const int dimensions[2] = { vtkMath::ClampValue(x, 2, 1000000),
    vtkMath::ClampValue(y, 2, 1000000) };
  if (!std::equal(dimensions, dimensions + 2, this->Dimensions))
  {
    std::copy_n(dimensions, 2, this->Dimensions);
    this->Modified();
  }
}

void vtkGodRaysTerrainSource::GetGrid(double origin[3], double spacing[3]) const
{
  std::fill_n(spacing, 3, this->Width / (this->Dimensions[0] - 1));
  origin[0] = -0.5 * this->Width;
  origin[1] = -0.5 * (this->Dimensions[1] - 1) * spacing[1];
  origin[2] = 0.0;
}

void vtkGodRaysTerrainSource::GetColor(double height, double upNormal, unsigned char color[3]) const
{
  constexpr double grass[3] = { 74.0, 92.0, 42.0 };
  constexpr double rock[3] = { 112.0, 100.0, 90.0 };
  constexpr double snow[3] = { 240.0, 244.0, 250.0 };
  // Snow begins over a twentieth of the height, rock over 10 degrees.
  const double bare = 1.0 -
    vtkGodRaysNoise::SmoothStep(
      std::cos(vtkMath::RadiansFromDegrees(std::min(this->RockSlope + 5.0, 90.0))),
      std::cos(vtkMath::RadiansFromDegrees(std::max(this->RockSlope - 5.0, 0.0))), upNormal);
  const double white = vtkGodRaysNoise::SmoothStep(
    (this->SnowHeight - 0.025) * this->Height, (this->SnowHeight + 0.025) * this->Height, height);
  for (int c = 0; c < 3; ++c)
  {
    const double soft = grass[c] + white * (snow[c] - grass[c]);
    color[c] = static_cast<unsigned char>(std::lround(soft + bare * (rock[c] - soft)));
  }
}

int vtkGodRaysTerrainSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* information = output->GetInformationObject(0);
  double origin[3];
  double spacing[3];
  this->GetGrid(origin, spacing);
  const int extent[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0, 0 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  information->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkGodRaysTerrainSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(output);
  int extent[6];
  output->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  double origin[3];
  double spacing[3];
  this->GetGrid(origin, spacing);
  constexpr double bytes = 35.0; // of a point
  const std::string fault = vtkGodRays::FindMemoryFault(
    bytes * (extent[1] - extent[0] + 1.0) * (extent[3] - extent[2] + 1.0), "Dimensions");
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute a terrain: " << fault);
    image->Initialize();
    return 1; // the executive would only add that something failed
  }
  image->SetExtent(extent);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  auto* heights = AddArray<vtkFloatArray>(image, "Height", 1);
  auto* normals = AddArray<vtkFloatArray>(image, "Normals", 3);
  auto* smoothNormals = AddArray<vtkFloatArray>(image, "SmoothNormals", 3);
  auto* shadows = AddArray<vtkFloatArray>(image, "SelfShadow", 1);
  auto* colors = AddArray<vtkUnsignedCharArray>(image, "Color", 3);
  image->GetPointData()->SetActiveScalars("Height");

  const vtkGodRaysNoise::Fractal fractal{ this->Octaves, this->Gain, this->Lacunarity,
    static_cast<unsigned int>(this->Seed) };
  const int smoothOctaves = std::min(this->SmoothOctaves, this->Octaves);
  const double scale = this->Features / this->Width;
  const double steepness = this->Height * scale;
  auto computeRows = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType row = begin; row < end; ++row)
    {
      const double y = origin[1] + static_cast<double>(extent[2] + row) * spacing[1];
      vtkIdType i = row * (extent[1] - extent[0] + 1);
      for (int column = extent[0]; column <= extent[1]; ++column, ++i)
      {
        const Vector position = { scale * (origin[0] + column * spacing[0]), scale * y, 0.0 };
        const vtkGodRaysNoise::Sample fine = fractal.Evaluate(position);
        const vtkGodRaysNoise::Sample smooth = fractal.Evaluate(position, smoothOctaves);
        const Vector normal = GetNormal(steepness * fine.Gradient[0], steepness * fine.Gradient[1]);
        const Vector smoothNormal =
          GetNormal(steepness * smooth.Gradient[0], steepness * smooth.Gradient[1]);
        const double height = this->Height * fine.Value;
        // 1 - normal.smoothNormal, without rounding errors where they are the same
        double shadow = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          shadow += 0.5 * (normal[c] - smoothNormal[c]) * (normal[c] - smoothNormal[c]);
        }
        *heights->GetPointer(i) = static_cast<float>(height);
        std::copy_n(normal.data(), 3, normals->GetPointer(3 * i));
        std::copy_n(smoothNormal.data(), 3, smoothNormals->GetPointer(3 * i));
        *shadows->GetPointer(i) = static_cast<float>(shadow);
        this->GetColor(height, normal[2], colors->GetPointer(3 * i));
      }
    }
  };
  if (!vtkGodRaysSourceTools::For(this, extent[3] - extent[2] + 1, computeRows))
  {
    image->Initialize();
  }
  return 1;
}
