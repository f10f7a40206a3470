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

using Haze = vtkGodRaysShadowLayers::Haze;

// What a texel has of a haze: layers of equal parts.
struct Veil
{
  int Count = 0;
  float Depths[Haze::Layers];
  float Lost = 0.0f; // part of the light, in the end

  // What the light that is left behind k of them is times behind the next one.
  float GetThrough(int k) const
  {
    return (Haze::Layers - (k + 1) * this->Lost) / (Haze::Layers - k * this->Lost);
  }
};

// Which face a texel of a map is in, and where.
void FindTexel(
  const vtkGodRaysShadowGrids& grids, int size, std::ptrdiff_t texel, int& face, int at[2])
{
  const std::ptrdiff_t stride = grids.Grids[0].Stride;
  const int x = static_cast<int>(texel % stride);
  const int y = static_cast<int>(texel / stride);
  face = static_cast<int>(y / size * (stride / size) + x / size);
  at[0] = x % size;
  at[1] = y % size;
}

// Linear between places.
void FindVeil(
  const Haze& haze, const vtkGodRaysShadowGrids& grids, std::ptrdiff_t texel, Veil& veil)
{
  veil.Count = 0;
  int face;
  int at[2];
  FindTexel(grids, haze.FaceSize, texel, face, at);
  if (face >= grids.Levels)
  {
    return;
  }
  constexpr int values = Haze::Slices + 1;
  const float* places[4];
  float weights[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  int low[2];
  for (int i = 0; i < 2; ++i)
  {
    const float x = std::min(
      std::max((static_cast<float>(at[i]) + 0.5f) / Haze::Scale - 0.5f, 0.0f), haze.Size - 1.0f);
    low[i] = std::min(static_cast<int>(x), std::max(haze.Size - 2, 0));
    const float part = x - static_cast<float>(low[i]);
    for (int k = 0; k < 4; ++k)
    {
      weights[k] *= (k >> i & 1) != 0 ? part : 1.0f - part;
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    const int x = std::min(low[0] + (k & 1), haze.Size - 1);
    const int y = std::min(low[1] + (k >> 1), haze.Size - 1);
    places[k] = haze.Dark.data() +
      ((static_cast<std::ptrdiff_t>(face) * haze.Size + y) * haze.Size + x) * values;
  }
  const auto get = [&](int slice)
  {
    return weights[0] * places[0][slice] + weights[1] * places[1][slice] +
      weights[2] * places[2][slice] + weights[3] * places[3][slice];
  };
  veil.Lost = std::min(get(Haze::Slices), 1.0f - 1e-6f);
  if (veil.Lost < 1e-4f)
  {
    return;
  }
  float before = 0.0f;
  for (int slice = 1; slice <= Haze::Slices; ++slice)
  {
    const float dark = get(slice);
    while (veil.Count < Haze::Layers)
    {
      const float wanted = (static_cast<float>(veil.Count) + 0.5f) / Haze::Layers * veil.Lost;
      if (wanted > dark)
      {
        break;
      }
      const float part = (wanted - before) / std::max(dark - before, 1e-20f);
      veil.Depths[veil.Count++] =
        haze.Depths[slice - 1] + part * (haze.Depths[slice] - haze.Depths[slice - 1]);
    }
    before = dark;
  }
}
}

void vtkGodRaysShadowLayers::Make(const std::vector<float>& opaque,
  const std::vector<Surface>& surfaces, const Haze* haze, const vtkGodRaysShadowGrids& grids)
{
  this->Colored = IsColored(surfaces);
  const int channels = this->Colored ? 3 : 1;
  // Planes are kept for the next map, also those that no texel fills, as zeroing them takes its time.
  this->Room.resize(surfaces.size() + 1 + (haze ? Haze::Layers : 0));
  for (Planes& planes : this->Room)
  {
    planes.Depths.resize(opaque.size());
    for (int c = 0; c < 3; ++c)
    {
      if (c < channels)
      {
        planes.Dark[c].resize(opaque.size());
      }
      else
      {
        std::vector<float>().swap(planes.Dark[c]);
      }
    }
  }
  std::atomic<int> most(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(opaque.size()), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      int mostHere = 0;
      Veil veil;
      for (vtkIdType i = begin; i < end; ++i)
      {
        int layer = 0;
        float through[3] = { 1.0f, 1.0f, 1.0f }; // what is before
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
        };
        float lastSurface = -1.0f;
        int k = 0; // of the veil
        const auto addVeil = [&](float end)
        {
          for (; k < veil.Count && veil.Depths[k] < end; ++k)
          {
            const float t = veil.GetThrough(k);
            const float let[3] = { t, t, t };
            add(veil.Depths[k], let);
          }
        };
        if (haze)
        {
          FindVeil(*haze, grids, i, veil);
        }
        for (const Surface& surface : surfaces)
        {
          const float* let = surface.Through.data() + 4 * i;
          const float depth = surface.Depths[i];
          if (let[3] > 0.0f && depth > lastSurface && depth < opaque[i])
          {
            addVeil(depth);
            add(depth, let);
            lastSurface = depth;
          }
        }
        addVeil(opaque[i]);
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
  this->Layers.resize(most);
  for (std::size_t k = 0; k < this->Layers.size(); ++k)
  {
    this->Layers[k].Depths = this->Room[k].Depths.data();
    for (int c = 0; c < 3; ++c)
    {
      this->Layers[k].Dark[c] = this->Room[k].Dark[this->Colored ? c : 0].data();
    }
  }
}

void vtkGodRaysShadowLayers::Clear()
{
  this->Room.clear();
  this->Layers.clear();
  this->Colored = false;
}

void vtkGodRaysShadowLayers::Set(vtkGodRaysShadowGrids& grids) const
{
  grids.Layers = this->Layers.data();
  grids.NumberOfLayers = this->GetNumberOfLayers();
  grids.Colored = this->Colored;
}
