// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Time and error of vtkGodRaysScatteringFilter, as a Markdown table.
//
// Usage: ScatteringFilter [option]... [width height [tolerance [components]]]
//        ScatteringFilter --cost [--instructions <set>] [width height]
//
// --quick: fewer rows and rounds. --instructions: vector instructions other than the best, such as AVX2.
// --rows: how many rows of the picture, evenly spaced, are compared (12). --cost: how time grows with
// components, samples and pixels, and what planning takes, of the sweep without a pipeline.
//
// Time is given in milliseconds and, as machines differ and are shared, in two units measured in the
// same run: a copy of the image (memcpy) and the customary 100 plain bilinear taps a pixel, with the
// same vector instructions and the exponential weight stepped, as a shader would. Errors are
// against vtkGodRaysReferenceFilter in some rows of the picture, as fractions of the peak.

#include "PlainTaps.h"

#include "vtkGodRaysRadialSweep.h"
#include "vtkGodRaysReferenceFilter.h"
#include "vtkGodRaysScatteringFilter.h"
#include "vtkGodRaysSweepKernels.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
struct Settings
{
  int Width = 1920;
  int Height = 1080;
  int Components = 1;
  double Tolerance = 1.0 / 255.0;
  int ReferenceRows = 12;
  int Repeats = 9;
  bool Cost = false;
};

struct Light
{
  const char* Name;
  double U;
  double V;
};
const Light Lights[] = { { "centre", 0.5, 0.5 }, { "near edge", 0.035, 0.62 },
  { "corner", 0.0, 0.0 }, { "0.5 off", -0.5, 0.31 }, { "10 off", -10.0, 0.3 },
  { "10 off diagonal", 7.1, -7.0 } };

// Open (1) or closed (0), at a pixel.
using Mask = std::vector<float>;

//------------------------------------------------------------------------------
double Hash(int x, int y)
{
  unsigned int h = x * 374761393u + y * 668265263u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return ((h ^ (h >> 16)) & 0xffffffu) / 16777216.0;
}

