// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPointTable.h"

#include "vtkGodRaysCoverageKernels.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysPlanetTable.h"
#include "vtkGodRaysTableRays.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// Steps of rows and columns, in the units of CoverageTable; bounds of their numbers.
constexpr double PointRowStep = 0.03;
constexpr double PointRowStepOfDepth = 0.1; // [mean free paths]
constexpr double PointColumnStep = 0.2;
constexpr double SliceStepOfHeight = 0.5; // [scale heights]
constexpr double Below = 4.0; // what goes on below a planet's ground ends [scale heights]
constexpr int MostRows = 1024;
constexpr int MostColumns = 1024;
constexpr double ReachOfSlices =
  4.0; // beyond, layers count as they do there [distances of the light]
constexpr double SlicesOfSpot = 16.0; // that fades, times its fineness
constexpr int FewestSlices = 6;
constexpr int MostSlices = 48;
constexpr int MostSlicesByError = 192;
constexpr double SliceError = 5e-4; // of the brightest ray, amid slices
constexpr int MostSlicesAround = 96;
constexpr double AroundPerCosine =
  3.5; // how fast cosines change with the tangent of a quarter, at most
constexpr int MostRowsOfSlices = 512;
constexpr int MostColumnsOfSlices = 256;
constexpr double MostPlaces = 500e3;        // of all slices, unless there are few
constexpr double MostPlacesAround = 1600e3; // of as many as fading takes

// The mean of 1/distance over a pixel is that at this distance from its centre [pixels].
constexpr double NearestOfPixel = 0.28;

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

// Where a place about the light's axis is, for each unit of distance from it.
Vec3 GetPlaceAround(const CoverageSettings& settings, double about)
{
  const double angle = 4.0 * std::atan(about);
  const Vec3 axis(settings.SliceAxis[0], settings.SliceAxis[1], settings.SliceAxis[2]);
  const Vec3 side(settings.SliceSide[0], settings.SliceSide[1], settings.SliceSide[2]);
  return std::cos(angle) * axis + std::sin(angle) * side;
}

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
  lit.ThroughGround = lit.LightHeight >= 0.0 ? 1 : 0; // kernels take the shadow away
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

// The axis about which rays lie: the way to the light, or parallel rays' own.
Vec3 GetAxis(const CoverageSettings& settings, const CoverageTable& table)
{
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  return settings.Parallel ? Vec3(0.0, 0.0, 1.0) : light / double(table.Distance);
}

// Where the view ray of a place in pixels lies about the light, as slices are counted. way: how far it leads
// away from the light's axis, for each unit of length, or where it begins, if rays are parallel.
double GetAbout(
  const CoverageSettings& settings, const CoverageTable& table, const Vec3& place, double& way)
{
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const Vec3 up(settings.SliceAxis[0], settings.SliceAxis[1], settings.SliceAxis[2]);
  const Vec3 across(settings.SliceSide[0], settings.SliceSide[1], settings.SliceSide[2]);
  const Vec3 axis = GetAxis(settings, table);
  const Vec3 ray = settings.Parallel ? place - light : place / length(place);
  const Vec3 away = ray - dot(ray, axis) * axis;
  way = length(away);
  const double side = 1.0 / double(table.InverseSide);
  return settings.Around
    ? std::tan(0.25 * std::atan2(dot(away, across), dot(away, up)))
    : std::min(std::max(dot(away, up) / std::max(way * side, 1e-9), -1.0), 1.0);
}

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
  table.LightRise = static_cast<float>(dot(up, light) / table.Distance);
  const double side = length(cross(GetAxis(settings, table), up));
  table.InverseSide = static_cast<float>(1.0 / std::max(side, 1e-6));
  Range range;
  double widest = 0.0; // way from the light's axis
  VisitEdge(image,
    [&](double x, double y)
    {
      double way;
      range.Add(GetAbout(settings, table, GetRay(settings, image, x, y), way));
      widest = std::max(widest, way * (settings.Parallel ? 1.0 : reach));
    });
  if (Shows(settings, image, light))
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

// Where a ray is so deep in a planet's ground that no pixel reads between there and the ground.
double FindEnd(const LitRay& lit, double scale, double longest)
{
  if (lit.PlanetRadius <= 0.0 || scale <= 0.0)
  {
    return longest;
  }
  const double ground = SkyGroundDistance(lit.PlanetRadius, lit.Height, lit.Slope);
  return ground >= 0.0
    ? ground + Below * scale / std::max(-lit.Slope, std::sqrt(scale / lit.PlanetRadius))
    : longest;
}

