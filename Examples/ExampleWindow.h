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

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

/**
 * Take a size, such as 1920x1080, out of the arguments; without one it is 1280x720.
 */
inline std::array<int, 2> TakeSize(int& argc, char* argv[])
{
  std::array<int, 2> size{ 1280, 720 };
  const auto isSize = [&size](const char* argument)
  {
    int given[2];
    char rest;
    const bool is = std::sscanf(argument, "%dx%d%c", &given[0], &given[1], &rest) == 2 &&
      std::min(given[0], given[1]) > 0 && std::max(given[0], given[1]) <= 16384;
    if (is)
    {
      size = { given[0], given[1] };
    }
    return is;
  };
  argc = static_cast<int>(std::remove_if(argv + 1, argv + argc, isSize) - argv);
  return size;
}

/**
 * Tell what is wrong, and how the program is called. Returns its exit status.
 */
inline int Refuse(const std::string& what)
{
  std::cerr << what
            << "\nArguments: [picture.png] [WIDTHxHEIGHT]; without a picture, a window opens.\n";
  return EXIT_FAILURE;
}

/**
 * Whether there is a display for the window, where it needs one: VTK ends the program without.
 */
inline bool HasDisplay(vtkRenderWindow* window)
{
  const bool has = !window->IsA("vtkXOpenGLRenderWindow") || std::getenv("DISPLAY");
  if (!has)
  {
    std::cerr << "There is no X display: DISPLAY is not set. Run this in a desktop session, or "
                 "under xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\".\n";
  }
  return has;
}

/**
 * Write what the window shows to a PNG file, without opening it, with so many samples a pixel. Returns the
 * program's exit status.
 */
inline int WritePicture(
  vtkRenderWindow* window, std::array<int, 2> size, const std::string& file, int samples = 0)
{
  const std::string suffix = ".png";
  if (file.size() < suffix.size() ||
    file.compare(file.size() - suffix.size(), suffix.size(), suffix) != 0)
  {
    return Refuse("The name of a picture ends in .png, not " + file + ".");
  }
  if (!HasDisplay(window))
  {
    return EXIT_FAILURE;
  }
  window->SetSize(size[0], size[1]);
  window->SetMultiSamples(samples);
  window->SetOffScreenRendering(true);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/**
 * Write what the window shows, in this size, to the PNG file that the first argument names, without opening
 * it, with so many samples a pixel; without an argument, open it and let the user look around, and let the
 * scene advance 25 times a second if it can. Returns the program's exit status.
 */
inline int ShowOrWrite(vtkRenderWindow* window, std::array<int, 2> size, int argc, char* argv[],
  const std::function<void()>& advance = {}, int samples = 0)
{
  if (argc > 2)
  {
    return Refuse(
      std::string("A size is WIDTHxHEIGHT, each from 1 to 16384, not ") + argv[2] + ".");
  }
  if (argc > 1)
  {
    return WritePicture(window, size, argv[1], samples);
  }
  if (!HasDisplay(window))
  {
    return EXIT_FAILURE;
  }
  window->SetSize(size[0], size[1]);
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
