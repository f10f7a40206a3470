// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridSight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr double FourPi = 12.566370614359172;
constexpr double WidestPiece = 0.15; // of a step, as a lamp sees it [radians]
constexpr int FarParts = 16; // an eighth of the parts of what of a ray is outside of data, at most
constexpr double PartOfCrossing = 0.15; // of the tolerance, for each of these

using Blocks = vtkGodRaysGridBlocks;
using Place = vtkGodRaysGridPlace;

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}
}

//------------------------------------------------------------------------------
void vtkGodRaysGridSight::SetUp(const vtkGodRaysSingleScattering::Parameters& parameters)
{
  this->Position = ToVector(parameters.Position);
  this->Axes[0] = ToVector(parameters.Right);
  this->Axes[1] = ToVector(parameters.Up);
  this->Axes[2] = ToVector(parameters.Forward);
  const auto toWorld = [&](const double* v)
  { return v[0] * this->Axes[0] + v[1] * this->Axes[1] + v[2] * this->Axes[2]; };
  this->Parallel = parameters.Parallel;
  this->Directional = parameters.Light[3] == 0.0;
  this->Light = ToVector(parameters.Light);
  this->Light =
    this->Light / (this->Directional ? vtkGodRays::length(this->Light) : parameters.Light[3]);
  this->LightColor = ToVector(parameters.LightColor);
  this->Medium = parameters.Medium;
  this->Spot = parameters.Spot;
  this->SpotAxis = toWorld(parameters.Spot.Axis);
  this->Upwards = toWorld(parameters.Medium.Up);
  this->Shadows.Place(this->Position, this->Axes, this->Light, this->Directional);
  this->Tolerance = parameters.Tolerance;
  this->Haze = false;
  for (int k = 0; k < 2; ++k)
  {
    vtkGodRaysMedium::Component component;
    if (k < this->Medium.NumberOfComponents)
    {
      component = this->Medium.Components[k];
    }
    for (int c = 0; c < 3; ++c)
    {
      const double extinction = component.Scattering[c] + component.Absorption[c];
      this->Components[c][k] = { component.Scattering[c], extinction, component.ScaleHeight,
        { component.PhaseFunction, component.Asymmetry },
        { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight };
      this->Haze = this->Haze || extinction > 0.0;
    }
  }
  this->Grey = this->Medium.IsGrey() && !this->Shadows.AreColored();
  for (const vtkGodRaysGrid& grid : this->Grids)
  {
    this->Grey = this->Grey && grid.Bands == 1 && grid.ScatteringBands <= 1 &&
      grid.Albedo[0] == grid.Albedo[1] && grid.Albedo[1] == grid.Albedo[2];
  }

  const double light[5] = { this->Light.x, this->Light.y, this->Light.z,
    this->Directional ? 0.0 : 1.0, 1.0 };
  const double rounding = 1e-9 *
    (this->Directional ? 1.0
                       : std::max(vtkGodRays::length(this->Light),
                           vtkGodRays::length(this->Light - this->Position)));
  this->Kept = std::equal(light + 3, light + 5, this->LastLight + 3) &&
    std::equal(light, light + 3, this->LastLight,
      [=](double a, double b) { return std::abs(a - b) <= rounding; });
  if (!this->Kept)
  {
    this->Lights.resize(this->Grids.size());
    for (std::size_t i = 0; i < this->Grids.size(); ++i)
    {
      this->Lights[i].Build(this->Grids[i], this->Light, this->Directional);
    }
    std::copy_n(light, 5, this->LastLight);
  }
}

//------------------------------------------------------------------------------
vtkGodRaysGridSight::Air vtkGodRaysGridSight::GetAir(const Ray& ray, double s) const
{
  Air air;
  const vtkGodRays::LitRay& lit = ray.Lit;
  const double beyond = s - ray.Foot;
  const double r = std::max(std::hypot(lit.Distance, beyond), 1e-30);
  air.Cosine = this->Directional ? ray.Foot : -beyond / r;
  if (!this->Directional)
  {
    air.Visible = vtkGodRays::IsInSpot(lit, s, r);
    air.Strength = vtkGodRays::SpotFactor(lit, s, r);
    air.Square = r * r;
  }
  if (!this->Haze)
  {
    return air;
  }
  const double height = vtkGodRays::MediumHeight(lit.PlanetRadius, lit.Height, lit.Slope, s);
  const double slope = vtkGodRays::LightSlope(lit, height, s, r);
  air.Visible = air.Visible && !vtkGodRays::IsInPlanetShadow(lit, height, slope, r);
  for (int c = 0; c < (this->Grey ? 1 : 3) && air.Visible; ++c)
  {
    double depth = 0.0;
    for (const vtkGodRays::MediumComponent& component : this->Components[c])
    {
      if (component.Extinction > 0.0)
      {
        depth += vtkGodRays::LightDepth(component, lit, height, slope, r) +
          component.Extinction *
            vtkGodRays::MediumDepth(
              lit.PlanetRadius, lit.Height, lit.Slope, component.ScaleHeight, s);
        air.Scattered[c] += vtkGodRays::ScatteredPart(component, height, air.Cosine);
        if (this->Directional && component.ScaleHeight > 0.0 && lit.PlanetRadius == 0.0 &&
          slope <= 0.0)
        {
          depth = Infinity; // a plane hides what is below its horizon
        }
      }
    }
    air.Left[c] = std::exp(-depth);
  }
  if (this->Grey)
  {
    air.Scattered = Vec3(air.Scattered.x);
    air.Left = Vec3(air.Left.x);
  }
  return air;
}

//------------------------------------------------------------------------------
void vtkGodRaysGridSight::AddLightDepth(const Vec3& position, float* depth) const
{
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    float here[3] = { 0.0f, 0.0f, 0.0f };
    this->Lights[i].AddDepth(this->Grids[i], this->Grids[i].GetPlace(position), here);
    for (int c = 0; c < 3; ++c)
    {
      depth[c] += here[this->Grids[i].Bands == 1 ? 0 : c];
    }
  }
}

