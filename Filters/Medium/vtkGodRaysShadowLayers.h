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

  /// What dims a light all along its rays, at places each Scale x Scale texels of a face. It becomes layers
  /// of equal parts of what is dark in the end, in whose middles they lie.
  struct Haze
  {
    static constexpr int Scale = 4;
    static constexpr int Slices = 32;
    static constexpr int Layers = 16;

    int FaceSize = 0;              // [texels]
    int Size = 0;                  // of a face [places]
    float Depths[Slices + 1] = {}; // where slices end, from the first one's begin on
    std::vector<float>
      Dark; // of faces, of rows, of places: part of the light that is lost up to there
  };

  /**
   * Make them, of the depths of what is opaque, of surfaces before it, the nearest first, and of a haze if
   * it is not null. A surface that is not beyond those before it does not count. For a haze, grids tell
   * which texels are which face's.
   */
  void Make(const std::vector<float>& opaque, const std::vector<Surface>& surfaces,
    const Haze* haze, const vtkGodRaysShadowGrids& grids);

  /// Forgets them, and frees their memory, or keeps that for the next ones.
  void Clear();
  void Reset() { this->Layers.clear(); }

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
  std::vector<Planes> Room; // the first ones are the layers
  std::vector<vtkGodRaysShadowGrids::Layer> Layers;
  bool Colored = false;
};

#endif
