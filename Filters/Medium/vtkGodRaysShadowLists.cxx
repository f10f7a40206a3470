// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowLists.h"

#include "vtkSMPTools.h"

namespace
{
constexpr int Rays = 64; // that one task walks
}

void vtkGodRaysShadowLists::WalkSome(const std::vector<Place>& places,
  const std::vector<float>& depths, std::size_t begin, std::size_t end, std::vector<float>& values,
  int* counts) const
{
  thread_local std::vector<vtkGodRaysShadowPyramid::Stretch> stretches;
  thread_local std::vector<float> numbers;
  values.clear();
  const bool opaque = this->Pyramid.IsOpaque();
  const int planes = this->Airlight.GetNumberOfPlanes();
  for (std::size_t ray = begin; ray < end; ++ray)
  {
    const int x = places[ray].X;
    const int y = places[ray].Y;
    double origin[3];
    double direction[3];
    this->Airlight.GetScene().GetRay(x, y, origin, direction);
    stretches.clear();
    double end =
      std::min<double>(depths[ray], this->Airlight.GetScene().Medium.FarLimit) / direction[2];
    if (this->Airlight.HasParts())
    {
      double parts[vtkGodRaysAirlight::MaximumParts][2];
      const int number = this->Airlight.GetParts(x, y, parts);
      if (number == 0)
      {
        counts[ray - begin] = -1;
        continue;
      }
      end = std::min(end, parts[number - 1][1]);
    }
    this->Pyramid.Walk(origin, direction, end, stretches);
    const int count = static_cast<int>(stretches.size());
    counts[ray - begin] = count;
    numbers.resize(static_cast<std::size_t>(count) * 2 * (3 + planes));
    float* xs = numbers.data();
    float* ys = xs + 2 * count;
    float* distances = ys + 2 * count;
    float* airlight = distances + 2 * count;
    for (int i = 0; i < count; ++i)
    {
      xs[2 * i] = xs[2 * i + 1] = static_cast<float>(x);
      ys[2 * i] = ys[2 * i + 1] = static_cast<float>(y);
      distances[2 * i] = stretches[i].Begin;
      distances[2 * i + 1] = stretches[i].End;
    }
    if (count > 0)
    {
      this->Airlight.Evaluate(2 * count, xs, ys, distances, airlight);
    }
    for (int i = 0; i < count; ++i)
    {
      for (int p = 0; p < planes; ++p)
      {
        values.push_back(airlight[2 * p * count + 2 * i]);
        values.push_back(airlight[2 * p * count + 2 * i + 1]);
      }
      if (!opaque)
      {
        values.insert(values.end(), stretches[i].Dark, stretches[i].Dark + 3);
      }
    }
  }
}

void vtkGodRaysShadowLists::Walk(const std::vector<Place>& places, const std::vector<float>& depths)
{
  const std::size_t first = this->Lists.size();
  const std::size_t tasks = (places.size() + Rays - 1) / Rays;
  const std::size_t firstTask = this->NumberOfTasks;
  this->NumberOfTasks += tasks;
  if (this->Values.size() < this->NumberOfTasks)
  {
    this->Values.resize(this->NumberOfTasks);
  }
  this->Lists.resize(first + places.size());
  const int stride = 2 * this->Airlight.GetNumberOfPlanes() + (this->Pyramid.IsOpaque() ? 0 : 3);
  vtkSMPTools::For(0, static_cast<vtkIdType>(tasks), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t task = static_cast<std::size_t>(begin); task < static_cast<std::size_t>(end);
           ++task)
      {
        int counts[Rays];
        const std::size_t from = task * Rays;
        const std::size_t to = std::min(from + Rays, places.size());
        std::vector<float>& values = this->Values[firstTask + task];
        this->WalkSome(places, depths, from, to, values, counts);
        const float* at = values.data();
        for (std::size_t ray = from; ray < to; ++ray)
        {
          this->Lists[first + ray] = { at, counts[ray - from] };
          at += static_cast<std::ptrdiff_t>(std::max(counts[ray - from], 0)) * stride;
        }
      }
    });
}
