// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace
{
struct Point
{
  double Value; // Hounsfield units: air -1000, fat -100, water 0, muscle 50, bone from 300
  double Opacity;
  double Color[3];
};

struct VolumePreset
{
  const char* Name;
  std::vector<Point> Points;
};

const std::vector<VolumePreset>& GetTable()
{
  constexpr double skin[3] = { 0.85, 0.62, 0.50 };
  constexpr double muscle[3] = { 0.62, 0.25, 0.20 };
  constexpr double bone[3] = { 0.95, 0.93, 0.84 };
  constexpr double lung[3] = { 0.75, 0.55, 0.50 };
  const auto at = [](double value, double opacity, const double* color) {
    return Point{ value, opacity, { color[0], color[1], color[2] } };
  };
  static const std::vector<VolumePreset> table = {
    { "ct-bone", { at(150, 0.0, bone), at(300, 0.4, bone), at(1200, 0.95, bone) } },
    { "ct-skin", { at(-500, 0.0, skin), at(-200, 0.7, skin), at(300, 0.9, skin) } },
    { "ct-skin-bone",
      { at(-500, 0.0, skin), at(-300, 0.06, skin), at(-150, 0.06, skin), at(0, 0.01, muscle),
        at(150, 0.01, muscle), at(300, 0.5, bone), at(1200, 0.95, bone) } },
    { "ct-muscle",
      { at(-150, 0.0, skin), at(0, 0.1, muscle), at(100, 0.5, muscle), at(300, 0.8, bone) } },
    { "ct-lung",
      { at(-950, 0.0, lung), at(-800, 0.1, lung), at(-500, 0.1, lung), at(-400, 0.0, lung),
        at(250, 0.0, bone), at(400, 0.5, bone) } },
  };
  return table;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetVolumePresets()
{
  std::vector<std::string> names;
  for (const VolumePreset& preset : GetTable())
  {
    names.emplace_back(preset.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
void ApplyVolumePreset(const std::string& name, double opacity, vtkVolumeProperty* property)
{
  for (const VolumePreset& preset : GetTable())
  {
    if (name != preset.Name)
    {
      continue;
    }
    vtkNew<vtkPiecewiseFunction> opacities;
    vtkNew<vtkColorTransferFunction> colors;
    for (const Point& point : preset.Points)
    {
      opacities->AddPoint(point.Value, opacity * point.Opacity);
      colors->AddRGBPoint(point.Value, point.Color[0], point.Color[1], point.Color[2]);
    }
    property->SetScalarOpacity(opacities);
    property->SetColor(colors);
  }
}
