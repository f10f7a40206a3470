// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysTapsIntegrator: the sum on the graphics card against the same sum in double precision,
// for every formulation, on noise and in whole scenes; numbers of taps.
// Every figure is printed and recorded as a property of its test.

#include "GodRaysTesting.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysPresets.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysTarget.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

using namespace GodRaysTesting;

namespace
{
void Record(const std::string& name, double value)
{
  std::ostringstream text;
  text << value;
  ::testing::Test::RecordProperty(name, text.str());
  std::cout << name << ": " << text.str() << "\n";
}

/// Software OpenGL interpolates a texture with 32-bit weights, a graphics card with 8-bit ones: it
/// is off by up to 1/512 of the difference of two neighbours, at every tap.
bool InterpolatesExactly(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  return capabilities.find("llvmpipe") != std::string::npos ||
    capabilities.find("softpipe") != std::string::npos;
}

double GetPeak(vtkImageData* image)
{
  double range[2];
  double peak = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    image->GetPointData()->GetScalars()->GetRange(range, c);
    peak = std::max({ peak, std::abs(range[0]), std::abs(range[1]) });
  }
  return peak;
}

/// Largest difference of two images, of a peak.
double GetError(vtkImageData* result, vtkImageData* reference, double peak)
{
  const int* size = reference->GetDimensions();
  double worst = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double difference =
          std::abs(GetValue(result, x, y, c) - GetValue(reference, x, y, c));
        worst = std::max(worst, std::isfinite(difference) ? difference : 1e30);
      }
    }
  }
  EXPECT_GT(peak, 0.0);
  return worst / peak;
}

double GetRMSDifference(vtkImageData* a, vtkImageData* b, double& largest)
{
  const int* size = a->GetDimensions();
  double sum = 0.0;
  largest = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double difference = GetValue(a, x, y, c) - GetValue(b, x, y, c);
        sum += difference * difference;
        largest = std::max(largest, std::abs(difference));
      }
    }
  }
  return std::sqrt(sum / (3.0 * size[0] * size[1]));
}

/// Among the formulations: the sum of a vtkGodRaysRadialModel.
constexpr int OurSum = -1;

/// A layer of noise and the integrator on it, without a scene.
class GodRaysTapsOnNoise : public ::testing::Test
{
protected:
  Messages VTKMessages;
  vtkNew<vtkRenderWindow> AnyWindow;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNew<vtkGodRaysRadialModel> Ours;
  vtkNew<vtkGodRaysPublishedModel> Published;
  vtkGodRaysRadialSumModel* Model = this->Ours;
  vtkNew<vtkGodRaysTapsIntegrator> Integrator;
  vtkNew<vtkImageData> Layer;
  vtkGodRaysTarget Target; // with the layer
  vtkGodRaysSum Result;
  double ViewScale = 1.0;

  GodRaysTapsOnNoise()
  {
    this->AnyWindow->SetOffScreenRendering(true);
    this->AnyWindow->SetMultiSamples(0);
    this->AnyWindow->SetSize(16, 16);
    this->AnyWindow->Render();
    this->Window = vtkOpenGLRenderWindow::SafeDownCast(this->AnyWindow);
  }
  ~GodRaysTapsOnNoise() override
  {
    this->Integrator->ReleaseGraphicsResources(this->Window);
    this->Target.Release(this->Window);
    this->Result.Release(this->Window);
  }

