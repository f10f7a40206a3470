// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Smoke: mass, closed forms of its mean and variance, symmetry, stability, the floor, time, bytes.

#include "GodRaysSourceTesting.h"
#include "vtkGodRaysSmokeSource.h"

#include <array>

using namespace GodRaysFiltersTesting;
using namespace GodRaysSourceTesting;
using Smoke = vtkGodRaysSmokeSource;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
vtkSmartPointer<Smoke> MakeSmoke(int x, int y, int z)
{
  vtkSmartPointer<Smoke> smoke = vtkSmartPointer<Smoke>::New();
  smoke->SetDimensions(x, y, z);
  return smoke;
}

// Mass in units of density times cell, and its first two moments along each axis.
struct Moments
{
  double Mass = 0.0;
  double Mean[3] = { 0.0, 0.0, 0.0 };
  double Variance[3] = { 0.0, 0.0, 0.0 };
  double Minimum = 0.0;
  vtkIdType Filled = 0;
};

Moments GetMoments(vtkDataSet* data)
{
  Moments moments;
  vtkDataArray* density = data->GetPointData()->GetScalars();
  double squares[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double value = density->GetComponent(i, 0);
    moments.Mass += value;
    moments.Minimum = std::min(moments.Minimum, value);
    moments.Filled += value > 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = data->GetPoint(i)[axis];
      moments.Mean[axis] += value * x;
      squares[axis] += value * x * x;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    moments.Mean[axis] /= moments.Mass;
    moments.Variance[axis] = squares[axis] / moments.Mass - moments.Mean[axis] * moments.Mean[axis];
  }
  return moments;
}

// A puff: all of the source within the first step.
void SetPuff(Smoke* smoke, double radius)
{
  smoke->SetSourceRadius(radius);
  smoke->SetSourceRate(1.0 / smoke->GetTimeStep());
  smoke->SetSourceDuration(smoke->GetTimeStep());
}
}

// --- Conservation -----------------------------------------------------------------------------

//------------------------------------------------------------------------------
// Smoke that fills a closed box, with everything that moves it, in space and in planes.
TEST(SmokeSource, KeepsMassInAClosedBox)
{
  const std::array<int, 3> sizes[] = { { 24, 20, 32 }, { 48, 1, 64 }, { 1, 48, 64 }, { 3, 2, 64 } };
  for (const auto& size : sizes)
  {
    SCOPED_TRACE(size[0]);
    const auto smoke = MakeSmoke(size[0], size[1], size[2]);
    smoke->SetDissipation(0.0);
    smoke->ClosedBoundariesOn();
    const double first = GetMoments(Update(smoke, 0.02)).Mass;
    ASSERT_GT(first, 0.0);
    const Moments later = GetMoments(Update(smoke, 20.0)); // kept within EndTime, 10
    EXPECT_EQ(GetOutput(smoke)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 10.0);
    EXPECT_NEAR(later.Mass / (500.0 * first), 1.0, 1e-6);
    EXPECT_GE(later.Minimum, 0.0);
    EXPECT_GT(later.Filled, size[0] * size[1] * size[2] / 2);
  }
}

//------------------------------------------------------------------------------
TEST(SmokeSource, VanishesAtItsRate)
{
  const auto smoke = MakeSmoke(24, 24, 24);
  smoke->ClosedBoundariesOn();
  smoke->SetDissipation(0.7);
  SetPuff(smoke, 0.2);
  const double first = GetMoments(Update(smoke, 0.02)).Mass;
  EXPECT_NEAR(GetMoments(Update(smoke, 2.02)).Mass / first, std::exp(-1.4), 1e-5);
}

//------------------------------------------------------------------------------
TEST(SmokeSource, LeavesAnOpenBox)
{
  const auto smoke = MakeSmoke(24, 24, 24);
  smoke->SetDissipation(0.0);
  SetPuff(smoke, 0.2);
  const double first = GetMoments(Update(smoke, 0.02)).Mass;
  double before = first;
  for (double time : { 0.5, 1.0, 2.0 })
  {
    const Moments moments = GetMoments(Update(smoke, time));
    EXPECT_LE(moments.Mass, before * (1.0 + 1e-6));
    before = moments.Mass;
  }
  EXPECT_LT(before, 0.1 * first);
}

// --- Closed forms -----------------------------------------------------------------------------

