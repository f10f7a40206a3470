//VTK::System::Dec
//VTK::Output::Dec

// Means of the layer over the blocks of each line: four blocks of a layer of one channel, or one of
// a layer of three. Means of even blocks, see Unevenness, are marked: that of one channel is negative,
// three have alpha 0.

in vec2 texCoord; // column of blocks, and line

//VTK::GodRays::Terms
//VTK::GodRays::Radial

uniform vec2 size; // columns and lines
uniform sampler2D layer;
uniform vec2 layerSize;      // [pixels]
uniform sampler2D blocks;    // in each column: where blocks begin, and end [pixels from nearest row]
uniform vec4 wedgeLines[4];  // of the first line and from one even line to the next: column in the
                             // nearest row, slope
uniform vec4 wedgeRows[4];   // nearest row, direction, whether rows are columns, number of lines
uniform vec4 wedgeStrips[4]; // where lines are closer, see LineOfEven()
uniform vec4 wedgeColumns;   // where the columns of each wedge begin
uniform float tapsPerPixel; // [1/pixel]

// A block is even whose taps differ by no more than this part of the largest. Without the taps from a
// node to a pixel it errs by as much times their distance's part of the march, at most 1/32.
const float Unevenness = 1.0 / 255.0;

// And 1, or 0 if the block is even.
vec4 Mean(float begin, float end, vec2 nearest, vec2 step)
{
  vec2 a = nearest + begin * step;
  vec2 b = nearest + end * step;
  int taps = int(ceil((end - begin) * tapsPerPixel - 0.01));
  if (taps < 1 || any(greaterThan(min(a, b), layerSize)) || any(lessThan(max(a, b), vec2(-1.0))))
  {
    return vec4(0.0);
  }
  vec2 stride = (b - a) / float(taps);
  vec2 first = a + 0.5 * stride + 0.5;
  vec3 sum = SampleLayer(layer, first / layerSize);
  vec3 least = sum;
  vec3 most = sum;
  for (int i = 1; i < taps; ++i)
  {
    vec3 tap = SampleLayer(layer, (first + float(i) * stride) / layerSize);
    sum += tap;
    least = min(least, tap);
    most = max(most, tap);
  }
  bvec3 even = lessThanEqual(most - least, Unevenness * most);
  return vec4(sum / float(taps), (OneChannel ? even.r : all(even)) ? 0.0 : 1.0);
}

float SignedMean(float begin, float end, vec2 nearest, vec2 step)
{
  vec4 mean = Mean(begin, end, nearest, step);
  return mean.w > 0.5 ? mean.r : -mean.r;
}

void main()
{
  // Cards also run fragments beyond the edge, to fill blocks of 2 x 2: there tables hold anything, which
  // must not be a number of taps.
  ivec2 cell = min(ivec2(texCoord * size), ivec2(size) - 1);
  int wedge = 0;
  for (int i = 1; i < 4; ++i)
  {
    wedge = float(cell.x) >= wedgeColumns[i] ? i : wedge;
  }
  vec4 rows = wedgeRows[wedge];
  vec4 sums = vec4(0.0);
  if (float(cell.y) < rows.w)
  {
    vec4 lines = wedgeLines[wedge];
    float even = EvenOfLine(float(cell.y), wedgeStrips[wedge].xyz);
    vec2 nearest = vec2(lines.x + even * lines.y, rows.x);
    vec2 step = vec2(lines.z + even * lines.w, rows.y);
    nearest = rows.z > 0.5 ? nearest.yx : nearest;
    step = rows.z > 0.5 ? step.yx : step;
    vec4 begins = texelFetch(blocks, ivec2(cell.x, 0), 0);
    vec4 ends = texelFetch(blocks, ivec2(cell.x, 1), 0);
    if (OneChannel)
    {
      sums.x = SignedMean(begins.x, ends.x, nearest, step);
      sums.y = SignedMean(begins.y, ends.y, nearest, step);
      sums.z = SignedMean(begins.z, ends.z, nearest, step);
      sums.w = SignedMean(begins.w, ends.w, nearest, step);
    }
    else
    {
      sums = Mean(begins.x, ends.x, nearest, step);
    }
  }
  gl_FragData[0] = sums;
}
