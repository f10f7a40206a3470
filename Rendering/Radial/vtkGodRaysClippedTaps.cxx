// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysClippedTaps.h"

#include "vtkGodRaysClippedTapsFS.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Beyond t = KernelEnd/k, e^(-k t) is below a float's precision.
constexpr double KernelEnd = 17.0;

// On black and white noise from pixel to pixel, with steps of h <= 1 pixels, the error is at most
// NoiseError h^2/sqrt(pixels that are summed) [of the peak]; measured.
constexpr double NoiseError = 0.1;

// How long marches are within the layer, about [pixels].
double GetLength(const vtkGodRaysMarch& march)
{
  const double size = std::min(march.LayerSize[0], march.LayerSize[1]);
  return std::min(0.5 * march.GetLongest(), 0.5 * size);
}

double ChooseTapsPerPixel(const vtkGodRaysMarch& march, double tolerance)
{
  const double summed = std::max(1.0, GetLength(march) / std::max(1.0, std::abs(march.K)));
  const double perPixel =
    std::sqrt(march.GetGrowth() * NoiseError / (tolerance * std::sqrt(summed)));
  return std::min(std::max(1.0, perPixel), 16.0);
}
}

vtkGodRaysClippedTaps::vtkGodRaysClippedTaps()
  : Quad("vtkGodRaysClippedTapsFS", vtkGodRaysClippedTapsFS)
{
}

bool vtkGodRaysClippedTaps::Integrate(
  const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march)
{
  this->TapsPerPixel = ChooseTapsPerPixel(march, request.ErrorTolerance);
  const bool oneChannel = request.Layer->HasOneChannel();
  if (!request.Result->BindToAdd())
  {
    return false;
  }
  vtkShaderProgram* program = this->Quad.Begin(request.Window, { { "OneChannel", oneChannel } });
  if (!program)
  {
    return false;
  }
  const auto set = [program](const char* name, const auto(&values)[2])
  {
    const float floats[2] = { static_cast<float>(values[0]), static_cast<float>(values[1]) };
    program->SetUniform2f(name, floats);
  };
  set("size", march.PictureSize);
  set("layerSize", march.LayerSize);
  set("origin", march.Origin);
  set("pixel", march.Step);
  set("marchConstant", march.Constant);
  program->SetUniformf("marchSlope", static_cast<float>(march.Slope));
  program->SetUniformf("k", static_cast<float>(march.K));
  const double reach = march.K > KernelEnd ? KernelEnd / march.K : 1.0;
  program->SetUniformf("reach", static_cast<float>(reach));
  program->SetUniformf("tapsPerPixel", static_cast<float>(this->TapsPerPixel));
  float gain[3];
  for (int c = 0; c < 3; ++c)
  {
    gain[c] = static_cast<float>(march.Gain * (oneChannel ? request.Light->Color[c] : 1.0));
  }
  program->SetUniform3f("gain", gain);
  vtkTextureObject* layer = request.Layer->GetColor();
  layer->SetWrapS(vtkTextureObject::ClampToBorder);
  layer->SetWrapT(vtkTextureObject::ClampToBorder);
  this->Quad.SetTexture("layer", layer);
  this->Quad.End();
  return true;
}

double vtkGodRaysClippedTaps::CountTaps(const vtkGodRaysMarch& march, double tolerance)
{
  return ChooseTapsPerPixel(march, tolerance) * march.GetLengthWithin() * march.PictureSize[0] *
    march.PictureSize[1];
}

std::string vtkGodRaysClippedTaps::Describe() const
{
  std::ostringstream text;
  text << "taps: " << this->TapsPerPixel << " for each pixel of a march within the layer";
  return text.str();
}

void vtkGodRaysClippedTaps::Release()
{
  this->Quad.Release();
}
