// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkyObserver.h"

#include "vtkGodRaysView.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using vtkGodRays::Vec3;

namespace
{
/// The eye in the world.
Vec3 GetEye(const vtkGodRaysView& view)
{
  double viewToWorld[16];
  vtkMatrix4x4::Invert(view.WorldToView, viewToWorld);
  return Vec3(viewToWorld[3], viewToWorld[7], viewToWorld[11]);
}

/// A vector of view coordinates in a frame of the world.
Vec3 ToFrame(const double vector[3], const vtkGodRaysView& view, const Vec3 axes[3])
{
  Vec3 world(0.0);
  for (int i = 0; i < 3; ++i)
  {
    const double* row = view.WorldToView + 4 * i;
    world += vector[i] * Vec3(row[0], row[1], row[2]);
  }
  return Vec3(dot(world, axes[0]), dot(world, axes[1]), dot(world, axes[2]));
}
}

void vtkGodRaysSkyObserver::Set(const vtkGodRaysView& view, const vtkGodRaysPlanet& planet)
{
  const Vec3 way = planet.WorldUnitInMeters * (GetEye(view) - planet.Origin);
  const double distance = length(way);
  const double slope = distance > 0.0 ? dot(way, planet.Up) / distance : 0.0;
  this->Height = std::max(vtkGodRays::SkyRise(planet.GroundRadius, slope, distance), 0.0);

  // where the sun is vertically above, any horizontal direction will do
  Vec3 axes[3];
  axes[2] = way + planet.GroundRadius * planet.Up;
  axes[2] = length(axes[2]) > 0.0 ? normalize(axes[2]) : planet.Up; // at the planet's centre
  axes[0] = planet.Sun - dot(planet.Sun, axes[2]) * axes[2];
  if (length(axes[0]) < 1e-9)
  {
    axes[0] = cross(axes[2], std::abs(axes[2].x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0));
  }
  axes[0] = normalize(axes[0]);
  axes[1] = cross(axes[2], axes[0]);
  this->Sun = Vec3(dot(planet.Sun, axes[0]), 0.0, dot(planet.Sun, axes[2]));

  double origin[3];
  double right[3];
  double up[3];
  view.GetPicture(false, origin, right, up);
  this->PictureOrigin = ToFrame(origin, view, axes);
  this->PictureRight = ToFrame(right, view, axes);
  this->PictureUp = ToFrame(up, view, axes);
  const double ahead[3] = { 0.0, 0.0, 1.0 };
  this->Axis = normalize(ToFrame(ahead, view, axes));
}

std::string vtkGodRaysSkyObserver::Describe() const
{
  std::ostringstream text;
  text << "observer: " << this->Height << " m above the ground, the sun "
       << vtkMath::DegreesFromRadians(std::asin(std::clamp(this->Sun.z, -1.0, 1.0)))
       << " degrees high\n";
  return text.str();
}
