// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Models of a medium in the pass: the light that they scatter against closed forms and against the
// ground truth of vtkGodRaysSingleScatteringReference, the scene that they dim, roles, cameras.

#include "GodRaysMediumTesting.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>
#include <random>

using namespace GodRaysTesting;

namespace
{
constexpr int Width = MediumTest::Width;
constexpr int Height = MediumTest::Height;

class GodRaysMedium : public MediumTest
{
};
}

TEST_F(GodRaysMedium, ChoosesItsOwnIntegratorUnlessOneIsSet)
{
  EXPECT_TRUE(vtkGodRaysShadowMapIntegrator::SafeDownCast(this->Rays->GetIntegrator()));
  this->Rays->SetModel(nullptr);
  EXPECT_TRUE(vtkGodRaysEpipolarIntegrator::SafeDownCast(this->Rays->GetIntegrator()));
  vtkNew<vtkGodRaysEpipolarIntegrator> mine;
  this->Rays->SetIntegrator(mine);
  this->Rays->SetModel(this->Model);
  EXPECT_EQ(this->Rays->GetIntegrator(), mine.Get());
  this->AddSun({ 0.0, 1.0, 0.0 });
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->VTKMessages.Take().at(0), "cannot evaluate"));
  this->Rays->SetIntegrator(nullptr);
  EXPECT_TRUE(vtkGodRaysShadowMapIntegrator::SafeDownCast(this->Rays->GetIntegrator()));
}

// Nothing blocks, so that a closed form holds in each pixel; view rays are those of GetClip().
TEST_F(GodRaysMedium, IsTheClosedFormWithoutOccluders)
{
  this->Model->SetScatteringCoefficient(0.05, 0.02, 0.2);
  this->Model->SetAbsorptionCoefficient(0.0, 0.01, 0.1);
  for (const std::array<double, 3>& towards :
    { std::array<double, 3>{ 0.3, 0.2, -1.0 }, { 1.0, 0.5, 0.0 }, { 0.2, -0.1, 1.0 } })
  {
    this->Rays->RemoveAllLights();
    this->AddSun(towards, { 1.0, 0.5, 0.2 });
    auto image = this->GetScattering();
    double direction[3] = { towards[0], towards[1], towards[2] };
    vtkMath::Normalize(direction);
    const double tangent = std::tan(vtkMath::RadiansFromDegrees(20.0));
    double worst = 0.0;
    for (int y = 0; y < Height; y += 7)
    {
      for (int x = 0; x < Width; x += 7)
      {
        double ray[3] = { (2.0 * (x + 0.5) / Width - 1.0) * tangent * Width / Height,
          (2.0 * (y + 0.5) / Height - 1.0) * tangent, -1.0 };
        const double perDepth = vtkMath::Normalize(ray);
        const double shown[3] = { 1.0, 0.5, 0.2 };
        for (int c = 0; c < 3; ++c)
        {
          const double scattering = this->Model->GetScatteringCoefficient()[c];
          const double extinction = scattering + this->Model->GetAbsorptionCoefficient()[c];
          const double expected = vtkMath::Pi() * vtkGodRays::DecodeDisplay(shown[c]) * scattering *
            vtkGodRays::PhaseHenyeyGreenstein(vtkMath::Dot(ray, direction), 0.6) *
            vtkGodRays::DirectionalAirlight(extinction, 0.0, 30.0 * perDepth, 0.0, 0.0);
          worst = std::max(worst, std::abs(GetValue(image, x, y, c) / expected - 1.0));
        }
      }
    }
    std::cout << "largest relative error " << worst << "\n";
    EXPECT_LT(worst, 1e-4);
  }
}

TEST_F(GodRaysMedium, IsTheGroundTruthWithOccluders)
{
  this->AddPillars();
  struct Case
  {
    const char* Name;
    std::array<double, 3> Towards;
    double Bound; // [root mean square over the peak]
  };
  for (const Case& each :
    { Case{ "front", { 0.15, 0.1, -1.0 }, 0.013 }, Case{ "edge", { 0.5, 0.2, -1.0 }, 0.005 },
      Case{ "beside", { 1.0, 0.3, -0.1 }, 0.002 }, Case{ "behind", { 0.3, 0.4, 1.0 }, 0.008 } })
  {
    this->Rays->RemoveAllLights();
    this->AddSun(each.Towards);
    auto image = this->GetScattering();
    const std::array<double, 4> light{ each.Towards[0], each.Towards[1], each.Towards[2], 0.0 };
    const double error = GetErrorOfMedium(this->Renderer, this->Model, light, image);
    std::cout << each.Name << ": " << error << "\n";
    RecordProperty(each.Name, std::to_string(error));
    EXPECT_LT(error, each.Bound) << each.Name;
    // the light a little off its place would be seen
    const std::array<double, 4> wrong{ light[0] + 0.2, light[1], light[2] + 0.2, 0.0 };
    EXPECT_GT(GetErrorOfMedium(this->Renderer, this->Model, wrong, image), 2.0 * each.Bound);
  }
}

