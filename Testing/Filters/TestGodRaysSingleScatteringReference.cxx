// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The ground truth of scattering between occluders: closed forms, and shadow rays.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkSMPTools.h"

#include <array>
#include <cstring>

using namespace GodRaysFiltersTesting;
using GodRaysMediumScenes::Mesh;
using vtkGodRays::Vec3;

namespace
{
using Reference = vtkGodRaysSingleScatteringReference;

double GetRadiance(Reference* reference, int x = 0, int y = 0, int c = 0)
{
  reference->Update();
  return reference->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c);
}

// One pixel that looks along x, and a medium.
void LookAlongX(Reference* reference, double asymmetry, double distance)
{
  reference->SetSize(1, 1);
  reference->SetCameraFocalPoint(1.0, 0.0, 0.0);
  reference->SetCameraViewUp(0.0, 0.0, 1.0);
  reference->SetScatteringCoefficient(0.02, 0.02, 0.02);
  reference->SetAbsorptionCoefficient(0.005, 0.005, 0.005);
  reference->SetAsymmetry(asymmetry);
  reference->SetFarLimit(distance);
}

struct Ray
{
  Vec3 Origin;
  Vec3 Direction;
};

// Where a ray meets a triangle, by Moeller and Trumbore; below 0 where it does not.
double Intersect(const Ray& ray, const std::array<Vec3, 3>& triangle)
{
  const Vec3 a = triangle[1] - triangle[0];
  const Vec3 b = triangle[2] - triangle[0];
  const Vec3 p = vtkGodRays::cross(ray.Direction, b);
  const double determinant = vtkGodRays::dot(a, p);
  const Vec3 from = ray.Origin - triangle[0];
  const double u = vtkGodRays::dot(from, p) / determinant;
  const Vec3 q = vtkGodRays::cross(from, a);
  const double v = vtkGodRays::dot(ray.Direction, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 ? vtkGodRays::dot(b, q) / determinant : -1.0;
}
}

//------------------------------------------------------------------------------
// A half cylinder of shadow and a ball: published interval and radiance.
TEST(SingleScatteringReference, SphereInADirectionalLight)
{
  Mesh mesh;
  mesh.AddSphere(10.0, 1.2, 1.6, 1.5, 300);
  vtkNew<Reference> reference;
  reference->SetInputData(mesh.Get());
  LookAlongX(reference, 0.3, 40.0);
  reference->SetLight(0.0, 0.6, 0.8, 0.0);
  // The published number is for light at 0.5 radians from straight on.
  const double radiance = GetRadiance(reference) *
    vtkGodRays::PhaseHenyeyGreenstein(std::cos(0.5), 0.3) /
    vtkGodRays::PhaseHenyeyGreenstein(0.0, 0.3);
  std::cout << "relative difference from the sphere " << radiance / 0.078581504562 - 1.0 << "\n";
  // 300 parts of a half circle: up to 5.5e-5 of the radius is missing.
  EXPECT_NEAR(radiance / 0.078581504562, 1.0, 1e-5);
  // Its mirror image is not in the way.
  reference->SetLight(0.0, -0.6, -0.8, 0.0);
  EXPECT_NEAR(GetRadiance(reference),
    0.02 * vtkGodRays::PhaseHenyeyGreenstein(0.0, 0.3) *
      vtkGodRays::DirectionalAirlight(0.025, 0.0, 40.0, 0.0, 0.0),
    1e-12);
}

//------------------------------------------------------------------------------
// A cone of shadow: published interval.
TEST(SingleScatteringReference, SphereInAPointLight)
{
  Mesh mesh;
  mesh.AddSphere(5.0, 2.5, 0.5, 0.8, 300);
  vtkNew<Reference> reference;
  reference->SetInputData(mesh.Get());
  LookAlongX(reference, 0.3, 12.0);
  reference->SetLight(4.0, 6.0, 1.0, 1.0);
  const vtkGodRays::PhaseFunction phase = { 2, 0.3 };
  const double height = std::sqrt(37.0);
  const auto airlight = [&](double from, double to)
  { return 0.02 * vtkGodRays::PointAirlight(phase, 0.025, 4.0, height, from, to); };
  const double expected = airlight(0.0, 4.349217743) + airlight(7.276414634, 12.0);
  const double radiance = GetRadiance(reference);
  std::cout << "relative difference from the sphere " << radiance / expected - 1.0 << "\n";
  EXPECT_NEAR(radiance / expected, 1.0, 1e-5);
  // Homogeneous coordinates of the same light, and one beyond which the sphere lies.
  reference->SetLight(-8.0, -12.0, -2.0, -2.0);
  EXPECT_NEAR(GetRadiance(reference), radiance, 1e-15);
  reference->SetLight(4.7, 1.3, 0.2, 1.0);
  EXPECT_NEAR(GetRadiance(reference),
    0.02 * vtkGodRays::PointAirlight(phase, 0.025, 4.7, std::hypot(1.3, 0.2), 0.0, 12.0), 1e-10);
}

