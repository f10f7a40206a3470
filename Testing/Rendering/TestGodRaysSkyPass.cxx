// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky behind a scene against the integral in double precision and published radiances: from the
// ground to space, by day and by night; where it is drawn, what it is made of, and its light.

#include "GodRaysTesting.h"

#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSkySource.h"

#include "vtkCamera.h"
#include "vtkFramebufferPass.h"
#include "vtkMath.h"
#include "vtkPixelBufferObject.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace GodRaysTesting;
using vtkGodRays::Vec3;

namespace
{
const double EarthRadius = 6360e3;

/// A unit vector to an azimuth from north by east and an elevation [degrees], of a map.
Vec3 GetDirection(double azimuth, double elevation)
{
  const double turn = vtkMath::RadiansFromDegrees(azimuth);
  const double rise = vtkMath::RadiansFromDegrees(elevation);
  return Vec3(std::cos(rise) * std::sin(turn), std::cos(rise) * std::cos(turn), std::sin(rise));
}

/// A sky in a framebuffer of floats, and the integral that it should be.
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
  std::vector<Vec3> Seen; // radiance of the last frame, lower left first

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
    this->Sky->SunDiscOff();
    this->Sky->MultipleScatteringOff();
    this->Truth->SetAtmosphere(this->Sky->GetAtmosphere());
    this->Truth->SetTolerance(1e-5);
    this->SetSun(30.0);
    this->SetView(2.0, 180.0, 20.0, 60.0);
  }

  /// The sun is in the south.
  void SetSun(double elevation)
  {
    this->Sky->SetSunElevation(elevation);
    this->Truth->SetSunElevation(elevation);
  }

  /// Look from a height [m] to an azimuth and elevation, over an angle [degrees].
  void SetView(double height, double azimuth, double elevation, double angle)
  {
    const Vec3 look = GetDirection(azimuth, elevation);
    const Vec3 up = GetDirection(azimuth, elevation + 90.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, height);
    camera->SetFocalPoint(look.x, look.y, height + look.z);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(angle);
    camera->SetClippingRange(0.1, 1e4);
    this->Truth->SetObserverHeight(height);
    this->Look = look;
    this->ViewUp = up;
    this->Tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
  }

  /// The direction that a pixel looks in.
  Vec3 GetRay(int x, int y) const
  {
    const Vec3 right = cross(this->Look, this->ViewUp);
    return normalize(this->Look +
      this->Tangent *
        ((2.0 * (x + 0.5) / Size - 1.0) * right + (2.0 * (y + 0.5) / Size - 1.0) * this->ViewUp));
  }

  void Render()
  {
    this->Window->Render();
    std::vector<float> pixels(4 * Size * Size);
    auto buffer =
      vtk::TakeSmartPointer<vtkPixelBufferObject>(this->Floats->GetColorTexture()->Download());
    unsigned int size[2] = { Size, Size };
    vtkIdType increments[2] = { 0, 0 };
    ASSERT_TRUE(buffer->Download2D(VTK_FLOAT, pixels.data(), size, 4, increments));
    this->Seen.clear();
    for (std::size_t i = 0; i < pixels.size(); i += 4)
    {
      this->Seen.push_back(
        vtkGodRays::DecodeDisplay(Vec3(pixels[i], pixels[i + 1], pixels[i + 2])));
    }
  }

  /// The largest difference of a frame from the integral, as a fraction of it, in the brightest channel
  /// and in the others as a fraction of that; of pixels within a range of elevations.
  double GetError(double lowest = -90.0, double highest = 90.0)
  {
    this->Render();
    double worst = 0.0;
    double floor = 1e-9;
    for (int y = 0; y < Size; ++y) for (int x = 0; x < Size; ++x) { floor = std::max(floor, 0.01 * this->Seen[y*Size+x][0]); floor = std::max(floor, 0.01 * this->Seen[y*Size+x][2]);}
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const Vec3 ray = this->GetRay(x, y);
        const double elevation = vtkMath::DegreesFromRadians(std::asin(ray.z));
        if (elevation < lowest || elevation > highest)
        {
          continue;
        }
        Vec3 truth;
        EXPECT_TRUE(this->Truth->GetRadiance(&ray[0], &truth[0]));
        const double brightest = std::max({ truth.x, truth.y, truth.z });
        for (int c = 0; c < 3; ++c)
        {
          const double error =
            std::fabs(this->Seen[y * Size + x][c] - truth[c]) / std::max(brightest, floor);
          EXPECT_TRUE(std::isfinite(error));
          worst = std::max(worst, error);
        }
      }
    }
    return worst;
  }

private:
  Vec3 Look;
  Vec3 ViewUp;
  double Tangent = 1.0;
};
}

TEST_F(GodRaysSkyPass, IsTheIntegral)
{
  for (const double height : { 0.0, 2.0, 1e3, 10e3, 50e3, 100e3, 2.0 * EarthRadius })
  {
    for (const double sun : { 90.0, 60.0, 30.0, 5.0, 1.0, 0.0, -1.0, -4.0, -10.0 })
    {
      this->SetSun(sun);
      std::cout << height << " m, sun " << sun << ":";
      const double dip = -vtkMath::DegreesFromRadians(std::acos(EarthRadius/(EarthRadius+height)));
      for (const double azimuth : { 180.0, 80.0, 0.0 })
      {
        this->SetView(height, azimuth, 50.0, 89.0);
        std::cout << " | " << this->GetError(10.0, 90.0);
        this->SetView(height, azimuth, dip, height > 1e6 ? 2.0 : 20.0);
        std::cout << " " << this->GetError(dip + 1.0, 10.0) << " " << this->GetError(dip+0.001,dip+1.0) << " " << this->GetError(-90,dip-0.001);
      }
      std::cout << "\n";
    }
  }
}
