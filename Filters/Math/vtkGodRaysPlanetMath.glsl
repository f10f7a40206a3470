// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Straight ways above a planet: heights, and columns of an exponential density. A way starts at a height
// above the ground; slope is its cosine with the vertical there, 1 straight up, 0 level.

//VTK::GodRays::Common

// Density at a height, of that at height 0; the height is kept within 80 scale heights of that.
// Formula: e^(-height/scaleHeight). [no unit]
FUNCTION Real ExponentialDensity(IN(RealLength) height, IN(RealLength) scaleHeight)
{
  GODRAYS_EXPECT(scaleHeight > 0.0);
  return exp(-clamp(height / scaleHeight, -80.0, 80.0));
}

// How much higher the end of a way is than its start, without cancellation.
// Formula: d (2 r slope + d)/(r + sqrt(r^2 + d (2 r slope + d))), r the start's radius. [length]
FUNCTION RealLength SkyRise(IN(RealLength) radius, IN(Real) slope, IN(RealLength) distance)
{
  GODRAYS_EXPECT(radius > 0.0 && IsCosine(slope) && distance >= 0.0);
  RealArea more = distance * (2.0 * radius * slope + distance);
  return more / (radius + sqrt(max(radius * radius + more, 0.0)));
}

// The part of a way, from distance x to distance y, that is below topHeight; x above y if there is none.
// Formula: d^2 + 2 r slope d = (top - height) (2 GroundRadius + top + height). [length]
FUNCTION Vec2Length SkyBelow(
  IN(RealLength) groundRadius, IN(RealLength) height, IN(Real) slope, IN(RealLength) topHeight)
{
  GODRAYS_EXPECT(groundRadius + height > 0.0 && IsCosine(slope));
  RealLength along = (groundRadius + height) * slope;
  RealArea room = (topHeight - height) * (2.0 * groundRadius + topHeight + height);
  RealArea square = along * along + room;
  if (square < 0.0 || (room < 0.0 && along >= 0.0))
  {
    return Vec2Length(1.0, 0.0);
  }
  RealLength root = sqrt(square);
  RealLength leave = along > 0.0 ? room / (along + root) : root - along;
  return Vec2Length(room < 0.0 ? -room / (root - along) : RealLength(0.0), leave);
}

// The distance at which a way meets the ground; -1 if it does not.
// Formula: height (2 GroundRadius + height)/(-r slope + sqrt(...)), as SkyBelow's entry. [length]
FUNCTION RealLength SkyGroundDistance(IN(RealLength) groundRadius, IN(RealLength) height,
  IN(Real) slope)
{
  GODRAYS_EXPECT(groundRadius + height > 0.0 && IsCosine(slope));
  RealLength along = (groundRadius + height) * slope;
  RealArea room = max(height, 0.0) * (2.0 * groundRadius + height);
  RealArea square = along * along - room;
  return slope < 0.0 && square >= 0.0 ? room / (sqrt(square) - along) : RealLength(-1.0);
}

// e^(z^2) erfc(z) for z from 0 on, to 1.2e-7 of itself.
// Formula: t e^P(t), t = 1/(1 + z/2), P a polynomial. [no unit] [Press1992] 6.2
FUNCTION Real ScaledErfc(IN(Real) z)
{
  GODRAYS_EXPECT(z >= 0.0);
  Real t = 1.0 / (1.0 + 0.5 * z);
  return t *
    exp(-1.26551223 + t * (1.00002368 + t * (0.37409196 + t * (0.09678418 +
      t * (-0.18628806 + t * (0.27886807 + t * (-1.13520398 + t * (1.48851587 +
      t * (-0.82215223 + t * 0.17087277)))))))));
}

// The column above a point along a way that does not descend, in an exponential density that is 1 there:
// Chapman's grazing incidence integral in closed form. Error below 1e-6 for scaleHeight < radius/500; it
// is of the second order in scaleHeight/radius, whatever the slope.
// With s = sqrt(1 - slope^2) and q^2 = radius - s radius + rise, the way's element is
// 2 (radius + rise)/sqrt((1 + s) radius + rise) dq; expanded to the first order in rise/radius, the
// integral over e^(-rise/H) is sqrt(pi H radius/(1 + s)) e^(z^2) erfc(z) (1 + (m/radius) (1 - 1/(2 + 2 s))),
// z = slope sqrt(radius/((1 + s) H)), m = H (1/2 - z^2 + z/(sqrt(pi) e^(z^2) erfc(z))) the mean rise.
// [length] [Chapman1931] for the problem; level, it is his sqrt(pi H radius/2) (1 + 3 H/(8 radius)).
FUNCTION RealLength ChapmanColumn(IN(RealLength) radius, IN(Real) slope, IN(RealLength) scaleHeight)
{
  GODRAYS_EXPECT(radius > 0.0 && slope >= 0.0 && slope <= 1.0 && scaleHeight > 0.0);
  Real side = 1.0 + sqrt(max(1.0 - slope * slope, 0.0));
  Real z = slope * sqrt(radius / (side * scaleHeight));
  Real tail = ScaledErfc(z);
  RealLength meanRise = clamp(0.5 - z * z + z * 0.5641895835477563 / tail, 0.5, 1.0) * scaleHeight;
  return 1.7724538509055160 * sqrt(scaleHeight * radius / side) * tail *
    (1.0 + meanRise / radius * (1.0 - 0.5 / side));
}

// Column of an exponential density along a way: what is above its lower end less what is above its upper
// end; with the lowest point between them, twice what is above that less what is above both.
// Formula: e^(-h/H) ChapmanColumn. [length]
FUNCTION RealLength SkyExponentialColumn(IN(RealLength) groundRadius, IN(RealLength) scaleHeight,
  IN(RealLength) height, IN(Real) slope, IN(RealLength) distance)
{
  GODRAYS_EXPECT(groundRadius > 0.0 && scaleHeight > 0.0);
  GODRAYS_EXPECT(IsCosine(slope) && distance >= 0.0);
  RealLength radius = groundRadius + height;
  RealLength rise = SkyRise(radius, slope, distance);
  RealLength endRadius = radius + rise;
  Real endSlope = (radius * slope + distance) / endRadius;
  RealLength start = ExponentialDensity(height, scaleHeight) *
    ChapmanColumn(radius, min(abs(slope), 1.0), scaleHeight);
  RealLength end = ExponentialDensity(height + rise, scaleHeight) *
    ChapmanColumn(endRadius, min(abs(endSlope), 1.0), scaleHeight);
  if (slope >= 0.0)
  {
    return max(start - end, 0.0);
  }
  if (endSlope <= 0.0)
  {
    return max(end - start, 0.0);
  }
  RealLength dip = SkyRise(radius, slope, -radius * slope);
  RealLength lowest = ExponentialDensity(height + dip, scaleHeight) *
    ChapmanColumn(radius + dip, 0.0, scaleHeight);
  return max(2.0 * lowest - start - end, 0.0);
}
