// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The scene under the rays: whatever the renderer draws it with, it is drawn as without the pass,
// depth and alpha stay, and rays are added to it in linear light.

#include "GodRaysTesting.h"

#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"

#include "vtkActorCollection.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

using namespace GodRaysTesting;

namespace
{
const int Width = 128;
const int Height = 96;

// IEC 61966-2-1, written once more: the tests share no formula with the pass.
double Decode(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}
double Encode(double light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

/// Pillars and a lamp half behind one of them, whose rays end before the edges of the picture.
void AddPillarsAndLamp(Stage& scene)
{
  scene.AddPillarsAndSun();
  scene.Rays->Detach(scene.Renderer);
  scene.Rays->RemoveAllLights();
  scene.Rays->SetBackgroundGlow(0.0);
  scene.Rays->SetSourceRadius(0.6);
  scene.Rays->AddLight(MakeLamplight({ 2.0, 1.2, -3.0 }, { 1.0, 0.8, 0.5 }));
  vtkGodRaysRadialModel::SafeDownCast(scene.Rays->GetModel())->SetDensity(0.8);
}

void AddGlass(Stage& scene)
{
  auto glass = MakeBox({ 1.5, 0.5, 1.5 }, { 3.0, 2.0, 0.2 }, { 0.2, 0.7, 0.9 });
  glass->GetProperty()->SetOpacity(0.4);
  glass->RotateZ(20.0);
  scene.Renderer->AddActor(glass);
}

/// A cloud in a cube of 2 about this centre.
vtkSmartPointer<vtkVolume> MakeCloud(double x, double y, double z)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(17, 17, 17);
  image->SetSpacing(0.125, 0.125, 0.125);
  image->SetOrigin(x - 1.0, y - 1.0, z - 1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int k = 0; k < 17; ++k)
  {
    for (int j = 0; j < 17; ++j)
    {
      for (int i = 0; i < 17; ++i)
      {
        const double radius = std::hypot(i - 8.0, j - 8.0, k - 8.0);
        *static_cast<unsigned char*>(image->GetScalarPointer(i, j, k)) =
          static_cast<unsigned char>(std::max(0.0, 255.0 - 30.0 * radius));
      }
    }
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.1);
  mapper->UseJitteringOff();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.2);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.5, 0.3);
  color->AddRGBPoint(255.0, 0.9, 0.9, 0.9);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  return volume;
}