  void MakeLayer(int width, int height)
  {
    std::mt19937 generator(3);
    this->Layer->SetDimensions(width, height, 1);
    this->Layer->AllocateScalars(VTK_FLOAT, 3);
    auto* values = static_cast<float*>(this->Layer->GetScalarPointer());
    std::vector<float> rgba;
    for (int i = 0; i < width * height; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        values[3 * i + c] = static_cast<float>(generator() / 4294967296.0);
        rgba.push_back(values[3 * i + c]);
      }
      rgba.push_back(1.0f);
    }
    this->Target.Prepare(this->Window, width, height, { GL_RGBA32F, 0 });
    this->Target.Write(GL_RGBA, GL_FLOAT, rgba.data());
  }

  double GetMarchScale(const std::array<double, 3>& clip)
  {
    const double aspect = 64.0 / 48.0;
    const double cap = this->Model->CapsMarch() ? 3.0 * std::hypot(aspect, 1.0) * this->ViewScale
                                                : std::numeric_limits<float>::max();
    return vtkGodRays::MarchScale({ clip[0], clip[1], clip[2] }, aspect, cap);
  }

  void Integrate(const std::array<double, 3>& clip, unsigned int format, vtkImageData* result)
  {
    vtkOpenGLState* state = this->Window->GetState();
    state->PushFramebufferBindings();
    this->Result.Begin(this->Window, 64, 48, format);
    vtkGodRaysRadialIntegrator::Request request;
    request.Window = this->Window;
    request.Model = this->Model;
    request.Layer = &this->Target;
    vtkGodRaysLight light;
    std::copy(clip.begin(), clip.end(), light.Clip);
    light.MarchScale = this->GetMarchScale(clip);
    request.Light = &light;
    request.ViewScale = this->ViewScale;
    request.ErrorTolerance = 1.0 / 255.0;
    request.Result = &this->Result;
    EXPECT_TRUE(this->Integrator->Integrate(request));
    EXPECT_TRUE(this->Result.Download(result));
    state->PopFramebufferBindings();
  }

  void Evaluate(const std::array<double, 3>& clip, vtkImageData* reference)
  {
    const int size[2] = { 64, 48 };
    ASSERT_TRUE(this->Model->Evaluate(this->Layer, clip.data(), this->GetMarchScale(clip),
      this->ViewScale, size, reference, this->Integrator->GetNumberOfTaps()));
  }

  /// Of the peak before it is clamped: clamping makes no sum more exact.
  double GetErrorAt(const std::array<double, 3>& clip, unsigned int format = GL_RGBA32F)
  {
    vtkNew<vtkImageData> result;
    vtkNew<vtkImageData> reference;
    vtkNew<vtkImageData> notClamped;
    this->Integrate(clip, format, result);
    this->Evaluate(clip, reference);
    const double maximum = this->Published->GetClampMaximum();
    this->Published->SetClampMaximum(65504.0);
    this->Evaluate(clip, notClamped);
    this->Published->SetClampMaximum(maximum);
    return GetError(result, reference, GetPeak(notClamped));
  }

  std::vector<std::array<double, 3>> GetLights()
  {
    std::vector<std::array<double, 3>> lights = {
      { 0.31, -0.23, 1.0 },                              // inside
      { 2.0 * 20.5 / 64 - 1, 2.0 * 30.5 / 48 - 1, 1.0 }, // on a pixel's centre
      { 1.0, 0.13, 1.0 },                                // on the edge
      { -17.5, 11.9, 7.0 },                              // outside
    };
    if (this->Model->CapsMarch())
    {
      lights.push_back({ 40.0, -9.0, 1.0 }); // beyond the cap
      lights.push_back({ 0.8, 0.5, 1e-7 });  // at a right angle to the view
      lights.push_back({ 0.4, 0.3, -0.5 });  // behind the camera
    }
    return lights;
  }

  const char* GetFormulation()
  {
    return this->Model == this->Ours.Get() ? "invariant"
                                           : this->Published->GetFormulationAsString();
  }

  /// Take a published formulation with its authors' numbers, or our sum.
  void SetFormulation(int formulation)
  {
    this->Model = this->Ours;
    if (formulation != OurSum)
    {
      this->Model = this->Published;
      const char* name = vtkGodRaysPublishedModel::GetPresetName(formulation);
      ASSERT_TRUE(this->Published->ApplyPreset(name));
      ASSERT_EQ(this->Published->GetFormulation(), formulation);
    }
    this->Published->SetClampMaximum(0.5); // in reach
  }
};
}

