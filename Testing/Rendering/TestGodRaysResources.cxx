// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What is made on the graphics card, counted where OpenGL is called, so that VTK's own work counts
// as well: a steady frame makes nothing, no number needs a new shader, and nothing is left behind.

#include "CountOpenGLCalls.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSkyPass.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"

#include <algorithm>
#include <functional>
#include <string>

using namespace GodRaysTesting;

namespace
{
/// Calls so far, and objects that are alive.
struct Counts
{
  int Shaders = 0;  // compiled
  int Programs = 0; // linked
  int Images = 0;   // textures given a size
  int Buffers = 0;  // filled
  int Objects = 0;  // all but queries, of which timers take new ones every time
  int Textures = 0; // alive, as all below
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int VertexArrays = 0;
  int Queries = 0; // VTK's mappers make some after a hundred frames
  int Uploads = 0; // into textures
  int Reads = 0;   // of textures and framebuffers

  int GetMade() const
  {
    return this->Shaders + this->Programs + this->Images + this->Buffers + this->Objects;
  }
  bool AliveAs(const Counts& other) const
  {
    return this->Textures == other.Textures && this->Framebuffers == other.Framebuffers &&
      this->Renderbuffers == other.Renderbuffers && this->VertexArrays == other.VertexArrays;
  }
  Counts operator-(const Counts& other) const
  {
    Counts c = *this;
    c.Shaders -= other.Shaders;
    c.Programs -= other.Programs;
    c.Images -= other.Images;
    c.Buffers -= other.Buffers;
    c.Objects -= other.Objects;
    c.Textures -= other.Textures;
    c.Framebuffers -= other.Framebuffers;
    c.Renderbuffers -= other.Renderbuffers;
    c.VertexArrays -= other.VertexArrays;
    c.Queries -= other.Queries;
    c.Uploads -= other.Uploads;
    c.Reads -= other.Reads;
    return c;
  }
};

std::ostream& operator<<(std::ostream& os, const Counts& c)
{
  return os << c.Shaders << " shaders, " << c.Programs << " programs, " << c.Images << " images, "
            << c.Buffers << " buffers, " << c.Objects << " objects; alive: " << c.Textures
            << " textures, " << c.Framebuffers << " framebuffers, " << c.Renderbuffers
            << " renderbuffers, " << c.VertexArrays << " vertex arrays, " << c.Queries
            << " queries";
}

Counts Now;
GLint RefusedFormat = 0; // of textures that are not made

/// A compiler's warnings reach users' screens: where OpenGL has a debug output, VTK prints it.
void ExpectNoWarning(GLuint program)
{
  GLuint shaders[4];
  GLsizei count = 0;
  glGetAttachedShaders(program, 4, &count, shaders);
  for (int i = 0; i < count; ++i)
  {
    char log[4096] = "";
    glGetShaderInfoLog(shaders[i], sizeof(log), nullptr, log);
    EXPECT_EQ(std::string(log).find("warning"), std::string::npos) << log;
  }
}

}

COUNT_CALLS(CompileShader, (GLuint s), (s), ++Now.Shaders)
COUNT_CALLS(LinkProgram, (GLuint p), (p), (++Now.Programs, ExpectNoWarning(p)))
COUNT_CALLS(
  BufferData, (GLenum t, GLsizeiptr s, const void* d, GLenum u), (t, s, d, u), ++Now.Buffers)
COUNT_CALLS(
  GenFramebuffers, (GLsizei n, GLuint* f), (n, f), (Now.Framebuffers += n, Now.Objects += n))
COUNT_CALLS(DeleteFramebuffers, (GLsizei n, const GLuint* f), (n, f), Now.Framebuffers -= n)
COUNT_CALLS(
  GenRenderbuffers, (GLsizei n, GLuint* f), (n, f), (Now.Renderbuffers += n, Now.Objects += n))
COUNT_CALLS(DeleteRenderbuffers, (GLsizei n, const GLuint* f), (n, f), Now.Renderbuffers -= n)
COUNT_CALLS(
  GenVertexArrays, (GLsizei n, GLuint* f), (n, f), (Now.VertexArrays += n, Now.Objects += n))
