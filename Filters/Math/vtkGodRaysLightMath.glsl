// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// A light as it is seen: its disc, its glow, and how it fades.

//VTK::GodRays::Types

// The angle between two vectors of any length but 0, accurate also near 0 and pi.
// Formula: atan2(|a x b|, a . b). [radians]
FUNCTION RealAngle AngleBetween(IN(Vec3) a, IN(Vec3) b)
{
  GODRAYS_EXPECT(dot(a, a) > 0.0 && dot(b, b) > 0.0);
  return RealAngle(atan(length(cross(a, b)), dot(a, b)));
}

// How large a pixel is seen, along its larger side: the angle by which a ray of any length turns when
// its end moves by a pixel to the right or up, which is small.
// Formula: max(|a x right|, |a x up|)/|a|^2. [radians]
FUNCTION RealAngle PixelAngle(IN(Vec3) ray, IN(Vec3) right, IN(Vec3) up)
{
  GODRAYS_EXPECT(dot(ray, ray) > 0.0);
  Vec3 sideways = cross(ray, right);
  Vec3 upwards = cross(ray, up);
  return RealAngle(sqrt(max(dot(sideways, sideways), dot(upwards, upwards))) / dot(ray, ray));
}

// How much of a pixel a disc covers, its edge softened so that it rises by 1 over a pixel. The
// integral over the plane is the disc's area pi radius^2 for any radius: a disc below a pixel gets
// dimmer, not smaller. The sum over pixels is that to 2.5 %, wherever the disc lies between them.
// Separation from the disc's centre, radius and pixel have one unit, e.g. radians.
// Formula: A (1 - smoothstep(R - h, R + h, s)), h = 3/4 pixel, R^2 = max(r^2 - h^2/5, h^2),
// A = r^2/(R^2 + h^2/5). [no unit]
FUNCTION Real DiscCoverage(IN(RealAngle) separation, IN(RealAngle) radius, IN(RealAngle) pixel)
{
  GODRAYS_EXPECT(separation >= 0.0 && radius >= 0.0 && pixel >= 0.0);
  RealAngle halfWidth = 0.75 * max(pixel, RealAngle(1e-15));
  RealSolidAngle spread = 0.2 * halfWidth * halfWidth;
  RealSolidAngle edgeSquared = max(radius * radius - spread, halfWidth * halfWidth);
  Real t = clamp(0.5 * (separation - sqrt(edgeSquared)) / halfWidth + 0.5, 0.0, 1.0);
  return radius * radius / (edgeSquared + spread) * (1.0 - t * t * (3.0 - 2.0 * t));
}

// The glow about a light: full within radius, then smoothly down to 0 at radius + falloff; sharp
// when falloff is 0. All three have one unit, e.g. radians.
// Formula: 1 - smoothstep(radius, radius + falloff, separation). [no unit]
FUNCTION Real GlowFalloff(IN(RealAngle) separation, IN(RealAngle) radius, IN(RealAngle) falloff)
{
  GODRAYS_EXPECT(separation >= 0.0 && radius >= 0.0 && falloff >= 0.0);
  Real t = clamp((separation - radius) / max(falloff, RealAngle(1e-30)), 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

// The fading of a light that passes behind the camera; facing is the cosine of the angle between
// the direction of view and the direction to the light.
// Formula: smoothstep(-0.1, 0.1, facing). [no unit]
FUNCTION Real FacingFade(IN(Real) facing)
{
  GODRAYS_EXPECT(IsCosine(facing));
  Real t = clamp(5.0 * facing + 0.5, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
