// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMultipleScattering.h"

#include "vtkGodRaysFixedPoint.h"
#include "vtkGodRaysGridBlocks.h"
#include "vtkGodRaysGridLight.h"
#include "vtkGodRaysOrdinates.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <numeric>

namespace
{
using vtkGodRays::Vec3;
using Scene = vtkGodRaysTransportScene;
using Wall = vtkGodRaysOrdinates::Wall;

constexpr int MaximumMoments = vtkGodRaysOrdinates::MaximumMoments;
constexpr int Samples = 4;       // of a node's volume, along each axis
constexpr double Nearest = 0.14; // distance of a lamp from nodes, at least [cells]
constexpr float MostOpen = 0.5f; // cover above which a node is opaque
constexpr float Wider = 1.5f;    // than their part of a volume are occluders, as light sees them
constexpr double MostStretched = 1.2; // ratio of a cell's edges, or so

// Calls work for each of so many nodes, on several threads.
template <typename Work>
void ForNodes(std::size_t count, const Work& work)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType node = begin; node < end; ++node)
      {
        work(static_cast<std::size_t>(node));
      }
    });
}

Vec3 GetOffset(int code, int count)
{
  return (Vec3(code % count, code / count % count, code / (count * count)) + 0.5) / Vec3(count);
}
}

Vec3 vtkGodRaysMultipleScattering::Texture::Sample(const Vec3& place) const
{
  const Vec3 last(this->Nodes[0] - 1, this->Nodes[1] - 1, this->Nodes[2] - 1);
  const Vec3 at = vtkGodRays::clamp((place - this->Low) / this->Cell, Vec3(0.0), last);
  const Vec3 cell = vtkGodRays::min(vtkGodRays::floor(at), last - 1.0);
  const Vec3 t = at - cell;
  Vec3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 high(corner & 1, corner >> 1 & 1, corner >> 2);
    const Vec3 weight = high * t + (1.0 - high) * (1.0 - t);
    const Vec3 node = cell + high;
    const float* const value = this->Values.data() +
      3 * static_cast<std::size_t>((node.z * this->Nodes[1] + node.y) * this->Nodes[0] + node.x);
    sum += weight.x * weight.y * weight.z * Vec3(value[0], value[1], value[2]);
  }
  return sum;
}

class vtkGodRaysMultipleScattering::vtkInternals
{
public:
  struct Channel // a colour
  {
    std::vector<float> Extinction; // [node], scaled [1/Unit]
    std::vector<float>
      Scattering; // [degree][node]: scaled moments of the phase functions, times scattering
    std::vector<float> Emission; // [moment][node]: light that is scattered for the first time
    std::vector<float> Moments;  // [moment][node]: diffuse radiance
  };

  Scene Input;
  Parameters Settings;
  bool IsSolved = false;
  std::vector<double> Mixture;              // what the peak was made of
  std::vector<std::vector<double>> Moments; // of each component's phase function
  std::vector<Vec3> Events;                 // of the peak, for each unit of a component's depth
  vtkGodRaysForwardPeak ForwardPeak;
  std::vector<std::vector<vtkGodRaysGridLight>> OwnDepths; // [light][grid]
  int Nodes[3] = { 2, 2, 2 };
  std::size_t Size = 8; // nodes
  Vec3 Cell = Vec3(1.0);
  double Unit = 1.0; // of the channels' lengths [scene units]
  Channel Channels[3];
  // [light][node][colour], if there is a peak: light that arrives through the scaled media, and the peak's
  // events on its way, which are means over what scatters.
  std::vector<float> Arriving;
  std::vector<float> Passed;
  std::vector<float> Cover;  // [node]
  std::vector<float> Albedo; // of what covers
  vtkGodRaysOrdinates Ordinates;
  Report Last;
  std::unique_ptr<vtkGodRaysMultipleScattering> Cheaper[3];

