// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of what lets part of the light through, against numbers and the ground truth.

#include "GodRaysLonelyCompositor.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysIntegrator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

using namespace GodRaysTesting;

namespace
{
class GodRaysTranslucentShadows : public MediumTest
{
protected:
  GodRaysTranslucentShadows() { this->Scene.Window->SetSize(128, 96); }

  /// A sheet from a corner along two edges.
  vtkActor* AddPane(std::array<double, 3> corner, std::array<double, 3> one,
    std::array<double, 3> other, double opacity, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(corner.data());
    plane->SetPoint1(corner[0] + one[0], corner[1] + one[1], corner[2] + one[2]);
    plane->SetPoint2(corner[0] + other[0], corner[1] + other[1], corner[2] + other[2]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    this->Renderer->AddActor(actor);
    return actor;
  }

  /// One above all that is seen.
  vtkActor* AddRoof(double height, double opacity, std::array<double, 3> color = { 1.0, 1.0, 1.0 })
  {
    return this->AddPane(
      { -60.0, height, -60.0 }, { 120.0, 0.0, 0.0 }, { 0.0, 0.0, 120.0 }, opacity, color);
  }

  /// Data that are 1 everywhere, in a box, of an opacity for each unit of length.
  vtkVolume* AddSlab(std::array<double, 3> low, std::array<double, 3> size, double opacity)
  {
    vtkNew<vtkImageData> data;
    data->SetDimensions(5, 5, 5);
    data->SetOrigin(low.data());
    data->SetSpacing(0.25 * size[0], 0.25 * size[1], 0.25 * size[2]);
    data->AllocateScalars(VTK_FLOAT, 1);
    std::fill_n(static_cast<float*>(data->GetScalarPointer()), 125, 1.0f);
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, opacity);
    opacities->AddPoint(2.0, opacity);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetScalarOpacity(opacities);
    this->Renderer->AddVolume(volume);
    return volume;
  }

  /// Panes before, among and behind pillars.
  void AddPanes()
  {
    this->AddPillars();
    this->Panes = {
      this->AddPane({ -4.0, -1.5, 1.0 }, { 8.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, 0.5),
      this->AddPane(
        { -1.0, -2.0, -1.5 }, { 3.0, 0.0, -1.0 }, { 0.0, 4.0, 0.0 }, 0.3, { 1.0, 0.2, 0.0 }),
    };
  }

  /// What is left of the light in the middle of the picture.
  double GetLeft(int channel = 0)
  {
    auto image = this->GetScattering();
    return GetValue(image, 64, 48, channel) / this->Lit;
  }

  void MeasureLit()
  {
    this->AddSun({ 0.1, 1.0, 0.05 });
    this->Lit = GetValue(this->GetScattering(), 64, 48);
    EXPECT_GT(this->Lit, 1e-7);
  }

  std::vector<vtkActor*> Panes;
  double Lit = 0.0;
};
}

TEST_F(GodRaysTranslucentShadows, LetPartOfTheLightThrough)
{
  this->MeasureLit();
  auto one = this->AddRoof(12.0, 0.5);
  EXPECT_NEAR(this->GetLeft(), 0.5, 1e-3);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "1 layers")) << this->Rays->GetPlan();
  auto two = this->AddRoof(14.0, 0.5);
  EXPECT_NEAR(this->GetLeft(), 0.25, 1e-3);
  one->GetProperty()->SetOpacity(0.2);
  const double product = this->GetLeft();
  EXPECT_NEAR(product, 0.8 * 0.5, 1e-3);
  one->GetProperty()->SetOpacity(0.5);
  two->GetProperty()->SetOpacity(0.2);
  EXPECT_NEAR(this->GetLeft(), product, 1e-4) << "whichever comes first";
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "2 layers")) << this->Rays->GetPlan();
  vtkGodRaysPass::SetRole(one, vtkGodRaysPass::IGNORED);
  vtkGodRaysPass::SetRole(two, vtkGodRaysPass::IGNORED);
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-4);
}

