// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Asks the operating system for what the program needs. System.cxx alone calls POSIX or Windows.
 */
#ifndef System_h
#define System_h

#include <cstddef>    // For std::size_t
#include <cstdio>     // For std::FILE
#include <filesystem> // For std::filesystem::path
#include <string>     // For std::string

namespace System
{
enum Access
{
  MayRead,
  MayWrite
};

/// Returns whether the user may read or write what is at a path.
bool Has(Access access, const std::filesystem::path& path);

/// Returns whether the folders of PATH hold a program.
bool HasProgram(const std::string& name);

/// Returns whether a name is of a pattern of the shell, such as *.vti. Windows has no sets in brackets.
bool Matches(const std::string& name, const std::string& pattern);

/// Returns the number of this process.
long GetProcess();

/// Makes an empty folder that only the user may read, and returns its path; empty if that fails.
std::string MakeTemporaryFolder();

/// Returns an argument of a command as the shell reads it.
std::string QuoteForShell(const std::string& text);

/// Starts a command of the shell that reads what is written to the file; null if it cannot be started.
std::FILE* StartCommand(const std::string& command);

/// Waits for the end of that command, and returns whether it succeeded.
bool EndCommand(std::FILE* input);

using Handler = void (*)(int signal);

/// Has signals that end the program call a handler, but for those that are ignored, as nohup has it.
void CatchEnds(Handler handler);

/// Has crashes call a handler, on a stack of its own; null: ends that.
void CatchCrashes(Handler handler);

/// Writes the standard error output into a file, and returns a descriptor of where it went before.
int DivertErrors(std::FILE* file);

/// Ends that. The descriptor is closed.
void RestoreErrors(int descriptor);

/// The descriptor of the standard error output.
constexpr int Errors = 2;

/// Writes to a descriptor. A signal handler may call this.
void Write(int descriptor, const char* text, std::size_t size);

/// Returns whether a descriptor is a terminal.
bool IsTerminal(int descriptor);

/// Ends the program without its destructors. A signal handler may call this.
[[noreturn]] void EndNow(int exitCode);
}

#endif
