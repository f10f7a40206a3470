// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRenderView.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCompositeRepresentation.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysPresets.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkGodRaysViewCompositor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVCenterAxesActor.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVGridAxes3DActor.h"
#include "vtkPVLODActor.h"
#include "vtkPVLight.h"
#include "vtkPVSession.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProcessModule.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysRenderView);

namespace
{
/// Props that show axes rather than data.
bool IsAnnotation(vtkProp* prop)
{
  // The grid of axes is ParaView's vtkGridAxes3DActor to 5.13, VTK's vtkGridAxesActor3D since 6.0.
  for (const char* type : { "vtkPVCenterAxesActor", "vtkGridAxes3DActor", "vtkGridAxesActor3D",
         "vtkCubeAxesActor", "vtkPolarAxesActor", "vtkAxesActor", "vtkAxisActor" })
  {
    if (prop->IsA(type))
    {
      return true;
    }
  }
  return false;
}

/// Whether ANARI draws a view; ParaView has it since 6.1.
template <typename View>
auto IsDrawnByANARI(View* view, int) -> decltype(view->GetEnableANARI())
{
  return view->GetEnableANARI();
}
[[maybe_unused]] bool IsDrawnByANARI(vtkPVRenderView*, long)
{
  return false;
}

/// The one slot that ParaView has for image passes, shared by all that a view has.
class PassChain : public vtkImageProcessingPass
{
public:
  static PassChain* New();
  vtkTypeMacro(PassChain, vtkImageProcessingPass);

  void Render(const vtkRenderState* s) override
  {
    vtkRenderPass* scene = this->UsesDelegate ? this->DelegatePass : nullptr;
    for (vtkImageProcessingPass* pass : this->Passes)
    {
      pass->SetDelegatePass(scene);
      scene = pass;
    }
    scene->Render(s);
    this->NumberOfRenderedProps = scene->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    for (vtkImageProcessingPass* pass : this->Passes)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }

  std::vector<vtkSmartPointer<vtkImageProcessingPass>> Passes; // each draws over the one before
  bool UsesDelegate = true; // or the first pass draws the scene by itself
};
vtkStandardNewMacro(PassChain);
}

struct vtkGodRaysRenderView::vtkInternals
{
  vtkSmartPointer<vtkGodRaysSun> Sun = vtkSmartPointer<vtkGodRaysSun>::New();
  vtkSmartPointer<vtkGodRaysSkyPass> Sky = vtkSmartPointer<vtkGodRaysSkyPass>::New();
  vtkSmartPointer<vtkGodRaysPass> Pass = vtkSmartPointer<vtkGodRaysPass>::New();
  vtkSmartPointer<vtkImageProcessingPass> ToneMapping; // ParaView's
  vtkNew<PassChain> Chain;
  vtkNew<vtkGodRaysViewCompositor> Compositor;
  vtkSmartPointer<vtkGodRaysModel> CustomModel;
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  std::string Preset = "default";
  double WorldUnitInMeters = 0.0;
  vtkNew<vtkLight> SunLight;
  std::string Plan;
  bool IsRayTraced = false;
  vtkNew<vtkCallbackCommand> Silence; // does nothing: warnings are not shown

  std::vector<vtkSmartPointer<vtkLight>> ChosenLights;

  std::vector<vtkWeakPointer<vtkProp>> KnownProps; // an address may be used again
  std::map<vtkDataRepresentation*, std::vector<vtkWeakPointer<vtkProp>>> Props;
};

vtkGodRaysRenderView::vtkGodRaysRenderView()
  : Internals(new vtkInternals)
{
  this->Internals->CustomModel = this->Internals->Pass->GetModel();
  this->Internals->Pass->SetModel(
    vtk::TakeSmartPointer(vtkGodRaysPresets::NewModel(this->Internals->Preset.c_str())));
  this->UpdatePasses();
}

vtkGodRaysRenderView::~vtkGodRaysRenderView()
{
  this->Internals->Chain->ReleaseGraphicsResources(this->GetRenderWindow());
  this->SynchronizedRenderers->SetImageProcessingPass(nullptr);
}

void vtkGodRaysRenderView::SetSun(vtkGodRaysSun* sun)
{
  if (sun)
  {
    this->Internals->Sun = sun;
    this->UpdatePasses();
    this->Modified();
  }
}

vtkGodRaysSun* vtkGodRaysRenderView::GetSun()
{
  return this->Internals->Sun;
}

