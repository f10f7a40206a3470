// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How wrong vtkGodRaysSkySource is, and what it costs: Markdown tables.
//
// Usage: SkyError [--quick]
//        SkyError --chart FILE   speed against error alone, drawn into a PNG file, too
//
// Multiple scattering is judged by paths of light that are followed backwards from the eye, all orders, by
// chance (Monte Carlo, free flights after Woodcock): slow, but without the approximations. Time is of one
// thread.

#include "Charts.h"

#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkGodRaysSkySource.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <random>

using namespace vtkGodRays;

namespace
{
const double Pi = 3.14159265358979323846;

Vec3 MakeDirection(double zenithAngle, double azimuth)
{
  const double zenith = zenithAngle * Pi / 180.0;
  const double turn = azimuth * Pi / 180.0;
  return Vec3(
    std::sin(zenith) * std::sin(turn), std::sin(zenith) * std::cos(turn), std::cos(zenith));
}

//------------------------------------------------------------------------------
// The paths.
class Paths
{
public:
  Paths(vtkGodRaysAtmosphere* atmosphere, const Vec3& sun)
    : Sky(MakeSkyAtmosphere(atmosphere))
    , Albedo(ToVec3(atmosphere->GetGroundAlbedo()))
    , Sun(sun)
  {
  }

  // Radiance of light that was scattered or reflected twice or more, for an irradiance of 1, and the
  // standard error of the mean.
  void GetRadiance(double height, const Vec3& direction, int color, int count, double result[2])
  {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const double value = this->Follow(height, direction, color);
      sum += value;
      squares += value * value;
    }
    result[0] = sum / count;
    result[1] = std::sqrt((squares / count - result[0] * result[0]) / count);
  }

private:
  double GetNumber() { return (this->Generator() + 0.5) / 4294967296.0; }

  // A direction at an angle to another.
  Vec3 Turn(const Vec3& axis, double cosAngle)
  {
    const Vec3 other = std::fabs(axis.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 u = glm::normalize(cross(axis, other));
    const Vec3 v = cross(axis, u);
    const double turn = 2.0 * Pi * this->GetNumber();
    const double side = std::sqrt(std::max(1.0 - cosAngle * cosAngle, 0.0));
    return glm::normalize(cosAngle * axis + side * (std::cos(turn) * u + std::sin(turn) * v));
  }

  // A cosine from Rayleigh's phase function, or from Henyey and Greenstein's.
  double GetRayleighCosine()
  {
    double c;
    do
    {
      c = 2.0 * this->GetNumber() - 1.0;
    } while (2.0 * this->GetNumber() > 1.0 + c * c);
    return c;
  }
  double GetHenyeyGreensteinCosine(double g)
  {
    const double ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * this->GetNumber());
    return (1.0 + g * g - ratio * ratio) / (2.0 * g);
  }

  // What of the sun's light arrives.
  double GetSunTransmittance(double height, double slope, int color) const
  {
    return SkyGroundDistance(this->Sky.GroundRadius, height, slope) >= 0.0
      ? 0.0
      : SkySunTransmittance(this->Sky, height, slope)[color];
  }

  double Follow(double height, Vec3 direction, int color)
  {
    const double ground = this->Sky.GroundRadius;
    const double most = this->Sky.AirScattering[color] + this->Sky.AerosolExtinction[color] +
      this->Sky.Absorption[color];
    Vec3 place(0.0, 0.0, ground + height);
    double weight = 1.0;
    double radiance = 0.0;
    for (int order = 0; order < 200;)
    {
      const double radius = length(place);
      const Vec3 up = place / radius;
      const double slope = dot(direction, up);
      const double above = std::max(radius - ground, 0.0);
      const double hit = SkyGroundDistance(ground, above, slope);
      const double end = hit >= 0.0 ? hit : SkyBelow(ground, above, slope, this->Sky.TopHeight).y;
      const double flight = -std::log(this->GetNumber()) / most;
      if (flight >= end)
      {
        if (hit < 0.0)
        {
          return radiance; // out into space
        }
        place += end * direction;
        place *= (ground + 1e-3) / length(place);
        const Vec3 vertical = glm::normalize(place);
        const double sunSlope = dot(vertical, this->Sun);
        weight *= this->Albedo[color];
        if (order > 0 && sunSlope > 0.0)
        {
          radiance += weight / Pi * sunSlope * this->GetSunTransmittance(0.0, sunSlope, color);
        }
        direction = this->Turn(vertical, std::sqrt(this->GetNumber()));
        ++order;
        continue;
      }
      place += flight * direction;
      const double there = std::max(length(place) - ground, 0.0);
      const double air = this->Sky.AirScattering[color] * SkyDensity(this->Sky.Air, there);
      const double density = SkyDensity(this->Sky.Aerosol, there);
      const double aerosol = this->Sky.AerosolScattering[color] * density;
      const double extinction = air + this->Sky.AerosolExtinction[color] * density +
        this->Sky.Absorption[color] * SkyDensity(this->Sky.Absorber, there);
      if (this->GetNumber() * most >= extinction)
      {
        continue; // nothing was met
      }
      weight *= (air + aerosol) / extinction;
      const double cosSun = dot(direction, this->Sun);
      const PhaseFunction aerosolPhase = { this->Sky.AerosolPhaseKind,
        this->Sky.AerosolAsymmetry[color] };
      if (order > 0)
      {
        const double phase =
          (air * Phase(this->Sky.AirPhase, cosSun) + aerosol * Phase(aerosolPhase, cosSun)) /
          (air + aerosol);
        radiance += weight * phase *
          this->GetSunTransmittance(there, dot(place, this->Sun) / length(place), color);
      }
      if (this->GetNumber() * (air + aerosol) < air)
      {
        direction = this->Turn(direction, this->GetRayleighCosine());
      }
      else
      {
        const double g = aerosolPhase.Asymmetry;
        const double c = this->GetHenyeyGreensteinCosine(g);
        weight *= Phase(aerosolPhase, c) / PhaseHenyeyGreenstein(c, g);
        direction = this->Turn(direction, c);
      }
      ++order;
    }
    return radiance;
  }

