// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The scene of which DataErrors.h measures pictures: smoke over hills, half in the shadow of a ridge, a sun.

#ifndef DataScene_h
#define DataScene_h

#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMath.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace DataMedium
{
using vtkGodRays::Vec3;
using Parameters = vtkGodRaysSingleScattering::Parameters;

const double ViewAngle = 57.3;
const double FarLimit = 30.0;
const double Asymmetry = 0.5;
const double Albedo = 0.9;

/// One value a pixel.
using Picture = std::vector<float>;

//------------------------------------------------------------------------------
/// Smoke, terrain, sun and a camera in the origin that looks along -z.
class Scene
{
public:
  Scene(int points, int width, int height, int mapSize);

  double GetPixelSize() const
  {
    return 2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle)) / this->Height;
  }
  double GetX(int column) const
  {
    return (column + 0.5 - 0.5 * this->Width) * this->GetPixelSize();
  }
  double GetY(int row) const { return (row + 0.5 - 0.5 * this->Height) * this->GetPixelSize(); }
  std::size_t GetPixel(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->Width + column;
  }

  /// Whether the terrain leaves a place to the sun, as the shadow map has it.
  bool IsLit(const Vec3& place) const
  {
    const double view[3] = { place.x, place.y, -place.z };
    return this->Shadows.GetHeight(view) <= vtkGodRays::dot(place, this->ToSun);
  }

  /// Extinction at a place of the grid [1/scene unit].
  float GetExtinction(const Vec3& place) const
  {
    int first[3];
    Vec3 offset(0.0);
    for (int i = 0; i < 3; ++i)
    {
      if (!(place[i] >= 0.0 && place[i] <= this->Grid.Points[i] - 1))
      {
        return 0.0f;
      }
      first[i] = std::min(static_cast<int>(place[i]), this->Grid.Points[i] - 2);
      offset[i] = place[i] - first[i];
    }
    const float* v = this->Extinction + this->Grid.GetPoint(first[0], first[1], first[2]);
    const std::ptrdiff_t row = this->Grid.Points[0];
    const std::ptrdiff_t slice = row * this->Grid.Points[1];
    const auto mix = [](float a, float b, double t) { return a + static_cast<float>(t) * (b - a); };
    const auto plane = [&](const float* p)
    { return mix(mix(p[0], p[1], offset.x), mix(p[row], p[row + 1], offset.x), offset.y); };
    return mix(plane(v), plane(v + slice), offset.z);
  }

  int Width;
  int Height;
  vtkSmartPointer<vtkImageData> Smoke;
  vtkSmartPointer<vtkPolyData> Terrain;
  vtkGodRaysGrid Grid;
  const float* Extinction; // of the smoke
  Vec3 ToSun;
  Parameters Clear; // smoke alone
  Parameters Hazy;
  Picture Depths; // view depths of the terrain, at most FarLimit
  vtkGodRaysShadowGrids Shadows;

private:
  void FindDepths();
  void DrawMap(int size);

  Picture Map;
};
}

#endif
