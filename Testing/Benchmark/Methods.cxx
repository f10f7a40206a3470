// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysTapsIntegrator.h"

const char* const CustomaryMethod = "taps 100";
const char* const ControlMethod = "taps 16";
const char* const ProcessorMethod = "epipolar, processor, 1/255";
const char* const GraphicsMethod = "epipolar, graphics, 1/255";

namespace
{
using Integrator = vtkSmartPointer<vtkGodRaysRadialIntegrator>;

Integrator MakeTaps(int taps)
{
  auto integrator = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  integrator->SetNumberOfTaps(taps);
  return integrator;
}

Integrator MakeJittered(int taps)
{
  auto integrator = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  integrator->SetNumberOfTaps(taps);
  integrator->JitterOn();
  return integrator;
}

Integrator MakeHierarchical(int taps, int passes)
{
  auto integrator = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  integrator->SetNumberOfTaps(taps);
  integrator->SetNumberOfPasses(passes);
  return integrator;
}

Integrator MakeEpipolar(int backend)
{
  auto integrator = vtkSmartPointer<vtkGodRaysEpipolarIntegrator>::New();
  integrator->SetBackend(backend);
  return integrator;
}
}

//------------------------------------------------------------------------------
std::vector<Method> MakeMethods()
{
  const double level = 1.0 / 255.0;
  std::vector<Method> methods = {
    { "taps 16", "taps", "16", MakeTaps(16) },
    { "taps 32", "taps", "32", MakeTaps(32) },
    { "taps 64", "taps", "64", MakeTaps(64) },
    { "taps 100", "taps", "100", MakeTaps(100) },
    { "taps 256", "taps", "256", MakeTaps(256), level, Method::SLOW },
    { "taps 1024", "taps", "1024", MakeTaps(1024), level, Method::SLOWEST },
    { "taps 16, jittered", "taps, jittered", "16", MakeJittered(16) },
    { "taps 32, jittered", "taps, jittered", "32", MakeJittered(32) },
    { "taps 3 x 6", "taps, three passes", "3 x 6", MakeHierarchical(216, 3) },
  };
  using Epipolar = vtkGodRaysEpipolarIntegrator;
  const struct
  {
    const char* Name;
    double Value;
    int Pace;
  } tolerances[] = { { "1e-2", 1e-2, Method::STEADY }, { "1/255", level, Method::STEADY },
    { "1e-3", 1e-3, Method::SLOW }, { "1e-4", 1e-4, Method::SLOWEST } };
  for (const auto& tolerance : tolerances)
  {
    const std::string name = tolerance.Name;
    methods.push_back({ "epipolar, processor, " + name, "epipolar, processor", name,
      MakeEpipolar(Epipolar::PROCESSOR), tolerance.Value, tolerance.Pace });
    methods.push_back({ "epipolar, graphics, " + name, "epipolar, graphics", name,
      MakeEpipolar(Epipolar::GRAPHICS), tolerance.Value, tolerance.Pace });
  }
  return methods;
}
