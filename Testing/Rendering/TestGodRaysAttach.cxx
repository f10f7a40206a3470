// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Attach and Detach, objects that go away while attached, readbacks and times, and a framebuffer
// that cannot have rays.

#include "GodRaysTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextureObject.h"
#include "vtkToneMappingPass.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

using namespace GodRaysTesting;
using Pixels = std::vector<unsigned char>;

TEST(GodRaysAttach, KeepsWhatTheRendererHad)
{
  Messages messages;
  Stage scene;
  vtkNew<vtkRenderStepsPass> former;
  vtkNew<vtkRenderStepsPass> delegate;
  scene.Renderer->SetPass(former);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseSSAOOn();
  scene.Renderer->SetMaximumNumberOfPeels(7);
  scene.Rays->SetDelegatePass(delegate);

  scene.Rays->Attach(scene.Renderer);
  scene.Rays->Attach(scene.Renderer); // changes nothing
  EXPECT_EQ(scene.Renderer->GetPass(), scene.Rays);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), former);
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), former);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), delegate);
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), former) << "after the second Detach";
  EXPECT_EQ(scene.Rays->GetDelegatePass(), delegate);
  EXPECT_TRUE(scene.Renderer->GetUseDepthPeeling());
  EXPECT_TRUE(scene.Renderer->GetUseSSAO());
  EXPECT_EQ(scene.Renderer->GetMaximumNumberOfPeels(), 7);

  scene.Rays->Attach(nullptr);
  EXPECT_EQ(messages.Take().size(), 1u);
  scene.Rays->Detach(nullptr);
}

TEST(GodRaysAttach, OfTwoPassesEndsInEitherOrder)
{
  Messages messages;
  for (const bool outerFirst : { true, false })
  {
    Stage scene;
    auto sun = scene.AddPillarsAndSun();
    scene.Rays->Detach(scene.Renderer);
    const auto without = GetPixels(scene.Window);
    vtkNew<vtkGodRaysPass> outer;
    outer->AddLight(sun);
    scene.Rays->Attach(scene.Renderer);
    outer->Attach(scene.Renderer);
    EXPECT_NE(GetPixels(scene.Window), without);
    (outerFirst ? outer.Get() : scene.Rays)->Detach(scene.Renderer);
    EXPECT_NE(GetPixels(scene.Window), without) << "of the one that is left";
    (outerFirst ? scene.Rays : outer.Get())->Detach(scene.Renderer);
    EXPECT_EQ(GetPixels(scene.Window), without) << (outerFirst ? "outer first" : "inner first");
    EXPECT_EQ(scene.Renderer->GetPass(), nullptr);
  }
}

TEST(GodRaysAttach, IsToOneRendererAtATime)
{
  Messages messages;
  Stage a;
  Stage b;
  vtkNew<vtkRenderStepsPass> ofA;
  a.Renderer->SetPass(ofA);
  a.Rays->Attach(a.Renderer);
  a.Rays->Attach(b.Renderer);
  EXPECT_EQ(a.Renderer->GetPass(), ofA);
  EXPECT_EQ(b.Renderer->GetPass(), a.Rays);
  EXPECT_EQ(a.Rays->GetDelegatePass(), nullptr);
  a.Rays->Detach(a.Renderer); // is not attached there
  EXPECT_EQ(b.Renderer->GetPass(), a.Rays);
  a.Rays->Detach(b.Renderer);
  EXPECT_EQ(b.Renderer->GetPass(), nullptr);
}

TEST(GodRaysAttach, DetachTakesOffAPassThatWasSetWithoutAttach)
{
  Messages messages;
  Stage scene;
  Stage other;
  vtkNew<vtkRenderStepsPass> delegate;
  scene.Rays->SetDelegatePass(delegate);
  scene.Rays->AddLight(MakeSun({ 0.1, 0.1, -1.0 }));
  scene.Renderer->SetPass(scene.Rays);
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(scene.Rays->GetScatteringImage(image));
  scene.Rays->Detach(other.Renderer); // has it not
  EXPECT_EQ(scene.Renderer->GetPass(), scene.Rays);
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), nullptr);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), delegate);
  EXPECT_FALSE(scene.Rays->GetScatteringImage(image))
    << "what was on the graphics card is released";

  scene.Rays->Attach(scene.Renderer); // and as well by mistake on a second renderer
  other.Renderer->SetPass(scene.Rays);
  scene.Rays->Detach(other.Renderer);
  EXPECT_EQ(other.Renderer->GetPass(), nullptr);
  EXPECT_EQ(scene.Renderer->GetPass(), scene.Rays);
}

