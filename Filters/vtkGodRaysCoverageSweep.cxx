// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageSweep.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

static_assert(vtkGodRaysCoverageSweep::Sky == vtkGodRays::CoverageSky, "one sky");

namespace
{
using namespace vtkGodRays;
using Plane = std::vector<float>;
using Component = vtkGodRaysMedium::Component;
using Parameters = vtkGodRaysCoverageSweep::Parameters;
using Monitor = vtkGodRaysCoverageSweep::Monitor;

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
// What of a component decides the shape of its phase function.
std::array<double, 5> GetPhaseKey(const Component& component)
{
  return { static_cast<double>(component.PhaseFunction), component.Asymmetry,
    static_cast<double>(component.SecondPhaseFunction), component.SecondAsymmetry,
    component.SecondWeight };
}

//------------------------------------------------------------------------------
double GetPhase(const Component& component, double cosAngle)
{
  return PhaseMix({ component.PhaseFunction, component.Asymmetry },
    { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight, cosAngle);
}

//------------------------------------------------------------------------------
void MakeTable(const Component& component, CoveragePhase& table)
{
  const auto sharpness = [](int kind, double asymmetry)
  { return kind >= 2 ? 1.0 - std::abs(asymmetry) : 1.0; };
  const double least = std::min(sharpness(component.PhaseFunction, component.Asymmetry),
    component.SecondWeight > 0.0
      ? sharpness(component.SecondPhaseFunction, component.SecondAsymmetry)
      : 1.0);
  int half = 768;
  while (half * least < 640.0)
  {
    half *= 2;
  }
  table.resize(2 * half + 1);
  for (int i = 0; i <= half; ++i)
  {
    const double chord = i / static_cast<double>(half);
    const double cosine = 1.0 - chord * chord;
    table[i] = static_cast<float>(GetPhase(component, cosine));
    table[2 * half - i] = static_cast<float>(GetPhase(component, -cosine));
  }
}

//------------------------------------------------------------------------------
bool IsGrey(const double* color)
{
  return color[0] == color[1] && color[1] == color[2];
}
}

//------------------------------------------------------------------------------
class vtkGodRaysCoverageSweep::vtkInternals
{
public:
  bool Execute(const Parameters& parameters, const Monitor& monitor)
  {
    this->Overflows = 0;
    this->Lines = 0;
    this->Prepare(parameters);
    float* result = this->Result;
    const std::size_t pixels = static_cast<std::size_t>(this->Image.Width) * this->Image.Height;
    if (!result)
    {
      this->OwnResult.resize(pixels * this->Shade.Components);
      result = this->OwnResult.data();
    }
    this->LastResult = result;
    if (this->IsAlongView())
    {
      this->HideAlongView();
    }
    else
    {
      if (!this->SweepColumns(monitor))
      {
        return false;
      }
      this->Sweep(this->Image, 2);
      this->Sweep(this->Image, 3);
    }
    if (monitor && !monitor(0.75))
    {
      return false;
    }
    vtkSMPTools::For(0, this->Image.Height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          WriteCoverageRow(this->Settings, this->Image, this->Shade, static_cast<int>(y),
            result + y * this->Image.Width * this->Shade.Components);
        }
      });
    return !monitor || monitor(1.0);
  }

  std::string Describe() const
  {
    if (!this->LastResult)
    {
      return "nothing yet";
    }
    return (this->Settings.Layers > 0 ? std::to_string(this->Settings.Layers) + " solid layer(s)"
                                      : std::string("depths of the first surface")) +
      ", " + std::to_string(this->Settings.Channels) + " extinction(s), " +
      std::to_string(this->Shade.Components) +
      " component(s), directional light, homogeneous medium, " +
      (this->Settings.Parallel ? "parallel projection, " : "perspective, ") +
      (this->IsAlongView() ? std::string("the light is along the direction of view")
                           : std::to_string(this->Lines) + " lines through the light") +
      ", " + std::to_string(this->Overflows) + " overflows";
  }

  CoverageImage Image = {};
  Plane Input[MaximumPlanes];
  int NumberOfPlanes = 0;
  float* Result = nullptr;
  const float* LastResult = nullptr;
  CoverageShade Shade = {};
  double Bound = 0.0;
  long long Overflows = 0;

