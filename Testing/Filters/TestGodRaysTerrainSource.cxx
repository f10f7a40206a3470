// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Terrain: normals against differences, the spectrum of octaves, bounds, streaming, bytes, colours.

#include "GodRaysSourceTesting.h"
#include "vtkGodRaysTerrainSource.h"

#include <array>

using namespace GodRaysFiltersTesting;
using namespace GodRaysSourceTesting;
using Terrain = vtkGodRaysTerrainSource;

namespace
{
double Get(vtkDataSet* data, const char* name, vtkIdType point, int component = 0)
{
  return data->GetPointData()->GetArray(name)->GetComponent(point, component);
}

// Standard deviation of heights.
double GetRoughness(vtkDataSet* data)
{
  double sum = 0.0;
  double squares = 0.0;
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double height = Get(data, "Height", i);
    sum += height;
    squares += height * height;
  }
  return std::sqrt(squares / count - sum * sum / count / count);
}
}

// --- Shape ------------------------------------------------------------------------------------

//------------------------------------------------------------------------------
// Normals come from derivatives: differences over a fine grid give the same, to the second order.
TEST(TerrainSource, NormalsAreThoseOfTheHeights)
{
  for (int octaves : { 1, 4 })
  {
    vtkNew<Terrain> terrain;
    terrain->SetDimensions(801, 801);
    terrain->SetFeatures(2.0);
    terrain->SetOctaves(octaves);
    terrain->SetSmoothOctaves(octaves);
    terrain->SetLacunarity(1.9);
    vtkDataSet* data = Update(terrain, 0.0);
    const double step = 2.0 * 100.0 / 800.0;
    double worst = 0.0;
    double steepest = 0.0;
    for (int y = 1; y < 800; y += 7)
    {
      for (int x = 1; x < 800; x += 7)
      {
        const vtkIdType i = x + 801 * y;
        const double slopeX = (Get(data, "Height", i + 1) - Get(data, "Height", i - 1)) / step;
        const double slopeY = (Get(data, "Height", i + 801) - Get(data, "Height", i - 801)) / step;
        const double up = Get(data, "Normals", i, 2);
        worst = std::max({ worst, std::abs(slopeX + Get(data, "Normals", i, 0) / up),
          std::abs(slopeY + Get(data, "Normals", i, 1) / up) });
        steepest = std::max({ steepest, std::abs(slopeX), std::abs(slopeY) });
        EXPECT_NEAR(
          std::hypot(Get(data, "Normals", i, 0), Get(data, "Normals", i, 1), up), 1.0, 1e-6);
        // The same octaves, the same normals.
        ASSERT_EQ(Get(data, "SelfShadow", i), 0.0);
        ASSERT_EQ(Get(data, "SmoothNormals", i, 0), Get(data, "Normals", i, 0));
      }
    }
    EXPECT_GT(steepest, 0.2);
    EXPECT_LT(worst, 0.003 * steepest);
  }
}

//------------------------------------------------------------------------------
// Octaves are independent: their variances add up, each by the square of the gain.
TEST(TerrainSource, OctavesAddUp)
{
  vtkNew<Terrain> terrain;
  terrain->SetDimensions(700, 700);
  terrain->SetFeatures(100.0);
  terrain->SetHeight(1.0);
  terrain->SetOctaves(1);
  const double one = GetRoughness(Update(terrain, 0.0));
  EXPECT_GT(one, 0.2);
  terrain->SetOctaves(3);
  terrain->SetGain(0.7);
  const double bound = 1.0 + 0.7 + 0.49;
  EXPECT_NEAR(
    GetRoughness(Update(terrain, 0.0)) * bound / one, std::sqrt(1.0 + 0.49 + 0.2401), 0.03);
}

//------------------------------------------------------------------------------
TEST(TerrainSource, IsBoundAndFollowsTheSeed)
{
  vtkNew<Terrain> terrain;
  terrain->SetFeatures(60.0);
  terrain->SetGain(1.0);
  terrain->SetOctaves(2);
  vtkDataSet* data = Update(terrain, 0.0);
  const double* range = data->GetScalarRange();
  EXPECT_GT(range[1], 10.0);
  EXPECT_LE(range[1], 30.0);
  EXPECT_LT(range[0], -10.0);
  EXPECT_GE(range[0], -30.0);
  const std::string first = GetBytes(data);
  terrain->SetSeed(2);
  EXPECT_TRUE(GetBytes(Update(terrain, 0.0)) != first);
  terrain->SetSeed(1);
  EXPECT_TRUE(GetBytes(Update(terrain, 0.0)) == first);
}

//------------------------------------------------------------------------------
// No hint of shadow where the terrain is as smooth as its normals, and more of it with more octaves.
TEST(TerrainSource, RoughGroundHasSelfShadow)
{
  double before = 0.0;
  for (int octaves : { 4, 6, 9 })
  {
    vtkNew<Terrain> terrain;
    terrain->SetOctaves(octaves);
    terrain->SetHeight(60.0);
    vtkDataSet* data = Update(terrain, 0.0);
    double mean = 0.0;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const double shadow = Get(data, "SelfShadow", i);
      ASSERT_GE(shadow, 0.0);
      ASSERT_LT(shadow, 2.0);
      mean += shadow / data->GetNumberOfPoints();
    }
    EXPECT_TRUE(octaves == 4 ? mean == 0.0 : mean > 1.5 * before) << mean;
    before = mean;
  }
}

