// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Light of all orders of scattering in rendered frames, against Monte Carlo.

#include "../Filters/GodRaysGridScenes.h"
#include "../Filters/GodRaysMultipleScatteringReference.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysVolumeModel.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

using namespace GodRaysTesting;
using vtkGodRays::Vec3;

namespace
{
constexpr int Step = 16; // pixels between those that are compared

class GodRaysScatteringOrders : public MediumTest
{
protected:
  vtkNew<vtkGodRaysVolumeModel> Alone;

  GodRaysScatteringOrders()
  {
    this->Scene.Window->SetSize(160, 120);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 3.5);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(60.0);
  }

  /// Pillars before a wall that ends all view rays.
  void AddHall()
  {
    this->AddPillars(0.6);
    this->Renderer->AddActor(MakeBox({ 0.0, 0.0, -4.0 }, { 12.0, 8.0, 0.2 }));
  }

  vtkVolume* AddCloud(double opacity)
  {
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    this->Data = GodRaysGridScenes::MakePlume(33);
    mapper->SetInputData(this->Data);
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, 0.0);
    opacities->AddPoint(4.0, opacity);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetScalarOpacity(opacities);
    volume->GetProperty()->SetColor(white);
    vtkGodRaysPass::SetRole(volume, vtkGodRaysPass::MEDIUM);
    this->Renderer->AddVolume(volume);
    return volume;
  }

  std::vector<Vec3> GetPixels(int orders)
  {
    auto* model = vtkGodRaysMediumModel::SafeDownCast(this->Rays->GetModel());
    model->SetScatteringOrders(orders);
    const auto image = this->GetScattering();
    const int* size = image->GetDimensions();
    std::vector<Vec3> pixels;
    for (int y = Step / 2; y < size[1]; y += Step)
    {
      for (int x = Step / 2; x < size[0]; x += Step)
      {
        pixels.emplace_back(image->GetScalarComponentAsDouble(x, y, 0, 0),
          image->GetScalarComponentAsDouble(x, y, 0, 1),
          image->GetScalarComponentAsDouble(x, y, 0, 2));
      }
    }
    return pixels;
  }

  /// What the pictures are of, but for occluders.
  vtkGodRaysTransportScene GetScene(std::array<double, 4> light)
  {
    double bounds[6];
    this->Renderer->ComputeVisiblePropBounds(bounds);
    vtkBoundingBox box(bounds);
    const double diagonal = box.GetDiagonalLength();
    vtkGodRaysTransportScene scene;
    scene.Medium.NumberOfComponents = 0;
    if (this->Rays->GetModel() == this->Model)
    {
      box.Inflate(0.25 * diagonal);
      scene.Medium.NumberOfComponents = 1;
      vtkGodRaysMedium::Component& air = scene.Medium.Components[0];
      std::copy_n(this->Model->GetScatteringCoefficient(), 3, air.Scattering);
      std::copy_n(this->Model->GetAbsorptionCoefficient(), 3, air.Absorption);
      air.PhaseFunction = this->Model->GetPhaseFunction();
      air.Asymmetry = this->Model->GetAsymmetry();
    }
    for (int i = 0; i < 3; ++i)
    {
      scene.Low[i] = box.GetBound(2 * i);
      scene.High[i] = box.GetBound(2 * i + 1);
    }
    vtkGodRaysTransportScene::Light lamp;
    lamp.Position = Vec3(light[0], light[1], light[2]);
    lamp.Directional = light[3] == 0.0;
    lamp.Color = Vec3(vtkMath::Pi() * (light[3] == 0.0 ? 1.0 : 0.25 * diagonal * diagonal));
    scene.Lights.push_back(lamp);
    return scene;
  }

  /// The root mean square error of light that is scattered twice and more, as a fraction of the brightest
  /// light of all orders; and what it is if there were none.
  void Compare(std::array<double, 4> light, const vtkGodRaysTransportScene& scene, double& error,
    double& control)
  {
    this->SetLight(light);
    const std::vector<Vec3> once = this->GetPixels(vtkGodRaysMediumModel::SINGLE);
    const std::vector<Vec3> all = this->GetPixels(vtkGodRaysMediumModel::ALL);
    vtkNew<vtkAppendPolyData> occluders;
    vtkActorCollection* actors = this->Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      vtkNew<vtkTransform> toWorld;
      toWorld->SetMatrix(actor->GetMatrix());
      vtkNew<vtkTransformFilter> moved;
      moved->SetTransform(toWorld);
      moved->SetInputData(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
      moved->Update();
      occluders->AddInputData(moved->GetPolyDataOutput());
    }
    GodRaysMultipleScatteringReference truth;
    if (occluders->GetNumberOfInputConnections(0) > 0)
    {
      occluders->Update();
    }
    truth.SetScene(scene, occluders->GetOutput(), 0.0);
    const int* size = this->Scene.Window->GetSize();
    double squares[2] = { 0.0, 0.0 };
    double noise = 0.0;
    double peak = 0.0;
    std::size_t k = 0;
    for (int y = Step / 2; y < size[1]; y += Step)
    {
      for (int x = Step / 2; x < size[0]; x += Step, ++k)
      {
        Vec3 places[2];
        for (int end = 0; end < 2; ++end)
        {
          this->Renderer->SetDisplayPoint(x + 0.5, y + 0.5, end);
          this->Renderer->DisplayToWorld();
          const double* place = this->Renderer->GetWorldPoint();
          places[end] = Vec3(place[0], place[1], place[2]) / place[3];
        }
        const Vec3 along = glm::normalize(places[1] - places[0]);
        const double* eye = this->Renderer->GetActiveCamera()->GetPosition();
        const bool parallel = this->Renderer->GetActiveCamera()->GetParallelProjection() != 0;
        const Vec3 origin(eye[0], eye[1], eye[2]); // with parallel rays, in its plane
        const auto known = truth.Evaluate(
          parallel ? places[0] - vtkGodRays::dot(places[0] - origin, along) * along : origin, along,
          1, this->Paths, static_cast<unsigned int>(k));
        squares[0] += std::pow(all[k].y - once[k].y - known.Orders, 2);
        squares[1] += std::pow(known.Orders, 2);
        noise += known.Variance;
        peak = std::max(peak, known.Single + known.Orders);
      }
    }
    error = std::sqrt(std::max(squares[0] - noise, 0.0) / k) / peak;
    control = std::sqrt(squares[1] / k) / peak;
    std::cout << "error " << error << ", without " << control << ", noise "
              << std::sqrt(noise / k) / peak << "\n";
  }

  vtkSmartPointer<vtkImageData> Data;
  int Paths = 2000;
};

