//VTK::System::Dec
//VTK::Output::Dec

// The weighted sum of taps from a pixel of the picture towards the light.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Radial

uniform vec2 size; // of the picture [pixels]
uniform sampler2D layer;
uniform TapSum taps;
uniform vec3 lightClip;
uniform float marchScale;
uniform float viewScale; // fraction of the layer that the picture covers

//VTK::GodRays::Terms
// jitter: each pixel's taps have an offset of their own

void main()
{
  vec2 picture = (floor(texCoord * size) + 0.5) / size; // the centre of the pixel, exactly
  vec2 uv = 0.5 + (picture - 0.5) * viewScale;
  TapSum sum = taps;
  if (jitter)
  {
    sum.TapOffset += InterleavedGradientNoise(floor(texCoord * size)) - 0.5;
  }
  vec2 march = MarchVector(lightClip, 2.0 * uv - 1.0, marchScale);
  // Where a published bias and its taps cancel each other, rounding can leave less than no light.
  gl_FragData[0] = vec4(max(SumTaps(layer, sum, uv, march), 0.0), 1.0);
}
