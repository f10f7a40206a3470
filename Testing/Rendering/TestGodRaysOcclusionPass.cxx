// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysOcclusionPass: what the layer of a light holds, pixel by pixel: discs, glow, props that
// shine, block or dim, the margin, several lights, every kind of vtkLight, and extreme intensities.

#include "GodRaysTesting.h"

#include "vtkGodRaysMath.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCylinderSource.h"
#include "vtkElevationFilter.h"
#include "vtkLineSource.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#else
using vtkLODActor = vtkActor;
#endif

#include <cmath>
#include <functional>
#include <limits>

using namespace GodRaysTesting;

namespace
{
const int Width = 128;
const int Height = 96;

/// The stage with 32-bit layers and no glow, so that the layer holds what a test puts there.
class GodRaysOcclusion : public ::testing::Test
{
protected:
  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;

  GodRaysOcclusion()
  {
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
    this->Rays->SetBackgroundGlow(0.0);
    this->Rays->Attach(this->Renderer);
  }

  vtkSmartPointer<vtkLight> AddSun(
    std::array<double, 3> towards, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    auto sun = MakeSun(towards, color);
    this->Rays->AddLight(sun);
    return sun;
  }

  vtkSmartPointer<vtkActor> AddBox(std::array<double, 3> center, std::array<double, 3> size)
  {
    auto box = MakeBox(center, size);
    this->Renderer->AddActor(box);
    return box;
  }

  vtkSmartPointer<vtkActor> AddLamp(
    std::array<double, 3> center, double radius, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    auto lamp = MakeLamp(center, radius, color);
    vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
    this->Renderer->AddActor(lamp);
    return lamp;
  }

  /// The layer of a new frame.
  vtkSmartPointer<vtkImageData> GetLayer()
  {
    this->Scene.Window->Render();
    auto layer = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetOcclusionImage(layer)) << this->Rays->GetPlan();
    return layer;
  }

  vtkSmartPointer<vtkImageData> GetScattering()
  {
    this->Scene.Window->Render();
    auto scattering = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetScatteringImage(scattering)) << this->Rays->GetPlan();
    return scattering;
  }

  /// Window depths of the scene without rays.
  std::vector<float> GetSceneDepths()
  {
    const double intensity = this->Rays->GetIntensity();
    this->Rays->SetIntensity(0.0);
    auto depths = GetDepths(this->Scene.Window);
    this->Rays->SetIntensity(intensity);
    return depths;
  }
};

bool Says(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

void ForEachPixel(vtkImageData* image, const std::function<void(int x, int y)>& visit)
{
  const int* size = image->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      visit(x, y);
    }
  }
}

double GetSum(vtkImageData* image, int channel = 0)
{
  double sum = 0.0;
  ForEachPixel(image, [&](int x, int y) { sum += GetValue(image, x, y, channel); });
  return sum;
}

/// Largest difference of two images in all channels.
double GetLargestDifference(vtkImageData* a, vtkImageData* b)
{
  const int* sizes[] = { a->GetDimensions(), b->GetDimensions() };
  EXPECT_TRUE(std::equal(sizes[0], sizes[0] + 3, sizes[1]));
  double largest = 0.0;
  ForEachPixel(a,
    [&](int x, int y)
    {
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(GetValue(a, x, y, c) - GetValue(b, x, y, c)));
      }
    });
  return largest;
}

/// Half the height of the stage's picture at distance 1.
double GetTangent(vtkRenderer* renderer)
{
  return std::tan(0.5 * vtkMath::RadiansFromDegrees(renderer->GetActiveCamera()->GetViewAngle()));
}

/// Where the centre of a pixel meets the plane at distance 1, the stage's camera looking along -z.
std::array<double, 3> GetPixelRay(vtkRenderer* renderer, double x, double y)
{
  const double pixel = 2.0 * GetTangent(renderer) / Height;
  return { pixel * (x + 0.5 - 0.5 * Width), pixel * (y + 0.5 - 0.5 * Height), -1.0 };
}

