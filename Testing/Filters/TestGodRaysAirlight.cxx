// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Light of media without shadows, in closed form and from tables: point lights, exponential density.

#include "GodRaysAirlight.h"
#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkSMPTools.h"

#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <set>
#include <utility>

using namespace GodRaysFiltersTesting;
using namespace GodRaysMediumScenes;
using vtkGodRays::Vec3;

namespace
{
using Filter = Airlight;
using Reference = vtkGodRaysSingleScatteringReference;

constexpr int Width = 64;
constexpr int Height = 36;
const double sky = std::numeric_limits<double>::infinity();

// The view ray of a pixel: where it begins, and a step of it for each unit of depth.
struct Ray
{
  Vec3 Origin;
  Vec3 Step;
};
double GetPixelSize(vtkGodRaysMediumFilter* filter)
{
  return 2.0 / Height *
    (filter->GetParallelProjection()
        ? filter->GetParallelScale()
        : std::tan(0.5 * vtkMath::RadiansFromDegrees(filter->GetViewAngle())));
}
Ray GetRay(vtkGodRaysMediumFilter* filter, int x, int y)
{
  const bool parallel = filter->GetParallelProjection();
  const double pixel = GetPixelSize(filter);
  const Vec3 offset((x + 0.5 - 0.5 * Width) * pixel, (y + 0.5 - 0.5 * Height) * pixel, 0.0);
  const Vec3 eye(
    filter->GetCameraPosition()[0], filter->GetCameraPosition()[1], filter->GetCameraPosition()[2]);
  const Vec3 ahead(0.0, 0.0, -1.0);
  return parallel ? Ray{ eye + offset, ahead } : Ray{ eye, ahead + offset };
}

// The largest difference from what is expected of a pixel and an end, as a fraction of the peak.
double CompareEnds(Filter* filter, const std::function<double(int, int)>& getEnd,
  const std::function<double(const Ray&, double)>& expect)
{
  const Picture picture = filter->Draw(MakePicture(Width, Height, getEnd));
  double peak = 0.0;
  double worst = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const double end = std::min(getEnd(x, y), filter->GetFarLimit());
      const double expected = expect(GetRay(filter, x, y), end);
      EXPECT_TRUE(picture.Get(x, y) >= 0.0);
      peak = std::max(peak, expected);
      worst = std::max(worst, std::abs(picture.Get(x, y) - expected));
    }
  }
  return peak > 0.0 ? worst / peak : worst;
}
}

//------------------------------------------------------------------------------
// A closed form, to rounding.
TEST(Airlight, DirectionalLightsShineAsTheClosedForm)
{
  Random random{ MakeGenerator(31) };
  double worst = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    vtkNew<Filter> filter;
    const Vec3 light = random.Direction();
    const double b = random.Log(1e-12, 1e3);
    const double far = random.Log(1e-3, 1e6);
    filter->SetViewAngle(60.0);
    filter->SetLight(light.x, light.y, light.z, 0.0);
    filter->SetScatteringCoefficient(b, b, b);
    filter->SetFarLimit(far);
    filter->SetParallelProjection(i % 3 == 0);
    filter->SetPhaseFunction(i % (vtkGodRaysLastPhaseFunction + 1));
    filter->SetAsymmetry(random.Uniform(-0.9, 0.9));
    const Picture result = filter->Draw(MakePicture(Width, Height, [](int, int) { return sky; }));
    ASSERT_EQ(result.Components, 1);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const Vec3 view = GetRay(filter, x, y).Step;
        const double length = vtkGodRays::length(view);
        const double expected = b *
          vtkGodRays::Phase({ i % (vtkGodRaysLastPhaseFunction + 1), filter->GetAsymmetry() },
            vtkGodRays::dot(view, light) / length / vtkGodRays::length(light)) *
          vtkGodRays::DirectionalAirlight(b, 0.0, far * length, 0.0, 0.0);
        worst = std::max(worst, std::abs(result.Get(x, y) / expected - 1.0));
      }
    }
  }
  std::cout << "largest relative difference " << worst << "\n";
  EXPECT_LE(worst, 1e-5);
}

