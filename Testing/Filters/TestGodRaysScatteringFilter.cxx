// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sector sweep against the reference: random pictures, lights and parameters, then the hard
// cases one by one. Errors are fractions of the reference's peak.

#include "GodRaysFiltersTesting.h"

#include "vtkGodRaysReferenceFilter.h"
#include "vtkGodRaysScatteringFilter.h"
#include "vtkGodRaysSweepKernels.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace GodRaysFiltersTesting;

namespace
{
// All parameters of both filters.
struct Parameters
{
  double Density = 0.97;
  double Decay = 0.99;
  double Weight = 0.01;
  double Exposure = 1.0;
  int Samples = 100;
  double Light[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;
  double Tolerance = 1.0 / 255.0;

  void SetPosition(double u, double v)
  {
    this->Light[0] = 2.0 * u - 1.0;
    this->Light[1] = 2.0 * v - 1.0;
    this->Light[2] = 1.0;
    this->MarchScale = 1.0;
  }
  // On the centre of a pixel, or between pixels.
  void SetPixel(double x, double y, const Picture& picture)
  {
    this->SetPosition((x + 0.5) / picture.Width, (y + 0.5) / picture.Height);
  }

  template <typename Filter>
  void Apply(Filter* filter) const
  {
    filter->SetDensity(this->Density);
    filter->SetDecay(this->Decay);
    filter->SetWeight(this->Weight);
    filter->SetExposure(this->Exposure);
    filter->SetNumberOfSamples(this->Samples);
    filter->SetLightClip(this->Light);
    filter->SetMarchScale(this->MarchScale);
  }

  std::string Describe() const
  {
    std::ostringstream text;
    text.precision(17);
    text << "density " << this->Density << ", decay " << this->Decay << ", samples "
         << this->Samples << ", light " << this->Light[0] << " " << this->Light[1] << " "
         << this->Light[2] << ", march scale " << this->MarchScale << ", tolerance "
         << this->Tolerance;
    return text.str();
  }
};

struct Errors
{
  double Rms = 0.0;
  double Permille = 0.0; // 99.9 % of pixels deviate less
  double Largest = 0.0;
};

Errors Compare(const Picture& result, const Picture& expected)
{
  EXPECT_EQ(result.Values.size(), expected.Values.size());
  const double peak = std::max(expected.GetMaximum(), 1e-300);
  std::vector<double> errors;
  double squares = 0.0;
  for (std::size_t i = 0; i < expected.Values.size(); ++i)
  {
    const double error = std::abs(result.Values[i] - expected.Values[i]) / peak;
    errors.push_back(std::isfinite(error) ? error : 1e30);
    squares += errors.back() * errors.back();
  }
  std::sort(errors.begin(), errors.end());
  return { std::sqrt(squares / errors.size()), errors[(errors.size() - 1) * 999 / 1000],
    errors.back() };
}

Picture Expect(const Parameters& parameters, const Picture& picture)
{
  vtkNew<vtkGodRaysReferenceFilter> filter;
  parameters.Apply(filter.Get());
  return Scatter(filter, picture);
}

Picture Evaluate(const Parameters& parameters, const Picture& picture,
  int method = vtkGodRaysScatteringFilter::AUTOMATIC, std::string* plan = nullptr,
  int type = VTK_FLOAT)
{
  vtkNew<vtkGodRaysScatteringFilter> filter;
  parameters.Apply(filter.Get());
  filter->SetErrorTolerance(parameters.Tolerance);
  filter->SetMethod(method);
  const Picture result = Scatter(filter, picture, type);
  if (plan)
  {
    *plan = filter->GetPlan();
  }
  return result;
}

// The error of one case, and that it is within the tolerance.
Errors Check(const Parameters& parameters, const Picture& picture,
  int method = vtkGodRaysScatteringFilter::AUTOMATIC)
{
  std::string plan;
  const Errors errors =
    Compare(Evaluate(parameters, picture, method, &plan), Expect(parameters, picture));
  EXPECT_LE(errors.Rms, parameters.Tolerance) << parameters.Describe() << "\n" << plan;
  return errors;
}

bool IsSweep(const std::string& plan)
{
  return plan.find("sweep") != std::string::npos;
}

// Random pictures of several kinds.
class Generator
{
public:
  static constexpr int FewPixels = 3; // a kind of picture

  explicit Generator(unsigned int seed)
    : Random(MakeGenerator(seed))
  {
  }

