// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads a file of any type that VTK can read and that has something to draw.
 */

#ifndef Files_h
#define Files_h

#include "Elevation.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

class vtkActor;
class vtkDataSet;
class vtkImageData;

struct FileContents
{
  std::string Path;
  std::vector<vtkSmartPointer<vtkDataSet>> DataSets; ///< the leaves, in the file's order
  std::vector<vtkSmartPointer<vtkActor>> Actors;     ///< parts that have their own materials
  Georeference Place;                                ///< how an elevation picture lies on the earth
  char Up = 'Z';                                     ///< the axis that points up
  std::optional<double> Time;                        ///< the one asked for
  std::vector<double> Times;                         ///< those of its steps, if it has any
  std::vector<std::string> Notes;                    ///< sentences for the user, none in most files
  std::string UpNote; ///< another one, if Up was guessed from the data
};

/**
 * Read a file, at the time step nearest to this time, or at the first one. Throws Failure, with what to
 * do, when the file is missing, empty, a directory, unreadable, of an unknown type, damaged, or has
 * nothing to draw. Tells on the standard error output how far it is when that takes more than a second.
 */
FileContents ReadFile(const std::string& path, std::optional<double> time);

/**
 * Read the picture that an option names. Throws Failure as ReadFile() does.
 */
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& option, const std::string& path);

/**
 * The extensions of the types that ReadFile() knows.
 */
std::string GetExtensions();

#endif
