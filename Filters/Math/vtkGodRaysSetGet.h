// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSetGet.h
 * @brief   the setters of parameters; private to the implementation files
 */

#ifndef vtkGodRaysSetGet_h
#define vtkGodRaysSetGet_h

#include "vtkMath.h"
#include "vtkSetGet.h"

#include <algorithm>

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

/**
 * The same for a parameter of three numbers: `void className::SetName(double, double, double)` and
 * `void className::SetName(const double[3])`.
 */
#define vtkGodRaysSetFinite3Macro(className, name, minimum, maximum)                               \
  vtkGodRaysSetFinite3AndMacro(className, name, minimum, maximum, static_cast<void>(0))

/**
 * The same with a statement that is executed if the parameter changes.
 */
#define vtkGodRaysSetFinite3AndMacro(className, name, minimum, maximum, onChange)                  \
  void className::Set##name(const double value[3])                                                 \
  {                                                                                                \
    double clamped[3];                                                                             \
    for (int i = 0; i < 3; ++i)                                                                    \
    {                                                                                              \
      if (!vtkMath::IsFinite(value[i]))                                                            \
      {                                                                                            \
        vtkErrorMacro(#name " must be three finite numbers in ["                                   \
          << (minimum) << ", " << (maximum) << "], not " << value[0] << " " << value[1] << " "     \
          << value[2] << "; it stays " << this->name[0] << " " << this->name[1] << " "             \
          << this->name[2] << ".");                                                                \
        return;                                                                                    \
      }                                                                                            \
      clamped[i] = vtkMath::ClampValue<double>(value[i], minimum, maximum);                        \
    }                                                                                              \
    if (!std::equal(clamped, clamped + 3, this->name))                                             \
    {                                                                                              \
      std::copy(clamped, clamped + 3, this->name);                                                 \
      onChange;                                                                                    \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  void className::Set##name(double first, double second, double third)                             \
  {                                                                                                \
    const double value[3] = { first, second, third };                                              \
    this->Set##name(value);                                                                        \
  }

/**
 * Define `void className::SetName(int)` of a mode, 0 to last. Any other number is an error that names
 * the parameter, its range and the value that is kept.
 */
#define vtkGodRaysSetModeMacro(className, name, last)                                              \
  void className::Set##name(int value)                                                             \
  {                                                                                                \
    if (value < 0 || value > (last))                                                               \
    {                                                                                              \
      vtkErrorMacro(#name " must be in 0.." << (last) << ", not " << value << "; it stays "        \
                                            << this->name << ".");                                 \
    }                                                                                              \
    else if (value != this->name)                                                                  \
    {                                                                                              \
      this->name = value;                                                                          \
      this->Modified();                                                                            \
    }                                                                                              \
  }

#endif
