// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysOcclusionPass: the layer of props tagged LIGHT: in which colours they shine, what hides
// them, and thin, slanted, translucent and volume ones.

#include "GodRaysOcclusionTesting.h"

#include "vtkGodRaysMath.h"

#include "vtkAssembly.h"
#include "vtkCylinderSource.h"
#include "vtkElevationFilter.h"
#include "vtkLineSource.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <functional>
#include <string>

using namespace GodRaysTesting;

class GodRaysOcclusionLamps : public GodRaysOcclusion
{
protected:
  /// The layer is the light of the colours in which the only prop is shown, to half a level of the
  /// 8-bit picture, and 0 elsewhere.
  void ExpectAsShown()
  {
    this->Rays->SetIntensity(0.0);
    const auto shown = GetPixels(this->Scene.Window);
    const auto depths = GetDepths(this->Scene.Window, false);
    this->Rays->SetIntensity(1.0);
    auto layer = this->GetLayer();
    int count = 0;
    ForEachPixel(layer,
      [&](int x, int y)
      {
        const std::size_t i = static_cast<std::size_t>(y) * Width + x;
        for (int c = 0; c < 3; ++c)
        {
          const double value = vtkGodRays::EncodeDisplay(GetValue(layer, x, y, c));
          EXPECT_NEAR(value, depths[i] < 1.0f ? shown[4 * i + c] / 255.0 : 0.0, 0.51 / 255.0)
            << x << ", " << y;
        }
        count += depths[i] < 1.0f;
      });
    EXPECT_GT(count, 300);
  }
};

TEST_F(GodRaysOcclusionLamps, ShineInTheirOwnColor)
{
  this->AddLamp({ 1.0, 0.0, 0.0 }, 1.2, { 0.8, 0.4, 0.2 });
  this->ExpectAsShown();
  auto layer = this->GetLayer();
  const int x = Width / 2 + 13;
  EXPECT_NEAR(GetValue(layer, x, Height / 2, 0), vtkGodRays::DecodeDisplay(0.8), 1e-6);
  EXPECT_NEAR(GetValue(layer, x, Height / 2, 1), vtkGodRays::DecodeDisplay(0.4), 1e-6);
  EXPECT_NEAR(GetValue(layer, x, Height / 2, 2), vtkGodRays::DecodeDisplay(0.2), 1e-6);
}

TEST_F(GodRaysOcclusionLamps, OfOneColorTakeOneComponentAndOthersThree)
{
  struct Change
  {
    const char* Name;
    std::function<void(vtkActor*)> Make;
    int Components;
  };
  vtkNew<vtkProperty> green;
  green->LightingOff();
  green->SetColor(0.1, 0.9, 0.2);
  const Change changes[] = {
    { "as it is", [](vtkActor*) {}, 1 },
    { "opaque wires", [](vtkActor* lamp) { lamp->GetProperty()->SetRepresentationToWireframe(); },
      1 },
    { "thick points",
      [](vtkActor* lamp)
      {
        lamp->GetProperty()->SetRepresentationToPoints();
        lamp->GetProperty()->SetPointSize(15.0);
      },
      1 },
    { "lit", [](vtkActor* lamp) { lamp->GetProperty()->LightingOn(); }, 3 },
    { "edges", [](vtkActor* lamp) { lamp->GetProperty()->EdgeVisibilityOn(); }, 3 },
    { "ambient light", [](vtkActor* lamp) { lamp->GetProperty()->SetAmbient(0.1); }, 3 },
    { "less diffuse light", [](vtkActor* lamp) { lamp->GetProperty()->SetDiffuse(0.6); }, 3 },
    { "culled, with backs of another colour",
      [&](vtkActor* lamp)
      {
        lamp->SetBackfaceProperty(green);
        lamp->GetProperty()->FrontfaceCullingOn();
      },
      3 },
    { "scalars",
      [](vtkActor* lamp)
      {
        vtkNew<vtkElevationFilter> elevation;
        elevation->SetInputConnection(lamp->GetMapper()->GetInputConnection(0, 0));
        elevation->SetLowPoint(0.0, -2.0, 0.0);
        elevation->SetHighPoint(0.0, 2.0, 0.0);
        lamp->GetMapper()->SetInputConnection(elevation->GetOutputPort());
      },
      3 },
  };
  for (const Change& change : changes)
  {
    SCOPED_TRACE(change.Name);
    auto lamp = this->AddLamp({ 0.5, 0.3, 0.0 }, 1.2, { 0.8, 0.4, 0.2 });
    change.Make(lamp);
    this->ExpectAsShown();
    const std::string components = change.Components == 1 ? ", 1 component:" : ", 3 components:";
    EXPECT_TRUE(Says(this->Rays->GetPlan(), components)) << this->Rays->GetPlan();
    this->Renderer->RemoveActor(lamp);
  }
}

