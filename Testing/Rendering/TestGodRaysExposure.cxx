// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How strong rays are by themselves, and how they join the picture: data keep their colours.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSunPlacer.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>

using namespace GodRaysTesting;
using vtkGodRays::Vec3;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

/// Coloured boxes in the light of the eye, a bright sun behind them.
struct ColorStage : Stage
{
  ColorStage()
    : Stage(Width, Height)
  {
    const std::array<double, 3> colors[] = { { 0.54, 0.18, 0.12 }, { 0.18, 0.42, 0.18 },
      { 0.12, 0.24, 0.54 }, { 0.54, 0.48, 0.18 }, { 0.36, 0.36, 0.36 } };
    for (int i = 0; i < 5; ++i)
    {
      this->Renderer->AddActor(MakeBox({ 1.4 * (i - 2), 0.0, 0.0 }, { 0.9, 4.0, 0.5 }, colors[i]));
    }
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Sun = MakeSun({ 0.05, 0.1, -1.0 }, { 1.0, 0.9, 0.7 });
    this->Rays->AddLight(this->Sun);
    this->Rays->SetAutomaticExposure(true);
    this->Rays->SetHighlightShoulder(true);
    this->Rays->SetDarkenLightBackground(true);
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
    this->Without = GetPixels(this->Window);
    this->Rays->Attach(this->Renderer);
  }

  static Vec3 Get(const std::vector<unsigned char>& picture, int pixel)
  {
    return vtkGodRays::DecodeDisplay(
      Vec3(picture[4 * pixel], picture[4 * pixel + 1], picture[4 * pixel + 2]) / 255.0);
  }

  bool IsData(int pixel) const { return this->Without[4 * pixel + 3] > 0; }

  struct Change
  {
    double Difference = 0.0; // mean over data that are lit, in CIE 1976 L*a*b*
    double Chroma = 0.0;     // part of theirs that is left
    double Clipped = 0.0;    // part of all data
    double Lightness = 0.0;  // largest
    double Color = 0.0;      // largest in a* and b*
  };

  Change Compare(const std::vector<unsigned char>& with) const
  {
    Change change;
    double chroma[2] = { 0.0, 0.0 };
    double lit = 0.0;
    int count = 0;
    for (int i = 0; i < Width * Height; ++i)
    {
      if (!this->IsData(i))
      {
        continue;
      }
      const double weight = vtkGodRays::SeenPart(Get(this->Without, i));
      lit += weight;
      ++count;
      const Vec3 before = vtkGodRays::LabOfLight(Get(this->Without, i));
      const Vec3 after = vtkGodRays::LabOfLight(Get(with, i));
      change.Difference += weight * glm::length(after - before);
      chroma[0] += weight * std::hypot(before.y, before.z);
      chroma[1] += weight * std::hypot(after.y, after.z);
      change.Lightness = std::max(change.Lightness, std::abs(after.x - before.x));
      change.Color = std::max(change.Color, std::hypot(after.y - before.y, after.z - before.z));
      const bool clipped = std::max({ with[4 * i], with[4 * i + 1], with[4 * i + 2] }) == 255;
      change.Clipped += clipped ? 1.0 : 0.0;
    }
    change.Difference /= lit;
    change.Clipped /= count;
    change.Chroma = chroma[1] / chroma[0];
    return change;
  }

  void SetStrength(double exposure)
  {
    vtkGodRaysRadialModel::SafeDownCast(this->Rays->GetModel())->SetExposure(exposure);
  }

  vtkSmartPointer<vtkLight> Sun;
  std::vector<unsigned char> Without;
};
}

//------------------------------------------------------------------------------
TEST(Exposure, DataKeepTheirColours)
{
  Messages messages;
  ColorStage stage;
  for (const double strength : { 1.0, 4.0, 40.0 })
  {
    stage.SetStrength(strength);
    const auto change = stage.Compare(GetPixels(stage.Window));
    EXPECT_LE(change.Difference, 9.0) << strength;
    EXPECT_GE(change.Chroma, 0.9) << strength;
    EXPECT_LE(change.Clipped, 0.005) << strength;
    EXPECT_GT(change.Difference, 2.0) << strength; // rays are seen
  }
  EXPECT_TRUE(Says(stage.Rays->GetPlan(), "by the picture"));
  EXPECT_LE(stage.Rays->GetDataExposure(), 1.0);

  // not by themselves
  stage.Rays->SetAutomaticExposure(false);
  stage.Rays->SetHighlightShoulder(false);
  const auto change = stage.Compare(GetPixels(stage.Window));
  EXPECT_GT(change.Difference, 30.0);
  EXPECT_LT(change.Chroma, 0.7);
  EXPECT_GT(change.Clipped, 0.5);
  EXPECT_EQ(stage.Rays->GetExposure(), 1.0);
  EXPECT_FALSE(Says(stage.Rays->GetPlan(), "by the picture"));
}

