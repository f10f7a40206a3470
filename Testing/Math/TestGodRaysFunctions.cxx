// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The shared formulas against closed forms and against their own definitions, without OpenGL.

#include "vtkGodRaysMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace vtkGodRays;

namespace
{
const double pi = 3.14159265358979323846;
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

// Layers without pixels: SumTaps takes any type that has a SampleLayer.
struct ConstantLayer
{
};
Vec3 SampleLayer(const ConstantLayer&, const Vec2&)
{
  return Vec3(1.0);
}

struct RampLayer // red u, green v, blue their product
{
};
Vec3 SampleLayer(const RampLayer&, const Vec2& uv)
{
  return Vec3(uv.x, uv.y, uv.x * uv.y);
}

// A sum that leaves out nothing and changes nothing, to be varied by each test.
TapSum PlainTapSum(int first, int last)
{
  TapSum taps = {};
  taps.FirstTap = first;
  taps.LastTap = last;
  taps.FirstWeight = 1.0;
  taps.Decay = 1.0;
  taps.Step = 1.0;
  taps.InputGain = 1.0;
  taps.OutputGain = 1.0;
  return taps;
}

void ExpectNear(const Vec3& actual, const Vec3& expected, double tolerance)
{
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}
}

//------------------------------------------------------------------------------
TEST(SumTaps, IsTheFormula)
{
  TapSum taps = PlainTapSum(2, 5);
  taps.TapOffset = 0.25;
  taps.OriginWeight = 0.7;
  taps.FirstWeight = 0.3;
  taps.Decay = 0.8;
  taps.Step = 0.1;
  taps.InputBias = 0.5;
  taps.InputGain = -2.0;
  taps.OutputBias = 0.2;
  taps.OutputGain = 1.5;
  const Vec2 uv(0.4, 0.9);
  const Vec2 march(0.6, -1.2);

  Vec3 sum = 0.7 * (0.5 - 2.0 * Vec3(0.4, 0.9, 0.36));
  for (int k = 2; k <= 5; ++k)
  {
    const double u = 0.4 + (k - 0.25) * 0.1 * 0.6;
    const double v = 0.9 - (k - 0.25) * 0.1 * 1.2;
    sum += 0.3 * std::pow(0.8, k - 2) * (0.5 - 2.0 * Vec3(u, v, u * v));
  }
  ExpectNear(SumTaps(RampLayer(), taps, uv, march), 0.2 + 1.5 * sum, 1e-14);
}

//------------------------------------------------------------------------------
TEST(InterleavedGradientNoise, HasThePublishedNumbersAndIsEven)
{
  // evaluated with 40 decimal digits
  EXPECT_NEAR(InterleavedGradientNoise(Vec2(0.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(InterleavedGradientNoise(Vec2(1.0, 0.0)), 0.555713357813584, 1e-12);
  EXPECT_NEAR(InterleavedGradientNoise(Vec2(0.0, 1.0)), 0.309269245057135, 1e-12);
  EXPECT_NEAR(InterleavedGradientNoise(Vec2(13.0, 7.0)), 0.389158366976537, 1e-12);
  EXPECT_NEAR(InterleavedGradientNoise(Vec2(1919.0, 1079.0)), 0.421397560916361, 1e-11);
  int counts[8] = {};
  for (int i = 0; i < 64 * 64; ++i)
  {
    ++counts[static_cast<int>(8.0 * InterleavedGradientNoise(Vec2(i % 64, i / 64)))];
  }
  for (int count : counts)
  {
    EXPECT_NEAR(count, 512, 26);
  }
}

//------------------------------------------------------------------------------
TEST(SumTaps, WithoutTapsIsTheOrigin)
{
  TapSum taps = PlainTapSum(1, 0);
  taps.OriginWeight = 2.0;
  ExpectNear(SumTaps(RampLayer(), taps, Vec2(0.5, 0.25), Vec2(1.0)), Vec3(1.0, 0.5, 0.25), 1e-15);
}

//------------------------------------------------------------------------------
TEST(SumTaps, IsKeptWithinMaximum)
{
  TapSum taps = PlainTapSum(1, 10);
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.0), Vec2(0.0)), Vec3(10.0));
  taps.Maximum = 3.0;
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.0), Vec2(0.0)), Vec3(3.0));
  taps.OutputGain = -1.0;
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.0), Vec2(0.0)), Vec3(0.0));
}

