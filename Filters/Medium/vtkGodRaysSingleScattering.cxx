// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSingleScattering.h"

#include "vtkGodRaysGridRay.h"
#include "vtkGodRaysKronrod.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysTriangleTree.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
using vtkGodRays::Vec3;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr double Parallel = 1e-9; // sine of the angle to the light below which a ray is along it

struct Interval
{
  double Begin;
  double End;
};

using vtkGodRays::Triangle;
using vtkGodRays::TriangleTree;

// A view ray in the plane that it spans with the light. Places in it are (distance along the ray,
// distance from the ray towards the light).
class Slice
{
public:
  // light: a position, or a direction of length 1. direction has length 1.
  Slice(const Vec3& origin, const Vec3& direction, const Vec3& light, bool directional)
    : Origin(origin)
    , Along(direction)
    , Directional(directional)
  {
    const Vec3 to = directional ? light : light - origin;
    this->Foot = vtkGodRays::dot(to, direction);
    const Vec3 across = to - this->Foot * direction;
    this->Height = vtkGodRays::length(across);
    this->AlongLight = !(this->Height > Parallel * std::abs(this->Foot));
    if (this->AlongLight)
    {
      const Vec3 axis = std::abs(direction.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
      const Vec3 side = vtkGodRays::cross(direction, axis);
      this->Across = side / vtkGodRays::length(side);
    }
    else
    {
      this->Across = across / this->Height;
    }
    this->Normal = vtkGodRays::cross(this->Along, this->Across);
  }

  // What of the ray before end is hidden from the light, in any order, and where it meets surfaces.
  void Cut(const TriangleTree& tree, double end, std::vector<Interval>& hidden,
    std::vector<double>& crossings) const
  {
    const auto skip = [&](const Vec3& centre, const Vec3& half)
    {
      const double y = vtkGodRays::dot(this->Across, centre - this->Origin);
      const double reach = vtkGodRays::dot(vtkGodRays::abs(this->Across), half);
      return y + reach < -1e-9 * reach ||
        (this->AlongLight ? y - reach > 1e-9 * reach
                          : !this->Directional && y - reach > this->Height);
    };
    const auto visit = [&](const Triangle& triangle)
    { this->Cut(triangle, end, hidden, crossings); };
    this->Find(tree, skip, visit);
  }

  const Vec3& GetDirection() const { return this->Along; }

  // Distance from the eye of the foot of the light on the ray, and of the light from there; or the
  // cosine of the angle to the light, and its sine.
  double Foot;
  double Height;
  bool AlongLight;

private:
  template <typename Skip, typename Visit>
  void Find(const TriangleTree& tree, const Skip& skip, const Visit& visit) const
  {
    tree.Find(this->Normal, vtkGodRays::dot(this->Normal, this->Origin), skip, visit);
  }

  struct Place
  {
    double Along;
    double Across;
  };

  void Cut(const Triangle& triangle, double end, std::vector<Interval>& hidden,
    std::vector<double>& crossings) const
  {
    double side[3];
    for (int i = 0; i < 3; ++i)
    {
      side[i] = vtkGodRays::dot(this->Normal, triangle[i] - this->Origin);
    }
    Place places[2];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if ((side[i] < 0.0) == (side[j] < 0.0))
      {
        continue;
      }
      // Both triangles of an edge find the same point.
      const int low = side[i] < 0.0 ? i : j;
      const int high = i + j - low;
      const double t = side[low] / (side[low] - side[high]);
      const Vec3 point = triangle[low] + t * (triangle[high] - triangle[low]) - this->Origin;
      places[count++] = { vtkGodRays::dot(this->Along, point),
        vtkGodRays::dot(this->Across, point) };
    }
    if (count < 2)
    {
      return;
    }
    Place low = places[0];
    Place high = places[1];
    if (low.Across > high.Across)
    {
      std::swap(low, high);
    }
    if (low.Across < 0.0 && high.Across >= 0.0)
    {
      const double t = low.Across / (low.Across - high.Across);
      low.Along += t * (high.Along - low.Along);
      low.Across = 0.0;
      if (low.Along > 0.0)
      {
        crossings.push_back(low.Along);
      }
    }
    if (this->AlongLight || high.Across < 0.0)
    {
      return;
    }
    double ends[2];
    if (this->Directional)
    {
      ends[0] = low.Along - low.Across * this->Foot / this->Height;
      ends[1] = high.Along - high.Across * this->Foot / this->Height;
    }
    else
    {
      if (low.Across >= this->Height)
      {
        return;
      }
      // What is as far from the ray as the light hides its far end.
      const double highest = this->Height * (1.0 - 1e-12);
      if (high.Across > highest && low.Across < highest)
      {
        const double t = (highest - low.Across) / (high.Across - low.Across);
        high.Along = low.Along + t * (high.Along - low.Along);
        high.Across = highest;
      }
      ends[0] = this->Project(low);
      ends[1] = this->Project(high);
    }
    const double begin = std::max(std::min(ends[0], ends[1]), 0.0);
    const double last = std::min(std::max(ends[0], ends[1]), end);
    if (last > begin)
    {
      hidden.push_back({ begin, last });
    }
  }

