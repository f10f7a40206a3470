// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkyIntegrator.h"

#include "vtkGodRaysKronrod.h"
#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

using namespace vtkGodRays;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Slopes = vtkGodRaysSkyIntegrator::Slopes;
constexpr int Heights = vtkGodRaysSkyIntegrator::Heights;

double MaxComponent(const Vec3& value)
{
  return std::max(value.x, std::max(value.y, value.z));
}
}

void vtkGodRaysSkyIntegrator::SetAtmosphere(vtkGodRaysAtmosphere* from)
{
  this->Sky = MakeSkyAtmosphere(from);
  this->ForwardPeak = GetForwardPeak(this->Sky);
  this->DiffuseSky = MakeDiffuseSky(this->Sky);
  this->Irradiance = ToVec3(from->GetSunIrradiance());
  this->Albedo = ToVec3(from->GetGroundAlbedo());
  this->Multiple.clear();
}

void vtkGodRaysSkyIntegrator::SetView(double height, const Vec3& sun, double tolerance)
{
  this->Height = height;
  this->Sun = sun;
  this->Tolerance = tolerance;
}

SkyWay vtkGodRaysSkyIntegrator::GetWay(const Vec3& direction) const
{
  return MakeSkyWay(this->Sky, this->Height, glm::clamp(direction.z, -1.0, 1.0),
    glm::clamp(this->Sun.z, -1.0, 1.0), glm::clamp(dot(direction, this->Sun), -1.0, 1.0));
}

