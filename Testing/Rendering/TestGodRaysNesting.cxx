// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Passes around the pass, and passes within it.

#include "GodRaysTesting.h"

#include "vtkActorCollection.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkEDLShading.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSimpleMotionBlurPass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkTextActor.h"
#include "vtkTextureObject.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

using namespace GodRaysTesting;

namespace
{
const int Width = 128;
const int Height = 96;

vtkSmartPointer<vtkActor> MakeGlass()
{
  auto glass = MakeBox({ 1.0, 0.5, 1.5 }, { 3.0, 2.0, 0.2 }, { 0.2, 0.7, 0.9 });
  glass->GetProperty()->SetOpacity(0.4);
  return glass;
}

double GetMeanDifference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += i % 4 < 3 ? std::abs(a[i] - b[i]) : 0;
  }
  return sum / (0.75 * static_cast<double>(a.size()));
}

double GetMeanOf(const std::vector<unsigned char>& a)
{
  return GetMeanDifference(a, std::vector<unsigned char>(a.size(), 0));
}

/// The four pictures of a scene: alone and within an outer pass, without and with rays.
struct Pictures
{
  std::vector<unsigned char> Bare;
  std::vector<unsigned char> Lit;
  std::vector<unsigned char> BareWithin;
  std::vector<unsigned char> LitWithin;
};

// Without translucent props: VTK's translucent pass copies depth only from a framebuffer of the
// window's format, which outer passes do not have.
void Arrange(Stage& scene)
{
  scene.AddPillarsAndSun();
  auto ignored = MakeBox({ -2.0, -1.0, 2.0 }, { 1.5, 1.0, 0.1 });
  vtkGodRaysPass::SetRole(ignored, vtkGodRaysPass::IGNORED);
  scene.Renderer->AddActor(ignored);
}

template <typename Pass>
Pictures Render(
  const std::function<void(Pass*)>& set = [](Pass*) {},
  int transfer = vtkGodRaysPass::AUTOMATIC_TRANSFER)
{
  Pictures pictures;
  for (const bool within : { false, true })
  {
    Stage scene(Width, Height);
    Arrange(scene);
    scene.Rays->SetDisplayTransfer(transfer);
    vtkNew<Pass> outer;
    if (within)
    {
      set(outer);
      scene.Rays->Detach(scene.Renderer);
      outer->SetDelegatePass(scene.Rays);
      scene.Renderer->SetPass(outer);
    }
    (within ? pictures.LitWithin : pictures.Lit) = GetPixels(scene.Window);
    EXPECT_EQ(within ? pictures.LitWithin : pictures.Lit, GetPixels(scene.Window))
      << "the second frame differs";
    EXPECT_NE(scene.Rays->GetPlan().find("scattering: epipolar"), std::string::npos)
      << scene.Rays->GetPlan();
    scene.Rays->SetIntensity(0.0);
    (within ? pictures.BareWithin : pictures.Bare) = GetPixels(scene.Window);
    if (within)
    {
      outer->ReleaseGraphicsResources(scene.Window);
      scene.Renderer->SetPass(nullptr);
      EXPECT_EQ(GetPixels(scene.Window), pictures.Bare) << "the window is not as it was";
    }
  }
  EXPECT_GT(GetMeanDifference(pictures.Lit, pictures.Bare), 5.0);
  const double added = GetMeanOf(pictures.Lit) - GetMeanOf(pictures.Bare);
  EXPECT_NEAR(GetMeanOf(pictures.LitWithin) - GetMeanOf(pictures.BareWithin), added, 0.015 * added);
  return pictures;
}

}

TEST(GodRaysWithin, AFramebufferPassIsAsWithout)
{
  Messages messages;
  for (const int format :
    { vtkTextureObject::Fixed8, vtkTextureObject::Float16, vtkTextureObject::Float32 })
  {
    const Pictures pictures = Render<vtkFramebufferPass>(
      [format](vtkFramebufferPass* outer) { outer->SetColorFormat(format); });
    EXPECT_LE(GetLargestDifference(pictures.BareWithin, pictures.Bare), 1) << format;
    EXPECT_LE(GetLargestDifference(pictures.LitWithin, pictures.Lit), 1) << format;
  }
}

