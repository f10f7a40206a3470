// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysTriangleTree.h
 * @brief   triangles in a tree of boxes, found by planes
 *
 * Private; see vtkGodRaysSingleScattering.h.
 */

#ifndef vtkGodRaysTriangleTree_h
#define vtkGodRaysTriangleTree_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMath.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

class vtkPolyData;

namespace vtkGodRays
{
using Triangle = std::array<Vec3, 3>;

class VTKGODRAYSFILTERS_EXPORT TriangleTree
{
public:
  /// Of polygons and strips, those whose corners are finite. Null has none.
  explicit TriangleTree(vtkPolyData* data);

  /// Call visit for every triangle in a box that meets the plane normal . p = offset, unless
  /// skip(centre, half size) is true.
  template <typename Skip, typename Visit>
  void Find(const Vec3& normal, double offset, const Skip& skip, const Visit& visit) const
  {
    const Vec3 size = abs(normal);
    std::size_t i = 0;
    while (i < this->Nodes.size())
    {
      const Node& node = this->Nodes[i];
      const double reach = dot(size, node.HalfSize);
      if (std::abs(dot(normal, node.Centre) - offset) >
          reach + 1e-12 * (std::abs(offset) + reach) ||
        skip(node.Centre, node.HalfSize))
      {
        i = node.Next;
        continue;
      }
      for (std::size_t j = node.Begin; j < node.End; ++j)
      {
        visit(this->Triangles[j]);
      }
      ++i;
    }
  }

private:
  struct Node
  {
    Vec3 Centre;
    Vec3 HalfSize;
    std::size_t Begin; // triangles of a leaf
    std::size_t End;
    std::size_t Next; // node after this one and its children
  };

  void Build(std::size_t begin, std::size_t end);

  std::vector<Triangle> Triangles;
  std::vector<Node> Nodes;
};
}

#endif
