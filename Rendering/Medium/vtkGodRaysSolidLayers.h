// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSolidLayers
 * @brief   where view rays enter and leave things, beyond the first surface; private to this module
 *
 * Peels the opaque parts of the props that block light: the back of the first thing, the front and the
 * back of the second. It takes part in the mappers' shaders as vtkDualDepthPeelingPass does, see
 * Documentation/Decisions/0008-solid-layers.md.
 */

#ifndef vtkGodRaysSolidLayers_h
#define vtkGodRaysSolidLayers_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkOpenGLRenderPass.h"

class vtkCamera;
class vtkRenderState;

class vtkGodRaysSolidLayers : public vtkOpenGLRenderPass
{
public:
  static vtkGodRaysSolidLayers* New();
  vtkTypeMacro(vtkGodRaysSolidLayers, vtkOpenGLRenderPass);

  /**
   * Render what is beyond the first surface: 1 plane for the back of the first layer, 3 for the
   * second, too. Returns false when the driver refuses.
   */
  bool Draw(const vtkGodRaysMediumIntegrator::Request& request, int planes);

  /**
   * Read a plane's view depths, as those of vtkGodRaysViewDepths; rows are so many pixels apart.
   */
  bool Read(
    const vtkGodRaysMediumIntegrator::Request& request, int plane, float* depths, int rowLength);

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
  vtkGodRaysSolidLayers() = default;
  ~vtkGodRaysSolidLayers() override = default;

private:
  vtkGodRaysSolidLayers(const vtkGodRaysSolidLayers&) = delete;
  void operator=(const vtkGodRaysSolidLayers&) = delete;

  static constexpr int MaximumPlanes = 3;

  vtkGodRaysTarget Planes[MaximumPlanes];
  vtkGodRaysViewDepths Depths[MaximumPlanes];
  vtkSmartPointer<vtkCamera> Camera;
  std::vector<vtkProp*> Props;        // that are drawn; its memory serves from frame to frame
  vtkTextureObject* Last = nullptr;   // what is nearer than the plane that is drawn
  vtkTextureObject* Before = nullptr; // or this, where the last plane is empty
  bool Backs = false;                 // whether the plane is of back faces
};

#endif
