// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * godrays: shows files with god rays.
 */

#include "Colormaps.h"
#include "Failure.h"
#include "Frames.h"
#include "Messages.h"
#include "Options.h"
#include "Output.h"
#include "Playlist.h"
#include "Presets.h"
#include "Progress.h"
#include "Scene.h"
#include "Stage.h"
#include "StandardInput.h"
#include "Viewer.h"

#include "vtkCamera.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysPass.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
void ListPresets()
{
  for (const Preset& preset : GetPresets())
  {
    std::cout << std::left << std::setw(29) << preset.Name << " " << preset.Description
              << (&preset == &GetPresets().front() ? "; if none is named" : "") << "\n";
  }
}

//------------------------------------------------------------------------------
/**
 * Whether what is given fits the preset.
 */
void CheckPreset(const Options& options)
{
  const bool isMedium =
    options.VolumeMedium || (!options.Preset.empty() && FindPreset(options.Preset).IsMedium);
  if (options.VolumeMedium && !options.Preset.empty() && !FindPreset(options.Preset).IsMedium)
  {
    throw Failure("--volume-medium needs a --preset that is a medium, such as haze, or none");
  }
  if (options.VolumeMedium && options.Preset.empty() && options.OpticalDepth)
  {
    throw Failure(
      "--optical-depth is of a medium beside volumes; name one by --preset, such as haze");
  }
  const std::pair<const char*, bool> others[] = { { "--density", options.Density.has_value() },
    { "--decay", options.Decay.has_value() }, { "--weight", options.Weight.has_value() },
    { "--exposure", options.Exposure.has_value() }, { "--glow", options.Glow.has_value() },
    { "--glow-angle", options.GlowAngle.has_value() } };
  const std::pair<const char*, bool> mediums[] = { { "--optical-depth",
                                                     options.OpticalDepth.has_value() },
    { "--all-orders", options.AllOrders }, { "--world-unit", options.WorldUnit.has_value() } };
  for (const auto& [name, given] : others)
  {
    if (given && isMedium)
    {
      throw Failure(std::string(name) + " belongs to looks, and " +
        (options.Preset.empty() ? "--volume-medium" : "--preset " + options.Preset) +
        " is a medium; take --optical-depth and --intensity");
    }
  }
  for (const auto& [name, given] : mediums)
  {
    const bool isOfSky = name == std::string("--world-unit") && !options.Sky.empty();
    if (given && !isMedium && !isOfSky)
    {
      throw Failure(std::string(name) + " needs a --preset that is a medium, such as fog or haze");
    }
  }
}

//------------------------------------------------------------------------------
std::string ToText(const double values[3])
{
  std::ostringstream text;
  text.precision(9);
  text << values[0] << "," << values[1] << "," << values[2];
  return text.str();
}

//------------------------------------------------------------------------------
void PrintScene(const Scene& scene, const OpeningTimes& times, double drawing)
{
  double lengths[3];
  scene.Bounds.GetLengths(lengths);
  std::cout << "scene      " << scene.NumberOfCells << " cells, " << scene.NumberOfVoxels
            << " voxels, " << lengths[0] << " x " << lengths[1] << " x " << lengths[2];
  if (scene.ElevationScale != 1.0)
  {
    std::cout << ", heights times " << scene.ElevationScale;
  }
  std::cout << "\n";
  for (const std::string& name : scene.Arrays)
  {
    std::cout << "colours    by " << name << "\n";
  }
  std::cout << "read in    " << times.Reading << " s\nprepared   in " << times.Preparing
            << " s\ndrawn in   " << drawing << " s\n";
}

//------------------------------------------------------------------------------
void PrintView(const Scene& scene, const Viewpoint& view, vtkCamera* camera)
{
  std::cout << "camera     --camera-position " << ToText(camera->GetPosition()) << " --focal-point "
            << ToText(camera->GetFocalPoint()) << " --view-up " << ToText(camera->GetViewUp());
  if (camera->GetParallelProjection())
  {
    std::cout << " --parallel --parallel-height " << 2.0 * camera->GetParallelScale() << "\n";
  }
  else
  {
    std::cout << " --view-angle " << camera->GetViewAngle() << "\n";
  }
  double azimuth = 0.0;
  double elevation = 0.0;
  scene.GetAngles(view.LightDirection, azimuth, elevation);
  std::cout << "light      ";
  if (view.LightIsLamp)
  {
    std::cout << "--light " << ToText(view.LightPosition.data());
  }
  else
  {
    std::cout << "--sun " << azimuth << "," << elevation;
  }
  std::cout << (view.LightWasChosen ? " (chosen)\n" : "\n");
}

