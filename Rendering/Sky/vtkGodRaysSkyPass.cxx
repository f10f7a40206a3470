// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSkyPass.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysAtmosphere.h"
#include "vtkGodRaysAttachment.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysScene.h"
#include "vtkGodRaysSceneCopy.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSkyFS.h"
#include "vtkGodRaysSkyObserver.h"
#include "vtkGodRaysSkySource.h"
#include "vtkGodRaysSkyTable.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysSurfaceSky.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTransfer.h"
#include "vtkGodRaysView.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkGodRaysSkyPass);

vtkGodRaysSetFinite3Macro(vtkGodRaysSkyPass, Origin, -1e30, 1e30);
vtkGodRaysSetFiniteMacro(vtkGodRaysSkyPass, WorldUnitInMeters, 1e-12, 1e12);
vtkGodRaysSetFiniteMacro(vtkGodRaysSkyPass, Exposure, 0.0, 1e30);
vtkGodRaysSetModeMacro(vtkGodRaysSkyPass, DisplayTransfer, vtkGodRaysPass::POWER_TRANSFER);

using vtkGodRays::Luminance;
using vtkGodRays::ToVec3;
using vtkGodRays::Vec3;

namespace
{
/// Whether the sky is drawn after the scene, where nothing is. That takes less, but all of the scene needs
/// depth, and edges must not be smoothed with what is behind them before. SSAO clears what is behind.
bool IsDrawnAfter(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** props = s->GetPropArray();
  const auto isOpaque = [](vtkProp* prop)
  {
    return vtkGodRaysIsOverlay(prop) ||
      (vtkActor::SafeDownCast(prop) && !prop->HasTranslucentPolygonalGeometry());
  };
  return renderer->GetUseSSAO() ||
    (!renderer->GetUseFXAA() && std::all_of(props, props + s->GetPropArrayCount(), isOpaque));
}

/// The weights of red, green and blue: with white balance, those for which SunIrradiance is grey.
Vec3 GetWeights(vtkGodRaysSkyPass* sky)
{
  const Vec3 sun = ToVec3(sky->GetAtmosphere()->GetSunIrradiance());
  Vec3 weights(1.0);
  for (int i = 0; i < 3; ++i)
  {
    weights[i] = sky->GetWhiteBalance() && sun[i] > 0.0 ? Luminance(sun) / sun[i] : 1.0;
  }
  return weights;
}

void SetVector(vtkShaderProgram* program, const char* name, const Vec3& value)
{
  vtkGodRaysQuad::SetVector(program, name, &value[0]);
}
}

struct vtkGodRaysSkyPass::Internals
{
  vtkNew<vtkGodRaysSkySource> Source; // of the atmosphere's tables and of the sun's colour
  vtkNew<vtkImageData> Repeated;      // light that is scattered more than once
  vtkMTimeType RepeatedTime = 0;      // of the atmosphere that it is of
  vtkNew<vtkTexture> Environment;
  vtkMTimeType EnvironmentTime = 0;  // of the source when its picture was made
  Vec3 EnvironmentGain = Vec3(-1.0); // of that picture
  vtkNew<vtkGodRaysSurfaceSky> Surfaces;

  vtkGodRaysAttachment Attachment;
  vtkSmartPointer<vtkGodRaysCompositor> Compositor;
  vtkNew<vtkGodRaysScene> RendererSteps;
  vtkGodRaysSkyTable Table{ vtkGodRaysSkyTable::WHOLE };
  vtkGodRaysSkyTable Air{ vtkGodRaysSkyTable::PARTS };
  vtkGodRaysSceneCopy Scene; // colour and depth of the viewport
  vtkGodRaysQuad Quad{ "vtkGodRaysSkyFS", vtkGodRaysSkyFS };

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the resources
  vtkMTimeType ContextTime = 0;                 // when its context was made
  vtkGodRaysView View;                          // of this frame
  vtkGodRaysSkyObserver Observer;
  vtkGodRaysLight Sun;
  vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB;
  bool Bytes = false;      // of the framebuffer of this frame
  bool DrawsScene = false; // at this moment
  std::string Plan;
  std::string Complaint; // that has been made already

