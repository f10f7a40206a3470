// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Media that are looked up from numbers of any type, against the same coefficients at each point.

#include "GodRaysFiltersTesting.h"
#include "GodRaysGridScenes.h"
#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysGridTable.h"
#include "vtkGodRaysMath.h"

#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace GodRaysFiltersTesting;
using namespace GodRaysGridScenes;
using vtkGodRays::Vec3;

namespace
{
constexpr int Points = 40;
constexpr int Size[2] = { 80, 60 };

// What numbers from 0 to 100 mean: extinction, and scattering of three bands. It is linear, as tables are
// between entries.
double GetExtinction(double value)
{
  return 0.03 * value;
}
double GetScattering(double value, int band)
{
  return GetExtinction(value) * (0.3 + 0.2 * band);
}

// A plume whose numbers are whole from 0 to 100.
vtkSmartPointer<vtkImageData> MakeWhole(int type)
{
  const double bounds[6] = { -1.5, 1.5, -1.5, 1.5, -7.5, -4.5 };
  const int points[3] = { Points, Points, Points };
  return MakeImage(
    bounds, points,
    [](double x, double y, double z) { return std::min(std::round(30.0 * Plume(x, y, z)), 100.0); },
    type);
}

// Not in the left part, whose edge is in no word of 64 points.
bool IsShown(int i)
{
  return i % Points >= 13;
}

vtkGodRaysGrid MakeTabled(vtkImageData* image, int bands, bool isMasked)
{
  auto table = std::make_shared<vtkGodRaysGridTable>();
  if (isMasked)
  {
    table->Shown.Resize(image->GetNumberOfPoints(), true);
    for (int i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      table->Shown.Set(i, IsShown(i));
    }
  }
  EXPECT_TRUE(table->SetValues(image->GetPointData()->GetScalars()));
  table->Components = 1 + bands;
  for (int i = 0; i < table->Entries; ++i)
  {
    const double value = table->First + i * (table->Last - table->First) / (table->Entries - 1);
    table->Coefficients.push_back(static_cast<float>(GetExtinction(value)));
    for (int band = 0; band < bands; ++band)
    {
      table->Coefficients.push_back(static_cast<float>(GetScattering(value, band)));
    }
  }
  table->Finish();
  vtkGodRaysGrid grid;
  EXPECT_EQ(grid.Read(MakePlume(Points)), ""); // its place
  grid.Table = table;
  grid.ScatteringBands = bands;
  return grid;
}

// The same, with coefficients at each point.
vtkGodRaysGrid MakePlain(int bands, bool isMasked)
{
  auto whole = MakeWhole(VTK_DOUBLE);
  vtkDataArray* values = whole->GetPointData()->GetScalars();
  auto plain = MakePlume(Points);
  vtkNew<vtkFloatArray> scattering;
  scattering->SetName("scattering");
  scattering->SetNumberOfComponents(std::max(bands, 1));
  scattering->SetNumberOfTuples(values->GetNumberOfTuples());
  plain->GetPointData()->AddArray(scattering);
  for (int i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const bool shown = !isMasked || IsShown(i);
    const double value = shown ? values->GetTuple1(i) : 0.0;
    plain->GetPointData()->GetScalars()->SetTuple1(i, GetExtinction(value));
    for (int band = 0; band < bands; ++band)
    {
      scattering->SetComponent(i, band, GetScattering(value, band));
    }
  }
  vtkGodRaysGrid grid;
  EXPECT_EQ(grid.Read(plain, nullptr, bands > 0 ? "scattering" : nullptr), "");
  return grid;
}

struct Pictures
{
  std::vector<float> Radiance = std::vector<float>(3 * Size[0] * Size[1]);
  std::vector<float> Transmittance = std::vector<float>(3 * Size[0] * Size[1]);

