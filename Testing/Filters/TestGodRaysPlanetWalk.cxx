// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The walk over a shadow map where a sun shines on air over a planet, against the ground truth by
// triangles.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMediumFilter.h"
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysSingleScattering.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace GodRaysFiltersTesting;

namespace
{
using GodRaysMediumScenes::Mesh;
using Walk = vtkGodRaysInScattering;
using Vector = std::array<double, 3>;

constexpr int Width = 128;
constexpr int Height = 72;

double GetSine(double degrees)
{
  return std::sin(vtkMath::RadiansFromDegrees(degrees));
}

double GetCosine(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
}

// An eye that looks forwards and up by a pitch, over the Earth, in a unit.
struct Scene
{
  std::string Name;
  double Unit;      // [m]
  double EyeHeight; // [m]
  double Pitch;     // [degrees]
  double Elevation; // of the sun, alike
  double Azimuth;   // of the sun, from forwards to the right
  double FarLimit;  // [units]
  bool Parallel = false;
  bool IsGrey = false;
  unsigned int Occluders = 0; // of this seed; 0: none
};

struct View
{
  Vector Up;      // the vertical
  Vector Forward; // level
};

View GetView(const Scene& scene)
{
  return { { 0.0, GetCosine(scene.Pitch), GetSine(scene.Pitch) },
    { 0.0, -GetSine(scene.Pitch), GetCosine(scene.Pitch) } };
}

Walk::Parameters MakeParameters(const Scene& scene, int width = Width, int height = Height)
{
  const View view = GetView(scene);
  Walk::Parameters parameters;
  parameters.Parallel = scene.Parallel;
  parameters.PixelSize =
    (scene.Parallel ? 0.6 * scene.FarLimit : 2.0 * std::tan(vtkMath::RadiansFromDegrees(30.0))) /
    height;
  parameters.Center[0] = 0.5 * width;
  parameters.Center[1] = 0.5 * height;
  parameters.Tolerance = 1e-4;
  for (int i = 0; i < 3; ++i)
  {
    parameters.Light[i] = GetSine(scene.Elevation) * view.Up[i] +
      GetCosine(scene.Elevation) *
        (GetCosine(scene.Azimuth) * view.Forward[i] + (i == 0 ? GetSine(scene.Azimuth) : 0.0));
  }
  vtkGodRaysMedium& medium = parameters.Medium;
  medium.NumberOfComponents = scene.IsGrey ? 1 : 2;
  const double gas[3] = { 5.8e-6, 1.35e-5, 3.31e-5 };
  for (int c = 0; c < 3; ++c)
  {
    medium.Components[0].Scattering[c] = 2e-5 * scene.Unit;
    medium.Components[0].Absorption[c] = 2e-6 * scene.Unit;
    medium.Components[1].Scattering[c] = gas[c] * scene.Unit;
  }
  medium.Components[0].ScaleHeight = 1200.0 / scene.Unit;
  medium.Components[0].PhaseFunction = vtkGodRaysMediumFilter::HENYEY_GREENSTEIN;
  medium.Components[0].Asymmetry = 0.7;
  medium.Components[1].ScaleHeight = 8000.0 / scene.Unit;
  medium.Components[1].PhaseFunction = vtkGodRaysMediumFilter::RAYLEIGH;
  medium.PlanetRadius = 6.36e6 / scene.Unit;
  medium.EyeHeight = scene.EyeHeight / scene.Unit;
  medium.FarLimit = scene.FarLimit;
  std::copy_n(view.Up.data(), 3, medium.Up);
  return parameters;
}

// Balls in the air before, over and beside the eye, and hills that follow the planet's ground.
vtkSmartPointer<vtkPolyData> MakeOccluders(const Scene& scene)
{
  std::mt19937 generator(scene.Occluders);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  const View view = GetView(scene);
  const double far = scene.FarLimit;
  Mesh mesh;
  for (int i = 0; i < 40; ++i)
  {
    const double x = uniform(-0.5, 0.5) * far;
    const double y = uniform(-0.35, 0.35) * far;
    const double z = uniform(0.15, 0.8) * far;
    mesh.AddSphere(x, y, z, uniform(0.01, 0.05) * far, 24);
  }
  auto data = mesh.Get();
  if (scene.EyeHeight > 1e3 || scene.Parallel)
  {
    return data;
  }
  const int size = 40;
  vtkPoints* points = data->GetPoints();
  const vtkIdType first = points->GetNumberOfPoints();
  const double step = 2.0 * far / size;
  const double radius = 6.36e6 / scene.Unit;
  for (int j = 0; j <= size; ++j)
  {
    for (int i = 0; i <= size; ++i)
    {
      const double a = (i - 0.5 * size) * step;
      const double b = (j - 0.5 * size) * step;
      const double height = -scene.EyeHeight / scene.Unit - (a * a + b * b) / (2.0 * radius) +
        (i % 4 == 2 && j % 3 == 1 ? uniform(0.02, 0.1) * far : 0.0);
      double point[3];
      for (int k = 0; k < 3; ++k)
      {
        point[k] = (k == 0 ? a : 0.0) + b * view.Forward[k] + height * view.Up[k];
      }
      points->InsertNextPoint(point);
    }
  }
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const vtkIdType at = first + j * (size + 1) + i;
      const vtkIdType triangles[2][3] = { { at, at + 1, at + size + 1 },
        { at + 1, at + size + 2, at + size + 1 } };
      data->GetPolys()->InsertNextCell(3, triangles[0]);
      data->GetPolys()->InsertNextCell(3, triangles[1]);
    }
  }
  return data;
}

