// Light of the sky and of the ground on a surface. vtkGodRaysSurfaceSky puts this into the mappers' shaders.

//VTK::GodRays::Colour

// Of red, green and blue, for a normal n in the camera's coordinates: (n, 1)^T matrix (n, 1) is the linear
// light of a white surface that only sky and ground light. The last number is 0 where none shines.
uniform mat4 godraysSky[3];

vec3 GodRaysSky(vec3 normal)
{
  vec4 n = vec4(normal, 1.0);
  return max(
    vec3(dot(n, godraysSky[0] * n), dot(n, godraysSky[1] * n), dot(n, godraysSky[2] * n)), 0.0);
}

// Returns what the sky adds to a colour of VTK's shading in display values, of which lit is the part that
// is scattered, and color what is white where all of the light is.
vec3 GodRaysAddSky(vec3 lit, vec3 color, vec3 normal)
{
  vec3 shown = max(lit, 0.0) / max(color, vec3(1e-4));
  return color * (EncodeDisplay(DecodeDisplay(shown) + GodRaysSky(normal)) - shown);
}

// Returns what the sky adds to physically based shading, in linear light. Its mirror image is as wide as that
// of a dull surface, see [Karis2014] for the part of it that is seen. A white surface has 1/pi of a light's
// colour there, so it has that part of the sky, too.
vec3 GodRaysAddSky(
  vec3 albedo, float metallic, float roughness, vec3 f0, vec3 normal, vec3 toEye)
{
  float facing = clamp(dot(normal, toEye), 0.0, 1.0);
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float edge = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
  vec2 part = vec2(-1.04, 1.04) * edge + r.zw;
  vec3 mirrored = f0 * part.x + part.y;
  return 0.31830988618 *
    ((1.0 - metallic) * (1.0 - mirrored) * albedo * GodRaysSky(normal) +
      mirrored * GodRaysSky(reflect(-toEye, normal)));
}
