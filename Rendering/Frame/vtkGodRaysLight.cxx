// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysLight.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysView.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>

namespace
{
/// In a parallel projection the picture's height counts as this angle.
const double ParallelHeightDegrees = 30.0;
}

void vtkGodRaysLight::AppendName(std::string& text) const
{
  text += this->Kind;
  if (this->Number >= 0)
  {
    text.append(", number ").append(std::to_string(this->Number));
  }
  else if (this->Prop)
  {
    text.append(", ").append(this->Prop->GetClassName());
  }
}

std::string vtkGodRaysLight::GetName() const
{
  std::string name;
  this->AppendName(name);
  return name;
}

void vtkGodRaysLight::Place(const vtkGodRaysView& view, const double world[4], double radius)
{
  double clip[4];
  vtkMatrix4x4::MultiplyPoint(view.WorldToView, world, this->Position);
  vtkMatrix4x4::MultiplyPoint(view.ViewToClip, this->Position, clip);
  this->Clip[0] = clip[0];
  this->Clip[1] = clip[1];
  this->Clip[2] = clip[3];

  const bool infinite = this->IsInfinite();
  std::copy_n(this->Position, 3, this->Direction);
  const double distance = vtkMath::Normalize(this->Direction);
  this->Planar = view.Parallel && !infinite;
  this->Radius = radius;
  this->LeastPixel = view.Parallel && infinite
    ? vtkMath::RadiansFromDegrees(0.5 * view.Pixel[1] / view.ViewScale * ParallelHeightDegrees)
    : 0.0;
  this->Depth = 1.0;
  this->Fade = view.Parallel ? 1.0 : vtkGodRays::FacingFade(this->Direction[2]);
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

void vtkGodRaysLight::SetGlow(const vtkGodRaysView& view, double radius, double falloff)
{
  const double unit = this->Planar ? view.GetPictureHeight() / ParallelHeightDegrees
                                   : vtkMath::RadiansFromDegrees(1.0);
  this->GlowRadius = radius * unit;
  this->GlowFalloff = falloff * unit;
}

double vtkGodRaysLight::GetPerspectiveDistance(const vtkGodRaysView& view) const
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ParallelHeightDegrees));
  return this->Direction[2] * 2.0 * tangent / view.GetPictureHeight();
}

void vtkGodRaysLight::GetDiscBounds(
  const vtkGodRaysView& view, const int size[2], int bounds[4]) const
{
  this->GetBoundsAbout(view, this->Radius, size, bounds);
}

void vtkGodRaysLight::GetGlowBounds(
  const vtkGodRaysView& view, const int size[2], int bounds[4]) const
{
  this->GetBoundsAbout(view, this->GlowRadius + this->GlowFalloff, size, bounds);
}

// What is as far from the light is within a square about it: its corners, projected.
void vtkGodRaysLight::GetBoundsAbout(
  const vtkGodRaysView& view, double radius, const int size[2], int bounds[4]) const
{
  const double largest = 1.0; // [radians]
  if (!this->Planar && (view.Parallel || radius > largest))
  {
    const int whole[4] = { 0, size[0], 0, size[1] };
    std::copy_n(whole, 4, bounds);
    return;
  }
  const double half = this->Planar ? radius : std::tan(radius);
  double right[3] = { 1.0, 0.0, 0.0 };
  double up[3] = { 0.0, 1.0, 0.0 };
  if (!this->Planar)
  {
    vtkMath::Perpendiculars(this->Direction, right, up, 0.0);
  }
  double corners[4][4];
  for (int corner = 0; corner < 4; ++corner)
  {
    const double* center = this->Planar ? this->Position : this->Direction;
    corners[corner][3] = this->Planar ? 1.0 : 0.0;
    for (int i = 0; i < 3; ++i)
    {
      corners[corner][i] =
        center[i] + half * ((corner & 1 ? right[i] : -right[i]) + (corner & 2 ? up[i] : -up[i]));
    }
  }
  const double margin = 3.0; // for the soft edge [pixels]
  view.GetHullBounds(corners, 4, size, margin, bounds);
}

bool vtkGodRaysLight::Reaches(const vtkGodRaysView& view, bool glows) const
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
