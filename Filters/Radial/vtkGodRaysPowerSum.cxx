// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPowerSum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vtkGodRays
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Nodes = 32;
using Column = std::array<double, Nodes>;

// Rounding in float costs this much of 6e-8; see Amplification.
constexpr double LargestAmplification = 100.0;

// The kernel at nodes that are dense at both ends of [0, end].
class Problem
{
public:
  Problem(double k, double d, double end)
    : Sign(d < 0.0 ? -1.0 : 1.0)
  {
    for (int i = 0; i < Nodes; ++i)
    {
      const double angle = Pi * (i + 0.5) / Nodes;
      const double t = 0.5 * end * (1.0 - std::cos(angle));
      this->LogRatio[i] = std::log1p(-std::min(d * t, 1.0 - 1e-12));
      this->Weight[i] = 0.5 * end * std::sin(angle) * Pi / Nodes;
      // Relative to the largest value, so that large negative k stay finite.
      this->Kernel[i] = std::exp(-k * t + std::min(k * end, 0.0));
      this->Total += this->Weight[i] * this->Kernel[i];
    }
    this->Rescale = std::exp(-std::min(k * end, 0.0));
    this->Rate = std::abs(k / d);
    this->Range = std::min(std::abs(std::log1p(-std::min(d * end, 1.0 - 1e-3))), 1.0);
  }

  // The steepness of the kernel at the pixel, as a power of u.
  double GetRate() const { return this->Rate; }
  // By what a power must change to matter.
  double GetUnit() const { return 1.0 / this->Range; }

  // Least squares for powers sign (first + j step); false if these are no use in float.
  bool Solve(int count, double first, double step, PowerSum& sum) const
  {
    std::array<Column, MaximumPowers + 1> columns;
    for (int j = 0; j < count; ++j)
    {
      sum.Powers[j] = this->Sign * (first + j * step);
    }
    Column& power = columns[0];
    Column ratio;
    for (int i = 0; i < Nodes; ++i)
    {
      const double root = std::sqrt(this->Weight[i]);
      power[i] = root * std::exp(sum.Powers[0] * this->LogRatio[i]);
      ratio[i] = std::exp(this->Sign * step * this->LogRatio[i]);
      columns[count][i] = root * this->Kernel[i];
    }
    for (int j = 1; j < count; ++j)
    {
      for (int i = 0; i < Nodes; ++i)
      {
        columns[j][i] = columns[j - 1][i] * ratio[i];
      }
    }
    const std::array<Column, MaximumPowers + 1> basis = columns;
    if (!SolveLeastSquares(columns, count, sum.Factors))
    {
      return false;
    }
    sum.Count = count;
    this->Judge(basis, sum);
    return this->GetAmplification(sum) < LargestAmplification;
  }

  // Undo the scaling of the kernel.
  void Finish(PowerSum& sum) const
  {
    for (int j = 0; j < sum.Count; ++j)
    {
      sum.Factors[j] *= this->Rescale;
    }
  }

private:
  // Modified Gram-Schmidt; the last column is the right hand side.
  static bool SolveLeastSquares(
    std::array<Column, MaximumPowers + 1>& columns, int count, double* factors)
  {
    double upper[MaximumPowers][MaximumPowers + 1] = {};
    for (int j = 0; j < count; ++j)
    {
      const double norm = std::sqrt(Dot(columns[j], columns[j]));
      if (!(norm > 1e-12))
      {
        return false;
      }
      upper[j][j] = norm;
      for (double& value : columns[j])
      {
        value /= norm;
      }
      for (int l = j + 1; l <= count; ++l)
      {
        const double part = Dot(columns[j], columns[l]);
        upper[j][l] = part;
        for (int i = 0; i < Nodes; ++i)
        {
          columns[l][i] -= part * columns[j][i];
        }
      }
    }
    for (int j = count - 1; j >= 0; --j)
    {
      double value = upper[j][count];
      for (int l = j + 1; l < count; ++l)
      {
        value -= upper[j][l] * factors[l];
      }
      factors[j] = value / upper[j][j];
    }
    return true;
  }

