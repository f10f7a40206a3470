// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A statue before a sphere of light and a galaxy; five sliders hold the parameters of the sum.

#include "../ExampleWindow.h"
#include "StatueScene.h"
#include "StatueSliders.h"

#include "vtkCamera.h"
#include "vtkGodRaysPass.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <iostream>

namespace
{
/// The light and the parameters of its sum, as the user changes them.
class Stage
{
public:
  void MoveLight(double degrees)
  {
    this->Angle += vtkMath::RadiansFromDegrees(degrees);
    double place[3] = { this->Center[0] + 0.39 * this->Size * std::sin(this->Angle),
      this->Center[1] + 0.1 * this->Size,
      this->Center[2] - 0.39 * this->Size * std::cos(this->Angle) };
    this->Sphere->SetPosition(place);
    this->Light->SetPosition(place);
  }

  void AddControls(vtkRenderWindowInteractor* interactor)
  {
    this->Sliders.Add(interactor);
    interactor->AddObserver(vtkCommand::KeyPressEvent, this, &Stage::OnKey);
    interactor->AddObserver(vtkCommand::TimerEvent, this, &Stage::OnTimer);
    interactor->CreateRepeatingTimer(33);
    this->Interactor = interactor;
  }

  vtkNew<vtkActor> Sphere;
  vtkNew<vtkLight> Light;
  vtkNew<vtkGodRaysPass> Rays;
  StatueSliders Sliders;
  double Center[3]; // of the statue
  double Size;      // the diagonal of its bounds

private:
  void OnKey()
  {
    const char* name = this->Interactor->GetKeySym(); // null for a key that X does not know
    const std::string key = name ? name : "";
    this->Moves ^= key == "space";
    if (key == "g") // the sum as published, tap by tap, and back
    {
      vtkGodRaysModel* published = this->Sliders.Published;
      const bool isPublished = this->Rays->GetModel() == published;
      this->Rays->SetModel(isPublished ? this->Sliders.Model.Get() : published);
      this->Interactor->Render();
    }
  }

  void OnTimer()
  {
    if (this->Moves)
    {
      this->MoveLight(1.5);
      this->Interactor->Render();
    }
  }

  vtkRenderWindowInteractor* Interactor = nullptr;
  double Angle = 0.0;
  bool Moves = false;
};
}

int main(int argc, char* argv[])
{
  const auto size = TakeSize(argc, argv);
  const bool writes = argc > 1 && vtksys::SystemTools::StringEndsWith(argv[1], ".png");
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  const std::string fault = AddModel(window, argc > 1 + writes ? argv[1 + writes] : "");
  if (!fault.empty())
  {
    std::cerr << "Statue: " << fault << "\n";
    return EXIT_FAILURE;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  Stage stage;
  box.GetCenter(stage.Center);
  stage.Size = box.GetDiagonalLength();

  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.07 * stage.Size);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  stage.Sphere->SetMapper(mapper);
  stage.Sphere->GetProperty()->LightingOff();
  stage.Sphere->GetProperty()->SetColor(1.0, 0.93, 0.8);
  vtkGodRaysPass::SetRole(stage.Sphere, vtkGodRaysPass::LIGHT);
  renderer->AddActor(stage.Sphere);
  const auto galaxy = MakeGalaxy(stage.Size, stage.Center);
  vtkGodRaysPass::SetRole(galaxy, vtkGodRaysPass::IGNORED); // it is behind everything
  renderer->AddActor(galaxy);

  renderer->RemoveAllLights(); // that a model may have brought
  stage.Light->PositionalOn();
  stage.Light->SetConeAngle(180.0);
  renderer->AddLight(stage.Light);
  stage.MoveLight(-20.0);
  vtkNew<vtkLight> starlight;
  starlight->SetLightTypeToHeadlight();
  starlight->SetColor(0.27, 0.32, 0.45);
  renderer->AddLight(starlight);
  renderer->SetBackground(0.008, 0.008, 0.02);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(stage.Center);
  // The front of the model's box fills the picture.
  const double front = std::max(box.GetLength(1), 0.75 * box.GetLength(0));
  camera->SetPosition(stage.Center[0] - 0.18 * stage.Size, stage.Center[1] - 0.1 * stage.Size,
    stage.Center[2] + 0.5 * box.GetLength(2) + 1.55 * front);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(36.0);
  renderer->ResetCameraClippingRange();

  stage.Sliders.Published->ApplyPreset("gianassi");
  for (vtkGodRaysRadialSumModel* model : stage.Sliders.GetModels())
  {
    model->SetExposure(0.05); // as published, but for the decay
    model->SetDecay(0.98);
    model->SetDensity(0.8);
    model->SetWeight(0.8);
  }
  stage.Rays->SetAutomaticExposure(false); // which would make up for what the sliders do
  stage.Rays->SetModel(stage.Sliders.Model);
  stage.Rays->SetBackgroundGlow(0.1);
  stage.Rays->Attach(renderer);

  if (writes)
  {
    return WritePicture(window, size, argv[1]);
  }
  window->SetSize(size[0], size[1]);
  window->SetMultiSamples(0); // with them, software OpenGL takes three times as long
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  stage.AddControls(interactor);
  window->Render();
  interactor->Start();
  return EXIT_SUCCESS;
}
