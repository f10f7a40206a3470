// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// A driver that refuses one thing after another: each shader that the passes compile, each framebuffer
// that they ask for. The scene is as without them, in colour and depth, and each cause is told once.

#include "CountOpenGLCalls.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSkyPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace GodRaysTesting;

namespace
{
constexpr int Never = -1;
int Shaders = 0;           // given to the driver
int RefusedShader = Never; // the first one is 0
std::vector<std::string> ShaderTexts;
int Framebuffers = 0; // asked for
int RefusedFramebuffers = Never;
std::string Broken;

const GLchar* const* Hand(const GLchar* const* texts, GLsizei number)
{
  static const GLchar* broken = nullptr;
  Broken.clear();
  for (GLsizei i = 0; i < number; ++i)
  {
    Broken += texts[i];
  }
  ShaderTexts.push_back(Broken);
  if (Shaders++ != RefusedShader || number != 1)
  {
    return texts;
  }
  Broken += "\nthis is no GLSL\n";
  broken = Broken.c_str();
  return &broken;
}

GLenum (*RealStatus)(GLenum) = nullptr;
GLenum GetStatus(GLenum target)
{
  const int number = Framebuffers++;
  return RefusedFramebuffers != Never && number >= RefusedFramebuffers ? GL_FRAMEBUFFER_UNSUPPORTED
                                                                       : RealStatus(target);
}
}

COUNT_CALLS(ShaderSource, (GLuint s, GLsizei n, const GLchar* const* t, const GLint* l),
  (s, n, t, Shaders - 1 == RefusedShader ? nullptr : l), t = Hand(t, n))

namespace
{
/// Refuse from now on, in this window. The loader sets its pointers anew whenever one is initialized.
void Install(vtkRenderWindow* window)
{
  vtkOpenGLRenderWindow::SafeDownCast(window)->Initialize();
  INSTALL_COUNT(ShaderSource)
  if (glCheckFramebufferStatus && glCheckFramebufferStatus != GetStatus)
  {
    RealStatus = glCheckFramebufferStatus;
    glCheckFramebufferStatus = GetStatus;
  }
  Shaders = 0;
  Framebuffers = 0;
  ShaderTexts.clear();
}

struct Kind
{
  const char* Name;
  std::function<void(Stage&)> Arrange;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

void AddFog(Stage& scene)
{
  scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
}

const Kind Kinds[] = {
  { "Plain", [](Stage&) {} },
  { "InShaders",
    [](Stage& scene)
    {
      auto integrator = vtkGodRaysEpipolarIntegrator::SafeDownCast(scene.Rays->GetIntegrator());
      integrator->SetBackend(vtkGodRaysEpipolarIntegrator::GRAPHICS);
    } },
  { "Taps", [](Stage& scene) { SumTaps(scene.Rays); } },
  { "Published", [](Stage& scene) { scene.Rays->ApplyPreset("published:three.js"); } },
  { "All",
    [](Stage& scene)
    {
      auto box = MakeBox({ 1.0, 0.0, 2.0 }, { 2.0, 1.0, 0.1 });
      vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
      scene.Renderer->AddActor(box);
      auto lamp = MakeLamp({ 2.0, 1.0, -2.0 }, 0.5);
      vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
      scene.Renderer->AddActor(lamp);
      auto glass = MakeBox({ 1.0, 0.5, 1.5 }, { 3.0, 2.0, 0.2 });
      glass->GetProperty()->SetOpacity(0.4);
      scene.Renderer->AddActor(glass);
      scene.Rays->AddLight(MakeLamplight({ 1.0, 1.0, -3.0 }));
      scene.Window->SetMultiSamples(4);
      scene.Rays->SetLayerMargin(0.25);
    } },
  { "Medium", AddFog },
  { "MediumInShaders",
    [](Stage& scene)
    {
      AddFog(scene);
      vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
      integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
      integrator->SetMapSize(64);
      scene.Rays->SetIntegrator(integrator);
    } },
  { "Sky", [](Stage&) {} },
};

/// A scene of a kind, without rays at first.
struct World : Stage
{
  explicit World(const Kind& kind)
    : Stage(64, 48)
    , IsSky(std::string(kind.Name) == "Sky")
  {
    this->AddPillarsAndSun();
    kind.Arrange(*this);
    this->Rays->Detach(this->Renderer);
    this->Without = GetPixels(this->Window);
    this->Depths = GetDepths(this->Window);
    Install(this->Window);
  }

