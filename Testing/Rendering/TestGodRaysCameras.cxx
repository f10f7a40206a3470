// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The light is where a camera of any kind shows a sphere in its place: both eyes of stereo,
// off-axis and explicit projections, parallel ones, the tiles of a large screenshot.

#include "GodRaysTesting.h"

#include "vtkGodRaysRadialModel.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPerspectiveTransform.h"
#include "vtkProperty.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace GodRaysTesting;

namespace
{
const int Width = 128;
const int Height = 96;

/// What the user sees, after both eyes are drawn: 8-bit RGBA.
std::vector<unsigned char> GetShown(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> data;
  window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 1, data);
  return { data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues() };
}

/// The centre of what shines in one channel, in columns [first, last), and its area in pixels.
struct Spot
{
  double X = 0.0;
  double Y = 0.0;
  double Area = 0.0;
};
Spot Find(const std::vector<unsigned char>& pixels, int channel, int first = 0, int last = Width)
{
  Spot spot;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = first; x < last; ++x)
    {
      // a pixel that is covered in part has a part of the light
      const double shown = pixels[4 * (static_cast<std::size_t>(y) * Width + x) + channel] / 255.0;
      const double value = std::pow(shown, 2.2);
      spot.X += x * value;
      spot.Y += y * value;
      spot.Area += value;
    }
  }
  spot.X /= spot.Area;
  spot.Y /= spot.Area;
  return spot;
}

/// A black scene with a white light or, in its place, a white sphere.
struct Sky : Stage
{
  vtkSmartPointer<vtkActor> Sphere;

  /// Positional, 25 in front of the camera; or a sun in the same direction.
  explicit Sky(bool sun)
    : Stage(Width, Height)
  {
    const std::array<double, 3> offset{ { 2.0, 1.5, -25.0 } }; // from the camera, at (0, 0, 10)
    const double distance = std::sqrt(2.0 * 2.0 + 1.5 * 1.5 + 25.0 * 25.0);
    const double far = sun ? 400.0 : 1.0;
    const double radius = 1.0;
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 2e4);
    this->Sphere =
      MakeLamp({ far * offset[0], far * offset[1], 10.0 + far * offset[2] }, far * radius);
    this->Renderer->AddActor(this->Sphere);
    this->Rays->AddLight(
      sun ? MakeSun(offset) : MakeLamplight({ offset[0], offset[1], 10.0 + offset[2] }));
    this->Rays->SetSourceRadius(radius);
    this->Rays->SetSunAngularRadius(std::asin(radius / distance) * 180.0 / 3.14159265358979);
    this->Rays->SetBackgroundGlow(0.0);
    this->Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
  }

  std::vector<unsigned char> GetLight()
  {
    this->Sphere->VisibilityOff();
    this->Rays->Attach(this->Renderer);
    return GetShown(this->Window);
  }
  std::vector<unsigned char> GetSphere()
  {
    this->Rays->Detach(this->Renderer);
    this->Sphere->VisibilityOn();
    return GetShown(this->Window);
  }
};

void ExpectSamePlace(const Spot& light, const Spot& sphere, const std::string& name)
{
  ASSERT_GT(light.Area, 10.0) << name;
  ASSERT_GT(sphere.Area, 10.0) << name;
  EXPECT_NEAR(light.X, sphere.X, 0.3) << name;
  EXPECT_NEAR(light.Y, sphere.Y, 0.3) << name;
  EXPECT_NEAR(light.Area, sphere.Area, 0.1 * sphere.Area) << name;
}
}

TEST(GodRaysCameras, BothEyesOfStereoHaveTheLightInItsPlace)
{
  Messages messages;
  const double halves = 0.5 * Width;
  for (const bool sun : { false, true })
  {
    double x[2];
    for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT, VTK_STEREO_RED_BLUE,
           VTK_STEREO_ANAGLYPH, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
    {
      Sky sky(sun);
      sky.Renderer->GetActiveCamera()->SetEyeAngle(4.0);
      sky.Window->SetStereoType(type);
      sky.Window->StereoRenderOn();
      const auto light = sky.GetLight();
      const auto sphere = sky.GetSphere();
      const std::string name =
        sky.Window->GetStereoTypeAsString() + std::string(sun ? ", sun" : "");
      if (type == VTK_STEREO_SPLITVIEWPORT_HORIZONTAL)
      {
        ExpectSamePlace(Find(light, 0, 0, halves), Find(sphere, 0, 0, halves), name + ", left");
        ExpectSamePlace(
          Find(light, 0, halves, Width), Find(sphere, 0, halves, Width), name + ", right");
        continue;
      }
      for (const int channel : { 0, 2 })
      {
        const Spot spot = Find(light, channel);
        ExpectSamePlace(spot, Find(sphere, channel), name + ", channel " + std::to_string(channel));
        if (type == VTK_STEREO_LEFT || type == VTK_STEREO_RIGHT)
        {
          x[type == VTK_STEREO_RIGHT] = spot.X;
        }
      }
    }
    EXPECT_GT(std::abs(x[0] - x[1]), 2.0) << "the eyes do not differ: nothing is tested";
  }
}

