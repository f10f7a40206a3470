// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialSweep
 * @brief   the work of vtkGodRaysScatteringFilter, for clients without a pipeline
 *
 * Private. Fill the input, execute, read the result:
 *
 *     vtkGodRaysRadialSweep::Planes input = sweep.PrepareInput(width, height, components);
 *     // write input.Values[c][y * input.Stride + x]
 *     sweep.Execute(parameters);
 *     // read sweep.GetResult(c)[y * width + x]
 *
 * An object keeps its memory and its plan: an execution like the one before allocates nothing (what
 * vtkSMPTools needs for its threads aside) and plans nothing. Not for two threads at a time.
 *
 * @sa vtkGodRaysScatteringFilter
 */

#ifndef vtkGodRaysRadialSweep_h
#define vtkGodRaysRadialSweep_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMarch.h"         // For vtkGodRaysMarchParameters

#include <cstddef>    // For std::ptrdiff_t
#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysRadialSweep
{
public:
  static constexpr int MaximumComponents = 4;

  enum MethodType
  {
    AUTOMATIC = 0,
    SWEEP = 1,
    TAPS = 2
  };

  /**
   * What vtkGodRaysScatteringFilter's setters of the same names take, in their ranges.
   */
  struct Parameters : vtkGodRaysMarchParameters
  {
    double ErrorTolerance = 1.0 / 255.0;
    int Method = AUTOMATIC;

    bool operator==(const Parameters& other) const;
    bool operator!=(const Parameters& other) const { return !(*this == other); }
  };

  /**
   * Where the input's components go: pixel (x, y) of c is Values[c][y * Stride + x]. Nothing else
   * of the memory may be written.
   */
  struct Planes
  {
    float* Values[MaximumComponents] = {};
    std::ptrdiff_t Stride = 0;
  };

  /**
   * Told the progress [fraction], on the calling thread; returns whether to go on.
   */
  using Monitor = std::function<bool(double)>;

  vtkGodRaysRadialSweep();
  ~vtkGodRaysRadialSweep();
  vtkGodRaysRadialSweep(const vtkGodRaysRadialSweep&) = delete;
  void operator=(const vtkGodRaysRadialSweep&) = delete;

  /**
   * Memory for an image of at least 1 x 1 pixels and of 1 to MaximumComponents components, which the
   * caller fills with numbers in [0, 65504]: they are taken as they are, and NaN would spread. Rows
   * begin at lines of the cache. It keeps its contents and its place until the size changes.
   */
  Planes PrepareInput(int width, int height, int components);

  ///@{
  /**
   * The same, filled from interleaved components of any values: bytes count as value/255, NaN and
   * negative numbers as 0, those above the largest float as that.
   */
  void LoadInput(const unsigned char* pixels, int width, int height, int components);
  void LoadInput(const float* pixels, int width, int height, int components);
  void LoadInput(const double* pixels, int width, int height, int components);
  ///@}

  /**
   * Where the next executions write a component, width x height floats; nullptr, the default, is the
   * object's own memory.
   */
  void SetResult(int component, float* values);

  /**
   * Compute the result of the input; false if there is none, or if the monitor stopped it: then the
   * result is of no use. The monitor is asked up to steps times, each of which costs a start of the
   * threads; where taps are summed, up to 20 times at least.
   */
  bool Execute(const Parameters& parameters, const Monitor& monitor = nullptr, int steps = 1);

  /**
   * Rows of a component from the bottom up, without gaps, finite and not negative; nullptr before
   * the first execution.
   */
  const float* GetResult(int component) const;

  /**
   * What the last execution did and why.
   */
  std::string Describe() const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
