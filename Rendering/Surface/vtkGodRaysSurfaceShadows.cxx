// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSurfaceShadows.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSceneSize.h"
#include "vtkGodRaysSurfaceShadowsFS.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysSurfaceShadows);

namespace
{
constexpr int LeastSize = 512; // of a map [pixels]
constexpr int MostSize = 4096;
constexpr double MostTexels =
  3 * 8192.0 * 4096.0; // of all lights, 384 MB: four cubes of the most size
constexpr int MostLevels = vtkGodRaysShadowGrids::MaximumLevels;
// Every driver has so many texture units, and VTK hands them out from 0 on. It is that of samplers without a
// texture: two kinds of samplers on one unit would have OpenGL refuse to draw.
constexpr int EmptyUnit = 47;

/// Returns whether a prop shows surfaces that may cast shadows. Points, lines, and the spheres and
/// tubes that stand for them, do not: they are so many pixels wide in a map as in the picture, or face
/// the eye in the picture and the light in the map, and would shadow themselves. Annotations lay
/// themselves out for the camera that draws them, and would for the light.
bool HasSurfaces(vtkProp* prop)
{
  auto actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper)
  {
    bool casts = prop->IsA("vtkLODProp3D");
    if (prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly"))
    {
      prop->InitPathTraversal();
      for (vtkAssemblyPath* path; !casts && (path = prop->GetNextPath());)
      {
        vtkProp* part = path->GetLastNode()->GetViewProp();
        casts = part != prop && part->GetVisibility() && HasSurfaces(part);
      }
    }
    return casts;
  }
  const int shape = mapper->IsA("vtkGlyph3DMapper") ? 1 : 0; // the input that has it
  auto data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(shape, 0));
  const bool isThin = actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper") ||
    mapper->IsA("vtkPointGaussianMapper") ||
    (data && data->GetNumberOfPolys() == 0 && data->GetNumberOfStrips() == 0);
  return !isThin;
}

/// Returns whether a mapper, or that of the prop for which it draws, colours by scalars.
bool IsColored(vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto drawing = vtkMapper::SafeDownCast(mapper);
  if (drawing && drawing->GetScalarVisibility() && drawing->GetColorMapColors())
  {
    return true;
  }
  auto actor = vtkActor::SafeDownCast(prop);
  vtkMapper* own = actor ? actor->GetMapper() : nullptr;
  vtkDataSet* data = own && own->GetScalarVisibility() ? own->GetInput() : nullptr;
  int ofCells = 0;
  return data &&
    vtkAbstractMapper::GetScalars(data, own->GetScalarMode(), own->GetArrayAccessMode(),
      own->GetArrayId(), own->GetArrayName(), ofCells);
}

/// Releases what is kept of a light.
template <typename Kept>
void Release(Kept& light, vtkWindow* window)
{
  for (vtkGodRaysShadowMap& map : light.Maps)
  {
    map.Release(window);
  }
}

/// Returns the tangent of a sun's angular radius, or the radius of a lamp's sphere. Where nobody has
/// given one, it is a fiftieth of the scene, but a tenth at most of how far the lamp is from where the
/// camera looks.
double GetRadius(const vtkGodRaysSurfaceShadows::Request& request, const vtkGodRaysLight& light)
{
  if (light.IsInfinite() || request.SourceRadius > 0.0)
  {
    return light.IsInfinite() ? std::tan(request.SunAngularRadius) : request.SourceRadius;
  }
  const double focus[3] = { 0.0, 0.0, request.Renderer->GetActiveCamera()->GetDistance() };
  return std::min(0.02 * request.Scene->GetDiagonal(),
    0.1 * std::sqrt(vtkMath::Distance2BetweenPoints(light.Position, focus)));
}

/// Returns from which distance on a lamp's map must see things. VTK projects them by matrices of single
/// precision: their rounding, of as much as the scene is away from the origin, is one of depths near
/// the lamp.
double FindNearest(const vtkGodRaysSurfaceShadows::Request& request)
{
  return std::min(6e-5 * request.Away, 0.02 * request.Diagonal);
}

void Replace(std::string& text, const std::string& what, const std::string& with)
{
  vtkShaderProgram::Substitute(text, what, with);
}
}

