// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the picture goes: a file or a window.
 */

#ifndef Output_h
#define Output_h

#include "Options.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstdio>   // For std::FILE
#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

class vtkGodRaysPass;
class vtkImageData;
class vtkRenderWindow;

/**
 * Throws Failure when the extension is none that can be written, or, with transparent, of a type that has
 * no opacity.
 */
void CheckPictureName(const std::string& path, bool transparent);

/**
 * Throws Failure, beginning with the option, when the file's folder is missing or may not be written, or
 * when it is one of the files to be read.
 */
void CheckOutput(
  const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

/**
 * The same of the file of --numbers, and when its extension is none that can be written.
 */
void CheckNumbers(const std::string& path, const std::vector<std::string>& inputs);

/**
 * Throws Failure when there is no display that can draw. VTK ends the program then.
 */
void CheckDisplay();

/**
 * What the window shows, in three bytes for a pixel; with transparent, in four.
 */
vtkSmartPointer<vtkImageData> TakePicture(vtkRenderWindow* window, bool transparent);

/**
 * Write a picture as PNG to an open file. Throws Failure, beginning with the option.
 */
void PrintPicture(vtkImageData* picture, std::FILE* file, const std::string& option);

/**
 * Write what the window shows; - is the standard output. With transparent, a .png or .exr has the window's
 * opacity. An .exr or .hdr has linear light, as TakeLinearPicture() has it. Throws Failure when that fails; a
 * file that was there is then as it was.
 */
void WritePicture(vtkRenderWindow* window, const std::string& path, bool transparent);

/**
 * Write the numbers of the medium of the last picture, with the irradiance of a white light [W m-2], or
 * relative to it. Throws Failure when there are none, or when that fails.
 */
void WriteNumbers(
  vtkGodRaysPass* rays, const std::optional<Vector3>& irradiance, const std::string& path);

/**
 * The thresholded error of vtkImageDifference between what the window shows and a PNG or JPEG file.
 * Throws Failure when it cannot be read, or has another size.
 */
double CompareWithReference(vtkRenderWindow* window, const std::string& path);

#endif
