// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Phase
//VTK::GodRays::Planet

// A planet's atmosphere in spherical shells. Lengths and the reciprocals of coefficients have one unit,
// e.g. metres. A way starts at a height above the ground; slope is its cosine with the vertical there, 1
// straight up, 0 level. Distances from the planet's centre are never subtracted, so that metres count in
// single precision, too. Ways stay above the ground and below the atmosphere's top.

// How dense a constituent is at each height.
struct SkyProfile
{
  int Kind;    // 0 exponential e^(-h/Height), 1 uniform up to Height, 2 layer 1 - |h - Height|/Width
  Real Height; // the scale height, the top, or the height of the layer's middle [length]
  Real Width;  // half that of a layer [length]
};

struct SkyAtmosphere
{
  Real GroundRadius;      // of the planet [length]
  Real TopHeight;         // beyond is nothing [length]
  SkyProfile Air;         // molecules
  SkyProfile Aerosol;     // droplets and dust
  SkyProfile Absorber;    // ozone
  Vec3 AirScattering;     // where their density is 1, as all that follow [1/length]
  Vec3 AerosolScattering; // [1/length]
  Vec3 AerosolExtinction; // scattering and absorption [1/length]
  Vec3 Absorption;        // [1/length]
  PhaseFunction AirPhase;
  int AerosolPhaseKind;
  Vec3 AerosolAsymmetry;  // of its phase function, for each colour [no unit]
};

// The integral along a way of how far it is below topHeight. The height is nearly quadratic along it:
// Gauss-Legendre of 3 points.
// Formula: integral max(topHeight - h, 0) ds. [length^2]
FUNCTION Real SkyRampColumn(IN(Real) groundRadius, IN(Real) topHeight, IN(Real) height,
  IN(Real) slope, IN(Real) distance)
{
  GODRAYS_EXPECT(distance >= 0.0);
  Vec2 part = SkyBelow(groundRadius, height, slope, topHeight);
  Real middle = 0.5 * (part.x + min(part.y, distance));
  Real reach = min(part.y, distance) - middle;
  if (reach <= 0.0)
  {
    return 0.0;
  }
  Real radius = groundRadius + height;
  Real sides = SkyRise(radius, slope, middle - 0.7745966692414834 * reach) +
    SkyRise(radius, slope, middle + 0.7745966692414834 * reach);
  Real mean = (5.0 * sides + 8.0 * SkyRise(radius, slope, middle)) / 18.0;
  return 2.0 * reach * max(topHeight - height - mean, 0.0);
}

// Density of a profile at a height. Formula: see SkyProfile. [no unit]
FUNCTION Real SkyDensity(IN(SkyProfile) profile, IN(Real) height)
{
  GODRAYS_EXPECT(profile.Kind != 0 || profile.Height > 0.0);
  GODRAYS_EXPECT(profile.Kind != 2 || profile.Width > 0.0);
  if (profile.Kind == 0)
  {
    return ExponentialDensity(height, profile.Height);
  }
  if (profile.Kind == 1)
  {
    return height <= profile.Height ? 1.0 : 0.0;
  }
  return max(1.0 - abs(height - profile.Height) / profile.Width, 0.0);
}

// The integral of a profile's density along a way. A layer is the second difference of three ramps.
// Formula: integral density ds. [length]
FUNCTION Real SkyColumn(IN(SkyProfile) profile, IN(Real) groundRadius, IN(Real) height,
  IN(Real) slope, IN(Real) distance)
{
  GODRAYS_EXPECT(groundRadius > 0.0 && IsCosine(slope) && distance >= 0.0);
  GODRAYS_EXPECT(profile.Kind != 2 || profile.Width > 0.0);
  if (profile.Kind == 0)
  {
    return SkyExponentialColumn(groundRadius, profile.Height, height, slope, distance);
  }
  if (profile.Kind == 1)
  {
    Vec2 part = SkyBelow(groundRadius, height, slope, profile.Height);
    return max(min(part.y, distance) - part.x, 0.0);
  }
  Real low = profile.Height - profile.Width;
  Real high = profile.Height + profile.Width;
  return (SkyRampColumn(groundRadius, low, height, slope, distance) -
           2.0 * SkyRampColumn(groundRadius, profile.Height, height, slope, distance) +
           SkyRampColumn(groundRadius, high, height, slope, distance)) /
    profile.Width;
}

