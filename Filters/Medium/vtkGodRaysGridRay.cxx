// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridRay.h"

namespace
{
const double Infinity = std::numeric_limits<double>::infinity();

using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

// The part of a convex polygon where a + b x + c y >= 0.
void Cut(std::vector<Vec2>& polygon, double a, double b, double c)
{
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vec2& from = polygon[i];
    const Vec2& to = polygon[(i + 1) % polygon.size()];
    const double at = a + b * from.x + c * from.y;
    const double next = a + b * to.x + c * to.y;
    if (at >= 0.0)
    {
      kept.push_back(from);
    }
    if ((at >= 0.0) != (next >= 0.0))
    {
      kept.push_back(from + at / (at - next) * (to - from));
    }
  }
  polygon.swap(kept);
}
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
    this->FindShadow(passage, end);
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

// The ray and the light span a plane, of which the grid has a convex part. Places in it are (s, t) with
// t >= 0 along a directional light's way, or, with a point light, (s (1 - t), t) with t = 1 at the light.
void vtkGodRaysGridRay::FindShadow(Passage& passage, double end) const
{
  const Vec3 across = this->Directional ? passage.Light : passage.Light - passage.Place;
  std::vector<Vec2> polygon = { Vec2(0.0, 0.0), Vec2(end, 0.0) };
  if (this->Directional)
  {
    double size = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      size +=
        passage.Grid->Points[i] + std::abs(passage.Place[i]) + end * std::abs(passage.Steps[i]);
    }
    const double reach = size / std::max(vtkGodRays::length(across), 1e-300);
    polygon.push_back(Vec2(end, reach));
    polygon.push_back(Vec2(0.0, reach));
  }
  else
  {
    polygon.push_back(Vec2(0.0, 1.0));
  }
  for (int i = 0; i < 3; ++i)
  {
    Cut(polygon, passage.Place[i], passage.Steps[i], across[i]);
    Cut(polygon, passage.Grid->Points[i] - 1 - passage.Place[i], -passage.Steps[i], -across[i]);
  }
  passage.Shadow[0] = polygon.empty() ? 0.0 : end;
  passage.Shadow[1] = 0.0;
  for (const Vec2& corner : polygon)
  {
    const double left = this->Directional ? 1.0 : 1.0 - corner.y;
    const double ends[2] = { left > 1e-9 ? corner.x / left : 0.0,
      left > 1e-9 ? corner.x / left : end };
    passage.Shadow[0] = std::min(passage.Shadow[0], std::max(ends[0], 0.0));
    passage.Shadow[1] = std::max(passage.Shadow[1], std::min(ends[1], end));
  }
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
