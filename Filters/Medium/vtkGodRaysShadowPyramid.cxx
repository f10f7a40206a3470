// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowPyramid.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// The walk itself, which shaders share.
using Real = float;
using glm::abs;
using glm::clamp;
using glm::max;
using glm::min;
#define FUNCTION inline
#define IN(T) T
#define INOUT(T) T&
#include "vtkGodRaysWalkMath.glsl"
#undef INOUT
#undef IN
#undef FUNCTION

// Height of a texel without occluder: a directional light's heights are at least 0, and a point light's
// 1/distance is above 0.
constexpr float None = -1e30f;

// By how much a shadowed stretch is longer than the map says, of the distance from the eye.
constexpr float Margin = 1e-5f;

// Texels whose parts of the light differ by no more, in all layers together, count as alike and have their
// mean. Parts are coded in 16 bits.
constexpr float Alike = 2.0f / 255.0f;
constexpr float Codes = 65535.0f;

double Along(const double axis[3], const double vector[3])
{
  return axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
}

// Of positive numbers: the order of bits is that of values, so their upper half is a number of 8 bits.
std::uint32_t GetBits(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

float FromBits(std::uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

struct Interval
{
  double Begin;
  double End;

  // Keeps what is at least 0 of an affine function of the distance along the ray.
  void Clip(double start, double change)
  {
    if (change == 0.0)
    {
      this->End = start < 0.0 ? this->Begin : this->End;
      return;
    }
    const double zero = -start / change;
    if (change > 0.0)
    {
      this->Begin = std::max(this->Begin, zero);
    }
    else
    {
      this->End = std::min(this->End, zero);
    }
  }
};
}

// Walks one layer of the maps, and keeps what was met last along the ray.
class vtkGodRaysShadowPyramid::Walker
{
public:
  Walker(const vtkGodRaysShadowPyramid& pyramid, double end, std::vector<Stretch>& stretches)
    : Pyramid(pyramid)
    , End(static_cast<float>(end))
    , Stretches(stretches)
  {
  }

  // A part of the ray, from the place a of the map to the place b: texels, texels, height.
  // w is 1/distance from a point light along the map's axis, 1 of a directional light.
  void WalkPart(const Map& map, const double a[3], const double b[3], double begin, double end,
    double wa, double wb);

  // The light reaches the ray from a distance on.
  void Close(double at)
  {
    if (this->Dark[0] + this->Dark[1] + this->Dark[2] > 0.0f)
    {
      this->Set(static_cast<float>(at), 0.0f, 0.0f, 0.0f);
    }
  }

private:
  void Set(float at, float red, float green, float blue)
  {
    const float next[3] = { red, green, blue };
    // What goes on beyond the ray's end counts up to there.
    const float length = std::max(std::min(at, this->End) - this->Last, 0.0f);
    for (int c = 0; c < 3; ++c)
    {
      this->Sum[c] += length * this->Dark[c];
    }
    this->Last = std::max(at, this->Last);
    // What is about as dark goes on, so that a stretch of haze is not one of each texel.
    const auto isNone = [](const float* dark) { return dark[0] + dark[1] + dark[2] <= 0.0f; };
    const auto isAlike = [&](const float* dark)
    {
      return isNone(dark) == isNone(next) &&
        std::abs(dark[0] - red) + std::abs(dark[1] - green) + std::abs(dark[2] - blue) <
        this->Pyramid.Alike;
    };
    std::copy_n(next, 3, this->Dark);
    if (isAlike(this->First))
    {
      return;
    }
    if (!isNone(this->First) && at > this->Begin)
    {
      const float inverse = 1.0f / std::max(std::min(at, this->End) - this->Begin, 1e-30f);
      this->Stretches.push_back({ this->Begin, at,
        { inverse * this->Sum[0], inverse * this->Sum[1], inverse * this->Sum[2] } });
    }
    this->Begin = this->Last = at;
    std::copy_n(next, 3, this->First);
    std::fill_n(this->Sum, 3, 0.0f);
  }

  const vtkGodRaysShadowPyramid& Pyramid;
  float End; // of the ray
  std::vector<Stretch>& Stretches;
  float Begin = 0.0f;
  float Last = 0.0f; // from where on Dark is
  float Dark[3] = { 0.0f, 0.0f, 0.0f };
  float First[3] = { 0.0f, 0.0f, 0.0f }; // of the stretch
  float Sum[3] = { 0.0f, 0.0f, 0.0f };   // of the stretch up to Last, times length
};

void vtkGodRaysShadowPyramid::Walker::WalkPart(const Map& map, const double a[3], const double b[3],
  double begin, double end, double wa, double wb)
{
  const bool point = this->Pyramid.Grids.Point;
  const bool opaque = this->Pyramid.Opaque;
  const float unit = 1.0f / this->Pyramid.Scale;
  const float az = static_cast<float>(a[2]);
  const float wz = static_cast<float>(b[2] - a[2]);
  const auto getDistance = [&](float s)
  {
    const double u = wa * (1.0 - s);
    const double v = wb * s;
    return static_cast<float>((begin * u + end * v) / (u + v));
  };
  const auto light = [&](float s)
  {
    if (this->Dark[0] + this->Dark[1] + this->Dark[2] > 0.0f)
    {
      this->Set(getDistance(s), 0.0f, 0.0f, 0.0f);
    }
  };
  const auto darken = [&](float s, const float dark[3])
  {
    if (dark[0] != this->Dark[0] || dark[1] != this->Dark[1] || dark[2] != this->Dark[2])
    {
      this->Set(getDistance(s), dark[0], dark[1], dark[2]);
    }
  };
  static const float all[3] = { 1.0f, 1.0f, 1.0f };

  MapWalk walk =
    BeginWalk(static_cast<float>(a[0]), static_cast<float>(a[1]), static_cast<float>(b[0]),
      static_cast<float>(b[1]), map.Size[0], map.Size[1], static_cast<int>(map.Levels.size()));
  // Each turn goes down a level or on by a cell: the bound is never reached, but NaN could.
  for (int guard = 16 * (map.Size[0] + map.Size[1]) + 64; guard > 0; --guard)
  {
    FindEnd(walk);
    const float h0 = az + walk.Begin * wz;
    const float h1 = az + walk.End * wz;
    if (walk.Level > 0)
    {
      const Level& nodes = map.Levels[static_cast<std::size_t>(walk.Level) - 1];
      const std::size_t at = nodes.First +
        static_cast<std::size_t>(walk.Y >> walk.Level) * nodes.Size[0] + (walk.X >> walk.Level);
      const Node node = map.Nodes[at];
      const float least = point ? FromBits(static_cast<std::uint32_t>(node.Least) << 16)
                                : unit * static_cast<float>(node.Least - 1);
      const float most = point ? FromBits(static_cast<std::uint32_t>(node.Most) << 16)
                               : unit * static_cast<float>(node.Most);
      if (node.Most == 0 || std::min(h0, h1) >= most)
      {
        light(walk.Begin);
      }
      else if (node.Least == 0 || std::max(h0, h1) >= least)
      {
        --walk.Level;
        continue;
      }
      else if (opaque)
      {
        darken(walk.Begin, all);
      }
      else
      {
        const Dimming& dims = map.Darker[at];
        int range = 0;
        for (int c = 0; c < 3; ++c)
        {
          range = std::max(range, dims.Most[c] - dims.Least[c]);
        }
        if (static_cast<float>(range) > Codes * this->Pyramid.Alike)
        {
          --walk.Level;
          continue;
        }
        darken(walk.Begin, dims.Mean);
      }
    }
    else
    {
      const float* dark =
        opaque ? all : &map.Darks[3 * (static_cast<std::size_t>(walk.Y) * map.Size[0] + walk.X)];
      const Patch patch = map.GetPatch(walk.X, walk.Y);
      const auto getAbove = [&](float s, float height) {
        return height -
          patch.GetHeight(walk.StartX + s * walk.SlopeX, walk.StartY + s * walk.SlopeY);
      };
      const float before = getAbove(walk.Begin, h0);
      const float after = getAbove(walk.End, h1);
      if (before >= 0.0f && after >= 0.0f)
      {
        light(walk.Begin);
      }
      else if (before < 0.0f && after < 0.0f)
      {
        darken(walk.Begin, dark);
      }
      else
      {
        const float cross = walk.Begin + (walk.End - walk.Begin) * before / (before - after);
        if (before < 0.0f)
        {
          darken(walk.Begin, dark);
          light(cross);
        }
        else
        {
          light(walk.Begin);
          darken(cross, dark);
        }
      }
    }
    if (!GoOn(walk))
    {
      return;
    }
  }
}

// Codes of heights are above 0.
std::uint32_t vtkGodRaysShadowPyramid::EncodeDown(float height) const
{
  return this->Grids.Point
    ? GetBits(std::max(height, 1e-30f)) >> 16
    : 1 + static_cast<std::uint32_t>(std::min(std::max(height * this->Scale, 0.0f), 65000.0f));
}

std::uint32_t vtkGodRaysShadowPyramid::EncodeUp(float height) const
{
  return this->Grids.Point
    ? (GetBits(std::max(height, 1e-30f)) >> 16) + 1
    : 2 + static_cast<std::uint32_t>(std::min(std::max(height * this->Scale, 0.0f), 65000.0f));
}

vtkGodRaysShadowPyramid::Patch vtkGodRaysShadowPyramid::Map::GetPatch(int x, int y) const
{
  const std::ptrdiff_t width = this->Size[0];
  const float* const texel = this->Heights.data() + y * width + x;
  Patch patch = { *texel, 0.0f, 0.0f, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f };
  if (*texel != None)
  {
    patch.SlopeX = TexelSlope(x > 0 ? texel[-1] : None, *texel, x + 1 < width ? texel[1] : None);
    patch.SlopeY =
      TexelSlope(y > 0 ? texel[-width] : None, *texel, y + 1 < this->Size[1] ? texel[width] : None);
  }
  return patch;
}

void vtkGodRaysShadowPyramid::Build(const vtkGodRaysShadowGrids& grids, const double light[3])
{
  const int layers = std::max(grids.NumberOfLayers, 1);
  const bool isSame = grids.Version != 0 && grids.Version == this->Grids.Version &&
    this->Maps.size() == static_cast<std::size_t>(layers) * grids.Levels;
  this->Grids = grids;
  std::copy_n(light, 3, this->Light);
  if (isSame)
  {
    return;
  }
  this->Opaque = grids.NumberOfLayers == 0;
  this->Alike = ::Alike / static_cast<float>(layers);
  this->Scale = static_cast<float>(65000.0 / (grids.Range[1] - grids.Range[0]));
  this->Maps.resize(static_cast<std::size_t>(layers) * grids.Levels);
  for (int layer = 0; layer < layers; ++layer)
  {
    for (int grid = 0; grid < grids.Levels; ++grid)
    {
      Map& map = this->Maps[static_cast<std::size_t>(layer) * grids.Levels + grid];
      this->Fill(grids, grid, layer, map);
      this->Reduce(map);
    }
  }
}

void vtkGodRaysShadowPyramid::Fill(
  const vtkGodRaysShadowGrids& grids, int index, int layer, Map& map) const
{
  const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[index];
  const bool layered = grids.NumberOfLayers > 0;
  const float* depths = layered ? grids.Layers[layer].Depths + grid.First : grid.Depths;
  const int width = map.Size[0] = grid.Size[0];
  map.Size[1] = grid.Size[1];
  map.Heights.resize(static_cast<std::size_t>(width) * grid.Size[1]);
  map.Darks.resize(layered ? 3 * map.Heights.size() : 0);
  const float range = static_cast<float>(grids.Range[1] - grids.Range[0]);
  vtkSMPTools::For(0, grid.Size[1], 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        const float* from = depths + y * grid.Stride;
        float* to = map.Heights.data() + y * width;
        for (int x = 0; x < width; ++x)
        {
          const float here =
            grids.Point ? static_cast<float>(grids.GetNearness(from[x])) : (1.0f - from[x]) * range;
          to[x] = from[x] < 1.0f ? here : None;
        }
        for (int c = 0; layered && c < 3; ++c)
        {
          const float* dark =
            grids.Layers[layer].Dark[grids.Colored ? c : 0] + grid.First + y * grid.Stride;
          for (int x = 0; x < width; ++x)
          {
            map.Darks[3 * (static_cast<std::size_t>(y) * width + x) + c] = dark[x];
          }
        }
      }
    });
}

