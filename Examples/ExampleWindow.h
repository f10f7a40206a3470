// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What all examples end with: a window, or a picture of it.
 */

#ifndef ExampleWindow_h
#define ExampleWindow_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <functional>

/**
 * Write what the window shows to a PNG file, without opening it. Returns the program's exit status.
 */
inline int WritePicture(vtkRenderWindow* window, const char* file)
{
  window->SetSize(400, 300);
  window->SetMultiSamples(0);
  window->SetOffScreenRendering(true);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/**
 * Write what the window shows to the PNG file that the first argument names, without opening it;
 * without an argument, open it and let the user look around, and let the scene advance 25 times a
 * second if it can. Returns the program's exit status.
 */
inline int ShowOrWrite(
  vtkRenderWindow* window, int argc, char* argv[], const std::function<void()>& advance = {})
{
  if (argc > 1)
  {
    return WritePicture(window, argv[1]);
  }
  window->SetSize(400, 300);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();
  auto tick = [&]()
  {
    advance();
    window->Render();
  };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&tick);
  command->SetCallback([](vtkObject*, unsigned long, void* client, void*)
    { (*static_cast<decltype(tick)*>(client))(); });
  if (advance)
  {
    interactor->Initialize();
    interactor->AddObserver(vtkCommand::TimerEvent, command);
    interactor->CreateRepeatingTimer(40);
  }
  interactor->Start();
  return EXIT_SUCCESS;
}

#endif
