// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Media of data, fast: pictures against the ground truth at pixels of all of them.

#include "GodRaysFiltersTesting.h"
#include "GodRaysGridScenes.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysMath.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>

using namespace GodRaysFiltersTesting;
using namespace GodRaysGridScenes;
using GodRaysMediumScenes::Mesh;
using vtkGodRays::Vec3;
using Parameters = vtkGodRaysSingleScattering::Parameters;

namespace
{
struct Drawing
{
  int Size[2] = { 320, 180 };
  std::vector<float> Radiance;
  std::vector<float> Transmittance;
  std::vector<float> Depths;

  double GetPixelSize() const { return 2.0 * std::tan(0.5) / this->Size[1]; }

  void Draw(vtkGodRaysGridPicture& drawer, const Parameters& parameters)
  {
    const std::size_t count = 3 * static_cast<std::size_t>(this->Size[0]) * this->Size[1];
    this->Radiance.assign(count, -1.0f);
    this->Transmittance.assign(count, -1.0f);
    vtkGodRaysGridPicture::Picture picture;
    std::copy_n(this->Size, 2, picture.Size);
    picture.PixelSize = this->GetPixelSize();
    picture.Center[0] = 0.5 * this->Size[0];
    picture.Center[1] = 0.5 * this->Size[1];
    picture.Depths = this->Depths.empty() ? nullptr : this->Depths.data();
    picture.Radiance = this->Radiance.data();
    picture.Transmittance = this->Transmittance.data();
    drawer.Draw(parameters, picture);
  }
};

// A camera in the origin that looks along -z, and a sun.
Parameters MakeParameters(const Vec3& light, double w)
{
  Parameters parameters;
  parameters.Forward[2] = -1.0;
  parameters.Light[0] = light.x;
  parameters.Light[1] = light.y;
  parameters.Light[2] = light.z;
  parameters.Light[3] = w;
  parameters.Medium.FarLimit = 20.0;
  parameters.Tolerance = 1.0 / 255.0;
  return parameters;
}

void AddHaze(Parameters& parameters, double scaleHeight = 0.0)
{
  vtkGodRaysMedium::Component& haze = parameters.Medium.Components[0];
  std::fill_n(haze.Scattering, 3, 0.03);
  haze.PhaseFunction = 2;
  haze.Asymmetry = 0.6;
  haze.ScaleHeight = scaleHeight;
  parameters.Medium.EyeHeight = 1.5;
}

std::vector<vtkGodRaysGrid> ReadGrids(std::initializer_list<vtkImageData*> images)
{
  std::vector<vtkGodRaysGrid> grids;
  for (vtkImageData* image : images)
  {
    vtkGodRaysGrid grid;
    EXPECT_EQ(grid.Read(image), "");
    std::fill_n(grid.Albedo, 3, 0.9);
    grid.PhaseFunction = 2;
    grid.Asymmetry = 0.5;
    grids.push_back(grid);
  }
  return grids;
}

struct Error
{
  double Rms = 0.0; // fraction of the peak
  double Largest = 0.0;
  double Transmittance = 0.0; // largest
  double Effect = 0.0;        // of data, the same way as Rms
};

// At every stride-th pixel of each axis. What the picture adds is held to the difference that data make to
// the truth.
Error Compare(const Drawing& drawing, Parameters parameters,
  const std::vector<vtkGodRaysGrid>& grids, vtkPolyData* occluders = nullptr, int stride = 13)
{
  parameters.Tolerance = 1e-5;
  vtkGodRaysSingleScattering truths[2];
  for (vtkGodRaysSingleScattering& truth : truths)
  {
    truth.SetParameters(parameters);
    truth.SetOccluders(occluders);
  }
  truths[0].SetGrids(grids);
  const int columns = drawing.Size[0] / stride;
  const int rows = drawing.Size[1] / stride;
  std::vector<double> numbers(4 * static_cast<std::size_t>(columns) * rows);
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGodRaysSingleScattering::Result rays[2];
      for (vtkIdType j = begin; j < end; ++j)
      {
        for (int i = 0; i < columns; ++i)
        {
          const int x = i * stride + static_cast<int>(j) % stride; // in no row of any raster
          const int y = static_cast<int>(j) * stride + i % stride;
          for (int k = 0; k < 2; ++k)
          {
            truths[k].Evaluate((x + 0.5 - 0.5 * drawing.Size[0]) * drawing.GetPixelSize(),
              (y + 0.5 - 0.5 * drawing.Size[1]) * drawing.GetPixelSize(), rays[k]);
          }
          const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * drawing.Size[0] + x);
          double* n = numbers.data() + 4 * (j * columns + i);
          n[0] = rays[0].Radiance[0] - rays[1].Radiance[0];
          n[1] = rays[0].Radiance[0];
          n[2] = drawing.Radiance[pixel];
          n[3] = std::abs(
            drawing.Transmittance[pixel] - rays[0].Transmittance[0] / rays[1].Transmittance[0]);
        }
      }
    });
  Error error;
  double peak = 0.0;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
  {
    const double difference = numbers[i + 2] - numbers[i];
    peak = std::max(peak, numbers[i + 1]);
    error.Rms += difference * difference;
    error.Effect += numbers[i] * numbers[i];
    error.Largest = std::max(error.Largest, std::abs(difference));
    error.Transmittance = std::max(error.Transmittance, numbers[i + 3]);
  }
  error.Rms = std::sqrt(error.Rms / columns / rows) / peak;
  error.Effect = std::sqrt(error.Effect / columns / rows) / peak;
  error.Largest /= peak;
  return error;
}