//------------------------------------------------------------------------------
TEST(SumTaps, CopiesRed)
{
  TapSum taps = PlainTapSum(0, 0);
  taps.RedToGrey = 1;
  EXPECT_EQ(SumTaps(RampLayer(), taps, Vec2(0.5, 0.25), Vec2(0.0)), Vec3(0.5));
}

//------------------------------------------------------------------------------
TEST(SumTaps, FixedLengthStopsAtTheLight)
{
  TapSum taps = PlainTapSum(0, 5);
  taps.FixedLength = 0.125;
  auto count = [&](const Vec2& march)
  { return SumTaps(ConstantLayer(), taps, Vec2(0.0), march).x; };
  EXPECT_EQ(count(Vec2(0.124, 0.0)), 1.0);
  EXPECT_EQ(count(Vec2(0.125, 0.0)), 2.0); // i <= iters: the tap on the light counts
  EXPECT_EQ(count(Vec2(0.26, 0.0)), 3.0);
  EXPECT_EQ(count(Vec2(0.3, 0.4)), 5.0);
  EXPECT_EQ(count(Vec2(100.0, 0.0)), 6.0);

  // The steps have that length, towards the light: taps 0 to 4 on the way from 0.
  const Vec3 sum = SumTaps(RampLayer(), taps, Vec2(0.0), Vec2(0.3, 0.4));
  EXPECT_NEAR(sum.x, 10.0 * 0.125 * 0.6, 1e-14);
  EXPECT_NEAR(sum.y, 10.0 * 0.125 * 0.8, 1e-14);
}

//------------------------------------------------------------------------------
TEST(SumTaps, FixedLengthStopsAtTheUpperEdge)
{
  TapSum taps = PlainTapSum(0, 5);
  taps.FixedLength = 0.25;
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.5, 0.5), Vec2(0.0, 9.0)).x, 2.0);
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.5, 0.5), Vec2(9.0, 0.0)).x, 6.0);
  EXPECT_EQ(SumTaps(ConstantLayer(), taps, Vec2(0.5, 0.5), Vec2(0.0, -9.0)).x, 6.0);
}

//------------------------------------------------------------------------------
TEST(SumTaps, OnTheLightReadsThePixelItself)
{
  TapSum taps = PlainTapSum(0, 5);
  const Vec3 own(0.5, 0.25, 0.125);
  EXPECT_EQ(SumTaps(RampLayer(), taps, Vec2(0.5, 0.25), Vec2(0.0)), 6.0 * own);
  taps.FixedLength = 1.0 / 6.0;
  EXPECT_EQ(SumTaps(RampLayer(), taps, Vec2(0.5, 0.25), Vec2(0.0)), own);
  EXPECT_EQ(SumTaps(RampLayer(), taps, Vec2(0.5, 0.25), Vec2(1e-300)), own);
}

