// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumEffect.h"

#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysMediumNumbers.h"
#include "vtkGodRaysSceneSize.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysVerification.h"
#include "vtkGodRaysView.h"

#include <algorithm>
#include <sstream>

vtkGodRaysMediumEffect::vtkGodRaysMediumEffect(vtkGodRaysMediumModel* model)
  : Model(model)
{
}

std::string vtkGodRaysMediumEffect::FindObstacle(vtkRenderer* renderer,
  vtkGodRaysCompositor* compositor, const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view,
  const int size[2])
{
  vtkGodRaysVolumeGrid::Numbers numbers;
  numbers.Scale = this->Model->GetDataScale();
  std::copy_n(this->Model->GetDataAlbedo(), 3, numbers.Albedo);
  numbers.PhaseFunction = this->Model->GetDataPhaseFunction();
  numbers.Asymmetry = this->Model->GetDataAsymmetry();
  numbers.Resolution = this->Model->GetDataResolution();
  std::string fault = this->Data.Take(renderer, compositor, numbers);
  fault = fault.empty() ? scene.GetFault() : fault;
  if (!fault.empty())
  {
    return fault;
  }
  vtkGodRaysView::Pinhole pinhole;
  return view.GetPinhole(size, pinhole)
    ? vtkGodRaysGate::FindFault(this->GetMedium(renderer, scene, view), view)
    : "the picture is tilted against the axis of view, or its pixels are oblong, in which light in "
      "a medium cannot be evaluated. Use a projection matrix without that, a window of "
      "another shape under a vtkDepthOfFieldPass, or a vtkGodRaysRadialModel";
}

bool vtkGodRaysMediumEffect::HasOwnProps(vtkRenderer* renderer) const
{
  return vtkGodRaysVolumeMedium::HasVolumes(renderer);
}

vtkGodRaysMedium vtkGodRaysMediumEffect::GetMedium(
  vtkRenderer* renderer, const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view) const
{
  return this->Model->GetMedium(view.WorldToView, scene.GetFarDepth(renderer), scene.GetDiagonal());
}

bool vtkGodRaysMediumEffect::DimsScene() const
{
  return this->Model->GetAttenuateScene();
}

void vtkGodRaysMediumEffect::SetUp(vtkGodRaysLightFinder& finder) const
{
  finder.LightsMedium = true;
  finder.AboveAir = vtkGodRaysAtmosphereModel::SafeDownCast(this->Model) != nullptr;
}

void vtkGodRaysMediumEffect::SetUp(
  vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator*) const
{
  request.LampsOcclude = false;
  request.Dims = false;
}

bool vtkGodRaysMediumEffect::FindMedium(vtkRenderer* renderer, const vtkGodRaysSceneSize& scene,
  const vtkGodRaysView& view, vtkGodRaysMedium& medium) const
{
  medium = this->GetMedium(renderer, scene, view);
  return this->DimsScene();
}

void vtkGodRaysMediumEffect::Begin(const Frame& frame)
{
  this->LastError = frame.Integrator->GetErrorEstimate();
  frame.Integrator->BeginVerification(!frame.Interactive);
  // On several processes the depth of the joined picture may be nowhere.
  vtkTextureObject* occluders = frame.Occlusion->GetDepth();
  const bool hasSeen =
    !frame.Compositor || !frame.Compositor->IsDistributed() || frame.Compositor->HasDepth();
  this->View = frame.View;
  this->LastView = *frame.View;
  this->LastUnit = this->Model->GetWorldUnitInMeters();
  this->HasNumbers = hasSeen;
  this->SeenDepth = hasSeen ? frame.SceneDepth : occluders;
  this->Depths.Begin(
    frame.Window, *frame.View, occluders, this->SeenDepth == occluders ? nullptr : this->SeenDepth);
  this->Medium = this->GetMedium(frame.Renderer, *frame.Scene, *frame.View);
  const vtkGodRaysMedium::Component& air = this->Medium.Components[0];
  this->SceneDepth = this->Medium.HasExponentialDensity()
    ? 0.0
    : frame.Scene->GetDiagonal() * (air.Scattering[1] + air.Absorption[1]);
  this->HiddenLamps = 0;
  this->Data.Begin();
  this->Diffuse.Begin();
  this->LightsToCome = frame.NumberOfLights;
  this->SingleReason = this->FindSingle(frame);
  this->DataError = frame.ErrorTolerance;
  this->HadData = false;
  if (!this->Data.IsEmpty() && frame.NumberOfLights == 0 && frame.Scatters)
  {
    vtkGodRaysLight none; // data dim without light, too
    none.Position[3] = 0.0;
    for (int i = 0; i < 3; ++i) // one direction of the world, whose depths are kept
    {
      none.Position[i] = frame.View->WorldToView[4 * i + 2];
    }
    this->HadData = this->Data.Draw(this->MakeRequest(frame, none), nullptr);
  }
}

