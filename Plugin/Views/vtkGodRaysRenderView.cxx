// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRenderView.h"

#include "vtkCompositeRepresentation.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSunPosition.h"
#include "vtkGodRaysViewCompositor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVCenterAxesActor.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVGridAxes3DActor.h"
#include "vtkPVLODActor.h"
#include "vtkPVLight.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysRenderView);

namespace
{
template <class Model>
bool HasPreset(const std::string& name)
{
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    if (name == Model::GetPresetName(i))
    {
      return true;
    }
  }
  return false;
}

template <class Model>
std::string ListPresets()
{
  std::string names;
  for (int i = 0; i < Model::GetNumberOfPresets(); ++i)
  {
    names += std::string(", ") + Model::GetPresetName(i);
  }
  return names;
}

/// Props that show axes rather than data.
bool IsAnnotation(vtkProp* prop)
{
  for (const char* type : { "vtkPVCenterAxesActor", "vtkGridAxes3DActor", "vtkCubeAxesActor",
         "vtkPolarAxesActor", "vtkAxesActor", "vtkAxisActor" })
  {
    if (prop->IsA(type))
    {
      return true;
    }
  }
  return false;
}

/// The one slot that ParaView has for image passes, shared by the rays and ParaView's tone mapping,
/// which comes after them.
class ToneMappedPass : public vtkImageProcessingPass
{
public:
  static ToneMappedPass* New();
  vtkTypeMacro(ToneMappedPass, vtkImageProcessingPass);

  void Render(const vtkRenderState* s) override
  {
    this->Rays->SetDelegatePass(this->DelegatePass);
    this->ToneMapping->SetDelegatePass(this->Rays);
    this->ToneMapping->Render(s);
    this->NumberOfRenderedProps = this->ToneMapping->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    for (vtkImageProcessingPass* pass : { this->Rays.Get(), this->ToneMapping.Get() })
    {
      if (pass)
      {
        pass->ReleaseGraphicsResources(window);
      }
    }
  }

  vtkSmartPointer<vtkImageProcessingPass> Rays;
  vtkSmartPointer<vtkImageProcessingPass> ToneMapping;
};
vtkStandardNewMacro(ToneMappedPass);
}

//------------------------------------------------------------------------------
struct vtkGodRaysRenderView::vtkInternals
{
  vtkNew<vtkGodRaysPass> Pass;
  vtkNew<ToneMappedPass> Chain;
  vtkNew<vtkGodRaysViewCompositor> Compositor;
  vtkSmartPointer<vtkGodRaysModel> CustomModel;
  vtkNew<vtkGodRaysRadialModel> Look;
  vtkNew<vtkGodRaysHomogeneousModel> Medium;
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  std::string Preset = "default";
  vtkNew<vtkLight> Sun;
  vtkNew<vtkGodRaysSunPosition> SunPosition;
  std::string Plan;

  std::vector<vtkSmartPointer<vtkLight>> ChosenLights;

  std::set<vtkProp*> KnownProps; // only compared
  std::map<vtkDataRepresentation*, std::vector<vtkWeakPointer<vtkProp>>> Props;
};

//------------------------------------------------------------------------------
vtkGodRaysRenderView::vtkGodRaysRenderView()
  : Internals(new vtkInternals)
{
  this->Internals->CustomModel = this->Internals->Pass->GetModel();
  this->Internals->Look->ApplyPreset("default");
  this->Internals->Pass->SetModel(this->Internals->Look);
  this->Internals->Chain->Rays = this->Internals->Pass;
  this->Internals->Pass->SetCompositor(this->Internals->Compositor);
  this->UpdatePasses();
}

//------------------------------------------------------------------------------
vtkGodRaysRenderView::~vtkGodRaysRenderView()
{
  this->Internals->Chain->ReleaseGraphicsResources(this->GetRenderWindow());
  this->SynchronizedRenderers->SetImageProcessingPass(nullptr);
}

