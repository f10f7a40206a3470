//VTK::System::Dec
//VTK::Output::Dec

// The airlight of the parts of a view ray that its walk through the light's shadow map finds lit.

//VTK::GodRays::Terms
// parallel: whether view rays are
// infinite: whether the light is infinitely far
// grey: whether the medium has one colour
// closed: whether airlight has a closed form
// shadowed: whether there is a map

//VTK::GodRays::Medium
//VTK::GodRays::Walk
//VTK::GodRays::ShadowMapTexels

// View coordinates are x to the right, y up, z forwards.
uniform vec2 pictureSize; // [pixels]
uniform vec2 layerSize;   // with the margin about it [pixels]
uniform float viewScale;  // fraction of the layer that the picture covers
uniform vec2 viewCenter;  // of the view axis [pixels of the layer]
uniform float pixelSize;  // at depth 1, or of a parallel projection
uniform float farLimit;   // where the medium ends [view depth]
uniform vec4 light;       // (x, y, z)/w, or with w = 0 the direction to it
uniform vec3 lightColor;  // irradiance or intensity
uniform float lightHeight; // of a point light
uniform vec3 spotAxis;    // of a spotlight
uniform SpotShape spotShape;
uniform vec3 mediumUp;
uniform float eyeHeight;
uniform float planetRadius; // 0: the ground is a plane
uniform vec4 components[12]; // of each channel two, of two each: see GetComponent()
uniform float maximum;    // that the result can hold
uniform sampler2D ends;    // view depths of where view rays end
uniform int numberOfFaces; // of the map
uniform mat4 toMap[6];     // view coordinates to (texels, texels, height, 1) w of a face
uniform float nearest;     // half the least distance from a point light that its faces have

// By how much a shadowed stretch is longer than the map says, of the distance from the eye: depths of single
// precision may end a ray shortly behind a surface that the map has, too.
const float margin = 1e-5;

const int channels = grey ? 1 : 3;

struct Part // of a ray that a face has
{
  float Begin;
  float End;
};

// Into which a whole ray is divided whose airlight has no closed form.
const float steps = 32.0;

LitRay ray;
vec3 strength = vec3(0.0); // what is scattered of a directional light, if airlight is closed
vec2 lit = vec2(0.0);      // from where to where light can come
vec3 airlight = vec3(0.0); // of the stretches so far
vec2 stretch = vec2(0.0);  // from where to where light came last, where it is to be added
float litFrom = 0.0;       // where the walk is, if it is
bool dark = false;         // if not

void SetRay(vec3 origin, vec3 direction)
{
  vec3 to = infinite ? light.xyz : light.xyz - origin;
  ray.Infinite = infinite ? 1 : 0;
  ray.Foot = dot(to, direction);
  ray.Distance = infinite ? 0.0 : length(cross(to, direction));
  vec2 start = MediumStart(planetRadius, eyeHeight, mediumUp, origin, direction);
  ray.Height = start.x;
  ray.Slope = start.y;
  ray.LightHeight = infinite
    ? MediumStart(planetRadius, eyeHeight, mediumUp, origin, light.xyz).y
    : lightHeight;
  ray.PlanetRadius = planetRadius;
  ray.AxisStart = -dot(spotAxis, to);
  ray.AxisSlope = dot(spotAxis, direction);
  ray.Shape = spotShape;
  ray.ThroughGround = 0;
}

MediumComponent GetComponent(int number)
{
  vec4 amounts = components[2 * number];
  vec4 phases = components[2 * number + 1];
  return MediumComponent(amounts.x, amounts.y, amounts.z, PhaseFunction(int(phases.x), phases.y),
    PhaseFunction(int(phases.z), phases.w), amounts.w);
}

// Adds the airlight of the last stretch, if one has ended that has no closed form.
void AddStretch()
{
  float begin = stretch.x;
  float end = min(stretch.y, lit.y);
  stretch = vec2(0.0);
  float fraction =
    MediumFraction(ray, lit.x, lit.y, end) - MediumFraction(ray, lit.x, lit.y, begin);
  float parts = begin < end ? ceil(steps * fraction) : 0.0;
  float last = begin;
  for (float part = 1.0; part <= parts; ++part)
  {
    float next = MediumPlace(ray, begin, end, part / parts);
    for (int c = 0; c < channels; ++c)
    {
      airlight[c] +=
        MediumAirlight(GetComponent(2 * c), GetComponent(2 * c + 1), ray, last, next);
    }
    last = next;
  }
}

