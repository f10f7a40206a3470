// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Much, often, or very little: many lights, windows of a few pixels, views from one degree to 170, stereo
// and sizes that change with every frame, and thousands of frames in the same memory.

#include "CountOpenGLCalls.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace GodRaysTesting;

namespace
{
double Indices = 0.0;  // that were drawn
double Uploaded = 0.0; // into buffers [bytes]
}
COUNT_CALLS(DrawRangeElements,
  (GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices),
  (mode, start, end, count, type, indices), Indices += count)
COUNT_CALLS_1_1(DrawElements, (GLenum mode, GLsizei count, GLenum type, const void* indices),
  (mode, count, type, indices), Indices += count)
COUNT_CALLS(BufferData, (GLenum target, GLsizeiptr size, const void* data, GLenum usage),
  (target, size, data, usage), Uploaded += static_cast<double>(size))

namespace
{
using Pixels = std::vector<unsigned char>;

void AddFog(Stage& scene)
{
  scene.Rays->SetModel(vtkNew<vtkGodRaysHomogeneousModel>());
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

void UseShaders(Stage& scene)
{
  vtkGodRaysEpipolarIntegrator::SafeDownCast(scene.Rays->GetIntegrator())
    ->SetBackend(vtkGodRaysEpipolarIntegrator::GRAPHICS);
}

const Kind Kinds[] = {
  { "Look", [](Stage&) {} },
  { "LookInShaders", UseShaders },
  { "Taps", [](Stage& scene) { SumTaps(scene.Rays); } },
  { "Margin", [](Stage& scene) { scene.Rays->SetLayerMargin(0.25); } },
  { "MarginInShaders",
    [](Stage& scene)
    {
      UseShaders(scene);
      scene.Rays->SetLayerMargin(0.25);
    } },
  { "Medium",
    [](Stage& scene)
    {
      AddFog(scene);
      // Small maps: a driver keeps up to three of them for a while, and each is to be seen if it stays.
      vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
      integrator->SetMapSize(128);
      scene.Rays->SetIntegrator(integrator);
    } },
  { "MediumInShaders",
    [](Stage& scene)
    {
      AddFog(scene);
      vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
      integrator->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
      integrator->SetMapSize(64);
      scene.Rays->SetIntegrator(integrator);
    } },
};

#ifdef __SANITIZE_ADDRESS__
constexpr bool KeepsWhatIsFreed = true;
#else
constexpr bool KeepsWhatIsFreed = false;
#endif

class GodRaysStress : public ::testing::TestWithParam<Kind>
{
};

/// Memory that the process uses, in MB: without what is freed, which the C library keeps for the next time.
double GetMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ifstream file("/proc/self/statm");
  long all = 0;
  long resident = 0;
  file >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}
}

TEST_P(GodRaysStress, AWindowOfAnySizeIsAsANewOne)
{
  Messages messages;
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  scene.Window->Render();
  const std::pair<int, int> sizes[] = { { 1, 1 }, { 64, 48 }, { 9, 1 }, { 31, 33 } };
  for (const auto& size : sizes)
  {
    scene.Window->SetSize(size.first, size.second);
    const Pixels picture = GetPixels(scene.Window);
    Stage another(size.first, size.second);
    another.AddPillarsAndSun();
    GetParam().Arrange(another);
    EXPECT_EQ(GetLargestDifference(picture, GetPixels(another.Window), 4), 0)
      << size.first << " x " << size.second;
  }
}

TEST_P(GodRaysStress, ViewsOfOneDegreeTo170HaveLightThatIsFinite)
{
  Messages messages;
  Stage scene(48, 36);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  int lit = 0;
  for (const double angle : { 1.0, 5.0, 40.0, 90.0, 150.0, 170.0 })
  {
    scene.Renderer->GetActiveCamera()->SetViewAngle(angle);
    scene.Window->Render();
    vtkNew<vtkImageData> light;
    if (!scene.Rays->GetScatteringImage(light))
    {
      continue; // a view of one degree does not have the sun
    }
    ++lit;
    const auto* values = static_cast<const float*>(light->GetScalarPointer());
    const auto number = static_cast<std::size_t>(light->GetNumberOfPoints()) *
      static_cast<std::size_t>(light->GetNumberOfScalarComponents());
    EXPECT_TRUE(std::all_of(
      values, values + number, [](float value) { return std::isfinite(value) && value >= 0.0f; }))
      << angle;
  }
  EXPECT_GE(lit, 3);
}

