// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialModel.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPresetTable.h"
#include "vtkGodRaysSetGet.h"
#include "vtkObjectFactory.h"

#include <cmath>
#include <iterator>

vtkStandardNewMacro(vtkGodRaysRadialModel);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Reach, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Streaks, 0.0, 0.5);

namespace
{
struct Preset
{
  const char* Name;
  const char* Description;
  double Density;
  double Decay;
  double Weight;
  double Exposure;
  int NumberOfSamples;
  double Reach;
  double Streaks;
};

const Preset Presets[] = {
  { "default", "Crisp shafts, for any scene", 0.97, 1.0, 0.013, 1.0, 100, 0.75, 0.22 },
  { "low-sun", "A fan of fine, long rays of a sun near the horizon", 1.0, 0.97, 0.041, 1.0, 100,
    3.0, 0.33 },
  { "long-shafts", "Even light, and shafts to the edges of the picture", 1.0, 1.015, 0.0028, 1.0,
    100, 0.0, 0.22 },
  { "cathedral", "Broad beams that cross a tall room", 1.2, 0.985, 0.016, 1.0, 100, 0.9, 0.1 },
  { "soft-haze", "Short shafts that melt into a haze", 0.85, 0.97, 0.041, 1.0, 100, 0.6, 0.0 },
  { "halo", "A glow about the light, with short shafts in it", 0.7, 0.96, 0.09, 1.0, 100, 0.3,
    0.0 },
};
}

void vtkGodRaysRadialModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Streaks: " << this->Streaks << "\n";
}

bool vtkGodRaysRadialModel::ApplyPreset(const char* name)
{
  const Preset* preset = vtkGodRaysFindPreset(this, Presets, name);
  if (preset)
  {
    this->SetParameters(
      preset->Density, preset->Decay, preset->Weight, preset->Exposure, preset->NumberOfSamples);
    this->SetReach(preset->Reach);
    this->SetStreaks(preset->Streaks);
  }
  return preset != nullptr;
}

int vtkGodRaysRadialModel::GetNumberOfPresets()
{
  return static_cast<int>(std::size(Presets));
}

const char* vtkGodRaysRadialModel::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Presets[index].Name : nullptr;
}

const char* vtkGodRaysRadialModel::GetPresetDescription(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Presets[index].Description : nullptr;
}

void vtkGodRaysRadialModel::GetTapSums(std::vector<vtkGodRays::TapSum>& passes, int taps) const
{
  const int count = taps > 0 ? taps : this->NumberOfSamples;
  const double ratio = static_cast<double>(this->NumberOfSamples) / count;
  vtkGodRays::TapSum sum = {};
  sum.FirstTap = 1;
  sum.LastTap = count;
  sum.TapOffset = 0.5;
  sum.FirstWeight = this->Weight * vtkGodRays::GeometricSum(this->Decay, ratio);
  sum.Decay = std::pow(this->Decay, ratio);
  sum.Step = this->Density / count;
  sum.InputGain = 1.0;
  sum.OutputGain = this->Exposure;
  passes.assign(1, sum);
}

std::string vtkGodRaysRadialModel::Describe() const
{
  return "radial sum: " + this->DescribeParameters();
}
