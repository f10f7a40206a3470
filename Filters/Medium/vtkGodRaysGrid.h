// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGrid.h
 * @brief   a participating medium sampled on a regular grid
 *
 * Private. Extinction and scattering coefficients at the points of a grid, trilinear between them and 0
 * outside of it. Lengths are in scene units. A place is in points: (i, j, k) is the place of a point.
 */

#ifndef vtkGodRaysGrid_h
#define vtkGodRaysGrid_h

#include "vtkGodRaysGridTable.h"
#include "vtkGodRaysMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;

struct vtkGodRaysGrid
{
  using Vec3 = vtkGodRays::Vec3;

  int Points[3] = { 2, 2, 2 }; // along each axis, at least 2
  Vec3 Origin = Vec3(0.0);     // where place 0 is, in the coordinates of rays [scene units]
  Vec3 Axes[3];                // and what a step of 1 along each is
  Vec3 Inverse[3];             // rows of what takes an offset from there to a place
  int Bands = 1;               // of extinction: 1, or 3 for red, green and blue
  int ScatteringBands = 0;     // 0: it is Albedo times the extinction
  std::shared_ptr<const vtkGodRaysGridTable> Table; // [1/scene unit, times Scale], at least 0
  double Scale = 1.0;
  double Albedo[3] = { 1.0, 1.0, 1.0 }; // what part of extinction is scattering, [0, 1]
  int PhaseFunction = 0;                // see vtkGodRaysPhaseFunction.h
  double Asymmetry = 0.0;               // [-0.99, 0.99]

  /// Set Inverse to suit Axes. False if these span no volume.
  bool Invert()
  {
    const Vec3 normals[3] = { vtkGodRays::cross(this->Axes[1], this->Axes[2]),
      vtkGodRays::cross(this->Axes[2], this->Axes[0]),
      vtkGodRays::cross(this->Axes[0], this->Axes[1]) };
    const double volume = vtkGodRays::dot(this->Axes[0], normals[0]);
    for (int i = 0; i < 3; ++i)
    {
      this->Inverse[i] = normals[i] / volume;
    }
    return std::isfinite(1.0 / volume);
  }

  ///@{
  /// A place, and how a direction changes it.
  Vec3 GetPlace(const Vec3& position) const { return this->GetSteps(position - this->Origin); }
  Vec3 GetSteps(const Vec3& direction) const
  {
    return Vec3(vtkGodRays::dot(this->Inverse[0], direction),
      vtkGodRays::dot(this->Inverse[1], direction), vtkGodRays::dot(this->Inverse[2], direction));
  }
  ///@}

