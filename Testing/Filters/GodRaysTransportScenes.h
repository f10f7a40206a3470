// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysTransportScenes.h
 * @brief   media with light of all orders of scattering, for tests
 *
 * The first are those of the prototype that the method was chosen by; the others were chosen after, before
 * anything of them was computed.
 */

#ifndef GodRaysTransportScenes_h
#define GodRaysTransportScenes_h

#include "GodRaysGridScenes.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMultipleScattering.h"

#include <cstdint>

namespace GodRaysTransportScenes
{
using vtkGodRays::Vec3;
using Scene = vtkGodRaysTransportScene;
using Ray = vtkGodRaysMultipleScattering::Ray;

struct Box
{
  Vec3 Low;
  Vec3 High;
  double Albedo;

  bool Contains(const Vec3& p) const
  {
    return p.x > this->Low.x && p.y > this->Low.y && p.z > this->Low.z && p.x < this->High.x &&
      p.y < this->High.y && p.z < this->High.z;
  }
  // Where a ray enters, at least 0; infinity if it does not.
  double Meet(const Vec3& origin, const Vec3& direction) const
  {
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
    {
      const double inverse = 1.0 / (direction[i] != 0.0 ? direction[i] : 1e-300);
      const double a = (this->Low[i] - origin[i]) * inverse;
      const double b = (this->High[i] - origin[i]) * inverse;
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    return begin < end ? begin : std::numeric_limits<double>::infinity();
  }
};

struct Case
{
  std::string Name;
  Scene Media;
  std::vector<Box> Boxes;
  Vec3 Eye = Vec3(0.0);
  Vec3 Focus = Vec3(0.0);
  double Angle = 40.0; // horizontal [degrees]; 0: parallel
  double Wide = 1.0;   // parallel [scene units]
  double Depth = 1.0;
  double Asymmetry = 0.0;
};
constexpr int Width = 12;
constexpr int Height = 8;

// Occluders for the solver: functions of the boxes. They hold copies.
inline void SetOccluders(Case& each)
{
  const std::vector<Box> boxes = each.Boxes;
  if (boxes.empty())
  {
    return;
  }
  each.Media.Solid = [boxes](const Vec3& place)
  {
    for (const Box& box : boxes)
    {
      if (box.Contains(place))
      {
        return box.Albedo;
      }
    }
    return -1.0;
  };
  for (Scene::Light& light : each.Media.Lights)
  {
    const Vec3 at = light.Position;
    const bool directional = light.Directional;
    light.Visibility = [boxes, at, directional](const Vec3& place)
    {
      Vec3 towards = directional ? at : at - place;
      const double distance = directional ? 1e30 : vtkGodRays::length(towards);
      towards /= vtkGodRays::length(towards);
      for (const Box& box : boxes)
      {
        if (box.Meet(place, towards) < distance)
        {
          return Vec3(0.0);
        }
      }
      return Vec3(1.0);
    };
  }
}

inline vtkSmartPointer<vtkPolyData> MakeMesh(const Case& each)
{
  GodRaysMediumScenes::Mesh mesh;
  for (const Box& box : each.Boxes)
  {
    mesh.AddBox(box.Low.x, box.High.x, box.Low.y, box.High.y, box.Low.z, box.High.z);
  }
  return mesh.Get();
}

inline std::vector<Ray> MakeRays(const Case& each, int width = Width, int height = Height)
{
  std::vector<Ray> rays;
  const Vec3 forward = (each.Focus - each.Eye) / vtkGodRays::length(each.Focus - each.Eye);
  Vec3 right = vtkGodRays::cross(forward, Vec3(0.0, 0.0, 1.0));
  right /= vtkGodRays::length(right);
  const Vec3 up = vtkGodRays::cross(right, forward);
  const double slope =
    each.Angle > 0.0 ? std::tan(each.Angle * 3.14159265358979 / 360.0) : 0.5 * each.Wide;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const Vec3 aside = slope * (2.0 * (i + 0.5) / width - 1.0) * right +
        slope * height / width * (2.0 * (j + 0.5) / height - 1.0) * up;
      Ray ray = { each.Eye, forward, 1e6 };
      if (each.Angle > 0.0)
      {
        ray.Direction = (forward + aside) / vtkGodRays::length(forward + aside);
      }
      else
      {
        ray.Origin += aside;
      }
      for (const Box& box : each.Boxes)
      {
        ray.End = std::min(ray.End, box.Meet(ray.Origin, ray.Direction));
      }
      rays.push_back(ray);
    }
  }
  return rays;
}

