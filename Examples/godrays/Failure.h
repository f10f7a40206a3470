// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A failure that the user is told of in one line: what went wrong, and what to do about it.
 */

#ifndef Failure_h
#define Failure_h

#include <stdexcept> // For std::runtime_error
#include <string>    // For std::string

class Failure : public std::runtime_error
{
public:
  /// What is wrong, by which the program ends with this exit code.
  enum Kind
  {
    Other = 1,     ///< drawing failed, or memory was not enough
    Usage = 2,     ///< the options
    File = 3,      ///< a file that is read or written
    Display = 4,   ///< the display
    Difference = 5 ///< the picture is not as the reference
  };

  explicit Failure(const std::string& what, Kind kind = Usage)
    : std::runtime_error(what)
    , Code(kind)
  {
  }

  const Kind Code;
};

#endif
