//VTK::System::Dec
//VTK::Output::Dec

// The scene and its rays, joined; fragments that no ray reaches are left alone.

in vec2 texCoord;

//VTK::GodRays::Colour
//VTK::GodRays::Medium
//VTK::GodRays::Radial

uniform sampler2D scene;
uniform sampler2D rays;
uniform float intensity;
uniform float sceneGain;
uniform sampler2D veil;     // what media of data leave of what is behind them
uniform sampler2D backdrop; // of a scene that is over black, put under it later
uniform vec3 tint;        // of rays of one channel
uniform vec4 responsePlace;   // of the light, and the size of the picture in heights
uniform vec3 responseNumbers; // nearest, reach and streaks of RadialResponse()
uniform float viewScale;  // fraction of the rays' size that is shown, if they are resized
uniform sampler2D depth;  // window depth of what is seen
uniform vec4 depthTerms;  // see vtkGodRaysView::Pinhole
uniform vec3 pictureOrigin; // with these, x and y in [-1, 1] become view coordinates (parallel), or
uniform vec3 pictureRight;  // else a vector along the view ray
uniform vec3 pictureUp;
uniform float pictureScale; // what x and y are on the picture's edge
uniform vec3 extinction;    // of the medium's two components, where their density is 1
uniform vec3 secondExtinction;
uniform vec2 scaleHeight;
uniform vec3 mediumUp;
uniform float eyeHeight;
uniform float planetRadius;
uniform float farLimit;
uniform vec3 skyLight;        // of a sky, times how much of what the medium takes it scatters
uniform float dataExposure;  // of the rays over data that are seen, as a part of that elsewhere
uniform float darkExposure;  // the same over data that are dark
uniform float dataGain;      // on data, at most as much as the medium takes of their light
uniform vec3 surroundLight;  // of rays before a light background where they leave it as it is, by distance
uniform vec3 surroundPlace;  // from this place of the whole picture, and the size of a pixel [heights]
uniform float surroundPart;  // by which it is darker where there are none
uniform float surroundRays;  // part of the rays that is added to it
uniform float mostLightness; // by which data change, if only their lightness does
uniform bool alphaShowsData; // it is 0 where nothing is drawn
uniform float alphaLayers;   // n in PartOfAlpha()
uniform ivec2 tile;           // corner of the viewport in a picture of several tiles [pixels]
uniform sampler2D opacity;   // of what leaves no depth, in alpha; may have a margin about the scene
uniform float opacityLayers; // n for it, and for coverage
uniform sampler2D coverage;  // by what has a depth, of pixels of several samples
uniform vec2 cells;          // of the pictures that a meter reads

//VTK::GodRays::Terms
// linearLight: whether rays are linear light, or shown values as the scene's colours
// bytes: whether shown values are of 8 bits
// isPower: whether shown values stand for light by a power
// screen: SCREEN rather than ADD
// showRays: the rays alone
// resized: they are not as large as the viewport
// oneChannel: the rays are one value a pixel, in red, times the tint
// hasBackdrop: whether there is a backdrop
// hasRays: whether there are rays
// dimmed: by the medium through which the scene is seen
// veiled: by media of data, too
// parallel: whether view rays are
// exponential: whether the medium's density falls with height
// hasSecond: whether it has two components
// grey: whether it dims all colours alike
// skyLit: whether it scatters light of a sky, too
// shoulder: whether sums stay below white rather than being clipped
// surround: whether rays darken the background, which is light
// sparesData: whether rays are weaker over data
// gainsData: whether data are brighter than what the medium leaves of them
// lightnessAlone: whether data keep hue and chroma
// hasOpacity: whether opacity, rather than the scene's alpha, says what leaves no depth
// hasCoverage: whether coverage, rather than one depth, says how much of a pixel has a depth
// responds: whether the rays have a response
// dithered: whether noise of half a level hides that colours are rounded
// capsData: whether rays over data have a cap
// metered: whether a few pixels are drawn for a vtkGodRaysLightMeter, rather than the picture