// Noise of several octaves, the same with every compiler.
inline double Noise(const Vec3& p)
{
  const auto hash = [](int x, int y, int z)
  {
    std::uint32_t n = static_cast<std::uint32_t>(x) * 73856093u ^
      static_cast<std::uint32_t>(y) * 19349663u ^ static_cast<std::uint32_t>(z) * 83492791u;
    n = (n ^ n >> 13) * 0x5bd1e995u;
    n = (n ^ n >> 15) * 0x2c1b3c6du;
    return ((n ^ n >> 12) & 0xffffffu) / 16777216.0;
  };
  const Vec3 corner = vtkGodRays::floor(p);
  Vec3 t = p - corner;
  t = t * t * (3.0 - 2.0 * t);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const int x = i & 1;
    const int y = i >> 1 & 1;
    const int z = i >> 2;
    sum += (x ? t.x : 1.0 - t.x) * (y ? t.y : 1.0 - t.y) * (z ? t.z : 1.0 - t.z) *
      hash(static_cast<int>(corner.x) + x, static_cast<int>(corner.y) + y,
        static_cast<int>(corner.z) + z);
  }
  return sum;
}
inline double Fractal(Vec3 p)
{
  double sum = 0.0;
  double size = 0.5;
  for (int octave = 0; octave < 4; ++octave, size *= 0.5)
  {
    sum += size * (Noise(p) - 0.5);
    p = 2.03 * p + Vec3(3.1, 1.7, 5.3);
  }
  return sum;
}

inline double Smoke(double x, double y, double z)
{
  const double aside = x - (0.35 + 0.3 * z * z + 0.05 * std::sin(7.0 * z));
  const double away = y - (0.5 + 0.06 * std::sin(5.0 * z + 1.0));
  const double wide = 0.07 + 0.17 * z;
  const double edge = (aside * aside + away * away) / (wide * wide) +
    2.4 * Fractal(9.0 * Vec3(x, y, z) + Vec3(0.0, 0.0, -2.0)) * (0.3 + z);
  const double density = std::exp(-2.0 * std::max(edge, 0.0)) *
    (z < 0.93 ? 1.0 : std::max((1.0 - z) / 0.07, 0.0)) * (0.07 / wide + 0.4);
  return density < 0.02 ? 0.0 : density;
}

inline double Cloud(double x, double y, double z)
{
  const double spheres[][4] = { { 0.5, 0.5, 0.42, 0.23 }, { 0.33, 0.47, 0.36, 0.16 },
    { 0.66, 0.55, 0.37, 0.17 }, { 0.55, 0.36, 0.36, 0.15 }, { 0.47, 0.62, 0.55, 0.16 },
    { 0.55, 0.48, 0.64, 0.15 }, { 0.4, 0.66, 0.36, 0.14 } };
  double inside = -1.0;
  for (const auto& s : spheres)
  {
    const double distance = vtkGodRays::length(Vec3(x, y, z) - Vec3(s[0], s[1], s[2]));
    inside = std::max(inside, 1.0 - distance / s[3]);
  }
  inside = std::min(inside + 0.9 * Fractal(8.0 * Vec3(x, y, z)), 12.0 * (z - 0.24));
  const double edge = std::min({ x, y, z, 1.0 - x, 1.0 - y, 1.0 - z });
  return edge < 0.02 ? 0.0 : glm::clamp(4.0 * inside, 0.0, 1.0);
}

// Adds an image of the unit box whose thickest column along an axis has a depth.
inline void AddGrid(Case& each, const GodRaysGridScenes::Field& field, int axis, double depth,
  int phase, double g, double albedo, int n = 40)
{
  const double bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  const int points[3] = { n, n, n };
  const auto image = GodRaysGridScenes::MakeImage(bounds, points, field);
  vtkGodRaysGrid grid;
  grid.Read(image);
  const int step = axis == 0 ? 1 : axis == 1 ? n : n * n;
  double thickest = 0.0;
  for (int i = 0; i < n * n; ++i)
  {
    const int first = axis == 0 ? i * n : axis == 1 ? i % n + i / n * n * n : i;
    double sum = 0.0;
    for (int k = 0; k < n; ++k)
    {
      sum += image->GetPointData()->GetScalars()->GetTuple1(first + k * step);
    }
    thickest = std::max(thickest, sum / (n - 1));
  }
  grid.Scale = depth / thickest;
  grid.PhaseFunction = phase;
  grid.Asymmetry = g;
  std::fill_n(grid.Albedo, 3, albedo);
  each.Media.Grids.push_back(grid);
}

inline void SetMedium(Case& each, double extinction, double g, double albedo, int phase)
{
  vtkGodRaysMedium::Component& part = each.Media.Medium.Components[0];
  std::fill_n(part.Scattering, 3, albedo * extinction);
  std::fill_n(part.Absorption, 3, (1.0 - albedo) * extinction);
  part.PhaseFunction = phase;
  part.Asymmetry = g;
  each.Media.Medium.NumberOfComponents = 1;
}

