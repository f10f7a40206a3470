// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture of the whole sky: its radiance as .hdr, or as .png to look at.

#include "vtkGodRaysHDRWriter.h"
#include "vtkGodRaysSkySource.h"
#include "vtkGodRaysSunPosition.h"
#include "vtkGodRaysToneMappingFilter.h"
#include "vtkImageEllipsoidSource.h"
#include "vtkImageMask.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace
{
int ExplainUsage()
{
  std::cerr << "Usage: SkyImage picture.hdr|picture.png [paraboloid|equirectangular|fisheye]\n"
               "                [time latitude longitude | elevation azimuth]\n"
               "Times are as 2024-06-21T20:45+02:00; angles are in degrees, azimuths from north "
               "by east.\n";
  return EXIT_FAILURE;
}

int Write(vtkImageWriter* writer, vtkAlgorithm* input, const std::string& name)
{
  writer->SetInputConnection(input->GetOutputPort());
  writer->SetFileName(name.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkGodRaysSkySource> sky;
  sky->SetResolution(256);
  sky->SunDiscOn();
  sky->MultipleScatteringOn();
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::map<std::string, int> mappings = { { "paraboloid", vtkGodRaysSkySource::PARABOLOID },
    { "equirectangular", vtkGodRaysSkySource::EQUIRECTANGULAR },
    { "fisheye", vtkGodRaysSkySource::FISHEYE } };
  if (arguments.size() > 1 && mappings.count(arguments[1]))
  {
    sky->SetMapping(mappings.at(arguments[1]));
    arguments.erase(arguments.begin() + 1);
  }
  const std::string output = arguments.empty() ? "" : arguments[0];
  const bool radiance = output.size() > 4 && output.rfind(".hdr") == output.size() - 4;
  if (!radiance && (output.size() <= 4 || output.rfind(".png") != output.size() - 4))
  {
    return ExplainUsage();
  }

  double numbers[2] = { 43.77, 11.26 }; // Florence on an evening in June
  vtkNew<vtkGodRaysSunPosition> sun;
  sun->SetDateTime("2024-06-21T20:00+02:00");
  if (arguments.size() == 3 || arguments.size() == 4)
  {
    for (int i = 0; i < 2; ++i)
    {
      const std::string& text = arguments[arguments.size() - 2 + i];
      char* end = nullptr;
      numbers[i] = std::strtod(text.c_str(), &end);
      if (text.empty() || *end != '\0')
      {
        return ExplainUsage();
      }
    }
  }
  else if (arguments.size() != 1)
  {
    return ExplainUsage();
  }
  if (arguments.size() != 3)
  {
    if (arguments.size() == 4 && !sun->SetDateTime(arguments[1]))
    {
      return EXIT_FAILURE;
    }
    sun->SetLatitude(numbers[0]);
    sun->SetLongitude(numbers[1]);
    numbers[0] = sun->GetElevation();
    numbers[1] = sun->GetAzimuth();
  }
  sky->SetSunElevation(numbers[0]);
  sky->SetSunAzimuth(numbers[1]);

  if (radiance)
  {
    return Write(vtkNew<vtkGodRaysHDRWriter>(), sky, output);
  }
  vtkNew<vtkGodRaysToneMappingFilter> shown;
  shown->SetInputConnection(sky->GetOutputPort());
  shown->SetKey(0.36); // a bright picture
  if (sky->GetMapping() == vtkGodRaysSkySource::EQUIRECTANGULAR)
  {
    return Write(vtkNew<vtkPNGWriter>(), shown, output);
  }
  // The corners, which look down, are black.
  const int size = sky->GetResolution();
  vtkNew<vtkImageEllipsoidSource> circle;
  circle->SetWholeExtent(0, size - 1, 0, size - 1, 0, 0);
  circle->SetCenter(0.5 * (size - 1), 0.5 * (size - 1), 0.0);
  circle->SetRadius(0.5 * size, 0.5 * size, 1.0);
  vtkNew<vtkImageMask> upper;
  upper->SetInputConnection(0, shown->GetOutputPort());
  upper->SetInputConnection(1, circle->GetOutputPort());
  return Write(vtkNew<vtkPNGWriter>(), upper, output);
}