//------------------------------------------------------------------------------
// Faces are planes: exact intervals, three colours, a surface that ends the ray.
TEST(SingleScatteringReference, Slabs)
{
  Mesh mesh;
  mesh.AddBox(2.0, 3.0, -1.0, 1.0, 4.0, 5.0);
  mesh.AddBox(2.5, 3.5, -1.0, 1.0, 6.0, 7.0);
  mesh.AddBox(20.0, 21.0, -1.0, 1.0, -1.0, 1.0);
  vtkNew<Reference> reference;
  reference->SetInputData(mesh.Get());
  LookAlongX(reference, 0.0, 40.0);
  reference->SetPhaseFunction(Reference::ISOTROPIC);
  reference->SetScatteringCoefficient(0.02, 0.5, 0.0);
  reference->SetAbsorptionCoefficient(0.0, 0.1, 0.3);
  reference->SetLightColor(1.0, 2.0, 3.0);
  reference->SetLight(0.5, 0.0, 1.0, 0.0);
  // Along (-0.5, 0, -1) they shadow [-0.5, 1] and [-1, 0.5], and the box before the eye from 19.5 on.
  const auto lit = [](double b, double from, double to) {
    return vtkGodRays::DirectionalAirlight(b, from, to, 0.0, 0.0) / (4.0 * 3.14159265358979323846);
  };
  EXPECT_NEAR(GetRadiance(reference, 0, 0, 0), 0.02 * lit(0.02, 1.0, 19.5), 1e-12);
  EXPECT_NEAR(GetRadiance(reference, 0, 0, 1), 2.0 * 0.5 * lit(0.6, 1.0, 19.5), 1e-10);
  EXPECT_EQ(GetRadiance(reference, 0, 0, 2), 0.0);
  reference->SetLight(-0.5, 0.0, 1.0, 0.0); // [4, 5.5] and [5.5, 7]
  EXPECT_NEAR(
    GetRadiance(reference, 0, 0, 0), 0.02 * (lit(0.02, 0.0, 4.0) + lit(0.02, 7.0, 20.0)), 1e-12);
  auto* depth = reference->GetOutput()->GetPointData()->GetArray("Depth");
  ASSERT_TRUE(depth);
  EXPECT_DOUBLE_EQ(depth->GetTuple1(0), 20.0);
  // Straight at the light: all before the box is hidden; straight away from it: nothing is.
  reference->SetLight(1.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(GetRadiance(reference), 0.0);
  reference->SetLight(-1.0, 0.0, 0.0, 0.0);
  EXPECT_NEAR(GetRadiance(reference), 0.02 * lit(0.02, 0.0, 20.0), 1e-12);
}

//------------------------------------------------------------------------------
// Any triangles, any light, both projections, against shadow rays from 4000 points of each view ray.
TEST(SingleScatteringReference, AgreesWithShadowRays)
{
  std::mt19937 generator = MakeGenerator(21);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  double worst = 0.0;
  for (int round = 0; round < 12; ++round)
  {
    Mesh mesh;
    std::vector<std::array<Vec3, 3>> triangles;
    for (int i = 0; i < 25; ++i)
    {
      const Vec3 centre(uniform(-3.0, 3.0), uniform(-3.0, 3.0), uniform(-9.0, 1.0));
      std::array<Vec3, 3> triangle;
      vtkIdType ids[3];
      for (int j = 0; j < 3; ++j)
      {
        triangle[j] = centre + Vec3(uniform(-0.7, 0.7), uniform(-0.7, 0.7), uniform(-0.7, 0.7));
        ids[j] = mesh.AddPoint(triangle[j].x, triangle[j].y, triangle[j].z);
      }
      mesh.AddPolygon({ ids[0], ids[1], ids[2] });
      triangles.push_back(triangle);
    }
    const bool directional = round % 2 == 0;
    const bool parallel = round % 3 == 0;
    const Vec3 light(uniform(-4.0, 4.0), uniform(-4.0, 4.0), uniform(-12.0, 4.0));
    vtkNew<Reference> reference;
    reference->SetInputData(mesh.Get());
    constexpr int size = 6;
    reference->SetSize(size, size);
    reference->SetViewAngle(50.0);
    reference->SetParallelProjection(parallel);
    reference->SetParallelScale(2.0);
    reference->SetFarLimit(8.0);
    reference->SetPhaseFunction(Reference::ISOTROPIC);
    reference->SetLight(light.x, light.y, light.z, directional ? 0.0 : 1.0);
    reference->Update();
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double pixel =
          2.0 / size * (parallel ? 2.0 : std::tan(25.0 * 3.14159265358979323846 / 180.0));
        const Vec3 offset((x + 0.5 - 0.5 * size) * pixel, (y + 0.5 - 0.5 * size) * pixel, 0.0);
        const Vec3 straight(0.0, 0.0, -1.0);
        const Ray view = { parallel ? offset : Vec3(0.0), parallel ? straight : straight + offset };
        const double length = vtkGodRays::length(view.Direction);
        double end = 8.0;
        for (const auto& triangle : triangles)
        {
          const double t = Intersect(view, triangle);
          end = t > 0.0 ? std::min(end, t) : end;
        }
        constexpr int steps = 4000;
        double sum = 0.0;
        double whole = 0.0;
        for (int i = 0; i < steps; ++i)
        {
          const double z = (i + 0.5) * end / steps;
          const Vec3 point = view.Origin + z * view.Direction;
          const Ray ray = { point, directional ? light : light - point };
          bool open = true;
          for (const auto& triangle : triangles)
          {
            const double t = Intersect(ray, triangle);
            open = open && !(t > 0.0 && (directional || t < 1.0));
          }
          const double r = directional ? 0.0 : vtkGodRays::length(light - point);
          const double step = 0.05 / (4.0 * 3.14159265358979323846) * end / steps * length *
            std::exp(-0.05 * (z * length + r)) / (directional ? 1.0 : r * r);
          whole += step;
          sum += open ? step : 0.0;
        }
        const double error =
          std::abs(reference->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 0) - sum) / whole;
        worst = std::max(worst, error);
        // Each end of a shadow is off by up to half a step, most so beside a point light.
        EXPECT_LE(error, 4e-3) << "round " << round << " pixel " << x << " " << y;
      }
    }
  }
  std::cout << "largest difference from shadow rays " << worst << "\n";
}

