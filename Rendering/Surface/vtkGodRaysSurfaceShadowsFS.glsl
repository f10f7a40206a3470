// How much of a light reaches a place of a surface, by a shadow map of the light.
// vtkGodRaysSurfaceShadows puts this into the mappers' shaders once for each map, with the map's name
// for NAME, the number of its faces for FACES, and true or false for whether it has layers, LAYERED, is
// that of a lamp, LAMP, and of a light that is no point, SOFT. Coordinates are the camera's, as VTK has
// them in vertexVC.

//VTK::GodRays::Common

uniform sampler2D godraysMapNAME; // window depths, or layers of depth and what is dark beyond, one on another
uniform mat4 godraysToFaceNAME[FACES]; // to (texels of the face, window depth, 1) w; 0 for a face that is not
uniform mat4 godraysToPlaneNAME[FACES]; // planes to what is 0 at (texels, window depth, 1) of theirs
// of a face: how many; faces side by side; layers; rounding of a lamp's depths at distance 1
uniform vec4 godraysTexelsNAME;
// window depth of a length, or of a texel of a lamp at distance 1; radius of the light as a blocker shows it,
// for each unit of depth between [lengths or texels]
uniform vec3 godraysUnitNAME;
                                // or texels]

// Returns how much of a light's disc is seen from a place, by the depths of what hides it: percentage-
// closer soft shadows [Fernando2005]. texel is a place in a face whose low corner is in the map; nearer
// is the depth of the surface's plane there, less the bias, and gradient how much that is more for each
// texel. soft is the radius that a blocker shows for each unit of depth between [texels].
float GodRaysDiscNAME(
  vec2 texel, ivec2 corner, float size, float nearer, vec2 gradient, vec2 soft)
{
  // Turned from pixel to pixel: what samples miss is noise, not bands.
  float turn = 6.2831853 * InterleavedGradientNoise(gl_FragCoord.xy);
  // Blockers are searched in the cone from the place to the disc. It is searched more densely in its
  // middle, as what is close above the place is in a small part of it.
  vec2 widest = min(nearer * soft, vec2(0.06 * size));
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
    bool blocks = between > 0.0 && length(max(abs(way) - 1.0, 0.0) / soft) <= nearer - depth;
    float weight = blocks ? part * part * part : 0.0; // of the area that a sample stands for
    sum += weight * depth;
    weights += weight;
  }
  // Only half shadows need the rest. No turns of a loop are less work than a branch where processors
  // draw.
  int samples = weights > 0.0 && open > 0 ? 32 : 0;
  vec2 radius =
    clamp((nearer - sum / max(weights, 1e-30)) * soft, vec2(0.7), vec2(0.06 * size));
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

// Returns whether a place is in a face, and where: texels and window depth.
bool GodRaysIsInNAME(mat4 toFace, vec3 place, float size, out vec3 at)
{
  vec4 scaled = toFace * vec4(place, 1.0);
  at = scaled.xyz / scaled.w;
  float edge = LAMP && FACES > 1 ? 1.0 : 0.0; // edges of a cube's faces are rounded
  return scaled.w > 0.0 && all(greaterThanEqual(at.xy, vec2(-edge))) &&
    all(lessThanEqual(at.xy, vec2(size + edge)));
}