  double Project(const Place& place) const
  {
    const double left = std::max(this->Height - place.Across, 1e-13 * this->Height);
    return this->Foot + (place.Along - this->Foot) * (this->Height / left);
  }

  Vec3 Origin;
  Vec3 Along;
  Vec3 Across;
  Vec3 Normal;
  bool Directional;
};

// The integrand along one ray: radiance per length, or per angle at a point light.
struct Scatter
{
  vtkGodRaysMedium Medium;
  Vec3 Light;
  bool Directional;
  vtkGodRays::LitRay Ray;
  const vtkGodRaysGridRay* Data = nullptr;

  // From a distance to the variable of integration.
  double ToVariable(double s) const
  {
    return this->Directional ? s : std::atan2(s - this->Ray.Foot, this->Ray.Distance);
  }

  Vec3 operator()(double v) const
  {
    if (this->Directional)
    {
      return this->Light * this->Evaluate(v, this->Ray.Foot, 0.0);
    }
    const double s = std::max(this->Ray.Foot + this->Ray.Distance * std::tan(v), 0.0);
    return this->Light / this->Ray.Distance *
      this->Evaluate(s, -std::sin(v), this->Ray.Distance / std::cos(v));
  }

  // The optical depth of the way to the eye.
  Vec3 GetDepth(double s) const
  {
    Vec3 depth(0.0);
    for (int k = 0; k < this->Medium.NumberOfComponents; ++k)
    {
      const vtkGodRaysMedium::Component& component = this->Medium.Components[k];
      const double length = vtkGodRays::MediumDepth(
        this->Ray.PlanetRadius, this->Ray.Height, this->Ray.Slope, component.ScaleHeight, s);
      depth += length * (GetVector(component.Scattering) + GetVector(component.Absorption));
    }
    if (this->Data)
    {
      Vec3 scattered(0.0);
      this->Data->Add(s, 0.0, false, scattered, depth);
    }
    return depth;
  }

private:
  // What is scattered at a distance and reaches the eye, of light that has a way to go to there.
  Vec3 Evaluate(double s, double cosAngle, double way) const
  {
    Vec3 scattered(0.0);
    Vec3 depth(0.0);
    const double radius = this->Ray.PlanetRadius;
    const double height = vtkGodRays::MediumHeight(radius, this->Ray.Height, this->Ray.Slope, s);
    const double lightSlope = vtkGodRays::LightSlope(this->Ray, height, s, std::max(way, 1e-300));
    if (vtkGodRays::IsInPlanetShadow(this->Ray, height, lightSlope, way))
    {
      return scattered;
    }
    for (int k = 0; k < this->Medium.NumberOfComponents; ++k)
    {
      const vtkGodRaysMedium::Component& component = this->Medium.Components[k];
      const Vec3 scattering = GetVector(component.Scattering);
      const double scaleHeight = component.ScaleHeight;
      const bool even = scaleHeight == 0.0;
      const double phase = (1.0 - component.SecondWeight) *
          vtkGodRays::Phase({ component.PhaseFunction, component.Asymmetry }, cosAngle) +
        component.SecondWeight *
          vtkGodRays::Phase({ component.SecondPhaseFunction, component.SecondAsymmetry }, cosAngle);
      double length =
        vtkGodRays::MediumDepth(radius, this->Ray.Height, this->Ray.Slope, scaleHeight, s);
      if (!this->Directional)
      {
        length += vtkGodRays::MediumDepth(radius, height, lightSlope, scaleHeight, way);
      }
      else if (!even)
      {
        length += lightSlope > 0.0 || radius > 0.0
          ? vtkGodRays::MediumColumn(radius, height, lightSlope, scaleHeight)
          : Infinity;
      }
      const double density = even ? 1.0 : vtkGodRays::ExponentialDensity(height, scaleHeight);
      scattered += phase * density * scattering;
      // No extinction is none even over an infinite way.
      const Vec3 extinction = scattering + GetVector(component.Absorption);
      for (int c = 0; c < 3; ++c)
      {
        depth[c] += extinction[c] > 0.0 ? extinction[c] * length : 0.0;
      }
    }
    if (this->Data)
    {
      this->Data->Add(s, cosAngle, true, scattered, depth);
    }
    const double spot =
      this->Directional ? 1.0 : vtkGodRays::SpotFactor(this->Ray, s, std::max(way, 1e-300));
    return scattered * (spot * vtkGodRays::exp(-depth));
  }