// A planet, of whose shadow there is none where rays end before the light's own horizon.
void SetPlanetOfLamp(const CoverageSettings& settings, double longest, CoverageTable& table)
{
  const double room = SetGlobe(settings, table);
  const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
  const Vec3 up(settings.Up[0], settings.Up[1], settings.Up[2]);
  const double eye = GetEyeRadius(settings);
  const double square = dot(light, light) / eye;
  const double ofLamp = room + (2.0 * dot(up, light) + square) / eye;
  table.Planet.LampRoom = static_cast<float>(std::max(ofLamp, 0.0));
  table.Planet.LampAlong = static_cast<float>(-dot(up, light) - square);
  table.Planet.HasShadow =
    ofLamp >= 0.0 && std::sqrt(ofLamp) * eye < longest + std::sqrt(dot(light, light));
}

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

MediumComponent GetComponent(const vtkGodRaysMedium& medium, int k, int color)
{
  const Component none;
  const Component& from = k < medium.NumberOfComponents ? medium.Components[k] : none;
  return { from.Scattering[color], from.Scattering[color] + from.Absorption[color],
    from.ScaleHeight, { from.PhaseFunction, from.Asymmetry },
    { from.SecondPhaseFunction, from.SecondAsymmetry }, from.SecondWeight };
}

// What scatters each colour.
struct PointMedium
{
  MediumComponent Components[3][2];
  double Wholes[3]; // of which a plane's scattering is a part
  int Brightest;

  explicit PointMedium(const vtkGodRaysMedium& medium)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Components[c][0] = GetComponent(medium, 0, c);
      this->Components[c][1] = GetComponent(medium, 1, c);
      this->Wholes[c] = this->Components[c][0].Scattering + this->Components[c][1].Scattering;
    }
    this->Brightest =
      static_cast<int>(std::max_element(this->Wholes, this->Wholes + 3) - this->Wholes);
  }
};

// A ray of the picture amid two slices: how far what is read there is from the integral, to any column
// before the ray's end, and the ray's own light.
struct SliceProbe
{
  double Error = 0.0;
  double Light = 0.0;

  void Measure(const CoverageSettings& settings, const CoverageImage& image,
    const PointMedium& medium, const CoverageTable& table, double x, double y)
  {
    const Vec3 light(settings.Light[0], settings.Light[1], settings.Light[2]);
    const Vec3 place = GetRay(settings, image, x, y);
    const double units = settings.Parallel ? std::hypot(place.x - light.x, place.y - light.y)
                                           : std::tan(0.5 * AngleBetween(place, light));
    const PointRay ray = GetPointRay(settings, table, std::log1p(units / table.RowUnit));
    double way;
    const double about = GetAbout(settings, table, place, way);
    const double slice = (about - table.FirstSlice) * table.SlicesPerUnit;
    const int before = static_cast<int>(std::min(std::max(slice, 0.0), table.Slices - 2.0));
    const int first = std::min(std::max(before - 1, 0), table.Slices - 4);
    // The four slices that are read, and the place itself; the cubic's weights.
    const double a = before + 0.5 - first;
    const double b = a - 1.0;
    const double c = a - 2.0;
    const double d = a - 3.0;
    const double weights[5] = { -b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0,
      a * b * c / 6.0, -1.0 };
    LitRay lit[5];
    for (int i = 0; i < 5; ++i)
    {
      const double from = i < 4 ? first + i : before + 0.5;
      lit[i] = GetLitRay(
        settings, table, ray, (table.FirstSlice + from / table.SlicesPerUnit) / table.InverseSide);
    }
    const double end =
      ray.ToUnits(MediumEnd(lit[4], settings.FarLimit * (settings.Parallel ? 1.0 : length(place))));
    const MediumComponent* components = medium.Components[medium.Brightest];
    double difference = 0.0;
    double s = 0.0;
    for (int column = 1; column < table.Columns && (column - 1) / table.ColumnsPerUnit < end;
         ++column)
    {
      const double next =
        ray.Invert(s, std::min(column / static_cast<double>(table.ColumnsPerUnit), end));
      for (int i = 0; i < 5; ++i)
      {
        const double part = MediumAirlight(components[0], components[1], lit[i], s, next);
        difference += weights[i] * part;
        this->Light += i == 4 ? part : 0.0;
      }
      this->Error = std::max(this->Error, std::abs(difference));
      s = next;
    }
  }
};