void vtkGodRaysRenderView::SetGodRaysPass(vtkGodRaysPass* pass)
{
  if (pass)
  {
    const vtkSmartPointer<vtkGodRaysModel> model = this->Internals->Pass->GetModel();
    this->Internals->Pass = pass;
    this->UseModel(model);
    this->UpdatePasses();
  }
}

vtkGodRaysPass* vtkGodRaysRenderView::GetGodRaysPass()
{
  return this->Internals->Pass;
}

void vtkGodRaysRenderView::SetSkyPass(vtkGodRaysSkyPass* pass)
{
  if (pass)
  {
    pass->SetWorldUnitInMeters(this->Internals->Sky->GetWorldUnitInMeters());
    this->Internals->Sky = pass;
    this->UpdatePasses();
    this->Modified();
  }
}

vtkGodRaysSkyPass* vtkGodRaysRenderView::GetSkyPass()
{
  return this->Internals->Sky;
}

void vtkGodRaysRenderView::SetUseGodRays(bool use)
{
  if (this->UseGodRays != use)
  {
    this->UseGodRays = use;
    this->UpdatePasses();
    this->Modified();
  }
}

void vtkGodRaysRenderView::SetUseSky(bool use)
{
  if (this->UseSky != use)
  {
    this->UseSky = use;
    this->UpdatePasses();
    this->Modified();
  }
}

void vtkGodRaysRenderView::SetUseToneMapping(bool use)
{
  if ((this->Internals->ToneMapping != nullptr) != use)
  {
    // The superclass takes the slot if it is empty, and leaves it if the slot is its own.
    this->SynchronizedRenderers->SetImageProcessingPass(
      use ? nullptr : this->Internals->ToneMapping.Get());
    this->Superclass::SetUseToneMapping(use);
    this->Internals->ToneMapping =
      use ? this->SynchronizedRenderers->GetImageProcessingPass() : nullptr;
    this->UpdatePasses();
  }
}

void vtkGodRaysRenderView::UpdatePasses()
{
  vtkInternals& self = *this->Internals;
  const int transfer =
    self.ToneMapping ? vtkGodRaysPass::POWER_TRANSFER : vtkGodRaysPass::SRGB_TRANSFER;
  self.Pass->SetDisplayTransfer(transfer);
  self.Pass->SetCompositor(self.Compositor);
  self.Pass->SetSun(self.Sun);
  self.Pass->GetSunPlacer()->SetLowest(0.52); // above the horizon, should a sky be switched on
  self.Pass->RemoveObservers(vtkGodRaysPass::SunPlacedEvent);
  self.Pass->AddObserver(
    vtkGodRaysPass::SunPlacedEvent, this, &vtkGodRaysRenderView::TakePlacedSun);
  self.Sky->SetDisplayTransfer(transfer);
  self.Sky->SetCompositor(self.Compositor);
  self.Sky->SetSun(self.Sun);
  auto& passes = self.Chain->Passes;
  passes.clear();
  if (this->UseSky && !self.IsRayTraced)
  {
    passes.emplace_back(self.Sky);
  }
  if (this->UseGodRays && !self.IsRayTraced)
  {
    passes.emplace_back(self.Pass);
  }
  if (self.ToneMapping)
  {
    passes.emplace_back(self.ToneMapping);
  }
  this->SynchronizedRenderers->SetImageProcessingPass(passes.empty() ? nullptr : self.Chain.Get());
}

void vtkGodRaysRenderView::SetLightSource(int mode)
{
  if (mode < SUN || mode > TAGGED_ONLY)
  {
    vtkErrorMacro("LightSource must be in 0.." << TAGGED_ONLY << ", not " << mode << "; it stays "
                                               << this->LightSource << ".");
    return;
  }
  this->LightSource = mode;
  this->Modified();
}

void vtkGodRaysRenderView::SetPlaceSun(bool place)
{
  this->PlaceSun = place;
  std::fill_n(this->PlacedSun, 3, 0.0);
  this->Modified();
}

