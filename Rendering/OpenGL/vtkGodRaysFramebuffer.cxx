// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysFramebuffer.h"

#include "vtkGodRaysOpenGL.h"

namespace
{
int Get(unsigned int attachment, unsigned int what)
{
  int value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
  return value;
}

bool Has(unsigned int attachment)
{
  return attachment != GL_NONE && Get(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}
}

vtkGodRaysStateKeeper::vtkGodRaysStateKeeper(vtkOpenGLState* state)
  : State(state)
  , Viewport(state)
  , Scissor(state)
  , BlendFunc(state)
  , DepthMask(state)
  , DepthFunc(state)
  , ColorMask(state)
  , ClearColor(state)
  , ActiveTexture(state)
  , Blend(state, GL_BLEND)
  , DepthTest(state, GL_DEPTH_TEST)
  , ScissorTest(state, GL_SCISSOR_TEST)
  , CullFace(state, GL_CULL_FACE)
  , StencilTest(state, GL_STENCIL_TEST)
{
  state->PushFramebufferBindings();
  if (vtkGodRaysFramebuffer::HasSeveralBuffers())
  {
    int most = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &most);
    this->DrawBuffers.resize(static_cast<std::size_t>(most));
    for (int i = 0; i < most; ++i)
    {
      glGetIntegerv(GL_DRAW_BUFFER0 + i, reinterpret_cast<int*>(&this->DrawBuffers[i]));
    }
    glDrawBuffers(1, this->DrawBuffers.data());
  }
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, &this->ClearDepth);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
}

vtkGodRaysStateKeeper::~vtkGodRaysStateKeeper()
{
  this->State->vtkglClearDepth(this->ClearDepth);
  this->State->PopFramebufferBindings();
  if (!this->DrawBuffers.empty())
  {
    glDrawBuffers(static_cast<int>(this->DrawBuffers.size()), this->DrawBuffers.data());
  }
}

bool vtkGodRaysFramebuffer::HasSeveralBuffers()
{
  int second = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER1, &second);
  return second != GL_NONE;
}

vtkGodRaysFramebuffer::vtkGodRaysFramebuffer()
{
  int value = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &value);
  this->Binding = static_cast<unsigned int>(value);
  glGetIntegerv(GL_SAMPLES, &value);
  this->Multisampled = value > 1;
  glGetIntegerv(GL_DRAW_BUFFER0, &value);
  this->ColorBuffer = static_cast<unsigned int>(value);
  const bool onScreen = this->Binding == 0;
  const unsigned int color =
    onScreen && value == GL_BACK ? static_cast<unsigned int>(GL_BACK_LEFT) : this->ColorBuffer;
  const unsigned int depth = onScreen ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const unsigned int stencil = onScreen ? GL_STENCIL : GL_STENCIL_ATTACHMENT;

  if (Has(color))
  {
    const int bits = Get(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
    this->Formats.Color = bits > 16 ? GL_RGBA32F : bits > 8 ? GL_RGBA16F : GL_RGBA8;
  }
  if (Has(depth))
  {
    const int bits = Get(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    const bool floating = Get(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    this->Formats.Depth = Has(stencil) ? GL_DEPTH24_STENCIL8
      : floating                       ? GL_DEPTH_COMPONENT32F
      : bits == 16                     ? GL_DEPTH_COMPONENT16
      : bits == 24                     ? GL_DEPTH_COMPONENT24
                                       : GL_DEPTH_COMPONENT32;
  }
}

void vtkGodRaysFramebuffer::CopyTo(
  vtkOpenGLState* state, const int rectangle[4], unsigned int buffers, const int to[2]) const
{
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Binding);
  state->vtkglReadBuffer(this->ColorBuffer);
  state->vtkglBlitFramebuffer(rectangle[0], rectangle[1], rectangle[0] + rectangle[2],
    rectangle[1] + rectangle[3], to[0], to[1], to[0] + rectangle[2], to[1] + rectangle[3], buffers,
    GL_NEAREST);
}
