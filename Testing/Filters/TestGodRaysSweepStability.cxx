// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Where sums through a light can lose their digits: lights on pixels and their borders, at infinity
// and behind, vanishing and huge parameters, values up to the largest float, values that are no
// numbers, pictures of one pixel and of 33 million. Each result, in single precision, is compared
// with the reference, in double, row by row where the picture is large; errors are fractions of the
// reference's peak in these rows.

#include "GodRaysFiltersTesting.h"

#include "vtkGodRaysReferenceFilter.h"
#include "vtkGodRaysScatteringFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace GodRaysFiltersTesting;

namespace
{
constexpr double Tolerance = 1.0 / 255.0;

// Of single pixels: at the edges of shafts, beside the light.
constexpr double LargestError = 0.15;

struct Case
{
  double Density = 0.97;
  double Decay = 0.99;
  int Samples = 100;
  double Light[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;

  void SetPosition(double u, double v)
  {
    this->Light[0] = 2.0 * u - 1.0;
    this->Light[1] = 2.0 * v - 1.0;
  }

  template <typename Filter>
  void Apply(Filter* filter) const
  {
    filter->SetDensity(this->Density);
    filter->SetDecay(this->Decay);
    filter->SetWeight(0.01);
    filter->SetNumberOfSamples(this->Samples);
    filter->SetLightClip(this->Light);
    filter->SetMarchScale(this->MarchScale);
  }
};

using Image = vtkSmartPointer<vtkImageData>;

Image MakeFloats(int width, int height, const std::function<float(int, int)>& function)
{
  auto image = Image::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      *values++ = function(x, y);
    }
  }
  return image;
}

// In [0, 1), from a pixel's position.
float Hash(int x, int y)
{
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393u + y * 668265263u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 65536.0f;
}

Image MakeHashed(int width, int height)
{
  std::mt19937 generator(41);
  return MakeFloats(
    width, height, [&generator](int, int) { return generator() < 1717986918u ? 0.0f : 1.0f; });
}

// Compares some rows, all of them if none are given.
void Check(
  const Case& parameters, vtkImageData* image, const std::string& name, std::vector<int> rows = {})
{
  vtkNew<vtkGodRaysScatteringFilter> filter;
  parameters.Apply(filter.Get());
  filter->SetInputData(image);
  filter->Update();
  vtkNew<vtkGodRaysReferenceFilter> reference;
  parameters.Apply(reference.Get());
  reference->SetInputData(image);

  const int* size = image->GetDimensions();
  if (rows.empty())
  {
    rows.resize(size[1]);
    std::iota(rows.begin(), rows.end(), 0);
  }
  double peak = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  for (const int y : rows)
  {
    const int extent[6] = { 0, size[0] - 1, y, y, 0, 0 };
    reference->UpdateExtent(extent);
    const auto* expected = static_cast<double*>(reference->GetOutput()->GetScalarPointer());
    const auto* values = static_cast<float*>(filter->GetOutput()->GetScalarPointer(0, y, 0));
    for (int x = 0; x < size[0]; ++x)
    {
      ASSERT_TRUE(std::isfinite(values[x]) && values[x] >= 0.0f) << name << ", " << x << " " << y;
      const double error = std::abs(static_cast<double>(values[x]) - expected[x]);
      peak = std::max(peak, expected[x]);
      largest = std::max(largest, error);
      squares += error * error;
    }
  }
  peak = std::max(peak, 1e-300);
  const double rms =
    std::sqrt(squares / (static_cast<double>(size[0]) * static_cast<double>(rows.size())));
  EXPECT_LE(rms / peak, Tolerance) << name << "\n" << filter->GetPlan();
  EXPECT_LE(largest / peak, LargestError) << name << "\n" << filter->GetPlan();
}
}

