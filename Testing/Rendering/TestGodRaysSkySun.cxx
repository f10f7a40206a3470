// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sun of a sky: its disc, its light, its surroundings, and what is brighter than white.

#include "GodRaysSkyTesting.h"

#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysHomogeneousModel.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace GodRaysTesting;
using vtkGodRays::ToVec3;
using Atmosphere = vtkGodRaysAtmosphere;

// Where values have 8 bits, light that is brighter than white keeps its hue: below half of white, all of it
// is as it is; floating-point values always are.
TEST_F(GodRaysSkyPass, KeepsItsHueWhereItIsBright)
{
  this->Sky->GetAtmosphere()->LoadPreset(Atmosphere::MARS);
  this->Sky->SetExposure(12.0);
  this->SetSun(8.0);
  this->SetView(2.0, 180.0, 12.0, 60.0);
  const std::vector<Vec3> light = this->Render();
  double brightest = 0.0;
  for (const Vec3& each : light)
  {
    brightest = std::max(brightest, GetBrightest(each));
  }
  EXPECT_GT(brightest, 4.0); // the shoulder is not for them

  struct Picture
  {
    double Clipped = 0.0; // part of the pixels
    double Below = 0.0;   // largest error below the knee [levels of 255]
    double Hue = 0.0;     // largest error of a channel above it, in units of the brightest
    int Above = 0;        // pixels above the knee
  };
  this->Renderer->SetPass(this->Sky);
  const auto look = [&]
  {
    const auto pixels = GetPixels(this->Window);
    Picture picture;
    for (std::size_t i = 0; i < light.size(); ++i)
    {
      const Vec3 shown(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
      picture.Clipped +=
        GetBrightest(shown) == 255.0 ? 1.0 / static_cast<double>(light.size()) : 0.0;
      if (GetBrightest(light[i]) < 0.49)
      {
        picture.Below = std::max(
          picture.Below, GetBrightest(abs(shown - 255.0 * vtkGodRays::EncodeDisplay(light[i]))));
        continue;
      }
      ++picture.Above;
      const Vec3 seen = vtkGodRays::DecodeDisplay(shown / 255.0);
      picture.Hue = std::max(picture.Hue,
        GetBrightest(abs(seen / GetBrightest(seen) - light[i] / GetBrightest(light[i]))));
    }
    return picture;
  };
  this->Sky->DitheringOff(); // bytes are compared
  EXPECT_FALSE(this->Sky->GetHighlightShoulder());
  this->Sky->HighlightShoulderOn();
  const Picture with = look();
  std::cout << "8 bits: " << 100.0 * with.Clipped << " % clipped, hue within " << with.Hue << " of "
            << with.Above << " bright pixels, " << with.Below << " levels off below\n";
  EXPECT_EQ(with.Clipped, 0.0);
  EXPECT_LT(with.Below, 0.6);
  EXPECT_LT(with.Hue, 0.02);
  EXPECT_GT(with.Above, 100);

  // the sun is seen, as the only white
  const auto sky = GetPixels(this->Window);
  this->Sky->SunDiscOn();
  const auto sun = GetPixels(this->Window);
  this->Sky->SunDiscOff();
  int white = 0;
  for (std::size_t i = 0; i < sky.size(); ++i)
  {
    EXPECT_GE(sun[i], sky[i]) << i;
    white += i % 4 < 3 && sun[i] == 255;
  }
  EXPECT_GT(white, 2);

  this->Sky->HighlightShoulderOff();
  const Picture without = look();
  std::cout << "without a shoulder: " << 100.0 * without.Clipped << " % clipped, hue within "
            << without.Hue << "\n";
  EXPECT_GT(without.Clipped, 0.1);
  EXPECT_GT(without.Hue, 0.2);
  EXPECT_LT(without.Below, 0.6);

  // tone mapping has all of the light
  this->Sky->HighlightShoulderOn();
  this->Renderer->SetPass(this->Floats);
  const auto& again = this->Render();
  EXPECT_EQ(again, light);
}

TEST_F(GodRaysSkyPass, HasASunThatIsDarkerTowardsItsLimb)
{
  this->SetSun(40.0);
  this->SetView(2.0, 180.0, 40.0, 0.8);
  const auto bare = this->Render();
  this->Sky->SunDiscOn();
  const auto& disc = this->Render();
  Vec3 sum(0.0);
  for (std::size_t i = 0; i < disc.size(); ++i)
  {
    sum += disc[i] - bare[i];
  }
  const double pixel = 2.0 * this->Tangent / Size;
  double irradiance[3];
  ASSERT_TRUE(this->Truth->GetSunLight(irradiance));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(sum[c] * pixel * pixel / irradiance[c], 1.0, 0.01);
  }
  const Vec3 middle = disc[Size * Size / 2 + Size / 2];
  const Vec3 limb = disc[Size * Size / 2 + Size / 2 + 14]; // of 16 pixels
  EXPECT_NEAR(limb.x / middle.x, std::pow(1.0 - 14.5 * 14.5 / 16.07 / 16.07, 0.2032), 0.03);
  EXPECT_LT(limb.z / middle.z, limb.x / middle.x);
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, GivesALightTheColourOfTheSun)
{
  vtkNew<vtkLight> light;
  this->Sky->SetExposure(2.0);
  double former = 2.0;
  for (const double sun : { 60.0, 20.0, 5.0, 1.0 })
  {
    this->SetSun(sun);
    this->Truth->SetObserverHeight(0.0);
    this->Sky->UpdateLight(light);
    double truth[3];
    ASSERT_TRUE(this->Truth->GetSunLight(truth));
    double color[3];
    this->Sky->GetSunColor(color);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(color[c], truth[c]);
      EXPECT_NEAR(vtkGodRays::DecodeDisplay(light->GetDiffuseColor()[c]) * light->GetIntensity(),
        2.0 * truth[c] / vtkMath::Pi(), 1e-9);
    }
    EXPECT_LT(color[2] / color[0], former) << "redder when lower";
    former = color[2] / color[0];
    double towards[3];
    vtkMath::Subtract(light->GetPosition(), light->GetFocalPoint(), towards);
    EXPECT_LT(length(ToVec3(towards) - GetDirection(180.0, sun)), 1e-9);
  }
  this->SetSun(-1.0);
  this->Sky->UpdateLight(light);
  EXPECT_EQ(light->GetIntensity(), 0.0);
  this->Sky->UpdateLight(nullptr);
  EXPECT_EQ(this->Said.Take().size(), 1u);
}

