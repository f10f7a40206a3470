// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes as media of data, in rendered frames, against the ground truth with the same data.

#include "../Filters/GodRaysGridScenes.h"
#include "GodRaysLonelyCompositor.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSingleScattering.h"
#include "vtkGodRaysVolumeModel.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageAppendComponents.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace GodRaysTesting;
using GodRaysGridScenes::MakePlume;

namespace
{
constexpr double Tolerance = 1.0 / 255.0;

/// Counts how often its numbers are asked for.
class CountingArray : public vtkFloatArray
{
public:
  static CountingArray* New();
  vtkTypeMacro(CountingArray, vtkFloatArray);
  int Readings = 0;

  void* GetVoidPointer(vtkIdType i) override
  {
    ++this->Readings;
    return this->Superclass::GetVoidPointer(i);
  }
};
vtkStandardNewMacro(CountingArray);

class GodRaysVolumeMedium : public MediumTest
{
protected:
  vtkNew<vtkGodRaysVolumeModel> Alone;
  vtkVolume* Smoke = nullptr;
  vtkSmartPointer<vtkImageData> Data = MakePlume(49);

  GodRaysVolumeMedium() { this->Scene.Window->SetSize(96, 72); }

  /// A plume about a place, of half its opacity for each length of 0.7.
  vtkVolume* AddSmoke(std::array<double, 3> place = { 0.0, 0.0, 0.0 })
  {
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(this->Data);
    vtkNew<vtkPiecewiseFunction> opacities;
    opacities->AddPoint(0.0, 0.0);
    opacities->AddPoint(1.5, 0.5);
    opacities->AddPoint(4.0, 0.8);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetScalarOpacity(opacities);
    volume->GetProperty()->SetColor(white);
    volume->GetProperty()->SetScalarOpacityUnitDistance(0.7);
    volume->SetPosition(place[0], place[1], place[2] + 6.0);
    vtkGodRaysPass::SetRole(volume, vtkGodRaysPass::MEDIUM);
    this->Renderer->AddVolume(volume);
    this->Smoke = volume;
    return volume;
  }

