// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The background: one or two colours, or a sky that is dark blue above and warm near the light. It
 * is for the look alone and follows no physics.
 */

#ifndef Sky_h
#define Sky_h

#include "Options.h"
#include "Scene.h"
#include "Viewpoint.h"

#include "vtkNew.h" // For vtkNew

#include <array>    // For std::array
#include <optional> // For std::optional

class vtkImageData;
class vtkRenderer;
class vtkTexture;

class Sky
{
public:
  /**
   * Set the background of a renderer, and keep the sky right when its camera moves. The radius is
   * that of the sun's disc in degrees.
   */
  Sky(vtkRenderer* renderer, const Scene& scene, const Viewpoint& view, double sunRadius,
    const Options& options);
  ~Sky();

  Sky(const Sky&) = delete;
  void operator=(const Sky&) = delete;

  /**
   * Have the light elsewhere; the camera of the view is not looked at.
   */
  void SetView(const Viewpoint& view);

private:
  void Update();
  Vector3 GetColor(double angleFromLight, double elevation) const;

  vtkRenderer* Renderer;
  Viewpoint View;
  Vector3 Up;
  Vector3 LightColor;
  double SunRadius;
  std::optional<std::array<Vector3, 2>>
    Gradient; ///< from the lower to the upper edge, instead of a sky
  unsigned long Observer = 0;
  unsigned long CameraTime = 0;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkTexture> Texture;
};

#endif