//------------------------------------------------------------------------------
// Warm rays give grey data no colour that is more than just visible.
TEST(Exposure, GreyDataStayGrey)
{
  Messages messages;
  ColorStage stage;
  stage.Rays->SetIntensity(0.0);
  vtkCollectionSimpleIterator iterator;
  vtkActorCollection* actors = stage.Renderer->GetActors();
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    actor->GetProperty()->SetColor(0.3, 0.3, 0.3);
  }
  stage.Sun->SetDiffuseColor(1.0, 0.6, 0.3);
  stage.Without = GetPixels(stage.Window);
  stage.Rays->SetIntensity(1.0);
  const auto getChroma = [&]()
  {
    const auto with = GetPixels(stage.Window);
    double chroma = 0.0;
    double lit = 0.0;
    for (int i = 0; i < Width * Height; ++i)
    {
      const double weight =
        stage.IsData(i) ? vtkGodRays::SeenPart(ColorStage::Get(stage.Without, i)) : 0.0;
      const Vec3 lab = vtkGodRays::LabOfLight(ColorStage::Get(with, i));
      chroma += weight * std::hypot(lab.y, lab.z);
      lit += weight;
    }
    return chroma / lit;
  };
  const double chroma = getChroma();
  EXPECT_LT(chroma, 2.5);
  EXPECT_GT(chroma, 1.0); // rays are seen
  stage.Rays->SetAutomaticExposure(false);
  EXPECT_GT(getChroma(), 10.0); // not by themselves
}

//------------------------------------------------------------------------------
// Dark data stay dark among lit ones: rays are before what is beside them. Shafts go across a silhouette.
TEST(Exposure, DarkDataAmongLitOnesStayDark)
{
  Messages messages;
  ColorStage stage;
  stage.Rays->SetIntensity(0.0);
  vtkCollectionSimpleIterator iterator;
  vtkActorCollection* actors = stage.Renderer->GetActors();
  actors->InitTraversal(iterator);
  for (int i = 0; vtkActor* actor = actors->GetNextActor(iterator); ++i)
  {
    if (i < 2)
    {
      actor->GetProperty()->SetColor(0.05, 0.03, 0.04);
    }
  }
  stage.Without = GetPixels(stage.Window);
  stage.Rays->SetIntensity(1.0);
  const auto getDifference = [&](bool ofData)
  {
    const auto with = GetPixels(stage.Window);
    double difference = 0.0;
    int count = 0;
    for (int i = 0; i < Width * Height; ++i)
    {
      if (stage.IsData(i) == ofData)
      {
        difference += glm::length(vtkGodRays::LabOfLight(ColorStage::Get(with, i)) -
          vtkGodRays::LabOfLight(ColorStage::Get(stage.Without, i)));
        ++count;
      }
    }
    return difference / count;
  };
  EXPECT_LT(getDifference(true), 10.0);
  EXPECT_GT(getDifference(true), 2.0);   // rays are seen
  EXPECT_GT(getDifference(false), 25.0); // not weaker beside data
  EXPECT_LT(stage.Rays->GetDarkDataExposure(), 1.0);
  EXPECT_TRUE(Says(stage.Rays->GetPlan(), "over dark ones"));
  stage.Rays->SetAutomaticExposure(false);
  EXPECT_GT(getDifference(true), 15.0); // not by themselves

  stage.Rays->SetAutomaticExposure(true);
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    actor->GetProperty()->SetColor(0.05, 0.03, 0.04);
  }
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetDarkDataExposure(), 1.0);
}

