// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include "Keys.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAxesActor.h"
#include "vtkCallbackCommand.h"
#include "vtkColorTransferFunction.h"
#include "vtkHandleWidget.h"
#include "vtkImageData.h"
#include "vtkImageMapper.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"
#include "vtkOrientationMarkerWidget.h"
#include "vtkPointHandleRepresentation2D.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
constexpr int Margin = 8; // pixels
constexpr int FontSize = 15;
constexpr double AxesShare = 0.2; // of the width and height

//------------------------------------------------------------------------------
void SetText(vtkTextActor* text, const char* font)
{
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontFamilyAsString(font);
  property->SetFontSize(FontSize);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetBackgroundColor(0.05, 0.05, 0.08);
  property->SetBackgroundOpacity(0.65);
  text->VisibilityOff();
}
}

//------------------------------------------------------------------------------
Overlay::Overlay(vtkRenderWindowInteractor* interactor)
  : Interactor(interactor)
{
  vtkRenderWindow* window = interactor->GetRenderWindow();
  window->SetNumberOfLayers(2);
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff();
  window->AddRenderer(this->Renderer);

  this->PictureMapper->SetColorWindow(255.0);
  this->PictureMapper->SetColorLevel(127.5);
  this->PictureMapper->UseCustomExtentsOn();
  this->Picture->SetMapper(this->PictureMapper);
  this->Picture->VisibilityOff();
  this->Renderer->AddViewProp(this->Picture);

  vtkNew<vtkPolyDataMapper2D> lines;
  lines->SetInputConnection(this->Line->GetOutputPort());
  this->Divider->SetMapper(lines);
  this->Divider->GetProperty()->SetLineWidth(2.0);
  this->Divider->VisibilityOff();
  this->Renderer->AddViewProp(this->Divider);

  this->ScalarBar->SetNumberOfLabels(5);
  this->ScalarBar->SetMaximumWidthInPixels(90);
  this->ScalarBar->SetPosition(0.87, 0.12);
  this->ScalarBar->SetPosition2(0.11, 0.7);
  this->ScalarBar->VisibilityOff();
  this->Renderer->AddViewProp(this->ScalarBar);

  SetText(this->Help, "Courier");
  SetText(this->Status, "Arial");
  SetText(this->Message, "Arial");
  this->Help->SetInput(GetKeyLines().c_str());
  this->Message->GetTextProperty()->SetVerticalJustificationToTop();
  this->Status->SetDisplayPosition(Margin, Margin);
  for (vtkTextActor* text : { this->Status.Get(), this->Message.Get(), this->Help.Get() })
  {
    this->Renderer->AddViewProp(text);
  }

  vtkNew<vtkAxesActor> arrows;
  this->Axes->SetOrientationMarker(arrows);
  this->Axes->SetInteractor(interactor);
  this->Axes->SetViewport(0.0, 0.06, AxesShare, 0.06 + AxesShare);

  this->Handle = this->MakeHandle(24, 9.0, { 1.0, 0.8, 0.2 }, this->DragLight);
  this->DividerHandle = this->MakeHandle(4, 8.0, { 1.0, 1.0, 1.0 }, this->DragDivider);
}

//------------------------------------------------------------------------------
Overlay::~Overlay()
{
  for (vtkHandleWidget* handle : { this->Handle.Get(), this->DividerHandle.Get() })
  {
    handle->EnabledOff();
    handle->SetInteractor(nullptr);
  }
  this->ShowAxes(false);
  this->Axes->SetInteractor(nullptr);
  this->Interactor->GetRenderWindow()->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHandleWidget> Overlay::MakeHandle(
  int sides, double radius, const Vector3& color, DragFunction& call)
{
  vtkNew<vtkRegularPolygonSource> shape;
  shape->SetNumberOfSides(sides);
  shape->SetRadius(radius);
  shape->GeneratePolygonOff();
  shape->Update();
  vtkNew<vtkPointHandleRepresentation2D> representation;
  representation->SetCursorShape(shape->GetOutput());
  representation->SetTolerance(15);
  representation->GetProperty()->SetColor(color[0], color[1], color[2]);
  representation->GetProperty()->SetLineWidth(3.0);
  representation->GetSelectedProperty()->SetColor(1.0, 1.0, 1.0);
  representation->GetSelectedProperty()->SetLineWidth(4.0);
  auto handle = vtkSmartPointer<vtkHandleWidget>::New();
  handle->SetInteractor(this->Interactor);
  handle->SetDefaultRenderer(this->Renderer);
  handle->SetCurrentRenderer(this->Renderer);
  handle->SetRepresentation(representation);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&call);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* call, void*)
    {
      const double* place = vtkHandleRepresentation::SafeDownCast(
        static_cast<vtkHandleWidget*>(caller)->GetRepresentation())
                              ->GetDisplayPosition();
      (*static_cast<DragFunction*>(call))(place[0], place[1]);
    });
  handle->AddObserver(vtkCommand::InteractionEvent, command);
  return handle;
}

//------------------------------------------------------------------------------
void Overlay::MoveHandle(vtkHandleWidget* handle, double x, double y)
{
  double place[3] = { x, y, 0.0 };
  auto* representation = vtkHandleRepresentation::SafeDownCast(handle->GetRepresentation());
  representation->SetRenderer(this->Renderer);
  representation->SetDisplayPosition(place);
  if (!handle->GetEnabled())
  {
    handle->EnabledOn();
  }
}

