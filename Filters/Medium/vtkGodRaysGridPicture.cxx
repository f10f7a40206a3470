// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridPicture.h"

#include "vtkGodRaysGridBlocks.h"
#include "vtkGodRaysGridLight.h"
#include "vtkGodRaysGridShadows.h"
#include "vtkSMPTools.h"

#include <atomic>

namespace
{
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr int TileSize = 64; // pixels
constexpr int FirstGap = 8;  // between pixels
constexpr int FarParts = 16; // of what of a ray is outside of data, at least

using Blocks = vtkGodRaysGridBlocks;
using Place = vtkGodRaysGridPlace;

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

struct Result
{
  Vec3 Radiance;
  Vec3 Transmittance;
};
}

//------------------------------------------------------------------------------
class vtkGodRaysGridPicture::vtkInternals
{
public:
  std::vector<vtkGodRaysGrid> Grids;
  std::vector<Blocks> AllBlocks;
  std::vector<vtkGodRaysGridLight> Lights;
  vtkGodRaysGridShadows Shadows;
  double LastLight[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 }; // the last is 1 once there is one
  bool Kept = false;
  std::atomic<std::size_t> Rays{ 0 };
  std::atomic<std::size_t> Steps{ 0 };

  // Of a picture.
  Vec3 Position, Axes[3], Light, LightColor, SpotAxis, Upwards;
  bool Parallel = false;
  bool Directional = true;
  bool Haze = false;
  bool Grey = false; // all colours are alike but for factors
  vtkGodRaysMedium Medium;
  vtkGodRaysSpot Spot;
  double Tolerance = 1.0 / 255.0;
  vtkGodRays::MediumComponent Components[3][2];

  void SetUp(const vtkGodRaysSingleScattering::Parameters& parameters);
  Result Evaluate(double x, double y, double depth);

private:
  struct Passage
  {
    Vec3 Place;
    Vec3 Steps;
    double Begin;
    double End;
    double Speed; // points for each unit of length, along the axis along which that is most
  };
  struct Ray
  {
    Vec3 Origin;
    Vec3 Along;
    vtkGodRays::LitRay Lit;
    double Foot;
    Passage Passages[vtkGodRaysGridPicture::MaximumGrids];
  };
  struct Air // what the medium of formulas is at a place of a ray
  {
    Vec3 Scattered = Vec3(0.0); // [1/(length sr)]
    Vec3 Left = Vec3(1.0);      // of light on its ways to there and on
    bool Visible = true;
    double Cosine = 0.0;   // of the angle of scattering
    double Strength = 1.0; // of the light there, of its irradiance or intensity
  };

