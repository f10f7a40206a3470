// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSetGet.h
 * @brief   the setter of every real parameter; private to the implementation files
 */

#ifndef vtkGodRaysSetGet_h
#define vtkGodRaysSetGet_h

#include "vtkMath.h"
#include "vtkSetGet.h"

/**
 * Define `void className::SetName(double)` in a .cxx file, as vtkCxxSetObjectMacro does for
 * objects. A number is clamped to [minimum, maximum]; Modified() is called if that is a change.
 * NaN and infinities are an error that names the parameter, its range and the value that is kept.
 */
#define vtkGodRaysSetFiniteMacro(className, name, minimum, maximum)                                \
  void className::Set##name(double value)                                                          \
  {                                                                                                \
    if (!vtkMath::IsFinite(value))                                                                 \
    {                                                                                              \
      vtkErrorMacro(#name " must be a finite number in ["                                          \
        << (minimum) << ", " << (maximum) << "], not " << value << "; it stays " << this->name     \
        << ".");                                                                                   \
      return;                                                                                      \
    }                                                                                              \
    const double clamped = vtkMath::ClampValue<double>(value, minimum, maximum);                   \
    if (this->name != clamped)                                                                     \
    {                                                                                              \
      this->name = clamped;                                                                        \
      this->Modified();                                                                            \
    }                                                                                              \
  }

#endif