// A prop of several renderers has the pass of each, which name things apart.
std::string vtkGodRaysSurfaceShadows::GetName(vtkProp* prop, std::string text)
{
  const int passes = this->CountBefore(prop);
  if (passes > 0)
  {
    Replace(text, "godrays", "godrays" + std::to_string(passes));
    Replace(text, "GodRays", "GodRays" + std::to_string(passes));
  }
  return text;
}

void vtkGodRaysSurfaceShadows::FindLights(
  const Request& request, std::vector<vtkGodRaysLight>& lights)
{
  std::vector<vtkSmartPointer<vtkLight>>& shining = this->Shining;
  shining.clear();
  vtkLightCollection* all = request.Renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  while (vtkLight* light = all->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      shining.emplace_back(light);
    }
  }
  this->Finder.Renderer = request.Renderer;
  this->Finder.Compositor = request.Compositor;
  this->Finder.Scene = request.Scene;
  this->Finder.LightsMedium = true; // wherever they are: behind the eye, too
  this->Finder.Find(*request.View, shining, lights);
  const auto castsNone = [&](const vtkGodRaysLight& light)
  {
    return light.Number < 0 || shining[light.Number]->LightTypeIsHeadlight() ||
      std::find(request.WithoutShadows.begin(), request.WithoutShadows.end(),
        shining[light.Number]) != request.WithoutShadows.end();
  };
  lights.erase(std::remove_if(lights.begin(), lights.end(), castsNone), lights.end());
  std::stable_sort(lights.begin(), lights.end(),
    [&](const vtkGodRaysLight& one, const vtkGodRaysLight& other)
    { return shining[one.Number]->GetIntensity() > shining[other.Number]->GetIntensity(); });
  this->Standing = lights.size();
  this->Faults = this->Finder.GetFaults();
  if (this->Standing > MaximumLights)
  {
    lights.resize(MaximumLights);
    this->Faults.push_back("of all but the " + std::to_string(MaximumLights) + " strongest of " +
      std::to_string(this->Standing) + " lights: switch lights off, or make them headlights");
  }
}

// Volumes cast shadows, also where they are media and not drawn.
void vtkGodRaysSurfaceShadows::FindOccluders(const Request& request)
{
  vtkGodRaysOcclusionPass::Request sorting;
  sorting.Renderer = request.Renderer;
  sorting.UntaggedPropsOcclude = request.UntaggedPropsOcclude;
  sorting.LampsOcclude = false;
  sorting.Dims = true;
  this->Sorted.Sort(sorting);
  const std::vector<vtkProp*>& all = this->Sorted.OccludingProps;
  this->Occluders[0].clear();
  this->Occluders[1].clear();
  for (vtkProp* prop : all)
  {
    const bool hasSurfaces = HasSurfaces(prop);
    if (hasSurfaces && prop->HasOpaqueGeometry())
    {
      this->Occluders[0].push_back(prop);
    }
    if (vtkGodRaysVolumeHaze::GetVolume(prop) ||
      (hasSurfaces && prop->HasTranslucentPolygonalGeometry()))
    {
      this->Occluders[1].push_back(prop);
    }
  }
  // A volume has 16 layers, and no edges; and layers of many lights take much memory.
  this->LayerSize = this->Standing > 4 ||
      std::any_of(this->Occluders[1].begin(), this->Occluders[1].end(),
        [](vtkProp* prop) { return vtkGodRaysVolumeHaze::GetVolume(prop) != nullptr; })
    ? 512
    : 1024;
}