  void Prepare();
  void SetGrid();
  void SampleNode(std::size_t node);
  std::vector<Wall> MakeWalls(int color) const;
  void Solve(int color);
  void FillOpaque(const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const;

  // The light that arrives at a place through the scaled media, and the mean number of the peak's events on
  // its way, which is not set if no light comes.
  Vec3 GetArriving(
    std::size_t light, const Vec3& place, double nearest, Vec3& towards, Vec3& events) const;

  int CountMoments() const { return (this->Settings.Degree + 1) * (this->Settings.Degree + 1); }
  static int GetDegree(int moment) { return moment < 1 ? 0 : moment < 4 ? 1 : moment < 9 ? 2 : 3; }
  void GetIndices(std::size_t node, int* at) const
  {
    at[0] = static_cast<int>(node % this->Nodes[0]);
    at[1] = static_cast<int>(node / this->Nodes[0] % this->Nodes[1]);
    at[2] = static_cast<int>(node / this->Nodes[0] / this->Nodes[1]);
  }
  std::size_t GetBeside(std::size_t node, int face) const // for faces with a node beyond them
  {
    const std::size_t row = this->Nodes[0];
    const std::size_t stride = face < 2 ? 1 : face < 4 ? row : row * this->Nodes[1];
    return face % 2 ? node + stride : node - stride;
  }
  Vec3 GetPlace(std::size_t node) const
  {
    int at[3];
    this->GetIndices(node, at);
    return this->Input.Low + this->Cell * Vec3(at[0], at[1], at[2]);
  }
};

// Finds what does not depend on places.
void vtkGodRaysMultipleScattering::vtkInternals::Prepare()
{
  const Scene& scene = this->Input;
  const int components = scene.GetNumberOfComponents();
  constexpr int count = 16; // places along each axis, for mean albedos and the mean phase function
  std::vector<Vec3> scattered(components, Vec3(0.0));
  std::vector<Vec3> dimmed(components, Vec3(1e-300));
  Vec3 all(1e-300);
  for (int i = 0; i < components * count * count * count; ++i)
  {
    const Vec3 offset = GetOffset(i / components, count);
    const Scene::Point point =
      scene.Sample(i % components, glm::mix(scene.Low, scene.High, offset));
    scattered[i % components] += point.Scattering;
    dimmed[i % components] += point.Extinction;
    all += point.Scattering;
  }
  std::vector<double> mixture = { static_cast<double>(this->Settings.Degree) };
  for (int k = 0; k < components; ++k)
  {
    const Scene::PhaseMix phase = scene.GetPhase(k);
    mixture.insert(mixture.end(),
      { phase.Get(1.0), phase.Get(0.3), phase.Get(-0.9),
        (scattered[k].x + scattered[k].y + scattered[k].z) / (all.x + all.y + all.z) });
  }
  if (mixture != this->Mixture)
  {
    this->Mixture = mixture;
    this->Moments.clear();
    std::vector<double> means(16, 0.0);
    for (int k = 0; k < components; ++k)
    {
      this->Moments.push_back(vtkGodRaysForwardPeak::FindMoments(scene.GetPhase(k)));
      means.resize(std::max(means.size(), this->Moments[k].size()));
      for (std::size_t l = 0; l < this->Moments[k].size(); ++l)
      {
        means[l] += mixture[4 * k + 4] * this->Moments[k][l];
      }
    }
    this->ForwardPeak.Build(means, this->Settings.Degree);
  }
  this->Events.clear();
  for (int k = 0; k < components; ++k)
  {
    this->Events.push_back(this->ForwardPeak.ForwardPart * scattered[k] / dimmed[k]);
  }
  this->OwnDepths.assign(scene.Lights.size(), {});
  for (const vtkGodRaysGrid& grid : scene.Grids)
  {
    const vtkGodRaysGridBlocks blocks(grid);
    for (std::size_t k = 0; k < scene.Lights.size(); ++k)
    {
      const Scene::Light& light = scene.Lights[k];
      if (light.Depths.empty())
      {
        const double length = light.Directional ? vtkGodRays::length(light.Position) : 1.0;
        this->OwnDepths[k].emplace_back();
        this->OwnDepths[k].back().Build(grid, blocks, light.Position / length, light.Directional);
      }
    }
  }
}

// Divides the box into whole numbers of cells that are nearly cubes. Where it is too thin for that, the grid
// goes beyond it.
void vtkGodRaysMultipleScattering::vtkInternals::SetGrid()
{
  const Vec3 size = this->Input.High - this->Input.Low;
  const double edge = std::max({ size.x, size.y, size.z }) / this->Settings.Cells;
  for (int i = 0; i < 3; ++i)
  {
    const int cells = std::max(static_cast<int>(std::lround(size[i] / edge)), 1);
    const double stretch = size[i] / (cells * edge);
    const bool fits = stretch < MostStretched && stretch > 1.0 / MostStretched;
    this->Cell[i] = fits ? size[i] / cells : edge;
    this->Nodes[i] = 1 + (fits ? cells : static_cast<int>(std::ceil(size[i] / edge + 1e-9)));
  }
  this->Size = static_cast<std::size_t>(this->Nodes[0]) * this->Nodes[1] * this->Nodes[2];
  this->Unit = std::cbrt(this->Cell.x * this->Cell.y * this->Cell.z);
  this->Ordinates.SetGrid(this->Settings.Directions, this->Nodes, this->Cell / this->Unit);
}

Vec3 vtkGodRaysMultipleScattering::vtkInternals::GetArriving(
  std::size_t light, const Vec3& place, double nearest, Vec3& towards, Vec3& events) const
{
  const Scene::Light& source = this->Input.Lights[light];
  double distance;
  Vec3 arriving = this->Input.GetIrradiance(source, place, towards, distance);
  const double closeness = std::min(distance / nearest, 1.0);
  arriving *= closeness * closeness;
  if (source.Visibility)
  {
    arriving *= source.Visibility(place);
  }
  Vec3 depth(0.0);
  events = Vec3(0.0);
  const int formulas = this->Input.Medium.NumberOfComponents;
  const int components = arriving == Vec3(0.0) ? 0 : this->Input.GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    Vec3 own;
    if (k < formulas)
    {
      own = this->Input.GetDepth(k, source, place, towards, distance);
    }
    else
    {
      const vtkGodRaysGrid& grid = this->Input.Grids[k - formulas];
      const vtkGodRaysGridLight& known =
        source.Depths.empty() ? this->OwnDepths[light][k - formulas] : *source.Depths[k - formulas];
      float values[3] = { 0.0f, 0.0f, 0.0f };
      known.AddDepth(grid, grid.GetPlace(place), values);
      own = grid.Bands == 1 ? Vec3(values[0]) : Vec3(values[0], values[1], values[2]);
    }
    depth += own;
    events += own * this->Events[k];
  }
  return arriving * vtkGodRays::exp(events - depth);
}

