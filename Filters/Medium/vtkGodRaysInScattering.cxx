// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysInScattering.h"

#include "vtkGodRaysAirlight.h"
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysShadowLists.h"
#include "vtkGodRaysShadowPyramid.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace
{
using Place = vtkGodRaysShadowLists::Place;
using List = vtkGodRaysShadowLists::List;

constexpr int Levels = 3; // of grids above that of pixels
constexpr int Coarsest = 1 << Levels;
constexpr int MostPixels = Coarsest * Coarsest;
constexpr int MaximumPlanes = vtkGodRaysAirlight::MaximumPlanes;

// A cell is filled where its rays differ by no more than so many tolerances of a pixel: measured on the
// scenes of ModelError.
constexpr double CellTolerance = 3.0;
constexpr double MostOfMean = 10.0; // rays near a lamp are 1000 times as bright as the others

// Cells of one task.
constexpr int Cells = 32;

struct Grid
{
  int Spacing;
  int Size[2];
  std::vector<int> Index; // of the ray at a place of the grid; -1
};

int Divide(int number, int by)
{
  return (number + by - 1) / by;
}
}

class vtkGodRaysInScattering::vtkInternals
{
public:
  int Size[2] = { 0, 0 };
  std::vector<float> Depths;
  std::vector<float> Result;
  int NumberOfComponents = 0;
  vtkGodRaysAirlight Airlight;

  void Execute(const Parameters& parameters);
  int CountRays() const { return this->Lists.GetNumberOfLists(); }

private:
  void FindDepths();
  double FindReach(int level, int i, int j) const;
  void FindOwn();
  void FindOwn(int first, int row, int count);
  void WalkCoarsest();
  double FindLimit();
  void Refine();
  template <int Side>
  void FillCells(int level, double limit);
  template <int Side>
  bool FillCell(int level, const Place& cell, double limit);
  void PlaceRays(int level);
  void GetWeights(int x, int y, double* weights) const;
  bool IsAlongLight(double x, double y, double side) const;
  void Write();
  void Write(int first, int row, int count);
  int GetComponents(const Parameters& parameters) const;

  const float* GetOwn(int plane) const { return this->Own.data() + plane * this->Pixels; }

  // Which part of the light can come from a pixel's ray.
  float GetLight(int plane, std::size_t pixel) const
  {
    return this->Lights.empty() ? 1.0f : this->Lights[plane * this->Pixels + pixel];
  }

  double Color[3] = { 1.0, 1.0, 1.0 };
  int Planes = 1;
  std::size_t Pixels = 0;
  vtkGodRaysShadowPyramid Pyramid;
  std::vector<float> Greatest[Levels]; // depths of cells
  std::vector<float> Own;              // airlight of the pixels' rays: [plane][pixel]
  std::vector<float> Hidden;           // of it
  std::vector<float> Lights;           // see vtkGodRaysAirlight::Evaluate(); empty if they are 1
  Grid Grids[Levels + 1];
  vtkGodRaysShadowLists Lists{ this->Airlight, this->Pyramid };
  std::vector<Place> CellsLeft;
  std::vector<Place> NextCells;
  std::vector<unsigned char> Flags;
  std::vector<Place> Places;
  std::vector<float> Ends;
  std::vector<float> Brightness; // of the coarsest grid's rays
};

void vtkGodRaysInScattering::vtkInternals::Execute(const Parameters& parameters)
{
  vtkGodRaysAirlight::Scene scene;
  for (int i = 0; i < 2; ++i)
  {
    scene.Size[i] = this->Size[i];
    scene.Center[i] = parameters.Center[i] - 0.5;
  }
  scene.PixelSize = parameters.PixelSize;
  scene.Tolerance = parameters.Tolerance;
  scene.Parallel = parameters.Parallel;
  scene.Point = parameters.Light[3] != 0.0;
  const double norm = scene.Point
    ? parameters.Light[3]
    : std::hypot(parameters.Light[0], parameters.Light[1], parameters.Light[2]);
  for (int i = 0; i < 3; ++i)
  {
    scene.Light[i] = parameters.Light[i] / norm;
  }
  scene.Spot = parameters.Spot;
  scene.Medium = parameters.Medium;
  const vtkGodRaysShadowGrids* shadows = parameters.Shadows;
  const bool hasShadows = shadows && shadows->Levels > 0;
  scene.Colored = hasShadows && shadows->NumberOfLayers > 0 && shadows->Colored;
  this->Airlight.Prepare(scene);
  std::copy_n(parameters.LightColor, 3, this->Color);
  this->Planes = this->Airlight.GetNumberOfPlanes();
  this->Pixels = static_cast<std::size_t>(this->Size[0]) * this->Size[1];
  this->NumberOfComponents = scene.Colored ? 3 : this->GetComponents(parameters);
  this->Lists.Clear();
  this->FindOwn();
  this->Hidden.assign(this->Planes * this->Pixels, 0.0f);
  if (hasShadows)
  {
    this->Pyramid.Build(*shadows, scene.Light);
    this->Refine();
  }
  this->Write();
}

