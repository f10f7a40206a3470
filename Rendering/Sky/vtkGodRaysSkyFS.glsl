//VTK::System::Dec
//VTK::Output::Dec

// The sky of a picture, looked up in the table of directions.

in vec2 texCoord;

//VTK::GodRays::Types
//VTK::GodRays::Functions

uniform sampler2D table;
uniform ivec2 halfSize;     // of the table's halves
uniform int rowsBelow;      // the horizon
uniform SkyAtmosphere sky;
uniform float height;       // of the observer
uniform vec2 edges;         // see SkyEdges
uniform vec3 sun;           // in the observer's frame, see vtkGodRaysSkyObserver
uniform vec3 pictureOrigin; // with these, x and y in [-1, 1] become a vector along the view ray
uniform vec3 pictureRight;
uniform vec3 pictureUp;
uniform vec2 pixelSize;     // of x and y
uniform vec3 irradiance;    // of the sun, times the exposure
uniform vec3 discRadiance;  // the same
uniform float discRadius;   // [radians]

//VTK::GodRays::Terms
// hasDisc: whether the sun's disc may be seen
// hasEdge: whether the atmosphere's edge may be
// phaseBit0, phaseBit1, phaseBit2: the kind of the aerosol's phase function

const int PhaseKind = (phaseBit0 ? 1 : 0) + (phaseBit1 ? 2 : 0) + (phaseBit2 ? 4 : 0);

// Light of the sun's disc, at directions near it.
vec3 DiscLight(vec3 direction, vec3 ray)
{
  float separation = length(direction - sun); // of a small angle
  float pixel = PixelAngle(ray, pixelSize.x * pictureRight, pixelSize.y * pictureUp);
  SkyWay way = MakeSkyWay(sky, height, direction.z, sun.z, 1.0);
  vec3 left = way.Length > 0.0 ? exp(-SkyDepth(sky, way.Height, way.Slope, way.Length)) : vec3(1.0);
  return discRadiance * DiscCoverage(separation, discRadius, pixel) *
    SunLimb(separation / discRadius) * left;
}

void main()
{
  vec2 place = 2.0 * texCoord - 1.0;
  vec3 ray = pictureOrigin + place.x * pictureRight + place.y * pictureUp;
  vec3 direction = normalize(ray);
  float slope = direction.z;
  float row = SkyTableRow(edges, slope);
  bool above = slope >= edges.x;
  float level = max(length(direction.xy), 1e-20);
  vec2 cell = vec2(0.5 + 0.5 * (1.0 + direction.x / level) * float(halfSize.x - 1),
    float(rowsBelow) + (above ? row * float(halfSize.y - rowsBelow - 1) + 0.5
                              : row * float(rowsBelow - 1) - 0.5));
  vec2 uv = cell / vec2(2 * halfSize.x, halfSize.y);
  PhaseFunction phase = PhaseFunction(PhaseKind, sky.AerosolPhase.Asymmetry);
  vec3 light = textureLod(table, uv, 0.0).rgb +
    Phase(phase, dot(direction, sun)) * textureLod(table, uv + vec2(0.5, 0.0), 0.0).rgb;
  light *= irradiance;
  if (hasEdge && slope >= edges.y)
  {
    light = vec3(0.0);
  }
  if (hasDisc && above)
  {
    light += DiscLight(direction, ray);
  }
  gl_FragData[0] = vec4(EncodeDisplay(light), 1.0);
}
