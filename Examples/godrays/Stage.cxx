// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "AmbientOcclusion.h"
#include "Environment.h"
#include "Values.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysVolumeModel.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{
// [degrees] a look: larger than the real sun, which vtkGodRaysSun and the sky of --sky have, to be seen
constexpr double SunRadius = 0.6;
constexpr double SkyExposure = 2.5; // a white wall in the sun is about as bright as can be shown
// of a light from the eye; 1 is VTK's headlight, which shows colours as they are without rays
constexpr double FillOfPlain = 0.96;
constexpr double FillOfColors = 1.0;
// as vtkGodRaysPass::PlaceSun() has them
constexpr Vector3 WarmSun = { 1.0, 0.85, 0.62 };
constexpr Vector3 PaleSun = { 1.0, 0.905, 0.76 }; // in a medium
constexpr double LampInAir = 24.0;                // intensity
constexpr double AboveSun = 5.0; // [degrees] where the sky is not to be brighter than white

//------------------------------------------------------------------------------
/**
 * Whether the sun itself lights the data. Elsewhere it only makes the rays: it stands behind the data, which
 * would be dark.
 */
bool SunLightsData(const Options& options)
{
  return !options.Sky.empty() || !options.Hdri.empty();
}

//------------------------------------------------------------------------------
bool IsColored(const vtkSmartPointer<vtkProp3D>& prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  int ofCells = 0;
  return !mapper || actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0 ||
    (mapper->GetScalarVisibility() &&
      vtkAbstractMapper::GetScalars(mapper->GetInput(), mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells));
}

//------------------------------------------------------------------------------
/**
 * Whether a prop is an opaque surface. Ambient occlusion would only darken lines and spheres of points, and
 * it has no place in volumes and glass.
 */
bool CanBeOccluded(const vtkSmartPointer<vtkProp3D>& prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* surface = actor ? vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()) : nullptr;
  return surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0 &&
    !prop->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
/**
 * Light from the eye, so that sides away from the sun keep their colours, and on terrain, which is seen at a
 * grazing angle, from above. Under a sky, which lights the data itself, there is none unless it is asked for.
 */
void AddFill(vtkRenderer* renderer, const Scene& scene, const Options& options)
{
  const bool isColored = std::any_of(scene.Props.begin(), scene.Props.end(), IsColored);
  const double fill = options.Fill.value_or(SunLightsData(options) ? 0.0
      : isColored                                                  ? FillOfColors
                                                                   : FillOfPlain);
  if (fill == 0.0)
  {
    return;
  }
  if (scene.IsTerrain())
  {
    vtkNew<vtkLight> above;
    above->SetPosition(scene.Up.data());
    above->SetFocalPoint(0.0, 0.0, 0.0);
    above->SetColor(0.70, 0.82, 1.0);
    above->SetIntensity(fill);
    renderer->AddLight(above);
  }
  vtkNew<vtkLight> eye;
  eye->SetLightTypeToHeadlight();
  eye->SetIntensity(fill);
  renderer->AddLight(eye);
}

//------------------------------------------------------------------------------
/**
 * The exposure of the physical sky: less than SkyExposure where a haze about the sun would be a sheet of
 * white in the picture. Away is how far the sun is from the middle of it [degrees].
 */
double ChooseExposure(
  vtkGodRaysSkyPass* sky, double azimuth, double elevation, double away, double viewAngle)
{
  const double turn = vtkMath::RadiansFromDegrees(azimuth);
  const double height = vtkMath::RadiansFromDegrees(elevation + AboveSun);
  const double direction[3] = { std::cos(height) * std::sin(turn),
    std::cos(height) * std::cos(turn), std::sin(height) };
  double radiance[3];
  sky->GetSkyColor(direction, radiance);
  const double seen = std::clamp((0.75 * viewAngle - away) / AboveSun + 1.0, 0.0, 1.0);
  const double brightest = seen * *std::max_element(radiance, radiance + 3);
  return SkyExposure / std::max(1.0, SkyExposure * brightest);
}

//------------------------------------------------------------------------------
/**
 * The physical sky, without its sun.
 */
void AddSky(vtkRenderer* renderer, const Scene& scene, const Options& options)
{
  Vector3 ground;
  scene.Bounds.GetCenter(ground.data());
  for (int i = 0; i < 3; ++i)
  {
    ground[i] -= 0.5 * scene.GetExtent(scene.Up) * scene.Up[i];
  }
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->GetAtmosphere()->LoadPreset(options.Sky);
  sky->SetUp(scene.Up.data());
  sky->SetNorth(scene.North.data());
  sky->SetOrigin(ground.data());
  sky->SetWorldUnitInMeters(options.WorldUnit.value_or(1.0));
  sky->HighlightShoulderOn();
}