//------------------------------------------------------------------------------
// A puff drifts at its speed and spreads by 2 D t along each axis. In steps, the variance grows by
// v^2 dt less along an axis of drift.
TEST(SmokeSource, DriftsAndSpreadsAsItShould)
{
  const auto smoke = MakeSmoke(80, 80, 120);
  smoke->SetTurbulence(0.0);
  smoke->SetDissipation(0.0);
  smoke->SetSwaySpeed(0.0);
  smoke->SetDiffusivity(0.02);
  smoke->SetRiseSpeed(0.7); // below 2 D/h: no other diffusion
  smoke->SetSourceCenter(0.0, 0.0, 1.5);
  SetPuff(smoke, 0.2);
  const Moments begin = GetMoments(Update(smoke, 0.02));
  const Moments end = GetMoments(Update(smoke, 2.02));
  EXPECT_NEAR(end.Mean[2] - begin.Mean[2], 1.4, 1e-4);
  EXPECT_NEAR(end.Mean[0] - begin.Mean[0], 0.0, 1e-5);
  EXPECT_NEAR(end.Variance[0] - begin.Variance[0], 0.08, 1e-4);
  EXPECT_NEAR(end.Variance[1] - begin.Variance[1], 0.08, 1e-4);
  EXPECT_NEAR(end.Variance[2] - begin.Variance[2], 0.08 - 0.7 * 0.7 * 0.02 * 2.0, 1e-4);
}

//------------------------------------------------------------------------------
// Upwind beyond: as if D were v h/2, and positive still.
TEST(SmokeSource, DiffusesByTheSchemeWhereItIsFast)
{
  const auto smoke = MakeSmoke(1, 1, 200);
  smoke->SetTurbulence(0.0);
  smoke->SetDissipation(0.0);
  smoke->SetDiffusivity(0.0);
  smoke->SetSourceCenter(0.0, 0.0, 2.0);
  SetPuff(smoke, 0.2);
  const Moments begin = GetMoments(Update(smoke, 0.02));
  const Moments end = GetMoments(Update(smoke, 4.02));
  EXPECT_NEAR(end.Mean[2] - begin.Mean[2], 4.0, 1e-4);
  EXPECT_NEAR(end.Variance[2] - begin.Variance[2], (0.05 - 0.02) * 4.0, 1e-4);
  EXPECT_EQ(end.Minimum, 0.0);
}

//------------------------------------------------------------------------------
// The mean sways by the integral of the sine: to one side and back within a period.
TEST(SmokeSource, SwaysToAndFro)
{
  const auto smoke = MakeSmoke(120, 1, 200);
  smoke->SetTurbulence(0.0);
  SetPuff(smoke, 0.2);
  const Moments half = GetMoments(Update(smoke, 2.0));
  const Moments whole = GetMoments(Update(smoke, 4.0));
  EXPECT_NEAR(half.Mean[0], 0.25 * 4.0 / vtkMath::Pi(), 1e-3);
  EXPECT_NEAR(whole.Mean[0], 0.0, 1e-3);
}

//------------------------------------------------------------------------------
TEST(SmokeSource, EddiesFollowTheSeed)
{
  const auto smoke = MakeSmoke(32, 32, 32);
  const std::string first = GetBytes(Update(smoke, 1.0));
  smoke->SetSeed(2);
  const std::string second = GetBytes(Update(smoke, 1.0));
  smoke->SetSeed(1);
  EXPECT_TRUE(first != second);
  EXPECT_TRUE(first == GetBytes(Update(smoke, 1.0)));
  smoke->SetTurbulence(0.0);
  const std::string still = GetBytes(Update(smoke, 1.0));
  smoke->SetSeed(2);
  EXPECT_TRUE(still == GetBytes(Update(smoke, 1.0)));
}

// --- Limits -----------------------------------------------------------------------------------