std::string vtkGodRaysMediumEffect::Describe() const
{
  std::ostringstream text;
  if (this->SceneDepth > 0.0)
  {
    text << ", optical depth across the scene " << this->SceneDepth;
  }
  if (this->HiddenLamps > 0)
  {
    text << ", " << this->HiddenLamps << " lamp(s) in the planet's ground give no light";
  }
  text << this->Data.Describe() << this->Diffuse.Describe();
  if (!this->SingleReason.empty())
  {
    text << ", light is scattered once: " << this->SingleReason;
  }
  return text.str();
}

// Between the limits pictures are believable.
std::string vtkGodRaysMediumEffect::FindConcern() const
{
  if (this->Data.IsSplit())
  {
    return "volumes tagged MEDIUM are drawn by their mappers: on several processes their light "
           "is not computed. Give them another role";
  }
  const bool hides = this->SceneDepth > 5.0;
  if (!hides && !(this->SceneDepth > 0.0 && this->SceneDepth < 0.01))
  {
    return "";
  }
  std::ostringstream text;
  text << "the medium " << (hides ? "hides the scene" : "hardly shows")
       << ": its optical depth across it is " << this->SceneDepth
       << ", where 0.1 to 1 suits. Set OpticalDepth, WorldUnitInMeters, or "
       << (hides ? "less" : "more") << " scattering";
  return text.str();
}

vtkGodRaysMediumIntegrator::Request vtkGodRaysMediumEffect::MakeRequest(
  const Frame& frame, const vtkGodRaysLight& light)
{
  vtkGodRaysMediumIntegrator::Request request;
  request.Window = frame.Window;
  request.Renderer = frame.Renderer;
  request.Medium = &this->Medium;
  request.View = frame.View;
  request.Light = &light;
  request.Occluders = &frame.Occlusion->GetOccludingProps();
  request.Compositor = frame.Compositor;
  request.ErrorTolerance = frame.ErrorTolerance;
  request.Interactive = frame.Interactive;
  request.LastError = this->LastError;
  request.WantsShadows = !this->Data.IsEmpty();
  request.Depths = &this->Depths;
  request.Result = frame.Light;
  return request;
}

// With the shadows that the light in the air has, so that what data take of it is no more than there is.
bool vtkGodRaysMediumEffect::DrawData(const vtkGodRaysMediumIntegrator::Request& request,
  bool hasAir, vtkGodRaysMediumIntegrator* integrator, const vtkGodRaysDiffuseLight* diffuse)
{
  const vtkGodRaysShadowGrids* shadows =
    hasAir ? integrator->GetShadows() : integrator->DrawShadows(request);
  this->HadData = shadows && this->Data.Draw(request, shadows, diffuse);
  return this->HadData;
}

// Why all orders cannot be had; empty if they can, or are not asked for.
std::string vtkGodRaysMediumEffect::FindSingle(const Frame& frame) const
{
  return this->Model->GetScatteringOrders() == vtkGodRaysMediumModel::SINGLE ? ""
    : frame.Compositor && frame.Compositor->IsDistributed()
    ? "all orders are not found on several processes"
    : this->Medium.NumberOfComponents + this->Data.GetGrids().size() >
      vtkGodRaysTransportScene::MaximumComponents
    ? "all orders are found in at most 16 media"
    : "";
}

// Take a light, and find light of all orders once it is the last one.
bool vtkGodRaysMediumEffect::FindDiffuse(
  const Frame& frame, const vtkGodRaysMediumIntegrator::Request& request, bool estimates)
{
  const vtkGodRaysGridPicture* data = this->Data.IsEmpty() ? nullptr : this->Data.Prepare(request);
  if (!(data || this->Data.IsEmpty()) || !this->Diffuse.AddLight(request, data))
  {
    return false;
  }
  if (this->LightsToCome == 0)
  {
    this->Diffuse.Find(
      request, frame.Scene->GetBounds(), this->Data.GetGrids(), this->Data.GetVersion(), estimates);
  }
  return true;
}