void Print(
  const char* name, const Error& error, const vtkGodRaysGridPicture& drawer, const Drawing& drawing)
{
  std::cout << name << ": RMSE " << error.Rms << ", largest " << error.Largest << ", transmittance "
            << error.Transmittance << ", effect of data " << error.Effect << "; "
            << static_cast<double>(drawer.GetNumberOfRays()) / (drawing.Size[0] * drawing.Size[1])
            << " rays a pixel, "
            << static_cast<double>(drawer.GetNumberOfSteps()) / drawer.GetNumberOfRays()
            << " steps a ray\n";
}
}

//------------------------------------------------------------------------------
// A plume in nothing and in haze, in the light of a sun at the side, before and behind, and of a lamp.
TEST(GridPicture, IsTheTruthToItsTolerance)
{
  const auto grids = ReadGrids({ MakePlume(48) });
  const struct
  {
    const char* Name;
    Vec3 Light;
    double W;
    bool Haze;
    double ScaleHeight;
  } cases[] = { { "sun at the side", Vec3(0.8, 0.6, 0.3), 0.0, false, 0.0 },
    { "sun behind, haze", Vec3(0.1, 0.3, -1.0), 0.0, true, 0.0 },
    { "sun above, haze that thins out", Vec3(0.2, 1.0, 0.1), 0.0, true, 4.0 },
    { "lamp at the side", Vec3(2.0, 1.5, -5.0), 1.0, false, 0.0 },
    { "lamp in the plume", Vec3(0.1, 0.0, -5.9), 1.0, false, 0.0 } };
  for (const auto& each : cases)
  {
    Parameters parameters = MakeParameters(each.Light, each.W);
    if (each.Haze)
    {
      AddHaze(parameters, each.ScaleHeight);
    }
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids(grids);
    Drawing drawing;
    drawing.Draw(drawer, parameters);
    const Error error = Compare(drawing, parameters, grids);
    Print(each.Name, error, drawer, drawing);
    EXPECT_LE(error.Rms, 1.0 / 255.0) << each.Name;
    EXPECT_LE(error.Transmittance, 4.0 / 255.0) << each.Name;
    EXPECT_GT(error.Effect, 5.0 / 255.0) << each.Name; // the control
    // What of a ray is before and behind data has few steps: 86 at equal distances.
    EXPECT_LE(drawer.GetNumberOfSteps(), 50 * drawer.GetNumberOfRays()) << each.Name;
  }
}

