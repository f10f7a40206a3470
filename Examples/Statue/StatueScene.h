// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stands before the light, and what is behind it: a model of the user's, a winged figure by
 * default, and a galaxy.
 */

#ifndef StatueScene_h
#define StatueScene_h

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGLTFImporter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkSplineFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtksys/SystemTools.hxx"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Smooth tubes through points, each with the tube's radius there: x, y, z, radius.
using Tubes = std::vector<std::vector<std::array<double, 4>>>;

inline void AddSurface(vtkRenderer* renderer, vtkAlgorithm* shape)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(shape->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.75, 0.72, 0.68);
  renderer->AddActor(actor);
}

/// A robe from hem to crown, raised arms, and wings whose feathers let light through; y is up.
inline Tubes MakeFigure()
{
  Tubes tubes = { { { 0, 0, 0, 0.5 }, { 0, 0.1, 0, 0.52 }, { 0, 0.5, 0.02, 0.42 },
    { 0, 1.1, 0.06, 0.32 }, { 0, 1.5, 0.06, 0.21 }, { 0, 1.9, 0.03, 0.27 }, { 0, 2.15, 0, 0.25 },
    { 0, 2.33, 0, 0.12 }, { 0, 2.45, 0.02, 0.085 }, { 0, 2.55, 0.04, 0.13 },
    { 0, 2.7, 0.05, 0.165 }, { 0, 2.85, 0.04, 0.12 }, { 0, 2.93, 0.03, 0.02 } } };
  for (const double side : { -1.0, 1.0 })
  {
    tubes.push_back({ { 0.2 * side, 2.18, 0, 0.1 }, { 0.42 * side, 2.3, 0.1, 0.09 },
      { 0.6 * side, 2.62, 0.18, 0.075 }, { 0.5 * side, 2.95, 0.2, 0.06 },
      { 0.3 * side, 3.25, 0.2, 0.05 }, { 0.22 * side, 3.42, 0.2, 0.02 } });
    tubes.push_back({ { 0.1 * side, 1.85, -0.2, 0.06 }, { 0.45 * side, 2.25, -0.36, 0.09 },
      { 0.9 * side, 2.65, -0.45, 0.08 }, { 1.5 * side, 2.85, -0.45, 0.05 },
      { 2.1 * side, 2.75, -0.4, 0.015 } });
    for (int i = 0; i <= 10; ++i)
    {
      const double along = i / 10.0; // the wing
      const double angle = vtkMath::RadiansFromDegrees(-98.0 + 78.0 * along);
      const double length = 0.75 + 1.1 * std::sin(vtkMath::Pi() * (0.15 + 0.75 * along));
      tubes.emplace_back();
      const double shape[4][2] = { { 0, 0.04 }, { 0.35, 0.075 }, { 0.75, 0.07 }, { 1, 0.01 } };
      for (const auto& [part, radius] : shape)
      {
        tubes.back().push_back({ side *
            (0.18 + 1.75 * along + length * (part * std::cos(angle) + 0.1 * std::sin(3.0 * part))),
          1.95 + 0.95 * std::sin(1.625 * along) +
            length * (part * std::sin(angle) - 0.12 * part * part),
          -0.4, radius });
      }
    }
  }
  return tubes;
}

inline void AddFigure(vtkRenderer* renderer)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> radii;
  for (const auto& tube : MakeFigure())
  {
    lines->InsertNextCell(static_cast<int>(tube.size()));
    for (const auto& [x, y, z, radius] : tube)
    {
      lines->InsertCellPoint(points->InsertNextPoint(x, y, z));
      radii->InsertNextValue(radius);
    }
  }
  vtkNew<vtkPolyData> skeleton;
  skeleton->SetPoints(points);
  skeleton->SetLines(lines);
  skeleton->GetPointData()->SetScalars(radii);
  vtkNew<vtkSplineFilter> smooth;
  smooth->SetInputData(skeleton);
  smooth->SetSubdivideToSpecified();
  smooth->SetNumberOfSubdivisions(48);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(smooth->GetOutputPort());
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(24);
  tubes->CappingOn();
  AddSurface(renderer, tubes);
}

/**
 * Read a model (glTF with its materials, OBJ, PLY, STL) into the window's first renderer, or make
 * the figure if the name is empty. Returns what is wrong with the file, and nothing if it is right.
 */
