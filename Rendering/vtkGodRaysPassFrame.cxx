// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What vtkGodRaysPass does in a frame; see Documentation/Architecture.md.
#include "vtkGodRaysPassInternals.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysOcclusionPass.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysView.h"
#include "vtkMath.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace
{
/// The number of tiles of a large screenshot, across or up, whichever is more; 1 for a whole picture.
double GetTiles(vtkRenderWindow* window)
{
  int tiles[2];
  window->GetTileScale(tiles);
  return std::max(tiles[0], tiles[1]);
}

/// How much of a picture lies left of, right of, below and above a tile of it [pixels], with a margin that is
/// a fraction of the picture; negative for less than the tile.
void FindBeyond(vtkRenderer* renderer, double margin, int beyond[4])
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  int size[2];
  int origin[2]; // in the tile
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const double* tile = window->GetTileViewport();
  const double* part = renderer->GetViewport();
  const int* all = window->GetSize(); // of all tiles
  for (int i = 0; i < 2; ++i)
  {
    const double low = all[i] * (tile[i] - part[i]) + origin[i];
    const double picture = all[i] * (part[i + 2] - part[i]);
    beyond[2 * i] = static_cast<int>(std::lround(low + margin * picture));
    beyond[2 * i + 1] = static_cast<int>(std::lround(picture - low - size[i] + margin * picture));
  }
}

/// The whole picture, where one tile of it has the corners (0, 0) and (1, 1): its corner and its size.
void FindPicture(vtkRenderer* renderer, double picture[4])
{
  int size[2];
  int beyond[4];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  FindBeyond(renderer, 0.0, beyond);
  for (int i = 0; i < 2; ++i)
  {
    picture[i] = -static_cast<double>(beyond[2 * i]) / size[i];
    picture[i + 2] = 1.0 + static_cast<double>(beyond[2 * i] + beyond[2 * i + 1]) / size[i];
  }
}

bool IsDisabledByEnvironment()
{
  const char* value = std::getenv("GODRAYS_DISABLE");
  return value && *value && std::string(value) != "0";
}
}

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
  const vtkGodRaysSurfaceShadows::Ending ending = { self.Shadows };
  self.Finder.Clear();
  self.Concerns.clear();
  self.IsStill = window && window->GetDesiredUpdateRate() < 1.0 && !s->GetRenderer()->GetSelector();
  self.HasScattering = false;
  self.HasRays = false;
  self.Timers.BeginFrame(this->MeasureTimes);
  this->NumberOfGeometryPasses = 1;

  vtkGodRaysView view;
  std::vector<vtkGodRaysLight> lights = std::move(self.FormerLights);
  std::string reason = this->FindReasonForNothing(s, window);
  if (reason.empty() && this->SurfaceShadows)
  {
    this->TakeWindow(window);
  }
  else if (!this->SurfaceShadows && self.Window)
  {
    self.Shadows->ReleaseGraphicsResources(self.Window); // maps take tens of megabytes
  }
  self.HasShadows = reason.empty() && this->SurfaceShadows;
  if (reason.empty())
  {
    self.SceneSize.Find(renderer, self.Compositor);
    reason = this->FindReasonForNoRays(s);
  }
  const bool hasLayers = reason.empty();
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
    const std::string fault = this->FindFault(renderer, view, viewport + 2, lights);
    if (!fault.empty())
    {
      this->Complain(": " + fault);
      reason = fault;
    }
    else if (lights.empty() && !this->DimsScene() && !self.IsNewPicture)
    {
      reason = "no light reaches the picture";
      this->AdviseOnLights();
    }
  }
  self.SunMoved = false;
  this->LightTheData(renderer);
  if (!reason.empty())
  {
    self.NumberOfLights = 0;
    this->RenderScene(s);
    self.StagePlan = "rays: none, " + reason + "\nscene: drawn straight through\n" +
      (self.HasShadows ? self.Shadows->Describe() + "\n" : "");
    if (hasLayers && this->Output != COMPOSITE)
    {
      this->ShowNoLight(s, window->GetState()); // the layers are dark, not absent
    }
    return;
  }

  this->TakeWindow(window);
  vtkGodRaysOverlays overlays(s);
  const int failures = vtkGodRaysQuad::GetNumberOfFailures();
  const auto drawScene = [&]
  {
    self.Timers.Start(vtkGodRaysTimers::SCENE);
    {
      const vtkGodRaysHiddenProps hidden(s, self.Effect->GetOwnProps());
      this->RenderScene(s);
    }
    self.Timers.Stop();
  };
  drawScene();
  bool done = !self.IsOwnDelegate && this->RenderRays(s, view, lights);
  if (done && (this->LightData || this->SurfaceShadows) && self.SunMoved)
  {
    self.IsNewPicture = false; // the scene once more, in the light from where the sun stands now
    this->LightTheData(renderer);
    drawScene();
    done = this->RenderRays(s, view, lights);
  }
  if (self.IsOwnDelegate)
  {
    self.StagePlan = "rays: none, the delegate leads back to this pass\n";
  }
  else if (!done && self.Window->GetAbortRender())
  {
    self.StagePlan = "rays: none, the frame was aborted\n";
  }
  else if (!done)
  {
    if (vtkGodRaysQuad::GetNumberOfFailures() == failures)
    {
      this->Complain(": the framebuffer of this window cannot be copied or drawn into by the rays' "
                     "stages. Render into a window or framebuffer with a depth buffer and 8-bit or "
                     "floating-point RGBA colours");
    }
    self.StagePlan = "rays: none, after an error\n";
  }
  overlays.Draw();
  lights.clear(); // they name props
  self.FormerLights = std::move(lights);
  vtkOpenGLCheckErrorMacro("failed after Render");
}