// The maps of what is opaque are parts of one texture, so that 8 lights need one texture unit of the mappers'
// shaders; that is made anew, with all maps, where lights come and go.
bool vtkGodRaysSurfaceShadows::DrawMaps(
  const Request& request, const std::vector<vtkGodRaysLight>& lights)
{
  vtkGodRaysMedium air;
  air.FarLimit = request.Renderer->GetActiveCamera()->GetClippingRange()[1];
  vtkGodRaysMediumIntegrator::Request scene;
  scene.Window = request.Window;
  scene.Renderer = request.Renderer;
  scene.Medium = &air;
  scene.View = request.View;
  scene.Compositor = request.Compositor;
  scene.Nearest = FindNearest(request);
  scene.Focus = request.Renderer->GetActiveCamera()->GetDistance();
  scene.Overlap = 0.14; // which the samples of a soft shadow reach, at most 0.06 of a face
  // Texels about half as wide as pixels, where map and picture show the same; wider ones of many lights.
  int size = LeastSize;
  const double pixels = request.Tiles * std::max(request.Size[0], request.Size[1]);
  while (size < std::min<double>(2.0 * pixels, MostSize))
  {
    size *= 2;
  }
  const int most = vtkTextureObject::GetMaximumTextureSize(request.Window);
  const bool hasLamp = std::any_of(
    lights.begin(), lights.end(), [](const vtkGodRaysLight& light) { return !light.IsInfinite(); });
  const double count = std::max<double>(lights.size(), 1);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = static_cast<int>(std::ceil(count / columns));
  const double wide = columns * (hasLamp ? 1.5 : 1.0); // a cube has 3 x 2 faces of half the size
  while (size > LeastSize &&
    (std::max<double>(wide, rows) * size > most || wide * rows * size * size > MostTexels))
  {
    size /= 2;
  }
  const int width = hasLamp ? size / 2 * 3 : size;
  const unsigned int version = this->Atlas.GetVersion();
  this->Atlas.Prepare(request.Window, columns * width, rows * size, { 0, GL_DEPTH_COMPONENT32F });
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    Kept& kept = this->Lights[i];
    scene.Light = &lights[i];
    vtkGodRaysShadowMap& opaque = kept.Maps[0];
    if (version != this->Atlas.GetVersion())
    {
      opaque.Release(request.Window);
    }
    const int place = static_cast<int>(i);
    kept.Parts[0] = { place % columns * width, place / columns * size };
    scene.Occluders = &this->Occluders[0];
    scene.Share = FindShare(request, scene, size, opaque.GetNumberOfFaces() > 1);
    if (!opaque.Draw(scene, lights[i].IsInfinite() ? size : size / 2,
          scene.Share < 1.0 ? MostLevels : 1, this->Atlas.GetDepth(), kept.Parts[0].data()))
    {
      return false;
    }
    scene.Occluders = &this->Occluders[1]; // layers are many, and smooth
    scene.Share = 1.0;
    if (!kept.Maps[1].Draw(
          scene, lights[i].IsInfinite() ? this->LayerSize : this->LayerSize / 2, 1))
    {
      return false;
    }
    for (const vtkGodRaysShadowMap& map : kept.Maps)
    {
      this->Drawn += map.GetNumberOfFaces() == 0 || map.WasKept() ? 0 : 1;
    }
  }
  return this->WriteLayers(request.Window, most);
}

// One map about all occluders serves while the camera moves. Where its texels are more than twice as wide
// as pixels are where the camera looks, maps are nested about the eye, and the finest reaches past there.
// Returns what share each is of the one before; 1 if one serves.
double vtkGodRaysSurfaceShadows::FindShare(
  const Request& request, const vtkGodRaysMediumIntegrator::Request& scene, int size, bool isNested)
{
  vtkGodRaysView::Pinhole pinhole;
  if (!scene.Light->IsInfinite() || scene.View->Parallel ||
    !scene.View->GetPinhole(request.Size, pinhole))
  {
    return 1.0;
  }
  vtkGodRaysShadowFaces whole;
  whole.Fit(scene, size, 1);
  const double* texels = whole.Grids.Grids[0].Texel;
  const double texel = std::max(texels[0], texels[1]);
  const double distance = scene.Renderer->GetActiveCamera()->GetDistance();
  // fewer for maps that are nested, so that no shader is built time and again while a camera moves
  const double most = isNested ? 1.7 : 2.0;
  if (whole.Count == 0 || texel <= most * pinhole.PixelSize * distance)
  {
    return 1.0;
  }
  // of the whole: from before the eye past there, or a few times as wide as a narrow picture is there
  const double seen = pinhole.PixelSize * std::max(request.Size[0], request.Size[1]);
  const double finest = std::min(1.8, 2.5 * seen) * distance / (texel * size);
  const double share = std::pow(finest, 1.0 / (MostLevels - 1));
  // One of few shares, so that maps stay while the camera comes nearer.
  return std::min(0.5, std::exp2(0.125 * std::ceil(8.0 * std::log2(std::max(share, 0.05)))));
}

