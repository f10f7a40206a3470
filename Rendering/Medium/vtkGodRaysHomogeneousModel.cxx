// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysHomogeneousModel.h"

#include "vtkGodRaysMedium.h"
#include "vtkGodRaysPresetTable.h"
#include "vtkGodRaysSetGet.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysHomogeneousModel);

vtkGodRaysSetFiniteMacro(vtkGodRaysHomogeneousModel, OpticalDepth, 0.0, 100.0);
vtkGodRaysSetFinite3AndMacro(
  vtkGodRaysHomogeneousModel, ScatteringCoefficient, 0.0, 1e15, this->OpticalDepth = 0.0);
vtkGodRaysSetFinite3AndMacro(
  vtkGodRaysHomogeneousModel, AbsorptionCoefficient, 0.0, 1e15, this->OpticalDepth = 0.0);
vtkGodRaysSetModeMacro(vtkGodRaysHomogeneousModel, PhaseFunction, vtkGodRaysLastPhaseFunction);
vtkGodRaysSetFiniteMacro(vtkGodRaysHomogeneousModel, Asymmetry, -0.99, 0.99);
vtkGodRaysSetModeMacro(
  vtkGodRaysHomogeneousModel, SecondPhaseFunction, vtkGodRaysLastPhaseFunction);
vtkGodRaysSetFiniteMacro(vtkGodRaysHomogeneousModel, SecondAsymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysHomogeneousModel, SecondWeight, 0.0, 1.0);

namespace
{
const double LeftOverDepth = -std::log(0.05); // optical depth over which 5 % of a contrast is left

struct Preset
{
  const char* Name;
  const char* Description;
  double Scattering[3];
  double Absorption[3];
  int PhaseFunction;
  double Asymmetry;
  double OpticalDepth; // across a scene of which nobody said how large it is
};

const Preset Presets[] = {
  { "clear-air", "molecules alone, at sea level; shows over kilometres",
    { 5.802e-6, 13.558e-6, 33.1e-6 }, { 0.0, 0.0, 0.0 }, vtkGodRaysMediumModel::RAYLEIGH, 0.0,
    0.15 },
  { "haze", "a visibility of 4 km", { 7.49e-4, 7.49e-4, 7.49e-4 }, { 0.0, 0.0, 0.0 },
    vtkGodRaysMediumModel::HENYEY_GREENSTEIN, 0.9, 0.3 },
  { "fog", "a visibility of 200 m", { 1.5e-2, 1.5e-2, 1.5e-2 }, { 0.0, 0.0, 0.0 },
    vtkGodRaysMediumModel::HENYEY_GREENSTEIN, 0.85, 0.6 },
  { "dust", "10 mg of coarse dust a cubic metre", { 5.64e-3, 5.28e-3, 4.56e-3 },
    { 3.6e-4, 7.2e-4, 1.44e-3 }, vtkGodRaysMediumModel::HENYEY_GREENSTEIN, 0.67, 0.5 },
  { "smoke", "of burning grass and wood, a visibility of 1 km", { 1.71e-3, 2.58e-3, 3.93e-3 },
    { 3.3e-4, 4.2e-4, 5.4e-4 }, vtkGodRaysMediumModel::HENYEY_GREENSTEIN, 0.6, 0.4 },
  { "sea-water", "coastal water, which swallows red", { 0.219, 0.219, 0.219 },
    { 0.61, 0.20, 0.151 }, vtkGodRaysMediumModel::HENYEY_GREENSTEIN, 0.924, 0.4 },
};
}

void vtkGodRaysHomogeneousModel::SetVisibility(double meters)
{
  if (!(meters > 0.0) || !std::isfinite(meters))
  {
    vtkErrorMacro("Visibility must be a number above 0, not " << meters << "; it stays "
                                                              << this->GetVisibility() << ".");
    return;
  }
  this->SetOpticalDepth(0.0);
  const double wanted = LeftOverDepth / std::min(std::max(meters, 1e-9), 1e12);
  const double now = this->ScatteringCoefficient[1] + this->AbsorptionCoefficient[1];
  if (!(now > 0.0))
  {
    this->SetScatteringCoefficient(wanted, wanted, wanted);
    return;
  }
  const double factor = wanted / now;
  double scattering[3];
  double absorption[3];
  for (int i = 0; i < 3; ++i)
  {
    scattering[i] = factor * this->ScatteringCoefficient[i];
    absorption[i] = factor * this->AbsorptionCoefficient[i];
  }
  this->SetScatteringCoefficient(scattering);
  this->SetAbsorptionCoefficient(absorption);
}

