// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadow maps: against closed forms and the ground truth, with things that the picture's depth does
// not hold; that the scene does not notice them; and for which props they are kept between frames.

#include "GodRaysLonelyCompositor.h"
#include "GodRaysMediumTesting.h"
#include "GodRaysOcclusionTesting.h"

#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkAppendFilter.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkDoubleArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper2.h"
using BlockMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using BlockMapper = vtkCompositePolyDataMapper;
#endif
#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#else // as in ParaView's VTK
using vtkLODActor = vtkActor;
#endif

using namespace GodRaysTesting;

namespace
{
class GodRaysShadowMap : public MediumTest
{
protected:
  vtkNew<vtkGodRaysShadowMapIntegrator> Integrator;

  GodRaysShadowMap()
  {
    this->Integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
    this->Integrator->SetMapSize(1024);
    this->Integrator->SetNumberOfNestedMaps(1);
    this->Rays->SetIntegrator(this->Integrator);
  }
};
}

TEST_F(GodRaysShadowMap, IsTheClosedFormWithoutShadows)
{
  for (const Case& each : {
         Case{ "sun in front", { 0.3, 0.2, -1.0, 0.0 }, 1e-4 },
         Case{ "sun beside", { 1.0, 0.5, 0.0, 0.0 }, 1e-4 },
         Case{ "lamp in front", { 1.0, 0.5, -3.0, 1.0 }, 1e-4 },
         Case{ "lamp behind", { 0.5, 0.5, 13.0, 1.0 }, 1e-4 },
       })
  {
    EXPECT_LT(this->GetError(each.Light), each.Bound) << each.Name;
  }
  // a thing that casts no shadow into the picture
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -25.0 }, { 200.0, 200.0, 0.1 }));
  EXPECT_LT(this->GetError({ 0.0, 0.2, 1.0, 0.0 }), 1e-4);
}

TEST_F(GodRaysShadowMap, IsTheGroundTruthWithOccluders)
{
  this->Integrator->SetNumberOfNestedMaps(4);
  this->AddPillars();
  this->CheckErrors({
    { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.003 },
    { "edge", { 0.5, 0.2, -1.0, 0.0 }, 0.0006 },
    { "beside", { 1.0, 0.3, -0.1, 0.0 }, 0.0001 },
    { "behind", { 0.3, 0.4, 1.0, 0.0 }, 0.0008 },
    { "lamp hidden in front", { 0.0, 0.5, -2.0, 1.0 }, 0.0002 },
    { "lamp beside", { 6.0, 1.0, 0.5, 1.0 }, 0.0002 },
    { "lamp between", { 0.6, 3.5, 2.0, 1.0 }, 0.00004 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.0002 },
  });
}

// Each colour is extinguished in its own way, so that shadows weigh differently.
TEST_F(GodRaysShadowMap, IsTheGroundTruthInThreeColours)
{
  this->AddPillars();
  this->Model->SetScatteringCoefficient(0.02, 0.05, 0.1);
  this->Model->SetAbsorptionCoefficient(0.0, 0.02, 0.3);
  this->CheckErrors({ { "front", { 0.15, 0.1, -1.0, 0.0 }, 0.003 } });
}

// The control: so coarse a map must fail.
TEST_F(GodRaysShadowMap, NeedsPixels)
{
  this->AddPillars();
  const std::array<double, 4> light{ 0.15, 0.1, -1.0, 0.0 };
  const double fine = this->GetError(light);
  this->Integrator->SetMapSize(64);
  const double coarse = this->GetError(light);
  std::cout << "error " << fine << ", in a map of 64 pixels: " << coarse << "\n";
  EXPECT_GT(coarse, 1.6 * fine);
}

