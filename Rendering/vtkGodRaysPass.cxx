// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPass.h"

#include "vtkCamera.h"
#include "vtkGodRaysAttachment.h"
#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysOcclusionPass.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysScene.h"
#include "vtkGodRaysSceneCopy.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSource.h"
#include "vtkGodRaysSourceFinder.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysTransfer.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkGodRaysPass);
vtkInformationKeyMacro(vtkGodRaysPass, ROLE, Integer);

namespace
{
/// The number of tiles of a large screenshot, across or up, whichever is more; 1 for a whole picture.
double GetTiles(vtkRenderWindow* window)
{
  int tiles[2];
  window->GetTileScale(tiles);
  return std::max(tiles[0], tiles[1]);
}

bool IsDisabledByEnvironment()
{
  const char* value = std::getenv("GODRAYS_DISABLE");
  return value && *value && std::string(value) != "0";
}
}

//------------------------------------------------------------------------------
struct vtkGodRaysPass::Internals
{
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  vtkSmartPointer<vtkGodRaysModel> Model;
  vtkGodRaysMediumModel* MediumModel = nullptr; // the model, if it is one
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  bool IntegratorIsModels = false; // nobody set it
  vtkSmartPointer<vtkGodRaysCompositor> Compositor;

  vtkGodRaysAttachment Attachment;

  vtkNew<vtkGodRaysScene> RendererSteps;
  vtkNew<vtkGodRaysOcclusionPass> Occlusion;
  vtkNew<vtkGodRaysBlendPass> Blending;
  vtkGodRaysSceneCopy Scene;   // colour and depth of the viewport
  vtkGodRaysTarget Backdrop;   // background, where the scene is drawn over black
  vtkGodRaysSum Scattering;    // light of all layers
  vtkGodRaysSum Layers;        // their sum; of several lights only when it is asked for
  vtkGodRaysViewDepths Depths; // for models of a medium
  vtkGodRaysMedium Medium;
  vtkTextureObject* SeenDepth = nullptr; // where view rays end
  vtkGodRaysTimers Timers;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the resources
  vtkMTimeType ContextTime = 0;                 // when its context was made
  bool HasScattering = false;                   // of the last frame
  bool HasLayer = false;
  bool HasAllLayers = false;
  bool HasBackdrop = false;
  bool KeepAllLayers = false;
  int NumberOfSources = 0; // of the last frame
  vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB;
  double Margin = 0.0;        // of the layers of this frame
  bool DrawsScene = false;    // at this moment
  bool Releases = false;      // at this moment
  bool IsOwnDelegate = false; // its delegate called it while it drew the scene
  std::string LightPlan;
  std::string StagePlan;
  std::string Complaint; // that has been made already

  void Release(vtkWindow* window)
  {
    this->Occlusion->ReleaseGraphicsResources(window);
    if (this->Integrator)
    {
      this->Integrator->ReleaseGraphicsResources(window);
    }
    this->Blending->ReleaseGraphicsResources(window);
    this->Scene.Release(window);
    this->Backdrop.Release(window);
    this->Scattering.Release(window);
    this->Layers.Release(window);
    this->Depths.Release(window);
    this->Timers.Release(this->Window);
    this->HasScattering = false;
    this->HasLayer = false;
    this->HasAllLayers = false;
    this->Window = nullptr;
  }
};

//------------------------------------------------------------------------------
vtkGodRaysPass::vtkGodRaysPass()
  : Internal(new Internals)
{
  this->SetModel(nullptr);
  this->SetIntegrator(nullptr);
}

