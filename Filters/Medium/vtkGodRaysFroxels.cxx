// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysFroxels.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
using vtkGodRays::Vec3;

// Columns of a picture: the source has some 30 nodes across it, so that 16 pixels are much narrower than its
// cells; more than 120 resolve nothing more.
constexpr int Gap = 16; // [pixels]
constexpr int MostColumns = 120;

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

/// Finds the node before a place and the part of the way to the next one.
int FindNode(double place, int nodes, double& part)
{
  const double within = std::clamp(place, 0.0, nodes - 1.0);
  const int node = std::min(static_cast<int>(within), std::max(nodes - 2, 0));
  part = within - node;
  return node;
}

/// Interpolates three channels between two corners at each axis.
Vec3 Interpolate(const float* corner, const std::ptrdiff_t strides[3], const double parts[3])
{
  Vec3 sum(0.0);
  for (int k = 0; k < 8; ++k)
  {
    std::ptrdiff_t offset = 0;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool upper = (k >> axis & 1) != 0;
      weight *= upper ? parts[axis] : 1.0 - parts[axis];
      offset += upper ? strides[axis] : 0;
    }
    if (weight > 0.0) // the corner beyond the last node is not there
    {
      sum += weight * Vec3(corner[offset], corner[offset + 1], corner[offset + 2]);
    }
  }
  return sum;
}

/// Adds up a medium's components: scattering and scaled extinction where the density is 1, each times a
/// density or length.
struct Sums
{
  Vec3 Scattering = Vec3(0.0);
  Vec3 Extinction = Vec3(0.0);

  void Add(const vtkGodRaysMedium::Component& component, double forward, double density)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double scattering = component.Scattering[c];
      this->Scattering[c] += density * scattering;
      this->Extinction[c] += density *
        vtkGodRays::ScaledExtinction(scattering + component.Absorption[c], scattering, forward);
    }
  }
};
}

void vtkGodRaysFroxels::Build(const vtkGodRaysSingleScattering::Parameters& parameters,
  const Picture& picture, const Source& source)
{
  const vtkGodRaysMedium& medium = parameters.Medium;
  const Vec3 eye = ToVector(parameters.Position);
  const Vec3 axes[3] = { ToVector(parameters.Right), ToVector(parameters.Up),
    ToVector(parameters.Forward) };
  const Vec3 vertical = medium.Up[0] * axes[0] + medium.Up[1] * axes[1] + medium.Up[2] * axes[2];
  // Beyond twice the depth of the lattice little is added that depends on it.
  double farthest = 0.0;
  for (int k = 0; k < 8; ++k)
  {
    Vec3 corner = source.Low - eye;
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] += (k >> axis & 1) * (source.Nodes[axis] - 1) * source.Cell[axis];
    }
    farthest = std::max(farthest, 2.0 * vtkGodRays::dot(corner, axes[2]));
  }
  this->Farthest = farthest > 0.0 ? std::min(farthest, medium.FarLimit) : medium.FarLimit;
  for (int i = 0; i < 2; ++i)
  {
    this->Count[i] = std::clamp((picture.Size[i] - 1) / Gap + 2, 2, MostColumns + 1);
    this->Corner[i] = -picture.Center[i] * picture.PixelSize;
    this->Step[i] = picture.Size[i] * picture.PixelSize / (this->Count[i] - 1);
  }
  const std::size_t slice = 3 * static_cast<std::size_t>(this->Count[0]) * this->Count[1];
  this->Values.resize(Slices * slice);
  const auto trace = [&](int column, int row)
  {
    const double x = this->Corner[0] + column * this->Step[0];
    const double y = this->Corner[1] + row * this->Step[1];
    const Vec3 offset = x * axes[0] + y * axes[1];
    const Vec3 toward = parameters.Parallel ? axes[2] : axes[2] + offset;
    const Vec3 start = parameters.Parallel ? offset : Vec3(0.0); // from the eye
    const double perDepth = vtkGodRays::length(toward);
    const vtkGodRays::Vec2 begin = vtkGodRays::MediumStart(
      medium.PlanetRadius, medium.EyeHeight, vertical, start, toward / perDepth);
    float* value =
      this->Values.data() + 3 * (static_cast<std::size_t>(row) * this->Count[0] + column);
    Vec3 sum(0.0);
    Vec3 before(1.0); // transmittance
    std::fill_n(value, 3, 0.0f);
    for (int k = 1; k < Slices; ++k)
    {
      const double end = this->Farthest * k / (Slices - 1);
      const double middle = this->Farthest * (k - 0.5) / (Slices - 1);
      const double height =
        vtkGodRays::MediumHeight(medium.PlanetRadius, begin.x, begin.y, perDepth * middle);
      Sums way;
      Sums place;
      for (int i = 0; i < medium.NumberOfComponents; ++i)
      {
        const vtkGodRaysMedium::Component& component = medium.Components[i];
        const double scale = component.ScaleHeight;
        way.Add(component, source.ForwardPart,
          vtkGodRays::MediumDepth(medium.PlanetRadius, begin.x, begin.y, scale, perDepth * end));
        place.Add(component, source.ForwardPart,
          scale > 0.0 ? vtkGodRays::ExponentialDensity(height, scale) : 1.0);
      }
      const Vec3 after = vtkGodRays::exp(-way.Extinction);
      sum += source.Sample(eye + start + middle * toward) * place.Scattering * (before - after) /
        vtkGodRays::max(place.Extinction, Vec3(1e-300));
      before = after;
      value += slice;
      for (int c = 0; c < 3; ++c)
      {
        value[c] = static_cast<float>(sum[c]);
      }
    }
  };
  vtkSMPTools::For(0, this->Count[1],
    [&](vtkIdType first, vtkIdType last)
    {
      for (int row = static_cast<int>(first); row < last; ++row)
      {
        for (int column = 0; column < this->Count[0]; ++column)
        {
          trace(column, row);
        }
      }
    });
}

Vec3 vtkGodRaysFroxels::Get(double x, double y, double depth) const
{
  const std::ptrdiff_t strides[3] = { 3, 3 * static_cast<std::ptrdiff_t>(this->Count[0]),
    3 * static_cast<std::ptrdiff_t>(this->Count[0]) * this->Count[1] };
  double parts[3];
  const std::ptrdiff_t first =
    strides[0] * FindNode((x - this->Corner[0]) / this->Step[0], this->Count[0], parts[0]) +
    strides[1] * FindNode((y - this->Corner[1]) / this->Step[1], this->Count[1], parts[1]) +
    strides[2] * FindNode(depth / this->Farthest * (Slices - 1), Slices, parts[2]);
  return Interpolate(this->Values.data() + first, strides, parts);
}
