// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysAirlight.h
 * @brief   light that a medium scatters where nothing casts a shadow, for tests of its tables
 */

#ifndef GodRaysAirlight_h
#define GodRaysAirlight_h

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMediumFilter.h"

#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace GodRaysMediumScenes
{
// A filter's camera, light and medium, as vtkGodRaysInScattering computes them.
class Airlight : public vtkGodRaysMediumFilter
{
public:
  vtkTypeMacro(Airlight, vtkGodRaysMediumFilter);
  static Airlight* New()
  {
    auto* result = new Airlight;
    result->InitializeObjectBase();
    return result;
  }

  // Draws a picture whose view rays end at these depths.
  GodRaysFiltersTesting::Picture Draw(const GodRaysFiltersTesting::Picture& ends)
  {
    const View view = this->GetView(ends.Height);
    vtkGodRaysInScattering::Parameters parameters;
    parameters.PixelSize = view.PixelSize;
    parameters.Center[0] = 0.5 * ends.Width;
    parameters.Center[1] = 0.5 * ends.Height;
    parameters.Parallel = view.Parallel;
    double light[3];
    for (int i = 0; i < 3; ++i)
    {
      light[i] = this->Light[i] - this->Light[3] * view.Position[i];
    }
    parameters.Light[0] = vtkMath::Dot(light, view.Right);
    parameters.Light[1] = vtkMath::Dot(light, view.Up);
    parameters.Light[2] = vtkMath::Dot(light, view.Forward);
    parameters.Light[3] = this->Light[3];
    std::copy_n(this->LightColor, 3, parameters.LightColor);
    parameters.Medium = this->GetMedium(view);
    parameters.Spot = this->GetSpot(view);
    parameters.Tolerance = 1e-4;
    float* input = this->Walk.PrepareInput(ends.Width, ends.Height);
    std::transform(ends.Values.begin(), ends.Values.end(), input,
      [](double end)
      { return static_cast<float>(std::min<double>(end, vtkGodRaysInScattering::Sky)); });
    EXPECT_TRUE(this->Walk.Execute(parameters));
    GodRaysFiltersTesting::Picture picture(
      ends.Width, ends.Height, this->Walk.GetNumberOfComponents());
    std::copy_n(this->Walk.GetResult(), picture.Values.size(), picture.Values.begin());
    return picture;
  }

  std::string Describe() const { return this->Walk.Describe(); }

protected:
  Airlight() = default;
  ~Airlight() override = default;

private:
  vtkGodRaysInScattering Walk;
};

// The pixel in which the light is seen, or -1: there the truth is of a ray through the pixel's centre, what
// is drawn the mean over the pixel.
inline vtkIdType FindLight(vtkGodRaysMediumFilter* filter, const int size[2])
{
  const double* light = filter->GetLight();
  const double halfHeight = filter->GetParallelProjection()
    ? filter->GetParallelScale()
    : -light[2] * std::tan(0.5 * vtkMath::RadiansFromDegrees(filter->GetViewAngle()));
  const double perUnit = 0.5 * size[1] / halfHeight;
  const double x = std::floor(light[0] * perUnit + 0.5 * size[0]);
  const double y = std::floor(light[1] * perUnit + 0.5 * size[1]);
  const bool isShown = halfHeight > 0.0 && x >= 0.0 && y >= 0.0 && x < size[0] && y < size[1];
  return isShown ? static_cast<vtkIdType>(y * size[0] + x) : -1;
}

// Fractions of the truth's peak.
struct Error
{
  double Rms = 0.0;
  double Largest = 0.0;
};

// Compares the red of a ground truth with what is drawn to the same ends of view rays, but for one pixel.
inline Error Compare(vtkImageData* truth, Airlight* airlight, vtkIdType left = -1)
{
  vtkDataArray* ends = truth->GetPointData()->GetArray("End");
  vtkDataArray* expected = truth->GetPointData()->GetArray("Radiance");
  const int width = truth->GetDimensions()[0];
  const GodRaysFiltersTesting::Picture drawn =
    airlight->Draw(GodRaysFiltersTesting::MakePicture(width, truth->GetDimensions()[1],
      [&](int x, int y) { return ends->GetComponent(static_cast<vtkIdType>(y) * width + x, 0); }));
  const vtkIdType pixels = expected->GetNumberOfTuples();
  double squares = 0.0;
  double peak = 0.0;
  Error error;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    if (i == left)
    {
      continue;
    }
    const double value = expected->GetComponent(i, 0);
    const double difference =
      std::abs(drawn.Values[static_cast<std::size_t>(i) * drawn.Components] - value);
    squares += difference * difference;
    error.Largest = std::max(error.Largest, difference);
    peak = std::max(peak, value);
  }
  return { std::sqrt(squares / static_cast<double>(pixels)) / peak, error.Largest / peak };
}
}

#endif
