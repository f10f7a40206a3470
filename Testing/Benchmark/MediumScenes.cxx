// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MediumScenes.h"

#include "vtkContourFilter.h"
#include "vtkImageData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSampleFunction.h"
#include "vtkSuperquadric.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <cmath>
#include <random>

using GodRaysMediumScenes::Mesh;
using GodRaysMediumScenes::Scene;

namespace
{
void AddGround(Mesh& mesh)
{
  mesh.AddBox(-2000, 2000, -1.7, -1.5, -2000, 2000);
}

//------------------------------------------------------------------------------
// Leaves overhead and before the eye, and a few trunks.
Scene MakeCanopy()
{
  Mesh mesh;
  std::mt19937 generator(11);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  for (int i = 0; i < 700; ++i)
  {
    const double z = -uniform(3.0, 12.0);
    const double x = uniform(-0.9, 0.9) * -z;
    const double y = uniform(0.3, 3.0);
    const double size = uniform(0.04, 0.12);
    mesh.AddBox(x - size, x + size, y, y + 0.02, z - size, z + size);
  }
  for (const double x : { -3.0, -0.8, 1.9, 4.1 })
  {
    mesh.AddBox(x - 0.12, x + 0.12, -1.5, 2.0, -8.12 + 0.5 * x, -7.88 + 0.5 * x);
  }
  AddGround(mesh);
  return { "canopy", mesh.Get() };
}

//------------------------------------------------------------------------------
// A wall with windows and their bars.
Scene MakeFacade()
{
  Mesh mesh;
  const double near = -7.0;
  const double far = -7.3;
  double edge = -9.0;
  for (int i = 0; i < 6; ++i)
  {
    const double x = -5.0 + 2.0 * i;
    mesh.AddBox(edge, x - 0.5, -1.5, 4.5, far, near);
    mesh.AddBox(x - 0.03, x + 0.03, -0.6, 2.6, far + 0.1, near - 0.1);
    mesh.AddBox(x - 0.5, x + 0.5, 0.97, 1.03, far + 0.1, near - 0.1);
    edge = x + 0.5;
  }
  mesh.AddBox(edge, 9.0, -1.5, 4.5, far, near);
  mesh.AddBox(-9.0, 9.0, -1.5, -0.6, far, near);
  mesh.AddBox(-9.0, 9.0, 2.6, 4.5, far, near);
  AddGround(mesh);
  return { "windows", mesh.Get() };
}

//------------------------------------------------------------------------------
// Hills, with their underside.
Scene MakeTerrain()
{
  Mesh mesh;
  const int columns = 160;
  const int rows = 120;
  const auto point = [&](int i, int j, bool top)
  {
    const double x = -14.0 + 28.0 * i / columns;
    const double z = -1.0 - 20.0 * j / rows;
    const double rise = 0.9 * std::sin(0.55 * x + 0.3) * std::cos(0.5 * z) +
      0.4 * std::sin(1.3 * x - 0.7 * z) + 0.2 * std::cos(2.9 * x + 1.7 * z) +
      0.05 * std::max(0.0, -z - 6.0) * (1.0 + std::sin(0.8 * x));
    return mesh.AddPoint(x, top ? -1.4 + std::max(rise, -0.5) : -3.0, z);
  };
  for (const bool top : { true, false })
  {
    std::vector<vtkIdType> points;
    for (int j = 0; j <= rows; ++j)
    {
      for (int i = 0; i <= columns; ++i)
      {
        points.push_back(point(i, j, top));
      }
    }
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        const vtkIdType a = points[j * (columns + 1) + i];
        const vtkIdType b = points[j * (columns + 1) + i + 1];
        const vtkIdType c = points[(j + 1) * (columns + 1) + i];
        const vtkIdType d = points[(j + 1) * (columns + 1) + i + 1];
        if (top)
        {
          mesh.AddPolygon({ a, b, d });
          mesh.AddPolygon({ a, d, c });
        }
        else
        {
          mesh.AddPolygon({ a, d, b });
          mesh.AddPolygon({ a, c, d });
        }
      }
    }
  }
  return { "terrain", mesh.Get() };
}

