// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysEpipolarIntegrator: the limit of the sum, in whole scenes, to the tolerance; what it says
// of its own error; parity formulations; several lights; while the user drags.

#include "GodRaysTesting.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkObjectFactory.h"

#include <cmath>
#include <sstream>
#include <vector>

using namespace GodRaysTesting;

namespace
{
/// What the pass asks for.
class ProbedIntegrator : public vtkGodRaysEpipolarIntegrator
{
public:
  static ProbedIntegrator* New();
  vtkTypeMacro(ProbedIntegrator, vtkGodRaysEpipolarIntegrator);
  bool Integrate(const Request& request) override
  {
    this->Tolerances.push_back(request.ErrorTolerance);
    return this->Superclass::Integrate(request);
  }
  std::vector<double> Tolerances;
};
vtkStandardNewMacro(ProbedIntegrator);

class GodRaysEpipolar : public ::testing::TestWithParam<int>
{
protected:
  Messages VTKMessages;
  Stage Scene{ 96, 72 };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkNew<ProbedIntegrator> Integrator;

  GodRaysEpipolar()
  {
    this->Integrator->SetBackend(this->GetParam());
    this->Rays->SetIntegrator(this->Integrator);
  }

  vtkSmartPointer<vtkImageData> GetScattering()
  {
    this->Scene.Window->Render();
    auto image = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetScatteringImage(image)) << this->Rays->GetPlan();
    return image;
  }

  double GetError(std::array<double, 4> world)
  {
    this->Scene.Window->Render();
    return GetErrorOfLimit(this->Rays, this->Scene.Renderer, GetClip(this->Scene.Renderer, world));
  }

  static double GetLargest(vtkImageData* image)
  {
    double largest = 0.0;
    const int* size = image->GetDimensions();
    for (int i = 0; i < 3 * size[0] * size[1]; ++i)
    {
      largest = std::max<double>(largest, static_cast<float*>(image->GetScalarPointer())[i]);
    }
    return largest;
  }

  static double GetLargestDifference(vtkImageData* a, vtkImageData* b)
  {
    double largest = 0.0;
    const int* size = a->GetDimensions();
    for (int i = 0; i < 3 * size[0] * size[1]; ++i)
    {
      largest = std::max(largest,
        std::abs(static_cast<double>(static_cast<float*>(a->GetScalarPointer())[i]) -
          static_cast<float*>(b->GetScalarPointer())[i]));
    }
    return largest;
  }
};
}

TEST_P(GodRaysEpipolar, KeepsTheToleranceForLightsOfAllKinds)
{
  for (double tolerance : { 1.0 / 255.0, 1e-3 })
  {
    Stage scene(96, 72);
    scene.Rays->SetIntegrator(this->Integrator);
    scene.Rays->SetErrorTolerance(tolerance);
    scene.Rays->SetPrecision(vtkGodRaysPass::SINGLE);
    ForEachLight(scene,
      [&](const std::string& name, std::array<double, 4> world)
      {
        scene.Window->Render();
        const auto clip = GetClip(scene.Renderer, world);
        const double error = GetErrorOfLimit(scene.Rays, scene.Renderer, clip);
        std::ostringstream text;
        text << error;
        RecordProperty(name, text.str());
        std::cout << name << ": " << text.str() << "\n";
        EXPECT_LE(error, tolerance) << name;
        // the light a little off its place would be seen
        const double wrong = GetErrorOfLimit(
          scene.Rays, scene.Renderer, { { clip[0] + 0.1 * clip[2] + 0.1, clip[1], clip[2] } });
        EXPECT_GT(wrong, 1.5 * tolerance) << name;
      });
    this->Integrator->ReleaseGraphicsResources(scene.Window);
    scene.Rays->Detach(scene.Renderer);
  }
}

TEST_P(GodRaysEpipolar, MeasuresItsOwnError)
{
  this->Scene.AddPillarsAndSun();
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  const double error = this->GetError({ 0.3, 0.2, -1.0, 0.0 });
  EXPECT_EQ(this->Integrator->GetErrorEstimate(), -1.0);
  EXPECT_EQ(this->Integrator->GetLargestVerifiedError(), -1.0);

  // of all pixels, and of the worst of three channels: of red, since the sun is shown as (1, 0.9, 0.7)
  this->Integrator->SetVerifyPixels(1000000);
  this->Scene.Window->Render();
  const auto square = [](double shown) { return std::pow(vtkGodRays::DecodeDisplay(shown), 2.0); };
  const double red = std::sqrt(3.0 / (1.0 + square(0.9) + square(0.7)));
  EXPECT_NEAR(this->Integrator->GetErrorEstimate() / (red * error), 1.0, 0.01);
  const double largest = this->Integrator->GetLargestVerifiedError();
  this->Integrator->SetVerifyPixels(1000);
  this->Scene.Window->Render();
  EXPECT_NEAR(this->Integrator->GetErrorEstimate() / error, 1.0, 0.7);
  EXPECT_LE(this->Integrator->GetLargestVerifiedError(), largest);
  EXPECT_GT(this->Integrator->GetLargestVerifiedError(), this->Integrator->GetErrorEstimate());

  // other lights do not spoil it
  vtkNew<vtkLight> other;
  other->SetPosition(-0.3, -0.2, -1.0);
  other->SetFocalPoint(0.0, 0.0, 0.0);
  other->SetColor(0.2, 0.9, 0.4);
  this->Rays->AddLight(other);
  this->Scene.Window->Render();
  EXPECT_LT(this->Integrator->GetErrorEstimate(), 3.0 * error);
  EXPECT_GT(this->Integrator->GetErrorEstimate(), 0.3 * error);

  this->Integrator->SetVerifyPixels(0);
  this->Scene.Window->Render();
  EXPECT_EQ(this->Integrator->GetErrorEstimate(), -1.0);
}