//------------------------------------------------------------------------------
TEST_F(GodRaysTapsOnNoise, EqualTheSumInDoublePrecision)
{
  const double bound = InterpolatesExactly(this->Window) ? 2e-6 : 4e-3;
  this->MakeLayer(24, 18); // a position in more pixels has fewer bits between them
  for (bool margin : { false, true })
  {
    this->ViewScale = margin ? 0.5 : 1.0;
    for (int i = OurSum; i <= vtkGodRaysPublishedModel::ARAUJO; ++i)
    {
      this->SetFormulation(i);
      double worst = 0.0;
      double worstOfHalf = 0.0;
      for (std::array<double, 3> light : this->GetLights())
      {
        light[0] *= this->ViewScale;
        light[1] *= this->ViewScale;
        const double error = this->GetErrorAt(light);
        EXPECT_LE(error, bound) << this->GetFormulation() << ", light " << light[0];
        worst = std::max(worst, error);
        const double half = this->GetErrorAt(light, GL_RGBA16F);
        EXPECT_LE(half, 2e-3) << this->GetFormulation() << ", light " << light[0];
        worstOfHalf = std::max(worstOfHalf, half);
      }
      const std::string name = this->GetFormulation() + std::string(margin ? "_margin" : "");
      Record("Single_" + name, worst);
      Record("Half_" + name, worstOfHalf);
    }
  }
}

TEST_F(GodRaysTapsOnNoise, DifferWhenAParameterDiffersSlightly)
{
  this->MakeLayer(64, 48);
  const std::array<double, 3> light = { 0.31, -0.23, 1.0 };
  for (int i = OurSum; i <= vtkGodRaysPublishedModel::ARAUJO; ++i)
  {
    this->SetFormulation(i);
    this->Published->SetClampMaximum(1e4);
    vtkNew<vtkImageData> result;
    vtkNew<vtkImageData> reference;
    this->Integrate(light, GL_RGBA32F, result);
    if (i == vtkGodRaysPublishedModel::THREE_JS)
    {
      this->Model->SetExposure(this->Model->GetExposure() * 1.0001);
    }
    else
    {
      this->Model->SetDecay(this->Model->GetDecay() * 1.0001);
    }
    this->Evaluate(light, reference);
    EXPECT_GT(GetError(result, reference, GetPeak(reference)), 2e-5) << this->GetFormulation();
  }
}

TEST_F(GodRaysTapsOnNoise, AddToWhatOtherLightsScattered)
{
  this->MakeLayer(64, 48);
  vtkNew<vtkImageData> once;
  vtkNew<vtkImageData> twice;
  const std::array<double, 3> clip = { 0.31, -0.23, 1.0 };
  this->Integrate(clip, GL_RGBA32F, once);
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  vtkGodRaysRadialIntegrator::Request request;
  request.Window = this->Window;
  request.Model = this->Model;
  request.Layer = &this->Target;
  vtkGodRaysLight light;
  std::copy(clip.begin(), clip.end(), light.Clip);
  request.Light = &light;
  request.ViewScale = 1.0;
  request.ErrorTolerance = 1.0 / 255.0;
  request.Result = &this->Result;
  EXPECT_TRUE(this->Integrator->Integrate(request));
  EXPECT_TRUE(this->Result.Download(twice));
  state->PopFramebufferBindings();
  for (int i = 0; i < 48; ++i)
  {
    EXPECT_FLOAT_EQ(GetValue(twice, i, i), 2.0 * GetValue(once, i, i));
  }
}

TEST_F(GodRaysTapsOnNoise, TakeTheTapsThatAreAskedFor)
{
  // a single tap is not helped by others' rounding; of 1000 the weights are products of 1000 factors
  const double bound = InterpolatesExactly(this->Window) ? 1e-5 : 4e-3;
  this->MakeLayer(64, 48);
  for (int taps : { 1, 7, 64, 1000 })
  {
    this->Integrator->SetNumberOfTaps(taps);
    const double error = this->GetErrorAt({ 0.31, -0.23, 1.0 });
    Record("Single_invariant_" + std::to_string(taps) + "_taps", error);
    EXPECT_LE(error, bound) << taps;
  }
}

