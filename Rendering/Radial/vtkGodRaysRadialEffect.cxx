// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialEffect.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysVerification.h"
#include "vtkGodRaysView.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkGodRaysRadialEffect::vtkGodRaysRadialEffect(vtkGodRaysRadialSumModel* model)
  : Model(model)
{
}

std::string vtkGodRaysRadialEffect::FindObstacle(vtkRenderer*, vtkGodRaysCompositor*,
  const vtkGodRaysSceneSize&, const vtkGodRaysView&, const int[2])
{
  return "";
}

bool vtkGodRaysRadialEffect::SumsShownValues() const
{
  return !this->Model->GetLinearLight();
}

bool vtkGodRaysRadialEffect::UsesCoverage() const
{
  return this->Model->GetStreaks() > 0.0;
}

void vtkGodRaysRadialEffect::SetUp(vtkGodRaysLightFinder& finder) const
{
  finder.CapsMarch = this->Model->CapsMarch();
  finder.LightsMedium = false;
}

void vtkGodRaysRadialEffect::SetUp(
  vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator* integrator) const
{
  request.LampsOcclude = true;
  request.Dims = true;
  request.OneColorFormat = vtkGodRaysRadialIntegrator::SafeDownCast(integrator)
                             ->GetOneColorFormat(this->Model, request.ColorFormat);
}

void vtkGodRaysRadialEffect::Begin(const Frame& frame)
{
  frame.Integrator->BeginVerification(!frame.Interactive);
  this->Composed = 0;
  this->Drawn = 0;
  this->Streaks.resize(frame.NumberOfLights, 0.0);
  this->KeepsAll = frame.NumberOfLights == 1 || frame.KeepsLayers;
}

bool vtkGodRaysRadialEffect::DrawLight(const Frame& frame, const vtkGodRaysLight& light)
{
  frame.Timers->Start(vtkGodRaysTimers::OCCLUSION);
  if (!this->ComposeLayer(frame, light))
  {
    return false;
  }
  frame.Timers->Stop();
  if (!frame.Scatters || (frame.Compositor && !frame.Compositor->IsRoot()))
  {
    return true;
  }
  vtkGodRaysRadialIntegrator::Request request;
  request.Window = frame.Window;
  request.Model = this->Model;
  request.Light = &light;
  request.Layer = frame.Occlusion->GetLayer();
  request.ViewScale = frame.View->ViewScale;
  request.ErrorTolerance = frame.ErrorTolerance;
  request.Result = frame.Light;
  frame.Light->SetResponse(this->GetResponse(frame, light));
  vtkGodRaysVerification verification(frame.Integrator, *frame.Light);
  frame.Timers->Start(vtkGodRaysTimers::SCATTERING);
  const bool done = vtkGodRaysRadialIntegrator::SafeDownCast(frame.Integrator)->Integrate(request);
  frame.Timers->Stop();
  if (done && verification.IsWanted())
  {
    this->Verify(request, verification);
  }
  return done;
}

/**
 * The response of a light. Streaks are as strong as the model has them where the data make at most 3 shafts,
 * and fade where the data make more of their own, up to 8.
 */