//------------------------------------------------------------------------------
void Overlay::SetVisible(bool on)
{
  this->Renderer->SetDraw(on);
  if (this->AreAxesShown())
  {
    this->Axes->GetOrientationMarker()->SetVisibility(on);
  }
}

//------------------------------------------------------------------------------
void Overlay::ShowHelp(bool on)
{
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  vtkTextProperty* property = this->Help->GetTextProperty();
  // As large as the window has room for.
  const int lines = static_cast<int>(GetKeyBindings().size());
  property->SetFontSize(std::clamp(static_cast<int>(size[1] / (1.25 * lines)), 6, FontSize));
  property->SetVerticalJustificationToTop();
  this->Help->SetDisplayPosition(Margin, size[1] - Margin);
  this->Help->SetVisibility(on);
}

//------------------------------------------------------------------------------
bool Overlay::IsHelpShown() const
{
  return this->Help->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
/**
 * In as many rows as the window is wide enough for; a part that is too long for one loses its beginning.
 */
void Overlay::ShowStatus(const std::string& line)
{
  const std::string between = "  |  ";
  const double room = std::max(this->Renderer->GetRenderWindow()->GetSize()[0] - 2 * Margin, 1);
  const auto getWidth = [this](const std::string& text)
  {
    double size[2] = { 0.0, 0.0 };
    this->Status->SetInput(text.c_str());
    this->Status->GetSize(this->Renderer, size);
    return size[0];
  };
  std::string rows;
  std::string row;
  for (std::size_t start = 0; start < line.size();)
  {
    const std::size_t end = std::min(line.find(between, start), line.size());
    std::string part = line.substr(start, end - start);
    start = end + between.size();
    const double width = getWidth(part);
    if (width > room)
    {
      const auto count = static_cast<std::size_t>(0.9 * part.size() * room / width);
      part = "..." + part.substr(part.size() - std::min(part.size(), count > 3 ? count - 3 : 1));
    }
    if (!row.empty() && getWidth(row + between + part) > room)
    {
      rows += row + "\n";
      row.clear();
    }
    row += (row.empty() ? "" : between) + part;
  }
  this->Status->SetInput((rows + row).c_str());
  this->Status->SetVisibility(!line.empty());
}

//------------------------------------------------------------------------------
void Overlay::ShowMessage(const std::string& lines)
{
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  this->Message->GetTextProperty()->SetJustificationToRight();
  this->Message->SetDisplayPosition(size[0] - Margin, size[1] - Margin);
  this->Message->SetInput(lines.c_str());
  this->Message->SetVisibility(!lines.empty());
}

//------------------------------------------------------------------------------
void Overlay::ShowScalarBar(const Scene* scene)
{
  this->ScalarBar->VisibilityOff();
  if (!scene || scene->Arrays.empty())
  {
    return;
  }
  vtkScalarsToColors* colors = nullptr;
  for (const auto& prop : scene->Props)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (!colors && actor && actor->GetMapper()->GetScalarVisibility())
    {
      colors = actor->GetMapper()->GetLookupTable();
    }
    else if (!colors && volume)
    {
      colors = volume->GetProperty()->GetRGBTransferFunction();
    }
  }
  if (colors)
  {
    this->ScalarBar->SetLookupTable(colors);
    this->ScalarBar->SetTitle(scene->Arrays.front().c_str());
    this->ScalarBar->VisibilityOn();
  }
}

//------------------------------------------------------------------------------
bool Overlay::IsScalarBarShown() const
{
  return this->ScalarBar->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
void Overlay::ShowAxes(bool on)
{
  if (on != this->AreAxesShown())
  {
    this->Axes->SetEnabled(on);
    if (on)
    {
      this->Axes->InteractiveOff();
    }
  }
}

//------------------------------------------------------------------------------
bool Overlay::AreAxesShown() const
{
  return const_cast<vtkOrientationMarkerWidget*>(this->Axes.Get())->GetEnabled() != 0;
}

//------------------------------------------------------------------------------
void Overlay::ShowPicture(vtkImageData* picture, int width)
{
  this->Picture->SetVisibility(picture && width > 0);
  if (picture && width > 0)
  {
    int size[3];
    picture->GetDimensions(size);
    int part[4] = { 0, std::min(width, size[0]) - 1, 0, size[1] - 1 };
    this->PictureMapper->SetInputData(picture);
    this->PictureMapper->SetCustomDisplayExtents(part);
  }
}

//------------------------------------------------------------------------------
void Overlay::ShowDivider(int column)
{
  this->Divider->SetVisibility(column >= 0);
  if (column < 0)
  {
    this->DividerHandle->EnabledOff();
    return;
  }
  const int height = this->Renderer->GetRenderWindow()->GetSize()[1];
  this->Line->SetPoint1(column, 0.0, 0.0);
  this->Line->SetPoint2(column, height, 0.0);
  this->MoveHandle(this->DividerHandle, column, 0.5 * height);
}

//------------------------------------------------------------------------------
void Overlay::ShowHandle(bool on, double x, double y)
{
  if (on)
  {
    this->MoveHandle(this->Handle, x, y);
  }
  else
  {
    this->Handle->EnabledOff();
  }
}
