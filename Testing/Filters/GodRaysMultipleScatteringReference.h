// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GodRaysMultipleScatteringReference
 * @brief   all orders of scattering by a Monte Carlo method, with its variance: the ground truth
 *
 * Private. Paths go backwards from the eye. Lengths of free flight come of delta tracking [Woodcock1965], and
 * at each event the light is looked at, past triangles and through media whose optical depth is exact but for
 * rounding: no bias. The first event is forced to lie on the view ray, by a table of its optical depth in
 * 1024 parts. Surfaces are diffuse, on both sides. Visibility is that of the triangles, not that of the
 * scene's functions: with vtkGodRaysMultipleScattering only the description of media and lights is shared.
 */

#ifndef GodRaysMultipleScatteringReference_h
#define GodRaysMultipleScatteringReference_h

#include "vtkGodRaysTransportScene.h"

#include <memory> // For std::unique_ptr

class vtkPolyData;

class GodRaysMultipleScatteringReference
{
public:
  using Vec3 = vtkGodRays::Vec3;

  struct Result
  {
    double Single = 0.0;   // radiance that was scattered once
    double Orders = 0.0;   // and more often, or scattered after surfaces have reflected it
    double Variance = 0.0; // of Orders, the mean over paths
  };

  GodRaysMultipleScatteringReference();
  ~GodRaysMultipleScatteringReference();
  GodRaysMultipleScatteringReference(const GodRaysMultipleScatteringReference&) = delete;
  void operator=(const GodRaysMultipleScatteringReference&) = delete;

  /// Sets the scene, and triangles that block light and reflect the part albedo of it; null: none.
  void SetScene(const vtkGodRaysTransportScene& scene, vtkPolyData* occluders, double albedo);

  /// Evaluates a colour of a view ray, of a direction of length 1, from so many paths. The same seed gives
  /// the same result. Threads may call it together.
  Result Evaluate(
    const Vec3& origin, const Vec3& direction, int color, int paths, unsigned int seed) const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
