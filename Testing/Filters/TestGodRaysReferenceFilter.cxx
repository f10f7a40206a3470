// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The reference filter against closed forms, against two evaluations of the same integral that
// share no code with it (100 000 taps; Gauss-Legendre in long double between all crossings), and
// against itself under every symmetry that the integral has.

#include "GodRaysFiltersTesting.h"

#include "vtkGodRaysReferenceFilter.h"

#include <array>
#include <sstream>

using namespace GodRaysFiltersTesting;

namespace
{
using Filter = vtkGodRaysReferenceFilter;
using Number = long double;

// --- The definition, in long double -----------------------------------------------------------

struct Problem
{
  Number Gain; // Exposure Weight (1 + d + ... + d^(n-1))
  Number K;
  Number Density;
  Number Light[3];
  Number Scale;

  explicit Problem(Filter* filter)
    : Gain(0)
    , K(-filter->GetNumberOfSamples() * std::log(Number(filter->GetDecay())))
    , Density(filter->GetDensity())
    , Scale(filter->GetMarchScale())
  {
    Number power = 1;
    for (int i = 0; i < filter->GetNumberOfSamples(); ++i)
    {
      this->Gain += power;
      power *= filter->GetDecay();
    }
    this->Gain *= Number(filter->GetExposure()) * filter->GetWeight();
    std::copy_n(filter->GetLightClip(), 3, this->Light);
  }

  // In pixels along the axis with size pixels.
  Number GetVelocity(int pixel, int size, int axis) const
  {
    const Number ndc = 2 * (pixel + Number(0.5)) / size - 1;
    return this->Density * this->Scale / 2 * (this->Light[axis] - this->Light[2] * ndc) * size;
  }
};

// The moments of the kernel: integral_a^b K(t) t^m dt, m = 0 or 1.
Number GetMoment(Number k, Number a, Number b, int m)
{
  const Number phi = k == 0 ? 1 : -std::expm1(-k) / k;
  const Number h = b - a;
  const Number z = k * h;
  Number zeroth;
  Number first; // integral of (t - a)/h
  if (std::abs(z) < 0.5L)
  {
    zeroth = first = 0;
    Number term = 1; // (-z)^j/j!
    for (int j = 0; j < 25; ++j)
    {
      zeroth += term / (j + 1);
      first += term / (j + 2);
      term *= -z / (j + 1);
    }
  }
  else
  {
    zeroth = -std::expm1(-z) / z;
    first = (zeroth - std::exp(-z)) / z;
  }
  const Number scale = h * std::exp(-k * a) / phi;
  return m == 0 ? scale * zeroth : scale * (a * zeroth + h * first);
}

// integral of K(t) times the hat with its peak of 1 at middle and its feet at middle +- width,
// for 0 <= middle - width and middle + width <= 1.
Number GetHat(Number k, Number middle, Number width)
{
  const Number low = middle - width;
  const Number high = middle + width;
  return (GetMoment(k, low, middle, 1) - low * GetMoment(k, low, middle, 0) +
           high * GetMoment(k, middle, high, 0) - GetMoment(k, middle, high, 1)) /
    width;
}

// By 100 000 taps at midpoints, for k not infinite.
double SumMidpoints(const Picture& picture, const Problem& problem, int x, int y, int c)
{
  const int taps = 100000;
  const double vx = static_cast<double>(problem.GetVelocity(x, picture.Width, 0));
  const double vy = static_cast<double>(problem.GetVelocity(y, picture.Height, 1));
  const double factor = static_cast<double>(std::exp(-problem.K / taps));
  double sum = 0.0;
  double weights = 0.0;
  double weight = 1.0;
  for (int i = 0; i < taps; ++i)
  {
    const double t = (i + 0.5) / taps;
    sum += weight * picture.Read(x + t * vx, y + t * vy, c);
    weights += weight;
    weight *= factor;
  }
  return static_cast<double>(problem.Gain) * sum / weights;
}

struct GaussRule
{
  static constexpr int Count = 12;
  std::array<Number, Count> Node; // in [0, 1]
  std::array<Number, Count> Weight;

