// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysOcclusionPass: what the layer of a vtkLight holds, pixel by pixel: its disc, the glow
// about it, lights of every kind, several of them, and extreme intensities.

#include "GodRaysOcclusionTesting.h"

#include "vtkGodRaysMath.h"

#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

#include <limits>

using namespace GodRaysTesting;

namespace
{
/// Where the centre of a pixel meets the plane at distance 1, the stage's camera looking along -z.
std::array<double, 3> GetPixelRay(vtkRenderer* renderer, double x, double y)
{
  const double pixel = 2.0 * GetTangent(renderer) / Height;
  return { pixel * (x + 0.5 - 0.5 * Width), pixel * (y + 0.5 - 0.5 * Height), -1.0 };
}

double GetAngle(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return vtkMath::AngleBetweenVectors(a.data(), b.data());
}

/// Solid angle of what shines, and the mean direction to it (scaled to z = -1).
double GetSolidAngle(
  vtkImageData* layer, vtkRenderer* renderer, std::array<double, 3>& direction, int channel = 0)
{
  const double pixel = 2.0 * GetTangent(renderer) / Height;
  double sum = 0.0;
  direction = { 0.0, 0.0, 0.0 };
  ForEachPixel(layer,
    [&](int x, int y)
    {
      std::array<double, 3> ray = GetPixelRay(renderer, x, y);
      const double length = vtkMath::Normalize(ray.data());
      const double part =
        GetValue(layer, x, y, channel) * pixel * pixel / (length * length * length);
      sum += part;
      for (int i = 0; i < 3; ++i)
      {
        direction[i] += part * ray[i];
      }
    });
  for (double& component : direction)
  {
    component /= std::abs(direction[2]);
  }
  return sum;
}

double GetSolidAngleOfDisc(double radius)
{
  return 2.0 * vtkMath::Pi() * (1.0 - std::cos(radius));
}
}

//------------------------------------------------------------------------------
// Discs

TEST_F(GodRaysOcclusion, TheDiscOfASunHasItsPlaceAndSolidAngle)
{
  const double radius = 2.0;
  this->Rays->SetSunAngularRadius(radius);
  double worst = 0.0;
  for (double viewAngle : { 12.0, 40.0, 90.0 })
  {
    this->Renderer->GetActiveCamera()->SetViewAngle(viewAngle);
    const double tangent = GetTangent(this->Renderer);
    for (const auto& place : { std::array<double, 2>{ 0.0, 0.0 }, { 0.5, -0.3 }, { -0.7, 0.61 } })
    {
      SCOPED_TRACE(testing::Message() << "view angle " << viewAngle << " at " << place[0]);
      const std::array<double, 3> towards = { place[0] * tangent, place[1] * tangent, -1.0 };
      this->Rays->RemoveAllLights();
      this->AddSun(towards);
      auto layer = this->GetLayer();
      std::array<double, 3> found;
      const double expected = GetSolidAngleOfDisc(vtkMath::RadiansFromDegrees(radius));
      const double area = GetSolidAngle(layer, this->Renderer, found);
      worst = std::max(worst, std::abs(area / expected - 1.0));
      EXPECT_NEAR(area / expected, 1.0, 0.025);
      EXPECT_LT(GetAngle(found, towards) * 0.5 * Height / tangent, 0.1) << "pixels";
      // 1 well inside, 0 well outside
      const double pixel = 2.0 * tangent / Height;
      ForEachPixel(layer,
        [&](int x, int y)
        {
          const double separation = GetAngle(GetPixelRay(this->Renderer, x, y), towards);
          const double inside = vtkMath::RadiansFromDegrees(radius) - separation;
          if (std::abs(inside) > pixel)
          {
            ASSERT_NEAR(GetValue(layer, x, y), inside > 0.0 ? 1.0 : 0.0, 1e-6) << x << ", " << y;
          }
        });
    }
  }
  std::cout << "largest error of a disc's solid angle: " << worst << "\n";
}

