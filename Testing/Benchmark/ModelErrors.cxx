// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelErrors.h"

#include "Charts.h"
#include "MediumScenes.h"
#include "Report.h"
#include "Rounds.h"
#include "Statistics.h"

#include "vtkGodRaysAutomaticIntegrator.h"
#include "vtkGodRaysDepthWeightedTapsIntegrator.h"
#include "vtkGodRaysEpipolarCoverageIntegrator.h"
#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSingleScattering.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

using GodRaysMediumScenes::Lights;
using GodRaysMediumScenes::NamedLight;
using GodRaysMediumScenes::Scene;

namespace
{
// Three media are three colours of one: optical depths of the far limit ahead of 0.4, 2 and 6.
const double Scattering[3] = { 0.02, 0.1, 0.3 };
const double FarLimit = 20.0;
const double ViewAngle = 60.0;
const double Asymmetries[] = { 0.6, 0.0, 0.85 }; // the last two before the light alone

const std::string CustomaryModel = "radial sum, 100 taps";
const std::string GreyName = ", grey"; // of a time in a medium that dims all colours alike
const char* const BestModel = "automatic, 1/255"; // the default

/// Light of one picture, three colours a pixel.
using Picture = std::vector<float>;

//------------------------------------------------------------------------------
/// What is compared: a line in each table.
struct ModelMethod
{
  std::string Name;
  std::string Series; // of the chart
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  bool IsMedium; // else it is the customary model, times what makes its error least
  double Tolerance = 1.0 / 255.0;
};

std::vector<ModelMethod> MakeModelMethods()
{
  std::vector<ModelMethod> methods;
  const auto add = [&methods](const char* name, const char* series, auto integrator)
  {
    const bool isMedium = integrator->Supports(vtkNew<vtkGodRaysHomogeneousModel>());
    methods.push_back({ name, series, integrator, isMedium, 1.0 / 255.0 });
  };
  add("radial sum", "radial sum", vtkSmartPointer<vtkGodRaysEpipolarIntegrator>::New());
  auto taps = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  taps->SetNumberOfTaps(100);
  add(CustomaryModel.c_str(), "radial sum", taps);
  for (const int count : { 32, 128 })
  {
    auto depths = vtkSmartPointer<vtkGodRaysDepthWeightedTapsIntegrator>::New();
    depths->SetNumberOfTaps(count);
    add(("depth-weighted taps, " + std::to_string(count)).c_str(), "depth-weighted taps", depths);
  }
  for (const int layers : { 0, 1, 2 })
  {
    auto coverage = vtkSmartPointer<vtkGodRaysEpipolarCoverageIntegrator>::New();
    coverage->SetNumberOfLayers(layers);
    const char* const names[] = { "coverage", "coverage, one layer", "coverage, two layers" };
    add(names[layers], "coverage", coverage);
  }
  for (const int steps : { 8, 16, 64, 256 })
  {
    auto shadows = vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New();
    shadows->SetNumberOfSteps(steps);
    add(("shadow map, " + std::to_string(steps) + " steps").c_str(), "shadow map, steps", shadows);
  }
  for (const int size : { 512, 1024, 1536, 3072 })
  {
    auto sweep = vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New();
    sweep->SweepMapOn();
    sweep->SetMapSize(size);
    add(
      ("shadow map, swept, 4 of " + std::to_string(size / 2)).c_str(), "shadow map, swept", sweep);
  }
  auto one = vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New();
  one->SweepMapOn();
  one->SetNumberOfNestedMaps(1);
  add("shadow map, swept, 1 of 1024", "one map, swept", one);
  for (const int share : { 16, 32, 64, 128, 255, 512, 1024 })
  {
    const std::string name = share == 255 ? BestModel : "automatic, 1/" + std::to_string(share);
    add(name.c_str(), "automatic", vtkSmartPointer<vtkGodRaysAutomaticIntegrator>::New());
    methods.back().Tolerance = 1.0 / share;
  }
  return methods;
}

//------------------------------------------------------------------------------
/// A scene, drawn by the pass.
class Stage
{
public:
  Stage(Device& device, const Scene& scene, int width, int height)
    : OpenGL(device)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(scene.Occluders);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 0.0);
    camera->SetFocalPoint(0.0, 0.0, -1.0);
    camera->SetViewAngle(ViewAngle);
    camera->SetClippingRange(0.05, 5000.0);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Medium->SetScatteringCoefficient(Scattering);
    this->Medium->SetFarLimit(FarLimit);
    this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
    this->Rays->AddLight(this->Light);
    device.GetWindow()->SetSize(width, height);
    device.GetWindow()->AddRenderer(this->Renderer);
  }
  ~Stage()
  {
    this->Rays->Detach(this->Renderer);
    this->OpenGL.GetWindow()->RemoveRenderer(this->Renderer);
  }
  Stage(const Stage&) = delete;
  void operator=(const Stage&) = delete;

  void Set(const NamedLight& light, double asymmetry)
  {
    this->Light->SetPosition(light.Direction);
    this->Medium->SetAsymmetry(asymmetry);
  }

  void Set(const ModelMethod& method)
  {
    this->Rays->SetModel(method.IsMedium ? this->Medium.Get() : nullptr);
    this->Rays->SetIntegrator(method.Integrator);
    this->Rays->SetErrorTolerance(method.Tolerance);
    this->Rays->Attach(this->Renderer);
  }

  /// Make the medium one that dims all colours alike, or three.
  void SetColors(bool grey)
  {
    this->Medium->SetScatteringCoefficient(
      Scattering[grey ? 1 : 0], Scattering[1], Scattering[grey ? 1 : 2]);
  }

  /// The time of a frame, to its end [s].
  double Draw()
  {
    return this->OpenGL.Measure([this] { this->OpenGL.GetWindow()->Render(); });
  }
  double DrawWithoutRays()
  {
    this->Rays->Detach(this->Renderer);
    return this->Draw();
  }

  Picture GetLight()
  {
    this->OpenGL.GetWindow()->Render();
    vtkNew<vtkImageData> image;
    if (!this->Rays->GetScatteringImage(image)) // a radial sum of a light that is nowhere near
    {
      const int* size = this->OpenGL.GetWindow()->GetSize();
      return Picture(3 * static_cast<std::size_t>(size[0]) * size[1], 0.0f);
    }
    const auto* values = static_cast<const float*>(image->GetScalarPointer());
    return Picture(values, values + 3 * image->GetNumberOfPoints());
  }