  static Vec3 GetVector(const double* v) { return Vec3(v[0], v[1], v[2]); }
};

double GetLargest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

// The integral by one application of the rules, and whether it is as exact as that.
bool Estimate(const Scatter& f, double a, double b, double error, Vec3& integral)
{
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  const auto [kronrod, gauss] = vtkGodRays::SumByKronrod(f, middle, half);
  // Below this there is only rounding.
  const double rounding = 2e-14 * GetLargest(kronrod);
  integral = kronrod * half;
  return GetLargest(kronrod - gauss) * half <= std::max(error, rounding * half);
}

// To an absolute error, or as closely as it takes with halves of halves, depth times.
Vec3 Integrate(const Scatter& f, double a, double b, double error, int depth)
{
  Vec3 integral;
  if (Estimate(f, a, b, error, integral) || depth == 0)
  {
    return integral;
  }
  const double middle = 0.5 * (a + b);
  return Integrate(f, a, middle, 0.5 * error, depth - 1) +
    Integrate(f, middle, b, 0.5 * error, depth - 1);
}

// Between distances, in the gaps of which the integrand is smooth, a few of them at a time.
Vec3 IntegrateGaps(
  const Scatter& f, const double* places, std::size_t gaps, double error, int depth)
{
  constexpr std::size_t most = 4; // in which three places of each are looked at
  const double a = f.ToVariable(places[0]);
  const double b = f.ToVariable(places[gaps]);
  Vec3 integral;
  if (gaps == 1)
  {
    return Integrate(f, a, b, error, depth);
  }
  if (gaps <= most && Estimate(f, a, b, error, integral))
  {
    return integral;
  }
  const std::size_t half = gaps / 2;
  return IntegrateGaps(f, places, half, 0.5 * error, depth) +
    IntegrateGaps(f, places + half, gaps - half, 0.5 * error, depth);
}

// Between two distances. Where the density falls, in parts that double, so that no layer near the
// eye is overlooked.
Vec3 IntegrateWay(const Scatter& f, double from, double to, double end, double error)
{
  constexpr int depth = 40;
  const int parts = f.Medium.HasExponentialDensity() ? 13 : 1;
  Vec3 sum(0.0);
  std::vector<double> places;
  double begin = from;
  const auto addPart = [&](double place)
  {
    const double next = std::min(place, to);
    if (!(next > begin))
    {
      return;
    }
    places.assign(1, begin);
    if (f.Data)
    {
      const std::vector<double>& knots = f.Data->GetKnots();
      const auto first = std::upper_bound(knots.begin(), knots.end(), begin);
      std::unique_copy(
        first, std::lower_bound(first, knots.end(), next), std::back_inserter(places));
    }
    places.push_back(next);
    sum += IntegrateGaps(f, places.data(), places.size() - 1, error / parts, depth);
    begin = next;
  };
  // No gap beside data, which may be many times as long as a cell, is looked at together with cells.
  const auto add = [&](double place)
  {
    if (f.Data)
    {
      const std::vector<double>& ends = f.Data->GetEnds();
      for (auto i = std::upper_bound(ends.begin(), ends.end(), begin);
           i != ends.end() && *i < place; ++i)
      {
        addPart(*i);
      }
    }
    addPart(place);
  };
  for (int i = parts - 1; i >= 0; --i)
  {
    const double next = std::ldexp(end, -i);
    // Layers far below an eye are thin for what is before them.
    const int pieces = f.Ray.PlanetRadius > 0.0 && i < 3 ? 32 : 1;
    const double last = begin;
    for (int k = 1; k <= pieces; ++k)
    {
      add(last + (next - last) * k / pieces);
    }
  }
  return sum;
}
}

