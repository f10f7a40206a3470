//VTK::System::Dec
//VTK::Output::Dec

// Tables of the sky's light from one observer, in all directions: in the left half what is as smooth as the
// air's phase function, in the right half what the aerosol scatters, without its phase function.
// With slices, one above the other, ways end before the atmosphere does, and the light is divided by what
// it would be if it were as bright all along: 1 - transmittance.

in vec2 texCoord;

//VTK::GodRays::Sky

uniform SkyAtmosphere sky;       // in which the aerosol's forward peak is left in the light, if repeated
uniform vec3 diffuseAerosol;     // what the aerosol scatters without its forward peak
uniform vec3 albedo;
uniform sampler2D repeatedLight; // see SkyMultiplePosition
uniform float height;            // of the observer
uniform float sunSlope;
uniform vec2 edges;              // see SkyEdges
uniform ivec2 halfSize;          // columns and rows of one half of one slice
uniform int rowsBelow;           // the horizon
uniform int slices;
uniform int extinctionSlices;

//VTK::GodRays::Terms
// repeated: whether light is scattered more than once
// sliced: whether there are slices
// ofExtinction: the mean extinction along the ways of all slices and rows, and no light

const int Steps = sliced ? 16 : 24; // slices are short, and many
const float ShortestWay = 10.0; // of a slice; below, what is read of columns of air is rounded

// Where a part of a way is looked at, and what that stands for: Steps middles of t in [0, 1], the part being
// t^3 (10 - 15 t + 6 t^2), so that they are dense at both ends and the sum is far better than its order.
vec2 Place(int step)
{
  float t = (float(step) + 0.5) / float(Steps);
  float rest = 1.0 - t;
  return vec2(t * t * t * (10.0 + t * (6.0 * t - 15.0)), 30.0 * t * t * rest * rest / float(Steps));
}

// The way of a row. The rows at the horizon are on their sides of it, whatever rounding says.
SkyWay WayOfRow(int row, float cosAzimuth)
{
  bool above = row >= 0;
  float place = above ? float(row) / float(halfSize.y - rowsBelow - 1)
                      : float(row + 1) / float(rowsBelow - 1);
  float slope = SkyTableSlope(edges, above ? place : min(place, -1e-9));
  float across = sqrt(max((1.0 - slope * slope) * (1.0 - sunSlope * sunSlope), 0.0));
  SkyWay way =
    MakeSkyWay(sky, height, slope, sunSlope, clamp(slope * sunSlope + across * cosAzimuth, -1.0, 1.0));
  if (above)
  {
    way.MeetsGround = false;
    way.Length = SkyBelow(sky.GroundRadius, way.Height, way.Slope, sky.TopHeight).y;
  }
  else if (!way.MeetsGround)
  {
    way.MeetsGround = true;
    way.Length = max(-(sky.GroundRadius + way.Height) * way.Slope, 0.0);
  }
  return way;
}

float EndOfSlice(SkyWay way, int slice, int count)
{
  float place = float(slice + 1) / float(count);
  return max(way.Length * place * place * place * place, ShortestWay);
}

// What a part of the way adds, on which the integrand is smooth.
vec3 IntegratePart(SkyWay way, float begin, float end, bool lit, bool ofAerosol)
{
  vec3 light = vec3(0.0);
  float size = end - begin;
  if (size <= 0.0 || !(lit || repeated))
  {
    return light;
  }
  for (int step = 0; step < Steps; ++step)
  {
    vec2 place = Place(step);
    float distance = begin + place.x * size;
    vec2 point = SkyPoint(sky, way, distance);
    float air = SkyDensity(sky.Air, point.x);
    float aerosol = SkyDensity(sky.Aerosol, point.x);
    vec3 scattered = vec3(0.0);
    if (lit)
    {
      scattered = (ofAerosol ? sky.AerosolScattering * aerosol
                             : sky.AirScattering * (air * Phase(sky.AirPhase, way.CosAngle))) *
        SkySunTransmittance(sky, point.x, point.y);
    }
    if (repeated && !ofAerosol)
    {
      vec2 there = SkyMultiplePosition(sky.TopHeight, point.x, point.y);
      vec2 tableSize = vec2(textureSize(repeatedLight, 0));
      scattered += (sky.AirScattering * air + diffuseAerosol * aerosol) *
        textureLod(repeatedLight, (there * (tableSize - 1.0) + 0.5) / tableSize, 0.0).rgb;
    }
    light += size * place.y * scattered * exp(-SkyDepth(sky, way.Height, way.Slope, distance));
  }
  return light;
}