// Nested maps of triangles, each half as wide as the one before, by their texels' centres.
class Maps
{
public:
  Maps(vtkPolyData* data, const double light[3], double half, int size, int levels)
  {
    auto& axes = this->Grids.Grids[0].Axes;
    vtkMath::Perpendiculars(light, axes[0], axes[1], 0.3);
    this->Grids.Range[0] = -4.0 * half;
    this->Grids.Range[1] = 4.0 * half;
    this->Grids.Levels = levels;
    for (int level = 0; level < levels; ++level)
    {
      vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[level];
      for (int k = 0; k < 2; ++k)
      {
        grid.Size[k] = size;
        grid.Low[k] = -std::ldexp(half, -level);
        grid.Texel[k] = -2.0 * grid.Low[k] / size;
      }
      grid.Stride = size;
      this->Depths[level].assign(static_cast<std::size_t>(size) * size, 1.0f);
      grid.Depths = this->Depths[level].data();
      vtkNew<vtkIdList> ids;
      vtkCellArray* polys = data->GetPolys();
      for (polys->InitTraversal(); polys->GetNextCell(ids);)
      {
        for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
        {
          const vtkIdType corners[3] = { ids->GetId(0), ids->GetId(i - 1), ids->GetId(i) };
          this->Draw(data, corners, light, level);
        }
      }
    }
  }

  // As one layer that takes half of the light.
  vtkGodRaysShadowGrids GetHalf()
  {
    vtkGodRaysShadowGrids grids = this->Grids;
    this->Joined.clear();
    for (int level = 0; level < grids.Levels; ++level)
    {
      grids.Grids[level].First = static_cast<std::ptrdiff_t>(this->Joined.size());
      this->Joined.insert(
        this->Joined.end(), this->Depths[level].begin(), this->Depths[level].end());
    }
    this->Halves.assign(this->Joined.size(), 0.5f);
    this->Layer.Depths = this->Joined.data();
    std::fill_n(this->Layer.Dark, 3, this->Halves.data());
    grids.Layers = &this->Layer;
    grids.NumberOfLayers = 1;
    return grids;
  }

