// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysEpipolarCoverageIntegrator.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSolidLayers.h"
#include "vtkGodRaysSweptLight.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"

vtkStandardNewMacro(vtkGodRaysEpipolarCoverageIntegrator);

vtkGodRaysSetFiniteMacro(vtkGodRaysEpipolarCoverageIntegrator, Thickness, 0.0, 1.0);

struct vtkGodRaysEpipolarCoverageIntegrator::Internals
{
  vtkGodRaysSweptLight Swept;
  vtkNew<vtkGodRaysSolidLayers> Solid;
  bool ToldOfLayers = false; // that there are none on several processes
  unsigned int Frame = 0;    // whose depths the sweep has
  int Layers = 0;            // as well as so many
  std::string Plan = "nothing yet";

  bool LoadDepths(const Request& request, int layers);
};

// Once a frame, however many lights it has.
bool vtkGodRaysEpipolarCoverageIntegrator::Internals::LoadDepths(const Request& request, int layers)
{
  vtkGodRaysViewDepths& depths = *request.Depths;
  if (this->Frame == depths.GetFrame() && this->Layers == layers)
  {
    return true;
  }
  vtkGodRaysTarget* const targets[2] = { depths.GetOccluders(), depths.GetEnds() };
  if (!targets[0] || !targets[1])
  {
    return false;
  }
  const int solid = layers > 0 ? 2 * layers : 1;
  const int planes = solid + (depths.HasEnds() ? 1 : 0);
  const auto input =
    this->Swept.Sweep.PrepareInput(targets[0]->GetWidth(), targets[0]->GetHeight(), planes);
  const int stride = static_cast<int>(input.Stride);
  targets[0]->Read(GL_RED, GL_FLOAT, input.Values[0], stride);
  if (depths.HasEnds())
  {
    targets[1]->Read(GL_RED, GL_FLOAT, input.Values[solid], stride);
  }
  if (solid > 1 && !this->Solid->Draw(request, solid - 1))
  {
    return false;
  }
  for (int i = 1; i < solid; ++i)
  {
    if (!this->Solid->Read(request, i - 1, input.Values[i], stride))
    {
      return false;
    }
  }
  this->Layers = layers;
  this->Frame = depths.GetFrame();
  return true;
}

vtkGodRaysEpipolarCoverageIntegrator::vtkGodRaysEpipolarCoverageIntegrator()
  : Internal(new Internals)
{
}

vtkGodRaysEpipolarCoverageIntegrator::~vtkGodRaysEpipolarCoverageIntegrator() = default;

bool vtkGodRaysEpipolarCoverageIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  const bool distributed = request.Compositor && request.Compositor->IsDistributed();
  const int layers = distributed ? 0 : this->NumberOfLayers;
  if (layers < this->NumberOfLayers && !self.ToldOfLayers)
  {
    self.ToldOfLayers = true;
    vtkWarningMacro(
      "There are no solid layers, since the scene is on several processes, which join its "
      "first surface alone: it is taken to be Thickness thick. Set NumberOfLayers to 0, or "
      "use one process.");
  }
  if (!self.LoadDepths(request, layers))
  {
    return false;
  }
  vtkGodRaysTarget& depths = *request.Depths->GetOccluders();
  const int size[2] = { depths.GetWidth(), depths.GetHeight() };
  auto parameters = vtkGodRaysSweptLight::GetParameters(request, size);
  parameters.Thickness = this->Thickness;
  parameters.Layers = layers;
  const bool done = self.Swept.Add(request, parameters, size);
  self.Plan = self.Swept.Sweep.Describe();
  const auto translucent = std::count_if(request.Occluders->begin(), request.Occluders->end(),
    [](vtkProp* prop)
    { return prop->HasTranslucentPolygonalGeometry() || vtkGodRaysHasVolume(prop); });
  if (translucent > 0)
  {
    self.Plan +=
      "; " + std::to_string(translucent) + " translucent props or volumes cast no shadow";
  }
  return done;
}

std::string vtkGodRaysEpipolarCoverageIntegrator::Describe(vtkGodRaysModel*)
{
  return "epipolar coverage, on the processor: " + this->Internal->Plan;
}

void vtkGodRaysEpipolarCoverageIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Solid->ReleaseGraphicsResources(window);
  this->Internal->Swept.Release(window);
}

void vtkGodRaysEpipolarCoverageIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
}
