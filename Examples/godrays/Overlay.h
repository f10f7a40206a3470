// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What lies over the picture in the window: help, status line, messages, pictures that were worked out
 * beside the one drawn, scalar bar, axes, the divider and the handle of the light. None of it is in
 * pictures that are written.
 */

#ifndef Overlay_h
#define Overlay_h

#include "Options.h"
#include "Scene.h"

#include "vtkNew.h"          // For vtkNew
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <functional> // For std::function
#include <string>     // For std::string

class vtkActor2D;
class vtkHandleWidget;
class vtkImageData;
class vtkImageMapper;
class vtkLineSource;
class vtkOrientationMarkerWidget;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

class Overlay
{
public:
  /**
   * In a layer of its own of the interactor's window.
   */
  explicit Overlay(vtkRenderWindowInteractor* interactor);
  ~Overlay();

  Overlay(const Overlay&) = delete;
  void operator=(const Overlay&) = delete;

  /// Where the user drags something to, in pixels from the lower left.
  using DragFunction = std::function<void(double x, double y)>;
  void OnDragLight(const DragFunction& call) { this->DragLight = call; }
  void OnDragDivider(const DragFunction& call) { this->DragDivider = call; }

  void SetVisible(bool on); ///< all of it

  void ShowHelp(bool on);
  bool IsHelpShown() const;
  void ShowStatus(const std::string& line);   ///< none if it is empty
  void ShowMessage(const std::string& lines); ///< none if it is empty
  void ShowScalarBar(const Scene* scene);     ///< of its first array; none for null
  bool IsScalarBarShown() const;
  void ShowAxes(bool on);
  bool AreAxesShown() const;

  vtkRenderer* GetRenderer() const { return this->Renderer; }

  /**
   * A picture as large as the window, the columns from 0 to before width; none for null.
   */
  void ShowPicture(vtkImageData* picture, int width);

  /**
   * The line between two halves, at this column; none if it is negative.
   */
  void ShowDivider(int column);

  /**
   * The light's handle, at this place in pixels.
   */
  void ShowHandle(bool on, double x = 0.0, double y = 0.0);

private:
  vtkSmartPointer<vtkHandleWidget> MakeHandle(
    int sides, double radius, const Vector3& color, DragFunction& call);
  void MoveHandle(vtkHandleWidget* handle, double x, double y);

  vtkRenderWindowInteractor* Interactor;
  DragFunction DragLight;
  DragFunction DragDivider;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Help;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Message;
  vtkNew<vtkImageMapper> PictureMapper;
  vtkNew<vtkActor2D> Picture;
  vtkNew<vtkLineSource> Line;
  vtkNew<vtkActor2D> Divider;
  vtkNew<vtkScalarBarActor> ScalarBar;
  vtkNew<vtkOrientationMarkerWidget> Axes;
  vtkSmartPointer<vtkHandleWidget> Handle;
  vtkSmartPointer<vtkHandleWidget> DividerHandle;
};

#endif