  void Release(vtkWindow* window)
  {
    this->Table.Release(window);
    this->Air.Release(window);
    this->Scene.Release(window);
    this->Quad.Release();
    this->Surfaces->Remove();
    this->Window = nullptr;
  }
  ~Internals() { this->Surfaces->Remove(); }
};

vtkGodRaysSkyPass::vtkGodRaysSkyPass()
  : Internal(new Internals)
{
  Internals& self = *this->Internal;
  self.Source->SetMapping(vtkGodRaysSkySource::EQUIRECTANGULAR);
  self.Source->SetResolution(64);
  self.Source->SetObserverHeight(0.0);
  self.Environment->SetColorModeToDirectScalars();
  self.Environment->InterpolateOn();
  self.Environment->MipmapOn();
}

vtkGodRaysSkyPass::~vtkGodRaysSkyPass() = default;

vtkGodRaysSkyPass* vtkGodRaysSkyPass::Attach(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("vtkGodRaysSkyPass::Attach needs a vtkRenderer, not null.");
    return nullptr;
  }
  if (auto known = Find(renderer))
  {
    return known;
  }
  vtkNew<vtkGodRaysSkyPass> sky;
  sky->Internal->Attachment.Attach(sky, renderer);
  return sky;
}

bool vtkGodRaysSkyPass::Detach(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkGodRaysSkyPass> sky = Find(renderer);
  if (!sky)
  {
    return false;
  }
  Internals& self = *sky->Internal;
  if (self.Window)
  {
    self.Window->MakeCurrent();
    self.Release(self.Window);
  }
  self.Attachment.Detach(sky, renderer);
  return Find(renderer) != sky;
}

vtkGodRaysSkyPass* vtkGodRaysSkyPass::Find(vtkRenderer* renderer)
{
  return renderer ? vtkGodRaysAttachment::Find<vtkGodRaysSkyPass>(renderer) : nullptr;
}

void vtkGodRaysSkyPass::SetAtmosphere(vtkGodRaysAtmosphere* atmosphere)
{
  if (!atmosphere || atmosphere != this->GetAtmosphere())
  {
    this->Internal->Source->SetAtmosphere(atmosphere);
    this->Modified();
  }
}

vtkGodRaysAtmosphere* vtkGodRaysSkyPass::GetAtmosphere()
{
  return this->Internal->Source->GetAtmosphere();
}

void vtkGodRaysSkyPass::SetCompositor(vtkGodRaysCompositor* compositor)
{
  if (this->Internal->Compositor != compositor)
  {
    this->Internal->Compositor = compositor;
    this->Modified();
  }
}

vtkGodRaysCompositor* vtkGodRaysSkyPass::GetCompositor()
{
  return this->Internal->Compositor;
}

void vtkGodRaysSkyPass::SetSun(vtkGodRaysSun* sun)
{
  if (!sun || sun != this->GetSun())
  {
    this->Internal->Source->SetSun(sun);
    this->Modified();
  }
}

vtkGodRaysSun* vtkGodRaysSkyPass::GetSun()
{
  return this->Internal->Source->GetSun();
}

#define vtkGodRaysForwardAngleMacro(name)                                                          \
  void vtkGodRaysSkyPass::SetSun##name(double degrees)                                             \
  {                                                                                                \
    this->Internal->Source->SetSun##name(degrees);                                                 \
  }                                                                                                \
  double vtkGodRaysSkyPass::GetSun##name()                                                         \
  {                                                                                                \
    return this->Internal->Source->GetSun##name();                                                 \
  }
vtkGodRaysForwardAngleMacro(Elevation);
vtkGodRaysForwardAngleMacro(Azimuth);

#define vtkGodRaysForwardAxisMacro(name)                                                           \
  void vtkGodRaysSkyPass::Set##name(const double direction[3])                                     \
  {                                                                                                \
    this->GetSun()->SetFrame(vtkGodRaysSun::UP_AND_NORTH);                                         \
    this->GetSun()->Set##name(direction);                                                          \
  }                                                                                                \
  void vtkGodRaysSkyPass::Set##name(double x, double y, double z)                                  \
  {                                                                                                \
    const double direction[3] = { x, y, z };                                                       \
    this->Set##name(direction);                                                                    \
  }                                                                                                \
  double* vtkGodRaysSkyPass::Get##name()                                                           \
  {                                                                                                \
    return this->GetSun()->Get##name();                                                            \
  }
