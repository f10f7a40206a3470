//VTK::System::Dec
//VTK::Output::Dec

// The part of a view ray that is lit: the mean of 5 pixels in a row, and then of 5 in a column, that end
// at about the same depth; at last times the ray's airlight.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Terms
// parallel: whether view rays are
// infinite: whether the light is infinitely far
// uniformly: whether it is and the medium is homogeneous
// grey: whether the medium has one colour
// cube: whether the map has six faces
// rows: whether the mean is of a row

//VTK::GodRays::MediumRays

uniform sampler2D ends; // view depths of where view rays end
uniform sampler2D lit;  // part of the airlight, and the depth over farLimit; of the picture's size

// Pixels whose depths differ by more do not count.
const float reach = 0.1; // [fraction of the pixel's depth]

void main()
{
  vec2 place = GetPlace();
  ivec2 pixel = ivec2(texCoord * pictureSize);
  ivec2 last = ivec2(pictureSize) - 1;
  vec4 here = texelFetch(lit, pixel, 0);
  float depth = grey ? here.g : here.a;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = -2; i <= 2; ++i)
  {
    ivec2 other = clamp(pixel + (rows ? ivec2(i, 0) : ivec2(0, i)), ivec2(0), last);
    vec4 there = texelFetch(lit, other, 0);
    float away = abs((grey ? there.g : there.a) - depth);
    float weight = max(0.0, 1.0 - away / max(reach * depth, 1e-30));
    sum += weight * there.rgb;
    weights += weight;
  }
  if (rows)
  {
    gl_FragData[0] = grey ? vec4(sum.x / weights, depth, 0.0, 1.0) : vec4(sum / weights, depth);
    return;
  }
  float end = texelFetch(ends, ivec2(place), 0).r;
  LitRay ray = GetLitRay(place);
  vec3 strength = uniformly ? GetStrength(ray) : vec3(0.0);
  vec3 airlight = vec3(0.0);
  for (int c = 0; c < channels; ++c)
  {
    airlight[c] = sum[c] / weights *
      GetTotalAirlight(c, ray, strength[c], GetEnd(ray, end, GetLengthPerDepth(place)));
  }
  gl_FragData[0] = GetRadiance(airlight);
}
