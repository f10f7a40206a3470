// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The taps of the radial model, INVARIANT, against their limit as vtkGodRaysReferenceFilter has it:
// one formula, two evaluations that share only the march.

#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysReferenceFilter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace
{
// Root mean square of the difference, of the peak.
double GetError(vtkImageData* sum, vtkImageData* limit)
{
  vtkDataArray* a = sum->GetPointData()->GetScalars();
  vtkDataArray* b = limit->GetPointData()->GetScalars();
  double squares = 0.0;
  double peak = 0.0;
  for (vtkIdType i = 0; i < b->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      squares += std::pow(a->GetComponent(i, c) - b->GetComponent(i, c), 2);
      peak = std::max(peak, b->GetComponent(i, c));
    }
  }
  return std::sqrt(squares / (3.0 * b->GetNumberOfTuples())) / peak;
}
}

//------------------------------------------------------------------------------
TEST(RadialLimit, TapsConvergeToTheReferenceFilter)
{
  std::mt19937 generator(7);
  const int size[2] = { 24, 18 };
  vtkNew<vtkImageData> layer;
  layer->SetDimensions(size[0], size[1], 1);
  layer->AllocateScalars(VTK_FLOAT, 3);
  auto* values = static_cast<float*>(layer->GetScalarPointer());
  std::generate_n(
    values, 3 * size[0] * size[1], [&] { return static_cast<float>(generator() / 4294967296.0); });

  vtkNew<vtkGodRaysRadialModel> model;
  vtkNew<vtkGodRaysReferenceFilter> filter;
  filter->SetInputData(layer);
  vtkNew<vtkImageData> sum;
  const double lights[][4] = {
    // X, Y, w, scale: inside, on an edge, outside, far with its march capped, at infinity, behind
    { 0.3, -0.2, 1.0, 1.0 },
    { 1.0, 0.1, 1.0, 1.0 },
    { -2.0, 1.5, 0.7, 1.0 / 0.7 },
    { 300.0, 200.0, 1.0, 1.0 / 300.0 },
    { 0.8, 0.5, 0.0, 1.0 },
    { 0.4, 0.3, -0.9, 0.6 },
  };
  for (const double(&light)[4] : lights)
  {
    for (double decay : { 0.95, 1.0, 1.02 })
    {
      for (double density : { 0.5, 0.97, 1.6 })
      {
        model->SetDecay(decay);
        model->SetDensity(density);
        filter->SetDecay(decay);
        filter->SetDensity(density);
        filter->SetLightClip(light);
        filter->SetMarchScale(light[3]);
        filter->Update();
        double errors[2];
        for (int i = 0; i < 2; ++i)
        {
          ASSERT_TRUE(model->Evaluate(layer, light, light[3], 1.0, size, sum, i == 0 ? 128 : 1024));
          errors[i] = GetError(sum, filter->GetOutput());
        }
        SCOPED_TRACE(testing::Message()
          << "light (" << light[0] << ", " << light[1] << ", " << light[2] << "), decay " << decay
          << ", density " << density);
        EXPECT_LT(errors[1], 1e-4);
        EXPECT_GT(errors[0] / errors[1], 20.0); // 8 times the taps: of second order, 64 at best
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialLimit, ParametersAgree)
{
  vtkNew<vtkGodRaysRadialModel> model;
  vtkNew<vtkGodRaysReferenceFilter> filter;
  EXPECT_EQ(model->GetDensity(), filter->GetDensity());
  EXPECT_EQ(model->GetDecay(), filter->GetDecay());
  EXPECT_EQ(model->GetWeight(), filter->GetWeight());
  EXPECT_EQ(model->GetExposure(), filter->GetExposure());
  EXPECT_EQ(model->GetNumberOfSamples(), filter->GetNumberOfSamples());
}

// Lines of a strip are numbered without gaps, and each number has its place.
TEST(RadialLines, AreCloserInTheStrip)
{
  const vtkGodRays::Vec3 strip(10.0, 14.0, 3.0);
  const std::pair<double, double> places[] = { { 0.0, 0.0 }, { 10.0, 10.0 }, { 11.0, 13.0 },
    { 12.5, 17.5 }, { 14.0, 22.0 }, { 20.0, 28.0 } }; // of even lines among all
  for (const auto& place : places)
  {
    EXPECT_DOUBLE_EQ(vtkGodRays::LineOfEven(place.first, strip), place.second);
    EXPECT_DOUBLE_EQ(vtkGodRays::EvenOfLine(place.second, strip), place.first);
  }
  EXPECT_EQ(vtkGodRays::LineOfEven(7.25, vtkGodRays::Vec3(3.0, 3.0, 4.0)), 7.25); // no strip
  EXPECT_EQ(vtkGodRays::LineOfEven(7.25, vtkGodRays::Vec3(3.0, 9.0, 1.0)), 7.25); // no closer
}
