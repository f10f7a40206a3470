// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysBlockMeans, of lines or of taps alone, against the exact integral in double precision: on
// random layers, in every hard case of the light, in sweeps; what a steady frame makes; figures.

#include "GodRaysTesting.h"

#include "vtkGodRaysBlockMeans.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysReferenceFilter.h"
#include "vtkGodRaysScatteringFilter.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysTarget.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>

using namespace GodRaysTesting;

namespace
{
using Light = std::array<double, 3>;

enum Method
{
  BLOCKS,
  TAPS
};

void Record(const std::string& name, double value)
{
  std::ostringstream text;
  text << value;
  ::testing::Test::RecordProperty(name, text.str());
  std::cout << name << ": " << text.str() << std::endl;
}

class GodRaysBlockMeans : public ::testing::Test
{
protected:
  Messages VTKMessages;
  vtkNew<vtkRenderWindow> AnyWindow;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNew<vtkGodRaysRadialModel> Model;
  vtkGodRaysBlockMeans Blocks;
  vtkNew<vtkGodRaysTapsIntegrator> Taps;
  vtkNew<vtkImageData> Layer; // one component or three
  vtkGodRaysTarget Target;    // with the layer
  vtkGodRaysSum Result;
  int Size[2] = { 0, 0 }; // of the picture
  double ViewScale = 1.0;
  double Tolerance = 1.0 / 255.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
  vtkGodRaysLight Emitter;
  double Seconds = 0.0; // that the last Integrate() took

  GodRaysBlockMeans()
  {
    this->AnyWindow->SetOffScreenRendering(true);
    this->AnyWindow->SetMultiSamples(0);
    this->AnyWindow->SetSize(16, 16);
    this->AnyWindow->Render();
    this->Window = vtkOpenGLRenderWindow::SafeDownCast(this->AnyWindow);
  }
  ~GodRaysBlockMeans() override
  {
    this->Blocks.Release(this->Window);
    this->Taps->ReleaseGraphicsResources(this->Window);
    this->Target.Release(this->Window);
    this->Result.Release(this->Window);
  }

  /// The picture is as large as the layer unless it is half of it.
  void MakeLayer(int width, int height, int channels, const std::function<double(int, int)>& value,
    bool half = false)
  {
    this->ViewScale = half ? 0.5 : 1.0;
    this->Size[0] = half ? width / 2 : width;
    this->Size[1] = half ? height / 2 : height;
    this->Layer->SetDimensions(width, height, 1);
    this->Layer->AllocateScalars(VTK_FLOAT, channels);
    auto* values = static_cast<float*>(this->Layer->GetScalarPointer());
    for (int i = 0; i < width * height; ++i)
    {
      for (int c = 0; c < channels; ++c)
      {
        const double factors[3] = { 1.0, 0.5, 0.25 };
        values[channels * i + c] = static_cast<float>(factors[c] * value(i % width, i / width));
      }
    }
    const unsigned int format = channels == 1 ? GL_R32F : GL_RGBA32F;
    this->Target.Prepare(this->Window, width, height, { format, 0 });
    this->Target.Write(channels == 1 ? GL_RED : GL_RGB, GL_FLOAT, values);
  }

  void MakeNoise(int width, int height, int channels, std::mt19937& generator, bool half = false)
  {
    this->MakeLayer(
      width, height, channels,
      [&generator](int, int)
      {
        const double uniform = generator() / 4294967296.0;
        return uniform < 0.3 ? 0.0 : uniform;
      },
      half);
  }

  double GetMarchScale(const Light& clip)
  {
    const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
    const double cap = 3.0 * std::hypot(aspect, 1.0) * this->ViewScale;
    return vtkGodRays::MarchScale({ clip[0], clip[1], clip[2] }, aspect, cap);
  }

  vtkGodRaysRadialIntegrator::Request MakeRequest(const Light& clip)
  {
    vtkGodRaysRadialIntegrator::Request request;
    request.Window = this->Window;
    request.Model = this->Model;
    request.Layer = &this->Target;
    std::copy_n(this->Color, 3, this->Emitter.Color);
    std::copy(clip.begin(), clip.end(), this->Emitter.Clip);
    this->Emitter.MarchScale = this->GetMarchScale(clip);
    request.Light = &this->Emitter;
    request.ViewScale = this->ViewScale;
    request.ErrorTolerance = this->Tolerance;
    request.Result = &this->Result;
    return request;
  }

  /// Returns whether the last Integrate() took lines, not taps alone.
  bool TookLines() const { return this->Blocks.Describe().rfind("block means", 0) == 0; }