//------------------------------------------------------------------------------
// To the far limit, and to nearer ends, against the integral; media, lights and scales of any kind.
TEST(Airlight, PointLightsShineAsTheIntegral)
{
  Random random{ MakeGenerator(41) };
  double worst = 0.0;
  for (int i = 0; i < 120; ++i)
  {
    vtkNew<Filter> filter;
    const double scale = random.Log(1e-3, 1e3);
    filter->SetFarLimit(20.0 * scale);
    filter->SetViewAngle(random.Uniform(10.0, 90.0));
    filter->SetParallelProjection(i % 2 == 1);
    filter->SetParallelScale(random.Uniform(1.0, 8.0) * scale);
    const double b = random.Log(1e-5, 1.0) / scale;
    filter->SetScatteringCoefficient(b, b, b);
    filter->SetPhaseFunction(i % (vtkGodRaysLastPhaseFunction + 1));
    const double g = random.Uniform(-0.9, 0.9);
    filter->SetAsymmetry(g);
    // Not so far that only darkness comes from it.
    const double distance = std::min(random.Log(0.01, 1e4) * scale, 20.0 / b);
    const Vec3 light = distance * random.Direction();
    filter->SetLight(light.x, light.y, light.z, 1.0);
    const double most = random.Uniform(0.05, 1.0);
    const double error = CompareEnds(
      filter, [&](int x, int y) { return most * 20.0 * scale * (1 + (x + y) % 7) / 7.0; },
      [&](const Ray& ray, double end)
      {
        const double length = vtkGodRays::length(ray.Step);
        const Vec3 along = ray.Step / length;
        const double foot = vtkGodRays::dot(light - ray.Origin, along);
        // Next to the light it is the mean over the pixel.
        const double nearest = filter->GetParallelProjection()
          ? 0.28 * GetPixelSize(filter)
          : 0.28 * GetPixelSize(filter) * light.z * light.z / vtkGodRays::length(light);
        const double height =
          std::max(nearest, vtkGodRays::length(vtkGodRays::cross(light - ray.Origin, along)));
        return b *
          vtkGodRays::PointAirlight(
            { i % (vtkGodRaysLastPhaseFunction + 1), g }, b, foot, height, 0.0, end * length);
      });
    EXPECT_LE(error, 2e-3) << i << " " << filter->Describe() << " light " << light.x / scale << " "
                           << light.y / scale << " " << light.z / scale << " optical depth "
                           << b * scale * 20.0;
    worst = std::max(worst, error);
  }
  std::cout << "largest difference " << worst << " of the peak\n";
}

