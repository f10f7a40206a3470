// Light of the sky and of the ground on a surface. vtkGodRaysSurfaceSky puts this into the mappers' shaders.

//VTK::GodRays::Colour

// Factors of 1, x, y, z, xy, yz, zx, xx and yy of a normal in the camera's coordinates, whose sum is the
// linear light of a white surface that only sky and ground light. The first is 0 where none shines.
uniform vec3 godraysSky[9];

vec3 GodRaysSky(vec3 n)
{
  vec3 light = godraysSky[0] + n.x * (godraysSky[1] + n.x * godraysSky[7] + n.y * godraysSky[4]);
  light += n.y * (godraysSky[2] + n.y * godraysSky[8] + n.z * godraysSky[5]);
  return max(light + n.z * (godraysSky[3] + n.x * godraysSky[6]), 0.0);
}

// Returns what the sky adds to a colour of VTK's shading in display values, of which lit is the part that
// is scattered, and color what is white where all of the light is. The curve is that of 8 bits, as powers
// would take most of a frame in software; above white it is that of a sixteenth of the light, up to 16.
vec3 GodRaysAddSky(vec3 lit, vec3 color, vec3 normal)
{
  const float wide = 3.1748021; // 16^(1/2.4)
  vec3 shown = max(lit, 0.0) / max(color, vec3(1e-4));
  vec3 isOver = step(1.0, shown);
  vec3 within = min(mix(shown, (shown + 0.055) / wide - 0.055, isOver), 1.0);
  vec3 light = mix(vec3(1.0), vec3(16.0), isOver) * DecodeDisplay8(within) + GodRaysSky(normal);
  isOver = step(1.0, light);
  vec3 with = EncodeDisplay8(light * mix(vec3(1.0), vec3(0.0625), isOver));
  return color * (mix(with, wide * (with + 0.055) - 0.055, isOver) - shown);
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
