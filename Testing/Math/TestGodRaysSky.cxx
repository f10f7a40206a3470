// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky's formulas: columns and depths against sums over fine steps and published numbers, shadows
// against points, maps of all directions and shared exponents against their inverses.

#include "GodRaysMediumSingle.h"
#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using namespace vtkGodRays;

namespace
{
const double pi = 3.14159265358979323846;
const double ground = 6360e3;
const double top = 60e3;
const SkyProfile air = { 0, 8000.0, 0.0 };
const SkyProfile aerosol = { 0, 1200.0, 0.0 };
const SkyProfile uniform = { 1, 8000.0, 0.0 };
const SkyProfile ozone = { 2, 25e3, 15e3 };

// [Bruneton2017], 680, 550 and 440 nm.
SkyAtmosphere MakeEarth()
{
  SkyAtmosphere earth = { ground, top, air, aerosol, ozone, Vec3(0.0), Vec3(3.996e-6),
    Vec3(4.44e-6), Vec3(0.650e-6, 1.881e-6, 0.085e-6), { 1, 0.0 }, 3, Vec3(0.8) };
  earth.AirScattering =
    1.24062e-6 * Vec3(std::pow(0.68, -4.0), std::pow(0.55, -4.0), std::pow(0.44, -4.0));
  return earth;
}

double ToTop(double height, double slope)
{
  return SkyBelow(ground, height, slope, top).y;
}

// The column by the midpoints of a million steps, the height from the theorem of Pythagoras.
double SumColumn(const SkyProfile& profile, double height, double slope, double distance)
{
  using Long = long double;
  const int steps = 1000000;
  const Long radius = Long(ground) + height;
  const Long step = Long(distance) / steps;
  Long sum = 0;
  for (int i = 0; i < steps; ++i)
  {
    const Long d = (i + 0.5L) * step;
    const Long there = std::sqrt(radius * radius + d * (2 * radius * slope + d)) - ground;
    sum += SkyDensity(profile, static_cast<double>(there));
  }
  return static_cast<double>(sum * step);
}

double Slope(double zenithAngle)
{
  return zenithAngle == 90.0 ? 0.0 : std::cos(zenithAngle * pi / 180.0);
}

/// The inverse of EncodeSharedExponent(), for bytes. Formula: 2^(e - 128) mantissa. [the colour's unit]
Vec3 DecodeSharedExponent(int variant, const Vec4& bytes)
{
  if (bytes.w == 0.0)
  {
    return Vec3(0.0);
  }
  return Vec3(bytes.x, bytes.y, bytes.z) *
    (std::exp2(bytes.w - 128.0) / (variant == 1 ? 256.0 : 255.0));
}

/// The inverse of SkyMapDirection(). The nadir has no position in kind 0, and gets one far away.
/// Formula: kind 0 (x, y)/(1 + z). [no unit]
Vec2 SkyMapPosition(int kind, const Vec3& direction)
{
  const Vec2 level = Vec2(direction.x, direction.y);
  const double reach = length(level);
  if (kind == 0)
  {
    return level / std::max(1.0 + direction.z, 1e-12);
  }
  if (kind == 1)
  {
    const double turn = reach > 0.0 ? std::atan2(direction.x, direction.y) / pi : 0.0;
    return Vec2(turn < 0.0 ? turn + 1.0 : turn - 1.0, std::atan2(direction.z, reach) / (0.5 * pi));
  }
  return level * (std::atan2(reach, direction.z) / (0.5 * pi) / std::max(reach, 1e-12));
}
}

//------------------------------------------------------------------------------
TEST(Sky, ColumnsAreIntegrals)
{
  struct Way
  {
    double Height, Slope, Part;
  };
  const Way ways[] = { { 0, 1, 1 }, { 0, 0.5, 1 }, { 0, 0.1, 1 }, { 0, 0.01, 0.3 }, { 0, 0, 1 },
    { 2, -1e-4, 1 }, { 20e3, -0.03, 1 }, { 20e3, -0.03, 0.2 }, { 60e3, -0.12, 1 },
    { 60e3, -1, 0.9 / 13.0 } };
  for (const Way& way : ways)
  {
    const double distance = way.Slope == -1.0 ? 55e3 : way.Part * ToTop(way.Height, way.Slope);
    for (const SkyProfile& profile : { air, aerosol, uniform, ozone })
    {
      const double expected = SumColumn(profile, way.Height, way.Slope, distance);
      // A uniform density ends within a step of the sum.
      const double tolerance = profile.Kind == 1 ? distance * 1e-6 : 1e-6 * expected;
      EXPECT_NEAR(
        SkyColumn(profile, ground, way.Height, way.Slope, distance), expected, tolerance + 1e-3)
        << profile.Kind << " " << profile.Height << " " << way.Height << " " << way.Slope;
    }
  }
}

