// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataErrors.h"

#include "Charts.h"
#include "DataMethods.h"
#include "DataScene.h"
#include "Report.h"
#include "Rounds.h"
#include "Statistics.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace DataMedium;

namespace
{
double Seconds(const std::function<void()>& run)
{
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

//------------------------------------------------------------------------------
/// What a method draws: the light of smoke alone, before the terrain. Pixels that are not drawn hold NaN.
class Method
{
public:
  std::string Name;
  std::string Series;                    // of the chart
  std::function<void(Picture&)> Prepare; // what the first picture does besides; may be empty
  std::function<void(Picture&)> Draw;
  double Share = 1.0; // of the pixels that are drawn; the time is that of all
  bool IsFitted = false;
  bool IsHazy = false; // beside haze, and held to what smoke changes
};

//------------------------------------------------------------------------------
class DataErrors
{
public:
  DataErrors(Device& device, const DataErrorSettings& settings)
    : OpenGL(device)
    , Settings(settings)
    , Stage(settings.Quick ? 48 : 256, settings.Quick ? 160 : 1920, settings.Quick ? 90 : 1080,
        settings.Quick ? 512 : 1024)
    , Alone(Stage, false)
    , InHaze(Stage, true)
  {
#if HAS_SCATTERING_MAPPER
    this->Volume = std::make_unique<Mapper>(device, this->Stage);
#endif
    this->AddMethods();
  }

  void Measure();
  bool Check() const;
  std::string MakeTable() const;
  void WritePage() const;

private:
  void AddMethods();
  void FindTruth();
  double Compare(const Method& method, Picture picture) const;
  void WritePicture() const;

  Device& OpenGL;
  const DataErrorSettings& Settings;
  Scene Stage;
  Ours Alone;
  Ours InHaze;
#if HAS_SCATTERING_MAPPER
  std::unique_ptr<Mapper> Volume;
#endif
  std::vector<Method> Methods;
  struct Sample
  {
    std::size_t Pixel;
    double Alone;  // light of smoke
    double Change; // what smoke changes in haze
    double Hazy;   // light of both
  };
  std::vector<Sample> Truth;
  std::vector<Picture> Pictures; // of each method
  std::vector<double> Errors;
  std::vector<std::vector<double>> Marches; // of each method, in each round
};

//------------------------------------------------------------------------------
void DataErrors::AddMethods()
{
  const auto add = [this](const std::string& name, const std::string& series,
                     std::function<void(Picture&)> draw) -> Method&
  {
    this->Methods.emplace_back();
    this->Methods.back().Name = name;
    this->Methods.back().Series = series;
    this->Methods.back().Draw = std::move(draw);
    return this->Methods.back();
  };
  for (const int share : { 16, 64, 255, 1024 })
  {
    add("vtkGodRays, 1/" + std::to_string(share), "vtkGodRays",
      [this, share](Picture& picture)
      {
        this->Alone.Draw(1.0 / share);
        this->Alone.Get(picture);
      });
  }
  add("vtkGodRays, 1/255, first picture", "vtkGodRays, first",
    [this](Picture& picture)
    {
      this->Alone.Forget();
      this->Alone.Draw(1.0 / 255.0);
      this->Alone.Get(picture);
    });
  add("vtkGodRays, 1/255, in haze", "vtkGodRays, in haze",
    [this](Picture& picture)
    {
      this->InHaze.Draw(1.0 / 255.0);
      this->InHaze.Get(picture);
    })
    .IsHazy = true;
  for (const int slices : { 64, 128 })
  {
    add("froxels, 160 x 90 x " + std::to_string(slices), "froxels",
      [this, slices](Picture& picture) { DrawFroxels(this->Stage, slices, picture); });
  }
  for (const int steps : { 64, 256, 1024 })
  {
    const int stride = this->Settings.Quick ? 1 : steps / 16;
    Method& march = add("march, " + std::to_string(steps) + " steps", "march with shadow rays",
      [this, steps, stride](Picture& picture) { March(this->Stage, steps, stride, picture); });
    const int rows = (this->Stage.Height + stride - 1) / stride;
    march.Share = static_cast<double>(rows) / this->Stage.Height;
  }
#if HAS_SCATTERING_MAPPER
  add("VTK's volume mapper, scattering", "VTK's volume mapper",
    [this](Picture& picture) { this->Volume->Draw(picture); })
    .IsFitted = true;
#endif
}

//------------------------------------------------------------------------------
void DataErrors::FindTruth()
{
  vtkGodRaysSingleScattering exact[3]; // smoke, haze, both
  for (int i = 0; i < 3; ++i)
  {
    Parameters parameters = i == 0 ? this->Stage.Clear : this->Stage.Hazy;
    parameters.Tolerance = 1e-5;
    exact[i].SetParameters(parameters);
    exact[i].SetOccluders(this->Stage.Terrain);
    if (i != 1)
    {
      exact[i].SetGrids({ this->Stage.Grid });
    }
  }
  // Rows that are multiples of 64, which all methods draw.
  const int rows = this->Settings.Quick ? 4 : 64;
  const int columns = this->Settings.Quick ? 5 : 13;
  for (int row = 0; row < this->Stage.Height; row += rows)
  {
    for (int column = row / rows % columns; column < this->Stage.Width; column += columns)
    {
      this->Truth.push_back({ this->Stage.GetPixel(column, row), 0.0, 0.0, 0.0 });
    }
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Truth.size()), 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Sample& sample = this->Truth[i];
        const int column = static_cast<int>(sample.Pixel % this->Stage.Width);
        const int row = static_cast<int>(sample.Pixel / this->Stage.Width);
        vtkGodRaysSingleScattering::Result ray[3];
        for (int k = 0; k < 3; ++k)
        {
          exact[k].Evaluate(this->Stage.GetX(column), this->Stage.GetY(row), ray[k],
            this->Stage.Depths[sample.Pixel]);
        }
        sample.Alone = ray[0].Radiance[0];
        sample.Change = ray[2].Radiance[0] - ray[1].Radiance[0];
        sample.Hazy = ray[2].Radiance[0];
      }
    });
}