//------------------------------------------------------------------------------
// One component of exponential density, against its closed form.
TEST(Airlight, LayersShineAsTheIntegral)
{
  Random random{ MakeGenerator(42) };
  double worst = 0.0;
  for (int i = 0; i < 120; ++i)
  {
    vtkNew<Filter> filter;
    const double scale = random.Log(1e-2, 1e3);
    const double far = random.Log(1.0, 1e3) * scale;
    filter->SetFarLimit(far);
    filter->SetViewAngle(random.Uniform(10.0, 90.0));
    filter->SetParallelProjection(i % 2 == 1);
    filter->SetParallelScale(random.Uniform(0.1, 8.0) * scale);
    const double b = random.Log(1e-3, 3.0) / scale;
    filter->SetScatteringCoefficient(b, b, b);
    filter->SetPhaseFunction(Filter::ISOTROPIC);
    filter->SetScaleHeight(scale);
    const Vec3 up = i % 3 == 0 ? Vec3(0.0, 1.0, 0.0) : random.Direction();
    filter->SetMediumUp(up.x, up.y, up.z);
    const double eye = random.Uniform(-1.0, i % 4 == 0 ? 20.0 : 3.0) * scale;
    filter->SetGroundLevel(-eye);
    Vec3 light;
    do // not where it is night
    {
      light = random.Direction();
    } while (b * scale * std::exp(-eye / scale) > 10.0 * vtkGodRays::dot(light, up));
    filter->SetLight(light.x, light.y, light.z, 0.0);
    const double most = random.Uniform(0.05, 1.0);
    const double error = CompareEnds(
      filter, [&](int x, int y) { return most * far * (1 + (x + y) % 7) / 7.0; },
      [&](const Ray& ray, double end)
      {
        const double length = vtkGodRays::length(ray.Step);
        return b / (4.0 * vtkMath::Pi()) *
          vtkGodRays::ExponentialAirlight(b, eye + vtkGodRays::dot(up, ray.Origin),
            vtkGodRays::dot(up, ray.Step) / length, vtkGodRays::dot(up, light), scale, 0.0,
            end * length);
      });
    EXPECT_LE(error, 2e-3) << i << " " << filter->Describe() << " eye " << eye / scale << " far "
                           << far / scale << " b " << b * scale << " light "
                           << vtkGodRays::dot(up, light);
    worst = std::max(worst, error);
  }
  std::cout << "largest difference " << worst << " of the peak\n";
}

//------------------------------------------------------------------------------
// Point lights above, in and below two components of exponential density, against sums of many steps.
// Of the second seed those alone whose slices would be too few if heights alone told their number;
// GODRAYS_LONG takes all.
TEST(Airlight, PointLightsInLayersShineAsTheIntegral)
{
  const bool all = std::getenv("GODRAYS_LONG") != nullptr;
  const std::set<int> chosen = { 9, 22, 33, 54 };
  Random randoms[] = { { MakeGenerator(45) }, { MakeGenerator(1045) } };
  double worst = 0.0;
  for (int scene = 0; scene < 120; ++scene)
  {
    const int i = scene % 60;
    Random& random = randoms[scene / 60];
    vtkNew<Filter> filter;
    const double scale = random.Log(1e-3, 1e3); // the lesser height
    const double far = random.Log(0.3, 100.0) * scale;
    filter->SetFarLimit(far);
    filter->SetViewAngle(random.Uniform(10.0, 90.0));
    filter->SetParallelProjection(i % 2 == 1);
    filter->SetParallelScale(random.Uniform(0.1, 4.0) * scale);
    const double b = random.Log(1e-3, 1.0) / scale;
    const double gas = random.Log(1e-3, 1.0) / scale;
    const double g = random.Uniform(-0.9, 0.9);
    const double gasScale = random.Log(1.0, 10.0) * scale;
    filter->SetScatteringCoefficient(b, b, b);
    filter->SetPhaseFunction(i % (vtkGodRaysLastPhaseFunction + 1));
    filter->SetAsymmetry(g);
    filter->SetScaleHeight(scale);
    filter->SetGasScatteringCoefficient(gas, gas, gas);
    filter->SetGasScaleHeight(i % 4 == 0 ? 0.0 : gasScale);
    const Vec3 up = i % 3 == 0 ? Vec3(0.0, 1.0, 0.0) : random.Direction();
    filter->SetMediumUp(up.x, up.y, up.z);
    const double eye = random.Uniform(-1.0, 3.0) * scale;
    filter->SetGroundLevel(-eye);
    const vtkGodRays::MediumComponent first = { b, b, scale,
      { i % (vtkGodRaysLastPhaseFunction + 1), g }, {}, 0.0 };
    const vtkGodRays::MediumComponent second = { gas, gas, filter->GetGasScaleHeight(),
      { Filter::RAYLEIGH, 0.0 }, {}, 0.0 };
    Vec3 light;
    double depth;
    do // not where only darkness comes from
    {
      light = random.Log(0.1, 20.0) * scale * random.Direction();
      const double distance = vtkGodRays::length(light);
      depth = b *
          vtkGodRays::MediumDepth(
            0.0, eye, vtkGodRays::dot(light, up) / distance, scale, distance) +
        gas *
          vtkGodRays::MediumDepth(
            0.0, eye, vtkGodRays::dot(light, up) / distance, second.ScaleHeight, distance);
    } while (depth > 10.0);
    filter->SetLight(light.x, light.y, light.z, 1.0);
    const double most = random.Uniform(0.05, 1.0);
    if (scene >= 60 && !all && chosen.count(i) == 0)
    {
      continue;
    }
    const double error = CompareEnds(
      filter, [&](int x, int y) { return most * far * (1 + (x + y) % 7) / 7.0; },
      [&](const Ray& ray, double end)
      {
        const double length = vtkGodRays::length(ray.Step);
        const Vec3 along = ray.Step / length;
        const Vec3 to = light - ray.Origin;
        const double nearest = 0.28 * GetPixelSize(filter) *
          (filter->GetParallelProjection() ? 1.0 : light.z * light.z / vtkGodRays::length(light));
        const vtkGodRays::LitRay lit = { 0, vtkGodRays::dot(to, along),
          std::max(nearest, vtkGodRays::length(vtkGodRays::cross(to, along))),
          eye + vtkGodRays::dot(up, ray.Origin), vtkGodRays::dot(up, along),
          eye + vtkGodRays::dot(up, light), 0.0, 0.0, 0.0, { 0.0, 0.0 }, 0 };
        // Steps of angle and of length.
        constexpr int parts = 60;
        std::array<double, 2 * parts> places;
        for (int k = 0; k < parts; ++k)
        {
          const double t = (k + 1.0) / parts;
          places[2 * k] = vtkGodRays::MediumPlace(lit, 0.0, end * length, t);
          places[2 * k + 1] = t * end * length;
        }
        std::sort(places.begin(), places.end());
        double sum = 0.0;
        double begin = 0.0;
        for (const double place : places)
        {
          sum += vtkGodRays::MediumAirlight(first, second, lit, begin, place);
          begin = place;
        }
        return sum;
      });
    EXPECT_LE(error, 2e-3) << scene << " " << filter->Describe() << " eye " << eye / scale
                           << " far " << far / scale << " light " << light.x / scale << " "
                           << light.y / scale << " " << light.z / scale << " up "
                           << vtkGodRays::dot(up, light) / scale << " depths " << b * scale << " "
                           << gas * scale;
    worst = std::max(worst, error);
  }
  std::cout << "largest difference " << worst << " of the peak\n";
}

