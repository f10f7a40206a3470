//VTK::System::Dec
//VTK::Output::Dec

// The scene and its rays, joined; fragments that no ray reaches are left alone.

in vec2 texCoord;

//VTK::GodRays::Types
//VTK::GodRays::Functions

uniform sampler2D scene;
uniform sampler2D rays;
uniform float intensity;
uniform float sceneGain;
uniform sampler2D backdrop; // of a scene that is over black, put under it later
uniform vec3 tint;        // of rays of one channel
uniform float viewScale;  // fraction of the rays' size that is shown, if they are resized

//VTK::GodRays::Terms
// linearLight: whether rays are linear light, or shown values as the scene's colours
// screen: SCREEN rather than ADD
// showRays: the rays alone
// resized: they are not as large as the viewport
// oneChannel: the rays are one value a pixel, in red, times the tint
// hasBackdrop: whether there is a backdrop

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(rays, 0))); // as large as the scene
  vec4 ray = resized ? texture(rays, 0.5 + (texCoord - 0.5) * viewScale) : texelFetch(rays, pixel, 0);
  vec3 light = intensity * (oneChannel ? ray.r * tint : ray.rgb);
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
