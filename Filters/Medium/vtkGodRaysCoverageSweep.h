// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysCoverageSweep
 * @brief   light that a medium scatters once along view rays, shadowed by a shadow map
 *
 * Private. Fill the input, execute, read the result:
 *
 *     float* ends = sweep.PrepareInput(width, height);
 *     // write ends[y * width + x]
 *     sweep.Execute(parameters);
 *     // read sweep.GetResult()[(y * width + x) * sweep.GetNumberOfComponents() + c]
 *
 * An object keeps its memory, its plan and its tables: an execution like the one before allocates
 * nothing (what vtkSMPTools needs for its threads aside) and plans nothing. Not for two threads at a
 * time.
 *
 * @sa vtkGodRaysShadowKernels.h
 */

#ifndef vtkGodRaysCoverageSweep_h
#define vtkGodRaysCoverageSweep_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMedium.h"        // For vtkGodRaysMedium

#include <memory> // For std::unique_ptr
#include <string> // For std::string

struct vtkGodRaysShadowGrids;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysCoverageSweep
{
public:
  /**
   * The depth at which a view ray ends that meets nothing.
   */
  static constexpr float Sky = 1e30f;

  /**
   * View coordinates are x to the right, y up, z forwards. Numbers are taken as they are: finite, and
   * in the ranges of vtkGodRaysMediumFilter's setters.
   */
  struct Parameters
  {
    double PixelSize = 0.0; // at depth 1, or of a parallel projection [scene units], above 0
    double Center[2] = { 0.0, 0.0 }; // of the view axis [pixels from the lower left corner]
    bool Parallel = false;           // projection
    double Light[4] = { 0, 1, 0,
      0 }; // (x, y, z)/w, a position, or with w = 0 the direction (x, y, z)
    double LightColor[3] = { 1.0, 1.0, 1.0 }; // irradiance, or intensity of a point light
    vtkGodRaysSpot Spot;                      // of a point light
    vtkGodRaysMedium Medium;
    const vtkGodRaysShadowGrids* Shadows = nullptr; // of occluders; nullptr: nothing blocks
    double LineSpacing = 2.0; // where lines are widest apart [pixels], [0.5, 2]
  };

  vtkGodRaysCoverageSweep();
  ~vtkGodRaysCoverageSweep();
  vtkGodRaysCoverageSweep(const vtkGodRaysCoverageSweep&) = delete;
  void operator=(const vtkGodRaysCoverageSweep&) = delete;

  /**
   * Memory for the view depths at which the view rays of an image of at least 1 x 1 pixels end, rows from
   * the bottom up, without gaps. The caller fills it with numbers above 0 and at most Sky: they are taken
   * as they are, and NaN would spread. It keeps its contents and its place until the size changes.
   */
  float* PrepareInput(int width, int height);

  /**
   * Compute the result of the input; false if there is none. The depths of Shadows are read while the sweep
   * is executed.
   */
  bool Execute(const Parameters& parameters);

  /**
   * Of the result: 1 if red, green and blue are the same, else 3. The second is of the last execution.
   */
  static int CountComponents(const Parameters& parameters);
  int GetNumberOfComponents() const;

  /**
   * Radiances, components interleaved, rows from the bottom up, without gaps, finite and not negative;
   * nullptr before the first execution.
   */
  const float* GetResult() const;

  /**
   * No radiance of the last execution is above this, whatever the depths.
   */
  double GetBound() const;

  /**
   * What the last execution did.
   */
  std::string Describe() const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