//------------------------------------------------------------------------------
void SetLook(vtkGodRaysPass* rays, const Options& options)
{
  auto* model = vtkGodRaysRadialSumModel::SafeDownCast(rays->GetModel());
  model->SetDensity(options.Density.value_or(model->GetDensity()));
  model->SetDecay(options.Decay.value_or(model->GetDecay()));
  model->SetWeight(options.Weight.value_or(model->GetWeight()));
  model->SetExposure(options.Exposure.value_or(model->GetExposure()));
  rays->SetAutomaticExposure(!options.Exposure && !options.Weight);
  rays->SetLayerMargin(0.0);
  rays->SetBackgroundGlow(options.Glow.value_or(rays->GetBackgroundGlow()));
  rays->SetBackgroundGlowFalloff(options.GlowAngle.value_or(rays->GetBackgroundGlowFalloff()));
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
void SetPreset(vtkGodRaysPass* rays, const Preset& preset, const Options& options)
{
  if (options.VolumeMedium && options.Preset.empty())
  {
    vtkNew<vtkGodRaysVolumeModel> model;
    model->SetWorldUnitInMeters(options.WorldUnit.value_or(0.0));
    rays->SetModel(model);
    rays->SetAutomaticExposure(true);
    rays->SetLayerMargin(0.0);
    return;
  }
  rays->ApplyPreset(preset.Name.c_str());
  if (preset.IsMedium)
  {
    SetMedium(rays, options);
  }
  else
  {
    SetLook(rays, options);
  }
}

//------------------------------------------------------------------------------
void SetRays(vtkGodRaysPass* rays, const Viewpoint& view, const Options& options)
{
  SetPreset(rays, GetPreset(options), options);
  if (auto* medium = vtkGodRaysMediumModel::SafeDownCast(rays->GetModel()))
  {
    medium->SetScatteringOrders(
      options.AllOrders ? vtkGodRaysMediumModel::ALL : vtkGodRaysMediumModel::SINGLE);
  }
  rays->SetIntensity(options.Intensity.value_or(1.0));
  rays->SetDataFirst(options.DataFirst);
  rays->SetSurfaceShadows(options.Shadows);
  rays->SetErrorTolerance(options.Tolerance.value_or(rays->GetErrorTolerance()));
  rays->SetOutput(options.Show == "occlusion" ? vtkGodRaysPass::OCCLUSION
      : options.Show == "rays"                ? vtkGodRaysPass::SCATTERING
                                              : vtkGodRaysPass::COMPOSITE);
  rays->SetSunAngularRadius(view.LightIsLamp ? SunRadius : options.LightSize.value_or(SunRadius));
  if (view.LightIsLamp)
  {
    rays->SetSourceRadius(options.LightSize.value_or(rays->GetSourceRadius()));
  }
}

}

//------------------------------------------------------------------------------
Stage::Stage(Scene scene, const Viewpoint& view, const Options& options)
  : Data(std::move(scene))
  , Original(view)
  , Settings(options)
  , Look(GetPreset(options))
{
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetActiveCamera(view.Camera);
  for (const auto& prop : this->Data.Props)
  {
    this->Renderer->AddViewProp(prop);
  }
  this->PlaceLight();
  if (SunLightsData(options))
  {
    this->Renderer->AddLight(this->Light);
  }
  if (options.Hdri.empty())
  {
    AddFill(this->Renderer, this->Data, options);
  }
  else
  {
    AddEnvironment(this->Renderer, this->Data, options.Hdri);
  }
  const auto& props = this->Data.Props;
  if (options.AmbientOcclusion && std::all_of(props.begin(), props.end(), CanBeOccluded))
  {
    vtkNew<AmbientOcclusion> occlusion;
    occlusion->SetUp(
      this->Data.Bounds.GetDiagonalLength(), std::any_of(props.begin(), props.end(), IsColored));
    this->Renderer->SetPass(occlusion); // the sky and the rays come over it
  }
  if (!options.Sky.empty())
  {
    AddSky(this->Renderer, this->Data, options);
  }
  this->SetBackground(options.Background);
  ::SetRays(this->Rays, this->View, options);
  this->Rays->AddLight(this->Light);
  this->Rays->SetLightData(!SunLightsData(options));
  this->Rays->SetMeasureTimes(options.Stats);
  if (options.OpensWindow())
  {
    vtkNew<vtkCallbackCommand> silence; // a window's status line has the advice
    this->Rays->AddObserver(vtkCommand::WarningEvent, silence);
  }
  this->SetRays(options.Rays);
}

