// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The triangle strips of .ply files, which vtkPLYReader leaves out.
 */

#ifndef PlyStrips_h
#define PlyStrips_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkCellArray;

/**
 * The strips of a .ply file, in its order; empty when it has none. Throws Failure when the file ends
 * before them, or has values of a type that PLY does not have.
 */
vtkSmartPointer<vtkCellArray> ReadPlyStrips(const std::string& path);

#endif
