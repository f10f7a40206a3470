// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAirlight.h"

#include "vtkGodRaysPhaseTable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace
{
using namespace vtkGodRays;
using Component = vtkGodRaysMedium::Component;

// A point light is no nearer to a view ray than that: 1/distance is then the mean over its pixel [pixels].
constexpr double NearestPass = 0.28;

// A spotlight's light ends where no more than that is left of it.
constexpr double LeastFade = 1e-5;

// Steps over which a spotlight's fade is a constant: at least, what is added for one that fades to nothing
// over the root of the tolerance, as the error is in proportion to the step's square, and at most.
constexpr double LeastSteps = 2.0;
constexpr double MoreSteps = 0.25;
constexpr double MostSteps = 28.0; // room for two parts in a batch
constexpr int FadeEntries = 2048;

// Places that are evaluated together.
constexpr int Batch = 64;

// e^-x for x from 0 to 80, to 2e-7, in a loop that compilers vectorise.
inline float ExpMinus(float x)
{
  const float turns = x * 1.44269504f;
  const int whole = static_cast<int>(turns + 0.5f);
  const float f = (static_cast<float>(whole) - turns) * 0.69314718f;
  const float fraction = 1.0f +
    f *
      (1.0f +
        f * (0.5f + f * (1.0f / 6.0f + f * (1.0f / 24.0f + f * (1.0f / 120.0f + f / 720.0f)))));
  const std::int32_t bits = (127 - whole) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return fraction * scale;
}

bool IsGrey(const double* color)
{
  return color[0] == color[1] && color[1] == color[2];
}

}

void vtkGodRaysAirlight::Prepare(const Scene& scene)
{
  this->Setup = scene;
  const vtkGodRaysMedium& medium = scene.Medium;
  const bool layered = medium.HasExponentialDensity();
  this->IsPlanet = layered && medium.PlanetRadius > 0.0;
  if (!this->IsPlanet)
  {
    this->Setup.Medium.PlanetRadius = 0.0;
  }
  if (!scene.Point)
  {
    this->Setup.Spot = vtkGodRaysSpot();
  }
  const double away = std::max(length(ToVector(scene.Light)), 1e-30);
  this->Setup.Nearest = std::max(
    NearestPass * scene.PixelSize * (scene.Parallel ? 1.0 : scene.Light[2] * scene.Light[2] / away),
    1e-9 * medium.FarLimit);
  const Vec3 up = ToVector(medium.Up);
  this->Setup.LightHeight =
    MediumStart(this->Setup.Medium.PlanetRadius, medium.EyeHeight, up, ToVector(scene.Light), up).x;
  this->FindPlanetShadow();
  this->MakeFade();
  bool grey = true;
  bool alike = true; // whether components scatter all colours in one proportion
  double total[3] = { 0.0, 0.0, 0.0 };
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const Component& component = medium.Components[k];
    alike = alike &&
      (IsGrey(component.Scattering) ||
        (medium.NumberOfComponents == 1 && component.Scattering[0] > 0.0));
    double extinction[3];
    for (int c = 0; c < 3; ++c)
    {
      extinction[c] = component.Scattering[c] + component.Absorption[c];
      total[c] += extinction[c];
    }
    grey = grey && IsGrey(extinction);
  }
  this->Setup.Channels =
    (layered ? grey : IsGrey(total)) && (alike || !scene.Point) && !scene.Colored ? 1 : 3;
  this->Setup.Components = layered && !scene.Point ? medium.NumberOfComponents : 1;
  this->Closed = !layered && !scene.Point;
  for (int c = 0; c < 3; ++c)
  {
    // So clear a medium cannot be told from none; and numbers are those of single precision.
    this->Extinction[c] =
      static_cast<float>(std::min(std::max(total[c], 1e-9 / medium.FarLimit), 1e30));
  }
  for (int k = 0; k < (scene.Point ? 0 : medium.NumberOfComponents); ++k)
  {
    MakePhaseTable(medium.Components[k], this->Phases[k]);
  }
  if (this->Closed)
  {
    this->Table.Clear();
    return;
  }
  this->Table.Prepare(this->Setup);
}

