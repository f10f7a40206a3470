// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Playlist.h"

#include "Advice.h"
#include "CameraOptions.h"
#include "Failure.h"
#include "Files.h"
#include "Messages.h"
#include "Progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace
{
//------------------------------------------------------------------------------
/**
 * MakeScene(), in which a filter of VTK's may crash of what a damaged file holds.
 */
Scene MakeSceneOf(
  const std::vector<FileContents>& files, const Options& options, std::vector<std::string>& notes)
{
  const std::string which = files.size() == 1 ? files.front().Path : "one of the files";
  const std::string remedy = "; the file is damaged, or not what its name says: write it again";
  const Messages messages(true, "godrays: " + which + ": cannot be drawn" + remedy, Failure::File);
  Scene scene = MakeScene(files, options);
  if (!messages.GetErrors().empty())
  {
    throw Failure(
      which + ": cannot be drawn (" + messages.GetErrors().front() + ")" + remedy, Failure::File);
  }
  notes.insert(notes.end(), messages.GetWarnings().begin(), messages.GetWarnings().end());
  notes.insert(notes.end(), scene.Notes.begin(), scene.Notes.end());
  return scene;
}
}

//------------------------------------------------------------------------------
double GetSeconds()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

//------------------------------------------------------------------------------
Playlist::Playlist(const Options& options)
  : Settings(&options)
{
  this->SetFiles(options.Files);
}

//------------------------------------------------------------------------------
void Playlist::SetFiles(const std::vector<std::string>& files)
{
  this->Files.insert(this->Files.end(), files.begin(), files.end());
  this->Items.clear();
  if (!this->Settings->Each)
  {
    this->Items = { files };
    return;
  }
  for (const std::string& file : files)
  {
    this->Items.push_back({ file });
  }
}

//------------------------------------------------------------------------------
std::string Playlist::GetName(std::size_t item) const
{
  return std::filesystem::path(this->Items[item].front()).stem().string();
}

//------------------------------------------------------------------------------
std::unique_ptr<Stage> Playlist::Open(std::size_t item, std::size_t step, const Viewpoint* view)
{
  const double start = GetSeconds();
  this->Opened = this->GetFileTime(item);
  std::optional<double> time = this->Settings->Time;
  if (step < this->Times.size() && (view || step > 0))
  {
    time = this->Times[step];
  }
  std::vector<FileContents> files;
  std::vector<std::string> notes;
  std::vector<double> times; // those of before stay where a file cannot be read
  for (const std::string& path : this->Items[item])
  {
    try
    {
      files.push_back(ReadFile(path, time));
    }
    catch (const Failure& failure)
    {
      throw Failure(failure.what(), Failure::File);
    }
    notes.insert(notes.end(), files.back().Notes.begin(), files.back().Notes.end());
    times.insert(times.end(), files.back().Times.begin(), files.back().Times.end());
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  this->Step = 0;
  for (std::size_t i = 1; time && i < times.size(); ++i)
  {
    this->Step = std::abs(times[i] - *time) < std::abs(times[this->Step] - *time) ? i : this->Step;
  }
  this->Times = std::move(times);
  if (this->Settings->Time && this->Times.empty())
  {
    notes.emplace_back("--time: no file has time steps, so it changes nothing");
  }
  if (!this->Settings->Up && !files.front().UpNote.empty())
  {
    notes.push_back(files.front().UpNote);
  }
  this->Took.Reading = GetSeconds() - start;
  std::optional<Waiting> waiting("preparing " + this->GetName(item));
  Scene scene = MakeSceneOf(files, *this->Settings, notes);
  const std::string ofVolumes = this->Settings->VolumeMedium ? "--volume-medium"
    : !this->Settings->VolumePreset.empty()                  ? "--volume-preset"
                                                             : "";
  Options settings = *this->Settings;
  if (!ofVolumes.empty() && scene.NumberOfVoxels == 0)
  {
    notes.push_back(ofVolumes + ": no volume is drawn, so it changes nothing");
    settings.VolumeMedium = false; // a model of volumes alone would have no light
  }
  const Viewpoint place = view ? *view : MakeView(scene, settings);
  waiting.reset();
  this->HasAdvice = false;
  if (settings.Rays)
  {
    const auto advice = GetAdvice(scene, place, settings, ::GetPreset(settings).IsMedium);
    notes.insert(notes.end(), advice.begin(), advice.end());
    this->HasAdvice = !advice.empty();
  }
  for (const std::string& note : notes)
  {
    if (!this->HasAdvised && !this->Settings->Quiet)
    {
      Messages::Show("godrays: " + note + "\n");
    }
  }
  this->HasAdvised = !this->Settings->Each; // a film would say it again in each frame
  this->Took.Preparing = GetSeconds() - start - this->Took.Reading;
  return std::make_unique<Stage>(std::move(scene), place, settings);
}

//------------------------------------------------------------------------------
Playlist::FileTime Playlist::GetFileTime(std::size_t item) const
{
  FileTime latest = FileTime::min();
  for (const std::string& file : this->Items[item])
  {
    std::error_code error;
    const FileTime time = std::filesystem::last_write_time(file, error);
    latest = error ? latest : std::max(latest, time);
  }
  return latest;
}

//------------------------------------------------------------------------------
bool Playlist::HasChanged(std::size_t item) const
{
  return this->GetFileTime(item) > this->Opened;
}
