// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What ModelErrors.h compares.

#ifndef ModelMethods_h
#define ModelMethods_h

#include "vtkGodRaysIntegrator.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace ModelError
{
const char* const CustomaryModel = "radial sum, 100 taps";
const char* const BestModel = "automatic, 1/255"; // the default
const char* const ClosedForm = "closed form, no shadows";
const char* const CellMethod = "froxels, 160 x 90 x 64";
const char* const TreeMethod = "epipolar lines, min/max trees";

/// A line in each table.
struct ModelMethod
{
  std::string Name;
  std::string Series; // of the chart
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  bool IsMedium; // else it is the customary model, times what makes its error least
  double Tolerance = 1.0 / 255.0;

  /// Whether it chooses by the tolerance.
  bool IsAutomatic() const { return this->Series == "automatic"; }
};

std::vector<ModelMethod> MakeModelMethods();
}

#endif