//------------------------------------------------------------------------------
// At the longest step, with the roughest parameters, nothing is negative, grows or is lost.
TEST(SmokeSource, IsStableToTheLongestStep)
{
  for (double diffusivity : { 0.0, 0.01, 1.0 })
  {
    SCOPED_TRACE(diffusivity);
    const auto smoke = MakeSmoke(20, 20, 20);
    smoke->SetDiffusivity(diffusivity);
    smoke->SetTurbulence(5.0);
    smoke->SetSwaySpeed(3.0);
    smoke->SetDissipation(0.0);
    smoke->ClosedBoundariesOn();
    smoke->SetTimeStep(smoke->GetLargestTimeStep());
    SetPuff(smoke, 0.2);
    ErrorListener errors(smoke);
    const double step = smoke->GetTimeStep();
    const double first = GetMoments(Update(smoke, step)).Mass;
    const Moments last = GetMoments(Update(smoke, 1000.0 * step));
    EXPECT_GE(last.Minimum, 0.0);
    EXPECT_NEAR(last.Mass / first, 1.0, 1e-6);
    EXPECT_LE(GetOutput(smoke)->GetScalarRange()[1], first);

    smoke->SetTimeStep(1.001 * step);
    EXPECT_EQ(Update(smoke, 1.0)->GetNumberOfPoints(), 0);
    ASSERT_EQ(errors.Texts.size(), 1u);
    EXPECT_NE(errors.Texts[0].find("TimeStep"), std::string::npos);
    EXPECT_NE(errors.Texts[0].find("Take"), std::string::npos);
  }
}

//------------------------------------------------------------------------------
// Cells are empty again when the smoke is gone, and those that it has not reached always were.
TEST(SmokeSource, CellsReachZero)
{
  const auto smoke = MakeSmoke(24, 24, 24);
  smoke->SetDissipation(5.0);
  SetPuff(smoke, 0.2);
  const Moments early = GetMoments(Update(smoke, 0.04));
  EXPECT_GT(early.Filled, 0);
  EXPECT_LT(early.Filled, 24 * 24 * 24 / 4);
  EXPECT_EQ(GetMoments(Update(smoke, 10.0)).Filled, 0);

  // What is left is never below the floor.
  smoke->SetMinimumDensity(1e-3);
  vtkDataSet* data = Update(smoke, 0.2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double value = data->GetPointData()->GetScalars()->GetComponent(i, 0);
    ASSERT_TRUE(value == 0.0 || value >= 0.00099);
  }
}

//------------------------------------------------------------------------------
TEST(SmokeSource, TellsWhyItCannot)
{
  const auto smoke = MakeSmoke(16, 16, 16);
  ErrorListener errors(smoke);
  ErrorListener executiveErrors(smoke->GetExecutive());
  smoke->SetSourceCenter(50.0, 0.0, 0.0);
  EXPECT_EQ(Update(smoke, 1.0)->GetNumberOfPoints(), 0);
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("SourceCenter"), std::string::npos);
  smoke->SetDimensions(5000, 1024, 1024);
  EXPECT_EQ(smoke->GetDimensions()[0], 1024);
  EXPECT_EQ(Update(smoke, 1.0)->GetNumberOfPoints(), 0);
  ASSERT_EQ(errors.Texts.size(), 2u);
  EXPECT_NE(errors.Texts[1].find("Take fewer"), std::string::npos);
  smoke->SetDimensions(0, -1, 1);
  smoke->SetSourceCenter(0.0, 0.0, 0.0);
  EXPECT_EQ(Update(smoke, 1.0)->GetNumberOfPoints(), 1);
  EXPECT_EQ(errors.Texts.size(), 2u);
  EXPECT_TRUE(executiveErrors.Texts.empty());
}

