// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysLightLayers
 * @brief   the translucent surfaces that a light meets before what is opaque; private to this module
 *
 * Peels translucent parts of props as the light sees them, the nearest first: each layer is drawn with what
 * is no farther than the one before left out. It takes part in the mappers' shaders as
 * vtkDualDepthPeelingPass does, see Documentation/Decisions/0008-solid-layers.md, and draws what a surface
 * lets through in place of its colour. A surface of opacity a, whose colour as it is lit by white has the
 * channels c, the largest of them being 1, lets through (1 - a)^(3 - 2 c) of each: a sheet of absorbing
 * matter, so that two sheets are as one of both thicknesses, and the strongest colour is dimmed by the
 * opacity alone.
 */

#ifndef vtkGodRaysLightLayers_h
#define vtkGodRaysLightLayers_h

#include "vtkGodRaysShadowLayers.h"
#include "vtkGodRaysTarget.h"
#include "vtkOpenGLRenderPass.h"

#include <functional> // For std::function
#include <vector>     // For std::vector

class vtkGodRaysCompositor;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;

class vtkGodRaysLightLayers : public vtkOpenGLRenderPass
{
public:
  static vtkGodRaysLightLayers* New();
  vtkTypeMacro(vtkGodRaysLightLayers, vtkOpenGLRenderPass);

  /// So many surfaces a ray of light goes through at most.
  static constexpr int MaximumSurfaces = 16;

  /// What a surface of a colour and an opacity lets through of red, green and blue, as the shaders have it.
  static void GetThrough(const double color[3], double opacity, double through[3]);

  /// Looks through each part of the map in turn, and draws the props that are in it. Returns false to stop.
  using DrawFaces = std::function<bool(const std::function<void(std::vector<vtkProp*>&)>& draw)>;

  /**
   * Peel the props' translucent surfaces before the depths of a map, in the depths' size. On several
   * processes, all call it, and get the surfaces of all. Returns false when the driver refuses, or
   * faces does.
   */
  bool Draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, std::vector<vtkProp*> props,
    vtkGodRaysTarget& opaque, vtkGodRaysCompositor* compositor, const DrawFaces& faces);

  /**
   * What was met, the nearest first.
   */
  const std::vector<vtkGodRaysShadowLayers::Surface>& GetSurfaces() const { return this->Surfaces; }

  /**
   * Whether there were more than MaximumSurfaces, so that the farther ones cast no shadow.
   */
  bool WereMore() const { return this->More; }

  /**
   * Forget the surfaces' numbers.
   */
  void Clear() { this->Surfaces.clear(); }

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /// For VTK.
  void Render(const vtkRenderState* s) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  ///@}

protected:
  vtkGodRaysLightLayers();
  ~vtkGodRaysLightLayers() override = default;

private:
  vtkGodRaysLightLayers(const vtkGodRaysLightLayers&) = delete;
  void operator=(const vtkGodRaysLightLayers&) = delete;

  vtkGodRaysTarget Planes[2]; // the layer that is drawn, and the one before, in turn
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkTextureObject* Opaque = nullptr;
  vtkTextureObject* Last = nullptr; // the layer before, or Opaque
  bool First = false;               // whether there is none
  std::vector<vtkGodRaysShadowLayers::Surface> Surfaces;
  bool More = false;
};

#endif
