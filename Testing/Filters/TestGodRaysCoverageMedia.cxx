// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows from depth images where airlight comes from a table: point lights, media of exponential density.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysCoverageFilter.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkDoubleArray.h"
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
using Filter = vtkGodRaysCoverageFilter;
using Reference = vtkGodRaysSingleScatteringReference;

constexpr int Width = 64;
constexpr int Height = 36;
const double sky = std::numeric_limits<double>::infinity();

// Nothing but where view rays end.
vtkSmartPointer<vtkImageData> MakeEnds(const std::function<double(int, int)>& getEnd)
{
  auto image = MakeImage(MakePicture(Width, Height, [](int, int) { return sky; }));
  vtkNew<vtkDoubleArray> ends;
  ends->SetName("End");
  ends->SetNumberOfTuples(Width * Height);
  for (int i = 0; i < Width * Height; ++i)
  {
    ends->SetValue(i, getEnd(i % Width, i / Width));
  }
  image->GetPointData()->AddArray(ends);
  return image;
}

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
  filter->SetInputData(MakeEnds(getEnd));
  filter->SetEndArrayName("End");
  filter->Update();
  const Picture picture = FromImage(filter->GetOutput());
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
// To the far limit, and to nearer ends, against the integral; media, lights and scales of any kind.
TEST(CoverageMedia, PointLightsShineAsTheIntegral)
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
    EXPECT_LE(error, 2e-3) << i << " " << filter->GetPlan() << " light " << light.x / scale << " "
                           << light.y / scale << " " << light.z / scale << " optical depth "
                           << b * scale * 20.0;
    worst = std::max(worst, error);
  }
  std::cout << "largest difference " << worst << " of the peak\n";
}

//------------------------------------------------------------------------------
// One component of exponential density, against its closed form.
TEST(CoverageMedia, LayersShineAsTheIntegral)
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
    EXPECT_LE(error, 2e-3) << i << " " << filter->GetPlan() << " eye " << eye / scale << " far "
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
TEST(CoverageMedia, PointLightsInLayersShineAsTheIntegral)
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
    EXPECT_LE(error, 2e-3) << scene << " " << filter->GetPlan() << " eye " << eye / scale << " far "
                           << far / scale << " light " << light.x / scale << " " << light.y / scale
                           << " " << light.z / scale << " up " << vtkGodRays::dot(up, light) / scale
                           << " depths " << b * scale << " " << gas * scale;
    worst = std::max(worst, error);
  }
  std::cout << "largest difference " << worst << " of the peak\n";
}

//------------------------------------------------------------------------------
// Layers whose density hardly falls in the picture are no layers.
TEST(CoverageMedia, PointLightsInThickLayersShineAsInNone)
{
  const Picture depths = MakePicture(
    Width, Height, [](int x, int y) { return (x / 5 + y / 4) % 3 == 0 ? 2.0 + 0.1 * x : sky; });
  for (const double z : { -6.0, 0.0, 2.0 })
  {
    vtkNew<Filter> filter;
    filter->SetFarLimit(20.0);
    filter->SetLight(0.5, 0.7, z, 1.0);
    const Picture without = Scatter(filter, depths);
    filter->SetScaleHeight(1e8);
    const Picture with = Scatter(filter, depths);
    EXPECT_LE(GetLargestDifference(with, without), 1e-3 * without.GetMaximum());
    filter->SetScaleHeight(1.0);
    EXPECT_GT(GetLargestDifference(Scatter(filter, depths), without), 0.05 * without.GetMaximum());
  }
}

//------------------------------------------------------------------------------
// Before, beside and behind the eye, fading and not, in layers, through slats: the ground truth.
TEST(CoverageMedia, SpotlightsAreShadowed)
{
  const auto scenes = MakeScenes(10);
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
      reference->SetNumberOfLayers(1);
      reference->Update();
      const Error open = Compare(reference->GetOutput(), filter);
      reference->SetInputData(scenes[1].Occluders);
      reference->Update();
      const Error shadowed = Compare(reference->GetOutput(), filter);
      filter->SetConeAngle(180.0);
      const Error everywhere = Compare(reference->GetOutput(), filter);
      std::cout << (parallel ? "parallel: " : "perspective: ") << open.Largest << ", shadowed "
                << shadowed.Rms << ", without cone " << everywhere.Rms << "\n";
      EXPECT_LE(open.Largest, 2e-3) << filter->GetPlan();
      EXPECT_LE(shadowed.Rms, 0.01);
      EXPECT_GT(everywhere.Rms, 3.0 * shadowed.Rms);
    }
  }
}

