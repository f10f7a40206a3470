// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridPicture.h"

#include "vtkGodRaysGridMarch.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
using vtkGodRays::Vec3;
using Result = vtkGodRaysGridMarch::Result;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr int TileSize = 64; // pixels
constexpr int FirstGap = 8;  // between pixels

struct Square // of pixels
{
  int X0, Y0, X1, Y1;

  /// The bilinear mean at a pixel of values at the corners, x fastest.
  template <typename T>
  T GetMean(const T* corners, int x, int y) const
  {
    const double u = static_cast<double>(x - this->X0) / std::max(this->X1 - this->X0, 1);
    const double v = static_cast<double>(y - this->Y0) / std::max(this->Y1 - this->Y0, 1);
    return (1.0 - v) * ((1.0 - u) * corners[0] + u * corners[1]) +
      v * ((1.0 - u) * corners[2] + u * corners[3]);
  }
};

double GetDifference(const Vec3& a, const Vec3& b)
{
  const Vec3 difference = vtkGodRays::abs(a - b);
  return std::max({ difference.x, difference.y, difference.z });
}
}

class vtkGodRaysGridPicture::vtkInternals : public vtkGodRaysGridMarch
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
  this->Internals->Shadows = shadows;
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
    return std::min(depth > 0.0 ? depth : Infinity, self.Medium.FarLimit);
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
    const auto getCorners = [&](const Square& square, Vec3* light, Vec3* left3)
    {
      for (int i = 0; i < 4; ++i)
      {
        const Result& corner = get(i % 2 ? square.X1 : square.X0, i / 2 ? square.Y1 : square.Y0);
        light[i] = corner.Radiance;
        left3[i] = corner.Transmittance;
      }
    };
    // Returns whether depths, which end rays, and light are the means of the corners: in the middle, which
    // may be so by chance, and in the middles of sides.
    const auto isFlat = [&](const Square& square)
    {
      double depths[4];
      for (int i = 0; i < 4; ++i)
      {
        depths[i] =
          getDepth(left + (i % 2 ? square.X1 : square.X0), low + (i / 2 ? square.Y1 : square.Y0));
      }
      for (int y = square.Y0; y <= square.Y1 && picture.Depths; ++y)
      {
        for (int x = square.X0; x <= square.X1; ++x)
        {
          const double expected = square.GetMean(depths, x, y);
          if (std::abs(getDepth(left + x, low + y) - expected) > 0.02 * expected)
          {
            return false;
          }
        }
      }
      Vec3 light[4];
      Vec3 left3[4];
      getCorners(square, light, left3);
      const int x = (square.X0 + square.X1) / 2;
      const int y = (square.Y0 + square.Y1) / 2;
      const int places[5][2] = { { x, y }, { x, square.Y0 }, { x, square.Y1 }, { square.X0, y },
        { square.X1, y } };
      return std::all_of(places, places + 5,
        [&](const int* at)
        {
          const Result& result = get(at[0], at[1]);
          return GetDifference(result.Radiance, square.GetMean(light, at[0], at[1])) <= accepted &&
            GetDifference(result.Transmittance, square.GetMean(left3, at[0], at[1])) <=
            self.Tolerance;
        });
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
      const bool isPixels = square.X1 - square.X0 <= 1 && square.Y1 - square.Y0 <= 1;
      if (!isPixels && !isFlat(square))
      {
        const int xs[3] = { square.X0, (square.X0 + square.X1) / 2, square.X1 };
        const int ys[3] = { square.Y0, (square.Y0 + square.Y1) / 2, square.Y1 };
        for (int k = 0; k < 4; ++k)
        {
          const int i = k % 2;
          const int j = k / 2;
          // A side of no length has no halves.
          if ((xs[i] < xs[i + 1] || (xs[0] == xs[2] && i == 0)) &&
            (ys[j] < ys[j + 1] || (ys[0] == ys[2] && j == 0)))
          {
            squares.push_back({ xs[i], ys[j], xs[i + 1], ys[j + 1] });
          }
        }
        continue;
      }
      Vec3 light[4];
      Vec3 left3[4];
      getCorners(square, light, left3);
      for (int y = square.Y0; y <= square.Y1; ++y)
      {
        for (int x = square.X0; x <= square.X1; ++x)
        {
          const int i = y * side + x;
          if (!known[i])
          {
            values[i] = { square.GetMean(light, x, y), square.GetMean(left3, x, y) };
            known[i] = 2; // drawn, but not evaluated
          }
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
