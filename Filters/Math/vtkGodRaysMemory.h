// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysMemory.h
 * @brief   whether what a source or a filter is asked for fits into memory
 *
 * Private. VTK ends the process where an array cannot be allocated.
 */

#ifndef vtkGodRaysMemory_h
#define vtkGodRaysMemory_h

#include "vtksys/SystemInformation.hxx"

#include <sstream>
#include <string>

namespace vtkGodRays
{
/**
 * Returns the end of an error message with the number to lower, if a process can never have so many bytes;
 * else nothing.
 */
inline std::string FindMemoryFault(double bytes, const char* number)
{
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  vtksys::SystemInformation system;
  const double most = 1024.0 * static_cast<double>(system.GetProcMemoryAvailable());
  if (!(most > 0.0) || bytes <= most)
  {
    return "";
  }
  std::ostringstream fault;
  fault.precision(3);
  fault << bytes / gibibyte << " GiB of memory would be needed, where there are " << most / gibibyte
        << ". Set a smaller " << number << ".";
  return fault.str();
}
}

#endif