  /// The extinction of a volume in the world, point by point.
  static vtkSmartPointer<vtkImageData> GetExtinction(vtkVolume* volume)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
    image->DeepCopy(mapper->GetInput());
    double origin[3];
    vtkMath::Add(image->GetOrigin(), volume->GetPosition(), origin);
    image->SetOrigin(origin);
    vtkDataArray* values = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double opacity =
        volume->GetProperty()->GetScalarOpacity()->GetValue(values->GetTuple1(i));
      values->SetTuple1(
        i, -std::log(1.0 - opacity) / volume->GetProperty()->GetScalarOpacityUnitDistance());
    }
    return image;
  }

  void UseAlone()
  {
    this->Alone->SetFarLimit(30.0);
    this->Rays->SetModel(this->Alone);
  }

  /// The exact light of a view ray, found from camera, actors and volumes rather than by the pass.
  void SetTruth(vtkGodRaysSingleScattering& truth, std::array<double, 4> light, bool withData)
  {
    auto* model = vtkGodRaysMediumModel::SafeDownCast(this->Rays->GetModel());
    vtkGodRaysSingleScattering::Parameters parameters;
    vtkCamera* camera = this->Renderer->GetActiveCamera(); // which looks along -z
    std::copy_n(camera->GetPosition(), 3, parameters.Position);
    parameters.Forward[2] = -1.0;
    parameters.Parallel = camera->GetParallelProjection() != 0;
    std::copy_n(light.data(), 4, parameters.Light);
    double power = vtkMath::Pi();
    if (light[3] != 0.0)
    {
      double bounds[6];
      this->Renderer->ComputeVisiblePropBounds(bounds);
      power *= 0.25 * std::pow(vtkBoundingBox(bounds).GetDiagonalLength(), 2);
    }
    std::fill_n(parameters.LightColor, 3, power);
    if (this->Cone < 90.0)
    {
      double axis[3] = { this->Axis[0], this->Axis[1], this->Axis[2] };
      vtkMath::Normalize(axis);
      parameters.Spot.Axis[0] = axis[0];
      parameters.Spot.Axis[1] = axis[1];
      parameters.Spot.Axis[2] = -axis[2];
      parameters.Spot.CosCone = std::cos(vtkMath::RadiansFromDegrees(this->Cone));
      parameters.Spot.Exponent = 2.0;
    }
    vtkGodRaysMedium::Component& air = parameters.Medium.Components[0];
    if (model == this->Model)
    {
      std::copy_n(this->Model->GetScatteringCoefficient(), 3, air.Scattering);
    }
    air.PhaseFunction = this->Model->GetPhaseFunction();
    air.Asymmetry = this->Model->GetAsymmetry();
    parameters.Medium.FarLimit = 30.0;
    parameters.Tolerance = 1e-4;
    truth.SetParameters(parameters);
    vtkNew<vtkAppendPolyData> all;
    std::vector<vtkGodRaysGrid> grids;
    vtkCollectionSimpleIterator iterator;
    vtkPropCollection* props = this->Renderer->GetViewProps();
    props->InitTraversal(iterator);
    while (vtkProp* prop = props->GetNextProp(iterator))
    {
      if (auto* actor = vtkActor::SafeDownCast(prop))
      {
        actor->GetMapper()->Update();
        vtkNew<vtkTransform> toWorld;
        toWorld->SetMatrix(actor->GetMatrix());
        vtkNew<vtkTransformFilter> placed;
        placed->SetInputData(actor->GetMapper()->GetInput());
        placed->SetTransform(toWorld);
        placed->Update();
        const double opacity = actor->GetProperty()->GetOpacity();
        if (opacity == 1.0)
        {
          all->AddInputConnection(placed->GetOutputPort());
          continue;
        }
        double through[3];
        for (int c = 0; c < 3; ++c)
        {
          through[c] = std::pow(1.0 - opacity, 3.0 - 2.0 * actor->GetProperty()->GetColor()[c]);
        }
        truth.AddVeil(placed->GetPolyDataOutput(), through);
      }
      else if (withData)
      {
        vtkGodRaysGrid grid;
        EXPECT_EQ(grid.Read(GetExtinction(vtkVolume::SafeDownCast(prop))), "");
        grid.Scale = model->GetDataScale();
        std::copy_n(model->GetDataAlbedo(), 3, grid.Albedo);
        grid.PhaseFunction = model->GetDataPhaseFunction();
        grid.Asymmetry = model->GetDataAsymmetry();
        grids.push_back(grid);
      }
    }
    if (all->GetNumberOfInputConnections(0) > 0)
    {
      all->Update();
      truth.SetOccluders(all->GetOutput());
    }
    truth.SetGrids(grids);
  }

  /// Root mean square over the peak, with data and without, at every second or, in haze, third pixel of each
  /// axis. Pixels at an edge, where what is drawn and what a ray meets are two things, do not count.
  std::array<double, 2> GetDataErrors(std::array<double, 4> light)
  {
    auto image = this->GetScattering();
    const auto depths = GetDepths(this->Scene.Window, false);
    const int* size = image->GetDimensions();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double pixel = 2.0 / size[1] *
      (camera->GetParallelProjection()
          ? camera->GetParallelScale()
          : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())));
    std::array<double, 2> errors = {};
    int leftOut = 0;
    const int stride = this->Rays->GetModel() == this->Model ? 3 : 2;
    for (int withData = 0; withData < 2; ++withData)
    {
      vtkGodRaysSingleScattering truth;
      this->SetTruth(truth, light, withData == 1);
      double squares = 0.0;
      double peak = 0.0;
      int count = 0;
      for (int y = 1; y < size[1]; y += stride)
      {
        for (int x = y / stride % stride; x < size[0]; x += stride)
        {
          vtkGodRaysSingleScattering::Result ray;
          truth.Evaluate((x + 0.5 - 0.5 * size[0]) * pixel, (y + 0.5 - 0.5 * size[1]) * pixel, ray);
          const double* range = camera->GetClippingRange();
          const double depth = depths[y * size[0] + x];
          const double seen = camera->GetParallelProjection()
            ? range[0] + depth * (range[1] - range[0])
            : range[0] * range[1] / (range[1] - depth * (range[1] - range[0]));
          if (std::abs(std::min(seen, 25.0) - std::min(ray.Sight, 25.0)) > 0.1)
          {
            ++leftOut;
            continue;
          }
          ++count;
          for (int c = 0; c < 3; ++c)
          {
            squares += std::pow(GetValue(image, x, y, c) - ray.Radiance[c], 2) / 3.0;
            peak = std::max(peak, ray.Radiance[c]);
          }
        }
      }
      errors[withData] = std::sqrt(squares / count) / peak;
    }
    EXPECT_LE(leftOut, 24);
    return { errors[1], errors[0] };
  }

  /// That light in the air and in data is true, and would not be without data.
  void CheckData(const std::string& name, std::array<double, 4> light, double bound = Tolerance)
  {
    if (this->Cone >= 90.0)
    {
      this->SetLight(light);
    }
    const auto [error, control] = this->GetDataErrors(light);
    std::cout << name << ": " << error << ", without data " << control << "\n";
    RecordProperty(name, std::to_string(error));
    EXPECT_LE(error, bound) << name << this->Rays->GetPlan();
    EXPECT_GT(control, 5.0 * error) << name;
  }

  double Cone = 90.0;
  std::array<double, 3> Axis = { 0.0, 0.0, -1.0 };
};

