// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSunPlacer.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

vtkStandardNewMacro(vtkGodRaysSunPlacer);

namespace
{
const double UsualPlace[2] = { 0.35, 0.75 };

/// Where a place of the picture is on the near and the far plane, in homogeneous world coordinates.
bool GetSight(vtkCamera* camera, double aspect, double x, double y, double ends[2][4])
{
  if (!(aspect > 0.0))
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0), toWorld);
  for (int i = 0; i < 2; ++i)
  {
    const double point[4] = { 2.0 * x - 1.0, 2.0 * y - 1.0, i == 0 ? -1.0 : 1.0, 1.0 };
    toWorld->MultiplyPoint(point, ends[i]);
  }
  return ends[0][3] != 0.0;
}

double GetAspect(vtkRenderer* renderer)
{
  const double aspect = renderer->GetTiledAspectRatio();
  return std::isfinite(aspect) && aspect > 0.0 ? aspect : 1.0;
}

/**
 * The corners in the picture of the base of the box of a renderer's visible props, one after the other around
 * it, if that box is flat and seen from above. Returns whether it is.
 */
bool FindBase(vtkRenderer* renderer, double corners[4][2])
{
  constexpr double flat = 0.35; // of the shorter side of the base: higher boxes are no landscapes
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  if (!box.IsValid())
  {
    return false;
  }
  double lengths[3];
  box.GetLengths(lengths);
  const int up = static_cast<int>(std::min_element(lengths, lengths + 3) - lengths);
  const int across[2] = { (up + 1) % 3, (up + 2) % 3 };
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* viewUp = camera->GetViewUp();
  const double sign = viewUp[up] < 0.0 ? -1.0 : 1.0;
  if (!(lengths[up] < flat * std::min(lengths[across[0]], lengths[across[1]])) ||
    std::abs(viewUp[up]) < 0.3 || sign * camera->GetDirectionOfProjection()[up] >= 0.0)
  {
    return false;
  }
  vtkMatrix4x4* toClip =
    camera->GetCompositeProjectionTransformMatrix(GetAspect(renderer), -1.0, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    double corner[4] = { 0.0, 0.0, 0.0, 1.0 };
    corner[up] = bounds[2 * up + (sign > 0.0 ? 0 : 1)];
    corner[across[0]] = bounds[2 * across[0] + (i == 1 || i == 2 ? 1 : 0)];
    corner[across[1]] = bounds[2 * across[1] + i / 2];
    toClip->MultiplyPoint(corner, corner);
    if (!(corner[3] > 0.0))
    {
      return false; // the camera stands on it
    }
    for (int j = 0; j < 2; ++j)
    {
      corners[i][j] = 0.5 + 0.5 * corner[j] / corner[3];
    }
  }
  return true;
}
}

/**
 * Coverage on a padded grid, and the rays of a light at any cell of it. Lengths are heights of the picture
 * where nothing else is said. The numbers were chosen with 12 data sets by eye, and the score agrees with the
 * eye in 10 of them; the root mean square of the contrast does so in 5.
 */
struct vtkGodRaysSunPlacer::Internals
{
  struct Place
  {
    int Column = 0;
    int Row = 0;
    double Score = 0.0;
    double Shafts = 0.0;   // how many, on average over the rings
    double Openness = 0.0; // mean part of the free light
  };

  static constexpr int Directions = 160;
  static constexpr double Outside = 2.0;   // a cell outside the picture: open
  static constexpr double Farthest = 0.08; // of places outside the picture
  static constexpr double RingEnds[4] = { 0.14, 0.3, 0.5, 0.8 };
  static constexpr double GlowRadius = 0.025; // as the pass has it for a view of 30 degrees
  static constexpr double GlowEnd = 0.145;
  static constexpr double Threshold = 3.0; // [L*] of a maximum that counts
  static constexpr double Clear = 8.0;
  static constexpr double MostProminence = 25.0;
  static constexpr double OverData = 0.6; // weight and light of rays over data

