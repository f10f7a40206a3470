// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How far pictures of media of data are from single scattering, and what they cost: ours, and what others
// do: froxels, marches with shadow rays, VTK's volume mapper. Smoke of 256^3 points over a terrain, one sun.

#ifndef DataErrors_h
#define DataErrors_h

#include "Device.h"

#include <string>

struct DataErrorSettings
{
  bool Quick = false;
  std::string Folder;  // of the documentation; none is written if it is empty
  std::string Command; // as the page tells it
};

/**
 * Measure, print the table, and write DataError.md with its chart and picture. Returns whether the errors
 * keep the bounds that are checked.
 */
bool MeasureDataErrors(Device& device, const DataErrorSettings& settings);

#endif
