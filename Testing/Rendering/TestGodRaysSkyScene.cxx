// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sky behind a scene and the air before it: the integral, and where they are drawn and made.

#include "GodRaysSkyTesting.h"

#include "vtkGodRaysAtmosphere.h"

#include "vtkConeSource.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <iostream>
#include <limits>

using namespace GodRaysTesting;
using vtkGodRays::ToVec3;
using Atmosphere = vtkGodRaysAtmosphere;

//------------------------------------------------------------------------------
namespace
{
/// Single scattering along the first part of a ray, in the middle of many steps, and what it leaves of the
/// light behind.
void IntegrateAir(Atmosphere* atmosphere, double height, const Vec3& ray, const Vec3& sun,
  double reach, Vec3& light, Vec3& left)
{
  const vtkGodRays::SkyAtmosphere sky = vtkGodRays::MakeSkyAtmosphere(atmosphere);
  const double cosAngle = dot(ray, sun);
  const auto shadow = vtkGodRays::SkyShadow(sky.GroundRadius, height, ray.z, sun.z, cosAngle);
  const int steps = 500;
  light = Vec3(0.0);
  for (int i = 0; i < steps; ++i)
  {
    const double distance = (i + 0.5) / steps * reach;
    if (!(distance > shadow.x && distance < shadow.y))
    {
      light +=
        reach / steps * vtkGodRays::SkyInscatter(sky, height, ray.z, sun.z, cosAngle, distance);
    }
  }
  light *= ToVec3(atmosphere->GetSunIrradiance());
  left = exp(-vtkGodRays::SkyDepth(sky, height, ray.z, reach));
}

/// A plane across the view, of a colour that no light changes.
vtkSmartPointer<vtkActor> MakeWall(const Vec3& center, const Vec3& look, double size, double grey)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(size, 0.0, 0.0);
  plane->SetPoint2(0.0, size, 0.0);
  plane->SetCenter(center.x, center.y, center.z);
  plane->SetNormal(-look.x, -look.y, -look.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto wall = vtkSmartPointer<vtkActor>::New();
  wall->SetMapper(mapper);
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(grey, grey, grey);
  return wall;
}
}

TEST_F(GodRaysSkyPass, TheAirBeforeASceneIsTheIntegral)
{
  const double grey = 0.2;
  const double behind = vtkGodRays::DecodeDisplay(grey);
  for (const int preset : { Atmosphere::EARTH_CLEAR, Atmosphere::EARTH_HAZY })
  {
    this->Sky->GetAtmosphere()->LoadPreset(preset);
    double thinnest = 1.0;
    for (const double height : { 2.0, 1500.0, 12e3 })
    {
      double worst = 0.0;
      for (const double sun : { 40.0, 4.0, -2.0 }) // first, as each needs its tables
      {
        this->SetSun(sun);
        for (const double distance : { 300.0, 3e3, 30e3, 150e3 })
        {
          for (const double azimuth : { 180.0, 60.0 })
          {
            this->SetView(height, azimuth, 1.0, 30.0);
            const auto wall =
              MakeWall(this->Eye + distance * this->Look, this->Look, 2.0 * distance, grey);
            this->Renderer->RemoveAllViewProps();
            this->Renderer->AddActor(wall);
            this->Renderer->GetActiveCamera()->SetClippingRange(0.5 * distance, 2.0 * distance);
            this->Render();
            const Vec3 towards = GetDirection(180.0, sun);
            double brightest = 0.0;
            double error = 0.0;
            for (int y = 2; y < Size; y += 6)
            {
              for (int x = 2; x < Size; x += 9)
              {
                const Vec3 ray = this->GetRay(x, y);
                const double reach = distance / dot(ray, this->Look);
                const double ground = vtkGodRays::SkyGroundDistance(EarthRadius, height, ray.z);
                if (ground >= 0.0 && ground < reach)
                {
                  continue;
                }
                Vec3 light;
                Vec3 left;
                IntegrateAir(this->Sky->GetAtmosphere(), height, ray, towards, reach, light, left);
                const Vec3 truth = light + behind * left;
                brightest = std::max(brightest, GetBrightest(truth));
                error = std::max(error, GetBrightest(abs(this->Seen[y * Size + x] - truth)));
                thinnest = std::min(thinnest, left.z);
              }
            }
            worst = std::max(worst, error / brightest);
          }
        }
      }
      std::cout << "preset " << preset << ", " << height << " m: " << worst
                << " of the brightest\n";
      // from high up, ways dip into dense air and out of it
      EXPECT_LT(worst, height < 10e3 ? 0.01 : 0.045) << preset << " " << height;
    }
    EXPECT_LT(thinnest, 0.1) << "the air is thin everywhere";
  }
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, LeavesDepthAndThinAirAlone)
{
  const auto wall = MakeWall(Vec3(0.0, -50.0, 10.0), Vec3(0.0, -1.0, 0.0), 30.0, 0.4);
  this->Renderer->AddActor(wall);
  this->Renderer->SetPass(nullptr);
  this->Renderer->GetActiveCamera()->SetClippingRange(10.0, 100.0);
  const auto depths = GetDepths(this->Window);
  const auto plain = GetPixels(this->Window);
  this->Renderer->SetPass(this->Sky);
  for (const bool thick : { false, true })
  {
    this->Sky->SetWorldUnitInMeters(thick ? 1000.0 : 0.01);
    EXPECT_EQ(depths, GetDepths(this->Window));
    EXPECT_EQ(Says(this->Sky->GetPlan(), "air: none, it is too little"), !thick);
    const auto pixels = GetPixels(this->Window);
    int sky = 0;
    int changed = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      const bool same = std::equal(&plain[4 * i], &plain[4 * i + 3], &pixels[4 * i]);
      sky += depths[i] == 1.0f && !same;
      changed += depths[i] < 1.0f && !same;
    }
    EXPECT_GT(sky, 500);
    EXPECT_EQ(changed > 500, thick) << changed;
  }
}