int vtkGodRaysInScattering::vtkInternals::GetComponents(const Parameters& parameters) const
{
  const auto isGrey = [](const double* color)
  { return color[0] == color[1] && color[1] == color[2]; };
  bool grey = isGrey(parameters.LightColor);
  for (int k = 0; k < parameters.Medium.NumberOfComponents; ++k)
  {
    const auto& component = parameters.Medium.Components[k];
    grey = grey && isGrey(component.Scattering) && isGrey(component.Absorption);
  }
  return grey ? 1 : 3;
}

// The airlight of each pixel's ray.
void vtkGodRaysInScattering::vtkInternals::FindOwn()
{
  this->Own.resize(this->Planes * this->Pixels);
  this->Lights.resize(this->Airlight.HasParts() ? this->Planes * this->Pixels : 0);
  vtkSMPTools::For(0, this->Size[1], 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int first = 0; first < this->Size[0]; first += MostPixels)
        {
          this->FindOwn(first, y, std::min(MostPixels, this->Size[0] - first));
        }
      }
    });
}

void vtkGodRaysInScattering::vtkInternals::FindOwn(int first, int row, int count)
{
  float x[MostPixels];
  float y[MostPixels];
  float distances[MostPixels];
  int pixels[MostPixels];
  float values[MaximumPlanes * MostPixels];
  float lights[MaximumPlanes * MostPixels];
  const std::size_t pixel = static_cast<std::size_t>(row) * this->Size[0] + first;
  const vtkGodRaysAirlightScene& scene = this->Airlight.GetScene();
  const float size = scene.Parallel ? 0.0f : static_cast<float>(scene.PixelSize);
  const float farLimit = static_cast<float>(scene.Medium.FarLimit);
  const float along = (static_cast<float>(row) - static_cast<float>(scene.Center[1])) * size;
  const bool hasLights = !this->Lights.empty();
  // A table's value is a fraction of the whole ray, which goes through a planet's ground.
  const bool isFraction =
    !hasLights && !this->Airlight.IsClosedForm() && !this->Airlight.IsOverPlanet();
  int number = 0;
  for (int i = 0; i < count; ++i)
  {
    const float depth = this->Depths[pixel + i];
    if (isFraction && depth >= farLimit)
    {
      continue;
    }
    pixels[number] = i;
    x[number] = static_cast<float>(first + i);
    y[number] = static_cast<float>(row);
    const float across = (x[number] - static_cast<float>(scene.Center[0])) * size;
    distances[number] =
      std::min(depth, farLimit) * std::sqrt(1.0f + across * across + along * along);
    if (this->Airlight.IsOverPlanet())
    {
      distances[number] =
        static_cast<float>(this->Airlight.GetEnd(first + i, row, distances[number]));
    }
    ++number;
  }
  this->Airlight.Evaluate(number, x, y, distances, values, hasLights ? lights : nullptr);
  for (int p = 0; p < this->Planes; ++p)
  {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(p) * number;
    float* const to = this->Own.data() + p * this->Pixels + pixel;
    std::fill_n(to, count, 1.0f);
    for (int i = 0; i < number; ++i)
    {
      to[pixels[i]] = values[from + i];
    }
    if (hasLights)
    {
      std::copy_n(lights + from, count, this->Lights.data() + p * this->Pixels + pixel);
    }
  }
}

