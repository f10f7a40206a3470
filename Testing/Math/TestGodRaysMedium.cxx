// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Light that a medium scatters: phase functions and closed forms against adaptive quadrature in long
// double and published numbers. In single precision, too: the same text as the graphics card's, with
// numbers that are rounded as it does.

#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

using namespace vtkGodRays;

namespace
{
const double pi = 3.14159265358979323846;
using Long = long double;
using Integrand = std::function<Long(Long)>;

// Gauss-Legendre of 8 points, and again of both halves until they agree.
Long Panel(const Integrand& f, Long a, Long b)
{
  const Long place[] = { 0.18343464249564980494L, 0.52553240991632898582L, 0.79666647741362673959L,
    0.96028985649753623168L };
  const Long weight[] = { 0.36268378337836198297L, 0.31370664587788728734L, 0.22238103445337447054L,
    0.10122853629037625915L };
  Long sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    sum += weight[i] *
      (f((a + b) / 2 - place[i] * (b - a) / 2) + f((a + b) / 2 + place[i] * (b - a) / 2));
  }
  return sum * (b - a) / 2;
}
Long Integrate(const Integrand& f, Long a, Long b, Long tolerance, Long whole, int depth)
{
  const Long middle = (a + b) / 2;
  const Long left = Panel(f, a, middle);
  const Long right = Panel(f, middle, b);
  if (std::abs(left + right - whole) <= tolerance || depth == 0)
  {
    return left + right;
  }
  return Integrate(f, a, middle, tolerance, left, depth - 1) +
    Integrate(f, middle, b, tolerance, right, depth - 1);
}
// To a fraction of the integral of a positive function. breaks: where it is not smooth, or steep.
Long Integrate(const Integrand& f, Long a, Long b, std::initializer_list<Long> breaks = {},
  Long relative = 1e-12L)
{
  std::vector<Long> ends(breaks);
  ends.push_back(a);
  ends.push_back(b);
  std::sort(ends.begin(), ends.end());
  Long size = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const Long low = std::min(std::max(ends[i], a), b);
    const Long high = std::min(std::max(ends[i + 1], a), b);
    size += std::abs(Integrate(f, low, high, 1e-4L * Panel(f, low, high), Panel(f, low, high), 24));
  }
  Long sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const Long low = std::min(std::max(ends[i], a), b);
    const Long high = std::min(std::max(ends[i + 1], a), b);
    sum += Integrate(f, low, high, relative * size, Panel(f, low, high), 24);
  }
  return sum;
}

// Each phase function once more, as it is printed.
Long PrintedPhase(int kind, Long g, Long c)
{
  const Long k = std::min(0.995L, std::max(-0.995L, 1.55L * g - 0.55L * g * g * g));
  const Long d = 1 + g * g - 2 * g * c;
  switch (kind)
  {
    case PHASE_RAYLEIGH:
      return 3 / (16 * Long(pi)) * (1 + c * c);
    case PHASE_HENYEY_GREENSTEIN:
      return (1 - g * g) / (4 * Long(pi) * std::pow(d, 1.5L));
    case PHASE_CORNETTE_SHANKS:
      return 3 / (8 * Long(pi)) * (1 - g * g) / (2 + g * g) * (1 + c * c) / std::pow(d, 1.5L);
    case PHASE_SCHLICK:
      return (1 - k * k) / (4 * Long(pi) * (1 - k * c) * (1 - k * c));
    default:
      return 1 / (4 * Long(pi));
  }
}

class Random
{
public:
  double Uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Generator);
  }
  double Magnitude(double low, double high)
  {
    return std::exp(this->Uniform(std::log(low), std::log(high)));
  }
  PhaseFunction Phase()
  {
    return { static_cast<int>(this->Generator() % (vtkGodRaysLastPhaseFunction + 1)),
      this->Uniform(-0.99, 0.99) };
  }

private:
  std::mt19937 Generator{ 11 };
};