// Make the resources those of a window and its context.
void vtkGodRaysPass::TakeWindow(vtkOpenGLRenderWindow* window)
{
  Internals& self = *this->Internal;
  if (self.Window != window || self.ContextTime != window->GetContextCreationTime())
  {
    // also if the former window, or its context, is gone
    self.Release(self.Window ? self.Window.Get() : window);
    window->MakeCurrent(); // windows of EGL leave the context current in which they released
  }
  self.Window = window;
  self.ContextTime = window->GetContextCreationTime();
}

const char* vtkGodRaysPass::FindReasonForNothing(
  const vtkRenderState* s, vtkOpenGLRenderWindow* window)
{
  int viewport[4];
  if (!window)
  {
    this->Complain(": the render window is not an OpenGL window. Use VTK's OpenGL back end");
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
  return "";
}

const char* vtkGodRaysPass::FindReasonForNoRays(const vtkRenderState* s)
{
  const Internals& self = *this->Internal;
  if (this->Intensity == 0.0)
  {
    return "Intensity is 0";
  }
  if (vtkRenderPass* hiding = vtkGodRaysAttachment::FindWithoutDepth(this->DelegatePass))
  {
    this->Complain(std::string(": under it there is a ") + hiding->GetClassName() +
      ", which leaves no depth of the scene. Make this pass the delegate of that one, as Attach() "
      "does");
    return "what is under it leaves no depth";
  }
  if (!self.Model->CanScatter() &&
    !vtkGodRaysCompositor::Any(self.Compositor, self.Effect->HasOwnProps(s->GetRenderer())))
  {
    this->Advise("the model's parameters scatter nothing. Set its density, exposure, weight or "
                 "scattering above 0, or Intensity to 0 for a picture without rays");
    return "the model's parameters scatter nothing";
  }
  if (!self.Integrator->Supports(self.Model))
  {
    this->Complain(std::string(": a ") + self.Integrator->GetClassName() + " cannot evaluate a " +
      self.Model->GetClassName() + ". Set an integrator that supports it");
    return "the integrator does not support the model";
  }
  return "";
}

// What of the frame cannot be computed with; lights of which that is so are left out.
std::string vtkGodRaysPass::FindFault(vtkRenderer* renderer, const vtkGodRaysView& view,
  const int size[2], std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  const std::string fault = vtkGodRaysGate::FindFault(renderer, view, size);
  if (!fault.empty())
  {
    return fault;
  }
  self.HasNoLight = false;
  this->FindLights(renderer, view, lights);
  self.HasNoLight = lights.empty();
  const bool movesSun = this->MovesSun();
  self.CoverageIsCurrent = false;
  self.IsNewPicture = (movesSun || self.Effect->UsesCoverage()) &&
    vtkGodRaysCompositor::Any(self.Compositor, this->SeesNewPicture(renderer));
  if (!self.IsNewPicture &&
    this->IsSunMissing()) // in a tile, which does not show all that there is
  {
    this->PlaceSun(renderer);
    this->FindLights(renderer, view, lights);
  }
  if (lights.empty() && !movesSun)
  {
    self.IsNewPicture = self.CoverageIsCurrent = false; // nobody needs it
    self.CoveredPicture = {};
  }
  for (const std::string& faultOfLight : self.Finder.GetFaults())
  {
    this->Complain(" " + faultOfLight);
  }
  const std::string obstacle =
    self.Effect->FindObstacle(renderer, self.Compositor, self.SceneSize, view, size);
  const std::string& faultOfScene = self.Finder.GetFaultOfScene();
  return faultOfScene.empty() ? obstacle : faultOfScene;
}

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

// Whether the picture changes where no light is scattered.
bool vtkGodRaysPass::DimsScene() const
{
  return this->Internal->Effect->DimsScene() && this->Output == COMPOSITE;
}

void vtkGodRaysPass::RenderScene(const vtkRenderState* s)
{
  vtkRenderPass* scene = this->DelegatePass;
  if (!scene)
  {
    scene = this->Internal->RendererSteps;
  }
  Internals& self = *this->Internal;
  self.IsOwnDelegate = false;
  const bool shadows = self.HasShadows && this->DrawShadows(s);
  self.DrawsScene = true;
  self.Shadows->SetActive(shadows);
  scene->Render(s);
  self.Shadows->SetActive(false);
  self.DrawsScene = false;
  vtkOpenGLClearErrorMacro(); // of VTK's passes, which a VTK without debugging does not tell of
  if (self.IsOwnDelegate)
  {
    this->Complain(": the delegate of this pass leads back to it. Set another delegate, or none; a "
                   "pass that has this one for its delegate is what the renderer takes, by "
                   "SetPass(), without Attach()");
  }
  this->NumberOfRenderedProps = scene->GetNumberOfRenderedProps();
}

// Draw the maps of the renderer's lights. Returns false if there are no shadows.
bool vtkGodRaysPass::DrawShadows(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkGodRaysView view;
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  vtkGodRaysScene::UpdateStereo(s->GetRenderer());
  view.Set(s->GetRenderer(), viewport + 2, 0.0);
  vtkGodRaysSurfaceShadows::Request request;
  request.Window = self.Window;
  request.Renderer = s->GetRenderer();
  request.View = &view;
  request.Size[0] = viewport[2];
  request.Size[1] = viewport[3];
  request.Tiles = GetTiles(self.Window);
  request.WithoutShadows = self.DataLights.GetLights();
  request.UntaggedPropsOcclude = this->UntaggedPropsOcclude;
  request.MostDataShadow = this->MostDataShadow;
  vtkGodRaysMedium medium;
  if (this->Intensity > 0.0 && self.Model->CanScatter() &&
    self.Effect->FindMedium(s->GetRenderer(), self.SceneSize, view, medium))
  {
    request.Medium = &medium;
  }
  request.Soft = this->SoftShadows;
  request.SunAngularRadius = vtkMath::RadiansFromDegrees(this->GetSunAngularRadius());
  request.SourceRadius = this->SourceRadius;
  request.Scene = &self.SceneSize;
  const double* bounds = self.SceneSize.GetBounds();
  if (self.SceneSize.GetFault().empty() && vtkMath::AreBoundsInitialized(bounds))
  {
    request.Diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
    for (int i = 0; i < 6; ++i)
    {
      request.Away = std::max(request.Away, std::abs(bounds[i]));
    }
  }
  const std::string fault = vtkGodRaysGate::FindFault(s->GetRenderer(), view, request.Size);
  if (fault.empty())
  {
    const vtkGodRaysStateKeeper keeper(self.Window->GetState());
    if (self.Shadows->Begin(request))
    {
      const std::string concern =
        "no light casts shadows on surfaces: headlights do not. Add to the "
        "renderer a vtkLight with SetLightTypeToSceneLight()";
      auto& concerns = self.Concerns; // the scene is drawn again once a sun is placed
      concerns.erase(std::remove(concerns.begin(), concerns.end(), concern), concerns.end());
      if (!self.Shadows->HasLights())
      {
        concerns.push_back(concern);
      }
      for (const std::string& faultOfLight : self.Shadows->GetFaults())
      {
        if (self.Complaints.insert(" " + faultOfLight).second) // else its rays lack, too
        {
          vtkWarningMacro("There are no shadows on surfaces " << faultOfLight << ".");
        }
      }
      return true;
    }
  }
  if (self.Complaints.insert("shadows").second)
  {
    vtkWarningMacro("There are no shadows on surfaces: "
      << (fault.empty() ? "the driver refuses to draw into textures of depths" : fault) << ".");
  }
  return false;
}

void vtkGodRaysPass::FindLights(
  vtkRenderer* renderer, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  vtkGodRaysLightFinder& finder = self.Finder;
  finder.Renderer = renderer;
  finder.SourceRadius = this->SourceRadius;
  finder.SunAngularRadius = this->GetSunAngularRadius();
  finder.BackgroundGlow = this->BackgroundGlow;
  finder.BackgroundGlowRadius = this->BackgroundGlowRadius;
  finder.BackgroundGlowFalloff = this->BackgroundGlowFalloff;
  finder.Transfer = self.Transfer;
  finder.Tiles = GetTiles(renderer->GetRenderWindow());
  finder.Compositor = self.Compositor;
  finder.Scene = &self.SceneSize;
  finder.AboveAir = false;
  self.Effect->SetUp(finder);
  finder.Find(view, self.Lights, lights);
}

bool vtkGodRaysPass::RenderRays(
  const vtkRenderState* s, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  const vtkGodRaysStateKeeper keeper(self.Window->GetState());
  const vtkGodRaysOwnShaders shaders(s);
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  const vtkGodRaysFramebuffer bound;
  const bool done = bound.Formats.Color && bound.Formats.Depth &&
    this->FindOccluders(s, view, bound, viewport) && this->LookAtPicture(s, view, lights) &&
    this->DrawLights(s, view, lights) && this->DrawOutput(s, bound, viewport);
  self.HasRays = self.HasRays && done; // else layers may lack lights
  self.Effect->End();
  self.Occlusion->End();
  return done;
}

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
  occlusion.IsTile = GetTiles(self.Window) > 1.0;
  if (occlusion.IsTile)
  {
    FindBeyond(s->GetRenderer(), this->LayerMargin, occlusion.Beyond);
  }
  occlusion.UntaggedPropsOcclude = this->UntaggedPropsOcclude;
  occlusion.Transfer = self.Transfer;
  occlusion.Glow = this->BackgroundGlow;
  occlusion.Compositor = self.Compositor;
  self.Effect->SetUp(occlusion, self.Integrator);
  // Translucent props and volumes cover the picture, too.
  occlusion.Dims = occlusion.Dims || self.IsNewPicture;

  const bool depthServes = self.Occlusion->SceneDepthServes(occlusion);
  const unsigned int buffers = (this->Output == COMPOSITE ? GL_COLOR_BUFFER_BIT : 0) |
    (depthServes || self.Effect->ReadsSceneDepth() || this->MetersPicture() || self.IsNewPicture
        ? GL_DEPTH_BUFFER_BIT
        : 0);
  if (!self.Scene.Copy(self.Window, bound, viewport, buffers))
  {
    return false;
  }
  self.Coverage =
    this->MetersPicture() ? self.Scene.FindCoverage(self.Window, bound, viewport) : nullptr;
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

bool vtkGodRaysPass::DrawLights(
  const vtkRenderState* s, const vtkGodRaysView& view, const std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  vtkGodRaysEffect::Frame frame;
  frame.Window = self.Window;
  frame.Renderer = s->GetRenderer();
  frame.View = &view;
  frame.Scene = &self.SceneSize;
  frame.Integrator = self.Integrator;
  frame.Occlusion = self.Occlusion;
  frame.SceneDepth = self.Scene.GetDepth();
  frame.Compositor = self.Compositor;
  frame.Timers = &self.Timers;
  frame.Light = &self.Scattering;
  frame.Format = this->GetLayerFormat();
  frame.NumberOfLights = self.NumberOfLights = static_cast<int>(lights.size());
  frame.Interactive = self.Window->GetDesiredUpdateRate() >= 1.0;
  frame.ErrorTolerance = frame.Interactive
    ? std::max(this->ErrorTolerance, this->InteractiveErrorTolerance)
    : this->ErrorTolerance;
  // Each tile has an error of its own, and edges of tiles must not show.
  if (GetTiles(self.Window) > 1.0)
  {
    frame.ErrorTolerance *= 0.5;
  }
  frame.Placer = self.CoverageIsCurrent ? self.Placer.Get() : nullptr;
  frame.InventsStreaks = !this->DataFirst;
  FindPicture(s->GetRenderer(), frame.Picture);
  frame.KeepsLayers = this->Output == OCCLUSION || self.KeepAllLayers;
  frame.Scatters = this->Output != OCCLUSION;
  const int width = static_cast<int>(frame.SceneDepth->GetWidth());
  const int height = static_cast<int>(frame.SceneDepth->GetHeight());
  self.Scattering.Begin(self.Window, width, height, frame.Format);
  self.Effect->Begin(frame);
  self.HasRays = true;
  constexpr double patience = 2.0; // [s]
  const double start = vtkTimerLog::GetUniversalTime();
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    if (!self.Effect->DrawLight(frame, lights[i]) || self.Window->CheckAbortStatus())
    {
      return false;
    }
    double done = static_cast<double>(i + 1) / static_cast<double>(lights.size());
    if (vtkTimerLog::GetUniversalTime() - start > patience)
    {
      this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    }
  }
  return self.Scattering.Finish();
}

