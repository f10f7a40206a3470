// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GodRaysTesting.h"

#include "vtkGodRaysRadialModel.h"

#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTesting.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{
class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Texts.emplace_back(text); }
  std::vector<std::string> Texts;
};
vtkStandardNewMacro(Collector);

vtkSmartPointer<Collector> TheCollector;
vtkSmartPointer<vtkOutputWindow> TheFormerWindow;

vtkSmartPointer<vtkActor> MakeActor(vtkPolyDataAlgorithm* source, std::array<double, 3> color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.data());
  return actor;
}

vtkSmartPointer<vtkImageData> GetPicture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}
}

namespace GodRaysTesting
{
//------------------------------------------------------------------------------
Messages::Messages(bool mayDrawNothing)
  : MayDrawNothing(mayDrawNothing)
{
  TheFormerWindow = vtkOutputWindow::GetInstance();
  TheCollector = vtkSmartPointer<Collector>::New();
  vtkOutputWindow::SetInstance(TheCollector);
}

//------------------------------------------------------------------------------
Messages::~Messages()
{
  for (const std::string& text : this->Take())
  {
    ADD_FAILURE() << "VTK says: " << text;
  }
  vtkOutputWindow::SetInstance(TheFormerWindow);
  TheFormerWindow = nullptr;
  TheCollector = nullptr;
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::Take()
{
  std::vector<std::string> texts;
  texts.swap(TheCollector->Texts);
  const auto isAllowed = [this](const std::string& text)
  {
    return this->MayDrawNothing &&
      (Says(text, "no light reaches the picture") || Says(text, "scatter nothing"));
  };
  texts.erase(std::remove_if(texts.begin(), texts.end(), isAllowed), texts.end());
  return texts;
}

//------------------------------------------------------------------------------
void Messages::Expect(const std::string& words)
{
  const auto texts = this->Take();
  ASSERT_EQ(texts.size(), 1u) << words;
  EXPECT_TRUE(Says(texts.front(), words)) << texts.front();
}

//------------------------------------------------------------------------------
bool Says(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeBox(
  std::array<double, 3> center, std::array<double, 3> size, std::array<double, 3> color)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(center.data());
  cube->SetXLength(size[0]);
  cube->SetYLength(size[1]);
  cube->SetZLength(size[2]);
  return MakeActor(cube, color);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeLamp(
  std::array<double, 3> center, double radius, std::array<double, 3> color)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.data());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  auto actor = MakeActor(sphere, color);
  actor->GetProperty()->LightingOff();
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeSun(std::array<double, 3> towards, std::array<double, 3> color)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(towards.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(color.data());
  return light;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeLamplight(std::array<double, 3> position, std::array<double, 3> color)
{
  auto light = MakeSun(position, color);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  return light;
}

//------------------------------------------------------------------------------
void SetLinear(vtkGodRaysPass* rays)
{
  if (auto* look = vtkGodRaysRadialModel::SafeDownCast(rays->GetModel()))
  {
    look->SetReach(0.0);
    look->SetStreaks(0.0);
  }
}

//------------------------------------------------------------------------------
void AddPlainly(vtkGodRaysPass* rays)
{
  rays->SetAutomaticExposure(false);
  rays->SetHighlightShoulder(false);
  rays->SetDarkenLightBackground(false);
  SetLinear(rays);
}

//------------------------------------------------------------------------------
Stage::Stage(int width, int height)
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetAlphaBitPlanes(true);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.05, 0.08, 0.15);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(40.0);
  camera->SetClippingRange(1.0, 100.0);
  AddPlainly(this->Rays);
  auto* look = vtkGodRaysRadialModel::SafeDownCast(this->Rays->GetModel());
  look->SetDensity(0.97); // a sum whose taps weigh differently
  look->SetDecay(0.98);
  look->SetWeight(0.03);
  // a glow that fills much of the picture
  this->Rays->SetBackgroundGlow(0.5);
  this->Rays->SetBackgroundGlowRadius(2.0);
  this->Rays->SetBackgroundGlowFalloff(25.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> Stage::AddPillarsAndSun()
{
  for (int i = -3; i <= 3; ++i)
  {
    this->Renderer->AddActor(MakeBox({ 1.2 * i, 0.0, 0.0 }, { 0.5, 4.0, 0.5 }));
  }
  auto sun = MakeSun({ 0.3, 0.2, -1.0 }, { 1.0, 0.9, 0.7 });
  this->Renderer->AddLight(sun);
  this->Rays->AddLight(sun);
  this->Rays->Attach(this->Renderer);
  return sun;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> GetPixels(vtkRenderWindow* window, bool render)
{
  if (render)
  {
    window->Render();
  }
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> data;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, data); // as it is shown
  const unsigned char* first = data->GetPointer(0);
  return { first, first + data->GetNumberOfValues() };
}

//------------------------------------------------------------------------------
std::vector<float> GetDepths(vtkRenderWindow* window, bool render)
{
  if (render)
  {
    window->Render();
  }
  const int* size = window->GetSize();
  vtkNew<vtkFloatArray> data;
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, data);
  const float* first = data->GetPointer(0);
  return { first, first + data->GetNumberOfValues() };
}

//------------------------------------------------------------------------------
int GetLargestDifference(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int channels)
{
  EXPECT_EQ(a.size(), b.size());
  int largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    if (static_cast<int>(i % 4) < channels)
    {
      largest = std::max(largest, std::abs(a[i] - b[i]));
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
int CountDifferentPixels(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int levels)
{
  EXPECT_EQ(a.size(), b.size());
  int count = 0;
  for (std::size_t i = 0; i + 3 < std::min(a.size(), b.size()); i += 4)
  {
    count += std::abs(a[i] - b[i]) > levels || std::abs(a[i + 1] - b[i + 1]) > levels ||
      std::abs(a[i + 2] - b[i + 2]) > levels;
  }
  return count;
}

//------------------------------------------------------------------------------
double GetValue(vtkImageData* image, int x, int y, int channel)
{
  const int* size = image->GetDimensions();
  if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return 0.0;
  }
  return image->GetScalarComponentAsDouble(x, y, 0, channel);
}

//------------------------------------------------------------------------------
double GetMean(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  double sum = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum += GetValue(image, x, y, c);
      }
    }
  }
  return sum / (3.0 * size[0] * size[1]);
}

