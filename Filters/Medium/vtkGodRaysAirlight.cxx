// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAirlight.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPhaseTable.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// Of the spline along a ray. With 64, interpolation is within 1e-4 of a ray's light in the tests' scenes.
constexpr int NumberOfParts = 64;
constexpr int NumberOfNodes = NumberOfParts + 1;

// Of the table's coarsest rays, in the picture's height, about.
constexpr double NumberOfRows = 64.0;

// What a ray may be off the mean of those beside it [fraction].
constexpr float RayTolerance = 1e-3f;

// A point light is no nearer to a view ray than that: 1/distance is then the mean over its pixel [pixels].
constexpr double NearestPass = 0.28;

// What is left of a spotlight's light where it ends, at the least.
constexpr double LeastFade = 1e-5;

// Steps over which a spotlight's fade is a constant: for one that is even, and what is added for one that fades to
// nothing.
constexpr double LeastSteps = 3.0;
constexpr double MoreSteps = 6.0;
constexpr int FadeEntries = 2048;

// Places that are evaluated together.
constexpr int Batch = 64;

// e^-x for x from 0 to 80, to 2e-7, in a loop that compilers vectorise.
inline float ExpMinus(float x)
{
  const float turns = x * 1.44269504f;
  const int whole = static_cast<int>(turns + 0.5f);
  const float f = (static_cast<float>(whole) - turns) * 0.69314718f;
  const float fraction = 1.0f +
    f *
      (1.0f +
        f * (0.5f + f * (1.0f / 6.0f + f * (1.0f / 24.0f + f * (1.0f / 120.0f + f / 720.0f)))));
  const std::int32_t bits = (127 - whole) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return fraction * scale;
}

bool IsGrey(const double* color)
{
  return color[0] == color[1] && color[1] == color[2];
}

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

// The geometry of a point light and a ray, in the coordinate of its splines: t = q/(1 + q), q^2 being the tangent of
// half the scattering angle, is about even in the angle at the light, and denser far from it on both sides.
// T is a floating-point type.
template <typename T>
struct PointRay
{
  T Foot;   // where the ray is nearest to the light
  T Height; // how near
  T Start;  // t of the ray's start
  T Length; // of its end, less Start

  T GetCoordinate(T distance) const
  {
    const T beyond = distance - this->Foot;
    const T r = std::sqrt(this->Height * this->Height + beyond * beyond);
    const T y = beyond > 0 ? r + beyond : this->Height * (this->Height / (r - beyond));
    const T root = std::sqrt(y);
    return root / (root + std::sqrt(this->Height));
  }

  T GetDistance(T t) const
  {
    const T root = std::max(t, T(1e-15)) / std::max(1 - t, T(1e-15));
    const T ratio = root * root;
    return this->Foot + T(0.5) * this->Height * (ratio - 1 / ratio);
  }

  void Set(T foot, T height, T end)
  {
    this->Foot = foot;
    this->Height = height;
    this->Start = this->GetCoordinate(0);
    this->Length = std::max(this->GetCoordinate(end) - this->Start, T(1e-12));
  }
};
}

// The integrand along one ray, in the coordinates of its nodes.
struct vtkGodRaysAirlight::Sampler
{
  const vtkGodRaysAirlight& Airlight;
  LitRay Ray;
  double Begin = 0.0;
  double End = 0.0;
  double Bend = 1.0;
  PointRay<double> Point = {};

  Sampler(const vtkGodRaysAirlight& airlight, double x, double y);

  // d(airlight)/d(distance) of each plane, at a distance; of a point light but for 1/r^2.
  void Sample(double distance, double* values) const;

  // d(airlight)/du at u, from 0 to 1.
  void SampleCoordinate(double u, double* values) const
  {
    double change;
    double distance;
    if (this->Airlight.Setup.Point)
    {
      const double t = this->Point.Start + u * this->Point.Length;
      const double left = 1.0 - t;
      distance = std::min(std::max(this->Point.GetDistance(t), 0.0), this->End);
      change = 4.0 * t * left * this->Point.Length / (t * t * t * t + left * left * left * left);
    }
    else
    {
      const double under = 1.0 - u + this->Bend * u;
      distance = this->Begin + (this->End - this->Begin) * this->Bend * u / under;
      change = (this->End - this->Begin) * this->Bend / (under * under);
    }
    this->Sample(distance, values);
    for (int p = 0; p < this->Airlight.GetNumberOfPlanes(); ++p)
    {
      values[p] *= change;
    }
  }

  // A point light's airlight without extinction, of which the totals are fractions: it is not smooth where the ray
  // is towards the light, or away from it.
  double GetUnit() const
  {
    return this->Airlight.Setup.Point
      ? this->Ray.Distance * PointAirlight(this->Ray.Foot, this->Ray.Distance, 0.0, this->End)
      : 1.0;
  }

  double GetEyeDepth(double distance) const; // optical, of the clearest channel
  void FindEnds();
  void FindBend();
};

vtkGodRaysAirlight::Sampler::Sampler(const vtkGodRaysAirlight& airlight, double x, double y)
  : Airlight(airlight)
{
  const Scene& setup = airlight.Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  double start[3];
  double way[3];
  airlight.GetRay(x, y, start, way);
  const Vec3 origin = ToVector(start);
  const Vec3 direction = ToVector(way);
  const Vec3 light = ToVector(setup.Light);
  const Vec3 up = ToVector(medium.Up);
  const Vec3 to = setup.Point ? light - origin : light;
  LitRay& ray = this->Ray;
  ray = {};
  ray.Infinite = setup.Point ? 0 : 1;
  ray.Foot = dot(to, direction);
  ray.Distance = setup.Point ? length(cross(to, direction)) : 0.0;
  const Vec2 begin = MediumStart(medium.PlanetRadius, medium.EyeHeight, up, origin, direction);
  ray.Height = begin.x;
  ray.Slope = begin.y;
  ray.LightHeight = setup.Point
    ? airlight.LightHeight
    : MediumStart(medium.PlanetRadius, medium.EyeHeight, up, origin, light).y;
  ray.PlanetRadius = medium.PlanetRadius;
  ray.ThroughGround = 1;
}