void vtkGodRaysShadowPyramid::Reduce(Map& map) const
{
  map.Levels.clear();
  std::size_t nodes = 0;
  for (int size[2] = { map.Size[0], map.Size[1] }; size[0] > 1 || size[1] > 1;)
  {
    for (int& each : size)
    {
      each = (each + 1) / 2;
    }
    map.Levels.push_back({ nodes, { size[0], size[1] } });
    nodes += static_cast<std::size_t>(size[0]) * size[1];
  }
  map.Nodes.resize(nodes);
  map.Darker.resize(this->Opaque ? 0 : nodes);
  int width = map.Size[0];
  int height = map.Size[1];
  for (std::size_t level = 0; level < map.Levels.size(); ++level)
  {
    const Level& to = map.Levels[level];
    const std::size_t below = level > 0 ? map.Levels[level - 1].First : 0;
    vtkSMPTools::For(0, to.Size[1], 32,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          for (int x = 0; x < to.Size[0]; ++x)
          {
            std::uint32_t least = 65535;
            std::uint32_t most = 0;
            Dimming dims = { { 65535, 65535, 65535 }, { 0, 0, 0 }, { 0.0f, 0.0f, 0.0f } };
            for (int k = 0; k < 4; ++k)
            {
              const int i = std::min(2 * x + (k & 1), width - 1);
              const int j = std::min(2 * static_cast<int>(y) + (k >> 1), height - 1);
              const std::size_t at = static_cast<std::size_t>(j) * width + i;
              if (level > 0)
              {
                least = std::min<std::uint32_t>(least, map.Nodes[below + at].Least);
                most = std::max<std::uint32_t>(most, map.Nodes[below + at].Most);
              }
              else
              {
                const Patch patch = map.GetPatch(i, j);
                const bool none = patch.Height == None;
                const float rise = 0.5f * (std::abs(patch.SlopeX) + std::abs(patch.SlopeY));
                least = std::min(least, none ? 0 : this->EncodeDown(patch.Height - rise));
                most = std::max(most, none ? 0 : this->EncodeUp(patch.Height + rise));
              }
              for (int c = 0; !this->Opaque && c < 3; ++c)
              {
                const bool isTexel = level == 0;
                const float dark = isTexel ? map.Darks[3 * at + c] : map.Darker[below + at].Mean[c];
                const int low =
                  isTexel ? static_cast<int>(Codes * dark) : map.Darker[below + at].Least[c];
                const int high = isTexel ? static_cast<int>(std::ceil(Codes * dark))
                                         : map.Darker[below + at].Most[c];
                dims.Least[c] = static_cast<std::uint16_t>(std::min<int>(dims.Least[c], low));
                dims.Most[c] = static_cast<std::uint16_t>(std::max<int>(dims.Most[c], high));
                dims.Mean[c] += 0.25f * dark;
              }
            }
            const std::size_t at = to.First + static_cast<std::size_t>(y) * to.Size[0] + x;
            map.Nodes[at] = { static_cast<std::uint16_t>(least), static_cast<std::uint16_t>(most) };
            if (!this->Opaque)
            {
              map.Darker[at] = dims;
            }
          }
        }
      });
    width = to.Size[0];
    height = to.Size[1];
  }
}