//------------------------------------------------------------------------------
std::array<double, 3> GetClip(vtkRenderer* renderer, std::array<double, 4> world)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double forward[3];
  double right[3];
  double up[3];
  camera->GetDirectionOfProjection(forward);
  vtkMath::Cross(forward, camera->GetViewUp(), right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);
  double relative[3];
  for (int i = 0; i < 3; ++i)
  {
    relative[i] = world[i] - world[3] * camera->GetPosition()[i];
  }
  const double x = vtkMath::Dot(relative, right);
  const double y = vtkMath::Dot(relative, up);
  const double z = vtkMath::Dot(relative, forward);
  const double aspect = renderer->GetTiledAspectRatio();
  if (camera->GetParallelProjection())
  {
    const double scale = camera->GetParallelScale();
    return { x / (scale * aspect), y / scale, world[3] };
  }
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return { x / (tangent * aspect), y / tangent, z };
}

//------------------------------------------------------------------------------
void SumTaps(vtkGodRaysPass* rays)
{
  rays->SetIntegrator(vtkSmartPointer<vtkGodRaysTapsIntegrator>::New());
}

//------------------------------------------------------------------------------
namespace
{
/// Differences between the light of the last frame and the model's sum of taps, of the peak.
struct Error
{
  double RootMeanSquare = 1e30;
  double Largest = 1e30;
};

Error GetError(vtkGodRaysPass* rays, vtkRenderer* renderer, std::array<double, 3> clip, int taps)
{
  auto model = vtkGodRaysRadialSumModel::SafeDownCast(rays->GetModel());
  vtkNew<vtkImageData> layer;
  vtkNew<vtkImageData> result;
  vtkNew<vtkImageData> reference;
  if (!model || !rays->GetOcclusionImage(layer) || !rays->GetScatteringImage(result))
  {
    ADD_FAILURE() << "no rays: " << rays->GetPlan();
    return {};
  }
  const double viewScale = 1.0 / (1.0 + 2.0 * rays->GetLayerMargin());
  clip[0] *= viewScale;
  clip[1] *= viewScale;
  const double aspect = renderer->GetTiledAspectRatio();
  const double cap = model->CapsMarch() ? 3.0 * std::hypot(aspect, 1.0) * viewScale : 1e300;
  const double reach = std::hypot(clip[0] * aspect, clip[1]);
  double distance = clip[2];
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection() && distance == 0.0 && rays->GetLight(0))
  {
    // a sun, whose march is that of a perspective view of 30 degrees
    vtkLight* sun = rays->GetLight(0);
    double towards[3];
    vtkMath::Subtract(sun->GetTransformedPosition(), sun->GetTransformedFocalPoint(), towards);
    const double angle = vtkMath::AngleBetweenVectors(towards, camera->GetDirectionOfProjection());
    const double tangent = std::tan(vtkMath::RadiansFromDegrees(15.0));
    distance = reach / viewScale * tangent / std::tan(angle); // clip may be of any length
  }
  const double scale = cap / std::max(reach, cap * std::abs(distance));
  const int* size = result->GetDimensions();
  const int outputSize[2] = { size[0], size[1] };
  EXPECT_TRUE(model->Evaluate(layer, clip.data(), scale, viewScale, outputSize, reference, taps));
  double peak = 0.0;
  double worst = 0.0;
  double squares = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double expected = GetValue(reference, x, y, c);
        peak = std::max(peak, std::abs(expected));
        const double error = std::abs(expected - GetValue(result, x, y, c));
        worst = std::max(worst, std::isfinite(error) ? error : 1e30);
        squares += error * error;
      }
    }
  }
  EXPECT_GT(peak, 0.0) << "the reference has no light at all: " << rays->GetPlan();
  return { std::sqrt(squares / (3.0 * size[0] * size[1])) / peak, worst / peak };
}
}

