// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSurfaceShadows.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysSurfaceShadowsFS.h"
#include "vtkGodRaysView.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
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
#include <sstream>

vtkStandardNewMacro(vtkGodRaysSurfaceShadows);

namespace
{
constexpr int LeastSize = 512; // of a map [pixels]
constexpr int MostSize = 4096;

/// Returns whether a prop casts shadows on surfaces. Points, lines, and the spheres and tubes that stand for
/// them, do not: they are so many pixels wide in a map as in the picture, or face the eye in the picture and
/// the light in the map, and would shadow themselves.
bool Casts(vtkProp* prop)
{
  auto actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper)
  {
    return prop->HasOpaqueGeometry() != 0;
  }
  auto data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const bool isThin = actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper") ||
    mapper->IsA("vtkPointGaussianMapper") ||
    (data && data->GetNumberOfPolys() == 0 && data->GetNumberOfStrips() == 0);
  return !isThin && prop->HasOpaqueGeometry() != 0;
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
  std::vector<vtkSmartPointer<vtkLight>> shining; // a light's place is its number in VTK's shaders
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
  this->Shining = static_cast<int>(shining.size());
  this->Finder.Renderer = request.Renderer;
  this->Finder.Compositor = request.Compositor;
  this->Finder.LightsMedium = true; // wherever they are: behind the eye, too
  this->Finder.Find(*request.View, shining, lights);
  const auto castsNone = [&](const vtkGodRaysLight& light)
  { return light.Number < 0 || shining[light.Number]->LightTypeIsHeadlight(); };
  lights.erase(std::remove_if(lights.begin(), lights.end(), castsNone), lights.end());
  std::stable_sort(lights.begin(), lights.end(),
    [&](const vtkGodRaysLight& one, const vtkGodRaysLight& other)
    { return shining[one.Number]->GetIntensity() > shining[other.Number]->GetIntensity(); });
  lights.resize(std::min(lights.size(), MaximumLights));
}

bool vtkGodRaysSurfaceShadows::DrawMap(
  const Request& request, const vtkGodRaysLight& light, vtkGodRaysShadowMap& map)
{
  vtkGodRaysMedium air;
  air.FarLimit = request.Renderer->GetActiveCamera()->GetClippingRange()[1];
  vtkGodRaysMediumIntegrator::Request scene;
  scene.Window = request.Window;
  scene.Renderer = request.Renderer;
  scene.Medium = &air;
  scene.View = request.View;
  scene.Light = &light;
  scene.Occluders = &this->Sorted.OccludingProps;
  scene.Compositor = request.Compositor;
  // Texels about half as wide as pixels, where map and picture show the same.
  int size = LeastSize;
  while (size < std::min(2 * std::max(request.Size[0], request.Size[1]), MostSize))
  {
    size *= 2;
  }
  if (!map.Draw(scene, light.IsInfinite() ? size : size / 2, 1))
  {
    return false;
  }
  const vtkGodRaysShadowFaces& faces = map.GetFaces();
  if (faces.Count == 0)
  {
    return true; // nothing casts
  }
  this->Drawn += map.WasKept() ? 0 : 1;
  Caster caster;
  caster.Number = light.Number;
  caster.Faces = faces.Count;
  caster.Map = map.GetDepth();
  for (int i = 0; i < 4; ++i)
  {
    caster.Light[i] = static_cast<float>(i == 2 ? -light.Position[2] : light.Position[i]);
  }
  const vtkGodRaysShadowGrids& grids = faces.Grids;
  const double texel = std::max(grids.Grids[0].Texel[0], grids.Grids[0].Texel[1]);
  const double depth = grids.Range[1] - grids.Range[0];
  caster.Texels[0] = static_cast<float>(faces.Size);
  caster.Texels[1] = static_cast<float>(faces.GetColumns());
  // Window depth is affine in the distance, or in 1/distance of a lamp, whose texels widen with it.
  caster.Texels[2] =
    static_cast<float>(texel * (grids.Point ? grids.Range[0] * grids.Range[1] : 1.0) / depth);
  for (int face = 0; face < faces.Count; ++face)
  {
    double clip[16];
    vtkMatrix4x4::Multiply4x4(faces.ViewToMap[face], request.View->CameraToView, clip);
    for (int column = 0; column < 4; ++column)
    {
      float* to = caster.ToFace + 16 * face + 4 * column;
      const double w = clip[12 + column];
      to[0] = static_cast<float>(0.5 * faces.Size * (clip[column] + w));
      to[1] = static_cast<float>(0.5 * faces.Size * (clip[4 + column] + w));
      to[2] = static_cast<float>(0.5 * (clip[8 + column] + w));
      to[3] = static_cast<float>(w);
    }
  }
  this->Casting.push_back(caster);
  return true;
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
  this->Active = false;
  this->Built = 0;
  this->Drawn = 0;
  this->Casting.clear();
  // Lights as the scene has them: mappers are built for their number and kinds.
  this->UpdateLightGeometry(request.Renderer);
  this->UpdateLights(request.Renderer);
  this->Nothing.Prepare(request.Window, 1, 1, { GL_RGBA8, 0 });
  vtkGodRaysOcclusionPass::Request sorting;
  sorting.Renderer = request.Renderer;
  sorting.UntaggedPropsOcclude = request.UntaggedPropsOcclude;
  sorting.LampsOcclude = false;
  sorting.Dims = false;
  this->Sorted.Sort(sorting);
  std::vector<vtkProp*>& occluding = this->Sorted.OccludingProps;
  occluding.erase(std::remove_if(occluding.begin(), occluding.end(),
                    [](vtkProp* prop) { return !Casts(prop); }),
    occluding.end());
  std::vector<vtkGodRaysLight> lights;
  this->FindLights(request, lights);
  for (; this->Maps.size() > lights.size(); this->Maps.pop_back())
  {
    this->Maps.back().Release(request.Window);
  }
  bool done = true;
  for (std::size_t i = 0; i < lights.size() && done; ++i)
  {
    if (i == this->Maps.size())
    {
      this->Maps.emplace_back();
    }
    done = this->DrawMap(request, lights[i], this->Maps[i]);
  }
  if (!done)
  {
    this->Casting.clear();
  }
  std::vector<std::pair<int, int>> text;
  for (const Caster& caster : this->Casting)
  {
    text.emplace_back(caster.Number, caster.Faces);
  }
  if (text != this->Text)
  {
    this->Text = text;
    this->Stage.Modified();
  }
  return done;
}

