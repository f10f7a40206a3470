// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Series.h"

#include "Failure.h"
#include "Json.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
bool IsCollection(const fs::path& path)
{
  return path.extension() == ".pvd";
}

//------------------------------------------------------------------------------
std::vector<SeriesPart> ReadCollection(const std::string& path)
{
  const auto root = vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
  {
    throw Failure(path + ": has no Collection; it is damaged, or not what its name says");
  }
  std::vector<SeriesPart> parts;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* part = collection->GetNestedElement(i);
    double time = 0.0;
    part->GetScalarAttribute("timestep", time);
    if (const char* file = part->GetAttribute("file"))
    {
      parts.emplace_back(time, file);
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
std::vector<SeriesPart> ReadJsonSeries(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  std::vector<SeriesPart> parts;
  for (const JsonMember& part : SplitJson(FindJson(SplitJson(text), "files")))
  {
    const auto members = SplitJson(part.Value);
    const std::string name = UnescapeJson(UnquoteJson(FindJson(members, "name")));
    const std::string time(FindJson(members, "time"));
    char* end = nullptr;
    const double value = std::strtod(time.c_str(), &end);
    if (name.empty())
    {
      continue;
    }
    if (time.empty() || *end != '\0' || !std::isfinite(value))
    {
      throw Failure(path + ": " + name + " has no number as its time; write it again");
    }
    parts.emplace_back(value, name);
  }
  return parts;
}
}

//------------------------------------------------------------------------------
std::vector<SeriesPart> ReadSeriesParts(const std::string& path)
{
  auto parts = IsCollection(path) ? ReadCollection(path) : ReadJsonSeries(path);
  if (parts.empty())
  {
    throw Failure(path + ": names no files; it is damaged, or not what its name says");
  }
  for (auto& [time, file] : parts)
  {
    const fs::path name = file;
    if (IsCollection(name) || name.extension() == ".series")
    {
      throw Failure(
        path + ": names another " + name.extension().string() + "; name its files instead");
    }
    file = (fs::path(path).parent_path() / name).string();
  }
  return parts;
}
