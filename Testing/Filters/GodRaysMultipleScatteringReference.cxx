// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GodRaysMultipleScatteringReference.h"

#include "vtkGodRaysTriangleTree.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using vtkGodRays::Vec3;
using Scene = vtkGodRaysTransportScene;
using Random = std::mt19937;

constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Hit
{
  double Distance = Infinity;
  Vec3 Normal = Vec3(0.0); // towards where the ray comes from
  double Albedo = 0.0;
  bool IsFace = true; // of the box, by which light leaves if the albedo is 0
};

double Draw(Random& random) // in (0, 1)
{
  return (random() + 0.5) / 4294967296.0;
}

Vec3 GetAcross(const Vec3& v)
{
  const Vec3 across =
    vtkGodRays::cross(v, std::abs(v.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0));
  return across / vtkGodRays::length(across);
}

// Draws a direction about an axis, by the cosine of the angle to it.
Vec3 Turn(const Vec3& axis, double cosine, Random& random)
{
  const double angle = 2.0 * vtkMath::Pi() * Draw(random);
  const Vec3 x = GetAcross(axis);
  const Vec3 turned = cosine * axis +
    std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) *
      (std::cos(angle) * x + std::sin(angle) * vtkGodRays::cross(axis, x));
  return turned / vtkGodRays::length(turned);
}

// Draws the cosine of a scattering angle; a factor 1 + c^2 by rejection.
double DrawCosine(const Scene::PhaseMix& mix, Random& random)
{
  const vtkGodRays::PhaseFunction& phase = Draw(random) < mix.SecondWeight ? mix.Second : mix.First;
  const double g = phase.Asymmetry;
  const bool rejects =
    phase.Kind == vtkGodRays::PHASE_RAYLEIGH || phase.Kind == vtkGodRays::PHASE_CORNETTE_SHANKS;
  for (;;)
  {
    double cosine = 2.0 * Draw(random) - 1.0;
    if (phase.Kind == vtkGodRays::PHASE_SCHLICK)
    {
      const double k = vtkGodRays::SchlickParameter(g);
      cosine = (cosine + k) / (1.0 + k * cosine);
    }
    else if (vtkGodRays::PhaseHasAsymmetry(phase.Kind) && std::abs(g) > 1e-4)
    {
      const double ratio = (1.0 - g * g) / (1.0 + g * cosine);
      cosine = (1.0 + g * g - ratio * ratio) / (2.0 * g);
    }
    if (!rejects || 2.0 * Draw(random) < 1.0 + cosine * cosine)
    {
      return glm::clamp(cosine, -1.0, 1.0);
    }
  }
}
}

class GodRaysMultipleScatteringReference::vtkInternals
{
public:
  Scene Input;
  vtkGodRays::TriangleTree Occluders{ nullptr };
  double Albedo = 0.0;
  Vec3 Majorant = Vec3(0.0); // of extinction [1/scene unit]
  double Size = 1.0;         // of the box [scene units]

  // What a colour of the media is at a place.
  struct Point
  {
    double Extinction = 0.0;
    double All = 0.0;                            // scattering
    double Scattering[Scene::MaximumComponents]; // of each component
  };
  Point GetPoint(const Vec3& place, int color) const;
  Hit Cast(const Vec3& origin, const Vec3& direction) const;
  double GetLight(const Vec3& place, int color, Vec3& towards, Random& random) const;
  void Follow(
    Vec3 place, Vec3 direction, int color, Random& random, double& single, double& orders) const;
};

GodRaysMultipleScatteringReference::vtkInternals::Point
GodRaysMultipleScatteringReference::vtkInternals::GetPoint(const Vec3& place, int color) const
{
  Point point;
  for (int k = 0; k < this->Input.GetNumberOfComponents(); ++k)
  {
    const Scene::Point own = this->Input.Sample(k, place);
    point.Extinction += own.Extinction[color];
    point.Scattering[k] = own.Scattering[color];
    point.All += own.Scattering[color];
  }
  return point;
}

