// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkGodRaysSunPosition.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool Scene::IsLow() const
{
  const double wide = std::min(this->GetExtent(this->East), this->GetExtent(this->North));
  const double high = this->GetExtent(this->Up);
  return high > 0.0 && high < LowestOfShapes * wide;
}

//------------------------------------------------------------------------------
bool Scene::IsTerrain() const
{
  constexpr double steepest = 0.18;
  const double length = std::max(this->GetExtent(this->East), this->GetExtent(this->North));
  return this->HasGround && this->IsLow() && this->GetExtent(this->Up) < steepest * length;
}

//------------------------------------------------------------------------------
Vector3 Scene::GetDirection(double azimuth, double elevation) const
{
  Vector3 direction;
  vtkGodRaysSunPosition::ComputeDirection(
    azimuth, elevation, this->Up.data(), this->North.data(), direction.data());
  return direction;
}

//------------------------------------------------------------------------------
void Scene::GetAngles(const Vector3& direction, double& azimuth, double& elevation) const
{
  double angles[2];
  vtkGodRaysSunPosition::ComputeAngles(
    direction.data(), this->Up.data(), this->North.data(), angles);
  azimuth = angles[0] + (angles[0] < 0.0 ? 360.0 : 0.0);
  elevation = angles[1];
}

//------------------------------------------------------------------------------
double Scene::GetExtent(const Vector3& direction) const
{
  double lengths[3];
  this->Bounds.GetLengths(lengths);
  return std::abs(direction[0]) * lengths[0] + std::abs(direction[1]) * lengths[1] +
    std::abs(direction[2]) * lengths[2];
}

//------------------------------------------------------------------------------
double Scene::GetHighest(const Vector3& point, double distance) const
{
  double center[3];
  this->Bounds.GetCenter(center);
  double highest = vtkMath::Dot(center, this->Up.data()) - 0.5 * this->GetExtent(this->Up);
  for (const auto& prop : this->Props)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkDataSet* data = actor ? actor->GetMapper()->GetInput() : nullptr;
    const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
    constexpr vtkIdType enough = 100000;
    for (vtkIdType i = 0; i < count; i += 1 + count / enough)
    {
      double position[4] = { 0.0, 0.0, 0.0, 1.0 };
      data->GetPoint(i, position);
      actor->GetMatrix()->MultiplyPoint(position, position);
      Vector3 arm;
      vtkMath::Subtract(position, point.data(), arm.data());
      const double east = vtkMath::Dot(arm.data(), this->East.data());
      const double north = vtkMath::Dot(arm.data(), this->North.data());
      if (std::hypot(east, north) < distance)
      {
        highest = std::max(highest, vtkMath::Dot(position, this->Up.data()));
      }
    }
  }
  return highest;
}
