// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridMarch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr int AirParts = 128; // of a segment of air, at most
constexpr int MostNodes = 24; // that wait for the parts before them
constexpr double Bend = 1.5;  // of light in a part, at most [tolerance, times the brightest light]
constexpr double Dimming = 2.0; // that is not linear in a part, at most [tolerance]

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

double GetLargest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}
}

void vtkGodRaysGridMarch::SetUp(const vtkGodRaysSingleScattering::Parameters& parameters)
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
  const bool hasShadows = this->Shadows && this->Shadows->Levels > 0;
  this->Grey = this->Medium.IsGrey() &&
    !(hasShadows && this->Shadows->NumberOfLayers > 0 && this->Shadows->Colored);
  double asymmetry = 0.0; // the largest: a peak is about 1 less it wide
  for (int k = 0; k < this->Medium.NumberOfComponents; ++k)
  {
    const vtkGodRaysMedium::Component& component = this->Medium.Components[k];
    asymmetry = std::max({ asymmetry, std::abs(component.Asymmetry),
      component.SecondWeight > 0.0 ? std::abs(component.SecondAsymmetry) : 0.0 });
  }
  for (const vtkGodRaysGrid& grid : this->Grids)
  {
    asymmetry = std::max(asymmetry, std::abs(grid.Asymmetry));
    this->Grey = this->Grey && grid.Bands == 1 && grid.ScatteringBands <= 1 &&
      grid.Albedo[0] == grid.Albedo[1] && grid.Albedo[1] == grid.Albedo[2];
  }
  this->WidestPart = std::clamp(1.2 * (1.0 - asymmetry), 0.04, 0.6);
  if (hasShadows)
  {
    const Vec3 offset = this->Directional ? this->Light : this->Light - this->Position;
    const double light[3] = { vtkGodRays::dot(offset, this->Axes[0]),
      vtkGodRays::dot(offset, this->Axes[1]), vtkGodRays::dot(offset, this->Axes[2]) };
    this->Pyramid.Build(*this->Shadows, light);
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
      this->Lights[i].Build(this->Grids[i], this->AllBlocks[i], this->Light, this->Directional);
    }
    std::copy_n(light, 5, this->LastLight);
  }
}

vtkGodRaysGridMarch::Result vtkGodRaysGridMarch::Evaluate(double x, double y, double depth)
{
  Ray ray;
  ray.X = x;
  ray.Y = y;
  const Vec3 offset = x * this->Axes[0] + y * this->Axes[1];
  const Vec3 toward = this->Parallel ? this->Axes[2] : this->Axes[2] + offset;
  ray.PerDepth = vtkGodRays::length(toward);
  ray.Origin = this->Position + (this->Parallel ? offset : Vec3(0.0));
  ray.Along = toward / ray.PerDepth;
  const Vec3 to = this->Directional ? this->Light : this->Light - ray.Origin;
  const double foot = vtkGodRays::dot(to, ray.Along);
  const auto start = [&](const Vec3& place, const Vec3& direction)
  {
    return vtkGodRays::MediumStart(this->Medium.PlanetRadius, this->Medium.EyeHeight, this->Upwards,
      place - this->Position, direction);
  };
  const Vec2 begin = start(ray.Origin, ray.Along);
  ray.Lit = { this->Directional ? 1 : 0, foot, 0.0, begin.x, begin.y,
    this->Directional ? start(ray.Origin, this->Light).y : start(this->Light, this->Light).x,
    this->Medium.PlanetRadius, vtkGodRays::dot(this->SpotAxis, ray.Origin - this->Light),
    vtkGodRays::dot(this->SpotAxis, ray.Along), {}, 0 };
  this->Spot.SetShape(ray.Lit);
  const double end =
    vtkGodRays::MediumEnd(ray.Lit, ray.PerDepth * std::min(depth, this->Medium.FarLimit));
  if (!this->Directional)
  {
    ray.Lit.Distance =
      vtkGodRays::PointLightHeight(foot, vtkGodRays::length(to - foot * ray.Along), 0.0, end);
  }
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const vtkGodRaysGrid& grid = this->Grids[i];
    Passage& passage = ray.Passages[i];
    passage = { grid.GetPlace(ray.Origin), grid.GetSteps(ray.Along), 0.0, end, 0.0, 0.0 };
    passage.Phase =
      this->Directional ? vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, foot) : 0.0;
    passage.Speed = std::max(GetLargest(passage.Steps), 1e-30);
    if (!grid.Clip(passage.Place, passage.Steps, passage.Begin, passage.End))
    {
      passage.Begin = passage.End = Infinity;
    }
  }
  if (this->Shadows && this->Shadows->Levels > 0)
  {
    const double origin[3] = { this->Parallel ? x : 0.0, this->Parallel ? y : 0.0, 0.0 };
    const double direction[3] = { this->Parallel ? 0.0 : x / ray.PerDepth,
      this->Parallel ? 0.0 : y / ray.PerDepth, 1.0 / ray.PerDepth };
    this->Pyramid.Walk(origin, direction, end, ray.Stretches);
  }
  Sums sums;
  this->March(ray, end, sums);
  this->Rays.fetch_add(1, std::memory_order_relaxed);
  this->Steps.fetch_add(sums.Steps, std::memory_order_relaxed);
  return { sums.Light * this->LightColor + sums.Diffuse, vtkGodRays::exp(-sums.Depth) };
}

