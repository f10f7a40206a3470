// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The models of radial sums against published numbers and closed forms; their parameters, errors and
// presets.
// Without OpenGL.

#include "GodRaysMathTesting.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
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
TapSum GetTapSum(vtkGodRaysRadialSumModel* model, int taps = 0)
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
  model->SetDensity(0.96);
  model->SetDecay(0.9);
  model->SetWeight(0.4);
  model->SetExposure(0.6);
  model->SetNumberOfSamples(60);
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
}

//------------------------------------------------------------------------------
TEST(RadialModel, IsFiniteForExtremeParameters)
{
  vtkNew<vtkImageData> layer;
  vtkNew<vtkImageData> result;
  MakeImage(layer, 8, 8);
  const double light[3] = { 0.125, 0.125, 1.0 }; // the centre of a pixel
  const int size[2] = { 8, 8 };
  std::vector<vtkSmartPointer<vtkGodRaysRadialSumModel>> models;
  models.push_back(vtkSmartPointer<vtkGodRaysRadialModel>::New());
  for (int formulation = 0; formulation <= vtkGodRaysPublishedModel::ARAUJO; ++formulation)
  {
    auto published = vtkSmartPointer<vtkGodRaysPublishedModel>::New();
    published->SetFormulation(formulation);
    published->SetWeight(models[0]->GetWeight());
    published->SetExposure(models[0]->GetExposure());
    models.push_back(published);
  }
  for (const auto& model : models)
  {
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
    { "Decay", &Model::SetDecay, &Model::GetDecay, 1.0, 1.05 },
    { "Weight", &Model::SetWeight, &Model::GetWeight, 0.013, 100.0 },
    { "Exposure", &Model::SetExposure, &Model::GetExposure, 1.0, 100.0 },
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
  EXPECT_EQ(model->GetNumberOfSamples(), 10000);
}

//------------------------------------------------------------------------------
// What any model with presets does; applied is called after each.
template <typename Model>
void CheckPresets(const char* usual, const std::function<void(Model*, const char*)>& applied)
{
  std::set<std::string> names;
  vtkNew<Model> model;
  ErrorListener errors(model);
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    SCOPED_TRACE(Model::GetPresetName(i));
    names.insert(Model::GetPresetName(i));
    EXPECT_FALSE(std::string(Model::GetPresetDescription(i)).empty());
    ASSERT_TRUE(model->ApplyPreset(Model::GetPresetName(i)));
    EXPECT_TRUE(model->CanScatter());
    applied(model, Model::GetPresetName(i));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Model::GetNumberOfPresets()));
  EXPECT_EQ(Model::GetPresetName(-1), nullptr);
  EXPECT_EQ(Model::GetPresetDescription(Model::GetNumberOfPresets()), nullptr);

  // the usual one is what a new model has
  const std::string before = model->Describe();
  ASSERT_TRUE(model->ApplyPreset(usual));
  vtkNew<Model> fresh;
  EXPECT_EQ(model->Describe(), fresh->Describe());
  EXPECT_NE(model->Describe(), before);
  EXPECT_TRUE(errors.Texts.empty());

  EXPECT_FALSE(model->ApplyPreset("no-such-look"));
  EXPECT_FALSE(model->ApplyPreset(nullptr));
  EXPECT_EQ(model->Describe(), fresh->Describe());
  ASSERT_EQ(errors.Texts.size(), 2u);
  EXPECT_NE(errors.Texts[0].find("\"no-such-look\""), std::string::npos);
  for (const std::string& name : names)
  {
    EXPECT_NE(errors.Texts[0].find(name), std::string::npos);
  }
}

TEST(RadialModel, HasPresets)
{
  CheckPresets<vtkGodRaysRadialModel>("default", [](vtkGodRaysRadialModel*, const char*) {});
  EXPECT_GE(vtkGodRaysRadialModel::GetNumberOfPresets(), 6);
}

TEST(PublishedModel, HasAPresetForEachFormulation)
{
  std::set<int> formulations;
  CheckPresets<vtkGodRaysPublishedModel>("mitchell",
    [&](vtkGodRaysPublishedModel* model, const char* name)
    {
      formulations.insert(model->GetFormulation());
      EXPECT_STREQ(model->GetFormulationAsString(), name);
      EXPECT_EQ(model->GetClampMaximum(), 1.0);
    });
  EXPECT_EQ(formulations.size(), vtkGodRaysPublishedModel::ARAUJO + 1u);
}

//------------------------------------------------------------------------------
TEST(PublishedModel, MatchesPublishedNumbers)
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
    vtkNew<vtkGodRaysPublishedModel> model;
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
TEST(PublishedModel, ClampsWhereTheAuthorsDo)
{
  vtkNew<vtkGodRaysPublishedModel> model;
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
TEST(PublishedModel, ScattersNothingWhereItIsClampedToZero)
{
  vtkNew<vtkGodRaysPublishedModel> model;
  model->SetClampMaximum(0.0);
  EXPECT_TRUE(model->CanScatter());
  model->SetFormulation(vtkGodRaysPublishedModel::POSTPROCESSING);
  EXPECT_FALSE(model->CanScatter());
  model->SetClampMaximum(1.0);
  EXPECT_TRUE(model->CanScatter());
  model->SetWeight(0.0);
  EXPECT_FALSE(model->CanScatter());
}

//------------------------------------------------------------------------------
TEST(PublishedModel, ParametersAreClampedAndNeverNaN)
{
  vtkNew<vtkGodRaysPublishedModel> model;
  ErrorListener errors(model);
  for (double value : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    model->SetClampMaximum(value);
    EXPECT_EQ(model->GetClampMaximum(), 1.0);
  }
  ASSERT_EQ(errors.Texts.size(), 3u);
  EXPECT_NE(errors.Texts[0].find("ClampMaximum"), std::string::npos);
  model->SetClampMaximum(-1.0);
  EXPECT_EQ(model->GetClampMaximum(), 0.0);
  model->SetClampMaximum(1e30);
  EXPECT_EQ(model->GetClampMaximum(), 65504.0);

  const vtkMTimeType before = model->GetMTime();
  model->SetFormulation(vtkGodRaysPublishedModel::BABYLON);
  EXPECT_GT(model->GetMTime(), before);
  std::size_t count = errors.Texts.size();
  for (int formulation : { -1, vtkGodRaysPublishedModel::ARAUJO + 1 })
  {
    model->SetFormulation(formulation);
    EXPECT_EQ(model->GetFormulation(), vtkGodRaysPublishedModel::BABYLON);
    EXPECT_EQ(errors.Texts.size(), ++count);
  }
}

//------------------------------------------------------------------------------
TEST(PublishedModel, PrintsEveryParameter)
{
  vtkNew<vtkGodRaysPublishedModel> model;
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