void vtkGodRaysAirlight::Sampler::Sample(double distance, double* values) const
{
  const Scene& setup = this->Airlight.Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  const LitRay& ray = this->Ray;
  const double beyond = distance - ray.Foot;
  const double r = std::max(std::hypot(ray.Distance, beyond), 1e-30);
  const double height = MediumHeight(ray.PlanetRadius, ray.Height, ray.Slope, distance);
  const double slope = LightSlope(ray, height, distance, r);
  double columns[vtkGodRaysMedium::MaximumComponents];
  double parts[vtkGodRaysMedium::MaximumComponents];
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    MediumComponent unit = {};
    unit.Extinction = 1.0;
    unit.ScaleHeight = component.ScaleHeight;
    columns[k] = LightDepth(unit, ray, height, slope, r) +
      MediumDepth(ray.PlanetRadius, ray.Height, ray.Slope, component.ScaleHeight, distance);
    parts[k] =
      component.ScaleHeight > 0.0 ? ExponentialDensity(height, component.ScaleHeight) : 1.0;
    if (setup.Point)
    {
      parts[k] *= PhaseMix({ component.PhaseFunction, component.Asymmetry },
        { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight,
        -beyond / r);
    }
  }
  for (int c = 0; c < this->Airlight.Channels; ++c)
  {
    double tau = 0.0;
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      tau += (medium.Components[k].Scattering[c] + medium.Components[k].Absorption[c]) * columns[k];
    }
    const double left = std::exp(-tau);
    if (setup.Point)
    {
      double sum = 0.0;
      for (int k = 0; k < medium.NumberOfComponents; ++k)
      {
        sum += medium.Components[k].Scattering[c] * parts[k];
      }
      values[c] = left * sum;
    }
    else
    {
      for (int k = 0; k < this->Airlight.Components; ++k)
      {
        values[k * this->Airlight.Channels + c] = left * parts[k];
      }
    }
  }
}

double vtkGodRaysAirlight::Sampler::GetEyeDepth(double distance) const
{
  const vtkGodRaysMedium& medium = this->Airlight.Setup.Medium;
  double least = 1e300;
  for (int c = 0; c < this->Airlight.Channels; ++c)
  {
    double tau = 0.0;
    for (int k = 0; k < medium.NumberOfComponents; ++k)
    {
      const Component& component = medium.Components[k];
      tau += (component.Scattering[c] + component.Absorption[c]) *
        MediumDepth(this->Ray.PlanetRadius, this->Ray.Height, this->Ray.Slope,
          component.ScaleHeight, distance);
    }
    least = std::min(least, tau);
  }
  return least;
}

// Nothing is scattered to the eye from beyond an optical depth of 18, or from outside of a planet's air.
void vtkGodRaysAirlight::Sampler::FindEnds()
{
  const LitRay& ray = this->Ray;
  if (ray.PlanetRadius > 0.0 && !this->Airlight.Setup.Point)
  {
    double highest = 0.0;
    for (int k = 0; k < this->Airlight.Setup.Medium.NumberOfComponents; ++k)
    {
      const double height = this->Airlight.Setup.Medium.Components[k].ScaleHeight;
      highest = height > 0.0 ? std::max(highest, 40.0 * height) : 1e300;
    }
    if (highest < 1e300)
    {
      const Vec2 part = SkyBelow(ray.PlanetRadius, ray.Height, ray.Slope, highest);
      this->Begin = std::min(std::max(part.x, 0.0), this->End);
      this->End = std::min(std::max(part.y, this->Begin), this->End);
    }
  }
  if (this->GetEyeDepth(this->End) <= 18.0)
  {
    return;
  }
  double low = this->Begin;
  double high = this->End;
  for (int i = 0; i < 40 && high - low > 1e-3 * (high - this->Begin); ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->GetEyeDepth(middle) > 18.0 ? high : low) = middle;
  }
  this->End = high;
}

// From sums over places that are denser at both ends.
void vtkGodRaysAirlight::Sampler::FindBend()
{
  constexpr int half = 14;
  constexpr int places = 2 * half - 1;
  double x[places + 2] = { 0.0 };
  double sums[places + 2] = { 0.0 };
  for (int i = 0; i < half; ++i)
  {
    x[1 + i] = std::ldexp(1.0, i - half);
    x[places - i] = 1.0 - std::ldexp(1.0, i - half);
  }
  x[places + 1] = 1.0;
  double last = 0.0;
  for (int i = 0; i < places + 2; ++i)
  {
    double values[MaximumPlanes];
    this->Sample(this->Begin + x[i] * (this->End - this->Begin), values);
    double sum = 0.0;
    for (int p = 0; p < this->Airlight.GetNumberOfPlanes(); ++p)
    {
      sum += values[p];
    }
    sums[i] = i > 0 ? sums[i - 1] + 0.5 * (sum + last) * (x[i] - x[i - 1]) : 0.0;
    last = sum;
  }
  this->Bend = 1.0;
  const double middle = 0.5 * sums[places + 1];
  for (int i = 1; i < places + 2 && middle > 0.0; ++i)
  {
    if (sums[i] >= middle)
    {
      const double part = (middle - sums[i - 1]) / std::max(sums[i] - sums[i - 1], 1e-300);
      const double at = x[i - 1] + part * (x[i] - x[i - 1]);
      this->Bend = std::min(std::max(at / std::max(1.0 - at, 1e-300), 1e-3), 1e3);
      return;
    }
  }
}

void vtkGodRaysAirlight::GetRay(double x, double y, double origin[3], double direction[3]) const
{
  const double place[2] = { (x - this->Setup.Center[0]) * this->Setup.PixelSize,
    (y - this->Setup.Center[1]) * this->Setup.PixelSize };
  const double inverse = 1.0 / this->GetLengthPerDepth(x, y);
  for (int i = 0; i < 2; ++i)
  {
    origin[i] = this->Setup.Parallel ? place[i] : 0.0;
    direction[i] = this->Setup.Parallel ? 0.0 : inverse * place[i];
  }
  origin[2] = 0.0;
  direction[2] = inverse;
}

double vtkGodRaysAirlight::GetLengthPerDepth(double x, double y) const
{
  if (this->Setup.Parallel)
  {
    return 1.0;
  }
  const double across = (x - this->Setup.Center[0]) * this->Setup.PixelSize;
  const double along = (y - this->Setup.Center[1]) * this->Setup.PixelSize;
  return std::sqrt(1.0 + across * across + along * along);
}

