// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coloring.h"

#include "Colormaps.h"
#include "Failure.h"
#include "Outliers.h"
#include "Values.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double LightGrey = 0.82;

//------------------------------------------------------------------------------
bool LooksLikeValues(vtkDataSetAttributes* attributes, vtkDataArray* array)
{
  const bool hasOtherUse = array == attributes->GetNormals() || array == attributes->GetTCoords() ||
    array == attributes->GetGlobalIds() || array == attributes->GetPedigreeIds() ||
    array == attributes->GetTangents() ||
    (array->GetNumberOfComponents() == 2 && array->GetDataType() == VTK_FLOAT); // coordinates
  const std::string name = array->GetName() ? array->GetName() : "";
  return !hasOtherUse && !name.empty() && name.rfind("vtk", 0) != 0 && name != "Normals" &&
    name != "STLSolidLabeling";
}

//------------------------------------------------------------------------------
vtkDataArray* FindFirst(vtkDataSetAttributes* attributes)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && LooksLikeValues(attributes, array))
    {
      return array;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* FindActive(vtkDataSetAttributes* attributes)
{
  vtkDataArray* scalars = attributes->GetScalars();
  return scalars && LooksLikeValues(attributes, scalars) ? scalars : nullptr;
}

//------------------------------------------------------------------------------
std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

//------------------------------------------------------------------------------
bool NamesElevation(const std::string& name)
{
  const std::string lower = LowerCase(name);
  const auto has = [&lower](const char* word) { return lower.find(word) != std::string::npos; };
  return has("elevation") || has("altitude") || has("topo") || has("height") || lower == "dem";
}
}

//------------------------------------------------------------------------------
std::string ColorArray::GetName() const
{
  return this->Array && this->Array->GetName() ? this->Array->GetName() : "";
}

//------------------------------------------------------------------------------
bool ColorArray::IsColor() const
{
  return this->Array && this->Array->GetDataType() == VTK_UNSIGNED_CHAR &&
    this->Array->GetNumberOfComponents() >= 3;
}

//------------------------------------------------------------------------------
Coloring::Coloring(const Options& options)
  : Settings(options)
{
}

//------------------------------------------------------------------------------
ColorArray Coloring::Choose(vtkDataSet* data)
{
  vtkDataSetAttributes* both[2] = { data->GetPointData(), data->GetCellData() };
  for (vtkDataSetAttributes* attributes : both)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && LooksLikeValues(attributes, array))
      {
        this->Seen.insert(array->GetName());
      }
    }
  }
  ColorArray choice;
  const std::string& wanted = this->Settings.Scalars;
  const auto choose = [&](auto find)
  {
    for (int i = 0; i < 2 && !choice.Array; ++i)
    {
      choice = { find(both[i]), i == 1 };
    }
  };
  if (!wanted.empty())
  {
    choose([&wanted](auto* attributes) { return attributes->GetArray(wanted.c_str()); });
    this->Found = this->Found || choice.Array;
  }
  else if (!this->Settings.Color)
  {
    choose(FindActive);
    choose(FindFirst);
  }
  return choice;
}

//------------------------------------------------------------------------------
bool Coloring::AddToRange(const ColorArray& choice)
{
  if (!choice.Array || choice.IsColor())
  {
    return false;
  }
  double range[2];
  const bool hasOutliers =
    FindUsualRange(choice.Array, choice.Array->GetNumberOfComponents() > 1 ? -1 : 0, range);
  if (range[0] <= range[1])
  {
    const std::array<double, 2> values = { range[0], range[1] };
    auto& total = this->Ranges.try_emplace(choice.GetName(), values).first->second;
    total = { std::min(total[0], range[0]), std::max(total[1], range[1]) };
  }
  return hasOutliers;
}

//------------------------------------------------------------------------------
bool Coloring::TellsNothing(const ColorArray& choice) const
{
  const Options& options = this->Settings;
  const auto found = this->Ranges.find(choice.GetName());
  return found != this->Ranges.end() && found->second[0] == found->second[1] && !options.Range &&
    options.Scalars.empty() && options.Colormap.empty() && options.Colors.empty();
}

//------------------------------------------------------------------------------
void Coloring::SetTerrain(const std::string& name, bool onlyIfNamed)
{
  if (!onlyIfNamed || NamesElevation(name))
  {
    this->Terrain.insert(name);
  }
}

//------------------------------------------------------------------------------
void Coloring::GetRange(const std::string& name, double range[2]) const
{
  const auto found = this->Ranges.find(name);
  const std::array<double, 2> none = { 0.0, 1.0 };
  const auto& used = this->Settings.Range ? *this->Settings.Range
    : found == this->Ranges.end()         ? none
                                          : found->second;
  std::copy(used.begin(), used.end(), range);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> Coloring::MakeColors(const std::string& name) const
{
  double range[2];
  this->GetRange(name, range);
  const auto& own = this->Settings.Colors;
  if (!own.empty())
  {
    auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
    const double step =
      (range[1] - range[0]) / std::max(static_cast<double>(own.size()) - 1.0, 1.0);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      colors->AddRGBPoint(
        range[0] + step * static_cast<double>(i), own[i][0], own[i][1], own[i][2]);
    }
    return colors;
  }
  const bool terrain = this->Terrain.count(name) > 0;
  const std::string map = !this->Settings.Colormap.empty() ? this->Settings.Colormap
    : terrain                                              ? "terrain"
                                                           : "viridis";
  return MakeColormap(map, range);
}

//------------------------------------------------------------------------------
void Coloring::Apply(const ColorArray& choice, vtkActor* actor) const
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  const Vector3 color = this->Settings.Color.value_or(Vector3{ LightGrey, LightGrey, LightGrey });
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  mapper->SetScalarVisibility(choice.Array != nullptr);
  if (!choice.Array)
  {
    return;
  }
  if (choice.OfCells)
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  else
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  mapper->SelectColorArray(choice.GetName().c_str());
  mapper->SetColorModeToDefault();
  if (!choice.IsColor())
  {
    auto colors = this->MakeColors(choice.GetName());
    if (choice.Array->GetNumberOfComponents() > 1)
    {
      colors->SetVectorModeToMagnitude();
    }
    mapper->SetLookupTable(colors);
    mapper->UseLookupTableScalarRangeOn();
    // Spheres are drawn in colours of their vertices alone.
    mapper->SetInterpolateScalarsBeforeMapping(
      !choice.OfCells && !vtkOpenGLSphereMapper::SafeDownCast(mapper));
    mapper->SetColorModeToMapScalars();
  }
}

//------------------------------------------------------------------------------
void Coloring::CheckFound() const
{
  if (this->Settings.Scalars.empty() || this->Settings.Scalars == "none" || this->Found)
  {
    return;
  }
  const std::string names = Join({ this->Seen.begin(), this->Seen.end() }, ", ");
  throw Failure("--scalars: there is no array '" + this->Settings.Scalars + "'; " +
    (names.empty() ? "there are none" : "there are " + names));
}
