// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSurfacePass
 * @brief   base of what takes part in the mappers' shaders; private to this module
 *
 * A renderer's props keep this pass from frame to frame, so that all that draws them has one shader: maps,
 * layers, and other renderers that share a prop. There a subclass leaves colours as they are.
 */

#ifndef vtkGodRaysSurfacePass_h
#define vtkGodRaysSurfacePass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h" // For vtkWeakPointer
#include "vtkWeakPointer.h"

#include <vector>

class vtkPropCollection;

class vtkGodRaysSurfacePass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkGodRaysSurfacePass, vtkOpenGLRenderPass);

  /**
   * Leave the props. A pass that is on props outlives its owner otherwise.
   */
  void Remove();

  /// For VTK.
  void Render(const vtkRenderState*) override {}

protected:
  vtkGodRaysSurfacePass() { this->SetActiveDrawBuffers(1); }
  ~vtkGodRaysSurfacePass() override = default;

  /// Puts this pass on all props of a renderer, hidden and culled ones too, and leaves all others.
  void TakeProps(vtkPropCollection* all);

  /// Returns how many passes of this class are on a prop before this one.
  int CountBefore(vtkProp* prop);

private:
  vtkGodRaysSurfacePass(const vtkGodRaysSurfacePass&) = delete;
  void operator=(const vtkGodRaysSurfacePass&) = delete;

  void RemoveFrom(vtkProp* prop);

  std::vector<vtkWeakPointer<vtkProp>> Props;
};

#endif
