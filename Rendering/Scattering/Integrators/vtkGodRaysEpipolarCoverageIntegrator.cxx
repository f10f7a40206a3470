// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysEpipolarCoverageIntegrator.h"

#include "vtkGodRaysCoverageSweep.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSource.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysEpipolarCoverageIntegrator);

vtkGodRaysSetFiniteMacro(vtkGodRaysEpipolarCoverageIntegrator, Thickness, 0.0, 1.0);

//------------------------------------------------------------------------------
struct vtkGodRaysEpipolarCoverageIntegrator::Internals
{
  vtkGodRaysCoverageSweep Sweep;
  vtkGodRaysTarget Rays[2]; // of one channel, and of three
  unsigned int Frame = 0;   // whose depths the sweep has
  std::string Plan = "nothing yet";
  std::string Told; // of which light it was told that it cannot be evaluated

  bool LoadDepths(vtkGodRaysViewDepths& depths);
};

//------------------------------------------------------------------------------
// Once a frame, however many lights it has.
bool vtkGodRaysEpipolarCoverageIntegrator::Internals::LoadDepths(vtkGodRaysViewDepths& depths)
{
  if (this->Frame == depths.GetFrame())
  {
    return true;
  }
  vtkGodRaysTarget* const targets[2] = { depths.GetBlocking(), depths.GetEnds() };
  if (!targets[0] || !targets[1])
  {
    return false;
  }
  const int planes = depths.HasEnds() ? 2 : 1;
  const auto input =
    this->Sweep.PrepareInput(targets[0]->GetWidth(), targets[0]->GetHeight(), planes);
  for (int i = 0; i < planes; ++i)
  {
    targets[i]->Read(GL_RED, GL_FLOAT, input.Values[i], static_cast<int>(input.Stride));
  }
  this->Frame = depths.GetFrame();
  return true;
}

//------------------------------------------------------------------------------
vtkGodRaysEpipolarCoverageIntegrator::vtkGodRaysEpipolarCoverageIntegrator()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysEpipolarCoverageIntegrator::~vtkGodRaysEpipolarCoverageIntegrator() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysEpipolarCoverageIntegrator::Supports(vtkGodRaysModel* model)
{
  return vtkGodRaysMediumModel::SafeDownCast(model) != nullptr;
}

//------------------------------------------------------------------------------
bool vtkGodRaysEpipolarCoverageIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  if (!self.LoadDepths(*request.Depths))
  {
    return false;
  }
  vtkGodRaysTarget& depths = *request.Depths->GetBlocking();
  const int size[2] = { depths.GetWidth(), depths.GetHeight() };
  const vtkGodRaysView& view = *request.View;
  const vtkGodRaysSource& source = *request.Source;
  const vtkGodRaysMediumRays rays(request, size);

  vtkGodRaysCoverageSweep::Parameters parameters;
  parameters.PixelSize = rays.GetPinhole().PixelSize;
  std::copy_n(rays.GetPinhole().Center, 2, parameters.Center);
  parameters.Parallel = view.Parallel;
  std::copy_n(rays.GetLight(), 4, parameters.Light);
  const bool grey = request.Medium->IsGrey(); // then one channel serves a light of any colour
  for (int i = 0; i < 3; ++i)
  {
    parameters.LightColor[i] = source.Power * (grey ? 1.0 : source.Color[i]);
  }
  parameters.Medium = *request.Medium;
  parameters.Thickness = this->Thickness;
  if (!vtkGodRaysCoverageSweep::Supports(parameters))
  {
    this->TellThatNot(source.Name);
    return true;
  }
  self.Sweep.Execute(parameters);
  self.Plan = self.Sweep.Describe();

  if (!request.Result->Settle()) // what is lent may be these rays, of another light
  {
    return false;
  }
  vtkGodRaysTarget& sum = self.Rays[grey ? 0 : 1];
  sum.Prepare(request.Window, size[0], size[1],
    { static_cast<unsigned int>(grey ? GL_R32F : GL_RGBA32F), 0 });
  sum.Write(grey ? GL_RED : GL_RGB, GL_FLOAT, self.Sweep.GetResult());
  return request.Result->Lend(sum, source.Color, view.ViewScale);
}

//------------------------------------------------------------------------------
void vtkGodRaysEpipolarCoverageIntegrator::TellThatNot(const std::string& light)
{
  this->Internal->Plan = "the light \"" + light + "\" cannot be evaluated in this medium";
  if (this->Internal->Told != light)
  {
    this->Internal->Told = light;
    vtkWarningMacro("The light \""
      << light << "\" scatters nothing: its shadows cannot be evaluated in this medium. Use a "
      << "directional light, a homogeneous medium, or another integrator.");
  }
}

//------------------------------------------------------------------------------
std::string vtkGodRaysEpipolarCoverageIntegrator::Describe(vtkGodRaysModel*, double)
{
  return "epipolar coverage, on the processor: " + this->Internal->Plan;
}

//------------------------------------------------------------------------------
void vtkGodRaysEpipolarCoverageIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Rays[0].Release(window);
  this->Internal->Rays[1].Release(window);
}

//------------------------------------------------------------------------------
void vtkGodRaysEpipolarCoverageIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
}
