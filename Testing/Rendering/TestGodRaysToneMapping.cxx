// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays within vtkToneMappingPass: light beyond white reaches it, decoded once and encoded once.

#include "GodRaysTesting.h"

#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSkySource.h"

#include "vtkCamera.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkToneMappingPass.h"

#include <cmath>
#include <functional>

using namespace GodRaysTesting;

namespace
{
const int Width = 96;
const int Height = 72;
const double Intensity = 4.0;

using Curve = std::function<double(double)>;

double Reinhard(double light)
{
  return light / (light + 1.0);
}

double Decode(double value)
{
  return std::pow(value, 2.2);
}

double Encode(double light)
{
  return std::pow(light, 1.0 / 2.2);
}

/// The pillars before a bright sun, the background opaque, as tone mapping needs it.
struct BrightStage : Stage
{
  BrightStage()
    : Stage(Width, Height)
  {
    this->AddPillarsAndSun();
    this->Renderer->SetBackgroundAlpha(1.0);
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  }

  /// The picture, as the tone mapping of this type makes it.
  std::vector<unsigned char> Render(int type)
  {
    this->Rays->SetIntensity(Intensity);
    this->Rays->Detach(this->Renderer);
    vtkNew<vtkToneMappingPass> outer;
    outer->SetToneMappingType(type);
    outer->SetExposure(0.7f);
    outer->SetDelegatePass(this->Rays);
    this->Renderer->SetPass(outer);
    return GetPixels(this->Window);
  }
};

/// How far a tone-mapped picture is at worst from the curve of scene and rays [levels of 255].
double GetErrorOfCurve(BrightStage& stage, int type, const Curve& curve)
{
  stage.Rays->SetIntensity(0.0);
  const auto scene = GetPixels(stage.Window);
  const auto picture = stage.Render(type);
  vtkNew<vtkImageData> light;
  EXPECT_TRUE(stage.Rays->GetScatteringImage(light));
  double worst = 0.0;
  double brightest = 0.0;
  for (int i = 0; i < Width * Height; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double sum =
        Decode(scene[4 * i + c] / 255.0) + Intensity * GetValue(light, i % Width, i / Width, c);
      brightest = std::max(brightest, sum);
      worst = std::max(worst, std::abs(picture[4 * i + c] - 255.0 * Encode(curve(sum))));
    }
  }
  EXPECT_GT(brightest, 2.0) << "nothing is beyond white";
  return worst;
}

/// The rays' plan within this pass.
std::string GetPlanWithin(Stage& stage, vtkImageProcessingPass* outer)
{
  stage.Rays->Detach(stage.Renderer);
  stage.Renderer->SetPass(outer);
  stage.Window->Render();
  return stage.Rays->GetPlan();
}
}

TEST(GodRaysToneMapping, GetsLinearLightBeyondWhite)
{
  Messages messages;
  const struct
  {
    int Type;
    Curve Of;
  } curves[] = { { vtkToneMappingPass::Clamp, [](double x) { return std::min(x, 1.0); } },
    { vtkToneMappingPass::Reinhard, Reinhard },
    { vtkToneMappingPass::Exponential, [](double x) { return 1.0 - std::exp(-0.7 * x); } } };
  for (const auto& curve : curves)
  {
    BrightStage stage;
    EXPECT_LE(GetErrorOfCurve(stage, curve.Type, curve.Of), 1.0) << curve.Type;
  }
}

// What the test above must not let pass: another transfer, and light that is encoded twice.
TEST(GodRaysToneMapping, OfAnotherTransferIsNotThatLight)
{
  Messages messages;
  BrightStage sRGB;
  sRGB.Rays->SetDisplayTransfer(vtkGodRaysPass::SRGB_TRANSFER);
  EXPECT_GT(GetErrorOfCurve(sRGB, vtkToneMappingPass::Reinhard, Reinhard), 2.0);
  BrightStage stage;
  const Curve twice = [](double light) { return Encode(Reinhard(light)); };
  EXPECT_GT(GetErrorOfCurve(stage, vtkToneMappingPass::Reinhard, twice), 30.0);
}

TEST(GodRaysToneMapping, IsFoundThroughOtherPasses)
{
  Messages messages;
  const std::string power = "linear light by a power of 2.2";
  Stage stage;
  stage.AddPillarsAndSun();
  vtkNew<vtkFramebufferPass> inner;
  inner->SetDelegatePass(stage.Rays);
  EXPECT_FALSE(Says(GetPlanWithin(stage, inner), power)) << "there is no tone mapping";
  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetDelegatePass(inner);
  EXPECT_TRUE(Says(GetPlanWithin(stage, toneMapping), power));
  vtkNew<vtkGaussianBlurPass> blur;
  blur->SetDelegatePass(toneMapping);
  EXPECT_TRUE(Says(GetPlanWithin(stage, blur), power));
  stage.Rays->SetDisplayTransfer(vtkGodRaysPass::SRGB_TRANSFER);
  EXPECT_FALSE(Says(GetPlanWithin(stage, blur), power)) << "what is asked for goes first";
}

// A sky beyond white: the middle of the picture is Reinhard's curve of the radiance in its direction.
TEST(GodRaysToneMapping, GetsTheSkysLinearLight)
{
  Messages messages;
  const double direction[3] = { 0.0, 0.6, 0.8 };
  Stage stage(33, 33);
  stage.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 2.0);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(direction[0], direction[1], direction[2] + 2.0);
  vtkNew<vtkGodRaysSkyPass> sky;
  sky->SetExposure(200.0);
  sky->WhiteBalanceOff();
  sky->MultipleScatteringOff();
  vtkNew<vtkToneMappingPass> outer;
  outer->SetToneMappingType(vtkToneMappingPass::Reinhard);
  outer->SetDelegatePass(sky);
  stage.Renderer->SetPass(outer);

  vtkNew<vtkGodRaysSkySource> source;
  double radiance[3];
  source->GetRadiance(direction, radiance);
  const auto getWorst = [&]()
  {
    const auto picture = GetPixels(stage.Window);
    double worst = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double shown = 255.0 * Encode(Reinhard(sky->GetExposure() * radiance[c]));
      worst = std::max(worst, std::abs(picture[4 * (16 * 33 + 16) + c] - shown));
    }
    return worst;
  };
  EXPECT_GT(sky->GetExposure() * radiance[2], 1.5) << "not beyond white";
  EXPECT_LE(getWorst(), 1.0);
  sky->SetExposure(1.0);
  EXPECT_LE(getWorst(), 1.0);
  sky->SetDisplayTransfer(vtkGodRaysPass::SRGB_TRANSFER);
  EXPECT_GT(getWorst(), 2.0) << "what the bound above must not let pass";
}