//------------------------------------------------------------------------------
TEST(Sky, ColumnsOfAHugePlanetAreFlat)
{
  for (const double slope : { 1.0, 0.3, 0.01, -0.2 })
  {
    const double height = slope < 0.0 ? 3000.0 : 100.0;
    const double expected = ExponentialDepth(1.0, height, slope, 1200.0, 9000.0);
    EXPECT_NEAR(SkyColumn(aerosol, 1e12, height, slope, 9000.0), expected, 1e-6 * expected);
  }
}

//------------------------------------------------------------------------------
// Published: optical depths from sea level to the top. The zenith's is accurate to 5e-5 of itself.
TEST(Sky, DepthsAreThoseOfTheEarth)
{
  const SkyAtmosphere earth = MakeEarth();
  const double zenithAngles[] = { 0.0, 60.0, 80.0, 90.0 };
  const Vec3 expected[] = { { 0.061471, 0.141945, 0.271257 }, { 0.122368, 0.282432, 0.540518 },
    { 0.338259, 0.777605, 1.506110 }, { 2.240192, 4.647622, 9.861897 } };
  for (int i = 0; i < 4; ++i)
  {
    const double slope = Slope(zenithAngles[i]);
    const Vec3 depth = SkyDepth(earth, 0.0, slope, ToTop(0.0, slope));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(depth[c], expected[i][c], 1e-4 * expected[i][c]) << zenithAngles[i] << " " << c;
    }
  }
}

//------------------------------------------------------------------------------
// Level, in units of the scale height: the asymptotic series of [Chapman1931]. And the real air's of
// [KastenYoung1989], which is no exponential one: what ours is of that.
TEST(Sky, AirMassIsChapmansAndNearKastenAndYoungs)
{
  const double x = ground / 8000.0;
  EXPECT_NEAR(ChapmanColumn(ground, 0.0, 8000.0) / 8000.0,
    std::sqrt(pi * x / 2.0) * (1.0 + 3.0 / (8.0 * x) - 15.0 / (128.0 * x * x)), 35.4e-6);
  const double zenith = ChapmanColumn(ground, 1.0, 8000.0);
  EXPECT_NEAR(zenith, 8000.0, 8000.0 * 1e-6);

  const double angles[] = { 0.0, 30.0, 60.0, 75.0, 80.0, 85.0, 88.0, 90.0 };
  const double ratios[] = { 1.0003, 1.0002, 0.9991, 0.9965, 0.9936, 0.9837, 0.9601, 0.9323 };
  for (int i = 0; i < 8; ++i)
  {
    const double elevation = 90.0 - angles[i];
    const double real =
      1.0 / (std::sin(elevation * pi / 180.0) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
    const double ours = ChapmanColumn(ground, Slope(angles[i]), 8000.0) / zenith;
    EXPECT_NEAR(ours / real, ratios[i], 1e-4) << angles[i];
  }
}

//------------------------------------------------------------------------------
TEST(Sky, MillimetresCountAtThePlanetsSurface)
{
  EXPECT_NEAR(SkyRise(ground, 1.0, 1e-3), 1e-3, 1e-15);
  EXPECT_NEAR(SkyRise(ground, 0.0, 1000.0), 0.0786163521, 1e-9); // 1000^2/(2 R)
  EXPECT_NEAR(SkyGroundDistance(ground, 1e-3, -1.0), 1e-3, 1e-15);
  EXPECT_EQ(SkyGroundDistance(ground, 0.0, 0.0), -1.0);
  EXPECT_EQ(SkyGroundDistance(ground, 2.0, 0.0), -1.0);
  EXPECT_NEAR(SkyGroundDistance(ground, 1e9, -1.0), 1e9, 1e-3);
}

//------------------------------------------------------------------------------
TEST(Sky, ShadowsAreThoseOfTheirPoints)
{
  std::mt19937 generator(7);
  const auto uniformNumber = [&] { return generator() / 4294967296.0; };
  int dark = 0;
  int points = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double height = top * uniformNumber();
    const double radius = ground + height;
    const auto direction = [&]
    {
      const double z = 2.0 * uniformNumber() - 1.0;
      const double turn = 2.0 * pi * uniformNumber();
      const double level = std::sqrt(1.0 - z * z);
      return Vec3(level * std::cos(turn), level * std::sin(turn), i % 2 ? z : 0.2 * z) /
        length(Vec3(level, 0.0, i % 2 ? z : 0.2 * z));
    };
    const Vec3 view = direction();
    const Vec3 sun = i % 10 == 0 ? view : direction();
    const Vec2 shadow = SkyShadow(ground, height, view.z, sun.z, dot(view, sun));
    const double hit = SkyGroundDistance(ground, height, view.z);
    const double end = hit >= 0.0 ? hit : ToTop(height, view.z);
    for (int n = 0; n < 20; ++n)
    {
      const double d = end * uniformNumber();
      const Vec3 point = Vec3(0.0, 0.0, radius) + d * view;
      const double along = dot(point, sun);
      const double miss = length(point - along * sun) - ground;
      if (std::fabs(miss) < 1.0 || std::fabs(along) < 1.0)
      {
        continue; // at the edge
      }
      const bool expected = along < 0.0 && miss < 0.0;
      ASSERT_EQ(d > shadow.x && d < shadow.y, expected) << i << " " << d;
      dark += expected;
      ++points;
    }
  }
  EXPECT_GT(dark, points / 10);
  EXPECT_LT(dark, points * 9 / 10);
}

