// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAtmosphere.h"

#include "vtkGodRaysSetGet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <iterator>

vtkStandardNewMacro(vtkGodRaysAtmosphere);

vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, GroundRadius, 1e3, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, TopHeight, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, RayleighHeight, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, RayleighWidth, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, MieHeight, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, MieWidth, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, OzoneHeight, 1.0, 1e8);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, OzoneWidth, 1.0, 1e8);
vtkGodRaysSetFinite3Macro(vtkGodRaysAtmosphere, MieAsymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphere, SunDistance, 0.01, 1e3);

namespace
{
const char* const PresetNames[] = { "earth-clear", "earth-hazy", "earth-polluted", "mars",
  "lodato-2015" };
const double Wavelengths[3] = { 680.0, 550.0, 440.0 }; // [nm]

bool IsWithin(const double values[3], double high)
{
  return std::all_of(
    values, values + 3, [high](double value) { return value >= 0.0 && value <= high; });
}

void PrintColor(ostream& os, vtkIndent indent, const char* name, const double values[3])
{
  os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n";
}
}

vtkGodRaysAtmosphere::vtkGodRaysAtmosphere()
{
  this->LoadPreset(EARTH_CLEAR);
}

void vtkGodRaysAtmosphere::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GroundRadius: " << this->GroundRadius << "\n";
  os << indent << "TopHeight: " << this->TopHeight << "\n";
  os << indent << "RayleighProfile: " << this->RayleighProfile << "\n";
  os << indent << "RayleighHeight: " << this->RayleighHeight << "\n";
  os << indent << "RayleighWidth: " << this->RayleighWidth << "\n";
  PrintColor(os, indent, "RayleighScattering", this->RayleighScattering);
  os << indent << "MieProfile: " << this->MieProfile << "\n";
  os << indent << "MieHeight: " << this->MieHeight << "\n";
  os << indent << "MieWidth: " << this->MieWidth << "\n";
  PrintColor(os, indent, "MieScattering", this->MieScattering);
  PrintColor(os, indent, "MieAbsorption", this->MieAbsorption);
  os << indent << "OzoneProfile: " << this->OzoneProfile << "\n";
  os << indent << "OzoneHeight: " << this->OzoneHeight << "\n";
  os << indent << "OzoneWidth: " << this->OzoneWidth << "\n";
  PrintColor(os, indent, "OzoneAbsorption", this->OzoneAbsorption);
  os << indent << "MiePhaseFunction: " << this->MiePhaseFunction << "\n";
  PrintColor(os, indent, "MieAsymmetry", this->MieAsymmetry);
  PrintColor(os, indent, "SunIrradiance", this->SunIrradiance);
  os << indent << "SunDistance: " << this->SunDistance << "\n";
  PrintColor(os, indent, "GroundAlbedo", this->GroundAlbedo);
}

double vtkGodRaysAtmosphere::GetRayleighScatteringOf(double wavelength)
{
  return 1.24062e-6 * std::pow(std::max(wavelength, 100.0) / 1000.0, -4.0);
}

void vtkGodRaysAtmosphere::SetAerosol(double depth, double exponent, double scattered)
{
  for (int i = 0; i < 3; ++i)
  {
    const double extinction =
      depth / this->MieHeight * std::pow(Wavelengths[i] / Wavelengths[1], -exponent);
    this->MieScattering[i] = scattered * extinction;
    this->MieAbsorption[i] = (1.0 - scattered) * extinction;
  }
}

void vtkGodRaysAtmosphere::SetMieAsymmetry(double g)
{
  this->SetMieAsymmetry(g, g, g);
}

