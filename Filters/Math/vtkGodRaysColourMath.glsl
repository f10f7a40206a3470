// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Colours: display transfer, tone mapping, blending, shared exponents.

//VTK::GodRays::Common

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

// DecodeDisplay() for values of 8 bits, without a power, which software OpenGL is slow at: within 1.1e-5,
// less than 0.04 of a step from a value to the next.
// Formula: the polynomial that is (c + 0.055)^2.4/1.055^2.4 at the Chebyshev nodes of 0.04045 to 1.
// [linear light]
FUNCTION Real DecodeDisplay8(IN(Real) value)
{
  GODRAYS_EXPECT(value >= 0.0 && value <= 1.0);
  Real power = -0.04716058174 * value + 0.20313659602;
  power = power * value - 0.40627094986;
  power = power * value + 0.70087075470;
  power = power * value + 0.51585768977;
  power = power * value + 0.03263252975;
  power = power * value + 0.00093114544;
  return value <= 0.04045 ? value / 12.92 : power;
}

// EncodeDisplay() for values of 8 bits, within 1.1e-5; light beyond 0 to 1 counts as these.
// Formula: the polynomial of q = c^(1/4) that is 1.055 q^(5/3) - 0.055 at the Chebyshev nodes of
// 0.0031308^(1/4) to 1. [display value]
FUNCTION Real EncodeDisplay8(IN(Real) light)
{
  Real shown = clamp(light, 0.0, 1.0);
  Real q = sqrt(sqrt(shown));
  Real power = -0.06275899154 * q + 0.27275224369;
  power = power * q - 0.55755564903;
  power = power * q + 1.24421399618;
  power = power * q + 0.16497400034;
  power = power * q - 0.06162970564;
  return shown <= 0.0031308 ? 12.92 * shown : power;
}

FUNCTION Vec3 DecodeDisplay8(IN(Vec3) value)
{
  return Vec3(DecodeDisplay8(value.x), DecodeDisplay8(value.y), DecodeDisplay8(value.z));
}

FUNCTION Vec3 EncodeDisplay8(IN(Vec3) light)
{
  return Vec3(EncodeDisplay8(light.x), EncodeDisplay8(light.y), EncodeDisplay8(light.z));
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
  GODRAYS_EXPECT(min(light.x, min(light.y, light.z)) >= 0.0 && inverseWhite >= 0.0);
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

// Rays over a scene, of which no channel is clipped: light adds up to half of the room that the scene
// leaves below 0.99, which 8 bits show as 254 of 255, in the channel that has the least for these rays; what
// is more is compressed, all channels alike, so that rays keep their hue. Where there is no room, the scene
// is as it was.
// Formula: a + b y(x)/x, with x = max b/(0.99 - a), y = x to 1/2, then 1 - exp(1 - 2 x)/2; y, its slope and
// the channels are continuous. [linear light, 1 is white]
FUNCTION Vec3 BlendShoulder(IN(Vec3) scene, IN(Vec3) rays)
{
  Vec3 part = rays / max(Vec3(0.99) - scene, Vec3(1e-6));
  Real used = max(part.x, max(part.y, part.z));
  return used <= 0.5 ? scene + rays : scene + rays * ((1.0 - 0.5 * exp(1.0 - 2.0 * used)) / used);
}

// Rays over data: faint ones as they are, strong ones up to a cap. Without it, the light's core makes data
// before it look transparent. All channels have the same factor.
// Formula: c (1 - exp(-m/c))/m, m being the brightest channel. [linear light]
FUNCTION Vec3 CapLight(IN(Vec3) light)
{
  Real cap = 0.1;
  Real most = max(light.x, max(light.y, light.z));
  return most > 1e-4 ? light * (cap * (1.0 - exp(-most / cap)) / most) : light;
}

// Ordered noise that hides the steps of 8 bits, in [-1/2, 1/2) levels: interleaved gradient noise of a
// pixel's column and row. [levels] [Jimenez2014]
FUNCTION Real OrderedNoise(IN(Vec2) pixel)
{
  return 0.98 * (fract(52.9829189 * fract(dot(pixel, Vec2(0.06711056, 0.00583715)))) - 0.5);
}

// Luminance of what is lit at a distance from a light, by a fit to that of a picture.
// Formula: exp(a + b u + c u^2), u = log(r + 0.05). [r: heights of the picture]
FUNCTION Real RingLight(IN(Vec3) fit, IN(Real) r)
{
  GODRAYS_EXPECT(r >= 0.0);
  Real u = log(r + 0.05);
  return exp(fit.x + u * (fit.y + u * fit.z));
}

// A light background, which rays cannot make lighter. It keeps its colour where rays are as bright as a
// reference, and becomes a cool grey in their shadows: white becomes sRGB's (178, 189, 208).
// Formula: a (1 - s (1 - g) (1 - min(Y/Y_ref, 1))^0.75), g = (0.445, 0.509, 0.631). [linear light]
FUNCTION Vec3 BlendSurround(IN(Vec3) scene, IN(Vec3) rays, IN(Real) reference, IN(Real) part)
{
  GODRAYS_EXPECT(reference > 0.0 && part >= 0.0 && part <= 1.0);
  Real dark = part * pow(1.0 - min(Luminance(rays) / reference, 1.0), Real(0.75));
  return scene * (Vec3(1.0) - dark * Vec3(0.555, 0.491, 0.369));
}

// The factor on what a medium lets through of data, whose lamps are taken for as much brighter; data are at
// most as bright as without the medium. Formula: 1 + p (min(g, 1/max t) - 1). [no unit]
FUNCTION Real DataGain(IN(Vec3) transmittance, IN(Real) gain, IN(Real) dataPart)
{
  GODRAYS_EXPECT(gain >= 1.0 && dataPart >= 0.0 && dataPart <= 1.0);
  Real most = max(transmittance.x, max(transmittance.y, transmittance.z));
  return 1.0 + dataPart * (min(gain, 1.0 / max(most, 1e-6)) - 1.0);
}

// --- Differences of colours ----------------------------------------------------------------------

// A step of CIE 1976 L*a*b*: the cube root, with a line near 0, and the inverse. [no unit]
// [CIE15] 8.2.1: with 6/29 and 4/29
FUNCTION Real LabStep(IN(Real) t)
{
  return t > 216.0 / 24389.0 ? pow(t, 1.0 / 3.0) : t * (841.0 / 108.0) + 4.0 / 29.0;
}

FUNCTION Real LabStepInverse(IN(Real) f)
{
  return f > 6.0 / 29.0 ? f * f * f : (f - 4.0 / 29.0) * (108.0 / 841.0);
}

// CIE 1976 L*a*b* of linear light of the primaries of sRGB, relative to their white, of which L* is 100:
// distances in it are differences as seen, of which 2 to 3 are just visible.
// Formula: L* = 116 f(Y) - 16, a* = 500 (f(X) - f(Y)), b* = 200 (f(Y) - f(Z)). [L*, a*, b*]
// [CIE15] 8.2.1; the primaries' matrix: [IEC61966-2-1]
FUNCTION Vec3 LabOfLight(IN(Vec3) light)
{
  GODRAYS_EXPECT(min(light.x, min(light.y, light.z)) >= 0.0);
  Real x = LabStep(dot(light, Vec3(0.4124564, 0.3575761, 0.1804375)) / 0.95047);
  Real y = LabStep(dot(light, Vec3(0.2126729, 0.7151522, 0.0721750)));
  Real z = LabStep(dot(light, Vec3(0.0193339, 0.1191920, 0.9503041)) / 1.08883);
  return Vec3(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z));
}

