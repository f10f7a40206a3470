// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Airlight
//VTK::GodRays::Phase
//VTK::GodRays::Planet

// Light that a medium of two components scatters once on its way to the eye, along a view ray. Units and
// ranges are those of vtkGodRaysAirlightMath.glsl.

// The height at which a parallel view ray starts that is aside of the eye by origin, and the slope of a
// direction there; up is the vertical at the eye.
// Formula: (MediumHeight, direction vertical), the vertical being along (R + eyeHeight) up + origin.
// [length, no unit]
FUNCTION Vec2 MediumStart(IN(Real) planetRadius, IN(Real) eyeHeight, IN(Vec3) up, IN(Vec3) origin,
  IN(Vec3) direction)
{
  GODRAYS_EXPECT(planetRadius >= 0.0);
  Real aside = length(origin);
  Real slope = dot(direction, up);
  Real height =
    MediumHeight(planetRadius, eyeHeight, dot(origin, up) / max(aside, 1e-30), aside);
  if (planetRadius > 0.0)
  {
    slope = ((planetRadius + eyeHeight) * slope + dot(origin, direction)) / (planetRadius + height);
  }
  return Vec2(height, slope);
}

// A component of a medium, e.g. molecules or dust, in one channel of colour.
struct MediumComponent
{
  Real Scattering;  // coefficient where the density is 1 [1/length]
  Real Extinction;  // [1/length]
  Real ScaleHeight; // 0: homogeneous [length]
  PhaseFunction First;
  PhaseFunction Second;
  Real SecondWeight; // see PhaseMix()
};

// How much of a point light's intensity leaves it which way, about its axis: a cone, as vtkLight has it.
struct SpotShape
{
  Real CosCone;  // cosine of half the cone's angle; 0: the light shines everywhere alike
  Real Exponent; // at least 0; how it fades towards the cone's edge
};

// A view ray and a light, which is infinitely far or a point. Distances are from the eye.
struct LitRay
{
  int Infinite;     // 1 or 0
  Real Foot;        // cosine of the angle to the light, or where the ray is nearest to it [length]
  Real Distance;    // of a point light from the ray [length]
  Real Height;      // of the ray's start above where densities are 1 [length]
  Real Slope;       // rise of the ray there, for each unit of its length
  Real LightHeight; // rise towards the light there for each unit of length, or its height [length]
  Real PlanetRadius; // whose ground densities are 1 at; 0: that is a plane [length]
  Real AxisStart;    // of a spotlight: how far along its axis from it the ray starts [length]
  Real AxisSlope;    // and how far along it each unit of the ray's length leads
  SpotShape Shape;   // and which way it shines
  int ThroughGround; // 1: a planet's ground lets the light through, and its shadow is taken away elsewhere
};

// The part of a ray, from x to y, that is within a spotlight's cone, at most from 0 to end; y is 0 if
// there is none.
// Formula: (AxisStart + AxisSlope s)^2 >= CosCone^2 (Distance^2 + (s - Foot)^2), AxisStart + AxisSlope s
// >= 0. [length]
FUNCTION Vec2 SpotPart(IN(LitRay) ray, IN(Real) end)
{
  GODRAYS_EXPECT(end >= 0.0);
  if (ray.Shape.CosCone <= 0.0)
  {
    return Vec2(0.0, end);
  }
  Real square = ray.Shape.CosCone * ray.Shape.CosCone;
  Real a = ray.AxisSlope * ray.AxisSlope - square;
  a = abs(a) < 1e-7 ? -1e-7 : a;
  Real b = ray.AxisStart * ray.AxisSlope + square * ray.Foot;
  Real c = ray.AxisStart * ray.AxisStart -
    square * (ray.Distance * ray.Distance + ray.Foot * ray.Foot);
  Real root = b * b - a * c;
  if (root <= 0.0 && a < 0.0)
  {
    return Vec2(0.0);
  }
  Real q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(root, 0.0)));
  Real one = q / a;
  Real other = q != 0.0 ? c / q : one;
  Vec2 part = Vec2(min(one, other), max(one, other));
  if (a > 0.0)
  {
    part = ray.AxisSlope > 0.0 ? Vec2(part.y, end) : Vec2(0.0, part.x);
  }
  else if (ray.AxisStart + 0.5 * (part.x + part.y) * ray.AxisSlope < 0.0)
  {
    return Vec2(0.0); // the cone behind the light
  }
  part = clamp(part, Vec2(0.0), Vec2(end));
  return part.y > part.x ? part : Vec2(0.0);
}

// Whether a spotlight shines towards a point of the ray, r from it: the test of SpotPart() for one place.
// Formula: AxisStart + AxisSlope s >= CosCone r.
FUNCTION bool IsInSpot(IN(LitRay) ray, IN(Real) s, IN(Real) r)
{
  GODRAYS_EXPECT(r > 0.0);
  return ray.Shape.CosCone <= 0.0 || ray.AxisStart + ray.AxisSlope * s >= ray.Shape.CosCone * r;
}

