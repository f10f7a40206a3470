// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSourceTools.h
 * @brief   what sources of scenes share: the time that is asked for
 *
 * Private.
 */

#ifndef vtkGodRaysSourceTools_h
#define vtkGodRaysSourceTools_h

#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace vtkGodRaysSourceTools
{
/**
 * Tell that any time from 0 to end [s] can be asked for.
 */
inline void SetTimeRange(vtkInformation* output, double end)
{
  const double range[2] = { 0.0, end };
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

/**
 * The time that is asked for, kept in [0, end]; 0 if none is [s].
 */
inline double GetTime(vtkInformation* output, double end)
{
  vtkInformationDoubleKey* key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  const double time = output->Has(key) ? output->Get(key) : 0.0;
  return vtkMath::IsFinite(time) ? vtkMath::ClampValue(time, 0.0, end) : 0.0;
}
}

#endif