unsigned int vtkGodRaysPass::GetLayerFormat() const
{
  return this->Precision == SINGLE ? GL_RGBA32F : GL_RGBA16F;
}

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
    double above[3];
    static_cast<void>(std::any_of(self.Lights.begin(), self.Lights.end(),
      [&](vtkLight* each) { return vtkGodRaysGetLightAboveAir(each, above, request.SkyLight); }));
  }
  request.Screen = this->Blend == MODEL_BLEND ? request.Screen : this->Blend == SCREEN;
  bool drawn = true;
  if (light)
  {
    request.Window = self.Window;
    std::copy_n(viewport, 4, request.Viewport);
    int beyond[4];
    FindBeyond(s->GetRenderer(), 0.0, beyond);
    request.Tile[0] = beyond[0];
    request.Tile[1] = beyond[2];
    request.PictureHeight = viewport[3] + beyond[2] + beyond[3];
    request.Scene = self.Scene.GetColor();
    request.Backdrop = self.HasBackdrop ? self.Backdrop.GetColor() : nullptr;
    request.Rays = light->GetTexture();
    request.Tint = light->GetTint();
    request.Response = light->GetResponse();
    request.Transfer = self.Transfer;
    request.ShowRays = this->Output != COMPOSITE;
    request.Depth = request.Depth ? request.Depth : self.Scene.GetDepth();
    request.Bytes = bound.Formats.Color == GL_RGBA8;
    request.Shoulder =
      this->HighlightShoulder && request.Bytes && self.Transfer != vtkGodRaysTransfer::NONE;
    request.Coverage = self.Coverage;
    drawn = self.FindExposure(*this, s->GetRenderer(), GetTiles(self.Window) > 1.0, request);
    request.Intensity = this->Output == OCCLUSION ? 1.0 : this->GetExposure();
    drawn = drawn && self.Blending->Draw(request);
  }
  else
  {
    this->ShowNoLight(s, state);
  }
  self.Timers.Stop();
  this->FindConcerns();
  this->DescribeStages(request.Screen);
  return drawn;
}