COUNT_CALLS(DeleteVertexArrays, (GLsizei n, const GLuint* f), (n, f), Now.VertexArrays -= n)
COUNT_CALLS(GenQueries, (GLsizei n, GLuint* f), (n, f), Now.Queries += n)
COUNT_CALLS(DeleteQueries, (GLsizei n, const GLuint* f), (n, f), Now.Queries -= n)
COUNT_CALLS(TexImage2DMultisample,
  (GLenum t, GLsizei n, GLenum i, GLsizei w, GLsizei h, GLboolean f), (t, n, i, w, h, f),
  ++Now.Images)
COUNT_CALLS_1_1(TexImage2D,
  (GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height, GLint border,
    GLenum format, GLenum type, const void* pixels),
  (target, level, internalFormat, width, height, border, format, type, pixels),
  (++Now.Images,
    width = internalFormat == RefusedFormat ? -1 : width)) // which is an error of OpenGL's
COUNT_CALLS_1_1(TexSubImage2D,
  (GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
    GLenum type, const void* pixels),
  (target, level, x, y, width, height, format, type, pixels), ++Now.Uploads)
COUNT_CALLS_1_1(ReadPixels,
  (GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels),
  (x, y, width, height, format, type, pixels), ++Now.Reads)
COUNT_CALLS_1_1(GetTexImage, (GLenum target, GLint level, GLenum format, GLenum type, void* pixels),
  (target, level, format, type, pixels), ++Now.Reads)
COUNT_CALLS_1_1(GenTextures, (GLsizei n, GLuint* t), (n, t), (Now.Textures += n, Now.Objects += n))
COUNT_CALLS_1_1(DeleteTextures, (GLsizei n, const GLuint* t), (n, t), Now.Textures -= n)

namespace
{
/// Count from now on in this window. The loader sets its pointers anew whenever a window is initialized.
void Count(vtkRenderWindow* window)
{
  vtkOpenGLRenderWindow::SafeDownCast(window)->Initialize();
  INSTALL_COUNT(CompileShader)
  INSTALL_COUNT(LinkProgram)
  INSTALL_COUNT(BufferData)
  INSTALL_COUNT(GenFramebuffers)
  INSTALL_COUNT(DeleteFramebuffers)
  INSTALL_COUNT(GenRenderbuffers)
  INSTALL_COUNT(DeleteRenderbuffers)
  INSTALL_COUNT(GenVertexArrays)
  INSTALL_COUNT(DeleteVertexArrays)
  INSTALL_COUNT(GenQueries)
  INSTALL_COUNT(DeleteQueries)
  INSTALL_COUNT(TexImage2DMultisample)
  INSTALL_COUNT_1_1(TexImage2D)
  INSTALL_COUNT_1_1(TexSubImage2D)
  INSTALL_COUNT_1_1(ReadPixels)
  INSTALL_COUNT_1_1(GetTexImage)
  INSTALL_COUNT_1_1(GenTextures)
  INSTALL_COUNT_1_1(DeleteTextures)
}

/// What one frame makes.
Counts Draw(Stage& scene)
{
  const Counts before = Now;
  scene.Window->Render();
  return Now - before;
}
}

