// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Of vtkGodRaysGridSight: what data change of the medium's light before, between and behind them.

#include "vtkGodRaysGridSight.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

constexpr int FarParts = 16; // an eighth of the parts of what of a ray is outside of data, at most
constexpr double PartOfCrossing = 0.15; // of the tolerance, for each of these
}

// Where on a part of a ray the light's way may go through a grid: a convex polygon of places of the ray and
// of the light's way, clipped by the faces of the grid. Depths lie between nodes, so it is two points wider.
vtkGodRays::Vec2 vtkGodRaysGridSight::FindShadow(
  std::size_t i, const Passage& passage, double begin, double end) const
{
  const vtkGodRaysGrid& grid = this->Grids[i];
  constexpr double margin = 2.0; // points
  const Vec3 size(grid.Points[0] - 1.0, grid.Points[1] - 1.0, grid.Points[2] - 1.0);
  Vec3 corner, across;
  Vec2 vertices[16];
  int count = 0;
  if (this->Directional) // place = corner + x steps + y across
  {
    corner = passage.Place;
    across = grid.GetSteps(this->Light);
    const double reach = vtkGodRays::length(corner + begin * passage.Steps) +
      vtkGodRays::length(corner + end * passage.Steps) + 2.0 * vtkGodRays::length(size) + 10.0;
    const double most = reach / std::max(vtkGodRays::length(across), 1e-300);
    for (const Vec2& each :
      { Vec2(begin, 0.0), Vec2(end, 0.0), Vec2(end, most), Vec2(begin, most) })
    {
      vertices[count++] = each;
    }
  }
  else // the same, with y the part of the way from the light, and x that of the ray times it
  {
    corner = grid.GetPlace(this->Light);
    across = passage.Place - corner;
    for (const Vec2& each : { Vec2(0.0, 0.0), Vec2(begin, 1.0), Vec2(end, 1.0) })
    {
      vertices[count++] = each;
    }
  }
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const auto inside = [&](const Vec2& v)
    {
      const double place = corner[axis] + v.x * passage.Steps[axis] + v.y * across[axis];
      return face % 2 == 0 ? place + margin : size[axis] + margin - place;
    };
    Vec2 kept[16];
    int number = 0;
    for (int k = 0; k < count; ++k)
    {
      const Vec2& from = vertices[k];
      const Vec2& to = vertices[(k + 1) % count];
      const double before = inside(from);
      const double after = inside(to);
      if (before >= 0.0)
      {
        kept[number++] = from;
      }
      if ((before >= 0.0) != (after >= 0.0))
      {
        kept[number++] = from + before / (before - after) * (to - from);
      }
    }
    count = number;
    std::copy_n(kept, count, vertices);
  }
  Vec2 range(end, begin);
  for (int k = 0; k < count; ++k)
  {
    const double part = this->Directional ? 1.0 : vertices[k].y;
    if (!(part > 1e-9)) // the light is in the grid
    {
      return Vec2(begin, end);
    }
    range.x = std::min(range.x, vertices[k].x / part);
    range.y = std::max(range.y, vertices[k].x / part);
  }
  return Vec2(std::clamp(range.x, begin, end), std::clamp(range.y, begin, end));
}

// What data change of the medium's light in a part of the ray that is outside of them.
void vtkGodRaysGridSight::Cross(const Ray& ray, double begin, double end, Way& way) const
{
  // No light comes from outside of a spotlight's cone, whose edge is rounded.
  const Vec2 lit = vtkGodRays::SpotPart(ray.Lit, std::max(end, 0.0));
  const double inset = this->Spot.IsCone() ? 1e-6 * (lit.y - lit.x) : 0.0;
  begin = std::max(begin, lit.x + inset);
  end = std::min(end, lit.y - inset);
  if (!(end > begin))
  {
    return;
  }
  Vec2 dark(end, begin);
  double speed = 0.0;
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const Vec2 shadow = this->FindShadow(i, ray.Passages[i], begin, end);
    if (shadow.x < shadow.y)
    {
      dark = Vec2(std::min(dark.x, shadow.x), std::max(dark.y, shadow.y));
    }
    speed = std::max(speed, ray.Passages[i].Speed);
  }
  const double finest =
    std::max(4.0 / speed, (end - begin) / static_cast<double>(8 * FarParts)); // part of a ray
  const bool dims = way.Depth != Vec3(0.0);
  // Two tell what is even, but not what a planet's shadow is in.
  const int fewest = ray.Lit.PlanetRadius > 0.0 ? FarParts / 2 : 2;
  if (!(dark.x < dark.y))
  {
    dark = Vec2(end);
  }
  if (dims)
  {
    this->CrossPart(ray, begin, dark.x, fewest, finest, way);
  }
  this->CrossPart(ray, dark.x, dark.y, FarParts / 2, finest, way);
  if (dims)
  {
    this->CrossPart(ray, dark.y, end, fewest, finest, way);
  }
}

