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

namespace
{
/// Whether one channel serves a light of any colour.
bool IsGrey(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysInScattering::Parameters& parameters)
{
  const vtkGodRaysShadowGrids* shadows = parameters.Shadows;
  return request.Medium->IsGrey() && !(shadows && shadows->NumberOfLayers > 0 && shadows->Colored);
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

bool vtkGodRaysWalkedLight::Add(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysInScattering::Parameters& parameters, const int size[2])
{
  this->Walk.Execute(parameters);
  if (!request.Result->Settle()) // what is lent may be these rays, of another light
  {
    return false;
  }
  const bool grey = IsGrey(request, parameters);
  vtkGodRaysTarget& sum = this->Rays[grey ? 0 : 1];
  sum.Prepare(request.Window, size[0], size[1],
    { static_cast<unsigned int>(grey ? GL_R32F : GL_RGBA32F), 0 });
  sum.Write(grey ? GL_RED : GL_RGB, GL_FLOAT, this->Walk.GetResult());
  return request.Result->Lend(sum, request.Light->Color, request.View->ViewScale);
}

void vtkGodRaysWalkedLight::Release(vtkWindow* window)
{
  this->Rays[0].Release(window);
  this->Rays[1].Release(window);
}
