// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "System.h"

#include <csignal>
#include <cstdlib>
#include <random>
#include <sstream>
#include <system_error>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#include <shlwapi.h>
#else
#include <fnmatch.h>
#include <unistd.h>
#endif

namespace fs = std::filesystem;

#ifdef _WIN32

//------------------------------------------------------------------------------
long System::GetProcess()
{
  return _getpid();
}

//------------------------------------------------------------------------------
bool System::Has(Access access, const fs::path& path)
{
  return _waccess(path.c_str(), access == MayRead ? 4 : 2) == 0;
}

//------------------------------------------------------------------------------
bool System::HasProgram(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::stringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ';');)
  {
    std::error_code error;
    if (fs::is_regular_file(fs::path(folder) / (name + ".exe"), error))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool System::Matches(const std::string& name, const std::string& pattern)
{
  return PathMatchSpecA(name.c_str(), pattern.c_str()) != 0;
}

//------------------------------------------------------------------------------
std::string System::MakeTemporaryFolder()
{
  std::error_code error;
  const fs::path path =
    fs::temp_directory_path(error) / ("godrays-" + std::to_string(std::random_device{}()));
  return !error && fs::create_directory(path, error) ? path.string() : "";
}

//------------------------------------------------------------------------------
std::string System::QuoteForShell(const std::string& text)
{
  return '"' + text + '"'; // no name of a file has a quotation mark
}

//------------------------------------------------------------------------------
std::FILE* System::StartCommand(const std::string& command)
{
  return _popen(command.c_str(), "wb");
}

//------------------------------------------------------------------------------
bool System::EndCommand(std::FILE* input)
{
  return _pclose(input) == 0;
}

//------------------------------------------------------------------------------
void System::CatchEnds(Handler handler)
{
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

//------------------------------------------------------------------------------
void System::CatchCrashes(Handler handler)
{
  for (const int signal : { SIGSEGV, SIGABRT, SIGFPE, SIGILL })
  {
    std::signal(signal, handler ? handler : SIG_DFL);
  }
}

//------------------------------------------------------------------------------
int System::DivertErrors(std::FILE* file)
{
  const int former = _dup(Errors);
  return former >= 0 && file && _dup2(_fileno(file), Errors) >= 0 ? former : Errors;
}

//------------------------------------------------------------------------------
void System::RestoreErrors(int descriptor)
{
  _dup2(descriptor, Errors);
  _close(descriptor);
}

//------------------------------------------------------------------------------
void System::Write(int descriptor, const char* text, std::size_t size)
{
  _write(descriptor, text, static_cast<unsigned int>(size));
}

//------------------------------------------------------------------------------
bool System::IsTerminal(int descriptor)
{
  return _isatty(descriptor) != 0;
}

#else

//------------------------------------------------------------------------------
long System::GetProcess()
{
  return getpid();
}

//------------------------------------------------------------------------------
bool System::Has(Access access, const fs::path& path)
{
  return ::access(path.c_str(), access == MayRead ? R_OK : W_OK) == 0;
}

//------------------------------------------------------------------------------
bool System::HasProgram(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::stringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    if (::access((fs::path(folder) / name).c_str(), X_OK) == 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool System::Matches(const std::string& name, const std::string& pattern)
{
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

//------------------------------------------------------------------------------
std::string System::MakeTemporaryFolder()
{
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "godrays-XXXXXX").string();
  return !error && mkdtemp(name.data()) ? name : "";
}

//------------------------------------------------------------------------------
std::string System::QuoteForShell(const std::string& text)
{
  std::string quoted = "'";
  for (const char letter : text)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

//------------------------------------------------------------------------------
std::FILE* System::StartCommand(const std::string& command)
{
  std::signal(SIGPIPE, SIG_IGN); // EndCommand() tells of what the command did not take
  return popen(command.c_str(), "w");
}

//------------------------------------------------------------------------------
bool System::EndCommand(std::FILE* input)
{
  return pclose(input) == 0;
}

//------------------------------------------------------------------------------
void System::CatchEnds(Handler handler)
{
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction former = {};
    sigaction(signal, nullptr, &former);
    if (former.sa_handler == SIG_DFL) // nohup ignores SIGHUP, and that is so to stay
    {
      std::signal(signal, handler);
    }
  }
}

//------------------------------------------------------------------------------
void System::CatchCrashes(Handler handler)
{
  static char stack[1 << 16]; // the program's own may be what is full
  stack_t other = {};
  other.ss_sp = stack;
  other.ss_size = sizeof(stack);
  sigaltstack(&other, nullptr);
  struct sigaction action = {};
  action.sa_handler = handler ? handler : SIG_DFL;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : { SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL })
  {
    sigaction(signal, &action, nullptr);
  }
}

//------------------------------------------------------------------------------
int System::DivertErrors(std::FILE* file)
{
  const int former = dup(Errors);
  return former >= 0 && file && dup2(fileno(file), Errors) >= 0 ? former : Errors;
}

//------------------------------------------------------------------------------
void System::RestoreErrors(int descriptor)
{
  dup2(descriptor, Errors);
  close(descriptor);
}

//------------------------------------------------------------------------------
void System::Write(int descriptor, const char* text, std::size_t size)
{
  if (write(descriptor, text, size) < 0)
  {
    return; // there is nobody to tell
  }
}

//------------------------------------------------------------------------------
bool System::IsTerminal(int descriptor)
{
  return isatty(descriptor) == 1;
}

#endif

//------------------------------------------------------------------------------
void System::EndNow(int exitCode)
{
  std::_Exit(exitCode);
}
