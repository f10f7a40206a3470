// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes and translucent surfaces are data before each background, also before one whose alpha is 1 and
// hides theirs.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysMath.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <ostream>
#include <tuple>
#include <utility>
#include <vector>

using namespace GodRaysTesting;
using vtkGodRays::Vec3;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

/// A ball of a colour, denser in its middle, as a volume.
vtkSmartPointer<vtkVolume> MakeBall(double x, std::array<double, 3> color)
{
  constexpr int count = 24;
  constexpr double size = 2.4;
  vtkNew<vtkImageData> image;
  image->SetDimensions(count, count, count);
  image->SetSpacing(size / (count - 1), size / (count - 1), size / (count - 1));
  image->SetOrigin(x - 0.5 * size, -0.5 * size, -0.5 * size);
  image->AllocateScalars(VTK_FLOAT, 1);
  const double middle = 0.5 * (count - 1);
  for (int k = 0; k < count; ++k)
  {
    for (int j = 0; j < count; ++j)
    {
      for (int i = 0; i < count; ++i)
      {
        const double radius = std::hypot(i - middle, j - middle, k - middle) / middle;
        *static_cast<float*>(image->GetScalarPointer(i, j, k)) =
          static_cast<float>(glm::smoothstep(1.0, 0.6, radius));
      }
    }
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05);
  mapper->UseJitteringOff();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.9);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, color[0], color[1], color[2]);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetInterpolationTypeToLinear();
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
    pixels[i] = static_cast<unsigned char>(10 + 5 * (i / 3 % 16));
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

/// The haze of a medium among volumes takes a second for each frame of Width x Height pixels.
constexpr int MediumScale = 2;

/// Coloured volumes, or sheets, in the light of the eye, a bright sun behind them. The window has
/// Width / scale x Height / scale pixels.
struct HazyStage : Stage
{
  explicit HazyStage(bool sheets = false, int samples = 0, int scale = 1)
    : Stage(Width / scale, Height / scale)
    , Pixels(Width / scale * (Height / scale))
  {
    const std::array<double, 3> colors[] = { { 0.6, 0.2, 0.1 }, { 0.2, 0.45, 0.2 },
      { 0.15, 0.25, 0.6 } };
    for (int i = 0; i < 3; ++i)
    {
      if (sheets)
      {
        auto sheet = MakeBox({ 2.4 * (i - 1), 0.0, 0.0 }, { 1.8, 3.0, 0.1 }, colors[i]);
        sheet->GetProperty()->SetOpacity(0.9);
        this->Renderer->AddActor(sheet);
      }
      else
      {
        this->Volumes.push_back(MakeBall(2.4 * (i - 1), colors[i]));
        this->Renderer->AddVolume(this->Volumes.back());
      }
    }
    this->Renderer->AddActor(MakeBox({ 0.8, 0.4, 1.5 }, { 0.5, 0.5, 0.5 }, { 0.5, 0.4, 0.1 }));
    this->Renderer->GetActiveCamera()->SetClippingRange(7.0, 12.0); // as ResetCameraClippingRange()
    this->Window->SetMultiSamples(samples);
    this->Renderer->SetBackground(0.1, 0.1, 0.1);
    this->Sun = MakeSun({ 0.05, 0.1, -1.0 }, { 1.0, 0.9, 0.7 });
    this->Rays->AddLight(this->Sun);
    this->Rays->SetAutomaticExposure(true);
    this->Rays->SetHighlightShoulder(true);
    this->Rays->SetDarkenLightBackground(true);
    this->Rays->Attach(this->Renderer);
    this->FindData();
  }

  void SetHaze()
  {
    vtkNew<vtkGodRaysHomogeneousModel> model;
    model->ApplyPreset("haze");
    this->Rays->SetModel(model);
  }

  /// Where black and white backgrounds hardly show.
  void FindData()
  {
    this->SetStrength(0.0);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    const auto black = GetPixels(this->Window);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    const auto white = GetPixels(this->Window);
    this->Renderer->SetBackground(0.1, 0.1, 0.1);
    this->IsData.clear();
    for (int i = 0; i < this->Pixels; ++i)
    {
      this->IsData.push_back(white[4 * i + 1] < black[4 * i + 1] + 50);
    }
    this->SetStrength(1.0);
  }

  void SetStrength(double intensity) { this->Rays->SetIntensity(intensity); }