// Flat ones, as a parallel projection shows no sides, which a light from the side makes cast shadows.
TEST_F(GodRaysMedium, IsTheSameInAParallelProjectionAndWithAMargin)
{
  this->AddPillars(0.1);
  const std::array<double, 4> light{ 0.5, 0.3, -1.0, 0.0 };
  this->AddSun({ light[0], light[1], light[2] });
  auto alone = this->GetScattering();
  this->Rays->SetLayerMargin(0.25);
  auto wide = this->GetScattering();
  EXPECT_LT(GetErrorOfMedium(this->Renderer, this->Model, light, wide), 0.012);
  EXPECT_NE(GetMean(alone), GetMean(wide)); // pillars beyond the edge
  this->Rays->SetLayerMargin(0.0);
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  EXPECT_LT(GetErrorOfMedium(this->Renderer, this->Model, light, this->GetScattering()), 0.02);
}

// e^-tau of the depth on the graphics card, in linear light, to a level of the 8-bit picture.
// As VTK shades with it: a cone, and a fading from its axis.
TEST_F(GodRaysMedium, SpotlightsShineInTheirCones)
{
  this->AddPillars();
  auto spot = MakeLamplight({ 1.0, 2.0, -3.0 });
  spot->SetFocalPoint(0.0, 0.0, 3.0);
  spot->SetConeAngle(30.0);
  spot->SetExponent(2.0);
  this->Rays->AddLight(spot);
  const auto setMedium = [](vtkGodRaysSingleScatteringReference* truth)
  {
    truth->SetScatteringCoefficient(0.05, 0.05, 0.05);
    truth->SetFarLimit(30.0);
    truth->SetSpotDirection(-1.0, -2.0, 6.0);
    truth->SetConeAngle(30.0);
    truth->SetSpotExponent(2.0);
  };
  const auto truth = GetTrueScattering(
    this->Renderer, setMedium, { 1.0, 2.0, -3.0, 1.0 }, this->Scene.Window->GetSize());
  vtkNew<vtkGodRaysShadowMapIntegrator> shadows;
  shadows->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
  vtkNew<vtkGodRaysShadowMapIntegrator> automatic;
  const std::array<vtkGodRaysIntegrator*, 2> integrators = { shadows, automatic };
  for (vtkGodRaysIntegrator* integrator : integrators)
  {
    this->Rays->SetIntegrator(integrator);
    const double error = GetErrorOfScattering(truth, this->GetScattering(), { 1.0, 1.0, 1.0 });
    spot->SetConeAngle(90.0);
    const double everywhere = GetErrorOfScattering(truth, this->GetScattering(), { 1.0, 1.0, 1.0 });
    spot->SetConeAngle(30.0);
    std::cout << integrator->GetClassName() << ": " << error << ", everywhere " << everywhere
              << "\n";
    EXPECT_LT(error, 0.001) << integrator->GetClassName();
    EXPECT_GT(everywhere, 5.0 * error);
  }
}

TEST_F(GodRaysMedium, HasAVisibility)
{
  vtkNew<vtkGodRaysHomogeneousModel> model;
  EXPECT_NEAR(model->GetVisibility(), 149.8, 0.1);
  model->SetScatteringCoefficient(0.2, 0.1, 0.05);
  model->SetAbsorptionCoefficient(0.1, 0.1, 0.4);
  model->SetVisibility(200.0);
  EXPECT_NEAR(model->GetVisibility(), 200.0, 1e-9);
  const double* scattering = model->GetScatteringCoefficient();
  const double* absorption = model->GetAbsorptionCoefficient();
  EXPECT_NEAR(std::exp(-200.0 * (scattering[1] + absorption[1])), 0.05, 1e-12);
  EXPECT_NEAR(scattering[0] / scattering[2], 4.0, 1e-9);
  EXPECT_NEAR(absorption[2] / scattering[1], 4.0, 1e-9);
  model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  model->SetAbsorptionCoefficient(0.0, 0.0, 0.0);
  EXPECT_TRUE(std::isinf(model->GetVisibility()));
  model->SetVisibility(100.0);
  EXPECT_NEAR(model->GetVisibility(), 100.0, 1e-9);
  EXPECT_EQ(scattering[0], scattering[2]);
  for (const double wrong : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    model->SetVisibility(wrong);
    EXPECT_NEAR(model->GetVisibility(), 100.0, 1e-9);
  }
  EXPECT_EQ(this->VTKMessages.Take().size(), 4u);
}