//------------------------------------------------------------------------------
// Layers whose density hardly falls in the picture are no layers.
TEST(Airlight, PointLightsInThickLayersShineAsInNone)
{
  const Picture ends = MakePicture(
    Width, Height, [](int x, int y) { return (x / 5 + y / 4) % 3 == 0 ? 2.0 + 0.1 * x : sky; });
  for (const double z : { -6.0, 0.0, 2.0 })
  {
    vtkNew<Filter> filter;
    filter->SetFarLimit(20.0);
    filter->SetLight(0.5, 0.7, z, 1.0);
    const Picture without = filter->Draw(ends);
    filter->SetScaleHeight(1e8);
    const Picture with = filter->Draw(ends);
    EXPECT_LE(GetLargestDifference(with, without), 1e-3 * without.GetMaximum());
    filter->SetScaleHeight(1.0);
    EXPECT_GT(GetLargestDifference(filter->Draw(ends), without), 0.05 * without.GetMaximum());
  }
}

//------------------------------------------------------------------------------
// Before, beside and behind the eye, fading and not, in layers: the ground truth.
TEST(Airlight, SpotlightsShineInTheirCones)
{
  struct Case
  {
    Vec3 Light;
    Vec3 Axis;
    double Exponent;
    double ScaleHeight;
  };
  const Case cases[] = { { { 0.3, 1.5, -9.0 }, { 0.0, -0.3, 1.0 }, 0.0, 0.0 },
    { { 0.3, 1.5, -9.0 }, { 0.0, -0.3, 1.0 }, 1.0, 0.0 },
    { { 6.0, 1.0, -3.0 }, { -1.0, 0.0, -0.4 }, 4.0, 0.0 },
    { { 0.7, 0.9, 3.0 }, { 0.0, 0.1, -1.0 }, 0.0, 2.0 },
    { { 0.5, 2.6, -5.0 }, { 0.0, -1.0, 0.0 }, 1.0, 2.0 },
    { { 6.0, 1.0, -3.0 }, { -1.0, 0.1, -0.4 }, 1.0, 1.0 } };
  for (const Case& each : cases)
  {
    for (const bool parallel : { false, true })
    {
      vtkNew<Reference> reference;
      vtkNew<Filter> filter;
      for (vtkGodRaysMediumFilter* either : { static_cast<vtkGodRaysMediumFilter*>(reference),
             static_cast<vtkGodRaysMediumFilter*>(filter) })
      {
        Prepare(either, Lights[0], 0.1);
        either->SetLight(each.Light.x, each.Light.y, each.Light.z, 1.0);
        either->SetConeAngle(25.0);
        either->SetSpotDirection(each.Axis.x, each.Axis.y, each.Axis.z);
        either->SetSpotExponent(each.Exponent);
        either->SetScaleHeight(each.ScaleHeight);
        either->SetParallelProjection(parallel);
        either->SetParallelScale(3.5);
      }
      reference->SetSize(120, 68);
      reference->SetTolerance(1e-4);
      reference->Update();
      const vtkIdType left = FindLight(reference, reference->GetSize());
      const Error error = Compare(reference->GetOutput(), filter, left);
      filter->SetConeAngle(180.0);
      const Error everywhere = Compare(reference->GetOutput(), filter, left);
      std::cout << (parallel ? "parallel: " : "perspective: ") << error.Largest
                << ", root mean square " << error.Rms << ", without cone " << everywhere.Rms
                << "\n";
      EXPECT_LE(error.Largest, 2e-3) << filter->Describe();
      EXPECT_GT(everywhere.Rms, 3.0 * error.Rms);
    }
  }
}

