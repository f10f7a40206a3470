// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "CameraOptions.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCubeAxesActor.h"
#include "vtkFloatArray.h"
#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysPass.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace
{
constexpr double ErrorFactor = 64.0;
constexpr double SmallestTolerance = 1e-6;
constexpr int VerifiedPixels = 1024;
constexpr float First = 10.0F;     // before VTK's own
constexpr int TimerInterval = 200; // milliseconds
}

//------------------------------------------------------------------------------
void Viewer::SetCamera(vtkRenderer* renderer, vtkCamera* from, const Scene& scene)
{
  vtkNew<vtkCamera> camera; // the stage's own is that of the beginning
  camera->DeepCopy(from);
  // VTK's styles turn the view about the focal point: as far away as the middle of the data is.
  double focus[3];
  double distance = 0.0;
  scene.Bounds.GetCenter(focus);
  for (int i = 0; i < 3; ++i)
  {
    distance += (focus[i] - camera->GetPosition()[i]) * camera->GetDirectionOfProjection()[i];
  }
  if (distance > 0.0)
  {
    camera->SetDistance(distance);
  }
  renderer->SetActiveCamera(camera);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
const char* Viewer::GetViewName(int view)
{
  static const char* const names[] = { "scene", "occlusion", "rays", "depth", "error" };
  return names[view];
}

//------------------------------------------------------------------------------
Viewer::Viewer(
  vtkRenderWindow* window, std::unique_ptr<Stage>& stage, Playlist& list, const Options& options)
  : Window(window)
  , Shown(stage)
  , List(list)
  , Settings(options)
  , Home(stage->GetOriginalView())
  , Step(list.GetStep())
{
  this->Interactor->SetRenderWindow(window);
  this->Interactor->EnableRenderOff(); // Render() is called for RenderEvent
  this->Over.emplace(this->Interactor);
  this->Over->OnDragLight([this](double x, double y) { this->OnDragLight(x, y); });
  this->Over->OnDragDivider([this](double x, double)
    { this->Divider = std::clamp(x / std::max(this->Window->GetSize()[0], 1), 0.02, 0.98); });
  this->SetStyle(stage->GetScene().IsTerrain());
  SetCamera(stage->GetRenderer(), this->Home.Camera, stage->GetScene());

  this->Observe(
    this->Interactor, vtkCommand::RenderEvent, [](Viewer* self) { self->Render(); }, false);
  this->Observe(
    this->Interactor, vtkCommand::KeyPressEvent,
    [](Viewer* self)
    {
      const char* symbol = self->Interactor->GetKeySym();
      self->OnKey(symbol ? symbol : "", self->Interactor->GetShiftKey() != 0);
    },
    true);
  // VTK's styles take letters here; 3 and P would leave a broken picture.
  this->Observe(
    this->Interactor, vtkCommand::CharEvent, [](Viewer*) {}, true);
  this->Observe(
    this->Interactor, vtkCommand::TimerEvent, [](Viewer* self) { self->OnTimer(); }, false);
  vtkNew<vtkCallbackCommand> drop;
  drop->SetClientData(this);
  drop->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* files)
    {
      std::vector<std::string> names;
      auto* array = static_cast<vtkStringArray*>(files);
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        names.push_back(array->GetValue(i));
      }
      if (!names.empty())
      {
        static_cast<Viewer*>(self)->TakeDrop(names);
        static_cast<Viewer*>(self)->Render();
      }
    });
  this->Interactor->AddObserver(vtkCommand::DropFilesEvent, drop, First);
  // Without this observer, VTK 9.1 closes the display at the end, while its loop still reads events.
  this->Observe(
    this->Interactor, vtkCommand::ExitEvent, [](Viewer* self) { self->Interactor->SetDone(true); },
    false);
}

//------------------------------------------------------------------------------
Viewer::~Viewer()
{
  this->SetGrid(false);
  this->Interactor->RemoveAllObservers();
}

//------------------------------------------------------------------------------
void Viewer::Observe(vtkObject* object, unsigned long event, void (*call)(Viewer*), bool last)
{
  struct Target
  {
    Viewer* Self;
    void (*Call)(Viewer*);
  };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Target{ this, call });
  command->SetClientDataDeleteCallback([](void* target) { delete static_cast<Target*>(target); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* target = static_cast<Target*>(data);
      target->Call(target->Self);
    });
  command->SetAbortFlagOnExecute(last);
  object->AddObserver(event, command, First);
}

//------------------------------------------------------------------------------
void Viewer::Run()
{
  this->Interactor->Initialize();
  this->StartTimer();
  this->Render();
  this->Interactor->Start();
  this->Numbers.reset();
  this->Over.reset();
  this->View = std::min<int>(this->View, RaysAlone);
  this->RenderPicture(); // VTK 9.3 keeps nothing of what it has shown
}

//------------------------------------------------------------------------------
/**
 * Where something may change by itself.
 */
void Viewer::StartTimer()
{
  if (!this->HasTimer &&
    (this->Settings.Watch || this->List.GetTimes().size() > 1 || this->List.GetSize() > 1))
  {
    this->HasTimer = this->Interactor->CreateRepeatingTimer(TimerInterval) != 0;
  }
}

