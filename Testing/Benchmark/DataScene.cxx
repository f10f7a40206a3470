// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataScene.h"

#include "GodRaysGridScenes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

namespace DataMedium
{
namespace
{
const Vec3 Sun(-0.78, 0.3, -0.55); // towards it
const double HazeScattering = 0.03;

//------------------------------------------------------------------------------
/// Hills below the smoke, and a ridge that shadows part of it.
vtkSmartPointer<vtkPolyData> MakeTerrain(int parts)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i <= parts; ++i)
    {
      const double x = -9.0 + 18.0 * i / parts;
      const double z = -1.0 - 18.0 * j / parts;
      const double hills =
        0.25 * std::sin(1.9 * x + 0.6) * std::cos(1.4 * z) + 0.1 * std::sin(4.1 * x - 3.3 * z);
      const double aside = x + 3.4 + 0.35 * std::sin(0.9 * z);
      const double ridge = 2.1 * std::exp(-aside * aside / 0.5) * (1.0 + 0.35 * std::sin(2.3 * z));
      points->InsertNextPoint(x, -2.0 + hills + ridge, z);
    }
  }
  const int row = parts + 1;
  for (int j = 0; j < parts; ++j)
  {
    for (int i = 0; i < parts; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * row + i;
      triangles->InsertNextCell({ a, a + 1, a + row + 1 });
      triangles->InsertNextCell({ a, a + row + 1, a + row });
    }
  }
  auto terrain = vtkSmartPointer<vtkPolyData>::New();
  terrain->SetPoints(points);
  terrain->SetPolys(triangles);
  return terrain;
}
}

//------------------------------------------------------------------------------
Scene::Scene(int points, int width, int height, int mapSize)
  : Width(width)
  , Height(height)
  , Smoke(GodRaysGridScenes::MakePlume(points))
  , Terrain(MakeTerrain(96))
  , Extinction(static_cast<const float*>(this->Smoke->GetScalarPointer()))
{
  this->Grid.Read(this->Smoke);
  std::fill_n(this->Grid.Albedo, 3, Albedo);
  this->Grid.PhaseFunction = 2; // Henyey and Greenstein's
  this->Grid.Asymmetry = Asymmetry;
  const double length = vtkGodRays::length(Sun);
  this->ToSun = Sun / length;
  this->Clear.Forward[2] = -1.0;
  this->Clear.Light[0] = this->ToSun.x;
  this->Clear.Light[1] = this->ToSun.y;
  this->Clear.Light[2] = this->ToSun.z;
  this->Clear.Light[3] = 0.0;
  this->Clear.Medium.FarLimit = FarLimit;
  this->Clear.Tolerance = 1.0 / 255.0;
  this->Hazy = this->Clear;
  vtkGodRaysMedium::Component& haze = this->Hazy.Medium.Components[0];
  std::fill_n(haze.Scattering, 3, HazeScattering);
  haze.PhaseFunction = 2;
  haze.Asymmetry = Asymmetry;
  this->FindDepths();
  this->DrawMap(mapSize);
}

//------------------------------------------------------------------------------
void Scene::FindDepths()
{
  vtkGodRaysSingleScattering exact;
  exact.SetParameters(this->Clear);
  exact.SetOccluders(this->Terrain);
  this->Depths.resize(static_cast<std::size_t>(this->Width) * this->Height);
  vtkSMPTools::For(0, this->Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < this->Width; ++column)
        {
          const double sight = exact.FindSight(this->GetX(column), this->GetY(row));
          this->Depths[this->GetPixel(column, row)] = static_cast<float>(std::min(sight, FarLimit));
        }
      }
    });
}

//------------------------------------------------------------------------------
// As a parallel camera at the sun sees the terrain.
void Scene::DrawMap(int size)
{
  const Vec3 right = glm::normalize(vtkGodRays::cross(Vec3(0.0, 1.0, 0.0), this->ToSun));
  const Vec3 up = vtkGodRays::cross(this->ToSun, right);
  const Vec3 middle = Vec3(0.0, 0.0, -6.0) + 20.0 * this->ToSun;
  const double extent = 5.4; // all of the smoke
  const double length = 40.0;
  Parameters camera;
  for (int i = 0; i < 3; ++i)
  {
    camera.Position[i] = middle[i];
    camera.Right[i] = right[i];
    camera.Up[i] = up[i];
    camera.Forward[i] = -this->ToSun[i];
    this->Shadows.Grids[0].Axes[0][i] = i == 2 ? -right[i] : right[i];
    this->Shadows.Grids[0].Axes[1][i] = i == 2 ? -up[i] : up[i];
  }
  camera.Parallel = true;
  camera.Medium.FarLimit = length;
  vtkGodRaysSingleScattering exact;
  exact.SetParameters(camera);
  exact.SetOccluders(this->Terrain);
  this->Map.resize(static_cast<std::size_t>(size) * size);
  const double texel = extent / size;
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType j = begin; j < end; ++j)
      {
        for (int i = 0; i < size; ++i)
        {
          const double sight =
            exact.FindSight((i + 0.5) * texel - 0.5 * extent, (j + 0.5) * texel - 0.5 * extent);
          this->Map[j * size + i] = static_cast<float>(std::min(sight / length, 1.0));
        }
      }
    });
  vtkGodRaysShadowGrids::Grid& grid = this->Shadows.Grids[0];
  grid.Depths = this->Map.data();
  grid.Stride = size;
  grid.Size[0] = grid.Size[1] = size;
  grid.Low[0] = vtkGodRays::dot(middle, right) - 0.5 * extent;
  grid.Low[1] = vtkGodRays::dot(middle, up) - 0.5 * extent;
  grid.Texel[0] = grid.Texel[1] = texel;
  this->Shadows.Levels = 1;
  this->Shadows.Range[0] = -vtkGodRays::dot(middle, this->ToSun);
  this->Shadows.Range[1] = this->Shadows.Range[0] + length;
}
}
