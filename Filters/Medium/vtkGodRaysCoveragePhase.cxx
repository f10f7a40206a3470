// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoveragePhase.h"

#include "vtkGodRaysMath.h"

#include <algorithm>
#include <cmath>

namespace vtkGodRays
{
using Component = vtkGodRaysMedium::Component;

namespace
{
double GetPhase(const Component& component, double cosAngle)
{
  return PhaseMix({ component.PhaseFunction, component.Asymmetry },
    { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight, cosAngle);
}
}

// What of a component decides the shape of its phase function.
std::array<double, 5> GetCoveragePhaseKey(const Component& component)
{
  return { static_cast<double>(component.PhaseFunction), component.Asymmetry,
    static_cast<double>(component.SecondPhaseFunction), component.SecondAsymmetry,
    component.SecondWeight };
}

void MakeCoveragePhase(const Component& component, CoveragePhase& table)
{
  const auto sharpness = [](int kind, double asymmetry)
  { return PhaseHasAsymmetry(kind) ? 1.0 - std::abs(asymmetry) : 1.0; };
  const double least = std::min(sharpness(component.PhaseFunction, component.Asymmetry),
    component.SecondWeight > 0.0
      ? sharpness(component.SecondPhaseFunction, component.SecondAsymmetry)
      : 1.0);
  int half = 768;
  while (half * least < 640.0)
  {
    half *= 2;
  }
  table.resize(2 * half + 1);
  for (int i = 0; i <= half; ++i)
  {
    const double chord = i / static_cast<double>(half);
    const double cosine = 1.0 - chord * chord;
    table[i] = static_cast<float>(GetPhase(component, cosine));
    table[2 * half - i] = static_cast<float>(GetPhase(component, -cosine));
  }
}
}
