// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPresets.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkObjectFactory.h"

#include <vector>

vtkStandardNewMacro(vtkGodRaysPresets);

namespace
{
struct Preset
{
  const char* Name;
  const char* Description;
  vtkGodRaysModel* (*MakeModel)();
};

template <typename Model>
void AddPresets(std::vector<Preset>& presets)
{
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    presets.push_back({ Model::GetPresetName(i), Model::GetPresetDescription(i),
      []() -> vtkGodRaysModel* { return Model::New(); } });
  }
}

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = []
  {
    std::vector<Preset> all;
    AddPresets<vtkGodRaysRadialModel>(all);
    AddPresets<vtkGodRaysPublishedModel>(all);
    AddPresets<vtkGodRaysHomogeneousModel>(all);
    return all;
  }();
  return presets;
}
}

//------------------------------------------------------------------------------
int vtkGodRaysPresets::GetNumberOfPresets()
{
  return static_cast<int>(GetPresets().size());
}

//------------------------------------------------------------------------------
const char* vtkGodRaysPresets::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? GetPresets()[index].Name : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkGodRaysPresets::GetPresetDescription(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? GetPresets()[index].Description : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkGodRaysPresets::ListNames()
{
  std::string names;
  for (const Preset& preset : GetPresets())
  {
    names += std::string(names.empty() ? "" : ", ") + preset.Name;
  }
  return names;
}

//------------------------------------------------------------------------------
vtkGodRaysModel* vtkGodRaysPresets::NewModel(const char* name)
{
  const std::string wanted = name ? name : "";
  for (const Preset& preset : GetPresets())
  {
    if (wanted == preset.Name)
    {
      vtkGodRaysModel* model = preset.MakeModel();
      model->ApplyPreset(name);
      return model;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkGodRaysPresets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