// Beside the picture, and behind what is seen. The control is the picture that lacks them.
TEST_F(GodRaysShadowMap, SeesWhatThePictureDoesNot)
{
  const auto check = [this](const char* name, vtkActor* unseen, std::array<double, 4> light)
  {
    this->Renderer->AddActor(unseen);
    const double error = this->GetError(light);
    this->Renderer->RemoveActor(unseen);
    auto lacking = this->GetScattering();
    this->Renderer->AddActor(unseen);
    const double without = GetErrorOfMedium(this->Renderer, this->Model, light, lacking);
    std::cout << name << ": " << error << ", without it " << without << "\n";
    EXPECT_LT(error, 0.0005) << name;
    EXPECT_GT(without, 5.0 * error) << name;
  };
  check("outside", MakeBox({ 9.0, 0.5, 0.0 }, { 0.5, 2.0, 4.0 }), { 1.0, 0.1, 0.0, 0.0 });
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddActor(MakeBox({ -1.0, 0.0, 3.0 }, { 2.0, 2.0, 0.1 }));
  check("hidden", MakeBox({ -1.5, 0.0, -1.0 }, { 2.0, 2.0, 1.0 }), { -0.6, 0.2, -1.0, 0.0 });
}

TEST_F(GodRaysShadowMap, SurroundsALampWithMaps)
{
  this->AddPillars();
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -3.0 }, { 8.0, 6.0, 0.2 }));
  this->Renderer->AddActor(MakeBox({ 0.6, 3.0, -1.5 }, { 0.3, 0.2, 3.0 }));
  const double error = this->GetError({ 0.0, 0.5, -1.5, 1.0 }); // behind a pillar
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "6 of 1024")) << this->Rays->GetPlan();
  std::cout << "error " << error << "\n";
  EXPECT_LT(error, 0.0005);
}

TEST_F(GodRaysShadowMap, IsTheSameInAParallelProjection)
{
  this->AddPillars();
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  const double error = this->GetError({ 0.5, 0.3, -1.0, 0.0 });
  std::cout << "error " << error << "\n";
  EXPECT_LT(error, 0.001); // the sides that the view does not show cast shadows, too
}

// One text runs in both; a lamp beside a sun is added to what the sun gave. The control is a coarser map.
TEST_F(GodRaysShadowMap, IsTheSameInComputeShadersAndInFragments)
{
  this->AddPillars();
  const std::vector<std::array<double, 4>> lights[] = { { { 0.15, 0.1, -1.0, 0.0 } },
    { { 6.0, 1.0, 0.5, 1.0 } }, { { 0.5, 0.2, -1.0, 0.0 }, { 0.0, 0.5, -2.0, 1.0 } } };
  for (const bool parallel : { false, true })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    this->Model->SetScatteringCoefficient(0.05, 0.05, parallel ? 0.1 : 0.05);
    for (const auto& some : lights)
    {
      this->Rays->RemoveAllLights();
      for (const auto& light : some)
      {
        this->Rays->AddLight(light[3] == 0.0 ? MakeSun({ light[0], light[1], light[2] })
                                             : MakeLamplight({ light[0], light[1], light[2] }));
      }
      const auto draw = [this](int backend, int size, const char* plan)
      {
        this->Integrator->SetBackend(backend);
        this->Integrator->SetMapSize(size);
        auto image = this->GetScattering();
        EXPECT_TRUE(Says(this->Rays->GetPlan(), plan)) << this->Rays->GetPlan();
        return image;
      };
      const auto computed = draw(vtkGodRaysIntegrator::GRAPHICS, 1024, "walked in compute shaders");
      const auto drawn = draw(vtkGodRaysIntegrator::FRAGMENTS, 1024, "walked in fragment shaders");
      const auto coarse = draw(vtkGodRaysIntegrator::GRAPHICS, 256, "walked in compute shaders");
      const double mean = GetMean(computed);
      EXPECT_GT(mean, 0.0);
      EXPECT_LT(GetLargestDifference(computed, drawn), 1e-6 * mean);
      EXPECT_GT(GetLargestDifference(computed, coarse), 1e-4 * mean);
    }
  }
}

