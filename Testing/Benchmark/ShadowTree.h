// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What is published as 1-D min/max mipmaps: the shadow map's texels in a plane through the eye and along a
// directional light, and the least and the greatest height of ever more of them. A view ray in that plane
// walks down where these do not tell whether it is lit. [Chen2011]

#ifndef ShadowTree_h
#define ShadowTree_h

#include "vtkGodRaysShadowGrids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

class ShadowTree
{
public:
  /// Of the first of the grids, in the plane at an angle from its first axis to its second.
  void Build(const vtkGodRaysShadowGrids& grids, double angle)
  {
    const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[0];
    const double way[2] = { std::cos(angle), std::sin(angle) };
    double begin = 0.0;
    double end = 1e30;
    for (int i = 0; i < 2; ++i)
    {
      const double low = grid.Low[i];
      const double high = low + grid.Size[i] * grid.Texel[i];
      const double perWay = 1.0 / (std::abs(way[i]) > 1e-12 ? way[i] : 1e-12);
      begin = std::max(begin, std::min(low * perWay, high * perWay));
      end = std::min(end, std::max(low * perWay, high * perWay));
    }
    this->Begin = begin;
    this->Width =
      1.0 / std::max(std::abs(way[0]) / grid.Texel[0], std::abs(way[1]) / grid.Texel[1]);
    const int columns =
      grids.Levels > 0 && begin < end ? static_cast<int>((end - begin) / this->Width) + 1 : 0;
    this->Least.resize(1);
    this->Least[0].resize(columns);
    for (int j = 0; j < columns; ++j)
    {
      const double t = begin + (j + 0.5) * this->Width;
      const int x = static_cast<int>(std::floor((t * way[0] - grid.Low[0]) / grid.Texel[0]));
      const int y = static_cast<int>(std::floor((t * way[1] - grid.Low[1]) / grid.Texel[1]));
      const bool isInside = x >= 0 && y >= 0 && x < grid.Size[0] && y < grid.Size[1];
      const float depth = isInside ? grid.Depths[y * grid.Stride + x] : 1.0f;
      this->Least[0][j] =
        depth < 1.0f ? static_cast<float>(grids.GetHeight(depth)) : vtkGodRaysShadowGrids::Nothing;
    }
    this->Most = this->Least;
    while (this->Least.back().size() > 1)
    {
      this->AddLevel();
    }
  }

  /// Tell of each part of a view ray, from the eye to a distance across the light, whether it is lit:
  /// visit(isLit, from there, to there). The ray rises by a slope towards the light.
  template <typename Visit>
  void Walk(double slope, double end, const Visit& visit) const
  {
    const double first = std::min(this->Begin, end);
    visit(true, 0.0, first);
    if (!this->Least[0].empty())
    {
      this->Walk(static_cast<int>(this->Least.size()) - 1, 0, slope, end, visit);
    }
    const double last = this->Begin + this->Least[0].size() * this->Width;
    visit(true, std::min(std::max(last, first), end), end);
  }

private:
  void AddLevel()
  {
    const std::size_t count = (this->Least.back().size() + 1) / 2;
    std::vector<float> least(count);
    std::vector<float> most(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t other = std::min(2 * i + 1, this->Least.back().size() - 1);
      least[i] = std::min(this->Least.back()[2 * i], this->Least.back()[other]);
      most[i] = std::max(this->Most.back()[2 * i], this->Most.back()[other]);
    }
    this->Least.push_back(std::move(least));
    this->Most.push_back(std::move(most));
  }

  template <typename Visit>
  void Walk(int level, std::size_t node, double slope, double end, const Visit& visit) const
  {
    const double from = this->Begin + std::ldexp(static_cast<double>(node), level) * this->Width;
    const double to = std::min(from + std::ldexp(this->Width, level), end);
    if (node >= this->Least[level].size() || from >= end)
    {
      return;
    }
    const double heights[2] = { slope * from, slope * to };
    const double middle = 0.5 * (heights[0] + heights[1]);
    if (this->Most[level][node] <= std::min(heights[0], heights[1]))
    {
      visit(true, from, to);
    }
    else if (level == 0 || this->Least[level][node] > std::max(heights[0], heights[1]))
    {
      visit(this->Most[level][node] <= middle, from, to);
    }
    else
    {
      this->Walk(level - 1, 2 * node, slope, end, visit);
      this->Walk(level - 1, 2 * node + 1, slope, end, visit);
    }
  }

  double Begin = 0.0; // of the texels [scene units from the eye, across the light]
  double Width = 1.0; // of one
  std::vector<std::vector<float>> Least; // heights, of one texel, of two, and so on
  std::vector<std::vector<float>> Most;
};

#endif
