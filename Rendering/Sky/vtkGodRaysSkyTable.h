// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSkyTable
 * @brief   light of the air in all directions from one observer; private to this module
 *
 * WHOLE is that of the sky, to the ground or the atmosphere's edge; PARTS that of the air up to a distance.
 * It depends on the atmosphere, the observer's height and the sun's elevation there, not on where a camera
 * looks: it is made anew when these change. After [Hillaire2020]; but the aerosol's phase function, which is
 * sharp, is left out.
 */

#ifndef vtkGodRaysSkyTable_h
#define vtkGodRaysSkyTable_h

#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkGodRaysTarget.h"

#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkGodRaysSkyTable
{
public:
  /// What the table is made of.
  struct Request
  {
    vtkGodRays::SkyAtmosphere Sky;
    vtkGodRays::Vec3 Albedo;
    vtkImageData* Repeated =
      nullptr;             ///< vtkGodRaysSkySource's table of multiple scattering, or null
    vtkMTimeType Time = 0; ///< when any of these was changed last
    double Height = 0.0;   ///< of the observer [m]
    double SunSlope = 0.0; ///< sine of the sun's elevation there
  };

  enum Kind
  {
    WHOLE,
    PARTS
  };

  explicit vtkGodRaysSkyTable(Kind kind);
  ~vtkGodRaysSkyTable();

  /**
   * Make the table if it is not that of the request: heights to 1e-4 of height + 10 m and elevations to
   * 2e-6 are not told apart, by which light changes less than 1e-3. Returns false, after an error, if it
   * cannot be drawn. The framebuffer drawn into may be another one after it.
   */
  bool Update(vtkOpenGLRenderWindow* window, const Request& request);

  /**
   * Whether the last Update() made the table, and what had changed.
   */
  const std::string& GetReason() const { return this->Reason; }

  /**
   * Give the table to a shader that looks directions up in it.
   */
  void SetUniforms(vtkGodRaysQuad& quad, vtkShaderProgram* program) const;

  /**
   * Give a shader an atmosphere, as the uniform "sky".
   */
  static void SetAtmosphere(vtkShaderProgram* program, const vtkGodRays::SkyAtmosphere& sky);

  /**
   * The slopes of the horizon and of the atmosphere's edge; see SkyEdges.
   */
  vtkGodRays::Vec2 GetEdges() const;

  void Release(vtkWindow* window);

private:
  std::string FindReason(const Request& request) const;
  void UploadRepeated(vtkOpenGLRenderWindow* window, vtkImageData* repeated);
  bool Draw(vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target, bool ofExtinction);
  void SetLayout(vtkShaderProgram* program) const;

  const bool InParts;
  vtkGodRaysQuad Quad;
  vtkGodRaysTarget Table;
  vtkGodRaysTarget Extinction; // of PARTS
  vtkGodRaysTarget Repeated;
  vtkMTimeType RepeatedTime = 0;
  Request Made;
  std::string Reason;
};

#endif
