// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysOcclusionPass.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysOcclusionFS.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysProjection.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysSortedProps.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysView.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysOcclusionPass);

namespace
{
void SetUpDrawing(vtkOpenGLState* state)
{
  state->vtkglClearDepth(1.0);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// While it lives, the renderer looks through a camera whose picture includes the margin, if any.
void IncludeMargin(vtkRenderer* renderer, const vtkGodRaysView& view,
  vtkSmartPointer<vtkCamera>& wide, std::optional<vtkGodRaysProjection>& projection)
{
  if (view.ViewScale < 1.0)
  {
    projection.emplace(renderer, view, view.ViewToClip, wide);
  }
}

/// A part of a layer: first and past the last column, first and past the last row [pixels].
struct Rectangle
{
  int Bounds[4];

  double GetArea() const
  {
    return 1.0 * std::max(0, this->Bounds[1] - this->Bounds[0]) *
      std::max(0, this->Bounds[3] - this->Bounds[2]);
  }
  Rectangle Within(const Rectangle& other) const
  {
    return { { std::max(this->Bounds[0], other.Bounds[0]),
      std::min(this->Bounds[1], other.Bounds[1]), std::max(this->Bounds[2], other.Bounds[2]),
      std::min(this->Bounds[3], other.Bounds[3]) } };
  }
  void SetScissor(vtkOpenGLState* state) const
  {
    state->vtkglScissor(this->Bounds[0], this->Bounds[2],
      std::max(0, this->Bounds[1] - this->Bounds[0]),
      std::max(0, this->Bounds[3] - this->Bounds[2]));
  }
};

/// What of a layer of this size is drawn: of a tile, what lies in the whole picture.
Rectangle GetDrawn(const vtkGodRaysOcclusionPass::Request& frame, const int size[2])
{
  Rectangle drawn = { { 0, size[0], 0, size[1] } };
  if (frame.IsTile)
  {
    const int tile[2] = { static_cast<int>(frame.SceneDepth->GetWidth()),
      static_cast<int>(frame.SceneDepth->GetHeight()) };
    for (int i = 0; i < 2; ++i)
    {
      const int margin = (size[i] - tile[i]) / 2;
      drawn.Bounds[2 * i] = std::max(0, margin - frame.Beyond[2 * i]);
      drawn.Bounds[2 * i + 1] = std::min(size[i], margin + tile[i] + frame.Beyond[2 * i + 1]);
    }
  }
  return drawn;
}

/// The prop as an actor, if what VTK's usual mapper and shaders draw is all that it shows; else null.
vtkActor* FindUsualActor(vtkProp* prop)
{
  auto actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  vtkShaderProperty* shaders = actor ? actor->GetShaderProperty() : nullptr;
  return mapper && shaders && std::string(actor->GetClassName()) == "vtkOpenGLActor" &&
      std::string(mapper->GetClassName()) == "vtkOpenGLPolyDataMapper" &&
      !shaders->HasVertexShaderCode() && !shaders->HasGeometryShaderCode() &&
      !shaders->HasFragmentShaderCode() && shaders->GetNumberOfShaderReplacements() == 0
    ? actor
    : nullptr;
}

/// Whether all of a prop is shown in its property's colour, which is that of its light.
bool HasOneColor(vtkProp* prop)
{
  vtkActor* actor = FindUsualActor(prop);
  if (!actor)
  {
    return false;
  }
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  int kind = 0;
  const bool hasScalars = mapper->GetScalarVisibility() &&
    (!mapper->GetInput() ||
      vtkAbstractMapper::GetScalars(mapper->GetInput(), mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), kind));
  return !hasScalars && !actor->GetTexture() && !actor->GetBackfaceProperty() &&
    property->GetNumberOfTextures() == 0 && !property->GetLighting() &&
    property->GetInterpolation() <= VTK_PHONG && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && property->GetAmbient() == 0.0 &&
    property->GetDiffuse() == 1.0 && property->GetSpecular() == 0.0 &&
    property->GetOpacity() >= 1.0; // also of an actor that is forced to be opaque
}

/// Where a prop is drawn; the bounds are left alone where that is not known: other shaders and mappers
/// may draw beyond the prop's bounds.
void FindPropBounds(vtkProp* prop, const vtkGodRaysView& view, const int size[2], int bounds[4])
{
  vtkActor* actor = FindUsualActor(prop);
  if (!actor)
  {
    return;
  }
  const double* box = actor->GetBounds();
  double corners[8][4];
  for (int corner = 0; corner < 8; ++corner)
  {
    const double world[4] = { box[corner & 1 ? 1 : 0], box[corner & 2 ? 3 : 2],
      box[corner & 4 ? 5 : 4], 1.0 };
    vtkMatrix4x4::MultiplyPoint(view.WorldToView, world, corners[corner]);
  }
  // for points, lines, and what the shader reads beside a pixel
  vtkProperty* property = actor->GetProperty();
  const double margin = 3.0 + std::max(property->GetPointSize(), property->GetLineWidth());
  view.GetHullBounds(corners, 8, size, margin, bounds);
}

/// Join translucent parts of all processes: what they let through, in alpha, is multiplied, and
/// their colours are added.
void JoinOpacity(vtkGodRaysTarget& target, vtkGodRaysCompositor* compositor)
{
  std::vector<float> pixels = target.ReadColor();
  const std::size_t count = pixels.size() / 4;
  std::vector<float> through(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    through[i] = 1.0f - std::min(pixels[4 * i + 3], 1.0f);
  }
  compositor->Reduce(through.data(), count, vtkGodRaysCompositor::PRODUCT);
  for (std::size_t i = 0; i < count; ++i)
  {
    pixels[4 * i + 3] = 0.0f;
  }
  compositor->Reduce(pixels.data(), pixels.size(), vtkGodRaysCompositor::SUM);
  for (std::size_t i = 0; i < count; ++i)
  {
    pixels[4 * i + 3] = 1.0f - through[i];
  }
  target.WriteColor(pixels);
}
}

