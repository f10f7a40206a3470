// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCoverageTable.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysPlanetTable.h"
#include "vtkGodRaysTableRays.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// Steps of rows and columns, in the units of CoverageTable; bounds of their numbers.
constexpr double PointRowStep = 0.03;
constexpr double PointRowStepOfDepth = 0.1; // [mean free paths]
constexpr double PointColumnStep = 0.2;
constexpr double SliceStepOfHeight = 0.5; // [scale heights]
constexpr double LayerRowStep = 0.025;
constexpr double LayerColumnStep = 0.12;
constexpr double LayerColumnStepOfHeight = 0.3; // [scale heights]
constexpr int MostRows = 1024;
constexpr int MostColumns = 1024;
constexpr double ReachOfSlices =
  4.0; // beyond, layers count as they do there [distances of the light]
constexpr double SlicesOfSpot = 16.0; // that fades, times its fineness
constexpr int FewestSlices = 6;
constexpr int MostSlices = 48;
constexpr int MostSlicesAround = 96;
constexpr double AroundPerCosine =
  3.5; // how fast cosines change with the tangent of a quarter, at most
constexpr int MostRowsOfSlices = 512;
constexpr int MostColumnsOfSlices = 256;
constexpr double MostPlaces = 500e3;        // of all slices, unless there are few
constexpr double MostPlacesAround = 1600e3; // of as many as fading takes

// The mean of 1/distance over a pixel is that at this distance from its centre [pixels].
constexpr double NearestOfPixel = 0.28;

//------------------------------------------------------------------------------
// Of a row.
PointRay GetPointRay(const CoverageSettings& settings, const CoverageTable& table, double units)
{
  const double place = table.RowUnit * std::expm1(units);
  const double nearest = table.Nearest;
  if (settings.Parallel)
  {
    return { settings.Light[2], std::max(place, nearest), table.Change };
  }
  const double angle = 2.0 * std::atan(place);
  return { table.Distance * std::cos(angle), table.Distance * std::max(std::sin(angle), nearest),
    table.Change };
}

//------------------------------------------------------------------------------
void SetPointRows(
  const CoverageSettings& settings, const CoverageImage& image, int most, CoverageTable& table)
{
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  table.Distance = static_cast<float>(std::max(length(light), 1e-9 * settings.FarLimit));
  const bool isShown = Shows(settings, image, light);
  Range range;
  if (settings.Parallel)
  {
    table.Nearest = static_cast<float>(NearestOfPixel * settings.PixelSize);
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 ray = GetRay(settings, image, x, y);
        range.Add(std::hypot(ray.x - light.x, ray.y - light.y));
      });
  }
  else
  {
    const double cosine = std::abs(light.z) / table.Distance;
    table.Nearest =
      static_cast<float>(NearestOfPixel * settings.PixelSize * std::max(cosine * cosine, 1e-3));
    const bool isInEye = length(light) <= 0.0; // all rays start at it
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 ray = GetRay(settings, image, x, y);
        range.Add(isInEye ? 0.0 : std::tan(0.5 * AngleBetween(ray, light)));
      });
  }
  const double least = settings.Parallel ? table.Nearest : 0.5 * table.Nearest;
  if (isShown && (settings.Parallel || light.z >= 0.0))
  {
    range.Low = least;
  }
  if (isShown && !settings.Parallel && light.z <= 0.0)
  {
    range.High = 1.0 / least;
  }
  range.Low = std::max(range.Low, least);
  range.High =
    std::max(settings.Parallel ? range.High : std::min(range.High, 1.0 / least), range.Low);
  table.RowUnit = static_cast<float>(range.Low);
  const double steps = std::log(0.5 + 0.5 * range.High / range.Low) / PointRowStep;
  const double width = settings.Parallel
    ? range.High - range.Low
    : 2.0 * table.Distance * (std::atan(range.High) - std::atan(range.Low));
  const double depth = table.Change * width;
  SetRows({ std::log1p(range.Low / table.RowUnit), std::log1p(range.High / table.RowUnit) },
    std::max(steps, depth / PointRowStepOfDepth), most, table);
}

//------------------------------------------------------------------------------
// Where a place about the light's axis is, for each unit of distance from it.
Vec3 GetPlaceAround(const CoverageSettings& settings, double about)
{
  const double angle = 4.0 * std::atan(about);
  const Vec3 axis(settings.SliceAxis[0], settings.SliceAxis[1], settings.SliceAxis[2]);
  const Vec3 side(settings.SliceSide[0], settings.SliceSide[1], settings.SliceSide[2]);
  return std::cos(angle) * axis + std::sin(angle) * side;
}

