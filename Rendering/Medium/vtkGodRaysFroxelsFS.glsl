//VTK::System::Dec
//VTK::Output::Dec

// The light of froxels up to where view rays end; see vtkGodRaysFroxels.

in vec2 texCoord;

uniform sampler2D ends;    // view depths of where view rays end, of the layer
uniform sampler2D froxels; // slices on each other
uniform float viewScale;   // fraction of the layer's size that the picture covers
uniform vec3 count;        // columns, rows and slices
uniform float farthest;    // view depth of the last slice
uniform float maximum;     // that the result can hold

//VTK::GodRays::Common
//VTK::GodRays::Terms

void main()
{
  vec2 place = 0.5 + (texCoord - 0.5) * viewScale;
  float depth = texelFetch(ends, ivec2(place * vec2(textureSize(ends, 0))), 0).r;
  vec2 node = texCoord * (count.xy - 1.0) + 0.5;
  float slice = clamp(depth / farthest, 0.0, 1.0) * (count.z - 1.0);
  float before = min(floor(slice), count.z - 2.0);
  vec2 low = vec2(node.x / count.x, (before * count.y + node.y) / (count.y * count.z));
  vec3 light = mix(texture(froxels, low).rgb,
    texture(froxels, low + vec2(0.0, 1.0 / count.z)).rgb, slice - before);
  gl_FragData[0] = vec4(Sanitize(light, maximum), 1.0);
}