void vtkGodRaysAtmosphere::LoadPreset(int preset)
{
  if (preset < EARTH_CLEAR || preset > LODATO_2015)
  {
    vtkErrorMacro("There is no preset " << preset << "; there are " << EARTH_CLEAR << " to "
                                        << LODATO_2015 << ".");
    return;
  }
  // Every preset differs from [Bruneton2017].
  this->GroundRadius = 6360e3;
  this->TopHeight = 60e3;
  this->RayleighProfile = EXPONENTIAL;
  this->RayleighHeight = 8000.0;
  this->RayleighWidth = 1000.0;
  this->MieProfile = EXPONENTIAL;
  this->MieHeight = 1200.0;
  this->MieWidth = 1000.0;
  this->OzoneProfile = LAYER;
  this->OzoneHeight = 25e3;
  this->OzoneWidth = 15e3;
  this->MiePhaseFunction = CORNETTE_SHANKS;
  std::fill_n(this->MieAsymmetry, 3, 0.8);
  this->SunDistance = 1.0;
  const double ozone[3] = { 0.650e-6, 1.881e-6, 0.085e-6 };
  const double sun[3] = { 1.474, 1.8504, 1.91198 };
  for (int i = 0; i < 3; ++i)
  {
    this->RayleighScattering[i] = GetRayleighScatteringOf(Wavelengths[i]);
    this->OzoneAbsorption[i] = ozone[i];
    this->SunIrradiance[i] = sun[i];
    this->GroundAlbedo[i] = 0.1;
  }
  this->SetAerosol(0.005328, 0.0, 0.9); // 4.44e-6 1/m in 1200 m

  switch (preset)
  {
    case EARTH_HAZY:
      this->SetAerosol(0.2, 1.3, 0.97);
      std::fill_n(this->MieAsymmetry, 3, 0.7);
      break;
    case EARTH_POLLUTED:
      this->SetAerosol(0.6, 1.3, 0.85);
      std::fill_n(this->MieAsymmetry, 3, 0.65);
      break;
    case MARS:
    {
      this->GroundRadius = 3389.5e3;
      this->TopHeight = 100e3;
      this->SunDistance = 1.5237;
      this->RayleighHeight = this->MieHeight = 11.1e3;
      const double air[3] = { 9.91e-8, 2.32e-7, 5.65e-7 };
      // Dust of [Ehlers2014], by Mie's solution: what it takes away, of that scattered, asymmetry.
      const double extinction[3] = { 1.038, 1.0, 0.979 };
      const double scattered[3] = { 0.955, 0.811, 0.666 };
      const double asymmetry[3] = { 0.718, 0.788, 0.856 };
      const double soil[3] = { 0.30, 0.16, 0.07 };
      for (int i = 0; i < 3; ++i)
      {
        this->RayleighScattering[i] = air[i];
        this->MieScattering[i] = scattered[i] * extinction[i] * 0.5 / this->MieHeight;
        this->MieAbsorption[i] = (1.0 - scattered[i]) * extinction[i] * 0.5 / this->MieHeight;
        this->MieAsymmetry[i] = asymmetry[i];
        this->OzoneAbsorption[i] = 0.0;
        this->GroundAlbedo[i] = soil[i];
        this->SunIrradiance[i] = sun[i] / (this->SunDistance * this->SunDistance);
      }
      break;
    }
    case LODATO_2015:
    {
      const double air[3] = { 5.8e-6, 13.5e-6, 33.1e-6 };
      for (int i = 0; i < 3; ++i)
      {
        this->RayleighScattering[i] = air[i];
        this->MieScattering[i] =
          2e-5 * 1200.0 / 8000.0; // the optical depth of 2e-5, falling over 1200 m
        this->MieAbsorption[i] = 0.0;
        this->OzoneAbsorption[i] = 0.0;
      }
      std::fill_n(this->MieAsymmetry, 3, 0.76);
      this->RayleighProfile = this->MieProfile = UNIFORM;
      this->TopHeight = this->RayleighHeight = this->MieHeight = 8000.0;
      break;
    }
    default:
      break;
  }
  this->Modified();
}

bool vtkGodRaysAtmosphere::LoadPreset(const std::string& name)
{
  const auto found = std::find(std::begin(PresetNames), std::end(PresetNames), name);
  if (found == std::end(PresetNames))
  {
    std::string names;
    for (const char* known : PresetNames)
    {
      names += std::string(names.empty() ? "" : ", ") + known;
    }
    vtkErrorMacro("There is no atmosphere \"" << name << "\"; there are " << names << ".");
    return false;
  }
  this->LoadPreset(static_cast<int>(found - std::begin(PresetNames)));
  return true;
}

std::string vtkGodRaysAtmosphere::FindFault() const
{
  if (!IsWithin(this->RayleighScattering, 1.0) || !IsWithin(this->MieScattering, 1.0) ||
    !IsWithin(this->MieAbsorption, 1.0) || !IsWithin(this->OzoneAbsorption, 1.0))
  {
    return "a coefficient of the atmosphere is out of range. Set RayleighScattering, "
           "MieScattering, "
           "MieAbsorption and OzoneAbsorption to numbers in [0, 1].";
  }
  if (!IsWithin(this->SunIrradiance, 1e30))
  {
    return "the sun's irradiance is out of range. Set SunIrradiance to numbers in [0, 1e30].";
  }
  if (!IsWithin(this->GroundAlbedo, 1.0))
  {
    return "the ground's albedo is out of range. Set GroundAlbedo to numbers in [0, 1].";
  }
  return {};
}