TEST(GodRaysAttach, APassThatIsItsOwnDelegateIsToldOnceAndTheSceneIsDrawnWithoutRays)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  scene.Rays->Detach(scene.Renderer);
  const auto plain = GetPixels(scene.Window);

  scene.Rays->SetDelegatePass(scene.Rays);
  scene.Rays->Attach(scene.Renderer);
  for (bool measured : { false, true })
  {
    scene.Rays->SetMeasureTimes(measured);
    EXPECT_EQ(plain, GetPixels(scene.Window));
    EXPECT_TRUE(Says(scene.Rays->GetPlan(), "rays: none, the delegate leads back"));
  }
  const auto said = messages.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], "leads back to it. Set another delegate")) << said[0];

  // attached where another pass has them for its delegate already, they stay there
  scene.Rays->Detach(scene.Renderer);
  scene.Rays->SetDelegatePass(nullptr);
  vtkNew<vtkToneMappingPass> outer;
  outer->SetDelegatePass(scene.Rays);
  scene.Renderer->SetPass(outer);
  scene.Rays->Attach(scene.Renderer);
  scene.Window->Render();
  EXPECT_EQ(scene.Renderer->GetPass(), outer);
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), "blend: additive"));
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), outer);
  EXPECT_EQ(outer->GetDelegatePass(), scene.Rays);
  outer->SetDelegatePass(nullptr);
}

TEST(GodRaysAttach, ForgetsARendererThatIsGone)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  vtkNew<vtkRenderStepsPass> delegate;
  rays->SetDelegatePass(delegate);
  rays->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
  vtkNew<vtkRenderStepsPass> former;
  std::vector<unsigned char> first;
  for (int i = 0; i < 4; ++i)
  {
    auto scene = std::make_unique<Stage>();
    scene->Renderer->AddActor(MakeBox({ 1.0, 0.5, 0.0 }, { 1.0, 1.0, 1.0 }));
    scene->Renderer->SetPass(i % 2 ? nullptr : former.Get());
    rays->Attach(scene->Renderer);
    EXPECT_EQ(rays->GetDelegatePass(), i % 2 ? delegate : former) << i;
    const auto picture = GetPixels(scene->Window);
    first = i ? first : picture;
    EXPECT_EQ(picture, first) << i;
    if (i == 2)
    {
      scene->Window->RemoveRenderer(scene->Renderer);
    }
  }
}

TEST(GodRaysAttach, KeepsThePassAliveWhileTheRendererIs)
{
  Messages messages;
  Stage scene;
  scene.Renderer->AddActor(MakeBox({ 1.0, 0.5, 0.0 }, { 1.0, 1.0, 1.0 }));
  const auto bare = GetPixels(scene.Window);
  {
    vtkNew<vtkGodRaysPass> rays;
    rays->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
    rays->Attach(scene.Renderer);
  }
  const auto lit = GetPixels(scene.Window);
  EXPECT_GT(CountDifferentPixels(lit, bare), 1000);
  {
    // the renderer's is the last reference
    auto rays = vtkGodRaysPass::SafeDownCast(scene.Renderer->GetPass());
    rays->Detach(scene.Renderer);
  }
  EXPECT_EQ(bare, GetPixels(scene.Window));

  vtkNew<vtkGodRaysPass> rays;
  rays->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
  rays->Attach(scene.Renderer);
  EXPECT_EQ(lit, GetPixels(scene.Window));
  scene.Renderer->SetPass(nullptr); // not Detach
  EXPECT_EQ(lit, GetPixels(scene.Window));
}

TEST(GodRaysAttach, OfAPassThatWasReplacedAndDroppedEnds)
{
  Messages messages;
  Stage scene;
  scene.Renderer->AddActor(MakeBox({ 1.0, 0.5, 0.0 }, { 1.0, 1.0, 1.0 }));
  const auto bare = GetPixels(scene.Window);
  std::vector<vtkWeakPointer<vtkGodRaysPass>> dropped;
  vtkSmartPointer<vtkGodRaysPass> last;
  Pixels once;
  for (int i = 0; i < 5; ++i)
  {
    last = vtkSmartPointer<vtkGodRaysPass>::New();
    dropped.emplace_back(last);
    AddPlainly(last);
    last->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
    scene.Renderer->SetPass(nullptr); // not Detach
    last->Attach(scene.Renderer);
    const auto picture = GetPixels(scene.Window);
    once = i == 0 ? picture : once;
    EXPECT_GT(CountDifferentPixels(picture, bare), 1000);
    EXPECT_EQ(picture, once) << i << ": former passes shine as well";
    EXPECT_EQ(std::count(dropped.begin(), dropped.end(), nullptr), i);
  }

  // one that the program has is attached still: both shine
  vtkNew<vtkGodRaysPass> another;
  AddPlainly(another);
  another->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
  scene.Renderer->SetPass(nullptr);
  another->Attach(scene.Renderer);
  EXPECT_GT(GetLargestDifference(GetPixels(scene.Window), once), 5);
  last->Detach(scene.Renderer);
  EXPECT_EQ(GetPixels(scene.Window), once);
}