void vtkGodRaysAirlight::Evaluate(int count, const float* x, const float* y, const float* distances,
  float* values, float* lights) const
{
  if (!this->HasParts())
  {
    this->EvaluateWhole(count, x, y, distances, values, count);
    if (lights)
    {
      std::fill_n(lights, this->GetNumberOfPlanes() * count, 1.0f);
    }
    return;
  }
  for (int first = 0; first < count;)
  {
    first += this->EvaluateParts(count - first, x + first, y + first, distances + first,
      values + first, lights ? lights + first : nullptr, count);
  }
}

// Reads parts in steps, over which the light fades by its mean; the last step ends at the distance. Returns
// the number of places that were evaluated, as there is room for so many samples only.
int vtkGodRaysAirlight::EvaluateParts(int count, const float* x, const float* y,
  const float* distances, float* values, float* lights, int stride) const
{
  float xs[Batch];
  float ys[Batch];
  float places[Batch];
  float fades[Batch]; // from a place to the next one
  struct
  {
    bool IsNew;   // whether its ray is not that of the place before
    int Nodes[2]; // the begins of a ray's steps, and the ends of its parts
    int Step;     // that its distance is in; -1 before all
    int Sample;   // of the distance
    float Fade;   // from the step's begin to there
  } of[Batch];
  LitRay ray = {};
  int samples = 0;
  int number = 0;
  for (; number < count; ++number)
  {
    auto& own = of[number];
    const bool isNew = own.IsNew =
      number == 0 || x[number] != x[number - 1] || y[number] != y[number - 1];
    if (samples + (isNew ? this->MaximumNumberOfParts * (this->Steps + 1) : 0) >= Batch)
    {
      break;
    }
    const int begin = samples;
    if (isNew)
    {
      double parts[MaximumParts][2];
      ray = this->MakeRay(x[number], y[number]);
      const int partsOfRay = this->GetParts(ray, x[number], y[number], parts);
      for (int k = 0; k < partsOfRay; ++k)
      {
        samples += this->AddSteps(
          ray, this->Steps, parts[k][0], parts[k][1], places + samples, fades + samples);
        places[samples] = static_cast<float>(parts[k][1]);
        fades[samples++] = 0.0f;
      }
    }
    own.Nodes[0] = isNew ? begin : of[number - 1].Nodes[0];
    own.Nodes[1] = isNew ? samples : of[number - 1].Nodes[1];
    own.Step = own.Nodes[0] - 1;
    while (own.Step + 1 < own.Nodes[1] && places[own.Step + 1] <= distances[number])
    {
      ++own.Step;
    }
    own.Sample = own.Step;
    own.Fade = 0.0f;
    if (own.Step >= own.Nodes[0] && fades[own.Step] > 0.0f && places[own.Step] < distances[number])
    {
      own.Sample = samples;
      this->AddSteps(ray, 1, places[own.Step], distances[number], places + samples, &own.Fade);
      places[samples++] = distances[number];
    }
    std::fill(xs + begin, xs + samples, x[number]);
    std::fill(ys + begin, ys + samples, y[number]);
  }
  float read[MaximumPlanes * Batch];
  if (samples > 0)
  {
    this->EvaluateWhole(samples, xs, ys, places, read, samples);
  }
  for (int p = 0; p < this->GetNumberOfPlanes(); ++p)
  {
    const float* at = read + static_cast<std::ptrdiff_t>(p) * samples;
    float sums[Batch] = {}; // up to nodes
    float sum = 0.0f;
    for (int i = 0; i < number; ++i)
    {
      if (of[i].IsNew)
      {
        sum = 0.0f;
        for (int k = of[i].Nodes[0]; k + 1 < of[i].Nodes[1]; ++k)
        {
          sums[k] = sum;
          sum += fades[k] * std::max(at[k + 1] - at[k], 0.0f);
          sums[k + 1] = sum;
        }
      }
      const int step = of[i].Step;
      const float before = step < of[i].Nodes[0]
        ? 0.0f
        : sums[step] + of[i].Fade * std::max(at[of[i].Sample] - at[step], 0.0f);
      values[static_cast<std::ptrdiff_t>(p) * stride + i] =
        sum > 0.0f ? std::min(before / sum, 1.0f) : 0.0f;
      if (lights)
      {
        lights[static_cast<std::ptrdiff_t>(p) * stride + i] = sum;
      }
    }
  }
  return number;
}