vtkGodRaysForwardAxisMacro(Up);
vtkGodRaysForwardAxisMacro(North);

void vtkGodRaysSkyPass::PrepareSource()
{
  this->Internal->Source->SetMultipleScattering(this->MultipleScattering);
}

void vtkGodRaysSkyPass::GetSunColor(double irradiance[3])
{
  this->PrepareSource();
  this->Internal->Source->GetSunLight(irradiance);
  const Vec3 weights = GetWeights(this);
  std::transform(irradiance, irradiance + 3, &weights[0], irradiance, std::multiplies<>());
}

bool vtkGodRaysSkyPass::GetSkyColor(const double direction[3], double radiance[3])
{
  this->PrepareSource();
  const bool done = this->Internal->Source->GetRadiance(direction, radiance);
  const Vec3 weights = GetWeights(this);
  std::transform(radiance, radiance + 3, &weights[0], radiance, std::multiplies<>());
  return done;
}

bool vtkGodRaysSkyPass::GetSkyIrradiance(const double normal[3], double irradiance[3])
{
  this->PrepareSource();
  const bool done = this->Internal->Source->GetIrradiance(normal, irradiance);
  const Vec3 weights = GetWeights(this);
  std::transform(irradiance, irradiance + 3, &weights[0], irradiance, std::multiplies<>());
  return done;
}

bool vtkGodRaysSkyPass::UpdateLight(vtkLight* light)
{
  if (!this->GetSun()->UpdateLight(light))
  {
    return false;
  }
  double color[3];
  this->GetSunColor(color);
  const double brightest = std::max({ color[0], color[1], color[2] });
  for (double& channel : color)
  {
    channel = vtkGodRays::EncodeDisplay(brightest > 0.0 ? channel / brightest : 0.0);
  }
  light->SetColor(color);
  light->SetIntensity(brightest * this->Exposure / vtkMath::Pi());
  // An atmosphere's model dims it itself. The last number of a form is 3/32 of the integral of radiance.
  Vec3 above = this->Exposure * GetWeights(this);
  double forms[48] = {};
  if (this->SurfaceLight)
  {
    this->Internal->Source->GetIrradianceForms(forms);
  }
  Vec3 sky = above * 8.0 / 3.0 / vtkMath::Pi() * Vec3(forms[15], forms[31], forms[47]);
  above *= ToVec3(this->GetAtmosphere()->GetSunIrradiance()) / vtkMath::Pi();
  vtkGodRaysSetLightAboveAir(light, &above[0], &sky[0]);
  return true;
}

vtkTexture* vtkGodRaysSkyPass::GetEnvironmentTexture()
{
  Internals& self = *this->Internal;
  this->PrepareSource();
  const Vec3 gain = this->Exposure * GetWeights(this);
  if (self.Source->GetMTime() == self.EnvironmentTime && gain == self.EnvironmentGain)
  {
    return self.Environment;
  }
  self.Source->Update();
  vtkImageData* sky = self.Source->GetOutput();
  if (sky->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  vtkNew<vtkImageData> image;
  image->DeepCopy(sky);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < 3 * image->GetNumberOfPoints(); ++i)
  {
    values[i] *= static_cast<float>(gain[i % 3]);
  }
  self.Environment->SetInputData(image);
  self.EnvironmentTime = self.Source->GetMTime();
  self.EnvironmentGain = gain;
  return self.Environment;
}

std::string vtkGodRaysSkyPass::GetPlan() const
{
  return this->Internal->Plan;
}

const char* vtkGodRaysSkyPass::FindReasonForNoSky(
  const vtkRenderState* s, vtkOpenGLRenderWindow* window)
{
  if (!window)
  {
    this->Complain("sky", "the render window is not an OpenGL window. Use VTK's OpenGL back end");
    return "the window is not an OpenGL one";
  }
  if (s->GetRenderer()->GetSelector())
  {
    return "a hardware selection is made";
  }
  vtkGodRaysCompositor* compositor = this->Internal->Compositor;
  if (compositor && !compositor->IsRoot())
  {
    return "another process has the joined picture";
  }
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  if (viewport[2] < 1 || viewport[3] < 1)
  {
    return "the viewport is empty";
  }
  if (vtkRenderPass* hiding = vtkGodRaysAttachment::FindWithoutDepth(this->DelegatePass))
  {
    this->Complain("sky",
      std::string("under it there is a ") + hiding->GetClassName() +
        ", which leaves no depth of the scene. Make this pass the delegate of that one, as "
        "Attach() does");
    return "what is under it leaves no depth";
  }
  const std::string fault = this->GetAtmosphere()->FindFault();
  if (!fault.empty())
  {
    this->Complain("sky", fault.substr(0, fault.size() - 1));
    return "the atmosphere cannot be used";
  }
  double sun[3];
  if (!this->GetSun()->GetDirection(s->GetRenderer()->GetActiveCamera(), sun))
  {
    this->Complain(
      "sky", "Up and North are parallel, or one of them is 0. Set directions that are not");
    return "there is no direction to the sun";
  }
  return nullptr;
}

