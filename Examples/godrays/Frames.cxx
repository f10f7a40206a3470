// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"

#include "Failure.h"
#include "Output.h"
#include "System.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"
#include "vtkRenderWindow.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
bool IsOgv(const std::string& path)
{
  return fs::path(path).extension() == ".ogv";
}

//------------------------------------------------------------------------------
/**
 * Returns whether a file has its last page, to its end: VTK's writer does not look whether the disk is full.
 */
bool IsWholeOgg(const std::string& path)
{
  constexpr std::streamoff largestPage = 65307;
  constexpr std::size_t header = 27; // bytes, the last of which is the number of segments
  constexpr char isLast = 4;         // flag in the fifth byte
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto size = std::min<std::streamoff>(file.tellg(), largestPage);
  std::string end(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)), '\0');
  file.seekg(-size, std::ios::end);
  file.read(end.data(), size);
  const auto page = end.rfind("OggS");
  if (!file || page == std::string::npos || page + header > end.size())
  {
    return false;
  }
  const std::size_t segments = static_cast<unsigned char>(end[page + header - 1]);
  const auto lengths = end.begin() + static_cast<std::ptrdiff_t>(page + header);
  return (end[page + 5] & isLast) && page + header + segments <= end.size() &&
    std::accumulate(lengths, lengths + static_cast<std::ptrdiff_t>(segments),
      page + header + segments,
      [](std::size_t sum, char length)
      { return sum + static_cast<unsigned char>(length); }) == end.size();
}
}

//------------------------------------------------------------------------------
std::string FillTemplate(const std::string& text, const std::string& name, std::size_t number,
  std::size_t frame, std::optional<double> time)
{
  const auto toDigits = [](std::size_t value)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%04zu", value);
    return std::string(digits);
  };
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto end = text[i] == '{' ? text.find('}', i) : std::string::npos;
    if (end == std::string::npos)
    {
      filled += text[i];
      continue;
    }
    const std::string word = text.substr(i + 1, end - i - 1);
    if (word == "time")
    {
      std::ostringstream value;
      value << time.value_or(0.0);
      filled += value.str();
    }
    else if (word == "name" || word == "n" || word == "frame")
    {
      filled += word == "name" ? name : toDigits(word == "n" ? number : frame);
    }
    else
    {
      throw Failure("--output: {" + word + "} should be {name}, {n}, {frame} or {time}");
    }
    i = end;
  }
  return filled;
}

//------------------------------------------------------------------------------
Frames::Frames(const Options& options)
  : Settings(options)
{
  if (!options.Output.empty())
  {
    CheckPictureName(options.Output, options.Transparent);
    if (options.Output != "-")
    {
      // Of names that are filled in, the folder at least is known.
      CheckOutput("--output", FillTemplate(options.Output, "name", 1, 1, 0.0), options.Files);
    }
  }
  const std::string& film = options.Film;
  if (film.empty())
  {
    return;
  }
  CheckOutput("--film", film, options.Files);
  const std::string extension = fs::path(film).extension().string();
  const std::string types = " .mp4 .webm .mkv .gif .ogv ";
  if (extension.empty() || types.find(" " + extension + " ") == std::string::npos)
  {
    throw Failure("--film: " + film + " should end in .ogv, .mp4, .webm, .mkv or .gif");
  }
  if (!IsOgv(film) && !System::HasProgram("ffmpeg"))
  {
    throw Failure("--film: there is no ffmpeg to write " + extension +
      " with; install it, give a name that ends in .ogv, or write pictures with --output "
      "'{frame}.png'");
  }
}

//------------------------------------------------------------------------------
Frames::~Frames()
{
  if (this->Encoder)
  {
    System::EndCommand(this->Encoder);
  }
  this->Writer = nullptr;
}

//------------------------------------------------------------------------------
void Frames::StartFilm(vtkRenderWindow* window)
{
  const fs::path film = this->Settings.Film;
  this->Part = Temporary::MakeNameBeside(film.string());
  this->Kept.emplace(this->Part);
  if (IsOgv(film.string()))
  {
    auto writer = vtkSmartPointer<vtkOggTheoraWriter>::New();
    writer->SetRate(static_cast<int>(this->Settings.FrameRate + 0.5));
    writer->SetQuality(2);
    writer->SetFileName(this->Part.c_str());
    writer->SetInputData(TakePicture(window, false));
    writer->Start();
    this->Writer = writer;
    return;
  }
  std::ostringstream command;
  // Most players want even sizes and colours of half their resolution.
  command << "ffmpeg -loglevel error -y -f image2pipe -framerate " << this->Settings.FrameRate
          << " -i - -vf " << System::QuoteForShell("pad=ceil(iw/2)*2:ceil(ih/2)*2") << ' '
          << (film.extension() == ".gif" ? "" : "-pix_fmt yuv420p ")
          << System::QuoteForShell(this->Part);
  this->Encoder = System::StartCommand(command.str());
}

//------------------------------------------------------------------------------
void Frames::Write(vtkRenderWindow* window, const std::string& name, std::size_t number,
  std::optional<double> time, const std::vector<std::string>& inputs)
{
  ++this->Count;
  if (!this->Settings.Output.empty())
  {
    const std::string path = FillTemplate(this->Settings.Output, name, number, this->Count, time);
    if (path != "-")
    {
      CheckOutput("--output", path, inputs);
    }
    WritePicture(window, path, this->Settings.Transparent);
  }
  if (this->Settings.Film.empty())
  {
    return;
  }
  CheckOutput("--film", this->Settings.Film, inputs);
  if (this->Part.empty())
  {
    this->StartFilm(window);
  }
  if (this->Writer)
  {
    this->Writer->SetInputData(TakePicture(window, false));
    this->Writer->Write();
  }
  else if (this->Encoder)
  {
    PrintPicture(TakePicture(window, false), this->Encoder, "--film");
  }
}

//------------------------------------------------------------------------------
void Frames::Finish()
{
  if (this->Part.empty())
  {
    return;
  }
  bool isWritten = true;
  if (this->Writer)
  {
    this->Writer->End();
    isWritten = !this->Writer->GetError() && IsWholeOgg(this->Part);
    this->Writer = nullptr;
  }
  else
  {
    isWritten = this->Encoder && System::EndCommand(this->Encoder);
    this->Encoder = nullptr;
  }
  std::error_code error;
  if (isWritten)
  {
    fs::rename(this->Part, this->Settings.Film, error);
  }
  if (!isWritten || error)
  {
    throw Failure(
      "--film: " + this->Settings.Film + " could not be written; is the disk full?", Failure::File);
  }
  this->Part.clear();
}
