// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// View rays' walks through a shadow map, against looking every point of every view ray up in
// the same map.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMediumFilter.h"
#include "vtkGodRaysShadowGrids.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace GodRaysFiltersTesting;

namespace
{
using Walk = vtkGodRaysInScattering;

constexpr int Width = 160;
constexpr int Height = 90;

struct Direction
{
  const char* Name;
  double Light[3];
};
const Direction Directions[] = { { "front", { 0.15, 0.22, 1.0 } }, { "edge", { 0.94, 0.22, 1.0 } },
  { "aside", { 1.0, 0.4, 0.0 } }, { "off", { 1.6, 0.7, 1.0 } }, { "behind", { 0.2, 0.3, -1.0 } },
  { "above", { 0.0, 1.0, 0.0 } }, { "nearly aside", { -1.0, 0.3, 1e-7 } } };

Walk::Parameters MakeParameters(int width, int height, const double light[3])
{
  Walk::Parameters parameters;
  parameters.PixelSize = 2.0 / height * std::tan(vtkMath::RadiansFromDegrees(30.0));
  parameters.Center[0] = 0.5 * width;
  parameters.Center[1] = 0.5 * height;
  std::copy_n(light, 3, parameters.Light);
  vtkMath::Normalize(parameters.Light);
  parameters.Medium.FarLimit = 20.0;
  parameters.Tolerance = 1e-4;
  vtkGodRaysMedium::Component& component = parameters.Medium.Components[0];
  std::fill_n(component.Scattering, 3, 0.1);
  component.PhaseFunction = vtkGodRaysMediumFilter::HENYEY_GREENSTEIN;
  component.Asymmetry = 0.6;
  return parameters;
}

// A picture 10 high.
void SetParallel(Walk::Parameters& parameters)
{
  parameters.Parallel = true;
  parameters.PixelSize = 10.0 / Height;
}

struct Ball
{
  double Center[3];
  double Radius;
};

// With gaps among them, around the view rays and outside of the picture.
std::vector<Ball> MakeBalls()
{
  std::mt19937 generator(5);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  std::vector<Ball> balls(60);
  for (Ball& ball : balls)
  {
    ball.Center[0] = uniform(-8.0, 8.0);
    ball.Center[1] = uniform(-6.0, 6.0);
    ball.Center[2] = uniform(3.0, 16.0);
    ball.Radius = uniform(0.1, 0.8);
  }
  return balls;
}

class Map
{
public:
  virtual ~Map() = default;
  virtual bool IsLit(const double place[3]) const = 0;
  vtkGodRaysShadowGrids Grids;

protected:
  // A square grid's depths, of the places along its axes.
  template <typename Function>
  void Fill(int index, int size, double half, Function getDepth)
  {
    vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[index];
    for (int k = 0; k < 2; ++k)
    {
      grid.Size[k] = size;
      grid.Low[k] = -half;
      grid.Texel[k] = 2.0 * half / size;
    }
    grid.Stride = size;
    this->Depths[index].resize(static_cast<std::size_t>(size) * size);
    grid.Depths = this->Depths[index].data();
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        this->Depths[index][j * static_cast<std::size_t>(size) + i] = static_cast<float>(getDepth(
          grid.Low[0] + (i + 0.5) * grid.Texel[0], grid.Low[1] + (j + 0.5) * grid.Texel[1]));
      }
    }
  }

  const std::vector<Ball> Balls = MakeBalls();

private:
  std::vector<float> Depths[vtkGodRaysShadowGrids::MaximumGrids];
};

class SunMap : public Map
{
public:
  SunMap(const double light[3], int size, int levels)
  {
    std::copy_n(light, 3, this->Light);
    vtkMath::Normalize(this->Light);
    auto& axes = this->Grids.Grids[0].Axes;
    vtkMath::Perpendiculars(this->Light, axes[0], axes[1], 0.3);
    this->Grids.Range[0] = -40.0;
    this->Grids.Range[1] = 40.0;
    this->Grids.Levels = levels;
    for (int level = 0; level < levels; ++level)
    {
      this->Fill(level, size, std::ldexp(14.0, -level),
        [this](double a, double b) { return this->Look(a, b); });
    }
  }

  double Light[3];