TEST_P(GodRaysEpipolar, SumsParityFormulationsAsPublished)
{
  this->Scene.AddPillarsAndSun();
  for (const char* preset :
    { "published:mitchell", "published:postprocessing", "published:three.js" })
  {
    ASSERT_TRUE(this->Rays->ApplyPreset(preset));
    this->Rays->SetIntegrator(this->Integrator);
    auto image = this->GetScattering();
    EXPECT_NE(this->Rays->GetPlan().find("as published"), std::string::npos);
    SumTaps(this->Rays);
    EXPECT_EQ(GetLargestDifference(image, this->GetScattering()), 0.0) << preset;
  }
}

TEST_P(GodRaysEpipolar, AddsLightsOfAllKinds)
{
  // discs of two colours and a lamp, whose layer has colours: each alone, then together
  auto sun = this->Scene.AddPillarsAndSun();
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  auto light = MakeLamplight({ 0.6, 0.4, -3.0 });
  light->SetColor(0.3, 0.5, 1.0);
  this->Rays->AddLight(light);
  this->Rays->SetSourceRadius(0.3);
  auto lamp = MakeLamp({ -0.7, -0.4, -2.0 }, 0.5, { 1.0, 0.8, 0.4 });
  vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::IGNORED);
  this->Scene.Renderer->AddActor(lamp);

  std::vector<vtkSmartPointer<vtkImageData>> alone;
  light->SwitchOff();
  alone.push_back(this->GetScattering());
  light->SwitchOn();
  sun->SwitchOff();
  alone.push_back(this->GetScattering());
  auto both = [&]
  {
    light->SwitchOn();
    sun->SwitchOn();
    return this->GetScattering();
  }();
  const double peak = GetLargest(both);
  for (int i = 0; i < 3 * 96 * 72; ++i)
  {
    const auto at = [i](vtkImageData* image)
    { return static_cast<float*>(image->GetScalarPointer())[i]; };
    ASSERT_NEAR(at(both), at(alone[0]) + at(alone[1]), 1e-6 * peak) << i;
  }
  vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
  auto three = this->GetScattering();
  sun->SwitchOff();
  light->SwitchOff();
  auto lampAlone = this->GetScattering();
  EXPECT_GT(GetLargest(lampAlone), 0.01);
  EXPECT_GT(GetLargestDifference(three, both), 0.3 * GetLargest(lampAlone));
  EXPECT_EQ(this->Integrator->Tolerances.size(), 1u + 1u + 2u + 3u + 1u);
}

TEST_P(GodRaysEpipolar, BrightnessIsThatOfTheTaps)
{
  this->Scene.AddPillarsAndSun();
  auto model = vtkGodRaysRadialModel::SafeDownCast(this->Rays->GetModel());
  const int samples[] = { 1, 10, 100, 10000 };
  const double decays[] = { 0.0, 0.9, 1.0, 1.01 };
  for (int n : samples)
  {
    for (double decay : decays)
    {
      if (decay > 1.0 && n > 500) // 1.01^10000 is no kernel of any use
      {
        continue;
      }
      model->SetNumberOfSamples(n);
      model->SetDecay(decay);
      EXPECT_LE(this->GetError({ 0.3, 0.2, -1.0, 0.0 }), 2.0 / 255.0) << n << ", " << decay;
    }
  }
}

TEST_P(GodRaysEpipolar, IsCheaperWhileTheUserDragsAndThenAsAsked)
{
  this->Scene.AddPillarsAndSun();
  this->Rays->SetErrorTolerance(0.002);
  auto still = this->GetScattering();
  this->Scene.Window->SetDesiredUpdateRate(15.0); // as an interactor does
  this->Scene.Window->Render();
  this->Rays->SetInteractiveErrorTolerance(0.001);
  this->Scene.Window->Render();
  this->Rays->SetInteractiveErrorTolerance(0.05);
  this->Scene.Window->Render();
  this->Scene.Window->SetDesiredUpdateRate(0.0001);
  auto again = this->GetScattering();
  EXPECT_EQ(this->Integrator->Tolerances, std::vector<double>({ 0.002, 0.01, 0.002, 0.05, 0.002 }));
  EXPECT_EQ(GetLargestDifference(still, again), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Backends, GodRaysEpipolar,
  ::testing::Values(static_cast<int>(vtkGodRaysEpipolarIntegrator::PROCESSOR),
    static_cast<int>(vtkGodRaysEpipolarIntegrator::GRAPHICS)),
  [](const auto& info)
  { return info.param == vtkGodRaysEpipolarIntegrator::PROCESSOR ? "Processor" : "Graphics"; });