private:
  // What the parameters mean for the kernels, and room for what they write.
  void Prepare(const Parameters& parameters)
  {
    const vtkGodRaysMedium& medium = parameters.Medium;
    CoverageSettings& settings = this->Settings;
    settings.PixelSize = parameters.PixelSize;
    settings.Parallel = parameters.Parallel;
    const double norm = std::hypot(parameters.Light[0], parameters.Light[1], parameters.Light[2]);
    for (int i = 0; i < 3; ++i)
    {
      settings.Light[i] = parameters.Light[i] / norm;
    }
    settings.FarLimit = medium.FarLimit;
    settings.Layers = parameters.Layers;
    settings.Thickness = parameters.Thickness;
    for (int c = 0; c < 3; ++c)
    {
      double extinction = 0.0;
      for (int k = 0; k < medium.NumberOfComponents; ++k)
      {
        extinction += medium.Components[k].Scattering[c] + medium.Components[k].Absorption[c];
      }
      // So clear a medium cannot be told from none, and the quotient stays defined.
      settings.Extinction[c] = std::max(extinction, 1e-9 / medium.FarLimit);
    }
    settings.Channels = IsGrey(settings.Extinction) ? 1 : 3;
    this->PrepareShade(parameters);
    this->PrepareImages(parameters);
  }

  void PrepareShade(const Parameters& parameters)
  {
    const vtkGodRaysMedium& medium = parameters.Medium;
    this->Shade.Components = CountComponents(parameters);
    this->Shade.Phases = medium.NumberOfComponents;
    double bounds[3] = {};
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      const Component& component = medium.Components[k];
      CoveragePhase& table = this->Shade.Table[k];
      if (table.empty() || this->PhaseKeys[k] != GetPhaseKey(component))
      {
        MakeTable(component, table);
        this->PhaseKeys[k] = GetPhaseKey(component);
        this->PhasePeaks[k] = *std::max_element(table.begin(), table.end());
      }
      for (int c = 0; c < 3; ++c)
      {
        const double factor = std::min(
          parameters.LightColor[c] * component.Scattering[c] / this->Settings.Extinction[c], 1e36);
        this->Shade.Factors[k][c] = static_cast<float>(factor);
        bounds[c] += 1.000001 * factor * this->PhasePeaks[k];
      }
    }
    this->Bound = *std::max_element(bounds, bounds + 3);
  }

  void PrepareImages(const Parameters& parameters)
  {
    CoverageImage& image = this->Image;
    CoverageImage& turned = this->Turned;
    turned.Width = image.Height;
    turned.Height = image.Width;
    for (int i = 0; i < 2; ++i)
    {
      image.Center[i] = turned.Center[1 - i] = parameters.Center[i] - 0.5;
    }
    const std::size_t pixels = static_cast<std::size_t>(image.Width) * image.Height;
    const auto place = [&](Plane& plane)
    {
      plane.resize(pixels);
      return plane.data();
    };
    for (int i = 0; i < this->NumberOfPlanes; ++i)
    {
      place(this->TurnedInput[i]);
    }
    const int depths = std::max(1, 2 * this->Settings.Layers);
    const int ends = this->NumberOfPlanes > depths ? depths : 0;
    for (int i = 0; i < depths; ++i)
    {
      image.Depths[i] = this->Input[i].data();
      turned.Depths[i] = this->TurnedInput[i].data();
    }
    image.Ends = this->Input[ends].data();
    turned.Ends = this->TurnedInput[ends].data();
    for (int c = 0; c < this->Settings.Channels; ++c)
    {
      image.Hidden[c] = place(this->Hidden[c]);
      turned.Hidden[c] = place(this->TurnedHidden[c]);
    }

    const std::array<double, 9> key = { image.Width + 0.0, image.Height + 0.0, image.Center[0],
      image.Center[1], this->Settings.PixelSize, this->Settings.Parallel + 0.0,
      this->Settings.Light[0], this->Settings.Light[1], this->Settings.Light[2] };
    if (key == this->WedgeKey || this->IsAlongView())
    {
      return;
    }
    this->WedgeKey = key;
    std::size_t bands = 0;
    for (int i = 0; i < 4; ++i)
    {
      this->Wedges[i] =
        MakeCoverageWedge(this->Settings, i < 2 ? turned : image, i < 2, i % 2 == 0 ? 1 : -1);
      bands = std::max(bands, static_cast<std::size_t>(this->Wedges[i].Bands));
    }
    while (this->BandLines.size() < bands)
    {
      this->BandLines.push_back(MakeCoverageLines());
    }
    this->BandOverflows.resize(bands);
  }

  // Whether every view ray is a light ray.
  bool IsAlongView() const
  {
    return this->Settings.Parallel &&
      std::hypot(this->Settings.Light[0], this->Settings.Light[1]) < 1e-7;
  }

  // From in front it is dark before the last thing, from behind it is beyond the first.
  void HidePixel(const CoverageImage& image, std::ptrdiff_t pixel, bool isInFront)
  {
    float begin = CoverageSky;
    float end = 0.0f;
    for (int layer = 0; layer < std::max(1, this->Settings.Layers); ++layer)
    {
      const float front = image.Depths[2 * layer][pixel];
      if (front < CoverageSky)
      {
        begin = std::min(begin, front);
        const float back = this->Settings.Layers > 0 ? image.Depths[2 * layer + 1][pixel] : front;
        end = std::max(end, back > front && back < CoverageSky ? back : front);
      }
    }
    HideCoverageInterval(
      this->Settings, image, pixel, isInFront ? 0.0f : begin, isInFront ? end : CoverageSky);
  }

  void HideAlongView()
  {
    const std::ptrdiff_t width = this->Image.Width;
    vtkSMPTools::For(0, this->Image.Height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (std::ptrdiff_t pixel = begin * width; pixel < end * width; ++pixel)
        {
          this->HidePixel(this->Image, pixel, this->Settings.Light[2] > 0.0);
        }
      });
  }

  void Sweep(const CoverageImage& image, int index)
  {
    const CoverageWedge& wedge = this->Wedges[index];
    if (wedge.Rows == 0)
    {
      return;
    }
    this->Lines += wedge.Lines;
    vtkSMPTools::For(0, wedge.Bands, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType band = begin; band < end; ++band)
        {
          this->BandOverflows[band] = SweepCoverageBand(
            this->Settings, image, wedge, static_cast<int>(band), *this->BandLines[band]);
        }
      });
    for (int band = 0; band < wedge.Bands; ++band)
    {
      this->Overflows += this->BandOverflows[band];
    }
  }

  // The wedges to the left and right, whose pixels those above and below overwrite where they meet.
  bool SweepColumns(const Monitor& monitor)
  {
    for (int i = 0; i < this->NumberOfPlanes; ++i)
    {
      Transpose(
        this->Input[i].data(), this->Image.Width, this->Image.Height, this->TurnedInput[i].data());
    }
    if (monitor && !monitor(0.25))
    {
      return false;
    }
    this->Sweep(this->Turned, 0);
    this->Sweep(this->Turned, 1);
    // The pixel in whose centre the light is belongs to no wedge.
    bool isCentred;
    const std::ptrdiff_t pixel = FindCoverageLight(this->Wedges[0], this->Turned, isCentred);
    if (pixel >= 0 && isCentred)
    {
      this->HidePixel(this->Turned, pixel, this->Wedges[0].W > 0.0);
    }
    for (int c = 0; c < this->Settings.Channels; ++c)
    {
      Transpose(
        this->Turned.Hidden[c], this->Turned.Width, this->Turned.Height, this->Image.Hidden[c]);
    }
    return !monitor || monitor(0.5);
  }

  CoverageSettings Settings = {};
  CoverageImage Turned = {};
  Plane OwnResult;
  Plane TurnedInput[MaximumPlanes];
  Plane Hidden[3];
  Plane TurnedHidden[3];
  std::array<double, 5> PhaseKeys[vtkGodRaysMedium::MaximumComponents];
  double PhasePeaks[vtkGodRaysMedium::MaximumComponents];
  std::array<double, 9> WedgeKey = {};
  CoverageWedge Wedges[4]; // of the transpose, then of the picture; each up and down
  std::vector<CoverageLinesPointer> BandLines;
  std::vector<long long> BandOverflows;
  int Lines = 0;
};

