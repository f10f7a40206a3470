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

uniform sampler2D coarse; // the sum on a coarser grid
uniform bool refine;      // whether to start from it
uniform float threshold;  // neighbours that differ by more are not interpolated

//VTK::GodRays::Terms
// jitter: each pixel's taps have an offset of their own

// The centre of the pixel, exactly.
vec2 Picture()
{
  return (floor(texCoord * size) + 0.5) / size;
}

vec3 Evaluate()
{
  vec2 uv = 0.5 + (Picture() - 0.5) * viewScale;
  TapSum sum = taps;
  if (jitter)
  {
    sum.TapOffset += InterleavedGradientNoise(floor(texCoord * size)) - 0.5;
  }
  return SumTaps(layer, sum, uv, MarchVector(lightClip, 2.0 * uv - 1.0, marchScale));
}

float Greatest(vec3 c)
{
  return max(c.r, max(c.g, c.b));
}

void main()
{
  vec3 sum;
  if (refine)
  {
    ivec2 last = textureSize(coarse, 0) - 1;
    vec2 position = Picture() * vec2(last + 1) - 0.5;
    ivec2 corner = ivec2(floor(position));
    vec2 t = position - vec2(corner);
    vec3 a = texelFetch(coarse, clamp(corner, ivec2(0), last), 0).rgb;
    vec3 b = texelFetch(coarse, clamp(corner + ivec2(1, 0), ivec2(0), last), 0).rgb;
    vec3 c = texelFetch(coarse, clamp(corner + ivec2(0, 1), ivec2(0), last), 0).rgb;
    vec3 d = texelFetch(coarse, clamp(corner + ivec2(1, 1), ivec2(0), last), 0).rgb;
    vec3 range = max(max(a, b), max(c, d)) - min(min(a, b), min(c, d));
    sum = Greatest(range) > threshold ? Evaluate() : mix(mix(a, b, t.x), mix(c, d, t.x), t.y);
  }
  else
  {
    sum = Evaluate();
  }
  gl_FragData[0] = vec4(sum, 1.0);
}