// Optical depth of a way. Formula: sum of extinction SkyColumn. [no unit]
FUNCTION Vec3 SkyDepth(
  IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) slope, IN(Real) distance)
{
  Vec3 depth =
    sky.AirScattering * SkyColumn(sky.Air, sky.GroundRadius, height, slope, distance) +
    sky.AerosolExtinction * SkyColumn(sky.Aerosol, sky.GroundRadius, height, slope, distance);
  if (dot(sky.Absorption, sky.Absorption) > 0.0)
  {
    depth += sky.Absorption * SkyColumn(sky.Absorber, sky.GroundRadius, height, slope, distance);
  }
  return depth;
}

// The part of a way, from distance x to y, that is in the planet's shadow, where there is no ground
// between; x above y if there is none. sunSlope is the slope of the way to the sun from the start,
// cosAngle the cosine of the angle between both. The sun is a point, infinitely far away.
// Formula: |P|^2 - (P sun)^2 < GroundRadius^2 and P sun < 0 for P = start + d way. [length]
FUNCTION Vec2 SkyShadow(IN(Real) groundRadius, IN(Real) height, IN(Real) slope,
  IN(Real) sunSlope, IN(Real) cosAngle)
{
  GODRAYS_EXPECT(groundRadius > 0.0);
  GODRAYS_EXPECT(IsCosine(slope) && IsCosine(sunSlope) && IsCosine(cosAngle));
  Real radius = groundRadius + height;
  Real towards = radius * sunSlope;
  Real a = 1.0 - cosAngle * cosAngle;
  Real b = radius * (slope - sunSlope * cosAngle);
  Real c = height * (2.0 * groundRadius + height) - towards * towards;
  Real root = b * b - a * c;
  Vec2 part = Vec2(0.0, 1e30);
  if (a > 1e-12)
  {
    if (root <= 0.0)
    {
      return Vec2(1.0, 0.0);
    }
    part = Vec2((-b - sqrt(root)) / a, (-b + sqrt(root)) / a);
  }
  else if (c >= 0.0)
  {
    return Vec2(1.0, 0.0);
  }
  Real terminator = abs(cosAngle) > 1e-12 ? -towards / cosAngle : (towards < 0.0 ? 1e30 : -1e30);
  if (cosAngle >= 0.0)
  {
    part.y = min(part.y, terminator);
  }
  else
  {
    part.x = max(part.x, terminator);
  }
  return Vec2(max(part.x, 0.0), part.y);
}

// Light that reaches a point from the sun: what is left of it, apart from the planet's shadow.
// Formula: e^-SkyDepth(to the top). [no unit]
FUNCTION Vec3 SkySunTransmittance(IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) sunSlope)
{
  Vec2 way = SkyBelow(sky.GroundRadius, height, sunSlope, sky.TopHeight);
  return exp(-SkyDepth(sky, height, sunSlope, max(way.y, 0.0)));
}

// The aerosol's phase function, for each colour, of a kind and three asymmetries. [1/sr]
FUNCTION Vec3 SkyAerosolPhase(int kind, IN(Vec3) asymmetry, IN(Real) cosAngle)
{
  PhaseFunction red;
  red.Kind = kind;
  red.Asymmetry = asymmetry.x;
  PhaseFunction green = red;
  green.Asymmetry = asymmetry.y;
  PhaseFunction blue = red;
  blue.Asymmetry = asymmetry.z;
  return Vec3(Phase(red, cosAngle), Phase(green, cosAngle), Phase(blue, cosAngle));
}

