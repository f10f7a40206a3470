// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysCoveragePhase.h
 * @brief   tables of phase functions for the coverage sweep
 *
 * Private.
 */

#ifndef vtkGodRaysCoveragePhase_h
#define vtkGodRaysCoveragePhase_h

#include "vtkGodRaysCoverageKernels.h" // For CoveragePhase
#include "vtkGodRaysMedium.h"

#include <array>

namespace vtkGodRays
{
/// What of a component decides the shape of its phase function.
std::array<double, 5> GetCoveragePhaseKey(const vtkGodRaysMedium::Component& component);

/// As fine as the component's peak needs.
void MakeCoveragePhase(const vtkGodRaysMedium::Component& component, CoveragePhase& table);
}

#endif
