// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChecks.h"

#include "Failure.h"
#include "System.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
std::uint32_t ReadLittleEndian(const std::string& path, std::streamoff position)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(position);
  unsigned char bytes[4] = {};
  file.read(reinterpret_cast<char*>(bytes), 4);
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

//------------------------------------------------------------------------------
/**
 * Returns the remedy for a file that is not there.
 */
std::string GetRemedy(const std::string& path)
{
  if (path.find("://") != std::string::npos)
  {
    return "; it is an address: name a file on this machine, without " +
      path.substr(0, path.find("://") + 3);
  }
  return path[0] == '-' ? "; what follows -- is files: name options before it"
                        : "; check the name and the folder";
}

//------------------------------------------------------------------------------
void CheckParts(vtkXMLDataElement* element, const fs::path& folder)
{
  for (const char* name : { "Source", "file" })
  {
    if (const char* part = element->GetAttribute(name))
    {
      CheckRegular((folder / part).string());
      CheckXmlParts((folder / part).string());
    }
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    CheckParts(element->GetNestedElement(i), folder);
  }
}
}

//------------------------------------------------------------------------------
void CheckRegular(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
  {
    throw Failure(path + ": there is no such file" + GetRemedy(path));
  }
  if (fs::is_directory(status))
  {
    throw Failure(path + ": is a directory; name the files in it");
  }
  if (error || !System::Has(System::MayRead, path))
  {
    throw Failure(path + ": may not be read; change its permissions");
  }
  if (!fs::is_regular_file(status))
  {
    throw Failure(path + ": is no regular file; copy what it holds to one");
  }
  if (fs::file_size(path, error) == 0)
  {
    throw Failure(path + ": is empty; write or copy it again");
  }
}

//------------------------------------------------------------------------------
void CheckXmlParts(const std::string& path)
{
  const std::string type = fs::path(path).extension().string();
  const bool namesFiles =
    type.rfind(".p", 0) == 0 || type.rfind(".vtm", 0) == 0 || type == ".vtpd" || type == ".vtpc";
  constexpr std::uintmax_t most = 1 << 24; // more is no list of files
  if (namesFiles && fs::file_size(path) < most)
  {
    const auto root = vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
    if (root)
    {
      CheckParts(root, fs::path(path).parent_path());
    }
  }
}

//------------------------------------------------------------------------------
void CheckXml(const std::string& path)
{
  constexpr long most = 100000;
  constexpr std::size_t enough = 1
    << 20; // of the file: what it says of its arrays stands before their values
  std::string start(enough, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), enough);
  start.resize(static_cast<std::size_t>(file.gcount()));
  const std::string word = "NumberOfComponents=\"";
  for (auto at = start.find(word); at != std::string::npos; at = start.find(word, at + 1))
  {
    if (std::strtol(start.c_str() + at + word.size(), nullptr, 10) > most)
    {
      throw Failure(path + ": says a size that cannot be; write it again");
    }
  }
}

//------------------------------------------------------------------------------
void CheckStl(const std::string& path)
{
  // VTK reads what there is of a binary file that was cut off.
  constexpr std::uintmax_t header = 84;
  constexpr std::uintmax_t facet = 50;
  std::string start(5, ' ');
  std::ifstream(path, std::ios::binary).read(start.data(), 5);
  const std::uintmax_t needed = header + facet * ReadLittleEndian(path, 80);
  if (start != "solid" && needed > fs::file_size(path))
  {
    throw Failure(path +
      ": is shorter than it says, or no .stl; copy it again, or give it the extension of its type");
  }
}

//------------------------------------------------------------------------------
void Check3ds(const std::string& path)
{
  // VTK goes through all of the length that a file says, byte by byte past its end.
  if (ReadLittleEndian(path, 2) > fs::file_size(path))
  {
    throw Failure(path + ": is shorter than it says; copy it again");
  }
}

