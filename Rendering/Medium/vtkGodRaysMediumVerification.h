// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumVerification
 * @brief   single scattering among the scene's polygons, evaluated exactly at some pixels; private to this
 * module
 *
 * The polygons of actors block light, translucent ones by their opacity, wherever they are, as their mappers
 * have them: those of
 * vtkPolyDataMapper and vtkCompositePolyDataMapper, moved and clipped, drawn as surfaces. They are taken
 * once, and again when an occluder changes. View rays end where the picture's depths are.
 */

#ifndef vtkGodRaysMediumVerification_h
#define vtkGodRaysMediumVerification_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysSingleScattering.h"
#include "vtkType.h" // For vtkMTimeType

#include <functional> // For std::function
#include <string>
#include <utility> // For std::pair
#include <vector>

class vtkActor;
class vtkAppendPolyData;
class vtkGodRaysVerification;
class vtkMatrix4x4;
struct vtkGodRaysGrid;

class vtkGodRaysMediumVerification
{
public:
  /**
   * Media of data that there are besides, which must stay.
   */
  void SetGrids(const std::vector<vtkGodRaysGrid>& grids) { this->Exact.SetGrids(grids); }

  /**
   * Compare what an integrator made of the request.
   */
  void Measure(
    const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysVerification& verification);

  /**
   * Add the opaque surfaces of props, in the world, and call translucent for the others of their parts.
   * Returns how many parts are no surfaces.
   */
  static int AddOpaque(const std::vector<vtkProp*>& props, vtkAppendPolyData* all,
    const std::function<bool(vtkActor*, vtkMatrix4x4*)>& translucent = nullptr);

  /**
   * What is left out, for the plan; empty if nothing is.
   */
  std::string Describe() const;

private:
  void TakeOccluders(const std::vector<vtkProp*>& props);
  bool AddVeil(vtkActor* actor, vtkMatrix4x4* matrix);

  vtkGodRaysSingleScattering Exact;
  std::vector<std::pair<const void*, vtkMTimeType>> Taken; // props, and when they changed
  bool HasTaken = false;
  int LeftOut = 0; // props that are no surfaces
};

#endif
