// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowLayers
 * @brief   the layers of a shadow map whose occluders let part of the light through
 *
 * Private. See vtkGodRaysShadowGrids.h for what layers are. Threads of vtkSMPTools make them.
 */

#ifndef vtkGodRaysShadowLayers_h
#define vtkGodRaysShadowLayers_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysShadowGrids.h"

#include <vector> // For std::vector

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysShadowLayers
{
public:
  /// What a light meets in each texel of a map.
  struct Surface
  {
    std::vector<float> Depths;
    std::vector<float>
      Through; // red, green, blue [0, 1] and 1; the fourth is 0 where nothing is met
  };

  /**
   * Make them, of the depths of what is opaque, and of surfaces before it, the nearest first. A surface
   * that is not beyond those before it does not count.
   */
  void Make(const std::vector<float>& opaque, const std::vector<Surface>& surfaces);

  void Clear();

  int GetNumberOfLayers() const { return static_cast<int>(this->Layers.size()); }

  /**
   * Give them to grids, whose First and Stride tell where their texels are. They are read there until the
   * next Make() or Clear().
   */
  void Set(vtkGodRaysShadowGrids& grids) const;

private:
  struct Planes
  {
    std::vector<float> Depths;
    std::vector<float> Dark[3]; // of red alone, if colours are alike
  };
  std::vector<Planes> Room;
  std::vector<vtkGodRaysShadowGrids::Layer> Layers;
  bool Colored = false;
};

#endif