TEST_P(GodRaysStress, LightsOfWhichThereAre64AreTheSumOfThem)
{
  Messages messages;
  double means[2];
  for (const int number : { 1, 64 })
  {
    Stage scene(48, 36);
    scene.AddPillarsAndSun();
    GetParam().Arrange(scene);
    scene.Rays->RemoveAllLights();
    for (int i = 0; i < number; ++i)
    {
      // in turn red, green and blue light: together as white as the one
      const auto part = [&](int c) { return number == 1 || (i + c) % 3 == 0 ? 1.0 : 0.0; };
      auto sun = MakeSun({ 0.3, 0.2, -1.0 }, { part(0), part(1), part(2) });
      sun->SetIntensity(number == 1 ? 1.0 : 3.0 / 64.0);
      scene.Rays->AddLight(sun);
    }
    scene.Window->Render();
    vtkNew<vtkImageData> light;
    ASSERT_TRUE(scene.Rays->GetScatteringImage(light)) << scene.Rays->GetPlan();
    means[number > 1] = GetMean(light);
  }
  EXPECT_GT(means[0], 0.0);
  EXPECT_NEAR(means[1], means[0], 0.01 * means[0]);
}

TEST_P(GodRaysStress, StereoThatIsSwitchedBetweenFramesIsAsWithoutRays)
{
  Messages messages;
  const int types[] = { VTK_STEREO_RED_BLUE, VTK_STEREO_INTERLACED, VTK_STEREO_LEFT,
    VTK_STEREO_RIGHT, VTK_STEREO_DRESDEN, VTK_STEREO_ANAGLYPH, VTK_STEREO_CHECKERBOARD,
    VTK_STEREO_SPLITVIEWPORT_HORIZONTAL };
  Stage with(62, 40);
  Stage without(62, 40);
  for (Stage* scene : { &with, &without })
  {
    scene->AddPillarsAndSun();
    GetParam().Arrange(*scene);
  }
  without.Rays->Detach(without.Renderer);
  const Pixels bare = GetPixels(without.Window);
  const Pixels lit = GetPixels(with.Window);
  const bool darkens = Says(with.Rays->GetPlan(), "medium"); // the scene behind it
  for (const int type : types)
  {
    for (const bool on : { true, true, false })
    {
      for (Stage* scene : { &with, &without })
      {
        scene->Window->SetStereoType(type);
        scene->Window->SetStereoRender(on);
        scene->Renderer->GetActiveCamera()
          ->Modified(); // else VTK 9.1 keeps the former eye, without rays
      }
      const Pixels picture = GetPixels(with.Window);
      const Pixels plain = GetPixels(without.Window);
      EXPECT_EQ(GetDepths(with.Window, false), GetDepths(without.Window, false)) << type << on;
      int darker = 0;
      int alpha = 0;
      for (std::size_t i = 0; i < plain.size(); ++i)
      {
        darker += i % 4 != 3 && picture[i] + 1 < plain[i];
        alpha += i % 4 == 3 && picture[i] != plain[i];
      }
      EXPECT_TRUE(darkens || darker == 0) << type << on << ": " << darker;
      EXPECT_EQ(alpha, 0) << type << on;
      EXPECT_NE(picture, plain) << type << on << ": there are no rays";
      if (!on)
      {
        EXPECT_EQ(picture, lit) << type;
        EXPECT_EQ(plain, bare) << type;
      }
    }
  }
}

// GODRAYS_LONG makes 2000 of each, and 5000 frames.
TEST_P(GodRaysStress, MemoryStaysAsItIs)
{
  Messages messages;
  const bool isLong = std::getenv("GODRAYS_LONG");
  Stage scene(64, 48);
  scene.AddPillarsAndSun();
  GetParam().Arrange(scene);
  const std::pair<const char*, std::function<void(int)>> changes[] = {
    { "attached and detached",
      [&](int)
      {
        scene.Rays->Detach(scene.Renderer);
        scene.Rays->Attach(scene.Renderer);
      } },
    { "another size", [&](int i) { scene.Window->SetSize(40 + i % 7, 30 + i % 5); } },
    { "frame", [&](int) { scene.Renderer->GetActiveCamera()->Azimuth(0.3); } },
  };
  for (const bool counts : { false, true }) // memory of threads and caches comes in the first round
  {
    for (const auto& change : changes)
    {
      const bool isFrame = change.first == std::string("frame");
      const int number = !counts ? 40 : !isLong ? 40 : isFrame ? 5000 : 2000;
      // Drivers free textures some frames later: the least of the second and of the last quarter do not
      // depend on when.
      double least[4] = { 1e30, 1e30, 1e30, 1e30 };
      for (int i = 0; i < number; ++i)
      {
        change.second(i);
        scene.Window->Render();
        if (i % (number / 20) == 0)
        {
          scene.Window->WaitForCompletion();
          double& quarter = least[4 * i / number];
          quarter = std::min(quarter, GetMemory());
        }
      }
      const double growth = least[3] - least[1];
      if (counts)
      {
        std::cout << number << " times " << change.first << ": " << growth << " MB more, of "
                  << least[1] << "\n";
        EXPECT_TRUE(KeepsWhatIsFreed || growth < 1.0) << change.first << ": " << growth;
      }
    }
  }
}

