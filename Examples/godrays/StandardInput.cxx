// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StandardInput.h"

#include "Failure.h"
#include "System.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
/**
 * The extension of the type that begins like this; empty for another one.
 */
std::string FindType(const std::string& start)
{
  const std::pair<const char*, const char*> beginnings[] = { { "# vtk DataFile", ".vtk" },
    { "ply", ".ply" }, { "solid", ".stl" }, { "glTF", ".glb" }, { "\x89PNG", ".png" } };
  for (const auto& [text, extension] : beginnings)
  {
    if (start.rfind(text, 0) == 0)
    {
      return extension;
    }
  }
  const std::pair<const char*, const char*> xmls[] = { { "PolyData", ".vtp" },
    { "UnstructuredGrid", ".vtu" }, { "ImageData", ".vti" }, { "RectilinearGrid", ".vtr" },
    { "StructuredGrid", ".vts" }, { "vtkMultiBlockDataSet", ".vtm" } };
  const auto root = start.find("<VTKFile");
  for (const auto& [type, extension] : xmls)
  {
    const std::string attribute = std::string("type=\"") + type + "\"";
    if (root != std::string::npos && start.find(attribute, root) < start.find('>', root))
    {
      return extension;
    }
  }
  return "";
}
}

//------------------------------------------------------------------------------
StandardInput::StandardInput(std::vector<std::string>& files)
{
  const auto place = std::find(files.begin(), files.end(), "-");
  if (place == files.end())
  {
    return;
  }
  if (std::find(place + 1, files.end(), "-") != files.end())
  {
    throw Failure("- is the standard input, which can be read once");
  }
  std::cin >> std::noskipws;
  const std::string data{ std::istreambuf_iterator<char>(std::cin), {} };
  constexpr std::size_t enough = 1000;
  const std::string type = FindType(data.substr(0, enough));
  if (type.empty())
  {
    throw Failure(
      "-: the standard input is of an unknown type, or empty; give a file with an extension",
      Failure::File);
  }
  const std::string name = System::MakeTemporaryFolder();
  if (name.empty())
  {
    throw Failure("-: there is no folder for temporary files; set TMPDIR to one", Failure::File);
  }
  *place = name + "/stdin" + type;
  this->Folder.emplace(name);
  this->File.emplace(*place);
  std::ofstream file(*place, std::ios::binary);
  file << data;
  if (!file.flush())
  {
    throw Failure("-: " + name + " could not be written; is the disk full?", Failure::File);
  }
}

//------------------------------------------------------------------------------
StandardInput::~StandardInput() = default;
