// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSingleScattering
 * @brief   the light that a medium scatters once along single view rays, to a tolerance
 *
 * Private: what vtkGodRaysSingleScatteringReference does for each pixel of a picture. Triangles block light
 * wherever they are; the plane of a view ray and the light cuts them into the parts of the ray that they
 * hide, and a quadrature adds what is left.
 */

#ifndef vtkGodRaysSingleScattering_h
#define vtkGodRaysSingleScattering_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMedium.h"        // For vtkGodRaysMedium

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class vtkPolyData;
struct vtkGodRaysGrid;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysSingleScattering
{
public:
  struct Parameters
  {
    ///@{
    /// Where the eye is and how it looks; a view ray goes from the eye along Forward + x Right + y Up, or,
    /// Parallel, from there along Forward.
    double Position[3] = { 0.0, 0.0, 0.0 };
    double Right[3] = { 1.0, 0.0, 0.0 };
    double Up[3] = { 0.0, 1.0, 0.0 };
    double Forward[3] = { 0.0, 0.0, 1.0 };
    bool Parallel = false;
    ///@}

    double Light[4] = { 0.0, 1.0, 0.0, 0.0 }; ///< (x, y, z)/w, or with w = 0 a direction
    double LightColor[3] = { 1.0, 1.0, 1.0 }; ///< irradiance, or intensity of a point light
    vtkGodRaysSpot Spot;                      ///< along Right, Up and Forward
    vtkGodRaysMedium Medium;                  ///< alike, seen from Position
    double Tolerance = 1e-6; ///< of each lit part [fraction of the ray without shadows]
  };

  struct Result
  {
    double Radiance[3];
    double Transmittance[3];       // of media between the eye and the ray's end
    double Sight;                  // view depth of the first surface; infinite if there is none
    double LengthPerDepth;         // of the ray
    std::vector<double> Crossings; // with what blocks light, from the eye on [scene units]
  };

  vtkGodRaysSingleScattering();
  ~vtkGodRaysSingleScattering();
  vtkGodRaysSingleScattering(const vtkGodRaysSingleScattering&) = delete;
  void operator=(const vtkGodRaysSingleScattering&) = delete;

  ///@{
  /**
   * What blocks light, and what ends view rays if that is something else: polygons and strips. Null is
   * nothing; without the second, the first ends view rays.
   */
  void SetOccluders(vtkPolyData* occluders);
  void SetSeen(vtkPolyData* seen);
  ///@}

  /**
   * Media of data that there are besides, which shadow themselves, each other and the medium.
   */
  void SetGrids(const std::vector<vtkGodRaysGrid>& grids);

  ///@{
  /// Sheets, besides, that let parts of red, green and blue through, each time that light meets one; they
  /// end no view ray.
  void AddVeil(vtkPolyData* surface, const double through[3]);
  void RemoveAllVeils();
  ///@}

  void SetParameters(const Parameters& parameters);

  /**
   * Evaluate the ray at (x, y). It ends at the first surface, at the medium's FarLimit, or at a view depth,
   * if that is above 0, whatever surfaces there are. Threads may call it together.
   */
  void Evaluate(double x, double y, Result& result, double depth = 0.0) const;

  /**
   * The view depth of the first surface that ends the ray at (x, y); infinite if there is none.
   */
  double FindSight(double x, double y) const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
