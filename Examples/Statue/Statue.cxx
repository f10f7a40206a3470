// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
// A statue before a sphere of light and a galaxy; five sliders hold the parameters of the sum.

#include "../ExampleWindow.h"
#include "StatueScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkSphereSource.h"
#include "vtkTextProperty.h"

#include <iostream>

namespace
{
struct Parameter
{
  const char* Name;
  double Range[2]; // of the slider; the model takes more
  double (*Get)(vtkGodRaysRadialModel*);
  void (*Set)(vtkGodRaysRadialModel*, double);
};

const Parameter Parameters[] = {
  { "exposure", { 0.0, 0.2 }, [](auto model) { return model->GetExposure(); },
    [](auto model, double value) { model->SetExposure(value); } },
  { "decay", { 0.8, 1.0 }, [](auto model) { return model->GetDecay(); },
    [](auto model, double value) { model->SetDecay(value); } },
  { "density", { 0.0, 1.0 }, [](auto model) { return model->GetDensity(); },
    [](auto model, double value) { model->SetDensity(value); } },
  { "weight", { 0.0, 1.0 }, [](auto model) { return model->GetWeight(); },
    [](auto model, double value) { model->SetWeight(value); } },
  { "samples", { 1.0, 200.0 }, [](auto model) { return double(model->GetNumberOfSamples()); },
    [](auto model, double value) { model->SetNumberOfSamples(std::lround(value)); } },
};

/// The light and the parameters, as the user changes them.
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

  void AddSliders(vtkRenderWindowInteractor* interactor)
  {
    for (const Parameter& parameter : Parameters)
    {
      const double left = 0.03 + 0.195 * this->Sliders.size();
      vtkNew<vtkSliderRepresentation2D> look;
      look->SetTitleText(parameter.Name);
      look->SetMinimumValue(parameter.Range[0]);
      look->SetMaximumValue(parameter.Range[1]);
      look->SetValue(parameter.Get(this->Model));
      look->SetLabelFormat("%.3g");
      look->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
      look->GetPoint1Coordinate()->SetValue(left, 0.07);
      look->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
      look->GetPoint2Coordinate()->SetValue(left + 0.16, 0.07);
      look->SetSliderLength(0.015);
      look->SetTitleHeight(0.025);
      look->SetLabelHeight(0.02);
      this->Sliders.push_back(vtkSmartPointer<vtkSliderWidget>::New());
      this->Sliders.back()->SetInteractor(interactor);
      this->Sliders.back()->SetRepresentation(look);
      this->Sliders.back()->SetAnimationModeToJump();
      this->Sliders.back()->AddObserver(vtkCommand::InteractionEvent, this, &Stage::OnSlide);
      this->Sliders.back()->EnabledOn();
    }
    interactor->AddObserver(vtkCommand::KeyPressEvent, this, &Stage::OnKey);
    interactor->AddObserver(vtkCommand::TimerEvent, this, &Stage::OnTimer);
    interactor->CreateRepeatingTimer(33);
    this->Interactor = interactor;
  }

  vtkNew<vtkActor> Sphere;
  vtkNew<vtkLight> Light;
  vtkNew<vtkGodRaysRadialModel> Model;
  double Center[3]; // of the statue
  double Size;      // the diagonal of its bounds

private:
  void OnSlide() // the widget renders
  {
    for (size_t i = 0; i < this->Sliders.size(); ++i)
    {
      Parameters[i].Set(this->Model, this->Sliders[i]->GetSliderRepresentation()->GetValue());
    }
  }

  void OnKey()
  {
    const char* name = this->Interactor->GetKeySym(); // null for a key that X does not know
    const std::string key = name ? name : "";
    this->Moves ^= key == "space";
    if (key == "g") // the sum as published, tap by tap, and back
    {
      const bool published = this->Model->GetFormulation() == vtkGodRaysRadialModel::GIANASSI;
      this->Model->SetFormulation(
        published ? vtkGodRaysRadialModel::INVARIANT : vtkGodRaysRadialModel::GIANASSI);
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

  std::vector<vtkSmartPointer<vtkSliderWidget>> Sliders;
  vtkRenderWindowInteractor* Interactor = nullptr;
  double Angle = 0.0;
  bool Moves = false;
};
}

int main(int argc, char* argv[])
{
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
  camera->SetPosition(stage.Center[0] - 0.18 * stage.Size, stage.Center[1] - 0.1 * stage.Size,
    stage.Center[2] + stage.Size);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(36.0);
  renderer->ResetCameraClippingRange();

  stage.Model->SetExposure(0.05); // as published, but for the decay
  stage.Model->SetDecay(0.98);
  stage.Model->SetDensity(0.8);
  stage.Model->SetWeight(0.8);
  vtkNew<vtkGodRaysPass> rays;
  rays->SetModel(stage.Model);
  rays->SetBackgroundGlow(0.1);
  rays->Attach(renderer);

  if (writes)
  {
    return WritePicture(window, argv[1]);
  }
  window->SetSize(800, 600);
  window->SetMultiSamples(0); // with them, software OpenGL takes three times as long
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  stage.AddSliders(interactor);
  window->Render();
  interactor->Start();
  return EXIT_SUCCESS;
}