void vtkGodRaysAirlight::Prepare(const Scene& scene)
{
  this->Setup = scene;
  const vtkGodRaysMedium& medium = scene.Medium;
  const bool layered = medium.HasExponentialDensity();
  this->IsPlanet = layered && medium.PlanetRadius > 0.0;
  if (!this->IsPlanet)
  {
    this->Setup.Medium.PlanetRadius = 0.0;
  }
  if (!scene.Point)
  {
    this->Setup.Spot = vtkGodRaysSpot();
  }
  const double away = std::max(length(ToVector(scene.Light)), 1e-30);
  this->Nearest = std::max(
    NearestPass * scene.PixelSize * (scene.Parallel ? 1.0 : scene.Light[2] * scene.Light[2] / away),
    1e-9 * medium.FarLimit);
  const Vec3 up = ToVector(medium.Up);
  this->LightHeight =
    MediumStart(this->Setup.Medium.PlanetRadius, medium.EyeHeight, up, ToVector(scene.Light), up).x;
  this->FindPlanetShadow();
  this->MakeFade();
  bool grey = true;
  bool alike = true; // whether components scatter all colours in one proportion
  double total[3] = { 0.0, 0.0, 0.0 };
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    alike = alike &&
      (IsGrey(component.Scattering) ||
        (medium.NumberOfComponents == 1 && component.Scattering[0] > 0.0));
    double extinction[3];
    for (int c = 0; c < 3; ++c)
    {
      extinction[c] = component.Scattering[c] + component.Absorption[c];
      total[c] += extinction[c];
    }
    grey = grey && IsGrey(extinction);
  }
  this->Channels =
    (layered ? grey : IsGrey(total)) && (alike || !scene.Point) && !scene.Colored ? 1 : 3;
  this->Components = layered && !scene.Point ? medium.NumberOfComponents : 1;
  this->Closed = !layered && !scene.Point;
  for (int c = 0; c < 3; ++c)
  {
    // So clear a medium cannot be told from none.
    this->Extinction[c] = static_cast<float>(std::max(total[c], 1e-9 / medium.FarLimit));
  }
  for (int k = 0; k < (scene.Point ? 0 : medium.NumberOfComponents); ++k)
  {
    MakePhaseTable(medium.Components[k], this->Phases[k]);
  }
  if (this->Closed)
  {
    this->Key.clear();
    return;
  }
  this->MakeKey(this->NewKey);
  if (this->NewKey != this->Key)
  {
    this->MakeTable();
    this->Key = this->NewKey;
  }
}

void vtkGodRaysAirlight::MakeKey(std::vector<double>& key) const
{
  const Scene& setup = this->Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  key.assign({ setup.Size[0] + 0.0, setup.Size[1] + 0.0, setup.PixelSize, setup.Center[0],
    setup.Center[1], setup.Parallel + 0.0, setup.Point + 0.0, setup.Light[0], setup.Light[1],
    setup.Light[2], medium.Up[0], medium.Up[1], medium.Up[2], medium.EyeHeight, medium.PlanetRadius,
    medium.FarLimit, this->Channels + 0.0 });
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    key.insert(key.end(), component.Scattering, component.Scattering + 3);
    key.insert(key.end(), component.Absorption, component.Absorption + 3);
    key.insert(key.end(),
      { component.ScaleHeight, component.PhaseFunction + 0.0, component.Asymmetry,
        component.SecondPhaseFunction + 0.0, component.SecondAsymmetry, component.SecondWeight });
  }
}

void vtkGodRaysAirlight::MakeTable()
{
  this->Spacing = 1;
  while (this->Spacing * NumberOfRows * 1.5 < this->Setup.Size[1])
  {
    this->Spacing *= 2;
  }
  const auto count = [this](int pixels) { return (pixels + 7) / this->Spacing + 2; };
  this->Columns = count(this->Setup.Size[0]);
  this->Rows = count(this->Setup.Size[1]);
  this->Pixels.clear();
  this->Finer.clear();
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      this->Pixels.insert(this->Pixels.end(), { i * this->Spacing, j * this->Spacing });
    }
  }
  this->Ladders.clear();
  this->MakeRays();
  this->Cells.clear();
  for (int j = 0; j + 1 < this->Rows; ++j)
  {
    for (int i = 0; i + 1 < this->Columns; ++i)
    {
      const int at = j * this->Columns + i;
      this->Cells.push_back({ { at, at + 1, at + this->Columns, at + this->Columns + 1 }, -1 });
    }
  }
  if (this->Spacing > 1)
  {
    this->Refine();
  }
}

// Those that there are pixels of, but no ladders.
void vtkGodRaysAirlight::MakeRays()
{
  const std::size_t first = this->Ladders.size();
  const std::size_t rays = this->Pixels.size() / 2;
  this->Ladders.resize(rays);
  this->Units.resize(rays);
  this->Totals.resize(rays * this->GetNumberOfPlanes());
  this->Nodes.resize(rays * NumberOfNodes * 2 * this->GetNumberOfPlanes());
  vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(rays), 16,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType ray = begin; ray < end; ++ray)
      {
        this->MakeLadder(static_cast<int>(ray), this->Pixels[2 * ray], this->Pixels[2 * ray + 1]);
      }
    });
}