  double Uniform(double low, double high) { return low + (high - low) * this->Draw(); }
  int GetKind() const { return this->Kind; }
  int Choose(int count) { return std::min(count - 1, static_cast<int>(this->Draw() * count)); }

  Picture MakeRandomPicture(int width, int height)
  {
    this->Kind = this->Choose(5);
    switch (this->Kind)
    {
      case 0: // black and white from pixel to pixel
        return MakePicture(width, height, [this](int, int) { return this->Choose(2); });
      case 1:
        return MakeNoise(width, height, 1, this->Random);
      case 2: // a lattice one pixel wide, turned
        return this->MakeLattice(width, height);
      case FewPixels:
        return MakePicture(
          width, height, [this](int, int) { return this->Draw() < 0.01 ? 1.0 : 0.0; });
      default:
        return this->MakeDiscs(width, height);
    }
  }

  Parameters MakeParameters(const Picture& picture)
  {
    Parameters p;
    const double densities[] = { 0.97, 1.0, this->Uniform(0.1, 1.0), this->Uniform(0.3, 1.0),
      std::pow(10.0, this->Uniform(-3.0, 0.0)), this->Uniform(1.0, 2.0) };
    p.Density = densities[this->Choose(6)];
    const double decays[] = { 0.99, 0.98, 1.0, this->Uniform(0.95, 1.0), this->Uniform(0.99, 1.01),
      this->Uniform(0.0, 1.05) };
    p.Decay = decays[this->Choose(6)];
    p.Samples = this->Choose(2) ? 100 : 1 + this->Choose(300);
    p.Weight = this->Uniform(0.001, 1.0);
    p.Exposure = this->Uniform(0.1, 2.0);
    const double tolerances[] = { 1.0 / 255.0, 1.0 / 255.0, 1e-2, 2e-2, 1e-3 };
    p.Tolerance = tolerances[this->Choose(5)];
    this->PlaceLight(picture, p);
    return p;
  }

private:
  double Draw() { return this->Random() / 4294967296.0; }

  Picture MakeLattice(int width, int height)
  {
    const double angle = this->Uniform(0.0, 3.14);
    const double period = this->Uniform(3.0, 12.0);
    return MakePicture(width, height,
      [=](int x, int y)
      {
        const double a = (x * std::cos(angle) + y * std::sin(angle)) / period;
        const double b = (y * std::cos(angle) - x * std::sin(angle)) / period;
        return a - std::floor(a) < 1.0 / period || b - std::floor(b) < 1.0 / period ? 0.0 : 1.0;
      });
  }

  Picture MakeDiscs(int width, int height)
  {
    std::vector<std::array<double, 4>> discs(6);
    for (auto& disc : discs)
    {
      disc = { this->Uniform(0.0, width), this->Uniform(0.0, height), this->Uniform(2.0, 30.0),
        this->Uniform(0.0, 1.0) };
    }
    return MakePicture(width, height,
      [&](int x, int y)
      {
        double value = 0.2;
        for (const auto& disc : discs)
        {
          value = std::hypot(x - disc[0], y - disc[1]) < disc[2] ? disc[3] : value;
        }
        return value;
      });
  }

  void PlaceLight(const Picture& picture, Parameters& p)
  {
    const double angle = this->Uniform(0.0, 6.283);
    switch (this->Choose(7))
    {
      case 0:
        p.SetPixel(this->Choose(picture.Width), this->Choose(picture.Height), picture);
        break;
      case 1:
        p.SetPosition(this->Choose(3) * 0.5, this->Choose(3) * 0.5); // centre, edges, corners
        break;
      case 2:
      case 3:
        p.SetPosition(this->Uniform(0.0, 1.0), this->Uniform(0.0, 1.0));
        break;
      case 4: // outside, to 1e6 screens away, the march capped or not
      {
        const double distance = std::pow(10.0, this->Uniform(-0.2, 6.0));
        p.SetPosition(0.5 + distance * std::cos(angle), 0.5 + distance * std::sin(angle));
        p.MarchScale = this->Choose(2) ? 1.0 : std::min(1.0, 1.0 / distance);
        break;
      }
      case 5: // at infinity
        p.Light[0] = std::cos(angle);
        p.Light[1] = std::sin(angle);
        p.Light[2] = this->Choose(2) ? 0.0 : this->Uniform(-1e-6, 1e-6);
        break;
      default: // behind
        p.Light[0] = this->Uniform(-1.5, 1.5);
        p.Light[1] = this->Uniform(-1.5, 1.5);
        p.Light[2] = -this->Uniform(0.05, 1.5);
    }
  }