TEST_F(GodRaysTapsOnNoise, SeveralPassesEqualOneForParallelShafts)
{
  this->MakeLayer(64, 48);
  this->Model->SetDecay(0.95);
  // 64 taps, a pixel apart in x, so that a repeated interpolation changes nothing
  const std::array<double, 3> light = { 1.0, 0.0, 0.0 };
  const double scale = this->GetMarchScale(light);
  this->Model->SetDensity(1.0 / (0.5 * scale));
  ASSERT_NEAR(this->Model->GetDensity() * 0.5 * scale, 1.0, 1e-12) << "the cap is too low";
  this->Integrator->SetNumberOfTaps(64);
  vtkNew<vtkImageData> one;
  this->Integrate(light, GL_RGBA32F, one);
  const double peak = GetPeak(one);
  for (int passes : { 2, 3 })
  {
    this->Integrator->SetNumberOfPasses(passes);
    vtkNew<vtkImageData> several;
    this->Integrate(light, GL_RGBA32F, several);
    const double error = GetError(several, one, peak);
    Record("Parallel_" + std::to_string(passes) + "_passes", error);
    EXPECT_LE(error, 1e-5) << passes;
    EXPECT_EQ(this->Integrator->Describe(this->Model),
      passes == 2 ? "taps: 8 + 8 a pixel" : "taps: 4 + 4 + 4 a pixel");
  }

  // and differ where shafts meet: a shortcut
  vtkNew<vtkImageData> several;
  const std::array<double, 3> inside = { 0.31, -0.23, 1.0 };
  this->Integrate(inside, GL_RGBA32F, several);
  this->Integrator->SetNumberOfPasses(1);
  this->Integrate(inside, GL_RGBA32F, one);
  EXPECT_GT(GetError(several, one, GetPeak(one)), 1e-2);

  // the passes of the authors stay
  this->SetFormulation(vtkGodRaysPublishedModel::MITCHELL);
  const std::string published = this->Integrator->Describe(this->Model);
  this->Integrator->SetNumberOfPasses(3);
  this->Integrator->JitterOn();
  EXPECT_EQ(this->Integrator->Describe(this->Model), published);
}

TEST_F(GodRaysTapsOnNoise, JitterIsGrainAboutTheSameMean)
{
  // a smooth layer: the grain of taps so few is large, its mean over 4 by 4 pixels is not
  this->MakeLayer(64, 48);
  std::vector<float> rgba;
  for (int y = 0; y < 48; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const double wave = std::sin(0.35 * x + 0.2 * y);
      rgba.insert(rgba.end(), 4, static_cast<float>(0.5 + 0.5 * wave));
    }
  }
  this->Target.Write(GL_RGBA, GL_FLOAT, rgba.data());
  this->Model->SetDensity(0.25);
  const std::array<double, 3> light = { 0.31, -0.23, 1.0 };
  this->Integrator->SetNumberOfTaps(4);
  vtkNew<vtkImageData> plain;
  this->Integrate(light, GL_RGBA32F, plain);
  this->Integrator->JitterOn();
  vtkNew<vtkImageData> jittered;
  this->Integrate(light, GL_RGBA32F, jittered);
  EXPECT_EQ(this->Integrator->Describe(this->Model), "taps: 4 a pixel, jittered");

  const double peak = GetPeak(plain);
  double grain = 0.0;
  double worst = 0.0;
  for (int y = 0; y < 48; y += 4)
  {
    for (int x = 0; x < 64; x += 4)
    {
      double difference = 0.0;
      for (int i = 0; i < 16; ++i)
      {
        const double one =
          GetValue(jittered, x + i % 4, y + i / 4) - GetValue(plain, x + i % 4, y + i / 4);
        difference += one / 16;
        grain = std::max(grain, std::abs(one) / peak);
      }
      worst = std::max(worst, std::abs(difference) / peak);
    }
  }
  Record("Jitter_grain", grain);
  Record("Jitter_mean_of_tile", worst);
  EXPECT_GT(grain, 0.02) << "nothing is moved";
  EXPECT_LT(worst, 0.02) << "the mean of a tile is moved";
}