TEST(GodRaysWithin, AToneMappingPassReachesItUntouched)
{
  Messages messages;
  const Pictures pictures = Render<vtkToneMappingPass>([](vtkToneMappingPass* outer)
    { outer->SetToneMappingType(vtkToneMappingPass::Clamp); },
    vtkGodRaysPass::POWER_TRANSFER);
  // this mapping is the identity but for its own rounding
  EXPECT_LE(GetLargestDifference(pictures.BareWithin, pictures.Bare), 1);
  EXPECT_LE(GetLargestDifference(pictures.LitWithin, pictures.Lit), 1);
}

TEST(GodRaysWithin, ASuperSamplingPassIsThePictureSmoothed)
{
  Messages messages;
  const Pictures pictures = Render<vtkSSAAPass>();
  EXPECT_LT(GetMeanDifference(pictures.LitWithin, pictures.Lit),
    GetMeanDifference(pictures.BareWithin, pictures.Bare) + 1.5);
}

TEST(GodRaysWithin, ABlurIsThePictureBlurred)
{
  Messages messages;
  const Pictures pictures = Render<vtkGaussianBlurPass>();
  EXPECT_LT(GetMeanDifference(pictures.LitWithin, pictures.Lit),
    GetMeanDifference(pictures.BareWithin, pictures.Bare) + 1.5);
}

TEST(GodRaysWithin, FXAAIsThePictureSmoothed)
{
  Messages messages;
  const Pictures pictures = Render<vtkOpenGLFXAAPass>();
  EXPECT_LT(GetMeanDifference(pictures.LitWithin, pictures.Lit),
    GetMeanDifference(pictures.BareWithin, pictures.Bare) + 1.5);
}

TEST(GodRaysWithin, AnSSAOPassOfANewWindowHasTranslucentPropsAsRenderStepsDrawThem)
{
  Messages messages;
  const auto draw = [](bool withRays, bool peeling, double intensity)
  {
    Stage scene(Width, Height);
    Arrange(scene);
    scene.Renderer->AddActor(MakeGlass());
    scene.Renderer->SetUseDepthPeeling(peeling);
    scene.Rays->SetIntensity(intensity);
    scene.Rays->Detach(scene.Renderer);
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> outer;
    outer->SetRadius(0.5);
    outer->SetDelegatePass(withRays ? static_cast<vtkRenderPass*>(scene.Rays) : steps);
    scene.Renderer->SetPass(outer);
    return GetPixels(scene.Window);
  };
  const auto expected = draw(false, false, 1.0);
  for (const bool peeling : { false, true })
  {
    EXPECT_EQ(draw(true, peeling, 0.0), expected) << peeling;
    EXPECT_GT(GetMeanDifference(draw(true, peeling, 1.0), expected), 5.0) << peeling;
  }
}

namespace
{
/// A scene that is lit everywhere, shaded by a vtkSSAOPass over another pass.
std::vector<unsigned char> GetShaded(Stage& scene, vtkRenderPass* inner)
{
  Arrange(scene);
  scene.Rays->Detach(scene.Renderer);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    actor->GetProperty()->SetAmbient(1.0);
  }
  vtkNew<vtkSSAOPass> outer;
  outer->SetRadius(0.5);
  outer->SetDelegatePass(inner);
  scene.Renderer->SetPass(outer);
  auto picture = GetPixels(scene.Window);
  scene.Renderer->SetPass(nullptr);
  outer->ReleaseGraphicsResources(scene.Window);
  return picture;
}
}

