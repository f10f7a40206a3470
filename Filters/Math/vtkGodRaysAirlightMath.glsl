// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Phase
//VTK::GodRays::Planet

// Light that a medium scatters once on its way to the eye. Lengths and the reciprocals of
// coefficients have one unit, e.g. metres. Everything is finite for coefficients from 0 to 1e3,
// lengths to 1e9 and |asymmetry| to 0.99, and without loss of figures where they are small.

// What is left of light after a way through a homogeneous medium: the law of Beer and Lambert.
// Formula: e^(-extinction distance). [no unit]
FUNCTION Real Transmittance(IN(RealPerLength) extinction, IN(RealLength) distance)
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
FUNCTION RealLength DirectionalAirlight(IN(RealPerLength) extinction, IN(RealLength) begin,
  IN(RealLength) end, IN(RealLength) lightWay, IN(Real) lightSlope)
{
  GODRAYS_EXPECT(extinction >= 0.0 && begin <= end);
  GODRAYS_EXPECT(min(lightWay + lightSlope * begin, lightWay + lightSlope * end) >= -1e-5 * end);
  Real tau = extinction * (begin + lightWay + lightSlope * begin);
  return (end - begin) * MeanTransmittance(tau, extinction * (1.0 + lightSlope) * (end - begin));
}

// The distance of the light from the view ray as the functions below count it: 0 would make the
// airlight of a light on the ray infinite.
// Formula: max(height, 1e-9 |the ray's ends as seen from the foot|). [length]
FUNCTION RealLength PointLightHeight(
  IN(RealLength) foot, IN(RealLength) height, IN(RealLength) begin, IN(RealLength) end)
{
  GODRAYS_EXPECT(height >= 0.0);
  return max(height, 1e-9 * max(abs(begin - foot), abs(end - foot)) + RealLength(1e-18));
}

