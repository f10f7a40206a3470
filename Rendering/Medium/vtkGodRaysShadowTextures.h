// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowTextures
 * @brief   the min/max pyramid of a light's shadow map on the graphics card; private to this module
 *
 * It is drawn when the map is, from its first level up. A shader that is completed by Complete() reads map
 * and pyramid, see vtkGodRaysShadowMapTexelsFS.glsl; Set() gives it what it needs.
 */

#ifndef vtkGodRaysShadowTextures_h
#define vtkGodRaysShadowTextures_h

#include "vtkGodRaysQuad.h"
#include "vtkGodRaysTarget.h"

#include <string> // For std::string

class vtkGodRaysShadowMap;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkGodRaysShadowTextures
{
public:
  vtkGodRaysShadowTextures();

  /// A shader's text with vtkGodRaysShadowMapTexelsFS.glsl in the place of its tag.
  static std::string Complete(const std::string& shader);

  /**
   * Draw the pyramid, if it is not that of the map as it is. Returns false, after an error, if that failed.
   */
  bool Draw(vtkOpenGLRenderWindow* window, const vtkGodRaysShadowMap& map);

  /**
   * Give a shader between Begin() and End() the map, whose pyramid was drawn last.
   */
  void Set(vtkGodRaysQuad& quad, vtkShaderProgram* program, const vtkGodRaysShadowMap& map);

  void Release(vtkWindow* window);

private:
  vtkGodRaysQuad Quad;
  vtkGodRaysTarget Levels[2]; // even and odd ones
  unsigned int Version = 0;   // of the map
};

#endif