// The greatest depths of cells, so that a ray is long enough for all pixels about it.
void vtkGodRaysInScattering::vtkInternals::FindDepths()
{
  for (int level = 1; level <= Levels; ++level)
  {
    const std::vector<float>& from = level > 1 ? this->Greatest[level - 2] : this->Depths;
    std::vector<float>& to = this->Greatest[level - 1];
    const int fromWidth = Divide(this->Size[0], 1 << (level - 1));
    const int fromHeight = Divide(this->Size[1], 1 << (level - 1));
    const int width = Divide(this->Size[0], 1 << level);
    const int height = Divide(this->Size[1], 1 << level);
    to.resize(static_cast<std::size_t>(width) * height);
    vtkSMPTools::For(0, height, 64,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int y = static_cast<int>(begin); y < end; ++y)
        {
          const float* rows[2] = { from.data() + static_cast<std::ptrdiff_t>(2) * y * fromWidth,
            from.data() +
              static_cast<std::ptrdiff_t>(std::min(2 * y + 1, fromHeight - 1)) * fromWidth };
          for (int x = 0; x < width; ++x)
          {
            const int next = std::min(2 * x + 1, fromWidth - 1);
            to[static_cast<std::size_t>(y) * width + x] = std::max(
              std::max(rows[0][2 * x], rows[0][next]), std::max(rows[1][2 * x], rows[1][next]));
          }
        }
      });
  }
}

// Of the cells about a place of a grid.
double vtkGodRaysInScattering::vtkInternals::FindReach(int level, int i, int j) const
{
  if (level == 0)
  {
    return this->Depths[static_cast<std::size_t>(j) * this->Size[0] + i];
  }
  const int width = Divide(this->Size[0], 1 << level);
  const int height = Divide(this->Size[1], 1 << level);
  float greatest = 0.0f;
  for (int y = std::max(j - 1, 0); y <= std::min(j, height - 1); ++y)
  {
    for (int x = std::max(i - 1, 0); x <= std::min(i, width - 1); ++x)
    {
      greatest =
        std::max(greatest, this->Greatest[level - 1][static_cast<std::size_t>(y) * width + x]);
    }
  }
  return greatest;
}

// Of the brightest colour that a plane adds to.
void vtkGodRaysInScattering::vtkInternals::GetWeights(int x, int y, double* weights) const
{
  float factors[6];
  this->Airlight.GetFactors(y, x, 1, factors);
  const int channels = this->Airlight.GetNumberOfChannels();
  for (int p = 0; p < this->Planes; ++p)
  {
    const float* factor = factors + 3 * (p / channels);
    weights[p] = channels == 3 ? this->Color[p % 3] * factor[p % 3]
                               : std::max({ this->Color[0] * factor[0], this->Color[1] * factor[1],
                                   this->Color[2] * factor[2] });
  }
}

// Whether a ray hardly crosses the light's rays, so that it tells little of those beside it: where the light,
// or its opposite, is seen within two cells; of parallel rays, where they end within two cells of where they
// begin.
bool vtkGodRaysInScattering::vtkInternals::IsAlongLight(double x, double y, double side) const
{
  double origin[3];
  double direction[3];
  const vtkGodRaysAirlightScene& scene = this->Airlight.GetScene();
  scene.GetRay(x, y, origin, direction);
  double to[3];
  double square = 0.0;
  double along = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    to[i] = scene.Light[i] - (scene.Point ? origin[i] : 0.0);
    square += to[i] * to[i];
    along += to[i] * direction[i];
  }
  // Squares of the sine of the angle between ray and light, or of the distance between them.
  const double across = std::max(square - along * along, 0.0);
  const double cells = 2.0 * side * scene.PixelSize;
  if (!scene.Parallel)
  {
    return across < square * cells * cells * direction[2] * direction[2];
  }
  const double farLimit = scene.Medium.FarLimit;
  return across * (scene.Point ? 1.0 : farLimit * farLimit) < cells * cells;
}

void vtkGodRaysInScattering::vtkInternals::WalkCoarsest()
{
  this->Places.clear();
  this->Ends.clear();
  this->CellsLeft.clear();
  Grid& grid = this->Grids[Levels];
  for (int j = 0; j < grid.Size[1]; ++j)
  {
    for (int i = 0; i < grid.Size[0]; ++i)
    {
      grid.Index[static_cast<std::size_t>(j) * grid.Size[0] + i] =
        static_cast<int>(this->Places.size());
      this->Places.push_back({ i * Coarsest, j * Coarsest });
      this->Ends.push_back(static_cast<float>(this->FindReach(Levels, i, j)));
      if (i + 1 < grid.Size[0] && j + 1 < grid.Size[1])
      {
        this->CellsLeft.push_back({ i, j });
      }
    }
  }
  this->Lists.Walk(this->Places, this->Ends);
}

