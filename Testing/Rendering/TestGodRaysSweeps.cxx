// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Lights that move about the camera and through the edges of the picture, and lights, cameras and
// scenes at extreme places: no jump, no mirror image, nothing that is not a number.

#include "GodRaysTesting.h"

#include "vtkGodRaysRadialModel.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace GodRaysTesting;

namespace
{
using Values = std::vector<float>;

/// The light of the next frame, all zero when it has no rays. Fails when any is no finite number
/// of at least 0.
Values GetRays(Stage& scene)
{
  scene.Window->Render();
  const int* size = scene.Window->GetSize();
  Values values(static_cast<std::size_t>(3) * size[0] * size[1], 0.0f);
  vtkNew<vtkImageData> image;
  if (scene.Rays->GetScatteringImage(image))
  {
    std::copy_n(
      static_cast<const float*>(image->GetScalarPointer()), values.size(), values.begin());
  }
  EXPECT_TRUE(std::all_of(
    values.begin(), values.end(), [](float v) { return std::isfinite(v) && v >= 0.0f; }));
  return values;
}

double GetGreatest(const Values& values)
{
  return *std::max_element(values.begin(), values.end());
}

double GetDifference(const Values& a, const Values& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max<double>(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// Move a light along a path, t from 0 to 1: the largest change of any value from one step to the
/// next, the brightest value, and how many frames had rays.
struct Sweep
{
  double Step = 0.0;
  double Brightest = 0.0;
  int Lit = 0;

  Sweep(Stage& scene, int steps, const std::function<void(double)>& move)
  {
    Values before;
    for (int i = 0; i <= steps; ++i)
    {
      move(static_cast<double>(i) / steps);
      Values now = GetRays(scene);
      const double greatest = GetGreatest(now);
      this->Brightest = std::max(this->Brightest, greatest);
      this->Lit += greatest > 0.0;
      if (i > 0)
      {
        this->Step = std::max(this->Step, GetDifference(before, now));
      }
      before.swap(now);
    }
  }
};

/// A path in so many steps, and in twice as many: what does not jump changes half as much. If all of it are
/// so many degrees, one of them changes no pixel by more than a part of the brightest ray.
void ExpectNoJump(Stage& scene, int steps, const std::string& name,
  const std::function<void(double)>& move, double degrees = 0.0, double most = 1.0)
{
  const Sweep coarse(scene, steps, move);
  const Sweep fine(scene, 2 * steps, move);
  EXPECT_GT(coarse.Brightest, 0.0) << name;
  EXPECT_GT(coarse.Lit, steps / 20) << name;
  EXPECT_LT(fine.Step, 0.65 * coarse.Step)
    << name << ": " << coarse.Step << ", " << fine.Step << " of " << coarse.Brightest;
  if (degrees > 0.0)
  {
    const double change = fine.Step / (degrees / (2 * steps)) / coarse.Brightest;
    std::cout << name << ": a degree changes a pixel by " << change << " of the brightest ray\n";
    EXPECT_LT(change, most) << name;
  }
}

/// A pillar in a small picture.
struct SmallStage : Stage
{
  SmallStage()
    : Stage(40, 30)
  {
    this->Renderer->AddActor(MakeBox({ 0.7, 0.3, 0.0 }, { 0.8, 4.0, 0.5 }));
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE); // half floats have steps of their own
    this->Rays->SetSunAngularRadius(4.0);
    this->Rays->Attach(this->Renderer);
  }
};

void Aim(vtkLight* light, double x, double y, double z)
{
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
}
}

TEST(GodRaysSweeps, ASunAboutTheCameraDoesNotJump)
{
  Messages messages(true);
  SmallStage scene;
  auto sun = MakeSun({ 0.0, 0.0, -1.0 });
  scene.Rays->AddLight(sun);
  // azimuth, with a tilt so that nothing is symmetric
  ExpectNoJump(
    scene, 240, "azimuth",
    [&](double t)
    {
      const double angle = 2.0 * vtkMath::Pi() * t;
      Aim(sun, std::sin(angle), 0.1, -std::cos(angle));
    },
    360.0, 0.5);
  ExpectNoJump(
    scene, 240, "elevation",
    [&](double t)
    {
      const double angle = 2.0 * vtkMath::Pi() * t;
      Aim(sun, 0.07, std::sin(angle), -std::cos(angle));
    },
    360.0, 0.5);
  // a view so wide that the sun is in it, or next to it, as it passes beside the camera
  scene.Renderer->GetActiveCamera()->SetViewAngle(150.0);
  scene.Rays->SetBackgroundGlowFalloff(60.0);
  ExpectNoJump(
    scene, 240, "azimuth, wide",
    [&](double t)
    {
      const double angle = 2.0 * vtkMath::Pi() * t;
      Aim(sun, std::sin(angle), 0.1, -std::cos(angle));
    },
    360.0, 0.5);
}

TEST(GodRaysSweeps, ALampAboutTheCameraDoesNotJump)
{
  Messages messages(true);
  SmallStage scene;
  auto lamp = MakeLamplight({ 0.0, 0.0, 0.0 });
  scene.Rays->AddLight(lamp);
  scene.Rays->SetSourceRadius(1.0);
  for (const double viewAngle : { 40.0, 140.0 })
  {
    scene.Renderer->GetActiveCamera()->SetViewAngle(viewAngle);
    ExpectNoJump(scene, 300, "lamp, view angle " + std::to_string(viewAngle),
      [&](double t)
      {
        const double angle = 2.0 * vtkMath::Pi() * t;
        lamp->SetPosition(15.0 * std::sin(angle), 1.0, 10.0 - 15.0 * std::cos(angle));
      });
  }
}

TEST(GodRaysSweeps, AParallelCamerasLightsDoNotJump)
{
  Messages messages(true);
  SmallStage scene;
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  auto sun = MakeSun({ 0.0, 0.0, -1.0 });
  scene.Rays->AddLight(sun);
  // wide enough for the sun's glow, and very near to the direction of view
  for (const double beside : { 0.3, 1e-3 })
  {
    ExpectNoJump(scene, 240, "sun, beside " + std::to_string(beside),
      [&](double t)
      {
        const double angle = 0.5 * (2.0 * t - 1.0);
        Aim(sun, std::sin(angle), beside, -std::cos(angle));
      });
  }
  Aim(sun, 0.0, 0.0, -1.0);
  EXPECT_GT(GetGreatest(GetRays(scene)), 0.0);
  scene.Rays->RemoveAllLights();
  auto lamp = MakeLamplight({ 0.0, 0.0, 0.0 });
  scene.Rays->AddLight(lamp);
  scene.Rays->SetSourceRadius(0.8);
  ExpectNoJump(scene, 240, "lamp", [&](double t) { // across the picture and through its depth
    lamp->SetPosition(-14.0 + 28.0 * t, 1.0, -4.0);
  });
  scene.Renderer->RemoveAllViewProps(); // a pillar that is reached hides the lamp at once
  ExpectNoJump(
    scene, 400, "lamp in depth", [&](double t) { lamp->SetPosition(1.0, 1.0, -10.0 + 40.0 * t); });
}

TEST(GodRaysSweeps, ALightThroughEachEdgeAndCornerDoesNotJump)
{
  Messages messages(true);
  SmallStage scene;
  auto sun = MakeSun({ 0.0, 0.0, -1.0 });
  scene.Rays->AddLight(sun);
  const double height = std::tan(vtkMath::RadiansFromDegrees(20.0));
  const double width = height * 4.0 / 3.0;
  for (const bool small : { false, true })
  {
    scene.Rays->SetBackgroundGlow(small ? 0.0 : 0.5);
    scene.Rays->SetSunAngularRadius(small ? 0.2678 : 4.0);
    for (int i = 0; i < 9; ++i)
    {
      const int x = i % 3 - 1;
      const int y = i / 3 - 1;
      if (x == 0 && y == 0)
      {
        continue;
      }
      const std::string name = "edge " + std::to_string(x) + ", " + std::to_string(y);
      ExpectNoJump(scene, 30, name + (small ? ", small" : ", glowing"),
        [&](double t)
        {
          const double place = 0.8 + 0.4 * t; // from three pixels inside to three outside
          Aim(sun, width * (x ? x * place : 0.1), height * (y ? y * place : 0.2), -1.0);
        });
    }
  }
}

TEST(GodRaysSweeps, ALightBehindIsNotMirrored)
{
  Messages messages(true);
  SmallStage scene;
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->GetActiveCamera()->SetViewAngle(120.0);
  auto sun = MakeSun({ 1.0, 0.0, 0.0 });
  scene.Rays->AddLight(sun);
  scene.Rays->SetBackgroundGlowFalloff(60.0);
  int lit = 0;
  for (double degrees = 80.0; degrees <= 180.0; degrees += 2.0)
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    Aim(sun, std::sin(angle), 0.0, -std::cos(angle));
    const Values values = GetRays(scene);
    double sides[2] = { 0.0, 0.0 };
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sides[(i / 3) % 40 >= 20] += values[i];
    }
    if (GetGreatest(values) > 0.0)
    {
      ++lit;
      EXPECT_GT(sides[1], sides[0]) << degrees << " degrees to the right";
    }
    if (degrees > 96.0)
    {
      EXPECT_EQ(GetGreatest(values), 0.0) << degrees;
    }
  }
  EXPECT_GT(lit, 5);
}