double GetErrorOfScattering(vtkGodRaysPass* rays, vtkRenderer* renderer, std::array<double, 3> clip)
{
  return GetError(rays, renderer, clip, 0).Largest;
}

//------------------------------------------------------------------------------
double GetErrorOfLimit(vtkGodRaysPass* rays, vtkRenderer* renderer, std::array<double, 3> clip)
{
  return GetError(rays, renderer, clip, 1024).RootMeanSquare;
}

//------------------------------------------------------------------------------
void ForEachLight(
  Stage& scene, const std::function<void(const std::string&, std::array<double, 4>)>& visit)
{
  vtkGodRaysPass* rays = scene.Rays;
  auto sun = scene.AddPillarsAndSun();
  visit("sun", { 0.3, 0.2, -1.0, 0.0 });

  rays->SetLayerMargin(0.25);
  visit("sun_margin", { 0.3, 0.2, -1.0, 0.0 });
  rays->SetLayerMargin(0.0);

  sun->SetPosition(0.6, 0.3, -1.0);
  visit("sun_off_screen", { 0.6, 0.3, -1.0, 0.0 });
  sun->SetPosition(1.0, 0.1, 0.05); // just behind the camera, glowing from the side
  rays->SetBackgroundGlowFalloff(120.0);
  visit("sun_behind", { 1.0, 0.1, 0.05, 0.0 });
  rays->SetBackgroundGlowFalloff(25.0);

  rays->RemoveAllLights();
  auto lamp = MakeLamplight({ 0.6, 0.4, -3.0 });
  rays->AddLight(lamp);
  rays->SetSourceRadius(0.5);
  visit("light", { 0.6, 0.4, -3.0, 1.0 });
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(3.0);
  visit("light_parallel", { 0.6, 0.4, -3.0, 1.0 });
  rays->RemoveAllLights();
  rays->AddLight(sun);
  sun->SetPosition(0.1, 0.05, -1.0);
  visit("sun_parallel", { 0.1, 0.05, -1.0, 0.0 });
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();

  rays->RemoveAllLights();
  auto prop = MakeLamp({ -0.7, -0.4, -2.0 }, 0.5, { 1.0, 0.8, 0.4 });
  vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::LIGHT);
  scene.Renderer->AddActor(prop);
  visit("lamp", { -0.7, -0.4, -2.0, 1.0 });
  rays->SetLayerMargin(0.25);
  visit("lamp_margin", { -0.7, -0.4, -2.0, 1.0 });
}

