// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "Failure.h"

#include <algorithm>
#include <cmath>
#include <string>

//------------------------------------------------------------------------------
void CheckSeries(const Options& options)
{
  const bool isMany = options.Animate || options.Turntable > 0 || options.Each;
  if (!options.Film.empty() && !isMany)
  {
    throw Failure("--film needs more than a picture; give --animate, --turntable or --each");
  }
  if ((options.Animate || options.Turntable > 0) && options.Output.empty() && options.Film.empty())
  {
    throw Failure("--animate and --turntable write pictures; give --output, or --film");
  }
  if (isMany && !options.Interactive && !options.Output.empty() &&
    options.Output.find('{') == std::string::npos)
  {
    throw Failure("--output: '" + options.Output +
      "' is one name for several pictures; put {frame}, {name}, {n} or {time} in it");
  }
  if (options.Interactive && (options.Animate || options.Turntable > 0 || !options.Film.empty()))
  {
    throw Failure("--interactive opens a window; leave out --animate, --turntable and --film");
  }
  if (options.Animate && options.Time)
  {
    throw Failure("--animate shows all time steps, and --time one; leave out one of them");
  }
  const auto has = [&options](const char* word)
  { return options.Output.find(word) != std::string::npos; };
  if (!options.Output.empty() &&
    ((options.Turntable > 1 && !has("{frame}")) ||
      (options.Animate && !has("{frame}") && !has("{time}"))))
  {
    throw Failure(
      "--output: '" + options.Output + "' is one name for several pictures; put {frame} in it");
  }
  if (options.Output == "-" && (options.Stats || (!options.Reference.empty() && !options.Quiet)))
  {
    throw Failure("--output - is a picture on the standard output; leave out --stats, and give "
                  "--quiet with --reference");
  }
  if (options.Quiet && options.Verbose)
  {
    throw Failure("--quiet and --verbose are the reverse of each other; give one of them");
  }
}

//------------------------------------------------------------------------------
void CheckTogether(const Options& options)
{
  if (options.ListPresets || options.ListColormaps)
  {
    return;
  }
  if (options.Files.empty())
  {
    throw Failure("no file to show; name one or more, for example godrays terrain.vtp, or see "
                  "godrays --help");
  }
  if (options.Sun && options.Light)
  {
    throw Failure("--sun and --light are two places for one light; give one of them");
  }
  if (options.Date.empty() == options.Place.has_value())
  {
    throw Failure("--date and --place belong together; give both, or --sun");
  }
  if (options.SunAt && (options.Sun || options.Light || options.Place))
  {
    throw Failure("--sun-at says where the sun is; leave out --sun, --light, --date and --place");
  }
  if (options.Camera && (options.CameraPosition || options.FocalPoint))
  {
    throw Failure(
      "--camera says where the camera is; leave out --camera-position and --focal-point");
  }
  if (options.Camera && std::abs((*options.Camera)[1]) > 90.0)
  {
    throw Failure("--camera: the elevation should be from -90 to 90 degrees");
  }
  if (options.ParallelHeight && !options.Parallel)
  {
    throw Failure("--parallel-height needs --parallel");
  }
  if (options.Transparent && !options.Sky.empty())
  {
    throw Failure("--transparent has no background, and --sky is one; leave out one of them");
  }
  CheckSeries(options);
  if (options.Place && (options.Sun || options.Light))
  {
    throw Failure("--date and --place say where the sun is; leave out --sun and --light");
  }
  if (options.Light && !options.Sky.empty())
  {
    throw Failure("--sky has a sun, and --light is a lamp; leave out one of them");
  }
  if (options.Background != Options().Background && !options.Sky.empty())
  {
    throw Failure("--sky is drawn over --background; leave out one of them");
  }
  if (!options.Hdri.empty() &&
    (options.Background != Options().Background || !options.Sky.empty() || options.Transparent))
  {
    throw Failure("--hdri is the background; leave out --background, --sky and --transparent");
  }
  if (options.Sun && std::abs((*options.Sun)[1]) > 90.0)
  {
    throw Failure("--sun: the elevation should be from -90 to 90 degrees");
  }
  if (options.CameraPosition && options.CameraPosition == options.FocalPoint)
  {
    throw Failure("--camera-position and --focal-point are the same; move one of them");
  }
  if (options.ViewUp && *options.ViewUp == Vector3{ 0.0, 0.0, 0.0 })
  {
    throw Failure("--view-up: 0,0,0 is no direction; give for example 0,0,1");
  }
  if (options.Irradiance && options.Numbers.empty())
  {
    throw Failure("--irradiance belongs to --numbers; give both");
  }
  if (options.Irradiance &&
    std::any_of(options.Irradiance->begin(), options.Irradiance->end(),
      [](double value) { return value < 0.0 || value > 1e30; }))
  {
    throw Failure("--irradiance: each number should be from 0 to 1e30");
  }
  if (!options.Numbers.empty() && !options.Rays)
  {
    throw Failure("--numbers are of rays, and --no-rays leaves them out; drop one of them");
  }
  if (!options.Numbers.empty() &&
    (options.Each || options.Animate || options.Turntable > 0 || !options.Film.empty()))
  {
    throw Failure(
      "--numbers are of one picture; leave out --each, --animate, --turntable and --film");
  }
  if (!options.Numbers.empty() && options.Show == "occlusion")
  {
    throw Failure(
      "--numbers need the rays, and --show occlusion leaves them out; drop one of them");
  }
  if (options.Window &&
    (options.Range || !options.VolumePreset.empty() || (*options.Window)[1] <= 0.0))
  {
    throw Failure(
      "--window has a width above 0, and is in the place of --range and --volume-preset");
  }
  if (options.VolumeMedium && options.Isosurface)
  {
    throw Failure(
      "--volume-medium is of volumes, and --isosurface makes surfaces of them; drop one");
  }
  if (options.Range && (*options.Range)[0] >= (*options.Range)[1])
  {
    throw Failure("--range: the first value should be below the second");
  }
}