private:
  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkLight> Light;
  vtkNew<vtkGodRaysHomogeneousModel> Medium;
  vtkNew<vtkGodRaysPass> Rays;
};

//------------------------------------------------------------------------------
/// Single scattering. Where an edge is within 1/256 of a pixel from its centre, which is what OpenGL's
/// rasterizers resolve, what is seen there is one thing or the other: there are two truths.
class Truth
{
public:
  Truth(vtkPolyData* occluders, const NamedLight& light, double asymmetry, int width, int height);

  /// Root mean square over the peak, for each colour; of two truths the nearer one counts.
  std::array<double, 3> Compare(const Picture& picture) const;

  Picture Light;
  int PixelsOnEdges = 0;

private:
  Picture Other; // the same where there is one truth
};

Truth::Truth(
  vtkPolyData* occluders, const NamedLight& light, double asymmetry, int width, int height)
  : Light(3 * static_cast<std::size_t>(width) * height)
  , Other(this->Light.size())
{
  vtkGodRaysSingleScattering::Parameters parameters;
  parameters.Forward[2] = -1.0;
  std::copy_n(light.Direction, 3, parameters.Light);
  std::fill_n(parameters.LightColor, 3, vtkMath::Pi());
  parameters.Medium.FarLimit = FarLimit;
  vtkGodRaysMedium::Component& component = parameters.Medium.Components[0];
  std::copy_n(Scattering, 3, component.Scattering);
  component.PhaseFunction = vtkGodRaysMediumModel::HENYEY_GREENSTEIN;
  component.Asymmetry = asymmetry;
  vtkGodRaysSingleScattering exact;
  exact.SetParameters(parameters);
  exact.SetOccluders(occluders);
  const double pixel = 2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle)) / height;
  std::atomic<int> onEdges{ 0 };
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          const double x = (column + 0.5 - 0.5 * width) * pixel;
          const double y = (row + 0.5 - 0.5 * height) * pixel;
          vtkGodRaysSingleScattering::Result ray;
          exact.Evaluate(x, y, ray);
          const std::size_t at = 3 * (static_cast<std::size_t>(row) * width + column);
          std::copy_n(ray.Radiance, 3, this->Light.begin() + at);
          std::copy_n(ray.Radiance, 3, this->Other.begin() + at);
          const double sight = std::min(ray.Sight, FarLimit);
          for (int corner = 0; corner < 4; ++corner)
          {
            const double away = pixel / 256.0;
            const double place[2] = { x + (corner & 1 ? away : -away),
              y + (corner & 2 ? away : -away) };
            const double seen = std::min(exact.FindSight(place[0], place[1]), FarLimit);
            if (std::abs(seen - sight) > 0.01 * sight)
            {
              exact.Evaluate(place[0], place[1], ray);
              std::copy_n(ray.Radiance, 3, this->Other.begin() + at);
              ++onEdges;
              break;
            }
          }
        }
      }
    });
  this->PixelsOnEdges = onEdges;
}