TEST_F(GodRaysOcclusion, ASunBelowAPixelKeepsItsEnergy)
{
  this->Rays->SetSunAngularRadius(0.05); // a pixel is 0.4 degrees
  const double expected = GetSolidAngleOfDisc(vtkMath::RadiansFromDegrees(0.05));
  for (int step = 0; step < 8; ++step)
  {
    const double pixel = 2.0 * GetTangent(this->Renderer) / Height;
    this->Rays->RemoveAllLights();
    this->AddSun({ (5.0 + step / 8.0) * pixel, (3.0 - step / 5.0) * pixel, -1.0 });
    std::array<double, 3> found;
    EXPECT_NEAR(GetSolidAngle(this->GetLayer(), this->Renderer, found) / expected, 1.0, 0.025);
  }
}

TEST_F(GodRaysOcclusion, WhereThereAreOpaquePropsTheLayerOfASunIsZero)
{
  this->AddBox({ -1.0, 0.5, 0.0 }, { 1.5, 2.0, 1.0 });
  this->AddBox({ 2.0, -1.0, -60.0 }, { 9.0, 9.0, 9.0 });
  this->AddSun({ -0.06, 0.05, -1.0 });
  this->Rays->SetSunAngularRadius(6.0);
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetBackgroundGlowRadius(90.0);
  const auto depths = this->GetSceneDepths();
  auto layer = this->GetLayer();
  int dark = 0;
  int lit = 0;
  ForEachPixel(layer,
    [&](int x, int y)
    {
      const bool open = depths[y * Width + x] == 1.0f;
      EXPECT_EQ(GetValue(layer, x, y) > 0.0, open) << x << ", " << y;
      ++(open ? lit : dark);
    });
  EXPECT_GT(dark, 500);
  EXPECT_GT(lit, 500);
}

TEST_F(GodRaysOcclusion, ALampIsHiddenByWhatIsBeforeItAndSeenBeforeWhatIsBehind)
{
  const std::array<double, 3> position = { 1.0, 0.5, -3.0 };
  const std::array<double, 3> towards = { 1.0, 0.5, -13.0 };
  auto light = MakeLamplight(position);
  this->Rays->AddLight(light);
  this->Rays->SetSourceRadius(0.7);
  const double expected = GetSolidAngleOfDisc(std::asin(0.7 / vtkMath::Norm(towards.data())));
  std::array<double, 3> found;
  EXPECT_NEAR(GetSolidAngle(this->GetLayer(), this->Renderer, found) / expected, 1.0, 0.025);
  EXPECT_LT(GetAngle(found, towards), 0.001);

  auto open = this->GetLayer();
  auto behind = this->AddBox({ 0.0, 0.0, -5.0 }, { 8.0, 8.0, 1.0 });
  EXPECT_EQ(GetLargestDifference(open, this->GetLayer()), 0.0);

  auto before = this->AddBox({ 2.0, 0.0, 0.0 }, { 2.6, 8.0, 1.0 });
  auto covered = this->GetLayer();
  this->Renderer->RemoveActor(behind);
  const auto depths = this->GetSceneDepths();
  int hidden = 0;
  int seen = 0;
  ForEachPixel(covered,
    [&](int x, int y)
    {
      const bool free = depths[y * Width + x] == 1.0f;
      EXPECT_EQ(GetValue(covered, x, y), free ? GetValue(open, x, y) : 0.0);
      ++(free ? seen : hidden);
    });
  EXPECT_GT(GetSum(covered), 0.1 * GetSum(open));
  EXPECT_LT(GetSum(covered), 0.9 * GetSum(open));
}

