//VTK::System::Dec
//VTK::Output::Dec

// The occlusion layer of one light: its emitter, less the occluders.

in vec2 texCoord; // of the layer

//VTK::GodRays::Common
//VTK::GodRays::Colour
//VTK::GodRays::Light

uniform sampler2D occluderDepth;

//VTK::GodRays::Terms
// dimmed: whether translucent props or volumes dim the light
// prop: whether a prop shines
// disc: whether a disc does
// evenly: whether all of the prop has the light's colour
// hazy: whether it has translucent parts or is a volume
// multisampled: whether occluderDepth is of a sample, not the centre, of each pixel
// planar: separations are lengths in the picture's plane, not angles
// linearLight: whether the layer holds linear light, or shown values
// isPower: whether shown values stand for light by a power

uniform sampler2D translucency;   // opacity of what dims, in alpha
uniform sampler2D propColor;
uniform sampler2D propDepth;
uniform sampler2D haze;           // colours of the hazy parts over black, before the occluders

uniform vec3 pictureOrigin;       // + x right + y up: a place in the picture, or a ray to it
uniform vec3 pictureRight;
uniform vec3 pictureUp;
uniform vec2 pixelStep;           // in x and y
uniform vec3 lightPosition;
uniform vec3 lightDirection;
uniform float lightDepth;
uniform vec3 lightColor;
uniform float lightRadius;
uniform float leastPixel;         // where all rays are parallel; else 0
uniform float fade;

uniform float glow;
uniform float glowRadius;
uniform float glowFalloff;

uniform float maximum;            // that the layer can hold

// The largest window depth below 1 differs from it by 2^-24 or more.
const float farthest = 1.0 - 1.0 / 16777216.0;

// Depth of the prop some pixels away; 1 where it is not.
float PropDepth(ivec2 pixel)
{
  return texelFetch(propDepth, clamp(pixel, ivec2(0), textureSize(propDepth, 0) - 1), 0).r;
}

// How much the depth of the prop changes from a pixel to the next on one side, where the prop goes
// on there without a step.
float OneSidedSlope(ivec2 pixel, ivec2 side)
{
  float depth = PropDepth(pixel);
  float beside = PropDepth(pixel + side);
  float next = PropDepth(pixel + 2 * side);
  return beside >= farthest || next >= farthest ? 0.0
                                                : min(abs(beside - depth), abs(next - beside));
}

float Slopes(ivec2 pixel)
{
  return max(OneSidedSlope(pixel, ivec2(-1, 0)), OneSidedSlope(pixel, ivec2(1, 0))) +
    max(OneSidedSlope(pixel, ivec2(0, -1)), OneSidedSlope(pixel, ivec2(0, 1)));
}

// The least depth that the prop may have within a pixel. The depth of the occluders holds the prop
// too, but when it is multisampled that depth is the one of a sample up to half a pixel off the
// centre: of the slanted surface at the centre, or of a nearer part of the prop that ends there.
float LeastPropDepth(ivec2 pixel)
{
  float depth = PropDepth(pixel);
  float least = depth;
  ivec2 nearest = pixel;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 other = pixel + ivec2(i % 3 - 1, i / 3 - 1);
    float otherDepth = PropDepth(other);
    if (otherDepth < least)
    {
      least = otherDepth;
      nearest = other;
    }
  }
  return min(depth - 0.5 * Slopes(pixel), least - Slopes(nearest));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(occluderDepth, pixel, 0).r;

  vec2 ndc = 2.0 * texCoord - 1.0;
  vec3 place = pictureOrigin + ndc.x * pictureRight + ndc.y * pictureUp;
  vec3 right = pixelStep.x * pictureRight;
  vec3 up = pixelStep.y * pictureUp;
  float pixelSize =
    planar ? max(length(right), length(up)) : max(PixelAngle(place, right, up), leastPixel);
  float separation =
    planar ? length(place.xy - lightPosition.xy) : AngleBetween(place, lightDirection);

  float glowing = depth >= farthest ? glow * GlowFalloff(separation, glowRadius, glowFalloff) : 0.0;
  vec3 light = glowing * lightColor;
  if (prop)
  {
    float propNearest = multisampled ? LeastPropDepth(pixel) : PropDepth(pixel);
    if (PropDepth(pixel) < farthest && propNearest <= depth + 1e-6)
    {
      vec4 shown = texelFetch(propColor, pixel, 0);
      light = evenly ? lightColor
                     : fade * (linearLight ? DecodeDisplay(shown.rgb, isPower) : shown.rgb);
    }
    if (hazy)
    {
      vec4 veil = texelFetch(haze, pixel, 0);
      light *= 1.0 - veil.a;
      light += fade * (linearLight ? DecodeDisplay(veil.rgb, isPower) : veil.rgb);
    }
  }
  else if (disc && depth >= min(lightDepth, farthest))
  {
    light = max(light, lightColor * DiscCoverage(separation, lightRadius, pixelSize));
  }
  if (dimmed)
  {
    light *= 1.0 - texelFetch(translucency, pixel, 0).a;
  }
  gl_FragData[0] = vec4(Sanitize(light, maximum), 1.0);
}