TEST_F(GodRaysMedium, TellsItsDepthAcrossTheScene)
{
  this->AddPillars();
  this->AddSun({ 0.15, 0.1, -1.0 });
  const auto getPlan = [this](double scattering)
  {
    this->Model->SetScatteringCoefficient(scattering, scattering, scattering);
    this->Scene.Window->Render();
    return this->Rays->GetPlan();
  };
  EXPECT_TRUE(Says(getPlan(0.05), "optical depth across the scene 0.")) << this->Rays->GetPlan();
  EXPECT_FALSE(Says(getPlan(0.05), "advice"));
  EXPECT_EQ(this->Rays->GetAdvice(), "");
  this->VTKMessages.Take();
  EXPECT_TRUE(Says(getPlan(2.0), "advice: the medium hides the scene: its optical depth"));
  EXPECT_TRUE(Says(this->Rays->GetAdvice(), "less scattering"));
  EXPECT_TRUE(Says(getPlan(1e-4), "advice: the medium hardly shows: its optical depth"));
  EXPECT_TRUE(Says(this->Rays->GetAdvice(), "more scattering"));
  getPlan(1e-5);
  const auto warnings = this->VTKMessages.Take(); // one of each kind
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(Says(warnings[0], "hides the scene")) << warnings[0];
  EXPECT_TRUE(Says(warnings[1], "hardly shows")) << warnings[1];
}

// A medium by name is as dense as suits the scene, whatever its unit, until somebody says how long that is.
TEST_F(GodRaysMedium, SuitsASceneOfWhichNobodyKnowsTheUnit)
{
  this->AddPillars();
  this->AddSun({ 0.15, 0.1, -1.0 });
  const auto getMean = [this]
  {
    this->Scene.Window->Render();
    return GetMean(this->GetScattering());
  };
  ASSERT_TRUE(this->Model->ApplyPreset("sea-water"));
  EXPECT_EQ(this->Model->GetOpticalDepth(), 0.4);
  const double suits = getMean();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "optical depth across the scene 0.4"))
    << this->Rays->GetPlan();
  double bounds[6];
  this->Renderer->ComputeVisiblePropBounds(bounds);
  const double diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
  // the same by hand: 0.419/m in green
  this->Model->SetWorldUnitInMeters(0.4 / (0.419 * diagonal));
  EXPECT_NEAR(getMean(), suits, 1e-5 * suits);
  this->Model->SetWorldUnitInMeters(1.0);
  EXPECT_GT(std::abs(getMean() - suits), 0.1 * suits);
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "across the scene 0.5"));

  this->Model->SetWorldUnitInMeters(0.0);
  this->Model->SetOpticalDepth(0.1);
  EXPECT_LT(getMean(), 0.6 * suits);
  // numbers of one's own are taken as they are
  this->Model->SetAbsorptionCoefficient(0.0, 0.0, 0.0);
  EXPECT_EQ(this->Model->GetOpticalDepth(), 0.0);
  this->Model->SetOpticalDepth(0.1);
  this->Model->SetVisibility(60.0);
  EXPECT_EQ(this->Model->GetOpticalDepth(), 0.0);
  this->Model->SetOpticalDepth(101.0);
  EXPECT_EQ(this->Model->GetOpticalDepth(), 100.0);
}

