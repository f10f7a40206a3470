// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCloudLayerSource.h"

#include "vtkGodRaysMemory.h"
#include "vtkGodRaysNoise.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSourceTools.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkGodRaysCloudLayerSource);

vtkGodRaysSetModeMacro(vtkGodRaysCloudLayerSource, Shape, DOME);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Width, 1e-6, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Altitude, -1e9, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, CloudSize, 1e-6, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Gain, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Coverage, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Softness, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, EdgeFade, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, Opacity, 0.0, 1.0);
vtkGodRaysSetFinite3Macro(vtkGodRaysCloudLayerSource, Color, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, WindSpeed, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, WindDirection, -360.0, 360.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, EvolutionTime, 1e-3, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysCloudLayerSource, EndTime, 0.0, 1e6);

namespace
{
// What a normal distribution exceeds with this probability [standard deviations]; by bisection.
double FindThreshold(double probability)
{
  constexpr double beyond = 40.0; // erfc is 0 there
  if (probability <= 0.0 || probability >= 1.0)
  {
    return std::copysign(std::numeric_limits<double>::infinity(), 0.5 - probability);
  }
  double below = -beyond;
  double above = beyond;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (below + above);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > probability ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

bool IsFirstPiece(vtkInformation* output)
{
  vtkInformationIntegerKey* piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) <= 0;
}
}

class vtkGodRaysCloudLayerSource::Clouds
{
public:
  Clouds(const vtkGodRaysCloudLayerSource* source, double time)
    : Source(source)
    , Fractal{ source->Octaves, source->Gain, 2.0, static_cast<unsigned int>(source->Seed) }
    , Age(time / source->EvolutionTime)
  {
    const double direction = vtkMath::RadiansFromDegrees(source->WindDirection);
    this->Drift[0] = source->WindSpeed * time * std::cos(direction);
    this->Drift[1] = source->WindSpeed * time * std::sin(direction);
    const double sigma = this->Fractal.GetRootMeanSquare();
    this->Threshold = sigma * FindThreshold(source->Coverage);
    this->HalfEdge = 2.0 * sigma * source->Softness;
  }

  double GetOpacity(double x, double y) const
  {
    // Octaves begin off the lattice of the noise, where it would be rougher than it is on average.
    const vtkGodRaysNoise::Vector position = { (x - this->Drift[0]) / this->Source->CloudSize,
      (y - this->Drift[1]) / this->Source->CloudSize, this->Age + 0.37 };
    const double cloud = vtkGodRaysNoise::SmoothStep(this->Threshold - this->HalfEdge,
      this->Threshold + this->HalfEdge, this->Fractal.Evaluate(position).Value);
    const double way = std::hypot(x, y) / (0.5 * this->Source->Width);
    const double fade = this->Source->EdgeFade > 0.0
      ? vtkGodRaysNoise::SmoothStep(0.0, this->Source->EdgeFade, 1.0 - way)
      : 1.0;
    return this->Source->Opacity * cloud * fade;
  }

  void GetColor(double x, double y, unsigned char color[4]) const
  {
    for (int c = 0; c < 3; ++c)
    {
      color[c] = static_cast<unsigned char>(std::lround(255.0 * this->Source->Color[c]));
    }
    color[3] = static_cast<unsigned char>(std::lround(255.0 * this->GetOpacity(x, y)));
  }

private:
  const vtkGodRaysCloudLayerSource* Source;
  vtkGodRaysNoise::Fractal Fractal;
  double Age; // [evolution times]
  double Drift[2];
  double Threshold;
  double HalfEdge;
};

vtkGodRaysCloudLayerSource::vtkGodRaysCloudLayerSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

void vtkGodRaysCloudLayerSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Altitude: " << this->Altitude << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "TextureResolution: " << this->TextureResolution << "\n";
  os << indent << "CloudSize: " << this->CloudSize << "\n";
  os << indent << "Octaves: " << this->Octaves << "\n";
  os << indent << "Gain: " << this->Gain << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "Softness: " << this->Softness << "\n";
  os << indent << "EdgeFade: " << this->EdgeFade << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
  os << indent << "WindSpeed: " << this->WindSpeed << "\n";
  os << indent << "WindDirection: " << this->WindDirection << "\n";
  os << indent << "EvolutionTime: " << this->EvolutionTime << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