  Air GetAir(const Ray& ray, double s) const;
  void AddLightDepth(const Vec3& position, float* depth) const;
  void March(const Ray& ray, double begin, double end, Vec3& depth, Vec3& sum, std::size_t& steps);
  void Cross(const Ray& ray, double begin, double end, const Vec3& depth, Vec3& sum,
    std::size_t& steps) const;
};

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::vtkInternals::SetUp(
  const vtkGodRaysSingleScattering::Parameters& parameters)
{
  this->Position = ToVector(parameters.Position);
  this->Axes[0] = ToVector(parameters.Right);
  this->Axes[1] = ToVector(parameters.Up);
  this->Axes[2] = ToVector(parameters.Forward);
  const auto toWorld = [&](const double* v)
  { return v[0] * this->Axes[0] + v[1] * this->Axes[1] + v[2] * this->Axes[2]; };
  this->Parallel = parameters.Parallel;
  this->Directional = parameters.Light[3] == 0.0;
  this->Light = ToVector(parameters.Light);
  this->Light =
    this->Light / (this->Directional ? vtkGodRays::length(this->Light) : parameters.Light[3]);
  this->LightColor = ToVector(parameters.LightColor);
  this->Medium = parameters.Medium;
  this->Spot = parameters.Spot;
  this->SpotAxis = toWorld(parameters.Spot.Axis);
  this->Upwards = toWorld(parameters.Medium.Up);
  this->Shadows.Place(this->Position, this->Axes, this->Light, this->Directional);
  this->Tolerance = parameters.Tolerance;
  this->Haze = false;
  for (int k = 0; k < 2; ++k)
  {
    vtkGodRaysMedium::Component component;
    if (k < this->Medium.NumberOfComponents)
    {
      component = this->Medium.Components[k];
    }
    for (int c = 0; c < 3; ++c)
    {
      const double extinction = component.Scattering[c] + component.Absorption[c];
      this->Components[c][k] = { component.Scattering[c], extinction, component.ScaleHeight,
        { component.PhaseFunction, component.Asymmetry },
        { component.SecondPhaseFunction, component.SecondAsymmetry }, component.SecondWeight };
      this->Haze = this->Haze || extinction > 0.0;
    }
  }
  this->Grey = this->Medium.IsGrey() && !this->Shadows.AreColored();
  for (const vtkGodRaysGrid& grid : this->Grids)
  {
    this->Grey = this->Grey && grid.Bands == 1 && grid.ScatteringBands <= 1 &&
      grid.Albedo[0] == grid.Albedo[1] && grid.Albedo[1] == grid.Albedo[2];
  }

  const double light[5] = { this->Light.x, this->Light.y, this->Light.z,
    this->Directional ? 0.0 : 1.0, 1.0 };
  const double rounding = 1e-9 *
    (this->Directional ? 1.0
                       : std::max(vtkGodRays::length(this->Light),
                           vtkGodRays::length(this->Light - this->Position)));
  this->Kept = std::equal(light + 3, light + 5, this->LastLight + 3) &&
    std::equal(light, light + 3, this->LastLight,
      [=](double a, double b) { return std::abs(a - b) <= rounding; });
  if (!this->Kept)
  {
    this->Lights.resize(this->Grids.size());
    for (std::size_t i = 0; i < this->Grids.size(); ++i)
    {
      this->Lights[i].Build(this->Grids[i], this->Light, this->Directional);
    }
    std::copy_n(light, 5, this->LastLight);
  }
}

//------------------------------------------------------------------------------
vtkGodRaysGridPicture::vtkInternals::Air vtkGodRaysGridPicture::vtkInternals::GetAir(
  const Ray& ray, double s) const
{
  Air air;
  const vtkGodRays::LitRay& lit = ray.Lit;
  const double beyond = s - ray.Foot;
  const double r = std::max(std::hypot(lit.Distance, beyond), 1e-30);
  air.Cosine = this->Directional ? ray.Foot : -beyond / r;
  if (!this->Directional)
  {
    air.Visible = vtkGodRays::IsInSpot(lit, s, r);
    air.Strength = vtkGodRays::SpotFactor(lit, s, r) / (r * r);
  }
  if (!this->Haze)
  {
    return air;
  }
  const double height = vtkGodRays::MediumHeight(lit.PlanetRadius, lit.Height, lit.Slope, s);
  const double slope = vtkGodRays::LightSlope(lit, height, s, r);
  air.Visible = air.Visible && !vtkGodRays::IsInPlanetShadow(lit, height, slope, r);
  for (int c = 0; c < (this->Grey ? 1 : 3) && air.Visible; ++c)
  {
    double depth = 0.0;
    for (const vtkGodRays::MediumComponent& component : this->Components[c])
    {
      if (component.Extinction > 0.0)
      {
        depth += vtkGodRays::LightDepth(component, lit, height, slope, r) +
          component.Extinction *
            vtkGodRays::MediumDepth(
              lit.PlanetRadius, lit.Height, lit.Slope, component.ScaleHeight, s);
        air.Scattered[c] += vtkGodRays::ScatteredPart(component, height, air.Cosine);
        if (this->Directional && component.ScaleHeight > 0.0 && lit.PlanetRadius == 0.0 &&
          slope <= 0.0)
        {
          depth = Infinity; // a plane hides what is below its horizon
        }
      }
    }
    air.Left[c] = std::exp(-depth);
  }
  if (this->Grey)
  {
    air.Scattered = Vec3(air.Scattered.x);
    air.Left = Vec3(air.Left.x);
  }
  return air;
}

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::vtkInternals::AddLightDepth(const Vec3& position, float* depth) const
{
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    float here[3] = { 0.0f, 0.0f, 0.0f };
    this->Lights[i].AddDepth(this->Grids[i], this->Grids[i].GetPlace(position), here);
    for (int c = 0; c < 3; ++c)
    {
      depth[c] += here[this->Grids[i].Bands == 1 ? 0 : c];
    }
  }
}

