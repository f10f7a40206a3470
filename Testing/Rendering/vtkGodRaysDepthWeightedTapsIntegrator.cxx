// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysDepthWeightedTapsIntegrator.h"

#include "vtkGodRaysDepthWeightedTapsFS.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkObjectFactory.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkGodRaysDepthWeightedTapsIntegrator);

vtkGodRaysSetFiniteMacro(vtkGodRaysDepthWeightedTapsIntegrator, Thickness, 0.0, 1.0);

//------------------------------------------------------------------------------
struct vtkGodRaysDepthWeightedTapsIntegrator::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysDepthWeightedTapsFS",
    vtkGodRaysMediumRays::Complete(vtkGodRaysDepthWeightedTapsFS) };
};

//------------------------------------------------------------------------------
vtkGodRaysDepthWeightedTapsIntegrator::vtkGodRaysDepthWeightedTapsIntegrator()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysDepthWeightedTapsIntegrator::~vtkGodRaysDepthWeightedTapsIntegrator() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysDepthWeightedTapsIntegrator::Integrate(const Request& request)
{
  vtkGodRaysTarget* const occluders = request.Depths->GetOccluders();
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!occluders || !ends || !request.Result->BindToAdd())
  {
    return false;
  }
  const int size[2] = { occluders->GetWidth(), occluders->GetHeight() };
  const vtkGodRaysMediumRays rays(request, size);
  vtkGodRaysQuad& quad = this->Internal->Quad;
  vtkShaderProgram* program = quad.Begin(request.Window,
    { { "parallel", rays.IsParallel() }, { "infinite", rays.IsInfinite() },
      { "uniformly", rays.IsUniform() }, { "grey", rays.IsGrey() } });
  if (!program)
  {
    return false;
  }
  rays.Set(program);
  program->SetUniformi("numberOfTaps", this->NumberOfTaps);
  program->SetUniformf("thickness", static_cast<float>(this->Thickness));
  program->SetUniformf("openSky", vtkGodRaysViewDepths::OpenSky);
  quad.SetTexture("occluders", occluders->GetColor());
  quad.SetTexture("ends", ends->GetColor());
  quad.End();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkGodRaysDepthWeightedTapsIntegrator::Describe(vtkGodRaysModel*)
{
  return "depth-weighted taps: " + std::to_string(this->NumberOfTaps) + " a pixel";
}

//------------------------------------------------------------------------------
void vtkGodRaysDepthWeightedTapsIntegrator::ReleaseGraphicsResources(vtkWindow*)
{
  this->Internal->Quad.Release();
}

//------------------------------------------------------------------------------
void vtkGodRaysDepthWeightedTapsIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTaps: " << this->NumberOfTaps << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
}
