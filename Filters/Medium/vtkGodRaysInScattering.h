// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysInScattering
 * @brief   light that a medium scatters once to the eye, with a light's shadow maps, on the processor
 *
 * Private. Fill the input, execute, read the result:
 *
 *     float* depths = scattering.PrepareInput(width, height);
 *     // write depths[y * width + x]
 *     scattering.Execute(parameters);
 *     // read scattering.GetResult()[(y * width + x) * scattering.GetNumberOfComponents() + c]
 *
 * View rays on a grid of 8 x 8 pixels are walked through the maps' pyramids, each to the greatest depth of
 * the cells about it, and leave a list of their shadowed stretches, measured in airlight. A pixel takes the
 * four lists about it at its own depth, so that edges of depth need nothing. Where the four differ by more
 * than the tolerance, the grid is halved there, down to single pixels.
 *
 * An object keeps its memory, pyramids and tables. Not for two threads at a time.
 */

#ifndef vtkGodRaysInScattering_h
#define vtkGodRaysInScattering_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMedium.h"        // For vtkGodRaysMedium

#include <memory>  // For std::unique_ptr
#include <string>  // For std::string
#include <utility> // For std::swap

struct vtkGodRaysShadowGrids;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysInScattering
{
public:
  /// Depth of what is nowhere.
  static constexpr float Sky = 1e30f;

  /// View coordinates are x to the right, y up, z forwards. Numbers are finite.
  struct Parameters
  {
    double PixelSize = 0.0; // at depth 1, or of a parallel projection [scene units], above 0
    double Center[2] = { 0.0, 0.0 }; // of the view axis [pixels from the lower left corner]
    bool Parallel = false;           // projection
    double Light[4] = { 0.0, 1.0, 0.0, 0.0 }; // (x, y, z)/w, or with w = 0 the direction to it
    double LightColor[3] = { 1.0, 1.0, 1.0 }; // irradiance, or intensity of a point light
    vtkGodRaysSpot Spot;                      // of a point light
    vtkGodRaysMedium Medium;
    const vtkGodRaysShadowGrids* Shadows = nullptr; // null: nothing blocks the light
    double Tolerance = 1.0 / 255.0; // of the brightest pixel or of 10 times the mean [fraction]
  };

  vtkGodRaysInScattering();
  ~vtkGodRaysInScattering();
  vtkGodRaysInScattering(const vtkGodRaysInScattering&) = delete;
  void operator=(const vtkGodRaysInScattering&) = delete;

  /// Memory for the view depths at which view rays end: above 0 and at most Sky. It keeps its contents until
  /// the size changes.
  float* PrepareInput(int width, int height);

  /// Exchanges memory, with what is in it.
  void Swap(vtkGodRaysInScattering& other) { std::swap(this->Internals, other.Internals); }

  /// Returns false if there is no input.
  bool Execute(const Parameters& parameters);

  /// How many view rays the last execution walked, for each pixel.
  double GetWalkedPart() const;

  /// Of the last result: 1 if red, green and blue are the same, else 3.
  int GetNumberOfComponents() const;

  /// Radiances, components interleaved, rows from the bottom up, finite and not negative; null before the
  /// first execution.
  const float* GetResult() const;

  /// What the last execution did.
  std::string Describe() const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