//------------------------------------------------------------------------------
// A part of the ray that is in data, block by block.
void vtkGodRaysGridPicture::vtkInternals::March(
  const Ray& ray, double begin, double end, Vec3& depth, Vec3& sum, std::size_t& steps)
{
  const int colours = this->Grey ? 1 : 3;
  const int count = static_cast<int>(this->Grids.size());
  double cell = end; // the shortest one
  for (int i = 0; i < count; ++i)
  {
    const Passage& passage = ray.Passages[i];
    cell = passage.Begin < passage.End ? std::min(cell, 1.0 / passage.Speed) : cell;
  }
  Vec3 edge(1.0);      // what surfaces leave of the light at s
  bool isNext = false; // it is that of the step before
  for (double s = begin; s < end;)
  {
    // How far everything is in one block, and into how many steps that is divided.
    double last = end;
    double parts = 1.0;
    double fastest = 0.0;
    bool empty = true;
    const double ahead = s + 1e-9 * (cell + s);
    const double left = std::exp(-std::min({ depth.x, depth.y, depth.z }));
    for (int i = 0; i < count; ++i)
    {
      const Passage& passage = ray.Passages[i];
      if (!(passage.Begin < passage.End))
      {
        continue;
      }
      fastest = std::max(fastest, passage.Speed);
      if (ahead < passage.Begin || ahead > passage.End)
      {
        last = ahead < passage.Begin ? std::min(last, passage.Begin) : last;
        continue;
      }
      double exit;
      const Vec2 range = this->AllBlocks[i].Get(
        passage.Place + ahead * passage.Steps, passage.Place, passage.Steps, ahead, exit);
      last = std::min({ last, std::max(exit, ahead), passage.End });
      if (range.y > 0.0)
      {
        const double length = Blocks::BlockSize / passage.Speed;
        const double change =
          (range.y - range.x + 0.5 * range.y * range.y * length) * length * left;
        parts = std::max(parts,
          std::clamp(std::sqrt(change / (4.0 * this->Tolerance)), 1.0, 2.0 * Blocks::BlockSize) *
            (last - s) / length);
        empty = false;
      }
    }
    if (empty && !this->Haze)
    {
      s = last;
      isNext = false;
      continue;
    }
    const double coarse = empty ? (last - s) * fastest / 4.0 : parts;
    const int number = static_cast<int>(std::clamp(std::ceil(coarse), 1.0, 512.0));
    const double step = (last - s) / number;
    edge = isNext ? edge : this->Shadows.Get(ray.Origin + s * ray.Along);
    isNext = true;
    Air air;
    for (int k = 0; k < number; ++k, ++steps)
    {
      const double middle = s + (k + 0.5) * step;
      const Vec3 position = ray.Origin + middle * ray.Along;
      Vec3 extinction(0.0);
      Vec3 scattered(0.0);
      if (k == 0 || !this->Directional)
      {
        air = this->GetAir(ray, this->Directional ? 0.5 * (s + last) : middle);
      }
      for (int i = 0; i < count && !empty; ++i)
      {
        const Passage& passage = ray.Passages[i];
        if (middle < passage.Begin || middle > passage.End)
        {
          continue;
        }
        const vtkGodRaysGrid& grid = this->Grids[i];
        const Place place(grid, passage.Place + middle * passage.Steps);
        const double phase =
          grid.Scale * vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, air.Cosine);
        for (int c = 0; c < colours; ++c)
        {
          const double value = place.Read(grid.Extinction, grid.Bands, grid.Bands == 1 ? 0 : c);
          extinction[c] += grid.Scale * value;
          scattered[c] += phase *
            (grid.ScatteringBands == 0 ? grid.Albedo[c] * value
                                       : place.Read(grid.Scattering, grid.ScatteringBands,
                                           grid.ScatteringBands == 1 ? 0 : c));
        }
      }
      float way[3] = { 0.0f, 0.0f, 0.0f };
      const Vec3 sunlit = this->Shadows.GetMean(
        ray.Origin, ray.Along, s + k * step, s + (k + 1) * step, 2.0 / fastest, edge);
      const bool lit = air.Visible && sunlit != Vec3(0.0);
      if (lit)
      {
        this->AddLightDepth(position, way);
      }
      for (int c = 0; c < colours; ++c)
      {
        const double thick = step * extinction[c];
        if (lit)
        {
          // Of the step: the mean of what is left on its way to the eye.
          const double arrives =
            std::exp(-depth[c] - way[c]) * vtkGodRays::MeanExponential(thick) * step;
          sum[c] += air.Strength * sunlit[c] * air.Left[c] *
            (scattered[c] * arrives + air.Scattered[c] * (arrives - step));
        }
        depth[c] += thick;
      }
    }
    if (this->Grey)
    {
      depth.y = depth.z = depth.x;
    }
    s = last;
    if (!this->Haze && left < 0.02 * this->Tolerance)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
// What data change of the medium's light in a part of the ray that is outside of them.
void vtkGodRaysGridPicture::vtkInternals::Cross(
  const Ray& ray, double begin, double end, const Vec3& depth, Vec3& sum, std::size_t& steps) const
{
  if (!(end > begin))
  {
    return;
  }
  double speed = 0.0;
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    speed = std::max(speed, ray.Passages[i].Speed);
  }
  const int parts = static_cast<int>(
    std::clamp(std::ceil((end - begin) * speed / 4.0), 1.0, static_cast<double>(8 * FarParts)));
  Vec3 edge(1.0);    // what surfaces leave of the light at the begin of a part
  int edgePart = -1; // of this one
  for (int k = 0; k < parts; ++k, ++steps)
  {
    const double from =
      vtkGodRays::MediumPlace(ray.Lit, begin, end, static_cast<double>(k) / parts);
    const double to = vtkGodRays::MediumPlace(ray.Lit, begin, end, (k + 1.0) / parts);
    const double middle = vtkGodRays::MediumPlace(ray.Lit, begin, end, (k + 0.5) / parts);
    const Vec3 position = ray.Origin + middle * ray.Along;
    float way[3] = { 0.0f, 0.0f, 0.0f };
    this->AddLightDepth(position, way);
    if (depth + Vec3(way[0], way[1], way[2]) == Vec3(0.0))
    {
      continue; // nothing is changed
    }
    const Air air = this->GetAir(ray, middle);
    if (!air.Visible)
    {
      continue;
    }
    edge = edgePart == k ? edge : this->Shadows.Get(ray.Origin + from * ray.Along);
    edgePart = k + 1;
    const Vec3 sunlit = this->Shadows.GetMean(ray.Origin, ray.Along, from, to, to - from, edge);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += (to - from) * air.Strength * sunlit[c] * air.Left[c] * air.Scattered[c] *
        std::expm1(-depth[c] - way[c]);
    }
  }
}

