// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPassInternals.h
 * @brief   what a vtkGodRaysPass has besides its parameters; private to it
 */

#ifndef vtkGodRaysPassInternals_h
#define vtkGodRaysPassInternals_h

#include "vtkGodRaysAttachment.h"
#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysDataLights.h"
#include "vtkGodRaysEffect.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysLightMeter.h"
#include "vtkGodRaysModel.h"
#include "vtkGodRaysOcclusionPass.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysScene.h"
#include "vtkGodRaysSceneCopy.h"
#include "vtkGodRaysSceneSize.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkGodRaysSurfaceShadows.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTimers.h"
#include "vtkGodRaysTransfer.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

struct vtkGodRaysPass::Internals
{
  ~Internals() { this->Shadows->Remove(); } // whom props keep, too

  std::vector<vtkSmartPointer<vtkLight>> Lights;
  vtkGodRaysLightFinder Finder;
  vtkGodRaysSceneSize SceneSize;
  std::vector<vtkGodRaysLight> FormerLights; // empty: memory for those of a frame
  vtkSmartPointer<vtkLight> PlacedSun;       // by PlaceSun()
  double SunStrength = 1.0;                  // intensity that it has of PlaceSun()
  bool SunIsKept = false;                    // it has a place that was found or given
  vtkGodRaysDataLights DataLights;
  vtkNew<vtkGodRaysSunPlacer> Placer;
  bool SunMoved = false;                      // in this frame
  bool HasNoLight = false;                    // nothing reaches this frame but a sun to be placed
  std::array<double, 34> CoveredPicture = {}; // of the placer's coverage: view and props
  bool IsNewPicture = false;                  // the coverage is to be found in this frame
  bool CoverageIsCurrent = false;             // the placer's is that of this frame
  vtkSmartPointer<vtkGodRaysSun> Sun = vtkSmartPointer<vtkGodRaysSun>::New();
  vtkSmartPointer<vtkGodRaysModel> Model;
  std::unique_ptr<vtkGodRaysEffect> Effect; // the model's
  vtkSmartPointer<vtkGodRaysIntegrator> Integrator;
  bool IntegratorIsModels = false; // nobody set it
  vtkSmartPointer<vtkGodRaysCompositor> Compositor;

  vtkGodRaysAttachment Attachment;

  vtkNew<vtkGodRaysScene> RendererSteps;
  vtkNew<vtkGodRaysSurfaceShadows> Shadows; // on surfaces
  vtkNew<vtkGodRaysOcclusionPass> Occlusion;
  vtkNew<vtkGodRaysBlendPass> Blending;
  vtkGodRaysSceneCopy Scene;            // colour and depth of the viewport
  vtkTextureObject* Coverage = nullptr; // of this frame's scene, by what has a depth
  vtkGodRaysTarget Backdrop;            // background, where the scene is drawn over black
  vtkGodRaysSum Scattering;             // light of all layers
  vtkGodRaysLightMeter Meter;
  vtkGodRaysLightMeter::Exposure Exposure;
  vtkGodRaysBlendPass::Surround Surround;
  bool IsMetered = false; // the last frame was
  bool IsStill = false;   // the user does not drag the camera in this frame
  vtkGodRaysTimers Timers;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the resources
  vtkMTimeType ContextTime = 0;                 // when its context was made
  bool HasRays = false;                         // of the last frame
  bool HasScattering = false;                   // alike
  bool HasBackdrop = false;
  bool HasShadows = false; // on surfaces, in this frame
  bool KeepAllLayers = false;
  int NumberOfLights = 0; // of the last frame
  vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB;
  double Margin = 0.0;        // of the layers of this frame
  bool DrawsScene = false;    // at this moment
  bool Releases = false;      // at this moment
  bool IsOwnDelegate = false; // its delegate called it while it drew the scene
  std::string StagePlan;
  std::vector<std::string> Concerns; // of the last frame
  std::set<std::string> Complaints;  // that have been made already

  bool FindExposure(vtkGodRaysPass& pass, vtkRenderer* renderer, bool isTile,
    vtkGodRaysBlendPass::Request& request);

  /// What the last frame left, if that is still there; else an image without points, and false.
  bool Download(vtkGodRaysSum* light, vtkImageData* image)
  {
    if (image && light && this->Window)
    {
      this->Window->MakeCurrent();
      if (light->Download(image))
      {
        return true;
      }
    }
    if (image)
    {
      image->Initialize();
    }
    return false;
  }

  /// The numbers of the last frame, if it has any; else an image without points, and false.
  bool ReadNumbers(const double* irradiance, double tolerance, vtkImageData* image)
  {
    vtkNew<vtkImageData> light;
    vtkTextureObject* depth = this->Scene.GetDepth();
    // a window that is finalized takes the texture away
    bool done = image && this->HasRays && this->Window && depth && depth->GetHandle() != 0;
    if (done && this->NumberOfLights > 0)
    {
      done = this->Download(this->HasScattering ? &this->Scattering : nullptr, light);
    }
    if (done)
    {
      this->Window->MakeCurrent();
      vtkGodRaysEffect::Reading reading;
      reading.WindowDepths = this->Scene.ReadDepth();
      reading.Size[0] = static_cast<int>(depth->GetWidth());
      reading.Size[1] = static_cast<int>(depth->GetHeight());
      reading.Light = this->NumberOfLights > 0 ? light.Get() : nullptr;
      reading.Irradiance = irradiance;
      const double measured = this->Integrator->GetErrorEstimate();
      reading.LightErrorIsMeasured = measured >= 0.0;
      reading.LightError = this->NumberOfLights == 0 ? 0.0 : measured >= 0.0 ? measured : tolerance;
      done = (!reading.Light ||
               light->GetNumberOfPoints() == static_cast<vtkIdType>(reading.WindowDepths.size())) &&
        this->Effect->FillNumbers(reading, image);
    }
    if (image && !done)
    {
      image->Initialize();
    }
    return done;
  }

  void Release(vtkWindow* window)
  {
    this->Shadows->ReleaseGraphicsResources(window);
    this->Occlusion->ReleaseGraphicsResources(window);
    if (this->Integrator)
    {
      this->Integrator->ReleaseGraphicsResources(window);
    }
    this->Blending->ReleaseGraphicsResources(window);
    this->Scene.Release(window);
    this->Coverage = nullptr;
    this->Backdrop.Release(window);
    this->Scattering.Release(window);
    this->Meter.Release(window);
    this->IsMetered = false;
    if (this->Effect)
    {
      this->Effect->Release(window);
    }
    this->Timers.Release(this->Window);
    this->HasRays = false;
    this->HasScattering = false;
    this->Window = nullptr;
  }
};

#endif
