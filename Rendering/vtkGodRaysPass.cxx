// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPass.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOcclusionPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSource.h"
#include "vtkGodRaysTapsIntegrator.h"
#include "vtkGodRaysTarget.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkGodRaysPass);
vtkInformationKeyMacro(vtkGodRaysPass, ROLE, Integer);

namespace
{
/// Stages that are timed, in the order of GetStageTimes().
enum Stage
{
  SCENE,
  OCCLUDE,
  SCATTER,
  BLEND,
  NUMBER_OF_STAGES
};

/// A light is marched to from at most this many picture diagonals away; see MarchScale().
const double MarchCapDiagonals = 1.5;

/// A prop that draws nothing.
class Nothing : public vtkProp
{
public:
  static Nothing* New();
  vtkTypeMacro(Nothing, vtkProp);
};
vtkStandardNewMacro(Nothing);

/// The renderer's own steps, as vtkOpenGLRenderer takes them when it has no pass.
class RendererSteps : public vtkRenderPass
{
public:
  static RendererSteps* New();
  vtkTypeMacro(RendererSteps, vtkRenderPass);
  void Render(const vtkRenderState* s) override
  {
    vtkRenderer* renderer = s->GetRenderer();
    if (!s->GetFrameBuffer())
    {
      this->UpdateCamera(renderer);
    } // else a vtkCameraPass has set the viewport
    this->UpdateLightGeometry(renderer);
    this->UpdateLights(renderer);
    this->UpdateGeometry(renderer, s->GetFrameBuffer());
    this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered();
  }
};
vtkStandardNewMacro(RendererSteps);

/// While it lives, 2-D props are taken out of a state's props; then they can be drawn.
class OverlaysHeldBack
{
public:
  OverlaysHeldBack(const vtkRenderState* s, vtkProp* nothing)
    : State(s)
  {
    for (int i = 0; i < s->GetPropArrayCount(); ++i)
    {
      vtkProp*& prop = s->GetPropArray()[i];
      if (vtkActor2D::SafeDownCast(prop))
      {
        this->Overlays.emplace_back(i, prop);
        prop = nothing;
      }
    }
  }
  ~OverlaysHeldBack()
  {
    for (const auto& overlay : this->Overlays)
    {
      this->State->GetPropArray()[overlay.first] = overlay.second;
    }
  }
  OverlaysHeldBack(const OverlaysHeldBack&) = delete;
  void operator=(const OverlaysHeldBack&) = delete;

