// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysShadowMapFS.h"
#include "vtkGodRaysShadowMapFilterFS.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkGodRaysWalkedLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysShadowMapIntegrator);

struct vtkGodRaysShadowMapIntegrator::Internals
{
  vtkGodRaysQuad March{ "vtkGodRaysShadowMapFS",
    vtkGodRaysMediumRays::Complete(vtkGodRaysShadowMapFS) };
  vtkGodRaysQuad Filter{ "vtkGodRaysShadowMapFilterFS",
    vtkGodRaysMediumRays::Complete(vtkGodRaysShadowMapFilterFS) };
  /// A light's state, kept from frame to frame.
  struct Light
  {
    vtkGodRaysShadowMap Map;
    vtkGodRaysWalkedLight Walked; // which has the light's table of airlight

    void Release(vtkWindow* window)
    {
      this->Map.Release(window);
      this->Walked.Release(window);
    }
  };
  std::deque<Light> Lights = std::deque<Light>(1); // in the frame's order
  std::size_t Last = 0;                            // the light of the last request
  unsigned int LightsFrame = 0;
  vtkGodRaysTarget Lit[2];      // the part that is lit, of one channel, and of three, and the depth
  vtkGodRaysTarget RowMeans[2]; // its means of rows, alike
  bool IsWalked = false;        // the last light
  bool ShadowsAlone = false;
  unsigned int EndsFrame = 0; // whose ends of view rays the walk of its first light has
  const float* Ends = nullptr;

  Light& GetLight() { return this->Lights[this->Last]; }
  vtkGodRaysShadowMap& GetMap() { return this->GetLight().Map; }
  void CountLight(const Request& request);
  bool ReadEnds(const Request& request, const int size[2]);
  bool Bind(vtkGodRaysTarget& target, const Request& request, bool grey);
  vtkShaderProgram* Begin(
    vtkGodRaysQuad& quad, const Request& request, const vtkGodRaysMediumRays& rays, bool rows);
  bool DrawMean(
    const Request& request, const vtkGodRaysMediumRays& rays, bool rows, vtkGodRaysTarget& lit);
};

// Processes that have no picture have no frames, and keep no maps. A new frame releases lights that the one
// before did not have.
void vtkGodRaysShadowMapIntegrator::Internals::CountLight(const Request& request)
{
  const unsigned int frame = request.Depths ? request.Depths->GetFrame() : 0;
  if (frame == 0 || frame != this->LightsFrame)
  {
    for (; this->Lights.size() > this->Last + 1; this->Lights.pop_back())
    {
      this->Lights.back().Release(request.Window);
    }
    this->Last = 0;
  }
  else if (++this->Last == this->Lights.size())
  {
    this->Lights.emplace_back();
  }
  this->LightsFrame = frame;
}

// They are read from the graphics card once a frame.
bool vtkGodRaysShadowMapIntegrator::Internals::ReadEnds(const Request& request, const int size[2])
{
  float* const ends = this->GetLight().Walked.Walk.PrepareInput(size[0], size[1]);
  if (this->EndsFrame == request.Depths->GetFrame())
  {
    std::copy_n(this->Ends, static_cast<std::size_t>(size[0]) * size[1], ends);
    return true;
  }
  this->EndsFrame = request.Depths->ReadEnds(ends) ? request.Depths->GetFrame() : 0;
  this->Ends = ends;
  return this->EndsFrame != 0;
}

bool vtkGodRaysShadowMapIntegrator::Internals::Bind(
  vtkGodRaysTarget& target, const Request& request, bool grey)
{
  const unsigned int format = request.Result->GetFormat();
  const unsigned int two = format == GL_RGBA32F ? GL_RG32F : GL_RG16F;
  target.Prepare(request.Window, request.Result->GetWidth(), request.Result->GetHeight(),
    { grey ? two : format, 0 });
  request.Window->GetState()->vtkglDisable(GL_BLEND);
  return target.Bind();
}

vtkShaderProgram* vtkGodRaysShadowMapIntegrator::Internals::Begin(
  vtkGodRaysQuad& quad, const Request& request, const vtkGodRaysMediumRays& rays, bool rows)
{
  vtkShaderProgram* program = quad.Begin(request.Window,
    { { "parallel", rays.IsParallel() }, { "infinite", rays.IsInfinite() },
      { "uniformly", rays.IsUniform() }, { "grey", rays.IsGrey() },
      { "cube", this->GetMap().GetNumberOfFaces() == 6 }, { "rows", rows } });
  if (program)
  {
    rays.Set(program);
    quad.SetTexture("ends", request.Depths->GetEnds()->GetColor());
  }
  return program;
}

