// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysTableRays.h
 * @brief   the view rays that tables of airlight are made for
 *
 * Private; see vtkGodRaysCoverageTable.h.
 */

#ifndef vtkGodRaysTableRays_h
#define vtkGodRaysTableRays_h

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace vtkGodRays
{
constexpr int FewestRows = 96;
constexpr int FewestColumns = 8;

struct Range
{
  double Low = 1e300;
  double High = -1e300;
  void Add(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
};

// The view ray, for each unit of depth, of a place in pixels.
inline Vec3 GetRay(const CoverageSettings& settings, const CoverageImage& image, double x, double y)
{
  return Vec3(
    (x - image.Center[0]) * settings.PixelSize, (y - image.Center[1]) * settings.PixelSize, 1.0);
}

// What visits the pixels at the picture's edge finds the ends of what has none inside.
inline void VisitEdge(const CoverageImage& image, const std::function<void(double, double)>& visit)
{
  for (int x = 0; x < image.Width; ++x)
  {
    visit(x, 0.0);
    visit(x, image.Height - 1.0);
  }
  for (int y = 0; y < image.Height; ++y)
  {
    visit(0.0, y);
    visit(image.Width - 1.0, y);
  }
}

// Whether the picture shows what is in a direction or its opposite, or, of parallel rays, at a place.
inline bool Shows(
  const CoverageSettings& settings, const CoverageImage& image, const Vec3& direction)
{
  const double z = settings.Parallel ? 1.0 : direction.z;
  const double x = direction.x / (z * settings.PixelSize) + image.Center[0];
  const double y = direction.y / (z * settings.PixelSize) + image.Center[1];
  return x > -1.0 && y > -1.0 && x < image.Width && y < image.Height; // false for NaN
}

inline double GetLongest(const CoverageSettings& settings, const CoverageImage& image)
{
  double longest = 1.0;
  if (!settings.Parallel)
  {
    VisitEdge(image,
      [&](double x, double y)
      { longest = std::max(longest, length(GetRay(settings, image, x, y))); });
  }
  return longest * settings.FarLimit;
}

// Of steps, which may be any number.
inline int CountSteps(double steps, int fewest, int most)
{
  return static_cast<int>(std::ceil(std::min(std::max<double>(steps, fewest), most + 0.0)));
}

// steps: so many at least, unless that is too many.
inline void SetRows(const Range& range, double steps, int most, CoverageTable& table)
{
  table.FirstRow = static_cast<float>(range.Low);
  const double size = range.High - range.Low;
  table.Rows = CountSteps(steps, FewestRows, most);
  table.RowsPerUnit = static_cast<float>((table.Rows - 1.0) / std::max(size, 1e-6));
}

inline void SetColumns(double end, double step, int most, CoverageTable& table)
{
  table.Columns = CountSteps(end / step + 1.0, FewestColumns, most);
  table.ColumnsPerUnit = static_cast<float>((table.Columns - 1.0) / end);
}

inline void MakeRoom(int planes, CoverageTable& table)
{
  for (int p = 0; p < planes; ++p)
  {
    table.Values[p].resize(static_cast<std::size_t>(2 * table.Columns) * table.Rows * table.Slices);
  }
}

// Of a row, as the kernels have it.
inline double GetRowUnits(const CoverageTable& table, vtkIdType row)
{
  return table.FirstRow + row / static_cast<double>(table.RowsPerUnit);
}

// A view ray beside a point light.
struct PointRay
{
  double Foot;
  double Height;
  double Change;

  double GetDistance(double s) const { return std::hypot(this->Height, s - this->Foot); }

  // The units of columns.
  double ToUnits(double s) const
  {
    const double start = PointLightWay(-this->Foot, this->Height);
    const double way = PointLightWay(s - this->Foot, this->Height);
    return std::log1p(
             s * (way + start) / ((this->GetDistance(s) + this->GetDistance(0.0)) * start)) +
      std::log1p(this->Change * s);
  }

  double GetUnitsPerLength(double s) const
  {
    return 1.0 / this->GetDistance(s) + this->Change / (1.0 + this->Change * s);
  }

  // From there to so many units, by Newton's method with steps that are exact where nothing is dimmed.
  double Invert(double s, double units) const
  {
    for (int i = 0; i < 20; ++i)
    {
      const double missing = units - this->ToUnits(s);
      const double r = this->GetDistance(s);
      const double step = missing / (r * this->GetUnitsPerLength(s));
      s = std::max(
        s + r * std::sinh(step) + (s - this->Foot) * 2.0 * std::pow(std::sinh(0.5 * step), 2), 0.0);
      if (std::abs(missing) < 1e-9)
      {
        break;
      }
    }
    return s;
  }
};

// The least scale height; 0 if there is none.
inline double GetLeastScale(const vtkGodRaysMedium& medium)
{
  double scale = 0.0;
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const double height = medium.Components[k].ScaleHeight;
    scale = height > 0.0 && !(scale > 0.0 && scale < height) ? height : scale;
  }
  return scale;
}

// At a height.
inline double GetExtinction(const vtkGodRaysMedium& medium, int color, double height)
{
  double sum = 0.0;
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const vtkGodRaysMedium::Component& component = medium.Components[k];
    sum += (component.Scattering[color] + component.Absorption[color]) *
      (component.ScaleHeight > 0.0 ? ExponentialDensity(height, component.ScaleHeight) : 1.0);
  }
  return sum;
}
}

#endif
