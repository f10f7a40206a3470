// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How rays join colours: without clipping, and without changing what colours say.

#include "vtkGodRaysMath.h"

#include <algorithm>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace vtkGodRays;

namespace
{
/// Colours all over the cube, as bytes show them.
std::vector<Vec3> GetColors()
{
  std::vector<Vec3> colors;
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    colors.push_back(DecodeDisplay(Vec3(i % 9, i / 9 % 9, i / 81) / 8.0));
  }
  return colors;
}

double GetChroma(const Vec3& lab)
{
  return std::hypot(lab.y, lab.z);
}
}

//------------------------------------------------------------------------------
TEST(BlendShoulder, IsTheSumWhereThereIsRoom)
{
  const Vec3 scene(0.2, 0.1, 0.4);
  const Vec3 rays(0.1, 0.2, 0.25);
  EXPECT_EQ(BlendShoulder(scene, rays), scene + rays);
  for (const Vec3& color : GetColors())
  {
    EXPECT_EQ(BlendShoulder(color, Vec3(0.0)), color);
  }
}

//------------------------------------------------------------------------------
TEST(BlendShoulder, NeitherClipsNorDarkens)
{
  for (const Vec3& color : GetColors())
  {
    for (const double strength : { 1e-6, 0.01, 0.3, 1.0, 30.0, 6e4 })
    {
      const Vec3 sum = BlendShoulder(color, strength * Vec3(1.0, 0.8, 0.4));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_GE(sum[c], color[c]);
        EXPECT_LE(sum[c], std::max(color[c] + 1e-6, 0.99 + 1e-12));
      }
    }
  }
  // plain sums do clip
  EXPECT_GT(BlendAdd(Vec3(0.5), Vec3(1.0)).x, 1.0);
}

//------------------------------------------------------------------------------
TEST(BlendShoulder, KeepsTheHueOfRays)
{
  const Vec3 rays(3.0, 2.4, 1.2);
  const Vec3 sum = BlendShoulder(Vec3(0.0), rays);
  EXPECT_NEAR(sum.y / sum.x, 0.8, 1e-12);
  EXPECT_NEAR(sum.z / sum.x, 0.4, 1e-12);
}

//------------------------------------------------------------------------------
TEST(BlendShoulder, IsSmooth)
{
  const Vec3 scene(0.3, 0.2, 0.1);
  const Vec3 color(1.0, 0.5, 0.2);
  const double step = 1e-4;
  double slope = 1.0;
  for (double strength = 0.0; strength < 3.0; strength += step)
  {
    const double next = (BlendShoulder(scene, (strength + step) * color).x -
                          BlendShoulder(scene, strength * color).x) /
      step;
    EXPECT_LE(next, slope + 1e-8); // it only bends down
    EXPECT_GT(next, slope - 1e-3);
    EXPECT_GT(next, 0.0);
    slope = next;
  }
  EXPECT_LT(slope, 0.02);
}

//------------------------------------------------------------------------------
TEST(LabOfLight, HasTheKnownNumbers)
{
  // of sRGB's primaries, white, black and middle grey [BruceLindbloom's calculator, D65]
  const struct
  {
    Vec3 Shown;
    Vec3 Lab;
  } known[] = { { Vec3(1.0, 0.0, 0.0), Vec3(53.2408, 80.0925, 67.2032) },
    { Vec3(0.0, 1.0, 0.0), Vec3(87.7347, -86.1827, 83.1793) },
    { Vec3(0.0, 0.0, 1.0), Vec3(32.2970, 79.1875, -107.8602) },
    { Vec3(1.0, 1.0, 1.0), Vec3(100.0, 0.0, 0.0) }, { Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0) },
    { Vec3(0.5, 0.5, 0.5), Vec3(53.3890, 0.0, 0.0) } };
  for (const auto& each : known)
  {
    EXPECT_LT(length(LabOfLight(DecodeDisplay(each.Shown)) - each.Lab), 0.02);
  }
}

//------------------------------------------------------------------------------
TEST(LabOfLight, GoesThereAndBack)
{
  for (const Vec3& color : GetColors())
  {
    EXPECT_LT(length(LightOfLab(LabOfLight(color)) - color), 1e-6);
  }
}

