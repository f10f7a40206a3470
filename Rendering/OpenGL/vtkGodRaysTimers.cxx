// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTimers.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <chrono>

vtkGodRaysTimers::vtkGodRaysTimers() = default;
vtkGodRaysTimers::~vtkGodRaysTimers() = default;

void vtkGodRaysTimers::BeginFrame(bool measure)
{
  this->Measure = measure;
  this->Used = 0;
  this->Running = false;
}

void vtkGodRaysTimers::Start(Stage stage)
{
  this->Running = this->Measure && vtkOpenGLRenderTimer::IsSupported();
  if (!this->Running)
  {
    return;
  }
  if (this->Used == this->Timers.size())
  {
    this->Timers.emplace_back(stage, std::make_unique<vtkOpenGLRenderTimer>());
  }
  auto& timer = this->Timers[this->Used];
  timer.first = stage;
  timer.second->Reset();
  timer.second->Start();
}

void vtkGodRaysTimers::Stop()
{
  if (this->Running)
  {
    this->Timers[this->Used++].second->Stop();
    this->Running = false;
  }
}

void vtkGodRaysTimers::GetTimes(double seconds[NUMBER_OF_STAGES])
{
  std::fill_n(seconds, static_cast<int>(NUMBER_OF_STAGES), 0.0);
  if (this->Used == 0)
  {
    return;
  }
  glFinish(); // all commands are done: a driver hands the results over at once
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    vtkOpenGLRenderTimer& timer = *this->Timers[i].second;
    bool ready = timer.Ready();
    while (!ready && std::chrono::steady_clock::now() < latest)
    {
      ready = timer.Ready();
    }
    seconds[this->Timers[i].first] += ready ? timer.GetElapsedSeconds() : 0.0;
  }
}

void vtkGodRaysTimers::Release(vtkRenderWindow* window)
{
  auto context = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (context && !this->Timers.empty())
  {
    context->PushContext(); // timers know none, all else does
    this->Timers.clear();
    context->PopContext();
  }
  this->Timers.clear();
  this->Used = 0;
  this->Running = false;
}
