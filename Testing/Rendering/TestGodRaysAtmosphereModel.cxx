// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysAtmosphereModel in the pass: molecules and aerosols against the ground truth, with and
// without things that block; where the ground is; the sun on its way down; the scene that it dims.

#include "GodRaysMediumTesting.h"

#include "vtkCommand.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

using namespace GodRaysTesting;

namespace
{
const double Unit = 100.0; // [m]

class GodRaysAtmosphereModel : public MediumTest
{
protected:
  vtkNew<vtkGodRaysAtmosphereModel> Air;

  GodRaysAtmosphereModel()
  {
    this->Air->SetRayleighScattering(4e-5, 1e-4, 2.5e-4);
    this->Air->SetRayleighScaleHeight(800.0);
    this->Air->SetMieScattering(5e-4, 5e-4, 5e-4);
    this->Air->SetMieAbsorption(5e-5, 5e-5, 5e-5);
    this->Air->SetMieScaleHeight(300.0);
    this->Air->SetWorldUnitInMeters(Unit);
    this->Air->SetUp(0.0, 2.0, 0.0);
    this->Air->SetGroundLevel(-2.0);
    this->Air->SetFarLimit(30.0);
    this->Rays->SetModel(this->Air);
  }

  /// Of each pixel, or of the middle one of each so many by so many.
  vtkSmartPointer<vtkImageData> GetTruth(
    std::array<double, 4> light, int step = 1, vtkLight* spot = nullptr)
  {
    const auto setMedium = [this, spot](vtkGodRaysSingleScatteringReference* truth)
    {
      const auto scaled = [](const double* c) {
        return std::array<double, 3>{ Unit * c[0], Unit * c[1], Unit * c[2] };
      };
      truth->SetScatteringCoefficient(scaled(this->Air->GetMieScattering()).data());
      truth->SetAbsorptionCoefficient(scaled(this->Air->GetMieAbsorption()).data());
      truth->SetPhaseFunction(vtkGodRaysMediumModel::CORNETTE_SHANKS);
      truth->SetAsymmetry(this->Air->GetMieAsymmetry());
      truth->SetScaleHeight(this->Air->GetMieScaleHeight() / Unit);
      truth->SetGasScatteringCoefficient(scaled(this->Air->GetRayleighScattering()).data());
      truth->SetGasPhaseFunction(vtkGodRaysMediumModel::RAYLEIGH);
      truth->SetGasScaleHeight(this->Air->GetRayleighScaleHeight() / Unit);
      truth->SetMediumUp(this->Air->GetUp());
      truth->SetGroundLevel(this->Air->GetGroundLevel());
      truth->SetPlanetRadius(this->Air->GetPlanetRadius() / Unit);
      truth->SetFarLimit(this->Air->GetFarLimit());
      if (spot)
      {
        double axis[3];
        vtkMath::Subtract(spot->GetFocalPoint(), spot->GetPosition(), axis);
        truth->SetSpotDirection(axis);
        truth->SetConeAngle(spot->GetConeAngle());
        truth->SetSpotExponent(spot->GetExponent());
      }
    };
    const int* window = this->Scene.Window->GetSize();
    EXPECT_TRUE(step % 2 == 1 && window[0] % step == 0 && window[1] % step == 0);
    const int size[2] = { window[0] / step, window[1] / step };
    return GetTrueScattering(this->Renderer, setMedium, light, size);
  }

  /// Where there is a truth, of such a step.
  double GetErrorOfAir(std::array<double, 4> light, vtkImageData* truth, int step = 1)
  {
    this->SetLight(light);
    return this->GetErrorOfAir(truth, step);
  }
  double GetErrorOfAir(vtkImageData* truth, int step = 1)
  {
    vtkNew<vtkExtractVOI> middles;
    middles->SetInputData(this->GetScattering());
    const int* window = this->Scene.Window->GetSize();
    middles->SetVOI(step / 2, window[0] - 1, step / 2, window[1] - 1, 0, 0);
    middles->SetSampleRate(step, step, 1);
    middles->Update();
    EXPECT_EQ(middles->GetOutput()->GetNumberOfPoints(), truth->GetNumberOfPoints());
    return GodRaysTesting::GetErrorOfScattering(truth, middles->GetOutput(), { 1.0, 1.0, 1.0 });
  }
};

const std::array<double, 4> InFront = { 0.15, 0.1, -1.0, 0.0 };
const std::array<double, 4> Beside = { 1.0, 0.3, -0.1, 0.0 };
const std::array<double, 4> Behind = { 0.3, 0.4, 1.0, 0.0 };
const std::array<double, 4> LampInFront = { 0.0, 0.5, -2.0, 1.0 };
const std::array<double, 4> LampBeside = { 6.0, 1.0, 0.5, 1.0 };
}