//------------------------------------------------------------------------------
std::array<double, 3> Truth::Compare(const Picture& picture) const
{
  std::array<double, 3> errors;
  for (int c = 0; c < 3; ++c)
  {
    double squares = 0.0;
    double peak = 0.0;
    for (std::size_t i = c; i < picture.size(); i += 3)
    {
      const double value = picture[i];
      squares +=
        std::pow(std::min(std::abs(value - this->Light[i]), std::abs(value - this->Other[i])), 2);
      peak = std::max<double>(peak, this->Light[i]);
    }
    errors[c] = std::sqrt(squares / (picture.size() / 3.0)) / peak;
  }
  return errors;
}

//------------------------------------------------------------------------------
/// For each colour the factor that brings a picture nearest to another.
void Fit(Picture& picture, const Picture& truth)
{
  for (int c = 0; c < 3; ++c)
  {
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = c; i < truth.size(); i += 3)
    {
      product += static_cast<double>(picture[i]) * truth[i];
      square += static_cast<double>(picture[i]) * picture[i];
    }
    for (std::size_t i = c; i < truth.size() && square > 0.0; i += 3)
    {
      picture[i] *= static_cast<float>(product / square);
    }
  }
}

//------------------------------------------------------------------------------
struct Summary
{
  double Squares = 0.0;
  double Worst = 0.0;
  std::string WorstScene;
  int Count = 0;

  void Add(double error, const std::string& scene)
  {
    this->Squares += error * error;
    if (error > this->Worst)
    {
      this->Worst = error;
      this->WorstScene = scene;
    }
    ++this->Count;
  }
  double GetRms() const { return std::sqrt(this->Squares / std::max(this->Count, 1)); }
};

std::string ToText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), number < 0.1 ? "%.4f" : "%.3f", number);
  return text;
}

std::string ToText(const Summary& summary)
{
  return summary.Count ? ToText(summary.GetRms()) + " / " + ToText(summary.Worst) : "-";
}

