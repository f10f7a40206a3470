// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysLightMeter.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRole.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
using vtkGodRays::Vec3;

constexpr int Columns = 72;
constexpr int Rows = 48;

constexpr double LeastPartOfMedium = 0.015; // that data leave of its light over them
constexpr double LeastPartBeside = 0.2;     // and beside them
constexpr double MostDataGain = 2.0;        // a stop of a camera
constexpr double LeastPartOverData = 0.5;   // of a medium's light beside them, a stop as well

// The opacity of volumes is in alpha, and that of surfaces whose depth is peeled. Without peeling VTK 9.1
// leaves T (1 - T) of surfaces that let T through, 0.13 where they hide 15 % or 85 %, which is to count as
// nearly all.
constexpr double BlendedAlphaLayers = 30.0;

constexpr double FewData = 0.005; // fraction of the picture; fewer count as less

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

/// What a medium leaves of a sample's light; nothing is taken of black.
Vec3 GetTransmittance(const vtkGodRaysLightMeter::Sample& sample)
{
  Vec3 result(1.0);
  for (int c = 0; c < 3; ++c)
  {
    result[c] =
      sample.Scene[c] > 1e-6 ? glm::clamp(sample.Base[c] / sample.Scene[c], 0.0, 1.0) : 0.0;
  }
  return result;
}

/// The fraction of light that a medium leaves on average, of data alone or of all samples; 1 without light.
double GetMeanTransmittance(const std::vector<vtkGodRaysLightMeter::Sample>& samples, bool ofData)
{
  double scene = 0.0;
  double base = 0.0;
  for (const auto& sample : samples)
  {
    const double part = ofData ? sample.DataPart : 1.0;
    scene += part * vtkGodRays::Luminance(ToVector(sample.Scene));
    base += part * vtkGodRays::Luminance(ToVector(sample.Base));
  }
  return scene > 0.0 ? base / scene : 1.0;
}

/// The gain with which data are on average as bright as without a medium, which hides what is farther.
double FindDataGain(const std::vector<vtkGodRaysLightMeter::Sample>& samples)
{
  const double left = GetMeanTransmittance(samples, true);
  return left > 0.0 ? glm::clamp(1.0 / left, 1.0, MostDataGain) : 1.0;
}

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

/// The largest part, from LeastPartOfMedium to 1, for which a loss is 1 or less; LeastPartOfMedium, if there
/// is none. The loss falls first, where light makes up for what the medium takes, and grows later.
template <typename Loss>
double FindPartOfMedium(const Loss& getLoss)
{
  constexpr double step = 0.8;
  double above = 1.0;
  double part = 1.0;
  while (part > LeastPartOfMedium && getLoss(part) > 1.0)
  {
    above = part;
    part *= step;
  }
  if (part <= LeastPartOfMedium)
  {
    return LeastPartOfMedium;
  }
  for (int i = 0; i < 6 && above > part; ++i)
  {
    const double middle = 0.5 * (part + above);
    (getLoss(middle) > 1.0 ? above : part) = middle;
  }
  return part;
}
}

/**
 * How much the colours of data change with rays of some strength.
 */
class vtkGodRaysLightMeter::Fidelity
{
public:
  /// Take samples, in the memory of those before.
  void Set(const std::vector<Sample>& samples, bool shoulder, bool limitsTint, double dataGain)
  {
    this->Shoulder = shoulder;
    this->LimitsTint = limitsTint;
    this->Data.clear();
    this->Before[LIT] = this->Before[ALL] = {};
    for (const auto& sample : samples)
    {
      const Vec3 scene = glm::clamp(ToVector(sample.Scene), Vec3(0.0), Vec3(1.0));
      if (sample.DataPart > 0.0)
      {
        const double lit = vtkGodRays::SeenPart(scene);
        const Vec3 base = ToVector(sample.Base) *
          vtkGodRays::DataGain(GetTransmittance(sample), dataGain, sample.DataPart);
        const Vec3 before = ToLab(scene);
        this->Data.push_back({ base, ToVector(sample.Rays), before, lit, sample.DataPart });
        this->Before[LIT].Add(sample.DataPart * lit, 0.0, GetChroma(before));
        this->Before[ALL].Add(sample.DataPart, 0.0, GetChroma(before));
      }
    }
    this->Few = FewData * static_cast<double>(samples.size());
  }

