// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPointSlices.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysTableRays.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace vtkGodRays;

// Of what begins at another height to the right of a lamp than to the left, so much may count as alike: it
// errs by at most 6e-4, root mean square.
constexpr double LeastBend = 0.05; // [least scale height]

// Whether parallel rays do, as a planet's ground bends away below the eye.
bool BeginsAboveBend(
  const CoverageSettings& settings, const CoverageImage& image, const vtkGodRaysMedium& medium)
{
  if (!settings.Parallel || settings.PlanetRadius <= 0.0)
  {
    return false;
  }
  const Vec3 light(settings.Light[0], settings.Light[1], 0.0);
  const Vec3 rise(settings.Up[0], settings.Up[1], 0.0);
  const double side =
    length(rise) > 1e-6 ? std::abs(cross(rise, light).z) / length(rise) : length(light);
  Range ways;
  VisitEdge(image,
    [&](double x, double y)
    {
      const Vec3 ray = GetRay(settings, image, x, y);
      ways.Add(std::hypot(ray.x - light.x, ray.y - light.y));
    });
  return 2.0 * side * ways.High > LeastBend * GetLeastScale(medium) * settings.PlanetRadius;
}
}

namespace vtkGodRays
{
// Rays are alike in planes with the vertical, or a spotlight's axis. If they fade from an axis that is not
// vertical, or begin where the ground bends, none are: slices are about the light, from the middle of the
// picture on.
void SetSliceAxes(const CoverageImage& image, const vtkGodRaysMedium& medium, bool layered,
  CoverageSettings& settings)
{
  const Vec3 up(settings.Up[0], settings.Up[1], settings.Up[2]);
  const Vec3 axis(settings.Spot.Axis[0], settings.Spot.Axis[1], settings.Spot.Axis[2]);
  std::copy_n(layered ? settings.Up : settings.Spot.Axis, 3, settings.SliceAxis);
  std::fill_n(settings.SliceSide, 3, 0.0);
  settings.Around = layered && settings.Point &&
    ((settings.Spot.Fades() && length(cross(up, axis)) > 1e-3) ||
      BeginsAboveBend(settings, image, medium));
  if (!settings.Around)
  {
    return;
  }
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const double distance = length(light);
  const Vec3 forward(0.0, 0.0, 1.0);
  const Vec3 way = settings.Parallel || distance <= 0.0 ? forward : light / distance;
  const Vec3 middle = GetRay(settings, image, 0.5 * (image.Width - 1), 0.5 * (image.Height - 1));
  const Vec3 towards = settings.Parallel ? middle - light : middle;
  Vec3 away = towards - dot(towards, way) * way;
  if (length(away) <= 1e-6 * length(towards))
  {
    const Vec3 any = std::abs(way.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    away = any - dot(any, way) * way;
  }
  const Vec3 one = away / length(away);
  const Vec3 other = cross(way, one);
  const double axes[2][3] = { { one.x, one.y, one.z }, { other.x, other.y, other.z } };
  std::copy_n(axes[0], 3, settings.SliceAxis);
  std::copy_n(axes[1], 3, settings.SliceSide);
}
}