inline void AddSun(Case& each, const Vec3& travels, double strength = 1.0)
{
  Scene::Light light;
  light.Position = -travels;
  light.Color = Vec3(strength);
  each.Media.Lights.push_back(light);
}

enum class Kind
{
  OPEN,
  COLUMNS,
  THIN,
  SMOKE,
  CLOUD
};
enum class View
{
  SIDE,
  BELOW,
  AGAINST
};

inline Case MakeCase(const std::string& name, Kind kind, double depth, double g,
  double albedo = 1.0, View view = View::SIDE, double reflects = 0.0,
  int phase = vtkGodRays::PHASE_HENYEY_GREENSTEIN)
{
  Case each;
  each.Name = name;
  each.Depth = depth;
  each.Asymmetry = g;
  Scene& media = each.Media;
  media.SunIsDimmed = true;
  media.Medium.NumberOfComponents = 0;
  const double up[3] = { 0.0, 0.0, 1.0 };
  std::copy_n(up, 3, media.Medium.Up);
  if (kind == Kind::SMOKE || kind == Kind::CLOUD)
  {
    const bool smoke = kind == Kind::SMOKE;
    AddGrid(each, smoke ? Smoke : Cloud, smoke ? 1 : 2, depth, phase, g, albedo);
    each.Focus = Vec3(0.5, 0.5, smoke ? 0.5 : 0.42);
    each.Angle = smoke ? 40.0 : view == View::BELOW ? 42.0 : 30.0;
    each.Eye = view == View::SIDE ? each.Focus + Vec3(0.2, -2.2, 0.05)
      : view == View::BELOW       ? Vec3(0.45, -0.7, -0.9)
                                  : each.Focus + Vec3(0.0, -2.2, -0.25);
    AddSun(each,
      view == View::SIDE      ? Vec3(0.7, 0.45, -0.5)
        : view == View::BELOW ? Vec3(0.5, 0.2, -0.8)
                              : Vec3(0.06, -1.0, -0.12));
    return each;
  }
  media.High = Vec3(1.0, 1.0, 0.6);
  SetMedium(each, depth, g, albedo, phase);
  if (kind != Kind::OPEN)
  {
    const bool thin = kind == Kind::THIN;
    const double wide = thin ? 0.012 : 0.05;
    const int count = thin ? 4 : 2;
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j < count; ++j)
      {
        const double x = thin ? 0.15 + 0.22 * i : 0.3 + 0.4 * i + 0.06 * j;
        const double y = thin ? 0.35 + 0.16 * j : 0.4 + 0.32 * j;
        each.Boxes.push_back(
          { Vec3(x - wide, y - wide, 0.0), Vec3(x + wide, y + wide, 0.42), reflects });
      }
    }
    each.Boxes.push_back({ Vec3(-0.01), Vec3(1.01, 1.01, 0.05), reflects });
  }
  each.Eye = Vec3(0.5, 0.03, 0.25);
  each.Focus = Vec3(0.5, 0.9, 0.27);
  each.Angle = 60.0;
  AddSun(each, Vec3(-0.35, -0.6, -0.5));
  return each;
}

inline void SetLamp(Case& each, const Vec3& place)
{
  each.Media.Lights.resize(1);
  each.Media.Lights[0].Position = place;
  each.Media.Lights[0].Directional = false;
}

