// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of vtkGodRays, each once: compiled by GLSL 1.50 after vtkGodRaysTypes.glsl and by
// C++17 within vtkGodRaysMath.h, where Real is double. So: no suffixes on numbers, no swizzles
// beyond .x .y .z, no gl_*, no uniforms; a texture is a Layer and is read by SampleLayer.
// Source keys are those of Documentation/References.md.
//
// uv  position in a layer, (0, 0) the lower left corner, (1, 1) the upper right
// ndc position in the picture, -1 to 1 along each axis

// --- Sums of taps along the march to the light ---------------------------------------------------

// One pass of a radial sum. Every published shader and our own is a choice of these numbers:
//   map(s) = InputBias + InputGain s
//   sum    = OriginWeight map(s(uv))
//          + sum_{k=FirstTap}^{LastTap} FirstWeight Decay^(k-FirstTap) map(s(uv + (k-TapOffset) d))
//   result = OutputBias + OutputGain sum, kept in [0, Maximum] if Maximum > 0
// with d = Step march, march being the vector from the pixel to the light. If FixedLength > 0, then
// d = FixedLength march/|march| instead, and taps beyond the light or above the layer are left out.
struct TapSum
{
  int FirstTap;
  int LastTap;       // below FirstTap: no taps
  Real TapOffset;    // [steps]
  Real OriginWeight; // [no unit]
  Real FirstWeight;  // [no unit]
  Real Decay;        // factor from one tap to the next [no unit]
  Real Step;         // [fraction of the march]
  Real FixedLength;  // [uv]; 0: none
  Real InputBias;    // [the layer's unit]
  Real InputGain;    // [no unit]
  Real OutputBias;   // [the layer's unit]
  Real OutputGain;   // [no unit]
  Real Maximum;      // [the layer's unit]; 0: none
  int RedToGrey;     // 1: red is copied into green and blue
};

// The one loop: evaluates a TapSum at uv. Positions are computed, not stepped, so that rounding
// does not grow with k. A march of 0 reads the pixel itself.
// Formula: see TapSum. [the layer's unit] [Mitchell2007] eq. 4 and listing; with FixedLength
// [ThreeGodRays], the generating shader.
LAYER_TEMPLATE Vec3 SumTaps(IN(Layer) layer, IN(TapSum) taps, IN(Vec2) uv, IN(Vec2) march)
{
  Vec2 stride = taps.Step * march;
  Real lastReached = Real(taps.LastTap);
  bool bounded = taps.FixedLength > 0.0;
  if (bounded)
  {
    Real reach = length(march);
    stride = (taps.FixedLength / max(reach, 1e-30)) * march;
    lastReached = reach / taps.FixedLength + 1e-5; // a tap at the light counts however it is rounded
  }

  Vec3 bias = Vec3(taps.InputBias);
  Vec3 sum = Vec3(0.0);
  if (taps.OriginWeight != 0.0)
  {
    sum = taps.OriginWeight * (bias + taps.InputGain * SampleLayer(layer, uv));
  }
  Real weight = taps.FirstWeight;
  for (int k = taps.FirstTap; k <= taps.LastTap; ++k)
  {
    Vec2 position = uv + (Real(k) - taps.TapOffset) * stride;
    if (!bounded || (Real(k) <= lastReached && position.y < 1.0))
    {
      sum += weight * (bias + taps.InputGain * SampleLayer(layer, position));
    }
    weight *= taps.Decay;
  }

  Vec3 result = Vec3(taps.OutputBias) + taps.OutputGain * sum;
  if (taps.Maximum > 0.0)
  {
    result = clamp(result, 0.0, taps.Maximum);
  }
  if (taps.RedToGrey != 0)
  {
    result = Vec3(result.x);
  }
  return result;
}

// The vector from a pixel to the light, for any light: smooth where the light passes w = 0, where
// the vectors are parallel, and pointing away from the light's mirror image behind the camera.
// lightClip holds the light's clip coordinates (X, Y, w); for a march in a layer with a margin,
// those and ndc are the layer's.
// Formula: scale/2 ((X, Y) - w ndc); scale = 1/w leads exactly to the light. [uv]
FUNCTION Vec2 MarchVector(IN(Vec3) lightClip, IN(Vec2) ndc, IN(Real) scale)
{
  return 0.5 * scale * (Vec2(lightClip.x, lightClip.y) - lightClip.z * ndc);
}