// By how much more than a fraction of what is expected an actual value is off.
void ExpectRatio(double actual, Long expected, double tolerance, double& worst)
{
  const double error = static_cast<double>(std::abs(actual / expected - 1));
  worst = std::max(worst, error);
  EXPECT_LE(error, tolerance) << actual << " instead of " << static_cast<double>(expected);
}
}

//------------------------------------------------------------------------------
TEST(Medium, PhaseFunctionsAreThePublishedOnes)
{
  Random random;
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const PhaseFunction phase = random.Phase();
    const double c = i % 7 == 0 ? 1.0 : i % 7 == 1 ? -1.0 : random.Uniform(-1.0, 1.0);
    ExpectRatio(Phase(phase, c), PrintedPhase(phase.Kind, phase.Asymmetry, c), 1e-11, worst);
  }
  std::cout << "phase functions, largest relative difference " << worst << "\n";

  EXPECT_NEAR(PhaseHenyeyGreenstein(1.0, 0.76), 2.43153, 1e-5);
  EXPECT_NEAR(PhaseCornetteShanks(1.0, 0.76), 2.83000, 1e-5);
  EXPECT_NEAR(PhaseCornetteShanks(1.0, 0.8), 4.06930, 1e-5);
  EXPECT_NEAR(PhaseRayleigh(1.0), 0.119366, 1e-6);
  EXPECT_DOUBLE_EQ(PhaseCornetteShanks(0.3, 0.0), PhaseRayleigh(0.3));
}

//------------------------------------------------------------------------------
// One convention for all: g > 0 is light that goes on, and that is seen when looking at it.
TEST(Medium, PositiveAsymmetryIsForwards)
{
  for (int kind = 0; kind <= vtkGodRaysLastPhaseFunction; ++kind)
  {
    if (!PhaseHasAsymmetry(kind))
    {
      EXPECT_EQ(Phase({ kind, 0.6 }, 0.8), Phase({ kind, -0.6 }, 0.8));
      EXPECT_EQ(PhaseForwardPeak({ kind, 0.6 }), 0.0);
      continue;
    }
    EXPECT_DOUBLE_EQ(PhaseForwardPeak({ kind, 0.6 }), 0.36);
    EXPECT_EQ(PhaseForwardPeak({ kind, -0.6 }), 0.0);
    EXPECT_GT(Phase({ kind, 0.6 }, 1.0), 2.0 * Phase({ kind, 0.6 }, 0.0));
    EXPECT_GT(Phase({ kind, 0.6 }, 0.0), Phase({ kind, 0.6 }, -1.0));
    EXPECT_DOUBLE_EQ(Phase({ kind, -0.6 }, -0.8), Phase({ kind, 0.6 }, 0.8));
  }
  // Towards a point light that is ahead the ray meets light that goes on into the eye.
  const PhaseFunction forwards = { 2, 0.8 };
  const PhaseFunction backwards = { 2, -0.8 };
  EXPECT_GT(PointAirlight(forwards, 0.1, 9.0, 1.0, 0.0, 5.0),
    10.0 * PointAirlight(backwards, 0.1, 9.0, 1.0, 0.0, 5.0));
}

//------------------------------------------------------------------------------
TEST(Medium, PhaseFunctionsIntegrateToOne)
{
  Random random;
  double worst = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const PhaseFunction phase = random.Phase();
    Long mean = 0;
    const auto integral = [&](int power)
    {
      return Integrate([&](Long c)
        { return 2 * Long(pi) * Phase(phase, static_cast<double>(c)) * std::pow(1 + c, power); },
        -1, 1, { -0.99L, 0.99L });
    };
    ExpectRatio(static_cast<double>(integral(0)), 1, 1e-9, worst);
    mean = integral(1) - 1;
    const double g = phase.Asymmetry;
    const double expected = !PhaseHasAsymmetry(phase.Kind) ? 0.0
      : phase.Kind == PHASE_HENYEY_GREENSTEIN              ? g
      : phase.Kind == PHASE_CORNETTE_SHANKS ? 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g))
                                            : mean;
    EXPECT_NEAR(static_cast<double>(mean), expected, 1e-9);
    if (phase.Kind == PHASE_SCHLICK)
    {
      EXPECT_NEAR(static_cast<double>(mean), g, 0.075); // Schlick's is near to it only
    }
  }
  std::cout << "integrals, largest difference from 1: " << worst << "\n";
}

