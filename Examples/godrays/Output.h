// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the picture goes: a file or a window.
 */

#ifndef Output_h
#define Output_h

#include "Options.h"
#include "Presets.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkGodRaysPass;
class vtkRenderWindow;
class vtkRenderer;

/**
 * Throws Failure when the file's folder is missing or may not be written, when its extension is none that
 * can be written, or when it is one of the files to be read.
 */
void CheckOutput(const std::string& path, const std::vector<std::string>& inputs);

/**
 * The same of the file of --numbers.
 */
void CheckNumbers(const std::string& path, const std::vector<std::string>& inputs);

/**
 * Throws Failure when there is no display that can draw. VTK ends the program then.
 */
void CheckDisplay();

/**
 * Write what the window shows. Throws Failure when that fails; a file that was there is then as it was.
 */
void WritePicture(vtkRenderWindow* window, const std::string& path);

/**
 * Write the numbers of the medium of the last picture, with the irradiance of a white light [W m-2], or
 * relative to it. Throws Failure when there are none, or when that fails.
 */
void WriteNumbers(
  vtkGodRaysPass* rays, const std::optional<Vector3>& irradiance, const std::string& path);

/**
 * Let the user look around until the window is closed, and set another look or medium than this one.
 */
void Interact(vtkRenderWindow* window, vtkRenderer* renderer, vtkGodRaysPass* rays,
  const Preset& preset, const std::function<void(const Preset&)>& setPreset);

#endif