// The scale of MarchVector that caps the march, so that shafts of a light far outside the picture
// do not fade by its distance: exact for a light nearer to the picture's centre than cap, else the
// march of a light at cap. Continuous for any light, finite also for one behind the camera.
// aspect is the picture's width/height; cap is in units of half its height.
// Formula: cap/max(|(X aspect, Y)|, cap |w|). [1/clip unit]
FUNCTION Real MarchScale(IN(Vec3) lightClip, IN(Real) aspect, IN(Real) cap)
{
  Real reach = length(Vec2(lightClip.x * aspect, lightClip.y));
  return cap / max(max(reach, cap * abs(lightClip.z)), 1e-30);
}

// Noise for the offset of each pixel's taps: between 0 and 1, even on every block of pixels, and
// different from one pixel to the next. pixel is a position [pixels].
// Formula: fract(52.9829189 fract(0.06711056 x + 0.00583715 y)). [no unit] [Jimenez2014]
FUNCTION Real InterleavedGradientNoise(IN(Vec2) pixel)
{
  return fract(52.9829189 * fract(0.06711056 * pixel.x + 0.00583715 * pixel.y));
}

// --- Kernels -------------------------------------------------------------------------------------

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

// What n samples weigh together, each decay times as much as the one before; n need not be whole.
// Formula: (1 - d^n)/(1 - d) = n phi(-n ln d)/phi(-ln d), phi being MeanExponential(); 1 for d = 0.
// [no unit]
FUNCTION Real GeometricSum(IN(Real) decay, IN(Real) n)
{
  if (decay <= 0.0)
  {
    return 1.0;
  }
  Real k = -log(decay);
  return n * MeanExponential(n * k) / MeanExponential(k);
}

// The part of a march along which one of its coordinates is within [-margin, 1 + margin]; empty, the
// first number above the second, if there is none.
// Formula: the two t at which position + t march is at an end. [fractions of the march]
FUNCTION Vec2 ClipCoordinate(IN(Real) position, IN(Real) march, IN(Real) margin)
{
  Real low = -margin - position;
  Real high = 1.0 + margin - position;
  if (abs(march) < 1e-20)
  {
    return low <= 0.0 && high >= 0.0 ? Vec2(0.0, 1.0) : Vec2(1.0, 0.0);
  }
  return Vec2(min(low / march, high / march), max(low / march, high / march));
}

// The part of a march from uv along which a layer that is 0 beyond margin can be other than 0.
// Formula: where ClipCoordinate allows both, within [0, 1]. [fractions of the march]
FUNCTION Vec2 ClipMarch(IN(Vec2) uv, IN(Vec2) march, IN(Vec2) margin)
{
  Vec2 x = ClipCoordinate(uv.x, march.x, margin.x);
  Vec2 y = ClipCoordinate(uv.y, march.y, margin.y);
  return Vec2(max(0.0, max(x.x, y.x)), min(1.0, min(x.y, y.y)));
}

// The mean of a layer along the part of a march from t = part.x to part.y, weighted by e^(-k t) as
// a part of the whole march, for a layer that is 0 in the rest. Taps are in the middle of equal
// steps, whose weights are exact.
// Formula: sum_i s(uv + (t_i + h/2) march) integral_{t_i}^{t_i + h} e^(-k t) dt/MeanExponential(k),
// t_i = part.x + i h. [the layer's unit]
LAYER_TEMPLATE Vec3 MeanAlongMarch(
  IN(Layer) layer, IN(Vec2) uv, IN(Vec2) march, IN(Real) k, IN(Vec2) part, IN(int) taps)
{
  Real h = (part.y - part.x) / Real(taps);
  Real weight = h * exp(-k * part.x) * MeanExponential(k * h) / MeanExponential(k);
  Real decay = exp(-k * h);
  Vec3 sum = Vec3(0.0);
  for (int i = 0; i < taps; ++i)
  {
    sum += weight * SampleLayer(layer, uv + (part.x + (Real(i) + 0.5) * h) * march);
    weight *= decay;
  }
  return sum;
}

// --- Display transfer ----------------------------------------------------------------------------

