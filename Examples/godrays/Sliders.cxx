// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sliders.h"

#include "vtkCallbackCommand.h"
#include "vtkCoordinate.h"
#include "vtkNew.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr double Length = 180.0; // pixels
constexpr double Margin = 24.0;
constexpr double Foot = 44.0; // for the status line
constexpr double LargestRow = 42.0;
constexpr double Thickness = 12.0;
constexpr double TextHeight = 13.0;

//------------------------------------------------------------------------------
void SetText(vtkTextProperty* property)
{
  property->SetColor(1.0, 1.0, 1.0);
  property->BoldOff();
  property->ItalicOff();
  property->ShadowOn();
}
}

//------------------------------------------------------------------------------
Sliders::Sliders(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer)
  : Interactor(interactor)
  , Renderer(renderer)
{
}

//------------------------------------------------------------------------------
Sliders::~Sliders()
{
  this->Show({});
}

//------------------------------------------------------------------------------
void Sliders::Add(const Stage::Parameter& parameter)
{
  vtkNew<vtkSliderRepresentation2D> shape;
  shape->SetMinimumValue(parameter.Low);
  shape->SetMaximumValue(parameter.High);
  shape->ShowSliderLabelOff(); // the title has the number
  shape->GetPoint1Coordinate()->SetCoordinateSystemToDisplay();
  shape->GetPoint2Coordinate()->SetCoordinateSystemToDisplay();
  shape->SetEndCapLength(0.0);
  shape->SetEndCapWidth(0.0);
  shape->GetTubeProperty()->SetColor(0.7, 0.7, 0.75);
  shape->GetSliderProperty()->SetColor(1.0, 0.8, 0.2); // as the light's handle
  shape->GetSelectedProperty()->SetColor(1.0, 1.0, 1.0);
  SetText(shape->GetTitleProperty());
  auto widget = vtkSmartPointer<vtkSliderWidget>::New();
  widget->SetInteractor(this->Interactor);
  widget->SetDefaultRenderer(this->Renderer);
  widget->SetCurrentRenderer(this->Renderer);
  widget->SetRepresentation(shape);
  widget->SetAnimationModeToJump();
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* self = static_cast<Sliders*>(data);
      auto* moved = static_cast<vtkSliderWidget*>(caller);
      const auto found = std::find(self->Widgets.begin(), self->Widgets.end(), moved);
      if (found != self->Widgets.end())
      {
        self->Change(self->Names[found - self->Widgets.begin()],
          vtkSliderRepresentation::SafeDownCast(moved->GetRepresentation())->GetValue());
      }
    });
  widget->AddObserver(vtkCommand::InteractionEvent, command);
  widget->EnabledOn();
  this->Widgets.push_back(widget);
  this->Names.push_back(parameter.Name);
}

//------------------------------------------------------------------------------
void Sliders::Show(const std::vector<Stage::Parameter>& parameters)
{
  const bool isSame =
    std::equal(this->Names.begin(), this->Names.end(), parameters.begin(), parameters.end(),
      [](const std::string& name, const Stage::Parameter& each) { return name == each.Name; });
  if (!isSame)
  {
    for (const auto& widget : this->Widgets)
    {
      widget->EnabledOff();
      widget->SetInteractor(nullptr);
    }
    this->Widgets.clear();
    this->Names.clear();
    for (const Stage::Parameter& parameter : parameters)
    {
      this->Add(parameter);
    }
  }
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  const double count = static_cast<double>(std::max<std::size_t>(parameters.size(), 1));
  const double row = std::min(LargestRow, (size[1] - Foot) / count);
  const double left = std::max(Margin, size[0] - Margin - Length);
  for (std::size_t i = 0; i < parameters.size(); ++i)
  {
    auto* shape = vtkSliderRepresentation2D::SafeDownCast(this->Widgets[i]->GetRepresentation());
    const double y = Foot + row * (static_cast<double>(parameters.size() - 1 - i) + 0.5);
    shape->GetPoint1Coordinate()->SetValue(left, y);
    shape->GetPoint2Coordinate()->SetValue(size[0] - Margin, y);
    // sizes are parts of the window's
    shape->SetSliderLength(Thickness / size[0]);
    shape->SetSliderWidth(Thickness / size[1]);
    shape->SetTubeWidth(0.3 * Thickness / size[1]);
    shape->SetTitleHeight(TextHeight / size[1]);
    shape->SetValue(parameters[i].Value);
    std::ostringstream title;
    title.precision(3);
    title << parameters[i].Name << " " << parameters[i].Value;
    shape->SetTitleText(title.str().c_str());
  }
}
