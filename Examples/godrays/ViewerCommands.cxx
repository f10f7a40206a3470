// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// What the keys of the window do.

#include "Viewer.h"

#include "CameraOptions.h"
#include "Output.h"

#include "vtkCamera.h"
#include "vtkCubeAxesActor.h"
#include "vtkGodRaysPass.h"
#include "vtkInteractorStyleTerrain.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>

namespace
{
constexpr double IntensityStep = 1.25;
constexpr double ExposureStep = 1.25;
constexpr double LightStep = 1.0; // degrees
constexpr double Faster = 5.0;    // with Shift
constexpr double HighestSun = 89.5;
}

//------------------------------------------------------------------------------
/**
 * Returns whether to draw again.
 */
bool Viewer::Do(const KeyBinding& binding, bool shift)
{
  vtkGodRaysPass* rays = this->Shown->GetRays();
  switch (binding.Do)
  {
    case Command::Help:
      this->Over->ShowHelp(!this->Over->IsHelpShown());
      break;
    case Command::Home:
      this->GoHome();
      break;
    case Command::Rays:
      this->Shown->SetRays(!this->Shown->AreRaysOn());
      break;
    case Command::Look:
      this->TakePreset(binding.Step);
      break;
    case Command::Intensity:
      rays->SetIntensity(
        std::min(rays->GetIntensity() * std::pow(IntensityStep, binding.Step), 1e4));
      break;
    case Command::Exposure:
      this->SkyExposure *= std::pow(ExposureStep, binding.Step);
      this->Shown->SetExposure(this->SkyExposure);
      this->Message = this->Settings.Sky.empty()
        ? "there is no physical sky; give --sky"
        : "exposure of the sky: times " + std::to_string(this->SkyExposure);
      break;
    case Command::Azimuth:
    case Command::Elevation:
      this->MoveLight(binding.Do, binding.Step * LightStep * (shift ? Faster : 1.0));
      break;
    case Command::Handle:
      this->HasHandle = !this->HasHandle;
      break;
    case Command::Sliders:
      this->ShowSliders(!this->Numbers);
      break;
    case Command::View:
      this->SetView((this->View + binding.Step + NumberOfViews) % NumberOfViews);
      break;
    case Command::RaysAlone:
      this->SetView(this->View == RaysAlone ? Composite : RaysAlone);
      break;
    case Command::Split:
      this->Divider = this->Divider ? std::nullopt : std::optional<double>(0.5);
      break;
    case Command::Background:
      this->TakeBackground();
      break;
    case Command::ScalarBar:
      this->Over->ShowScalarBar(
        this->Over->IsScalarBarShown() ? nullptr : &this->Shown->GetScene());
      break;
    case Command::Axes:
      this->Over->ShowAxes(!this->Over->AreAxesShown());
      break;
    case Command::Grid:
      this->SetGrid(!this->Grid);
      break;
    case Command::Status:
      this->HasStatus = !this->HasStatus;
      break;
    case Command::Style:
      this->SetStyle(!this->IsTerrainStyle);
      break;
    case Command::Screenshot:
      this->WriteScreenshot();
      break;
    case Command::PrintOptions:
      std::cout << this->Shown->GetOptions() << std::endl;
      this->Message = "printed";
      break;
    case Command::File:
      this->Open((this->Item + binding.Step + this->List.GetSize()) % this->List.GetSize(), 0,
        this->List.GetSize() == 1);
      break;
    case Command::Reload:
      this->Open(this->Item, this->Step, true);
      break;
    case Command::Time:
      this->TakeStep(binding.Step);
      break;
    case Command::Play:
      this->IsPlaying = !this->IsPlaying && this->List.GetTimes().size() > 1;
      break;
    case Command::Quit:
      this->Interactor->ExitCallback();
      return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void Viewer::GoHome()
{
  const Viewpoint& home = this->Home;
  SetCamera(this->Shown->GetRenderer(), home.Camera, this->Shown->GetScene());
  this->Shown->TakeLight(home);
}

//------------------------------------------------------------------------------
/**
 * The next one of ours; those that others published come by name alone.
 */
void Viewer::TakePreset(int step)
{
  const auto& presets = GetPresets();
  const int count = static_cast<int>(presets.size());
  int index = static_cast<int>(
    std::find_if(presets.begin(), presets.end(),
      [this](const Preset& preset) { return preset.Name == this->Shown->GetLook().Name; }) -
    presets.begin());
  do
  {
    index = (index + step + count) % count;
  } while (presets[index].IsPublished);
  this->Shown->SetPreset(presets[index]);
  this->Message = presets[index].Name + ": " + presets[index].Description;
  this->Window->SetWindowName(("godrays: " + presets[index].Name).c_str());
}

//------------------------------------------------------------------------------
/**
 * Of a sun its azimuth or elevation; a lamp as far across the picture.
 */
void Viewer::MoveLight(Command command, double degrees)
{
  const Viewpoint& view = this->Shown->GetView();
  if (!view.LightIsLamp)
  {
    double azimuth = 0.0;
    double elevation = 0.0;
    this->Shown->GetScene().GetAngles(view.LightDirection, azimuth, elevation);
    (command == Command::Azimuth ? azimuth : elevation) += degrees;
    elevation = std::clamp(elevation, -HighestSun, HighestSun);
    this->Shown->MoveLight(this->Shown->GetScene().GetDirection(azimuth, elevation));
    return;
  }
  vtkCamera* camera = this->Shown->GetRenderer()->GetActiveCamera();
  double x = 0.0;
  double y = 0.0;
  if (FindLight(view, camera, this->GetAspect(), x, y))
  {
    const double share = degrees / camera->GetViewAngle();
    x += command == Command::Azimuth ? share / this->GetAspect() : 0.0;
    y += command == Command::Elevation ? share : 0.0;
    this->Shown->MoveLight(GetLightAt(view, camera, this->GetAspect(), x, y));
  }
}

//------------------------------------------------------------------------------
void Viewer::OnDragLight(double x, double y)
{
  const int* size = this->Window->GetSize();
  this->Shown->MoveLight(GetLightAt(this->Shown->GetView(),
    this->Shown->GetRenderer()->GetActiveCamera(), this->GetAspect(), x / size[0], y / size[1]));
}

//------------------------------------------------------------------------------
void Viewer::TakeBackground()
{
  static const char* const backgrounds[] = { "#040508:#0e1118", "black", "white" };
  if (!this->Settings.Sky.empty() || !this->Settings.Hdri.empty())
  {
    this->Message = this->Settings.Hdri.empty() ? "the physical sky (--sky) is the background"
                                                : "the picture of --hdri is the background";
    return;
  }
  const auto* found =
    std::find(std::begin(backgrounds), std::end(backgrounds), this->Shown->GetBackground());
  const char* next = found == std::end(backgrounds) || found + 1 == std::end(backgrounds)
    ? backgrounds[0]
    : *(found + 1);
  this->Shown->SetBackground(next);
  this->Message = std::string("background: ") + next;
}

//------------------------------------------------------------------------------
void Viewer::SetView(int view)
{
  this->View = view;
  this->Shown->GetRays()->SetOutput(view == Occlusion ? vtkGodRaysPass::OCCLUSION
      : view == RaysAlone                             ? vtkGodRaysPass::SCATTERING
                                                      : vtkGodRaysPass::COMPOSITE);
  this->Message = std::string("view: ") + GetViewName(view);
}

//------------------------------------------------------------------------------
/**
 * It is of the scene, and stands in it; no light is blocked by it.
 */
void Viewer::SetGrid(bool on)
{
  vtkRenderer* renderer = this->Shown->GetRenderer();
  if (this->Grid)
  {
    renderer->RemoveViewProp(this->Grid);
    this->Grid = nullptr;
  }
  if (!on)
  {
    return;
  }
  this->Grid = vtkSmartPointer<vtkCubeAxesActor>::New();
  double bounds[6];
  this->Shown->GetScene().Bounds.GetBounds(bounds);
  this->Grid->SetBounds(bounds);
  this->Grid->SetCamera(renderer->GetActiveCamera());
  this->Grid->SetFlyModeToOuterEdges();
  this->Grid->SetGridLineLocation(vtkCubeAxesActor::VTK_GRID_LINES_FURTHEST);
  this->Grid->DrawXGridlinesOn();
  this->Grid->DrawYGridlinesOn();
  this->Grid->DrawZGridlinesOn();
  for (int i = 0; i < 3; ++i)
  {
    this->Grid->GetTitleTextProperty(i)->SetColor(1.0, 1.0, 1.0);
    this->Grid->GetLabelTextProperty(i)->SetColor(1.0, 1.0, 1.0);
  }
  vtkGodRaysPass::SetRole(this->Grid, vtkGodRaysPass::IGNORED);
  renderer->AddViewProp(this->Grid);
}

//------------------------------------------------------------------------------
void Viewer::SetStyle(bool terrain)
{
  this->IsTerrainStyle = terrain;
  vtkSmartPointer<vtkInteractorStyle> style;
  if (terrain)
  {
    style = vtkSmartPointer<vtkInteractorStyleTerrain>::New();
    this->Message = "the horizon stays level";
  }
  else
  {
    style = vtkSmartPointer<vtkInteractorStyleTrackballCamera>::New();
    this->Message = "trackball";
  }
  this->Interactor->SetInteractorStyle(style);
}

//------------------------------------------------------------------------------
void Viewer::TakeStep(int step)
{
  const int count = static_cast<int>(this->List.GetTimes().size());
  if (count > 1)
  {
    this->Open(this->Item, (static_cast<int>(this->Step) + step + count) % count, true);
  }
  else
  {
    this->Message = "the files have no time steps";
  }
}

//------------------------------------------------------------------------------
void Viewer::ShowSliders(bool on)
{
  this->Numbers.reset();
  if (on)
  {
    this->Numbers.emplace(this->Interactor, this->Over->GetRenderer());
    this->Numbers->OnChange(
      [this](const std::string& name, double value) { this->Shown->SetParameter(name, value); });
  }
}

//------------------------------------------------------------------------------
void Viewer::WriteScreenshot()
{
  namespace fs = std::filesystem;
  std::string name;
  for (int i = 1; name.empty() || fs::exists(name); ++i)
  {
    name = this->List.GetName(this->Item) + "-" + std::to_string(i) + ".png";
  }
  this->Over->SetVisible(false);
  this->RenderPicture();
  try
  {
    WritePicture(this->Window, name, false);
    this->Message = "written: " + name;
  }
  catch (const std::exception& failure)
  {
    this->Message = failure.what();
  }
  this->Over->SetVisible(true);
}