//------------------------------------------------------------------------------
Stage::~Stage()
{
  this->SetRays(false);
  vtkGodRaysSkyPass::Detach(this->Renderer);
}

//------------------------------------------------------------------------------
void Stage::SetRays(bool on)
{
  if (on && !this->HasRays)
  {
    this->Rays->Attach(this->Renderer);
  }
  else if (!on && this->HasRays)
  {
    this->Rays->Detach(this->Renderer);
  }
  this->HasRays = on;
}

//------------------------------------------------------------------------------
void Stage::SetPreset(const ::Preset& preset)
{
  if (this->Settings.VolumeMedium && this->Settings.Preset.empty() &&
    preset.Name == this->Look.Name)
  {
    return; // nobody has chosen one
  }
  this->Look = preset;
  this->Settings.Preset = preset.Name;
  ::SetPreset(this->Rays, preset, this->Settings);
  this->PlaceLight();
}

//------------------------------------------------------------------------------
void Stage::SetBackground(const std::string& background)
{
  this->Settings.Background = background;
  this->Renderer->GradientBackgroundOff();
  if (this->Settings.Transparent)
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Renderer->SetBackgroundAlpha(0.0);
  }
  else if (!this->Settings.Hdri.empty())
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
  }
  else if (this->Settings.Sky.empty())
  {
    const std::string& colors = this->Settings.Background;
    const auto colon = std::min(colors.find(':'), colors.size());
    const Vector3 bottom = ParseColor("--background", colors.substr(0, colon));
    const Vector3 top =
      colon < colors.size() ? ParseColor("--background", colors.substr(colon + 1)) : bottom;
    this->Renderer->SetGradientBackground(colon < colors.size());
    this->Renderer->SetBackground(bottom.data());
    this->Renderer->SetBackground2(top.data());
  }
  else
  {
    this->MoveSkySun();
  }
}

//------------------------------------------------------------------------------
void Stage::PlaceLight()
{
  const bool inMedium = this->Look.IsMedium;
  this->View = this->Original;
  if (inMedium && this->View.LightWasChosen && this->View.LampInMedium)
  {
    this->View.LightIsLamp = true;
    this->View.LightPosition = *this->View.LampInMedium;
  }
  const bool isLamp = this->View.LightIsLamp;
  const bool isInAir = isLamp && inMedium && !SunLightsData(this->Settings);
  const Vector3& place = isLamp ? this->View.LightPosition : this->View.LightDirection;
  this->Light->SetPositional(isLamp);
  this->Light->SetConeAngle(180.0);
  this->Light->SetPosition(place.data());
  this->Light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Light->SetIntensity(isInAir ? LampInAir : 1.0);
  this->Light->SetColor(this->Settings.LightColor.value_or(inMedium ? PaleSun : WarmSun).data());
  if (vtkGodRaysSkyPass::Find(this->Renderer))
  {
    this->MoveSkySun();
  }
}

//------------------------------------------------------------------------------
void Stage::MoveLight(const Vector3& place)
{
  Viewpoint moved = this->View;
  (moved.LightIsLamp ? moved.LightPosition : moved.LightDirection) = place;
  moved.LightWasChosen = false;
  this->TakeLight(moved);
}

//------------------------------------------------------------------------------
void Stage::TakeLight(const Viewpoint& view)
{
  this->Original = view;
  this->PlaceLight();
}

//------------------------------------------------------------------------------
void Stage::MoveSkySun()
{
  double azimuth = 0.0;
  double elevation = 0.0;
  this->Data.GetAngles(this->View.LightDirection, azimuth, elevation);
  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Find(this->Renderer);
  sky->SetSunAzimuth(azimuth);
  sky->SetSunElevation(elevation);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool turns = this->Settings.Turntable > 0;
  const double away = vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(
    camera->GetDirectionOfProjection(), this->View.LightDirection.data()));
  sky->SetExposure(this->ExposureFactor *
    ChooseExposure(sky, azimuth, elevation, turns ? 0.0 : away, camera->GetViewAngle()));
  sky->UpdateLight(this->Light);
}

