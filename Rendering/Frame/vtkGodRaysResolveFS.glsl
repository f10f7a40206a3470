//VTK::System::Dec
//VTK::Output::Dec

// The samples of a pixel as one colour, or how many of them something covers: see vtkGodRaysSceneCopy.

in vec2 texCoord;

//VTK::GodRays::Terms
// ofDepth: whether the samples are depths; what is written is the part of them below 1

uniform sampler2DMS samples;
uniform int count;       // of samples of a pixel
uniform vec4 rectangle;  // that is resolved: corner and size [pixels]

void main()
{
  ivec2 pixel = ivec2(rectangle.xy + texCoord * rectangle.zw);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < count; ++i)
  {
    vec4 value = texelFetch(samples, pixel, i);
    sum += ofDepth ? vec4(value.r < 1.0 ? 1.0 : 0.0) : vec4(pow(value.rgb, vec3(2.2)), value.a);
  }
  sum /= float(count);
  if (ofDepth)
  {
    gl_FragData[0] = sum;
    return;
  }
  gl_FragData[0] = vec4(pow(sum.rgb, vec3(1.0 / 2.2)), sum.a);
}