// Writes the shaders' numbers of a light and of its two maps; see vtkGodRaysSurfaceShadowsFS.glsl.
void vtkGodRaysSurfaceShadows::Describe(
  const Request& request, const vtkGodRaysLight& light, const Kept& kept, std::size_t first)
{
  // A direction has length 1 also where a camera's model transform scales it.
  const double* from = light.IsInfinite() ? light.Direction : light.Position;
  const double view[4] = { from[0], from[1], from[2], light.IsInfinite() ? 0.0 : 1.0 };
  double toCamera[16];
  double place[4];
  vtkMatrix4x4::Invert(request.View->CameraToView, toCamera);
  vtkMatrix4x4::MultiplyPoint(toCamera, view, place);
  std::copy_n(place, 4, this->Numbers.Light + 2 * first);
  for (int kind = 0; kind < 2; ++kind)
  {
    const vtkGodRaysShadowFaces& faces = kept.Maps[kind].GetFaces();
    const vtkGodRaysShadowGrids& grids = faces.Grids;
    const std::size_t map = first + kind;
    const double depth = 1.0 / (grids.Range[1] - grids.Range[0]);
    float* toMap = this->Numbers.ToMap + 16 * map;
    for (int row = 0; row < 3; ++row)
    {
      // The cube's axes are those along which its faces look.
      const double* axis =
        faces.Count == 6 && grids.Point ? grids.Grids[2 * row].Axes[2] : grids.Grids[0].Axes[row];
      const double scale = row == 2 && !grids.Point ? depth : 1.0;
      for (int column = 0; column < 4; ++column)
      {
        double along = column == 3 && row == 2 && !grids.Point ? -grids.Range[0] : 0.0;
        for (int k = 0; k < 3; ++k)
        {
          along += axis[k] * request.View->CameraToView[4 * k + column];
        }
        // a lamp's are from its place, which shaders take off
        toMap[4 * column + row] =
          static_cast<float>(column == 3 && grids.Point ? 0.0 : scale * along);
      }
    }
    for (int k = 0; k < MostLevels; ++k)
    {
      const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[k];
      for (int i = 0; i < 2; ++i)
      {
        const bool isThere = k < faces.Count;
        float* face = this->Numbers.Faces + 4 * (MostLevels * map + k) + i;
        face[0] = static_cast<float>(isThere ? 1.0 / grid.Texel[i] : 0.0);
        face[2] = static_cast<float>(isThere ? -grid.Low[i] / grid.Texel[i] : -1.0);
      }
    }
    const std::array<int, 4>& part = kept.Parts[kind];
    const double blocks[4] = { part[0] + 0.0, part[1] + 0.0, faces.Size + 0.0,
      part[3] / std::max(faces.GetRows() * faces.Size, 1) + 0.0 };
    // Window depth is affine in the distance, or in 1/distance of a lamp, whose texels widen with it.
    const double depths[4] = { grids.Range[1] * depth,
      grids.Point ? grids.Range[0] * grids.Range[1] * depth : depth, 2e-7 * request.Away,
      GetRadius(request, light) };
    std::copy_n(blocks, 4, this->Numbers.Blocks + 4 * map);
    std::copy_n(depths, 4, this->Numbers.Depths + 4 * map);
  }
}

// Where the widest penumbra is no wider than a pixel a hard shadow is as good; half a pixel for one that is
// soft, so that no shader is built time and again while a camera moves.
bool vtkGodRaysSurfaceShadows::IsSoft(
  const Request& request, const vtkGodRaysLight& light, const vtkGodRaysShadowFaces& faces) const
{
  vtkGodRaysView::Pinhole pinhole;
  const double radius = GetRadius(request, light);
  if (!request.Soft || !(radius > 0.0) || !request.View->GetPinhole(request.Size, pinhole))
  {
    return false;
  }
  const double depth = faces.Grids.Range[1] - faces.Grids.Range[0];
  const double width = 2.0 * radius * (light.IsInfinite() ? depth : 1.0);
  double nearest =
    request.View->Parallel ? 1.0 : VTK_DOUBLE_MAX; // of the occluders' middle and corners
  double middle = 0.0;
  for (const double* corner : faces.Corners)
  {
    middle += 0.125 * corner[2];
    nearest = request.View->Parallel || corner[2] <= 0.0 ? nearest : std::min(nearest, corner[2]);
  }
  const double distance = request.View->Parallel ? 1.0
    : middle > 0.0                               ? std::min(nearest, middle)
                                                 : 0.0;
  const bool was = std::any_of(this->Shaders.begin(), this->Shaders.end(),
    [&](const Text& text) { return text.Number == light.Number && text.IsSoft; });
  return width > (was ? 0.5 : 1.0) * pinhole.PixelSize * distance;
}