  /// From 0 to 1, whether most data are lit; else they are a silhouette.
  double GetMostlyLit() const
  {
    return glm::smoothstep(
      0.3, 0.6, this->Before[LIT].Weight / std::max(this->Before[ALL].Weight, this->Few));
  }

  enum Kind
  {
    LIT = 0,
    ALL = 1
  };

  /**
   * At most 1 if colours of a kind of data are kept with a factor on all rays, a further one over data
   * that are lit, and one over those that are dark.
   */
  double GetLoss(Kind kind, double exposure, double overLit, double overDark) const
  {
    Sum sum;
    for (const Colors& each : this->Data)
    {
      const double over = glm::mix(overDark, overLit, each.Lit);
      const Vec3 full = exposure * each.Rays;
      const Vec3 rays =
        glm::mix(full, over * (this->LimitsTint ? vtkGodRays::CapLight(full) : full), each.Part);
      const Vec3 after = ToLab(this->Shoulder ? vtkGodRays::BlendShoulder(each.Base, rays)
                                              : vtkGodRays::BlendAdd(each.Base, rays));
      sum.Add(each.Part * (kind == LIT ? each.Lit : 1.0), glm::length(after - each.Before),
        GetChroma(after));
    }
    const Sum& before = this->Before[kind];
    const double weight = std::max(before.Weight, this->Few);
    // Where there is hardly a colour, as in grey data, its chroma says nothing.
    const double most = 1.0 - vtkGodRaysLightMeter::LeastChroma;
    const double lost = before.Chroma > weight ? (1.0 - sum.Chroma / before.Chroma) / most : 0.0;
    const double tint = std::max(most * before.Chroma, vtkGodRaysLightMeter::MostTint * weight);
    const double gained = this->LimitsTint ? sum.Chroma - before.Chroma : 0.0;
    return std::max(
      { sum.Difference / weight / vtkGodRaysLightMeter::MostDifference, lost, gained / tint });
  }

private:
  struct Colors
  {
    Vec3 Base;
    Vec3 Rays;
    Vec3 Before;
    double Lit;
    double Part;
  };
  struct Sum
  {
    void Add(double weight, double difference, double chroma)
    {
      this->Weight += weight;
      this->Difference += weight * difference;
      this->Chroma += weight * chroma;
    }
    double Weight = 0.0;
    double Difference = 0.0;
    double Chroma = 0.0;
  };
  std::vector<Colors> Data;
  Sum Before[2];
  double Few = 0.0;
  bool Shoulder;
  bool LimitsTint;
};

vtkGodRaysLightMeter::vtkGodRaysLightMeter()
  : Data(new Fidelity)
{
}
vtkGodRaysLightMeter::~vtkGodRaysLightMeter() = default;

// Draw three pictures of a request, and read them into Pixels.
bool vtkGodRaysLightMeter::Draw(
  vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request, int columns, int rows)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->PushFramebufferBindings();
  this->Target.Prepare(request.Window, columns, 3 * rows, { GL_RGBA32F, 0 });
  bool done = this->Target.Bind();
  if (done)
  {
    vtkGodRaysBlendPass::Request metered = request;
    metered.Cells[0] = columns;
    metered.Cells[1] = rows;
    metered.Intensity = 1.0;
    const int whole[4] = { 0, 0, columns, 3 * rows };
    std::copy_n(whole, 4, metered.Viewport);
    done = blending->Draw(metered);
  }
  state->PopFramebufferBindings();
  if (done)
  {
    this->Pixels.resize(12 * static_cast<std::size_t>(columns) * rows);
    this->Target.Read(GL_RGBA, GL_FLOAT, this->Pixels.data(), 0);
  }
  return done;
}