// Splits cells in four where a ray is not about the mean of those beside it: of the coarsest grid by the rays that
// are there, at half the size by those that splitting adds.
void vtkGodRaysAirlight::Refine()
{
  const int planes = this->GetNumberOfPlanes();
  const auto getBrightness = [&](int ray)
  {
    const float* totals = this->Totals.data() + static_cast<std::ptrdiff_t>(ray) * planes;
    return this->Units[ray] * *std::max_element(totals, totals + planes);
  };
  std::vector<float> bright(this->Ladders.size());
  for (std::size_t i = 0; i < bright.size(); ++i)
  {
    bright[i] = getBrightness(static_cast<int>(i));
  }
  const auto rank =
    bright.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(bright.size()));
  std::nth_element(bright.begin(), rank, bright.end());
  const float floor = 0.1f * *rank;
  const auto getLimit = [&](int ray) { return RayTolerance * std::max(getBrightness(ray), floor); };

  struct Part
  {
    int Cell;
    int X;
    int Y;
  };
  std::vector<unsigned char> uneven(this->Cells.size());
  const int columns = this->Columns - 1;
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      const int ray = j * this->Columns + i;
      float difference = 0.0f;
      for (const int step : { 1, this->Columns })
      {
        const bool isInside =
          step == 1 ? i > 0 && i + 1 < this->Columns : j > 0 && j + 1 < this->Rows;
        const int others[2] = { ray - step, ray + step };
        difference += isInside ? this->GetDifference(ray, others, 2) : 0.0f;
      }
      // At half the distance a fourth is left of what is smooth, half of an edge.
      for (int k = 0; k < 4 && difference > 3.0f * getLimit(ray); ++k)
      {
        const int x = i - k % 2;
        const int y = j - k / 2;
        if (x >= 0 && y >= 0 && x < columns && y + 1 < this->Rows)
        {
          uneven[static_cast<std::size_t>(y) * columns + x] = 1;
        }
      }
    }
  }
  std::vector<Part> parts;
  for (std::size_t i = 0; i < uneven.size(); ++i)
  {
    if (uneven[i])
    {
      const int at = static_cast<int>(i);
      parts.push_back({ at, at % columns * this->Spacing, at / columns * this->Spacing });
    }
  }
  std::vector<Part> next;
  for (int side = this->Spacing; side > 1 && !parts.empty(); side /= 2, parts.swap(next))
  {
    for (const Part& part : parts)
    {
      this->Split(part.Cell, part.X, part.Y, side / 2);
    }
    this->MakeRays();
    next.clear();
    for (const Part& part : parts)
    {
      const Cell& cell = this->Cells[part.Cell];
      const int center = this->Cells[cell.Child].Corners[3];
      if (this->GetDifference(center, cell.Corners, 4) > 2.0f * getLimit(center))
      {
        for (int k = 0; k < 4; ++k)
        {
          next.push_back(
            { cell.Child + k, part.X + k % 2 * (side / 2), part.Y + k / 2 * (side / 2) });
        }
      }
    }
  }
}

// Into four of half the side.
void vtkGodRaysAirlight::Split(int index, int x, int y, int side)
{
  int rays[9];
  for (int k = 0; k < 9; ++k)
  {
    const int i = k % 3;
    const int j = k / 3;
    rays[k] = i != 1 && j != 1 ? this->Cells[index].Corners[j + i / 2]
                               : this->FindRay(x + i * side, y + j * side);
  }
  this->Cells[index].Child = static_cast<int>(this->Cells.size());
  for (const int k : { 0, 1, 3, 4 })
  {
    this->Cells.push_back({ { rays[k], rays[k + 1], rays[k + 3], rays[k + 4] }, -1 });
  }
}

int vtkGodRaysAirlight::FindRay(int x, int y)
{
  const auto [found, isNew] = this->Finer.try_emplace(
    static_cast<std::int64_t>(y) * (1 << 24) + x, static_cast<int>(this->Pixels.size() / 2));
  if (isNew)
  {
    this->Pixels.insert(this->Pixels.end(), { x, y });
  }
  return found->second;
}

// How much a ray's airlight is off the mean of others, anywhere along it.
float vtkGodRaysAirlight::GetDifference(int ray, const int* others, int count) const
{
  const int planes = this->GetNumberOfPlanes();
  const Ladder& ladder = this->Ladders[ray];
  const auto getNodes = [&](int index)
  { return this->Nodes.data() + static_cast<std::size_t>(index) * NumberOfNodes * 2 * planes; };
  float most = 0.0f;
  for (int k = 4; k <= NumberOfParts; k += 4)
  {
    const float u = static_cast<float>(k) / NumberOfParts;
    Place place = {};
    if (this->Setup.Point)
    {
      place.First = ladder.Begin;
      place.Last = ladder.Bend;
      place.Coordinate = ladder.Begin + u / ladder.Inverse;
      place.FindWeight();
    }
    else
    {
      place.Distance =
        ladder.Begin + ladder.Bend * u / ((1.0f - u + ladder.Bend * u) * ladder.Inverse);
    }
    for (int p = 0; p < planes; ++p)
    {
      float mean = 0.0f;
      for (int i = 0; i < count; ++i)
      {
        const float node = this->GetNode(others[i], place);
        const int low = std::min(static_cast<int>(node), NumberOfParts - 1);
        const float* const values = getNodes(others[i]) + 2 * planes * low + 2 * p;
        const float value =
          values[0] + (node - static_cast<float>(low)) * (values[2 * planes] - values[0]);
        mean += value * this->Totals[static_cast<std::size_t>(others[i]) * planes + p];
      }
      const float own = getNodes(ray)[2 * planes * k + 2 * p] *
        this->Totals[static_cast<std::size_t>(ray) * planes + p];
      most = std::max(most, std::abs(own - mean / static_cast<float>(count)));
    }
  }
  return this->Units[ray] * most;
}

// The cell of a pixel, and the place in it.
inline const vtkGodRaysAirlight::Cell& vtkGodRaysAirlight::FindCell(
  float x, float y, float& u, float& v) const
{
  float side = static_cast<float>(this->Spacing);
  const int i = std::min(static_cast<int>(x / side), this->Columns - 2);
  const int j = std::min(static_cast<int>(y / side), this->Rows - 2);
  const Cell* cell = this->Cells.data() + static_cast<std::ptrdiff_t>(j) * (this->Columns - 1) + i;
  u = x - side * static_cast<float>(i);
  v = y - side * static_cast<float>(j);
  while (cell->Child >= 0)
  {
    side *= 0.5f;
    const bool right = u >= side;
    const bool upper = v >= side;
    u -= right ? side : 0.0f;
    v -= upper ? side : 0.0f;
    cell = this->Cells.data() + cell->Child + (upper ? 2 : 0) + (right ? 1 : 0);
  }
  u /= side;
  v /= side;
  return *cell;
}

// Near their ends rays correspond by these, else by angles at the light, wherever their ends are.
inline void vtkGodRaysAirlight::Place::FindWeight()
{
  const float x = 1.0f - 2.0f * (this->Coordinate - this->First) / (this->Last - this->First);
  this->Early = 0.5f + 0.5f * x * x * x * x * x;
}

