// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowMap.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightLayers.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysProjection.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkUniforms.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

namespace
{
const double Eye[3] = { 0.0, 0.0, 0.0 };

/// The bounds of the occluders, on all processes, but of those that say theirs do not count and that cannot.
bool GetBounds(const vtkGodRaysMediumIntegrator::Request& request, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (vtkProp* prop : *request.Occluders)
  {
    const double* own = prop->GetBounds();
    if (own && vtkMath::AreBoundsInitialized(own) && vtkGodRaysGate::IsUsable(own))
    {
      for (int i = 0; i < 6; i += 2)
      {
        const bool first = bounds[i] > bounds[i + 1];
        bounds[i] = first ? own[i] : std::min(bounds[i], own[i]);
        bounds[i + 1] = first ? own[i + 1] : std::max(bounds[i + 1], own[i + 1]);
      }
    }
  }
  vtkGodRaysCompositor::JoinBounds(request.Compositor, bounds);
  return vtkMath::AreBoundsInitialized(bounds);
}

/// Add what an actor's depths depend on. False if VTK does not tell: of parts, of pieces, of what turns
/// to the camera or has holes of its own.
bool AddState(vtkProp* prop, std::vector<const void*>& objects, std::vector<double>& numbers)
{
  auto actor = vtkActor::SafeDownCast(prop);
  if (!actor || std::strcmp(actor->GetClassName(), "vtkOpenGLActor") != 0 || actor->GetTexture() ||
    !actor->GetMapper() ||
    std::strcmp(actor->GetMapper()->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return false;
  }
  vtkShaderProperty* shader = actor->GetShaderProperty();
  objects.push_back(actor);
  const vtkMTimeType times[] = { actor->GetRedrawMTime(), actor->GetUserTransformMatrixMTime(),
    shader->GetShaderMTime(), shader->GetVertexCustomUniforms()->GetMTime(),
    shader->GetGeometryCustomUniforms()->GetMTime(),
    shader->GetFragmentCustomUniforms()->GetMTime() };
  numbers.insert(numbers.end(), std::begin(times), std::end(times));
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    objects.push_back(planes->GetItem(i)); // whose changes the actor's time does not tell
    numbers.push_back(static_cast<double>(planes->GetItem(i)->GetMTime()));
  }
  return true;
}

/// Right, up, and backwards from what is looked at: made right-handed, in the camera's coordinates, so
/// that faces of props face as they do. In the world they are the same wherever the eye is.
void SetAxes(const vtkGodRaysView& view, const double backwards[3], double axes[3][3])
{
  const double* toView = view.WorldToView; // its rows turn, and mirror z
  double world[3];
  double right[3];
  double unused[3];
  for (int i = 0; i < 3; ++i)
  {
    world[i] =
      backwards[0] * toView[i] + backwards[1] * toView[4 + i] + backwards[2] * toView[8 + i];
  }
  vtkMath::Normalize(world);
  vtkMath::Perpendiculars(world, right, unused, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    const double mirrored = i == 2 ? -1.0 : 1.0;
    axes[0][i] = mirrored * vtkMath::Dot(toView + static_cast<std::ptrdiff_t>(4) * i, right);
    axes[2][i] = mirrored * backwards[i];
  }
  vtkMath::Cross(
    axes[2], axes[0], axes[1]); // at right angles, whatever the camera's own matrix does
  vtkMath::Normalize(axes[1]);
  vtkMath::Cross(axes[1], axes[2], axes[0]);
  for (int i = 0; i < 3; ++i)
  {
    axes[i][2] *= -1.0;
  }
}

/// Where the layer's point (x, y) is at a view depth.
void GetPlace(const vtkGodRaysView& view, double x, double y, double depth, double place[3])
{
  double origin[3];
  double right[3];
  double up[3];
  view.GetPicture(view.Parallel, origin, right, up);
  for (int i = 0; i < 3; ++i)
  {
    place[i] = origin[i] + x * right[i] + y * up[i];
  }
  const double scale = view.Parallel ? 1.0 : depth / place[2];
  for (int i = 0; i < 2; ++i)
  {
    place[i] *= scale;
  }
  place[2] = depth;
}

/// How far a place is along axes from an origin.
void GetAlong(
  const double axes[3][3], const double origin[3], const double place[3], double along[3])
{
  double from[3];
  vtkMath::Subtract(place, origin, from);
  for (int i = 0; i < 3; ++i)
  {
    along[i] = vtkMath::Dot(axes[i], from);
  }
}
}