//------------------------------------------------------------------------------
// Exactly on the centre of a pixel, on the border between two, at corners, and close to these.
TEST(GodRaysSweepStability, LightOnPixels)
{
  const int width = 81;
  const int height = 60;
  const Image image = MakeHashed(width, height);
  for (const double x : { 0.0, 0.5, 1.0, 40.0, 40.5, 80.5, 81.0 })
  {
    for (const double y : { 0.0, 0.5, 30.0, 30.5, 59.5, 60.0 })
    {
      for (const double shift : { 0.0, 1e-12, -1e-7 })
      {
        Case parameters;
        parameters.SetPosition((x + shift) / width, (y - shift) / height);
        Check(parameters, image, "light at " + std::to_string(x) + " " + std::to_string(y));
      }
    }
  }
}

//------------------------------------------------------------------------------
// At the light the sum is the pixel itself times G.
TEST(GodRaysSweepStability, PixelAtLight)
{
  const Image image = MakeHashed(161, 121);
  for (const double offset : { 0.0, 1e-300, 1e-15, 1e-9, 1e-5 })
  {
    Case parameters;
    parameters.SetPosition((80.5 + offset) / 161, (60.5 - offset) / 121);
    vtkNew<vtkGodRaysScatteringFilter> filter;
    parameters.Apply(filter.Get());
    filter->SetInputData(image);
    filter->Update();
    const double gain = 0.01 * (1.0 - std::pow(0.99, 100)) / (1.0 - 0.99);
    EXPECT_NEAR(filter->GetOutput()->GetScalarComponentAsDouble(80, 60, 0, 0),
      gain * image->GetScalarComponentAsDouble(80, 60, 0, 0), 1e-4 * gain);
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysSweepStability, DensitiesAndDecays)
{
  const Image image = MakeHashed(70, 50);
  for (const double density : { 0.0, 1e-300, 1e-9, 1e-3, 0.1, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0 })
  {
    // k from -49 over 0 to 69 078 and infinity
    for (const double decay : { 0.0, 1e-300, 0.5, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.005, 1.05 })
    {
      for (const int samples : { 1, 1000 })
      {
        Case parameters;
        parameters.Density = density;
        parameters.Decay = decay;
        parameters.Samples = samples;
        parameters.SetPosition(0.31, 0.6);
        Check(parameters, image,
          "density " + std::to_string(density) + ", decay " + std::to_string(decay) + ", samples " +
            std::to_string(samples));
      }
    }
  }
}

//------------------------------------------------------------------------------
// To a million screens away, through infinity, and behind the camera.
TEST(GodRaysSweepStability, LightsOutside)
{
  const Image image = MakeHashed(97, 73);
  for (const double distance : { 0.5, 1.0, 7.0, 1e2, 1e3, 1e4, 1e5, 1e6 })
  {
    for (const double angle : { 0.0, 0.7853981633974483, 1.1, 3.141592653589793, 4.0 })
    {
      for (const bool capped : { false, true })
      {
        Case parameters;
        parameters.SetPosition(0.5 + distance * std::cos(angle), 0.5 + distance * std::sin(angle));
        parameters.MarchScale = capped ? 1.0 / distance : 1.0;
        Check(parameters, image,
          "distance " + std::to_string(distance) + ", angle " + std::to_string(angle));
      }
    }
  }
  for (const double w : { 1.0, 1e-3, 1e-9, 1e-200, 0.0, -1e-200, -1e-9, -1e-3, -0.3, -1.0, -5.0 })
  {
    Case parameters;
    parameters.Light[0] = 0.7;
    parameters.Light[1] = -0.4;
    parameters.Light[2] = w;
    Check(parameters, image, "w " + std::to_string(w));
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysSweepStability, BrightPixels)
{
  for (const float bright : { 65504.0f, 1e30f, std::numeric_limits<float>::max() })
  {
    const Image everywhere =
      MakeFloats(150, 100, [bright](int x, int y) { return bright * Hash(x, y); });
    const Image few = MakeFloats(
      150, 100, [bright](int x, int y) { return x % 50 == 20 && y % 50 == 30 ? bright : 1.0f; });
    for (const double u : { 0.5, 0.0, -3.0 })
    {
      Case parameters;
      parameters.SetPosition(u, 0.45);
      Check(parameters, everywhere, "bright everywhere");
      vtkNew<vtkGodRaysScatteringFilter> filter;
      parameters.Apply(filter.Get());
      filter->SetInputData(few);
      filter->Update();
      const auto* values = static_cast<float*>(filter->GetOutput()->GetScalarPointer());
      EXPECT_TRUE(std::all_of(values, values + 150 * 100,
        [](float value) { return std::isfinite(value) && value >= 0.0f; }));
    }
  }
}

//------------------------------------------------------------------------------
// The same bytes as those of the picture put right by hand, at every light.
TEST(GodRaysSweepStability, ValuesThatAreNoNumbers)
{
  const float infinity = std::numeric_limits<float>::infinity();
  const float bad[] = { std::numeric_limits<float>::quiet_NaN(), -infinity, -1.0f, infinity };
  const float good[] = { 0.0f, 0.0f, 0.0f, std::numeric_limits<float>::max() };
  auto make = [](const float* values)
  {
    return MakeFloats(130, 110,
      [values](int x, int y)
      { return Hash(x, y) < 0.05f ? values[(x + 3 * y) % 4] : Hash(x + 7, y); });
  };
  const Image before = make(bad);
  const Image after = make(good);
  for (const double u : { 0.5, 0.0, 1.4, 1e4 })
  {
    for (const int method : { vtkGodRaysScatteringFilter::SWEEP, vtkGodRaysScatteringFilter::TAPS })
    {
      std::vector<std::vector<float>> results;
      for (vtkImageData* image : { before.Get(), after.Get() })
      {
        Case parameters;
        parameters.SetPosition(u, 0.4);
        vtkNew<vtkGodRaysScatteringFilter> filter;
        parameters.Apply(filter.Get());
        filter->SetMethod(method);
        filter->SetInputData(image);
        filter->Update();
        const auto* values = static_cast<float*>(filter->GetOutput()->GetScalarPointer());
        results.emplace_back(values, values + 130 * 110);
      }
      EXPECT_EQ(results[0], results[1]);
      EXPECT_TRUE(std::all_of(
        results[0].begin(), results[0].end(), [](float value) { return std::isfinite(value); }));
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysSweepStability, SizesAndThinFeatures)
{
  for (const auto& size :
    std::vector<std::vector<int>>{ { 1, 1 }, { 3, 5 }, { 1, 77 }, { 64, 33 } })
  {
    Check(Case(), MakeHashed(size[0], size[1]), std::to_string(size[0]) + " pixels wide");
  }
  const int width = 1921;
  const int height = 1079;
  const std::vector<int> rows = { 0, 333, 538, 539, 540, 800, 1078 };
  const Image pictures[] = { MakeHashed(width, height),
    MakeFloats(width, height, [](int x, int y) { return x % 7 && y % 9 ? 1.0f : 0.0f; }),
    MakeFloats(width, height, [](int, int y) { return y == 539 ? 1.0f : 0.0f; }),
    MakeFloats(width, height, [](int x, int) { return x == 960 ? 0.0f : 1.0f; }) };
  for (const Image& picture : pictures)
  {
    for (const double u : { 0.5, 0.0, -0.4 })
    {
      Case parameters;
      parameters.SetPosition(u, 0.5);
      Check(parameters, picture,
        "picture " + std::to_string(&picture - pictures) + ", light at " + std::to_string(u), rows);
    }
  }
}

//------------------------------------------------------------------------------
// 8K: single precision of positions, 4000 rows of sums.
TEST(GodRaysSweepStability, LargePicture)
{
  const Image image =
    MakeFloats(7680, 4320, [](int x, int y) { return (x / 13 + y / 17) % 3 ? 1.0f : Hash(x, y); });
  for (const double u : { 0.5, -2.0 })
  {
    Case parameters;
    parameters.SetPosition(u, 0.37);
    Check(parameters, image, "light at " + std::to_string(u), { 11, 1598 });
  }
}