namespace
{
/// Where the eye and the screen of an off-axis projection count from: since VTK 9.3, which projects anew,
/// from the origin of the world instead of the camera.
template <typename Camera>
auto GetOriginOfEyes(Camera* camera, double origin[3], int)
  -> decltype(static_cast<void>(camera->GetOffAxisClippingAdjustment()))
{
  camera->GetPosition(origin);
}
void GetOriginOfEyes(vtkCamera*, double[3], long) {}

/// A way to project.
struct Kind
{
  const char* Name;
  std::function<void(vtkCamera*)> Set;
  bool Suns; // whether the sun is where a far sphere is
};
const Kind Kinds[] = {
  { "symmetric", [](vtkCamera*) {}, true },
  { "WindowCenter", [](vtkCamera* camera) { camera->SetWindowCenter(0.4, -0.3); }, true },
  { "ViewShear", [](vtkCamera* camera) { camera->SetViewShear(0.2, 0.1, 1.0); }, true },
  { "roll and horizontal view angle",
    [](vtkCamera* camera)
    {
      camera->Roll(25.0);
      camera->UseHorizontalViewAngleOn();
    },
    true },
  { "off-axis",
    [](vtkCamera* camera)
    {
      double eye[3] = { 0.0, 0.0, 0.0 };
      GetOriginOfEyes(camera, eye, 0);
      camera->SetScreenBottomLeft(eye[0] - 0.6, eye[1] - 0.4, eye[2] - 1.0);
      camera->SetScreenBottomRight(eye[0] + 0.4, eye[1] - 0.4, eye[2] - 1.0);
      camera->SetScreenTopRight(eye[0] + 0.4, eye[1] + 0.35, eye[2] - 1.0);
      camera->SetEyePosition(eye);
      camera->UseOffAxisProjectionOn();
    },
    true },
  { "explicit",
    [](vtkCamera* camera)
    {
      vtkNew<vtkPerspectiveTransform> projection;
      projection->Frustum(-0.6, 0.4, -0.3, 0.45, 1.0, 2e4);
      camera->SetExplicitProjectionTransformMatrix(projection->GetMatrix());
      camera->UseExplicitProjectionTransformMatrixOn();
    },
    true },
  { "user transform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> squeeze;
      squeeze->Translate(0.1, -0.2, 0.0);
      squeeze->Scale(1.2, 1.2, 1.0);
      camera->SetUserTransform(squeeze);
    },
    true },
  { "user view transform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> turn;
      turn->RotateX(5.0);
      turn->RotateZ(30.0);
      camera->SetUserViewTransform(turn);
    },
    true },
  { "model transform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> turn;
      turn->RotateY(3.0);
      camera->SetModelTransformMatrix(turn->GetMatrix());
    },
    true },
  { "parallel",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(5.0);
    },
    false },
  { "parallel, mirrored and turned",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(5.0);
      vtkNew<vtkTransform> turn;
      turn->RotateZ(90.0);
      turn->Scale(1.0, -1.0, 1.0);
      camera->SetUserTransform(turn);
    },
    false },
  { "parallel, WindowCenter",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(5.0);
      camera->SetWindowCenter(0.4, -0.3);
    },
    false },
};
}

TEST(GodRaysCameras, OfAnyProjectionHaveTheLightInItsPlace)
{
  Messages messages;
  for (const Kind& kind : Kinds)
  {
    for (const bool sun : { false, true })
    {
      if (!sun || kind.Suns)
      {
        Sky sky(sun);
        kind.Set(sky.Renderer->GetActiveCamera());
        const auto light = sky.GetLight();
        ExpectSamePlace(
          Find(light, 0), Find(sky.GetSphere(), 0), kind.Name + std::string(sun ? ", sun" : ""));
      }
    }
  }
}

