// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells of data: against the corners' definition and sums of many places.

#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vtkGodRays;

//------------------------------------------------------------------------------
TEST(GridMath, CellsAreTrilinear)
{
  const Vec4 low(1.0, 2.0, 4.0, 8.0);
  const Vec4 high(16.0, 32.0, 64.0, 128.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
    EXPECT_EQ(CellValue(low, high, place), std::ldexp(1.0, corner));
  }
  EXPECT_NEAR(CellValue(low, high, Vec3(0.5)), 255.0 / 8.0, 1e-13);
}

//------------------------------------------------------------------------------
// Gauss-Legendre with 3 points is exact to the fifth power, and knows nothing of Simpson's rule.
TEST(GridMath, MeansOfLinesAreExact)
{
  std::mt19937 generator(7);
  const auto uniform = [&]() { return generator() / 4294967296.0; };
  double worst = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const Vec4 low(uniform(), uniform(), uniform(), uniform());
    const Vec4 high(uniform(), uniform(), uniform(), uniform());
    const Vec3 from(uniform(), uniform(), uniform());
    const Vec3 to(uniform(), uniform(), uniform());
    const double away = 0.5 * std::sqrt(0.6);
    const auto value = [&](double t) { return CellValue(low, high, from + t * (to - from)); };
    const double expected =
      (5.0 * value(0.5 - away) + 8.0 * value(0.5) + 5.0 * value(0.5 + away)) / 18.0;
    worst = std::max(worst, std::abs(CellMean(low, high, from, to) - expected));
    // Two halves make a whole: a rule that is not exact for cubics breaks this.
    const Vec3 middle = 0.5 * (from + to);
    worst = std::max(worst,
      std::abs(CellMean(low, high, from, to) -
        0.5 * (CellMean(low, high, from, middle) + CellMean(low, high, middle, to))));
  }
  EXPECT_LE(worst, 1e-15);
}

//------------------------------------------------------------------------------
TEST(GridMath, OpacitiesAreExtinctions)
{
  EXPECT_EQ(OpacityExtinction(0.0, 2.0), 0.0);
  EXPECT_NEAR(std::exp(-2.0 * OpacityExtinction(0.3, 2.0)), 0.7, 1e-15);
  EXPECT_NEAR(OpacityExtinction(1.0, 1.0), std::log(1e6), 1e-9);
  EXPECT_DEATH(OpacityExtinction(1.1, 1.0), "opacity <= 1.0");
  EXPECT_DEATH(CellValue(Vec4(0.0), Vec4(0.0), Vec3(1.1, 0.0, 0.0)), "place.x");
}