  SkyAtmosphere Sky;
  Vec3 Albedo;
  Vec3 Sun;
  std::mt19937 Generator;
};

//------------------------------------------------------------------------------
void JudgeMultipleScattering(bool quick)
{
  std::printf(
    "Multiple scattering: the whole radiance, single scattering included, against paths of all "
    "orders [%%]; in brackets the standard error of the paths.\n\n"
    "| atmosphere | sun's zenith angle | view's, azimuth | red | green | blue |\n"
    "|---|---|---|---|---|---|\n");
  const int count = quick ? 2000 : 30000;
  for (const char* name : { "earth-clear", "earth-hazy" })
  {
    for (const double sunZenith : { 30.0, 60.0, 85.0 })
    {
      vtkNew<vtkGodRaysSkySource> source;
      source->GetAtmosphere()->LoadPreset(std::string(name));
      source->SetSunElevation(90.0 - sunZenith);
      source->SetSunAzimuth(0.0);
      source->SetTolerance(1e-5);
      const Vec3 sun = MakeDirection(sunZenith, 0.0);
      const double views[][2] = { { 0, 0 }, { 45, 0 }, { 45, 90 }, { 45, 180 }, { 80, 90 },
        { 80, 180 } };
      for (const double* view : views)
      {
        const Vec3 direction = MakeDirection(view[0], view[1]);
        Vec3 radiance[2];
        for (int multiple = 0; multiple < 2; ++multiple)
        {
          source->SetMultipleScattering(multiple == 1);
          source->GetRadiance(&direction[0], &radiance[multiple][0]);
        }
        std::printf("| %s | %.0f | %.0f, %.0f |", name, sunZenith, view[0], view[1]);
        for (int color = 0; color < 3; ++color)
        {
          Paths paths(source->GetAtmosphere(), sun);
          double more[2];
          paths.GetRadiance(source->GetObserverHeight(), direction, color, count, more);
          const double irradiance = source->GetAtmosphere()->GetSunIrradiance()[color];
          const double truth = radiance[0][color] + irradiance * more[0];
          std::printf(" %+.1f (%.1f) |", 100.0 * (radiance[1][color] / truth - 1.0),
            100.0 * irradiance * more[1] / truth);
        }
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
  std::printf("\n");
}

//------------------------------------------------------------------------------
double GetSeconds(vtkGodRaysSkySource* source)
{
  source->Modified();
  const auto start = std::chrono::steady_clock::now();
  source->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Print root mean square and largest error, of the pixels' brightest colour, and return the former.
double PrintErrors(vtkGodRaysSkySource* source, vtkImageData* truth)
{
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
  vtkDataArray* expected = truth->GetPointData()->GetScalars();
  double squares = 0.0;
  double worst = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    double scale = 0.0;
    double difference = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      scale = std::max(scale, expected->GetComponent(i, c));
      difference =
        std::max(difference, std::fabs(values->GetComponent(i, c) - expected->GetComponent(i, c)));
    }
    const double relative = scale > 0.0 ? difference / scale : 0.0;
    squares += relative * relative;
    worst = std::max(worst, relative);
  }
  const double error = std::sqrt(squares / values->GetNumberOfTuples());
  std::printf(" %.1e | %.1e |\n", error, worst);
  return error;
}

Chart JudgeSpeed(bool quick)
{
  const int resolution = quick ? 16 : 128;
  std::printf(
    "Speed against error: a paraboloid of %d x %d pixels, the sun 30 degrees high, single "
    "scattering, against a tolerance of 1e-9; one thread.\n\n"
    "| method | microseconds/pixel | root mean square error | largest |\n|---|---|---|---|\n",
    resolution, resolution);
  vtkNew<vtkGodRaysSkySource> source;
  source->SetResolution(resolution);
  source->SetSunElevation(30.0);
  source->SetOutputScalarType(VTK_DOUBLE);
  source->SetTolerance(1e-9);
  source->Update();
  vtkNew<vtkImageData> truth;
  truth->DeepCopy(source->GetOutput());
  const double pixels = static_cast<double>(resolution) * resolution;
  const auto judge = [&](ChartSeries& series, const char* name, double value)
  {
    const double microseconds = 1e6 * GetSeconds(source) / pixels;
    std::printf("| %s %g | %.1f |", name, value, microseconds);
    series.X.push_back(microseconds);
    series.Y.push_back(PrintErrors(source, truth));
    char label[32];
    std::snprintf(label, sizeof(label), "%g", value);
    series.Labels.emplace_back(label);
  };
  Chart chart{ "A sky of single scattering", "microseconds a pixel, one thread",
    "root mean square error (fraction of each pixel)",
    { { "tolerance", {}, {}, {} }, { "steps of the first order", {}, {}, {} } } };
  for (const double tolerance : { 1e-1, 1e-2, 1e-3, 1e-4, 1e-6 })
  {
    source->SetTolerance(tolerance);
    judge(chart.Series[0], "tolerance", tolerance);
  }
  source->SetMethod(vtkGodRaysSkySource::STEPS);
  for (const int steps : { 8, 16, 32, 64, 128, 256 })
  {
    source->SetNumberOfSteps(steps);
    judge(chart.Series[1], "steps of the first order:", steps);
  }
  std::printf("\n");
  return chart;
}

//------------------------------------------------------------------------------
// The sky's shape against the CIE's clear one, L ~ (0.91 + 10 e^(-3 g) + 0.45 cos^2 g)
// (1 - e^(-0.32/cos z)), both divided by the zenith's.
void JudgeShape()
{
  std::printf(
    "Luminance, multiple scattering included, in units of the zenith's: ours/CIE clear sky.\n\n"
    "| atmosphere | sun's zenith angle | 30, 0 | 30, 180 | 60, 90 | 60, 180 | 85, 90 | 85, 180 |\n"
    "|---|---|---|---|---|---|---|---|\n");
  for (const char* name : { "earth-clear", "earth-hazy" })
  {
    for (const double sunZenith : { 40.0, 60.0 })
    {
      vtkNew<vtkGodRaysSkySource> source;
      source->GetAtmosphere()->LoadPreset(std::string(name));
      source->SetSunElevation(90.0 - sunZenith);
      source->SetSunAzimuth(0.0);
      source->SetMultipleScattering(true);
      const Vec3 sun = MakeDirection(sunZenith, 0.0);
      const auto getLuminances = [&](double zenith, double azimuth, double result[2])
      {
        const Vec3 direction = MakeDirection(zenith, azimuth);
        Vec3 radiance;
        source->GetRadiance(&direction[0], &radiance[0]);
        result[0] = dot(radiance, Vec3(0.2126, 0.7152, 0.0722));
        const double angle = AngleBetween(direction, sun);
        result[1] = (0.91 + 10.0 * std::exp(-3.0 * angle) + 0.45 * std::pow(std::cos(angle), 2.0)) *
          (1.0 - std::exp(-0.32 / direction.z));
      };
      double zenith[2];
      getLuminances(0.0, 0.0, zenith);
      std::printf("| %s | %.0f |", name, sunZenith);
      const double views[][2] = { { 30, 0 }, { 30, 180 }, { 60, 90 }, { 60, 180 }, { 85, 90 },
        { 85, 180 } };
      for (const double* view : views)
      {
        double there[2];
        getLuminances(view[0], view[1], there);
        std::printf(" %.2f/%.2f |", there[0] / zenith[0], there[1] / zenith[1]);
      }
      std::printf("\n");
    }
  }
  std::printf("\n");
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  vtkSMPTools::Initialize(1);
  if (argc > 2 && std::strcmp(argv[1], "--chart") == 0)
  {
    WriteChart(JudgeSpeed(false), argv[2]);
    return 0;
  }
  JudgeMultipleScattering(quick);
  JudgeSpeed(quick);
  JudgeShape();
  return 0;
}