bool vtkGodRaysLightMeter::ReadCoverage(vtkGodRaysBlendPass* blending,
  const vtkGodRaysBlendPass::Request& request, vtkImageData* coverage, double ground[3])
{
  constexpr double usualRows = 60.0;
  constexpr double mostCells = 480.0; // along the longer side
  constexpr int across = 3;           // pixels that are read of a cell
  const double width = request.Scene->GetWidth();
  const double height = request.Scene->GetHeight();
  const double cell = std::max(height / usualRows, std::max(width, height) / mostCells);
  const int columns = std::max(8, static_cast<int>(std::lround(width / cell)));
  const int rows = std::max(8, static_cast<int>(std::lround(height / cell)));
  if (!this->Draw(blending, request, across * columns, across * rows))
  {
    return false;
  }
  coverage->SetDimensions(columns, rows, 1);
  coverage->AllocateScalars(VTK_FLOAT, 1);
  auto covered = static_cast<float*>(coverage->GetScalarPointer());
  std::fill_n(covered, static_cast<std::size_t>(columns) * rows, 0.0f);
  const std::size_t count = static_cast<std::size_t>(across) * across * columns * rows;
  Vec3 light(0.0);
  double open = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const float* picture[3];
    for (int k = 0; k < 3; ++k)
    {
      picture[k] = this->Pixels.data() + 4 * (k * count + i);
    }
    const std::size_t x = i % (across * columns) / across;
    const std::size_t y = i / (across * columns) / across;
    const float part =
      picture[1][3] + (1.0f - picture[1][3]) * std::clamp(picture[2][3], 0.0f, 1.0f);
    covered[y * columns + x] += part / (across * across);
    light += (1.0 - part) * Vec3(picture[0][0], picture[0][1], picture[0][2]);
    open += 1.0 - part;
  }
  const Vec3 lab = ToLab(light / std::max(open, 1.0));
  std::copy_n(&lab.x, 3, ground);
  this->Samples.clear();
  return true;
}

bool vtkGodRaysLightMeter::Read(
  vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request)
{
  if (!this->Draw(blending, request, Columns, Rows))
  {
    return false;
  }
  const std::size_t count = static_cast<std::size_t>(Columns) * Rows;
  const float* pixels = this->Pixels.data();
  const float* picture[3] = { pixels, pixels + 4 * count, pixels + 8 * count };
  this->HasAlpha = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->HasAlpha =
      this->HasAlpha || (picture[0][4 * i + 3] == 0.0f && picture[1][4 * i + 3] == 0.0f);
  }
  this->Samples.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Sample& sample = this->Samples[i];
    std::copy_n(picture[0] + 4 * i, 3, sample.Scene.begin());
    std::copy_n(picture[1] + 4 * i, 3, sample.Base.begin());
    std::copy_n(picture[2] + 4 * i, 3, sample.Rays.begin());
    const double covered = picture[1][4 * i + 3]; // by what has a depth
    const double rest = picture[this->HasAlpha ? 0 : 2][4 * i + 3];
    sample.DataPart = covered + (1.0 - covered) * glm::clamp(rest, 0.0, 1.0);
  }
  return true;
}

double vtkGodRaysLightMeter::FindAlphaLayers(vtkRenderer* renderer)
{
  if (renderer->GetUseDepthPeeling())
  {
    return TrueAlphaLayers;
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop->GetVisibility() && !vtkGodRaysIsOverlay(prop) &&
      prop->HasTranslucentPolygonalGeometry())
    {
      return BlendedAlphaLayers;
    }
  }
  return TrueAlphaLayers;
}

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

double vtkGodRaysLightMeter::FindTransmittance() const
{
  const bool hasData = std::any_of(this->Samples.begin(), this->Samples.end(),
    [](const Sample& sample) { return sample.DataPart > 0.0; });
  return GetMeanTransmittance(this->Samples, hasData);
}

