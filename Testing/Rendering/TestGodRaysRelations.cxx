// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Metamorphic relations: what must become of the light when a scene is changed in a certain way. The scenes
// are random: GODRAYS_SEED=<number> takes others, GODRAYS_LONG=1 takes 40 rather than 4; a failure tells the
// seed. Each relation has a control, a light a little off its place, which must break it.

#include "GodRaysMediumTruth.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

using namespace GodRaysTesting;

namespace
{
using Vector = std::array<double, 3>;

int GetSetting(const char* name, int otherwise)
{
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

/// Boxes before a camera, a sun, and what there is between them; all of it in a transformed space.
struct World
{
  struct Box
  {
    Vector Center;
    Vector Size;
    Vector Angles; // [degrees] about the axes
    int Role = vtkGodRaysPass::AUTOMATIC;
  };

  bool HasMedium = false;
  std::vector<Box> Boxes;
  std::vector<Vector> Suns;   // the directions towards them
  std::vector<Vector> Colors; // theirs
  Vector Eye = { 0.0, 0.0, 10.0 };
  double Scattering = 0.05;       // [1/m]
  double SecondWeight = 0.0;      // of a second phase function that is the first again
  vtkNew<vtkTransform> Transform; // of the space
  double Scale = 1.0;             // of its lengths
  int Size[2] = { 192, 144 };
  int Samples = 0;
  int Renders = 1;

  World(int seed, bool hasMedium);
  World(const World& other);
  World& operator=(const World&) = delete;

  vtkSmartPointer<vtkImageData> Draw() const;

private:
  Vector Place(const Vector& point) const;
  Vector Turn(const Vector& direction) const;
};

World::World(int seed, bool hasMedium)
  : HasMedium(hasMedium)
{
  vtkNew<vtkMinimalStandardRandomSequence> chance;
  chance->SetSeed(1000 * seed + 17);
  const auto get = [&chance](double low, double high)
  {
    chance->Next();
    return chance->GetRangeValue(low, high);
  };
  const int count = static_cast<int>(get(4.0, 12.0));
  for (int i = 0; i < count; ++i)
  {
    this->Boxes.push_back({ { get(-4.0, 4.0), get(-3.0, 3.0), get(-3.0, 2.0) },
      { get(0.2, 1.6), get(0.2, 2.4), get(0.2, 1.2) },
      { get(0.0, 90.0), get(0.0, 90.0), get(0.0, 90.0) } });
  }
  // Some are in the picture; of looks, which need them there, all.
  const double ahead = hasMedium ? get(-1.5, 1.0) : -1.0;
  this->Suns.push_back({ get(-0.25, 0.25), get(-0.15, 0.2), std::min(ahead, 0.5) });
  this->Colors.push_back({ 1.0, get(0.6, 1.0), get(0.3, 1.0) });
  this->Eye = { get(-1.0, 1.0), get(-1.0, 1.0), 10.0 };
}

World::World(const World& other)
  : HasMedium(other.HasMedium)
  , Boxes(other.Boxes)
  , Suns(other.Suns)
  , Colors(other.Colors)
  , Eye(other.Eye)
  , Scattering(other.Scattering)
  , SecondWeight(other.SecondWeight)
  , Scale(other.Scale)
  , Samples(other.Samples)
  , Renders(other.Renders)
{
  this->Transform->SetMatrix(other.Transform->GetMatrix());
  std::copy_n(other.Size, 2, this->Size);
}

Vector World::Place(const Vector& point) const
{
  Vector placed;
  this->Transform->TransformPoint(point.data(), placed.data());
  return placed;
}

Vector World::Turn(const Vector& direction) const
{
  Vector turned;
  this->Transform->TransformVector(direction.data(), turned.data());
  return turned;
}

/// The light that is scattered.
vtkSmartPointer<vtkImageData> World::Draw() const
{
  Stage stage(this->Size[0], this->Size[1]);
  stage.Window->SetMultiSamples(this->Samples);
  for (const Box& each : this->Boxes)
  {
    auto box = MakeBox({ 0.0, 0.0, 0.0 }, each.Size);
    vtkNew<vtkTransform> placed;
    placed->SetMatrix(this->Transform->GetMatrix());
    placed->Translate(each.Center.data());
    placed->RotateX(each.Angles[0]);
    placed->RotateY(each.Angles[1]);
    placed->RotateZ(each.Angles[2]);
    box->SetUserTransform(placed);
    vtkGodRaysPass::SetRole(box, each.Role);
    stage.Renderer->AddActor(box);
  }
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(this->Place(this->Eye).data());
  camera->SetFocalPoint(this->Place({ 0.0, 0.0, 0.0 }).data());
  camera->SetViewUp(this->Turn({ 0.0, 1.0, 0.0 }).data());
  camera->SetClippingRange(1.0 * this->Scale, 60.0 * this->Scale);
  for (std::size_t i = 0; i < this->Suns.size(); ++i)
  {
    stage.Rays->AddLight(MakeSun(this->Turn(this->Suns[i]), this->Colors[i]));
  }
  vtkNew<vtkGodRaysHomogeneousModel> medium;
  if (this->HasMedium)
  {
    const double scattering = this->Scattering / this->Scale;
    medium->SetScatteringCoefficient(scattering, 0.8 * scattering, 0.6 * scattering);
    medium->SetSecondPhaseFunction(medium->GetPhaseFunction());
    medium->SetSecondAsymmetry(medium->GetAsymmetry());
    medium->SetSecondWeight(this->SecondWeight);
    medium->SetFarLimit(30.0 * this->Scale);
    stage.Rays->SetModel(medium);
  }
  stage.Rays->Attach(stage.Renderer);
  for (int i = 0; i < this->Renders; ++i)
  {
    stage.Window->Render();
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  EXPECT_TRUE(stage.Rays->GetScatteringImage(image)) << stage.Rays->GetPlan();
  return image;
}

double GetPeak(vtkImageData* image)
{
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  return *std::max_element(values, values + 3 * image->GetNumberOfPoints());
}

class GodRaysRelations : public ::testing::TestWithParam<bool>
{
protected:
  Messages VTKMessages;
  const int First = GetSetting("GODRAYS_SEED", 1);
  const int Count = GetSetting("GODRAYS_LONG", 0) ? 40 : 4;

  /// What a pixel of one picture is in the other: its place, and the factor on its light.
  struct Mapping
  {
    bool Mirrored = false;
    int Pixels =
      1; // of the first picture, in a row and in a column, whose mean is one of the second
    double Factor = 1.0;
    bool HasEdges =
      true; // or they lie elsewhere by a part of a pixel, and a tenth of all is left out
  };

  /// Root mean square of the difference over the peak.
  static double Compare(vtkImageData* a, vtkImageData* b, const Mapping& mapping)
  {
    const int* size = b->GetDimensions();
    const int n = mapping.Pixels;
    std::vector<double> squares;
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        for (int c = 0; c < 3; ++c)
        {
          double mean = 0.0;
          for (int i = 0; i < n * n; ++i)
          {
            mean += GetValue(a, n * x + i % n, n * y + i / n, c) / (n * n);
          }
          const double value = GetValue(b, mapping.Mirrored ? size[0] - 1 - x : x, y, c);
          squares.push_back(std::pow(mapping.Factor * mean - value, 2));
        }
      }
    }
    std::sort(squares.begin(), squares.end());
    squares.resize(squares.size() * (mapping.HasEdges ? 10 : 9) / 10);
    const double mean = std::accumulate(squares.begin(), squares.end(), 0.0) / squares.size();
    return std::sqrt(mean) / (mapping.Factor * GetPeak(a));
  }

  /// That the light of random scenes and of the changed ones differs by no more than this, as a root mean
  /// square over the peak; and does with another light.
  void Check(double bound, const std::function<void(World&)>& change, const Mapping& mapping,
    const std::function<void(World&)>& prepare = {})
  {
    double worst = 0.0;
    double least = 1.0;
    for (int seed = this->First; seed < this->First + this->Count; ++seed)
    {
      SCOPED_TRACE("GODRAYS_SEED=" + std::to_string(seed));
      World before(seed, this->GetParam());
      if (prepare)
      {
        prepare(before);
      }
      World after(before);
      change(after);
      const auto light = before.Draw();
      const double difference = this->Compare(light, after.Draw(), mapping);
      EXPECT_LE(difference, bound);
      worst = std::max(worst, difference);
      for (Vector& sun : after.Suns)
      {
        sun[0] += 0.2 * std::abs(sun[2]) + 0.1;
      }
      const double control = this->Compare(light, after.Draw(), mapping);
      EXPECT_GT(control, 2.0 * bound) << "the control";
      least = std::min(least, control);
    }
    std::cout << "worst " << worst << ", least of the controls " << least << "\n";
  }
};

const double Tolerance = 1.0 / 255.0; // of each of the two pictures, and the default

void AddSecondSun(World& world)
{
  const Vector& sun = world.Suns[0];
  world.Suns.push_back({ -0.6 * sun[0] - 0.1, 0.7 * sun[1] + 0.1, sun[2] });
  world.Colors.push_back({ 0.4, 0.7, 1.0 });
}
}

