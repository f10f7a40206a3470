// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colour maps for scalars: perceptually even ones, and one for terrain.
 */

#ifndef Colormaps_h
#define Colormaps_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkColorTransferFunction;

/// Whether there is a colour map of this name.
bool HasColormap(const std::string& name);

/// All names, with this text between them.
std::string GetColormapNames(const std::string& between);

/**
 * The colour map over a range of values. "terrain" has its coast at 0 if the range has values on
 * both sides of it, and begins with green lowlands if not.
 */
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& name, const double range[2]);

#endif
