// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkyTable.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysSkyTableFS.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

using namespace vtkGodRays;

namespace
{
/// Columns of azimuths from the sun, even in their cosine; rows of slopes, see SkyTableRow; and slices.
struct Layout
{
  int HalfSize[2];
  int RowsBelow; // the horizon
  int Slices;
};
const Layout WholeLayout = { { 32, 192 }, 64, 1 };
const Layout SpaceLayout = { { 96, 128 }, 64, 1 }; // the edge between day and night is in sight
const Layout PartsLayout = { { 8, 48 }, 24, 32 };
const int ExtinctionSlices = 128; // of the mean extinction up to a distance, which is little work

const Layout& GetLayout(bool inParts, const vtkGodRaysSkyTable::Request& request)
{
  return inParts ? PartsLayout : request.Height > request.Sky.TopHeight ? SpaceLayout : WholeLayout;
}

void SetProfile(vtkShaderProgram* program, const std::string& name, const SkyProfile& profile)
{
  program->SetUniformi((name + ".Kind").c_str(), profile.Kind);
  program->SetUniformf((name + ".Height").c_str(), static_cast<float>(profile.Height));
  program->SetUniformf((name + ".Width").c_str(), static_cast<float>(profile.Width));
}

void SetPhase(vtkShaderProgram* program, const std::string& name, const PhaseFunction& phase)
{
  program->SetUniformi((name + ".Kind").c_str(), phase.Kind);
  program->SetUniformf((name + ".Asymmetry").c_str(), static_cast<float>(phase.Asymmetry));
}
}

vtkGodRaysSkyTable::vtkGodRaysSkyTable(Kind kind)
  : InParts(kind == PARTS)
  , Quad("vtkGodRaysSkyTableFS", vtkGodRaysSkyTableFS)
{
}

vtkGodRaysSkyTable::~vtkGodRaysSkyTable() = default;

std::string vtkGodRaysSkyTable::FindReason(const Request& request) const
{
  if (!this->Table.IsReady())
  {
    return "there was none";
  }
  if (request.Time != this->Made.Time || !request.Repeated != !this->Made.Repeated)
  {
    return "the atmosphere changed";
  }
  if (std::fabs(request.SunSlope - this->Made.SunSlope) > 2e-6)
  {
    return "the sun's elevation changed";
  }
  if (std::fabs(request.Height - this->Made.Height) > 1e-4 * (this->Made.Height + 10.0))
  {
    return "the observer's height changed";
  }
  return {};
}

void vtkGodRaysSkyTable::UploadRepeated(vtkOpenGLRenderWindow* window, vtkImageData* repeated)
{
  if (this->Repeated.IsReady() && repeated->GetMTime() == this->RepeatedTime)
  {
    return;
  }
  const int* size = repeated->GetDimensions();
  this->Repeated.Prepare(window, size[0], size[1], { GL_RGBA32F, 0 });
  this->Repeated.Write(GL_RGB, GL_FLOAT, repeated->GetScalarPointer());
  this->RepeatedTime = repeated->GetMTime();
}

bool vtkGodRaysSkyTable::Update(vtkOpenGLRenderWindow* window, const Request& request)
{
  this->Reason = this->FindReason(request);
  if (this->Reason.empty())
  {
    return true;
  }
  this->Made = request;
  if (request.Repeated)
  {
    this->UploadRepeated(window, request.Repeated);
  }
  const Layout& layout = GetLayout(this->InParts, this->Made);
  this->Table.Prepare(
    window, 2 * layout.HalfSize[0], layout.Slices * layout.HalfSize[1], { GL_RGBA32F, 0 });
  bool made = this->Draw(window, this->Table, false);
  if (this->InParts)
  {
    this->Extinction.Prepare(window, ExtinctionSlices, layout.HalfSize[1], { GL_RGBA32F, 0 });
    made = made && this->Draw(window, this->Extinction, true);
  }
  if (!made)
  {
    this->Table.Release(window); // to be tried again
  }
  return made;
}