TEST(GodRaysSweeps, ALightBesideAndBehindIsMarchedToAsAPointMovesTowardsIt)
{
  // The march is found by moving a point of the scene towards the sun and projecting it: away from
  // the sun's mirror image when the sun is behind the camera.
  Messages messages;
  SmallStage scene;
  SumTaps(scene.Rays);
  scene.Renderer->GetActiveCamera()->SetViewAngle(120.0);
  scene.Rays->SetBackgroundGlowFalloff(90.0);
  auto sun = MakeSun({ 1.0, 0.0, 0.0 });
  scene.Rays->AddLight(sun);
  auto model = vtkGodRaysRadialModel::SafeDownCast(scene.Rays->GetModel());
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(60.0));
  const double aspect = 4.0 / 3.0;
  ASSERT_EQ(model->GetNumberOfSamples(), 100);
  for (const double degrees : { 70.0, 88.0, 90.0, 92.0, 95.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const std::array<double, 3> towards{ { std::sin(angle), 0.3, -std::cos(angle) } };
    Aim(sun, towards[0], towards[1], towards[2]);
    const Values values = GetRays(scene);
    vtkNew<vtkImageData> layer;
    ASSERT_TRUE(scene.Rays->GetOcclusionImage(layer)) << degrees;
    const auto clip = GetClip(scene.Renderer, { towards[0], towards[1], towards[2], 0.0 });
    const double cap = 3.0 * std::hypot(aspect, 1.0);
    const double scale =
      cap / std::max(std::hypot(clip[0] * aspect, clip[1]), cap * std::abs(clip[2]));
    double worst = 0.0;
    for (int y = 1; y < 30; y += 4)
    {
      for (int x = 1; x < 40; x += 3)
      {
        const double ndc[2] = { (x + 0.5) / 20.0 - 1.0, (y + 0.5) / 15.0 - 1.0 };
        const double step = 1e-6;
        const auto moved = GetClip(scene.Renderer,
          { ndc[0] * tangent * aspect + step * towards[0], ndc[1] * tangent + step * towards[1],
            9.0 + step * towards[2], 1.0 });
        double sum = 0.0;
        double weight = model->GetWeight() * model->GetExposure();
        for (int k = 1; k <= 100; ++k)
        {
          const double way = model->GetDensity() * (k - 0.5) / 100.0 * scale / step;
          const double column = x + 20.0 * way * (moved[0] / moved[2] - ndc[0]);
          const double row = y + 15.0 * way * (moved[1] / moved[2] - ndc[1]);
          const int left = static_cast<int>(std::floor(column));
          const int below = static_cast<int>(std::floor(row));
          const double s = column - left;
          const double t = row - below;
          sum += weight *
            ((1.0 - t) *
                ((1.0 - s) * GetValue(layer, left, below) + s * GetValue(layer, left + 1, below)) +
              t *
                ((1.0 - s) * GetValue(layer, left, below + 1) +
                  s * GetValue(layer, left + 1, below + 1)));
          weight *= model->GetDecay();
        }
        worst = std::max(worst, std::abs(sum - values[3 * (40 * y + x)]));
      }
    }
    EXPECT_LT(worst, 1e-3 * GetGreatest(values)) << degrees;
  }
}