namespace
{
struct Kind
{
  const char* Name;
  std::function<void(Stage&)> Arrange;
  int Objects = 0;    // that VTK makes more in every frame
  bool Grows = false; // textures grow as more is asked for, and stay
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

void AddIgnored(Stage& scene)
{
  auto box = MakeBox({ 1.0, 0.0, 2.0 }, { 2.0, 1.0, 0.1 });
  vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
  scene.Renderer->AddActor(box);
}

void AddShiningProp(Stage& scene)
{
  auto lamp = MakeLamp({ 2.0, 1.0, -2.0 }, 0.5);
  vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
  scene.Renderer->AddActor(lamp);
}

void AddLights(Stage& scene)
{
  scene.Rays->AddLight(MakeSun({ -0.2, 0.1, -1.0 }, { 0.2, 0.4, 1.0 }));
  scene.Rays->AddLight(MakeLamplight({ 1.0, 1.0, -3.0 }));
}

void UseShaders(Stage& scene)
{
  auto integrator = vtkGodRaysEpipolarIntegrator::SafeDownCast(scene.Rays->GetIntegrator());
  integrator->SetBackend(vtkGodRaysEpipolarIntegrator::GRAPHICS);
}

void AddAll(Stage& scene)
{
  AddIgnored(scene);
  AddShiningProp(scene);
  AddLights(scene);
  scene.Window->SetMultiSamples(8);
  scene.Rays->SetLayerMargin(0.25);
}

const Kind Kinds[] = {
  { "Plain", [](Stage&) {} },
  { "InShaders", UseShaders, 0, true },
  { "Taps", [](Stage& scene) { SumTaps(scene.Rays); } },
  { "Tagged", AddIgnored },
  { "ShiningProp", AddShiningProp },
  { "Lights", AddLights },
  { "LightsAndTheirLayers",
    [](Stage& scene)
    {
      AddLights(scene);
      scene.Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
    } },
  { "Translucent",
    [](Stage& scene)
    {
      auto glass = MakeBox({ 1.0, 0.5, 1.5 }, { 3.0, 2.0, 0.2 });
      glass->GetProperty()->SetOpacity(0.4);
      scene.Renderer->AddActor(glass);
      scene.Renderer->UseDepthPeelingOn();
    },
    1 }, // a mapper's vertex array, as the prop is drawn now with, now without the peeling's shader
  { "Margin", [](Stage& scene) { scene.Rays->SetLayerMargin(0.25); } },
  { "MultiSamples", [](Stage& scene) { scene.Window->SetMultiSamples(8); } },
  { "ThreePasses", [](Stage& scene) { scene.Rays->ApplyPreset("published:three.js"); } },
  { "Timed", [](Stage& scene) { scene.Rays->MeasureTimesOn(); } },
  { "All", AddAll },
  { "AllInShaders",
    [](Stage& scene)
    {
      AddAll(scene);
      UseShaders(scene);
    },
    0, true },
};

class GodRaysSteadyFrame : public ::testing::TestWithParam<Kind>
{
};
}

TEST_P(GodRaysSteadyFrame, MakesNothing)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  Count(scene.Window);
  scene.Rays->Detach(scene.Renderer);
  const Counts bare = Draw(scene); // and so the counters work
  EXPECT_GT(bare.Shaders, 1) << bare;
  EXPECT_GT(bare.Programs, 0) << bare;
  EXPECT_GT(bare.Images, 1) << bare;
  EXPECT_GT(bare.Buffers, 2) << bare;
  EXPECT_GT(bare.Framebuffers, 1) << bare;
  // depth peeling makes objects every time
  const int own = Draw(scene).GetMade() + GetParam().Objects;
  scene.Rays->Attach(scene.Renderer);
  const Counts first = Draw(scene);
  EXPECT_GE(first.Shaders, 4) << first;
  EXPECT_GE(first.Images, 4) << first;
  EXPECT_GE(first.Framebuffers, 3) << first;
  for (int frame = 2; frame < 5; ++frame)
  {
    const Counts steady = Draw(scene);
    EXPECT_EQ(steady.GetMade(), own) << "frame " << frame << ": " << steady;
    EXPECT_TRUE(steady.AliveAs(Counts())) << "frame " << frame << ": " << steady;
  }
}