//------------------------------------------------------------------------------
void CheckNrrd(const std::string& path)
{
  // VTK reads for ever in a header whose last line has no end, that does not say how many sizes it has,
  // or that counts files in steps of 0. For VTK, a header ends with an empty line, a null, or the file.
  constexpr std::size_t most = 0x400000 - 1; // as VTK has it
  constexpr double mostFiles = 100000;
  std::string header(most, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(header.data(), most);
  header.resize(static_cast<std::size_t>(file.gcount()));
  header.resize(std::min(header.size(), header.find('\0')));
  std::istringstream lines(header);
  bool ends = false;
  bool hasFiles = false;
  int dimension = 0;
  for (std::string line; !ends && std::getline(lines, line);)
  {
    std::sscanf(line.c_str(), "dimension: %d", &dimension);
    ends = line.empty() || line == "\r";
    if (line.rfind("data file:", 0) == 0 || line.rfind("datafile:", 0) == 0)
    {
      hasFiles = true;
      double least = 0.0;
      double largest = 0.0;
      double step = 1.0;
      if (std::sscanf(
            line.c_str() + line.find(':'), ": %*s %lf %lf %lf", &least, &largest, &step) == 3 &&
        !(step >= 1.0 && largest - least <= mostFiles * step))
      {
        throw Failure(path + ": says a number of files that cannot be; write it again");
      }
    }
  }
  if (!ends && !(hasFiles && header.back() == '\n'))
  {
    throw Failure(path + ": ends before its data; copy it again");
  }
  if (dimension < 1)
  {
    throw Failure(path + ": says no dimension; it is damaged, or not what its name says");
  }
}

//------------------------------------------------------------------------------
void CheckByu(const std::string& path)
{
  // VTK reads for ever where polygons do not end: each does so with a point whose number is negative.
  std::ifstream file(path);
  std::int64_t parts = 0;
  std::int64_t points = 0;
  std::int64_t polygons = 0;
  std::int64_t edges = 0;
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max(); // as VTK has it
  if (!(file >> parts >> points >> polygons >> edges) ||
    std::min({ parts, points, polygons }) < 0 || std::max({ parts, points, polygons }) > most)
  {
    throw Failure(path + ": says no number of points; it is damaged, or not what its name says");
  }
  double number = 0.0;
  for (std::int64_t i = 0; i < 2 * parts + 3 * points && file; ++i)
  {
    file >> number;
  }
  for (std::int64_t point = 0; polygons > 0 && file >> point;)
  {
    polygons -= point < 0 ? 1 : 0;
  }
  if (!file)
  {
    throw Failure(path + ": ends before its data; copy it again");
  }
}

//------------------------------------------------------------------------------
void CheckPng(const std::string& path)
{
  const std::string signature = "\x89PNG\r\n\x1a\n";
  std::ifstream file(path, std::ios::binary);
  std::string start(signature.size(), ' ');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start != signature)
  {
    return;
  }
  // A chunk is its length, its name, its data and a sum of 4 bytes; the last one is IEND.
  const std::uintmax_t size = fs::file_size(path);
  unsigned char head[8] = {};
  for (std::uintmax_t at = start.size(); at + 12 <= size;)
  {
    file.seekg(static_cast<std::streamoff>(at));
    file.read(reinterpret_cast<char*>(head), sizeof(head));
    if (std::equal(head + 4, head + 8, "IEND"))
    {
      return;
    }
    at += 12 + (static_cast<std::uint32_t>(head[0]) << 24 | head[1] << 16 | head[2] << 8 | head[3]);
  }
  throw Failure(path + ": is shorter than it says; copy it again");
}

//------------------------------------------------------------------------------
void CheckPnm(const std::string& path)
{
  // VTK reads for ever in a header that ends.
  std::ifstream file(path, std::ios::binary);
  std::string word;
  file >> word;
  const bool isPnm = word.size() == 2 && word[0] == 'P' && word[1] >= '1' && word[1] <= '6';
  int numbers =
    isPnm && (word[1] == '1' || word[1] == '4') ? 2 : 3; // one of two colours has no range
  while (isPnm && numbers > 0 && file >> word)
  {
    if (word[0] == '#')
    {
      file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    else if (word.find_first_not_of("0123456789") == std::string::npos)
    {
      --numbers;
    }
    else
    {
      break;
    }
  }
  if (!isPnm || numbers > 0)
  {
    throw Failure(path + ": says no size of a picture; it is damaged, or not what its name says");
  }
}

//------------------------------------------------------------------------------
void CheckHdr(const std::string& path)
{
  // VTK takes memory for a size that is not there.
  std::ifstream file(path);
  std::string line;
  bool hasSize = std::getline(file, line) && line.rfind("#?", 0) == 0;
  if (hasSize)
  {
    do
    {
      char sign[2];
      char axis[2];
      int size[2];
      hasSize = std::sscanf(line.c_str(), "%c%c %d %c%c %d", &sign[0], &axis[0], &size[0], &sign[1],
                  &axis[1], &size[1]) == 6 &&
        size[0] > 0 && size[1] > 0;
    } while (!hasSize && std::getline(file, line));
  }
  if (!hasSize)
  {
    throw Failure(path + ": says no size of a picture; it is damaged, or not what its name says");
  }
}