vtkSmartPointer<vtkTexture> MakeTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16 * 8 * 3; ++i)
  {
    pixels[i] = static_cast<unsigned char>(40 + (i * 7) % 120);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

vtkSmartPointer<vtkSkybox> MakeSkybox()
{
  auto sky = vtkSmartPointer<vtkSkybox>::New();
  sky->SetTexture(MakeTexture());
  sky->SetProjectionToSphere();
  return sky;
}

/// One way to draw the scene.
struct Situation
{
  const char* Name;
  std::function<void(Stage&)> Arrange;
};

const Situation Situations[] = {
  { "Plain", [](Stage&) {} },
  { "OrderIndependentTranslucency", [](Stage& scene) { AddGlass(scene); } },
  { "DepthPeeling",
    [](Stage& scene)
    {
      AddGlass(scene);
      scene.Renderer->UseDepthPeelingOn();
    } },
  { "DepthPeelingOfVolumes",
    [](Stage& scene)
    {
      AddGlass(scene);
      scene.Renderer->AddVolume(MakeCloud(1.0, 1.5, 1.5));
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->UseDepthPeelingForVolumesOn();
    } },
  { "SSAO",
    [](Stage& scene)
    {
      scene.Renderer->UseSSAOOn();
      scene.Renderer->SetSSAORadius(0.5);
      scene.Renderer->SetSSAOKernelSize(16);
    } },
  { "FXAA", [](Stage& scene) { scene.Renderer->UseFXAAOn(); } },
  { "Shadows", [](Stage& scene) { scene.Renderer->UseShadowsOn(); } },
  { "HiddenLineRemoval",
    [](Stage& scene)
    {
      vtkActor* pillar = scene.Renderer->GetActors()->GetLastActor();
      pillar->GetProperty()->SetRepresentationToWireframe();
      scene.Renderer->UseHiddenLineRemovalOn();
    } },
  { "Volume", [](Stage& scene) { scene.Renderer->AddVolume(MakeCloud(1.0, 1.5, 1.5)); } },
  { "GradientBackground",
    [](Stage& scene)
    {
      scene.Renderer->GradientBackgroundOn();
      scene.Renderer->SetBackground2(0.8, 0.3, 0.1);
    } },
  { "TexturedBackground",
    [](Stage& scene)
    {
      scene.Renderer->TexturedBackgroundOn();
      scene.Renderer->SetBackgroundTexture(MakeTexture());
    } },
  { "Skybox", [](Stage& scene) { scene.Renderer->AddActor(MakeSkybox()); } },
  { "Stencil", [](Stage& scene) { scene.Window->StencilCapableOn(); } },
  { "StencilAndTranslucency",
    [](Stage& scene)
    {
      scene.Window->StencilCapableOn();
      AddGlass(scene);
    } },
  { "LinesAndPoints",
    [](Stage& scene)
    {
      auto lines = MakeLamp({ 0.5, 1.0, 2.0 }, 1.0, { 0.9, 0.2, 0.2 });
      lines->GetProperty()->SetRepresentationToWireframe();
      scene.Renderer->AddActor(lines);
      auto points = MakeLamp({ 2.5, 0.0, 2.0 }, 0.8, { 0.2, 0.9, 0.2 });
      points->GetProperty()->SetRepresentationToPoints();
      points->GetProperty()->SetPointSize(3.0f);
      scene.Renderer->AddActor(points);
    } },
};

/// For test names.
void PrintTo(const Situation& situation, std::ostream* os)
{
  *os << situation.Name;
}

/// How far a picture is, at most, from the sum of that without rays and of the rays [levels].
double FindWorstSum(const std::vector<unsigned char>& without,
  const std::vector<unsigned char>& with, vtkImageData* rays, double intensity)
{
  double worst = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const std::size_t i = 4 * (static_cast<std::size_t>(y) * Width + x);
      for (int c = 0; c < 3; ++c)
      {
        const double light = Decode(without[i + c] / 255.0) + intensity * GetValue(rays, x, y, c);
        const double expected = 255.0 * std::min(1.0, Encode(light));
        worst = std::max(worst, std::abs(expected - with[i + c]));
      }
    }
  }
  return worst;
}

class GodRaysSceneIsAsWithoutPass : public ::testing::TestWithParam<std::tuple<Situation, int>>
{
};
}

