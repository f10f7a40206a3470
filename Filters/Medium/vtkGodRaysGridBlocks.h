// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridBlocks.h
 * @brief   the range of extinction in blocks of cells of a grid
 *
 * Private.
 */

#ifndef vtkGodRaysGridBlocks_h
#define vtkGodRaysGridBlocks_h

#include "vtkGodRaysGrid.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <vector>

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
        std::ptrdiff_t points[BlockSize + 1];
        float values[3 * (BlockSize + 1)];
        const int count = last[0] - first[0] + 1;
        std::iota(points, points + count, grid.GetPoint(first[0], b, c));
        grid.Table->Gather(points, count, 0, grid.Bands, values);
        const auto range = std::minmax_element(values, values + count * grid.Bands);
        low = std::min(low, *range.first);
        high = std::max(high, *range.second);
      }
    }
    return { low, high };
  }

  int Size[3];
  std::vector<Range> Ranges;
  double Scale;
};

#endif