//------------------------------------------------------------------------------
bool Viewer::OnKey(const std::string& symbol, bool shift)
{
  const KeyBinding* binding = FindKeyBinding(symbol);
  if (!binding)
  {
    return false;
  }
  this->Message.clear();
  if (this->Do(*binding, shift))
  {
    this->Render();
  }
  return true;
}

//------------------------------------------------------------------------------
void Viewer::OnTimer()
{
  if (this->IsPlaying)
  {
    this->TakeStep(1);
    this->Render();
  }
  else if (this->Settings.Watch && this->List.HasChanged(this->Item))
  {
    this->Open(this->Item, this->Step, true);
    this->Render();
  }
}

//------------------------------------------------------------------------------
/**
 * Show these files instead of those of the list.
 */
void Viewer::TakeDrop(const std::vector<std::string>& files)
{
  this->Message.clear();
  Playlist former = this->List;
  this->List.SetFiles(files);
  if (!this->Open(0, 0, false))
  {
    this->List = former;
  }
  this->StartTimer();
}

//------------------------------------------------------------------------------
/**
 * Show another scene; the present one if it cannot be read, and the reason. Returns whether it is shown.
 */
bool Viewer::Open(std::size_t item, std::size_t step, bool keepView)
{
  Viewpoint view = this->Shown->GetOriginalView();
  std::unique_ptr<Stage> next;
  try
  {
    next = this->List.Open(item, step, keepView ? &view : nullptr);
  }
  catch (const std::exception& failure)
  {
    this->Message = failure.what();
    return false;
  }
  const bool hasGrid = this->Grid;
  this->SetGrid(false);
  next->SetParameters(*this->Shown);
  next->SetPreset(this->Shown->GetLook());
  next->GetRays()->SetIntensity(this->Shown->GetRays()->GetIntensity());
  next->GetRays()->SetOutput(this->Shown->GetRays()->GetOutput());
  next->SetRays(this->Shown->AreRaysOn());
  next->SetBackground(this->Shown->GetBackground());
  next->SetExposure(this->SkyExposure);
  SetCamera(next->GetRenderer(),
    keepView ? this->Shown->GetRenderer()->GetActiveCamera() : next->GetView().Camera.Get(),
    next->GetScene());
  if (!keepView)
  {
    this->Home = next->GetOriginalView();
  }
  this->Window->RemoveRenderer(this->Shown->GetRenderer());
  this->Window->AddRenderer(next->GetRenderer());
  this->Shown = std::move(next);
  this->Item = item;
  this->Step = this->List.GetStep();
  this->SetGrid(hasGrid);
  if (this->Over->IsScalarBarShown())
  {
    this->Over->ShowScalarBar(&this->Shown->GetScene());
  }
  return true;
}

//------------------------------------------------------------------------------
double Viewer::GetAspect() const
{
  const int* size = this->Window->GetSize();
  return size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Viewer::Capture()
{
  this->Over->SetVisible(false);
  this->Window->SwapBuffersOff();
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(this->Window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  picture->Update();
  this->Window->SwapBuffersOn();
  this->Over->SetVisible(true);
  vtkSmartPointer<vtkImageData> result = picture->GetOutput();
  return result;
}

//------------------------------------------------------------------------------
/**
 * From white at the nearest to grey at the farthest; black where nothing is.
 */
vtkSmartPointer<vtkImageData> Viewer::MakeDepthPicture()
{
  vtkSmartPointer<vtkImageData> picture = this->Capture();
  int size[3];
  picture->GetDimensions(size);
  vtkNew<vtkFloatArray> depths;
  this->Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  vtkCamera* camera = this->Shown->GetRenderer()->GetActiveCamera();
  const double* range = camera->GetClippingRange();
  const bool parallel = camera->GetParallelProjection() != 0;
  const auto toDistance = [&](double depth)
  {
    return parallel ? range[0] + depth * (range[1] - range[0])
                    : range[0] * range[1] / (range[1] - depth * (range[1] - range[0]));
  };
  double nearest = VTK_DOUBLE_MAX;
  double farthest = 0.0;
  const vtkIdType count = std::min(depths->GetNumberOfValues(), picture->GetNumberOfPoints());
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double depth = depths->GetValue(i);
    if (depth < 1.0)
    {
      nearest = std::min(nearest, toDistance(depth));
      farthest = std::max(farthest, toDistance(depth));
    }
  }
  auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double depth = depths->GetValue(i);
    const double part =
      (toDistance(depth) - nearest) / (farthest > nearest ? farthest - nearest : 1.0);
    const double grey = depth < 1.0 ? 255.0 - 200.0 * part : 0.0;
    std::fill_n(bytes + 3 * i, 3, static_cast<unsigned char>(grey));
  }
  picture->Modified();
  return picture;
}

//------------------------------------------------------------------------------
/**
 * The rays less those of the smallest tolerance, 64 times as bright. The numbers are of more exact
 * values than a picture holds.
 */
