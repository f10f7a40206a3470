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
#include "vtkGodRaysSurfaceAirFS.h"
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
#include "vtkRenderState.h"
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
constexpr int MostLevels = vtkGodRaysShadowGrids::MaximumLevels;

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
  light.Layers.Release(window);
}

/// Returns the name of a light's map in shaders.
std::string GetName(const std::string& light, int kind)
{
  return light + (kind == 0 ? "Opaque" : "Layers");
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
  return std::min(0.02 * request.Diagonal,
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

vtkGodRaysSurfaceShadows::vtkGodRaysSurfaceShadows()
{
  this->SetActiveDrawBuffers(1);
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
  lights.resize(std::min(lights.size(), MaximumLights));
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
  // A volume has 16 layers, and no edges.
  this->LayerSize =
    std::any_of(this->Occluders[1].begin(), this->Occluders[1].end(),
      [](vtkProp* prop) { return vtkGodRaysVolumeHaze::GetVolume(prop) != nullptr; })
    ? 512
    : 1024;
}

bool vtkGodRaysSurfaceShadows::DrawMaps(
  const Request& request, const vtkGodRaysLight& light, Kept& kept)
{
  vtkGodRaysMedium air;
  air.FarLimit = request.Renderer->GetActiveCamera()->GetClippingRange()[1];
  vtkGodRaysMediumIntegrator::Request scene;
  scene.Window = request.Window;
  scene.Renderer = request.Renderer;
  scene.Medium = &air;
  scene.View = request.View;
  scene.Light = &light;
  scene.Compositor = request.Compositor;
  scene.Nearest = FindNearest(request);
  scene.Focus = request.Renderer->GetActiveCamera()->GetDistance();
  scene.Overlap = 0.14; // which the samples of a soft shadow reach, at most 0.06 of a face
  Caster caster;
  caster.Number = light.Number;
  // A direction has length 1 also where a camera's model transform scales it.
  const double* place = light.IsInfinite() ? light.Direction : light.Position;
  for (int i = 0; i < 3; ++i)
  {
    caster.Light[i] = static_cast<float>(i == 2 ? -place[2] : place[i]);
  }
  caster.Light[3] = light.IsInfinite() ? 0.0f : 1.0f;
  // A light that has the colour below the air is dimmed already.
  double above[3];
  caster.Dimmed = request.Medium &&
    (!light.IsInfinite() || request.Medium->HasExponentialDensity()) &&
    !vtkGodRaysGetLightAboveAir(this->Shining[light.Number], above);
  for (int kind = 0; kind < 2; ++kind)
  {
    // Texels about half as wide as pixels, where map and picture show the same; layers are many, and smooth.
    int size = LeastSize;
    const double pixels = request.Tiles * std::max(request.Size[0], request.Size[1]);
    while (size < std::min<double>(2.0 * pixels, MostSize))
    {
      size *= 2;
    }
    size = kind == 1 ? this->LayerSize : size;
    scene.Occluders = &this->Occluders[kind];
    vtkGodRaysShadowMap& map = kept.Maps[kind];
    scene.Share = kind == 0 ? FindShare(request, scene, size, map.GetNumberOfFaces() > 1) : 1.0;
    if (!map.Draw(scene, light.IsInfinite() ? size : size / 2, scene.Share < 1.0 ? MostLevels : 1))
    {
      return false;
    }
    this->Drawn += map.GetNumberOfFaces() == 0 || map.WasKept() ? 0 : 1;
    Describe(map, request, caster.Maps[kind]);
  }
  if (caster.Maps[0].Faces > 0 && this->IsSoft(request, light, kept.Maps[0].GetFaces()))
  {
    // Seen from a place, a blocker moves by this much of the map for each unit of depth between the two, as
    // the eye goes from the light's middle to its rim: depth is affine in the distance, or in one over it.
    const vtkGodRaysShadowGrids& grids = kept.Maps[0].GetFaces().Grids;
    const double depth = grids.Range[1] - grids.Range[0];
    for (int i = 0; i < 2; ++i)
    {
      caster.Maps[0].Unit[1 + i] = static_cast<float>(GetRadius(request, light) * depth /
        (grids.Point ? grids.Range[0] * grids.Range[1] * grids.Grids[0].Texel[i] : 1.0));
    }
  }
  if (!this->WriteLayers(request.Window, kept, caster.Maps[1]))
  {
    return false;
  }
  if (caster.Maps[0].Faces + caster.Maps[1].Faces > 0 || caster.Dimmed) // else nothing takes of it
  {
    this->Casting.push_back(caster);
  }
  return true;
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

void vtkGodRaysSurfaceShadows::Describe(
  const vtkGodRaysShadowMap& map, const Request& request, Map& shaders)
{
  const vtkGodRaysShadowFaces& faces = map.GetFaces();
  shaders.Faces = faces.Count;
  if (faces.Count == 0)
  {
    return;
  }
  shaders.Texture = map.GetDepth();
  const vtkGodRaysShadowGrids& grids = faces.Grids;
  const double depth = grids.Range[1] - grids.Range[0];
  shaders.Texels[0] = static_cast<float>(faces.Size);
  shaders.Texels[1] = static_cast<float>(faces.GetColumns());
  shaders.Texels[3] = static_cast<float>(grids.Point ? 2e-7 * request.Away : 0.0);
  // Window depth is affine in the distance, or in 1/distance of a lamp, whose texels widen with it.
  const double texel = std::max(grids.Grids[0].Texel[0], grids.Grids[0].Texel[1]);
  shaders.Unit[0] =
    static_cast<float>((grids.Point ? texel * grids.Range[0] * grids.Range[1] : 1.0) / depth);
  if (!grids.Point && faces.Count > 1)
  {
    shaders.Faces =
      MostLevels; // always, so that shaders stay; those that are not there have no place
    std::fill(std::begin(shaders.ToFace), std::end(shaders.ToFace), 0.0f);
    std::fill(std::begin(shaders.ToPlane), std::end(shaders.ToPlane), 0.0f);
  }
  for (int face = 0; face < faces.Count; ++face)
  {
    double clip[16];
    double toFace[16];
    vtkMatrix4x4::Multiply4x4(faces.ViewToMap[face], request.View->CameraToView, clip);
    for (int column = 0; column < 4; ++column)
    {
      const double w = clip[12 + column];
      toFace[column] = 0.5 * faces.Size * (clip[column] + w);
      toFace[4 + column] = 0.5 * faces.Size * (clip[4 + column] + w);
      toFace[8 + column] = 0.5 * (clip[8 + column] + w);
      toFace[12 + column] = w;
    }
    double inverse[16];
    vtkMatrix4x4::Invert(toFace, inverse);
    std::copy_n(inverse, 16, shaders.ToPlane + static_cast<std::ptrdiff_t>(16) * face);
    vtkMatrix4x4::Transpose(toFace, toFace);
    std::copy_n(toFace, 16, shaders.ToFace + static_cast<std::ptrdiff_t>(16) * face);
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

// The layers of a map as a texture: one on another, each texel its depth and what is dark beyond.
bool vtkGodRaysSurfaceShadows::WriteLayers(vtkOpenGLRenderWindow* window, Kept& kept, Map& shaders)
{
  const vtkGodRaysShadowMap& map = kept.Maps[1];
  if (shaders.Faces == 0 || !map.HasLayers())
  {
    shaders.Faces = 0;
    kept.Layers.Release(window);
    kept.Version = 0;
    return true;
  }
  const vtkGodRaysShadowGrids& grids = kept.Maps[1].GetGrids();
  const int width = map.GetFaces().GetColumns() * map.GetFaces().Size;
  const int rows = map.GetFaces().GetRows() * map.GetFaces().Size;
  const int layers = std::min(
    grids.NumberOfLayers, static_cast<int>(vtkTextureObject::GetMaximumTextureSize(window)) / rows);
  shaders.Texels[2] = static_cast<float>(layers);
  if (kept.Version != grids.Version)
  {
    const std::size_t texels = static_cast<std::size_t>(width) * rows;
    this->Texels.resize(4 * texels * layers);
    float* to = this->Texels.data();
    for (int k = 0; k < layers; ++k)
    {
      const vtkGodRaysShadowGrids::Layer& layer = grids.Layers[k];
      for (std::size_t i = 0; i < texels; ++i, to += 4)
      {
        to[0] = layer.Depths[i];
        for (int c = 0; c < 3; ++c)
        {
          to[1 + c] = layer.Dark[c][i];
        }
      }
    }
    kept.Layers.Prepare(window, width, rows * layers, { GL_RGBA32F, 0 });
    if (!kept.Layers.Bind())
    {
      return false;
    }
    kept.Layers.WriteColor(this->Texels);
    kept.Version = grids.Version;
  }
  shaders.Texture = kept.Layers.GetColor();
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

// All visible props have this pass, also those that are culled: they would be built anew when they come into
// view.
void vtkGodRaysSurfaceShadows::SetProps(bool on)
{
  vtkRenderState state(this->Renderer);
  state.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  on ? this->PreRender(&state) : this->PostRender(&state);
}

bool vtkGodRaysSurfaceShadows::Begin(const Request& request)
{
  this->End();
  this->Nothing.Prepare(request.Window, 1, 1, { GL_RGBA8, 0 });
  this->Renderer = request.Renderer;
  this->MostDataShadow = request.MostDataShadow;
  this->Props.clear();
  vtkPropCollection* props = request.Renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop->GetVisibility())
    {
      this->Props.push_back(prop);
    }
  }
  this->SetProps(true);
  this->Built = 0;
  this->Drawn = 0;
  this->Casting.clear();
  // Lights as the scene has them: mappers are built for their number and kinds.
  this->UpdateLightGeometry(request.Renderer);
  this->UpdateLights(request.Renderer);
  this->FindOccluders(request);
  this->SetMedium(request);
  std::vector<vtkGodRaysLight> lights;
  this->FindLights(request, lights);
  for (; this->Lights.size() > lights.size(); this->Lights.pop_back())
  {
    Release(this->Lights.back(), request.Window);
  }
  bool done = true;
  for (std::size_t i = 0; i < lights.size() && done; ++i)
  {
    if (i == this->Lights.size())
    {
      this->Lights.emplace_back();
    }
    done = this->DrawMaps(request, lights[i], this->Lights[i]);
  }
  if (!done)
  {
    this->Casting.clear();
  }
  std::vector<Text> shaders;
  for (const Caster& caster : this->Casting)
  {
    shaders.push_back({ caster.Number, { caster.Maps[0].Faces, caster.Maps[1].Faces },
      caster.Maps[0].Unit[1] > 0.0f, caster.Light[3] > 0.0f, caster.Dimmed });
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
  if (this->Active && !active)
  {
    for (const Caster& caster : this->Casting)
    {
      for (const Map& map : caster.Maps)
      {
        if (map.Faces > 0)
        {
          map.Texture->Deactivate();
        }
      }
    }
  }
  this->Active = active;
}

void vtkGodRaysSurfaceShadows::End()
{
  if (this->Props.empty())
  {
    return;
  }
  this->SetActive(false);
  this->SetProps(false);
  this->Props.clear();
  this->Shining.clear(); // lights may be deleted between frames
  this->Nothing.GetColor()->Deactivate();
}

// Marks of our own: mappers fill in their tags and leave these.
bool vtkGodRaysSurfaceShadows::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  // The first of each alone: users' replacements may repeat a tag.
  const auto mark = [&](const std::string& tag, const std::string& with)
  { vtkShaderProgram::Substitute(fragmentShader, tag, with, false); };
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
  std::string declarations = "uniform float godraysMost;\n"; // part of a light that shadows take
  std::string lights;
  bool isDimmed = false;
  // Physically based shading is in linear light, other shading of VTK in display values.
  const bool isLinear = has("1.0/2.2");
  const bool hasPlace = has("vec4 vertexVC = ") && has("//VTK::GodRays::Impl");
  for (const Text& light : this->Shaders)
  {
    const std::string number = std::to_string(light.Number);
    if (!hasPlace || !has("uniform vec3 lightColor" + number + ";"))
    {
      continue; // this mapper does not shade with it
    }
    const std::string color = "godraysColor" + number;
    const std::string toLight = "godraysLight" + number;
    declarations += "uniform vec4 " + toLight + ";\n"; // its place (w = 1), or the direction to it
    lights += "  vec3 " + color + " = lightColor" + number + ";\n" +
      "  if (godraysMost > 0.0)\n"
      "  {\n"
      "    vec3 toLight = " +
      toLight + ".xyz - " + toLight +
      ".w * vertexVC.xyz;\n"
      // a facet that is turned away hides the light; the map would tell by chance
      "    vec3 through = vec3(0.0);\n"
      "    if (dot(godraysNormal, toLight) > 0.0)\n"
      "    {\n"
      "      through = vec3(1.0);\n"
      "      vec3 left = vec3(1.0);\n"; // of linear light
    if (light.IsDimmed)
    {
      isDimmed = true;
      lights += "      left = GodRaysAir(vertexVC.xyz, " + toLight + ");\n";
    }
    for (int kind = 0; kind < 2; ++kind)
    {
      if (light.Faces[kind] > 0)
      {
        const std::string name = GetName(number, kind);
        std::string map = vtkGodRaysSurfaceShadowsFS;
        Replace(map, "NAME", name);
        Replace(map, "FACES", std::to_string(light.Faces[kind]));
        Replace(map, "SOFT", kind == 0 && light.IsSoft ? "true" : "false");
        Replace(map, "LAMP", light.IsLamp ? "true" : "false");
        Replace(map, "LAYERED", kind == 0 ? "false" : "true");
        declarations += map;
        lights += std::string("      ") + (kind == 0 ? "through" : "left") + " *= GodRaysThrough" +
          name + "(vertexVC.xyz, godraysNormal, toLight);\n";
      }
    }
    if (light.Faces[1] > 0 || light.IsDimmed)
    {
      lights += isLinear ? "      through *= left;\n" : "      through *= EncodeDisplay(left);\n";
    }
    lights += "    }\n    " + color + " *= 1.0 - godraysMost * (1.0 - through);\n  }\n" +
      "#define lightColor" + number + " " + color + "\n";
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
  declarations =
    "//VTK::GodRays::Colour\n" + (isDimmed ? vtkGodRaysSurfaceAirFS + declarations : declarations);
  if (declarations != this->Declarations)
  {
    this->Declarations = declarations;
    this->Included = vtkGodRaysQuad::Include(declarations);
  }
  Replace(fragmentShader, "//VTK::GodRays::Dec", this->Included);
  Replace(fragmentShader, "//VTK::GodRays::Flow",
    isImpostor
      ? ""
      : "  vec3 godraysFacet = cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz));\n"
        "  godraysFacet = dot(godraysFacet, godraysFacet) > 0.0 ? normalize(godraysFacet)\n"
        "                                                       : vec3(0.0, 0.0, 1.0);\n"
        "  vec3 godraysToEye = cameraParallel == 1 ? vec3(0.0, 0.0, 1.0) : -vertexVC.xyz;\n"
        "  godraysFacet = dot(godraysFacet, godraysToEye) < 0.0 ? -godraysFacet : godraysFacet;\n");
  Replace(fragmentShader, "//VTK::GodRays::Impl",
    std::string("  vec3 godraysNormal = ") + (isImpostor ? "normalVCVSOutput" : "godraysFacet") +
      ";\n" + lights);
  return true;
}

bool vtkGodRaysSurfaceShadows::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (!program->IsUniformUsed("godraysMost"))
  {
    return true;
  }
  const double most = IsColored(mapper, prop) ? this->MostDataShadow : 1.0;
  program->SetUniformf("godraysMost", static_cast<float>(this->Active ? most : 0.0));
  if (program->IsUniformUsed("godraysAir"))
  {
    program->SetUniform4fv("godraysAir", 2, this->Air);
    program->SetUniform4f("godraysVertical", this->Vertical);
    program->SetUniformf("godraysPlanet", this->Planet);
  }
  for (const Text& light : this->Shaders)
  {
    const std::string number = std::to_string(light.Number);
    const auto caster = std::find_if(this->Casting.begin(), this->Casting.end(),
      [&](const Caster& each) { return each.Number == light.Number; });
    const bool isShadowed = this->Active && caster != this->Casting.end();
    if (isShadowed && program->IsUniformUsed(("godraysLight" + number).c_str()))
    {
      program->SetUniform4f(("godraysLight" + number).c_str(), caster->Light);
    }
    for (int kind = 0; kind < 2; ++kind)
    {
      const std::string name = GetName(number, kind);
      if (light.Faces[kind] == 0 || !program->IsUniformUsed(("godraysMap" + name).c_str()))
      {
        continue;
      }
      // A sampler always has a texture of its kind, or OpenGL refuses to draw; and it is bound again for each
      // prop, as passes between, such as vtkEDLShading, bind theirs to its unit.
      const bool hasMap = isShadowed && caster->Maps[kind].Faces > 0;
      vtkTextureObject* texture = hasMap ? caster->Maps[kind].Texture : this->Nothing.GetColor();
      texture->Activate();
      program->SetUniformi(("godraysMap" + name).c_str(), texture->GetTextureUnit());
      if (hasMap)
      {
        const Map& map = caster->Maps[kind];
        // VTK 9.1 takes them as if it wrote to them
        program->SetUniformMatrix4x4v(
          ("godraysToFace" + name).c_str(), map.Faces, const_cast<float*>(map.ToFace));
        program->SetUniformMatrix4x4v(
          ("godraysToPlane" + name).c_str(), map.Faces, const_cast<float*>(map.ToPlane));
        program->SetUniform4f(("godraysTexels" + name).c_str(), map.Texels);
        program->SetUniform3f(("godraysUnit" + name).c_str(), map.Unit);
      }
    }
  }
  return true;
}

std::string vtkGodRaysSurfaceShadows::Describe() const
{
  std::ostringstream text;
  text << "surfaces: shadows of " << this->Casting.size() << " of " << this->Shining.size()
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
  for (Kept& light : this->Lights)
  {
    Release(light, window);
  }
  this->Lights.clear();
  this->Casting.clear();
  this->WithoutLights.clear();
  this->Nothing.Release(window);
}
