// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of light as they are shown: exposure, curve, sRGB once, and what cannot be used.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysSkySource.h"
#include "vtkGodRaysToneMappingFilter.h"

#include "vtkExecutive.h"
#include "vtkSMPTools.h"

#include <limits>

using namespace GodRaysFiltersTesting;

namespace
{
// sRGB, written here for itself.
double Encode(double light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

Picture MakeRow(std::vector<double> values, int components = 1)
{
  Picture picture(static_cast<int>(values.size()) / components, 1, components);
  picture.Values = std::move(values);
  return picture;
}
}

//------------------------------------------------------------------------------
TEST(ToneMapping, IsEncodedOnce)
{
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  filter->AutomaticExposureOff();
  filter->SetCurve(vtkGodRaysToneMappingFilter::CLAMP);
  const Picture shown = Scatter(filter, MakeRow({ 0.0, 0.001, 0.18, 0.5, 1.0, 7.0 }));
  // a grey card is 118; encoded twice it would be 182
  EXPECT_EQ(shown.Values, (std::vector<double>{ 0, 3, 118, 188, 255, 255 }));
  EXPECT_EQ(filter->GetOutput()->GetScalarType(), VTK_UNSIGNED_CHAR);
}

TEST(ToneMapping, IsUndoneByDecoding)
{
  for (const double light : { 0.0, 0.001, 0.0031308, 0.18, 1.0, 7.0 })
  {
    EXPECT_NEAR(vtkGodRaysToneMappingFilter::Decode(Encode(light)), light, 1e-6 * (1.0 + light));
  }
  EXPECT_EQ(vtkGodRaysToneMappingFilter::Decode(-0.5), 0.0);
}

TEST(ToneMapping, OfReinhardIsItsFormula)
{
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  filter->AutomaticExposureOff();
  filter->SetExposure(2.0);
  std::vector<double> values;
  for (double value = 1e-3; value < 1e3; value *= 1.3)
  {
    values.push_back(value);
  }
  for (const double white : { 4.0, 1e15 })
  {
    filter->SetWhitePoint(white);
    const Picture shown = Scatter(filter, MakeRow(values));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double light = 2.0 * values[i];
      const double toned = std::min(1.0, light * (1.0 + light / (white * white)) / (1.0 + light));
      EXPECT_NEAR(shown.Values[i], 255.0 * Encode(toned), 0.5001) << light;
    }
    // 4 becomes white, exactly; without a white point 0.8
    filter->SetInputData(MakeImage(MakeRow({ 2.0 })));
    filter->Update();
    EXPECT_EQ(FromImage(filter->GetOutput()).Values[0], white == 4.0 ? 255.0 : 231.0);
  }
}

// The geometric mean becomes the key, in any unit; what is dark does not count.
TEST(ToneMapping, FindsTheExposure)
{
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  for (const double unit : { 1e-6, 1.0, 1e9 })
  {
    Scatter(filter, MakeRow({ 0.5 * unit, 2.0 * unit, 0.0, unit, -3.0, std::nan("") }));
    EXPECT_NEAR(filter->GetUsedExposure() * unit, 0.18, 1e-12);
  }
  filter->SetKey(0.36);
  // green counts 0.7152
  Scatter(filter, MakeRow({ 0.0, 2.0, 0.0, 0.0, 8.0, 0.0 }, 3));
  EXPECT_NEAR(filter->GetUsedExposure(), 0.36 / (0.7152 * 4.0), 1e-12);
  Scatter(filter, MakeRow({ 0.0, 0.0 }));
  EXPECT_EQ(filter->GetUsedExposure(), 1.0) << "a picture without light";
}

TEST(ToneMapping, DoesNotDependOnThreads)
{
  std::mt19937 generator = MakeGenerator(8);
  const Picture noise = MakeNoise(311, 97, 3, generator);
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  const Picture shown = Scatter(filter, noise);
  const double exposure = filter->GetUsedExposure();
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 },
    [&]()
    {
      EXPECT_EQ(GetLargestDifference(Scatter(filter, noise), shown), 0.0);
      EXPECT_EQ(filter->GetUsedExposure(), exposure);
    });
}

// A sky is shown by itself: blue above, neither black nor white.
TEST(ToneMapping, ShowsASky)
{
  vtkNew<vtkGodRaysSkySource> sky;
  sky->SetResolution(32);
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  filter->SetInputConnection(sky->GetOutputPort());
  filter->Update();
  const Picture shown = FromImage(filter->GetOutput());
  EXPECT_EQ(shown.Components, 3);
  EXPECT_GT(shown.Get(16, 16, 2), shown.Get(16, 16, 0) + 40.0);
  EXPECT_GT(shown.Get(16, 16, 2), 80.0);
  EXPECT_LT(shown.Get(16, 16, 2), 200.0);
}

TEST(ToneMapping, TakesAnyLight)
{
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  const double infinity = std::numeric_limits<double>::infinity();
  const Picture shown =
    Scatter(filter, MakeRow({ infinity, -infinity, std::nan(""), 1e300, 1e-300, 1.0 }));
  EXPECT_EQ(shown.Values[1], 0.0);
  EXPECT_EQ(shown.Values[2], 0.0);
  EXPECT_EQ(shown.Values[0], 255.0);
  const ErrorListener errors(filter);
  filter->SetExposure(std::nan(""));
  EXPECT_EQ(filter->GetExposure(), 1.0);
  EXPECT_EQ(errors.Texts.size(), 1u);
}

TEST(ToneMapping, RefusesWhatIsNoPicture)
{
  vtkNew<vtkGodRaysToneMappingFilter> filter;
  const ErrorListener errors(filter);
  const ErrorListener pipeline(filter->GetExecutive());
  Scatter(filter, Picture(2, 2, 2));
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("Give 1 (grey) or 3"), std::string::npos);
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(2, 2, 1);
  filter->SetInputData(empty);
  filter->Update();
  ASSERT_EQ(errors.Texts.size(), 2u);
  EXPECT_NE(errors.Texts[1].find("no scalars"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
