// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumNumbers.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using vtkGodRays::Vec3;

constexpr double Threshold = 0.02;            // of a contrast that is seen, Koschmieder's
constexpr double DepthStep = 1.0 / (1 << 23); // of window depth: two steps of 24 bits
constexpr double Rounding = 1.2e-7;           // of 32-bit floats
constexpr double LeastLeft = 1e-6;            // by data: what is less counts as that
constexpr double PlanetError = 1e-4;          // of an optical depth, relative

vtkSmartPointer<vtkFloatArray> AddArray(
  vtkImageData* image, const char* name, int components, const char* unit)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  image->GetPointData()->AddArray(array);
  return array;
}

void AddNumber(vtkImageData* image, const std::string& name, double value, const char* unit)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  image->GetFieldData()->AddArray(array);
}

// The length of the scene's unit [m], as a factor.
double GetMeters(double unit)
{
  return unit > 0.0 ? unit : 1.0;
}

// The largest errors of a part of a picture.
struct Errors
{
  double Depth = 0.0;         // fraction
  double OpticalDepth = 0.0;  // absolute
  double Transmittance = 0.0; // absolute
  double Contrast = 0.0;      // absolute
  double Range = 0.0;         // fraction

  void Take(const Errors& other)
  {
    this->Depth = std::max(this->Depth, other.Depth);
    this->OpticalDepth = std::max(this->OpticalDepth, other.OpticalDepth);
    this->Transmittance = std::max(this->Transmittance, other.Transmittance);
    this->Contrast = std::max(this->Contrast, other.Contrast);
    this->Range = std::max(this->Range, other.Range);
  }
};

// View rays, and what the medium does along them.
class Rays
{
public:
  Rays(const vtkGodRaysView& view, const vtkGodRaysMedium& medium, const int size[2])
    : View(view)
    , Medium(medium)
  {
    view.GetPicture(view.Parallel, &this->Origin[0], &this->Right[0], &this->Upward[0]);
    view.GetPinhole(size, this->Pinhole);
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < 2; ++k)
      {
        const bool has = k < medium.NumberOfComponents;
        const vtkGodRaysMedium::Component part =
          has ? medium.Components[k] : vtkGodRaysMedium::Component();
        this->Components[c][k] = { part.Scattering[c], part.Scattering[c] + part.Absorption[c],
          part.ScaleHeight, { part.PhaseFunction, part.Asymmetry },
          { part.SecondPhaseFunction, part.SecondAsymmetry }, part.SecondWeight };
      }
    }
  }

  struct Pixel
  {
    double Depth;    // of the visible surface [scene units]; infinite if there is none
    double Distance; // along the ray, alike
    double Way;      // through the medium
    double Tau[3];
    Errors Error;

    // Add what is left by something that is known to an absolute error.
    void Veil(const float left[3], double error)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double part = std::max(static_cast<double>(left[c]), LeastLeft);
        this->Tau[c] -= std::log(part);
        this->Error.OpticalDepth = std::max(this->Error.OpticalDepth, error / part);
        if (c == 1 && this->Tau[c] > 0.0)
        {
          this->Error.Range += error / part / this->Tau[c];
        }
      }
      this->Error.Transmittance += error;
      this->Error.Contrast += error;
    }
  };

  // x and y are 0 to 1 in the picture.
  Pixel Evaluate(double x, double y, double windowDepth) const
  {
    Pixel pixel;
    const double scale = this->View.ViewScale;
    const Vec3 ray =
      this->Origin + scale * (2.0 * x - 1.0) * this->Right + scale * (2.0 * y - 1.0) * this->Upward;
    const double rest = 1.0 - windowDepth;
    const double* d = this->Pinhole.Depth;
    const double under = d[2] + d[3] * rest;
    const double depth = (d[0] + d[1] * rest) / under;
    const bool isSeen = rest > 0.0 && depth > 0.0;
    const double perDepth = this->View.Parallel ? 1.0 : vtkGodRays::length(ray) / ray.z;
    pixel.Depth = isSeen ? depth : vtkMath::Inf();
    pixel.Distance = isSeen ? depth * perDepth : vtkMath::Inf();
    pixel.Way =
      perDepth * (isSeen ? std::min(depth, this->Medium.FarLimit) : this->Medium.FarLimit);
    const bool ends = isSeen && depth < this->Medium.FarLimit;
    const double step =
      isSeen ? std::abs(d[1] * d[2] - d[0] * d[3]) / (under * under) * DepthStep : 0.0;
    pixel.Error.Depth = isSeen ? step / depth + Rounding : 0.0;

    const Vec3 direction =
      this->View.Parallel ? Vec3(0.0, 0.0, 1.0) : ray / vtkGodRays::length(ray);
    const Vec3 origin = this->View.Parallel ? Vec3(ray.x, ray.y, 0.0) : Vec3(0.0);
    const Vec3 up(this->Medium.Up[0], this->Medium.Up[1], this->Medium.Up[2]);
    const double radius = this->Medium.PlanetRadius;
    const auto start =
      vtkGodRays::MediumStart(radius, this->Medium.EyeHeight, up, origin, direction);
    const double slope = vtkGodRays::clamp(start.y, -1.0, 1.0);
    const double top = vtkGodRays::MediumHeight(radius, start.x, slope, pixel.Way);
    for (int c = 0; c < 3; ++c)
    {
      const auto& parts = this->Components[c];
      pixel.Tau[c] = vtkGodRays::WayDepth(parts[0], parts[1], radius, start.x, slope, pixel.Way);
      double extinction = 0.0; // where the way ends
      for (const vtkGodRays::MediumComponent& part : parts)
      {
        extinction += part.Extinction *
          (part.ScaleHeight > 0.0 ? vtkGodRays::ExponentialDensity(top, part.ScaleHeight) : 1.0);
      }
      const double error = (ends ? extinction * step * perDepth : 0.0) +
        pixel.Tau[c] * (Rounding + (radius > 0.0 ? PlanetError : 0.0));
      const double left = std::exp(-pixel.Tau[c]);
      pixel.Error.OpticalDepth = std::max(pixel.Error.OpticalDepth, error);
      pixel.Error.Transmittance =
        std::max(pixel.Error.Transmittance, left * (std::expm1(error) + Rounding));
      if (c == 1)
      {
        pixel.Error.Contrast = left * (std::expm1(error) + Rounding);
        pixel.Error.Range = pixel.Tau[c] > 0.0 ? error / pixel.Tau[c] + pixel.Error.Depth : 0.0;
      }
    }
    return pixel;
  }