TEST(GodRaysCameras, OfAnyProjectionShowTheMarginWithTheSameOccluders)
{
  Messages messages;
  for (const Kind& kind : Kinds)
  {
    for (const int eye : { 0, VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
    {
      Stage scene(Width, Height);
      scene.AddPillarsAndSun();
      kind.Set(scene.Renderer->GetActiveCamera());
      scene.Window->SetStereoRender(eye != 0);
      if (eye)
      {
        scene.Window->SetStereoType(eye);
      }
      scene.Rays->SetBackgroundGlowRadius(60.0);
      vtkNew<vtkImageData> layers[2];
      for (const int margin : { 0, 1 })
      {
        scene.Rays->SetLayerMargin(0.25 * margin);
        scene.Window->Render();
        ASSERT_TRUE(scene.Rays->GetOcclusionImage(layers[margin])) << kind.Name;
      }
      ASSERT_EQ(layers[1]->GetDimensions()[0], Width + Width / 2);
      int wrong = 0;
      int blocked = 0;
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const double value = GetValue(layers[0], x, y);
          const double wide = GetValue(layers[1], x + Width / 4, y + Height / 4);
          wrong += std::abs(value - wide) > 0.01;
          blocked += value == 0.0;
        }
      }
      EXPECT_LE(wrong, 5) << kind.Name << ", eye " << eye;
      EXPECT_GT(blocked, 500) << kind.Name << ", eye " << eye;
      EXPECT_LT(blocked, Width * Height - 500) << kind.Name << ", eye " << eye;
    }
  }
}

TEST(GodRaysCameras, OfParallelProjectionHaveParallelShaftsOfASunAndRadialOnesOfALamp)
{
  Messages messages;
  Stage scene(Width, Height);
  scene.AddPillarsAndSun();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  scene.Rays->SetBackgroundGlowRadius(20.0);
  vtkLight* sun = scene.Rays->GetLight(0);
  scene.Window->Render();
  const double* p = sun->GetPosition();
  EXPECT_LT(GetErrorOfScattering(
              scene.Rays, scene.Renderer, GetClip(scene.Renderer, { p[0], p[1], p[2], 0.0 })),
    2e-3);

  // parallel: what is moved across the picture casts the same shaft there
  scene.Renderer->RemoveAllViewProps();
  auto box = MakeBox({ 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.5 });
  scene.Renderer->AddActor(box);
  vtkNew<vtkImageData> first;
  vtkNew<vtkImageData> second;
  const double pixel = 8.0 / Height;
  box->SetPosition(-20.0 * pixel, -5.0 * pixel, 0.0);
  scene.Window->Render();
  ASSERT_TRUE(scene.Rays->GetOcclusionImage(first));
  const double open = GetValue(first, 2, 2);
  ASSERT_TRUE(scene.Rays->GetScatteringImage(first));
  box->SetPosition(0.0, 0.0, 0.0);
  scene.Window->Render();
  ASSERT_TRUE(scene.Rays->GetScatteringImage(second));
  EXPECT_GT(open, 0.1);
  // seen where the march of neither leaves the picture differently: relative to an open picture
  box->VisibilityOff();
  vtkNew<vtkImageData> empty;
  scene.Window->Render();
  ASSERT_TRUE(scene.Rays->GetScatteringImage(empty));
  double worst = 0.0;
  double peak = 0.0;
  for (int y = 8; y < Height - 8; ++y)
  {
    for (int x = 0; x < Width - 20; ++x)
    {
      const double a = GetValue(empty, x, y) - GetValue(first, x, y);
      const double b = GetValue(empty, x + 20, y + 5) - GetValue(second, x + 20, y + 5);
      worst = std::max(worst, std::abs(a - b));
      peak = std::max(peak, a);
    }
  }
  EXPECT_GT(peak, 0.05 * GetMean(empty));
  EXPECT_LT(worst, 0.02 * peak);

  box->VisibilityOn();
  scene.Rays->RemoveAllLights();
  scene.Rays->AddLight(MakeLamplight({ 1.0, 2.0, -3.0 }));
  scene.Rays->SetSourceRadius(0.5);
  scene.Window->Render();
  EXPECT_LT(GetErrorOfScattering(
              scene.Rays, scene.Renderer, GetClip(scene.Renderer, { 1.0, 2.0, -3.0, 1.0 })),
    2e-3);
}

namespace
{
/// A screenshot of a multiple of the window's size, in as many tiles by as many.
vtkSmartPointer<vtkImageData> GetTiled(vtkRenderWindow* window, int scale)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(scale);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->Update();
  return filter->GetOutput();
}