//------------------------------------------------------------------------------
void PrintRays(vtkGodRaysPass* rays, vtkRenderWindow* window, bool on)
{
  if (!on)
  {
    std::cout << "rays       none, as --no-rays has it\n";
    return;
  }
  std::cout << "plan\n";
  std::istringstream plan(rays->GetPlan());
  for (std::string line; std::getline(plan, line);)
  {
    std::cout << "  " << line << "\n";
  }
  double seconds[4];
  rays->GetStageTimes(seconds);
  const char* names[4] = { "scene", "occlusion", "scattering", "blend" };
  std::cout << "stage times\n";
  for (int i = 0; i < 4; ++i)
  {
    std::cout << "  " << std::left << std::setw(11) << names[i] << 1000.0 * seconds[i] << " ms\n";
  }

  // measured in a frame of its own, as it takes time
  const int pixels = 1024;
  vtkGodRaysIntegrator* integrator = rays->GetIntegrator();
  integrator->SetVerifyPixels(pixels);
  window->Render();
  if (integrator->GetErrorEstimate() >= 0.0)
  {
    std::cout << "error      " << integrator->GetErrorEstimate()
              << " of the brightest ray, root mean square; largest "
              << integrator->GetLargestVerifiedError() << "; at up to " << pixels << " pixels\n";
  }
  integrator->SetVerifyPixels(0);
}

//------------------------------------------------------------------------------
void ShowLines(const std::vector<std::string>& lines)
{
  for (const std::string& line : lines)
  {
    Messages::Show("godrays: " + line + "\n");
  }
}

//------------------------------------------------------------------------------
/**
 * Tell of what VTK said while it drew: each warning once, but for those told already. Returns whether there
 * was an error.
 */
bool TellMessages(const Messages& messages, std::set<std::string>& told, bool quiet)
{
  for (const std::string& warning : messages.GetWarnings())
  {
    if (told.insert(warning).second && !quiet)
    {
      ShowLines({ warning });
    }
  }
  ShowLines(messages.GetErrors());
  return !messages.GetErrors().empty();
}

/// Which scene of a list, at which time.
struct Position
{
  std::size_t Item;
  std::size_t Step;
};

//------------------------------------------------------------------------------
/**
 * Turns the camera about the middle of the data and the axis that points up, and with it a light that the
 * program has chosen, so that each picture has rays.
 */
void TurnView(Stage& stage, double degrees)
{
  const Scene& scene = stage.GetScene();
  double center[3];
  scene.Bounds.GetCenter(center);
  vtkNew<vtkTransform> turn;
  turn->Translate(center);
  turn->RotateWXYZ(degrees, scene.Up.data());
  turn->Translate(-center[0], -center[1], -center[2]);
  stage.GetRenderer()->GetActiveCamera()->ApplyTransform(turn);
  stage.GetRenderer()->ResetCameraClippingRange();
  Viewpoint view = stage.GetOriginalView();
  if (view.LightWasChosen)
  {
    turn->TransformVector(view.LightDirection.data(), view.LightDirection.data());
    turn->TransformPoint(view.LightPosition.data(), view.LightPosition.data());
    if (view.LampInMedium)
    {
      turn->TransformPoint(view.LampInMedium->data(), view.LampInMedium->data());
    }
    stage.TakeLight(view);
  }
}

//------------------------------------------------------------------------------
/**
 * Throws Failure when the picture is not as the reference.
 */
void Compare(vtkRenderWindow* window, const Options& options)
{
  const double error = CompareWithReference(window, options.Reference);
  std::ostringstream text;
  text << "the error against " << options.Reference << " is " << error;
  if (error > options.Threshold)
  {
    text << ", more than --threshold " << options.Threshold;
    throw Failure(text.str(), Failure::Difference);
  }
  if (!options.Quiet)
  {
    std::cout << text.str() << "\n";
  }
}

//------------------------------------------------------------------------------
/**
 * Draw, and write or print what the options ask for. Returns whether all went well.
 */
