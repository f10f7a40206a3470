// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What tests of the sky have in common: a sky in a framebuffer of floats beside the integral that it should
/// be.

#ifndef GodRaysSkyTesting_h
#define GodRaysSkyTesting_h

#include "GodRaysTesting.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysSkyAtmosphere.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSkySource.h"

#include "vtkCamera.h"
#include "vtkFramebufferPass.h"
#include "vtkMath.h"
#include "vtkPixelBufferObject.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace GodRaysTesting
{
using vtkGodRays::Vec3;

constexpr double EarthRadius = 6360e3;

inline double GetBrightest(const Vec3& color)
{
  return std::max({ color.x, color.y, color.z });
}

/// A unit vector to an azimuth from north by east and an elevation [degrees], of a map.
inline Vec3 GetDirection(double azimuth, double elevation)
{
  const double turn = vtkMath::RadiansFromDegrees(azimuth);
  const double rise = vtkMath::RadiansFromDegrees(elevation);
  return Vec3(std::cos(rise) * std::sin(turn), std::cos(rise) * std::cos(turn), std::sin(rise));
}

/// The elevation at which the ground's horizon is seen [degrees].
inline double GetHorizon(double height)
{
  return -vtkMath::DegreesFromRadians(std::acos(EarthRadius / (EarthRadius + height)));
}

/// A sky in a framebuffer of floats, and the integral that it should be. The sun is in the south.
class GodRaysSkyPass : public ::testing::Test
{
protected:
  static constexpr int Size = 48;

  Messages Said;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkFramebufferPass> Floats;
  vtkNew<vtkGodRaysSkyPass> Sky;
  vtkNew<vtkGodRaysSkySource> Truth;
  std::vector<Vec3> Seen; // linear light of the last frame, lower left first
  int Every = 13;         // pixel is compared, which is from all rows and columns

  GodRaysSkyPass()
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetSize(Size, Size);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    this->Floats->SetColorFormat(vtkTextureObject::Float32);
    this->Floats->SetDelegatePass(this->Sky);
    this->Renderer->SetPass(this->Floats);
    this->Sky->SetExposure(1.0);
    this->Sky->WhiteBalanceOff(); // radiances as they are
    this->Sky->SunDiscOff();
    this->Sky->MultipleScatteringOff();
    this->Truth->SetAtmosphere(this->Sky->GetAtmosphere());
    this->SetSun(30.0);
    this->SetView(2.0, 180.0, 20.0, 60.0);
  }

  void SetSun(double elevation)
  {
    this->Sky->SetSunElevation(elevation);
    this->Truth->SetSunElevation(elevation);
  }

  void SetMultipleScattering(bool multiple)
  {
    this->Sky->SetMultipleScattering(multiple);
    this->Truth->SetMultipleScattering(multiple);
  }

  /// Look from a height [m] to an azimuth and elevation, over an angle [degrees].
  void SetView(double height, double azimuth, double elevation, double angle)
  {
    this->Eye = Vec3(0.0, 0.0, height);
    this->Look = GetDirection(azimuth, elevation);
    this->ViewUp = GetDirection(azimuth, elevation + 90.0);
    this->Tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
    this->Truth->SetObserverHeight(std::max(height, 0.0));
    this->PlaceCamera(Vec3(0.0), 1.0);
  }

  /// The same view in a world that is moved, and whose unit is so many metres.
  void PlaceCamera(const Vec3& origin, double unit)
  {
    const Vec3 eye = origin + this->Eye / unit;
    const Vec3 focus = eye + 1e3 / unit * this->Look;
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(this->ViewUp.x, this->ViewUp.y, this->ViewUp.z);
    camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(this->Tangent)));
    camera->SetClippingRange(0.1 / unit, 1e4 / unit);
  }

  /// The direction that a pixel looks in.
  Vec3 GetRay(int x, int y) const
  {
    const Vec3 right = cross(this->Look, this->ViewUp);
    return normalize(this->Look +
      this->Tangent *
        ((2.0 * (x + 0.5) / Size - 1.0) * right + (2.0 * (y + 0.5) / Size - 1.0) * this->ViewUp));
  }

  Vec3 GetTruth(const Vec3& ray)
  {
    Vec3 truth;
    EXPECT_TRUE(this->Truth->GetRadiance(&ray[0], &truth[0]));
    return truth;
  }

  const std::vector<Vec3>& Render()
  {
    this->Window->Render();
    std::vector<float> pixels(4 * Size * Size);
    auto buffer =
      vtk::TakeSmartPointer<vtkPixelBufferObject>(this->Floats->GetColorTexture()->Download());
    unsigned int size[2] = { Size, Size };
    vtkIdType increments[2] = { 0, 0 };
    EXPECT_TRUE(buffer->Download2D(VTK_FLOAT, pixels.data(), size, 4, increments));
    this->Seen.clear();
    for (std::size_t i = 0; i < pixels.size(); i += 4)
    {
      const Vec3 shown(pixels[i], pixels[i + 1], pixels[i + 2]);
      EXPECT_TRUE(std::isfinite(shown.x + shown.y + shown.z));
      this->Seen.push_back(vtkGodRays::DecodeDisplay(shown));
    }
    return this->Seen;
  }

  /// Light of a frame, and what it should be, in directions of some elevations.
  struct Pair
  {
    Vec3 Seen;
    Vec3 Truth;
  };
  void AddPairs(std::vector<Pair>& pairs, double lowest, double highest)
  {
    this->Render();
    for (int i = 0; i < Size * Size; i += this->Every)
    {
      const Vec3 ray = this->GetRay(i % Size, i / Size);
      const double elevation = vtkMath::DegreesFromRadians(std::asin(ray.z));
      if (elevation > lowest && elevation < highest)
      {
        pairs.push_back({ this->Seen[i], this->GetTruth(ray) });
      }
    }
  }

  /// The largest error, as a fraction of the brightest colour that there should be, and of at least a part
  /// of the brightest of all.
  static double GetError(const std::vector<Pair>& pairs, double least)
  {
    double floor = 1e-30;
    for (const Pair& pair : pairs)
    {
      floor = std::max(floor, least * GetBrightest(pair.Truth));
    }
    double worst = 0.0;
    for (const Pair& pair : pairs)
    {
      worst = std::max(worst,
        GetBrightest(abs(pair.Seen - pair.Truth)) / std::max(floor, GetBrightest(pair.Truth)));
    }
    return worst;
  }

  /// The same of views to and away from the sun and across: of the horizon, or the planet's edge, and of
  /// what is above.
  double GetErrorOfSky(double height, double sun, double least)
  {
    this->SetSun(sun);
    const double horizon = GetHorizon(height);
    std::vector<Pair> pairs;
    for (const double azimuth : { 180.0, 85.0, 0.0 })
    {
      // a pixel's middle is not as exact as the horizon
      this->SetView(height, azimuth, horizon, height > 1e6 ? 2.0 : 20.0);
      this->AddPairs(pairs, horizon + 1e-3, 90.0);
      this->AddPairs(pairs, -90.0, horizon - 1e-3);
      this->SetView(height, azimuth, 50.0, 89.0);
      this->AddPairs(pairs, 0.0, 90.0);
    }
    return GetError(pairs, least);
  }

  Vec3 Eye;
  Vec3 Look;
  Vec3 ViewUp;
  double Tangent = 1.0;
};
}

#endif