// The camera and the sun as this frame has them.
void vtkGodRaysSkyPass::SetObserver(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkCamera* camera = s->GetRenderer()->GetActiveCamera();
  double sun[4] = { 0.0, 0.0, 0.0, 0.0 };
  this->GetSun()->GetDirection(camera, sun);
  double up[3], north[3];
  this->GetSun()->GetAxes(camera, up, north);
  const bool isOfCamera = this->GetSun()->GetFrame() == vtkGodRaysSun::CAMERA;
  vtkGodRaysPlanet planet;
  planet.Origin = ToVec3(isOfCamera ? camera->GetPosition() : this->Origin);
  planet.Up = normalize(ToVec3(up));
  planet.Sun = ToVec3(sun);
  planet.GroundRadius = this->GetAtmosphere()->GetGroundRadius();
  planet.WorldUnitInMeters = this->WorldUnitInMeters;

  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  self.Transfer = vtkGodRaysFindTransfer(this->DisplayTransfer, s->GetRenderer(), this);
  vtkGodRaysScene::UpdateStereo(s->GetRenderer());
  self.View.Set(s->GetRenderer(), viewport + 2, 0.0);
  self.Observer.Set(self.View, planet);
  self.Sun.Place(self.View, sun, vtkGodRays::GetDiscRadius(this->GetSun(), this->GetAtmosphere()));
}

void vtkGodRaysSkyPass::Render(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  auto window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
  if (self.DrawsScene)
  {
    this->Complain("the delegate of this pass", "it leads back to this pass. Set another, or none");
    self.RendererSteps->Render(s);
    return;
  }
  if (const char* reason = this->FindReasonForNoSky(s, window))
  {
    self.Plan = std::string("sky: none, ") + reason + "\n";
    if (self.Compositor &&
      !self.Compositor->IsRoot()) // the joined picture has this process's surfaces
    {
      this->LightSurfaces(s);
    }
    this->RenderScene(s);
    return;
  }
  if (self.Window != window || self.ContextTime != window->GetContextCreationTime())
  {
    // also if the former window, or its context, is gone
    self.Release(self.Window ? self.Window.Get() : window);
    window->MakeCurrent(); // see vtkGodRaysPass::Render()
    self.Window = window;
    self.ContextTime = window->GetContextCreationTime();
  }
  this->SetObserver(s);
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  const std::string fault = vtkGodRaysGate::FindFault(s->GetRenderer(), self.View, viewport + 2);
  if (!fault.empty())
  {
    this->Complain("sky", fault);
    self.Plan = "sky: none, " + fault + "\n";
    this->RenderScene(s);
    return;
  }
  self.Plan = self.Observer.Describe();

  this->LightSurfaces(s);
  vtkGodRaysOverlays overlays(s);
  const int failures = vtkGodRaysQuad::GetNumberOfFailures();
  bool drawn = true;
  if (this->DelegatePass || IsDrawnAfter(s))
  {
    this->RenderScene(s);
    drawn = this->DrawSky(s);
  }
  else
  {
    self.RendererSteps->SetBackdrop(
      [&]
      {
        drawn = this->DrawSky(s);
        vtkOpenGLCheckErrorMacro("failed after DrawSky");
      });
    this->RenderScene(s);
    self.RendererSteps->SetBackdrop(nullptr);
  }
  if (const char* reason = this->FindReasonForNoAir(s))
  {
    self.Plan += std::string("air: none, ") + reason + "\n";
  }
  else
  {
    drawn = this->DrawAir(s) && drawn;
  }
  if (!drawn)
  {
    if (vtkGodRaysQuad::GetNumberOfFailures() == failures)
    {
      this->Complain("sky",
        "the framebuffer of this window cannot be copied or drawn into. Render into a "
        "window or framebuffer with a depth buffer and 8-bit or floating-point RGBA "
        "colours");
    }
    if (!this->JoinsPictures()) // other processes would wait
    {
      this->RenderScene(s); // over what there is of a sky
    }
  }
  overlays.Draw();
  vtkOpenGLCheckErrorMacro("failed after Render");
}