vtkSmartPointer<vtkActor> MakePane(double opacity, double r, double g, double b)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.5, -2.0, 1.8);
  plane->SetPoint1(1.0, -2.0, 1.8);
  plane->SetPoint2(-1.5, 2.0, 1.8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetColor(r, g, b);
  return actor;
}
}

// Things before, in and behind the smoke, which shadow it and are shadowed by it, in haze and alone.
TEST_F(GodRaysVolumeMedium, IsTheTruth)
{
  this->AddSmoke();
  this->Renderer->AddActor(MakeBox({ -1.2, 0.0, 1.9 }, { 0.4, 3.0, 0.4 }));
  this->Renderer->AddActor(MakeBox({ 0.3, 0.6, 0.0 }, { 0.5, 0.5, 0.5 }));
  this->Renderer->AddActor(MakeBox({ 0.6, 0.0, -3.0 }, { 1.2, 3.0, 0.4 }));
  const MediumTest::Case cases[] = { { "sun in front", { 0.2, 0.3, -1.0, 0.0 }, 0.0 },
    { "sun beside", { 1.0, 0.4, 0.2, 0.0 }, 0.0 }, { "lamp inside", { -0.2, -0.6, 0.3, 1.0 }, 0.0 },
    { "lamp beside", { 2.4, 1.0, 0.5, 1.0 }, 0.0 } };
  for (const bool haze : { true, false })
  {
    if (!haze)
    {
      this->UseAlone();
    }
    this->Model->SetScatteringCoefficient(0.02, 0.02, 0.02);
    for (const Case& each : cases)
    {
      if (haze && (&each - cases) % 3 == 0)
      {
        continue; // the truth takes its time
      }
      this->CheckData(std::string(each.Name) + (haze ? ", haze" : ""), each.Light);
    }
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
  }
}

// VTK counts the length on which an opacity is taken in the data's own coordinates.
TEST_F(GodRaysVolumeMedium, IsTheSameHoweverItIsScaled)
{
  auto smoke = this->AddSmoke();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  const auto expected = this->GetScattering();
  vtkNew<vtkImageData> smaller;
  smaller->ShallowCopy(this->Data);
  double origin[3];
  double spacing[3];
  this->Data->GetOrigin(origin);
  this->Data->GetSpacing(spacing);
  smaller->SetOrigin(0.5 * origin[0], 0.5 * origin[1], 0.5 * origin[2]);
  smaller->SetSpacing(0.5 * spacing[0], 0.5 * spacing[1], 0.5 * spacing[2]);
  vtkVolumeMapper::SafeDownCast(smoke->GetMapper())->SetInputData(smaller);
  smoke->SetScale(2.0);
  const auto getDifference = [&]()
  {
    const auto image = this->GetScattering();
    double largest = 0.0;
    double peak = 0.0;
    for (int i = 0; i < 96 * 72; ++i)
    {
      const double value = GetValue(expected, i % 96, i / 96);
      peak = std::max(peak, value);
      largest = std::max(largest, std::abs(GetValue(image, i % 96, i / 96) - value));
    }
    return largest / peak;
  };
  EXPECT_GT(getDifference(), 0.01) << "the same length in smaller coordinates";
  smoke->GetProperty()->SetScalarOpacityUnitDistance(0.35);
  EXPECT_LT(getDifference(), 1e-5);
}

TEST_F(GodRaysVolumeMedium, IsTheTruthOfSpotlights)
{
  this->AddSmoke();
  this->Renderer->AddActor(MakeBox({ -0.5, 0.9, 0.0 }, { 0.3, 0.3, 3.0 }));
  auto lamp = MakeLamplight({ -2.2, 2.0, 0.5 });
  lamp->SetFocalPoint(0.2, -0.2, 0.0);
  lamp->SetConeAngle(25.0);
  lamp->SetExponent(2.0);
  this->Cone = 25.0;
  this->Axis = { 2.4, -2.2, -0.5 };
  this->Rays->AddLight(lamp);
  this->CheckData("spotlight, haze", { -2.2, 2.0, 0.5, 1.0 });
  this->UseAlone();
  this->CheckData("spotlight", { -2.2, 2.0, 0.5, 1.0 });
}