// How much of a spotlight's intensity leaves it towards a point of the ray, r from it, in its cone.
// Formula: cos(angle to the axis)^Exponent. [no unit]
FUNCTION Real SpotFactor(IN(LitRay) ray, IN(Real) s, IN(Real) r)
{
  GODRAYS_EXPECT(r > 0.0);
  Real cosine = (ray.AxisStart + ray.AxisSlope * s) / r;
  return ray.Shape.CosCone > 0.0 && ray.Shape.Exponent > 0.0
    ? pow(clamp(cosine, 1e-30, 1.0), ray.Shape.Exponent)
    : 1.0;
}

// The slope of the way from a point of the ray, s from its start, at a height, to the light, r from it.
// Formula: LightHeight or MediumSlope; over a planet ((R + Height) LightHeight + s Foot)/(R + height).
// [no unit]
FUNCTION Real LightSlope(IN(LitRay) ray, IN(Real) height, IN(Real) s, IN(Real) r)
{
  GODRAYS_EXPECT(r > 0.0);
  if (ray.Infinite == 0)
  {
    return MediumSlope(ray.PlanetRadius, height, ray.LightHeight, r);
  }
  if (ray.PlanetRadius > 0.0)
  {
    Real towards = (ray.PlanetRadius + ray.Height) * ray.LightHeight + s * ray.Foot;
    return clamp(towards / (ray.PlanetRadius + height), -1.0, 1.0);
  }
  return ray.LightHeight;
}

// Whether a planet hides a point of the ray from the light. The arguments are those of LightSlope() and
// its result; a plane hides nothing, and out of a planet nothing shines.
// Formula: LightHeight < 0, or SkyGroundDistance towards the light is one, and below r.
FUNCTION bool IsInPlanetShadow(IN(LitRay) ray, IN(Real) height, IN(Real) slope, IN(Real) r)
{
  if (ray.PlanetRadius <= 0.0 || ray.ThroughGround != 0)
  {
    return false;
  }
  Real ground = SkyGroundDistance(ray.PlanetRadius, height, slope);
  return ray.Infinite != 0 ? ground >= 0.0
                           : ray.LightHeight < 0.0 || (ground >= 0.0 && ground < r);
}

// Where a ray that would go on to end stops: at a planet's ground.
// Formula: min(SkyGroundDistance, end). [length]
FUNCTION Real MediumEnd(IN(LitRay) ray, IN(Real) end)
{
  Real ground =
    ray.PlanetRadius > 0.0 ? SkyGroundDistance(ray.PlanetRadius, ray.Height, ray.Slope) : -1.0;
  return ground >= 0.0 ? min(ground, end) : end;
}

// Optical depth of the light's way to a point of the ray at a height, r from a point light. Only a
// medium of exponential density dims a light that is infinitely far, and hides one below the horizon.
// Formula: see MediumDepth() and MediumColumn(). [no unit]
FUNCTION Real LightDepth(IN(MediumComponent) component, IN(LitRay) ray, IN(Real) height,
  IN(Real) slope, IN(Real) r)
{
  GODRAYS_EXPECT(component.Extinction >= 0.0 && component.ScaleHeight >= 0.0);
  if (ray.Infinite == 0)
  {
    return component.Extinction *
      MediumDepth(ray.PlanetRadius, height, slope, component.ScaleHeight, r);
  }
  return component.ScaleHeight > 0.0
    ? component.Extinction * MediumColumn(ray.PlanetRadius, height, slope, component.ScaleHeight)
    : 0.0;
}

// What a component scatters at a height, for each unit of length.
// Formula: coefficient density phase. [1/(length sr)]
FUNCTION Real ScatteredPart(
  IN(MediumComponent) component, IN(Real) height, IN(Real) cosAngle)
{
  GODRAYS_EXPECT(component.Scattering >= 0.0 && component.ScaleHeight >= 0.0);
  Real density =
    component.ScaleHeight > 0.0 ? ExponentialDensity(height, component.ScaleHeight) : 1.0;
  return component.Scattering * density *
    PhaseMix(component.First, component.Second, component.SecondWeight, cosAngle);
}

