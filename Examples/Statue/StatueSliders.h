// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The five parameters of the radial sum, on sliders along the lower edge of a window.
 */

#ifndef StatueSliders_h
#define StatueSliders_h

#include "vtkCommand.h"
#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

class StatueSliders
{
public:
  vtkNew<vtkGodRaysRadialModel> Model;
  vtkNew<vtkGodRaysPublishedModel> Published; // with the same parameters

  std::vector<vtkGodRaysRadialSumModel*> GetModels() { return { this->Model, this->Published }; }

  void Add(vtkRenderWindowInteractor* interactor)
  {
    for (const Parameter& parameter : Parameters)
    {
      const double left = 0.03 + 0.195 * this->Sliders.size(); // of the window's width
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
      auto slider = vtkSmartPointer<vtkSliderWidget>::New();
      slider->SetInteractor(interactor);
      slider->SetRepresentation(look);
      slider->SetAnimationModeToJump();
      slider->AddObserver(vtkCommand::InteractionEvent, this, &StatueSliders::OnSlide);
      slider->EnabledOn();
      this->Sliders.push_back(slider);
    }
  }

private:
  struct Parameter
  {
    const char* Name;
    double Range[2]; // of the slider; the model takes more
    double (*Get)(vtkGodRaysRadialSumModel*);
    void (*Set)(vtkGodRaysRadialSumModel*, double);
  };

  static constexpr Parameter Parameters[] = {
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

  void OnSlide() // the widget renders
  {
    for (size_t i = 0; i < this->Sliders.size(); ++i)
    {
      for (vtkGodRaysRadialSumModel* model : this->GetModels())
      {
        Parameters[i].Set(model, this->Sliders[i]->GetSliderRepresentation()->GetValue());
      }
    }
  }

  std::vector<vtkSmartPointer<vtkSliderWidget>> Sliders;
};

#endif
