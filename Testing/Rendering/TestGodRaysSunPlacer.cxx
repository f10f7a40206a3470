// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a sun is put behind a scene: where it makes the most shafts, for props of any kind, and again when
// that changes.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysSunPlacer.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLight.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <random>
#include <utility>
#include <vector>

using namespace GodRaysTesting;

namespace
{
constexpr int Columns = 96;
constexpr int Rows = 60;

/// A coverage of discs, bars and holes; a convex disc alone for the first seed.
vtkSmartPointer<vtkImageData> MakeCoverage(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(values, Columns * Rows, 0.0f);
  const auto addDisc = [&](double x, double y, double radius, float value)
  {
    for (int i = 0; i < Columns * Rows; ++i)
    {
      if (std::hypot(i % Columns + 0.5 - x * Columns, i / Columns + 0.5 - y * Rows) < radius * Rows)
      {
        values[i] = value;
      }
    }
  };
  addDisc(0.35 + 0.3 * part(random), 0.4 + 0.2 * part(random), 0.2 + 0.1 * part(random), 1.0f);
  const int count = seed == 0 ? 0 : 4 + static_cast<int>(random() % 12);
  for (int i = 0; i < count; ++i)
  {
    addDisc(0.2 + 0.6 * part(random), 0.2 + 0.6 * part(random), 0.02 + 0.08 * part(random),
      seed % 2 == 0 || i % 3 == 0 ? 1.0f : 0.0f);
  }
  return image;
}

class GodRaysSunPlacer : public ::testing::Test
{
protected:
  static constexpr int Width = 320;
  static constexpr int Height = 240;

  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;
  vtkGodRaysSunPlacer* Placer = Rays->GetSunPlacer();

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

  std::vector<double> GetSun()
  {
    this->Scene.Window->Render();
    vtkLight* sun = this->Rays->GetLight(0);
    return sun ? std::vector<double>(sun->GetPosition(), sun->GetPosition() + 3)
               : std::vector<double>();
  }