class vtkGodRaysSingleScattering::vtkInternals
{
public:
  std::unique_ptr<TriangleTree> Occluders = std::make_unique<TriangleTree>(nullptr);
  std::unique_ptr<TriangleTree> Seen; // null: the occluders
  Vec3 Position = Vec3(0.0);
  Vec3 Axes[3]; // right, up, forward
  bool Parallel = false;
  std::vector<vtkGodRaysGrid> Grids;
  Scatter Ray; // but for the ray
  Vec3 Light;  // position, or direction of length 1
  Vec3 Upwards;
  Vec3 SpotAxis;
  vtkGodRaysSpot Spot;
  double Tolerance = 1e-6;

  Slice MakeSlice(double x, double y, Vec3& origin, double& perDepth) const
  {
    const Vec3 offset = x * this->Axes[0] + y * this->Axes[1];
    const Vec3 way = this->Parallel ? this->Axes[2] : this->Axes[2] + offset;
    origin = this->Position + (this->Parallel ? offset : Vec3(0.0));
    perDepth = vtkGodRays::length(way);
    return Slice(origin, way / perDepth, this->Light, this->Ray.Directional);
  }

  // The place of the first surface that ends the ray, whose crossings with occluders are known.
  double FindSight(const Slice& slice, double farthest, const std::vector<double>& crossings) const
  {
    std::vector<double> sights;
    if (this->Seen)
    {
      std::vector<Interval> unhidden;
      slice.Cut(*this->Seen, farthest, unhidden, sights);
    }
    double sight = Infinity;
    for (const double crossing : this->Seen ? sights : crossings)
    {
      sight = std::min(sight, crossing);
    }
    return sight;
  }

  // What hides all of a ray along the light's from it: see Slice.
  static void HideAlong(const Slice& slice, bool directional, double farthest,
    const std::vector<double>& crossings, std::vector<Interval>& hidden)
  {
    // A point light hides behind what is before it; one behind the eye before all.
    const double reach = directional ? Infinity : slice.Foot;
    double first = 0.0;
    double last = Infinity;
    for (const double crossing : crossings)
    {
      if (slice.Foot > 0.0 && crossing < reach)
      {
        first = crossing;
      }
      // And what is beyond hides behind what is between.
      if (crossing > (directional ? 0.0 : slice.Foot) && (!directional || slice.Foot < 0.0))
      {
        last = std::min(last, crossing);
      }
    }
    hidden.push_back({ 0.0, std::min(first, farthest) });
    if (last < farthest)
    {
      hidden.push_back({ last, farthest });
    }
  }

  struct Veil
  {
    std::unique_ptr<TriangleTree> Triangles;
    Vec3 Through;
  };
  std::vector<Veil> Veils;

  /// A part of a ray that light reaches through something.
  struct Veiled
  {
    Interval Part;
    Vec3 Through;
  };

  std::vector<Veiled> FindVeiled(const Slice& slice, double farthest) const
  {
    std::vector<Veiled> all;
    for (const Veil& veil : this->Veils)
    {
      std::vector<Interval> parts;
      std::vector<double> crossings;
      slice.Cut(*veil.Triangles, farthest, parts, crossings);
      for (const double crossing : crossings)
      {
        if (slice.AlongLight)
        {
          HideAlong(slice, this->Ray.Directional, farthest, { crossing }, parts);
        }
      }
      for (const Interval& part : parts)
      {
        all.push_back({ part, veil.Through });
      }
    }
    return all;
  }