// In so many parts at first, which are halved where what is changed is not linear.
void vtkGodRaysGridSight::CrossPart(
  const Ray& ray, double begin, double end, int parts, double finest, Way& way) const
{
  if (!(end > begin))
  {
    return;
  }
  struct Node
  {
    double T; // of the part
    double S; // of the ray
    Vec3 Value;
  };
  const auto evaluate = [&](double t) -> Node
  {
    Node node = { t, vtkGodRays::MediumPlace(ray.Lit, begin, end, t), Vec3(0.0) };
    ++way.Steps;
    float light[3] = { 0.0f, 0.0f, 0.0f };
    this->AddLightDepth(ray.Origin + node.S * ray.Along, light);
    if (way.Depth + Vec3(light[0], light[1], light[2]) == Vec3(0.0))
    {
      return node; // nothing is changed
    }
    const Air air = this->GetAir(ray, node.S);
    for (int c = 0; c < 3 && air.Visible; ++c)
    {
      node.Value[c] = air.Strength / air.Square * air.Left[c] * air.Scattered[c] *
        std::expm1(-way.Depth[c] - light[c]);
    }
    return node;
  };
  const auto size = [](const Vec3& v) {
    return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  };
  const double accepted = PartOfCrossing * this->Tolerance * this->Brightest;
  const int first = std::max(std::min(parts, static_cast<int>((end - begin) / finest)), 1);
  Vec3 edge(1.0); // what surfaces leave of the light at the begin of a part
  bool hasEdge = false;
  Node from = evaluate(0.0);
  Node ahead[24]; // ends of parts, the nearest one last
  for (int k = 1; k <= first; ++k)
  {
    int count = 0;
    ahead[count++] = evaluate(static_cast<double>(k) / first);
    while (count > 0)
    {
      const Node to = ahead[count - 1];
      const double length = to.S - from.S;
      const Node middle = evaluate(0.5 * (from.T + to.T));
      const double part = length > 0.0 ? (middle.S - from.S) / length : 0.5;
      const Vec3 bent = middle.Value - (1.0 - part) * from.Value - part * to.Value;
      // Parts are alike as a lamp sees them, and near it shorter than what data ask for.
      const bool isWide = !this->Directional && to.T - from.T > 1.0 / (8 * FarParts);
      const bool halves = (length > finest || isWide) && count < 24;
      if (halves && size(bent) * length > accepted)
      {
        ahead[count++] = middle;
        continue;
      }
      Vec3 value = part * from.Value + middle.Value + (1.0 - part) * to.Value;
      value = 0.5 * value;
      if (part > 0.4 && part < 0.6) // of the parabola
      {
        value = (3.0 * part - 1.0) / (6.0 * part) * from.Value +
          middle.Value / (6.0 * part * (1.0 - part)) +
          (2.0 - 3.0 * part) / (6.0 * (1.0 - part)) * to.Value;
      }
      if (value != Vec3(0.0))
      {
        edge = hasEdge ? edge : this->Shadows.Get(ray.Origin + from.S * ray.Along);
        hasEdge = true;
        Vec3 after = edge;
        const Vec3 sunlit =
          this->Shadows.GetMean(ray.Origin, ray.Along, from.S, to.S, finest, after);
        const bool mixed = sunlit != edge || sunlit != after;
        if (halves && mixed && size(to.Value - from.Value) * length > accepted)
        {
          ahead[count++] = middle;
          continue;
        }
        edge = after;
        way.Light += length * sunlit * value;
      }
      else
      {
        hasEdge = false;
      }
      from = to;
      --count;
    }
  }
}