  bool IsLit(const double place[3]) const override
  {
    return vtkMath::Dot(place, this->Light) > this->Grids.GetHeight(place);
  }

private:
  double Look(double a, double b) const
  {
    double height = -40.0;
    for (const Ball& ball : this->Balls)
    {
      const double square = ball.Radius * ball.Radius -
        std::pow(a - vtkMath::Dot(ball.Center, this->Grids.Grids[0].Axes[0]), 2) -
        std::pow(b - vtkMath::Dot(ball.Center, this->Grids.Grids[0].Axes[1]), 2);
      if (square > 0.0)
      {
        height = std::max(height, vtkMath::Dot(ball.Center, this->Light) + std::sqrt(square));
      }
    }
    return (40.0 - height) / 80.0;
  }
};

// Six faces about a lamp, or one that looks back to the eye.
class LampMap : public Map
{
public:
  LampMap(const double light[3], int size, int faces)
  {
    std::copy_n(light, 3, this->Light);
    this->Grids.Point = true;
    this->Grids.Levels = faces;
    this->Grids.Range[0] = 0.01;
    this->Grids.Range[1] = 60.0;
    for (int face = 0; face < faces; ++face)
    {
      auto& axes = this->Grids.Grids[face].Axes;
      axes[2][0] = axes[2][1] = axes[2][2] = 0.0;
      axes[2][faces == 1 ? 2 : face / 2] = faces == 1 || face % 2 == 1 ? -1.0 : 1.0;
      vtkMath::Perpendiculars(axes[2], axes[0], axes[1], 0.0);
      this->Fill(face, size, faces == 1 ? 1.7 : 1.0,
        [&](double a, double b)
        {
          const double along[3] = { axes[2][0] + a * axes[0][0] + b * axes[1][0],
            axes[2][1] + a * axes[0][1] + b * axes[1][1],
            axes[2][2] + a * axes[0][2] + b * axes[1][2] };
          return this->Look(along);
        });
    }
  }

  double Light[3];

  bool IsLit(const double place[3]) const override
  {
    double from[3];
    vtkMath::Subtract(place, this->Light, from);
    const double distance = vtkMath::Normalize(from);
    return distance < this->Grids.GetDistance(from);
  }

private:
  // The depth of what is first met along a vector from the lamp, whose third axis has length 1.
  double Look(const double along[3]) const
  {
    double least = 1e30;
    for (const Ball& ball : this->Balls)
    {
      double to[3];
      vtkMath::Subtract(ball.Center, this->Light, to);
      const double square = vtkMath::Dot(along, along);
      const double middle = vtkMath::Dot(along, to) / square;
      const double root =
        middle * middle - (vtkMath::Dot(to, to) - ball.Radius * ball.Radius) / square;
      if (root > 0.0 && middle - std::sqrt(root) > this->Grids.Range[0])
      {
        least = std::min(least, middle - std::sqrt(root));
      }
    }
    const double* range = this->Grids.Range;
    return std::min(1.0, (range[1] - range[0] * range[1] / least) / (range[1] - range[0]));
  }
};

// Ends of view rays: some near, some at nothing.
Picture MakeEnds(int width, int height)
{
  return MakePicture(width, height,
    [&](int x, int y)
    { return (x / 16 + y / 12) % 3 == 0 ? Walk::Sky : 4.0 + 0.05 * x + 0.02 * y; });
}

Picture Execute(Walk& walk, const Walk::Parameters& parameters, const Picture& ends)
{
  std::transform(ends.Values.begin(), ends.Values.end(), walk.PrepareInput(ends.Width, ends.Height),
    [](double end) { return static_cast<float>(end); });
  EXPECT_TRUE(walk.Execute(parameters));
  Picture picture(ends.Width, ends.Height, walk.GetNumberOfComponents());
  std::copy_n(walk.GetResult(), picture.Values.size(), picture.Values.begin());
  for (const double value : picture.Values)
  {
    EXPECT_TRUE(std::isfinite(value) && value >= 0.0);
  }
  return picture;
}

// The optical depths of a place in layers for an extinction of 1: of the ways to the eye and to the light.
double GetDepth(const Walk::Parameters& parameters, const double place[3], double alongEye,
  double rise, double alongLight)
{
  const vtkGodRaysMedium& medium = parameters.Medium;
  const double scale = medium.Components[0].ScaleHeight;
  const double height = medium.EyeHeight + vtkMath::Dot(medium.Up, place);
  const double eye = vtkGodRays::MediumDepth(0.0, height, -rise, scale, alongEye);
  const double up = vtkMath::Dot(medium.Up, parameters.Light);
  if (parameters.Light[3] != 0.0)
  {
    const double slope = (medium.EyeHeight + up - height) / alongLight;
    return eye + vtkGodRays::MediumDepth(0.0, height, slope, scale, alongLight);
  }
  return eye + vtkGodRays::MediumColumn(0.0, height, up, scale);
}

