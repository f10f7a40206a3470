// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sliders over the picture, one for each number of the rays.
 */

#ifndef Sliders_h
#define Sliders_h

#include "Stage.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <functional> // For std::function
#include <string>     // For std::string
#include <vector>     // For std::vector

class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkSliderWidget;

class Sliders
{
public:
  /**
   * In a renderer over that of the scene.
   */
  Sliders(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  ~Sliders();

  Sliders(const Sliders&) = delete;
  void operator=(const Sliders&) = delete;

  /// What is done when the user has moved a slider.
  using ChangeFunction = std::function<void(const std::string& name, double value)>;
  void OnChange(const ChangeFunction& call) { this->Change = call; }

  /**
   * Those of these parameters, above each other in the lower right corner; none if there are none.
   */
  void Show(const std::vector<Stage::Parameter>& parameters);

private:
  void Add(const Stage::Parameter& parameter);

  vtkRenderWindowInteractor* Interactor;
  vtkRenderer* Renderer;
  ChangeFunction Change;
  std::vector<vtkSmartPointer<vtkSliderWidget>> Widgets;
  std::vector<std::string> Names;
};

#endif