TEST(GodRaysExtremes, ALightOnAPixelsCentre)
{
  Messages messages;
  for (const bool positional : { false, true })
  {
    Stage scene(33, 25);
    scene.Renderer->AddActor(MakeBox({ 1.0, 1.0, 0.0 }, { 0.5, 0.5, 0.5 }));
    scene.Rays->Attach(scene.Renderer);
    scene.Rays->AddLight(
      positional ? MakeLamplight({ 0.0, 0.0, -5.0 }) : MakeSun({ 0.0, 0.0, -1.0 }));
    scene.Rays->SetSunAngularRadius(3.0);
    scene.Rays->SetSourceRadius(1.0);
    const Values values = GetRays(scene);
    const auto at = [&values](int x, int y) { return values[3 * (33 * y + x)]; };
    EXPECT_GT(at(16, 12), 0.5 * GetGreatest(values));
    for (const int d : { -1, 1 })
    {
      EXPECT_NEAR(at(16 + d, 12), at(16, 12), 0.05 * at(16, 12));
      EXPECT_NEAR(at(16, 12 + d), at(16, 12), 0.05 * at(16, 12));
    }
  }
}

TEST(GodRaysExtremes, AVeryFarLampIsASun)
{
  Messages messages;
  Values values[2];
  for (const bool positional : { false, true })
  {
    Stage scene;
    scene.AddPillarsAndSun();
    scene.Rays->RemoveAllLights();
    const double length = std::sqrt(0.3 * 0.3 + 0.2 * 0.2 + 1.0);
    scene.Rays->SetSunAngularRadius(2.0);
    scene.Rays->SetSourceRadius(1e7 * length * std::sin(vtkMath::RadiansFromDegrees(2.0)));
    scene.Rays->AddLight(
      positional ? MakeLamplight({ 0.3e7, 0.2e7, 10.0 - 1e7 }) : MakeSun({ 0.3, 0.2, -1.0 }));
    values[positional] = GetRays(scene);
  }
  EXPECT_GT(GetGreatest(values[0]), 0.0);
  EXPECT_LT(GetDifference(values[0], values[1]), 2e-3 * GetGreatest(values[0]));
}

