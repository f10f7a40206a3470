// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkySource.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkGodRaysKronrod.h"
#include "vtkGodRaysMemory.h"
#include "vtkGodRaysProgress.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkGodRaysSkyIntegrator.h"
#include "vtkGodRaysSun.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkGodRaysSkySource);

vtkGodRaysSetFiniteMacro(vtkGodRaysSkySource, ObserverHeight, 0.0, 1e12);
vtkGodRaysSetFiniteMacro(vtkGodRaysSkySource, Tolerance, 1e-10, 0.1);

using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

// The directions of pixels, and their radiance.
class vtkGodRaysSkySource::vtkInternals
{
public:
  void Prepare(vtkGodRaysSkySource* source)
  {
    this->PrepareAtmosphere(source->Atmosphere);
    const double* angles = source->Sun->GetAngles();
    const double elevation = vtkMath::RadiansFromDegrees(angles[1]);
    const double azimuth = vtkMath::RadiansFromDegrees(angles[0]);
    this->Sun = Vec3(std::cos(elevation) * std::sin(azimuth),
      std::cos(elevation) * std::cos(azimuth), std::sin(elevation));
    this->Integrator.SetView(source->ObserverHeight, this->Sun, source->Tolerance);
    this->Source = source;
    this->Multiple = source->MultipleScattering && source->Method == ADAPTIVE;
    if (this->Multiple)
    {
      this->Integrator.PrepareMultipleScattering();
    }
    GetSize(source, this->Size);
    const double radius = vtkGodRays::GetDiscRadius(source->Sun, source->Atmosphere);
    this->DiscRadius = source->SunDisc ? radius : 0.0;
    this->DiscRadiance = vtkGodRays::ToVec3(source->Atmosphere->GetSunIrradiance()) /
      (2.0 * vtkMath::Pi() * (1.0 - std::cos(radius)));
  }

  void PrepareAtmosphere(vtkGodRaysAtmosphere* atmosphere)
  {
    if (atmosphere != this->Atmosphere || atmosphere->GetMTime() > this->AtmosphereTime)
    {
      this->Integrator.SetAtmosphere(atmosphere);
      this->Atmosphere = atmosphere;
      this->AtmosphereTime.Modified();
    }
  }

  const std::vector<Vec3>& GetMultipleTable()
  {
    this->Integrator.PrepareMultipleScattering();
    return this->Integrator.GetMultipleTable();
  }

  static void GetSize(vtkGodRaysSkySource* source, int size[3])
  {
    size[0] = source->Mapping == EQUIRECTANGULAR ? 2 * source->Resolution : source->Resolution;
    size[1] = source->Resolution;
    size[2] = source->Mapping == CUBE_MAP ? 6 : 1;
  }

  Vec3 GetRadiance(const Vec3& direction) const
  {
    return this->Source->Method == STEPS
      ? this->Integrator.MarchRadiance(direction, this->Source->NumberOfSteps)
      : this->Integrator.GetRadiance(direction, this->Multiple);
  }

  const Vec3& GetSunDirection() const { return this->Sun; }

  std::array<glm::dmat4, 3> Forms{};  // x towards the sun, y to its left
  std::array<double, 3> FormsState{}; // what they were made for

  // What is left of the sun's light.
  Vec3 GetSunTransmittance() const { return this->Integrator.GetTransmittance(this->Sun); }

  Vec3 Evaluate(int x, int y, int z) const
  {
    const Vec2 position(
      (2.0 * x + 1.0) / this->Size[0] - 1.0, (2.0 * y + 1.0) / this->Size[1] - 1.0);
    const double area = 4.0 / this->Size[0] / this->Size[1];
    Vec3 direction;
    double solidAngle;
    if (this->Source->Mapping == CUBE_MAP)
    {
      direction = vtkGodRays::CubeMapDirection(z, position);
      const double distance = vtkGodRays::length(direction);
      direction /= distance;
      solidAngle = area / (distance * distance * distance);
    }
    else
    {
      direction = vtkGodRays::SkyMapDirection(this->Source->Mapping, position);
      solidAngle = area * vtkGodRays::SkyMapSolidAngle(this->Source->Mapping, position);
    }

    Vec3 radiance = this->GetRadiance(direction);
    if (this->DiscRadius > 0.0)
    {
      const double coverage =
        vtkGodRays::DiscCoverage(vtkGodRays::AngleBetween(direction, this->Sun), this->DiscRadius,
          std::sqrt(std::max(solidAngle, 0.0)));
      if (coverage > 0.0)
      {
        radiance += coverage * this->DiscRadiance * this->Integrator.GetTransmittance(direction);
      }
    }
    return radiance;
  }

