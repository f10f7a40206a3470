// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Of vtkGodRaysGridSight: what of a view ray is in data, and between them.

#include "vtkGodRaysGridSight.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

constexpr double FourPi = 12.566370614359172;

using Blocks = vtkGodRaysGridBlocks;
}

// Into how many pieces, alike as a lamp sees them, a step falls.
int vtkGodRaysGridSight::CountPieces(const vtkGodRays::LitRay& lit, double begin, double end) const
{
  return this->Directional || !(begin < end)
    ? 1
    : static_cast<int>(1.0 +
        lit.Distance * vtkGodRays::PointAirlight(lit.Foot, lit.Distance, begin, end) /
          this->WidestPiece);
}

// What data leave of the light at a place.
vtkGodRays::Vec3 vtkGodRaysGridSight::GetArriving(const Vec3& position) const
{
  float way[3] = { 0.0f, 0.0f, 0.0f };
  this->AddLightDepth(position, way);
  return vtkGodRays::exp(-Vec3(way[0], way[1], way[2]));
}

// Adds the air's light of two and more scatterings along a part of the ray, behind a scaled depth of data.
void vtkGodRaysGridSight::AddDiffuseAir(
  const Ray& ray, double begin, double end, const Vec3& before, Way& way) const
{
  if (this->DiffuseAir && end > begin)
  {
    const Vec3 left = 0.5 * (vtkGodRays::exp(-before) + vtkGodRays::exp(-way.Scaled));
    way.Diffuse += left *
      (this->DiffuseAir->Get(ray.X, ray.Y, end / ray.PerDepth) -
        this->DiffuseAir->Get(ray.X, ray.Y, begin / ray.PerDepth));
  }
}

// Adds the light that data scatter again in a step about a place of the ray.
void vtkGodRaysGridSight::AddDiffuse(const Ray& ray, double s, double length,
  const Vec3& extinction, const Vec3& scattering, Way& way) const
{
  const Vec3 source = this->Diffuse->Sample(ray.Origin + s * ray.Along);
  const vtkGodRays::LitRay& lit = ray.Lit;
  for (int c = 0; c < 3; ++c)
  {
    const int band = this->Grey ? 0 : c;
    const double forward = this->Diffuse->ForwardPart;
    double air = 0.0;
    for (int k = 0; k < 2 && this->DiffuseAir; ++k)
    {
      const vtkGodRays::MediumComponent& part = this->Components[c][k];
      air += vtkGodRays::ScaledExtinction(part.Extinction, part.Scattering, forward) *
        vtkGodRays::MediumDepth(lit.PlanetRadius, lit.Height, lit.Slope, part.ScaleHeight, s);
    }
    const double thick =
      length * vtkGodRays::ScaledExtinction(extinction[band], scattering[band], forward);
    way.Diffuse[c] += source[c] * length * scattering[band] * std::exp(-way.Scaled[c] - air) *
      vtkGodRays::MeanExponential(thick);
    way.Scaled[c] += thick;
  }
}

// A part of the ray that is in data, block by block.
void vtkGodRaysGridSight::March(const Ray& ray, double begin, double end, Way& way) const
{
  const int count = static_cast<int>(this->Grids.size());
  double cell = end; // the shortest one
  for (int i = 0; i < count; ++i)
  {
    const Passage& passage = ray.Passages[i];
    cell = passage.Begin < passage.End ? std::min(cell, 1.0 / passage.Speed) : cell;
  }
  const Vec2 lit = vtkGodRays::SpotPart(ray.Lit, std::max(end, 0.0)); // in a spotlight's cone
  Front front;
  for (double s = begin; s < end;)
  {
    // How far everything is in one block, and into how many steps data divide that.
    double last = end;
    double parts = 1.0;
    double fastest = 0.0;
    double thickest = 0.0;
    bool outside = true;
    const double ahead = s + 1e-9 * (cell + s);
    const double left = std::exp(-std::min({ way.Depth.x, way.Depth.y, way.Depth.z }));
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
      outside = false;
      double exit;
      const Vec2 range = this->AllBlocks[i].Get(
        passage.Place + ahead * passage.Steps, passage.Place, passage.Steps, ahead, exit);
      last = std::min({ last, std::max(exit, ahead), passage.End });
      const double length = Blocks::BlockSize / passage.Speed;
      const double change = (range.y - range.x + 0.5 * range.y * range.y * length) * length * left;
      parts = std::max(parts,
        std::clamp(std::sqrt(change / (4.0 * this->Tolerance)), 1.0, 2.0 * Blocks::BlockSize) *
          (last - s) / length);
      thickest += range.y;
    }
    // A step is in the cone or not.
    bool isEdge = false;
    for (const double edge : { lit.x, lit.y })
    {
      if (this->Spot.IsCone() && edge > ahead && edge <= last)
      {
        last = edge;
        isEdge = true;
      }
    }
    const Vec3 before = way.Scaled;
    if (outside && this->Haze)
    {
      this->Cross(ray, s, last, way);
    }
    if (outside || (thickest == 0.0 && !this->Haze))
    {
      front.IsKnown = false;
    }
    else
    {
      const double cells = (last - s) * fastest;
      this->MarchBlock(ray, s, last, thickest > 0.0 ? parts : std::max(1.0, cells / 4.0), cells,
        thickest, front, way);
    }
    this->AddDiffuseAir(ray, s, last, before, way);
    front.IsKnown = front.IsKnown && !isEdge;
    s = last;
    if (!this->Haze && left < 0.02 * this->Tolerance)
    {
      return;
    }
  }
}

