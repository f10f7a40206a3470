// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The recipes in C++ of Documentation/Cookbook.md, as they stand there: each changes the picture by rays.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysSkyPass.h"
#include "vtkGodRaysSunPosition.h"

#include "vtkCamera.h"
#include "vtkNew.h"

#include <cstdlib>
#include <iostream>
#include <vector>

using namespace GodRaysTesting;

namespace
{
#include "CookbookCode.inc" // made of Cookbook.md: Recipe1() and so on, and their list, Recipes
}

TEST(Cookbook, RecipesInCxx)
{
  ASSERT_EQ(std::size(Recipes), 6u);
  for (const auto& recipe : Recipes)
  {
    SCOPED_TRACE(recipe.Name);
    Messages messages;
    Stage stage(160, 120);
    for (int i = -3; i <= 3; ++i)
    {
      stage.Renderer->AddActor(
        MakeBox({ 1.2 * i, 0.0, 0.0 }, { 0.4, 5.0, 0.4 }, { 0.2, 0.5, 0.8 }));
    }
    const auto actor = MakeLamp({ 0.3, 0.2, -1.5 }, 0.5, { 1.0, 0.8, 0.4 });
    stage.Renderer->AddActor(actor);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    if (std::string(recipe.Name).find("sky") != std::string::npos)
    {
      camera->SetFocalPoint(0.0, 0.0, 10.0); // towards the evening, with z up
      camera->SetPosition(10.0, -4.0, 10.0);
      camera->SetViewUp(0.0, 0.0, 1.0);
      stage.Renderer->ResetCamera();
    }
    const auto before = GetPixels(stage.Window);
    recipe.Run(stage.Renderer, stage.Window, actor);
    const auto after = GetPixels(stage.Window, false);
    double change = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i)
    {
      change += std::abs(after[i] - before[i]);
    }
    EXPECT_GT(change / after.size(), 2.0);
    vtkGodRaysPass* rays = vtkGodRaysPass::Find(stage.Renderer);
    ASSERT_TRUE(rays);
    EXPECT_FALSE(Says(rays->GetPlan(), "nothing to do")) << rays->GetPlan();
    vtkNew<vtkImageData> light;
    EXPECT_TRUE(rays->GetScatteringImage(light)) << rays->GetPlan();
    rays->Detach(stage.Renderer);
    vtkGodRaysSkyPass::Detach(stage.Renderer);
  }
}
