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
  vtkGodRaysMultipleScattering::Texture& table = this->Table;
  this->Farthest = farthest > 0.0 ? std::min(farthest, medium.FarLimit) : medium.FarLimit;
  for (int i = 0; i < 2; ++i)
  {
    table.Nodes[i] = std::clamp((picture.Size[i] - 1) / Gap + 2, 2, MostColumns + 1);
    table.Low[i] = -picture.Center[i] * picture.PixelSize;
    table.Cell[i] = picture.Size[i] * picture.PixelSize / (table.Nodes[i] - 1);
  }
  table.Nodes[2] = Slices;
  table.Low[2] = 0.0;
  table.Cell[2] = this->Farthest / (Slices - 1);
  const std::size_t slice = 3 * static_cast<std::size_t>(table.Nodes[0]) * table.Nodes[1];
  table.Values.resize(Slices * slice);
  const auto trace = [&](int column, int row)
  {
    const double x = table.Low[0] + column * table.Cell[0];
    const double y = table.Low[1] + row * table.Cell[1];
    const Vec3 offset = x * axes[0] + y * axes[1];
    const Vec3 toward = parameters.Parallel ? axes[2] : axes[2] + offset;
    const Vec3 start = parameters.Parallel ? offset : Vec3(0.0); // from the eye
    const double perDepth = vtkGodRays::length(toward);
    const vtkGodRays::Vec2 begin = vtkGodRays::MediumStart(
      medium.PlanetRadius, medium.EyeHeight, vertical, start, toward / perDepth);
    float* value =
      table.Values.data() + 3 * (static_cast<std::size_t>(row) * table.Nodes[0] + column);
    Vec3 sum(0.0);
    Vec3 before(1.0); // transmittance
    std::fill_n(value, 3, 0.0f);
    for (int k = 1; k < Slices; ++k)
    {
      const double end = k * table.Cell[2];
      const double middle = (k - 0.5) * table.Cell[2];
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
  vtkSMPTools::For(0, table.Nodes[1],
    [&](vtkIdType first, vtkIdType last)
    {
      for (int row = static_cast<int>(first); row < last; ++row)
      {
        for (int column = 0; column < table.Nodes[0]; ++column)
        {
          trace(column, row);
        }
      }
    });
}
