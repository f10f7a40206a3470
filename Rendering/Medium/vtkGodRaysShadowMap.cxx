// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowMap.h"

#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysLightLayers.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysProjection.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

vtkGodRaysShadowMap::vtkGodRaysShadowMap() = default;
vtkGodRaysShadowMap::~vtkGodRaysShadowMap() = default;

bool vtkGodRaysShadowMap::Draw(const vtkGodRaysMediumIntegrator::Request& request, int size,
  int levels, vtkTextureObject* atlas, const int corner[2])
{
  this->Fit(request, size, levels, atlas, corner);
  return this->Kept || this->Redraw(request, atlas);
}

void vtkGodRaysShadowMap::Fit(const vtkGodRaysMediumIntegrator::Request& request, int size,
  int levels, vtkTextureObject* atlas, const int corner[2])
{
  this->Kept = false;
  this->NumberOfChanged = 0;
  this->Faces.Fit(request, size, levels);
  if (this->Faces.Count == 0)
  {
    return;
  }
  vtkGodRaysTarget& map = this->Maps[this->Faces.Count / 6];
  const int part[4] = { corner ? corner[0] : 0, corner ? corner[1] : 0,
    this->Faces.GetColumns() * this->Faces.Size, this->Faces.GetRows() * this->Faces.Size };
  if (atlas)
  {
    map.Prepare(request.Window, 0, atlas, part);
  }
  else
  {
    map.Prepare(request.Window, part[2], part[3], { 0, GL_DEPTH_COMPONENT32F });
  }
  this->Asked.Find(request, this->Faces, map);
  this->Kept = !this->Asked.Objects.empty() && this->Asked.IsSame(this->Drawn);
}

bool vtkGodRaysShadowMap::Redraw(
  const vtkGodRaysMediumIntegrator::Request& request, vtkTextureObject* atlas)
{
  this->Kept = false;
  if (this->Faces.Count == 0)
  {
    return true;
  }
  vtkGodRaysTarget& map = this->Maps[this->Faces.Count / 6];
  // One number for all maps, as a walk may be given those of one light after those of another.
  static std::atomic<unsigned int> version{ 0 };
  this->Faces.Grids.Version = ++version;
  const bool hasRest = this->FindRest();
  this->Drawn.Clear();
  this->Depths.clear();
  if (!this->Render(request, map, hasRest) || (!atlas && !this->RenderTranslucent(request, map)))
  {
    return false;
  }
  std::swap(this->Drawn, this->Asked);
  return true;
}

// Which props have not changed since the map was drawn last, or, once there is a map of such props, since it
// was drawn: one that has changed stays out of it until none is left in it. False if there are none.
bool vtkGodRaysShadowMap::FindRest()
{
  const std::size_t props = this->Asked.GetNumberOfProps();
  const bool hasRest = this->Asked.HasSameFaces(this->Rest);
  this->RestIsDrawn = hasRest;
  if (!hasRest)
  {
    this->IsAtRest.assign(props, this->Asked.HasSameFaces(this->Drawn));
  }
  const vtkGodRaysShadowState& former = hasRest ? this->Rest : this->Drawn;
  for (std::size_t i = 0; i < props; ++i)
  {
    if (this->IsAtRest[i] && !this->Asked.HasSameProp(former, i))
    {
      this->IsAtRest[i] = false;
      this->RestIsDrawn = false;
    }
  }
  const auto resting = std::count(this->IsAtRest.begin(), this->IsAtRest.end(), true);
  if (!this->RestIsDrawn)
  {
    this->Rest = resting > 0 ? this->Asked : vtkGodRaysShadowState();
  }
  this->NumberOfChanged = this->RestIsDrawn ? static_cast<int>(props - resting) : 0;
  return resting > 0;
}

