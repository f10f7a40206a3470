// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSolidLayers.h"

#include "vtkCamera.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysProjection.h"
#include "vtkGodRaysView.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <optional>
#include <string>

vtkStandardNewMacro(vtkGodRaysSolidLayers);

namespace
{
/// What is put into shaders, in each frame: strings that are made once.
const std::string Declarations = "//VTK::DepthPeeling::Dec";
const std::string Uniforms = "uniform sampler2D solidLast;\n"
                             "uniform sampler2D solidBefore;\n"
                             "uniform int solidBacks;\n"
                             "//VTK::DepthPeeling::Dec";
const std::string BeforeColor = "//VTK::DepthPeeling::PreColor";
const std::string AfterColor = "//VTK::DepthPeeling::Impl";
const std::string Early = "//GodRays::Solid";
const std::string EarlyBeforeColor = BeforeColor + "\n" + Early;

/// Leave out what is not beyond the last plane, by this depth, and faces of the other side.
std::string MakeTest(const std::string& depth)
{
  return "  float solidNearer = texelFetch(solidLast, ivec2(gl_FragCoord.xy), 0).r;\n"
         "  if (solidNearer >= 1.0)\n"
         "  {\n"
         "    solidNearer = texelFetch(solidBefore, ivec2(gl_FragCoord.xy), 0).r;\n"
         "  }\n"
         "  if (" +
    depth +
    " <= solidNearer + 2.4e-7 || gl_FrontFacing == (solidBacks != 0))\n"
    "  {\n"
    "    discard;\n"
    "  }\n";
}
const std::string TestOfSurface = MakeTest("gl_FragCoord.z");
const std::string TestOfWritten = MakeTest("gl_FragDepth");
}

bool vtkGodRaysSolidLayers::Draw(const vtkGodRaysMediumIntegrator::Request& request, int planes)
{
  vtkTextureObject* const first = request.Depths->GetOccluderWindowDepth();
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  std::optional<vtkGodRaysProjection> camera;
  if (request.View->ViewScale < 1.0)
  {
    camera.emplace(request.Renderer, *request.View, request.View->ViewToClip, this->Camera);
  }
  this->Props = *request.Occluders;
  vtkRenderState occluders(request.Renderer);
  occluders.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->Last = first;
  this->PreRender(&occluders);
  bool drawn = true;
  for (int plane = 0; plane < planes && drawn; ++plane)
  {
    vtkGodRaysTarget& target = this->Planes[plane];
    target.Prepare(request.Window, static_cast<int>(first->GetWidth()),
      static_cast<int>(first->GetHeight()), { 0, GL_DEPTH_COMPONENT32F });
    drawn = target.Bind();
    if (drawn)
    {
      state->vtkglClear(GL_DEPTH_BUFFER_BIT);
      this->Backs = plane % 2 == 0;
      this->Before = plane == 0 ? first : this->Last;
      this->Last = plane == 0 ? first : this->Planes[plane - 1].GetDepth();
      this->Render(&occluders);
    }
  }
  this->PostRender(&occluders);
  this->Props.clear();
  return drawn;
}

void vtkGodRaysSolidLayers::Render(const vtkRenderState* s)
{
  this->Last->Activate();
  if (this->Before != this->Last)
  {
    this->Before->Activate();
  }
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    s->GetPropArray()[i]->RenderOpaqueGeometry(s->GetRenderer());
  }
  if (this->Before != this->Last)
  {
    this->Before->Deactivate();
  }
  this->Last->Deactivate();
}

// Numbers are uniforms, so that all planes have one shader.
bool vtkGodRaysSolidLayers::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShaderProgram::Substitute(fragmentShader, Declarations, Uniforms);
  vtkShaderProgram::Substitute(fragmentShader, BeforeColor, EarlyBeforeColor);
  return true;
}

// What is known of the mapper now: mappers of impostors, as of spheres, write the depth. The first surface is
// that of the scene, in whose format depths may be rounded to 24 bits.
bool vtkGodRaysSolidLayers::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const auto early = fragmentShader.find(Early);
  const auto offset = fragmentShader.find("gl_FragDepth = gl_FragCoord.z"); // of coincident things
  auto written = fragmentShader.find("gl_FragDepth =");
  written = written == offset ? std::string::npos : written;
  const bool isWritten = written != std::string::npos;
  vtkShaderProgram::Substitute(fragmentShader, isWritten && written > early ? AfterColor : Early,
    isWritten ? TestOfWritten : TestOfSurface);
  return true;
}

bool vtkGodRaysSolidLayers::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  program->SetUniformi("solidLast", this->Last->GetTextureUnit());
  program->SetUniformi("solidBefore", this->Before->GetTextureUnit());
  program->SetUniformi("solidBacks", this->Backs);
  return true;
}

bool vtkGodRaysSolidLayers::Read(
  const vtkGodRaysMediumIntegrator::Request& request, int plane, float* depths, int rowLength)
{
  vtkGodRaysViewDepths& converter = this->Depths[plane];
  converter.Begin(request.Window, *request.View, this->Planes[plane].GetDepth(), nullptr);
  vtkGodRaysTarget* target = converter.GetOccluders();
  if (target)
  {
    target->Read(GL_RED, GL_FLOAT, depths, rowLength);
  }
  return target != nullptr;
}

void vtkGodRaysSolidLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (int i = 0; i < MaximumPlanes; ++i)
  {
    this->Depths[i].Release(window);
    this->Planes[i].Release(window);
  }
}
