// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysFixedPoint
 * @brief   extrapolates a fixed-point iteration x -> g(x) from its last steps g(x) - x [Anderson1965]
 *
 * Private.
 */

#ifndef vtkGodRaysFixedPoint_h
#define vtkGodRaysFixedPoint_h

#include "vtkMath.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <numeric>
#include <vector>

class vtkGodRaysFixedPoint
{
public:
  // Makes the next x of the last one and of g(x).
  void Advance(std::vector<float>& x, const std::vector<float>& g)
  {
    std::vector<float> step(x.size());
    std::transform(g.begin(), g.end(), x.begin(), step.begin(), std::minus<float>());
    if (!this->Step.empty())
    {
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        this->Step[i] = step[i] - this->Step[i];
        this->X[i] = x[i] - this->X[i] + this->Step[i];
      }
      this->Changes.push_back({ std::move(this->Step), std::move(this->X) });
      if (this->Changes.size() > Depth)
      {
        this->Changes.pop_front();
      }
    }
    this->X = x;
    x = g;
    const int count = static_cast<int>(this->Changes.size());
    double matrix[Depth][Depth];
    double* rows[Depth];
    double weights[Depth];
    const auto multiply = [](const std::vector<float>& a, const std::vector<float>& b)
    { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); };
    for (int i = 0; i < count; ++i)
    {
      rows[i] = matrix[i];
      for (int j = 0; j <= i; ++j)
      {
        matrix[i][j] = matrix[j][i] = multiply(this->Changes[i].Step, this->Changes[j].Step);
      }
      matrix[i][i] *= 1.0 + 1e-6; // they may be parallel
      weights[i] = multiply(this->Changes[i].Step, step);
    }
    const bool solved = count > 0 && vtkMath::SolveLinearSystem(rows, weights, count);
    for (int i = 0; i < count && solved; ++i)
    {
      const float weight = static_cast<float>(weights[i]);
      for (std::size_t k = 0; k < x.size(); ++k)
      {
        x[k] -= weight * this->Changes[i].Sum[k];
      }
    }
    this->Step = std::move(step);
  }

private:
  static constexpr int Depth = 5;
  struct Change // from one x to the next: of the step, and of x and the step together
  {
    std::vector<float> Step;
    std::vector<float> Sum;
  };
  std::deque<Change> Changes;
  std::vector<float> X;
  std::vector<float> Step;
};

#endif
