// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UpAxis.h"

#include "Scene.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double ClearlyLonger = 1.2;
constexpr double ClearlyBroader = 1.5;
constexpr double Foot = 0.02; // of the height
constexpr double TipShare =
  0.05; // of the ground, at most, that something covers which stands on a tip
constexpr double OpenShare = 0.5; // of the ground, at least, that an open surface covers
constexpr double OnceShare =
  0.9; // of a ground's polygons, at least, that are seen from above, once

//------------------------------------------------------------------------------
/**
 * The share of the ground that the box of the lowest points covers, when an axis points up.
 */
double GetFootShare(vtkPolyData* surface, int axis)
{
  double bounds[6];
  surface->GetBounds(bounds);
  const double top = bounds[2 * axis] + Foot * (bounds[2 * axis + 1] - bounds[2 * axis]);
  vtkBoundingBox foot;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    if (point[axis] <= top)
    {
      foot.AddPoint(point);
    }
  }
  double share = 1.0;
  for (int other = 0; other < 3; ++other)
  {
    const double length = bounds[2 * other + 1] - bounds[2 * other];
    share *= other == axis || length == 0.0 ? 1.0 : foot.GetLength(other) / length;
  }
  return share;
}

//------------------------------------------------------------------------------
/**
 * The area that a surface covers along an axis.
 */
struct CoveredArea
{
  double Open = 0.0;  ///< seen from above less seen from below; 0 of closed surfaces
  double Whole = 0.0; ///< of all its polygons
};

CoveredArea GetCoveredArea(vtkPolyData* surface, int axis)
{
  CoveredArea area;
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 2; i < size; ++i)
    {
      double corners[3][3];
      surface->GetPoint(ids[0], corners[0]);
      surface->GetPoint(ids[i - 1], corners[1]);
      surface->GetPoint(ids[i], corners[2]);
      double normal[3];
      vtkTriangle::ComputeNormalDirection(corners[0], corners[1], corners[2], normal);
      area.Open += 0.5 * normal[axis];
      area.Whole += 0.5 * std::abs(normal[axis]);
    }
  }
  area.Open = std::abs(area.Open);
  return area;
}
}

//------------------------------------------------------------------------------
std::string GetReasonForUp(vtkPolyData* surface, char axis)
{
  const int up = axis == 'Z' ? 2 : 1;
  const int other = 3 - up; // the one that usually points up, and is ground if the axis does
  if (surface->GetNumberOfPoints() == 0)
  {
    return "";
  }
  double lengths[3];
  vtkBoundingBox(surface->GetBounds()).GetLengths(lengths);
  if (lengths[up] > ClearlyLonger * std::max(lengths[0], lengths[other]) &&
    GetFootShare(surface, up) > ClearlyBroader * GetFootShare(surface, other))
  {
    return std::string("it stands along ") + axis;
  }
  const bool isLow = lengths[up] < Scene::LowestOfShapes * std::min(lengths[0], lengths[other]);
  const double tip = isLow ? GetFootShare(surface, other) : 1.0;
  if (isLow &&
    (GetCoveredArea(surface, up).Open > OpenShare * lengths[0] * lengths[other] ||
      (tip < TipShare && GetFootShare(surface, up) > ClearlyBroader * tip)))
  {
    return std::string("it lies flat over X and ") + (axis == 'Z' ? 'Y' : 'Z');
  }
  return "";
}

//------------------------------------------------------------------------------
bool IsGround(vtkPolyData* surface, const Vector3& up)
{
  const int axis = up[0] != 0.0 ? 0 : up[1] != 0.0 ? 1 : 2;
  double lengths[3];
  vtkBoundingBox(surface->GetBounds()).GetLengths(lengths);
  lengths[axis] = OpenShare;
  const CoveredArea area = GetCoveredArea(surface, axis);
  return area.Open > lengths[0] * lengths[1] * lengths[2] && area.Open > OnceShare * area.Whole;
}
