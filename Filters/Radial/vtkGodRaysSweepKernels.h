// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSweepKernels.h
 * @brief   the inner loops of the sector sweep and of clipped taps, for whatever the processor has
 *
 * Private. Compiled once for each set of vector instructions through Highway; the best one that the
 * processor has is taken at run time.
 */

#ifndef vtkGodRaysSweepKernels_h
#define vtkGodRaysSweepKernels_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysSectorSweep.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vtkGodRays
{
/**
 * Rows of one component of the result.
 */
struct SweepResult
{
  float* Values;
  std::ptrdiff_t Stride;
};

///@{
/// Of 1 or 3 images and results at once.
/// Sweep the axis strip of a wedge, if it has one, and leave what it found in the workspace.
void SweepAxis(const SweepPlan& plan, const SweepWedge& wedge, const SweepImage* images,
  int channels, SweepWorkspace& workspace);
/// Sweep one band of a wedge and write the pixels that lie in it. axis: the strip's workspace.
void SweepBand(const SweepPlan& plan, const SweepWedge& wedge, int band, const SweepImage* images,
  int channels, SweepWorkspace& axis, SweepWorkspace& workspace, const SweepResult* results);
///@}

/// Sum taps along the marches of pixels first to last of row y, within the image only.
/// tolerance: root mean square error that is accepted [fraction of the peak].
void SumClippedTaps(const vtkGodRaysMarch& march, const SweepImage& image, double tolerance, int y,
  int first, int last, float* to);

///@{
/// One row of one component, sanitised, times scale.
void LoadPixels(const unsigned char* pixels, int step, int count, float scale, float* row);
void LoadPixels(const float* pixels, int step, int count, float scale, float* row);
void LoadPixels(const double* pixels, int step, int count, float scale, float* row);
///@}

///@{
/// For tests: the names of the instruction sets that this processor has, best first, and to use one
/// of them alone; an empty name ends that.
VTKGODRAYSFILTERS_EXPORT std::vector<std::string> GetInstructionSets();
VTKGODRAYSFILTERS_EXPORT bool UseInstructionSet(const std::string& name);
///@}
}

#endif