vtkSmartPointer<vtkImageData> Viewer::MakeErrorPicture()
{
  vtkGodRaysPass* rays = this->Shown->GetRays();
  const double tolerance = rays->GetErrorTolerance();
  rays->SetOutput(vtkGodRaysPass::SCATTERING);
  vtkGodRaysIntegrator* integrator = rays->GetIntegrator();
  integrator->SetVerifyPixels(VerifiedPixels);
  const vtkSmartPointer<vtkImageData> picture = this->Capture();
  this->Errors = { integrator->GetErrorEstimate(), integrator->GetLargestVerifiedError() };
  integrator->SetVerifyPixels(0);
  rays->SetErrorTolerance(SmallestTolerance);
  const vtkSmartPointer<vtkImageData> exact = this->Capture();
  rays->SetErrorTolerance(tolerance);
  rays->SetOutput(vtkGodRaysPass::COMPOSITE);
  auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  const auto* others = static_cast<const unsigned char*>(exact->GetScalarPointer());
  std::transform(bytes, bytes + 3 * picture->GetNumberOfPoints(), others, bytes,
    [](unsigned char a, unsigned char b)
    { return static_cast<unsigned char>(std::min(ErrorFactor * std::abs(a - b), 255.0)); });
  picture->Modified();
  return picture;
}

//------------------------------------------------------------------------------
void Viewer::Render()
{
  if (this->IsRendering || !this->Over)
  {
    return; // a widget or VTK asks for it within it
  }
  this->IsRendering = true;
  const double start = GetSeconds();
  this->Errors = { -1.0, -1.0 };
  vtkSmartPointer<vtkImageData> picture;
  int width = this->Window->GetSize()[0];
  if (this->View == Depth)
  {
    picture = this->MakeDepthPicture();
  }
  else if (this->View == Error && this->Shown->AreRaysOn())
  {
    picture = this->MakeErrorPicture();
  }
  else if (this->Divider && this->Shown->AreRaysOn())
  {
    this->Shown->SetRays(false);
    picture = this->Capture();
    this->Shown->SetRays(true);
    width = static_cast<int>(std::lround(*this->Divider * width));
  }
  this->Over->ShowPicture(picture, width);
  this->UpdateOverlay();
  this->RenderPicture();
  this->LastFrame = GetSeconds() - start;
  this->IsRendering = false;
}

//------------------------------------------------------------------------------
void Viewer::RenderPicture()
{
  this->Window->Render();
}

//------------------------------------------------------------------------------
void Viewer::UpdateOverlay()
{
  this->Over->ShowDivider(this->Divider && this->View < Depth && this->Shown->AreRaysOn()
      ? static_cast<int>(std::lround(*this->Divider * this->Window->GetSize()[0]))
      : -1);
  double x = 0.0;
  double y = 0.0;
  const bool isBefore = FindLight(
    this->Shown->GetView(), this->Shown->GetRenderer()->GetActiveCamera(), this->GetAspect(), x, y);
  const int* size = this->Window->GetSize();
  this->Over->ShowHandle(this->HasHandle && isBefore, x * size[0], y * size[1]);
  if (this->Over->IsHelpShown())
  {
    this->Over->ShowHelp(true); // where the window's size has it
  }
  if (this->Numbers)
  {
    this->Numbers->Show(this->Shown->GetParameters());
  }
  this->Over->ShowMessage(this->Message);
  this->Over->ShowStatus(this->HasStatus ? this->GetStatus() : "");
}

//------------------------------------------------------------------------------
std::string Viewer::GetStatus() const
{
  std::ostringstream text;
  text.precision(3);
  text << this->List.GetName(this->Item);
  if (this->List.GetSize() > 1)
  {
    text << " (" << this->Item + 1 << " of " << this->List.GetSize() << ")";
  }
  const auto& times = this->List.GetTimes();
  if (times.size() > 1 && this->Step < times.size())
  {
    text << "  |  time " << times[this->Step];
  }
  text << "  |  " << (this->Shown->AreRaysOn() ? this->Shown->GetLook().Name : "no rays")
       << ", intensity " << this->Shown->GetRays()->GetIntensity() << "  |  "
       << GetViewName(this->View);
  if (this->Errors[0] >= 0.0)
  {
    text << " times " << ErrorFactor << ": " << this->Errors[0] << ", largest " << this->Errors[1]
         << " of the brightest ray";
  }
  if (this->LastFrame > 0.0)
  {
    text << "  |  " << 1.0 / this->LastFrame << " frames/s";
  }
  // Of the plan, the line that says how the rays are worked out, to its first comma.
  std::istringstream plan(this->Shown->GetRays()->GetPlan());
  for (std::string line; this->Shown->AreRaysOn() && std::getline(plan, line);)
  {
    if (line.rfind("scattering: ", 0) == 0)
    {
      text << "  |  " << line.substr(12, line.find(',', 12) - 12);
    }
  }
  text << "  |  H: help";
  std::istringstream advice(this->Shown->GetRays()->GetAdvice());
  for (std::string line; std::getline(advice, line);)
  {
    text << "  |  " << line.substr(0, line.find_first_of(":.")); // the rest is printed at the end
  }
  return text.str();
}