//------------------------------------------------------------------------------
Result vtkGodRaysGridPicture::vtkInternals::Evaluate(double x, double y, double depth)
{
  Ray ray;
  const Vec3 offset = x * this->Axes[0] + y * this->Axes[1];
  const Vec3 way = this->Parallel ? this->Axes[2] : this->Axes[2] + offset;
  const double perDepth = vtkGodRays::length(way);
  ray.Origin = this->Position + (this->Parallel ? offset : Vec3(0.0));
  ray.Along = way / perDepth;
  const Vec3 to = this->Directional ? this->Light : this->Light - ray.Origin;
  ray.Foot = vtkGodRays::dot(to, ray.Along);
  double end = perDepth * std::min(depth, this->Medium.FarLimit);
  const auto start = [&](const Vec3& place, const Vec3& toward)
  {
    return vtkGodRays::MediumStart(this->Medium.PlanetRadius, this->Medium.EyeHeight, this->Upwards,
      place - this->Position, toward);
  };
  const Vec2 begin = start(ray.Origin, ray.Along);
  ray.Lit = { this->Directional ? 1 : 0, ray.Foot, 0.0, begin.x, begin.y,
    this->Directional ? start(ray.Origin, this->Light).y : start(this->Light, this->Light).x,
    this->Medium.PlanetRadius, vtkGodRays::dot(this->SpotAxis, ray.Origin - this->Light),
    vtkGodRays::dot(this->SpotAxis, ray.Along), {} };
  this->Spot.SetShape(ray.Lit);
  end = vtkGodRays::MediumEnd(ray.Lit, end);
  if (!this->Directional)
  {
    ray.Lit.Distance = vtkGodRays::PointLightHeight(
      ray.Foot, vtkGodRays::length(to - ray.Foot * ray.Along), 0.0, end);
  }
  double first = end;
  double last = 0.0;
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    const vtkGodRaysGrid& grid = this->Grids[i];
    Passage& passage = ray.Passages[i];
    passage = { grid.GetPlace(ray.Origin), grid.GetSteps(ray.Along), 0.0, end, 0.0 };
    const Vec3 size = vtkGodRays::abs(passage.Steps);
    passage.Speed = std::max({ size.x, size.y, size.z, 1e-30 });
    if (!grid.Clip(passage.Place, passage.Steps, passage.Begin, passage.End))
    {
      passage.Begin = passage.End = 0.0;
      continue;
    }
    first = std::min(first, passage.Begin);
    last = std::max(last, passage.End);
  }
  std::size_t steps = 0;
  Vec3 sum(0.0);
  Vec3 thick(0.0);
  if (this->Haze)
  {
    this->Cross(ray, 0.0, first, thick, sum, steps);
  }
  if (last > first)
  {
    this->March(ray, first, last, thick, sum, steps);
  }
  if (this->Haze)
  {
    this->Cross(ray, std::max(first, last), end, thick, sum, steps);
  }
  this->Rays.fetch_add(1, std::memory_order_relaxed);
  this->Steps.fetch_add(steps, std::memory_order_relaxed);
  if (this->Grey)
  {
    sum = Vec3(sum.x);
  }
  return { sum * this->LightColor, vtkGodRays::exp(-thick) };
}