//------------------------------------------------------------------------------
// Two components of exponential density, each with a mix of phase functions, against a sum of 200 000
// steps that takes its optical depths from heights alone.
TEST(SingleScatteringReference, MediaThatThinOut)
{
  const double scattering[2] = { 0.08, 0.05 };
  const double absorption[2] = { 0.02, 0.01 };
  const double scaleHeight[2] = { 1.2, 8.0 };
  const auto depth = [&](double low, double high, double length)
  {
    double sum = 0.0;
    for (int k = 0; k < 2; ++k)
    {
      const double rise = (high - low) / scaleHeight[k];
      const double mean = std::abs(rise) < 1e-6
        ? std::exp(-low / scaleHeight[k])
        : (std::exp(-low / scaleHeight[k]) - std::exp(-high / scaleHeight[k])) / rise;
      sum += (scattering[k] + absorption[k]) * mean * length;
    }
    return sum;
  };
  for (const double slope : { 0.4, 0.0, -0.2 })
  {
    for (const double w : { 0.0, 1.0 })
    {
      const double eye = 1.5;
      const double far = 12.0;
      vtkNew<Reference> reference;
      reference->SetSize(1, 1);
      reference->SetCameraPosition(0.0, 0.0, eye + 0.3);
      reference->SetCameraFocalPoint(std::sqrt(1.0 - slope * slope), 0.0, eye + 0.3 + slope);
      reference->SetCameraViewUp(0.0, 1.0, 0.0);
      reference->SetMediumUp(0.0, 0.0, 5.0);
      reference->SetGroundLevel(0.3);
      reference->SetScatteringCoefficient(scattering[0], scattering[0], scattering[0]);
      reference->SetAbsorptionCoefficient(absorption[0], absorption[0], absorption[0]);
      reference->SetScaleHeight(scaleHeight[0]);
      reference->SetSecondWeight(0.25);
      reference->SetGasScatteringCoefficient(scattering[1], scattering[1], scattering[1]);
      reference->SetGasAbsorptionCoefficient(absorption[1], absorption[1], absorption[1]);
      reference->SetGasScaleHeight(scaleHeight[1]);
      reference->SetFarLimit(far);
      const Vec3 light = w == 0.0 ? Vec3(0.6, 0.0, 0.8) : Vec3(3.0, 1.0, 4.0);
      reference->SetLight(light.x, light.y, light.z, w);
      const Vec3 view(std::sqrt(1.0 - slope * slope), 0.0, slope);
      constexpr int steps = 200000;
      double expected = 0.0;
      for (int i = 0; i < steps; ++i)
      {
        const double s = (i + 0.5) * far / steps;
        const double height = eye + slope * s;
        const Vec3 point = Vec3(0.0, 0.0, eye + 0.3) + s * view;
        const Vec3 way = w == 0.0 ? light : light - point;
        const double r = vtkGodRays::length(way);
        const double cosine = vtkGodRays::dot(way, view) / r;
        double value = 0.0;
        for (int k = 0; k < 2; ++k)
        {
          const double phase = k == 1 ? vtkGodRays::PhaseRayleigh(cosine)
                                      : 0.75 * vtkGodRays::PhaseHenyeyGreenstein(cosine, 0.6) +
              0.25 * vtkGodRays::PhaseHenyeyGreenstein(cosine, -0.3);
          value += phase * scattering[k] * std::exp(-height / scaleHeight[k]);
        }
        // From above, 200 scale heights up, or from the point.
        const double rise = w == 0.0 ? 1600.0 : light.z - 0.3 - height;
        const double length = w == 0.0 ? rise / light.z : r;
        expected += far / steps * value / (w == 0.0 ? 1.0 : r * r) *
          std::exp(-depth(eye, height, s) - depth(height, height + rise, length));
      }
      EXPECT_NEAR(GetRadiance(reference) / expected, 1.0, 1e-8) << slope << " " << w;
    }
  }
}

