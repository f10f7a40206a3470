// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowFaces.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysView.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace
{
const double Eye[3] = { 0.0, 0.0, 0.0 };

/// The bounds of the occluders, on all processes, but of those that say theirs do not count and that cannot.
bool GetBounds(const vtkGodRaysMediumIntegrator::Request& request, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (vtkProp* prop : *request.Occluders)
  {
    const double* own = prop->GetBounds();
    if (own && vtkMath::AreBoundsInitialized(own) && vtkGodRaysGate::IsUsable(own))
    {
      for (int i = 0; i < 6; i += 2)
      {
        const bool first = bounds[i] > bounds[i + 1];
        bounds[i] = first ? own[i] : std::min(bounds[i], own[i]);
        bounds[i + 1] = first ? own[i + 1] : std::max(bounds[i + 1], own[i + 1]);
      }
    }
  }
  vtkGodRaysCompositor::JoinBounds(request.Compositor, bounds);
  return vtkMath::AreBoundsInitialized(bounds);
}

/// Right, up, and backwards from what is looked at: made right-handed, in the camera's coordinates, so
/// that faces of props face as they do. In the world they are the same wherever the eye is: the perpendicular
/// is chosen by the largest component, of which the eye's rounding must not make another one.
void SetAxes(const vtkGodRaysView& view, const double backwards[3], double axes[3][3])
{
  const double* toView = view.WorldToView; // its rows turn, and mirror z
  double world[3];
  double right[3];
  double unused[3];
  for (int i = 0; i < 3; ++i)
  {
    world[i] =
      backwards[0] * toView[i] + backwards[1] * toView[4 + i] + backwards[2] * toView[8 + i];
  }
  vtkMath::Normalize(world);
  for (double& component : world)
  {
    component = std::round(component * 1e6) / 1e6;
  }
  vtkMath::Perpendiculars(world, right, unused, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    const double mirrored = i == 2 ? -1.0 : 1.0;
    axes[0][i] = mirrored * vtkMath::Dot(toView + static_cast<std::ptrdiff_t>(4) * i, right);
    axes[2][i] = mirrored * backwards[i];
  }
  vtkMath::Cross(
    axes[2], axes[0], axes[1]); // at right angles, whatever the camera's own matrix does
  vtkMath::Normalize(axes[1]);
  vtkMath::Cross(axes[1], axes[2], axes[0]);
  for (int i = 0; i < 3; ++i)
  {
    axes[i][2] *= -1.0;
  }
}

/// Where the layer's point (x, y) is at a view depth.
void GetPlace(const vtkGodRaysView& view, double x, double y, double depth, double place[3])
{
  double origin[3];
  double right[3];
  double up[3];
  view.GetPicture(view.Parallel, origin, right, up);
  for (int i = 0; i < 3; ++i)
  {
    place[i] = origin[i] + x * right[i] + y * up[i];
  }
  const double scale = view.Parallel ? 1.0 : depth / place[2];
  for (int i = 0; i < 2; ++i)
  {
    place[i] *= scale;
  }
  place[2] = depth;
}

/// How far a place is along axes from an origin.
void GetAlong(
  const double axes[3][3], const double origin[3], const double place[3], double along[3])
{
  double from[3];
  vtkMath::Subtract(place, origin, from);
  for (int i = 0; i < 3; ++i)
  {
    along[i] = vtkMath::Dot(axes[i], from);
  }
}
}

void vtkGodRaysShadowFaces::Fit(
  const vtkGodRaysMediumIntegrator::Request& request, int size, int levels)
{
  this->Levels = request.Light->IsInfinite() && !request.View->Parallel ? levels : 1;
  this->Count = 0;
  double bounds[6];
  if (!GetBounds(request, bounds))
  {
    return;
  }
  for (int i = 0; i < 8; ++i)
  {
    const double world[4] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)], 1.0 };
    double view[4];
    vtkMatrix4x4::MultiplyPoint(request.View->WorldToView, world, view);
    std::copy_n(view, 3, this->Corners[i]);
  }
  this->Grids.Point = !request.Light->IsInfinite();
  if (this->Grids.Point)
  {
    this->FitPoint(request);
  }
  else
  {
    this->FitDirectional(request);
  }
  if (this->Count > 0)
  {
    this->SetSize(std::min(this->Levels > 1 ? size / 2 : size,
      vtkTextureObject::GetMaximumTextureSize(request.Window) / this->GetColumns()));
  }
}

void vtkGodRaysShadowFaces::SetSize(int size)
{
  this->Size = size;
  for (vtkGodRaysShadowGrids::Grid& grid : this->Grids.Grids)
  {
    for (int k = 0; k < 2; ++k)
    {
      grid.Size[k] = size;
      grid.Texel[k] /= size;
    }
  }
}

