// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Every published formulation, and our own sum, against a second, literal evaluation of the formula that
// shares no code with the models. Without OpenGL.

#include "GodRaysMathTesting.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using vtkGodRays::TapSum;
using vtkGodRays::Vec3;

// Among the formulations: the sum of a vtkGodRaysRadialModel.
constexpr int Ours = -1;

// The published formulas once more, each as its authors' loop adds it up.
namespace published
{
struct Picture
{
  std::vector<double> Values;
  int Width;
  int Height;
  bool ZeroOutside;

  double Get(int x, int y, int channel) const
  {
    if (this->ZeroOutside && (x < 0 || y < 0 || x >= this->Width || y >= this->Height))
    {
      return 0.0;
    }
    x = std::min(std::max(x, 0), this->Width - 1);
    y = std::min(std::max(y, 0), this->Height - 1);
    return this->Values[3 * (y * this->Width + x) + channel];
  }
  double Read(double u, double v, int channel) const
  {
    const double x = u * this->Width - 0.5;
    const double y = v * this->Height - 0.5;
    const int left = static_cast<int>(std::floor(x));
    const int low = static_cast<int>(std::floor(y));
    double sum = 0.0;
    for (int dy = 0; dy < 2; ++dy)
    {
      for (int dx = 0; dx < 2; ++dx)
      {
        sum += (1.0 - std::abs(x - left - dx)) * (1.0 - std::abs(y - low - dy)) *
          this->Get(left + dx, low + dy, channel);
      }
    }
    return sum;
  }
};

struct Numbers
{
  double Density, Decay, Weight, Exposure, Maximum;
  int Samples;
};

double Clamp(double value, double maximum)
{
  return std::min(std::max(value, 0.0), maximum);
}

double Evaluate(int formulation, const Picture& picture, const Numbers& p, double u, double v,
  double lightU, double lightV, int channel)
{
  const int n = p.Samples;
  const double du = (lightU - u) * p.Density / n;
  const double dv = (lightV - v) * p.Density / n;
  auto s = [&](double k) { return picture.Read(u + k * du, v + k * dv, channel); };
  auto power = [&](int k) { return std::pow(p.Decay, k); };
  double sum = 0.0;
  switch (formulation)
  {
    case Ours:
      for (int k = 0; k < n; ++k)
      {
        sum += power(k) * s(k + 0.5);
      }
      return p.Exposure * p.Weight * sum;
    case vtkGodRaysPublishedModel::MITCHELL:
    case vtkGodRaysPublishedModel::ARAUJO:
      for (int k = 1; k <= n; ++k)
      {
        sum += power(k - 1) * s(k);
      }
      return p.Exposure * (s(0) + p.Weight * sum);
    case vtkGodRaysPublishedModel::GIANASSI:
      for (int k = 1; k < n; ++k)
      {
        sum += power(k) * s(k);
      }
      return p.Exposure * (s(0) + p.Weight * sum);
    case vtkGodRaysPublishedModel::LAYERS_AS_PUBLISHED:
      return Evaluate(vtkGodRaysPublishedModel::LAYERS, picture, p, u, v, lightU, lightV, 0);
    case vtkGodRaysPublishedModel::LAYERS:
      for (int k = 1; k <= n; ++k)
      {
        sum += 0.1 * power(k - 1) * s(k);
      }
      return Clamp(p.Exposure * p.Weight * sum, p.Maximum);
    case vtkGodRaysPublishedModel::EQUATION:
      for (int k = 0; k <= n; ++k)
      {
        sum += power(k) * p.Weight * s(k) / n;
      }
      return p.Exposure * sum;
    case vtkGodRaysPublishedModel::POSTPROCESSING:
      for (int k = 0; k < n; ++k)
      {
        sum += power(k) * s(k + 1);
      }
      return Clamp(p.Exposure * p.Weight * sum, p.Maximum);
    case vtkGodRaysPublishedModel::BABYLON:
      sum = 0.4 * s(0);
      for (int k = 0; k < n; ++k)
      {
        sum += 0.4 * p.Weight * power(k) * s(k + 1);
      }
      return p.Exposure * sum;
    case vtkGodRaysPublishedModel::ERKAMAN:
      for (int k = 0; k < 100 && k <= n; ++k)
      {
        sum += power(k) * s(k + 1);
      }
      return p.Exposure * p.Weight * sum;
    default:
      ADD_FAILURE() << "no second evaluation of formulation " << formulation;
      return 0.0;
  }
}

// One pass of three.js, in red.
double EvaluateThreeJSPass(
  const Picture& mask, double length, double u, double v, double lightU, double lightV)
{
  const double distance = std::hypot(lightU - u, lightV - v);
  double sum = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    if (i > 0 && i > distance / length)
    {
      break;
    }
    const double fraction = i == 0 ? 0.0 : i * length / distance;
    const double y = v + fraction * (lightV - v);
    sum += y < 1.0 ? mask.Read(u + fraction * (lightU - u), y, 0) / 6.0 : 0.0;
  }
  return sum;
}

