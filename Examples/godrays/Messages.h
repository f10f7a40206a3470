// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Keeps what VTK, and the libraries that it reads files with, would print, so that the user sees
 * one line.
 */

#ifndef Messages_h
#define Messages_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstdio> // For std::FILE
#include <string> // For std::string
#include <vector> // For std::vector

class vtkOutputWindow;

class Messages
{
public:
  /**
   * Collect messages while this object lives. With catchStandardError, also what libraries print
   * without asking VTK, and if one of them crashes, the program ends with the exit code and
   * the line onCrash. Objects may nest.
   */
  Messages(bool catchStandardError, const std::string& onCrash, int exitCode);
  ~Messages();

  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  /**
   * The errors and warnings so far, each in one line and without VTK's file name and line number.
   */
  std::vector<std::string> GetErrors() const;
  std::vector<std::string> GetWarnings() const;

  /**
   * What libraries printed to the standard error output while it was caught.
   */
  std::string GetPrinted() const;

  /**
   * Write to the standard error output that the user sees, also while it is caught.
   */
  static void Show(const std::string& text);

  /**
   * Whether that is a terminal.
   */
  static bool IsTerminal();

private:
  vtkSmartPointer<vtkOutputWindow> Collector;
  vtkSmartPointer<vtkOutputWindow> Former;
  std::FILE* Printed = nullptr; ///< a file without a name
  int FormerErrors;             ///< where errors went before they were caught here
  std::string FormerCause;      ///< of a crash; empty if this object is the first that catches any
  int FormerCode;
};

#endif