TEST_F(GodRaysTranslucentShadows, ColourTheLight)
{
  this->MeasureLit();
  auto roof = this->AddRoof(12.0, 0.5, { 0.8, 0.4, 0.0 });
  EXPECT_NEAR(this->GetLeft(0), 0.5, 1e-3);
  EXPECT_NEAR(this->GetLeft(1), 0.25, 1e-3);
  EXPECT_NEAR(this->GetLeft(2), 0.125, 1e-3);
  // a grey one dims alike, however dark it is and however the scene's lights light it
  roof->GetProperty()->SetColor(0.1, 0.1, 0.1);
  EXPECT_NEAR(this->GetLeft(0), 0.5, 1e-3);
  EXPECT_NEAR(this->GetLeft(2), 0.5, 1e-3);
  roof->GetProperty()->LightingOff();
  EXPECT_NEAR(this->GetLeft(1), 0.5, 1e-3);
}

TEST_F(GodRaysTranslucentShadows, AmongOpaqueThings)
{
  this->MeasureLit();
  auto pane = this->AddRoof(12.0, 0.5);
  auto wall = this->AddRoof(14.0, 1.0);
  EXPECT_NEAR(this->GetLeft(), 0.0, 1e-4) << "behind what is opaque";
  wall->SetPosition(0.0, -4.0, 0.0);
  EXPECT_NEAR(this->GetLeft(), 0.0, 1e-4) << "before it";
  wall->VisibilityOff();
  EXPECT_NEAR(this->GetLeft(), 0.5, 1e-3);
  pane->VisibilityOff();
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-4);
}

// With panes that are ignored, which then cast no shadow, the same error is beyond its bound.
TEST_F(GodRaysTranslucentShadows, AreTheGroundTruth)
{
  this->AddPanes();
  struct
  {
    const char* Name;
    std::array<double, 4> Light;
    double Bound;
  } cases[] = {
    { "sun in front", { 0.15, 0.1, -1.0, 0.0 }, 0.0025 },
    { "sun beside", { 1.0, 0.3, -0.4, 0.0 }, 0.0015 },
    { "sun behind", { 0.3, 0.4, 1.0, 0.0 }, 0.0015 },
    { "lamp in front", { 0.0, 0.5, -3.0, 1.0 }, 0.0005 },
    { "lamp behind", { 0.5, 1.0, 12.0, 1.0 }, 0.0015 },
  };
  for (const auto& each : cases)
  {
    const double error = this->GetError(each.Light);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "2 layers")) << this->Rays->GetPlan();
    for (vtkActor* pane : this->Panes)
    {
      vtkGodRaysPass::SetRole(pane, vtkGodRaysPass::IGNORED);
    }
    const double without = this->GetError(each.Light);
    for (vtkActor* pane : this->Panes)
    {
      vtkGodRaysPass::SetRole(pane, vtkGodRaysPass::AUTOMATIC);
    }
    this->Rays->SetErrorTolerance(1e-3);
    const double finer = this->GetError(each.Light);
    this->Rays->SetErrorTolerance(1.0 / 255.0);
    std::cout << each.Name << ": " << error << ", finer " << finer << ", without their shadows "
              << without << "\n";
    EXPECT_LT(finer, 1e-3) << each.Name;
    RecordProperty(each.Name, std::to_string(error));
    EXPECT_LT(error, each.Bound) << each.Name;
    EXPECT_GT(without, 2.0 * each.Bound) << each.Name;
  }
}

// What pictures say of their own error, by the pieces that sheets cut view rays into, is what a mean of
// pictures without sheets says. Errors of colours are counted otherwise there.
TEST_F(GodRaysTranslucentShadows, AreVerified)
{
  this->AddPanes();
  this->Panes[1]->GetProperty()->SetColor(1.0, 1.0, 1.0);
  for (const std::array<double, 4>& light :
    { std::array<double, 4>{ 0.15, 0.1, -1.0, 0.0 }, { 0.5, 1.0, 12.0, 1.0 } })
  {
    const double expected = this->GetError(light);
    auto integrator = this->Rays->GetIntegrator();
    integrator->SetVerifyPixels(128 * 96);
    this->Scene.Window->Render();
    const double measured = integrator->GetErrorEstimate();
    integrator->SetVerifyPixels(0);
    std::cout << "error " << expected << ", measured " << measured << "\n";
    EXPECT_NEAR(measured / expected, 1.0, 0.03);
  }
}

