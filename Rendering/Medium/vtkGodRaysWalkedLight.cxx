// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysWalkedLight.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysSum.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace
{
/// Whether one channel serves a light of any colour.
bool IsGrey(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysInScattering::Parameters& parameters)
{
  const vtkGodRaysShadowGrids* shadows = parameters.Shadows;
  return request.Medium->IsGrey() && !(shadows && shadows->NumberOfLayers > 0 && shadows->Colored);
}

/// Fills in all numbers that a walk depends on; NaN, which equals nothing, for maps of an unknown version.
void FillNumbers(const vtkGodRaysInScattering::Parameters& parameters, const int size[2],
  unsigned int ends, std::vector<double>& all)
{
  all.clear();
  const auto add = [&all](auto... numbers) { (all.push_back(static_cast<double>(numbers)), ...); };
  const auto addAll = [&all](const auto& numbers)
  { all.insert(all.end(), std::begin(numbers), std::end(numbers)); };
  add(size[0], size[1], ends, parameters.PixelSize, parameters.Parallel, parameters.Tolerance,
    parameters.Spot.CosCone, parameters.Spot.Exponent);
  addAll(parameters.Center);
  addAll(parameters.Light);
  addAll(parameters.LightColor);
  addAll(parameters.Spot.Axis);
  const vtkGodRaysMedium& medium = parameters.Medium;
  addAll(medium.Up);
  add(medium.EyeHeight, medium.PlanetRadius, medium.FarLimit);
  for (int i = 0; i < medium.NumberOfComponents; ++i)
  {
    const vtkGodRaysMedium::Component& component = medium.Components[i];
    addAll(component.Scattering);
    addAll(component.Absorption);
    add(component.PhaseFunction, component.Asymmetry, component.SecondPhaseFunction,
      component.SecondAsymmetry, component.SecondWeight, component.ScaleHeight);
  }
  if (const vtkGodRaysShadowGrids* shadows = parameters.Shadows)
  {
    add(shadows->Version > 0 ? shadows->Version + 0.0 : std::numeric_limits<double>::quiet_NaN(),
      shadows->NumberOfLayers, shadows->Colored, shadows->Point);
    addAll(shadows->Range);
    for (int i = 0; i < shadows->Levels; ++i)
    {
      const vtkGodRaysShadowGrids::Grid& grid = shadows->Grids[i];
      addAll(grid.Size);
      addAll(grid.Low);
      addAll(grid.Texel);
      for (const auto& axis : grid.Axes)
      {
        addAll(axis);
      }
    }
  }
}
}

vtkGodRaysInScattering::Parameters vtkGodRaysWalkedLight::GetParameters(
  const vtkGodRaysMediumIntegrator::Request& request, const int size[2],
  const vtkGodRaysShadowGrids* shadows)
{
  const vtkGodRaysLight& light = *request.Light;
  const vtkGodRaysMediumRays rays(request, size);
  vtkGodRaysInScattering::Parameters parameters;
  parameters.PixelSize = rays.GetPinhole().PixelSize;
  std::copy_n(rays.GetPinhole().Center, 2, parameters.Center);
  parameters.Parallel = request.View->Parallel;
  std::copy_n(light.Position, 4, parameters.Light);
  parameters.Shadows = shadows;
  parameters.Tolerance = request.ErrorTolerance;
  const bool grey = IsGrey(request, parameters);
  for (int i = 0; i < 3; ++i)
  {
    parameters.LightColor[i] = light.Power * (grey ? 1.0 : light.Color[i]);
  }
  parameters.Medium = *request.Medium;
  parameters.Spot = light.Spot;
  return parameters;
}

bool vtkGodRaysWalkedLight::Has(
  const vtkGodRaysInScattering::Parameters& parameters, const int size[2], unsigned int ends)
{
  FillNumbers(parameters, size, ends, this->Asked);
  return !this->Walked.empty() && this->Walked == this->Asked;
}

bool vtkGodRaysWalkedLight::Add(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysInScattering::Parameters& parameters, const int size[2], unsigned int ends)
{
  const bool grey = IsGrey(request, parameters);
  vtkGodRaysTarget& sum = this->Rays[grey ? 0 : 1];
  this->Unchanged = this->Has(parameters, size, ends);
  if (!this->Unchanged)
  {
    this->Walked.clear(); // keeps its memory
    this->Walk.Execute(parameters);
    if (!request.Result->Settle()) // what is lent may be these rays, of another light
    {
      return false;
    }
    sum.Prepare(request.Window, size[0], size[1],
      { static_cast<unsigned int>(grey ? GL_R32F : GL_RGBA32F), 0 });
    sum.Write(grey ? GL_RED : GL_RGB, GL_FLOAT, this->Walk.GetResult());
    this->Walked.swap(this->Asked);
    this->Description = this->Walk.Describe();
  }
  return request.Result->Lend(sum, request.Light->Color, request.View->ViewScale);
}

void vtkGodRaysWalkedLight::Release(vtkWindow* window)
{
  this->Walked.clear();
  this->Rays[0].Release(window);
  this->Rays[1].Release(window);
}
