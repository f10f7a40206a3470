// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL's functions and constants, from the loader that this VTK has: glad since VTK 9.4, GLEW before.
 * Private to this module.
 */

#ifndef vtkGodRaysOpenGL_h
#define vtkGodRaysOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
