// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// README's code in C++, as it stands there: data are seen in their colours, and so are shafts.

#include "GodRaysTesting.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPass.h"

#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace GodRaysTesting;

TEST(Readme, ItsCodeMakesShaftsAndKeepsData)
{
  Messages messages;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(true);
  window->SetSize(300, 200);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  for (int i = 0; i < 6; ++i)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(32);
    cone->SetCenter(2.0 * std::cos(i * 1.0472), 0.0, 2.0 * std::sin(i * 1.0472));
    cone->SetDirection(0.0, 1.0, 0.0);
    cone->SetHeight(1.6);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9, 0.4 + 0.1 * i, 0.2);
    renderer->AddActor(actor);
  }
  const auto before = GetPixels(window);

#include "ReadmeCode.inc" // made of README.md

  const auto after = GetPixels(window, false);
  const auto toLab = [](const std::vector<unsigned char>& picture, int pixel)
  {
    return vtkGodRays::LabOfLight(vtkGodRays::DecodeDisplay(
      vtkGodRays::Vec3(picture[4 * pixel], picture[4 * pixel + 1], picture[4 * pixel + 2]) /
      255.0));
  };
  double difference = 0.0;
  int data = 0;
  std::vector<double> lightness; // of the background
  for (int i = 0; i < 300 * 200; ++i)
  {
    if (before[4 * i + 3] > 0)
    {
      ++data;
      difference += glm::length(toLab(after, i) - toLab(before, i));
      continue;
    }
    lightness.push_back(toLab(after, i).x);
  }
  std::sort(lightness.begin(), lightness.end());
  const double dark = lightness[lightness.size() / 10];
  const double light = lightness[lightness.size() * 9 / 10];
  EXPECT_LT(difference / data, 10.0);
  EXPECT_GT(light, 35.0) << "rays";
  EXPECT_LT(dark, light - 15.0) << "and what is between them";
}