TEST_P(GodRaysSteadyFrame, NeedsNoShaderForANumber)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  Count(scene.Window);
  EXPECT_GT(Draw(scene).Shaders, 0);
  scene.Rays->Detach(scene.Renderer);
  scene.Window->Render();
  const int own = Draw(scene).GetMade() + GetParam().Objects;
  scene.Rays->Attach(scene.Renderer);
  scene.Window->Render();

  vtkGodRaysPass* rays = scene.Rays;
  auto model = vtkGodRaysRadialSumModel::SafeDownCast(rays->GetModel());
  auto published = vtkGodRaysPublishedModel::SafeDownCast(model);
  vtkLight* sun = rays->GetLight(0);
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "Intensity", [=] { rays->SetIntensity(0.7); } },
    { "ErrorTolerance", [=] { rays->SetErrorTolerance(0.01); } },
    { "SunAngularRadius", [=] { rays->SetSunAngularRadius(2.0); } },
    { "SourceRadius", [=] { rays->SetSourceRadius(0.5); } },
    { "BackgroundGlow", [=] { rays->SetBackgroundGlow(0.3); } },
    { "BackgroundGlowRadius", [=] { rays->SetBackgroundGlowRadius(5.0); } },
    { "BackgroundGlowFalloff", [=] { rays->SetBackgroundGlowFalloff(40.0); } },
    { "Density", [=] { model->SetDensity(0.8); } },
    { "Decay", [=] { model->SetDecay(0.95); } },
    { "Weight", [=] { model->SetWeight(0.05); } },
    { "Exposure", [=] { model->SetExposure(0.5); } },
    { "NumberOfSamples", [=] { model->SetNumberOfSamples(60); } },
    { "ClampMaximum",
      [=]
      {
        if (published)
        {
          published->SetClampMaximum(2.0);
        }
      } },
    { "the light's place", [=] { sun->SetPosition(0.1, -0.2, -1.0); } },
    { "the light's colour", [=] { sun->SetDiffuseColor(0.5, 0.6, 0.7); } },
  };
  for (const auto& change : changes)
  {
    change.second();
    const Counts counts = Draw(scene);
    if (GetParam().Grows)
    {
      EXPECT_EQ(counts.Shaders + counts.Programs + counts.Buffers, 0) << change.first << counts;
      EXPECT_EQ(Draw(scene).GetMade(), own) << change.first;
      continue;
    }
    EXPECT_EQ(counts.GetMade(), own) << change.first << ": " << counts;
    EXPECT_TRUE(counts.AliveAs(Counts())) << change.first << ": " << counts;
  }
  const std::pair<const char*, std::function<void()>> objects[] = {
    { "Blend", [=] { rays->SetBlend(vtkGodRaysPass::SCREEN); } },
    { "Formulation", [=] { rays->ApplyPreset("published:babylon"); } },
    { "Output", [=] { rays->SetOutput(vtkGodRaysPass::SCATTERING); } },
    { "Precision", [=] { rays->SetPrecision(vtkGodRaysPass::SINGLE); } },
  };
  // A mode has terms of its own, and so a shader, once; never another one, but maybe other textures.
  for (bool isFirst : { true, false })
  {
    rays->SetBlend(vtkGodRaysPass::ADD);
    rays->ApplyPreset("default");
    rays->SetLayerMargin(0.0);
    rays->SetOutput(vtkGodRaysPass::COMPOSITE);
    rays->SetPrecision(vtkGodRaysPass::HALF);
    scene.Window->Render();
    for (const auto& change : objects)
    {
      change.second();
      const Counts counts = Draw(scene);
      if (!isFirst)
      {
        EXPECT_EQ(counts.Shaders + counts.Programs + counts.Buffers, 0) << change.first << counts;
      }
      EXPECT_EQ(Draw(scene).GetMade(), own) << change.first;
    }
  }
}

TEST_P(GodRaysSteadyFrame, IsTheSameEveryTimeAndAfterARelease)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  const auto picture = GetPixels(scene.Window);
  EXPECT_EQ(picture, GetPixels(scene.Window));
  scene.Rays->ReleaseGraphicsResources(scene.Window);
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  EXPECT_FALSE(scene.Rays->GetOcclusionImage(image));
  EXPECT_FALSE(scene.Rays->GetScatteringImage(image));
  EXPECT_EQ(image->GetNumberOfPoints(), 0);
  EXPECT_EQ(picture, GetPixels(scene.Window));
  EXPECT_TRUE(scene.Rays->GetOcclusionImage(image));
  EXPECT_GT(GetMean(image), 0.0);
  EXPECT_EQ(picture, GetPixels(scene.Window));
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysSteadyFrame, ::testing::ValuesIn(Kinds),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(GodRaysResources, AreNotMadeForAFrameWithoutRays)
{
  Messages messages;
  Counts counts[2];
  for (const bool attached : { false, true })
  {
    Stage scene(64, 48);
    scene.AddPillarsAndSun();
    AddIgnored(scene);
    scene.Rays->SetIntensity(0.0);
    if (!attached)
    {
      scene.Rays->Detach(scene.Renderer);
    }
    Count(scene.Window);
    counts[attached] = Draw(scene);
  }
  EXPECT_EQ(counts[0].GetMade(), counts[1].GetMade()) << counts[0] << "\n" << counts[1];
  EXPECT_TRUE(counts[0].AliveAs(counts[1])) << counts[0] << "\n" << counts[1];
}

