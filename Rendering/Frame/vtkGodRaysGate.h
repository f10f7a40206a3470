// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGate
 * @brief   whether what enters a frame can be computed with; private to this module
 *
 * Cameras, lights, bounds of props and media come as their owners left them. A frame asks here about each
 * before anything is drawn, sized or counted by it. What is not finite, or so large that its square is not in
 * a shader, has a fault: a text of cause and remedy, to which the caller puts the end of the sentence. No
 * fault is an empty text.
 */

#ifndef vtkGodRaysGate_h
#define vtkGodRaysGate_h

#include <string>

class vtkGodRaysCompositor;
class vtkLight;
class vtkRenderer;
struct vtkGodRaysLight;
struct vtkGodRaysMedium;
struct vtkGodRaysView;

class vtkGodRaysGate
{
public:
  /**
   * No coordinate and no length may be beyond this [scene units].
   */
  static constexpr double Largest = 1e15;

  /**
   * Of the renderer's camera, of which this is the view, and of a picture of this size in pixels, which
   * has to be in textures with the view's margin.
   */
  static std::string FindFault(
    vtkRenderer* renderer, const vtkGodRaysView& view, const int size[2]);

  /**
   * Of a light, with its place and its focal point in the world.
   */
  static std::string FindFault(
    vtkLight* light, const double position[3], const double focalPoint[3]);

  /**
   * Of a medium, in scene units, as an eye sees it in a picture of pixels of this size: at depth 1, or of a
   * parallel view.
   */
  static std::string FindFault(const vtkGodRaysMedium& medium, const vtkGodRaysView& view);

  /**
   * Of what is visible, whose bounds these become: on all processes, and uninitialized if nothing is.
   */
  static std::string FindBounds(
    vtkRenderer* renderer, vtkGodRaysCompositor* compositor, double bounds[6]);

  /**
   * Whether bounds, of a prop or of a scene, have no fault.
   */
  static bool IsUsable(const double bounds[6]);

  /**
   * Keep a light so dark that what is computed with it is finite. It is beyond white by far.
   */
  static void Limit(vtkGodRaysLight& light);
};

#endif