//------------------------------------------------------------------------------
// A point light, and a directional one, over a small planet: the ground truth.
TEST(Airlight, LightsShineOverAPlanet)
{
  for (const auto& [parallel, light] :
    { std::pair<bool, double>{ false, 1.0 }, { true, 1.0 }, { false, 0.0 }, { true, 0.0 } })
  {
    vtkNew<Reference> reference;
    vtkNew<Filter> filter;
    for (vtkGodRaysMediumFilter* either : { static_cast<vtkGodRaysMediumFilter*>(reference),
           static_cast<vtkGodRaysMediumFilter*>(filter) })
    {
      Prepare(either, Lights[0], 10.0);
      either->SetFarLimit(10.0);
      either->SetParallelProjection(parallel);
      either->SetParallelScale(4.0);
      either->SetLight(1.0, light > 0.0 ? 2.0 : 0.4, -6.0, light);
      either->SetScaleHeight(1.0);
      either->SetGroundLevel(-7.0); // no ray meets it
      either->SetPlanetRadius(500.0);
    }
    reference->SetSize(64, 36);
    reference->SetTolerance(1e-4);
    reference->Update();
    const Error round = Compare(reference->GetOutput(), filter);
    filter->SetPlanetRadius(0.0);
    const Error flat = Compare(reference->GetOutput(), filter);
    std::cout << "round " << round.Largest << ", flat " << flat.Largest << "\n";
    EXPECT_LE(round.Largest, 2e-3);
    EXPECT_GT(flat.Largest, 5e-3);
  }
}

