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

using vtkGodRays::Vec3;

namespace
{
//------------------------------------------------------------------------------
// Sums of the light before each end of the slices, of the columns of cells of a row.
void FillRow(Froxels& froxels, int row, const vtkGodRaysCoverageSweep::Parameters& scene,
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
// No grid has an occluder.
bool ClosedFormIntegrator::Integrate(const Request& request)
{
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends)
  {
    return false;
  }
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  const auto input = this->Light.Sweep.PrepareInput(size[0], size[1], 1);
  ends->Read(GL_RED, GL_FLOAT, input.Values[0], static_cast<int>(input.Stride));
  const vtkGodRaysShadowGrids none;
  return this->Light.Add(request, vtkGodRaysSweptLight::GetParameters(request, size, &none), size);
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
FroxelsIntegrator::FroxelsIntegrator()
{
  this->Map->SweepMapOn();
  this->Map->SetMapSize(1024);
  this->Map->SetNumberOfNestedMaps(1);
}

//------------------------------------------------------------------------------
void FroxelsIntegrator::SetSize(int columns, int rows, int slices)
{
  this->Columns = columns;
  this->Rows = rows;
  this->Slices = slices;
}

//------------------------------------------------------------------------------
bool FroxelsIntegrator::Integrate(const Request& request)
{
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  const vtkGodRaysShadowGrids* const shadows = ends ? this->Map->DrawShadows(request) : nullptr;
  if (!shadows)
  {
    return false;
  }
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  const auto scene = vtkGodRaysSweptLight::GetParameters(request, size, shadows);
  const bool grey = request.Medium->IsGrey();
  const int components = grey ? 1 : 3;
  Froxels froxels(this->Columns, this->Rows, this->Slices, components);
  vtkSMPTools::For(0, this->Rows, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        FillRow(froxels, static_cast<int>(row), scene, size, components);
      }
    });
  const std::size_t pixels = static_cast<std::size_t>(size[0]) * size[1];
  this->Depths.resize(pixels);
  this->Picture.resize(components * pixels);
  ends->Read(GL_RED, GL_FLOAT, this->Depths.data(), size[0]);
  vtkSMPTools::For(0, size[1], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const std::size_t pixel = row * size[0] + column;
          const double depth = std::min<double>(this->Depths[pixel] / scene.Medium.FarLimit, 1.0);
          froxels.Read((column + 0.5) / size[0], (row + 0.5) / size[1],
            std::sqrt(depth) * this->Slices, this->Picture.data() + components * pixel);
        }
      }
    });
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
std::string FroxelsIntegrator::Describe(vtkGodRaysModel*)
{
  return "froxels: " + std::to_string(this->Columns) + " x " + std::to_string(this->Rows) + " x " +
    std::to_string(this->Slices);
}

//------------------------------------------------------------------------------
void FroxelsIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Map->ReleaseGraphicsResources(window);
  this->Rays[0].Release(window);
  this->Rays[1].Release(window);
}
