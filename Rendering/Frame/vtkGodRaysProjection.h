// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysProjection
 * @brief   while it lives, a renderer's camera projects in another way; private to this module
 *
 * Props are then rendered in their ordinary way, with the scene's own shaders, from wherever the
 * matrix puts them. The renderer's camera, its clipping range and the lights stay as they are.
 */

#ifndef vtkGodRaysProjection_h
#define vtkGodRaysProjection_h

#include "vtkSmartPointer.h"

#include <vector> // For std::vector

class vtkCamera;
class vtkProp;
class vtkRenderer;
struct vtkGodRaysView;

class vtkGodRaysProjection
{
public:
  /**
   * Project by a row-major matrix from view coordinates to clip coordinates. The camera that stands in
   * is kept by the caller from frame to frame.
   */
  vtkGodRaysProjection(vtkRenderer* renderer, const vtkGodRaysView& view,
    const double viewToClip[16], vtkSmartPointer<vtkCamera>& standIn);
  ~vtkGodRaysProjection();
  vtkGodRaysProjection(const vtkGodRaysProjection&) = delete;
  void operator=(const vtkGodRaysProjection&) = delete;

  /**
   * Returns which props are in the projection, as far as their bounds tell, in their order.
   */
  std::vector<vtkProp*> FindSeen(std::vector<vtkProp*> props) const;

  /**
   * Draws what is opaque of a prop, with the faces that it culls: they are left out for the eye alone.
   */
  static void DrawBothSides(vtkProp* prop, vtkRenderer* renderer);

  /**
   * Whether a prop is a billboard that its renderer has not drawn yet. VTK takes it for a point and draws
   * none whose point is outside the picture; once a layer had drawn it, VTK would show text that reaches
   * inside.
   */
  static bool IsUndrawnBillboard(vtkProp* prop);

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkCamera> Camera;
};

#endif
