// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Fire: how many live, where, of what size and colour; any time by itself; pieces; bytes.

#include "GodRaysSourceTesting.h"
#include "vtkGodRaysFireSource.h"

#include <set>

using namespace GodRaysFiltersTesting;
using namespace GodRaysSourceTesting;
using Fire = vtkGodRaysFireSource;

namespace
{
double Get(vtkDataSet* data, const char* name, vtkIdType point, int component = 0)
{
  return data->GetPointData()->GetArray(name)->GetComponent(point, component);
}
}

//------------------------------------------------------------------------------
TEST(FireSource, AsManyLiveAsAreBornInALifetime)
{
  vtkNew<Fire> fire;
  fire->SetSpawnRate(100.0);
  fire->SetLifetime(2.0);
  EXPECT_EQ(Update(fire, 0.0)->GetNumberOfPoints(), 1);
  EXPECT_EQ(Update(fire, 0.505)->GetNumberOfPoints(), 51);
  EXPECT_EQ(Update(fire, 1.995)->GetNumberOfPoints(), 200);
  for (double time : { 2.005, 5.5551, 9.999, 25.0 })
  {
    EXPECT_NEAR(Update(fire, time)->GetNumberOfPoints(), 200, 1) << time;
  }
  fire->SetCapacity(30);
  vtkDataSet* data = Update(fire, 5.005);
  ASSERT_EQ(data->GetNumberOfPoints(), 30);
  EXPECT_NEAR(Get(data, "Age", 0), 0.295, 1e-6); // the oldest are left out
  EXPECT_NEAR(Get(data, "Age", 29), 0.005, 1e-6);
  fire->SetSpawnRate(0.0);
  EXPECT_EQ(Update(fire, 5.0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(GetOutput(fire))->GetNumberOfVerts(), 0);
}

//------------------------------------------------------------------------------
// Without eddies: within the ball that moves and grows, with the moments of even balls.
TEST(FireSource, ParticlesMoveAsTheyShould)
{
  vtkNew<Fire> fire;
  fire->SetTurbulence(0.0);
  fire->SetCenter(1.0, -2.0, 3.0);
  fire->SetVelocity(0.5, 0.0, 2.0);
  fire->SetSpawnRate(15000.0);
  vtkDataSet* data = Update(fire, 7.0);
  const vtkIdType count = data->GetNumberOfPoints();
  ASSERT_NEAR(count, 18000, 1);
  double mean[3] = { 0.0, 0.0, 0.0 };
  double square = 0.0;
  double expectedSquare = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double age = Get(data, "Age", i);
    const double* p = data->GetPoint(i);
    const double away[3] = { p[0] - 1.0 - 0.5 * age, p[1] + 2.0, p[2] - 3.0 - 2.0 * age };
    const double distance = vtkMath::Norm(away);
    ASSERT_LE(distance, 0.25 * (1.0 + age) + 1e-5);
    square += distance * distance / count;
    // The mean of r^2 in a unit ball is 3/5.
    expectedSquare += 0.6 * 0.25 * 0.25 * (1.0 + age * age) / count;
    for (int axis = 0; axis < 3; ++axis)
    {
      mean[axis] += away[axis] / count;
    }
  }
  EXPECT_NEAR(square / expectedSquare, 1.0, 0.03);
  for (double component : mean)
  {
    EXPECT_NEAR(component, 0.0, 0.006); // 5 standard deviations
  }
}

//------------------------------------------------------------------------------
TEST(FireSource, EddiesAreBoundAndMove)
{
  vtkNew<Fire> fire;
  const vtkSmartPointer<vtkDataSet> with = Update(fire, 3.0)->NewInstance();
  with->UnRegister(nullptr);
  with->DeepCopy(GetOutput(fire));
  fire->SetTurbulence(0.0);
  vtkDataSet* without = Update(fire, 3.0);
  ASSERT_EQ(with->GetNumberOfPoints(), without->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < with->GetNumberOfPoints(); ++i)
  {
    double p[3];
    with->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double carried = std::abs(p[axis] - without->GetPoint(i)[axis]);
      ASSERT_LE(carried, 0.4 * Get(without, "Age", i) + 1e-5);
      largest = std::max(largest, carried);
    }
  }
  EXPECT_GT(largest, 0.1);
}

//------------------------------------------------------------------------------
TEST(FireSource, SizesAndColoursFadeWithAge)
{
  vtkNew<Fire> fire;
  fire->SetColorRandomness(0.0);
  vtkDataSet* data = Update(fire, 4.0);
  std::set<double> deviations;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double part = Get(data, "Age", i) / 1.2;
    ASSERT_GE(part, 0.0);
    ASSERT_LE(part, 1.0 + 1e-6);
    const double size = Get(data, "Size", i);
    ASSERT_GE(size, 0.04 * (1.0 - part) - 1e-6);
    ASSERT_LE(size, 0.12 * (1.0 - part) + 1e-6);
    deviations.insert(size / (1.0 - part + 1e-9));
    ASSERT_NEAR(Get(data, "Color", i, 0), 255.0 * (1.0 - 0.25 * part), 0.51);
    ASSERT_NEAR(Get(data, "Color", i, 3), 255.0 * 0.06 * (1.0 - part), 0.51);
  }
  EXPECT_LT(*deviations.begin(), 0.041);
  EXPECT_GT(*deviations.rbegin(), 0.119);

  // Components deviate each by themselves.
  fire->SetColorRandomness(0.2);
  fire->SetStartColor(0.5, 0.5, 0.5);
  fire->SetEndColor(0.5, 0.5, 0.5);
  data = Update(fire, 4.0);
  bool differ = false;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    differ = differ || std::abs(Get(data, "Color", i, 0) - Get(data, "Color", i, 1)) > 40.0;
    ASSERT_NEAR(Get(data, "Color", i, 2), 127.5, 0.2 * 127.5 + 0.51);
  }
  EXPECT_TRUE(differ);
}