  vtkGodRaysShadowGrids Grids;

private:
  void Draw(vtkPolyData* data, const vtkIdType corners[3], const double light[3], int level)
  {
    const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[level];
    double places[3][3]; // in texels, and the height
    int low[2] = { grid.Size[0], grid.Size[1] };
    int high[2] = { -1, -1 };
    for (int i = 0; i < 3; ++i)
    {
      double point[3];
      data->GetPoint(corners[i], point);
      places[i][2] = vtkMath::Dot(point, light);
      for (int k = 0; k < 2; ++k)
      {
        places[i][k] =
          (vtkMath::Dot(point, this->Grids.Grids[0].Axes[k]) - grid.Low[k]) / grid.Texel[k] - 0.5;
        const double place = std::min(std::max(places[i][k], -1.0), grid.Size[k] + 0.0);
        low[k] = std::min(low[k], std::max(static_cast<int>(std::ceil(place)), 0));
        high[k] =
          std::max(high[k], std::min(static_cast<int>(std::floor(place)), grid.Size[k] - 1));
      }
    }
    const auto cross = [&](int i, int j, double x, double y)
    { return (places[i][0] - x) * (places[j][1] - y) - (places[j][0] - x) * (places[i][1] - y); };
    const double area = cross(0, 1, places[2][0], places[2][1]);
    for (int y = low[1]; y <= high[1] && area != 0.0; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        const double a = cross(1, 2, x, y) / area;
        const double b = cross(2, 0, x, y) / area;
        if (a < 0.0 || b < 0.0 || a + b > 1.0)
        {
          continue;
        }
        const double height = a * places[0][2] + b * places[1][2] + (1.0 - a - b) * places[2][2];
        const double depth =
          (-height - this->Grids.Range[0]) / (this->Grids.Range[1] - this->Grids.Range[0]);
        float& least = this->Depths[level][static_cast<std::size_t>(y) * grid.Stride + x];
        least = std::min(least, static_cast<float>(depth));
      }
    }
  }

  std::vector<float> Depths[vtkGodRaysShadowGrids::MaximumLevels];
  std::vector<float> Joined; // of all grids
  std::vector<float> Halves;
  vtkGodRaysShadowGrids::Layer Layer;
};

vtkGodRaysSingleScattering::Parameters MakeTruth(const Walk::Parameters& parameters)
{
  vtkGodRaysSingleScattering::Parameters truth;
  truth.Parallel = parameters.Parallel;
  std::copy_n(parameters.Light, 4, truth.Light);
  truth.Medium = parameters.Medium;
  truth.Tolerance = 1e-5;
  return truth;
}

struct Error
{
  double Rms;
  double Largest;
  double Without; // shadows, root mean square
  std::string Plan;
};