// The begins of steps over a part of a ray, and the light's fade over them. Returns their number.
int vtkGodRaysAirlight::AddSteps(
  const LitRay& ray, int steps, double begin, double end, float* places, float* fades) const
{
  if (this->Fade.empty())
  {
    places[0] = static_cast<float>(begin);
    fades[0] = 1.0f;
    return 1;
  }
  PointRay<double> coordinates;
  coordinates.Foot = ray.Foot;
  coordinates.Height = std::max(ray.Distance, this->Setup.Nearest);
  const double first = coordinates.GetCoordinate(begin);
  const double step = (coordinates.GetCoordinate(end) - first) / steps;
  const float scale =
    static_cast<float>(this->Fade.size() - 2) / static_cast<float>(1.0 - this->CosLit);
  const auto getFade = [&](double distance)
  {
    const double beyond = distance - ray.Foot;
    const double r = std::max(std::sqrt(ray.Distance * ray.Distance + beyond * beyond), 1e-30);
    const double cosine = (ray.AxisStart + ray.AxisSlope * distance) / r;
    const float entry =
      scale * static_cast<float>(std::min(std::max(cosine, this->CosLit), 1.0) - this->CosLit);
    const int i = std::min(static_cast<int>(entry), static_cast<int>(this->Fade.size()) - 2);
    return this->Fade[i] + (entry - static_cast<float>(i)) * (this->Fade[i + 1] - this->Fade[i]);
  };
  float last = getFade(begin);
  for (int i = 0; i < steps; ++i)
  {
    places[i] = static_cast<float>(i == 0 ? begin : coordinates.GetDistance(first + i * step));
    const float middle = getFade(coordinates.GetDistance(first + (i + 0.5) * step));
    const float next =
      getFade(i + 1 < steps ? coordinates.GetDistance(first + (i + 1) * step) : end);
    fades[i] = (last + 4.0f * middle + next) / 6.0f; // Simpson's rule
    last = next;
  }
  return steps;
}

// Airlight of a closed form or the table, as if no part of a ray were dark.
void vtkGodRaysAirlight::EvaluateWhole(int count, const float* x, const float* y,
  const float* distances, float* values, int stride) const
{
  if (!this->Closed)
  {
    this->Table.Evaluate(count, x, y, distances, values, stride);
  }
  for (int c = 0; this->Closed && c < this->Setup.Channels; ++c)
  {
    const float extinction = this->Extinction[c];
    const float inverse = 1.0f / extinction;
    float* to = values + static_cast<std::ptrdiff_t>(c) * stride;
    for (int i = 0; i < count; ++i)
    {
      // (1 - e^-k)/extinction, by its series where that would lose figures.
      const float k = std::min(extinction * distances[i], 80.0f);
      const float series =
        k * (1.0f - k * (0.5f - k * (1.0f / 6.0f - k * (1.0f / 24.0f - k * (1.0f / 120.0f)))));
      to[i] = (k < 0.2f ? series : 1.0f - ExpMinus(k)) * inverse;
    }
  }
}