  std::mt19937 Random;
  int Kind = 0;
};

// The value below which a fraction of all lies.
double GetPercentile(std::vector<double> values, double fraction)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(fraction * (values.size() - 1))];
}

Picture MakeTestPicture(int width, int height)
{
  std::mt19937 generator(5);
  return MakeNoise(width, height, 1, generator);
}
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, KeepsToleranceOnRandomCases)
{
  Generator generator(1);
  const int cases = 600;
  int sweeps = 0;
  std::vector<double> rms;
  std::vector<double> permille;
  for (int i = 0; i < cases; ++i)
  {
    const int width = static_cast<int>(generator.Uniform(24.0, 160.0));
    const int height = static_cast<int>(generator.Uniform(24.0, 160.0));
    const Picture picture = generator.MakeRandomPicture(width, height);
    const Parameters parameters = generator.MakeParameters(picture);
    std::string plan;
    const Errors errors =
      Compare(Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plan),
        Expect(parameters, picture));
    // Few bright pixels on black are harder than noise; see SetErrorTolerance().
    const double limit = generator.GetKind() == Generator::FewPixels ? 1.5 : 1.0;
    EXPECT_LE(errors.Rms, limit * parameters.Tolerance)
      << "case " << i << ", picture " << generator.GetKind() << ", " << parameters.Describe()
      << "\n"
      << plan;
    if (IsSweep(plan))
    {
      ++sweeps;
      rms.push_back(errors.Rms / parameters.Tolerance);
      permille.push_back(errors.Permille / parameters.Tolerance);
    }
  }
  std::cout << cases << " cases, " << sweeps
            << " of them swept; their errors as fractions of the tolerance:\n"
            << "  RMSE 50 % " << GetPercentile(rms, 0.5) << ", 90 % " << GetPercentile(rms, 0.9)
            << ", 99 % " << GetPercentile(rms, 0.99) << ", all " << GetPercentile(rms, 1.0)
            << "\n  99.9 % of pixels: 50 % " << GetPercentile(permille, 0.5) << ", 90 % "
            << GetPercentile(permille, 0.9) << ", all " << GetPercentile(permille, 1.0) << "\n";
  EXPECT_GE(sweeps, cases / 3);
  EXPECT_LE(GetPercentile(rms, 0.5), 0.7);
  EXPECT_LE(GetPercentile(permille, 0.5), 3.0);
}

//------------------------------------------------------------------------------
// On the pixels, edges and corners of odd pictures; nothing is divided by 0.
TEST(GodRaysScatteringFilter, LightOnPixelsEdgesAndCorners)
{
  const Picture picture = MakeTestPicture(129, 97);
  for (const double x : { -1.0, -0.5, 0.0, 64.0, 64.5, 128.0, 128.5, 129.0 })
  {
    for (const double y : { -1.0, -0.5, 0.0, 48.0, 48.5, 96.0, 96.5, 97.0 })
    {
      Parameters parameters;
      parameters.SetPixel(x, y, picture);
      Check(parameters, picture);
    }
  }
}

