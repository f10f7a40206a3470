// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysScene.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRole.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysScene);

namespace
{
/// A prop that draws nothing.
class NoProp : public vtkProp
{
public:
  static NoProp* New();
  vtkTypeMacro(NoProp, vtkProp);
};
vtkStandardNewMacro(NoProp);

/// Whether the renderer's own steps can draw translucent props into the framebuffer that is bound. Its
/// passes for them have several textures of their own, which VTK does not set where mappers write several at
/// once already; and vtkOrderIndependentTranslucentPass copies depths into a texture of the window's format,
/// which fails from another, as within vtkEDLShading.
bool CanRendererBlend(const vtkRenderState* s)
{
  if (vtkGodRaysFramebuffer::HasSeveralBuffers())
  {
    return false;
  }
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** const props = s->GetPropArray();
  if (!s->GetFrameBuffer() || renderer->GetUseDepthPeeling() ||
    std::none_of(props, props + s->GetPropArrayCount(),
      [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; }))
  {
    return true;
  }
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const unsigned int ofWindow = window->GetStencilCapable() ? GL_DEPTH24_STENCIL8
    : window->GetDepthBufferSize() == 32                    ? GL_DEPTH_COMPONENT32
                                                            : GL_DEPTH_COMPONENT24;
  return vtkGodRaysFramebuffer().Formats.Depth == ofWindow;
}

/// All that follows the camera, once that has set the viewport.
class Steps : public vtkRenderPass
{
public:
  static Steps* New();
  vtkTypeMacro(Steps, vtkRenderPass);
  std::function<void()> Backdrop;
  void Render(const vtkRenderState* s) override
  {
    if (this->Backdrop)
    {
      this->Backdrop();
    }
    vtkRenderer* renderer = s->GetRenderer();
    this->UpdateLightGeometry(renderer);
    this->UpdateLights(renderer);
    if (!CanRendererBlend(s))
    {
      this->OneByOne->Render(s);
      this->NumberOfRenderedProps = this->OneByOne->GetNumberOfRenderedProps();
    }
    else
    {
      // Passes around this one, such as vtkEDLShading, write depths with the state that vtkRenderStepsPass
      // leaves; the renderer's pass for translucent geometry leaves another.
      auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
      const vtkOpenGLState::ScopedglEnableDisable depthTest(window->GetState(), GL_DEPTH_TEST);
      const vtkOpenGLState::ScopedglDepthMask depthMask(window->GetState());
      this->UpdateGeometry(renderer, s->GetFrameBuffer());
      this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered();
    }
  }
  vtkNew<vtkDefaultPass> OneByOne;
};
vtkStandardNewMacro(Steps);
}

vtkGodRaysScene::vtkGodRaysScene()
{
  vtkNew<Steps> steps;
  this->InFramebuffer->SetDelegatePass(steps);
}

vtkGodRaysScene::~vtkGodRaysScene() = default;

void vtkGodRaysScene::Render(const vtkRenderState* s)
{
  if (s->GetFrameBuffer())
  {
    this->InFramebuffer->Render(s);
  }
  else
  {
    this->UpdateCamera(s->GetRenderer());
    this->InFramebuffer->GetDelegatePass()->Render(s);
  }
  this->NumberOfRenderedProps = this->InFramebuffer->GetDelegatePass()->GetNumberOfRenderedProps();
}

void vtkGodRaysScene::SetBackdrop(std::function<void()> draw)
{
  static_cast<Steps*>(this->InFramebuffer->GetDelegatePass())->Backdrop = std::move(draw);
}

void vtkGodRaysScene::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->InFramebuffer->ReleaseGraphicsResources(window);
}

void vtkGodRaysScene::GetViewport(const vtkRenderState* s, int viewport[4])
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