struct Medium
{
  const char* Name;
  std::array<double, 4> Light;
  double Asymmetry;
  double Coefficient;
  bool Parallel;
};

class GodRaysScatteringOrdersOfMedia
  : public GodRaysScatteringOrders
  , public ::testing::WithParamInterface<Medium>
{
};

TEST_P(GodRaysScatteringOrdersOfMedia, AreThoseOfMonteCarlo)
{
  const Medium& each = this->GetParam();
  this->AddHall();
  this->Model->SetAsymmetry(each.Asymmetry);
  const double scattering = each.Coefficient;
  this->Model->SetScatteringCoefficient(scattering, scattering, scattering);
  this->Renderer->GetActiveCamera()->SetParallelProjection(each.Parallel);
  this->Renderer->GetActiveCamera()->SetParallelScale(2.5);
  this->Renderer->ResetCameraClippingRange();
  double error;
  double control;
  this->Compare(each.Light, this->GetScene(each.Light), error, control);
  EXPECT_LT(error, 0.05);
  EXPECT_GT(control, 3.0 * error);
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysScatteringOrdersOfMedia,
  ::testing::Values(Medium{ "sun", { -0.5, 0.6, 0.6, 0.0 }, 0.0, 0.1, false },
    Medium{ "forward", { -0.5, 0.6, 0.6, 0.0 }, 0.7, 0.1, false },
    Medium{ "parallel", { -0.5, 0.6, 0.6, 0.0 }, 0.3, 0.1, true },
    Medium{ "isotropic", { -0.5, 0.6, 0.6, 0.0 }, 0.0, 0.3, false },
    Medium{ "thin", { -0.5, 0.6, 0.6, 0.0 }, 0.5, 0.03, false },
    Medium{ "dense", { -0.5, 0.6, 0.6, 0.0 }, 0.5, 0.3, false },
    Medium{ "lamp", { 0.6, 1.0, -2.0, 1.0 }, 0.3, 0.1, false }),
  [](const auto& info) { return info.param.Name; });

TEST_F(GodRaysScatteringOrders, OfDataAreThoseOfMonteCarlo)
{
  vtkVolume* volume = this->AddCloud(0.9);
  this->Alone->SetFarLimit(30.0);
  this->Rays->SetModel(this->Alone);
  this->Renderer->ResetCamera();
  for (const double asymmetry : { 0.0, 0.6 })
  {
    this->Alone->SetDataAsymmetry(asymmetry);
    const std::array<double, 4> light = { -0.7, 0.5, 0.5, 0.0 };
    vtkGodRaysTransportScene scene = this->GetScene(light);
    vtkNew<vtkImageData> extinction;
    extinction->DeepCopy(this->Data);
    vtkDataArray* values = extinction->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetTuple1(i,
        -std::log(1.0 - volume->GetProperty()->GetScalarOpacity()->GetValue(values->GetTuple1(i))));
    }
    scene.Grids.emplace_back();
    ASSERT_EQ(scene.Grids[0].Read(extinction), "");
    scene.Grids[0].PhaseFunction = vtkGodRaysMediumModel::HENYEY_GREENSTEIN;
    scene.Grids[0].Asymmetry = asymmetry;
    double error;
    double control;
    this->Compare(light, scene, error, control);
    EXPECT_LT(error, 0.05) << asymmetry;
    EXPECT_GT(control, 3.0 * error) << asymmetry;
  }
}