// Three passes: on the pixels of the layer, which reaches beyond the picture by 1/viewScale, and
// the last one at a point of the picture. Lengths and the light are in the picture's uv.
double EvaluateThreeJS(const Picture& light, double exposure, double viewScale, double u, double v,
  double lightU, double lightV)
{
  auto toLayer = [&](double x) { return 0.5 + (x - 0.5) * viewScale; };
  Picture mask = light;
  for (double& value : mask.Values)
  {
    value = 1.0 - value;
  }
  for (double length : { 1.0 / 6.0, 1.0 / 36.0 })
  {
    Picture blurred = mask;
    for (int y = 0; y < mask.Height; ++y)
    {
      for (int x = 0; x < mask.Width; ++x)
      {
        blurred.Values[3 * (y * mask.Width + x)] = EvaluateThreeJSPass(mask, length * viewScale,
          (x + 0.5) / mask.Width, (y + 0.5) / mask.Height, toLayer(lightU), toLayer(lightV));
      }
    }
    mask = blurred;
  }
  return exposure *
    (1.0 -
      EvaluateThreeJSPass(
        mask, viewScale / 216.0, toLayer(u), toLayer(v), toLayer(lightU), toLayer(lightV)));
}
}

//------------------------------------------------------------------------------
namespace
{
vtkSmartPointer<vtkGodRaysRadialSumModel> MakeModel(int formulation, double maximum)
{
  if (formulation == Ours)
  {
    return vtkSmartPointer<vtkGodRaysRadialModel>::New();
  }
  auto model = vtkSmartPointer<vtkGodRaysPublishedModel>::New();
  model->SetFormulation(formulation);
  model->SetClampMaximum(maximum);
  return model;
}
}

//------------------------------------------------------------------------------
// Formulation, and whether the layer has a margin.
class RadialFormulation : public testing::TestWithParam<std::tuple<int, double>>
{
};

