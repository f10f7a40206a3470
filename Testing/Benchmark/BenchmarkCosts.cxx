// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What things cost: the whole effect, samples, pixels, threads, and a steady frame.

#include "Benchmark.h"

#include "Counters.h"
#include "EffectScene.h"
#include "Rounds.h"
#include "Statistics.h"

#include "vtkGodRaysScatteringFilter.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace GodRaysPictures;
using namespace Statistics;

namespace
{
std::string GetName(const Benchmark::Size& size)
{
  return std::to_string(size.Width) + "x" + std::to_string(size.Height);
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
      this->AddFigure("exponent of cost against pixels, " + name, Figure::AT_MOST, 1.1,
        FitExponent(pixels, times),
        "0.25 to " + std::to_string(std::lround(1e-6 * pixels.back())) + " million");
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
      this->AddFigure("allocations of vtkGodRays in a steady frame, " + what, Figure::AT_MOST, 0.0,
        counts.Allocations,
        std::to_string(counts.VTKAllocations - plain.VTKAllocations) +
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
