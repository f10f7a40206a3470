// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the fuzzers share: libFuzzer's functions, a file of given bytes, and a stop where something is not so.

#ifndef GodRaysFuzzing_h
#define GodRaysFuzzing_h

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// End as at any other fault: libFuzzer keeps the input.
inline void Require(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "not so: %s\n", what);
    std::abort();
  }
}

/// The path of a file with these bytes; the former one is written over.
inline const std::string& WriteBytes(const std::uint8_t* data, std::size_t size)
{
  static const std::string path = "/tmp/godrays-fuzzing-" + std::to_string(getpid());
  static const bool isRemoved = std::atexit([] { std::remove(path.c_str()); }) == 0;
  (void)isRemoved;
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return path;
}

#endif
