// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageTable.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysPlanetTable.h"
#include "vtkGodRaysPointTable.h"
#include "vtkGodRaysTableRays.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// Steps of rows and columns, in the units of CoverageTable; bounds of their numbers.
constexpr double LayerRowStep = 0.025;
constexpr double LayerColumnStep = 0.12;
constexpr double LayerColumnStepOfHeight = 0.3; // [scale heights]
constexpr int MostRows = 1024;
constexpr int MostColumns = 1024;

// A view ray through layers, lit from above.
struct LayeredRay
{
  const vtkGodRaysMedium& Medium;
  double Height; // of its origin
  double Slope;
  double LightSlope;

  // What of the light is scattered by each component and reaches the eye, for each length.
  void Evaluate(double s, int channels, double* results) const
  {
    const int components = this->Medium.NumberOfComponents;
    double depths[3] = {};
    double densities[vtkGodRaysMedium::MaximumComponents];
    for (int k = 0; k < components; ++k)
    {
      const Component& component = this->Medium.Components[k];
      const double scale = component.ScaleHeight;
      double way = s;
      densities[k] = 1.0;
      if (scale > 0.0)
      {
        densities[k] = ExponentialDensity(this->Height + this->Slope * s, scale);
        way = ExponentialDepth(1.0, this->Height, this->Slope, scale, s) +
          scale * densities[k] / this->LightSlope;
      }
      for (int c = 0; c < channels; ++c)
      {
        depths[c] += (component.Scattering[c] + component.Absorption[c]) * way;
      }
    }
    for (int c = 0; c < channels; ++c)
    {
      const double left = std::exp(-depths[c]);
      for (int k = 0; k < components; ++k)
      {
        results[k * channels + c] = left * densities[k];
      }
    }
  }
};

void MakeLayeredTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table)
{
  const Vec3 up(settings.Up[0], settings.Up[1], settings.Up[2]);
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const double lightSlope = dot(light, up);
  const double longest = GetLongest(settings, image);
  const double scale = GetLeastScale(medium);
  table.Slices = 1;

  // Rows
  Range range;
  double step = LayerRowStep;
  table.RowUnit = static_cast<float>(std::min(std::max(scale / longest, 1e-5), 1.0));
  if (settings.Parallel)
  {
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 ray = GetRay(settings, image, x, y);
        range.Add(settings.EyeHeight + ray.x * up.x + ray.y * up.y);
      });
    step *= scale;
  }
  else
  {
    const auto add = [&](double slope) { range.Add(std::asinh(slope / table.RowUnit)); };
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 ray = GetRay(settings, image, x, y);
        add(dot(ray, up) / length(ray));
      });
    if (Shows(settings, image, up))
    {
      add(up.z > 0.0 ? 1.0 : -1.0);
    }
  }
  SetRows(range, (range.High - range.Low) / step, MostRows, table);
  const auto getRay = [&](vtkIdType row) -> LayeredRay
  {
    const double units = GetRowUnits(table, row);
    if (settings.Parallel)
    {
      return { medium, units, up.z, lightSlope };
    }
    const double slope = table.RowUnit * std::sinh(units);
    return { medium, settings.EyeHeight, std::min(std::max(slope, -1.0), 1.0), lightSlope };
  };

  // Columns: the widths are where the light changes from the eye on.
  table.InverseWidths.resize(table.Rows);
  double end = 0.0;
  double drop = 1.0; // of a ray until no light is left [scale heights]
  for (int row = 0; row < table.Rows; ++row)
  {
    const LayeredRay ray = getRay(row);
    double rate = 0.0;
    double ground = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < medium.NumberOfComponents; ++k)
      {
        const Component& component = medium.Components[k];
        ground = std::max(ground, component.Scattering[c] + component.Absorption[c]);
      }
      rate = std::max(rate, GetExtinction(medium, c, ray.Height));
    }
    rate += std::hypot(ray.Slope, table.RowUnit) / scale + 1.0 / longest;
    table.InverseWidths[row] = static_cast<float>(std::min(rate, 1e20));
    end = std::max(end, std::log1p(longest * table.InverseWidths[row]));
    const double most = -ray.Slope * longest / scale;
    drop = std::max(
      drop, std::min(most, ray.Height / scale - std::log(std::min(ground * scale, 1.0) + 1e-30)));
  }
  SetColumns(end, std::min(LayerColumnStep, LayerColumnStepOfHeight / drop), MostColumns, table);
  MakeRoom(settings.Planes, table);

  vtkSMPTools::For(0, table.Rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const LayeredRay ray = getRay(row);
        const double width = 1.0 / table.InverseWidths[row];
        double sums[CoverageMaximumPlanes] = {};
        double here[CoverageMaximumPlanes] = {};
        double before = 0.0;
        for (int column = 0; column < table.Columns; ++column)
        {
          const double s = width * std::expm1(column / static_cast<double>(table.ColumnsPerUnit));
          if (lightSlope > 0.0)
          {
            // Gauss-Legendre of 4 points
            const double places[4] = { -0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
              0.8611363115940526 };
            const double weights[4] = { 0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
              0.3478548451374538 };
            for (int i = 0; i < 4; ++i)
            {
              ray.Evaluate(
                0.5 * (before + s) + 0.5 * (s - before) * places[i], settings.Channels, here);
              for (int p = 0; p < settings.Planes; ++p)
              {
                sums[p] += 0.5 * (s - before) * weights[i] * here[p];
              }
            }
            ray.Evaluate(s, settings.Channels, here);
          }
          for (int p = 0; p < settings.Planes; ++p)
          {
            float* values = table.Values[p].data() + 2 * (row * table.Columns + column);
            values[0] = static_cast<float>(sums[p]);
            values[1] = static_cast<float>(here[p] * (s + width) / table.ColumnsPerUnit);
          }
          before = s;
        }
      }
    });
}
}

namespace vtkGodRays
{
void MakeCoverageTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table)
{
  table.LinearSlices = false;
  table.Kind = settings.Point     ? CoverageTable::POINT
    : settings.PlanetRadius > 0.0 ? CoverageTable::PLANET
                                  : CoverageTable::LAYERS;
  if (settings.Point)
  {
    MakePointTable(settings, image, medium, table);
  }
  else if (table.Kind == CoverageTable::PLANET)
  {
    MakePlanetTable(settings, image, medium, table);
  }
  else
  {
    MakeLayeredTable(settings, image, medium, table);
  }
  for (int p = 0; p < settings.Planes; ++p)
  {
    table.Largest[p] = 0.0;
    for (vtkIdType row = 0; row < static_cast<vtkIdType>(table.Slices) * table.Rows; ++row)
    {
      const double gain = settings.Point
        ? 1.0 / GetPointHeight(settings, table, static_cast<int>(row % table.Rows))
        : 1.0;
      const double value = table.Values[p][2 * (row * table.Columns + table.Columns - 1)];
      table.Largest[p] = std::max(table.Largest[p], gain * value);
    }
  }
}
}
