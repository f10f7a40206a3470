// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Temporary.h"

#include "System.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>

namespace
{
constexpr int Most = 8;
std::array<std::array<char, 4096>, Most> paths;
std::array<volatile std::sig_atomic_t, Most> used;

//------------------------------------------------------------------------------
// std::remove() is unlink() or rmdir(), which a signal handler may call.
void EndBySignal(int signal)
{
  Temporary::RemoveAll();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
}

//------------------------------------------------------------------------------
Temporary::Temporary(const std::string& path)
  : Path(path)
  , Place(0)
{
  System::CatchEnds(EndBySignal);
  while (this->Place < Most && used[this->Place])
  {
    ++this->Place;
  }
  if (this->Place < Most && path.size() < paths[this->Place].size())
  {
    path.copy(paths[this->Place].data(), path.size());
    paths[this->Place][path.size()] = '\0';
    used[this->Place] = 1;
  }
  else
  {
    this->Place = Most;
  }
}

//------------------------------------------------------------------------------
Temporary::~Temporary()
{
  std::remove(this->Path.c_str());
  if (this->Place < Most)
  {
    used[this->Place] = 0;
  }
}

//------------------------------------------------------------------------------
std::string Temporary::MakeNameBeside(const std::string& path)
{
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  const std::string name =
    "." + std::to_string(System::GetProcess()) + "-part" + whole.extension().string();
  return (whole.parent_path() / name).string();
}

//------------------------------------------------------------------------------
void Temporary::RemoveAll()
{
  for (int i = Most; i-- > 0;)
  {
    if (used[i])
    {
      std::remove(paths[i].data());
    }
  }
}
