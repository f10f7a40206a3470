// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysMemory.h
 * @brief   how much memory the process has, for tests
 */

#ifndef GodRaysMemory_h
#define GodRaysMemory_h

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace GodRaysMemory
{
// A line of /proc/self/status [bytes]; -1 where there is none.
inline double Get(const std::string& name)
{
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
  {
    double kilobytes = 0.0;
    if (word == name + ":" && file >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return -1.0;
}

// What is resident, VmRSS, once pages that nothing is in are given back; the largest size, VmHWM, is that
// from now on.
inline double Start()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << "5";
  return Get("VmRSS");
}
}

#endif
