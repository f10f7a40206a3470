// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysOcclusionPass: which props it renders, for every role and after every change, and the
// margin about the picture. Its layer: TestGodRaysOcclusionLights, ...Lamps and ...Dimming.

#include "GodRaysOcclusionTesting.h"

#include "vtkAssembly.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPolyDataMapper.h"
#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#else
using vtkLODActor = vtkActor;
#endif

using namespace GodRaysTesting;

namespace
{
/// An actor that counts how often its geometry is drawn.
class CountingActor : public vtkOpenGLActor
{
public:
  static CountingActor* New();
  vtkTypeMacro(CountingActor, vtkOpenGLActor);
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    ++this->Count;
    return this->Superclass::RenderOpaqueGeometry(viewport);
  }
  int Count = 0;
};
vtkStandardNewMacro(CountingActor);
}

//------------------------------------------------------------------------------
// Tags

TEST_F(GodRaysOcclusion, GeometryIsRenderedOnceUnlessTagsAskForMore)
{
  vtkNew<CountingActor> actor;
  actor->SetMapper(MakeBox({ -0.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 })->GetMapper());
  this->Renderer->AddActor(actor);
  auto other = this->AddBox({ 1.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetBackgroundGlow(0.5);
  const auto check = [&](int passes, int draws, const char* words)
  {
    actor->Count = 0;
    this->Scene.Window->Render();
    EXPECT_EQ(this->Rays->GetNumberOfGeometryPasses(), passes);
    EXPECT_EQ(actor->Count, draws);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), words)) << this->Rays->GetPlan();
  };
  check(1, 1, "no second rendering of geometry");
  vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::OCCLUDER);
  check(1, 1, "no second rendering of geometry"); // the scene's depth still says it all
  vtkGodRaysPass::SetRole(other, vtkGodRaysPass::IGNORED);
  check(2, 2, "geometry rendered twice");
  other->VisibilityOff();
  check(1, 1, "geometry rendered once"); // what is not drawn needs no sorting out
  other->VisibilityOn();
  vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::IGNORED);
  check(2, 1, "geometry rendered twice"); // ignored: drawn in the scene only
  vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::AUTOMATIC);
  vtkGodRaysPass::SetRole(other, vtkGodRaysPass::OCCLUDER);
  this->Rays->UntaggedPropsOccludeOff();
  check(2, 1, "geometry rendered twice");
  this->Rays->UntaggedPropsOccludeOn();
  this->Rays->SetLayerMargin(0.1);
  check(2, 2, "margin 0.1");
  this->Rays->SetLayerMargin(0.0);
  check(1, 1, "geometry rendered once");
}