TEST_F(GodRaysSkyPass, HasAWhiteSun)
{
  Atmosphere* air = this->Sky->GetAtmosphere();
  const Vec3 sun = ToVec3(air->GetSunIrradiance());
  const Vec3 gain = vtkGodRays::Luminance(sun) / sun;
  this->SetView(2.0, 180.0, 20.0, 60.0);
  const auto plain = this->Render();
  vtkNew<vtkLight> light;
  this->Sky->UpdateLight(light);
  const Vec3 bluish = ToVec3(light->GetDiffuseColor());
  const double bluishIntensity = light->GetIntensity();
  this->Sky->WhiteBalanceOn();
  const auto& balanced = this->Render();
  ASSERT_GT(GetBrightest(plain[100]), 1e-3);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    EXPECT_LT(GetBrightest(abs(balanced[i] - gain * plain[i])), 1e-5 * GetBrightest(balanced[i]))
      << i;
  }
  this->Sky->UpdateLight(light);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(vtkGodRays::DecodeDisplay(light->GetDiffuseColor()[c]) * light->GetIntensity(),
      gain[c] * vtkGodRays::DecodeDisplay(bluish[c]) * bluishIntensity, 1e-9);
  }
}

TEST_F(GodRaysSkyPass, IsUnderTheRaysInTheSunsColour)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(96, 64);
  window->AddRenderer(renderer);
  renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->SetView(2.0, 180.0, 5.0, 50.0);
  for (int i = -2; i <= 2; ++i)
  {
    renderer->AddActor(MakeBox({ 6.0 * i, -40.0, 5.0 }, { 2.0, 2.0, 14.0 }));
  }
  this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 100.0);
  const auto getPicture = [&](bool raysFirst, double elevation, double* blueOverRed)
  {
    vtkNew<vtkGodRaysPass> rays;
    vtkNew<vtkLight> sun;
    if (raysFirst)
    {
      rays->Attach(renderer);
    }
    vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
    EXPECT_EQ(sky, vtkGodRaysSkyPass::Attach(renderer)) << "the one that it has";
    if (!raysFirst)
    {
      rays->Attach(renderer);
    }
    EXPECT_EQ(renderer->GetPass(), rays);
    EXPECT_EQ(rays->GetDelegatePass(), sky);
    sky->MultipleScatteringOff();
    sky->SetSunElevation(elevation);
    sky->UpdateLight(sun);
    rays->AddLight(sun);
    auto picture = GetPixels(window);
    vtkNew<vtkImageData> light;
    EXPECT_TRUE(rays->GetScatteringImage(light));
    EXPECT_GT(GetMean(light), 1e-3);
    double sums[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 96 * 64; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        sums[c] += GetValue(light, i % 96, i / 96, c);
      }
    }
    *blueOverRed = sums[2] / sums[0];
    EXPECT_TRUE(vtkGodRaysSkyPass::Detach(renderer));
    EXPECT_EQ(renderer->GetPass(), rays);
    EXPECT_EQ(rays->GetDelegatePass(), nullptr);
    rays->Detach(renderer);
    EXPECT_EQ(renderer->GetPass(), nullptr);
    return picture;
  };
  double high = 0.0;
  double low = 0.0;
  const auto picture = getPicture(false, 10.0, &high);
  EXPECT_EQ(picture, getPicture(true, 10.0, &high)) << "in whatever order they are attached";
  getPicture(false, 2.0, &low);
  EXPECT_LT(low, 0.5 * high);
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(renderer));
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(this->Renderer)) << "the delegate of another pass";
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(nullptr));
  EXPECT_EQ(vtkGodRaysSkyPass::Attach(nullptr), nullptr);
  EXPECT_EQ(this->Said.Take().size(), 1u);
}

