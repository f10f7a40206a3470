// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeHaze
 * @brief   deep shadow map of volumes: transmittance along the light; private to this module
 *
 * For each 4 x 4 texels of a shadow map, on the processor: the optical depth of vtkGodRaysVolumeGrid, moved,
 * cropped and clipped as VTK's mappers do. Volumes are vtkVolume with an image and composite blending;
 * gradient opacity, masks, and volumes of other data are left out.
 */

#ifndef vtkGodRaysVolumeHaze_h
#define vtkGodRaysVolumeHaze_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysShadowLayers.h"

#include <vector> // For std::vector

class vtkProp;
class vtkVolume;
class vtkVolumeProperty;

class vtkGodRaysVolumeHaze
{
public:
  /**
   * A prop as a volume that it can be computed for; null for others.
   */
  static vtkVolume* GetVolume(vtkProp* prop);

  /**
   * Tell whether the opacity depends on scalars alone. Some of VTK's mappers ask a property for its gradient
   * opacity, and so make one that is 1 everywhere: it counts as none.
   */
  static bool HasScalarOpacityAlone(vtkVolumeProperty* property);

  /**
   * Add what the volume's light depends on.
   */
  static void AddState(
    vtkVolume* volume, std::vector<const void*>& objects, std::vector<double>& numbers);

  /**
   * Go through the volumes along the rays of a map whose grids are these, in faces of a size [texels], side
   * by side as grids' First and Stride tell. All processes of a compositor call it, and get the volumes of
   * all. Returns how many volumes cannot be read.
   */
  static int Make(const vtkGodRaysMediumIntegrator::Request& request,
    const std::vector<vtkVolume*>& volumes, const vtkGodRaysShadowGrids& grids, int size,
    vtkGodRaysShadowLayers::Haze& haze);
};

#endif
