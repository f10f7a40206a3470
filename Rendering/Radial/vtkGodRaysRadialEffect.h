// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRadialEffect
 * @brief   a radial sum of the occlusion layer of each light; private to this module
 */

#ifndef vtkGodRaysRadialEffect_h
#define vtkGodRaysRadialEffect_h

#include "vtkGodRaysEffect.h"
#include "vtkGodRaysRadialIntegrator.h" // For Request
#include "vtkGodRaysSum.h"

#include <vector>

class vtkGodRaysRadialSumModel;
class vtkGodRaysVerification;

class vtkGodRaysRadialEffect : public vtkGodRaysEffect
{
public:
  /// The model must outlive this.
  explicit vtkGodRaysRadialEffect(vtkGodRaysRadialSumModel* model);

  std::string FindObstacle(vtkRenderer* renderer, vtkGodRaysCompositor* compositor,
    const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view, const int size[2]) override;
  bool SumsShownValues() const override;
  bool DimsScene() const override { return false; }
  bool ReadsSceneDepth() const override { return false; }
  bool UsesCoverage() const override;
  void SetUp(vtkGodRaysLightFinder& finder) const override;
  void SetUp(
    vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator* integrator) const override;
  void Begin(const Frame& frame) override;
  bool DrawLight(const Frame& frame, const vtkGodRaysLight& light) override;
  void Join(vtkGodRaysBlendPass::Request& request) const override;
  void End() override {}
  bool HasLayers() const override { return this->Composed > 0; }
  vtkGodRaysSum* GetLayers() override;
  void Release(vtkWindow* window) override;

private:
  bool ComposeLayer(const Frame& frame, const vtkGodRaysLight& light);
  vtkGodRaysBlendPass::LightResponse GetResponse(const Frame& frame, const vtkGodRaysLight& light);
  void Verify(
    const vtkGodRaysRadialIntegrator::Request& request, vtkGodRaysVerification& verification) const;

  vtkGodRaysRadialSumModel* Model;
  vtkGodRaysSum Layers; // of all lights; of several only if they are asked for
  int Composed = 0;     // layers of this frame
  bool KeepsAll = false;
  int Drawn = 0;               // lights of this frame
  std::vector<double> Streaks; // of each light; kept while the picture's coverage is
};

#endif