//------------------------------------------------------------------------------
TEST(ImageLayer, InterpolatesBetweenCentres)
{
  // Red is the column, green the row, blue 1.
  const int width = 4;
  const int height = 3;
  std::vector<float> pixels;
  for (int i = 0; i < width * height; ++i)
  {
    pixels.insert(pixels.end(), { float(i % width), float(i / width), 1.0f });
  }
  const ImageLayer edge = { pixels.data(), width, height, BORDER_EDGE };
  const ImageLayer zero = { pixels.data(), width, height, BORDER_ZERO };
  auto at = [&](double x, double y) { return Vec2((x + 0.5) / width, (y + 0.5) / height); };

  for (const ImageLayer& layer : { edge, zero })
  {
    ExpectNear(SampleLayer(layer, at(2.0, 1.0)), Vec3(2.0, 1.0, 1.0), 1e-14);
    ExpectNear(SampleLayer(layer, at(1.25, 0.75)), Vec3(1.25, 0.75, 1.0), 1e-14);
  }
  // Half a pixel outside lies the edge of the border: half the pixel, half nothing.
  ExpectNear(SampleLayer(edge, at(-0.5, 1.0)), Vec3(0.0, 1.0, 1.0), 1e-14);
  ExpectNear(SampleLayer(zero, at(-0.5, 1.0)), Vec3(0.0, 0.5, 0.5), 1e-14);
  ExpectNear(SampleLayer(zero, at(3.25, 2.5)), Vec3(3.0, 2.0, 1.0) * 0.75 * 0.5, 1e-14);
  for (const Vec2& far : { at(-1.0, 1.0), at(4.0, 1.0), at(1.0, 3.0), Vec2(1e300), Vec2(-1e300) })
  {
    EXPECT_EQ(SampleLayer(zero, far), Vec3(0.0));
  }
  ExpectNear(SampleLayer(edge, Vec2(1e300, -1e300)), Vec3(3.0, 0.0, 1.0), 0.0);
}

//------------------------------------------------------------------------------
TEST(MarchVector, LeadsToTheLight)
{
  const Vec3 light(1.5, -0.75, 2.5); // at ndc (0.6, -0.3), uv (0.8, 0.35)
  const Vec2 uv(0.1, 0.9);
  const Vec2 march = MarchVector(light, 2.0 * uv - 1.0, 1.0 / light.z);
  EXPECT_NEAR(uv.x + march.x, 0.8, 1e-15);
  EXPECT_NEAR(uv.y + march.y, 0.35, 1e-15);
}

//------------------------------------------------------------------------------
TEST(MarchVector, IsContinuousAllAround)
{
  // A light that circles the camera passes w = 0 twice; nothing may jump anywhere in the picture.
  const double aspect = 16.0 / 9.0;
  const double cap = 3.0;
  const int steps = 20000;
  for (const Vec2& ndc : { Vec2(0.0, 0.0), Vec2(-1.0, 1.0), Vec2(0.3, -0.9) })
  {
    Vec2 before;
    for (int i = 0; i <= steps; ++i)
    {
      const double angle = 2.0 * pi * i / steps;
      const Vec3 light(std::sin(angle), 0.4, std::cos(angle));
      const double scale = MarchScale(light, aspect, cap);
      ASSERT_TRUE(std::isfinite(scale));
      const Vec2 march = MarchVector(light, ndc, scale);
      if (i > 0)
      {
        ASSERT_LT(length(march - before), 0.01) << "at " << angle << " radians";
      }
      before = march;
    }
  }
}

//------------------------------------------------------------------------------
TEST(MarchScale, CapsFarLightsOnly)
{
  const double cap = 3.0;
  // Near: exactly to the light, which is 2 half heights from the centre.
  EXPECT_NEAR(MarchScale(Vec3(2.0, 0.0, 2.0), 2.0, cap), 0.5, 1e-15);
  // Far: the march of a pixel in the centre ends cap half heights away, however far the light is.
  for (double w : { 0.5, 1e-3, 0.0, -1e-3 })
  {
    const Vec3 light(2.0, 1.0, w);
    const Vec2 march = 2.0 * MarchVector(light, Vec2(0.0), MarchScale(light, 2.0, cap));
    EXPECT_NEAR(length(Vec2(2.0 * march.x, march.y)), cap, 1e-12) << "w " << w;
  }
  // On the axis, before and behind the camera and at infinity: finite.
  EXPECT_NEAR(MarchScale(Vec3(0.0, 0.0, 4.0), 2.0, cap), 0.25, 1e-15);
  EXPECT_NEAR(MarchScale(Vec3(0.0, 0.0, -4.0), 2.0, cap), 0.25, 1e-15);
  const Vec3 axis(0.0);
  EXPECT_EQ(MarchVector(axis, Vec2(0.5), MarchScale(axis, 2.0, cap)), Vec2(0.0));
}