// What the medium lets through between the eye and what is seen.
vec3 SceneTransmittance(ivec2 pixel, vec2 uv)
{
  float rest = 1.0 - texelFetch(depth, pixel, 0).r;
  float viewDepth = ViewDepth(depthTerms, rest);
  viewDepth = rest > 0.0 && viewDepth > 0.0 ? min(viewDepth, farLimit) : farLimit;
  vec2 place = pictureScale * (2.0 * uv - 1.0);
  vec3 ray = pictureOrigin + place.x * pictureRight + place.y * pictureUp;
  float way = parallel ? viewDepth : viewDepth * length(ray) / ray.z;
  vec3 tau = (exponential || !hasSecond ? extinction : extinction + secondExtinction) * way;
  if (exponential)
  {
    vec3 direction = parallel ? vec3(0.0, 0.0, 1.0) : normalize(ray);
    vec3 origin = parallel ? vec3(ray.xy, 0.0) : vec3(0.0);
    vec2 start = MediumStart(planetRadius, eyeHeight, mediumUp, origin, direction);
    tau = extinction * MediumDepth(planetRadius, start.x, start.y, scaleHeight.x, way);
    if (hasSecond)
    {
      tau += secondExtinction * MediumDepth(planetRadius, start.x, start.y, scaleHeight.y, way);
    }
  }
  return grey ? vec3(exp(-tau.x)) : exp(-tau);
}

vec3 Decode(vec3 shown)
{
  return !linearLight     ? shown
    : bytes && !isPower ? DecodeDisplay8(hasBackdrop ? min(shown, 1.0) : shown)
                        : DecodeDisplay(shown, isPower);
}

vec3 Encode(vec3 light)
{
  return !linearLight     ? light
    : bytes && !isPower ? EncodeDisplay8(light)
                        : EncodeDisplay(light, isPower);
}

// How much of what leaves no depth counts as something rather than a background: what several such layers
// hide, so that smoke has no outline. Formula: 1 - (1 - a)^n.
float PartOfAlpha(float alpha, float layers)
{
  return 1.0 - pow(clamp(1.0 - alpha, 0.0, 1.0), layers);
}

float PartOfOpacity(ivec2 pixel)
{
  if (!hasOpacity)
  {
    return 0.0;
  }
  ivec2 margin = (textureSize(opacity, 0) - textureSize(scene, 0)) / 2;
  return PartOfAlpha(texelFetch(opacity, pixel + margin, 0).a, opacityLayers);
}

// How much of a pixel has a depth.
float CoveredPart(ivec2 pixel)
{
  return hasCoverage ? texelFetch(coverage, pixel, 0).r : texelFetch(depth, pixel, 0).r < 1.0 ? 1.0 : 0.0;
}

// How much of that counts: as of what is thin, see PartOfAlpha().
float PartOfCoverage(float covered)
{
  return hasCoverage ? PartOfAlpha(covered, opacityLayers) : covered;
}

// How much of what has no depth in a pixel counts by the picture's alpha, which is 1 where it has one.
float RestOfAlpha(float alpha, float covered)
{
  return covered < 1.0 ? PartOfAlpha((alpha - covered) / (1.0 - covered), alphaLayers) : 0.0;
}

// How much of a pixel shows something rather than a background.
float DataPart(ivec2 pixel, float alpha)
{
  float covered = CoveredPart(pixel);
  float rest = alphaShowsData ? RestOfAlpha(alpha, covered) : PartOfOpacity(pixel);
  covered = PartOfCoverage(covered);
  return covered + (1.0 - covered) * rest;
}

vec3 Join(vec3 base, vec3 light)
{
  return screen ? BlendScreen(base, light)
    : shoulder  ? BlendShoulder(base, light)
                : BlendAdd(base, light);
}

