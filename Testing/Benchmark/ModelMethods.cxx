// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelMethods.h"

#include "MediumMethods.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysTapsIntegrator.h"

#include "vtkNew.h"

#include <cstdio>

namespace ModelError
{
//------------------------------------------------------------------------------
std::vector<ModelMethod> MakeModelMethods()
{
  std::vector<ModelMethod> methods;
  const auto add = [&methods](const char* name, const char* series, auto integrator)
  {
    const bool isMedium = integrator->Supports(vtkNew<vtkGodRaysHomogeneousModel>());
    methods.push_back({ name, series, integrator, isMedium, 1.0 / 255.0 });
  };
  add("radial sum", "radial sum", vtkSmartPointer<vtkGodRaysEpipolarIntegrator>::New());
  auto taps = vtkSmartPointer<vtkGodRaysTapsIntegrator>::New();
  taps->SetNumberOfTaps(100);
  add(CustomaryModel, "radial sum", taps);
  add(ClosedForm, "closed form", vtkSmartPointer<ClosedFormIntegrator>::New());
  const int sizes[][3] = { { 80, 45, 32 }, { 160, 90, 64 }, { 240, 135, 128 } };
  for (const auto& size : sizes)
  {
    auto froxels = vtkSmartPointer<FroxelsIntegrator>::New();
    froxels->SetSize(size[0], size[1], size[2]);
    char name[64];
    std::snprintf(name, sizeof(name), "froxels, %d x %d x %d", size[0], size[1], size[2]);
    add(name, "froxels", froxels);
  }
  add(TreeMethod, "min/max trees", vtkSmartPointer<TreesIntegrator>::New());
  const auto addMap = [&](const char* kind, int size, int backend)
  {
    auto walk = vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New();
    walk->SetMapSize(size);
    walk->SetBackend(backend);
    add((kind + (", 4 of " + std::to_string(size / 2))).c_str(), kind, walk);
  };
  for (const int size : { 512, 1024, 1536, 3072 })
  {
    addMap("shadow map, walked", size, vtkGodRaysIntegrator::PROCESSOR);
  }
  addMap("shadow map, in shaders", 1536, vtkGodRaysIntegrator::GRAPHICS);
  auto one = vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New();
  one->SetMapSize(1024);
  one->SetNumberOfNestedMaps(1);
  add("shadow map, walked, 1 of 1024", "one map, walked", one);
  for (const int share : { 16, 32, 64, 128, 255, 512, 1024 })
  {
    const std::string name =
      share == 255 ? std::string(BestModel) : "automatic, 1/" + std::to_string(share);
    add(name.c_str(), "automatic", vtkSmartPointer<vtkGodRaysShadowMapIntegrator>::New());
    methods.back().Tolerance = 1.0 / share;
  }
  return methods;
}
}
