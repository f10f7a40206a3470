// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysEpipolarIntegrator.h"

#include "vtkGodRaysBlockMeans.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRadialSweep.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysTarget.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysEpipolarIntegrator);

struct vtkGodRaysEpipolarIntegrator::Internals
{
  vtkNew<vtkGodRaysTapsIntegrator> Taps;
  vtkGodRaysRadialSweep Sweep;
  vtkGodRaysBlockMeans BlockMeans;
  std::string Plan = "nothing yet"; // what was done last
  std::vector<float> Pixels;        // of layers and rays of three channels
  vtkGodRaysTarget Rays[2];         // of one channel, and of three

  bool IntegrateOnProcessor(const Request& request);
  bool IntegrateOnGraphics(const Request& request);
};

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

bool vtkGodRaysEpipolarIntegrator::Internals::IntegrateOnGraphics(const Request& request)
{
  const bool done = this->BlockMeans.Integrate(request, request.GetMarch());
  this->Plan = "in shaders: " + this->BlockMeans.Describe();
  return done;
}

vtkGodRaysEpipolarIntegrator::vtkGodRaysEpipolarIntegrator()
  : Internal(new Internals)
{
}

vtkGodRaysEpipolarIntegrator::~vtkGodRaysEpipolarIntegrator() = default;

unsigned int vtkGodRaysEpipolarIntegrator::GetOneColorFormat(
  vtkGodRaysModel* model, unsigned int precision)
{
  if (!vtkGodRaysRadialModel::SafeDownCast(model))
  {
    return 0;
  }
  return this->UsesProcessor() || precision == GL_RGBA32F ? GL_R32F : GL_R16F; // nothing to convert
}

bool vtkGodRaysEpipolarIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  if (!vtkGodRaysRadialModel::SafeDownCast(request.Model))
  {
    return self.Taps->Integrate(request);
  }
  return this->UsesProcessor() ? self.IntegrateOnProcessor(request)
                               : self.IntegrateOnGraphics(request);
}

std::string vtkGodRaysEpipolarIntegrator::Describe(vtkGodRaysModel* model)
{
  if (!vtkGodRaysRadialModel::SafeDownCast(model))
  {
    return this->Internal->Taps->Describe(model) + ", as published";
  }
  return "epipolar, " + this->Internal->Plan;
}

void vtkGodRaysEpipolarIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Taps->ReleaseGraphicsResources(window);
  this->Internal->BlockMeans.Release(window);
  this->Internal->Rays[0].Release(window);
  this->Internal->Rays[1].Release(window);
}

void vtkGodRaysEpipolarIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n";
}
