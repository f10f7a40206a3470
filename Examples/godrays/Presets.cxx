// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Failure.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkNew.h"

#include <algorithm>

namespace
{
template <typename Model>
void AddPresets(std::vector<Preset>& presets, bool isMedium)
{
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    presets.push_back({ Model::GetPresetName(i), Model::GetPresetDescription(i), isMedium });
  }
}
}

//------------------------------------------------------------------------------
const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = []
  {
    std::vector<Preset> all;
    AddPresets<vtkGodRaysRadialModel>(all, false);
    AddPresets<vtkGodRaysHomogeneousModel>(all, true);
    return all;
  }();
  return presets;
}

//------------------------------------------------------------------------------
const Preset& FindPreset(const std::string& name)
{
  std::string names;
  for (const Preset& preset : GetPresets())
  {
    if (preset.Name == name)
    {
      return preset;
    }
    names += (names.empty() ? "" : ", ") + preset.Name;
  }
  throw Failure("--preset: '" + name + "' should be one of " + names);
}

//------------------------------------------------------------------------------
void ApplyPreset(const Preset& preset, vtkGodRaysPass* rays)
{
  const bool hasMedium = vtkGodRaysHomogeneousModel::SafeDownCast(rays->GetModel());
  if (preset.IsMedium && !hasMedium)
  {
    vtkNew<vtkGodRaysHomogeneousModel> medium;
    rays->SetModel(medium);
  }
  else if (!preset.IsMedium && hasMedium)
  {
    rays->SetModel(nullptr);
  }
  rays->ApplyPreset(preset.Name.c_str());
}