double GetAngle(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return vtkMath::AngleBetweenVectors(a.data(), b.data());
}

/// Solid angle of what shines, and the mean direction to it (scaled to z = -1).
double GetSolidAngle(
  vtkImageData* layer, vtkRenderer* renderer, std::array<double, 3>& direction, int channel = 0)
{
  const double pixel = 2.0 * GetTangent(renderer) / Height;
  double sum = 0.0;
  direction = { 0.0, 0.0, 0.0 };
  ForEachPixel(layer,
    [&](int x, int y)
    {
      std::array<double, 3> ray = GetPixelRay(renderer, x, y);
      const double length = vtkMath::Normalize(ray.data());
      const double part =
        GetValue(layer, x, y, channel) * pixel * pixel / (length * length * length);
      sum += part;
      for (int i = 0; i < 3; ++i)
      {
        direction[i] += part * ray[i];
      }
    });
  for (double& component : direction)
  {
    component /= std::abs(direction[2]);
  }
  return sum;
}

double GetSolidAngleOfDisc(double radius)
{
  return 2.0 * vtkMath::Pi() * (1.0 - std::cos(radius));
}

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

/// A box of 4 x 4 x 2 about a centre in which light fades to transmittance^thickness.
vtkSmartPointer<vtkVolume> MakeFog(
  vtkVolumeMapper* mapper, std::array<double, 3> center, double transmittance, int voxels = 9)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(voxels, voxels, voxels);
  image->SetSpacing(4.0 / (voxels - 1), 4.0 / (voxels - 1), 2.0 / (voxels - 1));
  image->SetOrigin(center[0] - 2.0, center[1] - 2.0, center[2] - 1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
    static_cast<unsigned char>(100));
  mapper->SetInputData(image);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1.0 - transmittance);
  opacity->AddPoint(255.0, 1.0 - transmittance);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.5, 0.5, 0.5);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->ShadeOff();
  return volume;
}
}

//------------------------------------------------------------------------------
// Discs

TEST_F(GodRaysOcclusion, TheDiscOfASunHasItsPlaceAndSolidAngle)
{
  const double radius = 2.0;
  this->Rays->SetSunAngularRadius(radius);
  double worst = 0.0;
  for (double viewAngle : { 12.0, 40.0, 90.0 })
  {
    this->Renderer->GetActiveCamera()->SetViewAngle(viewAngle);
    const double tangent = GetTangent(this->Renderer);
    for (const auto& place : { std::array<double, 2>{ 0.0, 0.0 }, { 0.5, -0.3 }, { -0.7, 0.61 } })
    {
      SCOPED_TRACE(testing::Message() << "view angle " << viewAngle << " at " << place[0]);
      const std::array<double, 3> towards = { place[0] * tangent, place[1] * tangent, -1.0 };
      this->Rays->RemoveAllLights();
      this->AddSun(towards);
      auto layer = this->GetLayer();
      std::array<double, 3> found;
      const double expected = GetSolidAngleOfDisc(vtkMath::RadiansFromDegrees(radius));
      const double area = GetSolidAngle(layer, this->Renderer, found);
      worst = std::max(worst, std::abs(area / expected - 1.0));
      EXPECT_NEAR(area / expected, 1.0, 0.025);
      EXPECT_LT(GetAngle(found, towards) * 0.5 * Height / tangent, 0.1) << "pixels";
      // 1 well inside, 0 well outside
      const double pixel = 2.0 * tangent / Height;
      ForEachPixel(layer,
        [&](int x, int y)
        {
          const double separation = GetAngle(GetPixelRay(this->Renderer, x, y), towards);
          const double inside = vtkMath::RadiansFromDegrees(radius) - separation;
          if (std::abs(inside) > pixel)
          {
            ASSERT_NEAR(GetValue(layer, x, y), inside > 0.0 ? 1.0 : 0.0, 1e-6) << x << ", " << y;
          }
        });
    }
  }
  std::cout << "largest error of a disc's solid angle: " << worst << "\n";
}