// With air before the scene, and new tables as the sun moves.
TEST(GodRaysResources, AreNotMadeForASkyAndAreReleased)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  scene.Rays->Detach(scene.Renderer);
  scene.Window->Render();
  Count(scene.Window);
  const int own = Draw(scene).GetMade();
  const Counts bare = Now;
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(scene.Renderer);
  sky->SetWorldUnitInMeters(1000.0);
  sky->SetSunElevation(10.0);
  const Counts first = Draw(scene);
  EXPECT_GE(first.Shaders, 6) << first;
  EXPECT_GE(first.Textures, 6) << first;
  for (double sun = 10.0; sun > 2.0; sun -= 2.0)
  {
    sky->SetSunElevation(sun);
    sky->SetExposure(sun);
    const Counts steady = Draw(scene);
    EXPECT_EQ(steady.GetMade(), own) << sun << ": " << steady;
    EXPECT_TRUE(steady.AliveAs(Counts())) << sun << ": " << steady;
  }
  EXPECT_EQ(sky->GetNumberOfTables(), 8);
  EXPECT_TRUE(vtkGodRaysSkyPass::Detach(scene.Renderer));
  EXPECT_TRUE(Now.AliveAs(bare)) << Now - bare;
}

TEST(GodRaysResources, AreKeptForManyLightsInShaders)
{
  Messages messages;
  Stage scene;
  scene.AddPillarsAndSun();
  for (int i = 0; i < 11; ++i)
  {
    scene.Rays->AddLight(MakeSun({ 0.02 * i - 0.1, 0.3 - 0.04 * i, -1.0 }));
  }
  UseShaders(scene);
  Count(scene.Window);
  Draw(scene);
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), "block means: ")) << scene.Rays->GetPlan();
  for (int frame = 2; frame < 5; ++frame)
  {
    EXPECT_EQ(Draw(scene).Uploads, 0) << "frame " << frame;
  }
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  EXPECT_GE(Draw(scene).Uploads, 12);
}

// A sun and a lamp amid the pillars: seven maps, rendered through projections of their own.
TEST(GodRaysResources, AreNotMadeForShadowMaps)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  scene.Rays->AddLight(MakeLamplight({ 0.6, 0.5, 0.0 }));
  vtkNew<vtkGodRaysHomogeneousModel> model;
  scene.Rays->SetModel(model);
  vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
  integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
  scene.Rays->SetIntegrator(integrator);
  Count(scene.Window);
  EXPECT_GT(Draw(scene).GetMade(), 10);
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), "shadow map: 6 of")) << scene.Rays->GetPlan();
  for (int frame = 2; frame < 5; ++frame)
  {
    const Counts steady = Draw(scene);
    EXPECT_EQ(steady.GetMade(), 0) << "frame " << frame << ": " << steady;
  }
}

