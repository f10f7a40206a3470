// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPass.h"

#include "vtkCamera.h"
#include "vtkGodRaysAttachment.h"
#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysEffect.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysOcclusionPass.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysPresets.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysScene.h"
#include "vtkGodRaysSceneCopy.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysTransfer.h"
#include "vtkGodRaysView.h"
#include "vtkImageData.h"
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
  vtkSmartPointer<vtkGodRaysSun> Sun = vtkSmartPointer<vtkGodRaysSun>::New();
  vtkSmartPointer<vtkGodRaysModel> Model;
  std::unique_ptr<vtkGodRaysEffect> Effect; // the model's
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  bool IntegratorIsModels = false; // nobody set it
  vtkSmartPointer<vtkGodRaysCompositor> Compositor;

  vtkGodRaysAttachment Attachment;

  vtkNew<vtkGodRaysScene> RendererSteps;
  vtkNew<vtkGodRaysOcclusionPass> Occlusion;
  vtkNew<vtkGodRaysBlendPass> Blending;
  vtkGodRaysSceneCopy Scene; // colour and depth of the viewport
  vtkGodRaysTarget Backdrop; // background, where the scene is drawn over black
  vtkGodRaysSum Scattering;  // light of all layers
  vtkGodRaysTimers Timers;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the resources
  vtkMTimeType ContextTime = 0;                 // when its context was made
  bool HasRays = false;                         // of the last frame
  bool HasScattering = false;                   // alike
  bool HasBackdrop = false;
  bool KeepAllLayers = false;
  int NumberOfLights = 0; // of the last frame
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
    if (this->Effect)
    {
      this->Effect->Release(window);
    }
    this->Timers.Release(this->Window);
    this->HasRays = false;
    this->HasScattering = false;
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
  vtkGodRaysSetRole(prop, static_cast<vtkGodRaysRole>(role));
}