void vtkGodRaysSkyPass::RenderScene(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkRenderPass* scene = this->DelegatePass;
  if (!scene)
  {
    scene = self.RendererSteps;
  }
  self.DrawsScene = true;
  scene->Render(s);
  self.DrawsScene = false;
  self.Surfaces->End();
  vtkOpenGLClearErrorMacro(); // of VTK's passes, which a VTK without debugging does not tell of
  this->NumberOfRenderedProps = scene->GetNumberOfRenderedProps();
}

// Why surfaces have no light of the sky, or null.
const char* vtkGodRaysSkyPass::FindReasonForNoLight(const vtkRenderState* s)
{
  if (!this->SurfaceLight)
  {
    return "SurfaceLight is off";
  }
  double bounds[6];
  s->GetRenderer()->ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  if (box.IsValid() &&
    box.GetDiagonalLength() * this->WorldUnitInMeters >
      0.05 * this->GetAtmosphere()->GetGroundRadius())
  {
    return "the scene is so large that it has more than one sky";
  }
  double sun[3];
  const bool hasSky = this->GetAtmosphere()->FindFault().empty() &&
    this->GetSun()->GetDirection(s->GetRenderer()->GetActiveCamera(), sun);
  return hasSky ? nullptr : "there is none";
}

// For the scene that is drawn next.
void vtkGodRaysSkyPass::LightSurfaces(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  if (const char* reason = this->FindReasonForNoLight(s))
  {
    self.Plan += std::string("surfaces: without light of the sky, ") + reason + "\n";
    self.Surfaces->Remove();
    return;
  }
  vtkGodRaysSurfaceSky::Request request;
  this->PrepareSource();
  self.Source->GetIrradianceForms(request.Forms);
  request.Gain = this->Exposure / vtkMath::Pi() * GetWeights(this);
  this->GetSun()->GetAxes(s->GetRenderer()->GetActiveCamera(), request.Up, request.North);
  self.Surfaces->Begin(s->GetRenderer(), request);
  self.Plan += "surfaces: light of the sky\n";
}

// Why there is no air before the scene, or null.
const char* vtkGodRaysSkyPass::FindReasonForNoAir(const vtkRenderState* s)
{
  if (!this->AerialPerspective)
  {
    return "AerialPerspective is off";
  }
  if (s->GetPropArrayCount() == 0)
  {
    return "there is no scene";
  }
  if (this->JoinsPictures() && !this->Internal->Compositor->HasDepth())
  {
    return "the picture is joined without depth";
  }
  const double way =
    s->GetRenderer()->GetActiveCamera()->GetClippingRange()[1] * this->WorldUnitInMeters;
  const vtkGodRays::SkyAtmosphere sky = vtkGodRays::MakeSkyAtmosphere(this->GetAtmosphere());
  const Vec3 depth = way * (sky.AirScattering + sky.AerosolExtinction + sky.Absorption);
  if (std::max({ depth.x, depth.y, depth.z }) < 5e-4)
  {
    return "it is too little";
  }
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  vtkGodRaysView::Pinhole pinhole;
  if (!this->Internal->View.GetPinhole(viewport + 2, pinhole))
  {
    this->Complain("the air before it",
      "the picture is tilted against the axis of view, or its pixels are oblong. Use a projection "
      "matrix without that, a window of another shape under a vtkDepthOfFieldPass, or switch "
      "AerialPerspective off");
    return "the projection is not one that it takes";
  }
  return nullptr;
}