TEST_F(GodRaysTranslucentShadows, AreTheGroundTruthInAParallelProjection)
{
  this->AddPanes();
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(3.0);
  for (const std::array<double, 4>& light : { std::array<double, 4>{ 0.5, 0.3, -1.0, 0.0 },
         { 0.0, 0.0, 1.0, 0.0 }, { 0.5, 1.0, 12.0, 1.0 } })
  {
    const double error = this->GetError(light);
    std::cout << light[0] << " " << light[3] << ": " << error << "\n";
    EXPECT_LT(error, 0.006);
  }
}

TEST_F(GodRaysTranslucentShadows, InAnAtmosphere)
{
  vtkNew<vtkGodRaysAtmosphereModel> air;
  air->SetFarLimit(30.0);
  this->Rays->SetModel(air);
  this->MeasureLit();
  auto roof = this->AddRoof(12.0, 0.5, { 1.0, 0.5, 0.5 });
  const double red = this->GetLeft(0);
  EXPECT_NEAR(red, 0.5, 2e-3);
  roof->GetProperty()->SetColor(1.0, 1.0, 1.0);
  const double green = this->GetLeft(1);
  roof->GetProperty()->SetColor(1.0, 0.5, 0.5);
  EXPECT_NEAR(this->GetLeft(1) / green, 0.25 / 0.5, 4e-3);
}

// The same pictures before panes, and after them.
TEST_F(GodRaysTranslucentShadows, LeaveOtherScenesAlone)
{
  this->AddPillars();
  this->AddSun({ 0.3, 0.4, 1.0 });
  const auto before = GetPixels(this->Scene.Window);
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "layers")) << this->Rays->GetPlan();
  auto pane = this->AddPane({ -4.0, -1.5, 1.0 }, { 8.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, 0.5);
  const auto with = GetPixels(this->Scene.Window);
  EXPECT_GT(GetLargestDifference(before, with), 2);
  EXPECT_EQ(with, GetPixels(this->Scene.Window));
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept")) << this->Rays->GetPlan();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "2 layers")) << this->Rays->GetPlan();
  pane->GetProperty()->SetOpacity(0.1);
  EXPECT_GT(GetLargestDifference(with, GetPixels(this->Scene.Window)), 2);
  this->Renderer->RemoveActor(pane);
  EXPECT_EQ(before, GetPixels(this->Scene.Window));
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "layers")) << this->Rays->GetPlan();
}