TEST_P(GodRaysSceneIsAsWithoutPass, ButForTheRays)
{
  Messages messages;
  Stage bare(Width, Height);
  Stage lit(Width, Height);
  for (Stage* scene : { &bare, &lit })
  {
    AddPillarsAndLamp(*scene);
    scene->Window->SetMultiSamples(std::get<1>(GetParam()));
    std::get<0>(GetParam()).Arrange(*scene);
  }
  lit.Rays->Attach(lit.Renderer);

  const auto without = GetPixels(bare.Window);
  const auto depthsWithout = GetDepths(bare.Window, false);
  // VTK's debug build finds OpenGL errors of its own in some of these frames
  const std::size_t saidWithout = messages.Take().size();
  const auto with = GetPixels(lit.Window);
  const auto depths = GetDepths(lit.Window, false);
  EXPECT_EQ(messages.Take().size(), saidWithout);
  EXPECT_EQ(depths, depthsWithout);
  EXPECT_LT(*std::min_element(depths.begin(), depths.end()), 1.0f);

  vtkNew<vtkImageData> rays;
  ASSERT_TRUE(lit.Rays->GetScatteringImage(rays)) << lit.Rays->GetPlan();
  int touched = 0;
  int changed = 0;
  int wrong = 0;
  int alphas = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const std::size_t i = 4 * (static_cast<std::size_t>(y) * Width + x);
      alphas += with[i + 3] != without[i + 3];
      const bool reached = GetValue(rays, x, y, 0) > 0.0;
      touched += reached;
      for (int c = 0; c < 3; ++c)
      {
        if (!reached)
        {
          wrong += with[i + c] != without[i + c];
          continue;
        }
        changed += with[i + c] != without[i + c];
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "channels changed where no ray reaches";
  EXPECT_EQ(alphas, 0) << "alphas changed";
  EXPECT_LE(FindWorstSum(without, with, rays, 1.0), 1.0) << "levels off the sum in linear light";
  EXPECT_GT(touched, 400);
  EXPECT_GT(changed, 400);
  EXPECT_GT(Width * Height - touched, 4000);
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysSceneIsAsWithoutPass,
  ::testing::Combine(::testing::ValuesIn(Situations), ::testing::Values(0, 8)),
  [](const auto& info)
  {
    return std::string(std::get<0>(info.param).Name) + "MultiSamples" +
      std::to_string(std::get<1>(info.param));
  });

namespace
{
/// Pixels whose red is well between those of their neighbours to the left and right, which differ
/// much: pixels of a smoothed edge.
int CountSmoothedEdges(const std::vector<unsigned char>& pixels)
{
  int count = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 1; x + 1 < Width; ++x)
    {
      const unsigned char* pixel = &pixels[4 * (static_cast<std::size_t>(y) * Width + x)];
      const int low = std::min(pixel[-4], pixel[4]);
      const int high = std::max(pixel[-4], pixel[4]);
      count += high - low > 40 && pixel[0] > low + 12 && pixel[0] < high - 12;
    }
  }
  return count;
}
}

TEST(GodRaysSceneEdges, StayAntiAliasedUnderRays)
{
  Messages messages;
  int smoothed[2][2]; // [multisampled][with rays]
  double worst = 0.0; // levels off the sum in linear light
  std::vector<unsigned char> pixels[2];
  for (const int multisampled : { 0, 1 })
  {
    for (const int withRays : { 0, 1 })
    {
      Stage scene;
      auto board = MakeBox({ 0.0, 0.0, 0.0 }, { 3.0, 3.0, 0.1 }, { 0.8, 0.8, 0.8 });
      board->RotateZ(17.0);
      board->GetProperty()->LightingOff();
      scene.Renderer->AddActor(board);
      scene.Window->SetMultiSamples(8 * multisampled);
      scene.Rays->AddLight(MakeSun({ 0.25, 0.2, -1.0 }));
      scene.Rays->SetIntensity(0.5);
      if (withRays)
      {
        scene.Rays->Attach(scene.Renderer);
      }
      pixels[withRays] = GetPixels(scene.Window);
      smoothed[multisampled][withRays] = CountSmoothedEdges(pixels[withRays]);
      if (withRays)
      {
        vtkNew<vtkImageData> rays;
        ASSERT_TRUE(scene.Rays->GetScatteringImage(rays));
        worst = std::max(worst, FindWorstSum(pixels[0], pixels[1], rays, 0.5));
      }
    }
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_EQ(smoothed[0][0], 0);
  EXPECT_LE(smoothed[0][1], 2);
  EXPECT_GT(smoothed[1][0], 50);
  EXPECT_GT(smoothed[1][1], 0.85 * smoothed[1][0]);
}

TEST(GodRaysSceneEdges, KeepTheirSamplesWhereNoRayReachesThem)
{
  // A later layer tells the samples of a pixel apart: its sheet hides those of the background only.
  Messages messages;
  Stage scene;
  scene.Window->SetMultiSamples(8);
  auto board = MakeBox({ -1.5, -0.5, 0.0 }, { 3.0, 3.0, 0.1 }, { 0.8, 0.8, 0.8 });
  board->RotateZ(17.0);
  scene.Renderer->AddActor(board);
  scene.Rays->AddLight(MakeLamplight({ 2.5, 1.5, -3.0 }));
  scene.Rays->SetSourceRadius(0.3);
  scene.Rays->SetBackgroundGlow(0.0);
  scene.Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  vtkGodRaysRadialModel::SafeDownCast(scene.Rays->GetModel())->SetDensity(0.5);
  vtkNew<vtkRenderer> later;
  auto sheet = MakeBox({ 0.0, 0.0, -5.0 }, { 30.0, 30.0, 0.1 }, { 0.2, 0.9, 0.4 });
  sheet->GetProperty()->LightingOff();
  later->AddActor(sheet);
  later->SetLayer(1);
  later->PreserveDepthBufferOn();
  later->SetActiveCamera(scene.Renderer->GetActiveCamera());
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(later);
  const auto without = GetPixels(scene.Window);
  scene.Rays->Attach(scene.Renderer);
  const auto with = GetPixels(scene.Window);
  vtkNew<vtkImageData> rays;
  ASSERT_TRUE(scene.Rays->GetScatteringImage(rays));
  int lit = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const std::size_t i = 4 * (static_cast<std::size_t>(y) * Width + x);
      const bool reached = GetValue(rays, x, y) > 0.0;
      lit += reached;
      EXPECT_TRUE(reached || std::equal(&with[i], &with[i] + 4, &without[i])) << x << ", " << y;
    }
  }
  EXPECT_GT(lit, 20);
  EXPECT_LT(lit, Width * Height / 2);
  EXPECT_GT(CountSmoothedEdges(with), 50);
}