//------------------------------------------------------------------------------
TEST(SingleScatteringReference, ThereIsNoLightBelowTheHorizon)
{
  vtkNew<Reference> reference;
  LookAlongX(reference, 0.3, 40.0);
  reference->SetLight(1.0, -0.01, 0.0, 0.0);
  EXPECT_GT(GetRadiance(reference), 0.0);
  reference->SetScaleHeight(2.0);
  EXPECT_EQ(GetRadiance(reference), 0.0);
  reference->SetLight(1.0, 0.01, 0.0, 0.0);
  EXPECT_GT(GetRadiance(reference), 0.0);
}

//------------------------------------------------------------------------------
// The air of a planet, from the ground to space, day and dusk: the sky's formula in 20 000 steps.
TEST(SingleScatteringReference, AirOverAPlanet)
{
  const double ground = 6360e3;
  const double top = 320e3;
  const vtkGodRays::SkyAtmosphere sky = { ground, top, { 0, 8000.0, 0.0 }, { 0, 1200.0, 0.0 },
    { 2, 25e3, 15e3 }, Vec3(5.802e-6, 13.558e-6, 33.1e-6), Vec3(3.996e-6), Vec3(4.44e-6), Vec3(0.0),
    { 1, 0.0 }, 3, Vec3(0.8) };
  vtkNew<Reference> reference;
  reference->SetSize(1, 1);
  reference->SetViewAngle(1e-3);
  reference->SetTolerance(1e-6);
  reference->SetScatteringCoefficient(3.996e-6, 3.996e-6, 3.996e-6);
  reference->SetAbsorptionCoefficient(4.44e-7, 4.44e-7, 4.44e-7);
  reference->SetPhaseFunction(Reference::CORNETTE_SHANKS);
  reference->SetAsymmetry(0.8);
  reference->SetScaleHeight(1200.0);
  reference->SetGasScatteringCoefficient(5.802e-6, 13.558e-6, 33.1e-6);
  reference->SetGasScaleHeight(8000.0);
  reference->SetMediumUp(0.0, 0.0, 1.0);
  reference->SetPlanetRadius(ground);
  reference->SetFarLimit(2e7);
  const double turn = 0.3; // of the eye's vertical from the origin's
  const auto toWorld = [&](const Vec3& v)
  {
    return Vec3(v.x * std::cos(turn) + v.z * std::sin(turn), v.y,
      v.z * std::cos(turn) - v.x * std::sin(turn));
  };
  double worst = 0.0;
  for (const double height : { 2.0, 1e3, 12e3, 4e5, 3e6 })
  {
    for (const double sunHeight : { 80.0, 30.0, 5.0, -3.0 })
    {
      for (const double view : { 90.0, 45.0, 2.0, -10.0, -45.0, -80.0 })
      {
        const auto getDirection = [](double degrees, double across)
        {
          const double angle = vtkMath::RadiansFromDegrees(degrees);
          return Vec3(std::cos(angle) * std::cos(across), std::cos(angle) * std::sin(across),
            std::sin(angle));
        };
        const Vec3 along = getDirection(view, 0.0);
        const Vec3 sun = getDirection(sunHeight, 0.7);
        const Vec3 eye = toWorld(Vec3(0.0, 0.0, ground + height)) - Vec3(0.0, 0.0, ground);
        const Vec3 focus = eye + 1e6 * toWorld(along);
        const Vec3 light = toWorld(sun);
        reference->SetCameraPosition(eye.x, eye.y, eye.z);
        reference->SetCameraFocalPoint(focus.x, focus.y, focus.z);
        reference->SetLight(light.x, light.y, light.z, 0.0);
        reference->Update();
        const Picture actual = FromImage(reference->GetOutput());

        const double cosAngle = vtkGodRays::dot(along, sun);
        const vtkGodRays::Vec2 air = vtkGodRays::SkyBelow(ground, height, along.z, top);
        const double end = vtkGodRays::SkyGroundDistance(ground, height, along.z);
        const double last = end >= 0.0 ? end : air.y;
        const vtkGodRays::Vec2 shadow =
          vtkGodRays::SkyShadow(ground, height, along.z, sun.z, cosAngle);
        constexpr int steps = 20000;
        Vec3 sum(0.0);
        for (int i = 0; i < steps && air.x < last; ++i)
        {
          const double step = (last - air.x) / steps;
          const double s = air.x + (i + 0.5) * step;
          if (s < shadow.x || s > shadow.y)
          {
            sum += step * vtkGodRays::SkyInscatter(sky, height, along.z, sun.z, cosAngle, s);
          }
        }
        const double most = std::max({ sum.x, sum.y, sum.z });
        for (int c = 0; c < 3; ++c)
        {
          const double error = std::abs(actual.Values[c] - sum[c]) / std::max(most, 1e-6);
          EXPECT_LE(error, 5e-4) << height << " m, sun " << sunHeight << ", view " << view;
          worst = std::max(worst, error);
        }
      }
    }
  }
  std::cout << "largest difference " << worst << "\n";
}

