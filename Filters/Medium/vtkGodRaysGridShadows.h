// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridShadows.h
 * @brief   what surfaces leave of a light, at places and along parts of view rays
 *
 * Private. A shadow map's numbers, looked up in coordinates of the world.
 */

#ifndef vtkGodRaysGridShadows_h
#define vtkGodRaysGridShadows_h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysShadowGrids.h"

#include <algorithm>
#include <cmath>
#include <vector>

class vtkGodRaysGridShadows
{
public:
  using Vec3 = vtkGodRays::Vec3;

  /// Take a map in view coordinates, which must stay; null: nothing is hidden.
  void Set(const vtkGodRaysShadowGrids* map)
  {
    this->Map = map && map->Levels > 0 ? map : nullptr;
    this->Layers.clear();
    for (int k = 0; this->Map && k < map->NumberOfLayers; ++k)
    {
      this->Layers.push_back(map->GetLayer(k));
    }
  }

  bool AreColored() const { return !this->Layers.empty() && this->Map->Colored; }

  /// The eye and its axes, and a light: a position, or a direction of length 1.
  void Place(const Vec3& eye, const Vec3 axes[3], const Vec3& light, bool directional)
  {
    std::copy_n(axes, 3, this->Axes);
    this->Origin = directional ? eye : light;
    this->Light = light;
    this->Directional = directional;
  }

  /// At a place: 1 where nothing is hidden.
  Vec3 Get(const Vec3& position) const
  {
    if (!this->Map)
    {
      return Vec3(1.0);
    }
    const Vec3 offset = position - this->Origin;
    const Vec3 place(vtkGodRays::dot(offset, this->Axes[0]), vtkGodRays::dot(offset, this->Axes[1]),
      vtkGodRays::dot(offset, this->Axes[2]));
    std::ptrdiff_t texel = 0;
    if (this->Layers.empty())
    {
      return Vec3(this->Hides(*this->Map, offset, place, texel) ? 0.0 : 1.0);
    }
    Vec3 left(1.0);
    for (std::size_t k = 0; k < this->Layers.size(); ++k)
    {
      if (this->Hides(this->Layers[k], offset, place, texel))
      {
        const float* const* dark = this->Map->Layers[k].Dark;
        left -= Vec3(dark[0][texel], dark[1][texel], dark[2][texel]);
      }
    }
    return vtkGodRays::max(left, Vec3(0.0));
  }

  /**
   * The mean over a part of a line. edge is that at its begin and, after it, at its end. What is lit is
   * looked at spacing apart; where it differs, the place at which it does is searched.
   */
  Vec3 GetMean(const Vec3& origin, const Vec3& along, double begin, double end, double spacing,
    Vec3& edge) const
  {
    if (!this->Map || !(end > begin))
    {
      return edge;
    }
    const int count = static_cast<int>(std::clamp(std::ceil((end - begin) / spacing), 1.0, 64.0));
    const double step = (end - begin) / count;
    Vec3 sum(0.0);
    for (int k = 1; k <= count; ++k)
    {
      const Vec3 before = edge;
      edge = this->Get(origin + (begin + k * step) * along);
      double first = 0.0; // part of the step that is as its begin
      double last = 1.0;
      for (int i = 0; i < Searches && edge != before; ++i)
      {
        const double middle = 0.5 * (first + last);
        (this->Get(origin + (begin + (k - 1 + middle) * step) * along) == before ? first : last) =
          middle;
      }
      const double part = 0.5 * (first + last);
      sum += part * before + (1.0 - part) * edge;
    }
    return sum / static_cast<double>(count);
  }

private:
  static constexpr int Searches = 4; // halvings

  bool Hides(const vtkGodRaysShadowGrids& map, const Vec3& offset, const Vec3& place,
    std::ptrdiff_t& texel) const
  {
    const double distance = this->Directional ? 1.0 : std::max(vtkGodRays::length(place), 1e-300);
    const double at[3] = { place.x / distance, place.y / distance, place.z / distance };
    return this->Directional ? map.GetHeight(at, &texel) > vtkGodRays::dot(offset, this->Light)
                             : map.GetDistance(at, &texel) < distance;
  }

  const vtkGodRaysShadowGrids* Map = nullptr;
  std::vector<vtkGodRaysShadowGrids> Layers; // of it
  Vec3 Axes[3];
  Vec3 Origin = Vec3(0.0);
  Vec3 Light = Vec3(0.0);
  bool Directional = true;
};

#endif
