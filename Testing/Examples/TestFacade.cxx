// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The window of the example Facade: its key, and the way from across the street to the wall.

#include "ExampleUser.h"

#include "vtkCamera.h"

#include <algorithm>
#include <cmath>

#define main ExampleMain
#include "Facade/Facade.cxx"
#undef main

TEST(Facade, GoesNearAndBack)
{
  RunExample(
    [](User* user)
    {
      const std::vector<float> far = user->GetLight();
      ASSERT_GT(GetSum(far), 0.0);
      user->Press("n");
      const std::vector<float> near = user->GetLight();
      EXPECT_GT(GetSum(near), 0.0);
      EXPECT_NE(near, far);
      user->Press("x");
      user->Press(nullptr);
      EXPECT_EQ(user->GetLight(), near);
      user->Press("n");
      EXPECT_EQ(user->GetLight(), far);
    });
}

// No step towards a window makes light that is no number, or has it jump.
TEST(Facade, LightIsContinuousUpToThePane)
{
  RunExample(
    [](User* user)
    {
      vtkRenderer* renderer = user->GetRenderer();
      vtkCamera* camera = renderer->GetActiveCamera();
      double before = -1.0;
      double worst = 0.0;
      double peak = 0.0;
      for (double distance = 2.0; distance > -0.2; distance -= 0.02) // from the wall's front
      {
        camera->SetPosition(-4.2, 2.0, distance);
        camera->SetFocalPoint(-3.2, 2.6, -0.5);
        renderer->ResetCameraClippingRange();
        user->Render();
        const std::vector<float> light = user->GetLight();
        EXPECT_TRUE(std::all_of(light.begin(), light.end(),
          [](float value) { return std::isfinite(value) && value >= 0.0f; }))
          << distance;
        const double mean = GetSum(light) / std::max<size_t>(light.size(), 1);
        worst = before < 0.0 ? 0.0 : std::max(worst, std::abs(mean - before));
        before = mean;
        peak = std::max(peak, mean);
      }
      EXPECT_GT(peak, 0.0);
      EXPECT_LT(worst, 0.1 * peak);
      std::cout << "largest step of the mean: " << worst / peak << " of its peak\n";
    });
}
