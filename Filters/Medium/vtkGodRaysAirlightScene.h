// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysAirlightScene.h
 * @brief   what the airlight of a picture depends on
 *
 * Private. See vtkGodRaysAirlight.
 */

#ifndef vtkGodRaysAirlightScene_h
#define vtkGodRaysAirlightScene_h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"

#include <algorithm>
#include <cmath>

/// View coordinates are x to the right, y up, z forwards, with the eye at the origin.
struct vtkGodRaysAirlightScene
{
  int Size[2] = { 0, 0 };              // of the picture [pixels]
  double Tolerance = 1e-3;             // of a spotlight's fade, of the light [0, 1]
  double PixelSize = 0.0;              // at depth 1, or of a parallel projection [scene units]
  double Center[2] = { 0.0, 0.0 };     // of the view axis; whole numbers are centres of pixels
  bool Parallel = false;               // projection
  bool Point = false;                  // light
  double Light[3] = { 0.0, 1.0, 0.0 }; // position, or direction to it, of length 1
  vtkGodRaysSpot Spot;
  vtkGodRaysMedium Medium;
  bool Colored = false; // whether one channel does not serve all, e.g. for coloured shadows

  ///@{
  /// Found by vtkGodRaysAirlight.
  int Channels = 1;         // 1 or 3
  int Components = 1;       // planes of channel c are c + k Channels
  double LightHeight = 0.0; // of a point light
  double Nearest = 0.0;     // that it is to a view ray
  ///@}

  int GetNumberOfPlanes() const { return this->Channels * this->Components; }

  /// The view ray through a place of the picture [pixels].
  void GetRay(double x, double y, double origin[3], double direction[3]) const
  {
    const double place[2] = { (x - this->Center[0]) * this->PixelSize,
      (y - this->Center[1]) * this->PixelSize };
    const double inverse = 1.0 / this->GetLengthPerDepth(x, y);
    for (int i = 0; i < 2; ++i)
    {
      origin[i] = this->Parallel ? place[i] : 0.0;
      direction[i] = this->Parallel ? 0.0 : inverse * place[i];
    }
    origin[2] = 0.0;
    direction[2] = inverse;
  }

  /// Length of the view ray for each unit of view depth.
  double GetLengthPerDepth(double x, double y) const
  {
    const double across = this->Parallel ? 0.0 : (x - this->Center[0]) * this->PixelSize;
    const double along = this->Parallel ? 0.0 : (y - this->Center[1]) * this->PixelSize;
    return std::sqrt(1.0 + across * across + along * along);
  }

  /// How a view ray passes a point light, and how long it is at most.
  void GetPass(float x, float y, float& foot, float& height, float& end) const
  {
    const float pixel = static_cast<float>(this->PixelSize);
    const float px = (x - static_cast<float>(this->Center[0])) * pixel;
    const float py = (y - static_cast<float>(this->Center[1])) * pixel;
    const float farLimit = static_cast<float>(this->Medium.FarLimit);
    float to[3];
    for (int i = 0; i < 3; ++i)
    {
      to[i] = static_cast<float>(this->Light[i]);
    }
    if (this->Parallel)
    {
      to[0] -= px;
      to[1] -= py;
      foot = to[2];
      height = std::sqrt(to[0] * to[0] + to[1] * to[1]);
      end = farLimit;
    }
    else
    {
      const float length = std::sqrt(1.0f + px * px + py * py);
      const float inverse = 1.0f / length;
      foot = (to[0] * px + to[1] * py + to[2]) * inverse;
      const float a = to[1] - to[2] * py;
      const float b = to[2] * px - to[0];
      const float c = to[0] * py - to[1] * px;
      height = std::sqrt(a * a + b * b + c * c) * inverse;
      end = farLimit * length;
    }
    height = std::max(height, static_cast<float>(this->Nearest));
  }
};

namespace vtkGodRays
{
inline Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

// The geometry of a point light and a ray, in the coordinate of its splines: t = q/(1 + q), q^2 being the
// tangent of half the scattering angle, is about even in the angle at the light, and denser far from it on
// both sides. T is a floating-point type.
template <typename T>
struct PointRay
{
  T Foot;   // where the ray is nearest to the light
  T Height; // how near
  T Start;  // t of the ray's start
  T Length; // of its end, less Start

  T GetCoordinate(T distance) const
  {
    const T beyond = distance - this->Foot;
    const T r = std::sqrt(this->Height * this->Height + beyond * beyond);
    const T y = beyond > 0 ? r + beyond : this->Height * (this->Height / (r - beyond));
    const T root = std::sqrt(y);
    return root / (root + std::sqrt(this->Height));
  }

  T GetDistance(T t) const
  {
    const T root = std::max(t, T(1e-15)) / std::max(1 - t, T(1e-15));
    const T ratio = root * root;
    return this->Foot + T(0.5) * this->Height * (ratio - 1 / ratio);
  }

  void Set(T foot, T height, T end)
  {
    this->Foot = foot;
    this->Height = height;
    this->Start = this->GetCoordinate(0);
    this->Length = std::max(this->GetCoordinate(end) - this->Start, T(1e-12));
  }
};
}

#endif
