// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPointTable.h
 * @brief   fills the table of a point light's airlight
 *
 * Private; see vtkGodRaysCoverageTable.h. A view ray is told from others by its angle to the light, or, if
 * rays are parallel, by its distance from it; in layers, and of spotlights that fade, also by where it lies
 * about the light: of that there are as many slices as the picture's own rays need.
 */

#ifndef vtkGodRaysPointTable_h
#define vtkGodRaysPointTable_h

struct vtkGodRaysMedium;

namespace vtkGodRays
{
struct CoverageImage;
struct CoverageSettings;
struct CoverageTable;

/// As MakeCoverageTable() has it.
void MakePointTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table);

/// How far a row's rays pass the light.
double GetPointHeight(const CoverageSettings& settings, const CoverageTable& table, int row);
}

#endif