// Takes means over the volume that is nearer to the node than to others, as far as it is in the grid. Light
// is averaged with scattering: where a medium is dense, its light counts.
void vtkGodRaysMultipleScattering::vtkInternals::SampleNode(std::size_t node)
{
  const Scene& scene = this->Input;
  const int degrees = this->Settings.Degree + 1;
  const Vec3 high =
    scene.Low + this->Cell * Vec3(this->Nodes[0] - 1, this->Nodes[1] - 1, this->Nodes[2] - 1);
  Vec3 dims(0.0);
  std::array<Vec3, 4> scatters;
  std::array<Vec3, MaximumMoments> emits;
  scatters.fill(Vec3(0.0));
  emits.fill(Vec3(0.0));
  const bool hasPeak = this->ForwardPeak.ForwardPart > 0.0;
  std::vector<std::array<Vec3, 2>> comes(
    hasPeak ? scene.Lights.size() : 0, { Vec3(0.0), Vec3(0.0) }); // light, and events times it
  int count = 0;
  int covered = 0;
  for (int i = 0; i < Samples * Samples * Samples; ++i)
  {
    const Vec3 place = this->GetPlace(node) + this->Cell * (GetOffset(i, Samples) - 0.5);
    if (vtkGodRays::clamp(place, scene.Low, high) != place)
    {
      continue;
    }
    ++count;
    const double albedo = scene.Solid ? scene.Solid(place) : -1.0;
    if (albedo >= 0.0)
    {
      ++covered;
      this->Albedo[node] = static_cast<float>(albedo);
      continue;
    }
    std::array<Vec3, 4> own;
    own.fill(Vec3(0.0));
    const double forward = this->ForwardPeak.ForwardPart;
    for (int k = 0; k < scene.GetNumberOfComponents(); ++k)
    {
      const Scene::Point point = scene.Sample(k, place);
      dims += point.Extinction - forward * point.Scattering;
      for (int l = 0; l < degrees; ++l)
      {
        own[l] += point.Scattering * (this->Moments[k][l] - forward);
      }
    }
    for (int l = 0; l < degrees; ++l)
    {
      scatters[l] += own[l];
    }
    for (std::size_t light = 0; light < scene.Lights.size() && own[0] != Vec3(0.0); ++light)
    {
      Vec3 towards;
      Vec3 events;
      const Vec3 arriving = this->GetArriving(light, place, Nearest * this->Unit, towards, events);
      float harmonics[MaximumMoments];
      vtkGodRaysOrdinates::GetHarmonics(-towards, this->Settings.Degree, harmonics);
      if (hasPeak && arriving != Vec3(0.0))
      {
        comes[light][0] += own[0] * arriving;
        comes[light][1] += own[0] * arriving * events;
      }
      for (int m = 0; m < this->CountMoments() && arriving != Vec3(0.0); ++m)
      {
        emits[m] += own[GetDegree(m)] * arriving * static_cast<double>(harmonics[m]);
      }
    }
  }
  const double factor = this->Unit / std::max(count, 1);
  for (int c = 0; c < 3; ++c)
  {
    Channel& channel = this->Channels[c];
    channel.Extinction[node] = static_cast<float>(factor * std::max(dims[c], 0.0));
    for (int l = 0; l < degrees; ++l)
    {
      channel.Scattering[l * this->Size + node] = static_cast<float>(factor * scatters[l][c]);
    }
    for (int m = 0; m < this->CountMoments(); ++m)
    {
      channel.Emission[m * this->Size + node] = static_cast<float>(factor * emits[m][c]);
    }
  }
  for (std::size_t light = 0; light < comes.size(); ++light)
  {
    for (int c = 0; c < 3; ++c)
    {
      const std::size_t at = 3 * (light * this->Size + node) + c;
      this->Arriving[at] =
        static_cast<float>(comes[light][0][c] / std::max(scatters[0][c], 1e-300));
      this->Passed[at] =
        static_cast<float>(comes[light][1][c] / std::max(comes[light][0][c], 1e-300));
    }
  }
  this->Cover[node] = static_cast<float>(covered) / static_cast<float>(std::max(count, 1));
}

