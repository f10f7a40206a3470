// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTransportScene.h"

namespace
{
using vtkGodRays::Vec3;

Vec3 GetVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}
}

vtkGodRaysTransportScene::PhaseMix vtkGodRaysTransportScene::GetPhase(int component) const
{
  if (component < this->Medium.NumberOfComponents)
  {
    const vtkGodRaysMedium::Component& part = this->Medium.Components[component];
    return { { part.PhaseFunction, part.Asymmetry },
      { part.SecondPhaseFunction, part.SecondAsymmetry }, part.SecondWeight };
  }
  const vtkGodRaysGrid& grid = this->Grids[component - this->Medium.NumberOfComponents];
  return { { grid.PhaseFunction, grid.Asymmetry }, { 0, 0.0 }, 0.0 };
}

vtkGodRaysTransportScene::Point vtkGodRaysTransportScene::Sample(
  int component, const Vec3& place) const
{
  Point point;
  if (vtkGodRays::clamp(place, this->Low, this->High) != place)
  {
    return point;
  }
  if (component < this->Medium.NumberOfComponents)
  {
    const vtkGodRaysMedium::Component& part = this->Medium.Components[component];
    const double height =
      this->Medium.EyeHeight + vtkGodRays::dot(place, GetVector(this->Medium.Up));
    const double density =
      part.ScaleHeight > 0.0 ? vtkGodRays::ExponentialDensity(height, part.ScaleHeight) : 1.0;
    point.Scattering = density * GetVector(part.Scattering);
    point.Extinction = point.Scattering + density * GetVector(part.Absorption);
    return point;
  }
  const vtkGodRaysGrid& grid = this->Grids[component - this->Medium.NumberOfComponents];
  const Vec3 at = grid.GetPlace(place);
  const Vec3 last(grid.Points[0] - 1, grid.Points[1] - 1, grid.Points[2] - 1);
  if (vtkGodRays::clamp(at, Vec3(0.0), last) != at)
  {
    return point;
  }
  return grid.Sample(at);
}

Vec3 vtkGodRaysTransportScene::GetIrradiance(
  const Light& light, const Vec3& place, Vec3& towards, double& distance) const
{
  towards = light.Directional ? light.Position : light.Position - place;
  const double length = std::max(vtkGodRays::length(towards), 1e-300);
  towards /= length;
  distance = light.Directional ? std::numeric_limits<double>::infinity() : length;
  double begin = 0.0;
  double end = distance;
  const int face = this->Clip(place, towards, begin, end);
  if (face >= 0 && this->FaceAlbedo[face] > 0.0)
  {
    return Vec3(0.0);
  }
  if (light.Directional)
  {
    return light.Color;
  }
  const double cosine = -vtkGodRays::dot(towards, GetVector(light.Spot.Axis));
  const double spot = !light.Spot.IsCone() ? 1.0
    : cosine < light.Spot.CosCone          ? 0.0
                                           : std::pow(cosine, light.Spot.Exponent);
  return light.Color * (spot / (length * length));
}

Vec3 vtkGodRaysTransportScene::GetDepth(
  int component, const Light& light, const Vec3& place, const Vec3& towards, double distance) const
{
  const vtkGodRaysMedium::Component& part = this->Medium.Components[component];
  const Vec3 extinction = GetVector(part.Scattering) + GetVector(part.Absorption);
  const Vec3 up = GetVector(this->Medium.Up);
  const double height = this->Medium.EyeHeight + vtkGodRays::dot(place, up);
  const double slope = glm::clamp(vtkGodRays::dot(up, towards), -1.0, 1.0);
  if (light.Directional && part.ScaleHeight > 0.0)
  {
    return extinction *
      (slope > 0.0 ? vtkGodRays::MediumColumn(0.0, height, slope, part.ScaleHeight) : 1e30);
  }
  double begin = 0.0;
  this->Clip(place, towards, begin, distance);
  return light.Directional && !this->SunIsDimmed ? Vec3(0.0)
                                                 : extinction *
      vtkGodRays::MediumDepth(0.0, height, slope, part.ScaleHeight, std::max(distance, 0.0));
}

int vtkGodRaysTransportScene::Clip(
  const Vec3& origin, const Vec3& direction, double& begin, double& end) const
{
  int face = -1;
  for (int i = 0; i < 3; ++i)
  {
    const bool up = direction[i] > 0.0;
    const double inverse = 1.0 / (direction[i] != 0.0 ? direction[i] : -1e-300);
    begin = std::max(begin, ((up ? this->Low[i] : this->High[i]) - origin[i]) * inverse);
    const double leaves = ((up ? this->High[i] : this->Low[i]) - origin[i]) * inverse;
    if (leaves < end)
    {
      end = leaves;
      face = 2 * i + (up ? 1 : 0);
    }
  }
  return begin < end ? face : -1;
}
