// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a sun is put behind a scene: at edges, where it is seen to be, and again when the view changes.

#include "GodRaysTesting.h"

#include "vtkGodRaysSunPlacer.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkConeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"
#include "vtkMolecule.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace GodRaysTesting;

namespace
{
/// In the place of VTK's, which is of a module that may be missing.
class MoleculeMapper : public vtkMapper
{
public:
  static MoleculeMapper* New();
  vtkTypeMacro(MoleculeMapper, vtkMapper);
  void Render(vtkRenderer*, vtkActor*) override {}
  int FillInputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMolecule");
    return 1;
  }
};
vtkStandardNewMacro(MoleculeMapper);

class GodRaysSunPlacer : public ::testing::Test
{
protected:
  static constexpr int Width = 320;
  static constexpr int Height = 240;

  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;
  vtkNew<vtkGodRaysSunPlacer> Placer;

  GodRaysSunPlacer() { this->Rays->Attach(this->Renderer); }

  /// A grid of boxes with gaps, left of the middle.
  void AddBoxes()
  {
    for (int i = 0; i < 5; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        this->Renderer->AddActor(
          MakeBox({ -2.0 + 0.6 * i, -0.5 + 0.7 * j, 0.0 }, { 0.25, 0.4, 0.2 }));
      }
    }
  }

  /// How much the rays vary along circles about the light: the root mean square of their difference from
  /// the mean of each circle.
  double GetContrast(double placeX, double placeY)
  {
    this->Scene.Window->Render();
    vtkNew<vtkImageData> image;
    if (!this->Rays->GetScatteringImage(image))
    {
      return 0.0;
    }
    const auto* values = static_cast<const float*>(image->GetScalarPointer());
    std::vector<double> sums(1000);
    std::vector<double> squares(1000);
    std::vector<int> counts(1000);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const int ring =
          static_cast<int>(std::hypot(x - placeX * Width, y - placeY * Height) / 4.0);
        const double value = values[3 * (y * Width + x) + 1];
        sums[ring] += value;
        squares[ring] += value * value;
        ++counts[ring];
      }
    }
    double variance = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      variance += counts[i] > 0 ? squares[i] - sums[i] * sums[i] / counts[i] : 0.0;
    }
    return std::sqrt(variance / (Width * Height));
  }
};
}

TEST_F(GodRaysSunPlacer, TakesAPlaceAmongEdges)
{
  this->AddBoxes();
  ASSERT_TRUE(this->Placer->Find(this->Renderer));
  const double* place = this->Placer->GetPlace();
  std::cout << "at " << place[0] << " " << place[1] << ", score " << this->Placer->GetScore()
            << ", covered " << this->Placer->GetCoverage() << "\n";
  EXPECT_GT(place[0], 0.1);
  EXPECT_LT(place[0], 0.65);
  EXPECT_GT(this->Placer->GetScore(), 1.0);
  EXPECT_GT(this->Placer->GetCoverage(), 0.02);
  EXPECT_LT(this->Placer->GetCoverage(), 0.5);

  // Its shafts vary more than those of suns in the open.
  this->Rays->PlaceSun(this->Renderer);
  const double here = this->GetContrast(place[0], place[1]);
  for (const std::pair<double, double>& other :
    { std::pair<double, double>{ 0.9, 0.9 }, { 0.9, 0.5 }, { 0.5, 0.97 } })
  {
    this->Rays->PlaceSun(this->Renderer, other.first, other.second);
    const double there = this->GetContrast(other.first, other.second);
    std::cout << "contrast " << here << ", at " << other.first << " " << other.second << " "
              << there << "\n";
    EXPECT_GT(here, 1.2 * there);
  }
  EXPECT_EQ(this->Rays->GetNumberOfLights(), 1) << "one sun, that is moved";
}

