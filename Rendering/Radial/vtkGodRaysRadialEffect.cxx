// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialEffect.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysVerification.h"
#include "vtkGodRaysView.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <vector>

//------------------------------------------------------------------------------
vtkGodRaysRadialEffect::vtkGodRaysRadialEffect(vtkGodRaysRadialSumModel* model)
  : Model(model)
{
}

//------------------------------------------------------------------------------
std::string vtkGodRaysRadialEffect::FindObstacle(
  vtkRenderer*, vtkGodRaysCompositor*, const vtkGodRaysView&, const int[2])
{
  return "";
}

//------------------------------------------------------------------------------
bool vtkGodRaysRadialEffect::SumsShownValues() const
{
  return !this->Model->GetLinearLight();
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialEffect::SetUp(vtkGodRaysLightFinder& finder) const
{
  finder.CapsMarch = this->Model->CapsMarch();
  finder.LightsMedium = false;
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialEffect::SetUp(
  vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator* integrator) const
{
  request.LampsOcclude = true;
  request.Dims = true;
  request.OneColorFormat = vtkGodRaysRadialIntegrator::SafeDownCast(integrator)
                             ->GetOneColorFormat(request.Window, this->Model, request.ColorFormat);
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialEffect::Begin(const Frame& frame)
{
  frame.Integrator->BeginVerification(!frame.Interactive);
  this->Composed = 0;
  this->KeepsAll = frame.NumberOfLights == 1 || frame.KeepsLayers;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void vtkGodRaysRadialEffect::Join(vtkGodRaysBlendPass::Request& request) const
{
  request.SceneGain = this->Model->GetSceneGain();
  request.Screen = this->Model->GetBlend() == vtkGodRaysRadialSumModel::SCREEN;
}

//------------------------------------------------------------------------------
vtkGodRaysSum* vtkGodRaysRadialEffect::GetLayers()
{
  return this->HasLayers() && this->KeepsAll ? &this->Layers : nullptr;
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialEffect::Release(vtkWindow* window)
{
  this->Layers.Release(window);
  this->Composed = 0;
}