vtkGodRaysBlendPass::LightResponse vtkGodRaysRadialEffect::GetResponse(
  const Frame& frame, const vtkGodRaysLight& light)
{
  constexpr double farthest = 1e3; // [heights] as good as infinitely far
  vtkGodRaysBlendPass::LightResponse response;
  const double* picture = frame.Picture;
  response.Heights[1] = 1.0 / picture[3];
  response.Heights[0] = response.Heights[1] * frame.View->Aspect;
  response.Reach = this->Model->GetReach();
  double outside = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double most = farthest * std::max(std::abs(light.Clip[2]), 1e-30);
    const double clip = light.Clip[2] < 0.0 ? -light.Clip[i] : light.Clip[i];
    const double place = std::clamp(clip, -most, most) / std::max(std::abs(light.Clip[2]), 1e-30) /
      frame.View->ViewScale;
    response.Light[i] = 0.5 + 0.5 * place;
    const double beyond = std::max(
      { picture[i] - response.Light[i], response.Light[i] - picture[i] - picture[i + 2], 0.0 });
    outside = std::hypot(outside, beyond * response.Heights[i]);
  }
  response.Nearest = outside;
  double& streaks = this->Streaks[this->Drawn++];
  if (frame.Placer && this->UsesCoverage())
  {
    const double shafts = frame.Placer->GetShaftsAt(
      (response.Light[0] - picture[0]) / picture[2], (response.Light[1] - picture[1]) / picture[3]);
    streaks = std::clamp((8.0 - shafts) / 5.0, 0.0, 1.0);
  }
  response.Streaks = frame.InventsStreaks ? this->Model->GetStreaks() * streaks : 0.0;
  return response;
}

void vtkGodRaysRadialEffect::Verify(
  const vtkGodRaysRadialIntegrator::Request& request, vtkGodRaysVerification& verification) const
{
  if (!vtkGodRaysRadialModel::SafeDownCast(this->Model))
  {
    return; // as published, there is no limit to compare with
  }
  vtkNew<vtkImageData> layer;
  request.Layer->Download(layer, request.Light->Color);
  const vtkGodRays::ImageLayer emitter = { static_cast<const float*>(layer->GetScalarPointer()),
    request.Layer->GetWidth(), request.Layer->GetHeight(), vtkGodRays::BORDER_ZERO };
  std::vector<vtkGodRays::TapSum> passes;
  this->Model->GetTapSums(passes, 2048);
  const double* light = request.Light->Clip;
  const vtkGodRays::Vec3 clip(light[0], light[1], light[2]);
  const int width = request.Result->GetWidth();
  const int height = request.Result->GetHeight();
  verification.Measure(
    [&](int x, int y)
    {
      const vtkGodRays::Vec2 picture((x + 0.5) / width, (y + 0.5) / height);
      const vtkGodRays::Vec2 uv = 0.5 + (picture - 0.5) * request.ViewScale;
      const vtkGodRays::Vec3 sum = vtkGodRays::SumTaps(emitter, passes[0], uv,
        vtkGodRays::MarchVector(clip, 2.0 * uv - 1.0, request.Light->MarchScale));
      return std::array<double, 3>{ sum.x, sum.y, sum.z };
    });
}

bool vtkGodRaysRadialEffect::ComposeLayer(const Frame& frame, const vtkGodRaysLight& light)
{
  if (!frame.Occlusion->Compose(light))
  {
    return false;
  }
  const bool first = this->Composed++ == 0;
  if (!this->KeepsAll)
  {
    return true;
  }
  vtkGodRaysTarget& layer = *frame.Occlusion->GetLayer();
  if (first)
  {
    this->Layers.Begin(frame.Window, layer.GetWidth(), layer.GetHeight(), frame.Format);
  }
  return frame.NumberOfLights == 1 ? this->Layers.Lend(layer, light.Color, 1.0)
                                   : this->Layers.Add(layer, light.Color, 1.0);
}

void vtkGodRaysRadialEffect::Join(vtkGodRaysBlendPass::Request& request) const
{
  constexpr double largest = 4.0; // two stops of a camera
  request.LargestExposure = vtkGodRaysRadialModel::SafeDownCast(this->Model) ? largest : 1.0;
  request.SceneGain = this->Model->GetSceneGain();
  request.Screen = this->Model->GetBlend() == vtkGodRaysRadialSumModel::SCREEN;
}

vtkGodRaysSum* vtkGodRaysRadialEffect::GetLayers()
{
  return this->HasLayers() && this->KeepsAll ? &this->Layers : nullptr;
}

void vtkGodRaysRadialEffect::Release(vtkWindow* window)
{
  this->Layers.Release(window);
  this->Composed = 0;
}