//------------------------------------------------------------------------------
// What the graphics card has: the same text with float. Views from the ground to the top, all suns that are
// seen.
TEST(Sky, KeepsItsFiguresInSinglePrecision)
{
  SkyAtmosphere earth = MakeEarth();
  earth.AirScattering = Vec3(5.802e-6, 13.558e-6, 33.1e-6);
  std::mt19937 generator(3);
  const auto number = [&] { return static_cast<float>(generator() / 4294967296.0); };
  double worst = 0.0;
  double squares = 0.0;
  int count = 0;
  while (count < 20000)
  {
    const float height = 59e3f * number() * number() * number();
    const float slope = 2.0f * number() - 1.0f;
    const float sunSlope = 1.3f * number() - 0.3f;
    const float side = std::sqrt((1.0f - slope * slope) * (1.0f - sunSlope * sunSlope));
    const float cosAngle = slope * sunSlope + side * (2.0f * number() - 1.0f);
    const double hit = SkyGroundDistance(ground, height, slope);
    const double end = hit >= 0.0 ? hit : ToTop(height, slope);
    const float distance = static_cast<float>(end) * number();
    const double there = height + SkyRise(ground + height, slope, distance);
    const double sunThere =
      ((ground + height) * sunSlope + double(distance) * cosAngle) / (ground + there);
    if (SkyGroundDistance(ground, there, sunThere) >= 0.0)
    {
      continue; // in the planet's shadow
    }
    const Vec3 expected = SkyInscatter(earth, height, slope, sunSlope, cosAngle, distance);
    float actual[3];
    GodRaysMediumSingle::EarthInscatter(height, slope, sunSlope, cosAngle, distance, actual);
    for (int c = 0; c < 3; ++c)
    {
      if (expected[c] > 1e-12) // a millionth of a blue sky's
      {
        const double error = std::fabs(actual[c] / expected[c] - 1.0);
        worst = std::max(worst, error);
        squares += error * error / 3.0;
      }
    }
    ++count;
  }
  std::cout << "relative differences: root mean square " << std::sqrt(squares / count)
            << ", largest " << worst << "\n";
  EXPECT_LT(worst, 5e-5);
}

//------------------------------------------------------------------------------
TEST(Sky, MapsHaveInversesAndSolidAngles)
{
  const int n = 1000;
  const double full[3] = { 2.0 * pi, 4.0 * pi, 2.0 * pi }; // of the circle, of all, of the circle
  for (int kind = 0; kind < 3; ++kind)
  {
    double sum = 0.0;
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const Vec2 position((2 * i + 1.0) / n - 1.0, (2 * j + 1.0) / n - 1.0);
        const bool counts = kind == 1 || dot(position, position) < 1.0;
        sum += counts ? SkyMapSolidAngle(kind, position) * 4.0 / (n * n) : 0.0;
        if (i % 97 == 0 && j % 89 == 0)
        {
          const Vec3 direction = SkyMapDirection(kind, position);
          EXPECT_NEAR(length(direction), 1.0, 1e-14);
          const Vec2 back = SkyMapPosition(kind, direction);
          EXPECT_NEAR(length(back - position), 0.0, 1e-12) << kind << " " << i << " " << j;
          // The area of a small square of directions.
          const double h = 1e-4;
          const Vec3 across = SkyMapDirection(kind, position + Vec2(h, 0.0)) - direction;
          const Vec3 up = SkyMapDirection(kind, position + Vec2(0.0, h)) - direction;
          EXPECT_NEAR(length(cross(across, up)) / (h * h),
            SkyMapSolidAngle(kind, position + Vec2(0.5 * h)), 1e-3);
        }
      }
    }
    EXPECT_NEAR(sum, full[kind], 1e-3) << kind;
  }
  EXPECT_EQ(SkyMapDirection(0, Vec2(0.0)), Vec3(0.0, 0.0, 1.0));
  EXPECT_NEAR(SkyMapDirection(1, Vec2(-0.5, 0.0)).x, 1.0, 1e-15); // east
  EXPECT_NEAR(SkyMapDirection(2, Vec2(1.0, 0.0)).x, 1.0, 1e-15);
}

