// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The named looks, and the media in which light is scattered once.
 */

#ifndef Presets_h
#define Presets_h

#include <string>
#include <vector>

struct Preset
{
  std::string Name;
  std::string Description;
  bool IsMedium;
  bool IsPublished; // somebody else's formulation
};

/**
 * All of them, looks first, of which the first is the usual one.
 */
const std::vector<Preset>& GetPresets();

/**
 * The one of this name. Throws Failure if there is none.
 */
const Preset& FindPreset(const std::string& name);

#endif
