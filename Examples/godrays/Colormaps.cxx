// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormaps.h"

#include "vtkColorTransferFunction.h"

#include <algorithm>
#include <map>
#include <vector>

namespace
{
struct Node
{
  double Position;
  double Red, Green, Blue;
};
using Nodes = std::vector<Node>;

//------------------------------------------------------------------------------
Nodes Even(const std::vector<unsigned int>& colors)
{
  Nodes nodes;
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const unsigned int color = colors[i];
    nodes.push_back({ i / (colors.size() - 1.0), (color >> 16) / 255.0,
      ((color >> 8) & 0xff) / 255.0, (color & 0xff) / 255.0 });
  }
  return nodes;
}

//------------------------------------------------------------------------------
const std::map<std::string, Nodes>& Maps()
{
  static const std::map<std::string, Nodes> maps = {
    { "viridis",
      Even({ 0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30,
        0xfde725 }) },
    { "inferno",
      Even({ 0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754, 0xe45a31, 0xf98e09, 0xf9cb35,
        0xfcffa4 }) },
    { "plasma",
      Even({ 0x0d0887, 0x4c02a1, 0x7e03a8, 0xaa2395, 0xcc4778, 0xe66c5c, 0xf89540, 0xfdc527,
        0xf0f921 }) },
    { "cividis",
      Even({ 0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369,
        0xfee838 }) },
    { "coolwarm", Even({ 0x3b4cc0, 0x8db0fe, 0xdddddd, 0xf49a7b, 0xb40426 }) },
    { "grey", Even({ 0x000000, 0xffffff }) },
    { "terrain", // land; the sea is put before it
      Even({ 0x4d6b45, 0x7f8f57, 0xb5a878, 0x9c7d58, 0x80654f, 0xa39a92, 0xf2f0ee }) },
  };
  return maps;
}

const Nodes& Sea()
{
  static const Nodes sea = Even({ 0x10243f, 0x1d4a6e, 0x3a7d97, 0x7fb0b0 });
  return sea;
}

//------------------------------------------------------------------------------
void AddNodes(vtkColorTransferFunction* colors, const Nodes& nodes, double low, double high)
{
  for (const Node& node : nodes)
  {
    colors->AddRGBPoint(low + node.Position * (high - low), node.Red, node.Green, node.Blue);
  }
}
}

//------------------------------------------------------------------------------
bool HasColormap(const std::string& name)
{
  return Maps().count(name) > 0;
}

//------------------------------------------------------------------------------
std::string GetColormapNames(const std::string& between)
{
  std::string names;
  for (const auto& [name, nodes] : Maps())
  {
    names += (names.empty() ? "" : between) + name;
  }
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& name, const double range[2])
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  colors->SetColorSpaceToLab();
  colors->SetNanColor(0.5, 0.5, 0.5);
  const double low = range[0];
  const double high = std::max(range[1], low + 1e-30);
  if (name == "terrain" && low < 0.0 && high > 0.0)
  {
    AddNodes(colors, Sea(), low, 0.0);
    AddNodes(colors, Maps().at(name), 1e-6 * (high - low), high);
  }
  else
  {
    AddNodes(colors, Maps().at(name), low, high);
  }
  return colors;
}