TEST_F(GodRaysOcclusionLamps, LayersAreTheSameWhereverTheGlowAndTheLampEnd)
{
  // what ends within the layer is drawn there alone; with shaders of a program's own, on all of it
  for (const double x : { -7.0, -2.0, 0.0, 3.0, 8.0 })
  {
    for (const double falloff : { 0.5, 5.0, 60.0 })
    {
      SCOPED_TRACE(testing::Message() << "lamp at " << x << ", falloff " << falloff);
      this->Rays->SetBackgroundGlow(0.7);
      this->Rays->SetBackgroundGlowRadius(1.0);
      this->Rays->SetBackgroundGlowFalloff(falloff);
      auto lamp = this->AddLamp({ x, 1.0, -2.0 }, 0.8, { 0.8, 0.4, 0.2 });
      auto part = this->GetLayer();
      lamp->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, "//VTK::Light::Impl", false);
      auto whole = this->GetLayer();
      EXPECT_LT(GetLargestDifference(part, whole), 1e-6);
      this->Renderer->RemoveActor(lamp);
    }
  }
}

TEST_F(GodRaysOcclusionLamps, ThatDoNotShineAreToldOf)
{
  auto hidden = this->AddLamp({ 0.0, 0.0, 0.0 }, 1.0);
  hidden->VisibilityOff();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "skipped: it is invisible or has no geometry"));
  this->VTKMessages.Expect("no light reaches the picture (it is invisible");
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "rays: none"));
  hidden->VisibilityOn();
  EXPECT_GT(GetSum(this->GetLayer()), 0.0);
}

TEST_F(GodRaysOcclusionLamps, ShineInTheColorsOfTheirScalars)
{
  auto lamp = this->AddLamp({ 0.0, 0.0, 0.0 }, 2.0);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2.0);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0.0, -2.0, 0.0);
  elevation->SetHighPoint(0.0, 2.0, 0.0);
  lamp->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  this->ExpectAsShown();
  lamp->GetProperty()->LightingOn(); // shaded: as drawn, too
  this->ExpectAsShown();
}

TEST_F(GodRaysOcclusionLamps, ShineInTheColorsOfTheirTexture)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 48; ++i)
  {
    bytes[i] = static_cast<unsigned char>(40 + (i * 37) % 200);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  auto lamp = this->AddLamp({ 0.0, 0.0, 0.0 }, 2.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -1.5, 0.0);
  plane->SetPoint1(2.0, -1.5, 0.5);
  plane->SetPoint2(-2.0, 1.5, 0.0);
  lamp->GetMapper()->SetInputConnection(plane->GetOutputPort());
  lamp->SetTexture(texture);
  this->ExpectAsShown();
}