TEST_F(GodRaysOcclusion, ASunBelowAPixelKeepsItsEnergy)
{
  this->Rays->SetSunAngularRadius(0.05); // a pixel is 0.4 degrees
  const double expected = GetSolidAngleOfDisc(vtkMath::RadiansFromDegrees(0.05));
  for (int step = 0; step < 8; ++step)
  {
    const double pixel = 2.0 * GetTangent(this->Renderer) / Height;
    this->Rays->RemoveAllLights();
    this->AddSun({ (5.0 + step / 8.0) * pixel, (3.0 - step / 5.0) * pixel, -1.0 });
    std::array<double, 3> found;
    EXPECT_NEAR(GetSolidAngle(this->GetLayer(), this->Renderer, found) / expected, 1.0, 0.025);
  }
}

TEST_F(GodRaysOcclusion, WhereThereAreOpaquePropsTheLayerOfASunIsZero)
{
  this->AddBox({ -1.0, 0.5, 0.0 }, { 1.5, 2.0, 1.0 });
  this->AddBox({ 2.0, -1.0, -60.0 }, { 9.0, 9.0, 9.0 });
  this->AddSun({ -0.06, 0.05, -1.0 });
  this->Rays->SetSunAngularRadius(6.0);
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetBackgroundGlowRadius(90.0);
  const auto depths = this->GetSceneDepths();
  auto layer = this->GetLayer();
  int dark = 0;
  int lit = 0;
  ForEachPixel(layer,
    [&](int x, int y)
    {
      const bool open = depths[y * Width + x] == 1.0f;
      EXPECT_EQ(GetValue(layer, x, y) > 0.0, open) << x << ", " << y;
      ++(open ? lit : dark);
    });
  EXPECT_GT(dark, 500);
  EXPECT_GT(lit, 500);
}

TEST_F(GodRaysOcclusion, ALampIsHiddenByWhatIsBeforeItAndSeenBeforeWhatIsBehind)
{
  const std::array<double, 3> position = { 1.0, 0.5, -3.0 };
  const std::array<double, 3> towards = { 1.0, 0.5, -13.0 };
  auto light = MakeLamplight(position);
  this->Rays->AddLight(light);
  this->Rays->SetSourceRadius(0.7);
  const double expected = GetSolidAngleOfDisc(std::asin(0.7 / vtkMath::Norm(towards.data())));
  std::array<double, 3> found;
  EXPECT_NEAR(GetSolidAngle(this->GetLayer(), this->Renderer, found) / expected, 1.0, 0.025);
  EXPECT_LT(GetAngle(found, towards), 0.001);

  auto open = this->GetLayer();
  auto behind = this->AddBox({ 0.0, 0.0, -5.0 }, { 8.0, 8.0, 1.0 });
  EXPECT_EQ(GetLargestDifference(open, this->GetLayer()), 0.0);

  auto before = this->AddBox({ 2.0, 0.0, 0.0 }, { 2.6, 8.0, 1.0 });
  auto covered = this->GetLayer();
  this->Renderer->RemoveActor(behind);
  const auto depths = this->GetSceneDepths();
  int hidden = 0;
  int seen = 0;
  ForEachPixel(covered,
    [&](int x, int y)
    {
      const bool free = depths[y * Width + x] == 1.0f;
      EXPECT_EQ(GetValue(covered, x, y), free ? GetValue(open, x, y) : 0.0);
      ++(free ? seen : hidden);
    });
  EXPECT_GT(GetSum(covered), 0.1 * GetSum(open));
  EXPECT_LT(GetSum(covered), 0.9 * GetSum(open));
}