  int Columns = 0;
  int Rows = 0;
  int Pad = 0;
  int Stride = 0;
  int Steps = 0;
  int GlowSteps = 0;              // beyond them, the light of a direction stays
  std::array<int, 4> RingSteps{}; // the first at or beyond each of RingEnds
  double MiddleY = 0.5;           // of what is covered
  double CoveredHeight = 1.0;
  std::vector<float> Open;             // part of a cell that is open, or Outside
  std::vector<std::ptrdiff_t> Offsets; // of the cells along each direction
  std::vector<float> Glow;             // by step: of the light, divided by its sum so far in Free
  std::vector<float> Free;
  std::vector<float> Shown; // by step: (L* + 16) of free light
  std::array<float, 257>
    Power; // P^0.4: the cube root of lightness and the exponent 1.2 of partly free light

  void Set(const float* coverage, int columns, int rows)
  {
    this->Rows = rows;
    this->Columns = columns;
    this->Steps = static_cast<int>(std::ceil(RingEnds[3] * rows));
    this->Pad = this->Steps + static_cast<int>(std::ceil(Farthest * std::max(rows, columns))) + 2;
    this->Stride = columns + 2 * this->Pad;
    this->Open.assign(
      static_cast<std::size_t>(this->Stride) * (rows + 2 * this->Pad), static_cast<float>(Outside));
    for (int y = 0; y < rows; ++y)
    {
      for (int x = 0; x < columns; ++x)
      {
        const float covered = coverage[static_cast<std::size_t>(y) * columns + x];
        this->Open[this->Index(x, y)] = 1.0f - std::clamp(covered, 0.0f, 1.0f);
      }
    }
    this->Offsets.resize(static_cast<std::size_t>(Directions) * this->Steps);
    for (int i = 0; i < Directions; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / Directions;
      for (int j = 0; j < this->Steps; ++j)
      {
        this->Offsets[static_cast<std::size_t>(i) * this->Steps + j] =
          std::lround((j + 0.5) * std::cos(angle)) +
          static_cast<std::ptrdiff_t>(this->Stride) * std::lround((j + 0.5) * std::sin(angle));
      }
    }
    this->Glow.resize(this->Steps);
    this->Free.resize(this->Steps);
    this->Shown.resize(this->Steps);
    const auto firstFrom = [&](double end)
    { return std::min(static_cast<int>(std::ceil(end * rows - 0.5)), this->Steps); };
    this->GlowSteps = firstFrom(GlowEnd);
    std::transform(std::begin(RingEnds), std::end(RingEnds), this->RingSteps.begin(), firstFrom);
    const auto mean = [](double r, double sum) { return sum / r; };
    double sum = 0.0;
    double scale = 0.0;
    for (int pass = 0; pass < 2; ++pass) // the first finds the mean of the glow at 0.12
    {
      sum = 0.0;
      for (int j = 0; j < this->Steps; ++j)
      {
        const double r = (j + 0.5) / rows;
        const double t = std::clamp((r - GlowRadius) / (GlowEnd - GlowRadius), 0.0, 1.0);
        const double glow = 1.0 - t * t * (3.0 - 2.0 * t);
        sum += glow / rows;
        this->Glow[j] = static_cast<float>(glow / rows);
        this->Free[j] = static_cast<float>(sum);
        if (pass == 0 && r <= 0.12)
        {
          scale = 0.5 / mean(r, sum);
        }
        const double light = scale * mean(r, sum) * std::exp(-r / 0.9);
        this->Shown[j] = static_cast<float>(116.0 * std::cbrt(light));
      }
    }
    for (std::size_t i = 0; i < this->Power.size(); ++i)
    {
      this->Power[i] = static_cast<float>(std::pow(i / 256.0, 0.4));
    }
  }

  std::size_t Index(int x, int y) const
  {
    return static_cast<std::size_t>(y + this->Pad) * this->Stride + x + this->Pad;
  }