//------------------------------------------------------------------------------
// The kinds have their formulas, and where one is not finite its poles are.
TEST(Medium, PolesOfPhaseFunctions)
{
  for (int kind = 0; kind <= vtkGodRaysLastPhaseFunction; ++kind)
  {
    EXPECT_EQ(PhasePole({ kind, -0.6 }), 1.0);
    const double square = -std::pow(PhasePole({ kind, 0.6 }), 2.0); // t^2
    if (!PhaseHasAsymmetry(kind))
    {
      EXPECT_EQ(square, -1.0);
      continue;
    }
    const Long c = (1.0L - square) / (1.0L + square);
    EXPECT_GT(c, 1.0L);
    EXPECT_GT(std::abs(PrintedPhase(kind, 0.6L, c - 1e-9L)), 1e6L) << kind;
  }
}

//------------------------------------------------------------------------------
// A mix is as much light as its parts, in the mean direction of both.
TEST(Medium, PhaseFunctionsMix)
{
  Random random;
  double worst = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    const PhaseFunction first = { 2, random.Uniform(-0.9, 0.9) };
    const PhaseFunction second = { 2, random.Uniform(-0.9, 0.9) };
    const double weight = random.Uniform(0.0, 1.0);
    const auto integral = [&](int power)
    {
      return static_cast<double>(Integrate(
        [&](Long c)
        {
          return 2 * Long(pi) * PhaseMix(first, second, weight, static_cast<double>(c)) *
            std::pow(1 + c, power);
        },
        -1, 1, { -0.99L, 0.99L }));
    };
    ExpectRatio(integral(0), 1, 1e-9, worst);
    EXPECT_NEAR(
      integral(1) - 1.0, (1.0 - weight) * first.Asymmetry + weight * second.Asymmetry, 1e-9);
  }
  EXPECT_DOUBLE_EQ(PhaseMix({ 1, 0.0 }, { 2, 0.5 }, 0.0, 0.3), PhaseRayleigh(0.3));
  EXPECT_DOUBLE_EQ(PhaseMix({ 1, 0.0 }, { 2, 0.5 }, 1.0, 0.3), PhaseHenyeyGreenstein(0.3, 0.5));
}

//------------------------------------------------------------------------------
// Worked examples, computed by others than this code.
TEST(Medium, GoldenNumbers)
{
  double worst = 0.0;
  const double extinction = 0.02 + 0.005;
  ExpectRatio(0.02 * PhaseHenyeyGreenstein(std::cos(0.5), 0.3) *
      DirectionalAirlight(extinction, 0.0, 50.0, 0.0, 0.0),
    0.09773023948157L, 1e-12, worst);
  const double foot = 5.0 * std::cos(0.7);
  const double height = 5.0 * std::sin(0.7);
  ExpectRatio(0.02 * PhaseIsotropic() * PointAirlight(foot, height, 0.0, 12.0), 1.02095889680e-3L,
    1e-10, worst);
  ExpectRatio(0.1 * PointAirlight({ 0, 0.0 }, 0.1, foot, height, 0.0, 12.0), 2.2285545022389e-3L,
    1e-10, worst);
  ExpectRatio(ExponentialDepth(4.44e-6, 100.0, 0.2, 1200.0, 2e4), 0.0236356142279L, 1e-11, worst);
  ExpectRatio(
    1.8e-4 * PhaseIsotropic() * ExponentialAirlight(2e-4, 100.0, 0.2, 0.6, 1200.0, 0.0, 2e4),
    0.0377894374195L, 1e-11, worst);
  std::cout << "golden numbers, largest relative difference " << worst << "\n";
}