TEST_F(GodRaysOcclusion, InAParallelProjectionADiscIsALengthAndASunIsEverywhereOrNowhere)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.0);
  const double pixel = 6.0 / Height;
  auto box = this->AddBox({ -2.0, -1.0, 0.0 }, { 1.4, 1.4, 1.0 });
  auto lamp = MakeLamplight({ 1.1, 0.7, -3.0 });
  this->Rays->AddLight(lamp);
  this->Rays->SetSourceRadius(0.5);
  auto layer = this->GetLayer();
  EXPECT_NEAR(GetSum(layer) * pixel * pixel / (vtkMath::Pi() * 0.25), 1.0, 0.025);
  double center[2] = { 0.0, 0.0 };
  ForEachPixel(layer,
    [&](int x, int y)
    {
      center[0] += GetValue(layer, x, y) * pixel * (x + 0.5 - 0.5 * Width);
      center[1] += GetValue(layer, x, y) * pixel * (y + 0.5 - 0.5 * Height);
    });
  EXPECT_NEAR(center[0] / GetSum(layer), 1.1, 0.1 * pixel);
  EXPECT_NEAR(center[1] / GetSum(layer), 0.7, 0.1 * pixel);

  box->SetPosition(3.1, 1.7, 0.0); // before the lamp
  EXPECT_LT(GetSum(this->GetLayer()), 1e-6);
  box->SetPosition(0.0, 0.0, 0.0);

  this->Rays->RemoveAllLights();
  auto sun = this->AddSun({ 0.0, 0.0, -1.0 }); // straight behind: all lines of sight end in it
  const auto depths = this->GetSceneDepths();
  layer = this->GetLayer();
  ForEachPixel(layer,
    [&](int x, int y)
    { EXPECT_NEAR(GetValue(layer, x, y), depths[y * Width + x] == 1.0f ? 1.0 : 0.0, 1e-6); });
  sun->SetPosition(0.1, 0.0, -1.0);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "neither it nor its glow"));
}

//------------------------------------------------------------------------------
// Glow

TEST_F(GodRaysOcclusion, GlowFollowsItsAnglesOnTheOpenBackgroundOnly)
{
  this->AddBox({ -1.5, 0.0, 0.0 }, { 0.7, 9.0, 0.7 });
  const std::array<double, 3> towards = { 0.1, 0.05, -1.0 };
  this->AddSun(towards, { 1.0, 0.7, 0.4 });
  this->Rays->SetSunAngularRadius(1.0);
  const auto depths = this->GetSceneDepths();
  const double degree = vtkMath::RadiansFromDegrees(1.0);
  const double pixel = 2.0 * GetTangent(this->Renderer) / Height;
  double worst = 0.0;
  for (const auto& numbers : { std::array<double, 3>{ 0.5, 2.0, 25.0 }, { 1.0, 3.0, 8.0 },
         { 0.25, 6.0, 0.0 }, { 0.0, 10.0, 10.0 } })
  {
    SCOPED_TRACE(testing::Message() << "glow " << numbers[0]);
    this->Rays->SetBackgroundGlow(numbers[0]);
    this->Rays->SetBackgroundGlowRadius(numbers[1]);
    this->Rays->SetBackgroundGlowFalloff(numbers[2]);
    auto layer = this->GetLayer();
    ForEachPixel(layer,
      [&](int x, int y)
      {
        const double separation = GetAngle(GetPixelRay(this->Renderer, x, y), towards);
        const bool nearAnEdge = std::abs(separation - degree) < pixel ||
          (numbers[2] == 0.0 && std::abs(separation - numbers[1] * degree) < 1e-4);
        if (nearAnEdge)
        {
          return;
        }
        double expected = separation < degree ? 1.0
                                              : numbers[0] *
            vtkGodRays::GlowFalloff(separation, numbers[1] * degree, numbers[2] * degree);
        expected *= depths[y * Width + x] == 1.0f ? 1.0 : 0.0;
        // GLSL's atan is good for some 2e-6 radians; the falloff is 1.5/width steep
        const double allowed =
          1e-6 + 2e-6 * (numbers[2] > 0.0 ? 1.5 * numbers[0] / (numbers[2] * degree) : 0.0);
        worst = std::max(worst, std::abs(GetValue(layer, x, y, 0) - expected) / allowed);
        EXPECT_NEAR(GetValue(layer, x, y, 0), expected, allowed) << x << ", " << y;
        EXPECT_NEAR(GetValue(layer, x, y, 2), expected * vtkGodRays::DecodeDisplay(0.4), allowed);
      });
  }
  std::cout << "largest error of the glow, of what 2e-6 radians allow: " << worst << "\n";
}