// Where between a ray's nodes the place is that corresponds to one on a ray beside it.
inline float vtkGodRaysAirlight::GetNode(int ray, const Place& place) const
{
  const Ladder& ladder = this->Ladders[ray];
  float u;
  if (this->Setup.Point)
  {
    const float shift = place.Early * (ladder.Begin - place.First) +
      (1.0f - place.Early) * (ladder.Bend - place.Last);
    u = (place.Coordinate + shift - ladder.Begin) * ladder.Inverse;
  }
  else
  {
    const float part =
      std::min(std::max((place.Distance - ladder.Begin) * ladder.Inverse, 0.0f), 1.0f);
    u = part / (part + ladder.Bend * (1.0f - part));
  }
  return std::min(std::max(0.0f, u), 1.0f) * NumberOfParts; // in this order 0 for NaN
}

void vtkGodRaysAirlight::MakeLadder(int index, double x, double y)
{
  Sampler sampler(*this, x, y);
  sampler.End = this->Setup.Medium.FarLimit * this->GetLengthPerDepth(x, y);
  if (this->Setup.Point)
  {
    sampler.Ray.Distance = std::max(sampler.Ray.Distance, this->Nearest);
    sampler.Point.Set(sampler.Ray.Foot, sampler.Ray.Distance, sampler.End);
  }
  else
  {
    sampler.FindEnds();
    sampler.FindBend();
  }
  const double first = this->Setup.Point ? sampler.Point.Start : sampler.Begin;
  const double range = this->Setup.Point ? sampler.Point.Length : sampler.End - sampler.Begin;
  this->Ladders[index] = { static_cast<float>(first),
    static_cast<float>(1.0 / std::max(range, 1e-30)),
    static_cast<float>(this->Setup.Point ? first + range : sampler.Bend) };
  this->Units[index] = static_cast<float>(sampler.GetUnit());
  const int planes = this->GetNumberOfPlanes();
  float* node = this->Nodes.data() + static_cast<std::size_t>(index) * NumberOfNodes * 2 * planes;
  const double step = 1.0 / NumberOfParts;
  double sums[MaximumPlanes] = {};
  double last[MaximumPlanes] = {};
  float* const nodes = node;
  for (int i = 0; i < NumberOfNodes; ++i)
  {
    double here[MaximumPlanes];
    double between[MaximumPlanes];
    sampler.SampleCoordinate(i * step, here);
    if (i > 0)
    {
      sampler.SampleCoordinate((i - 0.5) * step, between);
    }
    for (int p = 0; p < planes; ++p)
    {
      sums[p] +=
        i > 0 ? step / 6.0 * (last[p] + 4.0 * between[p] + here[p]) : 0.0; // Simpson's rule
      *node++ = static_cast<float>(sums[p]);
      *node++ = static_cast<float>(step * here[p]);
      last[p] = here[p];
    }
  }
  // As fractions of the whole ray's.
  for (int p = 0; p < planes; ++p)
  {
    this->Totals[static_cast<std::size_t>(index) * planes + p] =
      static_cast<float>(sums[p] / sampler.GetUnit());
    const double inverse = sums[p] > 1e-37 ? 1.0 / sums[p] : 0.0; // else it is no light in float
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      for (int k = 0; k < 2; ++k)
      {
        float& value = nodes[(i * planes + p) * 2 + k];
        value = static_cast<float>(value * inverse);
      }
    }
  }
}

void vtkGodRaysAirlight::Evaluate(int count, const float* x, const float* y, const float* distances,
  float* values, float* lights) const
{
  if (!this->HasParts())
  {
    this->EvaluateWhole(count, x, y, distances, values, count);
    if (lights)
    {
      std::fill_n(lights, this->GetNumberOfPlanes() * count, 1.0f);
    }
    return;
  }
  const int samples = this->MaximumNumberOfParts * (2 * this->Steps + 1);
  const int step = std::max(Batch / samples, 1);
  for (int first = 0; first < count; first += step)
  {
    this->EvaluateParts(std::min(step, count - first), x + first, y + first, distances + first,
      values + first, lights ? lights + first : nullptr, count);
  }
}

// Each part is read in steps up to a distance and beyond it, over which the light fades by its mean.
void vtkGodRaysAirlight::EvaluateParts(int count, const float* x, const float* y,
  const float* distances, float* values, float* lights, int stride) const
{
  float xs[Batch];
  float ys[Batch];
  float places[Batch];
  float fades[Batch]; // from a place to the next one
  int ends[Batch];    // of a place's samples
  bool before[Batch]; // the distance
  int samples = 0;
  for (int i = 0; i < count; ++i)
  {
    double parts[MaximumParts][2];
    const LitRay ray = this->MakeRay(x[i], y[i]);
    const int number = this->GetParts(ray, x[i], y[i], parts);
    const int begin = samples;
    for (int k = 0; k < number; ++k)
    {
      const double middle = std::min(std::max<double>(distances[i], parts[k][0]), parts[k][1]);
      const int first = samples;
      samples += this->AddSteps(ray, parts[k][0], middle, places + samples, fades + samples);
      std::fill(before + first, before + samples, true);
      const int beyond = samples;
      samples += this->AddSteps(ray, middle, parts[k][1], places + samples, fades + samples);
      places[samples] = static_cast<float>(parts[k][1]);
      fades[samples++] = 0.0f;
      std::fill(before + beyond, before + samples, false);
    }
    std::fill(xs + begin, xs + samples, x[i]);
    std::fill(ys + begin, ys + samples, y[i]);
    ends[i] = samples;
  }
  float read[MaximumPlanes * Batch];
  if (samples > 0)
  {
    this->EvaluateWhole(samples, xs, ys, places, read, samples);
  }
  for (int p = 0; p < this->GetNumberOfPlanes(); ++p)
  {
    const float* at = read + static_cast<std::ptrdiff_t>(p) * samples;
    for (int i = 0; i < count; ++i)
    {
      float sums[2] = {};
      for (int k = i > 0 ? ends[i - 1] : 0; k + 1 < ends[i]; ++k)
      {
        sums[before[k] ? 0 : 1] += fades[k] * std::max(at[k + 1] - at[k], 0.0f);
      }
      const float sum = sums[0] + sums[1];
      values[static_cast<std::ptrdiff_t>(p) * stride + i] = sum > 0.0f ? sums[0] / sum : 0.0f;
      if (lights)
      {
        lights[static_cast<std::ptrdiff_t>(p) * stride + i] = sum;
      }
    }
  }
}

