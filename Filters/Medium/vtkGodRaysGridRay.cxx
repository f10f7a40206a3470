// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridRay.h"

namespace
{
const double Infinity = std::numeric_limits<double>::infinity();

using vtkGodRays::Vec3;
}

void vtkGodRaysGridRay::Cast(const std::vector<vtkGodRaysGrid>& grids, const Vec3& origin,
  const Vec3& along, double end, const Vec3& light, bool directional)
{
  this->Passages.clear();
  this->Knots.clear();
  this->Ends.clear();
  this->Directional = directional;
  for (const vtkGodRaysGrid& grid : grids)
  {
    Passage passage = { &grid, grid.GetPlace(origin), grid.GetSteps(along),
      directional ? grid.GetSteps(light) : grid.GetPlace(light), 0.0, Vec3(0.0), {}, { 0.0, 0.0 },
      0.0 };
    const auto visit = [&](std::size_t point, const Vec3& corner, double from, double to)
    {
      passage.Parts.push_back({ from, point, corner, passage.Depth });
      grid.AddCellDepth(point, passage.Place + from * passage.Steps - corner,
        passage.Place + to * passage.Steps - corner, to - from, passage.Depth);
      passage.End = to;
      this->Knots.push_back(from);
    };
    grid.Walk(passage.Place, passage.Steps, 0.0, end, visit);
    this->Knots.push_back(passage.End);
    const vtkGodRays::Vec2 shadow =
      grid.FindShadow(passage.Place, passage.Steps, end, passage.Light, directional);
    passage.Shadow[0] = shadow.x;
    passage.Shadow[1] = shadow.y;
    const double fastest = std::max(
      { std::abs(passage.Steps.x), std::abs(passage.Steps.y), std::abs(passage.Steps.z), 1e-300 });
    passage.Cell = 1.0 / fastest;
    const double length = passage.Shadow[1] - passage.Shadow[0];
    const int pieces = static_cast<int>(std::clamp(std::ceil(length * fastest), 1.0, 65536.0));
    for (int i = 0; i <= pieces && length > 0.0; ++i)
    {
      this->Knots.push_back(passage.Shadow[0] + length * i / pieces);
    }
    const double first = passage.Parts.empty() ? 0.0 : passage.Parts.front().Begin;
    this->Ends.insert(
      this->Ends.end(), { first, passage.End, passage.Shadow[0], passage.Shadow[1] });
    this->Passages.push_back(std::move(passage));
  }
  std::sort(this->Knots.begin(), this->Knots.end());
  std::sort(this->Ends.begin(), this->Ends.end());
}

void vtkGodRaysGridRay::Add(double s, double cosAngle, bool lit, Vec3& scattered, Vec3& depth) const
{
  for (const Passage& passage : this->Passages)
  {
    const vtkGodRaysGrid& grid = *passage.Grid;
    const Vec3 place = passage.Place + s * passage.Steps;
    if (passage.Parts.empty() || s >= passage.End)
    {
      depth += passage.Depth;
    }
    else if (s > passage.Parts.front().Begin)
    {
      const Part& part = *(std::upper_bound(passage.Parts.begin(), passage.Parts.end(), s,
                             [](double value, const Part& other) { return value < other.Begin; }) -
        1);
      depth += part.Depth;
      Vec3 here(0.0);
      grid.AddCellDepth(part.Point, passage.Place + part.Begin * passage.Steps - part.Corner,
        place - part.Corner, s - part.Begin, here);
      depth += here;
      scattered += vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, cosAngle) *
        grid.Sample(place).Scattering;
    }
    // Rounding moves the shadow's ends a little.
    const double slack = 1e-9 * (passage.Cell + s);
    if (lit && s >= passage.Shadow[0] - slack && s <= passage.Shadow[1] + slack)
    {
      // Lengths along the light's way are those of the scene in the first case, the way's in the second.
      const Vec3 steps = this->Directional ? passage.Light : passage.Light - place;
      Vec3 way(0.0);
      grid.AddDepth(place, steps, 0.0, this->Directional ? Infinity : 1.0, way);
      if (!this->Directional)
      {
        const Vec3 offset =
          steps.x * grid.Axes[0] + steps.y * grid.Axes[1] + steps.z * grid.Axes[2];
        way *= vtkGodRays::length(offset);
      }
      depth += way;
    }
  }
}