//------------------------------------------------------------------------------
TEST(MeanExponential, IsStable)
{
  EXPECT_EQ(MeanExponential(0.0), 1.0);
  for (double k : { 1e-300, 1e-16, 1e-9, 1e-4, 0.01, 0.3, 0.999999, 1.0, 1.5, 5.0, 700.0 })
  {
    for (double signedK : { k, -k })
    {
      const double expected = -std::expm1(-signedK) / signedK;
      EXPECT_NEAR(MeanExponential(signedK) / expected, 1.0, 2e-15) << "k " << signedK;
    }
  }
}

//------------------------------------------------------------------------------
TEST(Display, GoesThereAndBack)
{
  EXPECT_EQ(DecodeDisplay(0.0), 0.0);
  EXPECT_NEAR(DecodeDisplay(1.0), 1.0, 1e-15);
  EXPECT_NEAR(DecodeDisplay(0.5), 0.21404114048223255, 1e-15);
  EXPECT_NEAR(EncodeDisplay(0.18), 0.46135612950044164, 1e-15);
  for (double value = 0.0; value < 4.0; value += 0.001)
  {
    // The standard's two pieces meet to 3e-8 only.
    ASSERT_NEAR(EncodeDisplay(DecodeDisplay(value)), value, 1e-7);
    ASSERT_GT(DecodeDisplay(value + 0.001), DecodeDisplay(value));
  }
  const Vec3 colour(0.02, 0.4, 1.7);
  ExpectNear(EncodeDisplay(DecodeDisplay(colour)), colour, 1e-7);
  EXPECT_EQ(DecodeDisplay(colour).y, DecodeDisplay(0.4));
  ExpectNear(DecodeDisplay(colour, false), DecodeDisplay(colour), 0.0);
  ExpectNear(EncodeDisplay(DecodeDisplay(colour, true), true), colour, 1e-15);
  EXPECT_NEAR(DecodeDisplay(Vec3(0.5), true).x, 0.217637640824031, 1e-15);
  EXPECT_EQ(DecodeDisplay(Vec3(-1.0), true).x, 0.0);
}

//------------------------------------------------------------------------------
TEST(Display, OfBytesIsWithoutPowersAsNearAsItSays)
{
  double decoding = 0.0;
  double encoding = 0.0;
  for (double value = 0.0; value <= 1.0; value += 1e-4)
  {
    decoding = std::max(decoding, std::abs(DecodeDisplay8(value) - DecodeDisplay(value)));
    encoding = std::max(encoding, std::abs(EncodeDisplay8(value) - EncodeDisplay(value)));
  }
  EXPECT_LT(decoding, 1.1e-5);
  EXPECT_LT(encoding, 1.1e-5);
  for (int byte = 0; byte < 256; ++byte)
  {
    // of a step from a byte to the next, as near black as elsewhere
    const double step = DecodeDisplay((byte + 1) / 255.0) - DecodeDisplay(byte / 255.0);
    const double light = DecodeDisplay8(byte / 255.0);
    EXPECT_LT(std::abs(light - DecodeDisplay(byte / 255.0)) / step, 0.04) << byte;
    EXPECT_NEAR(255.0 * EncodeDisplay8(light), byte, 0.04);
    EXPECT_LT(light, DecodeDisplay8(std::min(255, byte + 1) / 255.0) + (byte == 255 ? 1.0 : 0.0));
  }
  EXPECT_EQ(EncodeDisplay8(-0.5), 0.0);
  EXPECT_NEAR(EncodeDisplay8(7.0), 1.0, 1.1e-5);
  const Vec3 colour(0.02, 0.4, 0.9);
  EXPECT_EQ(DecodeDisplay8(colour).z, DecodeDisplay8(0.9));
  EXPECT_EQ(EncodeDisplay8(colour).y, EncodeDisplay8(0.4));
}

//------------------------------------------------------------------------------
TEST(Blend, AddsAndScreens)
{
  const Vec3 scene(0.0, 0.5, 2.0);
  const Vec3 rays(0.25, 0.5, 3.0);
  ExpectNear(BlendAdd(scene, rays), Vec3(0.25, 1.0, 5.0), 1e-15);
  ExpectNear(BlendScreen(scene, rays), Vec3(0.25, 0.75, 4.0), 1e-15);
}