// Returns the part of a ray where the light's way may go through a grid.
vtkGodRays::Vec2 vtkGodRaysGridMarch::FindShadow(const Ray& ray, double end) const
{
  constexpr double margin = 2.0; // points: depths lie between nodes
  Vec2 shadow(end, 0.0);
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const vtkGodRaysGrid& grid = this->Grids[i];
    const Vec3 light = this->Directional ? grid.GetSteps(this->Light) : grid.GetPlace(this->Light);
    const Vec2 own = grid.FindShadow(
      ray.Passages[i].Place, ray.Passages[i].Steps, end, light, this->Directional, margin);
    if (own.x < own.y)
    {
      shadow = Vec2(std::min(shadow.x, own.x), std::max(shadow.y, own.y));
    }
  }
  return shadow;
}

void vtkGodRaysGridMarch::March(const Ray& ray, double end, Sums& sums) const
{
  const int count = static_cast<int>(this->Grids.size());
  double cell = end; // the shortest one
  for (int i = 0; i < count; ++i)
  {
    cell = std::min(cell, 1.0 / ray.Passages[i].Speed);
  }
  const Vec2 cone = vtkGodRays::SpotPart(ray.Lit, std::max(end, 0.0));
  const Vec2 shadow = this->Haze ? this->FindShadow(ray, end) : Vec2(0.0);
  Segment segment;
  Node node; // at the end of the last segment
  bool isKnown = false;
  bool wasLit = false;
  std::uint32_t inside = 0;
  for (double s = 0.0; s < end; s = segment.End)
  {
    const double ahead = s + 1e-9 * (cell + s);
    segment = { s, end, ahead >= cone.x && ahead < cone.y, false, 0, 1, 0.0 };
    for (const double edge : { cone.x, cone.y, shadow.x, shadow.y })
    {
      segment.End = edge > ahead ? std::min(segment.End, edge) : segment.End;
    }
    const double left = std::exp(-std::min({ sums.Depth.x, sums.Depth.y, sums.Depth.z }));
    double fastest = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const Passage& passage = ray.Passages[i];
      if (ahead < passage.Begin || ahead > passage.End)
      {
        segment.End = ahead < passage.Begin ? std::min(segment.End, passage.Begin) : segment.End;
        continue;
      }
      segment.End = std::min(segment.End, passage.End);
      segment.Inside |= std::uint32_t(1) << i;
      fastest = std::max(fastest, passage.Speed);
    }
    // Blocks are joined while they hold data, or none, and one part is enough for all of them.
    double parts = 0.0;
    double block = ahead;
    for (bool isLast = segment.Inside == 0; !isLast;)
    {
      double exit = segment.End;
      double density = 0.0; // of parts [1/scene unit]
      bool holdsData = false;
      for (int i = 0; i < count; ++i)
      {
        if ((segment.Inside >> i & 1) != 0)
        {
          const Passage& passage = ray.Passages[i];
          double own;
          const Vec2 range = this->AllBlocks[i].Get(
            passage.Place + block * passage.Steps, passage.Place, passage.Steps, block, own);
          exit = std::min(exit, std::max(own, block));
          // A quarter of the parts with which the midpoint rule would keep the tolerance, of two places each.
          const double length = vtkGodRaysGridBlocks::BlockSize / passage.Speed;
          const double change =
            (range.y - range.x + 0.5 * range.y * range.y * length) * length * left;
          density = std::max(density, 0.12 * std::sqrt(change / this->Tolerance) / length);
          holdsData = holdsData || range.y > 0.0;
        }
      }
      const double more = density * (exit - block);
      if (block > ahead && (holdsData != segment.HasData || parts + more > 1.0))
      {
        segment.End = block;
        break;
      }
      segment.HasData = holdsData;
      parts += more;
      isLast = exit >= segment.End;
      block = exit + 1e-9 * (cell + exit);
    }
    const bool isShadowed = ahead >= shadow.x && ahead < shadow.y;
    const double length = segment.End - s;
    if (segment.HasData)
    {
      segment.Finest = 0.5 / fastest;
      segment.Parts =
        static_cast<int>(std::ceil(std::min(parts, length / (2.0 * segment.Finest)) - 1e-6));
    }
    else
    {
      segment.Finest = std::max(4.0 * cell, length / AirParts);
      segment.Parts = segment.Inside != 0 ? 1
        : isShadowed || ray.Lit.PlanetRadius > 0.0
        ? static_cast<int>(std::min(8.0, length / segment.Finest))
        : 2;
    }
    const Vec3 before = sums.Scaled;
    isKnown = isKnown && segment.Inside == inside && segment.IsLit == wasLit;
    const bool changesAir = this->Haze && segment.IsLit && (isShadowed || sums.Depth != Vec3(0.0));
    if (segment.HasData || changesAir)
    {
      node = isKnown ? node : this->Evaluate(ray, segment, 0.0);
      node.T = 0.0;
      this->Integrate(ray, segment, node, sums);
    }
    isKnown = segment.HasData || changesAir;
    wasLit = segment.IsLit;
    inside = segment.Inside;
    this->AddDiffuseAir(ray, s, segment.End, before, sums);
    if (!this->Haze && left < 0.02 * this->Tolerance)
    {
      return;
    }
  }
}