TEST_P(GodRaysRelations, TurnedAndMovedAsAWhole)
{
  this->Check(Tolerance,
    [](World& world)
    {
      world.Transform->Translate(30.0, -20.0, 7.0);
      world.Transform->RotateWXYZ(73.0, 0.3, -0.8, 0.5);
    },
    {});
}

TEST_P(GodRaysRelations, Mirrored)
{
  Mapping mapping;
  mapping.Mirrored = true;
  this->Check(
    Tolerance, [](World& world) { world.Transform->Scale(-1.0, 1.0, 1.0); }, mapping);
}

// With coefficients per length that are smaller by as much.
TEST_P(GodRaysRelations, LargerAThousandTimes)
{
  this->Check(0.5 * Tolerance,
    [](World& world)
    {
      world.Scale = 1000.0;
      world.Transform->Scale(1000.0, 1000.0, 1000.0);
    },
    {});
}

TEST_P(GodRaysRelations, InTwoHalves)
{
  if (!this->GetParam())
  {
    GTEST_SKIP() << "a look has no medium";
  }
  this->Check(
    1e-4, [](World& world) { world.SecondWeight = 0.5; }, {},
    [](World& world) { world.SecondWeight = 0.0; });
}

TEST_P(GodRaysRelations, LightsInAnotherOrder)
{
  this->Check(
    5e-4,
    [](World& world)
    {
      std::swap(world.Suns[0], world.Suns[1]);
      std::swap(world.Colors[0], world.Colors[1]);
    },
    {}, AddSecondSun);
}

