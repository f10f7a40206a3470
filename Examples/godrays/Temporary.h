// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A file or an empty folder that is removed when this object goes, and when the program is ended: by an
 * interrupt (Ctrl+C), by being terminated or hung up, or by a crash in a library.
 */
#ifndef Temporary_h
#define Temporary_h

#include <string>

class Temporary
{
public:
  /// Of at most eight at a time; of more, or of a name of 4096 letters, it is only gone with this object.
  explicit Temporary(const std::string& path);
  ~Temporary();

  Temporary(const Temporary&) = delete;
  void operator=(const Temporary&) = delete;

  /// Returns a name in the folder of a file, with its extension; short, whatever the file's own is.
  static std::string MakeNameBeside(const std::string& path);

  /// Remove all that there are, the latest first. A signal handler may call this.
  static void RemoveAll();

private:
  std::string Path;
  int Place;
};

#endif
