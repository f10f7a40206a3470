// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "vtksys/MD5.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

using namespace Statistics;

namespace
{
/// Two digits, the way that is easy to read; a dash for None.
std::string Format(double value)
{
  if (std::isnan(value))
  {
    return "-";
  }
  char text[32];
  const double size = std::abs(value);
  if (size >= 99.5 || value == std::floor(value))
  {
    std::snprintf(text, sizeof(text), "%.0f", value);
  }
  else if (size >= 9.95)
  {
    std::snprintf(text, sizeof(text), "%.1f", value);
  }
  else if (size >= 0.0995)
  {
    std::snprintf(text, sizeof(text), "%.2f", value);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1e", value);
    std::string shorter = text; // 1.0e-03 to 1.0e-3
    const auto zero = shorter.find("e-0");
    return zero == std::string::npos ? shorter : shorter.erase(zero + 2, 1);
  }
  return text;
}

/// What the processor calls itself.
std::string GetProcessor()
{
  vtksys::SystemInformation system;
  system.RunCPUCheck();
  return system.GetExtendedProcessorName();
}

/// How busy the machine is; more programs than processors make the figures of threads meaningless.
std::string GetLoad()
{
#ifdef __unix__
  double load = 0.0;
  if (getloadavg(&load, 1) == 1)
  {
    return "; programs that wanted one in the last minute: " + Format(load) +
      (load > 1.5 * std::thread::hardware_concurrency()
          ? ", so figures of threads, and of small differences, mean little"
          : "");
  }
#endif
  return {};
}

/// The middle half of samples, about their median.
std::string FormatSpread(const std::vector<double>& samples)
{
  const double median = GetMedian(samples);
  return std::isnan(median) ? "-"
                            : Format(median) + " (" + Format(GetQuantile(samples, 0.25)) + " to " +
      Format(GetQuantile(samples, 0.75)) + ")";
}

std::vector<double> Select(const std::vector<Record>& records, bool onScreen,
  const std::string& method, int channels, double (*value)(const Record&))
{
  std::vector<double> values;
  for (const Record& record : records)
  {
    if (record.Section == "scattering" && record.OnScreen == onScreen && record.HasErrors &&
      record.Method == method && record.Channels == channels)
    {
      values.push_back(value(record));
    }
  }
  return values;
}
}