inline std::vector<Case> MakeCases()
{
  std::vector<Case> cases;
  const auto add = [&](const char* name, Kind kind, double depth, double g, double albedo = 1.0,
                     View view = View::SIDE, double reflects = 0.0) -> Case&
  {
    cases.push_back(MakeCase(name, kind, depth, g, albedo, view, reflects));
    return cases.back();
  };
  add("columns 0.3 g 0", Kind::COLUMNS, 0.3, 0.0);
  add("columns 1 g 0", Kind::COLUMNS, 1.0, 0.0);
  add("columns 3 g 0", Kind::COLUMNS, 3.0, 0.0);
  add("columns 10 g 0", Kind::COLUMNS, 10.0, 0.0);
  add("columns 0.3 g 0.5", Kind::COLUMNS, 0.3, 0.5);
  add("columns 1 g 0.5", Kind::COLUMNS, 1.0, 0.5);
  add("columns 3 g 0.5", Kind::COLUMNS, 3.0, 0.5);
  add("columns 0.3 g 0.85", Kind::COLUMNS, 0.3, 0.85);
  add("columns 1 g 0.85", Kind::COLUMNS, 1.0, 0.85);
  add("columns 3 g 0.85", Kind::COLUMNS, 3.0, 0.85);
  add("columns 10 g 0.85", Kind::COLUMNS, 10.0, 0.85);
  add("columns 3 g 0.85 albedo 0.99", Kind::COLUMNS, 3.0, 0.85, 0.99);
  add("white columns 3 g 0.5", Kind::COLUMNS, 3.0, 0.5, 1.0, View::SIDE, 0.5);
  add("thin columns 1 g 0.5", Kind::THIN, 1.0, 0.5);
  SetLamp(add("lamp 1 g 0", Kind::COLUMNS, 1.0, 0.0), Vec3(0.52, 0.55, 0.33));
  SetLamp(add("lamp 1 g 0.85", Kind::COLUMNS, 1.0, 0.85), Vec3(0.52, 0.55, 0.33));
  add("smoke 1 g 0.5", Kind::SMOKE, 1.0, 0.5, 0.9);
  add("smoke 10 g 0.5", Kind::SMOKE, 10.0, 0.5, 0.9);
  add("smoke 3 g 0.85", Kind::SMOKE, 3.0, 0.85, 0.99);
  add("cloud 3 side", Kind::CLOUD, 3.0, 0.85);
  add("cloud 30 side", Kind::CLOUD, 30.0, 0.85);
  add("cloud 100 side", Kind::CLOUD, 100.0, 0.85);
  add("cloud 30 below", Kind::CLOUD, 30.0, 0.85, 1.0, View::BELOW);
  add("cloud 10 against", Kind::CLOUD, 10.0, 0.85, 1.0, View::AGAINST);

  // Held out.
  Case& atmosphere = add("exponential 1 g 0.5", Kind::OPEN, 8.3, 0.5);
  atmosphere.Media.Medium.Components[0].ScaleHeight = 0.12;
  atmosphere.Depth = 1.0;
  Case& two = add("droplets and molecules", Kind::OPEN, 1.0, 0.7);
  two.Media.Medium.NumberOfComponents = 2;
  std::fill_n(two.Media.Medium.Components[1].Scattering, 3, 1.5);
  two.Media.Medium.Components[1].PhaseFunction = vtkGodRays::PHASE_RAYLEIGH;
  Case& odd = add("odd box 3 g 0.6", Kind::OPEN, 3.0, 0.6);
  odd.Media.High = Vec3(1.0, 0.83, 0.37);
  Case& ground = add("white ground 1 g 0.5", Kind::OPEN, 1.0, 0.5);
  ground.Media.FaceAlbedo[4] = 0.6;
  Case& both = add("smoke in haze", Kind::SMOKE, 3.0, 0.3);
  SetMedium(both, 0.5, 0.7, 1.0, vtkGodRays::PHASE_HENYEY_GREENSTEIN);
  AddSun(add("two suns 2 g 0.5", Kind::COLUMNS, 2.0, 0.5), Vec3(0.6, 0.3, -0.4), 2.0);
  add("backwards 2 g -0.3", Kind::COLUMNS, 2.0, -0.3);
  cases.push_back(MakeCase("cloud 10 Cornette-Shanks 0.7", Kind::CLOUD, 10.0, 0.7, 1.0, View::SIDE,
    0.0, vtkGodRays::PHASE_CORNETTE_SHANKS));
  cases.push_back(MakeCase("smoke 3 Schlick 0.6", Kind::SMOKE, 3.0, 0.6, 0.95, View::SIDE, 0.0,
    vtkGodRays::PHASE_SCHLICK));
  Case& spot = add("spotlight 1 g 0.3", Kind::OPEN, 1.0, 0.3);
  SetLamp(spot, Vec3(0.2, 0.5, 0.55));
  vtkGodRaysSpot& cone = spot.Media.Lights[0].Spot;
  const Vec3 axis = Vec3(0.8, 0.1, -0.5) / vtkGodRays::length(Vec3(0.8, 0.1, -0.5));
  std::copy_n(&axis.x, 3, cone.Axis);
  cone.CosCone = 0.9;
  add("dark cloud 20 g 0.75", Kind::CLOUD, 20.0, 0.75, 0.8);
  Case& parallel = add("parallel 3 g 0.7", Kind::OPEN, 3.0, 0.7);
  parallel.Boxes.push_back({ Vec3(0.4, 0.4, 0.15), Vec3(0.6, 0.6, 0.45), 0.2 });
  parallel.Eye = Vec3(0.3, -2.0, 0.5);
  parallel.Focus = Vec3(0.5, 0.5, 0.3);
  parallel.Angle = 0.0;

  for (Case& each : cases)
  {
    SetOccluders(each);
  }
  return cases;
}
}

#endif