// Light of the sun that is scattered once, on a unit of a way, into the way's start, for an irradiance of
// 1; the point is not in the planet's shadow. Its integral along the way is the sky's radiance.
// Formula: (beta_air density phase + beta_aerosol density phase) e^-(depth to the start + depth to the
// sun). [1/(length sr)] [Nishita1993]
FUNCTION Vec3 SkyInscatter(IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) slope,
  IN(Real) sunSlope, IN(Real) cosAngle, IN(Real) distance)
{
  GODRAYS_EXPECT(IsCosine(slope) && IsCosine(sunSlope) && IsCosine(cosAngle));
  Real radius = sky.GroundRadius + height;
  Real rise = SkyRise(radius, slope, distance);
  Real sunSlopeThere = clamp((radius * sunSlope + distance * cosAngle) / (radius + rise), -1.0, 1.0);
  Vec3 scattered = sky.AirScattering * (SkyDensity(sky.Air, height + rise) * Phase(sky.AirPhase, cosAngle)) +
    sky.AerosolScattering * SkyDensity(sky.Aerosol, height + rise) * 
      SkyAerosolPhase(sky.AerosolPhaseKind, sky.AerosolAsymmetry, cosAngle);
  return scattered * exp(-SkyDepth(sky, height, slope, distance)) *
    SkySunTransmittance(sky, height + rise, sunSlopeThere);
}

// Light of the sun that the ground reflects into all directions alike, after Lambert, for an irradiance of
// 1; 0 at night. Formula: albedo/pi sunSlope SkySunTransmittance. [1/sr]
FUNCTION Vec3 SkyGround(IN(SkyAtmosphere) sky, IN(Vec3) albedo, IN(Real) sunSlope)
{
  GODRAYS_EXPECT(IsCosine(sunSlope));
  if (sunSlope <= 0.0)
  {
    return Vec3(0.0);
  }
  return albedo * (0.31830988618379067 * sunSlope) * SkySunTransmittance(sky, 0.0, sunSlope);
}

// Where a table of light that comes from everywhere alike has a height and a slope of the way to the sun,
// 0 to 1 in each: denser about the horizon, and towards the ground.
// Formula: (1 + sign(slope) sqrt(|slope|))/2, sqrt(height/topHeight). [no unit]
FUNCTION Vec2 SkyMultiplePosition(IN(Real) topHeight, IN(Real) height, IN(Real) sunSlope)
{
  GODRAYS_EXPECT(topHeight > 0.0 && IsCosine(sunSlope));
  Real root = sqrt(abs(sunSlope));
  return Vec2(0.5 * (sunSlope < 0.0 ? 1.0 - root : 1.0 + root),
    sqrt(clamp(height / topHeight, 0.0, 1.0)));
}

// A way through the atmosphere, from an observer or from where it enters.
struct SkyWay
{
  Real Height;
  Real Slope;
  Real SunSlope;    // of the way to the sun from the start
  Real CosAngle;    // of the angle to the sun
  Real Length;      // negative if there is no atmosphere along it
  bool MeetsGround;
};

// The slope of the way at the height at which it enters the atmosphere follows from its lowest point, so
// that single precision does for planets that are seen from far away.
// Formula: slope -sqrt(u (2 top - u))/top, u being how far the lowest point is below the top, of radius top.
FUNCTION SkyWay MakeSkyWay(IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) slope, IN(Real) sunSlope,
  IN(Real) cosAngle)
{
  GODRAYS_EXPECT(IsCosine(slope) && IsCosine(sunSlope) && IsCosine(cosAngle));
  SkyWay way;
  way.Height = height;
  way.Slope = slope;
  way.SunSlope = sunSlope;
  way.CosAngle = cosAngle;
  way.Length = -1.0;
  way.MeetsGround = false;
  Vec2 within = SkyBelow(sky.GroundRadius, height, slope, sky.TopHeight);
  if (within.x > within.y)
  {
    return way;
  }
  if (within.x > 0.0)
  {
    Real radius = sky.GroundRadius + height;
    Real top = sky.GroundRadius + sky.TopHeight;
    Real under = max(sky.TopHeight - height - SkyRise(radius, slope, -radius * slope), 0.0);
    way.Height = sky.TopHeight;
    way.Slope = -min(sqrt(under * (2.0 * top - under)) / top, 1.0);
    way.SunSlope = clamp((radius * sunSlope + within.x * cosAngle) / top, -1.0, 1.0);
  }
  Real ground = SkyGroundDistance(sky.GroundRadius, way.Height, way.Slope);
  way.MeetsGround = ground >= 0.0;
  way.Length = way.MeetsGround ? ground : within.y - within.x;
  return way;
}