bool DrawFrames(vtkRenderWindow* window, std::unique_ptr<Stage>& stage, Playlist& list,
  const Options& options, const Position& at, Frames& frames)
{
  const bool isWindow = options.OpensWindow();
  const Messages messages(!isWindow,
    "godrays: the display cannot draw, or not with OpenGL 3.2; see that it is there, and its "
    "driver "
    "(Debian: libgl1-mesa-dri)",
    Failure::Display);
  vtkRenderer* renderer = stage->GetRenderer();
  window->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();
  const auto& times = list.GetTimes();
  const auto time =
    list.GetStep() < times.size() ? std::optional<double>(times[list.GetStep()]) : std::nullopt;
  const int views = std::max(options.Turntable, 1);
  for (int i = 0; i < views; ++i)
  {
    const double start = GetSeconds();
    {
      const Waiting waiting("drawing");
      window->Render();
    }
    const double drawing = GetSeconds() - start;
    if (options.Verbose)
    {
      Messages::Show(
        "godrays: " + list.GetName(at.Item) + " drawn in " + std::to_string(drawing) + " s\n");
    }
    if (isWindow)
    {
      Viewer(window, stage, list, options).Run();
      renderer = stage->GetRenderer();
    }
    frames.Write(window, list.GetName(at.Item), at.Item + 1, time, list.GetFiles());
    if (!options.Numbers.empty())
    {
      CheckNumbers(options.Numbers, list.GetFiles());
      WriteNumbers(stage->GetRays(), options.Irradiance, options.Numbers);
    }
    if (!options.Reference.empty())
    {
      Compare(window, options);
    }
    if (options.Stats && i == 0)
    {
      PrintScene(stage->GetScene(), list.GetOpeningTimes(), drawing);
      PrintView(stage->GetScene(), stage->GetView(), renderer->GetActiveCamera());
      PrintRays(stage->GetRays(), window, stage->AreRaysOn());
    }
    TurnView(*stage, 360.0 / views);
  }
  window->RemoveRenderer(renderer);
  static std::set<std::string> told; // a film would say it again in each frame
  if (options.Each)
  {
    told.clear();
  }
  std::istringstream advice(list.WasAdvised() ? stage->GetRays()->GetAdvice() : "");
  for (std::string line; std::getline(advice, line);)
  {
    told.insert(line); // in the program's own words
  }
  stage.reset();
  return !TellMessages(messages, told, options.Quiet);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(const Options& options)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(!options.OpensWindow());
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName("godrays");
  window->SetAlphaBitPlanes(options.Transparent);
  return window;
}

//------------------------------------------------------------------------------
/**
 * Draw all scenes in all times to where the options say. Returns whether all went well.
 */
bool DrawAll(const Options& options)
{
  Playlist list(options);
  Frames frames(options);
  vtkSmartPointer<vtkRenderWindow> window;
  bool isGood = true;
  const std::size_t items = options.OpensWindow() ? 1 : list.GetSize();
  for (std::size_t item = 0; item < items; ++item)
  {
    std::size_t steps = 1;
    std::optional<Viewpoint> view; // that of the first step
    for (std::size_t step = 0; step < steps; ++step)
    {
      auto stage = list.Open(item, step, view ? &*view : nullptr);
      if (options.Verbose)
      {
        const OpeningTimes& took = list.GetOpeningTimes();
        Messages::Show("godrays: " + list.GetName(item) + " read in " +
          std::to_string(took.Reading) + " s, prepared in " + std::to_string(took.Preparing) +
          " s\n");
      }
      if (!view)
      {
        if (!window)
        {
          window = MakeWindow(options);
        }
        view = stage->GetOriginalView();
      }
      if (options.Animate)
      {
        steps = std::max<std::size_t>(list.GetTimes().size(), 1);
      }
      isGood = DrawFrames(window, stage, list, options, { item, step }, frames) && isGood;
    }
  }
  frames.Finish();
  return isGood;
}

//------------------------------------------------------------------------------
int Run(int argc, char* argv[])
{
  auto options = ParseCommandLine(argc, argv);
  if (!options)
  {
    return EXIT_SUCCESS;
  }
  if (options->ListPresets || options->ListColormaps)
  {
    if (options->ListPresets)
    {
      ListPresets();
    }
    if (options->ListColormaps)
    {
      std::cout << GetColormapNames("\n") << "\n";
    }
    return EXIT_SUCCESS;
  }
  CheckPreset(*options);
  if (!options->Numbers.empty())
  {
    CheckNumbers(options->Numbers, options->Files);
  }
  Progress::SetQuiet(options->Quiet);
  const StandardInput input(options->Files);
  return DrawAll(*options) ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::bad_alloc&)
  {
    Messages::Show("godrays: there is not enough memory; give fewer or smaller files\n");
  }
  catch (const Failure& failure)
  {
    Messages::Show(std::string("godrays: ") + failure.what() + "\n");
    return failure.Code;
  }
  catch (const std::exception& failure)
  {
    Messages::Show(std::string("godrays: ") + failure.what() + "\n");
  }
  return EXIT_FAILURE;
}