void vtkGodRaysRenderView::TakePlacedSun(vtkObject*, unsigned long, void* light)
{
  vtkInternals& self = *this->Internals;
  vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
  vtkGodRaysSunPlacer* placer = self.Pass->GetSunPlacer();
  const double* place = placer->GetPlace(); // the usual one if none is good
  double direction[3];
  if (placer->GetCoverage() > 0.0 &&
    placer->GetDirection(this->GetRenderer(), place[0], place[1], direction) &&
    self.Sun->MoveTo(camera, direction))
  {
    // As they stand in the panel and in state files.
    self.Sun->SetAzimuth(std::round(10.0 * self.Sun->GetAzimuth()) / 10.0);
    self.Sun->SetElevation(std::round(10.0 * self.Sun->GetElevation()) / 10.0);
    this->PlacedSun[0] = self.Sun->GetAzimuth();
    this->PlacedSun[1] = self.Sun->GetElevation();
    this->PlacedSun[2] = 1.0;
    const double* color = self.Sun->GetColor();
    if (*std::min_element(color, color + 3) == 1.0) // white, which it is unless set
    {
      self.Sun->SetColor(static_cast<vtkLight*>(light)->GetDiffuseColor());
    }
    std::copy_n(color, 3, this->PlacedSun + 3);
    this->PlaceSun = false;
    self.Pass->SetSunPlacement(vtkGodRaysPass::SUN_BY_HAND);
  }
  this->UpdateLights(); // instead of the pass's own
}

void vtkGodRaysRenderView::SetPreset(const char* name)
{
  vtkInternals& self = *this->Internals;
  const std::string preset = name ? name : "";
  if (preset == self.Preset)
  {
    return;
  }
  vtkSmartPointer<vtkGodRaysModel> model = self.CustomModel;
  if (preset != "custom")
  {
    model = vtk::TakeSmartPointer(vtkGodRaysPresets::NewModel(name));
    if (!model)
    {
      vtkErrorMacro("There is no preset \"" << preset << "\"; it stays " << self.Preset
                                            << ". There are: custom, "
                                            << vtkGodRaysPresets::ListNames() << ".");
      return;
    }
  }
  self.Preset = preset;
  this->UseModel(model);
  this->SetWorldUnitInMeters(self.WorldUnitInMeters);
}

void vtkGodRaysRenderView::SetModel(vtkGodRaysModel* model)
{
  this->Internals->CustomModel = model;
  if (this->Internals->Preset == "custom")
  {
    this->UseModel(model);
  }
}

void vtkGodRaysRenderView::SetIntegrator(vtkGodRaysIntegrator* integrator)
{
  this->Internals->Integrator = integrator;
  this->UseModel(this->Internals->Pass->GetModel());
}

void vtkGodRaysRenderView::UseModel(vtkGodRaysModel* model)
{
  vtkInternals& self = *this->Internals;
  self.Pass->SetModel(model);
  const bool fits = self.Integrator && self.Integrator->Supports(self.Pass->GetModel());
  self.Pass->SetIntegrator(fits ? self.Integrator.Get() : nullptr);
  this->Modified();
}

void vtkGodRaysRenderView::SetWorldUnitInMeters(double meters)
{
  vtkInternals& self = *this->Internals;
  self.WorldUnitInMeters = meters;
  self.Sky->SetWorldUnitInMeters(meters > 0.0 ? meters : 1.0);
  auto medium = vtkGodRaysMediumModel::SafeDownCast(self.Pass->GetModel());
  if (medium && self.Preset != "custom")
  {
    medium->SetWorldUnitInMeters(meters);
  }
  this->Modified();
}

void vtkGodRaysRenderView::AddChosenLight(vtkLight* light)
{
  auto& lights = this->Internals->ChosenLights;
  if (light && std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    lights.emplace_back(light);
    this->Modified();
  }
}

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

const char* vtkGodRaysRenderView::GetPlan()
{
  this->Internals->Plan =
    (this->UseSky ? this->Internals->Sky->GetPlan() : "") + this->Internals->Pass->GetPlan();
  return this->Internals->Plan.c_str();
}

void vtkGodRaysRenderView::AddRepresentationInternal(vtkDataRepresentation* representation)
{
  this->Superclass::AddRepresentationInternal(representation);

  // It has just been added to the view: the props that are new are its own.
  vtkInternals& self = *this->Internals;
  std::vector<vtkWeakPointer<vtkProp>> present;
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = this->GetRenderer()->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    present.emplace_back(prop);
    const bool known =
      std::find(self.KnownProps.begin(), self.KnownProps.end(), prop) != self.KnownProps.end();
    if (!known && !IsAnnotation(prop))
    {
      self.Props[representation].emplace_back(prop);
    }
  }
  self.KnownProps.swap(present);
}

void vtkGodRaysRenderView::RemoveRepresentationInternal(vtkDataRepresentation* representation)
{
  vtkInternals& self = *this->Internals;
  const auto found = self.Props.find(representation);
  if (found != self.Props.end())
  {
    for (vtkProp* prop : found->second)
    {
      self.KnownProps.erase(
        std::remove(self.KnownProps.begin(), self.KnownProps.end(), prop), self.KnownProps.end());
    }
    self.Props.erase(found);
  }
  this->Superclass::RemoveRepresentationInternal(representation);
}

void vtkGodRaysRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  this->UpdateRayTracing();
  // With an image pass, ParaView would smooth edges twice: as the renderer draws, and by a pass.
  // Where pictures are joined, the former is done to the joined one; elsewhere the latter is, so
  // that the edges of shafts are smoothed alike.
  const bool drawsSky = this->UseSky && !this->Internals->IsRayTraced;
  const bool draws = drawsSky || (this->UseGodRays && !this->Internals->IsRayTraced);
  const bool joined = this->SynchronizedRenderers->GetEnabled();
  (joined ? this->SynchronizedRenderers->SetUseFXAA(false)
          : this->GetRenderer()->SetUseFXAA(this->GetRenderer()->GetUseFXAA() && !draws));

  // Translucent geometry and volumes are joined in order, and then without depth.
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool distributed = joined && controller && controller->GetNumberOfProcesses() > 1;
  const bool hasDepth = !this->GetUseOrderedCompositing();
  this->SynchronizedRenderers->SetUseDepthBuffer(draws && hasDepth);
  this->Internals->Compositor->Update(this->GetRenderer(), distributed, hasDepth);
  // So that what is translucent is before the sky; pictures that are joined have alpha for that.
  this->Internals->Chain->UsesDelegate = !drawsSky || distributed;

  // A client that shows its server's picture draws an empty one: the server tells why it has no rays.
  auto session = vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetSession());
  this->Internals->Pass->RemoveObserver(this->Internals->Silence);
  if (session && !session->HasProcessRole(vtkPVSession::RENDER_SERVER) &&
    this->GetUseDistributedRenderingForRender())
  {
    this->Internals->Pass->AddObserver(vtkCommand::WarningEvent, this->Internals->Silence);
  }

  this->UpdateRoles();
  this->UpdateLights();
  const bool placesSun = this->PlaceSun && this->LightSource == SUN && !interactive &&
    !this->GetRenderer()->GetActiveCamera()->GetParallelProjection();
  this->Internals->Pass->SetSunPlacement(
    placesSun ? vtkGodRaysPass::SUN_ONCE : vtkGodRaysPass::SUN_BY_HAND);
}

// A ray tracer draws the scene as it does without us: nothing of it is where our passes look.
void vtkGodRaysRenderView::UpdateRayTracing()
{
  const char* tracer = this->GetEnableOSPRay() ? "OSPRay"
    : IsDrawnByANARI(this, 0)                  ? "ANARI"
                                               : nullptr;
  if (this->Internals->IsRayTraced == (tracer != nullptr))
  {
    return;
  }
  this->Internals->IsRayTraced = tracer != nullptr;
  this->UpdatePasses();
  if (tracer && (this->UseGodRays || this->UseSky))
  {
    vtkWarningMacro("God rays and sky are not drawn while "
      << tracer << " draws this view. Switch ray tracing off to see them.");
  }
}

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

// Whether it shines. With a sky it has the colour that the air leaves, and sets.
bool vtkGodRaysRenderView::UpdateSun()
{
  vtkInternals& self = *this->Internals;
  return this->UseSky ? self.Sky->UpdateLight(self.SunLight) && self.Sun->IsAboveHorizon()
                      : self.Sun->UpdateLight(self.SunLight) && self.Sun->Shines();
}

void vtkGodRaysRenderView::UpdateLights()
{
  vtkInternals& self = *this->Internals;
  std::vector<vtkLight*> lights;
  if (this->LightSource == SUN)
  {
    if (this->UpdateSun())
    {
      lights.push_back(self.SunLight);
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

void vtkGodRaysRenderView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseGodRays: " << (this->UseGodRays ? "on" : "off") << "\n";
  os << indent << "LightSource: " << this->LightSource << "\n";
  os << indent << "PlaceSun: " << (this->PlaceSun ? "on" : "off") << "\n";
  os << indent << "PlacedSun: " << this->PlacedSun[0] << " " << this->PlacedSun[1] << " "
     << this->PlacedSun[2] << "\n";
  os << indent << "Sun:\n";
  this->Internals->Sun->PrintSelf(os, indent.GetNextIndent());
  os << indent << "UseSky: " << (this->UseSky ? "on" : "off") << "\n";
  os << indent << "Sky:\n";
  this->Internals->Sky->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Preset: " << this->Internals->Preset << "\n";
  os << indent << "Pass:\n";
  this->Internals->Pass->PrintSelf(os, indent.GetNextIndent());
}
