// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysShadowMapFS.h"
#include "vtkGodRaysShadowTextures.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkGodRaysWalkedLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkGodRaysShadowMapIntegrator);

namespace
{
// Measured: on the twelve scenes of Documentation/Evidence/ModelError.md, 95 of 100 cases are within 0.0093
// with one map of 1024 pixels; with four nested ones within 0.0057 (half of 512 pixels), 0.0030 (1536) and
// 0.0017 (3072).
constexpr double OneMapTolerance = 0.009;
constexpr int OneMapSize = 1024;

// Returns how much the layers of several lights keep [bytes], a quarter of what the process may have. Beyond
// it, lights take memory from each other, as a lamp's layers take two gigabytes.
double GetMostMemory()
{
  static const double most =
    256.0 * static_cast<double>(vtksys::SystemInformation().GetProcMemoryAvailable());
  return most;
}

int ChooseMapSize(double tolerance)
{
  const double steps = std::round(6.0 / 256.0 / tolerance);
  return 256 * static_cast<int>(std::min(std::max(steps, 2.0), 16.0));
}
}

struct vtkGodRaysShadowMapIntegrator::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysShadowMapFS",
    vtkGodRaysShadowTextures::Complete(vtkGodRaysShadowMapFS) };
  /// A light's state, kept from frame to frame.
  struct Light
  {
    vtkGodRaysShadowMap Map;
    vtkGodRaysShadowTextures Textures;
    vtkGodRaysWalkedLight Walked; // which has the light's table of airlight

    void Release(vtkWindow* window)
    {
      this->Map.Release(window);
      this->Textures.Release(window);
      this->Walked.Release(window);
    }
  };
  std::deque<Light> Lights = std::deque<Light>(1); // in the frame's order
  std::size_t Last = 0;                            // the light of the last request
  unsigned int LightsFrame = 0;
  const char* Done = ""; // with the last light
  bool OnProcessor = false;
  int MapSize = 0; // as chosen
  int NumberOfNestedMaps = 1;
  double Tolerance = 0.0;          // that was asked for last
  double Correction = 1.0;         // what it is times
  unsigned int CorrectedFrame = 0; // in which that was looked at
  unsigned int EndsFrame = 0;      // whose ends of view rays are read
  unsigned int EndsVersion = 0;    // another one for other ends
  std::vector<float> Ends;
  std::vector<float> NewEnds;  // here to keep its memory
  std::size_t MemoryOwner = 0; // the light whose layers were drawn last
  vtkGodRaysTarget Computed;   // light of the last request that compute shaders summed

  Light& GetLight() { return this->Lights[this->Last]; }
  vtkGodRaysShadowMap& GetMap() { return this->GetLight().Map; }
  double GetCorrectedTolerance(const Request& request);
  void CountLight(const Request& request);
  void MakeRoom();
  bool ReadEnds(const Request& request, const int size[2]);
  bool Redraw(const Request& request);
  bool WalkOnProcessor(const Request& request);
  bool WalkInShaders(const Request& request, bool computes);
};

// Once a frame, however many lights it has.
double vtkGodRaysShadowMapIntegrator::Internals::GetCorrectedTolerance(const Request& request)
{
  const unsigned int frame = request.Depths ? request.Depths->GetFrame() : 0;
  if (this->Tolerance != request.ErrorTolerance)
  {
    this->Tolerance = request.ErrorTolerance;
    this->Correction = 1.0;
  }
  else if (frame != 0 && frame != this->CorrectedFrame &&
    request.LastError > request.ErrorTolerance)
  {
    this->Correction =
      std::max(this->Correction * request.ErrorTolerance / request.LastError, 0.01);
  }
  this->CorrectedFrame = frame;
  return request.ErrorTolerance * this->Correction;
}

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

