// What integrators of a medium share: the view ray of a pixel and its airlight. Set by
// vtkGodRaysMediumRays. View coordinates are x to the right, y up, z forwards.

//VTK::GodRays::Medium

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
uniform MediumComponent components[6]; // two of each channel
uniform int totalParts;   // into which a whole ray is divided for its airlight
uniform float maximum;    // that the result can hold

const int channels = grey ? 1 : 3;

// Where the pixel is in the layer [pixels].
vec2 GetPlace()
{
  vec2 uv = (floor(texCoord * pictureSize) + 0.5) / pictureSize;
  return (0.5 + (uv - 0.5) * viewScale) * layerSize;
}

// The view ray at depth 1, or where it starts in a parallel projection.
vec2 GetRayPlace(vec2 place)
{
  return (place - viewCenter) * pixelSize;
}

float GetLengthPerDepth(vec2 place)
{
  return parallel ? 1.0 : length(vec3(GetRayPlace(place), 1.0));
}

LitRay GetLitRay(vec2 place)
{
  vec2 xy = GetRayPlace(place);
  vec3 direction = parallel ? vec3(0.0, 0.0, 1.0) : normalize(vec3(xy, 1.0));
  vec3 origin = parallel ? vec3(xy, 0.0) : vec3(0.0);
  vec3 to = infinite ? light.xyz : light.xyz - origin;
  LitRay ray;
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
  return ray;
}

// Where the ray ends that sees a depth, of which each unit is so long [distance].
float GetEnd(LitRay ray, float depth, float lengthPerDepth)
{
  return MediumEnd(ray, lengthPerDepth * min(depth, farLimit));
}

// What the components scatter in the one direction of a directional light, by channel.
vec3 GetStrength(LitRay ray)
{
  vec3 strength = vec3(0.0);
  for (int c = 0; c < channels; ++c)
  {
    strength[c] = ScatteredPart(components[2 * c], 0.0, ray.Foot) +
      ScatteredPart(components[2 * c + 1], 0.0, ray.Foot);
  }
  return strength;
}

float GetExtinction(int channel)
{
  return components[2 * channel].Extinction + components[2 * channel + 1].Extinction;
}

// Airlight of a part of a ray, all of which the light reaches; strength is GetStrength() where the
// medium is homogeneous and the light directional.
float GetAirlight(int channel, LitRay ray, float strength, float begin, float end)
{
  if (uniformly)
  {
    return strength * DirectionalAirlight(GetExtinction(channel), begin, end, 0.0, 0.0);
  }
  return MediumAirlight(
    components[2 * channel], components[2 * channel + 1], ray, begin, end);
}

// Airlight of a ray as far as it is in a spotlight's cone.
float GetTotalAirlight(int channel, LitRay ray, float strength, float end)
{
  vec2 part = SpotPart(ray, end);
  float sum = 0.0;
  float begin = part.x;
  for (int i = 1; i <= totalParts; ++i)
  {
    float last = MediumPlace(ray, part.x, part.y, float(i) / float(totalParts));
    sum += GetAirlight(channel, ray, strength, begin, last);
    begin = last;
  }
  return sum;
}

// The radiance of the pixel.
vec4 GetRadiance(vec3 airlight)
{
  return vec4(Sanitize(lightColor * (grey ? vec3(airlight.x) : airlight), maximum), 1.0);
}