//------------------------------------------------------------------------------
// Where data alone would do with few steps: what else changes within one has to count.
TEST(GridPicture, IsTheTruthWhereDataAreEven)
{
  const auto make = [](double x, double y, double z, double half, int n, const Field& field)
  {
    const double bounds[6] = { x - half, x + half, y - half, y + half, z - half, z + half };
    const int points[3] = { n, n, n };
    return MakeImage(bounds, points, field);
  };
  const auto even = [](double value) { return [value](double, double, double) { return value; }; };
  const auto ball = [](double x, double y, double z)
  { return 0.1 + 4.0 * std::exp(-10.0 * (x * x + (y - 0.9) * (y - 0.9) + (z + 6.0) * (z + 6.0))); };
  const auto check =
    [](const char* name, const Parameters& parameters, std::initializer_list<vtkImageData*> images)
  {
    const auto grids = ReadGrids(images);
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids(grids);
    Drawing drawing;
    drawing.Draw(drawer, parameters);
    const Error error = Compare(drawing, parameters, grids);
    Print(name, error, drawer, drawing);
    EXPECT_LE(error.Rms, 1.0 / 255.0) << name;
    EXPECT_GT(error.Effect, 5.0 / 255.0) << name; // the control
    return error;
  };
  const Vec3 sun(0.1, 1.0, 0.2);
  Parameters parameters = MakeParameters(sun, 0.0);
  check("a ball's shadow in thin data", parameters, { make(0, 0, -6, 1.5, 49, ball) });
  AddHaze(parameters);
  std::fill_n(parameters.Medium.Components[0].Scattering, 3, 0.2);
  check("haze between two clouds", parameters,
    { make(0, 0, -3, 0.7, 25, even(1.0)), make(0, 0, -17, 2.0, 25, even(1.0)) });
  check("haze in a coarse cloud", parameters, { make(0, 0, -9, 6.0, 7, even(0.1)) });
  AddHaze(parameters, 3.0);
  std::fill_n(parameters.Medium.Components[0].Scattering, 3, 1.0);
  parameters.Medium.EyeHeight = 9.0;
  check("haze that thins out in a coarse cloud", parameters, { make(0, 0, -9, 6.0, 7, even(0.1)) });
  check("a lamp in a coarse cloud", MakeParameters(Vec3(0.2, 0.1, -6.0), 1.0),
    { make(0, 0, -6, 2.0, 5, even(0.2)) });
  Parameters behind = MakeParameters(Vec3(0.1, 0.1, -8.5), 1.0);
  AddHaze(behind);
  const Error about =
    check("haze about a lamp behind a coarse cloud", behind, { make(0, 0, -6, 2.0, 5, even(0.3)) });
  EXPECT_LE(about.Largest, 2.0 / 255.0); // of few pixels
  behind = MakeParameters(Vec3(0.0, 3.0, -12.0), 1.0);
  AddHaze(behind);
  behind.Spot.Axis[1] = -1.0;
  behind.Spot.Axis[2] = 0.0;
  behind.Spot.CosCone = std::cos(vtkMath::RadiansFromDegrees(4.0));
  check("a narrow beam behind a cloud", behind, { make(0, 0, -6, 2.0, 33, even(0.12)) });
  check("a cell with a lamp in it", MakeParameters(Vec3(0.2, 0.1, -6.0), 1.0),
    { make(0, 0, -6, 2.0, 2, even(0.2)) });
}