struct vtkGodRaysOcclusionPass::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysOcclusionFS", vtkGodRaysOcclusionFS };
  vtkGodRaysTarget Occluders; // depth, when the scene's will not do
  vtkGodRaysTarget Dimming;   // opacity, over the depth of the occluders
  vtkGodRaysTarget Opacity;   // of all that is shown, over the depth of the scene
  vtkGodRaysTarget Emitter;   // opaque parts of a prop tagged LIGHT
  vtkGodRaysTarget Haze;      // its translucent parts and volumes, over the depth of the occluders
  vtkGodRaysTarget Layer;
  vtkGodRaysTarget OneColorLayer; // one value a pixel
  vtkGodRaysTarget* Composed = nullptr;
  vtkSmartPointer<vtkCamera> WideCamera;
  Request Frame{};
  vtkGodRaysSortedProps SortedProps;
  std::vector<vtkProp*> Shown;       // that leave no depth
  std::vector<vtkProp*> Volumes;     // of those that are drawn; kept for its memory
  vtkTextureObject* Depth = nullptr; // of the occluders
  bool Dimmed = false;
  int Width = 0; // of the layer [pixels]
  int Height = 0;
  bool Distributed = false;
};

vtkGodRaysOcclusionPass::vtkGodRaysOcclusionPass()
  : Internal(new Internals)
{
  this->SetActiveDrawBuffers(1); // volume mappers ask for it
}

vtkGodRaysOcclusionPass::~vtkGodRaysOcclusionPass() = default;

bool vtkGodRaysOcclusionPass::SceneDepthServes(const Request& request)
{
  vtkGodRaysSortedProps& sorted = this->Internal->SortedProps;
  sorted.Sort(request);
  return sorted.SceneDepthServes(request);
}

