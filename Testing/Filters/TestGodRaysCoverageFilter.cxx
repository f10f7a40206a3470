// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows from depth images: against closed forms, the ground truth, and the filter's own promises.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysCoverageFilter.h"
#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSingleScatteringReference.h"
#include "vtkGodRaysSweepKernels.h"

#include "vtkSMPTools.h"

#include <cstring>
#include <limits>

using namespace GodRaysFiltersTesting;
using namespace GodRaysMediumScenes;
using vtkGodRays::Vec3;

namespace
{
using Filter = vtkGodRaysCoverageFilter;
using Reference = vtkGodRaysSingleScatteringReference;

const double sky = std::numeric_limits<double>::infinity();

void Prepare(vtkGodRaysMediumFilter* filter, double x, double y, double z, double scattering = 0.1)
{
  const NamedLight light = { "", { x, y, z } };
  Prepare(filter, light, scattering);
}

// A sphere and something like the ground before the sky.
Picture MakeDepths(int width, int height)
{
  return MakePicture(width, height,
    [&](int x, int y)
    {
      if (std::hypot(x - 0.4 * width, y - 0.6 * height) < 0.2 * height)
      {
        return 5.0;
      }
      return y < 0.25 * height ? 1.5 / (0.55 - 1.1 * y / height) : sky;
    });
}
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, IsTheAirlightWithoutOccluders)
{
  std::mt19937 generator = MakeGenerator(31);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  double worst = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    vtkNew<Filter> filter;
    const Vec3 light(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
    Prepare(filter, light.x, light.y, light.z);
    const double b = std::exp(uniform(std::log(1e-12), std::log(1e3)));
    const double far = std::exp(uniform(std::log(1e-3), std::log(1e6)));
    const bool parallel = i % 3 == 0;
    filter->SetScatteringCoefficient(b, b, b);
    filter->SetFarLimit(far);
    filter->SetParallelProjection(parallel);
    filter->SetPhaseFunction(i % (vtkGodRaysLastPhaseFunction + 1));
    filter->SetAsymmetry(uniform(-0.9, 0.9));
    const int width = 37;
    const int height = 23;
    const Picture result =
      Scatter(filter, MakePicture(width, height, [](int, int) { return sky; }));
    ASSERT_EQ(result.Components, 1);
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const double pixel = 2.0 / height * std::tan(vtkMath::Pi() / 6.0);
        const Vec3 view = parallel
          ? Vec3(0.0, 0.0, -1.0)
          : Vec3((x + 0.5 - 0.5 * width) * pixel, (y + 0.5 - 0.5 * height) * pixel, -1.0);
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
// A half cylinder of shadow, whose ends on each ray have a closed form, at two sizes.
TEST(CoverageFilter, ConvergesToTheShadowOfASphere)
{
  Mesh mesh;
  mesh.AddSphere(0.25, 0.25, -6.0, 1.0, 64);
  const double bounds[2][5] = { { 0.0055, 0.0006, 0.0004, 0.0004, 0.0018 },
    { 0.0038, 0.0004, 0.0003, 0.0003, 0.0011 } };
  for (int i = 0; i < 5; ++i)
  {
    for (const int size : { 1, 2 })
    {
      vtkNew<Reference> reference;
      Prepare(reference, Lights[i], 0.1);
      reference->SetInputData(mesh.Get());
      reference->SetSize(160 * size, 90 * size);
      reference->SetNumberOfLayers(1);
      reference->Update();
      vtkNew<Filter> filter;
      Prepare(filter, Lights[i], 0.1);
      const double rms = Compare(reference->GetOutput(), filter).Rms;
      std::cout << Lights[i].Name << " " << 160 * size << " x " << 90 * size << ": rms " << rms
                << "\n";
      EXPECT_LE(rms, bounds[size - 1][i]);
    }
  }
}

//------------------------------------------------------------------------------
// A wall across the view, lit from above at a slant: a plane divides light and shadow.
TEST(CoverageFilter, ASlabCastsItsShadow)
{
  const int width = 96;
  const int height = 96;
  const double pixel = 2.0 / height * std::tan(vtkMath::Pi() / 6.0);
  const double z = 5.0;
  const double thick = 0.5;
  // Solid from row 40 up to row 60.
  const double low = (40.0 - 0.5 * height) * pixel * z;
  const double high = (60.0 - 0.5 * height) * pixel * z;
  Mesh mesh;
  mesh.AddBox(-100.0, 100.0, low, high, -z - thick, -z);
  vtkNew<Reference> reference;
  Prepare(reference, 0.0, 2.0, -1.0);
  reference->SetInputData(mesh.Get());
  reference->SetSize(width, height);
  reference->SetNumberOfLayers(1);
  reference->Update();
  vtkNew<Filter> filter;
  Prepare(filter, 0.0, 2.0, -1.0);
  const Error error = Compare(reference->GetOutput(), filter);
  std::cout << "rms " << error.Rms << " largest " << error.Largest << "\n";
  EXPECT_LE(error.Rms, 4e-3);

  // In closed form at one pixel in the shadow: from below, the ray sees the wall's two edges.
  const int row = 10;
  const double slope = (row + 0.5 - 0.5 * height) * pixel;
  const double length = std::hypot(1.0, slope);
  // (y, depth) of an edge moves along -(2, 1): slope Z = y - 2 (depth - Z)
  const auto hit = [&](double y, double depth) { return (y - 2.0 * depth) / (slope - 2.0); };
  const double begin = hit(high, z + thick) * length;
  const double last = hit(low, z) * length;
  const double first = std::min(hit(high, z), std::min(begin, last) / length) * length;
  const double end = std::max(hit(low, z + thick) * length, last);
  const double expected = 0.1 *
    vtkGodRays::PhaseHenyeyGreenstein((2.0 * slope + 1.0) / length / std::sqrt(5.0), 0.6) *
    (vtkGodRays::DirectionalAirlight(0.1, 0.0, std::min(first, begin), 0.0, 0.0) +
      vtkGodRays::DirectionalAirlight(0.1, end, 20.0 * length, 0.0, 0.0));
  const double centre = reference->GetOutput()->GetScalarComponentAsDouble(width / 2, row, 0, 0);
  EXPECT_NEAR(expected / centre, 1.0, 2e-3); // half a pixel beside the plane of the light
  EXPECT_NEAR(
    filter->GetOutput()->GetScalarComponentAsDouble(width / 2, row, 0, 0) / centre, 1.0, 2e-2);
}

//------------------------------------------------------------------------------
// Light and scattering are linear; depths of parts of a scene hide no more than the scene.
TEST(CoverageFilter, AddsUp)
{
  const Picture depths = MakeDepths(80, 60);
  vtkNew<Filter> filter;
  Prepare(filter, 0.2, 0.3, -1.0);
  const Picture once = Scatter(filter, depths);
  filter->SetLightColor(3.0, 3.0, 3.0);
  Picture thrice = Scatter(filter, depths);
  for (double& value : thrice.Values)
  {
    value /= 3.0;
  }
  EXPECT_LE(GetLargestDifference(once, thrice), 1e-6 * once.GetMaximum());

  filter->SetLightColor(1.0, 2.0, 0.0);
  const Picture colored = Scatter(filter, depths);
  ASSERT_EQ(colored.Components, 3);
  filter->SetLightColor(1.0, 1.0, 1.0);
  filter->SetScatteringCoefficient(0.1, 0.3, 0.1);
  const Picture tinted = Scatter(filter, depths);
  ASSERT_EQ(tinted.Components, 3);
  filter->SetScatteringCoefficient(0.3, 0.3, 0.3);
  const Picture dense = Scatter(filter, depths);
  for (int y = 0; y < 60; ++y)
  {
    for (int x = 0; x < 80; ++x)
    {
      EXPECT_NEAR(colored.Get(x, y, 1), 2.0 * once.Get(x, y), 1e-6);
      EXPECT_EQ(colored.Get(x, y, 2), 0.0);
      EXPECT_NEAR(tinted.Get(x, y, 0), once.Get(x, y), 1e-7);
      EXPECT_NEAR(tinted.Get(x, y, 1), dense.Get(x, y), 1e-7);
    }
  }
  // More matter, less light.
  Picture less = depths;
  for (int i = 0; i < 80 * 15; ++i)
  {
    less.Values[i] = sky;
  }
  filter->SetScatteringCoefficient(0.1, 0.1, 0.1);
  const Picture more = Scatter(filter, less);
  for (int i = 80 * 15; i < 80 * 60; ++i)
  {
    EXPECT_GE(more.Values[i], once.Values[i] - 1e-6);
  }
}

//------------------------------------------------------------------------------
// The union of hidden intervals does not depend on the order of solid layers.
TEST(CoverageFilter, OrderOfLayersDoesNotMatter)
{
  const int width = 64;
  const int height = 48;
  Picture layers(width, height, 4);
  Picture turned(width, height, 4);
  for (int i = 0; i < width * height; ++i)
  {
    const bool solid = (i / width / 6 + i % width / 8) % 3 == 0;
    const double front = 2.0 + (i % width / 8) % 4;
    for (int layer = 0; layer < 2; ++layer)
    {
      const double z = solid ? front + 3.0 * layer : sky;
      layers.Values[4 * i + 2 * layer] = z;
      layers.Values[4 * i + 2 * layer + 1] = z + 0.7;
      turned.Values[4 * i + 2 * (1 - layer)] = z;
      turned.Values[4 * i + 2 * (1 - layer) + 1] = z + 0.7;
    }
  }
  vtkNew<Filter> filter;
  Prepare(filter, 0.9, 0.5, -1.0);
  const Picture a = Scatter(filter, layers);
  const Picture b = Scatter(filter, turned);
  double worst = 0.0;
  for (int i = 0; i < width * height; ++i)
  {
    // The first of the two decides how far a pixel sees.
    if (std::isinf(layers.Values[4 * i]))
    {
      worst = std::max(worst, std::abs(a.Values[i] - b.Values[i]));
    }
  }
  EXPECT_LE(worst, 2e-6 * a.GetMaximum());
  EXPECT_EQ(filter->GetNumberOfOverflows(), 0);
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, IsFiniteForAnyLight)
{
  const int width = 48;
  const int height = 27;
  Picture depths = MakeDepths(width, height);
  depths.At(30, 12) = std::nan("");
  depths.At(31, 20) = -3.0;
  depths.At(8, 20) = 0.0;
  const double pixel = 2.0 / height * std::tan(vtkMath::Pi() / 6.0);
  for (const bool parallel : { false, true })
  {
    for (const double px : { 0.0, 10.0, 10.5, 23.5, 47.0, 47.5, -0.5, -1.0, -300.0, 1e9 })
    {
      for (const double py : { 0.0, 13.0, 13.5, 26.0, 26.5, -1.0, 1e5 })
      {
        for (const double side : { 1.0, -1.0, 0.0 })
        {
          if (side == 0.0 && px == -1.0 && py == 0.0)
          {
            continue; // no direction
          }
          vtkNew<Filter> filter;
          Prepare(filter, side == 0.0 ? px + 1.0 : side * (px - 23.5) * pixel,
            side == 0.0 ? py : side * (py - 13.0) * pixel, -side);
          filter->SetParallelProjection(parallel);
          for (const double value : Scatter(filter, depths).Values)
          {
            ASSERT_TRUE(value >= 0.0 && value < 1e3) << px << " " << py << " " << side;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, IsContinuousWhereTheLightPassesTheSide)
{
  const Picture depths = MakeDepths(96, 54);
  vtkNew<Filter> filter;
  Picture before;
  for (const double z : { -1e-3, -1e-5, -1e-7, -1e-12, 0.0, 1e-12, 1e-7, 1e-5, 1e-3 })
  {
    Prepare(filter, 0.8, 0.6, z);
    const Picture now = Scatter(filter, depths);
    if (!before.Values.empty())
    {
      double squares = 0.0;
      for (std::size_t i = 0; i < now.Values.size(); ++i)
      {
        squares += std::pow(now.Values[i] - before.Values[i], 2);
      }
      const double rms = std::sqrt(squares / now.Values.size()) / now.GetMaximum();
      std::cout << "z " << z << ": rms difference from the one before " << rms << "\n";
      EXPECT_LE(rms, 5e-3);
    }
    before = now;
  }
}

//------------------------------------------------------------------------------
// A light on the pixel's centre, behind a surface and before the sky.
TEST(CoverageFilter, TheLightsOwnPixel)
{
  vtkNew<Filter> filter;
  Prepare(filter, 0.0, 0.0, -1.0);
  Picture depths = MakePicture(31, 31, [](int, int) { return sky; });
  const Picture open = Scatter(filter, depths);
  EXPECT_GT(open.Get(15, 15), open.Get(14, 15));
  depths.At(15, 15) = 4.0;
  EXPECT_EQ(Scatter(filter, depths).Get(15, 15), 0.0);
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, CountsIntervalsWithoutRoom)
{
  // Farther and farther away from the light, thin things at depths that grow faster.
  const int width = 200;
  Picture depths =
    MakePicture(width, 3, [](int x, int) { return x % 4 == 1 ? 0.5 + 0.09 * x : sky; });
  vtkNew<Filter> filter;
  Prepare(filter, -50.0, 0.01, -1.0);
  filter->SetFarLimit(100.0);
  Scatter(filter, depths);
  EXPECT_GT(filter->GetNumberOfOverflows(), 0);
  EXPECT_NE(filter->GetPlan().find("overflows"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, BytesDoNotDependOnThreads)
{
  const Picture depths = MakeDepths(333, 217);
  for (const double z : { -1.0, 0.0, 1.0 })
  {
    Picture pictures[2];
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&]()
        {
          vtkNew<Filter> filter;
          Prepare(filter, 0.3, 0.2, z);
          pictures[threads - 1] = Scatter(filter, depths);
        });
    }
    EXPECT_EQ(std::memcmp(pictures[0].Values.data(), pictures[1].Values.data(),
                pictures[0].Values.size() * sizeof(double)),
      0);
  }
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, InstructionSetsAgree)
{
  std::mt19937 generator = MakeGenerator(33);
  const Picture noise = MakeNoise(150, 100, 1, generator);
  Picture depths = MakeDepths(150, 100);
  for (std::size_t i = 0; i < depths.Values.size(); ++i)
  {
    // Many intervals on each line
    depths.Values[i] =
      noise.Values[i] > 0.97 ? 3.0 + 300.0 * (noise.Values[i] - 0.97) : depths.Values[i];
  }
  Picture first;
  for (const std::string& name : vtkGodRays::GetInstructionSets())
  {
    ASSERT_TRUE(vtkGodRays::UseInstructionSet(name));
    vtkNew<Filter> filter;
    Prepare(filter, 0.3, 0.2, -1.0);
    const Picture picture = Scatter(filter, depths);
    if (first.Values.empty())
    {
      first = picture;
    }
    const double difference = GetLargestDifference(first, picture) / first.GetMaximum();
    std::cout << name << ": " << difference << "\n";
    EXPECT_LE(difference, 1e-5);
  }
  vtkGodRays::UseInstructionSet("");
}

//------------------------------------------------------------------------------
TEST(CoverageFilter, TellsWhatCannotBeUsedOnce)
{
  vtkNew<Filter> filter;
  ErrorListener errors(filter);
  filter->Update();
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("depth image"), std::string::npos);
  Scatter(filter, Picture(4, 4, 3));
  ASSERT_EQ(errors.Texts.size(), 2u);
  filter->SetEndArrayName("nowhere");
  Scatter(filter, Picture(4, 4));
  ASSERT_EQ(errors.Texts.size(), 3u);
  EXPECT_NE(errors.Texts[2].find("nowhere"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetEndArrayName("");
  filter->SetMediumUp(0.0, 0.0, 0.0);
  Scatter(filter, Picture(4, 4));
  ASSERT_EQ(errors.Texts.size(), 4u);
  EXPECT_NE(errors.Texts[3].find("MediumUp"), std::string::npos);
  filter->SetMediumUp(0.0, 1.0, 0.0);
  EXPECT_GT(Scatter(filter, MakePicture(4, 4, [](int, int) { return sky; })).GetMaximum(), 0.0);
  EXPECT_EQ(errors.Texts.size(), 4u);
}

//------------------------------------------------------------------------------
// The ground truth over scenes and lights. Without layers what is hidden cannot be known, which is
// most of the error in the deep scenes (tree line, city).
TEST(CoverageFilter, IsNearTheGroundTruth)
{
  for (const Scene& scene : MakeScenes(10))
  {
    for (const NamedLight& light : Lights)
    {
      vtkNew<Reference> reference;
      Prepare(reference, light, 0.1);
      reference->SetInputData(scene.Occluders);
      reference->SetSize(240, 135);
      reference->SetNumberOfLayers(2);
      reference->Update();
      vtkNew<vtkImageData> truth;
      truth->DeepCopy(reference->GetOutput());
      vtkNew<Filter> filter;
      Prepare(filter, light, 0.1);
      const double layers = Compare(truth, filter).Rms;
      reference->SetNumberOfLayers(0);
      reference->Update();
      const double depths = Compare(reference->GetOutput(), filter).Rms;
      std::cout << scene.Name << ", " << light.Name << ": rms " << depths << ", two layers "
                << layers << "\n";
      // Front, near edge, off, off, behind
      const int index = static_cast<int>(&light - Lights);
      const double bounds[2][5] = { { 0.0125, 0.0125, 0.0040, 0.0040, 0.0055 },
        { 0.0125, 0.0045, 0.0010, 0.0010, 0.0030 } };
      EXPECT_LE(depths, bounds[0][index]);
      EXPECT_LE(layers, bounds[1][index]);
    }
  }
}

//------------------------------------------------------------------------------
// Parallel view rays: a light ray's depth changes by the same from pixel to pixel.
TEST(CoverageFilter, IsNearTheGroundTruthInParallelProjection)
{
  const NamedLight lights[] = { { "ahead", { 0.3, 0.4, -1.0 } }, { "aside", { 1.0, 0.2, 0.0 } },
    { "behind", { 0.5, 0.7, 1.0 } }, { "nearly ahead", { 0.02, 0.01, -1.0 } } };
  for (const Scene& scene : MakeScenes(10))
  {
    if (scene.Name != "sphere" && scene.Name != "slats")
    {
      continue;
    }
    for (const NamedLight& light : lights)
    {
      vtkNew<Reference> reference;
      vtkNew<Filter> filter;
      vtkNew<Filter> unshadowed;
      for (vtkGodRaysMediumFilter* either : { static_cast<vtkGodRaysMediumFilter*>(reference),
             static_cast<vtkGodRaysMediumFilter*>(filter),
             static_cast<vtkGodRaysMediumFilter*>(unshadowed) })
      {
        Prepare(either, light, 0.1);
        either->SetParallelProjection(true);
        either->SetParallelScale(3.5);
      }
      reference->SetInputData(scene.Occluders);
      reference->SetSize(240, 135);
      reference->SetNumberOfLayers(1);
      reference->Update();
      const Error error = Compare(reference->GetOutput(), filter);
      std::cout << scene.Name << ", " << light.Name << ": rms " << error.Rms << "\n";
      // A light 1.3 degrees from the direction of view passes a pixel in 2.3 units of depth: where in
      // a pixel an edge lies decides how much of the ray is dark.
      EXPECT_LE(error.Rms, std::strcmp(light.Name, "nearly ahead") == 0 ? 0.03 : 0.01);
      // Without the shadows it would be far off.
      Picture open = MakePicture(240, 135, [](int, int) { return sky; });
      vtkDataArray* truth = reference->GetOutput()->GetPointData()->GetScalars();
      const Picture airlight = Scatter(unshadowed, open);
      double squares = 0.0;
      for (std::size_t i = 0; i < open.Values.size(); ++i)
      {
        squares +=
          std::pow(airlight.Values[i] - truth->GetComponent(static_cast<vtkIdType>(i), 0), 2);
      }
      EXPECT_GT(std::sqrt(squares / open.Values.size()) / airlight.GetMaximum(), 3.0 * error.Rms);
    }
  }
}

//------------------------------------------------------------------------------
// What is seen but casts no shadow, and what casts one but is not seen.
TEST(CoverageFilter, RaysMayEndElsewhere)
{
  const auto scenes = MakeScenes(10);
  const Scene& sphere = scenes[0];
  const Scene& treeLine = scenes[3];
  for (const NamedLight& light : Lights)
  {
    vtkNew<Reference> reference;
    Prepare(reference, light, 0.1);
    reference->SetInputData(0, sphere.Occluders);
    reference->SetInputData(1, treeLine.Occluders);
    reference->SetSize(240, 135);
    reference->SetNumberOfLayers(1);
    reference->Update();
    vtkNew<Filter> filter;
    Prepare(filter, light, 0.1);
    const double rms = Compare(reference->GetOutput(), filter).Rms;
    // Taken for the same, they are not.
    vtkNew<vtkImageData> without;
    without->ShallowCopy(reference->GetOutput());
    without->GetPointData()->RemoveArray("End");
    const double wrong = Compare(without, filter).Rms;
    std::cout << light.Name << ": rms " << rms << ", with one for both " << wrong << "\n";
    EXPECT_LE(rms, 0.005);
    EXPECT_GT(wrong, 5.0 * rms);
  }
}

//------------------------------------------------------------------------------
// Two components, one with two phase functions: sums of what each would be with the others' extinction.
TEST(CoverageFilter, PhaseFunctionsAndComponentsAddUp)
{
  const Picture depths = MakeDepths(80, 60);
  vtkNew<Filter> filter;
  Prepare(filter, 0.2, 0.3, -1.0);
  filter->SetAsymmetry(0.9);
  filter->SetSecondAsymmetry(-0.8);
  filter->SetSecondWeight(0.3);
  filter->SetGasScatteringCoefficient(0.02, 0.03, 0.05);
  const Picture whole = Scatter(filter, depths);
  ASSERT_EQ(whole.Components, 3);
  const double extinction[3] = { 0.12, 0.13, 0.15 };
  const auto single = [&](int kind, double g, const double scattering[3])
  {
    vtkNew<Filter> one;
    Prepare(one, 0.2, 0.3, -1.0);
    one->SetPhaseFunction(kind);
    one->SetAsymmetry(g);
    one->SetScatteringCoefficient(scattering);
    one->SetAbsorptionCoefficient(
      extinction[0] - scattering[0], extinction[1] - scattering[1], extinction[2] - scattering[2]);
    return Scatter(one, depths);
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
TEST(CoverageFilter, StopsWhenItIsTold)
{
  vtkNew<Filter> filter;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputData(MakeImage(MakeDepths(32, 24)));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 32 * 24);
}