//------------------------------------------------------------------------------
vtkGodRaysShadowMap::vtkGodRaysShadowMap() = default;
vtkGodRaysShadowMap::~vtkGodRaysShadowMap() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMap::Draw(
  const vtkGodRaysMediumIntegrator::Request& request, int size, int levels, bool translucent)
{
  this->Kept = false;
  this->Translucent = translucent;
  this->Levels = request.Light->IsInfinite() && !request.View->Parallel ? levels : 1;
  this->Fit(request);
  if (this->NumberOfFaces == 0)
  {
    return true;
  }
  const int columns = this->GetColumns();
  const int rows = this->GetRows();
  this->Size = std::min(this->Levels > 1 ? size / 2 : size,
    vtkTextureObject::GetMaximumTextureSize(request.Window) / columns);
  this->Texel /= this->Size;
  for (vtkGodRaysShadowGrids::Grid& grid : this->Grids.Grids)
  {
    for (int k = 0; k < 2; ++k)
    {
      grid.Size[k] = this->Size;
      grid.Texel[k] /= this->Size;
    }
  }
  vtkGodRaysTarget& map = this->Maps[this->NumberOfFaces / 6];
  map.Prepare(
    request.Window, columns * this->Size, rows * this->Size, { 0, GL_DEPTH_COMPONENT32F });
  this->FindState(request, this->Asked);
  this->Kept = !this->Asked.Objects.empty() && this->Asked.IsSame(this->Drawn);
  this->NumberOfChanged = 0;
  if (this->Kept)
  {
    return true;
  }
  const bool hasRest = this->FindRest();
  this->Drawn.Clear();
  this->Depths.clear();
  if (!this->Render(request, map, hasRest) || !this->RenderTranslucent(request, map))
  {
    return false;
  }
  std::swap(this->Drawn, this->Asked);
  return true;
}

//------------------------------------------------------------------------------
// Nothing, if another frame cannot be told to be the same.
void vtkGodRaysShadowMap::FindState(
  const vtkGodRaysMediumIntegrator::Request& request, State& state) const
{
  state.Clear();
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    return; // the others would have to agree
  }
  state.Objects = { request.Window, request.Renderer,
    this->Maps[this->NumberOfFaces / 6].GetDepth() };
  state.Numbers = { this->Size + 0.0, this->NumberOfFaces + 0.0, this->Translucent + 0.0 };
  for (int face = 0; face < this->NumberOfFaces; ++face)
  {
    for (const double* corner : this->Corners)
    {
      const double view[4] = { corner[0], corner[1], corner[2], 1.0 };
      double place[4];
      vtkMatrix4x4::MultiplyPoint(this->ViewToMap[face], view, place);
      state.Places.insert(state.Places.end(), place, place + 4);
    }
  }
  state.End();
  for (vtkProp* prop : *request.Occluders)
  {
    if (vtkVolume* volume = vtkGodRaysVolumeHaze::GetVolume(prop))
    {
      vtkGodRaysVolumeHaze::AddState(volume, state.Objects, state.Numbers);
    }
    else if (!AddState(prop, state.Objects, state.Numbers))
    {
      state.Clear();
      return;
    }
    state.End();
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMap::State::Clear()
{
  this->Objects.clear();
  this->Numbers.clear();
  this->Places.clear();
  this->Ends.clear();
}

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMap::State::IsSame(const State& other) const
{
  return this->Objects == other.Objects && this->Numbers == other.Numbers &&
    this->HasSameFaces(other);
}

//------------------------------------------------------------------------------
// And as many props.
bool vtkGodRaysShadowMap::State::HasSameFaces(const State& other) const
{
  if (this->Ends.empty() || this->Ends.size() != other.Ends.size() ||
    this->Ends[0] != other.Ends[0])
  {
    return false;
  }
  double largest = 0.0;
  for (const double place : this->Places)
  {
    largest = std::max(largest, std::abs(place));
  }
  return std::equal(this->Objects.begin(), this->Objects.begin() + this->Ends[0][0],
           other.Objects.begin()) &&
    std::equal(
      this->Numbers.begin(), this->Numbers.begin() + this->Ends[0][1], other.Numbers.begin()) &&
    std::equal(this->Places.begin(), this->Places.end(), other.Places.begin(), other.Places.end(),
      [=](double one, double two) { return std::abs(one - two) <= 1e-9 * largest; });
}

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMap::State::HasSameProp(const State& other, std::size_t prop) const
{
  const auto isSame = [&](const auto& own, const auto& others, int kind)
  {
    return std::equal(own.begin() + this->Ends[prop][kind],
      own.begin() + this->Ends[prop + 1][kind], others.begin() + other.Ends[prop][kind],
      others.begin() + other.Ends[prop + 1][kind]);
  };
  return isSame(this->Objects, other.Objects, 0) && isSame(this->Numbers, other.Numbers, 1);
}

//------------------------------------------------------------------------------
// Which props have not changed since the map was drawn last, or, once there is a map of such props, since it
// was drawn: one that has changed stays out of it until none is left in it. False if there are none.
bool vtkGodRaysShadowMap::FindRest()
{
  const std::size_t props = this->Asked.Ends.empty() ? 0 : this->Asked.Ends.size() - 1;
  const bool hasRest = this->Asked.HasSameFaces(this->Rest);
  this->RestIsDrawn = hasRest;
  if (!hasRest)
  {
    this->IsAtRest.assign(props, this->Asked.HasSameFaces(this->Drawn));
  }
  const State& former = hasRest ? this->Rest : this->Drawn;
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
    this->Rest = resting > 0 ? this->Asked : State();
  }
  this->NumberOfChanged = this->RestIsDrawn ? static_cast<int>(props - resting) : 0;
  return resting > 0;
}

