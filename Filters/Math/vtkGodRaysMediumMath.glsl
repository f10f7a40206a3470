// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Phase
//VTK::GodRays::Planet

// Light that a medium scatters once on its way to the eye. Lengths and the reciprocals of
// coefficients have one unit, e.g. metres. Everything is finite for coefficients from 0 to 1e3,
// lengths to 1e9 and |asymmetry| to 0.99, and without loss of figures where they are small.

// What is left of light after a way through a homogeneous medium: the law of Beer and Lambert.
// Formula: e^(-extinction distance). [no unit]
FUNCTION Real Transmittance(IN(Real) extinction, IN(Real) distance)
{
  GODRAYS_EXPECT(extinction >= 0.0 && distance >= 0.0);
  return exp(-extinction * distance);
}

// e^-tau MeanExponential(k) where tau and tau + k, the optical depths of two ends, are at least 0:
// the mean of e^-t between them, without overflow where k < 0.
// Formula: (e^-tau - e^-(tau + k))/k. [no unit]
FUNCTION Real MeanTransmittance(IN(Real) tau, IN(Real) k)
{
  GODRAYS_EXPECT(tau >= 0.0 && tau + k >= -1e-5 * (1.0 + tau));
  return k < 0.0 ? exp(-(tau + k)) * MeanExponential(-k) : exp(-tau) * MeanExponential(k);
}

// Airlight of a directional light in a homogeneous medium, from the part of a view ray between the
// distances begin and end of the eye, where the light's own way through the medium to the point at
// distance s is lightWay + lightSlope s long, at least 0: 0 and 0 for a light that is not dimmed, 0
// and c for a medium with a plane surface. The radiance is irradiance * phase * scattering
// coefficient * this; parts add up.
// Formula: integral_begin^end e^(-extinction (s + lightWay + lightSlope s)) ds. [length]
// [HoffmanPreetham2002]
FUNCTION Real DirectionalAirlight(IN(Real) extinction, IN(Real) begin, IN(Real) end,
  IN(Real) lightWay, IN(Real) lightSlope)
{
  GODRAYS_EXPECT(extinction >= 0.0 && begin <= end);
  GODRAYS_EXPECT(min(lightWay + lightSlope * begin, lightWay + lightSlope * end) >= -1e-5 * end);
  Real tau = extinction * (begin + lightWay + lightSlope * begin);
  return (end - begin) * MeanTransmittance(tau, extinction * (1.0 + lightSlope) * (end - begin));
}

// The distance of the light from the view ray as the functions below count it: 0 would make the
// airlight of a light on the ray infinite.
// Formula: max(height, 1e-9 |the ray's ends as seen from the foot|). [length]
FUNCTION Real PointLightHeight(
  IN(Real) foot, IN(Real) height, IN(Real) begin, IN(Real) end)
{
  GODRAYS_EXPECT(height >= 0.0);
  return max(height, 1e-9 * max(abs(begin - foot), abs(end - foot)) + 1e-18);
}

// Airlight of a point light in a medium that does not dim it, from the part of a view ray between
// the distances begin and end of the eye. foot is the distance along the ray of the point nearest to
// the light, height the light's distance from it. The radiance is intensity * phase (a constant) *
// scattering coefficient * this; parts add up.
// Formula: integral_begin^end ds/(h^2 + (s - foot)^2)
//   = atan2(h (end - begin), h^2 + (begin - foot) (end - foot))/h. [1/length] [Pegoraro2009]
FUNCTION Real PointAirlight(IN(Real) foot, IN(Real) height, IN(Real) begin, IN(Real) end)
{
  GODRAYS_EXPECT(height >= 0.0 && begin <= end);
  Real h = PointLightHeight(foot, height, begin, end);
  Real opposite = h * (end - begin);
  Real adjacent = h * h + (begin - foot) * (end - foot);
  if (opposite < 1e-2 * adjacent)
  {
    Real q = opposite / adjacent;
    Real q2 = q * q;
    Real mean = 1.0 - q2 * (1.0 / 3.0 - q2 * (0.2 - q2 * (1.0 / 7.0 - q2 / 9.0)));
    return (end - begin) / adjacent * mean;
  }
  return atan(opposite, adjacent) / h;
}

// The variable of the integral below, without cancellation before the foot.
// Formula: y = s - foot + r(s), r^2 = h^2 + (s - foot)^2. [length]
FUNCTION Real PointLightWay(IN(Real) beyondFoot, IN(Real) h)
{
  GODRAYS_EXPECT(h > 0.0);
  Real r = sqrt(h * h + beyondFoot * beyondFoot);
  return beyondFoot > 0.0 ? r + beyondFoot : h * (h / (r - beyondFoot));
}