// The sum over so many steps of each ray, of the picture that is all lit.
Picture March(const Walk::Parameters& parameters, const Picture& ends, const Picture& lit,
  const Map& map, int steps)
{
  Picture picture(lit.Width, lit.Height, lit.Components);
  for (int y = 0; y < lit.Height; ++y)
  {
    for (int x = 0; x < lit.Width; ++x)
    {
      const bool parallel = parameters.Parallel;
      const double across[2] = { (x + 0.5 - parameters.Center[0]) * parameters.PixelSize,
        (y + 0.5 - parameters.Center[1]) * parameters.PixelSize };
      const double ray[3] = { parallel ? 0.0 : across[0], parallel ? 0.0 : across[1], 1.0 };
      const double length = vtkMath::Norm(ray);
      const double end = std::min(ends.Get(x, y), parameters.Medium.FarLimit);
      double sums[3] = {};
      double wholes[3] = {};
      for (int i = 0; i < steps; ++i)
      {
        const double z = (i + 0.5) / steps * end;
        const double place[3] = { across[0] * (parallel ? 1.0 : z),
          across[1] * (parallel ? 1.0 : z), z };
        const bool isLit = map.IsLit(place);
        double from[3];
        vtkMath::Subtract(place, parameters.Light, from);
        const bool isPoint = parameters.Light[3] != 0.0;
        const double distance = isPoint ? vtkMath::Norm(from) : 0.0;
        const double g = parameters.Medium.Components[0].Asymmetry;
        const double cosine = isPoint ? -vtkMath::Dot(from, ray) / (distance * length) : 0.0;
        const double scale = parameters.Medium.Components[0].ScaleHeight;
        double power =
          isPoint ? std::pow(1.0 + g * g - 2.0 * g * cosine, -1.5) / (distance * distance) : 1.0;
        double depth = z * length + distance;
        if (scale > 0.0)
        {
          const double* up = parameters.Medium.Up;
          power *= std::exp(-(parameters.Medium.EyeHeight + vtkMath::Dot(up, place)) / scale);
          depth = GetDepth(parameters, place, z * length, vtkMath::Dot(up, ray) / length, distance);
        }
        for (int c = 0; c < lit.Components; ++c)
        {
          const auto& component = parameters.Medium.Components[0];
          const double extinction = component.Scattering[c] + component.Absorption[c];
          const double weight = power * std::exp(-extinction * depth);
          wholes[c] += weight;
          sums[c] += isLit ? weight : 0.0;
        }
      }
      for (int c = 0; c < lit.Components; ++c)
      {
        picture.At(x, y, c) = lit.Get(x, y, c) * sums[c] / wholes[c];
      }
    }
  }
  return picture;
}

double GetRms(const Picture& a, const Picture& b)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    squares += std::pow(a.Values[i] - b.Values[i], 2);
  }
  return std::sqrt(squares / a.Values.size()) / b.GetMaximum();
}

// Walks a map, and compares with the march through it.
void Check(const std::string& name, Walk::Parameters parameters, const Map& map, int steps,
  double bound = 0.004)
{
  const Picture ends = MakeEnds(Width, Height);
  Walk walk;
  const Picture lit = Execute(walk, parameters, ends);
  parameters.Shadows = &map.Grids;
  const Picture swept = Execute(walk, parameters, ends);
  const Picture truth = March(parameters, ends, lit, map, steps);
  const double rms = GetRms(swept, truth);
  const double shadows = GetRms(lit, truth);
  std::cout << name << ": " << rms << ", without shadows " << shadows << "\n";
  EXPECT_LE(rms, bound) << name;
  EXPECT_GT(shadows, 3.0 * rms) << name;
}

void Check(const Direction& direction, int levels, const double scattering[3])
{
  const SunMap map(direction.Light, levels == 1 ? 512 : 256, levels);
  Walk::Parameters parameters = MakeParameters(Width, Height, direction.Light);
  std::copy_n(scattering, 3, parameters.Medium.Components[0].Scattering);
  Check(
    std::to_string(levels) + " level(s), " + direction.Name + ", " + std::to_string(scattering[0]),
    parameters, map, 600);
}

