// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysDiffuseLight
 * @brief   light that a medium scatters twice and more, of one picture; private to this module
 *
 * Each light has a small shadow map of all occluders, wherever the camera is. All orders are solved anew when
 * a map, a light, the medium or the scene's bounds change. The solution is summed along view rays anew when
 * the camera moves. Otherwise both are kept.
 *
 * Air fills the visible props' bounds and a quarter of their diagonal about them; beyond that box its light
 * is that of the box's faces. Occluders are walls in the lattice by the area of their surfaces, and black.
 */

#ifndef vtkGodRaysDiffuseLight_h
#define vtkGodRaysDiffuseLight_h

#include "vtkGodRaysFroxels.h"
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysMultipleScattering.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysTarget.h"

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

class vtkGodRaysGridPicture;
class vtkWindow;

class vtkGodRaysDiffuseLight
{
public:
  vtkGodRaysDiffuseLight();

  /**
   * Start a frame without lights.
   */
  void Begin();

  /**
   * Take a light of the frame, and what data leave of it, null without data. Returns false, after an error,
   * if its map cannot be drawn.
   */
  bool AddLight(
    const vtkGodRaysMediumIntegrator::Request& request, const vtkGodRaysGridPicture* data);

  /**
   * Solve for all lights of the frame, if something has changed, and sum along the request's view rays.
   * bounds are those of the visible props, dataVersion changes with the grids. estimates tells whether the
   * error is to be estimated, too, which takes twice as long as the solution.
   */
  void Find(const vtkGodRaysMediumIntegrator::Request& request, const double bounds[6],
    const std::vector<vtkGodRaysGrid>& grids, unsigned int dataVersion, bool estimates);

  /**
   * Add the light of the air, without data, to the request's result. Returns false, after an error, if that
   * failed.
   */
  bool Add(const vtkGodRaysMediumIntegrator::Request& request);

  ///@{
  /// What Find() found: that of air, null without air, and what data scatter, null without data.
  const vtkGodRaysFroxels* GetAir() const { return this->HasAir ? &this->Froxels : nullptr; }
  const vtkGodRaysFroxels::Source* GetData() const
  {
    return this->HasData ? &this->Source : nullptr;
  }
  ///@}

  /**
   * Returns whether the last frame had any.
   */
  bool HasLight() const { return !this->Scene.Lights.empty(); }

  /**
   * What was done, for the plan; empty if nothing was.
   */
  std::string Describe() const;

  void Release(vtkWindow* window);

private:
  /// What a solution depends on: numbers that have to be the same, and places, but for rounding.
  struct State
  {
    std::vector<double> Numbers;
    std::vector<double> Places; // [diagonals of the box]
    bool IsSame(const State& other) const;
  };

  void SetBox(const double bounds[6]);
  void Choose(double tolerance);
  State GetState(unsigned int dataVersion) const;
  void Solve(const vtkGodRaysMediumIntegrator::Request& request, bool estimates);
  void Estimate(const vtkGodRaysMediumIntegrator::Request& request);
  void Sum(const vtkGodRaysMediumIntegrator::Request& request);

  struct Light
  {
    vtkGodRaysShadowMap Map;
    std::vector<vtkGodRaysShadowGrids> Layers; // of the map
  };
  std::deque<Light> Lights; // in the frame's order
  vtkGodRaysTransportScene Scene;
  vtkGodRaysMultipleScattering::Parameters Parameters;
  vtkGodRaysMultipleScattering Solution;
  State Solved;
  std::vector<double> View; // that the sums are of
  vtkGodRaysFroxels::Source Source;
  vtkGodRaysFroxels Froxels;
  bool HasAir = false;
  bool HasData = false;
  bool Changed = false; // a map of this frame was drawn anew
  bool Kept = false;
  double Seconds = 0.0; // that the last solution took
  double Error = -1.0;  // estimated, root mean square [fraction of the brightest]; -1: unknown
  vtkGodRaysQuad Quad;
  vtkGodRaysTarget Image;        // of the froxels
  unsigned int ImageVersion = 0; // with the froxels that there are; 0: not yet sent
};

#endif