//------------------------------------------------------------------------------
int vtkGodRaysPass::GetRole(vtkProp* prop)
{
  return static_cast<int>(vtkGodRaysGetRole(prop));
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkGodRaysPass::ROLE()
{
  return vtkGodRaysGetRoleKey();
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

//------------------------------------------------------------------------------
vtkGodRaysSun* vtkGodRaysPass::GetSun()
{
  return this->Internal->Sun;
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetSunAngularRadius(double degrees)
{
  this->Internal->Sun->SetAngularRadius(degrees);
}

//------------------------------------------------------------------------------
double vtkGodRaysPass::GetSunAngularRadius()
{
  return this->Internal->Sun->GetAngularRadius();
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetModel(vtkGodRaysModel* model)
{
  if (model && model == this->Internal->Model)
  {
    return;
  }
  Internals& self = *this->Internal;
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
  const auto model = vtk::TakeSmartPointer(vtkGodRaysPresets::NewModel(name));
  if (!model)
  {
    vtkErrorMacro("There is no preset \""
      << (name ? name : "") << "\". The presets are: " << vtkGodRaysPresets::ListNames() << ".");
    return false;
  }
  if (this->GetModel()->IsA(model->GetClassName()))
  {
    return this->GetModel()->ApplyPreset(name); // what no preset sets stays
  }
  this->SetModel(model);
  return true;
}

//------------------------------------------------------------------------------
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, Intensity, 0.0, 1e4);
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
  if (self.Window && self.HasRays && self.Effect->HasLayers() && !self.Effect->GetLayers() &&
    !distributed)
  {
    // one layer texture served all lights in turn
    self.KeepAllLayers = true;
    self.Window->Render();
    self.KeepAllLayers = false;
  }
  vtkGodRaysSum* layers = self.Window && self.HasRays ? self.Effect->GetLayers() : nullptr;
  if (!image || !layers)
  {
    if (image)
    {
      image->Initialize();
    }
    return false;
  }
  self.Window->MakeCurrent();
  return layers->Download(image);
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
  self.HasRays = false;
  self.Timers.BeginFrame(this->MeasureTimes);
  this->NumberOfGeometryPasses = 1;

  vtkGodRaysView view;
  std::vector<vtkGodRaysLight> lights;
  const char* reason = this->FindReasonForNoRays(s, window);
  const bool hasLayers = !reason;
  if (hasLayers)
  {
    int viewport[4];
    vtkGodRaysScene::GetViewport(s, viewport);
    vtkGodRaysScene::UpdateStereo(renderer);
    self.Margin = this->FindMargin(window, viewport + 2);
    view.Set(renderer, viewport + 2, self.Margin);
    self.Transfer = self.Effect->SumsShownValues()
      ? vtkGodRaysTransfer::NONE
      : vtkGodRaysFindTransfer(this->DisplayTransfer, renderer, this);
    lights = this->FindLights(renderer, view);
    reason = lights.empty() && !this->DimsScene() ? "no light reaches the picture" : nullptr;
    const std::string obstacle = self.Effect->FindObstacle(view, viewport + 2);
    if (!obstacle.empty())
    {
      this->Complain(obstacle);
      reason = "the model cannot be evaluated in this projection";
    }
  }
  self.NumberOfLights = static_cast<int>(lights.size());
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
  else if (!this->RenderRays(s, view, lights))
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
  return this->Internal->Effect->DimsScene() && this->Output == COMPOSITE;
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
std::vector<vtkGodRaysLight> vtkGodRaysPass::FindLights(
  vtkRenderer* renderer, const vtkGodRaysView& view)
{
  Internals& self = *this->Internal;
  vtkGodRaysLightFinder finder;
  finder.Renderer = renderer;
  finder.SourceRadius = this->SourceRadius;
  finder.SunAngularRadius = this->GetSunAngularRadius();
  finder.BackgroundGlow = this->BackgroundGlow;
  finder.BackgroundGlowRadius = this->BackgroundGlowRadius;
  finder.BackgroundGlowFalloff = this->BackgroundGlowFalloff;
  finder.Transfer = self.Transfer;
  finder.Tiles = GetTiles(renderer->GetRenderWindow());
  finder.Compositor = self.Compositor;
  self.Effect->SetUp(finder);
  auto lights = finder.Find(view, self.Lights);
  self.LightPlan = finder.GetPlan();
  return lights;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::RenderRays(
  const vtkRenderState* s, const vtkGodRaysView& view, const std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  const vtkGodRaysStateKeeper keeper(self.Window->GetState());
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  const vtkGodRaysFramebuffer bound;
  const bool done = bound.Formats.Color && bound.Formats.Depth &&
    this->FindOccluders(s, view, bound, viewport) && this->DrawLights(s, view, lights) &&
    this->DrawOutput(s, bound, viewport);
  self.HasRays = self.HasRays && done; // else layers may lack lights
  self.Effect->End();
  self.Occlusion->End();
  return done;
}

//------------------------------------------------------------------------------
// Keep what the framebuffer holds, and find the occluders.
bool vtkGodRaysPass::FindOccluders(const vtkRenderState* s, const vtkGodRaysView& view,
  const vtkGodRaysFramebuffer& bound, const int viewport[4])
{
  Internals& self = *this->Internal;
  self.Timers.Start(vtkGodRaysTimers::OCCLUSION);
  vtkGodRaysOcclusionPass::Request occlusion;
  occlusion.Window = self.Window;
  occlusion.Renderer = s->GetRenderer();
  occlusion.View = &view;
  occlusion.DepthFormat = bound.Formats.Depth;
  occlusion.Multisampled = bound.Multisampled;
  occlusion.ColorFormat = this->GetLayerFormat();
  occlusion.Margin = self.Margin;
  occlusion.UntaggedPropsOcclude = this->UntaggedPropsOcclude;
  occlusion.Transfer = self.Transfer;
  occlusion.Glow = this->BackgroundGlow;
  occlusion.Compositor = self.Compositor;
  self.Effect->SetUp(occlusion, self.Integrator);

  const bool depthServes = vtkGodRaysOcclusionPass::SceneDepthServes(occlusion);
  const unsigned int buffers = (this->Output == COMPOSITE ? GL_COLOR_BUFFER_BIT : 0) |
    (depthServes || self.Effect->ReadsSceneDepth() ? GL_DEPTH_BUFFER_BIT : 0);
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
  const bool done = self.Occlusion->Begin(occlusion);
  self.Timers.Stop();
  this->NumberOfGeometryPasses = self.Occlusion->GetRenderedOccluders() ? 2 : 1;
  return done;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::DrawLights(
  const vtkRenderState* s, const vtkGodRaysView& view, const std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  vtkGodRaysEffect::Frame frame;
  frame.Window = self.Window;
  frame.Renderer = s->GetRenderer();
  frame.View = &view;
  frame.Integrator = self.Integrator;
  frame.Occlusion = self.Occlusion;
  frame.SceneDepth = self.Scene.GetDepth();
  frame.Compositor = self.Compositor;
  frame.Timers = &self.Timers;
  frame.Light = &self.Scattering;
  frame.Format = this->GetLayerFormat();
  frame.NumberOfLights = static_cast<int>(lights.size());
  const bool interactive = self.Window->GetDesiredUpdateRate() >= 1.0;
  frame.ErrorTolerance = interactive
    ? std::max(this->ErrorTolerance, this->InteractiveErrorTolerance)
    : this->ErrorTolerance;
  frame.KeepsLayers = this->Output == OCCLUSION || self.KeepAllLayers;
  frame.Scatters = this->Output != OCCLUSION;
  const int width = static_cast<int>(frame.SceneDepth->GetWidth());
  const int height = static_cast<int>(frame.SceneDepth->GetHeight());
  self.Scattering.Begin(self.Window, width, height, frame.Format);
  self.Effect->Begin(frame);
  self.HasRays = true;
  return std::all_of(lights.begin(), lights.end(),
    [&](const vtkGodRaysLight& light) { return self.Effect->DrawLight(frame, light); });
}

//------------------------------------------------------------------------------
unsigned int vtkGodRaysPass::GetLayerFormat() const
{
  return this->Precision == SINGLE ? GL_RGBA32F : GL_RGBA16F;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::DrawOutput(
  const vtkRenderState* s, const vtkGodRaysFramebuffer& bound, const int viewport[4])
{
  Internals& self = *this->Internal;
  if (self.Compositor && !self.Compositor->IsRoot())
  {
    self.StagePlan = "rays: joined by another process\n";
    return true;
  }
  self.HasScattering = !self.Scattering.IsEmpty();
  self.Timers.Start(vtkGodRaysTimers::BLEND);
  vtkOpenGLState* state = self.Window->GetState();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.Binding);
  vtkGodRaysSum* light = this->Output == OCCLUSION ? self.Effect->GetLayers() : &self.Scattering;
  vtkGodRaysBlendPass::Request request;
  if (this->Output == COMPOSITE)
  {
    self.Effect->Join(request);
  }
  request.Screen = this->Blend == MODEL_BLEND ? request.Screen : this->Blend == SCREEN;
  bool drawn = true;
  if (light)
  {
    request.Window = self.Window;
    std::copy_n(viewport, 4, request.Viewport);
    request.Scene = self.Scene.GetColor();
    request.Backdrop = self.HasBackdrop ? self.Backdrop.GetColor() : nullptr;
    request.Rays = light->GetTexture();
    request.Tint = light->GetTint();
    request.Intensity = this->Output == OCCLUSION ? 1.0 : this->Intensity;
    request.Transfer = self.Transfer;
    request.ShowRays = this->Output != COMPOSITE;
    drawn = self.Blending->Draw(request);
  }
  else
  {
    this->ShowNoLight(s, state);
  }
  self.Timers.Stop();
  this->DescribeStages(request.Screen);
  return drawn;
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
void vtkGodRaysPass::DescribeStages(bool screen)
{
  Internals& self = *this->Internal;
  std::ostringstream plan;
  plan << "scene: drawn in place, geometry rendered "
       << (this->NumberOfGeometryPasses == 1 ? "once" : "twice") << "\n";
  plan << "occlusion: " << self.Occlusion->Describe();
  if (self.Margin > 0.0)
  {
    plan << ", margin " << self.Margin;
  }
  plan << "\nmodel: " << self.Model->Describe() << "\nscattering: "
       << (this->Output == OCCLUSION ? "skipped, the occlusion layer is shown"
                                     : self.Integrator->Describe(self.Model))
       << "\nblend: "
       << (this->Output != COMPOSITE ? "skipped, one layer is shown"
              : screen               ? "screen"
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
  time = std::max(time, this->Internal->Sun->GetMTime());
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