bool vtkGodRaysSkyIntegrator::IsInShadow(double height, double sunSlope) const
{
  return SkyGroundDistance(this->Sky.GroundRadius, height, sunSlope) >= 0.0;
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::GetDiffuseScattering(double height) const
{
  return this->Sky.AirScattering * SkyDensity(this->Sky.Air, height) +
    (1.0 - this->ForwardPeak) * this->Sky.AerosolScattering * SkyDensity(this->Sky.Aerosol, height);
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::GetInscatter(
  const SkyWay& way, double distance, bool lit, bool multiple) const
{
  const SkyAtmosphere& sky = multiple ? this->DiffuseSky : this->Sky;
  Vec3 sum(0.0);
  if (lit)
  {
    sum = SkyInscatter(sky, way.Height, way.Slope, way.SunSlope, way.CosAngle, distance);
  }
  if (multiple)
  {
    const Vec2 point = SkyPoint(this->Sky, way, distance);
    sum += this->GetDiffuseScattering(point.x) * this->GetMultiple(point.x, point.y) *
      exp(-SkyDepth(sky, way.Height, way.Slope, distance));
  }
  return sum;
}

vtkGodRaysSkyIntegrator::Estimate vtkGodRaysSkyIntegrator::EstimatePart(
  const SkyWay& way, double begin, double end, bool lit, bool multiple) const
{
  const double middle = 0.5 * (begin + end);
  const double reach = 0.5 * (end - begin);
  const auto [kronrod, gauss] =
    SumByKronrod([&](double distance) { return this->GetInscatter(way, distance, lit, multiple); },
      middle, reach);
  // The difference is the error of Gauss's rule; that of Kronrod's is about its power of 3/2.
  const double scale = MaxComponent(kronrod);
  const double difference = MaxComponent(abs(kronrod - gauss));
  const double ratio = scale > 0.0 ? difference / scale : 0.0;
  return { reach * kronrod, reach * scale * std::min(ratio, std::pow(50.0 * ratio, 1.5)) };
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::IntegratePart(const SkyWay& way,
  double begin, double end, bool lit, bool multiple, const Estimate& estimate, double accepted,
  int depth) const
{
  if (estimate.Error <= accepted || depth == 0)
  {
    return estimate.Value;
  }
  const double middle = 0.5 * (begin + end);
  const Estimate nearPart = this->EstimatePart(way, begin, middle, lit, multiple);
  const Estimate farPart = this->EstimatePart(way, middle, end, lit, multiple);
  return this->IntegratePart(
           way, begin, middle, lit, multiple, nearPart, 0.5 * accepted, depth - 1) +
    this->IntegratePart(way, middle, end, lit, multiple, farPart, 0.5 * accepted, depth - 1);
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::GetRadiance(
  const Vec3& direction, bool multiple) const
{
  const SkyWay way = this->GetWay(direction);
  if (way.Length < 0.0)
  {
    return Vec3(0.0);
  }
  // Where the integrand is not smooth: the shadow's edges; and the lowest point, about which it peaks.
  const Vec2 shadow =
    SkyShadow(this->Sky.GroundRadius, way.Height, way.Slope, way.SunSlope, way.CosAngle);
  const bool shaded = shadow.x < shadow.y;
  const double lowest = -(this->Sky.GroundRadius + way.Height) * way.Slope;
  std::array<double, 5> ends = { 0.0, shaded ? shadow.x : 0.0, shaded ? shadow.y : 0.0, lowest,
    way.Length };
  for (double& end : ends)
  {
    end = glm::clamp(end, 0.0, way.Length);
  }
  std::sort(ends.begin(), ends.end());

  std::array<Estimate, 4> estimates;
  std::array<bool, 4> lit;
  double total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double middle = 0.5 * (ends[i] + ends[i + 1]);
    lit[i] = !(shaded && middle > shadow.x && middle < shadow.y);
    estimates[i] = { Vec3(0.0), 0.0 };
    if (ends[i + 1] > ends[i] && (lit[i] || multiple))
    {
      estimates[i] = this->EstimatePart(way, ends[i], ends[i + 1], lit[i], multiple);
      total += MaxComponent(estimates[i].Value);
    }
  }
  Vec3 radiance(0.0);
  for (int i = 0; i < 4; ++i)
  {
    radiance += this->IntegratePart(
      way, ends[i], ends[i + 1], lit[i], multiple, estimates[i], this->Tolerance * total, 20);
  }
  if (way.MeetsGround)
  {
    const SkyAtmosphere& sky = multiple ? this->DiffuseSky : this->Sky;
    radiance += exp(-SkyDepth(sky, way.Height, way.Slope, way.Length)) *
      SkyGround(sky, this->Albedo, SkyPoint(sky, way, way.Length).y);
  }
  return this->Irradiance * radiance;
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::MarchRadiance(
  const Vec3& direction, int steps) const
{
  const SkyWay way = this->GetWay(direction);
  if (way.Length < 0.0)
  {
    return Vec3(0.0);
  }
  const double step = way.Length / steps;
  const Vec3 aerosolPhase =
    SkyAerosolPhase(this->Sky.AerosolPhaseKind, this->Sky.AerosolAsymmetry, way.CosAngle);
  Vec3 radiance = way.MeetsGround
    ? SkyGround(this->Sky, this->Albedo, SkyPoint(this->Sky, way, way.Length).y)
    : Vec3(0.0);
  for (int i = steps - 1; i >= 0; --i)
  {
    const Vec2 point = SkyPoint(this->Sky, way, i * step);
    const double air = SkyDensity(this->Sky.Air, point.x);
    const double aerosol = SkyDensity(this->Sky.Aerosol, point.x);
    const Vec3 extinction = this->Sky.AirScattering * air + this->Sky.AerosolExtinction * aerosol +
      this->Sky.Absorption * SkyDensity(this->Sky.Absorber, point.x);
    radiance *= exp(-extinction * step);
    if (!this->IsInShadow(point.x, point.y))
    {
      radiance += (this->Sky.AirScattering * (air * Phase(this->Sky.AirPhase, way.CosAngle)) +
                    this->Sky.AerosolScattering * (aerosol * aerosolPhase)) *
        SkySunTransmittance(this->Sky, point.x, point.y) * step;
    }
  }
  return this->Irradiance * radiance;
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::GetTransmittance(const Vec3& direction) const
{
  const SkyWay way = this->GetWay(direction);
  if (way.Length < 0.0)
  {
    return Vec3(1.0);
  }
  return way.MeetsGround ? Vec3(0.0) : exp(-SkyDepth(this->Sky, way.Height, way.Slope, way.Length));
}

void vtkGodRaysSkyIntegrator::PrepareMultipleScattering()
{
  if (!this->Multiple.empty())
  {
    return;
  }
  std::vector<Vec3> table(static_cast<std::size_t>(Slopes) * Heights);
  vtkSMPTools::For(0, static_cast<vtkIdType>(table.size()), 8,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        const double u = 2.0 * static_cast<double>(cell % Slopes) / (Slopes - 1) - 1.0;
        const double v = static_cast<double>(cell / Slopes) / (Heights - 1);
        const double sunSlope = u * std::fabs(u);
        const double height = v * v * this->Sky.TopHeight;
        Vec3 twice(0.0); // light that is scattered here after it was scattered, or reflected, once
        Vec3 again(0.0); // of light that comes from everywhere alike, what comes back here
        // All directions: Kronrod's rule for the slope, the middle of 8 parts for half of the azimuths.
        for (int i = 0; i < 15; ++i)
        {
          const int k = std::min(i, 14 - i);
          const double slope = i < 7 ? -KronrodPlaces[k] : KronrodPlaces[k];
          std::array<double, 8> cosAngles;
          for (int j = 0; j < 8; ++j)
          {
            cosAngles[j] = slope * sunSlope +
              std::sqrt((1.0 - slope * slope) * (1.0 - sunSlope * sunSlope)) *
                std::cos(Pi * (j + 0.5) / 8.0);
          }
          SkyWay way = MakeSkyWay(this->Sky, height, slope, sunSlope, cosAngles[0]);
          const double weight = KronrodWeights[k] / 16.0; // of all directions
          const double nearPart = 0.15 * way.Length;
          for (int part = 0; part < 2; ++part)
          {
            const double begin = part == 0 ? 0.0 : nearPart;
            const double reach = 0.5 * ((part == 0 ? nearPart : way.Length) - begin);
            for (int n = 0; n < 15; ++n)
            {
              const int m = std::min(n, 14 - n);
              const double distance =
                begin + reach * (1.0 + (n < 7 ? -KronrodPlaces[m] : KronrodPlaces[m]));
              const Vec3 scattering = (weight * reach * KronrodWeights[m]) *
                this->GetDiffuseScattering(SkyPoint(this->Sky, way, distance).x) *
                exp(-SkyDepth(this->DiffuseSky, way.Height, way.Slope, distance));
              for (const double cosAngle : cosAngles) // the sun alone depends on the azimuth
              {
                way.CosAngle = cosAngle;
                const Vec2 point = SkyPoint(this->Sky, way, distance);
                again += scattering;
                if (!this->IsInShadow(point.x, point.y))
                {
                  twice += PhaseIsotropic() * scattering *
                    SkySunTransmittance(this->DiffuseSky, point.x, point.y);
                }
              }
            }
          }
          if (way.MeetsGround)
          {
            const Vec3 left =
              weight * exp(-SkyDepth(this->DiffuseSky, way.Height, way.Slope, way.Length));
            for (const double cosAngle : cosAngles)
            {
              way.CosAngle = cosAngle;
              twice += left *
                SkyGround(this->DiffuseSky, this->Albedo, SkyPoint(this->Sky, way, way.Length).y);
            }
          }
        }
        table[cell] = twice / (1.0 - again);
      }
    });
  this->Multiple = std::move(table);
}

vtkGodRaysSkyIntegrator::Vec3 vtkGodRaysSkyIntegrator::GetMultiple(
  double height, double sunSlope) const
{
  const Vec2 position = SkyMultiplePosition(this->Sky.TopHeight, height, sunSlope);
  const double x = position.x * (Slopes - 1);
  const double y = position.y * (Heights - 1);
  const int column = std::min(static_cast<int>(x), Slopes - 2);
  const int row = std::min(static_cast<int>(y), Heights - 2);
  const double s = x - column;
  const double t = y - row;
  const Vec3* corner = this->Multiple.data() + row * Slopes + column;
  return (1.0 - t) * ((1.0 - s) * corner[0] + s * corner[1]) +
    t * ((1.0 - s) * corner[Slopes] + s * corner[Slopes + 1]);
}
