// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How strong the rays of a frame are by the picture that they join, and what of it is data; see
// Documentation/Pipeline.md.
#include "vtkGodRaysPassInternals.h"

#include "vtkCamera.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

// Whether the join depends on what the picture shows.
bool vtkGodRaysPass::MetersPicture() const
{
  return this->Output == COMPOSITE &&
    (this->AutomaticExposure || this->DarkenLightBackground || this->DataFirst) &&
    this->Internal->Transfer != vtkGodRaysTransfer::NONE;
}

// Find what a new picture covers, and put the sun where that makes shafts, if it is this pass's.
bool vtkGodRaysPass::LookAtPicture(
  const vtkRenderState* s, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights)
{
  Internals& self = *this->Internal;
  if (!self.IsNewPicture)
  {
    return true;
  }
  vtkRenderer* renderer = s->GetRenderer();
  vtkGodRaysBlendPass::Request request;
  request.Window = self.Window;
  request.Scene = self.Scene.GetColor();
  request.Depth = self.Margin == 0.0 ? self.Occlusion->GetDepth() : self.Scene.GetDepth();
  request.Coverage = request.Depth == self.Scene.GetDepth() ? self.Coverage : nullptr;
  request.Opacity = self.Occlusion->GetDimming();
  request.Transfer = self.Transfer;
  request.Bytes = true;
  vtkNew<vtkImageData> coverage;
  double ground[3] = {};
  if (!self.Meter.ReadCoverage(self.Blending, request, coverage, ground))
  {
    return false;
  }
  if (self.Compositor && self.Compositor->IsDistributed())
  {
    self.Compositor->Reduce(static_cast<float*>(coverage->GetScalarPointer()),
      static_cast<std::size_t>(coverage->GetNumberOfPoints()), vtkGodRaysCompositor::GREATEST);
  }
  self.Placer->SetCoverageImage(coverage);
  if (this->MovesSun())
  {
    constexpr double leastLightness = 12.0; // [L*]
    constexpr double blue = -6.0;           // b*
    this->MoveSun(renderer, ground[0] > leastLightness && ground[2] < blue);
    this->FindLights(renderer, view, lights);
  }
  return true;
}

// Choose how strong the rays are, and tell the request. Tiles and the second eye take what the first had.
bool vtkGodRaysPass::Internals::FindExposure(
  vtkGodRaysPass& pass, vtkRenderer* renderer, bool isTile, vtkGodRaysBlendPass::Request& request)
{
  const vtkGodRaysLightMeter::Exposure former = this->Exposure;
  const bool wasMetered = this->IsMetered;
  this->IsMetered = pass.MetersPicture() && request.Rays;
  if (!this->IsMetered)
  {
    return true;
  }
  request.AlphaLayers = vtkGodRaysLightMeter::FindAlphaLayers(renderer);
  // Before a background that has alpha, as a gradient or a sky box has, opacity is looked up elsewhere.
  request.OpacityLayers = vtkGodRaysLightMeter::TrueAlphaLayers;
  request.Opacity = this->Meter.AlphaShowsData() ? nullptr : this->Occlusion->FindOpacity();
  // of a picture whose whole was drawn before
  const bool isPart =
    isTile || (this->Window->GetStereoRender() && !renderer->GetActiveCamera()->GetLeftEye());
  if (!isPart || !wasMetered)
  {
    if (!this->Meter.Read(this->Blending, request))
    {
      return false;
    }
    if (!request.Opacity && !this->Meter.AlphaShowsData())
    {
      request.Opacity = this->Occlusion->FindOpacity();
      if (request.Opacity && !this->Meter.Read(this->Blending, request))
      {
        return false;
      }
    }
    this->Exposure = {};
    if (pass.AutomaticExposure)
    {
      this->Exposure = this->Meter.FindExposure(
        request.Shoulder && !request.Screen, request.LargestExposure, request.SparesData);
      if (wasMetered && this->Window->GetDesiredUpdateRate() >= 1.0)
      {
        const auto approach = [](double& now, double before)
        { now = before + 0.25 * (now - before); };
        approach(this->Exposure.Everywhere, former.Everywhere);
        approach(this->Exposure.OverData, former.OverData);
        approach(this->Exposure.OverDark, former.OverDark);
        approach(this->Exposure.DataGain, former.DataGain);
      }
    }
    this->Surround = {};
    if (pass.DarkenLightBackground)
    {
      double place[2] = { 0.5, 0.5 };
      if (!this->Lights.empty())
      {
        vtkGodRaysSunPlacer::FindPlace(renderer, this->Lights.front(), place);
      }
      this->Surround =
        this->Meter.FindSurround(pass.GetExposure(), place, renderer->GetTiledAspectRatio());
      this->Exposure.OverData *= this->Surround.Rays; // before white, light over data is a veil
      this->Exposure.OverDark *= this->Surround.Rays;
    }
  }
  request.AlphaShowsData = this->Meter.AlphaShowsData();
  request.Opacity = request.AlphaShowsData ? nullptr : request.Opacity;
  request.DataExposure = this->Exposure.OverData;
  request.DarkExposure = this->Exposure.OverDark;
  request.DataGain = this->Exposure.DataGain;
  request.CapsData = pass.AutomaticExposure && request.SparesData; // shafts in a room are over data
  request.Around = this->Surround.Part > 0.0 ? &this->Surround : nullptr;
  if (pass.DataFirst)
  {
    request.MostLightness = pass.MostDataLightness;
  }
  return true;
}
