// How much of a light the medium leaves on its way to a place of a surface. vtkGodRaysSurfaceShadows
// puts this into the mappers' shaders. Coordinates are the camera's, as VTK has them in vertexVC.

//VTK::GodRays::Visibility

uniform vec4 godraysAir[2];    // of each component: extinction of red, green and blue; scale height
uniform vec4 godraysVertical;  // at the eye, of length 1; the eye's height above where densities are 1
uniform float godraysPlanet;   // radius; 0: the ground is a plane

// light is its place (w = 1), or the direction to it (w = 0), of length 1.
vec3 GodRaysAir(vec3 place, vec4 light)
{
  vec3 toLight = light.xyz - light.w * place;
  float height = godraysVertical.w;
  vec2 start = MediumStart(godraysPlanet, height, godraysVertical.xyz, place, normalize(toLight));
  LitRay ray; // from the place
  ray.Infinite = light.w > 0.0 ? 0 : 1;
  ray.Foot = 0.0;
  ray.Distance = 0.0;
  ray.Height = start.x;
  ray.Slope = start.y;
  ray.LightHeight = start.y;
  if (light.w > 0.0)
  {
    ray.LightHeight =
      MediumStart(godraysPlanet, height, godraysVertical.xyz, light.xyz, godraysVertical.xyz).x;
  }
  ray.PlanetRadius = godraysPlanet;
  ray.AxisStart = 0.0;
  ray.AxisSlope = 0.0;
  ray.Shape = SpotShape(0.0, 0.0);
  ray.ThroughGround = 0;
  PhaseFunction none = PhaseFunction(0, 0.0);
  vec3 left;
  for (int c = 0; c < 3; ++c)
  {
    left[c] = LightTransmittance(
      MediumComponent(0.0, godraysAir[0][c], godraysAir[0].w, none, none, 0.0),
      MediumComponent(0.0, godraysAir[1][c], godraysAir[1].w, none, none, 0.0), ray,
      length(toLight));
  }
  return left;
}