//------------------------------------------------------------------------------
// Into how many pieces, alike as a lamp sees them, a step falls.
int vtkGodRaysGridSight::CountPieces(const vtkGodRays::LitRay& lit, double begin, double end) const
{
  return this->Directional || !(begin < end)
    ? 1
    : static_cast<int>(1.0 +
        lit.Distance * vtkGodRays::PointAirlight(lit.Foot, lit.Distance, begin, end) / WidestPiece);
}

//------------------------------------------------------------------------------
// What data leave of the light at a place.
vtkGodRays::Vec3 vtkGodRaysGridSight::GetArriving(const Vec3& position) const
{
  float way[3] = { 0.0f, 0.0f, 0.0f };
  this->AddLightDepth(position, way);
  return vtkGodRays::exp(-Vec3(way[0], way[1], way[2]));
}

//------------------------------------------------------------------------------
// The logarithm of how much more there is of light, or of what scatters it, at one place than at the other.
double vtkGodRaysGridSight::Air::GetChange(const Air& other) const
{
  if (this->Visible != other.Visible)
  {
    return Infinity;
  }
  double change = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    for (const Vec3 Air::*part : { &Air::Left, &Air::Scattered })
    {
      const double low = std::min((this->*part)[c], (other.*part)[c]);
      const double high = std::max((this->*part)[c], (other.*part)[c]);
      change = high > 1e-30 ? std::max(change, std::log(high / std::max(low, 1e-30))) : change;
    }
  }
  return change;
}