// Airlight of a point light in a medium that does not dim it, from the part of a view ray between
// the distances begin and end of the eye. foot is the distance along the ray of the point nearest to
// the light, height the light's distance from it. The radiance is intensity * phase (a constant) *
// scattering coefficient * this; parts add up.
// Formula: integral_begin^end ds/(h^2 + (s - foot)^2)
//   = atan2(h (end - begin), h^2 + (begin - foot) (end - foot))/h. [1/length] [Pegoraro2009]
FUNCTION RealPerLength PointAirlight(IN(RealLength) foot, IN(RealLength) height,
  IN(RealLength) begin, IN(RealLength) end)
{
  GODRAYS_EXPECT(height >= 0.0 && begin <= end);
  RealLength h = PointLightHeight(foot, height, begin, end);
  RealArea opposite = h * (end - begin);
  RealArea adjacent = h * h + (begin - foot) * (end - foot);
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
FUNCTION RealLength PointLightWay(IN(RealLength) beyondFoot, IN(RealLength) h)
{
  GODRAYS_EXPECT(h > 0.0);
  RealLength r = sqrt(h * h + beyondFoot * beyondFoot);
  return beyondFoot > 0.0 ? r + beyondFoot : h * (h / (r - beyondFoot));
}

// Two points of the panel of PointAirlight, symmetric about its middle, at place of its half to either side.
// Formula: sum of phase((h^2 - y^2)/(h^2 + y^2)) e^(-extinction (y - start))/(h^2 + y^2). [1/(length^2 sr)]
FUNCTION RealPerAreaSolidAngle PointAirlightPair(IN(PhaseFunction) phase,
  IN(RealPerLength) extinction, IN(RealLength) h, IN(RealLength) start, IN(RealLength) size,
  IN(Real) place)
{
  GODRAYS_EXPECT(extinction >= 0.0 && h > 0.0);
  GODRAYS_EXPECT(size >= 0.0 && place >= 0.0 && place <= 1.0);
  RealPerAreaSolidAngle sum = RealPerAreaSolidAngle(0.0);
  for (int i = 0; i < 2; ++i)
  {
    RealLength along = size * (i == 0 ? 0.5 - 0.5 * place : 0.5 + 0.5 * place);
    RealLength y = start + along;
    RealArea square = h * h + y * y;
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
FUNCTION RealPerLengthSolidAngle PointAirlight(IN(PhaseFunction) phase,
  IN(RealPerLength) extinction, IN(RealLength) foot, IN(RealLength) height, IN(RealLength) begin,
  IN(RealLength) end)
{
  GODRAYS_EXPECT(height >= 0.0 && begin <= end);
  RealLength h = PointLightHeight(foot, height, begin, end);
  RealLength y = PointLightWay(begin - foot, h);
  RealLength rNear = sqrt(h * h + (begin - foot) * (begin - foot));
  RealLength rFar = sqrt(h * h + (end - foot) * (end - foot));
  RealLength left = (end - begin) * (y + PointLightWay(end - foot, h)) / (rNear + rFar);
  // The integrand's poles are at y = +-i h and at +-i times this, since y/h is the tangent of half the
  // scattering angle.
  RealLength scale = h * PhasePole(phase);
  Real tau = 0.0;
  RealPerLengthSolidAngle sum = RealPerLengthSolidAngle(0.0);
  for (int panel = 0; panel < 96; ++panel)
  {
    RealLength size = 0.75 * sqrt(scale * scale + y * y);
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

// Length of a straight way from a height, up or down, times the mean density along it.
// Formula: distance e^(-height/H) phi(slope distance/H), phi = MeanExponential. [length]
FUNCTION RealLength ExponentialColumn(IN(RealLength) height, IN(Real) slope,
  IN(RealLength) scaleHeight, IN(RealLength) distance)
{
  GODRAYS_EXPECT(scaleHeight > 0.0 && IsCosine(slope) && distance >= 0.0);
  RealLength rise = slope * distance;
  Real low = ExponentialDensity(rise < 0.0 ? height + rise : height, scaleHeight);
  return distance * low * MeanExponential(abs(rise) / scaleHeight);
}

// Its optical depth. Formula: extinction ExponentialColumn. [no unit]
FUNCTION Real ExponentialDepth(IN(RealPerLength) extinction, IN(RealLength) height, IN(Real) slope,
  IN(RealLength) scaleHeight, IN(RealLength) distance)
{
  GODRAYS_EXPECT(extinction >= 0.0);
  return extinction * ExponentialColumn(height, slope, scaleHeight, distance);
}

// The height at which a way from another one ends.
// Formula: height + slope distance, or height + SkyRise. [length]
FUNCTION RealLength MediumHeight(
  IN(RealLength) planetRadius, IN(RealLength) height, IN(Real) slope, IN(RealLength) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && IsCosine(slope) && distance >= 0.0);
  return height +
    (planetRadius > 0.0 ? SkyRise(planetRadius + height, slope, distance) : slope * distance);
}

// The slope of a straight way of known length between two heights, where it starts.
// Formula: (end - height)/distance, or, from (R + end)^2 = (R + height)^2 + d^2 + 2 (R + height) d slope,
// ((end - height) (2 R + height + end) - d^2)/(2 (R + height) d). [no unit]
FUNCTION Real MediumSlope(
  IN(RealLength) planetRadius, IN(RealLength) height, IN(RealLength) end, IN(RealLength) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && distance > 0.0);
  if (planetRadius > 0.0)
  {
    RealLength rise = (end - height) * ((2.0 * planetRadius + height + end) / distance) - distance;
    return clamp(rise / (2.0 * (planetRadius + height)), -1.0, 1.0);
  }
  return (end - height) / distance;
}

// Length of a way times the mean density along it; a scale height of 0 stands for a homogeneous medium, where
// slope may be anything.
// The ground bends away by distance^2/(2 planetRadius): where that is little of the scale height, a
// plane of the same rise is exact to 1e-5, without the differences of SkyExponentialColumn().
// Formula: distance, ExponentialColumn, or SkyExponentialColumn. [length]
FUNCTION RealLength MediumDepth(IN(RealLength) planetRadius, IN(RealLength) height, IN(Real) slope,
  IN(RealLength) scaleHeight, IN(RealLength) distance)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && scaleHeight >= 0.0 && distance >= 0.0);
  if (scaleHeight <= 0.0)
  {
    return distance;
  }
  if (planetRadius > 0.0 && distance * (distance / planetRadius) > 1e-4 * scaleHeight)
  {
    return SkyExponentialColumn(planetRadius, scaleHeight, height, slope, distance);
  }
  RealLength rise = MediumHeight(planetRadius, height, slope, distance) - height;
  return ExponentialColumn(height, rise / max(distance, RealLength(1e-30)), scaleHeight, distance);
}

// The same of a way to where nothing is any more, of a medium of exponential density: up over a plane,
// else to 40 scale heights above.
// Formula: scaleHeight density/slope, or SkyExponentialColumn. [length]
FUNCTION RealLength MediumColumn(
  IN(RealLength) planetRadius, IN(RealLength) height, IN(Real) slope, IN(RealLength) scaleHeight)
{
  GODRAYS_EXPECT(planetRadius >= 0.0 && IsCosine(slope) && scaleHeight > 0.0);
  if (planetRadius > 0.0)
  {
    RealLength end = SkyBelow(planetRadius, height, slope, max(height, 0.0) + 40.0 * scaleHeight).y;
    return SkyExponentialColumn(planetRadius, scaleHeight, height, slope, end);
  }
  return scaleHeight * ExponentialDensity(height, scaleHeight) / max(slope, 1e-6);
}

// Airlight of a directional light in it, from the part of a view ray between the distances begin and
// end of the eye, which is at height; lightSlope is the rise towards the light, above 0. The light is
// dimmed on its way from above. The ground is plane: from 85 degrees of the zenith on a sphere
// differs. The radiance is irradiance * phase * scattering coefficient at height 0 * this; parts add
// up.
// Formula: D e^-tau(begin) e^(-b X0/lightSlope) phi(b (1 - slope/lightSlope) D/H),
// D = integral_begin^end X ds = X0 (end - begin) phi(slope (end - begin)/H), X = e^(-height/H), b =
// extinction H, X0 at begin. [length] [PreethamShirleySmits1999] for constant slopes
FUNCTION RealLength ExponentialAirlight(IN(RealPerLength) extinction, IN(RealLength) height,
  IN(Real) slope, IN(Real) lightSlope, IN(RealLength) scaleHeight, IN(RealLength) begin,
  IN(RealLength) end)
{
  GODRAYS_EXPECT(extinction >= 0.0 && IsCosine(slope) && lightSlope > 0.0);
  GODRAYS_EXPECT(scaleHeight > 0.0 && begin >= 0.0 && begin <= end);
  RealLength start = height + slope * begin;
  RealLength column = ExponentialColumn(start, slope, scaleHeight, end - begin);
  Real tau = ExponentialDepth(extinction, height, slope, scaleHeight, begin) +
    extinction * scaleHeight * ExponentialDensity(start, scaleHeight) / lightSlope;
  return column * MeanTransmittance(tau, extinction * column * (1.0 - slope / lightSlope));
}
