// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The rays among other passes of a renderer, set before and after them by somebody who does not know of
// them, as PyVista and vedo do.

#include "GodRaysTesting.h"

#include "vtkCameraPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkGaussianBlurPass.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numeric>
#include <string>
#include <vector>

using namespace GodRaysTesting;

namespace
{
/// Passes that are set on a renderer by somebody who does not know of the rays.
struct Others
{
  const char* Name;
  std::function<vtkSmartPointer<vtkRenderPass>()> Make;
};

template <typename Pass>
vtkSmartPointer<vtkRenderPass> MakeOver(vtkRenderPass* drawn)
{
  auto pass = vtkSmartPointer<Pass>::New();
  pass->SetDelegatePass(drawn);
  return pass;
}

vtkSmartPointer<vtkRenderPass> MakeSequence(std::initializer_list<vtkRenderPass*> members)
{
  vtkNew<vtkRenderPassCollection> passes;
  for (vtkRenderPass* each : members)
  {
    passes->AddItem(each);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  return MakeOver<vtkCameraPass>(sequence);
}

vtkSmartPointer<vtkRenderPass> MakeSteps()
{
  return vtkSmartPointer<vtkRenderStepsPass>::New();
}

/// In focus is what the camera looks at. The automatic distance comes from the driver in a later frame: in
/// which one depends on how busy the machine is.
vtkSmartPointer<vtkRenderPass> MakeDepthOfField(vtkRenderPass* drawn)
{
  auto pass = vtkSmartPointer<vtkDepthOfFieldPass>::New();
  pass->SetDelegatePass(drawn);
  pass->AutomaticFocalDistanceOff();
  return pass;
}

const Others AllOthers[] = {
  { "nothing", [] { return vtkSmartPointer<vtkRenderPass>(); } },
  { "steps", MakeSteps },
  { "SSAA", [] { return MakeOver<vtkSSAAPass>(MakeSteps()); } },
  { "FXAA", [] { return MakeOver<vtkOpenGLFXAAPass>(MakeSteps()); } },
  { "blur", [] { return MakeOver<vtkGaussianBlurPass>(MakeSteps()); } },
  { "SSAO", [] { return MakeOver<vtkSSAOPass>(MakeSteps()); } },
  { "EDL", [] { return MakeOver<vtkEDLShading>(MakeSteps()); } },
  { "depth of field", [] { return MakeDepthOfField(MakeSteps()); } },
  { "SSAA over SSAO", [] { return MakeOver<vtkSSAAPass>(MakeOver<vtkSSAOPass>(MakeSteps())); } },
  { "shadows",
    []
    {
      vtkNew<vtkShadowMapPass> shadows;
      return MakeSequence({ shadows->GetShadowMapBakerPass(), shadows });
    } },
  { "depth of field in a sequence",
    []
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      return MakeSequence({ lights, MakeDepthOfField(MakeOver<vtkCameraPass>(opaque)) });
    } },
  { "SSAO in a sequence",
    []
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      return MakeSequence({ lights, MakeOver<vtkSSAOPass>(MakeOver<vtkCameraPass>(opaque)) });
    } },
};

/// The light that rays add to a scene [levels], and how like that of another scene it is, 1 for the same.
std::vector<double> GetAdded(Stage& scene)
{
  const auto lit = GetPixels(scene.Window);
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), "blend: additive")) << scene.Rays->GetPlan();
  scene.Rays->SetIntensity(0.0);
  const auto bare = GetPixels(scene.Window);
  scene.Rays->SetIntensity(1.0);
  std::vector<double> added;
  for (std::size_t i = 0; i < lit.size(); i += 4)
  {
    added.push_back(static_cast<double>(lit[i]) - bare[i]);
  }
  return added;
}

double GetMean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double GetCorrelation(const std::vector<double>& a, const std::vector<double>& b)
{
  const double meanA = GetMean(a);
  const double meanB = GetMean(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
  }
  return ab / std::sqrt(aa * bb);
}

void PrintTo(const Others& others, std::ostream* os)
{
  *os << others.Name;
}

class GodRaysAmong : public ::testing::TestWithParam<Others>
{
};

std::string NameOf(const ::testing::TestParamInfo<Others>& info)
{
  std::string name = info.param.Name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}
}