//------------------------------------------------------------------------------
// What a medium takes of data is made up for, but for what it takes of the farther ones, and up to a stop.
TEST(Exposure, DataKeepTheirLightInAMedium)
{
  Messages messages;
  ColorStage stage;
  vtkNew<vtkGodRaysHomogeneousModel> medium;
  stage.Rays->SetModel(medium);
  medium->ApplyPreset("haze");
  const auto change = stage.Compare(GetPixels(stage.Window));
  EXPECT_LT(change.Difference, 10.0);
  EXPECT_GT(change.Chroma, 0.9);
  EXPECT_GT(stage.Rays->GetDataGain(), 1.1);
  EXPECT_LT(stage.Rays->GetDataGain(), 2.0);
  EXPECT_TRUE(Says(stage.Rays->GetPlan(), "times as bright as the medium leaves them"));
  stage.Rays->SetAutomaticExposure(false);
  EXPECT_LT(stage.Compare(GetPixels(stage.Window)).Chroma, 0.85); // not by itself
  EXPECT_EQ(stage.Rays->GetDataGain(), 1.0);
  stage.Rays->SetAutomaticExposure(true);

  medium->SetAttenuateScene(false);
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetDataGain(), 1.0); // nothing is taken

  // fog hides as before
  medium->SetAttenuateScene(true);
  medium->SetOpticalDepth(8.0);
  const auto hidden = stage.Compare(GetPixels(stage.Window));
  EXPECT_EQ(stage.Rays->GetDataGain(), 2.0);
  EXPECT_LT(hidden.Chroma, 0.2);
  EXPECT_EQ(messages.Take().size(), 1u); // that it does
}

//------------------------------------------------------------------------------
TEST(Exposure, PictureIsTheFormula)
{
  Messages messages;
  ColorStage stage;
  stage.SetStrength(6.0);
  stage.Rays->SetIntensity(1.5);
  const auto with = GetPixels(stage.Window);
  vtkNew<vtkImageData> light;
  ASSERT_TRUE(stage.Rays->GetScatteringImage(light));
  const double exposure = stage.Rays->GetExposure();
  const double overData = stage.Rays->GetDataExposure();
  const double overDark = stage.Rays->GetDarkDataExposure();
  int largest = 0;
  int plain = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const Vec3 scene = ColorStage::Get(stage.Without, i);
    const Vec3 rays = exposure *
      Vec3(GetValue(light, i % Width, i / Width, 0), GetValue(light, i % Width, i / Width, 1),
        GetValue(light, i % Width, i / Width, 2));
    const Vec3 over =
      glm::mix(overDark, overData, vtkGodRays::SeenPart(scene)) * vtkGodRays::CapLight(rays);
    const Vec3 sum =
      vtkGodRays::EncodeDisplay(vtkGodRays::BlendShoulder(scene, stage.IsData(i) ? over : rays));
    const Vec3 added = vtkGodRays::EncodeDisplay(scene + rays);
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(
        largest, std::abs(static_cast<int>(std::lround(255.0 * sum[c])) - with[4 * i + c]));
      plain = std::max(plain,
        std::abs(static_cast<int>(std::lround(255.0 * std::min(added[c], 1.0))) - with[4 * i + c]));
    }
  }
  EXPECT_LE(largest, 1);
  EXPECT_GT(plain, 20); // a plain sum is something else
}

//------------------------------------------------------------------------------
TEST(Exposure, WeakOnesAreStrengthenedByTwoStops)
{
  Messages messages;
  ColorStage stage;
  stage.SetStrength(0.01);
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetExposure(), 4.0);
  EXPECT_EQ(stage.Rays->GetDataExposure(), 1.0);

  vtkNew<vtkGodRaysHomogeneousModel> medium;
  medium->SetScatteringCoefficient(1e-5, 1e-5, 1e-5);
  stage.Rays->SetModel(medium);
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetExposure(), 4.0);
  EXPECT_EQ(messages.Take().size(), 1u); // it hardly shows
  medium->SetScatteringCoefficient(0.05, 0.05, 0.05);
  medium->SetAsymmetry(0.9);
  stage.Window->Render();
  EXPECT_LT(stage.Rays->GetExposure() * stage.Rays->GetDataExposure(), 0.2);
  EXPECT_LT(stage.Rays->GetDataExposure(), 1.0);
  EXPECT_GE(stage.Rays->GetDataExposure(), 0.5); // a stop, and the rest everywhere

  vtkNew<vtkGodRaysPublishedModel> published;
  stage.Rays->SetModel(published);
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetExposure(), 1.0);
}

