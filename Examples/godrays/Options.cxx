// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Configuration.h"
#include "Documents.h"
#include "Failure.h"
#include "Files.h"
#include "Keys.h"
#include "OptionChecks.h"
#include "OptionTable.h"
#include "Suggestions.h"
#include "Values.h"

#include "vtkGodRaysSunPosition.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>

namespace
{
//------------------------------------------------------------------------------
std::string FormatClock(double hours)
{
  const int minutes = static_cast<int>(std::lround(60.0 * hours) + 1440) % 1440;
  char text[16];
  std::snprintf(text, sizeof(text), "%02d:%02d", minutes / 60, minutes % 60);
  return text;
}

//------------------------------------------------------------------------------
std::array<double, 2> FindSun(
  const std::string& date, const std::array<double, 2>& place, bool mayBeDown)
{
  if (std::abs(place[0]) > 90.0 || std::abs(place[1]) > 180.0)
  {
    throw Failure(
      "--place: the latitude should be from -90 to 90 degrees, the longitude from -180 to 180");
  }
  vtkNew<vtkGodRaysSunPosition> sun;
  vtkObject::GlobalWarningDisplayOff(); // it is told below
  const bool hasZone = date.find_first_of("Z+-", date.find(':')) != std::string::npos;
  const bool read = sun->SetDateTime(date) && hasZone;
  vtkObject::GlobalWarningDisplayOn();
  if (!read)
  {
    throw Failure("--date: " + Quoted(date) +
      " should be a date from 1900 to 2100, a time and a zone, as in 2024-06-21T19:30+02:00");
  }
  sun->SetLatitude(place[0]);
  sun->SetLongitude(place[1]);
  const double elevation = sun->GetElevation();
  if (elevation < 0.0 && !mayBeDown)
  {
    const bool rises = sun->GetDayType() == vtkGodRaysSunPosition::RISES_AND_SETS;
    throw Failure("--date: the sun is below the horizon then" +
      (rises ? "; that day it is up from " + FormatClock(sun->GetSunrise()) + " to " +
            FormatClock(sun->GetSunset())
             : std::string()));
  }
  return { sun->GetAzimuth(), elevation };
}

//------------------------------------------------------------------------------
std::vector<std::string> GetNames(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
  {
    for (const std::string& name : option->get_lnames())
    {
      names.push_back("--" + name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::string GetReason(const CLI::ParseError& error)
{
  const std::string text = error.what();
  const std::string line = text.substr(0, text.find('\n'));
  // "--size: 1 required WxH missing"
  const bool isMissing = line.find(" required ") != std::string::npos;
  return isMissing ? line.substr(0, line.find(": ")) + ": needs a value" : line;
}

//------------------------------------------------------------------------------
/**
 * Parse the options of a file, and then those of the command line, which hold where both name one.
 */
void ParseAgain(CLI::App& app, Options& options, const std::string& path, int argc, char* argv[])
{
  auto words = ReadConfiguration(path, options.Files.front());
  const auto names = GetNames(app);
  for (const std::string& word : words)
  {
    const std::string name = word.substr(0, word.find('='));
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      throw Failure(path + ": " + name.substr(2) + " is no option" + Suggest(name, names));
    }
  }
  const auto parse = [&app, &options](std::vector<std::string> all)
  {
    std::reverse(all.begin(), all.end()); // as CLI11 has it
    options = {};
    app.clear();
    app.parse(all);
  };
  try
  {
    parse(words);
  }
  catch (const CLI::Success&)
  {
    throw;
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(path + ": " + GetReason(error));
  }
  catch (const Failure& failure)
  {
    throw Failure(path + ": " + failure.what(), failure.Code);
  }
  words.insert(words.end(), argv + 1, argv + argc);
  parse(words);
}
}

//------------------------------------------------------------------------------
std::optional<Options> ParseCommandLine(int argc, char* argv[])
{
  CLI::App app("Shows files with god rays: the shafts of light that appear where air scatters "
               "sunlight past things that block it.",
    "godrays");
  app.footer("Reads " + GetExtensions() +
    "\n\nWithout --output a window opens. Drag to look around; its keys are:\n" + GetKeyLines() +
    "\n\nEnds with 0, or when something is wrong, which a line tells, with 2 (options), 3 (files),"
    " 4 (the display), 5 (not as the --reference) or 1.");
  app.set_version_flag("--version", std::string("godrays ") + GODRAYS_VERSION);
  Options options;
  AddOptions(app, options);
  try
  {
    app.parse(argc, argv);
    const std::string path = options.NoConfiguration ? ""
      : options.Configuration.empty()                ? FindConfiguration()
                                                     : options.Configuration;
    if (!path.empty() && !options.Files.empty() && options.Document.empty())
    {
      ParseAgain(app, options, path, argc, argv);
    }
  }
  catch (const CLI::Success& success)
  {
    app.exit(success);
    return {};
  }
  catch (const CLI::ExtrasError&)
  {
    const std::string extra = app.remaining().front();
    const std::string name = extra.substr(0, extra.find('='));
    const bool isFile = std::filesystem::exists(extra);
    throw Failure(name + " is no option" +
      (isFile ? "; if the file is meant, name it ./" + extra : Suggest(name, GetNames(app))) +
      "; see godrays --help");
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(GetReason(error) + "; see godrays --help");
  }
  if (!options.Document.empty())
  {
    std::cout << MakeDocument(options.Document, GetRows(app));
    return {};
  }
  CheckTogether(options);
  if (options.Shadows && !options.Rays)
  {
    options.Rays = true;
    options.Intensity = 0.0;
  }
  if (options.Window)
  {
    const auto& [level, width] = *options.Window;
    options.Range = { level - 0.5 * width, level + 0.5 * width };
  }
  if (options.Place)
  {
    options.Sun = FindSun(options.Date, *options.Place, !options.Sky.empty());
  }
  return options;
}