// Describes a view ray as the light meets it.
LitRay vtkGodRaysAirlight::MakeRay(double x, double y) const
{
  double start[3];
  double way[3];
  this->Setup.GetRay(x, y, start, way);
  const Vec3 direction = ToVector(way);
  const Vec3 light = ToVector(this->Setup.Light);
  const Vec3 to = this->Setup.Point ? light - ToVector(start) : light;
  const Vec3 axis = ToVector(this->Setup.Spot.Axis);
  LitRay ray = {};
  ray.Infinite = this->Setup.Point ? 0 : 1;
  ray.Foot = dot(to, direction);
  ray.Distance = this->Setup.Point ? length(cross(to, direction)) : 0.0;
  ray.AxisStart = -dot(axis, to);
  ray.AxisSlope = dot(axis, direction);
  ray.Shape.CosCone = this->CosLit;
  ray.ThroughGround = 1;
  return ray;
}

double vtkGodRaysAirlight::GetEnd(double x, double y, double distance) const
{
  const vtkGodRaysMedium& medium = this->Setup.Medium;
  double start[3];
  double way[3];
  this->Setup.GetRay(x, y, start, way);
  LitRay ray = {};
  const Vec2 begin = MediumStart(
    medium.PlanetRadius, medium.EyeHeight, ToVector(medium.Up), ToVector(start), ToVector(way));
  ray.Height = begin.x;
  ray.Slope = begin.y;
  ray.PlanetRadius = medium.PlanetRadius;
  return MediumEnd(ray, distance);
}

int vtkGodRaysAirlight::GetParts(double x, double y, double parts[MaximumParts][2]) const
{
  return this->GetParts(this->MakeRay(x, y), x, y, parts);
}

int vtkGodRaysAirlight::GetParts(
  const LitRay& ray, double x, double y, double parts[MaximumParts][2]) const
{
  const Vec2 part =
    SpotPart(ray, this->Setup.Medium.FarLimit * this->Setup.GetLengthPerDepth(x, y));
  parts[0][0] = part.x;
  parts[0][1] = part.y;
  if (!(part.y > part.x) || (this->IsPlanet && this->Setup.Point && this->Setup.LightHeight < 0.0))
  {
    return 0;
  }
  if (!this->HasPlanetShadow)
  {
    return 1;
  }
  const Vec2 dark = clamp(this->GetPlanetShadow(x, y, part.y), Vec2(part.x), Vec2(part.y));
  if (!(dark.y > dark.x))
  {
    return 1;
  }
  int count = 0;
  if (dark.x > part.x)
  {
    parts[count][0] = part.x;
    parts[count++][1] = dark.x;
  }
  if (part.y > dark.y)
  {
    parts[count][0] = dark.y;
    parts[count++][1] = part.y;
  }
  return count;
}

