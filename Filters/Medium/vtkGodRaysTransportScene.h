// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysTransportScene.h
 * @brief   media, lights and occluders for light that is scattered more than once
 *
 * Private. The input of vtkGodRaysMultipleScattering and of its reference. All is in one system of
 * coordinates, say that of the world; Medium is as an eye in its origin has it.
 */

#ifndef vtkGodRaysTransportScene_h
#define vtkGodRaysTransportScene_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysMedium.h"

#include <functional>
#include <vector>

class vtkGodRaysGridLight;

struct VTKGODRAYSFILTERS_EXPORT vtkGodRaysTransportScene
{
  using Vec3 = vtkGodRays::Vec3;
  static constexpr int MaximumComponents = 16;

  struct Light
  {
    Vec3 Position = Vec3(0.0, 1.0, 0.0); // or, of a directional light, the direction to it
    bool Directional = true;
    Vec3 Color = Vec3(1.0); // irradiance, or intensity of a point light
    vtkGodRaysSpot Spot;    // of a point light
    /// Returns the part of the light that occluders let through to a place; null: all of it.
    std::function<Vec3(const Vec3& place)> Visibility;
    /// The light's depths in each of Grids; they are found, if this is empty.
    std::vector<const vtkGodRaysGridLight*> Depths;
  };

  Vec3 Low = Vec3(0.0); // corners of the box that has all media [scene units]
  Vec3 High = Vec3(1.0);
  vtkGodRaysMedium Medium; // may have no component; PlanetRadius and FarLimit are not looked at
  std::vector<vtkGodRaysGrid> Grids;
  std::vector<Light> Lights;
  /// Tells whether homogeneous components dim a directional light from the box on. They do not where
  /// Color is the irradiance everywhere, as in pictures of single scattering.
  bool SunIsDimmed = false;
  /// Returns the albedo of the occluder that a place is inside of; below 0: none. Null: there are none.
  std::function<double(const Vec3& place)> Solid;
  /// Fills in what part of the light that goes through each node black occluders stop, of the grid that
  /// begins at low; x is fastest. Null: Solid tells.
  std::function<void(
    const int nodes[3], const Vec3& low, const Vec3& cell, std::vector<float>& cover)>
    Cover;
  /// The albedo of the box's faces, from inside: -x, +x, -y, +y, -z, +z. Light leaves and enters where it is
  /// 0; other faces are opaque. A ground is a face.
  double FaceAlbedo[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  /// To be another one whenever anything of the scene is.
  unsigned long Version = 0;

  struct PhaseMix
  {
    vtkGodRays::PhaseFunction First;
    vtkGodRays::PhaseFunction Second;
    double SecondWeight;

    double Get(double cosAngle) const
    {
      return vtkGodRays::PhaseMix(this->First, this->Second, this->SecondWeight, cosAngle);
    }
  };

  ///@{
  /// The components of all media, those of Medium first.
  int GetNumberOfComponents() const
  {
    return this->Medium.NumberOfComponents + static_cast<int>(this->Grids.size());
  }
  PhaseMix GetPhase(int component) const;
  ///@}

  using Point = vtkGodRaysGrid::Point; // coefficients
  /// Returns those of a component at a place.
  Point Sample(int component, const Vec3& place) const;

  /// Returns the irradiance of a light without media and occluders, across the direction towards it, of
  /// length 1. The distance is infinite for a directional light.
  Vec3 GetIrradiance(const Light& light, const Vec3& place, Vec3& towards, double& distance) const;

  /// Returns the optical depth of a component of Medium from a place in the box to a light.
  Vec3 GetDepth(int component, const Light& light, const Vec3& place, const Vec3& towards,
    double distance) const;

  /// Cuts a line, from begin to end, to what is in the box, and returns the face by which it leaves; -1 if it
  /// ends before, or if nothing is left of it.
  int Clip(const Vec3& origin, const Vec3& direction, double& begin, double& end) const;
};

#endif