  // Of a lit part of a ray, piece by piece.
  template <typename Integrate>
  static Vec3 SumVeiled(
    const std::vector<Veiled>& veiled, double from, double to, const Integrate& integrate)
  {
    std::vector<double> ends = { from, to };
    for (const Veiled& veil : veiled)
    {
      ends.push_back(std::min(std::max(veil.Part.Begin, from), to));
      ends.push_back(std::min(std::max(veil.Part.End, from), to));
    }
    std::sort(ends.begin(), ends.end());
    Vec3 sum(0.0);
    for (std::size_t i = 1; i < ends.size(); ++i)
    {
      if (!(ends[i] > ends[i - 1]))
      {
        continue;
      }
      const double middle = 0.5 * (ends[i - 1] + ends[i]);
      Vec3 through(1.0);
      for (const Veiled& veil : veiled)
      {
        through *= veil.Part.Begin < middle && middle < veil.Part.End ? veil.Through : Vec3(1.0);
      }
      sum += through * integrate(ends[i - 1], ends[i]);
    }
    return sum;
  }

  // The light of a ray's lit parts up to an end.
  Vec3 Sum(const Scatter& f, double end, std::vector<Interval>& hidden,
    const std::vector<Veiled>& veiled) const
  {
    std::sort(hidden.begin(), hidden.end(),
      [](const Interval& a, const Interval& b) { return a.Begin < b.Begin; });
    const auto integrate = [&](double from, double to, double error)
    { return IntegrateWay(f, from, to, end, error); };
    Vec3 whole = integrate(0.0, end, Infinity);
    whole = f.Data ? whole : integrate(0.0, end, 1e-3 * GetLargest(whole));
    const double error = this->Tolerance * GetLargest(whole);
    const auto integrateLit = [&](double from, double to)
    {
      return veiled.empty()
        ? integrate(from, to, error)
        : SumVeiled(veiled, from, to, [&](double a, double b) { return integrate(a, b, error); });
    };
    Vec3 sum(0.0);
    double lit = 0.0; // from here on
    for (const Interval& interval : hidden)
    {
      if (interval.Begin >= end)
      {
        break;
      }
      if (interval.Begin > lit)
      {
        sum += integrateLit(lit, interval.Begin);
      }
      lit = std::max(lit, interval.End);
    }
    return lit < end ? sum + integrateLit(lit, end) : sum;
  }
};

vtkGodRaysSingleScattering::vtkGodRaysSingleScattering()
  : Internals(new vtkInternals)
{
  this->SetParameters(Parameters());
}

vtkGodRaysSingleScattering::~vtkGodRaysSingleScattering() = default;

void vtkGodRaysSingleScattering::SetOccluders(vtkPolyData* occluders)
{
  this->Internals->Occluders = std::make_unique<TriangleTree>(occluders);
}

void vtkGodRaysSingleScattering::SetSeen(vtkPolyData* seen)
{
  this->Internals->Seen = seen ? std::make_unique<TriangleTree>(seen) : nullptr;
}

void vtkGodRaysSingleScattering::SetGrids(const std::vector<vtkGodRaysGrid>& grids)
{
  this->Internals->Grids = grids;
}

void vtkGodRaysSingleScattering::AddVeil(vtkPolyData* surface, const double through[3])
{
  this->Internals->Veils.push_back(
    { std::make_unique<TriangleTree>(surface), Vec3(through[0], through[1], through[2]) });
}

void vtkGodRaysSingleScattering::RemoveAllVeils()
{
  this->Internals->Veils.clear();
}