vtkGodRaysLightMeter::Exposure vtkGodRaysLightMeter::FindExposure(
  bool shoulder, double largest, bool sparesData)
{
  const std::vector<Sample>& samples = this->Samples;
  std::vector<double>& brightest = this->Ranked;
  Exposure result;
  result.Everywhere = largest;
  brightest.resize(samples.size());
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
  const auto findRank = [&brightest](double part)
  {
    const auto rank =
      brightest.begin() + static_cast<std::ptrdiff_t>(part * (brightest.size() - 1));
    std::nth_element(brightest.begin(), rank, brightest.end());
    return std::max(*rank, 1e-30);
  };
  const int kind = sparesData ? 0 : 1;
  result.Everywhere = std::min({ largest, MostMean[kind] / mean,
    MostBrightest[kind] / findRank(0.99), MostQuartile / findRank(0.75) });

  result.DataGain = sparesData ? 1.0 : FindDataGain(samples);
  Fidelity& fidelity = *this->Data;
  fidelity.Set(samples, shoulder, sparesData, result.DataGain);
  const double most = result.Everywhere;
  const double mostlyLit = fidelity.GetMostlyLit();
  if (!sparesData)
  {
    const double part = FindPartOfMedium(
      [&](double x)
      {
        return std::max(fidelity.GetLoss(Fidelity::LIT, x * most, 1.0, 1.0),
          mostlyLit * fidelity.GetLoss(Fidelity::ALL, x * most, 1.0, 1.0));
      });
    const double beside = glm::clamp(part / LeastPartOverData, LeastPartBeside, 1.0);
    result.Everywhere *= beside;
    result.OverData = part / beside;
    result.OverDark = glm::mix(1.0, result.OverData, mostlyLit);
    return result;
  }
  result.OverData = FindPart([&](double x) { return fidelity.GetLoss(Fidelity::LIT, most, x, x); });
  result.OverDark = FindPart([&](double x)
    { return mostlyLit * fidelity.GetLoss(Fidelity::ALL, most, result.OverData, x); });
  return result;
}

vtkGodRaysBlendPass::Surround vtkGodRaysLightMeter::FindSurround(
  double exposure, const double place[2], double aspect)
{
  vtkGodRaysBlendPass::Surround result;
  result.Place[0] = place[0] * aspect;
  result.Place[1] = place[1];
  for (auto& ring : this->Rings)
  {
    ring.clear();
  }
  double lightness = 0.0;
  double open = 0.0;
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const Sample& sample = this->Samples[i];
    if (sample.DataPart < 0.5)
    {
      lightness += ToLab(ToVector(sample.Scene)).x;
      open += 1.0;
      const double distance =
        std::hypot((0.5 + static_cast<double>(i % Columns)) / Columns * aspect - result.Place[0],
          (0.5 + static_cast<double>(i / Columns)) / Rows - result.Place[1]);
      const double ring = std::min(distance * RingsInHeight, NumberOfRings - 1.0);
      this->Rings[static_cast<std::size_t>(ring)].push_back(
        exposure * vtkGodRays::Luminance(ToVector(sample.Rays)));
    }
  }
  // Fits the rings' 95th percentiles by least squares, each as often as it has samples. Those below 1 % of
  // the brightest ring are the faint edge of a shadow, which tells nothing and would lead the fit.
  std::array<double, NumberOfRings> lit = {};
  for (int k = 0; k < NumberOfRings; ++k)
  {
    std::vector<double>& ring = this->Rings[k];
    const auto rank = ring.begin() + static_cast<std::ptrdiff_t>(0.95 * ring.size());
    if (rank != ring.end())
    {
      std::nth_element(ring.begin(), rank, ring.end());
      lit[k] = *rank;
    }
  }
  const double least = 0.01 * *std::max_element(lit.begin(), lit.end());
  glm::dmat3 squares(0.0);
  Vec3 sums(0.0);
  for (int k = 0; k < NumberOfRings; ++k)
  {
    if (lit[k] > least)
    {
      const double u = std::log((k + 0.5) / RingsInHeight + 0.05);
      const Vec3 terms(1.0, u, u * u);
      const double weight = static_cast<double>(this->Rings[k].size());
      squares += weight * glm::outerProduct(terms, terms);
      sums += weight * std::log(lit[k]) * terms;
    }
  }
  if (squares[0][0] > 0.0)
  {
    squares += 1e-6 * squares[0][0] * glm::dmat3(1.0); // few rings
    const Vec3 fit = glm::inverse(squares) * sums;
    std::copy_n(&fit.x, 3, result.Light);
    lightness /= open;
    result.Part = glm::smoothstep(55.0, 78.0, lightness);
    result.Rays = 1.0 - glm::smoothstep(75.0, 90.0, lightness);
  }
  return result;
}

void vtkGodRaysLightMeter::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->HasAlpha = true;
}
