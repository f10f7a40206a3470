// How much of each light reaches a place of a surface, by the lights' shadow maps. vtkGodRaysSurfaceShadows
// puts this into the mappers' shaders, with the number of lights that cast shadows for LIGHTS, and 1 for
// DIMMED if a medium dims one, else 0. Light i has the maps 2 i, of what is opaque, and 2 i + 1, of what
// lets a part through. Coordinates are the camera's, as VTK has them in vertexVC. Kinds of lights and maps
// are constants where functions are called: what a light does without is not compiled, as a branch would
// cost as much as if it were taken.

//VTK::GodRays::Common
//VTK::GodRays::Colour

uniform float godraysMost;          // part of a light that shadows take; 0 while maps are drawn
uniform sampler2D godraysOpaque;    // window depths, of all lights
uniform sampler2D godraysLayers;    // of all lights, layers of depth and what is dark beyond, one on another
uniform vec4 godraysLight[LIGHTS];  // its place (w = 1), or the direction to it, of length 1 (w = 0)
// Of a map: to lengths across a sun's light, and window depth; or, from a lamp, along the axes of its cube
// or of its one face.
uniform mat4 godraysToMap[2 * LIGHTS];
// Of a map's nested faces, four of a sun: texels of a length, or of one at distance 1; the axis's texel.
uniform vec4 godraysFaces[8 * LIGHTS];
uniform vec4 godraysBlocks[2 * LIGHTS]; // corner in the texture; size of a face [texels]; number of layers
// Window depth is x - y/distance from a lamp; y of a sun is that of a length. What depths are rounded by,
// of a lamp at distance 1; the light's radius, or the tangent of a sun's.
uniform vec4 godraysDepths[2 * LIGHTS];

#if DIMMED
//VTK::GodRays::Visibility

uniform vec4 godraysAir[2];    // of each component: extinction of red, green and blue; scale height
uniform vec4 godraysVertical;  // at the eye, of length 1; the eye's height above where densities are 1
uniform float godraysPlanet;   // radius; 0: the ground is a plane

// Returns how much of a light the medium leaves on its way to a place.
vec3 GodRaysAir(vec3 place, vec4 light)
{
  vec3 toLight = light.xyz - light.w * place;
  float height = godraysVertical.w;
  vec2 start = MediumStart(godraysPlanet, height, godraysVertical.xyz, place, normalize(toLight));
  LitRay ray; // from the place
  ray.Infinite = light.w > 0.0 ? 0 : 1;
  ray.Foot = 0.0;
  ray.Distance = 0.0;
  ray.Height = start.x;
  ray.Slope = start.y;
  ray.LightHeight = start.y;
  if (light.w > 0.0)
  {
    ray.LightHeight =
      MediumStart(godraysPlanet, height, godraysVertical.xyz, light.xyz, godraysVertical.xyz).x;
  }
  ray.PlanetRadius = godraysPlanet;
  ray.AxisStart = 0.0;
  ray.AxisSlope = 0.0;
  ray.Shape = SpotShape(0.0, 0.0);
  ray.ThroughGround = 0;
  PhaseFunction none = PhaseFunction(0, 0.0);
  vec3 left;
  for (int c = 0; c < 3; ++c)
  {
    left[c] = LightTransmittance(
      MediumComponent(0.0, godraysAir[0][c], godraysAir[0].w, none, none, 0.0),
      MediumComponent(0.0, godraysAir[1][c], godraysAir[1].w, none, none, 0.0), ray,
      length(toLight));
  }
  return left;
}
#endif

// A soft shadow that is to be sampled: a place in a face [texels] and the face's low corner in the texture;
// the depth of the surface's plane there, less the bias, how much that is more for each texel, and the size
// of a face; the radius that a blocker shows for each unit of depth between [texels].
struct GodRaysDisc
{
  vec2 Texel;
  vec2 Corner;
  float Nearer; // -1 where there is nothing to sample
  vec2 Gradient;
  float Size;
  vec2 Soft;
};
GodRaysDisc godraysDiscs[LIGHTS];
float godraysSeen[LIGHTS]; // of their lights