vtkImageData* vtkGodRaysCloudLayerSource::GetTexture()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkGodRaysCloudLayerSource::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkGodRaysCloudLayerSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* geometry = output->GetInformationObject(0);
  vtkInformation* texture = output->GetInformationObject(1);
  geometry->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  vtkGodRaysSourceTools::SetTimeRange(geometry, this->EndTime);
  vtkGodRaysSourceTools::SetTimeRange(texture, this->EndTime);
  const int last = this->TextureResolution - 1;
  const int extent[6] = { 0, last, 0, last, 0, 0 };
  const double origin[3] = { -0.5 * this->Width, -0.5 * this->Width, this->Altitude };
  const double step = this->Width / last;
  const double spacing[3] = { step, step, step };
  texture->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  texture->Set(vtkDataObject::ORIGIN(), origin, 3);
  texture->Set(vtkDataObject::SPACING(), spacing, 3);
  texture->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(texture, VTK_UNSIGNED_CHAR, 4);
  return 1;
}

bool vtkGodRaysCloudLayerSource::MakeGeometry(const Clouds& clouds, vtkPolyData* geometry)
{
  const vtkIdType size = this->Resolution;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(size * size);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(size * size);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(size * size);
  const bool finished = vtkGodRaysSourceTools::For(
    this, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (vtkIdType column = 0; column < size; ++column)
        {
          const vtkIdType i = row * size + column;
          const double u = static_cast<double>(column) / (size - 1);
          const double v = static_cast<double>(row) / (size - 1);
          const double x = (u - 0.5) * this->Width;
          const double y = (v - 0.5) * this->Width;
          // The square of the way to a corner, which is 1 there.
          const double way = 2.0 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5));
          const double height = this->Shape == DOME ? std::sqrt(std::max(0.0, 1.0 - way)) : 1.0;
          points->SetPoint(i, x, y, height * this->Altitude);
          clouds.GetColor(x, y, colors->GetPointer(4 * i));
          coordinates->SetTypedComponent(i, 0, static_cast<float>(u));
          coordinates->SetTypedComponent(i, 1, static_cast<float>(v));
        }
      }
    },
    0.0, 0.5);
  if (!finished)
  {
    return false;
  }

  vtkNew<vtkCellArray> quads;
  quads->AllocateExact((size - 1) * (size - 1), 4 * (size - 1) * (size - 1));
  for (vtkIdType row = 0; row < size - 1; ++row)
  {
    for (vtkIdType column = 0; column < size - 1; ++column)
    {
      const vtkIdType i = row * size + column;
      quads->InsertNextCell({ i, i + 1, i + 1 + size, i + size });
    }
  }
  geometry->SetPoints(points);
  geometry->SetPolys(quads);
  geometry->GetPointData()->SetScalars(colors);
  geometry->GetPointData()->SetTCoords(coordinates);
  return true;
}

bool vtkGodRaysCloudLayerSource::MakeTexture(
  const Clouds& clouds, const int extent[6], vtkImageData* texture)
{
  const double step = this->Width / (this->TextureResolution - 1);
  texture->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  texture->SetOrigin(-0.5 * this->Width, -0.5 * this->Width, this->Altitude);
  texture->SetSpacing(step, step, step);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(texture->GetNumberOfPoints());
  texture->GetPointData()->SetScalars(colors);
  return vtkGodRaysSourceTools::For(
    this, extent[3] - extent[2] + 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        unsigned char* color = colors->GetPointer(4 * row * (extent[1] - extent[0] + 1));
        const double y = static_cast<double>(extent[2] + row) * step - 0.5 * this->Width;
        for (int column = extent[0]; column <= extent[1]; ++column, color += 4)
        {
          clouds.GetColor(column * step - 0.5 * this->Width, y, color);
        }
      }
    },
    0.5, 1.0);
}

int vtkGodRaysCloudLayerSource::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* output)
{
  vtkPolyData* geometry = vtkPolyData::GetData(output, 0);
  vtkImageData* texture = vtkImageData::GetData(output, 1);
  // Both are made for the time that is asked of the one.
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  const double time =
    vtkGodRaysSourceTools::GetTime(output->GetInformationObject(port), this->EndTime);
  const Clouds clouds(this, time);

  vtkInformation* information = output->GetInformationObject(1);
  int extent[6];
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  if (port == 1)
  {
    information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  }
  constexpr double bytesOfPoint = 56.0; // with its part of the polygons
  constexpr double bytesOfTexel = 4.0;
  const double texels = (extent[1] - extent[0] + 1.0) * (extent[3] - extent[2] + 1.0);
  std::string fault =
    vtkGodRays::FindMemoryFault(bytesOfPoint * this->Resolution * this->Resolution, "Resolution");
  fault =
    fault.empty() ? vtkGodRays::FindMemoryFault(bytesOfTexel * texels, "TextureResolution") : fault;
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute clouds: " << fault);
  }
  const bool finished = fault.empty() &&
    (!IsFirstPiece(output->GetInformationObject(0)) || this->MakeGeometry(clouds, geometry)) &&
    this->MakeTexture(clouds, extent, texture);
  if (!finished)
  {
    geometry->Initialize();
    texture->Initialize();
    return 1;
  }
  geometry->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  texture->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}
