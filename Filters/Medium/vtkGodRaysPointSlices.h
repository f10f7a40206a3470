// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPointSlices.h
 * @brief   about which axes the slices of a point light's table lie
 *
 * Private; see vtkGodRaysPointTable.h.
 */

#ifndef vtkGodRaysPointSlices_h
#define vtkGodRaysPointSlices_h

struct vtkGodRaysMedium;

namespace vtkGodRays
{
struct CoverageImage;
struct CoverageSettings;

/// Set SliceAxis, SliceSide and Around; all else of the settings is there. layered: whether the medium is.
void SetSliceAxes(const CoverageImage& image, const vtkGodRaysMedium& medium, bool layered,
  CoverageSettings& settings);
}

#endif