TEST_F(GodRaysSkyPass, IsBehindWhatIsTranslucent)
{
  const auto veil = MakeWall(Vec3(0.0, -50.0, 20.0), Vec3(0.0, -1.0, 0.0), 200.0, 0.0);
  this->Sky->AerialPerspectiveOff();
  this->Sky->SetExposure(4.0);
  this->Renderer->SetPass(this->Sky);
  const auto open = GetPixels(this->Window);
  this->Renderer->AddActor(veil);
  veil->GetProperty()->SetOpacity(0.5);
  const auto veiled = GetPixels(this->Window);
  const int upper = 4 * (40 * Size + 24);
  ASSERT_GT(open[upper + 2], 50);
  EXPECT_NEAR(veiled[upper + 2], 0.5 * open[upper + 2], 2.5);

  vtkNew<vtkGodRaysSkyPass>
    outer; // the sky of a delegate is drawn after it, and replaces what it covers
  outer->SetExposure(4.0);
  outer->WhiteBalanceOff();
  outer->SetSunElevation(30.0);
  this->Sky->SetExposure(0.0);
  outer->SetDelegatePass(this->Sky);
  outer->MultipleScatteringOff();
  outer->SunDiscOff();
  this->Renderer->SetPass(outer);
  EXPECT_EQ(GetPixels(this->Window)[upper + 2], open[upper + 2]);
}

TEST_F(GodRaysSkyPass, LeavesSelectionsAlone)
{
  const auto wall = MakeWall(Vec3(0.0, -50.0, 10.0), Vec3(0.0, -1.0, 0.0), 30.0, 0.4);
  this->Renderer->AddActor(wall);
  this->Renderer->SetPass(this->Sky);
  this->Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  EXPECT_EQ(selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()), wall);
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: none, a hardware selection is made"));
}

//------------------------------------------------------------------------------
TEST_F(GodRaysSkyPass, MakesNothingWithoutCause)
{
  this->Renderer->AddActor(MakeWall(Vec3(0.0, -5e3, 0.0), Vec3(0.0, -1.0, 0.0), 3e3, 0.4));
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 2);
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: a new table, as there was none"));
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 60.0)
  {
    this->SetView(2.0, azimuth, 5.0, 50.0);
    this->Sky->SetSunAzimuth(azimuth / 3.0);
    this->Sky->SetExposure(1.0 + azimuth);
    this->Render();
    EXPECT_TRUE(Says(this->Sky->GetPlan(), "sky: the table is kept"));
  }
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 2);
  this->SetView(180.0, 180.0, 5.0, 50.0);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the observer's height changed"));
  this->SetSun(10.0);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the sun's elevation changed"));
  this->Sky->GetAtmosphere()->SetMieAsymmetry(0.7);
  this->Render();
  EXPECT_TRUE(Says(this->Sky->GetPlan(), "as the atmosphere changed"));
  this->SetMultipleScattering(true);
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 10);
  this->Sky->ReleaseGraphicsResources(this->Window);
  const auto before = this->Seen;
  this->Render();
  EXPECT_EQ(this->Sky->GetNumberOfTables(), 12);
  EXPECT_EQ(before, this->Seen);
}