//------------------------------------------------------------------------------
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
    this->RenderProps(request, true, !hasRest);
  }
  if (hasRest)
  {
    const vtkGodRaysFramebuffer rest;
    if (!map.Bind())
    {
      return false;
    }
    rest.CopyTo(state, rectangle, GL_DEPTH_BUFFER_BIT);
    this->RenderProps(request, false, true);
  }
  else if (request.Compositor && request.Compositor->IsDistributed())
  {
    std::vector<float> depth = map.ReadDepth();
    request.Compositor->Reduce(depth.data(), depth.size(), vtkGodRaysCompositor::LEAST);
    map.WriteDepth(depth);
  }
  return true;
}

//------------------------------------------------------------------------------
// Of those that rest, those that change, or both.
void vtkGodRaysShadowMap::RenderProps(
  const vtkGodRaysMediumIntegrator::Request& request, bool resting, bool changed)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  this->ForFaces(request,
    [&]()
    {
      std::size_t i = 0;
      for (vtkProp* prop : *request.Occluders)
      {
        const bool rests = i < this->IsAtRest.size() && this->IsAtRest[i];
        if (rests ? resting : changed)
        {
          prop->RenderOpaqueGeometry(request.Renderer);
        }
        ++i;
      }
    });
}

//------------------------------------------------------------------------------
// Look through each face in turn, and draw into it.
void vtkGodRaysShadowMap::ForFaces(
  const vtkGodRaysMediumIntegrator::Request& request, const std::function<void()>& draw)
{
  vtkOpenGLState* state = request.Window->GetState();
  for (int face = 0; face < this->NumberOfFaces; ++face)
  {
    const int columns = this->GetColumns();
    const int corner[2] = { face % columns * this->Size, face / columns * this->Size };
    state->vtkglViewport(corner[0], corner[1], this->Size, this->Size);
    state->vtkglScissor(corner[0], corner[1], this->Size, this->Size);
    const vtkGodRaysProjection projection(
      request.Renderer, *request.View, this->ViewToMap[face], this->Camera);
    draw();
  }
}

