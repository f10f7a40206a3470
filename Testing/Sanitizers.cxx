// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What sanitizers are told at the start of each test program: see GODRAYS_SANITIZERS.

extern "C"
{
  // A leak is suppressed by the library that allocated it. Libraries stay, as of one that is closed the
  // name is not known at the end.
  int dlclose(void*)
  {
    return 0;
  }

  const char* __lsan_default_suppressions()
  {
    return "leak:swrast_dri.so\n" // Mesa's driver: 56 bytes twice for each context that is made
           "leak:libLLVM\n"       // its compiler
           "leak:libGLX\n"        // GLVND keeps a table of each display
           "leak:libX11\n";       // the display's, if a connection is left open
  }
}