//------------------------------------------------------------------------------
// Hills in haze before a low sun, in the colours of that sun.
TEST_F(GodRaysSkyPass, MakesAPicture)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(320, 200);
  window->AddRenderer(renderer);
  this->SetView(300.0, 154.0, 5.0, 40.0);
  renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> sun;
  renderer->AddLight(sun);
  const double distances[] = { 3e3, 7e3, 14e3, 28e3, 56e3 };
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkConeSource> hill;
    const double distance = distances[i / 4];
    const double turn = 40.0 * (i % 4 + 0.37 * (i * i % 3)) - 90.0;
    const double height = 300.0 + distance * (0.04 + 0.02 * (i * 7 % 5) / 4.0);
    const Vec3 place = distance * GetDirection(154.0 + 0.4 * turn, 0.0);
    hill->SetResolution(7);
    hill->SetDirection(0.0, 0.0, 1.0);
    hill->SetHeight(height);
    hill->SetRadius(3.0 * height);
    hill->SetCenter(place.x, place.y, 0.5 * height);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(hill->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.35, 0.4, 0.3);
    renderer->AddActor(actor);
  }
  renderer->ResetCameraClippingRange();
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->GetAtmosphere()->LoadPreset(Atmosphere::EARTH_HAZY);
  sky->SetSunElevation(8.0);
  sky->SetExposure(1.5);
  sky->UpdateLight(sun);
  const auto pixels = GetPixels(window);
  EXPECT_TRUE(IsLikeBaseline(window, "GodRaysSkyPass"));
  const auto get = [&pixels](int x, int y) { return &pixels[4 * (320 * y + x)]; };
  EXPECT_GT(get(5, 195)[2], get(5, 195)[0] + 8) << "away from the sun the sky is blue";
  EXPECT_GT(get(270, 100)[0], get(270, 100)[2] + 30) << "below the sun it is yellow";
  EXPECT_GT(get(290, 40)[0], get(30, 40)[0] + 60) << "hills are bright before the sun";
  sky->AerialPerspectiveOff();
  GetPixels(window);
  EXPECT_FALSE(IsLikeBaseline(window, "GodRaysSkyPass", 2, true));
}

// Steps of bytes are hidden in the sky and in the air before a scene: means of 8 x 8 pixels are exact.
TEST_F(GodRaysSkyPass, HidesTheStepsOfBytes)
{
  constexpr int size = 8 * Size;
  this->Window->SetSize(size, size);
  for (const bool hasScene : { false, true })
  {
    this->SetView(300.0, 120.0, hasScene ? -2.0 : 12.0, 20.0);
    this->Sky->SetExposure(1.5);
    if (hasScene)
    {
      this->Renderer->AddActor(
        MakeWall(this->Eye + 2e4 * this->Look, GetDirection(60.0, 0.0), 1e5, 0.2));
      this->Renderer->GetActiveCamera()->SetClippingRange(1e3, 1e5);
    }
    this->Renderer->SetPass(this->Floats);
    this->Window->Render();
    std::vector<float> light(4 * size * size);
    auto buffer =
      vtk::TakeSmartPointer<vtkPixelBufferObject>(this->Floats->GetColorTexture()->Download());
    unsigned int sizes[2] = { size, size };
    vtkIdType increments[2] = { 0, 0 };
    EXPECT_TRUE(buffer->Download2D(VTK_FLOAT, light.data(), sizes, 4, increments));
    this->Floats->ReleaseGraphicsResources(this->Window);
    this->Renderer->SetPass(this->Sky);
    double worst[2] = { 0.0, 0.0 }; // error of a mean [levels]: rounded, and with noise
    int widest[2] = { 0, 0 };       // band of one value along a column [pixels]
    for (const bool dithers : { false, true })
    {
      this->Sky->SetDithering(dithers);
      const auto shown = GetPixels(this->Window);
      std::vector<double> sums(3 * Size * Size);
      std::vector<int> runs(4 * size);
      for (std::size_t i = 0; i < light.size(); ++i)
      {
        if (i % 4 == 3)
        {
          continue;
        }
        const double error = shown[i] - 255.0 * std::clamp(light[i], 0.0f, 1.0f);
        ASSERT_LE(std::abs(error), dithers ? 1.0 : 0.51);
        const std::size_t x = i / 4 % size;
        const std::size_t y = i / 4 / size;
        sums[3 * (y / 8 * Size + x / 8) + i % 4] += error / 64.0;
        int& run = runs[i % (4 * size)];
        run = y > 0 && shown[i] == shown[i - 4 * size] ? run + 1 : 1;
        widest[dithers] = std::max(widest[dithers], run);
      }
      for (const double sum : sums)
      {
        worst[dithers] = std::max(worst[dithers], std::abs(sum));
      }
    }
    std::cout << (hasScene ? "air" : "sky") << ": means are off by " << worst[0]
              << " levels by rounding, " << worst[1] << " with noise; widest band " << widest[0]
              << " and " << widest[1] << " pixels\n";
    EXPECT_LT(worst[1], 0.12);
    EXPECT_GT(worst[0], 4.0 * worst[1]);
  }
}

