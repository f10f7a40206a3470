// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion of opaque surfaces. The scene is drawn where it always is, with the window's
 * multisampling, and then multiplied by the occlusion that vtkSSAOPass found. That pass alone would show its
 * own drawing, which has one sample a pixel, and whose strength cannot be set before VTK 9.4. There is no
 * occlusion while the user drags the camera, and none for a hardware selection.
 */

#ifndef AmbientOcclusion_h
#define AmbientOcclusion_h

#include "vtkNew.h"      // For vtkNew
#include "vtkSSAOPass.h" // For vtkSSAOPass

#include <memory> // For std::unique_ptr

class vtkOpenGLRenderWindow;
class vtkOverlayPass;
class vtkRenderStepsPass;

class AmbientOcclusion : public vtkSSAOPass
{
public:
  static AmbientOcclusion* New();
  vtkTypeMacro(AmbientOcclusion, vtkSSAOPass);

  /**
   * Choose the radius by the scene's diagonal, and the strength by whether colours stand for data.
   */
  void SetUp(double diagonal, bool isColored);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  AmbientOcclusion();
  ~AmbientOcclusion() override;

private:
  AmbientOcclusion(const AmbientOcclusion&) = delete;
  void operator=(const AmbientOcclusion&) = delete;

  void Darken(vtkOpenGLRenderWindow* window);

  vtkNew<vtkRenderStepsPass> Steps;
  vtkNew<vtkOverlayPass> Overlays;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  double Strength = 1.0;
};

#endif