TEST_F(GodRaysMedium, DimsTheScene)
{
  this->AddPillars();
  this->Renderer->SetBackground(0.8, 0.6, 0.4);
  this->Model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  this->Model->SetAbsorptionCoefficient(0.03, 0.06, 0.12);
  this->Model->AttenuateSceneOff();
  const auto before = GetPixels(this->Scene.Window);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "scatter nothing"));
  this->VTKMessages.Expect("scatter nothing");
  this->Model->AttenuateSceneOn(); // without any light
  const auto after = GetPixels(this->Scene.Window);
  const auto depths = GetDepths(this->Scene.Window, false);
  const double near = 1.0;
  const double far = 100.0;
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(20.0));
  int worst = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const double x = (2.0 * (i % Width + 0.5) / Width - 1.0) * tangent * Width / Height;
    const double y = (2.0 * (i / Width + 0.5) / Height - 1.0) * tangent;
    const double depth = near * far / (far - depths[i] * (far - near));
    const double way = std::min(depth, 30.0) * std::sqrt(1.0 + x * x + y * y);
    for (int c = 0; c < 3; ++c)
    {
      const double light = vtkGodRays::DecodeDisplay(before[4 * i + c] / 255.0) *
        vtkGodRays::Transmittance(this->Model->GetAbsorptionCoefficient()[c], way);
      const int expected = static_cast<int>(std::lround(255.0 * vtkGodRays::EncodeDisplay(light)));
      worst = std::max(worst, std::abs(expected - after[4 * i + c]));
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(GetLargestDifference(before, after), 40);
}

TEST_F(GodRaysMedium, SeesPropsThatAreIgnoredButCastNoShadow)
{
  this->AddSun({ 0.5, 0.3, -1.0 });
  auto wall = MakeBox({ 0.5, 0.5, 2.0 }, { 2.0, 2.0, 0.1 });
  this->Renderer->AddActor(wall);
  auto blocking = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::IGNORED);
  auto ignored = this->GetScattering();
  vtkGodRaysPass::SetRole(wall, vtkGodRaysPass::AUTOMATIC);
  wall->VisibilityOff();
  auto empty = this->GetScattering();
  // the ray ends at the wall in both, and beyond it nothing is missing in the second
  const int onWall[2] = { 140, 108 };
  const int inShadow[2] = { 80, 80 };
  EXPECT_LT(GetValue(ignored, onWall[0], onWall[1]), 0.7 * GetValue(empty, onWall[0], onWall[1]));
  EXPECT_NEAR(
    GetValue(ignored, inShadow[0], inShadow[1]), GetValue(empty, inShadow[0], inShadow[1]), 1e-6);
  EXPECT_LT(
    GetValue(blocking, inShadow[0], inShadow[1]), 0.98 * GetValue(empty, inShadow[0], inShadow[1]));
}

TEST_F(GodRaysMedium, IsLinearInEachLight)
{
  this->AddPillars();
  auto red = this->AddSun({ 0.2, 0.2, -1.0 }, { 1.0, 0.0, 0.0 });
  auto first = this->GetScattering();
  this->Rays->RemoveLight(red);
  this->AddSun({ -0.4, 0.1, -1.0 }, { 0.2, 0.5, 1.0 });
  auto second = this->GetScattering();
  this->Rays->AddLight(red);
  auto both = this->GetScattering();
  double worst = 0.0;
  double peak = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double sum = GetValue(first, x, y, c) + GetValue(second, x, y, c);
        worst = std::max(worst, std::abs(sum - GetValue(both, x, y, c)));
        peak = std::max(peak, sum);
      }
    }
  }
  EXPECT_LT(worst, 1e-6 * peak);
}

// One pass over the other, each with its own lights: what the outer one adds is added to the whole
// picture of the inner one, in linear light.
TEST_F(GodRaysMedium, GoesTogetherWithARadialSum)
{
  this->AddPillars();
  this->AddSun({ 0.4, 0.2, -1.0 }, { 0.3, 0.5, 1.0 });
  const auto alone = GetPixels(this->Scene.Window);
  auto mediumAlone = this->GetScattering();
  vtkNew<vtkGodRaysPass> radial;
  radial->SetPrecision(vtkGodRaysPass::SINGLE);
  AddPlainly(radial);
  radial->AddLight(MakeSun({ -0.2, 0.1, -1.0 }, { 1.0, 0.7, 0.3 }));
  radial->Attach(this->Renderer);
  const auto both = GetPixels(this->Scene.Window);
  vtkNew<vtkImageData> light;
  ASSERT_TRUE(radial->GetScatteringImage(light));
  EXPECT_LE(GetErrorOfSum(both, alone, Width, light), 1.0);
  EXPECT_GT(GetLargestDifference(both, alone), 20);
  vtkNew<vtkImageData> medium;
  ASSERT_TRUE(this->Rays->GetScatteringImage(medium));
  for (int i = 0; i < Width; ++i)
  {
    EXPECT_EQ(GetValue(medium, i, Height / 2), GetValue(mediumAlone, i, Height / 2));
  }
  radial->Detach(this->Renderer);
}

