// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPass.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPassInternals.h"
#include "vtkGodRaysPresets.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysPass);

namespace
{
// Linear (1, 0.69, 0.34) and (0.62, 0.80, 1): warm light over blue passes grey, which looks like mud.
const double WarmSun[3] = { 1.0, 0.85, 0.62 };
const double CoolSun[3] = { 0.81, 0.91, 1.0 };
// of media: warmer light is brown in haze, paler is grey
const double PaleSun[3] = { 1.0, 0.905, 0.76 };
constexpr double LampStrength = 24.0; // in air; 12 at least to be exposed as a sun is

bool IsColor(vtkLight* light, const double color[3])
{
  return std::equal(color, color + 3, light->GetDiffuseColor());
}
}

vtkGodRaysPass::vtkGodRaysPass()
  : Internal(new Internals)
{
  this->SetModel(nullptr);
  this->SetIntegrator(nullptr);
}

vtkGodRaysPass::~vtkGodRaysPass() = default;

void vtkGodRaysPass::SetRole(vtkProp* prop, int role)
{
  if (!prop || role < AUTOMATIC || role > MEDIUM)
  {
    vtkGenericWarningMacro(
      "SetRole needs a prop and one of AUTOMATIC (0), OCCLUDER (1), LIGHT (2), "
      "IGNORED (3) and MEDIUM (4), not "
      << (prop ? "role " + std::to_string(role) : "a null prop") << "; nothing is changed.");
    return;
  }
  vtkGodRaysSetRole(prop, static_cast<vtkGodRaysRole>(role));
}

int vtkGodRaysPass::GetRole(vtkProp* prop)
{
  return static_cast<int>(vtkGodRaysGetRole(prop));
}

vtkInformationIntegerKey* vtkGodRaysPass::ROLE()
{
  return vtkGodRaysGetRoleKey();
}

void vtkGodRaysPass::AddLight(vtkLight* light)
{
  auto& lights = this->Internal->Lights;
  if (light && std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    lights.emplace_back(light);
    this->Modified();
  }
}

void vtkGodRaysPass::RemoveLight(vtkLight* light)
{
  auto& lights = this->Internal->Lights;
  const auto found = std::find(lights.begin(), lights.end(), light);
  if (found != lights.end())
  {
    lights.erase(found);
    this->Modified();
  }
}

void vtkGodRaysPass::RemoveAllLights()
{
  if (!this->Internal->Lights.empty())
  {
    this->Internal->Lights.clear();
    this->Modified();
  }
}

vtkLight* vtkGodRaysPass::PlaceSun(vtkRenderer* renderer)
{
  const double* usual = vtkGodRaysSunPlacer::GetUsualPlace();
  vtkLight* sun = this->PlaceSun(renderer, usual[0], usual[1]);
  this->Internal->SunIsKept = this->Internal->SunIsKept && !sun;
  return sun;
}

vtkLight* vtkGodRaysPass::PlaceSun(vtkRenderer* renderer, double x, double y)
{
  return this->PlaceSunOrLamp(renderer, x, y, false);
}

// Places a lamp in air and in a parallel projection, else a sun; see PlaceSun() in the header.
vtkLight* vtkGodRaysPass::PlaceSunOrLamp(vtkRenderer* renderer, double x, double y, bool isInAir)
{
  Internals& self = *this->Internal;
  const bool isLamp = renderer && (isInAir || renderer->GetActiveCamera()->GetParallelProjection());
  double place[3];
  if (!(isLamp ? vtkGodRaysSunPlacer::GetPosition(renderer, x, y, place)
               : vtkGodRaysSunPlacer::GetDirection(renderer, x, y, place)))
  {
    vtkErrorMacro(
      "PlaceSun needs a vtkRenderer with a camera that sees something; nothing is changed.");
    return nullptr;
  }
  if (!self.PlacedSun)
  {
    self.PlacedSun = vtkSmartPointer<vtkLight>::New();
    self.PlacedSun->SetLightTypeToSceneLight();
    self.PlacedSun->SetConeAngle(90.0);
    self.PlacedSun->SetFocalPoint(0.0, 0.0, 0.0);
    self.PlacedSun->SetDiffuseColor(WarmSun[0], WarmSun[1], WarmSun[2]);
  }
  const double strength = isInAir ? LampStrength : 1.0; // users' factors on that are kept
  self.PlacedSun->SetIntensity(self.PlacedSun->GetIntensity() * strength / self.SunStrength);
  self.SunStrength = strength;
  self.PlacedSun->SetPositional(isLamp);
  self.PlacedSun->SetPosition(place);
  self.SunIsKept = true;
  this->AddLight(self.PlacedSun);
  if (this->SunPlacement == SUN_IF_NO_LIGHT)
  {
    std::iter_swap(self.Lights.begin(), // the first light is the one that looks go by
      std::find(self.Lights.begin(), self.Lights.end(), self.PlacedSun));
  }
  return self.PlacedSun;
}