// The begins of steps over a part of a ray, and the light's fade over them. Returns their number.
int vtkGodRaysAirlight::AddSteps(
  const LitRay& ray, double begin, double end, float* places, float* fades) const
{
  if (this->Fade.empty())
  {
    places[0] = static_cast<float>(begin);
    fades[0] = 1.0f;
    return 1;
  }
  PointRay<double> coordinates;
  coordinates.Foot = ray.Foot;
  coordinates.Height = std::max(ray.Distance, this->Nearest);
  const double first = coordinates.GetCoordinate(begin);
  const double step = (coordinates.GetCoordinate(end) - first) / this->Steps;
  const float scale =
    static_cast<float>(this->Fade.size() - 2) / static_cast<float>(1.0 - this->CosLit);
  const auto getFade = [&](double distance)
  {
    const double beyond = distance - ray.Foot;
    const double r = std::max(std::sqrt(ray.Distance * ray.Distance + beyond * beyond), 1e-30);
    const double cosine = (ray.AxisStart + ray.AxisSlope * distance) / r;
    const float entry =
      scale * static_cast<float>(std::min(std::max(cosine, this->CosLit), 1.0) - this->CosLit);
    const int i = std::min(static_cast<int>(entry), static_cast<int>(this->Fade.size()) - 2);
    return this->Fade[i] + (entry - static_cast<float>(i)) * (this->Fade[i + 1] - this->Fade[i]);
  };
  float last = getFade(begin);
  for (int i = 0; i < this->Steps; ++i)
  {
    places[i] = static_cast<float>(i == 0 ? begin : coordinates.GetDistance(first + i * step));
    const float middle = getFade(coordinates.GetDistance(first + (i + 0.5) * step));
    const float next =
      getFade(i + 1 < this->Steps ? coordinates.GetDistance(first + (i + 1) * step) : end);
    fades[i] = (last + 4.0f * middle + next) / 6.0f; // Simpson's rule
    last = next;
  }
  return this->Steps;
}

// Airlight of a closed form or the table, as if no part of a ray were dark.
void vtkGodRaysAirlight::EvaluateWhole(int count, const float* x, const float* y,
  const float* distances, float* values, int stride) const
{
  for (int first = 0; !this->Closed && first < count; first += Batch)
  {
    this->EvaluateTable(std::min(Batch, count - first), x + first, y + first, distances + first,
      values + first, stride);
  }
  for (int c = 0; this->Closed && c < this->Channels; ++c)
  {
    const float extinction = this->Extinction[c];
    const float inverse = 1.0f / extinction;
    float* to = values + static_cast<std::ptrdiff_t>(c) * stride;
    for (int i = 0; i < count; ++i)
    {
      // (1 - e^-k)/extinction, by its series where that would lose figures.
      const float k = std::min(extinction * distances[i], 80.0f);
      const float series =
        k * (1.0f - k * (0.5f - k * (1.0f / 6.0f - k * (1.0f / 24.0f - k * (1.0f / 120.0f)))));
      to[i] = (k < 0.2f ? series : 1.0f - ExpMinus(k)) * inverse;
    }
  }
}

void vtkGodRaysAirlight::EvaluateTable(int count, const float* xs, const float* ys,
  const float* distances, float* values, int stride) const
{
  const int planes = this->GetNumberOfPlanes();
  const Cell* cells[Batch];
  float across[Batch];
  float along[Batch];
  Place places[Batch];
  for (int i = 0; i < count; ++i)
  {
    cells[i] = &this->FindCell(xs[i], ys[i], across[i], along[i]);
    places[i].Distance = distances[i];
  }
  for (int i = 0; this->Setup.Point && i < count; ++i)
  {
    float foot;
    float height;
    float end;
    this->GetPass(xs[i], ys[i], foot, height, end);
    PointRay<float> ray;
    ray.Set(foot, height, end);
    places[i].Coordinate = ray.GetCoordinate(std::min(distances[i], end));
    places[i].First = ray.Start;
    places[i].Last = ray.Start + ray.Length;
    places[i].FindWeight();
  }
  for (int p = 0; p < planes; ++p)
  {
    std::fill_n(values + static_cast<std::ptrdiff_t>(p) * stride, count, 0.0f);
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int i = 0; i < count; ++i)
    {
      const int ray = cells[i]->Corners[corner];
      const float weight = (corner % 2 == 1 ? across[i] : 1.0f - across[i]) *
        (corner / 2 == 1 ? along[i] : 1.0f - along[i]);
      const float u = this->GetNode(ray, places[i]);
      const int k = std::min(static_cast<int>(u), NumberOfParts - 1);
      const float f = u - static_cast<float>(k);
      const float square = f * f;
      const float cube = square * f;
      const float upper = weight * (3.0f * square - 2.0f * cube);
      const float lower = weight - upper;
      const float firstSlope = weight * (cube - 2.0f * square + f);
      const float lastSlope = weight * (cube - square);
      const float* node =
        this->Nodes.data() + (static_cast<std::size_t>(ray) * NumberOfNodes + k) * 2 * planes;
      for (int p = 0; p < planes; ++p)
      {
        values[static_cast<std::ptrdiff_t>(p) * stride + i] += lower * node[2 * p] +
          firstSlope * node[2 * p + 1] + upper * node[2 * planes + 2 * p] +
          lastSlope * node[2 * planes + 2 * p + 1];
      }
    }
  }
}

// How a view ray passes a point light, and how long it is at most.
void vtkGodRaysAirlight::GetPass(float x, float y, float& foot, float& height, float& end) const
{
  const float pixel = static_cast<float>(this->Setup.PixelSize);
  const float px = (x - static_cast<float>(this->Setup.Center[0])) * pixel;
  const float py = (y - static_cast<float>(this->Setup.Center[1])) * pixel;
  const float far = static_cast<float>(this->Setup.Medium.FarLimit);
  float to[3];
  for (int i = 0; i < 3; ++i)
  {
    to[i] = static_cast<float>(this->Setup.Light[i]);
  }
  if (this->Setup.Parallel)
  {
    to[0] -= px;
    to[1] -= py;
    foot = to[2];
    height = std::sqrt(to[0] * to[0] + to[1] * to[1]);
    end = far;
  }
  else
  {
    const float length = std::sqrt(1.0f + px * px + py * py);
    const float inverse = 1.0f / length;
    foot = (to[0] * px + to[1] * py + to[2]) * inverse;
    const float a = to[1] - to[2] * py;
    const float b = to[2] * px - to[0];
    const float c = to[0] * py - to[1] * px;
    height = std::sqrt(a * a + b * b + c * c) * inverse;
    end = far * length;
  }
  height = std::max(height, static_cast<float>(this->Nearest));
}

