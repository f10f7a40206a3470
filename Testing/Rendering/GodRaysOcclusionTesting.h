// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of vtkGodRaysOcclusionPass share: their fixture, sums over its layer, fog.

#ifndef GodRaysOcclusionTesting_h
#define GodRaysOcclusionTesting_h

#include "GodRaysTesting.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace GodRaysTesting
{
constexpr int Width = 128;
constexpr int Height = 96;

/// The stage with 32-bit layers and no glow, so that the layer holds what a test puts there.
class GodRaysOcclusion : public ::testing::Test
{
protected:
  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;

  GodRaysOcclusion()
  {
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
    this->Rays->SetBackgroundGlow(0.0);
    this->Rays->Attach(this->Renderer);
  }

  vtkSmartPointer<vtkLight> AddSun(
    std::array<double, 3> towards, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    auto sun = MakeSun(towards, color);
    this->Rays->AddLight(sun);
    return sun;
  }

  vtkSmartPointer<vtkActor> AddBox(std::array<double, 3> center, std::array<double, 3> size)
  {
    auto box = MakeBox(center, size);
    this->Renderer->AddActor(box);
    return box;
  }

  vtkSmartPointer<vtkActor> AddLamp(
    std::array<double, 3> center, double radius, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    auto lamp = MakeLamp(center, radius, color);
    vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
    this->Renderer->AddActor(lamp);
    return lamp;
  }

  /// The layer of a new frame.
  vtkSmartPointer<vtkImageData> GetLayer()
  {
    this->Scene.Window->Render();
    auto layer = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetOcclusionImage(layer)) << this->Rays->GetPlan();
    return layer;
  }

  vtkSmartPointer<vtkImageData> GetScattering()
  {
    this->Scene.Window->Render();
    auto scattering = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetScatteringImage(scattering)) << this->Rays->GetPlan();
    return scattering;
  }

  /// Window depths of the scene without rays.
  std::vector<float> GetSceneDepths()
  {
    const double intensity = this->Rays->GetIntensity();
    this->Rays->SetIntensity(0.0);
    auto depths = GetDepths(this->Scene.Window);
    this->Rays->SetIntensity(intensity);
    return depths;
  }
};

/// Call a function for each pixel of an image.
inline void ForEachPixel(vtkImageData* image, const std::function<void(int x, int y)>& visit)
{
  const int* size = image->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      visit(x, y);
    }
  }
}

/// Sum of a channel over all pixels.
inline double GetSum(vtkImageData* image, int channel = 0)
{
  double sum = 0.0;
  ForEachPixel(image, [&](int x, int y) { sum += GetValue(image, x, y, channel); });
  return sum;
}

/// Largest difference of two images in all channels.
inline double GetLargestDifference(vtkImageData* a, vtkImageData* b)
{
  const int* sizes[] = { a->GetDimensions(), b->GetDimensions() };
  EXPECT_TRUE(std::equal(sizes[0], sizes[0] + 3, sizes[1]));
  double largest = 0.0;
  ForEachPixel(a,
    [&](int x, int y)
    {
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(GetValue(a, x, y, c) - GetValue(b, x, y, c)));
      }
    });
  return largest;
}

/// Half the height of the stage's picture at distance 1.
inline double GetTangent(vtkRenderer* renderer)
{
  return std::tan(0.5 * vtkMath::RadiansFromDegrees(renderer->GetActiveCamera()->GetViewAngle()));
}

/// A box of 4 x 4 x 2 about a centre in which light fades to transmittance^thickness.
inline vtkSmartPointer<vtkVolume> MakeFog(
  vtkVolumeMapper* mapper, std::array<double, 3> center, double transmittance, int voxels = 9)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(voxels, voxels, voxels);
  image->SetSpacing(4.0 / (voxels - 1), 4.0 / (voxels - 1), 2.0 / (voxels - 1));
  image->SetOrigin(center[0] - 2.0, center[1] - 2.0, center[2] - 1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
    static_cast<unsigned char>(100));
  mapper->SetInputData(image);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1.0 - transmittance);
  opacity->AddPoint(255.0, 1.0 - transmittance);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.5, 0.5, 0.5);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->ShadeOff();
  return volume;
}
}

#endif