// Two points of the panel of PointAirlight, symmetric about its middle, at place of its half to either side.
// Formula: sum of phase((h^2 - y^2)/(h^2 + y^2)) e^(-extinction (y - start))/(h^2 + y^2). [1/(length^2 sr)]
FUNCTION Real PointAirlightPair(IN(PhaseFunction) phase, IN(Real) extinction, IN(Real) h,
  IN(Real) start, IN(Real) size, IN(Real) place)
{
  GODRAYS_EXPECT(extinction >= 0.0 && h > 0.0);
  GODRAYS_EXPECT(size >= 0.0 && place >= 0.0 && place <= 1.0);
  Real sum = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    Real along = size * (i == 0 ? 0.5 - 0.5 * place : 0.5 + 0.5 * place);
    Real y = start + along;
    Real square = h * h + y * y;
    sum += Phase(phase, (h - y) * (h + y) / square) * exp(-extinction * along) / square;
  }
  return sum;
}

// The same in a homogeneous medium that dims the light on its way to each point and from there to
// the eye, with any phase function. The radiance is intensity * scattering coefficient * this.
// With y = s - foot + r, the integrand is smooth on the scale of y itself: Gauss-Legendre of 8
// points in panels that grow by 3/4, each at most 3 mean free paths long, at most 96 of them, up to
// 40 mean free paths. Relative error below 1e-9 (in double precision).
// Formula: integral_begin^end phase e^(-extinction (s + r))/r^2 ds, r^2 = h^2 + (s - foot)^2,
// = e^(-extinction (begin + r(begin))) integral 2 phase((h^2 - y^2)/(h^2 + y^2))
//   e^(-extinction (y - y(begin)))/(h^2 + y^2) dy. [1/(length sr)]
// For an isotropic phase function that is the airlight model of [Sun2005], with y = h tan xi.
FUNCTION Real PointAirlight(IN(PhaseFunction) phase, IN(Real) extinction, IN(Real) foot,
  IN(Real) height, IN(Real) begin, IN(Real) end)
{
  GODRAYS_EXPECT(height >= 0.0 && begin <= end);
  Real h = PointLightHeight(foot, height, begin, end);
  Real y = PointLightWay(begin - foot, h);
  Real rNear = sqrt(h * h + (begin - foot) * (begin - foot));
  Real rFar = sqrt(h * h + (end - foot) * (end - foot));
  Real left = (end - begin) * (y + PointLightWay(end - foot, h)) / (rNear + rFar);
  // The integrand's poles are at y = +-i h and at +-i times this, since y/h is the tangent of half the
  // scattering angle.
  Real scale = h * PhasePole(phase);
  Real tau = 0.0;
  Real sum = 0.0;
  for (int panel = 0; panel < 96; ++panel)
  {
    Real size = 0.75 * sqrt(scale * scale + y * y);
    size = min(left, extinction * size > 3.0 ? 3.0 / extinction : size);
    sum += exp(-tau) * size *
      (0.3626837833783620 * PointAirlightPair(phase, extinction, h, y, size, 0.1834346424956498) +
        0.3137066458778873 * PointAirlightPair(phase, extinction, h, y, size, 0.5255324099163290) +
        0.2223810344533745 * PointAirlightPair(phase, extinction, h, y, size, 0.7966664774136267) +
        0.1012285362903763 * PointAirlightPair(phase, extinction, h, y, size, 0.9602898564975363));
    tau += extinction * size;
    y += size;
    left -= size;
    if (left <= 0.0 || tau > 40.0)
    {
      break;
    }
  }
  return exp(-extinction * (begin + rNear)) * sum;
}

// A medium whose density falls exponentially with height above the plane of reference, where its
// coefficients are given. slope is the rise of a way for each unit of its length, -1 to 1.

// Optical depth of a straight way from a height, up or down.
// Formula: extinction distance e^(-height/H) phi(slope distance/H), phi = MeanExponential. [no unit]
FUNCTION Real ExponentialDepth(IN(Real) extinction, IN(Real) height, IN(Real) slope,
  IN(Real) scaleHeight, IN(Real) distance)
{
  GODRAYS_EXPECT(extinction >= 0.0 && scaleHeight > 0.0);
  GODRAYS_EXPECT(IsCosine(slope) && distance >= 0.0);
  Real rise = slope * distance;
  Real low = ExponentialDensity(rise < 0.0 ? height + rise : height, scaleHeight);
  return extinction * distance * low * MeanExponential(abs(rise) / scaleHeight);
}

