// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// That this compiles is the proof; GODRAYS_WRONG_UNITS is the control, which must not.

#include "GodRaysUnits.h"

#include <gtest/gtest.h>

#include <type_traits>

using namespace vtkGodRaysUnits;

namespace
{
template <typename T>
constexpr bool IsAreaWithLength = requires(RealArea a, T b)
{
  a + b;
};
template <typename T>
constexpr bool DimsOver = requires(T distance)
{
  vtkGodRaysUnits::Transmittance(RealPerLength(1.0), distance);
};
static_assert(
  IsAreaWithLength<RealArea> && !IsAreaWithLength<RealLength> && !IsAreaWithLength<double>);
static_assert(DimsOver<RealLength> && !DimsOver<RealPerLength> && !DimsOver<double>);
static_assert(std::is_same_v<decltype(RealPerLength(1.0) * RealLength(1.0)), double>);
}

//------------------------------------------------------------------------------
// The text is the same, and so are the numbers.
TEST(Units, ChangeNoNumber)
{
  const RealPerLength extinction(0.02);
  const RealLength begin(1.0);
  const RealLength end(30.0);
  EXPECT_EQ(vtkGodRaysUnits::DirectionalAirlight(extinction, begin, end, begin, 0.2).Value,
    vtkGodRays::DirectionalAirlight(0.02, 1.0, 30.0, 1.0, 0.2));
  EXPECT_NEAR(
    vtkGodRaysUnits::PointAirlight({ PHASE_SCHLICK, 0.4 }, extinction, begin, begin, begin, end)
        .Value /
      vtkGodRays::PointAirlight({ vtkGodRays::PHASE_SCHLICK, 0.4 }, 0.02, 1.0, 1.0, 1.0, 30.0),
    1.0, 1e-14);
  EXPECT_NEAR(
    vtkGodRaysUnits::MediumColumn(RealLength(6e6), RealLength(10.0), 0.3, RealLength(8e3)).Value /
      vtkGodRays::MediumColumn(6e6, 10.0, 0.3, 8e3),
    1.0, 1e-14);
}

#ifdef GODRAYS_WRONG_UNITS
// A length in the place of a coefficient, and the other way round.
const double wrong = vtkGodRaysUnits::Transmittance(RealLength(1.0), RealPerLength(1.0));
#endif