//------------------------------------------------------------------------------
// A part of the ray that is in data, block by block.
void vtkGodRaysGridSight::March(
  const Ray& ray, double begin, double end, Vec3& depth, Vec3& sum, std::size_t& steps) const
{
  const int count = static_cast<int>(this->Grids.size());
  double cell = end; // the shortest one
  for (int i = 0; i < count; ++i)
  {
    const Passage& passage = ray.Passages[i];
    cell = passage.Begin < passage.End ? std::min(cell, 1.0 / passage.Speed) : cell;
  }
  const Vec2 lit = vtkGodRays::SpotPart(ray.Lit, std::max(end, 0.0)); // in a spotlight's cone
  Front front;
  for (double s = begin; s < end;)
  {
    // How far everything is in one block, and into how many steps data divide that.
    double last = end;
    double parts = 1.0;
    double fastest = 0.0;
    double thickest = 0.0;
    bool outside = true;
    const double ahead = s + 1e-9 * (cell + s);
    const double left = std::exp(-std::min({ depth.x, depth.y, depth.z }));
    for (int i = 0; i < count; ++i)
    {
      const Passage& passage = ray.Passages[i];
      if (!(passage.Begin < passage.End))
      {
        continue;
      }
      fastest = std::max(fastest, passage.Speed);
      if (ahead < passage.Begin || ahead > passage.End)
      {
        last = ahead < passage.Begin ? std::min(last, passage.Begin) : last;
        continue;
      }
      outside = false;
      double exit;
      const Vec2 range = this->AllBlocks[i].Get(
        passage.Place + ahead * passage.Steps, passage.Place, passage.Steps, ahead, exit);
      last = std::min({ last, std::max(exit, ahead), passage.End });
      const double length = Blocks::BlockSize / passage.Speed;
      const double change = (range.y - range.x + 0.5 * range.y * range.y * length) * length * left;
      parts = std::max(parts,
        std::clamp(std::sqrt(change / (4.0 * this->Tolerance)), 1.0, 2.0 * Blocks::BlockSize) *
          (last - s) / length);
      thickest += range.y;
    }
    // A step is in the cone or not.
    bool isEdge = false;
    for (const double edge : { lit.x, lit.y })
    {
      if (this->Spot.IsCone() && edge > ahead && edge <= last)
      {
        last = edge;
        isEdge = true;
      }
    }
    if (outside && this->Haze)
    {
      this->Cross(ray, s, last, depth, sum, steps);
    }
    if (outside || (thickest == 0.0 && !this->Haze))
    {
      front.IsKnown = false;
    }
    else
    {
      const double cells = (last - s) * fastest;
      this->MarchBlock(ray, s, last, thickest > 0.0 ? parts : std::max(1.0, cells / 4.0), cells,
        thickest, front, depth, sum, steps);
    }
    front.IsKnown = front.IsKnown && !isEdge;
    s = last;
    if (!this->Haze && left < 0.02 * this->Tolerance)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
// A part of the ray in one block, in at least so many steps. There are more where light changes faster than
// data do: in haze, in the shadow of other data, and near a lamp, from which the steps then look alike.
void vtkGodRaysGridSight::MarchBlock(const Ray& ray, double begin, double end, double parts,
  double cells, double thickest, Front& front, Vec3& depth, Vec3& sum, std::size_t& steps) const
{
  const int colours = this->Grey ? 1 : 3;
  const vtkGodRays::LitRay& lit = ray.Lit;
  Vec3 position = ray.Origin + begin * ray.Along;
  const double inset = this->Spot.IsCone() ? 1e-6 * (end - begin) : 0.0; // edges are rounded
  if (!front.IsKnown)
  {
    front = { true, false, this->Shadows.Get(position), this->GetAir(ray, begin + inset),
      Vec3(1.0) };
  }
  Front next = { true, false, front.Edge, this->GetAir(ray, end - inset), Vec3(1.0) };
  const double most = 0.9 * std::sqrt(this->Tolerance); // in a step
  const double change = this->Haze ? front.Medium.GetChange(next.Medium) : 0.0;
  parts = std::max(parts, std::min(change / most, 8.0 * Blocks::BlockSize));
  const double left = std::exp(-std::min({ depth.x, depth.y, depth.z }));
  const Vec3& haze = front.Medium.Scattered;
  const double thickness =
    (end - begin) * left * (thickest + FourPi * std::max({ haze.x, haze.y, haze.z }));
  next.HasArriving = thickness > this->Tolerance;
  if (next.HasArriving)
  {
    front.Arriving = front.HasArriving ? front.Arriving : this->GetArriving(position);
    next.Arriving = this->GetArriving(ray.Origin + end * ray.Along);
    const Vec3 jump = vtkGodRays::abs(next.Arriving - front.Arriving);
    const double wanted =
      thickness * std::max({ jump.x, jump.y, jump.z }) / (2.0 * this->Tolerance);
    parts = std::max(parts, std::min(wanted, cells));
  }
  const int number = static_cast<int>(std::clamp(std::ceil(parts - 1e-6), 1.0, 512.0));
  const bool isEven = this->Directional && change < most;
  Air air = front.Medium;
  air.Left = 0.5 * (front.Medium.Left + next.Medium.Left);
  air.Scattered = 0.5 * (front.Medium.Scattered + next.Medium.Scattered);
  double from = begin;
  int part = 0;   // of the steps into which data divide the block
  int piece = 0;  // of it, as a lamp sees them
  int pieces = 0; // how many there are
  for (; part < number; ++steps)
  {
    const double first = begin + part * (end - begin) / number;
    const double last = part + 1 < number ? begin + (part + 1) * (end - begin) / number : end;
    if (piece == 0)
    {
      pieces = this->CountPieces(lit, first, last);
    }
    const auto find = [&](double t)
    {
      return pieces > 1 ? vtkGodRays::MediumPlace(lit, first, last, t / pieces)
                        : first + t * (last - first);
    };
    const double to = piece + 1 < pieces ? find(piece + 1.0) : last;
    const double middle = find(piece + 0.5);
    const double step = to - from;
    piece = (piece + 1) % pieces;
    part += piece == 0 ? 1 : 0;
    position = ray.Origin + middle * ray.Along;
    if (!isEven)
    {
      air = this->GetAir(ray, middle);
    }
    Vec3 extinction(0.0);
    Vec3 scattered(0.0);
    for (std::size_t i = 0; i < this->Grids.size() && thickest > 0.0; ++i)
    {
      const Passage& passage = ray.Passages[i];
      if (!(passage.Begin < passage.End) || middle < passage.Begin || middle > passage.End)
      {
        continue;
      }
      const vtkGodRaysGrid& grid = this->Grids[i];
      const Place place(grid, passage.Place + middle * passage.Steps);
      const double phase =
        grid.Scale * vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, air.Cosine);
      for (int c = 0; c < colours; ++c)
      {
        const double value = place.Read(grid.Extinction, grid.Bands, grid.Bands == 1 ? 0 : c);
        extinction[c] += grid.Scale * value;
        scattered[c] += phase *
          (grid.ScatteringBands == 0 ? grid.Albedo[c] * value
                                     : place.Read(grid.Scattering, grid.ScatteringBands,
                                         grid.ScatteringBands == 1 ? 0 : c));
      }
    }
    float way[3] = { 0.0f, 0.0f, 0.0f };
    const Vec3 sunlit = this->Shadows.GetMean(
      ray.Origin, ray.Along, from, to, 2.0 * (end - begin) / cells, next.Edge);
    const bool isLit = air.Visible && sunlit != Vec3(0.0);
    if (isLit)
    {
      this->AddLightDepth(position, way);
    }
    const double comes = air.Strength *
      (this->Directional ? step : vtkGodRays::PointAirlight(lit.Foot, lit.Distance, from, to));
    for (int c = 0; c < colours; ++c)
    {
      const double thick = step * extinction[c];
      if (isLit)
      {
        // Of the step: the mean of what is left on its way to the eye.
        const double arrives = std::exp(-depth[c] - way[c]) * vtkGodRays::MeanExponential(thick);
        sum[c] += comes * sunlit[c] * air.Left[c] *
          (scattered[c] * arrives + air.Scattered[c] * (arrives - 1.0));
      }
      depth[c] += thick;
    }
    from = to;
  }
  if (this->Grey)
  {
    depth.y = depth.z = depth.x;
  }
  front = next;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
// What data change of the medium's light in a part of the ray that is outside of them.
void vtkGodRaysGridSight::Cross(
  const Ray& ray, double begin, double end, const Vec3& depth, Vec3& sum, std::size_t& steps) const
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
  const bool dims = depth != Vec3(0.0);
  // Two tell what is even, but not what a planet's shadow is in.
  const int fewest = ray.Lit.PlanetRadius > 0.0 ? FarParts / 2 : 2;
  if (!(dark.x < dark.y))
  {
    dark = Vec2(end);
  }
  if (dims)
  {
    this->CrossPart(ray, begin, dark.x, fewest, finest, depth, sum, steps);
  }
  this->CrossPart(ray, dark.x, dark.y, FarParts / 2, finest, depth, sum, steps);
  if (dims)
  {
    this->CrossPart(ray, dark.y, end, fewest, finest, depth, sum, steps);
  }
}

//------------------------------------------------------------------------------
// In so many parts at first, which are halved where what is changed is not linear.
void vtkGodRaysGridSight::CrossPart(const Ray& ray, double begin, double end, int parts,
  double finest, const Vec3& depth, Vec3& sum, std::size_t& steps) const
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
    ++steps;
    float way[3] = { 0.0f, 0.0f, 0.0f };
    this->AddLightDepth(ray.Origin + node.S * ray.Along, way);
    if (depth + Vec3(way[0], way[1], way[2]) == Vec3(0.0))
    {
      return node; // nothing is changed
    }
    const Air air = this->GetAir(ray, node.S);
    for (int c = 0; c < 3 && air.Visible; ++c)
    {
      node.Value[c] =
        air.Strength / air.Square * air.Left[c] * air.Scattered[c] * std::expm1(-depth[c] - way[c]);
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
        sum += length * sunlit * value;
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

//------------------------------------------------------------------------------
vtkGodRaysGridSight::Result vtkGodRaysGridSight::Evaluate(double x, double y, double depth)
{
  Ray ray;
  const Vec3 offset = x * this->Axes[0] + y * this->Axes[1];
  const Vec3 way = this->Parallel ? this->Axes[2] : this->Axes[2] + offset;
  const double perDepth = vtkGodRays::length(way);
  ray.Origin = this->Position + (this->Parallel ? offset : Vec3(0.0));
  ray.Along = way / perDepth;
  const Vec3 to = this->Directional ? this->Light : this->Light - ray.Origin;
  ray.Foot = vtkGodRays::dot(to, ray.Along);
  double end = perDepth * std::min(depth, this->Medium.FarLimit);
  const auto start = [&](const Vec3& place, const Vec3& toward)
  {
    return vtkGodRays::MediumStart(this->Medium.PlanetRadius, this->Medium.EyeHeight, this->Upwards,
      place - this->Position, toward);
  };
  const Vec2 begin = start(ray.Origin, ray.Along);
  ray.Lit = { this->Directional ? 1 : 0, ray.Foot, 0.0, begin.x, begin.y,
    this->Directional ? start(ray.Origin, this->Light).y : start(this->Light, this->Light).x,
    this->Medium.PlanetRadius, vtkGodRays::dot(this->SpotAxis, ray.Origin - this->Light),
    vtkGodRays::dot(this->SpotAxis, ray.Along), {} };
  this->Spot.SetShape(ray.Lit);
  end = vtkGodRays::MediumEnd(ray.Lit, end);
  if (!this->Directional)
  {
    ray.Lit.Distance = vtkGodRays::PointLightHeight(
      ray.Foot, vtkGodRays::length(to - ray.Foot * ray.Along), 0.0, end);
  }
  double first = end;
  double last = 0.0;
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const vtkGodRaysGrid& grid = this->Grids[i];
    Passage& passage = ray.Passages[i];
    passage = { grid.GetPlace(ray.Origin), grid.GetSteps(ray.Along), 0.0, end, 0.0 };
    const Vec3 size = vtkGodRays::abs(passage.Steps);
    passage.Speed = std::max({ size.x, size.y, size.z, 1e-30 });
    if (!grid.Clip(passage.Place, passage.Steps, passage.Begin, passage.End))
    {
      passage.Begin = passage.End = 0.0;
      continue;
    }
    first = std::min(first, passage.Begin);
    last = std::max(last, passage.End);
  }
  std::size_t steps = 0;
  Vec3 sum(0.0);
  Vec3 thick(0.0);
  if (this->Haze)
  {
    this->Cross(ray, 0.0, first, thick, sum, steps);
  }
  if (last > first)
  {
    this->March(ray, first, last, thick, sum, steps);
  }
  if (this->Haze)
  {
    this->Cross(ray, std::max(first, last), end, thick, sum, steps);
  }
  this->Rays.fetch_add(1, std::memory_order_relaxed);
  this->Steps.fetch_add(steps, std::memory_order_relaxed);
  if (this->Grey)
  {
    sum = Vec3(sum.x);
  }
  return { sum * this->LightColor, vtkGodRays::exp(-thick) };
}
