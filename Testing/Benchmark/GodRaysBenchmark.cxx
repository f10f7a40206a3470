// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// godrays_benchmark: speed and error of the integrators, and the figures that are asked for.
// See Help below.

#include "Charts.h"
#include "Counters.h"
#include "DataErrors.h"
#include "Device.h"
#include "EffectScene.h"
#include "GodRaysPictures.h"
#include "Methods.h"
#include "ModelErrors.h"
#include "Report.h"
#include "Rounds.h"
#include "Scattering.h"
#include "Statistics.h"

#include "vtkGodRaysScatteringFilter.h"
#include "vtkGodRaysSweepKernels.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace GodRaysPictures;
using namespace Statistics;

namespace
{
const char* const Help = R"(Usage: godrays_benchmark [--quick | --full] [option ...]

Measures the integrators of vtkGodRays: their error against the exact reference, and their cost, as
ratios to a full-screen copy and to the bare loop of 60 taps that are measured in the same rounds.
Prints tables, and each figure that is asked for as met or missed.

  --full                 everything, 1920 x 1080, pictures of up to 33 million pixels; some 10
                         minutes on two cores with software OpenGL. The default
  --quick                small pictures, under a minute. Checks that the errors keep their bounds,
                         and that a control with 16 taps does not; the exit status is 1 if not.
                         Never judges a time
  --filter REGEX         only measurements whose names match. Names: scattering/PICTURE/LIGHT,
                         effect/WIDTHxHEIGHT, samples, pixels, threads, steady
  --methods REGEX        only integrators whose names match; --list shows names
  --instructions SET     vector instructions of the processor's integrators, such as AVX2, other than
                         the best that it has
  --csv FILE             write all that was measured as comma-separated values
  --documentation FOLDER write FOLDER/Performance.md and the charts in FOLDER/Charts/
  --model-error          measure something else: how far models are from single scattering, on twelve
                         scenes; FOLDER/ModelError.md, its chart and pictures. Names for --filter:
                         SCENE/LIGHT. Some 4 minutes
  --data-error           measure something else: media of data; FOLDER/DataError.md, its chart and picture
  --list                 list pictures, lights and integrators, and measure nothing
  --help                 this text

Pictures, lights and the model (density 0.97, decay 0.99) are the same every time. The light's march
is capped as vtkGodRaysPass does it. Layers hold 16-bit floats (32-bit where an integrator asks for
them), the same values in both.

It needs a display: xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" godrays_benchmark
)";

struct Options
{
  bool Quick = false;
  bool List = false;
  bool ModelError = false;
  bool DataError = false;
  std::string Filter = ".";
  std::string Methods = ".";
  std::string Instructions = vtkGodRays::GetInstructionSets().front();
  std::string CSV;
  std::string Documentation;
  std::string Command = "build/bin/godrays_benchmark"; // as the page tells it
};

struct Size
{
  int Width;
  int Height;
};

std::string GetName(const Size& size)
{
  return std::to_string(size.Width) + "x" + std::to_string(size.Height);
}

//------------------------------------------------------------------------------
class Benchmark
{
public:
  explicit Benchmark(const Options& options);

  void MeasureScattering();
  void MeasureEffect();
  void MeasureSamples();
  void MeasurePixels();
  void MeasureThreads();
  void MeasureSteadyFrame();

  /// Whether errors keep their bounds; says where not.
  bool Check() const;

  void Print();

private:
  bool IsWanted(const std::string& name) const
  {
    return std::regex_search(name, std::regex(this->Settings.Filter));
  }
  void JudgeErrorAndCost();
  void WriteFiles();
  void MeasureCase(const Picture& picture, const Mask& mask, const Light& light);
  const Method* FindMethod(const std::string& name) const;
  std::vector<const Method*> GetConverged() const;
  Size GetSize() const { return this->Settings.Quick ? Size{ 320, 180 } : Size{ 1920, 1080 }; }
  void AddFigure(const std::string& text, Figure::Relation relation, double bound, double measured,
    const std::string& note = "", double target = 0.0);