TEST_F(GodRaysOcclusion, InAParallelProjectionADiscIsALengthAndASunIsEverywhereOrNowhere)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.0);
  const double pixel = 6.0 / Height;
  auto box = this->AddBox({ -2.0, -1.0, 0.0 }, { 1.4, 1.4, 1.0 });
  auto lamp = MakeLamplight({ 1.1, 0.7, -3.0 });
  this->Rays->AddLight(lamp);
  this->Rays->SetSourceRadius(0.5);
  auto layer = this->GetLayer();
  EXPECT_NEAR(GetSum(layer) * pixel * pixel / (vtkMath::Pi() * 0.25), 1.0, 0.025);
  double center[2] = { 0.0, 0.0 };
  ForEachPixel(layer,
    [&](int x, int y)
    {
      center[0] += GetValue(layer, x, y) * pixel * (x + 0.5 - 0.5 * Width);
      center[1] += GetValue(layer, x, y) * pixel * (y + 0.5 - 0.5 * Height);
    });
  EXPECT_NEAR(center[0] / GetSum(layer), 1.1, 0.1 * pixel);
  EXPECT_NEAR(center[1] / GetSum(layer), 0.7, 0.1 * pixel);

  box->SetPosition(3.1, 1.7, 0.0); // before the lamp
  EXPECT_LT(GetSum(this->GetLayer()), 1e-6);
  box->SetPosition(0.0, 0.0, 0.0);

  this->Rays->RemoveAllLights();
  auto sun = this->AddSun({ 0.0, 0.0, -1.0 }); // straight behind: all lines of sight end in it
  const auto depths = this->GetSceneDepths();
  layer = this->GetLayer();
  ForEachPixel(layer,
    [&](int x, int y)
    { EXPECT_NEAR(GetValue(layer, x, y), depths[y * Width + x] == 1.0f ? 1.0 : 0.0, 1e-6); });
  sun->SetPosition(0.1, 0.0, -1.0);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "neither it nor its glow"));
  this->VTKMessages.Expect("no light reaches the picture (neither it nor its glow");
}

//------------------------------------------------------------------------------
// Glow

TEST_F(GodRaysOcclusion, GlowFollowsItsAnglesOnTheOpenBackgroundOnly)
{
  this->AddBox({ -1.5, 0.0, 0.0 }, { 0.7, 9.0, 0.7 });
  const std::array<double, 3> towards = { 0.1, 0.05, -1.0 };
  this->AddSun(towards, { 1.0, 0.7, 0.4 });
  this->Rays->SetSunAngularRadius(1.0);
  const auto depths = this->GetSceneDepths();
  const double degree = vtkMath::RadiansFromDegrees(1.0);
  const double pixel = 2.0 * GetTangent(this->Renderer) / Height;
  double worst = 0.0;
  for (const auto& numbers : { std::array<double, 3>{ 0.5, 2.0, 25.0 }, { 1.0, 3.0, 8.0 },
         { 0.25, 6.0, 0.0 }, { 0.0, 10.0, 10.0 } })
  {
    SCOPED_TRACE(testing::Message() << "glow " << numbers[0]);
    this->Rays->SetBackgroundGlow(numbers[0]);
    this->Rays->SetBackgroundGlowRadius(numbers[1]);
    this->Rays->SetBackgroundGlowFalloff(numbers[2]);
    auto layer = this->GetLayer();
    ForEachPixel(layer,
      [&](int x, int y)
      {
        const double separation = GetAngle(GetPixelRay(this->Renderer, x, y), towards);
        const bool nearAnEdge = std::abs(separation - degree) < pixel ||
          (numbers[2] == 0.0 && std::abs(separation - numbers[1] * degree) < 1e-4);
        if (nearAnEdge)
        {
          return;
        }
        double expected = separation < degree ? 1.0
                                              : numbers[0] *
            vtkGodRays::GlowFalloff(separation, numbers[1] * degree, numbers[2] * degree);
        expected *= depths[y * Width + x] == 1.0f ? 1.0 : 0.0;
        // GLSL's atan is good for some 2e-6 radians; the falloff is 1.5/width steep
        const double allowed =
          1e-6 + 2e-6 * (numbers[2] > 0.0 ? 1.5 * numbers[0] / (numbers[2] * degree) : 0.0);
        worst = std::max(worst, std::abs(GetValue(layer, x, y, 0) - expected) / allowed);
        EXPECT_NEAR(GetValue(layer, x, y, 0), expected, allowed) << x << ", " << y;
        EXPECT_NEAR(GetValue(layer, x, y, 2), expected * vtkGodRays::DecodeDisplay(0.4), allowed);
      });
  }
  std::cout << "largest error of the glow, of what 2e-6 radians allow: " << worst << "\n";
}

