// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How far what the pass draws is from single scattering, and what it costs: each model and quality on
// twelve scenes, five places of the light, three media and three phase functions.

#ifndef ModelErrors_h
#define ModelErrors_h

#include "Device.h"

#include <string>

struct ModelErrorSettings
{
  bool Quick = false;
  std::string Filter = "."; // of "scene/light"
  std::string Folder;       // of the documentation; none is written if it is empty
  std::string Command;      // as the page tells it
};

/**
 * Measure, print the tables, and write ModelError.md with its chart and pictures. Returns whether the
 * errors keep the bounds that are checked.
 */
bool MeasureModelErrors(Device& device, const ModelErrorSettings& settings);

#endif
