// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGrid.h
 * @brief   a medium that a grid of numbers tells of
 *
 * Private. Extinction and scattering coefficients at the points of a grid, trilinear between them and 0
 * outside of it: arrays of them, or numbers and a table of what they mean. Lengths are in scene units. A
 * place is in points: (i, j, k) is the place of a point.
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

  int Points[3] = { 2, 2, 2 };       // along each axis, at least 2
  Vec3 Origin = Vec3(0.0);           // where place 0 is, in the coordinates of rays [scene units]
  Vec3 Axes[3];                      // and what a step of 1 along each is
  Vec3 Inverse[3];                   // rows of what takes an offset from there to a place
  int Bands = 1;                     // of Extinction: 1, or 3 for red, green and blue
  int ScatteringBands = 0;           // of Scattering; 0: it is Albedo times the extinction
  const float* Extinction = nullptr; // point-major [1/scene unit, times Scale], at least 0
  const float* Scattering = nullptr;
  std::shared_ptr<const void> Owners[2]; // of these
  std::shared_ptr<const vtkGodRaysGridTable>
    Table;                              // in their place, if any; extinction has one band
  double Scale = 1.0;                   // of both
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

  /// Extinction or scattering of a band at the corners of a cell whose first point is at i.
  void GetCorners(
    bool ofScattering, std::size_t i, int band, vtkGodRays::Vec4& low, vtkGodRays::Vec4& high) const
  {
    if (this->Table)
    {
      float c[8];
      this->Table->GetCorners(i, this->Points[0],
        static_cast<std::ptrdiff_t>(this->Points[0]) * this->Points[1], ofScattering ? 1 + band : 0,
        c);
      low = vtkGodRays::Vec4(c[0], c[1], c[2], c[3]);
      high = vtkGodRays::Vec4(c[4], c[5], c[6], c[7]);
      return;
    }
    const float* values = ofScattering ? this->Scattering : this->Extinction;
    const int bands = ofScattering ? this->ScatteringBands : this->Bands;
    const std::size_t row = static_cast<std::size_t>(bands) * this->Points[0];
    const std::size_t slice = row * this->Points[1];
    const float* v = values + i * bands + band;
    low = vtkGodRays::Vec4(v[0], v[bands], v[row], v[row + bands]);
    v += slice;
    high = vtkGodRays::Vec4(v[0], v[bands], v[row], v[row + bands]);
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
    vtkGodRays::Vec4 low;
    vtkGodRays::Vec4 high;
    for (int band = 0; band < this->Bands; ++band)
    {
      this->GetCorners(false, point, band, low, high);
      depth[band] += this->Scale * length * vtkGodRays::CellMean(low, high, from, to);
    }
    if (this->Bands == 1)
    {
      depth.y = depth.z = depth.x;
    }
  }

  /// What is scattered into all directions at a place in a cell. [1/scene unit]
  Vec3 GetScattering(std::size_t point, const Vec3& place) const
  {
    const bool own = this->ScatteringBands > 0;
    const int bands = own ? this->ScatteringBands : this->Bands;
    vtkGodRays::Vec4 low;
    vtkGodRays::Vec4 high;
    Vec3 result(0.0);
    for (int band = 0; band < bands; ++band)
    {
      this->GetCorners(own, point, band, low, high);
      result[band] = this->Scale * vtkGodRays::CellValue(low, high, place);
    }
    if (bands == 1)
    {
      result.y = result.z = result.x;
    }
    return own ? result : result * Vec3(this->Albedo[0], this->Albedo[1], this->Albedo[2]);
  }

  /**
   * Take a picture's numbers: its scalars, or the named arrays of its points, in the picture's coordinates,
   * which are those of the scene. What is no array of floats is copied as such. Returns what is wrong, and
   * what to do; empty if nothing is.
   */
  std::string Read(
    vtkImageData* image, const char* extinction = nullptr, const char* scattering = nullptr);

private:
  double GetFace(const Vec3& place, const Vec3& steps, const int cell[3], int axis) const
  {
    return steps[axis] == 0.0
      ? std::numeric_limits<double>::infinity()
      : (cell[axis] + (steps[axis] > 0.0 ? 1 : 0) - place[axis]) / steps[axis];
  }
};

#endif