// Height of a point of a way, and the slope of the way to the sun from there.
// Formula: height + SkyRise, (r sunSlope + distance cosAngle)/(r + SkyRise). [length, no unit]
FUNCTION Vec2 SkyPoint(IN(SkyAtmosphere) sky, IN(SkyWay) way, IN(Real) distance)
{
  GODRAYS_EXPECT(distance >= 0.0);
  Real radius = sky.GroundRadius + way.Height;
  Real rise = SkyRise(radius, way.Slope, distance);
  return Vec2(max(way.Height + rise, 0.0),
    clamp((radius * way.SunSlope + distance * way.CosAngle) / (radius + rise), -1.0, 1.0));
}

// The slopes at which an observer sees the ground's horizon and the atmosphere's edge; the latter is 1
// within it. Formula: -sqrt((height - h) (2 GroundRadius + height + h))/(GroundRadius + height). [no unit]
FUNCTION Vec2 SkyEdges(IN(Real) groundRadius, IN(Real) topHeight, IN(Real) height)
{
  GODRAYS_EXPECT(groundRadius > 0.0 && height >= 0.0);
  Real radius = groundRadius + height;
  Real above = height - topHeight;
  return Vec2(-sqrt(height * (groundRadius + radius)) / radius,
    above < 0.0 ? 1.0 : -sqrt(above * (groundRadius + radius + topHeight)) / radius);
}

// Tables of all directions in which an observer sees air have rows of slopes, dense about the horizon: -1
// the nadir, 0 the horizon, 1 the zenith or the atmosphere's edge, about which they are even in angle. This
// is the slope of a row, and the row of a slope.
// Formula: horizon + (edge - horizon) (1 - (1 - row^4)^2), the edge being -1 below the horizon. [no unit]
FUNCTION Real SkyTableSlope(IN(Vec2) edges, IN(Real) row)
{
  GODRAYS_EXPECT(row >= -1.0 && row <= 1.0);
  Real square = row * row;
  Real fourth = square * square;
  return edges.x + (row < 0.0 ? -1.0 - edges.x : edges.y - edges.x) * (fourth * (2.0 - fourth));
}

FUNCTION Real SkyTableRow(IN(Vec2) edges, IN(Real) slope)
{
  GODRAYS_EXPECT(IsCosine(slope));
  Real away = slope - edges.x;
  Real part = clamp(away < 0.0 ? -away / (1.0 + edges.x) : away / (edges.y - edges.x), 0.0, 1.0);
  Real row = sqrt(sqrt(part / (1.0 + sqrt(1.0 - part))));
  return away < 0.0 ? -row : row;
}

// How bright the sun's disc is at a part of its radius from its middle, for each of the colours 680, 550
// and 440 nm, as a fraction of the mean over the disc: its limb is darker.
// Formula: (1 + a/2) (1 - part^2)^(a/2), a = 0.292 um/wavelength - 0.023. [no unit] [HestrofferMagnan1998]
FUNCTION Vec3 SunLimb(IN(Real) part)
{
  GODRAYS_EXPECT(part >= 0.0);
  Vec3 a = Vec3(0.4064, 0.5079, 0.6406);
  Real square = max(1.0 - part * part, 1e-4);
  return (1.0 + 0.5 * a) *
    Vec3(pow(square, 0.5 * a.x), pow(square, 0.5 * a.y), pow(square, 0.5 * a.z));
}
