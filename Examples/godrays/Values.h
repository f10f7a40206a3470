// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values as they are written in options: lists, numbers, colours.
 */

#ifndef Values_h
#define Values_h

#include "Options.h"

#include <array>   // For std::array
#include <cstddef> // For std::size_t
#include <sstream> // For std::stringstream
#include <string>  // For std::string
#include <vector>  // For std::vector

std::string Quoted(const std::string& text);

/**
 * The words of a list with commas between them.
 */
std::vector<std::string> Split(const std::string& text);

/**
 * The words as a list, with this between them.
 */
std::string Join(const std::vector<std::string>& words, const std::string& between);

/**
 * Read one finite number. Returns whether the text is that and nothing else.
 */
bool ReadNumber(const std::string& text, double& value);

/**
 * Read numbers with commas between them. Returns whether the text is as many as there are values.
 */
template <std::size_t N>
bool ReadNumbers(const std::string& text, std::array<double, N>& values)
{
  std::stringstream stream(text);
  std::string word;
  std::size_t count = 0;
  while (std::getline(stream, word, ','))
  {
    if (count == N || !ReadNumber(word, values[count]))
    {
      return false;
    }
    ++count;
  }
  return count == N && text.back() != ',';
}

/**
 * A colour, given as r,g,b from 0 to 1, as #rrggbb, or by its name in VTK. Throws Failure,
 * beginning with what, when it is none of these.
 */
Vector3 ParseColor(const std::string& what, const std::string& text);

#endif