// The height at which a way from another one ends.
// Formula: height + slope distance, or height + SkyRise. [length]
FUNCTION Real MediumHeight(
  IN(Real) planetRadius, IN(Real) height, IN(Real) slope, IN(Real) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && IsCosine(slope) && distance >= 0.0);
  return height +
    (planetRadius > 0.0 ? SkyRise(planetRadius + height, slope, distance) : slope * distance);
}

// The slope of a straight way of known length between two heights, where it starts.
// Formula: (end - height)/distance, or, from (R + end)^2 = (R + height)^2 + d^2 + 2 (R + height) d slope,
// ((end - height) (2 R + height + end) - d^2)/(2 (R + height) d). [no unit]
FUNCTION Real MediumSlope(
  IN(Real) planetRadius, IN(Real) height, IN(Real) end, IN(Real) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && distance > 0.0);
  if (planetRadius > 0.0)
  {
    Real rise = (end - height) * ((2.0 * planetRadius + height + end) / distance) - distance;
    return clamp(rise / (2.0 * (planetRadius + height)), -1.0, 1.0);
  }
  return (end - height) / distance;
}

// Length of a way times the mean density along it; a scale height of 0 stands for a homogeneous medium.
// The ground bends away by distance^2/(2 planetRadius): where that is little of the scale height, a
// plane of the same rise is exact to 1e-5, without the differences of SkyExponentialColumn().
// Formula: distance, ExponentialDepth(1, ...), or SkyExponentialColumn. [length]
FUNCTION Real MediumDepth(IN(Real) planetRadius, IN(Real) height, IN(Real) slope,
  IN(Real) scaleHeight, IN(Real) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && IsCosine(slope));
  GODRAYS_EXPECT(scaleHeight >= 0.0 && distance >= 0.0);
  if (scaleHeight <= 0.0)
  {
    return distance;
  }
  if (planetRadius > 0.0 && distance * (distance / planetRadius) > 1e-4 * scaleHeight)
  {
    return SkyExponentialColumn(planetRadius, scaleHeight, height, slope, distance);
  }
  Real rise = MediumHeight(planetRadius, height, slope, distance) - height;
  return ExponentialDepth(1.0, height, rise / max(distance, 1e-30), scaleHeight, distance);
}

// The same of a way to where nothing is any more, of a medium of exponential density: up over a plane, else to
// 40 scale heights above.
// Formula: scaleHeight density/slope, or SkyExponentialColumn. [length]
FUNCTION Real MediumColumn(
  IN(Real) planetRadius, IN(Real) height, IN(Real) slope, IN(Real) scaleHeight)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && IsCosine(slope) && scaleHeight > 0.0);
  if (planetRadius > 0.0)
  {
    Real end = SkyBelow(planetRadius, height, slope, max(height, 0.0) + 40.0 * scaleHeight).y;
    return SkyExponentialColumn(planetRadius, scaleHeight, height, slope, end);
  }
  return scaleHeight * ExponentialDensity(height, scaleHeight) / max(slope, 1e-6);
}

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

// Airlight of a directional light in it, from the part of a view ray between the distances begin and
// end of the eye, which is at height; lightSlope is the rise towards the light, above 0. The light is
// dimmed on its way from above. The ground is plane: from 85 degrees of the zenith on a sphere
// differs. The radiance is irradiance * phase * scattering coefficient at height 0 * this; parts add
// up.
// Formula: D e^-tau(begin) e^(-b X0/lightSlope) phi(b (1 - slope/lightSlope) D/H),
// D = integral_begin^end X ds = X0 (end - begin) phi(slope (end - begin)/H), X = e^(-height/H), b =
// extinction H, X0 at begin. [length] [PreethamShirleySmits1999] for constant slopes
FUNCTION Real ExponentialAirlight(IN(Real) extinction, IN(Real) height, IN(Real) slope,
  IN(Real) lightSlope, IN(Real) scaleHeight, IN(Real) begin, IN(Real) end)
{
  GODRAYS_EXPECT(extinction >= 0.0 && IsCosine(slope) && lightSlope > 0.0);
  GODRAYS_EXPECT(scaleHeight > 0.0 && begin >= 0.0 && begin <= end);
  Real start = height + slope * begin;
  Real column = ExponentialDepth(1.0, start, slope, scaleHeight, end - begin);
  Real tau = ExponentialDepth(extinction, height, slope, scaleHeight, begin) +
    extinction * scaleHeight * ExponentialDensity(start, scaleHeight) / lightSlope;
  return column * MeanTransmittance(tau, extinction * column * (1.0 - slope / lightSlope));
}