namespace
{
/// The picture with rays, held against a formula of the scene's value and the rays', both 0..1.
void ExpectBlend(Stage& scene, const std::vector<unsigned char>& without, double intensity,
  const std::function<double(double, double)>& blend, const char* name)
{
  const auto with = GetPixels(scene.Window);
  vtkNew<vtkImageData> rays;
  ASSERT_TRUE(scene.Rays->GetScatteringImage(rays)) << name;
  double worst = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * Width + x) + c;
        const double value = blend(without[i] / 255.0, intensity * GetValue(rays, x, y, c));
        worst = std::max(worst, std::abs(255.0 * std::min(std::max(value, 0.0), 1.0) - with[i]));
      }
    }
  }
  EXPECT_LE(worst, 1.0) << name;
  EXPECT_GT(CountDifferentPixels(with, without, 3), 500) << name;
}
}

TEST(GodRaysSceneBlend, IsTheFormula)
{
  Messages messages;
  Stage scene(Width, Height);
  AddPillarsAndLamp(scene);
  const auto without = GetPixels(scene.Window);
  scene.Rays->Attach(scene.Renderer);

  const auto add = [](double shown, double rays) { return Encode(Decode(shown) + rays); };
  const auto screen = [](double shown, double rays)
  {
    const double light = Decode(shown);
    return Encode(light + rays - std::min(light * rays, 1.0));
  };
  ExpectBlend(scene, without, 1.0, add, "ADD");
  scene.Rays->SetIntensity(0.4);
  ExpectBlend(scene, without, 0.4, add, "ADD, Intensity 0.4");
  scene.Rays->SetIntensity(30.0);
  ExpectBlend(scene, without, 30.0, add, "ADD, Intensity 30");
  scene.Rays->SetBlend(vtkGodRaysPass::SCREEN);
  ExpectBlend(scene, without, 30.0, screen, "SCREEN, Intensity 30");
  scene.Rays->SetIntensity(1.0);
  scene.Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  ExpectBlend(scene, without, 1.0, screen, "SCREEN, single precision");

  // published formulations, each by its own convention
  scene.Rays->SetBlend(vtkGodRaysPass::MODEL_BLEND);
  ASSERT_TRUE(scene.Rays->ApplyPreset("published:babylon"));
  ExpectBlend(
    scene, without, 1.0, [](double shown, double rays) { return 1.1 * shown + rays; }, "BABYLON");
  ASSERT_TRUE(scene.Rays->ApplyPreset("published:mitchell"));
  ExpectBlend(
    scene, without, 1.0, [](double shown, double rays) { return shown + rays; }, "MITCHELL");
  ASSERT_TRUE(scene.Rays->ApplyPreset("published:postprocessing"));
  ExpectBlend(scene, without, 1.0, screen, "POSTPROCESSING");
  auto model = vtkGodRaysPublishedModel::SafeDownCast(scene.Rays->GetModel());
  ASSERT_TRUE(model);
  EXPECT_EQ(model->GetBlend(), vtkGodRaysPublishedModel::SCREEN);
}

