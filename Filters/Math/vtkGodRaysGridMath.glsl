// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Types

// A medium that data tell of: numbers at the points of a grid, trilinear between them.

// The value at a place in a cell, each of whose coordinates is in [0, 1]. Its corners are low, where z is 0,
// and high, where it is 1, each with x running fastest.
// Formula: trilinear interpolation. [the values' unit]
FUNCTION Real CellValue(IN(Vec4) low, IN(Vec4) high, IN(Vec3) place)
{
  GODRAYS_EXPECT(place.x >= -1e-4 && place.x <= 1.0001);
  GODRAYS_EXPECT(place.y >= -1e-4 && place.y <= 1.0001);
  GODRAYS_EXPECT(place.z >= -1e-4 && place.z <= 1.0001);
  Vec4 plane = low + place.z * (high - low);
  Real front = plane.x + place.x * (plane.y - plane.x);
  Real back = plane.z + place.x * (plane.w - plane.z);
  return front + place.y * (back - front);
}

// The mean of the values in a cell along the straight line between two places: times the line's length, what
// the line adds to an optical depth. Along a line the value is a product of up to three linear functions of
// the way, so a cubic polynomial of it, for which Simpson's rule is exact.
// Formula: (f(from) + 4 f((from + to)/2) + f(to))/6. [the values' unit]
FUNCTION Real CellMean(IN(Vec4) low, IN(Vec4) high, IN(Vec3) from, IN(Vec3) to)
{
  return (CellValue(low, high, from) + 4.0 * CellValue(low, high, 0.5 * (from + to)) +
           CellValue(low, high, to)) /
    6.0;
}

// The extinction of a medium of which a way of the length unit hides a part of what is behind: opacity, as
// volume renderers have it, of which more than 1 - 1e-6 counts as that.
// Formula: -ln(1 - opacity)/unit. [1/length] [DrebinCarpenterHanrahan1988]
FUNCTION Real OpacityExtinction(IN(Real) opacity, IN(Real) unit)
{
  GODRAYS_EXPECT(opacity >= 0.0 && opacity <= 1.0 && unit > 0.0);
  return -log(1.0 - min(opacity, 0.999999)) / unit;
}