// What a ray has in common with the light.
LitRay vtkGodRaysAirlight::MakeRay(double x, double y) const
{
  double start[3];
  double way[3];
  this->GetRay(x, y, start, way);
  const Vec3 direction = ToVector(way);
  const Vec3 light = ToVector(this->Setup.Light);
  const Vec3 to = this->Setup.Point ? light - ToVector(start) : light;
  const Vec3 axis = ToVector(this->Setup.Spot.Axis);
  LitRay ray = {};
  ray.Infinite = this->Setup.Point ? 0 : 1;
  ray.Foot = dot(to, direction);
  ray.Distance = this->Setup.Point ? length(cross(to, direction)) : 0.0;
  ray.AxisStart = -dot(axis, to);
  ray.AxisSlope = dot(axis, direction);
  ray.Shape.CosCone = this->CosLit;
  ray.ThroughGround = 1;
  return ray;
}

double vtkGodRaysAirlight::GetEnd(double x, double y, double distance) const
{
  const vtkGodRaysMedium& medium = this->Setup.Medium;
  double start[3];
  double way[3];
  this->GetRay(x, y, start, way);
  LitRay ray = {};
  const Vec2 begin = MediumStart(
    medium.PlanetRadius, medium.EyeHeight, ToVector(medium.Up), ToVector(start), ToVector(way));
  ray.Height = begin.x;
  ray.Slope = begin.y;
  ray.PlanetRadius = medium.PlanetRadius;
  return MediumEnd(ray, distance);
}

int vtkGodRaysAirlight::GetParts(double x, double y, double parts[MaximumParts][2]) const
{
  return this->GetParts(this->MakeRay(x, y), x, y, parts);
}

int vtkGodRaysAirlight::GetParts(
  const LitRay& ray, double x, double y, double parts[MaximumParts][2]) const
{
  const Vec2 part = SpotPart(ray, this->Setup.Medium.FarLimit * this->GetLengthPerDepth(x, y));
  parts[0][0] = part.x;
  parts[0][1] = part.y;
  if (!(part.y > part.x) || (this->IsPlanet && this->Setup.Point && this->LightHeight < 0.0))
  {
    return 0;
  }
  if (!this->HasPlanetShadow)
  {
    return 1;
  }
  const Vec2 dark = clamp(this->GetPlanetShadow(x, y, part.y), Vec2(part.x), Vec2(part.y));
  if (!(dark.y > dark.x))
  {
    return 1;
  }
  int count = 0;
  if (dark.x > part.x)
  {
    parts[count][0] = part.x;
    parts[count++][1] = dark.x;
  }
  if (part.y > dark.y)
  {
    parts[count][0] = dark.y;
    parts[count++][1] = part.y;
  }
  return count;
}

// The part of a ray from which a planet hides the light: behind it in a cylinder, or in a cone about a point light.
Vec2 vtkGodRaysAirlight::GetPlanetShadow(double x, double y, double end) const
{
  const Scene& setup = this->Setup;
  const double radius = setup.Medium.PlanetRadius;
  double start[3];
  double way[3];
  this->GetRay(x, y, start, way);
  const Vec3 center = -(radius + setup.Medium.EyeHeight) * ToVector(setup.Medium.Up);
  const Vec3 light = ToVector(setup.Light);
  const Vec3 direction = ToVector(way);
  if (setup.Point)
  {
    const Vec3 toCenter = center - light;
    const double distance = length(toCenter);
    const double room = this->LightHeight * (2.0 * radius + this->LightHeight);
    const Vec3 axis = toCenter / distance;
    LitRay ray = this->MakeRay(x, y);
    ray.AxisStart = dot(axis, ToVector(start) - light);
    ray.AxisSlope = dot(axis, direction);
    ray.Shape.CosCone = std::max(std::sqrt(room) / distance, 1e-9);
    const Vec2 dark = SpotPart(ray, end);
    const double beyond = room / distance - ray.AxisStart; // of the plane of all tangents' ends
    const double at = beyond / (std::abs(ray.AxisSlope) > 1e-12 ? ray.AxisSlope : 1e-12);
    return ray.AxisSlope > 0.0 ? Vec2(std::max(dark.x, at), dark.y)
                               : Vec2(dark.x, std::min(dark.y, at));
  }
  const Vec3 from = ToVector(start) - center;
  const Vec3 across = from - dot(from, light) * light;
  const Vec3 aside = direction - dot(direction, light) * light;
  const double a = std::max(dot(aside, aside), 1e-18);
  const double b = dot(across, aside);
  const double root = b * b - a * (dot(across, across) - radius * radius);
  if (root <= 0.0)
  {
    return Vec2(0.0, 0.0);
  }
  const double slope = dot(direction, light);
  const double at = -dot(from, light) / (std::abs(slope) > 1e-12 ? slope : 1e-12);
  const Vec2 dark((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
  return slope > 0.0 ? Vec2(dark.x, std::min(dark.y, at)) : Vec2(std::max(dark.x, at), dark.y);
}

// None of a sun where it is higher over the eye than what can be seen is wide.
void vtkGodRaysAirlight::FindPlanetShadow()
{
  const Scene& setup = this->Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  double reach = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    double start[3];
    double way[3];
    const double x = corner % 2 == 0 ? 0.0 : setup.Size[0] + 8.0;
    const double y = corner / 2 == 0 ? 0.0 : setup.Size[1] + 8.0;
    this->GetRay(x, y, start, way);
    reach =
      std::max(reach, length(ToVector(start)) + medium.FarLimit * this->GetLengthPerDepth(x, y));
  }
  const double rise = dot(ToVector(medium.Up), ToVector(setup.Light));
  this->HasPlanetShadow =
    this->IsPlanet && (setup.Point || (medium.PlanetRadius + medium.EyeHeight) * rise < reach);
  this->MaximumNumberOfParts = this->HasPlanetShadow ? MaximumParts : 1;
}

// The cone of a light that fades ends where next to nothing is left of it.
void vtkGodRaysAirlight::MakeFade()
{
  const vtkGodRaysSpot& spot = this->Setup.Spot;
  this->Fade.clear();
  this->Steps = 1;
  this->CosLit = spot.CosCone;
  if (!spot.Fades())
  {
    return;
  }
  this->CosLit = std::max(this->CosLit, std::pow(LeastFade, 1.0 / spot.Exponent));
  const double least = std::pow(this->CosLit, spot.Exponent);
  this->Steps = static_cast<int>(std::ceil(LeastSteps + MoreSteps * (1.0 - least)));
  this->Fade.resize(FadeEntries);
  for (int i = 0; i < FadeEntries; ++i)
  {
    const double cosine = this->CosLit + (1.0 - this->CosLit) * i / (FadeEntries - 2.0);
    this->Fade[i] = static_cast<float>(std::pow(std::min(cosine, 1.0), spot.Exponent));
  }
}

void vtkGodRaysAirlight::GetFactors(double y, int first, int count, float* factors) const
{
  for (int begin = 0; begin < count; begin += Batch)
  {
    const int number = std::min(Batch, count - begin);
    if (this->Setup.Point)
    {
      this->GetPointFactors(static_cast<float>(y), first + begin, number, factors + begin, count);
    }
    else
    {
      this->GetPhaseFactors(static_cast<float>(y), first + begin, number, factors + begin, count);
    }
  }
  if (this->Closed)
  {
    return;
  }
  // The totals, bilinear as the shapes are.
  const int planes = this->GetNumberOfPlanes();
  for (int i = 0; i < count; ++i)
  {
    float u;
    float v;
    const Cell& cell = this->FindCell(static_cast<float>(first + i), static_cast<float>(y), u, v);
    const float* totals[4];
    for (int corner = 0; corner < 4; ++corner)
    {
      totals[corner] =
        this->Totals.data() + static_cast<std::ptrdiff_t>(cell.Corners[corner]) * planes;
    }
    for (int k = 0; k < this->Components; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int p = k * this->Channels + (this->Channels == 3 ? c : 0);
        factors[static_cast<std::ptrdiff_t>(3 * k + c) * count + i] *=
          (1.0f - v) * ((1.0f - u) * totals[0][p] + u * totals[1][p]) +
          v * ((1.0f - u) * totals[2][p] + u * totals[3][p]);
      }
    }
  }
}

