// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Data that come from another program.
 */

#ifndef StandardInput_h
#define StandardInput_h

#include "Temporary.h"

#include <optional>
#include <string>
#include <vector>

/**
 * Puts what the standard input holds into a file, under a name whose extension says of which type it is,
 * as long as this object lives.
 */
class StandardInput
{
public:
  /**
   * Where "-" is among the files, it is replaced by that file's name. Throws Failure when it is there
   * twice, or the type is none of those that are known by their first bytes: .vtk, .vtp, .vtu, .vti,
   * .vtr, .vts, .vtm, .ply, .stl as text, .glb and .png.
   */
  explicit StandardInput(std::vector<std::string>& files);
  ~StandardInput();

  StandardInput(const StandardInput&) = delete;
  void operator=(const StandardInput&) = delete;

private:
  std::optional<Temporary> Folder;
  std::optional<Temporary> File; // goes before its folder
};

#endif
