// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the command line asks for.
 */

#ifndef Options_h
#define Options_h

#include "Vectors.h"

#include <array>    // For std::array
#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

struct Options
{
  std::vector<std::string> Files;

  // Light. Azimuth and elevation are in degrees, azimuth clockwise from north as on a map.
  std::optional<std::array<double, 2>> Sun; ///< as given, or of Date and Place
  std::string Date;
  std::optional<std::array<double, 2>> Place;
  std::optional<std::array<double, 2>> SunAt; ///< place in the picture
  std::optional<Vector3> Light;
  std::optional<Vector3> LightColor;
  std::optional<double> LightSize;
  std::optional<double> Fill;

  // Rays: what is not given stays as the preset has it.
  bool Rays = true;
  bool DataFirst = false;
  bool AllOrders = false; ///< of scattering
  bool Shadows = false;   ///< on surfaces
  std::string Preset;
  std::optional<double> Intensity, Density, Decay, Weight, Exposure, Glow, GlowAngle, Tolerance,
    OpticalDepth, WorldUnit;
  std::string Show = "composite";

  // Camera.
  std::optional<Vector3> CameraPosition, FocalPoint, ViewUp;
  std::optional<double> ViewAngle;
  std::optional<std::array<double, 2>> Camera; ///< azimuth and elevation of it from the data
  double Zoom = 1.0;
  std::optional<double> ParallelHeight;
  bool Parallel = false;

  // Look.
  std::string Background = "#040508:#0e1118"; // bottom and top
  std::string Sky;  ///< the atmosphere of a physical sky instead; empty for none
  std::string Hdri; ///< an environment picture instead; empty for none
  std::string Scalars;
  std::string Colormap;
  std::vector<Vector3> Colors; ///< evenly spaced, instead of a map's; the command line has none
  std::optional<std::array<double, 2>> Range;
  std::optional<Vector3> Color;
  double Opacity = 1.0;
  bool Edges = false;
  bool AmbientOcclusion = true;
  bool Flat = false;
  std::optional<double> ElevationScale;
  std::optional<double> Isosurface;
  std::optional<std::array<double, 2>> Window; ///< level and width, of which Range is made
  std::string VolumePreset;
  bool VolumeMedium = false;
  char Up = 0; ///< 'X', 'Y', 'Z', or 0: as is usual for the type of file

  // Output.
  std::array<int, 2> Size = { 1200, 800 };
  std::string Output;
  std::string Numbers;               ///< a file of the numbers of a medium; empty for none
  std::optional<Vector3> Irradiance; ///< [W m-2] of a light of colour 1
  bool Interactive = false;
  bool Transparent = false;
  std::string Reference;
  double Threshold = 10.0;
  bool Quiet = false;
  bool Verbose = false;

  // Several files and times.
  bool Each = false;
  bool Watch = false;
  std::optional<double> Time;
  bool Animate = false;
  int Turntable = 0; ///< how many pictures
  std::string Film;
  double FrameRate = 25.0;

  bool Stats = false;
  bool ListPresets = false;
  bool ListColormaps = false;
  std::string Configuration; ///< a file of options instead of the user's
  bool NoConfiguration = false;
  std::string Document; ///< the kind of one to print

  bool OpensWindow() const
  {
    const bool isWritten = !this->Output.empty() || !this->Film.empty() || !this->Numbers.empty() ||
      !this->Reference.empty();
    return !isWritten || this->Interactive;
  }
};

/**
 * The options in the command line, or nothing when it asked for help or the version, which have
 * then been printed. Throws Failure when there is a mistake in it.
 */
std::optional<Options> ParseCommandLine(int argc, char* argv[]);

#endif