//------------------------------------------------------------------------------
// A spotlight, with and without fading, against a sum over points each of which is asked for its angle.
TEST(SingleScatteringReference, Spotlights)
{
  double worst = 0.0;
  for (const double cone : { 20.0, 60.0, 85.0 })
  {
    for (const double exponent : { 0.0, 1.0, 7.5 })
    {
      for (const Vec3& axis : { Vec3(0.0, -1.0, 0.0), Vec3(0.3, 0.2, 1.0), Vec3(-1.0, -0.5, -0.5) })
      {
        vtkNew<Reference> reference;
        reference->SetSize(7, 5);
        reference->SetViewAngle(70.0);
        reference->SetFarLimit(20.0);
        reference->SetTolerance(1e-7);
        const Vec3 light(0.4, 0.8, -5.0);
        reference->SetLight(light.x, light.y, light.z, 1.0);
        reference->SetConeAngle(cone);
        reference->SetSpotDirection(axis.x, axis.y, axis.z);
        reference->SetSpotExponent(exponent);
        reference->Update();
        const Picture actual = FromImage(reference->GetOutput());
        const double least = std::cos(vtkMath::RadiansFromDegrees(cone));
        double peak = 0.0;
        std::vector<double> expected;
        for (int y = 0; y < 5; ++y)
        {
          for (int x = 0; x < 7; ++x)
          {
            const double pixel = 2.0 / 5.0 * std::tan(vtkMath::RadiansFromDegrees(35.0));
            const Vec3 way((x - 3.0) * pixel, (y - 2.0) * pixel, -1.0);
            const double length = vtkGodRays::length(way);
            constexpr int steps = 40000;
            double sum = 0.0;
            for (int i = 0; i < steps; ++i)
            {
              const double s = (i + 0.5) * 20.0 * length / steps;
              const Vec3 from = s / length * way - light;
              const double r = vtkGodRays::length(from);
              const double cosine = vtkGodRays::dot(from, axis) / (r * vtkGodRays::length(axis));
              if (cosine >= least)
              {
                sum += std::pow(cosine, exponent) / (r * r) * std::exp(-0.05 * (s + r)) *
                  vtkGodRays::PhaseHenyeyGreenstein(
                    -vtkGodRays::dot(from, way) / (r * length), 0.6);
              }
            }
            expected.push_back(0.05 * sum * 20.0 * length / steps);
            peak = std::max(peak, expected.back());
          }
        }
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          worst = std::max(worst, std::abs(actual.Values[3 * i] - expected[i]) / peak);
        }
      }
    }
  }
  std::cout << "largest difference " << worst << "\n";
  EXPECT_LE(worst, 5e-4); // of the sum: its steps end at the cone's edge
}

