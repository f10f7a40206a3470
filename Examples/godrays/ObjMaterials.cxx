// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjMaterials.h"

#include "Failure.h"
#include "FileChecks.h"

#include "vtkColor.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
using Materials = std::map<std::string, vtkColor3ub>;

/**
 * Add the diffuse colours of the materials in a .mtl file.
 */
void ReadMaterials(const fs::path& path, Materials& materials)
{
  std::ifstream file(path);
  std::string material;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    double color[3];
    if (word == "newmtl")
    {
      words >> material;
    }
    else if (word == "Kd" && words >> color[0] >> color[1] >> color[2])
    {
      const auto byte = [](double value)
      { return static_cast<unsigned char>(255.0 * std::clamp(value, 0.0, 1.0) + 0.5); };
      materials[material] = vtkColor3ub(byte(color[0]), byte(color[1]), byte(color[2]));
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> ReadObjFaceColors(
  const std::string& path, std::vector<std::string>& notes)
{
  const vtkColor3ub none(210, 210, 210);
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Materials");
  colors->SetNumberOfComponents(3);
  Materials materials;
  vtkColor3ub color = none;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string word;
    std::string name;
    words >> word;
    if (word == "mtllib")
    {
      while (words >> name)
      {
        const fs::path library = fs::path(path).parent_path() / name;
        try
        {
          CheckRegular(library.string());
          ReadMaterials(library, materials);
        }
        catch (const Failure& failure)
        {
          notes.push_back(failure.what() + std::string("; there is a plain colour"));
        }
      }
    }
    else if (word == "usemtl" && words >> name)
    {
      const auto found = materials.find(name);
      color = found != materials.end() ? found->second : none;
    }
    else if (word == "f")
    {
      colors->InsertNextTypedTuple(color.GetData());
    }
  }
  if (materials.empty())
  {
    colors->Reset();
  }
  return colors;
}
