// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The radial model against published numbers, closed forms, and a second, literal evaluation of
// each published formula that shares no code with the model. Without OpenGL.

#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using vtkGodRays::TapSum;
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

namespace
{
// A layer given by a function of uv.
struct FunctionLayer
{
  std::function<double(const Vec2&)> Function;
};
Vec3 SampleLayer(const FunctionLayer& layer, const Vec2& uv)
{
  return Vec3(layer.Function(uv));
}
const FunctionLayer constantLayer = { [](const Vec2&) { return 1.0; } };
const FunctionLayer rampLayer = { [](const Vec2& uv) { return uv.x; } };

// The model's only pass.
TapSum GetTapSum(vtkGodRaysRadialModel* model, int taps = 0)
{
  std::vector<TapSum> passes;
  model->GetTapSums(passes, taps);
  EXPECT_EQ(passes.size(), 1u);
  return passes.front();
}

double SumOver(const FunctionLayer& layer, const TapSum& taps, const Vec2& uv, const Vec2& light)
{
  return vtkGodRays::SumTaps(layer, taps, uv, light - uv).x;
}

// Collects the text of errors instead of printing it.
class ErrorListener
{
public:
  explicit ErrorListener(vtkObject* object)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* texts, void* text) {
        static_cast<std::vector<std::string>*>(texts)->push_back(static_cast<const char*>(text));
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  std::vector<std::string> Texts;

private:
  vtkNew<vtkCallbackCommand> Command;
};

// A random float image.
void MakeImage(vtkImageData* image, int width, int height)
{
  std::mt19937 generator(7);
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 3 * width * height; ++i)
  {
    values[i] = static_cast<float>(generator() / 4294967296.0);
  }
}
}