TEST(GodRaysSceneOutput, ShowsTheLayersAndLeavesAlphaAndDepth)
{
  Messages messages;
  Stage scene(Width, Height);
  AddPillarsAndLamp(scene);
  scene.Rays->AddLight(MakeSun({ -0.2, 0.1, -1.0 }, { 0.1, 0.3, 0.6 })); // layers of two are added
  const auto without = GetPixels(scene.Window);
  const auto depths = GetDepths(scene.Window, false);
  scene.Rays->Attach(scene.Renderer);
  scene.Rays->SetIntensity(0.7);

  for (const int output : { vtkGodRaysPass::OCCLUSION, vtkGodRaysPass::SCATTERING })
  {
    scene.Rays->SetOutput(output);
    const auto shown = GetPixels(scene.Window);
    EXPECT_EQ(depths, GetDepths(scene.Window, false));
    vtkNew<vtkImageData> layer;
    const bool occlusion = output == vtkGodRaysPass::OCCLUSION;
    ASSERT_TRUE(
      occlusion ? scene.Rays->GetOcclusionImage(layer) : scene.Rays->GetScatteringImage(layer));
    EXPECT_EQ(layer->GetDimensions()[0], Width);
    EXPECT_EQ(layer->GetDimensions()[1], Height);
    double worst = 0.0;
    double brightest = 0.0;
    int alphas = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * Width + x);
        alphas += shown[i + 3] != without[i + 3];
        for (int c = 0; c < 3; ++c)
        {
          const double value = (occlusion ? 1.0 : 0.7) * GetValue(layer, x, y, c);
          brightest = std::max(brightest, value);
          worst = std::max(worst, std::abs(255.0 * std::min(1.0, Encode(value)) - shown[i + c]));
        }
      }
    }
    EXPECT_LE(worst, 1.0) << output;
    EXPECT_GT(brightest, occlusion ? 0.9 : 0.01) << output;
    EXPECT_EQ(alphas, 0);
  }
}

TEST(GodRaysSceneEnvironment, SwitchesRaysOff)
{
  Messages messages;
  Stage scene(Width, Height);
  AddPillarsAndLamp(scene);
  const auto without = GetPixels(scene.Window);
  scene.Rays->Attach(scene.Renderer);
  const auto with = GetPixels(scene.Window);
  EXPECT_GT(CountDifferentPixels(with, without), 500);
  for (const char* value : { "1", "yes" })
  {
    setenv("GODRAYS_DISABLE", value, 1);
    EXPECT_EQ(GetPixels(scene.Window), without) << value;
    EXPECT_NE(scene.Rays->GetPlan().find("GODRAYS_DISABLE"), std::string::npos);
    vtkNew<vtkImageData> image;
    EXPECT_FALSE(scene.Rays->GetScatteringImage(image));
  }
  for (const char* value : { "0", "" })
  {
    setenv("GODRAYS_DISABLE", value, 1);
    EXPECT_EQ(GetPixels(scene.Window), with) << value;
  }
  unsetenv("GODRAYS_DISABLE");
  EXPECT_EQ(GetPixels(scene.Window), with);
}