//------------------------------------------------------------------------------
// Bars of a few pixels, one grid behind the other.
Scene MakeLattice()
{
  Mesh mesh;
  for (const double z : { -5.0, -8.0 })
  {
    for (int i = -12; i <= 12; ++i)
    {
      const double at = 0.45 * i + 0.02 * z;
      mesh.AddBox(at - 0.03, at + 0.03, -4.0, 4.0, z - 0.06, z);
      mesh.AddBox(-6.0, 6.0, at - 0.03, at + 0.03, z - 0.12, z - 0.06);
    }
  }
  return { "lattice", mesh.Get() };
}

//------------------------------------------------------------------------------
// A surface of a sampled function: a ring.
Scene MakeIsosurface(int sphereParts)
{
  vtkNew<vtkSuperquadric> ring;
  ring->ToroidalOn();
  ring->SetThickness(0.3);
  ring->SetSize(1.6);
  vtkNew<vtkSampleFunction> field;
  field->SetImplicitFunction(ring);
  field->SetModelBounds(-2.2, 2.2, -2.2, 2.2, -2.2, 2.2);
  field->SetSampleDimensions(3 * sphereParts, 3 * sphereParts, 3 * sphereParts);
  field->ComputeNormalsOff();
  vtkNew<vtkContourFilter> surface;
  surface->SetInputConnection(field->GetOutputPort());
  surface->SetValue(0, 0.0);
  vtkNew<vtkTransform> turn;
  turn->Translate(0.3, 0.2, -6.5);
  turn->RotateX(35.0);
  turn->RotateY(30.0);
  vtkNew<vtkTransformFilter> placed;
  placed->SetTransform(turn);
  placed->SetInputConnection(surface->GetOutputPort());
  vtkNew<vtkPolyDataNormals> oriented;
  oriented->SetInputConnection(placed->GetOutputPort());
  oriented->SplittingOff();
  oriented->AutoOrientNormalsOn();
  oriented->Update();
  return { "isosurface", oriented->GetOutput() };
}

//------------------------------------------------------------------------------
Scene MakeColonnade()
{
  Mesh mesh;
  for (int i = -5; i <= 5; ++i)
  {
    for (const double z : { -6.0, -10.0 })
    {
      mesh.AddBox(1.5 * i - 0.25, 1.5 * i + 0.25, -1.5, 2.2, z - 0.5, z);
    }
  }
  mesh.AddBox(-9.0, 9.0, 2.2, 2.5, -11.0, -5.5);
  AddGround(mesh);
  return { "colonnade", mesh.Get() };
}

//------------------------------------------------------------------------------
// Close to the eye, large and far apart in the picture.
Scene MakeNear(int sphereParts)
{
  Mesh mesh;
  mesh.AddSphere(-0.5, 0.1, -1.6, 0.25, sphereParts);
  mesh.AddSphere(0.6, 0.4, -2.2, 0.3, sphereParts);
  mesh.AddSphere(0.1, -0.4, -1.3, 0.12, sphereParts);
  mesh.AddBox(-2.0, 2.0, 0.75, 0.85, -2.1, -2.0);
  return { "near", mesh.Get() };
}
}

//------------------------------------------------------------------------------
std::vector<Scene> MakeMediumScenes(int sphereParts)
{
  std::vector<Scene> scenes = GodRaysMediumScenes::MakeScenes(sphereParts);
  scenes.push_back(MakeCanopy());
  scenes.push_back(MakeFacade());
  scenes.push_back(MakeTerrain());
  scenes.push_back(MakeLattice());
  scenes.push_back(MakeIsosurface(sphereParts));
  scenes.push_back(MakeColonnade());
  scenes.push_back(MakeNear(sphereParts));
  return scenes;
}