//------------------------------------------------------------------------------
TEST(RadialModel, MatchesPublishedNumbers)
{
  // Flat: a constant layer of 1. Ramp: s = u, pixel at u = 0.75, light at u = 0.25.
  struct Row
  {
    const char* Preset;
    int NumberOfSamples; // 0: the preset's
    double Flat;
    double Ramp; // 0: not tabulated
    double Tolerance;
  };
  const Row rows[] = {
    { "gianassi", 0, 2.545870634907081, 1.4908499507942736, 1e-12 },
    { "mitchell", 0, 2.585870634907081, 1.510706468254647, 1e-12 },
    { "equation", 0, 0.0255051192855801, 0.014884744035720992, 1e-12 },
    { "layers", 50, 1.03192, 0.0, 1e-5 },
    { "layers", 0, 1.65624, 1.0531855067689746, 1e-5 },
    { "layers", 200, 2.26248, 0.0, 1e-5 },
    { "layers", 300, 2.48438, 1.6742834590531153, 1e-5 },
    { "postprocessing", 0, 2.395687175280205, 1.6071805633032388, 1e-12 },
    { "babylon", 0, 2.2471510912228267, 1.4164181291978513, 1e-12 },
    { "erkaman", 0, 1.0, 0.0, 1e-12 },
    { "araujo", 0, 2.0, 0.0, 1e-12 },
  };
  for (const Row& row : rows)
  {
    SCOPED_TRACE(row.Preset);
    vtkNew<vtkGodRaysRadialModel> model;
    ASSERT_TRUE(model->ApplyPreset(row.Preset));
    if (row.NumberOfSamples > 0)
    {
      model->SetNumberOfSamples(row.NumberOfSamples);
    }
    TapSum taps = GetTapSum(model);
    taps.Maximum = 0.0; // the numbers are those before the clamp
    const Vec2 uv(0.75, 0.5);
    const Vec2 light(0.25, 0.5);
    EXPECT_NEAR(SumOver(constantLayer, taps, uv, light) / row.Flat, 1.0, row.Tolerance);
    EXPECT_NEAR(model->GetFlatGain() / row.Flat, 1.0, row.Tolerance);
    if (row.Ramp > 0.0)
    {
      EXPECT_NEAR(SumOver(rampLayer, taps, uv, light) / row.Ramp, 1.0, 1e-12);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, ClampsWhereTheAuthorsDo)
{
  vtkNew<vtkGodRaysRadialModel> model;
  for (const char* preset : { "layers", "layers-as-published", "postprocessing" })
  {
    ASSERT_TRUE(model->ApplyPreset(preset));
    EXPECT_EQ(SumOver(constantLayer, GetTapSum(model), Vec2(0.5), Vec2(0.1)), 1.0);
    model->SetClampMaximum(0.25);
    EXPECT_EQ(SumOver(constantLayer, GetTapSum(model), Vec2(0.5), Vec2(0.1)), 0.25);
  }
  ASSERT_TRUE(model->ApplyPreset("mitchell"));
  EXPECT_GT(SumOver(constantLayer, GetTapSum(model), Vec2(0.5), Vec2(0.1)), 2.0);
}

//------------------------------------------------------------------------------
TEST(RadialModel, BrightnessDoesNotDependOnTaps)
{
  vtkNew<vtkGodRaysRadialModel> model;
  for (double decay : { 0.0, 0.5, 0.9, 0.98, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.02, 1.05 })
  {
    for (int samples : { 1, 60, 100 })
    {
      model->SetDecay(decay);
      model->SetNumberOfSamples(samples);
      double published = 0.0;
      for (int k = 0; k < samples; ++k)
      {
        published += model->GetExposure() * model->GetWeight() * std::pow(decay, k);
      }
      EXPECT_NEAR(model->GetFlatGain() / published, 1.0, 1e-12);
      for (int taps : { 1, 16, 17, 32, 60, 100, 128, 256, 512 })
      {
        const double sum =
          SumOver(constantLayer, GetTapSum(model, taps), Vec2(0.75, 0.5), Vec2(0.25, 0.5));
        EXPECT_NEAR(sum / published, 1.0, 1e-12)
          << "decay " << decay << ", samples " << samples << ", taps " << taps;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, ConvergesOnARamp)
{
  // The ramp with the numbers of postprocessing; its limit is 1.616932.
  vtkNew<vtkGodRaysRadialModel> model;
  ASSERT_TRUE(model->ApplyPreset("postprocessing"));
  model->SetFormulation(vtkGodRaysRadialModel::INVARIANT);
  const int taps[] = { 15, 30, 60, 120, 240 };
  const double midpoint[] = { 1.614247, 1.616259, 1.616763, 1.616889, 1.616921 };
  const double rightEnd[] = { 1.57592, 1.59709, 1.60718, 1.61210, 1.61453 };
  for (int i = 0; i < 5; ++i)
  {
    TapSum sum = GetTapSum(model, taps[i]);
    EXPECT_NEAR(SumOver(rampLayer, sum, Vec2(0.75, 0.5), Vec2(0.25, 0.5)), midpoint[i], 6e-7);
    sum.TapOffset = 0.0;
    EXPECT_NEAR(SumOver(rampLayer, sum, Vec2(0.75, 0.5), Vec2(0.25, 0.5)), rightEnd[i], 6e-6);
  }
  const TapSum limit = GetTapSum(model, 100000);
  EXPECT_NEAR(SumOver(rampLayer, limit, Vec2(0.75, 0.5), Vec2(0.25, 0.5)), 1.616932, 6e-7);
}

//------------------------------------------------------------------------------
TEST(RadialModel, ConvergesToClosedForms)
{
  // In units of the flat gain: a disc of radius R about the light, seen from r, gives
  // (e^(-k t) - e^-k)/(k phi(k)) with t = max(0, (1 - R/r)/density).
  vtkNew<vtkGodRaysRadialModel> model;
  const Vec2 light(0.4, 0.7);
  const double radius = 0.1;
  const FunctionLayer disc = { [&](const Vec2& uv)
    { return glm::length(uv - light) < radius ? 1.0 : 0.0; } };
  const FunctionLayer halfPlane = { [&](const Vec2& uv)
    { return glm::dot(uv - light, Vec2(0.6, -0.8)) > 0.0 ? 1.0 : 0.0; } };
  for (double decay : { 0.9, 0.98, 1.01 })
  {
    for (double density : { 0.3, 0.97 })
    {
      model->SetDecay(decay);
      model->SetDensity(density);
      const double gain = model->GetFlatGain();
      const double k = -model->GetNumberOfSamples() * std::log(decay);
      const double phi = vtkGodRays::MeanExponential(k);
      for (double r : { 0.05, 0.13, 0.3, 0.8 })
      {
        const Vec2 uv = light + r * Vec2(0.8, -0.6);
        const double start = glm::clamp((1.0 - radius / r) / density, 0.0, 1.0);
        const double exact = (std::exp(-k * start) - std::exp(-k)) / (k * phi);
        for (int taps : { 64, 1024, 16384 })
        {
          // At most one tap falls on the wrong side of the edge, by half a step.
          const double steepest = std::max(1.0, std::exp(-k)) / phi;
          const double sum = SumOver(disc, GetTapSum(model, taps), uv, light) / gain;
          EXPECT_NEAR(sum, exact, 0.51 * steepest / taps + 1e-4 * 64 / taps) << "r " << r;
          EXPECT_NEAR(SumOver(halfPlane, GetTapSum(model, taps), uv, light) / gain, 1.0, 1e-11);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, ErrorFallsWithTheSquareOfTaps)
{
  vtkNew<vtkGodRaysRadialModel> model;
  const FunctionLayer smooth = { [](const Vec2& uv)
    { return std::exp(-20.0 * glm::dot(uv - 0.5, uv - 0.5)); } };
  const Vec2 uv(0.9, 0.8);
  const Vec2 light(0.45, 0.55);
  const double exact = SumOver(smooth, GetTapSum(model, 200000), uv, light);
  const double coarse = SumOver(smooth, GetTapSum(model, 64), uv, light) - exact;
  const double fine = SumOver(smooth, GetTapSum(model, 128), uv, light) - exact;
  EXPECT_NEAR(coarse / fine, 4.0, 0.02);
}

//------------------------------------------------------------------------------
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
    case vtkGodRaysRadialModel::INVARIANT:
      for (int k = 0; k < n; ++k)
      {
        sum += power(k) * s(k + 0.5);
      }
      return p.Exposure * p.Weight * sum;
    case vtkGodRaysRadialModel::MITCHELL:
    case vtkGodRaysRadialModel::ARAUJO:
      for (int k = 1; k <= n; ++k)
      {
        sum += power(k - 1) * s(k);
      }
      return p.Exposure * (s(0) + p.Weight * sum);
    case vtkGodRaysRadialModel::GIANASSI:
      for (int k = 1; k < n; ++k)
      {
        sum += power(k) * s(k);
      }
      return p.Exposure * (s(0) + p.Weight * sum);
    case vtkGodRaysRadialModel::LAYERS_AS_PUBLISHED:
      return Evaluate(vtkGodRaysRadialModel::LAYERS, picture, p, u, v, lightU, lightV, 0);
    case vtkGodRaysRadialModel::LAYERS:
      for (int k = 1; k <= n; ++k)
      {
        sum += 0.1 * power(k - 1) * s(k);
      }
      return Clamp(p.Exposure * p.Weight * sum, p.Maximum);
    case vtkGodRaysRadialModel::EQUATION:
      for (int k = 0; k <= n; ++k)
      {
        sum += power(k) * p.Weight * s(k) / n;
      }
      return p.Exposure * sum;
    case vtkGodRaysRadialModel::POSTPROCESSING:
      for (int k = 0; k < n; ++k)
      {
        sum += power(k) * s(k + 1);
      }
      return Clamp(p.Exposure * p.Weight * sum, p.Maximum);
    case vtkGodRaysRadialModel::BABYLON:
      sum = 0.4 * s(0);
      for (int k = 0; k < n; ++k)
      {
        sum += 0.4 * p.Weight * power(k) * s(k + 1);
      }
      return p.Exposure * sum;
    case vtkGodRaysRadialModel::ERKAMAN:
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
// Formulation, and whether the layer has a margin.
class RadialFormulation : public testing::TestWithParam<std::tuple<int, double>>
{
};

TEST_P(RadialFormulation, EqualsASecondEvaluation)
{
  const int formulation = std::get<0>(this->GetParam());
  const double viewScale = std::get<1>(this->GetParam());
  vtkNew<vtkGodRaysRadialModel> model;
  model->SetFormulation(formulation);
  model->SetDensity(0.9);
  model->SetDecay(0.93);
  model->SetWeight(0.21);
  model->SetExposure(0.7);
  model->SetNumberOfSamples(23);
  model->SetClampMaximum(0.3);
  const published::Numbers numbers = { 0.9, 0.93, 0.21, 0.7, 0.3, 23 };

  vtkNew<vtkImageData> layer;
  MakeImage(layer, 13, 9);
  const auto* values = static_cast<const float*>(layer->GetScalarPointer());
  const published::Picture picture = { { values, values + 3 * 13 * 9 }, 13, 9,
    formulation == vtkGodRaysRadialModel::INVARIANT ||
      formulation == vtkGodRaysRadialModel::EQUATION };

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
          const double expected = formulation == vtkGodRaysRadialModel::THREE_JS
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
    testing::Range(0, vtkGodRaysRadialModel::ARAUJO + 1), testing::Values(1.0, 0.5)));

//------------------------------------------------------------------------------
TEST(RadialModel, ErkamanNeverTakesMoreThan100Taps)
{
  vtkNew<vtkGodRaysRadialModel> model;
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
TEST(RadialModel, ThreeJSGivesTheOpenSkyItsExposure)
{
  vtkNew<vtkGodRaysRadialModel> model;
  ASSERT_TRUE(model->ApplyPreset("three.js"));
  EXPECT_NEAR(model->GetFlatGain(), 0.69, 1e-15);
  std::vector<TapSum> passes;
  model->GetTapSums(passes, 0);
  EXPECT_EQ(passes.size(), 3u);
}

//------------------------------------------------------------------------------
TEST(RadialModel, StatesEachFormulationsConventions)
{
  vtkNew<vtkGodRaysRadialModel> model;
  std::set<std::string> names;
  for (int i = 0; i <= vtkGodRaysRadialModel::ARAUJO; ++i)
  {
    model->SetFormulation(i);
    names.insert(model->GetFormulationAsString());
    const bool ownOrEquation =
      i == vtkGodRaysRadialModel::INVARIANT || i == vtkGodRaysRadialModel::EQUATION;
    const bool screen = i == vtkGodRaysRadialModel::POSTPROCESSING;
    EXPECT_EQ(model->GetLinearLight(), ownOrEquation || screen);
    EXPECT_EQ(model->GetBorder(),
      ownOrEquation ? vtkGodRaysRadialModel::ZERO_BORDER : vtkGodRaysRadialModel::EDGE_BORDER);
    EXPECT_EQ(
      model->GetBlend(), screen ? vtkGodRaysRadialModel::SCREEN : vtkGodRaysRadialModel::ADD);
    EXPECT_EQ(model->CapsMarch(), i == vtkGodRaysRadialModel::INVARIANT);
    EXPECT_EQ(model->GetSceneGain(), i == vtkGodRaysRadialModel::BABYLON ? 1.1 : 1.0);
    EXPECT_NE(model->Describe().find(model->GetFormulationAsString()), std::string::npos);
    EXPECT_EQ(model->Describe().find('\n'), std::string::npos);
  }
  EXPECT_EQ(names.size(), vtkGodRaysRadialModel::ARAUJO + 1u);
}

//------------------------------------------------------------------------------
TEST(RadialModel, ScattersNothingAtZero)
{
  vtkNew<vtkGodRaysRadialModel> model;
  vtkNew<vtkImageData> layer;
  vtkNew<vtkImageData> result;
  MakeImage(layer, 5, 5);
  const double light[3] = { 0.2, 0.2, 1.0 };
  const int size[2] = { 4, 3 };
  using Setter = std::function<void(double)>;
  const Setter setters[] = { [&](double value) { model->SetDensity(value); },
    [&](double value) { model->SetWeight(value); },
    [&](double value) { model->SetExposure(value); } };
  for (const Setter& set : setters)
  {
    set(0.0);
    EXPECT_FALSE(model->CanScatter());
    ASSERT_TRUE(model->Evaluate(layer, light, 1.0, 1.0, size, result));
    EXPECT_EQ(result->GetScalarRange()[1], 0.0);
    set(1.0);
    EXPECT_TRUE(model->CanScatter());
  }
  model->SetClampMaximum(0.0);
  EXPECT_TRUE(model->CanScatter());
  model->SetFormulation(vtkGodRaysRadialModel::POSTPROCESSING);
  EXPECT_FALSE(model->CanScatter());
}

//------------------------------------------------------------------------------
TEST(RadialModel, IsFiniteForExtremeParameters)
{
  vtkNew<vtkImageData> layer;
  vtkNew<vtkImageData> result;
  MakeImage(layer, 8, 8);
  const double light[3] = { 0.125, 0.125, 1.0 }; // the centre of a pixel
  const int size[2] = { 8, 8 };
  vtkNew<vtkGodRaysRadialModel> model;
  for (int formulation = 0; formulation <= vtkGodRaysRadialModel::ARAUJO; ++formulation)
  {
    model->SetFormulation(formulation);
    for (double decay : { 0.0, 1e-300, 1.0, 1.05 })
    {
      for (int samples : { 1, 2, 1024 })
      {
        for (double density : { 1e-300, 1.0, 2.0 })
        {
          model->SetDecay(decay);
          model->SetNumberOfSamples(samples);
          model->SetDensity(density);
          ASSERT_TRUE(model->Evaluate(layer, light, 1.0, 1.0, size, result));
          ASSERT_TRUE(std::isfinite(result->GetScalarRange()[0]));
          ASSERT_TRUE(std::isfinite(result->GetScalarRange()[1]));
          ASSERT_GE(result->GetScalarRange()[0], 0.0);
          ASSERT_TRUE(std::isfinite(model->GetFlatGain()));
          ASSERT_LT(model->GetFlatGain(), 3e38); // what the graphics card can sum
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, RefusesWhatItCannotEvaluate)
{
  vtkNew<vtkGodRaysRadialModel> model;
  ErrorListener errors(model);
  vtkNew<vtkImageData> layer;
  vtkNew<vtkImageData> result;
  MakeImage(layer, 5, 5);
  MakeImage(result, 2, 2);
  const double light[3] = { 0.2, 0.2, 1.0 };
  const int size[2] = { 4, 3 };
  const int empty[2] = { 4, 0 };
  vtkNew<vtkImageData> doubles;
  doubles->SetDimensions(5, 5, 1);
  doubles->AllocateScalars(VTK_DOUBLE, 3);
  vtkNew<vtkImageData> nothing;
  EXPECT_FALSE(model->Evaluate(nullptr, light, 1.0, 1.0, size, result));
  EXPECT_FALSE(model->Evaluate(layer, light, 1.0, 1.0, size, nullptr));
  EXPECT_FALSE(model->Evaluate(doubles, light, 1.0, 1.0, size, result));
  EXPECT_FALSE(model->Evaluate(nothing, light, 1.0, 1.0, size, result));
  EXPECT_FALSE(model->Evaluate(layer, light, HUGE_VAL, 1.0, size, result));
  EXPECT_FALSE(model->Evaluate(layer, light, 1.0, 0.0, size, result));
  EXPECT_FALSE(model->Evaluate(layer, light, 1.0, 1.0, empty, result));
  EXPECT_EQ(errors.Texts.size(), 7u);
  EXPECT_EQ(result->GetDimensions()[0], 2);
  EXPECT_TRUE(model->Evaluate(layer, light, 1.0, 1.0, size, result));
  EXPECT_EQ(errors.Texts.size(), 7u);
}

//------------------------------------------------------------------------------
TEST(RadialModel, ParametersAreClampedAndNeverNaN)
{
  vtkNew<vtkGodRaysRadialModel> model;
  ErrorListener errors(model);
  using Model = vtkGodRaysRadialModel;
  struct Row
  {
    const char* Name;
    void (Model::*Set)(double);
    double (Model::*Get)();
    double Default, Maximum;
  };
  const Row rows[] = {
    { "Density", &Model::SetDensity, &Model::GetDensity, 0.97, 2.0 },
    { "Decay", &Model::SetDecay, &Model::GetDecay, 0.98, 1.05 },
    { "Weight", &Model::SetWeight, &Model::GetWeight, 0.03, 100.0 },
    { "Exposure", &Model::SetExposure, &Model::GetExposure, 1.0, 100.0 },
    { "ClampMaximum", &Model::SetClampMaximum, &Model::GetClampMaximum, 1.0, 65504.0 },
  };
  std::size_t count = 0;
  for (const Row& row : rows)
  {
    SCOPED_TRACE(row.Name);
    auto get = [&] { return (model->*row.Get)(); };
    auto set = [&](double value) { (model->*row.Set)(value); };
    EXPECT_EQ(get(), row.Default);
    for (double value : { std::nan(""), HUGE_VAL, -HUGE_VAL })
    {
      const vtkMTimeType before = model->GetMTime();
      set(value);
      EXPECT_EQ(get(), row.Default);
      EXPECT_EQ(model->GetMTime(), before);
      ASSERT_EQ(errors.Texts.size(), ++count);
      EXPECT_NE(errors.Texts.back().find(row.Name), std::string::npos);
      std::ostringstream stays;
      stays << "stays " << row.Default;
      EXPECT_NE(errors.Texts.back().find(stays.str()), std::string::npos);
    }
    set(-1.0);
    EXPECT_EQ(get(), 0.0);
    set(1e30);
    EXPECT_EQ(get(), row.Maximum);
    const vtkMTimeType before = model->GetMTime();
    set(1e30);
    EXPECT_EQ(model->GetMTime(), before);
    set(0.5);
    EXPECT_EQ(get(), 0.5);
    EXPECT_GT(model->GetMTime(), before);
  }
  model->SetNumberOfSamples(0);
  EXPECT_EQ(model->GetNumberOfSamples(), 1);
  model->SetNumberOfSamples(100000);
  EXPECT_EQ(model->GetNumberOfSamples(), 1024);
  const vtkMTimeType before = model->GetMTime();
  model->SetFormulation(vtkGodRaysRadialModel::BABYLON);
  EXPECT_GT(model->GetMTime(), before);
  for (int formulation : { -1, vtkGodRaysRadialModel::ARAUJO + 1 })
  {
    model->SetFormulation(formulation);
    EXPECT_EQ(model->GetFormulation(), vtkGodRaysRadialModel::BABYLON);
    EXPECT_EQ(errors.Texts.size(), ++count);
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, PrintsEveryParameter)
{
  vtkNew<vtkGodRaysRadialModel> model;
  ASSERT_TRUE(model->ApplyPreset("babylon"));
  model->SetClampMaximum(0.375);
  std::ostringstream text;
  model->Print(text);
  for (const char* line : { "Density: 0.926\n", "Decay: 0.96815\n", "Weight: 0.58767\n",
         "Exposure: 0.3\n", "NumberOfSamples: 100\n", "ClampMaximum: 0.375\n",
         "Formulation: babylon\n", "SceneGain: 1.1\n" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

//------------------------------------------------------------------------------
TEST(RadialModel, HasPresets)
{
  using Model = vtkGodRaysRadialModel;
  std::set<std::string> names;
  std::set<int> formulations;
  vtkNew<Model> model;
  ErrorListener errors(model);
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    SCOPED_TRACE(Model::GetPresetName(i));
    names.insert(Model::GetPresetName(i));
    EXPECT_FALSE(std::string(Model::GetPresetDescription(i)).empty());
    ASSERT_TRUE(model->ApplyPreset(Model::GetPresetName(i)));
    EXPECT_TRUE(model->CanScatter());
    formulations.insert(model->GetFormulation());
    if (model->GetFormulation() != Model::INVARIANT)
    {
      EXPECT_STREQ(model->GetFormulationAsString(), Model::GetPresetName(i));
    }
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Model::GetNumberOfPresets()));
  EXPECT_EQ(formulations.size(), Model::ARAUJO + 1u);
  EXPECT_GE(Model::GetNumberOfPresets(), Model::ARAUJO + 7);
  EXPECT_EQ(Model::GetPresetName(-1), nullptr);
  EXPECT_EQ(Model::GetPresetDescription(Model::GetNumberOfPresets()), nullptr);

  // "default" is what a new model has.
  ASSERT_TRUE(model->ApplyPreset("default"));
  vtkNew<Model> fresh;
  EXPECT_EQ(model->Describe(), fresh->Describe());
  EXPECT_EQ(model->GetClampMaximum(), fresh->GetClampMaximum());
  EXPECT_TRUE(errors.Texts.empty());

  ASSERT_TRUE(model->ApplyPreset("underwater"));
  const std::string before = model->Describe();
  EXPECT_FALSE(model->ApplyPreset("no-such-look"));
  EXPECT_FALSE(model->ApplyPreset(nullptr));
  EXPECT_EQ(model->Describe(), before);
  ASSERT_EQ(errors.Texts.size(), 2u);
  EXPECT_NE(errors.Texts[0].find("\"no-such-look\""), std::string::npos);
  for (const std::string& name : names)
  {
    EXPECT_NE(errors.Texts[0].find(name), std::string::npos);
  }
}