// What the props cover gets less of the rays than the open picture, as the sun stands at their edge and not
// among them.
TEST_F(GodRaysSunPlacer, KeepsGlareOffTheData)
{
  const auto add = [this](vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
  };
  const std::vector<std::pair<const char*, std::function<void()>>> scenes = {
    { "ball",
      [&]
      {
        vtkNew<vtkSphereSource> ball;
        ball->SetRadius(1.5);
        ball->SetThetaResolution(40);
        ball->SetPhiResolution(40);
        add(ball);
      } },
    { "helix of balls",
      [&]
      {
        for (int i = 0; i < 30; ++i)
        {
          vtkNew<vtkSphereSource> ball;
          ball->SetRadius(0.22);
          ball->SetCenter(std::cos(0.6 * i), -1.5 + 0.1 * i, std::sin(0.6 * i));
          add(ball);
        }
      } },
    { "ring of cones",
      [&]
      {
        for (int i = 0; i < 5; ++i)
        {
          const double angle = 2.0 * vtkMath::Pi() * i / 5;
          vtkNew<vtkConeSource> cone;
          cone->SetDirection(0.0, 1.0, 0.0);
          cone->SetHeight(1.6);
          cone->SetRadius(0.4);
          cone->SetResolution(24);
          cone->SetCenter(1.6 * std::cos(angle), 0.0, 1.6 * std::sin(angle));
          add(cone);
        }
      } },
    { "rods",
      [&]
      {
        for (int i = 0; i < 24; ++i)
        {
          this->Renderer->AddActor(
            MakeBox({ 1.8 * std::sin(2.4 * i), 0.0, 0.1 * i }, { 0.05, 2.5, 0.05 }));
          this->Renderer->AddActor(
            MakeBox({ 0.0, 1.2 * std::sin(2.4 * i), 0.1 * i }, { 3.6, 0.05, 0.05 }));
        }
      } },
  };
  for (const auto& [name, make] : scenes)
  {
    make();
    this->Rays->RemoveAllLights();
    vtkLight* sun = this->Rays->PlaceSun(this->Renderer);
    ASSERT_NE(sun, nullptr);
    const auto depths = GetDepths(this->Scene.Window);
    vtkNew<vtkImageData> rays;
    ASSERT_TRUE(this->Rays->GetScatteringImage(rays));
    const auto* values = static_cast<const float*>(rays->GetScalarPointer());
    double sums[2] = {};
    int counts[2] = {};
    for (int i = 0; i < Width * Height; ++i)
    {
      const int covered = depths[i] < 1.0f ? 1 : 0;
      sums[covered] += values[3 * i + 1];
      ++counts[covered];
    }
    const double open = sums[0] / counts[0];
    const double data = sums[1] / counts[1];
    ASSERT_TRUE(this->Placer->Find(this->Renderer));
    const double* place = this->Placer->GetPlace();
    const double contrast = this->GetContrast(place[0], place[1]);
    std::cout << name << ": rays " << data << " over the data, " << open
              << " beside them, contrast " << contrast << "\n";
    EXPECT_LT(data, 0.8 * open) << name;
    EXPECT_GT(contrast, 0.04) << name;
    this->Renderer->RemoveAllViewProps();
  }
}

TEST_F(GodRaysSunPlacer, IsWhereTheSunIsSeen)
{
  this->AddBoxes();
  this->Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
  this->Rays->SetBackgroundGlow(0.0);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->Azimuth(25.0);
  camera->Roll(15.0);
  this->Renderer->ResetCameraClippingRange();
  for (const bool parallel : { false, true })
  {
    camera->SetParallelProjection(parallel);
    this->Rays->PlaceSun(this->Renderer, 0.93, 0.85);
    const auto pixels = GetPixels(this->Scene.Window);
    double sums[3] = {};
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const double value =
          pixels[pixels.size() / (Width * Height) * (y * Width + x)] > 128 ? 1.0 : 0.0;
        sums[0] += value;
        sums[1] += value * (x + 0.5);
        sums[2] += value * (y + 0.5);
      }
    }
    ASSERT_GT(sums[0], 0.0) << "parallel " << parallel;
    EXPECT_NEAR(sums[1] / sums[0], 0.93 * Width, 2.0) << "parallel " << parallel;
    EXPECT_NEAR(sums[2] / sums[0], 0.85 * Height, 2.0) << "parallel " << parallel;
  }
}