  const Options& Settings;
  Device OpenGL;
  Scattering Stage;
  std::vector<Method> Methods;
  Report Results;
};

//------------------------------------------------------------------------------
Benchmark::Benchmark(const Options& options)
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
  double measured, const std::string& note, double target)
{
  Figure figure;
  figure.Text = text;
  figure.Relates = relation;
  figure.Bound = bound;
  figure.Measured = measured;
  figure.Target = target;
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
void Benchmark::MeasureEffect()
{
  const std::vector<Size> sizes = this->Settings.Quick
    ? std::vector<Size>{ { 320, 180 } }
    : std::vector<Size>{ { 1280, 720 }, { 1920, 1080 } };
  for (const Size& size : sizes)
  {
    double measured = None;
    double lamp = None;
    if (this->IsWanted("effect/" + GetName(size)))
    {
      this->OpenGL.PrepareUnits(size.Width, size.Height);
      EffectScene scene(this->OpenGL, size.Width, size.Height);
      std::vector<RoundsItem> items = {
        { "copy", [this]() { return this->OpenGL.MeasureCopy(); }, {} },
        { "march", [this]() { return this->OpenGL.MeasureMarch(); }, {} },
      };
      for (const auto& variant : EffectScene::GetVariants())
      {
        items.push_back({ variant.Name, [&scene, &variant]() { return scene.Draw(variant); }, {} });
      }
      MeasureRounds("effect/" + GetName(size), items, this->Settings.Quick ? 2 : 7);
      const auto copies = GetSeconds(items, "copy");
      const auto marches = GetSeconds(items, "march");
      for (const auto& variant : EffectScene::GetVariants())
      {
        if (!variant.HasPass)
        {
          continue;
        }
        const auto added = Subtract(GetSeconds(items, variant.Name),
          GetSeconds(items, variant.LampShines ? "plain, with a lamp" : "plain"));
        Record record;
        record.Section = "effect";
        record.Method = variant.Name;
        record.Width = size.Width;
        record.Height = size.Height;
        record.Milliseconds = 1e3 * GetMedian(added);
        record.Copies = GetMedian(Divide(added, copies));
        record.Marches = GetMedian(Divide(added, marches));
        this->Results.Records.push_back(record);
        if (variant.Name == "default")
        {
          measured = record.Marches;
        }
        else if (variant.Name == "default, lamp")
        {
          lamp = record.Marches;
        }
      }
    }
    if (!this->Settings.Quick)
    {
      this->AddFigure("the whole effect at " + GetName(size) + ", a vtkLight, in marches",
        Figure::AT_MOST, size.Height == 720 ? 0.2 : 0.12, measured);
      this->AddFigure("the same, a prop that shines", Figure::AT_MOST, 0.2, lamp);
    }
  }
}

//------------------------------------------------------------------------------
void Benchmark::MeasureSamples()
{
  const std::string text = "change of cost from 10 to 10,000 samples [%], ";
  const auto converged = this->GetConverged();
  if (!this->IsWanted("samples"))
  {
    return;
  }
  const Size size = this->GetSize();
  Mask mask(size.Width, size.Height);
  DrawLattice(mask);
  this->Stage.SetCase(mask, GetLights()[0], 1);
  this->OpenGL.PrepareUnits(size.Width, size.Height);
  vtkGodRaysRadialModel* model = this->Stage.GetModel();
  const double kernel = -100.0 * std::log(model->GetDecay());
  const double gain = model->GetFlatGain();
  const auto setSamples = [&](int samples)
  {
    // the same picture, in more samples
    model->SetNumberOfSamples(samples);
    model->SetDecay(std::exp(-kernel / samples));
    model->SetWeight(model->GetWeight() * gain / model->GetFlatGain());
  };

  std::vector<int> counts;
  for (int samples : { 10, 100, 1000, 10000 })
  {
    if (samples <= model->GetNumberOfSamplesMaxValue())
    {
      counts.push_back(samples);
    }
  }
  Method taps;
  taps.Name = "taps as many";
  taps.Integrator = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();

  std::vector<Method> copies; // an integrator for each, as one scene has
  std::vector<int> samplesOf;
  for (const Method* wanted : converged)
  {
    for (int samples : counts)
    {
      for (Method& method : MakeMethods())
      {
        if (method.Name == wanted->Name)
        {
          copies.push_back(method);
          samplesOf.push_back(samples);
        }
      }
    }
  }
  std::vector<RoundsItem> items = {
    { "march", [this]() { return this->OpenGL.MeasureMarch(); }, {} },
  };
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    items.push_back({ copies[i].Name + " " + std::to_string(samplesOf[i]),
      [this, &setSamples, &method = copies[i], samples = samplesOf[i]]()
      {
        setSamples(samples);
        return this->Stage.Run(method, Scattering::ONE_COLOR);
      },
      {} });
  }
  MeasureRounds("samples", items, this->Settings.Quick ? 2 : 11);
  const auto marches = GetSeconds(items, "march");

  const auto add = [&](const Method& method, int samples, const std::vector<double>& seconds)
  {
    Record record;
    record.Section = "samples";
    record.Picture = "lattice";
    record.Light = "centre";
    record.Method = method.Name;
    record.Width = size.Width;
    record.Height = size.Height;
    record.Samples = samples;
    record.Milliseconds = 1e3 * GetMedian(seconds);
    record.Marches = GetMedian(seconds) / GetMedian(marches);
    this->Results.Records.push_back(record);
  };
  for (int samples : counts)
  {
    if (samples <= 1000 || this->Settings.Quick)
    {
      setSamples(samples);
      this->Stage.Run(taps, Scattering::ONE_COLOR);
      add(taps, samples, { this->Stage.Run(taps, Scattering::ONE_COLOR) });
    }
  }
  for (const Method* method : converged)
  {
    const auto fewest = GetSeconds(items, method->Name + " 10");
    double change = 0.0;
    for (int samples : counts)
    {
      const auto seconds = GetSeconds(items, method->Name + " " + std::to_string(samples));
      add(*method, samples, seconds);
      change = std::max(change, 100.0 * std::abs(GetMedian(Divide(seconds, fewest)) - 1.0));
    }
    if (!this->Settings.Quick)
    {
      this->AddFigure(text + method->Name, Figure::AT_MOST, 5.0, change,
        counts.back() < 10000
          ? "to " + std::to_string(counts.back()) + ", the most that the model takes"
          : "");
    }
  }
  setSamples(100);
}

