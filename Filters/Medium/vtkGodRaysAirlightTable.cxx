// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAirlightTable.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// A ray's spline has 64 parts: its interpolation is within 1e-4 of the ray's light in the tests' scenes.
constexpr int NumberOfParts = 64;
constexpr int NumberOfNodes = NumberOfParts + 1;

// The coarsest grid has about so many rays in the picture's height.
constexpr double NumberOfRows = 64.0;

// Rays are added where one differs by more from the mean of those beside it [fraction].
constexpr float RayTolerance = 1e-3f;

// Places that are evaluated together.
constexpr int Batch = 64;
}

// The integrand along one ray, in the coordinates of its nodes.
struct vtkGodRaysAirlightTable::Sampler
{
  const vtkGodRaysAirlightTable& Airlight;
  LitRay Ray;
  double Begin = 0.0;
  double End = 0.0;
  double Bend = 1.0;
  PointRay<double> Point = {};

  Sampler(const vtkGodRaysAirlightTable& airlight, double x, double y);

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
    for (int p = 0; p < this->Airlight.Setup.GetNumberOfPlanes(); ++p)
    {
      values[p] *= change;
    }
  }

  // A point light's airlight without extinction, of which the totals are fractions: it is not smooth where
  // the ray is towards the light, or away from it.
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

vtkGodRaysAirlightTable::Sampler::Sampler(
  const vtkGodRaysAirlightTable& airlight, double x, double y)
  : Airlight(airlight)
{
  const vtkGodRaysAirlightScene& setup = airlight.Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  double start[3];
  double way[3];
  setup.GetRay(x, y, start, way);
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
    ? setup.LightHeight
    : MediumStart(medium.PlanetRadius, medium.EyeHeight, up, origin, light).y;
  ray.PlanetRadius = medium.PlanetRadius;
  ray.ThroughGround = 1;
}

void vtkGodRaysAirlightTable::Sampler::Sample(double distance, double* values) const
{
  const vtkGodRaysAirlightScene& setup = this->Airlight.Setup;
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
  for (int c = 0; c < this->Airlight.Setup.Channels; ++c)
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
      for (int k = 0; k < this->Airlight.Setup.Components; ++k)
      {
        values[k * this->Airlight.Setup.Channels + c] = left * parts[k];
      }
    }
  }
}

double vtkGodRaysAirlightTable::Sampler::GetEyeDepth(double distance) const
{
  const vtkGodRaysMedium& medium = this->Airlight.Setup.Medium;
  double least = 1e300;
  for (int c = 0; c < this->Airlight.Setup.Channels; ++c)
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
void vtkGodRaysAirlightTable::Sampler::FindEnds()
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
void vtkGodRaysAirlightTable::Sampler::FindBend()
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
    for (int p = 0; p < this->Airlight.Setup.GetNumberOfPlanes(); ++p)
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

void vtkGodRaysAirlightTable::Prepare(const vtkGodRaysAirlightScene& scene)
{
  this->Setup = scene;
  this->MakeKey(this->NewKey);
  if (this->NewKey != this->Key)
  {
    this->MakeTable();
    this->Key = this->NewKey;
  }
}

void vtkGodRaysAirlightTable::MakeKey(std::vector<double>& key) const
{
  const vtkGodRaysAirlightScene& setup = this->Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  key.assign({ setup.Size[0] + 0.0, setup.Size[1] + 0.0, setup.PixelSize, setup.Center[0],
    setup.Center[1], setup.Parallel + 0.0, setup.Point + 0.0, setup.Light[0], setup.Light[1],
    setup.Light[2], medium.Up[0], medium.Up[1], medium.Up[2], medium.EyeHeight, medium.PlanetRadius,
    medium.FarLimit, this->Setup.Channels + 0.0 });
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

void vtkGodRaysAirlightTable::MakeTable()
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
void vtkGodRaysAirlightTable::MakeRays()
{
  const std::size_t first = this->Ladders.size();
  const std::size_t rays = this->Pixels.size() / 2;
  this->Ladders.resize(rays);
  this->Units.resize(rays);
  this->Totals.resize(rays * this->Setup.GetNumberOfPlanes());
  this->Nodes.resize(rays * NumberOfNodes * 2 * this->Setup.GetNumberOfPlanes());
  vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(rays), 16,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType ray = begin; ray < end; ++ray)
      {
        this->MakeLadder(static_cast<int>(ray), this->Pixels[2 * ray], this->Pixels[2 * ray + 1]);
      }
    });
}

// Splits cells in four where a ray is not about the mean of those beside it: of the coarsest grid by the rays
// that are there, at half the size by those that splitting adds.
void vtkGodRaysAirlightTable::Refine()
{
  const int planes = this->Setup.GetNumberOfPlanes();
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
void vtkGodRaysAirlightTable::Split(int index, int x, int y, int side)
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

int vtkGodRaysAirlightTable::FindRay(int x, int y)
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
float vtkGodRaysAirlightTable::GetDifference(int ray, const int* others, int count) const
{
  const int planes = this->Setup.GetNumberOfPlanes();
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
inline const vtkGodRaysAirlightTable::Cell& vtkGodRaysAirlightTable::FindCell(
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
inline void vtkGodRaysAirlightTable::Place::FindWeight()
{
  const float x = 1.0f - 2.0f * (this->Coordinate - this->First) / (this->Last - this->First);
  this->Early = 0.5f + 0.5f * x * x * x * x * x;
}

// Where between a ray's nodes the place is that corresponds to one on a ray beside it.
inline float vtkGodRaysAirlightTable::GetNode(int ray, const Place& place) const
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

void vtkGodRaysAirlightTable::MakeLadder(int index, double x, double y)
{
  Sampler sampler(*this, x, y);
  sampler.End = this->Setup.Medium.FarLimit * this->Setup.GetLengthPerDepth(x, y);
  if (this->Setup.Point)
  {
    sampler.Ray.Distance = std::max(sampler.Ray.Distance, this->Setup.Nearest);
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
  const int planes = this->Setup.GetNumberOfPlanes();
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

void vtkGodRaysAirlightTable::Evaluate(int count, const float* x, const float* y,
  const float* distances, float* values, int stride) const
{
  for (int first = 0; first < count; first += Batch)
  {
    this->EvaluateSome(std::min(Batch, count - first), x + first, y + first, distances + first,
      values + first, stride);
  }
}

void vtkGodRaysAirlightTable::EvaluateSome(int count, const float* xs, const float* ys,
  const float* distances, float* values, int stride) const
{
  const int planes = this->Setup.GetNumberOfPlanes();
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
    this->Setup.GetPass(xs[i], ys[i], foot, height, end);
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

void vtkGodRaysAirlightTable::GetTotals(float x, float y, float* totals) const
{
  const int planes = this->Setup.GetNumberOfPlanes();
  float u;
  float v;
  const Cell& cell = this->FindCell(x, y, u, v);
  std::fill_n(totals, planes, 0.0f);
  for (int corner = 0; corner < 4; ++corner)
  {
    const float weight = (corner % 2 == 1 ? u : 1.0f - u) * (corner / 2 == 1 ? v : 1.0f - v);
    const float* from =
      this->Totals.data() + static_cast<std::ptrdiff_t>(cell.Corners[corner]) * planes;
    for (int p = 0; p < planes; ++p)
    {
      totals[p] += weight * from[p];
    }
  }
}

std::string vtkGodRaysAirlightTable::Describe() const
{
  return "table of " + std::to_string(this->Ladders.size()) + " rays x " +
    std::to_string(NumberOfNodes) + " nodes";
}