// The inverse; channels of colours beyond the primaries are below 0 or above 1. [linear light]
FUNCTION Vec3 LightOfLab(IN(Vec3) lab)
{
  Real y = (lab.x + 16.0) / 116.0;
  Vec3 xyz = Vec3(0.95047 * LabStepInverse(y + lab.y / 500.0), LabStepInverse(y),
    1.08883 * LabStepInverse(y - lab.z / 200.0));
  return Vec3(dot(xyz, Vec3(3.2404542, -1.5371385, -0.4985314)),
    dot(xyz, Vec3(-0.9692660, 1.8760108, 0.0415560)),
    dot(xyz, Vec3(0.0556434, -0.2040259, 1.0572252)));
}

// How much of a colour is seen: nothing in the dark, below a lightness of 5, all from 20 on. [fraction]
FUNCTION Real SeenPart(IN(Vec3) light)
{
  return smoothstep(5.0, 20.0, 116.0 * LabStep(Luminance(light)) - 16.0);
}

// A scene's colour, as light or dark as it is with rays, by at most some lightness: hue and chroma stay, and
// where the primaries have no lighter or darker colour of these, lightness goes as far as they have, and no
// channel beyond 0.99 or what it was, as in BlendShoulder().
// Formula: L* towards that of the joined light, a* and b* as they were. [linear light]
FUNCTION Vec3 BlendLightness(IN(Vec3) scene, IN(Vec3) joined, IN(Real) mostLightness)
{
  Vec3 lab = LabOfLight(scene);
  Real change = clamp(LabOfLight(joined).x - lab.x, -mostLightness, mostLightness);
  Real most = max(0.99, max(scene.x, max(scene.y, scene.z)));
  Real low = 0.0;
  Real high = 1.0;
  for (int i = 0; i < 10; ++i)
  {
    Real middle = i == 0 ? 1.0 : 0.5 * (low + high);
    Vec3 light = LightOfLab(Vec3(lab.x + middle * change, lab.y, lab.z));
    bool isShown = min(light.x, min(light.y, light.z)) >= -1e-4 &&
      max(light.x, max(light.y, light.z)) <= most;
    low = isShown ? middle : low;
    high = isShown ? high : middle;
  }
  Vec3 light = LightOfLab(Vec3(lab.x + low * change, lab.y, lab.z));
  return low > 0.0 ? clamp(light, Vec3(0.0), Vec3(1.0)) : scene;
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
  GODRAYS_EXPECT(brightest > 0.0);
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
