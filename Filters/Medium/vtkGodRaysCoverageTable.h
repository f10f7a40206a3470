// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysCoverageTable.h
 * @brief   fills the tables of airlight that vtkGodRaysCoverageKernels reads
 *
 * Private. Rows, columns and slices are so dense that what is read differs from the integral by less than
 * 2e-3 of the largest in the picture; see Documentation/Accuracy.md.
 */

#ifndef vtkGodRaysCoverageTable_h
#define vtkGodRaysCoverageTable_h

struct vtkGodRaysMedium;

namespace vtkGodRays
{
struct CoverageImage;
struct CoverageSettings;
struct CoverageTable;

/// The table of a point light, or of a directional light in a medium of exponential density, for the view
/// rays of a picture. Plane c is of colour c, or, of a directional light, k Channels + c of component k.
void MakeCoverageTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table);
}

#endif
