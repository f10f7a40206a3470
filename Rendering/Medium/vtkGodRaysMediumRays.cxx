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
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>

namespace
{
/// Into which a ray is divided whose airlight has no closed form.
constexpr int TotalParts = 32;

void SetNumber(vtkShaderProgram* program, const std::string& name, double value)
{
  program->SetUniformf(name.c_str(), static_cast<float>(value));
}

void SetPair(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

void SetPhase(vtkShaderProgram* program, const std::string& name, int kind, double asymmetry)
{
  program->SetUniformi((name + ".Kind").c_str(), kind);
  SetNumber(program, name + ".Asymmetry", asymmetry);
}
}

//------------------------------------------------------------------------------
std::string vtkGodRaysMediumRays::Complete(const char* shader)
{
  std::string text = shader;
  vtkShaderProgram::Substitute(text, "//VTK::GodRays::MediumRays", vtkGodRaysMediumRaysFS);
  return text;
}

//------------------------------------------------------------------------------
vtkGodRaysMediumRays::vtkGodRaysMediumRays(
  const vtkGodRaysMediumIntegrator::Request& request, const int layerSize[2])
  : Request(request)
  , LayerSize{ layerSize[0], layerSize[1] }
{
  request.View->GetPinhole(layerSize, this->Pinhole);
}

//------------------------------------------------------------------------------
bool vtkGodRaysMediumRays::IsParallel() const
{
  return this->Request.View->Parallel;
}

//------------------------------------------------------------------------------
bool vtkGodRaysMediumRays::IsInfinite() const
{
  return this->Request.Light->IsInfinite();
}

//------------------------------------------------------------------------------
bool vtkGodRaysMediumRays::IsGrey() const
{
  return this->Request.Medium->IsGrey();
}

//------------------------------------------------------------------------------
bool vtkGodRaysMediumRays::IsUniform() const
{
  return this->IsInfinite() && !this->Request.Medium->HasExponentialDensity();
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void vtkGodRaysMediumRays::SetComponents(vtkShaderProgram* program) const
{
  const vtkGodRaysMedium& medium = *this->Request.Medium;
  const vtkGodRaysMedium::Component empty;
  for (int channel = 0; channel < (this->IsGrey() ? 1 : 3); ++channel)
  {
    for (int k = 0; k < vtkGodRaysMedium::MaximumComponents; ++k)
    {
      const auto& component = k < medium.NumberOfComponents ? medium.Components[k] : empty;
      const std::string name =
        "components[" + std::to_string(vtkGodRaysMedium::MaximumComponents * channel + k) + "].";
      const double scattering = component.Scattering[channel];
      SetNumber(program, name + "Scattering", scattering);
      SetNumber(program, name + "Extinction", scattering + component.Absorption[channel]);
      SetNumber(program, name + "ScaleHeight", component.ScaleHeight);
      SetPhase(program, name + "First", component.PhaseFunction, component.Asymmetry);
      SetPhase(program, name + "Second", component.SecondPhaseFunction, component.SecondAsymmetry);
      SetNumber(program, name + "SecondWeight", component.SecondWeight);
    }
  }
}
