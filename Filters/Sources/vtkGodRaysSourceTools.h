// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSourceTools.h
 * @brief   what sources of scenes share: the time that is asked for, and loops that can be stopped
 *
 * Private.
 */

#ifndef vtkGodRaysSourceTools_h
#define vtkGodRaysSourceTools_h

#include "vtkGodRaysProgress.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"
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

/**
 * function(begin, end) over 0 to count, on all threads; progress, from one fraction to another, is told
 * between parts. Returns false if the source is to stop.
 */
template <typename Function>
bool For(vtkAlgorithm* source, vtkIdType count, const Function& function, double from = 0.0,
  double to = 1.0)
{
  constexpr vtkIdType parts = 20;
  for (vtkIdType part = 0; part < parts; ++part)
  {
    if (!vtkGodRays::TellProgress(source, from + part * (to - from) / parts))
    {
      return false;
    }
    vtkSMPTools::For(count * part / parts, count * (part + 1) / parts, function);
  }
  return vtkGodRays::TellProgress(source, to);
}
}

#endif
