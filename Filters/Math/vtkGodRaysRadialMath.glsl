// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The radial look: sums of taps along the march from a pixel to the light.
//
// uv  position in a layer, (0, 0) the lower left corner, (1, 1) the upper right
// ndc position in the picture, -1 to 1 along each axis

//VTK::GodRays::Common

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
  GODRAYS_EXPECT(taps.Decay >= 0.0 && taps.FixedLength >= 0.0);
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
  GODRAYS_EXPECT(aspect > 0.0 && cap > 0.0);
  Real reach = length(Vec2(lightClip.x * aspect, lightClip.y));
  return cap / max(max(reach, cap * abs(lightClip.z)), 1e-30);
}

// What n samples weigh together, each decay times as much as the one before; n need not be whole.
// Formula: (1 - d^n)/(1 - d) = n phi(-n ln d)/phi(-ln d), phi being MeanExponential(); 1 for d = 0.
// [no unit]
FUNCTION Real GeometricSum(IN(Real) decay, IN(Real) n)
{
  GODRAYS_EXPECT(n >= 0.0);
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
  GODRAYS_EXPECT(margin >= 0.0);
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

// Lines through the light are numbered evenly, but for a strip that has more of them: strip.x and
// strip.y are where it begins and ends in that numbering, strip.z is how many times as close its lines
// are. This is the place of an even line's number among all of them.
// Formula: i + (z - 1) (i - x), the last term kept within [0, (z - 1) (y - x)]. [lines]
FUNCTION Real LineOfEven(IN(Real) even, IN(Vec3) strip)
{
  GODRAYS_EXPECT(strip.x <= strip.y && strip.z >= 1.0);
  return even + (strip.z - 1.0) * clamp(even - strip.x, Real(0.0), strip.y - strip.x);
}

// The inverse of LineOfEven().
// Formula: l - (z - 1)/z (l - x), the last term kept within [0, (z - 1) (y - x)]. [even lines]
FUNCTION Real EvenOfLine(IN(Real) line, IN(Vec3) strip)
{
  GODRAYS_EXPECT(strip.x <= strip.y && strip.z >= 1.0);
  return line -
    (strip.z - 1.0) * clamp((line - strip.x) / strip.z, Real(0.0), strip.y - strip.x);
}

// The mean of a layer along the part of a march from t = part.x to part.y, weighted by e^(-k t) as
// a part of the whole march, for a layer that is 0 in the rest. Taps are in the middle of equal
// steps, whose weights are exact.
// Formula: sum_i s(uv + (t_i + h/2) march) integral_{t_i}^{t_i + h} e^(-k t) dt/MeanExponential(k),
// t_i = part.x + i h. [the layer's unit]
LAYER_TEMPLATE Vec3 MeanAlongMarch(
  IN(Layer) layer, IN(Vec2) uv, IN(Vec2) march, IN(Real) k, IN(Vec2) part, IN(int) taps)
{
  GODRAYS_EXPECT(taps > 0 && part.x <= part.y);
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

// The response of a look: how its sum is shown.

// Streaks of a light: a fixed pattern of the angle about it, of mean 0 and variance 1, as dust that is not
// even makes them. Formula: sum_i n_i^-0.35 cos(n_i a + p_i), normalized, n = 5, 9, 14, 22, 35. [no unit]
FUNCTION Real StreakPattern(IN(Real) angle)
{
  return 0.8512 * cos(5.0 * angle + 0.7) + 0.6929 * cos(9.0 * angle + 2.9) +
    0.5936 * cos(14.0 * angle + 4.4) + 0.5068 * cos(22.0 * angle + 1.3) +
    0.4308 * cos(35.0 * angle + 5.6);
}

// The factor on a sum at some offset from its light. Rays fade with the distance by which they are farther
// from the light than the picture's nearest point; reach 0 leaves that out. Streaks have an amplitude of
// their pattern, and begin 0.12 from the light.
// Formula: exp(-(r - nearest)/reach) max(1 + streaks smoothstep(r/0.12) pattern, 0). [no unit], lengths in
// heights of the picture
FUNCTION Real RadialResponse(IN(Vec2) offset, IN(Real) nearest, IN(Real) reach, IN(Real) streaks)
{
  GODRAYS_EXPECT(nearest >= 0.0 && reach >= 0.0 && streaks >= 0.0);
  Real r = length(offset);
  Real fade = reach > 0.0 ? exp(-max(r - nearest, Real(0.0)) / reach) : 1.0;
  if (streaks <= 0.0 || r <= 0.0)
  {
    return fade;
  }
  Real t = clamp(r / 0.12, Real(0.0), Real(1.0));
  Real pattern = StreakPattern(atan(offset.y, offset.x));
  return fade * max(1.0 + streaks * t * t * (3.0 - 2.0 * t) * pattern, Real(0.0));
}
