// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a misspelt name was meant to be.
 */

#ifndef Suggestions_h
#define Suggestions_h

#include <string>
#include <vector>

/**
 * "; did you mean NAME?" with the name that takes the fewest letters put in, left out or replaced, or
 * exchanged with their neighbours; if none is within a third of the word's length, with the first that begins
 * with a word of four letters or more; or else empty.
 */
std::string Suggest(const std::string& word, const std::vector<std::string>& names);

#endif
