// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysDiffuseLight.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkGodRaysFroxelsFS.h"
#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysMediumVerification.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using vtkGodRays::Vec3;
using Request = vtkGodRaysMediumIntegrator::Request;

// Nodes are some sixteenth to thirty-second of the scene apart, and average a map over 64 places.
constexpr int MapSize = 256;
// Of air about the scene's bounds, of their diagonal: light comes from there, too.
constexpr double Margin = 0.25;

Vec3 ToVector(const double* v)
{
  return Vec3(v[0], v[1], v[2]);
}

/// Returns a medium as it is seen from the world's origin, in the world. A planet's ground is a plane for the
/// solver: what it solves for is small beside a planet.
vtkGodRaysMedium SeeFromOrigin(const vtkGodRaysSingleScattering::Parameters& world)
{
  vtkGodRaysMedium medium = world.Medium;
  const Vec3 eye = ToVector(world.Position);
  const Vec3 up = medium.Up[0] * ToVector(world.Right) + medium.Up[1] * ToVector(world.Up) +
    medium.Up[2] * ToVector(world.Forward);
  medium.EyeHeight = vtkGodRays::MediumStart(medium.PlanetRadius, medium.EyeHeight, up, -eye, up).x;
  const Vec3 vertical = medium.PlanetRadius > 0.0
    ? glm::normalize((medium.PlanetRadius + world.Medium.EyeHeight) * up - eye)
    : up;
  for (int i = 0; i < 3; ++i)
  {
    medium.Up[i] = vertical[i];
  }
  return medium;
}

/// Returns what the layers of a map leave of its light at a place in view coordinates: at a height towards a
/// directional light, or relative to a lamp.
Vec3 GetVisibility(
  const std::vector<vtkGodRaysShadowGrids>& layers, double height, const Vec3& place)
{
  Vec3 left(1.0);
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const vtkGodRaysShadowGrids& map = layers[k];
    const double distance = map.Point ? std::max(vtkGodRays::length(place), 1e-300) : 1.0;
    const double at[3] = { place.x / distance, place.y / distance, place.z / distance };
    std::ptrdiff_t texel = 0;
    if (map.Point ? map.GetDistance(at, &texel) < distance : map.GetHeight(at, &texel) > height)
    {
      const float* const* dark = map.NumberOfLayers > 0 ? map.Layers[k].Dark : nullptr;
      left -= dark ? Vec3(dark[0][texel], dark[1][texel], dark[2][texel]) : Vec3(1.0);
    }
  }
  return vtkGodRays::max(left, Vec3(0.0));
}

/// What triangles in a node's cell hide along each axis, as parts of its face: all of them, and less where
/// they turn to both sides.
struct Hidden
{
  Vec3 All = Vec3(0.0);
  Vec3 Net = Vec3(0.0);
};

/// Adds triangles to the cells in which they are.
void AddTriangles(vtkPolyData* surface, const int nodes[3], const Vec3& low, const Vec3& cell,
  std::vector<Hidden>& hidden)
{
  const Vec3 faces(cell.y * cell.z, cell.z * cell.x, cell.x * cell.y);
  const double spacing = 0.5 * std::min({ cell.x, cell.y, cell.z });
  const auto add = [&](const Vec3& place, const Vec3& parts)
  {
    std::size_t node = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const double at = std::round((place[axis] - low[axis]) / cell[axis]);
      if (!(at >= 0.0 && at < nodes[axis]))
      {
        return;
      }
      node = node * nodes[axis] + static_cast<std::size_t>(at);
    }
    hidden[node].All += vtkGodRays::abs(parts);
    hidden[node].Net += parts;
  };
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* points;
    cells->GetCurrentCell(count, points);
    Vec3 corners[3];
    for (int i = 0; i < 3; ++i)
    {
      double place[3];
      surface->GetPoint(points[i], place);
      corners[i] = ToVector(place);
    }
    const Vec3 sides[2] = { corners[1] - corners[0], corners[2] - corners[0] };
    const double longest = std::max({ vtkGodRays::length(sides[0]), vtkGodRays::length(sides[1]),
      vtkGodRays::length(sides[1] - sides[0]) });
    const int parts = static_cast<int>(std::clamp(std::ceil(longest / spacing), 1.0, 512.0));
    const Vec3 area = vtkGodRays::cross(sides[0], sides[1]) / faces / (2.0 * parts * parts);
    for (int i = 0; i < parts; ++i) // rows of small triangles, whose centres stand for them
    {
      for (int j = 0; j < 2 * (parts - i) - 1; ++j)
      {
        const double u = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / parts;
        const double v = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / parts;
        add(corners[0] + u * sides[0] + v * sides[1], area);
      }
    }
  }
}