TEST_F(GodRaysVolumeMedium, IsTheTruthInParallelAndBehindPanes)
{
  this->AddSmoke();
  this->AddSmoke({ 0.7, 0.4, -0.8 }); // in the other one
  this->Renderer->AddActor(MakeBox({ 0.3, 0.6, 0.0 }, { 0.5, 0.5, 0.5 }));
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(2.5);
  this->CheckData("parallel, two volumes", { 1.0, 0.4, 0.2, 0.0 });
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
  this->Renderer->AddActor(MakePane(0.5, 1.0, 1.0, 1.0));
  this->CheckData("white pane", { -0.3, 0.2, 1.0, 0.0 });
}

// Grey through coloured panes: the sum over which of them block.
TEST_F(GodRaysVolumeMedium, IsTheTruthBehindColours)
{
  this->AddSmoke();
  this->Renderer->AddActor(MakePane(0.6, 1.0, 0.4, 0.1));
  this->UseAlone();
  this->CheckData("coloured pane", { -0.3, 0.2, 1.0, 0.0 });
}

TEST_F(GodRaysVolumeMedium, HasNumbersOfItsOwn)
{
  this->AddSmoke();
  this->UseAlone();
  this->Alone->SetDataScale(0.4);
  this->Alone->SetDataAlbedo(0.9, 0.7, 0.3);
  this->Alone->SetDataAsymmetry(-0.3);
  this->CheckData("scale, albedo, asymmetry", { 0.2, 0.3, -1.0, 0.0 });
  // colours of sRGB's transfer are an albedo, alike or from point to point
  const auto getMeans = [this]
  {
    auto image = this->GetScattering();
    std::array<double, 3> mean = {};
    for (int i = 0; i < 96 * 72; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        mean[c] += GetValue(image, i % 96, i / 96, c);
      }
    }
    return mean;
  };
  this->Alone->SetDataAlbedo(1.0, 1.0, 1.0);
  const auto white = getMeans();
  auto* colors = this->Smoke->GetProperty()->GetRGBTransferFunction();
  colors->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  auto tinted = getMeans();
  EXPECT_NEAR(tinted[0], white[0], 1e-3 * white[0]);
  EXPECT_NEAR(tinted[1], 0.2140 * white[0], 1e-3 * white[0]);
  EXPECT_EQ(tinted[2], 0.0);
  colors->AddRGBPoint(4.0, 1.0, 0.5, 1.0); // blue where it is dense
  tinted = getMeans();
  EXPECT_NEAR(tinted[0], white[0], 1e-3 * white[0]);
  EXPECT_NEAR(tinted[1], 0.2140 * white[0], 1e-3 * white[0]);
  EXPECT_GT(tinted[2], 0.01 * white[0]);
  EXPECT_LT(tinted[2], 0.6 * white[0]);
}

// What is behind is dimmed, with and without a light, and to the truth.
TEST_F(GodRaysVolumeMedium, DimsWhatIsBehind)
{
  this->UseAlone();
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  this->AddSmoke();
  AddPlainly(this->Rays);
  const auto pixels = GetPixels(this->Scene.Window);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
  vtkGodRaysSingleScattering truth;
  this->SetTruth(truth, { 0.0, 1.0, 0.0, 0.0 }, true);
  const double pixel = 2.0 * std::tan(vtkMath::RadiansFromDegrees(20.0)) / 72;
  double least = 1.0;
  double squares = 0.0;
  for (int i = 0; i < 96 * 72; i += 7)
  {
    vtkGodRaysSingleScattering::Result ray;
    truth.Evaluate((i % 96 + 0.5 - 48.0) * pixel, (i / 96 + 0.5 - 36.0) * pixel, ray);
    const double t = ray.Transmittance[0];
    const double shown = t <= 0.0031308 ? 12.92 * t : 1.055 * std::pow(t, 1.0 / 2.4) - 0.055;
    least = std::min(least, t);
    squares += std::pow(pixels[4 * i] / 255.0 - shown, 2);
  }
  std::cout << "transmittance down to " << least << ", RMSE of shown values "
            << std::sqrt(7 * squares / (96 * 72)) << "\n";
  EXPECT_LT(least, 0.4);
  EXPECT_LT(std::sqrt(7 * squares / (96 * 72)), 1.0 / 255.0);
  this->Alone->AttenuateSceneOff();
  const auto undimmed = GetPixels(this->Scene.Window);
  this->VTKMessages.Expect("no light reaches the picture (there is none)");
  for (int i = 0; i < 96 * 72; ++i)
  {
    ASSERT_EQ(undimmed[4 * i], 255);
  }
}