TEST_F(GodRaysAtmosphereModel, IsTheIntegralWithoutOccluders)
{
  this->Scene.Window->SetSize(64, 48); // the truth takes its time
  for (const auto& light : { InFront, Beside, Behind, LampInFront })
  {
    EXPECT_LT(this->GetErrorOfAir(light, this->GetTruth(light)), 2e-5);
  }
  const auto former = this->GetTruth(InFront);
  this->Air->SetGroundLevel(0.0);
  EXPECT_LT(this->GetErrorOfAir(InFront, this->GetTruth(InFront)), 2e-5);
  EXPECT_GT(this->GetErrorOfAir(InFront, former), 0.05);
}

TEST_F(GodRaysAtmosphereModel, IsTheGroundTruthWithOccluders)
{
  this->Scene.Window->SetSize(255, 192);
  this->AddPillars(0.1);
  vtkNew<vtkGodRaysShadowMapIntegrator> shadows;
  shadows->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
  vtkNew<vtkGodRaysShadowMapIntegrator> automatic;
  const std::array<vtkGodRaysIntegrator*, 2> integrators = { shadows, automatic };
  const std::pair<std::array<double, 4>, double> cases[] = { { InFront, 0.01 }, { Beside, 0.005 },
    { Behind, 0.006 }, { LampInFront, 0.008 }, { LampBeside, 0.0002 } };
  for (const auto& [light, bound] : cases)
  {
    // The truth takes its time; of the lamp in the picture's middle, few pixels make most of the error.
    const int step = std::getenv("GODRAYS_LONG") || light == LampInFront ? 1 : 3;
    const auto truth = this->GetTruth(light, step);
    for (vtkGodRaysIntegrator* integrator : integrators)
    {
      this->Rays->SetIntegrator(integrator);
      const double error = this->GetErrorOfAir(light, truth, step);
      std::cout << integrator->GetClassName() << ": " << error << "\n";
      EXPECT_LT(error, bound) << integrator->GetClassName();
    }
  }
}

// That fade from slanted axes: no view ray is lit as another one is. Beside the picture, before the eye, and
// behind it.
TEST_F(GodRaysAtmosphereModel, IsTheGroundTruthOfSlantedSpotlights)
{
  this->Scene.Window->SetSize(255, 192);
  this->AddPillars(0.1);
  this->Rays->SetErrorTolerance(2e-4);
  const int step = std::getenv("GODRAYS_LONG") ? 1 : 3; // the truth takes its time
  const std::array<std::array<double, 4>, 3> places = { { { 4.0, 3.0, -3.0, 1.0 },
    { 0.5, 1.0, -3.0, 1.0 }, { -3.0, 2.5, 12.0, 1.0 } } };
  for (const auto& place : places)
  {
    auto spot = MakeLamplight({ place[0], place[1], place[2] });
    spot->SetFocalPoint(0.5, -0.5, 1.0);
    spot->SetConeAngle(25.0);
    spot->SetExponent(6.0);
    const auto truth = this->GetTruth(place, step, spot);
    this->Rays->RemoveAllLights();
    this->Rays->AddLight(spot);
    const double error = this->GetErrorOfAir(truth, step);
    spot->SetExponent(0.0);
    const double even = this->GetErrorOfAir(truth, step);
    spot->SetExponent(6.0);
    std::cout << "error " << error << ", without fading " << even << "\n";
    EXPECT_LT(error, 0.0007) << this->Rays->GetPlan();
    EXPECT_GT(even, 0.005);
    this->Scene.Window->Render();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "walked on the processor")) << this->Rays->GetPlan();
  }
}