// From the node at the begin of a segment, which becomes that at its end.
void vtkGodRaysGridMarch::Integrate(
  const Ray& ray, const Segment& segment, Node& from, Sums& sums) const
{
  const vtkGodRays::LitRay& lit = ray.Lit;
  // Light from a lamp falls with the square of its distance; over the angle at the lamp it does not.
  const double whole = this->Directional
    ? segment.End - segment.Begin
    : vtkGodRays::PointAirlight(lit.Foot, lit.Distance, segment.Begin, segment.End);
  const double angle = this->Directional ? 0.0 : lit.Distance * whole;
  const int first = std::max({ segment.Parts, static_cast<int>(angle / this->WidestPart), 1 });
  const double accepted =
    this->Brightest > 0.0 ? Bend * this->Tolerance * this->Brightest : Infinity;
  Vec3 left = this->GetTransmittance(sums.Depth);
  Node ahead[MostNodes]; // ends of parts, the nearest one last
  for (int k = 1; k <= first; ++k)
  {
    int count = 0;
    ahead[count++] = this->Evaluate(ray, segment, static_cast<double>(k) / first);
    while (count > 0)
    {
      const Node to = ahead[count - 1];
      const Node middle = this->Evaluate(ray, segment, 0.5 * (from.T + to.T));
      ++sums.Steps;
      const double length = to.S - from.S;
      const double part = length > 0.0 ? (middle.S - from.S) / length : 0.5;
      // Extinction is a parabola through the three, or straight between them where a lamp sets them apart.
      const Vec3 bend = (to.Extinction - middle.Extinction) / (1.0 - part) -
        (middle.Extinction - from.Extinction) / part;
      const bool isBalanced = part > 0.3 && part < 0.7;
      const Vec3 cubic = isBalanced ? bend / 6.0 : Vec3(0.0);
      const Vec3 half =
        0.5 * part * (from.Extinction + middle.Extinction) - part * part * part * cubic;
      const Vec3 rest = 0.5 * (1.0 - part) * (middle.Extinction + to.Extinction) -
        (1.0 - part) * (1.0 - part) * (1.0 - part) * cubic;
      const Vec3 thick = length * (half + rest);
      const Vec3 after = this->GetTransmittance(sums.Depth + thick);
      const Vec3 lights[3] = { from.Full * left - from.Air,
        middle.Full * this->GetTransmittance(sums.Depth + length * half) - middle.Air,
        to.Full * after - to.Air };
      bool isEven = true;
      const Vec3 visible =
        segment.IsLit ? this->GetVisibility(ray, from.S, to.S, isEven) : Vec3(0.0);
      const double weight = whole * (to.T - from.T);
      const double bent =
        GetLargest(visible * (0.5 * (lights[0] + lights[2]) - lights[1])) * weight;
      const double jump = isEven ? 0.0 : GetLargest(lights[2] - lights[0]) * weight;
      const double dims = GetLargest(part * (1.0 - part) * bend) * length * GetLargest(left);
      const bool canHalve = count < MostNodes &&
        (length > segment.Finest || (to.T - from.T) * angle > 0.1 * this->WidestPart);
      if (canHalve && (bent > accepted || jump > accepted || dims > Dimming * this->Tolerance))
      {
        ahead[count++] = middle;
        continue;
      }
      sums.Light += weight / 6.0 * visible * (lights[0] + 4.0 * lights[1] + lights[2]);
      sums.Depth += thick;
      left = after;
      if (this->Diffuse && segment.HasData)
      {
        this->AddDiffuse(ray, middle.S, length,
          (from.Extinction + 4.0 * middle.Extinction + to.Extinction) / 6.0,
          (from.Scattering + 4.0 * middle.Scattering + to.Scattering) / 6.0, sums);
      }
      from = to;
      --count;
    }
  }
  sums.Steps += first;
}