//------------------------------------------------------------------------------
bool vtkGodRaysShadowMap::RenderTranslucent(
  const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map)
{
  std::vector<vtkProp*> props;
  std::copy_if(request.Occluders->begin(), request.Occluders->end(), std::back_inserter(props),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  std::vector<vtkVolume*> volumes;
  this->LeftOut = this->Translucent ? 0 : static_cast<int>(props.size());
  for (vtkProp* prop : *request.Occluders)
  {
    vtkVolume* volume = this->Translucent ? vtkGodRaysVolumeHaze::GetVolume(prop) : nullptr;
    if (volume)
    {
      volumes.push_back(volume);
    }
    else if (vtkGodRaysHasVolume(prop))
    {
      ++this->LeftOut;
    }
  }
  const bool hasSurfaces =
    vtkGodRaysCompositor::Any(request.Compositor, !props.empty()) && this->Translucent;
  const bool hasVolumes = vtkGodRaysCompositor::Any(request.Compositor, !volumes.empty());
  this->Layers.Clear();
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
      [&](const std::function<void()>& draw) { this->ForFaces(request, draw); }))
  {
    return false;
  }
  static const std::vector<vtkGodRaysShadowLayers::Surface> none;
  const auto& surfaces = hasSurfaces ? this->Peeler->GetSurfaces() : none;
  vtkGodRaysShadowLayers::Haze haze;
  if (hasVolumes)
  {
    vtkGodRaysVolumeHaze::Make(request, volumes, this->Grids, this->Size, haze);
  }
  if (request.Result && (hasVolumes || !surfaces.empty())) // not where there is no picture
  {
    this->Depths = map.ReadDepth();
    this->Layers.Make(this->Depths, surfaces, hasVolumes ? &haze : nullptr, this->GetGrids());
  }
  if (hasSurfaces)
  {
    this->Peeler->Clear();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkGodRaysShadowMap::DescribeLayers() const
{
  if (this->NumberOfFaces == 0)
  {
    return "";
  }
  std::string text;
  if (this->Layers.GetNumberOfLayers() > 0)
  {
    text += "; " + std::to_string(this->Layers.GetNumberOfLayers()) +
      " layers, as some props let light through";
  }
  if (this->Peeler && this->Peeler->WereMore())
  {
    text += "; what is behind " + std::to_string(vtkGodRaysLightLayers::MaximumSurfaces) +
      " translucent surfaces casts no shadow unless it is opaque";
  }
  if (this->LeftOut > 0)
  {
    text += "; " + std::to_string(this->LeftOut) +
      (this->Translucent ? " volumes cast no shadow: they are no images, or have gradient opacity, "
                           "a 2-D transfer function or another blend mode than composite"
                         : " translucent props or volumes cast no shadow in steps");
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMap::Fit(const vtkGodRaysMediumIntegrator::Request& request)
{
  this->NumberOfFaces = 0;
  double bounds[6];
  if (!GetBounds(request, bounds))
  {
    return;
  }
  for (int i = 0; i < 8; ++i)
  {
    const double world[4] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)], 1.0 };
    double view[4];
    vtkMatrix4x4::MultiplyPoint(request.View->WorldToView, world, view);
    std::copy_n(view, 3, this->Corners[i]);
  }
  this->Grids.Point = !request.Light->IsInfinite();
  if (this->Grids.Point)
  {
    this->FitPoint(request);
  }
  else
  {
    this->FitDirectional(request);
  }
}

