// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sweep as a client without a pipeline uses it.

#include "GodRaysFiltersTesting.h"

#include "vtkGodRaysRadialSweep.h"
#include "vtkGodRaysScatteringFilter.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <random>
#include <string>
#include <vector>

using namespace GodRaysFiltersTesting;

//------------------------------------------------------------------------------
// Every allocation of the process, this library's included.
namespace
{
std::atomic<bool> CountsAllocations{ false };
std::atomic<int> Allocations{ 0 };

void* Allocate(std::size_t size)
{
  if (CountsAllocations)
  {
    ++Allocations;
  }
  if (void* memory = std::malloc(std::max<std::size_t>(size, 1)))
  {
    return memory;
  }
  throw std::bad_alloc();
}
}

void* operator new(std::size_t size)
{
  return Allocate(size);
}
void* operator new[](std::size_t size)
{
  return Allocate(size);
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

int GodRaysFiltersTesting::CountAllocations(const std::function<void()>& function)
{
  Allocations = 0;
  CountsAllocations = true;
  function();
  CountsAllocations = false;
  return Allocations;
}

namespace
{
using Sweep = vtkGodRaysRadialSweep;

// Writes a picture where the sweep wants it.
void Fill(Sweep& sweep, const Picture& picture)
{
  const Sweep::Planes planes =
    sweep.PrepareInput(picture.Width, picture.Height, picture.Components);
  for (int c = 0; c < picture.Components; ++c)
  {
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        planes.Values[c][y * planes.Stride + x] = static_cast<float>(picture.Get(x, y, c));
      }
    }
  }
}

Picture Read(const Sweep& sweep, int width, int height, int components)
{
  Picture picture(width, height, components);
  for (int c = 0; c < components; ++c)
  {
    for (int i = 0; i < width * height; ++i)
    {
      picture.Values[static_cast<std::size_t>(i) * components + c] = sweep.GetResult(c)[i];
    }
  }
  return picture;
}

Picture Filter(const Sweep::Parameters& parameters, const Picture& picture)
{
  vtkNew<vtkGodRaysScatteringFilter> filter;
  filter->SetDensity(parameters.Density);
  filter->SetDecay(parameters.Decay);
  filter->SetWeight(parameters.Weight);
  filter->SetExposure(parameters.Exposure);
  filter->SetNumberOfSamples(parameters.NumberOfSamples);
  filter->SetLightClip(parameters.LightClip);
  filter->SetMarchScale(parameters.MarchScale);
  filter->SetErrorTolerance(parameters.ErrorTolerance);
  filter->SetMethod(parameters.Method);
  return Scatter(filter, picture, VTK_FLOAT);
}
}

//------------------------------------------------------------------------------
// One object, from one size, number of components and set of parameters to the next.
TEST(GodRaysRadialSweep, DoesWhatTheFilterDoes)
{
  std::mt19937 generator = MakeGenerator(31);
  Sweep sweep;
  EXPECT_EQ(sweep.GetResult(0), nullptr);
  EXPECT_FALSE(sweep.Execute(Sweep::Parameters()));
  EXPECT_EQ(sweep.Describe(), "nothing has been computed");
  const int sizes[][3] = { { 200, 150, 1 }, { 200, 150, 3 }, { 150, 200, 2 }, { 40, 33, 4 },
    { 1, 1, 1 }, { 333, 77, 1 } };
  for (const auto& size : sizes)
  {
    const Picture picture = MakeNoise(size[0], size[1], size[2], generator);
    for (const int method : { Sweep::AUTOMATIC, Sweep::TAPS })
    {
      Sweep::Parameters parameters;
      parameters.Method = method;
      parameters.Density = 0.7;
      parameters.Decay = 0.99;
      parameters.LightClip[0] = 0.3;
      Fill(sweep, picture);
      ASSERT_TRUE(sweep.Execute(parameters));
      EXPECT_EQ(Read(sweep, size[0], size[1], size[2]).Values, Filter(parameters, picture).Values)
        << sweep.Describe();
      parameters.LightClip[1] = -1.9;
      ASSERT_TRUE(sweep.Execute(parameters));
      EXPECT_EQ(Read(sweep, size[0], size[1], size[2]).Values, Filter(parameters, picture).Values)
        << sweep.Describe();
    }
  }
}

