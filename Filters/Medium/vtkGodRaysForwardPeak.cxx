// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysForwardPeak.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
constexpr double LeastForward = 1e-3; // part below which there is no peak
constexpr double DarkestDepth = 12.0; // scaled depth at which the table ends

// Finds moment l of the peak function, of a phase function whose moment is m and whose forward part is f. Of
// n events on a way, on the average, Poisson's law has none in e^-n of the cases: that is single scattering,
// which is known exactly and taken away. Either one event of a path is not of the peak, or all are: such a
// path counts once, not once for each event.
// m - f + f (1 - e^-n)/n - e^-n m to the degree that is kept, above f (e^(-n (1 - m/f)) - e^-n)/n - e^-n m.
double GetPeakMoment(double m, double f, double n, bool isKept)
{
  const double part = std::min(m / f, 1.0);
  return isKept ? m - f + f * vtkGodRays::MeanExponential(n) - std::exp(-n) * m
                : std::exp(-n) * (f * part * vtkGodRays::MeanExponential(-n * part) - m);
}

}

// Finds the Legendre moments of a phase function, of which the first is 1: by midpoints in the third root of
// 1 - cosine, which are dense in a peak, until they are small.
std::vector<double> vtkGodRaysForwardPeak::FindMoments(
  const vtkGodRaysTransportScene::PhaseMix& phase)
{
  constexpr int count = 4096;
  constexpr std::size_t most = 2000;
  std::vector<double> cosines(count);
  std::vector<double> last(count);
  std::vector<double> legendre(count, 1.0); // times the part of light
  for (int i = 0; i < count; ++i)
  {
    const double x = (i + 0.5) / count;
    cosines[i] = 1.0 - 2.0 * x * x * x;
    last[i] = 0.0;
    legendre[i] = 12.0 * vtkMath::Pi() * x * x * phase.Get(cosines[i]) / count;
  }
  std::vector<double> moments;
  int vanishing = 0;
  while (moments.size() < most && vanishing < 8)
  {
    const double l = static_cast<double>(moments.size());
    moments.push_back(std::accumulate(legendre.begin(), legendre.end(), 0.0));
    vanishing = std::abs(moments.back()) < 1e-6 ? vanishing + 1 : 0;
    for (int i = 0; i < count; ++i)
    {
      const double next = ((2.0 * l + 1.0) * cosines[i] * legendre[i] - l * last[i]) / (l + 1.0);
      last[i] = legendre[i];
      legendre[i] = next;
    }
  }
  return moments;
}

void vtkGodRaysForwardPeak::Build(const std::vector<double>& moments, int degree)
{
  this->ForwardPart = moments[degree + 1] >= LeastForward ? moments[degree + 1] : 0.0;
  this->Table.clear();
  if (this->ForwardPart == 0.0)
  {
    return;
  }
  // Without absorption, f/(1 - f) events come with each unit of scaled depth; else fewer.
  this->Most = DarkestDepth * this->ForwardPart / (1.0 - this->ForwardPart);
  this->Table.assign(Rows * Angles, 0.0f);
  vtkSMPTools::For(0, Rows, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const double place = row / (Rows - 1.0);
        double last[Angles] = { 0.0 };
        double legendre[Angles];
        std::fill_n(legendre, Angles, 1.0);
        for (std::size_t l = 0; l < moments.size(); ++l)
        {
          const double degrees = 2.0 * l + 1.0;
          const double moment = degrees / (4.0 * vtkMath::Pi()) *
            GetPeakMoment(moments[l], this->ForwardPart, this->Most * place * place,
              static_cast<int>(l) <= degree);
          for (int i = 0; i < Angles; ++i)
          {
            const double x = i / (Angles - 1.0);
            this->Table[row * Angles + i] += static_cast<float>(moment * legendre[i]);
            const double next =
              (degrees * (1.0 - 2.0 * x * x * x) * legendre[i] - l * last[i]) / (l + 1.0);
            last[i] = legendre[i];
            legendre[i] = next;
          }
        }
      }
    });
}

double vtkGodRaysForwardPeak::Get(double cosAngle, double events) const
{
  if (this->Table.empty())
  {
    return 0.0;
  }
  const vtkGodRays::Vec2 place = vtkGodRays::PeakPlace(cosAngle, events, this->Most) *
    vtkGodRays::Vec2(Angles - 1.0, Rows - 1.0);
  const int i = std::min(static_cast<int>(place.x), Angles - 2);
  const int j = std::min(static_cast<int>(place.y), Rows - 2);
  const float* const entry = this->Table.data() + static_cast<std::ptrdiff_t>(j) * Angles + i;
  const vtkGodRays::Vec2 t = place - vtkGodRays::Vec2(i, j);
  return (entry[0] + t.x * (entry[1] - entry[0])) * (1.0 - t.y) +
    (entry[Angles] + t.x * (entry[Angles + 1] - entry[Angles])) * t.y;
}
