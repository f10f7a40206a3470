// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysMedium.h
 * @brief   what scatters and absorbs light between things, in numbers
 *
 * Private. One or two components, e.g. molecules and dust, each of a density that is 1 everywhere or
 * falls with the height above a plane as e^(-height/ScaleHeight). Lengths are in scene units.
 */

#ifndef vtkGodRaysMedium_h
#define vtkGodRaysMedium_h

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

/// The cone of a point light, as vtkLight has it.
struct vtkGodRaysSpot
{
  double Axis[3] = { 0.0, 0.0, 1.0 }; // in view coordinates; length 1
  double CosCone = 0.0;               // cosine of half its angle; 0: it shines everywhere alike
  double Exponent = 0.0;

  bool IsCone() const { return this->CosCone > 0.0; }
  bool Fades() const { return this->IsCone() && this->Exponent > 0.0; }

  /// Give a LitRay of the formulas what does not depend on where the ray lies.
  template <typename LitRay>
  void SetShape(LitRay& ray) const
  {
    ray.Shape.CosCone = this->CosCone;
    ray.Shape.Exponent = this->Exponent;
  }
};

struct vtkGodRaysMedium
{
  struct Component
  {
    double Scattering[3] = { 0.0, 0.0, 0.0 }; // where the density is 1 [1/scene unit], at least 0
    double Absorption[3] = { 0.0, 0.0, 0.0 };
    int PhaseFunction = 0;  // see vtkGodRaysPhaseFunction.h
    double Asymmetry = 0.0; // [-0.99, 0.99]
    int SecondPhaseFunction =
      0; // the phase function is (1 - SecondWeight) first + SecondWeight second
    double SecondAsymmetry = 0.0;
    double SecondWeight = 0.0; // [0, 1]
    double ScaleHeight = 0.0;  // 0: homogeneous
  };

  static constexpr int MaximumComponents = 2;
  int NumberOfComponents = 1;
  Component Components[MaximumComponents];
  double Up[3] = { 0.0, 1.0,
    0.0 };                   // where densities fall at the eye, in view coordinates; length 1
  double EyeHeight = 0.0;    // above where densities are 1
  double PlanetRadius = 0.0; // of the ground where they are; 0: it is a plane
  double FarLimit = 100.0;   // where the medium ends [view depth]

  /// Place an eye, in the coordinates of the world: up, of length 1, is the vertical of the origin,
  /// groundLevel the coordinate along it of the ground there. vertical is that of the eye, in the world;
  /// Up is for the caller, who knows its own view.
  void PlaceEye(const double eye[3], const double up[3], double groundLevel, double vertical[3])
  {
    const double along = eye[0] * up[0] + eye[1] * up[1] + eye[2] * up[2];
    this->EyeHeight = along - groundLevel;
    std::copy_n(up, 3, vertical);
    if (this->PlanetRadius > 0.0)
    {
      const double above = this->PlanetRadius + this->EyeHeight;
      double aside[3];
      for (int i = 0; i < 3; ++i)
      {
        aside[i] = eye[i] - along * up[i];
      }
      const double square = aside[0] * aside[0] + aside[1] * aside[1] + aside[2] * aside[2];
      const double radius = std::max(std::sqrt(above * above + square), 1e-300);
      this->EyeHeight =
        above > 0.0 ? this->EyeHeight + square / (above + radius) : radius - this->PlanetRadius;
      for (int i = 0; i < 3; ++i)
      {
        vertical[i] = (above * up[i] + aside[i]) / radius;
      }
    }
  }

  /// Make it denser or thinner.
  void Scale(double factor)
  {
    for (int i = 0; i < this->NumberOfComponents; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Components[i].Scattering[c] *= factor;
        this->Components[i].Absorption[c] *= factor;
      }
    }
  }

  /// Convert all lengths but FarLimit from metres to a unit of so many metres.
  void ConvertTo(double unit)
  {
    this->Scale(unit);
    for (int i = 0; i < this->NumberOfComponents; ++i)
    {
      this->Components[i].ScaleHeight /= unit;
    }
    this->EyeHeight /= unit;
    this->PlanetRadius /= unit;
  }

  /// Whether red, green and blue are alike.
  bool IsGrey() const
  {
    for (int i = 0; i < this->NumberOfComponents; ++i)
    {
      for (const double* c : { this->Components[i].Scattering, this->Components[i].Absorption })
      {
        if (c[0] != c[1] || c[1] != c[2])
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Whether its density falls with height.
  bool HasExponentialDensity() const
  {
    for (int i = 0; i < this->NumberOfComponents; ++i)
    {
      if (this->Components[i].ScaleHeight > 0.0)
      {
        return true;
      }
    }
    return false;
  }
};

#endif