// Keeps what is probably not meant in a whole, still picture, and warns of each kind once; not where lights
// are at fault, which is told already.
void vtkGodRaysPass::Advise(const std::string& concern)
{
  Internals& self = *this->Internal;
  if (!concern.empty() && this->Output == COMPOSITE && self.IsStill)
  {
    self.Concerns.push_back(concern);
    if (self.Complaints.insert(concern.substr(0, concern.find_first_of(":."))).second &&
      self.Finder.GetFaults().empty())
    {
      vtkWarningMacro(<< concern << ".");
    }
  }
}

// Says why no light makes rays, and what to do.
void vtkGodRaysPass::AdviseOnLights()
{
  const Internals& self = *this->Internal;
  const bool isPlaced =
    self.PlacedSun && self.Lights.size() == 1 && self.Lights.front() == self.PlacedSun;
  if (isPlaced && this->SunPlacement < SUN_EVERY_VIEW)
  {
    this->Advise("the sun left the picture. Set SunPlacement to SUN_EVERY_VIEW, so that it "
                 "follows still views, or call PlaceSun() again");
    return;
  }
  const std::string skipped = "skipped: ";
  const std::string& plan = self.Finder.GetPlan();
  const auto found = plan.find(skipped);
  std::string cause = "there is none";
  if (found != std::string::npos)
  {
    const auto start = found + skipped.size();
    cause = plan.substr(start, plan.find('\n', start) - start);
  }
  this->Advise("no light reaches the picture (" + cause +
    "). Move a light behind the data, where the camera sees it, or set SunPlacement to "
    "SUN_EVERY_VIEW, which places a sun");
}

