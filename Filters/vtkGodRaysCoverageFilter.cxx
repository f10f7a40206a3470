// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageFilter.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
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
#include <cmath>
#include <functional>
#include <vector>

vtkStandardNewMacro(vtkGodRaysCoverageFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysCoverageFilter, Thickness, 0.0, 1.0);

namespace
{
using namespace vtkGodRays;
using Plane = std::vector<float>;

//------------------------------------------------------------------------------
// In blocks, for the sake of the cache.
void Transpose(const float* from, int width, int height, float* to)
{
  constexpr int block = 16;
  vtkSMPTools::For(0, (height + block - 1) / block, 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType strip = begin; strip < end; ++strip)
      {
        const int low = static_cast<int>(strip) * block;
        const int high = std::min(low + block, height);
        for (int left = 0; left < width; left += block)
        {
          const int right = std::min(left + block, width);
          for (int x = left; x < right; ++x)
          {
            for (int y = low; y < high; ++y)
            {
              to[static_cast<std::ptrdiff_t>(x) * height + y] =
                from[static_cast<std::ptrdiff_t>(y) * width + x];
            }
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
// Planes of positive depths.
template <typename Scalar>
void Load(const Scalar* values, int components, int planes, vtkIdType pixels, Plane* to)
{
  vtkSMPTools::For(0, pixels, 1 << 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int c = 0; c < planes; ++c)
      {
        float* plane = to[c].data();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Scalar z = values[i * components + c];
          // false for NaN
          plane[i] = z > 0 && z < CoverageSky ? static_cast<float>(z) : CoverageSky;
        }
      }
    });
}

//------------------------------------------------------------------------------
CoveragePhase MakeTable(const PhaseFunction& phase)
{
  CoveragePhase table;
  const double g = phase.Kind >= 2 ? phase.Asymmetry : 0.0;
  table.Back = g < 0.0;
  int intervals = 1024;
  while (intervals * (1.0 - std::abs(g)) < 870.0)
  {
    intervals *= 2;
  }
  table.Table.resize(intervals + 1);
  for (int i = 0; i <= intervals; ++i)
  {
    const double chord = i / static_cast<double>(intervals);
    const double cosine = 1.0 - 2.0 * chord * chord;
    table.Table[i] = static_cast<float>(Phase(phase, table.Back ? -cosine : cosine));
  }
  return table;
}

//------------------------------------------------------------------------------
bool IsGrey(const double* color)
{
  return color[0] == color[1] && color[1] == color[2];
}
}

//------------------------------------------------------------------------------
class vtkGodRaysCoverageFilter::vtkInternals
{
public:
  // False if it was told to stop.
  bool Execute(const CoverageSettings& settings, int width, int height,
    const vtkGodRays::PhaseFunction& phase, int components, const double factors[3], float* result,
    const std::function<bool(double)>& monitor)
  {
    this->Overflows = 0;
    this->Lines = 0;
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    const int planes = std::max(1, 2 * settings.Layers);
    CoverageImage image = {};
    CoverageImage turned = {};
    image.Width = turned.Height = width;
    image.Height = turned.Width = height;
    for (int i = 0; i < planes; ++i)
    {
      image.Depths[i] = this->Depths[i].data();
    }
    for (int c = 0; c < settings.Channels; ++c)
    {
      this->Hidden[c].resize(pixels);
      image.Hidden[c] = this->Hidden[c].data();
    }
    const bool along = settings.Parallel && std::hypot(settings.Light[0], settings.Light[1]) < 1e-7;
    if (along)
    {
      this->HideAlongView(settings, image);
    }
    else
    {
      if (!this->SweepColumns(settings, image, turned, planes, monitor))
      {
        return false;
      }
      for (const int direction : { 1, -1 })
      {
        this->Sweep(settings, image, false, direction);
      }
    }
    if (!monitor(0.75))
    {
      return false;
    }
    if (this->PhaseKind != phase.Kind || this->PhaseAsymmetry != phase.Asymmetry)
    {
      this->Phase = MakeTable(phase);
      this->PhaseKind = phase.Kind;
      this->PhaseAsymmetry = phase.Asymmetry;
    }
    vtkSMPTools::For(0, height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          WriteCoverageRow(settings, image, this->Phase, static_cast<int>(y), components, factors,
            result + y * width * components);
        }
      });
    this->Plan = (settings.Layers > 0 ? std::to_string(settings.Layers) + " solid layer(s)"
                                      : std::string("depths of the first surface")) +
      ", " + std::to_string(settings.Channels) + " extinction(s), " + std::to_string(components) +
      " component(s), directional light, homogeneous medium, " +
      (settings.Parallel ? "parallel projection, " : "perspective, ") +
      (along ? std::string("the light is along the direction of view")
             : std::to_string(this->Lines) + " lines through the light") +
      ", " + std::to_string(this->Overflows) + " overflows";
    return monitor(1.0);
  }

  Plane Depths[4];
  long long Overflows = 0;
  std::string Plan = "nothing yet";