  /// The fraction of the picture that blocks light, as the pass sees it.
  double GetCoverage()
  {
    this->Rays->RemoveAllLights();
    this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
    this->Scene.Window->Render();
    return this->Placer->GetCoverage();
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

TEST(GodRaysSunPlaces, AreNearlyTheBestOfAThousand)
{
  vtkNew<vtkGodRaysSunPlacer> placer;
  double found = 0.0;
  double random = 0.0;
  std::vector<double> times; // of the processors: others on the machine take those of the clock
  constexpr int count = 24;
  for (unsigned int seed = 0; seed < count; ++seed)
  {
    ASSERT_TRUE(placer->SetCoverageImage(MakeCoverage(seed)));
    const std::clock_t begun = std::clock();
    ASSERT_TRUE(placer->Find()) << seed;
    times.push_back(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
    const double* place = placer->GetPlace();
    EXPECT_NEAR(placer->GetScoreAt(place[0], place[1]), placer->GetScore(), 1e-9) << seed;
    double best = 0.0;
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
      const double score = placer->GetScoreAt((i % 40 + 0.5) / 40, 0.2 + 0.8 * (i / 40 + 0.5) / 25);
      best = std::max(best, score);
      sum += score;
    }
    EXPECT_GT(placer->GetScore(), 0.6 * best) << seed;
    found += placer->GetScore() / best / count;
    random += sum / 1000 / best / count;
  }
  std::nth_element(times.begin(), times.begin() + count / 2, times.end());
  std::cout << "score " << found << " of the best on average, a random place " << random << "; "
            << 1000.0 * times[count / 2] << " ms of processors\n";
  EXPECT_GT(found, 0.95);
  EXPECT_LT(random, 0.6) << "a control";
  EXPECT_LT(times[count / 2], 0.030);
}

// A plate with two holes makes more shafts through them than at its edge; without them, there is no place
// within it.
TEST(GodRaysSunPlaces, AreAtHoles)
{
  for (const bool hasHoles : { true, false })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(Columns, Rows, 1);
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* values = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < Columns * Rows; ++i)
    {
      const int x = i % Columns;
      const int y = i / Columns;
      const bool isHole = hasHoles && y >= 28 && y < 34 && x >= 30 && x < 66 && x % 6 < 2;
      values[i] = x >= 4 && x < 92 && y >= 4 && y < 56 && !isHole ? 1.0f : 0.0f;
    }
    vtkNew<vtkGodRaysSunPlacer> placer;
    ASSERT_TRUE(placer->SetCoverageImage(image));
    placer->Find();
    const double* place = placer->GetPlace();
    const bool isWithin = place[0] > 0.2 && place[0] < 0.8 && place[1] > 0.3 && place[1] < 0.7;
    EXPECT_EQ(isWithin, hasHoles) << place[0] << " " << place[1];
  }
}

TEST_F(GodRaysSunPlacer, TakesAPlaceAmongEdges)
{
  this->AddBoxes();
  this->Rays->PlaceSun(this->Renderer);
  const double here = (this->Scene.Window->Render(),
    this->GetContrast(this->Placer->GetPlace()[0], this->Placer->GetPlace()[1]));
  const double* place = this->Placer->GetPlace();
  EXPECT_GT(place[0], 0.1);
  EXPECT_LT(place[0], 0.65);
  EXPECT_GT(this->Placer->GetScore(), 1.0);
  EXPECT_GT(this->Placer->GetCoverage(), 0.02);
  EXPECT_LT(this->Placer->GetCoverage(), 0.5);
  // Its shafts vary more than those of suns in the open.
  for (const std::pair<double, double>& other :
    { std::pair<double, double>{ 0.9, 0.9 }, { 0.9, 0.5 }, { 0.5, 0.97 } })
  {
    this->Rays->PlaceSun(this->Renderer, other.first, other.second);
    EXPECT_GT(here, 1.2 * this->GetContrast(other.first, other.second));
  }
  EXPECT_EQ(this->Rays->GetNumberOfLights(), 1) << "one sun, that is moved";
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
    vtkLight* sun = this->Rays->PlaceSun(this->Renderer, 0.93, 0.85);
    double place[2];
    ASSERT_TRUE(vtkGodRaysSunPlacer::FindPlace(this->Renderer, sun, place));
    EXPECT_NEAR(place[0], 0.93, 1e-6);
    EXPECT_NEAR(place[1], 0.85, 1e-6);
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

// An empty scene, one that fills the picture, and one that leaves its corners have a place, too.
TEST_F(GodRaysSunPlacer, HasAPlaceInAnyCase)
{
  EXPECT_EQ(this->GetCoverage(), 0.0);
  EXPECT_EQ(this->Placer->GetScore(), 0.0);
  EXPECT_EQ(this->Placer->GetPlace()[0], 0.35);
  EXPECT_EQ(this->Placer->GetPlace()[1], 0.75);
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
  const double covered = this->GetCoverage();
  EXPECT_GT(covered, 0.9);
  EXPECT_LT(covered, 1.0);
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, 0.0 }, { 500.0, 500.0, 0.1 }));
  EXPECT_EQ(this->GetCoverage(), 1.0);
  EXPECT_EQ(this->Placer->GetScore(), 0.0);
  this->Placer->SetLowest(0.9);
  this->GetCoverage();
  EXPECT_GE(this->Placer->GetPlace()[1], 0.9 - 0.5 / Rows);
  EXPECT_EQ(this->Rays->PlaceSun(nullptr), nullptr);
  vtkNew<vtkImageData> other;
  EXPECT_FALSE(this->Placer->SetCoverageImage(other));
  EXPECT_FALSE(this->Placer->SetCoverageImage(nullptr));
  EXPECT_EQ(this->VTKMessages.Take().size(), 3u);
}

// A flat ground that is seen from above has no sun under it, nor before its far corner.
TEST_F(GodRaysSunPlacer, StandsAboveTheGround)
{
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, 0.0 }, { 4.0, 0.02, 4.0 }));
  for (int i = 0; i < 9; ++i)
  {
    this->Renderer->AddActor(
      MakeBox({ -1.4 + 1.4 * (i % 3), 0.3, -1.4 + 1.4 * (i / 3) }, { 0.4, 0.6, 0.4 }));
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  for (const double azimuth : { 0.0, 30.0, 45.0, 70.0 })
  {
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, 3.0, 6.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->Azimuth(azimuth);
    this->Renderer->ResetCamera();
    this->GetCoverage();
    double highest = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      this->Renderer->SetWorldPoint(i % 2 ? 2.0 : -2.0, -0.01, i / 2 ? 2.0 : -2.0, 1.0);
      this->Renderer->WorldToView();
      highest = std::max(highest, 0.5 + 0.5 * this->Renderer->GetViewPoint()[1]);
    }
    EXPECT_GE(this->Placer->GetPlace()[1], highest - 1.0 / Rows) << azimuth;
    EXPECT_GT(this->Placer->GetScore(), 0.0) << azimuth;
  }
}