vtkGodRaysSunPlacer* vtkGodRaysPass::GetSunPlacer()
{
  return this->Internal->Placer;
}

// Returns true if a sun is to be placed in this frame: there is none, or PlaceSun() asked for it.
bool vtkGodRaysPass::IsSunMissing() const
{
  const Internals& self = *this->Internal;
  const bool isThere = self.PlacedSun &&
    std::find(self.Lights.begin(), self.Lights.end(), self.PlacedSun) != self.Lights.end();
  return isThere                            ? !self.SunIsKept
    : this->SunPlacement == SUN_IF_NO_LIGHT ? self.HasNoLight
                                            : this->SunPlacement != SUN_BY_HAND;
}

// Returns true if a sun is to be placed in this frame, or follows the view.
bool vtkGodRaysPass::MovesSun() const
{
  return this->IsSunMissing() ||
    (this->Internal->PlacedSun && this->SunPlacement >= SUN_EVERY_VIEW);
}

// Returns true if view or props differ from those whose coverage is known. Pictures of
// which the user drags the camera are not looked at, nor are tiles, which are parts.
bool vtkGodRaysPass::SeesNewPicture(vtkRenderer* renderer)
{
  Internals& self = *this->Internal;
  vtkRenderWindow* window = renderer->GetRenderWindow();
  int tiles[2];
  window->GetTileScale(tiles);
  if (std::max(tiles[0], tiles[1]) > 1 ||
    (window->GetDesiredUpdateRate() >= 1.0 && !this->IsSunMissing()))
  {
    return false;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<double, 34> picture;
  std::copy_n(camera->GetViewTransformMatrix()->GetData(), 16, picture.begin());
  std::copy_n(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(), 16,
    picture.begin() + 16);
  // The clipping range is left out: it follows props that move.
  picture[16 + 10] = picture[16 + 11] = 0.0;
  picture[32] = renderer->GetTiledAspectRatio();
  vtkMTimeType changed = 0;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    changed = std::max(changed, prop->GetRedrawMTime());
  }
  picture[33] = static_cast<double>(changed) + props->GetNumberOfItems();
  const bool isNew = picture != self.CoveredPicture || this->IsSunMissing();
  self.CoveredPicture = picture;
  self.CoverageIsCurrent = true; // once a new one was looked at
  return isNew;
}

// Have the first light on the data, too, as LightData asks for, and all of them, as SurfaceShadows does.
void vtkGodRaysPass::LightTheData(vtkRenderer* renderer)
{
  Internals& self = *this->Internal;
  static const std::vector<vtkSmartPointer<vtkLight>> none;
  self.DataLights.Shine(renderer, this->SurfaceShadows ? self.Lights : none, self.PlacedSun);
  if (!this->LightData || self.Lights.empty())
  {
    self.DataLights.Remove();
    return;
  }
  vtkLight* light = self.Lights.front();
  double from[3] = { 0.0, 0.0, 0.0 };
  double bounds[6];
  light->GetTransformedFocalPoint(from);
  if (light->GetPositional())
  {
    renderer->ComputeVisiblePropBounds(bounds);
    vtkBoundingBox(bounds).GetCenter(from);
  }
  double direction[3];
  light->GetTransformedPosition(direction);
  vtkMath::Subtract(direction, from, direction);
  vtkMath::Normalize(direction);
  self.DataLights.Update(renderer, direction);
}