//------------------------------------------------------------------------------
// Its light has the colour below the air for surfaces, and an atmosphere's model, which dims it itself, takes
// what it is above: else a low sun would be dimmed twice, blue 10 times at 5 degrees.
TEST_F(GodRaysSkyPass, GivesAnAtmosphereTheSunAboveIt)
{
  this->SetView(2.0, 180.0, 5.0, 50.0);
  this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 1e5);
  this->Renderer->AddActor(MakeBox({ 0.0, -40.0, 5.0 }, { 2.0, 2.0, 14.0 }));
  this->Renderer->SetPass(nullptr);
  vtkNew<vtkGodRaysAtmosphereModel> air;
  vtkNew<vtkGodRaysPass> rays;
  rays->SetModel(air);
  rays->Attach(this->Renderer);
  vtkNew<vtkLight> sun;
  rays->AddLight(sun);
  const auto measure = [&]
  {
    GetPixels(this->Window);
    vtkNew<vtkImageData> light;
    EXPECT_TRUE(rays->GetScatteringImage(light)) << rays->GetPlan();
    std::array<double, 3> sums = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < Size * Size; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        sums[c] += GetValue(light, i % Size, i / Size, c);
      }
    }
    return sums;
  };
  for (const double elevation : { 40.0, 5.0, 2.0 })
  {
    this->Sky->SetSunElevation(elevation);
    ASSERT_TRUE(this->Sky->UpdateLight(sun));
    const auto given = measure();
    sun->SetIntensity(2.0 * sun->GetIntensity());
    const auto twice = measure();
    // by hand: what the atmosphere has above it
    const double* above = this->Sky->GetAtmosphere()->GetSunIrradiance();
    const double brightest = std::max({ above[0], above[1], above[2] });
    std::array<double, 3> color;
    for (int c = 0; c < 3; ++c)
    {
      color[c] = vtkGodRays::EncodeDisplay(above[c] / brightest);
    }
    const double below[3] = { sun->GetDiffuseColor()[0], sun->GetDiffuseColor()[1],
      sun->GetDiffuseColor()[2] };
    const double intensity = 0.5 * sun->GetIntensity();
    sun->SetColor(color.data());
    sun->SetIntensity(brightest * this->Sky->GetExposure() / vtkMath::Pi());
    const auto wanted = measure();
    sun->SetColor(below[0], below[1], below[2] + 1e-9); // the control: a colour of the user's own
    sun->SetIntensity(intensity);
    const auto dimmed = measure();
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(given[c] / wanted[c], 1.0, 1e-3) << elevation << " " << c;
      EXPECT_NEAR(twice[c] / given[c], 2.0, 1e-3) << elevation << " " << c;
    }
    if (elevation < 10.0)
    {
      EXPECT_LT(dimmed[2], 0.5 * given[2]) << elevation;
    }
  }
  rays->Detach(this->Renderer);
}