vtkGodRaysGridMarch::Node vtkGodRaysGridMarch::Evaluate(
  const Ray& ray, const Segment& segment, double t) const
{
  Node node;
  node.T = t;
  node.S = vtkGodRays::MediumPlace(ray.Lit, segment.Begin, segment.End, t);
  const double beyond = node.S - ray.Lit.Foot;
  const double r = std::max(std::hypot(ray.Lit.Distance, beyond), 1e-30);
  const double cosine = this->Directional ? ray.Lit.Foot : -beyond / r;
  Vec3 scattered(0.0); // by data, towards the eye
  for (std::size_t i = 0; i < this->Grids.size() && segment.HasData; ++i)
  {
    if ((segment.Inside >> i & 1) != 0)
    {
      const vtkGodRaysGrid& grid = this->Grids[i];
      const Passage& passage = ray.Passages[i];
      const vtkGodRaysGrid::Point point = grid.Sample(passage.Place + node.S * passage.Steps);
      node.Extinction += point.Extinction;
      node.Scattering += point.Scattering;
      scattered += point.Scattering *
        (this->Directional ? passage.Phase
                           : vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, cosine));
    }
  }
  if (segment.IsLit)
  {
    this->AddLight(ray, cosine, r, scattered, node);
  }
  return node;
}