//------------------------------------------------------------------------------
// Across the light, of the occluders' shadow what may be seen; all of it, which is the same wherever the
// eye is, for one face if that is no more than four times as large.
void vtkGodRaysShadowMap::FitDirectional(const vtkGodRaysMediumIntegrator::Request& request)
{
  double axes[3][3];
  SetAxes(*request.View, request.Light->Direction, axes);
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int i = 0; i < 8; ++i)
  {
    double along[3];
    GetAlong(axes, Eye, this->Corners[i], along);
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], along[k]);
      high[k] = std::max(high[k], along[k]);
    }
  }
  double farthest = request.Medium->FarLimit;
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    request.Compositor->Reduce(&farthest, 1, vtkGodRaysCompositor::GREATEST);
  }
  double seenLow[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double seenHigh[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  const auto see = [&](double x, double y, double depth)
  {
    double place[3];
    GetPlace(*request.View, x, y, depth, place);
    double along[3];
    GetAlong(axes, Eye, place, along);
    for (int k = 0; k < 2; ++k)
    {
      seenLow[k] = std::min(seenLow[k], along[k]);
      seenHigh[k] = std::max(seenHigh[k], along[k]);
    }
  };
  for (int i = 0; i < 4; ++i)
  {
    see(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0);
    see(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, farthest);
  }
  const double around = 1e-3 * (high[2] - low[2] + high[1] - low[1] + high[0] - low[0]) + 1e-30;
  double whole = 1.0;
  double seen = 1.0;
  for (int k = 0; k < 2; ++k)
  {
    whole *= high[k] - low[k];
    seenLow[k] = std::max(low[k], seenLow[k]);
    seenHigh[k] = std::min(high[k], seenHigh[k]);
    seen *= seenHigh[k] - seenLow[k];
    if (!(seenLow[k] - around < seenHigh[k] + around))
    {
      return; // no shadow is seen
    }
  }
  const bool fitsView = this->Levels > 1 || seen < 0.25 * whole;
  for (int k = 0; k < 2; ++k)
  {
    low[k] = (fitsView ? seenLow[k] : low[k]) - around;
    high[k] = (fitsView ? seenHigh[k] : high[k]) + around;
  }
  this->NumberOfFaces = 1;
  this->Grids.Range[0] = -high[2] - around;
  this->Grids.Range[1] = -low[2] + around;
  this->Texel = std::max(high[0] - low[0], high[1] - low[1]);
  this->SetFace(0, axes, Eye, low, high);
  this->Grids.Levels = 1;
  this->Nest(axes, low, high);
}

//------------------------------------------------------------------------------
// Finer faces, each of half of the one before about the axis through the eye. A face that the axis does
// not go through ends where the coarsest one does.
void vtkGodRaysShadowMap::Nest(const double axes[3][3], const double low[2], const double high[2])
{
  double share = 0.5;
  for (int level = 1; level < this->Levels; ++level, share *= 0.5)
  {
    double ends[2][2];
    for (int k = 0; k < 2; ++k)
    {
      ends[0][k] = low[k] < 0.0 ? share * low[k] : low[k];
      ends[1][k] = high[k] > 0.0 ? share * high[k] : high[k];
      if (!(ends[0][k] < ends[1][k]))
      {
        return;
      }
    }
    this->SetFace(level, axes, Eye, ends[0], ends[1]);
    this->NumberOfFaces = this->Grids.Levels = level + 1;
  }
}

//------------------------------------------------------------------------------
const vtkGodRaysShadowGrids& vtkGodRaysShadowMap::GetGrids()
{
  if (this->NumberOfFaces == 0)
  {
    this->Grids.Levels = 0;
    this->Grids.Layers = nullptr;
    this->Grids.NumberOfLayers = 0;
    this->Grids.Colored = false;
    return this->Grids;
  }
  if (this->Depths.empty())
  {
    this->Depths = this->Maps[this->NumberOfFaces / 6].ReadDepth();
  }
  const std::ptrdiff_t columns = this->GetColumns();
  for (int level = 0; level < this->Grids.Levels; ++level)
  {
    vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[level];
    grid.Stride = columns * this->Size;
    grid.First = (level / columns * grid.Stride + level % columns) * this->Size;
    grid.Depths = this->Depths.data() + grid.First;
  }
  this->Layers.Set(this->Grids);
  return this->Grids;
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMap::FitPoint(const vtkGodRaysMediumIntegrator::Request& request)
{
  const double* light = request.Light->Position;
  double center[3] = { 0.0, 0.0, 0.0 };
  double farthest = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      center[k] += 0.125 * this->Corners[i][k];
    }
    farthest =
      std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(light, this->Corners[i])));
  }
  double axes[3][3];
  double backwards[3];
  vtkMath::Subtract(light, center, backwards);
  if (!(vtkMath::Normalize(backwards) > 0.0))
  {
    backwards[2] = 1.0;
  }
  SetAxes(*request.View, backwards, axes);
  double tangents[2] = { 0.0, 0.0 };
  double nearest = farthest;
  for (int i = 0; i < 8; ++i)
  {
    double along[3];
    GetAlong(axes, light, this->Corners[i], along);
    nearest = std::min(nearest, -along[2]);
    for (int k = 0; k < 2; ++k)
    {
      tangents[k] = std::max(tangents[k], std::abs(along[k]) / std::max(-along[2], 1e-30));
    }
  }
  const double widest = std::sqrt(3.0); // the tangent of 60 degrees
  this->Grids.Range[1] = 1.001 * farthest;
  if (nearest > 0.0 && std::max(tangents[0], tangents[1]) < widest)
  {
    this->NumberOfFaces = 1;
    this->Grids.Range[0] = 0.999 * nearest;
    const double high[2] = { 1.001 * tangents[0] + 1e-6, 1.001 * tangents[1] + 1e-6 };
    const double low[2] = { -high[0], -high[1] };
    this->Texel = 2.0 * std::max(high[0], high[1]);
    this->SetFace(0, axes, light, low, high);
    this->Grids.Levels = 1;
    return;
  }
  this->NumberOfFaces = 6;
  this->Grids.Range[0] = 1e-4 * farthest;
  this->Texel = 2.0;
  for (int face = 0; face < 6; ++face)
  {
    double direction[3]; // backwards, along an axis of the world
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = request.View->WorldToView[4 * k + face / 2] * (face % 2 == 0 ? -1.0 : 1.0);
    }
    vtkMath::Normalize(direction);
    SetAxes(*request.View, direction, axes);
    const double low[2] = { -1.0, -1.0 };
    const double high[2] = { 1.0, 1.0 };
    this->SetFace(face, axes, light, low, high);
  }
  this->Grids.Levels = 6;
}

