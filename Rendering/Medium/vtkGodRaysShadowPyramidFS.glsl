//VTK::System::Dec
//VTK::Output::Dec

// A level of a shadow map's pyramid, from the texels or from the level below.

in vec2 texCoord; // of the level

//VTK::GodRays::Terms
// texels: whether the level is the first

//VTK::GodRays::ShadowMapTexels

uniform int level;

void main()
{
  int size = GetSize(level);
  ivec2 here = ivec2(texCoord * vec2(size * ivec2(mapColumns, mapRows)));
  ivec2 place = here / size;
  int face = place.x + place.y * mapColumns;
  ivec2 corner = GetCorner(face, 0);
  ivec2 last = ivec2(GetSize(level - 1) - 1);
  vec2 range = vec2(1e30, nothing);
  for (int k = 0; k < 4; ++k)
  {
    ivec2 below = min(2 * (here - size * place) + ivec2(k & 1, k >> 1), last);
    vec2 node;
    if (texels)
    {
      float height = GetHeight(corner, below);
      vec2 slopes = abs(GetSlopes(corner, below, height));
      float rise = height > nothing ? 0.5 * (slopes.x + slopes.y) : 0.0;
      node = vec2(height - rise, height + rise);
    }
    else
    {
      node = GetNode(face, level - 1, below);
    }
    range = vec2(min(range.x, node.x), max(range.y, node.y));
  }
  gl_FragData[0] = vec4(range, 0.0, 1.0);
}