TEST_F(GodRaysShadowMap, KeepsTheMapWhileNothingInItChanges)
{
  this->Integrator->SetBackend(vtkGodRaysIntegrator::PROCESSOR);
  this->AddPillars();
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(box);
  auto sun = this->AddSun({ 0.15, 0.1, -1.0 });
  const auto isKept = [this]()
  {
    this->Scene.Window->Render();
    return Says(this->Rays->GetPlan(), ", kept");
  };
  EXPECT_FALSE(isKept());
  const auto before = GetPixels(this->Scene.Window);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept"));
  this->Model->SetScatteringCoefficient(0.1, 0.1, 0.1);
  EXPECT_TRUE(isKept());
  this->Model->SetScatteringCoefficient(0.05, 0.05, 0.05);
  sun->SetPosition(0.3, 0.1, -1.0);
  EXPECT_FALSE(isKept());
  sun->SetPosition(0.15, 0.1, -1.0);
  EXPECT_FALSE(isKept());
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  box->SetPosition(0.3, 0.0, 0.0);
  EXPECT_FALSE(isKept());
  EXPECT_GT(GetLargestDifference(before, GetPixels(this->Scene.Window)), 2);
  vtkPolyDataMapper::SafeDownCast(box->GetMapper())->GetInput()->GetPoints()->Modified();
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plane->SetOrigin(-10.0, 0.0, 0.0);
  box->GetMapper()->AddClippingPlane(plane);
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  const auto whole = GetPixels(this->Scene.Window);
  plane->SetOrigin(0.5, 0.0, 0.0);
  EXPECT_FALSE(isKept());
  EXPECT_GT(GetLargestDifference(whole, GetPixels(this->Scene.Window)), 2);
  box->VisibilityOff();
  EXPECT_FALSE(isKept());
  this->Renderer->GetActiveCamera()->Azimuth(1.0);
  this->Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(isKept()); // all that casts a shadow is in it
  const auto kept = GetPixels(this->Scene.Window);
  vtkNew<vtkGodRaysShadowMapIntegrator> other;
  other->SetBackend(vtkGodRaysIntegrator::PROCESSOR);
  other->SetMapSize(1024);
  other->SetNumberOfNestedMaps(1);
  this->Rays->SetIntegrator(other);
  EXPECT_FALSE(isKept());
  EXPECT_LE(GetLargestDifference(kept, GetPixels(this->Scene.Window)), 1);
  this->Rays->SetIntegrator(this->Integrator);
  this->Integrator->SetMapSize(512);
  EXPECT_FALSE(isKept());
  this->Scene.Window->Finalize();
  EXPECT_FALSE(isKept());
}

// The depths of what stays where it is are kept; what is drawn over them makes the same picture.
TEST_F(GodRaysShadowMap, DrawsOnlyWhatMovesAmongThingsThatStay)
{
  this->AddPillars();
  for (const double corner : { -12.0, 12.0 }) // faces stay as they are
  {
    this->Renderer->AddActor(MakeBox({ corner, corner, 0.25 * corner }, { 0.1, 0.1, 0.1 }));
  }
  auto box = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  auto other = MakeBox({ -1.5, 0.5, 2.0 }, { 1.0, 1.0, 0.1 });
  this->Renderer->AddActor(box);
  this->Renderer->AddActor(other);
  auto sun = this->AddSun({ 0.15, 0.1, -1.0 });
  const struct
  {
    double Box;
    double Other;
    const char* Part;                                // of the plan; none: all are drawn
  } frames[] = { { 0.0, 0.0, "" }, { 0.3, 0.0, "" }, // the first time all are drawn, to be kept
    { 0.5, 0.0, "only 1 of" }, { 0.5, 0.1, "" }, { 0.4, 0.2, "only 2 of" },
    { 0.4, 0.3, "only 2 of" } };
  const auto draw = [&](const auto& frame)
  {
    box->SetPosition(frame.Box, 0.0, 0.0);
    other->SetPosition(0.0, frame.Other, 0.0);
    return GetPixels(this->Scene.Window);
  };
  std::vector<decltype(GetPixels(this->Scene.Window))> pictures;
  for (const auto& frame : frames)
  {
    pictures.push_back(draw(frame));
    const std::string plan = this->Rays->GetPlan();
    EXPECT_EQ(Says(plan, ", only "), *frame.Part != 0) << plan;
    EXPECT_TRUE(Says(plan, frame.Part)) << plan;
  }
  EXPECT_GT(GetLargestDifference(pictures[1], pictures[2]), 2);
  EXPECT_GT(GetLargestDifference(pictures[4], pictures[5]), 2);
  sun->SetPosition(0.3, 0.1, -1.0);
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), ", only ")) << this->Rays->GetPlan();
  sun->SetPosition(0.15, 0.1, -1.0);
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    vtkNew<vtkGodRaysShadowMapIntegrator> fresh; // which knows of no frame before
    fresh->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
    fresh->SetMapSize(1024);
    fresh->SetNumberOfNestedMaps(1);
    this->Rays->SetIntegrator(fresh);
    EXPECT_EQ(pictures[i], draw(frames[i])) << i;
  }
}

