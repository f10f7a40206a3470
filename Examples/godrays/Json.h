// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * As much of JSON as finding things in it takes; the syntax is not checked.
 */

#ifndef Json_h
#define Json_h

#include <string>      // For std::string
#include <string_view> // For std::string_view
#include <vector>      // For std::vector

/// A member of a JSON object, or, without a name, of an array: views of the text.
struct JsonMember
{
  std::string_view Name;
  std::string_view Value;
};

/**
 * The members of a JSON object or array, without what is in them. None of a text that is neither; those
 * before the end of one that was cut off.
 */
std::vector<JsonMember> SplitJson(std::string_view text);

/**
 * The value of a name; nothing if there is none.
 */
std::string_view FindJson(const std::vector<JsonMember>& members, std::string_view name);

/**
 * What stands between the quotes of a JSON string.
 */
std::string_view UnquoteJson(std::string_view text);

/**
 * The text of a JSON string. The letters that \u writes are left as they are.
 */
std::string UnescapeJson(std::string_view text);

#endif
