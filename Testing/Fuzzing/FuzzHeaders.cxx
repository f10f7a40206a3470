// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What is looked at before a reader of VTK's: the first byte chooses the type.

#include "GodRaysFuzzing.h"

#include "Failure.h"
#include "FileChecks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  using Check = void (*)(const std::string&);
  const Check checks[] = { CheckXml, CheckStl, CheckNrrd, CheckByu, CheckPnm, CheckHdr, Check3ds };
  const std::string& path = WriteBytes(data + 1, size - 1);
  try
  {
    checks[data[0] % 7](path);
  }
  catch (const Failure& failure)
  {
    Require(std::string(failure.what()).find('\n') == std::string::npos, "a failure is one line");
  }
  return 0;
}