bool vtkGodRaysSkyPass::UpdateTable(vtkGodRaysSkyTable& table, const char* name)
{
  Internals& self = *this->Internal;
  vtkGodRaysAtmosphere* atmosphere = this->GetAtmosphere();
  vtkGodRaysSkyTable::Request request;
  request.Sky = vtkGodRays::MakeSkyAtmosphere(atmosphere);
  request.Albedo = ToVec3(atmosphere->GetGroundAlbedo());
  request.Time = atmosphere->GetMTime();
  request.Height = self.Observer.Height;
  request.SunSlope = self.Observer.Sun.z;
  if (this->MultipleScattering)
  {
    if (self.RepeatedTime != request.Time)
    {
      self.Source->GetMultipleScattering(self.Repeated);
      self.RepeatedTime = request.Time;
    }
    request.Repeated = self.Repeated;
  }
  const bool done = table.Update(self.Window, request);
  const std::string& reason = table.GetReason();
  self.Plan += name;
  self.Plan += !done ? "none, after an error"
    : reason.empty() ? "the table is kept"
                     : "a new table, as " + reason;
  self.Plan += "\n";
  this->NumberOfTables += reason.empty() ? 0 : 1;
  return done;
}

bool vtkGodRaysSkyPass::JoinsPictures() const
{
  return this->Internal->Compositor && this->Internal->Compositor->IsDistributed();
}

bool vtkGodRaysSkyPass::DrawSky(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkOpenGLState* state = self.Window->GetState();
  const vtkGodRaysStateKeeper keeper(state);
  const vtkGodRaysFramebuffer bound;
  self.Bytes = bound.Formats.Color == GL_RGBA8;
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  if (!this->UpdateTable(self.Table, "sky: "))
  {
    return false;
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.Binding);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const int whole[4] = { 0, viewport[2], 0, viewport[3] };
  bool drawn = this->JoinsPictures() || this->Draw(viewport, whole, SKY);
  if (this->SunDisc && !self.View.Parallel && self.Sun.Reaches(self.View, false))
  {
    int disc[4];
    self.Sun.GetDiscBounds(self.View, viewport + 2, disc);
    drawn = drawn && this->Draw(viewport, disc, SKY_WITH_SUN);
  }
  // Under a joined picture, what is drawn first remains.
  return drawn && (!this->JoinsPictures() || this->Draw(viewport, whole, SKY));
}

bool vtkGodRaysSkyPass::DrawAir(const vtkRenderState* s)
{
  Internals& self = *this->Internal;
  vtkOpenGLState* state = self.Window->GetState();
  const vtkGodRaysStateKeeper keeper(state);
  const vtkGodRaysFramebuffer bound;
  self.Bytes = bound.Formats.Color == GL_RGBA8;
  int viewport[4];
  vtkGodRaysScene::GetViewport(s, viewport);
  if (!bound.Formats.Color || !bound.Formats.Depth || !this->UpdateTable(self.Air, "air: ") ||
    !self.Scene.Copy(self.Window, bound, viewport, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT))
  {
    return false;
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound.Binding);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  const int whole[4] = { 0, viewport[2], 0, viewport[3] };
  return this->Draw(viewport, whole, AIR);
}

