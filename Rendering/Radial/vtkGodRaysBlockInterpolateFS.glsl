//VTK::System::Dec
//VTK::Output::Dec

// The integral at each pixel of the picture, from that at the nodes of the lines about it. What is
// needed in a box about the light alone, taps for short marches and ends of marches within a block,
// is drawn there alone: NearLight is whether that is drawn, or the rest of the picture.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Terms
//VTK::GodRays::Radial

uniform vec2 size;      // of the picture [pixels]
uniform vec2 layerSize; // [pixels]
uniform vec2 origin;    // of the picture's first pixel in the layer [pixels, centres are whole]
uniform vec2 pixel;     // distance of the picture's pixels [pixels of the layer]
uniform sampler2D layer;
uniform sampler2D means;
uniform sampler2D sums;      // at the nodes
uniform sampler2D rows;      // for each row or column of the picture and each wedge, three values
uniform vec2 sumsSize;       // of the texture [texels]
uniform vec4 firstStrip;     // of each wedge: the first even line of those that are closer
uniform float stripFactor;   // how many times
uniform float lastLine;      // of any wedge
uniform vec2 marchConstant; // from the point p, marchConstant - marchSlope p [pixels]
uniform float marchSlope;
uniform float k;             // the kernel is e^(-k t)
uniform float shortest;      // shorter marches are summed by taps [pixels]
uniform float tapsPerPixel;  // of these
uniform float bumpTapLength; // [pixels]
uniform vec4 nearBox; // first column and row that are drawn with NearLight, and the first beyond
uniform vec3 gain;

const float KernelEnd = 17.0; // beyond t = KernelEnd/k, the kernel is below a float's precision

vec3 SumTapsNearLight(vec2 point, vec2 march)
{
  vec2 uv = (point + 0.5) / layerSize;
  vec2 part = ClipMarch(uv, march / layerSize, 0.5 / layerSize);
  part.y = k > KernelEnd ? min(part.y, KernelEnd / k) : part.y;
  if (part.x >= part.y)
  {
    return vec3(0.0);
  }
  int taps = int(clamp(ceil((part.y - part.x) * length(march) * tapsPerPixel), 16.0, 32768.0));
  return MeanAlongMarch(layer, uv, march / layerSize, k, part, taps);
}

// What is to be added where an end of the march, at a point, is length steps beyond an end of a
// block: the layer in between instead of the block's mean. bump: that length, its factor, the mean.
vec3 Bump(vec3 bump, vec2 point, vec2 step, float line)
{
  float column = OneChannel ? floor(0.25 * bump.z) : bump.z;
  vec4 texel = texelFetch(means, ivec2(vec2(column, line + 0.5)), 0);
  vec3 mean = texel.rgb;
  if (OneChannel)
  {
    float channel = bump.z - 4.0 * column;
    mean = vec3(channel < 1.5 ? (channel < 0.5 ? texel.x : texel.y)
                              : (channel < 2.5 ? texel.z : texel.w));
  }
  if (OneChannel ? mean.r <= 0.0 : texel.a < 0.5) // even
  {
    return vec3(0.0);
  }
  int taps = int(clamp(ceil(abs(bump.x) / bumpTapLength), 1.0, 64.0));
  vec2 stride = -bump.x / float(taps) / layerSize * step;
  vec2 first = (point + 0.5) / layerSize + 0.5 * stride;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < taps; ++i)
  {
    sum += SampleLayer(layer, first + float(i) * stride);
  }
  return bump.y * (sum / float(taps) - mean);
}

void main()
{
  vec2 index = floor(texCoord * size);
  bool near = all(greaterThanEqual(index, nearBox.xy)) && all(lessThan(index, nearBox.zw));
  if (NearLight && !near)
  {
    discard;
  }
  vec2 point = origin + index * pixel;
  vec2 march = marchConstant - marchSlope * point;
  bool transposed = abs(march.x) > abs(march.y);
  bool back = (marchSlope < 0.0) == ((transposed ? march.x : march.y) < 0.0);
  int row = int(transposed ? index.x : index.y);
  int place = 3 * ((transposed ? 2 : 0) + (back ? 1 : 0));
  vec4 sumsPlace = texelFetch(rows, ivec2(row, place), 0);
  vec4 front = texelFetch(rows, ivec2(row, place + 1), 0);
  float even = ((transposed ? point.y : point.x) - sumsPlace.x) * sumsPlace.y;
  float strip = transposed ? (back ? firstStrip.w : firstStrip.z)
                           : (back ? firstStrip.y : firstStrip.x);
  float line = clamp(
    LineOfEven(even, vec3(strip, strip + sumsPlace.w, stripFactor)), 0.0, lastLine);
  // to the next row, along the line through the light
  vec2 step = march * ((back ? -1.0 : 1.0) / (transposed ? march.x : march.y));
  vec3 result = textureLod(sums, (vec2(sumsPlace.z, line) + 0.5) / sumsSize, 0.0).rgb;
  result += Bump(front.xyz, point, step, line);
  if (NearLight)
  {
    vec4 tail = texelFetch(rows, ivec2(row, place + 2), 0);
    if (tail.y != 0.0)
    {
      result += Bump(tail.xyz, point + tail.w * step, step, line);
    }
    if (!(length(march) >= shortest))
    {
      result = SumTapsNearLight(point, march);
    }
  }
  else if (near)
  {
    result = vec3(0.0);
  }
  result = max(result, vec3(0.0)); // what bumps take away is rounded
  gl_FragData[0] = vec4(gain * (OneChannel ? vec3(result.r) : result), 1.0);
}