//------------------------------------------------------------------------------
TEST(BlendLightness, ChangesLightnessAlone)
{
  int changed = 0;
  for (const Vec3& color : GetColors())
  {
    const Vec3 before = LabOfLight(color);
    for (const Vec3& joined : { Vec3(0.9, 0.5, 0.1), Vec3(0.01, 0.02, 0.03) })
    {
      const Vec3 result = BlendLightness(color, joined, 10.0);
      const Vec3 after = LabOfLight(result);
      EXPECT_LE(std::abs(after.x - before.x), 10.2);
      // to the edge of the primaries' colours, where rounding counts
      EXPECT_LT(std::hypot(after.y - before.y, after.z - before.z), 1.0);
      EXPECT_GE((after.x - before.x) * (LabOfLight(joined).x - before.x), -0.1);
      const Real brightest = std::max({ color.x, color.y, color.z });
      EXPECT_LE(std::max({ result.x, result.y, result.z }), std::max(Real(0.99), brightest));
      changed += std::abs(after.x - before.x) > 5.0 ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 300); // of 1458
  // sums do change the rest
  const Vec3 blue(0.0, 0.0, 0.5);
  EXPECT_LT(
    GetChroma(LabOfLight(BlendAdd(blue, Vec3(0.3, 0.25, 0.2)))), 0.7 * GetChroma(LabOfLight(blue)));
}

//------------------------------------------------------------------------------
TEST(DataGain, MakesUpForWhatAMediumTakes)
{
  const Vec3 half(0.5, 0.4, 0.3);
  EXPECT_NEAR(DataGain(half, 1.5, 1.0), 1.5, 1e-12);
  EXPECT_NEAR(DataGain(half, 3.0, 1.0), 2.0, 1e-12); // no brighter than without the medium
  EXPECT_NEAR(DataGain(half, 3.0, 0.5), 1.5, 1e-12); // half of it is background
  EXPECT_EQ(DataGain(half, 3.0, 0.0), 1.0);
  EXPECT_EQ(DataGain(Vec3(1.0), 2.0, 1.0), 1.0);
  EXPECT_EQ(DataGain(Vec3(0.0), 2.0, 1.0), 2.0);
}

//------------------------------------------------------------------------------
TEST(SeenPart, GrowsFromTheDark)
{
  EXPECT_EQ(SeenPart(Vec3(0.0)), 0.0);
  EXPECT_EQ(SeenPart(LightOfLab(Vec3(4.9, 0.0, 0.0))), 0.0);
  EXPECT_NEAR(SeenPart(LightOfLab(Vec3(12.5, 0.0, 0.0))), 0.5, 1e-3);
  EXPECT_EQ(SeenPart(LightOfLab(Vec3(20.1, 0.0, 0.0))), 1.0);
  EXPECT_EQ(SeenPart(Vec3(1.0)), 1.0);
}

//------------------------------------------------------------------------------
TEST(BlendSurround, KeepsWhatIsLitAndDarkensShadows)
{
  const Vec3 white(1.0);
  const Vec3 rays(0.3, 0.2, 0.1);
  EXPECT_EQ(BlendSurround(white, rays, Luminance(rays), 1.0), white);
  EXPECT_EQ(BlendSurround(white, 2.0 * rays, Luminance(rays), 1.0), white);
  EXPECT_EQ(BlendSurround(white, Vec3(0.0), 1.0, 0.0), white);
  const Vec3 shadow = 255.0 * EncodeDisplay(BlendSurround(white, Vec3(0.0), 1.0, 1.0));
  EXPECT_NEAR(length(shadow - Vec3(178.0, 189.0, 208.0)), 0.0, 0.5);
  const Vec3 half = BlendSurround(white, 0.5 * rays, Luminance(rays), 1.0);
  EXPECT_NEAR(half.x, 1.0 - std::pow(0.5, 0.75) * (1.0 - 0.445), 1e-12);
}

//------------------------------------------------------------------------------
TEST(RingLight, IsTheFit)
{
  for (const double r : { 0.0, 0.1, 0.95, 3.0 })
  {
    EXPECT_NEAR(RingLight(Vec3(std::log(2.0), 0.0, 0.0), r), 2.0, 1e-12);
    EXPECT_NEAR(RingLight(Vec3(0.0, -1.0, 0.0), r) * (r + 0.05), 1.0, 1e-12);
    EXPECT_NEAR(
      std::log(RingLight(Vec3(0.0, 0.0, -1.0), r)), -std::pow(std::log(r + 0.05), 2.0), 1e-9);
  }
}