// Adds the light that comes r from a lamp, or of a directional light.
void vtkGodRaysGridMarch::AddLight(
  const Ray& ray, double cosine, double r, const Vec3& scattered, Node& node) const
{
  const vtkGodRays::LitRay& lit = ray.Lit;
  const int colours = this->Grey ? 1 : 3;
  Vec3 air(0.0);      // scattered by it
  Vec3 airDepth(0.0); // of the light's way and of that to the eye
  if (this->Haze)
  {
    const double height = vtkGodRays::MediumHeight(lit.PlanetRadius, lit.Height, lit.Slope, node.S);
    const double slope = vtkGodRays::LightSlope(lit, height, node.S, r);
    if (vtkGodRays::IsInPlanetShadow(lit, height, slope, r))
    {
      return;
    }
    const bool isAbove = !this->Directional || lit.PlanetRadius > 0.0 || slope > 0.0;
    for (int c = 0; c < colours; ++c)
    {
      for (const vtkGodRays::MediumComponent& part : this->Components[c])
      {
        if (part.Extinction > 0.0)
        {
          airDepth[c] += vtkGodRays::LightDepth(part, lit, height, slope, r) +
            part.Extinction *
              vtkGodRays::MediumDepth(
                lit.PlanetRadius, lit.Height, lit.Slope, part.ScaleHeight, node.S);
          air[c] += vtkGodRays::ScatteredPart(part, height, cosine);
          // A plane hides what is below its horizon.
          airDepth[c] = isAbove || part.ScaleHeight <= 0.0 ? airDepth[c] : Infinity;
        }
      }
    }
  }
  float depths[3] = { 0.0f, 0.0f, 0.0f }; // of data
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const vtkGodRaysGrid& grid = this->Grids[i];
    float own[3] = { 0.0f, 0.0f, 0.0f };
    this->Lights[i].AddDepth(grid, grid.GetPlace(ray.Origin + node.S * ray.Along), own);
    for (int c = 0; c < 3; ++c)
    {
      depths[c] += own[grid.Bands == 1 ? 0 : c];
    }
  }
  const double strength = this->Directional ? 1.0 : vtkGodRays::SpotFactor(lit, node.S, r);
  for (int c = 0; c < 3; ++c)
  {
    const int band = c < colours ? c : 0;
    const double comes =
      c == band ? strength * std::exp(-airDepth[c]) : 0.0; // others are those of the first
    node.Air[c] = c == band ? comes * air[c] : node.Air.x;
    node.Full[c] = c == band
      ? comes * (air[c] + scattered[c]) * static_cast<double>(std::exp(-depths[c]))
      : node.Full.x;
  }
}

vtkGodRays::Vec3 vtkGodRaysGridMarch::GetTransmittance(const Vec3& depth) const
{
  return this->Grey ? Vec3(std::exp(-depth.x)) : vtkGodRays::exp(-depth);
}

// Returns the mean of what surfaces let through to a part of a ray, and whether it is even there.
vtkGodRays::Vec3 vtkGodRaysGridMarch::GetVisibility(
  const Ray& ray, double begin, double end, bool& isEven) const
{
  Vec3 visible(1.0);
  for (const vtkGodRaysShadowPyramid::Stretch& stretch : ray.Stretches)
  {
    const double first = std::max<double>(stretch.Begin, begin);
    const double last = std::min<double>(stretch.End, end);
    if (last > first)
    {
      isEven = isEven && first == begin && last == end;
      visible -=
        (last - first) / (end - begin) * Vec3(stretch.Dark[0], stretch.Dark[1], stretch.Dark[2]);
    }
  }
  return vtkGodRays::max(visible, Vec3(0.0));
}

// Adds the air's light of two and more scatterings along a part of the ray, behind a scaled depth of data.
void vtkGodRaysGridMarch::AddDiffuseAir(
  const Ray& ray, double begin, double end, const Vec3& before, Sums& sums) const
{
  if (this->DiffuseAir && end > begin)
  {
    const Vec3 left = 0.5 * (vtkGodRays::exp(-before) + vtkGodRays::exp(-sums.Scaled));
    sums.Diffuse += left *
      (this->DiffuseAir->Get(ray.X, ray.Y, end / ray.PerDepth) -
        this->DiffuseAir->Get(ray.X, ray.Y, begin / ray.PerDepth));
  }
}

// Adds the light that data scatter again in a part about a place of the ray.
void vtkGodRaysGridMarch::AddDiffuse(const Ray& ray, double s, double length,
  const Vec3& extinction, const Vec3& scattering, Sums& sums) const
{
  const Vec3 source = this->Diffuse->Sample(ray.Origin + s * ray.Along);
  const vtkGodRays::LitRay& lit = ray.Lit;
  const double forward = this->Diffuse->ForwardPart;
  for (int c = 0; c < 3; ++c)
  {
    double air = 0.0;
    for (int k = 0; k < 2 && this->DiffuseAir; ++k)
    {
      const vtkGodRays::MediumComponent& part = this->Components[c][k];
      air += vtkGodRays::ScaledExtinction(part.Extinction, part.Scattering, forward) *
        vtkGodRays::MediumDepth(lit.PlanetRadius, lit.Height, lit.Slope, part.ScaleHeight, s);
    }
    const double thick =
      length * vtkGodRays::ScaledExtinction(extinction[c], scattering[c], forward);
    sums.Diffuse[c] += source[c] * length * scattering[c] * std::exp(-sums.Scaled[c] - air) *
      vtkGodRays::MeanExponential(thick);
    sums.Scaled[c] += thick;
  }
}
