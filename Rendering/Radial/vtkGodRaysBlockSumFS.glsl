//VTK::System::Dec
//VTK::Output::Dec

// The integral at each node of each line: the means of blocks times the kernel's weights.

in vec2 texCoord; // column of nodes, and line

//VTK::GodRays::Terms
//VTK::GodRays::Radial

uniform vec2 size; // columns and lines
uniform sampler2D means;
uniform sampler2D nodes;    // in each column: first and last column of weights, row of weights,
                            // first column of means; then where the nodes before and after are
                            // [pixels from nearest row], and the wedge
uniform sampler2D kernel;   // weights of four blocks
uniform vec2 layerSize;     // [pixels]
uniform vec4 wedgeLines[4]; // as for the means
uniform vec4 wedgeRows[4];
uniform vec4 wedgeStrips[4];

vec4 Fetch(int column, int line)
{
  return texelFetch(means, ivec2(column, line), 0);
}

void main()
{
  ivec2 cell = min(ivec2(texCoord * size), ivec2(size) - 1); // as for the means
  vec4 sums = texelFetch(nodes, ivec2(cell.x, 0), 0);
  vec4 around = texelFetch(nodes, ivec2(cell.x, 1), 0);
  int wedge = int(around.z);
  vec4 rows = wedgeRows[wedge];
  vec4 lines = wedgeLines[wedge];
  float even = EvenOfLine(float(cell.y), wedgeStrips[wedge].xyz);
  float nearest = lines.x + even * lines.y;
  float slope = lines.z + even * lines.w;
  float a = nearest + around.x * slope;
  float b = nearest + around.y * slope;
  // No pixel is interpolated from nodes on all sides of which there is no picture.
  bool used = float(cell.y) < rows.w && min(a, b) < (rows.z > 0.5 ? layerSize.y : layerSize.x) + 2.0 &&
    max(a, b) > -3.0;
  int last = used ? int(sums.y) : -1;
  int row = int(sums.z);
  int offset = int(sums.w);
  vec4 sum = vec4(0.0);
  for (int i = int(sums.x); i <= last; ++i)
  {
    vec4 weights = texelFetch(kernel, ivec2(i, row), 0);
    if (OneChannel)
    {
      sum.x += dot(weights, abs(Fetch(offset + i, cell.y)));
    }
    else
    {
      int column = offset + 4 * i;
      sum += weights.x * Fetch(column, cell.y) + weights.y * Fetch(column + 1, cell.y) +
        weights.z * Fetch(column + 2, cell.y) + weights.w * Fetch(column + 3, cell.y);
    }
  }
  gl_FragData[0] = sum;
}