// The light's intensity is that of a medium without extinction; colours that one component scatters are in
// proportion to the first, if one channel serves them.
void vtkGodRaysAirlight::GetPointFactors(
  float y, int first, int count, float* factors, int stride) const
{
  const double* scattering = this->Setup.Medium.Components[0].Scattering;
  for (int i = 0; i < count; ++i)
  {
    float foot;
    float height;
    float end;
    this->GetPass(static_cast<float>(first + i), y, foot, height, end);
    const float adjacent = height * height - foot * (end - foot);
    const float unit = std::atan2(height * end, adjacent) / height;
    for (int c = 0; c < 3; ++c)
    {
      factors[static_cast<std::ptrdiff_t>(c) * stride + i] =
        this->Channels == 1 ? unit * static_cast<float>(scattering[c] / scattering[0]) : unit;
    }
  }
}

void vtkGodRaysAirlight::GetPhaseFactors(
  float y, int first, int count, float* factors, int stride) const
{
  const vtkGodRaysMedium& medium = this->Setup.Medium;
  const float pixel = static_cast<float>(this->Setup.PixelSize);
  const float py = (y - static_cast<float>(this->Setup.Center[1])) * pixel;
  const float light[3] = { static_cast<float>(this->Setup.Light[0]),
    static_cast<float>(this->Setup.Light[1]), static_cast<float>(this->Setup.Light[2]) };
  float sines[Batch]; // of half the angle
  float cosines[Batch];
  for (int i = 0; i < count; ++i)
  {
    const float px =
      (static_cast<float>(first + i) - static_cast<float>(this->Setup.Center[0])) * pixel;
    const float x = this->Setup.Parallel ? 0.0f : px;
    const float z = this->Setup.Parallel ? 0.0f : py;
    const float inverse = 1.0f / std::sqrt(1.0f + x * x + z * z);
    const float way[3] = { x * inverse, z * inverse, inverse };
    float less = 0.0f;
    float more = 0.0f;
    for (int k = 0; k < 3; ++k)
    {
      less += (way[k] - light[k]) * (way[k] - light[k]);
      more += (way[k] + light[k]) * (way[k] + light[k]);
    }
    sines[i] = 0.5f * std::sqrt(less);
    cosines[i] = 0.5f * std::sqrt(more);
  }
  for (int k = 0; k < this->Components; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      std::fill_n(factors + static_cast<std::ptrdiff_t>(3 * k + c) * stride, count, 0.0f);
    }
  }
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const int plane = this->Components > 1 ? k : 0;
    const double* scattering = medium.Components[k].Scattering;
    for (int i = 0; i < count; ++i)
    {
      const float phase = LookUpPhase(this->Phases[k], sines[i], cosines[i]);
      for (int c = 0; c < 3; ++c)
      {
        factors[static_cast<std::ptrdiff_t>(3 * plane + c) * stride + i] +=
          phase * static_cast<float>(scattering[c]);
      }
    }
  }
}

std::string vtkGodRaysAirlight::Describe() const
{
  const int planes = this->GetNumberOfPlanes();
  return std::to_string(planes) + (planes > 1 ? " airlights of a " : " airlight of a ") +
    (this->Setup.Point ? "point light, " : "directional light, ") +
    (this->Setup.Medium.HasExponentialDensity() ? "layered" : "homogeneous") + " medium" +
    (this->IsPlanet ? " over a planet, " : ", ") +
    (this->Setup.Parallel ? "parallel projection, " : "perspective, ") +
    (this->Closed ? std::string("closed form")
                  : "table of " + std::to_string(this->Ladders.size()) + " rays x " +
          std::to_string(NumberOfNodes) + " nodes");
}