  // Fills what the image's extent asks for. Returns false if it was told to stop.
  template <typename Scalar>
  bool Execute(vtkImageData* image, Scalar* values)
  {
    const int* extent = image->GetExtent();
    const vtkIdType width = extent[1] - extent[0] + 1;
    const vtkIdType height = extent[3] - extent[2] + 1;
    const vtkIdType rows = height * (extent[5] - extent[4] + 1);
    const vtkIdType turn = std::max<vtkIdType>(1, rows / 20);
    for (vtkIdType first = 0; first < rows; first += turn)
    {
      if (!this->Source->TellProgress(static_cast<double>(first) / rows))
      {
        return false;
      }
      vtkSMPTools::For(first, std::min(rows, first + turn), 1,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType row = begin; row < end; ++row)
          {
            Scalar* to = values + 3 * row * width;
            const int y = extent[2] + static_cast<int>(row % height);
            const int z = extent[4] + static_cast<int>(row / height);
            for (int x = extent[0]; x <= extent[1]; ++x, to += 3)
            {
              const Vec3 radiance = this->Evaluate(x, y, z);
              for (int c = 0; c < 3; ++c)
              {
                to[c] = static_cast<Scalar>(vtkGodRays::Sanitize(radiance[c], 3e38));
              }
            }
          }
        });
    }
    return this->Source->TellProgress(1.0);
  }

private:
  vtkGodRaysSkySource* Source = nullptr;
  vtkGodRaysSkyIntegrator Integrator;
  vtkSmartPointer<vtkGodRaysAtmosphere> Atmosphere; // that the integrator has, as it was then
  vtkTimeStamp AtmosphereTime;
  Vec3 Sun;
  Vec3 DiscRadiance;
  double DiscRadius = 0.0;
  bool Multiple = false;
  int Size[3] = { 0, 0, 0 };
};

vtkGodRaysSkySource::vtkGodRaysSkySource()
  : Internals(new vtkInternals)
  , Atmosphere(vtkSmartPointer<vtkGodRaysAtmosphere>::New())
{
  this->SetSun(nullptr);
  this->SetNumberOfInputPorts(0);
}

vtkGodRaysSkySource::~vtkGodRaysSkySource() = default;

void vtkGodRaysSkySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Atmosphere:\n";
  this->Atmosphere->PrintSelf(os, indent.GetNextIndent());
  os << indent << "AtmospherePreset: " << this->AtmospherePreset << "\n";
  os << indent << "ObserverHeight: " << this->ObserverHeight << "\n";
  os << indent << "Sun:\n";
  this->Sun->PrintSelf(os, indent.GetNextIndent());
  os << indent << "SunDisc: " << this->SunDisc << "\n";
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Mapping: " << this->Mapping << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
}

void vtkGodRaysSkySource::SetAtmosphere(vtkGodRaysAtmosphere* atmosphere)
{
  if (atmosphere && atmosphere == this->Atmosphere)
  {
    return;
  }
  this->Atmosphere = atmosphere;
  if (!atmosphere)
  {
    this->Atmosphere = vtkSmartPointer<vtkGodRaysAtmosphere>::New();
  }
  this->Modified();
}

vtkGodRaysAtmosphere* vtkGodRaysSkySource::GetAtmosphere()
{
  return this->Atmosphere;
}

void vtkGodRaysSkySource::SetSun(vtkGodRaysSun* sun)
{
  if (sun && sun == this->Sun)
  {
    return;
  }
  this->Sun = sun;
  if (!sun)
  {
    this->Sun = vtkSmartPointer<vtkGodRaysSun>::New();
    this->Sun->SetFrame(vtkGodRaysSun::UP_AND_NORTH);
    this->Sun->SetElevation(45.0);
    this->Sun->SetAzimuth(180.0);
  }
  this->Modified();
}

vtkGodRaysSun* vtkGodRaysSkySource::GetSun()
{
  return this->Sun;
}

void vtkGodRaysSkySource::SetSunElevation(double degrees)
{
  this->Sun->SetPosition(vtkGodRaysSun::AZIMUTH_AND_ELEVATION);
  this->Sun->SetElevation(degrees);
}

double vtkGodRaysSkySource::GetSunElevation()
{
  return this->Sun->GetElevation();
}

void vtkGodRaysSkySource::SetSunAzimuth(double degrees)
{
  this->Sun->SetPosition(vtkGodRaysSun::AZIMUTH_AND_ELEVATION);
  this->Sun->SetAzimuth(degrees);
}

double vtkGodRaysSkySource::GetSunAzimuth()
{
  return this->Sun->GetAzimuth();
}