// Put the sun where the placer finds the most shafts, unless it has a good place.
void vtkGodRaysPass::MoveSun(vtkRenderer* renderer, bool isBlue)
{
  constexpr double goodPart = 0.8; // of the best score: nearer ones are not worth a jump
  Internals& self = *this->Internal;
  self.Placer->Find(renderer);
  const double* place = self.Placer->GetPlace();
  // The shafts of a lamp behind the props spread in the air, as those of a sun do in a look. A sun's own are
  // parallel there, and in front of the props there is nothing that they are told from.
  const bool isInAir =
    vtkGodRaysHomogeneousModel::SafeDownCast(self.Model) && self.Placer->GetCoverage() > 0.0;
  const bool isLamp = isInAir || renderer->GetActiveCamera()->GetParallelProjection();
  if (!this->IsSunMissing())
  {
    double now[2];
    if (isLamp == (self.PlacedSun->GetPositional() != 0) &&
      vtkGodRaysSunPlacer::FindPlace(renderer, self.PlacedSun, now) &&
      self.Placer->GetScoreAt(now[0], now[1]) >= goodPart * self.Placer->GetScore())
    {
      return;
    }
  }
  const bool hasOwnColor = self.PlacedSun && !IsColor(self.PlacedSun, WarmSun) &&
    !IsColor(self.PlacedSun, CoolSun) && !IsColor(self.PlacedSun, PaleSun);
  if (this->PlaceSunOrLamp(renderer, place[0], place[1], isInAir))
  {
    self.SunIsKept = self.Placer->GetCoverage() > 0.0;
    const double* color = self.Effect->DimsScene() ? PaleSun : isBlue ? CoolSun : WarmSun;
    if (!hasOwnColor && !IsColor(self.PlacedSun, color))
    {
      self.PlacedSun->SetDiffuseColor(color[0], color[1], color[2]);
    }
    self.SunMoved = true;
    this->InvokeEvent(SunPlacedEvent, self.PlacedSun);
  }
}

void vtkGodRaysPass::ResetSceneSize()
{
  this->Internal->SceneSize.Reset();
  this->Modified();
}

int vtkGodRaysPass::GetNumberOfLights()
{
  return static_cast<int>(this->Internal->Lights.size());
}

vtkLight* vtkGodRaysPass::GetLight(int index)
{
  const auto& lights = this->Internal->Lights;
  return index >= 0 && index < static_cast<int>(lights.size()) ? lights[index].Get() : nullptr;
}

void vtkGodRaysPass::SetSun(vtkGodRaysSun* sun)
{
  if (!sun || sun != this->Internal->Sun)
  {
    this->Internal->Sun = sun;
    if (!sun)
    {
      this->Internal->Sun = vtkSmartPointer<vtkGodRaysSun>::New();
    }
    this->Modified();
  }
}

vtkGodRaysSun* vtkGodRaysPass::GetSun()
{
  return this->Internal->Sun;
}

void vtkGodRaysPass::SetSunAngularRadius(double degrees)
{
  this->Internal->Sun->SetAngularRadius(degrees);
}

double vtkGodRaysPass::GetSunAngularRadius()
{
  return this->Internal->Sun->GetAngularRadius();
}

void vtkGodRaysPass::SetModel(vtkGodRaysModel* model)
{
  if (model && model == this->Internal->Model)
  {
    return;
  }
  Internals& self = *this->Internal;
  self.HasScattering = false; // the effect may have lent it
  if (self.Effect && self.Window)
  {
    self.Effect->Release(self.Window);
    self.HasRays = false;
  }
  self.Model = model;
  if (!model)
  {
    self.Model = vtkSmartPointer<vtkGodRaysRadialModel>::New();
  }
  self.Effect = self.Model->MakeEffect();
  if (self.IntegratorIsModels && !self.Integrator->Supports(self.Model))
  {
    this->SetIntegrator(nullptr);
  }
  this->Modified();
}

vtkGodRaysModel* vtkGodRaysPass::GetModel()
{
  return this->Internal->Model;
}

void vtkGodRaysPass::SetIntegrator(vtkGodRaysIntegrator* integrator)
{
  Internals& self = *this->Internal;
  if (integrator && integrator == self.Integrator)
  {
    self.IntegratorIsModels = false;
    return;
  }
  if (self.Integrator && self.Window)
  {
    self.Integrator->ReleaseGraphicsResources(self.Window);
    self.HasScattering = false; // which it may have lent
  }
  self.IntegratorIsModels = !integrator;
  self.Integrator = integrator;
  if (!integrator)
  {
    self.Integrator = vtk::TakeSmartPointer(self.Model->MakeIntegrator());
  }
  this->Modified();
}

vtkGodRaysIntegrator* vtkGodRaysPass::GetIntegrator()
{
  return this->Internal->Integrator;
}

