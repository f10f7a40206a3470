// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "Colormaps.h"
#include "Failure.h"
#include "Presets.h"
#include "Suggestions.h"
#include "Values.h"
#include "Volumes.h"

#include "vtkGodRaysAtmosphere.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

namespace
{
const std::string Airs = "earth-clear, earth-hazy, earth-polluted, mars, lodato-2015";

//------------------------------------------------------------------------------
/**
 * Adds options of one value to a parser. Each has its own sentence for a wrong value, with what it
 * should be.
 */
class Parser
{
public:
  explicit Parser(CLI::App& app)
    : App(app)
  {
  }

  template <std::size_t N>
  void Add(const std::string& name, std::optional<std::array<double, N>>& target,
    const std::string& form, const std::string& help)
  {
    this->AddCall(name, form, help,
      [name, form, &target](const std::string& text)
      {
        std::array<double, N> values{};
        if (!ReadNumbers(text, values))
        {
          throw Failure(name + ": " + Quoted(text) + " should be " + form + ", " +
            std::to_string(N) + " numbers with commas between them");
        }
        target = values;
      });
  }

  template <typename T>
  void Add(const std::string& name, T& target, double low, double high, const std::string& help)
  {
    this->AddCall(name, "NUMBER", help,
      [name, low, high, &target](const std::string& text)
      {
        double value = 0.0;
        if (!ReadNumber(text, value) || value < low || value > high)
        {
          std::ostringstream message;
          message << name << ": " << Quoted(text) << " should be a number from " << low << " to "
                  << high;
          throw Failure(message.str());
        }
        target = value;
      });
  }

  void AddCall(const std::string& name, const std::string& form, const std::string& help,
    const std::function<void(const std::string&)>& call)
  {
    const auto checked = [name, call](const std::string& text)
    {
      if (text.empty())
      {
        throw Failure(name.substr(name.find("--")) + ": needs a value; see godrays --help");
      }
      call(text);
    };
    this->App.add_option_function<std::string>(name, checked, help)
      ->take_last()
      ->type_name(form)
      ->group(this->Group);
  }

  void AddFlag(const std::string& name, bool& target, const std::string& help)
  {
    this->App.add_flag(name, target, help)->group(this->Group);
  }

