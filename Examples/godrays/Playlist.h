// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files of the command line, one after another or together, and their time steps, as scenes to be
 * drawn.
 */

#ifndef Playlist_h
#define Playlist_h

#include "Options.h"
#include "Stage.h"
#include "Viewpoint.h"

#include <filesystem> // For std::filesystem
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string
#include <vector>     // For std::vector

/// How long the parts of opening take, in seconds.
struct OpeningTimes
{
  double Reading = 0.0;
  double Preparing = 0.0;
};

class Playlist
{
public:
  explicit Playlist(const Options& options);

  /**
   * Have these files instead of those of the options.
   */
  void SetFiles(const std::vector<std::string>& files);

  /**
   * All files that were given, by the options and since.
   */
  const std::vector<std::string>& GetFiles() const { return this->Files; }

  /**
   * How many scenes there are: one, or with --each as many as files.
   */
  std::size_t GetSize() const { return this->Items.size(); }

  /**
   * The name of a scene's first file, without folder and extension.
   */
  std::string GetName(std::size_t item) const;

  /**
   * Read a scene, at one of its time steps; with a view, seen and lit as there. Throws Failure.
   */
  std::unique_ptr<Stage> Open(std::size_t item, std::size_t step, const Viewpoint* view);

  /**
   * The times of the scene that was opened last; none if it does not change in time.
   */
  const std::vector<double>& GetTimes() const { return this->Times; }
  std::size_t GetStep() const { return this->Step; } ///< that it was opened at
  const OpeningTimes& GetOpeningTimes() const { return this->Took; }

  /**
   * Whether something was told of the scene that was opened last, that its picture would tell again.
   */
  bool WasAdvised() const { return this->HasAdvice; }

  /**
   * Whether a file of the scene was written since it was opened last.
   */
  bool HasChanged(std::size_t item) const;

private:
  using FileTime = std::filesystem::file_time_type;

  FileTime GetFileTime(std::size_t item) const;

  const Options* Settings;
  std::vector<std::vector<std::string>> Items;
  std::vector<std::string> Files;
  std::vector<double> Times;
  std::size_t Step = 0;
  OpeningTimes Took;
  FileTime Opened;
  bool HasAdvised = false;
  bool HasAdvice = false;
};

/**
 * Seconds on a clock that only runs forward.
 */
double GetSeconds();

#endif
