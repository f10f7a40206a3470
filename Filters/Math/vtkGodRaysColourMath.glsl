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