namespace
{
/// What a frame takes.
struct Cost
{
  double Triangles = 0.0; // drawn
  double Seconds = 0.0;
  double Uploaded = 0.0; // into buffers [MB]
};
Cost DrawFrame(vtkRenderWindow* window)
{
  Indices = 0.0;
  Uploaded = 0.0;
  const auto start = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return { Indices / 3.0, took.count(), 1e-6 * Uploaded };
}
}

// 0.2 million triangles, and 10 million with GODRAYS_LONG. Many triangles cost a look nothing more, and a
// medium one picture more from the light, which is kept.
TEST(GodRaysStress, OfManyTrianglesTheSceneIsDrawnOnceMoreAtMost)
{
  Messages messages;
  const int rows = std::getenv("GODRAYS_LONG") ? 2238 : 318;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(rows);
  sphere->SetPhiResolution(rows);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  mapper->Update();
  const double triangles = static_cast<double>(mapper->GetInput()->GetNumberOfPolys());
  EXPECT_GT(triangles, std::getenv("GODRAYS_LONG") ? 1e7 : 2e5);

  for (const bool fog : { false, true })
  {
    Stage scene(320, 240);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.5, 0.3, 0.0);
    scene.Window->Render(); // from now on there is a context
    INSTALL_COUNT(BufferData)
    scene.Renderer->AddActor(actor);
    // the control: VTK's own mapper has to upload three indices of each triangle
    EXPECT_GT(DrawFrame(scene.Window).Uploaded, 12e-6 * triangles);
    INSTALL_COUNT(DrawRangeElements)
    INSTALL_COUNT_1_1(DrawElements)
    const Cost without = DrawFrame(scene.Window);
    EXPECT_EQ(without.Triangles, triangles);
    const Pixels bare = GetPixels(scene.Window, false);

    auto sun = MakeSun({ 0.3, 0.2, -1.0 });
    scene.Rays->AddLight(sun);
    if (fog)
    {
      AddFog(scene);
    }
    scene.Rays->Attach(scene.Renderer);
    const Cost first = DrawFrame(scene.Window);
    EXPECT_EQ(first.Triangles, fog ? 2.0 * triangles : triangles);
    EXPECT_GT(CountDifferentPixels(GetPixels(scene.Window, false), bare, 2), 1000);
    scene.Renderer->GetActiveCamera()->Azimuth(0.3);
    const Cost next = DrawFrame(scene.Window);
    EXPECT_EQ(next.Triangles, triangles);
    sun->SetPosition(0.2, 0.3, -1.0);
    const Cost moved = DrawFrame(scene.Window);
    EXPECT_EQ(moved.Triangles, fog ? 2.0 * triangles : triangles);
    if (!fog)
    {
      // the control: what is beyond the picture has to be drawn for itself
      scene.Rays->SetLayerMargin(0.1);
      EXPECT_EQ(DrawFrame(scene.Window).Triangles, 2.0 * triangles);
    }
    const double uploaded = first.Uploaded + next.Uploaded + moved.Uploaded;
    EXPECT_LT(uploaded, 0.01); // no vertex a second time: rectangles of passes alone
    std::cout << triangles << " triangles" << (fog ? ", fog" : "") << ": " << without.Seconds
              << " s without rays, then " << first.Seconds << ", " << next.Seconds
              << " with another camera, " << moved.Seconds << " with another sun; " << uploaded
              << " MB into buffers\n";
  }
}

