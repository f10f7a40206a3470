// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Counters.h"

#include "CountOpenGLCalls.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <cxxabi.h>
#include <dlfcn.h>

namespace
{
// Callers are written down, not looked up, while it counts: looking up allocates.
const int MostCallers = 65536;
void* Callers[MostCallers];
std::atomic<int> NumberOfCallers{ 0 };
std::atomic<bool> Counting{ false };

int Shaders = 0;
int Objects = 0;

void CountAllocation(void* caller)
{
  if (Counting.load(std::memory_order_relaxed))
  {
    const int i = NumberOfCallers.fetch_add(1, std::memory_order_relaxed);
    if (i < MostCallers)
    {
      Callers[i] = caller;
    }
  }
}
}

// These symbols of the program come before those of the libraries.
#ifdef __GLIBC__
extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* memory, std::size_t size);

  void* malloc(std::size_t size)
  {
    CountAllocation(__builtin_return_address(0));
    return __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    CountAllocation(__builtin_return_address(0));
    return __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    CountAllocation(__builtin_return_address(0));
    return __libc_realloc(memory, size);
  }
}

void* operator new(std::size_t size)
{
  CountAllocation(__builtin_return_address(0));
  if (void* memory = __libc_malloc(size ? size : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
#endif

COUNT_CALLS(CompileShader, (GLuint s), (s), ++Shaders)
COUNT_CALLS(LinkProgram, (GLuint p), (p), ++Shaders)
COUNT_CALLS(BufferData, (GLenum t, GLsizeiptr s, const void* d, GLenum u), (t, s, d, u), ++Objects)
COUNT_CALLS(GenBuffers, (GLsizei n, GLuint* f), (n, f), Objects += n)
COUNT_CALLS(GenFramebuffers, (GLsizei n, GLuint* f), (n, f), Objects += n)
COUNT_CALLS(GenRenderbuffers, (GLsizei n, GLuint* f), (n, f), Objects += n)
COUNT_CALLS(GenVertexArrays, (GLsizei n, GLuint* f), (n, f), Objects += n)
COUNT_CALLS(GenQueries, (GLsizei n, GLuint* f), (n, f), Objects += n)
COUNT_CALLS_1_1(TexImage2D,
  (GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height, GLint border,
    GLenum format, GLenum type, const void* pixels),
  (target, level, internalFormat, width, height, border, format, type, pixels), ++Objects)
COUNT_CALLS_1_1(GenTextures, (GLsizei n, GLuint* t), (n, t), Objects += n)

//------------------------------------------------------------------------------
void StartCounters(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  INSTALL_COUNT(CompileShader)
  INSTALL_COUNT(LinkProgram)
  INSTALL_COUNT(BufferData)
  INSTALL_COUNT(GenBuffers)
  INSTALL_COUNT(GenFramebuffers)
  INSTALL_COUNT(GenRenderbuffers)
  INSTALL_COUNT(GenVertexArrays)
  INSTALL_COUNT(GenQueries)
  INSTALL_COUNT_1_1(TexImage2D)
  INSTALL_COUNT_1_1(GenTextures)
  Shaders = 0;
  Objects = 0;
  NumberOfCallers = 0;
  Counting = true;
}

//------------------------------------------------------------------------------
CountersResult StopCounters()
{
  Counting = false;
  CountersResult result;
  result.Shaders = Shaders;
  result.Objects = Objects;
#ifdef __GLIBC__
  result.HasAllocations = true;
#endif
  const int count = std::min(NumberOfCallers.load(), MostCallers);
  result.OtherAllocations = NumberOfCallers - count;
  for (int i = 0; i < count; ++i)
  {
    Dl_info info = {};
    const bool known = dladdr(Callers[i], &info) != 0 && info.dli_fname;
    const std::string file = known ? info.dli_fname : "";
    if (file.find("libvtk") == std::string::npos)
    {
      ++result.OtherAllocations;
      continue;
    }
    if (file.find("libvtkGodRays") == std::string::npos)
    {
      ++result.VTKAllocations;
      continue;
    }
    ++result.Allocations;
    int status = 1;
    char* readable =
      info.dli_sname ? abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status) : nullptr;
    const std::string name = file.substr(file.rfind('/') + 1) + ": " +
      (status == 0         ? readable
          : info.dli_sname ? info.dli_sname
                           : "a local function");
    std::free(readable);
    if (std::find(result.Allocators.begin(), result.Allocators.end(), name) ==
      result.Allocators.end())
    {
      result.Allocators.push_back(name);
    }
  }
  return result;
}
