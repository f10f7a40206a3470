// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Media of data, fast, as a filter: its pictures against those of the reference.

#include "GodRaysFiltersTesting.h"
#include "GodRaysGridScenes.h"
#include "GodRaysMemory.h"
#include "vtkGodRaysGridFilter.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace GodRaysFiltersTesting;
using namespace GodRaysGridScenes;

namespace
{
struct Truth
{
  Picture Alone; // the medium without data
  Picture Whole;
};

// What the reference makes of a plume in a medium, after the same settings as the filter's.
template <typename Set>
Truth FindTruth(vtkGodRaysGridFilter* filter, vtkImageData* plume, int columns, int rows, Set set)
{
  vtkNew<vtkGodRaysSingleScatteringReference> reference;
  filter->SetInputData(0, plume);
  filter->SetSize(columns, rows);
  reference->SetSize(columns, rows);
  set(filter);
  set(reference.Get());
  reference->SetTolerance(1e-5);
  reference->Update();
  Truth truth;
  truth.Alone = FromImage(reference->GetOutput());
  reference->SetInputData(2, plume);
  reference->Update();
  truth.Whole = FromImage(reference->GetOutput());
  return truth;
}
}

//------------------------------------------------------------------------------
// As a filter: with the medium's own light it is the reference's picture; errors are told once.
TEST(GridFilter, IsTheReferenceWithTheMediumsLight)
{
  auto plume = MakePlume(40);
  vtkNew<vtkGodRaysGridFilter> filter;
  const Truth truth = FindTruth(filter, plume, 24, 16,
    [](vtkGodRaysGridMediumFilter* each)
    {
      each->SetCameraPosition(3.0, 0.5, -3.0);
      each->SetCameraFocalPoint(0.0, 0.0, -6.0);
      each->SetViewAngle(40.0);
      each->SetFarLimit(9.0);
      each->SetScatteringCoefficient(0.02, 0.03, 0.05);
      each->SetLight(0.3, 1.0, 0.4, 0.0);
      each->SetDataAlbedo(0.9, 0.8, 0.7);
      each->SetDataScale(0.8);
    });
  const auto compare = [&]()
  {
    filter->Update();
    const Picture actual = FromImage(filter->GetOutput());
    double squares = 0.0;
    for (std::size_t i = 0; i < actual.Values.size(); ++i)
    {
      const double difference = actual.Values[i] + truth.Alone.Values[i] - truth.Whole.Values[i];
      squares += difference * difference;
    }
    return std::sqrt(squares / actual.Values.size()) / truth.Whole.GetMaximum();
  };
  const double error = compare();
  std::cout << "RMSE " << error << "\n";
  EXPECT_LE(error, 1.0 / 255.0);
  filter->SetDataScale(0.4); // the control: the depths of before are not kept
  EXPECT_GT(compare(), 5.0 / 255.0);
  filter->SetDataScale(0.8);
  EXPECT_LE(compare(), 1.0 / 255.0);
  filter->SetDataAlbedo(0.0, 0.0, 0.0);
  EXPECT_GT(compare(), 5.0 / 255.0);
  filter->SetDataAlbedo(0.9, 0.8, 0.7);
  EXPECT_LE(compare(), 1.0 / 255.0);

  // Depths that end all rays before the plume.
  vtkNew<vtkImageData> depths;
  depths->SetDimensions(24, 16, 1);
  depths->AllocateScalars(VTK_DOUBLE, 1);
  depths->GetPointData()->GetScalars()->Fill(1.0);
  filter->SetInputData(1, depths);
  filter->SetScatteringCoefficient(0.0, 0.0, 0.0);
  filter->Update();
  EXPECT_EQ(FromImage(filter->GetOutput()).GetMaximum(), 0.0);
  ErrorListener errors(filter);
  filter->SetSize(25, 16);
  filter->Update();
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("picture of depths"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// A spotlight, air of two components that thin out, a planet's ground, three colours, both projections.
TEST(GridFilter, KnowsAllLightsAndMedia)
{
  auto plume = MakePlume(40);
  for (const bool parallel : { false, true })
  {
    for (const bool spot : { false, true })
    {
      vtkNew<vtkGodRaysGridFilter> filter;
      const Truth truth = FindTruth(filter, plume, 13, 9,
        [=](vtkGodRaysGridMediumFilter* each)
        {
          each->SetCameraPosition(2.0, 0.8, -2.5);
          each->SetCameraFocalPoint(0.0, 0.2, -6.0);
          each->SetViewAngle(45.0);
          each->SetParallelProjection(parallel);
          each->SetParallelScale(1.8);
          each->SetFarLimit(10.0);
          each->SetScatteringCoefficient(0.02, 0.03, 0.05);
          each->SetScaleHeight(2.0);
          each->SetGasScatteringCoefficient(0.01, 0.02, 0.04);
          each->SetGasScaleHeight(5.0);
          each->SetGroundLevel(-1.5);
          each->SetPlanetRadius(5000.0);
          each->SetLight(spot ? 1.5 : 0.6, spot ? 3.0 : 1.0, spot ? -5.0 : 0.4, spot ? 1.0 : 0.0);
          each->SetConeAngle(25.0);
          each->SetSpotDirection(-1.4, -3.0, -0.8);
          each->SetSpotExponent(2.0);
          each->SetDataAlbedo(0.9, 0.8, 0.7);
        });
      filter->Update();
      const Picture actual = FromImage(filter->GetOutput());
      double squares = 0.0;
      double effect = 0.0;
      for (std::size_t i = 0; i < actual.Values.size(); ++i)
      {
        const double change = truth.Whole.Values[i] - truth.Alone.Values[i];
        squares += (actual.Values[i] - change) * (actual.Values[i] - change);
        effect += change * change;
      }
      const double scale = 1.0 / std::sqrt(actual.Values.size()) / truth.Whole.GetMaximum();
      std::cout << (parallel ? "parallel" : "perspective") << (spot ? ", spotlight" : ", sun")
                << ": RMSE " << scale * std::sqrt(squares) << ", effect of data "
                << scale * std::sqrt(effect) << "\n";
      EXPECT_LE(scale * std::sqrt(squares), 1.0 / 255.0);
      EXPECT_GT(scale * std::sqrt(effect), 5.0 / 255.0); // the control
    }
  }
}

//------------------------------------------------------------------------------
// Beside an image of floats, a light takes an eighth of its memory at most, also while depths are summed: in
// pages of the process, with the picture. With GODRAYS_LONG: of 512^3 points.
TEST(GridFilter, TakesAnEighthOfTheMemoryOfItsData)
{
  const int n = std::getenv("GODRAYS_LONG") ? 512 : 256;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->SetOrigin(-1.5, -1.5, -7.5);
  image->SetSpacing(3.0 / (n - 1), 3.0 / (n - 1), 3.0 / (n - 1));
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const std::size_t count = static_cast<std::size_t>(n) * n * n;
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = i / n % n < static_cast<std::size_t>(n) / 2 ? 0.5f : 0.0f;
  }
  vtkNew<vtkGodRaysGridFilter> filter;
  filter->SetSize(64, 48);
  filter->SetCameraFocalPoint(0.0, 0.0, -1.0);
  filter->SetScatteringCoefficient(0.0, 0.0, 0.0);
  filter->SetLight(0.3, 1.0, 0.2, 0.0);
  filter->SetInputData(0, MakePlume(24)); // threads are there from now on
  filter->Update();
  filter->SetInputData(0, image);
  const double before = GodRaysMemory::Start();
  filter->Update();
  const double after = GodRaysMemory::Get("VmRSS");
  if (before < 0.0)
  {
    GTEST_SKIP() << "there is no /proc/self/status";
  }
  EXPECT_GT(FromImage(filter->GetOutput()).GetMaximum(), 0.01);
  const double data = static_cast<double>(count) * sizeof(float);
  std::cout << n << " points along an axis, " << data / 1048576.0
            << " MiB: " << (after - before) / data << " of the data's memory beside them, "
            << (GodRaysMemory::Get("VmHWM") - before) / data << " at most\n";
  EXPECT_LE(after - before, data / 8.0);
  EXPECT_LE(GodRaysMemory::Get("VmHWM") - before, data / 8.0);
  EXPECT_GE(after - before, data / 64.0); // the control: depths are kept
}