//------------------------------------------------------------------------------
TEST(Exposure, ChangesGraduallyWhileTheCameraIsDragged)
{
  Messages messages;
  ColorStage stage;
  stage.SetStrength(0.2);
  stage.Window->Render();
  const double weak = stage.Rays->GetExposure();
  stage.SetStrength(8.0);
  stage.Window->Render();
  const double strong = stage.Rays->GetExposure();
  ASSERT_LT(strong, 0.85 * weak);

  stage.Window->SetDesiredUpdateRate(15.0);
  stage.SetStrength(0.2);
  stage.Window->Render();
  EXPECT_NEAR(stage.Rays->GetExposure(), strong + 0.25 * (weak - strong), 0.02 * weak);
  for (int i = 0; i < 30; ++i)
  {
    stage.Window->Render();
  }
  EXPECT_NEAR(stage.Rays->GetExposure(), weak, 0.02 * weak);

  // a still picture does not depend on what was before
  stage.SetStrength(8.0);
  stage.Window->Render();
  stage.Window->SetDesiredUpdateRate(0.001);
  stage.Window->Render();
  EXPECT_EQ(stage.Rays->GetExposure(), strong);
}

//------------------------------------------------------------------------------
TEST(Exposure, TilesAreThoseOfOnePicture)
{
  Messages messages;
  ColorStage stage;
  stage.SetStrength(6.0);
  stage.Window->Render();
  const double whole = stage.Rays->GetDataExposure();
  vtkNew<vtkWindowToImageFilter> tiles;
  tiles->SetInput(stage.Window);
  tiles->SetScale(2);
  tiles->ReadFrontBufferOff();
  tiles->Update();
  EXPECT_EQ(stage.Rays->GetDataExposure(), whole);
}