  struct Change
  {
    double Difference = 0.0; // mean over data, in CIE 1976 L*a*b*
    double Color = 0.0;      // largest in a* and b* of data
    double Beside = 0.0;     // mean difference beside data
  };

  /// Of the rays; depths and alpha are those without them.
  Change Compare()
  {
    this->SetStrength(0.0);
    const auto without = GetPixels(this->Window);
    const auto depths = GetDepths(this->Window, false);
    this->SetStrength(1.0);
    const auto with = GetPixels(this->Window);
    EXPECT_EQ(depths, GetDepths(this->Window, false));
    const auto get = [](const std::vector<unsigned char>& picture, int i)
    {
      return vtkGodRays::LabOfLight(vtkGodRays::DecodeDisplay(
        Vec3(picture[4 * i], picture[4 * i + 1], picture[4 * i + 2]) / 255.0));
    };
    Change change;
    int count[2] = { 0, 0 };
    int otherAlpha = 0;
    for (int i = 0; i < this->Pixels; ++i)
    {
      const Vec3 before = get(without, i);
      const Vec3 after = get(with, i);
      otherAlpha += with[4 * i + 3] != without[4 * i + 3] ? 1 : 0;
      ++count[this->IsData[i] ? 1 : 0];
      if (this->IsData[i])
      {
        change.Difference += glm::length(after - before);
        change.Color = std::max(change.Color, std::hypot(after.y - before.y, after.z - before.z));
      }
      else
      {
        change.Beside += glm::length(after - before);
      }
    }
    EXPECT_EQ(otherAlpha, 0);
    EXPECT_GT(count[1], this->Pixels / 20);
    change.Difference /= count[1];
    change.Beside /= count[0];
    return change;
  }

  Change CompareDataFirst()
  {
    this->Rays->SetDataFirst(true);
    const Change change = this->Compare();
    this->Rays->SetDataFirst(false);
    return change;
  }

  const int Pixels; // of the window
  vtkSmartPointer<vtkLight> Sun;
  std::vector<vtkSmartPointer<vtkVolume>> Volumes;
  std::vector<bool> IsData;
};

struct Background
{
  const char* Name;
  std::function<void(HazyStage&)> Arrange;
};

void PrintTo(const Background& background, std::ostream* os)
{
  *os << background.Name;
}

void SetGradient(vtkRenderer* renderer)
{
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.05, 0.05, 0.1);
  renderer->SetBackground2(0.15, 0.2, 0.3);
}

/// Another renderer, whose picture is kept.
void AddBelow(HazyStage& stage)
{
  vtkNew<vtkRenderer> below;
  SetGradient(below);
  stage.Window->RemoveRenderer(stage.Renderer);
  stage.Window->AddRenderer(below);
  stage.Window->AddRenderer(stage.Renderer);
}

const Background Backgrounds[] = {
  { "Colour", [](HazyStage&) {} },
  { "OpaqueColour", [](HazyStage& stage) { stage.Renderer->SetBackgroundAlpha(1.0); } },
  { "Gradient", [](HazyStage& stage) { SetGradient(stage.Renderer); } },
  { "LightGradient",
    [](HazyStage& stage)
    {
      SetGradient(stage.Renderer);
      stage.Renderer->SetBackground(0.9, 0.9, 0.9);
      stage.Renderer->SetBackground2(1.0, 1.0, 1.0);
    } },
  { "Texture",
    [](HazyStage& stage)
    {
      stage.Renderer->TexturedBackgroundOn();
      stage.Renderer->SetBackgroundTexture(MakeTexture());
    } },
  { "Skybox",
    [](HazyStage& stage)
    {
      vtkNew<vtkSkybox> sky;
      sky->SetTexture(MakeTexture());
      sky->SetProjectionToSphere();
      stage.Renderer->AddActor(sky);
    } },
  { "PreservedPicture",
    [](HazyStage& stage)
    {
      AddBelow(stage);
      stage.Renderer->PreserveColorBufferOn();
    } },
  { "LayerBelow",
    [](HazyStage& stage)
    {
      AddBelow(stage);
      stage.Window->SetNumberOfLayers(2);
      stage.Renderer->SetLayer(1);
    } },
  { "GradientInADelegate",
    [](HazyStage& stage)
    {
      SetGradient(stage.Renderer);
      vtkNew<vtkRenderPassCollection> steps;
      steps->AddItem(vtkNew<vtkLightsPass>());
      steps->AddItem(vtkNew<vtkOpaquePass>());
      steps->AddItem(vtkNew<vtkVolumetricPass>());
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(steps);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      stage.Rays->SetDelegatePass(camera);
    } },
};