  CLI::App& App;
  std::string Group;
};

//------------------------------------------------------------------------------
void AddLightOptions(Parser& parser, Options& options)
{
  parser.Group = "Light";
  parser.Add("--sun", options.Sun, "AZIMUTH,ELEVATION",
    "Where the sun is, in degrees: azimuth clockwise from north as on a map (0 north, 90 east), "
    "elevation above the horizon. Without --sun and --light a place is chosen that gives shafts");
  parser.AddCall("--date", "ISO8601",
    "Instead of --sun, with --place: date, time and zone there, as in 2024-06-21T19:30+02:00",
    [&options](const std::string& text) { options.Date = text; });
  parser.Add("--place", options.Place, "LAT,LON",
    "Latitude and longitude of the scene in degrees, positive to the north and to the east");
  parser.Add("--sun-at", options.SunAt, "X,Y",
    "Instead of --sun: the place of the picture behind which the sun is, from 0,0 at the lower "
    "left to "
    "1,1 at the upper right");
  parser.Add("--light", options.Light, "X,Y,Z", "A lamp at this point instead of the sun");
  parser.AddCall("--light-color", "COLOR", "Colour of the sun or lamp: r,g,b, #rrggbb or a name",
    [&options](const std::string& text)
    { options.LightColor = ParseColor("--light-color", text); });
  parser.Add("--light-size", options.LightSize, 1e-6, 1e30,
    "Radius of the sun in degrees, or of the lamp in world units");
  parser.Add("--fill", options.Fill, 0.0, 10.0,
    "Light from the eye on the data; 1 is VTK's headlight (0.88, or 1 where an array colours "
    "them). With --sky the sun and the sky light the data instead (0)");
}

//------------------------------------------------------------------------------
void AddRayOptions(Parser& parser, Options& options)
{
  parser.Group = "Rays";
  parser.AddCall("--preset", "NAME", "A named look or medium: see --list-presets",
    [&options](const std::string& text) { options.Preset = text; });
  parser.Add("--intensity", options.Intensity, 0.0, 1e4,
    "Factor on all rays, beside the one that suits the picture");
  parser.Add("--density", options.Density, 0.0, 2.0, "Length of the rays, to the light at 1");
  parser.Add(
    "--decay", options.Decay, 0.0, 1.05, "What remains of the light from sample to sample");
  parser.Add("--weight", options.Weight, 0.0, 100.0,
    "Weight of each sample; with it or --exposure, the picture chooses no strength");
  parser.Add("--exposure", options.Exposure, 0.0, 100.0, "Factor on the sum of the samples");
  parser.Add("--glow", options.Glow, 0.0, 1.0,
    "Radiance of the open background about the light, as a fraction of the light's (1)");
  parser.Add("--glow-angle", options.GlowAngle, 0.0, 180.0,
    "Angle from the light over which that glow falls to 0, in degrees (3.6)");
  parser.Add("--optical-depth", options.OpticalDepth, 1e-6, 100.0,
    "How thick a medium is across the scene, in green: 1 lets a third of the light through (0.15 "
    "to 0.6)");
  parser.AddFlag("--all-orders", options.AllOrders,
    "A medium scatters light again and again, as clouds and fog do, instead of once");
  parser.Add("--world-unit", options.WorldUnit, 1e-12, 1e12,
    "How long the scene's unit is in metres; a medium is as dense as suits the scene without it");
  parser.Add("--tolerance", options.Tolerance, 1e-6, 0.1,
    "Error that the rays may have, as a fraction of the brightest possible");
  parser.AddFlag("--data-first", options.DataFirst,
    "Rays change nothing of the data's colours but their lightness, and that by at most 10 of 100 "
    "(CIE "
    "1976 L*): for figures whose colours stand for numbers");
  parser.AddFlag("--shadows", options.Shadows,
    "Lights cast shadows on surfaces, too; with --no-rays they are alone");
  parser.App
    .add_flag_function(
      "--no-rays", [&options](std::int64_t) { options.Rays = false; },
      "The same picture without rays")
    ->group(parser.Group);
  parser.AddCall("--show", "WHAT", "composite (the scene with rays), occlusion or rays",
    [&options](const std::string& text)
    {
      if (text != "composite" && text != "occlusion" && text != "rays")
      {
        throw Failure("--show: " + Quoted(text) + " should be composite, occlusion or rays");
      }
      options.Show = text;
    });
}

//------------------------------------------------------------------------------
void AddCameraOptions(Parser& parser, Options& options)
{
  parser.Group = "Camera";
  parser.Add("--camera", options.Camera, "AZIMUTH,ELEVATION",
    "Where the camera is, seen from the middle of the data, in degrees as for --sun; as far away "
    "as shows all of it");
  parser.Add("--zoom", options.Zoom, 1e-3, 1e3, "How many times as near the camera is (1)");
  parser.Add("--camera-position", options.CameraPosition, "X,Y,Z", "Where the camera is");
  parser.Add("--focal-point", options.FocalPoint, "X,Y,Z", "What the camera looks at");
  parser.Add("--view-up", options.ViewUp, "X,Y,Z", "What is up in the picture");
  parser.Add("--view-angle", options.ViewAngle, 1.0, 170.0, "Height of the view in degrees");
  parser.AddFlag("--parallel", options.Parallel, "Parallel projection");
  parser.Add("--parallel-height", options.ParallelHeight, 1e-15, 1e15,
    "Height of the view with --parallel, in world units");
  parser.AddCall("--up", "AXIS",
    "Axis of the data that points up: X, Y or Z. Y for .gltf and .glb, guessed from the extents of "
    ".obj, .ply and .stl, else Z",
    [&options](const std::string& text)
    {
      const std::string axes = "XYZ";
      const char axis = static_cast<char>(text.empty() ? 0 : std::toupper(text[0]));
      if (text.size() != 1 || axes.find(axis) == std::string::npos)
      {
        throw Failure("--up: " + Quoted(text) + " should be X, Y or Z");
      }
      options.Up = axis;
    });
}

//------------------------------------------------------------------------------
void AddLookOptions(Parser& parser, Options& options)
{
  parser.Group = "Look";
  parser.AddCall("--background", "COLOR",
    "A colour, or two with a colon between them, bottom:top. Colours are r,g,b, #rrggbb or "
    "names (#040508:#0e1118)",
    [&options](const std::string& text)
    {
      options.Background = text;
      for (std::size_t begin = 0; begin <= text.size();)
      {
        const auto end = std::min(text.find(':', begin), text.size());
        ParseColor("--background", text.substr(begin, end - begin));
        begin = end + 1;
      }
      if (std::count(text.begin(), text.end(), ':') > 1)
      {
        throw Failure("--background: " + Quoted(text) + " has more than two colours");
      }
    });
  parser.AddCall("--sky", "AIR",
    "The physical sky instead, in the sun's own colours, its light on the data, and air before the "
    "scene: " +
      Airs + "; see --world-unit",
    [&options](const std::string& text)
    {
      vtkNew<vtkGodRaysAtmosphere> atmosphere;
      vtkObject::GlobalWarningDisplayOff(); // it is told below
      const bool known = atmosphere->LoadPreset(text);
      vtkObject::GlobalWarningDisplayOn();
      if (!known)
      {
        throw Failure(
          "--sky: " + Quoted(text) + " should be one of " + Airs + Suggest(text, Split(Airs)));
      }
      options.Sky = text;
    });
  parser.AddCall("--hdri", "FILE",
    "An environment picture, a .hdr as wide as twice its height, as the background and as light on "
    "surfaces in place of --fill; its middle is to the north. The sun stays where it is asked for",
    [&options](const std::string& text) { options.Hdri = text; });
  parser.AddCall("--scalars", "NAME", "Array to colour by, or none",
    [&options](const std::string& text) { options.Scalars = text; });
  parser.AddCall("--colormap", "NAME", "Colours of the array: see --list-colormaps",
    [&options](const std::string& text)
    {
      if (!HasColormap(text))
      {
        throw Failure("--colormap: " + Quoted(text) + " should be one of " +
          GetColormapNames(", ") + Suggest(text, Split(GetColormapNames(","))));
      }
      options.Colormap = text;
    });
  parser.Add("--range", options.Range, "LOW,HIGH", "Values at the ends of the colour map");
  parser.AddCall("--color", "COLOR", "Colour of surfaces that have no array",
    [&options](const std::string& text) { options.Color = ParseColor("--color", text); });
  parser.Add("--opacity", options.Opacity, 0.0, 1.0, "Opacity of surfaces");
  parser.AddFlag("--edges", options.Edges, "Draw the edges of the cells");
  parser.App
    .add_flag_function(
      "--no-ambient-occlusion", [&options](std::int64_t) { options.AmbientOcclusion = false; },
      "Surfaces without the shade that they have where little of their surroundings is open")
    ->group(parser.Group);
  parser.AddFlag("--flat", options.Flat, "Draw elevation pictures flat");
  parser.AddCall("--elevation-scale", "FACTOR",
    "Vertical exaggeration; auto, for elevation pictures, makes them neither flat nor steep",
    [&options](const std::string& text)
    {
      double value = 0.0;
      if (text == "auto")
      {
        options.ElevationScale.reset();
      }
      else if (!ReadNumber(text, value) || value <= 0.0 || value > 1e9)
      {
        throw Failure(
          "--elevation-scale: " + Quoted(text) + " should be a number above 0, or auto");
      }
      else
      {
        options.ElevationScale = value;
      }
    });
  parser.Add("--window", options.Window, "LEVEL,WIDTH",
    "Of volumes: the values in the middle of those shown, and how far they range, as radiologists "
    "have it; opacity goes from 0 to its most there");
  parser.AddCall("--volume-preset", "NAME",
    "Opacities and colours of a CT volume, in Hounsfield units: " + Join(GetVolumePresets(), ", "),
    [&options](const std::string& text)
    {
      const auto names = GetVolumePresets();
      if (std::find(names.begin(), names.end(), text) == names.end())
      {
        throw Failure("--volume-preset: " + Quoted(text) + " should be one of " +
          Join(names, ", ") + Suggest(text, names));
      }
      options.VolumePreset = text;
    });
  parser.AddFlag("--volume-medium", options.VolumeMedium,
    "Volumes scatter light, as smoke does, in the medium of --preset or alone; opacities are as "
    "those of volumes");
  parser.Add("--isosurface", options.Isosurface, -1e300, 1e300,
    "Draw 3-D images as the surface of this value instead of as a volume");
}

//------------------------------------------------------------------------------
void AddOutputOptions(Parser& parser, Options& options)
{
  parser.Group = "Output";
  parser.AddCall("--size", "WxH", "Width and height of the picture in pixels (1200x800)",
    [&options](const std::string& text)
    {
      int length = 0;
      auto& size = options.Size;
      const bool read = std::sscanf(text.c_str(), "%5dx%5d%n", &size[0], &size[1], &length) == 2;
      const bool whole = read && static_cast<std::size_t>(length) == text.size();
      if (!whole || size[0] < 8 || size[1] < 8 || size[0] > 16384 || size[1] > 16384)
      {
        throw Failure("--size: " + Quoted(text) +
          " should be WIDTHxHEIGHT in pixels, each from 8 to 16384, for example 1200x800");
      }
    });
  parser.AddCall("-o,--output", "FILE",
    "Write the picture to this .png or .jpg, or as linear light, of which 1 is white, to this .exr "
    "or .hdr, without a window; - is a PNG to the standard output. {name} is the name of the first "
    "file, {n} the number of the file, {frame} that of the picture, {time} the time step's",
    [&options](const std::string& text) { options.Output = text; });
  parser.AddCall("--numbers", "FILE",
    "Write what a medium is in numbers, for each pixel, to this .vti or .exr, without a window: "
    "radiance, transmittance, optical depth, depth, contrast, range; needs a --preset that is a "
    "medium",
    [&options](const std::string& text) { options.Numbers = text; });
  parser.Add("--irradiance", options.Irradiance, "R,G,B",
    "Irradiance of a white light [W/m2], for the radiance of --numbers; relative to it without");
  parser.AddFlag("--interactive", options.Interactive,
    "Open a window, also with --output, which is then written when it closes");
  parser.AddFlag("--transparent", options.Transparent,
    "Leave the background out of a .png or .exr: its opacity there is 0");
  parser.AddCall("--reference", "FILE",
    "Compare the picture with this one, as VTK's tests do, and end with 5 if it differs",
    [&options](const std::string& text) { options.Reference = text; });
  parser.Add("--threshold", options.Threshold, 0.0, 1e9,
    "Error up to which a picture is as its reference, in the unit of vtkImageDifference (10)");
  parser.AddFlag("--quiet", options.Quiet, "No notes, and no progress: failures alone are told");
  parser.AddFlag("--verbose", options.Verbose, "Tell of each step, and how long it took");
  parser.AddFlag("--stats", options.Stats,
    "Print what was drawn, how, how long it took, and how exact the rays are");
  parser.AddFlag("--list-presets", options.ListPresets, "List the named looks and media");
  parser.AddFlag("--list-colormaps", options.ListColormaps, "List the colour maps");
}

//------------------------------------------------------------------------------
void AddSeriesOptions(Parser& parser, Options& options)
{
  parser.Group = "Several files, times and views";
  parser.AddFlag("--each", options.Each,
    "Show the files one after another instead of together; with --output, write a picture of each");
  parser.AddFlag("--watch", options.Watch, "In the window, read files again when they are written");
  parser.AddCall("--time", "NUMBER", "Show the time step nearest to this time (the first one)",
    [&options](const std::string& text)
    {
      double value = 0.0;
      if (!ReadNumber(text, value))
      {
        throw Failure("--time: " + Quoted(text) + " should be a number");
      }
      options.Time = value;
    });
  parser.AddFlag("--animate", options.Animate, "Write a picture of each time step");
  parser.AddCall("--turntable", "COUNT",
    "Write this many pictures, between which the camera goes about the data once; with the light, "
    "unless that is given",
    [&options](const std::string& text)
    {
      double value = 0.0;
      if (!ReadNumber(text, value) || value < 1.0 || value > 100000.0 || value != std::floor(value))
      {
        throw Failure(
          "--turntable: " + Quoted(text) + " should be a whole number from 1 to 100000");
      }
      options.Turntable = static_cast<int>(value);
    });
  parser.AddCall("--film", "FILE",
    "Join the pictures of --animate, --turntable or --each to a film: .ogv, or with ffmpeg, which "
    "is to be installed, .mp4, .webm, .mkv or .gif",
    [&options](const std::string& text) { options.Film = text; });
  parser.Add("--frame-rate", options.FrameRate, 0.1, 240.0, "Pictures a second of a film (25)");
}
}

