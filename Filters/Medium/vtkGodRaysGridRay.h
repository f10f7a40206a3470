// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridRay.h
 * @brief   media of data along one view ray, exactly
 *
 * Private. Optical depths of the ray are sums over the cells that it goes through; those of the light's ways
 * to it are found anew for each place.
 */

#ifndef vtkGodRaysGridRay_h
#define vtkGodRaysGridRay_h

#include "vtkGodRaysGrid.h"

#include <vector>

class vtkGodRaysGridRay
{
public:
  using Vec3 = vtkGodRays::Vec3;

  /**
   * Look at a ray from origin along a direction of length 1 to end. The light is a position, or a
   * direction of length 1.
   */
  void Cast(const std::vector<vtkGodRaysGrid>& grids, const Vec3& origin, const Vec3& along,
    double end, const Vec3& light, bool directional);

  /**
   * Add what is scattered at a distance, for each unit of length and of solid angle, and the optical depth of
   * its way to the eye and, for lit, of the light's to there.
   */
  void Add(double s, double cosAngle, bool lit, Vec3& scattered, Vec3& depth) const;

  /**
   * Between which distances what Add() tells is smooth, or nearly so: where the ray goes from cell to cell,
   * and where the light's way to it moves by a cell. In their order.
   */
  const std::vector<double>& GetKnots() const { return this->Knots; }

  /**
   * Where the ray or the light's way to it enters or leaves a grid, in their order. Between two of these,
   * knots are a cell apart or there are none.
   */
  const std::vector<double>& GetEnds() const { return this->Ends; }

private:
  struct Part
  {
    double Begin;
    std::size_t Point; // of the cell
    Vec3 Corner;       // its place
    Vec3 Depth;        // of what is before
  };
  struct Passage
  {
    const vtkGodRaysGrid* Grid;
    Vec3 Place; // of the ray's origin
    Vec3 Steps;
    Vec3 Light; // place or steps
    double End; // of the last part
    Vec3 Depth; // of all
    std::vector<Part> Parts;
    double Shadow[2]; // where the light comes through the grid
    double Cell;      // length of the ray in the shortest cell that it could cross
  };

  std::vector<Passage> Passages;
  std::vector<double> Knots;
  std::vector<double> Ends;
  bool Directional = true;
};

#endif
