// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Configuration.h"

#include "Failure.h"
#include "System.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
std::string Trim(const std::string& text)
{
  const char* const spaces = " \t\r";
  const auto begin = text.find_first_not_of(spaces);
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}
}

//------------------------------------------------------------------------------
std::string FindConfiguration()
{
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  const fs::path path = folder && *folder ? fs::path(folder)
    : home                                ? fs::path(home) / ".config"
                                          : fs::path();
  std::error_code error;
  const fs::path file = path / "godrays" / "config";
  return !path.empty() && fs::is_regular_file(file, error) ? file.string() : "";
}

//------------------------------------------------------------------------------
std::vector<std::string> ReadConfiguration(const std::string& path, const std::string& shown)
{
  std::ifstream file(path);
  std::error_code error;
  if (!file || fs::is_directory(path, error))
  {
    throw Failure(
      "--config: " + path + " cannot be read; check its name and permissions", Failure::File);
  }
  const std::string name = fs::path(shown).filename().string();
  std::vector<std::string> options;
  bool fits = true;
  int number = 0;
  for (std::string line; std::getline(file, line);)
  {
    ++number;
    line = Trim(line);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    if (line[0] == '[')
    {
      if (line.back() != ']')
      {
        throw Failure(
          path + ":" + std::to_string(number) + ": " + line + " should end in ], as in [*.vti]");
      }
      fits = System::Matches(name, line.substr(1, line.size() - 2));
      continue;
    }
    const auto equal = line.find('=');
    const std::string option = Trim(line.substr(0, equal));
    if (option.empty() || option.find_first_of(" \t") != std::string::npos || option[0] == '-')
    {
      throw Failure(path + ":" + std::to_string(number) + ": " + line +
        " should be an option without hyphens, as in preset = fog, or edges");
    }
    if (fits)
    {
      options.push_back(
        "--" + option + (equal == std::string::npos ? "" : "=" + Trim(line.substr(equal + 1))));
    }
  }
  return options;
}
