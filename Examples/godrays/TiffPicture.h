// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads TIFF of compressions that VTK's reader takes for damaged, or reads wrongly.
 */

#ifndef TiffPicture_h
#define TiffPicture_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkImageData;

/**
 * Returns the first picture of a file of bytes that is compressed and of colours, or by JPEG: values of one,
 * three or, with opacity, four components. Null of others, which VTK reads. Throws Failure if the library has
 * no code for the compression, or the file is damaged.
 */
vtkSmartPointer<vtkImageData> ReadCompressedTiff(const std::string& path);

#endif