  Place At(double x, double y) const
  {
    const auto cell = [](double part, int count)
    {
      const double margin = Farthest * count;
      return static_cast<int>(std::floor(std::clamp(part * count, -margin, count - 1 + margin)));
    };
    Place place;
    place.Column = cell(x, this->Columns);
    place.Row = cell(y, this->Rows);
    return place;
  }

  /// Sums and counts the prominences of the maxima of a closed profile that stand out by Threshold on both
  /// sides. Those below Clear count in part.
  static double SumProminences(const std::vector<float>& profile, double& count)
  {
    if (profile.empty())
    {
      return 0.0;
    }
    const std::size_t size = profile.size();
    const std::size_t lowest =
      static_cast<std::size_t>(std::min_element(profile.begin(), profile.end()) - profile.begin());
    double sum = 0.0;
    double valley = profile[lowest]; // before the maximum
    double high = valley;
    double low = valley; // since the maximum
    for (std::size_t i = 1; i <= size; ++i)
    {
      const double value = profile[(lowest + i) % size];
      if (high < valley + Threshold) // no maximum yet
      {
        valley = std::min(valley, value);
        high = low = std::max(value, valley);
        continue;
      }
      if (value > high)
      {
        high = low = value;
        continue;
      }
      low = std::min(low, value);
      if (low <= high - Threshold && (value >= low + Threshold || i == size))
      {
        const double prominence = high - std::max(valley, low);
        count += std::min(prominence / Clear, 1.0);
        sum += std::min(prominence, MostProminence);
        valley = low;
        high = low = value;
      }
    }
    return sum;
  }