// Looks for what is probably not meant in a picture with rays.
void vtkGodRaysPass::FindConcerns()
{
  constexpr double hidden = 0.0067; // transmittance of an optical depth of 5
  constexpr double unchanged = 0.99;
  const Internals& self = *this->Internal;
  const std::string concern = self.Effect->FindConcern();
  this->Advise(concern);
  const bool showsRays = self.IsMetered
    ? self.Surround.Part > 0.0 || self.Meter.ShowsRays(this->GetExposure())
    : self.HasScattering;
  const double left = !this->DimsScene() ? 1.0
    : self.IsMetered                     ? self.Meter.FindTransmittance()
                                         : 0.5;
  if (self.NumberOfLights == 0 && !this->DimsScene())
  {
    this->AdviseOnLights();
  }
  else if (concern.empty() && left < hidden)
  {
    std::ostringstream text;
    text << "the medium hides the scene: it leaves " << 100.0 * left
         << " % of its light. Set WorldUnitInMeters, scale heights, or less scattering";
    this->Advise(text.str());
  }
  else if (concern.empty() && !showsRays && left > unchanged && self.Effect->GetOwnProps().empty())
  {
    this->Advise("the rays change nothing that can be seen. Move a light where it is seen past "
                 "something, before a background that is not white, or set a larger Intensity");
  }
}

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