TEST_F(GodRaysOcclusion, InAParallelProjectionThePicturesHeightCountsAs30Degrees)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3.0);
  this->Rays->AddLight(MakeLamplight({ 1.0, -0.5, -3.0 }));
  this->Rays->SetSourceRadius(0.3);
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetBackgroundGlowRadius(4.0);
  this->Rays->SetBackgroundGlowFalloff(12.0);
  for (double margin : { 0.0, 0.25 })
  {
    this->Rays->SetLayerMargin(margin);
    auto layer = this->GetLayer();
    const int* size = layer->GetDimensions();
    const double pixel = 6.0 / Height;
    ForEachPixel(layer,
      [&](int x, int y)
      {
        const double separation = std::hypot(
          pixel * (x + 0.5 - 0.5 * size[0]) - 1.0, pixel * (y + 0.5 - 0.5 * size[1]) + 0.5);
        if (separation > 0.3 + pixel)
        {
          EXPECT_NEAR(GetValue(layer, x, y),
            0.5 * vtkGodRays::GlowFalloff(separation, 4.0 * 6.0 / 30.0, 12.0 * 6.0 / 30.0), 1e-5);
        }
      });
  }
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
// Props that shine

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

TEST_F(GodRaysOcclusionLamps, EachHasItsOwnCentre)
{
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

//------------------------------------------------------------------------------
// Props that dim

class GodRaysOcclusionDimming : public GodRaysOcclusion
{
protected:
  double GetCentre() { return GetValue(this->GetLayer(), Width / 2, Height / 2); }
};

TEST_F(GodRaysOcclusionDimming, OpacityHalvesTheLightWithAndWithoutDepthPeeling)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  auto front = this->AddBox({ 0.0, 0.0, 1.0 }, { 4.0, 4.0, 0.0 });
  auto back = this->AddBox({ 0.0, 0.0, -1.0 }, { 4.0, 4.0, 0.0 });
  vtkNew<vtkPlaneSource> plane; // one face each
  front->GetMapper()->SetInputConnection(plane->GetOutputPort());
  back->GetMapper()->SetInputConnection(plane->GetOutputPort());
  front->SetScale(4.0);
  back->SetScale(4.0);
  back->SetPosition(0.0, 0.0, -2.0);
  for (bool peeling : { false, true })
  {
    SCOPED_TRACE(peeling);
    this->Renderer->SetUseDepthPeeling(peeling);
    this->Scene.Window->SetAlphaBitPlanes(true);
    back->VisibilityOff();
    front->GetProperty()->SetOpacity(1.0);
    EXPECT_EQ(this->GetCentre(), 0.0);
    front->GetProperty()->SetOpacity(0.5);
    EXPECT_NEAR(this->GetCentre(), 0.5, 1e-3);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "opacity of 1 translucent")) << this->Rays->GetPlan();
    EXPECT_EQ(this->Rays->GetNumberOfGeometryPasses(), 1);
    back->VisibilityOn();
    back->GetProperty()->SetOpacity(0.5);
    EXPECT_NEAR(this->GetCentre(), 0.25, 1e-3);
    back->GetProperty()->SetOpacity(0.01); // faint ones count, too
    EXPECT_NEAR(this->GetCentre(), 0.495, 1e-3);
    vtkGodRaysPass::SetRole(front, vtkGodRaysPass::IGNORED);
    vtkGodRaysPass::SetRole(back, vtkGodRaysPass::IGNORED);
    EXPECT_EQ(this->GetCentre(), 1.0);
    vtkGodRaysPass::SetRole(front, vtkGodRaysPass::AUTOMATIC);
    vtkGodRaysPass::SetRole(back, vtkGodRaysPass::AUTOMATIC);
  }
}

