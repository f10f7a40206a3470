// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points, directions and colours.
 */

#ifndef Vectors_h
#define Vectors_h

#include <array> // For std::array

using Vector3 = std::array<double, 3>;

/**
 * a + factor b.
 */
inline Vector3 AddScaled(const Vector3& a, double factor, const Vector3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

/**
 * a - b.
 */
inline Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return AddScaled(a, -1.0, b);
}

#endif