TEST_F(GodRaysVolumeMedium, IsKeptUntilSomethingChanges)
{
  this->AddSmoke();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  const auto isKept = [this]
  {
    this->Scene.Window->Render();
    return Says(this->Rays->GetPlan(), "is kept");
  };
  EXPECT_FALSE(isKept());
  EXPECT_TRUE(isKept());
  this->Renderer->GetActiveCamera()->Azimuth(23.0);
  EXPECT_TRUE(isKept());
  this->Model->SetDataAsymmetry(0.2);
  EXPECT_TRUE(isKept());
  const auto before = this->GetScattering();
  const auto change = [&](const char* name, const std::function<void()>& something)
  {
    auto old = this->GetScattering();
    something();
    EXPECT_FALSE(isKept()) << name;
    auto now = this->GetScattering();
    double largest = 0.0;
    for (int i = 0; i < 96 * 72; ++i)
    {
      largest =
        std::max(largest, std::abs(GetValue(now, i % 96, i / 96) - GetValue(old, i % 96, i / 96)));
    }
    EXPECT_GT(largest, 1e-3) << name;
  };
  change("light", [&] { this->SetLight({ 1.0, 0.5, 0.2, 0.0 }); });
  change("place", [&] { this->Smoke->SetPosition(0.3, 0.0, 6.0); });
  change("opacity", [&] { this->Smoke->GetProperty()->GetScalarOpacity()->AddPoint(1.0, 0.9); });
  change("unit", [&] { this->Smoke->GetProperty()->SetScalarOpacityUnitDistance(1.7); });
  change("scale", [&] { this->Model->SetDataScale(0.5); });
  change("data",
    [&]
    {
      vtkDataArray* values = this->Data->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        values->SetTuple1(i, 0.3 * values->GetTuple1(i));
      }
      values->Modified();
    });
  change("visibility", [&] { this->AddSmoke({ 0.5, 0.5, 0.5 }); });
}

TEST_F(GodRaysVolumeMedium, IsKeptForEachLight)
{
  this->AddSmoke();
  this->Rays->RemoveAllLights();
  for (int i = 0; i < 6; ++i)
  {
    this->Rays->AddLight(MakeSun({ 1.0, 0.4 - 0.1 * i, 0.2 }));
  }
  this->Scene.Window->Render();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "is kept")) << this->Rays->GetPlan();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "is kept")) << this->Rays->GetPlan();
}

// Cropping and planes cut it to a cell: as if the points beyond had nothing.
TEST_F(GodRaysVolumeMedium, IsCut)
{
  this->AddSmoke();
  this->UseAlone();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  const auto whole = this->GetScattering();
  auto* mapper = vtkVolumeMapper::SafeDownCast(this->Smoke->GetMapper());
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(0.0, 9.0, -9.0, 9.0, -9.0, 9.0); // the right half
  const auto cropped = this->GetScattering();
  mapper->CroppingOff();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  mapper->AddClippingPlane(plane);
  const auto clipped = this->GetScattering();
  mapper->RemoveAllClippingPlanes();
  vtkDataArray* values = this->Data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    double place[3];
    this->Data->GetPoint(i, place);
    values->SetTuple1(i, place[0] < 0.0 ? 0.0 : values->GetTuple1(i));
  }
  values->Modified();
  const auto halved = this->GetScattering();
  EXPECT_GT(GetMean(whole), 1.3 * GetMean(halved));
  for (int i = 0; i < 96 * 72; ++i)
  {
    const double expected = GetValue(halved, i % 96, i / 96);
    ASSERT_NEAR(GetValue(cropped, i % 96, i / 96), expected, 1e-5);
    ASSERT_NEAR(GetValue(clipped, i % 96, i / 96), expected, 1e-5);
  }
}

