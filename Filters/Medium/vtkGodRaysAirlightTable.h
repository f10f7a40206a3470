// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAirlightTable
 * @brief   a table of airlight along the view rays of a picture
 *
 * Private. Rays through a grid of the picture, and along each of them nodes of a cubic Hermite spline, placed
 * so that light comes about evenly from between them; bilinear between the rays. Where that would be off,
 * e.g. next to a lamp or at a planet's limb, there are more rays, up to those of all pixels. The integrand is
 * that of the shared formulas, without a spotlight's cone and fade and a planet's shadow.
 */

#ifndef vtkGodRaysAirlightTable_h
#define vtkGodRaysAirlightTable_h

#include "vtkGodRaysAirlightScene.h"

#include <cstdint>       // For std::int64_t
#include <string>        // For std::string
#include <unordered_map> // For std::unordered_map
#include <vector>        // For std::vector

class vtkGodRaysAirlightTable
{
public:
  static constexpr int MaximumPlanes = 6;

  /// Nothing is done where the table is that of the scene.
  void Prepare(const vtkGodRaysAirlightScene& scene);

  void Clear() { this->Key.clear(); }
  std::string Describe() const;

  /**
   * Airlight up to distances, as fractions of the whole ray's.
   * @param values  of places; planes are a stride apart
   */
  void Evaluate(int count, const float* x, const float* y, const float* distances, float* values,
    int stride) const;

  /// Airlight of the whole ray of a pixel; of a point light, as a fraction of that without extinction.
  void GetTotals(float x, float y, float* totals) const;

private:
  struct Ladder // along a ray
  {
    float Begin;   // [scene units], or of a point light's coordinate
    float Inverse; // of its length
    // The end of a point light's; else c of u = x/(x + c (1 - x)): half of the light comes from before u =
    // 1/2.
    float Bend;
  };
  struct Cell // of the picture, between four rays
  {
    int Corners[4]; // rays
    int Child;      // the first of four cells within it, or -1
  };
  struct Place // on a view ray
  {
    float Distance;
    float Coordinate; // of a point light; First to Last is the whole ray, Early the weight of First
    float First;
    float Last;
    float Early;

    void FindWeight();
  };
  struct Sampler;

  void MakeTable();
  void MakeRays();
  void MakeLadder(int ray, double x, double y);
  void Refine();
  void Split(int cell, int x, int y, int side);
  int FindRay(int x, int y);
  float GetDifference(int ray, const int* others, int count) const;
  const Cell& FindCell(float x, float y, float& u, float& v) const;
  float GetNode(int ray, const Place& place) const;
  void EvaluateSome(int count, const float* x, const float* y, const float* distances,
    float* values, int stride) const;
  void MakeKey(std::vector<double>& key) const;

  vtkGodRaysAirlightScene Setup;
  int Spacing = 16; // of the table's rays [pixels]
  int Columns = 0;
  int Rows = 0;
  std::vector<Ladder> Ladders;
  std::vector<float> Nodes;  // of rays, of nodes, of planes: value and slope, of the whole ray's
  std::vector<float> Totals; // of rays, of planes
  std::vector<float> Units;  // of rays: what totals are fractions of
  std::vector<int> Pixels;   // of rays, two each
  std::vector<Cell> Cells;   // those of the coarsest grid first
  std::unordered_map<std::int64_t, int> Finer; // rays by pixels
  std::vector<double> Key;
  std::vector<double> NewKey;
};

#endif
