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

#include <initializer_list>

struct vtkGodRaysMedium
{
  struct Component
  {
    double Scattering[3] = { 0.0, 0.0, 0.0 }; // where the density is 1 [1/scene unit], at least 0
    double Absorption[3] = { 0.0, 0.0, 0.0 };
    int PhaseFunction = 0;  // vtkGodRaysMediumFilter::PhaseFunctionType
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
  double Up[3] = { 0.0, 1.0, 0.0 }; // where densities fall, in view coordinates; length 1
  double EyeHeight = 0.0;           // above the plane where densities are 1
  double FarLimit = 100.0;          // where the medium ends [view depth]

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
  bool ThinsOut() const
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