// Notes that from a place on there is light, or none.
void Turn(float place, bool isDark)
{
  if (isDark != dark)
  {
    for (int c = 0; closed && isDark && c < channels; ++c)
    {
      float extinction = components[4 * c].y + components[4 * c + 2].y;
      airlight[c] +=
        strength[c] * DirectionalAirlight(extinction, min(litFrom, place), place, 0.0, 0.0);
    }
    stretch = isDark && !closed ? vec2(litFrom, place) : stretch;
    litFrom = place * (1.0 + margin);
    dark = isDark;
  }
}

// Keeps what is at least 0 of an affine function of the distance along the ray.
void Clip(inout Part part, float start, float change)
{
  float zero = -start / (change == 0.0 ? 1e-30 : change);
  if (change > 0.0)
  {
    part.Begin = max(part.Begin, zero);
  }
  else if (change < 0.0 || start < 0.0)
  {
    part.End = change < 0.0 ? min(part.End, zero) : part.Begin;
  }
}

// Finds the part of a ray that is within a face; start and change are in its coordinates.
Part GetPart(vec4 start, vec4 change)
{
  Part part = Part(lit.x, lit.y);
  if (!infinite)
  {
    Clip(part, start.w - nearest, change.w);
  }
  float size = float(mapSize);
  for (int k = 0; k < 2; ++k)
  {
    Clip(part, start[k], change[k]);
    Clip(part, size * start.w - start[k], size * change.w - change[k]);
  }
  part.End = max(part.End, part.Begin);
  return part;
}

void WalkFace(int face, vec4 start, vec4 change, Part part)
{
  vec4 a = start + part.Begin * change;
  vec4 b = start + part.End * change;
  vec3 from = a.xyz / a.w;
  vec3 to = b.xyz / b.w;
  ivec2 corner = GetCorner(face, 0);
  MapWalk walk = BeginWalk(from.x, from.y, to.x, to.y, mapSize, mapSize, mapTop);
  // Pixels that are drawn together wait for each other: each goes on until a stretch has ended, and then all
  // add their stretches at once. Each turn goes down a level or on by a cell: the bound is never reached, but
  // NaN could.
  int guard = 32 * mapSize + 64;
  while (guard > 0)
  {
    for (; guard > 0 && stretch.y <= 0.0; --guard)
    {
      FindEnd(walk);
      vec2 heights = from.z + vec2(walk.Begin, walk.End) * (to.z - from.z);
      // Distances of the places where the cell, and perhaps a shadow within it, begin.
      vec2 s = vec2(walk.Begin);
      bool darkAtFirst;
      bool changes = false;
      if (walk.Level > 0)
      {
        vec2 node = GetNode(face, walk.Level, ivec2(walk.X, walk.Y) >> walk.Level);
        bool above = min(heights.x, heights.y) >= node.y;
        if (!above && max(heights.x, heights.y) >= node.x)
        {
          --walk.Level;
          continue;
        }
        darkAtFirst = !above;
      }
      else
      {
        ivec2 texel = ivec2(walk.X, walk.Y);
        float height = GetHeight(corner, texel);
        vec2 slopes = height > nothing ? GetSlopes(corner, texel, height) : vec2(0.0);
        vec2 x = walk.StartX + vec2(walk.Begin, walk.End) * walk.SlopeX - (float(walk.X) + 0.5);
        vec2 y = walk.StartY + vec2(walk.Begin, walk.End) * walk.SlopeY - (float(walk.Y) + 0.5);
        vec2 above = heights - (height + slopes.x * x + slopes.y * y);
        darkAtFirst = above.x < 0.0;
        changes = darkAtFirst != (above.y < 0.0);
        s.y = mix(walk.Begin, walk.End, changes ? above.x / (above.x - above.y) : 0.0);
      }
      vec2 ends = vec2(b.w * (1.0 - s.x), a.w * s.x);
      vec2 crossing = vec2(b.w * (1.0 - s.y), a.w * s.y);
      vec2 at = vec2(dot(ends, vec2(part.Begin, part.End)) / (ends.x + ends.y),
        dot(crossing, vec2(part.Begin, part.End)) / (crossing.x + crossing.y));
      Turn(at.x, darkAtFirst); // one of the two ends a stretch, if any does
      Turn(at.y, darkAtFirst != changes);
      guard = GoOn(walk) ? guard : 0;
    }
    AddStretch();
  }
}