//------------------------------------------------------------------------------
TEST(Sky, CubeMapsCoverAllDirections)
{
  const int n = 200;
  double sum = 0.0;
  Vec3 mean(0.0);
  for (int face = 0; face < 6; ++face)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const Vec3 direction =
          CubeMapDirection(face, Vec2((2 * i + 1.0) / n - 1.0, (2 * j + 1.0) / n - 1.0));
        const double angle = 4.0 / (n * n) / std::pow(length(direction), 3.0);
        sum += angle;
        mean += angle * direction / length(direction);
      }
    }
    // Faces are as they are seen from outside: a cube map is a left-handed system.
    const Vec3 right = CubeMapDirection(face, Vec2(1.0, 0.0)) - CubeMapDirection(face, Vec2(0.0));
    const Vec3 down = CubeMapDirection(face, Vec2(0.0, 1.0)) - CubeMapDirection(face, Vec2(0.0));
    EXPECT_EQ(dot(cross(right, down), CubeMapDirection(face, Vec2(0.0))), -1.0) << face;
  }
  EXPECT_NEAR(sum, 4.0 * pi, 1e-4);
  EXPECT_NEAR(length(mean), 0.0, 1e-9);
}

//------------------------------------------------------------------------------
// From below the atmosphere, at its top and above it; the edges are tangents.
TEST(Sky, TablesHaveInversesAndMeetTheHorizon)
{
  for (const double height : { 0.0, 2.0, 10e3, top, 100e3, 2.0 * ground })
  {
    const Vec2 edges = SkyEdges(ground, top, height);
    EXPECT_NEAR(edges.x, -std::sqrt(1.0 - std::pow(ground / (ground + height), 2.0)), 1e-12);
    EXPECT_EQ(height < top, edges.y == 1.0);
    for (double row = -1.0; row <= 1.0; row += 0.125)
    {
      const double slope = SkyTableSlope(edges, row);
      EXPECT_GE(slope, row < 0.0 ? -1.0 : edges.x);
      EXPECT_LE(slope, row < 0.0 ? edges.x : edges.y);
      // where rows are dense, a slope has few figures of them
      EXPECT_NEAR(SkyTableRow(edges, slope), row, row == 0.0 ? 1e-3 : 1e-6) << height;
    }
    EXPECT_EQ(SkyTableRow(edges, -1.0), -1.0);
    EXPECT_EQ(SkyTableRow(edges, edges.y), 1.0);
  }
}

//------------------------------------------------------------------------------
// Ways through the planet's air, seen from space, have the lowest point of the line of sight.
TEST(Sky, WaysFromSpaceEnterAtTheTop)
{
  const SkyAtmosphere earth = MakeEarth();
  const double height = 2.0 * ground;
  for (const double lowest : { -1e5, -100.0, 100.0, 30e3 })
  {
    const double slope = -std::sqrt(1.0 - std::pow((ground + lowest) / (ground + height), 2.0));
    const SkyWay way = MakeSkyWay(earth, height, slope, 0.3, 0.1);
    EXPECT_EQ(way.Height, top);
    EXPECT_EQ(way.MeetsGround, lowest < 0.0);
    const double middle = -(ground + top) * way.Slope;
    EXPECT_NEAR(top + SkyRise(ground + top, way.Slope, middle), lowest, 1e-3);
    EXPECT_NEAR(SkyPoint(earth, way, way.Length).x, lowest < 0.0 ? 0.0 : top, 1e-3);
  }
  EXPECT_LT(MakeSkyWay(earth, height, 0.1, 0.3, 0.1).Length, 0.0);
  EXPECT_EQ(MakeSkyWay(earth, 100.0, 0.1, 0.3, 0.1).Height, 100.0);
}