struct Lamp
{
  const char* Name;
  double Light[3];
  int Faces;
};

void Check(const Lamp& lamp, bool parallel)
{
  const LampMap map(lamp.Light, lamp.Faces == 6 ? 256 : 512, lamp.Faces);
  Walk::Parameters parameters = MakeParameters(Width, Height, Directions[0].Light);
  std::copy_n(lamp.Light, 3, parameters.Light);
  parameters.Light[3] = 1.0;
  if (parallel)
  {
    SetParallel(parameters);
  }
  Check(std::string(lamp.Name) + (parallel ? ", parallel" : ""), parameters, map, 2000);
}

// Among the balls, beside them, behind the eye, in the picture's plane; and far behind them, in one face.
const Lamp Lamps[] = { { "among", { 0.5, 0.6, 6.0 }, 6 }, { "aside", { 7.0, 1.0, 8.0 }, 6 },
  { "above", { 0.4, 6.0, 5.0 }, 6 }, { "behind", { 1.0, 1.2, -3.0 }, 6 },
  { "level", { -3.0, 0.5, 1e-7 }, 6 }, { "far", { 1.5, 2.0, 22.0 }, 1 },
  { "far aside", { 9.0, 2.0, 21.0 }, 1 } };
}

//------------------------------------------------------------------------------
// What is left are lines that are 2 pixels apart, and the march's steps.
TEST(InScattering, IsTheMapLookedUpEverywhere)
{
  for (const Direction& direction : Directions)
  {
    for (const double scattering : { 0.02, 0.1, 0.3 })
    {
      const double grey[3] = { scattering, scattering, scattering };
      Check(direction, 1, grey);
    }
  }
}

//------------------------------------------------------------------------------
TEST(InScattering, NestedMapsAndThreeColours)
{
  for (const Direction& direction : Directions)
  {
    const double colors[3] = { 0.02, 0.1, 0.3 };
    Check(direction, 4, colors);
  }
}

//------------------------------------------------------------------------------
TEST(InScattering, IsTheMapOfALampLookedUpEverywhere)
{
  for (const Lamp& lamp : Lamps)
  {
    Check(lamp, false);
  }
}

//------------------------------------------------------------------------------
// A pixel is as large as 2 of the map's: its one line is what is off.
TEST(InScattering, IsTheMapLookedUpEverywhereAlongParallelRays)
{
  for (const Direction& direction : Directions)
  {
    const SunMap map(direction.Light, 512, 1);
    Walk::Parameters parameters = MakeParameters(Width, Height, direction.Light);
    SetParallel(parameters);
    Check(std::string(direction.Name) + ", parallel", parameters, map, 600, 0.011);
  }
  const double along[3] = { 0.0, 0.0, 1.0 };
  const double against[3] = { 0.0, 0.0, -1.0 };
  for (const double* light : { along, against })
  {
    const SunMap map(light, 512, 1);
    Walk::Parameters parameters = MakeParameters(Width, Height, light);
    SetParallel(parameters);
    Check("along the rays, parallel", parameters, map, 600);
  }
  for (const Lamp& lamp : Lamps)
  {
    Check(lamp, true);
  }
}

//------------------------------------------------------------------------------
// Any size of picture, the light in a pixel's centre, along an axis, or nearly in the picture's plane.
TEST(InScattering, IsFiniteInDegenerateCases)
{
  const int sizes[][2] = { { 1, 1 }, { 3, 90 }, { 90, 2 }, { 81, 45 } };
  const double lights[][3] = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 },
    { 1, 1, 1e-12 }, { -1, 0.5, -1e-12 }, { 0.01, 0, 1 } };
  for (const auto& size : sizes)
  {
    const Picture ends = MakeEnds(size[0], size[1]);
    for (const auto& light : lights)
    {
      const SunMap map(light, 64, 4);
      Walk::Parameters parameters = MakeParameters(size[0], size[1], light);
      parameters.Shadows = &map.Grids;
      for (const double scattering : { 1e-9, 0.1, 1e4 })
      {
        std::fill_n(parameters.Medium.Components[0].Scattering, 3, scattering);
        Walk walk;
        Execute(walk, parameters, ends); // expects finite values
      }
      const LampMap lamp(light, 32, 6);
      parameters.Light[3] = 1.0;
      parameters.Shadows = &lamp.Grids;
      Walk walk;
      Execute(walk, parameters, ends);
      parameters.Parallel = true;
      Execute(walk, parameters, ends);
      std::fill_n(parameters.Light, 3, 0.0); // in the eye
      Execute(walk, parameters, ends);
      parameters.Parallel = false;
      Execute(walk, parameters, ends);
    }
  }
}

