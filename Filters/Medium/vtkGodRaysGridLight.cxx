// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridLight.h"

#include "vtkGodRaysGridBlocks.h"
#include "vtkSMPTools.h"

namespace
{
// Along an axis: depths bend where the way's end moves from a face of the grid to the next.
constexpr int LeastNodes = 40;
constexpr int GroupSize = 16;  // columns
constexpr int PlanesRead = 16; // together
constexpr double ExactPlanes =
  32.0; // on longer ways of a lamp what changes between planes is averaged out

using Depth = vtkGodRaysGridDepth;

// [scene units] of a way in points
double GetLength(const vtkGodRaysGrid& grid, const vtkGodRays::Vec3& way)
{
  return vtkGodRays::length(way.x * grid.Axes[0] + way.y * grid.Axes[1] + way.z * grid.Axes[2]);
}

// How many planes of points a way to a point light goes through.
double CountPlanes(
  const vtkGodRaysGrid& grid, const vtkGodRays::Vec3& place, const vtkGodRays::Vec3& steps)
{
  double begin = 0.0;
  double end = 1.0;
  const vtkGodRays::Vec3 size = vtkGodRays::abs(steps);
  return grid.Clip(place, steps, begin, end) ? (end - begin) * std::max({ size.x, size.y, size.z })
                                             : 0.0;
}

// What a line adds to an optical depth between two places: exactly but for what changes across it between
// planes of points.
void AddPlanes(const vtkGodRaysGrid& grid, const vtkGodRays::Vec3& place,
  const vtkGodRays::Vec3& steps, double begin, double end, vtkGodRays::Vec3& depth)
{
  const vtkGodRays::Vec3 size = vtkGodRays::abs(steps);
  const int along = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  const int across[2] = { along == 0 ? 1 : 0, along == 2 ? 1 : 2 };
  const int up = steps[along] > 0.0 ? 1 : -1;
  const double from = up * (place[along] + begin * steps[along]);
  const double to = up * (place[along] + end * steps[along]);
  const int first = static_cast<int>(std::floor(from)) + 1; // plane between the two, times up
  const int last = static_cast<int>(std::ceil(to)) - 1;
  if (last - first < 2)
  {
    grid.AddDepth(place, steps, begin, end, depth);
    return;
  }
  const double one = 1.0 / size[along]; // step
  const double bend = begin + (first - from) * one;
  const std::ptrdiff_t strides[3] = { 1, grid.Points[0],
    static_cast<std::ptrdiff_t>(grid.Points[0]) * grid.Points[1] };
  grid.AddDepth(place, steps, begin, bend, depth);
  float sums[3] = { 0.0f, 0.0f, 0.0f };
  for (int plane = first; plane <= last; plane += PlanesRead)
  {
    const int count = std::min(PlanesRead, last - plane + 1);
    std::ptrdiff_t points[4 * PlanesRead];
    float t[2][PlanesRead]; // in the cell across
    for (int i = 0; i < count; ++i)
    {
      std::ptrdiff_t point = up * (plane + i) * strides[along];
      for (int k = 0; k < 2; ++k)
      {
        const int axis = across[k];
        const double at =
          std::max(place[axis] + (bend + (plane + i - first) * one) * steps[axis], 0.0);
        const int cell = std::min(static_cast<int>(at), grid.Points[axis] - 2);
        t[k][i] = static_cast<float>(at - cell);
        point += cell * strides[axis];
      }
      for (int k = 0; k < 4; ++k)
      {
        points[4 * i + k] = point + (k & 1) * strides[across[0]] + (k >> 1) * strides[across[1]];
      }
    }
    float values[12 * PlanesRead];
    grid.Table->Gather(points, 4 * count, 0, grid.Bands, values);
    for (int i = 0; i < grid.Bands * count; ++i)
    {
      const float* v = values + 4 * i;
      const float x = t[0][i % count];
      const float front = v[0] + x * (v[1] - v[0]);
      const float back = v[2] + x * (v[3] - v[2]);
      const int at = plane + i % count;
      const float weight = at == first || at == last ? 0.5f : 1.0f;
      sums[i / count] += weight * (front + t[1][i % count] * (back - front));
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    depth[c] += grid.Scale * one * sums[c < grid.Bands ? c : 0];
  }
  grid.AddDepth(place, steps, bend + (last - first) * one, end, depth);
}

// What a line adds to an optical depth from its begin to an end, past blocks that are empty.
template <typename Add>
void AddWay(const vtkGodRaysGrid& grid, const vtkGodRaysGridBlocks& blocks,
  const vtkGodRays::Vec3& place, const vtkGodRays::Vec3& steps, double end, const Add& add)
{
  double s = 0.0;
  if (!grid.Clip(place, steps, s, end))
  {
    return;
  }
  double first = s; // of what is not yet added
  while (s < end)
  {
    double exit;
    const bool isEmpty = blocks.Get(place + s * steps, place, steps, s, exit).y == 0.0;
    if (isEmpty && first < s)
    {
      add(first, s);
    }
    s = std::min(exit, end);
    first = isEmpty ? s : first;
  }
  if (first < s)
  {
    add(first, s);
  }
}
}

void vtkGodRaysGridLight::Build(const vtkGodRaysGrid& grid, const vtkGodRaysGridBlocks& blocks,
  const Vec3& light, bool directional)
{
  this->Directional = directional;
  this->Bands = grid.Bands;
  this->Light = directional ? grid.GetSteps(light) : grid.GetPlace(light);
  const Vec3 size = vtkGodRays::abs(this->Light);
  const int first = !directional           ? 2
    : size.z >= size.x && size.z >= size.y ? 2
    : size.y >= size.x                     ? 1
                                           : 0;
  this->Order[0] = first;
  this->Order[1] = first == 0 ? 1 : 0;
  this->Order[2] = first == 2 ? 1 : 2;
  for (int i = 0; i < 3; ++i)
  {
    const int points = grid.Points[this->Order[i]];
    // Aside there are columns before the grid and behind it, too.
    const int nodes = std::max(points / 2, LeastNodes) - (i == 0 ? 0 : 3);
    this->Distance[i] = (points - 1.0) / (nodes - 1);
    this->Size[i] = i == 0 ? nodes : nodes + 3;
  }
  for (int i = 0; i < 2; ++i)
  {
    this->Slope[i] = directional ? this->Light[this->Order[i + 1]] / this->Light[first] : 0.0;
    this->Base[i].resize(this->Size[0]);
    for (int plane = 0; plane < this->Size[0]; ++plane)
    {
      this->Base[i][plane] = static_cast<int>(std::floor(-this->Slope[i] * plane *
                               this->Distance[0] / this->Distance[i + 1])) -
        (directional ? 0 : 1);
    }
  }
  this->Reach = 1.0;
  for (int corner = 0; corner < 8 && !directional; ++corner)
  {
    Vec3 way = -this->Light;
    for (int i = 0; i < 3; ++i)
    {
      way[i] += (corner >> i) % 2 == 0 ? 0.0 : grid.Points[i] - 1.0;
    }
    this->Reach = std::max(corner == 0 ? 0.0 : this->Reach, GetLength(grid, way));
  }
  const std::size_t row = static_cast<std::size_t>(this->Size[1]) * this->Bands;
  const std::size_t slice = row * this->Size[2];
  this->Depths.resize(slice * this->Size[0]);
  // The way from the node of two columns in a plane, as far as the next plane or a point light.
  const double length = directional ? this->Distance[0] / size[first] : 1.0;
  const auto sum = [&](int plane, int a, int b)
  {
    const int columns[2] = { a, b };
    Vec3 place;
    place[first] = plane * this->Distance[0];
    for (int i = 0; i < 2; ++i)
    {
      place[this->Order[i + 1]] =
        columns[i] * this->Distance[i + 1] + this->Slope[i] * place[first];
    }
    Vec3 depth(0.0);
    const Vec3 way = directional ? this->Light : this->Light - place;
    const bool isLong = !directional && CountPlanes(grid, place, way) > ExactPlanes;
    const auto add = [&](double begin, double end)
    {
      isLong ? AddPlanes(grid, place, way, begin, end, depth)
             : grid.AddDepth(place, way, begin, end, depth);
    };
    AddWay(grid, blocks, place, way, length, add);
    return this->Reach * depth;
  };
  const auto keep = [&](float depth, int plane, int a, int b, int band)
  {
    this->Depths[plane * slice + (b - this->Base[1][plane]) * row +
      (a - this->Base[0][plane]) * this->Bands + band] = Depth::Encode(depth);
  };
  if (!directional)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Size[0]) * this->Size[2], 4,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const int plane = static_cast<int>(i / this->Size[2]);
          const int b = this->Base[1][plane] + static_cast<int>(i % this->Size[2]);
          for (int a = this->Base[0][plane]; a < this->Base[0][plane] + this->Size[1]; ++a)
          {
            const Vec3 depth = sum(plane, a, b);
            for (int band = 0; band < this->Bands; ++band)
            {
              keep(static_cast<float>(std::min(depth[band], 1e30)), plane, a, b, band);
            }
          }
        }
      });
    return;
  }
  // Some columns side by side, from plane to plane as light goes.
  const bool up = this->Light[first] > 0.0;
  int low[2];
  int count[2];
  for (int i = 0; i < 2; ++i)
  {
    const auto range = std::minmax(this->Base[i].front(), this->Base[i].back());
    low[i] = range.first;
    count[i] = range.second - range.first + this->Size[i + 1];
  }
  const int groups = (count[0] - 1) / GroupSize + 1;
  vtkSMPTools::For(0, static_cast<vtkIdType>(groups) * count[1], 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        float sums[3 * GroupSize] = {};
        const int b = low[1] + static_cast<int>(k / groups);
        const int left = low[0] + static_cast<int>(k % groups) * GroupSize;
        for (int i = 0; i < this->Size[0]; ++i)
        {
          const int plane = up ? this->Size[0] - 1 - i : i;
          const int there = b - this->Base[1][plane];
          for (int a = left; a < left + GroupSize; ++a)
          {
            float* own = sums + 3 * (a - left);
            const int here = a - this->Base[0][plane];
            if (there < 0 || there >= this->Size[2] || here < 0 || here >= this->Size[1])
            {
              std::fill_n(own, 3, 0.0f); // the column does not go through the grid there
              continue;
            }
            const Vec3 depth = sum(plane, a, b);
            for (int band = 0; band < this->Bands; ++band)
            {
              // Differences are finite.
              own[band] =
                std::min(own[band] + static_cast<float>(std::min(depth[band], 1e30)), 1e30f);
              keep(own[band], plane, a, b, band);
            }
          }
        }
      }
    });
}