  vtkSmartPointer<vtkImageData> Integrate(
    const Light& clip, Method method, unsigned int format = GL_RGBA32F)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    vtkOpenGLState* state = this->Window->GetState();
    state->PushFramebufferBindings();
    this->Result.Begin(this->Window, this->Size[0], this->Size[1], format);
    const auto request = this->MakeRequest(clip);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(method == BLOCKS ? this->Blocks.Integrate(request, request.GetMarch())
                                 : this->Taps->Integrate(request));
    glFinish();
    this->Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_TRUE(this->Result.Download(image));
    state->PopFramebufferBindings();
    return image;
  }

  /// The exact answer on the layer, or one to a tolerance of 1e-4.
  vtkSmartPointer<vtkImageData> Evaluate(const Light& clip, bool exact = true)
  {
    vtkNew<vtkGodRaysReferenceFilter> reference;
    vtkNew<vtkGodRaysScatteringFilter> sweep;
    sweep->SetErrorTolerance(1e-4);
    sweep->SetMethod(vtkGodRaysScatteringFilter::SWEEP);
    vtkGodRaysRadialFilter* filter = sweep;
    if (exact)
    {
      filter = reference;
    }
    filter->SetInputData(this->Layer);
    filter->SetDensity(this->Model->GetDensity());
    filter->SetDecay(this->Model->GetDecay());
    filter->SetWeight(this->Model->GetWeight());
    filter->SetExposure(this->Model->GetExposure());
    filter->SetNumberOfSamples(this->Model->GetNumberOfSamples());
    filter->SetLightClip(clip.data());
    filter->SetMarchScale(this->GetMarchScale(clip));
    filter->Update();
    return filter->GetOutput();
  }

  /// Root mean square difference, as a fraction of the reference's largest value in the layer; huge
  /// when there is NaN.
  double GetError(vtkImageData* image, vtkImageData* reference, int channels = 3)
  {
    const int components = reference->GetNumberOfScalarComponents();
    const int* layer = reference->GetDimensions();
    const int origin[2] = { (layer[0] - this->Size[0]) / 2, (layer[1] - this->Size[1]) / 2 };
    double sum = 0.0;
    double peak = 0.0;
    for (int y = 0; y < this->Size[1]; ++y)
    {
      for (int x = 0; x < this->Size[0]; ++x)
      {
        for (int c = 0; c < channels; ++c)
        {
          const double exact = this->GetFactor(components, c) *
            reference->GetScalarComponentAsDouble(
              x + origin[0], y + origin[1], 0, components == 1 ? 0 : c);
          const double error = image->GetScalarComponentAsDouble(x, y, 0, c) - exact;
          sum += std::isfinite(error) ? error * error : 1e30;
          peak = std::max(peak, exact);
        }
      }
    }
    EXPECT_GT(peak, 0.0);
    return std::sqrt(sum / (1.0 * channels * this->Size[0] * this->Size[1])) / peak;
  }
  double GetFactor(int components, int c) { return components == 1 ? this->Color[c] : 1.0; }

  /// Inside, on a pixel's centre, on the edge and just beyond it, outside, far, at infinity, about
  /// w = 0, behind the camera.
  static std::vector<Light> GetLights()
  {
    return { { 0.31, -0.23, 1.0 }, { 2.0 * 40.5 / 96 - 1, 2.0 * 20.5 / 64 - 1, 1.0 },
      { 1.0, 0.13, 1.0 }, { -1.0, -1.0, 1.0 }, { 0.2, 1.02, 1.0 }, { -17.5, 11.9, 7.0 },
      { 20.0, -9.0, 1.0 }, { 64.0, 96.0, 1.0 }, { 2e6, 3e5, 1.0 }, { 1.0, 0.0, 0.0 },
      { 0.0, -1.0, 0.0 }, { 0.8, 0.5, 0.0 }, { 0.8, 0.5, 1e-7 }, { 0.8, 0.5, -1e-7 },
      { 0.8, 0.5, 1e-3 }, { 0.4, 0.3, -0.5 }, { 0.02, -0.1, -1.0 }, { 1.7, 0.3, -1.0 },
      { -1.0, 0.4, -1.0 } };
  }

  int CountObjects()
  {
    int count = 0;
    for (GLuint name = 1; name < 4096; ++name)
    {
      count += glIsTexture(name) + glIsProgram(name) + glIsFramebuffer(name) + glIsBuffer(name) +
        glIsVertexArray(name);
    }
    return count;
  }
};
}

