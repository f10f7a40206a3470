// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What formulas of several topics share. How they are written: see vtkGodRaysMath.h.

//VTK::GodRays::Types

// The mean of e^(-k t) over t in [0, 1]: what a converged radial sum makes of a constant layer.
// Formula: phi(k) = (1 - e^-k)/k = 1 - k/2 (1 - k/3 (1 - k/4 (...))), the latter for |k| < 1.
// [no unit]
FUNCTION Real MeanExponential(IN(Real) k)
{
  if (abs(k) >= 1.0)
  {
    return (1.0 - exp(-k)) / k;
  }
  Real mean = 1.0;
  for (int n = 18; n >= 2; --n)
  {
    mean = 1.0 - k * mean / Real(n);
  }
  return mean;
}

// A value that can be stored and summed: NaN and negative numbers become 0, others at most maximum.
// Formula: c > 0 ? min(c, maximum) : 0. [the value's unit]
FUNCTION Real Sanitize(IN(Real) value, IN(Real) maximum)
{
  GODRAYS_EXPECT(maximum >= 0.0);
  return value > 0.0 ? min(value, maximum) : 0.0;
}

FUNCTION Vec3 Sanitize(IN(Vec3) value, IN(Real) maximum)
{
  GODRAYS_EXPECT(maximum >= 0.0);
  return Vec3(
    Sanitize(value.x, maximum), Sanitize(value.y, maximum), Sanitize(value.z, maximum));
}

// How far along the axis of view something is whose window depth is 1 - rest; terms are those of the camera,
// see vtkGodRaysView::Pinhole.
// Formula: (x + y rest)/(z + w rest), (x, y, z, w) being the terms. [length]
FUNCTION Real ViewDepth(IN(Vec4) terms, IN(Real) rest)
{
  return (terms.x + terms.y * rest) / (terms.z + terms.w * rest);
}

// Noise for the offset of each pixel's taps: between 0 and 1, even on every block of pixels, and
// different from one pixel to the next. pixel is a position [pixels].
// Formula: fract(52.9829189 fract(0.06711056 x + 0.00583715 y)). [no unit] [Jimenez2014]
FUNCTION Real InterleavedGradientNoise(IN(Vec2) pixel)
{
  return fract(52.9829189 * fract(0.06711056 * pixel.x + 0.00583715 * pixel.y));
}
