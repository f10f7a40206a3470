// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Medians and quartiles of samples, of which NaN are those that were not taken.

#ifndef Statistics_h
#define Statistics_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Statistics
{
const double None = std::numeric_limits<double>::quiet_NaN();

/// The value below which a fraction of the samples lies; None without any.
inline double GetQuantile(std::vector<double> samples, double fraction)
{
  samples.erase(std::remove_if(
                  samples.begin(), samples.end(), [](double sample) { return std::isnan(sample); }),
    samples.end());
  if (samples.empty())
  {
    return None;
  }
  std::sort(samples.begin(), samples.end());
  const double position = fraction * (samples.size() - 1);
  const auto lower = static_cast<std::size_t>(position);
  const auto upper = std::min(lower + 1, samples.size() - 1);
  return samples[lower] + (position - lower) * (samples[upper] - samples[lower]);
}

inline double GetMedian(const std::vector<double>& samples)
{
  return GetQuantile(samples, 0.5);
}

inline double GetLargest(const std::vector<double>& samples)
{
  return GetQuantile(samples, 1.0);
}

inline double GetRootMeanSquare(const std::vector<double>& samples)
{
  double sum = 0.0;
  int count = 0;
  for (double sample : samples)
  {
    if (!std::isnan(sample))
    {
      sum += sample * sample;
      ++count;
    }
  }
  return count ? std::sqrt(sum / count) : None;
}

/// Samples divided by those that were taken beside them.
inline std::vector<double> Divide(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    ratios.push_back(a[i] / b[i]);
  }
  return ratios;
}

inline std::vector<double> Subtract(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    differences.push_back(a[i] - b[i]);
  }
  return differences;
}

/// The power e in y = c x^e that fits best.
inline double FitExponent(const std::vector<double>& x, const std::vector<double>& y)
{
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
  {
    if (x[i] > 0.0 && y[i] > 0.0)
    {
      const double a = std::log(x[i]);
      const double b = std::log(y[i]);
      sx += a;
      sy += b;
      sxx += a * a;
      sxy += a * b;
      ++count;
    }
  }
  return count > 1 ? (count * sxy - sx * sy) / (count * sxx - sx * sx) : None;
}
}

#endif