//------------------------------------------------------------------------------
double SmoothNoise(double x, double y)
{
  const double left = std::floor(x);
  const double low = std::floor(y);
  auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double fx = ease(x - left);
  const double fy = ease(y - low);
  auto at = [&](int i, int j)
  { return Hash(static_cast<int>(left) + i, static_cast<int>(low) + j); };
  return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
    fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

//------------------------------------------------------------------------------
Mask MakeMask(const Settings& s, const std::function<double(double, double)>& function)
{
  Mask mask;
  for (int y = 0; y < s.Height; ++y)
  {
    for (int x = 0; x < s.Width; ++x)
    {
      mask.push_back(static_cast<float>(function(x, y)));
    }
  }
  return mask;
}

//------------------------------------------------------------------------------
// Branches of a tree, drawn as capsules.
void Grow(Mask& mask, const Settings& s, double x, double y, double angle, double length,
  double radius, int depth, std::mt19937& random)
{
  if (depth == 0 || radius < 0.35)
  {
    return;
  }
  const double endX = x + length * std::cos(angle);
  const double endY = y + length * std::sin(angle);
  const int left = std::max(0, static_cast<int>(std::min(x, endX) - radius));
  const int right = std::min(s.Width - 1, static_cast<int>(std::max(x, endX) + radius + 1));
  const int low = std::max(0, static_cast<int>(std::min(y, endY) - radius));
  const int high = std::min(s.Height - 1, static_cast<int>(std::max(y, endY) + radius + 1));
  for (int j = low; j <= high; ++j)
  {
    for (int i = left; i <= right; ++i)
    {
      const double along = ((i - x) * std::cos(angle) + (j - y) * std::sin(angle)) / length;
      const double t = std::min(1.0, std::max(0.0, along));
      if (std::hypot(i - x - t * (endX - x), j - y - t * (endY - y)) < radius)
      {
        mask[static_cast<std::size_t>(j) * s.Width + i] = 0.0f;
      }
    }
  }
  std::uniform_real_distribution<double> spread(-0.3, 0.3);
  for (const double turn : { -0.45, 0.05, 0.5 })
  {
    Grow(mask, s, endX, endY, angle + turn + spread(random), 0.76 * length, 0.66 * radius,
      depth - 1, random);
  }
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, Mask>> MakeMasks(const Settings& s)
{
  const double scale = s.Height / 720.0;
  std::vector<std::pair<std::string, Mask>> masks;
  masks.emplace_back("discs",
    MakeMask(s,
      [&](double x, double y)
      {
        const double discs[][3] = { { 0.34, 0.36, 70 }, { 0.66, 0.62, 50 }, { 0.2, 0.85, 60 },
          { 0.85, 0.25, 35 }, { 0.52, 0.22, 40 } };
        for (const double* disc : discs)
        {
          if (std::hypot(x - disc[0] * s.Width, y - disc[1] * s.Height) < disc[2] * scale)
          {
            return 0.0;
          }
        }
        return 1.0;
      }));
  masks.emplace_back("lattice",
    MakeMask(s,
      [&](double x, double y)
      {
        const double a = (0.955 * x + 0.296 * y) / (22.0 * scale);
        const double b = (0.955 * y - 0.296 * x) / (26.0 * scale);
        return a - std::floor(a) < 0.1 || b - std::floor(b) < 0.085 ? 0.0 : 1.0;
      }));
  masks.emplace_back("clouds",
    MakeMask(s,
      [&](double x, double y)
      {
        double sum = 0.0;
        for (int octave = 0; octave < 7; ++octave)
        {
          const double frequency = std::ldexp(1.0 / (220.0 * scale), octave);
          sum += std::ldexp(0.5, -octave) * SmoothNoise(x * frequency, y * frequency);
        }
        return 1.0 - std::min(1.0, std::max(0.0, (sum - 0.42) / 0.14));
      }));
  Mask trees = MakeMask(s, [](double, double) { return 1.0; });
  std::mt19937 random(7);
  Grow(trees, s, 0.5 * s.Width, 0.0, 1.5, 170.0 * scale, 17.0 * scale, 10, random);
  Grow(trees, s, 0.15 * s.Width, 0.0, 1.7, 120.0 * scale, 11.0 * scale, 9, random);
  Grow(trees, s, 0.85 * s.Width, 0.0, 1.4, 130.0 * scale, 12.0 * scale, 9, random);
  masks.emplace_back("trees", trees);
  masks.emplace_back("one-pixel lattice",
    MakeMask(s,
      [](double x, double y)
      { return std::fmod(x, 7.0) < 1.0 || std::fmod(y, 9.0) < 1.0 ? 0.0 : 1.0; }));
  masks.emplace_back("noise",
    MakeMask(
      s, [](double x, double y) { return Hash(static_cast<int>(x), static_cast<int>(y)) < 0.5; }));
  masks.emplace_back("stars",
    MakeMask(s,
      [](double x, double y)
      { return Hash(static_cast<int>(x) + 17, static_cast<int>(y) + 91) < 0.002; }));
  return masks;
}

//------------------------------------------------------------------------------
// A disc of light and its glow behind the mask, another tint in each component.
vtkSmartPointer<vtkImageData> MakeImage(const Settings& s, const Mask& mask, const Light& light)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(s.Width, s.Height, 1);
  image->AllocateScalars(VTK_FLOAT, s.Components);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const double away = std::max({ 0.0, -light.U, light.U - 1.0, -light.V, light.V - 1.0 });
  const double reach = (0.35 + 0.7 * away) * s.Width;
  for (int y = 0; y < s.Height; ++y)
  {
    for (int x = 0; x < s.Width; ++x)
    {
      const double distance = std::hypot(x - light.U * s.Width, y - light.V * s.Height);
      const double glow = distance < 0.03 * s.Width ? 1.0 : 0.1 + 0.5 * std::exp(-distance / reach);
      for (int c = 0; c < s.Components; ++c)
      {
        *values++ = static_cast<float>(
          mask[static_cast<std::size_t>(y) * s.Width + x] * glow * (1.0 - 0.1 * c));
      }
    }
  }
  return image;
}

//------------------------------------------------------------------------------
double MeasureCopy(const Settings& s)
{
  const std::size_t size = static_cast<std::size_t>(s.Width) * s.Height * s.Components;
  std::vector<float> from(size, 1.0f);
  std::vector<float> to(size);
  // Read back, or the compiler would leave it out.
  volatile float seen = 0.0f;
  return Measure(9,
    [&]()
    {
      from[size / 2] += 1.0f;
      std::memcpy(to.data(), from.data(), size * sizeof(float));
      seen = to[size / 2];
    });
}

struct Errors
{
  double Rms;
  double Permille;
  double Largest;
};

//------------------------------------------------------------------------------
Errors Compare(const Settings& s, vtkImageData* image, const Light& light, vtkImageData* result)
{
  vtkNew<vtkGodRaysReferenceFilter> reference;
  reference->SetInputData(image);
  reference->SetDecay(0.99);
  reference->SetLightPosition(light.U, light.V);
  std::vector<double> errors;
  double peak = 0.0;
  double squares = 0.0;
  for (int i = 0; i < s.ReferenceRows; ++i)
  {
    const int y = static_cast<int>((i + 0.5) * s.Height / s.ReferenceRows);
    const int extent[6] = { 0, s.Width - 1, y, y, 0, 0 };
    reference->UpdateExtent(extent);
    const auto* expected = static_cast<double*>(reference->GetOutput()->GetScalarPointer());
    const auto* values = static_cast<float*>(result->GetScalarPointer(0, y, 0));
    for (int x = 0; x < s.Width * s.Components; ++x)
    {
      const double error = values[x] - expected[x];
      errors.push_back(std::abs(error));
      squares += error * error;
      peak = std::max(peak, expected[x]);
    }
  }
  std::sort(errors.begin(), errors.end());
  return { std::sqrt(squares / errors.size()) / peak,
    errors[(errors.size() - 1) * 999 / 1000] / peak, errors.back() / peak };
}

//------------------------------------------------------------------------------
double MeasureFilter(const Settings& s, vtkGodRaysScatteringFilter* filter, int threads)
{
  double time = 0.0;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
    [&]()
    {
      auto execute = [&]()
      {
        filter->Modified();
        filter->Update();
      };
      // Two threads need both cores for themselves: the best of more.
      time = threads == 1 ? MeasureProcessor(s.Repeats, execute) : Measure(3 * s.Repeats, execute);
    });
  return time;
}

