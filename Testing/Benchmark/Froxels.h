// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What games do: a grid of the view's cells, whose columns go away from the eye. Each cell has one sample.
// The light of a column's cells is summed from the eye on, and pixels are interpolated.

#ifndef Froxels_h
#define Froxels_h

#include <algorithm>
#include <cstddef>
#include <vector>

class Froxels
{
public:
  Froxels(int columns, int rows, int slices, int components)
    : Sizes{ columns, rows, slices + 1 }
    , Components(components)
    , Sums(static_cast<std::size_t>(columns) * rows * (slices + 1) * components, 0.0f)
  {
  }

  int GetColumns() const { return this->Sizes[0]; }
  int GetRows() const { return this->Sizes[1]; }
  int GetSlices() const { return this->Sizes[2] - 1; }

  /// The light that reaches the eye from before each end of the slices of a column, the nearest one first,
  /// components interleaved; 0 at first.
  float* GetSums(int column, int row) { return this->Sums.data() + this->GetIndex(column, row, 0); }

  /// Read it at a place of the picture [fractions of its width and height] and a depth [slices].
  void Read(double x, double y, double slice, float* values) const
  {
    const double places[3] = { x * this->Sizes[0] - 0.5, y * this->Sizes[1] - 0.5, slice };
    int low[3];
    float shares[3][2];
    for (int a = 0; a < 3; ++a)
    {
      const double place = std::min(std::max(places[a], 0.0), this->Sizes[a] - 1.0);
      low[a] = std::min(static_cast<int>(place), this->Sizes[a] - 2);
      shares[a][1] = static_cast<float>(place - low[a]);
      shares[a][0] = 1.0f - shares[a][1];
    }
    std::fill_n(values, this->Components, 0.0f);
    for (int corner = 0; corner < 8; ++corner)
    {
      const int up[3] = { corner & 1, corner >> 1 & 1, corner >> 2 };
      const float weight = shares[0][up[0]] * shares[1][up[1]] * shares[2][up[2]];
      const float* sum =
        this->Sums.data() + this->GetIndex(low[0] + up[0], low[1] + up[1], low[2] + up[2]);
      for (int c = 0; c < this->Components; ++c)
      {
        values[c] += weight * sum[c];
      }
    }
  }

private:
  std::size_t GetIndex(int column, int row, int end) const
  {
    return ((static_cast<std::size_t>(row) * this->Sizes[0] + column) * this->Sizes[2] + end) *
      this->Components;
  }

  int Sizes[3]; // columns, rows, ends of slices
  int Components;
  std::vector<float> Sums;
};

#endif
