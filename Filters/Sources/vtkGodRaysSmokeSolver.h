// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSmokeSolver.h
 * @brief   smoke that cells of a grid exchange with their neighbours
 *
 * Private. In each step, a cell gives a share of what it holds to each neighbour. With F the density,
 * a_i the share that is given ahead along axis i, and b_i the one that is given back,
 *
 *     F' = F - F sum_i (a_i + b_i) + sum_i (a_i F_behind + b_i F_ahead)          [Zucconi2016]
 *
 * where the print has + F sum: what a cell gives has to leave it, or mass grows. Shares are those of
 * the hybrid scheme for diffusion D and velocity v, with cells of width h and steps of dt [Spalding1972]:
 *
 *     a = dt max(v/h, D/h^2 + v/2h, 0),   b = dt max(-v/h, D/h^2 - v/2h, 0)
 *
 * They are never negative, and a - b = v dt/h exactly. So the density stays positive for each dt at
 * which no cell gives more than it has. Where |v| h > 2 D, the scheme diffuses as if D were |v| h/2.
 *
 * Velocity: rise, sway along x, and eddies. Each component varies in time and along the two other
 * axes only, so that the flow has no divergence, in the exchange as well, and the shares are three
 * tables, each of two dimensions.
 */

#ifndef vtkGodRaysSmokeSolver_h
#define vtkGodRaysSmokeSolver_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkGodRaysSmokeSolver
{
public:
  // Units and ranges are those of vtkGodRaysSmokeSource.
  struct Parameters
  {
    std::array<int, 3> Dimensions;
    double Spacing;
    double TimeStep;
    double Diffusivity;
    double RiseSpeed;
    double SwaySpeed;
    double SwayPeriod;
    double Turbulence;
    double TurbulenceSize;
    double Dissipation;
    double MinimumDensity;
    std::array<double, 3> SourceCenter; // from the centre of the first cell
    double SourceRadius;
    double SourceRate;
    double SourceDuration;
    bool ClosedBoundaries;
    unsigned int Seed;
  };

  /**
   * The longest stable time step [s]: no cell gives more than it has. Infinite if nothing moves.
   */
  static double GetLargestTimeStep(const Parameters& parameters);

  /**
   * Begins again: no smoke, at step 0.
   */
  void Start(const Parameters& parameters);

  /**
   * One step. Bytes do not depend on the number of threads.
   */
  void Advance();

  // The number of steps that were done.
  vtkIdType GetStep() const { return this->Step; }
  // Density of cells, x fastest.
  const std::vector<float>& GetDensity() const { return this->Density; }
  // Whether there is a cell that the source fills.
  bool HasSource() const { return !this->Source.empty(); }

private:
  struct SourceCell
  {
    std::size_t Index;
    double Coverage; // fraction of the cell's width
  };
  struct Shares
  {
    std::vector<float> Ahead;
    std::vector<float> Back;
  };

  void FindSource();
  void ComputeShares(int axis);
  void Exchange(vtkIdType beginRow, vtkIdType endRow);
  void Emit();

  Parameters Setup = {};
  vtkIdType Step = 0;
  std::vector<float> Density;
  std::vector<float> Next;
  std::vector<float> Zeros; // a row
  std::array<Shares, 3> Given;
  std::vector<SourceCell> Source;
};

#endif