namespace
{
using Changes = std::vector<std::pair<std::string, std::function<void()>>>;

/// A prop that casts a shadow, and what can change about it, one after another.
struct Thing
{
  vtkSmartPointer<vtkProp> Prop;
  Changes After;
};

vtkSmartPointer<vtkPolyData> MakeData(double shift = 0.0)
{
  auto box = MakeBox({ 0.5 + shift, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  box->GetMapper()->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(box->GetMapper()->GetInput());
  return data;
}

void Shrink(vtkPointSet* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double place[3];
    data->GetPoint(i, place);
    data->GetPoints()->SetPoint(i, 0.8 * place[0], place[1], place[2]);
  }
  data->GetPoints()->Modified();
}

/// Changes of any actor that has a mapper.
Changes MakeChanges(vtkActor* actor, vtkPointSet* data)
{
  vtkNew<vtkMatrix4x4> matrix;
  actor->SetUserMatrix(matrix);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plane->SetOrigin(-10.0, 0.0, 0.0);
  actor->GetMapper()->AddClippingPlane(plane);
  const vtkSmartPointer<vtkMatrix4x4> user = matrix.Get();
  const vtkSmartPointer<vtkPlane> clip = plane.Get();
  return {
    { "points", [=] { Shrink(data); } },
    { "place", [=] { actor->SetPosition(-0.2, 0.1, 0.0); } },
    { "user matrix",
      [=]
      {
        user->SetElement(1, 3, 0.3);
        user->Modified();
      } },
    { "opacity", [=] { actor->GetProperty()->SetOpacity(0.6); } },
    { "colour", [=] { actor->GetProperty()->SetColor(1.0, 0.2, 0.2); } },
    { "opaque", [=] { actor->GetProperty()->SetOpacity(1.0); } },
    { "clipping plane", [=] { clip->SetOrigin(0.3, 0.0, 0.0); } },
    { "invisible", [=] { actor->VisibilityOff(); } },
    { "visible", [=] { actor->VisibilityOn(); } },
  };
}

void Append(Changes& changes, const Changes& more)
{
  changes.insert(changes.end(), more.begin(), more.end());
}

template <typename Actor, typename Mapper>
Thing MakeActor()
{
  vtkNew<Actor> actor;
  vtkNew<Mapper> mapper;
  auto data = MakeData();
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
  Thing thing = { actor.Get(), MakeChanges(actor, data) };
  Append(
    thing.After, { { "input", [mapper = mapper.Get()] { mapper->SetInputData(MakeData(0.4)); } } });
  return thing;
}

Thing MakePlainActor()
{
  auto thing = MakeActor<vtkActor, vtkPolyDataMapper>();
  auto actor = vtkActor::SafeDownCast(thing.Prop);
  Append(thing.After,
    { { "shader",
        [=]
        {
          actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
            "//VTK::PositionVC::Impl\n  gl_Position.x += 0.05 * gl_Position.w;\n", false);
        } },
      { "back face",
        [=]
        {
          vtkNew<vtkProperty> glass;
          glass->SetOpacity(0.3);
          actor->SetBackfaceProperty(glass);
          actor->ForceTranslucentOn();
        } } });
  return thing;
}

Thing MakeCells()
{
  vtkNew<vtkAppendFilter> cells;
  cells->AddInputData(MakeData());
  cells->Update();
  vtkSmartPointer<vtkUnstructuredGrid> grid = cells->GetOutput();
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return { actor.Get(), MakeChanges(actor, grid) };
}

/// Opacity by scalars, through a table.
Thing MakeScalars()
{
  auto data = MakeData();
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(data->GetPoint(i)[0] > 0.5 ? 1.0 : 0.0);
  }
  data->GetPointData()->SetScalars(scalars);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 1.0, 1.0, 1.0);
  table->SetTableValue(1, 1.0, 0.5, 0.5, 0.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(table);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const vtkSmartPointer<vtkDoubleArray> values = scalars.Get();
  return { actor.Get(),
    { { "table", [=] { table->SetTableValue(1, 0.5, 0.5, 1.0, 0.7); } },
      { "scalars",
        [=]
        {
          values->FillValue(1.0);
          values->Modified();
        } } } };
}