//------------------------------------------------------------------------------
void Benchmark::MeasurePixels()
{
  if (!this->IsWanted("pixels"))
  {
    return;
  }
  const std::vector<Size> sizes = this->Settings.Quick
    ? std::vector<Size>{ { 160, 90 }, { 320, 180 }, { 640, 360 } }
    : std::vector<Size>{ { 672, 378 }, { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 },
        { 7680, 4320 } };
  const Size& unit = sizes[std::min<std::size_t>(2, sizes.size() - 1)];
  this->OpenGL.PrepareUnits(unit.Width, unit.Height);
  std::vector<std::unique_ptr<Scattering>> stages;
  std::vector<std::vector<Method>> methods; // an integrator for each size, as one window has
  for (const Size& size : sizes)
  {
    Mask mask(size.Width, size.Height);
    DrawLattice(mask);
    stages.push_back(std::make_unique<Scattering>(this->OpenGL));
    stages.back()->SetCase(mask, GetLights()[0], 1);
    methods.emplace_back();
    for (const Method& method : MakeMethods())
    {
      if (this->FindMethod(method.Name) &&
        (method.Name == ProcessorMethod || method.Name == GraphicsMethod ||
          method.Name == ControlMethod) &&
        (method.Name == ProcessorMethod || size.Width <= 3840)) // the others take seconds there
      {
        methods.back().push_back(method);
      }
    }
  }
  std::vector<RoundsItem> items = {
    { "march", [this]() { return this->OpenGL.MeasureMarch(); }, {} },
  };
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    for (const Method& method : methods[i])
    {
      items.push_back({ method.Name + " " + GetName(sizes[i]),
        [&stage = *stages[i], &method]() { return stage.Run(method, Scattering::ONE_COLOR); },
        {} });
    }
  }
  MeasureRounds("pixels", items, this->Settings.Quick ? 2 : 3);
  const auto marches = GetSeconds(items, "march");
  for (std::size_t m = 0; m < methods[0].size(); ++m)
  {
    const std::string name = methods[0][m].Name;
    std::vector<double> pixels;
    std::vector<double> times;
    for (const Size& size : sizes)
    {
      const auto seconds = GetSeconds(items, name + " " + GetName(size));
      if (seconds.empty())
      {
        continue;
      }
      Record record;
      record.Section = "pixels";
      record.Picture = "lattice";
      record.Light = "centre";
      record.Method = name;
      record.Width = size.Width;
      record.Height = size.Height;
      record.Milliseconds = 1e3 * GetMedian(seconds);
      record.Marches = GetMedian(Divide(seconds, marches));
      this->Results.Records.push_back(record);
      pixels.push_back(static_cast<double>(size.Width) * size.Height);
      times.push_back(record.Milliseconds);
    }
    if (name != ControlMethod && !this->Settings.Quick)
    {
      this->AddFigure("exponent of cost against pixels, " + name, Figure::ABOUT, 0.1,
        FitExponent(pixels, times),
        "0.25 to " + std::to_string(std::lround(1e-6 * pixels.back())) + " million", 1.0);
    }
  }
}