//------------------------------------------------------------------------------
// What the rays of a row share, but for where they lie about the light.
LitRay GetLitRay(
  const CoverageSettings& settings, const CoverageTable& table, const PointRay& ray, double about)
{
  const double radius = settings.PlanetRadius;
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const Vec3 up(settings.Up[0], settings.Up[1], settings.Up[2]);
  const Vec3 sliceAxis(settings.SliceAxis[0], settings.SliceAxis[1], settings.SliceAxis[2]);
  const Vec3 axis(settings.Spot.Axis[0], settings.Spot.Axis[1], settings.Spot.Axis[2]);
  LitRay lit = {};
  lit.Foot = ray.Foot;
  lit.Distance = ray.Height;
  lit.Height = settings.EyeHeight;
  lit.LightHeight =
    MediumHeight(radius, settings.EyeHeight, dot(up, light) / table.Distance, table.Distance);
  lit.PlanetRadius = radius;
  settings.Spot.SetShape(lit);
  if (settings.Parallel)
  {
    // aside of the light, along the slices' axis and across it
    const double side = std::hypot(sliceAxis.x, sliceAxis.y);
    const Vec3 rising =
      side > 1e-6 ? Vec3(sliceAxis.x / side, sliceAxis.y / side, 0.0) : Vec3(1.0, 0.0, 0.0);
    const double share = side > 1e-6 ? std::min(std::max(about / side, -1.0), 1.0) : 0.0;
    const Vec3 level = std::sqrt(1.0 - share * share) * Vec3(-rising.y, rising.x, 0.0);
    const Vec3 aside = settings.Around ? GetPlaceAround(settings, about) : share * rising + level;
    const Vec3 origin = Vec3(light.x, light.y, 0.0) + ray.Height * aside;
    const Vec2 start = MediumStart(radius, settings.EyeHeight, up, origin, Vec3(0.0, 0.0, 1.0));
    lit.Height = start.x;
    lit.Slope = start.y;
    lit.AxisStart = dot(axis, origin - light);
    lit.AxisSlope = axis.z;
  }
  else if (settings.Around)
  {
    const Vec3 along =
      (ray.Foot / table.Distance * light + ray.Height * GetPlaceAround(settings, about)) /
      double(table.Distance);
    lit.Slope = std::min(std::max(dot(up, along), -1.0), 1.0);
    lit.AxisStart = -dot(axis, light);
    lit.AxisSlope = dot(axis, along);
  }
  else
  {
    // of the slices' axis, which is Up in layers
    const double slope = (ray.Foot * table.LightRise + ray.Height * about) / table.Distance;
    lit.Slope = std::min(std::max(slope, -1.0), 1.0);
    lit.AxisStart = -dot(axis, light);
    lit.AxisSlope = dot(axis, sliceAxis) < 0.0 ? -lit.Slope : lit.Slope;
  }
  return lit;
}

//------------------------------------------------------------------------------
// Where rays lie about a point light; only in layers does that matter.
void SetSlices(const CoverageSettings& settings, const CoverageImage& image, double scale,
  double longest, CoverageTable& table)
{
  const double reach = std::min(longest, ReachOfSlices * table.Distance);
  table.Slices = 1;
  table.FirstSlice = table.SlicesPerUnit = table.InverseSide = 0.0f;
  if (scale <= 0.0 && !settings.Spot.Fades())
  {
    return;
  }
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const Vec3 up(settings.SliceAxis[0], settings.SliceAxis[1], settings.SliceAxis[2]);
  const Vec3 across(settings.SliceSide[0], settings.SliceSide[1], settings.SliceSide[2]);
  table.LightRise = static_cast<float>(dot(up, light) / table.Distance);
  const Vec3 axis = settings.Parallel ? Vec3(0.0, 0.0, 1.0) : light / double(table.Distance);
  const double side = length(cross(axis, up));
  table.InverseSide = static_cast<float>(1.0 / std::max(side, 1e-6));
  Range range;
  double widest = 0.0; // way from the light's axis
  VisitEdge(image,
    [&](double x, double y)
    {
      const Vec3 place = GetRay(settings, image, x, y);
      const Vec3 ray = settings.Parallel ? place - light : place / length(place);
      const Vec3 away = ray - dot(ray, axis) * axis;
      const double size = length(away);
      range.Add(settings.Around
          ? std::tan(0.25 * std::atan2(dot(away, across), dot(away, up)))
          : std::min(std::max(dot(away, up) / std::max(size * side, 1e-9), -1.0), 1.0));
      widest = std::max(widest, size * (settings.Parallel ? 1.0 : reach));
    });
  if (Shows(settings, image, light) || Shows(settings, image, axis))
  {
    range = { -1.0, 1.0 };
  }
  const double size = range.High - range.Low;
  const double places = static_cast<double>(table.Rows) * table.Columns;
  const double ofHeight = scale > 0.0 ? size * side * widest / scale / SliceStepOfHeight : 0.0;
  const double ofSpot = SlicesOfSpot * settings.Spot.GetFineness();
  table.Slices = settings.Around
    ? CountSteps(std::max(std::min(AroundPerCosine * ofHeight, MostPlaces / places),
                   std::min(size * ofSpot, MostPlacesAround / places)),
        FewestSlices, MostSlicesAround)
    : CountSteps(
        std::min(std::max(ofHeight, ofSpot), MostPlaces / places), FewestSlices, MostSlices);
  table.FirstSlice = static_cast<float>(range.Low);
  table.SlicesPerUnit = static_cast<float>((table.Slices - 1.0) / std::max(size, 1e-6));
}