bool vtkGodRaysOcclusionPass::Begin(const Request& request)
{
  Internals& self = *this->Internal;
  self.Frame = request;
  vtkGodRaysSortedProps& sorted = self.SortedProps;
  sorted.Sort(request);
  this->RenderedOpacity = false;
  const auto enlarged = [&request](unsigned int size)
  { return static_cast<int>(std::lround(size * (1.0 + 2.0 * request.Margin))); };
  const int width = self.Width = enlarged(request.SceneDepth->GetWidth());
  const int height = self.Height = enlarged(request.SceneDepth->GetHeight());

  vtkOpenGLState* state = request.Window->GetState();
  SetUpDrawing(state);
  std::optional<vtkGodRaysProjection> camera;
  IncludeMargin(request.Renderer, *request.View, self.WideCamera, camera);

  vtkGodRaysCompositor* compositor = request.Compositor;
  self.Distributed = compositor && compositor->IsDistributed();
  self.Depth = request.SceneDepth;
  this->RenderedOccluders = !sorted.SceneDepthServes(request);
  if (this->RenderedOccluders)
  {
    self.Occluders.Prepare(request.Window, width, height, { GL_RGBA8, request.DepthFormat });
    if (!self.Occluders.Bind())
    {
      return false;
    }
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (vtkProp* prop : sorted.OccludingProps)
    {
      prop->RenderOpaqueGeometry(request.Renderer);
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (self.Distributed)
    {
      std::vector<float> depth = self.Occluders.ReadDepth();
      compositor->Reduce(depth.data(), depth.size(), vtkGodRaysCompositor::LEAST);
      self.Occluders.WriteDepth(depth);
    }
    self.Depth = self.Occluders.GetDepth();
  }

  this->NumberOfTranslucentProps = static_cast<int>(sorted.Dimming.size());
  self.Dimmed = vtkGodRaysCompositor::Any(compositor, !sorted.Dimming.empty());
  if (self.Dimmed)
  {
    // 8 bits would round away faint ones
    self.Dimming.Prepare(request.Window, GL_RGBA16F, self.Depth);
    if (!self.Dimming.Bind())
    {
      return false;
    }
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    this->RenderTranslucent(sorted.Dimming.data(), sorted.Dimming.size());
    if (self.Distributed)
    {
      JoinOpacity(self.Dimming, compositor);
    }
  }

  return true;
}

void vtkGodRaysOcclusionPass::End()
{
  this->Internal->Frame = Request();
  this->Internal->SortedProps.OccludingProps.clear();
  this->Internal->SortedProps.Dimming.clear();
  this->Internal->Shown.clear();
  this->Internal->Volumes.clear();
  this->Internal->Depth = nullptr;
}

vtkTextureObject* vtkGodRaysOcclusionPass::FindOpacity()
{
  Internals& self = *this->Internal;
  const vtkGodRaysSortedProps& sorted = self.SortedProps;
  sorted.FindShown(self.Frame, self.Shown);
  if (self.Dimmed && (self.Distributed || self.Shown == sorted.Dimming))
  {
    return self.Dimming.GetColor();
  }
  if (self.Distributed || self.Shown.empty())
  {
    return nullptr; // on several processes alpha says it
  }
  vtkOpenGLState* state = self.Frame.Window->GetState();
  state->PushFramebufferBindings();
  self.Opacity.Prepare(self.Frame.Window, GL_RGBA16F, self.Frame.SceneDepth);
  this->RenderedOpacity = self.Opacity.Bind();
  if (this->RenderedOpacity)
  {
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    this->RenderTranslucent(self.Shown.data(), self.Shown.size());
  }
  state->PopFramebufferBindings();
  return this->RenderedOpacity ? self.Opacity.GetColor() : nullptr;
}

void vtkGodRaysOcclusionPass::RenderTranslucent(vtkProp* const* props, std::size_t count)
{
  vtkRenderer* renderer = this->Internal->Frame.Renderer;
  std::vector<vtkProp*>& volumes = this->Internal->Volumes;
  volumes.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (props[i]->HasTranslucentPolygonalGeometry())
    {
      props[i]->RenderTranslucentPolygonalGeometry(renderer);
    }
    if (vtkGodRaysHasVolume(props[i]))
    {
      volumes.push_back(props[i]);
    }
  }
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(volumes.data(), static_cast<int>(volumes.size()));
  this->Render(&state);
}

void vtkGodRaysOcclusionPass::Render(const vtkRenderState* s)
{
  this->PreRender(s);
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    s->GetPropArray()[i]->RenderVolumetricGeometry(s->GetRenderer());
  }
  this->PostRender(s);
}

