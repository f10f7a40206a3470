// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Functions of a test program that are put before OpenGL's, to count calls:
 *
 *   COUNT_CALLS(CompileShader, (GLuint s), (s), ++Shaders)
 *   COUNT_CALLS_1_1(GenTextures, (GLsizei n, GLuint* t), (n, t), Textures += n)
 *
 * outside of any namespace, and then, in each new context, INSTALL_COUNT(CompileShader) and
 * INSTALL_COUNT_1_1(GenTextures). The program has to be linked with ENABLE_EXPORTS.
 *
 * Both loaders keep pointers to functions, under macros with OpenGL's names, so that ours can be put in
 * their place. GLEW has none for OpenGL 1.1: there the program's symbols come before the library's.
 */

#ifndef CountOpenGLCalls_h
#define CountOpenGLCalls_h

#include "vtkGodRaysOpenGL.h"

#include <dlfcn.h>

#define COUNT_CALLS(name, parameters, arguments, count)                                            \
  static decltype(gl##name) Real##name = nullptr;                                                  \
  static void Count##name parameters                                                               \
  {                                                                                                \
    count;                                                                                         \
    Real##name arguments;                                                                          \
  }

#define INSTALL_COUNT(name)                                                                        \
  if (gl##name && gl##name != Count##name)                                                         \
  {                                                                                                \
    Real##name = gl##name;                                                                         \
    gl##name = Count##name;                                                                        \
  }

#ifdef glGenTextures
#define COUNT_CALLS_1_1(name, parameters, arguments, count)                                        \
  COUNT_CALLS(name, parameters, arguments, count)
#define INSTALL_COUNT_1_1(name) INSTALL_COUNT(name)
#else
#define COUNT_CALLS_1_1(name, parameters, arguments, count)                                        \
  extern "C" void gl##name parameters                                                              \
  {                                                                                                \
    static const auto next = reinterpret_cast<decltype(&gl##name)>(dlsym(RTLD_NEXT, "gl" #name));  \
    count;                                                                                         \
    next arguments;                                                                                \
  }
#define INSTALL_COUNT_1_1(name)
#endif

#endif