void vtkGodRaysPass::DescribeStages(bool screen)
{
  Internals& self = *this->Internal;
  std::ostringstream plan;
  plan << "scene: drawn in place, geometry rendered "
       << (this->NumberOfGeometryPasses == 1 ? "once" : "twice") << "\n"
       << self.SceneSize.Describe();
  if (self.HasShadows)
  {
    plan << self.Shadows->Describe() << "\n";
  }
  plan << "occlusion: " << self.Occlusion->Describe();
  if (self.Margin > 0.0)
  {
    plan << ", margin " << self.Margin;
  }
  plan << "\nmodel: " << self.Model->Describe() << self.Effect->Describe() << "\nscattering: "
       << (this->Output == OCCLUSION ? "skipped, the occlusion layer is shown"
                                     : self.Integrator->Describe(self.Model))
       << this->DescribeErrors() << "\nblend: "
       << (this->Output != COMPOSITE ? "skipped, one layer is shown"
              : screen               ? "screen"
                                     : "additive")
       << (self.Transfer == vtkGodRaysTransfer::NONE      ? ", shown values"
              : self.Transfer == vtkGodRaysTransfer::SRGB ? ", linear light"
                                                          : ", linear light by a power of 2.2");
  if (self.IsMetered && this->AutomaticExposure)
  {
    plan << ", exposure " << self.Exposure.Everywhere << " by the picture";
    if (self.Exposure.OverData < 1.0)
    {
      plan << ", over data " << self.Exposure.OverData << " of that";
    }
    if (self.Exposure.OverDark < 1.0)
    {
      plan << ", over dark ones " << self.Exposure.OverDark;
    }
    if (self.Exposure.DataGain > 1.0)
    {
      plan << ", data " << self.Exposure.DataGain << " times as bright as the medium leaves them";
    }
  }
  if (self.IsMetered && self.Surround.Part > 0.0)
  {
    plan << ", shadows darken the background by up to " << 100.0 * self.Surround.Part << " %";
  }
  plan << "\n";
  self.StagePlan = plan.str();
}

std::string vtkGodRaysPass::DescribeErrors() const
{
  const Internals& self = *this->Internal;
  const double estimate = self.Integrator->GetErrorEstimate();
  if (this->Output == OCCLUSION || estimate < 0.0)
  {
    return "";
  }
  std::ostringstream text;
  const std::string leftOut = self.Effect->DescribeErrors();
  text << "\nerror: asked for " << this->ErrorTolerance << ", measured " << estimate << ", largest "
       << self.Integrator->GetLargestVerifiedError() << " of the brightest ray"
       << (leftOut.empty() ? "" : "; ") << leftOut;
  return text.str();
}

void vtkGodRaysPass::Complain(const std::string& complaint)
{
  if (this->Internal->Complaints.insert(complaint).second)
  {
    vtkWarningMacro("The scene is drawn without god rays" << complaint << ".");
  }
}