//------------------------------------------------------------------------------
void Stage::SetExposure(double factor)
{
  this->ExposureFactor = factor;
  if (vtkGodRaysSkyPass::Find(this->Renderer))
  {
    this->MoveSkySun();
  }
}

//------------------------------------------------------------------------------
std::vector<Stage::Parameter> Stage::GetParameters() const
{
  // Each quarter of a slider changes pictures: beyond these ends of decay and glow, hardly anything does.
  std::vector<Parameter> found = { { "intensity", 0.0, 3.0, this->Rays->GetIntensity() } };
  if (auto* look = vtkGodRaysRadialSumModel::SafeDownCast(this->Rays->GetModel()))
  {
    found.push_back({ "density", 0.0, 1.0, look->GetDensity() });
    found.push_back({ "decay", 0.94, 1.0, look->GetDecay() });
    found.push_back({ "glow", 0.0, 0.5, this->Rays->GetBackgroundGlow() });
  }
  else if (auto* medium = vtkGodRaysHomogeneousModel::SafeDownCast(this->Rays->GetModel());
           medium && medium->GetWorldUnitInMeters() == 0.0)
  {
    found.push_back({ "optical-depth", 0.01, 2.0, medium->GetOpticalDepth() });
  }
  return found;
}

//------------------------------------------------------------------------------
void Stage::SetParameter(const std::string& name, double value)
{
  if (name == "intensity")
  {
    this->Rays->SetIntensity(value);
    return;
  }
  const std::pair<const char*, std::optional<double>*> numbers[] = {
    { "density", &this->Settings.Density }, { "decay", &this->Settings.Decay },
    { "glow", &this->Settings.Glow }, { "optical-depth", &this->Settings.OpticalDepth }
  };
  for (const auto& [each, number] : numbers)
  {
    if (name == each)
    {
      *number = value;
    }
  }
  if (this->Look.IsMedium)
  {
    SetMedium(this->Rays, this->Settings);
  }
  else
  {
    SetLook(this->Rays, this->Settings);
  }
}

//------------------------------------------------------------------------------
void Stage::SetParameters(const Stage& other)
{
  this->Settings.Density = other.Settings.Density;
  this->Settings.Decay = other.Settings.Decay;
  this->Settings.Glow = other.Settings.Glow;
  this->Settings.OpticalDepth = other.Settings.OpticalDepth;
}

//------------------------------------------------------------------------------
std::string Stage::GetOptions() const
{
  const auto toText = [](const double values[3])
  {
    std::ostringstream text;
    text.precision(9);
    text << values[0] << "," << values[1] << "," << values[2];
    return text.str();
  };
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  std::ostringstream text;
  text << "--camera-position " << toText(camera->GetPosition()) << " --focal-point "
       << toText(camera->GetFocalPoint()) << " --view-up " << toText(camera->GetViewUp());
  if (camera->GetParallelProjection())
  {
    text << " --parallel --parallel-height " << 2.0 * camera->GetParallelScale();
  }
  else
  {
    text << " --view-angle " << camera->GetViewAngle();
  }
  if (this->View.LightIsLamp)
  {
    text << " --light " << toText(this->View.LightPosition.data());
  }
  else
  {
    double azimuth = 0.0;
    double elevation = 0.0;
    this->Data.GetAngles(this->View.LightDirection, azimuth, elevation);
    text.precision(9);
    text << " --sun " << azimuth << "," << elevation;
  }
  text << " --preset " << this->Look.Name;
  if (this->Rays->GetIntensity() != 1.0)
  {
    text << " --intensity " << this->Rays->GetIntensity();
  }
  const std::pair<const char*, std::optional<double>> numbers[] = {
    { "density", this->Settings.Density }, { "decay", this->Settings.Decay },
    { "glow", this->Settings.Glow }, { "optical-depth", this->Settings.OpticalDepth }
  };
  const auto used = this->GetParameters();
  for (const auto& [name, number] : numbers)
  {
    const std::string option = name;
    if (number &&
      std::any_of(
        used.begin(), used.end(), [&option](const Parameter& each) { return each.Name == option; }))
    {
      text << " --" << option << " " << *number;
    }
  }
  if (this->Settings.Background != Options().Background)
  {
    text << " --background '" << this->Settings.Background << "'"; // # begins a comment of shells
  }
  return text.str();
}

//------------------------------------------------------------------------------
const Preset& GetPreset(const Options& options)
{
  return options.Preset.empty() ? GetPresets().front() : FindPreset(options.Preset);
}
