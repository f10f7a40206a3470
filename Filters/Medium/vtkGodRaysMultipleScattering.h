// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMultipleScattering
 * @brief   light that media scatter twice and more, on a coarse grid
 *
 * Private. Single scattering is known better than a grid could tell. Found here is the rest D: radiance is
 * single scattering plus D. Along a view ray, with the functions of vtkGodRaysOrdersMath.glsl,
 *
 *     D = integral of T'(eye) sigma_s [ E T'(light) B(c, n) + (1 - f) S ] ds
 *
 * T' is transmittance with the scaled extinction, E the irradiance of a light with its shadows, c the cosine
 * of the angle to it, n the mean number of events of the forward peak on the way from the light to the eye, S
 * the diffuse radiance that is scattered towards the eye. S comes of moments of the radiance at the nodes of
 * a grid, which discrete ordinates find. Where components differ in their phase functions, S has that of
 * their mixture at each node, f and B that of the mixture in the whole box.
 *
 *     scattering.Update(scene, vtkGodRaysMultipleScattering::Choose(tolerance, depth, g, hasOccluders));
 *     scattering.Contract(eye, forward, false, texture); // for each picture
 *     scattering.Evaluate(texture, eye, direction, end, steps);
 *
 * An object keeps its solution while nothing changes. Bytes do not depend on the number of threads.
 */

#ifndef vtkGodRaysMultipleScattering_h
#define vtkGodRaysMultipleScattering_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysForwardPeak.h"

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysMultipleScattering
{
public:
  using Vec3 = vtkGodRays::Vec3;
  using Scene = vtkGodRaysTransportScene;

  struct Parameters
  {
    int Cells = 16;          // along the longest side of the box, at least 2
    int Directions = 26;     // 14, 26, 50 or 98
    int Degree = 2;          // of moments, [1, 3]
    double Residual = 1e-3;  // at which sweeps end [fraction of the largest mean radiance]
    int MaximumSweeps = 100; // at least 1
  };

  /// S at the nodes of the grid, for one eye: [node][red, green, blue], x fastest; trilinear between them.
  struct Texture
  {
    int Nodes[3] = { 2, 2, 2 };
    Vec3 Low = Vec3(0.0);  // the first node
    Vec3 Cell = Vec3(1.0); // edges
    std::vector<float> Values;
    double ForwardPart = 0.0; // of scattered light, which counts as not scattered, of FindSource()

    /// Beyond the nodes it is that of the outermost ones.
    Vec3 Sample(const Vec3& place) const;
  };

  struct Result
  {
    Vec3 Orders = Vec3(0.0); // D
    Vec3 Broad = Vec3(0.0);  // the part of it that the peak adds
  };

  struct Ray
  {
    Vec3 Origin;
    Vec3 Direction; // of length 1
    double End;     // distance
  };

  vtkGodRaysMultipleScattering();
  ~vtkGodRaysMultipleScattering();
  vtkGodRaysMultipleScattering(const vtkGodRaysMultipleScattering&) = delete;
  void operator=(const vtkGodRaysMultipleScattering&) = delete;

  /// Returns the cheapest parameters that kept a tolerance, an RMS error as a fraction of the brightest
  /// radiance, in most scenes that were measured, by their optical depth and mean cosine of scattering.
  static Parameters Choose(double tolerance, double depth, double asymmetry);

  /// Solves, unless parameters and the scene's Version are those of the last time; returns whether it did.
  bool Update(const Scene& scene, const Parameters& parameters);

  /// Finds S towards an eye that looks forward, a direction of length 1, or, if parallel, against that
  /// direction.
  void Contract(const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const;

  /// Finds all that D has of each place but the scaled extinction between it and the eye: what scattering
  /// there sends towards the eye, for each unit of its coefficient. Light and the peak's events are the means
  /// of nodes.
  void FindSource(const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const;

  const vtkGodRaysForwardPeak& GetPeak() const;

  /// Evaluates D of a view ray in so many steps.
  Result Evaluate(const Texture& texture, const Ray& ray, int steps) const;

  /// Estimates the RMS error of D, which is no bound, for a sample of a picture's view rays [radiance], from
  /// three cheaper solutions, which are kept, too: with half the cells, fewer directions, and a lower degree.
  double Estimate(const std::vector<Ray>& rays, const Vec3& forward, bool parallel, int steps);

  /// How the last solution came about.
  struct Report
  {
    int Sweeps = 0;
    double Residual = 0.0; // see Parameters
  };
  const Report& GetReport() const;

  /// Returns the moments of the diffuse radiance of a colour, [moment][node].
  const std::vector<float>& GetMoments(int color) const;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