void vtkGodRaysPass::SetCompositor(vtkGodRaysCompositor* compositor)
{
  if (this->Internal->Compositor != compositor)
  {
    this->Internal->Compositor = compositor;
    this->Modified();
  }
}

vtkGodRaysCompositor* vtkGodRaysPass::GetCompositor()
{
  return this->Internal->Compositor;
}

bool vtkGodRaysPass::ApplyPreset(const char* name)
{
  if (vtkGodRaysPresets::ApplyTo(this->GetModel(), name))
  {
    return true;
  }
  const auto model = vtk::TakeSmartPointer(vtkGodRaysPresets::NewModel(name));
  if (!model)
  {
    vtkErrorMacro("There is no preset \""
      << (name ? name : "") << "\". The presets are: " << vtkGodRaysPresets::ListNames() << ".");
    return false;
  }
  this->SetModel(model);
  return true;
}

vtkGodRaysSetFiniteMacro(vtkGodRaysPass, Intensity, 0.0, 1e4);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, MostDataLightness, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, MostDataShadow, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, ErrorTolerance, 1e-6, 0.1);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, InteractiveErrorTolerance, 1e-6, 0.1);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, SourceRadius, 0.0, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlow, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowRadius, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowFalloff, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, LayerMargin, 0.0, 1.0);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Blend, SCREEN);
vtkGodRaysSetModeMacro(vtkGodRaysPass, DisplayTransfer, POWER_TRANSFER);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Output, SCATTERING);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Precision, SINGLE);

void vtkGodRaysPass::Attach(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("Attach needs a vtkRenderer, not null.");
    return;
  }
  Internals& self = *this->Internal;
  vtkRenderer* former = self.Attachment.GetRenderer();
  if (former != renderer)
  {
    const vtkSmartPointer<vtkGodRaysPass> keep = this;
    this->Detach(former);
  }
  self.Attachment.Attach(this, renderer);
}

vtkGodRaysPass* vtkGodRaysPass::Find(vtkRenderer* renderer)
{
  return renderer ? vtkGodRaysAttachment::Find<vtkGodRaysPass>(renderer) : nullptr;
}

void vtkGodRaysPass::Detach(vtkRenderer* renderer)
{
  Internals& self = *this->Internal;
  if (!self.Attachment.Has(this, renderer))
  {
    return;
  }
  const vtkSmartPointer<vtkGodRaysPass> keep = this; // the renderer may hold the last reference
  if (self.Window)
  {
    self.Window->MakeCurrent();
    self.Release(self.Window);
  }
  self.DataLights.Remove();
  self.DataLights.Shine(renderer, {});
  self.Attachment.Detach(this, renderer);
}

bool vtkGodRaysPass::GetOcclusionImage(vtkImageData* image)
{
  Internals& self = *this->Internal;
  const bool distributed = self.Compositor && self.Compositor->IsDistributed();
  if (self.Window && self.HasRays && self.Effect->HasLayers() && !self.Effect->GetLayers() &&
    !distributed)
  {
    // one layer texture served all lights in turn
    self.KeepAllLayers = true;
    self.Window->Render();
    self.KeepAllLayers = false;
  }
  return self.Download(self.HasRays ? self.Effect->GetLayers() : nullptr, image);
}

bool vtkGodRaysPass::GetScatteringImage(vtkImageData* image)
{
  Internals& self = *this->Internal;
  return self.Download(self.HasScattering ? &self.Scattering : nullptr, image);
}

bool vtkGodRaysPass::GetMediumImage(vtkImageData* image)
{
  return this->Internal->ReadNumbers(nullptr, this->ErrorTolerance, image);
}

bool vtkGodRaysPass::GetMediumImage(vtkImageData* image, const double irradiance[3])
{
  for (int c = 0; c < 3; ++c)
  {
    if (!(irradiance[c] >= 0.0 && irradiance[c] <= 1e30)) // false for NaN
    {
      vtkErrorMacro("The irradiance must be three numbers in [0, 1e30], not "
        << irradiance[0] << " " << irradiance[1] << " " << irradiance[2] << ".");
      if (image)
      {
        image->Initialize();
      }
      return false;
    }
  }
  return this->Internal->ReadNumbers(irradiance, this->ErrorTolerance, image);
}

std::string vtkGodRaysPass::GetAdvice() const
{
  std::string lines;
  for (const std::string& concern : this->Internal->Concerns)
  {
    lines += concern + "\n";
  }
  return lines;
}