TEST(GodRaysAttach, OfALookOverAMediumBothComeBackOrEndTogether)
{
  Messages messages;
  for (const bool lookIsFirst : { false, true })
  {
    SCOPED_TRACE(lookIsFirst ? "the look is attached first" : "the medium is attached first");
    Stage scene;
    scene.Renderer->AddActor(MakeBox({ 1.0, 0.5, 0.0 }, { 1.0, 1.0, 1.0 }));
    std::vector<vtkWeakPointer<vtkGodRaysPass>> dropped;
    for (const bool isLook : { lookIsFirst, !lookIsFirst })
    {
      const auto rays = vtkSmartPointer<vtkGodRaysPass>::New();
      rays->ApplyPreset(isLook ? "default" : "fog");
      AddPlainly(rays);
      rays->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
      rays->Attach(scene.Renderer);
      dropped.emplace_back(rays);
    }
    const auto both = GetPixels(scene.Window);

    scene.Renderer->SetPass(nullptr); // not Detach
    EXPECT_EQ(GetPixels(scene.Window), both);
    EXPECT_EQ(std::count(dropped.begin(), dropped.end(), nullptr), 0);
    EXPECT_EQ(GetPixels(scene.Window), both) << "in the next frame";

    vtkNew<vtkGodRaysPass> another;
    AddPlainly(another);
    another->AddLight(MakeSun({ 0.3, 0.2, -1.0 }));
    scene.Renderer->SetPass(nullptr);
    another->Attach(scene.Renderer);
    const auto last = GetPixels(scene.Window);
    EXPECT_EQ(std::count(dropped.begin(), dropped.end(), nullptr), 2);
    EXPECT_EQ(GetPixels(scene.Window), last) << "in the next frame";
    EXPECT_GT(GetLargestDifference(last, both), 5);
    Stage alone;
    alone.Renderer->AddActor(MakeBox({ 1.0, 0.5, 0.0 }, { 1.0, 1.0, 1.0 }));
    another->Detach(scene.Renderer);
    another->Attach(alone.Renderer);
    EXPECT_EQ(GetPixels(alone.Window), last) << "former passes shine as well";
  }
}

TEST(GodRaysAttach, NoticesANewContextOfItsWindow)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  const auto expected = GetPixels(scene.Window);
  scene.Renderer->SetPass(nullptr); // so that the pass does not hear of the end of the context
  scene.Window->Finalize();
  GetPixels(scene.Window);
  scene.Renderer->SetPass(scene.Rays);
  EXPECT_EQ(expected, GetPixels(scene.Window));
  EXPECT_EQ(expected, GetPixels(scene.Window));
}

TEST(GodRaysReadbacks, AreEmptyWithoutRays)
{
  Messages messages;
  Stage scene;
  const auto expectEmpty = [&scene](const char* when)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    EXPECT_FALSE(scene.Rays->GetOcclusionImage(image)) << when;
    EXPECT_EQ(image->GetNumberOfPoints(), 0) << when;
    image->SetDimensions(2, 2, 1);
    EXPECT_FALSE(scene.Rays->GetScatteringImage(image)) << when;
    EXPECT_EQ(image->GetNumberOfPoints(), 0) << when;
  };
  expectEmpty("before it is attached");
  scene.AddPillarsAndSun();
  expectEmpty("before a frame");
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(scene.Rays->GetOcclusionImage(image));
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(image->GetNumberOfScalarComponents(), 3);
  EXPECT_TRUE(scene.Rays->GetScatteringImage(image));
  EXPECT_FALSE(scene.Rays->GetScatteringImage(nullptr));
  EXPECT_FALSE(scene.Rays->GetOcclusionImage(nullptr));
  scene.Rays->SetIntensity(0.0);
  scene.Window->Render();
  expectEmpty("after a frame without rays");
  scene.Rays->SetIntensity(1.0);
  scene.Window->Render();
  scene.Rays->Detach(scene.Renderer);
  expectEmpty("after Detach");
}

