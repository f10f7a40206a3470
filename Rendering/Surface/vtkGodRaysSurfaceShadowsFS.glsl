// How much of a light reaches a place of a surface, by a shadow map of the light. vtkGodRaysSurfaceShadows puts
// this into the mappers' shaders once for each map, with the map's name for NAME, the number of its faces for
// FACES, and whether it has layers for LAYERED. Coordinates are the camera's, as VTK has them in vertexVC.

uniform sampler2D godraysMapNAME;      // window depths, or layers of depth and what is dark beyond, one on another
uniform mat4 godraysToFaceNAME[FACES]; // to (texels of the face, window depth, 1) w
uniform vec4 godraysTexelsNAME;        // of a face: how many; faces side by side; layers; bias of one at distance 1

// Returns 1 where nothing hides the light, 0 where something does; between them within a texel of an edge, and
// behind what lets a part of the light through. slope is the tangent of the angle between normal and light.
vec3 GodRaysThroughNAME(vec3 place, float slope, bool isLamp)
{
  int size = int(godraysTexelsNAME.x);
  int columns = int(godraysTexelsNAME.y);
  for (int face = 0; face < FACES; ++face)
  {
    vec4 scaled = godraysToFaceNAME[face] * vec4(place, 1.0);
    vec3 at = scaled.xyz / scaled.w;
    if (scaled.w <= 0.0 || any(lessThan(at.xy, vec2(0.0))) ||
      any(greaterThan(at.xy, vec2(float(size)))))
    {
      continue;
    }
    // Four texels have a plane's own depth up to 1.5 texels away from the place, times its slope; depths near 1
    // are rounded, here and in the map.
    float bias = godraysTexelsNAME.w * (0.1 + 1.5 * slope) / (isLamp ? scaled.w : 1.0) + 5e-7;
    float depth = min(at.z - bias, 1.0); // where the map has nothing it has 1
    vec2 between = clamp(at.xy - 0.5, vec2(0.0), vec2(float(size - 1)));
    ivec2 low = ivec2(min(between, vec2(float(size - 2))));
    vec2 part = between - vec2(low);
    low += size * ivec2(face % columns, face / columns);
    if (LAYERED)
    {
      vec3 dark = vec3(0.0);
      int rows = (FACES > 1 ? 2 : 1) * size;
      for (int k = 0; k < 4 * int(godraysTexelsNAME.z); ++k)
      {
        ivec2 corner = ivec2(k & 1, k >> 1 & 1);
        vec4 layer = texelFetch(godraysMapNAME, low + corner + ivec2(0, (k >> 2) * rows), 0);
        vec2 weight = mix(1.0 - part, part, vec2(corner));
        dark += layer.x < depth ? weight.x * weight.y * layer.yzw : vec3(0.0);
      }
      return max(1.0 - dark, vec3(0.0));
    }
    vec4 lit = step(vec4(depth),
      vec4(texelFetch(godraysMapNAME, low, 0).r, texelFetch(godraysMapNAME, low + ivec2(1, 0), 0).r,
        texelFetch(godraysMapNAME, low + ivec2(0, 1), 0).r,
        texelFetch(godraysMapNAME, low + ivec2(1, 1), 0).r));
    vec2 rows = mix(lit.xz, lit.yw, part.x);
    return vec3(mix(rows.x, rows.y, part.y));
  }
  return vec3(1.0); // beyond the map nothing casts a shadow
}