// The tolerance counts the brightest ray of the coarsest grid but for 1 in 1000, or MostOfMean of their mean.
double vtkGodRaysInScattering::vtkInternals::FindLimit()
{
  const Grid& grid = this->Grids[Levels];
  std::vector<float>& bright = this->Brightness;
  bright.clear();
  for (int j = 0; j < grid.Size[1]; ++j)
  {
    for (int i = 0; i < grid.Size[0]; ++i)
    {
      const int x = std::min(i * Coarsest, this->Size[0] - 1);
      const int y = std::min(j * Coarsest, this->Size[1] - 1);
      const std::size_t pixel = static_cast<std::size_t>(y) * this->Size[0] + x;
      float own[MaximumPlanes];
      float hidden[MaximumPlanes];
      for (int p = 0; p < this->Planes; ++p)
      {
        own[p] = this->GetOwn(p)[pixel];
      }
      const int index = grid.Index[static_cast<std::size_t>(j) * grid.Size[0] + i];
      this->Lists.GetHidden<1>(this->Lists.Get(index), own, hidden);
      double weights[MaximumPlanes];
      this->GetWeights(x, y, weights);
      double sum = 0.0;
      for (int p = 0; p < this->Planes; ++p)
      {
        sum = std::max(sum, (own[p] - hidden[p]) * weights[p] * this->GetLight(p, pixel));
      }
      bright.push_back(static_cast<float>(sum));
    }
  }
  const auto rank = bright.begin() + static_cast<std::ptrdiff_t>(0.999 * (bright.size() - 1));
  std::nth_element(bright.begin(), rank, bright.end());
  double most = MostOfMean * std::accumulate(bright.begin(), bright.end(), 0.0) / bright.size();
  return CellTolerance * this->Airlight.GetScene().Tolerance * std::min<double>(*rank, most);
}

template <int Side>
bool vtkGodRaysInScattering::vtkInternals::FillCell(int level, const Place& cell, double limit)
{
  constexpr int count = Side * Side;
  if (this->IsAlongLight((cell.X + 0.5) * Side, (cell.Y + 0.5) * Side, Side))
  {
    return false;
  }
  const Grid& grid = this->Grids[level];
  const List* lists[4];
  const List* lit = nullptr;
  bool unlit = false;
  int stretches = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::size_t at =
      static_cast<std::size_t>(cell.Y + corner / 2) * grid.Size[0] + cell.X + corner % 2;
    lists[corner] = &this->Lists.Get(grid.Index[at]);
    unlit = unlit || lists[corner]->Count < 0;
    lit = lists[corner]->Count < 0 ? lit : lists[corner];
    stretches += std::max(lists[corner]->Count, 0);
  }
  if (stretches == 0 && !unlit)
  {
    return true; // and nothing is hidden
  }
  const int planes = this->Planes;
  const int x0 = cell.X * Side;
  const int y0 = cell.Y * Side;
  float own[MaximumPlanes * count];
  float lights[MaximumPlanes * count];
  for (int p = 0; p < planes; ++p)
  {
    for (int i = 0; i < count; ++i)
    {
      const int x = std::min(x0 + i % Side, this->Size[0] - 1);
      const int y = std::min(y0 + i / Side, this->Size[1] - 1);
      const std::size_t pixel = static_cast<std::size_t>(y) * this->Size[0] + x;
      own[p * count + i] = this->GetOwn(p)[pixel];
      lights[p * count + i] = this->GetLight(p, pixel);
    }
  }
  double weights[MaximumPlanes];
  this->GetWeights(x0 + Side / 2, y0 + Side / 2, weights);
  if (unlit)
  {
    // Rays without light tell nothing of those beside them.
    for (int p = 0; p < planes; ++p)
    {
      float most = 0.0f;
      for (int i = p * count; i < (p + 1) * count; ++i)
      {
        most = std::max(most, own[i] * lights[i]);
      }
      if (most * weights[p] > limit)
      {
        return false;
      }
    }
    if (!lit)
    {
      return true;
    }
    for (const List*& list : lists)
    {
      list = list->Count < 0 ? lit : list;
    }
  }
  float hidden[4][MaximumPlanes * count];
  for (int corner = 0; corner < 4; ++corner)
  {
    this->Lists.GetHidden<count>(*lists[corner], own, hidden[corner]);
  }
  for (int p = 0; p < planes; ++p)
  {
    float most = 0.0f;
    const float* const corners[4] = { hidden[0] + p * count, hidden[1] + p * count,
      hidden[2] + p * count, hidden[3] + p * count };
    for (int i = 0; i < count; ++i)
    {
      const float low =
        std::min(std::min(corners[0][i], corners[1][i]), std::min(corners[2][i], corners[3][i]));
      const float high =
        std::max(std::max(corners[0][i], corners[1][i]), std::max(corners[2][i], corners[3][i]));
      most = std::max(most, (high - low) * lights[p * count + i]);
    }
    if (most * weights[p] > limit)
    {
      return false;
    }
  }
  for (int p = 0; p < planes; ++p)
  {
    float* to = this->Hidden.data() + p * this->Pixels;
    for (int i = 0; i < count; ++i)
    {
      const int x = x0 + i % Side;
      const int y = y0 + i / Side;
      if (x < this->Size[0] && y < this->Size[1])
      {
        const float u = static_cast<float>(x - x0) / Side;
        const float v = static_cast<float>(y - y0) / Side;
        const int at = p * count + i;
        const float low = hidden[0][at] + u * (hidden[1][at] - hidden[0][at]);
        const float high = hidden[2][at] + u * (hidden[3][at] - hidden[2][at]);
        to[static_cast<std::size_t>(y) * this->Size[0] + x] = low + v * (high - low);
      }
    }
  }
  return true;
}

