// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The shared formulas with Real = float; -fsingle-precision-constant (GCC) makes their numbers those of
// GLSL.

#include "GodRaysMediumSingle.h"

#include "vtkGodRaysPhaseFunction.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace vtkGodRaysSingle
{
using Real = float;
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;

#include "vtkGodRaysFormulas.inl"
}

float GodRaysMediumSingle::DirectionalAirlight(float extinction, float end)
{
  return vtkGodRaysSingle::DirectionalAirlight(extinction, 0.0f, end, 0.0f, 0.0f);
}

float GodRaysMediumSingle::PointAirlight(float foot, float height, float end)
{
  return vtkGodRaysSingle::PointAirlight(foot, height, 0.0f, end);
}

float GodRaysMediumSingle::PointAirlight(
  int kind, float g, float extinction, float foot, float height, float end)
{
  const vtkGodRaysSingle::PhaseFunction phase = { kind, g };
  return vtkGodRaysSingle::PointAirlight(phase, extinction, foot, height, 0.0f, end);
}

float GodRaysMediumSingle::ExponentialAirlight(
  float extinction, float height, float slope, float lightSlope, float scaleHeight, float end)
{
  return vtkGodRaysSingle::ExponentialAirlight(
    extinction, height, slope, lightSlope, scaleHeight, 0.0f, end);
}

void GodRaysMediumSingle::EarthInscatter(
  float height, float slope, float sunSlope, float cosAngle, float distance, float result[3])
{
  using vtkGodRaysSingle::Vec3;
  const vtkGodRaysSingle::SkyAtmosphere earth = { 6360e3f, 60e3f, { 0, 8000.0f, 0.0f },
    { 0, 1200.0f, 0.0f }, { 2, 25e3f, 15e3f }, Vec3(5.802e-6f, 13.558e-6f, 33.1e-6f),
    Vec3(3.996e-6f), Vec3(4.44e-6f), Vec3(0.650e-6f, 1.881e-6f, 0.085e-6f), { 1, 0.0f }, 3,
    Vec3(0.8f) };
  const Vec3 light =
    vtkGodRaysSingle::SkyInscatter(earth, height, slope, sunSlope, cosAngle, distance);
  result[0] = light.x;
  result[1] = light.y;
  result[2] = light.z;
}
