// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of the medium in single precision, as on a graphics card, against double precision.

#include "GodRaysMediumSingle.h"
#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace
{
double Magnitude(std::mt19937& generator, double low, double high)
{
  return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(generator));
}
}

//------------------------------------------------------------------------------
// Optical depths from 1e-9 to 50, |g| to 0.9, angles to the light from 1e-2.
TEST(MediumSingle, KeepsItsFigures)
{
  std::mt19937 generator(5);
  double worst[4] = {};
  for (int i = 0; i < 20000; ++i)
  {
    // Inputs that both precisions hold exactly.
    const auto pick = [&](float low, float high)
    { return static_cast<float>(Magnitude(generator, low, high)); };
    const float end = pick(1e-4f, 1e5f);
    const float b = pick(1e-9f, 50.0f) / end;
    const float distance = pick(1e-3f, 3.0f) * end;
    const float angle = pick(1e-2f, 3.0f);
    const float foot = distance * std::cos(angle);
    const float height = distance * std::sin(angle);
    const float slope = (i % 2 == 0 ? 1 : -1) * pick(1e-7f, 1.0f);
    const float lightSlope = pick(5e-2f, 1.0f);
    const float g = (i % 3 == 0 ? 1 : -1) * pick(1e-3f, 0.9f);
    const vtkGodRays::PhaseFunction phase = { i % (vtkGodRaysLastPhaseFunction + 1), g };
    // Below the smallest normal number nothing can be kept.
    const auto compare = [&](int which, float actual, double expected)
    {
      if (expected > 1e-30)
      {
        worst[which] = std::max(worst[which], std::abs(actual / expected - 1.0));
      }
    };
    compare(0, GodRaysMediumSingle::DirectionalAirlight(b, end),
      vtkGodRays::DirectionalAirlight(b, 0.0, end, 0.0, 0.0));
    compare(1, GodRaysMediumSingle::PointAirlight(foot, height, end),
      vtkGodRays::PointAirlight(foot, height, 0.0, end));
    compare(2,
      GodRaysMediumSingle::PointAirlight(
        i % (vtkGodRaysLastPhaseFunction + 1), g, b, foot, height, end),
      vtkGodRays::PointAirlight(phase, b, foot, height, 0.0, end));
    const float scaleHeight = end / pick(1e-3f, 5.0f);
    const float start = slope < 0.0f ? -slope * end : 0.0f;
    compare(3,
      GodRaysMediumSingle::ExponentialAirlight(b, start, slope, lightSlope, scaleHeight, end),
      vtkGodRays::ExponentialAirlight(b, start, slope, lightSlope, scaleHeight, 0.0, end));
  }
  std::cout << "largest relative differences: directional " << worst[0] << ", point " << worst[1]
            << ", point with extinction " << worst[2] << ", exponential " << worst[3] << "\n";
  for (const double error : worst)
  {
    EXPECT_LE(error, 1e-4);
  }
}
