// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowLists.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
constexpr int Rays = 64;  // that one task walks
constexpr int Batch = 32; // stretches that are evaluated together
}

void vtkGodRaysShadowLists::WalkSome(const std::vector<Place>& places,
  const std::vector<float>& depths, std::size_t begin, std::size_t end, Task& task,
  int* counts) const
{
  std::vector<vtkGodRaysShadowPyramid::Stretch>& stretches = task.Stretches;
  std::vector<float>& values = task.Values;
  values.clear();
  float xs[2 * Batch];
  float ys[2 * Batch];
  float distances[2 * Batch];
  float airlight[vtkGodRaysAirlight::MaximumPlanes * 2 * Batch];
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
    std::fill_n(xs, 2 * Batch, static_cast<float>(x));
    std::fill_n(ys, 2 * Batch, static_cast<float>(y));
    for (int first = 0; first < count; first += Batch)
    {
      const int number = std::min(Batch, count - first);
      const vtkGodRaysShadowPyramid::Stretch* const some = stretches.data() + first;
      for (int i = 0; i < number; ++i)
      {
        distances[2 * i] = some[i].Begin;
        distances[2 * i + 1] = some[i].End;
      }
      this->Airlight.Evaluate(2 * number, xs, ys, distances, airlight);
      for (int i = 0; i < number; ++i)
      {
        for (int p = 0; p < planes; ++p)
        {
          values.push_back(airlight[2 * p * number + 2 * i]);
          values.push_back(airlight[2 * p * number + 2 * i + 1]);
        }
        if (!opaque)
        {
          values.insert(values.end(), some[i].Dark, some[i].Dark + 3);
        }
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
  if (this->Tasks.size() < this->NumberOfTasks)
  {
    this->Tasks.resize(this->NumberOfTasks);
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
        Task& own = this->Tasks[firstTask + task];
        this->WalkSome(places, depths, from, to, own, counts);
        const float* at = own.Values.data();
        for (std::size_t ray = from; ray < to; ++ray)
        {
          this->Lists[first + ray] = { at, counts[ray - from] };
          at += static_cast<std::ptrdiff_t>(std::max(counts[ray - from], 0)) * stride;
        }
      }
    });
}