  std::size_t GetPoint(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * this->Points[1] + j) * this->Points[0] + i;
  }

  /// The part of a line, place + s steps from s = begin to end, that is in the grid; false if there is none.
  bool Clip(const Vec3& place, const Vec3& steps, double& begin, double& end) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const double last = this->Points[i] - 1;
      if (steps[i] == 0.0)
      {
        if (!(place[i] >= 0.0 && place[i] <= last))
        {
          return false;
        }
        continue;
      }
      const double a = -place[i] / steps[i];
      const double b = (last - place[i]) / steps[i];
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    return begin < end;
  }

  /**
   * The part of a line, place + s steps from s = 0 to end, to which a light's way may go through the grid
   * with so many points about it: a convex polygon of places of the line and of the way, clipped by the
   * faces. The light is a place, or the steps to it. The second number is not above the first if there is no
   * part.
   */
  vtkGodRays::Vec2 FindShadow(const Vec3& place, const Vec3& steps, double end, const Vec3& light,
    bool directional, double margin = 0.0) const;

  /**
   * Visit the cells of a line in their order: visit(first point, its place, begin, end) with what of the line
   * is in the cell.
   */
  template <typename Visit>
  void Walk(
    const Vec3& place, const Vec3& steps, double begin, double end, const Visit& visit) const
  {
    if (!this->Clip(place, steps, begin, end))
    {
      return;
    }
    int cell[3];
    double next[3]; // where the line leaves the cell along each axis
    for (int i = 0; i < 3; ++i)
    {
      cell[i] = std::clamp(
        static_cast<int>(std::floor(place[i] + begin * steps[i])), 0, this->Points[i] - 2);
      next[i] = this->GetFace(place, steps, cell, i);
    }
    for (double s = begin; s < end;)
    {
      const int axis =
        next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      const double last = std::min(next[axis], end);
      if (last > s)
      {
        visit(this->GetPoint(cell[0], cell[1], cell[2]), Vec3(cell[0], cell[1], cell[2]), s, last);
        s = last;
      }
      cell[axis] += steps[axis] > 0.0 ? 1 : -1;
      if (cell[axis] < 0 || cell[axis] > this->Points[axis] - 2)
      {
        return;
      }
      next[axis] = this->GetFace(place, steps, cell, axis);
    }
  }

  /// Add the optical depth of each colour between two places of a line, exactly but for rounding.
  void AddDepth(const Vec3& place, const Vec3& steps, double begin, double end, Vec3& depth) const
  {
    const auto visit = [&](std::size_t point, const Vec3& corner, double from, double to)
    {
      this->AddCellDepth(
        point, place + from * steps - corner, place + to * steps - corner, to - from, depth);
    };
    this->Walk(place, steps, begin, end, visit);
  }

  /// The same in one cell, from its first point.
  void AddCellDepth(
    std::size_t point, const Vec3& from, const Vec3& to, double length, Vec3& depth) const
  {
    vtkGodRays::Vec4 corners[2 * vtkGodRaysGridTable::MostComponents];
    this->GetCorners(point, this->Bands, corners);
    for (int band = 0; band < this->Bands; ++band)
    {
      depth[band] += this->Scale * length *
        vtkGodRays::CellMean(corners[2 * band], corners[2 * band + 1], from, to);
    }
    if (this->Bands == 1)
    {
      depth.y = depth.z = depth.x;
    }
  }

  /// Coefficients at a place. [1/scene unit]
  struct Point
  {
    Vec3 Extinction = Vec3(0.0);
    Vec3 Scattering = Vec3(0.0); // into all directions
  };
  /// Those at a place; beyond the grid they are those of its face.
  Point Sample(const Vec3& place) const
  {
    int cell[3];
    Vec3 there;
    for (int i = 0; i < 3; ++i)
    {
      const double x = std::clamp(place[i], 0.0, this->Points[i] - 1.0);
      cell[i] = std::min(static_cast<int>(x), this->Points[i] - 2);
      there[i] = x - cell[i];
    }
    const int count = this->Bands + this->ScatteringBands;
    vtkGodRays::Vec4 corners[2 * vtkGodRaysGridTable::MostComponents];
    this->GetCorners(this->GetPoint(cell[0], cell[1], cell[2]), count, corners);
    const auto read = [&](int first, int bands)
    {
      Vec3 result;
      for (int c = 0; c < 3; ++c)
      {
        const vtkGodRays::Vec4* at = corners + 2 * (first + c);
        result[c] = c < bands ? this->Scale * vtkGodRays::CellValue(at[0], at[1], there) : result.x;
      }
      return result;
    };
    Point point;
    point.Extinction = read(0, this->Bands);
    point.Scattering = this->ScatteringBands > 0
      ? read(this->Bands, this->ScatteringBands)
      : point.Extinction * Vec3(this->Albedo[0], this->Albedo[1], this->Albedo[2]);
    return point;
  }

  /**
   * Take a picture's numbers: its scalars, or the named arrays of its points, in the picture's coordinates,
   * which are those of the scene. What is no array of floats is copied as such. Returns what is wrong, and
   * what to do; empty if nothing is.
   */
  std::string Read(
    vtkImageData* image, const char* extinction = nullptr, const char* scattering = nullptr);

private:
  /// So many components at the corners of a cell, from its first point: first where z is 0.
  void GetCorners(std::size_t point, int count, vtkGodRays::Vec4* corners) const
  {
    const std::ptrdiff_t row = this->Points[0];
    const std::ptrdiff_t slice = row * this->Points[1];
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(point);
    const std::ptrdiff_t points[8] = { first, first + 1, first + row, first + row + 1,
      first + slice, first + slice + 1, first + slice + row, first + slice + row + 1 };
    float values[8 * vtkGodRaysGridTable::MostComponents];
    this->Table->Gather(points, 8, 0, count, values);
    for (int i = 0; i < 2 * count; ++i)
    {
      const float* v = values + 4 * i;
      corners[i] = vtkGodRays::Vec4(v[0], v[1], v[2], v[3]);
    }
  }

  double GetFace(const Vec3& place, const Vec3& steps, const int cell[3], int axis) const
  {
    return steps[axis] == 0.0
      ? std::numeric_limits<double>::infinity()
      : (cell[axis] + (steps[axis] > 0.0 ? 1 : 0) - place[axis]) / steps[axis];
  }
};

#endif
