// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageSweep.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysCoveragePhase.h"
#include "vtkGodRaysCoverageTable.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysPointSlices.h"
#include "vtkGodRaysShadowAlong.h"
#include "vtkGodRaysShadowKernels.h"
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

bool IsGrey(const double* color)
{
  return color[0] == color[1] && color[1] == color[2];
}

// Whether shadows let more of one colour through than of another.
bool HasColoredShadows(const Parameters& parameters)
{
  return parameters.Shadows && parameters.Shadows->NumberOfLayers > 0 &&
    parameters.Shadows->Colored;
}

// What a table depends on, in the order of the members.
using TableKey = std::vector<double>;
void MakeTableKey(const Parameters& parameters, int width, int height, TableKey& key)
{
  const vtkGodRaysMedium& medium = parameters.Medium;
  key.assign({ width + 0.0, height + 0.0, parameters.PixelSize, parameters.Center[0],
    parameters.Center[1], parameters.Parallel + 0.0, parameters.Light[0], parameters.Light[1],
    parameters.Light[2], parameters.Light[3], medium.Up[0], medium.Up[1], medium.Up[2],
    medium.EyeHeight, medium.PlanetRadius, medium.FarLimit, HasColoredShadows(parameters) + 0.0 });
  parameters.Spot.AddTo(key);
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    key.insert(key.end(), component.Scattering, component.Scattering + 3);
    key.insert(key.end(), component.Absorption, component.Absorption + 3);
    const auto phase = GetCoveragePhaseKey(component);
    key.insert(key.end(), phase.begin(), phase.end());
    key.push_back(component.ScaleHeight);
  }
}
}

class vtkGodRaysCoverageSweep::vtkInternals
{
public:
  void Execute(const Parameters& parameters)
  {
    this->Lines = 0;
    this->Prepare(parameters);
    const std::size_t pixels = static_cast<std::size_t>(this->Image.Width) * this->Image.Height;
    this->Result.resize(pixels * this->Shade.Components);
    float* result = this->Result.data();
    this->LastResult = result;
    this->HideShadows(parameters.Shadows);
    vtkSMPTools::For(0, this->Image.Height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          WriteCoverageRow(this->Settings, this->Image, this->Shade, static_cast<int>(y),
            result + y * this->Image.Width * this->Shade.Components);
        }
      });
  }

  std::string Describe() const
  {
    if (!this->LastResult)
    {
      return "nothing yet";
    }
    return std::to_string(this->Settings.Channels) + " extinction(s), " +
      std::to_string(this->Shade.Components) + " component(s), " +
      (this->Settings.Point ? "point light, " : "directional light, ") +
      (this->Layered ? "layered" : "homogeneous") + " medium" +
      (this->Layered && this->Settings.PlanetRadius > 0.0 ? " over a planet, " : ", ") +
      (this->Settings.Parallel ? "parallel projection, " : "perspective, ") +
      (this->Table.Kind == CoverageTable::NONE ? std::string()
                                               : "table of " + std::to_string(this->Table.Rows) +
            " x " + std::to_string(this->Table.Columns) +
            (this->Table.Slices > 1 ? " x " + std::to_string(this->Table.Slices) : std::string()) +
            ", ") +
      (this->HasNoLines() ? std::string("the light is along the direction of view")
                          : std::to_string(this->Lines) + " lines through the light");
  }

  CoverageImage Image = {};
  Plane Ends; // of view rays
  const float* LastResult = nullptr;
  CoverageShade Shade = {};
  double Bound = 0.0;

