// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which options go together.
 */

#ifndef OptionChecks_h
#define OptionChecks_h

#include "Options.h"

/**
 * Throws Failure where options of several pictures, of films and of the window exclude or lack each other.
 */
void CheckSeries(const Options& options);

/**
 * Throws Failure where other options do.
 */
void CheckTogether(const Options& options);

#endif
