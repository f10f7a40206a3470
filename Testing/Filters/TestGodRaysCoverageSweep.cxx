// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sweep of shadows in a medium as a client without a pipeline uses it.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysCoverageFilter.h"
#include "vtkGodRaysCoverageSweep.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

using namespace GodRaysFiltersTesting;

namespace
{
using Sweep = vtkGodRaysCoverageSweep;

constexpr double sky = Sweep::Sky;

// The filter's defaults, with a light in the picture.
Sweep::Parameters MakeParameters(int width, int height)
{
  Sweep::Parameters parameters;
  parameters.PixelSize = 2.0 / height * std::tan(vtkMath::RadiansFromDegrees(15.0));
  parameters.Center[0] = 0.5 * width;
  parameters.Center[1] = 0.5 * height;
  const double light[4] = { 0.1, 0.15, 1.0, 0.0 };
  std::copy_n(light, 4, parameters.Light);
  vtkGodRaysMedium::Component& component = parameters.Medium.Components[0];
  std::fill_n(component.Scattering, 3, 0.05);
  component.PhaseFunction = vtkGodRaysMediumFilter::HENYEY_GREENSTEIN;
  component.Asymmetry = 0.6;
  return parameters;
}

// Balls before the sky.
Picture MakeDepths(int width, int height)
{
  return MakePicture(width, height,
    [&](int x, int y)
    {
      const double radius = std::hypot(x % 40 - 19.3, y % 30 - 14.7);
      return radius < 9.0 ? 5.0 + x / 40 + 0.02 * radius * radius : sky;
    });
}

Picture Execute(Sweep& sweep, const Sweep::Parameters& parameters, const Picture& depths)
{
  const Sweep::Planes planes = sweep.PrepareInput(depths.Width, depths.Height, depths.Components);
  for (int c = 0; c < depths.Components; ++c)
  {
    for (int y = 0; y < depths.Height; ++y)
    {
      for (int x = 0; x < depths.Width; ++x)
      {
        planes.Values[c][y * planes.Stride + x] = static_cast<float>(depths.Get(x, y, c));
      }
    }
  }
  EXPECT_TRUE(sweep.Execute(parameters));
  Picture picture(depths.Width, depths.Height, sweep.GetNumberOfComponents());
  std::copy_n(sweep.GetResult(), picture.Values.size(), picture.Values.begin());
  EXPECT_LE(picture.GetMaximum(), sweep.GetBound());
  return picture;
}
}

//------------------------------------------------------------------------------
TEST(CoverageSweep, IsTheFilter)
{
  const Picture depths = MakeDepths(150, 100);
  Sweep::Parameters parameters = MakeParameters(150, 100);
  Sweep sweep;
  vtkNew<vtkGodRaysCoverageFilter> filter;
  filter->SetLight(0.1, 0.15, -1.0, 0.0);
  EXPECT_EQ(GetLargestDifference(Scatter(filter, depths), Execute(sweep, parameters, depths)), 0.0);
  parameters.LightColor[1] = 2.0;
  filter->SetLightColor(1.0, 2.0, 1.0);
  const Picture colored = Execute(sweep, parameters, depths);
  EXPECT_EQ(colored.Components, 3);
  EXPECT_EQ(GetLargestDifference(Scatter(filter, depths), colored), 0.0);
  EXPECT_FALSE(sweep.Describe().empty());
}

//------------------------------------------------------------------------------
TEST(CoverageSweep, SaysWhatItLacks)
{
  Sweep sweep;
  const Sweep::Parameters parameters = MakeParameters(4, 4);
  EXPECT_FALSE(sweep.Execute(parameters));
  EXPECT_EQ(sweep.GetResult(), nullptr);
  sweep.PrepareInput(4, 4, 4);
  EXPECT_FALSE(sweep.Execute(parameters)); // no layers, but four planes
}

//------------------------------------------------------------------------------
// A part of a picture is the picture's part, where nothing outside of it casts shadows into it.
TEST(CoverageSweep, PartsOfAPicture)
{
  const int width = 160;
  const int height = 90;
  Picture depths(width, height);
  std::fill(depths.Values.begin(), depths.Values.end(), sky);
  for (int y = 40; y < 50; ++y)
  {
    for (int x = 60; x < 90; ++x)
    {
      depths.At(x, y) = 4.0 + 0.1 * x;
    }
  }
  Sweep sweep;
  Sweep::Parameters parameters = MakeParameters(width, height);
  const Picture whole = Execute(sweep, parameters, depths);
  const int left = 30;
  const int low = 20;
  Picture part(width - left - 10, height - low - 10);
  for (int y = 0; y < part.Height; ++y)
  {
    for (int x = 0; x < part.Width; ++x)
    {
      part.At(x, y) = depths.Get(x + left, y + low);
    }
  }
  parameters.Center[0] -= left;
  parameters.Center[1] -= low;
  const Picture result = Execute(sweep, parameters, part);
  double squares = 0.0;
  for (int y = 0; y < part.Height; ++y)
  {
    for (int x = 0; x < part.Width; ++x)
    {
      squares += std::pow(result.Get(x, y) - whole.Get(x + left, y + low), 2);
    }
  }
  // Lines lie elsewhere by parts of their distance, at the edges of the shadow.
  const double rms = std::sqrt(squares / part.Values.size()) / whole.GetMaximum();
  std::cout << "rms difference " << rms << "\n";
  EXPECT_LE(rms, 2e-3);
  parameters.Center[0] += 8.0;
  EXPECT_GT(GetLargestDifference(Execute(sweep, parameters, part), result), 0.0);
}

//------------------------------------------------------------------------------
// The threads of vtkSMPTools need memory of their own: without them here.
TEST(CoverageSweep, SteadyExecutionAllocatesNothing)
{
  const Picture depths = MakeDepths(120, 80);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]()
    {
      for (const double w : { 0.0, 1.0 })
      {
        for (const double scaleHeight : { 0.0, w == 0.0 ? 2.0 : 0.0 })
        {
          Sweep sweep;
          Sweep::Parameters parameters = MakeParameters(120, 80);
          parameters.Light[3] = w;
          parameters.Medium.Components[0].ScaleHeight = scaleHeight;
          const Picture first = Execute(sweep, parameters, depths);
          const int allocations = CountAllocations(
            [&]()
            {
              sweep.PrepareInput(120, 80, 1);
              sweep.Execute(parameters);
            });
          EXPECT_EQ(allocations, 0) << sweep.Describe();
          EXPECT_EQ(GetLargestDifference(Execute(sweep, parameters, depths), first), 0.0);
        }
      }
    });
}