TEST(GodRaysReadbacks, AddTheLayersOfAllLights)
{
  Messages messages;
  Stage scene;
  auto sun = scene.AddPillarsAndSun();
  scene.Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  auto other = MakeSun({ -0.2, 0.1, -1.0 }, { 0.2, 0.4, 1.0 });
  vtkNew<vtkImageData> layers[3];
  vtkNew<vtkImageData> rays[3];
  for (int i = 0; i < 3; ++i) // the first, the second, both
  {
    scene.Rays->RemoveAllLights();
    if (i != 1)
    {
      scene.Rays->AddLight(sun);
    }
    if (i != 0)
    {
      scene.Rays->AddLight(other);
    }
    scene.Window->Render();
    ASSERT_TRUE(scene.Rays->GetOcclusionImage(layers[i]));
    ASSERT_TRUE(scene.Rays->GetScatteringImage(rays[i]));
  }
  double worst = 0.0;
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        for (const auto images : { layers, rays })
        {
          worst = std::max(worst,
            std::abs(GetValue(images[0], x, y, c) + GetValue(images[1], x, y, c) -
              GetValue(images[2], x, y, c)));
        }
      }
    }
  }
  EXPECT_LT(worst, 1e-5);
}

TEST(GodRaysReadbacks, OfSeveralLightsAreNotOneOfThemWhereTheWindowCannotRenderOnceMore)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays;
  vtkNew<vtkImageData> image;
  {
    Stage scene;
    rays->AddLight(MakeSun({ 0.1, 0.1, -1.0 }));
    rays->AddLight(MakeSun({ -0.1, 0.1, -1.0 }));
    rays->Attach(scene.Renderer);
    int readbacks = 0;
    vtkNew<vtkCallbackCommand> duringRender;
    auto readBack = std::make_pair(rays.Get(), &readbacks);
    duringRender->SetClientData(&readBack);
    duringRender->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*)
      {
        auto both = static_cast<decltype(readBack)*>(data);
        vtkNew<vtkImageData> layer;
        EXPECT_FALSE(both->first->GetOcclusionImage(layer));
        EXPECT_EQ(layer->GetNumberOfPoints(), 0);
        ++*both->second;
      });
    scene.Renderer->AddObserver(vtkCommand::EndEvent, duringRender);
    scene.Window->Render();
    EXPECT_EQ(readbacks, 1);
    scene.Renderer->RemoveAllObservers();
    EXPECT_TRUE(rays->GetOcclusionImage(image));
    scene.Window->Render();
    scene.Renderer->SetPass(nullptr); // the pass is not told that the window goes
  }
  EXPECT_FALSE(rays->GetOcclusionImage(image));
}

TEST(GodRaysReadbacks, AreNothingAfterTheirMakerIsReplaced)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  scene.Rays->Attach(scene.Renderer);
  vtkNew<vtkImageData> image;
  vtkNew<vtkGodRaysRadialModel> model;
  vtkNew<vtkGodRaysTapsIntegrator> integrator;
  const std::function<void()> replacements[] = { [&] { scene.Rays->SetModel(model); },
    [&] { scene.Rays->SetIntegrator(integrator); } };
  for (const auto& replace : replacements)
  {
    scene.Window->Render();
    EXPECT_TRUE(scene.Rays->GetOcclusionImage(image));
    EXPECT_TRUE(scene.Rays->GetScatteringImage(image));
    replace();
    EXPECT_FALSE(scene.Rays->GetOcclusionImage(image) && scene.Rays->GetScatteringImage(image));
    EXPECT_EQ(image->GetNumberOfPoints(), 0);
  }
}

TEST(GodRaysStageTimes, AreThereWhenAskedFor)
{
  Messages messages;
  Stage scene;
  double times[4] = { 1.0, 1.0, 1.0, 1.0 };
  const auto sum = [&]
  {
    scene.Rays->GetStageTimes(times);
    return times[0] + times[1] + times[2] + times[3];
  };
  EXPECT_EQ(sum(), 0.0) << "before a frame";
  scene.AddPillarsAndSun();
  scene.Window->Render();
  EXPECT_EQ(sum(), 0.0) << "not measured";
  scene.Rays->MeasureTimesOn();
  scene.Window->Render();
  EXPECT_GT(sum(), 0.0);
  EXPECT_LT(sum(), 10.0);
  EXPECT_EQ(sum(), sum()) << "can be read again";
  for (const double time : times)
  {
    EXPECT_GE(time, 0.0);
  }
  EXPECT_GT(times[2], 0.0) << "the scattering is no small work";
  scene.Rays->SetIntensity(0.0);
  scene.Window->Render();
  EXPECT_EQ(sum(), 0.0) << "no stages";
  scene.Rays->SetIntensity(1.0);
  scene.Window->Render();
  EXPECT_GT(sum(), 0.0);
  scene.Rays->MeasureTimesOff();
  scene.Window->Render();
  EXPECT_EQ(sum(), 0.0);
}