//------------------------------------------------------------------------------
void Benchmark::MeasureThreads()
{
  if (!this->IsWanted("threads"))
  {
    return;
  }
  const Size size = this->GetSize();
  std::vector<double> gains;
  for (const char* name : { "lattice", "clouds" })
  {
    Mask mask(size.Width, size.Height);
    for (const Picture& picture : GetPictures())
    {
      if (picture.Name == std::string(name))
      {
        picture.Draw(mask);
      }
    }
    for (const Light& light : { GetLights()[0], GetLights()[3] })
    {
      this->Stage.SetCase(mask, light, 1);
      vtkNew<vtkGodRaysScatteringFilter> filter;
      filter->SetInputData(this->Stage.GetLayer());
      filter->SetDecay(this->Stage.GetModel()->GetDecay());
      filter->SetLightClip(this->Stage.GetLightClip());
      filter->SetMarchScale(this->Stage.GetMarchScale());
      std::vector<RoundsItem> items;
      for (int threads : { 1, 2 })
      {
        items.push_back({ std::to_string(threads),
          [this, threads, &filter]()
          {
            double seconds = 0.0;
            vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
              [&]()
              {
                seconds = this->OpenGL.Measure(
                  [&]()
                  {
                    filter->Modified();
                    filter->Update();
                  });
              });
            return seconds;
          },
          {} });
      }
      MeasureRounds(
        std::string("threads/") + name + "/" + light.Name, items, this->Settings.Quick ? 2 : 21);
      for (int threads : { 1, 2 })
      {
        Record record;
        record.Section = "threads";
        record.Picture = name;
        record.Light = light.Name;
        record.OnScreen = light.IsOnScreen();
        record.Method = "vtkGodRaysScatteringFilter";
        record.Width = size.Width;
        record.Height = size.Height;
        record.Threads = threads;
        record.Milliseconds = 1e3 * GetMedian(GetSeconds(items, std::to_string(threads)));
        this->Results.Records.push_back(record);
      }
      gains.push_back(GetMedian(Divide(GetSeconds(items, "1"), GetSeconds(items, "2"))));
    }
  }
  if (!this->Settings.Quick)
  {
    this->AddFigure("two threads against one, vtkGodRaysScatteringFilter", Figure::AT_LEAST, 1.7,
      GetMedian(gains));
  }
}