TEST_F(GodRaysSunPlacer, FollowsIfAsked)
{
  this->AddBoxes();
  EXPECT_TRUE(this->GetSun().empty());
  this->VTKMessages.Expect("no light reaches the picture (there is none)");
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
  const auto first = this->GetSun();
  ASSERT_EQ(first.size(), 3u);
  EXPECT_GT(this->GetContrast(0.4, 0.6), 0.01) << "there are rays in the first frame";
  this->Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_EQ(this->GetSun(), first);
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_EVERY_VIEW);
  this->Renderer->GetActiveCamera()->Azimuth(0.01); // of the same view there is nothing new to know
  const auto second = this->GetSun();
  EXPECT_NE(second, first);
  this->Renderer->ResetCameraClippingRange();
  EXPECT_EQ(this->GetSun(), second) << "the view is the same";
  this->Renderer->GetActiveCamera()->Azimuth(0.02);
  EXPECT_EQ(this->GetSun(), second) << "its place is as good as others";
  this->Scene.Window->SetDesiredUpdateRate(15.0);
  this->Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_EQ(this->GetSun(), second) << "the camera is dragged";
  this->Scene.Window->SetDesiredUpdateRate(0.0001);
  EXPECT_NE(this->GetSun(), second);
  EXPECT_EQ(this->Rays->GetNumberOfLights(), 1);
  this->Rays->RemoveAllLights();
  EXPECT_EQ(this->GetSun().size(), 3u);
}

// An orbit has rays in each of its pictures where the sun follows, and none of a sun or light that stays and
// leaves the picture without a word.
TEST_F(GodRaysSunPlacer, IsSeenAllAlongAnOrbit)
{
  this->AddBoxes();
  const auto given = MakeSun({ 0.1, 0.2, -1.0 });
  struct Case
  {
    int Placement;
    bool IsGiven;
  };
  for (const Case& each :
    { Case{ vtkGodRaysPass::SUN_EVERY_VIEW, false }, Case{ vtkGodRaysPass::SUN_ONCE, false },
      Case{ vtkGodRaysPass::SUN_BY_HAND, true }, Case{ vtkGodRaysPass::SUN_IF_NO_LIGHT, true },
      Case{ vtkGodRaysPass::SUN_IF_NO_LIGHT, false } })
  {
    this->Rays->RemoveAllLights();
    this->Rays->AddLight(each.IsGiven ? given : nullptr);
    this->Rays->SetSunPlacement(each.Placement);
    int without = 0;
    for (int i = 0; i < 8; ++i)
    {
      this->Renderer->GetActiveCamera()->Azimuth(45.0);
      this->Renderer->ResetCameraClippingRange();
      this->Scene.Window->Render();
      vtkNew<vtkImageData> image;
      const bool hasRays = this->Rays->GetScatteringImage(image);
      const std::string advice = this->Rays->GetAdvice();
      const bool isTold = Says(advice, "sun left the picture") || Says(advice, "no light reaches");
      EXPECT_NE(hasRays, isTold) << each.Placement << " " << i << advice;
      without += hasRays ? 0 : 1;
    }
    EXPECT_EQ(without > 0, each.Placement < vtkGodRaysPass::SUN_EVERY_VIEW) << each.Placement;
  }
  const auto told = this->VTKMessages.Take();
  EXPECT_GE(told.size(), 2u);
  EXPECT_LE(told.size(), 3u); // one of the sun, and one for each cause of the light's
}

// A light that reaches the picture is the only one; where it does not, a sun is placed before it.
TEST_F(GodRaysSunPlacer, IfNoLight_PlacesOnlyWhereNoneReaches)
{
  this->AddBoxes();
  const auto given = MakeSun({ 0.1, 0.2, -1.0 });
  this->Rays->AddLight(given);
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_IF_NO_LIGHT);
  this->Scene.Window->Render();
  EXPECT_EQ(this->Rays->GetNumberOfLights(), 1);
  given->SetPosition(0.1, 0.2, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    this->Scene.Window->Render();
    ASSERT_EQ(this->Rays->GetNumberOfLights(), 2);
    EXPECT_EQ(this->Rays->GetLight(1), given);
    this->Renderer->GetActiveCamera()->Azimuth(60.0);
  }
}

