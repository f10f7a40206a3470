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

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}
}

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

  this->WidestPiece = std::clamp(0.3 * (1.0 - asymmetry), 0.01, 0.15);

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

vtkGodRaysGridSight::Result vtkGodRaysGridSight::Evaluate(double x, double y, double depth)
{
  Ray ray;
  ray.X = x;
  ray.Y = y;
  const Vec3 offset = x * this->Axes[0] + y * this->Axes[1];
  const Vec3 toward = this->Parallel ? this->Axes[2] : this->Axes[2] + offset;
  const double perDepth = vtkGodRays::length(toward);
  ray.PerDepth = perDepth;
  ray.Origin = this->Position + (this->Parallel ? offset : Vec3(0.0));
  ray.Along = toward / perDepth;
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
    vtkGodRays::dot(this->SpotAxis, ray.Along), {}, 0 };
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
    passage = { grid.GetPlace(ray.Origin), grid.GetSteps(ray.Along), 0.0, end, 0.0, 0.0 };
    const Vec3 size = vtkGodRays::abs(passage.Steps);
    passage.Speed = std::max({ size.x, size.y, size.z, 1e-30 });
    if (!grid.Clip(passage.Place, passage.Steps, passage.Begin, passage.End))
    {
      passage.Begin = passage.End = 0.0;
      continue;
    }
    if (this->Directional)
    {
      passage.Phase = vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, ray.Foot);
    }
    first = std::min(first, passage.Begin);
    last = std::max(last, passage.End);
  }
  Way way;
  if (this->Haze)
  {
    this->Cross(ray, 0.0, first, way);
  }
  this->AddDiffuseAir(ray, 0.0, first, way.Scaled, way);
  if (last > first)
  {
    this->March(ray, first, last, way);
  }
  if (this->Haze)
  {
    this->Cross(ray, std::max(first, last), end, way);
  }
  this->AddDiffuseAir(ray, std::max(first, last), end, way.Scaled, way);
  this->Rays.fetch_add(1, std::memory_order_relaxed);
  this->Steps.fetch_add(way.Steps, std::memory_order_relaxed);
  if (this->Grey)
  {
    way.Light = Vec3(way.Light.x);
  }
  return { way.Light * this->LightColor + way.Diffuse, vtkGodRays::exp(-way.Depth) };
}