void main()
{
  vec2 uv = texCoord;
  if (metered)
  {
    // of three pictures, one above the other; in each cell a pixel is read, not in rows and columns
    vec2 cell = floor(vec2(texCoord.x, fract(3.0 * texCoord.y)) * cells);
    vec2 place = fract(0.5 + cell.x * vec2(0.7548777, 0.5698403) + cell.y * vec2(0.3819660, 0.6710436));
    uv = (cell + place) / cells;
  }
  // as large as the scene
  ivec2 pixel = ivec2(uv * vec2(hasRays ? textureSize(rays, 0) : textureSize(scene, 0)));
  vec3 light = vec3(0.0);
  float shade = 1.0; // how dark shadows are before a light background: they fade and have streaks, too
  if (hasRays)
  {
    vec4 ray = resized ? texture(rays, 0.5 + (uv - 0.5) * viewScale) : texelFetch(rays, pixel, 0);
    light = intensity * (oneChannel ? ray.r * tint : ray.rgb);
    if (responds)
    {
      vec2 offset = (uv - responsePlace.xy) * responsePlace.zw;
      light *= RadialResponse(offset, responseNumbers.x, responseNumbers.y, responseNumbers.z);
      shade = RadialResponse(offset, responseNumbers.x, 6.0 * responseNumbers.y, responseNumbers.z);
    }
  }
  if (showRays)
  {
    gl_FragData[0] = vec4(Encode(light), 1.0);
    return;
  }
  light = max(light, vec3(0.0)); // data and haze are rounded apart
  vec3 transmittance = dimmed ? SceneTransmittance(pixel, uv) : vec3(1.0);
  if (skyLit)
  {
    light += intensity * skyLight * (1.0 - transmittance);
  }
  if (!metered && !dimmed && !any(greaterThan(light, vec3(0.0))) && sceneGain == 1.0 &&
    !surround)
  {
    discard;
  }
  vec4 shownOver = texelFetch(scene, pixel, 0);
  vec3 under =
    hasBackdrop ? (1.0 - shownOver.a) * texelFetch(backdrop, pixel, 0).rgb : vec3(0.0);
  vec3 shown = shownOver.rgb + under;
  vec3 before = Decode(shown);
  vec3 base = sceneGain * before;
  if (dimmed)
  {
    base *= transmittance;
    if (gainsData)
    {
      base *= DataGain(transmittance, dataGain, DataPart(pixel, shownOver.a));
    }
  }
  if (veiled && !metered) // what data take is not made up for
  {
    base *= texelFetch(veil, pixel, 0).rgb;
  }
  if (metered)
  {
    float covered = CoveredPart(pixel);
    gl_FragData[0] = 3.0 * texCoord.y < 1.0 ? vec4(before, RestOfAlpha(shownOver.a, covered))
      : 3.0 * texCoord.y < 2.0              ? vec4(base, PartOfCoverage(covered))
                                            : vec4(light, PartOfOpacity(pixel));
    return;
  }
  if (sparesData)
  {
    vec3 over = mix(darkExposure, dataExposure, SeenPart(before)) * (capsData ? CapLight(light) : light);
    light = mix(light, over, DataPart(pixel, shownOver.a));
  }
  vec3 sum = Join(base, light);
  if (surround)
  {
    vec3 ground = dimmed ? mix(base, before, surroundPart) : base; // a medium's own light makes up for it
    vec2 place = surroundPlace.z * (vec2(pixel + tile) + 0.5);
    float lit = RingLight(surroundLight, distance(place, surroundPlace.xy));
    vec3 darker = BlendSurround(ground, light, lit, min(surroundPart * shade, 1.0));
    sum = mix(Join(darker, surroundRays * light), sum, DataPart(pixel, shownOver.a));
  }
  if (lightnessAlone)
  {
    sum = mix(sum, BlendLightness(before, sum, mostLightness), DataPart(pixel, shownOver.a));
  }
  // what is darker than the backdrop has to cover it
  vec3 shownSum = Encode(sum);
  if (dithered)
  {
    vec3 change = abs(shownSum - shown); // colours that stay keep their bytes
    float amplitude = min(255.0 * max(change.x, max(change.y, change.z)), 1.0);
    shownSum += amplitude * OrderedNoise(vec2(pixel + tile)) / 255.0;
  }
  gl_FragData[0] =
    vec4(shownSum - (dimmed || surround ? vec3(0.0) : under), 1.0);
}
