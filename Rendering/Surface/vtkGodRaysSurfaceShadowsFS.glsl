// How much of a light reaches a place of a surface, by a shadow map of the light. vtkGodRaysSurfaceShadows puts
// this into the mappers' shaders once for each map, with the map's name for NAME, the number of its faces for
// FACES, and whether it has layers for LAYERED and is of a light that is no point for SOFT. Coordinates are the camera's, as VTK has them in vertexVC.

uniform sampler2D godraysMapNAME;      // window depths, or layers of depth and what is dark beyond, one on another
uniform mat4 godraysToFaceNAME[FACES]; // to (texels of the face, window depth, 1) w
uniform vec4 godraysTexelsNAME;        // of a face: how many; faces side by side; layers; bias of one at distance 1

uniform mat4 godraysToPlaneNAME[FACES]; // planes to what is 0 at (texels, window depth, 1) of theirs
uniform float godraysSoftNAME; // radius of the light as a blocker shows it, for each unit of depth between [texels]

// Returns how much of a light's disc is seen from a place, by the depths of what hides it: percentage-closer
// soft shadows [Fernando2005]. texel is a place in a face whose low corner is in the map; nearer is the depth of
// the surface's plane there, less the bias, and gradient how much that is more for each texel.
float GodRaysDiscNAME(vec2 texel, ivec2 corner, float size, float nearer, vec2 gradient)
{
  // Turned from pixel to pixel, by InterleavedGradientNoise(), whose macros would get into users' shaders: what
  // samples miss is noise, not bands.
  float turn =
    6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  // Blockers are searched in the cone from the place to the disc. It is searched more densely in its middle, as
  // what is close above the place is in a small part of it.
  float widest = min(nearer * godraysSoftNAME, 0.06 * size);
  float sum = 0.0;
  float weights = 0.0;
  int open = 0;
  for (int i = 1; i <= 16; ++i)
  {
    float part = float(i) / 16.0;
    float angle = turn + 2.3999632 * float(i);
    vec2 offset = widest * part * part * vec2(cos(angle), sin(angle));
    ivec2 at = ivec2(clamp(texel + offset, vec2(0.0), vec2(size - 1.0)));
    float depth = texelFetch(godraysMapNAME, corner + at, 0).r;
    vec2 way = vec2(at) + 0.5 - texel;
    float between = nearer + dot(gradient, way) - depth;
    open += between > 0.0 ? 0 : 1;
    bool blocks = between > 0.0 && length(way) <= (nearer - depth) * godraysSoftNAME + 1.0;
    float weight = blocks ? part * part * part : 0.0; // of the area that a sample stands for
    sum += weight * depth;
    weights += weight;
  }
  // Only half shadows need the rest. No more turns of a loop are less work than a branch where processors draw.
  int samples = weights > 0.0 && open > 0 ? 32 : 0;
  float radius = clamp((nearer - sum / max(weights, 1e-30)) * godraysSoftNAME, 0.7, 0.06 * size);
  float seen = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    float angle = turn + 2.3999632 * float(i);
    vec2 offset = radius * sqrt((float(i) + 0.5) / 32.0) * vec2(cos(angle), sin(angle));
    ivec2 at = ivec2(clamp(texel + offset, vec2(0.0), vec2(size - 1.0)));
    float depth = min(nearer + dot(gradient, vec2(at) + 0.5 - texel), 1.0);
    seen += depth <= texelFetch(godraysMapNAME, corner + at, 0).r ? 1.0 : 0.0;
  }
  return samples > 0 ? seen / 32.0 : weights > 0.0 ? 0.0 : 1.0;
}

// Returns 1 where nothing hides the light, 0 where something does; between them within a texel of an edge, and
// behind what lets a part of the light through. slope is the tangent of the angle between normal and light.
vec3 GodRaysThroughNAME(vec3 place, vec3 normal, float slope, bool isLamp)
{
  int size = int(godraysTexelsNAME.x);
  int columns = int(godraysTexelsNAME.y);
  int face = 0; // of a cube, the one whose axis is nearest
  float ahead = 0.0;
  for (int k = 0; k < FACES && FACES > 1; ++k)
  {
    mat4 to = godraysToFaceNAME[k];
    float along = dot(vec4(to[0].w, to[1].w, to[2].w, to[3].w), vec4(place, 1.0));
    face = along > ahead ? k : face;
    ahead = max(ahead, along);
  }
  vec4 scaled = godraysToFaceNAME[face] * vec4(place, 1.0);
  vec3 at = scaled.xyz / scaled.w;
  float end = float(size) + (FACES > 1 ? 1.0 : 0.0); // edges of a cube's faces are rounded
  if (scaled.w <= 0.0 || any(lessThan(at.xy, vec2(float(size) - end))) ||
    any(greaterThan(at.xy, vec2(end))))
  {
    return vec3(1.0); // beyond the map nothing casts a shadow
  }
  // Four texels have a plane's own depth up to 1.5 texels away from the place, times its slope; depths near 1
  // are rounded, here and in the map.
  float unit = godraysTexelsNAME.w / (isLamp ? scaled.w : 1.0);
  float bias = unit * (0.1 + 1.5 * slope) + 5e-7;
  float depth = min(at.z - bias, 1.0); // where the map has nothing it has 1
  vec2 between = clamp(at.xy - 0.5, vec2(0.0), vec2(float(size - 1)));
  ivec2 low = ivec2(min(between, vec2(float(size - 2))));
  vec2 part = between - vec2(low);
  ivec2 corner = size * ivec2(face % columns, face / columns);
  low += corner;
  if (SOFT)
  {
    vec4 plane = godraysToPlaneNAME[face] * vec4(normal, -dot(normal, place));
    vec2 gradient = -plane.xy / (abs(plane.z) > 0.0 ? plane.z : 1e30);
    gradient *= min(1.0, 50.0 * unit / max(length(gradient), 1e-30)); // of a plane along the light
    return vec3(GodRaysDiscNAME(at.xy, corner, float(size), at.z - bias, gradient));
  }
  if (LAYERED)
  {
    vec3 dark = vec3(0.0);
    int rows = (FACES > 1 ? 2 : 1) * size;
    for (int k = 0; k < 4 * int(godraysTexelsNAME.z); ++k)
    {
      ivec2 side = ivec2(k & 1, k >> 1 & 1);
      vec4 layer = texelFetch(godraysMapNAME, low + side + ivec2(0, (k >> 2) * rows), 0);
      vec2 weight = mix(1.0 - part, part, vec2(side));
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