//------------------------------------------------------------------------------
// As VTK's shaders look it up: right, up and their cross product are x, y and z of a sphere.
TEST_F(GodRaysSkyPass, HasAnEnvironment)
{
  this->Sky->SetExposure(2.0);
  this->Truth->SetObserverHeight(0.0);
  vtkTexture* texture = this->Sky->GetEnvironmentTexture();
  ASSERT_TRUE(texture);
  vtkImageData* image = texture->GetInput();
  ASSERT_EQ(image->GetDimensions()[0], 128);
  const vtkMTimeType time = image->GetMTime();
  const Vec3 up(0.0, 0.0, 1.0);
  const Vec3 right(0.0, -1.0, 0.0);
  const Vec3 third = cross(right, up);
  for (const double azimuth : { 10.0, 100.0, 180.0, 300.0 })
  {
    const Vec3 ray = GetDirection(azimuth, 35.0);
    const double u = std::atan2(dot(ray, third), dot(ray, right)) / (2.0 * vtkMath::Pi()) + 0.5;
    const double v = std::asin(dot(ray, up)) / vtkMath::Pi() + 0.5;
    const int x = static_cast<int>(u * 128.0);
    const int y = static_cast<int>(v * 64.0);
    const Vec3 truth = 2.0 * this->GetTruth(ray);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetValue(image, x, y, c) / truth[c], 1.0, 0.1) << azimuth << " " << c;
    }
  }
  EXPECT_EQ(this->Sky->GetEnvironmentTexture()->GetInput()->GetMTime(), time);
  this->Sky->SetSunElevation(31.0);
  EXPECT_EQ(this->Sky->GetEnvironmentTexture(), texture);
  EXPECT_GT(texture->GetInput()->GetMTime(), time);
}

