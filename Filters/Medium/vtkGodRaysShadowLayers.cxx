// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowLayers.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

namespace
{
constexpr vtkIdType Grain = 4096; // texels

// Whether a surface colours light, by more than rounding does.
bool IsColored(const std::vector<vtkGodRaysShadowLayers::Surface>& surfaces)
{
  std::atomic<bool> colored(false);
  for (const vtkGodRaysShadowLayers::Surface& surface : surfaces)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(surface.Depths.size()), Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        bool differs = false;
        for (vtkIdType i = begin; i < end; ++i)
        {
          const float* t = surface.Through.data() + 4 * i;
          differs = differs ||
            (t[3] > 0.0f && std::max(std::abs(t[0] - t[1]), std::abs(t[0] - t[2])) > 1e-3f);
        }
        if (differs)
        {
          colored = true;
        }
      });
  }
  return colored;
}
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowLayers::Make(
  const std::vector<float>& opaque, const std::vector<Surface>& surfaces)
{
  this->Colored = IsColored(surfaces);
  const int channels = this->Colored ? 3 : 1;
  this->Room.resize(surfaces.size() + 1);
  for (Planes& planes : this->Room)
  {
    planes.Depths.resize(opaque.size());
    for (int c = 0; c < 3; ++c)
    {
      planes.Dark[c].resize(c < channels ? opaque.size() : 0);
    }
  }
  std::atomic<int> most(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(opaque.size()), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      int mostHere = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        int layer = 0;
        float through[3] = { 1.0f, 1.0f, 1.0f }; // what is before
        float last = 0.0f;
        const auto add = [&](float depth, const float* let)
        {
          Planes& planes = this->Room[layer++];
          planes.Depths[i] = depth;
          for (int c = 0; c < channels; ++c)
          {
            const float t = let ? std::min(std::max(let[c], 0.0f), 1.0f) : 0.0f;
            planes.Dark[c][i] = through[c] * (1.0f - t);
            through[c] *= t;
          }
          last = depth;
        };
        for (const Surface& surface : surfaces)
        {
          const float* let = surface.Through.data() + 4 * i;
          const float depth = surface.Depths[i];
          if (let[3] > 0.0f && (layer == 0 || depth > last) && depth < opaque[i])
          {
            add(depth, let);
          }
        }
        if (opaque[i] < 1.0f)
        {
          add(opaque[i], nullptr);
        }
        mostHere = std::max(mostHere, layer);
        for (; layer < static_cast<int>(this->Room.size()); ++layer)
        {
          this->Room[layer].Depths[i] = 1.0f;
          for (int c = 0; c < channels; ++c)
          {
            this->Room[layer].Dark[c][i] = 0.0f;
          }
        }
      }
      int before = most;
      while (before < mostHere && !most.compare_exchange_weak(before, mostHere))
      {
      }
    });
  this->Room.resize(most);
  this->Layers.resize(most);
  for (std::size_t k = 0; k < this->Room.size(); ++k)
  {
    this->Layers[k].Depths = this->Room[k].Depths.data();
    for (int c = 0; c < 3; ++c)
    {
      this->Layers[k].Dark[c] = this->Room[k].Dark[this->Colored ? c : 0].data();
    }
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowLayers::Clear()
{
  this->Room.clear();
  this->Layers.clear();
  this->Colored = false;
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowLayers::Set(vtkGodRaysShadowGrids& grids) const
{
  grids.Layers = this->Layers.data();
  grids.NumberOfLayers = this->GetNumberOfLayers();
  grids.Colored = this->Colored;
}
