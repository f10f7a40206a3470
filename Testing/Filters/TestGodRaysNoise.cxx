// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Noise: bounds, moments, gradients against differences, random numbers that are even.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysNoise.h"

using namespace GodRaysFiltersTesting;
using namespace vtkGodRaysNoise;

namespace
{
template <typename Function>
void ExpectGradient(const Function& noise, const Vector& position, double tolerance)
{
  constexpr double step = 1e-5;
  const Sample sample = noise(position);
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector before = position;
    Vector after = position;
    before[axis] -= step;
    after[axis] += step;
    const double slope = (noise(after).Value - noise(before).Value) / (2.0 * step);
    EXPECT_NEAR(sample.Gradient[axis], slope, tolerance) << axis;
  }
}
}

//------------------------------------------------------------------------------
TEST(Noise, HasItsBoundsAndMoments)
{
  std::mt19937 generator = MakeGenerator(3);
  std::uniform_real_distribution<double> anywhere(-300.0, 300.0);
  const Fractal fractal{ 4, 0.6, 2.1, 5 };
  double mean = 0.0;
  double square = 0.0;
  double fractalSquare = 0.0;
  double largest = 0.0;
  constexpr int count = 400000;
  for (int i = 0; i < count; ++i)
  {
    const Vector position = { anywhere(generator), anywhere(generator), anywhere(generator) };
    const double value = GradientNoise(position, 9).Value;
    mean += value / count;
    square += value * value / count;
    largest = std::max(largest, std::abs(value));
    const double sum = fractal.Evaluate(position).Value;
    fractalSquare += sum * sum / count;
    ASSERT_LE(std::abs(sum), 1.0);
  }
  EXPECT_NEAR(mean, 0.0, 0.002);
  EXPECT_NEAR(std::sqrt(square), RootMeanSquare, 0.002);
  EXPECT_NEAR(std::sqrt(fractalSquare) / fractal.GetRootMeanSquare(), 1.0, 0.01);
  EXPECT_LE(largest, 1.0);
  EXPECT_GT(largest, 0.85);
}

//------------------------------------------------------------------------------
TEST(Noise, GradientsAreThoseOfTheValues)
{
  std::mt19937 generator = MakeGenerator(4);
  std::uniform_real_distribution<double> anywhere(-50.0, 50.0);
  const Fractal fractal{ 3, 0.5, 2.0, 5 };
  for (int i = 0; i < 200; ++i)
  {
    // Whole coordinates are the seams of the lattice.
    const double z = i % 2 == 0 ? anywhere(generator) : std::floor(anywhere(generator));
    const Vector position = { anywhere(generator), anywhere(generator), z };
    ExpectGradient([](const Vector& p) { return GradientNoise(p, 7); }, position, 1e-7);
    ExpectGradient([&](const Vector& p) { return fractal.Evaluate(p); }, position, 1e-6);
    EXPECT_EQ(GradientNoise({ std::floor(position[0]), 3.0, -4.0 }, 7).Value, 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(Noise, RandomNumbersAreEvenAndIndependent)
{
  constexpr int count = 100000;
  std::vector<int> histogram(20);
  double product = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double first = Uniform(MakeSeed(1, 0), i);
    const double second = Uniform(MakeSeed(1, 1), i);
    ASSERT_GE(first, 0.0);
    ASSERT_LT(first, 1.0);
    ++histogram[static_cast<std::size_t>(20.0 * first)];
    product += (first - 0.5) * (second - 0.5) / count;
  }
  for (int bin : histogram)
  {
    EXPECT_NEAR(bin, count / 20, 5.0 * std::sqrt(count / 20.0));
  }
  EXPECT_NEAR(product, 0.0, 5.0 / 12.0 / std::sqrt(1.0 * count));
  EXPECT_NE(Uniform(1, 7), Uniform(1, 7 + (std::uint64_t(1) << 32)));
}

//------------------------------------------------------------------------------
TEST(Noise, StepsAreSmooth)
{
  EXPECT_EQ(SmoothStep(1.0, 3.0, 1.0), 0.0);
  EXPECT_EQ(SmoothStep(1.0, 3.0, 2.0), 0.5);
  EXPECT_EQ(SmoothStep(1.0, 3.0, 3.0), 1.0);
  EXPECT_EQ(SmoothStep(2.0, 2.0, 1.999), 0.0);
  EXPECT_EQ(SmoothStep(2.0, 2.0, 2.0), 1.0);
  EXPECT_EQ(SmoothStep(HUGE_VAL, HUGE_VAL, 5.0), 0.0);
  EXPECT_EQ(SmoothStep(-HUGE_VAL, -HUGE_VAL, 5.0), 1.0);
}
