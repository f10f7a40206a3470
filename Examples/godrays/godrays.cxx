// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * godrays: shows files with god rays.
 */

#include "Advice.h"
#include "Colormaps.h"
#include "Failure.h"
#include "Files.h"
#include "Messages.h"
#include "Options.h"
#include "Output.h"
#include "Presets.h"
#include "Scene.h"
#include "Sky.h"
#include "Viewpoint.h"

#include "vtkCamera.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
// [degrees] a look: larger than the real sun, which vtkGodRaysSun and the sky of --sky have, to be seen
constexpr double SunRadius = 0.6;
// brighter and narrower than the pass has it: shafts with more contrast
constexpr double Glow = 0.6;
constexpr double GlowRadius = 1.0;
constexpr double SunGlowAngle = 5.0;
constexpr double LampGlowAngle = 14.0;
constexpr double SkyExposure = 2.5; // a white wall in the sun is about as bright as can be shown

/// What --stats tells apart from the pass's own plan and times.
struct Measured
{
  double Reading = 0.0;
  double Preparing = 0.0;
  double Drawing = 0.0;
};

//------------------------------------------------------------------------------
double GetSeconds()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

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
  const bool isMedium = !options.Preset.empty() && FindPreset(options.Preset).IsMedium;
  const std::pair<const char*, bool> others[] = { { "--density", options.Density.has_value() },
    { "--decay", options.Decay.has_value() }, { "--weight", options.Weight.has_value() },
    { "--exposure", options.Exposure.has_value() }, { "--glow", options.Glow.has_value() },
    { "--glow-angle", options.GlowAngle.has_value() } };
  const std::pair<const char*, bool> mediums[] = { { "--optical-depth",
                                                     options.OpticalDepth.has_value() },
    { "--world-unit", options.WorldUnit.has_value() }, { "--numbers", !options.Numbers.empty() } };
  for (const auto& [name, given] : others)
  {
    if (given && isMedium)
    {
      throw Failure(std::string(name) + " belongs to looks, and --preset " + options.Preset +
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
vtkSmartPointer<vtkLight> MakeLight(const Viewpoint& view, const Options& options)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  if (view.LightIsLamp)
  {
    light->SetPositional(true);
    light->SetConeAngle(180.0);
    light->SetPosition(view.LightPosition.data());
  }
  else
  {
    light->SetPosition(view.LightDirection.data());
    light->SetFocalPoint(0.0, 0.0, 0.0);
  }
  light->SetColor(options.LightColor.data());
  return light;
}

//------------------------------------------------------------------------------
/**
 * Light from the sky and from the eye, so that sides away from the sun keep their colours.
 */
void AddFill(vtkRenderer* renderer, const Scene& scene, double fill)
{
  vtkNew<vtkLight> sky;
  sky->SetPosition(scene.Up.data());
  sky->SetFocalPoint(0.0, 0.0, 0.0);
  sky->SetColor(0.70, 0.82, 1.0);
  sky->SetIntensity(fill);
  renderer->AddLight(sky);
  vtkNew<vtkLight> eye;
  eye->SetLightTypeToHeadlight();
  eye->SetColor(0.85, 0.90, 1.0);
  eye->SetIntensity(fill);
  renderer->AddLight(eye);
}

//------------------------------------------------------------------------------
/**
 * The physical sky; the sun's light gets its colour.
 */
void AddSky(vtkRenderer* renderer, const Scene& scene, const Viewpoint& view, vtkLight* light,
  const Options& options)
{
  double azimuth = 0.0;
  double elevation = 0.0;
  scene.GetAngles(view.LightDirection, azimuth, elevation);
  Vector3 ground;
  scene.Bounds.GetCenter(ground.data());
  for (int i = 0; i < 3; ++i)
  {
    ground[i] -= 0.5 * scene.GetExtent(scene.Up) * scene.Up[i];
  }
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->GetAtmosphere()->LoadPreset(options.Sky);
  sky->SetSunAzimuth(azimuth);
  sky->SetSunElevation(elevation);
  sky->SetUp(scene.Up.data());
  sky->SetNorth(scene.North.data());
  sky->SetOrigin(ground.data());
  sky->SetWorldUnitInMeters(options.WorldUnit.value_or(1.0));
  sky->SetExposure(SkyExposure);
  sky->UpdateLight(light);
}

//------------------------------------------------------------------------------
const Preset& GetPreset(const Options& options)
{
  return options.Preset.empty() ? GetPresets().front() : FindPreset(options.Preset);
}

//------------------------------------------------------------------------------
void SetLook(vtkGodRaysPass* rays, const Viewpoint& view, const Options& options)
{
  auto* model = vtkGodRaysRadialSumModel::SafeDownCast(rays->GetModel());
  model->SetDensity(options.Density.value_or(model->GetDensity()));
  model->SetDecay(options.Decay.value_or(model->GetDecay()));
  model->SetWeight(options.Weight.value_or(model->GetWeight()));
  model->SetExposure(options.Exposure.value_or(model->GetExposure()));
  rays->SetAutomaticExposure(!options.Exposure && !options.Weight);
  rays->SetLayerMargin(0.0);
  rays->SetBackgroundGlow(options.Glow.value_or(Glow));
  rays->SetBackgroundGlowRadius(GlowRadius);
  rays->SetBackgroundGlowFalloff(
    options.GlowAngle.value_or(view.LightIsLamp ? LampGlowAngle : SunGlowAngle));
}

//------------------------------------------------------------------------------
void SetMedium(vtkGodRaysPass* rays, const Options& options)
{
  auto* medium = vtkGodRaysHomogeneousModel::SafeDownCast(rays->GetModel());
  if (options.OpticalDepth)
  {
    medium->SetOpticalDepth(*options.OpticalDepth);
  }
  else
  {
    medium->SetWorldUnitInMeters(options.WorldUnit.value_or(0.0));
  }
  rays->SetAutomaticExposure(true);
  rays->SetLayerMargin(0.5); // what is just outside the picture casts shadows into it
}

//------------------------------------------------------------------------------
void SetPreset(
  vtkGodRaysPass* rays, const Preset& preset, const Viewpoint& view, const Options& options)
{
  rays->ApplyPreset(preset.Name.c_str());
  if (preset.IsMedium)
  {
    SetMedium(rays, options);
  }
  else
  {
    SetLook(rays, view, options);
  }
}

//------------------------------------------------------------------------------
void SetRays(vtkGodRaysPass* rays, const Viewpoint& view, const Options& options)
{
  SetPreset(rays, GetPreset(options), view, options);
  rays->SetIntensity(options.Intensity.value_or(1.0));
  rays->SetErrorTolerance(options.Tolerance.value_or(rays->GetErrorTolerance()));
  rays->SetOutput(options.Show == "occlusion" ? vtkGodRaysPass::OCCLUSION
      : options.Show == "rays"                ? vtkGodRaysPass::SCATTERING
                                              : vtkGodRaysPass::COMPOSITE);
  if (view.LightIsLamp)
  {
    rays->SetSourceRadius(options.LightSize.value_or(rays->GetSourceRadius()));
  }
  else
  {
    rays->SetSunAngularRadius(options.LightSize.value_or(SunRadius));
  }
}

//------------------------------------------------------------------------------
std::string ToText(const double values[3])
{
  std::ostringstream text;
  text << values[0] << "," << values[1] << "," << values[2];
  return text.str();
}

//------------------------------------------------------------------------------
void PrintScene(const Scene& scene, const Measured& times)
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
            << " s\ndrawn in   " << times.Drawing << " s\n";
}

//------------------------------------------------------------------------------
void PrintView(const Scene& scene, const Viewpoint& view, vtkCamera* camera)
{
  std::cout << "camera     --camera-position " << ToText(camera->GetPosition()) << " --focal-point "
            << ToText(camera->GetFocalPoint()) << " --view-angle " << camera->GetViewAngle()
            << "\n";
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
std::vector<FileContents> ReadFiles(const Options& options)
{
  std::vector<FileContents> files;
  std::vector<std::string> notes;
  for (const std::string& path : options.Files)
  {
    files.push_back(ReadFile(path));
    notes.insert(notes.end(), files.back().Notes.begin(), files.back().Notes.end());
  }
  if (!options.Up && !files.front().UpNote.empty())
  {
    notes.push_back(files.front().UpNote);
  }
  ShowLines(notes);
  return files;
}

//------------------------------------------------------------------------------
/**
 * MakeScene(), in which a filter of VTK's may crash of what a damaged file holds.
 */
Scene MakeSceneOf(const std::vector<FileContents>& files, const Options& options)
{
  const std::string which = files.size() == 1 ? files.front().Path : "one of the files";
  const std::string remedy = "; the file is damaged, or not what its name says: write it again";
  const Messages messages(true, "godrays: " + which + ": cannot be drawn" + remedy);
  Scene scene = MakeScene(files, options);
  if (!messages.GetErrors().empty())
  {
    throw Failure(which + ": cannot be drawn (" + messages.GetErrors().front() + ")" + remedy);
  }
  ShowLines(messages.GetWarnings());
  return scene;
}

//------------------------------------------------------------------------------
/**
 * Tell of what VTK said while it drew, and of what in the picture is probably not meant, unless that was told
 * already. Returns whether there was an error.
 */
bool TellMessages(const Messages& messages, const std::string& advice, bool wasTold)
{
  ShowLines(messages.GetWarnings());
  if (messages.GetWarnings().empty() && !wasTold)
  {
    std::istringstream lines(advice);
    for (std::string line; std::getline(lines, line);)
    {
      ShowLines({ line });
    }
  }
  ShowLines(messages.GetErrors());
  return !messages.GetErrors().empty();
}

//------------------------------------------------------------------------------
/**
 * Draw a scene to where the options say. Returns whether all went well.
 */
bool Draw(const Scene& scene, const Viewpoint& view, const Options& options, Measured& times,
  bool hasAdvice)
{
  const bool window = (options.Output.empty() && options.Numbers.empty()) || options.Interactive;
  const Messages messages(!window,
    "godrays: the display cannot draw with OpenGL 3.2; see that its driver is there (Debian: "
    "libgl1-mesa-dri)");
  vtkNew<vtkRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  renderer->SetActiveCamera(view.Camera);
  for (const auto& prop : scene.Props)
  {
    renderer->AddViewProp(prop);
  }
  const auto light = MakeLight(view, options);
  renderer->AddLight(light);
  AddFill(renderer, scene, options.Fill);
  std::optional<Sky> background;
  if (options.Sky.empty())
  {
    background.emplace(renderer, scene, view, options.LightSize.value_or(SunRadius), options);
  }
  else
  {
    AddSky(renderer, scene, view, light, options);
  }

  vtkNew<vtkGodRaysPass> rays;
  SetRays(rays, view, options);
  rays->AddLight(light);
  rays->SetMeasureTimes(options.Stats);

  vtkNew<vtkRenderWindow> renderWindow;
  renderWindow->SetOffScreenRendering(!window);
  renderWindow->SetSize(options.Size[0], options.Size[1]);
  renderWindow->SetWindowName("godrays");
  renderWindow->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();
  if (options.Rays)
  {
    rays->Attach(renderer);
  }
  const double start = GetSeconds();
  renderWindow->Render();
  times.Drawing = GetSeconds() - start;
  if (window)
  {
    Interact(renderWindow, renderer, rays, GetPreset(options),
      [&](const Preset& preset) { SetPreset(rays, preset, view, options); });
    renderWindow->Render(); // VTK 9.3 keeps nothing of what it has shown
  }
  if (!options.Output.empty())
  {
    WritePicture(renderWindow, options.Output);
  }
  if (!options.Numbers.empty())
  {
    WriteNumbers(rays, options.Irradiance, options.Numbers);
  }
  if (options.Stats)
  {
    PrintScene(scene, times);
    PrintView(scene, view, renderer->GetActiveCamera());
    PrintRays(rays, renderWindow, options.Rays);
  }
  const std::string advice = rays->GetAdvice();
  rays->Detach(renderer);
  vtkGodRaysSkyPass::Detach(renderer);
  return !TellMessages(messages, advice, hasAdvice);
}

//------------------------------------------------------------------------------
int Run(int argc, char* argv[])
{
  const auto options = ParseCommandLine(argc, argv);
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
  if (!options->Output.empty())
  {
    CheckOutput(options->Output, options->Files);
  }
  if (!options->Numbers.empty())
  {
    CheckNumbers(options->Numbers, options->Files);
  }
  Measured times;
  const double start = GetSeconds();
  const auto files = ReadFiles(*options);
  times.Reading = GetSeconds() - start;
  const Scene scene = MakeSceneOf(files, *options);
  const Viewpoint view = MakeViewpoint(scene, *options);
  const auto advice = options->Rays ? GetAdvice(scene, view, *options, GetPreset(*options).IsMedium)
                                    : std::vector<std::string>();
  ShowLines(advice);
  times.Preparing = GetSeconds() - start - times.Reading;
  CheckDisplay();
  return Draw(scene, view, *options, times, !advice.empty()) ? EXIT_SUCCESS : EXIT_FAILURE;
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
  catch (const std::exception& failure)
  {
    Messages::Show(std::string("godrays: ") + failure.what() + "\n");
  }
  return EXIT_FAILURE;
}