//------------------------------------------------------------------------------
// The same particle a moment later is where its velocity leads, whatever else was asked for.
TEST(FireSource, TimeIsContinuousAndHasNoMemory)
{
  vtkNew<Fire> fire;
  fire->SetSpawnRate(1.0); // one particle
  const double before = Update(fire, 3.5)->GetPoint(0)[2];
  const std::string bytes = GetBytes(GetOutput(fire));
  const double after = Update(fire, 3.501)->GetPoint(0)[2];
  EXPECT_NEAR(after, before, 0.005);
  EXPECT_NE(after, before);
  Update(fire, 0.2);
  EXPECT_TRUE(GetBytes(Update(fire, 3.5)) == bytes);
  EXPECT_EQ(GetOutput(fire)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 3.5);
  fire->SetTimeScale(2.0);
  EXPECT_TRUE(GetBytes(Update(fire, 1.75)) == bytes);
  fire->SetSeed(2);
  EXPECT_TRUE(GetBytes(Update(fire, 1.75)) != bytes);
  const double* range =
    fire->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 10.0);
}

//------------------------------------------------------------------------------
// The longest time at the highest rate: still particles, and no NaN.
TEST(FireSource, LastsToTheEndOfItsRanges)
{
  vtkNew<Fire> fire;
  fire->SetEndTime(1e6);
  fire->SetTimeScale(1e3);
  fire->SetSpawnRate(1e9);
  fire->SetCapacity(1000);
  fire->SetTurbulence(1e6);
  fire->SetTurbulenceSize(1e-6);
  vtkDataSet* data = Update(fire, 1e6);
  ASSERT_EQ(data->GetNumberOfPoints(), 1000);
  EXPECT_TRUE(IsFinite(vtkPolyData::SafeDownCast(data)->GetPoints()->GetData()));
  EXPECT_TRUE(IsFinite(data->GetPointData()->GetArray("Size")));
}

//------------------------------------------------------------------------------
TEST(FireSource, PiecesAreTheWhole)
{
  vtkNew<Fire> fire;
  fire->SetSpawnRate(1001.0);
  Update(fire, 2.0);
  const std::string whole = GetBytes(GetOutput(fire)->GetPointData()->GetArray("Age"));
  std::string pieces;
  for (int piece = 0; piece < 3; ++piece)
  {
    fire->UpdatePiece(piece, 3, 0);
    pieces += GetBytes(GetOutput(fire)->GetPointData()->GetArray("Age"));
    EXPECT_NEAR(GetOutput(fire)->GetNumberOfPoints(), 400, 2);
  }
  EXPECT_TRUE(pieces == whole);
}

//------------------------------------------------------------------------------
TEST(FireSource, BytesDoNotDependOnThreads)
{
  vtkNew<Fire> fire;
  ExpectSameOnThreads(fire, 2.5);
  ExpectProgressAndAbort(fire, 2.5);
  EXPECT_EQ(vtkPolyData::SafeDownCast(GetOutput(fire))->GetNumberOfVerts(),
    GetOutput(fire)->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
TEST(FireSource, ParametersAreClampedAndNeverNaN)
{
  vtkNew<Fire> fire;
  ExpectParameters<Fire>(fire,
    { { "SpawnRate", &Fire::SetSpawnRate, &Fire::GetSpawnRate, 1500.0, 0.0, 1e9 },
      { "Lifetime", &Fire::SetLifetime, &Fire::GetLifetime, 1.2, 1e-3, 1e6 },
      { "TimeScale", &Fire::SetTimeScale, &Fire::GetTimeScale, 1.0, 0.0, 1e3 },
      { "EndTime", &Fire::SetEndTime, &Fire::GetEndTime, 10.0, 0.0, 1e6 },
      { "PositionRandomness", &Fire::SetPositionRandomness, &Fire::GetPositionRandomness, 0.25, 0.0,
        1e9 },
      { "VelocityRandomness", &Fire::SetVelocityRandomness, &Fire::GetVelocityRandomness, 0.25, 0.0,
        1e6 },
      { "Turbulence", &Fire::SetTurbulence, &Fire::GetTurbulence, 0.4, 0.0, 1e6 },
      { "TurbulenceSize", &Fire::SetTurbulenceSize, &Fire::GetTurbulenceSize, 0.4, 1e-6, 1e6 },
      { "Size", &Fire::SetSize, &Fire::GetSize, 0.08, 0.0, 1e9 },
      { "SizeRandomness", &Fire::SetSizeRandomness, &Fire::GetSizeRandomness, 0.5, 0.0, 1.0 },
      { "ColorRandomness", &Fire::SetColorRandomness, &Fire::GetColorRandomness, 0.2, 0.0, 1.0 },
      { "Opacity", &Fire::SetOpacity, &Fire::GetOpacity, 0.06, 0.0, 1.0 } });
}