// One clear message, and the scene without rays, the volume by its mapper.
TEST_F(GodRaysVolumeMedium, TellsWhatCannotBeAMedium)
{
  this->AddSmoke();
  this->UseAlone();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  auto* mapper = vtkVolumeMapper::SafeDownCast(this->Smoke->GetMapper());
  const auto check = [&](const std::string& words, const std::function<void()>& harm,
                       const std::function<void()>& mend)
  {
    harm();
    const auto pixels = GetPixels(this->Scene.Window);
    GetPixels(this->Scene.Window);
    const auto messages = this->VTKMessages.Take();
    int told = 0;
    for (const std::string& message : messages)
    {
      told += Says(message, "The scene is drawn without god rays: a prop tagged MEDIUM") &&
        Says(message, words);
    }
    EXPECT_EQ(told, 1) << words << "; " << (messages.empty() ? "nothing" : messages[0]);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "rays: none")) << words;
    mend();
    this->Scene.Window->Render();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << words;
  };
  const auto put = [&](vtkImageData* image) { mapper->SetInputData(image); };
  const auto repair = [&] { put(this->Data); };
  vtkDataArray* values = this->Data->GetPointData()->GetScalars();
  const double value = values->GetTuple1(50000);
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    this->Rays->SetModel(nullptr); // what was told is told again
    this->Rays->SetModel(this->Alone);
    values->SetTuple1(50000, bad);
    values->Modified();
    this->Scene.Window->Render();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "values that are not finite")) << this->Rays->GetPlan();
  }
  EXPECT_EQ(this->VTKMessages.Take().size(), 1u);
  values->SetTuple1(50000, value);
  values->Modified();

  vtkNew<vtkImageAppendComponents> two;
  two->AddInputData(this->Data);
  two->AddInputData(this->Data);
  two->Update();
  this->Smoke->GetProperty()->IndependentComponentsOff(); // as its mapper can draw them
  check(
    "scalars of 2 components", [&] { put(two->GetOutput()); }, repair);
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(9, 9, 1);
  flat->AllocateScalars(VTK_FLOAT, 1);
  std::fill_n(static_cast<float*>(flat->GetScalarPointer()), 81, 1.0f);
  check(
    "at least 2 points along each axis", [&] { put(flat); }, repair);
  check(
    "composite", [&] { mapper->SetBlendModeToMaximumIntensity(); },
    [&] { mapper->SetBlendModeToComposite(); });
  check(
    "has no volume in the world", [&] { this->Smoke->SetScale(1.0, 0.0, 1.0); },
    [&] { this->Smoke->SetScale(1.0); });
  auto box = MakeBox({ 0.0, 0.0, 0.0 }, { 0.3, 0.3, 0.3 });
  this->Renderer->AddActor(box);
  check(
    "Tag each vtkVolume", [&] { vtkGodRaysPass::SetRole(box, vtkGodRaysPass::MEDIUM); },
    [&] { vtkGodRaysPass::SetRole(box, vtkGodRaysPass::AUTOMATIC); });
}

// Data are read once, also where one of several volumes has a fault.
TEST_F(GodRaysVolumeMedium, IsReadOnceDespiteAFault)
{
  vtkNew<CountingArray> values;
  values->DeepCopy(this->Data->GetPointData()->GetScalars());
  values->SetName("smoke");
  this->Data->GetPointData()->SetScalars(values);
  this->AddSmoke();
  this->UseAlone();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  vtkVolume* good = this->Smoke;
  this->Data = MakePlume(9);
  vtkVolume* faulty = this->AddSmoke({ 0.7, 0.4, -0.8 });
  auto* mapper = vtkVolumeMapper::SafeDownCast(faulty->GetMapper());
  mapper->SetBlendModeToMaximumIntensity();
  this->Scene.Window->Render();
  this->Scene.Window->Render();
  EXPECT_EQ(this->VTKMessages.Take().size(), 1u);
  const int before = values->Readings;
  EXPECT_GT(before, 0);
  for (int frame = 0; frame < 5; ++frame)
  {
    this->Scene.Window->Render();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "composite")) << this->Rays->GetPlan();
  }
  EXPECT_EQ(values->Readings, before);
  values->Modified(); // another fault may be in it
  this->Scene.Window->Render();
  EXPECT_GT(values->Readings, before);
  mapper->SetBlendModeToComposite();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 2 volumes")) << this->Rays->GetPlan();
  faulty->SetMapper(nullptr);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "rays: none")) << this->Rays->GetPlan();
  faulty->SetMapper(good->GetMapper());
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 2 volumes")) << this->Rays->GetPlan();
  this->VTKMessages.Take();
}

