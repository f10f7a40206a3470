// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the cost of vtkGodRaysSkyPass, for the tables of Documentation/Evidence/Sky.md.

#include "Device.h"
#include "Rounds.h"
#include "Statistics.h"

#include "vtkGodRaysSkyPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <cstdio>
#include <cstring>
#include <iostream>

namespace
{
/// Frames of one window, with and without a sky.
class Frames
{
public:
  Frames(Device& device, int width, int height)
    : OpenGL(device)
  {
    device.GetWindow()->SetSize(width, height);
    device.GetWindow()->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 2.0);
    camera->SetFocalPoint(0.0, -1.0, 2.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(60.0);
    this->Sky->SetSunElevation(10.0);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-1e4, -1e4, -1e4);
    plane->SetPoint1(1e4, -1e4, -1e4);
    plane->SetPoint2(-1e4, -1e4, 1e4);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    this->Wall->SetMapper(mapper);
    this->Renderer->AddActor(this->Wall);
    this->Renderer->ResetCameraClippingRange();
  }

  /// Without a sky; a wall fills the picture, or there is nothing.
  double DrawPlain(bool wall)
  {
    this->Renderer->SetPass(nullptr);
    this->Wall->SetVisibility(wall);
    return this->Draw();
  }

  double DrawSky(bool wall)
  {
    this->Renderer->SetPass(this->Sky);
    this->Wall->SetVisibility(wall);
    return this->Draw();
  }

  /// The tables are made anew.
  double DrawNewSky(bool wall)
  {
    this->Sky->SetSunElevation(this->Sky->GetSunElevation() > 10.0 ? 10.0 : 10.1);
    return this->DrawSky(wall);
  }

private:
  double Draw()
  {
    return this->OpenGL.Measure([this] { this->OpenGL.GetWindow()->Render(); });
  }

  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Wall; // 10 km away
  vtkNew<vtkGodRaysSkyPass> Sky;
};

void PrintCosts(Device& device, int width, int height, int rounds)
{
  Frames frames(device, width, height);
  device.PrepareUnits(width, height);
  std::vector<RoundsItem> items;
  items.push_back({ "copy", [&] { return device.MeasureCopy(); }, {} });
  for (const bool wall : { false, true })
  {
    const std::string name = wall ? "air before a scene that fills the picture" : "sky";
    items.push_back(
      { wall ? "wall" : "nothing", [&, wall] { return frames.DrawPlain(wall); }, {} });
    items.push_back({ name, [&, wall] { return frames.DrawSky(wall); }, {} });
    items.push_back(
      { name + ", the sun moves", [&, wall] { return frames.DrawNewSky(wall); }, {} });
  }
  MeasureRounds("sky", items, rounds);
  const auto copies = GetSeconds(items, "copy");
  std::printf("A copy takes %.2f ms.\n\n", 1e3 * Statistics::GetMedian(copies));
  std::printf("| frame | more than without [copies] | [ms] |\n|---|---|---|\n");
  for (std::size_t i = 1; i < items.size(); ++i)
  {
    const std::size_t plain = i < 4 ? 1 : 4;
    if (i != plain)
    {
      const auto more = Statistics::Subtract(items[i].Seconds, items[plain].Seconds);
      std::printf("| %s | %.1f | %.1f |\n", items[i].Name.c_str(),
        Statistics::GetMedian(Statistics::Divide(more, copies)), 1e3 * Statistics::GetMedian(more));
    }
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const std::string reason = FindWhyNoDisplay();
  if (!reason.empty())
  {
    std::cerr << "godrays_sky_pass_benchmark: " << reason << "\n";
    return 1;
  }
  Device device;
  std::cout << "OpenGL: " << device.GetRendererName() << "\n";
  if (quick)
  {
    PrintCosts(device, 320, 180, 2);
  }
  else
  {
    PrintCosts(device, 1920, 1080, 15);
  }
  return 0;
}