bool vtkGodRaysOcclusionPass::Compose(const vtkGodRaysLight& light)
{
  Internals& self = *this->Internal;
  const Request& frame = self.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  const bool hazy = light.Prop &&
    vtkGodRaysCompositor::Any(frame.Compositor,
      light.Prop->HasTranslucentPolygonalGeometry() || vtkGodRaysHasVolume(light.Prop));
  if (light.Prop)
  {
    self.Emitter.Prepare(
      frame.Window, self.Width, self.Height, { frame.ColorFormat, frame.DepthFormat });
    if (!self.Emitter.Bind())
    {
      return false;
    }
    SetUpDrawing(state);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    std::optional<vtkGodRaysProjection> camera;
    IncludeMargin(frame.Renderer, *frame.View, self.WideCamera, camera);
    light.Prop->RenderOpaqueGeometry(frame.Renderer);
    if (self.Distributed)
    {
      this->JoinEmitter();
    }
    if (hazy)
    {
      self.Haze.Prepare(frame.Window, frame.ColorFormat, self.Depth);
      if (!self.Haze.Bind())
      {
        return false;
      }
      state->vtkglClear(GL_COLOR_BUFFER_BIT);
      this->RenderTranslucent(&light.Prop, 1);
      if (self.Distributed)
      {
        JoinOpacity(self.Haze, frame.Compositor);
      }
    }
  }

  // A disc and its glow have one colour, and a prop may have the glow's.
  const bool oneColor = frame.OneColorFormat &&
    (!light.Prop || (!hazy && !self.Distributed && HasOneColor(light.Prop)));
  self.Composed = oneColor ? &self.OneColorLayer : &self.Layer;
  self.Composed->Prepare(frame.Window, self.Width, self.Height,
    { oneColor ? frame.OneColorFormat : frame.ColorFormat, 0 });
  if (!self.Composed->Bind())
  {
    return false;
  }
  state->vtkglDisable(GL_BLEND);
  const int size[2] = { self.Width, self.Height };
  const Rectangle drawn = GetDrawn(frame, size);
  // The emitter takes more than the glow, and that more than nothing: each only where it may be, if
  // that is not most of the layer.
  Rectangle emitter = { { 0, size[0], 0, size[1] } };
  Rectangle glow = { { 0, frame.Glow > 0.0 ? size[0] : 0, 0, size[1] } };
  if (!light.Prop)
  {
    light.GetDiscBounds(*frame.View, size, emitter.Bounds);
  }
  else if (!hazy && !self.Distributed)
  {
    FindPropBounds(light.Prop, *frame.View, size, emitter.Bounds);
  }
  const double most = 0.5 * size[0] * size[1];
  const bool everywhere = emitter.GetArea() > most;
  if (!everywhere && frame.Glow > 0.0)
  {
    light.GetGlowBounds(*frame.View, size, glow.Bounds);
  }
  const bool glowsEverywhere = !everywhere && glow.GetArea() > most;
  if ((!everywhere && !glowsEverywhere) || drawn.GetArea() < 2.0 * most)
  {
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  if (!everywhere)
  {
    const Rectangle part = glowsEverywhere ? drawn : glow.Within(drawn);
    part.SetScissor(state);
    if (part.GetArea() > 0.0 && !this->Draw(light, GLOW, false))
    {
      return false;
    }
  }
  const Rectangle part = everywhere ? drawn : emitter.Within(drawn);
  part.SetScissor(state);
  return part.GetArea() == 0.0 || this->Draw(light, light.Prop ? PROP : DISC, hazy);
}

// Draw the glow into the bound framebuffer, alone or with the disc or prop.
bool vtkGodRaysOcclusionPass::Draw(const vtkGodRaysLight& light, Part part, bool hazy)
{
  Internals& self = *this->Internal;
  const Request& frame = self.Frame;
  vtkShaderProgram* program = self.Quad.Begin(frame.Window,
    { { "dimmed", self.Dimmed }, { "prop", part == PROP }, { "disc", part == DISC },
      { "evenly", part == PROP && self.Composed == &self.OneColorLayer }, { "hazy", hazy },
      { "planar", light.Planar },
      { "multisampled", frame.Multisampled && !this->RenderedOccluders },
      { "linearLight", frame.Transfer != vtkGodRaysTransfer::NONE },
      { "isPower", frame.Transfer == vtkGodRaysTransfer::POWER } });
  if (!program)
  {
    return false;
  }
  double origin[3];
  double right[3];
  double up[3];
  frame.View->GetPicture(light.Planar, origin, right, up);
  vtkGodRaysQuad::SetVector(program, "pictureOrigin", origin);
  vtkGodRaysQuad::SetVector(program, "pictureRight", right);
  vtkGodRaysQuad::SetVector(program, "pictureUp", up);
  const float pixelStep[2] = { 2.0f / static_cast<float>(self.Width),
    2.0f / static_cast<float>(self.Height) };
  program->SetUniform2f("pixelStep", pixelStep);
  vtkGodRaysQuad::SetVector(program, "lightPosition", light.Position);
  vtkGodRaysQuad::SetVector(program, "lightDirection", light.Direction);
  const double white[3] = { 1.0, 1.0, 1.0 };
  vtkGodRaysQuad::SetVector(
    program, "lightColor", self.Composed == &self.OneColorLayer ? white : light.Color);
  program->SetUniformf("lightDepth", static_cast<float>(light.Depth));
  program->SetUniformf("lightRadius", static_cast<float>(light.Radius));
  program->SetUniformf("leastPixel", static_cast<float>(light.LeastPixel));
  program->SetUniformf("fade", static_cast<float>(light.Fade));
  program->SetUniformf("glow", static_cast<float>(frame.Glow));
  program->SetUniformf("glowRadius", static_cast<float>(light.GlowRadius));
  program->SetUniformf("glowFalloff", static_cast<float>(light.GlowFalloff));
  program->SetUniformf("maximum", frame.ColorFormat == GL_RGBA16F ? 65504.0f : 1e30f);
  self.Quad.SetTexture("occluderDepth", self.Depth);
  if (self.Dimmed)
  {
    self.Quad.SetTexture("translucency", self.Dimming.GetColor());
  }
  if (part == PROP)
  {
    if (self.Composed != &self.OneColorLayer)
    {
      self.Quad.SetTexture("propColor", self.Emitter.GetColor());
    }
    self.Quad.SetTexture("propDepth", self.Emitter.GetDepth());
  }
  if (hazy)
  {
    self.Quad.SetTexture("haze", self.Haze.GetColor());
  }
  self.Quad.End();
  return true;
}

// Of the parts of a prop on all processes, the nearest.
void vtkGodRaysOcclusionPass::JoinEmitter()
{
  Internals& self = *this->Internal;
  vtkGodRaysCompositor* compositor = self.Frame.Compositor;
  const std::vector<float> own = self.Emitter.ReadDepth();
  std::vector<float> depth = own;
  compositor->Reduce(depth.data(), depth.size(), vtkGodRaysCompositor::LEAST);
  std::vector<float> color = self.Emitter.ReadColor();
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    if (own[i] > depth[i])
    {
      std::fill_n(color.begin() + 4 * i, 4, 0.0f);
    }
  }
  compositor->Reduce(color.data(), color.size(), vtkGodRaysCompositor::GREATEST);
  self.Emitter.WriteDepth(depth);
  self.Emitter.WriteColor(color);
}