/// The largest difference of two pictures: inside, and in the pixels along the edges.
void GetLargest(vtkImageData* a, const std::vector<unsigned char>& b, int& inside, int& along)
{
  const int* size = a->GetDimensions();
  inside = 0;
  along = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      int& largest = x == 0 || y == 0 || x == size[0] - 1 || y == size[1] - 1 ? along : inside;
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest,
          std::abs(static_cast<int>(GetValue(a, x, y, c)) -
            b[4 * (static_cast<std::size_t>(y) * size[0] + x) + c]));
      }
    }
  }
}

double GetMeanDifference(
  vtkImageData* a, const std::vector<unsigned char>& b, int* largest, int* numberAbove2 = nullptr)
{
  const int* size = a->GetDimensions();
  double sum = 0.0;
  int above2 = 0;
  *largest = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int difference = std::abs(static_cast<int>(GetValue(a, x, y, c)) -
          b[4 * (static_cast<std::size_t>(y) * size[0] + x) + c]);
        sum += difference;
        above2 += difference > 2;
        *largest = std::max(*largest, difference);
      }
    }
  }
  if (numberAbove2)
  {
    *numberAbove2 = above2;
  }
  return sum / (3.0 * size[0] * size[1]);
}
}

TEST(GodRaysCameras, OfTilesShowOnePicture)
{
  Messages messages;
  const auto arrange = [](Stage& scene, bool layer)
  {
    scene.AddPillarsAndSun();
    scene.Rays->SetSunAngularRadius(3.0);
    scene.Rays->SetOutput(layer ? vtkGodRaysPass::OCCLUSION : vtkGodRaysPass::COMPOSITE);
  };
  for (const int scale : { 2, 3, 4, 5 })
  {
    int largest = 0;
    {
      // the layer: everything is where it is in one large window, but for pixels on edges
      Stage tiles(64, 48);
      Stage large(64 * scale, 48 * scale);
      arrange(tiles, true);
      arrange(large, true);
      auto tiled = GetTiled(tiles.Window, scale);
      ASSERT_EQ(tiled->GetDimensions()[0], 64 * scale);
      int off = 0;
      GetMeanDifference(tiled, GetPixels(large.Window), &largest, &off);
      EXPECT_LE(off, 3 * 20) << scale;
    }
    // the rays come from other tiles as well
    Stage tiles(64, 48);
    Stage large(64 * scale, 48 * scale);
    arrange(tiles, false);
    arrange(large, false);
    auto tiled = GetTiled(tiles.Window, scale);
    const double error = GetMeanDifference(tiled, GetPixels(large.Window), &largest);
    EXPECT_LT(error, 0.5) << scale;
    EXPECT_LE(largest, 2) << scale;
    large.Rays->SetIntensity(0.0);
    EXPECT_GT(GetMeanDifference(tiled, GetPixels(large.Window), &largest), 5.0) << scale;
  }
}

// One large picture does not have the light of what is beyond it. In tiles it lies in their margins.
TEST(GodRaysCameras, OfTilesShowOnePictureOfLightsBeyondIt)
{
  Messages messages;
  const std::array<double, 3> suns[] = { { 0.5, 0.3, -1.0 }, { -0.1, -0.5, -1.0 },
    { 0.02, 0.03, -1.0 } };
  for (const auto& position : suns)
  {
    for (const int scale : { 2, 3 })
    {
      if (scale > 2 && &position != suns)
      {
        continue;
      }
      SCOPED_TRACE("sun at " + std::to_string(position[0]) + ", scale " + std::to_string(scale));
      Stage tiles(64, 48);
      Stage large(64 * scale, 48 * scale);
      for (Stage* scene : { &tiles, &large })
      {
        auto sun = scene->AddPillarsAndSun();
        sun->SetPosition(position.data());
        scene->Rays->SetSunAngularRadius(3.0);
        // In black parts of a picture, the default tolerance is as much as 13 levels.
        scene->Rays->SetErrorTolerance(0.1 / 255.0);
      }
      auto tiled = GetTiled(tiles.Window, scale);
      int inside;
      int along;
      GetLargest(tiled, GetPixels(large.Window), inside, along);
      EXPECT_LE(inside, 2);
      EXPECT_LE(along, 4);
      large.Rays->SetIntensity(0.0);
      GetLargest(tiled, GetPixels(large.Window), inside, along);
      EXPECT_GT(inside, 20) << "there are no rays";
    }
  }
}