TEST_F(GodRaysOcclusion, InAParallelProjectionThePicturesHeightCountsAs30Degrees)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.0);
  this->Rays->AddLight(MakeLamplight({ 1.0, -0.5, -3.0 }));
  this->Rays->SetSourceRadius(0.3);
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetBackgroundGlowRadius(4.0);
  this->Rays->SetBackgroundGlowFalloff(12.0);
  for (double margin : { 0.0, 0.25 })
  {
    this->Rays->SetLayerMargin(margin);
    auto layer = this->GetLayer();
    const int* size = layer->GetDimensions();
    const double pixel = 6.0 / Height;
    ForEachPixel(layer,
      [&](int x, int y)
      {
        const double separation = std::hypot(
          pixel * (x + 0.5 - 0.5 * size[0]) - 1.0, pixel * (y + 0.5 - 0.5 * size[1]) + 0.5);
        if (separation > 0.3 + pixel)
        {
          EXPECT_NEAR(GetValue(layer, x, y),
            0.5 * vtkGodRays::GlowFalloff(separation, 4.0 * 6.0 / 30.0, 12.0 * 6.0 / 30.0), 1e-5);
        }
      });
  }
}

//------------------------------------------------------------------------------
// Several lights

TEST_F(GodRaysOcclusion, SeveralLightsAdd)
{
  for (int i = -2; i <= 2; ++i)
  {
    this->AddBox({ 1.3 * i, 0.0, 0.0 }, { 0.5, 3.0, 0.5 });
  }
  this->Rays->SetBackgroundGlow(0.3);
  vtkSmartPointer<vtkLight> lights[] = { MakeSun({ 0.2, 0.1, -1.0 }, { 1.0, 0.3, 0.3 }),
    MakeSun({ -0.2, 0.2, -1.0 }, { 0.2, 1.0, 0.2 }),
    MakeLamplight({ -1.0, -1.0, -3.0 }, { 0.4, 0.4, 1.0 }) };
  lights[1]->SetIntensity(2.5);
  vtkSmartPointer<vtkImageData> layers[3];
  vtkSmartPointer<vtkImageData> scatterings[3];
  for (int i = 0; i < 3; ++i)
  {
    this->Rays->RemoveAllLights();
    this->Rays->AddLight(lights[i]);
    layers[i] = this->GetLayer();
    scatterings[i] = this->GetScattering();
  }
  for (vtkLight* light : lights)
  {
    this->Rays->AddLight(light);
  }
  auto layer = this->GetLayer(); // after a COMPOSITE frame
  auto scattering = this->GetScattering();
  this->Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
  auto shownLayer = this->GetLayer();
  EXPECT_EQ(GetLargestDifference(layer, shownLayer), 0.0);
  ForEachPixel(layer,
    [&](int x, int y)
    {
      for (int c = 0; c < 3; ++c)
      {
        double sums[2] = { 0.0, 0.0 };
        for (int i = 0; i < 3; ++i)
        {
          sums[0] += GetValue(layers[i], x, y, c);
          sums[1] += GetValue(scatterings[i], x, y, c);
        }
        EXPECT_NEAR(GetValue(layer, x, y, c), sums[0], 1e-6);
        EXPECT_NEAR(GetValue(scattering, x, y, c), sums[1], 1e-6);
      }
    });
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_GT(GetSum(layer, c), 10.0);
    EXPECT_GT(GetSum(scattering, c), 1.0);
  }
}

//------------------------------------------------------------------------------
// Kinds of lights

