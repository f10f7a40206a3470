// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Json.h"

namespace
{
//------------------------------------------------------------------------------
std::string_view Trim(std::string_view text)
{
  constexpr const char* space = " \t\r\n";
  const auto first = text.find_first_not_of(space);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(space) - first + 1);
}
}

//------------------------------------------------------------------------------
std::string_view UnquoteJson(std::string_view text)
{
  return text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
}

//------------------------------------------------------------------------------
std::vector<JsonMember> SplitJson(std::string_view text)
{
  std::vector<JsonMember> members;
  text = Trim(text);
  if (text.empty() || (text.front() != '{' && text.front() != '['))
  {
    return members;
  }
  JsonMember member;
  std::size_t begin = 1;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i];
    if (quoted)
    {
      i += letter == '\\';
      quoted = letter != '"';
      continue;
    }
    quoted = letter == '"';
    depth += letter == '{' || letter == '[';
    depth -= letter == '}' || letter == ']';
    if (letter == ':' && depth == 1)
    {
      member.Name = UnquoteJson(Trim(text.substr(begin, i - begin)));
      begin = i + 1;
    }
    else if ((letter == ',' && depth == 1) || depth == 0)
    {
      member.Value = Trim(text.substr(begin, i - begin));
      members.push_back(member);
      member = JsonMember();
      begin = i + 1;
    }
    if (depth == 0)
    {
      break;
    }
  }
  return members;
}

//------------------------------------------------------------------------------
std::string_view FindJson(const std::vector<JsonMember>& members, std::string_view name)
{
  for (const JsonMember& member : members)
  {
    if (member.Name == name)
    {
      return member.Value;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string UnescapeJson(std::string_view text)
{
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    i += text[i] == '\\' && i + 1 < text.size() && text[i + 1] != 'u';
    plain += text[i];
  }
  return plain;
}