//------------------------------------------------------------------------------
/// Pictures side by side, each as bright as its largest value makes it, and encoded for a display.
void WriteRow(const std::vector<Picture>& pictures, double white, int width, int height,
  const std::string& file)
{
  const int count = static_cast<int>(pictures.size());
  const int gap = 4;
  vtkNew<vtkImageData> image;
  image->SetDimensions(count * (width + gap) - gap, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(pixels, image->GetNumberOfPoints(), static_cast<unsigned char>(255));
  for (int p = 0; p < count; ++p)
  {
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const double value = pictures[p][3 * (static_cast<std::size_t>(y) * width + x) + 1];
        const double shown = vtkGodRays::EncodeDisplay(std::min(1.0, std::max(0.0, value / white)));
        pixels[static_cast<std::size_t>(y) * image->GetDimensions()[0] + p * (width + gap) + x] =
          static_cast<unsigned char>(std::lround(255.0 * shown));
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
class ModelErrors
{
public:
  ModelErrors(Device& device, const ModelErrorSettings& settings)
    : OpenGL(device)
    , Settings(settings)
    , Methods(MakeModelMethods())
    , Width(settings.Quick ? 160 : 480)
    , Height(settings.Quick ? 90 : 270)
  {
  }

  void Measure()
  {
    for (const Scene& scene : MakeMediumScenes(this->Settings.Quick ? 12 : 24))
    {
      for (const NamedLight& light : Lights)
      {
        if (std::regex_search(scene.Name + "/" + light.Name, std::regex(this->Settings.Filter)))
        {
          this->MeasureCase(scene, light);
        }
      }
    }
    this->MeasureTimes();
  }

  bool Print() const;

  void WritePage() const;

private:
  void MeasureCase(const Scene& scene, const NamedLight& light);
  void MeasureTimes();
  void WritePictures(
    const Scene& scene, const Picture& truth, const std::vector<Picture>& pictures);
  std::string MakeTables() const;

  Device& OpenGL;
  const ModelErrorSettings& Settings;
  std::vector<ModelMethod> Methods;
  int Width;
  int Height;
  int PixelsOnEdges = 0;                                              // of the picture with most
  std::ostringstream Cases;                                           // rows of the long table
  std::map<std::pair<std::string, std::string>, Summary> ByLight;     // method, light; g 0.6
  std::map<std::pair<std::string, std::string>, Summary> ByAsymmetry; // method, g; before the light
  std::map<std::pair<std::string, std::string>, Summary> ByMedium;    // method, scattering; g 0.6
  std::map<std::string, Summary> All;
  std::map<std::string, std::vector<double>> Errors; // of all cases, g 0.6
  std::map<std::string, std::vector<double>> Copies; // of what the rays add to a frame, each round
  std::map<std::string, std::vector<double>> Taps;   // of the same with 100 taps
};

//------------------------------------------------------------------------------
void ModelErrors::MeasureCase(const Scene& scene, const NamedLight& light)
{
  const bool front = &light == &Lights[0];
  // Quickly, those whose errors are not checked have one case.
  const bool isShort =
    this->Settings.Quick && this->Settings.Folder.empty() && !this->Errors.empty();
  Stage stage(this->OpenGL, scene, this->Width, this->Height);
  for (const double asymmetry : Asymmetries)
  {
    if (asymmetry != Asymmetries[0] && (!front || this->Settings.Quick))
    {
      continue;
    }
    stage.Set(light, asymmetry);
    const Truth truth(scene.Occluders, light, asymmetry, this->Width, this->Height);
    this->PixelsOnEdges = std::max(this->PixelsOnEdges, truth.PixelsOnEdges);
    std::vector<Picture> pictures;
    std::ostringstream row;
    row << "| " << scene.Name << " | " << light.Name << " | " << asymmetry;
    for (const ModelMethod& method : this->Methods)
    {
      if (isShort && method.Name != BestModel && method.Name != CustomaryModel)
      {
        row << " | -";
        continue;
      }
      stage.Set(method);
      Picture picture = stage.GetLight();
      if (!method.IsMedium)
      {
        Fit(picture, truth.Light);
      }
      Summary ofCase;
      const auto errors = truth.Compare(picture);
      for (int c = 0; c < 3; ++c)
      {
        ofCase.Add(errors[c], scene.Name);
        if (asymmetry == Asymmetries[0])
        {
          this->ByLight[{ method.Name, light.Name }].Add(errors[c], scene.Name);
          this->ByMedium[{ method.Name, std::to_string(c) }].Add(errors[c], scene.Name);
          this->All[method.Name].Add(errors[c], scene.Name);
          this->Errors[method.Name].push_back(errors[c]);
        }
        if (front)
        {
          this->ByAsymmetry[{ method.Name, std::to_string(asymmetry) }].Add(errors[c], scene.Name);
        }
      }
      row << " | " << ToText(ofCase);
      pictures.push_back(std::move(picture));
    }
    row << " |\n";
    std::printf("%s", row.str().c_str());
    std::fflush(stdout);
    this->Cases << row.str();
    if (front && asymmetry == Asymmetries[0])
    {
      this->WritePictures(scene, truth.Light, pictures);
    }
  }
}

//------------------------------------------------------------------------------
// Truth, the customary model, ours, and four times the differences of both from the truth.
void ModelErrors::WritePictures(
  const Scene& scene, const Picture& truth, const std::vector<Picture>& pictures)
{
  if (this->Settings.Folder.empty())
  {
    return;
  }
  const auto best = std::find_if(this->Methods.begin(), this->Methods.end(),
    [](const ModelMethod& method) { return method.Name == BestModel; });
  const Picture& ours = pictures[best - this->Methods.begin()];
  Picture differences[2] = { pictures[0], ours };
  double white = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    white = std::max<double>(white, i % 3 == 1 ? truth[i] : 0.0);
    for (Picture& difference : differences)
    {
      difference[i] = 4.0f * std::abs(difference[i] - truth[i]);
    }
  }
  std::string name = scene.Name;
  std::replace(name.begin(), name.end(), ' ', '-');
  WriteRow({ truth, pictures[0], ours, differences[0], differences[1] }, white, this->Width,
    this->Height, this->Settings.Folder + "/Gallery/model-error-" + name + ".png");
}

//------------------------------------------------------------------------------
// On the scene whose things hide most of each other, at the size of a film.
void ModelErrors::MeasureTimes()
{
  const int width = this->Settings.Quick ? 160 : 1920;
  const int height = this->Settings.Quick ? 90 : 1080;
  const Scene scene = MakeMediumScenes(12)[4];
  Stage stage(this->OpenGL, scene, width, height);
  stage.Set(Lights[0], Asymmetries[0]);
  this->OpenGL.PrepareUnits(width, height);
  std::vector<RoundsItem> items;
  items.push_back({ "copy", [&] { return this->OpenGL.MeasureCopy(); }, {} });
  items.push_back({ "none", [&] { return stage.DrawWithoutRays(); }, {} });
  for (const ModelMethod& method : this->Methods)
  {
    for (const bool grey : { true, false })
    {
      items.push_back({ method.Name + (grey ? GreyName : ""),
        [&, grey]
        {
          stage.SetColors(grey);
          stage.Set(method);
          stage.Draw(); // what the first frame makes does not count
          return stage.Draw();
        },
        {} });
    }
  }
  MeasureRounds("model error", items, this->Settings.Quick ? 1 : 5);
  const auto copies = GetSeconds(items, "copy");
  const auto none = GetSeconds(items, "none");
  const auto hundred = GetSeconds(items, CustomaryModel + GreyName);
  for (const RoundsItem& item : items)
  {
    for (std::size_t i = 0; i < item.Seconds.size(); ++i)
    {
      this->Copies[item.Name].push_back((item.Seconds[i] - none[i]) / copies[i]);
      this->Taps[item.Name].push_back((item.Seconds[i] - none[i]) / (hundred[i] - none[i]));
    }
  }
}

//------------------------------------------------------------------------------
std::string ModelErrors::MakeTables() const
{
  std::ostringstream text;
  const auto get = [](const auto& map, const std::string& a, const std::string& b)
  {
    const auto found = map.find({ a, b });
    return found == map.end() ? Summary() : found->second;
  };
  text << "| method | all lights | worst scene";
  for (const NamedLight& light : Lights)
  {
    text << " | " << light.Name;
  }
  text << " | copies, grey | of 100 taps | copies, three colours |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    const Summary& all = this->All.at(method.Name);
    text << "| " << method.Name << " | " << ToText(all) << " | " << all.WorstScene;
    for (const NamedLight& light : Lights)
    {
      text << " | " << ToText(get(this->ByLight, method.Name, light.Name));
    }
    char times[64];
    std::snprintf(times, sizeof(times), " | %.3g | %.3g | %.3g |\n",
      Statistics::GetMedian(this->Copies.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Taps.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Copies.at(method.Name)));
    text << times;
  }
  text << "\nThe automatic choice, by tolerance: cases within it, and the error that 95 of 100 "
          "cases keep.\n\n"
          "| tolerance | within | 95 of 100 | all lights | copies, grey | three colours |\n"
          "|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    if (method.Series != "automatic")
    {
      continue;
    }
    std::vector<double> errors = this->Errors.at(method.Name);
    std::sort(errors.begin(), errors.end());
    const auto within = std::count_if(
      errors.begin(), errors.end(), [&](double error) { return error <= method.Tolerance; });
    char row[160];
    std::snprintf(row, sizeof(row), "| 1/%.0f | %d of %d | %.4f | %s | %.3g | %.3g |\n",
      1.0 / method.Tolerance, static_cast<int>(within), static_cast<int>(errors.size()),
      errors[(errors.size() - 1) * 95 / 100], ToText(this->All.at(method.Name)).c_str(),
      Statistics::GetMedian(this->Copies.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Copies.at(method.Name)));
    text << row;
  }
  text << "\n| method | scattering 0.02 | 0.1 | 0.3 | g 0, front | g 0.6, front | g 0.85, front |\n"
          "|---|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    text << "| " << method.Name;
    for (const char* medium : { "0", "1", "2" })
    {
      text << " | " << ToText(get(this->ByMedium, method.Name, medium));
    }
    for (const double asymmetry : { 0.0, 0.6, 0.85 })
    {
      text << " | " << ToText(get(this->ByAsymmetry, method.Name, std::to_string(asymmetry)));
    }
    text << " |\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool ModelErrors::Print() const
{
  std::printf("\n%s\n", this->MakeTables().c_str());
  // The customary sum is the control: it must not pass for single scattering.
  const double bound = 0.03;
  const double ourBound = this->Settings.Quick ? 0.004 : 0.0015;
  const double ours = this->All.at(BestModel).GetRms();
  const double customary = this->All.at(CustomaryModel).GetRms();
  const bool kept = ours < ourBound && customary > bound;
  if (!kept)
  {
    std::printf(
      "the error of %s, %g, should be below %g, and that of the radial sum, %g, above %g\n",
      BestModel, ours, ourBound, customary, bound);
  }
  return kept;
}

//------------------------------------------------------------------------------
void ModelErrors::WritePage() const
{
  const std::string& folder = this->Settings.Folder;
  Chart chart;
  chart.Title = "Model error against cost, 1920 x 1080";
  chart.XTitle = "what the rays add to a frame (full-screen copies)";
  chart.YTitle = "RMSE against single scattering (fraction of the peak)";
  for (const ModelMethod& method : this->Methods)
  {
    if (chart.Series.empty() || chart.Series.back().Name != method.Series)
    {
      chart.Series.push_back({ method.Series, {}, {}, {} });
    }
    chart.Series.back().X.push_back(Statistics::GetMedian(this->Copies.at(method.Name + GreyName)));
    chart.Series.back().Y.push_back(this->All.at(method.Name).GetRms());
    chart.Series.back().Labels.push_back(method.Name);
  }
  std::filesystem::create_directories(folder + "/Charts");
  WriteChart(chart, folder + "/Charts/model-error.png");

  std::ofstream page(folder + "/ModelError.md");
  page
    << "# Model error\n\nWritten by `" << this->Settings.Command << "`.\n\n"
    << "How far pictures are from single scattering, and what they cost. The truth is\n"
       "`vtkGodRaysSingleScatteringReference`; errors are root mean squares over a picture of "
    << this->Width << " x " << this->Height
    << ",\nas fractions of its peak, shown as *root mean square / worst* of the cases: twelve "
       "scenes, three media with\nscattering coefficients of 0.02, 0.1 and 0.3 to a far limit of "
       "20 (optical depths 0.4, 2 and 6), nothing absorbed,\nHenyey-Greenstein with g 0.6 unless "
       "said otherwise. The radial sum, which has no scale of its own, is times what\nmakes its "
       "error least, for each picture and medium; the others are as they come. The cost is what "
       "the rays add to a frame\nof the scene *city* at 1920 x 1080, dimming it included, in "
       "full-screen copies: in a medium that is grey,\nthat against the radial sum with 100 taps, "
       "and "
       "in one that has three colours; medians of five rounds. OpenGL: "
    << this->OpenGL.GetRendererName()
    << ".\n\nWhere an edge is within 1/256 of a pixel from its centre, in up to "
    << this->PixelsOnEdges
    << " pixels of a picture, what is seen\nthere is one thing or the other, and the "
       "nearer truth counts.\n\nWhat exceeds a few thousandths is what a method does not know: the "
       "depth of the "
       "picture has "
       "no roof above a\nwindow and no wall beside it (*windows*, *colonnade*), nor what stands "
       "behind "
       "other things (*canopy*, *lattice*).\nLayers know the latter, shadow maps both; what is "
       "left of "
       "theirs is edges of less than a pixel, and of the map's.\nSteps among leaves (*canopy*) are "
       "no better than their one map: swept, it has the same error.\n\n![Model error against "
       "cost](Charts/model-error.png)\n\n"
    << this->MakeTables() << "\n## Pictures\n\n"
    << "Truth, the radial sum, " << BestModel
    << ", and four times the differences of both from the truth; light in front, "
       "coefficient 0.1.\n\n";
  for (const Scene& scene : MakeMediumScenes(4))
  {
    std::string name = scene.Name;
    std::replace(name.begin(), name.end(), ' ', '-');
    if (std::filesystem::exists(folder + "/Gallery/model-error-" + name + ".png"))
    {
      page << "**" << scene.Name << "**\n\n![" << scene.Name << "](Gallery/model-error-" << name
           << ".png)\n\n";
    }
  }
  page << "## Every case\n\n| scene | light | g";
  for (const ModelMethod& method : this->Methods)
  {
    page << " | " << method.Name;
  }
  page << " |\n|---|---|---";
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    page << "|---";
  }
  page << "|\n" << this->Cases.str();
  page.close();
  SealPage(folder + "/ModelError.md");
}
}

//------------------------------------------------------------------------------
bool MeasureModelErrors(Device& device, const ModelErrorSettings& settings)
{
  ModelErrors errors(device, settings);
  errors.Measure();
  const bool kept = errors.Print();
  if (!settings.Folder.empty())
  {
    errors.WritePage();
  }
  return kept;
}