//------------------------------------------------------------------------------
// The largest half-float, everywhere and summed with a factor: nothing overflows.
TEST(GodRaysRadialSweep, LargestValues)
{
  const Picture picture = MakePicture(300, 200, [](int, int) { return 65504.0; });
  Sweep sweep;
  Sweep::Parameters parameters;
  parameters.Decay = 1.0;
  parameters.Weight = 0.01;
  Fill(sweep, picture);
  ASSERT_TRUE(sweep.Execute(parameters));
  for (const double value : Read(sweep, 300, 200, 1).Values)
  {
    ASSERT_NEAR(value, 65504.0, 65504.0 * parameters.ErrorTolerance);
  }
}

//------------------------------------------------------------------------------
// The threads of vtkSMPTools need memory of their own: without them here.
TEST(GodRaysRadialSweep, SteadyExecutionAllocatesNothing)
{
  std::mt19937 generator = MakeGenerator(32);
  const Picture picture = MakeNoise(320, 200, 3, generator);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]()
    {
      for (const double density : { 1.0, 0.5, 1.5 })
      {
        Sweep sweep;
        Sweep::Parameters parameters;
        parameters.Density = density;
        Fill(sweep, picture);
        sweep.Execute(parameters);
        const Picture first = Read(sweep, 320, 200, 3);
        const int allocations = CountAllocations(
          [&]()
          {
            sweep.PrepareInput(320, 200, 3);
            sweep.Execute(parameters);
          });
        EXPECT_EQ(allocations, 0) << sweep.Describe();
        EXPECT_EQ(Read(sweep, 320, 200, 3).Values, first.Values);
      }
    });
  // And they are counted at all.
  EXPECT_GT(CountAllocations([]() { Sweep().PrepareInput(10, 10, 1); }), 1);
}

//------------------------------------------------------------------------------
TEST(GodRaysRadialSweep, WritesWhereItIsTold)
{
  std::mt19937 generator = MakeGenerator(33);
  const Picture picture = MakeNoise(120, 90, 2, generator);
  Sweep sweep;
  Fill(sweep, picture);
  sweep.Execute(Sweep::Parameters());
  const Picture expected = Read(sweep, 120, 90, 2);
  std::vector<float> place(120 * 90, -1.0f);
  sweep.SetResult(1, place.data());
  sweep.Execute(Sweep::Parameters());
  EXPECT_EQ(sweep.GetResult(1), place.data());
  EXPECT_NE(sweep.GetResult(0), place.data());
  EXPECT_EQ(Read(sweep, 120, 90, 2).Values, expected.Values);
  sweep.SetResult(1, nullptr);
  sweep.Execute(Sweep::Parameters());
  EXPECT_NE(sweep.GetResult(1), place.data());
  EXPECT_EQ(Read(sweep, 120, 90, 2).Values, expected.Values);
}

//------------------------------------------------------------------------------
TEST(GodRaysRadialSweep, MonitorIsToldAndStops)
{
  std::mt19937 generator = MakeGenerator(34);
  for (const double density : { 0.9, 1.5 }) // lines are swept, taps are summed
  {
    const Picture picture = MakeNoise(density < 1.0 ? 1200 : 120, 80, 1, generator);
    Sweep sweep;
    Fill(sweep, picture);
    Sweep::Parameters parameters;
    parameters.Density = density;
    std::vector<double> told;
    auto tell = [&told](double progress)
    {
      told.push_back(progress);
      return progress < 0.5;
    };
    EXPECT_FALSE(sweep.Execute(parameters, tell, 10));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.front(), 0.0);
    EXPECT_GE(told.size(), 4u);
    EXPECT_LE(told.back(), 0.65);
    EXPECT_TRUE(sweep.Execute(
      parameters, [](double) { return true; }, 10));
    const Picture stepped = Read(sweep, picture.Width, picture.Height, 1);
    EXPECT_TRUE(sweep.Execute(parameters));
    EXPECT_EQ(Read(sweep, picture.Width, picture.Height, 1).Values, stepped.Values);
  }
}