  GaussRule()
  {
    for (int i = 0; i < Count; ++i)
    {
      Number x = std::cos(std::acos(Number(-1)) * (i + Number(0.75)) / (Count + Number(0.5)));
      Number slope = 0;
      for (int step = 0; step < 30; ++step) // Newton, on the Legendre polynomial
      {
        Number value = 1;
        Number before = 0;
        for (int n = 0; n < Count; ++n)
        {
          const Number next = ((2 * n + 1) * x * value - n * before) / (n + 1);
          before = value;
          value = next;
        }
        slope = Count * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      this->Node[i] = (1 + x) / 2;
      this->Weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

// By Gauss-Legendre quadrature, all but exact, between all crossings of lines of pixel centres.
Number Integrate(const Picture& picture, const Problem& problem, int x, int y, int c)
{
  static const GaussRule rule;
  const Number start[2] = { Number(x), Number(y) };
  const Number velocity[2] = { problem.GetVelocity(x, picture.Width, 0),
    problem.GetVelocity(y, picture.Height, 1) };
  const int size[2] = { picture.Width, picture.Height };
  const Number k = problem.K;
  if (std::isinf(k))
  {
    return problem.Gain * picture.Get(x, y, c);
  }
  std::vector<Number> times = { 0, 1 };
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int line = -1; line <= size[axis]; ++line)
    {
      const Number t = velocity[axis] != 0 ? (line - start[axis]) / velocity[axis] : 0;
      if (t > 0 && t < 1)
      {
        times.push_back(t);
      }
    }
  }
  std::sort(times.begin(), times.end());
  const Number steepest = k < 0 ? -k : 0; // keeps the exponential at most 1
  Number sum = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    const Number reach = k > 0 ? std::min(times[i], times[i - 1] + 120 / k) : times[i];
    const int pieces = 1 + static_cast<int>(std::abs(k) * (reach - times[i - 1]));
    const Number h = (reach - times[i - 1]) / pieces;
    for (int piece = 0; piece < pieces; ++piece)
    {
      for (int j = 0; j < GaussRule::Count; ++j)
      {
        const Number t = times[i - 1] + h * (piece + rule.Node[j]);
        sum += h * rule.Weight[j] * std::exp(-k * t - steepest) *
          picture.Read(start[0] + t * velocity[0], start[1] + t * velocity[1], c);
      }
    }
  }
  const Number phi = k == 0 ? 1 : -std::expm1(-k) / k;
  return problem.Gain * sum * std::exp(steepest) / phi;
}

// --- Random problems --------------------------------------------------------------------------

template <typename Item, std::size_t Size>
Item Pick(const Item (&items)[Size], std::mt19937& generator)
{
  return items[generator() % Size];
}

double Uniform(double low, double high, std::mt19937& generator)
{
  return low + (high - low) * (generator() / 4294967296.0);
}

// A light anywhere: inside, on a pixel's centre, on an edge, in a corner, outside, far, at
// infinity, just beside infinity, behind the camera.
void SetRandomLight(Filter* filter, int width, int height, double farthest, std::mt19937& generator)
{
  auto uniform = [&](double low, double high) { return Uniform(low, high, generator); };
  const double column = generator() % width + 0.5;
  const double row = generator() % height + 0.5;
  const double scale = uniform(0.2, 2.0);
  switch (generator() % 9)
  {
    case 0:
      return filter->SetLightPosition(uniform(0, 1), uniform(0, 1));
    case 1:
      return filter->SetLightPosition(column / width, row / height);
    case 2:
      return filter->SetLightPosition(1.0, uniform(0, 1));
    case 3:
      return filter->SetLightPosition(0.0, 1.0);
    case 4:
      return filter->SetLightPosition(uniform(-2, 3), uniform(-2, 3));
    case 5:
      return filter->SetLightPosition(uniform(-farthest, farthest), uniform(-farthest, farthest));
    case 6:
      return filter->SetLightDirection(uniform(-1, 1), generator() % 3 == 0 ? 0 : uniform(-1, 1));
    case 7:
      filter->SetLightClip(uniform(-1, 1), uniform(-1, 1), uniform(-1e-9, 1e-9));
      return filter->SetMarchScale(scale);
    default:
      filter->SetLightClip(uniform(-2, 2), uniform(-2, 2), uniform(-1.5, 0));
      return filter->SetMarchScale(scale);
  }
}

std::string Describe(Filter* filter)
{
  std::ostringstream text;
  filter->Print(text);
  return text.str();
}

const double decays[] = { 0.5, 0.9, 0.98, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.02, 1.05 };
const double kernels[] = { -50.0, -4.0, -1.0, -1e-3, -1e-9, 0.0, 1e-12, 1e-6, 0.1, 1.0, 1.99, 2.01,
  5.0, 30.0, 500.0 };

// Decay such that the kernel is e^(-k t); for k < -4.8 that takes more samples.
Number SetKernel(Filter* filter, double k)
{
  filter->SetNumberOfSamples(k < -4.0 ? 1024 : 100);
  filter->SetDecay(std::exp(-k / filter->GetNumberOfSamples()));
  return Problem(filter).K;
}
}

// --- Closed forms -----------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilter, ConstantGivesTheGain)
{
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.3, 0.6);
  filter->SetDensity(1.0);
  filter->SetExposure(1.5);
  const Picture constant = MakePicture(17, 11, [](int, int) { return 0.7; });
  for (double k : kernels)
  {
    SetKernel(filter, k);
    const double gain = static_cast<double>(0.7 * Problem(filter).Gain);
    for (double value : Scatter(filter, constant).Values)
    {
      ASSERT_NEAR(value / gain, 1.0, 1e-13) << "k " << k;
    }
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, RampGivesTheMeanOfTheKernel)
{
  vtkNew<Filter> filter;
  const int width = 33;
  const double light = 4.0; // pixels
  filter->SetLightPosition((light + 0.5) / width, 0.37);
  filter->SetDensity(0.8);
  const Picture ramp = MakePicture(width, 9, [](int x, int) { return x; });
  for (double kernel : kernels)
  {
    const Number k = SetKernel(filter, kernel);
    const Picture rays = Scatter(filter, ramp);
    for (int x = 0; x < width; ++x)
    {
      const Number expected =
        Problem(filter).Gain * (x + 0.8L * (light - x) * GetMoment(k, 0, 1, 1));
      ASSERT_NEAR(rays.Get(x, 4) / static_cast<double>(expected), 1.0, 1e-13) << "k " << kernel;
    }
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, BrightLineIsAHatInTheKernel)
{
  // A column of light, parallel shafts and a light inside; the exponential at every k.
  vtkNew<Filter> filter;
  filter->SetDensity(1.0);
  const int width = 41;
  const Picture line = MakePicture(width, 5, [](int x, int) { return x == 20 ? 1.0 : 0.0; });
  for (double kernel : kernels)
  {
    const Number k = SetKernel(filter, kernel);
    const Number gain = Problem(filter).Gain;
    filter->SetLightDirection(30.0 / width, 0.0);
    const Picture parallel = Scatter(filter, line);
    filter->SetLightPosition(36.5 / width, 0.5);
    const Picture finite = Scatter(filter, line);
    for (int x = 3; x < 19; ++x)
    {
      const Number distance = 20 - x;
      const Number a = gain * GetHat(k, distance / 30, 1 / 30.0L);
      const Number b = gain * GetHat(k, distance / (36 - x), 1.0L / (36 - x));
      ASSERT_NEAR(parallel.Get(x, 2) / static_cast<double>(a), 1.0, 1e-12) << "k " << kernel;
      ASSERT_NEAR(finite.Get(x, 2) / static_cast<double>(b), 1.0, 1e-12) << "k " << kernel;
    }
    EXPECT_EQ(parallel.Get(21, 2), 0.0);
    EXPECT_EQ(parallel.Get(40, 2), 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, HalfPlaneThroughTheLight)
{
  // The edge is reconstructed as a ramp of one pixel, its middle at the light's height.
  vtkNew<Filter> filter;
  const Picture half = MakePicture(25, 40, [](int, int y) { return y >= 20 ? 1.0 : 0.0; });
  filter->SetLightPosition(0.4, 0.5);
  for (double density : { 0.5, 0.97, 1.0 })
  {
    for (double kernel : { -4.0, 0.0, 1.0, 30.0 })
    {
      filter->SetDensity(density);
      const Number k = SetKernel(filter, kernel);
      const Number gain = Problem(filter).Gain;
      const Picture rays = Scatter(filter, half);
      for (int y = 20; y < 40; ++y)
      {
        const Number r = y - 19.5L;
        const Number enters = std::min(Number(1), (1 - 0.5L / r) / density);
        const Number expected = gain *
          (GetMoment(k, 0, enters, 0) + (0.5L + r) * GetMoment(k, enters, 1, 0) -
            r * density * GetMoment(k, enters, 1, 1));
        ASSERT_NEAR(rays.Get(7, y), static_cast<double>(expected), 1e-13 * gain) << y;
        ASSERT_NEAR(rays.Get(7, 39 - y), static_cast<double>(gain - expected), 1e-13 * gain) << y;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, DiscAndAnnulusConvergeWithTheGrid)
{
  // An edge falls within a pixel, wherever in it: the error is of first order in a pixel's size.
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.5, 0.5);
  filter->SetDensity(0.9);
  for (double kernel : { -2.0, 0.0, 3.0 })
  {
    const Number k = SetKernel(filter, kernel);
    const Number gain = Problem(filter).Gain;
    for (double inner : { 0.0, 0.08 })
    {
      const double outer = 0.2;
      auto inside = [&](Number radius, Number r) // of the kernel's weight
      {
        const Number enters = std::min(Number(1), std::max(Number(0), (1 - radius / r) / 0.9L));
        return GetMoment(k, enters, 1, 0);
      };
      double errors[3];
      for (int level = 0; level < 3; ++level)
      {
        const int size = (64 << level) + 1;
        auto disc = [&](double radius, double r)
        { return std::min(std::max(size * (radius - r) + 0.5, 0.0), 1.0); };
        const Picture picture = MakePicture(size, size,
          [&](int x, int y)
          {
            const double r = std::hypot(x - size / 2, y - size / 2) / size;
            return disc(outer, r) - (inner > 0.0 ? disc(inner, r) : 0.0);
          });
        filter->SetInputData(MakeImage(picture));
        const int row = size / 2 + size / 3; // all of it outside of the disc
        filter->UpdateExtent(std::array<int, 6>{ 0, size - 1, row, row, 0, 0 }.data());
        const Picture rays = FromImage(filter->GetOutput());
        ASSERT_EQ(rays.Height, 1);
        double squares = 0.0;
        for (int x = 0; x < size; ++x)
        {
          const Number r = std::hypot(x - size / 2, row - size / 2) / Number(size);
          const Number exact =
            gain * (inside(outer, r) - (inner > 0.0 ? inside(inner, r) : Number(0)));
          squares += std::pow(static_cast<double>(rays.Get(x, 0) / gain - exact / gain), 2);
        }
        errors[level] = std::sqrt(squares / size);
      }
      EXPECT_LT(errors[2], 1e-3) << "k " << kernel << ", inner radius " << inner;
      EXPECT_GT(errors[0] / errors[2], 3.5) << "k " << kernel << ", inner radius " << inner;
    }
  }
}

// --- The same integral, evaluated differently -------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilter, EqualsBruteForce)
{
  std::mt19937 generator = MakeGenerator(1);
  vtkNew<Filter> filter;
  const double densities[] = { 0.0, 1e-6, 0.5, 1.0, 2.0 };
  const double listed[] = { 0.0, 0.5, 0.98, 1.0, 1.05 };
  double worst = 0.0;
  for (double density : densities)
  {
    for (double decay : listed)
    {
      for (int repetition = 0; repetition < 6; ++repetition)
      {
        const int width = 1 + generator() % 9;
        const int height = 1 + generator() % 9;
        const Picture picture = MakeNoise(width, height, 1, generator);
        filter->SetDensity(density);
        filter->SetDecay(decay);
        SetRandomLight(filter, width, height, 5.0, generator);
        const Problem problem(filter);
        const Picture rays = Scatter(filter, picture);
        const int x = generator() % width;
        const int y = generator() % height;
        const double gain = static_cast<double>(problem.Gain);
        const double expected = std::isinf(problem.K) ? gain * picture.Get(x, y)
                                                      : SumMidpoints(picture, problem, x, y, 0);
        worst = std::max(worst, std::abs(rays.Get(x, y) - expected) / gain);
        ASSERT_NEAR(rays.Get(x, y) / gain, expected / gain, 5e-8) << Describe(filter);
      }
    }
  }
  std::cout << "largest difference from 100 000 taps, of the peak: " << worst << "\n";
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, EqualsQuadrature)
{
  std::mt19937 generator = MakeGenerator(2);
  vtkNew<Filter> filter;
  const double densities[] = { 0.0, 1e-12, 1e-6, 0.01, 0.5, 0.97, 1.0, 2.0 };
  const int counts[] = { 1, 10, 100, 1024 };
  const int sizes[] = { 1, 2, 3, 5, 8, 13, 60 };
  double worst = 0.0;
  double worstRelative = 0.0;
  for (int i = 0; i < 600; ++i)
  {
    const int width = Pick(sizes, generator);
    const int height = Pick(sizes, generator);
    const Picture picture = MakeNoise(width, height, 1, generator);
    filter->SetDensity(Pick(densities, generator));
    filter->SetDecay(i % 40 == 0 ? 1e-300 : i % 40 == 1 ? 0.0 : Pick(decays, generator));
    filter->SetNumberOfSamples(Pick(counts, generator));
    SetRandomLight(filter, width, height, 1e6, generator);
    const Problem problem(filter);
    const Picture rays = Scatter(filter, picture);
    for (int pixel = 0; pixel < std::min(width * height, 16); ++pixel)
    {
      const int x = generator() % width;
      const int y = generator() % height;
      const Number expected = Integrate(picture, problem, x, y, 0);
      const Number difference = std::abs(rays.Get(x, y) - expected);
      worst = std::max(worst, static_cast<double>(difference / problem.Gain));
      ASSERT_LT(difference, 1e-13L * problem.Gain) << "case " << i << "\n" << Describe(filter);
      if (expected > 1e-3L * problem.Gain)
      {
        worstRelative = std::max(worstRelative, static_cast<double>(difference / expected));
        ASSERT_LT(difference, 1e-12L * expected) << "case " << i << "\n" << Describe(filter);
      }
    }
  }
  std::cout << "largest difference from quadrature, of the peak: " << worst
            << ", of the result: " << worstRelative << "\n";
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, StaysExactOnALargePicture)
{
  std::mt19937 generator = MakeGenerator(3);
  vtkNew<Filter> filter;
  const int width = 1921;
  const int height = 1079;
  const Picture picture = MakeNoise(width, height, 1, generator);
  filter->SetInputData(MakeImage(picture, VTK_FLOAT));
  Picture rounded = picture;
  for (double& value : rounded.Values)
  {
    value = static_cast<float>(value);
  }
  double worst = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    filter->SetDecay(Pick(decays, generator));
    SetRandomLight(filter, width, height, 1e6, generator);
    const int x = generator() % width;
    const int y = generator() % height;
    filter->UpdateExtent(std::array<int, 6>{ x, x, y, y, 0, 0 }.data());
    ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1);
    const Number expected = Integrate(rounded, Problem(filter), x, y, 0);
    const Number value = FromImage(filter->GetOutput()).Get(0, 0);
    worst = std::max(worst, static_cast<double>(std::abs(value - expected) / Problem(filter).Gain));
  }
  EXPECT_LT(worst, 1e-12);
  std::cout << "1921 x 1079: largest difference from quadrature, of the peak: " << worst << "\n";
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, HalvesOfTheMarchAddUp)
{
  // L = first half + d^(n/2) second half, the second being a march of its own from where the first
  // ends: at a pixel's centre. Half of the march has half of the samples.
  std::mt19937 generator = MakeGenerator(4);
  const Picture picture = MakeNoise(23, 17, 1, generator);
  vtkNew<Filter> filter;
  filter->SetDecay(0.97);
  const double rest = std::pow(0.97, 50);

  filter->SetLightDirection(6.0 / 23, -4.0 / 17);
  filter->SetDensity(1.0);
  Picture all = Scatter(filter, picture);
  filter->SetNumberOfSamples(50);
  filter->SetDensity(0.5);
  Picture first = Scatter(filter, picture);
  for (int y = 0; y < 17; ++y)
  {
    for (int x = 0; x < 23; ++x)
    {
      ASSERT_NEAR(first.Get(x, y) + rest * first.Get(x + 3, y - 2), all.Get(x, y), 1e-14);
    }
  }

  filter->SetNumberOfSamples(100);
  filter->SetLightPosition(8.5 / 23, 6.5 / 17);
  filter->SetDensity(1.0);
  all = Scatter(filter, picture);
  filter->SetNumberOfSamples(50);
  const Picture second = Scatter(filter, picture);
  filter->SetDensity(0.5);
  first = Scatter(filter, picture);
  for (int y = 0; y < 17; y += 2)
  {
    for (int x = 0; x < 23; x += 2)
    {
      ASSERT_NEAR(
        first.Get(x, y) + rest * second.Get((x + 8) / 2, (y + 6) / 2), all.Get(x, y), 1e-14);
    }
  }
}

// --- Limits -----------------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilter, LimitsLeaveThePixelItself)
{
  std::mt19937 generator = MakeGenerator(5);
  const Picture picture = MakeNoise(7, 6, 2, generator);
  auto expectItself = [&](Filter* filter, double gain)
  {
    const Picture rays = Scatter(filter, picture);
    for (std::size_t i = 0; i < picture.Values.size(); ++i)
    {
      ASSERT_NEAR(rays.Values[i], gain * picture.Values[i], 1e-15 * gain);
    }
  };
  vtkNew<Filter> filter;
  filter->SetExposure(2.0);
  filter->SetWeight(0.03);
  filter->SetDensity(0.0);
  expectItself(filter, static_cast<double>(Problem(filter).Gain));
  filter->SetDensity(1.0);
  filter->SetDecay(0.0);
  expectItself(filter, 2.0 * 0.03);
  filter->SetDecay(0.9);
  filter->SetLightDirection(0.0, 0.0);
  expectItself(filter, static_cast<double>(Problem(filter).Gain));
  filter->SetExposure(0.0);
  expectItself(filter, 0.0);

  // A light on a pixel: that pixel itself.
  filter->SetExposure(1.0);
  filter->SetLightPosition(2.5 / 7, 3.5 / 6);
  const double gain = static_cast<double>(Problem(filter).Gain);
  EXPECT_NEAR(Scatter(filter, picture).Get(2, 3, 1), gain * picture.Get(2, 3, 1), 1e-13 * gain);
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, IsContinuousInItsParameters)
{
  std::mt19937 generator = MakeGenerator(6);
  const Picture picture = MakeNoise(11, 9, 1, generator);
  vtkNew<Filter> filter;
  auto difference = [&](const std::function<void()>& change)
  {
    const Picture before = Scatter(filter, picture);
    change();
    return GetLargestDifference(before, Scatter(filter, picture)) / before.GetMaximum();
  };
  filter->SetLightPosition(0.8, 0.3);
  filter->SetDecay(0.98);
  EXPECT_LT(difference([&] { filter->SetDecay(0.98 + 1e-12); }), 1e-9);
  filter->SetDecay(1.0);
  EXPECT_LT(difference([&] { filter->SetDecay(1.0 + 1e-13); }), 1e-10);
  EXPECT_LT(difference([&] { filter->SetDecay(1.0 - 1e-13); }), 1e-10);
  filter->SetDecay(0.0);
  EXPECT_LT(difference([&] { filter->SetDecay(1e-300); }), 1e-3); // k = 69078
  EXPECT_LT(difference([&] { filter->SetDecay(5e-324); }), 1e-3);
  filter->SetDecay(0.95);
  filter->SetDensity(0.0);
  EXPECT_LT(difference([&] { filter->SetDensity(1e-12); }), 1e-10);
  EXPECT_LT(difference([&] { filter->SetDensity(1e-300); }), 1e-10);
  filter->SetDensity(0.97);
  filter->SetLightClip(0.4, 0.7, 1e-13); // through infinity
  EXPECT_LT(difference([&] { filter->SetLightClip(0.4, 0.7, 0.0); }), 1e-11);
  EXPECT_LT(difference([&] { filter->SetLightClip(0.4, 0.7, -1e-13); }), 1e-11);
  // On a line of pixel centres, and on a pixel.
  filter->SetLightPosition(4.5 / 11, 0.3);
  EXPECT_LT(difference([&] { filter->SetLightPosition(4.5 / 11 + 1e-13, 0.3); }), 1e-10);
  filter->SetLightPosition(4.5 / 11, 2.5 / 9);
  EXPECT_LT(difference([&] { filter->SetLightPosition(4.5 / 11 + 1e-13, 2.5 / 9); }), 1e-10);
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, IsFiniteAtTheEndsOfEveryRange)
{
  std::mt19937 generator = MakeGenerator(7);
  vtkNew<Filter> filter;
  for (int size : { 1, 2, 5 })
  {
    const Picture picture = MakeNoise(size, size, 1, generator);
    for (double far : { 0.0, 5e-324, 1e-30, 1.0, 1e30 })
    {
      for (double scale : { -1e30, 0.0, 1e-300, 1e30 })
      {
        for (double decay : { 0.0, 5e-324, 1.0, 1.05 })
        {
          filter->SetLightClip(far, -far, far);
          filter->SetMarchScale(scale);
          filter->SetDecay(decay);
          filter->SetNumberOfSamples(1024);
          filter->SetDensity(2.0);
          for (double value : Scatter(filter, picture).Values)
          {
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << Describe(filter);
          }
        }
      }
    }
  }
}

// --- Symmetries -------------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilter, IsLinear)
{
  std::mt19937 generator = MakeGenerator(8);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.2, 1.3);
  const Picture a = MakeNoise(129, 97, 1, generator);
  const Picture b = MakeNoise(129, 97, 1, generator);
  Picture sum = a;
  for (std::size_t i = 0; i < sum.Values.size(); ++i)
  {
    sum.Values[i] = 2.0 * a.Values[i] + 3.0 * b.Values[i];
  }
  Picture expected = Scatter(filter, a);
  const Picture raysB = Scatter(filter, b);
  for (std::size_t i = 0; i < sum.Values.size(); ++i)
  {
    expected.Values[i] = 2.0 * expected.Values[i] + 3.0 * raysB.Values[i];
  }
  EXPECT_LT(GetLargestDifference(Scatter(filter, sum), expected), 1e-13 * expected.GetMaximum());
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, TurnsAndMirrorsWithThePicture)
{
  std::mt19937 generator = MakeGenerator(9);
  vtkNew<Filter> filter;
  for (int i = 0; i < 20; ++i)
  {
    const int width = 3 + generator() % 20;
    const int height = 5 + generator() % 20;
    const Picture picture = MakeNoise(width, height, 1, generator);
    filter->SetDecay(Pick(decays, generator));
    SetRandomLight(filter, width, height, 100.0, generator);
    const double* clip = filter->GetLightClip();
    const double light[3] = { clip[0], clip[1], clip[2] };
    const Picture rays = Scatter(filter, picture);
    auto mirror = [&](const Picture& p)
    { return MakePicture(width, height, [&](int x, int y) { return p.Get(width - 1 - x, y); }); };
    auto turn = [&](const Picture& p)
    { return MakePicture(height, width, [&](int x, int y) { return p.Get(y, height - 1 - x); }); };

    const double peak = static_cast<double>(Problem(filter).Gain);
    filter->SetLightClip(-light[0], light[1], light[2]);
    ASSERT_LT(GetLargestDifference(Scatter(filter, mirror(picture)), mirror(rays)), 1e-13 * peak);
    filter->SetLightClip(-light[1], light[0], light[2]);
    ASSERT_LT(GetLargestDifference(Scatter(filter, turn(picture)), turn(rays)), 1e-13 * peak);
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilter, ScalesWithThePicture)
{
  // The reconstruction of a picture, read on a grid three times as fine that includes the fall to 0
  // beyond its edges, is the same function: so are the rays.
  std::mt19937 generator = MakeGenerator(10);
  const int width = 9;
  const int height = 7;
  const Picture coarse = MakeNoise(width, height, 1, generator);
  const Picture fine = MakePicture(3 * (width + 1) + 1, 3 * (height + 1) + 1,
    [&](int x, int y) { return coarse.Read(x / 3.0 - 1.0, y / 3.0 - 1.0); });
  vtkNew<Filter> filter;
  for (const auto& light : std::vector<std::array<double, 2>>{ { 0.3, 0.8 }, { -1.2, 0.4 } })
  {
    filter->SetLightPosition(light[0], light[1]);
    const Picture expected = Scatter(filter, coarse);
    auto toFine = [](double fraction, int coarseSize, int fineSize)
    { return (3.0 * (fraction * coarseSize + 0.5) + 0.5) / fineSize; };
    filter->SetLightPosition(
      toFine(light[0], width, fine.Width), toFine(light[1], height, fine.Height));
    const Picture rays = Scatter(filter, fine);
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        ASSERT_NEAR(rays.Get(3 * (x + 1), 3 * (y + 1)), expected.Get(x, y), 1e-13);
      }
    }
  }
}