void vtkGodRaysSkySource::SetAtmospherePreset(int preset)
{
  preset = std::clamp(preset, static_cast<int>(vtkGodRaysAtmosphere::EARTH_CLEAR),
    static_cast<int>(vtkGodRaysAtmosphere::LODATO_2015));
  this->Atmosphere->LoadPreset(preset);
  this->AtmospherePreset = preset;
}

void vtkGodRaysSkySource::SetOutputScalarType(int type)
{
  type = type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  if (this->OutputScalarType != type)
  {
    this->OutputScalarType = type;
    this->Modified();
  }
}

bool vtkGodRaysSkySource::Prepare()
{
  const std::string fault = this->Atmosphere->FindFault();
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute the sky: " << fault);
    return false;
  }
  this->Internals->Prepare(this);
  return true;
}

bool vtkGodRaysSkySource::GetRadiance(const double direction[3], double radiance[3])
{
  std::fill_n(radiance, 3, 0.0);
  const Vec3 towards = vtkGodRays::ToVec3(direction);
  const double size = vtkGodRays::length(towards);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("Cannot compute the sky: the direction must be finite and not 0.");
    return false;
  }
  if (!this->Prepare())
  {
    return false;
  }
  const Vec3 found = this->Internals->GetRadiance(towards / size);
  for (int c = 0; c < 3; ++c)
  {
    radiance[c] = found[c];
  }
  return true;
}

bool vtkGodRaysSkySource::GetSunLight(double irradiance[3])
{
  std::fill_n(irradiance, 3, 0.0);
  if (!this->Prepare())
  {
    return false;
  }
  const Vec3 transmittance = this->Internals->GetSunTransmittance();
  for (int c = 0; c < 3; ++c)
  {
    irradiance[c] = transmittance[c] * this->Atmosphere->GetSunIrradiance()[c];
  }
  return true;
}

// The harmonics' terms of irradiance are m0/4, m1 n/2 and 5/16 (3 n^T m2 n - m0)/2, where m0, m1 and m2 are
// moments of radiance: integrals of L, L d and L d d^T over directions d. All of them are in that of
// (d, 1) (d, 1)^T. Places of Kronrod's rule are dense at the horizon and about the sun, where radiance
// changes fastest; azimuths beyond the sun's meridian mirror the others. What is kept turns with the sun.
bool vtkGodRaysSkySource::GetIrradianceForms(double forms[48])
{
  std::fill_n(forms, 48, 0.0);
  if (!this->Prepare())
  {
    return false;
  }
  const Vec3& sun = this->Internals->GetSunDirection();
  const double azimuth = std::atan2(sun.y, sun.x);
  const std::array<double, 3> state = { sun.z, static_cast<double>(this->Superclass::GetMTime()),
    static_cast<double>(this->Atmosphere->GetMTime()) };
  if (this->Internals->FormsState != state)
  {
    this->MakeIrradianceForms(sun.z, azimuth);
    this->Internals->FormsState = state;
  }
  glm::dmat4 turn(1.0);
  turn[0] = glm::dvec4(std::cos(azimuth), std::sin(azimuth), 0.0, 0.0);
  turn[1] = glm::dvec4(-std::sin(azimuth), std::cos(azimuth), 0.0, 0.0);
  for (int c = 0; c < 3; ++c)
  {
    const glm::dmat4 turned = turn * this->Internals->Forms[c] * glm::transpose(turn);
    for (int i = 0; i < 16; ++i)
    {
      forms[16 * c + i] = turned[i / 4][i % 4];
    }
  }
  return true;
}