// Of a texture: a quarter of it is empty, a quarter opaque, and the rest lets half through.
TEST_F(GodRaysTranslucentShadows, AreCutOut)
{
  this->MeasureLit();
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(4, 1, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const unsigned char alphas[4] = { 0, 255, 128, 128 };
  for (int i = 0; i < 4; ++i)
  {
    auto texel = static_cast<unsigned char*>(picture->GetScalarPointer(i, 0, 0));
    std::fill_n(texel, 3, static_cast<unsigned char>(255));
    texel[3] = alphas[i];
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(picture);
  texture->InterpolateOff();
  texture->RepeatOff();
  auto roof = this->AddRoof(12.0, 1.0);
  roof->SetTexture(texture);
  const double expected[4] = { 1.0, 0.0, 1.0 - 128.0 / 255.0, 1.0 - 128.0 / 255.0 };
  for (int i = 0; i < 4; ++i)
  {
    roof->SetPosition(45.0 - 30.0 * i, 0.0, 0.0); // the quarter's middle is over what is seen
    EXPECT_NEAR(this->GetLeft(), expected[i], 2e-3) << i;
  }
}

// A slab of a known optical depth, above all that is seen; cropped, clipped, and changed.
TEST_F(GodRaysTranslucentShadows, OfVolumes)
{
  this->MeasureLit();
  this->Rays->SetErrorTolerance(0.02); // smaller maps are made sooner
  auto slab = this->AddSlab({ -60.0, 12.0, -60.0 }, { 120.0, 2.0, 120.0 }, 0.1);
  const double slant = std::sqrt(0.1 * 0.1 + 1.0 + 0.05 * 0.05);
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 2.0 * slant), 1e-3);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "16 layers")) << this->Rays->GetPlan();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), ", kept")) << this->Rays->GetPlan();
  slab->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 4.0 * slant), 1e-3);
  vtkPiecewiseFunction* factors =
    slab->GetProperty()->GetGradientOpacity(0); // made now, 1 everywhere
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 4.0 * slant), 1e-3);
  factors->AddPoint(0.0, 0.5);
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-3);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "1 volumes cast no shadow")) << this->Rays->GetPlan();
  slab->GetProperty()->DisableGradientOpacityOn();
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 4.0 * slant), 1e-3);
  auto pane = this->AddRoof(13.0, 0.5);
  EXPECT_NEAR(this->GetLeft(), 0.5 * std::pow(0.9, 4.0 * slant), 1e-3) << "a pane in it";
  pane->VisibilityOff();
  auto mapper = vtkVolumeMapper::SafeDownCast(slab->GetMapper());
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(-60.0, 60.0, 12.5, 14.0, -60.0, 60.0);
  mapper->SetCroppingRegionFlagsToSubVolume();
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 3.0 * slant), 4e-3);
  mapper->CroppingOff();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 13.0, 0.0);
  plane->SetNormal(0.0, -1.0, 0.0);
  mapper->AddClippingPlane(plane);
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 2.0 * slant), 4e-3);
  plane->SetNormal(1.0, 0.0, 0.0);
  plane->SetOrigin(40.0, 0.0, 0.0);
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-3);
  vtkGodRaysPass::SetRole(slab, vtkGodRaysPass::IGNORED);
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-4);
}

// The opacity is that of the last component, or, of independent ones, of the first.
TEST_F(GodRaysTranslucentShadows, OfVolumesOfSeveralComponents)
{
  this->MeasureLit();
  this->Rays->SetErrorTolerance(0.02);
  auto slab = this->AddSlab({ -60.0, 12.0, -60.0 }, { 120.0, 2.0, 120.0 }, 0.1);
  auto mapper = vtkVolumeMapper::SafeDownCast(slab->GetMapper());
  vtkNew<vtkImageData> data;
  data->CopyStructure(mapper->GetDataSetInput());
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  data->GetPointData()->GetScalars()->FillComponent(0, 0.0);
  data->GetPointData()->GetScalars()->FillComponent(1, 1.0);
  mapper->SetInputDataObject(data);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(1.0, 0.1);
  slab->GetProperty()->SetScalarOpacity(opacities);
  EXPECT_NEAR(this->GetLeft(), 1.0, 1e-3);
  slab->GetProperty()->IndependentComponentsOff();
  const double slant = std::sqrt(0.1 * 0.1 + 1.0 + 0.05 * 0.05);
  EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 2.0 * slant), 1e-3);
}

// Along a view ray in a slab that fills the picture's depths, against a sum of the two exponentials.
TEST_F(GodRaysTranslucentShadows, InsideAVolume)
{
  this->Rays->SetErrorTolerance(0.02);
  const double sigma = 0.05;
  this->AddSun({ 0.0, 1.0, 0.0 });
  auto image = this->GetScattering();
  const double lit = GetValue(image, 64, 48);
  // The middle of the picture is seen at y = 0, with 6 of 12 above it.
  this->AddSlab({ -60.0, -6.0, -60.0 }, { 120.0, 12.0, 120.0 }, 1.0 - std::exp(-sigma));
  const double left = GetValue(this->GetScattering(), 64, 48) / lit;
  std::cout << "left in the middle of a slab: " << left << ", " << std::exp(-6.0 * sigma) << "\n";
  EXPECT_NEAR(left, std::exp(-6.0 * sigma), 0.01);
}