//------------------------------------------------------------------------------
vtkGodRaysPass* vtkGodRaysRenderView::GetGodRaysPass()
{
  return this->Internals->Pass;
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetUseGodRays(bool use)
{
  if (this->UseGodRays != use)
  {
    this->UseGodRays = use;
    this->UpdatePasses();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetUseToneMapping(bool use)
{
  if ((this->Internals->Chain->ToneMapping != nullptr) != use)
  {
    // The superclass takes the slot if it is empty, and leaves it if the slot is its own.
    this->SynchronizedRenderers->SetImageProcessingPass(
      use ? nullptr : this->Internals->Chain->ToneMapping.Get());
    this->Superclass::SetUseToneMapping(use);
    this->Internals->Chain->ToneMapping =
      use ? this->SynchronizedRenderers->GetImageProcessingPass() : nullptr;
    this->UpdatePasses();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::UpdatePasses()
{
  vtkInternals& self = *this->Internals;
  vtkImageProcessingPass* pass = self.Chain->ToneMapping;
  self.Pass->SetDisplayTransfer(
    pass ? vtkGodRaysPass::POWER_TRANSFER : vtkGodRaysPass::SRGB_TRANSFER);
  if (this->UseGodRays)
  {
    pass = pass ? static_cast<vtkImageProcessingPass*>(self.Chain) : self.Pass;
  }
  this->SynchronizedRenderers->SetImageProcessingPass(pass);
}

//------------------------------------------------------------------------------
bool vtkGodRaysRenderView::SetMode(const char* name, int& mode, int value, int last)
{
  if (value < 0 || value > last)
  {
    vtkErrorMacro(<< name << " must be in 0.." << last << ", not " << value << "; it stays " << mode
                  << ".");
    return false;
  }
  mode = value;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetLightSource(int mode)
{
  this->SetMode("LightSource", this->LightSource, mode, TAGGED_ONLY);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunFrame(int frame)
{
  this->SetMode("SunFrame", this->SunFrame, frame, UP_AND_NORTH);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunAzimuth(double degrees)
{
  if (!vtkMath::IsFinite(degrees))
  {
    vtkErrorMacro("SunAzimuth must be a finite number, not " << degrees << "; it stays "
                                                             << this->SunAzimuth << ".");
    return;
  }
  this->SunAzimuth = degrees;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunElevation(double degrees)
{
  if (!vtkMath::IsFinite(degrees))
  {
    vtkErrorMacro("SunElevation must be a finite number in [-90, 90], not "
      << degrees << "; it stays " << this->SunElevation << ".");
    return;
  }
  this->SunElevation = vtkMath::ClampValue(degrees, -90.0, 90.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunUp(double x, double y, double z)
{
  const double up[3] = { x, y, z };
  vtkMath::Assign(up, this->SunUp);
  this->SunErrorTold = false;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunNorth(double x, double y, double z)
{
  const double north[3] = { x, y, z };
  vtkMath::Assign(north, this->SunNorth);
  this->SunErrorTold = false;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunPosition(int mode)
{
  this->SetMode("SunPosition", this->SunPosition, mode, DATE_AND_PLACE);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunDate(int year, int month, int day)
{
  this->Internals->SunPosition->SetDate(year, month, day);
  this->Modified();
}

//------------------------------------------------------------------------------
#define vtkGodRaysForwardSunMacro(name)                                                            \
  void vtkGodRaysRenderView::SetSun##name(double value)                                            \
  {                                                                                                \
    this->Internals->SunPosition->Set##name(value);                                                \
    this->Modified();                                                                              \
  }
vtkGodRaysForwardSunMacro(TimeOfDay);
vtkGodRaysForwardSunMacro(TimeZone);
vtkGodRaysForwardSunMacro(Latitude);
vtkGodRaysForwardSunMacro(Longitude);

//------------------------------------------------------------------------------
double* vtkGodRaysRenderView::GetSunAngles()
{
  const bool angles = this->SunPosition == AZIMUTH_AND_ELEVATION;
  this->SunAngles[0] = angles ? this->SunAzimuth : this->Internals->SunPosition->GetAzimuth();
  this->SunAngles[1] = angles ? this->SunElevation : this->Internals->SunPosition->GetElevation();
  return this->SunAngles;
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetSunColor(double red, double green, double blue)
{
  double color[3] = { red, green, blue };
  for (double& each : color)
  {
    if (!vtkMath::IsFinite(each))
    {
      vtkErrorMacro("SunColor must be three numbers in [0, 1], not ("
        << red << ", " << green << ", " << blue << "); it stays as it is.");
      return;
    }
    each = vtkMath::ClampValue(each, 0.0, 1.0);
  }
  this->Internals->Sun->SetDiffuseColor(color);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetPreset(const char* name)
{
  vtkInternals& self = *this->Internals;
  const std::string preset = name ? name : "";
  if (preset == self.Preset)
  {
    return;
  }
  vtkGodRaysModel* model = nullptr;
  if (preset == "custom")
  {
    model = self.CustomModel;
  }
  else if (HasPreset<vtkGodRaysHomogeneousModel>(preset))
  {
    model = self.Medium;
  }
  else if (HasPreset<vtkGodRaysRadialModel>(preset))
  {
    model = self.Look;
  }
  else
  {
    vtkErrorMacro("There is no preset \""
      << preset << "\"; it stays " << self.Preset << ". There are: custom"
      << ListPresets<vtkGodRaysRadialModel>() << ListPresets<vtkGodRaysHomogeneousModel>() << ".");
    return;
  }
  self.Preset = preset;
  if (preset != "custom")
  {
    model->ApplyPreset(name);
  }
  this->UseModel(model);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetModel(vtkGodRaysModel* model)
{
  this->Internals->CustomModel = model;
  if (this->Internals->Preset == "custom")
  {
    this->UseModel(model);
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetIntegrator(vtkGodRaysIntegrator* integrator)
{
  this->Internals->Integrator = integrator;
  this->UseModel(this->Internals->Pass->GetModel());
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::UseModel(vtkGodRaysModel* model)
{
  vtkInternals& self = *this->Internals;
  self.Pass->SetModel(model);
  const bool fits = self.Integrator && self.Integrator->Supports(self.Pass->GetModel());
  self.Pass->SetIntegrator(fits ? self.Integrator.Get() : nullptr);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::SetWorldUnitInMeters(double meters)
{
  this->Internals->Medium->SetWorldUnitInMeters(meters);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::AddChosenLight(vtkLight* light)
{
  auto& lights = this->Internals->ChosenLights;
  if (light && std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    lights.emplace_back(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::RemoveChosenLight(vtkLight* light)
{
  auto& lights = this->Internals->ChosenLights;
  const auto found = std::find(lights.begin(), lights.end(), light);
  if (found != lights.end())
  {
    lights.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
#define vtkGodRaysForwardMacro(name, type)                                                         \
  void vtkGodRaysRenderView::Set##name(type value)                                                 \
  {                                                                                                \
    this->Internals->Pass->Set##name(value);                                                       \
  }
vtkGodRaysForwardMacro(Intensity, double);
vtkGodRaysForwardMacro(ErrorTolerance, double);
vtkGodRaysForwardMacro(InteractiveErrorTolerance, double);
vtkGodRaysForwardMacro(ResolutionScale, double);
vtkGodRaysForwardMacro(UntaggedPropsOcclude, bool);
vtkGodRaysForwardMacro(SourceRadius, double);
vtkGodRaysForwardMacro(SunAngularRadius, double);
vtkGodRaysForwardMacro(BackgroundGlow, double);
vtkGodRaysForwardMacro(BackgroundGlowRadius, double);
vtkGodRaysForwardMacro(BackgroundGlowFalloff, double);
vtkGodRaysForwardMacro(LayerMargin, double);
vtkGodRaysForwardMacro(Blend, int);
vtkGodRaysForwardMacro(Output, int);
vtkGodRaysForwardMacro(Precision, int);
vtkGodRaysForwardMacro(MeasureTimes, bool);

//------------------------------------------------------------------------------
const char* vtkGodRaysRenderView::GetPlan()
{
  this->Internals->Plan = this->Internals->Pass->GetPlan();
  return this->Internals->Plan.c_str();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::AddRepresentationInternal(vtkDataRepresentation* representation)
{
  this->Superclass::AddRepresentationInternal(representation);

  // It has just been added to the view: the props that are new are its own.
  vtkInternals& self = *this->Internals;
  std::set<vtkProp*> present;
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = this->GetRenderer()->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    present.insert(prop);
    if (!self.KnownProps.count(prop) && !IsAnnotation(prop))
    {
      self.Props[representation].emplace_back(prop);
    }
  }
  self.KnownProps.swap(present);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::RemoveRepresentationInternal(vtkDataRepresentation* representation)
{
  vtkInternals& self = *this->Internals;
  const auto found = self.Props.find(representation);
  if (found != self.Props.end())
  {
    for (vtkProp* prop : found->second)
    {
      self.KnownProps.erase(prop);
    }
    self.Props.erase(found);
  }
  this->Superclass::RemoveRepresentationInternal(representation);
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  // With an image pass, ParaView would smooth edges twice: as the renderer draws, and by a pass.
  // Where pictures are joined, the former is done to the joined one; elsewhere the latter is, so
  // that the edges of shafts are smoothed alike.
  const bool joined = this->SynchronizedRenderers->GetEnabled();
  (joined
      ? this->SynchronizedRenderers->SetUseFXAA(false)
      : this->GetRenderer()->SetUseFXAA(this->GetRenderer()->GetUseFXAA() && !this->UseGodRays));

  // Translucent geometry and volumes are joined in order, and then without depth.
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool distributed = joined && controller && controller->GetNumberOfProcesses() > 1;
  const bool hasDepth = !this->GetUseOrderedCompositing();
  this->SynchronizedRenderers->SetUseDepthBuffer(this->UseGodRays && hasDepth);
  this->Internals->Compositor->Update(this->GetRenderer(), distributed, hasDepth);

  this->UpdateRoles();
  this->UpdateLights();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::UpdateRoles()
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = this->GetRenderer()->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (IsAnnotation(prop))
    {
      vtkGodRaysPass::SetRole(prop, vtkGodRaysPass::IGNORED);
    }
  }
  for (int i = 0; i < this->GetNumberOfRepresentations(); ++i)
  {
    auto representation = vtkCompositeRepresentation::SafeDownCast(this->GetRepresentation(i));
    vtkInformation* keys = representation ? representation->GetInformation() : nullptr;
    if (!keys || !keys->Has(vtkGodRaysPass::ROLE()))
    {
      continue;
    }
    const auto found = this->Internals->Props.find(representation->GetActiveRepresentation());
    if (found != this->Internals->Props.end())
    {
      for (vtkProp* prop : found->second)
      {
        if (prop)
        {
          vtkGodRaysPass::SetRole(prop, keys->Get(vtkGodRaysPass::ROLE()));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkGodRaysRenderView::UpdateSun()
{
  static const double axes[][2][3] = { // up and north, by SunFrame
    { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 } }, { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } },
    { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 } }, { { 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 } }
  };
  const bool given = this->SunFrame == UP_AND_NORTH;
  const double* up = given ? this->SunUp : axes[this->SunFrame][0];
  const double* north = given ? this->SunNorth : axes[this->SunFrame][1];
  const double* angles = this->GetSunAngles();
  vtkInternals& self = *this->Internals;
  double direction[3];
  if (!vtkGodRaysSunPosition::ComputeDirection(angles[0], angles[1], up, north, direction))
  {
    if (!this->SunErrorTold)
    {
      vtkErrorMacro("There is no sun: SunUp and SunNorth must be finite, not 0 and not parallel.");
      this->SunErrorTold = true;
    }
    return false;
  }
  self.Sun->SetLightType(
    this->SunFrame == CAMERA ? VTK_LIGHT_TYPE_CAMERA_LIGHT : VTK_LIGHT_TYPE_SCENE_LIGHT);
  self.Sun->SetFocalPoint(0.0, 0.0, 0.0);
  self.Sun->SetPosition(direction);
  // At night it does not shine; a sun by its angles may well stand below the scene.
  return this->SunPosition == AZIMUTH_AND_ELEVATION ||
    angles[1] > -self.Pass->GetSunAngularRadius();
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::UpdateLights()
{
  vtkInternals& self = *this->Internals;
  std::vector<vtkLight*> lights;
  if (this->LightSource == SUN)
  {
    if (this->UpdateSun())
    {
      lights.push_back(self.Sun);
    }
  }
  else if (this->LightSource == VIEW_LIGHTS)
  {
    vtkCollectionSimpleIterator iterator;
    vtkLightCollection* all = this->GetRenderer()->GetLights();
    all->InitTraversal(iterator);
    while (vtkLight* light = all->GetNextLight(iterator))
    {
      if (light->IsA("vtkPVLight")) // not those of the light kit
      {
        lights.push_back(light);
      }
    }
  }
  lights.insert(lights.end(), self.ChosenLights.begin(), self.ChosenLights.end());

  std::vector<vtkLight*> former;
  for (int i = 0; i < self.Pass->GetNumberOfLights(); ++i)
  {
    former.push_back(self.Pass->GetLight(i));
  }
  if (former != lights)
  {
    self.Pass->RemoveAllLights();
    for (vtkLight* light : lights)
    {
      self.Pass->AddLight(light);
    }
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysRenderView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseGodRays: " << (this->UseGodRays ? "on" : "off") << "\n";
  os << indent << "LightSource: " << this->LightSource << "\n";
  os << indent << "SunFrame: " << this->SunFrame << "\n";
  os << indent << "SunAzimuth: " << this->SunAzimuth << "\n";
  os << indent << "SunElevation: " << this->SunElevation << "\n";
  os << indent << "SunUp: (" << this->SunUp[0] << ", " << this->SunUp[1] << ", " << this->SunUp[2]
     << ")\n";
  os << indent << "SunNorth: (" << this->SunNorth[0] << ", " << this->SunNorth[1] << ", "
     << this->SunNorth[2] << ")\n";
  os << indent << "SunPosition: " << this->SunPosition << "\n";
  this->Internals->SunPosition->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Preset: " << this->Internals->Preset << "\n";
  os << indent << "Pass:\n";
  this->Internals->Pass->PrintSelf(os, indent.GetNextIndent());
}