// It shades by positions and normals, for which the framebuffer has colour buffers of their own.
TEST(GodRaysWithin, AnSSAOPassShadesTheSceneAsWithout)
{
  Messages messages;
  Stage plain(Width, Height);
  vtkNew<vtkRenderStepsPass> steps;
  const auto expected = GetShaded(plain, steps);
  const auto depths = GetDepths(plain.Window);
  const auto count = [&expected, &depths](const std::vector<unsigned char>& picture)
  {
    int different = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      for (std::size_t c = 4 * i; depths[i] < 1.0f && c < 4 * i + 3; ++c)
      {
        different += std::abs(picture[c] - expected[c]) > 3;
      }
    }
    return different;
  };
  Stage rays(Width, Height);
  rays.Rays->AutomaticExposureOff();
  rays.Rays->SetIntensity(1e-6);
  EXPECT_EQ(count(GetShaded(rays, rays.Rays)), 0);
  EXPECT_TRUE(Says(rays.Rays->GetPlan(), "scattering: epipolar")) << rays.Rays->GetPlan();
  Stage under(Width, Height);
  vtkNew<vtkGodRaysSkyPass> sky;
  sky->SetWorldUnitInMeters(10.0);
  sky->SurfaceLightOff();
  EXPECT_EQ(count(GetShaded(under, sky)), 0);
  EXPECT_TRUE(Says(sky->GetPlan(), "air: a new table")) << sky->GetPlan();
}

TEST(GodRaysWithin, AnEDLPassLeavesTheDepthsAsWithout)
{
  Messages messages;
  const auto getDepths = [](bool withRays, double intensity)
  {
    Stage scene(Width, Height);
    Arrange(scene);
    scene.Renderer->AddActor(MakeGlass());
    scene.Rays->SetIntensity(intensity);
    scene.Rays->Detach(scene.Renderer);
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkEDLShading> outer;
    outer->SetDelegatePass(withRays ? static_cast<vtkRenderPass*>(scene.Rays) : steps);
    scene.Renderer->SetPass(outer);
    return GetDepths(scene.Window);
  };
  const auto expected = getDepths(false, 1.0);
  EXPECT_LT(*std::min_element(expected.begin(), expected.end()), 0.95f);
  EXPECT_EQ(getDepths(true, 0.0), expected);
  EXPECT_EQ(getDepths(true, 1.0), expected);
}

TEST(GodRaysWithin, PassesInAViewportAreAsInAWindow)
{
  Messages messages;
  Stage single(64, 48);
  Arrange(single);
  const auto expected = GetPixels(single.Window);
  Stage whole(128, 96);
  whole.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  Arrange(whole);
  vtkNew<vtkFramebufferPass> outer;
  whole.Rays->Detach(whole.Renderer);
  outer->SetDelegatePass(whole.Rays);
  whole.Renderer->SetPass(outer);
  const auto picture = GetPixels(whole.Window);
  int worst = 0;
  for (int y = 0; y < 48; ++y)
  {
    for (int i = 0; i < 64 * 4; ++i)
    {
      const std::size_t at = (static_cast<std::size_t>(y + 48) * 128 + 64) * 4;
      worst = std::max(worst, std::abs(picture[at + i] - expected[y * 64 * 4 + i]));
    }
  }
  EXPECT_LE(worst, 1);
}

TEST(GodRaysDelegate, OfRenderStepsDrawsAsTheRenderer)
{
  Messages messages;
  Stage scene(Width, Height);
  scene.AddPillarsAndSun();
  const auto expected = GetPixels(scene.Window);
  const auto depths = GetDepths(scene.Window, false);
  const int rendered = scene.Rays->GetNumberOfRenderedProps();
  EXPECT_EQ(rendered, scene.Renderer->GetViewProps()->GetNumberOfItems());
  scene.Rays->Detach(scene.Renderer);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  scene.Rays->Attach(scene.Renderer); // the renderer's pass becomes the delegate
  EXPECT_EQ(scene.Rays->GetDelegatePass(), steps);
  EXPECT_EQ(GetPixels(scene.Window), expected);
  EXPECT_EQ(GetDepths(scene.Window, false), depths);
  EXPECT_EQ(scene.Rays->GetNumberOfRenderedProps(), rendered);
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), steps);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), nullptr);
}

