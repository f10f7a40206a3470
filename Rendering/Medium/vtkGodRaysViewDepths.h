// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysViewDepths
 * @brief   how far from the eye things are, of one frame; private to this module
 *
 * View depths as 32-bit floats, OpenSky where nothing is: what a frame's integrators of a medium read,
 * in shaders or in memory. They are drawn when they are first asked for, once a frame.
 */

#ifndef vtkGodRaysViewDepths_h
#define vtkGodRaysViewDepths_h

#include "vtkGodRaysQuad.h"
#include "vtkGodRaysTarget.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
struct vtkGodRaysView;

class vtkGodRaysViewDepths
{
public:
  static constexpr float OpenSky = 1e30f;

  vtkGodRaysViewDepths();
  ~vtkGodRaysViewDepths();

  /**
   * Start a frame with the window depths of the occluders, of a layer's size, and of what is seen,
   * of the picture's, about which the layer may have a margin; null if it is the same.
   */
  void Begin(vtkOpenGLRenderWindow* window, const vtkGodRaysView& view, vtkTextureObject* occluders,
    vtkTextureObject* seen);

  /**
   * Forget the textures and the view of the frame.
   */
  void End();

  /**
   * A number that no other frame has, of any of these objects.
   */
  unsigned int GetFrame() const { return this->Frame; }

  /**
   * Depths at which view rays end, of the layer's size. Null, after an error, if they cannot be drawn. The
   * framebuffer drawn into may be another one after it.
   */
  vtkGodRaysTarget* GetEnds();

  /**
   * The size of the layer.
   */
  void GetSize(int size[2]) const;

  /**
   * Copy where view rays end to memory, rows one after the other: from window depths, without drawing, where
   * these are the layer's alone. False after an error.
   */
  bool ReadEnds(float* depths);

  void Release(vtkWindow* window);

private:
  vtkGodRaysQuad Quad;
  vtkGodRaysTarget Ends;
  vtkGodRaysTarget Layer; // the occluders' window depths, to be read
  bool Drawn = false;
  vtkTextureObject* Sources[2] = { nullptr, nullptr }; // the occluders, and what is seen or null
  vtkOpenGLRenderWindow* Window = nullptr;
  const vtkGodRaysView* View = nullptr;
  unsigned int Frame = 0;
};

#endif