// Finds the first surface of a ray that starts in the box: a triangle, or the box's face.
Hit GodRaysMultipleScatteringReference::vtkInternals::Cast(
  const Vec3& origin, const Vec3& direction) const
{
  Hit hit;
  double begin = 0.0;
  const int face = this->Input.Clip(origin, direction, begin, hit.Distance);
  hit.Distance = std::max(hit.Distance, 0.0);
  hit.Albedo = face >= 0 ? this->Input.FaceAlbedo[face] : 0.0;
  hit.Normal[face / 2] = face % 2 ? -1.0 : 1.0;
  const auto skip = [&](const Vec3& centre, const Vec3& half)
  {
    const Vec3 inverse = 1.0 / (direction + Vec3(1e-300));
    const Vec3 middle = (centre - origin) * inverse;
    const Vec3 reach = (half + 1e-9 * this->Size) * vtkGodRays::abs(inverse);
    const Vec3 low = middle - reach;
    const Vec3 high = middle + reach;
    return std::max({ low.x, low.y, low.z, 0.0 }) >
      std::min({ high.x, high.y, high.z, hit.Distance });
  };
  const auto visit = [&](const vtkGodRays::Triangle& triangle) // as Moeller and Trumbore
  {
    const Vec3 a = triangle[1] - triangle[0];
    const Vec3 b = triangle[2] - triangle[0];
    const Vec3 p = vtkGodRays::cross(direction, b);
    const double determinant = vtkGodRays::dot(a, p);
    const Vec3 from = origin - triangle[0];
    const Vec3 q = vtkGodRays::cross(from, a);
    const double u = vtkGodRays::dot(from, p) / determinant;
    const double v = vtkGodRays::dot(direction, q) / determinant;
    const double distance = vtkGodRays::dot(b, q) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance >= 0.0 && distance < hit.Distance)
    {
      const Vec3 normal = vtkGodRays::cross(a, b) / vtkGodRays::length(vtkGodRays::cross(a, b));
      hit = { distance, vtkGodRays::dot(normal, direction) > 0.0 ? -normal : normal, this->Albedo,
        false };
    }
  };
  const Vec3 across = GetAcross(direction);
  this->Occluders.Find(across, vtkGodRays::dot(across, origin), skip, visit);
  return hit;
}

// Returns the irradiance of a random light, times how many there are, that arrives at a place.
double GodRaysMultipleScatteringReference::vtkInternals::GetLight(
  const Vec3& place, int color, Vec3& towards, Random& random) const
{
  const std::size_t count = this->Input.Lights.size();
  const Scene::Light& light = this->Input.Lights[random() % count];
  double distance;
  const double irradiance = this->Input.GetIrradiance(light, place, towards, distance)[color];
  const Hit hit = this->Cast(place, towards);
  if (irradiance <= 0.0 || (!hit.IsFace && hit.Distance < distance))
  {
    return 0.0;
  }
  Vec3 depth(0.0);
  for (int k = 0; k < this->Input.Medium.NumberOfComponents; ++k)
  {
    depth += this->Input.GetDepth(k, light, place, towards, distance);
  }
  for (const vtkGodRaysGrid& grid : this->Input.Grids)
  {
    grid.AddDepth(
      grid.GetPlace(place), grid.GetSteps(towards), 0.0, std::min(hit.Distance, distance), depth);
  }
  return static_cast<double>(count) * irradiance * std::exp(-depth[color]);
}

// Follows a path on from its first event.
void GodRaysMultipleScatteringReference::vtkInternals::Follow(
  Vec3 place, Vec3 direction, int color, Random& random, double& single, double& orders) const
{
  single = orders = 0.0;
  double weight = 1.0;
  Point medium = this->GetPoint(place, color);
  Hit surface;
  bool isInMedium = true;
  for (bool isFirst = true;; isFirst = false)
  {
    Vec3 towards;
    const double light = this->GetLight(place, color, towards, random);
    if (isInMedium)
    {
      const double incoming = weight * light / std::max(medium.Extinction, 1e-300);
      weight *= std::min(medium.All / std::max(medium.Extinction, 1e-300), 1.0);
      int chosen = 0;
      double left = medium.All * Draw(random);
      for (int k = 0; k < this->Input.GetNumberOfComponents(); ++k)
      {
        (isFirst ? single : orders) += incoming * medium.Scattering[k] *
          this->Input.GetPhase(k).Get(vtkGodRays::dot(direction, towards));
        chosen = left >= 0.0 ? k : chosen;
        left -= medium.Scattering[k];
      }
      direction = Turn(direction, DrawCosine(this->Input.GetPhase(chosen), random), random);
    }
    else
    {
      weight *= surface.Albedo;
      orders +=
        weight * light * std::max(vtkGodRays::dot(surface.Normal, towards), 0.0) / vtkMath::Pi();
      direction = Turn(surface.Normal, std::sqrt(Draw(random)), random);
    }
    if (weight < 0.2) // Russian roulette
    {
      if (Draw(random) >= 2.0 * weight)
      {
        return;
      }
      weight = 0.5;
    }

    surface = this->Cast(place, direction);
    double distance = 0.0;
    isInMedium = false;
    while (!isInMedium && distance < surface.Distance)
    {
      distance -= std::log(Draw(random)) / std::max(this->Majorant[color], 1e-300);
      medium = this->GetPoint(place + distance * direction, color);
      isInMedium =
        distance < surface.Distance && Draw(random) * this->Majorant[color] < medium.Extinction;
    }
    if (!isInMedium && !(surface.Albedo > 0.0))
    {
      return;
    }
    place += isInMedium ? distance * direction
                        : surface.Distance * direction + 1e-7 * this->Size * surface.Normal;
  }
}