//------------------------------------------------------------------------------
// Root mean square, as a fraction of the peak of the light.
double DataErrors::Compare(const Method& method, Picture picture) const
{
  const auto get = [&](const Sample& sample)
  { return method.IsHazy ? sample.Change : sample.Alone; };
  double factor = 1.0;
  if (method.IsFitted)
  {
    double product = 0.0;
    double square = 0.0;
    for (const Sample& sample : this->Truth)
    {
      product += picture[sample.Pixel] * get(sample);
      square += static_cast<double>(picture[sample.Pixel]) * picture[sample.Pixel];
    }
    factor = product / square;
  }
  double squares = 0.0;
  double peak = 0.0;
  for (const Sample& sample : this->Truth)
  {
    squares += std::pow(factor * picture[sample.Pixel] - get(sample), 2);
    peak = std::max(peak, method.IsHazy ? sample.Hazy : sample.Alone);
  }
  return std::sqrt(squares / this->Truth.size()) / peak;
}

//------------------------------------------------------------------------------
void DataErrors::Measure()
{
  this->FindTruth();
  this->OpenGL.PrepareUnits(this->Stage.Width, this->Stage.Height);
  this->Pictures.resize(this->Methods.size());
  std::vector<RoundsItem> items;
  items.push_back({ "march", [&] { return this->OpenGL.MeasureMarch(); }, {} });
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    items.push_back({ this->Methods[i].Name,
      [this, i]
      {
        const Method& method = this->Methods[i];
        const auto draw = [&] { method.Draw(this->Pictures[i]); };
        return (method.IsFitted ? this->OpenGL.Measure(draw) : Seconds(draw)) / method.Share;
      },
      {} });
  }
  MeasureRounds("data error", items, this->Settings.Quick ? 1 : 5);
  const auto unit = GetSeconds(items, "march");
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    this->Marches.push_back(Statistics::Divide(GetSeconds(items, this->Methods[i].Name), unit));
    this->Errors.push_back(this->Compare(this->Methods[i], this->Pictures[i]));
  }
}

//------------------------------------------------------------------------------
std::string DataErrors::MakeTable() const
{
  std::ostringstream text;
  text << "| method | RMSE | marches |\n|---|---|---|\n";
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    char row[160];
    std::snprintf(row, sizeof(row), "| %s | %.4f | %.3g |\n", this->Methods[i].Name.c_str(),
      this->Errors[i], Statistics::GetMedian(this->Marches[i]));
    text << row;
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool DataErrors::Check() const
{
  std::printf("\n%s\n", this->MakeTable().c_str());
  double clear = 0.0;
  double ours = 0.0;
  double coarse = 0.0;
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    if (this->Methods[i].Name == "vtkGodRays, 1/255")
    {
      clear = this->Errors[i];
    }
    if (this->Methods[i].Name == "vtkGodRays, 1/255" || this->Methods[i].IsHazy)
    {
      ours = std::max(ours, this->Errors[i]);
    }
    if (this->Methods[i].Name == "froxels, 160 x 90 x 64")
    {
      coarse = this->Errors[i]; // the control
    }
  }
  // In the large form, froxels are within the tolerance, too.
  const double least = this->Settings.Quick ? 1.0 / 255.0 : 3.0 * clear;
  const bool kept = ours < 1.0 / 255.0 && coarse > least;
  if (!kept)
  {
    std::printf("our error, %g, should be below 1/255, and that of froxels, %g, above %g\n", ours,
      coarse, least);
  }
  return kept;
}