/// Finds what part of light nodes stop: all of it where triangles hide three quarters of a face, as a wall
/// does; else the mean over the axes. A body has two sides, and a sheet one.
void FindCover(const std::vector<Hidden>& hidden, std::vector<float>& cover)
{
  for (std::size_t node = 0; node < hidden.size(); ++node)
  {
    const Vec3 parts = 0.5 * (hidden[node].All + vtkGodRays::abs(hidden[node].Net));
    cover[node] = static_cast<float>(
      std::max({ parts.x, parts.y, parts.z }) > 0.75 ? 1.0 : (parts.x + parts.y + parts.z) / 3.0);
  }
}
}

bool vtkGodRaysDiffuseLight::State::IsSame(const State& other) const
{
  return this->Numbers == other.Numbers &&
    std::equal(this->Places.begin(), this->Places.end(), other.Places.begin(), other.Places.end(),
      [](double a, double b) { return std::abs(a - b) <= 1e-8 * std::max(1.0, std::abs(a)); });
}

vtkGodRaysDiffuseLight::vtkGodRaysDiffuseLight()
  : Quad("vtkGodRaysFroxelsFS", vtkGodRaysFroxelsFS)
{
}

void vtkGodRaysDiffuseLight::Begin()
{
  this->Scene.Lights.clear();
  this->Changed = false;
}

bool vtkGodRaysDiffuseLight::AddLight(const Request& request, const vtkGodRaysGridPicture* data)
{
  const std::size_t index = this->Scene.Lights.size();
  if (index == this->Lights.size())
  {
    this->Lights.emplace_back();
  }
  Light& own = this->Lights[index];
  Request everywhere = request;
  everywhere.Focus = std::numeric_limits<double>::infinity();
  if (!own.Map.Draw(everywhere, MapSize, 1))
  {
    return false;
  }
  this->Changed = this->Changed || (own.Map.GetNumberOfFaces() > 0 && !own.Map.WasKept());
  const vtkGodRaysShadowGrids& map = own.Map.GetGrids();
  own.Layers.clear();
  for (int k = 0; map.Levels > 0 && k < std::max(map.NumberOfLayers, 1); ++k)
  {
    own.Layers.push_back(map.NumberOfLayers > 0 ? map.GetLayer(k) : map);
  }
  const auto parameters = vtkGodRaysMediumRays::GetWorldParameters(request);
  const Vec3 axes[3] = { ToVector(parameters.Right), ToVector(parameters.Up),
    ToVector(parameters.Forward) };
  const bool directional = parameters.Light[3] == 0.0;
  Vec3 place = ToVector(parameters.Light);
  place = place / (directional ? vtkGodRays::length(place) : parameters.Light[3]);
  vtkGodRaysTransportScene::Light light;
  light.Position = place;
  light.Directional = directional;
  light.Color = ToVector(parameters.LightColor);
  light.Spot = parameters.Spot;
  for (int i = 0; i < 3; ++i)
  {
    light.Spot.Axis[i] = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      light.Spot.Axis[i] += parameters.Spot.Axis[k] * axes[k][i];
    }
  }
  const Vec3 origin = directional ? ToVector(parameters.Position) : place;
  light.Visibility = [&own, place, origin, right = axes[0], up = axes[1], forward = axes[2]](
                       const Vec3& at)
  {
    const Vec3 offset = at - origin;
    return GetVisibility(own.Layers, vtkGodRays::dot(offset, place),
      Vec3(vtkGodRays::dot(offset, right), vtkGodRays::dot(offset, up),
        vtkGodRays::dot(offset, forward)));
  };
  if (data)
  {
    light.Depths = data->GetLights();
  }
  this->Scene.Lights.push_back(std::move(light));
  return true;
}