// The layers of all lights' maps as one texture: lights side by side, layers one on another, each texel its
// depth and what is dark beyond.
bool vtkGodRaysSurfaceShadows::WriteLayers(vtkOpenGLRenderWindow* window, int most)
{
  int sides[2] = { 0, 0 };
  for (Kept& kept : this->Lights)
  {
    vtkGodRaysShadowMap& map = kept.Maps[1];
    std::array<int, 4> part = {};
    if (map.GetNumberOfFaces() > 0 && map.HasLayers())
    {
      const int rows = map.GetFaces().GetRows() * map.GetFaces().Size;
      part = { sides[0], 0, map.GetFaces().GetColumns() * map.GetFaces().Size,
        rows * std::min(map.GetGrids().NumberOfLayers, most / rows) };
      sides[0] += part[2];
      sides[1] = std::max(sides[1], part[3]);
    }
    kept.Version = part == kept.Parts[1] ? kept.Version : 0;
    kept.Parts[1] = part;
  }
  if (sides[0] == 0)
  {
    this->Layers.Release(window);
    return true;
  }
  const unsigned int version = this->Layers.GetVersion();
  this->Layers.Prepare(window, sides[0], sides[1], { GL_RGBA32F, 0 });
  const bool isNew = version != this->Layers.GetVersion();
  if (isNew && !this->Layers.Bind())
  {
    this->Layers.Release(window);
    return false;
  }
  for (Kept& kept : this->Lights)
  {
    const std::array<int, 4>& part = kept.Parts[1];
    if (part[2] == 0 || (!isNew && kept.Version == kept.Maps[1].GetGrids().Version))
    {
      continue;
    }
    const vtkGodRaysShadowGrids& grids = kept.Maps[1].GetGrids();
    const std::size_t texels = static_cast<std::size_t>(part[2]) *
      kept.Maps[1].GetFaces().GetRows() * kept.Maps[1].GetFaces().Size;
    this->Texels.resize(4 * static_cast<std::size_t>(part[2]) * part[3]);
    for (std::size_t at = 0; at < this->Texels.size(); at += 4)
    {
      const vtkGodRaysShadowGrids::Layer& layer = grids.Layers[at / 4 / texels];
      const std::size_t i = at / 4 % texels;
      this->Texels[at] = layer.Depths[i];
      for (int c = 0; c < 3; ++c)
      {
        this->Texels[at + 1 + c] = layer.Dark[c][i];
      }
    }
    this->Layers.Write(GL_RGBA, GL_FLOAT, this->Texels.data(), part.data());
    kept.Version = grids.Version;
  }
  return true;
}

void vtkGodRaysSurfaceShadows::SetMedium(const Request& request)
{
  const vtkGodRaysMedium medium = request.Medium ? *request.Medium : vtkGodRaysMedium();
  for (int i = 0; i < 4; ++i)
  {
    this->Vertical[i] = static_cast<float>(i == 3 ? medium.EyeHeight
        : i == 2                                  ? -medium.Up[2]
                                                  : medium.Up[i]);
    for (int k = 0; k < 2; ++k)
    {
      const vtkGodRaysMedium::Component& component = medium.Components[k];
      this->Air[4 * k + i] = static_cast<float>(k >= medium.NumberOfComponents ? 0.0
          : i == 3 ? component.ScaleHeight
                   : component.Scattering[i] + component.Absorption[i]);
    }
  }
  this->Planet = static_cast<float>(medium.PlanetRadius);
}

