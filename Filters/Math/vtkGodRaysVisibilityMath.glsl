// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What can be seen through a medium. Units and ranges are those of vtkGodRaysAirlightMath.glsl.

//VTK::GodRays::Airlight
//VTK::GodRays::Medium

// Optical depth of a straight way through a medium of two components, from a height with a slope.
// Formula: sum_k extinction_k MediumDepth_k. [no unit]
FUNCTION Real WayDepth(IN(MediumComponent) first, IN(MediumComponent) second, IN(Real) planetRadius,
  IN(Real) height, IN(Real) slope, IN(Real) distance)
{
  GODRAYS_EXPECT(first.Extinction >= 0.0 && second.Extinction >= 0.0);
  return first.Extinction * MediumDepth(planetRadius, height, slope, first.ScaleHeight, distance) +
    second.Extinction * MediumDepth(planetRadius, height, slope, second.ScaleHeight, distance);
}

// What is left of light from a light to the start of a ray, r from it if it is a point: see LightDepth().
// A directional light at or below the horizon of a plane medium that thins out is not seen through it.
// Formula: e^-(sum_k LightDepth_k), or 0 where a planet hides the light. [no unit]
FUNCTION Real LightTransmittance(
  IN(MediumComponent) first, IN(MediumComponent) second, IN(LitRay) ray, IN(Real) r)
{
  GODRAYS_EXPECT(r > 0.0);
  Real slope = LightSlope(ray, ray.Height, 0.0, r);
  if (IsInPlanetShadow(ray, ray.Height, slope, r))
  {
    return 0.0;
  }
  bool thins = (first.Extinction > 0.0 && first.ScaleHeight > 0.0) ||
    (second.Extinction > 0.0 && second.ScaleHeight > 0.0);
  if (ray.Infinite != 0 && ray.PlanetRadius <= 0.0 && slope <= 0.0 && thins)
  {
    return 0.0;
  }
  return exp(-LightDepth(first, ray, ray.Height, slope, r) -
    LightDepth(second, ray, ray.Height, slope, r));
}

// The apparent contrast of a target against the horizon, where that is as bright at the target as it is at
// the eye. inherent is the contrast at no distance, 1 for a black target.
// Formula: inherent e^-tau. [no unit] [Koschmieder1924]
FUNCTION Real KoschmiederContrast(IN(Real) inherent, IN(Real) tau)
{
  GODRAYS_EXPECT(inherent >= 0.0 && tau >= 0.0);
  return inherent * exp(-tau);
}

// How far a black target can be seen against the horizon where the extinction is everywhere the mean of a
// way: the distance at which the contrast has fallen to threshold, 3.912/extinction for 0.02. Without
// extinction there is none.
// Formula: -ln(threshold) distance/tau. [length] [Koschmieder1924], [WMO8] for a threshold of 0.05
FUNCTION Real MeteorologicalRange(IN(Real) threshold, IN(Real) tau, IN(Real) distance)
{
  GODRAYS_EXPECT(threshold > 0.0 && threshold < 1.0 && tau > 0.0 && distance >= 0.0);
  return -log(threshold) * (distance / tau);
}