// A frame of another pass, at the place in memory where a former one was, is another frame.
TEST_F(GodRaysMedium, AnIntegratorServesOnePassAfterAnother)
{
  vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
  double means[2];
  for (const bool pillars : { false, true })
  {
    Stage stage(Width, Height);
    if (pillars)
    {
      stage.Renderer->AddActor(MakeBox({ 0.0, 0.0, 0.0 }, { 3.0, 3.0, 0.5 }));
    }
    stage.Rays->SetModel(this->Model);
    stage.Rays->SetIntegrator(integrator);
    stage.Rays->AddLight(MakeSun({ 0.1, 0.1, -1.0 }));
    stage.Rays->Attach(stage.Renderer);
    stage.Window->Render();
    vtkNew<vtkImageData> image;
    ASSERT_TRUE(stage.Rays->GetScatteringImage(image));
    means[pillars] = GetMean(image);
    stage.Rays->Detach(stage.Renderer);
  }
  EXPECT_LT(means[1], 0.95 * means[0]);
}

TEST_F(GodRaysMedium, TakesShiftedPicturesButNoTiltedOnes)
{
  this->AddPillars();
  this->AddSun({ 0.2, 0.2, -1.0 });
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(
    camera->GetProjectionTransformMatrix(static_cast<double>(Width) / Height, -1.0, 1.0));
  const auto plain = this->GetScattering();
  camera->UseExplicitProjectionTransformMatrixOn();
  projection->SetElement(0, 2, 0.125); // by 16 pixels
  camera->SetExplicitProjectionTransformMatrix(projection);
  const auto shifted = this->GetScattering();
  for (int x = 40; x < Width - 40; x += 10)
  {
    EXPECT_NEAR(
      GetValue(shifted, x, 60), GetValue(plain, x + 16, 60), 0.01 * GetValue(plain, x + 16, 60));
  }
  projection->SetElement(0, 1, 0.3);
  camera->SetExplicitProjectionTransformMatrix(projection);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->VTKMessages.Take().at(0), "tilted against the axis of view"));
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "rays: none"));
}

TEST_F(GodRaysMedium, ComputesWhatTheSceneNeeds)
{
  this->AddPillars();
  this->AddSun({ 0.2, 0.2, -1.0 }, { 1.0, 0.5, 0.1 });
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "1 airlight of a directional light"))
    << this->Rays->GetPlan();
  EXPECT_EQ(this->Rays->GetNumberOfGeometryPasses(), 1);
  this->Model->SetScatteringCoefficient(0.05, 0.06, 0.07);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "3 airlights of a directional light"))
    << this->Rays->GetPlan();
}