//------------------------------------------------------------------------------
TEST(Medium, DirectionalAirlightIsTheIntegral)
{
  Random random;
  double worst = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    const double begin = i % 2 == 0 ? 0.0 : random.Magnitude(1e-3, 10.0);
    const double end = begin + random.Magnitude(1e-4, 1e3);
    const double tau = random.Magnitude(1e-9, 50.0);
    const double slope = random.Uniform(-3.0, 3.0);
    const double way = std::max(0.0, -slope * end) + random.Uniform(0.0, 1.0) * end;
    const double extinction = tau / end;
    const Long expected =
      Integrate([&](Long s) { return std::exp(-extinction * (s + way + slope * s)); }, begin, end);
    ExpectRatio(DirectionalAirlight(extinction, begin, end, way, slope), expected, 1e-12, worst);
  }
  std::cout << "largest relative difference " << worst << "\n";
}

//------------------------------------------------------------------------------
TEST(Medium, PointAirlightIsTheIntegral)
{
  Random random;
  double worst = 0.0;
  double worstClear = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    const double distance = random.Magnitude(1e-2, 1e2);
    const double angle = i % 3 == 0 ? random.Magnitude(1e-4, 1.0) : random.Uniform(0.0, pi);
    const double foot = distance * std::cos(angle);
    const double height = distance * std::sin(angle);
    const double begin = i % 2 == 0 ? 0.0 : random.Magnitude(1e-3, 10.0);
    const double end = begin + random.Magnitude(1e-3, 1e4);
    const double extinction = random.Magnitude(1e-9, 30.0) / (distance + begin);
    const PhaseFunction phase = random.Phase();
    // With s = foot + h tan a the integrand is smooth but for steep ends.
    const Long h = height;
    const Long first = std::atan2(Long(begin) - foot, h);
    const Long last = std::atan2(Long(end) - foot, h);
    const auto integrand = [&](Long a, bool dimmed)
    {
      const Long beyond = h * std::tan(a);
      const Long r = h / std::cos(a);
      const Long c = -std::sin(a);
      return dimmed ? PrintedPhase(phase.Kind, phase.Asymmetry, c) *
          std::exp(-Long(extinction) * (beyond - h * std::tan(first) + r - h / std::cos(first))) / h
                    : 1 / h;
    };
    // What is left where it begins is compared, to see also what is small.
    const double rBegin = std::hypot(height, begin - foot);
    const Long expected =
      Integrate([&](Long a) { return integrand(a, true); }, first, last, {}, 1e-10L) *
      std::exp(-Long(extinction) * (begin + rBegin));
    ExpectRatio(PointAirlight(phase, extinction, foot, height, begin, end), expected, 1e-9, worst);
    ExpectRatio(PointAirlight(foot, height, begin, end),
      Integrate([&](Long a) { return integrand(a, false); }, first, last), 1e-10, worstClear);
  }
  std::cout << "largest relative difference " << worst << ", without extinction " << worstClear
            << "\n";
}

//------------------------------------------------------------------------------
// The function that [Sun2005] tabulates, integrated, gives the same.
TEST(Medium, PointAirlightIsSunsForAnIsotropicMedium)
{
  double worst = 0.0;
  for (const double extinction : { 0.01, 0.3, 2.0 })
  {
    for (const double angle : { 0.05, 0.7, 1.6, 3.0 })
    {
      for (const double end : { 0.5, 4.0, 60.0 })
      {
        const Long distance = 3.0L;
        const Long tsv = extinction * distance;
        const Long u = tsv * std::sin(Long(angle));
        // F(u, last) - F(u, first)
        const Long first = Long(angle) / 2;
        const Long last =
          Long(pi) / 4 + std::atan((extinction * Long(end) - tsv * std::cos(Long(angle))) / u) / 2;
        const Long difference =
          Integrate([&](Long xi) { return std::exp(-u * std::tan(xi)); }, first, last);
        const Long expected = Long(extinction) * extinction *
          std::exp(-tsv * std::cos(Long(angle))) / (2 * Long(pi) * u) * difference;
        const double actual = extinction *
          PointAirlight(
            { 0, 0.0 }, extinction, 3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.0, end);
        ExpectRatio(actual, expected, 1e-9, worst);
      }
    }
  }
  std::cout << "largest relative difference " << worst << "\n";
}

