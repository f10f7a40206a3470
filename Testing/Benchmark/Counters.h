// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What is allocated, in memory and on the graphics card, between two moments. Memory is counted where
// the C library and the C++ library are called, by the library that asked for it, so that what the
// OpenGL driver does for itself is told apart. OpenGL is counted where it is called.

#ifndef Counters_h
#define Counters_h

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

struct CountersResult
{
  bool HasAllocations = false;         // whether this platform can tell
  int Allocations = 0;                 // by vtkGodRays
  int VTKAllocations = 0;              // by VTK
  int OtherAllocations = 0;            // by the driver and the C++ library
  std::vector<std::string> Allocators; // functions of vtkGodRays that allocate
  int Shaders = 0;                     // compiled, and programs linked
  int Objects = 0; // textures, framebuffers, buffers and their like made or sized
};

/**
 * Count from now on.
 */
void StartCounters(vtkOpenGLRenderWindow* window);

/**
 * What was counted since.
 */
CountersResult StopCounters();

#endif