//------------------------------------------------------------------------------
// Whole scenes

namespace
{
class GodRaysTapsInScenes : public ::testing::Test
{
protected:
  Messages VTKMessages;
  Stage Scene;
  vtkGodRaysPass* Rays = Scene.Rays;

  GodRaysTapsInScenes() { SumTaps(this->Rays); }

  vtkSmartPointer<vtkImageData> GetScattering()
  {
    this->Scene.Window->Render();
    auto image = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Rays->GetScatteringImage(image)) << this->Rays->GetPlan();
    return image;
  }

  /// The errors with 16 and 32 bits of a light at a world position or in a direction.
  void ExpectAccurate(const std::string& name, std::array<double, 4> world)
  {
    const bool exact = InterpolatesExactly(this->Scene.Window);
    const auto clip = GetClip(this->Scene.Renderer, world);
    for (int precision : { vtkGodRaysPass::HALF, vtkGodRaysPass::SINGLE })
    {
      const bool single = precision == vtkGodRaysPass::SINGLE;
      this->Rays->SetPrecision(precision);
      this->Scene.Window->Render();
      const double error = GetErrorOfScattering(this->Rays, this->Scene.Renderer, clip);
      Record((single ? "Single_" : "Half_") + name, error);
      EXPECT_LE(error, single && exact ? 1e-5 : 2e-3) << name;
    }
  }
};
}

TEST_F(GodRaysTapsInScenes, EqualTheSumInDoublePrecision)
{
  ForEachLight(this->Scene,
    [this](const std::string& name, std::array<double, 4> world)
    { this->ExpectAccurate(name, world); });
}

TEST_F(GodRaysTapsInScenes, PublishedFormulationsAreExactInScenesToo)
{
  this->Scene.AddPillarsAndSun();
  this->Rays->SetLayerMargin(0.25);
  for (int i = 0; i < vtkGodRaysPresets::GetNumberOfPresets(); ++i)
  {
    const char* name = vtkGodRaysPresets::GetPresetName(i);
    ASSERT_TRUE(this->Rays->ApplyPreset(name));
    SetLinear(this->Rays);
    if (!vtkGodRaysRadialSumModel::SafeDownCast(this->Rays->GetModel()))
    {
      continue; // a medium
    }
    this->ExpectAccurate(name, { 0.3, 0.2, -1.0, 0.0 });
  }
}

TEST_F(GodRaysTapsInScenes, BrightnessDoesNotDependOnTheNumberOfTapsAndTheyConverge)
{
  this->Scene.AddPillarsAndSun();
  this->Rays->SetSunAngularRadius(3.0);
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  auto integrator = vtkGodRaysTapsIntegrator::SafeDownCast(this->Rays->GetIntegrator());
  integrator->SetNumberOfTaps(2048);
  auto limit = this->GetScattering();
  const double peak = vtkGodRaysRadialModel::SafeDownCast(this->Rays->GetModel())
                        ->GetFlatGain(); // the light's peak is 1
  double former = 1e30;
  for (int taps : { 16, 32, 64, 128, 256, 512 })
  {
    integrator->SetNumberOfTaps(taps);
    auto image = this->GetScattering();
    const double brightness = GetMean(image) / GetMean(limit);
    double largest = 0.0;
    const double error = GetRMSDifference(image, limit, largest) / peak;
    Record("Brightness_" + std::to_string(taps) + "_taps", brightness);
    Record("RMS_" + std::to_string(taps) + "_taps", error);
    EXPECT_NEAR(brightness, 1.0, 0.01) << taps;
    EXPECT_LT(error, 0.7 * former) << taps;
    former = error;
  }
}