//------------------------------------------------------------------------------
// The pixel in whose centre the light is: all before the occluder's end is dark.
TEST(InScattering, ThePixelOfTheLight)
{
  const double light[3] = { 0.0, 0.0, 1.0 };
  const SunMap map(light, 127, 1); // the axis goes through a texel's centre
  Walk::Parameters parameters = MakeParameters(21, 11, light);
  const Picture ends = MakePicture(21, 11, [](int, int) { return Walk::Sky + 0.0; });
  Walk walk;
  const double lit = Execute(walk, parameters, ends).Get(10, 5);
  parameters.Shadows = &map.Grids;
  const double eye[3] = { 0.0, 0.0, 0.0 };
  const double end = std::max(0.0f, map.Grids.GetHeight(eye));
  const double far = parameters.Medium.FarLimit;
  const double share = (std::exp(-0.1 * end) - std::exp(-0.1 * far)) / (1.0 - std::exp(-0.1 * far));
  EXPECT_GT(end, 0.0);
  EXPECT_NEAR(Execute(walk, parameters, ends).Get(10, 5), lit * share, 1e-3 * lit);
}

//------------------------------------------------------------------------------
// Below a roof without end all is dark, whatever is between the steps of the ladder.
TEST(InScattering, AllDarkIsDark)
{
  const Picture ends = MakeEnds(Width, Height);
  const std::vector<float> roof(64 * 64, 0.0f);
  for (const Direction& direction : Directions)
  {
    Walk::Parameters parameters = MakeParameters(Width, Height, direction.Light);
    vtkGodRaysShadowGrids grids;
    parameters.Shadows = &grids;
    Walk walk;
    const double brightest = Execute(walk, parameters, ends).GetMaximum();
    vtkMath::Perpendiculars(parameters.Light, grids.Grids[0].Axes[0], grids.Grids[0].Axes[1], 0.3);
    grids.Levels = 1;
    grids.Range[0] = -1000.0;
    grids.Range[1] = 1000.0;
    grids.Grids[0].Depths = roof.data();
    grids.Grids[0].Stride = 64;
    for (int k = 0; k < 2; ++k)
    {
      grids.Grids[0].Size[k] = 64;
      grids.Grids[0].Low[k] = -40.0;
      grids.Grids[0].Texel[k] = 80.0 / 64.0;
    }
    const double left = Execute(walk, parameters, ends).GetMaximum();
    std::cout << direction.Name << ": left " << left / brightest << "\n";
    EXPECT_LT(left, 5e-4 * brightest) << direction.Name;
  }
}

//------------------------------------------------------------------------------
// Suns and lamps in a medium whose density falls with height, whose light is read from a table.
TEST(InScattering, LayersAreShadowed)
{
  const auto check = [](const std::string& name, Walk::Parameters parameters, const Map& map)
  {
    parameters.Medium.EyeHeight = 1.0;
    parameters.Medium.Components[0].ScaleHeight = 2.0;
    Check(name + ", layers", parameters, map, 300, 0.006);
    SetParallel(parameters);
    Check(name + ", layers, parallel", parameters, map, 300, 0.011);
  };
  for (const int index : { 0, 4 })
  {
    const Direction& direction = Directions[index];
    check(direction.Name, MakeParameters(Width, Height, direction.Light),
      SunMap(direction.Light, 512, 1));
  }
  for (const int index : { 1, 3 })
  {
    const Lamp& lamp = Lamps[index];
    Walk::Parameters parameters = MakeParameters(Width, Height, Directions[0].Light);
    std::copy_n(lamp.Light, 3, parameters.Light);
    parameters.Light[3] = 1.0;
    check(lamp.Name, parameters, LampMap(lamp.Light, 256, lamp.Faces));
  }
}

//------------------------------------------------------------------------------
TEST(InScattering, NeedsInput)
{
  Walk walk;
  EXPECT_FALSE(walk.Execute(MakeParameters(4, 4, Directions[0].Light)));
  EXPECT_EQ(walk.GetResult(), nullptr);
  EXPECT_EQ(walk.Describe(), "nothing yet");
}