// Has the light's layers drawn in the memory of another light where lights keep much already.
void vtkGodRaysShadowMapIntegrator::Internals::MakeRoom()
{
  Light& light = this->GetLight();
  if (this->MemoryOwner < this->Lights.size() && this->MemoryOwner != this->Last &&
    light.Map.GetMemory() == 0.0)
  {
    double kept = 0.0;
    for (const Light& each : this->Lights)
    {
      kept += each.Map.GetMemory();
    }
    if (kept > GetMostMemory())
    {
      Light& owner = this->Lights[this->MemoryOwner];
      light.Map.TakeMemory(owner.Map);
      light.Walked.Walk.Swap(owner.Walked.Walk);
    }
  }
  this->MemoryOwner = this->Last;
}

// Reads them from the graphics card once a frame.
bool vtkGodRaysShadowMapIntegrator::Internals::ReadEnds(const Request& request, const int size[2])
{
  if (this->EndsFrame == request.Depths->GetFrame())
  {
    return true;
  }
  this->NewEnds.resize(static_cast<std::size_t>(size[0]) * size[1]);
  this->EndsFrame = request.Depths->ReadEnds(this->NewEnds.data()) ? request.Depths->GetFrame() : 0;
  if (this->NewEnds != this->Ends)
  {
    this->Ends.swap(this->NewEnds);
    ++this->EndsVersion;
  }
  return this->EndsFrame != 0;
}

bool vtkGodRaysShadowMapIntegrator::Internals::WalkOnProcessor(const Request& request)
{
  int size[2];
  request.Depths->GetSize(size);
  Light& light = this->GetLight();
  const auto parameters =
    vtkGodRaysWalkedLight::GetParameters(request, size, &light.Map.GetGrids());
  if (!this->ReadEnds(request, size))
  {
    return false;
  }
  if (!light.Walked.Has(parameters, size, this->EndsVersion))
  {
    if (!light.Map.HasNumbers() && !this->Redraw(request))
    {
      return false;
    }
    std::copy(
      this->Ends.begin(), this->Ends.end(), light.Walked.Walk.PrepareInput(size[0], size[1]));
  }
  return light.Walked.Add(request,
    vtkGodRaysWalkedLight::GetParameters(request, size, &light.Map.GetGrids()), size,
    this->EndsVersion);
}

bool vtkGodRaysShadowMapIntegrator::Internals::Redraw(const Request& request)
{
  this->MakeRoom();
  return this->GetMap().Redraw(request);
}

bool vtkGodRaysShadowMapIntegrator::Internals::WalkInShaders(const Request& request, bool computes)
{
  Light& light = this->GetLight();
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  const bool hasMap = light.Map.GetNumberOfFaces() > 0;
  vtkGodRaysSum& result = *request.Result;
  if (computes)
  {
    this->Computed.Prepare(
      request.Window, result.GetWidth(), result.GetHeight(), { result.GetFormat(), 0 });
  }
  if (!ends || (hasMap && !light.Textures.Draw(request.Window, light.Map)) ||
    !(computes ? result.Settle() && this->Computed.Bind() : result.BindToAdd()))
  {
    return false;
  }
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  const vtkGodRaysMediumRays rays(request, size);
  const std::initializer_list<vtkGodRaysQuad::Term> terms = { { "parallel", rays.IsParallel() },
    { "infinite", rays.IsInfinite() }, { "closed", rays.IsClosed() }, { "grey", rays.IsGrey() },
    { "shadowed", hasMap } };
  vtkShaderProgram* program = computes ? this->Quad.BeginCompute(request.Window, terms)
                                       : this->Quad.Begin(request.Window, terms);
  if (!program)
  {
    return false;
  }
  rays.Set(program);
  this->Quad.SetTexture("ends", ends->GetColor());
  if (hasMap)
  {
    light.Map.GetFaces().Set(program);
    light.Textures.Set(this->Quad, program, light.Map);
  }
  if (!computes)
  {
    this->Quad.End();
    return true;
  }
  this->Quad.EndCompute(this->Computed);
  return result.Lend(this->Computed, request.Light->Color, 1.0);
}

vtkGodRaysShadowMapIntegrator::vtkGodRaysShadowMapIntegrator()
  : Internal(new Internals)
{
}

vtkGodRaysShadowMapIntegrator::~vtkGodRaysShadowMapIntegrator() = default;