//------------------------------------------------------------------------------
// Two components, one with two phase functions: sums of what each would be with the others' extinction.
TEST(Airlight, PhaseFunctionsAndComponentsAddUp)
{
  const Picture ends = MakePicture(80, 60, [](int x, int y) { return 2.0 + 0.1 * x + 0.2 * y; });
  vtkNew<Filter> filter;
  const NamedLight light = { "", { 0.2, 0.3, -1.0 } };
  Prepare(filter, light, 0.1);
  filter->SetAsymmetry(0.9);
  filter->SetSecondAsymmetry(-0.8);
  filter->SetSecondWeight(0.3);
  filter->SetGasScatteringCoefficient(0.02, 0.03, 0.05);
  const Picture whole = filter->Draw(ends);
  ASSERT_EQ(whole.Components, 3);
  const double extinction[3] = { 0.12, 0.13, 0.15 };
  const auto single = [&](int kind, double g, const double scattering[3])
  {
    vtkNew<Filter> one;
    Prepare(one, light, 0.1);
    one->SetPhaseFunction(kind);
    one->SetAsymmetry(g);
    one->SetScatteringCoefficient(scattering);
    one->SetAbsorptionCoefficient(
      extinction[0] - scattering[0], extinction[1] - scattering[1], extinction[2] - scattering[2]);
    return one->Draw(ends);
  };
  const double forward[3] = { 0.07, 0.07, 0.07 };
  const double backward[3] = { 0.03, 0.03, 0.03 };
  const double gas[3] = { 0.02, 0.03, 0.05 };
  const Picture parts[3] = { single(Filter::HENYEY_GREENSTEIN, 0.9, forward),
    single(Filter::HENYEY_GREENSTEIN, -0.8, backward), single(Filter::RAYLEIGH, 0.0, gas) };
  double worst = 0.0;
  for (std::size_t i = 0; i < whole.Values.size(); ++i)
  {
    const double sum = parts[0].Values[i] + parts[1].Values[i] + parts[2].Values[i];
    worst = std::max(worst, std::abs(whole.Values[i] - sum));
  }
  std::cout << "largest difference " << worst / whole.GetMaximum() << "\n";
  EXPECT_LE(worst, 1e-5 * whole.GetMaximum());
}