TEST_P(RadialFormulation, EqualsASecondEvaluation)
{
  const int formulation = std::get<0>(this->GetParam());
  const double viewScale = std::get<1>(this->GetParam());
  const auto model = MakeModel(formulation, 0.3);
  model->SetDensity(0.9);
  model->SetDecay(0.93);
  model->SetWeight(0.21);
  model->SetExposure(0.7);
  model->SetNumberOfSamples(23);
  const published::Numbers numbers = { 0.9, 0.93, 0.21, 0.7, 0.3, 23 };

  vtkNew<vtkImageData> layer;
  MakeImage(layer, 13, 9);
  const auto* values = static_cast<const float*>(layer->GetScalarPointer());
  const published::Picture picture = { { values, values + 3 * 13 * 9 }, 13, 9,
    formulation == Ours || formulation == vtkGodRaysPublishedModel::EQUATION };

  // In the picture and on a pixel's centre, beyond two edges, and behind the camera.
  const double w = 2.5;
  const int size[2] = { 7, 5 };
  for (const Vec3& light : { w * Vec3(3.0 / 7.0, -0.4, 1.0), w * Vec3(-2.5, 1.9, 1.0),
         w * Vec3(0.3, 3.1, 1.0), -w * Vec3(0.7, 0.2, 1.0) })
  {
    vtkNew<vtkImageData> result;
    const double clip[3] = { light.x * viewScale, light.y * viewScale, light.z };
    ASSERT_TRUE(model->Evaluate(layer, clip, 1.0 / light.z, viewScale, size, result));
    ASSERT_EQ(result->GetScalarType(), VTK_DOUBLE);
    const double lightU = 0.5 + 0.5 * light.x / light.z;
    const double lightV = 0.5 + 0.5 * light.y / light.z;
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          const double u = (x + 0.5) / size[0];
          const double v = (y + 0.5) / size[1];
          auto toLayer = [&](double t) { return 0.5 + (t - 0.5) * viewScale; };
          const double expected = formulation == vtkGodRaysPublishedModel::THREE_JS
            ? published::EvaluateThreeJS(picture, 0.7, viewScale, u, v, lightU, lightV)
            : published::Evaluate(formulation, picture, numbers, toLayer(u), toLayer(v),
                toLayer(lightU), toLayer(lightV), channel);
          ASSERT_NEAR(result->GetScalarComponentAsDouble(x, y, 0, channel), expected, 1e-12)
            << "pixel " << x << ", " << y << ", channel " << channel;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RadialFormulation,
  testing::Combine(
    testing::Range(Ours, vtkGodRaysPublishedModel::ARAUJO + 1), testing::Values(1.0, 0.5)));

//------------------------------------------------------------------------------
TEST(RadialFormulations, ErkamanNeverTakesMoreThan100Taps)
{
  vtkNew<vtkGodRaysPublishedModel> model;
  ASSERT_TRUE(model->ApplyPreset("erkaman"));
  const int samples[] = { 1, 50, 99, 100, 500 };
  const int taps[] = { 2, 51, 100, 100, 100 };
  for (int i = 0; i < 5; ++i)
  {
    model->SetNumberOfSamples(samples[i]);
    EXPECT_NEAR(model->GetFlatGain(), 0.01 * taps[i], 1e-14);
  }
}

//------------------------------------------------------------------------------
TEST(RadialFormulations, ThreeJSGivesTheOpenSkyItsExposure)
{
  vtkNew<vtkGodRaysPublishedModel> model;
  ASSERT_TRUE(model->ApplyPreset("three.js"));
  EXPECT_NEAR(model->GetFlatGain(), 0.69, 1e-15);
  std::vector<TapSum> passes;
  model->GetTapSums(passes, 0);
  EXPECT_EQ(passes.size(), 3u);
}

//------------------------------------------------------------------------------
TEST(RadialFormulations, StatesEachFormulationsConventions)
{
  std::set<std::string> names;
  for (int i = Ours; i <= vtkGodRaysPublishedModel::ARAUJO; ++i)
  {
    const auto model = MakeModel(i, 1.0);
    const bool ownOrEquation = i == Ours || i == vtkGodRaysPublishedModel::EQUATION;
    const bool screen = i == vtkGodRaysPublishedModel::POSTPROCESSING;
    EXPECT_EQ(model->GetLinearLight(), ownOrEquation || screen);
    EXPECT_EQ(model->GetBorder(),
      ownOrEquation ? vtkGodRaysPublishedModel::ZERO_BORDER
                    : vtkGodRaysPublishedModel::EDGE_BORDER);
    EXPECT_EQ(
      model->GetBlend(), screen ? vtkGodRaysPublishedModel::SCREEN : vtkGodRaysPublishedModel::ADD);
    EXPECT_EQ(model->CapsMarch(), i == Ours);
    EXPECT_EQ(model->GetSceneGain(), i == vtkGodRaysPublishedModel::BABYLON ? 1.1 : 1.0);
    EXPECT_EQ(model->Describe().find('\n'), std::string::npos);
    if (auto published = vtkGodRaysPublishedModel::SafeDownCast(model))
    {
      names.insert(published->GetFormulationAsString());
      EXPECT_NE(model->Describe().find(published->GetFormulationAsString()), std::string::npos);
    }
  }
  EXPECT_EQ(names.size(), vtkGodRaysPublishedModel::ARAUJO + 1u);
}