// The faces in the order in which the ray meets them: those about a point light as they come; of nested ones,
// each before and behind the finer one.
void Walk(vec3 origin, vec3 direction)
{
  vec4 starts[6];
  vec4 changes[6];
  Part inside[6];
  for (int face = 0; face < numberOfFaces; ++face)
  {
    starts[face] = toMap[face] * vec4(origin, 1.0);
    changes[face] = toMap[face] * vec4(direction, 0.0);
    inside[face] = GetPart(starts[face], changes[face]);
    if (infinite && face > 0)
    {
      Part outer = inside[face - 1];
      inside[face].Begin = clamp(inside[face].Begin, outer.Begin, outer.End);
      inside[face].End = clamp(inside[face].End, outer.Begin, outer.End);
    }
  }
  float last = lit.x;
  int visited = 0;
  int count = infinite ? 2 * numberOfFaces - 1 : numberOfFaces;
  for (int k = 0; k < count; ++k)
  {
    int face = k < numberOfFaces ? k : 2 * numberOfFaces - 2 - k;
    Part part = inside[face];
    if (infinite)
    {
      part.Begin = k < numberOfFaces ? part.Begin : inside[face + 1].End;
      part.End = k < numberOfFaces - 1 ? inside[face + 1].Begin : part.End;
    }
    else
    {
      face = -1;
      for (int other = 0; other < numberOfFaces; ++other)
      {
        bool left = (visited & (1 << other)) == 0 && inside[other].End > inside[other].Begin;
        face = left && (face < 0 || inside[other].Begin < inside[face].Begin) ? other : face;
      }
      if (face < 0)
      {
        break;
      }
      visited |= 1 << face;
      part = inside[face];
    }
    if (part.End > part.Begin)
    {
      if (part.Begin > last + 1e-6 * lit.y)
      {
        Turn(last, false); // beyond the map all is lit
      }
      WalkFace(face, starts[face], changes[face], part);
      last = part.End;
    }
  }
  if (last < lit.y - 1e-6 * lit.y)
  {
    Turn(last, false);
  }
}

vec4 GetColor(ivec2 pixel)
{
  vec2 uv = (vec2(pixel) + 0.5) / pictureSize;
  vec2 place = (0.5 + (uv - 0.5) * viewScale) * layerSize; // of the pixel in the layer
  vec2 xy = (place - viewCenter) * pixelSize; // of the view ray at depth 1, or of its start
  float perDepth = parallel ? 1.0 : length(vec3(xy, 1.0));
  vec3 origin = parallel ? vec3(xy, 0.0) : vec3(0.0);
  vec3 direction = parallel ? vec3(0.0, 0.0, 1.0) : vec3(xy, 1.0) / perDepth;
  SetRay(origin, direction);
  float depth = texelFetch(ends, ivec2(place), 0).r;
  lit = SpotPart(ray, MediumEnd(ray, perDepth * min(depth, farLimit)));
  litFrom = lit.x;
  for (int c = 0; closed && c < channels; ++c)
  {
    strength[c] = ScatteredPart(GetComponent(2 * c), 0.0, ray.Foot) +
      ScatteredPart(GetComponent(2 * c + 1), 0.0, ray.Foot);
  }
  if (shadowed)
  {
    Walk(origin, direction);
  }
  Turn(lit.y, true);
  AddStretch();
  return vec4(Sanitize(lightColor * (grey ? vec3(airlight.x) : airlight), maximum), 1.0);
}

//VTK::GodRays::Main