private:
  // What the parameters mean for the kernels, and room for what they write.
  void Prepare(const Parameters& parameters)
  {
    const vtkGodRaysMedium& medium = parameters.Medium;
    CoverageSettings& settings = this->Settings;
    settings.PixelSize = parameters.PixelSize;
    settings.Parallel = parameters.Parallel;
    this->Layered = medium.HasExponentialDensity();
    settings.Point = parameters.Light[3] != 0.0;
    const double norm = settings.Point
      ? parameters.Light[3]
      : std::hypot(parameters.Light[0], parameters.Light[1], parameters.Light[2]);
    for (int i = 0; i < 3; ++i)
    {
      settings.Light[i] = parameters.Light[i] / norm;
      settings.Up[i] = medium.Up[i];
    }
    settings.Spot = settings.Point ? parameters.Spot : vtkGodRaysSpot();
    settings.EyeHeight = medium.EyeHeight;
    settings.PlanetRadius = medium.PlanetRadius;
    settings.FarLimit = medium.FarLimit;
    settings.Spacing = parameters.LineSpacing;
    const bool layered = this->Layered;
    bool grey = true;
    bool alike = true; // whether components scatter all colours in one proportion
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      const Component& component = medium.Components[k];
      alike = alike && (IsGrey(component.Scattering) || medium.NumberOfComponents == 1);
      double extinction[3];
      for (int c = 0; c < 3; ++c)
      {
        extinction[c] = component.Scattering[c] + component.Absorption[c];
        settings.Extinction[c] = extinction[c] + (k > 0 ? settings.Extinction[c] : 0.0);
      }
      grey = grey && IsGrey(extinction);
    }
    settings.Channels = (layered ? grey : IsGrey(settings.Extinction)) &&
        (alike || !settings.Point) && !HasColoredShadows(parameters)
      ? 1
      : 3;
    settings.Planes =
      settings.Channels * (layered && !settings.Point ? medium.NumberOfComponents : 1);
    settings.Table = &this->Table;
    if (!layered && !settings.Point)
    {
      this->Table.Kind = CoverageTable::NONE;
      for (double& extinction : settings.Extinction)
      {
        // So clear a medium cannot be told from none, and the quotient stays defined.
        extinction = std::max(extinction, 1e-9 / medium.FarLimit);
      }
    }
    this->PrepareImages(parameters);
    SetSliceAxes(this->Image, medium, layered, settings);
    this->PrepareCone();
    this->PrepareTable(parameters);
    this->PrepareShade(parameters);
    this->TurnedSettings = settings;
    std::swap(this->TurnedSettings.Light[0], this->TurnedSettings.Light[1]);
    std::swap(this->TurnedSettings.Up[0], this->TurnedSettings.Up[1]);
    std::swap(this->TurnedSettings.SliceAxis[0], this->TurnedSettings.SliceAxis[1]);
    std::swap(this->TurnedSettings.SliceSide[0], this->TurnedSettings.SliceSide[1]);
    this->PrepareWedges();
  }

  void PrepareTable(const Parameters& parameters)
  {
    if (!this->Settings.Point && !this->Layered)
    {
      this->TableKeys[0].clear();
      return;
    }
    MakeTableKey(parameters, this->Image.Width, this->Image.Height, this->TableKeys[1]);
    if (this->TableKeys[0] != this->TableKeys[1])
    {
      MakeCoverageTable(this->Settings, this->Image, parameters.Medium, this->Table);
      this->TableKeys[0] = this->TableKeys[1];
    }
  }

  void PrepareShade(const Parameters& parameters)
  {
    const vtkGodRaysMedium& medium = parameters.Medium;
    this->Shade.Components = CountComponents(parameters);
    this->Shade.Phases = this->Settings.Point ? 1 : medium.NumberOfComponents;
    std::fill_n(&this->Shade.Factors[0][0], 6, 0.0f);
    double bounds[3] = {};
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      const Component& component = medium.Components[k];
      const int phase = this->Settings.Point ? 0 : k;
      const double peak = this->Settings.Point ? 1.0 : this->PreparePhase(component, k);
      for (int c = 0; c < 3; ++c)
      {
        const double factor =
          std::min(parameters.LightColor[c] * component.Scattering[c] * this->GetUnit(c), 1e36);
        this->Shade.Factors[phase][c] += static_cast<float>(factor);
        bounds[c] += 1.001 * factor * peak * this->GetLargest(k, c);
      }
    }
    this->Bound = std::min(*std::max_element(bounds, bounds + 3), 3e38);
  }

  // The table of a component's phase function; returns its peak.
  double PreparePhase(const Component& component, int k)
  {
    CoveragePhase& table = this->Shade.Table[k];
    if (table.empty() || this->PhaseKeys[k] != GetCoveragePhaseKey(component))
    {
      MakeCoveragePhase(component, table);
      this->PhaseKeys[k] = GetCoveragePhaseKey(component);
      this->PhasePeaks[k] = *std::max_element(table.begin(), table.end());
    }
    return this->PhasePeaks[k];
  }

  // What the kernels measure light in: the closed form in parts of an infinite ray's.
  double GetUnit(int color) const
  {
    return this->Table.Kind == CoverageTable::NONE ? 1.0 / this->Settings.Extinction[color] : 1.0;
  }

  // In that unit, the most light of any ray.
  double GetLargest(int component, int color) const
  {
    const int channel = this->Settings.Channels == 1 ? 0 : color;
    const bool isShared = this->Settings.Planes == this->Settings.Channels;
    return this->Table.Kind == CoverageTable::NONE
      ? 1.0
      : this->Table.Largest[isShared ? channel : component * this->Settings.Channels + channel];
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
    image.Begins = nullptr;
    image.Ends = this->Ends.data();
    for (int p = 0; p < this->Settings.Planes; ++p)
    {
      this->Hidden[p].resize(pixels);
      image.Hidden[p] = this->Hidden[p].data();
    }
  }

  // The parts of view rays that are in a spotlight's cone.
  void PrepareCone()
  {
    const vtkGodRaysSpot& spot = this->Settings.Spot;
    if (!spot.IsCone())
    {
      return;
    }
    CoverageImage& image = this->Image;
    const std::size_t pixels = static_cast<std::size_t>(image.Width) * image.Height;
    for (Plane& plane : this->Cone)
    {
      plane.resize(pixels);
    }
    const CoverageSettings& settings = this->Settings;
    const Vec3 axis(spot.Axis[0], spot.Axis[1], spot.Axis[2]);
    const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
    vtkSMPTools::For(0, image.Height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          for (int x = 0; x < image.Width; ++x)
          {
            const Vec3 place((x - image.Center[0]) * settings.PixelSize,
              (y - image.Center[1]) * settings.PixelSize, settings.Parallel ? 0.0 : 1.0);
            const Vec3 origin = settings.Parallel ? place : Vec3(0.0);
            const Vec3 along = settings.Parallel ? Vec3(0.0, 0.0, 1.0) : place;
            const double perDepth = length(along);
            const Vec3 to = light - origin;
            LitRay ray = {};
            ray.Foot = dot(to, along) / perDepth;
            ray.Distance = length(cross(to, along)) / perDepth;
            ray.AxisStart = -dot(axis, to);
            ray.AxisSlope = dot(axis, along) / perDepth;
            spot.SetShape(ray);
            const std::ptrdiff_t pixel = y * image.Width + x;
            const double last = std::min<double>(image.Ends[pixel], settings.FarLimit);
            const Vec2 part = SpotPart(ray, last * perDepth) / perDepth;
            this->Cone[0][pixel] = static_cast<float>(part.x);
            this->Cone[1][pixel] = static_cast<float>(part.y);
          }
        }
      });
    image.Begins = this->Cone[0].data();
    image.Ends = this->Cone[1].data();
  }

  void PrepareWedges()
  {
    const CoverageImage& image = this->Image;
    const std::array<double, 11> key = { image.Width + 0.0, image.Height + 0.0, image.Center[0],
      image.Center[1], this->Settings.PixelSize, this->Settings.Parallel + 0.0,
      this->Settings.Point + 0.0, this->Settings.Light[0], this->Settings.Light[1],
      this->Settings.Light[2], this->Settings.Spacing };
    if (key == this->WedgeKey || this->HasNoLines())
    {
      return;
    }
    this->WedgeKey = key;
    for (int i = 0; i < 4; ++i)
    {
      this->Wedges[i] = MakeCoverageWedge(i < 2 ? this->TurnedSettings : this->Settings,
        i < 2 ? this->Turned : image, i % 2 == 0 ? 1 : -1);
    }
  }

  // Whether every view ray is a light ray: of a light along parallel view rays, or in the eye.
  bool HasNoLines() const
  {
    const double* light = this->Settings.Light;
    const double aside = std::hypot(light[0], light[1]);
    if (this->Settings.Point)
    {
      return !this->Settings.Parallel &&
        std::hypot(aside, light[2]) <= 1e-9 * this->Settings.FarLimit;
    }
    return this->Settings.Parallel && aside < 1e-7;
  }

  // Of planes through eye and light; the transpose is read and written in place.
  void HideShadows(const vtkGodRaysShadowGrids* shadows)
  {
    const CoverageSettings& settings = this->Settings;
    for (int p = 0; p < settings.Planes; ++p)
    {
      std::fill(this->Hidden[p].begin(), this->Hidden[p].end(), 0.0f);
    }
    if (!shadows || shadows->Levels == 0)
    {
      return; // nothing blocks
    }
    const vtkGodRaysShadowGrids& grids = *shadows;
    if (this->HasNoLines())
    {
      HideAlongRays(settings, this->Image, grids);
      return;
    }
    if (grids.Point)
    {
      MakeShadowFan(grids, this->Shadows.Fan);
    }
    else
    {
      const bool weighs = this->Table.Kind == CoverageTable::NONE && !settings.Parallel;
      const double* extinctions = settings.Extinction;
      const auto range = std::minmax_element(extinctions, extinctions + settings.Channels);
      MakeShadowLadder(
        grids, weighs ? *range.first : 0.0, weighs ? *range.second : 0.0, this->Shadows.Ladder);
    }
    vtkGodRaysShadowGrids turned = grids;
    for (vtkGodRaysShadowGrids::Grid& grid : turned.Grids)
    {
      for (double* axis : grid.Axes)
      {
        std::swap(axis[0], axis[1]);
      }
    }
    std::size_t bands = 0;
    for (const CoverageWedge& wedge : this->Wedges)
    {
      bands = std::max(bands, static_cast<std::size_t>(wedge.Bands));
    }
    while (this->ShadowBands.size() < bands)
    {
      this->ShadowBands.push_back(MakeShadowLines());
    }
    ShadowPicture picture = { this->Image.Begins, this->Image.Ends, {}, 0, 0 };
    std::copy_n(this->Image.Hidden, settings.Planes, picture.Hidden);
    for (int i = 0; i < 4; ++i)
    {
      const CoverageWedge& wedge = this->Wedges[i];
      const bool isTurned = i < 2;
      picture.Across = isTurned ? this->Image.Width : 1;
      picture.Along = isTurned ? 1 : this->Image.Width;
      this->Lines += wedge.Rows > 0 ? wedge.Lines : 0;
      vtkSMPTools::For(0, wedge.Rows > 0 ? wedge.Bands : 0, 1,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType band = begin; band < end; ++band)
          {
            SweepShadowBand(isTurned ? this->TurnedSettings : settings,
              isTurned ? this->Turned : this->Image, wedge, static_cast<int>(band),
              isTurned ? turned : grids, this->Shadows, picture, *this->ShadowBands[band]);
          }
        });
    }
    // The pixel in whose centre the light, or its opposite, is belongs to no wedge.
    bool isCentred;
    const std::ptrdiff_t pixel = FindCoverageLight(this->Wedges[2], this->Image, isCentred);
    if (pixel >= 0 && isCentred)
    {
      HideAlongRay(settings, this->Image, grids, pixel);
    }
  }

  CoverageSettings Settings = {};
  CoverageSettings TurnedSettings = {};
  CoverageImage Turned = {}; // its size and centre alone
  Plane Result;
  Plane Hidden[CoverageMaximumPlanes];
  bool Layered = false; // the medium
  Plane Cone[2];        // where view rays enter a spotlight's cone, and where they end
  CoverageTable Table;
  TableKey TableKeys[2]; // of the table, and of what is asked for
  std::array<double, 5> PhaseKeys[vtkGodRaysMedium::MaximumComponents];
  double PhasePeaks[vtkGodRaysMedium::MaximumComponents];
  std::array<double, 11> WedgeKey = {};
  CoverageWedge Wedges[4]; // of the transpose, then of the picture; each up and down
  ShadowTables Shadows;
  std::vector<ShadowLinesPointer> ShadowBands;
  int Lines = 0;
};