// A small one, so that its horizon is in the picture.
TEST_F(GodRaysAtmosphereModel, IsTheIntegralOverAPlanet)
{
  this->Scene.Window->SetSize(48, 36); // the truth takes its time
  this->Air->SetPlanetRadius(5e5);
  this->Air->SetFarLimit(300.0);
  vtkNew<vtkGodRaysShadowMapIntegrator> shadows;
  shadows->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
  vtkNew<vtkGodRaysShadowMapIntegrator> automatic;
  const std::array<vtkGodRaysIntegrator*, 2> integrators = { shadows, automatic };
  const auto truth = this->GetTruth(Beside);
  for (vtkGodRaysIntegrator* integrator : integrators)
  {
    this->Rays->SetIntegrator(integrator);
    const double round = this->GetErrorOfAir(Beside, truth);
    this->Air->SetPlanetRadius(0.0);
    const double flat = this->GetErrorOfAir(Beside, truth);
    this->Air->SetPlanetRadius(5e5);
    std::cout << integrator->GetClassName() << ": " << round << ", flat " << flat << "\n";
    EXPECT_LT(round, 1e-3);
    EXPECT_GT(flat, 10.0 * round);
  }
}

TEST_F(GodRaysAtmosphereModel, ReddensALowSunAndIsDarkBelowTheHorizon)
{
  const auto getBlueOverRed = [this](double height)
  {
    this->SetLight({ 0.3, height, -1.0, 0.0 });
    auto image = this->GetScattering();
    return GetValue(image, 128, 96, 2) / GetValue(image, 128, 96, 0);
  };
  EXPECT_LT(getBlueOverRed(0.05), 0.6 * getBlueOverRed(1.0));
  this->SetLight({ 0.3, -0.2, -1.0, 0.0 });
  this->Scene.Window->Render();
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(!this->Rays->GetScatteringImage(image) || GetMean(image) == 0.0);
}

// A planet's ground, which no prop shows, ends view rays, and lamps in it give no light.
TEST_F(GodRaysAtmosphereModel, EndsAtAPlanetsGroundOutOfWhichNothingShines)
{
  this->Scene.Window->SetSize(48, 36); // the truth takes its time
  this->Air->SetPlanetRadius(6.36e6);
  this->Air->SetGroundLevel(-0.5);
  for (const bool parallel : { false, true })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
    for (const int backend : { vtkGodRaysIntegrator::PROCESSOR, vtkGodRaysIntegrator::GRAPHICS })
    {
      integrator->SetBackend(backend);
      this->Rays->SetIntegrator(integrator);
      const auto truth = this->GetTruth(LampBeside);
      const double error = this->GetErrorOfAir(LampBeside, truth);
      std::cout << integrator->GetClassName() << (parallel ? ", parallel: " : ": ") << error
                << "\n";
      EXPECT_LT(error, 1e-4);
      EXPECT_FALSE(Says(this->Rays->GetPlan(), "in the planet's ground"));
      this->SetLight({ 0.0, -0.7, -2.0, 1.0 });
      EXPECT_EQ(GetMean(this->GetScattering()), 0.0);
      EXPECT_TRUE(Says(this->Rays->GetPlan(), "1 lamp(s) in the planet's ground give no light"));
    }
  }
}

TEST_F(GodRaysAtmosphereModel, DimsLessWhatIsHigh)
{
  this->Renderer->SetBackground(0.7, 0.7, 0.7);
  this->Scene.Window->Render();
  const auto pixels = GetPixels(this->Scene.Window);
  const auto get = [&pixels](int y) { return pixels[4 * (y * Width + Width / 2)]; };
  EXPECT_GT(get(Height - 5), get(5) + 20);
}

