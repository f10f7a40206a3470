// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A failure that the user is told of in one line: what went wrong, and what to do about it.
 */

#ifndef Failure_h
#define Failure_h

#include <stdexcept> // For std::runtime_error

class Failure : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif
