// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysPass: roles, lights, parameters, errors, and the frames that need no rays.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#else // ParaView leaves it out of its VTK
using vtkLODActor = vtkActor;
#endif
#include "vtkTextActor.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace GodRaysTesting;

TEST(GodRaysPassRoles, AreKeptBesideOtherKeys)
{
  Messages messages;
  vtkNew<vtkActor> actor;
  vtkNew<vtkInformation> keys;
  keys->Set(vtkDataObject::FIELD_ASSOCIATION(), 7);
  actor->SetPropertyKeys(keys);
  vtkNew<vtkActor> sharing;
  sharing->SetPropertyKeys(keys);

  EXPECT_EQ(vtkGodRaysPass::GetRole(actor), vtkGodRaysPass::AUTOMATIC);
  const vtkMTimeType before = actor->GetMTime();
  vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::LIGHT);
  EXPECT_EQ(vtkGodRaysPass::GetRole(actor), vtkGodRaysPass::LIGHT);
  EXPECT_GT(actor->GetMTime(), before);
  EXPECT_EQ(actor->GetPropertyKeys()->Get(vtkDataObject::FIELD_ASSOCIATION()), 7);
  EXPECT_EQ(vtkGodRaysPass::GetRole(sharing), vtkGodRaysPass::AUTOMATIC)
    << "a prop that shares the keys must not be tagged with it";

  vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::AUTOMATIC);
  EXPECT_FALSE(actor->GetPropertyKeys()->Has(vtkGodRaysPass::ROLE()));
  EXPECT_EQ(actor->GetPropertyKeys()->Get(vtkDataObject::FIELD_ASSOCIATION()), 7);
}

TEST(GodRaysPassRoles, GoOnAnyPropButOnlyKnownOnes)
{
  Messages messages;
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkLODActor> lod;
  for (int role = vtkGodRaysPass::AUTOMATIC; role <= vtkGodRaysPass::MEDIUM; ++role)
  {
    vtkGodRaysPass::SetRole(assembly, role);
    vtkGodRaysPass::SetRole(lod, role);
    EXPECT_EQ(vtkGodRaysPass::GetRole(assembly), role);
    EXPECT_EQ(vtkGodRaysPass::GetRole(lod), role);
  }
  EXPECT_EQ(vtkGodRaysPass::GetRole(nullptr), vtkGodRaysPass::AUTOMATIC);

  vtkGodRaysPass::SetRole(lod, 5);
  vtkGodRaysPass::SetRole(nullptr, vtkGodRaysPass::LIGHT);
  const auto said = messages.Take();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_TRUE(Says(said[0], "role 5") && Says(said[0], "OCCLUDER (1)")) << said[0];
  EXPECT_TRUE(Says(said[1], "null prop")) << said[1];
  EXPECT_EQ(vtkGodRaysPass::GetRole(lod), vtkGodRaysPass::MEDIUM);
}

TEST(GodRaysPassLights, AreASet)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  vtkNew<vtkLight> a;
  vtkNew<vtkLight> b;
  rays->AddLight(a);
  rays->AddLight(b);
  rays->AddLight(a);
  rays->AddLight(nullptr);
  EXPECT_EQ(rays->GetNumberOfLights(), 2);
  EXPECT_EQ(rays->GetLight(1), b);
  EXPECT_EQ(rays->GetLight(2), nullptr);
  EXPECT_EQ(rays->GetLight(-1), nullptr);
  rays->RemoveLight(a);
  rays->RemoveLight(a);
  EXPECT_EQ(rays->GetNumberOfLights(), 1);
  const vtkMTimeType before = rays->GetMTime();
  b->SetIntensity(0.5);
  EXPECT_GT(rays->GetMTime(), before) << "a light's change is the pass's";
  rays->RemoveAllLights();
  EXPECT_EQ(rays->GetNumberOfLights(), 0);
}

TEST(GodRaysPassParameters, AreClampedAndRefuseNaN)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [&](const char* name, auto set, auto get, double low, double high, double now)
  {
    EXPECT_DOUBLE_EQ(get(), now) << name << ", default";
    set(low - 1.0);
    EXPECT_DOUBLE_EQ(get(), low) << name;
    set(high * 2.0 + 1.0);
    EXPECT_DOUBLE_EQ(get(), high) << name;
    const vtkMTimeType before = rays->GetMTime();
    set(nan);
    const auto said = messages.Take();
    ASSERT_EQ(said.size(), 1u) << name;
    EXPECT_TRUE(Says(said[0], name) && Says(said[0], "finite number")) << said[0];
    EXPECT_DOUBLE_EQ(get(), high) << name;
    EXPECT_EQ(rays->GetMTime(), before) << name;
  };
#define CHECK(Name, low, high, now)                                                                \
  check(                                                                                           \
    #Name, [&](double v) { rays->Set##Name(v); }, [&] { return rays->Get##Name(); }, low, high,    \
    now)
  CHECK(Intensity, 0.0, 1e4, 1.0);
  CHECK(MostDataLightness, 0.0, 100.0, 10.0);
  CHECK(ErrorTolerance, 1e-6, 0.1, 1.0 / 255.0);
  CHECK(InteractiveErrorTolerance, 1e-6, 0.1, 0.01);
  CHECK(SourceRadius, 0.0, 1e30, 0.0);
  CHECK(BackgroundGlow, 0.0, 1.0, 1.0);
  CHECK(BackgroundGlowRadius, 0.0, 180.0, 0.75);
  CHECK(BackgroundGlowFalloff, 0.0, 180.0, 3.6);
  CHECK(LayerMargin, 0.0, 1.0, 0.0);
#undef CHECK
  check(
    "AngularRadius", [&](double v) { rays->SetSunAngularRadius(v); }, // the sun's
    [&] { return rays->GetSun()->GetAngularRadius(); }, 0.01, 90.0, 0.2678);

  rays->SetOutput(3);
  rays->SetBlend(-1);
  rays->SetPrecision(2);
  EXPECT_EQ(messages.Take().size(), 3u);
  EXPECT_EQ(rays->GetOutput(), vtkGodRaysPass::COMPOSITE);
  EXPECT_EQ(rays->GetBlend(), vtkGodRaysPass::MODEL_BLEND);
  EXPECT_EQ(rays->GetPrecision(), vtkGodRaysPass::HALF);
}

TEST(GodRaysPassParameters, AreAllPrinted)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  std::ostringstream text;
  rays->Print(text);
  for (const char* name : { "Intensity", "AutomaticExposure", "HighlightShoulder",
         "DarkenLightBackground", "DataFirst", "MostDataLightness", "ErrorTolerance",
         "InteractiveErrorTolerance", "UntaggedPropsOcclude", "SourceRadius", "SunAngularRadius",
         "BackgroundGlow:", "BackgroundGlowRadius", "BackgroundGlowFalloff", "LayerMargin", "Blend",
         "Output", "Precision", "MeasureTimes", "Density", "VerifyPixels" })
  {
    EXPECT_TRUE(Says(text.str(), name)) << name;
  }
}

TEST(GodRaysPassParameters, DefaultObjectsComeBackWithNull)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  vtkNew<vtkGodRaysRadialModel> model;
  vtkNew<vtkGodRaysTapsIntegrator> integrator;
  rays->SetModel(model);
  rays->SetIntegrator(integrator);
  EXPECT_EQ(rays->GetModel(), model);
  EXPECT_EQ(rays->GetIntegrator(), integrator);
  rays->SetModel(nullptr);
  rays->SetIntegrator(nullptr);
  EXPECT_TRUE(rays->GetModel()->IsA("vtkGodRaysRadialModel"));
  EXPECT_TRUE(rays->GetIntegrator()->IsA("vtkGodRaysEpipolarIntegrator"));
}

TEST(GodRaysPassParameters, APresetBringsItsModelAndKeepsOneOfItsClass)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  vtkSmartPointer<vtkGodRaysIntegrator> integrator = rays->GetIntegrator();
  vtkNew<vtkGodRaysRadialModel> model;
  rays->SetModel(model);
  ASSERT_TRUE(rays->ApplyPreset("low-sun"));
  EXPECT_EQ(rays->GetModel(), model);
  EXPECT_EQ(model->GetWeight(), 0.041);
  ASSERT_TRUE(rays->ApplyPreset("published:mitchell"));
  EXPECT_TRUE(rays->GetModel()->IsA("vtkGodRaysPublishedModel"));
  EXPECT_EQ(model->GetWeight(), 0.041) << "the former model";
  EXPECT_EQ(rays->GetIntegrator(), integrator) << "which evaluates both";
  vtkSmartPointer<vtkGodRaysModel> published = rays->GetModel();
  ASSERT_TRUE(rays->ApplyPreset("published:babylon"));
  EXPECT_EQ(rays->GetModel(), published);

  ASSERT_TRUE(rays->ApplyPreset("fog"));
  auto medium = vtkGodRaysHomogeneousModel::SafeDownCast(rays->GetModel());
  ASSERT_TRUE(medium);
  EXPECT_TRUE(rays->GetIntegrator()->Supports(medium));
  medium->SetWorldUnitInMeters(100.0);
  ASSERT_TRUE(rays->ApplyPreset("haze"));
  EXPECT_EQ(rays->GetModel(), medium);
  EXPECT_EQ(medium->GetWorldUnitInMeters(), 100.0);
}

/// Frames without rays have the bytes of frames without the pass, and the plan gives the reason. A reason
/// that was probably not meant is advice, and one warning, with a remedy.
class GodRaysPassStraightThrough : public ::testing::Test
{
protected:
  Messages VTKMessages;
  Stage Scene;

  void ExpectIdentical(const std::string& reason, const std::string& remedy, bool isNew = true)
  {
    this->Scene.Window->Render();
    const auto with = GetPixels(this->Scene.Window);
    const std::string advice = this->Scene.Rays->GetAdvice();
    EXPECT_EQ(advice.empty(), remedy.empty()) << reason;
    EXPECT_TRUE(Says(advice, remedy)) << advice;
    const auto told = this->VTKMessages.Take();
    ASSERT_EQ(told.size(), isNew && !remedy.empty() ? 1u : 0u) << reason;
    EXPECT_TRUE(told.empty() || Says(told.front(), remedy)) << told.front();
    const auto depths = GetDepths(this->Scene.Window, false);
    EXPECT_TRUE(Says(this->Scene.Rays->GetPlan(), reason)) << this->Scene.Rays->GetPlan();
    this->Scene.Rays->Detach(this->Scene.Renderer);
    EXPECT_EQ(with, GetPixels(this->Scene.Window));
    EXPECT_EQ(depths, GetDepths(this->Scene.Window, false));
    this->Scene.Rays->Attach(this->Scene.Renderer);
  }
};

TEST_F(GodRaysPassStraightThrough, ForEveryReason)
{
  auto sun = this->Scene.AddPillarsAndSun();
  vtkGodRaysPass* rays = this->Scene.Rays;
  auto model = vtkGodRaysRadialModel::SafeDownCast(rays->GetModel());

  rays->SetIntensity(0.0);
  this->ExpectIdentical("Intensity is 0", "");
  rays->SetIntensity(1.0);

  const double density = model->GetDensity();
  model->SetDensity(0.0);
  this->ExpectIdentical("scatter nothing", "Set its density");
  model->SetDensity(density);

  const std::string place = "Move a light behind the data";
  sun->SwitchOff();
  this->ExpectIdentical("off or black", place);
  sun->SwitchOn();
  sun->SetIntensity(0.0);
  this->ExpectIdentical("off or black", place, false);
  sun->SetIntensity(1.0);

  sun->SetPosition(0.3, 0.2, 1.0);
  this->ExpectIdentical("behind the camera", place);
  this->Scene.Window->SetDesiredUpdateRate(15.0);
  this->ExpectIdentical("behind the camera", ""); // the user drags it
  this->Scene.Window->SetDesiredUpdateRate(0.0001);
  sun->SetPosition(1.0, 0.2, -0.3);
  this->ExpectIdentical("neither it nor its glow", place);
  sun->SetPosition(0.0, 0.0, 0.0);
  this->ExpectIdentical("its position is its focal point", place);
  sun->SetPosition(0.3, 0.2, -1.0);

  rays->RemoveLight(sun);
  this->ExpectIdentical("add one with AddLight()", "SUN_EVERY_VIEW");
  rays->AddLight(sun);

  // and, as a control, rays where there is no reason against them
  const auto with = GetPixels(this->Scene.Window);
  rays->Detach(this->Scene.Renderer);
  EXPECT_GT(CountDifferentPixels(with, GetPixels(this->Scene.Window)), 128 * 96 / 2);
}

TEST_F(GodRaysPassStraightThrough, ButLayersWithoutLightAreShownDark)
{
  auto sun = this->Scene.AddPillarsAndSun();
  sun->SetPosition(1.0, 0.2, -0.3);
  for (const int output : { vtkGodRaysPass::OCCLUSION, vtkGodRaysPass::SCATTERING })
  {
    this->Scene.Rays->SetOutput(output);
    const auto pixels = GetPixels(this->Scene.Window);
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      ASSERT_TRUE(i % 4 == 3 || pixels[i] == 0) << i;
    }
  }
  this->Scene.Rays->SetOutput(vtkGodRaysPass::COMPOSITE);
  this->ExpectIdentical("neither it nor its glow", "Move a light behind the data");
}

TEST_F(GodRaysPassStraightThrough, WhereNoRayReachesThePixelsKeepTheirBytes)
{
  // a lamp and a march that ends halfway: nothing beyond the lamp's own reach
  vtkGodRaysPass* rays = this->Scene.Rays;
  this->Scene.AddPillarsAndSun();
  rays->RemoveAllLights();
  rays->SetBackgroundGlow(0.0);
  rays->AddLight(MakeLamplight({ 2.5, 1.5, -3.0 }));
  rays->SetSourceRadius(0.3);
  vtkGodRaysRadialModel::SafeDownCast(rays->GetModel())->SetDensity(0.5);
  const auto with = GetPixels(this->Scene.Window);
  const auto depths = GetDepths(this->Scene.Window, false);
  vtkNew<vtkImageData> scattering;
  ASSERT_TRUE(rays->GetScatteringImage(scattering));
  rays->Detach(this->Scene.Renderer);
  const auto without = GetPixels(this->Scene.Window);
  EXPECT_EQ(depths, GetDepths(this->Scene.Window, false));
  int lit = 0;
  int dark = 0;
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      const std::size_t i = 4 * (static_cast<std::size_t>(y) * 128 + x);
      EXPECT_EQ(with[i + 3], without[i + 3]) << "alpha";
      if (GetValue(scattering, x, y, 0) > 0.0)
      {
        ++lit;
        EXPECT_GE(with[i], without[i]);
      }
      else
      {
        ++dark;
        EXPECT_TRUE(std::equal(&with[i], &with[i] + 4, &without[i])) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(lit, 20);
  EXPECT_GT(dark, 1000);
}

TEST(GodRaysPassErrors, AnUnsupportedModelIsToldOnceAndDrawnWithoutRays)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  vtkNew<vtkGodRaysHomogeneousModel> model;
  vtkNew<vtkGodRaysTapsIntegrator> integrator;
  scene.Rays->SetModel(model);
  scene.Rays->SetIntegrator(integrator);
  const auto with = GetPixels(scene.Window);
  GetPixels(scene.Window);
  const auto said = messages.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "cannot evaluate") && Says(said[0], "Set an integrator")) << said[0];
  for (vtkGodRaysModel* unsupported : std::vector<vtkGodRaysModel*>{ model, nullptr })
  {
    EXPECT_FALSE(integrator->Supports(unsupported));
    EXPECT_TRUE(Says(integrator->Describe(unsupported), "taps: none"));
  }
  EXPECT_FALSE(scene.Rays->ApplyPreset("mitchel"));
  const auto refused = messages.Take();
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_TRUE(Says(refused[0], "\"mitchel\"") && Says(refused[0], "default, ")) << refused[0];
  EXPECT_EQ(scene.Rays->GetModel(), model.Get());
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(with, GetPixels(scene.Window));
}

TEST(GodRaysPassOverlays, TextNeitherGlowsNorBlocks)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  const auto plain = GetPixels(scene.Window);
  vtkNew<vtkImageData> layer;
  ASSERT_TRUE(scene.Rays->GetOcclusionImage(layer));
  const double mean = GetMean(layer);

  vtkNew<vtkTextActor> text;
  text->SetInput("MMMMMMMMM");
  text->SetPosition(5, 5);
  scene.Renderer->AddActor(text);
  const auto withText = GetPixels(scene.Window);
  vtkNew<vtkImageData> layerWithText;
  ASSERT_TRUE(scene.Rays->GetOcclusionImage(layerWithText));
  EXPECT_DOUBLE_EQ(mean, GetMean(layerWithText));
  EXPECT_GT(CountDifferentPixels(plain, withText), 50);

  // the text is what it is without rays: where it is opaque, its own colour
  scene.Rays->Detach(scene.Renderer);
  const auto withoutRays = GetPixels(scene.Window);
  int white = 0;
  for (std::size_t i = 0; i < withText.size(); i += 4)
  {
    const bool opaque = withoutRays[i] == 255 && withoutRays[i + 1] == 255;
    white += opaque;
    if (opaque)
    {
      EXPECT_EQ(withText[i], 255);
    }
  }
  EXPECT_GT(white, 10);
}