// The part of a ray from which a planet hides the light: behind it in a cylinder, or in a cone about a point
// light.
Vec2 vtkGodRaysAirlight::GetPlanetShadow(double x, double y, double end) const
{
  const Scene& setup = this->Setup;
  const double radius = setup.Medium.PlanetRadius;
  double start[3];
  double way[3];
  this->Setup.GetRay(x, y, start, way);
  const Vec3 center = -(radius + setup.Medium.EyeHeight) * ToVector(setup.Medium.Up);
  const Vec3 light = ToVector(setup.Light);
  const Vec3 direction = ToVector(way);
  if (setup.Point)
  {
    const Vec3 toCenter = center - light;
    const double distance = length(toCenter);
    const double room = this->Setup.LightHeight * (2.0 * radius + this->Setup.LightHeight);
    const Vec3 axis = toCenter / distance;
    LitRay ray = this->MakeRay(x, y);
    ray.AxisStart = dot(axis, ToVector(start) - light);
    ray.AxisSlope = dot(axis, direction);
    ray.Shape.CosCone = std::max(std::sqrt(room) / distance, 1e-9);
    const Vec2 dark = SpotPart(ray, end);
    const double beyond = room / distance - ray.AxisStart; // of the plane of all tangents' ends
    const double at = beyond / (std::abs(ray.AxisSlope) > 1e-12 ? ray.AxisSlope : 1e-12);
    return ray.AxisSlope > 0.0 ? Vec2(std::max(dark.x, at), dark.y)
                               : Vec2(dark.x, std::min(dark.y, at));
  }
  const Vec3 from = ToVector(start) - center;
  const Vec3 across = from - dot(from, light) * light;
  const Vec3 aside = direction - dot(direction, light) * light;
  const double a = std::max(dot(aside, aside), 1e-18);
  const double b = dot(across, aside);
  const double root = b * b - a * (dot(across, across) - radius * radius);
  if (root <= 0.0)
  {
    return Vec2(0.0, 0.0);
  }
  const double slope = dot(direction, light);
  const double at = -dot(from, light) / (std::abs(slope) > 1e-12 ? slope : 1e-12);
  const Vec2 dark((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
  return slope > 0.0 ? Vec2(dark.x, std::min(dark.y, at)) : Vec2(std::max(dark.x, at), dark.y);
}

// None of a sun where it is higher over the eye than what can be seen is wide.
void vtkGodRaysAirlight::FindPlanetShadow()
{
  const Scene& setup = this->Setup;
  const vtkGodRaysMedium& medium = setup.Medium;
  double reach = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    double start[3];
    double way[3];
    const double x = corner % 2 == 0 ? 0.0 : setup.Size[0] + 8.0;
    const double y = corner / 2 == 0 ? 0.0 : setup.Size[1] + 8.0;
    this->Setup.GetRay(x, y, start, way);
    reach = std::max(
      reach, length(ToVector(start)) + medium.FarLimit * this->Setup.GetLengthPerDepth(x, y));
  }
  const double rise = dot(ToVector(medium.Up), ToVector(setup.Light));
  this->HasPlanetShadow =
    this->IsPlanet && (setup.Point || (medium.PlanetRadius + medium.EyeHeight) * rise < reach);
  this->MaximumNumberOfParts = this->HasPlanetShadow ? MaximumParts : 1;
}

// The cone of a light that fades ends where next to nothing is left of it.
void vtkGodRaysAirlight::MakeFade()
{
  const vtkGodRaysSpot& spot = this->Setup.Spot;
  this->Fade.clear();
  this->Steps = 1;
  this->CosLit = spot.CosCone;
  if (!spot.Fades())
  {
    return;
  }
  this->CosLit = std::max(this->CosLit, std::pow(LeastFade, 1.0 / spot.Exponent));
  const double least = std::pow(this->CosLit, spot.Exponent);
  const double more = MoreSteps * (1.0 - least) / std::sqrt(std::max(this->Setup.Tolerance, 1e-9));
  this->Steps = static_cast<int>(std::ceil(std::min(LeastSteps + more, MostSteps)));
  this->Fade.resize(FadeEntries);
  for (int i = 0; i < FadeEntries; ++i)
  {
    const double cosine = this->CosLit + (1.0 - this->CosLit) * i / (FadeEntries - 2.0);
    this->Fade[i] = static_cast<float>(std::pow(std::min(cosine, 1.0), spot.Exponent));
  }
}

void vtkGodRaysAirlight::GetFactors(double y, int first, int count, float* factors) const
{
  for (int begin = 0; begin < count; begin += Batch)
  {
    const int number = std::min(Batch, count - begin);
    if (this->Setup.Point)
    {
      this->GetPointFactors(static_cast<float>(y), first + begin, number, factors + begin, count);
    }
    else
    {
      this->GetPhaseFactors(static_cast<float>(y), first + begin, number, factors + begin, count);
    }
  }
  if (this->Closed)
  {
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    float totals[MaximumPlanes];
    this->Table.GetTotals(static_cast<float>(first + i), static_cast<float>(y), totals);
    for (int k = 0; k < this->Setup.Components; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int p = k * this->Setup.Channels + (this->Setup.Channels == 3 ? c : 0);
        factors[static_cast<std::ptrdiff_t>(3 * k + c) * count + i] *= totals[p];
      }
    }
  }
}

