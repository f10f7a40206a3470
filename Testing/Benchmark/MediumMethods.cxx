// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MediumMethods.h"

#include "Froxels.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(ClosedFormIntegrator);
vtkStandardNewMacro(FroxelsIntegrator);
vtkStandardNewMacro(TreesIntegrator);

using vtkGodRays::Vec3;

namespace
{
//------------------------------------------------------------------------------
// Sums of the light before each end of the slices, of the columns of cells of a row.
void FillRow(Froxels& froxels, int row, const vtkGodRaysInScattering::Parameters& scene,
  const int size[2], int components)
{
  const vtkGodRaysMedium::Component& medium = scene.Medium.Components[0];
  const Vec3 toLight = glm::normalize(Vec3(scene.Light[0], scene.Light[1], scene.Light[2]));
  const int slices = froxels.GetSlices();
  const double y = ((row + 0.5) * size[1] / froxels.GetRows() - scene.Center[1]) * scene.PixelSize;
  for (int column = 0; column < froxels.GetColumns(); ++column)
  {
    const double x =
      ((column + 0.5) * size[0] / froxels.GetColumns() - scene.Center[0]) * scene.PixelSize;
    const Vec3 way(x, y, 1.0);
    const double perDepth = vtkGodRays::length(way);
    const double phase = vtkGodRays::Phase(
      { medium.PhaseFunction, medium.Asymmetry }, vtkGodRays::dot(way, toLight) / perDepth);
    float* sum = froxels.GetSums(column, row);
    for (int k = 0; k < slices; ++k, sum += components)
    {
      const double begin = scene.Medium.FarLimit * k * k / (slices * slices);
      const double end = scene.Medium.FarLimit * (k + 1) * (k + 1) / (slices * slices);
      const Vec3 middle = 0.5 * (begin + end) * way;
      const double place[3] = { middle.x, middle.y, middle.z };
      const bool isLit = scene.Shadows->GetHeight(place) <= vtkGodRays::dot(middle, toLight);
      for (int c = 0; c < components; ++c)
      {
        const double extinction = medium.Scattering[c] + medium.Absorption[c];
        const double light = isLit ? scene.LightColor[c] * phase * medium.Scattering[c] *
            vtkGodRays::DirectionalAirlight(extinction, perDepth * begin, perDepth * end, 0.0, 0.0)
                                   : 0.0;
        sum[components + c] = sum[c] + static_cast<float>(light);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool ClosedFormIntegrator::Integrate(const Request& request)
{
  int size[2];
  request.Depths->GetSize(size);
  return request.Depths->ReadEnds(this->Light.Walk.PrepareInput(size[0], size[1])) &&
    this->Light.Add(request, vtkGodRaysWalkedLight::GetParameters(request, size), size,
      request.Depths->GetFrame());
}

//------------------------------------------------------------------------------
std::string ClosedFormIntegrator::Describe(vtkGodRaysModel*)
{
  return "closed form, no shadows";
}

//------------------------------------------------------------------------------
void ClosedFormIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Light.Release(window);
}

//------------------------------------------------------------------------------
PictureIntegrator::PictureIntegrator()
{
  this->Map->SetMapSize(1024);
  this->Map->SetNumberOfNestedMaps(1);
}

//------------------------------------------------------------------------------
bool PictureIntegrator::Integrate(const Request& request)
{
  const vtkGodRaysShadowGrids* const shadows = this->Map->DrawShadows(request);
  if (!shadows)
  {
    return false;
  }
  int size[2];
  request.Depths->GetSize(size);
  const bool grey = request.Medium->IsGrey();
  const int components = grey ? 1 : 3;
  const std::size_t pixels = static_cast<std::size_t>(size[0]) * size[1];
  this->Depths.resize(pixels);
  this->Picture.resize(components * pixels);
  if (!request.Depths->ReadEnds(this->Depths.data()))
  {
    return false;
  }
  this->Fill(vtkGodRaysWalkedLight::GetParameters(request, size, shadows), size, components,
    this->Depths.data(), this->Picture.data());
  vtkGodRaysTarget& rays = this->Rays[grey ? 0 : 1];
  if (!request.Result->Settle())
  {
    return false;
  }
  rays.Prepare(request.Window, size[0], size[1],
    { static_cast<unsigned int>(grey ? GL_R32F : GL_RGBA32F), 0 });
  rays.Write(grey ? GL_RED : GL_RGB, GL_FLOAT, this->Picture.data());
  return request.Result->Lend(rays, request.Light->Color, request.View->ViewScale);
}

//------------------------------------------------------------------------------
void PictureIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Map->ReleaseGraphicsResources(window);
  this->Rays[0].Release(window);
  this->Rays[1].Release(window);
}

//------------------------------------------------------------------------------
void FroxelsIntegrator::SetSize(int columns, int rows, int slices)
{
  this->Columns = columns;
  this->Rows = rows;
  this->Slices = slices;
}

//------------------------------------------------------------------------------
void FroxelsIntegrator::Fill(
  const Scene& scene, const int size[2], int components, const float* depths, float* picture)
{
  Froxels froxels(this->Columns, this->Rows, this->Slices, components);
  vtkSMPTools::For(0, this->Rows, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        FillRow(froxels, static_cast<int>(row), scene, size, components);
      }
    });
  vtkSMPTools::For(0, size[1], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const std::size_t pixel = row * size[0] + column;
          const double depth = std::min<double>(depths[pixel] / scene.Medium.FarLimit, 1.0);
          froxels.Read((column + 0.5) / size[0], (row + 0.5) / size[1],
            std::sqrt(depth) * this->Slices, picture + components * pixel);
        }
      }
    });
}

