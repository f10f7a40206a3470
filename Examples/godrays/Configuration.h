// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options that hold each time, in a file.
 */

#ifndef Configuration_h
#define Configuration_h

#include <string>
#include <vector>

/**
 * Where the user's file is: godrays/config in XDG_CONFIG_HOME or ~/.config. Empty if there is none.
 */
std::string FindConfiguration();

/**
 * The options in a file, as on the command line: those before its first line with a pattern in brackets,
 * such as [*.vti], and those after each that the name of the file to be shown fits. Throws Failure when
 * it cannot be read.
 */
std::vector<std::string> ReadConfiguration(const std::string& path, const std::string& shown);

#endif