//------------------------------------------------------------------------------
vtkGodRaysGridPicture::vtkGodRaysGridPicture()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysGridPicture::~vtkGodRaysGridPicture() = default;

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::SetGrids(const std::vector<vtkGodRaysGrid>& grids, bool sameExtinction)
{
  vtkInternals& self = *this->Internals;
  const bool same = sameExtinction && self.Grids.size() == grids.size();
  self.Grids = grids;
  if (same)
  {
    return;
  }
  if (self.Grids.size() > MaximumGrids)
  {
    self.Grids.resize(MaximumGrids);
  }
  self.AllBlocks.clear();
  self.AllBlocks.reserve(self.Grids.size());
  for (const vtkGodRaysGrid& grid : self.Grids)
  {
    self.AllBlocks.emplace_back(grid);
  }
  self.LastLight[4] = 0.0;
}

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::SetShadows(const vtkGodRaysShadowGrids* shadows)
{
  this->Internals->Shadows.Set(shadows);
}

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::Draw(
  const vtkGodRaysSingleScattering::Parameters& parameters, const Picture& picture)
{
  vtkInternals& self = *this->Internals;
  self.SetUp(parameters);
  self.Rays = 0;
  self.Steps = 0;
  const int width = picture.Size[0];
  const int height = picture.Size[1];
  const auto getDepth = [&](int x, int y) -> double
  {
    const double depth =
      picture.Depths ? picture.Depths[static_cast<std::size_t>(y) * width + x] : Infinity;
    return depth > 0.0 ? depth : Infinity;
  };
  const auto evaluate = [&](int x, int y)
  {
    return self.Evaluate((x + 0.5 - picture.Center[0]) * picture.PixelSize,
      (y + 0.5 - picture.Center[1]) * picture.PixelSize, getDepth(x, y));
  };
  // The peak, of a few pixels.
  constexpr int looks = 24;
  std::vector<double> peaks(looks * looks, 0.0);
  vtkSMPTools::For(0, looks * looks, 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Result result = evaluate(static_cast<int>((i % looks + 0.5) / looks * width),
          static_cast<int>((i / looks + 0.5) / looks * height));
        peaks[i] = std::max({ std::abs(result.Radiance.x), std::abs(result.Radiance.y),
          std::abs(result.Radiance.z) });
      }
    });
  const double peak = *std::max_element(peaks.begin(), peaks.end());
  const double accepted = self.Tolerance;
  const double brightest = std::max(peak, 1e-300);

  const int tiles[2] = { (width + TileSize - 1) / TileSize, (height + TileSize - 1) / TileSize };
  const auto drawTile = [&](int left, int low)
  {
    constexpr int side = TileSize + 1;
    std::vector<Result> values(side * side);
    std::vector<char> known(side * side, 0);
    const int columns = std::min(TileSize, width - 1 - left);
    const int rows = std::min(TileSize, height - 1 - low);
    const auto get = [&](int x, int y) -> const Result&
    {
      const int i = y * side + x;
      if (known[i] != 1) // what is drawn is not yet evaluated
      {
        values[i] = evaluate(left + x, low + y);
        known[i] = 1;
      }
      return values[i];
    };
    const auto isFlat = [&](int x0, int y0, int x1, int y1)
    {
      // Depths end rays.
      if (picture.Depths)
      {
        const double corners[4] = { getDepth(left + x0, low + y0), getDepth(left + x1, low + y0),
          getDepth(left + x0, low + y1), getDepth(left + x1, low + y1) };
        for (int y = y0; y <= y1; ++y)
        {
          const double v = static_cast<double>(y - y0) / (y1 - y0);
          for (int x = x0; x <= x1; ++x)
          {
            const double u = static_cast<double>(x - x0) / (x1 - x0);
            const double depth = std::min(getDepth(left + x, low + y), self.Medium.FarLimit);
            double expected = 0.0;
            for (int i = 0; i < 4; ++i)
            {
              expected += (i % 2 ? u : 1.0 - u) * (i / 2 ? v : 1.0 - v) *
                std::min(corners[i], self.Medium.FarLimit);
            }
            if (std::abs(depth - expected) > 0.02 * expected)
            {
              return false;
            }
          }
        }
      }
      const Result& a = get(x0, y0);
      const Result& b = get(x1, y0);
      const Result& c = get(x0, y1);
      const Result& d = get(x1, y1);
      const Result& middle = get((x0 + x1) / 2, (y0 + y1) / 2);
      const double u = static_cast<double>((x0 + x1) / 2 - x0) / (x1 - x0);
      const double v = static_cast<double>((y0 + y1) / 2 - y0) / (y1 - y0);
      const auto mean = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s)
      { return (1.0 - v) * ((1.0 - u) * p + u * q) + v * ((1.0 - u) * r + u * s); };
      const Vec3 light =
        vtkGodRays::abs(middle.Radiance - mean(a.Radiance, b.Radiance, c.Radiance, d.Radiance));
      const Vec3 left3 = vtkGodRays::abs(middle.Transmittance -
        mean(a.Transmittance, b.Transmittance, c.Transmittance, d.Transmittance));
      if (!(std::max({ light.x, light.y, light.z }) <= accepted * brightest) ||
        !(std::max({ left3.x, left3.y, left3.z }) <= accepted))
      {
        return false;
      }
      // The middle may be the mean of the corners by chance: sides have middles, too.
      const auto differ = [&](const Result& p, const Result& q)
      {
        const Vec3 difference = vtkGodRays::abs(p.Radiance - q.Radiance);
        return std::max({ difference.x, difference.y, difference.z }) > accepted * brightest;
      };
      if (x1 - x0 < 2 || y1 - y0 < 2)
      {
        return true;
      }
      const auto between = [](const Result& p, const Result& q, double t) -> Result
      {
        return { (1.0 - t) * p.Radiance + t * q.Radiance,
          (1.0 - t) * p.Transmittance + t * q.Transmittance };
      };
      const int x = (x0 + x1) / 2;
      const int y = (y0 + y1) / 2;
      return !differ(get(x, y0), between(a, b, u)) && !differ(get(x, y1), between(c, d, u)) &&
        !differ(get(x0, y), between(a, c, v)) && !differ(get(x1, y), between(b, d, v));
    };
    struct Square
    {
      int X0, Y0, X1, Y1;
    };
    std::vector<Square> squares;
    for (int y = 0; y < std::max(rows, 1); y += FirstGap)
    {
      for (int x = 0; x < std::max(columns, 1); x += FirstGap)
      {
        squares.push_back({ x, y, std::min(x + FirstGap, columns), std::min(y + FirstGap, rows) });
      }
    }
    while (!squares.empty())
    {
      const Square square = squares.back();
      squares.pop_back();
      const int w = square.X1 - square.X0;
      const int h = square.Y1 - square.Y0;
      if (w <= 1 && h <= 1)
      {
        for (int i = 0; i < 4; ++i)
        {
          get(i % 2 ? square.X1 : square.X0, i / 2 ? square.Y1 : square.Y0);
        }
        continue;
      }
      if (w < 1 || h < 1 || !isFlat(square.X0, square.Y0, square.X1, square.Y1))
      {
        const int x = (square.X0 + square.X1) / 2;
        const int y = (square.Y0 + square.Y1) / 2;
        const int xs[3] = { square.X0, x, square.X1 };
        const int ys[3] = { square.Y0, y, square.Y1 };
        for (int j = 0; j < 2; ++j)
        {
          for (int i = 0; i < 2; ++i)
          {
            // A side of no length has no halves.
            if ((xs[i] < xs[i + 1] || (w < 1 && i == 0)) &&
              (ys[j] < ys[j + 1] || (h < 1 && j == 0)))
            {
              squares.push_back({ xs[i], ys[j], xs[i + 1], ys[j + 1] });
            }
          }
        }
        continue;
      }
      const Result corners[4] = { get(square.X0, square.Y0), get(square.X1, square.Y0),
        get(square.X0, square.Y1), get(square.X1, square.Y1) };
      for (int y = square.Y0; y <= square.Y1; ++y)
      {
        const double v = static_cast<double>(y - square.Y0) / h;
        for (int x = square.X0; x <= square.X1; ++x)
        {
          const int i = y * side + x;
          if (known[i])
          {
            continue;
          }
          const double u = static_cast<double>(x - square.X0) / w;
          const auto mean = [&](Vec3 Result::*part)
          {
            return (1.0 - v) * ((1.0 - u) * corners[0].*part + u * corners[1].*part) +
              v * ((1.0 - u) * corners[2].*part + u * corners[3].*part);
          };
          values[i] = { mean(&Result::Radiance), mean(&Result::Transmittance) };
          known[i] = 2; // drawn, but not evaluated
        }
      }
    }
    for (int y = 0; y < std::min(TileSize, height - low); ++y)
    {
      for (int x = 0; x < std::min(TileSize, width - left); ++x)
      {
        const std::size_t pixel = 3 * (static_cast<std::size_t>(low + y) * width + left + x);
        const Result& result = values[y * side + x];
        for (int c = 0; c < 3; ++c)
        {
          picture.Radiance[pixel + c] = static_cast<float>(result.Radiance[c]);
          picture.Transmittance[pixel + c] = static_cast<float>(result.Transmittance[c]);
        }
      }
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(tiles[0]) * tiles[1], 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        drawTile(
          static_cast<int>(i % tiles[0]) * TileSize, static_cast<int>(i / tiles[0]) * TileSize);
      }
    });
}