//------------------------------------------------------------------------------
// A part of a picture is the picture's part, but for the places of lines.
TEST(InScattering, PartsOfAPicture)
{
  const Picture ends = MakeEnds(Width, Height);
  const SunMap map(Directions[0].Light, 512, 1);
  Walk::Parameters parameters = MakeParameters(Width, Height, Directions[0].Light);
  parameters.Shadows = &map.Grids;
  Walk walk;
  const Picture whole = Execute(walk, parameters, ends);
  const int left = 30;
  const int low = 20;
  const auto crop = [&](const Picture& picture)
  {
    return MakePicture(Width - left - 10, Height - low - 10,
      [&](int x, int y) { return picture.Get(x + left, y + low); });
  };
  parameters.Center[0] -= left;
  parameters.Center[1] -= low;
  const double rms = GetRms(Execute(walk, parameters, crop(ends)), crop(whole));
  parameters.Center[0] += 8.0;
  const double aside = GetRms(Execute(walk, parameters, crop(ends)), crop(whole));
  std::cout << "rms difference " << rms << ", 8 pixels aside " << aside << "\n";
  EXPECT_LE(rms, 2e-3);
  EXPECT_GT(aside, 10.0 * rms);
}

//------------------------------------------------------------------------------
// The threads of vtkSMPTools need memory of their own: one alone is counted. Others change no byte.
TEST(InScattering, SteadyExecutionAllocatesNothing)
{
  const Picture ends = MakeEnds(120, 80);
  const SunMap sun(Directions[0].Light, 128, 4);
  const LampMap lamp(Lamps[0].Light, 64, 6);
  for (const bool point : { false, true })
  {
    for (const double scaleHeight : { 0.0, 2.0 })
    {
      Walk::Parameters parameters = MakeParameters(120, 80, Directions[0].Light);
      std::copy_n(point ? lamp.Light : sun.Light, 3, parameters.Light);
      parameters.Light[3] = point;
      parameters.Shadows = point ? &lamp.Grids : &sun.Grids;
      parameters.Medium.Components[0].ScaleHeight = scaleHeight;
      Picture alone;
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
        [&]()
        {
          Walk walk;
          alone = Execute(walk, parameters, ends);
          EXPECT_EQ(CountAllocations([&]() { walk.Execute(parameters); }), 0) << walk.Describe();
          EXPECT_EQ(GetLargestDifference(Execute(walk, parameters, ends), alone), 0.0);
        });
      Walk walk;
      EXPECT_EQ(GetLargestDifference(Execute(walk, parameters, ends), alone), 0.0);
    }
  }
}

//------------------------------------------------------------------------------
// Of the 99.9 % brightness; each tolerance is kept, and a looser one walks fewer rays.
TEST(InScattering, ToleranceSpends)
{
  const Picture ends = MakeEnds(4 * Width, 4 * Height);
  const SunMap sun(Directions[0].Light, 256, 4);
  const LampMap lamp(Lamps[3].Light, 256, 6);
  for (const bool point : { false, true })
  {
    Walk::Parameters parameters = MakeParameters(4 * Width, 4 * Height, Directions[0].Light);
    std::copy_n(point ? lamp.Light : sun.Light, 3, parameters.Light);
    parameters.Light[3] = point;
    parameters.Shadows = point ? &lamp.Grids : &sun.Grids;
    parameters.Tolerance = 1e-6;
    Walk walk;
    const Picture exact = Execute(walk, parameters, ends);
    std::vector<double> values = exact.Values;
    const auto bright = values.begin() + static_cast<std::ptrdiff_t>(0.999 * values.size());
    std::nth_element(values.begin(), bright, values.end());
    double last = walk.GetWalkedPart();
    for (const double tolerance : { 1.0 / 1024.0, 1.0 / 255.0, 1.0 / 64.0, 1.0 / 16.0 })
    {
      parameters.Tolerance = tolerance;
      const double rms =
        GetRms(Execute(walk, parameters, ends), exact) * exact.GetMaximum() / *bright;
      std::cout << (point ? "lamp" : "sun") << ", tolerance 1/" << 1.0 / tolerance << ": " << rms
                << ", walked " << walk.GetWalkedPart() << " of " << last << "\n";
      EXPECT_LE(rms, tolerance);
      EXPECT_LT(walk.GetWalkedPart(), last);
      last = walk.GetWalkedPart();
    }
  }
}