//------------------------------------------------------------------------------
// How fast light changes along rays where it is brightest, at the eye or at a point light: what of it
// is extinguished for each unit of length, and how fast their density falls.
double GetChange(const CoverageSettings& settings, const vtkGodRaysMedium& medium, double longest)
{
  const double* light = settings.Light;
  const double* up = settings.Up;
  const double rise = light[0] * up[0] + light[1] * up[1] + light[2] * up[2];
  const double lower = settings.EyeHeight + std::min(rise, 0.0);
  double extinction = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    extinction = std::max(extinction, GetExtinction(medium, c, lower));
  }
  const double scale = GetLeastScale(medium);
  return std::min(extinction + (scale > 0.0 ? 1.0 / scale : 0.0), 1e6 / longest);
}

//------------------------------------------------------------------------------
MediumComponent GetComponent(const vtkGodRaysMedium& medium, int k, int color)
{
  const Component none;
  const Component& from = k < medium.NumberOfComponents ? medium.Components[k] : none;
  return { from.Scattering[color], from.Scattering[color] + from.Absorption[color],
    from.ScaleHeight, { from.PhaseFunction, from.Asymmetry },
    { from.SecondPhaseFunction, from.SecondAsymmetry }, from.SecondWeight };
}

//------------------------------------------------------------------------------
void MakePointTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table)
{
  const double longest = GetLongest(settings, image);
  const double scale = GetLeastScale(medium);
  MediumComponent components[3][2];
  double wholes[3]; // of which a plane's scattering is a part
  for (int c = 0; c < 3; ++c)
  {
    components[c][0] = GetComponent(medium, 0, c);
    components[c][1] = GetComponent(medium, 1, c);
    wholes[c] = components[c][0].Scattering + components[c][1].Scattering;
  }
  const int brightest = static_cast<int>(std::max_element(wholes, wholes + 3) - wholes);
  table.Change = static_cast<float>(GetChange(settings, medium, longest));
  const bool sliced = scale > 0.0 || settings.Spot.Fades();
  SetPointRows(settings, image, sliced ? MostRowsOfSlices : MostRows, table);
  double end = 0.0;
  for (int row = 0; row < table.Rows; ++row)
  {
    end = std::max(end, GetPointRay(settings, table, GetRowUnits(table, row)).ToUnits(longest));
  }
  SetColumns(end, PointColumnStep, sliced ? MostColumnsOfSlices : MostColumns, table);
  SetSlices(settings, image, scale, longest, table);
  MakeRoom(settings.Planes, table);

  vtkSMPTools::For(0, static_cast<vtkIdType>(table.Slices) * table.Rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const PointRay ray = GetPointRay(settings, table, GetRowUnits(table, row % table.Rows));
        const double about = table.Slices == 1
          ? 0.0
          : (table.FirstSlice + row / table.Rows / double(table.SlicesPerUnit)) / table.InverseSide;
        const LitRay lit = GetLitRay(settings, table, ray, about);
        double sums[CoverageMaximumPlanes] = {};
        double before = 0.0;
        for (int column = 0; column < table.Columns; ++column)
        {
          const double s = ray.Invert(before, column / static_cast<double>(table.ColumnsPerUnit));
          const double r = ray.GetDistance(s);
          const double perColumn = 1.0 / (r * r * ray.GetUnitsPerLength(s) * table.ColumnsPerUnit);
          for (int p = 0; p < settings.Planes; ++p)
          {
            const int color = settings.Planes == 1 ? brightest : p;
            const MediumComponent& one = components[color][0];
            const MediumComponent& other = components[color][1];
            const double gain = wholes[color] > 0.0 ? ray.Height / wholes[color] : 0.0;
            sums[p] += gain * MediumAirlight(one, other, lit, before, s);
            float* values = table.Values[p].data() + 2 * (row * table.Columns + column);
            values[0] = static_cast<float>(sums[p]);
            values[1] = static_cast<float>(gain * perColumn * MediumIntegrand(one, other, lit, s));
          }
          before = s;
        }
      }
    });
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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
//------------------------------------------------------------------------------
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
        ? 1.0 / GetPointRay(settings, table, GetRowUnits(table, row % table.Rows)).Height
        : 1.0;
      const double value = table.Values[p][2 * (row * table.Columns + table.Columns - 1)];
      table.Largest[p] = std::max(table.Largest[p], gain * value);
    }
  }
}
}