void vtkGodRaysSingleScattering::SetParameters(const Parameters& parameters)
{
  vtkInternals& self = *this->Internals;
  const auto vector = [](const double* v) { return Vec3(v[0], v[1], v[2]); };
  self.Position = vector(parameters.Position);
  self.Axes[0] = vector(parameters.Right);
  self.Axes[1] = vector(parameters.Up);
  self.Axes[2] = vector(parameters.Forward);
  const auto toWorld = [&](const double* v)
  { return v[0] * self.Axes[0] + v[1] * self.Axes[1] + v[2] * self.Axes[2]; };
  self.Parallel = parameters.Parallel;
  self.Ray.Directional = parameters.Light[3] == 0.0;
  self.Light = vector(parameters.Light);
  self.Light =
    self.Light / (self.Ray.Directional ? vtkGodRays::length(self.Light) : parameters.Light[3]);
  self.Ray.Medium = parameters.Medium;
  self.Ray.Light = vector(parameters.LightColor);
  self.Upwards = toWorld(parameters.Medium.Up);
  self.Spot = parameters.Spot;
  self.SpotAxis = toWorld(parameters.Spot.Axis);
  self.Tolerance = parameters.Tolerance;
}

void vtkGodRaysSingleScattering::Evaluate(double x, double y, Result& result, double depth) const
{
  const vtkInternals& self = *this->Internals;
  const vtkGodRaysMedium& medium = self.Ray.Medium;
  const bool directional = self.Ray.Directional;
  Vec3 origin;
  const Slice slice = self.MakeSlice(x, y, origin, result.LengthPerDepth);
  const double farthest = result.LengthPerDepth * medium.FarLimit;
  std::vector<Interval> hidden;
  result.Crossings.clear();
  slice.Cut(*self.Occluders, farthest, hidden, result.Crossings);
  std::sort(result.Crossings.begin(), result.Crossings.end());
  const double sight =
    depth > 0.0 ? depth * result.LengthPerDepth : self.FindSight(slice, farthest, result.Crossings);
  result.Sight = sight / result.LengthPerDepth;
  Scatter f = self.Ray;
  const auto start = [&](const Vec3& place, const Vec3& toward)
  {
    return vtkGodRays::MediumStart(
      medium.PlanetRadius, medium.EyeHeight, self.Upwards, place - self.Position, toward);
  };
  const Vec3 along = slice.GetDirection();
  const auto begin = start(origin, along);
  f.Ray = { directional ? 1 : 0, slice.Foot, 0.0, begin.x, begin.y,
    directional ? start(origin, self.Light).y : start(self.Light, self.Light).x,
    medium.PlanetRadius, vtkGodRays::dot(self.SpotAxis, origin - self.Light),
    vtkGodRays::dot(self.SpotAxis, along), {}, 0 };
  self.Spot.SetShape(f.Ray);
  const double end = vtkGodRays::MediumEnd(f.Ray, std::min(sight, farthest));
  if (!directional)
  {
    f.Ray.Distance = vtkGodRays::PointLightHeight(slice.Foot, slice.Height, 0.0, end);
    const auto part = vtkGodRays::SpotPart(f.Ray, end);
    hidden.push_back({ 0.0, part.x });
    hidden.push_back({ std::max(part.x, part.y), end });
  }
  if (slice.AlongLight && !result.Crossings.empty())
  {
    vtkInternals::HideAlong(slice, directional, farthest, result.Crossings, hidden);
  }
  vtkGodRaysGridRay data;
  if (!self.Grids.empty())
  {
    data.Cast(self.Grids, origin, along, end, self.Light, directional);
    f.Data = &data;
  }
  const Vec3 sum = self.Sum(f, end, hidden, self.FindVeiled(slice, farthest));
  const Vec3 left = vtkGodRays::exp(-f.GetDepth(end));
  result.Transmittance[0] = left.x;
  result.Transmittance[1] = left.y;
  result.Transmittance[2] = left.z;
  result.Radiance[0] = sum.x;
  result.Radiance[1] = sum.y;
  result.Radiance[2] = sum.z;
}

double vtkGodRaysSingleScattering::FindSight(double x, double y) const
{
  const vtkInternals& self = *this->Internals;
  Vec3 origin;
  double perDepth;
  const Slice slice = self.MakeSlice(x, y, origin, perDepth);
  const double farthest = perDepth * self.Ray.Medium.FarLimit;
  std::vector<Interval> hidden;
  std::vector<double> crossings;
  if (!self.Seen)
  {
    slice.Cut(*self.Occluders, farthest, hidden, crossings);
  }
  return self.FindSight(slice, farthest, crossings) / perDepth;
}