// The plan tells whether a solution was kept.
TEST_F(GodRaysScatteringOrders, AreSolvedWhereLightMediumOrOccludersChange)
{
  this->AddHall();
  this->SetLight({ -0.5, 0.6, 0.6, 0.0 });
  this->Model->SetScatteringOrders(vtkGodRaysMediumModel::ALL);
  const auto isKept = [this]()
  {
    this->Scene.Window->Render();
    const std::string plan = this->Rays->GetPlan();
    EXPECT_TRUE(Says(plan, "all orders of scattering")) << plan;
    return !Says(plan, "solved in");
  };
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  for (int i = 0; i < 20; ++i)
  {
    camera->Azimuth(7.0);
    camera->Elevation(i % 5 - 2.0);
    camera->Dolly(i % 3 == 0 ? 1.1 : 0.97);
    this->Renderer->ResetCameraClippingRange();
    EXPECT_TRUE(isKept()) << i;
  }
  this->SetLight({ -0.5, 0.6, 0.5, 0.0 });
  EXPECT_FALSE(isKept());
  this->Model->SetAsymmetry(0.1);
  EXPECT_FALSE(isKept());
  vtkActor* last = this->Renderer->GetActors()->GetLastActor();
  last->SetPosition(0.1, 0.0, 0.0);
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
}

TEST_F(GodRaysScatteringOrders, AreNotThereUnlessAskedFor)
{
  this->AddHall();
  this->SetLight({ -0.5, 0.6, 0.6, 0.0 });
  EXPECT_EQ(this->Model->GetScatteringOrders(), vtkGodRaysMediumModel::SINGLE);
  const std::vector<Vec3> once = this->GetPixels(vtkGodRaysMediumModel::SINGLE);
  const std::vector<Vec3> all = this->GetPixels(vtkGodRaysMediumModel::ALL);
  EXPECT_EQ(this->GetPixels(vtkGodRaysMediumModel::ALL), all);
  EXPECT_EQ(this->GetPixels(vtkGodRaysMediumModel::SINGLE), once);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_GT(all[i].y, once[i].y);
  }
}

// Two lights are the sum of each; three colours are those of the light.
TEST_F(GodRaysScatteringOrders, AddUp)
{
  this->AddHall();
  const auto find = [this](std::vector<std::array<double, 3>> lights)
  {
    this->Rays->RemoveAllLights();
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      this->AddSun(lights[i], { 1.0, i == 0 ? 0.5 : 1.0, 0.25 });
    }
    std::vector<Vec3> pixels = this->GetPixels(vtkGodRaysMediumModel::ALL);
    const std::vector<Vec3> once = this->GetPixels(vtkGodRaysMediumModel::SINGLE);
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      pixels[i] -= once[i];
    }
    return pixels;
  };
  const std::array<double, 3> one = { -0.5, 0.6, 0.6 };
  const std::array<double, 3> other = { 0.7, 0.3, 0.4 };
  const auto both = find({ one, other });
  const auto first = find({ one });
  auto swapped = find({ other, one });
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    EXPECT_NEAR(first[i].x * vtkGodRays::DecodeDisplay(0.25), first[i].z, 1e-4 * first[i].x) << i;
    // The light that is first is half as green: together they are as bright in red both ways.
    EXPECT_NEAR(both[i].x, swapped[i].x, 4e-3 * both[i].x) << i;
    EXPECT_GT(both[i].x, first[i].x) << i;
  }
}

// A layer of air over a plane is as good as one over a large planet.
TEST_F(GodRaysScatteringOrders, AreThereOverAPlanet)
{
  this->AddHall();
  this->SetLight({ -0.5, 0.6, 0.6, 0.0 });
  vtkNew<vtkGodRaysAtmosphereModel> air;
  air->SetRayleighScattering(0.1, 0.1, 0.1);
  air->SetRayleighScaleHeight(3.0);
  air->SetMieScattering(0.0, 0.0, 0.0);
  air->SetMieAbsorption(0.0, 0.0, 0.0);
  air->SetWorldUnitInMeters(1.0);
  air->SetUp(0.0, 1.0, 0.0);
  air->SetGroundLevel(-6.0);
  this->Rays->SetModel(air);
  std::vector<Vec3> pixels[2];
  for (const double radius : { 0.0, 1e7 })
  {
    air->SetPlanetRadius(radius);
    pixels[radius > 0.0] = this->GetPixels(vtkGodRaysMediumModel::ALL);
    const std::vector<Vec3> once = this->GetPixels(vtkGodRaysMediumModel::SINGLE);
    for (std::size_t i = 0; i < once.size(); ++i)
    {
      EXPECT_GT(pixels[radius > 0.0][i].y, 1.02 * once[i].y) << radius << " " << i;
    }
  }
  for (std::size_t i = 0; i < pixels[0].size(); ++i)
  {
    EXPECT_NEAR(pixels[0][i].y, pixels[1][i].y, 2e-3 * pixels[0][i].y) << i;
  }
}
}