class GodRaysBackgrounds : public ::testing::TestWithParam<Background>
{
};
}

//------------------------------------------------------------------------------
TEST_P(GodRaysBackgrounds, VolumesAreData)
{
  Messages messages;
  for (const auto& [name, medium, samples] : { std::tuple("look", false, 0),
         std::tuple("look of samples", false, 4), std::tuple("medium", true, 0) })
  {
    SCOPED_TRACE(name);
    HazyStage stage(false, samples, medium ? MediumScale : 1);
    if (medium)
    {
      stage.SetHaze();
    }
    const double plain = stage.Compare().Difference;
    GetParam().Arrange(stage);
    const auto change = stage.Compare();
    EXPECT_LE(change.Difference, 10.0);
    EXPECT_LE(change.Difference, 1.5 * plain + 0.5);
    EXPECT_GT(change.Beside, 2.0); // rays are seen

    // weakened by nobody
    stage.Rays->SetAutomaticExposure(false);
    stage.Rays->SetDarkenLightBackground(false);
    const auto all = stage.Compare();
    EXPECT_GT(all.Color, 15.0);
    const double first = stage.CompareDataFirst().Color;
    EXPECT_LT(first, 0.35 * all.Color);
    std::cout << name << ": dE " << change.Difference << ", before one colour " << plain
              << "; data first: colours by " << first << " rather than " << all.Color << "\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Before, GodRaysBackgrounds, ::testing::ValuesIn(Backgrounds),
  [](const ::testing::TestParamInfo<Background>& info) { return std::string(info.param.Name); });

//------------------------------------------------------------------------------
// The opacity of data is at its place, whatever part of the window and of the layer the picture is.
TEST(GodRaysBackground, DataAreWhereTheyAreSeen)
{
  Messages messages;
  const std::pair<const char*, std::function<void(HazyStage&)>> arrangements[] = {
    { "a viewport",
      [](HazyStage& stage) { stage.Renderer->SetViewport(0.25, 0.125, 0.875, 0.75); } },
    { "a margin", [](HazyStage& stage) { stage.Rays->SetLayerMargin(0.3); } },
    { "two eyes",
      [](HazyStage& stage)
      {
        stage.Window->SetStereoType(VTK_STEREO_SPLITVIEWPORT_HORIZONTAL);
        stage.Window->StereoRenderOn();
      } },
    { "props that block no light",
      [](HazyStage& stage) { stage.Rays->UntaggedPropsOccludeOff(); } },
    { "one that does",
      [](HazyStage& stage)
      {
        stage.Rays->UntaggedPropsOccludeOff();
        vtkGodRaysPass::SetRole(stage.Volumes[0], vtkGodRaysPass::OCCLUDER);
      } },
  };
  for (const auto& [name, arrange] : arrangements)
  {
    for (const bool medium : { false, true })
    {
      SCOPED_TRACE(std::string(name) + (medium ? ", medium" : ", look"));
      HazyStage stage(false, 0, medium ? MediumScale : 1);
      stage.Rays->SetAutomaticExposure(false);
      arrange(stage);
      stage.FindData();
      if (medium)
      {
        stage.SetHaze();
      }
      SetGradient(stage.Renderer);
      const auto all = stage.Compare();
      const auto first = stage.CompareDataFirst();
      EXPECT_GT(all.Color, 15.0);
      EXPECT_LT(first.Color, 0.35 * all.Color);
      EXPECT_GT(first.Beside, 0.7 * all.Beside);
      std::cout << name << ": data first: colours by " << first.Color << " rather than "
                << all.Color << ", beside data " << first.Beside << " and " << all.Beside << "\n";
    }
  }
}

//------------------------------------------------------------------------------
TEST(GodRaysBackground, TranslucentSurfacesAreData)
{
  Messages messages;
  for (const bool peels : { false, true })
  {
    HazyStage stage(true);
    stage.Renderer->SetUseDepthPeeling(peels);
    stage.FindData();
    SetGradient(stage.Renderer);
    const auto change = stage.Compare();
    EXPECT_LE(change.Difference, 10.0);
    stage.Rays->SetAutomaticExposure(false);
    stage.Rays->SetDarkenLightBackground(false);
    const auto all = stage.Compare();
    EXPECT_GT(all.Difference, 15.0);
    EXPECT_LT(stage.CompareDataFirst().Color, 0.35 * all.Color);
  }
}

//------------------------------------------------------------------------------
// Volumes cost time: they are rendered again only where nothing else says where they are.
TEST(GodRaysBackground, VolumesAreRenderedAgainOnlyWhereNeeded)
{
  Messages messages;
  HazyStage stage(false, 0, MediumScale);
  int count = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&count);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  stage.Volumes[0]->GetMapper()->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, counter);
  const auto getRendered = [&]()
  {
    stage.Window->Render();
    count = 0;
    stage.Window->Render();
    const bool told = Says(stage.Rays->GetPlan(), "opacity of data before the background");
    EXPECT_EQ(told, Says(stage.Rays->GetPlan(), "rendered a second time"));
    return std::pair(count, told);
  };
  using Result = std::pair<int, bool>;
  EXPECT_EQ(getRendered(), Result(2, false)); // by the scene, and as what dims light
  SetGradient(stage.Renderer);
  EXPECT_EQ(getRendered(), Result(2, false));

  stage.SetHaze();
  EXPECT_EQ(getRendered(), Result(2, true));
  stage.Rays->SetAutomaticExposure(false);
  stage.Rays->SetDarkenLightBackground(false);
  EXPECT_EQ(getRendered(), Result(1, false)); // nobody asks
  stage.Rays->SetDataFirst(true);
  EXPECT_EQ(getRendered(), Result(2, true));
  stage.Renderer->GradientBackgroundOff();
  EXPECT_EQ(getRendered(), Result(1, false));
}