  void Judge(Place& place, std::vector<float>* rings) const
  {
    const float* open = this->Open.data() + this->Index(place.Column, place.Row);
    double openness = 0.0;
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      rings[i].clear();
    }
    const int firstCounted = this->Rows / 10;
    for (int i = 0; i < Directions; ++i)
    {
      const std::ptrdiff_t* offsets =
        this->Offsets.data() + static_cast<std::size_t>(i) * this->Steps;
      float light = 0.0f;
      float part = 0.0f;
      float power = 0.0f;
      int ring = 0;
      float sum = 0.0f;
      float weight = 0.0f;
      for (int j = 0; j < this->Steps; ++j)
      {
        const float cell = open[offsets[j]];
        const float isOpen = std::min(cell, 1.0f);
        if (j < this->GlowSteps)
        {
          light += this->Glow[j] * isOpen;
          part = light / this->Free[j];
          power = this->Power[static_cast<std::size_t>(256.0f * std::min(part, 1.0f))];
        }
        if (j < firstCounted)
        {
          continue;
        }
        openness += part;
        ++count;
        if (j >= this->RingSteps[ring + 1] || j + 1 == this->Steps)
        {
          if (weight > 0.0f)
          {
            rings[ring].push_back(sum / weight);
          }
          sum = weight = 0.0f;
          ++ring;
          if (ring == 3)
          {
            break;
          }
        }
        if (j >= this->RingSteps[0] && cell <= 1.0f)
        {
          const float seen = static_cast<float>(OverData + (1.0 - OverData) * isOpen);
          sum += seen * seen * std::max(this->Shown[j] * power - 16.0f, 0.0f);
          weight += seen;
        }
      }
    }
    double prominence = 0.0;
    double shafts = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      prominence += SumProminences(rings[i], shafts) / 3.0;
    }
    place.Shafts = shafts / 3.0;
    place.Openness = openness / std::max(count, 1);
    place.Score = prominence * this->GetFactor(place, this->GetGlare(place));
  }

  /// The open part of the disc of 0.06 about a place.
  double GetGlare(const Place& place) const
  {
    const int reach = static_cast<int>(std::ceil(0.06 * this->Rows));
    double sum = 0.0;
    int count = 0;
    for (int y = -reach; y <= reach; ++y)
    {
      for (int x = -reach; x <= reach; ++x)
      {
        if (x * x + y * y <= reach * reach)
        {
          sum += std::min(this->Open[this->Index(place.Column + x, place.Row + y)], 1.0f);
          ++count;
        }
      }
    }
    return sum / count;
  }

  double GetFactor(const Place& place, double glare) const
  {
    const auto square = [](double x) { return x * x; };
    const auto excess = [&](double x, double unit)
    { return 1.0 / (1.0 + square(std::max(0.0, x) / unit)); };
    const auto smooth = [](double t)
    {
      t = std::clamp(t, 0.0, 1.0);
      return t * t * (3.0 - 2.0 * t);
    };
    const double x = (place.Column + 0.5) / this->Columns;
    const double y = (place.Row + 0.5) / this->Rows;
    const double aspect = static_cast<double>(this->Columns) / this->Rows;
    const double p = place.Openness;
    const double quarter = std::max(0.25 * this->CoveredHeight, 1e-6);
    const double below = 0.55 + 0.45 * smooth((y - this->MiddleY + quarter) / quarter);
    const double sheet = excess(p - 0.45, 0.2);
    const double dark = excess(0.12 - p, 0.08);
    const double bare = excess(glare - 0.45, 0.25);
    const double edge = std::min({ x * aspect, (1.0 - x) * aspect, y, 1.0 - y }); // < 0 outside
    const double cut = edge < -0.06
      ? 1.0
      : 1.0 - 0.5 * std::min(1.0, 2.0 * glare) * std::clamp((0.12 - edge) / 0.12, 0.0, 1.0);
    const double outside = edge < 0.0 ? 0.8 : 1.0;
    const double third = 1.0 - 0.15 * std::min(1.0, std::abs(std::abs(x - 0.5) - 1.0 / 6.0) / 0.25);
    return below * sheet * dark * bare * cut * outside * third;
  }

  /// Returns true if most of a convex polygon with four corners is covered, as far as it is in the picture.
  bool IsCovered(const double corners[4][2]) const
  {
    constexpr double most = 0.6;
    double covered = 0.0;
    int count = 0;
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        int sides = 0;
        for (int i = 0; i < 4; ++i)
        {
          const double* a = corners[i];
          const double* b = corners[(i + 1) % 4];
          const double x = (column + 0.5) / this->Columns;
          const double y = (row + 0.5) / this->Rows;
          sides += (b[0] - a[0]) * (y - a[1]) > (b[1] - a[1]) * (x - a[0]) ? 1 : 0;
        }
        if (sides % 4 == 0)
        {
          covered += 1.0 - this->Open[this->Index(column, row)];
          ++count;
        }
      }
    }
    return covered > most * count;
  }

  Place JudgeAt(double x, double y) const
  {
    Place place;
    const double aspect = static_cast<double>(this->Columns) / std::max(this->Rows, 1);
    const double outside = std::max({ -x * aspect, (x - 1.0) * aspect, -y, y - 1.0 });
    if (this->Rows > 0 && outside <= 1.01 * Farthest)
    {
      std::vector<float> rings[3];
      place = this->At(x, y);
      this->Judge(place, rings);
    }
    return place;
  }

  void JudgeAll(std::vector<Place>& places) const
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<float> rings[3];
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Judge(places[i], rings);
        }
      });
  }

  /// Looks at a grid of 17 x 12 places, then about the best. A finer grid finds less than that does.
  Place FindBest(double lowest) const
  {
    constexpr int across = 17;
    constexpr int upwards = 12;
    const double low = std::max(0.2, lowest);
    const double step[2] = { (1.0 + 2.0 * Farthest) / (across - 1),
      std::max(1.0 + Farthest - low, 0.0) / (upwards - 1) };
    std::vector<Place> places;
    for (int j = 0; j < upwards; ++j)
    {
      for (int i = 0; i < across; ++i)
      {
        places.push_back(this->At(-Farthest + i * step[0], low + j * step[1]));
      }
    }
    this->JudgeAll(places);
    const auto isBetter = [](const Place& a, const Place& b) { return a.Score > b.Score; };
    const auto lookAbout = [&](std::size_t count, double part)
    {
      std::partial_sort(places.begin(), places.begin() + count, places.end(), isBetter);
      std::vector<Place> nearby;
      for (std::size_t i = 0; i < 9 * count; ++i)
      {
        const Place& about = places[i / 9];
        const double x =
          (about.Column + 0.5) / this->Columns + part * step[0] * (static_cast<int>(i % 3) - 1);
        const double y =
          (about.Row + 0.5) / this->Rows + part * step[1] * (static_cast<int>(i / 3 % 3) - 1);
        nearby.push_back(this->At(x, std::max(y, low)));
      }
      this->JudgeAll(nearby);
      places.insert(places.end(), nearby.begin(), nearby.end());
    };
    lookAbout(5, 0.4);
    lookAbout(2, 0.2);
    const Place best = *std::min_element(places.begin(), places.end(), isBetter);
    return best.Score > 0.0
      ? best
      : *std::max_element(places.begin(), places.end(),
          [](const Place& a, const Place& b) { return a.Openness < b.Openness; });
  }
};