TEST_F(GodRaysOcclusionDimming, ManyFaintPropsAddUp)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkPlaneSource> plane;
  for (int i = 0; i < 50; ++i)
  {
    auto sheet = this->AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
    sheet->GetMapper()->SetInputConnection(plane->GetOutputPort());
    sheet->SetScale(4.0);
    sheet->SetPosition(0.0, 0.0, -0.05 * i);
    sheet->GetProperty()->SetOpacity(0.01);
  }
  EXPECT_NEAR(this->GetCentre(), std::pow(0.99, 50), 5e-3);
}

TEST_F(GodRaysOcclusionDimming, OpacityOfScalarsCounts)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  auto sheet = this->AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(plane->GetOutputPort());
  elevation->SetLowPoint(-1e6, 0.0, 0.0); // 0.5 all over
  elevation->SetHighPoint(1e6, 0.0, 0.0);
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.3, 0.3);
  table->Build();
  sheet->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  sheet->GetMapper()->SetLookupTable(table);
  sheet->SetScale(4.0);
  EXPECT_NEAR(this->GetCentre(), 0.7, 3e-3); // the table has 8-bit entries
}

TEST_F(GodRaysOcclusionDimming, VolumesDimByTheirTransmittance)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  auto fog = MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.7);
  this->Renderer->AddVolume(fog);
  const double expected = 0.7 * 0.7; // 2 units thick
  const double found = this->GetCentre();
  std::cout << "volume: transmittance " << found << ", expected " << expected << "\n";
  EXPECT_NEAR(found, expected, 0.02);
  vtkGodRaysPass::SetRole(fog, vtkGodRaysPass::IGNORED);
  EXPECT_EQ(this->GetCentre(), 1.0);
  vtkGodRaysPass::SetRole(fog, vtkGodRaysPass::OCCLUDER);

  // opaque props hide it, and it hides nothing before it
  auto box = this->AddBox({ 0.0, 0.0, 3.0 }, { 1.0, 1.0, 1.0 });
  EXPECT_EQ(this->GetCentre(), 0.0);
  vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
  EXPECT_NEAR(this->GetCentre(), found, 1e-3) << "an ignored prop before it changes nothing";
  this->Renderer->RemoveActor(box);

  // in a viewport that does not start at the origin
  this->Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  vtkSmartPointer<vtkImageData> layer = this->GetLayer();
  EXPECT_EQ(layer->GetDimensions()[0], Width / 2);
  EXPECT_NEAR(GetValue(layer, Width / 4, Height / 4), found, 5e-3);
  this->Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);

  // coarser pictures of the mapper
  mapper->SetImageSampleDistance(2.0f);
  EXPECT_NEAR(this->GetCentre(), found, 0.02);
  mapper->SetImageSampleDistance(1.0f);
  EXPECT_NEAR(this->GetCentre(), found, 1e-6);
}

TEST_F(GodRaysOcclusionDimming, VolumesDimAlsoInTheMargin)
{
  this->Rays->SetBackgroundGlow(1.0);
  this->Rays->SetBackgroundGlowRadius(90.0);
  this->AddSun({ 0.0, 0.0, -1.0 });
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  auto fog = MakeFog(mapper, { 2.5, -1.0, 0.0 }, 0.7);
  this->Renderer->AddVolume(fog);
  this->AddBox({ 3.2, -1.0, 0.3 }, { 0.7, 1.0, 0.3 }); // in the fog
  // the margin's picture is a wider picture
  this->Rays->SetLayerMargin(0.25);
  auto margin = this->GetLayer();
  mapper->SetImageSampleDistance(2.0f); // VTK draws it into the picture's size: misplaced, no error
  this->GetLayer();
  mapper->SetImageSampleDistance(1.0f);
  this->Rays->SetLayerMargin(0.0);
  this->Scene.Window->SetSize(Width * 3 / 2, Height * 3 / 2);
  this->Renderer->GetActiveCamera()->SetViewAngle(
    2.0 * vtkMath::DegreesFromRadians(std::atan(1.5 * GetTangent(this->Renderer))));
  auto wide = this->GetLayer();
  int different = 0;
  int dimmed = 0;
  ForEachPixel(wide,
    [&](int x, int y)
    {
      different += std::abs(GetValue(wide, x, y) - GetValue(margin, x, y)) > 0.02;
      dimmed += GetValue(wide, x, y) < 0.99;
    });
  EXPECT_GT(dimmed, 1000);
  EXPECT_LE(different, dimmed / 50); // the edges of the box, one row or column
}

