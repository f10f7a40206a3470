// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAtmosphereModel.h"

#include "vtkCommand.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysSetGet.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysAtmosphereModel);

vtkGodRaysSetFinite3Macro(vtkGodRaysAtmosphereModel, RayleighScattering, 0.0, 1e15);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphereModel, RayleighScaleHeight, 1e-6, 1e9);
vtkGodRaysSetFinite3Macro(vtkGodRaysAtmosphereModel, MieScattering, 0.0, 1e15);
vtkGodRaysSetFinite3Macro(vtkGodRaysAtmosphereModel, MieAbsorption, 0.0, 1e15);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphereModel, MieScaleHeight, 1e-6, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphereModel, MieAsymmetry, -0.99, 0.99);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphereModel, GroundLevel, -1e30, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysAtmosphereModel, PlanetRadius, 0.0, 1e15);

vtkGodRaysAtmosphereModel::vtkGodRaysAtmosphereModel()
{
  vtkNew<vtkGodRaysAtmosphere> earth;
  this->Take(earth);
}

vtkGodRaysAtmosphereModel::~vtkGodRaysAtmosphereModel()
{
  this->SetAtmosphere(nullptr);
}

void vtkGodRaysAtmosphereModel::SetAtmosphere(vtkGodRaysAtmosphere* atmosphere)
{
  if (this->Atmosphere == atmosphere)
  {
    return;
  }
  if (this->Atmosphere)
  {
    this->Atmosphere->RemoveObserver(this->Observer);
  }
  this->Atmosphere = atmosphere;
  if (atmosphere)
  {
    this->Observer =
      atmosphere->AddObserver(vtkCommand::ModifiedEvent, this, &vtkGodRaysAtmosphereModel::Follow);
    this->Follow();
  }
  this->Modified();
}

vtkGodRaysAtmosphere* vtkGodRaysAtmosphereModel::GetAtmosphere()
{
  return this->Atmosphere;
}

void vtkGodRaysAtmosphereModel::Follow()
{
  this->Take(this->Atmosphere);
}

void vtkGodRaysAtmosphereModel::Take(vtkGodRaysAtmosphere* atmosphere)
{
  this->SetRayleighScattering(atmosphere->GetRayleighScattering());
  this->SetRayleighScaleHeight(atmosphere->GetRayleighHeight());
  this->SetMieScattering(atmosphere->GetMieScattering());
  this->SetMieAbsorption(atmosphere->GetMieAbsorption());
  this->SetMieScaleHeight(atmosphere->GetMieHeight());
  this->SetMieAsymmetry(atmosphere->GetMieAsymmetry()[1]);
}

void vtkGodRaysAtmosphereModel::SetUp(const double direction[3])
{
  const double length = vtkMath::Norm(direction);
  if (!(length > 0.0) || !vtkMath::IsFinite(length))
  {
    vtkErrorMacro("Up must be a direction, not "
      << direction[0] << " " << direction[1] << " " << direction[2] << "; it stays " << this->Up[0]
      << " " << this->Up[1] << " " << this->Up[2] << ".");
    return;
  }
  if (!std::equal(direction, direction + 3, this->Up))
  {
    std::copy_n(direction, 3, this->Up);
    this->Modified();
  }
}

void vtkGodRaysAtmosphereModel::SetUp(double x, double y, double z)
{
  const double direction[3] = { x, y, z };
  this->SetUp(direction);
}

void vtkGodRaysAtmosphereModel::FillMedium(
  vtkGodRaysMedium& medium, const double worldToView[16]) const
{
  medium.NumberOfComponents = 2;
  vtkGodRaysMedium::Component& molecules = medium.Components[0];
  std::copy_n(this->RayleighScattering, 3, molecules.Scattering);
  molecules.PhaseFunction = RAYLEIGH;
  molecules.ScaleHeight = this->RayleighScaleHeight;
  vtkGodRaysMedium::Component& aerosols = medium.Components[1];
  std::copy_n(this->MieScattering, 3, aerosols.Scattering);
  std::copy_n(this->MieAbsorption, 3, aerosols.Absorption);
  aerosols.PhaseFunction = CORNETTE_SHANKS;
  aerosols.Asymmetry = this->MieAsymmetry;
  aerosols.ScaleHeight = this->MieScaleHeight;

  // A view is the world, turned and then moved by the last column; the eye is its origin.
  double up[3] = { this->Up[0], this->Up[1], this->Up[2] };
  vtkMath::Normalize(up);
  double place[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      place[k] -= this->GetUnit() * worldToView[4 * i + k] * worldToView[4 * i + 3];
    }
  }
  medium.PlanetRadius = this->PlanetRadius;
  double vertical[3];
  medium.PlaceEye(place, up, this->GetUnit() * this->GroundLevel, vertical);
  for (int i = 0; i < 3; ++i)
  {
    medium.Up[i] = vtkMath::Dot(worldToView + 4 * i, vertical);
  }
}

std::string vtkGodRaysAtmosphereModel::Describe() const
{
  std::ostringstream text;
  const auto print = [&text](const double* values)
  { text << values[0] << " " << values[1] << " " << values[2]; };
  text << "atmosphere over a " << (this->PlanetRadius > 0.0 ? "planet" : "plane") << ", molecules ";
  print(this->RayleighScattering);
  text << " [1/m], scale height " << this->RayleighScaleHeight << " m, aerosols ";
  print(this->MieScattering);
  text << " [1/m], scale height " << this->MieScaleHeight << " m, g " << this->MieAsymmetry
       << (this->AttenuateScene ? ", the scene is dimmed" : ", the scene is not dimmed");
  return text.str();
}

void vtkGodRaysAtmosphereModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double* values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  os << indent << "Atmosphere: " << this->Atmosphere.Get() << "\n";
  print("RayleighScattering", this->RayleighScattering);
  os << indent << "RayleighScaleHeight: " << this->RayleighScaleHeight << "\n";
  print("MieScattering", this->MieScattering);
  print("MieAbsorption", this->MieAbsorption);
  os << indent << "MieScaleHeight: " << this->MieScaleHeight << "\n";
  os << indent << "MieAsymmetry: " << this->MieAsymmetry << "\n";
  print("Up", this->Up);
  os << indent << "GroundLevel: " << this->GroundLevel << "\n";
  os << indent << "PlanetRadius: " << this->PlanetRadius << "\n";
}
