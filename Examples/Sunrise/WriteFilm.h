// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A film of what a window shows.
 */

#ifndef WriteFilm_h
#define WriteFilm_h

#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

/**
 * Write name.ogv, a film of Ogg/Theora, and each of its frames as name-0000.png and so on. Before each
 * frame, show() makes the scene what it is at a time from 0 to 1, and says what to tell the user.
 * Returns the program's exit status.
 */
inline int WriteFilm(vtkRenderWindow* window, std::array<int, 2> size, const std::string& name,
  int frames, const std::function<std::string(double)>& show)
{
  window->SetSize(size[0], size[1]);
  window->SetMultiSamples(0);
  window->SetOffScreenRendering(true);
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  vtkNew<vtkOggTheoraWriter> film;
  film->SetInputConnection(picture->GetOutputPort());
  film->SetFileName((name + ".ogv").c_str());
  film->SubsamplingOn(); // as players have it
  film->SetRate(25);
  film->Start();
  for (int i = 0; i < frames && !film->GetError() && !writer->GetErrorCode(); ++i)
  {
    const std::string text = show(static_cast<double>(i) / std::max(frames - 1, 1));
    window->Render();
    picture->Modified();
    std::ostringstream frame;
    frame << name << '-' << std::setw(4) << std::setfill('0') << i << ".png";
    writer->SetFileName(frame.str().c_str());
    writer->Write();
    film->Write();
    std::cout << "\rframe " << i + 1 << " of " << frames << ": " << text << ' ' << std::flush;
  }
  film->End();
  std::cout << '\n';
  return film->GetError() || writer->GetErrorCode() ? EXIT_FAILURE : EXIT_SUCCESS;
}

#endif