//------------------------------------------------------------------------------
TEST(TerrainSource, ColoursFollowHeightAndSlope)
{
  const std::array<double, 3> grass = { 74.0, 92.0, 42.0 };
  const std::array<double, 3> rock = { 112.0, 100.0, 90.0 };
  const std::array<double, 3> snow = { 240.0, 244.0, 250.0 };
  vtkNew<Terrain> terrain;
  terrain->SetDimensions(65, 65);
  auto expectAll = [&](const std::array<double, 3>& color)
  {
    vtkDataSet* data = Update(terrain, 0.0);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += 17)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_EQ(Get(data, "Color", i, c), color[c]);
      }
    }
  };
  terrain->SetSnowHeight(1.0);
  terrain->SetRockSlope(90.0);
  terrain->SetHeight(1.0);
  expectAll(grass);
  terrain->SetSnowHeight(-1.0);
  expectAll(snow);
  terrain->SetHeight(1e9); // walls
  terrain->SetRockSlope(30.0);
  expectAll(rock);
  terrain->SetHeight(0.0); // a plain, at the height of the snow
  terrain->SetSnowHeight(0.5);
  expectAll(snow);
}

// --- As a source ------------------------------------------------------------------------------

//------------------------------------------------------------------------------
// A part of a terrain of 10^12 points, which no memory holds.
TEST(TerrainSource, AnyPieceIsThatOfTheWhole)
{
  vtkNew<Terrain> terrain;
  terrain->SetDimensions(60, 50);
  const vtkSmartPointer<vtkImageData> whole = terrain->GetOutput();
  terrain->Update();
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(whole);
  terrain->Modified();
  terrain->UpdateExtent(std::array<int, 6>{ 10, 29, 40, 49, 0, 0 }.data());
  vtkDataSet* piece = GetOutput(terrain);
  ASSERT_EQ(piece->GetNumberOfPoints(), 200);
  for (vtkIdType i = 0; i < 200; ++i)
  {
    const vtkIdType j = 10 + i % 20 + 60 * (40 + i / 20);
    for (const char* name : { "Height", "Normals", "SmoothNormals", "SelfShadow", "Color" })
    {
      ASSERT_EQ(Get(piece, name, i), Get(copy, name, j)) << name;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(piece->GetPoint(i)[axis], copy->GetPoint(j)[axis]);
    }
  }

  terrain->SetDimensions(1000000, 1000000);
  terrain->SetFeatures(1000.0);
  terrain->SetOctaves(16);
  terrain->SetLacunarity(4.0);
  terrain->UpdateExtent(std::array<int, 6>{ 999900, 999999, 999990, 999999, 0, 0 }.data());
  ASSERT_EQ(GetOutput(terrain)->GetNumberOfPoints(), 1000);
  EXPECT_TRUE(IsFinite(GetOutput(terrain)->GetPointData()->GetArray("Normals")));
  EXPECT_GT(GetRoughness(GetOutput(terrain)), 0.0);
}

//------------------------------------------------------------------------------
TEST(TerrainSource, BytesDoNotDependOnThreads)
{
  vtkNew<Terrain> terrain;
  terrain->SetDimensions(133, 77);
  ExpectSameOnThreads(terrain, 0.0);
  ExpectProgressAndAbort(terrain, 0.0);
  const double* bounds = GetOutput(terrain)->GetBounds();
  EXPECT_NEAR(bounds[0], -50.0, 1e-9);
  EXPECT_NEAR(bounds[1], 50.0, 1e-9);
  EXPECT_NEAR(bounds[3], 50.0 * 76.0 / 132.0, 1e-9);
}

//------------------------------------------------------------------------------
TEST(TerrainSource, ParametersAreClampedAndNeverNaN)
{
  vtkNew<Terrain> terrain;
  ExpectParameters<Terrain>(terrain,
    { { "Width", &Terrain::SetWidth, &Terrain::GetWidth, 100.0, 1e-6, 1e9 },
      { "Height", &Terrain::SetHeight, &Terrain::GetHeight, 30.0, 0.0, 1e9 },
      { "Features", &Terrain::SetFeatures, &Terrain::GetFeatures, 4.0, 0.01, 1000.0 },
      { "Gain", &Terrain::SetGain, &Terrain::GetGain, 0.5, 0.0, 1.0 },
      { "Lacunarity", &Terrain::SetLacunarity, &Terrain::GetLacunarity, 2.0, 1.0, 4.0 },
      { "SnowHeight", &Terrain::SetSnowHeight, &Terrain::GetSnowHeight, 0.15, -1.0, 1.0 },
      { "RockSlope", &Terrain::SetRockSlope, &Terrain::GetRockSlope, 35.0, 0.0, 90.0 } });
  terrain->SetDimensions(-5, 2000000);
  EXPECT_EQ(terrain->GetDimensions()[0], 2);
  EXPECT_EQ(terrain->GetDimensions()[1], 1000000);
}