double vtkGodRaysHomogeneousModel::GetVisibility()
{
  const double extinction = this->ScatteringCoefficient[1] + this->AbsorptionCoefficient[1];
  return extinction > 0.0 ? LeftOverDepth / extinction : vtkMath::Inf();
}

int vtkGodRaysHomogeneousModel::GetNumberOfPresets()
{
  return static_cast<int>(std::size(Presets));
}

const char* vtkGodRaysHomogeneousModel::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Presets[index].Name : nullptr;
}

const char* vtkGodRaysHomogeneousModel::GetPresetDescription(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Presets[index].Description : nullptr;
}

bool vtkGodRaysHomogeneousModel::ApplyPreset(const char* name)
{
  const Preset* found = vtkGodRaysFindPreset(this, Presets, name);
  if (!found)
  {
    return false;
  }
  this->SetScatteringCoefficient(found->Scattering);
  this->SetAbsorptionCoefficient(found->Absorption);
  this->SetPhaseFunction(found->PhaseFunction);
  this->SetAsymmetry(found->Asymmetry);
  this->SetSecondWeight(0.0);
  this->SetOpticalDepth(found->OpticalDepth);
  return true;
}

double vtkGodRaysHomogeneousModel::GetScale(const vtkGodRaysMedium& medium, double diagonal) const
{
  const vtkGodRaysMedium::Component& component = medium.Components[0];
  const double depth = (component.Scattering[1] + component.Absorption[1]) * diagonal;
  return this->OpticalDepth > 0.0 && depth > 0.0 ? this->OpticalDepth / depth : 1.0;
}

void vtkGodRaysHomogeneousModel::FillMedium(vtkGodRaysMedium& medium, const double*) const
{
  medium.NumberOfComponents = 1;
  vtkGodRaysMedium::Component& component = medium.Components[0];
  std::copy_n(this->ScatteringCoefficient, 3, component.Scattering);
  std::copy_n(this->AbsorptionCoefficient, 3, component.Absorption);
  component.PhaseFunction = this->PhaseFunction;
  component.Asymmetry = this->Asymmetry;
  component.SecondPhaseFunction = this->SecondPhaseFunction;
  component.SecondAsymmetry = this->SecondAsymmetry;
  component.SecondWeight = this->SecondWeight;
  component.ScaleHeight = 0.0;
}

std::string vtkGodRaysHomogeneousModel::Describe() const
{
  std::ostringstream text;
  const double* s = this->ScatteringCoefficient;
  const double* a = this->AbsorptionCoefficient;
  text << "homogeneous medium, scattering " << s[0] << " " << s[1] << " " << s[2] << ", absorption "
       << a[0] << " " << a[1] << " " << a[2] << " [1/m], "
       << vtkGodRaysPhaseFunctions[this->PhaseFunction].Name;
  if (vtkGodRaysPhaseFunctions[this->PhaseFunction].HasAsymmetry)
  {
    text << " " << this->Asymmetry;
  }
  if (this->SecondWeight > 0.0)
  {
    text << " and " << this->SecondWeight << " of "
         << vtkGodRaysPhaseFunctions[this->SecondPhaseFunction].Name;
  }
  text << (this->AttenuateScene ? ", the scene is dimmed" : ", the scene is not dimmed");
  return text.str();
}

void vtkGodRaysHomogeneousModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double* values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  print("ScatteringCoefficient", this->ScatteringCoefficient);
  print("AbsorptionCoefficient", this->AbsorptionCoefficient);
  os << indent << "OpticalDepth: " << this->OpticalDepth << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "Asymmetry: " << this->Asymmetry << "\n";
  os << indent << "SecondPhaseFunction: " << this->SecondPhaseFunction << "\n";
  os << indent << "SecondAsymmetry: " << this->SecondAsymmetry << "\n";
  os << indent << "SecondWeight: " << this->SecondWeight << "\n";
}