//------------------------------------------------------------------------------
TEST(SingleScatteringReference, AHugePlanetIsAPlane)
{
  vtkNew<Reference> reference;
  reference->SetInputData(GodRaysMediumScenes::MakeScenes(6)[0].Occluders);
  reference->SetSize(24, 16);
  reference->SetFarLimit(20.0);
  reference->SetScaleHeight(2.0);
  reference->SetScatteringCoefficient(10.0, 10.0, 10.0);
  reference->SetGroundLevel(-15.0); // no ray meets it
  for (const bool parallel : { false, true })
  {
    reference->SetParallelProjection(parallel);
    reference->SetParallelScale(2.5);
    for (const double w : { 0.0, 1.0 })
    {
      reference->SetLight(1.0, 2.0, -6.0, w);
      reference->SetPlanetRadius(0.0);
      reference->Update();
      const Picture flat = FromImage(reference->GetOutput());
      const auto getDifference = [&](double radius)
      {
        reference->SetPlanetRadius(radius);
        reference->Update();
        return GetLargestDifference(FromImage(reference->GetOutput()), flat) / flat.GetMaximum();
      };
      EXPECT_LE(getDifference(1e9), 1e-6);
      EXPECT_GT(getDifference(1e3), 1e-4);
    }
  }
}

//------------------------------------------------------------------------------
// A wall that is seen and casts no shadow, and a roof that casts one and is not seen.
TEST(SingleScatteringReference, RaysMayEndElsewhere)
{
  Mesh roof;
  roof.AddBox(2.0, 3.0, -1.0, 1.0, 4.0, 5.0);
  Mesh wall;
  wall.AddBox(20.0, 21.0, -1.0, 1.0, -1.0, 1.0);
  Mesh both;
  both.AddBox(2.0, 3.0, -1.0, 1.0, 4.0, 5.0);
  both.AddBox(20.0, 21.0, -1.0, 1.0, -1.0, 1.0);
  vtkNew<Reference> reference;
  LookAlongX(reference, 0.3, 40.0);
  reference->SetLight(0.0, 0.0, 1.0, 0.0);
  const double factor = 0.02 * vtkGodRays::PhaseHenyeyGreenstein(0.0, 0.3);
  const auto lit = [&](double from, double to)
  { return factor * vtkGodRays::DirectionalAirlight(0.025, from, to, 0.0, 0.0); };
  reference->SetInputData(0, roof.Get());
  reference->SetInputData(1, wall.Get());
  EXPECT_NEAR(GetRadiance(reference), lit(0.0, 2.0) + lit(3.0, 20.0), 1e-12);
  EXPECT_EQ(reference->GetOutput()->GetPointData()->GetArray("End")->GetTuple1(0), 20.0);
  EXPECT_TRUE(std::isinf(reference->GetOutput()->GetPointData()->GetArray("Depth")->GetTuple1(0)));
  reference->SetInputData(0, both.Get());
  EXPECT_NEAR(GetRadiance(reference), lit(0.0, 2.0) + lit(3.0, 20.0), 1e-12);
  reference->SetInputData(1, roof.Get()); // the wall is not seen, its shadow is
  EXPECT_NEAR(GetRadiance(reference), lit(0.0, 2.0) + lit(3.0, 20.0) + lit(21.0, 40.0), 1e-12);
  // Straight at the light, and away from it: dark before the wall, or beyond it.
  reference->SetLight(1.0, 0.0, 0.0, 0.0);
  const double ahead =
    vtkGodRays::PhaseHenyeyGreenstein(1.0, 0.3) / vtkGodRays::PhaseHenyeyGreenstein(0.0, 0.3);
  EXPECT_NEAR(GetRadiance(reference), ahead * lit(21.0, 40.0), 1e-12);
  reference->SetLight(-1.0, 0.0, 0.0, 0.0);
  const double back =
    vtkGodRays::PhaseHenyeyGreenstein(-1.0, 0.3) / vtkGodRays::PhaseHenyeyGreenstein(0.0, 0.3);
  EXPECT_NEAR(GetRadiance(reference), back * lit(0.0, 20.0), 1e-12);
}