//------------------------------------------------------------------------------
bool IsLikeBaseline(vtkRenderWindow* window, const std::string& name, int levels, bool quiet)
{
  const std::string file = std::string(GODRAYS_BASELINE_DIR) + "/" + name + ".png";
  const std::string got = std::string(GODRAYS_TEMPORARY_DIR) + "/" + name + ".png";
  vtkSmartPointer<vtkImageData> picture = GetPicture(window);
  const auto write = [&]
  {
    vtksys::SystemTools::MakeDirectory(GODRAYS_TEMPORARY_DIR);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(picture);
    writer->SetFileName(got.c_str());
    writer->Write();
  };
  if (!vtksys::SystemTools::FileExists(file))
  {
    write();
    ADD_FAILURE() << "There is no baseline " << name << ".png. Look at " << got
                  << " and, if it is right, copy it to Testing/Baseline.";
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* baseline = reader->GetOutput();
  bool alike =
    std::equal(baseline->GetDimensions(), baseline->GetDimensions() + 3, picture->GetDimensions());
  int worst = 255;
  if (alike)
  {
    const auto a = static_cast<const unsigned char*>(baseline->GetScalarPointer());
    const auto b = static_cast<const unsigned char*>(picture->GetScalarPointer());
    const vtkIdType count = baseline->GetNumberOfPoints() * 3;
    worst = 0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    alike = worst <= levels;
  }
  if (!quiet)
  {
    if (!alike)
    {
      write();
      ADD_FAILURE() << name << " differs from its baseline by " << worst << " levels, more than "
                    << levels << "; see " << got;
    }
    // VTK's own regression test, of which the comparison above is the stricter one
    vtkNew<vtkTesting> testing;
    testing->AddArgument("-V");
    testing->AddArgument(file.c_str());
    testing->AddArgument("-T");
    testing->AddArgument(GODRAYS_TEMPORARY_DIR);
    testing->SetRenderWindow(window);
    EXPECT_EQ(testing->RegressionTest(0.15), vtkTesting::PASSED) << name;
  }
  return alike;
}

//------------------------------------------------------------------------------
double GetErrorOfSum(const std::vector<unsigned char>& with,
  const std::vector<unsigned char>& without, int width, vtkImageData* light, int x, int y)
{
  // IEC 61966-2-1, written once more: tests share no formula with the pass
  const auto decode = [](double shown)
  { return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4); };
  const auto encode = [](double linear)
  { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055; };
  EXPECT_EQ(with.size(), without.size());
  double worst = 0.0;
  for (int row = 0; row < light->GetDimensions()[1]; ++row)
  {
    for (int column = 0; column < light->GetDimensions()[0]; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t i = 4 * (static_cast<std::size_t>(y + row) * width + x + column) +
          static_cast<std::size_t>(c);
        const double sum = decode(without.at(i) / 255.0) + GetValue(light, column, row, c);
        worst = std::max(worst, std::abs(255.0 * std::min(1.0, encode(sum)) - with.at(i)));
      }
    }
  }
  return worst;
}
}