/// An image whose right half is glass.
Thing MakeTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto fill = [image = vtkSmartPointer<vtkImageData>(image.Get())](double alpha)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int channel = 0; channel < 4; ++channel)
      {
        image->SetScalarComponentFromDouble(
          i % 2, i / 2, 0, channel, channel == 3 && i % 2 == 1 ? alpha : 255.0);
      }
    }
    image->Modified();
  };
  fill(100.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  auto data = MakeData();
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* point = data->GetPoint(i);
    places->InsertNextTuple2(point[0] > 0.5 ? 1.0 : 0.0, point[1] > 0.5 ? 1.0 : 0.0);
  }
  data->GetPointData()->SetTCoords(places);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  return { actor.Get(), { { "image", [=] { fill(200.0); } }, { "no texture", [a = actor.Get()] {
                                                                a->SetTexture(nullptr);
                                                              } } } };
}

Thing MakeBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  auto data = MakeData();
  blocks->SetBlock(0, data);
  blocks->SetBlock(1, MakeData(-2.5));
  vtkNew<BlockMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  Thing thing = { actor.Get(), {} };
  BlockMapper* m = mapper.Get();
  Append(thing.After,
    { { "block hidden", [=] { m->SetBlockVisibility(2, false); } },
      { "block shown", [=] { m->SetBlockVisibility(2, true); } },
      { "block opacity", [=] { m->SetBlockOpacity(2, 0.5); } },
      { "block opaque", [=] { m->SetBlockOpacity(2, 1.0); } } });
  Append(thing.After, MakeChanges(actor, data));
  Append(thing.After,
    { { "input",
      [=]
      {
        vtkNew<vtkMultiBlockDataSet> other;
        other->SetBlock(0, MakeData(0.4));
        m->SetInputDataObject(other);
      } } });
  return thing;
}

Thing MakeGlyphs()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(-2.5, 0.2, 0.0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  auto source = MakeData();
  mapper->SetInputData(places);
  mapper->SetSourceData(source);
  mapper->ScalingOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  Thing thing = { actor.Get(), MakeChanges(actor, places) };
  for (auto& change : thing.After) // without which VTK does not see another opacity or colour
  {
    change.second = [=, m = mapper.Get(), act = change.second]
    {
      act();
      m->Modified();
    };
  }
  Append(thing.After,
    { { "source", [=] { Shrink(source); } },
      { "another source", [m = mapper.Get()] { m->SetSourceData(MakeData(0.3)); } } });
  return thing;
}

/// A part, another in a part of the part; what is drawn of them moves their parts' times.
template <typename Assembly>
Thing MakeAssembly()
{
  vtkNew<Assembly> whole;
  vtkNew<vtkAssembly> inner;
  auto part = MakeActor<vtkActor, vtkPolyDataMapper>();
  auto other = MakeBox({ -1.8, 0.5, 2.0 }, { 1.0, 1.0, 0.1 });
  inner->AddPart(other);
  auto actor = vtkActor::SafeDownCast(part.Prop);
  whole->AddPart(actor);
  whole->AddPart(inner);
  Thing thing = { whole.Get(), part.After };
  Append(thing.After,
    { { "inner assembly", [a = inner.Get()] { a->SetPosition(0.0, -0.4, 0.0); } },
      { "inner part", [=] { other->SetPosition(0.2, 0.0, 0.0); } },
      { "inner opacity", [=] { other->GetProperty()->SetOpacity(0.5); } },
      { "inner part hidden", [=] { other->VisibilityOff(); } },
      { "part removed", [=, w = whole.Get()] { w->RemovePart(actor); } } });
  return thing;
}

