// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The integrator that chooses: what it takes for which light, view and tolerance, and how far that is from
// the ground truth, with a picture without shadows as the control.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace GodRaysTesting;

namespace
{
class GodRaysAutomaticIntegrator : public MediumTest
{
protected:
  std::string GetPlan()
  {
    this->Scene.Window->Render();
    return this->Rays->GetPlan();
  }

  /// The error by default, and that of a picture in which things are seen but cast no shadow.
  void CheckAgainstNoShadows(const char* name, std::array<double, 4> light, double bound)
  {
    const double error = this->GetError(light);
    const auto setRoles = [this](int role)
    {
      vtkPropCollection* props = this->Renderer->GetViewProps();
      for (int i = 0; i < props->GetNumberOfItems(); ++i)
      {
        vtkGodRaysPass::SetRole(vtkProp::SafeDownCast(props->GetItemAsObject(i)), role);
      }
    };
    setRoles(vtkGodRaysPass::IGNORED);
    auto lit = this->GetScattering();
    setRoles(vtkGodRaysPass::AUTOMATIC);
    const double without = GetErrorOfMedium(this->Renderer, this->Model, light, lit);
    std::cout << name << ": " << error << ", without shadows " << without << "\n";
    EXPECT_LT(error, bound) << name;
    EXPECT_GT(without, 4.0 * bound) << name;
  }
};
}

TEST_F(GodRaysAutomaticIntegrator, ChoosesByLightViewAndMedium)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "shadow map: 4 of 768")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "walked on the processor"));
  this->SetLight({ 0.0, 0.5, -2.0, 1.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "6 of 1024")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "walked on the processor"));
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  EXPECT_TRUE(Says(this->GetPlan(), "parallel projection")) << this->Rays->GetPlan();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "1 of 1536")) << this->Rays->GetPlan();
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
  vtkNew<vtkGodRaysAtmosphereModel> air;
  this->Rays->SetModel(air);
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  EXPECT_TRUE(Says(this->GetPlan(), "layered medium")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "4 of 768"));
  air->SetPlanetRadius(6.36e6);
  EXPECT_TRUE(Says(this->GetPlan(), "layered medium over a planet")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->GetPlan(), "4 of 768"));
  auto pane = MakeBox({ 0.0, 3.0, 0.0 }, { 4.0, 0.1, 4.0 });
  pane->GetProperty()->SetOpacity(0.5);
  this->Renderer->AddActor(pane);
  EXPECT_TRUE(Says(this->GetPlan(), "layers, as some props let light through"))
    << this->Rays->GetPlan();
}

TEST_F(GodRaysAutomaticIntegrator, TakesMapsByTheTolerance)
{
  this->AddPillars();
  this->SetLight({ 0.15, 0.1, -1.0, 0.0 });
  for (const auto& [tolerance, words] : { std::pair<double, const char*>{ 1.0 / 32.0, "4 of 256" },
         { 1.0 / 64.0, "4 of 256" }, { 1.0 / 128.0, "4 of 384" }, { 1.0 / 255.0, "4 of 768" },
         { 1.0 / 512.0, "4 of 1536" }, { 1e-6, "4 of 2048" } })
  {
    this->Rays->SetErrorTolerance(tolerance);
    EXPECT_TRUE(Says(this->GetPlan(), words)) << tolerance << "\n" << this->Rays->GetPlan();
  }
}

// While the camera is dragged one map serves; the still picture is the same every time.
TEST_F(GodRaysAutomaticIntegrator, KeepsTheMapWhileTheCameraIsDragged)
{
  this->AddPillars();
  for (const std::array<double, 4>& light :
    { std::array<double, 4>{ 0.15, 0.1, -1.0, 0.0 }, { 0.0, 0.5, -2.0, 1.0 } })
  {
    this->SetLight(light);
    const auto still = GetPixels(this->Scene.Window);
    this->Scene.Window->SetDesiredUpdateRate(15.0);
    this->Scene.Window->Render();
    for (int frame = 0; frame < 3; ++frame)
    {
      this->Renderer->GetActiveCamera()->Azimuth(1.0);
      EXPECT_TRUE(Says(this->GetPlan(), " of 1024 x 1024")) << this->Rays->GetPlan();
      EXPECT_TRUE(Says(this->GetPlan(), ", kept, "));
    }
    this->Renderer->GetActiveCamera()->Azimuth(-3.0);
    this->Scene.Window->SetDesiredUpdateRate(0.0001);
    EXPECT_LE(GetLargestDifference(still, GetPixels(this->Scene.Window)), 1);
  }
}