void vtkGodRaysDiffuseLight::SetBox(const double bounds[6])
{
  vtkBoundingBox box(bounds);
  if (this->HasAir)
  {
    box.Inflate(Margin * box.GetDiagonalLength());
  }
  else
  {
    box.Reset();
    for (const vtkGodRaysGrid& grid : this->Scene.Grids)
    {
      for (int k = 0; k < 8; ++k)
      {
        Vec3 corner = grid.Origin;
        for (int axis = 0; axis < 3; ++axis)
        {
          corner += (k >> axis & 1) * (grid.Points[axis] - 1.0) * grid.Axes[axis];
        }
        box.AddPoint(corner.x, corner.y, corner.z);
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Scene.Low[i] = box.GetBound(2 * i);
    this->Scene.High[i] = box.GetBound(2 * i + 1);
  }
}

// Chooses how finely to solve.
void vtkGodRaysDiffuseLight::Choose(double tolerance)
{
  const double diagonal = vtkGodRays::length(this->Scene.High - this->Scene.Low);
  double depth = this->HasData ? 10.0 : 0.0; // data are dense somewhere
  double asymmetry = this->HasData ? std::abs(this->Scene.Grids[0].Asymmetry) : 0.0;
  for (int i = 0; i < this->Scene.Medium.NumberOfComponents; ++i)
  {
    const vtkGodRaysMedium::Component& part = this->Scene.Medium.Components[i];
    depth += diagonal * (part.Scattering[1] + part.Absorption[1]);
    asymmetry = std::max(asymmetry, std::abs(part.Asymmetry));
  }
  this->Parameters = vtkGodRaysMultipleScattering::Choose(tolerance, depth, asymmetry);
}

vtkGodRaysDiffuseLight::State vtkGodRaysDiffuseLight::GetState(unsigned int dataVersion) const
{
  const vtkGodRaysTransportScene& scene = this->Scene;
  const double diagonal = vtkGodRays::length(scene.High - scene.Low);
  State state;
  state.Numbers = { dataVersion + 0.0, scene.Medium.PlanetRadius, this->Parameters.Cells + 0.0,
    this->Parameters.Directions + 0.0, this->Parameters.Degree + 0.0 };
  const auto addPlace = [&](const Vec3& place, double unit)
  {
    for (int i = 0; i < 3; ++i)
    {
      state.Places.push_back(place[i] / unit);
    }
  };
  addPlace(scene.Low, diagonal);
  addPlace(scene.High, diagonal);
  if (scene.Medium.HasExponentialDensity()) // else its vertical is anywhere
  {
    addPlace(ToVector(scene.Medium.Up), 1.0);
    state.Places.push_back(scene.Medium.EyeHeight / diagonal);
  }
  for (int i = 0; i < scene.Medium.NumberOfComponents; ++i)
  {
    const vtkGodRaysMedium::Component& part = scene.Medium.Components[i];
    state.Numbers.insert(state.Numbers.end(), part.Scattering, part.Scattering + 3);
    state.Numbers.insert(state.Numbers.end(), part.Absorption, part.Absorption + 3);
    state.Numbers.insert(state.Numbers.end(),
      { part.PhaseFunction + 0.0, part.Asymmetry, part.SecondPhaseFunction + 0.0,
        part.SecondAsymmetry, part.SecondWeight, part.ScaleHeight });
  }
  for (std::size_t i = 0; i < scene.Lights.size(); ++i)
  {
    const vtkGodRaysTransportScene::Light& light = scene.Lights[i];
    state.Numbers.push_back(this->Lights[i].Map.GetNumberOfFaces());
    addPlace(light.Position, light.Directional ? 1.0 : diagonal);
    addPlace(light.Spot.IsCone() ? ToVector(light.Spot.Axis) : Vec3(0.0), 1.0);
    state.Numbers.insert(state.Numbers.end(),
      { light.Directional ? 1.0 : 0.0, light.Color.x, light.Color.y, light.Color.z,
        light.Spot.CosCone, light.Spot.Exponent });
  }
  return state;
}

void vtkGodRaysDiffuseLight::Find(const Request& request, const double bounds[6],
  const std::vector<vtkGodRaysGrid>& grids, unsigned int dataVersion, bool estimates)
{
  while (this->Lights.size() > this->Scene.Lights.size()) // of lights that are gone
  {
    this->Lights.back().Map.Release(request.Window);
    this->Lights.pop_back();
  }
  const auto world = vtkGodRaysMediumRays::GetWorldParameters(request);
  this->Scene.Medium = SeeFromOrigin(world);
  this->HasAir = false;
  for (int i = 0; i < world.Medium.NumberOfComponents; ++i)
  {
    const vtkGodRaysMedium::Component& part = world.Medium.Components[i];
    this->HasAir =
      this->HasAir || part.Scattering[0] + part.Scattering[1] + part.Scattering[2] > 0.0;
  }
  if (!this->HasAir)
  {
    this->Scene.Medium.NumberOfComponents = 0;
  }
  this->HasData = !grids.empty();
  this->Scene.Grids = grids;
  this->SetBox(bounds);
  this->Choose(request.ErrorTolerance);
  State state = this->GetState(dataVersion);
  this->Kept = !this->Changed && state.IsSame(this->Solved) && (!estimates || this->Error >= 0.0);
  if (!this->Kept)
  {
    this->Solved = std::move(state);
    this->View.clear();
    this->Solve(request, estimates);
  }
  this->Sum(request);
}

void vtkGodRaysDiffuseLight::Solve(const Request& request, bool estimates)
{
  this->Scene.Cover =
    [&request](const int nodes[3], const Vec3& low, const Vec3& cell, std::vector<float>& cover)
  {
    vtkNew<vtkAppendPolyData> all;
    vtkGodRaysMediumVerification::AddOpaque(*request.Occluders, all);
    if (all->GetNumberOfInputConnections(0) > 0)
    {
      vtkNew<vtkTriangleFilter> triangles;
      triangles->SetInputConnection(all->GetOutputPort());
      triangles->PassVertsOff();
      triangles->PassLinesOff();
      triangles->Update();
      std::vector<Hidden> hidden(cover.size());
      AddTriangles(triangles->GetOutput(), nodes, low, cell, hidden);
      FindCover(hidden, cover);
    }
  };
  ++this->Scene.Version;
  const double start = vtkTimerLog::GetUniversalTime();
  this->Solution.Update(this->Scene, this->Parameters);
  this->Seconds = vtkTimerLog::GetUniversalTime() - start;
  this->Error = -1.0;
  if (estimates)
  {
    this->Estimate(request);
  }
}

// Over view rays that no surface ends.
void vtkGodRaysDiffuseLight::Estimate(const Request& request)
{
  const auto world = vtkGodRaysMediumRays::GetWorldParameters(request);
  int layer[2];
  request.Depths->GetSize(layer);
  const vtkGodRaysFroxels::Picture picture = vtkGodRaysMediumRays(request, layer).GetPicture();
  constexpr int steps = 64;
  constexpr int columns = 12;
  constexpr int rows = 8;
  std::vector<vtkGodRaysMultipleScattering::Ray> rays;
  for (int i = 0; i < columns * rows; ++i)
  {
    const double x = ((i % columns + 0.5) / columns * picture.Size[0] - picture.Center[0]);
    const double y = ((i / columns + 0.5) / rows * picture.Size[1] - picture.Center[1]);
    const Vec3 aside = picture.PixelSize * (x * ToVector(world.Right) + y * ToVector(world.Up));
    const Vec3 eye = ToVector(world.Position);
    const Vec3 forward = ToVector(world.Forward);
    const Vec3 toward = world.Parallel ? forward : forward + aside;
    const double perDepth = vtkGodRays::length(toward);
    rays.push_back(
      { world.Parallel ? eye + aside : eye, toward / perDepth, perDepth * world.Medium.FarLimit });
  }
  vtkGodRaysMultipleScattering::Texture source;
  this->Solution.Contract(rays[0].Origin, ToVector(world.Forward), world.Parallel, source);
  double brightest = 1e-300;
  for (const vtkGodRaysMultipleScattering::Ray& ray : rays)
  {
    const Vec3 light = this->Solution.Evaluate(source, ray, steps).Orders;
    brightest = std::max({ brightest, light.x, light.y, light.z });
  }
  this->Error =
    this->Solution.Estimate(rays, ToVector(world.Forward), world.Parallel, steps) / brightest;
}

void vtkGodRaysDiffuseLight::Sum(const Request& request)
{
  const auto world = vtkGodRaysMediumRays::GetWorldParameters(request);
  int layer[2];
  request.Depths->GetSize(layer);
  const vtkGodRaysFroxels::Picture picture = vtkGodRaysMediumRays(request, layer).GetPicture();
  std::vector<double> view(request.View->WorldToView, request.View->WorldToView + 16);
  view.insert(view.end(),
    { picture.PixelSize, picture.Center[0], picture.Center[1], picture.Size[0] + 0.0,
      picture.Size[1] + 0.0, world.Parallel ? 1.0 : 0.0, world.Medium.FarLimit });
  if (view == this->View)
  {
    return;
  }
  this->View = std::move(view);
  this->Solution.FindSource(
    ToVector(world.Position), ToVector(world.Forward), world.Parallel, this->Source);
  if (this->HasAir)
  {
    this->Froxels.Build(world, picture, this->Source);
  }
  this->ImageVersion = 0;
}

bool vtkGodRaysDiffuseLight::Add(const Request& request)
{
  if (!this->HasAir)
  {
    return true;
  }
  const int columns = this->Froxels.GetColumns();
  const int rows = this->Froxels.GetRows();
  constexpr int slices = vtkGodRaysFroxels::Slices;
  this->Image.Prepare(request.Window, columns, rows * slices, { GL_RGBA32F, 0 });
  if (this->ImageVersion == 0 || this->ImageVersion != this->Image.GetVersion())
  {
    this->Image.Write(GL_RGB, GL_FLOAT, this->Froxels.GetValues().data());
    this->ImageVersion = this->Image.GetVersion();
  }
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends || !request.Result->BindToAdd())
  {
    return false;
  }
  vtkShaderProgram* program = this->Quad.Begin(request.Window);
  if (!program)
  {
    return false;
  }
  const double count[3] = { columns + 0.0, rows + 0.0, slices + 0.0 };
  vtkGodRaysQuad::SetVector(program, "count", count);
  program->SetUniformf("viewScale", static_cast<float>(request.View->ViewScale));
  program->SetUniformf("farthest", static_cast<float>(this->Froxels.GetFarthest()));
  program->SetUniformf("maximum", request.Result->GetFormat() == GL_RGBA16F ? 65504.0f : 1e30f);
  this->Quad.SetTexture("ends", ends->GetColor());
  this->Quad.SetTexture("froxels", this->Image.GetColor());
  this->Quad.End();
  return true;
}

std::string vtkGodRaysDiffuseLight::Describe() const
{
  if (!this->HasLight())
  {
    return "";
  }
  const int* nodes = this->Source.Nodes;
  std::ostringstream text;
  text << ", all orders of scattering from " << nodes[0] << " x " << nodes[1] << " x " << nodes[2]
       << " nodes in " << this->Parameters.Directions << " directions, ";
  if (this->Kept)
  {
    text << "kept";
  }
  else
  {
    text << "solved in " << this->Seconds << " s";
  }
  if (this->Error >= 0.0)
  {
    text << ", with an error that is estimated at " << this->Error
         << " of the brightest light that was scattered more than once";
  }
  return text.str();
}

void vtkGodRaysDiffuseLight::Release(vtkWindow* window)
{
  for (Light& light : this->Lights)
  {
    light.Map.Release(window);
  }
  this->Lights.clear();
  this->Solved = State();
  this->Image.Release(window);
  this->Quad.Release();
}
