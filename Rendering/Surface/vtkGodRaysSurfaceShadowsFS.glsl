// How much of a light reaches a place of a surface, by the light's shadow map. vtkGodRaysSurfaceShadows puts
// this into the mappers' shaders, once for each light that has a map, with the light's number for NUMBER and
// the number of the map's faces for FACES. Coordinates are the camera's, as VTK has them in vertexVC.

uniform sampler2D godraysMapNUMBER;       // window depths, faces side by side
uniform mat4 godraysToFaceNUMBER[FACES];  // to (texels of the face, window depth, 1) w
uniform vec4 godraysLightNUMBER;          // its place (w = 1), or the direction to it (w = 0)
uniform vec3 godraysTexelsNUMBER;         // of a face: how many; faces side by side; bias of one at distance 1

// Returns 1 where nothing hides the light, 0 where something does; between them within a texel of an edge.
// normal is the facet's and of length 1.
float GodRaysVisibilityNUMBER(vec3 place, vec3 normal)
{
  vec3 toLight = normalize(godraysLightNUMBER.xyz - godraysLightNUMBER.w * place);
  float cosine = dot(normal, toLight);
  if (cosine <= 0.0)
  {
    return 0.0; // the facet hides it; the map would tell by chance
  }
  int size = int(godraysTexelsNUMBER.x);
  int columns = int(godraysTexelsNUMBER.y);
  for (int face = 0; face < FACES; ++face)
  {
    vec4 scaled = godraysToFaceNUMBER[face] * vec4(place, 1.0);
    vec3 at = scaled.xyz / scaled.w;
    if (scaled.w <= 0.0 || any(lessThan(at.xy, vec2(0.0))) ||
      any(greaterThan(at.xy, vec2(float(size)))))
    {
      continue;
    }
    // Four texels have a plane's own depth up to 1.5 texels away from the place, times its slope.
    float slope = min(sqrt(max(1.0 - cosine * cosine, 0.0)) / cosine, 50.0);
    float bias = godraysTexelsNUMBER.z * (0.1 + 1.5 * slope);
    bias /= godraysLightNUMBER.w == 0.0 ? 1.0 : scaled.w;
    float depth = min(at.z - bias, 1.0); // where the map has nothing it has 1
    vec2 between = clamp(at.xy - 0.5, vec2(0.0), vec2(float(size - 1)));
    ivec2 low = ivec2(min(between, vec2(float(size - 2))));
    vec2 part = between - vec2(low);
    low += size * ivec2(face % columns, face / columns);
    vec4 depths = vec4(texelFetch(godraysMapNUMBER, low, 0).r,
      texelFetch(godraysMapNUMBER, low + ivec2(1, 0), 0).r,
      texelFetch(godraysMapNUMBER, low + ivec2(0, 1), 0).r,
      texelFetch(godraysMapNUMBER, low + ivec2(1, 1), 0).r);
    vec4 lit = step(vec4(depth), depths);
    vec2 rows = mix(lit.xz, lit.yw, part.x);
    return mix(rows.x, rows.y, part.y);
  }
  return 1.0; // beyond the map nothing casts a shadow
}
