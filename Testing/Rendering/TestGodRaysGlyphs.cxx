// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What a placer of suns sees of the glyphs that a mapper draws.

#include "GodRaysTesting.h"

#include "vtkGodRaysSunPlacer.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkBitArray.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3D.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <cmath>

using namespace GodRaysTesting;

// Glyphs are as large as the mapper draws them: as the same shapes made by a filter.
TEST(GodRaysGlyphs, HaveTheirSizeInTheSilhouette)
{
  Messages messages;
  Stage stage;
  vtkNew<vtkGodRaysSunPlacer> placer;
  vtkNew<vtkPoints> places;
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("sizes");
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("directions");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    places->InsertNextPoint(1.5 * (i - 2), 0.4 * i - 0.8, 0.0);
    sizes->InsertNextValue(0.5 + 0.25 * i);
    directions->InsertNextTuple3(std::cos(0.7 * i), std::sin(0.7 * i), 0.3);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  points->GetPointData()->AddArray(sizes);
  points->GetPointData()->AddArray(directions);
  vtkNew<vtkCubeSource> bar;
  bar->SetXLength(1.6);
  bar->SetYLength(0.3);
  bar->SetCenter(0.8, 0.0, 0.0);

  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(points);
  glyphs->SetSourceConnection(bar->GetOutputPort());
  glyphs->SetScaleArray("sizes");
  glyphs->SetScaleModeToScaleByMagnitude();
  glyphs->SetScaleFactor(0.8);
  glyphs->SetOrientationArray("directions");
  glyphs->SetOrientationModeToDirection();

  vtkNew<vtkGlyph3D> filter;
  filter->SetInputData(points);
  filter->SetSourceConnection(bar->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "sizes");
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "directions");
  filter->SetScaleModeToScaleByScalar();
  filter->SetScaleFactor(0.8);
  vtkNew<vtkPolyDataMapper> made;
  made->SetInputConnection(filter->GetOutputPort());

  vtkNew<vtkActor> actor;
  const auto cover = [&](vtkMapper* mapper)
  {
    actor->SetMapper(mapper);
    stage.Renderer->AddActor(actor);
    placer->Find(stage.Renderer);
    stage.Renderer->RemoveAllViewProps();
    return placer->GetCoverage();
  };
  const double expected = cover(made);
  EXPECT_GT(expected, 0.01);
  EXPECT_NEAR(cover(glyphs), expected, 0.05 * expected);

  // by each of the ways to turn and to scale
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("angles");
  angles->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> quaternions;
  quaternions->SetName("quaternions");
  quaternions->SetNumberOfComponents(4);
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("lengths");
  lengths->SetNumberOfComponents(3);
  vtkNew<vtkAppendPolyData> shapes;
  for (int i = 0; i < 5; ++i)
  {
    const double turn[3] = { 10.0 * i, 20.0 * i, 35.0 * i };
    const double length[3] = { 0.6, 1.0 + 0.3 * i, 1.0 };
    angles->InsertNextTuple(turn);
    lengths->InsertNextTuple(length);
    vtkNew<vtkTransform> transform;
    transform->Translate(places->GetPoint(i));
    transform->RotateZ(turn[2]);
    transform->RotateX(turn[0]);
    transform->RotateY(turn[1]);
    double about[4]; // [degrees], axis
    transform->GetOrientationWXYZ(about);
    const double half = 0.5 * vtkMath::RadiansFromDegrees(about[0]);
    quaternions->InsertNextTuple4(std::cos(half), std::sin(half) * about[1],
      std::sin(half) * about[2], std::sin(half) * about[3]);
    transform->Scale(length);
    vtkNew<vtkTransformFilter> shape;
    shape->SetInputConnection(bar->GetOutputPort());
    shape->SetTransform(transform);
    shapes->AddInputConnection(shape->GetOutputPort());
  }
  made->SetInputConnection(shapes->GetOutputPort());
  const double turned = cover(made);
  points->GetPointData()->AddArray(angles);
  points->GetPointData()->AddArray(quaternions);
  points->GetPointData()->AddArray(lengths);
  glyphs->SetScaleArray("lengths");
  glyphs->SetScaleModeToScaleByVectorComponents();
  glyphs->SetScaleFactor(1.0);
  glyphs->SetOrientationArray("angles");
  glyphs->SetOrientationModeToRotation();
  EXPECT_NEAR(cover(glyphs), turned, 0.05 * turned);
  glyphs->SetOrientationArray("quaternions");
  glyphs->SetOrientationModeToQuaternion();
  EXPECT_NEAR(cover(glyphs), turned, 0.05 * turned);

  // by masks, and as each source is
  vtkNew<vtkBitArray> mask;
  mask->SetName("mask");
  for (int i = 0; i < 5; ++i)
  {
    mask->InsertNextValue(0);
  }
  points->GetPointData()->AddArray(mask);
  glyphs->SetMaskArray("mask");
  glyphs->MaskingOn();
  EXPECT_EQ(cover(glyphs), 0.0);
  glyphs->MaskingOff();
  vtkNew<vtkPolyData> nothing;
  glyphs->SetSourceData(0, nothing);
  EXPECT_EQ(cover(glyphs), 0.0);
  glyphs->SetSourceConnection(1, bar->GetOutputPort());
  glyphs->SetSourceIndexArray("sizes");
  glyphs->SourceIndexingOn();
  glyphs->SetRange(0.0, 1.8); // the first two have the first source
  const double some = cover(glyphs);
  EXPECT_GT(some, 0.3 * turned);
  EXPECT_LT(some, 0.9 * turned);
}
