// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumEffect
 * @brief   light that a medium scatters along view rays, and the scene dimmed by it; private to this
 * module
 */

#ifndef vtkGodRaysMediumEffect_h
#define vtkGodRaysMediumEffect_h

#include "vtkGodRaysDiffuseLight.h"
#include "vtkGodRaysEffect.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysMediumVerification.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkGodRaysVolumeMedium.h"

class vtkGodRaysMediumModel;

class vtkGodRaysMediumEffect : public vtkGodRaysEffect
{
public:
  /// The model must outlive this.
  explicit vtkGodRaysMediumEffect(vtkGodRaysMediumModel* model);

  std::string FindObstacle(vtkRenderer* renderer, vtkGodRaysCompositor* compositor,
    const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view, const int size[2]) override;
  bool HasOwnProps(vtkRenderer* renderer) const override;
  const std::vector<vtkProp*>& GetOwnProps() const override { return this->Data.GetProps(); }
  bool SumsShownValues() const override { return false; }
  bool DimsScene() const override;
  bool ReadsSceneDepth() const override { return true; }
  void SetUp(vtkGodRaysLightFinder& finder) const override;
  void SetUp(
    vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator* integrator) const override;
  bool FindMedium(vtkRenderer* renderer, const vtkGodRaysSceneSize& scene,
    const vtkGodRaysView& view, vtkGodRaysMedium& medium) const override;
  void Begin(const Frame& frame) override;
  bool DrawLight(const Frame& frame, const vtkGodRaysLight& light) override;
  void Join(vtkGodRaysBlendPass::Request& request) const override;
  void End() override;
  bool HasLayers() const override { return false; }
  vtkGodRaysSum* GetLayers() override { return nullptr; }
  bool FillNumbers(const Reading& reading, vtkImageData* image) const override;
  void Release(vtkWindow* window) override;
  std::string Describe() const override;
  std::string FindConcern() const override;
  std::string DescribeErrors() const override { return this->Verification.Describe(); }

private:
  vtkGodRaysMedium GetMedium(
    vtkRenderer* renderer, const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view) const;

  bool IsInGround(const vtkGodRaysLight& light) const; // of a planet
  vtkGodRaysMediumIntegrator::Request MakeRequest(const Frame& frame, const vtkGodRaysLight& light);
  bool DrawData(const vtkGodRaysMediumIntegrator::Request& request, bool hasAir,
    vtkGodRaysMediumIntegrator* integrator, const vtkGodRaysDiffuseLight* diffuse);
  bool FindDiffuse(
    const Frame& frame, const vtkGodRaysMediumIntegrator::Request& request, bool estimates);
  std::string FindSingle(const Frame& frame) const;

  vtkGodRaysMediumModel* Model;
  vtkGodRaysMedium Medium; // of this frame, in scene units
  vtkGodRaysViewDepths Depths;
  vtkGodRaysVolumeMedium Data;
  vtkGodRaysDiffuseLight Diffuse;
  int LightsToCome = 0;     // of this frame
  std::string SingleReason; // why light is scattered once in this frame, though ALL is asked for
  unsigned int VerifiedData = 0;
  double DataError = 0.0; // of the last frame
  bool HadData = false;   // alike
  vtkGodRaysMediumVerification Verification;
  double LastError = -1.0; // of the last frame
  double SceneDepth = 0.0; // optical depth across the scene; 0 if that is not one number
  int HiddenLamps = 0;     // of this frame, in a planet's ground
  vtkTextureObject* SeenDepth = nullptr; // where view rays end
  const vtkGodRaysView* View = nullptr;
  vtkGodRaysView LastView; // of the last frame, for its numbers
  double LastUnit = 0.0;   // alike
  bool HasNumbers = false; // the depth of its picture was there
};

#endif