// Linear light of a display value, and of a colour. Above 1 the curve goes on.
// Formula: c/12.92 for c <= 0.04045, else ((c + 0.055)/1.055)^2.4. [linear light]
// [IEC61966-2-1] 5.2
FUNCTION Real DecodeDisplay(IN(Real) value)
{
  return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

FUNCTION Vec3 DecodeDisplay(IN(Vec3) value)
{
  return Vec3(DecodeDisplay(value.x), DecodeDisplay(value.y), DecodeDisplay(value.z));
}

// Display value of linear light, and of a colour: the inverse of DecodeDisplay.
// Formula: 12.92 c for c <= 0.0031308, else 1.055 c^(1/2.4) - 0.055. [display value]
// [IEC61966-2-1] 5.3
FUNCTION Real EncodeDisplay(IN(Real) light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
}

FUNCTION Vec3 EncodeDisplay(IN(Vec3) light)
{
  return Vec3(EncodeDisplay(light.x), EncodeDisplay(light.y), EncodeDisplay(light.z));
}

// --- Blending ------------------------------------------------------------------------------------

// Rays over a scene as light adds. Formula: a + b. [the unit of both]
FUNCTION Vec3 BlendAdd(IN(Vec3) scene, IN(Vec3) rays)
{
  return scene + rays;
}

// Rays over a scene as two slides projected in turn. Formula: a + b - min(a b, 1). [no unit]
// [Postprocessing], blend function SCREEN
FUNCTION Vec3 BlendScreen(IN(Vec3) scene, IN(Vec3) rays)
{
  return scene + rays - min(scene * rays, 1.0);
}

// --- The light as it is seen ---------------------------------------------------------------------

// The angle between two vectors of any length but 0, accurate also near 0 and pi.
// Formula: atan2(|a x b|, a . b). [radians]
FUNCTION Real AngleBetween(IN(Vec3) a, IN(Vec3) b)
{
  return atan(length(cross(a, b)), dot(a, b));
}

// How large a pixel is seen, along its larger side: the angle by which a ray of any length turns when
// its end moves by a pixel to the right or up, which is small.
// Formula: max(|a x right|, |a x up|)/|a|^2. [radians]
FUNCTION Real PixelAngle(IN(Vec3) ray, IN(Vec3) right, IN(Vec3) up)
{
  Vec3 sideways = cross(ray, right);
  Vec3 upwards = cross(ray, up);
  return sqrt(max(dot(sideways, sideways), dot(upwards, upwards))) / dot(ray, ray);
}

// How much of a pixel a disc covers, its edge softened so that it rises by 1 over a pixel. The
// integral over the plane is the disc's area pi radius^2 for any radius: a disc below a pixel gets
// dimmer, not smaller. The sum over pixels is that to 2.5 %, wherever the disc lies between them.
// Separation from the disc's centre, radius and pixel have one unit, e.g. radians.
// Formula: A (1 - smoothstep(R - h, R + h, s)), h = 3/4 pixel, R^2 = max(r^2 - h^2/5, h^2),
// A = r^2/(R^2 + h^2/5). [no unit]
FUNCTION Real DiscCoverage(IN(Real) separation, IN(Real) radius, IN(Real) pixel)
{
  Real halfWidth = 0.75 * max(pixel, 1e-15);
  Real spread = 0.2 * halfWidth * halfWidth;
  Real edgeSquared = max(radius * radius - spread, halfWidth * halfWidth);
  Real t = clamp(0.5 * (separation - sqrt(edgeSquared)) / halfWidth + 0.5, 0.0, 1.0);
  return radius * radius / (edgeSquared + spread) * (1.0 - t * t * (3.0 - 2.0 * t));
}

// The glow about a light: full within radius, then smoothly down to 0 at radius + falloff; sharp
// when falloff is 0. All three have one unit, e.g. radians.
// Formula: 1 - smoothstep(radius, radius + falloff, separation). [no unit]
FUNCTION Real GlowFalloff(IN(Real) separation, IN(Real) radius, IN(Real) falloff)
{
  Real t = clamp((separation - radius) / max(falloff, 1e-30), 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

// The fading of a light that passes behind the camera; facing is the cosine of the angle between
// the direction of view and the direction to the light.
// Formula: smoothstep(-0.1, 0.1, facing). [no unit]
FUNCTION Real FacingFade(IN(Real) facing)
{
  Real t = clamp(5.0 * facing + 0.5, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// --- Safety --------------------------------------------------------------------------------------

// A value that can be stored and summed: NaN and negative numbers become 0, others at most maximum.
// Formula: c > 0 ? min(c, maximum) : 0. [the value's unit]
FUNCTION Real Sanitize(IN(Real) value, IN(Real) maximum)
{
  return value > 0.0 ? min(value, maximum) : 0.0;
}

FUNCTION Vec3 Sanitize(IN(Vec3) value, IN(Real) maximum)
{
  return Vec3(
    Sanitize(value.x, maximum), Sanitize(value.y, maximum), Sanitize(value.z, maximum));
}
