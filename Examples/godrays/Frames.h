// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pictures that are written: one, or those of a film.
 */

#ifndef Frames_h
#define Frames_h

#include "Options.h"
#include "Temporary.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstdio>   // For std::FILE
#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

class vtkGenericMovieWriter;
class vtkRenderWindow;

/**
 * A name with {name}, {n}, {frame} and {time} replaced; numbers have four digits. Throws Failure for
 * another word in braces.
 */
std::string FillTemplate(const std::string& text, const std::string& name, std::size_t number,
  std::size_t frame, std::optional<double> time);

class Frames
{
public:
  /**
   * Throws Failure when a film cannot be made of the type, or a file cannot be written where it is to
   * be.
   */
  explicit Frames(const Options& options);
  ~Frames();

  Frames(const Frames&) = delete;
  void operator=(const Frames&) = delete;

  /**
   * Write what the window shows, of the file of this name and number; over none of the inputs, which may be
   * more than were known before. Throws Failure.
   */
  void Write(vtkRenderWindow* window, const std::string& name, std::size_t number,
    std::optional<double> time, const std::vector<std::string>& inputs);

  /**
   * End the film. Throws Failure when it could not be written; there is none then.
   */
  void Finish();

private:
  void StartFilm(vtkRenderWindow* window);

  const Options& Settings;
  std::string Part;              ///< the film until it is whole
  std::optional<Temporary> Kept; ///< so that it goes with the program
  std::FILE* Encoder = nullptr;
  vtkSmartPointer<vtkGenericMovieWriter> Writer;
  std::size_t Count = 0;
};

#endif
