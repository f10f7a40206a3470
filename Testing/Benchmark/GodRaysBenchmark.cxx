// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// godrays_benchmark: speed and error of the integrators, and the figures that are asked for.
// See Help below.

#include "Benchmark.h"
#include "DataErrors.h"
#include "Device.h"
#include "GodRaysPictures.h"
#include "Methods.h"
#include "ModelErrors.h"

#include "vtkGodRaysSweepKernels.h"

#include <cstdio>
#include <cstdlib>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>

using namespace GodRaysPictures;

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
                         scenes; FOLDER/ModelError.md, its table, chart and pictures. Names for
                         --filter: SCENE/LIGHT. Some 4 minutes
  --data-error           measure something else: media of data; FOLDER/DataError.md, its chart and picture
  --list                 list pictures, lights and integrators, and measure nothing
  --help                 this text

Pictures, lights and the model (density 0.97, decay 0.99) are the same every time. The light's march
is capped as vtkGodRaysPass does it. Layers hold 16-bit floats (32-bit where an integrator asks for
them), the same values in both.

It needs a display, if VTK has no EGL or is older than 9.4:
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" godrays_benchmark
)";
//------------------------------------------------------------------------------
BenchmarkOptions ReadOptions(int count, char* arguments[])
{
  BenchmarkOptions options;
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
    const BenchmarkOptions options = ReadOptions(count, arguments);
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
