// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outliers.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
double GetValue(vtkDataArray* values, vtkIdType i, int component)
{
  if (component >= 0)
  {
    return values->GetComponent(i, component);
  }
  double magnitude = 0.0;
  for (int c = 0; c < values->GetNumberOfComponents(); ++c)
  {
    magnitude = std::hypot(magnitude, values->GetComponent(i, c));
  }
  return magnitude;
}
}

//------------------------------------------------------------------------------
bool FindUsualRange(vtkDataArray* values, int component, double range[2])
{
  constexpr vtkIdType enough = 10000; // of evenly spread values, whose 99 % stand for all
  constexpr double most = 1000.0;
  values->GetFiniteRange(range, component);
  const vtkIdType count = values->GetNumberOfTuples();
  std::vector<double> sample;
  for (vtkIdType i = 0; i < count; i += 1 + count / enough)
  {
    const double value = GetValue(values, i, component);
    if (std::isfinite(value))
    {
      sample.push_back(value);
    }
  }
  if (sample.empty())
  {
    return false;
  }
  std::sort(sample.begin(), sample.end());
  const std::size_t left = (sample.size() + 99) / 100; // at either end
  const double low = sample[std::min(left, sample.size() / 2)];
  const double high = sample[sample.size() - 1 - std::min(left, (sample.size() - 1) / 2)];
  const double reach = most * (high - low);
  // A magnitude whose square overflows is finite, but not in VTK's range.
  if (!(reach > 0.0) || (component >= 0 && range[0] >= low - reach && range[1] <= high + reach))
  {
    return false;
  }
  double usual[2] = { low, high };
  double outside[2] = { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() }; // the outliers next to the range
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = GetValue(values, i, component);
    if (value >= low - reach && value <= high + reach)
    {
      usual[0] = std::min(usual[0], value);
      usual[1] = std::max(usual[1], value);
    }
    else if (std::isfinite(value))
    {
      double& next = outside[value < low ? 0 : 1];
      next = value < low ? std::max(next, value) : std::min(next, value);
    }
  }
  const double gap = most * (usual[1] - usual[0]);
  const bool isBelow = std::isfinite(outside[0]) && outside[0] < usual[0] - gap;
  const bool isAbove = std::isfinite(outside[1]) && outside[1] > usual[1] + gap;
  range[0] = isBelow ? usual[0] : std::min(range[0], usual[0]);
  range[1] = isAbove ? usual[1] : std::max(range[1], usual[1]);
  return isBelow || isAbove;
}
