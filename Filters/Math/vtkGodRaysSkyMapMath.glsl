// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Maps of all directions.

//VTK::GodRays::Types

// Pictures of all directions. Directions have length 1: x to the right (east), y up in the picture
// (north), z to the zenith. Positions are -1 to 1 across the picture in both axes.
//   kind 0 paraboloid: the zenith in the middle, the horizon a circle of radius 1
//   kind 1 equirectangular: azimuth from north clockwise, 0 to 360 degrees from left to right, nadir to
//          zenith from the bottom up
//   kind 2 fisheye: as 0, with the distance from the middle proportional to the angle from the zenith

// Formula: kind 0 (2 x, 2 y, 1 - r^2)/(1 + r^2). [no unit] [Heidrich1998] for the paraboloid
FUNCTION Vec3 SkyMapDirection(IN(int) kind, IN(Vec2) position)
{
  GODRAYS_EXPECT(kind >= 0 && kind <= 2);
  if (kind == 0)
  {
    Real square = dot(position, position);
    return Vec3(2.0 * position.x, 2.0 * position.y, 1.0 - square) / (1.0 + square);
  }
  if (kind == 1)
  {
    Real azimuth = 3.14159265358979324 * (position.x + 1.0);
    Real elevation = 1.57079632679489662 * position.y;
    return Vec3(cos(elevation) * sin(azimuth), cos(elevation) * cos(azimuth), sin(elevation));
  }
  Real reach = length(position);
  Real angle = 1.57079632679489662 * reach;
  Real scale = reach > 1e-6 ? sin(angle) / reach : 1.57079632679489662;
  return Vec3(scale * position.x, scale * position.y, cos(angle));
}

// The solid angle of a unit of a picture's area about a position.
// Formula: kind 0 4/(1 + r^2)^2, kind 1 pi^2/2 cos(elevation), kind 2 pi/2 sin(angle)/r. [sr]
FUNCTION Real SkyMapSolidAngle(IN(int) kind, IN(Vec2) position)
{
  GODRAYS_EXPECT(kind >= 0 && kind <= 2);
  if (kind == 0)
  {
    Real width = 1.0 + dot(position, position);
    return 4.0 / (width * width);
  }
  if (kind == 1)
  {
    return 4.93480220054467931 * cos(1.57079632679489662 * position.y);
  }
  Real reach = max(length(position), 1e-6);
  return 1.57079632679489662 * sin(1.57079632679489662 * reach) / reach;
}

// A direction of a face of a cube map, as OpenGL numbers and turns them: +x, -x, +y, -y, +z, -z. Position
// is -1 to 1 to the right and down in the face. Of length 1 or more; its solid angle is 1/length^3.
// Formula: OpenGL 3.2 specification, table 3.19. [no unit]
FUNCTION Vec3 CubeMapDirection(IN(int) face, IN(Vec2) position)
{
  GODRAYS_EXPECT(face >= 0 && face <= 5);
  Real s = position.x;
  Real t = position.y;
  if (face < 2)
  {
    return face == 0 ? Vec3(1.0, -t, -s) : Vec3(-1.0, -t, s);
  }
  if (face < 4)
  {
    return face == 2 ? Vec3(s, 1.0, t) : Vec3(s, -1.0, -t);
  }
  return face == 4 ? Vec3(s, -t, 1.0) : Vec3(-s, -t, -1.0);
}