// Lists the nodes that occluders cover in part, and those on faces of the box that reflect.
std::vector<Wall> vtkGodRaysMultipleScattering::vtkInternals::MakeWalls(int color) const
{
  const Scene& scene = this->Input;
  std::vector<Wall> walls;
  for (std::size_t node = 0; node < this->Size; ++node)
  {
    int at[3];
    this->GetIndices(node, at);
    const float cover = this->Cover[node];
    // Occluders of half of the volume hide all; smaller ones are wider than their share of the volume.
    Wall wall = { node, cover > MostOpen ? 0.0f : 1.0f - Wider * cover, this->Albedo[node], false,
      {}, {} };
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2;
      const int step = face % 2 ? 1 : -1;
      const bool isLast = at[axis] == (step > 0 ? this->Nodes[axis] - 1 : 0);
      const bool isEntry = at[axis] == (step > 0 ? 0 : this->Nodes[axis] - 1);
      Vec3 place = this->GetPlace(node);
      if (isEntry && scene.FaceAlbedo[face ^ 1] > 0.0 && cover <= MostOpen)
      {
        wall.IsFree[face] = wall.IsFace = true;
        wall.Albedo = static_cast<float>(scene.FaceAlbedo[face ^ 1]);
      }
      else if (cover > 0.0f && !isLast)
      {
        const std::ptrdiff_t stride = axis == 0 ? 1
          : axis == 1                           ? this->Nodes[0]
                                                : this->Nodes[0] * this->Nodes[1];
        const std::size_t beside = node + step * stride;
        wall.IsFree[face] = this->Cover[beside] <= MostOpen && this->Cover[beside] < cover - 0.05f;
        place = this->GetPlace(beside);
      }
      int count = 0;
      double sum = 0.0;
      for (int sample = 0; sample < 4 && wall.IsFree[face] && wall.Albedo > 0.0f; ++sample)
      {
        Vec3 seen = place;
        for (int i = 1; i < 3; ++i) // on the face, of which a part may be beyond the box
        {
          const int side = (axis + i) % 3;
          const double quarter = 0.25 * this->Cell[side];
          seen[side] += sample >> (i - 1) & 1 ? quarter : -quarter;
          seen[side] =
            glm::clamp(seen[side], scene.Low[side] + quarter, scene.High[side] - quarter);
        }
        count += scene.Solid && scene.Solid(seen) >= 0.0 ? 0 : 1;
        for (std::size_t light = 0; light < scene.Lights.size(); ++light)
        {
          Vec3 towards;
          Vec3 events;
          const Vec3 arriving =
            this->GetArriving(light, seen, Nearest * this->Unit, towards, events);
          sum += arriving[color] * std::max(step * towards[axis], 0.0);
        }
      }
      wall.Direct[face] = static_cast<float>(sum / std::max(count, 1));
    }
    if (cover > 0.0f || wall.IsFace)
    {
      walls.push_back(wall);
    }
  }
  return walls;
}