//------------------------------------------------------------------------------
// Data in which light falls within a cell or a few, those that have an edge, and thin ones. For a sheet as
// thin as a cell the error is twice as large, as vtkGodRaysGridFilter says: the light's depths are known at
// every other point.
TEST(GridPicture, IsTheTruthOfDenseSharpAndThinData)
{
  const auto ball = [](double extinction, double width) -> Field
  {
    return [=](double x, double y, double z)
    {
      const double square = x * x + y * y + (z + 6.0) * (z + 6.0);
      return extinction * std::exp(-square / (width * width));
    };
  };
  const Field box = [](double x, double y, double z)
  { return std::abs(x) < 0.7 && std::abs(y) < 0.6 && std::abs(z + 6.0) < 0.8 ? 3.0 : 0.0; };
  const Field sheet = [](double x, double y, double z)
  { return std::abs(z + 6.0 + 0.3 * x + 0.2 * y) < 0.05 ? 4.0 : 0.0; };
  const struct
  {
    const char* Name;
    Field Values;
    double Bound;
  } cases[] = { { "extinction 10", ball(10.0, 0.8), 1.0 },
    { "extinction 40", ball(40.0, 0.8), 1.0 }, { "box", box, 1.0 }, { "sheet", sheet, 2.0 },
    { "thin", ball(0.02, 0.8), 1.0 } };
  const double bounds[6] = { -1.5, 1.5, -1.5, 1.5, -7.5, -4.5 };
  const int points[3] = { 64, 64, 64 };
  for (const auto& each : cases)
  {
    const auto grids = ReadGrids({ MakeImage(bounds, points, each.Values) });
    for (const bool isLamp : { false, true })
    {
      const Parameters parameters = isLamp ? MakeParameters(Vec3(2.0, 1.5, -5.0), 1.0)
                                           : MakeParameters(Vec3(0.8, 0.6, 0.3), 0.0);
      vtkGodRaysGridPicture drawer;
      drawer.SetGrids(grids);
      Drawing drawing;
      drawing.Draw(drawer, parameters);
      const Error error = Compare(drawing, parameters, grids);
      Print(each.Name, error, drawer, drawing);
      EXPECT_LE(error.Rms, each.Bound / 255.0) << each.Name;
      EXPECT_GT(error.Effect, 5.0 / 255.0) << each.Name; // the control
    }
  }
}

//------------------------------------------------------------------------------
// A lamp beside the eye, both in data that scatter nearly all light forwards or back: near the lamp, the
// angle of scattering changes fast along a ray.
TEST(GridPicture, IsTheTruthOfNarrowPhaseFunctions)
{
  const double bounds[6] = { -4.0, 4.0, -4.0, 4.0, -7.0, 1.0 };
  const int points[3] = { 7, 7, 7 };
  const auto image = MakeImage(bounds, points,
    [](double x, double y, double z) { return 0.2 + 0.05 * std::sin(x + 2.0 * y + z); });
  for (const double asymmetry : { -0.95, -0.9, 0.9, 0.95 })
  {
    auto grids = ReadGrids({ image });
    grids[0].Asymmetry = asymmetry;
    const Parameters parameters =
      MakeParameters(Vec3(0.3, 0.2, asymmetry < 0.0 ? -0.6 : -3.0), 1.0);
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids(grids);
    Drawing drawing;
    drawing.Size[0] = 96;
    drawing.Size[1] = 72;
    drawing.Draw(drawer, parameters);
    const Error error = Compare(drawing, parameters, grids, nullptr, 3);
    Print(std::to_string(asymmetry).c_str(), error, drawer, drawing);
    EXPECT_LE(error.Rms, 1.0 / 255.0) << asymmetry;
    EXPECT_GT(error.Effect, 5.0 / 255.0) << asymmetry; // the control
  }
}

//------------------------------------------------------------------------------
// In another unit of length the picture is the same to its tolerance, and the ground truth to 1e-4: also
// where a cell is shorter than any length that is short in the usual one.
TEST(GridPicture, IsTheSameInAnyUnit)
{
  std::vector<float> usual;
  double truth = 0.0;
  const std::pair<double, bool> cases[] = { { 1.0, false }, { 1e-12, false }, { 1e-9, false },
    { 1e9, false }, { 1.0, true }, { 1e-12, true }, { 1e9, true } };
  for (const auto& [length, lamp] : cases)
  {
    const double unit = length;
    const double bounds[6] = { -1.5 * unit, 1.5 * unit, -1.5 * unit, 1.5 * unit, -7.5 * unit,
      -4.5 * unit };
    const int points[3] = { 24, 24, 24 };
    const auto image = MakeImage(bounds, points,
      [unit](double x, double y, double z) { return Plume(x / unit, y / unit, z / unit) / unit; });
    const auto grids = ReadGrids({ image });
    Parameters parameters = lamp ? MakeParameters(unit * Vec3(2.0, 1.5, -5.0), 1.0)
                                 : MakeParameters(Vec3(0.8, 0.6, 0.3), 0.0);
    std::fill_n(
      parameters.LightColor, 3, lamp ? 10.0 * unit * unit : 1.0); // which falls with its square
    parameters.Medium.FarLimit = 20.0 * unit;
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids(grids);
    Drawing drawing;
    drawing.Draw(drawer, parameters);
    vtkGodRaysSingleScattering reference;
    Parameters fine = parameters;
    fine.Tolerance = 1e-5;
    reference.SetParameters(fine);
    reference.SetGrids(grids);
    vtkGodRaysSingleScattering::Result result;
    reference.Evaluate(0.01, -0.02, result);
    if (unit == 1.0)
    {
      usual = drawing.Radiance;
      truth = result.Radiance[0];
      EXPECT_GT(truth, 0.005);
    }
    double largest = 0.0;
    double peak = 0.0;
    for (std::size_t i = 0; i < usual.size(); ++i)
    {
      largest = std::max<double>(largest, std::abs(drawing.Radiance[i] - usual[i]));
      peak = std::max<double>(peak, usual[i]);
    }
    EXPECT_LE(largest, parameters.Tolerance * peak) << unit << (lamp ? ", lamp" : ", sun");
    EXPECT_NEAR(result.Radiance[0], truth, 1e-4 * truth) << unit;
  }
}