TEST_P(GodRaysRelations, TwoLightsForOne)
{
  Mapping mapping;
  mapping.Factor = 2.0;
  this->Check(
    5e-4,
    [](World& world)
    {
      world.Suns.push_back(world.Suns[0]);
      world.Colors.push_back(world.Colors[0]);
    },
    mapping);
}

TEST_P(GodRaysRelations, AtHalfTheResolution)
{
  Mapping mapping;
  mapping.Pixels = 2;
  mapping.HasEdges = false;
  this->Check(
    this->GetParam() ? Tolerance : 2.0 * Tolerance,
    [](World& world)
    {
      world.Size[0] /= 2;
      world.Size[1] /= 2;
    },
    mapping);
}

TEST_P(GodRaysRelations, Multisampled)
{
  Mapping mapping;
  mapping.HasEdges = false;
  this->Check(
    Tolerance, [](World& world) { world.Samples = 8; }, mapping);
}

// Downstream, and beside what is seen.
TEST_P(GodRaysRelations, AnOccluderThatCannotCastIntoTheView)
{
  this->Check(Tolerance,
    [](World& world)
    {
      Vector towards = world.Suns[0];
      vtkMath::Normalize(towards.data());
      world.Boxes.push_back(
        { { 80.0, -30.0 * towards[1], -30.0 * towards[2] }, { 2.0, 2.0, 2.0 }, { 0.0, 0.0, 0.0 } });
    },
    {});
}

// In the picture of a look; in a medium, where what is seen ends view rays, on the light's way to it.
TEST_P(GodRaysRelations, APropThatIsIgnored)
{
  this->Check(Tolerance,
    [this](World& world)
    {
      World::Box box{ { 0.5, 0.5, 1.0 }, { 1.5, 0.4, 0.4 }, { 20.0, 30.0, 40.0 } };
      if (this->GetParam())
      {
        Vector towards = world.Suns[0];
        vtkMath::Normalize(towards.data());
        box.Center = { 12.0 * towards[0], 12.0 * towards[1] + 9.0, 12.0 * towards[2] };
      }
      box.Role = vtkGodRaysPass::IGNORED;
      world.Boxes.push_back(box);
    },
    {});
}

TEST_P(GodRaysRelations, RenderedTwice)
{
  this->Check(0.0, [](World& world) { world.Renders = 2; }, {});
}

INSTANTIATE_TEST_SUITE_P(Of, GodRaysRelations, ::testing::Bool(),
  [](const ::testing::TestParamInfo<bool>& info) { return info.param ? "media" : "looks"; });