bool vtkGodRaysSurfaceShadows::Begin(const Request& request)
{
  this->End();
  this->MostDataShadow = request.MostDataShadow;
  this->TakeProps(request.Renderer->GetViewProps());
  this->Built = 0;
  this->Drawn = 0;
  // Lights as the scene has them: mappers are built for their number and kinds.
  this->UpdateLightGeometry(request.Renderer);
  this->UpdateLights(request.Renderer);
  std::vector<vtkGodRaysLight> lights;
  this->FindLights(request, lights);
  this->FindOccluders(request);
  this->SetMedium(request);
  for (; this->Lights.size() > lights.size(); this->Lights.pop_back())
  {
    Release(this->Lights.back(), request.Window);
  }
  while (this->Lights.size() < lights.size())
  {
    this->Lights.emplace_back();
  }
  const bool done = this->DrawMaps(request, lights);
  std::vector<Text> shaders;
  for (std::size_t i = 0; i < lights.size() && done; ++i)
  {
    const Kept& kept = this->Lights[i];
    const bool isLamp = !lights[i].IsInfinite();
    const int faces[2] = { kept.Maps[0].GetNumberOfFaces(),
      kept.Parts[1][2] > 0 ? kept.Maps[1].GetNumberOfFaces() : 0 };
    // A light that has the colour below the air is dimmed already.
    double above[3];
    const bool isDimmed = request.Medium && (isLamp || request.Medium->HasExponentialDensity()) &&
      !vtkGodRaysGetLightAboveAir(this->Shining[lights[i].Number], above);
    if (faces[0] + faces[1] > 0 || isDimmed) // else nothing takes of it
    {
      this->Describe(request, lights[i], kept, 2 * shaders.size());
      // Nested maps are as many always, so that shaders stay; those that are not there have no place.
      shaders.push_back(
        { lights[i].Number, { !isLamp && faces[0] > 1 ? MostLevels : faces[0], faces[1] },
          faces[0] > 0 && this->IsSoft(request, lights[i], kept.Maps[0].GetFaces()), isLamp,
          isDimmed });
    }
  }
  if (shaders != this->Shaders)
  {
    this->Shaders = shaders;
    this->Stage.Modified();
  }
  return done;
}

void vtkGodRaysSurfaceShadows::SetActive(bool active)
{
  for (vtkTextureObject* texture : { this->Atlas.GetDepth(), this->Layers.GetColor() })
  {
    if (texture && !active)
    {
      texture->Deactivate();
    }
  }
  this->Active = active;
}

void vtkGodRaysSurfaceShadows::End()
{
  this->SetActive(false);
  this->Shining.clear(); // lights may be deleted between frames
}

// Marks of our own: mappers fill in their tags and leave these.
bool vtkGodRaysSurfaceShadows::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  // The first of each alone: users' replacements may repeat a tag.
  const auto mark = [&](const std::string& tag, const std::string& with)
  { vtkShaderProgram::Substitute(fragmentShader, tag, this->GetName(prop, with), false); };
  mark("//VTK::Light::Dec", "//VTK::Light::Dec\n//VTK::GodRays::Dec\n");
  mark("//VTK::UniformFlow::Impl", "//VTK::UniformFlow::Impl\n//VTK::GodRays::Flow\n");
  mark("//VTK::Light::Impl", "//VTK::GodRays::Impl\n//VTK::Light::Impl");
  return true;
}

bool vtkGodRaysSurfaceShadows::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  ++this->Built;
  const auto has = [&](const std::string& text)
  { return fragmentShader.find(text) != std::string::npos; };
  std::string lights;
  std::string colors;
  int discs = 0;
  // Physically based shading is in linear light, other shading of VTK in display values.
  const bool isLinear = has("1.0/2.2");
  const bool hasPlace = has("vec4 vertexVC = ") && has(this->GetName(prop, "//VTK::GodRays::Impl"));
  for (std::size_t i = 0; i < this->Shaders.size() && hasPlace; ++i)
  {
    const Text& light = this->Shaders[i];
    const std::string number = std::to_string(light.Number);
    if (!has("uniform vec3 lightColor" + number + ";"))
    {
      continue; // this mapper does not shade with it
    }
    const int disc = light.IsSoft ? discs++ : -1;
    const std::string left = "godraysLeft" + number;
    lights += "  vec3 " + left + " = GodRaysLeft(";
    for (const int value : { static_cast<int>(i), light.Faces[0], light.Faces[1], disc })
    {
      lights += std::to_string(value) + ", ";
    }
    for (const bool is : { light.IsLamp, light.IsDimmed, isLinear })
    {
      lights += is ? "true, " : "false, ";
    }
    lights += "vertexVC.xyz, godraysNormal);\n";
    const std::string seen = disc >= 0 ? " * godraysSeen[" + std::to_string(disc) + "]" : "";
    colors += "  vec3 godraysColor" + number + " = lightColor" + number +
      " * (1.0 - godraysMost * (1.0 - " + left + seen + "));\n#undef lightColor" + number +
      "\n#define lightColor" + number + " godraysColor" + number + "\n";
  }
  if (lights.empty())
  {
    auto actor = vtkActor::SafeDownCast(prop);
    if (!this->Shaders.empty() && (!actor || actor->GetProperty()->GetLighting()))
    {
      this->WithoutLights.insert(mapper->GetClassName());
    }
    return true;
  }
  // Spheres and tubes that stand for points and lines move vertexVC later on: their normal is the drawn one.
  const std::size_t first = fragmentShader.find("vec4 vertexVC = ");
  const bool isImpostor = fragmentShader.find("vertexVC =", first + 16) != std::string::npos ||
    has("vertexVC.xyz =") || has("tubeBasis1");
  std::string declarations = vtkGodRaysSurfaceShadowsFS;
  Replace(declarations, "LIGHTS", std::to_string(this->Shaders.size()));
  Replace(declarations, "DIMMED",
    std::any_of(
      this->Shaders.begin(), this->Shaders.end(), [](const Text& light) { return light.IsDimmed; })
      ? "1"
      : "0");
  if (declarations != this->Declarations)
  {
    this->Declarations = declarations;
    this->Included = vtkGodRaysQuad::Include(declarations);
  }
  const auto fill = [&](const char* mark, const std::string& with)
  { Replace(fragmentShader, this->GetName(prop, mark), this->GetName(prop, with)); };
  fill("//VTK::GodRays::Dec", this->Included);
  fill("//VTK::GodRays::Flow",
    isImpostor ? "" : "  vec3 godraysFacet = GodRaysFacet(vertexVC.xyz, cameraParallel == 1);\n");
  fill("//VTK::GodRays::Impl",
    std::string("  vec3 godraysNormal = ") + (isImpostor ? "normalVCVSOutput" : "godraysFacet") +
      ";\n" + lights + (discs > 0 ? "  GodRaysSample(" + std::to_string(discs) + ");\n" : "") +
      colors);
  return true;
}