//------------------------------------------------------------------------------
TEST(SingleScatteringReference, KeepsItsTolerance)
{
  auto scenes = GodRaysMediumScenes::MakeScenes(8);
  for (const double w : { 0.0, 1.0 })
  {
    vtkNew<Reference> reference;
    reference->SetInputData(scenes[3].Occluders);
    reference->SetSize(48, 27);
    reference->SetViewAngle(60.0);
    reference->SetFarLimit(1000.0);
    reference->SetScatteringCoefficient(0.3, 0.1, 0.02);
    reference->SetAsymmetry(0.95);
    reference->SetLight(0.5, 0.8, -4.0, w);
    reference->SetTolerance(1e-12);
    reference->Update();
    const Picture exact = FromImage(reference->GetOutput());
    double before = 1.0;
    for (const double tolerance : { 1e-3, 1e-6, 1e-9 })
    {
      reference->SetTolerance(tolerance);
      reference->Update();
      const double error =
        GetLargestDifference(exact, FromImage(reference->GetOutput())) / exact.GetMaximum();
      std::cout << "w " << w << " tolerance " << tolerance << ": " << error << "\n";
      EXPECT_LE(error, tolerance);
      EXPECT_LE(error, before);
      before = error;
    }
  }
}

//------------------------------------------------------------------------------
TEST(SingleScatteringReference, BytesDoNotDependOnThreads)
{
  auto scenes = GodRaysMediumScenes::MakeScenes(6);
  Picture pictures[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        vtkNew<Reference> reference;
        reference->SetInputData(scenes[4].Occluders);
        reference->SetSize(33, 21);
        reference->Update();
        pictures[threads - 1] = FromImage(reference->GetOutput());
      });
  }
  EXPECT_EQ(std::memcmp(pictures[0].Values.data(), pictures[1].Values.data(),
              pictures[0].Values.size() * sizeof(double)),
    0);
}

//------------------------------------------------------------------------------
TEST(SingleScatteringReference, TellsWhatCannotBeUsedOnce)
{
  vtkNew<Reference> reference;
  ErrorListener errors(reference);
  reference->SetCameraViewUp(0.0, 0.0, 5.0);
  reference->Update();
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("CameraViewUp"), std::string::npos);
  EXPECT_EQ(reference->GetOutput()->GetNumberOfPoints(), 0);
  reference->SetCameraViewUp(0.0, 1.0, 0.0);
  reference->SetLight(0.0, 0.0, 0.0, 0.0);
  reference->Update();
  EXPECT_EQ(errors.Texts.size(), 2u);
  reference->SetLight(0.0, 1.0, 0.0, 0.0);
  reference->SetLightColor(-1.0, 1.0, 1.0);
  reference->Update();
  EXPECT_EQ(errors.Texts.size(), 3u);
  // Without occluders all is lit.
  reference->SetLightColor(1.0, 1.0, 1.0);
  reference->Update();
  EXPECT_EQ(errors.Texts.size(), 3u);
  EXPECT_GT(GetRadiance(reference), 0.0);
}
