// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialEffect.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysRadialIntegrator.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysView.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkGodRaysRadialEffect::vtkGodRaysRadialEffect(vtkGodRaysRadialSumModel* model)
  : Model(model)
{
}

//------------------------------------------------------------------------------
std::string vtkGodRaysRadialEffect::FindObstacle(const vtkGodRaysView&, const int[2]) const
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
  frame.Timers->Start(vtkGodRaysTimers::SCATTERING);
  const bool done = vtkGodRaysRadialIntegrator::SafeDownCast(frame.Integrator)->Integrate(request);
  frame.Timers->Stop();
  return done;
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
