// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysOrdinates
 * @brief   transport of light along directions that go from node to node of a regular grid
 *
 * Private to vtkGodRaysMultipleScattering. Directions are moves by whole cells, so that radiance needs no
 * interpolation on its way and is not smeared. At the half-way points of moves by two cells the medium is the
 * mean of the 2 or 4 nodes about them. Lengths have any unit, extinction its reciprocal.
 *
 * Radiance at nodes is kept as its moments with the real spherical harmonics Y_lm, to a degree of 3 at most,
 * in the order (0,0), (1,-1), (1,0), (1,1), (2,-2), ...
 */

#ifndef vtkGodRaysOrdinates_h
#define vtkGodRaysOrdinates_h

#include "vtkGodRaysMath.h"

#include <cstddef>
#include <vector>

class vtkGodRaysOrdinates
{
public:
  using Vec3 = vtkGodRays::Vec3;
  static constexpr int MaximumMoments = 16;

  /// A node with an occluder in its volume, or on a face of the grid that reflects light. Its faces are -x,
  /// +x, -y, +y, -z, +z, by where they look.
  struct Wall
  {
    std::size_t Node;
    float Kept;      // the part of the light that passes [0, 1]
    float Albedo;    // of its faces
    bool IsFace;     // of the grid: what it sends enters there
    bool IsFree[6];  // whether a face sees light and reflects it
    float Direct[6]; // irradiance of the light that was never scattered
  };

  /// Finds the harmonics of a direction of length 1.
  static void GetHarmonics(const Vec3& direction, int degree, float* harmonics);

  /// Sets the number of directions, 14, 26, 50 or 98, of nodes along each axis, at least 2, and the cell's
  /// edges. Weights integrate polynomials over all directions exactly, to degree 2, 4, 6 or 8; of those that
  /// do, they differ least from the weights for cubes.
  void SetGrid(int directions, const int nodes[3], const Vec3& cell);
  void SetWalls(const std::vector<Wall>& walls);

  /// The irradiance of walls' faces, [wall][face], without the direct one: what Sweep() takes and leaves.
  std::vector<float>& GetIrradiance() { return this->Irradiance; }

  /// Sends light through the grid once. Extinction is that of each node, emission the moments of what it adds
  /// for each unit of length, [moment][node], result the moments of the radiance. Bytes do not depend on the
  /// number of threads.
  void Sweep(const float* extinction, const float* emission, int degree, float* result);

private:
  struct Direction
  {
    int Move[3];   // [cells]
    Vec3 Along;    // of length 1
    double Weight; // [sr]
    double Length; // of the move
  };
  void SweepDirection(std::size_t direction, const float* extinction, const float* emission);
  void SendFromWalls();
  void GatherAtWalls();

  int Nodes[3] = { 2, 2, 2 };
  std::size_t Size = 8; // nodes
  std::vector<Direction> Directions;
  std::vector<float> Radiance; // [direction][node]
  std::vector<Wall> Walls;
  std::vector<int> WallOf;       // of each node, or -1; empty without walls
  std::vector<float> Kept;       // of each node; empty without walls
  std::vector<float> Irradiance; // [wall][face]
  std::vector<float> Sent;       // [direction][wall]
  std::vector<float> Received;   // the same
};

#endif