//------------------------------------------------------------------------------
TEST(Medium, ExponentialAirlightIsTheIntegral)
{
  Random random;
  double worst = 0.0;
  double worstDepth = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    const double scaleHeight = random.Magnitude(0.1, 1e4);
    const double height = scaleHeight * random.Uniform(0.0, 3.0);
    const double slope = i % 5 == 0 ? random.Uniform(-1e-9, 1e-9) : random.Uniform(-1.0, 1.0);
    const double lightSlope = random.Uniform(0.05, 1.0);
    double length = scaleHeight * random.Magnitude(1e-3, 30.0);
    if (slope < 0.0)
    {
      length = std::min(length, 1.5 * height / -slope);
    }
    const double begin = i % 2 == 0 ? 0.0 : 0.3 * length;
    const double extinction = random.Magnitude(1e-9, 10.0) / scaleHeight;
    const auto depth = [&](Long from, Long rise, Long distance)
    {
      const Long z = rise * distance / scaleHeight;
      return extinction * distance * std::exp(-from / scaleHeight) *
        (std::abs(z) < 1e-15L ? 1 : -std::expm1(-z) / z);
    };
    ExpectRatio(ExponentialDepth(extinction, height, slope, scaleHeight, length),
      depth(height, slope, length), 1e-12, worstDepth);
    const auto start = [&](Long s)
    {
      const Long h = height + slope * s;
      return depth(height, slope, s) +
        extinction * scaleHeight * std::exp(-h / scaleHeight) / lightSlope;
    };
    // Where little is left: compared with what is left there.
    const Long least = std::min(start(begin), start(length));
    const Long expected = Integrate([&](Long s)
      { return std::exp(-(height + slope * s) / scaleHeight - (start(s) - least)); },
      begin, length);
    ExpectRatio(
      ExponentialAirlight(extinction, height, slope, lightSlope, scaleHeight, begin, length) *
        static_cast<double>(std::exp(least)),
      expected, 1e-10, worst);
  }
  std::cout << "largest relative difference " << worst << ", optical depth " << worstDepth << "\n";
}

//------------------------------------------------------------------------------
TEST(Medium, PartsAddUp)
{
  Random random;
  for (int i = 0; i < 500; ++i)
  {
    const double b = random.Magnitude(1e-6, 5.0);
    const double middle = random.Uniform(0.1, 5.0);
    const double end = middle + random.Uniform(0.1, 5.0);
    const PhaseFunction phase = random.Phase();
    const auto expectSum = [&](const std::function<double(double, double)>& part, double tolerance)
    {
      const double whole = part(0.0, end);
      EXPECT_NEAR(part(0.0, middle) + part(middle, end), whole, tolerance * whole);
    };
    expectSum(
      [&](double from, double to) { return DirectionalAirlight(b, from, to, 0.1, 0.3); }, 1e-13);
    expectSum([&](double from, double to) { return PointAirlight(2.0, 0.7, from, to); }, 1e-13);
    expectSum(
      [&](double from, double to) { return PointAirlight(phase, b, 2.0, 0.7, from, to); }, 1e-9);
    expectSum([&](double from, double to)
      { return ExponentialAirlight(b, 0.5, -0.3, 0.4, 2.0, from, to); },
      1e-12);
  }
}