TEST(GodRaysDelegate, WithDepthPeelingDrawsAsTheRenderer)
{
  Messages messages;
  Stage scene(Width, Height);
  Arrange(scene);
  scene.Renderer->AddActor(MakeGlass());
  scene.Renderer->UseDepthPeelingOn();
  const auto expected = GetPixels(scene.Window);
  scene.Renderer->UseDepthPeelingOff();
  scene.Rays->Detach(scene.Renderer);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkDualDepthPeelingPass> peeling;
  vtkNew<vtkTranslucentPass> translucent;
  peeling->SetTranslucentPass(translucent);
  steps->SetTranslucentPass(peeling);
  scene.Rays->SetDelegatePass(steps);
  scene.Rays->Attach(scene.Renderer);
  EXPECT_LE(GetLargestDifference(GetPixels(scene.Window), expected), 1);
}

TEST(GodRaysDelegate, ThatIsAFramebufferPassOrFXAAGivesRays)
{
  Messages messages;
  Stage scene(Width, Height);
  Arrange(scene);
  const auto expected = GetPixels(scene.Window);
  scene.Rays->Detach(scene.Renderer);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkOpenGLFXAAPass> smoothing;
  smoothing->SetDelegatePass(steps);
  scene.Rays->SetDelegatePass(smoothing);
  scene.Rays->Attach(scene.Renderer);
  EXPECT_LT(GetMeanDifference(GetPixels(scene.Window), expected), 2.0);
}

// By hand: Attach() puts rays under them.
TEST(GodRaysDelegate, ThatLeavesNoDepthIsToldOfOnce)
{
  const std::array<vtkSmartPointer<vtkImageProcessingPass>, 6> passes = {
    vtkSmartPointer<vtkDepthOfFieldPass>::New(), vtkSmartPointer<vtkFramebufferPass>::New(),
    vtkSmartPointer<vtkGaussianBlurPass>::New(), vtkSmartPointer<vtkToneMappingPass>::New(),
    vtkSmartPointer<vtkSobelGradientMagnitudePass>::New(),
    vtkSmartPointer<vtkSimpleMotionBlurPass>::New()
  };
  for (vtkImageProcessingPass* hiding : passes)
  {
    SCOPED_TRACE(hiding->GetClassName());
    for (const bool isMedium : { false, true })
    {
      Messages messages;
      Stage scene(Width, Height);
      Arrange(scene);
      scene.Rays->Detach(scene.Renderer);
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkOpenGLFXAAPass> smoothing; // which draws in place
      hiding->SetDelegatePass(steps);
      smoothing->SetDelegatePass(hiding);
      scene.Renderer->SetPass(smoothing);
      GetPixels(scene.Window); // some are another picture at first
      const auto expected = GetPixels(scene.Window);
      if (isMedium)
      {
        scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
      }
      scene.Rays->SetDelegatePass(smoothing);
      scene.Renderer->SetPass(scene.Rays);
      for (int i = 0; i < 2; ++i)
      {
        const auto picture = GetPixels(scene.Window);
        // by chance depth of field has one of two pictures, without rays, too
        EXPECT_TRUE(vtkDepthOfFieldPass::SafeDownCast(hiding) ||
          GetLargestDifference(picture, expected) <= 1);
      }
      EXPECT_TRUE(Says(scene.Rays->GetPlan(), "rays: none")) << scene.Rays->GetPlan();
      const auto said = messages.Take();
      ASSERT_EQ(said.size(), 1u);
      EXPECT_TRUE(Says(said[0], hiding->GetClassName())) << said[0];
      scene.Renderer->SetPass(nullptr);
      smoothing->ReleaseGraphicsResources(scene.Window);
      // the other way round there are rays
      hiding->SetDelegatePass(scene.Rays);
      scene.Rays->SetDelegatePass(nullptr);
      scene.Renderer->SetPass(hiding);
      scene.Window->Render();
      EXPECT_FALSE(Says(scene.Rays->GetPlan(), "no depth")) << scene.Rays->GetPlan();
      scene.Renderer->SetPass(nullptr);
      hiding->ReleaseGraphicsResources(scene.Window);
      messages.Take(); // a medium in oblong pixels
    }
    vtkNew<vtkGodRaysSkyPass> sky;
    Messages messages;
    Stage scene(Width, Height);
    Arrange(scene);
    scene.Rays->Detach(scene.Renderer);
    vtkNew<vtkRenderStepsPass> steps;
    hiding->SetDelegatePass(steps);
    sky->SetDelegatePass(hiding);
    scene.Renderer->SetPass(sky);
    scene.Window->Render();
    scene.Window->Render();
    const auto said = messages.Take();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(Says(said[0], hiding->GetClassName())) << said[0];
    scene.Renderer->SetPass(nullptr);
    hiding->ReleaseGraphicsResources(scene.Window);
  }
}