//------------------------------------------------------------------------------
vtkGodRaysPass::~vtkGodRaysPass() = default;

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetRole(vtkProp* prop, int role)
{
  if (!prop || role < AUTOMATIC || role > IGNORED)
  {
    vtkGenericWarningMacro("SetRole needs a prop and one of AUTOMATIC (0), OCCLUDER (1), LIGHT (2) "
                           "and IGNORED (3), not "
      << (prop ? "role " + std::to_string(role) : "a null prop") << "; nothing is changed.");
    return;
  }
  if (GetRole(prop) == role)
  {
    return;
  }
  // A copy, since props may share their keys, as those made by vtkActor::ShallowCopy() do.
  vtkNew<vtkInformation> keys;
  if (vtkInformation* former = prop->GetPropertyKeys())
  {
    keys->Copy(former);
  }
  if (role == AUTOMATIC)
  {
    keys->Remove(ROLE());
  }
  else
  {
    keys->Set(ROLE(), role);
  }
  prop->SetPropertyKeys(keys);
}

//------------------------------------------------------------------------------
int vtkGodRaysPass::GetRole(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys && keys->Has(ROLE()) ? keys->Get(ROLE()) : AUTOMATIC;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::AddLight(vtkLight* light)
{
  auto& lights = this->Internal->Lights;
  if (light && std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    lights.emplace_back(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void vtkGodRaysPass::RemoveAllLights()
{
  if (!this->Internal->Lights.empty())
  {
    this->Internal->Lights.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkGodRaysPass::GetNumberOfLights()
{
  return static_cast<int>(this->Internal->Lights.size());
}

//------------------------------------------------------------------------------
vtkLight* vtkGodRaysPass::GetLight(int index)
{
  const auto& lights = this->Internal->Lights;
  return index >= 0 && index < static_cast<int>(lights.size()) ? lights[index].Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetModel(vtkGodRaysModel* model)
{
  if (model && model == this->Internal->Model)
  {
    return;
  }
  Internals& self = *this->Internal;
  self.Model = model;
  if (!model)
  {
    self.Model = vtkSmartPointer<vtkGodRaysRadialModel>::New();
  }
  self.MediumModel = vtkGodRaysMediumModel::SafeDownCast(self.Model);
  if (self.IntegratorIsModels && !self.Integrator->Supports(self.Model))
  {
    this->SetIntegrator(nullptr);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkGodRaysModel* vtkGodRaysPass::GetModel()
{
  return this->Internal->Model;
}

//------------------------------------------------------------------------------
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
  }
  self.IntegratorIsModels = !integrator;
  self.Integrator = integrator;
  if (!integrator)
  {
    self.Integrator = vtk::TakeSmartPointer(self.Model->MakeIntegrator());
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkGodRaysIntegrator* vtkGodRaysPass::GetIntegrator()
{
  return this->Internal->Integrator;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetCompositor(vtkGodRaysCompositor* compositor)
{
  if (this->Internal->Compositor != compositor)
  {
    this->Internal->Compositor = compositor;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGodRaysCompositor* vtkGodRaysPass::GetCompositor()
{
  return this->Internal->Compositor;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::ApplyPreset(const char* name)
{
  return this->Internal->Model->ApplyPreset(name);
}

//------------------------------------------------------------------------------
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, Intensity, 0.0, 1e4);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, ErrorTolerance, 1e-6, 0.1);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, InteractiveErrorTolerance, 1e-6, 0.1);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, ResolutionScale, 0.125, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, SourceRadius, 0.0, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, SunAngularRadius, 0.01, 90.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlow, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowRadius, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowFalloff, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, LayerMargin, 0.0, 1.0);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Blend, SCREEN);
vtkGodRaysSetModeMacro(vtkGodRaysPass, DisplayTransfer, POWER_TRANSFER);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Output, SCATTERING);
vtkGodRaysSetModeMacro(vtkGodRaysPass, Precision, SINGLE);

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
vtkGodRaysPass* vtkGodRaysPass::Find(vtkRenderer* renderer)
{
  return renderer ? vtkGodRaysAttachment::Find<vtkGodRaysPass>(renderer) : nullptr;
}

//------------------------------------------------------------------------------
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
  self.Attachment.Detach(this, renderer);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::GetOcclusionImage(vtkImageData* image)
{
  Internals& self = *this->Internal;
  const bool distributed = self.Compositor && self.Compositor->IsDistributed();
  if (self.HasLayer && !self.HasAllLayers && self.Window && !distributed)
  {
    // one layer texture served all lights in turn
    self.KeepAllLayers = true;
    self.Window->Render();
    self.KeepAllLayers = false;
  }
  if (!image || !self.HasAllLayers || !self.Window)
  {
    if (image)
    {
      image->Initialize();
    }
    return false;
  }
  self.Window->MakeCurrent();
  return self.Layers.Download(image);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::GetScatteringImage(vtkImageData* image)
{
  Internals& self = *this->Internal;
  if (!image || !self.HasScattering || !self.Window)
  {
    if (image)
    {
      image->Initialize();
    }
    return false;
  }
  self.Window->MakeCurrent();
  return self.Scattering.Download(image);
}

//------------------------------------------------------------------------------
std::string vtkGodRaysPass::GetPlan() const
{
  return this->Internal->LightPlan + this->Internal->StagePlan;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::GetStageTimes(double seconds[4])
{
  Internals& self = *this->Internal;
  if (self.Window)
  {
    self.Window->MakeCurrent();
  }
  self.Timers.GetTimes(seconds);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::Render(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (self.DrawsScene)
  {
    self.IsOwnDelegate = true;
    self.RendererSteps->Render(s);
    return;
  }
  self.LightPlan.clear();
  self.HasScattering = false;
  self.HasLayer = false;
  self.HasAllLayers = false;
  self.Timers.BeginFrame(this->MeasureTimes);
  this->NumberOfGeometryPasses = 1;

  vtkGodRaysView view;
  std::vector<vtkGodRaysSource> sources;
  const char* reason = this->FindReasonForNoRays(s, window);
  const bool hasLayers = !reason;
  if (hasLayers)
  {
    int viewport[4];
    vtkGodRaysScene::GetViewport(s, viewport);
    vtkGodRaysScene::UpdateStereo(renderer);
    self.Margin = this->FindMargin(window, viewport + 2);
    view.Set(renderer, viewport + 2, self.Margin);
    self.Transfer = self.Model->GetLinearLight()
      ? vtkGodRaysFindTransfer(this->DisplayTransfer, renderer, this)
      : vtkGodRaysTransfer::NONE;
    sources = this->FindSources(renderer, view);
    reason = sources.empty() && !this->DimsScene() ? "no light reaches the picture" : nullptr;
    vtkGodRaysView::Pinhole pinhole;
    if (self.MediumModel && !view.GetPinhole(viewport + 2, pinhole))
    {
      this->Complain("the picture is tilted against the axis of view, or its pixels are oblong, in "
                     "which light in a medium cannot be evaluated. Use a projection matrix without "
                     "that, or a vtkGodRaysRadialModel");
      reason = "the projection is not one that a medium takes";
    }
  }
  self.NumberOfSources = static_cast<int>(sources.size());
  if (reason)
  {
    self.StagePlan = std::string("rays: none, ") + reason + "\nscene: drawn straight through\n";
    this->RenderScene(s);
    if (hasLayers && this->Output != COMPOSITE)
    {
      this->ShowNoLight(s, window->GetState()); // the layers are dark, not absent
    }
    return;
  }

  if (self.Window != window || self.ContextTime != window->GetContextCreationTime())
  {
    // also if the former window, or its context, is gone
    self.Release(self.Window ? self.Window.Get() : window);
  }
  self.Window = window;
  self.ContextTime = window->GetContextCreationTime();

  vtkGodRaysOverlays overlays(s);
  self.Timers.Start(vtkGodRaysTimers::SCENE);
  this->RenderScene(s);
  self.Timers.Stop();
  if (self.IsOwnDelegate)
  {
    self.StagePlan = "rays: none, the delegate leads back to this pass\n";
  }
  else if (!this->RenderRays(s, view, sources))
  {
    this->Complain("the framebuffer of this window cannot be copied or drawn into by the rays' "
                   "stages. Render into a window or framebuffer with a depth buffer and 8-bit or "
                   "floating-point RGBA colours");
    self.StagePlan = "rays: none, after an error\n";
  }
  overlays.Draw();
  vtkOpenGLCheckErrorMacro("failed after Render");
}

//------------------------------------------------------------------------------
const char* vtkGodRaysPass::FindReasonForNoRays(
  const vtkRenderState* s, vtkOpenGLRenderWindow* window)
{
  const Internals& self = *this->Internal;
  int viewport[4];
  if (!window)
  {
    this->Complain("the render window is not an OpenGL window. Use VTK's OpenGL back end");
    return "the window is not an OpenGL one";
  }
  if (s->GetRenderer()->GetSelector())
  {
    return "a hardware selection is made";
  }
  if (IsDisabledByEnvironment())
  {
    return "the environment variable GODRAYS_DISABLE is set";
  }
  vtkGodRaysScene::GetViewport(s, viewport);
  if (viewport[2] < 1 || viewport[3] < 1)
  {
    return "the viewport is empty";
  }
  if (this->Intensity == 0.0)
  {
    return "Intensity is 0";
  }
  if (!self.Model->CanScatter())
  {
    return "the model's parameters scatter nothing";
  }
  if (!self.Integrator->Supports(self.Model))
  {
    this->Complain(std::string("a ") + self.Integrator->GetClassName() + " cannot evaluate a " +
      self.Model->GetClassName() + ". Set an integrator that supports it");
    return "the integrator does not support the model";
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// A large screenshot is drawn in tiles: what is on the others must cast into each as on one picture.
double vtkGodRaysPass::FindMargin(vtkOpenGLRenderWindow* window, const int size[2]) const
{
  const double wanted = GetTiles(window) - 1.0;
  if (wanted <= this->LayerMargin ||
    this->Output == OCCLUSION) // which shows the layer with its margin
  {
    return this->LayerMargin;
  }
  const double largest = vtkTextureObject::GetMaximumTextureSize(window);
  const double possible = 0.5 * (largest / std::max(size[0], size[1]) - 1.0);
  return std::max(this->LayerMargin, std::min(wanted, possible));
}

//------------------------------------------------------------------------------
// Whether the picture changes where no light is scattered.
bool vtkGodRaysPass::DimsScene() const
{
  const Internals& self = *this->Internal;
  return self.MediumModel && self.MediumModel->GetAttenuateScene() && this->Output == COMPOSITE;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::RenderScene(const vtkRenderState* s)
{
  vtkRenderPass* scene = this->DelegatePass;
  if (!scene)
  {
    scene = this->Internal->RendererSteps;
  }
  Internals& self = *this->Internal;
  self.IsOwnDelegate = false;
  self.DrawsScene = true;
  scene->Render(s);
  self.DrawsScene = false;
  if (self.IsOwnDelegate)
  {
    this->Complain("the delegate of this pass leads back to it. Set another delegate, or none; a "
                   "pass that has this one for its delegate is what the renderer takes, by "
                   "SetPass(), without Attach()");
  }
  this->NumberOfRenderedProps = scene->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
std::vector<vtkGodRaysSource> vtkGodRaysPass::FindSources(
  vtkRenderer* renderer, const vtkGodRaysView& view)
{
  Internals& self = *this->Internal;
  vtkGodRaysSourceFinder finder;
  finder.Renderer = renderer;
  finder.SourceRadius = this->SourceRadius;
  finder.SunAngularRadius = this->SunAngularRadius;
  finder.BackgroundGlow = this->BackgroundGlow;
  finder.BackgroundGlowRadius = this->BackgroundGlowRadius;
  finder.BackgroundGlowFalloff = this->BackgroundGlowFalloff;
  finder.Transfer = self.Transfer;
  finder.CapsMarch = self.Model->CapsMarch();
  finder.Tiles = GetTiles(renderer->GetRenderWindow());
  finder.LightsMedium = self.MediumModel != nullptr;
  finder.Compositor = self.Compositor;
  auto sources = finder.Find(view, self.Lights);
  self.LightPlan = finder.GetPlan();
  return sources;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::RenderRays(
  const vtkRenderState* s, const vtkGodRaysView& view, const std::vector<vtkGodRaysSource>& sources)
{
  Internals& self = *this->Internal;
  vtkOpenGLState* state = self.Window->GetState();
  vtkGodRaysStateKeeper keeper(state);

  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  const vtkGodRaysFramebuffer bound;
  if (!bound.Formats.Color || !bound.Formats.Depth)
  {
    return false;
  }
  const unsigned int precision = this->Precision == SINGLE ? GL_RGBA32F : GL_RGBA16F;
  self.Timers.Start(vtkGodRaysTimers::OCCLUSION);
  if (!this->FindOccluders(s, view, bound, viewport, precision))
  {
    return false;
  }
  self.Timers.Stop();
  this->NumberOfGeometryPasses = self.Occlusion->GetRenderedOccluders() ? 2 : 1;

  self.Scattering.Begin(self.Window, viewport[2], viewport[3], precision);
  const bool isRoot = !self.Compositor || self.Compositor->IsRoot();
  for (const vtkGodRaysSource& source : sources)
  {
    if (!self.MediumModel && !this->ComposeLayer(source, sources, precision))
    {
      return false;
    }
    if (this->Output != OCCLUSION)
    {
      self.Timers.Start(vtkGodRaysTimers::SCATTERING);
      if (!this->Scatter(s->GetRenderer(), view, source))
      {
        return false;
      }
      self.Timers.Stop();
    }
  }
  if (!isRoot)
  {
    self.StagePlan = "rays: joined by another process\n";
    return true;
  }
  self.HasScattering = !self.Scattering.IsEmpty();

  self.Timers.Start(vtkGodRaysTimers::BLEND);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.Binding);
  bool blended = true;
  if (self.MediumModel && this->Output == OCCLUSION)
  {
    this->ShowNoLight(s, state); // a medium has no layer
  }
  else
  {
    blended = this->DrawOutput(viewport, view);
  }
  self.Timers.Stop();
  this->DescribeStages(self.Margin);
  return blended;
}

//------------------------------------------------------------------------------
// Keep what the framebuffer holds, and find what blocks light.
bool vtkGodRaysPass::FindOccluders(const vtkRenderState* s, const vtkGodRaysView& view,
  const vtkGodRaysFramebuffer& bound, const int viewport[4], unsigned int precision)
{
  Internals& self = *this->Internal;
  vtkGodRaysOcclusionPass::Request occlusion;
  occlusion.Window = self.Window;
  occlusion.Renderer = s->GetRenderer();
  occlusion.View = &view;
  occlusion.DepthFormat = bound.Formats.Depth;
  occlusion.Multisampled = bound.Multisampled;
  occlusion.ColorFormat = precision;
  occlusion.OneColorFormat = self.Integrator->GetOneColorFormat(self.Window, self.Model, precision);
  occlusion.Margin = self.Margin;
  occlusion.UntaggedPropsOcclude = this->UntaggedPropsOcclude;
  occlusion.LampsOcclude = !self.MediumModel;
  occlusion.Dims = !self.MediumModel;
  occlusion.Transfer = self.Transfer;
  occlusion.Glow = this->BackgroundGlow;
  occlusion.Compositor = self.Compositor;

  const bool depthServes = vtkGodRaysOcclusionPass::SceneDepthServes(occlusion);
  const unsigned int buffers = (this->Output == COMPOSITE ? GL_COLOR_BUFFER_BIT : 0) |
    (depthServes || self.MediumModel ? GL_DEPTH_BUFFER_BIT : 0);
  if (!self.Scene.Copy(self.Window, bound, viewport, buffers))
  {
    return false;
  }
  occlusion.SceneDepth = self.Scene.GetDepth();
  self.HasBackdrop = false;
  if (self.Compositor && self.Compositor->IsRoot())
  {
    self.Backdrop.Prepare(self.Window, viewport[2], viewport[3], { GL_RGBA8, bound.Formats.Depth });
    if (!self.Backdrop.Bind())
    {
      return false;
    }
    self.HasBackdrop = self.Compositor->DrawBackground(s->GetRenderer());
  }
  if (!self.Occlusion->Begin(occlusion))
  {
    return false;
  }
  if (self.MediumModel)
  {
    // On several processes the depth of the joined picture may be nowhere.
    const bool hasSeen =
      !self.Compositor || !self.Compositor->IsDistributed() || self.Compositor->HasDepth();
    self.SeenDepth = hasSeen ? self.Scene.GetDepth() : self.Occlusion->GetDepth();
    self.Depths.Begin(self.Window, view, self.Occlusion->GetDepth(),
      self.SeenDepth == self.Occlusion->GetDepth() ? nullptr : self.SeenDepth);
    self.Medium = self.MediumModel->GetMedium(
      view.WorldToView, view.Eye, s->GetRenderer()->GetActiveCamera()->GetClippingRange()[1]);
  }
  return true;
}

//------------------------------------------------------------------------------
// The layer of one light, kept if it is asked for.
bool vtkGodRaysPass::ComposeLayer(const vtkGodRaysSource& source,
  const std::vector<vtkGodRaysSource>& sources, unsigned int precision)
{
  Internals& self = *this->Internal;
  self.Timers.Start(vtkGodRaysTimers::OCCLUSION);
  if (!self.Occlusion->Compose(source))
  {
    return false;
  }
  self.HasLayer = true;
  self.HasAllLayers = sources.size() == 1 || this->Output == OCCLUSION || self.KeepAllLayers;
  if (self.HasAllLayers)
  {
    vtkGodRaysTarget& layer = *self.Occlusion->GetLayer();
    if (&source == &sources.front())
    {
      self.Layers.Begin(self.Window, layer.GetWidth(), layer.GetHeight(), precision);
    }
    if (!(sources.size() == 1 ? self.Layers.Lend(layer, source.Color, 1.0)
                              : self.Layers.Add(layer, source.Color, 1.0)))
    {
      return false;
    }
  }
  self.Timers.Stop();
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::Scatter(
  vtkRenderer* renderer, const vtkGodRaysView& view, const vtkGodRaysSource& source)
{
  Internals& self = *this->Internal;
  vtkGodRaysIntegrator::Request request;
  request.Window = self.Window;
  request.Model = self.Model;
  if (self.MediumModel)
  {
    request.Medium = &self.Medium;
    request.View = &view;
    request.Source = &source;
    request.Depths = &self.Depths;
    request.Renderer = renderer;
    request.Blocking = &self.Occlusion->GetBlocking();
    request.Compositor = self.Compositor;
  }
  else
  {
    request.Layer = self.Occlusion->GetLayer();
    std::copy_n(source.Color, 3, request.Color);
    std::copy_n(source.Clip, 3, request.LightClip);
    request.MarchScale = source.MarchScale;
  }
  request.ViewScale = view.ViewScale;
  request.Peak = source.Prop ? 1.0 : *std::max_element(source.Color, source.Color + 3);
  request.ResolutionScale = this->ResolutionScale;
  const bool interactive = self.Window->GetDesiredUpdateRate() >= 1.0;
  request.ErrorTolerance = interactive
    ? std::max(this->ErrorTolerance, this->InteractiveErrorTolerance)
    : this->ErrorTolerance;
  if (self.Compositor && !self.Compositor->IsRoot())
  {
    request.Depths = nullptr;
    return self.Integrator->Contribute(request);
  }
  request.Result = &self.Scattering;
  return self.Integrator->Integrate(request);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::DrawOutput(const int viewport[4], const vtkGodRaysView& view)
{
  Internals& self = *this->Internal;
  const vtkGodRaysSum& light = this->Output == OCCLUSION ? self.Layers : self.Scattering;
  vtkGodRaysBlendPass::Request request;
  request.Window = self.Window;
  std::copy_n(viewport, 4, request.Viewport);
  request.Scene = self.Scene.GetColor();
  request.Backdrop = self.HasBackdrop ? self.Backdrop.GetColor() : nullptr;
  request.Rays = light.GetTexture();
  request.Tint = light.GetTint();
  request.Intensity = this->Output == OCCLUSION ? 1.0 : this->Intensity;
  request.SceneGain = self.Model->GetSceneGain();
  request.Transfer = self.Transfer;
  const int blend = this->Blend == MODEL_BLEND ? self.Model->GetBlend() : this->Blend;
  request.Screen = blend == SCREEN;
  request.ShowRays = this->Output != COMPOSITE;
  if (this->DimsScene())
  {
    request.Medium = &self.Medium;
    request.View = &view;
    request.Depth = self.SeenDepth;
  }
  return self.Blending->Draw(request);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::ShowNoLight(const vtkRenderState* s, vtkOpenGLState* state)
{
  vtkGodRaysStateKeeper keeper(state);
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  state->vtkglScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::DescribeStages(double margin)
{
  Internals& self = *this->Internal;
  std::ostringstream plan;
  plan << "scene: drawn in place, geometry rendered "
       << (this->NumberOfGeometryPasses == 1 ? "once" : "twice") << "\n";
  plan << "occlusion: " << self.Occlusion->Describe();
  if (margin > 0.0)
  {
    plan << ", margin " << margin;
  }
  plan << "\nmodel: " << self.Model->Describe() << "\n";
  if (this->Output == OCCLUSION)
  {
    plan << "scattering: skipped, the occlusion layer is shown\n";
  }
  else
  {
    plan << "scattering: " << self.Integrator->Describe(self.Model, this->ResolutionScale) << "\n";
  }
  const int blend = this->Blend == MODEL_BLEND ? self.Model->GetBlend() : this->Blend;
  plan << "blend: "
       << (this->Output != COMPOSITE ? "skipped, one layer is shown"
              : blend == SCREEN      ? "screen"
                                     : "additive")
       << (self.Transfer == vtkGodRaysTransfer::NONE      ? ", shown values"
              : self.Transfer == vtkGodRaysTransfer::SRGB ? ", linear light"
                                                          : ", linear light by a power of 2.2")
       << "\n";
  self.StagePlan = plan.str();
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::Complain(const std::string& complaint)
{
  if (this->Internal->Complaint != complaint)
  {
    this->Internal->Complaint = complaint;
    vtkWarningMacro("The scene is drawn without god rays: " << complaint << ".");
  }
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
vtkMTimeType vtkGodRaysPass::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = std::max(time, this->Internal->Model->GetMTime());
  time = std::max(time, this->Internal->Integrator->GetMTime());
  for (const auto& light : this->Internal->Lights)
  {
    time = std::max(time, light->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const vtkIndent next = indent.GetNextIndent();
  os << indent << "Intensity: " << this->Intensity << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "InteractiveErrorTolerance: " << this->InteractiveErrorTolerance << "\n";
  os << indent << "ResolutionScale: " << this->ResolutionScale << "\n";
  os << indent << "UntaggedPropsOcclude: " << (this->UntaggedPropsOcclude ? "on" : "off") << "\n";
  os << indent << "SourceRadius: " << this->SourceRadius << "\n";
  os << indent << "SunAngularRadius: " << this->SunAngularRadius << "\n";
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