//------------------------------------------------------------------------------
// Light can add nothing to white: there, shadows are what is seen.
TEST(LightBackground, IsDarkerInShadows)
{
  Messages messages;
  ColorStage stage;
  stage.Renderer->SetBackground(1.0, 1.0, 1.0);
  auto* model = vtkGodRaysRadialModel::SafeDownCast(stage.Rays->GetModel());
  ASSERT_NE(model, nullptr);
  model->SetStreaks(0.0);
  model->SetReach(0.75);
  const auto with = GetPixels(stage.Window);
  vtkNew<vtkImageData> light;
  ASSERT_TRUE(stage.Rays->GetScatteringImage(light));
  double place[2];
  ASSERT_TRUE(vtkGodRaysSunPlacer::FindPlace(stage.Renderer, stage.Rays->GetLight(0), place));
  const auto getDistance = [&](int i) // from the light [heights of the picture]
  {
    return std::hypot((i % Width + 0.5) / Height - place[0] * Width / Height,
      (i / Width + 0.5) / Height - place[1]);
  };
  std::vector<double> luminance(Width * Height, 0.0);
  std::map<int, std::vector<double>> rings; // by distance, 12 in the height; -1: all
  int darker = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    luminance[i] = vtkGodRays::Luminance(Vec3(GetValue(light, i % Width, i / Width, 0),
      GetValue(light, i % Width, i / Width, 1), GetValue(light, i % Width, i / Width, 2)));
    if (!stage.IsData(i))
    {
      rings[static_cast<int>(12.0 * getDistance(i))].push_back(luminance[i]);
      rings[-1].push_back(luminance[i]);
      darker += with[4 * i] < 245 ? 1 : 0;
    }
  }
  const auto getTerm = [](double distance) { return std::log(distance + 0.05); };
  // Fits a parabola to the logarithms of the rings' 95th percentiles, by least squares over all pixels.
  double squares[3][3] = {};
  double sums[3] = {};
  double fit[3];
  double percentile = 0.0;
  for (auto& [ring, values] : rings)
  {
    std::sort(values.begin(), values.end());
    const double lit = values[values.size() * 95 / 100];
    percentile = ring < 0 ? lit : percentile;
    for (int j = 0; j < 9 && ring >= 0; ++j)
    {
      const double u = getTerm((ring + 0.5) / 12.0);
      const double weight = static_cast<double>(values.size()) * std::pow(u, j / 3);
      squares[j / 3][j % 3] += weight * std::pow(u, j % 3);
      sums[j / 3] += j % 3 == 0 ? weight * std::log(lit) : 0.0;
    }
  }
  vtkMath::LinearSolve3x3(squares, sums, fit);
  // Lit places stay white, and full shadow becomes a cool grey, sRGB's (178, 189, 208), near the light, and
  // fades with distance.
  // Compares the part that a place lacks of its light, before the formula's exponent, which magnifies noise
  // where that is next to nothing.
  const auto getWorst = [&](const std::function<double(double)>& getLit)
  {
    const double parts[3] = { 0.555, 0.491, 0.369 };
    double worst = 0.0;
    for (int i = 0; i < Width * Height; ++i)
    {
      const double distance = getDistance(i);
      const double lacks = 1.0 - std::min(luminance[i] / getLit(distance), 1.0);
      const double fade = std::exp(-distance / (6.0 * model->GetReach()));
      for (int c = 0; c < 3 && !stage.IsData(i); ++c)
      {
        const double dark = 1.0 - vtkGodRays::DecodeDisplay(with[4 * i + c] / 255.0);
        const double shown = std::pow(std::min(dark / (parts[c] * fade), 1.0), 4.0 / 3.0);
        worst = std::max(worst,
          255.0 *
            std::abs(vtkGodRays::EncodeDisplay(1.0 - parts[c] * lacks) -
              vtkGodRays::EncodeDisplay(1.0 - parts[c] * shown)));
      }
    }
    return worst;
  };
  const double worst = getWorst(
    [&](double distance)
    {
      const double u = getTerm(distance);
      return std::exp(fit[0] + u * (fit[1] + u * fit[2]));
    });
  const double worstOfAll = getWorst([&](double) { return percentile; });
  std::cout << worst << " levels at most from what rings say, " << worstOfAll
            << " from what the percentile of all pixels says\n";
  EXPECT_LE(worst, 2.0); // the pass fits to some of the pixels
  EXPECT_GT(worstOfAll, 30.0) << "a control";
  EXPECT_GT(darker, Width * Height / 20);
  EXPECT_TRUE(Says(stage.Rays->GetPlan(), "darken the background"));
  EXPECT_LE(stage.Compare(with).Difference, 1.0); // no veil over data

  stage.Rays->SetDarkenLightBackground(false);
  const auto off = GetPixels(stage.Window);
  stage.Renderer->SetBackground(0.4, 0.4, 0.4);
  stage.Rays->SetDarkenLightBackground(true);
  stage.Window->Render();
  EXPECT_FALSE(Says(stage.Rays->GetPlan(), "darken the background"));
  for (int i = 0; i < Width * Height; ++i)
  {
    if (!stage.IsData(i))
    {
      EXPECT_EQ(off[4 * i], 255);
    }
  }
}

//------------------------------------------------------------------------------
// From black to white there is no grey before which shafts are not seen.
TEST(LightBackground, ShaftsAreSeenBeforeEachGrey)
{
  Messages messages;
  ColorStage stage;
  const auto getSpread = [&](double grey)
  {
    stage.Renderer->SetBackground(grey, grey, grey);
    const auto with = GetPixels(stage.Window);
    std::vector<double> lightness;
    for (int i = 0; i < Width * Height; ++i)
    {
      if (!stage.IsData(i))
      {
        lightness.push_back(vtkGodRays::LabOfLight(ColorStage::Get(with, i)).x);
      }
    }
    std::sort(lightness.begin(), lightness.end());
    return lightness[lightness.size() * 9 / 10] - lightness[lightness.size() / 10];
  };
  double least = 100.0;
  double worst = 0.0;
  for (int i = 0; i <= 50; ++i)
  {
    const double grey = i / 50.0;
    const double spread = getSpread(grey);
    worst = spread < least ? grey : worst;
    least = std::min(least, spread);
  }
  std::cout << "between shadows and shafts: " << least << " L* before the worst grey, " << worst
            << "\n";
  EXPECT_GT(least, 10.0);

  stage.Rays->SetDarkenLightBackground(false);
  EXPECT_LT(getSpread(0.8), 10.0); // not by themselves
  EXPECT_EQ(getSpread(1.0), 0.0);
  messages.Take(); // that nothing can be seen before white
}