private:
  // Every view ray is a light ray: from in front it is dark before a surface, from behind all is lit.
  void HideAlongView(const CoverageSettings& settings, const CoverageImage& image)
  {
    for (int c = 0; c < settings.Channels; ++c)
    {
      Plane& hidden = this->Hidden[c];
      for (std::size_t i = 0; i < hidden.size(); ++i)
      {
        hidden[i] = settings.Light[2] > 0.0 && image.Depths[0][i] < CoverageSky ? 2.0f : 0.0f;
      }
    }
  }

  void Sweep(
    const CoverageSettings& settings, const CoverageImage& image, bool transposed, int direction)
  {
    const CoverageWedge wedge = MakeCoverageWedge(settings, image, transposed, direction);
    if (wedge.Rows == 0)
    {
      return;
    }
    this->Lines += wedge.Lines;
    std::vector<long long> overflows(wedge.Bands);
    vtkSMPTools::For(0, wedge.Bands, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType band = begin; band < end; ++band)
        {
          overflows[band] = SweepCoverageBand(settings, image, wedge, static_cast<int>(band));
        }
      });
    for (const long long count : overflows)
    {
      this->Overflows += count;
    }
  }

  // The wedges to the left and right, whose pixels those above and below overwrite where they meet.
  bool SweepColumns(const CoverageSettings& settings, CoverageImage& image, CoverageImage& turned,
    int planes, const std::function<bool(double)>& monitor)
  {
    const std::size_t pixels = this->Hidden[0].size();
    for (int i = 0; i < planes; ++i)
    {
      this->TurnedDepths[i].resize(pixels);
      Transpose(image.Depths[i], image.Width, image.Height, this->TurnedDepths[i].data());
      turned.Depths[i] = this->TurnedDepths[i].data();
    }
    for (int c = 0; c < settings.Channels; ++c)
    {
      this->TurnedHidden[c].resize(pixels);
      turned.Hidden[c] = this->TurnedHidden[c].data();
    }
    if (!monitor(0.25))
    {
      return false;
    }
    for (const int direction : { 1, -1 })
    {
      this->Sweep(settings, turned, true, direction);
    }
    this->FillLight(settings, turned);
    for (int c = 0; c < settings.Channels; ++c)
    {
      Transpose(turned.Hidden[c], turned.Width, turned.Height, image.Hidden[c]);
    }
    return monitor(0.5);
  }

  // The pixel in whose centre the light is belongs to no wedge: it is dark before a surface.
  void FillLight(const CoverageSettings& settings, const CoverageImage& turned)
  {
    const CoverageWedge wedge = MakeCoverageWedge(settings, turned, true, 1);
    const double x = wedge.A / wedge.W;
    const double y = wedge.B / wedge.W;
    if (wedge.W == 0.0 || !(x >= 0.0 && y >= 0.0 && x < turned.Width && y < turned.Height) ||
      wedge.W * std::floor(x + 0.5) != wedge.A || wedge.W * std::floor(y + 0.5) != wedge.B)
    {
      return;
    }
    const std::size_t pixel =
      static_cast<std::size_t>(std::min(y + 0.5, turned.Height - 1.0)) * turned.Width +
      static_cast<std::size_t>(std::min(x + 0.5, turned.Width - 1.0));
    for (int c = 0; c < settings.Channels; ++c)
    {
      turned.Hidden[c][pixel] =
        wedge.W > 0.0 && turned.Depths[0][pixel] < CoverageSky ? 2.0f : 0.0f;
    }
  }

  Plane TurnedDepths[4];
  Plane Hidden[3];
  Plane TurnedHidden[3];
  CoveragePhase Phase;
  int PhaseKind = -1;
  double PhaseAsymmetry = 0.0;
  int Lines = 0;
};

//------------------------------------------------------------------------------
vtkGodRaysCoverageFilter::vtkGodRaysCoverageFilter()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysCoverageFilter::~vtkGodRaysCoverageFilter() = default;

//------------------------------------------------------------------------------
void vtkGodRaysCoverageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "Plan: " << this->GetPlan() << "\n";
}