void vtkGodRaysSkySource::MakeIrradianceForms(double sunHeight, double azimuth)
{
  const double half = 0.5 * vtkMath::Pi();
  const double ends[4] = { -half, 0.0, std::max(std::asin(std::min(sunHeight, 1.0)), 0.0), half };
  const auto place = [](int i) // of 15, from 0 to 1
  { return 0.5 + (i < 7 ? -0.5 : 0.5) * vtkGodRays::KronrodPlaces[i < 7 ? i : 14 - i]; };
  const auto weight = [](int i) { return 0.5 * vtkGodRays::KronrodWeights[i < 7 ? i : 14 - i]; };
  std::array<std::array<glm::dmat4, 3>, 45> moments{}; // of rows of directions, by colour
  vtkSMPTools::For(0, 45, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const int i = static_cast<int>(row % 15);
        const double low = ends[row / 15];
        const double width = ends[row / 15 + 1] - low;
        const double u = place(i);
        const double height = low + width * u * u * (3.0 - 2.0 * u);
        const double band = weight(i) * width * 6.0 * u * (1.0 - u) * std::cos(height);
        for (int k = 0; k < 15 && band > 0.0; ++k)
        {
          const double v = place(k);
          const auto look = [&](double turn)
          {
            return glm::dvec4(std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn),
              std::sin(height), 1.0);
          };
          const double turn = vtkMath::Pi() * v * v; // from the sun
          const glm::dmat4 both =
            glm::outerProduct(look(turn), look(turn)) + glm::outerProduct(look(-turn), look(-turn));
          const Vec3 light = weight(k) * 2.0 * vtkMath::Pi() * v * band *
            this->Internals->GetRadiance(Vec3(look(azimuth + turn)));
          for (int c = 0; c < 3; ++c)
          {
            moments[row][c] += light[c] * both;
          }
        }
      }
    });
  const Vec3 albedo = vtkGodRays::ToVec3(this->Atmosphere->GetGroundAlbedo());
  for (int c = 0; c < 3; ++c)
  {
    glm::dmat4 sum(0.0);
    double onGround = 0.0;
    for (int row = 0; row < 45; ++row)
    {
      sum += moments[row][c];
      onGround += row < 15 ? 0.0 : moments[row][c][3].z;
    }
    // The ground reflects light of the sky, too, all ways below.
    const double ground = albedo[c] * onGround;
    for (int i = 0; i < 3; ++i)
    {
      sum[i][i] += 2.0 / 3.0 * ground;
    }
    sum[3] += glm::dvec4(0.0, 0.0, -ground, 2.0 * ground);
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        const double factor = i < 3 && j < 3 ? 15.0 / 32.0 : i < 3 || j < 3 ? 0.25 : 3.0 / 32.0;
        this->Internals->Forms[c][i][j] = factor * (i < 3 && j == 3 ? sum[3][i] : sum[i][j]);
      }
    }
  }
}

bool vtkGodRaysSkySource::GetIrradiance(const double normal[3], double irradiance[3])
{
  std::fill_n(irradiance, 3, 0.0);
  const double size = vtkMath::Norm(normal);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("Cannot compute light of the sky: the normal must be finite and not 0.");
    return false;
  }
  double forms[48];
  const bool done = this->GetIrradianceForms(forms);
  const double n[4] = { normal[0] / size, normal[1] / size, normal[2] / size, 1.0 };
  for (int i = 0; i < 48; ++i)
  {
    irradiance[i / 16] += forms[i] * n[i / 4 % 4] * n[i % 4];
  }
  std::transform(irradiance, irradiance + 3, irradiance, [](double e) { return std::max(e, 0.0); });
  return done;
}

bool vtkGodRaysSkySource::GetMultipleScattering(vtkImageData* table)
{
  table->Initialize();
  if (!this->Prepare())
  {
    return false;
  }
  table->SetDimensions(vtkGodRaysSkyIntegrator::Slopes, vtkGodRaysSkyIntegrator::Heights, 1);
  table->AllocateScalars(VTK_FLOAT, 3);
  auto* to = static_cast<float*>(table->GetScalarPointer());
  for (const Vec3& value : this->Internals->GetMultipleTable())
  {
    for (int c = 0; c < 3; ++c)
    {
      *to++ = static_cast<float>(value[c]);
    }
  }
  return true;
}

vtkMTimeType vtkGodRaysSkySource::GetMTime()
{
  return std::max(
    { this->Superclass::GetMTime(), this->Atmosphere->GetMTime(), this->Sun->GetMTime() });
}

int vtkGodRaysSkySource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  int size[3];
  vtkInternals::GetSize(this, size);
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->OutputScalarType, 3);
  return 1;
}

int vtkGodRaysSkySource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(output);
  if (!this->Prepare())
  {
    image->Initialize();
    return 1; // the executive would only add that something failed
  }
  const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  double bytes = 3.0 * (this->OutputScalarType == VTK_DOUBLE ? sizeof(double) : sizeof(float));
  for (int i = 0; i < 3; ++i)
  {
    bytes *= extent[2 * i + 1] - extent[2 * i] + 1.0;
  }
  const std::string fault = vtkGodRays::FindMemoryFault(bytes, "Resolution");
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute a sky: " << fault);
    image->Initialize();
    return 1; // the executive would only add that something failed
  }
  image->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  image->AllocateScalars(this->OutputScalarType, 3);
  image->GetPointData()->GetScalars()->SetName("Radiance");

  void* values = image->GetScalarPointer();
  const bool done = this->OutputScalarType == VTK_DOUBLE
    ? this->Internals->Execute(image, static_cast<double*>(values))
    : this->Internals->Execute(image, static_cast<float*>(values));
  if (!done)
  {
    image->Initialize();
  }
  return 1;
}

bool vtkGodRaysSkySource::TellProgress(double progress)
{
  return vtkGodRays::TellProgress(this, progress);
}