// Across the light, of the occluders' shadow what may be seen; all of it, which is the same wherever the
// eye is, for one face if that is no more than four times as large.
void vtkGodRaysShadowFaces::FitDirectional(const vtkGodRaysMediumIntegrator::Request& request)
{
  double axes[3][3];
  SetAxes(*request.View, request.Light->Direction, axes);
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int i = 0; i < 8; ++i)
  {
    double along[3];
    GetAlong(axes, Eye, this->Corners[i], along);
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], along[k]);
      high[k] = std::max(high[k], along[k]);
    }
  }
  double farthest = request.Medium->FarLimit;
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    request.Compositor->Reduce(&farthest, 1, vtkGodRaysCompositor::GREATEST);
  }
  double seenLow[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double seenHigh[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  const auto see = [&](double x, double y, double depth)
  {
    double place[3];
    GetPlace(*request.View, x, y, depth, place);
    double along[3];
    GetAlong(axes, Eye, place, along);
    for (int k = 0; k < 2; ++k)
    {
      seenLow[k] = std::min(seenLow[k], along[k]);
      seenHigh[k] = std::max(seenHigh[k], along[k]);
    }
  };
  for (int i = 0; i < 4; ++i)
  {
    see(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0);
    see(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, farthest);
  }
  const double around = 1e-3 * (high[2] - low[2] + high[1] - low[1] + high[0] - low[0]) + 1e-30;
  double whole = 1.0;
  double seen = 1.0;
  for (int k = 0; k < 2; ++k)
  {
    whole *= high[k] - low[k];
    seenLow[k] = std::max(low[k], seenLow[k]);
    seenHigh[k] = std::min(high[k], seenHigh[k]);
    seen *= seenHigh[k] - seenLow[k];
    if (!std::isinf(request.Focus) && !(seenLow[k] - around < seenHigh[k] + around))
    {
      return; // no shadow is seen
    }
  }
  const bool fitsView = request.Focus == 0.0 && (this->Levels > 1 || seen < 0.25 * whole);
  for (int k = 0; k < 2; ++k)
  {
    low[k] = (fitsView ? seenLow[k] : low[k]) - around;
    high[k] = (fitsView ? seenHigh[k] : high[k]) + around;
  }
  this->Count = 1;
  this->Grids.Range[0] = -high[2] - around;
  this->Grids.Range[1] = -low[2] + around;
  this->SetFace(0, axes, Eye, low, high);
  this->Grids.Levels = 1;
  this->Nest(axes, low, high, request);
}

// Finer faces, each of a share of the one before about the axis through the eye. A face that the axis does
// not go through ends where the coarsest one does. With a focus they are as wide both ways, about a place
// ahead of the eye from which they reach past the focus, and go by eighths of their width: texels stay where
// they are in the world, and so do edges of shadows, and most frames of a camera that moves need no new map.
void vtkGodRaysShadowFaces::Nest(const double axes[3][3], const double low[2], const double high[2],
  const vtkGodRaysMediumIntegrator::Request& request)
{
  const bool isStill = request.Focus > 0.0;
  double share = request.Share;
  for (int level = 1; level < this->Levels; ++level, share *= request.Share)
  {
    const double widest = share * std::max(high[0] - low[0], high[1] - low[1]);
    const double ahead = std::max(0.25 * widest, request.Focus - 0.3 * widest);
    double ends[2][2];
    for (int k = 0; k < 2; ++k)
    {
      const double width = std::min(widest, high[k] - low[k]);
      const double step = width / 8.0;
      const double last = std::floor((high[k] - low[k] - width) / step);
      const double first = std::round((ahead * axes[k][2] - 0.5 * width - low[k]) / step);
      const double at = low[k] + step * std::clamp(first, 0.0, std::max(last, 0.0));
      ends[0][k] = isStill ? at : low[k] < 0.0 ? share * low[k] : low[k];
      ends[1][k] = isStill ? at + width : high[k] > 0.0 ? share * high[k] : high[k];
      if (!(ends[0][k] < ends[1][k]))
      {
        return;
      }
    }
    this->SetFace(level, axes, Eye, ends[0], ends[1]);
    this->Count = this->Grids.Levels = level + 1;
  }
}

void vtkGodRaysShadowFaces::FitPoint(const vtkGodRaysMediumIntegrator::Request& request)
{
  const double* light = request.Light->Position;
  double center[3] = { 0.0, 0.0, 0.0 };
  double farthest = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      center[k] += 0.125 * this->Corners[i][k];
    }
    farthest =
      std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(light, this->Corners[i])));
  }
  double axes[3][3];
  double backwards[3];
  vtkMath::Subtract(light, center, backwards);
  if (!(vtkMath::Normalize(backwards) > 0.0))
  {
    backwards[2] = 1.0;
  }
  SetAxes(*request.View, backwards, axes);
  double tangents[2] = { 0.0, 0.0 };
  double nearest = farthest;
  for (int i = 0; i < 8; ++i)
  {
    double along[3];
    GetAlong(axes, light, this->Corners[i], along);
    nearest = std::min(nearest, -along[2]);
    for (int k = 0; k < 2; ++k)
    {
      tangents[k] = std::max(tangents[k], std::abs(along[k]) / std::max(-along[2], 1e-30));
    }
  }
  const double widest = std::sqrt(3.0); // the tangent of 60 degrees
  this->Grids.Range[1] = 1.001 * farthest;
  if (nearest > 0.0 && std::max(tangents[0], tangents[1]) < widest)
  {
    this->Count = 1;
    this->Grids.Range[0] = 0.999 * nearest;
    const double high[2] = { 1.001 * tangents[0] + 1e-6, 1.001 * tangents[1] + 1e-6 };
    const double low[2] = { -high[0], -high[1] };
    this->SetFace(0, axes, light, low, high);
    this->Grids.Levels = 1;
    return;
  }
  this->Count = 6;
  this->Grids.Range[0] = std::max(1e-4 * farthest, request.Nearest);
  // The world's axes, at right angles also where the camera's own matrix makes others of them.
  for (int k = 0; k < 3; ++k)
  {
    backwards[k] = request.View->WorldToView[4 * k];
  }
  vtkMath::Normalize(backwards);
  double cube[3][3];
  SetAxes(*request.View, backwards, axes);
  std::copy_n(axes[2], 3, cube[0]);
  std::copy_n(axes[1], 3, cube[1]);
  std::transform(axes[0], axes[0] + 3, cube[2], std::negate<>());
  // Ahead along each axis, and against it, up along the next one; surfaces' shaders know this order.
  for (int face = 0; face < 6; ++face)
  {
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    for (int k = 0; k < 3; ++k)
    {
      axes[0][k] = -side * cube[(face / 2 + 2) % 3][k];
      axes[1][k] = cube[(face / 2 + 1) % 3][k];
      axes[2][k] = side * cube[face / 2][k];
    }
    const double high[2] = { 1.0 + request.Overlap, 1.0 + request.Overlap };
    const double low[2] = { -high[0], -high[1] };
    this->SetFace(face, axes, light, low, high);
  }
  this->Grids.Levels = 6;
}

