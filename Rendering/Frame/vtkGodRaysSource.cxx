// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSource.h"

#include "vtkCamera.h"
#include "vtkGodRaysMath.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
/// In a parallel projection the picture's height counts as this angle.
const double ParallelHeightDegrees = 30.0;

double GetPictureHeight(const vtkGodRaysView& view)
{
  return 2.0 * view.ViewScale / std::hypot(view.ViewToClip[4], view.ViewToClip[5]);
}
}

//------------------------------------------------------------------------------
void vtkGodRaysView::Set(vtkRenderer* renderer, const int size[2], double margin)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Aspect = renderer->GetTiledAspectRatio();
  this->ViewScale = 1.0 / (1.0 + 2.0 * margin);
  this->Pixel[0] = 2.0 * this->ViewScale / size[0];
  this->Pixel[1] = 2.0 * this->ViewScale / size[1];

  // The matrices of vtkOpenGLCamera::GetKeyMatrices(). GetCompositeProjectionTransformMatrix()
  // will not do: it is for picking, and switches stereo off.
  vtkMatrix4x4::DeepCopy(this->WorldToView, camera->GetModelViewTransformMatrix());
  vtkMatrix4x4::DeepCopy(
    this->ViewToClip, camera->GetProjectionTransformMatrix(this->Aspect, -1.0, 1.0));
  for (int column = 0; column < 8; ++column) // rows of x and y
  {
    this->ViewToClip[column] *= this->ViewScale;
  }
  vtkMatrix4x4::Invert(this->ViewToClip, this->ClipToView);

  // The eye is where all rays meet, the point that projects to (0, 0, 1, 0).
  const double w = this->ClipToView[14];
  this->Parallel =
    this->ViewToClip[12] == 0.0 && this->ViewToClip[13] == 0.0 && this->ViewToClip[14] == 0.0;
  for (int i = 0; i < 3; ++i)
  {
    this->Eye[i] = this->Parallel ? 0.0 : this->ClipToView[4 * i + 2] / w;
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysView::GetRay(double x, double y, double ray[3]) const
{
  const double onNear[4] = { x, y, -1.0, 1.0 };
  const double onFar[4] = { x, y, 1.0, 1.0 };
  double a[4];
  double b[4];
  vtkMatrix4x4::MultiplyPoint(this->ClipToView, onNear, a);
  vtkMatrix4x4::MultiplyPoint(this->ClipToView, onFar, b);
  for (int i = 0; i < 3; ++i)
  {
    ray[i] = b[i] * a[3] - a[i] * b[3];
  }
  vtkMath::Normalize(ray);
}

//------------------------------------------------------------------------------
// With depth d, its rows of x and y are (X x + S d + T)/w, w being d or 1.
bool vtkGodRaysView::GetPinhole(const int size[2], Pinhole& pinhole) const
{
  const double* m = this->ViewToClip;
  const double tilt = std::hypot(std::hypot(m[1], m[4]), std::hypot(m[8], m[9])) +
    (this->Parallel ? std::hypot(m[2], m[6]) : std::hypot(m[12], m[13]));
  const double pixel[2] = { 2.0 / (m[0] * size[0]), 2.0 / (m[5] * size[1]) };
  if (!(m[0] > 0.0 && m[5] > 0.0 && tilt < 1e-6 * (m[0] + m[5])) ||
    !(std::abs(pixel[0] - pixel[1]) < 0.02 * pixel[1]))
  {
    return false;
  }
  const double scale = this->Parallel ? 1.0 / m[15] : -1.0 / m[14];
  pinhole.PixelSize = std::sqrt(pixel[0] * pixel[1]) / scale;
  for (int i = 0; i < 2; ++i)
  {
    const double center = this->Parallel ? m[4 * i + 3] : -m[4 * i + 2];
    pinhole.Center[i] = 0.5 * (1.0 + center * scale) * size[i];
  }
  // at z = 1 - 2 e; the view depth is counted from the eye
  const double* c = this->ClipToView;
  const double over[2] = { this->Eye[2] * c[15] - c[11], this->Eye[2] * c[14] - c[10] };
  pinhole.Depth[0] = over[0] + over[1];
  pinhole.Depth[1] = -2.0 * over[1];
  pinhole.Depth[2] = c[15] + c[14];
  pinhole.Depth[3] = -2.0 * c[14];
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysView::GetPicture(bool planar, double origin[3], double right[3], double up[3]) const
{
  if (this->Parallel && !planar)
  {
    this->GetRay(0.0, 0.0, origin);
    std::fill_n(right, 3, 0.0);
    std::fill_n(up, 3, 0.0);
    return;
  }
  // On the near plane, (x, y, -1, 1) in clip coordinates, everything is linear, also seen from the
  // eye when it is not divided by w.
  const double* m = this->ClipToView;
  const double w[3] = { m[15] - m[14], m[12], m[13] };
  const double scale = planar ? 1.0 / w[0] : w[0] < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* row = m + 4 * i;
    const double eye = planar ? 0.0 : this->Eye[i];
    origin[i] = scale * (row[3] - row[2] - eye * w[0]);
    right[i] = scale * (row[0] - eye * w[1]);
    up[i] = scale * (row[1] - eye * w[2]);
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSource::Place(const vtkGodRaysView& view, const double world[4], double radius)
{
  double position[4];
  double clip[4];
  vtkMatrix4x4::MultiplyPoint(view.WorldToView, world, position);
  vtkMatrix4x4::MultiplyPoint(view.ViewToClip, position, clip);
  this->Clip[0] = clip[0];
  this->Clip[1] = clip[1];
  this->Clip[2] = clip[3];

  const bool infinite = world[3] == 0.0;
  this->Infinite = infinite;
  for (int i = 0; i < 3; ++i)
  {
    this->Position[i] = position[i];
    this->Direction[i] = position[i] - (infinite ? 0.0 : view.Eye[i]);
  }
  const double distance = vtkMath::Normalize(this->Direction);
  this->Planar = view.Parallel && !infinite;
  this->Radius = radius;
  this->LeastPixel = view.Parallel && infinite
    ? vtkMath::RadiansFromDegrees(0.5 * view.Pixel[1] / view.ViewScale * ParallelHeightDegrees)
    : 0.0;
  this->Depth = 1.0;
  this->Fade = view.Parallel ? 1.0 : vtkGodRays::FacingFade(-this->Direction[2]);
  if (!infinite)
  {
    const double z = clip[3] > 0.0 ? clip[2] / clip[3] : -1.0;
    this->Depth = vtkMath::ClampValue(0.5 * z + 0.5, 0.0, 1.0);
    if (this->Planar) // behind a parallel camera: no angle says so, but the near plane does
    {
      this->Fade = vtkMath::ClampValue(10.0 * (z + 1.1), 0.0, 1.0);
    }
    else
    {
      this->Radius = distance > radius ? std::asin(radius / distance) : vtkMath::Pi();
    }
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSource::SetGlow(const vtkGodRaysView& view, double radius, double falloff)
{
  const double unit = this->Planar ? GetPictureHeight(view) / ParallelHeightDegrees
                                   : vtkMath::RadiansFromDegrees(1.0);
  this->GlowRadius = radius * unit;
  this->GlowFalloff = falloff * unit;
}

//------------------------------------------------------------------------------
double vtkGodRaysSource::GetPerspectiveDistance(const vtkGodRaysView& view) const
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ParallelHeightDegrees));
  return -this->Direction[2] * 2.0 * tangent / GetPictureHeight(view);
}

//------------------------------------------------------------------------------
// The disc is within a square about it: its corners, projected.
void vtkGodRaysSource::GetDiscBounds(
  const vtkGodRaysView& view, const int size[2], int bounds[4]) const
{
  for (int i = 0; i < 2; ++i)
  {
    bounds[2 * i] = 0;
    bounds[2 * i + 1] = size[i];
  }
  const double largest = 1.0; // [radians]
  if (!this->Planar && (view.Parallel || this->Radius > largest))
  {
    return;
  }
  const double half = this->Planar ? this->Radius : std::tan(this->Radius);
  double right[3] = { 1.0, 0.0, 0.0 };
  double up[3] = { 0.0, 1.0, 0.0 };
  if (!this->Planar)
  {
    vtkMath::Perpendiculars(this->Direction, right, up, 0.0);
  }
  double low[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int corner = 0; corner < 4; ++corner)
  {
    const double* center = this->Planar ? this->Position : this->Direction;
    double point[4] = { 0.0, 0.0, 0.0, this->Planar ? 1.0 : 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      point[i] =
        center[i] + half * ((corner & 1 ? right[i] : -right[i]) + (corner & 2 ? up[i] : -up[i]));
    }
    double clip[4];
    vtkMatrix4x4::MultiplyPoint(view.ViewToClip, point, clip);
    if (!(clip[3] > 1e-6 * std::hypot(clip[0], clip[1])))
    {
      return; // beside or behind the camera
    }
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], clip[i] / clip[3]);
      high[i] = std::max(high[i], clip[i] / clip[3]);
    }
  }
  const double margin = 3.0; // for the soft edge [pixels]
  for (int i = 0; i < 2; ++i)
  {
    const double first = std::floor(0.5 * (low[i] + 1.0) * size[i] - margin);
    const double last = std::ceil(0.5 * (high[i] + 1.0) * size[i] + margin);
    bounds[2 * i] = static_cast<int>(std::min(std::max(first, 0.0), 1.0 * size[i]));
    bounds[2 * i + 1] = static_cast<int>(std::min(std::max(last, 0.0), 1.0 * size[i]));
  }
}

