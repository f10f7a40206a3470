// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysBlockMeans.h"

#include "vtkGodRaysBlockInterpolateFS.h"
#include "vtkGodRaysBlockMeansFS.h"
#include "vtkGodRaysBlockPlan.h"
#include "vtkGodRaysBlockSumFS.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace
{
constexpr std::size_t LeastPlans = 8; // that are kept, or one for each light of a frame

using Plan = vtkGodRaysBlockPlan;
constexpr int NumberOfWedges = Plan::NumberOfWedges;

void SetVector(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

void SetWedges(vtkShaderProgram* program, const Plan& plan)
{
  float lines[NumberOfWedges][4];
  float rows[NumberOfWedges][4];
  float strips[NumberOfWedges][4] = {};
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    const Plan::Wedge& wedge = plan.Wedges[i];
    lines[i][0] = static_cast<float>(wedge.FirstLine);
    lines[i][1] = static_cast<float>(wedge.SlopeStep * wedge.Near);
    lines[i][2] = static_cast<float>(wedge.FirstSlope);
    lines[i][3] = static_cast<float>(wedge.SlopeStep);
    rows[i][0] = static_cast<float>(wedge.NearRow);
    rows[i][1] = static_cast<float>(wedge.Direction);
    rows[i][2] = wedge.Axis == 0 ? 1.0f : 0.0f;
    rows[i][3] = static_cast<float>(wedge.Lines);
    strips[i][0] = static_cast<float>(wedge.Strip[0]);
    strips[i][1] = static_cast<float>(wedge.Strip[1]);
    strips[i][2] = static_cast<float>(plan.StripFactor);
  }
  program->SetUniform4fv("wedgeLines", NumberOfWedges, lines);
  program->SetUniform4fv("wedgeRows", NumberOfWedges, rows);
  program->SetUniform4fv("wedgeStrips", NumberOfWedges, strips);
  SetVector(program, "layerSize", plan.March.LayerSize[0], plan.March.LayerSize[1]);
}
}

struct vtkGodRaysBlockMeans::Internals
{
  vtkGodRaysQuad MeansQuad{ "vtkGodRaysBlockMeansFS", vtkGodRaysBlockMeansFS };
  vtkGodRaysQuad SumQuad{ "vtkGodRaysBlockSumFS", vtkGodRaysBlockSumFS };
  vtkGodRaysQuad InterpolateQuad{ "vtkGodRaysBlockInterpolateFS", vtkGodRaysBlockInterpolateFS };
  vtkGodRaysTarget Means[2]; // of one channel, of three
  vtkGodRaysTarget Sums[2];
  vtkGodRaysTarget Rays;                    // of one channel
  std::vector<std::unique_ptr<Plan>> Plans; // the one that was used last comes last
  std::size_t Lights = 0;                   // of this frame, up to now
  std::size_t FormerLights = 0;             // of the frame before

