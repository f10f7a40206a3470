// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSceneCopy.h"

#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysResolveFS.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>

namespace
{
bool StartsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

/// Drivers on which VTK resolves by a blit, since they misread multisampled textures.
bool MisreadsSamples(vtkOpenGLState* state)
{
  const std::string& vendor = state->GetVendor();
  const std::string& renderer = state->GetRenderer();
  return (StartsWith(vendor, "Intel") && StartsWith(renderer, "Mesa Intel")) ||
    (StartsWith(vendor, "X.Org") && StartsWith(renderer, "AMD")) ||
    (StartsWith(vendor, "Mesa") && StartsWith(renderer, "NV"));
}

/// The texture whose samples the window resolves by a shader, if that is what is bound; null if not.
vtkTextureObject* FindSamples(vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene)
{
  vtkOpenGLFramebufferObject* drawn = window->GetRenderFramebuffer();
  return scene.Multisampled && drawn && drawn->GetFBOIndex() == scene.Binding &&
      !MisreadsSamples(window->GetState())
    ? drawn->GetColorAttachmentAsTextureObject(0)
    : nullptr;
}
}

//------------------------------------------------------------------------------
vtkGodRaysSceneCopy::vtkGodRaysSceneCopy()
  : Quad("vtkGodRaysResolveFS", vtkGodRaysResolveFS)
{
}

//------------------------------------------------------------------------------
bool vtkGodRaysSceneCopy::Copy(vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene,
  const int rectangle[4], unsigned int buffers)
{
  this->Target.Prepare(window, rectangle[2], rectangle[3], scene.Formats);
  if (!this->Target.Bind())
  {
    return false;
  }
  vtkTextureObject* samples = buffers & GL_COLOR_BUFFER_BIT ? FindSamples(window, scene) : nullptr;
  if (samples)
  {
    buffers &= ~static_cast<unsigned int>(GL_COLOR_BUFFER_BIT);
  }
  if (buffers)
  {
    scene.CopyTo(window->GetState(), rectangle, buffers);
  }
  return !samples || this->Resolve(window, samples, window->GetMultiSamples(), rectangle);
}

//------------------------------------------------------------------------------
bool vtkGodRaysSceneCopy::Resolve(
  vtkOpenGLRenderWindow* window, vtkTextureObject* samples, int count, const int rectangle[4])
{
  vtkShaderProgram* program = this->Quad.Begin(window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  program->SetUniformi("count", count);
  const float part[4] = { static_cast<float>(rectangle[0]), static_cast<float>(rectangle[1]),
    static_cast<float>(rectangle[2]), static_cast<float>(rectangle[3]) };
  program->SetUniform4f("rectangle", part);
  this->Quad.SetTexture("samples", samples);
  this->Quad.End();
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysSceneCopy::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Quad.Release();
}
