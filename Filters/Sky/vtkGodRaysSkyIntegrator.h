// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSkyIntegrator.h
 * @brief   the radiance of the sky in one direction; private to the implementation files
 *
 * The formulas are those of vtkGodRaysSkyMath.glsl. Directions have length 1: x east, y north, z to the
 * zenith of the observer.
 */

#ifndef vtkGodRaysSkyIntegrator_h
#define vtkGodRaysSkyIntegrator_h

#include "vtkGodRaysMath.h"

#include <array>
#include <vector>

class vtkGodRaysAtmosphere;

class vtkGodRaysSkyIntegrator
{
public:
  using Vec3 = vtkGodRays::Vec3;
  using SkyWay = vtkGodRays::SkyWay;

  void SetAtmosphere(vtkGodRaysAtmosphere* atmosphere);

  // The observer's height [m], the direction to the sun, and the error that is accepted [fraction].
  void SetView(double height, const Vec3& sun, double tolerance);

  // The table of light that is scattered more than once; it depends on the atmosphere alone. After
  // [Hillaire2020]: scattered twice or more, light is taken to come from everywhere alike. Before that, the
  // forward peak of the aerosol's phase function, a part g^2, is taken to be no scattering at all, after
  // [Joseph1976]; the light that is scattered once keeps the phase function as it is.
  void PrepareMultipleScattering();

  // That table, for an irradiance of 1 [1/sr]: rows of heights, of slopes of the way to the sun; see
  // SkyMultiplePosition.
  static constexpr int Slopes = 48;
  static constexpr int Heights = 16;
  const std::vector<Vec3>& GetMultipleTable() const { return this->Multiple; }

  // Radiance of the sky without the sun's disc [the irradiance's unit/sr].
  Vec3 GetRadiance(const Vec3& direction, bool multiple) const;

  // The same by the march of [Lodato2015]: steps of the first order from the edge to the eye.
  Vec3 MarchRadiance(const Vec3& direction, int steps) const;

  // What is left of light from outside; 0 where the ground is before it.
  Vec3 GetTransmittance(const Vec3& direction) const;

  // Light that arrives at a point after two scatterings or more, from everywhere alike, for an
  // irradiance of 1. [1/sr]
  Vec3 GetMultiple(double height, double sunSlope) const;

private:
  // The way from the observer.
  SkyWay GetWay(const Vec3& direction) const;
  bool IsInShadow(double height, double sunSlope) const;
  // Scattering at a height without the aerosol's forward peak.
  Vec3 GetDiffuseScattering(double height) const;

  // What a unit of the way adds: by light straight from the sun, and by other.
  Vec3 GetInscatter(const SkyWay& way, double distance, bool lit, bool multiple) const;
  struct Estimate
  {
    Vec3 Value;
    double Error;
  };
  Estimate EstimatePart(const SkyWay& way, double begin, double end, bool lit, bool multiple) const;
  Vec3 IntegratePart(const SkyWay& way, double begin, double end, bool lit, bool multiple,
    const Estimate& estimate, double accepted, int depth) const;

  vtkGodRays::SkyAtmosphere Sky;
  vtkGodRays::SkyAtmosphere DiffuseSky; // what the forward peak takes away is left in the light
  Vec3 ForwardPeak = Vec3(0.0);         // part of the aerosol's scattering
  Vec3 Irradiance;
  Vec3 Albedo;
  double Height = 0.0;
  Vec3 Sun;
  double Tolerance = 1e-3;
  std::vector<Vec3> Multiple;
};

#endif