vtkTextureObject* vtkGodRaysOcclusionPass::GetDimming()
{
  return this->Internal->Dimmed ? this->Internal->Dimming.GetColor() : nullptr;
}

vtkGodRaysTarget* vtkGodRaysOcclusionPass::GetLayer()
{
  return this->Internal->Composed;
}

vtkTextureObject* vtkGodRaysOcclusionPass::GetDepth()
{
  return this->Internal->Depth;
}

const std::vector<vtkProp*>& vtkGodRaysOcclusionPass::GetOccludingProps() const
{
  return this->Internal->SortedProps.OccludingProps;
}

std::string vtkGodRaysOcclusionPass::Describe() const
{
  std::ostringstream text;
  text << (this->RenderedOccluders ? "occluders rendered into the layer, a second time"
                                   : "depth of the scene, no second rendering of geometry");
  if (this->NumberOfTranslucentProps)
  {
    text << "; opacity of " << this->NumberOfTranslucentProps << " translucent props or volumes";
  }
  if (this->RenderedOpacity)
  {
    text << "; opacity of data before the background, rendered a second time";
  }
  return text.str();
}

void vtkGodRaysOcclusionPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Quad.Release();
  this->Internal->Dimming.Release(window); // before the depth that they borrow
  this->Internal->Opacity.Release(window);
  this->Internal->Haze.Release(window);
  this->Internal->Occluders.Release(window);
  this->Internal->Emitter.Release(window);
  this->Internal->Layer.Release(window);
  this->Internal->OneColorLayer.Release(window);
  this->Internal->Composed = nullptr;
  this->Internal->Depth = nullptr;
}

void vtkGodRaysOcclusionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RenderedOccluders: " << this->RenderedOccluders << "\n";
  os << indent << "NumberOfTranslucentProps: " << this->NumberOfTranslucentProps << "\n";
}