TEST_P(GodRaysAmong, StayWhicheverIsSetFirst)
{
  Messages messages;
  Stage plain;
  plain.AddPillarsAndSun();
  const auto expected = GetAdded(plain);
  ASSERT_GT(GetMean(expected), 5.0);

  // One scene and one pass for both: VTK's depth of field does not show the same in another one, each time.
  Stage scene;
  scene.AddPillarsAndSun();
  scene.Rays->Detach(scene.Renderer);
  const auto others = GetParam().Make();
  std::vector<unsigned char> pictures[2];
  for (bool raysFirst : { false, true })
  {
    if (raysFirst)
    {
      scene.Renderer->SetPass(nullptr);
      scene.Rays->Attach(scene.Renderer);
      scene.Window->Render();
    }
    scene.Renderer->SetPass(others);
    if (!raysFirst)
    {
      scene.Rays->Attach(scene.Renderer);
    }
    EXPECT_EQ(vtkGodRaysPass::Find(scene.Renderer), scene.Rays);
    scene.Window->Render(); // VTK's depth of field shows the scene from its second frame on
    pictures[raysFirst] = GetPixels(scene.Window);
    const auto added = GetAdded(scene);
    EXPECT_NEAR(GetMean(added), GetMean(expected), 0.15 * GetMean(expected));
    EXPECT_GT(GetCorrelation(added, expected), 0.95) << "the pillars cast other shadows";

    scene.Rays->Detach(scene.Renderer);
    EXPECT_EQ(scene.Renderer->GetPass(), others);
    EXPECT_EQ(vtkGodRaysPass::Find(scene.Renderer), nullptr);
    EXPECT_NE(GetPixels(scene.Window), pictures[raysFirst]);
  }
  if (others)
  {
    others->ReleaseGraphicsResources(scene.Window);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

INSTANTIATE_TEST_SUITE_P(Passes, GodRaysAmong, ::testing::ValuesIn(AllOthers), NameOf);

// VTK draws 16 pixels more on each side with the aspect of the window: pixels are oblong, the more so the
// more the window is. The pillars and the fog are there; a warning says why the shafts are not.
TEST(GodRaysAmongPasses, OfAMediumUnderDepthOfFieldNeedSquarePixels)
{
  const struct
  {
    int Size[2];
    bool HasRays;
  } windows[] = { { { 128, 128 }, true }, { { 600, 450 }, true }, { { 150, 110 }, false },
    { { 600, 200 }, false } };
  for (const auto& each : windows)
  {
    Messages messages;
    Stage scene(each.Size[0], each.Size[1]);
    scene.AddPillarsAndSun();
    scene.Rays->Detach(scene.Renderer);
    const auto pass = MakeDepthOfField(MakeSteps());
    scene.Renderer->SetPass(pass);
    vtkNew<vtkGodRaysHomogeneousModel> fog;
    fog->ApplyPreset("fog");
    scene.Rays->SetModel(fog);
    scene.Rays->Attach(scene.Renderer);
    for (int frame = 0; frame < 3; ++frame)
    {
      scene.Window->Render();
    }
    vtkNew<vtkImageData> light;
    EXPECT_EQ(scene.Rays->GetScatteringImage(light), each.HasRays) << each.Size[0];
    const auto said = messages.Take();
    ASSERT_EQ(said.size(), each.HasRays ? 0u : 1u);
    if (each.HasRays)
    {
      EXPECT_GT(GetMean(light), 0.0);
    }
    else
    {
      EXPECT_TRUE(Says(said[0], "its pixels are oblong")) << said[0];
      EXPECT_TRUE(Says(said[0], "a window of another shape under a vtkDepthOfFieldPass"))
        << said[0];
      const auto picture = GetPixels(scene.Window);
      scene.Rays->Detach(scene.Renderer);
      EXPECT_EQ(GetLargestDifference(GetPixels(scene.Window), picture), 0);
    }
    pass->ReleaseGraphicsResources(scene.Window);
  }
}

TEST(GodRaysAmongPasses, StayWithASkyWhenTheirPassesAreReplaced)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(scene.Renderer);
  sky->SetSunElevation(10.0);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), sky);
  const auto expected = GetPixels(scene.Window);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  EXPECT_EQ(vtkGodRaysSkyPass::Attach(scene.Renderer), sky);
  EXPECT_EQ(expected, GetPixels(scene.Window));
  EXPECT_EQ(scene.Renderer->GetPass(), scene.Rays);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), sky);
  EXPECT_EQ(sky->GetDelegatePass(), steps);
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(expected, GetPixels(scene.Window));
  EXPECT_EQ(sky->GetDelegatePass(), nullptr);

  // each can go first, also when the passes of both were replaced
  scene.Renderer->SetPass(steps);
  EXPECT_TRUE(vtkGodRaysSkyPass::Detach(scene.Renderer));
  EXPECT_FALSE(vtkGodRaysSkyPass::Detach(scene.Renderer));
  EXPECT_NE(expected, GetPixels(scene.Window));
  EXPECT_EQ(scene.Rays->GetDelegatePass(), steps);
  sky = vtkGodRaysSkyPass::Attach(scene.Renderer);
  scene.Rays->Detach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), sky);
  EXPECT_EQ(sky->GetDelegatePass(), steps);
  EXPECT_TRUE(vtkGodRaysSkyPass::Detach(scene.Renderer));
  EXPECT_EQ(scene.Renderer->GetPass(), steps);
}

TEST(GodRaysAmongPasses, ASkyKeepsTheDelegateThatTheRaysWereGiven)
{
  Messages messages;
  Stage scene;
  vtkNew<vtkRenderStepsPass> given;
  scene.Rays->Detach(scene.Renderer);
  scene.Rays->SetDelegatePass(given);
  scene.Rays->Attach(scene.Renderer);
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(scene.Renderer);
  EXPECT_EQ(scene.Rays->GetDelegatePass(), sky);
  EXPECT_EQ(sky->GetDelegatePass(), given);
  EXPECT_TRUE(vtkGodRaysSkyPass::Detach(scene.Renderer));
  EXPECT_EQ(scene.Rays->GetDelegatePass(), given);
}
