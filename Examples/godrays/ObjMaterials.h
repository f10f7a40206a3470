// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The colours of .obj files, which are in .mtl files beside them.
 */

#ifndef ObjMaterials_h
#define ObjMaterials_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string
#include <vector> // For std::vector

class vtkUnsignedCharArray;

/**
 * The colours of the faces of a .obj file, in its order, by their materials; no values when it has
 * no materials. (The numbers of materials that vtkOBJReader gives do not always fit their names.)
 */
vtkSmartPointer<vtkUnsignedCharArray> ReadObjFaceColors(
  const std::string& path, std::vector<std::string>& notes);

#endif
