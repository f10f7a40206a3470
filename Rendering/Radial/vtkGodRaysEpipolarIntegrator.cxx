// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysEpipolarIntegrator.h"

#include "vtkGodRaysBlockMeans.h"
#include "vtkGodRaysClippedTaps.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRadialSweep.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysTarget.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysEpipolarIntegrator);

namespace
{
/// Whether OpenGL runs on the processor; its context is current.
bool IsSoftware()
{
  const auto name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  for (const char* software : { "llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR",
         "SwiftShader", "GDI Generic" })
  {
    if (renderer.find(software) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
struct vtkGodRaysEpipolarIntegrator::Internals
{
  vtkNew<vtkGodRaysTapsIntegrator> Taps;
  vtkGodRaysRadialSweep Sweep;
  vtkGodRaysBlockMeans BlockMeans;
  vtkGodRaysClippedTaps ClippedTaps;
  std::string Plan = "nothing yet";        // what was done last
  std::vector<float> Pixels;               // of layers and rays of three channels
  vtkGodRaysTarget Rays[2];                // of one channel, and of three
  vtkOpenGLRenderWindow* Window = nullptr; // that Software is known of
  vtkMTimeType ContextTime = 0;
  bool Software = false;

  bool UsesProcessor(int backend, vtkOpenGLRenderWindow* window)
  {
    if (this->Window != window || this->ContextTime != window->GetContextCreationTime())
    {
      this->Window = window;
      this->ContextTime = window->GetContextCreationTime();
      this->Software = IsSoftware();
    }
    return backend == PROCESSOR || (backend == AUTOMATIC && this->Software);
  }

  bool IntegrateOnProcessor(const Request& request);
  bool IntegrateOnGraphics(const Request& request);
};

namespace
{
/// What a picture holds before and after the light of a layer was added to it, against that light.
struct Verification
{
  double RootMeanSquare = 0.0; // [fraction of the brightest]
  double Largest = 0.0;

  void Measure(const vtkGodRaysRadialIntegrator::Request& request, vtkGodRaysRadialModel* model,
    vtkImageData* before, int wanted);
};

void Verification::Measure(const vtkGodRaysRadialIntegrator::Request& request,
  vtkGodRaysRadialModel* model, vtkImageData* before, int wanted)
{
  const int taps = 2048;
  vtkNew<vtkImageData> after;
  vtkNew<vtkImageData> layer;
  if (!request.Result->Download(after))
  {
    return;
  }
  request.Layer->Download(layer, request.Light->Color);
  const vtkGodRays::ImageLayer emitter = { static_cast<const float*>(layer->GetScalarPointer()),
    request.Layer->GetWidth(), request.Layer->GetHeight(), vtkGodRays::BORDER_ZERO };
  const float* values = static_cast<const float*>(after->GetScalarPointer());
  const float* former = before->GetNumberOfPoints() > 0
    ? static_cast<const float*>(before->GetScalarPointer())
    : nullptr;
  const int width = request.Result->GetWidth();
  const int height = request.Result->GetHeight();
  std::vector<vtkGodRays::TapSum> passes;
  model->GetTapSums(passes, taps);
  const double* light = request.Light->Clip;
  const vtkGodRays::Vec3 clip(light[0], light[1], light[2]);

  // one pixel at random of each of as many parts of the picture, the same ones every time
  const std::int64_t total = static_cast<std::int64_t>(width) * height;
  const std::int64_t pixels = std::min<std::int64_t>(wanted, total);
  std::mt19937 generator(5489);
  std::vector<std::int64_t> places;
  for (std::int64_t i = 0; i < pixels; ++i)
  {
    const std::int64_t first = i * total / pixels;
    const std::int64_t next = (i + 1) * total / pixels;
    places.push_back(first + static_cast<std::int64_t>(generator()) % (next - first));
  }
  std::vector<double> errors(places.size(), 0.0); // of the worst channel
  vtkSMPTools::For(0, pixels,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkGodRays::Vec2 picture(
          (places[i] % width + 0.5) / width, (places[i] / width + 0.5) / height);
        const vtkGodRays::Vec2 uv = 0.5 + (picture - 0.5) * request.ViewScale;
        const vtkGodRays::Vec3 exact = vtkGodRays::SumTaps(emitter, passes[0], uv,
          vtkGodRays::MarchVector(clip, 2.0 * uv - 1.0, request.Light->MarchScale));
        for (int c = 0; c < 3; ++c)
        {
          const std::size_t at = 3 * static_cast<std::size_t>(places[i]) + c;
          const double got = values[at] - (former ? former[at] : 0.0f);
          errors[i] = std::max(errors[i], std::abs(got - exact[c]));
        }
      }
    });

  double brightest = 0.0;
  for (std::int64_t i = 0; i < 3 * total; ++i)
  {
    brightest = std::max(brightest, values[i] - (former ? former[i] : 0.0));
  }
  double squares = 0.0;
  for (double error : errors)
  {
    squares += error * error;
    this->Largest = std::max(this->Largest, error);
  }
  const double scale = brightest > 0.0 ? 1.0 / brightest : 1.0;
  this->RootMeanSquare = std::sqrt(squares / pixels) * scale;
  this->Largest *= scale;
}
}

//------------------------------------------------------------------------------
bool vtkGodRaysEpipolarIntegrator::Internals::IntegrateOnProcessor(const Request& request)
{
  const bool oneColor = request.Layer->HasOneChannel();
  const int width = request.Layer->GetWidth();
  const int height = request.Layer->GetHeight();
  if (oneColor)
  {
    // values that a light of one colour has, 0 to 1, need no check
    const auto input = this->Sweep.PrepareInput(width, height, 1);
    request.Layer->Read(GL_RED, GL_FLOAT, input.Values[0], static_cast<int>(input.Stride));
  }
  else
  {
    this->Pixels.resize(3 * static_cast<std::size_t>(width) * height);
    request.Layer->Read(GL_RGB, GL_FLOAT, this->Pixels.data(), 0);
    this->Sweep.LoadInput(this->Pixels.data(), width, height, 3);
  }

  vtkGodRaysRadialSweep::Parameters parameters;
  static_cast<vtkGodRaysMarchParameters&>(parameters) = request.GetMarchParameters();
  parameters.ErrorTolerance = request.ErrorTolerance;
  this->Sweep.Execute(parameters);

  if (!request.Result->Settle()) // what is lent may be these rays, of another light
  {
    return false;
  }
  vtkGodRaysTarget& rays = this->Rays[oneColor ? 0 : 1];
  rays.Prepare(request.Window, width, height,
    { static_cast<unsigned int>(oneColor ? GL_R32F : GL_RGBA32F), 0 });
  if (oneColor)
  {
    rays.Write(GL_RED, GL_FLOAT, this->Sweep.GetResult(0));
  }
  else
  {
    const float* planes[3];
    for (int c = 0; c < 3; ++c)
    {
      planes[c] = this->Sweep.GetResult(c);
    }
    vtkSMPTools::For(0, height,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin * width; i < end * width; ++i)
        {
          for (int c = 0; c < 3; ++c)
          {
            this->Pixels[3 * i + c] = planes[c][i];
          }
        }
      });
    rays.Write(GL_RGB, GL_FLOAT, this->Pixels.data());
  }
  this->Plan = "on the processor: " + this->Sweep.Describe();
  return request.Result->Lend(rays, request.Light->Color, request.ViewScale);
}