// An empty scene, and one that fills the picture, have a place, too.
TEST_F(GodRaysSunPlacer, HasADefault)
{
  EXPECT_FALSE(this->Placer->Find(this->Renderer));
  EXPECT_EQ(this->Placer->GetScore(), 0.0);
  EXPECT_EQ(this->Placer->GetPlace()[0], 0.35);
  EXPECT_EQ(this->Placer->GetPlace()[1], 0.75);
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, 0.0 }, { 500.0, 500.0, 1.0 }));
  EXPECT_FALSE(this->Placer->Find(this->Renderer));
  EXPECT_EQ(this->Placer->GetCoverage(), 1.0);
  this->Placer->SetLowest(0.9);
  EXPECT_FALSE(this->Placer->Find(this->Renderer));
  EXPECT_EQ(this->Placer->GetPlace()[1], 0.9);
  EXPECT_FALSE(this->Placer->Find(nullptr));
  EXPECT_EQ(this->Rays->PlaceSun(nullptr), nullptr);
  EXPECT_EQ(this->VTKMessages.Take().size(), 2u);
}

// A ball that fills nearly all of the picture leaves its corners.
TEST_F(GodRaysSunPlacer, LooksForAnOpeningIfTheDefaultIsHidden)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(30);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->Renderer->ResetCamera();
  this->Renderer->GetActiveCamera()->Zoom(2.6);
  this->Placer->Find(this->Renderer);
  EXPECT_GT(this->Placer->GetCoverage(), 0.9);
  EXPECT_LT(this->Placer->GetCoverage(), 1.0);
  const double* place = this->Placer->GetPlace();
  EXPECT_GT(place[1], 0.85);
  EXPECT_GT(std::abs(place[0] - 0.5), 0.35);
}

TEST_F(GodRaysSunPlacer, FollowsIfAsked)
{
  this->AddBoxes();
  const auto getSun = [this]()
  {
    this->Scene.Window->Render();
    vtkLight* sun = this->Rays->GetLight(0);
    return sun ? std::vector<double>(sun->GetPosition(), sun->GetPosition() + 3)
               : std::vector<double>();
  };
  EXPECT_TRUE(getSun().empty());
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
  const auto first = getSun();
  ASSERT_EQ(first.size(), 3u);
  EXPECT_GT(this->GetContrast(0.4, 0.6), 0.01) << "there are rays in the first frame";
  this->Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_EQ(getSun(), first);
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_EVERY_VIEW);
  const auto second = getSun();
  EXPECT_NE(second, first);
  this->Renderer->ResetCameraClippingRange();
  EXPECT_EQ(getSun(), second) << "the view is the same";
  this->Scene.Window->SetDesiredUpdateRate(15.0);
  this->Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_EQ(getSun(), second) << "the camera is dragged";
  this->Scene.Window->SetDesiredUpdateRate(0.0001);
  EXPECT_NE(getSun(), second);
  EXPECT_EQ(this->Rays->GetNumberOfLights(), 1);
  this->Rays->RemoveAllLights();
  EXPECT_EQ(getSun().size(), 3u);
}

// As long as there is nothing to see, the sun is put again.
TEST_F(GodRaysSunPlacer, WaitsForAScene)
{
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
  this->Scene.Window->Render();
  ASSERT_EQ(this->Rays->GetNumberOfLights(), 1);
  const std::vector<double> empty(
    this->Rays->GetLight(0)->GetPosition(), this->Rays->GetLight(0)->GetPosition() + 3);
  this->AddBoxes();
  this->Scene.Window->Render();
  const std::vector<double> full(
    this->Rays->GetLight(0)->GetPosition(), this->Rays->GetLight(0)->GetPosition() + 3);
  EXPECT_NE(empty, full);
}

TEST_F(GodRaysSunPlacer, SeesLinesSplatsAndMolecules)
{
  const auto cover = [this](vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->Placer->Find(this->Renderer);
    const double covered = this->Placer->GetCoverage();
    this->Renderer->RemoveActor(actor);
    return covered;
  };

  // A line of two points covers what lies between them, a third of the picture's 170 columns or more.
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-2.0, 0.0, 0.0);
  line->SetPoint2(2.0, 0.5, 0.0);
  vtkNew<vtkPolyDataMapper> ofLine;
  ofLine->SetInputConnection(line->GetOutputPort());
  EXPECT_GT(cover(ofLine), 57.0 / (170 * 128));

  // Splats, which need no cells, are as large as their scale.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputData(cloud);
  splats->SetScaleFactor(0.3);
  const double small = cover(splats);
  splats->SetScaleFactor(0.9);
  const double large = cover(splats);
  EXPECT_GT(small, 0.0);
  EXPECT_NEAR(large / small, 9.0, 3.0);

  // Atoms are balls, bonds are sticks.
  vtkNew<vtkMolecule> molecule;
  const auto first = molecule->AppendAtom(6, -1.0, 0.0, 0.0);
  const auto second = molecule->AppendAtom(6, 1.0, 0.0, 0.0);
  vtkNew<MoleculeMapper> balls;
  balls->SetInputDataObject(molecule);
  const double apart = cover(balls);
  EXPECT_GT(apart, 0.0);
  molecule->AppendBond(first, second, 1);
  molecule->Modified();
  EXPECT_GT(cover(balls), 5.0 * apart);
}