  void Draw()
  {
    vtkRenderer* renderer = this->State->GetRenderer();
    for (const auto& overlay : this->Overlays)
    {
      vtkProp* prop = overlay.second;
      prop->RenderOpaqueGeometry(renderer); // where text and scalar bars are prepared
      if (prop->HasTranslucentPolygonalGeometry())
      {
        prop->RenderTranslucentPolygonalGeometry(renderer);
      }
      prop->RenderOverlay(renderer);
    }
  }

private:
  const vtkRenderState* State;
  std::vector<std::pair<int, vtkProp*>> Overlays;
};

/// Keeps the OpenGL state that the stages change, and sets what all of them need.
class StateKeeper
{
public:
  explicit StateKeeper(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state)
    , BlendFunc(state)
    , DepthMask(state)
    , DepthFunc(state)
    , ColorMask(state)
    , ClearColor(state)
    , ActiveTexture(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , CullFace(state, GL_CULL_FACE)
    , StencilTest(state, GL_STENCIL_TEST)
  {
    state->PushFramebufferBindings();
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
  }
  ~StateKeeper() { this->State->PopFramebufferBindings(); }
  StateKeeper(const StateKeeper&) = delete;
  void operator=(const StateKeeper&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
};

/// The framebuffer that the scene is drawn into: whoever bound it, and of whatever formats.
struct BoundFramebuffer
{
  unsigned int Binding;
  unsigned int ColorBuffer;
  vtkGodRaysTarget::Format Formats; // 0 where there is none that can be copied

  BoundFramebuffer()
  {
    int value = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &value);
    this->Binding = static_cast<unsigned int>(value);
    glGetIntegerv(GL_DRAW_BUFFER0, &value);
    this->ColorBuffer = static_cast<unsigned int>(value);
    const bool onScreen = this->Binding == 0;
    const unsigned int color =
      onScreen && value == GL_BACK ? static_cast<unsigned int>(GL_BACK_LEFT) : this->ColorBuffer;
    const unsigned int depth = onScreen ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
    const unsigned int stencil = onScreen ? GL_STENCIL : GL_STENCIL_ATTACHMENT;

    if (this->Has(color))
    {
      const int bits = this->Get(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
      this->Formats.Color = bits > 16 ? GL_RGBA32F : bits > 8 ? GL_RGBA16F : GL_RGBA8;
    }
    if (this->Has(depth))
    {
      const int bits = this->Get(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
      const bool floating = this->Get(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
      this->Formats.Depth = this->Has(stencil) ? GL_DEPTH24_STENCIL8
        : floating                             ? GL_DEPTH_COMPONENT32F
        : bits == 16                           ? GL_DEPTH_COMPONENT16
        : bits == 24                           ? GL_DEPTH_COMPONENT24
                                               : GL_DEPTH_COMPONENT32;
    }
  }

  /// Copy a rectangle of colour and depth into the framebuffer that is bound for drawing.
  void CopyTo(vtkOpenGLState* state, const int rectangle[4], unsigned int buffers) const
  {
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Binding);
    state->vtkglReadBuffer(this->ColorBuffer);
    state->vtkglBlitFramebuffer(rectangle[0], rectangle[1], rectangle[0] + rectangle[2],
      rectangle[1] + rectangle[3], 0, 0, rectangle[2], rectangle[3], buffers, GL_NEAREST);
  }

private:
  static int Get(unsigned int attachment, unsigned int what)
  {
    int value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
    return value;
  }
  static bool Has(unsigned int attachment)
  {
    return attachment != GL_NONE &&
      Get(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
  }
};

/// A camera learns from its own Render(), which draws nothing, whether the window is in stereo; the
/// first frame after a change needs its matrices before that.
void TellStereo(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (!camera->GetStereo() == !window->GetStereoRender())
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const vtkTypeBool erase = renderer->GetErase();
  const bool useScissor = camera->GetUseScissor();
  renderer->EraseOff();
  camera->Render(renderer);
  renderer->SetErase(erase);
  camera->SetUseScissor(useScissor);
}

bool IsDisabledByEnvironment()
{
  const char* value = std::getenv("GODRAYS_DISABLE");
  return value && *value && std::string(value) != "0";
}

void Clear(vtkGodRaysTarget& target, vtkOpenGLState* state)
{
  target.Bind();
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

/// Where a light stands in the world (w = 1), or in which direction it lies (w = 0).
bool GetWorldPlace(vtkLight* light, vtkCamera* camera, double place[4])
{
  double position[4] = { 0.0, 0.0, 0.0, 1.0 };
  double focalPoint[4] = { 0.0, 0.0, 0.0, 1.0 };
  if (light->LightTypeIsHeadlight())
  {
    camera->GetPosition(position);
    camera->GetFocalPoint(focalPoint);
  }
  else if (light->LightTypeIsCameraLight())
  {
    // as vtkRenderer does for its own lights; this one may be none of them
    vtkMatrix4x4* matrix = camera->GetCameraLightTransformMatrix();
    light->GetPosition(position);
    light->GetFocalPoint(focalPoint);
    matrix->MultiplyPoint(position, position);
    matrix->MultiplyPoint(focalPoint, focalPoint);
  }
  else
  {
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focalPoint);
  }
  std::copy_n(position, 3, place);
  place[3] = 1.0;
  if (!light->GetPositional())
  {
    vtkMath::Subtract(position, focalPoint, place);
    place[3] = 0.0;
    return vtkMath::Normalize(place) > 0.0;
  }
  return true;
}
}

//------------------------------------------------------------------------------
struct vtkGodRaysPass::Internals
{
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  vtkSmartPointer<vtkGodRaysModel> Model;
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;

  vtkWeakPointer<vtkRenderer> Attached;
  vtkSmartPointer<vtkRenderPass> FormerPass;
  vtkSmartPointer<vtkRenderPass> FormerDelegate;

  vtkNew<Nothing> NoProp;
  vtkNew<RendererSteps> Steps;
  vtkNew<vtkCameraPass> StepsInFramebuffer;
  vtkNew<vtkGodRaysOcclusionPass> Occlusion;
  vtkNew<vtkGodRaysBlendPass> Blending;
  vtkGodRaysTarget Scene;      // colour and depth of the viewport
  vtkGodRaysTarget Scattering; // light of all layers
  vtkGodRaysTarget LayerSum;   // of several lights, when it is asked for

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the resources
  vtkMTimeType ContextTime = 0;                 // when its context was made
  vtkWeakPointer<vtkRenderer> LastRenderer;
  bool HasScattering = false; // of the last frame
  bool HasLayer = false;
  bool HasLayerSum = false;
  bool KeepLayerSum = false;
  int NumberOfSources = 0; // of the last frame
  std::string LightPlan;
  std::string StagePlan;
  std::string Complaint; // that has been made already

  std::vector<std::pair<Stage, std::unique_ptr<vtkOpenGLRenderTimer>>> Timers;
  std::size_t TimersUsed = 0;
  bool Timing = false; // whether the timer TimersUsed runs

  void StartTimer(Stage stage, bool measure)
  {
    this->Timing = measure && vtkOpenGLRenderTimer::IsSupported();
    if (!this->Timing)
    {
      return;
    }
    if (this->TimersUsed == this->Timers.size())
    {
      this->Timers.emplace_back(stage, std::make_unique<vtkOpenGLRenderTimer>());
    }
    auto& timer = this->Timers[this->TimersUsed];
    timer.first = stage;
    timer.second->Reset();
    timer.second->Start();
  }

  void StopTimer()
  {
    if (this->Timing)
    {
      this->Timers[this->TimersUsed++].second->Stop();
      this->Timing = false;
    }
  }

  void Release(vtkWindow* window)
  {
    this->Occlusion->ReleaseGraphicsResources(window);
    if (this->Integrator)
    {
      this->Integrator->ReleaseGraphicsResources(window);
    }
    this->Blending->ReleaseGraphicsResources(window);
    this->Scene.Release(window);
    this->Scattering.Release(window);
    this->LayerSum.Release(window);
    if (this->Window && !this->Timers.empty())
    {
      this->Window->PushContext(); // timers know none, all else does
      this->Timers.clear();
      this->Window->PopContext();
    }
    this->Timers.clear();
    this->TimersUsed = 0;
    this->Timing = false;
    this->HasScattering = false;
    this->HasLayer = false;
    this->HasLayerSum = false;
    this->Window = nullptr;
  }

  /// Where a light's shafts start, and how far they are marched.
  void SetMarch(vtkGodRaysSource& source, const vtkGodRaysView& view) const
  {
    // Parallel rays have no point to lead to: they lead as far as to the point of a perspective
    // view, so that the shafts of a sun that crosses the direction of view shrink and grow again.
    const double distance =
      source.Planar || !view.Parallel ? source.Clip[2] : source.GetPerspectiveDistance(view);
    const glm::dvec3 clip(source.Clip[0], source.Clip[1], distance);
    const double diagonal = 2.0 * std::hypot(view.Aspect, 1.0);
    const bool capped = this->Model->CapsMarch() || view.Parallel;
    const double cap =
      capped ? MarchCapDiagonals * diagonal * view.ViewScale : std::numeric_limits<float>::max();
    source.MarchScale = vtkGodRays::MarchScale(clip, view.Aspect, cap);
    if (!capped && source.Clip[2] <= 0.0)
    {
      source.Fade = 0.0; // a published march ends where the light stops being before the camera
    }
  }
};

//------------------------------------------------------------------------------
vtkGodRaysPass::vtkGodRaysPass()
  : Internal(new Internals)
{
  this->Internal->StepsInFramebuffer->SetDelegatePass(this->Internal->Steps);
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
  this->Internal->Model = model;
  if (!model)
  {
    this->Internal->Model = vtkSmartPointer<vtkGodRaysRadialModel>::New();
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
  if (integrator && integrator == this->Internal->Integrator)
  {
    return;
  }
  if (this->Internal->Integrator && this->Internal->Window)
  {
    this->Internal->Integrator->ReleaseGraphicsResources(this->Internal->Window);
  }
  this->Internal->Integrator = integrator;
  if (!integrator)
  {
    this->Internal->Integrator = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkGodRaysIntegrator* vtkGodRaysPass::GetIntegrator()
{
  return this->Internal->Integrator;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::ApplyPreset(const char* name)
{
  auto model = vtkGodRaysRadialModel::SafeDownCast(this->Internal->Model);
  if (!model)
  {
    vtkErrorMacro("Presets are those of vtkGodRaysRadialModel, but the model is a "
      << this->Internal->Model->GetClassName() << ". Call SetModel(nullptr) first.");
    return false;
  }
  return model->ApplyPreset(name);
}

//------------------------------------------------------------------------------
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, Intensity, 0.0, 1e4);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, ErrorTolerance, 1e-6, 0.1);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, ResolutionScale, 0.125, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, SourceRadius, 0.0, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, SunAngularRadius, 0.01, 90.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlow, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowRadius, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, BackgroundGlowFalloff, 0.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysPass, LayerMargin, 0.0, 1.0);

//------------------------------------------------------------------------------
void vtkGodRaysPass::Attach(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("Attach needs a vtkRenderer, not null.");
    return;
  }
  Internals& self = *this->Internal;
  if (self.Attached == renderer && renderer->GetPass() == this)
  {
    return;
  }
  if (self.Attached)
  {
    this->Detach(self.Attached);
  }
  else if (self.FormerPass) // of a renderer that is gone
  {
    this->SetDelegatePass(self.FormerDelegate);
  }
  self.Attached = renderer;
  self.FormerDelegate = this->DelegatePass;
  self.FormerPass = renderer->GetPass() == this ? nullptr : renderer->GetPass();
  if (self.FormerPass)
  {
    this->SetDelegatePass(self.FormerPass);
  }
  renderer->SetPass(this);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::Detach(vtkRenderer* renderer)
{
  Internals& self = *this->Internal;
  if (!renderer || self.Attached != renderer)
  {
    return;
  }
  const vtkSmartPointer<vtkGodRaysPass> keep = this; // the renderer may hold the last reference
  if (self.Window)
  {
    self.Window->MakeCurrent();
    self.Release(self.Window);
  }
  if (renderer->GetPass() == this)
  {
    renderer->SetPass(self.FormerPass);
  }
  this->SetDelegatePass(self.FormerDelegate);
  self.FormerPass = nullptr;
  self.FormerDelegate = nullptr;
  self.Attached = nullptr;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::GetOcclusionImage(vtkImageData* image)
{
  Internals& self = *this->Internal;
  if (self.HasLayer && !self.HasLayerSum && self.NumberOfSources > 1)
  {
    // one layer texture served all lights in turn
    self.KeepLayerSum = true;
    self.Window->Render();
    self.KeepLayerSum = false;
  }
  if (!image || !self.HasLayer || !self.Window)
  {
    if (image)
    {
      image->Initialize();
    }
    return false;
  }
  self.Window->MakeCurrent();
  (self.HasLayerSum ? self.LayerSum : self.Occlusion->GetLayer()).Download(image);
  return true;
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
  self.Scattering.Download(image);
  return true;
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
  std::fill_n(seconds, static_cast<int>(NUMBER_OF_STAGES), 0.0);
  if (!self.Window || self.TimersUsed == 0)
  {
    return;
  }
  self.Window->MakeCurrent();
  glFinish();
  for (std::size_t i = 0; i < self.TimersUsed; ++i)
  {
    vtkOpenGLRenderTimer& timer = *self.Timers[i].second;
    while (!timer.Ready())
    {
      // all commands are done: the driver hands the result over at once
    }
    seconds[self.Timers[i].first] += timer.GetElapsedSeconds();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::Render(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  self.LightPlan.clear();
  self.HasScattering = false;
  self.HasLayer = false;
  self.HasLayerSum = false;
  self.TimersUsed = 0;
  this->NumberOfGeometryPasses = 1;

  vtkGodRaysView view;
  std::vector<vtkGodRaysSource> sources;
  const char* reason = this->FindReasonForNoRays(s, window);
  if (!reason)
  {
    int viewport[4];
    this->GetViewport(s, viewport);
    TellStereo(renderer, window);
    view.Set(renderer, viewport + 2, this->LayerMargin);
    this->CollectSources(renderer, view, sources);
    reason = sources.empty() ? "no light reaches the picture" : nullptr;
  }
  self.NumberOfSources = static_cast<int>(sources.size());
  if (reason)
  {
    self.StagePlan = std::string("rays: none, ") + reason + "\nscene: drawn straight through\n";
    this->RenderScene(s);
    return;
  }

  if (self.Window != window || self.ContextTime != window->GetContextCreationTime())
  {
    // also if the former window, or its context, is gone
    self.Release(self.Window ? self.Window.Get() : window);
  }
  self.Window = window;
  self.ContextTime = window->GetContextCreationTime();

  OverlaysHeldBack overlays(s, self.NoProp);
  self.StartTimer(SCENE, this->MeasureTimes);
  this->RenderScene(s);
  self.StopTimer();
  if (!this->RenderRays(s, view, sources))
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
  this->GetViewport(s, viewport);
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
void vtkGodRaysPass::GetViewport(const vtkRenderState* s, int viewport[4]) const
{
  if (vtkFrameBufferObjectBase* framebuffer = s->GetFrameBuffer())
  {
    viewport[0] = 0;
    viewport[1] = 0;
    framebuffer->GetLastSize(viewport + 2);
  }
  else
  {
    s->GetRenderer()->GetTiledSizeAndOrigin(viewport + 2, viewport + 3, viewport, viewport + 1);
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::RenderScene(const vtkRenderState* s)
{
  vtkRenderPass* scene = this->DelegatePass;
  if (!scene)
  {
    scene = s->GetFrameBuffer() ? static_cast<vtkRenderPass*>(this->Internal->StepsInFramebuffer)
                                : this->Internal->Steps;
  }
  scene->Render(s);
  this->NumberOfRenderedProps = scene->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::CollectSources(
  vtkRenderer* renderer, const vtkGodRaysView& view, std::vector<vtkGodRaysSource>& sources)
{
  Internals& self = *this->Internal;
  const bool linear = self.Model->GetLinearLight();
  std::ostringstream plan;

  const auto add = [&](vtkGodRaysSource& source, const double color[3], double intensity)
  {
    source.SetGlow(view, this->BackgroundGlowRadius, this->BackgroundGlowFalloff);
    self.SetMarch(source, view);
    double greatest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double light = linear ? vtkGodRays::DecodeDisplay(color[i]) : color[i];
      source.Color[i] =
        vtkGodRays::Sanitize(source.Fade * intensity * light, std::numeric_limits<float>::max());
      greatest = std::max(greatest, source.Color[i]);
    }
    plan << "light: " << source.Name;
    if (source.Fade <= 0.0)
    {
      plan << ", skipped: behind the camera\n";
    }
    else if (!(greatest > 0.0) && !source.Prop)
    {
      plan << ", skipped: off or black\n";
    }
    else if (!source.Reaches(view, this->BackgroundGlow > 0.0))
    {
      plan << ", skipped: neither it nor its glow can be in the picture\n";
    }
    else
    {
      plan << (source.Fade < 1.0 ? ", fading behind the camera\n" : "\n");
      sources.push_back(source);
    }
  };

  int number = 0;
  for (vtkLight* light : self.Lights)
  {
    vtkGodRaysSource source;
    source.Name = (light->GetPositional() ? "positional, number " : "directional, number ") +
      std::to_string(number++);
    double place[4];
    if (!GetWorldPlace(light, renderer->GetActiveCamera(), place))
    {
      plan << "light: " << source.Name << ", skipped: its position is its focal point\n";
      continue;
    }
    source.Place(view, place,
      light->GetPositional() ? this->FindSourceRadius(renderer)
                             : vtkMath::RadiansFromDegrees(this->SunAngularRadius));
    add(source, light->GetDiffuseColor(), light->GetSwitch() ? light->GetIntensity() : 0.0);
  }

  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    const double* bounds = nullptr;
    if (!prop->GetVisibility() || GetRole(prop) != LIGHT || !(bounds = prop->GetBounds()) ||
      !vtkMath::AreBoundsInitialized(bounds))
    {
      continue;
    }
    vtkGodRaysSource source;
    source.Name = std::string("prop tagged LIGHT, ") + prop->GetClassName();
    source.Prop = prop;
    const double place[4] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]), 1.0 };
    const double diagonal[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2],
      bounds[5] - bounds[4] };
    source.Place(view, place, 0.5 * vtkMath::Norm(diagonal));
    double color[3] = { 1.0, 1.0, 1.0 };
    if (auto actor = vtkActor::SafeDownCast(prop))
    {
      actor->GetProperty()->GetColor(color);
    }
    add(source, color, 1.0);
  }
  if (sources.empty() && plan.str().empty())
  {
    plan << "light: none; add one with AddLight() or tag a prop LIGHT\n";
  }
  self.LightPlan = plan.str();
}

//------------------------------------------------------------------------------
double vtkGodRaysPass::FindSourceRadius(vtkRenderer* renderer) const
{
  if (this->SourceRadius > 0.0)
  {
    return this->SourceRadius;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return 1.0;
  }
  const double diagonal[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2],
    bounds[5] - bounds[4] };
  return 0.02 * vtkMath::Norm(diagonal);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::RenderRays(
  const vtkRenderState* s, const vtkGodRaysView& view, const std::vector<vtkGodRaysSource>& sources)
{
  Internals& self = *this->Internal;
  vtkOpenGLRenderWindow* window = self.Window;
  vtkOpenGLState* state = window->GetState();
  StateKeeper keeper(state);

  int viewport[4];
  this->GetViewport(s, viewport);
  const BoundFramebuffer bound;
  if (!bound.Formats.Color || !bound.Formats.Depth)
  {
    return false;
  }
  const unsigned int precision = this->Precision == SINGLE ? GL_RGBA32F : GL_RGBA16F;

  vtkGodRaysOcclusionPass::Request occlusion;
  occlusion.Window = window;
  occlusion.Renderer = s->GetRenderer();
  occlusion.View = &view;
  occlusion.DepthFormat = bound.Formats.Depth;
  occlusion.ColorFormat = precision;
  occlusion.Margin = this->LayerMargin;
  occlusion.UntaggedPropsOcclude = this->UntaggedPropsOcclude;
  occlusion.LinearLight = self.Model->GetLinearLight();
  occlusion.Glow = this->BackgroundGlow;

  self.StartTimer(OCCLUDE, this->MeasureTimes);
  self.Scene.Prepare(window, viewport[2], viewport[3], bound.Formats);
  if (!self.Scene.Bind())
  {
    return false;
  }
  const unsigned int buffers = (this->Output == COMPOSITE ? GL_COLOR_BUFFER_BIT : 0) |
    (vtkGodRaysOcclusionPass::SceneDepthServes(occlusion) ? GL_DEPTH_BUFFER_BIT : 0);
  if (buffers)
  {
    bound.CopyTo(state, viewport, buffers);
  }
  occlusion.SceneDepth = self.Scene.GetDepth();
  if (!self.Occlusion->Begin(occlusion))
  {
    return false;
  }
  self.StopTimer();
  this->NumberOfGeometryPasses = self.Occlusion->GetRenderedOccluders() ? 2 : 1;

  self.Scattering.Prepare(window, viewport[2], viewport[3], { precision, 0 });
  Clear(self.Scattering, state);
  const bool sumLayers = sources.size() > 1 && (this->Output == OCCLUSION || self.KeepLayerSum);
  vtkGodRaysTarget& layer = self.Occlusion->GetLayer();
  if (sumLayers)
  {
    self.LayerSum.Prepare(window, layer.GetWidth(), layer.GetHeight(), { precision, 0 });
    Clear(self.LayerSum, state);
  }

  for (const vtkGodRaysSource& source : sources)
  {
    self.StartTimer(OCCLUDE, this->MeasureTimes);
    if (!self.Occlusion->Compose(source) || (sumLayers && !this->AddToLayerSum(layer)))
    {
      return false;
    }
    self.StopTimer();
    if (this->Output != OCCLUSION)
    {
      self.StartTimer(SCATTER, this->MeasureTimes);
      if (!this->Scatter(view, source, layer))
      {
        return false;
      }
      self.StopTimer();
    }
  }
  self.HasLayer = true;
  self.HasLayerSum = sumLayers;
  self.HasScattering = this->Output != OCCLUSION;

  self.StartTimer(BLEND, this->MeasureTimes);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.Binding);
  const bool blended = this->DrawOutput(viewport, sumLayers ? self.LayerSum : layer);
  self.StopTimer();
  this->DescribeStages(this->LayerMargin);
  return blended;
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::AddToLayerSum(vtkGodRaysTarget& layer)
{
  Internals& self = *this->Internal;
  vtkGodRaysBlendPass::Request request;
  request.Window = self.Window;
  request.Viewport[0] = 0;
  request.Viewport[1] = 0;
  request.Viewport[2] = layer.GetWidth();
  request.Viewport[3] = layer.GetHeight();
  request.Rays = layer.GetColor();
  request.LinearLight = false; // as it is
  request.ShowRays = true;
  request.Accumulate = true;
  return self.LayerSum.Bind() && self.Blending->Draw(request);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::Scatter(
  const vtkGodRaysView& view, const vtkGodRaysSource& source, vtkGodRaysTarget& layer)
{
  Internals& self = *this->Internal;
  vtkGodRaysIntegrator::Request request;
  request.Window = self.Window;
  request.Model = self.Model;
  request.Layer = layer.GetColor();
  std::copy_n(source.Clip, 3, request.LightClip);
  request.MarchScale = source.MarchScale;
  request.ViewScale = view.ViewScale;
  request.Peak = source.Prop ? 1.0 : *std::max_element(source.Color, source.Color + 3);
  request.ResolutionScale = this->ResolutionScale;
  request.ErrorTolerance = this->ErrorTolerance;
  request.Result = &self.Scattering;
  return self.Integrator->Integrate(request);
}

//------------------------------------------------------------------------------
bool vtkGodRaysPass::DrawOutput(const int viewport[4], vtkGodRaysTarget& layer)
{
  Internals& self = *this->Internal;
  vtkGodRaysBlendPass::Request request;
  request.Window = self.Window;
  std::copy_n(viewport, 4, request.Viewport);
  request.Scene = self.Scene.GetColor();
  request.Rays = this->Output == OCCLUSION ? layer.GetColor() : self.Scattering.GetColor();
  request.Intensity = this->Output == OCCLUSION ? 1.0 : this->Intensity;
  request.SceneGain = self.Model->GetSceneGain();
  request.LinearLight = self.Model->GetLinearLight();
  const int blend = this->Blend == MODEL_BLEND ? self.Model->GetBlend() : this->Blend;
  request.Screen = blend == SCREEN;
  request.ShowRays = this->Output != COMPOSITE;
  return self.Blending->Draw(request);
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
       << (self.Model->GetLinearLight() ? ", linear light" : ", shown values") << "\n";
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
void vtkGodRaysPass::SetBlend(int mode)
{
  this->SetMode("Blend", this->Blend, mode, SCREEN);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetOutput(int output)
{
  this->SetMode("Output", this->Output, output, SCATTERING);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetPrecision(int precision)
{
  this->SetMode("Precision", this->Precision, precision, SINGLE);
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::SetMode(const char* name, int& mode, int value, int last)
{
  if (value < 0 || value > last)
  {
    vtkErrorMacro(<< name << " must be in 0.." << last << ", not " << value << "; it stays " << mode
                  << ".");
  }
  else if (value != mode)
  {
    mode = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Release(window);
  this->Internal->StepsInFramebuffer->ReleaseGraphicsResources(window);
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
  os << indent << "ResolutionScale: " << this->ResolutionScale << "\n";
  os << indent << "UntaggedPropsOcclude: " << (this->UntaggedPropsOcclude ? "on" : "off") << "\n";
  os << indent << "SourceRadius: " << this->SourceRadius << "\n";
  os << indent << "SunAngularRadius: " << this->SunAngularRadius << "\n";
  os << indent << "BackgroundGlow: " << this->BackgroundGlow << "\n";
  os << indent << "BackgroundGlowRadius: " << this->BackgroundGlowRadius << "\n";
  os << indent << "BackgroundGlowFalloff: " << this->BackgroundGlowFalloff << "\n";
  os << indent << "LayerMargin: " << this->LayerMargin << "\n";
  os << indent << "Blend: " << this->Blend << "\n";
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