/// It chooses without a word which of two mappers it draws, as ParaView's actors do.
class Chooser : public vtkOpenGLActor
{
public:
  static Chooser* New();
  vtkTypeMacro(Chooser, vtkOpenGLActor);
  vtkMapper* GetMapper() override { return this->Coarse ? this->Other.Get() : this->Mapper; }
  void Render(vtkRenderer* renderer, vtkMapper*) override
  {
    this->Superclass::Render(renderer, this->GetMapper());
  }
  vtkNew<vtkPolyDataMapper> Other;
  bool Coarse = false;
};
vtkStandardNewMacro(Chooser);

Thing MakeChooser()
{
  auto thing = MakeActor<Chooser, vtkPolyDataMapper>();
  auto actor = static_cast<Chooser*>(thing.Prop.Get());
  actor->Other->SetInputData(MakeData(-0.5));
  Append(thing.After, { { "coarse", [=] { actor->Coarse = true; } } });
  return thing;
}

Thing MakeFollower(vtkCamera* camera)
{
  auto thing = MakeActor<vtkFollower, vtkPolyDataMapper>();
  vtkFollower::SafeDownCast(thing.Prop)->SetCamera(camera);
  Append(thing.After, { { "camera", [=] { camera->Azimuth(10.0); } } });
  return thing;
}

struct ThingKind
{
  const char* Name;
  std::function<Thing(vtkCamera*)> Make;
};

void PrintTo(const ThingKind& kind, std::ostream* os)
{
  *os << kind.Name;
}

const ThingKind ThingKinds[] = {
  { "Actor", [](vtkCamera*) { return MakePlainActor(); } },
  { "DataSetMapper", [](vtkCamera*) { return MakeCells(); } },
  { "LODActor", [](vtkCamera*) { return MakeActor<vtkLODActor, vtkPolyDataMapper>(); } },
  { "Scalars", [](vtkCamera*) { return MakeScalars(); } },
  { "Texture", [](vtkCamera*) { return MakeTexture(); } },
  { "Blocks", [](vtkCamera*) { return MakeBlocks(); } },
  { "Glyphs", [](vtkCamera*) { return MakeGlyphs(); } },
  { "Assembly", [](vtkCamera*) { return MakeAssembly<vtkAssembly>(); } },
  { "PropAssembly", [](vtkCamera*) { return MakeAssembly<vtkPropAssembly>(); } },
  { "Chooser", [](vtkCamera*) { return MakeChooser(); } },
  { "Follower", MakeFollower },
};

/// A thing among others in a medium, which has shadow maps with layers.
struct Air
{
  Stage Scene{ 96, 72 };
  Thing Object;

  explicit Air(const std::function<Thing(vtkCamera*)>& make)
    : Object(make(this->Scene.Renderer->GetActiveCamera()))
  {
    vtkNew<vtkGodRaysHomogeneousModel> model;
    model->SetScatteringCoefficient(0.05, 0.05, 0.05);
    model->SetFarLimit(30.0);
    vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
    integrator->SetNumberOfNestedMaps(1);
    integrator->SetMapSize(256);
    this->Scene.Rays->SetModel(model);
    this->Scene.Rays->SetIntegrator(integrator);
    this->Scene.Rays->AddLight(MakeSun({ 0.15, 0.1, -1.0 }));
    this->Scene.Rays->Attach(this->Scene.Renderer);
    for (const double corner : { -12.0, 12.0 }) // faces stay as they are
    {
      this->Scene.Renderer->AddActor(MakeBox({ corner, corner, 0.25 * corner }, { 0.1, 0.1, 0.1 }));
    }
    this->Scene.Renderer->AddViewProp(this->Object.Prop);
  }

  std::vector<unsigned char> Draw() { return GetPixels(this->Scene.Window); }
  std::string GetPlan() { return this->Scene.Rays->GetPlan(); }
  bool IsKept() { return Says(this->GetPlan(), ", kept, "); }
};