// A lamp in air gives one picture of a scene at any scale. The control has no rays.
TEST_F(GodRaysSunPlacer, LampInAir_AnyScale_LooksTheSame)
{
  this->Scene.Window->SetSize(128, 96);
  vtkNew<vtkGodRaysHomogeneousModel> air;
  ASSERT_TRUE(air->ApplyPreset("haze"));
  this->Rays->SetModel(air);
  this->AddBoxes();
  vtkActorCollection* boxes = this->Renderer->GetActors();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double eye[3];
  camera->GetPosition(eye);
  std::vector<unsigned char> first;
  for (const double scale : { 1.0, 0.01, 100.0, 0.5 })
  {
    for (int i = 0; i < boxes->GetNumberOfItems(); ++i)
    {
      vtkActor::SafeDownCast(boxes->GetItemAsObject(i))->SetScale(scale);
    }
    camera->SetPosition(scale * eye[0], scale * eye[1], scale * eye[2]);
    this->Renderer->ResetCameraClippingRange();
    this->Rays->ResetSceneSize();
    this->Rays->PlaceSun(this->Renderer);
    this->Scene.Window->Render();
    vtkLight* lamp = this->Rays->GetLight(0);
    ASSERT_TRUE(lamp && lamp->GetPositional());
    const auto pixels = GetPixels(this->Scene.Window);
    first = first.empty() ? pixels : first;
    EXPECT_LE(GetLargestDifference(first, pixels), 3) << scale;
  }
  this->Rays->SetIntensity(0.0);
  EXPECT_GT(GetLargestDifference(first, GetPixels(this->Scene.Window)), 60);
}

// As long as there is nothing to see, the sun is put again.
TEST_F(GodRaysSunPlacer, WaitsForAScene)
{
  this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
  const auto empty = this->GetSun();
  ASSERT_EQ(empty.size(), 3u);
  this->AddBoxes();
  EXPECT_NE(this->GetSun(), empty);
}

// Light is warm, but before a blue ground, over which it would be grey; a colour that is set stays.
TEST_F(GodRaysSunPlacer, ChoosesItsColourByTheGround)
{
  this->AddBoxes();
  const auto isWarm = [this](double red, double green, double blue)
  {
    this->Renderer->SetBackground(red, green, blue);
    this->GetCoverage();
    const double* color = this->Rays->GetLight(0)->GetDiffuseColor();
    return color[0] > color[2];
  };
  EXPECT_TRUE(isWarm(0.0, 0.0, 0.0));
  EXPECT_FALSE(isWarm(0.16, 0.2, 0.32));
  EXPECT_TRUE(isWarm(0.3, 0.3, 0.3));
  EXPECT_TRUE(isWarm(0.01, 0.01, 0.04)) << "too dark to be seen as blue";
  this->Rays->GetLight(0)->SetDiffuseColor(0.0, 1.0, 0.5);
  EXPECT_FALSE(isWarm(0.0, 0.0, 0.0));
  EXPECT_EQ(this->Rays->GetLight(0)->GetDiffuseColor()[1], 1.0);
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
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-2.0, 0.0, 0.0);
  line->SetPoint2(2.0, 0.5, 0.0);
  vtkNew<vtkPolyDataMapper> ofLine;
  ofLine->SetInputConnection(line->GetOutputPort());
  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputConnection(sphere->GetOutputPort());
  splats->SetScaleFactor(0.3);
  splats->EmissiveOff(); // those that add light hide none
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
  const std::vector<std::pair<const char*, std::function<vtkProp*()>>> props = {
    { "data set", [&] { return makeActor(ofData); } },
    { "line", [&] { return makeActor(ofLine); } }, { "splats", [&] { return makeActor(splats); } },
    { "glyphs", [&] { return makeActor(glyphs); } },
    { "blocks", [&] { return makeActor(ofBlocks); } }, { "volume", [&] { return volume.Get(); } },
    { "slice", [&] { return slice.Get(); } }, { "assembly", [&] { return assembly.Get(); } }
  };
  for (const auto& [name, make] : props)
  {
    vtkProp* prop = make();
    this->Renderer->AddViewProp(prop);
    EXPECT_GT(this->GetCoverage(), 0.0) << name;
    vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::IGNORED);
    EXPECT_EQ(this->GetCoverage(), 0.0) << name;
    vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::AUTOMATIC);
    prop->VisibilityOff();
    EXPECT_EQ(this->GetCoverage(), 0.0) << name;
    prop->VisibilityOn();
    this->Renderer->RemoveAllViewProps();
  }
}
