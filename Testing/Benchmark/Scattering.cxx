// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysReferenceFilter.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{
/// Halves, so that the channels of a layer in 16 bits are exact multiples.
const double Tints[3] = { 1.0, 0.5, 0.25 };
}

//------------------------------------------------------------------------------
Scattering::Scattering(Device& device)
  : OpenGL(device)
{
  this->Model->SetDecay(0.99);
  this->Model->SetWeight(0.01);
}

//------------------------------------------------------------------------------
Scattering::~Scattering()
{
  for (auto& target : this->Targets)
  {
    target.second.Release(this->OpenGL.GetWindow());
  }
  this->Result.Release(this->OpenGL.GetWindow());
}

//------------------------------------------------------------------------------
void Scattering::SetCase(
  const GodRaysPictures::Mask& mask, const GodRaysPictures::Light& light, int referenceRows)
{
  for (auto& target : this->Targets)
  {
    target.second.Release(this->OpenGL.GetWindow());
  }
  this->Targets.clear();
  this->Reference.clear();
  this->Rows.clear();
  for (int i = 0; i < referenceRows; ++i) // one at random in each of so many strips
  {
    this->Rows.push_back(
      static_cast<int>((i + GodRaysPictures::Hash(i, 3)) * mask.Height / referenceRows));
  }
  this->Layer->SetDimensions(mask.Width, mask.Height, 1);
  this->Layer->AllocateScalars(VTK_FLOAT, 1);
  const std::vector<float> layer = GodRaysPictures::MakeLayer(mask, light);
  std::copy(layer.begin(), layer.end(), static_cast<float*>(this->Layer->GetScalarPointer()));
  this->LightClip[0] = 2.0 * light.U - 1.0;
  this->LightClip[1] = 2.0 * light.V - 1.0;
  this->LightClip[2] = 1.0;
  // as vtkGodRaysPass has it: at most one and a half diagonals
  const double aspect = static_cast<double>(mask.Width) / mask.Height;
  this->MarchScale =
    vtkGodRays::MarchScale({ this->LightClip[0], this->LightClip[1], this->LightClip[2] }, aspect,
      3.0 * std::hypot(aspect, 1.0));
}

//------------------------------------------------------------------------------
vtkGodRaysTarget& Scattering::GetTarget(const Method& method, Content content)
{
  const unsigned int one =
    content == ONE_COLOR ? method.Integrator->GetOneColorFormat(this->Model, GL_RGBA16F) : 0;
  const unsigned int format = one ? one : GL_RGBA16F;
  vtkGodRaysTarget& target = this->Targets[format];
  if (!target.IsReady())
  {
    const int* size = this->Layer->GetDimensions();
    const auto* values = static_cast<const float*>(this->Layer->GetScalarPointer());
    target.Prepare(this->OpenGL.GetWindow(), size[0], size[1], { format, 0 });
    if (one)
    {
      target.Write(GL_RED, GL_FLOAT, values);
    }
    else
    {
      const std::size_t count = static_cast<std::size_t>(size[0]) * size[1];
      std::vector<float> colors(3 * count);
      for (std::size_t i = 0; i < 3 * count; ++i)
      {
        colors[i] = static_cast<float>(Tints[i % 3] * values[i / 3]);
      }
      target.Write(GL_RGB, GL_FLOAT, colors.data());
    }
  }
  return target;
}

//------------------------------------------------------------------------------
bool Scattering::HasOneChannel(const Method& method)
{
  return method.Integrator->GetOneColorFormat(this->Model, GL_RGBA16F) != 0;
}

//------------------------------------------------------------------------------
double Scattering::Run(const Method& method, Content content)
{
  vtkOpenGLRenderWindow* window = this->OpenGL.GetWindow();
  window->MakeCurrent();
  const int* size = this->Layer->GetDimensions();
  vtkGodRaysRadialIntegrator::Request request;
  request.Window = window;
  request.Model = this->Model;
  request.Layer = &this->GetTarget(method, content);
  vtkGodRaysLight light;
  std::copy_n(Tints, 3, light.Color);
  std::copy_n(this->LightClip, 3, light.Clip);
  light.MarchScale = this->MarchScale;
  request.Light = &light;
  request.ErrorTolerance = method.Tolerance;
  request.Result = &this->Result;
  vtkOpenGLState* state = window->GetState();
  return this->OpenGL.Measure(
    [&]()
    {
      state->PushFramebufferBindings();
      this->Result.Begin(window, size[0], size[1], GL_RGBA16F);
      if (!method.Integrator->Integrate(request))
      {
        std::fprintf(
          stderr, "godrays_benchmark: %s failed, see the message above.\n", method.Name.c_str());
        std::exit(EXIT_FAILURE);
      }
      state->PopFramebufferBindings();
    });
}

//------------------------------------------------------------------------------
const std::vector<double>& Scattering::GetReference()
{
  if (this->Reference.empty())
  {
    vtkNew<vtkGodRaysReferenceFilter> filter;
    filter->SetInputData(this->Layer);
    filter->SetDensity(this->Model->GetDensity());
    filter->SetDecay(this->Model->GetDecay());
    filter->SetWeight(this->Model->GetWeight());
    filter->SetExposure(this->Model->GetExposure());
    filter->SetNumberOfSamples(this->Model->GetNumberOfSamples());
    filter->SetLightClip(this->LightClip);
    filter->SetMarchScale(this->MarchScale);
    const int width = this->Layer->GetDimensions()[0];
    for (int y : this->Rows)
    {
      const int extent[6] = { 0, width - 1, y, y, 0, 0 };
      filter->UpdateExtent(extent);
      const auto* row = static_cast<const double*>(filter->GetOutput()->GetScalarPointer());
      this->Reference.insert(this->Reference.end(), row, row + width);
    }
  }
  return this->Reference;
}

//------------------------------------------------------------------------------
Errors Scattering::Compare(Content content)
{
  const std::vector<double>& reference = this->GetReference();
  const double peak = *std::max_element(reference.begin(), reference.end());
  vtkNew<vtkImageData> result;
  vtkOpenGLState* state = this->OpenGL.GetWindow()->GetState();
  state->PushFramebufferBindings();
  this->Result.Download(result);
  state->PopFramebufferBindings();
  const int width = this->Layer->GetDimensions()[0];
  const int channels = content == RGB ? 3 : 1;
  std::vector<double> errors;
  errors.reserve(channels * reference.size());
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    const auto* values = static_cast<const float*>(result->GetScalarPointer(0, this->Rows[row], 0));
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < channels; ++c)
      {
        // each channel as a fraction of its own peak
        const double error = (values[3 * x + c] / Tints[c] - reference[row * width + x]) / peak;
        errors.push_back(std::abs(error));
        squares += error * error;
        sum += error;
      }
    }
  }
  Errors all;
  all.RMS = std::sqrt(squares / errors.size());
  all.Bias = sum / errors.size();
  all.Largest = *std::max_element(errors.begin(), errors.end());
  const auto permille = errors.begin() + static_cast<std::ptrdiff_t>(0.999 * (errors.size() - 1));
  std::nth_element(errors.begin(), permille, errors.end());
  all.Permille = *permille;
  return all;
}
