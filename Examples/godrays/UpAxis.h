// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a surface's shape tells about it: which axis points up, where its file does not say it, and whether it
 * is ground.
 */

#ifndef UpAxis_h
#define UpAxis_h

#include "Vectors.h" // For Vector3

#include <string> // For std::string

class vtkPolyData;

/**
 * Why an axis, Y or Z, seems to point up in a surface of a type in which the other one usually does; empty
 * when it does not. It does where the surface stands: clearly longest along the axis, and on a clearly
 * broader foot than if the other one pointed up; and where it lies low over the plane of the other two: open,
 * as terrain, or so that it would stand on a tip else, as an aeroplane on its nose.
 */
std::string GetReasonForUp(vtkPolyData* surface, char axis);

/**
 * Whether a surface is seen once from above, nearly everywhere, and from below not at all, as terrain is.
 */
bool IsGround(vtkPolyData* surface, const Vector3& up);

#endif
