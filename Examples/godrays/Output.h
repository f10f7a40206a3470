// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the picture goes: a file or a window.
 */

#ifndef Output_h
#define Output_h

#include "Options.h"

class vtkGodRaysPass;
class vtkRenderWindow;
class vtkRenderer;

/**
 * Throws Failure when the file's folder is missing or may not be written, or when its extension is
 * none that can be written.
 */
void CheckOutput(const std::string& path);

/**
 * Throws Failure when there is no display that can draw. VTK ends the program then.
 */
void CheckDisplay();

/**
 * Write what the window shows. Throws Failure when that fails.
 */
void WritePicture(vtkRenderWindow* window, const std::string& path);

/**
 * Let the user look around until the window is closed.
 */
void Interact(
  vtkRenderWindow* window, vtkRenderer* renderer, vtkGodRaysPass* rays, const std::string& preset);

#endif