//------------------------------------------------------------------------------
// Neither NaN nor infinity, nor less than nothing; and never more light than without extinction.
TEST(Medium, IsFiniteForAnyMedium)
{
  Random random;
  for (int i = 0; i < 20000; ++i)
  {
    const double b = i % 17 == 0 ? 0.0 : random.Magnitude(1e-12, 1e3);
    const double begin = i % 3 == 0 ? 0.0 : random.Magnitude(1e-6, 1e9);
    const double end = begin + (i % 19 == 0 ? 0.0 : random.Magnitude(1e-6, 1e9));
    const double distance = i % 13 == 0 ? 0.0 : random.Magnitude(1e-6, 1e9);
    const double angle = i % 11 == 0 ? 0.0 : i % 11 == 1 ? pi : random.Uniform(0.0, pi);
    const double foot = distance * std::cos(angle);
    const double height = distance * std::sin(angle);
    const PhaseFunction phase = random.Phase();
    const double lightSlope = random.Uniform(-1.0, 1.0);
    const double lightWay = std::max(0.0, -lightSlope * end);
    const double directional = DirectionalAirlight(b, begin, end, lightWay, lightSlope);
    EXPECT_TRUE(directional >= 0.0 && directional <= (end - begin) * (1.0 + 1e-12)) << directional;
    const double clear = PointAirlight(foot, height, begin, end);
    EXPECT_TRUE(clear >= 0.0 && std::isfinite(clear)) << clear;
    const double point = PointAirlight(phase, b, foot, height, begin, end);
    const double brightest = std::max(Phase(phase, 1.0), Phase(phase, -1.0));
    EXPECT_TRUE(point >= 0.0 && point <= brightest * clear * (1.0 + 1e-6))
      << point << " of " << clear;
    const double sky =
      ExponentialAirlight(b, random.Uniform(-1.0, 1.0) * 1e4, random.Uniform(-1.0, 1.0),
        random.Magnitude(1e-3, 1.0), random.Magnitude(1.0, 1e4), begin, end);
    EXPECT_TRUE(sky >= 0.0 && std::isfinite(sky)) << sky;
  }
}

//------------------------------------------------------------------------------
// A white medium under an isotropic phase function sends no more light on than it takes away.
TEST(Medium, GivesNoMoreThanItTakes)
{
  Random random;
  for (int i = 0; i < 1000; ++i)
  {
    const double b = random.Magnitude(1e-9, 1e3);
    const double end = random.Magnitude(1e-3, 1e3);
    const double scattered = b * DirectionalAirlight(b, 0.0, end, 0.0, 0.0);
    EXPECT_NEAR(scattered + Transmittance(b, end), 1.0, 1e-12);
  }
}

TEST(Medium, FractionsEndAtTheirPlaces)
{
  Random random;
  for (int i = 0; i < 1000; ++i)
  {
    LitRay ray = {};
    ray.Infinite = i % 2;
    ray.Foot = random.Uniform(-20.0, 20.0);
    ray.Distance = i % 7 == 0 ? 0.0 : random.Magnitude(1e-3, 1e2);
    const double begin = random.Uniform(0.0, 10.0);
    const double end = begin + random.Magnitude(1e-3, 1e2);
    for (const double fraction : { 0.0, 0.01, 0.5, 0.99, 1.0 })
    {
      // Where the ray goes through the light, nearly all of the way there is at the light.
      const double place = MediumPlace(ray, begin, end, fraction);
      const double found = MediumFraction(ray, begin, end, place);
      EXPECT_NEAR(MediumPlace(ray, begin, end, found), place, 1e-6 * (end - begin)) << i;
    }
  }
}

// Cells follow on each other to the end of the way, and have what is between.
TEST(Walk, GoesThroughTheCellsOfTheWay)
{
  Random random;
  for (int i = 0; i < 2000; ++i)
  {
    const int width = 1 + static_cast<int>(random.Uniform(0.0, 40.0));
    const int height = 1 + static_cast<int>(random.Uniform(0.0, 40.0));
    int top = 0;
    while ((std::max(width, height) - 1) >> top > 0)
    {
      ++top;
    }
    double from[2] = { random.Uniform(0.0, width), random.Uniform(0.0, height) };
    double to[2] = { random.Uniform(0.0, width), random.Uniform(0.0, height) };
    if (i % 3 == 0) // along edges, or nowhere
    {
      from[i % 2] = to[i % 2] = std::floor(from[i % 2]);
    }
    if (i % 33 == 0)
    {
      from[1 - i % 2] = to[1 - i % 2];
    }
    MapWalk walk = BeginWalk(from[0], from[1], to[0], to[1], width, height, top);
    double last = 0.0;
    int guard = 16 * (width + height) + 64;
    do
    {
      FindEnd(walk);
      if (walk.Level > 0 && random.Uniform(0.0, 1.0) < 0.6)
      {
        --walk.Level;
        continue;
      }
      ASSERT_EQ(walk.Begin, last) << i;
      ASSERT_GE(walk.End, last) << i;
      last = walk.End;
      const double middle = 0.5 * (walk.Begin + walk.End);
      const double x = (from[0] + middle * (to[0] - from[0])) / (1 << walk.Level);
      const double y = (from[1] + middle * (to[1] - from[1])) / (1 << walk.Level);
      ASSERT_NEAR(x, (walk.X >> walk.Level) + 0.5, 0.5 + 1e-9) << i;
      ASSERT_NEAR(y, (walk.Y >> walk.Level) + 0.5, 0.5 + 1e-9) << i;
      if (!GoOn(walk))
      {
        break;
      }
    } while (--guard > 0);
    EXPECT_GT(guard, 0) << i;
    EXPECT_GT(last, 1.0 - 1e-9) << i;
  }
}