//------------------------------------------------------------------------------
TEST(GeometricSum, IsTheSumOfItsTerms)
{
  for (double decay : { 0.0, 1e-9, 0.5, 0.93, 0.99, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.05 })
  {
    for (int n : { 1, 2, 60, 1000 })
    {
      long double sum = 0.0L;
      long double term = 1.0L;
      for (int i = 0; i < n; ++i)
      {
        sum += term;
        term *= decay;
      }
      EXPECT_NEAR(GeometricSum(decay, n) / static_cast<double>(sum), 1.0, 1e-12)
        << decay << ", " << n;
    }
  }
  // in two halves
  EXPECT_NEAR(GeometricSum(0.9, 0.5) * (1.0 + std::sqrt(0.9)), 1.0, 1e-14);
}

TEST(PixelAngle, IsHowFarTheRayTurnsAlongTheLargerSide)
{
  const Vec3 ray(0.3, -0.7, -2.5);
  for (double length : { 1e-3, 1.0, 1e6 })
  {
    const Vec3 right = length * Vec3(1e-6, 0.0, 0.0);
    const Vec3 up = length * Vec3(0.0, 2e-6, 0.0);
    const double sideways = AngleBetween(ray, ray + right / length);
    const double upwards = AngleBetween(ray, ray + up / length);
    EXPECT_GT(upwards, sideways);
    EXPECT_NEAR(PixelAngle(length * ray, right, up) / upwards, 1.0, 1e-5);
    EXPECT_NEAR(PixelAngle(length * ray, right, 0.1 * up) / sideways, 1.0, 1e-5);
  }
}

TEST(AngleBetween, IsAccurateAtBothEnds)
{
  const Vec3 axis(0.0, 0.0, 3.0);
  for (double angle : { 0.0, 1e-9, 0.3, 0.5 * pi, 3.0, pi - 1e-9 })
  {
    const Vec3 other = 0.1 * Vec3(std::sin(angle), 0.0, std::cos(angle));
    EXPECT_NEAR(AngleBetween(axis, other), angle, 1e-15);
  }
}

//------------------------------------------------------------------------------
TEST(DiscCoverage, IsOneInsideAndZeroOutside)
{
  for (double radius : { 0.9, 1.0, 3.0, 50.0 })
  {
    EXPECT_NEAR(DiscCoverage(0.0, radius, 1.0), 1.0, 1e-15);
    EXPECT_NEAR(DiscCoverage(radius - 0.9, radius, 1.0), 1.0, 1e-15);
    EXPECT_EQ(DiscCoverage(radius + 0.75, radius, 1.0), 0.0);
  }
  EXPECT_NEAR(DiscCoverage(50.0, 50.0, 1.0), 0.5, 2e-3);
  // Without a pixel size the edge is sharp.
  EXPECT_EQ(DiscCoverage(0.999, 1.0, 0.0), 1.0);
  EXPECT_EQ(DiscCoverage(1.001, 1.0, 0.0), 0.0);
  EXPECT_EQ(DiscCoverage(0.0, 0.0, 1.0), 0.0);
}

//------------------------------------------------------------------------------
TEST(DiscCoverage, IntegratesToTheArea)
{
  for (double radius : { 0.01, 0.1, 0.3, 0.5, 0.82, 0.83, 1.0, 2.5, 10.0 })
  {
    double area = 0.0;
    const int rings = 200000;
    const double width = (radius + 1.6) / rings;
    for (int i = 0; i < rings; ++i)
    {
      const double separation = (i + 0.5) * width;
      area += 2.0 * pi * separation * width * DiscCoverage(separation, radius, 1.0);
    }
    EXPECT_NEAR(area / (pi * radius * radius), 1.0, 1e-6) << "radius " << radius;
  }
}

