// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vtkGodRays
{
double GetShadowColumn(int column)
{
  constexpr int each = ShadowLadder::Each;
  if (column >= ShadowLadder::FirstWhole)
  {
    return each + column - static_cast<double>(ShadowLadder::FirstWhole);
  }
  const double least = std::ldexp(1.0, -ShadowLadder::Octaves);
  return column < each ? column * least
                       : std::ldexp(least, column / each - 1) * (each + column % each);
}

void MakeShadowLadder(
  const vtkGodRaysShadowGrids& grids, double low, double high, ShadowLadder& ladder)
{
  const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[0];
  const double least = std::min(grid.Texel[0], grid.Texel[1]);
  const double most = std::max(grid.Texel[0], grid.Texel[1]) * std::sqrt(2.0);
  // From rays at right angles to the light to where all is in the finest column. Both ends are rounded, so
  // that the ladder serves while a camera moves and texels change with it.
  constexpr int rounded = 16;
  const double perStep = 1.0 / std::log(ShadowLadder::Ratio);
  const bool weighs = high > 0.0;
  const double begin =
    weighs ? std::floor(std::log(low * least) * perStep / rounded) * rounded : 0.0;
  const double end =
    weighs ? std::ceil(std::log(3000.0 * high * most) * perStep / rounded + 1.0) * rounded : 0.0;
  const int steps = static_cast<int>(std::min(end - begin, 512.0));
  const double first = std::pow(ShadowLadder::Ratio, begin);
  const int wanted = grid.Size[0] + grid.Size[1] + ShadowLadder::FirstWhole + 128;
  const int columns = (wanted + 63) / 64 * 64;
  if (columns == ladder.Columns && steps == ladder.Steps && first == ladder.First)
  {
    return;
  }
  ladder.Columns = columns;
  ladder.Steps = steps;
  ladder.First = first;
  ladder.Middles.resize(columns + 64);
  ladder.Edges.resize(columns + 64);
  for (int j = 0; j < columns + 64; ++j)
  {
    ladder.Edges[j] = static_cast<float>(GetShadowColumn(j));
    ladder.Middles[j] = static_cast<float>(0.5 * (GetShadowColumn(j) + GetShadowColumn(j + 1)));
  }
  ladder.Weights.assign(static_cast<std::size_t>(steps) * columns, 0.0f);
  for (int step = 0; step < steps; ++step)
  {
    const double x = first * std::pow(ShadowLadder::Ratio, step);
    float* weights = ladder.Weights.data() + static_cast<std::size_t>(step) * columns;
    for (int j = 0; j < columns; ++j)
    {
      const double start = GetShadowColumn(j);
      const double left = std::exp(-x * start);
      if (left < 1e-12)
      {
        break;
      }
      weights[j] = static_cast<float>(left * -std::expm1(-x * (GetShadowColumn(j + 1) - start)));
    }
  }
}

void MakeShadowFan(const vtkGodRaysShadowGrids& grids, ShadowFan& fan)
{
  double least = 1.0;
  for (int face = 0; face < grids.Levels; ++face)
  {
    const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[face];
    least = std::min({ least, grid.Texel[0], grid.Texel[1] });
  }
  const double pi = std::acos(-1.0);
  const int columns = static_cast<int>(std::min(std::ceil(pi / least), 16384.0));
  if (columns == fan.Columns)
  {
    return;
  }
  fan.Columns = columns;
  fan.Angle = pi / columns;
  const int padded = columns + 64;
  for (std::vector<float>* values :
    { &fan.MiddleSines, &fan.MiddleCosines, &fan.EdgeSines, &fan.EdgeMinusCosines })
  {
    values->resize(padded);
  }
  for (int j = 0; j < padded; ++j)
  {
    const double edge = std::min(j, columns) * fan.Angle;
    const double middle = std::min(j + 0.5, columns - 0.5) * fan.Angle;
    fan.MiddleSines[j] = static_cast<float>(std::sin(middle));
    fan.MiddleCosines[j] = static_cast<float>(-std::cos(middle));
    fan.EdgeSines[j] = static_cast<float>(std::sin(edge));
    fan.EdgeMinusCosines[j] = static_cast<float>(std::cos(edge));
  }
}
}