// The request with the tolerance as corrected.
vtkGodRaysMediumIntegrator::Request vtkGodRaysShadowMapIntegrator::Choose(const Request& request)
{
  Internals& self = *this->Internal;
  self.MapSize = std::max(this->MapSize, 64);
  self.NumberOfNestedMaps = this->NumberOfNestedMaps;
  if (this->MapSize > 0)
  {
    return request;
  }
  double greatest[2] = { self.GetCorrectedTolerance(request), request.Interactive ? 1.0 : 0.0 };
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    // Maps are joined: they are of one size.
    request.Compositor->Reduce(greatest, 2, vtkGodRaysCompositor::GREATEST);
  }
  Request corrected = request;
  corrected.ErrorTolerance = greatest[0];
  const bool oneServes = greatest[1] > 0.0 && greatest[0] > OneMapTolerance;
  const bool isPoint = !request.Light->IsInfinite();
  self.MapSize = isPoint || oneServes ? OneMapSize : ChooseMapSize(greatest[0]);
  self.NumberOfNestedMaps = oneServes ? 1 : this->NumberOfNestedMaps;
  return corrected;
}

bool vtkGodRaysShadowMapIntegrator::Integrate(const Request& request)
{
  const Request corrected = this->Choose(request);
  if (!this->DrawMap(corrected))
  {
    return false;
  }
  Internals& self = *this->Internal;
  self.OnProcessor = this->UsesProcessor() || self.GetMap().HasLayers();
  const bool computes = this->Backend != FRAGMENTS && self.Quad.CanCompute(request.Window);
  self.Done = self.OnProcessor ? "walked on the processor: "
    : computes                 ? "walked in compute shaders"
                               : "walked in fragment shaders";
  return self.OnProcessor ? self.WalkOnProcessor(corrected)
                          : self.WalkInShaders(corrected, computes);
}

bool vtkGodRaysShadowMapIntegrator::DrawMap(const Request& request)
{
  Internals& self = *this->Internal;
  self.CountLight(request);
  vtkGodRaysShadowMap& map = self.GetMap();
  map.Fit(request, self.MapSize, self.NumberOfNestedMaps);
  const bool serves = map.WasKept() && (map.HasNumbers() || !request.WantsShadows);
  return serves || self.Redraw(request);
}

bool vtkGodRaysShadowMapIntegrator::Contribute(const Request& request)
{
  return this->DrawMap(this->Choose(request));
}

const vtkGodRaysShadowGrids* vtkGodRaysShadowMapIntegrator::GetShadows()
{
  return &this->Internal->GetMap().GetGrids();
}

const vtkGodRaysShadowGrids* vtkGodRaysShadowMapIntegrator::DrawShadows(const Request& request)
{
  this->Internal->Done = "for data alone";
  this->Internal->OnProcessor = false;
  return this->DrawMap(this->Choose(request)) ? this->GetShadows() : nullptr;
}

std::string vtkGodRaysShadowMapIntegrator::Describe(vtkGodRaysModel*)
{
  std::ostringstream text;
  const vtkGodRaysShadowMap& map = this->Internal->GetMap();
  text << "shadow map: " << map.GetNumberOfFaces() << " of " << map.GetFaces().Size << " x "
       << map.GetFaces().Size << " pixels for the last light"
       << (map.WasKept() ? ", kept, " : ", drawn, ");
  if (map.GetNumberOfChanged() > 0)
  {
    text << "only " << map.GetNumberOfChanged() << " of " << map.GetNumberOfProps() << " props, ";
  }
  text << this->Internal->Done
       << (this->Internal->OnProcessor ? this->Internal->GetLight().Walked.Describe() : "")
       << map.DescribeLayers();
  return text.str();
}

void vtkGodRaysShadowMapIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Internal;
  self.Quad.Release();
  self.Computed.Release(window);
  for (Internals::Light& light : self.Lights)
  {
    light.Release(window);
  }
}

void vtkGodRaysShadowMapIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "NumberOfNestedMaps: " << this->NumberOfNestedMaps << "\n";
}
