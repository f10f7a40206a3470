// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSceneCopy
 * @brief   colours and depth of the scene as it stands in the framebuffer; private to this module
 *
 * The samples of a multisampled window are resolved as vtkOpenGLRenderWindow resolves them when it shows
 * the picture: the mean of colours raised to the power 2.2, by a shader. A blit takes the mean of the
 * colours themselves, which makes the edges of things darker.
 */

#ifndef vtkGodRaysSceneCopy_h
#define vtkGodRaysSceneCopy_h

#include "vtkGodRaysQuad.h"
#include "vtkGodRaysTarget.h"

struct vtkGodRaysFramebuffer;

class vtkGodRaysSceneCopy
{
public:
  vtkGodRaysSceneCopy();

  /**
   * Copy a rectangle of the scene [pixels]: colour, depth, both or neither, as OpenGL's bits of buffers.
   * The textures have its size. False when the driver refuses their formats or, after one error, the
   * shader.
   */
  bool Copy(vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene,
    const int rectangle[4], unsigned int buffers);

  /**
   * How much of each pixel of the rectangle something covers, in red: the part of its samples whose window
   * depth is below 1. Null if the scene has one sample a pixel, or if its samples cannot be read. The
   * framebuffer that was bound is bound again.
   */
  vtkTextureObject* FindCoverage(
    vtkOpenGLRenderWindow* window, const vtkGodRaysFramebuffer& scene, const int rectangle[4]);

  void Release(vtkWindow* window);

  vtkTextureObject* GetColor() const { return this->Target.GetColor(); }
  vtkTextureObject* GetDepth() const { return this->Target.GetDepth(); }

  /**
   * Window depths that were copied, in memory; waits for the drawing.
   */
  std::vector<float> ReadDepth() { return this->Target.ReadDepth(); }

private:
  bool Resolve(
    vtkOpenGLRenderWindow* window, vtkTextureObject* samples, bool ofDepth, const int rectangle[4]);

  vtkGodRaysTarget Target;
  vtkGodRaysTarget Coverage;
  vtkGodRaysQuad Quad;
};

#endif
