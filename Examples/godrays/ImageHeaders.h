// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Applies what headers of medical images say and VTK's readers leave out: the directions of the axes and the
 * origin, in DICOM's patient coordinates (x to the left, y to the back, z to the head) [the file's unit], and
 * the slope and intercept of the values. Slices are reordered where the axes are left-handed, as VTK draws
 * right-handed images alone.
 */

#ifndef ImageHeaders_h
#define ImageHeaders_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkImageData;
class vtkMetaImageReader;
class vtkNIFTIImageReader;
class vtkNrrdReader;

/// Checks the file that has the data of a MetaImage or NRRD file, and that VTK can read their encoding.
void CheckDataFiles(const std::string& path);

/// Returns the image that a reader has read from a file, placed and scaled. Throws Failure if the header's
/// axes do not span a volume, or if it says other numbers that cannot be.
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkMetaImageReader* reader);
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkNIFTIImageReader* reader);
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkNrrdReader* reader);

#endif