//------------------------------------------------------------------------------
TEST_F(GodRaysBlockMeans, KeepTheToleranceForAnyLight)
{
  std::mt19937 generator(5);
  const std::pair<int, int> sizes[] = { { 96, 64 }, { 40, 28 } }; // lines, taps alone
  for (const auto& size : sizes)
  {
    for (int channels : { 1, 3 })
    {
      this->MakeNoise(size.first, size.second, channels, generator);
      for (double tolerance : { 0.01, 1.0 / 255.0 })
      {
        this->Tolerance = tolerance;
        double worst = 0.0;
        int lines = 0;
        for (const Light& light : this->GetLights())
        {
          auto reference = this->Evaluate(light);
          const double error = this->GetError(this->Integrate(light, BLOCKS), reference);
          const double half = this->GetError(this->Integrate(light, BLOCKS, GL_RGBA16F), reference);
          EXPECT_LE(std::max(error, half), tolerance)
            << light[0] << " " << light[1] << " " << light[2] << ", " << this->Blocks.Describe();
          worst = std::max({ worst, error, half });
          lines += this->TookLines();
        }
        EXPECT_EQ(lines > 0, size.first == 96);
        Record(std::to_string(size.first) + "_pixels_" + std::to_string(channels) +
            "_channels_tolerance_" + std::to_string(tolerance),
          worst);
      }
    }
  }
}

TEST_F(GodRaysBlockMeans, KeepTheToleranceOnRandomLayers)
{
  const char* offset = std::getenv("GODRAYS_SEED");
  const unsigned int seed =
    11u + (offset ? 1000u * static_cast<unsigned int>(std::atoi(offset)) : 0u);
  std::cout << "seed " << seed << "\n";
  std::mt19937 generator(seed);
  const auto uniform = [&generator](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  double worst[2] = { 0.0, 0.0 };
  int counts[2] = { 0, 0 };
  for (int i = 0; i < 120; ++i)
  {
    const int width = 4 * static_cast<int>(uniform(6.0, 25.0)); // half of it is in its middle
    const int height = 4 * static_cast<int>(uniform(6.0, 20.0));
    this->MakeNoise(width, height, i % 2 ? 3 : 1, generator, i % 3 == 0);
    const double tolerances[3] = { 0.02, 1.0 / 255.0, 1.5e-3 };
    this->Tolerance = tolerances[generator() % 3];
    this->Model->SetDensity(i % 4 ? 0.97 : uniform(0.2, 1.2));
    this->Model->SetDecay(i % 5 ? 0.98 : uniform(0.9, 1.03));
    const double distance = std::pow(10.0, uniform(-1.0, i % 7 ? 1.0 : 6.0));
    const double angle = uniform(0.0, 6.283);
    const Light light = { distance * std::cos(angle), distance * std::sin(angle),
      i % 6 ? uniform(-1.0, 1.0) : 0.0 };
    const double error =
      this->GetError(this->Integrate(light, BLOCKS), this->Evaluate(light)) / this->Tolerance;
    EXPECT_LE(error, 1.0) << i << ": " << width << " x " << height << ", "
                          << this->Blocks.Describe() << ", tolerance " << this->Tolerance
                          << ", density " << this->Model->GetDensity() << ", decay "
                          << this->Model->GetDecay() << ", light " << light[0] << " " << light[1]
                          << " " << light[2];
    const bool lines = this->TookLines();
    worst[lines] = std::max(worst[lines], error);
    ++counts[lines];
  }
  Record("Lines_cases", counts[1]);
  Record("Lines_worst_error_of_tolerance", worst[1]);
  Record("Taps_cases", counts[0]);
  Record("Taps_worst_error_of_tolerance", worst[0]);
  EXPECT_GT(std::min(counts[0], counts[1]), 20);
}

TEST_F(GodRaysBlockMeans, MeetTheErrorOfAWrongLight)
{
  std::mt19937 generator(7);
  this->MakeNoise(96, 64, 1, generator);
  auto result = this->Integrate({ 0.31, -0.23, 1.0 }, BLOCKS);
  EXPECT_LE(this->GetError(result, this->Evaluate({ 0.31, -0.23, 1.0 })), this->Tolerance);
  EXPECT_GT(this->GetError(result, this->Evaluate({ 0.36, -0.23, 1.0 })), this->Tolerance);
  EXPECT_GT(this->GetError(result, this->Evaluate({ 0.31, -0.23, -1.0 })), this->Tolerance);
}

TEST_F(GodRaysBlockMeans, OneChannelIsTheSameAsThree)
{
  const auto value = [](int x, int y) { return (x / 7 + y / 5) % 3 ? 0.0 : 1.0; };
  for (const Light& light : this->GetLights())
  {
    this->MakeLayer(96, 64, 3, value);
    auto three = this->Integrate(light, BLOCKS);
    this->MakeLayer(96, 64, 1, value);
    this->Color[1] = 0.5;
    this->Color[2] = 0.25;
    auto one = this->Integrate(light, BLOCKS);
    double largest = 0.0;
    for (int i = 0; i < 64; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(GetValue(one, i, i, c) - GetValue(three, i, i, c)));
      }
    }
    EXPECT_LE(largest, 1e-5) << light[0] << " " << light[1] << " " << light[2];
  }
}