//------------------------------------------------------------------------------
void vtkGodRaysGridPicture::GetLightDepth(const double position[3], double depth[3]) const
{
  const vtkInternals& self = *this->Internals;
  std::fill_n(depth, 3, 0.0);
  for (std::size_t i = 0; i < self.Lights.size(); ++i)
  {
    float here[3] = { 0.0f, 0.0f, 0.0f };
    self.Lights[i].AddDepth(self.Grids[i], self.Grids[i].GetPlace(ToVector(position)), here);
    for (int c = 0; c < 3; ++c)
    {
      depth[c] += here[self.Grids[i].Bands == 1 ? 0 : c];
    }
  }
}

//------------------------------------------------------------------------------
std::size_t vtkGodRaysGridPicture::GetNumberOfRays() const
{
  return this->Internals->Rays;
}

//------------------------------------------------------------------------------
std::size_t vtkGodRaysGridPicture::GetNumberOfSteps() const
{
  return this->Internals->Steps;
}

//------------------------------------------------------------------------------
bool vtkGodRaysGridPicture::KeptLight() const
{
  return this->Internals->Kept;
}

//------------------------------------------------------------------------------
std::size_t vtkGodRaysGridPicture::GetLightSize() const
{
  std::size_t size = 0;
  for (const vtkGodRaysGridLight& light : this->Internals->Lights)
  {
    size += light.GetSize();
  }
  return size;
}