std::string vtkGodRaysPass::GetPlan() const
{
  std::string plan = this->Internal->Finder.GetPlan() + this->Internal->StagePlan;
  for (const std::string& concern : this->Internal->Concerns)
  {
    plan += "advice: " + concern + "\n";
  }
  return plan;
}

double vtkGodRaysPass::GetExposure()
{
  return this->Intensity * (this->Internal->IsMetered ? this->Internal->Exposure.Everywhere : 1.0);
}

double vtkGodRaysPass::GetDataExposure()
{
  return this->Internal->IsMetered ? this->Internal->Exposure.OverData : 1.0;
}

double vtkGodRaysPass::GetDarkDataExposure()
{
  return this->Internal->IsMetered ? this->Internal->Exposure.OverDark : 1.0;
}

double vtkGodRaysPass::GetDataGain()
{
  return this->Internal->IsMetered ? this->Internal->Exposure.DataGain : 1.0;
}

void vtkGodRaysPass::GetStageTimes(double seconds[4])
{
  Internals& self = *this->Internal;
  if (self.Window)
  {
    self.Window->MakeCurrent();
  }
  self.Timers.GetTimes(seconds);
}

void vtkGodRaysPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Internal;
  if (self.Releases) // its delegate leads back to it
  {
    return;
  }
  self.Releases = true;
  this->Superclass::ReleaseGraphicsResources(window);
  self.Release(window);
  self.RendererSteps->ReleaseGraphicsResources(window);
  self.Releases = false;
}

vtkMTimeType vtkGodRaysPass::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = std::max(time, this->Internal->Model->GetMTime());
  time = std::max(time, this->Internal->Integrator->GetMTime());
  time = std::max(time, this->Internal->Sun->GetMTime());
  for (const auto& light : this->Internal->Lights)
  {
    time = std::max(time, light->GetMTime());
  }
  return time;
}

void vtkGodRaysPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const vtkIndent next = indent.GetNextIndent();
  os << indent << "Intensity: " << this->Intensity << "\n";
  os << indent << "AutomaticExposure: " << (this->AutomaticExposure ? "on" : "off") << "\n";
  os << indent << "HighlightShoulder: " << (this->HighlightShoulder ? "on" : "off") << "\n";
  os << indent << "DarkenLightBackground: " << (this->DarkenLightBackground ? "on" : "off") << "\n";
  os << indent << "DataFirst: " << (this->DataFirst ? "on" : "off") << "\n";
  os << indent << "MostDataLightness: " << this->MostDataLightness << "\n";
  os << indent << "LightData: " << (this->LightData ? "on" : "off") << "\n";
  os << indent << "SurfaceShadows: " << (this->SurfaceShadows ? "on" : "off") << "\n";
  os << indent << "SoftShadows: " << (this->SoftShadows ? "on" : "off") << "\n";
  os << indent << "MostDataShadow: " << this->MostDataShadow << "\n";
  os << indent << "SunPlacement: " << this->SunPlacement << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "InteractiveErrorTolerance: " << this->InteractiveErrorTolerance << "\n";
  os << indent << "UntaggedPropsOcclude: " << (this->UntaggedPropsOcclude ? "on" : "off") << "\n";
  os << indent << "SourceRadius: " << this->SourceRadius << "\n";
  os << indent << "SunAngularRadius: " << this->GetSunAngularRadius() << "\n";
  os << indent << "BackgroundGlow: " << this->BackgroundGlow << "\n";
  os << indent << "BackgroundGlowRadius: " << this->BackgroundGlowRadius << "\n";
  os << indent << "BackgroundGlowFalloff: " << this->BackgroundGlowFalloff << "\n";
  os << indent << "LayerMargin: " << this->LayerMargin << "\n";
  os << indent << "Blend: " << this->Blend << "\n";
  os << indent << "DisplayTransfer: " << this->DisplayTransfer << "\n";
  os << indent << "Output: " << this->Output << "\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "MeasureTimes: " << (this->MeasureTimes ? "on" : "off") << "\n";
  os << indent << "NumberOfGeometryPasses: " << this->NumberOfGeometryPasses << "\n";
  os << indent << "NumberOfLights: " << this->GetNumberOfLights() << "\n";
  os << indent << "Model:\n";
  this->Internal->Model->PrintSelf(os, next);
  os << indent << "Integrator:\n";
  this->Internal->Integrator->PrintSelf(os, next);
}