// Returns 1 where nothing hides the light, 0 where something does; between them within a texel of an
// edge, and behind what lets a part of the light through. The normal is the facet's, of length 1;
// toLight is the way to a lamp, or a direction of length 1. The facet faces the light.
vec3 GodRaysThroughNAME(vec3 place, vec3 normal, vec3 toLight)
{
  float size = godraysTexelsNAME.x;
  // of nested faces the finest that has the place, of a cube's the one whose axis is nearest
  int face = FACES - 1;
  if (LAMP)
  {
    float ahead = 0.0;
    for (int k = 0; k < FACES && FACES > 1; ++k)
    {
      mat4 to = godraysToFaceNAME[k];
      float along = dot(vec4(to[0].w, to[1].w, to[2].w, to[3].w), vec4(place, 1.0));
      face = along > ahead ? k : face;
      ahead = max(ahead, along);
    }
  }
  vec3 at;
  bool isIn = GodRaysIsInNAME(godraysToFaceNAME[face], place, size, at);
  for (int k = FACES - 2; k >= 0 && !LAMP && !isIn; --k)
  {
    face = k;
    isIn = GodRaysIsInNAME(godraysToFaceNAME[k], place, size, at);
  }
  if (!isIn)
  {
    return vec3(1.0); // beyond the map nothing casts a shadow
  }
  // Window depths are affine in places of the map on each plane. What they change by as far as 1.5 texels,
  // by which the four texels are away from the place, is in the bias; so are 0.2 texels along the light, and
  // what depths are rounded by, here and in the map. A slope above 20 would let light through along edges.
  mat4 toFace = godraysToFaceNAME[face];
  vec2 texels = vec2(1.0); // for each unit of length
  vec3 axis = toLight;
  float unit = godraysUnitNAME.x;
  float rounding = 5e-7;
  float facing = dot(normal, toLight);
  if (LAMP)
  {
    axis = vec3(toFace[0].w, toFace[1].w, toFace[2].w);
    float ahead = dot(vec4(axis, toFace[3].w), vec4(place, 1.0));
    facing /= ahead;
    unit /= ahead;
    rounding += godraysTexelsNAME.w / ahead;
  }
  else
  {
    texels = vec2(length(vec3(toFace[0].x, toFace[1].x, toFace[2].x)),
      length(vec3(toFace[0].y, toFace[1].y, toFace[2].y)));
    unit /= min(texels.x, texels.y);
  }
  float along = dot(normal, axis);
  float slope = min(sqrt(max(1.0 - along * along, 0.0)) / facing, LAMP ? 50.0 : 20.0);
  float nearer = at.z - unit * (0.2 + 1.5 * slope) - rounding;
  ivec2 corner =
    int(size) * ivec2(face % int(godraysTexelsNAME.y), face / int(godraysTexelsNAME.y));
  if (SOFT)
  {
    vec4 plane = godraysToPlaneNAME[face] * vec4(normal, -dot(normal, place));
    vec2 gradient = -plane.xy / (abs(plane.z) > 0.0 ? plane.z : 1e30);
    gradient *= min(1.0, 50.0 * unit / max(length(gradient), 1e-30)); // of a plane along the light
    return vec3(
      GodRaysDiscNAME(at.xy, corner, size, nearer, gradient, godraysUnitNAME.yz * texels));
  }
  nearer = min(nearer, 1.0); // where the map has nothing it has 1
  vec2 between = clamp(at.xy - 0.5, vec2(0.0), vec2(size - 1.0));
  ivec2 low = ivec2(min(between, vec2(size - 2.0)));
  vec2 part = between - vec2(low);
  low += corner;
  if (LAYERED)
  {
    vec3 dark = vec3(0.0);
    int rows = (FACES > 1 ? 2 : 1) * int(size);
    for (int k = 0; k < 4 * int(godraysTexelsNAME.z); ++k)
    {
      ivec2 side = ivec2(k & 1, k >> 1 & 1);
      vec4 layer = texelFetch(godraysMapNAME, low + side + ivec2(0, (k >> 2) * rows), 0);
      vec2 weight = mix(1.0 - part, part, vec2(side));
      dark += layer.x < nearer ? weight.x * weight.y * layer.yzw : vec3(0.0);
    }
    return max(1.0 - dark, vec3(0.0));
  }
  vec4 lit = step(vec4(nearer),
    vec4(texelFetch(godraysMapNAME, low, 0).r, texelFetch(godraysMapNAME, low + ivec2(1, 0), 0).r,
      texelFetch(godraysMapNAME, low + ivec2(0, 1), 0).r,
      texelFetch(godraysMapNAME, low + ivec2(1, 1), 0).r));
  vec2 rows = mix(lit.xz, lit.yw, part.x);
  return vec3(mix(rows.x, rows.y, part.y));
}
