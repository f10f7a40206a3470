//VTK::System::Dec
//VTK::Output::Dec

// The occlusion layer of one light: what shines, less what blocks it.

in vec2 texCoord; // of the layer

//VTK::GodRays::Types
//VTK::GodRays::Functions

uniform sampler2D occluderDepth;

uniform bool dimmed;              // whether translucent props or volumes dim the light
uniform sampler2D translucency;   // their opacity, in alpha

uniform bool prop;                // whether a prop shines, rather than a disc
uniform sampler2D propColor;
uniform sampler2D propDepth;

uniform mat4 clipToView;
uniform bool planar;              // separations are lengths in the picture's plane, not angles
uniform vec3 lightPosition;
uniform vec3 lightDirection;
uniform float lightDepth;
uniform vec3 lightColor;
uniform float lightRadius;
uniform float fade;

uniform float glow;
uniform float glowRadius;
uniform float glowFalloff;

uniform bool linearLight;
uniform float maximum;            // that the layer can hold

// The largest window depth below 1 differs from it by 2^-24 or more.
const float farthest = 1.0 - 1.0 / 16777216.0;

// How far depth may change from a pixel's centre to its samples: the slope of the surface, taken on
// the side where the surface goes on.
float DepthSlope(ivec2 pixel, float depth)
{
  ivec2 last = textureSize(propDepth, 0) - 1;
  float left = texelFetch(propDepth, max(pixel - ivec2(1, 0), ivec2(0)), 0).r;
  float right = texelFetch(propDepth, min(pixel + ivec2(1, 0), last), 0).r;
  float below = texelFetch(propDepth, max(pixel - ivec2(0, 1), ivec2(0)), 0).r;
  float above = texelFetch(propDepth, min(pixel + ivec2(0, 1), last), 0).r;
  return max(min(abs(left - depth), abs(right - depth)), min(abs(below - depth), abs(above - depth)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(occluderDepth, pixel, 0).r;

  vec2 ndc = 2.0 * texCoord - 1.0;
  vec4 onNear = clipToView * vec4(ndc, -1.0, 1.0);
  vec4 onFar = clipToView * vec4(ndc, 1.0, 1.0);
  vec3 ray = normalize(onFar.xyz * onNear.w - onNear.xyz * onFar.w);
  vec3 place = onNear.xyz / onNear.w;
  vec3 across = planar ? place : ray;
  float pixelSize = max(length(dFdx(across)), length(dFdy(across)));
  float separation =
    planar ? length(place.xy - lightPosition.xy) : AngleBetween(ray, lightDirection);

  float glowing = depth >= farthest ? glow * GlowFalloff(separation, glowRadius, glowFalloff) : 0.0;
  vec3 light = glowing * lightColor;
  if (prop)
  {
    vec4 shown = texelFetch(propColor, pixel, 0);
    float shownDepth = texelFetch(propDepth, pixel, 0).r;
    if (shown.a > 0.0 && shownDepth <= depth + DepthSlope(pixel, shownDepth) + 1e-6)
    {
      light = fade * (linearLight ? DecodeDisplay(shown.rgb) : shown.rgb);
    }
  }
  else if (depth >= min(lightDepth, farthest))
  {
    light = max(light, lightColor * DiscCoverage(separation, lightRadius, pixelSize));
  }
  if (dimmed)
  {
    light *= 1.0 - texelFetch(translucency, pixel, 0).a;
  }
  gl_FragData[0] = vec4(Sanitize(light, maximum), 1.0);
}