// Finds the diffuse radiance that sends itself: moments, and the irradiance of walls, are one vector.
void vtkGodRaysMultipleScattering::vtkInternals::Solve(int color)
{
  Channel& channel = this->Channels[color];
  this->Ordinates.SetWalls(this->MakeWalls(color));
  const std::size_t count = this->CountMoments() * this->Size;
  std::vector<float>& irradiance = this->Ordinates.GetIrradiance();
  std::vector<float> x(count + irradiance.size(), 0.0f);
  std::vector<float> next(x.size());
  std::vector<float> emission(count);
  vtkGodRaysFixedPoint iteration;
  for (this->Last.Sweeps = 1;; ++this->Last.Sweeps)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t degree = GetDegree(static_cast<int>(i / this->Size));
      emission[i] =
        channel.Emission[i] + channel.Scattering[degree * this->Size + i % this->Size] * x[i];
    }
    std::copy(x.begin() + count, x.end(), irradiance.begin());
    this->Ordinates.Sweep(
      channel.Extinction.data(), emission.data(), this->Settings.Degree, next.data());
    std::copy(irradiance.begin(), irradiance.end(), next.begin() + count);
    const auto compare = [&](std::size_t begin, std::size_t end)
    {
      float change = 0.0f;
      float largest = 1e-30f;
      for (std::size_t i = begin; i < end; ++i)
      {
        change = std::max(change, std::abs(next[i] - x[i]));
        largest = std::max(largest, std::abs(next[i]));
      }
      return static_cast<double>(change / largest);
    };
    this->Last.Residual = std::max(compare(0, this->Size), compare(count, x.size()));
    if (this->Last.Residual < this->Settings.Residual ||
      this->Last.Sweeps >= this->Settings.MaximumSweeps)
    {
      break;
    }
    iteration.Advance(x, next);
  }
  next.resize(count);
  channel.Moments = std::move(next);
}

