//VTK::System::Dec
//VTK::Output::Dec

// The scene and its rays, joined; fragments that no ray reaches are left alone.

in vec2 texCoord;

//VTK::GodRays::Types
//VTK::GodRays::Functions

uniform sampler2D scene;
uniform sampler2D rays;
uniform ivec2 origin;     // of the viewport, whose size the scene and its rays have [pixels]
uniform float intensity;
uniform float sceneGain;
uniform bool linearLight; // whether rays are linear light, or shown values as the scene's colours
uniform bool screen;      // SCREEN rather than ADD
uniform bool hasBackdrop; // whether the scene is over black, and this is put under it later
uniform sampler2D backdrop;
uniform bool showRays;    // the rays alone, of whatever size

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
  vec3 light = intensity * (showRays ? texture(rays, texCoord) : texelFetch(rays, pixel, 0)).rgb;
  if (showRays)
  {
    gl_FragData[0] = vec4(linearLight ? EncodeDisplay(light) : light, 1.0);
    return;
  }
  if (!any(greaterThan(light, vec3(0.0))) && sceneGain == 1.0)
  {
    discard;
  }
  vec4 shownOver = texelFetch(scene, pixel, 0);
  vec3 under =
    hasBackdrop ? (1.0 - shownOver.a) * texelFetch(backdrop, pixel, 0).rgb : vec3(0.0);
  vec3 shown = shownOver.rgb + under;
  vec3 base = sceneGain * (linearLight ? DecodeDisplay(shown) : shown);
  vec3 sum = screen ? BlendScreen(base, light) : BlendAdd(base, light);
  gl_FragData[0] = vec4((linearLight ? EncodeDisplay(sum) : sum) - under, 1.0);
}