// What the picture loses is told, whatever parameters take it; the truth is the transmittance in double
// precision. Air that is as it should be is the control.
TEST_F(GodRaysAtmosphereModel, HidingTheScene_AnyCause_IsTold)
{
  struct Case
  {
    const char* Name;
    double WorldUnit;
    double Scattering; // factor
    double ScaleHeight;
  };
  this->Scene.Window->SetSize(64, 48);
  this->AddPillars();
  this->SetLight(InFront);
  this->Rays->Detach(this->Renderer);
  int hidden = 0;
  for (const Case& each : { Case{ "usual", Unit, 1.0, 300.0 }, Case{ "thin", 1.0, 1.0, 300.0 },
         Case{ "unit", 1e6, 1.0, 300.0 }, Case{ "coefficients", Unit, 1e6, 300.0 },
         Case{ "dense", Unit, 1e4, 300.0 }, Case{ "coefficients of thin air", 1e-3, 1e6, 300.0 },
         Case{ "no height", Unit, 1.0, 0.0 }, Case{ "great height", Unit, 1.0, 1e9 } })
  {
    vtkNew<vtkGodRaysPass> rays; // which has told nothing yet
    rays->SetModel(this->Air);
    rays->AddLight(this->Rays->GetLight(0));
    rays->Attach(this->Renderer);
    this->Air->SetWorldUnitInMeters(each.WorldUnit);
    this->Air->SetMieScattering(5e-4 * each.Scattering, 5e-4, 5e-4);
    this->Air->SetRayleighScattering(4e-5, 1e-4 * each.Scattering, 2.5e-4 * each.Scattering);
    this->Air->SetMieScaleHeight(each.ScaleHeight);
    this->Scene.Window->Render();
    vtkNew<vtkImageData> numbers;
    ASSERT_TRUE(rays->GetMediumImage(numbers)) << each.Name;
    vtkDataArray* depth = numbers->GetPointData()->GetArray("Depth");
    vtkDataArray* transmittance = numbers->GetPointData()->GetArray("Transmittance");
    double left = 0.0;
    int count = 0;
    for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
    {
      if (std::isfinite(depth->GetTuple1(i)))
      {
        left += vtkMath::Max(transmittance->GetTuple3(i)[0], transmittance->GetTuple3(i)[1]);
        ++count;
      }
    }
    left /= std::max(count, 1);
    ASSERT_TRUE(left < 0.003 || left > 0.05) << each.Name << " " << left;
    hidden += left < 0.003 ? 1 : 0;
    EXPECT_EQ(Says(rays->GetAdvice(), "the medium hides the scene"), left < 0.003)
      << each.Name << " " << left << "\n"
      << rays->GetPlan();
    const auto told = this->VTKMessages.Take();
    EXPECT_EQ(told.empty(), rays->GetAdvice().empty()) << each.Name;
    rays->Detach(this->Renderer);
  }
  EXPECT_GE(hidden, 2);
}

TEST_F(GodRaysAtmosphereModel, SharesTheAirOfASky)
{
  vtkNew<vtkGodRaysAtmosphere> sky;
  vtkNew<vtkGodRaysAtmosphereModel> model;
  const auto expectSame = [&]
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(model->GetRayleighScattering()[i], sky->GetRayleighScattering()[i]);
      EXPECT_EQ(model->GetMieScattering()[i], sky->GetMieScattering()[i]);
      EXPECT_EQ(model->GetMieAbsorption()[i], sky->GetMieAbsorption()[i]);
    }
    EXPECT_EQ(model->GetRayleighScaleHeight(), sky->GetRayleighHeight());
    EXPECT_EQ(model->GetMieScaleHeight(), sky->GetMieHeight());
    EXPECT_EQ(model->GetMieAsymmetry(), sky->GetMieAsymmetry()[1]);
  };
  expectSame();
  sky->LoadPreset(vtkGodRaysAtmosphere::MARS);
  EXPECT_NE(model->GetMieScaleHeight(), sky->GetMieHeight());
  model->SetAtmosphere(sky);
  EXPECT_EQ(model->GetAtmosphere(), sky);
  expectSame();
  vtkMTimeType time = model->GetMTime();
  sky->SetMieHeight(400.0); // as a sky pass's owner does it
  expectSame();
  EXPECT_GT(model->GetMTime(), time);
  model->SetMieScaleHeight(50.0);
  EXPECT_EQ(sky->GetMieHeight(), 400.0);
  sky->LoadPreset(vtkGodRaysAtmosphere::EARTH_HAZY);
  expectSame();
  model->SetAtmosphere(nullptr);
  expectSame();
  time = model->GetMTime();
  sky->LoadPreset(vtkGodRaysAtmosphere::MARS);
  EXPECT_NE(model->GetMieScaleHeight(), sky->GetMieHeight());
  EXPECT_EQ(model->GetMTime(), time);
  {
    vtkNew<vtkGodRaysAtmosphereModel> gone;
    gone->SetAtmosphere(sky);
  }
  EXPECT_FALSE(sky->HasObserver(vtkCommand::ModifiedEvent));
}

TEST_F(GodRaysAtmosphereModel, RefusesWhatIsNoDirection)
{
  this->Air->SetUp(0.0, 0.0, 0.0);
  EXPECT_TRUE(Says(this->VTKMessages.Take().at(0), "Up must be a direction"));
  EXPECT_EQ(this->Air->GetUp()[1], 2.0);
}
