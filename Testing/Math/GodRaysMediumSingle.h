// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of the medium in single precision, from the eye on.

#ifndef GodRaysMediumSingle_h
#define GodRaysMediumSingle_h

namespace GodRaysMediumSingle
{
float DirectionalAirlight(float extinction, float end);
float PointAirlight(float foot, float height, float end);
float PointAirlight(int kind, float g, float extinction, float foot, float height, float end);
float ExponentialAirlight(
  float extinction, float height, float slope, float lightSlope, float scaleHeight, float end);
void EarthInscatter(
  float height, float slope, float sunSlope, float cosAngle, float distance, float result[3]);
}

#endif