// Opaque faces that are culled for the eye cast the shadows that they cast when they are drawn.
TEST_F(GodRaysMedium, CulledFacesCastShadows)
{
  for (const std::array<double, 4>& light :
    { std::array<double, 4>{ 0.2, 0.3, -1.0, 0.0 }, { 0.5, 0.2, -3.0, 1.0 } })
  {
    this->Renderer->RemoveAllViewProps();
    this->SetLight(light);
    const double open = GetMean(this->GetScattering());
    vtkNew<vtkPlaneSource> plane; // an open surface, which has a front that the eye sees
    plane->SetOrigin(-1.5, -1.0, 0.0);
    plane->SetPoint1(1.0, -1.0, 0.0);
    plane->SetPoint2(-1.5, 1.5, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> wall;
    wall->SetMapper(mapper);
    this->Renderer->AddActor(wall);
    const double whole = GetMean(this->GetScattering());
    EXPECT_LT(whole, 0.99 * open);
    wall->GetProperty()->BackfaceCullingOn();
    EXPECT_EQ(GetMean(this->GetScattering()), whole) << "the light sees its back";
    // A face that is not drawn ends no view ray: it is seen through, and casts its shadow.
    wall->GetProperty()->BackfaceCullingOff();
    wall->GetProperty()->FrontfaceCullingOn();
    EXPECT_LT(GetMean(this->GetScattering()), open);
  }
}

// Air whose density, and lamps whose power, are found from the visible props, in random scenes.
class GodRaysSceneSize : public ::testing::TestWithParam<int>
{
protected:
  GodRaysSceneSize()
  {
    this->Random.seed(this->GetParam());
    this->Rays->SetAutomaticExposure(false);
    this->Rays->SetModel(this->Model);
    this->Model->SetOpticalDepth(0.6);
    for (int i = 0; i < 6; ++i)
    {
      this->Renderer->AddActor(MakeBox({ this->Draw(-3.0, 3.0), this->Draw(-2.0, 2.0), -1.0 },
        { this->Draw(0.2, 1.0), this->Draw(0.2, 1.0), this->Draw(0.2, 1.0) }, { 0.8, 0.4, 0.2 }));
    }
    this->Rays->AddLight(this->GetParam() % 2
        ? MakeLamplight({ this->Draw(-2.0, 2.0), this->Draw(-2.0, 2.0), -2.5 })
        : MakeSun({ this->Draw(-0.5, 0.5), this->Draw(-0.3, 0.3), -1.0 }));
    this->Rays->SetSourceRadius(this->GetParam() % 4 == 1 ? 0.0 : 0.05);
    this->Rays->Attach(this->Renderer);
  }

  double Draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  std::vector<unsigned char> Render()
  {
    this->Renderer->ResetCameraClippingRange();
    return GetPixels(this->Scene.Window);
  }

  std::mt19937 Random;
  Messages VTKMessages{ true };
  Stage Scene;
  vtkGodRaysPass* Rays = this->Scene.Rays;
  vtkRenderer* Renderer = this->Scene.Renderer;
  vtkNew<vtkGodRaysHomogeneousModel> Model;
};

// Something that appears, moves and vanishes beside the picture changes nothing in it.
TEST_P(GodRaysSceneSize, StaysWhenSomethingFliesByFarAway)
{
  const auto before = this->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "size:"));
  const double angle = this->Draw(-0.4, 0.4);
  const double away = this->Draw(50.0, 500.0);
  auto bird = MakeBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  this->Renderer->AddActor(bird);
  for (const double part : { 1.0, 0.6, 2.0 })
  {
    bird->SetPosition(part * away * std::cos(angle), part * away * std::sin(angle), -0.3 * away);
    // But for edges of shadows, whose map reaches to what casts them.
    EXPECT_LT(CountDifferentPixels(before, this->Render(), 2), before.size() / 4 / 100);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "ResetSceneSize()")) << this->Rays->GetPlan();
  }
  this->Rays->ResetSceneSize(); // the control
  EXPECT_GT(CountDifferentPixels(before, this->Render(), 2), before.size() / 4 / 10);
  this->Rays->ResetSceneSize();
  bird->VisibilityOff();
  EXPECT_EQ(before, this->Render());
}

// Data in place of all former data are as they are in a new window.
TEST_P(GodRaysSceneSize, IsFoundAnewWhenDataAreExchanged)
{
  const auto before = this->Render();
  const double scale = this->Draw(5.0, 50.0);
  std::vector<unsigned char> pictures[2];
  auto box = MakeBox({ 0.0, 0.0, -0.5 * scale }, { 0.3 * scale, 0.3 * scale, 0.1 * scale });
  for (int i = 0; i < 2; ++i)
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->AddActor(box);
    pictures[i] = this->Render();
    this->Rays->ResetSceneSize();
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_NE(pictures[0], before);
}

INSTANTIATE_TEST_SUITE_P(Random, GodRaysSceneSize, ::testing::Range(0, 8));

TEST(GodRaysHomogeneousModel, RefusesWhatIsNoMedium)
{
  Messages messages;
  vtkNew<vtkGodRaysHomogeneousModel> model;
  const double nan = std::nan("");
  model->SetScatteringCoefficient(nan, 1.0, 1.0);
  EXPECT_TRUE(Says(messages.Take().at(0), "ScatteringCoefficient must be three finite numbers"));
  EXPECT_EQ(model->GetScatteringCoefficient()[0], 0.02);
  model->SetAsymmetry(2.0);
  EXPECT_EQ(model->GetAsymmetry(), 0.99);
  model->SetPhaseFunction(vtkGodRaysLastPhaseFunction + 1);
  EXPECT_TRUE(Says(messages.Take().at(0),
    "PhaseFunction must be in 0.." + std::to_string(vtkGodRaysLastPhaseFunction)));
  EXPECT_FALSE(model->ApplyPreset("soup"));
  EXPECT_TRUE(Says(messages.Take().at(0), "clear-air, haze, fog, dust, smoke, sea-water"));
  for (int i = 0; i < model->GetNumberOfPresets(); ++i)
  {
    EXPECT_TRUE(model->ApplyPreset(model->GetPresetName(i)));
    EXPECT_TRUE(model->CanScatter());
  }
  model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  EXPECT_TRUE(model->CanScatter()); // sea water absorbs
  model->AttenuateSceneOff();
  EXPECT_FALSE(model->CanScatter());
}