bool vtkGodRaysMediumEffect::IsInGround(const vtkGodRaysLight& light) const
{
  const vtkGodRaysMedium& medium = this->Medium;
  const glm::dvec3 up(medium.Up[0], medium.Up[1], medium.Up[2]);
  const glm::dvec3 place(light.Position[0], light.Position[1], light.Position[2]);
  return medium.PlanetRadius > 0.0 && !light.IsInfinite() &&
    vtkGodRays::MediumStart(medium.PlanetRadius, medium.EyeHeight, up, place, up).x < 0.0;
}

bool vtkGodRaysMediumEffect::DrawLight(const Frame& frame, const vtkGodRaysLight& light)
{
  if (!frame.Scatters)
  {
    return true;
  }
  this->HiddenLamps += this->IsInGround(light) ? 1 : 0;
  vtkGodRaysMediumIntegrator::Request request = this->MakeRequest(frame, light);
  auto integrator = vtkGodRaysMediumIntegrator::SafeDownCast(frame.Integrator);
  frame.Timers->Start(vtkGodRaysTimers::SCATTERING);
  --this->LightsToCome;
  bool done = false;
  if (frame.Compositor && !frame.Compositor->IsRoot())
  {
    request.Depths = nullptr;
    request.Result = nullptr;
    request.WantsLayers = false;
    done = integrator->Contribute(request);
  }
  else
  {
    // A scene on several processes is nowhere as a whole.
    const bool isWhole = !frame.Compositor || !frame.Compositor->IsDistributed();
    vtkGodRaysVerification verification(integrator, *frame.Light);
    const bool hasAir = this->Data.IsEmpty() || this->Model->CanScatter();
    const bool all = this->Model->GetScatteringOrders() == vtkGodRaysMediumModel::ALL &&
      this->SingleReason.empty();
    done = (!hasAir || integrator->Integrate(request)) &&
      (!all || this->FindDiffuse(frame, request, verification.IsWanted()));
    const vtkGodRaysDiffuseLight* const diffuse =
      all && this->LightsToCome == 0 ? &this->Diffuse : nullptr;
    done = done && (this->Data.IsEmpty() || this->DrawData(request, hasAir, integrator, diffuse));
    const bool isMixed =
      diffuse && !this->Data.IsEmpty(); // what data scatter once is not known alone
    if (done && isWhole && verification.IsWanted() && !isMixed)
    {
      if (this->VerifiedData != this->Data.GetVersion())
      {
        this->Verification.SetGrids(this->Data.GetGrids());
        this->VerifiedData = this->Data.GetVersion();
      }
      this->Verification.Measure(request, verification);
    }
    done = done && (!diffuse || !this->Data.IsEmpty() || this->Diffuse.Add(request));
  }
  frame.Timers->Stop();
  return done;
}

void vtkGodRaysMediumEffect::Join(vtkGodRaysBlendPass::Request& request) const
{
  request.LargestExposure = 4.0; // its lights' unit is anybody's
  request.SparesData = false;    // light is before data, too, but for a stop at most
  if (this->DimsScene())
  {
    request.Medium = &this->Medium;
    request.View = this->View;
    request.Depth = this->SeenDepth;
    request.Veil = this->HadData ? this->Data.GetVeil() : nullptr;
  }
}

void vtkGodRaysMediumEffect::End()
{
  this->Depths.End();
  this->Data.End();
  this->SeenDepth = nullptr;
  this->View = nullptr;
}

bool vtkGodRaysMediumEffect::FillNumbers(const Reading& reading, vtkImageData* image) const
{
  if (this->HasNumbers)
  {
    // A pixel's transmittance is within four tolerances, see the tests of vtkGodRaysGridPicture.
    const std::vector<float>& left = this->Data.GetTransmittance();
    const bool hasData = this->HadData && left.size() == 3 * reading.WindowDepths.size();
    vtkGodRaysMediumNumbers::Fill(reading, this->LastView, this->Medium, this->LastUnit,
      hasData ? left.data() : nullptr, 4.0 * this->DataError, image);
    vtkGodRaysMediumNumbers::AddOrders(this->Diffuse.HasLight(), image);
    if (this->HadData)
    {
      double mean;
      double largest;
      this->Data.GetResamplingErrors(mean, largest);
      vtkGodRaysMediumNumbers::AddDataErrors(mean, largest, this->LastUnit, image);
    }
  }
  return this->HasNumbers;
}

void vtkGodRaysMediumEffect::Release(vtkWindow* window)
{
  this->Depths.Release(window);
  this->Data.Release(window);
  this->Diffuse.Release(window);
}