// A roof on columns over the eye, the sun behind it: most of what casts a shadow is not in the picture.
TEST_F(GodRaysAutomaticIntegrator, SeesARoofAndColumnsBehindTheEye)
{
  this->Renderer->AddActor(MakeBox({ 0.0, 2.6, 4.0 }, { 8.0, 0.2, 18.0 }));
  for (const double z : { -4.0, -1.0, 2.0, 5.0, 8.0, 11.0 })
  {
    this->Renderer->AddActor(MakeBox({ -2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
    this->Renderer->AddActor(MakeBox({ 2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
  }
  this->CheckAgainstNoShadows("sun behind the eye", { 1.0, 0.5, 0.6, 0.0 }, 0.004);
}

// In so small a picture the lines of the sweep, 2 pixels apart, decide the error, not the map.
TEST_F(GodRaysAutomaticIntegrator, SeesWhatStandsBesideThePicture)
{
  for (const double y : { -1.5, 0.0, 1.5 })
  {
    this->Renderer->AddActor(MakeBox({ 7.0, y, 1.0 }, { 0.4, 0.6, 6.0 }));
  }
  this->CheckAgainstNoShadows("sun beside", { 1.0, 0.1, -0.2, 0.0 }, 0.003);
  this->CheckAgainstNoShadows("lamp beside", { 11.0, 0.5, 1.0, 1.0 }, 0.005);
}

namespace
{
/// A hall of columns under a roof with a gap, open on all sides: errors of frames, as they are measured.
class GodRaysContinuity : public GodRaysAutomaticIntegrator
{
protected:
  GodRaysContinuity()
  {
    this->Scene.Window->SetSize(480, 270);
    this->Renderer->AddActor(MakeBox({ -2.0, 2.6, 2.0 }, { 3.0, 0.2, 12.0 }));
    this->Renderer->AddActor(MakeBox({ 2.0, 2.6, 2.0 }, { 3.0, 0.2, 12.0 }));
    for (const double z : { -3.0, -0.5, 2.0, 4.5, 7.0 })
    {
      this->Renderer->AddActor(MakeBox({ -2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
      this->Renderer->AddActor(MakeBox({ 2.0, 0.5, z }, { 0.4, 4.2, 0.4 }));
    }
    this->Rays->GetIntegrator()->SetVerifyPixels(FewPixels);
    this->Sun = this->AddSun({ 0.0, 0.3, -1.0 });
  }

  void SetSun(double degrees, double elevation)
  {
    const double azimuth = vtkMath::RadiansFromDegrees(degrees);
    this->Sun->SetPosition(std::sin(azimuth), elevation, -std::cos(azimuth));
  }

  /// Draw a frame, and take its error.
  void Take(const std::string& name)
  {
    // What it learns in one frame must not show in the next ones: each is on its own.
    this->Rays->SetErrorTolerance(this->Errors.size() % 2 ? 1.0 / 255.0 : 1.0 / 255.0 - 1e-9);
    this->Renderer->ResetCameraClippingRange();
    this->Scene.Window->Render();
    vtkGodRaysIntegrator* integrator = this->Rays->GetIntegrator();
    if (integrator->GetErrorEstimate() > 1.0 / 255.0) // a few pixels decide: take all
    {
      integrator->SetVerifyPixels(480 * 270);
      this->Rays->SetErrorTolerance(this->Rays->GetErrorTolerance() - 2e-9);
      this->Scene.Window->Render();
      integrator->SetVerifyPixels(FewPixels);
    }
    this->Errors.push_back(integrator->GetErrorEstimate());
    if (this->Errors.back() >= *std::max_element(this->Errors.begin(), this->Errors.end()))
    {
      this->Worst = name;
    }
  }

  void Check()
  {
    double squares = 0.0;
    for (const double error : this->Errors)
    {
      EXPECT_GE(error, 0.0);
      squares += error * error;
    }
    const double worst = *std::max_element(this->Errors.begin(), this->Errors.end());
    std::cout << this->Errors.size() << " frames: root mean square "
              << std::sqrt(squares / this->Errors.size()) << ", worst " << worst << " at "
              << this->Worst << "\n";
    EXPECT_LT(worst, 2.0 / 255.0);
  }

  static constexpr int FewPixels = 2000;

  /// GODRAYS_LONG makes steps finer.
  static int GetSteps(int few, int many) { return std::getenv("GODRAYS_LONG") ? many : few; }

  vtkSmartPointer<vtkLight> Sun;
  std::vector<double> Errors;
  std::string Worst;
};
}

TEST_F(GodRaysContinuity, TheSunGoesRound)
{
  const int steps = GetSteps(120, 720);
  for (int i = 0; i < steps; ++i)
  {
    const double degrees = 360.0 * i / steps;
    this->SetSun(degrees, 0.5);
    this->Take(std::to_string(degrees) + " degrees");
  }
  this->Check();
}

TEST_F(GodRaysContinuity, TheSunRises)
{
  const int steps = GetSteps(60, 360);
  for (int i = 0; i < steps; ++i)
  {
    const double elevation = std::tan(vtkMath::RadiansFromDegrees(-60.0 + 140.0 * i / steps));
    this->SetSun(40.0, elevation);
    this->Take("tangent " + std::to_string(elevation));
  }
  this->Check();
}

TEST_F(GodRaysContinuity, TheCameraFliesThrough)
{
  this->SetSun(60.0, 0.7);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const int steps = GetSteps(80, 400);
  for (int i = 0; i < steps; ++i)
  {
    const double at = static_cast<double>(i) / steps;
    const double turn = vtkMath::RadiansFromDegrees(300.0 * at);
    const double place[3] = { 1.2 * std::sin(7.0 * at), 0.6 + 0.4 * at, 12.0 - 18.0 * at };
    camera->SetPosition(place);
    camera->SetFocalPoint(place[0] + std::sin(turn), place[1] + 0.1, place[2] - std::cos(turn));
    this->Take("frame " + std::to_string(i));
  }
  this->Check();
}

// Lamps as far away as suns are, and parallel rays that nearly follow the view.
TEST_F(GodRaysAutomaticIntegrator, IsTheGroundTruthInHardCases)
{
  this->AddPillars();
  const std::array<double, 3> towards = { 0.15, 0.1, -1.0 };
  for (const double distance : { 50.0, 200.0, 1000.0 })
  {
    this->CheckAgainstNoShadows(("lamp at " + std::to_string(distance)).c_str(),
      { distance * towards[0], distance * towards[1], distance * towards[2], 1.0 }, 0.0039);
  }
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  // A view ray along the light is in one texel for long: the map's edges count for all of it.
  const std::array<std::array<double, 2>, 4> cases = { { { 0.1, 0.0075 }, { 1.0, 0.003 },
    { 6.0, 0.0045 }, { 13.0, 0.002 } } };
  for (const auto& [degrees, bound] : cases)
  {
    for (const double along : { -1.0, 1.0 })
    {
      const double angle = vtkMath::RadiansFromDegrees(degrees);
      this->CheckAgainstNoShadows(
        (std::to_string(degrees) + (along < 0.0 ? " degrees, in front" : " degrees, behind"))
          .c_str(),
        { 0.8 * std::sin(angle), 0.6 * std::sin(angle), along * std::cos(angle), 0.0 }, bound);
    }
  }
}

// Without thickness, whose far side ends the view rays at the very depth that the map has.
TEST_F(GodRaysAutomaticIntegrator, AClosedRoomIsDark)
{
  auto room = MakeBox({ 0.0, 0.0, 2.0 }, { 14.0, 6.0, 24.0 });
  this->Renderer->AddActor(room);
  const std::vector<std::array<double, 4>> lights = { { 0.3, 1.0, 0.2, 0.0 },
    { 0.3, 0.05, -1.0, 0.0 }, { 1.0, 0.01, 0.3, 0.0 }, { 0.3, 0.3, 1.0, 0.0 },
    { 2.0, 9.0, -18.0, 1.0 }, { 9.0, 0.5, 3.0, 1.0 } };
  const auto getLargest = [this]()
  {
    const auto image = this->GetScattering();
    double largest = 0.0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        largest = std::max(largest, GetValue(image, x, y));
      }
    }
    return largest;
  };
  for (const auto& light : lights)
  {
    this->SetLight(light);
    const double dark = getLargest();
    vtkGodRaysPass::SetRole(room, vtkGodRaysPass::IGNORED);
    const double lit = getLargest();
    vtkGodRaysPass::SetRole(room, vtkGodRaysPass::AUTOMATIC);
    std::cout << light[0] << " " << light[3] << ": " << dark / lit << "\n";
    EXPECT_LT(dark, 1e-3 * lit);
  }
}

TEST_F(GodRaysAutomaticIntegrator, IsTheClosedFormWhereNoShadowCanBeSeen)
{
  this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -25.0 }, { 200.0, 200.0, 0.1 }));
  EXPECT_LT(this->GetError({ 0.0, 0.2, 1.0, 0.0 }), 1e-4);
}