//------------------------------------------------------------------------------
// A surface in each kind of shading has its light and that of the sky, as linear light; without SurfaceLight
// it is what it is without a sky, and so it is for another renderer that has it, too.
TEST_F(GodRaysSkyPass, LightsSurfaces)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> surface;
  surface->SetMapper(mapper);
  this->Renderer->AddActor(surface);
  this->Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToHeadlight();
  lamp->SetIntensity(0.4);
  this->Renderer->AddLight(lamp);
  this->Sky->AerialPerspectiveOff();
  this->Sky->SetExposure(3.0);
  const Vec3 color(0.9, 0.5, 0.2);
  surface->GetProperty()->SetColor(color.x, color.y, color.z);
  const auto see = [&](double elevation, const Vec3& normal, bool sky)
  {
    plane->SetCenter(0.0, 0.0, 0.0);
    plane->SetNormal(normal.x, normal.y, normal.z);
    const Vec3 side = cross(normal, std::abs(normal.z) > 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vec3 eye = 0.2 * normal + Vec3(0.0, 0.0, 2.0);
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(0.0, 0.0, 2.0);
    camera->SetViewUp(side.x, side.y, side.z);
    camera->SetClippingRange(0.01, 10.0);
    surface->SetPosition(0.0, 0.0, 2.0);
    this->SetSun(elevation);
    this->Sky->SetSurfaceLight(sky);
    return this->Render()[Size * Size / 2 + Size / 2];
  };
  vtkNew<vtkRenderStepsPass> steps;
  double errors[2] = {};
  for (const bool isPhysical : { false, true })
  {
    surface->GetProperty()->SetInterpolation(isPhysical ? VTK_PBR : VTK_PHONG);
    for (const double elevation : { 40.0, 5.0, -4.0, -30.0 })
    {
      for (const Vec3& normal : { Vec3(0.0, 0.0, 1.0), Vec3(0.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0),
             normalize(Vec3(1.0, 1.0, -1.0)) })
      {
        this->Floats->SetDelegatePass(steps);
        const Vec3 without = see(elevation, normal, false);
        this->Floats->SetDelegatePass(this->Sky);
        EXPECT_EQ(see(elevation, normal, false), without);
        EXPECT_FALSE(surface->GetPropertyKeys() &&
          surface->GetPropertyKeys()->Has(vtkOpenGLRenderPass::RenderPasses()));
        const Vec3 with = see(elevation, normal, true);
        EXPECT_TRUE(Says(this->Sky->GetPlan(), "surfaces: light of the sky"));
        Vec3 light;
        ASSERT_TRUE(this->Sky->GetSkyIrradiance(&normal[0], &light[0]));
        light *= 3.0 / vtkMath::Pi();
        for (int c = 0; c < 3; ++c)
        {
          // VTK's physically based shading takes colours for linear ones, and 2.2 for the curve
          const double shown[2] = { vtkGodRays::EncodeDisplay(without[c]),
            vtkGodRays::EncodeDisplay(with[c]) };
          const double truth = isPhysical
            ? std::pow(shown[0], 2.2) + color[c] * light[c] / vtkMath::Pi()
            : color[c] *
              vtkGodRays::EncodeDisplay(vtkGodRays::DecodeDisplay(shown[0] / color[c]) + light[c]);
          // and mirrors a few hundredths of it
          const double found = isPhysical ? std::pow(shown[1], 2.2) : shown[1];
          errors[isPhysical] = std::max(errors[isPhysical], std::abs(found - truth));
        }
        if (elevation < -20.0)
        {
          EXPECT_LT(length(with - without), 1e-3);
        }
        else if (elevation > 0.0)
        {
          EXPECT_GT(length(with - without), 0.005);
        }
      }
    }
  }
  std::cout << "light of the sky on surfaces: " << errors[0] << " off, physically based "
            << errors[1] << std::endl;
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_LT(errors[1], 0.01);

  // It leaves alone surfaces without lights, and scenes as wide as countries.
  surface->GetProperty()->SetInterpolationToPhong();
  surface->GetProperty()->LightingOff();
  const Vec3 up(0.0, 0.0, 1.0);
  EXPECT_EQ(see(40.0, up, true), see(40.0, up, false));
  surface->GetProperty()->LightingOn();
  this->Sky->SetWorldUnitInMeters(1e6);
  const Vec3 large = see(40.0, up, true);
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "it has more than one sky"));
  EXPECT_EQ(large, see(40.0, up, false));
  this->Sky->SetWorldUnitInMeters(1.0);

  // Another renderer with a sky of its own, and one without.
  const Vec3 day = see(40.0, up, true);
  vtkNew<vtkRenderer> other;
  other->SetActiveCamera(this->Renderer->GetActiveCamera());
  other->SetAutomaticLightCreation(false);
  other->AddLight(lamp);
  other->AddActor(surface);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(Size, Size);
  window->AddRenderer(other);
  const auto plain = GetPixels(window);
  EXPECT_EQ(see(40.0, up, true), day);
  EXPECT_EQ(GetPixels(window), plain);
  auto night = vtkGodRaysSkyPass::Attach(other);
  night->SetSunElevation(-30.0);
  GetPixels(window);
  EXPECT_EQ(see(40.0, up, true), day);
  vtkGodRaysSkyPass::Detach(other);
  EXPECT_EQ(see(40.0, up, true), day);
  other->RemoveActor(surface);

  // A view that scales by different factors is told of once; one that mirrors, or scales alike, is none.
  std::vector<std::size_t> told;
  for (const Vec3& factors :
    { Vec3(1.0), Vec3(-1.0, 1.0, 1.0), Vec3(2.0), Vec3(1.5, 1.0, 1.0), Vec3(1.5, 1.0, 1.0) })
  {
    vtkNew<vtkTransform> scaling;
    scaling->Scale(factors.x, factors.y, factors.z);
    this->Renderer->GetActiveCamera()->SetUserViewTransform(scaling);
    see(40.0, up, true);
    told.push_back(this->Said.Take().size());
  }
  EXPECT_EQ(told, (std::vector<std::size_t>{ 0, 0, 0, 1, 0 }));
  this->Renderer->GetActiveCamera()->SetUserViewTransform(nullptr);

  // A prop that shares its keys, as a copy and the parts of an assembly do, may go.
  vtkNew<vtkActor> copy;
  copy->ShallowCopy(surface);
  this->Renderer->AddActor(copy);
  EXPECT_EQ(see(40.0, up, true), day);
  this->Renderer->RemoveActor(copy);
  EXPECT_EQ(see(40.0, up, true), day);
}