bool vtkGodRaysShadowMapIntegrator::Internals::DrawMean(
  const Request& request, const vtkGodRaysMediumRays& rays, bool rows, vtkGodRaysTarget& lit)
{
  if (!this->Begin(this->Filter, request, rays, rows))
  {
    return false;
  }
  this->Filter.SetTexture("lit", lit.GetColor());
  this->Filter.End();
  return true;
}

vtkGodRaysShadowMapIntegrator::vtkGodRaysShadowMapIntegrator()
  : Internal(new Internals)
{
}

vtkGodRaysShadowMapIntegrator::~vtkGodRaysShadowMapIntegrator() = default;

bool vtkGodRaysShadowMapIntegrator::Integrate(const Request& request)
{
  Internals& self = *this->Internal;
  self.ShadowsAlone = false;
  if (!this->DrawMap(request))
  {
    return false;
  }
  if (self.IsWalked)
  {
    return this->Walk(request);
  }
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends)
  {
    return false;
  }
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  const vtkGodRaysMediumRays rays(request, size);
  vtkGodRaysTarget& lit = self.Lit[rays.IsGrey() ? 0 : 1];
  vtkGodRaysTarget& rows = self.RowMeans[rays.IsGrey() ? 0 : 1];
  if (!self.Bind(lit, request, rays.IsGrey()))
  {
    return false;
  }
  if (self.GetMap().GetNumberOfFaces() == 0)
  {
    vtkOpenGLState* state = request.Window->GetState();
    state->vtkglClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  else
  {
    vtkShaderProgram* march = self.Begin(self.March, request, rays, false);
    if (!march)
    {
      return false;
    }
    self.GetMap().Set(march);
    march->SetUniformi("numberOfSteps", this->NumberOfSteps);
    self.March.SetTexture("map", self.GetMap().GetDepth());
    self.March.End();
  }
  return self.Bind(rows, request, rays.IsGrey()) && self.DrawMean(request, rays, true, lit) &&
    request.Result->BindToAdd() && self.DrawMean(request, rays, false, rows);
}

bool vtkGodRaysShadowMapIntegrator::DrawMap(const Request& request)
{
  Internals& self = *this->Internal;
  self.IsWalked = this->WalkMap;
  self.CountLight(request);
  return self.GetMap().Draw(
    request, this->MapSize, self.IsWalked ? this->NumberOfNestedMaps : 1, self.IsWalked);
}

bool vtkGodRaysShadowMapIntegrator::Walk(const Request& request)
{
  Internals& self = *this->Internal;
  int size[2];
  request.Depths->GetSize(size);
  const auto parameters =
    vtkGodRaysWalkedLight::GetParameters(request, size, &self.GetMap().GetGrids());
  return self.ReadEnds(request, size) && self.GetLight().Walked.Add(request, parameters, size);
}

bool vtkGodRaysShadowMapIntegrator::Contribute(const Request& request)
{
  return this->DrawMap(request);
}

const vtkGodRaysShadowGrids* vtkGodRaysShadowMapIntegrator::GetShadows()
{
  return &this->Internal->GetMap().GetGrids();
}

const vtkGodRaysShadowGrids* vtkGodRaysShadowMapIntegrator::DrawShadows(const Request& request)
{
  this->Internal->ShadowsAlone = true;
  return this->DrawMap(request) ? this->GetShadows() : nullptr;
}

std::string vtkGodRaysShadowMapIntegrator::Describe(vtkGodRaysModel*)
{
  std::ostringstream text;
  const vtkGodRaysShadowMap& map = this->Internal->GetMap();
  text << "shadow map: " << map.GetNumberOfFaces() << " of " << map.GetSize() << " x "
       << map.GetSize() << " pixels for the last light"
       << (map.WasKept() ? ", kept, " : ", drawn, ");
  if (map.GetNumberOfChanged() > 0)
  {
    text << "only " << map.GetNumberOfChanged() << " of " << map.GetNumberOfProps() << " props, ";
  }
  if (this->Internal->ShadowsAlone)
  {
    text << "for data alone";
  }
  else if (this->Internal->IsWalked)
  {
    text << "walked on the processor: " << this->Internal->GetLight().Walked.Walk.Describe();
  }
  else
  {
    text << this->NumberOfSteps << " steps a pixel";
  }
  text << map.DescribeLayers();
  return text.str();
}

void vtkGodRaysShadowMapIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Internal;
  self.March.Release();
  self.Filter.Release();
  for (Internals::Light& light : self.Lights)
  {
    light.Release(window);
  }
  for (int i = 0; i < 2; ++i)
  {
    self.Lit[i].Release(window);
    self.RowMeans[i].Release(window);
  }
}

void vtkGodRaysShadowMapIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "WalkMap: " << (this->WalkMap ? "On\n" : "Off\n");
  os << indent << "NumberOfNestedMaps: " << this->NumberOfNestedMaps << "\n";
}