//------------------------------------------------------------------------------
Settings ReadSettings(int count, char* arguments[])
{
  Settings s;
  std::vector<double> numbers;
  for (int i = 1; i < count; ++i)
  {
    if (std::strcmp(arguments[i], "--quick") == 0)
    {
      s.ReferenceRows = 4;
      s.Repeats = 3;
    }
    else if (std::strcmp(arguments[i], "--cost") == 0)
    {
      s.Cost = true;
    }
    else if (std::strcmp(arguments[i], "--instructions") == 0 && i + 1 < count)
    {
      if (!vtkGodRays::UseInstructionSet(arguments[++i]))
      {
        std::fprintf(stderr, "this processor has no instructions %s\n", arguments[i]);
        std::exit(EXIT_FAILURE);
      }
    }
    else if (std::strcmp(arguments[i], "--rows") == 0 && i + 1 < count)
    {
      s.ReferenceRows = std::max(1, std::atoi(arguments[++i]));
    }
    else
    {
      numbers.push_back(std::atof(arguments[i]));
    }
  }
  if (numbers.size() >= 2)
  {
    s.Width = std::max(1, static_cast<int>(numbers[0]));
    s.Height = std::max(1, static_cast<int>(numbers[1]));
  }
  s.Tolerance = numbers.size() >= 3 ? numbers[2] : s.Tolerance;
  s.Components = numbers.size() >= 4 ? std::max(1, static_cast<int>(numbers[3])) : 1;
  return s;
}
}

//------------------------------------------------------------------------------
// Milliseconds of the sweep alone, on one thread: the median over the lights.
struct Cost
{
  double Steady = 0.0;
  double Moving = 0.0; // the light moves from one to the next: plans anew
};

Cost MeasureSweep(int width, int height, int components, int samples)
{
  vtkGodRaysRadialSweep sweep;
  const vtkGodRaysRadialSweep::Planes planes = sweep.PrepareInput(width, height, components);
  for (int c = 0; c < components; ++c)
  {
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        planes.Values[c][y * planes.Stride + x] = static_cast<float>((x / 7 + y / 9 + c) % 3);
      }
    }
  }
  std::vector<double> steady;
  std::vector<double> moving;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]()
    {
      for (const Light& light : Lights)
      {
        vtkGodRaysRadialSweep::Parameters parameters;
        parameters.NumberOfSamples = samples;
        parameters.Decay = std::pow(0.99, 100.0 / samples);
        parameters.LightClip[0] = 2.0 * light.U - 1.0;
        parameters.LightClip[1] = 2.0 * light.V - 1.0;
        sweep.Execute(parameters);
        steady.push_back(MeasureProcessor(7, [&]() { sweep.Execute(parameters); }));
        moving.push_back(MeasureProcessor(7,
          [&]()
          {
            parameters.LightClip[0] += 1e-4;
            sweep.Execute(parameters);
          }));
      }
    });
  std::sort(steady.begin(), steady.end());
  std::sort(moving.begin(), moving.end());
  return { 1e3 * steady[steady.size() / 2], 1e3 * moving[moving.size() / 2] };
}

