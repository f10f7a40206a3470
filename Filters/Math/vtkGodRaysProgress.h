// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysProgress.h
 * @brief   progress, and whether to go on
 *
 * Private.
 */

#ifndef vtkGodRaysProgress_h
#define vtkGodRaysProgress_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace vtkGodRays
{
/**
 * Tells progress [fraction]. Returns false if the algorithm is to stop. Newer VTKs are told to stop in
 * turn, and pass it on.
 */
inline bool TellProgress(vtkAlgorithm* algorithm, double progress)
{
  algorithm->UpdateProgress(progress);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  if (algorithm->GetAbortExecute())
  {
    algorithm->SetAbortOutput(true);
  }
  return !algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() == 0;
#endif
}
}

#endif
