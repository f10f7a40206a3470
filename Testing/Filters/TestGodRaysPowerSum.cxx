// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysPowerSum: the bound that it gives for the error of its kernel is one, for any picture, and
// is what was asked for.

#include "vtkGodRaysPowerSum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

using namespace vtkGodRays;

namespace
{
/// The kernel less its power sum, and the kernel, at the middle of many equal steps of t.
struct Difference
{
  std::vector<double> Values;
  double Mean = 0.0; // of the kernel

  Difference(const PowerSum& sum, double k, double d, double end)
  {
    const int steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
      const double t = end * (i + 0.5) / steps;
      const double u = 1.0 - d * t;
      double approximation = 0.0;
      for (int j = 0; j < sum.Count; ++j)
      {
        approximation += sum.Factors[j] * std::pow(u, sum.Powers[j]);
      }
      this->Values.push_back((std::exp(-k * t) - approximation) / steps);
      this->Mean += std::exp(-k * t) / steps;
    }
  }

  double GetError(const std::vector<double>& picture) const
  {
    double error = 0.0;
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      error += this->Values[i] * picture[i];
    }
    return std::abs(error) / this->Mean;
  }
};

class PowerSumBound : public ::testing::TestWithParam<std::tuple<double, double>>
{
};
}

TEST_P(PowerSumBound, HoldsForAnyPictureAndIsAsAskedFor)
{
  const double k = std::get<0>(GetParam());
  const double d = std::get<1>(GetParam());
  for (double tolerance : { 1e-2, 1.6e-3, 4e-4 })
  {
    const PowerSum sum = FitPowerSum(k, d, 1.0, tolerance);
    ASSERT_GE(sum.Count, 1);
    ASSERT_LE(sum.Count, MaximumPowers);
    EXPECT_LE(sum.Bound, tolerance) << sum.Count;

    // the worst picture is 1 just where the difference has one sign
    const Difference difference(sum, k, d, 1.0);
    double worst = 0.0;
    for (double sign : { 1.0, -1.0 })
    {
      std::vector<double> picture;
      for (double value : difference.Values)
      {
        picture.push_back(sign * value > 0.0 ? 1.0 : 0.0);
      }
      worst = std::max(worst, difference.GetError(picture));
    }
    EXPECT_LE(worst, 1.02 * sum.Bound + 1e-9) << sum.Count;
    EXPECT_GE(worst, 0.9 * sum.Bound - 1e-9) << "the bound is far from tight";

    std::mt19937 generator(7);
    for (int i = 0; i < 20; ++i)
    {
      std::vector<double> picture;
      double value = 0.0;
      for (std::size_t j = 0; j < difference.Values.size(); ++j)
      {
        if (generator() % 500 == 0)
        {
          value = generator() / 4294967296.0;
        }
        picture.push_back(value);
      }
      EXPECT_LE(difference.GetError(picture), 1.02 * sum.Bound + 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, PowerSumBound,
  ::testing::Combine(::testing::Values(0.0, 0.25, 1.0, 2.0, 5.0, 10.0),
    ::testing::Values(0.05, 0.2, 0.5, 0.8, 0.97, 1.0)));

TEST(PowerSum, OfAWrongKernelIsSeen)
{
  const PowerSum sum = FitPowerSum(1.0, 0.97, 1.0, 4e-4);
  const Difference difference(sum, 1.1, 0.97, 1.0);
  EXPECT_GT(
    difference.GetError(std::vector<double>(difference.Values.size(), 1.0)), 10.0 * sum.Bound);
}
