// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The options of the command line: names, values, helps and groups, in one place.
 */

#ifndef OptionTable_h
#define OptionTable_h

#include "Documents.h"
#include "Options.h"

#include <vector> // For std::vector

namespace CLI
{
class App;
}

/**
 * Add all options to a parser. It writes their values to the struct.
 */
void AddOptions(CLI::App& app, Options& options);

/**
 * What documents tell of them.
 */
std::vector<OptionRow> GetRows(const CLI::App& app);

#endif