// Those of the cells that are too uneven become the next cells.
template <int Side>
void vtkGodRaysInScattering::vtkInternals::FillCells(int level, double limit)
{
  this->Flags.resize(this->CellsLeft.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->CellsLeft.size()), Cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Flags[i] = this->FillCell<Side>(level, this->CellsLeft[i], limit) ? 0 : 1;
      }
    });
  this->NextCells.clear();
  for (std::size_t i = 0; i < this->CellsLeft.size(); ++i)
  {
    if (this->Flags[i])
    {
      this->NextCells.push_back(this->CellsLeft[i]);
    }
  }
}

// Walks the rays of the next finer grid that uneven cells need.
void vtkGodRaysInScattering::vtkInternals::PlaceRays(int level)
{
  const Grid& coarse = this->Grids[level];
  Grid& fine = this->Grids[level - 1];
  this->Places.clear();
  this->Ends.clear();
  this->CellsLeft.clear();
  int next = this->Lists.GetNumberOfLists();
  for (const Place& cell : this->NextCells)
  {
    const int side = level > 1 ? 3 : 2; // corners, or pixels
    for (int k = 0; k < side * side; ++k)
    {
      const int i = 2 * cell.X + k % side;
      const int j = 2 * cell.Y + k / side;
      int& index = fine.Index[static_cast<std::size_t>(j) * fine.Size[0] + i];
      if (index >= 0)
      {
        continue;
      }
      if (i % 2 == 0 && j % 2 == 0)
      {
        index = coarse.Index[static_cast<std::size_t>(j / 2) * coarse.Size[0] + i / 2];
        continue;
      }
      if (level == 1 && (i >= this->Size[0] || j >= this->Size[1]))
      {
        continue;
      }
      index = next++;
      this->Places.push_back({ i * fine.Spacing, j * fine.Spacing });
      this->Ends.push_back(static_cast<float>(this->FindReach(level - 1, i, j)));
    }
    for (int k = 0; k < 4; ++k)
    {
      const Place finer = { 2 * cell.X + k % 2, 2 * cell.Y + k / 2 };
      if (finer.X * fine.Spacing < this->Size[0] && finer.Y * fine.Spacing < this->Size[1])
      {
        this->CellsLeft.push_back(finer);
      }
    }
  }
  this->Lists.Walk(this->Places, this->Ends);
}