TEST_F(GodRaysOcclusionLamps, AreHiddenAndHalfHiddenByWhatIsBeforeThem)
{
  for (int samples : { 0, 8 })
  {
    SCOPED_TRACE(testing::Message() << samples << " samples");
    this->Scene.Window->SetMultiSamples(samples);
    this->Renderer->RemoveAllViewProps();
    this->AddLamp({ 0.0, 0.0, -2.0 }, 1.5);
    auto open = this->GetLayer();
    EXPECT_GT(GetSum(open), 500.0);

    this->AddBox({ 5.0, 0.0, 1.0 }, { 10.0, 10.0, 1.0 });
    auto layer = this->GetLayer();
    ForEachPixel(layer,
      [&](int x, int y)
      {
        if (x != Width / 2) // the box's edge goes through the samples of that column or beside
        {
          EXPECT_EQ(GetValue(layer, x, y), x < Width / 2 ? GetValue(open, x, y) : 0.0)
            << x << ", " << y;
        }
      });

    // all of it, also its limb, where it is steep; close before it and far before it
    for (double radius : { 1.5, 0.6, 0.2 })
    {
      this->Renderer->RemoveAllViewProps();
      this->AddLamp({ 0.0, 0.0, -2.0 }, radius);
      EXPECT_GT(GetSum(this->GetLayer()), 5.0);
      for (double z : { -2.0 + radius + 0.11, 1.0 })
      {
        auto wall = this->AddBox({ 0.0, 0.0, z }, { 10.0, 10.0, 0.2 });
        EXPECT_EQ(GetSum(this->GetLayer()), 0.0) << radius << ", " << z;
        this->Renderer->RemoveActor(wall);
      }
    }
  }
}

TEST_F(GodRaysOcclusionLamps, ThinOnesAreHiddenToo)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-2.0, -1.3, -1.0);
  line->SetPoint2(1.8, 1.1, -1.0);
  vtkNew<vtkPlaneSource> grille; // with gaps of about a pixel
  grille->SetOrigin(-2.0, -1.5, -1.0);
  grille->SetPoint1(2.0, -1.5, -1.5);
  grille->SetPoint2(-2.0, 1.5, -2.0);
  grille->SetResolution(25, 20);
  vtkPolyDataAlgorithm* sources[] = { line, grille };
  for (int samples : { 0, 8 })
  {
    this->Scene.Window->SetMultiSamples(samples);
    for (int shape = 0; shape < 2; ++shape)
    {
      SCOPED_TRACE(testing::Message() << samples << " samples, shape " << shape);
      this->Renderer->RemoveAllViewProps();
      auto lamp = this->AddLamp({ 0.0, 0.0, 0.0 }, 1.0);
      lamp->GetMapper()->SetInputConnection(sources[shape]->GetOutputPort());
      lamp->GetProperty()->SetRepresentationToWireframe();
      auto layer = this->GetLayer();
      for (int x = Width / 2 - 20; x <= Width / 2 + 20; ++x)
      {
        double column = 0.0;
        for (int y = 0; y < Height; ++y)
        {
          column += GetValue(layer, x, y);
        }
        EXPECT_GT(column, 0.5) << "the line has a gap at " << x;
      }
      this->AddBox({ 0.0, 0.0, -0.3 }, { 10.0, 10.0, 0.2 });
      EXPECT_EQ(GetSum(this->GetLayer()), 0.0);
    }
  }
}

