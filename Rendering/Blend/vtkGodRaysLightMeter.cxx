// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysLightMeter.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkGodRays::Vec3;

constexpr int Columns = 72;
constexpr int Rows = 48;

constexpr double LeastPart = 0.35;        // that dark data among lit ones leave of rays
constexpr double LeastPartOfMedium = 0.3; // that data leave of its light
constexpr double FewData = 0.005;         // fraction of the picture; fewer count as less

Vec3 ToVector(const std::array<double, 3>& color)
{
  return Vec3(color[0], color[1], color[2]);
}

Vec3 ToLab(const Vec3& light)
{
  return vtkGodRays::LabOfLight(glm::clamp(light, Vec3(0.0), Vec3(1.0)));
}

double GetChroma(const Vec3& lab)
{
  return std::hypot(lab.y, lab.z);
}

/**
 * How much the colours of data change with rays of some strength.
 */
class Fidelity
{
public:
  Fidelity(const std::vector<vtkGodRaysLightMeter::Sample>& samples, bool shoulder, bool limitsTint)
    : Shoulder(shoulder)
    , LimitsTint(limitsTint)
  {
    for (const auto& sample : samples)
    {
      const Vec3 base = ToVector(sample.Base);
      const Vec3 before = ToLab(base);
      const double lit = sample.DataPart *
        vtkGodRays::SeenPart(glm::clamp(ToVector(sample.Scene), Vec3(0.0), Vec3(1.0)));
      if (sample.DataPart > 0.0)
      {
        this->Data.push_back({ base, ToVector(sample.Rays), before, lit, sample.DataPart });
        this->Weight += lit;
        this->All += sample.DataPart;
        this->Chroma += lit * GetChroma(before);
        this->ChromaOfAll += sample.DataPart * GetChroma(before);
      }
    }
    const double few = FewData * static_cast<double>(samples.size());
    this->MostlyLit = glm::smoothstep(0.3, 0.6, this->Weight / std::max(this->All, few));
    this->Weight = std::max(this->Weight, few);
    this->All = std::max(this->All, few);
  }

  /// At most 1 each if colours are kept with a factor on all rays, and a further one over data that are lit:
  /// those of data that are lit, and, if most are, those of all data.
  std::array<double, 2> GetLosses(double exposure, double dataExposure) const
  {
    double difference = 0.0;
    double ofAll = 0.0;
    double chroma = 0.0;
    double chromaOfAll = 0.0;
    for (const Colors& each : this->Data)
    {
      const Vec3 rays = exposure * glm::mix(1.0, dataExposure, each.Weight) * each.Rays;
      const Vec3 after = ToLab(this->Shoulder ? vtkGodRays::BlendShoulder(each.Base, rays)
                                              : vtkGodRays::BlendAdd(each.Base, rays));
      const double change = glm::length(after - each.Before);
      difference += each.Weight * change;
      ofAll += each.Part * change;
      chroma += each.Weight * GetChroma(after);
      chromaOfAll += each.Part * GetChroma(after);
    }
    // Where there is hardly a colour, as in grey data, its chroma says nothing.
    const auto getLost = [](double now, double before, double weight)
    {
      return before > weight ? (1.0 - now / before) / (1.0 - vtkGodRaysLightMeter::LeastChroma)
                             : 0.0;
    };
    const double tint = std::max((1.0 - vtkGodRaysLightMeter::LeastChroma) * this->Chroma,
      vtkGodRaysLightMeter::MostTint * this->Weight);
    const double gained = this->LimitsTint ? chroma - this->Chroma : 0.0;
    const double loss = std::max({ difference / this->Weight / vtkGodRaysLightMeter::MostDifference,
      getLost(chroma, this->Chroma, this->Weight), gained / tint });
    const double lossOfAll = this->MostlyLit *
      std::max(ofAll / this->All / vtkGodRaysLightMeter::MostDifference,
        getLost(chromaOfAll, this->ChromaOfAll, this->All));
    return { loss, lossOfAll };
  }

private:
  struct Colors
  {
    Vec3 Base;
    Vec3 Rays;
    Vec3 Before;
    double Weight;
    double Part;
  };
  std::vector<Colors> Data;
  double Weight = 0.0;
  double All = 0.0;
  double MostlyLit = 0.0;
  double Chroma = 0.0;
  double ChromaOfAll = 0.0;
  bool Shoulder;
  bool LimitsTint;
};

/// The largest part, from 0 to 1, for which a loss that grows with it is about 1: false position with the
/// rule of Illinois.
template <typename Loss>
double FindPart(const Loss& getLoss)
{
  double high = 1.0;
  double above = getLoss(high) - 1.0;
  if (above <= 0.0)
  {
    return high;
  }
  double low = 0.0;
  double below = getLoss(low) - 1.0;
  if (below >= 0.0)
  {
    return low;
  }
  double part = low;
  for (int i = 0; i < 20; ++i)
  {
    part = (low * above - high * below) / (above - below);
    const double excess = getLoss(part) - 1.0;
    if (std::abs(excess) < 1e-3)
    {
      break;
    }
    if (excess > 0.0)
    {
      high = part;
      above = excess;
      below *= 0.5;
    }
    else
    {
      low = part;
      below = excess;
      above *= 0.5;
    }
  }
  return part;
}
}