void vtkGodRaysInScattering::vtkInternals::Refine()
{
  this->FindDepths();
  for (int level = 0; level <= Levels; ++level)
  {
    Grid& grid = this->Grids[level];
    grid.Spacing = 1 << level;
    for (int i = 0; i < 2; ++i)
    {
      // Cells of each level lie within those of the one above.
      grid.Size[i] = Divide(this->Size[i], Coarsest) * (Coarsest >> level) + 1;
    }
    grid.Index.assign(static_cast<std::size_t>(grid.Size[0]) * grid.Size[1], -1);
  }
  this->WalkCoarsest();
  const double limit = this->FindLimit();
  for (int level = Levels; level > 0; --level)
  {
    if (level == 3)
    {
      this->FillCells<8>(level, limit);
    }
    else if (level == 2)
    {
      this->FillCells<4>(level, limit);
    }
    else
    {
      this->FillCells<2>(level, limit);
    }
    this->PlaceRays(level);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->CellsLeft.size()), Cells * 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Place& pixel = this->CellsLeft[i];
        const std::size_t at = static_cast<std::size_t>(pixel.Y) * this->Size[0] + pixel.X;
        float own[MaximumPlanes];
        float hidden[MaximumPlanes] = {};
        for (int p = 0; p < this->Planes; ++p)
        {
          own[p] = this->GetOwn(p)[at];
        }
        const Grid& grid = this->Grids[0];
        const int index = grid.Index[static_cast<std::size_t>(pixel.Y) * grid.Size[0] + pixel.X];
        this->Lists.GetHidden<1>(this->Lists.Get(index), own, hidden);
        for (int p = 0; p < this->Planes; ++p)
        {
          this->Hidden[p * this->Pixels + at] = hidden[p];
        }
      }
    });
}

void vtkGodRaysInScattering::vtkInternals::Write()
{
  this->Result.resize(this->Pixels * this->NumberOfComponents);
  vtkSMPTools::For(0, this->Size[1], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int first = 0; first < this->Size[0]; first += MostPixels)
        {
          this->Write(first, y, std::min(MostPixels, this->Size[0] - first));
        }
      }
    });
}

void vtkGodRaysInScattering::vtkInternals::Write(int first, int row, int count)
{
  const int components = this->NumberOfComponents;
  const int channels = this->Airlight.GetNumberOfChannels();
  const std::size_t pixel = static_cast<std::size_t>(row) * this->Size[0] + first;
  float factors[6 * MostPixels];
  this->Airlight.GetFactors(row, first, count, factors);
  for (int c = 0; c < components; ++c)
  {
    const float color = static_cast<float>(std::min(this->Color[c], 1e30));
    float sums[MostPixels] = {};
    for (int k = 0; k < this->Airlight.GetNumberOfComponents(); ++k)
    {
      const int p = k * channels + (channels == 3 ? c : 0);
      const float* factor = factors + static_cast<std::ptrdiff_t>(3 * k + c) * count;
      const float* hidden = this->Hidden.data() + p * this->Pixels + pixel;
      const float* own = this->GetOwn(p) + pixel;
      const float* lights =
        this->Lights.empty() ? nullptr : this->Lights.data() + p * this->Pixels + pixel;
      for (int i = 0; i < count; ++i)
      {
        sums[i] += factor[i] * (lights ? lights[i] : 1.0f) * std::max(own[i] - hidden[i], 0.0f);
      }
    }
    float* to = this->Result.data() + pixel * components + c;
    for (int i = 0; i < count; ++i)
    {
      to[static_cast<std::ptrdiff_t>(i) * components] =
        std::min(std::max(color * sums[i], 0.0f), 3e38f);
    }
  }
}

vtkGodRaysInScattering::vtkGodRaysInScattering()
  : Internals(new vtkInternals)
{
}

vtkGodRaysInScattering::~vtkGodRaysInScattering() = default;

float* vtkGodRaysInScattering::PrepareInput(int width, int height)
{
  vtkInternals& self = *this->Internals;
  self.Size[0] = width;
  self.Size[1] = height;
  self.Depths.resize(static_cast<std::size_t>(width) * height);
  return self.Depths.data();
}

bool vtkGodRaysInScattering::Execute(const Parameters& parameters)
{
  const bool hasInput = !this->Internals->Depths.empty();
  if (hasInput)
  {
    this->Internals->Execute(parameters);
  }
  return hasInput;
}

double vtkGodRaysInScattering::GetWalkedPart() const
{
  const vtkInternals& self = *this->Internals;
  const double pixels = std::max(1.0, static_cast<double>(self.Size[0]) * self.Size[1]);
  return self.CountRays() / pixels;
}

int vtkGodRaysInScattering::GetNumberOfComponents() const
{
  return this->Internals->NumberOfComponents;
}

const float* vtkGodRaysInScattering::GetResult() const
{
  return this->Internals->Result.empty() ? nullptr : this->Internals->Result.data();
}

std::string vtkGodRaysInScattering::Describe() const
{
  if (!this->GetResult())
  {
    return "nothing yet";
  }
  const int part = static_cast<int>(std::lround(100.0 * this->GetWalkedPart()));
  return std::to_string(part) + " % of the view rays walked, " +
    this->Internals->Airlight.Describe();
}