//------------------------------------------------------------------------------
TEST(DiscCoverage, SummedOverPixelsIsAboutTheArea)
{
  for (double radius : { 0.1, 0.4, 0.7, 1.5, 4.0 })
  {
    for (const Vec2& centre : { Vec2(0.0, 0.0), Vec2(0.5, 0.5), Vec2(0.25, 0.1), Vec2(0.5, 0.0) })
    {
      double sum = 0.0;
      for (int y = -8; y <= 8; ++y)
      {
        for (int x = -8; x <= 8; ++x)
        {
          sum += DiscCoverage(length(Vec2(x, y) - centre), radius, 1.0);
        }
      }
      EXPECT_NEAR(sum / (pi * radius * radius), 1.0, 0.025) << "radius " << radius;
    }
  }
}

//------------------------------------------------------------------------------
TEST(GlowFalloff, FallsSmoothly)
{
  EXPECT_EQ(GlowFalloff(0.0, 2.0, 10.0), 1.0);
  EXPECT_EQ(GlowFalloff(2.0, 2.0, 10.0), 1.0);
  EXPECT_NEAR(GlowFalloff(7.0, 2.0, 10.0), 0.5, 1e-15);
  EXPECT_EQ(GlowFalloff(12.0, 2.0, 10.0), 0.0);
  EXPECT_EQ(GlowFalloff(100.0, 2.0, 10.0), 0.0);
  const double h = 1e-3;
  double slopeBefore = 0.0;
  for (double s = 0.0; s < 14.0; s += h)
  {
    const double slope = (GlowFalloff(s + h, 2.0, 10.0) - GlowFalloff(s, 2.0, 10.0)) / h;
    ASSERT_LE(slope, 1e-12);
    ASSERT_NEAR(slope, slopeBefore, 1e-3); // C1: the slope does not jump
    slopeBefore = slope;
  }
  EXPECT_EQ(GlowFalloff(2.0, 2.0, 0.0), 1.0);
  EXPECT_EQ(GlowFalloff(2.0 + 1e-9, 2.0, 0.0), 0.0);
}

//------------------------------------------------------------------------------
TEST(FacingFade, FadesBehindTheCamera)
{
  EXPECT_EQ(FacingFade(1.0), 1.0);
  EXPECT_NEAR(FacingFade(0.1), 1.0, 1e-15);
  EXPECT_NEAR(FacingFade(0.0), 0.5, 1e-15);
  EXPECT_NEAR(FacingFade(-0.1), 0.0, 1e-15);
  EXPECT_EQ(FacingFade(-1.0), 0.0);
  for (double facing = -1.0; facing < 1.0; facing += 0.001)
  {
    ASSERT_GE(FacingFade(facing + 0.001), FacingFade(facing));
    ASSERT_LT(FacingFade(facing + 0.001) - FacingFade(facing), 0.01);
  }
}

//------------------------------------------------------------------------------
TEST(ViewDepth, IsWhatProjectionsMadeOfIt)
{
  const double nearest = 0.5;
  const double farthest = 80.0;
  for (const double z : { 0.5, 0.7, 3.0, 41.0, 80.0 })
  {
    const double perspective = (1.0 / nearest - 1.0 / z) / (1.0 / nearest - 1.0 / farthest);
    const double parallel = (z - nearest) / (farthest - nearest);
    const Vec4 ofPerspective(nearest * farthest, 0.0, nearest, farthest - nearest);
    const Vec4 ofParallel(farthest, nearest - farthest, 1.0, 0.0);
    EXPECT_NEAR(ViewDepth(ofPerspective, 1.0 - perspective), z, 1e-12 * z);
    EXPECT_NEAR(ViewDepth(ofParallel, 1.0 - parallel), z, 1e-12 * z);
  }
}

//------------------------------------------------------------------------------
TEST(Sanitize, LeavesNothingHarmful)
{
  EXPECT_EQ(Sanitize(Vec3(notANumber, -1.0, infinity), 100.0), Vec3(0.0, 0.0, 100.0));
  EXPECT_EQ(Sanitize(Vec3(-infinity, 0.25, 1e9), 100.0), Vec3(0.0, 0.25, 100.0));
}
