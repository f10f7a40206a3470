// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The OpenGL that is measured on, and the two units of cost: a full-screen copy and the bare march.

#ifndef Device_h
#define Device_h

#include "vtkGodRaysTarget.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <functional>
#include <memory>
#include <string>

class vtkOpenGLQuadHelper;

/**
 * Why no window can be opened, and what to do; empty if one can.
 */
std::string FindWhyNoDisplay();

class Device
{
public:
  Device();
  ~Device();

  vtkOpenGLRenderWindow* GetWindow() const { return this->OpenGLWindow; }

  /// The driver's name for what draws.
  std::string GetRendererName() const;

  /// The time that something takes on the processor and on the graphics card, to its end [s].
  double Measure(const std::function<void()>& run);

  /// Make the pictures that the units are measured on.
  void PrepareUnits(int width, int height);

  /// Draw a picture of 8-bit RGBA once more, interpolated: the time of a full-screen copy [s].
  double MeasureCopy();

  /// The customary sum of 60 taps of such a picture, and nothing else: the time of a march [s].
  double MeasureMarch();

private:
  double Draw(vtkOpenGLQuadHelper& quad);

  vtkNew<vtkRenderWindow> Window;
  vtkOpenGLRenderWindow* OpenGLWindow = nullptr;
  std::unique_ptr<vtkOpenGLQuadHelper> Copy;
  std::unique_ptr<vtkOpenGLQuadHelper> March;
  vtkGodRaysTarget From;
  vtkGodRaysTarget To;
};

#endif