// Where a directional light's airlight from the first part of a ray is a given part of that from an
// endless one, in a homogeneous medium: steps between such places carry equal light. all is the part
// of the whole ray, tau MeanExponential(tau) for its optical depth tau.
// Formula: -ln(1 - fraction all)/extinction, as a series where all is below 0.01; distance is the
// whole ray's length. [length]
FUNCTION Real AirlightPlace(
  IN(Real) extinction, IN(Real) distance, IN(Real) all, IN(Real) fraction)
{
  GODRAYS_EXPECT(extinction >= 0.0 && distance >= 0.0);
  GODRAYS_EXPECT(all >= 0.0 && all <= 1.0 && fraction >= 0.0 && fraction <= 1.0);
  Real x = fraction * all;
  if (all < 0.01)
  {
    Real mean = all / max(extinction * distance, 1e-30);
    return distance * (mean > 0.5 ? mean : 1.0) * fraction *
      (1.0 + x * (0.5 + x * (1.0 / 3.0 + 0.25 * x)));
  }
  return -log(max(1.0 - x, 1e-30)) / extinction;
}

// The depth at which something at view depth z hides a point light, or one that is infinitely far,
// from a view ray. lightZ and lightW are of the light's view coordinates (x, y, z)/w, z forwards; m is
// how far the thing is along the march from the ray's point of the picture towards the light's:
// picture + m ((x, y) - picture z) at depth 1, or picture + m ((x, y) - picture w) in a parallel view.
// 1e30 if it is beyond the light.
// Formula: (1 - m lightZ)/(1/z - m lightW), or (z - m lightZ)/(1 - m lightW): a line is straight in the
// picture and in 1/z, or z. [length]
FUNCTION Real HiddenDepth(
  IN(bool) parallel, IN(Real) lightZ, IN(Real) lightW, IN(Real) z, IN(Real) m)
{
  Real over = parallel ? z - m * lightZ : z * (1.0 - m * lightZ);
  Real under = 1.0 - m * lightW * (parallel ? 1.0 : z);
  return under > 1e-6 ? min(over / under, 1e30) : 1e30;
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
  Real CosCone;      // cosine of half its cone's angle; 0: the light shines everywhere
  Real SpotExponent; // at least 0; how it fades towards the cone's edge
};

// The part of a ray, from x to y, that is within a spotlight's cone, at most from 0 to end; y is 0 if
// there is none.
// Formula: (AxisStart + AxisSlope s)^2 >= CosCone^2 (Distance^2 + (s - Foot)^2), AxisStart + AxisSlope s
// >= 0. [length]
FUNCTION Vec2 SpotPart(IN(LitRay) ray, IN(Real) end)
{
  GODRAYS_EXPECT(end >= 0.0);
  if (ray.CosCone <= 0.0)
  {
    return Vec2(0.0, end);
  }
  Real square = ray.CosCone * ray.CosCone;
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

// How much of a spotlight's intensity leaves it towards a point of the ray, r from it, in its cone.
// Formula: cos(angle to the axis)^SpotExponent. [no unit]
FUNCTION Real SpotFactor(IN(LitRay) ray, IN(Real) s, IN(Real) r)
{
  GODRAYS_EXPECT(r > 0.0);
  Real cosine = (ray.AxisStart + ray.AxisSlope * s) / r;
  return ray.CosCone > 0.0 && ray.SpotExponent > 0.0
    ? pow(clamp(cosine, 1e-30, 1.0), ray.SpotExponent)
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
// its result; a plane hides nothing. Formula: SkyGroundDistance towards the light is one, and below r.
FUNCTION bool IsInPlanetShadow(IN(LitRay) ray, IN(Real) height, IN(Real) slope, IN(Real) r)
{
  Real ground =
    ray.PlanetRadius > 0.0 ? SkyGroundDistance(ray.PlanetRadius, height, slope) : -1.0;
  return ground >= 0.0 && (ray.Infinite != 0 || ground < r);
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

// Airlight of a part of a ray, for a light of irradiance or intensity 1. For a light that is
// infinitely far, in a medium that is homogeneous or has one component over a plane,
// DirectionalAirlight() or ExponentialAirlight(); otherwise Gauss-Legendre with 2 points, in lengths or, for a point light, in
// angles: parts should be so small that light falls by no more than 1/e along them.
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