//------------------------------------------------------------------------------
TEST(Sky, TheGroundReflectsItsAlbedo)
{
  SkyAtmosphere none = MakeEarth();
  none.AirScattering = none.AerosolScattering = none.AerosolExtinction = none.Absorption =
    Vec3(0.0);
  const Vec3 albedo(0.1, 0.5, 1.0);
  EXPECT_LT(length(pi * SkyGround(none, albedo, 0.5) - 0.5 * albedo), 1e-12);
  EXPECT_EQ(SkyGround(none, albedo, -0.1), Vec3(0.0));
}

//------------------------------------------------------------------------------
TEST(Sky, TheSunsLimbIsDarkerAndItsMeanIsOne)
{
  Vec3 sum(0.0);
  const int steps = 100000;
  for (int i = 0; i < steps; ++i)
  {
    const double part = (i + 0.5) / steps;
    sum += SunLimb(part) * (2.0 * part / steps);
  }
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(sum[c], 1.0, 1e-4);
  }
  const Vec3 limb = SunLimb(0.95) / SunLimb(0.0);
  EXPECT_GT(limb.x, limb.y);
  EXPECT_GT(limb.y, limb.z);
  EXPECT_NEAR(limb.y, std::pow(1.0 - 0.95 * 0.95, 0.25395), 1e-12);
}

//------------------------------------------------------------------------------
TEST(SharedExponent, KeepsColoursToHalfAUnit)
{
  std::mt19937 generator(11);
  const auto number = [&] { return generator() / 4294967296.0; };
  for (int variant = 0; variant < 2; ++variant)
  {
    const double units = variant == 0 ? 255.0 : 256.0;
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i)
    {
      const double scale = std::exp2(200.0 * number() - 100.0);
      const Vec3 colour = scale * Vec3(number(), number(), number());
      const Vec4 bytes = EncodeSharedExponent(variant, colour);
      const Vec3 back = DecodeSharedExponent(variant, bytes);
      const double brightest = std::max(colour.x, std::max(colour.y, colour.z));
      for (int c = 0; c < 4; ++c)
      {
        ASSERT_TRUE(bytes[c] >= 0.0 && bytes[c] <= 255.0 && bytes[c] == std::floor(bytes[c]));
      }
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_LE(
          std::fabs(back[c] - colour[c]), 0.5 / units * std::exp2(bytes.w - 128.0) * 1.000001);
        worst = std::max(worst, std::fabs(back[c] - colour[c]) / brightest);
      }
    }
    EXPECT_LE(worst, 0.5 / 127.5);
    EXPECT_GE(worst, 0.3 / 127.5); // the bound is not far off
  }
}

//------------------------------------------------------------------------------
TEST(SharedExponent, HandlesEdges)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (int variant = 0; variant < 2; ++variant)
  {
    for (const Vec3& none : { Vec3(0.0), Vec3(-1.0), Vec3(nan), Vec3(1e-40) })
    {
      EXPECT_EQ(EncodeSharedExponent(variant, none), Vec4(0.0));
    }
    EXPECT_EQ(DecodeSharedExponent(variant, Vec4(0.0)), Vec3(0.0));
    const Vec3 mixed =
      DecodeSharedExponent(variant, EncodeSharedExponent(variant, Vec3(nan, -2.0, 4.0)));
    EXPECT_EQ(mixed, Vec3(0.0, 0.0, 4.0));
    const Vec4 most = EncodeSharedExponent(variant, Vec3(infinity, 1.0, 1e38));
    EXPECT_LE(most.w, 255.0);
    EXPECT_NEAR(DecodeSharedExponent(variant, most).x / 1.69e38, 1.0, 0.004);
    for (int e = -120; e <= 120; ++e) // whole powers of 2, and numbers beside them
    {
      for (const double factor : { 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 0.9985 })
      {
        const double value = factor * std::exp2(e);
        const Vec4 bytes = EncodeSharedExponent(variant, Vec3(value));
        ASSERT_LE(bytes.x, 255.0);
        ASSERT_GE(bytes.x, 127.0);
        ASSERT_NEAR(DecodeSharedExponent(variant, bytes).x / value, 1.0, 0.004);
      }
    }
  }
  // One is 1.0 with exponent 0 as published, and 0.5 with exponent 1 in Radiance.
  EXPECT_EQ(EncodeSharedExponent(0, Vec3(1.0)), Vec4(255.0, 255.0, 255.0, 128.0));
  EXPECT_EQ(EncodeSharedExponent(1, Vec3(1.0)), Vec4(128.0, 128.0, 128.0, 129.0));
}
