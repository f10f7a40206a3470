// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysView.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

void vtkGodRaysView::Set(vtkRenderer* renderer, const int size[2], double margin)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Aspect = renderer->GetTiledAspectRatio();
  this->ViewScale = 1.0 / (1.0 + 2.0 * margin);
  this->Pixel[0] = 2.0 * this->ViewScale / size[0];
  this->Pixel[1] = 2.0 * this->ViewScale / size[1];

  // The matrices of vtkOpenGLCamera::GetKeyMatrices(). GetCompositeProjectionTransformMatrix()
  // will not do: it is for picking, and switches stereo off.
  double worldToCamera[16];
  double cameraToClip[16];
  double clipToCamera[16] = {}; // which stays 0 if it cannot be inverted
  vtkMatrix4x4::DeepCopy(worldToCamera, camera->GetModelViewTransformMatrix());
  vtkMatrix4x4::DeepCopy(
    cameraToClip, camera->GetProjectionTransformMatrix(this->Aspect, -1.0, 1.0));
  for (int column = 0; column < 8; ++column) // rows of x and y
  {
    cameraToClip[column] *= this->ViewScale;
  }
  vtkMatrix4x4::Invert(cameraToClip, clipToCamera);

  // The eye is where all rays meet, the point that projects to (0, 0, 1, 0).
  this->Parallel = cameraToClip[12] == 0.0 && cameraToClip[13] == 0.0 && cameraToClip[14] == 0.0;
  double viewToCamera[16];
  vtkMatrix4x4::Identity(viewToCamera);
  for (int i = 0; i < 3; ++i)
  {
    viewToCamera[4 * i + 3] = this->Parallel ? 0.0 : clipToCamera[4 * i + 2] / clipToCamera[14];
  }
  viewToCamera[10] = -1.0;
  vtkMatrix4x4::Invert(viewToCamera, this->CameraToView);
  vtkMatrix4x4::Multiply4x4(this->CameraToView, worldToCamera, this->WorldToView);
  vtkMatrix4x4::Multiply4x4(cameraToClip, viewToCamera, this->ViewToClip);
  vtkMatrix4x4::Multiply4x4(this->CameraToView, clipToCamera, this->ClipToView);
}

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
  const double scale = 1.0 / m[this->Parallel ? 15 : 14];
  pinhole.PixelSize = std::sqrt(pixel[0] * pixel[1]) / scale;
  for (int i = 0; i < 2; ++i)
  {
    const double center = m[4 * i + (this->Parallel ? 3 : 2)];
    pinhole.Center[i] = 0.5 * (1.0 + center * scale) * size[i];
  }
  // at z = 1 - 2 e
  const double* c = this->ClipToView;
  pinhole.Depth[0] = c[11] + c[10];
  pinhole.Depth[1] = -2.0 * c[10];
  pinhole.Depth[2] = c[15] + c[14];
  pinhole.Depth[3] = -2.0 * c[14];
  return true;
}

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
  const double w = m[15] - m[14];
  const double scale = planar ? 1.0 / w : w < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* row = m + 4 * i;
    origin[i] = scale * (row[3] - row[2]);
    right[i] = scale * row[0];
    up[i] = scale * row[1];
  }
}

double vtkGodRaysView::GetPictureHeight() const
{
  return 2.0 * this->ViewScale / std::hypot(this->ViewToClip[4], this->ViewToClip[5]);
}

void vtkGodRaysView::GetHullBounds(
  const double (*points)[4], int count, const int size[2], double margin, int bounds[4]) const
{
  double low[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int k = 0; k < count; ++k)
  {
    double clip[4];
    vtkMatrix4x4::MultiplyPoint(this->ViewToClip, points[k], clip);
    if (!(clip[3] > 1e-6 * std::hypot(clip[0], clip[1])))
    {
      const int whole[4] = { 0, size[0], 0, size[1] };
      std::copy_n(whole, 4, bounds);
      return;
    }
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], clip[i] / clip[3]);
      high[i] = std::max(high[i], clip[i] / clip[3]);
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    const double first = std::floor(0.5 * (low[i] + 1.0) * size[i] - margin);
    const double last = std::ceil(0.5 * (high[i] + 1.0) * size[i] + margin);
    bounds[2 * i] = static_cast<int>(std::min(std::max(first, 0.0), 1.0 * size[i]));
    bounds[2 * i + 1] = static_cast<int>(std::min(std::max(last, 0.0), 1.0 * size[i]));
  }
}
