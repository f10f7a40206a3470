//VTK::System::Dec
//VTK::Output::Dec

// The part of a view ray's airlight that the light's shadow map leaves, in steps along the ray.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Terms
// parallel: whether view rays are
// infinite: whether the light is infinitely far
// uniformly: whether it is and the medium is homogeneous
// grey: whether the medium has one colour
// cube: whether the map has six faces

//VTK::GodRays::MediumRays

uniform sampler2D ends;    // view depths of where view rays end
uniform sampler2D map;     // window depths, faces side by side
uniform int mapSize;       // of a face [pixels]
uniform mat4 toMap[6];     // view coordinates to clip coordinates of a face
uniform mat3 toCube;       // view coordinates to the axes of a cube's faces
uniform vec2 mapRange;     // distances from the light of window depths 0 and 1
uniform float texel;       // size of a pixel, at distance 1 from a point light
uniform int numberOfSteps;

// Of a pixel's size, so that what a step is on does not shade it.
const float bias = 1.5;

// The face of a cube about the light that a direction from it, along the cube's axes, meets.
int GetFace(vec3 direction)
{
  vec3 size = abs(direction);
  if (size.x >= size.y && size.x >= size.z)
  {
    return direction.x > 0.0 ? 0 : 1;
  }
  if (size.y >= size.z)
  {
    return direction.y > 0.0 ? 2 : 3;
  }
  return direction.z > 0.0 ? 4 : 5;
}

// Whether the light reaches a place, in clip coordinates of a face: beyond the map's edge nothing
// blocks it.
float GetVisibility(vec4 clip, int face)
{
  vec2 at = 0.5 * ((infinite ? clip.xy : clip.xy / clip.w) + 1.0) * float(mapSize);
  if (clip.w <= 0.0 || (!cube &&
      (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(float(mapSize)))))))
  {
    return 1.0;
  }
  ivec2 pixel = clamp(ivec2(at), ivec2(0), ivec2(mapSize - 1)) +
    mapSize * ivec2(face % 3, face / 3);
  float window = texelFetch(map, pixel, 0).r;
  if (window >= 1.0)
  {
    return 1.0;
  }
  float blocked = infinite
    ? mix(mapRange.x, mapRange.y, window)
    : mapRange.x * mapRange.y / (mapRange.y - window * (mapRange.y - mapRange.x));
  float here = infinite
    ? mix(mapRange.x, mapRange.y, 0.5 * clip.z + 0.5)
    : clip.w;
  return here > blocked + bias * texel * (infinite ? 1.0 : blocked) ? 0.0 : 1.0;
}

// Where steps end: equal light comes from each, if nothing blocks it. all is of AirlightPlace().
float GetStep(LitRay ray, vec2 part, float extinction, float all, float t)
{
  return uniformly ? AirlightPlace(extinction, part.y, all, t) : MediumPlace(ray, part.x, part.y, t);
}

void main()
{
  vec2 place = GetPlace();
  LitRay ray = GetLitRay(place);
  float perDepth = GetLengthPerDepth(place);
  float end = GetEnd(ray, texelFetch(ends, ivec2(place), 0).r, perDepth);
  vec2 part = SpotPart(ray, end);
  float extinction =
    grey ? GetExtinction(0) : (GetExtinction(0) + GetExtinction(1) + GetExtinction(2)) / 3.0;
  float whole = extinction * end * MeanExponential(extinction * end);
  vec2 xy = GetRayPlace(place);
  vec3 origin = parallel ? vec3(xy, 0.0) : vec3(0.0);
  vec3 direction = parallel ? vec3(0.0, 0.0, 1.0) : vec3(xy, 1.0) / perDepth;
  vec4 start = toMap[0] * vec4(origin, 1.0); // a face's clip coordinates are linear along the ray
  vec4 change = toMap[0] * vec4(direction, 0.0);
  float noise = InterleavedGradientNoise(floor(texCoord * pictureSize));

  vec3 lit = vec3(0.0);
  vec3 all = vec3(0.0);
  float begin = part.x;
  for (int i = 0; i < numberOfSteps; ++i)
  {
    float at = GetStep(ray, part, extinction, whole, (float(i) + noise) / float(numberOfSteps));
    int face = cube ? GetFace(toCube * (origin + at * direction - light.xyz)) : 0;
    float visible = GetVisibility(
      cube ? toMap[face] * vec4(origin + at * direction, 1.0) : start + at * change, face);
    if (uniformly && grey)
    {
      lit.x += visible;
      all.x += 1.0;
      continue;
    }
    float last = GetStep(ray, part, extinction, whole, float(i + 1) / float(numberOfSteps));
    vec3 sum = vec3(0.0);
    for (int c = 0; c < channels; ++c)
    {
      float depth = uniformly ? GetExtinction(c) * last : 0.0;
      sum[c] = uniformly ? last * MeanExponential(depth) : all[c] + GetAirlight(c, ray, 0.0, begin, last);
    }
    lit += visible * (sum - all);
    all = sum;
    begin = last;
  }
  for (int c = 0; c < channels; ++c)
  {
    lit[c] = all[c] > 0.0 ? lit[c] / all[c] : 1.0;
  }
  float depth = min(texelFetch(ends, ivec2(place), 0).r, farLimit) / farLimit;
  gl_FragData[0] = grey ? vec4(lit.x, depth, 0.0, 1.0) : vec4(lit, depth);
}