//------------------------------------------------------------------------------
std::string FroxelsIntegrator::Describe(vtkGodRaysModel*)
{
  return "froxels: " + std::to_string(this->Columns) + " x " + std::to_string(this->Rows) + " x " +
    std::to_string(this->Slices);
}

//------------------------------------------------------------------------------
void TreesIntegrator::Fill(
  const Scene& scene, const int size[2], int components, const float* depths, float* picture)
{
  const Vec3 light = glm::normalize(Vec3(scene.Light[0], scene.Light[1], scene.Light[2]));
  const vtkGodRaysShadowGrids& shadows = *scene.Shadows;
  const auto across = [&](const Vec3& way, int axis)
  {
    const double* a = shadows.Grids[0].Axes[axis];
    return vtkGodRays::dot(way, Vec3(a[0], a[1], a[2]));
  };
  const auto getWay = [&](double x, double y)
  {
    return Vec3(
      (x - scene.Center[0]) * scene.PixelSize, (y - scene.Center[1]) * scene.PixelSize, 1.0);
  };
  const auto addLine = [&](double x, double y)
  {
    const Vec3 way = getWay(x, y);
    this->Angles.push_back(std::atan2(across(way, 1), across(way, 0)));
  };
  this->Angles.clear();
  for (int x = 0; x <= size[0]; x += 2)
  {
    addLine(x, 0.0);
    addLine(x, size[1]);
  }
  for (int y = 0; y <= size[1]; y += 2)
  {
    addLine(0.0, y);
    addLine(size[0], y);
  }
  std::sort(this->Angles.begin(), this->Angles.end());
  const int lines = static_cast<int>(this->Angles.size());
  const double pi = std::acos(-1.0);
  const int parts = 1 << 16;
  this->Nearest.resize(parts);
  for (int i = 0, line = 0; i < parts; ++i)
  {
    const double angle = 2.0 * pi * (i + 0.5) / parts - pi;
    while (line + 1 < lines &&
      std::abs(this->Angles[line + 1] - angle) <= std::abs(this->Angles[line] - angle))
    {
      ++line;
    }
    this->Nearest[i] = line;
  }
  this->Trees.resize(lines);
  vtkSMPTools::For(0, lines, 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType line = begin; line < end; ++line)
      {
        this->Trees[line].Build(shadows, this->Angles[line]);
      }
    });
  const vtkGodRaysMedium::Component& medium = scene.Medium.Components[0];
  vtkSMPTools::For(0, size[1], 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const std::size_t pixel = row * size[0] + column;
          const Vec3 way = getWay(column + 0.5, row + 0.5);
          const double part = std::atan2(across(way, 1), across(way, 0)) / (2.0 * pi) + 0.5;
          const ShadowTree& tree =
            this->Trees[this->Nearest[std::min(static_cast<int>(part * parts), parts - 1)]];
          const double perDepth = vtkGodRays::length(way);
          const double perAcross =
            perDepth / std::max(std::hypot(across(way, 0), across(way, 1)), 1e-9);
          const double far = std::min<double>(depths[pixel], scene.Medium.FarLimit);
          double sums[3] = {};
          double litFrom = 0.0; // of the parts that follow each other
          double litTo = 0.0;
          const auto add = [&]
          {
            for (int c = 0; c < components && litTo > litFrom; ++c)
            {
              sums[c] +=
                vtkGodRays::DirectionalAirlight(medium.Scattering[c] + medium.Absorption[c],
                  perAcross * litFrom, perAcross * litTo, 0.0, 0.0);
            }
          };
          tree.Walk(vtkGodRays::dot(way, light) * perAcross / perDepth, far * perDepth / perAcross,
            [&](bool isLit, double from, double to)
            {
              if (isLit && from > litTo)
              {
                add();
                litFrom = from;
              }
              litTo = isLit ? to : litTo;
            });
          add();
          const double phase = vtkGodRays::Phase(
            { medium.PhaseFunction, medium.Asymmetry }, vtkGodRays::dot(way, light) / perDepth);
          for (int c = 0; c < components; ++c)
          {
            picture[components * pixel + c] =
              static_cast<float>(scene.LightColor[c] * phase * medium.Scattering[c] * sums[c]);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
std::string TreesIntegrator::Describe(vtkGodRaysModel*)
{
  return "trees of least and greatest heights: " + std::to_string(this->Trees.size());
}