void vtkGodRaysGridLight::AddDepth(
  const vtkGodRaysGrid& grid, const Vec3& place, float* depth) const
{
  bool inside = true;
  for (int i = 0; i < 3; ++i)
  {
    inside = inside && place[i] >= 0.0 && place[i] <= grid.Points[i] - 1;
  }
  const Vec3 steps = this->Directional ? this->Light : this->Light - place;
  double begin = 0.0;
  double end = this->Directional ? std::numeric_limits<double>::infinity() : 1.0;
  if (!inside && !grid.Clip(place, steps, begin, end))
  {
    return;
  }
  float known[3] = { 0.0f, 0.0f, 0.0f };
  this->Look(inside ? place : place + begin * steps, known);
  const double length =
    this->Directional ? 1.0 : (1.0 - begin) * GetLength(grid, steps) / this->Reach;
  for (int band = 0; band < this->Bands; ++band)
  {
    depth[band] += static_cast<float>(length) * known[band];
  }
}

void vtkGodRaysGridLight::Look(const Vec3& place, float* known) const
{
  const double across = place[this->Order[0]];
  const double w = std::max(across / this->Distance[0], 0.0);
  const int plane = std::min(static_cast<int>(w), this->Size[0] - 2);
  const float t = static_cast<float>(w - plane);
  double column[2];
  for (int i = 0; i < 2; ++i)
  {
    column[i] = (place[this->Order[i + 1]] - this->Slope[i] * across) / this->Distance[i + 1];
  }
  const std::size_t row = static_cast<std::size_t>(this->Size[1]) * this->Bands;
  const std::size_t slice = row * this->Size[2];
  for (int i = 0; i < 2; ++i)
  {
    const double a = std::max(column[0] - this->Base[0][plane + i], 0.0);
    const double b = std::max(column[1] - this->Base[1][plane + i], 0.0);
    const int left = std::min(static_cast<int>(a), this->Size[1] - 2);
    const int low = std::min(static_cast<int>(b), this->Size[2] - 2);
    const float x = std::min(static_cast<float>(a - left), 1.0f);
    const float y = std::min(static_cast<float>(b - low), 1.0f);
    const std::uint16_t* v =
      this->Depths.data() + (plane + i) * slice + low * row + left * this->Bands;
    for (int band = 0; band < this->Bands; ++band, ++v)
    {
      const float values[4] = { Depth::Decode(v[0]), Depth::Decode(v[this->Bands]),
        Depth::Decode(v[row]), Depth::Decode(v[row + this->Bands]) };
      const float front = values[0] + x * (values[1] - values[0]);
      const float back = values[2] + x * (values[3] - values[2]);
      const float here = front + y * (back - front);
      known[band] = i == 0 ? here : known[band] + t * (here - known[band]) - Depth::Offset;
    }
  }
}