//------------------------------------------------------------------------------
bool vtkGodRaysLightMeter::Read(
  vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->PushFramebufferBindings();
  this->Target.Prepare(request.Window, Columns, 3 * Rows, { GL_RGBA32F, 0 });
  bool done = this->Target.Bind();
  if (done)
  {
    vtkGodRaysBlendPass::Request metered = request;
    metered.Cells[0] = Columns;
    metered.Cells[1] = Rows;
    metered.Intensity = 1.0;
    const int whole[4] = { 0, 0, Columns, 3 * Rows };
    std::copy_n(whole, 4, metered.Viewport);
    done = blending->Draw(metered);
  }
  state->PopFramebufferBindings();
  if (!done)
  {
    return false;
  }
  const std::vector<float> pixels = this->Target.ReadColor();
  const std::size_t count = static_cast<std::size_t>(Columns) * Rows;
  const float* picture[3] = { pixels.data(), pixels.data() + 4 * count, pixels.data() + 8 * count };
  this->HasAlpha = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->HasAlpha =
      this->HasAlpha || (picture[0][4 * i + 3] == 0.0f && picture[1][4 * i + 3] >= 1.0f);
  }
  this->Samples.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Sample& sample = this->Samples[i];
    std::copy_n(picture[0] + 4 * i, 3, sample.Scene.begin());
    std::copy_n(picture[1] + 4 * i, 3, sample.Base.begin());
    std::copy_n(picture[2] + 4 * i, 3, sample.Rays.begin());
    sample.DataPart = picture[1][4 * i + 3] < 1.0f ? 1.0
      : this->HasAlpha                             ? glm::clamp(picture[0][4 * i + 3], 0.0f, 1.0f)
                                                   : 0.0;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysLightMeter::ShowsRays(double exposure) const
{
  return std::any_of(this->Samples.begin(), this->Samples.end(),
    [=](const Sample& sample)
    {
      const Vec3 base = ToVector(sample.Base);
      const Vec3 sum = vtkGodRays::BlendAdd(base, exposure * ToVector(sample.Rays));
      return ToLab(sum).x >= ToLab(base).x + 1.0;
    });
}

//------------------------------------------------------------------------------
vtkGodRaysLightMeter::Exposure vtkGodRaysLightMeter::FindExposure(
  const std::vector<Sample>& samples, bool shoulder, double largest, bool sparesData)
{
  Exposure result;
  result.Everywhere = largest;
  std::vector<double> brightest(samples.size());
  std::transform(samples.begin(), samples.end(), brightest.begin(),
    [](const Sample& sample) { return *std::max_element(sample.Rays.begin(), sample.Rays.end()); });
  double mean = 0.0;
  for (const double each : brightest)
  {
    mean += each / static_cast<double>(brightest.size());
  }
  if (!(mean > 0.0) || !std::isfinite(mean))
  {
    return result;
  }
  const auto rank = brightest.begin() + static_cast<std::ptrdiff_t>(0.99 * (brightest.size() - 1));
  std::nth_element(brightest.begin(), rank, brightest.end());
  result.Everywhere = std::min(largest, MostMean / mean);
  result.Everywhere =
    *rank > 0.0 ? std::min(result.Everywhere, MostBrightest / *rank) : result.Everywhere;

  const Fidelity fidelity(samples, shoulder, sparesData);
  const double most = result.Everywhere;
  if (!sparesData)
  {
    result.Everywhere *= std::max(
      LeastPartOfMedium, FindPart([&](double x) { return fidelity.GetLosses(x * most, 1.0)[0]; }));
    return result;
  }
  result.OverData = FindPart([&](double x) { return fidelity.GetLosses(most, x)[0]; });
  result.Everywhere *= std::max(LeastPart,
    FindPart([&](double x) { return fidelity.GetLosses(x * most, result.OverData)[1]; }));
  return result;
}

//------------------------------------------------------------------------------
vtkGodRaysLightMeter::Surround vtkGodRaysLightMeter::FindSurround(
  const std::vector<Sample>& samples, double exposure)
{
  Surround result;
  std::vector<double> light;
  double lightness = 0.0;
  for (const Sample& sample : samples)
  {
    if (sample.DataPart < 0.5)
    {
      lightness += ToLab(ToVector(sample.Base)).x;
      light.push_back(exposure * vtkGodRays::Luminance(ToVector(sample.Rays)));
    }
  }
  if (light.empty())
  {
    return result;
  }
  const auto rank = light.begin() + static_cast<std::ptrdiff_t>(0.9 * (light.size() - 1));
  std::nth_element(light.begin(), rank, light.end());
  if (*rank > 0.0)
  {
    result.Light = *rank;
    result.Part =
      MostSurroundPart * glm::smoothstep(75.0, 90.0, lightness / static_cast<double>(light.size()));
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkGodRaysLightMeter::Release(vtkWindow* window)
{
  this->Target.Release(window);
}
