//VTK::System::Dec
//VTK::Output::Dec

// Airlight less what the depths between a pixel and the light hide of its view ray.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Radial

//VTK::GodRays::Terms
// parallel: whether view rays are
// infinite: whether the light is infinitely far
// uniformly: whether it is and the medium is homogeneous
// grey: whether the medium has one colour

//VTK::GodRays::MediumRays

uniform sampler2D occluders; // view depths of what blocks light, of the layer's size
uniform sampler2D ends;     // and of where view rays end
uniform float openSky;      // the depth where nothing is
uniform int numberOfTaps;
uniform float thickness;    // of a surface [fraction of its depth]

// Neighbours that differ by less are one surface.
const float jump = 0.1; // [fraction of the nearer depth]

// The march to the light in the layer, whole or as far as any picture reaches; m is how far a
// point of it is, see HiddenDepth() in vtkGodRaysMediumMath.glsl.
vec2 GetMarch(vec2 place, vec4 towards, out float reach)
{
  vec2 xy = GetRayPlace(place);
  vec2 march = (towards.xy - (parallel ? towards.w : towards.z) * xy) / (pixelSize * layerSize);
  float ratio = parallel ? towards.w : towards.z;
  reach = 1.5 / max(max(length(march), 1.5 * ratio), 1e-6);
  return reach * march;
}

void main()
{
  vec2 place = GetPlace();
  LitRay ray = GetLitRay(place);
  float perDepth = GetLengthPerDepth(place);
  float end = GetEnd(ray, texelFetch(ends, ivec2(place), 0).r, perDepth) / perDepth;
  vec2 lit = SpotPart(ray, end * perDepth) / perDepth;
  vec3 strength = uniformly ? GetStrength(ray) : vec3(0.0);

  vec4 towards = light / max(length(light.xyz), 1e-6); // in scene units the march could overflow
  float reach;
  vec2 march = GetMarch(place, towards, reach);
  vec2 uv = place / layerSize;
  vec2 part = ClipMarch(uv, march, vec2(0.0));
  float tap = max(part.y - part.x, 0.0) / float(numberOfTaps);

  // Hidden intervals of neighbours are joined: begin and end of the one that grows.
  vec3 hidden = vec3(0.0);
  vec2 grown = vec2(0.0);
  float before = openSky;
  for (int i = 0; i <= numberOfTaps; ++i)
  {
    vec2 next = vec2(0.0);
    bool solid = false;
    bool joined = false;
    if (i < numberOfTaps)
    {
      float t = part.x + (float(i) + 0.5) * tap;
      float z = texelFetch(occluders, ivec2((uv + t * march) * layerSize), 0).r;
      solid = z < openSky;
      if (solid)
      {
        float back = z * (1.0 + thickness);
        float m = reach * (t - 0.5 * tap);
        float n = reach * (t + 0.5 * tap);
        vec2 front = vec2(HiddenDepth(parallel, towards.z, towards.w, z, m),
          HiddenDepth(parallel, towards.z, towards.w, z, n));
        vec2 rear = vec2(HiddenDepth(parallel, towards.z, towards.w, back, m),
          HiddenDepth(parallel, towards.z, towards.w, back, n));
        next = clamp(vec2(min(front.x, front.y), max(rear.x, rear.y)), 0.0, end);
      }
      joined = solid && grown.y > grown.x &&
        (abs(z - before) < jump * min(z, before) || (next.x <= grown.y && next.y >= grown.x));
      before = z;
    }
    if (joined)
    {
      grown = vec2(min(grown.x, next.x), max(grown.y, next.y));
    }
    else if (solid || i == numberOfTaps)
    {
      grown = clamp(grown, lit.x, lit.y);
      if (grown.y > grown.x)
      {
        for (int c = 0; c < channels; ++c)
        {
          hidden[c] += GetAirlight(c, ray, strength[c], perDepth * grown.x, perDepth * grown.y);
        }
      }
      grown = next;
    }
  }

  vec3 airlight = vec3(0.0);
  for (int c = 0; c < channels; ++c)
  {
    airlight[c] = max(GetTotalAirlight(c, ray, strength[c], perDepth * end) - hidden[c], 0.0);
  }
  gl_FragData[0] = GetRadiance(airlight);
}
