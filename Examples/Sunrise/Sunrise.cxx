// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A short day over a terrain, from dawn to dusk, the camera turning with the sun.
// Usage: Sunrise [picture.png | film.ogv] [1280x720] [elevations.vti] [number of frames]

#include "../ExampleWindow.h"
#include "WriteFilm.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSunPosition.h"
#include "vtkGodRaysTerrainSource.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWarpScalar.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace
{
bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
}

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  std::string output;
  std::string elevations;
  int frames = 120;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    char* rest = nullptr;
    const long number = std::strtol(argv[i], &rest, 10);
    if (EndsWith(argument, ".png") || EndsWith(argument, ".ogv"))
    {
      output = argument;
    }
    else if (EndsWith(argument, ".vti"))
    {
      elevations = argument;
    }
    else if (*rest == '\0' && number > 0 && number <= 1000000)
    {
      frames = static_cast<int>(number);
    }
    else
    {
      std::cerr << argument << " is neither a .png, .ogv or .vti file nor a number of frames.\n"
                << "Usage: Sunrise [picture.png | film.ogv] [elevations.vti] [number of frames]\n";
      return EXIT_FAILURE;
    }
  }

  // In metres; x is east, y north and z up. Real heights are drawn threefold.
  vtkSmartPointer<vtkAlgorithm> heights;
  if (!elevations.empty())
  {
    auto reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
    if (!reader->CanReadFile(elevations.c_str()))
    {
      std::cerr << elevations << " is no picture of VTK: make one with Examples/make_terrain.py.\n";
      return EXIT_FAILURE;
    }
    reader->SetFileName(elevations.c_str());
    heights = reader;
  }
  else
  {
    auto terrain = vtkSmartPointer<vtkGodRaysTerrainSource>::New();
    terrain->SetDimensions(401, 401);
    terrain->SetWidth(30000.0);
    terrain->SetHeight(4000.0);
    terrain->SetFeatures(5.0);
    terrain->SetGain(0.45);
    terrain->SetSeed(4);
    heights = terrain;
  }
  heights->Update();
  auto grid = vtkImageData::SafeDownCast(heights->GetOutputDataObject(0));
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  if (!values || grid->GetDimensions()[2] != 1)
  {
    std::cerr << elevations
              << " has no elevations: one slice of values at its points, in metres. Make "
              << "one with Examples/make_terrain.py.\n";
    return EXIT_FAILURE;
  }
  const double exaggeration = elevations.empty() ? 1.0 : 3.0;
  vtkNew<vtkImageDataGeometryFilter> surface;
  surface->SetInputConnection(heights->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(surface->GetOutputPort());
  warp->SetScaleFactor(exaggeration);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(warp->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  double bounds[6]; // west, east, south, north, low, high
  normals->GetOutput()->GetBounds(bounds);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  ground->GetProperty()->SetColor(0.45, 0.42, 0.33);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);

  vtkNew<vtkLight> sun;
  renderer->AddLight(sun);
  const double center[2] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->SetOrigin(center[0], center[1], bounds[4]);
  vtkNew<vtkGodRaysPass> rays;
  rays->AddLight(sun);
  rays->ApplyPreset("low-sun");
  rays->SetAutomaticExposure(false); // the sky behind says how bright the sun is
  rays->SetIntensity(2.0);
  rays->SetBackgroundGlowFalloff(10.0);
  rays->SurfaceShadowsOn();
  rays->Attach(renderer);

  vtkNew<vtkGodRaysSunPosition> day; // at Jacksboro, Tennessee
  day->SetDate(2024, 12, 21);
  day->SetTimeZone(-5.0);
  day->SetLatitude(36.33);
  day->SetLongitude(-84.18);
  const double dawn = day->GetSunrise() - 0.3; // [h]
  const double dusk = day->GetSunset() + 0.3;
  auto setTime = [&](double hours)
  {
    day->SetTimeOfDay(hours);
    const double elevation = day->GetElevation();
    sky->SetSunElevation(elevation);
    sky->SetSunAzimuth(day->GetAzimuth());
    // As for a camera or an eye, less light is needed of a higher sun.
    const double height = std::max(std::sin(vtkMath::RadiansFromDegrees(elevation)), 0.0);
    sky->SetExposure(3.0 / (1.0 + 1.5 * height));
    sky->UpdateLight(sun);
    // The sun is a little to the right, and low in the picture while it is low.
    const double azimuth = vtkMath::RadiansFromDegrees(day->GetAzimuth() - 8.0);
    const double distance = 0.35 * std::min(bounds[1] - bounds[0], bounds[3] - bounds[2]);
    const double ahead[2] = { distance * std::sin(azimuth), distance * std::cos(azimuth) };
    double eye[3] = { center[0] - ahead[0], center[1] - ahead[1], grid->GetOrigin()[2] };
    const vtkIdType point = grid->FindPoint(eye);
    const double below = eye[2] + values->GetTuple1(point) * exaggeration;
    eye[2] = std::max(0.4 * bounds[4] + 0.6 * bounds[5], below + 0.15 * (bounds[5] - bounds[4]));
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(eye);
    camera->SetFocalPoint(eye[0] + ahead[0], eye[1] + ahead[1], eye[2] + 0.12 * distance);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(50.0);
    camera->SetClippingRange(0.01 * distance, 10.0 * distance);
  };

  setTime(day->GetSunrise() + 0.5);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  if (EndsWith(output, ".ogv"))
  {
    auto show = [&](double part)
    {
      setTime(dawn + (dusk - dawn) * part);
      std::ostringstream text;
      text << day->GetDateTime().substr(11, 5) << ", sun " << std::fixed << std::setprecision(1)
           << day->GetElevation() << " degrees high";
      return text.str();
    };
    return WriteFilm(window, size, output.substr(0, output.size() - 4), frames, show);
  }
  auto advance = [&]() { setTime(day->GetTimeOfDay() < dusk ? day->GetTimeOfDay() + 0.02 : dawn); };
  char* arguments[] = { argv[0], &output[0] };
  return ShowOrWrite(window, size, output.empty() ? 1 : 2, arguments, advance);
}