  Plan* Prepare(const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march);
  bool Bind(vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target, int width, int height,
    unsigned int format);
  bool DrawMeans(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
  bool DrawSums(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
  bool DrawPicture(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
  bool DrawPart(
    const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan, bool lends, bool isNear);
};

Plan* vtkGodRaysBlockMeans::Internals::Prepare(
  const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march)
{
  if (request.Result->IsEmpty()) // the first light of a frame
  {
    this->FormerLights = this->Lights;
    this->Lights = 0;
  }
  ++this->Lights;
  const Plan::Effort effort = Plan::ChooseEffort(
    march, request.ErrorTolerance, vtkTextureObject::GetMaximumTextureSize(request.Window));
  const bool oneChannel = request.Layer->HasOneChannel();
  const auto found = std::find_if(this->Plans.begin(), this->Plans.end(),
    [&](const auto& plan) { return plan->Is(march, effort, oneChannel); });
  if (found != this->Plans.end())
  {
    std::rotate(found, found + 1, this->Plans.end());
    return this->Plans.back().get();
  }
  if (this->Plans.size() < std::max({ LeastPlans, this->Lights, this->FormerLights }))
  {
    this->Plans.push_back(std::make_unique<Plan>(march, effort, oneChannel));
  }
  else
  {
    std::rotate(this->Plans.begin(), this->Plans.begin() + 1, this->Plans.end());
    this->Plans.back()->Change(march, effort, oneChannel);
  }
  this->Plans.back()->Upload(request.Window);
  return this->Plans.back().get();
}

// Draw into the lower left part of a target that is at least as large.
bool vtkGodRaysBlockMeans::Internals::Bind(vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target,
  int width, int height, unsigned int format)
{
  const bool same = target.IsReady() && target.GetColorFormat() == format;
  if (!same || target.GetWidth() < width || target.GetHeight() < height)
  {
    target.Prepare(window, std::max(target.GetWidth(), Plan::RoundUp(width, 32)),
      std::max(target.GetHeight(), Plan::RoundUp(height, 256)), { format, 0 });
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  if (!target.Bind())
  {
    return false;
  }
  window->GetState()->vtkglViewport(0, 0, width, height);
  return true;
}

bool vtkGodRaysBlockMeans::Internals::DrawMeans(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  vtkShaderProgram* program = this->Bind(request.Window, this->Means[plan.OneChannel ? 0 : 1],
                                plan.BlockColumns, plan.Lines, GL_RGBA32F)
    ? this->MeansQuad.Begin(request.Window, { { "OneChannel", plan.OneChannel } })
    : nullptr;
  if (!program)
  {
    return false;
  }
  SetWedges(program, plan);
  float columns[NumberOfWedges]; // the first one of each wedge's blocks
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    columns[i] = static_cast<float>(plan.Wedges[i].BlockColumn);
  }
  program->SetUniform4f("wedgeColumns", columns);
  SetVector(program, "size", plan.BlockColumns, plan.Lines);
  program->SetUniformf("tapsPerPixel", static_cast<float>(plan.Chosen.TapsPerPixel));
  this->MeansQuad.SetTexture("layer", request.Layer->GetColor());
  this->MeansQuad.SetTexture("blocks", plan.Blocks.Texture);
  this->MeansQuad.End();
  return true;
}

bool vtkGodRaysBlockMeans::Internals::DrawSums(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  const int index = plan.OneChannel ? 0 : 1;
  const unsigned int format = plan.OneChannel ? GL_R32F : GL_RGBA32F;
  vtkShaderProgram* program =
    this->Bind(request.Window, this->Sums[index], plan.NodeColumns, plan.Lines, format)
    ? this->SumQuad.Begin(request.Window, { { "OneChannel", plan.OneChannel } })
    : nullptr;
  if (!program)
  {
    return false;
  }
  SetWedges(program, plan);
  SetVector(program, "size", plan.NodeColumns, plan.Lines);
  this->SumQuad.SetTexture("means", this->Means[index].GetColor());
  this->SumQuad.SetTexture("nodes", plan.Nodes.Texture);
  this->SumQuad.SetTexture("kernel", plan.Kernel.Texture);
  this->SumQuad.End();
  return true;
}

bool vtkGodRaysBlockMeans::Internals::DrawPicture(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  // The first light's rays of one channel are lent: a quarter of what a sum takes to write.
  const bool lends = plan.OneChannel && request.Result->IsEmpty();
  const int* size = plan.March.PictureSize;
  if (lends)
  {
    this->Rays.Prepare(request.Window, size[0], size[1], { GL_R32F, 0 });
    request.Window->GetState()->vtkglDisable(GL_BLEND);
  }
  if (!(lends ? this->Rays.Bind() : request.Result->BindToAdd()))
  {
    return false;
  }
  // Both parts have their shaders from the first frame on, also where one of them has no pixel.
  const int* box = plan.NearBox;
  const bool isFar = box[0] > 0 || box[1] > 0 || box[2] < size[0] || box[3] < size[1];
  vtkOpenGLState* state = request.Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable enabled(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, isFar ? size[0] : 0, size[1]);
  if (!this->DrawPart(request, plan, lends, false))
  {
    return false;
  }
  state->vtkglScissor(box[0], box[1], std::max(box[2] - box[0], 0), std::max(box[3] - box[1], 0));
  return this->DrawPart(request, plan, lends, true) &&
    (!lends || request.Result->Lend(this->Rays, request.Light->Color, 1.0));
}

// Draw into the bound target what is in the box near the light, or else the rest of the picture.
bool vtkGodRaysBlockMeans::Internals::DrawPart(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan, bool lends, bool isNear)
{
  vtkShaderProgram* program = this->InterpolateQuad.Begin(
    request.Window, { { "OneChannel", plan.OneChannel }, { "NearLight", isNear } });
  if (!program)
  {
    return false;
  }
  const int index = plan.OneChannel ? 0 : 1;
  const vtkGodRaysMarch& march = plan.March;
  float strips[NumberOfWedges];
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    strips[i] = static_cast<float>(plan.Wedges[i].Strip[0]);
  }
  program->SetUniform4f("firstStrip", strips);
  SetVector(program, "layerSize", march.LayerSize[0], march.LayerSize[1]);
  SetVector(program, "size", march.PictureSize[0], march.PictureSize[1]);
  SetVector(program, "origin", march.Origin[0], march.Origin[1]);
  SetVector(program, "pixel", march.Step[0], march.Step[1]);
  SetVector(program, "marchConstant", plan.Density * plan.Light[0], plan.Density * plan.Light[1]);
  const vtkGodRaysTarget& sums = this->Sums[index];
  const vtkGodRaysTarget& means = this->Means[index];
  SetVector(program, "sumsSize", sums.GetWidth(), sums.GetHeight());
  const auto set = [program](const char* name, double value)
  { program->SetUniformf(name, static_cast<float>(value)); };
  set("marchSlope", plan.Density);
  set("stripFactor", plan.StripFactor);
  set("lastLine", plan.Lines - 1.0);
  set("k", march.K);
  set("shortest", plan.ShortestMarch);
  set("tapsPerPixel", 2.0 * plan.Chosen.TapsPerPixel);
  set("bumpTapLength", plan.Chosen.BumpTapLength);
  float box[4];
  std::copy_n(plan.NearBox, 4, box);
  program->SetUniform4f("nearBox", box);
  float gain[3];
  for (int c = 0; c < 3; ++c)
  {
    const double tint = plan.OneChannel && !lends ? request.Light->Color[c] : 1.0;
    gain[c] = static_cast<float>(march.Gain * tint);
  }
  program->SetUniform3f("gain", gain);
  this->InterpolateQuad.SetTexture("layer", request.Layer->GetColor());
  this->InterpolateQuad.SetTexture("means", means.GetColor());
  this->InterpolateQuad.SetTexture("sums", sums.GetColor());
  this->InterpolateQuad.SetTexture("rows", plan.Rows.Texture);
  this->InterpolateQuad.End();
  return true;
}

vtkGodRaysBlockMeans::vtkGodRaysBlockMeans()
  : Internal(new Internals)
{
}

vtkGodRaysBlockMeans::~vtkGodRaysBlockMeans() = default;

bool vtkGodRaysBlockMeans::Integrate(
  const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march)
{
  Internals& self = *this->Internal;
  vtkTextureObject* layer = request.Layer->GetColor();
  layer->SetWrapS(vtkTextureObject::ClampToBorder);
  layer->SetWrapT(vtkTextureObject::ClampToBorder);
  const Plan* plan = self.Prepare(request, march);
  return self.DrawMeans(request, *plan) && self.DrawSums(request, *plan) &&
    self.DrawPicture(request, *plan);
}

std::string vtkGodRaysBlockMeans::Describe() const
{
  if (this->Internal->Plans.empty())
  {
    return "block means: nothing has been computed";
  }
  const Plan& plan = *this->Internal->Plans.back();
  int lines = 0;
  for (const Plan::Wedge& wedge : plan.Wedges)
  {
    lines += wedge.Lines;
  }
  std::ostringstream text;
  if (!plan.Chosen.HasLines())
  {
    text << "taps: " << 2.0 * plan.Chosen.TapsPerPixel
         << " for each pixel of a march within the layer";
    return text.str();
  }
  text << "block means: " << lines << " lines " << plan.Chosen.Spacing << " pixels apart, up to "
       << plan.GetNodes() << " nodes, blocks of up to " << plan.Chosen.LongestBlock
       << " pixels, taps for marches below " << plan.ShortestMarch << " pixels";
  return text.str();
}

void vtkGodRaysBlockMeans::Release(vtkWindow* window)
{
  Internals& self = *this->Internal;
  self.MeansQuad.Release();
  self.Rays.Release(window);
  self.SumQuad.Release();
  self.InterpolateQuad.Release();
  for (int i = 0; i < 2; ++i)
  {
    self.Means[i].Release(window);
    self.Sums[i].Release(window);
  }
  for (const auto& plan : self.Plans)
  {
    plan->Release(window);
  }
  self.Plans.clear();
}