// Returns how much of a light's disc is seen from a place, by the depths of what hides it: percentage-closer
// soft shadows [Fernando2005].
float GodRaysSeen(GodRaysDisc disc)
{
  // Turned from pixel to pixel: what samples miss is noise, not bands.
  float turn = 6.2831853 * InterleavedGradientNoise(gl_FragCoord.xy);
  // Blockers are searched in the cone from the place to the disc. It is searched more densely in its
  // middle, as what is close above the place is in a small part of it.
  vec2 widest = min(disc.Nearer * disc.Soft, vec2(0.06 * disc.Size));
  float sum = 0.0;
  float weights = 0.0;
  int open = 0;
  for (int i = 1; i <= 16; ++i)
  {
    float part = float(i) / 16.0;
    float angle = turn + 2.3999632 * float(i);
    vec2 offset = widest * part * part * vec2(cos(angle), sin(angle));
    ivec2 at = ivec2(clamp(disc.Texel + offset, vec2(0.0), vec2(disc.Size - 1.0)));
    float depth = texelFetch(godraysOpaque, ivec2(disc.Corner) + at, 0).r;
    vec2 way = vec2(at) + 0.5 - disc.Texel;
    float between = disc.Nearer + dot(disc.Gradient, way) - depth;
    open += between > 0.0 ? 0 : 1;
    bool blocks = between > 0.0 && length(max(abs(way) - 1.0, 0.0) / disc.Soft) <= disc.Nearer - depth;
    float weight = blocks ? part * part * part : 0.0; // of the area that a sample stands for
    sum += weight * depth;
    weights += weight;
  }
  // Only half shadows need the rest. No turns of a loop are less work than a branch where processors draw.
  int samples = weights > 0.0 && open > 0 ? 32 : 0;
  float between = disc.Nearer - sum / max(weights, 1e-30);
  vec2 radius = clamp(between * disc.Soft, vec2(0.7), vec2(0.06 * disc.Size));
  float seen = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    float angle = turn + 2.3999632 * float(i);
    vec2 offset = radius * sqrt((float(i) + 0.5) / 32.0) * vec2(cos(angle), sin(angle));
    ivec2 at = ivec2(clamp(disc.Texel + offset, vec2(0.0), vec2(disc.Size - 1.0)));
    float depth = min(disc.Nearer + dot(disc.Gradient, vec2(at) + 0.5 - disc.Texel), 1.0);
    seen += depth <= texelFetch(godraysOpaque, ivec2(disc.Corner) + at, 0).r ? 1.0 : 0.0;
  }
  return samples > 0 ? seen / 32.0 : weights > 0.0 ? 0.0 : 1.0;
}

// Samples the first soft shadows. All lights share its loops: LLVM takes half a minute for 16 loops in a
// row.
void GodRaysSample(int count)
{
  for (int i = 0; i < count; ++i)
  {
    godraysSeen[i] = godraysDiscs[i].Nearer < 0.0 ? 1.0 : GodRaysSeen(godraysDiscs[i]);
  }
}

// Returns how far to go from a place along its facet's normal, where the light grazes it: a bias of depth
// would let light through along edges, in closed rooms, too. Texels count as far as 2/3 of one away.
const float godraysSteep = 4.0; // slope from which on
vec3 GodRaysLift(vec3 facet, float facing, vec2 scale)
{
  float grazing = max(length(facet.xy) - godraysSteep * facing, 0.0);
  return 0.75 / min(scale.x, scale.y) * grazing * facet;
}