TEST_F(GodRaysOcclusionDimming, SmartVolumeMappersDimAlso)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetRequestedRenderModeToGPU();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  this->Renderer->AddVolume(MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.5));
  EXPECT_NEAR(this->GetCentre(), 0.25, 0.02);
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

//------------------------------------------------------------------------------
// Several lights

TEST_F(GodRaysOcclusion, SeveralLightsAdd)
{
  for (int i = -2; i <= 2; ++i)
  {
    this->AddBox({ 1.3 * i, 0.0, 0.0 }, { 0.5, 3.0, 0.5 });
  }
  this->Rays->SetBackgroundGlow(0.3);
  vtkSmartPointer<vtkLight> lights[] = { MakeSun({ 0.2, 0.1, -1.0 }, { 1.0, 0.3, 0.3 }),
    MakeSun({ -0.2, 0.2, -1.0 }, { 0.2, 1.0, 0.2 }),
    MakeLamplight({ -1.0, -1.0, -3.0 }, { 0.4, 0.4, 1.0 }) };
  lights[1]->SetIntensity(2.5);
  vtkSmartPointer<vtkImageData> layers[3];
  vtkSmartPointer<vtkImageData> scatterings[3];
  for (int i = 0; i < 3; ++i)
  {
    this->Rays->RemoveAllLights();
    this->Rays->AddLight(lights[i]);
    layers[i] = this->GetLayer();
    scatterings[i] = this->GetScattering();
  }
  for (vtkLight* light : lights)
  {
    this->Rays->AddLight(light);
  }
  auto layer = this->GetLayer(); // after a COMPOSITE frame
  auto scattering = this->GetScattering();
  this->Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
  auto shownLayer = this->GetLayer();
  EXPECT_EQ(GetLargestDifference(layer, shownLayer), 0.0);
  ForEachPixel(layer,
    [&](int x, int y)
    {
      for (int c = 0; c < 3; ++c)
      {
        double sums[2] = { 0.0, 0.0 };
        for (int i = 0; i < 3; ++i)
        {
          sums[0] += GetValue(layers[i], x, y, c);
          sums[1] += GetValue(scatterings[i], x, y, c);
        }
        EXPECT_NEAR(GetValue(layer, x, y, c), sums[0], 1e-6);
        EXPECT_NEAR(GetValue(scattering, x, y, c), sums[1], 1e-6);
      }
    });
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_GT(GetSum(layer, c), 10.0);
    EXPECT_GT(GetSum(scattering, c), 1.0);
  }
}

//------------------------------------------------------------------------------
// Kinds of lights

