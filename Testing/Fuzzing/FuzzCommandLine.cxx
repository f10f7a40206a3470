// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The command line, and the file of options: a line is a word, and what follows an empty line is the file. It
// is taken, or there is a Failure of one line.

#include "GodRaysFuzzing.h"

#include "Failure.h"
#include "Files.h"
#include "Options.h"
#include "Presets.h"

#include "vtkObject.h"

#include <iostream>
#include <sstream>
#include <vector>

// of Files.cxx, which has all readers
std::string GetExtensions()
{
  return ".vtp";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::cout.rdbuf(nullptr); // --help
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> words = { "godrays" };
  std::string file;
  for (std::string line; std::getline(text, line);)
  {
    if (line.empty())
    {
      file.assign(std::istreambuf_iterator<char>(text), {});
      break;
    }
    words.push_back(line.c_str()); // a word ends at a zero
  }
  // Of configurations there is this one or none, and not the user's.
  if (file.empty())
  {
    words.emplace_back("--no-config");
  }
  else
  {
    words.push_back(
      "--config=" + WriteBytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size()));
  }
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  try
  {
    const auto options = ParseCommandLine(static_cast<int>(arguments.size()), arguments.data());
    if (options)
    {
      Require(options->Size[0] >= 8 && options->Size[1] >= 8, "a picture has pixels");
      Require(options->Zoom > 0.0 && options->Turntable >= 0, "numbers are in their ranges");
      for (const double channel : options->LightColor.value_or(Vector3{}))
      {
        Require(channel >= 0.0 && channel <= 1.0, "colours are from 0 to 1");
      }
      if (!options->Preset.empty())
      {
        Require(
          FindPreset(options->Preset).Name == options->Preset, "a preset is found by its name");
      }
    }
  }
  catch (const Failure& failure)
  {
    Require(*failure.what() != '\0', "a failure has words");
  }
  return 0;
}
