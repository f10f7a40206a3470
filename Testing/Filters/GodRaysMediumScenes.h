// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysMediumScenes.h
 * @brief   occluders and lights for the tests and the benchmark of scattering in a medium
 *
 * In view coordinates: the eye in the origin, looking along -z. The scenes are those of the prototype
 * that the method was chosen by.
 */

#ifndef GodRaysMediumScenes_h
#define GodRaysMediumScenes_h

#include "vtkGodRaysMath.h"
#include "vtkGodRaysMediumFilter.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace GodRaysMediumScenes
{
// Triangles and quadrangles, their normals outwards.
class Mesh
{
public:
  Mesh() { this->Points->SetDataTypeToDouble(); }

  void AddPolygon(std::initializer_list<vtkIdType> points)
  {
    this->Polygons->InsertNextCell(points);
  }
  vtkIdType AddPoint(double x, double y, double z)
  {
    return this->Points->InsertNextPoint(x, y, z);
  }

  void AddSphere(double x, double y, double z, double radius, int parts)
  {
    const double pi = 3.14159265358979323846;
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; j < 2 * parts; ++j)
      {
        const double a = pi * i / parts;
        const double b = pi * j / parts;
        this->AddPoint(x + radius * std::sin(a) * std::cos(b),
          y + radius * std::sin(a) * std::sin(b), z + radius * std::cos(a));
      }
    }
    for (int i = 0; i < parts; ++i)
    {
      for (int j = 0; j < 2 * parts; ++j)
      {
        const vtkIdType a = first + 2 * parts * i;
        const vtkIdType b = a + 2 * parts;
        const int next = (j + 1) % (2 * parts);
        this->AddPolygon({ a + j, b + j, b + next });
        this->AddPolygon({ a + j, b + next, a + next });
      }
    }
  }

  void AddBox(double x0, double x1, double y0, double y1, double z0, double z1)
  {
    vtkIdType p[8];
    for (int i = 0; i < 8; ++i)
    {
      p[i] = this->AddPoint(i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0);
    }
    this->AddPolygon({ p[0], p[2], p[3], p[1] });
    this->AddPolygon({ p[4], p[5], p[7], p[6] });
    this->AddPolygon({ p[0], p[1], p[5], p[4] });
    this->AddPolygon({ p[2], p[6], p[7], p[3] });
    this->AddPolygon({ p[0], p[4], p[6], p[2] });
    this->AddPolygon({ p[1], p[3], p[7], p[5] });
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetPolys(this->Polygons);
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
};

struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Occluders;
};

// As in a camera's picture, depth counting forwards.
inline std::vector<Scene> MakeScenes(int sphereParts = 24)
{
  std::vector<Scene> scenes;
  const auto ground = [](Mesh& mesh) { mesh.AddBox(-2000, 2000, -1.7, -1.5, -2000, 2000); };
  {
    Mesh mesh;
    mesh.AddSphere(0.25, 0.25, -6.0, 1.0, 4 * sphereParts);
    scenes.push_back({ "sphere", mesh.Get() });
  }
  {
    Mesh mesh;
    for (int i = -3; i <= 3; ++i)
    {
      mesh.AddBox(0.8 * i - 0.1, 0.8 * i + 0.3, -2.5, 2.5, -6.3, -6.0);
    }
    scenes.push_back({ "slats", mesh.Get() });
  }
  {
    Mesh mesh;
    mesh.AddSphere(-1.0, 0.5, -4.0, 0.5, 2 * sphereParts);
    mesh.AddSphere(1.4, 0.9, -9.0, 0.8, 2 * sphereParts);
    for (int i = 0; i < 5; ++i)
    {
      mesh.AddBox(-4.0 + 1.7 * i, -3.5 + 1.7 * i, -1.5, 2.2, -11.5, -11.0);
    }
    ground(mesh);
    scenes.push_back({ "mixed", mesh.Get() });
  }
  std::mt19937 generator(3);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  {
    Mesh mesh;
    for (int i = 0; i < 60; ++i)
    {
      const double x = uniform(-6.0, 6.0);
      const double z = uniform(4.0, 14.0);
      const double radius = uniform(0.1, 0.35);
      mesh.AddSphere(x * z / 8.0, uniform(-0.5, 1.7), -z, radius, sphereParts);
    }
    ground(mesh);
    scenes.push_back({ "tree line", mesh.Get() });
  }
  {
    Mesh mesh;
    for (int i = 0; i < 14; ++i)
    {
      const double z = uniform(4.0, 14.0);
      const double x = uniform(-0.9, 0.9) * z;
      const double width = uniform(0.4, 1.2);
      const double depth = uniform(0.5, 2.5);
      mesh.AddBox(x - width / 2.0, x + width / 2.0, -1.5, uniform(-0.5, 2.5), -z - depth, -z);
    }
    ground(mesh);
    scenes.push_back({ "city", mesh.Get() });
  }
  return scenes;
}

struct NamedLight
{
  const char* Name;
  double Direction[3];
};
// For a view angle of 60 degrees and a picture of 16 : 9.
const NamedLight Lights[] = { { "front", { 0.15, 0.22, -1.0 } },
  { "near edge", { 0.94, 0.22, -1.0 } }, { "off by 0.28 width", { 1.6, 0.7, -1.0 } },
  { "off by 0.5 width", { 2.05, 0.7, -1.0 } }, { "behind", { 0.5, 0.6, 1.0 } } };

// The camera and the medium of the measurements.
inline void Prepare(vtkGodRaysMediumFilter* filter, const NamedLight& light, double scattering)
{
  filter->SetViewAngle(60.0);
  filter->SetFarLimit(20.0);
  filter->SetScatteringCoefficient(scattering, scattering, scattering);
  filter->SetAsymmetry(0.6);
  filter->SetLight(light.Direction[0], light.Direction[1], light.Direction[2], 0.0);
}

// Numbers that are the same with every compiler.
struct Random
{
  std::mt19937 Generator;
  double Uniform(double low, double high)
  {
    return low + (high - low) * (this->Generator() / 4294967296.0);
  }
  double Log(double low, double high)
  {
    return std::exp(this->Uniform(std::log(low), std::log(high)));
  }
  vtkGodRays::Vec3 Direction()
  {
    vtkGodRays::Vec3 v;
    do
    {
      v = vtkGodRays::Vec3(this->Uniform(-1, 1), this->Uniform(-1, 1), this->Uniform(-1, 1));
    } while (vtkGodRays::length(v) > 1.0 || vtkGodRays::length(v) < 0.1);
    return v / vtkGodRays::length(v);
  }
};
}

#endif
