// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPhaseTable.h
 * @brief   tables of phase functions
 *
 * Private. Linear between entries: the first half is over sin(a/2), a being the scattering angle, from 0 to
 * sin(45 degrees), the second over cos(a/2) back to 0.
 */

#ifndef vtkGodRaysPhaseTable_h
#define vtkGodRaysPhaseTable_h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vtkGodRays
{
/// Makes the table of a component, as fine as its peak needs.
inline void MakePhaseTable(const vtkGodRaysMedium::Component& component, std::vector<float>& table)
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
  table.resize(2 * static_cast<std::size_t>(half) + 1);
  for (int i = 0; i <= half; ++i)
  {
    const double sine = i / static_cast<double>(half) * std::sqrt(0.5);
    const double cosine = 1.0 - 2.0 * sine * sine;
    const auto phase = [&](double cosAngle)
    {
      return static_cast<float>(PhaseMix({ component.PhaseFunction, component.Asymmetry },
        { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight,
        cosAngle));
    };
    table[i] = phase(cosine);
    table[2 * static_cast<std::size_t>(half) - i] = phase(-cosine);
  }
}

/// The phase function of an angle, of which half the sine and cosine are given.
inline float LookUpPhase(const std::vector<float>& table, float sine, float cosine)
{
  const float scale =
    0.70710678f * static_cast<float>(table.size() - 1); // half the entries for each half
  const float at =
    sine < cosine ? sine * scale : static_cast<float>(table.size() - 1) - cosine * scale;
  const std::size_t i = std::min(static_cast<std::size_t>(at), table.size() - 2);
  const float f = at - static_cast<float>(i);
  return table[i] + f * (table[i + 1] - table[i]);
}
}

#endif
