// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPlanetTable.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysTableRays.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

constexpr int Components = vtkGodRaysMedium::MaximumComponents;

// Steps, in the units of CoverageTable; bounds of their numbers.
constexpr double RowStep = 0.025;
constexpr double ColumnStep = 0.12;
constexpr double ColumnStepOfDusk = 0.08;
constexpr double SliceStep = 0.2;        // of where the light's depth changes by 1/e
constexpr double LinearSliceStep = 0.06; // between slices that are read in half the time
constexpr int MostLinearSlices = 10;
constexpr int MostRows = 512;
constexpr int MostColumns = 192;
constexpr int FewestSlices = 6;
constexpr int MostSlices = 96;

constexpr double Top = 15.0;  // above, nothing is scattered [scale heights]
constexpr double Deep = 12.0; // what goes on below the ground ends [scale heights]
constexpr double Below = 2.0; // the same of view rays
constexpr double Low = 12.0;  // light that is level so high shines through [half scale heights]

// What the table's rays share.
class Planet
{
public:
  Planet(const CoverageSettings& settings, const vtkGodRaysMedium& medium)
    : Medium(medium)
    , Parallel(settings.Parallel)
    , Ground(settings.PlanetRadius)
    , Eye(GetEyeRadius(settings))
    , UpZ(settings.Up[2])
    , LightZ(settings.Light[2])
    , LightSlope(settings.Light[0] * settings.Up[0] + settings.Light[1] * settings.Up[1] +
        settings.Light[2] * settings.Up[2])
    , Least(GetLeastScale(medium))
  {
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      this->Highest = std::max(this->Highest, medium.Components[k].ScaleHeight);
    }
    const double reach =
      std::sqrt(2.0 * this->Ground * (this->Least + std::max(settings.EyeHeight, 0.0)));
    this->Reach = reach;
  }

  // Of a parallel ray whose line is at least so far from the centre.
  double GetUnits(double least, double unit) const
  {
    const double start = std::hypot(least, this->Eye * this->UpZ);
    return std::asinh((least - this->Ground) / unit) + std::asinh((start - this->Ground) / unit);
  }

  double FindLeast(double units, double unit) const
  {
    double low = 0.0;
    double high = 2.0 * this->Eye;
    for (int i = 0; i < 1100 && this->GetUnits(high, unit) < units; ++i)
    {
      high *= 2.0;
    }
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (this->GetUnits(middle, unit) < units ? low : high) = middle;
    }
    return low;
  }

  const vtkGodRaysMedium& Medium;
  const bool Parallel;
  const double Ground;
  const double Eye; // distance from the centre
  const double UpZ;
  const double LightZ;
  const double LightSlope;
  const double Least; // scale height
  double Highest = 0.0;
  double Reach; // of level rays to where the air is left
};

// The rays of a row.
struct PlanetRow
{
  double Height; // of their start
  double Slope;
  double End; // of what is worth a look
  PointRay Columns;
};

PlanetRow GetRow(const Planet& planet, const CoverageTable& table, double units, double longest)
{
  PlanetRow row = {};
  if (planet.Parallel)
  {
    const double least = planet.FindLeast(units, table.RowUnit);
    const double along = planet.Eye * planet.UpZ;
    const double radius = std::max(std::hypot(least, along), 1e-6 * planet.Ground);
    row.Height = radius - planet.Ground;
    row.Slope = std::min(std::max(along / radius, -1.0), 1.0);
  }
  else
  {
    row.Height = planet.Eye - planet.Ground;
    const double slope = table.Planet.Horizon + table.RowUnit * std::sinh(units);
    row.Slope = std::min(std::max(slope, -1.0), 1.0);
  }
  const double radius = planet.Ground + row.Height;
  const double ground = SkyGroundDistance(planet.Ground, row.Height, row.Slope);
  const double foot =
    std::min(ground >= 0.0 ? ground : std::max(-radius * row.Slope, 0.0), longest);
  const double there = radius + SkyRise(radius, row.Slope, foot);
  // The way along which the air becomes denser by e: Least = slope s + s^2/(2 Eye).
  const double steep = std::hypot((radius * row.Slope + foot) / there, planet.Least / longest);
  const double height =
    2.0 * planet.Least / (steep + std::sqrt(steep * steep + 2.0 * planet.Least / planet.Eye));
  // So that it does not matter to a ray along which the air changes little where that is.
  row.Columns = { std::hypot(foot, height) - height, height, table.Change };
  row.End = std::min(longest, ground >= 0.0 ? ground + height : longest);
  bool isEverywhere = false;
  for (int k = 0; k < planet.Medium.NumberOfComponents; ++k)
  {
    isEverywhere = isEverywhere || planet.Medium.Components[k].ScaleHeight <= 0.0;
  }
  if (!isEverywhere)
  {
    const double top = std::max(row.Height, 0.0) > Top * planet.Highest
      ? Top * planet.Highest
      : std::max(row.Height, 0.0) + Top * planet.Highest;
    row.End =
      std::min(row.End, std::max(SkyBelow(planet.Ground, row.Height, row.Slope, top).y, foot));
  }
  return row;
}

