// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkyTable.h"

#include "vtkGodRaysSkyTableFS.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <cmath>

using namespace vtkGodRays;

namespace
{
// Columns of azimuths from the sun, even in their cosine; rows of slopes, see SkyTableRow.
const int HalfSize[2] = { 32, 192 };
const int RowsBelow = 64;

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

void SetLayout(vtkShaderProgram* program, const Vec2& edges)
{
  const float slopes[2] = { static_cast<float>(edges.x), static_cast<float>(edges.y) };
  program->SetUniform2f("edges", slopes);
  program->SetUniform2i("halfSize", HalfSize);
  program->SetUniformi("rowsBelow", RowsBelow);
}
}

//------------------------------------------------------------------------------
vtkGodRaysSkyTable::vtkGodRaysSkyTable()
  : Quad("vtkGodRaysSkyTableFS", vtkGodRaysSkyTableFS)
{
}

//------------------------------------------------------------------------------
vtkGodRaysSkyTable::~vtkGodRaysSkyTable() = default;

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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
  this->Table.Prepare(window, 2 * HalfSize[0], HalfSize[1], { GL_RGBA32F, 0 });
  vtkShaderProgram* program =
    this->Quad.Begin(window, { { "repeated", request.Repeated != nullptr } });
  if (!program || !this->Table.Bind())
  {
    this->Table.Release(window);
    return false;
  }
  SetAtmosphere(program, request.Repeated ? MakeDiffuseSky(request.Sky) : request.Sky);
  SetLayout(program, this->GetEdges());
  const Vec3 diffuse = (1.0 - GetForwardPeak(request.Sky)) * request.Sky.AerosolScattering;
  vtkGodRaysQuad::SetVector(program, "diffuseAerosol", &diffuse[0]);
  vtkGodRaysQuad::SetVector(program, "albedo", &request.Albedo[0]);
  program->SetUniformf("height", static_cast<float>(request.Height));
  program->SetUniformf("sunSlope", static_cast<float>(request.SunSlope));
  if (request.Repeated)
  {
    this->Quad.SetTexture("repeatedLight", this->Repeated.GetColor());
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  this->Quad.End();
  return true;
}

//------------------------------------------------------------------------------
Vec2 vtkGodRaysSkyTable::GetEdges() const
{
  return SkyEdges(this->Made.Sky.GroundRadius, this->Made.Sky.TopHeight, this->Made.Height);
}

//------------------------------------------------------------------------------
void vtkGodRaysSkyTable::SetUniforms(vtkGodRaysQuad& quad, vtkShaderProgram* program) const
{
  quad.SetTexture("table", this->Table.GetColor());
  SetLayout(program, this->GetEdges());
}

//------------------------------------------------------------------------------
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
  SetPhase(program, "sky.AerosolPhase", sky.AerosolPhase);
}

//------------------------------------------------------------------------------
void vtkGodRaysSkyTable::Release(vtkWindow* window)
{
  this->Quad.Release();
  this->Table.Release(window);
  this->Repeated.Release(window);
}