//------------------------------------------------------------------------------
// A view ray in a face of the blocks that empty space is skipped by, but for rounding. It took 1e9 steps.
TEST(GridPicture, ViewRaysMayLieInFaces)
{
  const auto grids = ReadGrids({ MakePlume(65) }); // of which x = 0 is such a face
  Drawing drawings[2];
  for (int i = 0; i < 2; ++i)
  {
    Parameters parameters = MakeParameters(Vec3(0.8, 0.6, 0.3), 0.0);
    parameters.Forward[0] = i == 0 ? 0.0 : -1e-17;
    vtkGodRaysGridPicture drawer;
    drawer.SetGrids(grids);
    drawings[i].Size[0] = 17;
    drawings[i].Size[1] = 9;
    drawings[i].Draw(drawer, parameters);
    EXPECT_LT(drawer.GetNumberOfSteps(), 200 * drawer.GetNumberOfRays());
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < drawings[0].Radiance.size(); ++i)
  {
    worst = std::max<double>(worst, std::abs(drawings[0].Radiance[i] - drawings[1].Radiance[i]));
  }
  const double peak = *std::max_element(drawings[0].Radiance.begin(), drawings[0].Radiance.end());
  EXPECT_LT(worst, 0.1 * peak / 255.0); // steps are those of the block on either side
}

//------------------------------------------------------------------------------
// A roof that stands between the sun and half of the plume, as a shadow map of it tells: the tolerance and
// half of it for the map's pixels.
TEST(GridPicture, SurfacesThrowShadowsOnData)
{
  const auto grids = ReadGrids({ MakePlume(32) });
  Parameters parameters = MakeParameters(Vec3(0.0, 1.0, 0.0), 0.0);
  AddHaze(parameters);
  Mesh mesh;
  mesh.AddBox(-0.4, 0.1, 1.7, 1.8, -6.5, -5.5);
  // Seen from above: texels of 1/128, the roof at depth 0.2 between heights of 2 and 1.
  constexpr int size = 1024;
  std::vector<float> depths(size * size, 1.0f);
  vtkGodRaysShadowGrids shadows;
  shadows.Levels = 1;
  shadows.Grids[0].Depths = depths.data();
  shadows.Grids[0].Stride = size;
  shadows.Grids[0].Axes[1][1] = 0.0; // along x and, forwards, z
  shadows.Grids[0].Axes[1][2] = 1.0;
  shadows.Range[0] = -2.0;
  shadows.Range[1] = -1.0;
  const double low[2] = { -4.0, 2.0 };
  for (int i = 0; i < 2; ++i)
  {
    shadows.Grids[0].Size[i] = size;
    shadows.Grids[0].Low[i] = low[i];
    shadows.Grids[0].Texel[i] = 1.0 / 128.0;
  }
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const double x = low[0] + (i + 0.5) / 128.0;
      const double z = low[1] + (j + 0.5) / 128.0;
      if (x > -0.4 && x < 0.1 && z > 5.5 && z < 6.5)
      {
        depths[j * size + i] = 0.2f;
      }
    }
  }
  vtkGodRaysGridPicture drawer;
  drawer.SetGrids(grids);
  Drawing drawing;
  drawing.Draw(drawer, parameters);
  const Error without = Compare(drawing, parameters, grids, mesh.Get());
  drawer.SetShadows(&shadows);
  drawing.Draw(drawer, parameters);
  const Error error = Compare(drawing, parameters, grids, mesh.Get());
  Print("without a map", without, drawer, drawing);
  Print("with a map", error, drawer, drawing);
  EXPECT_LE(error.Rms, 1.5 / 255.0);
  EXPECT_GT(without.Rms, 5.0 * error.Rms); // the control
  EXPECT_TRUE(drawer.KeptLight());
}

