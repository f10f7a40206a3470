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

/// The framebuffer whose samples the window resolves by a shader, if that is what is bound; null if not.
vtkOpenGLFramebufferObject* FindSamples(
  vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene)
{
  vtkOpenGLFramebufferObject* drawn = window->GetRenderFramebuffer();
  return scene.Multisampled && drawn && drawn->GetFBOIndex() == scene.Binding &&
      !MisreadsSamples(window->GetState())
    ? drawn
    : nullptr;
}
}

vtkGodRaysSceneCopy::vtkGodRaysSceneCopy()
  : Quad("vtkGodRaysResolveFS", vtkGodRaysResolveFS)
{
}

bool vtkGodRaysSceneCopy::Copy(vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene,
  const int rectangle[4], unsigned int buffers)
{
  this->Target.Prepare(window, rectangle[2], rectangle[3], scene.Formats);
  if (!this->Target.Bind())
  {
    return false;
  }
  vtkOpenGLFramebufferObject* drawn =
    buffers & GL_COLOR_BUFFER_BIT ? FindSamples(window, scene) : nullptr;
  vtkTextureObject* samples = drawn ? drawn->GetColorAttachmentAsTextureObject(0) : nullptr;
  if (samples)
  {
    buffers &= ~static_cast<unsigned int>(GL_COLOR_BUFFER_BIT);
  }
  if (buffers)
  {
    scene.CopyTo(window->GetState(), rectangle, buffers);
  }
  return !samples || this->Resolve(window, samples, false, rectangle);
}

vtkTextureObject* vtkGodRaysSceneCopy::FindCoverage(
  vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene, const int rectangle[4])
{
  vtkOpenGLFramebufferObject* drawn = FindSamples(window, scene);
  vtkTextureObject* samples = drawn ? drawn->GetDepthAttachmentAsTextureObject() : nullptr;
  if (!samples)
  {
    return nullptr;
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Coverage.Prepare(window, rectangle[2], rectangle[3], { GL_RGBA8, 0 });
  const bool done = this->Coverage.Bind() && this->Resolve(window, samples, true, rectangle);
  state->PopFramebufferBindings();
  return done ? this->Coverage.GetColor() : nullptr;
}

bool vtkGodRaysSceneCopy::Resolve(
  vtkOpenGLRenderWindow* window, vtkTextureObject* samples, bool ofDepth, const int rectangle[4])
{
  vtkShaderProgram* program = this->Quad.Begin(window, { { "ofDepth", ofDepth } });
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  program->SetUniformi("count", window->GetMultiSamples());
  const float part[4] = { static_cast<float>(rectangle[0]), static_cast<float>(rectangle[1]),
    static_cast<float>(rectangle[2]), static_cast<float>(rectangle[3]) };
  program->SetUniform4f("rectangle", part);
  this->Quad.SetTexture("samples", samples);
  this->Quad.End();
  return true;
}

void vtkGodRaysSceneCopy::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Coverage.Release(window);
  this->Quad.Release();
}
