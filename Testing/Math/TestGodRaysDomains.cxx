// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Formulas stop what they are not for, in a build that checks it, such as that of these tests.

#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vtkGodRays;

//------------------------------------------------------------------------------
TEST(DomainsDeathTest, FormulasStopWhatTheyAreNotFor)
{
  const double nan = std::nan("");
  EXPECT_DEATH(PhaseHenyeyGreenstein(1.1, 0.5), "PhaseHenyeyGreenstein.. is for IsCosine");
  EXPECT_DEATH(PhaseHenyeyGreenstein(0.5, 1.0), "abs.g. < 1.0");
  EXPECT_DEATH(PhaseRayleigh(nan), "PhaseRayleigh");
  EXPECT_DEATH(PhaseHasAsymmetry(vtkGodRaysLastPhaseFunction + 1), "kind");
  EXPECT_DEATH(
    Transmittance(0.1, -1.0), "Transmittance.. is for extinction >= 0.0 && distance >= 0.0");
  EXPECT_DEATH(ExponentialDensity(1.0, 0.0), "scaleHeight > 0.0");
  EXPECT_DEATH(PointAirlight(1.0, 1.0, 3.0, 2.0), "begin <= end");
  EXPECT_DEATH(AngleBetween(Vec3(0.0), Vec3(1.0)), "AngleBetween");
  EXPECT_DEATH(SunLimb(-0.1), "SunLimb");
  EXPECT_DEATH(ScaledExtinction(1.0, 1.0, 1.0), "forwardPart < 1.0");
  EXPECT_DEATH(OrdersPart(-1.0, 0.5, 1.0, 1.0), "OrdersPart");
  EXPECT_DEATH(PeakPlace(0.5, 1.0, 0.0), "most > 0.0");
  EXPECT_DEATH(CubeMapDirection(6, Vec2(0.0)), "CubeMapDirection");
}

//------------------------------------------------------------------------------
TEST(Domains, EndsBelongToThem)
{
  EXPECT_GT(PhaseHenyeyGreenstein(-1.0, 0.99), 0.0);
  EXPECT_GT(PhaseHenyeyGreenstein(1.0 + 1e-6, -0.99), 0.0); // a cosine from single precision
  EXPECT_EQ(Transmittance(0.0, 0.0), 1.0);
  EXPECT_EQ(ScaledExtinction(1.0, 1.0, 0.0), 1.0);
  EXPECT_EQ(PeakPlace(1.0 + 1e-6, 9.0, 3.0), Vec2(0.0, 1.0));
  EXPECT_EQ(OrdersPart(2.0, 0.5, 0.25, 1.0), 1.5);
  EXPECT_EQ(PointAirlight(1.0, 1.0, 2.0, 2.0), 0.0);
}