namespace
{
/// Draws its delegate into a framebuffer without depth, then into the window.
class FlatPass : public vtkImageProcessingPass
{
public:
  static FlatPass* New();
  vtkTypeMacro(FlatPass, vtkImageProcessingPass);
  void Render(const vtkRenderState* s) override
  {
    auto window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    int size[2];
    s->GetWindowSize(size);
    this->Color->SetContext(window);
    this->Framebuffer->SetContext(window);
    if (!this->Color->GetHandle())
    {
      this->Color->Allocate2D(size[0], size[1], 4, VTK_UNSIGNED_CHAR);
    }
    state->PushFramebufferBindings();
    this->Framebuffer->Bind();
    this->Framebuffer->AddColorAttachment(0, this->Color);
    this->Framebuffer->ActivateDrawBuffer(0);
    this->Framebuffer->StartNonOrtho(size[0], size[1]);
    state->vtkglViewport(0, 0, size[0], size[1]);
    state->vtkglScissor(0, 0, size[0], size[1]);
    vtkRenderState flat(s->GetRenderer());
    flat.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
    flat.SetFrameBuffer(this->Framebuffer);
    this->DelegatePass->Render(&flat);
    state->PopFramebufferBindings();
    state->PushReadFramebufferBinding();
    this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->Framebuffer->ActivateReadBuffer(0);
    state->vtkglBlitFramebuffer(
      0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->PopReadFramebufferBinding();
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
  }

private:
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};
vtkStandardNewMacro(FlatPass);
}

TEST(GodRaysErrors, AFramebufferWithoutDepthIsToldOnceAndHasTheScene)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  const auto lit = GetPixels(scene.Window);
  scene.Rays->Detach(scene.Renderer);
  vtkNew<FlatPass> flat;
  flat->SetDelegatePass(scene.Rays);
  scene.Renderer->SetPass(flat);
  const auto picture = GetPixels(scene.Window);
  EXPECT_EQ(picture, GetPixels(scene.Window));
  const auto said = messages.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("without god rays"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("with a depth buffer"), std::string::npos) << said[0];
  EXPECT_NE(scene.Rays->GetPlan().find("none, after an error"), std::string::npos);
  vtkNew<vtkImageData> image;
  EXPECT_FALSE(scene.Rays->GetScatteringImage(image));
  scene.Rays->SetIntensity(0.0);
  EXPECT_EQ(picture, GetPixels(scene.Window));
  // in a window with depth there are rays again
  scene.Rays->SetIntensity(1.0);
  scene.Renderer->SetPass(nullptr);
  flat->ReleaseGraphicsResources(scene.Window);
  scene.Rays->Attach(scene.Renderer);
  EXPECT_EQ(lit, GetPixels(scene.Window));
}

TEST(GodRaysErrors, PicturesBeyondATextureAreToldOnceWithTheRemedy)
{
  Messages messages;
  Stage scene(64, 16);
  scene.AddPillarsAndSun();
  scene.Window->Render();
  const int largest =
    vtkTextureObject::GetMaximumTextureSize(vtkOpenGLRenderWindow::SafeDownCast(scene.Window));
  scene.Window->SetSize(largest / 2, 16);
  scene.Rays->SetIntensity(0.0);
  const auto expected = GetPixels(scene.Window);
  scene.Rays->SetIntensity(1.0);
  scene.Rays->SetLayerMargin(0.5); // as large as a texture
  EXPECT_NE(GetPixels(scene.Window), expected);
  EXPECT_TRUE(messages.Take().empty());
  scene.Rays->SetLayerMargin(0.501);
  EXPECT_EQ(GetPixels(scene.Window), expected);
  EXPECT_EQ(GetPixels(scene.Window), expected);
  scene.Window->SetSize(largest / 2 + 7, 16); // another size, the same cause
  scene.Window->Render();
  const std::string remedy = "Set a smaller LayerMargin";
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), remedy)) << scene.Rays->GetPlan();
  const auto said = messages.Take();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(Says(said[0], remedy)) << said[0];
}
