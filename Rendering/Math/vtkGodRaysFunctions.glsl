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

// The same, or by the power of 2.2 that VTK's tone mapping and PBR shaders take for it, where light is
// 0.218 for a value of 0.5, rather than 0.214. Negative values count as 0.
// Formula: c^2.2. [linear light] vtkToneMappingPass
FUNCTION Vec3 DecodeDisplay(IN(Vec3) value, bool isPower)
{
  return isPower ? pow(max(value, Vec3(0.0)), Vec3(2.2)) : DecodeDisplay(value);
}

// The inverse. Formula: c^(1/2.2). [display value]
FUNCTION Vec3 EncodeDisplay(IN(Vec3) light, bool isPower)
{
  return isPower ? pow(max(light, Vec3(0.0)), Vec3(1.0 / 2.2)) : EncodeDisplay(light);
}

// --- Tone mapping --------------------------------------------------------------------------------

// Luminance of linear light of the primaries of sRGB. [the unit of the light]
// [IEC61966-2-1] 5.2: ITU-R BT.709's
FUNCTION Real Luminance(IN(Vec3) light)
{
  return dot(light, Vec3(0.2126, 0.7152, 0.0722));
}

// Light of any brightness, to be shown; light as bright as white becomes 1, and without a white, where
// its inverse is 0, nothing does. Formula: c (1 + c/white^2)/(1 + c), at most 1. [linear light]
// [Reinhard2002] equation 4, for each colour for itself
FUNCTION Vec3 ToneReinhard(IN(Vec3) light, Real inverseWhite)
{
  return min(light * (light * (inverseWhite * inverseWhite) + Vec3(1.0)) / (light + Vec3(1.0)), Vec3(1.0));
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

// --- The medium ----------------------------------------------------------------------------------

// Light that a medium scatters once on its way to the eye. Lengths and the reciprocals of
// coefficients have one unit, e.g. metres. Everything is finite for coefficients from 0 to 1e3,
// lengths to 1e9 and |asymmetry| to 0.99, and without loss of figures where they are small.

// How a medium scatters light into directions [1/sr]; the integral over all is 1.
// cosAngle is the cosine of the scattering angle, between the directions in which the light travels
// before and after: 1 is straight on, as for an eye that looks at the light, for which it is the
// cosine of the angle between the view ray and the direction to the light.
struct PhaseFunction
{
  int Kind;       // 0 isotropic, 1 Rayleigh, 2 Henyey-Greenstein, 3 Cornette-Shanks, 4 Schlick
  Real Asymmetry; // g, of kinds 2 to 4: the mean cosine (of 3 nearly); in (-1, 1) [no unit]
};

// Formula: 1/(4 pi). [1/sr]
FUNCTION Real PhaseIsotropic()
{
  return 0.07957747154594767;
}

// Formula: 3/(16 pi) (1 + c^2). [1/sr] [Chandrasekhar1960]
FUNCTION Real PhaseRayleigh(IN(Real) cosAngle)
{
  return 0.05968310365946075 * (1.0 + cosAngle * cosAngle);
}

// The square of 1 - 2 g c + g^2, without cancellation near the peak.
// Formula: (1 - |g|)^2 + 2 |g| (1 - sign(g) c). [no unit]
FUNCTION Real PhaseDistance(IN(Real) cosAngle, IN(Real) g)
{
  Real sharpness = 1.0 - abs(g);
  Real away = max(1.0 - (g < 0.0 ? -cosAngle : cosAngle), 0.0);
  return sharpness * sharpness + 2.0 * abs(g) * away;
}

// Formula: 1/(4 pi) (1 - g^2)/(1 - 2 g c + g^2)^(3/2). [1/sr] [HenyeyGreenstein1941]
FUNCTION Real PhaseHenyeyGreenstein(IN(Real) cosAngle, IN(Real) g)
{
  Real distance = PhaseDistance(cosAngle, g);
  return 0.07957747154594767 * (1.0 - g * g) / (distance * sqrt(distance));
}

// Rayleigh's for g = 0. Its mean cosine is 3 g (4 + g^2)/(5 (2 + g^2)).
// Formula: 3/(8 pi) (1 - g^2)/(2 + g^2) (1 + c^2)/(1 - 2 g c + g^2)^(3/2). [1/sr]
// [CornetteShanks1992]
FUNCTION Real PhaseCornetteShanks(IN(Real) cosAngle, IN(Real) g)
{
  return 1.5 * (1.0 + cosAngle * cosAngle) / (2.0 + g * g) * PhaseHenyeyGreenstein(cosAngle, g);
}

// The parameter of Schlick's phase function for a given g. The fit exceeds 1 from g = 0.94 on, which
// no phase function may.
// Formula: 1.55 g - 0.55 g^3, within [-0.995, 0.995]. [no unit] [PharrHumphreys2004]
FUNCTION Real SchlickParameter(IN(Real) g)
{
  return clamp(g * (1.55 - 0.55 * g * g), -0.995, 0.995);
}

// Near Henyey-Greenstein's of the same g, without a root.
// Formula: 1/(4 pi) (1 - k^2)/(1 - k c)^2, k = SchlickParameter(g). [1/sr] [Blasi1993]
FUNCTION Real PhaseSchlick(IN(Real) cosAngle, IN(Real) g)
{
  Real k = SchlickParameter(g);
  Real away = max(1.0 - (k < 0.0 ? -cosAngle : cosAngle), 0.0);
  Real distance = (1.0 - abs(k)) + abs(k) * away;
  return 0.07957747154594767 * (1.0 - k * k) / (distance * distance);
}

// Formula: that of its kind. [1/sr]
FUNCTION Real Phase(IN(PhaseFunction) phase, IN(Real) cosAngle)
{
  if (phase.Kind == 1)
  {
    return PhaseRayleigh(cosAngle);
  }
  if (phase.Kind == 2)
  {
    return PhaseHenyeyGreenstein(cosAngle, phase.Asymmetry);
  }
  if (phase.Kind == 3)
  {
    return PhaseCornetteShanks(cosAngle, phase.Asymmetry);
  }
  if (phase.Kind == 4)
  {
    return PhaseSchlick(cosAngle, phase.Asymmetry);
  }
  return PhaseIsotropic();
}

// A mix of two, e.g. of a peak ahead and one to the back; weight is the second's part, in [0, 1].
// Formula: (1 - weight) first + weight second. [1/sr]
FUNCTION Real PhaseMix(IN(PhaseFunction) first, IN(PhaseFunction) second, IN(Real) weight,
  IN(Real) cosAngle)
{
  return (1.0 - weight) * Phase(first, cosAngle) + weight * Phase(second, cosAngle);
}

// What is left of light after a way through a homogeneous medium: the law of Beer and Lambert.
// Formula: e^(-extinction distance). [no unit]
FUNCTION Real Transmittance(IN(Real) extinction, IN(Real) distance)
{
  return exp(-extinction * distance);
}

// e^-tau MeanExponential(k) where tau and tau + k, the optical depths of two ends, are at least 0:
// the mean of e^-t between them, without overflow where k < 0.
// Formula: (e^-tau - e^-(tau + k))/k. [no unit]
FUNCTION Real MeanTransmittance(IN(Real) tau, IN(Real) k)
{
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
  Real tau = extinction * (begin + lightWay + lightSlope * begin);
  return (end - begin) * MeanTransmittance(tau, extinction * (1.0 + lightSlope) * (end - begin));
}

// The distance of the light from the view ray as the functions below count it: 0 would make the
// airlight of a light on the ray infinite.
// Formula: max(height, 1e-9 |the ray's ends as seen from the foot|). [length]
FUNCTION Real PointLightHeight(
  IN(Real) foot, IN(Real) height, IN(Real) begin, IN(Real) end)
{
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

// y = s - foot + r(s), r^2 = h^2 + (s - foot)^2, without cancellation before the foot. [length]
FUNCTION Real PointLightWay(IN(Real) beyondFoot, IN(Real) h)
{
  Real r = sqrt(h * h + beyondFoot * beyondFoot);
  return beyondFoot > 0.0 ? r + beyondFoot : h * (h / (r - beyondFoot));
}

// Two points of the panel of PointAirlight, symmetric about its middle.
FUNCTION Real PointAirlightPair(IN(PhaseFunction) phase, IN(Real) extinction, IN(Real) h,
  IN(Real) start, IN(Real) size, IN(Real) place)
{
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
  Real h = PointLightHeight(foot, height, begin, end);
  Real y = PointLightWay(begin - foot, h);
  Real rNear = sqrt(h * h + (begin - foot) * (begin - foot));
  Real rFar = sqrt(h * h + (end - foot) * (end - foot));
  Real left = (end - begin) * (y + PointLightWay(end - foot, h)) / (rNear + rFar);
  // The integrand's poles are at y = +-i h and at +-i times this.
  Real g = phase.Kind >= 2 ? abs(phase.Asymmetry) : 0.0;
  Real k = phase.Kind == 4 ? SchlickParameter(g) : g;
  Real scale = phase.Kind == 4 ? h * sqrt((1.0 - k) / (1.0 + k)) : h * (1.0 - k) / (1.0 + k);
  if (phase.Kind >= 2 && phase.Asymmetry < 0.0)
  {
    scale = h; // the poles of a peak to the back are beyond
  }
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

// A medium that thins out exponentially with height above the plane of reference, where its
// coefficients are given. slope is the rise of a way for each unit of its length, -1 to 1.

// Density at a height, of that at height 0; the height is kept within 80 scale heights of that.
// Formula: e^(-height/scaleHeight). [no unit]
FUNCTION Real ExponentialDensity(IN(Real) height, IN(Real) scaleHeight)
{
  return exp(-clamp(height / scaleHeight, -80.0, 80.0));
}

// Optical depth of a straight way from a height, up or down.
// Formula: extinction distance e^(-height/H) phi(slope distance/H), phi = MeanExponential. [no unit]
FUNCTION Real ExponentialDepth(IN(Real) extinction, IN(Real) height, IN(Real) slope,
  IN(Real) scaleHeight, IN(Real) distance)
{
  Real rise = slope * distance;
  Real low = ExponentialDensity(rise < 0.0 ? height + rise : height, scaleHeight);
  return extinction * distance * low * MeanExponential(abs(rise) / scaleHeight);
}

// Heights above a plane or, with a planetRadius above 0, above a planet's ground: see "The sky".
FUNCTION Real SkyRise(IN(Real) radius, IN(Real) slope, IN(Real) distance);
FUNCTION Vec2 SkyBelow(
  IN(Real) groundRadius, IN(Real) height, IN(Real) slope, IN(Real) topHeight);
FUNCTION Real SkyGroundDistance(IN(Real) groundRadius, IN(Real) height, IN(Real) slope);
FUNCTION Real SkyExponentialColumn(IN(Real) groundRadius, IN(Real) scaleHeight, IN(Real) height,
  IN(Real) slope, IN(Real) distance);

// The height at which a way from another one ends.
// Formula: height + slope distance, or height + SkyRise. [length]
FUNCTION Real MediumHeight(
  IN(Real) planetRadius, IN(Real) height, IN(Real) slope, IN(Real) distance)
{
  return height +
    (planetRadius > 0.0 ? SkyRise(planetRadius + height, slope, distance) : slope * distance);
}

// The slope of a straight way of known length between two heights, where it starts.
// Formula: (end - height)/distance, or, from (R + end)^2 = (R + height)^2 + d^2 + 2 (R + height) d slope,
// ((end - height) (2 R + height + end) - d^2)/(2 (R + height) d). [no unit]
FUNCTION Real MediumSlope(
  IN(Real) planetRadius, IN(Real) height, IN(Real) end, IN(Real) distance)
{
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

// The same of a way to where nothing is any more, of a medium that thins out: up over a plane, else to
// 40 scale heights above.
// Formula: scaleHeight density/slope, or SkyExponentialColumn. [length]
FUNCTION Real MediumColumn(
  IN(Real) planetRadius, IN(Real) height, IN(Real) slope, IN(Real) scaleHeight)
{
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
// its result; a plane hides nothing.
FUNCTION bool IsInPlanetShadow(IN(LitRay) ray, IN(Real) height, IN(Real) slope, IN(Real) r)
{
  Real ground =
    ray.PlanetRadius > 0.0 ? SkyGroundDistance(ray.PlanetRadius, height, slope) : -1.0;
  return ground >= 0.0 && (ray.Infinite != 0 || ground < r);
}

// Where a ray that would go on to end stops: at a planet's ground. [length]
FUNCTION Real MediumEnd(IN(LitRay) ray, IN(Real) end)
{
  Real ground =
    ray.PlanetRadius > 0.0 ? SkyGroundDistance(ray.PlanetRadius, ray.Height, ray.Slope) : -1.0;
  return ground >= 0.0 ? min(ground, end) : end;
}

// Optical depth of the light's way to a point of the ray at a height, r from a point light. Only a
// medium that thins out dims a light that is infinitely far, and hides one below the horizon.
// Formula: see MediumDepth() and MediumColumn(). [no unit]
FUNCTION Real LightDepth(IN(MediumComponent) component, IN(LitRay) ray, IN(Real) height,
  IN(Real) slope, IN(Real) r)
{
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

// --- The sky -------------------------------------------------------------------------------------

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
  PhaseFunction AerosolPhase;
};

// How much higher the end of a way is than its start, without cancellation.
// Formula: d (2 r slope + d)/(r + sqrt(r^2 + d (2 r slope + d))), r the start's radius. [length]
FUNCTION Real SkyRise(IN(Real) radius, IN(Real) slope, IN(Real) distance)
{
  Real more = distance * (2.0 * radius * slope + distance);
  return more / (radius + sqrt(max(radius * radius + more, 0.0)));
}

// The part of a way, from distance x to distance y, that is below topHeight; x above y if there is none.
// Formula: d^2 + 2 r slope d = (top - height) (2 GroundRadius + top + height). [length]
FUNCTION Vec2 SkyBelow(
  IN(Real) groundRadius, IN(Real) height, IN(Real) slope, IN(Real) topHeight)
{
  Real along = (groundRadius + height) * slope;
  Real room = (topHeight - height) * (2.0 * groundRadius + topHeight + height);
  Real square = along * along + room;
  if (square < 0.0 || (room < 0.0 && along >= 0.0))
  {
    return Vec2(1.0, 0.0);
  }
  Real root = sqrt(square);
  Real leave = along > 0.0 ? room / (along + root) : root - along;
  return Vec2(room < 0.0 ? -room / (root - along) : 0.0, leave);
}

// The distance at which a way meets the ground; -1 if it does not.
// Formula: height (2 GroundRadius + height)/(-r slope + sqrt(...)), as SkyBelow's entry. [length]
FUNCTION Real SkyGroundDistance(IN(Real) groundRadius, IN(Real) height, IN(Real) slope)
{
  Real along = (groundRadius + height) * slope;
  Real room = max(height, 0.0) * (2.0 * groundRadius + height);
  Real square = along * along - room;
  return slope < 0.0 && square >= 0.0 ? room / (sqrt(square) - along) : -1.0;
}

// e^(z^2) erfc(z) for z from 0 on, to 1.2e-7 of itself.
// Formula: t e^P(t), t = 1/(1 + z/2), P a polynomial. [no unit] [Press1992] 6.2
FUNCTION Real ScaledErfc(IN(Real) z)
{
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
FUNCTION Real ChapmanColumn(IN(Real) radius, IN(Real) slope, IN(Real) scaleHeight)
{
  Real side = 1.0 + sqrt(max(1.0 - slope * slope, 0.0));
  Real z = slope * sqrt(radius / (side * scaleHeight));
  Real tail = ScaledErfc(z);
  Real meanRise = clamp(0.5 - z * z + z * 0.5641895835477563 / tail, 0.5, 1.0) * scaleHeight;
  return 1.7724538509055160 * sqrt(scaleHeight * radius / side) * tail *
    (1.0 + meanRise / radius * (1.0 - 0.5 / side));
}

// Column of an exponential density along a way: what is above its lower end less what is above its upper
// end; with the lowest point between them, twice what is above that less what is above both.
// Formula: e^(-h/H) ChapmanColumn. [length]
FUNCTION Real SkyExponentialColumn(IN(Real) groundRadius, IN(Real) scaleHeight, IN(Real) height,
  IN(Real) slope, IN(Real) distance)
{
  Real radius = groundRadius + height;
  Real rise = SkyRise(radius, slope, distance);
  Real endRadius = radius + rise;
  Real endSlope = (radius * slope + distance) / endRadius;
  Real start = ExponentialDensity(height, scaleHeight) *
    ChapmanColumn(radius, min(abs(slope), 1.0), scaleHeight);
  Real end = ExponentialDensity(height + rise, scaleHeight) *
    ChapmanColumn(endRadius, min(abs(endSlope), 1.0), scaleHeight);
  if (slope >= 0.0)
  {
    return max(start - end, 0.0);
  }
  if (endSlope <= 0.0)
  {
    return max(end - start, 0.0);
  }
  Real dip = SkyRise(radius, slope, -radius * slope);
  Real lowest = ExponentialDensity(height + dip, scaleHeight) *
    ChapmanColumn(radius + dip, 0.0, scaleHeight);
  return max(2.0 * lowest - start - end, 0.0);
}

// The integral along a way of how far it is below topHeight. The height is nearly quadratic along it:
// Gauss-Legendre of 3 points.
// Formula: integral max(topHeight - h, 0) ds. [length^2]
FUNCTION Real SkyRampColumn(IN(Real) groundRadius, IN(Real) topHeight, IN(Real) height,
  IN(Real) slope, IN(Real) distance)
{
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

// Light of the sun that is scattered once, on a unit of a way, into the way's start, for an irradiance of
// 1; the point is not in the planet's shadow. Its integral along the way is the sky's radiance.
// Formula: (beta_air density phase + beta_aerosol density phase) e^-(depth to the start + depth to the
// sun). [1/(length sr)] [Nishita1993]
FUNCTION Vec3 SkyInscatter(IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) slope,
  IN(Real) sunSlope, IN(Real) cosAngle, IN(Real) distance)
{
  Real radius = sky.GroundRadius + height;
  Real rise = SkyRise(radius, slope, distance);
  Real sunSlopeThere = clamp((radius * sunSlope + distance * cosAngle) / (radius + rise), -1.0, 1.0);
  Vec3 scattered = sky.AirScattering * (SkyDensity(sky.Air, height + rise) * Phase(sky.AirPhase, cosAngle)) +
    sky.AerosolScattering *
      (SkyDensity(sky.Aerosol, height + rise) * Phase(sky.AerosolPhase, cosAngle));
  return scattered * exp(-SkyDepth(sky, height, slope, distance)) *
    SkySunTransmittance(sky, height + rise, sunSlopeThere);
}

// Light of the sun that the ground reflects into all directions alike, after Lambert, for an irradiance of
// 1; 0 at night. Formula: albedo/pi sunSlope SkySunTransmittance. [1/sr]
FUNCTION Vec3 SkyGround(IN(SkyAtmosphere) sky, IN(Vec3) albedo, IN(Real) sunSlope)
{
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
FUNCTION SkyWay MakeSkyWay(IN(SkyAtmosphere) sky, IN(Real) height, IN(Real) slope, IN(Real) sunSlope,
  IN(Real) cosAngle)
{
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
  Real radius = sky.GroundRadius + way.Height;
  Real rise = SkyRise(radius, way.Slope, distance);
  return Vec2(max(way.Height + rise, 0.0),
    clamp((radius * way.SunSlope + distance * way.CosAngle) / (radius + rise), -1.0, 1.0));
}

// The slopes at which an observer sees the ground's horizon and the atmosphere's edge; the latter is 1
// within it. Formula: -sqrt((height - h) (2 GroundRadius + height + h))/(GroundRadius + height). [no unit]
FUNCTION Vec2 SkyEdges(IN(Real) groundRadius, IN(Real) topHeight, IN(Real) height)
{
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
  Real square = row * row;
  Real fourth = square * square;
  return edges.x + (row < 0.0 ? -1.0 - edges.x : edges.y - edges.x) * (fourth * (2.0 - fourth));
}

FUNCTION Real SkyTableRow(IN(Vec2) edges, IN(Real) slope)
{
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
  Vec3 a = Vec3(0.4064, 0.5079, 0.6406);
  Real square = max(1.0 - part * part, 1e-4);
  return (1.0 + 0.5 * a) *
    Vec3(pow(square, 0.5 * a.x), pow(square, 0.5 * a.y), pow(square, 0.5 * a.z));
}

// What a march of the first order makes of a homogeneous step of optical depth tau, of what it is.
// Formula: 1/MeanExponential(tau). [no unit]
FUNCTION Real FirstOrderStepBias(IN(Real) tau)
{
  return 1.0 / MeanExponential(tau);
}

// Pictures of all directions. Directions have length 1: x to the right (east), y up in the picture
// (north), z to the zenith. Positions are -1 to 1 across the picture in both axes.
//   kind 0 paraboloid: the zenith in the middle, the horizon a circle of radius 1
//   kind 1 equirectangular: azimuth from north clockwise, 0 to 360 degrees from left to right, nadir to
//          zenith from the bottom up
//   kind 2 fisheye: as 0, with the distance from the middle proportional to the angle from the zenith

// Formula: kind 0 (2 x, 2 y, 1 - r^2)/(1 + r^2). [no unit] [Heidrich1998] for the paraboloid
FUNCTION Vec3 SkyMapDirection(IN(int) kind, IN(Vec2) position)
{
  if (kind == 0)
  {
    Real square = dot(position, position);
    return Vec3(2.0 * position.x, 2.0 * position.y, 1.0 - square) / (1.0 + square);
  }
  if (kind == 1)
  {
    Real azimuth = 3.14159265358979324 * (position.x + 1.0);
    Real elevation = 1.57079632679489662 * position.y;
    return Vec3(cos(elevation) * sin(azimuth), cos(elevation) * cos(azimuth), sin(elevation));
  }
  Real reach = length(position);
  Real angle = 1.57079632679489662 * reach;
  Real scale = reach > 1e-6 ? sin(angle) / reach : 1.57079632679489662;
  return Vec3(scale * position.x, scale * position.y, cos(angle));
}

// The inverse of SkyMapDirection. The nadir has no position in kind 0, and gets one far away.
// Formula: kind 0 (x, y)/(1 + z). [no unit]
FUNCTION Vec2 SkyMapPosition(IN(int) kind, IN(Vec3) direction)
{
  Vec2 level = Vec2(direction.x, direction.y);
  Real reach = length(level);
  if (kind == 0)
  {
    return level / max(1.0 + direction.z, 1e-12);
  }
  if (kind == 1)
  {
    Real turn = reach > 0.0 ? atan(direction.x, direction.y) / 3.14159265358979324 : 0.0;
    return Vec2(turn < 0.0 ? turn + 1.0 : turn - 1.0,
      atan(direction.z, reach) / 1.57079632679489662);
  }
  return level * (atan(reach, direction.z) / 1.57079632679489662 / max(reach, 1e-12));
}

// The solid angle of a unit of a picture's area about a position.
// Formula: kind 0 4/(1 + r^2)^2, kind 1 pi^2/2 cos(elevation), kind 2 pi/2 sin(angle)/r. [sr]
FUNCTION Real SkyMapSolidAngle(IN(int) kind, IN(Vec2) position)
{
  if (kind == 0)
  {
    Real width = 1.0 + dot(position, position);
    return 4.0 / (width * width);
  }
  if (kind == 1)
  {
    return 4.93480220054467931 * cos(1.57079632679489662 * position.y);
  }
  Real reach = max(length(position), 1e-6);
  return 1.57079632679489662 * sin(1.57079632679489662 * reach) / reach;
}

// A direction of a face of a cube map, as OpenGL numbers and turns them: +x, -x, +y, -y, +z, -z. Position
// is -1 to 1 to the right and down in the face. Of length 1 or more; its solid angle is 1/length^3.
// Formula: OpenGL 3.2 specification, table 3.19. [no unit]
FUNCTION Vec3 CubeMapDirection(IN(int) face, IN(Vec2) position)
{
  Real s = position.x;
  Real t = position.y;
  if (face < 2)
  {
    return face == 0 ? Vec3(1.0, -t, -s) : Vec3(-1.0, -t, s);
  }
  if (face < 4)
  {
    return face == 2 ? Vec3(s, 1.0, t) : Vec3(s, -1.0, -t);
  }
  return face == 4 ? Vec3(s, -t, 1.0) : Vec3(-s, -t, -1.0);
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

// --- Shared exponents ----------------------------------------------------------------------------

// A colour in four bytes: three mantissas and their exponent of 2. NaN, negative numbers and those below
// 2^-127 become 0, others are at most 2^127 (255/256). The error of each channel is at most half a unit
// of the mantissa: 0.39 % of the brightest channel or less.

// The exponent for the brightest channel m. variant 0, as published: ceil(log2 m), a mantissa in (1/2, 1]
// that is stored as 255 of itself. variant 1, of Radiance: that of frexp, a mantissa in [1/2, 1) that is
// stored as 256 of itself; one higher if it rounds to 256.
// Formula: ceil(log2 m); floor(log2 m) + 1. [no unit] [Lodato2015], [Ward1991]
FUNCTION Real SharedExponent(IN(int) variant, IN(Real) brightest)
{
  Real exponent = ceil(log2(brightest));
  // The logarithm may be rounded across a whole number.
  exponent += brightest > exp2(exponent) ? 1.0 : (brightest <= exp2(exponent - 1.0) ? -1.0 : 0.0);
  return variant == 1 && brightest * 256.0 >= 255.5 * exp2(exponent) ? exponent + 1.0 : exponent;
}

// Formula: mantissa = c/2^e, rounded to 1/255 (1/256); exponent e + 128. [bytes]
FUNCTION Vec4 EncodeSharedExponent(IN(int) variant, IN(Vec3) colour)
{
  Vec3 light = Sanitize(colour, 1.69e38);
  Real brightest = max(light.x, max(light.y, light.z));
  if (brightest < 5.9e-39)
  {
    return Vec4(0.0, 0.0, 0.0, 0.0);
  }
  Real exponent = SharedExponent(variant, brightest);
  Real scale = (variant == 1 ? 256.0 : 255.0) * exp2(-exponent);
  return Vec4(floor(light.x * scale + 0.5), floor(light.y * scale + 0.5),
    floor(light.z * scale + 0.5), exponent + 128.0);
}

// The inverse, for bytes. Formula: 2^(e - 128) mantissa. [the colour's unit]
FUNCTION Vec3 DecodeSharedExponent(IN(int) variant, IN(Vec4) bytes)
{
  if (bytes.w == 0.0)
  {
    return Vec3(0.0);
  }
  return Vec3(bytes.x, bytes.y, bytes.z) *
    (exp2(bytes.w - 128.0) / (variant == 1 ? 256.0 : 255.0));
}
