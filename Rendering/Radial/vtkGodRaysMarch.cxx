// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMarch.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkGodRaysMarch::vtkGodRaysMarch(const vtkGodRaysRadialIntegrator::Request& request)
{
  vtkGodRaysRadialModel* model = request.Model;
  const int n = model->GetNumberOfSamples();
  this->Gain =
    model->GetExposure() * model->GetWeight() * vtkGodRays::GeometricSum(model->GetDecay(), n);
  this->K = -n * std::log(model->GetDecay());

  this->LayerSize[0] = request.Layer->GetWidth();
  this->LayerSize[1] = request.Layer->GetHeight();
  this->PictureSize[0] = request.Result->GetWidth();
  this->PictureSize[1] = request.Result->GetHeight();
  const double* light = request.LightClip;
  // The march is linear in the point: known from that at the picture's centre, where ndc is 0.
  const vtkGodRays::Vec2 center = vtkGodRays::MarchVector(
    { light[0], light[1], light[2] }, vtkGodRays::Vec2(0.0), request.MarchScale);
  this->Slope = model->GetDensity() * request.MarchScale * light[2];
  for (int i = 0; i < 2; ++i)
  {
    const double size = this->LayerSize[i];
    this->Step[i] = request.ViewScale * size / this->PictureSize[i];
    this->Origin[i] = 0.5 * (size - 1.0) - 0.5 * this->Step[i] * (this->PictureSize[i] - 1);
    this->Constant[i] = model->GetDensity() * center[i] * size + this->Slope * 0.5 * (size - 1.0);
  }
  if (std::isinf(this->K)) // the pixel itself
  {
    this->K = this->Slope = this->Constant[0] = this->Constant[1] = 0.0;
  }
}

//------------------------------------------------------------------------------
bool vtkGodRaysMarch::operator==(const vtkGodRaysMarch& other) const
{
  const auto same = [](const auto& a, const auto& b) { return std::equal(a, a + 2, b); };
  return same(this->Constant, other.Constant) && this->Slope == other.Slope && this->K == other.K &&
    this->Gain == other.Gain && same(this->LayerSize, other.LayerSize) &&
    same(this->PictureSize, other.PictureSize) && same(this->Origin, other.Origin) &&
    same(this->Step, other.Step);
}

//------------------------------------------------------------------------------
double vtkGodRaysMarch::GetLongest() const
{
  double longest = 0.0;
  for (const int x : { 0, this->PictureSize[0] - 1 })
  {
    for (const int y : { 0, this->PictureSize[1] - 1 })
    {
      longest = std::max(longest,
        std::hypot(this->Constant[0] - this->Slope * this->GetPoint(0, x),
          this->Constant[1] - this->Slope * this->GetPoint(1, y)));
    }
  }
  return longest;
}

//------------------------------------------------------------------------------
double vtkGodRaysMarch::GetSummedPixels() const
{
  double sum = 0.0;
  const double points[5][2] = { { 0.5, 0.5 }, { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  for (const double* point : points)
  {
    sum += std::hypot(
      this->Constant[0] - this->Slope * this->GetPoint(0, point[0] * (this->PictureSize[0] - 1)),
      this->Constant[1] - this->Slope * this->GetPoint(1, point[1] * (this->PictureSize[1] - 1)));
  }
  const double area = static_cast<double>(this->LayerSize[0]) * this->LayerSize[1];
  const double length = std::min(0.2 * sum, 0.4 * std::sqrt(area));
  return std::max(1.0, length / std::sqrt(std::max(1.0, std::abs(this->K))));
}

//------------------------------------------------------------------------------
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
