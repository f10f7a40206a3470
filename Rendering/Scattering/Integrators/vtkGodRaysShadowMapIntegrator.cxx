// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysShadowMapFS.h"
#include "vtkGodRaysShadowMapFilterFS.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <sstream>

vtkStandardNewMacro(vtkGodRaysShadowMapIntegrator);

//------------------------------------------------------------------------------
struct vtkGodRaysShadowMapIntegrator::Internals
{
  vtkGodRaysQuad March{ "vtkGodRaysShadowMapFS", vtkGodRaysShadowMapFS };
  vtkGodRaysQuad Filter{ "vtkGodRaysShadowMapFilterFS", vtkGodRaysShadowMapFilterFS };
  vtkGodRaysShadowMap Map;
  vtkGodRaysTarget Lit[2]; // of one channel, and of three

  vtkShaderProgram* Begin(
    vtkGodRaysQuad& quad, const Request& request, const vtkGodRaysMediumRays& rays)
  {
    vtkShaderProgram* program = quad.Begin(request.Window,
      { { "parallel", rays.IsParallel() }, { "infinite", rays.IsInfinite() },
        { "uniformly", rays.IsUniform() }, { "grey", rays.IsGrey() },
        { "cube", this->Map.GetNumberOfFaces() == 6 } });
    if (program)
    {
      rays.Set(program);
      quad.SetTexture("ends", request.Depths->GetEnds()->GetColor());
    }
    return program;
  }
};

//------------------------------------------------------------------------------
vtkGodRaysShadowMapIntegrator::vtkGodRaysShadowMapIntegrator()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysShadowMapIntegrator::~vtkGodRaysShadowMapIntegrator() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMapIntegrator::Supports(vtkGodRaysModel* model)
{
  return vtkGodRaysMediumModel::SafeDownCast(model) != nullptr;
}

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMapIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends || !self.Map.Draw(request, this->MapSize))
  {
    return false;
  }
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  const vtkGodRaysMediumRays rays(request, size);
  vtkGodRaysTarget& lit = self.Lit[rays.IsGrey() ? 0 : 1];
  const bool single = request.Result->GetFormat() == GL_RGBA32F;
  const unsigned int one = single ? GL_R32F : GL_R16F;
  lit.Prepare(request.Window, request.Result->GetWidth(), request.Result->GetHeight(),
    { rays.IsGrey() ? one : request.Result->GetFormat(), 0 });
  if (!lit.Bind())
  {
    return false;
  }
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglDisable(GL_BLEND);
  if (self.Map.GetNumberOfFaces() == 0)
  {
    state->vtkglClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  else
  {
    vtkShaderProgram* march = self.Begin(self.March, request, rays);
    if (!march)
    {
      return false;
    }
    self.Map.Set(march);
    march->SetUniformi("numberOfSteps", this->NumberOfSteps);
    self.March.SetTexture("map", self.Map.GetDepth());
    self.March.End();
  }
  if (!request.Result->BindToAdd() || !self.Begin(self.Filter, request, rays))
  {
    return false;
  }
  self.Filter.SetTexture("lit", lit.GetColor());
  self.Filter.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMapIntegrator::Contribute(const Request& request)
{
  return this->Internal->Map.Draw(request, this->MapSize);
}

//------------------------------------------------------------------------------
std::string vtkGodRaysShadowMapIntegrator::Describe(vtkGodRaysModel*, double)
{
  std::ostringstream text;
  const vtkGodRaysShadowMap& map = this->Internal->Map;
  text << "shadow map: " << map.GetNumberOfFaces() << " of " << map.GetSize() << " x "
       << map.GetSize() << " pixels for the last light, " << this->NumberOfSteps
       << " steps a pixel";
  return text.str();
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMapIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Internal;
  self.March.Release();
  self.Filter.Release();
  self.Map.Release(window);
  self.Lit[0].Release(window);
  self.Lit[1].Release(window);
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMapIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
}