//------------------------------------------------------------------------------
// Between low and high across the light, or, for a point light, across it at distance 1.
void vtkGodRaysShadowMap::SetFace(int face, const double axes[3][3], const double origin[3],
  const double low[2], const double high[2])
{
  vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
  for (int k = 0; k < 2; ++k)
  {
    std::copy_n(axes[k], 3, grid.Axes[k]);
    grid.Low[k] = low[k];
    grid.Texel[k] = high[k] - low[k]; // of its one pixel as yet
  }
  std::transform(axes[2], axes[2] + 3, grid.Axes[2], std::negate<>());
  double* m = this->ViewToMap[face];
  double shift[3];
  for (int k = 0; k < 3; ++k)
  {
    shift[k] = -vtkMath::Dot(axes[k], origin);
  }
  const double nearest = this->Grids.Range[0];
  const double farthest = this->Grids.Range[1];
  const double depth = farthest - nearest;
  for (int column = 0; column < 4; ++column)
  {
    const auto along = [&](int k) { return column < 3 ? axes[k][column] : shift[k]; };
    const double one = column == 3 ? 1.0 : 0.0;
    const double w = this->Grids.Point ? -along(2) : one;
    for (int k = 0; k < 2; ++k)
    {
      m[4 * k + column] = (2.0 * along(k) - (low[k] + high[k]) * w) / (high[k] - low[k]);
    }
    m[8 + column] = this->Grids.Point
      ? ((farthest + nearest) * -along(2) - 2.0 * farthest * nearest * one) / depth
      : (-2.0 * along(2) - (farthest + nearest) * one) / depth;
    m[12 + column] = w;
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMap::Set(vtkShaderProgram* program) const
{
  program->SetUniformi("mapSize", this->Size);
  const float range[2] = { static_cast<float>(this->Grids.Range[0]),
    static_cast<float>(this->Grids.Range[1]) };
  program->SetUniform2f("mapRange", range);
  program->SetUniformf("texel", static_cast<float>(this->Texel));
  float matrices[6 * 16]; // columns first
  for (int face = 0; face < this->NumberOfFaces; ++face)
  {
    for (int i = 0; i < 16; ++i)
    {
      matrices[16 * face + i] = static_cast<float>(this->ViewToMap[face][4 * (i % 4) + i / 4]);
    }
  }
  program->SetUniformMatrix4x4v("toMap", this->NumberOfFaces, matrices);
  if (this->NumberOfFaces == 6)
  {
    float toCube[9]; // columns first
    for (int i = 0; i < 3; ++i)
    {
      const double* axis = this->Grids.Grids[2 * i].Axes[2];
      for (int k = 0; k < 3; ++k)
      {
        toCube[3 * k + i] = static_cast<float>(axis[k]);
      }
    }
    program->SetUniformMatrix3x3("toCube", toCube);
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysShadowMap::Release(vtkWindow* window)
{
  this->Drawn = State();
  this->Rest = State();
  this->RestMap.Release(window);
  this->Depths.clear();
  this->Layers.Clear();
  if (this->Peeler)
  {
    this->Peeler->ReleaseGraphicsResources(window);
    this->Peeler = nullptr;
  }
  this->Maps[0].Release(window);
  this->Maps[1].Release(window);
}