//------------------------------------------------------------------------------
void PrintCost(const Settings& s)
{
  const double taps = 1e3 * MeasurePlainTaps(s.Width, s.Height, true);
  const Cost one = MeasureSweep(s.Width, s.Height, 1, 100);
  std::printf("%d x %d: %.2f ms, 100 plain taps %.0f ms, %.0f times as much; with a moving light "
              "%.2f ms\n",
    s.Width, s.Height, one.Steady, taps, taps / one.Steady, one.Moving);
  const double three = MeasureSweep(s.Width, s.Height, 3, 100).Steady;
  std::printf("3 components: %.2f ms, %.2f times one\n", three, three / one.Steady);
  for (const int samples : { 10, 1000, 10000 })
  {
    std::printf(
      "%d samples: %.2f ms\n", samples, MeasureSweep(s.Width, s.Height, 1, samples).Steady);
  }
  // The slope of the straight line through the logarithms.
  double sums[4] = {};
  const int sizes[][2] = { { 640, 360 }, { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 },
    { 7680, 4320 } };
  for (const auto& size : sizes)
  {
    const double pixels = static_cast<double>(size[0]) * size[1];
    const double time = MeasureSweep(size[0], size[1], 1, 100).Steady;
    std::printf("%d x %d: %.2f ms, %.2f ns a pixel\n", size[0], size[1], time, 1e6 * time / pixels);
    const double x = std::log(pixels);
    const double y = std::log(time);
    sums[0] += x;
    sums[1] += y;
    sums[2] += x * x;
    sums[3] += x * y;
  }
  const double n = 5.0;
  std::printf("time grows with the number of pixels to the power of %.2f\n",
    (n * sums[3] - sums[0] * sums[1]) / (n * sums[2] - sums[0] * sums[0]));
}

//------------------------------------------------------------------------------
int main(int count, char* arguments[])
{
  const Settings s = ReadSettings(count, arguments);
  if (s.Cost)
  {
    PrintCost(s);
    return EXIT_SUCCESS;
  }
  double taps = MeasurePlainTaps(s.Width, s.Height, true);
  const double copy = MeasureCopy(s);
  std::printf("%d x %d, %d component(s), tolerance %.2e; 100 plain taps of one component %.0f ms, "
              "copy %.2f ms\n\n",
    s.Width, s.Height, s.Components, s.Tolerance, 1e3 * taps, 1e3 * copy);
  std::printf(
    "| mask | light | 1 thread ms | copies | 100 taps / it | 2 threads ms | speed-up | RMSE "
    "| 99.9 %% | max |\n|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<double> ratios;
  std::vector<double> speedups;
  std::vector<double> rms;
  std::vector<double> permille;
  std::string plan;
  for (const auto& mask : MakeMasks(s))
  {
    taps = MeasurePlainTaps(s.Width, s.Height, true); // again: others may share the machine
    for (const Light& light : Lights)
    {
      auto image = MakeImage(s, mask.second, light);
      vtkNew<vtkGodRaysScatteringFilter> filter;
      filter->SetInputData(image);
      filter->SetDecay(0.99);
      filter->SetErrorTolerance(s.Tolerance);
      filter->SetLightPosition(light.U, light.V);
      const double one = MeasureFilter(s, filter, 1);
      const double two = MeasureFilter(s, filter, 2);
      const Errors errors = Compare(s, image, light, filter->GetOutput());
      ratios.push_back(taps / one);
      speedups.push_back(one / two);
      rms.push_back(errors.Rms);
      permille.push_back(errors.Permille);
      std::printf("| %s | %s | %.2f | %.1f | %.0f | %.2f | %.2f | %.1e | %.1e | %.1e |\n",
        mask.first.c_str(), light.Name, 1e3 * one, one / copy, taps / one, 1e3 * two, one / two,
        errors.Rms, errors.Permille, errors.Largest);
      std::fflush(stdout);
      plan = filter->GetPlan();
    }
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(speedups.begin(), speedups.end());
  std::sort(rms.begin(), rms.end());
  std::sort(permille.begin(), permille.end());
  const std::size_t half = ratios.size() / 2;
  std::printf("\nmedian: 100 taps / it %.0f, two threads %.2f, RMSE %.1e, 99.9 %% %.1e; the last "
              "plan: %s\n",
    ratios[half], speedups[half], rms[half], permille[half], plan.c_str());
  return EXIT_SUCCESS;
}