//------------------------------------------------------------------------------
void SealPage(const std::string& file)
{
  const auto read = [](const std::filesystem::path& path)
  {
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
    {
      throw std::runtime_error(path.string() + " cannot be read");
    }
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string page = read(file);
  std::string all = page;
  const std::string begin = "](";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
  {
    const auto close = page.find(')', at);
    const std::string name = page.substr(at + begin.size(), close - at - begin.size());
    const std::filesystem::path beside = std::filesystem::path(file).parent_path() / name;
    if ((beside.extension() == ".png" || beside.extension() == ".csv") &&
      std::filesystem::exists(beside))
    {
      all += read(beside);
    }
  }
  vtksysMD5* digest = vtksysMD5_New();
  vtksysMD5_Initialize(digest);
  vtksysMD5_Append(
    digest, reinterpret_cast<const unsigned char*>(all.data()), static_cast<int>(all.size()));
  char text[33] = {};
  vtksysMD5_FinalizeHex(digest, text);
  vtksysMD5_Delete(digest);
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream << "\n<!-- One run wrote this page and its pictures: " << text << " -->\n";
  stream.close();
  if (!stream)
  {
    throw std::runtime_error(file + " cannot be written");
  }
}

//------------------------------------------------------------------------------
double GetRMS(const Record& record)
{
  return record.HasErrors ? record.Error.RMS : None;
}
double GetPermille(const Record& record)
{
  return record.HasErrors ? record.Error.Permille : None;
}
double GetLargestError(const Record& record)
{
  return record.HasErrors ? record.Error.Largest : None;
}
double GetBias(const Record& record)
{
  return record.HasErrors ? record.Error.Bias : None;
}
double GetCopies(const Record& record)
{
  return record.Copies;
}
double GetMarches(const Record& record)
{
  return record.Marches;
}
double GetGain(const Record& record)
{
  return record.Gain;
}
double GetMilliseconds(const Record& record)
{
  return record.Milliseconds;
}

//------------------------------------------------------------------------------
bool Figure::IsMeasured() const
{
  return !std::isnan(this->Measured);
}

//------------------------------------------------------------------------------
bool Figure::IsMet() const
{
  return this->Relates == AT_MOST ? this->Measured <= this->Bound : this->Measured >= this->Bound;
}

//------------------------------------------------------------------------------
std::string MakeFigureTable(const std::vector<Figure>& figures)
{
  std::ostringstream text;
  text << "| figure | asked | measured | |\n|---|---|---|---|\n";
  for (const Figure& figure : figures)
  {
    text << "| " << figure.Text << (figure.Note.empty() ? "" : " (" + figure.Note + ")") << " | ";
    text << (figure.Relates == Figure::AT_MOST ? "at most " : "at least ") << Format(figure.Bound);
    text << " | " << Format(figure.Measured) << " | "
         << (!figure.IsMeasured() ? "not measured"
                : figure.IsMet()  ? "met"
                                  : "**missed**")
         << " |\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::vector<double> Report::Get(const std::string& section, const std::string& method, int channels,
  double (*value)(const Record&)) const
{
  std::vector<double> values;
  for (const Record& record : this->Records)
  {
    if (record.Section == section && record.Method == method && record.Channels == channels)
    {
      values.push_back(value(record));
    }
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<std::string> Report::GetMethods(const std::string& section) const
{
  std::vector<std::string> names;
  for (const Record& record : this->Records)
  {
    if (record.Section == section &&
      std::find(names.begin(), names.end(), record.Method) == names.end())
    {
      names.push_back(record.Method);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::string Report::MakeTables() const
{
  std::ostringstream text;
  const auto scattering = this->GetMethods("scattering");
  if (!scattering.empty())
  {
    std::size_t mostCases = 0;
    for (const std::string& name : scattering)
    {
      mostCases = std::max(mostCases, this->Get("scattering", name, 1, GetRMS).size());
    }
    text << "## Error\n\n"
         << "| method | on screen: RMSE, worst | 99.9 %, worst | max | off screen: RMSE, worst "
            "| 99.9 %, worst | max | bias, worst |\n|---|---|---|---|---|---|---|---|\n";
    for (const std::string& name : scattering)
    {
      const auto cases = this->Get("scattering", name, 1, GetRMS).size();
      text << "| " << name
           << (cases < mostCases ? ", " + std::to_string(cases) + " cases" : std::string());
      for (bool onScreen : { true, false })
      {
        const auto rms = Select(this->Records, onScreen, name, 1, GetRMS);
        const auto permille = Select(this->Records, onScreen, name, 1, GetPermille);
        text << " | " << Format(GetRootMeanSquare(rms)) << ", " << Format(GetLargest(rms)) << " | "
             << Format(GetMedian(permille)) << ", " << Format(GetLargest(permille)) << " | "
             << Format(GetLargest(Select(this->Records, onScreen, name, 1, GetLargestError)));
      }
      double bias = 0.0;
      for (double value : this->Get("scattering", name, 1, GetBias))
      {
        bias = std::abs(value) > std::abs(bias) ? value : bias;
      }
      text << " | " << Format(bias) << " |\n";
    }
    text << "\n## Cost\n\n"
         << "| method | one colour: marches | copies | taps 100 / it | RGB: marches | copies "
            "| taps 100 / it |\n|---|---|---|---|---|---|---|\n";
    for (const std::string& name : scattering)
    {
      text << "| " << name;
      for (int channels : { 1, 3 })
      {
        text << " | " << FormatSpread(this->Get("scattering", name, channels, GetMarches)) << " | "
             << FormatSpread(this->Get("scattering", name, channels, GetCopies)) << " | "
             << Format(GetMedian(this->Get("scattering", name, channels, GetGain)));
      }
      text << " |\n";
    }
    text << "\n";
  }

  const auto effects = this->GetMethods("effect");
  if (!effects.empty())
  {
    text << "## The whole effect\n\n| integrator | size | marches | copies |\n|---|---|---|---|\n";
    for (const Record& record : this->Records)
    {
      if (record.Section == "effect")
      {
        text << "| " << record.Method << " | " << record.Width << " x " << record.Height << " | "
             << Format(record.Marches) << " | " << Format(record.Copies) << " |\n";
      }
    }
    text << "\n";
  }

  for (const char* section : { "samples", "pixels" })
  {
    const auto methods = this->GetMethods(section);
    if (methods.empty())
    {
      continue;
    }
    const bool samples = std::string(section) == "samples";
    text << (samples ? "## Cost against NumberOfSamples\n\nIn bare marches.\n\n"
                     : "## Cost against pixels\n\nIn bare marches at 1920 x 1080, or the largest "
                       "size before it.\n\n");
    std::vector<std::string> columns;
    for (const Record& record : this->Records)
    {
      const std::string column = samples
        ? std::to_string(record.Samples)
        : std::to_string(record.Width) + " x " + std::to_string(record.Height);
      if (record.Section == section &&
        std::find(columns.begin(), columns.end(), column) == columns.end())
      {
        columns.push_back(column);
      }
    }
    text << "| method |";
    for (const std::string& column : columns)
    {
      text << " " << column << " |";
    }
    text << (samples ? "\n|---|" : " exponent |\n|---|---|");
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      text << "---|";
    }
    text << "\n";
    for (const std::string& name : methods)
    {
      text << "| " << name << " |";
      std::vector<double> x;
      std::vector<double> y;
      std::size_t i = 0;
      for (const Record& record : this->Records)
      {
        if (record.Section == section && record.Method == name)
        {
          text << " " << Format(record.Marches) << " |";
          x.push_back(static_cast<double>(record.Width) * record.Height);
          y.push_back(record.Milliseconds);
          ++i;
        }
      }
      for (; i < columns.size(); ++i)
      {
        text << " - |";
      }
      text << (samples ? "" : " " + Format(FitExponent(x, y)) + " |") << "\n";
    }
    text << "\n";
  }

  text << "## The figures that are asked for\n\n" << MakeFigureTable(this->Figures);
  return text.str();
}

//------------------------------------------------------------------------------
void Report::WriteCSV(const std::string& file) const
{
  std::ofstream stream(file);
  stream
    << "section,picture,light,method,channels,width,height,samples,threads,milliseconds,copies,"
       "marches,gain,rmse,permille,max,bias\n";
  const auto write = [&stream](double value)
  {
    stream << ",";
    if (!std::isnan(value))
    {
      stream << value;
    }
  };
  for (const Record& record : this->Records)
  {
    stream << record.Section << "," << record.Picture << "," << record.Light << ",\""
           << record.Method << "\"," << record.Channels << "," << record.Width << ","
           << record.Height << "," << record.Samples << "," << record.Threads;
    for (double value : { record.Milliseconds, record.Copies, record.Marches, record.Gain,
           GetRMS(record), GetPermille(record), GetLargestError(record), GetBias(record) })
    {
      write(value);
    }
    stream << "\n";
  }
  stream.close();
  if (!stream)
  {
    throw std::runtime_error(file + " cannot be written");
  }
}

//------------------------------------------------------------------------------
void Report::WritePage(const std::string& file, const std::string& command) const
{
  std::ofstream stream(file);
  stream
    << "# Performance\n\n"
    << "Written by `" << command << "`; what it measures stands in\n"
    << "`Testing/Benchmark/Benchmark.h`. Times differ from machine to machine and "
       "from hour to hour, so costs\nare ratios of times taken in the same round: to a *copy*, "
       "a full-screen quad of 8-bit RGBA that is interpolated\nonce, and to a *march*, the "
       "bare loop of 60 taps of such a picture at full size, which is the steadier of the\n"
       "two. Rounds run everything once, in rotating order; medians, and quartiles in "
       "brackets. An integrator's time\nincludes all copies to and from the card. Taps have no "
       "layers of one channel: one colour "
       "costs them as much as RGB.\n\n"
    << "Errors are against `vtkGodRaysReferenceFilter`, as fractions of the peak of the exact "
       "result, on "
    << this->Rows << " rows of each\ncase: " << this->Width << " x " << this->Height
    << ", density 0.97, decay 0.99, 100 samples, 16-bit layers. RMSE: over all cases, and of "
       "the worst; 99.9th\npercentile: of the median case, and of the worst. "
    << this->Get("scattering", "taps 100", 1, GetRMS).size()
    << " cases: pictures times lights; the slowest\nintegrators run in two of them at most, "
       "also in the chart.\n\n"
    << "OpenGL: " << this->Renderer << ". Vector instructions: " << this->Instructions
    << " (AVX3 is AVX-512), on " << GetProcessor()
    << ". Processors: " << std::thread::hardware_concurrency() << GetLoad() << ".\n\n"
    << "![Speed against error](Charts/speed-and-error.png)\n\n"
    << this->MakeTables() << "\n"
    << "![Cost against NumberOfSamples](Charts/samples.png)\n\n"
    << "![Cost against pixels](Charts/pixels.png)\n";
  stream.close();
  if (!stream)
  {
    throw std::runtime_error(file + " cannot be written");
  }
}