// A part of the ray in one block, in at least so many steps. There are more where light changes faster than
// data do: in haze, in the shadow of other data, and near a lamp, from which the steps then look alike.
void vtkGodRaysGridSight::MarchBlock(const Ray& ray, double begin, double end, double parts,
  double cells, double thickest, Front& front, Way& way) const
{
  const int colours = this->Grey ? 1 : 3;
  const vtkGodRays::LitRay& lit = ray.Lit;
  Vec3 position = ray.Origin + begin * ray.Along;
  const double inset = this->Spot.IsCone() ? 1e-6 * (end - begin) : 0.0; // edges are rounded
  if (!front.IsKnown)
  {
    front = { true, false, this->Shadows.Get(position), this->GetAir(ray, begin + inset),
      Vec3(1.0) };
  }
  Front next = { true, false, front.Edge, this->GetAir(ray, end - inset), Vec3(1.0) };
  const double most = 0.9 * std::sqrt(this->Tolerance); // in a step
  const double change = this->Haze ? front.Medium.GetChange(next.Medium) : 0.0;
  parts = std::max(parts, std::min(change / most, 8.0 * Blocks::BlockSize));
  const double left = std::exp(-std::min({ way.Depth.x, way.Depth.y, way.Depth.z }));
  const Vec3& haze = front.Medium.Scattered;
  const double thickness =
    (end - begin) * left * (thickest + FourPi * std::max({ haze.x, haze.y, haze.z }));
  next.HasArriving = thickness > this->Tolerance;
  if (next.HasArriving)
  {
    front.Arriving = front.HasArriving ? front.Arriving : this->GetArriving(position);
    next.Arriving = this->GetArriving(ray.Origin + end * ray.Along);
    const Vec3 jump = vtkGodRays::abs(next.Arriving - front.Arriving);
    const double wanted =
      thickness * std::max({ jump.x, jump.y, jump.z }) / (2.0 * this->Tolerance);
    parts = std::max(parts, std::min(wanted, cells));
  }
  const int number = static_cast<int>(std::clamp(std::ceil(parts - 1e-6), 1.0, 512.0));
  const bool isEven = this->Directional && change < most;
  Air air = front.Medium;
  air.Left = 0.5 * (front.Medium.Left + next.Medium.Left);
  air.Scattered = 0.5 * (front.Medium.Scattered + next.Medium.Scattered);
  double from = begin;
  int part = 0;   // of the steps into which data divide the block
  int piece = 0;  // of it, as a lamp sees them
  int pieces = 0; // how many there are
  for (; part < number; ++way.Steps)
  {
    const double first = begin + part * (end - begin) / number;
    const double last = part + 1 < number ? begin + (part + 1) * (end - begin) / number : end;
    if (piece == 0)
    {
      pieces = this->CountPieces(lit, first, last);
    }
    const auto find = [&](double t)
    {
      return pieces > 1 ? vtkGodRays::MediumPlace(lit, first, last, t / pieces)
                        : first + t * (last - first);
    };
    const double to = piece + 1 < pieces ? find(piece + 1.0) : last;
    const double middle = find(piece + 0.5);
    const double step = to - from;
    piece = (piece + 1) % pieces;
    part += piece == 0 ? 1 : 0;
    position = ray.Origin + middle * ray.Along;
    if (!isEven)
    {
      air = this->GetAir(ray, middle);
    }
    Vec3 extinction(0.0);
    Vec3 scattering(0.0); // into all directions, and into the view ray's
    Vec3 scattered(0.0);
    for (std::size_t i = 0; i < this->Grids.size() && thickest > 0.0; ++i)
    {
      const Passage& passage = ray.Passages[i];
      if (!(passage.Begin < passage.End) || middle < passage.Begin || middle > passage.End)
      {
        continue;
      }
      const vtkGodRaysGrid& grid = this->Grids[i];
      const vtkGodRaysGrid::Point point = grid.Sample(passage.Place + middle * passage.Steps);
      const double phase = this->Directional
        ? passage.Phase
        : vtkGodRays::Phase({ grid.PhaseFunction, grid.Asymmetry }, air.Cosine);
      extinction += point.Extinction;
      scattering += point.Scattering;
      scattered += phase * point.Scattering;
    }
    float light[3] = { 0.0f, 0.0f, 0.0f };
    const Vec3 sunlit = this->Shadows.GetMean(
      ray.Origin, ray.Along, from, to, 2.0 * (end - begin) / cells, next.Edge);
    const bool isLit = air.Visible && sunlit != Vec3(0.0);
    if (isLit)
    {
      this->AddLightDepth(position, light);
    }
    const double comes = air.Strength *
      (this->Directional ? step : vtkGodRays::PointAirlight(lit.Foot, lit.Distance, from, to));
    for (int c = 0; c < colours; ++c)
    {
      const double thick = step * extinction[c];
      if (isLit)
      {
        // Of the step: the mean of what is left on its way to the eye.
        const double arrives =
          std::exp(-way.Depth[c] - light[c]) * vtkGodRays::MeanExponential(thick);
        way.Light[c] += comes * sunlit[c] * air.Left[c] *
          (scattered[c] * arrives + air.Scattered[c] * (arrives - 1.0));
      }
      way.Depth[c] += thick;
    }
    if (this->Diffuse)
    {
      this->AddDiffuse(ray, middle, step, extinction, scattering, way);
    }
    from = to;
  }
  if (this->Grey)
  {
    way.Depth.y = way.Depth.z = way.Depth.x;
  }
  front = next;
}