// The light's intensity is that of a medium without extinction; colours that one component scatters are in
// proportion to the first, if one channel serves them.
void vtkGodRaysAirlight::GetPointFactors(
  float y, int first, int count, float* factors, int stride) const
{
  const double* scattering = this->Setup.Medium.Components[0].Scattering;
  for (int i = 0; i < count; ++i)
  {
    float foot;
    float height;
    float end;
    this->Setup.GetPass(static_cast<float>(first + i), y, foot, height, end);
    const float adjacent = height * height - foot * (end - foot);
    const float unit = std::atan2(height * end, adjacent) / height;
    for (int c = 0; c < 3; ++c)
    {
      factors[static_cast<std::ptrdiff_t>(c) * stride + i] =
        this->Setup.Channels == 1 ? unit * static_cast<float>(scattering[c] / scattering[0]) : unit;
    }
  }
}

void vtkGodRaysAirlight::GetPhaseFactors(
  float y, int first, int count, float* factors, int stride) const
{
  const vtkGodRaysMedium& medium = this->Setup.Medium;
  const float pixel = static_cast<float>(this->Setup.PixelSize);
  const float py = (y - static_cast<float>(this->Setup.Center[1])) * pixel;
  const float light[3] = { static_cast<float>(this->Setup.Light[0]),
    static_cast<float>(this->Setup.Light[1]), static_cast<float>(this->Setup.Light[2]) };
  float sines[Batch]; // of half the angle
  float cosines[Batch];
  for (int i = 0; i < count; ++i)
  {
    const float px =
      (static_cast<float>(first + i) - static_cast<float>(this->Setup.Center[0])) * pixel;
    const float x = this->Setup.Parallel ? 0.0f : px;
    const float z = this->Setup.Parallel ? 0.0f : py;
    const float inverse = 1.0f / std::sqrt(1.0f + x * x + z * z);
    const float way[3] = { x * inverse, z * inverse, inverse };
    float less = 0.0f;
    float more = 0.0f;
    for (int k = 0; k < 3; ++k)
    {
      less += (way[k] - light[k]) * (way[k] - light[k]);
      more += (way[k] + light[k]) * (way[k] + light[k]);
    }
    sines[i] = 0.5f * std::sqrt(less);
    cosines[i] = 0.5f * std::sqrt(more);
  }
  for (int k = 0; k < this->Setup.Components; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      std::fill_n(factors + static_cast<std::ptrdiff_t>(3 * k + c) * stride, count, 0.0f);
    }
  }
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    const int plane = this->Setup.Components > 1 ? k : 0;
    const double* scattering = medium.Components[k].Scattering;
    for (int i = 0; i < count; ++i)
    {
      const float phase = LookUpPhase(this->Phases[k], sines[i], cosines[i]);
      for (int c = 0; c < 3; ++c)
      {
        factors[static_cast<std::ptrdiff_t>(3 * plane + c) * stride + i] +=
          phase * static_cast<float>(scattering[c]);
      }
    }
  }
}

std::string vtkGodRaysAirlight::Describe() const
{
  const int planes = this->GetNumberOfPlanes();
  return std::to_string(planes) + (planes > 1 ? " airlights of a " : " airlight of a ") +
    (this->Setup.Point ? "point light, " : "directional light, ") +
    (this->Setup.Medium.HasExponentialDensity() ? "layered" : "homogeneous") + " medium" +
    (this->IsPlanet ? " over a planet, " : ", ") +
    (this->Setup.Parallel ? "parallel projection, " : "perspective, ") +
    (this->Closed ? std::string("closed form") : this->Table.Describe());
}
