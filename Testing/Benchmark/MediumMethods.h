// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Ways to draw a medium that the library does not offer, to compare it with. Both are of a directional light
// in perspective, run on the processor, and give their picture to the pass as the library's sweeps do.

#ifndef MediumMethods_h
#define MediumMethods_h

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysSweptLight.h"

#include "vtkNew.h"

#include <string>
#include <vector>

/// Light without any shadow: what the library does where no occluder reaches.
class ClosedFormIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static ClosedFormIntegrator* New();
  vtkTypeMacro(ClosedFormIntegrator, vtkGodRaysMediumIntegrator);

  bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  ClosedFormIntegrator() = default;
  ~ClosedFormIntegrator() override = default;

private:
  vtkGodRaysSweptLight Light;
};

/// What games do in a homogeneous medium: a grid of the view's cells, slices at depths that grow as squares;
/// each cell asks the library's shadow map, one of 1024 x 1024 pixels, whether its middle is lit, and if it
/// is, has all its light; see Froxels.h.
class FroxelsIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static FroxelsIntegrator* New();
  vtkTypeMacro(FroxelsIntegrator, vtkGodRaysMediumIntegrator);

  void SetSize(int columns, int rows, int slices);

  bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  FroxelsIntegrator();
  ~FroxelsIntegrator() override = default;

private:
  int Columns = 160;
  int Rows = 90;
  int Slices = 64;
  vtkNew<vtkGodRaysShadowMapIntegrator> Map;
  std::vector<float> Depths;
  std::vector<float> Picture;
  vtkGodRaysTarget Rays[2]; // of one channel, and of three
};

#endif
