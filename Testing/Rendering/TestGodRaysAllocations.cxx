// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What a steady frame allocates by vtkGodRays: words of its plan, and nothing else.

#include "GodRaysTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <cstdlib>
#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <new>

using namespace GodRaysTesting;

namespace
{
// Stacks are written down, not looked up, while it counts: looking up allocates.
constexpr int Depth = 24;
constexpr int MostStacks = 16384;
void* Stacks[MostStacks][Depth];
std::atomic<int> NumberOfStacks{ 0 };
std::atomic<bool> Counts{ false };
thread_local bool IsInside = false;

void CountAllocation()
{
  if (Counts.load(std::memory_order_relaxed) && !IsInside)
  {
    IsInside = true;
    const int i = NumberOfStacks.fetch_add(1, std::memory_order_relaxed);
    if (i < MostStacks)
    {
      backtrace(Stacks[i], Depth);
    }
    IsInside = false;
  }
}
}

// These symbols of the program come before those of the libraries.
extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* memory, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void __libc_free(void* memory);

  void* malloc(std::size_t size)
  {
    CountAllocation();
    return __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    CountAllocation();
    return __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    CountAllocation();
    return __libc_realloc(memory, size);
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    CountAllocation();
    return __libc_memalign(alignment, size);
  }
}

void* operator new(std::size_t size)
{
  CountAllocation();
  if (void* memory = __libc_malloc(size ? size : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
  __libc_free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  __libc_free(memory);
}

namespace
{
std::string Demangle(const char* symbol)
{
  int status = 1;
  char* readable = symbol ? abi::__cxa_demangle(symbol, nullptr, nullptr, &status) : nullptr;
  const std::string name = status == 0 ? readable : "a local function";
  std::free(readable);
  return name;
}

/// The function of vtkGodRays that asked for this memory itself; empty if it is none. Words are asked for by
/// the C++ library. What of that is a template may be in any library, for all others: its caller counts.
std::string FindAllocator(void* const* stack)
{
  Dl_info program = {};
  dladdr(reinterpret_cast<void*>(&CountAllocation), &program);
  for (int i = 0; i < Depth && stack[i]; ++i)
  {
    Dl_info info = {};
    // After functions of this file, which come before the C library's.
    if (!dladdr(stack[i], &info) || !info.dli_fname || info.dli_fbase == program.dli_fbase)
    {
      continue;
    }
    if (std::string(info.dli_fname).find("libvtkGodRays") == std::string::npos)
    {
      return "";
    }
    const std::string name = Demangle(info.dli_sname);
    if (name.find("std::") != 0 && name.find("void std::") != 0)
    {
      return name;
    }
  }
  return "";
}

using Arrange = std::function<void(Stage&)>;

struct Kind
{
  const char* Name;
  Arrange Prepare;
  int Allowed = 0;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

template <class Integrator>
Integrator* SetMedium(Stage& scene)
{
  scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
  vtkNew<Integrator> integrator;
  scene.Rays->SetIntegrator(integrator);
  return integrator;
}

/// Whose opacity is looked up.
void AddTranslucentData(Stage& scene)
{
  auto glass = MakeBox({ 0.0, 0.0, 2.0 }, { 2.0, 2.0, 0.2 });
  glass->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(glass);
  scene.Renderer->GradientBackgroundOn();
  scene.Rays->AutomaticExposureOn();
}

/// Lights with a table of airlight each, that stand still.
void AddLampsInAnAtmosphere(Stage& scene, int number)
{
  scene.Rays->RemoveAllLights();
  for (int i = 0; i < number; ++i)
  {
    scene.Rays->AddLight(MakeLamplight({ 1.2 * i - 3.0, 0.5, 2.0 }));
  }
  vtkNew<vtkGodRaysAtmosphereModel> air;
  air->SetWorldUnitInMeters(1000.0);
  scene.Rays->SetModel(air);
}

const Kind Kinds[] = {
  { "Look", [](Stage&) {} },
  { "LookInShaders",
    [](Stage& scene)
    {
      auto integrator = vtkGodRaysEpipolarIntegrator::SafeDownCast(scene.Rays->GetIntegrator());
      integrator->SetBackend(vtkGodRaysEpipolarIntegrator::GRAPHICS);
    } },
  { "Taps", [](Stage& scene) { SumTaps(scene.Rays); }, 2 }, // lists of its passes: drawn, told
  { "Margin", [](Stage& scene) { scene.Rays->SetLayerMargin(0.25); } },
  { "Exposure",
    [](Stage& scene)
    {
      scene.Rays->AutomaticExposureOn();
      scene.Rays->DarkenLightBackgroundOn();
      scene.Renderer->SetBackground(1.0, 1.0, 1.0);
    } },
  { "TranslucentDataBeforeAGradient", [](Stage& scene) { AddTranslucentData(scene); } },
  { "TranslucentDataInAMediumBeforeAGradient",
    [](Stage& scene)
    {
      AddTranslucentData(scene);
      scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
    } },
  { "Medium", [](Stage& scene) { scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>()); } },
  { "Atmosphere", [](Stage& scene) { scene.Rays->SetModel(vtkNew<vtkGodRaysAtmosphereModel>()); } },
  { "ShadowMap",
    [](Stage& scene) { SetMedium<vtkGodRaysShadowMapIntegrator>(scene)->SetMapSize(128); } },
  { "ShadowMapInShaders",
    [](Stage& scene) {
      SetMedium<vtkGodRaysShadowMapIntegrator>(scene)->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
    } },
  { "TwoLampsInAnAtmosphere", [](Stage& scene) { AddLampsInAnAtmosphere(scene, 2); } },
  { "FiveLampsInAnAtmosphere", [](Stage& scene) { AddLampsInAnAtmosphere(scene, 5); } },
};

class GodRaysAllocations : public ::testing::TestWithParam<Kind>
{
};
}

TEST_P(GodRaysAllocations, OfASteadyFrameAreWords)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  GetParam().Prepare(scene);
  for (int i = 0; i < 4; ++i)
  {
    scene.Window->Render();
  }
  void* first[Depth];
  backtrace(first, Depth); // it allocates when it is called first
  NumberOfStacks = 0;
  for (auto& stack : Stacks)
  {
    std::fill(std::begin(stack), std::end(stack), nullptr);
  }
  Counts = true;
  scene.Window->Render();
  Counts = false;
  std::map<std::string, int> ours;
  const int number = NumberOfStacks;
  ASSERT_LT(number, MostStacks);
  ASSERT_GT(number, 0) << "VTK allocates in each frame: nothing is counted";
  for (int i = 0; i < number; ++i)
  {
    const std::string name = FindAllocator(Stacks[i]);
    if (!name.empty() && name.find("::Describe[") == std::string::npos)
    {
      ++ours[name];
    }
  }
  std::ostringstream text;
  int sum = 0;
  for (const auto& each : ours)
  {
    text << "\n" << each.second << " by " << each.first;
    sum += each.second;
  }
  EXPECT_LE(sum, GetParam().Allowed) << text.str();
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysAllocations, ::testing::ValuesIn(Kinds),
  [](const ::testing::TestParamInfo<Kind>& info) { return info.param.Name; });
#endif