//------------------------------------------------------------------------------
// What is seen through a medium and what it scatters, of light as bright as what is seen from everywhere,
// is no more than that light.
TEST(Airlight, GivesNoMoreThanItTakes)
{
  Random random{ MakeGenerator(43) };
  for (int i = 0; i < 40; ++i)
  {
    vtkNew<Filter> filter;
    const double scale = random.Log(0.1, 10.0);
    const bool layered = i % 2 == 1;
    filter->SetFarLimit(random.Log(0.1, 100.0));
    const double b = random.Log(1e-3, 10.0);
    const double albedo = random.Uniform(0.1, 1.0);
    filter->SetScatteringCoefficient(b * albedo, b * albedo, b * albedo);
    filter->SetAbsorptionCoefficient(b * (1.0 - albedo), b * (1.0 - albedo), b * (1.0 - albedo));
    filter->SetScaleHeight(layered ? scale : 0.0);
    filter->SetPhaseFunction(Filter::ISOTROPIC);
    filter->SetLight(random.Uniform(-1, 1), 1.0, random.Uniform(-1, 1), 0.0);
    filter->SetLightColor(4.0 * vtkMath::Pi(), 4.0 * vtkMath::Pi(), 4.0 * vtkMath::Pi());
    const Picture result = filter->Draw(MakePicture(Width, Height, [](int, int) { return sky; }));
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const Ray ray = GetRay(filter, x, y);
        const double length = vtkGodRays::length(ray.Step);
        const double way = filter->GetFarLimit() * length;
        const double depth =
          layered ? vtkGodRays::ExponentialDepth(b, 0.0, ray.Step.y / length, scale, way) : b * way;
        ASSERT_LE(result.Get(x, y) + std::exp(-depth), 1.0 + 2e-3) << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The ranges that setters take, ends of rays near and far, lights in the eye and beyond the ends.
TEST(Airlight, IsFiniteForAnyMedium)
{
  Random random{ MakeGenerator(44) };
  const Picture ends = MakePicture(
    Width, Height, [](int x, int y) { return (x / 5 + y / 4) % 3 == 0 ? 2.0 + 0.1 * x : sky; });
  for (int i = 0; i < 80; ++i)
  {
    vtkNew<Filter> filter;
    const double b = random.Log(1e-12, 1e3);
    filter->SetScatteringCoefficient(b, 0.5 * b, b);
    filter->SetAbsorptionCoefficient(0.0, random.Log(1e-12, 1e3), 0.0);
    filter->SetFarLimit(random.Log(1e-6, 1e9));
    filter->SetParallelProjection(i % 2 == 1);
    filter->SetParallelScale(random.Log(1e-3, 1e3));
    filter->SetPhaseFunction(i % (vtkGodRaysLastPhaseFunction + 1));
    filter->SetAsymmetry(i % 7 == 0 ? 0.99 : random.Uniform(-0.99, 0.99));
    const Vec3 light = random.Direction() * (i % 11 == 0 ? 0.0 : random.Log(1e-6, 1e9));
    const bool point = i % 4 < 2;
    if (point)
    {
      filter->SetLight(light.x, light.y, i % 13 == 0 ? 0.0 : light.z, 1.0);
    }
    else
    {
      const Vec3 direction = random.Direction();
      filter->SetLight(direction.x, direction.y, direction.z, 0.0);
    }
    if (!point || i % 3 == 0)
    {
      filter->SetScaleHeight(random.Log(1e-6, 1e9));
      filter->SetGroundLevel(random.Uniform(-1.0, 1.0) * random.Log(1e-6, 1e9));
      filter->SetGasScatteringCoefficient(b, b, random.Log(1e-12, 1e3));
      filter->SetGasScaleHeight(i % 3 == 0 ? 0.0 : random.Log(1e-6, 1e9));
    }
    for (const double value : filter->Draw(ends).Values)
    {
      ASSERT_TRUE(value >= 0.0 && value < 1e39) << i << " " << filter->Describe();
    }
  }
}

//------------------------------------------------------------------------------
TEST(Airlight, IsContinuousWhereAPointLightPassesTheEye)
{
  const Picture ends = MakePicture(
    Width, Height, [](int x, int y) { return std::hypot(x - 30.0, y - 15.0) < 8.0 ? 3.0 : sky; });
  vtkNew<Filter> filter;
  filter->SetFarLimit(20.0);
  Picture before;
  for (const double z : { -1e-2, -1e-4, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-4, 1e-2 })
  {
    filter->SetLight(1.5, 0.8, z, 1.0);
    const Picture now = filter->Draw(ends);
    if (!before.Values.empty())
    {
      const double difference = GetLargestDifference(now, before) / now.GetMaximum();
      std::cout << "z " << z << ": largest difference from the one before " << difference << "\n";
      EXPECT_LE(difference, 0.03);
    }
    before = now;
  }
}

//------------------------------------------------------------------------------
TEST(Airlight, BytesDoNotDependOnThreads)
{
  const Picture ends = MakePicture(
    200, 130, [](int x, int y) { return (x / 9 + y / 7) % 3 == 0 ? 2.0 + 0.02 * x : sky; });
  for (const auto& [point, scale] : { std::pair(false, 2.0), { true, 0.0 }, { true, 2.0 } })
  {
    Picture pictures[2];
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&]()
        {
          vtkNew<Filter> filter;
          filter->SetLight(0.5, 0.7, -4.0, point ? 1.0 : 0.0);
          filter->SetScaleHeight(scale);
          pictures[threads - 1] = filter->Draw(ends);
        });
    }
    EXPECT_EQ(GetLargestDifference(pictures[0], pictures[1]), 0.0);
    EXPECT_GT(pictures[0].GetMaximum(), 0.0);
  }
}