// What a medium takes of white is made up for; its shadows are seen all the same.
TEST(LightBackground, IsSeenThroughAMedium)
{
  Messages messages;
  ColorStage stage;
  stage.Renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkGodRaysHomogeneousModel> medium;
  medium->ApplyPreset("haze");
  stage.Rays->SetModel(medium);
  const auto with = GetPixels(stage.Window);
  int lightest = 0;
  int darkest = 255;
  for (int i = 0; i < Width * Height; ++i)
  {
    if (!stage.IsData(i))
    {
      lightest = std::max<int>(lightest, with[4 * i]);
      darkest = std::min<int>(darkest, with[4 * i]);
    }
  }
  EXPECT_GT(lightest, darkest + 10);
  EXPECT_EQ(lightest, 255);
  EXPECT_TRUE(Says(stage.Rays->GetPlan(), "darken the background"));
}

//------------------------------------------------------------------------------
// Each light fades and has streaks about its own place; together they are the sum of both.
TEST(Response, LightsAddUp)
{
  Messages messages;
  ColorStage stage;
  auto* look = vtkGodRaysRadialModel::SafeDownCast(stage.Rays->GetModel());
  look->SetReach(0.75);
  look->SetStreaks(0.22);
  const auto sun = MakeSun({ -0.2, 0.15, -1.0 }, { 0.3, 0.6, 1.0 });
  const auto get = [&](bool first, bool second)
  {
    stage.Rays->RemoveAllLights();
    for (const auto& [has, light] : { std::make_pair(first, stage.Sun), { second, sun } })
    {
      if (has)
      {
        stage.Rays->AddLight(light);
      }
    }
    stage.Renderer->GetActiveCamera()->Azimuth(1e-9); // its coverage is found again
    return GetPixels(stage.Window); // an image that is read back has all lights added before
  };
  stage.Rays->SetAutomaticExposure(false);
  stage.Rays->SetOutput(vtkGodRaysPass::SCATTERING);
  const auto both = get(true, true);
  const auto one = get(true, false);
  const auto other = get(false, true);
  double worst = 0.0;
  double without = 0.0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const Vec3 sum = ColorStage::Get(one, i) + ColorStage::Get(other, i);
    for (int c = 0; c < 3; ++c)
    {
      const double expected = 255.0 * vtkGodRays::EncodeDisplay(std::min(sum[c], 1.0));
      worst = std::max(worst, std::abs(both[4 * i + c] - expected));
      without = std::max(without, std::abs(other[4 * i + c] - expected));
    }
  }
  EXPECT_LT(worst, 6.0);    // what is dark is rounded thrice
  EXPECT_GT(without, 50.0); // a control: the second light alone is something else
}

//------------------------------------------------------------------------------
TEST(DataFirst, KeepsHueAndChroma)
{
  Messages messages;
  ColorStage stage;
  stage.Rays->SetAutomaticExposure(false);
  stage.SetStrength(2.0);
  stage.Rays->SetMostDataLightness(6.0);
  const auto plain = stage.Compare(GetPixels(stage.Window));
  EXPECT_GT(plain.Color, 20.0);
  EXPECT_GT(plain.Lightness, 20.0);

  stage.Rays->SetDataFirst(true);
  const auto with = GetPixels(stage.Window);
  const auto change = stage.Compare(with);
  EXPECT_LT(change.Color, 3.0); // what rounding to 8 bits does
  EXPECT_EQ(change.Clipped, 0.0);
  EXPECT_LT(change.Lightness, 7.0);
  EXPECT_GT(change.Lightness, 4.0);
  int lighter = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    lighter += !stage.IsData(i) && with[4 * i] > stage.Without[4 * i] + 20 ? 1 : 0;
  }
  EXPECT_GT(lighter, Width * Height / 10); // rays are seen beside the data

  // also of what a medium does
  vtkNew<vtkGodRaysHomogeneousModel> medium;
  medium->SetScatteringCoefficient(0.06, 0.06, 0.06);
  stage.Rays->SetModel(medium);
  const auto dimmed = stage.Compare(GetPixels(stage.Window));
  EXPECT_LT(dimmed.Color, 3.0);
  EXPECT_LT(dimmed.Lightness, 7.0);
  stage.Rays->SetDataFirst(false);
  EXPECT_GT(stage.Compare(GetPixels(stage.Window)).Color, 10.0);
}
