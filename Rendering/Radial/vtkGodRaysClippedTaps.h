// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysClippedTaps
 * @brief   the converged radial sum by taps along the part of each march within the layer; private
 *
 * Evaluates what vtkGodRaysBlockMeans evaluates, of any parameters, in one pass: taps in the middle
 * of equal steps, their weights exact, as many for each pixel as its march has pixels within the
 * layer, times what the tolerance asks for. Where marches are long, it costs many times as much.
 */

#ifndef vtkGodRaysClippedTaps_h
#define vtkGodRaysClippedTaps_h

#include "vtkGodRaysQuad.h"
#include "vtkGodRaysRadialIntegrator.h" // For Request

#include <string>

class vtkGodRaysClippedTaps
{
public:
  vtkGodRaysClippedTaps();

  /**
   * Add the light of one layer to the result, to request.ErrorTolerance (root mean square, of the
   * peak). The march is the request's, of a vtkGodRaysRadialModel. Returns false, after an error, if that
   * failed.
   */
  bool Integrate(const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march);

  /// How many taps a picture takes to a tolerance, about.
  static double CountTaps(const vtkGodRaysMarch& march, double tolerance);

  /// What the last Integrate() did, in one line.
  std::string Describe() const;

  void Release();

private:
  vtkGodRaysQuad Quad;
  double TapsPerPixel = 0.0;
};

#endif
