// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTapsFS.h"
#include "vtkGodRaysTarget.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkGodRaysTapsIntegrator);

namespace
{
/// Lengths of a model are those of the picture, which is a part of the layer.
void SetTaps(vtkShaderProgram* program, const vtkGodRays::TapSum& taps, double viewScale)
{
  program->SetUniformi("taps.FirstTap", taps.FirstTap);
  program->SetUniformi("taps.LastTap", taps.LastTap);
  program->SetUniformi("taps.RedToGrey", taps.RedToGrey);
  const auto set = [program](const char* name, double value)
  { program->SetUniformf(name, static_cast<float>(value)); };
  set("taps.TapOffset", taps.TapOffset);
  set("taps.OriginWeight", taps.OriginWeight);
  set("taps.FirstWeight", taps.FirstWeight);
  set("taps.Decay", taps.Decay);
  set("taps.Step", taps.Step);
  set("taps.FixedLength", viewScale * taps.FixedLength);
  set("taps.InputBias", taps.InputBias);
  set("taps.InputGain", taps.InputGain);
  set("taps.OutputBias", taps.OutputBias);
  set("taps.OutputGain", taps.OutputGain);
  set("taps.Maximum", taps.Maximum);
}

void SetBorder(vtkTextureObject* texture, int border)
{
  const int wrap = border == vtkGodRaysRadialSumModel::EDGE_BORDER
    ? vtkTextureObject::ClampToEdge
    : vtkTextureObject::ClampToBorder;
  texture->SetWrapS(wrap);
  texture->SetWrapT(wrap);
}
}

struct vtkGodRaysTapsIntegrator::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysTapsFS", vtkGodRaysTapsFS };
  vtkGodRaysTarget Between[2]; // results of all but the last of several passes

  /// Draw one sum of taps of a layer into the framebuffer that is bound.
  bool Draw(const Request& request, const vtkGodRays::TapSum& taps, vtkTextureObject* layer,
    int width, int height, double viewScale, bool jitter)
  {
    vtkShaderProgram* program = this->Quad.Begin(request.Window, { { "jitter", jitter } });
    if (!program)
    {
      return false;
    }
    const float size[2] = { static_cast<float>(width), static_cast<float>(height) };
    program->SetUniform2f("size", size);
    SetTaps(program, taps, request.ViewScale);
    vtkGodRaysQuad::SetVector(program, "lightClip", request.Light->Clip);
    program->SetUniformf("marchScale", static_cast<float>(request.Light->MarchScale));
    program->SetUniformf("viewScale", static_cast<float>(viewScale));
    this->Quad.SetTexture("layer", layer);
    this->Quad.End();
    return true;
  }

  /// Draw one sum of taps of a layer into a target.
  bool Draw(const Request& request, const vtkGodRays::TapSum& taps, vtkTextureObject* layer,
    vtkGodRaysTarget& target, double viewScale, bool jitter)
  {
    request.Window->GetState()->vtkglDisable(GL_BLEND);
    return target.Bind() &&
      this->Draw(request, taps, layer, target.GetWidth(), target.GetHeight(), viewScale, jitter);
  }
};

vtkGodRaysTapsIntegrator::vtkGodRaysTapsIntegrator()
  : Internal(new Internals)
{
}

vtkGodRaysTapsIntegrator::~vtkGodRaysTapsIntegrator() = default;

bool vtkGodRaysTapsIntegrator::IsJittered(vtkGodRaysRadialSumModel* model) const
{
  return this->Jitter && vtkGodRaysRadialModel::SafeDownCast(model);
}

// sum_{k<m^p} w d^k s(k) = sum_{i<m} w d^i sum_{j<m} (d^m)^j s(i + m j), and so on.
void vtkGodRaysTapsIntegrator::GetPasses(
  vtkGodRaysRadialSumModel* model, std::vector<vtkGodRays::TapSum>& passes) const
{
  const int asked = this->NumberOfTaps > 0 ? this->NumberOfTaps : model->GetNumberOfSamples();
  if (this->NumberOfPasses == 1 || !vtkGodRaysRadialModel::SafeDownCast(model))
  {
    model->GetTapSums(passes, asked);
    return;
  }
  const int taps = static_cast<int>(std::lround(std::pow(asked, 1.0 / this->NumberOfPasses)));
  model->GetTapSums(passes, static_cast<int>(std::lround(std::pow(taps, this->NumberOfPasses))));
  vtkGodRays::TapSum coarser = passes[0];
  passes[0].LastTap = taps;
  coarser.FirstTap = 0;
  coarser.LastTap = taps - 1;
  coarser.TapOffset = 0.0;
  coarser.FirstWeight = 1.0;
  coarser.OutputGain = 1.0;
  for (int i = 1; i < this->NumberOfPasses; ++i)
  {
    coarser.Decay = std::pow(coarser.Decay, taps);
    coarser.Step *= taps;
    passes.push_back(coarser);
  }
}

bool vtkGodRaysTapsIntegrator::Integrate(const Request& request)
{
  vtkGodRaysRadialSumModel* model = request.Model;
  std::vector<vtkGodRays::TapSum> passes;
  this->GetPasses(model, passes);
  const bool jitter = this->IsJittered(model); // the first pass alone: its taps are the closest

  // all passes but the last cover the whole layer, margin included
  vtkTextureObject* layer = request.Layer->GetColor();
  SetBorder(layer, model->GetBorder());
  for (std::size_t i = 0; i + 1 < passes.size(); ++i)
  {
    vtkGodRaysTarget& target = this->Internal->Between[i % 2];
    target.Prepare(request.Window, static_cast<int>(layer->GetWidth()),
      static_cast<int>(layer->GetHeight()), { request.Result->GetFormat(), 0 });
    if (!this->Internal->Draw(request, passes[i], layer, target, 1.0, jitter && i == 0))
    {
      return false;
    }
    layer = target.GetColor();
    SetBorder(layer, model->GetBorder());
  }

  return request.Result->BindToAdd() &&
    this->Internal->Draw(request, passes.back(), layer, request.Result->GetWidth(),
      request.Result->GetHeight(), request.ViewScale, jitter && passes.size() == 1);
}

std::string vtkGodRaysTapsIntegrator::Describe(vtkGodRaysModel* model)
{
  auto radial = vtkGodRaysRadialSumModel::SafeDownCast(model);
  if (!radial)
  {
    return "taps: none, only a vtkGodRaysRadialSumModel can be evaluated";
  }
  std::vector<vtkGodRays::TapSum> passes;
  this->GetPasses(radial, passes);
  std::ostringstream text;
  text << "taps: ";
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    const int origin = passes[i].OriginWeight != 0.0 ? 1 : 0;
    text << (i ? " + " : "") << passes[i].LastTap - passes[i].FirstTap + 1 + origin;
  }
  text << " a pixel" << (this->IsJittered(radial) ? ", jittered" : "");
  return text.str();
}

void vtkGodRaysTapsIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Quad.Release();
  this->Internal->Between[0].Release(window);
  this->Internal->Between[1].Release(window);
}

void vtkGodRaysTapsIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTaps: " << this->NumberOfTaps << "\n";
  os << indent << "Jitter: " << (this->Jitter ? "On\n" : "Off\n");
  os << indent << "NumberOfPasses: " << this->NumberOfPasses << "\n";
}