TEST_F(GodRaysBlockMeans, ASweepOfTheLightIsSmooth)
{
  this->MakeLayer(96, 64, 1,
    [](int x, int y) { return std::hypot(x - 40.0, y - 30.0) < 14.0 ? 0.0 : 0.4 + 0.006 * x; });
  const double pi = 3.14159265358979323846;
  double worst = 0.0;
  std::vector<Light> lights;
  for (int i = 0; i <= 48; ++i) // once around, in front of, beside and behind the camera
  {
    const double angle = 2.0 * pi * i / 48.0;
    lights.push_back({ 2.0 * std::sin(angle), 0.3, std::cos(angle) });
  }
  for (double w : { 1e-2, 1e-4, 1e-6, 0.0, -1e-6, -1e-4, -1e-2 })
  {
    lights.push_back({ 0.7, 0.7, w }); // at 45 degrees, where wedges meet
  }
  for (const Light& light : lights)
  {
    const double error = this->GetError(this->Integrate(light, BLOCKS), this->Evaluate(light));
    EXPECT_LE(error, this->Tolerance) << light[0] << " " << light[1] << " " << light[2];
    worst = std::max(worst, error);
  }
  Record("Worst", worst); // a step differs from the exact one by at most twice that
}

// Bars of one pixel that point at a light far away: their shadows do not blur.
TEST_F(GodRaysBlockMeans, KeepBarsThatPointAtTheLight)
{
  this->MakeLayer(960, 540, 1, [](int x, int y) { return x % 7 == 0 || y % 9 == 0 ? 0.0 : 1.0; });
  const Light light = { -21.0, -0.4, 1.0 };
  const double error = this->GetError(this->Integrate(light, BLOCKS), this->Evaluate(light, false));
  Record("Bars", error);
  EXPECT_LE(error, 0.25 * this->Tolerance);
}

TEST_F(GodRaysBlockMeans, ASteadyFrameMakesNothing)
{
  std::mt19937 generator(9);
  this->MakeNoise(96, 64, 1, generator);
  const Light first = { 0.31, -0.23, 1.0 };
  const Light second = { 0.35, -0.20, 1.0 };
  this->Integrate(first, BLOCKS);
  this->Integrate(second, BLOCKS);
  auto once = this->Integrate(first, BLOCKS);
  const int count = this->CountObjects();
  EXPECT_GT(count, 0);
  for (int i = 0; i < 3; ++i)
  {
    this->Integrate(second, BLOCKS);
    auto again = this->Integrate(first, BLOCKS);
    EXPECT_EQ(GetValue(again, 10, 10), GetValue(once, 10, 10));
  }
  EXPECT_EQ(this->CountObjects(), count);
  this->Blocks.Release(this->Window);
  EXPECT_LT(this->CountObjects(), count);
}

TEST_F(GodRaysBlockMeans, KeepTheToleranceInStrips)
{
  const int sizes[][2] = { { 512, 16 }, { 16, 512 }, { 700, 4 } };
  std::mt19937 generator(13);
  int blocks = 0;
  for (const auto& size : sizes)
  {
    this->MakeNoise(size[0], size[1], 1, generator);
    for (const Light& light : this->GetLights())
    {
      EXPECT_LE(
        this->GetError(this->Integrate(light, BLOCKS), this->Evaluate(light)), this->Tolerance)
        << size[0] << " x " << size[1] << ", light " << light[0] << " " << light[1] << " "
        << light[2];
      blocks += this->TookLines();
    }
  }
  EXPECT_GT(blocks, 10); // of 57
}

// Taps along a strip would be as many as the square of its length. Lines across longer ones are more than
// textures of 16,384 pixels hold.
TEST_F(GodRaysBlockMeans, AreTakenInLongStrips)
{
  const int sizes[][2] = { { 7000, 16 }, { 16, 7000 }, { 4096, 48 } };
  this->Model->SetDecay(0.98);
  for (const auto& size : sizes)
  {
    this->MakeLayer(size[0], size[1], 1, [](int, int) { return 1.0; });
    for (const Light& light : this->GetLights())
    {
      this->Integrate(light, BLOCKS);
      EXPECT_TRUE(
        this->TookLines() || this->MakeRequest(light).GetMarch().GetLengthWithin() < 128.0)
        << size[0] << " x " << size[1] << ", light " << light[0] << " " << light[1] << " "
        << light[2];
    }
  }
}

