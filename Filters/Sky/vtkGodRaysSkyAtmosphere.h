// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSkyAtmosphere.h
 * @brief   an atmosphere as the formulas take it; private to the implementation files
 */

#ifndef vtkGodRaysSkyAtmosphere_h
#define vtkGodRaysSkyAtmosphere_h

#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSun.h"

#include "vtkMath.h"

namespace vtkGodRays
{
inline Vec3 ToVec3(const double values[3])
{
  return Vec3(values[0], values[1], values[2]);
}

inline SkyAtmosphere MakeSkyAtmosphere(vtkGodRaysAtmosphere* from)
{
  SkyAtmosphere sky;
  sky.GroundRadius = from->GetGroundRadius();
  sky.TopHeight = from->GetTopHeight();
  sky.Air = { from->GetRayleighProfile(), from->GetRayleighHeight(), from->GetRayleighWidth() };
  sky.Aerosol = { from->GetMieProfile(), from->GetMieHeight(), from->GetMieWidth() };
  sky.Absorber = { from->GetOzoneProfile(), from->GetOzoneHeight(), from->GetOzoneWidth() };
  sky.AirScattering = ToVec3(from->GetRayleighScattering());
  sky.AerosolScattering = ToVec3(from->GetMieScattering());
  sky.AerosolExtinction = sky.AerosolScattering + ToVec3(from->GetMieAbsorption());
  sky.Absorption = ToVec3(from->GetOzoneAbsorption());
  sky.AirPhase = { vtkGodRaysAtmosphere::RAYLEIGH, 0.0 };
  sky.AerosolPhaseKind = from->GetMiePhaseFunction();
  sky.AerosolAsymmetry = ToVec3(from->GetMieAsymmetry());
  return sky;
}

/// The radius of the sun's disc, where the planet is [radians].
inline double GetDiscRadius(vtkGodRaysSun* sun, vtkGodRaysAtmosphere* atmosphere)
{
  return vtkMath::RadiansFromDegrees(
    std::min(sun->GetAngularRadius() / atmosphere->GetSunDistance(), 90.0));
}

// The part of what an aerosol scatters that goes on nearly straight, and so is taken to be no scattering
// where light is scattered more than once.
inline Vec3 GetForwardPeak(const SkyAtmosphere& sky)
{
  Vec3 peak;
  for (int i = 0; i < 3; ++i)
  {
    peak[i] = PhaseForwardPeak({ sky.AerosolPhaseKind, sky.AerosolAsymmetry[i] });
  }
  return peak;
}

// The atmosphere in which light is scattered more than once: the forward peak is left in the light.
inline SkyAtmosphere MakeDiffuseSky(const SkyAtmosphere& sky)
{
  SkyAtmosphere diffuse = sky;
  diffuse.AerosolExtinction -= GetForwardPeak(sky) * sky.AerosolScattering;
  return diffuse;
}
}

#endif