bool vtkGodRaysShadowMap::Render(
  const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map, bool hasRest)
{
  vtkOpenGLState* state = request.Window->GetState();
  const int rectangle[4] = { 0, 0, map.GetWidth(), map.GetHeight() };
  if (hasRest)
  {
    this->RestMap.Prepare(request.Window, rectangle[2], rectangle[3], { 0, GL_DEPTH_COMPONENT32F });
  }
  if (!(hasRest ? this->RestMap : map).Bind())
  {
    this->Rest.Clear();
    return false;
  }
  state->vtkglDepthMask(GL_TRUE);
  if (!hasRest || !this->RestIsDrawn)
  {
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
    if (!this->RenderProps(request, (hasRest ? this->RestMap : map).GetOrigin(), true, !hasRest))
    {
      this->Rest.Clear();
      return false;
    }
  }
  if (hasRest)
  {
    const vtkGodRaysFramebuffer rest;
    if (!map.Bind())
    {
      return false;
    }
    rest.CopyTo(state, rectangle, GL_DEPTH_BUFFER_BIT, map.GetOrigin());
    return this->RenderProps(request, map.GetOrigin(), false, true);
  }
  else if (request.Compositor && request.Compositor->IsDistributed())
  {
    std::vector<float> depth = map.ReadDepth();
    request.Compositor->Reduce(depth.data(), depth.size(), vtkGodRaysCompositor::LEAST);
    map.WriteDepth(depth);
  }
  return true;
}

// Draws the props that rest, those that change, or both. Returns false if the frame is to be aborted.
bool vtkGodRaysShadowMap::RenderProps(const vtkGodRaysMediumIntegrator::Request& request,
  const int origin[2], bool resting, bool changed)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  std::vector<vtkProp*> props;
  for (std::size_t i = 0; i < request.Occluders->size(); ++i)
  {
    const bool rests = i < this->IsAtRest.size() && this->IsAtRest[i];
    if (rests ? resting : changed)
    {
      props.push_back((*request.Occluders)[i]);
    }
  }
  return this->ForFaces(request, origin, props,
    [&](const std::vector<vtkProp*>& seen)
    {
      for (vtkProp* prop : seen)
      {
        vtkGodRaysProjection::DrawBothSides(prop, request.Renderer);
      }
    });
}

// Looks through each face in turn, and draws the props that it sees. Returns false if the frame is to be
// aborted.
bool vtkGodRaysShadowMap::ForFaces(const vtkGodRaysMediumIntegrator::Request& request,
  const int origin[2], const std::vector<vtkProp*>& props,
  const std::function<void(std::vector<vtkProp*>&)>& draw)
{
  vtkOpenGLState* state = request.Window->GetState();
  for (int face = 0; face < this->Faces.Count; ++face)
  {
    const int columns = this->Faces.GetColumns();
    const int corner[2] = { origin[0] + face % columns * this->Faces.Size,
      origin[1] + face / columns * this->Faces.Size };
    state->vtkglViewport(corner[0], corner[1], this->Faces.Size, this->Faces.Size);
    state->vtkglScissor(corner[0], corner[1], this->Faces.Size, this->Faces.Size);
    const vtkGodRaysProjection projection(
      request.Renderer, *request.View, this->Faces.ViewToMap[face], this->Camera);
    std::vector<vtkProp*> seen = projection.FindSeen(props);
    draw(seen);
    if (request.Window->CheckAbortStatus())
    {
      return false;
    }
  }
  return true;
}