//------------------------------------------------------------------------------
void AddOptions(CLI::App& app, Options& options)
{
  app.add_option("files", options.Files,
    "Files to show together; - is the standard input, of a type that its first bytes tell");
  Parser parser(app);
  AddLightOptions(parser, options);
  AddRayOptions(parser, options);
  AddCameraOptions(parser, options);
  AddLookOptions(parser, options);
  AddOutputOptions(parser, options);
  AddSeriesOptions(parser, options);
  parser.AddCall("--config", "FILE",
    "Read options from this file instead of godrays/config in XDG_CONFIG_HOME or ~/.config",
    [&options](const std::string& text) { options.Configuration = text; });
  parser.AddFlag("--no-config", options.NoConfiguration, "Read no file of options");
  parser.Group = ""; // for the build: not in --help
  parser.AddCall("--document", "KIND", "Print a document",
    [&options](const std::string& text) { options.Document = text; });
}

//------------------------------------------------------------------------------
std::vector<OptionRow> GetRows(const CLI::App& app)
{
  std::vector<OptionRow> rows;
  for (const CLI::Option* option : app.get_options())
  {
    if (option->get_lnames().empty() || option->get_group().empty())
    {
      continue;
    }
    OptionRow row;
    for (const std::string& name : option->get_snames())
    {
      row.Names.push_back("-" + name);
    }
    for (const std::string& name : option->get_lnames())
    {
      row.Names.push_back("--" + name);
    }
    row.Form = option->get_items_expected_max() == 0 ? "" : option->get_type_name();
    row.Help = option->get_description();
    row.Group = option->get_group();
    const std::string& name = option->get_lnames().front();
    if (name == "preset")
    {
      for (const Preset& preset : GetPresets())
      {
        row.Choices.push_back(preset.Name);
      }
    }
    else if (name == "volume-preset")
    {
      row.Choices = GetVolumePresets();
    }
    else if (name == "colormap" || name == "sky")
    {
      row.Choices = Split(name == "sky" ? Airs : GetColormapNames(","));
    }
    else if (name == "show")
    {
      row.Choices = { "composite", "occlusion", "rays" };
    }
    else if (name == "up")
    {
      row.Choices = { "X", "Y", "Z" };
    }
    rows.push_back(row);
  }
  return rows;
}