//------------------------------------------------------------------------------
vtkGodRaysCoverageSweep::vtkGodRaysCoverageSweep()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysCoverageSweep::~vtkGodRaysCoverageSweep() = default;

//------------------------------------------------------------------------------
vtkGodRaysCoverageSweep::Planes vtkGodRaysCoverageSweep::PrepareInput(
  int width, int height, int planes)
{
  vtkInternals& internals = *this->Internals;
  internals.Image.Width = width;
  internals.Image.Height = height;
  internals.NumberOfPlanes = std::min(planes, MaximumPlanes);
  Planes result;
  for (int i = 0; i < internals.NumberOfPlanes; ++i)
  {
    internals.Input[i].resize(static_cast<std::size_t>(width) * height);
    result.Values[i] = internals.Input[i].data();
  }
  result.Stride = width;
  return result;
}

//------------------------------------------------------------------------------
void vtkGodRaysCoverageSweep::SetResult(float* values)
{
  this->Internals->Result = values;
}

//------------------------------------------------------------------------------
bool vtkGodRaysCoverageSweep::Execute(const Parameters& parameters, const Monitor& monitor)
{
  const int depths = std::max(1, 2 * parameters.Layers);
  const int planes = this->Internals->NumberOfPlanes;
  return (planes == depths || planes == depths + 1) && Supports(parameters) &&
    this->Internals->Execute(parameters, monitor);
}

