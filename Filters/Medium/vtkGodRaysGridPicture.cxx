// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridPicture.h"

#include "vtkGodRaysGridSight.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
using vtkGodRays::Vec3;
using Result = vtkGodRaysGridSight::Result;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr int TileSize = 64; // pixels
constexpr int FirstGap = 8;  // between pixels
}

class vtkGodRaysGridPicture::vtkInternals : public vtkGodRaysGridSight
{
};

vtkGodRaysGridPicture::vtkGodRaysGridPicture()
  : Internals(new vtkInternals)
{
}

vtkGodRaysGridPicture::~vtkGodRaysGridPicture() = default;

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
  self.Lights.clear();
  self.AllBlocks.reserve(self.Grids.size());
  for (const vtkGodRaysGrid& grid : self.Grids)
  {
    self.AllBlocks.emplace_back(grid);
  }
  self.LastLight[4] = 0.0;
}

void vtkGodRaysGridPicture::SetShadows(const vtkGodRaysShadowGrids* shadows)
{
  this->Internals->Shadows.Set(shadows);
}

void vtkGodRaysGridPicture::SetDiffuse(
  const vtkGodRaysFroxels* air, const vtkGodRaysFroxels::Source* data)
{
  this->Internals->DiffuseAir = air;
  this->Internals->Diffuse = data;
}

void vtkGodRaysGridPicture::Prepare(const vtkGodRaysSingleScattering::Parameters& parameters)
{
  this->Internals->SetUp(parameters);
}

void vtkGodRaysGridPicture::Draw(
  const vtkGodRaysSingleScattering::Parameters& parameters, const Picture& picture)
{
  vtkInternals& self = *this->Internals;
  self.SetUp(parameters);
  self.Rays = 0;
  self.Steps = 0;
  self.Brightest = 0.0;
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
  const double peak =
    std::min(*std::max_element(peaks.begin(), peaks.end()), // see vtkGodRaysInScattering
      10.0 * std::accumulate(peaks.begin(), peaks.end(), 0.0) / peaks.size());
  const double accepted = self.Tolerance * std::max(peak, 1e-300);
  const double color = std::max({ self.LightColor.x, self.LightColor.y, self.LightColor.z });
  self.Brightest = color > 0.0 ? peak / color : 0.0;

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
      if (!(std::max({ light.x, light.y, light.z }) <= accepted) ||
        !(std::max({ left3.x, left3.y, left3.z }) <= self.Tolerance))
      {
        return false;
      }
      // The middle may be the mean of the corners by chance: sides have middles, too.
      const auto differ = [&](const Result& p, const Result& q)
      {
        const Vec3 difference = vtkGodRays::abs(p.Radiance - q.Radiance);
        return std::max({ difference.x, difference.y, difference.z }) > accepted;
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

std::vector<const vtkGodRaysGridLight*> vtkGodRaysGridPicture::GetLights() const
{
  std::vector<const vtkGodRaysGridLight*> lights;
  for (const vtkGodRaysGridLight& light : this->Internals->Lights)
  {
    lights.push_back(&light);
  }
  return lights;
}

std::size_t vtkGodRaysGridPicture::GetNumberOfRays() const
{
  return this->Internals->Rays;
}

std::size_t vtkGodRaysGridPicture::GetNumberOfSteps() const
{
  return this->Internals->Steps;
}

bool vtkGodRaysGridPicture::KeptLight() const
{
  return this->Internals->Kept;
}

std::size_t vtkGodRaysGridPicture::GetKeptSize() const
{
  std::size_t size = 0;
  for (const vtkGodRaysGridLight& light : this->Internals->Lights)
  {
    size += light.GetSize();
  }
  for (const vtkGodRaysGridBlocks& blocks : this->Internals->AllBlocks)
  {
    size += blocks.GetSize();
  }
  return size;
}