// Returns 1 where nothing hides the light, 0 where something does; between them within a third of a texel of
// an edge, and behind what lets a part of the light through. The normal is the facet's, of length 1; toLight
// is the way to a lamp, or a direction of length 1. The facet faces the light. A soft shadow is left to
// sample, if disc is the number of one.
vec3 GodRaysThrough(int map, int faces, bool isLamp, int disc, vec3 place, vec3 normal, vec3 toLight)
{
  vec4 block = godraysBlocks[map];
  vec4 depths = godraysDepths[map];
  float size = block.z;
  vec2 corner = block.xy;
  vec3 at = (godraysToMap[map] * vec4(isLamp ? -toLight : place, 1.0)).xyz;
  vec3 facet = mat3(godraysToMap[map]) * normal;
  float facing = dot(normal, toLight);
  float unit = depths.y; // window depth of a length across the light, or of one at distance 1
  float rounding = 5e-7;
  bool isIn = true;
  bool isHard = disc < 0 && map % 2 == 0;
  vec2 scale = godraysFaces[4 * map].xy;
  if (isLamp)
  {
    if (faces > 1)
    {
      // The face whose axis is nearest; see vtkGodRaysShadowFaces for how they lie.
      vec3 along = abs(at);
      bool isX = along.x >= along.y && along.x >= along.z;
      bool isY = !isX && along.y >= along.z;
      at = isX ? at.zyx : isY ? at.xzy : at.yxz;
      facet = isX ? facet.zyx : isY ? facet.xzy : facet.yxz;
      int face = (isX ? 0 : isY ? 2 : 4) + (at.z < 0.0 ? 1 : 0);
      float side = at.z < 0.0 ? -1.0 : 1.0;
      at.xz *= side;
      facet.x *= side;
      corner += size * vec2(face % 3, face / 3);
    }
    isIn = at.z > 0.0;
    float nearness = 1.0 / at.z;
    if (isHard)
    {
      at += GodRaysLift(facet, facing * nearness, scale * nearness);
      nearness = 1.0 / at.z;
    }
    at = vec3(at.xy * nearness, depths.x - depths.y * nearness);
    facing *= nearness;
    unit *= nearness;
    rounding += depths.z * nearness;
  }
  vec2 texel = at.xy * scale + godraysFaces[4 * map].zw;
  isIn = isIn && texel == clamp(texel, vec2(0.0), vec2(size));
  for (int k = 1; k < faces && !isLamp; ++k) // nested ones: the finest that has the place
  {
    vec4 finer = godraysFaces[4 * map + k];
    vec2 there = at.xy * finer.xy + finer.zw;
    if (there == clamp(there, vec2(0.0), vec2(size)))
    {
      isIn = true;
      texel = there;
      scale = finer.xy;
      corner = block.xy + size * vec2(k % 2, k / 2);
    }
  }
  if (!isIn)
  {
    return vec3(1.0); // beyond the map nothing casts a shadow
  }
  if (isHard && !isLamp)
  {
    vec3 lift = GodRaysLift(facet, facing, scale);
    texel += lift.xy * scale;
    at.z += lift.z;
  }
  // Window depths are affine in places of the map on each plane. What they change by as far as 1.5 texels, by
  // which texels are away from the place, is in the bias, or as far as 1 where only nearer ones count; so are
  // 0.2 texels along the light, and what depths are rounded by, here and in the map. A larger slope would
  // let light through along edges.
  vec2 slope = facet.xy / facing;
  unit /= min(scale.x, scale.y);
  float most = isHard ? godraysSteep : isLamp ? 50.0 : 20.0;
  float nearer = at.z - unit * (0.2 + (isHard ? 1.0 : 1.5) * min(length(slope), most)) - rounding;
  if (disc >= 0)
  {
    vec2 gradient = unit * min(scale.x, scale.y) / scale * slope;
    gradient *= min(1.0, 50.0 * unit / max(length(gradient), 1e-30)); // of a plane along the light
    godraysDiscs[disc] = GodRaysDisc(
      texel, corner, max(nearer, 0.0), gradient, size, depths.w / depths.y * scale);
    return vec3(1.0);
  }
  nearer = min(nearer, 1.0); // where the map has nothing it has 1
  vec2 between = clamp(texel - 0.5, vec2(0.0), vec2(size - 1.0));
  ivec2 low = ivec2(min(between, vec2(size - 2.0)));
  vec2 part = between - vec2(low);
  low += ivec2(corner);
  if (map % 2 == 1)
  {
    vec3 dark = vec3(0.0);
    int rows = (faces > 1 ? 2 : 1) * int(size);
    for (int k = 0; k < 4 * int(block.w); ++k)
    {
      ivec2 side = ivec2(k & 1, k >> 1 & 1);
      vec4 layer = texelFetch(godraysLayers, low + side + ivec2(0, (k >> 2) * rows), 0);
      vec2 weight = mix(1.0 - part, part, vec2(side));
      dark += layer.x < nearer ? weight.x * weight.y * layer.yzw : vec3(0.0);
    }
    return max(1.0 - dark, vec3(0.0));
  }
  vec4 lit = step(vec4(nearer),
    vec4(texelFetch(godraysOpaque, low, 0).r, texelFetch(godraysOpaque, low + ivec2(1, 0), 0).r,
      texelFetch(godraysOpaque, low + ivec2(0, 1), 0).r,
      texelFetch(godraysOpaque, low + ivec2(1, 1), 0).r));
  // An edge that is a third of a texel wide is nearer to that of a point's light.
  vec2 rows = mix(lit.xz, lit.yw, part.x);
  return vec3(clamp(3.0 * mix(rows.x, rows.y, part.y) - 1.0, 0.0, 1.0));
}

// Returns which part of a light shadows and the medium leave. The numbers of faces are those of its two
// maps, 0 for none; disc is the number of its soft shadow, -1 for a hard one. What is not opaque leaves
// linear light: shading in display values takes it encoded. A facet that is turned away hides the light;
// the map would tell by chance.
vec3 GodRaysLeft(int light, int faces, int layerFaces, int disc, bool isLamp, bool isDimmed, bool isLinear,
  vec3 place, vec3 normal)
{
  if (disc >= 0)
  {
    godraysDiscs[disc].Nearer = -1.0;
  }
  if (godraysMost <= 0.0)
  {
    return vec3(1.0);
  }
  vec3 toLight = godraysLight[light].xyz - godraysLight[light].w * place;
  vec3 through = vec3(0.0);
  if (dot(normal, toLight) > 0.0)
  {
    through = vec3(1.0);
#if DIMMED
    if (isDimmed)
    {
      through = GodRaysAir(place, godraysLight[light]);
    }
#endif
    if (layerFaces > 0)
    {
      through *= GodRaysThrough(2 * light + 1, layerFaces, isLamp, -1, place, normal, toLight);
    }
    if ((isDimmed || layerFaces > 0) && !isLinear)
    {
      through = EncodeDisplay(through);
    }
    if (faces > 0)
    {
      through *= GodRaysThrough(2 * light, faces, isLamp, disc, place, normal, toLight);
    }
  }
  return through;
}

// Returns the facet's normal, towards the eye. Called before fragments are discarded.
vec3 GodRaysFacet(vec3 place, bool isParallel)
{
  vec3 facet = cross(dFdx(place), dFdy(place));
  facet = dot(facet, facet) > 0.0 ? normalize(facet) : vec3(0.0, 0.0, 1.0);
  return dot(facet, isParallel ? vec3(0.0, 0.0, 1.0) : -place) < 0.0 ? -facet : facet;
}