  Pictures(const vtkGodRaysGrid& grid, const Vec3& light, double w)
  {
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids({ grid });
    vtkGodRaysSingleScattering::Parameters parameters;
    parameters.Forward[2] = -1.0;
    parameters.Light[0] = light.x;
    parameters.Light[1] = light.y;
    parameters.Light[2] = light.z;
    parameters.Light[3] = w;
    parameters.Medium.FarLimit = 20.0;
    parameters.Tolerance = 1.0 / 255.0;
    vtkGodRaysGridPicture::Picture picture;
    std::copy_n(Size, 2, picture.Size);
    picture.PixelSize = 2.0 * std::tan(0.35) / Size[1];
    picture.Center[0] = 0.5 * Size[0];
    picture.Center[1] = 0.5 * Size[1];
    picture.Radiance = this->Radiance.data();
    picture.Transmittance = this->Transmittance.data();
    drawer.Draw(parameters, picture);
  }
};

double FindLargest(const std::vector<float>& a, const std::vector<float>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max<double>(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}
}

//------------------------------------------------------------------------------
// Pictures of a sun and a lamp, grey and in colours, also where a part is hidden.
TEST(GridTable, IsWhatItsNumbersMean)
{
  const int types[] = { VTK_FLOAT, VTK_DOUBLE, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR,
    VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG };
  for (const int bands : { 0, 1, 3 })
  {
    for (const bool isMasked : { false, true })
    {
      const Vec3 sun(0.8, 0.6, 0.3);
      const Vec3 lamp(2.0, 1.5, -5.0);
      const auto plain = MakePlain(bands, isMasked);
      const Pictures expected[2] = { { plain, sun, 0.0 }, { plain, lamp, 1.0 } };
      for (const int type : types)
      {
        const auto grid = MakeTabled(MakeWhole(type), bands, isMasked);
        for (int i = 0; i < (type == VTK_FLOAT || type == VTK_SHORT ? 2 : 1); ++i)
        {
          const Pictures actual(grid, i == 0 ? sun : lamp, i);
          const auto& light = expected[i].Radiance;
          const double peak = *std::max_element(light.begin(), light.end());
          EXPECT_LE(FindLargest(actual.Radiance, light), 1e-5 * peak) << type << bands << isMasked;
          EXPECT_LE(FindLargest(actual.Transmittance, expected[i].Transmittance), 1e-5);
        }
      }
      if (isMasked) // the control
      {
        const Pictures whole(MakeTabled(MakeWhole(VTK_FLOAT), bands, false), sun, 0.0);
        EXPECT_GT(FindLargest(whole.Transmittance, expected[0].Transmittance), 0.1);
      }
    }
  }
}

//------------------------------------------------------------------------------
// What is found exactly: values between points, and sums along lines.
TEST(GridTable, HasTheSameDepths)
{
  const auto plain = MakePlain(3, true);
  for (const int type : { VTK_FLOAT, VTK_SHORT, VTK_INT })
  {
    const auto grid = MakeTabled(MakeWhole(type), 3, true);
    std::mt19937 generator = MakeGenerator(7);
    const auto uniform = [&]() { return generator() / 4294967296.0; };
    double deepest = 0.0;
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 place(39.0 * uniform(), 39.0 * uniform(), 39.0 * uniform());
      const Vec3 steps(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
      Vec3 depths[2] = { Vec3(0.0), Vec3(0.0) };
      plain.AddDepth(place, steps, 0.0, 1e3, depths[0]);
      grid.AddDepth(place, steps, 0.0, 1e3, depths[1]);
      deepest = std::max(deepest, depths[0].x);
      ASSERT_NEAR(depths[1].x, depths[0].x, 1e-5 * std::max(depths[0].x, 1.0));
      const Vec3 expected = plain.Sample(place).Scattering;
      const Vec3 actual = grid.Sample(place).Scattering;
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(actual[c], expected[c], 1e-5);
      }
    }
    EXPECT_GT(deepest, 10.0);
  }
}

//------------------------------------------------------------------------------
// Numbers are read where they are; those that do not stand side by side are copied, others are told of.
TEST(GridTable, ReadsNumbersInPlace)
{
  auto image = MakeWhole(VTK_FLOAT);
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  vtkGodRaysGridTable table;
  EXPECT_TRUE(table.SetValues(values));
  EXPECT_EQ(table.First, 0.0);
  EXPECT_TRUE(table.IsInPlace());
  values->Resize(2 * values->GetNumberOfTuples());
  values->SetNumberOfTuples(2 * Points * Points * Points);
  EXPECT_FALSE(table.IsInPlace());

  image = MakeWhole(VTK_FLOAT);
  vtkNew<vtkSOADataArrayTemplate<float>> apart;
  apart->DeepCopy(image->GetPointData()->GetScalars());
  const auto plain = MakeTabled(image, 0, false);
  image->GetPointData()->SetScalars(apart);
  const auto copied = MakeTabled(image, 0, false);
  const Vec3 sun(0.8, 0.6, 0.3);
  EXPECT_EQ(
    FindLargest(Pictures(plain, sun, 0.0).Radiance, Pictures(copied, sun, 0.0).Radiance), 0.0);

  image = MakeWhole(VTK_FLOAT);
  image->GetPointData()->GetScalars()->SetTuple1(Points, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(vtkGodRaysGridTable().SetValues(image->GetPointData()->GetScalars()));
  vtkGodRaysGridTable hidden; // what is hidden is no matter
  hidden.Shown.Resize(image->GetNumberOfPoints(), true);
  hidden.Shown.Set(Points, false);
  EXPECT_TRUE(hidden.SetValues(image->GetPointData()->GetScalars()));
}