// Of a picture, at every few pixels, as parts of the brightest.
Error GetError(const Scene& scene, int every)
{
  Walk::Parameters parameters = MakeParameters(scene);
  const auto occluders = scene.Occluders ? MakeOccluders(scene) : nullptr;
  vtkGodRaysSingleScattering scattering;
  scattering.SetOccluders(occluders);
  scattering.SetParameters(MakeTruth(parameters));
  Walk walk;
  float* ends = walk.PrepareInput(Width, Height);
  const auto getPlace = [&](int x, int y) -> std::array<double, 2>
  {
    return { (x + 0.5 - parameters.Center[0]) * parameters.PixelSize,
      (y + 0.5 - parameters.Center[1]) * parameters.PixelSize };
  };
  vtkSMPTools::For(0, Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const auto place = getPlace(x, y);
          const double sight = occluders ? scattering.FindSight(place[0], place[1]) : Walk::Sky;
          ends[y * Width + x] = static_cast<float>(std::min<double>(sight, Walk::Sky));
        }
      }
    });
  EXPECT_TRUE(walk.Execute(parameters)) << scene.Name;
  const int components = walk.GetNumberOfComponents();
  const std::size_t size = static_cast<std::size_t>(Width) * Height * components;
  const std::vector<float> lit(walk.GetResult(), walk.GetResult() + size);
  std::unique_ptr<Maps> maps;
  if (occluders)
  {
    // Nested maps are about the axis through the eye, which is that of rays in perspective alone. Texels are
    // small: it is not their size that is looked at.
    maps = std::make_unique<Maps>(
      occluders, parameters.Light, 1.5 * scene.FarLimit, 2048, scene.Parallel ? 1 : 4);
    parameters.Shadows = &maps->Grids;
    EXPECT_TRUE(walk.Execute(parameters)) << scene.Name;
  }
  const float* result = walk.GetResult();
  Picture truth(Width / every, Height / every, components);
  vtkSMPTools::For(0, truth.Height, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGodRaysSingleScattering::Result ray;
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int x = 0; x < truth.Width; ++x)
        {
          const auto place = getPlace(x * every, y * every);
          scattering.Evaluate(place[0], place[1], ray);
          for (int c = 0; c < components; ++c)
          {
            truth.At(x, y, c) = ray.Radiance[c];
          }
        }
      }
    });
  Error error = {};
  double squares[2] = {};
  const double most = std::max(truth.GetMaximum(), 1e-5); // below, there is night
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        const std::size_t at = (y * every * std::size_t(Width) + x * every) * components + c;
        EXPECT_TRUE(std::isfinite(result[at]) && result[at] >= 0.0f) << scene.Name;
        const double difference = (result[at] - truth.Get(x, y, c)) / most;
        squares[0] += difference * difference;
        squares[1] += std::pow((lit[at] - truth.Get(x, y, c)) / most, 2);
        error.Largest = std::max(error.Largest, std::abs(difference));
      }
    }
  }
  error.Rms = std::sqrt(squares[0] / truth.Values.size());
  error.Without = std::sqrt(squares[1] / truth.Values.size());
  error.Plan = walk.Describe();
  std::cout << scene.Name << ": root mean square " << error.Rms << ", largest " << error.Largest
            << ", without shadows " << error.Without << ", brightest " << most << "; " << error.Plan
            << "\n";
  return error;
}

// On the ground, in the air, and in orbit; the sun high, low, and below the eye's horizon.
const Scene Scenes[] = { { "valley, low sun", 1.0, 20.0, 0.0, 4.0, 20.0, 5e3 },
  { "valley, sun behind", 1.0, 20.0, 5.0, 30.0, 160.0, 5e3 },
  { "plain, sun at the horizon", 1000.0, 2.0, 10.0, 0.0, 5.0, 200.0 },
  { "plain, sun below the horizon", 1000.0, 2.0, 10.0, -4.0, 5.0, 400.0 },
  { "aeroplane, low sun", 1000.0, 11e3, -10.0, 1.0, 40.0, 400.0 },
  { "aeroplane, sun below the horizon", 1000.0, 11e3, -4.0, -4.0, 10.0, 500.0 },
  { "orbit, day", 1e4, 4e5, -30.0, 40.0, 30.0, 300.0 },
  { "orbit, terminator", 1e4, 4e5, -30.0, -14.0, 60.0, 300.0 },
  { "orbit, night before dawn", 1e4, 4e5, -20.0, -25.0, 10.0, 400.0 },
  { "map from above", 1e3, 1e5, -90.0, 20.0, 0.0, 200.0, true },
  { "map aslant", 1e3, 3e4, -30.0, 3.0, 100.0, 200.0, true },
  { "section", 1e3, 1e3, 0.0, 1.0, 80.0, 200.0, true } };
}

//------------------------------------------------------------------------------
TEST(PlanetWalk, IsTheIntegralWithoutOccluders)
{
  for (const Scene& scene : Scenes)
  {
    const Error error = GetError(scene, 12);
    EXPECT_LE(error.Rms, 3e-4) << scene.Name;
    EXPECT_LE(error.Largest, 4e-3) << scene.Name;
  }
}

