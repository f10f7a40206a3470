// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPlanetTable.h
 * @brief   fills the table of a directional light's airlight over a planet
 *
 * Private; see vtkGodRaysCoverageTable.h. A view ray is told from others by its slope and its angle to
 * the light, or, if rays are parallel, by the least height of its line and how near to the light it
 * begins. The table holds the light as if the planet cast no shadow: below the horizon it is dimmed by
 * the air that would be in the ground's place, so that it is smooth. Kernels know where the shadow begins
 * and ends.
 */

#ifndef vtkGodRaysPlanetTable_h
#define vtkGodRaysPlanetTable_h

struct vtkGodRaysMedium;

namespace vtkGodRays
{
struct CoverageImage;
struct CoverageSettings;
struct CoverageTable;

/// How far the eye is from the planet's centre.
double GetEyeRadius(const CoverageSettings& settings);

/// What kernels need to know of the planet's ground; returns 1 - Globe::Ground^2.
double SetGlobe(const CoverageSettings& settings, CoverageTable& table);

/// As MakeCoverageTable() has it.
void MakePlanetTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table);
}

#endif
