// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "Failure.h"

#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

//------------------------------------------------------------------------------
std::string Quoted(const std::string& text)
{
  return "'" + text + "'";
}

//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> words;
  std::stringstream stream(text);
  for (std::string word; std::getline(stream >> std::ws, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words, const std::string& between)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : between) + word;
  }
  return text;
}

//------------------------------------------------------------------------------
bool ReadNumber(const std::string& text, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value);
}

//------------------------------------------------------------------------------
Vector3 ParseColor(const std::string& what, const std::string& text)
{
  Vector3 color{};
  const auto outside = [](double value) { return value < 0.0 || value > 1.0; };
  if (ReadNumbers(text, color) && std::none_of(color.begin(), color.end(), outside))
  {
    return color;
  }
  vtkNew<vtkNamedColors> names;
  const bool hexadecimal = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (hexadecimal || names->ColorExists(text))
  {
    const vtkColor3ub bytes = hexadecimal ? names->HTMLColorToRGB(text) : names->GetColor3ub(text);
    return { bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0 };
  }
  throw Failure(
    what + ": " + Quoted(text) + " should be r,g,b from 0 to 1, #rrggbb, or a name such as orange");
}