//------------------------------------------------------------------------------
// With the light on a pixel that pixel is its own sum, and about it sums are close to the reference.
TEST(GodRaysScatteringFilter, PixelsNearLight)
{
  const Picture picture = MakeTestPicture(129, 97);
  for (const double offset : { 0.0, 1e-9, 1e-3, 0.5 })
  {
    Parameters parameters;
    parameters.SetPixel(64.0 + offset, 48.0, picture);
    const Picture result = Evaluate(parameters, picture);
    const Picture expected = Expect(parameters, picture);
    for (int y = 44; y <= 52; ++y)
    {
      for (int x = 60; x <= 68; ++x)
      {
        EXPECT_NEAR(result.Get(x, y), expected.Get(x, y), 0.01 * expected.GetMaximum());
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, Densities)
{
  const Picture picture = MakeTestPicture(129, 97);
  for (const double density :
    { 0.0, 1e-6, 1e-3, 0.05, 0.2, 0.5, 0.999999, 1.0, 1.000001, 1.5, 2.0 })
  {
    Parameters parameters;
    parameters.Density = density;
    parameters.SetPosition(0.3, 0.6);
    Check(parameters, picture);
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, Decays)
{
  const Picture picture = MakeTestPicture(129, 97);
  for (const double decay :
    { 0.0, 1e-300, 0.1, 0.5, 0.7, 0.9, 0.999999, 1.0, 1.000001, 1.01, 1.05 })
  {
    for (const int samples : { 1, 100, 1024, 10000 })
    {
      if (samples == 10000 && decay > 1.001)
      {
        continue; // no float is as large as G
      }
      Parameters parameters;
      parameters.Decay = decay;
      parameters.Samples = samples;
      parameters.SetPosition(0.3, 0.6);
      Check(parameters, picture);
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, LightsFarAway)
{
  const Picture picture = MakeTestPicture(129, 97);
  for (const double distance : { 0.5, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e9 })
  {
    for (const double angle : { 0.0, 0.4, 0.78539816, 2.0, 3.14159265, 5.0 })
    {
      Parameters parameters;
      parameters.SetPosition(0.5 + distance * std::cos(angle), 0.5 + distance * std::sin(angle));
      Check(parameters, picture);
      parameters.MarchScale = 1.0 / distance; // capped
      Check(parameters, picture);
    }
  }
}

//------------------------------------------------------------------------------
// The result changes no more than the reference does, on both sides of w = 0.
TEST(GodRaysScatteringFilter, LightPassesInfinity)
{
  const Picture picture = MakeTestPicture(129, 97);
  Parameters parameters;
  parameters.Light[0] = 0.8;
  parameters.Light[1] = 0.5;
  parameters.Light[2] = 0.0;
  const Picture atInfinity = Evaluate(parameters, picture);
  for (const double w : { 0.0, 1e-30, -1e-30, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4, 0.1, -0.1,
         0.5, -0.5, -1.0, -2.0 })
  {
    parameters.Light[2] = w;
    Check(parameters, picture);
    if (std::abs(w) < 1e-7)
    {
      const Errors errors = Compare(Evaluate(parameters, picture), atInfinity);
      EXPECT_LE(errors.Largest, 1e-3) << w;
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, BrightPixels)
{
  for (const double bright : { 65504.0, 1e30, 3e38 })
  {
    Picture picture = MakeTestPicture(129, 97);
    picture.At(40, 50) = bright;
    picture.At(90, 20) = bright;
    Parameters parameters;
    Check(parameters, picture);
    parameters.SetPosition(-3.0, 0.2);
    Check(parameters, picture);
    parameters.Weight = 100.0;
    parameters.Exposure = 100.0;
    for (const double value : Evaluate(parameters, picture).Values)
    {
      ASSERT_TRUE(std::isfinite(value));
    }
  }
}

//------------------------------------------------------------------------------
// NaN and negative pixels are as if black, infinite ones as the largest float.
TEST(GodRaysScatteringFilter, PixelsThatAreNoLight)
{
  Picture picture = MakeTestPicture(129, 97);
  Picture clean = picture;
  const double infinity = std::numeric_limits<double>::infinity();
  const double values[] = { std::numeric_limits<double>::quiet_NaN(), -1.0, -infinity };
  for (int i = 0; i < 60; ++i)
  {
    picture.At(2 * i, i) = values[i % 3];
    clean.At(2 * i, i) = 0.0;
  }
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const Parameters parameters;
    const int automatic = vtkGodRaysScatteringFilter::AUTOMATIC;
    EXPECT_EQ(Evaluate(parameters, picture, automatic, nullptr, type).Values,
      Evaluate(parameters, clean, automatic, nullptr, type).Values);
  }
  picture = clean;
  picture.At(10, 10) = infinity;
  clean.At(10, 10) = std::numeric_limits<float>::max();
  EXPECT_EQ(Evaluate(Parameters(), picture).Values, Evaluate(Parameters(), clean).Values);
  for (const double value : Evaluate(Parameters(), picture).Values)
  {
    ASSERT_TRUE(std::isfinite(value));
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, SmallAndOddPictures)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 2 }, { 3, 5 }, { 1, 200 }, { 200, 1 }, { 2, 300 },
    { 31, 33 }, { 129, 97 }, { 17, 400 } };
  for (const auto& size : sizes)
  {
    const Picture picture = MakeTestPicture(size[0], size[1]);
    for (const double u : { 0.5, 0.0, 1.3, -20.0 })
    {
      for (const int method :
        { vtkGodRaysScatteringFilter::AUTOMATIC, vtkGodRaysScatteringFilter::TAPS })
      {
        Parameters parameters;
        parameters.SetPosition(u, 0.3);
        Check(parameters, picture, method);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Few pixels one way and many the other: swept, and as accurate as others.
TEST(GodRaysScatteringFilter, Strips)
{
  const int sizes[][2] = { { 1024, 16 }, { 16, 700 }, { 900, 4 }, { 1500, 3 }, { 2, 1500 },
    { 2000, 1 }, { 1, 2000 } };
  const double lights[][3] = { { 0.3, 0.2, 1.0 }, { 1.3, 0.1, 1.0 }, { 0.2, 3.0, 1.0 },
    { 1.0, 0.3, 0.0 }, { 0.4, 0.3, -0.5 } };
  int sweeps = 0;
  for (const auto& size : sizes)
  {
    const Picture picture = MakeTestPicture(size[0], size[1]);
    for (const auto& light : lights)
    {
      Parameters parameters;
      std::copy_n(light, 3, parameters.Light);
      std::string plan;
      const Errors errors =
        Compare(Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plan),
          Expect(parameters, picture));
      EXPECT_LE(errors.Rms, parameters.Tolerance) << parameters.Describe() << "\n" << plan;
      sweeps += IsSweep(plan);
    }
  }
  EXPECT_GT(sweeps, 25); // of 35
}

//------------------------------------------------------------------------------
// Taps along a strip are as many as the square of its length: for each pixel, as many as its march is long
// [pixels], over the distance that this tolerance asks for.
TEST(GodRaysScatteringFilter, LongStripsHaveNoMoreTapsThanPictures)
{
  const int sizes[][2] = { { 12000, 16 }, { 16, 12000 }, { 4096, 31 }, { 16384, 3 }, { 16384, 1 } };
  const double lights[][3] = { { 0.3, 0.2, 1.0 }, { 1.3, 0.1, 1.0 }, { 0.0, 3.0, 1.0 },
    { 1.0, 0.001, 0.0 }, { 0.0, 1.0, 0.0 } };
  for (const auto& size : sizes)
  {
    const Picture picture = MakePicture(size[0], size[1], [](int, int) { return 1.0; });
    for (const auto& light : lights)
    {
      for (const double tolerance : { 1.0 / 255.0, 1e-3 })
      {
        Parameters parameters;
        parameters.Tolerance = tolerance;
        std::copy_n(light, 3, parameters.Light);
        const auto lengthAt = [&](int x, int y) // within the picture
        {
          double begin = 0.0;
          double end = 1.0;
          double squares = 0.0;
          const int place[2] = { x, y };
          for (int i = 0; i < 2; ++i)
          {
            const double ndc = 2.0 * (place[i] + 0.5) / size[i] - 1.0;
            const double way = parameters.Density * 0.5 * size[i] * (light[i] - light[2] * ndc);
            const double ends[2] = { -0.5 - place[i], size[i] - 0.5 - place[i] };
            if (way != 0.0)
            {
              begin = std::max(begin, std::min(ends[0] / way, ends[1] / way));
              end = std::min(end, std::max(ends[0] / way, ends[1] / way));
            }
            squares += way * way;
          }
          return std::max(0.0, end - begin) * std::sqrt(squares);
        };
        double taps = 0.0;
        for (int y = 0; y < size[1]; ++y)
        {
          for (int x = 0; x < size[0]; ++x)
          {
            taps += lengthAt(x, y) / std::sqrt(tolerance / 0.09);
          }
        }
        std::string plan;
        Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plan);
        EXPECT_TRUE(IsSweep(plan) || taps < 2.2e8)
          << taps << " taps, " << parameters.Describe() << "\n"
          << plan;
      }
    }
  }
}

//------------------------------------------------------------------------------
// One bright line, one bright pixel: where they are missed, shafts are.
TEST(GodRaysScatteringFilter, ThinFeatures)
{
  const std::vector<Picture> pictures = {
    MakePicture(150, 130, [](int x, int) { return x == 40 ? 1.0 : 0.0; }),
    MakePicture(150, 130, [](int, int y) { return y == 40 ? 1.0 : 0.0; }),
    MakePicture(150, 130, [](int x, int y) { return x == 90 && y == 70 ? 1.0 : 0.0; }),
    MakePicture(150, 130, [](int x, int y) { return x == y ? 0.0 : 1.0; }),
    MakePicture(150, 130, [](int x, int y) { return (x + y) % 2 ? 0.0 : 1.0; }),
  };
  for (const Picture& picture : pictures)
  {
    for (const double u : { 0.5, 0.27, -0.6, 1e4 })
    {
      Parameters parameters;
      parameters.SetPosition(u, 0.4);
      Check(parameters, picture);
    }
  }
}

//------------------------------------------------------------------------------
// A white picture about the light is G in every pixel: no bias.
TEST(GodRaysScatteringFilter, WhitePicture)
{
  const Picture picture = MakePicture(400, 300, [](int, int) { return 1.0; });
  Parameters parameters;
  parameters.Tolerance = 1e-3;
  parameters.SetPosition(0.4, 0.3);
  const double gain = 0.01 * (1.0 - std::pow(0.99, 100)) / (1.0 - 0.99);
  std::string plan;
  const Picture result =
    Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plan);
  EXPECT_TRUE(IsSweep(plan)) << plan;
  for (const double value : result.Values)
  {
    ASSERT_NEAR(value, gain, 1e-3 * gain);
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, BlackPictureIsBlack)
{
  const Picture picture = MakePicture(300, 200, [](int, int) { return 0.0; });
  for (const double value : Evaluate(Parameters(), picture).Values)
  {
    ASSERT_EQ(value, 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, IsLinear)
{
  std::mt19937 generator(3);
  const Picture a = MakeNoise(300, 200, 1, generator);
  const Picture b = MakeNoise(300, 200, 1, generator);
  Picture sum = a;
  for (std::size_t i = 0; i < sum.Values.size(); ++i)
  {
    sum.Values[i] = 3.0 * a.Values[i] + 0.5 * b.Values[i];
  }
  for (const double density : { 1.0, 0.6 })
  {
    Parameters parameters;
    parameters.Density = density;
    const Picture fromA = Evaluate(parameters, a);
    const Picture fromB = Evaluate(parameters, b);
    Picture expected = fromA;
    for (std::size_t i = 0; i < sum.Values.size(); ++i)
    {
      expected.Values[i] = 3.0 * fromA.Values[i] + 0.5 * fromB.Values[i];
    }
    EXPECT_LE(Compare(Evaluate(parameters, sum), expected).Largest, 2e-5);
  }
}

//------------------------------------------------------------------------------
// Each component as if it were alone; bytes as fractions of 255.
TEST(GodRaysScatteringFilter, ComponentsAndTypes)
{
  std::mt19937 generator(4);
  for (int components = 1; components <= 4; ++components)
  {
    Picture picture = MakeNoise(200, 150, components, generator);
    for (double& value : picture.Values)
    {
      value = std::floor(255.0 * value);
    }
    Picture fractions = picture;
    for (double& value : fractions.Values)
    {
      value /= 255.0;
    }
    const int automatic = vtkGodRaysScatteringFilter::AUTOMATIC;
    const Picture result = Evaluate(Parameters(), fractions);
    EXPECT_LE(
      Compare(Evaluate(Parameters(), picture, automatic, nullptr, VTK_UNSIGNED_CHAR), result)
        .Largest,
      1e-6);
    EXPECT_LE(
      Compare(Evaluate(Parameters(), fractions, automatic, nullptr, VTK_DOUBLE), result).Largest,
      1e-6);
    for (int c = 0; c < components; ++c)
    {
      const Picture one =
        MakePicture(200, 150, [&](int x, int y) { return fractions.Get(x, y, c); });
      const Picture alone = Evaluate(Parameters(), one);
      for (int i = 0; i < 200 * 150; ++i)
      {
        ASSERT_EQ(alone.Values[i], result.Values[i * components + c]);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A mirrored picture with a mirrored light gives mirrored rays: all wedges are the same.
TEST(GodRaysScatteringFilter, Mirrored)
{
  const Picture picture = MakeTestPicture(200, 200);
  const Picture mirrored =
    MakePicture(200, 200, [&](int x, int y) { return picture.Get(199 - x, y); });
  const Picture turned = MakePicture(200, 200, [&](int x, int y) { return picture.Get(y, x); });
  for (const double density : { 1.0, 0.5 })
  {
    Parameters parameters;
    parameters.Density = density;
    parameters.SetPixel(60.3, 90.6, picture);
    const Picture result = Evaluate(parameters, picture);
    parameters.SetPixel(199 - 60.3, 90.6, picture);
    const Picture fromMirrored = Evaluate(parameters, mirrored);
    parameters.SetPixel(90.6, 60.3, picture);
    const Picture fromTurned = Evaluate(parameters, turned);
    const Picture back =
      MakePicture(200, 200, [&](int x, int y) { return fromMirrored.Get(199 - x, y); });
    EXPECT_LE(Compare(back, result).Rms, parameters.Tolerance);
    const Picture backTurned =
      MakePicture(200, 200, [&](int x, int y) { return fromTurned.Get(y, x); });
    EXPECT_LE(Compare(backTurned, result).Rms, parameters.Tolerance);
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, ThreadsGiveTheSameBytes)
{
  std::mt19937 generator(6);
  const Picture picture = MakeNoise(640, 360, 3, generator);
  for (const double density : { 0.97, 0.4 })
  {
    Parameters parameters;
    parameters.Density = density;
    std::vector<Picture> results;
    for (const int threads : { 1, 2, 3, 8 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&]() { results.push_back(Evaluate(parameters, picture)); });
    }
    results.push_back(Evaluate(parameters, picture)); // on whatever threads there are by default
    for (const Picture& result : results)
    {
      EXPECT_EQ(result.Values, results.front().Values);
    }
  }
}

//------------------------------------------------------------------------------
// Whatever instructions the processor has, within 1e-6 of the peak.
TEST(GodRaysScatteringFilter, InstructionSetsAgree)
{
  const std::vector<std::string> sets = vtkGodRays::GetInstructionSets();
  std::string names;
  for (const std::string& name : sets)
  {
    names += name + " ";
  }
  std::cout << "instruction sets: " << names << "\n";
  const Picture picture = MakeTestPicture(301, 203);
  std::vector<Parameters> cases(6);
  cases[1].Density = 1.0;
  cases[2].SetPosition(-0.8, 0.3);
  cases[3].Light[2] = 0.0;
  cases[3].Light[0] = cases[3].Light[1] = 0.7;
  cases[4].Density = 0.3;
  cases[4].Decay = 0.95;
  cases[5].Light[2] = -1.0;
  cases[5].Density = 0.7;
  for (const Parameters& parameters : cases)
  {
    for (const int method : { vtkGodRaysScatteringFilter::SWEEP, vtkGodRaysScatteringFilter::TAPS })
    {
      vtkGodRays::UseInstructionSet("");
      const Picture expected = Evaluate(parameters, picture, method);
      for (const std::string& name : sets)
      {
        ASSERT_TRUE(vtkGodRays::UseInstructionSet(name));
        EXPECT_LE(Compare(Evaluate(parameters, picture, method), expected).Largest, 1e-6)
          << name << ", " << parameters.Describe();
      }
    }
  }
  EXPECT_FALSE(vtkGodRays::UseInstructionSet("no such"));
  vtkGodRays::UseInstructionSet("");
}

//------------------------------------------------------------------------------
// The same memory again, and the same result.
TEST(GodRaysScatteringFilter, SteadyExecutionKeepsItsMemory)
{
  const Picture picture = MakeTestPicture(320, 200);
  vtkNew<vtkGodRaysScatteringFilter> filter;
  filter->SetDecay(0.98);
  filter->SetInputData(MakeImage(picture, VTK_FLOAT));
  filter->Update();
  const void* first = filter->GetOutput()->GetScalarPointer();
  const Picture result = FromImage(filter->GetOutput());
  for (int i = 0; i < 3; ++i)
  {
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetScalarPointer(), first);
    EXPECT_EQ(FromImage(filter->GetOutput()).Values, result.Values);
  }
  // Who keeps the output has it for good.
  vtkNew<vtkImageData> kept;
  kept->ShallowCopy(filter->GetOutput());
  filter->SetDecay(0.9);
  filter->Update();
  EXPECT_EQ(FromImage(kept).Values, result.Values);
  EXPECT_NE(FromImage(filter->GetOutput()).Values, result.Values);
  filter->ReleaseMemory();
  filter->SetDecay(0.98);
  filter->Update();
  EXPECT_EQ(FromImage(filter->GetOutput()).Values, result.Values);
}

//------------------------------------------------------------------------------
// A filter that moves from one picture and light to others forgets the ones before.
TEST(GodRaysScatteringFilter, StateDoesNotLeak)
{
  vtkNew<vtkGodRaysScatteringFilter> filter;
  Generator generator(8);
  for (int i = 0; i < 40; ++i)
  {
    const Picture picture = generator.MakeRandomPicture(
      static_cast<int>(generator.Uniform(30, 300)), static_cast<int>(generator.Uniform(30, 300)));
    const Parameters parameters = generator.MakeParameters(picture);
    parameters.Apply(filter.Get());
    filter->SetErrorTolerance(parameters.Tolerance);
    const Picture result = Scatter(filter, picture, VTK_FLOAT);
    EXPECT_EQ(result.Values, Evaluate(parameters, picture).Values) << parameters.Describe();
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, CostDoesNotDependOnSamples)
{
  const Picture picture = MakeTestPicture(320, 200);
  std::string plans[2];
  Parameters parameters;
  parameters.Samples = 10;
  parameters.Decay = 0.9;
  Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plans[0]);
  parameters.Samples = 1000;
  parameters.Decay = std::pow(0.9, 0.01);
  Evaluate(parameters, picture, vtkGodRaysScatteringFilter::AUTOMATIC, &plans[1]);
  EXPECT_TRUE(IsSweep(plans[0]));
  EXPECT_EQ(plans[0].substr(0, 80), plans[1].substr(0, 80));
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, TellsProgressAndStops)
{
  struct Watch
  {
    std::vector<double> Progress;
    double StopAt = 2.0;
  } watch;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* filter = static_cast<vtkGodRaysScatteringFilter*>(caller);
      auto* own = static_cast<Watch*>(data);
      own->Progress.push_back(filter->GetProgress());
      if (filter->GetProgress() >= own->StopAt)
      {
        filter->AbortExecuteOn();
      }
    });
  const Picture pictures[] = { MakeTestPicture(1200, 700), MakeTestPicture(64, 48) };
  const int methods[] = { vtkGodRaysScatteringFilter::SWEEP, vtkGodRaysScatteringFilter::TAPS };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkGodRaysScatteringFilter> filter;
    ErrorListener errors(filter);
    filter->SetMethod(methods[i]);
    filter->SetInputData(MakeImage(pictures[i], VTK_FLOAT));
    filter->Update();
    const Picture expected = FromImage(filter->GetOutput());

    filter->AddObserver(vtkCommand::ProgressEvent, command);
    watch = {};
    filter->Modified();
    filter->Update();
    EXPECT_GT(watch.Progress.size(), 8u);
    EXPECT_TRUE(std::is_sorted(watch.Progress.begin(), watch.Progress.end()));
    EXPECT_EQ(watch.Progress.back(), 1.0);
    EXPECT_EQ(FromImage(filter->GetOutput()).Values, expected.Values);

    watch = {};
    watch.StopAt = 0.3;
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(std::none_of(watch.Progress.begin(), watch.Progress.end(),
      [](double progress) { return progress > 0.45 && progress < 1.0; }));
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

    watch = {};
    filter->AbortExecuteOff(); // VTK 9.1 does so by itself
    filter->Modified();
    filter->Update();
    EXPECT_EQ(FromImage(filter->GetOutput()).Values, expected.Values);
    EXPECT_TRUE(errors.Texts.empty());
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysScatteringFilter, InputsThatCannotBeUsed)
{
  vtkNew<vtkGodRaysScatteringFilter> filter;
  ErrorListener listener(filter);
  filter->Update();
  ASSERT_EQ(listener.Texts.size(), 1u);
  EXPECT_NE(listener.Texts[0].find("no input"), std::string::npos);

  vtkNew<vtkImageData> volume;
  volume->SetDimensions(4, 4, 4);
  volume->AllocateScalars(VTK_FLOAT, 1);
  filter->SetInputData(volume);
  filter->Update();
  EXPECT_EQ(listener.Texts.size(), 2u);

  vtkNew<vtkImageData> shorts;
  shorts->SetDimensions(4, 4, 1);
  shorts->AllocateScalars(VTK_SHORT, 1);
  filter->SetInputData(shorts);
  filter->Update();
  EXPECT_EQ(listener.Texts.size(), 3u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  filter->SetInputData(MakeImage(MakeTestPicture(40, 30)));
  filter->Update();
  EXPECT_EQ(listener.Texts.size(), 3u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1200);
  filter->SetDensity(std::numeric_limits<double>::quiet_NaN());
  filter->SetLightPosition(std::numeric_limits<double>::infinity(), 0.0);
  EXPECT_EQ(listener.Texts.size(), 5u);
}

//------------------------------------------------------------------------------
// Extents and names are the input's.
TEST(GodRaysScatteringFilter, GeometryOfTheInput)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(5, 104, -20, 59, 3, 3);
  image->SetSpacing(0.5, 2.0, 1.0);
  image->SetOrigin(1.0, 2.0, 3.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), 8000, 1.0f);
  vtkNew<vtkGodRaysScatteringFilter> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkImageData* result = filter->GetOutput();
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(result->GetExtent()[i], image->GetExtent()[i]);
  }
  EXPECT_EQ(result->GetSpacing()[1], 2.0);
  EXPECT_EQ(result->GetOrigin()[2], 3.0);
  EXPECT_EQ(result->GetScalarType(), VTK_FLOAT);
}