// Of rays all over the picture, as a part of the brightest of them.
double FindSliceError(const CoverageSettings& settings, const CoverageImage& image,
  const PointMedium& medium, const CoverageTable& table)
{
  constexpr int columns = 7;
  constexpr int rows = 5;
  std::array<SliceProbe, static_cast<std::size_t>(columns) * rows> probes;
  vtkSMPTools::For(0, columns * rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        probes[i].Measure(settings, image, medium, table,
          (i % columns) * (image.Width - 1.0) / (columns - 1),
          (i / columns) * (image.Height - 1.0) / (rows - 1));
      }
    });
  double error = 0.0;
  double brightest = 0.0;
  for (const SliceProbe& probe : probes)
  {
    error = std::max(error, probe.Error);
    brightest = std::max(brightest, probe.Light);
  }
  return brightest > 0.0 ? error / brightest : 0.0;
}

// Where heights do not tell how fast light changes, as where rays go down to what is dense: as many more
// slices as their error asks for, which falls with the fourth power of their number.
void AddSlices(const CoverageSettings& settings, const CoverageImage& image,
  const PointMedium& medium, CoverageTable& table)
{
  const double places = static_cast<double>(table.Rows) * table.Columns;
  const int most =
    CountSteps(MostPlaces / places, table.Slices, std::max(MostSlicesByError, table.Slices));
  for (int i = 0; i < 3 && table.Slices < most; ++i)
  {
    const double error = FindSliceError(settings, image, medium, table);
    if (!(error > SliceError))
    {
      return;
    }
    const double size = (table.Slices - 1.0) / table.SlicesPerUnit;
    table.Slices = CountSteps(
      1.0 + 1.1 * (table.Slices - 1.0) * std::pow(error / SliceError, 0.25), table.Slices, most);
    table.SlicesPerUnit = static_cast<float>((table.Slices - 1.0) / size);
  }
}
}

namespace vtkGodRays
{
void MakePointTable(const CoverageSettings& settings, const CoverageImage& image,
  const vtkGodRaysMedium& medium, CoverageTable& table)
{
  const double longest = GetLongest(settings, image);
  const double scale = GetLeastScale(medium);
  const PointMedium mixed(medium);
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
  if (table.Slices > 1 && !(settings.Around && settings.Spot.Fades()))
  {
    AddSlices(settings, image, mixed, table);
  }
  MakeRoom(settings.Planes, table);
  if (settings.PlanetRadius > 0.0)
  {
    SetPlanetOfLamp(settings, longest, table);
  }

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
        const double last = FindEnd(lit, scale, longest);
        double sums[CoverageMaximumPlanes] = {};
        double before = 0.0;
        for (int column = 0; column < table.Columns; ++column)
        {
          const double s = ray.Invert(before, column / static_cast<double>(table.ColumnsPerUnit));
          const bool isBeyond = before > last;
          const double r = ray.GetDistance(s);
          const double perColumn = 1.0 / (r * r * ray.GetUnitsPerLength(s) * table.ColumnsPerUnit);
          for (int p = 0; p < settings.Planes; ++p)
          {
            const int color = settings.Planes == 1 ? mixed.Brightest : p;
            const MediumComponent& one = mixed.Components[color][0];
            const MediumComponent& other = mixed.Components[color][1];
            double rate = 0.0;
            if (!isBeyond && mixed.Wholes[color] > 0.0)
            {
              const double gain = ray.Height / mixed.Wholes[color];
              sums[p] += gain * MediumAirlight(one, other, lit, before, s);
              rate = gain * perColumn * MediumIntegrand(one, other, lit, s);
            }
            float* values = table.Values[p].data() + 2 * (row * table.Columns + column);
            values[0] = static_cast<float>(sums[p]);
            values[1] = static_cast<float>(rate);
          }
          before = s;
        }
      }
    });
}

double GetPointHeight(const CoverageSettings& settings, const CoverageTable& table, int row)
{
  return GetPointRay(settings, table, GetRowUnits(table, row)).Height;
}
}