GodRaysMultipleScatteringReference::GodRaysMultipleScatteringReference()
  : Internals(std::make_unique<vtkInternals>())
{
}
GodRaysMultipleScatteringReference::~GodRaysMultipleScatteringReference() = default;

void GodRaysMultipleScatteringReference::SetScene(
  const vtkGodRaysTransportScene& scene, vtkPolyData* occluders, double albedo)
{
  vtkInternals& in = *this->Internals;
  in.Input = scene;
  in.Occluders = vtkGodRays::TriangleTree(occluders);
  in.Albedo = albedo;
  const Vec3 size = scene.High - scene.Low;
  in.Size = std::max({ size.x, size.y, size.z });
  in.Majorant = Vec3(0.0);
  for (int k = 0; k < scene.Medium.NumberOfComponents; ++k)
  {
    Vec3 largest(0.0);
    for (int corner = 0; corner < 8; ++corner) // in one of which an exponential is densest
    {
      const Vec3 place =
        glm::mix(scene.Low, scene.High, Vec3(corner & 1, corner >> 1 & 1, corner >> 2));
      largest = vtkGodRays::max(largest, scene.Sample(k, place).Extinction);
    }
    in.Majorant += largest;
  }
  for (const vtkGodRaysGrid& grid : scene.Grids)
  {
    Vec3 largest(0.0);
    for (int i = 0; i < grid.Points[0] * grid.Points[1] * grid.Points[2]; ++i)
    {
      const Vec3 place(i % grid.Points[0], i / grid.Points[0] % grid.Points[1],
        i / (grid.Points[0] * grid.Points[1]));
      largest = vtkGodRays::max(largest, grid.Sample(place).Extinction);
    }
    in.Majorant += largest;
  }
  in.Majorant *= 1.0 + 1e-9;
}

GodRaysMultipleScatteringReference::Result GodRaysMultipleScatteringReference::Evaluate(
  const Vec3& origin, const Vec3& direction, int color, int paths, unsigned int seed) const
{
  constexpr int parts = 1024;
  const vtkInternals& in = *this->Internals;
  Result result;
  double begin = 0.0;
  double end = Infinity;
  if (in.Input.Clip(origin, direction, begin, end) < 0 || in.Input.Lights.empty())
  {
    return result;
  }
  const Vec3 start = origin + begin * direction;
  const double length = std::min(in.Cast(start, direction).Distance, end - begin);
  std::array<double, parts + 1> depths = { 0.0 };
  for (int i = 0; i < parts; ++i)
  {
    const Vec3 place = start + (i + 0.5) / parts * length * direction;
    depths[i + 1] = depths[i] + length / parts * in.GetPoint(place, color).Extinction;
  }
  const double scattered = -std::expm1(-depths.back());
  Random random(seed);
  double squares = 0.0;
  for (int path = 0; path < paths && scattered > 0.0; ++path)
  {
    const double depth = -std::log1p(-(path + Draw(random)) / paths * scattered);
    const auto next = std::upper_bound(depths.begin() + 1, depths.end() - 1, depth);
    const double part = (depth - next[-1]) / std::max(next[0] - next[-1], 1e-300);
    const double place = (next - depths.begin() - 1 + glm::clamp(part, 0.0, 1.0)) / parts * length;
    double single;
    double orders;
    in.Follow(start + place * direction, direction, color, random, single, orders);
    result.Single += scattered * single / paths;
    result.Orders += scattered * orders / paths;
    squares += scattered * scattered * orders * orders / paths;
  }
  result.Variance = std::max(squares - result.Orders * result.Orders, 0.0) / std::max(paths - 1, 1);
  return result;
}
