// Reads a light's shadow map and its pyramid. vtkGodRaysShadowTextures sets the numbers.
//
// Heights of texels are 1 - window depth, towards the light: affine in the distance of a directional light,
// and in 1/distance of a point light. Nodes have the least and the greatest of 2^level x 2^level texels.
// Odd and even levels are in one texture each, as one is drawn from the other, level on level from the
// bottom up.

//VTK::GodRays::Walk

uniform sampler2D map;       // window depths, faces side by side
uniform sampler2D oddLevels; // of nodes, faces side by side
uniform sampler2D evenLevels;
uniform int mapSize;    // of a face [texels]
uniform int mapColumns; // of faces
uniform int mapRows;
uniform int mapTop;         // the last level, of one node
uniform int mapOffsets[16]; // where levels begin in their textures

// Height of a texel without occluder, or of one beyond the face.
const float nothing = -1e30;

// Returns how wide a face is at a level.
int GetSize(int level)
{
  return (mapSize + (1 << level) - 1) >> level;
}

float GetHeight(ivec2 corner, ivec2 texel)
{
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(mapSize))))
  {
    return nothing;
  }
  float depth = texelFetch(map, corner + texel, 0).r;
  return depth < 1.0 ? 1.0 - depth : nothing;
}

// Returns the slopes of a texel's plane in x and y, for each texel. A slope towards nothing is larger than
// any other, and where there is nothing to both sides, they do not agree.
vec2 GetSlopes(ivec2 corner, ivec2 texel, float height)
{
  return vec2(TexelSlope(GetHeight(corner, texel - ivec2(1, 0)), height,
                GetHeight(corner, texel + ivec2(1, 0))),
    TexelSlope(GetHeight(corner, texel - ivec2(0, 1)), height,
      GetHeight(corner, texel + ivec2(0, 1))));
}

// Returns the corner of a face at a level.
ivec2 GetCorner(int face, int level)
{
  return GetSize(level) * ivec2(face % mapColumns, face / mapColumns);
}

vec2 GetNode(int face, int level, ivec2 node)
{
  ivec2 at = GetCorner(face, level) + ivec2(0, mapOffsets[level]) + node;
  return (level & 1) == 1 ? texelFetch(oddLevels, at, 0).rg : texelFetch(evenLevels, at, 0).rg;
}