//------------------------------------------------------------------------------
// The same of any eye; GODRAYS_LONG takes more of them. The darker it is, the less light there is that a
// picture's brightest is.
TEST(PlanetWalk, IsTheIntegralInRandomViews)
{
  std::mt19937 generator = MakeGenerator(3);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  const int views = std::getenv("GODRAYS_LONG") ? 200 : 12;
  for (int i = 0; i < views; ++i)
  {
    Scene scene;
    scene.Unit = std::pow(10.0, uniform(0.0, 4.0));
    scene.FarLimit = std::pow(10.0, uniform(3.0, 6.5)) / scene.Unit;
    scene.EyeHeight = std::pow(10.0, uniform(0.0, 6.0));
    scene.Pitch = uniform(-60.0, 30.0);
    scene.Elevation = i % 2 == 0 ? uniform(-6.0, 10.0) : uniform(-6.0, 90.0);
    scene.Azimuth = uniform(-180.0, 180.0);
    scene.Parallel = i % 3 == 2;
    scene.IsGrey = i % 4 == 3;
    scene.Name = std::to_string(i) + ": far " + std::to_string(scene.FarLimit * scene.Unit) +
      " m, eye " + std::to_string(scene.EyeHeight) + " m, pitch " + std::to_string(scene.Pitch) +
      ", sun " + std::to_string(scene.Elevation) + " at " + std::to_string(scene.Azimuth);
    const Error error = GetError(scene, 12);
    EXPECT_LE(error.Rms, 1e-3) << scene.Name;
    EXPECT_LE(error.Largest, 4e-3) << scene.Name;
  }
}

//------------------------------------------------------------------------------
// Balls, and, where a map's texels are small against the scale of heights, hills.
TEST(PlanetWalk, IsTheGroundTruthWithOccluders)
{
  unsigned int seed = 1;
  double errors = 0.0;
  double shadows = 0.0;
  for (Scene scene : Scenes)
  {
    scene.Occluders = seed++;
    const Error error = GetError(scene, 8);
    // In parallel views lines decide, as over a plane: see InScattering.
    EXPECT_LE(error.Rms, scene.Parallel ? 0.005 : 0.003) << scene.Name;
    errors += error.Rms;
    shadows += error.Without;
  }
  EXPECT_GT(shadows, 10.0 * errors);
}

//------------------------------------------------------------------------------
// A layer that takes half of the light leaves the mean of all and of what opaque things leave.
TEST(PlanetWalk, TranslucentThingsCastTheirPart)
{
  for (const int index : { 0, 5, 7, 11 })
  {
    Scene scene = Scenes[index];
    scene.Occluders = 1;
    Walk::Parameters parameters = MakeParameters(scene);
    parameters.Tolerance =
      1e-7; // else half a shadow's edges are half as uneven, and walked less finely
    const auto occluders = MakeOccluders(scene);
    const int levels = scene.Parallel ? 1 : 2;
    Maps maps(occluders, parameters.Light, 1.5 * scene.FarLimit, 256, levels);
    const auto execute = [&](const vtkGodRaysShadowGrids& grids)
    {
      Walk walk;
      std::fill_n(walk.PrepareInput(Width, Height), Width * Height, Walk::Sky);
      parameters.Shadows = &grids;
      EXPECT_TRUE(walk.Execute(parameters));
      const std::size_t size = static_cast<std::size_t>(Width) * Height;
      return std::vector<float>(
        walk.GetResult(), walk.GetResult() + size * walk.GetNumberOfComponents());
    };
    const auto lit = execute(vtkGodRaysShadowGrids());
    const auto opaque = execute(maps.Grids);
    const vtkGodRaysShadowGrids grids = maps.GetHalf();
    const auto half = execute(grids);
    ASSERT_EQ(half.size(), lit.size());
    double most = 0.0;
    double largest = 0.0;
    double shadow = 0.0;
    for (std::size_t i = 0; i < lit.size(); ++i)
    {
      most = std::max<double>(most, lit[i]);
      largest = std::max<double>(largest, std::abs(half[i] - 0.5 * (lit[i] + opaque[i])));
      shadow = std::max<double>(shadow, lit[i] - opaque[i]);
    }
    std::cout << scene.Name << ": " << largest / most << ", shadows " << shadow / most << "\n";
    EXPECT_LE(largest, 1e-4 * most) << scene.Name;
    EXPECT_GT(shadow, 0.01 * most) << scene.Name;
  }
}