TEST_F(GodRaysOcclusionLamps, LoseNoPixelsInsideHoweverSlantedTheyAre)
{
  vtkNew<vtkCylinderSource> tube; // seen nearly along its axis
  tube->SetResolution(40);
  tube->SetRadius(0.6);
  tube->SetHeight(16.0);
  tube->CappingOff();
  tube->SetCenter(0.0, 0.0, 0.0);
  vtkNew<vtkSphereSource> ball; // fills the picture
  ball->SetRadius(7.0);
  ball->SetCenter(0.0, -3.0, 1.0);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  vtkNew<vtkPlaneSource> floor; // a pixel covers more and more of it
  floor->SetOrigin(-30.0, -0.5, 8.5);
  floor->SetPoint1(30.0, -0.5, 8.5);
  floor->SetPoint2(-30.0, 0.5, -80.0);
  vtkPolyDataAlgorithm* sources[] = { tube, ball, floor };
  for (int samples : { 0, 8 })
  {
    for (int shape = 0; shape < 3; ++shape)
    {
      SCOPED_TRACE(testing::Message() << samples << " samples, shape " << shape);
      this->Renderer->RemoveAllViewProps();
      auto lamp = this->AddLamp({ 0.0, 0.0, 0.0 }, 1.0);
      lamp->GetMapper()->SetInputConnection(sources[shape]->GetOutputPort());
      if (shape == 0)
      {
        lamp->SetOrientation(86.0, 0.0, 0.0);
        lamp->SetPosition(0.9, -0.9, -2.0);
      }
      this->Scene.Window->SetMultiSamples(0);
      const auto depths = this->GetSceneDepths();
      this->Scene.Window->SetMultiSamples(samples);
      auto layer = this->GetLayer();
      int inside = 0;
      for (int y = 1; y + 1 < Height; ++y)
      {
        for (int x = 1; x + 1 < Width; ++x)
        {
          bool within = true;
          for (int i = 0; i < 9; ++i)
          {
            within = within && depths[(y + i / 3 - 1) * Width + x + i % 3 - 1] < 1.0f;
          }
          inside += within;
          EXPECT_TRUE(!within || GetValue(layer, x, y) == 1.0) << x << ", " << y;
        }
      }
      EXPECT_GT(inside, 500);
    }
  }
}

TEST_F(GodRaysOcclusionLamps, AreSeenThroughIgnoredPropsAndMayBeAssemblies)
{
  vtkNew<vtkAssembly> lamps;
  lamps->AddPart(MakeLamp({ -1.2, 0.0, -1.0 }, 0.7, { 1.0, 0.5, 0.5 }));
  lamps->AddPart(MakeLamp({ 1.2, 0.0, -1.0 }, 0.7, { 0.5, 0.5, 1.0 }));
  vtkGodRaysPass::SetRole(lamps, vtkGodRaysPass::LIGHT);
  this->Renderer->AddActor(lamps);
  this->ExpectAsShown();
  auto open = this->GetLayer();
  auto box = this->AddBox({ 0.0, 0.0, 1.0 }, { 10.0, 10.0, 1.0 });
  EXPECT_EQ(GetSum(this->GetLayer()), 0.0);
  vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
  EXPECT_EQ(GetLargestDifference(open, this->GetLayer()), 0.0);
}

TEST_F(GodRaysOcclusionLamps, ShineAlsoWhenTranslucentOrVolumes)
{
  const int x = Width / 2;
  const int y = Height / 2;
  auto glass = this->AddLamp({ 0.0, 0.0, 0.0 }, 1.5, { 0.8, 0.6, 0.4 });
  vtkNew<vtkPlaneSource> plane;
  glass->GetMapper()->SetInputConnection(plane->GetOutputPort());
  glass->SetScale(3.0);
  glass->GetProperty()->SetOpacity(0.5);
  auto wall = this->AddBox({ 0.0, 0.0, -5.0 }, { 10.0, 10.0, 1.0 });
  const auto expectGlass = [&]
  {
    auto layer = this->GetLayer();
    EXPECT_NEAR(GetValue(layer, x, y, 0), vtkGodRays::DecodeDisplay(0.4), 1e-5);
    EXPECT_NEAR(GetValue(layer, x, y, 2), vtkGodRays::DecodeDisplay(0.2), 1e-5);
    EXPECT_EQ(GetValue(layer, 1, 1), 0.0);
  };
  expectGlass();
  wall->VisibilityOff();
  expectGlass();
  this->Rays->SetBackgroundGlow(0.5); // seen through it
  EXPECT_NEAR(GetValue(this->GetLayer(), x, y, 0),
    vtkGodRays::DecodeDisplay(0.4) + 0.5 * 0.5 * vtkGodRays::DecodeDisplay(0.8), 1e-3);
  this->Rays->SetBackgroundGlow(0.0);
  wall->VisibilityOn();
  wall->SetPosition(0.0, 0.0, 8.0); // before it
  EXPECT_EQ(GetSum(this->GetLayer()), 0.0);
  wall->SetPosition(0.0, 0.0, 0.0);
  this->Renderer->RemoveActor(glass);

  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  auto fire = MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.2);
  vtkGodRaysPass::SetRole(fire, vtkGodRaysPass::LIGHT);
  this->Renderer->AddVolume(fire);
  auto layer = this->GetLayer();
  // two units thick and 0.5 grey: all but 4 % of it
  EXPECT_NEAR(GetValue(layer, x, y), vtkGodRays::DecodeDisplay(0.96 * 0.5), 0.01);
  EXPECT_EQ(GetValue(layer, 1, 1), 0.0);
  wall->SetPosition(0.0, 0.0, 8.0);
  EXPECT_EQ(GetSum(this->GetLayer()), 0.0);
}

