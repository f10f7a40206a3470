// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSurfaceRepresentation
 * @brief   a surface with a role in god rays
 *
 * The representation type "Surface (God Rays)": ParaView's surface, and whether it blocks light,
 * shines, or does neither. In any other view than a vtkGodRaysRenderView it is an ordinary surface.
 *
 * @sa vtkGodRaysRenderView vtkGodRaysPass
 */

#ifndef vtkGodRaysSurfaceRepresentation_h
#define vtkGodRaysSurfaceRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkGodRaysViewsModule.h" // For export macro

class VTKGODRAYSVIEWS_EXPORT vtkGodRaysSurfaceRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkGodRaysSurfaceRepresentation* New();
  vtkTypeMacro(vtkGodRaysSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get what the surface does to light, one of vtkGodRaysPass::Role. Any other number is an
   * error and changes nothing. A view's lists Occluders, Lights and Ignored come before it.
   * Default is AUTOMATIC.
   */
  void SetRole(int role);
  vtkGetMacro(Role, int);
  ///@}

protected:
  vtkGodRaysSurfaceRepresentation();
  ~vtkGodRaysSurfaceRepresentation() override;

private:
  vtkGodRaysSurfaceRepresentation(const vtkGodRaysSurfaceRepresentation&) = delete;
  void operator=(const vtkGodRaysSurfaceRepresentation&) = delete;

  int Role;
};

#endif