namespace
{
/// An actor that counts how often it is drawn.
class CountedActor : public vtkOpenGLActor
{
public:
  static CountedActor* New();
  vtkTypeMacro(CountedActor, vtkOpenGLActor);
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    ++Drawn;
    return this->Superclass::RenderOpaqueGeometry(viewport);
  }
  static int Drawn;
};
int CountedActor::Drawn = 0;
vtkStandardNewMacro(CountedActor);

/// Boxes all about lamps in fog, every fourth of glass.
struct LampsAmongBoxes : Stage
{
  static constexpr int Boxes = 60;

  explicit LampsAmongBoxes(int lamps)
    : Stage(96, 72)
  {
    vtkMath::RandomSeed(7);
    vtkNew<vtkCubeSource> cube;
    const auto place = [](double range, double at[3])
    {
      for (int i = 0; i < 3; ++i)
      {
        at[i] = vtkMath::Random(-range, range);
      }
    };
    double at[3];
    for (int i = 0; i < Boxes; ++i)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(cube->GetOutputPort());
      vtkNew<CountedActor> box;
      box->SetMapper(mapper);
      place(5.0, at);
      box->SetPosition(at);
      box->GetProperty()->SetColor(1.0, 0.5, 0.2);
      box->GetProperty()->SetOpacity(i % 4 == 0 ? 0.5 : 1.0);
      this->Renderer->AddActor(box);
    }
    AddFog(*this);
    vtkNew<vtkGodRaysShadowMapIntegrator> integrator;
    integrator->SetMapSize(256);
    this->Rays->SetIntegrator(integrator);
    for (int i = 0; i < lamps; ++i)
    {
      vtkNew<vtkLight> lamp;
      lamp->SetPositional(true);
      lamp->SetConeAngle(180.0);
      place(3.0, at);
      lamp->SetPosition(at);
      this->Rays->AddLight(lamp);
    }
    this->Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 18.0);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 60.0);
    this->Rays->Attach(this->Renderer);
  }
};
}

// Each of the six faces about a lamp draws what it sees. An unchanged scene draws and walks nothing anew, and
// after the camera moved the picture is that of a new window.
TEST(GodRaysStress, LampsAmongBoxesOfGlassAreDrawnOnceFaceByFace)
{
  LampsAmongBoxes scene(4);
  CountedActor::Drawn = 0;
  scene.Window->Render();
  EXPECT_GE(CountedActor::Drawn, LampsAmongBoxes::Boxes * (1 + 4)); // the control
  EXPECT_LT(CountedActor::Drawn, LampsAmongBoxes::Boxes * (1 + 4 * 3));
  const Pixels first = GetPixels(scene.Window, false);

  CountedActor::Drawn = 0;
  scene.Window->Render();
  EXPECT_EQ(CountedActor::Drawn, LampsAmongBoxes::Boxes);
  EXPECT_TRUE(Says(scene.Rays->GetPlan(), "nodes, kept")) << scene.Rays->GetPlan();
  EXPECT_EQ(GetPixels(scene.Window, false), first);

  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 2.0, 17.0);
  scene.Window->Render();
  EXPECT_FALSE(Says(scene.Rays->GetPlan(), "nodes, kept")) << scene.Rays->GetPlan();
  LampsAmongBoxes fresh(4);
  fresh.Renderer->GetActiveCamera()->SetPosition(0.0, 2.0, 17.0);
  fresh.Window->Render();
  EXPECT_EQ(
    CountDifferentPixels(GetPixels(scene.Window, false), GetPixels(fresh.Window, false), 1), 0);
}

// A frame is aborted between lights and faces, as VTK asks for it, and the next one is whole.
TEST(GodRaysStress, AFrameThatIsAbortedHasNoRays)
{
  Messages messages;
  LampsAmongBoxes scene(2);
  scene.Window->Render();
  const Pixels whole = GetPixels(scene.Window, false);
  LampsAmongBoxes aborted(2);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* window, unsigned long, void*, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long observer = aborted.Window->AddObserver(vtkCommand::AbortCheckEvent, abort);
  aborted.Window->Render();
  EXPECT_TRUE(Says(aborted.Rays->GetPlan(), "rays: none, the frame was aborted"))
    << aborted.Rays->GetPlan();
  aborted.Window->RemoveObserver(observer);
  aborted.Window->Render();
  EXPECT_EQ(GetPixels(aborted.Window, false), whole);
}

INSTANTIATE_TEST_SUITE_P(
  All, GodRaysStress, ::testing::ValuesIn(Kinds), [](const auto& info) { return info.param.Name; });