class GodRaysKeptMap : public ::testing::TestWithParam<ThingKind>
{
protected:
  ~GodRaysKeptMap() override
  {
    for (const std::string& text : this->VTKMessages.Take())
    {
      EXPECT_TRUE(Says(text, "was deprecated"))
        << text; // vtkLODActor of VTK 9.1 says that of itself
    }
  }
  Messages VTKMessages;
};
}

TEST_P(GodRaysKeptMap, IsThatOfAFreshWindowAfterEachChange)
{
  Air air(GetParam().Make);
  auto before = air.Draw();
  EXPECT_FALSE(air.IsKept()) << air.GetPlan();
  EXPECT_EQ(before, air.Draw());
  EXPECT_TRUE(air.IsKept()) << air.GetPlan();
  for (std::size_t i = 0; i < air.Object.After.size(); ++i)
  {
    SCOPED_TRACE(air.Object.After[i].first);
    air.Object.After[i].second();
    const auto now = air.Draw();
    EXPECT_FALSE(air.IsKept()) << air.GetPlan();
    EXPECT_NE(now, before);
    Air fresh(GetParam().Make);
    for (std::size_t j = 0; j <= i; ++j)
    {
      fresh.Object.After[j].second();
    }
    EXPECT_EQ(now, fresh.Draw());
    EXPECT_EQ(now, air.Draw());
    EXPECT_TRUE(air.IsKept()) << air.GetPlan();
    before = now;
  }
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysKeptMap, ::testing::ValuesIn(ThingKinds),
  [](const auto& info) { return std::string(info.param.Name); });

namespace
{
/// A prop of a class that tells nothing of what it draws.
class Secret : public vtkProp3D
{
public:
  static Secret* New();
  vtkTypeMacro(Secret, vtkProp3D);
  double* GetBounds() override { return this->Inner->GetBounds(); }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    return this->Inner->RenderOpaqueGeometry(viewport);
  }
  vtkSmartPointer<vtkActor> Inner = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
};
vtkStandardNewMacro(Secret);

/// Gives a shader a number in each draw.
class SetShift : public vtkCommand
{
public:
  static SetShift* New() { return new SetShift; }
  void Execute(vtkObject*, unsigned long, void* program) override
  {
    static_cast<vtkShaderProgram*>(program)->SetUniformf("shift", static_cast<float>(*this->Shift));
  }
  std::shared_ptr<double> Shift;
};

/// A change that nothing tells of, for what is not kept.
const ThingKind UnkeptKinds[] = {
  { "Secret",
    [](vtkCamera*)
    {
      vtkNew<Secret> prop;
      return Thing{ prop.Get(),
        { { "", [=, p = prop.Get()] { p->Inner->SetPosition(0.4, 0.0, 0.0); } } } };
    } },
  { "SecretInAnAssembly",
    [](vtkCamera*)
    {
      vtkNew<Secret> prop;
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(prop);
      return Thing{ assembly.Get(),
        { { "", [p = prop.Get()] { p->Inner->SetPosition(0.4, 0.0, 0.0); } } } };
    } },
  { "ShaderParameters",
    [](vtkCamera*)
    {
      auto thing = MakeActor<vtkActor, vtkPolyDataMapper>();
      auto shift = std::make_shared<double>(0.0);
      auto actor = vtkActor::SafeDownCast(thing.Prop);
      actor->GetShaderProperty()->AddVertexShaderReplacement(
        "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nuniform float shift;\n", false);
      actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
        "//VTK::PositionVC::Impl\n  gl_Position.x += shift * gl_Position.w;\n", false);
      vtkNew<SetShift> observer;
      observer->Shift = shift;
      actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, observer);
      return Thing{ actor, { { "", [=] { *shift = 0.05; } } } };
    } },
};
}

// Props whose changes VTK cannot see are drawn in each frame; those beside them are not.
TEST(GodRaysUnkeptMap, IsThatOfAFreshWindow)
{
  Messages messages;
  for (const ThingKind& kind : UnkeptKinds)
  {
    SCOPED_TRACE(kind.Name);
    Air air(kind.Make);
    const auto before = air.Draw();
    EXPECT_EQ(before, air.Draw());
    EXPECT_EQ(before, air.Draw());
    EXPECT_TRUE(Says(air.GetPlan(), "drawn, only 1 of 3 props")) << air.GetPlan();
    air.Object.After[0].second();
    const auto now = air.Draw();
    EXPECT_NE(now, before);
    Air fresh(kind.Make);
    fresh.Object.After[0].second();
    EXPECT_EQ(now, fresh.Draw());
  }
}