private:
  const vtkGodRaysView& View;
  const vtkGodRaysMedium& Medium;
  vtkGodRaysView::Pinhole Pinhole;
  Vec3 Origin;
  Vec3 Right;
  Vec3 Upward;
  vtkGodRays::MediumComponent Components[3][2];
};
}

void vtkGodRaysMediumNumbers::Fill(const vtkGodRaysEffect::Reading& reading,
  const vtkGodRaysView& view, const vtkGodRaysMedium& medium, double unit, const float* veil,
  double veilError, vtkImageData* image)
{
  const int width = reading.Size[0];
  const int height = reading.Size[1];
  image->Initialize();
  image->SetDimensions(width, height, 1);
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  const auto radiances = AddArray(image, "Radiance", 3, reading.Irradiance ? "W m-2 sr-1" : "sr-1");
  image->GetPointData()->SetActiveScalars("Radiance");
  const auto transmittances = AddArray(image, "Transmittance", 3, "1");
  const auto taus = AddArray(image, "OpticalDepth", 3, "1");
  const auto depths = AddArray(image, "Depth", 1, "scene unit");
  const auto distances = AddArray(image, "Distance_m", 1, "m");
  const auto contrasts = AddArray(image, "Contrast", 1, "1");
  const auto ranges = AddArray(image, "MeteorologicalRange_m", 1, "m");

  const double meters = GetMeters(unit);
  double perLight[3]; // a light of 1 has an irradiance of pi in the pass
  for (int c = 0; c < 3; ++c)
  {
    perLight[c] = (reading.Irradiance ? reading.Irradiance[c] : 1.0) / vtkMath::Pi();
  }
  vtkDataArray* light = reading.Light ? reading.Light->GetPointData()->GetScalars() : nullptr;
  const Rays rays(view, medium, reading.Size);
  std::vector<Errors> rows(height);
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          const vtkIdType i = y * width + x;
          Rays::Pixel pixel =
            rays.Evaluate((x + 0.5) / width, (y + 0.5) / height, reading.WindowDepths[i]);
          if (veil)
          {
            pixel.Veil(veil + 3 * i, veilError);
          }
          rows[y].Take(pixel.Error);
          for (int c = 0; c < 3; ++c)
          {
            const double scattered = light ? light->GetComponent(i, c) : 0.0;
            radiances->SetTypedComponent(i, c, static_cast<float>(perLight[c] * scattered));
            taus->SetTypedComponent(i, c, static_cast<float>(pixel.Tau[c]));
            transmittances->SetTypedComponent(i, c, static_cast<float>(std::exp(-pixel.Tau[c])));
          }
          const double tau = pixel.Tau[1];
          depths->SetValue(i, static_cast<float>(pixel.Depth));
          distances->SetValue(i, static_cast<float>(meters * pixel.Distance));
          contrasts->SetValue(i, static_cast<float>(vtkGodRays::KoschmiederContrast(1.0, tau)));
          ranges->SetValue(i,
            tau > 0.0 ? static_cast<float>(
                          vtkGodRays::MeteorologicalRange(Threshold, tau, meters * pixel.Way))
                      : static_cast<float>(vtkMath::Inf()));
        }
      }
    });
  Errors errors;
  for (const Errors& row : rows)
  {
    errors.Take(row);
  }
  AddNumber(image, "Radiance_Error", reading.LightError,
    reading.LightErrorIsMeasured ? "root mean square, fraction of the brightest, measured"
                                 : "root mean square, fraction of the brightest, asked for");
  AddNumber(image, "Transmittance_Error", errors.Transmittance, "1");
  AddNumber(image, "OpticalDepth_Error", errors.OpticalDepth, "1");
  AddNumber(image, "Depth_Error", errors.Depth, "fraction of the depth");
  AddNumber(image, "Distance_m_Error", errors.Depth, "fraction of the distance");
  AddNumber(image, "Contrast_Error", errors.Contrast, "1");
  AddNumber(image, "MeteorologicalRange_m_Error", errors.Range, "fraction of the range");
  AddNumber(image, "WorldUnitInMeters", unit, "m");
}

void vtkGodRaysMediumNumbers::AddDataErrors(
  double mean, double largest, double unit, vtkImageData* image)
{
  const std::string name = "DataExtinction_per_m_";
  AddNumber(image, name + "Error", mean / GetMeters(unit), "m-1, root mean square");
  AddNumber(image, name + "MaxError", largest / GetMeters(unit), "m-1");
}

void vtkGodRaysMediumNumbers::AddOrders(bool all, vtkImageData* image)
{
  AddNumber(image, "ScatteringOrders", all ? 0.0 : 1.0,
    "1: once, 0: any number of times; Radiance_Error is that of light that was scattered once");
}