// How far light comes from in thick air, which is looked at apart; all of the way in other air.
float NearPart(SkyWay way, float reach)
{
  vec3 extinction = sky.AirScattering * SkyDensity(sky.Air, way.Height) +
    sky.AerosolExtinction * SkyDensity(sky.Aerosol, way.Height);
  float thickest = max(extinction.x, max(extinction.y, extinction.z));
  return thickest * reach > 60.0 ? 6.0 / thickest : reach;
}

// What the way up to a distance adds.
vec3 Integrate(SkyWay way, float reach, bool ofAerosol)
{
  // Where the integrand is not smooth: the shadow's edges; and the lowest point, about which it peaks.
  vec2 shadow = SkyShadow(sky.GroundRadius, way.Height, way.Slope, way.SunSlope, way.CosAngle);
  bool shaded = shadow.x < shadow.y;
  shadow = shaded ? clamp(shadow, 0.0, reach) : vec2(0.0);
  float lowest = clamp(-(sky.GroundRadius + way.Height) * way.Slope, 0.0, reach);
  float ends[5] = float[5](
    0.0, min(lowest, shadow.x), clamp(lowest, shadow.x, shadow.y), max(lowest, shadow.y), reach);

  float near = NearPart(way, reach);
  vec3 light = vec3(0.0);
  for (int part = 0; part < 4; ++part)
  {
    float middle = 0.5 * (ends[part] + ends[part + 1]);
    bool lit = !(shaded && middle > shadow.x && middle < shadow.y);
    float split = clamp(near, ends[part], ends[part + 1]);
    light += IntegratePart(way, ends[part], split, lit, ofAerosol) +
      IntegratePart(way, split, ends[part + 1], lit, ofAerosol);
  }
  return light;
}

void main()
{
  if (ofExtinction)
  {
    ivec2 cell = ivec2(texCoord * vec2(extinctionSlices, halfSize.y));
    SkyWay way = WayOfRow(cell.y - rowsBelow, 1.0);
    float reach = EndOfSlice(way, cell.x, extinctionSlices);
    gl_FragData[0] = vec4(SkyDepth(sky, way.Height, way.Slope, reach) / reach, 1.0);
    return;
  }
  ivec2 cell = ivec2(texCoord * vec2(2 * halfSize.x, halfSize.y * slices));
  bool ofAerosol = cell.x >= halfSize.x;
  float across = float(ofAerosol ? cell.x - halfSize.x : cell.x) / float(halfSize.x - 1);
  SkyWay way = WayOfRow(cell.y % halfSize.y - rowsBelow, 2.0 * across - 1.0);
  float reach = sliced ? EndOfSlice(way, cell.y / halfSize.y, slices) : way.Length;
  vec3 light = Integrate(way, reach, ofAerosol);
  if (sliced)
  {
    vec3 depth = SkyDepth(sky, way.Height, way.Slope, reach);
    light /= max(depth * vec3(MeanExponential(depth.x), MeanExponential(depth.y), MeanExponential(depth.z)),
      1e-12);
  }
  else if (way.MeetsGround && !ofAerosol)
  {
    light += exp(-SkyDepth(sky, way.Height, way.Slope, reach)) *
      SkyGround(sky, albedo, SkyPoint(sky, way, reach).y);
  }
  gl_FragData[0] = vec4(Sanitize(light, 1e30), 1.0);
}