// Between low and high across the light, or, for a point light, across it at distance 1.
void vtkGodRaysShadowFaces::SetFace(int face, const double axes[3][3], const double origin[3],
  const double low[2], const double high[2])
{
  vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
  for (int k = 0; k < 2; ++k)
  {
    std::copy_n(axes[k], 3, grid.Axes[k]);
    grid.Low[k] = low[k];
    grid.Texel[k] = high[k] - low[k]; // of its one pixel as yet
  }
  std::transform(axes[2], axes[2] + 3, grid.Axes[2], std::negate<>());
  double* m = this->ViewToMap[face];
  double shift[3];
  for (int k = 0; k < 3; ++k)
  {
    shift[k] = -vtkMath::Dot(axes[k], origin);
  }
  const double nearest = this->Grids.Range[0];
  const double farthest = this->Grids.Range[1];
  const double depth = farthest - nearest;
  for (int column = 0; column < 4; ++column)
  {
    const auto along = [&](int k) { return column < 3 ? axes[k][column] : shift[k]; };
    const double one = column == 3 ? 1.0 : 0.0;
    const double w = this->Grids.Point ? -along(2) : one;
    for (int k = 0; k < 2; ++k)
    {
      m[4 * k + column] = (2.0 * along(k) - (low[k] + high[k]) * w) / (high[k] - low[k]);
    }
    m[8 + column] = this->Grids.Point
      ? ((farthest + nearest) * -along(2) - 2.0 * farthest * nearest * one) / depth
      : (-2.0 * along(2) - (farthest + nearest) * one) / depth;
    m[12 + column] = w;
  }
}

void vtkGodRaysShadowFaces::Set(vtkShaderProgram* program) const
{
  program->SetUniformi("numberOfFaces", this->Count);
  program->SetUniformf("nearest", static_cast<float>(0.5 * this->Grids.Range[0]));
  float matrices[6 * 16]; // columns first
  for (int face = 0; face < this->Count; ++face)
  {
    const double* m = this->ViewToMap[face];
    for (int column = 0; column < 4; ++column)
    {
      float* to = matrices + static_cast<std::ptrdiff_t>(16) * face + 4 * column;
      const double w = m[12 + column];
      to[0] = static_cast<float>(0.5 * this->Size * (m[column] + w));
      to[1] = static_cast<float>(0.5 * this->Size * (m[4 + column] + w));
      to[2] = static_cast<float>(0.5 * (w - m[8 + column]));
      to[3] = static_cast<float>(w);
    }
  }
  program->SetUniformMatrix4x4v("toMap", this->Count, matrices);
}
