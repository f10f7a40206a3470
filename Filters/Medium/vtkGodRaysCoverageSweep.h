// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysCoverageSweep
 * @brief   the work of vtkGodRaysCoverageFilter, for clients without a pipeline
 *
 * Private. Fill the input, execute, read the result:
 *
 *     vtkGodRaysCoverageSweep::Planes input = sweep.PrepareInput(width, height, planes);
 *     // write input.Values[i][y * input.Stride + x]
 *     sweep.Execute(parameters);
 *     // read sweep.GetResult()[(y * width + x) * sweep.GetNumberOfComponents() + c]
 *
 * An object keeps its memory, its plan and its tables: an execution like the one before allocates
 * nothing (what vtkSMPTools needs for its threads aside) and plans nothing. Not for two threads at a
 * time.
 *
 * @sa vtkGodRaysCoverageFilter
 */

#ifndef vtkGodRaysCoverageSweep_h
#define vtkGodRaysCoverageSweep_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMedium.h"        // For vtkGodRaysMedium

#include <cstddef>    // For std::ptrdiff_t
#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string

struct vtkGodRaysShadowGrids;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysCoverageSweep
{
public:
  static constexpr int MaximumLayers = 2;
  static constexpr int MaximumPlanes = 2 * MaximumLayers + 1;

  /**
   * The depth of what is nowhere, in every plane.
   */
  static constexpr float Sky = 1e30f;

  /**
   * View coordinates are x to the right, y up, z forwards. Numbers are taken as they are: finite, and
   * in the ranges of vtkGodRaysCoverageFilter's setters.
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
    const vtkGodRaysShadowGrids* Shadows = nullptr; // of occluders; nullptr: the input has them
    int Layers = 0;                                 // of solid matter; 0: the first surfaces alone
    double LineSpacing = 2.0; // where lines are widest apart [pixels], [0.5, 2]
    double Thickness = 0.01;  // of what has no back [fraction of its depth]
  };

  /**
   * Where the input goes: pixel (x, y) of plane i is Values[i][y * Stride + x].
   */
  struct Planes
  {
    float* Values[MaximumPlanes] = {};
    std::ptrdiff_t Stride = 0;
  };

  /**
   * Told the progress [fraction], on the calling thread; returns whether to go on.
   */
  using Monitor = std::function<bool(double)>;

  vtkGodRaysCoverageSweep();
  ~vtkGodRaysCoverageSweep();
  vtkGodRaysCoverageSweep(const vtkGodRaysCoverageSweep&) = delete;
  void operator=(const vtkGodRaysCoverageSweep&) = delete;

  /**
   * Memory for view depths of an image of at least 1 x 1 pixels, which the caller fills with numbers
   * above 0 and at most Sky: they are taken as they are, and NaN would spread. Without layers: the
   * first surface that blocks light; with layers their fronts and backs in turn, the nearest layer
   * first. One plane more holds where view rays end, which without it is the first plane: for things
   * that are seen but cast no shadow, or the other way round. The memory keeps its contents and its
   * place until the size or the number of planes changes.
   *
   * With Shadows there is one plane, where view rays end. The grids' depths are read while the sweep is
   * executed.
   */
  Planes PrepareInput(int width, int height, int planes);

  /**
   * Where the next executions write, width x height x components floats; nullptr, the default, is the
   * object's own memory.
   */
  void SetResult(float* values);

  /**
   * Compute the result of the input; false if there is none or not what Layers takes, or if
   * the monitor stopped it: then the result is of no use.
   */
  bool Execute(const Parameters& parameters, const Monitor& monitor = nullptr);

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
   * How many hidden intervals found no room in the last execution.
   */
  long long GetNumberOfOverflows() const;

  /**
   * What the last execution did.
   */
  std::string Describe() const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