//------------------------------------------------------------------------------
// Ours, froxels and, where there is one, VTK's mapper, each as bright as its largest value makes it.
void DataErrors::WritePicture() const
{
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    const std::string& name = this->Methods[i].Name;
    if (name == "vtkGodRays, 1/255" || name == "froxels, 160 x 90 x 64" ||
      this->Methods[i].IsFitted)
    {
      shown.push_back(i);
    }
  }
  const int scale = this->Settings.Quick ? 1 : 3;
  const int width = this->Stage.Width / scale;
  const int height = this->Stage.Height / scale;
  const int gap = 4;
  const int all = static_cast<int>(shown.size()) * (width + gap) - gap;
  vtkNew<vtkImageData> image;
  image->SetDimensions(all, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(pixels, image->GetNumberOfPoints(), static_cast<unsigned char>(255));
  for (std::size_t p = 0; p < shown.size(); ++p)
  {
    const Picture& picture = this->Pictures[shown[p]];
    const float white = *std::max_element(picture.begin(), picture.end());
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const float value = picture[this->Stage.GetPixel(x * scale, y * scale)];
        pixels[static_cast<std::size_t>(y) * all + p * (width + gap) + x] =
          static_cast<unsigned char>(
            std::lround(255.0 * vtkGodRays::EncodeDisplay(std::max(0.0f, value / white))));
      }
    }
  }
  std::filesystem::create_directories(this->Settings.Folder + "/Pictures");
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName((this->Settings.Folder + "/Pictures/data-error.png").c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
void DataErrors::WritePage() const
{
  const std::string& folder = this->Settings.Folder;
  Chart chart;
  chart.Title = "Smoke of 256 x 256 x 256 points, 1920 x 1080";
  chart.XTitle = "time of a picture (marches of 60 taps)";
  chart.YTitle = "RMSE against single scattering (fraction of the peak)";
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    const Method& method = this->Methods[i];
    if (chart.Series.empty() || chart.Series.back().Name != method.Series)
    {
      chart.Series.push_back({ method.Series, {}, {}, {} });
    }
    chart.Series.back().X.push_back(Statistics::GetMedian(this->Marches[i]));
    chart.Series.back().Y.push_back(this->Errors[i]);
    chart.Series.back().Labels.push_back(method.Name);
  }
  std::filesystem::create_directories(folder + "/Charts");
  WriteChart(chart, folder + "/Charts/data-error.png");
  this->WritePicture();
  std::ofstream page(folder + "/DataError.md");
  page
    << "# Data error\n\nWritten by `" << this->Settings.Command
    << "`.\n\n"
       "How far pictures of a medium of data are from single scattering, and what they cost. The "
       "scene is smoke of\n256 x 256 x 256 points over hills, half in the shadow of a ridge, lit "
       "by "
       "a sun. The truth is\n`vtkGodRaysSingleScatteringReference`, to 1e-5; errors are root mean "
       "squares over "
    << this->Truth.size() << " pixels of 1920 x 1080,\nas fractions of the peak. The unit of time "
    << "is the bare march of 60 bilinear taps of a picture of that size, measured\nin the same "
       "rounds; medians of five. Two threads; OpenGL: "
    << this->OpenGL.GetRendererName() << "; VTK " << VTK_MAJOR_VERSION << "." << VTK_MINOR_VERSION
    << ".\n\n"
       "- *vtkGodRays*: `vtkGodRaysGridPicture` by its tolerance; the first picture includes the "
       "light's depths through\n  the data, which are kept. *In haze*: beside a homogeneous "
       "medium, "
       "whose own light is not counted.\n"
       "- *froxels*: one sample and one ray of 32 steps to the sun in each cell of the view.\n"
       "- *march*: equal steps through the data's box, each with a ray of an eighth as many to the "
       "sun, at least 8. Every\n  4th to 64th row is drawn, and the time is that of all.\n"
       "- *VTK's volume mapper*: all of its scattering, reach 1. It has no unit, so its picture is "
       "times what makes its\n  error least; it sees no shadow of the hills. Ours and the other "
       "two "
       "run on the processor, it on OpenGL.\n\n"
       "All are given the depths of the hills and their shadow map, whose making is not "
       "counted.\n\n![Data error against cost](Charts/data-error.png)\n\n"
    << this->MakeTable()
    << "\nOurs, froxels of 64 slices, and VTK's mapper where this VTK scatters:\n\n"
       "![Smoke](Pictures/data-error.png)\n";
  page.close();
  SealPage(folder + "/DataError.md");
}
}

//------------------------------------------------------------------------------
bool MeasureDataErrors(Device& device, const DataErrorSettings& settings)
{
  DataErrors errors(device, settings);
  errors.Measure();
  const bool kept = errors.Check();
  if (!settings.Folder.empty())
  {
    errors.WritePage();
  }
  return kept;
}