TEST_F(GodRaysOcclusion, ChangesOfTagsAndPropsAreSeenInTheNextFrame)
{
  auto left = this->AddBox({ -1.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  auto right = this->AddBox({ 1.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetBackgroundGlow(1.0);
  this->Rays->SetBackgroundGlowRadius(90.0);
  const auto check = [&](bool leftBlocks, bool rightBlocks)
  {
    auto layer = this->GetLayer();
    EXPECT_EQ(GetValue(layer, Width / 2 - 20, Height / 2), leftBlocks ? 0.0 : 1.0);
    EXPECT_EQ(GetValue(layer, Width / 2 + 20, Height / 2), rightBlocks ? 0.0 : 1.0);
  };
  check(true, true);
  vtkGodRaysPass::SetRole(left, vtkGodRaysPass::IGNORED);
  check(false, true);
  vtkGodRaysPass::SetRole(left, vtkGodRaysPass::AUTOMATIC);
  this->Rays->UntaggedPropsOccludeOff();
  check(false, false);
  vtkGodRaysPass::SetRole(right, vtkGodRaysPass::OCCLUDER);
  check(false, true);
  right->VisibilityOff();
  check(false, false);
  right->VisibilityOn();
  check(false, true);
  this->Renderer->RemoveActor(right);
  check(false, false);
  this->Renderer->AddActor(right);
  check(false, true);
  this->Rays->UntaggedPropsOccludeOn();
  check(true, true);
  left->SetPosition(0.0, 3.0, 0.0);
  check(false, true);
}

TEST_F(GodRaysOcclusion, AssembliesAndLODActorsAreTaggedAsAWhole)
{
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(MakeBox({ -1.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  assembly->AddPart(MakeBox({ -1.5, 1.5, 0.0 }, { 1.0, 1.0, 1.0 }));
  this->Renderer->AddActor(assembly);
  vtkNew<vtkLODActor> lod;
  lod->SetMapper(MakeBox({ 1.5, 0.0, 0.0 }, { 1.0, 1.0, 1.0 })->GetMapper());
  this->Renderer->AddActor(lod);
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetBackgroundGlow(1.0);
  this->Rays->SetBackgroundGlowRadius(90.0);
  const auto check = [&](bool assemblyBlocks, bool lodBlocks)
  {
    auto layer = this->GetLayer();
    EXPECT_EQ(GetValue(layer, Width / 2 - 20, Height / 2), assemblyBlocks ? 0.0 : 1.0);
    EXPECT_EQ(GetValue(layer, Width / 2 - 20, Height / 2 + 20), assemblyBlocks ? 0.0 : 1.0);
    EXPECT_EQ(GetValue(layer, Width / 2 + 20, Height / 2), lodBlocks ? 0.0 : 1.0);
  };
  check(true, true);
  vtkGodRaysPass::SetRole(assembly, vtkGodRaysPass::IGNORED);
  check(false, true);
  vtkGodRaysPass::SetRole(lod, vtkGodRaysPass::IGNORED);
  check(false, false);
  this->Rays->UntaggedPropsOccludeOff();
  vtkGodRaysPass::SetRole(assembly, vtkGodRaysPass::OCCLUDER);
  check(true, false);
  vtkGodRaysPass::SetRole(lod, vtkGodRaysPass::OCCLUDER);
  check(true, true);
  for (const std::string& text : this->VTKMessages.Take())
  {
    EXPECT_TRUE(Says(text, "was deprecated")) << text; // vtkLODActor of VTK 9.1 says that of itself
  }
}

//------------------------------------------------------------------------------
// The margin

TEST_F(GodRaysOcclusion, TheMarginHoldsWhatIsJustOutsideThePicture)
{
  // a wider picture by the same factor, cropped, is what the margin shows
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double tangent = GetTangent(this->Renderer);
  const double right = tangent * Width / Height;
  this->AddSun({ 1.15 * right, 0.2 * tangent, -1.0 });                 // outside
  this->AddBox({ 10.0 * right * 1.08, 0.0, 0.0 }, { 0.15, 2.0, 0.1 }); // outside, before it
  this->AddBox({ 0.0, -1.0, 0.0 }, { 1.0, 1.0, 1.0 });
  this->Rays->SetSunAngularRadius(2.0);
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetLayerMargin(0.25);
  const vtkMTimeType before = camera->GetMTime();
  auto layer = this->GetLayer();
  auto scattering = this->GetScattering();
  EXPECT_EQ(layer->GetDimensions()[0], Width * 3 / 2);
  EXPECT_EQ(layer->GetDimensions()[1], Height * 3 / 2);
  EXPECT_EQ(scattering->GetDimensions()[0], Width);
  EXPECT_EQ(this->Renderer->GetActiveCamera(), camera);
  EXPECT_EQ(camera->GetMTime(), before);
  EXPECT_FALSE(camera->GetUseExplicitProjectionTransformMatrix());

  Stage wide(Width * 3 / 2, Height * 3 / 2);
  vtkCamera* wideCamera = wide.Renderer->GetActiveCamera();
  wideCamera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(1.5 * tangent)));
  wide.Renderer->AddActor(MakeBox({ 10.0 * right * 1.08, 0.0, 0.0 }, { 0.15, 2.0, 0.1 }));
  wide.Renderer->AddActor(MakeBox({ 0.0, -1.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  wide.Rays->AddLight(this->Rays->GetLight(0));
  wide.Rays->SetSunAngularRadius(2.0);
  wide.Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  wide.Rays->Attach(wide.Renderer);
  wide.Window->Render();
  vtkNew<vtkImageData> wideLayer;
  vtkNew<vtkImageData> wideScattering;
  ASSERT_TRUE(wide.Rays->GetOcclusionImage(wideLayer));
  ASSERT_TRUE(wide.Rays->GetScatteringImage(wideScattering));
  int different = 0; // edges of boxes may fall to either side of a pixel
  ForEachPixel(layer,
    [&](int x, int y)
    { different += std::abs(GetValue(layer, x, y) - GetValue(wideLayer, x, y)) > 1e-4; });
  EXPECT_LE(different, 4);
  double worst = 0.0;
  double peak = 0.0;
  ForEachPixel(scattering,
    [&](int x, int y)
    {
      const double expected = GetValue(wideScattering, x + Width / 4, y + Height / 4);
      peak = std::max(peak, expected);
      worst = std::max(worst, std::abs(GetValue(scattering, x, y) - expected));
    });
  std::cout << "margin against a wider picture, of the peak: " << worst / peak << "\n";
  EXPECT_LT(worst, 0.01 * peak);
  EXPECT_GT(peak, 0.01);

  // and the light outside and the box before it do act
  this->Rays->SetBackgroundGlow(0.0);
  const double lit = GetMean(this->GetScattering());
  EXPECT_GT(lit, 0.0);
  this->Rays->SetLayerMargin(0.0);
  EXPECT_EQ(GetSum(this->GetScattering()), 0.0);
}

TEST_F(GodRaysOcclusion, WithAMarginTheRaysDoNotJumpWhenALightCrossesTheEdge)
{
  const double tangent = GetTangent(this->Renderer);
  const double right = tangent * Width / Height;
  this->AddBox({ 3.0, 0.0, 0.0 }, { 0.4, 2.0, 0.1 });
  auto sun = this->AddSun({ right, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(1.5);
  this->Rays->SetLayerMargin(0.25);
  // 0.02 is about a pixel; the sun's radius is some 3
  double largestStep = 0.0;
  double mean = 0.0;
  double former = -1.0;
  for (double x = 0.9; x < 1.1; x += 0.02)
  {
    sun->SetPosition(x * right, 0.1 * tangent, -1.0);
    mean = GetMean(this->GetScattering());
    EXPECT_GT(mean, 0.0);
    if (former >= 0.0)
    {
      largestStep = std::max(largestStep, std::abs(mean / former - 1.0));
    }
    former = mean;
  }
  EXPECT_LT(largestStep, 0.1);
  // as a control, without one they do
  this->Rays->SetLayerMargin(0.0);
  sun->SetPosition(0.98 * right, 0.1 * tangent, -1.0);
  const double inside = GetMean(this->GetScattering());
  sun->SetPosition(1.02 * right, 0.1 * tangent, -1.0);
  EXPECT_LT(GetMean(this->GetScattering()), 0.7 * inside);
}
