// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include "Charts.h"
#include "Rounds.h"
#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

using namespace GodRaysPictures;
using namespace Statistics;

//------------------------------------------------------------------------------
Benchmark::Benchmark(const BenchmarkOptions& options)
  : Settings(options)
  , Stage(OpenGL)
{
  const Size size = this->GetSize();
  this->Results.Renderer = this->OpenGL.GetRendererName();
  this->Results.Instructions = options.Instructions;
  this->Results.Width = size.Width;
  this->Results.Height = size.Height;
  this->Results.Rows = 180;
  std::printf("OpenGL: %s\n", this->Results.Renderer.c_str());

  const Light centre = GetLights()[0];
  Mask open(64, 36);
  this->Stage.SetCase(open, centre, 1);
  for (const Method& method : MakeMethods())
  {
    if (!std::regex_search(method.Name, std::regex(options.Methods)))
    {
      continue;
    }
    this->Stage.Run(method, Scattering::ONE_COLOR);
    const std::string plan = method.Integrator->Describe(this->Stage.GetModel());
    if (method.Series == "epipolar, graphics" && plan.find("on the processor") != std::string::npos)
    {
      continue; // there is no such back end here
    }
    this->Methods.push_back(method);
  }
}

//------------------------------------------------------------------------------
const Method* Benchmark::FindMethod(const std::string& name) const
{
  for (const Method& method : this->Methods)
  {
    if (method.Name == name)
    {
      return &method;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::vector<const Method*> Benchmark::GetConverged() const
{
  std::vector<const Method*> methods;
  for (const char* name : { ProcessorMethod, GraphicsMethod })
  {
    if (const Method* method = this->FindMethod(name))
    {
      methods.push_back(method);
    }
  }
  return methods;
}

//------------------------------------------------------------------------------
void Benchmark::AddFigure(const std::string& text, Figure::Relation relation, double bound,
  double measured, const std::string& note)
{
  Figure figure;
  figure.Text = text;
  figure.Relates = relation;
  figure.Bound = bound;
  figure.Measured = measured;
  figure.Note = note;
  this->Results.Figures.push_back(figure);
}

//------------------------------------------------------------------------------
void Benchmark::MeasureScattering()
{
  const Size size = this->GetSize();
  const std::set<std::string> quickPictures = { "discs", "lattice", "one-pixel lattice" };
  const std::set<std::string> quickLights = { "centre", "corner", "0.5 off" };
  this->OpenGL.PrepareUnits(size.Width, size.Height);
  for (const Picture& picture : GetPictures())
  {
    if (this->Settings.Quick && !quickPictures.count(picture.Name))
    {
      continue;
    }
    Mask mask(size.Width, size.Height);
    picture.Draw(mask);
    for (const Light& light : GetLights())
    {
      if ((!this->Settings.Quick || quickLights.count(light.Name)) &&
        this->IsWanted(std::string("scattering/") + picture.Name + "/" + light.Name))
      {
        this->MeasureCase(picture, mask, light);
        this->WriteFiles();
      }
    }
  }
}

//------------------------------------------------------------------------------
void Benchmark::MeasureCase(const Picture& picture, const Mask& mask, const Light& light)
{
  this->Stage.SetCase(mask, light, std::min(mask.Height, this->Results.Rows));
  std::vector<RoundsItem> items = {
    { "copy", [this]() { return this->OpenGL.MeasureCopy(); }, {} },
    { "march", [this]() { return this->OpenGL.MeasureMarch(); }, {} },
  };
  std::vector<Record> records;
  for (const Method& method : this->Methods)
  {
    if (method.Pace == Method::SLOWEST &&
      (picture.Name != std::string("lattice") ||
        (light.Name != std::string("centre") && light.Name != std::string("0.5 off"))))
    {
      continue;
    }
    for (const auto content : { Scattering::ONE_COLOR, Scattering::RGB })
    {
      if (method.Pace != Method::STEADY && content == Scattering::RGB &&
        this->Stage.HasOneChannel(method))
      {
        continue;
      }
      Record record;
      record.Section = "scattering";
      record.Picture = picture.Name;
      record.Light = light.Name;
      record.OnScreen = light.IsOnScreen();
      record.Method = method.Name;
      record.Channels = content == Scattering::RGB ? 3 : 1;
      record.Width = mask.Width;
      record.Height = mask.Height;
      record.HasErrors = true;
      if (content == Scattering::RGB && !this->Stage.HasOneChannel(method))
      {
        record.Milliseconds = records.back().Milliseconds;
        record.Error = records.back().Error; // one colour was three channels already
        records.push_back(record);
        continue;
      }
      // what is made at the first time does not count, except where it does not matter
      record.Milliseconds = 1e3 * this->Stage.Run(method, content);
      record.Error = this->Stage.Compare(content);
      records.push_back(record);
      if (method.Pace == Method::STEADY)
      {
        items.push_back({ method.Name + (content == Scattering::RGB ? ", RGB" : ""),
          [this, &method, content]() { return this->Stage.Run(method, content); }, {} });
      }
    }
  }
  MeasureRounds(std::string("scattering/") + picture.Name + "/" + light.Name, items,
    this->Settings.Quick ? 3 : 1, false);

  const auto copies = GetSeconds(items, "copy");
  const auto marches = GetSeconds(items, "march");
  const auto customary = GetSeconds(items, CustomaryMethod);
  for (Record& record : records)
  {
    auto seconds = GetSeconds(items, record.Method + (record.Channels == 3 ? ", RGB" : ""));
    if (seconds.empty())
    {
      seconds = GetSeconds(items, record.Method);
    }
    if (seconds.empty()) // slow: once
    {
      seconds.assign(marches.size(), record.Milliseconds / 1e3);
    }
    record.Milliseconds = 1e3 * GetMedian(seconds);
    record.Copies = GetMedian(Divide(seconds, copies));
    record.Marches = GetMedian(Divide(seconds, marches));
    record.Gain = GetMedian(Divide(customary, seconds));
    this->Results.Records.push_back(record);
  }
}

//------------------------------------------------------------------------------
void Benchmark::JudgeErrorAndCost()
{
  const auto get = [this](const char* method, int channels, double (*value)(const Record&))
  { return this->Results.Get("scattering", method, channels, value); };
  if (this->Results.GetMethods("scattering").empty() || this->Settings.Quick)
  {
    return;
  }
  const std::string at = std::string(ProcessorMethod) + ": ";
  const double level = 1.0 / 255.0;
  this->AddFigure(at + "RMSE of the worst case", Figure::AT_MOST, 1e-3,
    GetLargest(get(ProcessorMethod, 1, GetRMS)));
  this->AddFigure(
    at + "the same, RGB", Figure::AT_MOST, 1e-3, GetLargest(get(ProcessorMethod, 3, GetRMS)));
  this->AddFigure(at + "99.9th percentile of the median case", Figure::AT_MOST, level,
    GetMedian(get(ProcessorMethod, 1, GetPermille)));
  this->AddFigure(at + "99.9th percentile of the worst case", Figure::AT_MOST, 4.0 * level,
    GetLargest(get(ProcessorMethod, 1, GetPermille)));
  this->AddFigure(at + "times cheaper than taps 100, one colour", Figure::AT_LEAST, 60.0,
    GetMedian(get(ProcessorMethod, 1, GetGain)));
  this->AddFigure(at + "times cheaper than taps 100, RGB", Figure::AT_LEAST, 25.0,
    GetMedian(get(ProcessorMethod, 3, GetGain)));
  this->AddFigure(at + "full-screen copies, one colour", Figure::AT_MOST, 1.5,
    GetMedian(get(ProcessorMethod, 1, GetCopies)));
  this->AddFigure(at + "full-screen copies, RGB", Figure::AT_MOST, 4.0,
    GetMedian(get(ProcessorMethod, 3, GetCopies)));
  const std::string card = std::string(GraphicsMethod) + ": ";
  this->AddFigure(card + "times cheaper than taps 100, one colour", Figure::AT_LEAST, 10.0,
    GetMedian(get(GraphicsMethod, 1, GetGain)));
  this->AddFigure(card + "RMSE of the worst case", Figure::AT_MOST, 6e-4,
    GetLargest(get(GraphicsMethod, 1, GetRMS)));
}

//------------------------------------------------------------------------------
bool Benchmark::Check() const
{
  bool good = true;
  double control = None;
  int checked = 0;
  for (const Record& record : this->Results.Records)
  {
    if (record.Section != "scattering")
    {
      continue;
    }
    const Method* method = this->FindMethod(record.Method);
    const bool converges = method->Series.find("epipolar") == 0;
    checked += converges ? 1 : 0;
    if (record.Method == ControlMethod)
    {
      control = std::fmax(control, record.Error.RMS);
    }
    if (converges && !(record.Error.RMS <= method->Tolerance))
    {
      // on the card, tolerances finer than a level of 255 are not kept yet
      const double floor = method->Series == "epipolar, graphics" ? 1e-3 : 0.0;
      const bool excused = record.Error.RMS <= floor;
      std::fprintf(excused ? stdout : stderr,
        "%s, %s, light %s, %d channel(s): RMSE %.2e is above the tolerance%s\n",
        record.Method.c_str(), record.Picture.c_str(), record.Light.c_str(), record.Channels,
        record.Error.RMS, excused ? ", but below 1e-3, all that is asked of the card" : "");
      good = good && excused;
    }
  }
  std::printf(
    "%d results of converged integrators keep their bounds: %s\n", checked, good ? "yes" : "no");
  if (control <= 1.0 / 255.0)
  {
    std::fprintf(stderr,
      "godrays_benchmark: the control, %s, has an RMSE of %.2e: this checks nothing\n",
      ControlMethod, control);
    good = false;
  }
  return good;
}

//------------------------------------------------------------------------------
void Benchmark::Print()
{
  this->JudgeErrorAndCost();
  std::printf("\n%s", this->Results.MakeTables().c_str());
}

//------------------------------------------------------------------------------
// Anew after each case, so that a run that is ended early leaves what it has.
void Benchmark::WriteFiles()
{
  const std::vector<Figure> figures = this->Results.Figures;
  this->JudgeErrorAndCost();
  const Report written = this->Results;
  this->Results.Figures = figures;
  if (!this->Settings.CSV.empty())
  {
    written.WriteCSV(this->Settings.CSV);
  }
  if (this->Settings.Documentation.empty())
  {
    return;
  }
  const std::filesystem::path folder = this->Settings.Documentation;
  std::filesystem::create_directories(folder / "Charts");
  for (const char* chart : { "speed-and-error.png", "samples.png", "pixels.png" })
  {
    std::filesystem::remove(folder / "Charts" / chart); // of another run: not all are written anew
  }
  written.WritePage((folder / "Performance.md").string(), this->Settings.Command);

  const std::string size =
    std::to_string(this->Results.Width) + " x " + std::to_string(this->Results.Height);
  Chart error;
  error.Title = "Error against cost, " + size + ", one colour";
  error.XTitle = "cost [bare marches of 60 taps]";
  error.YTitle = "RMSE over all cases [fraction of the peak]";
  Chart samples;
  samples.Title = "Cost against NumberOfSamples, " + size;
  samples.XTitle = "NumberOfSamples";
  samples.YTitle = "cost [bare marches of 60 taps]";
  Chart pixels;
  pixels.Title = "Cost against pixels";
  pixels.XTitle = "million pixels";
  pixels.YTitle = "cost [bare marches of 60 taps at 1920 x 1080]";

  for (const Method& method : this->Methods)
  {
    auto series = std::find_if(error.Series.begin(), error.Series.end(),
      [&method](const ChartSeries& other) { return other.Name == method.Series; });
    if (series == error.Series.end())
    {
      series = error.Series.insert(series, { method.Series, {}, {}, {} });
    }
    series->X.push_back(GetMedian(this->Results.Get("scattering", method.Name, 1, GetMarches)));
    series->Y.push_back(GetRootMeanSquare(this->Results.Get("scattering", method.Name, 1, GetRMS)));
    series->Labels.push_back(method.Label);
  }
  for (const char* section : { "samples", "pixels" })
  {
    Chart& chart = section == std::string("samples") ? samples : pixels;
    for (const std::string& name : this->Results.GetMethods(section))
    {
      ChartSeries series;
      series.Name = name;
      for (const Record& record : this->Results.Records)
      {
        if (record.Section == section && record.Method == name)
        {
          series.X.push_back(
            &chart == &samples ? record.Samples : 1e-6 * record.Width * record.Height);
          series.Y.push_back(record.Marches);
        }
      }
      chart.Series.push_back(series);
    }
  }
  WriteChart(error, (folder / "Charts" / "speed-and-error.png").string());
  WriteChart(samples, (folder / "Charts" / "samples.png").string());
  WriteChart(pixels, (folder / "Charts" / "pixels.png").string());
  SealPage((folder / "Performance.md").string());
}
