// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridBlocks.h
 * @brief   where a medium of data is empty, and its numbers between points, in single precision
 *
 * Private.
 */

#ifndef vtkGodRaysGridBlocks_h
#define vtkGodRaysGridBlocks_h

#include "vtkGodRaysGrid.h"
#include "vtkSMPTools.h"

#include <algorithm>

// The least and the largest extinction in each block of cells.
class vtkGodRaysGridBlocks
{
public:
  using Vec2 = vtkGodRays::Vec2;
  using Vec3 = vtkGodRays::Vec3;
  static constexpr int BlockSize = 8; // cells along each axis

  explicit vtkGodRaysGridBlocks(const vtkGodRaysGrid& grid)
    : Scale(grid.Scale)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Size[i] = (grid.Points[i] - 2) / BlockSize + 1;
    }
    this->Ranges.resize(static_cast<std::size_t>(this->Size[0]) * this->Size[1] * this->Size[2]);
    vtkSMPTools::For(0, this->Size[2],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int k = static_cast<int>(begin); k < end; ++k)
        {
          for (int j = 0; j < this->Size[1]; ++j)
          {
            for (int i = 0; i < this->Size[0]; ++i)
            {
              this->Ranges[this->GetBlock(i, j, k)] = FindRange(grid, i, j, k);
            }
          }
        }
      });
  }

  // The range of the block that holds a place of a line, origin + s steps, and where the line leaves it,
  // beyond s. A place that lies on a face, as far as rounding tells, is in the block that the line goes to: a
  // line along a face would else leave a block where it enters it, forever.
  Vec2 Get(const Vec3& place, const Vec3& origin, const Vec3& steps, double s, double& exit) const
  {
    int block[3];
    exit = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
    {
      block[i] = std::clamp(static_cast<int>(place[i]) / BlockSize, 0, this->Size[i] - 1);
      if (steps[i] != 0.0)
      {
        const auto leave = [&]
        { return ((block[i] + (steps[i] > 0.0 ? 1 : 0)) * BlockSize - origin[i]) / steps[i]; };
        double face = leave();
        if (face <= s)
        {
          block[i] = std::clamp(block[i] + (steps[i] > 0.0 ? 1 : -1), 0, this->Size[i] - 1);
          face = leave();
        }
        exit = face > s ? std::min(exit, face) : exit;
      }
    }
    const Range& range = this->Ranges[this->GetBlock(block[0], block[1], block[2])];
    return this->Scale * Vec2(range.Low, range.High);
  }

  // How many bytes its numbers take.
  std::size_t GetSize() const { return this->Ranges.size() * sizeof(Range); }

private:
  struct Range // of a block's numbers, before Scale
  {
    float Low;
    float High;
  };

  std::size_t GetBlock(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * this->Size[1] + j) * this->Size[0] + i;
  }

  static Range FindRange(const vtkGodRaysGrid& grid, int i, int j, int k)
  {
    const int first[3] = { i * BlockSize, j * BlockSize, k * BlockSize };
    float low = std::numeric_limits<float>::max();
    float high = 0.0f;
    const int last[3] = { std::min(first[0] + BlockSize, grid.Points[0] - 1),
      std::min(first[1] + BlockSize, grid.Points[1] - 1),
      std::min(first[2] + BlockSize, grid.Points[2] - 1) };
    for (int c = first[2]; c <= last[2]; ++c)
    {
      for (int b = first[1]; b <= last[1]; ++b)
      {
        if (grid.Table)
        {
          grid.Table->AddRange(grid.GetPoint(first[0], b, c), last[0] - first[0] + 1, low, high);
          continue;
        }
        const float* values = grid.Extinction + grid.Bands * grid.GetPoint(first[0], b, c);
        const int count = grid.Bands * (last[0] - first[0] + 1);
        for (int a = 0; a < count; ++a)
        {
          low = std::min(low, values[a]);
          high = std::max(high, values[a]);
        }
      }
    }
    return { low, high };
  }

  int Size[3];
  std::vector<Range> Ranges;
  double Scale;
};

// A place between the points of a grid, for several arrays.
class vtkGodRaysGridPlace
{
public:
  vtkGodRaysGridPlace(const vtkGodRaysGrid& grid, const vtkGodRays::Vec3& place)
  {
    std::ptrdiff_t cell[3];
    for (int i = 0; i < 3; ++i)
    {
      const double x = std::clamp(place[i], 0.0, grid.Points[i] - 1.0);
      cell[i] =
        std::min(static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(grid.Points[i] - 2));
      this->T[i] = static_cast<float>(x - cell[i]);
    }
    this->Row = grid.Points[0];
    this->Slice = this->Row * grid.Points[1];
    this->First = cell[2] * this->Slice + cell[1] * this->Row + cell[0];
  }

  /// Extinction of each band and scattering of each that it has itself, before Scale: at most 6 numbers.
  void Read(const vtkGodRaysGrid& grid, float* coefficients) const
  {
    if (grid.Table)
    {
      grid.Table->Look(this->First, this->Row, this->Slice, this->T, coefficients);
      return;
    }
    for (int band = 0; band < grid.Bands; ++band)
    {
      coefficients[band] = this->Read(grid.Extinction, grid.Bands, band);
    }
    for (int band = 0; band < grid.ScatteringBands; ++band)
    {
      coefficients[grid.Bands + band] = this->Read(grid.Scattering, grid.ScatteringBands, band);
    }
  }

private:
  float Read(const float* values, int bands, int band) const
  {
    const float* v = values + this->First * bands + band;
    const float* w = v + this->Slice * bands;
    const std::ptrdiff_t row = this->Row * bands;
    const float* t = this->T;
    const float a = v[0] + t[0] * (v[bands] - v[0]);
    const float b = v[row] + t[0] * (v[row + bands] - v[row]);
    const float c = w[0] + t[0] * (w[bands] - w[0]);
    const float d = w[row] + t[0] * (w[row + bands] - w[row]);
    const float front = a + t[1] * (b - a);
    const float back = c + t[1] * (d - c);
    return front + t[2] * (back - front);
  }

  std::ptrdiff_t First;
  std::ptrdiff_t Row;
  std::ptrdiff_t Slice;
  float T[3];
};

#endif