//------------------------------------------------------------------------------
// After sunset fog has the light of the sky alone: its mean radiance, as much as fog takes of what is behind
// it, times the albedo. Without SurfaceLight it is black, and so it is at night.
TEST_F(GodRaysSkyPass, LightsMedia)
{
  const double depth = 0.7;
  const double albedo = 0.6;
  vtkNew<vtkGodRaysHomogeneousModel> fog;
  fog->SetScatteringCoefficient(
    albedo * depth / 10.0, albedo * depth / 10.0, albedo * depth / 10.0);
  fog->SetAbsorptionCoefficient(
    (1.0 - albedo) * depth / 10.0, (1.0 - albedo) * depth / 10.0, (1.0 - albedo) * depth / 10.0);
  vtkNew<vtkGodRaysPass> rays;
  rays->SetModel(fog);
  rays->SetDelegatePass(this->Sky);
  this->Floats->SetDelegatePass(rays);
  this->SetView(2.0, 180.0, 0.0, 20.0);
  this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 100.0);
  auto wall = MakeBox({ 0.0, -15.0, 2.0 }, { 20.0, 10.0, 20.0 }); // its face is 10 away
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->Renderer->AddActor(wall);
  this->Sky->AerialPerspectiveOff();
  this->Sky->SetExposure(5.0);
  vtkNew<vtkLight> sun;
  rays->AddLight(sun);
  const auto see = [&](double elevation, bool shines)
  {
    this->SetSun(elevation);
    this->Sky->SetSurfaceLight(shines);
    EXPECT_TRUE(this->Sky->UpdateLight(sun));
    return this->Render()[Size * Size / 2 + Size / 2];
  };
  Vec3 mean(0.0);
  const Vec3 dusk = see(-3.0, true);
  const Vec3 up(0.0, 0.0, 1.0);
  Vec3 above;
  ASSERT_TRUE(this->Sky->GetSkyIrradiance(&up[0], &above[0]));
  this->Truth->SetObserverHeight(0.0);
  for (int k = 0; k < 40 * 40; ++k)
  {
    const double height = -90.0 + 4.5 * (k / 40 + 0.5);
    const Vec3 ray = GetDirection(9.0 * (k % 40 + 0.5), height);
    const Vec3 ground =
      ToVec3(this->Sky->GetAtmosphere()->GetGroundAlbedo()) * above / vtkMath::Pi();
    mean += std::cos(vtkMath::RadiansFromDegrees(height)) * vtkMath::Pi() / 2.0 / (40 * 40) *
      (this->GetTruth(ray) + (ray.z < 0.0 ? ground : Vec3(0.0)));
  }
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(dusk[c] / (5.0 * albedo * (1.0 - std::exp(-depth)) * mean[c]), 1.0, 0.03) << c;
  }
  EXPECT_EQ(see(-3.0, false), Vec3(0.0));
  EXPECT_LT(GetBrightest(see(-20.0, true)), 1e-4);
}
