// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// A light's depths through data against sums along its ways.

#include "GodRaysFiltersTesting.h"
#include "GodRaysGridScenes.h"
#include "vtkGodRaysGridBlocks.h"
#include "vtkGodRaysGridLight.h"
#include "vtkGodRaysMath.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

using namespace GodRaysFiltersTesting;
using namespace GodRaysGridScenes;
using vtkGodRays::Vec3;

//------------------------------------------------------------------------------
// Sums along columns are exact; between columns, twice as far apart as the data, errors fall with the square
// of their distance, in the grid and in its shadow. The light number 2 grazes the face that cuts the plume
// off: depths have a bend there, between columns, and errors fall slower.
TEST(GridLight, IsTheDepthOfTheWay)
{
  const Vec3 lights[] = { Vec3(0.3, 1.0, 0.2), Vec3(-1.0, 0.9, -0.8), Vec3(0.0, -0.2, 1.0),
    Vec3(1.0, 0.0, 0.0), Vec3(1.0, 2.5, -5.0), Vec3(0.2, 0.1, -6.2) };
  const std::pair<int, vtkSmartPointer<vtkImageData>> plumes[] = { { 80, MakePlume(80) },
    { 160, MakePlume(160) } };
  for (int i = 0; i < 6; ++i)
  {
    const bool directional = i < 4;
    const Vec3 light = directional ? lights[i] / vtkGodRays::length(lights[i]) : lights[i];
    double before = 0.0;
    for (const auto& [n, image] : plumes)
    {
      vtkGodRaysGrid grid;
      ASSERT_EQ(grid.Read(image), "");
      vtkGodRaysGridLight depths;
      depths.Build(grid, vtkGodRaysGridBlocks(grid), light, directional);
      EXPECT_LE(depths.GetSize(), n * n * n * sizeof(float) / 16);
      std::mt19937 generator = MakeGenerator(41);
      const auto uniform = [&](double low, double high)
      { return low + (high - low) * (generator() / 4294967296.0); };
      double deepest = 0.0;
      double squares = 0.0;
      constexpr int count = 4000;
      for (int k = 0; k < count; ++k)
      {
        const Vec3 p(uniform(-2.0, 2.0), uniform(-2.0, 2.0), uniform(-8.0, -4.0));
        float actual = 0.0f;
        depths.AddDepth(grid, grid.GetPlace(p), &actual);
        Vec3 expected(0.0);
        const Vec3 way = directional ? light : light - p;
        const double length = directional ? 1.0 : vtkGodRays::length(way);
        grid.AddDepth(
          grid.GetPlace(p), grid.GetSteps(way / length), 0.0, directional ? 1e3 : length, expected);
        deepest = std::max(deepest, expected.x);
        squares += (actual - expected.x) * (actual - expected.x);
      }
      const double error = std::sqrt(squares / count) / deepest;
      std::cout << "light " << i << ", " << n << " points: RMSE " << error
                << " of the largest depth, " << deepest << "\n";
      EXPECT_LE(error, i == 2 ? 0.02 : 0.002);
      EXPECT_LE(n == 80 ? 0.0 : error, (i == 2 ? 0.5 : 0.3) * before);
      before = error;
    }
  }
}

//------------------------------------------------------------------------------
// Data that are noise with spikes a point wide: what a lamp leaves of light, also in three colours. A lamp's
// long ways are sums over planes of points. With all of its ways so, it would be 0.028 of 33 points with the
// lamp in them.
TEST(GridLight, IsTheDepthOfTheWayThroughNoise)
{
  const double bounds[6] = { -1.5, 1.5, -1.5, 1.5, -7.5, -4.5 };
  for (const int n : { 33, 96 })
  {
    const int points[3] = { n, n, n };
    std::mt19937 noise = MakeGenerator(3);
    const auto image = MakeImage(bounds, points,
      [&](double, double, double)
      {
        const double v = noise() / 4294967296.0;
        return v > 0.97 ? 20.0 * v : v;
      });
    vtkNew<vtkFloatArray> colors;
    colors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double v = image->GetPointData()->GetScalars()->GetTuple1(i);
      colors->InsertNextTuple3(v, 0.5 * v, 2.0 * v);
    }
    vtkNew<vtkImageData> colored;
    colored->CopyStructure(image);
    colored->GetPointData()->SetScalars(colors);
    vtkGodRaysGrid grids[2];
    ASSERT_EQ(grids[0].Read(image), "");
    ASSERT_EQ(grids[1].Read(colored), "");
    for (const Vec3& light : { Vec3(1.0, 2.5, -5.0), Vec3(0.2, 0.1, -6.2) })
    {
      vtkGodRaysGridLight lights[2];
      for (int i = 0; i < 2; ++i)
      {
        lights[i].Build(grids[i], vtkGodRaysGridBlocks(grids[i]), light, false);
      }
      std::mt19937 generator = MakeGenerator(41);
      const auto uniform = [&](double low, double high)
      { return low + (high - low) * (generator() / 4294967296.0); };
      double squares = 0.0;
      constexpr int count = 4000;
      for (int k = 0; k < count; ++k)
      {
        const Vec3 p(uniform(-2.0, 2.0), uniform(-2.0, 2.0), uniform(-8.0, -4.0));
        float actual = 0.0f;
        lights[0].AddDepth(grids[0], grids[0].GetPlace(p), &actual);
        float bands[3] = { 0.0f, 0.0f, 0.0f };
        lights[1].AddDepth(grids[1], grids[1].GetPlace(p), bands);
        for (int c = 0; c < 3; ++c)
        {
          const double expected = (c == 0 ? 1.0 : c == 1 ? 0.5 : 2.0) * actual;
          ASSERT_NEAR(bands[c], expected, 1e-3 * expected + 1e-4); // 16 bits
        }
        Vec3 depth(0.0);
        const double length = vtkGodRays::length(light - p);
        const Vec3 steps = grids[0].GetSteps((light - p) / length);
        grids[0].AddDepth(grids[0].GetPlace(p), steps, 0.0, length, depth);
        squares += std::pow(std::exp(-actual) - std::exp(-depth.x), 2);
      }
      const double error = std::sqrt(squares / count);
      std::cout << n << " points: RMSE " << error << " of what is left of light\n";
      EXPECT_LE(error, n == 33 ? (light.y > 1.0 ? 0.029 : 0.024) : (light.y > 1.0 ? 0.058 : 0.046));
    }
  }
}

//------------------------------------------------------------------------------
// Numbers of 16 bits: right to 2^-12 of themselves and 2^-16, in their order; 0 is 0, and nothing overflows.
TEST(GridLight, DepthsOf16BitsAreRightToAPartOf4096)
{
  using Depth = vtkGodRaysGridDepth;
  const auto keep = [](float depth)
  { return static_cast<double>(Depth::Decode(Depth::Encode(depth))) - Depth::Offset; };
  EXPECT_EQ(keep(0.0f), 0.0);
  double before = 0.0;
  for (float depth = 1e-9f; depth < Depth::Largest; depth *= 1.0001f)
  {
    const double kept = keep(depth);
    ASSERT_NEAR(kept, depth, (depth + 1.0 / 65536.0) * 1.001 / 4096.0);
    ASSERT_GE(kept, before);
    before = kept;
  }
  for (const float depth : { 1e5f, 1e30f })
  {
    EXPECT_NEAR(keep(depth), Depth::Largest, 0.001 * Depth::Largest);
  }
}
