// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The window in which the user looks around.
 */

#ifndef Viewer_h
#define Viewer_h

#include "Keys.h"
#include "Options.h"
#include "Overlay.h"
#include "Playlist.h"
#include "Sliders.h"
#include "Stage.h"

#include "vtkNew.h"          // For vtkNew
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <array>    // For std::array
#include <memory>   // For std::unique_ptr
#include <optional> // For std::optional
#include <string>   // For std::string
#include <vector>   // For std::vector

class vtkCamera;
class vtkCubeAxesActor;
class vtkImageData;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;

class Viewer
{
public:
  /**
   * The stage is that of the list's first scene; another one is in its place when the user goes on.
   */
  Viewer(
    vtkRenderWindow* window, std::unique_ptr<Stage>& stage, Playlist& list, const Options& options);
  ~Viewer();

  Viewer(const Viewer&) = delete;
  void operator=(const Viewer&) = delete;

  /**
   * Until the window is closed.
   */
  void Run();

private:
  /// What is seen of the picture.
  enum ViewType
  {
    Composite,
    Occlusion,
    RaysAlone,
    Depth,
    Error,
    NumberOfViews
  };

  static void SetCamera(
    vtkRenderer* renderer, vtkCamera* from, const Scene& scene); ///< a copy of it
  static const char* GetViewName(int view);
  void Observe(vtkObject* object, unsigned long event, void (*call)(Viewer*), bool last);
  bool OnKey(const std::string& symbol, bool shift);
  bool Do(const KeyBinding& binding, bool shift);
  void StartTimer();
  void OnTimer();
  void OnDragLight(double x, double y);

  void Render();
  void RenderPicture();
  void UpdateOverlay();
  vtkSmartPointer<vtkImageData> Capture();
  vtkSmartPointer<vtkImageData> MakeDepthPicture();
  vtkSmartPointer<vtkImageData> MakeErrorPicture();

  void GoHome();
  void TakePreset(int step);
  void MoveLight(Command command, double degrees);
  void TakeBackground();
  void SetView(int view);
  void SetGrid(bool on);
  void SetStyle(bool terrain);
  bool Open(std::size_t item, std::size_t step, bool keepView);
  void TakeStep(int step);
  void TakeDrop(const std::vector<std::string>& files);
  void ShowSliders(bool on);
  void WriteScreenshot();
  double GetAspect() const;
  std::string GetStatus() const;

  vtkRenderWindow* Window;
  std::unique_ptr<Stage>& Shown;
  Playlist& List;
  const Options& Settings;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  std::optional<Overlay> Over;
  std::optional<Sliders> Numbers; ///< while they are shown
  Viewpoint Home;
  vtkSmartPointer<vtkCubeAxesActor> Grid;
  std::string Message; ///< until the next key
  std::size_t Item = 0;
  std::size_t Step = 0;
  int View = Composite;
  double SkyExposure = 1.0;
  double LastFrame = 0.0; ///< [s] how long it took
  std::array<double, 2> Errors = { -1.0, -1.0 };
  std::optional<double> Divider; ///< fraction of the width
  bool HasHandle = false;
  bool HasStatus = true;
  bool HasTimer = false;
  bool IsTerrainStyle = false;
  bool IsPlaying = false;
  bool IsRendering = false;
};

#endif