TEST(GodRaysExtremes, AScene1e7FromTheOriginAndANearPlane1e7TimesNearer)
{
  Messages messages;
  Values values[4];
  for (int kind = 0; kind < 4; ++kind)
  {
    Stage scene;
    const double shift = kind == 1 ? 1e7 : 0.0;
    const std::array<double, 3> offset{ { shift, -0.7 * shift, 0.3 * shift } };
    for (int i = -3; i <= 3; ++i)
    {
      auto box = MakeBox({ 0.0, 0.0, 0.0 }, { 0.5, 4.0, 0.5 });
      box->SetPosition(offset[0] + 1.2 * i, offset[1], offset[2]);
      scene.Renderer->AddActor(box);
    }
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(offset[0], offset[1], offset[2] + 10.0);
    camera->SetFocalPoint(offset.data());
    if (kind == 2)
    {
      camera->SetClippingRange(1e-2, 1e5);
    }
    if (kind == 3)
    {
      scene.Rays->SetLayerMargin(0.5); // the occluders are rendered again
    }
    scene.Rays->SetSourceRadius(0.5);
    scene.Rays->AddLight(MakeLamplight({ offset[0] + 2.0, offset[1] + 1.0, offset[2] - 3.0 }));
    scene.Rays->Attach(scene.Renderer);
    values[kind] = GetRays(scene);
  }
  const double peak = GetGreatest(values[0]);
  EXPECT_GT(peak, 0.0);
  EXPECT_LT(GetDifference(values[0], values[1]), 5e-3 * peak) << "far from the origin";
  EXPECT_LT(GetDifference(values[0], values[2]), 5e-3 * peak) << "near plane";
}

TEST(GodRaysExtremes, ACameraWithinThings)
{
  Messages messages(true);
  // in an occluder: nothing is open
  Stage inside;
  inside.Renderer->AddActor(MakeBox({ 0.0, 0.0, 10.0 }, { 8.0, 8.0, 8.0 }));
  inside.Rays->AddLight(MakeSun({ 0.1, 0.1, -1.0 }));
  inside.Rays->Attach(inside.Renderer);
  EXPECT_EQ(GetGreatest(GetRays(inside)), 0.0);

  // in a lamp that is a prop: light all over
  Stage within;
  auto shade = MakeLamp({ 0.0, 0.0, 10.0 }, 4.0);
  vtkGodRaysPass::SetRole(shade, vtkGodRaysPass::LIGHT);
  within.Renderer->AddActor(shade);
  within.Rays->Attach(within.Renderer);
  const Values values = GetRays(within);
  EXPECT_GT(*std::min_element(values.begin(), values.end()), 0.1f);

  // in a light's sphere, and at a light's very place
  for (const double z : { 9.0, 10.0, 11.0 })
  {
    Stage light;
    light.Renderer->AddActor(MakeBox({ 0.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
    light.Rays->SetSourceRadius(3.0);
    light.Rays->AddLight(MakeLamplight({ 0.0, 0.0, z }));
    light.Rays->Attach(light.Renderer);
    EXPECT_LT(GetGreatest(GetRays(light)), 10.0) << z;
  }
}