bool vtkGodRaysSurfaceShadows::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  const auto name = [&](const char* text) { return this->GetName(prop, text); };
  if (!program->IsUniformUsed(name("godraysMost").c_str()))
  {
    return true;
  }
  const double most = IsColored(mapper, prop) ? this->MostDataShadow : 1.0;
  program->SetUniformf(name("godraysMost").c_str(), static_cast<float>(this->Active ? most : 0.0));
  program->SetUniform4f(name("godraysVertical").c_str(), this->Vertical);
  program->SetUniformf(name("godraysPlanet").c_str(), this->Planet);
  const int lights = static_cast<int>(this->Shaders.size());
  const auto set = [&](const char* text, int count, const float* values)
  { program->SetUniform4fv(name(text).c_str(), count, values); };
  set("godraysAir", 2, this->Air);
  set("godraysLight", lights, this->Numbers.Light);
  set("godraysFaces", 2 * MostLevels * lights, this->Numbers.Faces);
  set("godraysBlocks", 2 * lights, this->Numbers.Blocks);
  set("godraysDepths", 2 * lights, this->Numbers.Depths);
  // VTK 9.1 takes matrices as if it wrote to them
  program->SetUniformMatrix4x4v(name("godraysToMap").c_str(), 2 * lights, this->Numbers.ToMap);
  // Bound again for each prop, as passes between, such as vtkEDLShading, bind theirs to the unit.
  const auto bind = [&](const char* text, vtkTextureObject* texture)
  {
    const bool binds = this->Active && texture;
    if (binds)
    {
      texture->Activate();
    }
    program->SetUniformi(name(text).c_str(), binds ? texture->GetTextureUnit() : EmptyUnit);
  };
  bind("godraysOpaque", this->Atlas.GetDepth());
  bind("godraysLayers", this->Layers.GetColor());
  return true;
}

std::string vtkGodRaysSurfaceShadows::Describe() const
{
  std::ostringstream text;
  text << "surfaces: shadows of " << this->Shaders.size() << " of " << this->Shining.size()
       << " lights, " << this->Drawn << " maps drawn, " << this->Built << " shaders built";
  for (const std::string& mapper : this->WithoutLights)
  {
    text << (mapper == *this->WithoutLights.begin() ? "; none on what has no lights of VTK's: "
                                                    : ", ")
         << mapper;
  }
  return text.str();
}

void vtkGodRaysSurfaceShadows::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Remove();
  for (Kept& light : this->Lights)
  {
    Release(light, window);
  }
  this->Lights.clear();
  this->WithoutLights.clear();
  this->Atlas.Release(window);
  this->Layers.Release(window);
}