void vtkGodRaysScene::UpdateStereo(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (!camera->GetStereo() == !window->GetStereoRender())
  {
    return;
  }
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(window)->GetState();
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

namespace
{
/// The props that are hidden at this moment, on the thread that draws.
std::vector<vtkProp*>& GetHidden()
{
  thread_local std::vector<vtkProp*> hidden;
  return hidden;
}
}

vtkGodRaysHiddenProps::vtkGodRaysHiddenProps(
  const vtkRenderState* s, const std::vector<vtkProp*>& props)
  : State(s)
  , Former(GetHidden().size())
{
  if (props.empty())
  {
    return;
  }
  GetHidden().insert(GetHidden().end(), props.begin(), props.end());
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp*& prop = s->GetPropArray()[i];
    if (std::find(props.begin(), props.end(), prop) != props.end())
    {
      this->Hidden.emplace_back(i, prop);
      this->StandIns.push_back(vtkSmartPointer<NoProp>::New());
      prop = this->StandIns.back();
    }
  }
}

vtkGodRaysHiddenProps::~vtkGodRaysHiddenProps()
{
  GetHidden().resize(this->Former);
  for (const auto& each : this->Hidden)
  {
    this->State->GetPropArray()[each.first] = each.second;
  }
}

bool vtkGodRaysHiddenProps::IsHidden(vtkProp* prop)
{
  const std::vector<vtkProp*>& hidden = GetHidden();
  return std::find(hidden.begin(), hidden.end(), prop) != hidden.end();
}

vtkGodRaysOwnShaders::vtkGodRaysOwnShaders(const vtkRenderState* s)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    vtkInformation* keys = prop->GetPropertyKeys();
    if (keys && keys->Has(key))
    {
      const auto kept = vtkSmartPointer<vtkInformation>::New();
      kept->CopyEntry(keys, key);
      std::vector<vtkObjectBase*> own;
      for (int k = 0; k < key->Length(keys); ++k)
      {
        vtkObjectBase* pass = key->Get(keys, k);
        if (std::string(pass->GetClassName()).rfind("vtkGodRays", 0) == 0)
        {
          own.push_back(pass);
        }
      }
      if (static_cast<int>(own.size()) == key->Length(keys))
      {
        continue;
      }
      keys->Remove(key);
      for (vtkObjectBase* pass : own)
      {
        key->Append(keys, pass);
      }
      this->Passes.emplace_back(prop, kept);
    }
  }
}

vtkGodRaysOwnShaders::~vtkGodRaysOwnShaders()
{
  for (const auto& each : this->Passes)
  {
    each.first->GetPropertyKeys()->CopyEntry(each.second, vtkOpenGLRenderPass::RenderPasses());
  }
}

vtkGodRaysOverlays::vtkGodRaysOverlays(const vtkRenderState* s)
  : State(s)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp*& prop = s->GetPropArray()[i];
    if (vtkGodRaysIsOverlay(prop))
    {
      this->Overlays.emplace_back(i, prop);
      this->StandIns.push_back(vtkSmartPointer<NoProp>::New());
      prop = this->StandIns.back();
    }
  }
}

vtkGodRaysOverlays::~vtkGodRaysOverlays()
{
  for (const auto& overlay : this->Overlays)
  {
    this->State->GetPropArray()[overlay.first] = overlay.second;
  }
}

void vtkGodRaysOverlays::Draw()
{
  vtkRenderer* renderer = this->State->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  // Some passes, such as vtkShadowMapPass, leave those of the whole window; others, such as
  // vtkDepthOfFieldPass, draw into a larger one and need theirs again.
  const vtkOpenGLState::ScopedglViewport formerViewport(window->GetState());
  const vtkOpenGLState::ScopedglScissor formerScissor(window->GetState());
  int viewport[4];
  vtkGodRaysScene::GetViewport(this->State, viewport);
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  window->GetState()->vtkglScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  for (const auto& overlay : this->Overlays)
  {
    overlay.second->RenderOpaqueGeometry(renderer); // where text and scalar bars are prepared
  }
  for (const auto& overlay : this->Overlays)
  {
    if (overlay.second->HasTranslucentPolygonalGeometry())
    {
      overlay.second->RenderTranslucentPolygonalGeometry(renderer);
    }
  }
  for (const auto& overlay : this->Overlays)
  {
    overlay.second->RenderOverlay(renderer);
  }
}