//------------------------------------------------------------------------------
bool vtkGodRaysEpipolarIntegrator::Internals::IntegrateOnGraphics(const Request& request)
{
  const bool keeps = vtkGodRaysBlockMeans::Keeps(request);
  const bool done =
    keeps ? this->BlockMeans.Integrate(request) : this->ClippedTaps.Integrate(request);
  this->Plan =
    "in shaders: " + (keeps ? this->BlockMeans.Describe() : this->ClippedTaps.Describe());
  return done;
}

//------------------------------------------------------------------------------
vtkGodRaysEpipolarIntegrator::vtkGodRaysEpipolarIntegrator()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysEpipolarIntegrator::~vtkGodRaysEpipolarIntegrator() = default;

//------------------------------------------------------------------------------
unsigned int vtkGodRaysEpipolarIntegrator::GetOneColorFormat(
  vtkOpenGLRenderWindow* window, vtkGodRaysModel* model, unsigned int precision)
{
  if (!vtkGodRaysRadialModel::SafeDownCast(model))
  {
    return 0;
  }
  const bool processor = this->Internal->UsesProcessor(this->Backend, window);
  return processor || precision == GL_RGBA32F ? GL_R32F : GL_R16F; // nothing to convert
}

//------------------------------------------------------------------------------
bool vtkGodRaysEpipolarIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  auto model = vtkGodRaysRadialModel::SafeDownCast(request.Model);
  const bool isFirst = request.Result->IsEmpty();
  if (isFirst)
  {
    this->ErrorEstimate = -1.0;
    this->LargestVerifiedError = -1.0;
  }
  if (!model)
  {
    return self.Taps->Integrate(request);
  }
  vtkNew<vtkImageData> before;
  if (this->VerifyPixels > 0 && !isFirst)
  {
    request.Result->Download(before);
  }
  if (!(self.UsesProcessor(this->Backend, request.Window) ? self.IntegrateOnProcessor(request)
                                                          : self.IntegrateOnGraphics(request)))
  {
    return false;
  }
  if (this->VerifyPixels > 0)
  {
    Verification verification;
    verification.Measure(request, model, before, this->VerifyPixels);
    this->ErrorEstimate = std::max(this->ErrorEstimate, verification.RootMeanSquare);
    this->LargestVerifiedError = std::max(this->LargestVerifiedError, verification.Largest);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkGodRaysEpipolarIntegrator::Describe(vtkGodRaysModel* model)
{
  if (!vtkGodRaysRadialModel::SafeDownCast(model))
  {
    return this->Internal->Taps->Describe(model) + ", as published";
  }
  return "epipolar, " + this->Internal->Plan;
}

//------------------------------------------------------------------------------
void vtkGodRaysEpipolarIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Taps->ReleaseGraphicsResources(window);
  this->Internal->BlockMeans.Release(window);
  this->Internal->ClippedTaps.Release();
  this->Internal->Rays[0].Release(window);
  this->Internal->Rays[1].Release(window);
  this->Internal->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkGodRaysEpipolarIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "VerifyPixels: " << this->VerifyPixels << "\n";
  os << indent << "ErrorEstimate: " << this->ErrorEstimate << "\n";
  os << indent << "LargestVerifiedError: " << this->LargestVerifiedError << "\n";
}