void vtkGodRaysShadowPyramid::Walk(const double origin[3], const double direction[3], double end,
  std::vector<Stretch>& stretches) const
{
  const vtkGodRaysShadowGrids& grids = this->Grids;
  if (grids.Levels == 0 || !(end > 0.0))
  {
    return;
  }
  struct Part
  {
    int Grid;
    Interval Ray;
  };
  Part parts[2 * vtkGodRaysShadowGrids::MaximumGrids];
  int count = 0;
  double starts[vtkGodRaysShadowGrids::MaximumGrids][3];
  double changes[vtkGodRaysShadowGrids::MaximumGrids][3];
  Interval inside[vtkGodRaysShadowGrids::MaximumGrids];
  for (int g = 0; g < grids.Levels; ++g)
  {
    const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[g];
    const double away[3] = { -this->Light[0], -this->Light[1], -this->Light[2] };
    for (int k = 0; k < 3; ++k)
    {
      const double* axis = grids.Point ? grid.Axes[k] : k < 2 ? grids.Grids[0].Axes[k] : away;
      starts[g][k] = Along(axis, origin) - (grids.Point ? Along(axis, this->Light) : 0.0);
      changes[g][k] = Along(axis, direction);
    }
    Interval part = { 0.0, end };
    if (grids.Point)
    {
      // Nothing is in the map that is nearer than its range.
      part.Clip(starts[g][2] - 0.5 * grids.Range[0], changes[g][2]);
    }
    for (int k = 0; k < 2; ++k)
    {
      const double low = grid.Low[k];
      const double high = low + grid.Size[k] * grid.Texel[k];
      const double w = grids.Point ? starts[g][2] : 1.0;
      const double dw = grids.Point ? changes[g][2] : 0.0;
      part.Clip(starts[g][k] - low * w, changes[g][k] - low * dw);
      part.Clip(high * w - starts[g][k], high * dw - changes[g][k]);
    }
    part.End = std::max(part.End, part.Begin);
    if (g > 0 && !grids.Point) // within the coarser one
    {
      part.Begin = std::min(std::max(part.Begin, inside[g - 1].Begin), inside[g - 1].End);
      part.End = std::min(std::max(part.End, inside[g - 1].Begin), inside[g - 1].End);
    }
    inside[g] = part;
  }
  if (grids.Point)
  {
    for (int g = 0; g < grids.Levels; ++g)
    {
      if (inside[g].End > inside[g].Begin) // from the nearest on
      {
        int at = count++;
        for (; at > 0 && parts[at - 1].Ray.Begin > inside[g].Begin; --at)
        {
          parts[at] = parts[at - 1];
        }
        parts[at] = { g, inside[g] };
      }
    }
  }
  else
  {
    const int levels = grids.Levels;
    for (int k = 0; k < 2 * levels - 1; ++k)
    {
      const int g = k < levels ? k : 2 * levels - 2 - k;
      const double from = k < levels ? inside[g].Begin : inside[g + 1].End;
      const double to = k < levels - 1 ? inside[g + 1].Begin : inside[g].End;
      if (to > from)
      {
        parts[count++] = { g, { from, to } };
      }
    }
  }
  const int layers = static_cast<int>(this->Maps.size()) / grids.Levels;
  for (int layer = 0; layer < layers; ++layer)
  {
    Walker walker(*this, end, stretches);
    const std::size_t first = stretches.size();
    double last = 0.0;
    for (int k = 0; k < count; ++k)
    {
      const Part& part = parts[k];
      const int g = part.Grid;
      const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[g];
      const Interval& ray = part.Ray;
      if (ray.Begin > last + 1e-6 * end)
      {
        walker.Close(last); // beyond the maps all is lit
      }
      double places[2][3];
      double w[2] = { 1.0, 1.0 };
      for (int i = 0; i < 2; ++i)
      {
        const double at = i == 0 ? ray.Begin : ray.End;
        const double ahead = starts[g][2] + at * changes[g][2];
        w[i] = grids.Point ? 1.0 / ahead : 1.0;
        for (int a = 0; a < 2; ++a)
        {
          places[i][a] = ((starts[g][a] + at * changes[g][a]) * w[i] - grid.Low[a]) / grid.Texel[a];
        }
        // Above the map's far end.
        places[i][2] = grids.Point ? w[i] : grids.Range[1] - ahead;
      }
      walker.WalkPart(this->Maps[static_cast<std::size_t>(layer) * grids.Levels + g], places[0],
        places[1], ray.Begin, ray.End, w[0], w[1]);
      last = ray.End;
    }
    // What ends in the dark goes on: rays that end farther away take this list, too.
    walker.Close(last < end - 1e-6 * end ? last : 1e30);
    // Depths of single precision may end a pixel's ray shortly behind a surface that the map has, too.
    for (std::size_t i = first; i < stretches.size(); ++i)
    {
      stretches[i].End *= 1.0f + Margin;
    }
  }
}
