// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSurfaceSky
 * @brief   light of the sky on a renderer's surfaces; private to this module
 *
 * Takes part in the mappers' shaders after VTK's own text for lights, as vtkGodRaysSurfaceShadows does before
 * it: to the light that a surface scatters comes that of the sky and the ground, by its normal. Surfaces
 * without lights, and those that VTK lights by an environment, stay as they are.
 * It shines between Begin() and End().
 */

#ifndef vtkGodRaysSurfaceSky_h
#define vtkGodRaysSurfaceSky_h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysSurfacePass.h"

#include <string>

class vtkRenderer;

class vtkGodRaysSurfaceSky : public vtkGodRaysSurfacePass
{
public:
  static vtkGodRaysSurfaceSky* New();
  vtkTypeMacro(vtkGodRaysSurfaceSky, vtkGodRaysSurfacePass);

  struct Request
  {
    double Forms[48];      ///< see vtkGodRaysSkySource::GetIrradianceForms()
    vtkGodRays::Vec3 Gain; ///< from irradiance to linear light of a white surface
    double Up[3];          ///< of the frame that forms are in
    double North[3];
  };

  /**
   * Shine on the props of a renderer, until End().
   */
  void Begin(vtkRenderer* renderer, const Request& request);
  void End();

  ///@{
  /// For VTK.
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  ///@}

protected:
  vtkGodRaysSurfaceSky() = default;
  ~vtkGodRaysSurfaceSky() override = default;

private:
  vtkGodRaysSurfaceSky(const vtkGodRaysSurfaceSky&) = delete;
  void operator=(const vtkGodRaysSurfaceSky&) = delete;

  bool HasWarned = false;
  float Factors[27] = {}; // see vtkGodRaysSurfaceSkyFS.glsl
};

#endif