// Gives nodes inside occluders the mean of their neighbours on the eye's side, where view rays come from that
// end there.
void vtkGodRaysMultipleScattering::vtkInternals::FillOpaque(
  const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const
{
  std::vector<float> cover = this->Cover;
  std::vector<float> left = cover;
  for (std::size_t i = 0; i < 2 * this->Size; ++i)
  {
    const std::size_t node = i % this->Size;
    if (i == this->Size)
    {
      cover = left; // a second pass, from what the first has filled
    }
    int at[3];
    this->GetIndices(node, at);
    const Vec3 towards = parallel ? -forward : eye - this->GetPlace(node);
    Vec3 sum(0.0);
    double weights = 0.0;
    for (int face = 0; face < 6 && cover[node] > MostOpen; ++face)
    {
      const int step = face % 2 ? 1 : -1;
      const int next = at[face / 2] + step;
      const double ahead = step * towards[face / 2];
      const std::size_t other = this->GetBeside(node, face);
      if (ahead > 0.0 && next >= 0 && next < this->Nodes[face / 2] && cover[other] <= MostOpen)
      {
        const float* const value = texture.Values.data() + 3 * other;
        sum += ahead * Vec3(value[0], value[1], value[2]);
        weights += ahead;
      }
    }
    for (int c = 0; c < 3 && weights > 0.0; ++c)
    {
      texture.Values[3 * node + c] = static_cast<float>(sum[c] / weights);
      left[node] = 0.0f;
    }
  }
}

vtkGodRaysMultipleScattering::vtkGodRaysMultipleScattering()
  : Internals(std::make_unique<vtkInternals>())
{
}
vtkGodRaysMultipleScattering::~vtkGodRaysMultipleScattering() = default;

vtkGodRaysMultipleScattering::Parameters vtkGodRaysMultipleScattering::Choose(
  double tolerance, double depth, double asymmetry)
{
  Parameters result;
  if (depth > 1.0 || (tolerance < 1e-3 && (depth > 0.3 || std::abs(asymmetry) > 0.5)))
  {
    result.Cells = tolerance < 1e-3 ? 32 : 24;
    result.Directions = 98;
    result.Degree = 3;
  }
  return result;
}

bool vtkGodRaysMultipleScattering::Update(const Scene& scene, const Parameters& parameters)
{
  vtkInternals& in = *this->Internals;
  const Parameters& last = in.Settings;
  if (in.IsSolved && in.Input.Version == scene.Version && last.Cells == parameters.Cells &&
    last.Directions == parameters.Directions && last.Degree == parameters.Degree &&
    last.Residual == parameters.Residual && last.MaximumSweeps == parameters.MaximumSweeps)
  {
    return false;
  }
  in.Input = scene;
  in.Settings = parameters;
  in.IsSolved = true;
  in.Prepare();
  in.SetGrid();
  for (vtkInternals::Channel& channel : in.Channels)
  {
    channel.Extinction.assign(in.Size, 0.0f);
    channel.Scattering.assign((parameters.Degree + 1) * in.Size, 0.0f);
    channel.Emission.assign(in.CountMoments() * in.Size, 0.0f);
  }
  in.Cover.assign(in.Size, 0.0f);
  in.Albedo.assign(in.Size, 0.0f);
  const std::size_t lights = in.ForwardPeak.ForwardPart > 0.0 ? scene.Lights.size() : 0;
  in.Arriving.assign(3 * lights * in.Size, 0.0f);
  in.Passed.assign(3 * lights * in.Size, 0.0f);
  ForNodes(in.Size, [&](std::size_t node) { in.SampleNode(node); });
  if (scene.Cover)
  {
    scene.Cover(in.Nodes, scene.Low, in.Cell, in.Cover);
    std::transform(in.Cover.begin(), in.Cover.end(), in.Cover.begin(),
      [](float stopped) { return std::min(stopped, 1.0f) / Wider; });
  }
  for (int c = 0; c < 3; ++c)
  {
    // Colours that are alike, but for a factor of the light, are solved once.
    vtkInternals::Channel& channel = in.Channels[c];
    const vtkInternals::Channel& first = in.Channels[0];
    const double all =
      std::accumulate(first.Emission.begin(), first.Emission.begin() + in.Size, 0.0);
    const float factor = static_cast<float>(
      std::accumulate(channel.Emission.begin(), channel.Emission.begin() + in.Size, 0.0) /
      std::max(all, 1e-300));
    const bool isAlike = c > 0 && all > 0.0 && channel.Extinction == first.Extinction &&
      channel.Scattering == first.Scattering &&
      std::equal(channel.Emission.begin(), channel.Emission.end(), first.Emission.begin(),
        [&](float a, float b) { return std::abs(a - factor * b) <= 1e-5f * std::abs(a); });
    if (!isAlike)
    {
      in.Solve(c);
      continue;
    }
    channel.Moments = first.Moments;
    for (float& moment : channel.Moments)
    {
      moment *= factor;
    }
  }
  return true;
}

void vtkGodRaysMultipleScattering::Contract(
  const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const
{
  const vtkInternals& in = *this->Internals;
  std::copy_n(in.Nodes, 3, texture.Nodes);
  texture.Low = in.Input.Low;
  texture.Cell = in.Cell;
  texture.Values.assign(3 * in.Size, 0.0f);
  // Where there is no medium, S is that of the mean medium: rays at its edge are between such nodes.
  std::array<double, 12> means = { 0.0 };
  for (int i = 0; i < 3 * (in.Settings.Degree + 1); ++i)
  {
    const auto values = in.Channels[i % 3].Scattering.begin() + (i / 3) * in.Size;
    means[i] = std::accumulate(values, values + in.Size, 0.0);
  }
  ForNodes(in.Size,
    [&](std::size_t node)
    {
      // Nodes near the eye are for rays that begin between them, all of which go forward: they see an eye
      // a cell behind.
      Vec3 towards = eye - in.GetPlace(node);
      const double closeness = 2.0 - vtkGodRays::length(towards) / in.Unit;
      towards -= in.Unit * glm::clamp(closeness, 0.0, 1.0) * forward;
      towards = parallel ? -forward : towards / std::max(vtkGodRays::length(towards), 1e-300);
      float harmonics[MaximumMoments];
      vtkGodRaysOrdinates::GetHarmonics(towards, in.Settings.Degree, harmonics);
      for (int c = 0; c < 3; ++c)
      {
        const vtkInternals::Channel& channel = in.Channels[c];
        const bool isVoid = channel.Scattering[node] <= 0.0f;
        const double whole = isVoid ? means[c] : channel.Scattering[node];
        double sum = 0.0;
        for (int m = 0; m < in.CountMoments() && whole > 0.0; ++m)
        {
          const int l = vtkInternals::GetDegree(m);
          const double part = isVoid ? means[3 * l + c] : channel.Scattering[l * in.Size + node];
          sum += part / whole * harmonics[m] * channel.Moments[m * in.Size + node];
        }
        texture.Values[3 * node + c] = static_cast<float>(sum);
      }
    });
  in.FillOpaque(eye, forward, parallel, texture);
}

void vtkGodRaysMultipleScattering::FindSource(
  const Vec3& eye, const Vec3& forward, bool parallel, Texture& texture) const
{
  const vtkInternals& in = *this->Internals;
  this->Contract(eye, forward, parallel, texture);
  const double f = texture.ForwardPart = in.ForwardPeak.ForwardPart;
  const Scene& scene = in.Input;
  const Vec3 last(in.Nodes[0] - 1, in.Nodes[1] - 1, in.Nodes[2] - 1);
  constexpr int steps =
    8; // of a node's way to the eye: peaks change slowly with the number of events
  const auto add = [&](std::size_t node)
  {
    const Vec3 place = in.GetPlace(node);
    Vec3 way = parallel ? -2.0 * vtkGodRays::length(scene.High - scene.Low) * forward : eye - place;
    const double distance = std::max(vtkGodRays::length(way), 1e-300);
    double begin = 0.0;
    double end = 1.0;
    scene.Clip(place, way, begin, end); // beyond the box media are not known
    Vec3 events(0.0);
    for (int i = 0; i < steps; ++i)
    {
      const Vec3 at = vtkGodRays::clamp(
        (place + end * (i + 0.5) / steps * way - scene.Low) / in.Cell + 0.5, Vec3(0.0), last);
      const std::size_t nearest =
        (static_cast<std::size_t>(at.z) * in.Nodes[1] + static_cast<std::size_t>(at.y)) *
          in.Nodes[0] +
        static_cast<std::size_t>(at.x);
      for (int c = 0; c < 3; ++c)
      {
        events[c] += in.Channels[c].Scattering[nearest];
      }
    }
    events *= f / (1.0 - f) * end * distance / (steps * in.Unit);
    for (int c = 0; c < 3; ++c)
    {
      float& value = texture.Values[3 * node + c];
      value *= static_cast<float>(1.0 - f);
      for (std::size_t k = 0; k < scene.Lights.size() && f > 0.0; ++k)
      {
        const std::size_t at = 3 * (k * in.Size + node) + c;
        if (in.Arriving[at] > 0.0f)
        {
          double unused;
          Vec3 towards;
          scene.GetIrradiance(scene.Lights[k], place, towards, unused);
          value += in.Arriving[at] *
            static_cast<float>(in.ForwardPeak.Get(
              -vtkGodRays::dot(towards, way) / distance, in.Passed[at] + events[c]));
        }
      }
    }
  };
  ForNodes(in.Size, add);
  in.FillOpaque(eye, forward, parallel, texture);
}

const vtkGodRaysForwardPeak& vtkGodRaysMultipleScattering::GetPeak() const
{
  return this->Internals->ForwardPeak;
}

vtkGodRaysMultipleScattering::Result vtkGodRaysMultipleScattering::Evaluate(
  const Texture& texture, const Ray& ray, int steps) const
{
  const vtkInternals& in = *this->Internals;
  Result result;
  double begin = 0.0;
  double end = ray.End;
  in.Input.Clip(ray.Origin, ray.Direction, begin, end);
  const double step = std::max(end - begin, 0.0) / steps;
  const vtkGodRaysForwardPeak& peak = in.ForwardPeak;
  Vec3 depth(0.0);  // scaled, to the eye
  Vec3 passed(0.0); // events of the peak on this way
  for (int i = 0; i < steps && step > 0.0; ++i)
  {
    const Vec3 place = ray.Origin + (begin + (i + 0.5) * step) * ray.Direction;
    Vec3 scatters(0.0);
    Vec3 dims(0.0);
    for (int k = 0; k < in.Input.GetNumberOfComponents(); ++k)
    {
      const Scene::Point point = in.Input.Sample(k, place);
      scatters += point.Scattering;
      dims += point.Extinction - peak.ForwardPart * point.Scattering;
    }
    const Vec3 events = step * peak.ForwardPart * scatters;
    Vec3 lit(0.0);
    Vec3 broad(0.0);
    for (std::size_t light = 0; light < in.Input.Lights.size() && scatters != Vec3(0.0); ++light)
    {
      Vec3 towards;
      Vec3 before(0.0);
      const Vec3 arriving = in.GetArriving(light, place, 1e-9 * in.Unit, towards, before);
      for (int c = 0; c < 3; ++c)
      {
        const double part = arriving[c] *
          peak.Get(
            vtkGodRays::dot(towards, ray.Direction), before[c] + passed[c] + 0.5 * events[c]);
        lit[c] += part;
        broad[c] += std::max(part, 0.0);
      }
    }
    const Vec3 source = texture.Sample(place);
    for (int c = 0; c < 3; ++c)
    {
      const double weight =
        step * std::exp(-depth[c]) * vtkGodRays::MeanExponential(dims[c] * step);
      result.Orders[c] +=
        weight * vtkGodRays::OrdersPart(scatters[c], peak.ForwardPart, lit[c], source[c]);
      result.Broad[c] += weight * scatters[c] * broad[c];
    }
    depth += step * dims;
    passed += events;
  }
  return result;
}

double vtkGodRaysMultipleScattering::Estimate(
  const std::vector<Ray>& rays, const Vec3& forward, bool parallel, int steps)
{
  vtkInternals& in = *this->Internals;
  Parameters variants[3] = { in.Settings, in.Settings, in.Settings };
  variants[0].Cells = std::max(in.Settings.Cells / 2, 2);
  variants[1].Directions = in.Settings.Directions > 50 ? 26 : 14;
  variants[2].Degree = std::max(in.Settings.Degree - 1, 1);
  const vtkGodRaysMultipleScattering* solutions[4] = { this };
  Texture textures[4];
  for (int i = 0; i < 4 && !rays.empty(); ++i)
  {
    if (i > 0)
    {
      in.Cheaper[i - 1] = in.Cheaper[i - 1] ? std::move(in.Cheaper[i - 1])
                                            : std::make_unique<vtkGodRaysMultipleScattering>();
      in.Cheaper[i - 1]->Update(in.Input, variants[i - 1]);
      solutions[i] = in.Cheaper[i - 1].get();
    }
    solutions[i]->Contract(rays.front().Origin, forward, parallel, textures[i]);
  }
  double squares = 0.0;
  for (const Ray& ray : rays)
  {
    const Result result = this->Evaluate(textures[0], ray, steps);
    Vec3 sum = 0.1 * result.Broad + in.Last.Residual * vtkGodRays::abs(result.Orders);
    for (int i = 1; i < 4; ++i)
    {
      sum += 2.0 *
        vtkGodRays::abs(solutions[i]->Evaluate(textures[i], ray, steps).Orders - result.Orders);
    }
    const double own = std::max({ sum.x, sum.y, sum.z });
    squares += own * own;
  }
  return std::sqrt(squares / std::max<double>(static_cast<double>(rays.size()), 1.0));
}

const vtkGodRaysMultipleScattering::Report& vtkGodRaysMultipleScattering::GetReport() const
{
  return this->Internals->Last;
}

const std::vector<float>& vtkGodRaysMultipleScattering::GetMoments(int color) const
{
  return this->Internals->Channels[color].Moments;
}