// Where each process has a part of the data, one message says so, and the mapper draws the volume; the haze
// about it has its rays.
TEST_F(GodRaysVolumeMedium, IsDrawnByItsMapperOnSeveralProcesses)
{
  this->AddSmoke();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  vtkNew<LonelyCompositor> compositor;
  this->Rays->SetCompositor(compositor);
  std::vector<unsigned char> drawn;
  for (int frame = 0; frame < 3; ++frame)
  {
    drawn = GetPixels(this->Scene.Window);
    EXPECT_FALSE(Says(this->Rays->GetPlan(), "rays: none")) << this->Rays->GetPlan();
  }
  const auto messages = this->VTKMessages.Take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_TRUE(Says(messages.front(), "drawn by their mappers")) << messages.front();
  vtkNew<vtkImageData> light;
  EXPECT_TRUE(this->Rays->GetScatteringImage(light));
  EXPECT_GT(GetMean(light), 1e-4);
  this->Smoke->VisibilityOff();
  EXPECT_GT(CountDifferentPixels(GetPixels(this->Scene.Window), drawn), 100);
  this->Smoke->VisibilityOn();
  compositor->Distributed = false; // one has all data: it is drawn
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volume")) << this->Rays->GetPlan();
  this->Rays->SetCompositor(nullptr);
}

// Where nothing else scatters, and no volume does, there are no rays; in a look it is as any volume.
TEST_F(GodRaysVolumeMedium, IsWhatItsModelMakesOfIt)
{
  this->UseAlone();
  this->SetLight({ 0.2, 0.3, -1.0, 0.0 });
  this->Renderer->AddActor(MakeBox({ 0.3, 0.6, 0.0 }, { 0.5, 0.5, 0.5 }));
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "scatter nothing")) << this->Rays->GetPlan();
  this->AddSmoke();
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
  // a homogeneous medium of no density is as none
  const auto alone = this->GetScattering();
  this->Model->SetScatteringCoefficient(0.0, 0.0, 0.0);
  this->Rays->SetModel(this->Model);
  const auto zero = this->GetScattering();
  for (int i = 0; i < 96 * 72; ++i)
  {
    ASSERT_EQ(GetValue(zero, i % 96, i / 96), GetValue(alone, i % 96, i / 96));
  }
  this->Rays->SetModel(nullptr);
  const auto medium = GetPixels(this->Scene.Window);
  vtkGodRaysPass::SetRole(this->Smoke, vtkGodRaysPass::AUTOMATIC);
  EXPECT_EQ(GetLargestDifference(medium, GetPixels(this->Scene.Window)), 0);
}

// A sun below a plane's horizon lights neither air nor data.
TEST_F(GodRaysVolumeMedium, IsDarkBelowTheHorizon)
{
  this->AddSmoke();
  vtkNew<vtkGodRaysAtmosphereModel> air;
  air->SetUp(0.0, 1.0, 0.0);
  air->SetWorldUnitInMeters(1000.0);
  this->Rays->SetModel(air);
  this->SetLight({ 0.3, 0.2, -1.0, 0.0 });
  EXPECT_GT(GetMean(this->GetScattering()), 1e-3);
  this->SetLight({ 0.3, -0.2, -1.0, 0.0 });
  EXPECT_LT(std::abs(GetMean(this->GetScattering())), 1e-9);
}

// Data have the shadows of any integrator; margins and verification know data.
TEST_F(GodRaysVolumeMedium, WorksWithEachIntegrator)
{
  this->AddSmoke();
  this->Model->SetScatteringCoefficient(0.02, 0.02, 0.02);
  vtkNew<vtkGodRaysShadowMapIntegrator> shaders;
  shaders->SetBackend(vtkGodRaysIntegrator::GRAPHICS);
  this->Rays->SetIntegrator(shaders);
  this->CheckData("in shaders", { 1.0, 0.4, 0.2, 0.0 });
  this->Rays->SetIntegrator(nullptr);
  this->Rays->SetLayerMargin(0.2);
  this->CheckData("margin", { 1.0, 0.4, 0.2, 0.0 });
  this->Rays->SetLayerMargin(0.0);
  const double error = this->GetDataErrors({ 1.0, 0.4, 0.2, 0.0 })[0];
  this->Rays->GetIntegrator()->SetVerifyPixels(1000000);
  this->Scene.Window->Render();
  const double measured = this->Rays->GetIntegrator()->GetErrorEstimate();
  std::cout << "error " << error << ", measured " << measured << "\n";
  EXPECT_NEAR(measured / error, 1.0, 0.3); // of all pixels; without data 20
}