void vtkGodRaysSurfaceShadows::End()
{
  this->SetProps(false);
  for (const Caster& caster : this->Casting)
  {
    caster.Map->Deactivate();
  }
  if (this->Nothing.IsReady())
  {
    this->Nothing.GetColor()->Deactivate();
  }
  this->Active = false;
  this->Props.clear();
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
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  ++this->Built;
  const auto has = [&](const std::string& text)
  { return fragmentShader.find(text) != std::string::npos; };
  std::string declarations = "uniform float godraysMost;\n"; // part of a light that shadows take
  std::string lights;
  const bool hasPlace = has("vec4 vertexVC = ") && has("//VTK::GodRays::Impl");
  for (const auto& light : this->Text)
  {
    const std::string number = std::to_string(light.first);
    if (!hasPlace || !has("uniform vec3 lightColor" + number + ";"))
    {
      continue; // this mapper does not shade with it
    }
    std::string visibility = vtkGodRaysSurfaceShadowsFS;
    Replace(visibility, "NUMBER", number);
    Replace(visibility, "FACES", std::to_string(light.second));
    declarations += visibility;
    const std::string color = "godraysColor" + number;
    lights += "  vec3 " + color + " = lightColor" + number +
      ";\n"
      "  if (godraysMost > 0.0)\n"
      "  {\n"
      "    " +
      color + " *= 1.0 - godraysMost * (1.0 - GodRaysVisibility" + number +
      "(vertexVC.xyz, godraysNormal));\n"
      "  }\n"
      "#define lightColor" +
      number + " " + color + "\n";
  }
  if (lights.empty())
  {
    return true;
  }
  // Spheres and tubes that stand for points and lines move vertexVC later on: their normal is the drawn one.
  const std::size_t first = fragmentShader.find("vec4 vertexVC = ");
  const bool isImpostor = fragmentShader.find("vertexVC =", first + 16) != std::string::npos ||
    has("vertexVC.xyz =");
  Replace(fragmentShader, "//VTK::GodRays::Dec", declarations);
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
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (!program->IsUniformUsed("godraysMost"))
  {
    return true;
  }
  auto shown = vtkMapper::SafeDownCast(mapper);
  const bool isColored =
    shown && shown->GetScalarVisibility() && shown->GetColorMapColors() != nullptr;
  const double most = isColored ? this->MostDataShadow : 1.0;
  program->SetUniformf("godraysMost", static_cast<float>(this->Active ? most : 0.0));
  for (const auto& light : this->Text)
  {
    const std::string number = std::to_string(light.first);
    const auto name = [&](const char* of) { return of + number; };
    if (!program->IsUniformUsed(name("godraysMap").c_str()))
    {
      continue;
    }
    // A sampler always has a texture of its kind, or OpenGL refuses to draw; and it is bound again for each
    // prop, as passes between, such as vtkEDLShading, bind theirs to its unit.
    const auto caster = std::find_if(this->Casting.begin(), this->Casting.end(),
      [&](const Caster& each) { return each.Number == light.first; });
    const bool isShadowed = this->Active && caster != this->Casting.end();
    vtkTextureObject* map = isShadowed ? caster->Map : this->Nothing.GetColor();
    map->Activate();
    program->SetUniformi(name("godraysMap").c_str(), map->GetTextureUnit());
    if (isShadowed)
    {
      program->SetUniformMatrix4x4v(name("godraysToFace").c_str(), caster->Faces, caster->ToFace);
      program->SetUniform4f(name("godraysLight").c_str(), caster->Light);
      program->SetUniform3f(name("godraysTexels").c_str(), caster->Texels);
    }
  }
  return true;
}

std::string vtkGodRaysSurfaceShadows::Describe() const
{
  std::ostringstream text;
  text << "surfaces: shadows of " << this->Casting.size() << " of " << this->Shining
       << " lights, " << this->Drawn << " maps drawn, " << this->Built << " shaders built";
  return text.str();
}

void vtkGodRaysSurfaceShadows::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (vtkGodRaysShadowMap& map : this->Maps)
  {
    map.Release(window);
  }
  this->Maps.clear();
  this->Casting.clear();
  this->Nothing.Release(window);
}
