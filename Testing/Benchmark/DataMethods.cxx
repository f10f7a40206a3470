// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataMethods.h"

#include "Froxels.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <limits>

namespace DataMedium
{
namespace
{
// Radiance towards the eye of a place for each unit of length, before extinction on the way to the eye.
float GetSource(double phase, float extinction, double sunDepth)
{
  return static_cast<float>(Albedo * extinction * phase * std::exp(-sunDepth));
}

//------------------------------------------------------------------------------
// The optical depth of the sun's way to a place of the grid, by equal steps to the grid's border.
double MarchToSun(const Scene& scene, const Vec3& place, int steps)
{
  const Vec3 change = scene.Grid.GetSteps(scene.ToSun);
  double begin = 0.0;
  double end = 1e30;
  if (!scene.Grid.Clip(place, change, begin, end))
  {
    return 0.0;
  }
  const double length = (end - begin) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    sum += scene.GetExtinction(place + (begin + (i + 0.5) * length) * change);
  }
  return sum * length;
}
}

//------------------------------------------------------------------------------
void March(const Scene& scene, int steps, int rowStride, Picture& picture)
{
  picture.assign(scene.Depths.size(), std::numeric_limits<float>::quiet_NaN());
  const int sunSteps = std::max(steps / 8, 8);
  const int rows = (scene.Height + rowStride - 1) / rowStride;
  vtkSMPTools::For(0, rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType k = first; k < last; ++k)
      {
        const int row = static_cast<int>(k) * rowStride;
        for (int column = 0; column < scene.Width; ++column)
        {
          const std::size_t pixel = scene.GetPixel(column, row);
          const Vec3 way(scene.GetX(column), scene.GetY(row), -1.0);
          const double perDepth = vtkGodRays::length(way);
          const Vec3 along = way / perDepth;
          const Vec3 place = scene.Grid.GetPlace(Vec3(0.0));
          const Vec3 change = scene.Grid.GetSteps(along);
          double begin = 0.0;
          double end = perDepth * scene.Depths[pixel];
          float light = 0.0f;
          if (scene.Grid.Clip(place, change, begin, end))
          {
            const double phase =
              vtkGodRays::Phase({ 2, Asymmetry }, vtkGodRays::dot(along, scene.ToSun));
            const double length = (end - begin) / steps;
            double through = 1.0;
            for (int i = 0; i < steps; ++i)
            {
              const double s = begin + (i + 0.5) * length;
              const Vec3 here = place + s * change;
              const float extinction = scene.GetExtinction(here);
              if (extinction > 0.0f)
              {
                const double left = std::exp(-extinction * length);
                if (scene.IsLit(s * along))
                {
                  light += static_cast<float>(through * (1.0 - left) / extinction *
                    GetSource(phase, extinction, MarchToSun(scene, here, sunSteps)));
                }
                through *= left;
              }
            }
          }
          picture[pixel] = light;
        }
      }
    });
}

//------------------------------------------------------------------------------
void DrawFroxels(const Scene& scene, int slices, Picture& picture)
{
  const int columns = 160;
  const int rows = 90;
  const double nearest = 2.0;
  const double farthest = 12.0;
  const auto getDepth = [&](double slice)
  { return nearest * std::pow(farthest / nearest, slice / slices); };
  Froxels froxels(columns, rows, slices, 1);
  vtkSMPTools::For(0, rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (int j = static_cast<int>(first); j < last; ++j)
      {
        for (int i = 0; i < columns; ++i)
        {
          const double x =
            ((i + 0.5) * scene.Width / columns - 0.5 * scene.Width) * scene.GetPixelSize();
          const double y =
            ((j + 0.5) * scene.Height / rows - 0.5 * scene.Height) * scene.GetPixelSize();
          const Vec3 way(x, y, -1.0);
          const double perDepth = vtkGodRays::length(way);
          const double phase =
            vtkGodRays::Phase({ 2, Asymmetry }, vtkGodRays::dot(way, scene.ToSun) / perDepth);
          double through = 1.0;
          float* sum = froxels.GetSums(i, j);
          for (int k = 0; k < slices; ++k)
          {
            const Vec3 world = getDepth(k + 0.5) * way;
            const Vec3 here = scene.Grid.GetPlace(world);
            const float extinction = scene.GetExtinction(here);
            sum[k + 1] = sum[k];
            if (extinction > 0.0f)
            {
              const double left =
                std::exp(-extinction * perDepth * (getDepth(k + 1.0) - getDepth(k)));
              if (scene.IsLit(world))
              {
                sum[k + 1] += static_cast<float>(through * (1.0 - left) / extinction *
                  GetSource(phase, extinction, MarchToSun(scene, here, 32)));
              }
              through *= left;
            }
          }
        }
      }
    });
  picture.resize(scene.Depths.size());
  vtkSMPTools::For(0, scene.Height, 16,
    [&](vtkIdType first, vtkIdType last)
    {
      for (int row = static_cast<int>(first); row < last; ++row)
      {
        for (int column = 0; column < scene.Width; ++column)
        {
          const std::size_t pixel = scene.GetPixel(column, row);
          const double slice = std::log(std::max<double>(scene.Depths[pixel] / nearest, 1.0)) *
            slices / std::log(farthest / nearest);
          froxels.Read(
            (column + 0.5) / scene.Width, (row + 0.5) / scene.Height, slice, &picture[pixel]);
        }
      }
    });
}

#if HAS_SCATTERING_MAPPER
//------------------------------------------------------------------------------
Mapper::Mapper(Device& device, const Scene& scene)
  : OpenGL(device)
{
  const double highest = scene.Smoke->GetScalarRange()[1];
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int i = 0; i <= 256; ++i)
  {
    const double extinction = highest * i / 256.0;
    opacity->AddPoint(extinction, 1.0 - std::exp(-extinction));
  }
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  white->AddRGBPoint(highest, 1.0, 1.0, 1.0);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(scene.Smoke);
  mapper->SetVolumetricScatteringBlending(2.0f); // its own word for all of it
  mapper->SetGlobalIlluminationReach(1.0f);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  volume->GetProperty()->SetColor(white);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->ShadeOn();
  volume->GetProperty()->SetAmbient(0.0);
  volume->GetProperty()->SetDiffuse(1.0);
  volume->GetProperty()->SetSpecular(0.0);
  volume->GetProperty()->SetScatteringAnisotropy(static_cast<float>(Asymmetry));
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputData(scene.Terrain);
  vtkNew<vtkActor> terrain;
  terrain->SetMapper(surface);
  terrain->GetProperty()->LightingOff();
  terrain->GetProperty()->SetColor(0.0, 0.0, 0.0);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPosition(scene.ToSun.x, scene.ToSun.y, scene.ToSun.z);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewAngle(ViewAngle);
  camera->SetClippingRange(0.1, 100.0);
  this->Renderer->AddLight(light);
  this->Renderer->AddVolume(volume);
  this->Renderer->AddActor(terrain);
  device.GetWindow()->SetSize(scene.Width, scene.Height);
  device.GetWindow()->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
Mapper::~Mapper()
{
  this->OpenGL.GetWindow()->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void Mapper::Draw(Picture& picture)
{
  vtkRenderWindow* window = this->OpenGL.GetWindow();
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  picture.resize(pixels->GetNumberOfTuples());
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    picture[i] = pixels->GetValue(3 * static_cast<vtkIdType>(i)) / 255.0f;
  }
}
#endif
}
