// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that name other files by time.
 */

#ifndef Series_h
#define Series_h

#include <string>  // For std::string
#include <utility> // For std::pair
#include <vector>  // For std::vector

/// A time, and a file of it; several files may be of one time.
using SeriesPart = std::pair<double, std::string>;

/**
 * The files of ParaView's collection, .pvd, or of its series, as .vtu.series, in JSON. Throws Failure when
 * there are none, or one that names others itself.
 */
std::vector<SeriesPart> ReadSeriesParts(const std::string& path);

#endif