TEST_F(GodRaysSunPlacer, SeesPropsOfAllKinds)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->Update();
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-10, 10, -10, 10, -10, 10);
  wavelet->Update();
  vtkNew<vtkActor> actor;
  const auto makeActor = [&](vtkMapper* mapper)
  {
    actor->SetMapper(mapper);
    return actor.Get();
  };
  vtkNew<vtkDataSetMapper> ofData;
  ofData->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputConnection(sphere->GetOutputPort());
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere->GetOutput());
  vtkNew<vtkCompositePolyDataMapper> ofBlocks;
  ofBlocks->SetInputDataObject(blocks);
  vtkNew<vtkSmartVolumeMapper> ofVolume;
  ofVolume->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.5);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(ofVolume);
  volume->GetProperty()->SetScalarOpacity(opacity);
  vtkNew<vtkImageSliceMapper> ofSlice;
  ofSlice->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(ofSlice);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(MakeBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  vtkNew<vtkActor> nothing;
  vtkNew<vtkVolume> noVolume;
  vtkNew<vtkImageSlice> noSlice;
  const std::vector<std::pair<const char*, std::function<vtkProp*()>>> props = {
    { "data set", [&] { return makeActor(ofData); } },
    { "glyphs", [&] { return makeActor(glyphs); } },
    { "blocks", [&] { return makeActor(ofBlocks); } }, { "volume", [&] { return volume.Get(); } },
    { "slice", [&] { return slice.Get(); } }, { "assembly", [&] { return assembly.Get(); } }
  };
  for (const auto& [name, make] : props)
  {
    vtkProp* prop = make();
    this->Renderer->AddViewProp(prop);
    this->Renderer->AddViewProp(nothing);
    this->Renderer->AddViewProp(noVolume);
    this->Renderer->AddViewProp(noSlice);
    this->Placer->Find(this->Renderer);
    EXPECT_GT(this->Placer->GetCoverage(), 0.0) << name;
    vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::IGNORED);
    this->Placer->Find(this->Renderer);
    EXPECT_EQ(this->Placer->GetCoverage(), 0.0) << name;
    vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::AUTOMATIC);
    prop->VisibilityOff();
    this->Placer->Find(this->Renderer);
    EXPECT_EQ(this->Placer->GetCoverage(), 0.0) << name;
    prop->VisibilityOn();
    this->Renderer->RemoveAllViewProps();
  }
}

TEST_F(GodRaysSunPlacer, SeesTheRectangleOfASlice)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-1, 1, -2, 2, -1, 1);
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  const auto cover = [this](vtkProp3D* prop)
  {
    prop->SetPosition(0.3, 0.2, 0.0);
    prop->SetOrientation(25.0, 35.0, 0.0);
    this->Renderer->AddViewProp(prop);
    this->Placer->Find(this->Renderer);
    this->Renderer->RemoveAllViewProps();
    return this->Placer->GetCoverage();
  };
  for (const int axis : { 0, 1, 2 })
  {
    for (const int number : { 0, 1 }) // in the image's middle, and at its end
    {
      mapper->SetOrientation(axis);
      mapper->SetSliceNumber(number);
      std::array<double, 3> center = { 0.0, 0.0, 0.0 };
      std::array<double, 3> size = { 2.0, 4.0, 2.0 };
      center[axis] = number;
      size[axis] = 0.0;
      const double expected = cover(MakeBox(center, size));
      EXPECT_GT(expected, 0.01) << axis;
      EXPECT_NEAR(cover(slice), expected, 0.05 * expected) << axis << " " << number;
    }
  }
}
