// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Failure.h"
#include "Suggestions.h"
#include "Values.h"

#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysPresets.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkSmartPointer.h"

//------------------------------------------------------------------------------
const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = []
  {
    std::vector<Preset> all;
    for (int i = 0; i < vtkGodRaysPresets::GetNumberOfPresets(); ++i)
    {
      const char* name = vtkGodRaysPresets::GetPresetName(i);
      const auto model = vtk::TakeSmartPointer(vtkGodRaysPresets::NewModel(name));
      all.push_back({ name, vtkGodRaysPresets::GetPresetDescription(i),
        vtkGodRaysMediumModel::SafeDownCast(model) != nullptr,
        vtkGodRaysPublishedModel::SafeDownCast(model) != nullptr });
    }
    return all;
  }();
  return presets;
}

//------------------------------------------------------------------------------
const Preset& FindPreset(const std::string& name)
{
  std::vector<std::string> all;
  for (const Preset& preset : GetPresets())
  {
    if (preset.Name == name)
    {
      return preset;
    }
    all.push_back(preset.Name);
  }
  throw Failure(
    "--preset: '" + name + "' should be one of " + Join(all, ", ") + Suggest(name, all));
}