//------------------------------------------------------------------------------
std::string vtkGodRaysCoverageFilter::GetPlan() const
{
  return this->Internals->Plan;
}

//------------------------------------------------------------------------------
long long vtkGodRaysCoverageFilter::GetNumberOfOverflows() const
{
  return this->Internals->Overflows;
}

//------------------------------------------------------------------------------
int vtkGodRaysCoverageFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  // Optional, so that it is this filter that tells what to do without one.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
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
  const bool grey = IsGrey(this->LightColor) && IsGrey(this->ScatteringCoefficient) &&
    IsGrey(this->AbsorptionCoefficient);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, grey ? 1 : 3);
  return 1;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
int vtkGodRaysCoverageFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkImageData* result = vtkImageData::GetData(output);
  vtkDataArray* depths = image ? this->GetInputArrayToProcess(0, input) : nullptr;
  std::string fault = this->FindFault();
  const int components = depths ? depths->GetNumberOfComponents() : 0;
  if (!fault.empty())
  {
    // said
  }
  else if (!depths || depths->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    image->GetNumberOfPoints() == 0 || image->GetDimensions()[2] != 1)
  {
    fault =
      "there is no depth image. Connect one slice in x and y of view depths as point data; name "
      "the array with SetInputArrayToProcess() unless it is the active one.";
  }
  else if ((components != 1 && components != 2 && components != 4) ||
    (depths->GetDataType() != VTK_FLOAT && depths->GetDataType() != VTK_DOUBLE))
  {
    fault = "the depths are " + std::to_string(components) + " component(s) of type " +
      depths->GetDataTypeAsString() +
      ". Give 1, 2 or 4 components of float or double: the first surface, or fronts and backs of "
      "solid layers.";
  }
  else if (this->Light[3] != 0.0)
  {
    fault = "the light is a point light, and only directional lights are supported. Set the fourth "
            "number of Light to 0, or take vtkGodRaysSingleScatteringReference.";
  }
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute scattered light: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  }

  int dimensions[3];
  image->GetDimensions(dimensions);
  const View view = this->GetView(dimensions[1]);
  CoverageSettings settings;
  settings.PixelSize = view.PixelSize;
  settings.Parallel = view.Parallel;
  const double norm = vtkMath::Norm(this->Light);
  settings.Light[0] = vtkMath::Dot(this->Light, view.Right) / norm;
  settings.Light[1] = vtkMath::Dot(this->Light, view.Up) / norm;
  settings.Light[2] = vtkMath::Dot(this->Light, view.Forward) / norm;
  settings.FarLimit = this->FarLimit;
  settings.Layers = components / 2;
  settings.Thickness = this->Thickness;
  double factors[3];
  for (int c = 0; c < 3; ++c)
  {
    // So clear a medium cannot be told from none, and the quotient stays defined.
    const double extinction = this->ScatteringCoefficient[c] + this->AbsorptionCoefficient[c];
    settings.Extinction[c] = std::max(extinction, 1e-9 / this->FarLimit);
    factors[c] =
      std::min(this->LightColor[c] * this->ScatteringCoefficient[c] / settings.Extinction[c], 1e36);
  }
  settings.Channels = IsGrey(settings.Extinction) ? 1 : 3;
  const int colors = settings.Channels == 1 && IsGrey(factors) ? 1 : 3;

  const vtkIdType pixels = image->GetNumberOfPoints();
  const int planes = std::max(1, 2 * settings.Layers);
  for (int i = 0; i < planes; ++i)
  {
    this->Internals->Depths[i].resize(pixels);
  }
  if (depths->GetDataType() == VTK_FLOAT)
  {
    Load(static_cast<const float*>(depths->GetVoidPointer(0)), components, planes, pixels,
      this->Internals->Depths);
  }
  else
  {
    Load(static_cast<const double*>(depths->GetVoidPointer(0)), components, planes, pixels,
      this->Internals->Depths);
  }

  vtkNew<vtkFloatArray> radiances;
  radiances->SetName("Radiance");
  radiances->SetNumberOfComponents(colors);
  radiances->SetNumberOfTuples(pixels);
  if (!this->Internals->Execute(settings, dimensions[0], dimensions[1],
        { this->PhaseFunction, this->Asymmetry }, colors, factors, radiances->GetPointer(0),
        [this](double progress) { return this->TellProgress(progress); }))
  {
    result->Initialize();
    return 1;
  }
  result->SetExtent(image->GetExtent());
  result->GetPointData()->SetScalars(radiances);
  return 1;
}