// A place of a row: all that its slices share.
struct PlanetPlace
{
  double Height;
  double Density[Components];
  double Way[Components]; // to the eye, times the mean density
};

PlanetPlace GetPlace(const Planet& planet, const PlanetRow& row, double s)
{
  PlanetPlace place = {};
  place.Height = MediumHeight(planet.Ground, row.Height, row.Slope, s);
  const bool isDeep = place.Height < -Below * planet.Least && place.Height < row.Height;
  for (int k = 0; k < planet.Medium.NumberOfComponents; ++k)
  {
    const double scale = planet.Medium.Components[k].ScaleHeight;
    place.Density[k] = isDeep ? 0.0 : scale > 0.0 ? ExponentialDensity(place.Height, scale) : 1.0;
    place.Way[k] = isDeep ? 0.0 : MediumDepth(planet.Ground, row.Height, row.Slope, scale, s);
  }
  return place;
}

// The light's way to a place of a density, times the mean density along it: SkyExponentialColumn() to
// where no air is left.
double GetColumn(const Planet& planet, double radius, double slope, double scale, double density)
{
  const double above = density * ChapmanColumn(radius, std::abs(slope), scale);
  if (slope >= 0.0)
  {
    return above;
  }
  const double least = radius * std::sqrt(1.0 - slope * slope);
  const double most = ExponentialDensity(least - planet.Ground, scale);
  return std::max(2.0 * most * ChapmanColumn(least, 0.0, scale) - above, 0.0);
}

// What of the light is scattered by each component and reaches the eye, for each length.
void Evaluate(const Planet& planet, const CoverageSettings& settings, const PlanetPlace& place,
  double lightSlope, double* results)
{
  const vtkGodRaysMedium& medium = planet.Medium;
  const double radius = planet.Ground + place.Height;
  double slope = std::min(std::max(lightSlope, -1.0), 1.0);
  const double deepest = std::max(planet.Ground - Deep * planet.Highest, 0.5 * planet.Ground);
  if (slope < 0.0 && deepest < radius)
  {
    const double part = deepest / radius;
    slope = std::max(slope, -std::sqrt(1.0 - part * part));
  }
  slope = deepest < radius ? slope : std::max(slope, 0.0);
  double depths[3] = {};
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    const double scale = component.ScaleHeight;
    const double way = place.Way[k] +
      (scale > 0.0 ? GetColumn(planet, radius, slope, scale, place.Density[k]) : 0.0);
    for (int c = 0; c < settings.Channels; ++c)
    {
      depths[c] += (component.Scattering[c] + component.Absorption[c]) * way;
    }
  }
  for (int c = 0; c < settings.Channels; ++c)
  {
    const double left = std::exp(-depths[c]);
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      results[k * settings.Channels + c] = left * place.Density[k];
    }
  }
}

void SetPlanetOfSun(
  const Planet& planet, const CoverageSettings& settings, double longest, CoverageTable& table)
{
  const double room = SetGlobe(settings, table);
  table.Planet.Longest = static_cast<float>(longest / planet.Eye);
  table.Planet.Scale = static_cast<float>(planet.Least / planet.Eye);
  table.Planet.LightSlope = static_cast<float>(planet.LightSlope);
  table.Planet.Horizon = static_cast<float>(-std::sqrt(std::max(room, 0.0)));
}