TEST_F(GodRaysSkyPass, IsInItsViewportAlone)
{
  this->Renderer->SetPass(this->Sky);
  const auto alone = GetPixels(this->Window);
  vtkNew<vtkRenderer> other;
  other->SetActiveCamera(this->Renderer->GetActiveCamera());
  other->SetViewport(0.0, 0.0, 0.5, 0.5);
  other->SetBackground(0.2, 0.4, 0.6);
  this->Window->AddRenderer(other);
  this->Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  this->Window->SetSize(2 * Size, 2 * Size);
  const auto both = GetPixels(this->Window);
  for (int y = 0; y < 2 * Size; ++y)
  {
    for (int x = 0; x < 2 * Size; ++x)
    {
      const unsigned char* pixel = &both[4 * (2 * y * Size + x)];
      if (x >= Size && y >= Size)
      {
        ASSERT_TRUE(std::equal(pixel, pixel + 3, &alone[4 * ((y - Size) * Size + x - Size)]));
      }
      else
      {
        ASSERT_TRUE(x < Size && y < Size ? pixel[0] == 51 : pixel[0] == 0) << x << " " << y;
      }
    }
  }
  vtkGodRaysSkyPass::Attach(other)->SetSunElevation(5.0);
  const auto skies = GetPixels(this->Window);
  EXPECT_TRUE(std::equal(&skies[4 * (3 * Size * Size + Size)],
    &skies[4 * (3 * Size * Size + 2 * Size)], &both[4 * (3 * Size * Size + Size)]))
    << "two skies do not meet";
  EXPECT_NE(skies[4 * (Size * Size + 10)], 51);
}

TEST_F(GodRaysSkyPass, IsOneColourInAParallelProjection)
{
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  const Vec3 truth = this->GetTruth(this->Look);
  for (const Vec3& seen : this->Render())
  {
    EXPECT_LT(GetBrightest(abs(seen - truth)), 0.002 * GetBrightest(truth));
  }
}

TEST_F(GodRaysSkyPass, SaysWhatIsWrong)
{
  this->Sky->SetSunElevation(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(this->Sky->GetSunElevation(), 30.0);
  this->Sky->SetUp(0.0, 0.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(this->Said.Take().size(), 2u);

  this->Renderer->SetBackground(1.0, 0.0, 0.0);
  const auto isPlain = [this] { return this->Render()[0] == Vec3(1.0, 0.0, 0.0); };
  EXPECT_FALSE(isPlain());
  this->Sky->GetAtmosphere()->SetMieScattering(-1.0, 0.0, 0.0);
  EXPECT_TRUE(isPlain());
  EXPECT_TRUE(isPlain());
  auto said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without sky: a coefficient of the atmosphere is out of range. Set"));
  EXPECT_EQ(this->Sky->GetEnvironmentTexture(), nullptr);
  this->Said.Take();

  this->Sky->GetAtmosphere()->LoadPreset(Atmosphere::EARTH_CLEAR);
  EXPECT_FALSE(isPlain());
  this->Sky->SetNorth(0.0, 0.0, 3.0);
  EXPECT_TRUE(isPlain());
  said = this->Said.Take();
  ASSERT_FALSE(said.empty());
  EXPECT_TRUE(Says(said.back(), "Up and North")) << said.back();
  this->Sky->SetNorth(0.0, 1.0, 0.0);

  this->Sky->SetDelegatePass(this->Sky);
  this->Render();
  said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without the delegate of this pass: it leads back")) << said[0];
  this->Sky->SetDelegatePass(nullptr);

  // A tilted picture has a sky, but no air before the scene.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  this->Renderer->AddActor(MakeWall(1e3 * this->Look, this->Look, 100.0, 0.4));
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0));
  projection->SetElement(0, 1, 0.3);
  camera->UseExplicitProjectionTransformMatrixOn();
  camera->SetExplicitProjectionTransformMatrix(projection);
  this->Renderer->SetPass(this->Sky); // the other pass has a camera without the matrix
  EXPECT_NE(GetPixels(this->Window)[2], 0) << "the background has no blue";
  GetPixels(this->Window);
  said = this->Said.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "without the air before it: the picture is tilted")) << said[0];
  this->Renderer->SetPass(this->Floats); // which wants to be released
}