  void Attach()
  {
    if (this->IsSky)
    {
      this->Sky = vtkGodRaysSkyPass::Attach(this->Renderer);
      this->Sky->SetMultipleScattering(false);
      this->Sky->SetWorldUnitInMeters(1000.0);
      return;
    }
    this->Rays->Attach(this->Renderer);
  }

  /// Three frames, of which the last is shown.
  std::vector<unsigned char> Draw()
  {
    std::vector<unsigned char> picture;
    for (int frame = 0; frame < 3; ++frame)
    {
      picture = GetPixels(this->Window);
    }
    while (glGetError() != GL_NO_ERROR) // of what was refused
    {
    }
    return picture;
  }

  /// The picture of three frames is that without rays, though something was refused.
  void ExpectSceneAlone(Messages& messages)
  {
    const auto picture = this->Draw();
    std::vector<std::string> ours;
    for (const std::string& said : messages.Take())
    {
      if (Says(said, "is drawn without"))
      {
        ours.push_back(said);
      }
    }
    EXPECT_EQ(ours.size(), 1u) << (ours.size() > 1 ? ours[0] + ours[1] : "");
    EXPECT_EQ(CountDifferentPixels(picture, this->Without), 0);
    EXPECT_EQ(GetDepths(this->Window, false), this->Depths);
  }

  bool IsSky;
  vtkGodRaysSkyPass* Sky = nullptr;
  std::vector<unsigned char> Without;
  std::vector<float> Depths;
};

class GodRaysFaults : public ::testing::TestWithParam<Kind>
{
protected:
  void TearDown() override
  {
    RefusedShader = Never;
    RefusedFramebuffers = Never;
  }
};

/// Shaders that were refused already, with another kind.
std::set<std::string> Tried;
}

TEST_P(GodRaysFaults, OfAnyShaderLeaveTheSceneAsWithoutRays)
{
  std::vector<std::string> texts;
  {
    Messages messages;
    World world(GetParam());
    world.Attach();
    EXPECT_GT(CountDifferentPixels(world.Draw(), world.Without), 100);
    texts = ShaderTexts;
  }
  ASSERT_GE(texts.size(), 2u); // a pass's, of vertices and of fragments
  int refused = 0;
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    // Of a mapper's shader that does not compile VTK 9.1 makes a crash, also in a scene without rays.
    const bool isMappers = texts[i].find("ambientColor") != std::string::npos;
    const bool isFragment = texts[i].find("gl_Position") == std::string::npos;
    if (isMappers || !isFragment || !Tried.insert(texts[i]).second)
    {
      continue;
    }
    SCOPED_TRACE("shader " + std::to_string(i) + ":\n" + texts[i].substr(0, 200) + " ... " +
      texts[i].substr(texts[i].size() - std::min<std::size_t>(texts[i].size(), 300)));
    Messages messages;
    World world(GetParam());
    RefusedShader = static_cast<int>(i);
    world.Attach();
    world.ExpectSceneAlone(messages);
    ++refused;
  }
  std::cout << refused << " shaders of " << texts.size() << "\n";
}

TEST_P(GodRaysFaults, OfFramebuffersLeaveTheSceneAsWithoutRays)
{
  int number = 0;
  {
    Messages messages;
    World world(GetParam());
    world.Attach();
    Framebuffers = 0;
    world.Window->Render();
    number = Framebuffers;
  }
  std::cout << number << " framebuffers\n";
  ASSERT_GT(number, 0);
  for (int i = 0; i < number; ++i)
  {
    SCOPED_TRACE("framebuffers from number " + std::to_string(i) + " on");
    Messages messages;
    World world(GetParam());
    // VTK's own are refused, too, without which VTK 9.6 resolves samples in another way.
    RefusedFramebuffers = 0;
    world.Without = world.Draw();
    RefusedFramebuffers = Never;
    world.Attach();
    Framebuffers = 0;
    RefusedFramebuffers = i;
    world.ExpectSceneAlone(messages);
    RefusedFramebuffers = Never;
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, GodRaysFaults, ::testing::ValuesIn(Kinds), [](const auto& info) { return info.param.Name; });
