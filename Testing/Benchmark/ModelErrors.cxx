// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelErrors.h"

#include "ModelReport.h"
#include "ModelScene.h"
#include "Rounds.h"

#include "vtkGodRaysMath.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <regex>

using namespace ModelError;

namespace
{
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
  {
    this->Results.Methods = MakeModelMethods();
    this->Results.Renderer = device.GetRendererName();
    this->Results.Command = settings.Command;
    this->Results.Width = settings.Quick ? 160 : 480;
    this->Results.Height = settings.Quick ? 90 : 270;
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

  void WritePage() const { this->Results.WritePage(this->Settings.Folder); }

private:
  void MeasureCase(const Scene& scene, const NamedLight& light);
  void MeasureTimes();
  void WritePictures(
    const Scene& scene, const Picture& truth, const std::vector<Picture>& pictures);

  Device& OpenGL;
  const ModelErrorSettings& Settings;
  ModelReport Results;
};

//------------------------------------------------------------------------------
void ModelErrors::MeasureCase(const Scene& scene, const NamedLight& light)
{
  const bool front = &light == &Lights[0];
  // Quickly, those whose errors are not checked have one case.
  const bool isShort =
    this->Settings.Quick && this->Settings.Folder.empty() && !this->Results.Errors.empty();
  Stage stage(this->OpenGL, scene, this->Results.Width, this->Results.Height);
  for (const double asymmetry : Asymmetries)
  {
    if (asymmetry != Asymmetries[0] && (!front || this->Settings.Quick))
    {
      continue;
    }
    stage.Set(light, asymmetry);
    const Truth truth(scene.Occluders, light, asymmetry, this->Results.Width, this->Results.Height);
    this->Results.PixelsOnEdges = std::max(this->Results.PixelsOnEdges, truth.PixelsOnEdges);
    std::vector<Picture> pictures;
    std::ostringstream row;
    row << "| " << scene.Name << " | " << light.Name << " | " << asymmetry;
    for (const ModelMethod& method : this->Results.Methods)
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
          this->Results.ByLight[{ method.Name, light.Name }].Add(errors[c], scene.Name);
          this->Results.ByMedium[{ method.Name, std::to_string(c) }].Add(errors[c], scene.Name);
          this->Results.All[method.Name].Add(errors[c], scene.Name);
          this->Results.Errors[method.Name].push_back(errors[c]);
        }
        if (front)
        {
          this->Results.ByAsymmetry[{ method.Name, std::to_string(asymmetry) }].Add(
            errors[c], scene.Name);
        }
      }
      row << " | " << ToText(ofCase);
      this->Results.Cases << scene.Name << "," << light.Name << "," << asymmetry << ",\""
                          << method.Name << "\"," << ToText(ofCase.GetRms()) << ","
                          << ToText(ofCase.Worst) << "\n";
      pictures.push_back(std::move(picture));
    }
    row << " |\n";
    std::printf("%s", row.str().c_str());
    std::fflush(stdout);
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
  const auto best = std::find_if(this->Results.Methods.begin(), this->Results.Methods.end(),
    [](const ModelMethod& method) { return method.Name == BestModel; });
  const Picture& ours = pictures[best - this->Results.Methods.begin()];
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
  std::filesystem::create_directories(this->Settings.Folder + "/Pictures");
  WriteRow({ truth, pictures[0], ours, differences[0], differences[1] }, white, this->Results.Width,
    this->Results.Height, this->Settings.Folder + "/Pictures/model-error-" + name + ".png");
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
  for (const ModelMethod& method : this->Results.Methods)
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
  const auto hundred = GetSeconds(items, std::string(CustomaryModel) + GreyName);
  for (const RoundsItem& item : items)
  {
    for (std::size_t i = 0; i < item.Seconds.size(); ++i)
    {
      this->Results.Copies[item.Name].push_back((item.Seconds[i] - none[i]) / copies[i]);
      this->Results.Taps[item.Name].push_back((item.Seconds[i] - none[i]) / (hundred[i] - none[i]));
    }
  }
}

//------------------------------------------------------------------------------
bool ModelErrors::Print() const
{
  std::printf("\n%s\n", this->Results.MakeTables().c_str());
  const auto get = [this](const char* method) { return this->Results.All.at(method).GetRms(); };
  // The customary sum is the control: it must not pass for single scattering. Nor must light without shadows,
  // which froxels and trees know most of.
  const double bound = 0.03;
  const double ourBound = this->Settings.Quick ? 0.004 : 0.0015;
  const bool kept = get(BestModel) < ourBound && get(CustomaryModel) > bound;
  if (!kept)
  {
    std::printf(
      "the error of %s, %g, should be below %g, and that of the radial sum, %g, above %g\n",
      BestModel, get(BestModel), ourBound, get(CustomaryModel), bound);
  }
  const double others = std::max(get(CellMethod), get(TreeMethod));
  const bool areOrdered = get(ClosedForm) > bound && others < 0.25 * get(ClosedForm);
  if (!areOrdered)
  {
    std::printf("the error of the closed form, %g, should be above %g, and those of %s and %s, "
                "at most %g, below a quarter of it\n",
      get(ClosedForm), bound, CellMethod, TreeMethod, others);
  }
  return kept && areOrdered;
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
