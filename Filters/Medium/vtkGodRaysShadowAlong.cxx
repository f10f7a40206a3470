// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowAlong.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace vtkGodRays
{
namespace
{
// What is dark of a view ray along light rays: all before a view depth, and all from another one on; and
// the texels whose occluders make it so.
struct DarkEnds
{
  float Before = 0.0f;
  float From = CoverageSky;
  std::ptrdiff_t BeforeTexel = 0;
  std::ptrdiff_t FromTexel = 0;
};

// Of the line through the eye and the light.
DarkEnds FindDarkEnds(const CoverageSettings& settings, const vtkGodRaysShadowGrids& grids)
{
  DarkEnds ends;
  const double* light = settings.Light;
  const bool isAhead = light[2] > 0.0;
  if (!grids.Point)
  {
    // Ahead, all up to the occluder is dark; behind the eye, all beyond it.
    const double eye[3] = { 0.0, 0.0, 0.0 };
    const double height = grids.GetHeight(eye, &ends.BeforeTexel);
    ends.FromTexel = ends.BeforeTexel;
    const float depth = static_cast<float>(std::max(height * light[2], 0.0));
    ends.Before = isAhead ? depth : 0.0f;
    ends.From = isAhead ? CoverageSky : std::min(depth, CoverageSky);
    return ends;
  }
  const bool parallel = settings.Parallel;
  const double distance =
    parallel ? std::abs(light[2]) : std::hypot(std::hypot(light[0], light[1]), light[2]);
  const double forward = isAhead ? 1.0 : -1.0;
  const double away[3] = { parallel ? 0.0 : light[0] / distance,
    parallel ? 0.0 : light[1] / distance, parallel ? forward : light[2] / distance };
  const double towards[3] = { -away[0], -away[1], -away[2] };
  // On the eye's side of the light.
  const double toOccluder =
    grids.GetDistance(towards, isAhead ? &ends.BeforeTexel : &ends.FromTexel);
  if (isAhead)
  {
    const double beyond = (distance + grids.GetDistance(away, &ends.FromTexel)) * away[2];
    ends.Before = static_cast<float>(std::max((distance - toOccluder) * away[2], 0.0));
    ends.From = static_cast<float>(std::min<double>(beyond, CoverageSky));
    return ends;
  }
  ends.Before = 0.0f;
  ends.From = static_cast<float>(
    std::min<double>(std::max((toOccluder - distance) * towards[2], 0.0), CoverageSky));
  return ends;
}

// Of a pixel's ray from the eye's plane, along a directional light.
DarkEnds FindDarkEndsOfPixel(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysShadowGrids& grids, vtkIdType row, int column)
{
  DarkEnds ends;
  const bool isAhead = settings.Light[2] > 0.0;
  const double x = (column - image.Center[0]) * settings.PixelSize;
  const double y = (row - image.Center[1]) * settings.PixelSize;
  const double place[3] = { x, y, 0.0 };
  const double height = grids.GetHeight(place, &ends.BeforeTexel);
  ends.FromTexel = ends.BeforeTexel;
  const float depth = static_cast<float>(isAhead ? height : -height);
  ends.Before = isAhead ? std::max(depth, 0.0f) : 0.0f;
  ends.From = isAhead ? CoverageSky : std::min(std::max(depth, 0.0f), CoverageSky);
  return ends;
}

// Add what is dark by a layer's parts, of the colours.
void AddInParts(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysShadowGrids::Layer& layer, std::ptrdiff_t pixel, const DarkEnds& ends)
{
  float sums[CoverageMaximumPlanes];
  for (int plane = 0; plane < settings.Planes; ++plane)
  {
    sums[plane] = image.Hidden[plane][pixel];
  }
  const auto add = [&](float before, float from, std::ptrdiff_t texel)
  {
    HideCoverageInterval(settings, image, pixel, before, from);
    for (int plane = 0; plane < settings.Planes; ++plane)
    {
      sums[plane] += layer.Dark[plane % settings.Channels][texel] * image.Hidden[plane][pixel];
    }
  };
  if (ends.Before > 0.0f)
  {
    add(ends.Before, CoverageSky, ends.BeforeTexel);
  }
  if (ends.From < CoverageSky)
  {
    add(0.0f, ends.From, ends.FromTexel);
  }
  for (int plane = 0; plane < settings.Planes; ++plane)
  {
    image.Hidden[plane][pixel] = sums[plane];
  }
}
}

void HideAlongRay(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysShadowGrids& grids, std::ptrdiff_t pixel)
{
  if (grids.NumberOfLayers == 0)
  {
    const DarkEnds ends = FindDarkEnds(settings, grids);
    HideCoverageInterval(settings, image, pixel, ends.Before, ends.From);
    return;
  }
  for (int plane = 0; plane < settings.Planes; ++plane)
  {
    image.Hidden[plane][pixel] = 0.0f;
  }
  for (int k = 0; k < grids.NumberOfLayers; ++k)
  {
    AddInParts(settings, image, grids.Layers[k], pixel, FindDarkEnds(settings, grids.GetLayer(k)));
  }
}

void HideAlongRays(
  const CoverageSettings& settings, const CoverageImage& image, const vtkGodRaysShadowGrids& grids)
{
  if (settings.Point)
  {
    return;
  }
  const auto hide = [&](const vtkGodRaysShadowGrids& one, const vtkGodRaysShadowGrids::Layer* layer)
  {
    vtkSMPTools::For(0, image.Height, 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          for (int column = 0; column < image.Width; ++column)
          {
            const DarkEnds ends = FindDarkEndsOfPixel(settings, image, one, row, column);
            const std::ptrdiff_t pixel = row * image.Width + column;
            if (layer)
            {
              AddInParts(settings, image, *layer, pixel, ends);
              continue;
            }
            HideCoverageInterval(settings, image, pixel, ends.Before, ends.From);
          }
        }
      });
  };
  if (grids.NumberOfLayers == 0)
  {
    hide(grids, nullptr);
  }
  for (int k = 0; k < grids.NumberOfLayers; ++k)
  {
    hide(grids.GetLayer(k), grids.Layers + k); // on what is 0 before
  }
}
}