TEST_F(GodRaysOcclusion, LightsOfEveryKindAreWhereVTKHasThem)
{
  this->Rays->SetSourceRadius(0.5);
  const auto expect = [&](std::array<double, 3> towards)
  {
    std::array<double, 3> found;
    EXPECT_GT(GetSolidAngle(this->GetLayer(), this->Renderer, found), 0.0);
    EXPECT_LT(GetAngle(found, towards), 0.001) << found[0] << ", " << found[1];
  };
  // camera lights: in coordinates in which the eye is at (0, 0, 1) and looks at the origin, at the
  // distance from the eye to the focal point; not in the renderer's list, so nobody else moves them
  auto light = MakeLamplight({ 0.1, 0.05, -0.2 });
  light->SetLightTypeToCameraLight();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Rays->AddLight(light);
  expect({ 1.0, 0.5, -12.0 });
  light->PositionalOff();
  this->Rays->SetSunAngularRadius(1.0);
  light->SetPosition(0.1, 0.05, -1.0);
  expect({ 0.1, 0.05, -1.0 });

  // after the camera has turned they turn with it
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(10.0, 0.0, 0.0);
  expect({ 0.1, 0.05, -1.0 }); // in the picture
  camera->SetPosition(0.0, 0.0, 10.0);

  // scene lights with a transform
  light->SetLightTypeToSceneLight();
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, -0.5, 0.0);
  transform->RotateX(180.0);
  light->SetTransformMatrix(transform->GetMatrix());
  light->PositionalOn();
  light->SetPosition(0.2, -1.0, 3.0); // becomes (1.2, 0.5, -3)
  expect({ 1.2, 0.5, -13.0 });
  light->PositionalOff();
  light->SetPosition(0.1, -0.05, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  expect({ 0.1, 0.05, -1.0 });

  // headlights are at the eye: behind everything that they light
  light->SetTransformMatrix(nullptr);
  light->SetLightTypeToHeadlight();
  light->SetPosition(0.1, 0.05, -1.0); // which does not count
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "behind the camera")) << this->Rays->GetPlan();
  this->VTKMessages.Expect("no light reaches the picture (behind the camera)");
}

//------------------------------------------------------------------------------
// Extremes

TEST_F(GodRaysOcclusion, IntensitiesBeyondTheDisplaySurviveToTheLimitOfTheLayer)
{
  this->AddBox({ 0.0, 0.0, 0.0 }, { 0.2, 4.0, 0.2 });
  auto sun = this->AddSun({ 0.1, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  this->Rays->SetPrecision(vtkGodRaysPass::HALF);
  const auto greatest = [&](vtkImageData* image)
  {
    double value = 0.0;
    ForEachPixel(image, [&](int x, int y) { value = std::max(value, GetValue(image, x, y)); });
    return value;
  };
  for (double intensity : { 1.0, 50.0, 6e4 })
  {
    sun->SetIntensity(intensity);
    EXPECT_NEAR(greatest(this->GetLayer()) / intensity, 1.0, 5e-4);
    const double brightest = greatest(this->GetScattering());
    EXPECT_GT(brightest, 0.3 * intensity);
    EXPECT_TRUE(std::isfinite(brightest));
  }
  sun->SetIntensity(1e9);
  EXPECT_NEAR(greatest(this->GetLayer()) / 1e9, 1.0, 1e-6); // whose colour is not in the layer
  SumTaps(this->Rays);
  EXPECT_EQ(greatest(this->GetLayer()), 65504.0); // of a layer that holds colours
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  EXPECT_NEAR(greatest(this->GetLayer()) / 1e9, 1.0, 1e-6);
}

TEST_F(GodRaysOcclusion, ColorsThatAreNoNumbersDoNoHarm)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->AddBox({ 0.0, 0.0, 0.0 }, { 0.2, 4.0, 0.2 });
  auto sun = this->AddSun({ 0.1, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  this->Rays->SetBackgroundGlow(0.5);
  sun->SetDiffuseColor(0.0, 1.0, 0.0);
  EXPECT_GT(GetSum(this->GetScattering(), 1), 1.0);
  for (int channels = 1; channels <= 3; ++channels)
  {
    sun->SetDiffuseColor(nan, channels > 1 ? nan : 1.0, channels > 2 ? nan : -1.0);
    this->Scene.Window->Render();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "its DiffuseColor is not finite"))
      << this->Rays->GetPlan();
  }
  EXPECT_EQ(this->VTKMessages.Take().size(), 1u);
  sun->SetDiffuseColor(1.0, 1.0, 1.0);
  sun->SetPosition(nan, 0.0, -1.0);
  this->Scene.Window->Render();
  EXPECT_EQ(this->VTKMessages.Take().size(), 1u);
  const auto pixels = GetPixels(this->Scene.Window);
  this->Rays->SetIntensity(0.0);
  EXPECT_EQ(pixels, GetPixels(this->Scene.Window)) << "a light that is nowhere makes no rays";
}
