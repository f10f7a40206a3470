// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowLists
 * @brief   the shadowed stretches of view rays, measured in airlight
 *
 * Private. For each ray that is walked, a list of stretches: of each, the airlight of planes at its begin and
 * end, and its darkness, unless that is 1.
 */

#ifndef vtkGodRaysShadowLists_h
#define vtkGodRaysShadowLists_h

#include "vtkGodRaysAirlight.h"
#include "vtkGodRaysShadowPyramid.h"

#include <algorithm> // For std::copy_n, std::max, std::min
#include <cstddef>   // For std::size_t
#include <vector>    // For std::vector

class vtkGodRaysShadowLists
{
public:
  struct Place // of a view ray [pixels]
  {
    int X;
    int Y;
  };
  struct List
  {
    const float* Values;
    int Count; // of stretches; -1 where no light comes from the ray at all
  };

  /// They are as they are when rays are walked.
  vtkGodRaysShadowLists(const vtkGodRaysAirlight& airlight, const vtkGodRaysShadowPyramid& pyramid)
    : Airlight(airlight)
    , Pyramid(pyramid)
  {
  }

  void Clear()
  {
    this->Lists.clear();
    this->NumberOfTasks = 0;
  }

  int GetNumberOfLists() const { return static_cast<int>(this->Lists.size()); }
  const List& Get(int index) const { return this->Lists[index]; }

  /// Appends a list for each place, of rays to view depths.
  void Walk(const std::vector<Place>& places, const std::vector<float>& depths);

  /// What is hidden of the airlight of some pixels, which is [plane][pixel].
  template <int Count>
  void GetHidden(const List& list, const float* airlight, float* hidden) const
  {
    const int planes = this->Airlight.GetNumberOfPlanes();
    const int channels = this->Airlight.GetNumberOfChannels();
    const bool opaque = this->Pyramid.IsOpaque();
    const int stride = 2 * planes + (opaque ? 0 : 3);
    for (int p = 0; p < planes; ++p)
    {
      const float* own = airlight + p * Count;
      float sums[Count] = {};
      const float* values = list.Values;
      for (int i = 0; i < list.Count; ++i, values += stride)
      {
        const float begin = values[2 * p];
        const float end = values[2 * p + 1];
        const float dark = opaque ? 1.0f : values[2 * planes + p % channels];
        for (int k = 0; k < Count; ++k)
        {
          sums[k] += dark * (std::min(end, own[k]) - std::min(begin, own[k]));
        }
      }
      std::copy_n(sums, Count, hidden + p * Count);
    }
  }

private:
  struct Task // keeps its memory, so that a steady frame allocates none whatever the threads do
  {
    std::vector<vtkGodRaysShadowPyramid::Stretch> Stretches;
    std::vector<float> Values; // of its lists
  };

  void WalkSome(const std::vector<Place>& places, const std::vector<float>& depths,
    std::size_t begin, std::size_t end, Task& task, int* counts) const;

  const vtkGodRaysAirlight& Airlight;
  const vtkGodRaysShadowPyramid& Pyramid;
  std::vector<Task> Tasks; // their number only grows
  std::size_t NumberOfTasks = 0;
  std::vector<List> Lists;
};

#endif
