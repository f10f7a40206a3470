// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPowerSum.h
 * @brief   an exponential kernel as a sum of a few powers, which running sums can evaluate
 *
 * Private. At u, the ratio of a sample's distance from the light to the pixel's,
 *
 *     e^(-k t) ~ sum_j Factors[j] u^Powers[j],   u = 1 - d t,   0 <= t <= end
 *
 * with real powers in arithmetic progression. d is the density that remains when the light's
 * distance is the unit: in (0, 1] for a march towards the light, negative for one away from it.
 */

#ifndef vtkGodRaysPowerSum_h
#define vtkGodRaysPowerSum_h

namespace vtkGodRays
{
constexpr int MaximumPowers = 6;

struct PowerSum
{
  int Count = 0;
  double Powers[MaximumPowers] = {};
  double Factors[MaximumPowers] = {};
  /// Of the rays of any image with values in [0, 1] [fraction of those of a white one]; rigorous
  /// but for the quadrature.
  double Bound = 1.0;
};

/**
 * The sum of the fewest powers whose Bound is at most tolerance, or else the best one found.
 * Least squares for fixed powers, a grid and a pattern search over these: some tenths of a
 * millisecond.
 */
PowerSum FitPowerSum(double k, double d, double end, double tolerance);
}

#endif