  static double Dot(const Column& a, const Column& b)
  {
    double sum = 0.0;
    for (int i = 0; i < Nodes; ++i)
    {
      sum += a[i] * b[i];
    }
    return sum;
  }

  // An image can be white just where the error has one sign: the larger of both is the bound.
  void Judge(const std::array<Column, MaximumPowers + 1>& basis, PowerSum& sum) const
  {
    double above = 0.0;
    double below = 0.0;
    for (int i = 0; i < Nodes; ++i)
    {
      const double root = std::sqrt(this->Weight[i]);
      double error = -root * this->Kernel[i];
      for (int j = 0; j < sum.Count; ++j)
      {
        error += sum.Factors[j] * basis[j][i];
      }
      (error > 0.0 ? above : below) += root * std::abs(error);
    }
    sum.Bound = std::max(above, below) / this->Total;
  }

  // How much larger than the result the terms are that are added and subtracted: each at most
  // |factor| times the integral of its power, twice where the end of the march is subtracted.
  double GetAmplification(const PowerSum& sum) const
  {
    double terms = 0.0;
    for (int j = 0; j < sum.Count; ++j)
    {
      double integral = 0.0;
      for (int i = 0; i < Nodes; ++i)
      {
        integral += this->Weight[i] * std::exp(sum.Powers[j] * this->LogRatio[i]);
      }
      terms += std::abs(sum.Factors[j]) * integral;
    }
    return terms / this->Total;
  }

  double Sign;
  Column LogRatio;
  Column Weight;
  Column Kernel;
  double Total = 0.0;
  double Rescale = 1.0;
  double Rate;
  double Range;
};

// Keeps the better one.
void Try(const Problem& problem, int count, double first, double step, PowerSum& best,
  double& bestFirst, double& bestStep)
{
  PowerSum candidate;
  if (first >= 0.0 && step > 0.0 && problem.Solve(count, first, step, candidate) &&
    candidate.Bound < best.Bound)
  {
    best = candidate;
    bestFirst = first;
    bestStep = step;
  }
}

PowerSum FitPowers(const Problem& problem, int count, double tolerance)
{
  const double unit = problem.GetUnit();
  const double span = 1.5 * problem.GetRate() + 0.5 * unit;
  PowerSum best;
  double first = 0.0;
  double step = unit;
  for (int i = 0; i <= 12 && best.Bound > 0.3 * tolerance; ++i)
  {
    for (const double factor : { 0.5, 1.0, 1.5, 2.0, 3.0, 4.5, 7.0 })
    {
      Try(problem, count, span * i / 12, unit * factor, best, first, step);
      if (count == 1)
      {
        break;
      }
    }
  }
  double firstChange = span / 24;
  double stepChange = 0.25 * unit;
  for (int i = 0; i < 10 && best.Bound > 0.3 * tolerance; ++i)
  {
    const double center[2] = { first, step };
    for (const double sign : { -1.0, 1.0 })
    {
      Try(problem, count, std::max(0.0, center[0] + sign * firstChange), center[1], best, first,
        step);
      if (count > 1)
      {
        Try(problem, count, center[0], center[1] + sign * stepChange, best, first, step);
      }
    }
    if (first == center[0] && step == center[1])
    {
      firstChange *= 0.4;
      stepChange *= 0.4;
    }
  }
  return best;
}
}

PowerSum FitPowerSum(double k, double d, double end, double tolerance)
{
  if (k == 0.0)
  {
    PowerSum one;
    one.Count = 1;
    one.Factors[0] = 1.0;
    one.Bound = 0.0;
    return one;
  }
  const Problem problem(k, d, end);
  PowerSum best;
  for (int count = 1; count <= MaximumPowers && best.Bound > tolerance; ++count)
  {
    const PowerSum sum = FitPowers(problem, count, tolerance);
    if (sum.Bound < best.Bound)
    {
      best = sum;
    }
  }
  problem.Finish(best);
  return best;
}
}
