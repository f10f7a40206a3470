// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumRays.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
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
void SetNumber(vtkShaderProgram* program, const char* name, double value)
{
  program->SetUniformf(name, static_cast<float>(value));
}

void SetPair(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

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

vtkGodRaysFroxels::Picture vtkGodRaysMediumRays::GetPicture() const
{
  const double scale = this->Request.View->ViewScale;
  vtkGodRaysFroxels::Picture picture;
  picture.Size[0] = this->Request.Result->GetWidth();
  picture.Size[1] = this->Request.Result->GetHeight();
  picture.PixelSize = this->Pinhole.PixelSize * scale * this->LayerSize[1] / picture.Size[1];
  for (int i = 0; i < 2; ++i)
  {
    picture.Center[i] =
      (0.5 + (this->Pinhole.Center[i] / this->LayerSize[i] - 0.5) / scale) * picture.Size[i];
  }
  return picture;
}

bool vtkGodRaysMediumRays::IsClosed() const
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
  program->SetUniformf("maximum", result.GetFormat() == GL_RGBA16F ? 65504.0f : 1e30f);
  this->SetComponents(program);
}

void vtkGodRaysMediumRays::SetComponents(vtkShaderProgram* program) const
{
  constexpr int each = vtkGodRaysMedium::MaximumComponents;
  const vtkGodRaysMedium& medium = *this->Request.Medium;
  float numbers[3 * each][8] = {};
  for (int i = 0; i < 3 * each; ++i)
  {
    if (i % each < medium.NumberOfComponents)
    {
      const auto& component = medium.Components[i % each];
      const double scattering = component.Scattering[i / each];
      const double values[8] = { scattering, scattering + component.Absorption[i / each],
        component.ScaleHeight, component.SecondWeight, component.PhaseFunction + 0.0,
        component.Asymmetry, component.SecondPhaseFunction + 0.0, component.SecondAsymmetry };
      std::copy_n(values, 8, numbers[i]);
    }
  }
  program->SetUniform4fv("components", 6 * each, numbers[0]);
}