// --- As a source ------------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(SmokeSource, TellsItsTimesAndItsBox)
{
  const auto smoke = MakeSmoke(8, 9, 10);
  smoke->SetEndTime(0.1);
  smoke->UpdateInformation();
  vtkInformation* information = smoke->GetOutputInformation(0);
  ASSERT_EQ(information->Length(Pipeline::TIME_STEPS()), 6);
  for (int i = 0; i < 6; ++i)
  {
    const double time = information->Get(Pipeline::TIME_STEPS())[i];
    Update(smoke, time);
    EXPECT_EQ(GetOutput(smoke)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
  EXPECT_EQ(information->Get(Pipeline::TIME_RANGE())[1], 0.1);
  smoke->SetTimeStep(1e-6);
  smoke->SetEndTime(1e6);
  smoke->UpdateInformation();
  EXPECT_FALSE(information->Has(Pipeline::TIME_STEPS()));

  vtkDataSet* data = Update(smoke, 0.0);
  EXPECT_EQ(GetMoments(data).Filled, 0);
  const double* bounds = data->GetBounds();
  const double expected[6] = { -0.175, 0.175, -0.2, 0.2, 0.0, 0.45 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], expected[i], 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(SmokeSource, BytesDoNotDependOnTheWayThere)
{
  const auto smoke = MakeSmoke(33, 20, 30);
  const auto other = MakeSmoke(33, 20, 30);
  const std::string early = GetBytes(Update(smoke, 0.5));
  const std::string late = GetBytes(Update(smoke, 1.0));
  EXPECT_TRUE(GetBytes(Update(other, 1.0)) == late);
  EXPECT_TRUE(GetBytes(Update(other, 0.5)) == early);
  EXPECT_TRUE(early != late);
  ExpectSameOnThreads(smoke, 1.0);
  ExpectProgressAndAbort(smoke, 1.0);
  EXPECT_TRUE(GetBytes(Update(smoke, 1.0)) == late);
}

//------------------------------------------------------------------------------
// Progress is told once a step, and by each execution a few times more.
TEST(SmokeSource, GoesOnFromTheLastStepWhereItCan)
{
  const auto smoke = MakeSmoke(8, 8, 8);
  int steps = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&steps);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  smoke->AddObserver(vtkCommand::ProgressEvent, command);
  auto count = [&](double time)
  {
    steps = 0;
    Update(smoke, time);
    return steps;
  };
  const int more = count(0.0);
  EXPECT_EQ(count(1.0) - more, 50);
  EXPECT_EQ(count(1.5) - more, 25);
  EXPECT_EQ(count(1.2) - more, 60); // earlier: from the start
  smoke->SetRiseSpeed(0.9);
  EXPECT_EQ(count(1.4) - more, 70); // another smoke
}

//------------------------------------------------------------------------------
TEST(SmokeSource, GivesThePieceThatIsAskedFor)
{
  const auto smoke = MakeSmoke(16, 12, 20);
  vtkSmartPointer<vtkDataArray> whole = Update(smoke, 0.5)->GetPointData()->GetScalars();
  smoke->Modified();
  const std::array<int, 6> piece = { 3, 12, 5, 7, 4, 19 };
  smoke->UpdateExtent(piece.data());
  auto* image = vtkImageData::SafeDownCast(GetOutput(smoke));
  ASSERT_EQ(image->GetNumberOfPoints(), 10 * 3 * 16);
  for (int z = 4; z <= 19; ++z)
  {
    for (int y = 5; y <= 7; ++y)
    {
      for (int x = 3; x <= 12; ++x)
      {
        ASSERT_EQ(image->GetScalarComponentAsDouble(x, y, z, 0),
          whole->GetComponent(x + 16 * (y + 12 * z), 0));
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(SmokeSource, ParametersAreClampedAndNeverNaN)
{
  vtkNew<Smoke> smoke;
  ExpectParameters<Smoke>(smoke,
    { { "Spacing", &Smoke::SetSpacing, &Smoke::GetSpacing, 0.05, 1e-6, 1e6 },
      { "TimeStep", &Smoke::SetTimeStep, &Smoke::GetTimeStep, 0.02, 1e-6, 1e3 },
      { "EndTime", &Smoke::SetEndTime, &Smoke::GetEndTime, 10.0, 0.0, 1e6 },
      { "Diffusivity", &Smoke::SetDiffusivity, &Smoke::GetDiffusivity, 0.01, 0.0, 1e6 },
      { "RiseSpeed", &Smoke::SetRiseSpeed, &Smoke::GetRiseSpeed, 1.0, -1e6, 1e6 },
      { "SwaySpeed", &Smoke::SetSwaySpeed, &Smoke::GetSwaySpeed, 0.25, 0.0, 1e6 },
      { "SwayPeriod", &Smoke::SetSwayPeriod, &Smoke::GetSwayPeriod, 4.0, 1e-3, 1e6 },
      { "Turbulence", &Smoke::SetTurbulence, &Smoke::GetTurbulence, 0.4, 0.0, 1e6 },
      { "TurbulenceSize", &Smoke::SetTurbulenceSize, &Smoke::GetTurbulenceSize, 0.4, 1e-6, 1e6 },
      { "Dissipation", &Smoke::SetDissipation, &Smoke::GetDissipation, 0.1, 0.0, 1e3 },
      { "MinimumDensity", &Smoke::SetMinimumDensity, &Smoke::GetMinimumDensity, 1e-9, 1e-30, 1.0 },
      { "SourceRadius", &Smoke::SetSourceRadius, &Smoke::GetSourceRadius, 0.2, 0.0, 1e9 },
      { "SourceRate", &Smoke::SetSourceRate, &Smoke::GetSourceRate, 3.0, 0.0, 1e6 },
      { "SourceDuration", &Smoke::SetSourceDuration, &Smoke::GetSourceDuration, 1e6, 0.0, 1e6 } });
}