//------------------------------------------------------------------------------
// A point light, and a directional one, over a small planet: the ground truth.
TEST(CoverageMedia, LightsShineOverAPlanet)
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
// Shadows of point lights before, beside, above and behind things, and behind the eye: the ground truth.
// Without shadows it would be far off. Each light is in both views and both media, one of each with each
// scene; GODRAYS_LONG takes all.
TEST(CoverageMedia, PointLightsCastShadows)
{
  const bool all = std::getenv("GODRAYS_LONG") != nullptr;
  const double lights[][3] = { { 0.3, 0.5, -12.0 }, { 2.0, 1.0, -7.0 }, { -3.0, 4.0, -6.0 },
    { 1.5, 2.0, 0.0 }, { 0.7, 0.9, 3.0 }, { 6.0, 1.0, -3.0 } };
  for (const Scene& scene : MakeScenes(10))
  {
    if (scene.Name != "sphere" && scene.Name != "slats")
    {
      continue;
    }
    int turn = 0;
    for (const double* light : lights)
    {
      const int own = scene.Name == "sphere" ? turn % 4 : 3 - turn % 4;
      ++turn;
      for (int kind = 0; kind < 4; ++kind)
      {
        if (!all && kind != own)
        {
          continue;
        }
        const bool parallel = kind % 2 == 1;
        const bool layered = kind >= 2;
        vtkNew<Reference> reference;
        vtkNew<Filter> filter;
        for (vtkGodRaysMediumFilter* either : { static_cast<vtkGodRaysMediumFilter*>(reference),
               static_cast<vtkGodRaysMediumFilter*>(filter) })
        {
          Prepare(either, Lights[0], 0.1);
          either->SetLight(light[0], light[1], light[2], 1.0);
          either->SetParallelProjection(parallel);
          either->SetParallelScale(3.5);
          either->SetScaleHeight(layered ? 2.0 : 0.0);
          either->SetGroundLevel(-1.0);
        }
        reference->SetInputData(scene.Occluders);
        reference->SetSize(240, 135);
        reference->SetTolerance(1e-3);
        reference->SetNumberOfLayers(1);
        reference->Update();
        const Picture truth = FromImage(reference->GetOutput());
        Compare(reference->GetOutput(), filter);
        const Picture shadowed = FromImage(filter->GetOutput());
        // The same ends of rays, and nothing that casts a shadow.
        auto open = MakeImage(MakePicture(240, 135, [](int, int) { return sky; }));
        open->GetPointData()->AddArray(reference->GetOutput()->GetPointData()->GetArray("End"));
        filter->SetInputData(open);
        filter->SetInputArrayToProcess(
          0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "ImageScalars");
        filter->Update();
        const Picture unshadowed = FromImage(filter->GetOutput());
        // Next to the light one pixel is as bright as all others: each by its own unshadowed light.
        double squares = 0.0;
        double without = 0.0;
        for (std::size_t i = 0; i < shadowed.Values.size(); ++i)
        {
          const double all = unshadowed.Values[i];
          const double expected = std::min(truth.Values[3 * i], all);
          squares += std::pow((shadowed.Values[i] - expected) / all, 2);
          without += std::pow((all - expected) / all, 2);
        }
        const double rms = std::sqrt(squares / shadowed.Values.size());
        const double wrong = std::sqrt(without / shadowed.Values.size());
        std::cout << scene.Name << " " << light[0] << " " << light[1] << " " << light[2]
                  << (parallel ? " parallel" : "") << (layered ? " layered" : "") << ": rms " << rms
                  << ", without shadows " << wrong << "\n";
        // Slats are a few pixels wide, and known to half a pixel.
        EXPECT_LE(rms, scene.Name == "slats" ? 0.04 : 0.025);
        EXPECT_GT(wrong, 3.0 * rms);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Air and dust, each of its own scale height and colour, over a scene: the ground truth.
TEST(CoverageMedia, LayersAreShadowed)
{
  const auto scenes = MakeScenes(10);
  for (const int index : { 0, 2, 4 })
  {
    const NamedLight& light = Lights[index];
    for (const bool fogFirst : { true, false }) // which component is which changes nothing
    {
      const bool parallel = index == 2;
      vtkNew<Reference> reference;
      vtkNew<Filter> filter;
      for (vtkGodRaysMediumFilter* either : { static_cast<vtkGodRaysMediumFilter*>(reference),
             static_cast<vtkGodRaysMediumFilter*>(filter) })
      {
        const double fog[3] = { 0.1, 0.1, 0.1 };
        const double gas[3] = { 0.01, 0.02, 0.05 };
        Prepare(either, light, 0.1);
        either->SetParallelProjection(parallel);
        either->SetParallelScale(3.5);
        either->SetGroundLevel(-1.5);
        either->SetScatteringCoefficient(fogFirst ? fog : gas);
        either->SetPhaseFunction(fogFirst ? Filter::HENYEY_GREENSTEIN : Filter::RAYLEIGH);
        either->SetScaleHeight(fogFirst ? 1.2 : 8.0);
        either->SetGasScatteringCoefficient(fogFirst ? gas : fog);
        either->SetGasPhaseFunction(fogFirst ? Filter::RAYLEIGH : Filter::HENYEY_GREENSTEIN);
        either->SetGasAsymmetry(0.6);
        either->SetGasScaleHeight(fogFirst ? 8.0 : 1.2);
      }
      reference->SetInputData(scenes[1].Occluders);
      reference->SetSize(112, 63);
      reference->SetTolerance(1e-4);
      reference->SetNumberOfLayers(1);
      reference->Update();
      const Picture truth = FromImage(reference->GetOutput());
      const double red = Compare(reference->GetOutput(), filter).Rms;
      const Picture actual = FromImage(filter->GetOutput());
      ASSERT_EQ(actual.Components, 3);
      double squares = 0.0;
      for (std::size_t i = 0; i < truth.Values.size(); ++i)
      {
        squares += std::pow(actual.Values[i] - truth.Values[i], 2);
      }
      const double rms = std::sqrt(squares / truth.Values.size()) / truth.GetMaximum();
      std::cout << light.Name << (fogFirst ? " fog first" : " gas first") << ": rms " << rms
                << ", red " << red << "\n";
      // Half a pixel of an edge is more of so small a picture than of others.
      EXPECT_LE(rms, 0.01);
      EXPECT_LE(red, 0.013);
    }
  }
}

//------------------------------------------------------------------------------
// What is seen through a medium and what it scatters, of light as bright as what is seen from everywhere,
// is no more than that light.
TEST(CoverageMedia, GivesNoMoreThanItTakes)
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
    filter->SetInputData(MakeEnds([](int, int) { return sky; }));
    filter->Update();
    const Picture result = FromImage(filter->GetOutput());
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
// The ranges that setters take, things in the way, lights in the eye and in the things.
TEST(CoverageMedia, IsFiniteForAnyMedium)
{
  Random random{ MakeGenerator(44) };
  const Picture depths = MakePicture(
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
    for (const double value : Scatter(filter, depths).Values)
    {
      ASSERT_TRUE(value >= 0.0 && value < 1e39) << i << " " << filter->GetPlan();
    }
  }
}

//------------------------------------------------------------------------------
TEST(CoverageMedia, IsContinuousWhereAPointLightPassesTheEye)
{
  const Picture depths = MakePicture(
    Width, Height, [](int x, int y) { return std::hypot(x - 30.0, y - 15.0) < 8.0 ? 3.0 : sky; });
  vtkNew<Filter> filter;
  filter->SetFarLimit(20.0);
  Picture before;
  for (const double z : { -1e-2, -1e-4, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-4, 1e-2 })
  {
    filter->SetLight(1.5, 0.8, z, 1.0);
    const Picture now = Scatter(filter, depths);
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
TEST(CoverageMedia, BytesDoNotDependOnThreads)
{
  const Picture depths = MakePicture(
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
          pictures[threads - 1] = Scatter(filter, depths);
        });
    }
    EXPECT_EQ(GetLargestDifference(pictures[0], pictures[1]), 0.0);
    EXPECT_GT(pictures[0].GetMaximum(), 0.0);
  }
}