// Nothing goes over the bus, whether the camera moves or not, but for the exposure. The control is the
// processor.
TEST(GodRaysResources, AreNeitherReadNorUploadedInShaders)
{
  Messages messages;
  for (const bool air : { false, true })
  {
    for (const int backend : { vtkGodRaysIntegrator::GRAPHICS, vtkGodRaysIntegrator::PROCESSOR })
    {
      Stage scene(64, 48);
      scene.AddPillarsAndSun();
      scene.Rays->AddLight(MakeLamplight({ 0.6, 0.5, 0.0 }));
      vtkSmartPointer<vtkGodRaysModel> model = vtkSmartPointer<vtkGodRaysHomogeneousModel>::New();
      if (air)
      {
        model = vtkSmartPointer<vtkGodRaysAtmosphereModel>::New();
      }
      scene.Rays->SetModel(model);
      vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
      integrator->SetBackend(backend);
      scene.Rays->SetIntegrator(integrator);
      scene.Rays->AutomaticExposureOff();
      Count(scene.Window);
      Draw(scene);
      for (int frame = 0; frame < 4; ++frame)
      {
        const Counts counts = Draw(scene);
        const bool processor = backend == vtkGodRaysIntegrator::PROCESSOR;
        EXPECT_EQ(counts.Reads > 0, processor) << counts.Reads << " in frame " << frame;
        const bool moved = frame > 1; // else the last walk is kept
        EXPECT_EQ(counts.Uploads > 0, processor && moved)
          << counts.Uploads << " in frame " << frame;
        EXPECT_TRUE(
          Says(scene.Rays->GetPlan(), processor ? "on the processor" : "in compute shaders"));
        scene.Renderer->GetActiveCamera()->Azimuth(frame < 1 ? 0.0 : 2.0);
      }
    }
  }
}

// However many they are; a light that is gone keeps none.
TEST(GodRaysResources, AreThoseOfTheLightsThatThereAre)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
  vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
  integrator->SetMapSize(64);
  scene.Rays->SetIntegrator(integrator);
  scene.Rays->RemoveAllLights();
  std::vector<vtkSmartPointer<vtkLight>> lamps;
  for (int i = 0; i < 7; ++i)
  {
    lamps.push_back(MakeLamplight({ 1.2 * i - 3.0, 0.5, 2.0 }));
  }
  scene.Rays->AddLight(lamps[0]);
  scene.Rays->AddLight(lamps[1]); // lights have a sum, too
  Count(scene.Window);
  Draw(scene);
  const Counts two = Now;
  for (std::size_t i = 2; i < lamps.size(); ++i)
  {
    scene.Rays->AddLight(lamps[i]);
  }
  const Counts added = Draw(scene);
  EXPECT_EQ(added.Textures, 5 * 2) << "a map and rays of each: " << added;
  EXPECT_EQ(Draw(scene).GetMade(), 0);
  for (std::size_t i = 2; i < lamps.size(); ++i)
  {
    scene.Rays->RemoveLight(lamps[i]);
  }
  Draw(scene);
  Draw(scene);
  EXPECT_TRUE(Now.AliveAs(two)) << Now - two;
}

TEST(GodRaysResources, AreAsBeforeAfterFiftyToggles)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  AddIgnored(scene);
  AddShiningProp(scene);
  AddLights(scene);
  scene.Rays->MeasureTimesOn();
  scene.Rays->Detach(scene.Renderer);
  Count(scene.Window);
  const auto bare = GetPixels(scene.Window);
  const Counts before = Now;
  Counts once;
  for (int i = 0; i < 50; ++i)
  {
    scene.Rays->Attach(scene.Renderer);
    const Counts first = Draw(scene);
    EXPECT_GT(first.Textures, 4) << first;
    EXPECT_GT(first.Queries, 4) << first;
    vtkNew<vtkImageData> layers; // whose sum has a texture of its own
    EXPECT_TRUE(scene.Rays->GetOcclusionImage(layers));
    scene.Rays->Detach(scene.Renderer);
    EXPECT_TRUE(Now.AliveAs(before)) << i << ": " << before << "\n" << Now;
    EXPECT_TRUE(i > 4 || Now.Queries == before.Queries) << i << ": " << before << "\n" << Now;
    once = i == 0 ? Now : once;
  }
  EXPECT_EQ(Now.Shaders, once.Shaders) << "the window keeps shaders, they are built once";
  EXPECT_EQ(bare, GetPixels(scene.Window));
}