// Rows and the range of slices.
Range SetRowsOfPlanet(const Planet& planet, const CoverageSettings& settings,
  const CoverageImage& image, double longest, CoverageTable& table)
{
  const Vec3 up(settings.Up[0], settings.Up[1], settings.Up[2]);
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  Range rows;
  Range slices;
  if (planet.Parallel)
  {
    table.RowUnit = static_cast<float>(planet.Least);
    const auto add = [&](double x, double y)
    {
      const double least = std::hypot(planet.Eye * up.x + x, planet.Eye * up.y + y);
      rows.Add(planet.GetUnits(least, table.RowUnit));
    };
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 place = GetRay(settings, image, x, y);
        add(place.x, place.y);
        slices.Add(place.x * light.x + place.y * light.y);
      });
    const Vec3 centre = -planet.Eye * up;
    if (Shows(settings, image, centre))
    {
      add(centre.x, centre.y);
    }
  }
  else
  {
    table.RowUnit = static_cast<float>(
      std::min(std::max(planet.Least / std::min(longest, planet.Reach), 1e-5), 1.0));
    const auto add = [&](double slope)
    { rows.Add(std::asinh((slope - table.Planet.Horizon) / table.RowUnit)); };
    VisitEdge(image,
      [&](double x, double y)
      {
        const Vec3 ray = GetRay(settings, image, x, y);
        add(dot(ray, up) / length(ray));
        slices.Add(dot(ray, light) / length(ray));
      });
    if (Shows(settings, image, up))
    {
      add(up.z > 0.0 ? 1.0 : -1.0);
    }
    if (Shows(settings, image, light))
    {
      slices.Add(light.z > 0.0 ? 1.0 : -1.0);
    }
  }
  SetRows(rows, (rows.High - rows.Low) / RowStep, MostRows, table);
  return slices;
}

// So many that the light's depth is smooth between them, farthest from the eye.
void SetSlicesOfPlanet(
  const Planet& planet, const Range& slices, double farthest, CoverageTable& table)
{
  const double size = std::max(slices.High - slices.Low, 1e-6);
  const double most = std::max(std::abs(slices.Low), std::abs(slices.High));
  const double change = (planet.Parallel ? size : size * farthest) / planet.Ground;
  const double low =
    planet.LightSlope - (planet.Parallel ? most + farthest : farthest) / planet.Ground;
  const double thin = planet.Least / planet.Ground;
  // Below the horizon it is the least height of the light's way that changes.
  const double below = std::min(std::max(-low, 0.0), std::sqrt(Low * thin));
  const double scale =
    1.0 / (1.0 / std::sqrt(2.0 * thin + std::pow(std::max(low, 0.0), 2)) + 0.5 * below / thin);
  const double steps = change / scale / LinearSliceStep;
  table.LinearSlices = steps <= MostLinearSlices;
  table.Slices = table.LinearSlices
    ? CountSteps(steps, 1, MostLinearSlices) + 1
    : CountSteps(change / scale / SliceStep, FewestSlices, MostSlices);
  table.FirstSlice = static_cast<float>(slices.Low);
  table.SlicesPerUnit = static_cast<float>((table.Slices - 1.0) / size);
}

