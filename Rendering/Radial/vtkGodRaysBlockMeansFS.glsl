//VTK::System::Dec
//VTK::Output::Dec

// Means of the layer over the blocks of each line: four blocks of a layer of one channel, or one of
// a layer of three.

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

vec3 Mean(float begin, float end, vec2 nearest, vec2 step)
{
  vec2 a = nearest + begin * step;
  vec2 b = nearest + end * step;
  int taps = int(ceil((end - begin) * tapsPerPixel - 0.01));
  if (taps < 1 || any(greaterThan(min(a, b), layerSize)) || any(lessThan(max(a, b), vec2(-1.0))))
  {
    return vec3(0.0);
  }
  vec2 stride = (b - a) / float(taps);
  vec2 first = a + 0.5 * stride + 0.5;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < taps; ++i)
  {
    sum += SampleLayer(layer, (first + float(i) * stride) / layerSize);
  }
  return sum / float(taps);
}

void main()
{
  ivec2 cell = ivec2(texCoord * size);
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
      sums.x = Mean(begins.x, ends.x, nearest, step).r;
      sums.y = Mean(begins.y, ends.y, nearest, step).r;
      sums.z = Mean(begins.z, ends.z, nearest, step).r;
      sums.w = Mean(begins.w, ends.w, nearest, step).r;
    }
    else
    {
      sums.rgb = Mean(begins.x, ends.x, nearest, step);
    }
  }
  gl_FragData[0] = sums;
}
