// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMarch.h"

#include "vtkGodRaysMath.h"

#include <algorithm>
#include <cmath>

vtkGodRaysMarch::vtkGodRaysMarch(const vtkGodRaysMarchParameters& parameters,
  const int layerSize[2], const int pictureSize[2], double viewScale)
{
  const int n = parameters.NumberOfSamples;
  this->Gain =
    parameters.Exposure * parameters.Weight * vtkGodRays::GeometricSum(parameters.Decay, n);
  this->K = -n * std::log(parameters.Decay);
  const double* light = parameters.LightClip;
  // The march is linear in the point: known from that at the picture's centre, where ndc is 0.
  const vtkGodRays::Vec2 center = vtkGodRays::MarchVector(
    { light[0], light[1], light[2] }, vtkGodRays::Vec2(0.0), parameters.MarchScale);
  this->Slope = parameters.Density * parameters.MarchScale * light[2];
  for (int i = 0; i < 2; ++i)
  {
    this->LayerSize[i] = layerSize[i];
    this->PictureSize[i] = pictureSize[i];
    const double size = layerSize[i];
    this->Step[i] = viewScale * size / pictureSize[i];
    this->Origin[i] = 0.5 * (size - 1.0) - 0.5 * this->Step[i] * (pictureSize[i] - 1);
    this->Constant[i] = parameters.Density * center[i] * size + this->Slope * 0.5 * (size - 1.0);
  }
  if (std::isinf(this->K))
  {
    this->K = this->Slope = this->Constant[0] = this->Constant[1] = 0.0;
  }
}

bool vtkGodRaysMarch::operator==(const vtkGodRaysMarch& other) const
{
  const auto same = [](const auto& a, const auto& b) { return std::equal(a, a + 2, b); };
  return same(this->Constant, other.Constant) && this->Slope == other.Slope && this->K == other.K &&
    this->Gain == other.Gain && same(this->LayerSize, other.LayerSize) &&
    same(this->PictureSize, other.PictureSize) && same(this->Origin, other.Origin) &&
    same(this->Step, other.Step);
}

double vtkGodRaysMarch::GetMarchAt(double x, double y) const
{
  return std::hypot(this->Constant[0] - this->Slope * this->GetPoint(0, x),
    this->Constant[1] - this->Slope * this->GetPoint(1, y));
}

double vtkGodRaysMarch::GetLongest() const
{
  double longest = 0.0;
  for (const int x : { 0, this->PictureSize[0] - 1 })
  {
    for (const int y : { 0, this->PictureSize[1] - 1 })
    {
      longest = std::max(longest, this->GetMarchAt(x, y));
    }
  }
  return longest;
}

double vtkGodRaysMarch::GetLength() const
{
  double sum = 0.0;
  const double points[5][2] = { { 0.5, 0.5 }, { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  for (const double* point : points)
  {
    sum += this->GetMarchAt(
      point[0] * (this->PictureSize[0] - 1), point[1] * (this->PictureSize[1] - 1));
  }
  const double area = static_cast<double>(this->LayerSize[0]) * this->LayerSize[1];
  return std::min(0.2 * sum, 0.4 * std::sqrt(area));
}

double vtkGodRaysMarch::GetLengthWithin() const
{
  constexpr int Points = 16; // on each side of a grid over the picture
  double sum = 0.0;
  for (int i = 0; i < Points * Points; ++i)
  {
    const int place[2] = { i % Points, i / Points };
    double way[2];
    double first = 0.0;
    double last = 1.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double point =
        this->GetPoint(axis, (place[axis] + 0.5) / Points * this->PictureSize[axis] - 0.5);
      way[axis] = this->Constant[axis] - this->Slope * point;
      if (way[axis] != 0.0)
      {
        const double a = (-0.5 - point) / way[axis];
        const double b = (this->LayerSize[axis] - 0.5 - point) / way[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
      }
    }
    sum += std::max(0.0, last - first) * std::hypot(way[0], way[1]);
  }
  return sum / (Points * Points);
}

bool vtkGodRaysMarch::IsSmall() const
{
  return std::min(this->LayerSize[0], this->LayerSize[1]) < SmallestSweep &&
    this->GetLengthWithin() <= LongestOfSmall;
}

double vtkGodRaysMarch::GetSummedPixels() const
{
  return std::max(1.0, this->GetLength() / std::sqrt(std::max(1.0, std::abs(this->K))));
}

double vtkGodRaysMarch::GetGrowth() const
{
  return std::exp(0.5 * std::min(std::max(-this->K, 0.0), 5.0));
}

double vtkGodRaysMarch::GetParallelism() const
{
  double nearest = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double low = this->Constant[i] - this->Slope * this->GetPoint(i, 0);
    const double high =
      this->Constant[i] - this->Slope * this->GetPoint(i, this->PictureSize[i] - 1);
    nearest = std::max(nearest, low * high > 0.0 ? std::min(std::abs(low), std::abs(high)) : 0.0);
    farthest = std::max({ farthest, std::abs(low), std::abs(high) });
  }
  return 1.0 + (farthest > 0.0 ? 3.0 * nearest / farthest : 0.0);
}

double vtkGodRaysMarch::GetErrorScale() const
{
  return this->GetGrowth() * this->GetParallelism() / std::sqrt(this->GetSummedPixels());
}
