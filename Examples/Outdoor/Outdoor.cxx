// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// Outdoors: the sun behind clouds, mountains, and a fire on a slope with its smoke.
// Or, with the argument baked, shafts of the clouds behind everything; or, with medium, in haze and smoke
// that scatter light.

#include "../ExampleWindow.h"
#include "BakeSky.h"

#include "vtkActor.h"
#include "vtkAssignAttribute.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGodRaysAtmosphereModel.h"
#include "vtkGodRaysCloudLayerSource.h"
#include "vtkGodRaysFireSource.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSmokeSource.h"
#include "vtkGodRaysTerrainSource.h"
#include "vtkLight.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWarpScalar.h"

#include <initializer_list>
#include <string>

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  vtkNew<vtkRenderer> renderer;
  auto add = [&](vtkActor* actor, vtkPolyDataMapper* mapper, vtkAlgorithm* source)
  {
    mapper->SetInputConnection(source->GetOutputPort());
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  };

  // The unit is 100 m; x is west, y south and z up. Mountains, 6 km wide:
  vtkNew<vtkGodRaysTerrainSource> heights;
  heights->SetDimensions(801, 801);
  heights->SetWidth(60.0);
  heights->SetHeight(11.0);
  heights->SetFeatures(3.0);
  heights->SetGain(0.45);
  heights->SetSeed(3);
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(heights->GetOutputPort());
  warp->UseNormalOn();
  warp->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkAssignAttribute> normals;
  normals->SetInputConnection(warp->GetOutputPort());
  normals->Assign("Normals", "NORMALS", "POINT_DATA");
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(normals->GetOutputPort());
  vtkNew<vtkPolyDataMapper> colors;
  colors->SetScalarModeToUsePointFieldData();
  colors->SelectColorArray("Color");
  vtkNew<vtkActor> ground;
  ground->GetProperty()->SetAmbient(0.2);
  add(ground, colors, surface);

  // Clouds are translucent geometry: they let through what their opacity leaves.
  vtkNew<vtkGodRaysCloudLayerSource> layer;
  layer->SetWidth(160.0);
  layer->SetAltitude(10.0);
  layer->SetCloudSize(4.0);
  layer->SetCoverage(0.65);
  layer->SetSoftness(0.3);
  layer->SetColor(0.25, 0.25, 0.26);
  layer->SetResolution(600);
  layer->SetWindSpeed(1.0);
  layer->SetSeed(15);
  layer->SetEndTime(1000.0);
  vtkNew<vtkActor> clouds;
  clouds->GetProperty()->LightingOff();
  clouds->ForceTranslucentOn();
  add(clouds, vtkNew<vtkPolyDataMapper>(), layer);

  // So does smoke, which is a volume. The fire below it shines.
  vtkNew<vtkGodRaysSmokeSource> plume;
  plume->SetDimensions(48, 48, 72);
  plume->SetSpacing(1.0 / 15.0);
  plume->SetDiffusivity(0.002);
  plume->SetTurbulence(1.4);
  plume->SetTurbulenceSize(0.8);
  plume->SetSourceRadius(0.25);
  plume->SetSourceRate(8.0);
  plume->SetTimeStep(0.01);
  plume->SetEndTime(1000.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.6);
  vtkNew<vtkColorTransferFunction> grey;
  grey->AddRGBPoint(0.0, 0.12, 0.12, 0.12);
  grey->AddRGBPoint(1.0, 0.36, 0.36, 0.36);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputConnection(plume->GetOutputPort());
  vtkNew<vtkVolume> smoke;
  smoke->SetMapper(mapper);
  smoke->SetPosition(3.0, -20.5, 0.3);
  smoke->GetProperty()->SetScalarOpacity(opacity);
  smoke->GetProperty()->SetScalarOpacityUnitDistance(0.15);
  smoke->GetProperty()->SetColor(grey);
  smoke->GetProperty()->SetInterpolationTypeToLinear();
  renderer->AddVolume(smoke);

  vtkNew<vtkGodRaysFireSource> fire;
  fire->SetCenter(3.0, -20.5, -0.05); // on the ground
  fire->SetTurbulence(0.8);
  fire->SetOpacity(0.03);
  fire->SetEndTime(1000.0);
  vtkNew<vtkPointGaussianMapper> particles;
  particles->SetScaleArray("Size");
  particles->SetScaleFactor(1.0);
  particles->EmissiveOn();
  vtkNew<vtkActor> flames;
  add(flames, particles, fire);

  vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
  sky->SetWorldUnitInMeters(100.0);
  sky->SetNorth(0.0, -1.0, 0.0);
  sky->SetSunElevation(11.0);
  sky->SetSunAzimuth(176.0);
  sky->SetExposure(4.0);
  sky->SurfaceLightOff(); // which a sky without clouds would give
  vtkNew<vtkLight> sun;
  sky->UpdateLight(sun);
  vtkNew<vtkLight> shade; // what the clouds leave of it
  shade->SetPosition(-0.5, -1.0, 1.0);
  shade->SetColor(0.2, 0.22, 0.26);
  renderer->AddLight(sun);
  renderer->AddLight(shade);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -29.0, 0.1);
  camera->SetFocalPoint(0.0, 0.0, 6.2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(55.0);
  camera->SetClippingRange(0.2, 200.0);

  const std::string last = argc > 1 ? argv[argc - 1] : "";
  const std::string mode = last == "baked" || last == "medium" ? last : "";
  vtkNew<vtkGodRaysPass> rays;
  rays->SetAutomaticExposure(false); // the sky behind says how bright the sun is
  if (mode == "medium")
  {
    // Haze, with a visibility of 39 km on the ground. Molecules are in the sky already, so the haze has a
    // light of its own: of the sky's it would take the colour above the air.
    vtkNew<vtkLight> low;
    low->SetPosition(sun->GetPosition());
    low->SetColor(sun->GetDiffuseColor());
    low->SetIntensity(sun->GetIntensity());
    rays->AddLight(low);
    vtkNew<vtkGodRaysAtmosphereModel> haze;
    haze->SetMieScattering(1e-4, 1e-4, 1e-4);
    haze->SetMieScaleHeight(600.0);
    haze->SetRayleighScattering(0.0, 0.0, 0.0);
    haze->SetWorldUnitInMeters(100.0);
    rays->SetModel(haze);
    rays->SetIntensity(sky->GetExposure());
    vtkGodRaysPass::SetRole(smoke, vtkGodRaysPass::MEDIUM);
  }
  else
  {
    rays->AddLight(sun);
    vtkGodRaysPass::SetRole(flames, vtkGodRaysPass::LIGHT);
    rays->ApplyPreset("low-sun");
    rays->SetIntensity(0.75);
    rays->SetSunAngularRadius(6.0); // the sun is hidden: what shines is the bright sky about it
    rays->SetBackgroundGlow(0.0);
  }
  rays->Attach(renderer);

  double time = 4.98; // [s]; a second is ten of the clock
  auto advance = [&]()
  {
    time += 0.02;
    layer->UpdateTimeStep(time);
    plume->UpdateTimeStep(time);
    fire->UpdateTimeStep(time);
  };
  advance();
  if (mode == "baked")
  {
    // The shafts of the clouds alone, once, behind everything. They are made short enough to end within a
    // face of the panorama: sums along lines of one picture do not go on in the next. Their fall is measured
    // in heights of a picture, and streaks in angles in it: a face has others.
    auto model = vtkGodRaysRadialModel::SafeDownCast(rays->GetModel());
    model->SetDensity(0.85);
    model->SetReach(0.0);
    model->SetStreaks(0.0);
    const std::initializer_list<vtkProp*> scene = { ground, smoke, flames };
    for (vtkProp* prop : scene)
    {
      prop->VisibilityOff();
    }
    renderer->AddActor(BakeSky(renderer));
    for (vtkProp* prop : scene)
    {
      prop->VisibilityOn();
    }
    clouds->VisibilityOff();
    rays->Detach(renderer);
  }

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  return ShowOrWrite(window, size, argc - !mode.empty(), argv, advance);
}
