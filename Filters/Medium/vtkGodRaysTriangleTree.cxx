// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTriangleTree.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>

namespace
{
using vtkGodRays::Triangle;
using vtkGodRays::Vec3;

std::vector<Triangle> GetTriangles(vtkPolyData* data)
{
  std::vector<Triangle> triangles;
  if (!data || !data->GetPoints())
  {
    return triangles;
  }
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    Triangle triangle;
    const vtkIdType ids[3] = { a, b, c };
    for (int i = 0; i < 3; ++i)
    {
      double point[3];
      data->GetPoint(ids[i], point);
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
      {
        return;
      }
      triangle[i] = Vec3(point[0], point[1], point[2]);
    }
    triangles.push_back(triangle);
  };
  vtkIdType count;
  const vtkIdType* ids;
  auto polygons = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    polygons->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      add(ids[0], ids[i - 1], ids[i]);
    }
  }
  auto strips = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      add(ids[i - 2], ids[i - 1 + i % 2], ids[i - i % 2]);
    }
  }
  return triangles;
}
}

namespace vtkGodRays
{
TriangleTree::TriangleTree(vtkPolyData* data)
  : Triangles(GetTriangles(data))
{
  if (!this->Triangles.empty())
  {
    this->Build(0, this->Triangles.size());
  }
}

void TriangleTree::Build(std::size_t begin, std::size_t end)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low(infinity);
  Vec3 high(-infinity);
  for (std::size_t i = begin; i < end; ++i)
  {
    for (const Vec3& corner : this->Triangles[i])
    {
      low = min(low, corner);
      high = max(high, corner);
    }
  }
  const std::size_t self = this->Nodes.size();
  this->Nodes.push_back({ 0.5 * (low + high), 0.5 * (high - low), begin, begin, 0 });
  constexpr std::size_t leaf = 4;
  if (end - begin <= leaf)
  {
    this->Nodes[self].End = end;
  }
  else
  {
    const Vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(this->Triangles.begin() + begin, this->Triangles.begin() + middle,
      this->Triangles.begin() + end,
      [axis](const Triangle& a, const Triangle& b)
      { return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis]; });
    this->Build(begin, middle);
    this->Build(middle, end);
  }
  this->Nodes[self].Next = this->Nodes.size();
}
}