vtkGodRaysSunPlacer::vtkGodRaysSunPlacer()
  : Internal(new Internals)
{
}

vtkGodRaysSunPlacer::~vtkGodRaysSunPlacer() = default;

bool vtkGodRaysSunPlacer::SetCoverageImage(vtkImageData* coverage)
{
  const int* size = coverage ? coverage->GetDimensions() : nullptr;
  if (!size || size[0] < 8 || size[1] < 8 || size[2] != 1 ||
    coverage->GetScalarType() != VTK_FLOAT || coverage->GetNumberOfScalarComponents() != 1)
  {
    vtkErrorMacro("SetCoverageImage needs an image of one 32-bit float a cell, of at least 8 x 8 "
                  "cells; nothing is "
                  "changed.");
    return false;
  }
  const auto covered = static_cast<const float*>(coverage->GetScalarPointer());
  constexpr float some = 0.25f; // of a cell that counts for the box
  int box[4] = { size[0], 0, size[1], 0 };
  double sum = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const float part = covered[static_cast<std::size_t>(y) * size[0] + x];
      sum += part;
      if (part >= some)
      {
        box[0] = std::min(box[0], x);
        box[1] = std::max(box[1], x + 1);
        box[2] = std::min(box[2], y);
        box[3] = std::max(box[3], y + 1);
      }
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    this->CoveredBounds[i] = box[1] == 0 ? i % 2 : static_cast<double>(box[i]) / size[i / 2];
  }
  this->Coverage = sum / (static_cast<double>(size[0]) * size[1]);
  Internals& self = *this->Internal;
  self.Set(covered, size[0], size[1]);
  self.MiddleY = 0.5 * (this->CoveredBounds[2] + this->CoveredBounds[3]);
  self.CoveredHeight = this->CoveredBounds[3] - this->CoveredBounds[2];
  return true;
}

bool vtkGodRaysSunPlacer::Find(vtkRenderer* renderer)
{
  const Internals& self = *this->Internal;
  double base[4][2];
  double lowest = this->Lowest;
  if (renderer && FindBase(renderer, base) && self.IsCovered(base))
  {
    constexpr double highest = 0.9;
    lowest = std::max(
      lowest, std::min(highest, std::max({ base[0][1], base[1][1], base[2][1], base[3][1] })));
  }
  this->Place[0] = UsualPlace[0];
  this->Place[1] = std::max(UsualPlace[1], lowest);
  this->Score = 0.0;
  constexpr double all = 0.999;
  if (this->Coverage > 0.0 && this->Coverage < all)
  {
    const Internals::Place best = self.FindBest(lowest);
    this->Place[0] = (best.Column + 0.5) / self.Columns;
    this->Place[1] = (best.Row + 0.5) / self.Rows;
    this->Score = best.Score;
  }
  return this->Score > 0.0;
}