TEST(Walk, PlanesOfTexelsGoOnOnBothSidesOrNot)
{
  const double nothing = -1e30;
  EXPECT_EQ(TexelSlope(1.0, 2.0, 3.0), 1.0);
  EXPECT_EQ(TexelSlope(1.0, 2.0, 2.5), 0.5);
  EXPECT_EQ(TexelSlope(3.0, 2.0, 1.5), -0.5);
  EXPECT_EQ(TexelSlope(1.0, 2.0, 1.0), 0.0);
  EXPECT_EQ(TexelSlope(nothing, 2.0, 2.5), 0.5);
  EXPECT_EQ(TexelSlope(nothing, 2.0, 1.5), 0.0);
  EXPECT_EQ(TexelSlope(nothing, 2.0, nothing), 0.0);
}

TEST(Medium, AirlightOfPartsIsTheClosedForm)
{
  const MediumComponent dust = { 0.04, 0.05, 0.0, { 2, 0.6 }, { 0, 0.0 }, 0.0 };
  const MediumComponent none = { 0.0, 0.0, 0.0, { 0, 0.0 }, { 0, 0.0 }, 0.0 };
  const MediumComponent thin = { 0.04, 0.05, 4.0, { 2, 0.6 }, { 0, 0.0 }, 0.0 };
  const LitRay sun = { 1, 0.7, 0.0, 1.0, 0.2, 0.5, 0.0, 0.0, 0.0, { 0.0, 0.0 }, 0 };
  const LitRay lamp = { 0, 8.0, 0.5, 1.0, 0.2, 2.5, 0.0, 0.0, 0.0, { 0.0, 0.0 }, 0 };
  const auto sum = [](const MediumComponent& a, const MediumComponent& b, const LitRay& ray)
  {
    double all = 0.0;
    for (int i = 0; i < 32; ++i)
    {
      all += MediumAirlight(a, b, ray, MediumPlace(ray, 0.0, 20.0, i / 32.0),
        MediumPlace(ray, 0.0, 20.0, (i + 1) / 32.0));
    }
    return all;
  };
  const double phase = PhaseHenyeyGreenstein(0.7, 0.6);
  EXPECT_NEAR(
    sum(dust, none, sun) / (0.04 * phase * DirectionalAirlight(0.05, 0.0, 20.0, 0.0, 0.0)), 1.0,
    1e-12);
  EXPECT_NEAR(sum(thin, none, sun) /
      (0.04 * phase * ExponentialAirlight(0.05, 1.0, 0.2, 0.5, 4.0, 0.0, 20.0)),
    1.0, 1e-12);
  EXPECT_NEAR(sum(dust, none, lamp) / (0.04 * PointAirlight(dust.First, 0.05, 8.0, 0.5, 0.0, 20.0)),
    1.0, 1e-5);
  // halves of a medium are the medium, by the quadrature
  MediumComponent half = thin;
  half.Scattering *= 0.5;
  half.Extinction *= 0.5;
  EXPECT_NEAR(sum(half, half, sun) / sum(thin, none, sun), 1.0, 1e-5);
}