TEST_F(GodRaysBlockMeans, LeaveOtherCasesToTaps)
{
  std::mt19937 generator(9);
  this->MakeNoise(96, 64, 1, generator);
  const Light light = { 0.31, -0.23, 1.0 };
  this->Integrate(light, BLOCKS);
  EXPECT_TRUE(this->TookLines());
  const auto expectTaps = [&]()
  {
    EXPECT_LE(
      this->GetError(this->Integrate(light, BLOCKS), this->Evaluate(light)), this->Tolerance);
    EXPECT_FALSE(this->TookLines());
  };
  this->Model->SetDensity(0.05); // marches of few pixels
  expectTaps();
  this->Model->SetDensity(1.3); // past the light
  expectTaps();
  this->Model->SetDensity(0.97);
  this->Model->SetDecay(0.6); // k = 51
  expectTaps();
  this->Model->SetDecay(0.0); // the pixel itself
  expectTaps();
  this->Model->SetDecay(1.05); // k = -4.9
  this->MakeNoise(31, 40, 1, generator);
  expectTaps();
}

// Error and time against 100 taps; at 1920 x 1080 pixels with:
//   GODRAYS_FIGURES=1080 xvfb-run -a -s "-screen 0 1280x1024x24 -noreset"
//     build/bin/godrays_rendering_tests --gtest_filter='GodRaysBlockMeans.Figures'
TEST_F(GodRaysBlockMeans, Figures)
{
  const char* rows = std::getenv("GODRAYS_FIGURES");
  const int height = rows ? std::max(90, std::atoi(rows)) : 180;
  const int width = 16 * height / 9;
  const auto trunks = [height](int x, int y)
  {
    const double u = static_cast<double>(x) / height;
    const double v = static_cast<double>(y) / height;
    for (double f : { 3.0, 6.3, 13.2, 27.8 })
    {
      const double phase = f * u + 0.3 * std::sin(0.7 * f * v + f);
      if (std::abs(phase - std::floor(phase) - 0.5) < 0.06)
      {
        return 0.0;
      }
    }
    return 0.2 + 0.8 * std::exp(-4.0 * ((u - 0.9) * (u - 0.9) + (v - 0.5) * (v - 0.5)));
  };
  const auto discs = [height](int x, int y)
  {
    const double u = 6.0 * x / height;
    const double v = 6.0 * y / height;
    return std::hypot(u - std::floor(u) - 0.5, v - std::floor(v) - 0.5) < 0.3 ? 0.0 : 1.0;
  };
  const auto clouds = [height](int x, int y)
  {
    double sum = 0.4;
    for (double f = 2.0; f < 70.0; f *= 2.0)
    {
      const double v = f * y / height;
      sum += 0.6 / std::sqrt(f) * std::sin(f * x / height + f + std::sin(v)) * std::cos(1.1 * v);
    }
    return std::min(std::max(sum, 0.0), 1.0);
  };
  const std::pair<const char*, std::function<double(int, int)>> pictures[] = { { "trunks", trunks },
    { "discs", discs }, { "clouds", clouds } };
  const std::pair<const char*, Light> lights[] = { { "inside", { 0.03, 0.05, 1.0 } },
    { "edge", { 0.96, 0.31, 1.0 } }, { "outside", { -2.0, 0.4, 1.0 } },
    { "behind", { 0.3, 0.2, -1.0 } } };
  for (const auto& picture : pictures)
  {
    this->MakeLayer(width, height, 1, picture.second);
    for (const auto& light : lights)
    {
      auto reference = this->Evaluate(light.second, false);
      auto blocks = this->Integrate(light.second, BLOCKS);
      auto taps = this->Integrate(light.second, TAPS);
      std::vector<double> ratios;
      for (int i = 0; i < 3; ++i)
      {
        this->Integrate(light.second, BLOCKS);
        const double seconds = this->Seconds;
        this->Integrate(light.second, TAPS);
        ratios.push_back(this->Seconds / seconds);
      }
      std::sort(ratios.begin(), ratios.end());
      const std::string name = std::string(picture.first) + "_" + light.first;
      const double error = this->GetError(blocks, reference);
      Record(name + "_error", error);
      Record(name + "_error_of_100_taps", this->GetError(taps, reference, 1));
      Record(name + "_times_faster", ratios[1]);
      EXPECT_LE(error, this->Tolerance);
    }
  }
}