bool vtkGodRaysSkyTable::Draw(
  vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target, bool ofExtinction)
{
  const Request& request = this->Made;
  const bool repeated = request.Repeated != nullptr;
  vtkShaderProgram* program = this->Quad.Begin(window,
    { { "repeated", repeated && !ofExtinction }, { "sliced", this->InParts },
      { "ofExtinction", ofExtinction } });
  if (!program || !target.Bind())
  {
    return false;
  }
  SetAtmosphere(program, repeated ? MakeDiffuseSky(request.Sky) : request.Sky);
  this->SetLayout(program);
  const Vec3 diffuse = (1.0 - GetForwardPeak(request.Sky)) * request.Sky.AerosolScattering;
  vtkGodRaysQuad::SetVector(program, "diffuseAerosol", &diffuse[0]);
  vtkGodRaysQuad::SetVector(program, "albedo", &request.Albedo[0]);
  program->SetUniformf("height", static_cast<float>(request.Height));
  program->SetUniformf("sunSlope", static_cast<float>(request.SunSlope));
  if (repeated && !ofExtinction)
  {
    this->Quad.SetTexture("repeatedLight", this->Repeated.GetColor());
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  this->Quad.End();
  return true;
}

Vec2 vtkGodRaysSkyTable::GetEdges() const
{
  return SkyEdges(this->Made.Sky.GroundRadius, this->Made.Sky.TopHeight, this->Made.Height);
}

void vtkGodRaysSkyTable::SetLayout(vtkShaderProgram* program) const
{
  const Layout& layout = GetLayout(this->InParts, this->Made);
  const Vec2 edges = this->GetEdges();
  const float slopes[2] = { static_cast<float>(edges.x), static_cast<float>(edges.y) };
  program->SetUniform2f("edges", slopes);
  program->SetUniform2i("halfSize", layout.HalfSize);
  program->SetUniformi("rowsBelow", layout.RowsBelow);
  program->SetUniformi("slices", layout.Slices);
  program->SetUniformi("extinctionSlices", ExtinctionSlices);
}

void vtkGodRaysSkyTable::SetUniforms(vtkGodRaysQuad& quad, vtkShaderProgram* program) const
{
  quad.SetTexture("table", this->Table.GetColor());
  if (this->InParts)
  {
    quad.SetTexture("extinction", this->Extinction.GetColor());
  }
  this->SetLayout(program);
}

void vtkGodRaysSkyTable::SetAtmosphere(vtkShaderProgram* program, const SkyAtmosphere& sky)
{
  program->SetUniformf("sky.GroundRadius", static_cast<float>(sky.GroundRadius));
  program->SetUniformf("sky.TopHeight", static_cast<float>(sky.TopHeight));
  SetProfile(program, "sky.Air", sky.Air);
  SetProfile(program, "sky.Aerosol", sky.Aerosol);
  SetProfile(program, "sky.Absorber", sky.Absorber);
  vtkGodRaysQuad::SetVector(program, "sky.AirScattering", &sky.AirScattering[0]);
  vtkGodRaysQuad::SetVector(program, "sky.AerosolScattering", &sky.AerosolScattering[0]);
  vtkGodRaysQuad::SetVector(program, "sky.AerosolExtinction", &sky.AerosolExtinction[0]);
  vtkGodRaysQuad::SetVector(program, "sky.Absorption", &sky.Absorption[0]);
  SetPhase(program, "sky.AirPhase", sky.AirPhase);
  program->SetUniformi("sky.AerosolPhaseKind", sky.AerosolPhaseKind);
  vtkGodRaysQuad::SetVector(program, "sky.AerosolAsymmetry", &sky.AerosolAsymmetry[0]);
}

void vtkGodRaysSkyTable::Release(vtkWindow* window)
{
  this->Quad.Release();
  this->Table.Release(window);
  this->Extinction.Release(window);
  this->Repeated.Release(window);
}