//------------------------------------------------------------------------------
// A pixel of several samples shows data in some of them: there rays are between those over data and those
// beside them.
TEST(GodRaysBackground, EdgesOfDataAreSmooth)
{
  Messages messages;
  constexpr int scale = 4;
  for (const bool gradient : { false, true })
  {
    SCOPED_TRACE(gradient ? "gradient" : "one colour");
    std::vector<unsigned char> pictures[2];
    std::vector<float> depths;
    for (const bool fine : { false, true })
    {
      Stage stage(fine ? scale * Width : Width, fine ? scale * Height : Height);
      for (int i = -3; i <= 3; ++i)
      {
        auto board = MakeBox({ 1.1 * i, 0.0, 0.0 }, { 0.3, 6.0, 0.1 }, { 0.4, 0.1, 0.1 });
        board->RotateZ(20.0);
        stage.Renderer->AddActor(board);
      }
      stage.Renderer->SetGradientBackground(gradient);
      stage.Window->SetMultiSamples(fine ? 0 : 8);
      stage.Rays->AddLight(MakeSun({ 0.05, 0.1, -1.0 }, { 1.0, 0.9, 0.7 }));
      stage.Rays->SetDataFirst(true);
      stage.Rays->SetMostDataLightness(0.0); // data are as without rays
      stage.Rays->Attach(stage.Renderer);
      pictures[fine ? 1 : 0] = GetPixels(stage.Window);
      depths = GetDepths(stage.Window, false);
    }
    double difference = 0.0;
    int count = 0;
    for (int i = 0; i < Width * Height; ++i)
    {
      double covered = 0.0;
      Vec3 light(0.0);
      for (int k = 0; k < scale * scale; ++k)
      {
        const int x = i % Width * scale + k % scale;
        const int y = i / Width * scale + k / scale;
        const int pixel = y * Width * scale + x;
        covered += depths[pixel] < 1.0f ? 1.0 / (scale * scale) : 0.0;
        for (int c = 0; c < 3; ++c)
        {
          light[c] += std::pow(pictures[1][4 * pixel + c] / 255.0, 2.2) / (scale * scale);
        }
      }
      if (covered > 0.2 && covered < 0.8)
      {
        ++count;
        for (int c = 0; c < 3; ++c)
        {
          difference +=
            std::abs(pictures[0][4 * i + c] - 255.0 * std::pow(light[c], 1.0 / 2.2)) / 3.0;
        }
      }
    }
    EXPECT_GT(count, Width * Height / 40);
    std::cout << "edges differ by " << difference / count << " levels of 255\n";
    EXPECT_LT(difference / count, 30.0); // what data half cover counts as three quarters
  }
}