double vtkGodRaysSunPlacer::GetScoreAt(double x, double y) const
{
  return this->Internal->JudgeAt(x, y).Score;
}

double vtkGodRaysSunPlacer::GetShaftsAt(double x, double y) const
{
  return this->Internal->JudgeAt(x, y).Shafts;
}

bool vtkGodRaysSunPlacer::FindPlace(vtkRenderer* renderer, vtkLight* light, double place[2])
{
  double point[4];
  light->GetTransformedPosition(point);
  point[3] = light->GetPositional() ? 1.0 : 0.0;
  double focus[3];
  light->GetTransformedFocalPoint(focus);
  for (int i = 0; i < 3 && !light->GetPositional(); ++i)
  {
    point[i] -= focus[i];
  }
  renderer->GetActiveCamera()
    ->GetCompositeProjectionTransformMatrix(GetAspect(renderer), -1.0, 1.0)
    ->MultiplyPoint(point, point);
  if (!(point[3] > 0.0))
  {
    return false;
  }
  place[0] = 0.5 + 0.5 * point[0] / point[3];
  place[1] = 0.5 + 0.5 * point[1] / point[3];
  return true;
}

const double* vtkGodRaysSunPlacer::GetUsualPlace()
{
  return UsualPlace;
}

bool vtkGodRaysSunPlacer::GetDirection(
  vtkRenderer* renderer, double x, double y, double direction[3])
{
  return renderer &&
    GetDirection(renderer->GetActiveCamera(), GetAspect(renderer), x, y, direction);
}

bool vtkGodRaysSunPlacer::GetDirection(
  vtkCamera* camera, double aspect, double x, double y, double direction[3])
{
  double ends[2][4];
  if (!camera || !GetSight(camera, aspect, x, y, ends))
  {
    return false;
  }
  double way[3];
  for (int i = 0; i < 3; ++i)
  {
    way[i] = ends[1][i] * ends[0][3] - ends[0][i] * ends[1][3];
  }
  if (!std::isfinite(way[0] + way[1] + way[2]) || !(vtkMath::Normalize(way) > 0.0))
  {
    return false;
  }
  // Points in front of the eye have weights of one sign: a far plane beyond infinity turns it around.
  const double sign = ends[0][3] * ends[1][3] < 0.0 ? -1.0 : 1.0;
  std::transform(way, way + 3, direction, [sign](double value) { return sign * value; });
  return true;
}

bool vtkGodRaysSunPlacer::GetPosition(vtkRenderer* renderer, double x, double y, double position[3])
{
  constexpr double beyond = 0.05; // diagonals of the box: near it, shafts in the air are strongest
  double direction[3];
  double ends[2][4];
  if (!GetDirection(renderer, x, y, direction) ||
    !GetSight(renderer->GetActiveCamera(), GetAspect(renderer), x, y, ends))
  {
    return false;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  vtkBoundingBox box(bounds);
  if (!box.IsValid())
  {
    box.SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  }
  double start[3];
  double farthest = -VTK_DOUBLE_MAX;
  for (int i = 0; i < 3; ++i)
  {
    start[i] = ends[0][i] / ends[0][3];
  }
  for (int i = 0; i < 8; ++i)
  {
    double corner[3];
    box.GetCorner(i, corner);
    vtkMath::Subtract(corner, start, corner);
    farthest = std::max(farthest, vtkMath::Dot(corner, direction));
  }
  for (int i = 0; i < 3; ++i)
  {
    position[i] = start[i] + (farthest + beyond * box.GetDiagonalLength()) * direction[i];
  }
  return true;
}

void vtkGodRaysSunPlacer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lowest: " << this->Lowest << "\n";
  os << indent << "Place: " << this->Place[0] << " " << this->Place[1] << "\n";
  os << indent << "Score: " << this->Score << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoveredBounds: " << this->CoveredBounds[0] << " " << this->CoveredBounds[1]
     << " " << this->CoveredBounds[2] << " " << this->CoveredBounds[3] << "\n";
}