vtkGodRaysCoverageSweep::vtkGodRaysCoverageSweep()
  : Internals(new vtkInternals)
{
}

vtkGodRaysCoverageSweep::~vtkGodRaysCoverageSweep() = default;

float* vtkGodRaysCoverageSweep::PrepareInput(int width, int height)
{
  vtkInternals& internals = *this->Internals;
  internals.Image.Width = width;
  internals.Image.Height = height;
  internals.Ends.resize(static_cast<std::size_t>(width) * height);
  return internals.Ends.data();
}

bool vtkGodRaysCoverageSweep::Execute(const Parameters& parameters)
{
  if (this->Internals->Ends.empty())
  {
    return false;
  }
  this->Internals->Execute(parameters);
  return true;
}

int vtkGodRaysCoverageSweep::CountComponents(const Parameters& parameters)
{
  bool isGrey = IsGrey(parameters.LightColor) && !HasColoredShadows(parameters);
  for (int k = 0; k < parameters.Medium.NumberOfComponents; ++k)
  {
    const Component& component = parameters.Medium.Components[k];
    isGrey = isGrey && IsGrey(component.Scattering) && IsGrey(component.Absorption);
  }
  return isGrey ? 1 : 3;
}

int vtkGodRaysCoverageSweep::GetNumberOfComponents() const
{
  return this->Internals->Shade.Components;
}

const float* vtkGodRaysCoverageSweep::GetResult() const
{
  return this->Internals->LastResult;
}

double vtkGodRaysCoverageSweep::GetBound() const
{
  return this->Internals->Bound;
}

std::string vtkGodRaysCoverageSweep::Describe() const
{
  return this->Internals->Describe();
}
