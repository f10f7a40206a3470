//VTK::System::Dec
//VTK::Output::Dec

// The sky of a picture, looked up in tables of directions; or the air before a scene.

in vec2 texCoord;

//VTK::GodRays::Colour
//VTK::GodRays::Light
//VTK::GodRays::Sky

uniform sampler2D table;    // see vtkGodRaysSkyTableFS
uniform sampler2D extinction;
uniform ivec2 halfSize;     // columns and rows of one half of one of the table's slices
uniform int rowsBelow;      // the horizon
uniform int slices;
uniform int extinctionSlices;
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
uniform sampler2D scene;
uniform sampler2D depth;    // window depth of what is seen
uniform vec4 depthTerms;    // see vtkGodRaysView::Pinhole
uniform vec3 axis;          // of view
uniform float sceneUnit;    // [m]
uniform ivec2 corner;       // of the picture [pixels of the framebuffer]

//VTK::GodRays::Terms
// beforeScene: the air before the scene rather than the sky behind it
// isPower: whether shown values stand for light by a power of 2.2, not by sRGB's transfer
// shoulder: whether light stays below white rather than being clipped
// dithered: whether noise of half a level hides that colours are rounded
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

// Light at a place of the table, with its phase function.
vec3 LookUp(vec2 cell, int slice, vec3 aerosolPhase)
{
  vec2 uv = (cell + vec2(0.0, slice * halfSize.y)) / vec2(2 * halfSize.x, halfSize.y * slices);
  return textureLod(table, uv, 0.0).rgb +
    aerosolPhase * textureLod(table, uv + vec2(0.5, 0.0), 0.0).rgb;
}

vec3 Join(vec3 behind, vec3 light)
{
  return shoulder ? BlendShoulder(behind, light) : BlendAdd(behind, light);
}

// Light as it is shown. Noise of less than half a level leaves colours alone that bytes can hold.
vec3 Encode(vec3 light)
{
  vec3 shown = EncodeDisplay(light, isPower);
  return dithered ? shown + OrderedNoise(floor(gl_FragCoord.xy) - vec2(corner)) / 255.0 : shown;
}

// The scene through the air.
vec3 SceneThroughAir(vec3 ray, float slope, bool above, vec2 cell, vec3 aerosolPhase)
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(depth, 0)));
  vec3 shown = texelFetch(scene, pixel, 0).rgb;
  vec2 within = SkyBelow(sky.GroundRadius, height, slope, sky.TopHeight);
  float rest = 1.0 - texelFetch(depth, pixel, 0).r;
  float way = ViewDepth(depthTerms, rest) * sceneUnit * length(ray) / dot(ray, axis) - within.x;
  if (within.x > within.y || !(way > 0.0))
  {
    return shown;
  }
  float ground = SkyGroundDistance(sky.GroundRadius, height, slope);
  float end = above       ? within.y
    : ground >= 0.0 ? ground
                    : -(sky.GroundRadius + height) * slope; // just below the horizon
  float place = sqrt(sqrt(clamp(way / max(end - within.x, 1e-3), 0.0, 1.0)));
  float slice = clamp(place * float(slices) - 1.0, 0.0, float(slices - 1));
  vec2 uv = vec2(place - 0.5 / float(extinctionSlices), cell.y / float(halfSize.y));
  vec3 transmittance = exp(-way * textureLod(extinction, uv, 0.0).rgb);
  int lower = min(int(slice), slices - 2);
  vec3 light = mix(LookUp(cell, lower, aerosolPhase), LookUp(cell, lower + 1, aerosolPhase),
    slice - float(lower));
  vec3 behind = DecodeDisplay(shown, isPower) * transmittance;
  return Encode(Join(behind, irradiance * light * (1.0 - transmittance)));
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
  vec3 aerosolPhase = SkyAerosolPhase(PhaseKind, sky.AerosolAsymmetry, dot(direction, sun));
  if (beforeScene)
  {
    gl_FragData[0] = vec4(SceneThroughAir(ray, slope, above, cell, aerosolPhase), 1.0);
    return;
  }
  vec3 light = irradiance * LookUp(cell, 0, aerosolPhase);
  vec3 disc = vec3(0.0); // joined last, and clipped: compressed, it could not be told from the sky about it
  if (hasEdge && slope >= edges.y)
  {
    light = vec3(0.0);
  }
  if (hasDisc && above)
  {
    disc = DiscLight(direction, ray);
  }
  gl_FragData[0] = vec4(Encode(BlendAdd(Join(vec3(0.0), light), disc)), 1.0);
}
