// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is made of the tables of options and keys: the manual page, completions for shells, README.md's
 * tables.
 */

#ifndef Documents_h
#define Documents_h

#include <string>
#include <vector>

struct OptionRow
{
  std::vector<std::string> Names; ///< with their hyphens, the long one last
  std::string Form;               ///< of its value; empty for a flag
  std::string Help;
  std::string Group;
  std::vector<std::string> Choices; ///< the values, where they are few
};

/// The kinds of documents.
const std::vector<std::string>& GetDocumentKinds();

/**
 * One of them: man, bash, zsh, fish, options or keys (tables in Markdown).
 */
std::string MakeDocument(const std::string& kind, const std::vector<OptionRow>& options);

#endif