TEST_F(GodRaysOcclusionLamps, FadeAsTheirCentrePassesBehindTheCamera)
{
  // a bar along the direction of view, part of which is seen wherever its centre is
  for (double opacity : { 1.0, 0.5 })
  {
    for (double ahead : { 3.0, 0.1, 0.0, -0.1 })
    {
      SCOPED_TRACE(testing::Message() << "opacity " << opacity << ", " << ahead << " ahead");
      this->Renderer->RemoveAllViewProps();
      auto bar = this->AddBox({ 1.5, 0.0, 10.0 - ahead }, { 1.0, 1.0, 30.0 });
      bar->GetProperty()->LightingOff();
      bar->GetProperty()->BackfaceCullingOn();
      bar->GetProperty()->SetColor(1.0, 1.0, 1.0);
      bar->GetProperty()->SetOpacity(opacity);
      vtkGodRaysPass::SetRole(bar, vtkGodRaysPass::LIGHT);
      auto layer = this->GetLayer();
      double brightest = 0.0;
      ForEachPixel(
        layer, [&](int x, int y) { brightest = std::max(brightest, GetValue(layer, x, y)); });
      const double fade = vtkGodRays::FacingFade(ahead / std::hypot(1.5, ahead));
      EXPECT_NEAR(brightest, fade * vtkGodRays::DecodeDisplay(opacity), 2e-3);
    }
  }
}

TEST_F(GodRaysOcclusionLamps, EachHasItsOwnCentre)
{
  SumTaps(this->Rays);
  // without anything that blocks, the rays of each lamp are rotationally symmetric about it, and
  // go through nothing but its own disc: the model's sum about its own centre
  auto left = this->AddLamp({ -2.0, 0.5, 0.0 }, 0.4, { 1.0, 0.0, 0.0 });
  auto right = this->AddLamp({ 1.5, -0.8, -2.0 }, 0.5, { 0.0, 0.0, 1.0 });
  auto both = this->GetScattering();
  vtkGodRaysPass::SetRole(right, vtkGodRaysPass::AUTOMATIC);
  this->GetScattering();
  EXPECT_LT(GetErrorOfScattering(
              this->Rays, this->Renderer, GetClip(this->Renderer, { -2.0, 0.5, 0.0, 1.0 })),
    1e-5);
  auto first = this->GetScattering();
  vtkGodRaysPass::SetRole(right, vtkGodRaysPass::LIGHT);
  vtkGodRaysPass::SetRole(left, vtkGodRaysPass::AUTOMATIC);
  this->GetScattering();
  EXPECT_LT(GetErrorOfScattering(
              this->Rays, this->Renderer, GetClip(this->Renderer, { 1.5, -0.8, -2.0, 1.0 })),
    1e-5);
  auto second = this->GetScattering();
  ForEachPixel(both,
    [&](int x, int y)
    {
      EXPECT_NEAR(GetValue(both, x, y, 0), GetValue(first, x, y, 0), 1e-6);
      EXPECT_NEAR(GetValue(both, x, y, 2), GetValue(second, x, y, 2), 1e-6);
    });
}