inline std::string AddModel(vtkRenderWindow* window, const std::string& file)
{
  vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
  if (file.empty())
  {
    AddFigure(renderer);
    return "";
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  const std::map<std::string, vtkSmartPointer<vtkAbstractPolyDataReader>> readers = {
    { ".obj", vtkSmartPointer<vtkOBJReader>::New() },
    { ".ply", vtkSmartPointer<vtkPLYReader>::New() },
    { ".stl", vtkSmartPointer<vtkSTLReader>::New() }
  };
  const auto reader = readers.find(ending);
  const bool isGLTF = ending == ".glb" || ending == ".gltf";
  if (!isGLTF && reader == readers.end())
  {
    return file + " is no model that is read here; give a .glb, .gltf, .obj, .ply or .stl file";
  }
  if (!vtksys::SystemTools::TestFileAccess(file, vtksys::TEST_FILE_READ))
  {
    return file + " cannot be read; check its name and your right to read it";
  }
  vtkObject::GlobalWarningDisplayOff(); // what is wrong is told once, by the caller
  if (isGLTF)
  {
    vtkNew<vtkGLTFImporter> importer;
    importer->SetRenderWindow(window);
    importer->SetFileName(file.c_str());
    importer->Update();
  }
  else
  {
    reader->second->SetFileName(file.c_str());
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(reader->second->GetOutputPort());
    normals->Update();
    AddSurface(renderer, normals);
  }
  vtkObject::GlobalWarningDisplayOn();
  const vtkBoundingBox box(renderer->ComputeVisiblePropBounds());
  const double length = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  return length > 0.0 && std::isfinite(length)
    ? ""
    : file + " holds no surface, or is damaged; write it again";
}

/// Stars all about, and a spiral of two arms, which begins blue and ends, at its core, yellow.
inline vtkSmartPointer<vtkActor> MakeGalaxy(double size, const double center[3])
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  vtkMath::RandomSeed(3);
  for (int i = 0; i < 9000; ++i)
  {
    // One after the other: the order of arguments is the compiler's.
    double place[3];
    for (double& coordinate : place)
    {
      coordinate = vtkMath::Gaussian();
    }
    const double chance = vtkMath::Random();
    double brightness;
    double color[3] = { 230.0, 235.0, 255.0 };
    if (i < 2500)
    {
      vtkMath::Normalize(place);
      vtkMath::MultiplyScalar(place, 10.0);
      brightness = 0.4 + 0.6 * std::pow(chance, 4.0);
      radii->InsertNextValue(size * (0.01 + 0.017 * brightness));
    }
    else
    {
      const double out = std::pow(vtkMath::Random(), 0.9); // of the core, as a part of the radius
      const double angle = vtkMath::Pi() * (i % 2) + 2.6 * std::log(1.0 + 15.0 * out);
      const double spread = 0.05 + 0.16 * out;
      const double x = 2.2 * (out * std::cos(angle) + spread * place[0] / 2.5);
      const double z = 2.2 * (out * std::sin(angle) + spread * place[2] / 2.5);
      const double warm = std::exp(-1.7 * std::hypot(x, z));
      const double y = 0.1 * warm * place[1];
      brightness = 0.15 + 0.6 * std::pow(chance, 3.0);
      color[0] = 120.0 + 135.0 * warm;
      color[1] = 140.0 + 80.0 * warm;
      color[2] = 225.0 - 90.0 * warm;
      radii->InsertNextValue(size * (0.007 + 0.02 * std::pow(chance, 6.0) + 0.009 * warm));
      // tilted towards the eye
      place[0] = 1.7 + 0.91 * x - 0.41 * y;
      place[1] = 1.2 + 0.27 * x + 0.61 * y - 0.74 * z;
      place[2] = -6.4 + 0.3 * x + 0.68 * y + 0.67 * z;
    }
    vtkMath::MultiplyScalar(color, brightness);
    colors->InsertNextTuple(color);
    points->InsertNextPoint(
      center[0] + size * place[0], center[1] + size * place[1], center[2] + size * place[2]);
  }
  vtkNew<vtkPolyData> stars;
  stars->SetPoints(points);
  stars->GetPointData()->SetScalars(colors);
  stars->GetPointData()->AddArray(radii);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(stars);
  mapper->SetScaleArray("radius");
  mapper->SetScaleFactor(1.0);
  mapper->EmissiveOn();
  auto galaxy = vtkSmartPointer<vtkActor>::New();
  galaxy->SetMapper(mapper);
  return galaxy;
}

#endif