// A row of all slices, by the cubic through a column's ends and their neighbours, in the units of columns.
void FillRow(const Planet& planet, const CoverageSettings& settings, const PlanetRow& row,
  int index, CoverageTable& table)
{
  const double step = 1.0 / table.ColumnsPerUnit;
  const int planes = settings.Planes;
  // Of columns, one more than the table's: what comes from each unit.
  std::vector<PlanetPlace> places(table.Columns + 1);
  std::vector<double> lengths(places.size());
  std::vector<double> perColumn(places.size());
  double s = 0.0;
  int used = 0; // the last ones are beyond what is worth a look
  for (int column = 0; column <= table.Columns; ++column)
  {
    const bool isBeyond = s > row.End;
    s = column > 0 ? row.Columns.Invert(s, column * step) : 0.0;
    lengths[column] = s;
    perColumn[column] = step / row.Columns.GetUnitsPerLength(s);
    if (isBeyond)
    {
      break;
    }
    places[column] = GetPlace(planet, row, s);
    used = column + 1;
  }
  std::vector<double> rates(places.size() * planes, 0.0);
  for (int slice = 0; slice < table.Slices; ++slice)
  {
    const double value = table.FirstSlice + slice / double(table.SlicesPerUnit);
    for (int column = 0; column < used; ++column)
    {
      const double way = lengths[column];
      const double towards = planet.Eye * planet.LightSlope +
        (planet.Parallel ? value + way * planet.LightZ : way * value);
      double* here = rates.data() + static_cast<std::size_t>(planes) * column;
      Evaluate(
        planet, settings, places[column], towards / (planet.Ground + places[column].Height), here);
      for (int p = 0; p < planes; ++p)
      {
        here[p] *= perColumn[column];
      }
    }
    for (int p = 0; p < planes; ++p)
    {
      const auto rate = [&](int column) { return rates[column * std::size_t(planes) + p]; };
      float* values = table.Values[p].data() +
        2 * (static_cast<std::size_t>(slice) * table.Rows + index) * table.Columns;
      double sum = 0.0;
      for (int column = 0; column < table.Columns; ++column, values += 2)
      {
        if (column > 0 && column < used)
        {
          const double before = column > 1 ? rate(column - 2) : 3.0 * (rate(0) - rate(1)) + rate(2);
          const double after =
            column + 1 < used ? rate(column + 1) : 2.0 * rate(column) - rate(column - 1);
          sum += (13.0 * (rate(column - 1) + rate(column)) - before - after) / 24.0;
        }
        values[0] = static_cast<float>(sum);
        values[1] = static_cast<float>(column < used ? rate(column) : 0.0);
      }
    }
  }
}
}

namespace vtkGodRays
{
double GetEyeRadius(const CoverageSettings& settings)
{
  return std::max(settings.PlanetRadius + settings.EyeHeight, 1e-6 * settings.PlanetRadius);
}

double SetGlobe(const CoverageSettings& settings, CoverageTable& table)
{
  const double eye = GetEyeRadius(settings);
  const double ground = settings.PlanetRadius / eye;
  const double room = settings.EyeHeight / eye * (1.0 + ground); // without cancellation
  table.Planet.Radius = static_cast<float>(eye);
  table.Planet.Ground = static_cast<float>(ground);
  table.Planet.Room = static_cast<float>(room);
  table.Planet.Excess = static_cast<float>(room - settings.Up[2] * settings.Up[2]);
  return room;
}

void MakePlanetTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table)
{
  const Planet planet(settings, medium);
  const double longest = GetLongest(settings, image);
  SetPlanetOfSun(planet, settings, longest, table);
  double change = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    change = std::max(change, GetExtinction(medium, c, settings.EyeHeight));
  }
  table.Change = static_cast<float>(std::min(change, 1e6 / longest));
  const Range slices = SetRowsOfPlanet(planet, settings, image, longest, table);
  std::vector<PlanetRow> rows(table.Rows);
  double end = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < table.Rows; ++i)
  {
    rows[i] = GetRow(planet, table, GetRowUnits(table, i), longest);
    end = std::max(end, rows[i].Columns.ToUnits(rows[i].End));
    farthest = std::max(farthest, rows[i].End);
  }
  // Nothing is darker than where the light is level.
  table.Planet.HasShadow =
    planet.Eye * planet.LightSlope + (planet.Parallel ? slices.Low : 0.0) < farthest;
  SetColumns(end, table.Planet.HasShadow ? ColumnStepOfDusk : ColumnStep, MostColumns, table);
  SetSlicesOfPlanet(planet, slices, farthest, table);
  MakeRoom(settings.Planes, table);
  vtkSMPTools::For(0, table.Rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        FillRow(planet, settings, rows[row], static_cast<int>(row), table);
      }
    });
}
}