//------------------------------------------------------------------------------
bool vtkGodRaysCoverageSweep::Supports(const Parameters& parameters)
{
  bool isHomogeneous = true;
  for (int k = 0; k < parameters.Medium.NumberOfComponents; ++k)
  {
    isHomogeneous = isHomogeneous && parameters.Medium.Components[k].ScaleHeight == 0.0;
  }
  return isHomogeneous && parameters.Light[3] == 0.0;
}

//------------------------------------------------------------------------------
int vtkGodRaysCoverageSweep::CountComponents(const Parameters& parameters)
{
  bool isGrey = IsGrey(parameters.LightColor);
  for (int k = 0; k < parameters.Medium.NumberOfComponents; ++k)
  {
    const Component& component = parameters.Medium.Components[k];
    isGrey = isGrey && IsGrey(component.Scattering) && IsGrey(component.Absorption);
  }
  return isGrey ? 1 : 3;
}

//------------------------------------------------------------------------------
int vtkGodRaysCoverageSweep::GetNumberOfComponents() const
{
  return this->Internals->Shade.Components;
}

//------------------------------------------------------------------------------
const float* vtkGodRaysCoverageSweep::GetResult() const
{
  return this->Internals->LastResult;
}

//------------------------------------------------------------------------------
double vtkGodRaysCoverageSweep::GetBound() const
{
  return this->Internals->Bound;
}

//------------------------------------------------------------------------------
long long vtkGodRaysCoverageSweep::GetNumberOfOverflows() const
{
  return this->Internals->Overflows;
}

//------------------------------------------------------------------------------
std::string vtkGodRaysCoverageSweep::Describe() const
{
  return this->Internals->Describe();
}