TEST(GodRaysResources, AreFreedWithTheWindow)
{
  Messages messages;
  vtkNew<vtkGodRaysPass> rays; // outlives its windows
  auto sun = MakeSun({ 0.3, 0.2, -1.0 });
  rays->AddLight(sun);
  std::vector<unsigned char> first;
  const Counts before = Now;
  for (int i = 0; i < 6; ++i)
  {
    Stage scene(64, 48);
    AddIgnored(scene);
    Count(scene.Window);
    if (i % 2)
    {
      rays->Attach(scene.Renderer);
    }
    else
    {
      scene.Renderer->SetPass(rays);
    }
    const auto picture = GetPixels(scene.Window);
    first = i ? first : picture;
    EXPECT_EQ(picture, first) << i;
    if (i == 4)
    {
      scene.Renderer->SetPass(nullptr); // behind the pass's back
    }
    else if (i == 5)
    {
      scene.Window->Finalize();
      Count(scene.Window);
      EXPECT_EQ(GetPixels(scene.Window), first) << "after Finalize";
      scene.Renderer->SetPass(nullptr);
      scene.Window->Finalize();
      scene.Renderer->SetPass(rays);
      Count(scene.Window);
      EXPECT_EQ(GetPixels(scene.Window), first) << "after Finalize without the pass";
    }
  }
  EXPECT_EQ(Now.Textures, before.Textures) << Now - before;
  EXPECT_EQ(Now.Framebuffers, before.Framebuffers) << Now - before;
  vtkNew<vtkImageData> image;
  EXPECT_FALSE(rays->GetScatteringImage(image)) << "there is no window any more";
  EXPECT_FALSE(rays->GetOcclusionImage(image));
}

// The window has its own textures by then: without them there is no scene, with rays or without.
TEST(GodRaysResources, ThatADriverRefusesLeaveTheSceneAsWithoutRays)
{
  const std::pair<const char*, std::function<void(Stage&)>> kinds[] = {
    { "plain", [](Stage&) {} },
    { "in shaders", UseShaders },
    { "all", AddAll },
    { "medium", [](Stage& scene) { scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>()); } },
    { "medium in shaders",
      [](Stage& scene)
      {
        scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
        vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
        integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
        scene.Rays->SetIntegrator(integrator);
      } },
  };
  int refused = 0;
  for (const auto& kind : kinds)
  {
    for (const int format : { GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F, GL_RGBA8, GL_RGBA16F,
           GL_RGBA32F, GL_R16F, GL_R32F })
    {
      SCOPED_TRACE(std::string(kind.first) + ", format " + std::to_string(format));
      Messages messages;
      Stage scene(64, 48);
      scene.AddPillarsAndSun();
      kind.second(scene);
      scene.Rays->Detach(scene.Renderer);
      const auto without = GetPixels(scene.Window);
      const auto depths = GetDepths(scene.Window);
      scene.Rays->Attach(scene.Renderer);
      Count(scene.Window);
      RefusedFormat = format;
      std::vector<unsigned char> with;
      for (int frame = 0; frame < 3; ++frame)
      {
        with = GetPixels(scene.Window);
      }
      RefusedFormat = 0;
      while (glGetError() != GL_NO_ERROR) // that was asked for
      {
      }
      std::string plan = scene.Rays->GetPlan();
      auto said = messages.Take();
      // Debian 14's VTK tells the driver's error wherever it asks for errors.
      said.erase(std::remove_if(said.begin(), said.end(),
                   [](const std::string& each)
                   { return Says(each, "OpenGL errors detected") || Says(each, "GL Message"); }),
        said.end());
      if (!Says(plan, "after an error"))
      {
        EXPECT_NE(with, without) << "it is not needed: there are rays";
        EXPECT_TRUE(said.empty());
        continue;
      }
      ++refused;
      EXPECT_EQ(with, without);
      EXPECT_EQ(depths, GetDepths(scene.Window, false));
      ASSERT_EQ(said.size(), 1u);
      EXPECT_TRUE(Says(said[0], "The scene is drawn without god rays: the framebuffer")) << said[0];
    }
  }
  EXPECT_GT(refused, 15);
}
