// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPresets.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkGodRaysPresets);

namespace
{
struct Preset
{
  std::string Name;
  const char* NameInModel;
  const char* Description;
  bool (*Fits)(vtkGodRaysModel*);
  vtkGodRaysModel* (*MakeModel)();
};

template <typename Model>
void AddPresets(std::vector<Preset>& presets, const std::string& prefix = "")
{
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    presets.push_back(
      { prefix + Model::GetPresetName(i), Model::GetPresetName(i), Model::GetPresetDescription(i),
        [](vtkGodRaysModel* model) { return Model::SafeDownCast(model) != nullptr; },
        []() -> vtkGodRaysModel* { return Model::New(); } });
  }
}

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = []
  {
    std::vector<Preset> all;
    AddPresets<vtkGodRaysRadialModel>(all);
    AddPresets<vtkGodRaysHomogeneousModel>(all);
    AddPresets<vtkGodRaysPublishedModel>(all, "published:");
    return all;
  }();
  return presets;
}

const Preset* FindPreset(const char* name)
{
  const std::vector<Preset>& presets = GetPresets();
  const auto found = std::find_if(presets.begin(), presets.end(),
    [name](const Preset& preset) { return name && preset.Name == name; });
  return found != presets.end() ? &*found : nullptr;
}
}

int vtkGodRaysPresets::GetNumberOfPresets()
{
  return static_cast<int>(GetPresets().size());
}

const char* vtkGodRaysPresets::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? GetPresets()[index].Name.c_str() : nullptr;
}

const char* vtkGodRaysPresets::GetPresetDescription(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? GetPresets()[index].Description : nullptr;
}

std::string vtkGodRaysPresets::ListNames()
{
  std::string names;
  for (const Preset& preset : GetPresets())
  {
    names += (names.empty() ? "" : ", ") + preset.Name;
  }
  return names;
}

vtkGodRaysModel* vtkGodRaysPresets::NewModel(const char* name)
{
  const Preset* preset = FindPreset(name);
  vtkGodRaysModel* model = preset ? preset->MakeModel() : nullptr;
  if (model)
  {
    model->ApplyPreset(preset->NameInModel);
  }
  return model;
}

bool vtkGodRaysPresets::ApplyTo(vtkGodRaysModel* model, const char* name)
{
  const Preset* preset = FindPreset(name);
  return preset && preset->Fits(model) && model->ApplyPreset(preset->NameInModel);
}

void vtkGodRaysPresets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