//------------------------------------------------------------------------------
void Benchmark::MeasureSteadyFrame()
{
  if (!this->IsWanted("steady"))
  {
    return;
  }
  const Size size = this->GetSize();
  // plain: what there is without us
  const auto tell = [this](const std::string& what, const CountersResult& counts,
                      const CountersResult& plain = CountersResult())
  {
    std::printf("steady, %s: %d allocations by vtkGodRays, %d by VTK, %d by others; %d shaders "
                "built, %d objects made on the card\n",
      what.c_str(), counts.Allocations, counts.VTKAllocations, counts.OtherAllocations,
      counts.Shaders, counts.Objects);
    for (const std::string& name : counts.Allocators)
    {
      std::printf("  allocates: %s\n", name.c_str());
    }
    if (counts.HasAllocations)
    {
      const int ofVTK = counts.VTKAllocations - plain.VTKAllocations;
      this->AddFigure("allocations in a steady frame, " + what, Figure::AT_MOST, 0.0,
        counts.Allocations + std::max(0, ofVTK),
        std::to_string(counts.Allocations) + " by vtkGodRays, " + std::to_string(ofVTK) +
          " by VTK that a plain frame or copy has not");
    }
    this->AddFigure("shaders built and objects made on the card, " + what, Figure::AT_MOST, 0.0,
      counts.Shaders + counts.Objects - plain.Shaders - plain.Objects);
  };
  Mask mask(size.Width, size.Height);
  DrawLattice(mask);
  this->Stage.SetCase(mask, GetLights()[0], 1);
  this->OpenGL.PrepareUnits(size.Width, size.Height);
  this->OpenGL.MeasureCopy();
  StartCounters(this->OpenGL.GetWindow());
  this->OpenGL.MeasureCopy();
  const CountersResult copy = StopCounters(); // what VTK allocates to draw a quad
  for (const Method* method : this->GetConverged())
  {
    for (const auto content : { Scattering::ONE_COLOR, Scattering::RGB })
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Stage.Run(*method, content);
      }
      StartCounters(this->OpenGL.GetWindow());
      this->Stage.Run(*method, content);
      tell(method->Name + (content == Scattering::RGB ? ", RGB" : ", one colour"), StopCounters(),
        copy);
    }
  }
  EffectScene scene(this->OpenGL, size.Width, size.Height);
  CountersResult frames[2]; // plain, and with the pass
  for (int i = 0; i < 2; ++i)
  {
    const auto& variant = EffectScene::GetVariants()[i];
    for (int repeat = 0; repeat < 4; ++repeat)
    {
      scene.Draw(variant);
    }
    StartCounters(this->OpenGL.GetWindow());
    scene.Draw(variant);
    frames[i] = StopCounters();
  }
  tell("a whole frame", frames[1], frames[0]);
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
  this->AddFigure(card + "times cheaper than taps 100", Figure::AT_LEAST, 4.0,
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
      const double floor = method->Series == "epipolar, graphics" ? 2e-3 : 0.0;
      const bool excused = record.Error.RMS <= floor;
      std::fprintf(excused ? stdout : stderr,
        "%s, %s, light %s, %d channel(s): RMSE %.2e is above the tolerance%s\n",
        record.Method.c_str(), record.Picture.c_str(), record.Light.c_str(), record.Channels,
        record.Error.RMS, excused ? ", but below 2e-3, all that is asked of the card" : "");
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

//------------------------------------------------------------------------------
Options ReadOptions(int count, char* arguments[])
{
  Options options;
  for (int i = 1; i < count; ++i)
  {
    const std::string name = arguments[i];
    const auto value = [&]()
    {
      if (++i == count)
      {
        throw std::runtime_error(name + " needs a value; see --help");
      }
      return std::string(arguments[i]);
    };
    if (name == "--help" || name == "-h")
    {
      std::fputs(Help, stdout);
      std::exit(EXIT_SUCCESS);
    }
    else if (name == "--quick")
    {
      options.Quick = true;
    }
    else if (name == "--model-error")
    {
      options.ModelError = true;
    }
    else if (name == "--data-error")
    {
      options.DataError = true;
    }
    else if (name == "--full")
    {
      options.Quick = false;
    }
    else if (name == "--list")
    {
      options.List = true;
    }
    else if (name == "--filter")
    {
      options.Filter = value();
    }
    else if (name == "--methods")
    {
      options.Methods = value();
    }
    else if (name == "--instructions")
    {
      options.Instructions = value();
    }
    else if (name == "--csv")
    {
      options.CSV = value();
    }
    else if (name == "--documentation")
    {
      options.Documentation = value();
    }
    else
    {
      throw std::runtime_error("unknown option " + name + "; see --help");
    }
  }
  for (const std::string* expression : { &options.Filter, &options.Methods })
  {
    try
    {
      std::regex test(*expression);
    }
    catch (const std::regex_error&)
    {
      throw std::runtime_error("'" + *expression + "' is not a regular expression");
    }
  }
  if (!vtkGodRays::UseInstructionSet(options.Instructions))
  {
    std::string names;
    for (const std::string& set : vtkGodRays::GetInstructionSets())
    {
      names += " " + set;
    }
    throw std::runtime_error("this processor has no vector instructions named " +
      options.Instructions + "; it has" + names);
  }
  options.Command += options.ModelError ? " --model-error" : "";
  options.Command += options.DataError ? " --data-error" : "";
  options.Command += options.Quick ? " --quick" : "";
  for (const auto& option : { std::make_pair(" --filter '", options.Filter),
         std::make_pair(" --methods '", options.Methods) })
  {
    if (option.second != ".")
    {
      options.Command += option.first + option.second + "'";
    }
  }
  options.Command += " --documentation Documentation";
  return options;
}

//------------------------------------------------------------------------------
void List()
{
  std::printf("pictures:\n");
  for (const Picture& picture : GetPictures())
  {
    std::printf("  %s\n", picture.Name);
  }
  std::printf("lights:\n");
  for (const Light& light : GetLights())
  {
    std::printf("  %s\n", light.Name);
  }
  std::printf("integrators:\n");
  for (const Method& method : MakeMethods())
  {
    std::printf("  %s\n", method.Name.c_str());
  }
}
}

//------------------------------------------------------------------------------
int main(int count, char* arguments[])
{
  try
  {
    const Options options = ReadOptions(count, arguments);
    if (options.List)
    {
      List();
      return EXIT_SUCCESS;
    }
    const std::string fault = FindWhyNoDisplay();
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
    if (options.DataError)
    {
      Device device;
      const bool kept =
        MeasureDataErrors(device, { options.Quick, options.Documentation, options.Command });
      return kept ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    if (options.ModelError)
    {
      Device device;
      const bool kept = MeasureModelErrors(
        device, { options.Quick, options.Filter, options.Documentation, options.Command });
      return kept ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    Benchmark benchmark(options);
    benchmark.MeasureSteadyFrame();
    benchmark.MeasureEffect();
    benchmark.MeasureThreads();
    benchmark.MeasureSamples();
    benchmark.MeasurePixels();
    benchmark.MeasureScattering();
    benchmark.Print();
    return !options.Quick || benchmark.Check() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "godrays_benchmark: %s.\n", error.what());
    return EXIT_FAILURE;
  }
}
