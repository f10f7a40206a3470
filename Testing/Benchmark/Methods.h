// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The integrators that are compared, with their settings: a line each in Methods.cxx.

#ifndef Methods_h
#define Methods_h

#include "vtkGodRaysRadialIntegrator.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct Method
{
  std::string Name;   // unique
  std::string Series; // methods of one series are a line in the charts
  std::string Label;  // in the charts, within its series
  vtkSmartPointer<vtkGodRaysRadialIntegrator> Integrator;
  double Tolerance = 1.0 / 255.0;
  int Pace = STEADY;

  /// How often it runs.
  enum Paces
  {
    STEADY, ///< in every round
    SLOW,   ///< once in each case, and for one colour only
    SLOWEST ///< the same, in two cases only
  };
};

/// Names that figures refer to.
extern const char* const CustomaryMethod; // 100 taps
extern const char* const ControlMethod;   // 16 taps: must not keep the bounds
extern const char* const ProcessorMethod; // at 1/255
extern const char* const GraphicsMethod;  // at 1/255

std::vector<Method> MakeMethods();

#endif
