// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumRays.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysMediumRaysFS.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSum.h"
#include "vtkMatrix4x4.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
/// Into which a ray is divided whose airlight has no closed form.
constexpr int TotalParts = 32;

void SetNumber(vtkShaderProgram* program, const char* name, double value)
{
  program->SetUniformf(name, static_cast<float>(value));
}

void SetPair(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

/// The names of a component's uniforms; they are made once, as they are needed in each frame.
struct ComponentNames
{
  explicit ComponentNames(int number)
    : Component("components[" + std::to_string(number) + "].")
  {
  }

  const std::string Component;
  const std::string Scattering = Component + "Scattering";
  const std::string Extinction = Component + "Extinction";
  const std::string ScaleHeight = Component + "ScaleHeight";
  const std::string Kinds[2] = { Component + "First.Kind", Component + "Second.Kind" };
  const std::string Asymmetries[2] = { Component + "First.Asymmetry",
    Component + "Second.Asymmetry" };
  const std::string SecondWeight = Component + "SecondWeight";
};

const ComponentNames& GetNames(int number)
{
  static const std::vector<ComponentNames> all = []
  {
    std::vector<ComponentNames> names;
    for (int i = 0; i < 3 * vtkGodRaysMedium::MaximumComponents; ++i)
    {
      names.emplace_back(i);
    }
    return names;
  }();
  return all[static_cast<std::size_t>(number)];
}
}

std::string vtkGodRaysMediumRays::Complete(const char* shader)
{
  std::string text = shader;
  vtkShaderProgram::Substitute(text, "//VTK::GodRays::MediumRays", vtkGodRaysMediumRaysFS);
  return text;
}

vtkGodRaysMediumRays::vtkGodRaysMediumRays(
  const vtkGodRaysMediumIntegrator::Request& request, const int layerSize[2])
  : Request(request)
  , LayerSize{ layerSize[0], layerSize[1] }
{
  request.View->GetPinhole(layerSize, this->Pinhole);
}

vtkGodRaysSingleScattering::Parameters vtkGodRaysMediumRays::GetWorldParameters(
  const vtkGodRaysMediumIntegrator::Request& request)
{
  double toWorld[16];
  vtkMatrix4x4::Invert(request.View->WorldToView, toWorld);
  vtkGodRaysSingleScattering::Parameters parameters;
  for (int i = 0; i < 3; ++i)
  {
    parameters.Right[i] = toWorld[4 * i];
    parameters.Up[i] = toWorld[4 * i + 1];
    parameters.Forward[i] = toWorld[4 * i + 2];
    parameters.Position[i] = toWorld[4 * i + 3];
  }
  vtkMatrix4x4::MultiplyPoint(toWorld, request.Light->Position, parameters.Light);
  parameters.Parallel = request.View->Parallel;
  for (int i = 0; i < 3; ++i)
  {
    parameters.LightColor[i] = request.Light->Power * request.Light->Color[i];
  }
  parameters.Spot = request.Light->Spot;
  parameters.Medium = *request.Medium;
  return parameters;
}

bool vtkGodRaysMediumRays::IsParallel() const
{
  return this->Request.View->Parallel;
}

bool vtkGodRaysMediumRays::IsInfinite() const
{
  return this->Request.Light->IsInfinite();
}

bool vtkGodRaysMediumRays::IsGrey() const
{
  return this->Request.Medium->IsGrey();
}

bool vtkGodRaysMediumRays::IsUniform() const
{
  return this->IsInfinite() && !this->Request.Medium->HasExponentialDensity();
}

void vtkGodRaysMediumRays::Set(vtkShaderProgram* program) const
{
  const vtkGodRaysMedium& medium = *this->Request.Medium;
  const vtkGodRaysSum& result = *this->Request.Result;
  SetPair(program, "pictureSize", result.GetWidth(), result.GetHeight());
  SetPair(program, "layerSize", this->LayerSize[0], this->LayerSize[1]);
  SetNumber(program, "viewScale", this->Request.View->ViewScale);
  SetPair(program, "viewCenter", this->Pinhole.Center[0], this->Pinhole.Center[1]);
  SetNumber(program, "pixelSize", this->Pinhole.PixelSize);
  SetNumber(program, "farLimit", medium.FarLimit);
  const vtkGodRaysLight& light = *this->Request.Light;
  float position[4];
  std::copy_n(light.Position, 4, position);
  program->SetUniform4f("light", position);
  const double color[3] = { light.Power * light.Color[0], light.Power * light.Color[1],
    light.Power * light.Color[2] };
  vtkGodRaysQuad::SetVector(program, "lightColor", color);
  const glm::dvec3 up(medium.Up[0], medium.Up[1], medium.Up[2]);
  const glm::dvec3 place(light.Position[0], light.Position[1], light.Position[2]);
  SetNumber(program, "lightHeight",
    vtkGodRays::MediumStart(medium.PlanetRadius, medium.EyeHeight, up, place, up).x);
  SetNumber(program, "planetRadius", medium.PlanetRadius);
  vtkGodRaysQuad::SetVector(program, "spotAxis", light.Spot.Axis);
  SetNumber(program, "spotShape.CosCone", light.IsInfinite() ? 0.0 : light.Spot.CosCone);
  SetNumber(program, "spotShape.Exponent", light.Spot.Exponent);
  vtkGodRaysQuad::SetVector(program, "mediumUp", medium.Up);
  SetNumber(program, "eyeHeight", medium.EyeHeight);
  const bool closed = this->IsInfinite() &&
    (!medium.HasExponentialDensity() ||
      (medium.NumberOfComponents == 1 && medium.PlanetRadius == 0.0));
  program->SetUniformi("totalParts", closed ? 1 : TotalParts);
  program->SetUniformf("maximum", result.GetFormat() == GL_RGBA16F ? 65504.0f : 1e30f);
  this->SetComponents(program);
}

void vtkGodRaysMediumRays::SetComponents(vtkShaderProgram* program) const
{
  const vtkGodRaysMedium& medium = *this->Request.Medium;
  const vtkGodRaysMedium::Component empty;
  for (int channel = 0; channel < (this->IsGrey() ? 1 : 3); ++channel)
  {
    for (int k = 0; k < vtkGodRaysMedium::MaximumComponents; ++k)
    {
      const auto& component = k < medium.NumberOfComponents ? medium.Components[k] : empty;
      const ComponentNames& names = GetNames(vtkGodRaysMedium::MaximumComponents * channel + k);
      const double scattering = component.Scattering[channel];
      SetNumber(program, names.Scattering.c_str(), scattering);
      SetNumber(program, names.Extinction.c_str(), scattering + component.Absorption[channel]);
      SetNumber(program, names.ScaleHeight.c_str(), component.ScaleHeight);
      program->SetUniformi(names.Kinds[0].c_str(), component.PhaseFunction);
      SetNumber(program, names.Asymmetries[0].c_str(), component.Asymmetry);
      program->SetUniformi(names.Kinds[1].c_str(), component.SecondPhaseFunction);
      SetNumber(program, names.Asymmetries[1].c_str(), component.SecondAsymmetry);
      SetNumber(program, names.SecondWeight.c_str(), component.SecondWeight);
    }
  }
}
