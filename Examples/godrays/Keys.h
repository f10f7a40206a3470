// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The keys of the window: one table, of which the window, its help, --help, the manual page and
 * README.md are made.
 */

#ifndef Keys_h
#define Keys_h

#include <string>
#include <vector>

/// What a key does. Of those that have two directions, KeyBinding::Step says which.
enum class Command
{
  Help,
  Home,
  Rays,
  Look,
  Intensity,
  Exposure,
  View,
  RaysAlone,
  Split,
  Azimuth,
  Elevation,
  Handle,
  Sliders,
  Background,
  ScalarBar,
  Axes,
  Grid,
  Status,
  Style,
  Screenshot,
  PrintOptions,
  File,
  Reload,
  Time,
  Play,
  Quit
};

struct KeyBinding
{
  std::string Keys;                 ///< as the user reads them
  std::vector<std::string> Symbols; ///< X's names of them
  Command Do;
  int Step; ///< 1 or -1; 0 where there is one direction
  std::string Help;
};

const std::vector<KeyBinding>& GetKeyBindings();

/**
 * The one of a key, or null. A capital letter is taken for a small one if no key is that letter.
 */
const KeyBinding* FindKeyBinding(const std::string& symbol);

/**
 * A line for each, in two columns.
 */
std::string GetKeyLines();

#endif