bool vtkGodRaysShadowMap::RenderTranslucent(
  const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map)
{
  std::vector<vtkProp*> props;
  std::copy_if(request.Occluders->begin(), request.Occluders->end(), std::back_inserter(props),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  std::vector<vtkVolume*> volumes;
  this->LeftOut = 0;
  for (vtkProp* prop : *request.Occluders)
  {
    vtkVolume* volume = vtkGodRaysVolumeHaze::GetVolume(prop);
    if (volume)
    {
      volumes.push_back(volume);
    }
    else if (vtkGodRaysHasVolume(prop))
    {
      ++this->LeftOut;
    }
  }
  const bool hasSurfaces = vtkGodRaysCompositor::Any(request.Compositor, !props.empty());
  const bool hasVolumes = vtkGodRaysCompositor::Any(request.Compositor, !volumes.empty());
  this->Layers.Reset();
  this->NumberOfLayers = 0;
  if (!hasSurfaces && this->Peeler)
  {
    this->Peeler->ReleaseGraphicsResources(request.Window);
    this->Peeler = nullptr;
  }
  if (hasSurfaces && !this->Peeler)
  {
    this->Peeler = vtkSmartPointer<vtkGodRaysLightLayers>::New();
  }
  if (hasSurfaces &&
    !this->Peeler->Draw(request.Window, request.Renderer, props, map, request.Compositor,
      [&](const std::function<void(std::vector<vtkProp*>&)>& draw)
      { return this->ForFaces(request, map.GetOrigin(), props, draw); }))
  {
    return false;
  }
  static const std::vector<vtkGodRaysShadowLayers::Surface> none;
  const auto& surfaces = hasSurfaces ? this->Peeler->GetSurfaces() : none;
  vtkGodRaysShadowLayers::Haze haze;
  if (hasVolumes)
  {
    this->LeftOut +=
      vtkGodRaysVolumeHaze::Make(request, volumes, this->Faces.Grids, this->Faces.Size, haze);
  }
  if (request.WantsLayers && (hasVolumes || !surfaces.empty()))
  {
    this->Depths = map.ReadDepth();
    this->Layers.Make(this->Depths, surfaces, hasVolumes ? &haze : nullptr, this->GetGrids());
    this->NumberOfLayers = this->Layers.GetNumberOfLayers();
    this->HasColoredLayers = this->GetGrids().Colored;
  }
  else
  {
    this->Layers.Clear();
  }
  if (hasSurfaces)
  {
    this->Peeler->Clear();
  }
  return true;
}

std::string vtkGodRaysShadowMap::DescribeLayers() const
{
  if (this->Faces.Count == 0)
  {
    return "";
  }
  std::string text;
  if (this->NumberOfLayers > 0)
  {
    text +=
      "; " + std::to_string(this->NumberOfLayers) + " layers, as some props let light through";
  }
  if (this->Peeler && this->Peeler->WereMore())
  {
    text += "; what is behind " + std::to_string(vtkGodRaysLightLayers::MaximumSurfaces) +
      " translucent surfaces casts no shadow unless it is opaque";
  }
  if (this->LeftOut > 0)
  {
    text += "; " + std::to_string(this->LeftOut) +
      " volumes cast no shadow: they are no images of finite numbers, or have gradient opacity, a "
      "2-D transfer function or another blend mode than composite";
  }
  return text;
}

const vtkGodRaysShadowGrids& vtkGodRaysShadowMap::GetGrids()
{
  if (this->Faces.Count == 0)
  {
    this->Faces.Grids.Levels = 0;
    this->Faces.Grids.Layers = nullptr;
    this->Faces.Grids.NumberOfLayers = 0;
    this->Faces.Grids.Colored = false;
    return this->Faces.Grids;
  }
  if (this->Depths.empty() && this->HasNumbers())
  {
    this->Depths = this->Maps[this->Faces.Count / 6].ReadDepth();
  }
  const std::ptrdiff_t columns = this->Faces.GetColumns();
  for (int level = 0; level < this->Faces.Grids.Levels; ++level)
  {
    vtkGodRaysShadowGrids::Grid& grid = this->Faces.Grids.Grids[level];
    grid.Stride = columns * this->Faces.Size;
    grid.First = (level / columns * grid.Stride + level % columns) * this->Faces.Size;
    grid.Depths = this->Depths.data() + grid.First;
  }
  this->Layers.Set(this->Faces.Grids);
  if (!this->HasNumbers())
  {
    this->Faces.Grids.NumberOfLayers = this->NumberOfLayers;
    this->Faces.Grids.Colored = this->HasColoredLayers;
  }
  return this->Faces.Grids;
}

void vtkGodRaysShadowMap::TakeMemory(vtkGodRaysShadowMap& other)
{
  this->Layers.Clear();
  std::swap(this->Layers, other.Layers);
  std::swap(this->Peeler, other.Peeler);
  std::swap(this->Depths, other.Depths);
}

double vtkGodRaysShadowMap::GetMemory() const
{
  constexpr double each = 40.0; // depth, dark parts, and what a pyramid has of them
  return each * this->Layers.GetNumberOfLayers() * this->Faces.Count * this->Faces.Size *
    this->Faces.Size;
}

void vtkGodRaysShadowMap::Release(vtkWindow* window)
{
  this->Drawn = vtkGodRaysShadowState();
  this->Rest = vtkGodRaysShadowState();
  this->RestMap.Release(window);
  this->Depths.clear();
  this->Layers.Clear();
  this->NumberOfLayers = 0;
  if (this->Peeler)
  {
    this->Peeler->ReleaseGraphicsResources(window);
    this->Peeler = nullptr;
  }
  this->Maps[0].Release(window);
  this->Maps[1].Release(window);
}