TEST_F(GodRaysOcclusion, LightsOfEveryKindAreWhereVTKHasThem)
{
  this->Rays->SetSourceRadius(0.5);
  const auto expect = [&](std::array<double, 3> towards)
  {
    std::array<double, 3> found;
    EXPECT_GT(GetSolidAngle(this->GetLayer(), this->Renderer, found), 0.0);
    EXPECT_LT(GetAngle(found, towards), 0.001) << found[0] << ", " << found[1];
  };
  // camera lights: in coordinates in which the eye is at (0, 0, 1) and looks at the origin, at the
  // distance from the eye to the focal point; not in the renderer's list, so nobody else moves them
  auto light = MakeLamplight({ 0.1, 0.05, -0.2 });
  light->SetLightTypeToCameraLight();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Rays->AddLight(light);
  expect({ 1.0, 0.5, -12.0 });
  light->PositionalOff();
  this->Rays->SetSunAngularRadius(1.0);
  light->SetPosition(0.1, 0.05, -1.0);
  expect({ 0.1, 0.05, -1.0 });

  // after the camera has turned they turn with it
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(10.0, 0.0, 0.0);
  expect({ 0.1, 0.05, -1.0 }); // in the picture
  camera->SetPosition(0.0, 0.0, 10.0);

  // scene lights with a transform
  light->SetLightTypeToSceneLight();
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, -0.5, 0.0);
  transform->RotateX(180.0);
  light->SetTransformMatrix(transform->GetMatrix());
  light->PositionalOn();
  light->SetPosition(0.2, -1.0, 3.0); // becomes (1.2, 0.5, -3)
  expect({ 1.2, 0.5, -13.0 });
  light->PositionalOff();
  light->SetPosition(0.1, -0.05, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  expect({ 0.1, 0.05, -1.0 });

  // headlights are at the eye: behind everything that they light
  light->SetTransformMatrix(nullptr);
  light->SetLightTypeToHeadlight();
  light->SetPosition(0.1, 0.05, -1.0); // which does not count
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "behind the camera")) << this->Rays->GetPlan();
}

//------------------------------------------------------------------------------
// Extremes

TEST_F(GodRaysOcclusion, IntensitiesBeyondTheDisplaySurviveToTheLimitOfTheLayer)
{
  this->AddBox({ 0.0, 0.0, 0.0 }, { 0.2, 4.0, 0.2 });
  auto sun = this->AddSun({ 0.1, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  this->Rays->SetPrecision(vtkGodRaysPass::HALF);
  const auto greatest = [&](vtkImageData* image)
  {
    double value = 0.0;
    ForEachPixel(image, [&](int x, int y) { value = std::max(value, GetValue(image, x, y)); });
    return value;
  };
  for (double intensity : { 1.0, 50.0, 6e4 })
  {
    sun->SetIntensity(intensity);
    EXPECT_NEAR(greatest(this->GetLayer()) / intensity, 1.0, 5e-4);
    const double brightest = greatest(this->GetScattering());
    EXPECT_GT(brightest, 0.3 * intensity);
    EXPECT_TRUE(std::isfinite(brightest));
  }
  sun->SetIntensity(1e9);
  EXPECT_EQ(greatest(this->GetLayer()), 65504.0);
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  EXPECT_NEAR(greatest(this->GetLayer()) / 1e9, 1.0, 1e-6);
}

TEST_F(GodRaysOcclusion, ColorsThatAreNoNumbersDoNoHarm)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->AddBox({ 0.0, 0.0, 0.0 }, { 0.2, 4.0, 0.2 });
  auto sun = this->AddSun({ 0.1, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  this->Rays->SetBackgroundGlow(0.5);
  for (double scale : { 1.0, 0.25 })
  {
    this->Rays->SetResolutionScale(scale);
    sun->SetDiffuseColor(0.0, 1.0, 0.0);
    auto layer = this->GetLayer();
    auto scattering = this->GetScattering();
    EXPECT_GT(GetSum(scattering, 1), 1.0);
    sun->SetDiffuseColor(nan, 1.0, -1.0);
    EXPECT_EQ(GetLargestDifference(layer, this->GetLayer()), 0.0);
    EXPECT_EQ(GetLargestDifference(scattering, this->GetScattering()), 0.0);
  }
  sun->SetDiffuseColor(nan, nan, nan);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "off or black")) << this->Rays->GetPlan();
  sun->SetDiffuseColor(1.0, 1.0, 1.0);
  sun->SetPosition(nan, 0.0, -1.0);
  this->Scene.Window->Render();
  const auto pixels = GetPixels(this->Scene.Window);
  this->Rays->SetIntensity(0.0);
  EXPECT_EQ(pixels, GetPixels(this->Scene.Window)) << "a light that is nowhere makes no rays";
}
