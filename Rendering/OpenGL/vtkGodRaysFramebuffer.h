// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysFramebuffer.h
 * @brief   the framebuffer and the OpenGL state that a frame finds; private to this module
 */

#ifndef vtkGodRaysFramebuffer_h
#define vtkGodRaysFramebuffer_h

#include "vtkGodRaysTarget.h"
#include "vtkOpenGLState.h"

#include <vector>

/**
 * Keeps the OpenGL state that the stages change, and sets what all of them need. What is drawn meanwhile goes
 * into the first colour buffer alone: the stages' shaders give one colour, and where an outer pass such as
 * vtkSSAOPass has bound more, for positions and normals, what others get is not defined.
 */
class vtkGodRaysStateKeeper
{
public:
  explicit vtkGodRaysStateKeeper(vtkOpenGLState* state);
  ~vtkGodRaysStateKeeper();
  vtkGodRaysStateKeeper(const vtkGodRaysStateKeeper&) = delete;
  void operator=(const vtkGodRaysStateKeeper&) = delete;

private:
  vtkOpenGLState* State;
  std::vector<unsigned int> DrawBuffers; ///< empty if there is one
  float ClearDepth = 1.0f;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
};

/// The framebuffer that the scene is drawn into: whoever bound it, and of whatever formats.
struct vtkGodRaysFramebuffer
{
  unsigned int Binding;
  unsigned int ColorBuffer;
  vtkGodRaysTarget::Format Formats; ///< 0 where there is none that can be copied
  bool Multisampled;

  /// The one that is bound for drawing.
  vtkGodRaysFramebuffer();

  /// Whether what is drawn goes into several colour buffers, as vtkSSAOPass has it.
  static bool HasSeveralBuffers();

  /// Copy a rectangle of colour, depth or both into the framebuffer that is bound for drawing, to where its
  /// low corner is to be.
  static constexpr int Corner[2] = { 0, 0 };
  void CopyTo(vtkOpenGLState* state, const int rectangle[4], unsigned int buffers,
    const int to[2] = Corner) const;
};

#endif
