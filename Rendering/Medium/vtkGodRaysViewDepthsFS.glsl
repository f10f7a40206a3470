//VTK::System::Dec
//VTK::Output::Dec

// View depths from window depths.

in vec2 texCoord;

uniform sampler2D occluders; // of the layer
uniform sampler2D seen;     // of the picture in its middle
uniform float viewScale;    // fraction of the layer's size that the picture covers
uniform vec4 depthTerms;    // see vtkGodRaysView::Pinhole
uniform float openSky;

//VTK::GodRays::Common
//VTK::GodRays::Terms
// fromPicture: whether the picture has depths of its own

void main()
{
  float depth = texelFetch(occluders, ivec2(texCoord * vec2(textureSize(occluders, 0))), 0).r;
  if (fromPicture)
  {
    vec2 place = 0.5 + (texCoord - 0.5) / viewScale;
    if (all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, vec2(1.0))))
    {
      depth = texelFetch(seen, ivec2(place * vec2(textureSize(seen, 0))), 0).r;
    }
  }
  float rest = 1.0 - depth;
  float view = ViewDepth(depthTerms, rest);
  gl_FragData[0] = vec4(depth < 1.0 && view > 0.0 ? min(view, openSky) : openSky);
}