// Draw a part of the viewport: first and past the last column, first and past the last row.
bool vtkGodRaysSkyPass::Draw(const int viewport[4], const int part[4], Stage stage)
{
  Internals& self = *this->Internal;
  vtkGodRaysAtmosphere* atmosphere = this->GetAtmosphere();
  const vtkGodRaysSkyTable& table = stage == AIR ? self.Air : self.Table;
  static_assert(vtkGodRaysLastPhaseFunction < 8, "a kind of phase function has three bits");
  const int kind = atmosphere->GetMiePhaseFunction();
  vtkShaderProgram* program = self.Quad.Begin(self.Window,
    { { "isPower", self.Transfer == vtkGodRaysTransfer::POWER }, { "beforeScene", stage == AIR },
      { "shoulder", self.Bytes && this->HighlightShoulder },
      { "dithered", self.Bytes && this->Dithering }, { "hasDisc", stage == SKY_WITH_SUN },
      { "hasEdge", stage != AIR && table.GetEdges().y < 1.0 }, { "phaseBit0", (kind & 1) != 0 },
      { "phaseBit1", (kind & 2) != 0 }, { "phaseBit2", (kind & 4) != 0 } });
  if (!program)
  {
    return false;
  }
  table.SetUniforms(self.Quad, program);
  vtkGodRaysSkyTable::SetAtmosphere(program, vtkGodRays::MakeSkyAtmosphere(atmosphere));
  program->SetUniformf("height", static_cast<float>(self.Observer.Height));
  SetVector(program, "sun", self.Observer.Sun);
  SetVector(program, "pictureOrigin", self.Observer.PictureOrigin);
  SetVector(program, "pictureRight", self.Observer.PictureRight);
  SetVector(program, "pictureUp", self.Observer.PictureUp);
  const Vec3 irradiance =
    this->Exposure * GetWeights(this) * ToVec3(atmosphere->GetSunIrradiance());
  SetVector(program, "irradiance", irradiance);
  program->SetUniform2i("corner", viewport);
  if (stage == SKY_WITH_SUN)
  {
    const float pixelSize[2] = { 2.0f / static_cast<float>(viewport[2]),
      2.0f / static_cast<float>(viewport[3]) };
    program->SetUniform2f("pixelSize", pixelSize);
    const double radius = vtkGodRays::GetDiscRadius(this->GetSun(), atmosphere);
    program->SetUniformf("discRadius", static_cast<float>(radius));
    const double solidAngle = 2.0 * vtkMath::Pi() * (1.0 - std::cos(radius));
    SetVector(program, "discRadiance", irradiance / solidAngle);
  }
  if (stage == AIR)
  {
    self.Quad.SetTexture("scene", self.Scene.GetColor());
    self.Quad.SetTexture("depth", self.Scene.GetDepth());
    SetVector(program, "axis", self.Observer.Axis);
    program->SetUniformf("sceneUnit", static_cast<float>(this->WorldUnitInMeters));
    vtkGodRaysView::Pinhole pinhole;
    self.View.GetPinhole(viewport + 2, pinhole);
    const float terms[4] = { static_cast<float>(pinhole.Depth[0]),
      static_cast<float>(pinhole.Depth[1]), static_cast<float>(pinhole.Depth[2]),
      static_cast<float>(pinhole.Depth[3]) };
    program->SetUniform4f("depthTerms", terms);
  }
  const bool under = stage != AIR && this->JoinsPictures();
  vtkOpenGLState* state = self.Window->GetState();
  state->SetEnumState(GL_BLEND, under);
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  state->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglScissor(
    viewport[0] + part[0], viewport[1] + part[2], part[1] - part[0], part[3] - part[2]);
  self.Quad.End(stage == AIR ? vtkGodRaysQuad::BEFORE
      : under                ? vtkGodRaysQuad::EVERYWHERE
                             : vtkGodRaysQuad::BEHIND);
  return true;
}

void vtkGodRaysSkyPass::Complain(const char* what, const std::string& reason)
{
  const std::string complaint = std::string("without ") + what + ": " + reason;
  if (this->Internal->Complaint != complaint)
  {
    this->Internal->Complaint = complaint;
    vtkErrorMacro("The scene is drawn " << complaint << ".");
  }
}

void vtkGodRaysSkyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Release(window);
  this->Internal->RendererSteps->ReleaseGraphicsResources(window);
}

vtkMTimeType vtkGodRaysSkyPass::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->GetAtmosphere()->GetMTime(),
    this->GetSun()->GetMTime() });
}

void vtkGodRaysSkyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "WorldUnitInMeters: " << this->WorldUnitInMeters << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "WhiteBalance: " << this->WhiteBalance << "\n";
  os << indent << "DisplayTransfer: " << this->DisplayTransfer << "\n";
  os << indent << "HighlightShoulder: " << (this->HighlightShoulder ? "on" : "off") << "\n";
  os << indent << "Dithering: " << (this->Dithering ? "on" : "off") << "\n";
  os << indent << "SunDisc: " << (this->SunDisc ? "on" : "off") << "\n";
  os << indent << "AerialPerspective: " << (this->AerialPerspective ? "on" : "off") << "\n";
  os << indent << "SurfaceLight: " << (this->SurfaceLight ? "on" : "off") << "\n";
  os << indent << "MultipleScattering: " << (this->MultipleScattering ? "on" : "off") << "\n";
  os << indent << "NumberOfTables: " << this->NumberOfTables << "\n";
  os << indent << "Sun:\n";
  this->GetSun()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Atmosphere:\n";
  this->GetAtmosphere()->PrintSelf(os, indent.GetNextIndent());
}
