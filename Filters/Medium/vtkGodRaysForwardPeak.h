// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysForwardPeak.h
 * @brief   the part of scattered light that goes on nearly straight, and how it spreads
 *
 * Private. The table of the peak function B of vtkGodRaysOrdersMath.glsl, [events][angle]: see PeakPlace().
 */

#ifndef vtkGodRaysForwardPeak_h
#define vtkGodRaysForwardPeak_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysTransportScene.h"

#include <vector> // For std::vector

struct VTKGODRAYSFILTERS_EXPORT vtkGodRaysForwardPeak
{
  static constexpr int Angles = 128;
  static constexpr int Rows = 48;
  double ForwardPart = 0.0; // f; 0: there is no peak, and no table
  double Most = 0.0;        // events of the last row
  std::vector<float> Table;

  /// Returns the Legendre moments of a phase function, of which the first is 1, until they are small.
  static std::vector<double> FindMoments(const vtkGodRaysTransportScene::PhaseMix& phase);

  /// Builds the table from moments, of which those to a degree, below 15, are kept by the scaled phase
  /// function.
  void Build(const std::vector<double>& moments, int degree);

  double Get(double cosAngle, double events) const;
};

#endif