namespace
{
/// Draws the scene, then leaves OpenGL in a state in which little is drawn.
class UntidySteps : public vtkRenderStepsPass
{
public:
  static UntidySteps* New();
  vtkTypeMacro(UntidySteps, vtkRenderStepsPass);
  void Render(const vtkRenderState* s) override
  {
    this->Superclass::Render(s);
    auto window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(GL_FRONT_AND_BACK);
    state->vtkglDepthFunc(GL_NEVER);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglClearDepth(0.25);
    state->vtkglClearColor(1.0f, 0.0f, 1.0f, 1.0f);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(3, 3, 5, 5);
    state->vtkglViewport(3, 3, 5, 5);
    state->vtkglBlendFuncSeparate(GL_ZERO, GL_ONE, GL_ZERO, GL_ONE);
    state->vtkglActiveTexture(GL_TEXTURE5);
  }
};
vtkStandardNewMacro(UntidySteps);
}

// Props that are held back have stand-ins, to which passes for shaders add themselves, too.
TEST(GodRaysDelegate, IsReferredToAsOftenAfterEachFrame)
{
  Stage stage(Width, Height);
  auto sun = stage.AddPillarsAndSun();
  stage.Renderer->AddActor(MakeGlass());
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkTextActor> text;
    text->SetInput("held back");
    text->SetPosition(5.0, 5.0 + 20.0 * i);
    stage.Renderer->AddViewProp(text);
  }
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkOrderIndependentTranslucentPass> blended;
  vtkNew<vtkTranslucentPass> translucent;
  blended->SetTranslucentPass(translucent);
  steps->SetTranslucentPass(blended);
  stage.Rays->SetDelegatePass(steps);
  stage.Window->Render();
  ASSERT_FALSE(Says(stage.Rays->GetPlan(), "rays: none")) << stage.Rays->GetPlan();
  const int references = blended->GetReferenceCount();
  for (int i = 0; i < 3; ++i)
  {
    stage.Window->Render();
    EXPECT_EQ(blended->GetReferenceCount(), references);
  }
}

TEST(GodRaysDelegate, MayLeaveOpenGLInAnyState)
{
  Messages messages;
  Stage scene(Width, Height);
  Arrange(scene);
  for (bool drawsProps : { false, true }) // props into the layers, by which VTK tidies up
  {
    if (drawsProps)
    {
      auto lamp = MakeLamp({ 2.0, 1.0, -2.0 }, 0.5);
      vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
      scene.Renderer->AddActor(lamp);
      scene.Renderer->AddActor(MakeGlass());
      scene.Rays->SetLayerMargin(0.2);
    }
    std::vector<unsigned char> pictures[2];
    for (bool untidy : { false, true })
    {
      vtkNew<vtkRenderStepsPass> tidySteps;
      vtkNew<UntidySteps> untidySteps;
      scene.Rays->Detach(scene.Renderer);
      scene.Renderer->SetPass(untidy ? untidySteps : tidySteps);
      scene.Rays->Attach(scene.Renderer);
      pictures[untidy] = GetPixels(scene.Window);
      EXPECT_TRUE(Says(scene.Rays->GetPlan(), "blend: additive"));
      scene.Rays->Detach(scene.Renderer);
      scene.Renderer->SetPass(nullptr);
      auto state = vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetState();
      state->vtkglDisable(GL_CULL_FACE);
      state->vtkglCullFace(GL_BACK);
    }
    EXPECT_EQ(pictures[0], pictures[1]) << drawsProps;
  }
}
