// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysBlendPass.h"

#include "vtkGodRaysBlendFS.h"
#include "vtkGodRaysQuad.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

vtkStandardNewMacro(vtkGodRaysBlendPass);

//------------------------------------------------------------------------------
struct vtkGodRaysBlendPass::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysBlendFS", vtkGodRaysBlendFS };
};

//------------------------------------------------------------------------------
vtkGodRaysBlendPass::vtkGodRaysBlendPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysBlendPass::~vtkGodRaysBlendPass() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysBlendPass::Draw(const Request& request)
{
  const bool resized = static_cast<int>(request.Rays->GetWidth()) != request.Viewport[2] ||
    static_cast<int>(request.Rays->GetHeight()) != request.Viewport[3];
  vtkShaderProgram* program = this->Internal->Quad.Begin(request.Window,
    { { "linearLight", request.LinearLight }, { "screen", request.Screen && !request.ShowRays },
      { "showRays", request.ShowRays }, { "resized", resized },
      { "hasBackdrop", request.Backdrop != nullptr }, { "oneChannel", request.Tint != nullptr } });
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = request.Window->GetState();
  vtkOpenGLState::ScopedglColorMask mask(state);
  state->vtkglColorMask(
    GL_TRUE, GL_TRUE, GL_TRUE, request.ShowRays && request.Backdrop ? GL_TRUE : GL_FALSE);
  if (request.Accumulate)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  state->vtkglViewport(
    request.Viewport[0], request.Viewport[1], request.Viewport[2], request.Viewport[3]);
  state->vtkglScissor(
    request.Viewport[0], request.Viewport[1], request.Viewport[2], request.Viewport[3]);

  program->SetUniformf("intensity", static_cast<float>(request.Intensity));
  program->SetUniformf("sceneGain", static_cast<float>(request.SceneGain));
  program->SetUniformf("viewScale", static_cast<float>(request.ViewScale));
  if (request.Tint)
  {
    const float tint[3] = { static_cast<float>(request.Tint[0]),
      static_cast<float>(request.Tint[1]), static_cast<float>(request.Tint[2]) };
    program->SetUniform3f("tint", tint);
  }
  this->Internal->Quad.SetTexture("rays", request.Rays);
  if (!request.ShowRays)
  {
    this->Internal->Quad.SetTexture("scene", request.Scene);
  }
  if (request.Backdrop)
  {
    this->Internal->Quad.SetTexture("backdrop", request.Backdrop);
  }
  this->Internal->Quad.End();
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysBlendPass::ReleaseGraphicsResources(vtkWindow*)
{
  this->Internal->Quad.Release();
}

//------------------------------------------------------------------------------
void vtkGodRaysBlendPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