//------------------------------------------------------------------------------
bool vtkGodRaysSource::Reaches(const vtkGodRaysView& view, bool glows) const
{
  const double reach = std::max(this->Radius, glows ? this->GlowRadius + this->GlowFalloff : 0.0);
  // the layer and two pixels about it, over which the edge of a disc may be softened
  const double right = 1.0 + 2.0 * view.Pixel[0];
  const double top = 1.0 + 2.0 * view.Pixel[1];
  if (this->Planar)
  {
    const double halfHeight = 1.0 / std::hypot(view.ViewToClip[4], view.ViewToClip[5]);
    const double halfWidth = 1.0 / std::hypot(view.ViewToClip[0], view.ViewToClip[1]);
    return std::abs(this->Clip[0]) * halfWidth <= right * halfWidth + reach &&
      std::abs(this->Clip[1]) * halfHeight <= top * halfHeight + reach;
  }
  // the cone about the layer's centre that holds its corners
  double axis[3];
  double cone = 0.0;
  view.GetRay(0.0, 0.0, axis);
  for (int corner = 0; corner < 4; ++corner)
  {
    double ray[3];
    view.GetRay(corner & 1 ? right : -right, corner & 2 ? top : -top, ray);
    cone = std::max(cone, vtkMath::AngleBetweenVectors(axis, ray));
  }
  return vtkMath::AngleBetweenVectors(axis, this->Direction) <=
    cone + reach + 2.0 * this->LeastPixel;
}