#if __has_include("vtkLODActor.h")
namespace
{
/// A mapper that says that it takes less time than others.
class Quick : public vtkOpenGLPolyDataMapper
{
public:
  static Quick* New();
  vtkTypeMacro(Quick, vtkOpenGLPolyDataMapper);

protected:
  Quick() { this->TimeToDraw = 1e-6; }
};
vtkStandardNewMacro(Quick);
}

// An actor that has too little time draws another mapper, as times tell it to that may differ by frame.
TEST(GodRaysUnkeptMap, IsOfTheLevelOfDetailOfTheFrame)
{
  Messages messages;
  Air air(
    [](vtkCamera*)
    {
      auto thing = MakeActor<vtkLODActor, vtkPolyDataMapper>();
      vtkNew<Quick> quick;
      quick->SetInputData(MakeData(-0.5));
      vtkLODActor::SafeDownCast(thing.Prop)->AddLODMapper(quick);
      return thing;
    });
  const auto still = air.Draw();
  for (int i = 0; i < 2; ++i)
  {
    air.Scene.Window->SetDesiredUpdateRate(1e9);
    const auto coarse = air.Draw();
    EXPECT_FALSE(air.IsKept()) << air.GetPlan();
    EXPECT_NE(coarse, still);
    EXPECT_EQ(coarse, air.Draw());
    EXPECT_FALSE(air.IsKept()) << air.GetPlan();
    air.Scene.Window->SetDesiredUpdateRate(0.0001);
    EXPECT_EQ(still, air.Draw());
    EXPECT_FALSE(air.IsKept()) << air.GetPlan();
    EXPECT_EQ(still, air.Draw());
    EXPECT_TRUE(air.IsKept()) << air.GetPlan();
  }
  messages.Take(); // vtkLODActor of VTK 9.1 says that it was deprecated
}
#endif

TEST_F(GodRaysShadowMap, AsksNoOtherProcessWhereOneHasAllData)
{
  this->AddPillars();
  this->AddSun({ 0.15, 0.1, -1.0 });
  vtkNew<LonelyCompositor> compositor;
  compositor->Distributed = false;
  this->Rays->SetCompositor(compositor);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "shadow map: 1 of")) << this->Rays->GetPlan();
  EXPECT_EQ(compositor->Calls, 0);
  this->Rays->SetCompositor(nullptr);
}

TEST_F(GodRaysShadowMap, LeavesTheSceneAndRolesAlone)
{
  this->AddPillars();
  auto wall = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(wall);
  auto sun = this->AddSun({ 0.5, 0.3, -1.0 });
  this->Renderer->AddLight(sun);
  this->Model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  this->Model->SetAbsorptionCoefficient(0.0, 0.0, 0.0);
  const auto before = GetPixels(this->Scene.Window); // scatters nothing: drawn straight through
  this->Model->SetScatteringCoefficient(1e-12, 1e-12, 1e-12);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double range[2] = { camera->GetClippingRange()[0], camera->GetClippingRange()[1] };
  const auto times = camera->GetMTime() + sun->GetMTime();
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "shadow map: 1 of"));
  EXPECT_EQ(camera, this->Renderer->GetActiveCamera());
  EXPECT_EQ(range[0], camera->GetClippingRange()[0]);
  EXPECT_EQ(range[1], camera->GetClippingRange()[1]);
  EXPECT_EQ(times, camera->GetMTime() + sun->GetMTime());

  this->Model->SetScatteringCoefficient(0.05, 0.05, 0.05);
  auto blocking = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::IGNORED);
  auto ignored = this->GetScattering();
  wall->VisibilityOff();
  auto empty = this->GetScattering();
  EXPECT_NEAR(GetValue(ignored, 80, 80), GetValue(empty, 80, 80), 1e-6);
  EXPECT_LT(GetValue(blocking, 80, 80), 0.98 * GetValue(empty, 80, 80));
}