// As VTK draws them: a length on which the opacity is taken is one of the data's own coordinates.
TEST_F(GodRaysTranslucentShadows, OfVolumesThatAreScaled)
{
  this->MeasureLit();
  this->Rays->SetErrorTolerance(0.02);
  const double slant = std::sqrt(0.1 * 0.1 + 1.0 + 0.05 * 0.05);
  auto slab = this->AddSlab({ -60.0, 12.0, -60.0 }, { 120.0, 2.0, 120.0 }, 0.1);
  slab->SetOrigin(0.0, 12.0, 0.0);
  for (const std::array<double, 3>& scale :
    { std::array<double, 3>{ 2.0, 2.0, 2.0 }, { 0.5, 3.0, 2.0 }, { 3.0, 0.5, 3.0 } })
  {
    slab->SetScale(scale[0], scale[1], scale[2]);
    // The light's ray is changed by the scale.
    const double length = std::sqrt(
      std::pow(0.1 / scale[0], 2) + std::pow(1.0 / scale[1], 2) + std::pow(0.05 / scale[2], 2));
    EXPECT_NEAR(this->GetLeft(), std::pow(0.9, 2.0 * scale[1] * length), 1e-3) << scale[1];
    EXPECT_GT(std::abs(std::pow(0.9, 2.0 * scale[1] * slant) - this->GetLeft()), 0.05);
  }
}

TEST_F(GodRaysTranslucentShadows, OfVolumesInTheLightOfALamp)
{
  const std::array<double, 4> light{ 0.0, 9.0, 0.0, 1.0 };
  this->SetLight(light);
  // It is in the scene all the time: its bounds are what a lamp's power goes by.
  auto slab = this->AddSlab({ -60.0, 6.0, -60.0 }, { 120.0, 1.0, 120.0 }, 0.2);
  vtkGodRaysPass::SetRole(slab, vtkGodRaysPass::IGNORED);
  const double lit = GetValue(this->GetScattering(), 64, 48);
  vtkGodRaysPass::SetRole(slab, vtkGodRaysPass::AUTOMATIC);
  const double left = GetValue(this->GetScattering(), 64, 48) / lit;
  // A ray to z on the axis of view goes through the slab over sqrt(81 + z z)/9.
  double sum = 0.0;
  double all = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const double s = 0.01 * (i + 0.5);
    const double z = this->Renderer->GetActiveCamera()->GetPosition()[2] - s;
    const double way = std::sqrt(81.0 + z * z);
    const double cosine = z / way; // of the angle by which light is turned
    const double phase = std::pow(1.36 - 1.2 * cosine, -1.5);
    const double value = std::exp(-0.05 * (s + way)) / (way * way) * phase;
    all += value;
    sum += value * std::pow(0.8, way / 9.0);
  }
  std::cout << "left of a lamp: " << left << ", " << sum / all << "\n";
  EXPECT_NEAR(left, sum / all, 0.004);
}

TEST_F(GodRaysTranslucentShadows, AreJoinedOnSeveralProcesses)
{
  this->AddPanes();
  this->AddSlab({ -3.0, 2.5, -3.0 }, { 6.0, 1.0, 6.0 }, 0.2);
  this->SetLight({ 0.3, 0.4, 1.0, 0.0 });
  auto alone = this->GetScattering();
  vtkNew<LonelyCompositor> compositor;
  this->Rays->SetCompositor(compositor);
  auto joined = this->GetScattering();
  EXPECT_GT(compositor->Calls, 8);
  double largest = 0.0;
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      largest = std::max(largest, std::abs(GetValue(alone, x, y) - GetValue(joined, x, y)));
    }
  }
  EXPECT_LT(largest, 1e-4 * GetMean(alone));
  EXPECT_TRUE(Says(this->Rays->GetPlan(), " layers")) << this->Rays->GetPlan();
  this->Rays->SetCompositor(nullptr);
}