// Light that reaches the eye from a point of a ray in a medium of two components, which may be
// empty, for each unit of the ray's length and of the light's irradiance at the ray, or, times r^2,
// of its intensity, on its axis if it is a spotlight, whose cone's edge is not looked at.
// Formula: SpotFactor sum_k sigma_k density_k phase_k e^-(tau to the eye + tau to the light).
// [1/(length sr)]
FUNCTION Real MediumIntegrand(
  IN(MediumComponent) first, IN(MediumComponent) second, IN(LitRay) ray, IN(Real) s)
{
  GODRAYS_EXPECT(s >= 0.0);
  Real beyond = s - ray.Foot;
  Real r = max(sqrt(ray.Distance * ray.Distance + beyond * beyond), 1e-30);
  Real cosAngle = ray.Infinite != 0 ? ray.Foot : -beyond / r;
  Real height = MediumHeight(ray.PlanetRadius, ray.Height, ray.Slope, s);
  Real slope = LightSlope(ray, height, s, r);
  if (IsInPlanetShadow(ray, height, slope, r))
  {
    return 0.0;
  }
  Real tau =
    LightDepth(first, ray, height, slope, r) + LightDepth(second, ray, height, slope, r) +
    first.Extinction *
      MediumDepth(ray.PlanetRadius, ray.Height, ray.Slope, first.ScaleHeight, s) +
    second.Extinction *
      MediumDepth(ray.PlanetRadius, ray.Height, ray.Slope, second.ScaleHeight, s);
  Real spot = ray.Infinite != 0 ? 1.0 : SpotFactor(ray, s, r);
  return spot * exp(-tau) *
    (ScatteredPart(first, height, cosAngle) + ScatteredPart(second, height, cosAngle));
}

// Where a fraction of the way between two places of a ray ends when it is counted in lengths or, for
// a point light, in angles at the light, by which light comes evenly from all of the ray if nothing
// dims it.
// Formula: begin + t (end - begin), or Foot + h tan(a + t (b - a)), with a and b the angles of begin
// and end. [length] [KullaFajardo2012]
FUNCTION Real MediumPlace(
  IN(LitRay) ray, IN(Real) begin, IN(Real) end, IN(Real) t)
{
  GODRAYS_EXPECT(begin <= end && t >= 0.0 && t <= 1.0);
  if (ray.Infinite != 0)
  {
    return begin + t * (end - begin);
  }
  Real h = PointLightHeight(ray.Foot, ray.Distance, begin, end);
  Real angle = t * atan(h * (end - begin), h * h + (begin - ray.Foot) * (end - ray.Foot));
  Real low = begin - ray.Foot;
  // tan(a + angle) with tan(a) = low/h
  Real place = ray.Foot + h * (low * cos(angle) + h * sin(angle)) / (h * cos(angle) - low * sin(angle));
  return t < 1.0 ? clamp(place, begin, end) : end;
}

// The inverse of MediumPlace(): which fraction of the way ends at a place of the ray.
// Formula: (place - begin)/(end - begin), or the angle of place at the light over that of end. [no unit]
FUNCTION Real MediumFraction(
  IN(LitRay) ray, IN(Real) begin, IN(Real) end, IN(Real) place)
{
  GODRAYS_EXPECT(begin <= end && place >= begin && place <= end);
  Real all = end - begin;
  Real part = place - begin;
  if (ray.Infinite == 0)
  {
    Real h = PointLightHeight(ray.Foot, ray.Distance, begin, end);
    all = atan(h * all, h * h + (begin - ray.Foot) * (end - ray.Foot));
    part = atan(h * part, h * h + (begin - ray.Foot) * (place - ray.Foot));
  }
  return part < all ? part / all : 1.0;
}

// Airlight of a part of a ray, for a light of irradiance or intensity 1. For a light that is
// infinitely far, in a medium that is homogeneous or has one component over a plane,
// DirectionalAirlight() or ExponentialAirlight(); otherwise Gauss-Legendre with 2 points, in lengths or,
// for a point light, in angles: parts should be so small that light falls by no more than 1/e along them.
// Formula: integral_begin^end MediumIntegrand ds, or MediumIntegrand/r^2 ds. [1/sr] or
// [1/(length^2 sr)]
FUNCTION Real MediumAirlight(IN(MediumComponent) first, IN(MediumComponent) second,
  IN(LitRay) ray, IN(Real) begin, IN(Real) end)
{
  GODRAYS_EXPECT(begin >= 0.0 && begin <= end);
  if (ray.Infinite != 0 && first.ScaleHeight == 0.0 && second.ScaleHeight == 0.0)
  {
    return (ScatteredPart(first, 0.0, ray.Foot) + ScatteredPart(second, 0.0, ray.Foot)) *
      DirectionalAirlight(first.Extinction + second.Extinction, begin, end, 0.0, 0.0);
  }
  if (ray.Infinite != 0 && second.Extinction == 0.0 && ray.PlanetRadius <= 0.0)
  {
    return ScatteredPart(first, 0.0, ray.Foot) *
      ExponentialAirlight(first.Extinction, ray.Height, ray.Slope, max(ray.LightHeight, 1e-6),
        first.ScaleHeight, begin, end);
  }
  Real weight = end - begin;
  if (ray.Infinite == 0)
  {
    weight = PointAirlight(ray.Foot, ray.Distance, begin, end);
  }
  Real low = MediumPlace(ray, begin, end, 0.2113248654051871);
  Real high = MediumPlace(ray, begin, end, 0.7886751345948129);
  return 0.5 * weight *
    (MediumIntegrand(first, second, ray, low) + MediumIntegrand(first, second, ray, high));
}