// The numbers of a frame hold what data leave of what is behind them.
TEST_F(GodRaysVolumeMedium, IsInTheNumbers)
{
  this->AddSmoke();
  this->Model->SetScatteringCoefficient(0.02, 0.02, 0.02);
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  this->Scene.Window->Render();
  vtkNew<vtkImageData> numbers;
  ASSERT_TRUE(this->Rays->GetMediumImage(numbers));
  vtkGodRaysSingleScattering truth;
  this->SetTruth(truth, { 1.0, 0.4, 0.2, 0.0 }, true);
  const double pixel = 2.0 * std::tan(vtkMath::RadiansFromDegrees(20.0)) / 72;
  const double bound = numbers->GetFieldData()->GetArray("Transmittance_Error")->GetTuple1(0);
  EXPECT_LT(bound, 0.02);
  vtkDataArray* left = numbers->GetPointData()->GetArray("Transmittance");
  vtkDataArray* depth = numbers->GetPointData()->GetArray("OpticalDepth");
  double deepest = 0.0;
  for (int i = 5; i < 96 * 72; i += 11)
  {
    vtkGodRaysSingleScattering::Result ray;
    truth.Evaluate((i % 96 + 0.5 - 48.0) * pixel, (i / 96 + 0.5 - 36.0) * pixel, ray);
    ASSERT_NEAR(left->GetComponent(i, 1), ray.Transmittance[1], bound) << i;
    ASSERT_NEAR(std::exp(-depth->GetComponent(i, 1)), left->GetComponent(i, 1), 1e-6);
    deepest = std::max(deepest, depth->GetComponent(i, 1));
  }
  EXPECT_GT(deepest, 1.2); // 0.6 without data
}

// In two passes one volume is one: the outer one has it.
TEST_F(GodRaysVolumeMedium, IsTakenOnce)
{
  this->AddSmoke();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  vtkNew<vtkGodRaysPass> outer;
  vtkNew<vtkGodRaysVolumeModel> model;
  outer->SetModel(model);
  outer->AddLight(this->Rays->GetLight(0));
  outer->SetDelegatePass(this->Rays);
  this->Renderer->SetPass(outer);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(outer->GetPlan(), "data of 1 volumes")) << outer->GetPlan();
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "data of")) << this->Rays->GetPlan();
  this->Renderer->SetPass(this->Rays);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
}

// Numbers that are all alike have no range, whatever their size.
TEST_F(GodRaysVolumeMedium, MayBeOneLargeNumber)
{
  this->Data->GetPointData()->GetScalars()->Fill(1e20);
  this->AddSmoke();
  this->UseAlone();
  this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
  EXPECT_GT(GetMean(this->GetScattering()), 1e-3);
}

TEST_F(GodRaysVolumeMedium, IsLikeItsBaseline)
{
  this->Data = MakePlume(49);
  this->Scene.Window->SetSize(Width, Height);
  this->Renderer->SetBackground(0.1, 0.15, 0.25);
  this->AddSmoke();
  this->Renderer->AddActor(MakeBox({ 0.0, -1.6, -0.5 }, { 7.0, 0.1, 7.0 }, { 0.7, 0.65, 0.55 }));
  this->Renderer->AddActor(MakeBox({ -1.2, 0.4, 0.4 }, { 0.25, 4.0, 0.25 }, { 0.6, 0.2, 0.15 }));
  this->Renderer->AddActor(MakeBox({ 1.5, 1.1, 0.2 }, { 1.2, 0.1, 1.2 }, { 0.2, 0.4, 0.6 }));
  this->Model->SetScatteringCoefficient(0.005, 0.005, 0.005);
  this->Model->SetDataScale(3.0);
  this->SetLight({ 0.8, 0.9, -0.3, 0.0 });
  this->Scene.Window->Render();
  ASSERT_TRUE(IsLikeBaseline(this->Scene.Window, "VolumeMedium"));
  this->CheckData("picture", { 0.8, 0.9, -0.3, 0.0 });
  vtkGodRaysPass::SetRole(this->Smoke, vtkGodRaysPass::AUTOMATIC); // the control
  this->Scene.Window->Render();
  EXPECT_FALSE(IsLikeBaseline(this->Scene.Window, "VolumeMedium", 2, true));
}