//------------------------------------------------------------------------------
// Ends of rays in the plume; two plumes that overlap; fewer rays and steps for a larger tolerance; light that
// is kept; bytes of one thread and of two.
TEST(GridPicture, TakesWhatThereIsAndNoMore)
{
  const double bounds[6] = { -0.5, 2.0, -1.0, 1.0, -8.0, -5.0 };
  const int points[3] = { 40, 32, 48 };
  auto other = MakeImage(bounds, points,
    [](double x, double y, double z)
    { return 0.4 + 0.1 * std::sin(3.0 * x + 2.0 * y) * std::cos(z); });
  auto plume = MakePlume(48);
  const auto grids = ReadGrids({ plume, other });
  Parameters parameters = MakeParameters(Vec3(0.8, 0.6, 0.3), 0.0);
  AddHaze(parameters);
  vtkGodRaysGridPicture drawer;
  drawer.SetGrids(grids);
  Drawing drawing;
  drawing.Draw(drawer, parameters);
  EXPECT_FALSE(drawer.KeptLight());
  Error error = Compare(drawing, parameters, grids);
  Print("two media", error, drawer, drawing);
  EXPECT_LE(error.Rms, 1.0 / 255.0);
  const std::size_t rays = drawer.GetNumberOfRays();
  const auto first = drawing.Radiance;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 1, "STDThread", false }, [&]() { drawing.Draw(drawer, parameters); });
  EXPECT_TRUE(drawer.KeptLight());
  EXPECT_EQ(std::memcmp(first.data(), drawing.Radiance.data(), first.size() * sizeof(float)), 0);
  const std::size_t steps = drawer.GetNumberOfSteps();
  parameters.Tolerance = 0.04;
  drawing.Draw(drawer, parameters);
  const Error coarser = Compare(drawing, parameters, grids);
  Print("tolerance 0.04", coarser, drawer, drawing);
  EXPECT_LE(coarser.Rms, 0.04);
  EXPECT_GT(coarser.Rms, error.Rms);
  EXPECT_LT(drawer.GetNumberOfRays(), 0.8 * rays);
  EXPECT_LT(drawer.GetNumberOfSteps(), 0.6 * steps);
  parameters.Light[0] = -0.8;
  drawing.Draw(drawer, parameters);
  EXPECT_FALSE(drawer.KeptLight());

  // A wall that stands in the data, on the left half of the picture.
  parameters.Tolerance = 1.0 / 255.0;
  drawing.Depths.assign(drawing.Size[0] * drawing.Size[1], 1e30f);
  for (int y = 0; y < drawing.Size[1]; ++y)
  {
    std::fill_n(drawing.Depths.begin() + y * drawing.Size[0], drawing.Size[0] / 2, 6.0f);
  }
  drawing.Draw(drawer, parameters);
  Mesh wall;
  wall.AddPolygon({ wall.AddPoint(-50.0, -50.0, -6.0), wall.AddPoint(0.0, -50.0, -6.0),
    wall.AddPoint(0.0, 50.0, -6.0), wall.AddPoint(-50.0, 50.0, -6.0) });
  // As the wall throws no shadow here, its rays are asked for one by one.
  vtkGodRaysSingleScattering truths[2];
  for (int k = 0; k < 2; ++k)
  {
    Parameters exact = parameters;
    exact.Tolerance = 1e-5;
    truths[k].SetParameters(exact);
    truths[k].SetSeen(wall.Get());
  }
  truths[0].SetGrids(grids);
  double squares = 0.0;
  double effect = 0.0; // of the wall
  const double peak = *std::max_element(drawing.Radiance.begin(), drawing.Radiance.end());
  for (int x = 140; x < 180; ++x)
  {
    vtkGodRaysSingleScattering::Result results[2];
    for (int k = 0; k < 2; ++k)
    {
      truths[k].Evaluate(
        (x + 0.5 - 160.0) * drawing.GetPixelSize(), 5.5 * drawing.GetPixelSize(), results[k]);
    }
    const double error = drawing.Radiance[3 * (95 * drawing.Size[0] + x)] - results[0].Radiance[0] +
      results[1].Radiance[0];
    squares += error * error;
    effect += x == 159 ? results[0].Radiance[0] : x == 160 ? -results[0].Radiance[0] : 0.0;
  }
  const double rms = std::sqrt(squares / 40.0) / peak;
  std::cout << "at the edge of a wall in the data: RMSE " << rms << ", step " << effect / peak
            << "\n";
  EXPECT_LE(rms, 2.0 / 255.0); // of 20 pixels on either side
  EXPECT_GT(std::abs(effect) / peak, 10.0 / 255.0);
}

