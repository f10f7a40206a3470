// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysCompositor
 * @brief   how a scene whose parts are on several processes becomes one: an interface
 *
 * Where each process renders its own part of a scene and the pictures are joined, the rays need the
 * whole of the occluders and of the emitters. vtkGodRaysPass asks its compositor, if it has one,
 * to join those layers; they are floats, so that light is not cut off at 1.
 *
 * Every process makes the same calls in the same order, also one that has no part of the scene:
 * what they depend on is the same on all processes, or is joined first.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysCompositor_h
#define vtkGodRaysCompositor_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"

#include <cstddef> // For std::size_t

class vtkRenderer;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysCompositor : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysCompositor, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the scene of this frame is on several processes. The same on all of them.
   */
  virtual bool IsDistributed() = 0;

  /**
   * Whether this process has the joined picture, and so draws the rays.
   */
  virtual bool IsRoot() = 0;

  /**
   * Whether the framebuffer has the depth of the joined picture where IsRoot(). The same on all
   * processes.
   */
  virtual bool HasDepth() = 0;

  /// How values of several processes are joined.
  enum Operation
  {
    LEAST = 0,
    GREATEST = 1,
    PRODUCT = 2,
    SUM = 3
  };

  ///@{
  /**
   * Join an array of as many values on every process, element by element, and put the result into
   * it on all of them.
   */
  VTK_WRAPEXCLUDE virtual void Reduce(float* values, std::size_t count, Operation operation) = 0;
  VTK_WRAPEXCLUDE virtual void Reduce(double* values, std::size_t count, Operation operation) = 0;
  ///@}

  /**
   * Draw the background into the bound framebuffer if the picture was drawn over black, and the
   * background is put under it later. Returns false, and draws nothing, if it has its background.
   */
  virtual bool DrawBackground(vtkRenderer* renderer) = 0;

  /**
   * Whether anything is true on any of the processes; without a compositor, whether it is here.
   */
  static bool Any(vtkGodRaysCompositor* compositor, bool here);

  /**
   * The union of the bounds on all processes, in place; without a compositor nothing changes.
   */
  VTK_WRAPEXCLUDE static void JoinBounds(vtkGodRaysCompositor* compositor, double bounds[6]);

protected:
  vtkGodRaysCompositor() = default;
  ~vtkGodRaysCompositor() override = default;

private:
  vtkGodRaysCompositor(const vtkGodRaysCompositor&) = delete;
  void operator=(const vtkGodRaysCompositor&) = delete;
};

#endif