//------------------------------------------------------------------------------
// With GODRAYS_LONG: the time of 1920 x 1080 pixels and data of 256^3 points.
TEST(GridPicture, TimeOfALargePicture)
{
  const bool large = std::getenv("GODRAYS_LONG") != nullptr;
  const auto grids = ReadGrids({ MakePlume(large ? 256 : 32) });
  Drawing drawing;
  drawing.Size[0] = large ? 1920 : 160;
  drawing.Size[1] = large ? 1080 : 90;
  const auto time = [](const std::function<void()>& function)
  {
    const auto begin = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  // A march: 60 bilinear taps of a picture of one channel, on one thread.
  std::vector<float> picture(static_cast<std::size_t>(drawing.Size[0]) * drawing.Size[1], 0.5f);
  std::vector<float> sums(picture.size());
  const double march = time(
    [&]()
    {
      for (int y = 0; y < drawing.Size[1]; ++y)
      {
        for (int x = 0; x < drawing.Size[0]; ++x)
        {
          float sum = 0.0f;
          for (int k = 0; k < 60; ++k)
          {
            const float t = k / 60.0f;
            const float u = x + t * (drawing.Size[0] / 2 - 1 - x);
            const float v = y + t * (drawing.Size[1] / 2 - 1 - y);
            const int i = static_cast<int>(u);
            const int j = static_cast<int>(v);
            const float* p = picture.data() +
              static_cast<std::size_t>(std::min(j, drawing.Size[1] - 2)) * drawing.Size[0] +
              std::min(i, drawing.Size[0] - 2);
            const float a = p[0] + (u - i) * (p[1] - p[0]);
            const float b =
              p[drawing.Size[0]] + (u - i) * (p[drawing.Size[0] + 1] - p[drawing.Size[0]]);
            sum += a + (v - j) * (b - a);
          }
          sums[static_cast<std::size_t>(y) * drawing.Size[0] + x] = sum;
        }
      }
    });
  std::cout << "a march on one thread: " << march << " s\n";
  for (const bool haze : { false, true })
  {
    Parameters parameters = MakeParameters(Vec3(0.8, 0.6, 0.3), 0.0);
    if (haze)
    {
      AddHaze(parameters);
    }
    vtkGodRaysGridPicture drawer;
    const double blocks = time([&]() { drawer.SetGrids(grids); });
    const double first = time([&]() { drawing.Draw(drawer, parameters); });
    const double second = time([&]() { drawing.Draw(drawer, parameters); });
    std::cout << (haze ? "in haze" : "alone") << ": blocks " << blocks << " s, first picture "
              << first << " s, next " << second << " s, "
              << vtkSMPTools::GetEstimatedNumberOfThreads() << " threads\n";
    EXPECT_TRUE(drawer.KeptLight());
    const Error error = Compare(drawing, parameters, grids, nullptr, large ? 120 : 13);
    Print("large", error, drawer, drawing);
    EXPECT_LE(error.Rms, 1.0 / 255.0);
  }
  EXPECT_GT(sums[sums.size() / 2], 29.0f);
}
